//! Film thickness and traction over the quantity of a curve.

use ertel_rheology::quantity::Dimension;

use super::super::plot::{
    Axis, AxisScale, Chart, Look, Marker, PALETTE, Series, Side, film_unit, pressure_unit,
};
use crate::case::curve::Quantity;
use crate::solution::{FormulaFilm, Solution};
use crate::study::{CurveSolution, PointSolution};

/// Ratio of the largest to the smallest value from which an axis is logarithmic.
const LOG_FROM: f64 = 5.0;

/// One of the films of a formula.
type Film = fn(&FormulaFilm) -> Option<f64>;

/// A figure of a solution.
type Figure = fn(&Solution) -> f64;

/// Central and minimum film over the quantity, beside those without shear thinning (dashed) and without heat (open
/// circles) or, where the curve asks for neither, the formulas' (dashed). Failed points are marked.
pub fn film_chart(title: &str, curve: &CurveSolution) -> Chart {
    let size = largest(
        curve
            .points
            .iter()
            .flat_map(|p| films(p).into_iter().flatten()),
    );
    let (factor, unit) = film_unit(size);
    let mut chart = curve_chart(title, curve, &format!("Film thickness *h* ({unit})"));
    let values: [(&str, Figure); 2] = [
        ("central film", |s| s.summary.film_central.value),
        ("minimum film", |s| s.summary.film_minimum.value),
    ];
    for ((label, value), colour) in values.into_iter().zip(PALETTE) {
        chart.series.push(Series {
            label: label.into(),
            points: points_over(curve, |p| Some(factor * value(p.outcome.solution()?))),
            look: Look::LineAndDots,
            colour: colour.into(),
            side: Side::Left,
        });
    }
    let mut alone = true;
    for beside in BESIDES {
        if !curve.points.iter().any(|p| (beside.of)(p).is_some()) {
            continue;
        }
        alone = false;
        for ((label, value), colour) in values.into_iter().zip(PALETTE) {
            let value = |s: &Solution| factor * value(s);
            chart
                .series
                .push(beside.series(curve, label, colour, value));
        }
    }
    if alone {
        add_formulas(&mut chart, curve, factor);
    }
    fit_y(&mut chart);
    chart
}

/// Traction coefficient at mid-film over the quantity, beside that without shear thinning (dashed) and that without
/// heat (open circles); `None` where nothing slides. Failed points are marked.
pub fn traction_chart(title: &str, curve: &CurveSolution) -> Option<Chart> {
    let slides = |p: &PointSolution| p.case.motion.slide_to_roll_ratio != 0.0;
    let solved = |p: &&PointSolution| p.outcome.solution().is_some();
    if !curve.points.iter().filter(solved).any(slides) {
        return None;
    }
    let mut chart = curve_chart(title, curve, "Traction coefficient");
    let value = |s: &Solution| s.traction.coefficient;
    let label = "traction coefficient";
    chart.series = vec![Series {
        label: label.into(),
        points: points_over(curve, |p| p.outcome.solution().map(value)),
        look: Look::LineAndDots,
        colour: PALETTE[0].into(),
        side: Side::Left,
    }];
    let [newtonian, isothermal] =
        BESIDES.map(|beside| beside.series(curve, label, beside.colour, value));
    add_simpler_tractions(&mut chart, vec![vec![newtonian], vec![isothermal]]);
    Some(chart)
}

