//! `ertel estimate`.

use ertel::estimate;
use ertel::machine;
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
    let whole = machine::estimate(&case);
    if !arguments.json {
        let text = output::estimate_report(&echo, &figures, whole.as_ref());
        return print::report(&text);
    }
    let text = output::estimate_json(&echo, &figures, whole.as_ref())
        .map(|json| format!("{json:#}\n"))
        .map_err(|error| Failure::Other(format!("cannot write the estimates: {error}")))?;
    print::stdout(&text)
}
