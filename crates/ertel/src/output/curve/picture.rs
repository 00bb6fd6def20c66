//! Film thickness and traction over the quantity of a curve.

use super::super::pictures::{ERROR_BARS, film_unit};
use super::frame::{curve_chart, fit_y, largest, points_over};
use crate::solution::{Estimate, Figure, FormulaFilm, Solution};
use crate::study::{CurveSolution, PointSolution};
use ertel_plot::{Chart, ErrorBars, Look, PALETTE, Series, Side};

/// One of the films of a formula.
type Film = fn(&FormulaFilm) -> Option<f64>;

/// A figure of a solution; not a number where it has none.
fn estimate(solution: &Solution, figure: Figure) -> Estimate {
    solution.measured.estimate(figure)
}

/// The figure of a point that is solved.
fn of_point(point: &PointSolution, figure: Figure) -> Option<Estimate> {
    Some(estimate(point.outcome.solution()?, figure))
}

/// Central and minimum film over the quantity, beside those without shear thinning and without heat (the first of these
/// dashed, a second one open circles) or, where the curve asks for neither, the formulas' (dashed). Failed points are marked.
pub fn film_chart(title: &str, curve: &CurveSolution) -> Chart {
    films_over(title, curve, &[Figure::FilmCentral, Figure::FilmMinimum])
}

/// As [`film_chart`], with the smallest film on the centreline.
pub fn film_shape_chart(title: &str, curve: &CurveSolution) -> Chart {
    films_over(
        title,
        curve,
        &[
            Figure::FilmCentral,
            Figure::FilmCentrelineMinimum,
            Figure::FilmMinimum,
        ],
    )
}

/// These films over the quantity, beside those of simpler contacts.
fn films_over(title: &str, curve: &CurveSolution, figures: &[Figure]) -> Chart {
    let size = largest(
        curve
            .points
            .iter()
            .flat_map(|p| films(p).into_iter().flatten()),
    );
    let (factor, unit) = film_unit(size);
    let mut chart = curve_chart(title, curve, &format!("Film thickness *h* ({unit})"));
    for (figure, colour) in figures.iter().zip(PALETTE) {
        chart.series.push(Series {
            label: figure.words().into(),
            points: points_over(curve, |p| Some(factor * of_point(p, *figure)?.value)),
            look: match *figure == Figure::FilmMinimum {
                true => Look::LineAndRings,
                false => Look::LineAndDots,
            },
            colour: colour.into(),
            side: Side::Left,
        });
        add_bars(&mut chart, curve, factor, *figure, colour);
    }
    let besides = besides_of(&[curve]);
    for beside in &besides {
        for (figure, colour) in figures.iter().zip(PALETTE) {
            let value = |s: &Solution| factor * estimate(s, *figure).value;
            chart.series.push(beside.unlabelled(curve, colour, value));
        }
        let entry = legend_entry(beside.look, beside.name.to_owned());
        chart.series.push(entry);
    }
    if besides.is_empty() {
        add_formulas(&mut chart, curve, factor);
    }
    fit_y(&mut chart);
    chart
}

/// Traction coefficient at mid-film over the quantity, beside that without shear thinning and that without heat (the
/// first of these dashed, a second one open circles); `None` where nothing slides. Failed points are marked.
pub fn traction_chart(title: &str, curve: &CurveSolution) -> Option<Chart> {
    let slides = |p: &PointSolution| p.case.motion.slides();
    let solved = |p: &&PointSolution| p.outcome.solution().is_some();
    if !curve.points.iter().filter(solved).any(slides) {
        return None;
    }
    let mut chart = curve_chart(title, curve, "Traction coefficient");
    let value = |s: &Solution| estimate(s, Figure::TractionCoefficient).value;
    add_bars(
        &mut chart,
        curve,
        1.0,
        Figure::TractionCoefficient,
        PALETTE[0],
    );
    let label = Figure::TractionCoefficient.words();
    chart.series = vec![Series {
        label: label.into(),
        points: points_over(curve, |p| p.outcome.solution().map(value)),
        look: Look::LineAndDots,
        colour: PALETTE[0].into(),
        side: Side::Left,
    }];
    let groups = besides_of(&[curve])
        .into_iter()
        .map(|beside| vec![beside.series(curve, label, beside.colour, value)]);
    add_simpler_tractions(&mut chart, groups.collect());
    Some(chart)
}

