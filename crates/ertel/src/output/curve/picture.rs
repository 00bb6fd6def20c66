//! Film thickness and traction over the quantity of a curve.

use super::super::pictures::{ERROR_BARS, film_unit, legend_entry};
use super::frame::{curve_chart, fit_y, largest, points_over};
use crate::solution::{Estimate, Figure, FormulaFilm, Solution};
use crate::study::{CurveSolution, PointSolution};
use ertel_plot::{Chart, ErrorBars, Look, PALETTE, Series};

/// One of the films of a formula.
type Film = fn(&FormulaFilm) -> Option<f64>;

/// A figure of a solution; NaN without one.
fn estimate(solution: &Solution, figure: Figure) -> Estimate {
    solution.measured.estimate(figure)
}

/// The figure of a solved point.
fn of_point(point: &PointSolution, figure: Figure) -> Option<Estimate> {
    Some(estimate(point.outcome.solution()?, figure))
}

/// Central and minimum film over the quantity, with the Newtonian and isothermal films (the first of these
/// dashed, a second one open circles). Without those, the formula films are dashed. Failed points are marked.
pub fn film_chart(title: &str, curve: &CurveSolution) -> Chart {
    films_over(title, curve, &[Figure::FilmCentral, Figure::FilmMinimum])
}

/// As [`film_chart`], with the minimum film on the centreline.
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

/// These films over the quantity, with those of simpler contacts.
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
        chart.series.push(Series::new(
            figure.words(),
            points_over(curve, |p| Some(factor * of_point(p, *figure)?.value)),
            match *figure == Figure::FilmMinimum {
                true => Look::LineAndRings,
                false => Look::LineAndDots,
            },
            colour,
        ));
        add_bars(&mut chart, curve, factor, *figure, colour);
    }
    let all = simpler_solutions(&[curve]);
    for other in &all {
        for (figure, colour) in figures.iter().zip(PALETTE) {
            let value = |s: &Solution| factor * estimate(s, *figure).value;
            chart.series.push(other.unlabelled(curve, colour, value));
        }
        let entry = legend_entry(other.look, other.name);
        chart.series.push(entry);
    }
    if all.is_empty() {
        add_formulas(&mut chart, curve, factor);
    }
    fit_y(&mut chart);
    chart
}

/// Traction coefficient at mid-film over the quantity, with the Newtonian and isothermal ones (the first of these
/// dashed, a second one open circles); `None` without sliding. Failed points are marked.
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
    chart.series = vec![Series::new(
        label,
        points_over(curve, |p| p.outcome.solution().map(value)),
        Look::LineAndDots,
        PALETTE[0],
    )];
    let groups = simpler_solutions(&[curve])
        .into_iter()
        .map(|other| vec![other.series(curve, label, other.colour, value)]);
    add_simpler_tractions(&mut chart, groups.collect());
    Some(chart)
}

/// Films of several curves over the same quantity: central films with dots, minimum films with rings, central films of the
/// simpler contact dashed. A single curve is drawn as [`film_chart`]. `None` without curves.
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
    let other = simpler(curves);
    // The legend explains both: colours distinguish the curves, line styles the films.
    let mut looks = vec![
        (Look::LineAndDots, Figure::FilmCentral.words().to_owned()),
        (Look::LineAndRings, Figure::FilmMinimum.words().to_owned()),
    ];
    looks.extend(other.iter().map(|b| {
        (
            b.look,
            format!("{}, {}", Figure::FilmCentral.words(), b.name),
        )
    }));
    for ((name, curve), colour) in curves.iter().zip(PALETTE.iter().cycle()) {
        let part = |look, film: Figure| {
            Series::new(
                "",
                points_over(curve, |p| Some(factor * of_point(p, film)?.value)),
                look,
                *colour,
            )
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
        if let Some(other) = &other {
            let central = |s: &Solution| factor * estimate(s, Figure::FilmCentral).value;
            chart.series.push(other.unlabelled(curve, colour, central));
        }
    }
    fit_y(&mut chart);
    chart.series.extend(
        looks
            .into_iter()
            .map(|(look, label)| legend_entry(look, &label)),
    );
    Some(chart)
}

