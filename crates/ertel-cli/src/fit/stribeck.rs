//! `ertel fit stribeck`.

use std::sync::atomic::Ordering;

use ertel::compare::{Measured, ReadParams};
use ertel::fit::{FitObserver, StribeckError, StribeckFit, fit_stribeck};
use ertel::words::digits;

use crate::args::FitStribeckArgs;
use crate::failure::Failure;
use crate::interrupt::{CANCELLED, listen_for_interrupts};
use crate::print;
use crate::table::columns;

/// Runs the command.
///
/// # Errors
///
/// A table or case that cannot be read or fitted, contacts that do not converge, an interruption.
pub fn run(arguments: &FitStribeckArgs) -> Result<(), Failure> {
    let params = ReadParams {
        table: arguments.table.params(&arguments.ignore),
        ..ReadParams::default()
    };
    let measured = Measured::read(&arguments.case, &arguments.data, &params)?;
    for note in &measured.notes {
        print::stderr(&format!("note: {note}"));
    }
    listen_for_interrupts();
    let progress = Progress {
        is_quiet: arguments.quiet,
    };
    let file = arguments.data.display().to_string();
    let fit = fit_stribeck(&measured, arguments.asperity_group, &progress)
        .map_err(|error| failure(&file, error))?;
    for warning in &fit.warnings {
        print::stderr(&format!("warning: {warning}"));
    }
    print::stdout(&report(&fit, &file))
}

fn failure(file: &str, error: StribeckError) -> Failure {
    match error {
        StribeckError::Interrupted => Failure::Interrupted,
        StribeckError::NotConverged(..) | StribeckError::NoMinimum(_) => {
            Failure::NotConverged(format!("{file}: {error}"))
        }
        error => Failure::Argument(format!("{file}: {error}")),
    }
}

/// Rounds on stderr.
struct Progress {
    is_quiet: bool,
}

impl FitObserver for Progress {
    fn round(&self, round: usize, n_solves: usize) {
        if !self.is_quiet {
            print::stderr(&format!("round {round}: {n_solves} contacts"));
        }
    }

    fn cancelled(&self) -> bool {
        CANCELLED.load(Ordering::Relaxed)
    }
}

fn report(fit: &StribeckFit, file: &str) -> String {
    let row = |cells: [String; 3]| cells.to_vec();
    let mut rows = vec![row([
        "constant".into(),
        "value".into(),
        "standard uncertainty".into(),
    ])];
    for own in &fit.constants {
        let name = own.constant.words().to_owned();
        rows.push(match own.standard.filter(|_| own.is_resolved()) {
            Some(standard) => row([
                name,
                own.constant.text(own.value),
                format!("± {}", own.constant.text(standard)),
            ]),
            None => row([name, "not resolved".into(), String::new()]),
        });
    }
    let mut text = format!(
        "Boundary friction and roughness fitted to {} readings in {file}\n\n{}",
        fit.points.len(),
        columns(&rows)
    );
    text += "\n";
    for (one, other, correlation) in &fit.correlations {
        let [one, other] = [one, other].map(|own| own.words());
        text += &format!("  correlation of {one} and {other}: {correlation:.2}\n");
    }
    let number = |value: f64| digits(value, 4);
    let titles = [
        "line",
        "point",
        "measured",
        "fitted",
        "asperities",
        "residual",
    ];
    let mut rows = vec![titles.map(str::to_owned).to_vec()];
    for point in &fit.points {
        rows.push(vec![
            point.line.to_string(),
            point.label.clone(),
            number(point.measured),
            number(point.fitted),
            number(point.asperities),
            format!("{:+.4}", point.fitted - point.measured),
        ]);
    }
    let scatter = match fit.is_weighted {
        true => "standard deviation of the residuals over the uncertainties of the readings",
        false => "standard deviation of the residuals",
    };
    text += &format!(
        "\n{}\n  {scatter}: {}\n",
        columns(&rows),
        digits(fit.scatter, 3)
    );
    text += &format!(
        "  {} contacts solved with a target error of {} % of the films; error bars of their friction up to {}\n",
        fit.n_solves,
        digits(100.0 * fit.target_error, 2),
        digits(fit.largest_bar, 2)
    );
    text + "\n" + &fit.section()
}