/// Films of several curves over the same quantity: central with dots, minimum without, dashed the central ones without
/// shear thinning. `None` without curves.
pub fn films_chart(title: &str, curves: &[(&str, &CurveSolution)]) -> Option<Chart> {
    let size = largest(curves.iter().flat_map(|(_, curve)| {
        let films = curve.points.iter().flat_map(films);
        films.flatten()
    }));
    let (factor, unit) = film_unit(size);
    let label = format!("Film thickness *h* ({unit})");
    let mut chart = curve_chart(title, curves.first()?.1, &label);
    let single = curves.len() == 1;
    for ((name, curve), colour) in curves.iter().zip(PALETTE.iter().cycle()) {
        let part = |look, film: Figure| Series {
            points: points_over(curve, |p| Some(factor * film(p.outcome.solution()?))),
            look,
            colour: (*colour).into(),
            ..Series::default()
        };
        let central = |s: &Solution| s.summary.film_central.value;
        let mut series = [
            part(Look::LineAndDots, central),
            part(Look::Line, |s| s.summary.film_minimum.value),
            NEWTONIAN.series(curve, "", colour, |s| factor * central(s)),
        ];
        for (series, label) in series.iter_mut().zip(FILM_LABELS) {
            series.label = if single {
                label.to_owned()
            } else {
                String::new()
            };
        }
        if !single {
            series[0].label = (*name).to_owned();
        }
        chart.series.extend(series);
    }
    fit_y(&mut chart);
    if !single {
        // Colours tell the curves, looks what they show: both stand in the legend, which needs room above.
        let looks = [Look::LineAndDots, Look::Line, Look::Dashed];
        for (look, label) in looks.into_iter().zip(FILM_LABELS) {
            chart.series.push(Series {
                label: label.into(),
                look,
                colour: LEGEND_GREY.into(),
                ..Series::default()
            });
        }
        if chart.y.scale == AxisScale::Linear {
            chart.y = Axis::linear_around(&label, [chart.y.low, LEGEND_ROOM * chart.y.high]);
        }
    }
    Some(chart)
}

/// What the looks of [`films_chart`] show.
const FILM_LABELS: [&str; 3] = ["central film", "minimum film", "central film, Newtonian"];

/// Colour of legend entries that hold for curves of all colours.
const LEGEND_GREY: &str = "#404040";

/// By how much an axis grows to make room for a long legend.
const LEGEND_ROOM: f64 = 1.5;

