//! `ertel estimate`.

use ertel::estimate;
use ertel::output;

use crate::args::EstimateArgs;
use crate::failure::Failure;
use crate::given::Given;
use crate::print;

/// Runs the command.
///
/// # Errors
///
/// A bad case, or an output that cannot be written.
pub fn run(arguments: &EstimateArgs) -> Result<(), Failure> {
    let case = Given::read(&arguments.case, &arguments.set)?.case;
    let (echo, figures) = (case.echo(), estimate::estimate(&case));
    if !arguments.json {
        return print::report(&output::estimate_report(&echo, &figures));
    }
    let text = output::estimate_json(&echo, &figures)
        .map(|json| format!("{json:#}\n"))
        .map_err(|error| Failure::Other(format!("cannot write the estimates: {error}")))?;
    print::stdout(&text)
}
