//! The map in a picture: material over load group, converged or not, colour by iterations.

use ertel::contact::ContactKind;
use ertel_plot::{Axis, AxisScale, Chart, Look, Series, side_by_side};

use crate::cases::Family;
use crate::record::Record;

/// Newton iterations up to which a point has a colour (light to dark), and the colours
/// (ColorBrewer, YlGnBu).
const STEPS: [(usize, &str); 4] = [
    (20, "#7fcdbb"),
    (40, "#41b6c4"),
    (80, "#225ea8"),
    (usize::MAX, "#081d58"),
];
const FAILED: &str = "#D55E00";

/// Line contacts left, circular ones right; or ellipses and rollers. Kinds without records have no panel.
pub fn svg(records: &[Record]) -> String {
    let of_machines =
        (records.iter()).any(|r| matches!(r.kind, ContactKind::Elliptical | ContactKind::Roller));
    let panels = match of_machines {
        true => [
            (ContactKind::Elliptical, "Elliptical contacts"),
            (ContactKind::Roller, "Rollers"),
        ],
        false => [
            (ContactKind::Line, "Line contacts"),
            (ContactKind::Circular, "Circular contacts"),
        ],
    };
    let charts: Vec<Chart> = (panels.into_iter())
        .filter_map(|(kind, heading)| {
            let of_kind: Vec<&Record> = records.iter().filter(|r| r.kind == kind).collect();
            (!of_kind.is_empty()).then(|| panel(heading, &of_kind))
        })
        .collect();
    side_by_side("Convergence map", &charts, 2).svg()
}

fn panel(heading: &str, records: &[&Record]) -> Chart {
    let mut chart = Chart::new(
        heading,
        Axis {
            label: "Load group *M*".into(),
            low: 0.1,
            high: 3e4,
            scale: AxisScale::Log,
        },
        Axis::linear("Material group *L*", -2.0, 40.0),
    );
    chart.heading = heading.to_owned();
    let mut below = 0;
    for (limit, colour) in STEPS {
        let points: Vec<[f64; 2]> = records
            .iter()
            .filter(|r| r.converged() && (below..limit).contains(&r.newton))
            .map(|r| place(r))
            .collect();
        let label = match limit {
            usize::MAX => format!("{below} or more"),
            _ if below == 0 => format!("fewer than {limit} Newton iterations"),
            _ => format!("{below} to {}", limit - 1),
        };
        chart.series.push(series(label, points, Look::Dots, colour));
        below = limit;
    }
    let failed: Vec<[f64; 2]> = records
        .iter()
        .filter(|r| !r.converged())
        .map(|r| place(r))
        .collect();
    let label = format!("not converged ({} of {})", failed.len(), records.len());
    chart
        .series
        .push(series(label, failed, Look::Crosses, FAILED));
    chart
}

fn series(label: String, points: Vec<[f64; 2]>, look: Look, colour: &str) -> Series {
    Series {
        label,
        points,
        look,
        colour: colour.to_owned(),
        ..Series::default()
    }
}

/// Position of a case in the picture: laws next to each other where their groups agree, densities above each
/// other.
fn place(record: &Record) -> [f64; 2] {
    let law = Family::ALL.iter().position(|f| *f == record.family);
    let right = 0.05 * (law.unwrap_or(0) as f64 - 2.0);
    let up = match record.name.as_str() {
        n if n.contains("-inc-") => -0.7,
        n if n.contains("-tait-") => 0.7,
        _ => 0.0,
    };
    [record.m * 10f64.powf(right), record.l + up]
}