/// Traction coefficients of several curves over the same quantity, dashed those without shear thinning, which may
/// leave the picture. `None` without curves.
pub fn tractions_chart(title: &str, curves: &[(&str, &CurveSolution)]) -> Option<Chart> {
    let value = |s: &Solution| s.traction.coefficient;
    let mut chart = curve_chart(title, curves.first()?.1, "Traction coefficient");
    let mut newtonian = Vec::new();
    for ((name, curve), colour) in curves.iter().zip(PALETTE.iter().cycle()) {
        chart.series.push(Series {
            label: (*name).to_owned(),
            points: points_over(curve, |p| p.outcome.solution().map(value)),
            look: Look::LineAndDots,
            colour: (*colour).into(),
            side: Side::Left,
        });
        let series = NEWTONIAN.series(curve, "", colour, value);
        newtonian.push(Series {
            label: String::new(),
            ..series
        });
    }
    newtonian.push(Series {
        label: "Newtonian".into(),
        look: Look::Dashed,
        colour: LEGEND_GREY.into(),
        ..Series::default()
    });
    add_simpler_tractions(&mut chart, vec![newtonian]);
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
struct Beside {
    name: &'static str,
    look: Look,
    /// In a picture of one figure.
    colour: &'static str,
    of: fn(&PointSolution) -> Option<&Solution>,
}

const NEWTONIAN: Beside = Beside {
    name: "Newtonian",
    look: Look::Dashed,
    colour: PALETTE[0],
    of: PointSolution::newtonian_solution,
};

const BESIDES: [Beside; 2] = [
    NEWTONIAN,
    Beside {
        name: "isothermal",
        look: Look::Circles,
        colour: PALETTE[1],
        of: PointSolution::isothermal_solution,
    },
];

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

/// Diagram over the quantity of a curve without series; call [`fit_y`] once they are there.
fn curve_chart(title: &str, curve: &CurveSolution, y_label: &str) -> Chart {
    let values = || curve.points.iter().map(|p| p.value);
    let (shown, unit) = shown_unit(&curve.quantity, largest(values().map(f64::abs)));
    let label = axis_label(&curve.quantity, unit);
    // Sliding is shown from rolling onwards, as traction curves are.
    let is_ratio = curve.quantity.dimension == Dimension::DIMENSIONLESS;
    let x = if !is_ratio && is_wide(values()) {
        Axis::log_close_around(&label, values().map(shown))
    } else {
        let origin = is_ratio.then_some(0.0);
        Axis::linear_around(&label, values().map(shown).chain(origin))
    };
    let mut chart = Chart::new(title, x, Axis::linear(y_label, 0.0, 1.0));
    let failed = curve
        .points
        .iter()
        .filter(|p| p.outcome.solution().is_none());
    chart.markers = failed
        .map(|p| Marker {
            x: shown(p.value),
            label: "failed".into(),
        })
        .collect();
    chart
}

/// Lets the left axis cover the series; logarithmic beside a logarithmic x axis, for power laws are straight there.
fn fit_y(chart: &mut Chart) {
    let heights = || {
        let points = chart.series.iter().flat_map(|s| &s.points);
        points.map(|p| p[1]).filter(|h| h.is_finite())
    };
    let label = chart.y.label.clone();
    let y = if chart.x.scale == AxisScale::Log && is_wide(heights()) {
        Axis::log_close_around(&label, heights())
    } else {
        Axis::linear_around(&label, heights().chain([0.0]))
    };
    chart.y = y;
}

/// One point for each of the curve; not finite where there is no value.
fn points_over(
    curve: &CurveSolution,
    value: impl Fn(&PointSolution) -> Option<f64>,
) -> Vec<[f64; 2]> {
    let size = largest(curve.points.iter().map(|p| p.value.abs()));
    let (shown, _) = shown_unit(&curve.quantity, size);
    let mut points: Vec<[f64; 2]> = (curve.points.iter())
        .map(|p| [shown(p.value), value(p).unwrap_or(f64::NAN)])
        .collect();
    points.sort_by(|a, b| a[0].total_cmp(&b[0]));
    points
}

fn films(point: &PointSolution) -> [Option<f64>; 2] {
    let summary = point.outcome.solution().map(|s| &s.summary);
    [
        summary.map(|s| s.film_central.value),
        summary.map(|s| s.film_minimum.value),
    ]
}

fn largest(values: impl Iterator<Item = f64>) -> f64 {
    values.fold(0.0, f64::max)
}

fn is_wide(values: impl Iterator<Item = f64>) -> bool {
    let (low, high) = values.fold((f64::INFINITY, 0.0), |(l, h): (f64, f64), v| {
        (l.min(v), h.max(v))
    });
    low > 0.0 && high >= LOG_FROM * low
}

/// How values of the quantity, the largest of this size (SI), are shown.
fn shown_unit(quantity: &Quantity, size: f64) -> (fn(f64) -> f64, &'static str) {
    match quantity.dimension {
        Dimension::SPEED if size < 0.1 => (|v| 1e3 * v, "mm/s"),
        Dimension::SPEED => (|v| v, "m/s"),
        Dimension::FORCE if size < 0.1 => (|v| 1e3 * v, "mN"),
        Dimension::FORCE => (|v| v, "N"),
        Dimension::FORCE_PER_LENGTH => (|v| 1e-3 * v, "kN/m"),
        Dimension::PRESSURE if pressure_unit(size).1 == "MPa" => (|v| 1e-6 * v, "MPa"),
        Dimension::PRESSURE => (|v| 1e-9 * v, "GPa"),
        Dimension::LENGTH => (|v| 1e3 * v, "mm"),
        Dimension::TEMPERATURE => (|v| v - 273.15, "°C"),
        _ => (|v| v, ""),
    }
}

fn axis_label(quantity: &Quantity, unit: &str) -> String {
    let mut name = quantity.name.to_owned();
    if let Some(first) = name.get_mut(..1) {
        first.make_ascii_uppercase();
    }
    let symbol = match quantity.symbol {
        "" => String::new(),
        symbol => format!(" {symbol}"),
    };
    let unit = match unit {
        "" => String::new(),
        unit => format!(" ({unit})"),
    };
    format!("{name}{symbol}{unit}")
}
