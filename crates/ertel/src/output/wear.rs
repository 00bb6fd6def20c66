//! Wear: report, `wear.csv` and `wear-depth.csv`.

use std::io::{self, Write};

use super::figure::{BODIES, estimate, in_unit};
use super::lines::Lines;
use crate::solution::{BodyWear, Solution, Wear, WearStep};
use crate::words::{digits, length, pressure};

/// Wear of the bodies, if there is any.
pub(super) fn write_results(out: &mut Lines, solution: &Solution) {
    let Some(wear) = &solution.wear else {
        return;
    };
    out.heading("Wear");
    out.row(
        "sliding distance",
        format!(
            "{} m in {} steps",
            digits(wear.sliding_distance, 6),
            wear.steps
        ),
    );
    let unit = if solution.shape.is_line() {
        "m²"
    } else {
        "m³"
    };
    for (n, body) in wear.bodies() {
        out.row(
            BODIES[n - 1],
            format!(
                "k {:e}, H {}{}",
                body.wear_coefficient,
                pressure(body.hardness),
                track(body)
            ),
        );
        out.row("  largest depth", estimate(&body.depth));
        out.row("  worn volume", in_unit(body.volume, 1.0, unit));
        for (name, size) in [("  length", body.length), ("  width", body.width)] {
            if let Some(size) = size {
                out.row(name, length(size));
            }
        }
        out.row(
            "  volume balance error",
            format!("{:.0e} of k W_a s/H", body.volume_deviation),
        );
    }
    if let (Some(new), Some(worn)) = (wear.course.first(), wear.course.last()) {
        let of = |words: &dyn Fn(&WearStep) -> String| {
            format!("{} new, {} worn", words(new), words(worn))
        };
        out.row(
            "load on asperities",
            of(&|at| format!("{} %", digits(100.0 * at.asperity_load_share, 3))),
        );
        out.row("central film", of(&|at| length(at.film_central)));
        out.row("minimum film", of(&|at| length(at.film_minimum)));
        out.row("largest pressure", of(&|at| pressure(at.pressure_maximum)));
        if new.friction_total.is_some() {
            let friction =
                |at: &WearStep| at.friction_total.map_or(String::new(), |f| digits(f, 4));
            out.row("total friction coefficient", of(&friction));
        }
    }
    out.note(&format!(
        "{}. All other results are those of the worn contact. Error bars contain those of the steps. Length and width: \
         where the depth is above 1 % of the largest.",
        wear.label
    ));
}

fn track(body: &BodyWear) -> String {
    match body.track_length {
        None => ", at rest".to_owned(),
        Some(track) => format!(", track of {}", length(track)),
    }
}

/// The columns of the course, with units in their names, and their values.
fn columns(wear: &Wear, is_line: bool) -> Vec<(&'static str, Vec<f64>)> {
    let column = |name, value: &dyn Fn(&WearStep) -> Option<f64>| {
        let values: Option<Vec<f64>> = wear.course.iter().map(value).collect();
        Some((name, values?))
    };
    let volumes = match is_line {
        true => ["body_1_volume_m2", "body_2_volume_m2"],
        false => ["body_1_volume_m3", "body_2_volume_m3"],
    };
    let all = [
        column("sliding_distance_m", &|at| Some(at.sliding_distance)),
        column("asperity_load_share", &|at| Some(at.asperity_load_share)),
        column("film_central_m", &|at| Some(at.film_central)),
        column("film_minimum_m", &|at| Some(at.film_minimum)),
        column("pressure_maximum_Pa", &|at| Some(at.pressure_maximum)),
        column("friction_total", &|at| at.friction_total),
        column("body_1_depth_m", &|at| at.body_1_depth),
        column("body_2_depth_m", &|at| at.body_2_depth),
        column(volumes[0], &|at| at.body_1_volume),
        column(volumes[1], &|at| at.body_2_volume),
    ];
    all.into_iter().flatten().collect()
}

/// Writes the contact over the sliding distance, one line per step, SI.
///
/// # Errors
/// Those of the writer.
pub fn write_course(mut out: impl Write, wear: &Wear, is_line: bool) -> io::Result<()> {
    writeln!(out, "# {}", wear.label)?;
    let columns = columns(wear, is_line);
    let names: Vec<&str> = columns.iter().map(|(name, _)| *name).collect();
    writeln!(out, "{}", names.join(","))?;
    for i in 0..wear.course.len() {
        let row = columns.iter().map(|(_, values)| format!("{:e}", values[i]));
        writeln!(out, "{}", row.collect::<Vec<_>>().join(","))?;
    }
    Ok(())
}

/// Writes the worn depth along and across the motion through the centre, SI.
///
/// # Errors
/// Those of the writer.
pub fn write_depths(mut out: impl Write, wear: &Wear) -> io::Result<()> {
    writeln!(out, "# {}", wear.label)?;
    writeln!(out, "body,direction,position_m,depth_m")?;
    for (n, body) in wear.bodies() {
        for (direction, points) in ["along", "across"].into_iter().zip(&body.profiles) {
            for [place, depth] in points {
                writeln!(out, "{n},{direction},{place:e},{depth:e}")?;
            }
        }
    }
    Ok(())
}
