//! The folder of own lubricants and materials.

use std::path::{Path, PathBuf};

use ertel_rheology::database::{fluid_names, solid_names, use_own_data};

use crate::failure::Failure;
use crate::print;

/// Variable of the environment that names the folder where `--data` does not.
const VARIABLE: &str = "ERTEL_DATA";

/// Makes the files of the folder that the option or the environment names available by name, and notes which names of the database
/// they replace.
///
/// # Errors
///
/// A folder that cannot be read, or holds neither fluids nor solids.
pub fn set(option: Option<&Path>) -> Result<(), Failure> {
    let variable = || std::env::var_os(VARIABLE).filter(|value| !value.is_empty());
    let Some(folder) = option
        .map(Path::to_owned)
        .or_else(|| variable().map(PathBuf::from))
    else {
        return Ok(());
    };
    let own = use_own_data(&folder)?;
    for (kind, names, shipped) in [
        ("fluid", &own.fluids, fluid_names()),
        ("solid", &own.solids, solid_names()),
    ] {
        for name in names.iter().filter(|name| shipped.contains(&name.as_str())) {
            print::stderr(&format!(
                "note: the {kind} `{name}` is that of {}, not that of the database",
                folder.display()
            ));
        }
    }
    Ok(())
}
