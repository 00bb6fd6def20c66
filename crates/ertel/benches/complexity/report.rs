//! Table, fits and picture of the sweeps.

use std::fmt::Write;

use ertel_plot::{Axis, Chart, Look, PALETTE, Series, side_by_side};

use crate::{Point, Sweep};

pub const HEAD: &str = "contact              cells    unknowns        U        P   Newton   s/Newton (CPU)        s/case (CPU)   memory";

pub fn line(p: &Point) -> String {
    let seconds = |v: Option<f64>| v.map_or("        ".to_owned(), |v| format!("{v:8.3}"));
    format!(
        "{:<20} x{:<6} {:>9} {:>8} {:>8} {:>8} {:9.4} {:9.4} {} {} {:6.0} MiB",
        p.sweep.name(),
        p.factor,
        p.n_displacement + p.n_pressure,
        p.n_displacement,
        p.n_pressure,
        p.newton.map_or(String::new(), |n| n.to_string()),
        p.iteration_wall,
        p.iteration_cpu,
        seconds(p.case_wall),
        seconds(p.case_cpu),
        p.memory.unwrap_or(0) as f64 / 1048576.0
    )
}

/// CPU seconds of a Newton iteration over unknowns, Habchi 2008, Table 3.2 (2 GHz processor).
const THESIS_LINE: [[f64; 2]; 7] = [
    [5217.0, 0.347],
    [10441.0, 0.578],
    [17946.0, 1.022],
    [21563.0, 1.094],
    [24405.0, 1.276],
    [26389.0, 1.403],
    [42384.0, 2.158],
];
const THESIS_CIRCULAR: [[f64; 2]; 7] = [
    [7862.0, 2.875],
    [17841.0, 7.765],
    [21873.0, 10.078],
    [30733.0, 15.234],
    [46194.0, 29.344],
    [64977.0, 43.532],
    [67755.0, 50.281],
];

/// Quantities over unknowns.
const QUANTITIES: [(&str, Value); 5] = [
    ("CPU s per Newton iteration", |p| Some(p.iteration_cpu)),
    ("CPU s per case", |p| p.case_cpu),
    ("peak memory", |p| p.memory.map(|m| m as f64)),
    ("s to build the operator", |p| p.operator),
    ("s per Krylov iteration", |p| p.krylov),
];

/// A quantity of a point.
type Value = fn(&Point) -> Option<f64>;

pub fn markdown(points: &[Point]) -> String {
    let mut text = String::from(
        "| contact | unknowns | displacements | pressures | Newton | s per Newton | CPU | s per case | CPU | operator s | Krylov ms | peak MiB |\n\
         |---|---|---|---|---|---|---|---|---|---|---|---|\n",
    );
    let shown = |v: Option<f64>| v.map_or(String::new(), |v| format!("{v:.3}"));
    let by_sweep = Sweep::ALL
        .into_iter()
        .flat_map(|sweep| points.iter().filter(move |p| p.sweep == sweep));
    for p in by_sweep {
        // Writing into a String cannot fail
        let _ = writeln!(
            text,
            "| {} | {} | {} | {} | {} | {:.4} | {:.4} | {} | {} | {} | {} | {:.0} |",
            p.sweep.name(),
            p.n_displacement + p.n_pressure,
            p.n_displacement,
            p.n_pressure,
            p.newton.map_or(String::new(), |n| n.to_string()),
            p.iteration_wall,
            p.iteration_cpu,
            shown(p.case_wall),
            shown(p.case_cpu),
            shown(p.operator),
            shown(p.krylov.map(|s| 1e3 * s)),
            p.memory.unwrap_or(0) as f64 / 1048576.0
        );
    }
    text.push_str("\nFitted exponents over the larger half of the meshes, cost ~ unknowns^e:\n\n");
    let names = QUANTITIES.map(|(name, _)| name).join(" | ");
    let _ = writeln!(text, "| contact | {names} |\n|---|---|---|---|---|---|");
    for sweep in Sweep::ALL {
        let _ = write!(text, "| {} |", sweep.name());
        for (_, value) in QUANTITIES {
            let of_sweep = curve(points, sweep, value);
            let larger = &of_sweep[of_sweep.len() / 2..];
            let fit = exponent(larger).map_or(String::new(), |e| format!("{e:.2}"));
            let _ = write!(text, " {fit} |");
        }
        text.push('\n');
    }
    let _ = writeln!(
        text,
        "| Habchi 2008, line | {:.2} | | | | |\n| Habchi 2008, circular | {:.2} | | | | |",
        exponent(&THESIS_LINE).unwrap_or(f64::NAN),
        exponent(&THESIS_CIRCULAR).unwrap_or(f64::NAN)
    );
    text
}

fn curve(points: &[Point], sweep: Sweep, value: Value) -> Vec<[f64; 2]> {
    points
        .iter()
        .filter(|p| p.sweep == sweep)
        .filter_map(|p| value(p).map(|v| [p.unknowns(), v]))
        .collect()
}

/// Slope of the least-squares line through logarithms.
fn exponent(points: &[[f64; 2]]) -> Option<f64> {
    if points.len() < 2 {
        return None;
    }
    let logs: Vec<[f64; 2]> = points.iter().map(|p| [p[0].ln(), p[1].ln()]).collect();
    let n = logs.len() as f64;
    let mean = |i: usize| logs.iter().map(|p| p[i]).sum::<f64>() / n;
    let (x, y) = (mean(0), mean(1));
    let above: f64 = logs.iter().map(|p| (p[0] - x) * (p[1] - y)).sum();
    let below: f64 = logs.iter().map(|p| (p[0] - x).powi(2)).sum();
    Some(above / below)
}

/// Time per iteration, time per case, memory.
pub fn svg(points: &[Point]) -> String {
    let charts = [
        ("CPU time per Newton iteration (s)", 1.0),
        ("CPU time per case (s)", 1.0),
        ("Peak memory (MiB)", 1.0 / 1048576.0),
    ];
    let charts: Vec<Chart> = charts
        .iter()
        .zip(QUANTITIES)
        .map(|((label, factor), (_, value))| {
            let mut series: Vec<Series> = Sweep::ALL
                .into_iter()
                .enumerate()
                .map(|(i, sweep)| {
                    let points = curve(points, sweep, value);
                    let larger = &points[points.len() / 2..];
                    let fit =
                        exponent(larger).map_or(String::new(), |e| format!(": *n*^{{{e:.2}}}"));
                    Series::new(
                        format!("{}{fit}", sweep.name().replace('-', ", ")),
                        points.iter().map(|p| [p[0], factor * p[1]]).collect(),
                        Look::LineAndDots,
                        PALETTE[i],
                    )
                })
                .filter(|s| !s.points.is_empty())
                .collect();
            if label.contains("Newton") {
                for (name, points, colour) in [
                    ("line, Habchi 2008", THESIS_LINE, PALETTE[0]),
                    ("circular, Habchi 2008", THESIS_CIRCULAR, PALETTE[1]),
                ] {
                    series.push(Series::new(name, points.to_vec(), Look::Circles, colour));
                }
            }
            let all = || series.iter().flat_map(|s| s.points.iter());
            let mut chart = Chart::new(
                "Complexity",
                Axis::log_around("Unknowns *n*", all().map(|p| p[0])),
                // Room for the legend
                Axis::log_around(label, all().flat_map(|p| [p[1], 20.0 * p[1]])),
            );
            chart.series = series;
            chart
        })
        .collect();
    side_by_side("Complexity", &charts, 3).svg()
}