/// Films of several curves over the same quantity: central with dots, minimum with rings, dashed the central ones of the
/// simpler contact; of a single curve as [`film_chart`]. `None` without curves.
pub fn films_chart(title: &str, curves: &[(&str, &CurveSolution)]) -> Option<Chart> {
    if let [(_, curve)] = curves {
        return Some(film_chart(title, curve));
    }
    let size = largest(curves.iter().flat_map(|(_, curve)| {
        let films = curve.points.iter().flat_map(films);
        films.flatten()
    }));
    let (factor, unit) = film_unit(size);
    let label = format!("Film thickness *h* ({unit})");
    let mut chart = curve_chart(title, curves.first()?.1, &label);
    let beside = simpler(curves);
    // Colours tell the curves, looks what they show: both stand in the legend.
    let mut looks = vec![
        (Look::LineAndDots, Figure::FilmCentral.words().to_owned()),
        (Look::LineAndRings, Figure::FilmMinimum.words().to_owned()),
    ];
    looks.extend(beside.iter().map(|b| {
        (
            b.look,
            format!("{}, {}", Figure::FilmCentral.words(), b.name),
        )
    }));
    for ((name, curve), colour) in curves.iter().zip(PALETTE.iter().cycle()) {
        let part = |look, film: Figure| Series {
            points: points_over(curve, |p| Some(factor * of_point(p, film)?.value)),
            look,
            colour: (*colour).into(),
            ..Series::default()
        };
        chart.series.push(Series {
            label: (*name).to_owned(),
            ..part(Look::LineAndDots, Figure::FilmCentral)
        });
        chart
            .series
            .push(part(Look::LineAndRings, Figure::FilmMinimum));
        for film in [Figure::FilmCentral, Figure::FilmMinimum] {
            add_bars(&mut chart, curve, factor, film, colour);
        }
        if let Some(beside) = &beside {
            let central = |s: &Solution| factor * estimate(s, Figure::FilmCentral).value;
            chart.series.push(beside.unlabelled(curve, colour, central));
        }
    }
    fit_y(&mut chart);
    chart.series.extend(
        looks
            .into_iter()
            .map(|(look, label)| legend_entry(look, label)),
    );
    Some(chart)
}

/// The simpler contact that several curves are shown beside: the first that one of them has.
fn simpler(curves: &[(&str, &CurveSolution)]) -> Option<Beside> {
    let curves: Vec<&CurveSolution> = curves.iter().map(|(_, curve)| *curve).collect();
    besides_of(&curves).into_iter().next()
}

/// Entry of the legend that holds for curves of all colours.
fn legend_entry(look: Look, label: String) -> Series {
    Series {
        label,
        look,
        colour: LEGEND_GREY.into(),
        ..Series::default()
    }
}

/// Colour of legend entries that hold for curves of all colours.
const LEGEND_GREY: &str = "#404040";

/// Traction coefficients of several curves over the same quantity, dashed those of the simpler contact, which may
/// leave the picture. `None` without curves.
pub fn tractions_chart(title: &str, curves: &[(&str, &CurveSolution)]) -> Option<Chart> {
    let value = |s: &Solution| estimate(s, Figure::TractionCoefficient).value;
    let mut chart = curve_chart(title, curves.first()?.1, "Traction coefficient");
    let beside = simpler(curves);
    let mut simpler = Vec::new();
    for ((name, curve), colour) in curves.iter().zip(PALETTE.iter().cycle()) {
        chart.series.push(Series {
            label: (*name).to_owned(),
            points: points_over(curve, |p| p.outcome.solution().map(value)),
            look: Look::LineAndDots,
            colour: (*colour).into(),
            side: Side::Left,
        });
        let series = beside.iter().map(|b| b.unlabelled(curve, colour, value));
        simpler.extend(series);
    }
    simpler.extend(beside.map(|b| legend_entry(b.look, b.name.to_owned())));
    add_simpler_tractions(&mut chart, vec![simpler]);
    Some(chart)
}

