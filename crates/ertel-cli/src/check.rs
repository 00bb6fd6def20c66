//! Output of `ertel solve --check` and `--verbose`.

use std::path::Path;

use ertel::case::Case;
use ertel::contact::ContactKind;
use ertel::engine::SolveError;
use ertel::estimate::{CaseEstimate, estimate};
use ertel::machine;
use ertel::output;
use ertel::params::DEFAULT_TARGET_ERROR;
use ertel::run;
use ertel::solution::Solution;
use ertel::study::value_text;
use ertel::warning::WarningKind;
use serde_json::json;

use crate::args::SolveArgs;
use crate::cases::{Job, input_warnings, n_points};
use crate::events::{Events, path_text};
use crate::failure::Failure;
use crate::print::{self, warn};

/// Checks a case, or the points of its curve, for errors that a solve would refuse; then shows a summary.
///
/// # Errors
///
/// Cases that a solve would refuse.
pub fn run(job: &Job, arguments: &SolveArgs, events: &Events) -> Result<(), Failure> {
    let (name, case) = (&job.given.name, &job.given.case);
    check(case, name)?;
    let found = Checked::of(case);
    // Warnings of the estimates, in addition to those of the input; none for the points of a curve.
    let doubts = found.estimate.warnings.iter().filter(|warning| {
        let is_own = warning.kind != WarningKind::EstimateScope && !case.warnings.contains(warning);
        is_own && case.curve.is_none()
    });
    if events.is_on() {
        events.warn(&input_warnings(case));
        events.warn(doubts);
        events.emit(
            "checked",
            json!({
                "title": case.title,
                "folder": path_text(&job.folder),
                "points": found.n_points,
                "film_central": found.estimate.film.central,
                "film_minimum": found.estimate.film.minimum,
                "hertz_pressure": found.estimate.hertz.pressure,
                "half_width": found.estimate.hertz.half_width,
                "cpu_seconds": found.cpu_seconds,
            }),
        );
        return Ok(());
    }
    warn(doubts);
    if arguments.report.quiet {
        return Ok(());
    }
    let whole = machine::estimate(case);
    let text = output::check_report(&case.echo(), &found.estimate, whole.as_ref());
    let files: Vec<String> = job
        .given
        .files()
        .iter()
        .map(|f| f.display().to_string())
        .collect();
    let files = match files.is_empty() {
        true => name.clone(),
        false => files.join(", "),
    };
    print::report(&format!(
        "{text}\nThe solve\n{}\n{name} is valid (check only)\n",
        rows(&[
            ("files read", files),
            ("contacts to solve", found.points(case)),
            ("estimated time", found.time()),
            ("results would go to", job.folder.display().to_string()),
        ])
    ))
}

fn rows(rows: &[(&str, String)]) -> String {
    rows.iter()
        .map(|(name, value)| format!("  {name:<34}{value}\n"))
        .collect()
}

fn check(case: &Case, file: &str) -> Result<(), Failure> {
    let Some(curve) = &case.curve else {
        let refused = |error| Failure::Argument(format!("{file}: {}", Failure::from(error)));
        return check_contacts(case).map_err(refused);
    };
    for (i, point) in curve.points.iter().enumerate() {
        check_contacts(&point.case).map_err(|error| {
            Failure::Argument(format!(
                "{file}: point {} of the curve ({}): {}",
                i + 1,
                value_text(&curve.quantity, point.value()),
                Failure::from(error)
            ))
        })?;
    }
    Ok(())
}

/// Whether the solve of a contact, or of those of a machine, would begin.
fn check_contacts(case: &Case) -> Result<(), SolveError> {
    let contacts = case.contacts.iter();
    for point in contacts.flat_map(|contacts| &contacts.study.points) {
        run::check(&point.case)?;
    }
    run::check(case)
}

/// Estimates of a case before it is solved.
struct Checked {
    estimate: CaseEstimate,
    n_points: usize,
    cpu_seconds: f64,
}

impl Checked {
    fn of(case: &Case) -> Self {
        let (n_points, cpu_seconds) = match &case.curve {
            None => (n_points(case), cpu_seconds(case)),
            Some(curve) => {
                let points = curve.points.iter().map(|point| cpu_seconds(&point.case));
                let comparisons = f64::from(curve.newtonian) + f64::from(curve.isothermal);
                (
                    curve.points.len(),
                    points.sum::<f64>() * (1.0 + comparisons),
                )
            }
        };
        Self {
            estimate: estimate(case),
            n_points,
            cpu_seconds,
        }
    }

    fn points(&self, case: &Case) -> String {
        match &case.curve {
            None if self.n_points > 1 => {
                format!("{} distinct contacts", self.n_points)
            }
            None => "1".to_owned(),
            Some(curve) => format!("{}, over {}", self.n_points, curve.quantity.path),
        }
    }