/// The simpler contact drawn with several curves: the first one that some curve has.
fn simpler(curves: &[(&str, &CurveSolution)]) -> Option<Simpler> {
    let curves: Vec<&CurveSolution> = curves.iter().map(|(_, curve)| *curve).collect();
    simpler_solutions(&curves).into_iter().next()
}

/// Traction coefficients of several curves over the same quantity, those of the simpler contact dashed; the latter may
/// exceed the frame. `None` without curves.
pub fn tractions_chart(title: &str, curves: &[(&str, &CurveSolution)]) -> Option<Chart> {
    let value = |s: &Solution| estimate(s, Figure::TractionCoefficient).value;
    let mut chart = curve_chart(title, curves.first()?.1, "Traction coefficient");
    let other = simpler(curves);
    let mut dashed = Vec::new();
    for ((name, curve), colour) in curves.iter().zip(PALETTE.iter().cycle()) {
        chart.series.push(Series::new(
            *name,
            points_over(curve, |p| p.outcome.solution().map(value)),
            Look::LineAndDots,
            *colour,
        ));
        let series = other.iter().map(|b| b.unlabelled(curve, colour, value));
        dashed.extend(series);
    }
    dashed.extend(other.map(|b| legend_entry(b.look, b.name)));
    add_simpler_tractions(&mut chart, vec![dashed]);
    Some(chart)
}

/// Fits the axis to the tractions and to each group of simpler contacts, unless these are several times
/// larger: then they exceed the frame.
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

/// Traction coefficients of a simpler contact above this multiple of the largest one are cut off.
const LARGEST_SIMPLER: f64 = 3.0;

/// Simpler solutions drawn with those of a curve.
#[derive(Clone, Copy)]
struct Simpler {
    name: &'static str,
    look: Look,
    /// Colour in a picture of one figure.
    colour: &'static str,
    of: fn(&PointSolution) -> Option<&Solution>,
}

/// The simpler solutions that some curve has: the first kind dashed, a second one as open circles.
fn simpler_solutions(curves: &[&CurveSolution]) -> Vec<Simpler> {
    let newtonian = Simpler {
        name: "Newtonian",
        look: Look::Dashed,
        colour: PALETTE[0],
        of: PointSolution::newtonian_solution,
    };
    let isothermal = Simpler {
        name: "isothermal",
        of: PointSolution::isothermal_solution,
        ..newtonian
    };
    let found = |other: &Simpler| {
        let mut points = curves.iter().flat_map(|curve| &curve.points);
        points.any(|p| (other.of)(p).is_some())
    };
    let mut all: Vec<Simpler> = [newtonian, isothermal].into_iter().filter(found).collect();
    for second in all.iter_mut().skip(1) {
        second.look = Look::Circles;
        second.colour = PALETTE[1];
    }
    all
}

impl Simpler {
    /// A figure of these solutions.
    fn series(
        &self,
        curve: &CurveSolution,
        label: &str,
        colour: &str,
        value: impl Fn(&Solution) -> f64,
    ) -> Series {
        Series::new(
            format!("{label}, {}", self.name),
            points_over(curve, |p| (self.of)(p).map(&value)),
            self.look,
            colour,
        )
    }

    /// The same without a legend entry.
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

/// The formula films, dashed.
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
                chart.series.push(Series::new(
                    format!("{}{suffix}", formula.name),
                    points,
                    Look::Dashed,
                    *colours.next().unwrap_or(&PALETTE[2]),
                ));
            }
        }
    }
}

fn films(point: &PointSolution) -> [Option<f64>; 2] {
    [Figure::FilmCentral, Figure::FilmMinimum].map(|film| Some(of_point(point, film)?.value))
}