/// Fits the axis to the tractions, and to each group of those of simpler contacts unless they are several times
/// larger: these leave the frame.
fn add_simpler_tractions(chart: &mut Chart, groups: Vec<Vec<Series>>) {
    let size = |list: &[Series]| {
        let points = list.iter().flat_map(|s| &s.points);
        largest(points.map(|p| p[1].abs()).filter(|v| v.is_finite()))
    };
    let found = |group: &Vec<Series>| {
        let mut points = group.iter().flat_map(|s| &s.points);
        points.any(|p| p[1].is_finite())
    };
    let most = LARGEST_SIMPLER * size(&chart.series);
    let (fitting, leaving): (Vec<_>, Vec<_>) = groups
        .into_iter()
        .filter(found)
        .partition(|group| size(group) <= most);
    chart.series.extend(fitting.into_iter().flatten());
    fit_y(chart);
    chart.series.extend(leaving.into_iter().flatten());
}

/// A traction coefficient of a simpler contact of so many times the largest one is not shown to its end.
const LARGEST_SIMPLER: f64 = 3.0;

/// Simpler solutions shown beside those of a curve.
#[derive(Clone, Copy)]
struct Beside {
    name: &'static str,
    look: Look,
    /// In a picture of one figure.
    colour: &'static str,
    of: fn(&PointSolution) -> Option<&Solution>,
}

/// The simpler solutions that some curve has: the first kind dashed, a second one as open circles.
fn besides_of(curves: &[&CurveSolution]) -> Vec<Beside> {
    let newtonian = Beside {
        name: "Newtonian",
        look: Look::Dashed,
        colour: PALETTE[0],
        of: PointSolution::newtonian_solution,
    };
    let isothermal = Beside {
        name: "isothermal",
        of: PointSolution::isothermal_solution,
        ..newtonian
    };
    let found = |beside: &Beside| {
        let mut points = curves.iter().flat_map(|curve| &curve.points);
        points.any(|p| (beside.of)(p).is_some())
    };
    let mut besides: Vec<Beside> = [newtonian, isothermal].into_iter().filter(found).collect();
    for second in besides.iter_mut().skip(1) {
        second.look = Look::Circles;
        second.colour = PALETTE[1];
    }
    besides
}

impl Beside {
    /// A figure of these solutions.
    fn series(
        &self,
        curve: &CurveSolution,
        label: &str,
        colour: &str,
        value: impl Fn(&Solution) -> f64,
    ) -> Series {
        Series {
            label: format!("{label}, {}", self.name),
            points: points_over(curve, |p| (self.of)(p).map(&value)),
            look: self.look,
            colour: colour.into(),
            side: Side::Left,
        }
    }

    /// The same without an entry of the legend.
    fn unlabelled(
        &self,
        curve: &CurveSolution,
        colour: &str,
        value: impl Fn(&Solution) -> f64,
    ) -> Series {
        Series {
            label: String::new(),
            ..self.series(curve, "", colour, value)
        }
    }
}

/// Error bars of a figure.
fn add_bars(chart: &mut Chart, curve: &CurveSolution, factor: f64, of: Figure, colour: &str) {
    let ends = |sign: f64| {
        points_over(curve, |p| {
            let figure = of_point(p, of)?;
            Some(factor * (figure.value + sign * figure.error?))
        })
    };
    let bars = ends(-1.0).into_iter().zip(ends(1.0));
    chart.error_bars.push(ErrorBars {
        bars: bars
            .map(|([x, low], [_, high])| [x, low, high])
            .filter(|bar| bar.iter().all(|v| v.is_finite()))
            .collect(),
        colour: colour.to_owned(),
    });
    chart.error_label = ERROR_BARS.to_owned();
}

/// The films of the formulas, dashed.
fn add_formulas(chart: &mut Chart, curve: &CurveSolution, factor: f64) {
    let mut colours = PALETTE[2..].iter().cycle();
    for formula in curve.points.first().map_or(&[][..], |p| &p.formulas) {
        let parts: [(&str, Film); 2] = [("", |f| f.central), (", minimum", |f| f.minimum)];
        for (suffix, value) in parts {
            let points = points_over(curve, |p| {
                let same = p.formulas.iter().find(|f| f.name == formula.name)?;
                value(same).map(|h| factor * h)
            });
            if points.iter().any(|p| p[1].is_finite()) {
                chart.series.push(Series {
                    label: format!("{}{suffix}", formula.name),
                    points,
                    look: Look::Dashed,
                    colour: (*colours.next().unwrap_or(&PALETTE[2])).into(),
                    side: Side::Left,
                });
            }
        }
    }
}

fn films(point: &PointSolution) -> [Option<f64>; 2] {
    [Figure::FilmCentral, Figure::FilmMinimum].map(|film| Some(of_point(point, film)?.value))
}