    fn time(&self) -> String {
        let time = match self.cpu_seconds {
            s if s < 1.0 => "1 s".to_owned(),
            s if s < 100.0 => format!("{} s", ertel::words::digits(s, 1)),
            s if s < 6000.0 => format!("{} min", ertel::words::digits(s / 60.0, 2)),
            s => format!("{} h", ertel::words::digits(s / 3600.0, 2)),
        };
        format!("{time} on one core (rough)")
    }
}

/// Time of a case in time over that of a steady contact; for a line the ratio is larger, since its steady solve is short.
const IN_TIME: f64 = 30.0;
const LINE_IN_TIME: f64 = 50.0;
/// Steps of these.
const STEPS: f64 = 300.0;

/// CPU s of a contact or of those of a machine.
fn cpu_seconds(case: &Case) -> f64 {
    match &case.contacts {
        Some(contacts) => {
            let points = contacts.study.points.iter();
            points.map(|point| typical_cpu_seconds(&point.case)).sum()
        }
        None => typical_cpu_seconds(case),
    }
}

/// The time of a point contact falls with this power of its target error: the heaviest contact of a bearing 7210 B takes 4.9 s at 0.2 %, 1.8 s at 1 %.
const BY_TARGET: f64 = -0.6;

/// CPU s of cold solves: medians of the convergence map for lines (docs/performance.md), shipped cases for the others, of
/// which most took between half and twice as long.
fn typical_cpu_seconds(case: &Case) -> f64 {
    let is_line = case.contact.kind.is_line();
    let one = match case.contact.kind {
        ContactKind::Line => 0.1,
        ContactKind::Circular => 1.5,
        ContactKind::Elliptical | ContactKind::Roller => 4.0,
    };
    let heat = match (case.thermal().is_some(), is_line) {
        (false, _) => 1.0,
        (true, true) => 30.0,
        (true, false) => 4.0,
    };
    let target = case.mesh.target_error.filter(|_| !is_line);
    let target = target.map_or(1.0, |target| target / DEFAULT_TARGET_ERROR);
    let one = one * target.powf(BY_TARGET);
    let sensitivities = if case.wants_sensitivities() { 2.0 } else { 1.0 };
    // Lines of gears and cams took 0.7 to 1 s with thinning, most of it outside the linear systems.
    let one = match is_line && case.shear_thinning().is_some() {
        true => 8.0 * one,
        false => one,
    };
    // Both halves are solved where they differ, and a starved contact again with a flooded inlet.
    let halves = if case.motion.is_straight() { 1.0 } else { 2.0 };
    let supplies = if case.supply.is_limited() { 3.5 } else { 1.0 };
    let in_time = match (&case.transient, is_line) {
        (None, _) => return one * heat * sensitivities * halves * supplies,
        (Some(_), true) => LINE_IN_TIME,
        (Some(_), false) => IN_TIME,
    };
    let steps = (case.transient.as_ref()).map_or(0.0, |transient| transient.least_steps());
    let in_time = in_time * (steps / STEPS).max(1.0);
    one * heat * halves * in_time
}

/// Shows the summary of a verbose solve before it begins, on stderr.
///
/// # Errors
///
/// None yet.
pub fn announce(job: &Job) -> Result<(), Failure> {
    let case = &job.given.case;
    let found = Checked::of(case);
    for file in job.given.files() {
        print::stderr(&format!("read {}", file.display()));
    }
    let film = &found.estimate.film;
    print::stderr(&format!(
        "{}; Hertz pressure {}, half-width {}; central film by {} {}",
        found.points(case) + if found.n_points == 1 { " contact" } else { "" },
        ertel::words::pressure(found.estimate.hertz.pressure),
        ertel::words::length(found.estimate.hertz.half_width),
        film.central_formula,
        ertel::words::length(film.central),
    ));
    print::stderr(&format!("estimated time {}", found.time()));
    print::stderr(&format!("results will go to {}", job.folder.display()));
    Ok(())
}

/// The meshes of a solve and the files written.
pub fn effort(solution: &Solution, folder: &Path) -> String {
    let mut text = "\nMeshes\n".to_owned();
    for (i, level) in solution.stats.levels.iter().enumerate() {
        text += &format!(
            "  {:>2}: {} elements, {} pressure unknowns of order {}, {} Newton and {} Krylov iterations\n",
            i + 1,
            level.n_contact_elements,
            level.n_pressure_dofs,
            level.pressure_order,
            level.newton_iterations,
            level.krylov_iterations,
        );
    }
    text += "\nFiles\n";
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
    let mut names: Vec<String> = entries
        .map(|entry| entry.file_name().to_string_lossy().into_owned())
        .collect();
    names.sort();
    for name in names {
        text += &format!("  {}\n", folder.join(name).display());
    }
    text
}
