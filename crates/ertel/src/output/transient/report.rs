//! The report of a transient case.

use std::path::Path;

use super::super::figure::{number, with_bar};
use super::super::lines::{Lines, Table};
use super::super::pictures::film_unit;
use super::super::rows;
use super::table::AMPLITUDE_RATIO;
use crate::case::CaseEcho;
use crate::contact::ContactKind;
use crate::figures::{Definition, find, run};
use crate::run::over_time::over_time;
use crate::run::transient::{InstantSolution, TransientSolution};
use crate::solution::Figure;
use crate::transient::TransientError;
use crate::words::{digits, force, length};

/// Extremes over time, the instants of the output, warnings, and effort.
pub fn transient_report(
    case: &CaseEcho,
    found: &TransientSolution,
    folder: Option<&Path>,
) -> String {
    let mut out = Lines::default();
    out.title(&case.title);
    out.heading("Results");
    write_results(&mut out, found, case.contact.kind);
    out.warnings(&found.warnings);
    if let Some(folder) = folder {
        out.line(&format!("Results in {}", folder.display()));
    }
    out.text()
}

/// Figures of the whole run that are listed first.
const LISTED: [Definition; 8] = [
    run::FILM_CENTRAL_LOWEST,
    run::FILM_CENTRAL_HIGHEST,
    run::FILM_MINIMUM_LOWEST,
    run::PRESSURE_MAXIMUM_HIGHEST,
    run::TRACTION_COEFFICIENT_HIGHEST,
    run::TRACTION_COEFFICIENT_MEAN,
    run::FRICTION_POWER_MEAN,
    run::FILM_TEMPERATURE_MAXIMUM_HIGHEST,
];

/// The report without title and warnings.
pub(in crate::output) fn write_results(
    out: &mut Lines,
    found: &TransientSolution,
    kind: ContactKind,
) {
    let instants = &found.instants;
    let (Some(first), Some(last)) = (instants.first(), instants.last()) else {
        if let Some(failure) = &found.failure {
            out.line(&failure.to_string());
        }
        return;
    };
    let time = time_unit(last.time);
    let reduced = over_time(found, kind.is_line());
    let listed = LISTED
        .iter()
        .filter_map(|figure| find(&reduced, figure.name));
    for row in listed.filter(|row| row.estimate.value != 0.0) {
        let text = rows::shown(row);
        out.row(
            row.figure.words,
            match row.time {
                Some(at_time) => format!("{text} at {}", at(at_time, time)),
                None => text,
            },
        );
    }
    let known = found.amplitude_ratios.iter().zip(instants).rev();
    if let Some((ratio, instant)) = known.filter_map(|(r, i)| Some((r.as_ref()?, i))).next() {
        out.row(
            AMPLITUDE_RATIO,
            format!(
                "{} in the passage that ends at {}",
                digits(*ratio, 3),
                at(instant.time, time)
            ),
        );
    }
    let moves = found.moves();
    if moves {
        let by = |value: fn(&InstantSolution) -> f64| {
            instants
                .iter()
                .max_by(move |a, b| value(a).total_cmp(&value(b)))
        };
        if let Some(instant) = by(|instant| instant.film_force) {
            out.row(
                "largest film force",
                format!(
                    "{} at {}",
                    force(instant.film_force, kind.is_line(), 4),
                    at(instant.time, time)
                ),
            );
        }
        if let Some(instant) = by(|instant| instant.approach) {
            out.row(
                "largest approach",
                format!("{} at {}", length(instant.approach), at(instant.time, time)),
            );
        }
        if let Some(restitution) = found.restitution() {
            out.row("coefficient of restitution", number(restitution));
        }
    }
    out.heading("Instants");
    let times: Vec<f64> = found.profiles.iter().map(|profile| profile.time).collect();
    let rows: Vec<Vec<String>> = (instants.iter())
        .filter(|instant| times.contains(&instant.time) || std::ptr::eq(*instant, last))
        .map(|instant| {
            vec![
                at(instant.time, time),
                match moves {
                    true => format!("{} m/s", digits(instant.approach_velocity, 4)),
                    false => format!(
                        "{} m/s",
                        digits(0.5 * (instant.speeds[0] + instant.speeds[1]), 4)
                    ),
                },
                match moves {
                    true => force(instant.film_force, kind.is_line(), 4),
                    false => force(instant.load, kind.is_line(), 4),
                },
                shown(instant, Figure::FilmCentral),
                shown(instant, Figure::FilmMinimum),
            ]
        })
        .collect();
    let [speed, load] = match moves {
        true => ["approach", "film force"],
        false => ["speed", "load"],
    };
    let head = ["time", speed, load, "central film", "minimum film"];
    out.table(Table {
        head: head.map(String::from).to_vec(),
        widths: vec![(10, 2), (12, 2), (13, 2), (18, 2), (18, 2)],
        rows,
    });
    out.note(match moves {
        true => "velocity of approach, film force; ±: grid error and time-step tolerance; no ± where fewer than three grids are available",
        false => "entrainment speed; ±: grid error and time-step tolerance; no ± where fewer than three grids are available",
    });
    out.heading("Effort");
    let mass = instants
        .iter()
        .map(|instant| instant.mass_error.abs())
        .fold(0.0, f64::max);
    let refused = match found.failure {
        // The number of refused steps is unknown.
        Some(TransientError::Interrupted) => String::new(),
        _ => format!(", {} refused", found.info.refused),
    };
    out.row(
        "time steps",
        format!(
            "{}{refused}, from {} to {}",
            found.info.steps,
            at(first.time, time),
            at(last.time, time)
        ),
    );
    out.row(
        "Newton iterations",
        found.info.newton_iterations.to_string(),
    );
    out.row(
        "largest mass error of a step",
        format!("{} %", digits(100.0 * mass, 2)),
    );
    out.row("wall time", format!("{} s", digits(found.wall_seconds, 3)));
    if let Some(failure) = &found.failure {
        out.line(&failure.to_string());
    }
}

/// Unit for times up to this one (s), and its factor.
pub(super) fn time_unit(longest: f64) -> (f64, &'static str) {
    match longest {
        t if t < 2e-3 => (1e6, "µs"),
        t if t < 2.0 => (1e3, "ms"),
        _ => (1.0, "s"),
    }
}

pub(super) fn at(time: f64, (factor, unit): (f64, &str)) -> String {
    format!("{} {unit}", digits(factor * time, 4))
}

/// A film at an instant.
fn shown(instant: &InstantSolution, figure: Figure) -> String {
    let measured = &instant.measured;
    if !measured.is_resolved(figure) {
        return "not resolved".to_owned();
    }
    let estimate = measured.estimate(figure);
    let (factor, unit) = film_unit(estimate.value);
    with_bar(estimate, factor, unit)
}
