//! Case files: read, estimated, checked, their problem set up; a few iterations of line contacts.

use std::path::Path;
use std::time::{Duration, Instant};

use ertel::case::Case;
use ertel::engine::{Observer, SolveError};
use ertel::output;
use ertel::params::MeshParams;
use ertel::run;
use ertel::study::journal::PointKey;

use super::{Verdict, check_place, check_text};
use crate::finding::Defect;

/// Points of a curve that are set up.
const MOST_POINTS: usize = 5;
/// Pressure unknowns that a solve may go to.
const MOST_UNKNOWNS: usize = 3000;
/// Time after which a solve is asked to stop.
const PATIENCE: Duration = Duration::from_millis(400);

/// Reads `case.toml`, and goes as far as is possible without solving.
pub fn run(folder: &Path) -> Result<Verdict, Defect> {
    let case = match Case::read(&folder.join("case.toml")) {
        Ok(case) => case,
        Err(error) => return check_place(&error, folder),
    };
    let points = case.curve.iter().flat_map(|curve| &curve.points);
    let cases = points.map(|point| &point.case).take(MOST_POINTS);
    for case in std::iter::once(&case).chain(cases) {
        set_up(case)?;
        let contacts = case.contacts.iter().flat_map(|of| &of.study.points);
        for contact in contacts.take(MOST_POINTS) {
            set_up(&contact.case)?;
        }
    }
    Ok(Verdict::Taken)
}

/// The steps of all commands except the solver.
pub fn set_up(case: &Case) -> Result<(), Defect> {
    let (echo, figures) = (case.echo(), ertel::estimate::estimate(case));
    let whole = ertel::machine::estimate(case);
    output::estimate_report(&echo, &figures, whole.as_ref());
    if let Err(error) = output::estimate_json(&echo, &figures, whole.as_ref()) {
        return Err(Defect::wrong(
            "estimates that are not finite",
            error.to_string(),
        ));
    }
    drop(String::from(PointKey::new(case)));
    case.files(Path::new(""));
    if let Err(error) = run::check(case) {
        check_text(&error.to_string())?;
    }
    Ok(())
}

/// Solves `case.toml`, a line contact, on a small mesh for a moment. Only what is not converged may have no result.
pub fn solve(folder: &Path) -> Result<Verdict, Defect> {
    let mut case = match Case::read(&folder.join("case.toml")) {
        Ok(case) => case,
        Err(error) => return check_place(&error, folder),
    };
    if !case.contact.kind.is_line() {
        return Ok(Verdict::Refused);
    }
    case.curve = None;
    case.output.body_field = false;
    case.mesh = MeshParams {
        target_error: Some(0.1),
        max_unknowns: Some(MOST_UNKNOWNS),
        ..MeshParams::preset(Default::default(), case.contact.kind)
    };
    case.solver.error_estimate = true;
    let mut until = Until(Instant::now() + PATIENCE);
    match run::solve(&case, &mut until) {
        Ok(solution) => {
            let film = solution.summary.film_central.value;
            if !(film.is_finite() && film > 0.0) {
                return Err(Defect::wrong("a film that is none", film.to_string()));
            }
            output::report(&case.echo(), &solution, None);
            Ok(Verdict::Taken)
        }
        Err(SolveError::Interrupted) => Ok(Verdict::Taken),
        Err(error) => check_text(&error.to_string()),
    }
}

/// Asks to stop at a time.
struct Until(Instant);

impl Observer for Until {
    fn cancelled(&self) -> bool {
        Instant::now() > self.0
    }
}
