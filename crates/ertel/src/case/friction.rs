//! The friction law of machines.

use ertel_input::{InputError, Table};

use super::lubricant::Lubricant;
use super::{MachineEcho, SolverParams};

/// Whether the friction of a machine follows the shear-thinning law of its lubricant while its films are Newtonian; adds a row of the machine about it. Under an
/// estimated law, films are Newtonian unless `asked` for otherwise or thermal: its constants come from traction, and are
/// not verified for the inlet.
pub(super) fn by_law(
    root: &mut Table<'_>,
    machine: Option<&mut MachineEcho>,
    (lubricant, solver): (&Lubricant, &mut SolverParams),
    asked: bool,
    heat: bool,
) -> Result<bool, InputError> {
    let (Some(machine), Some(_)) = (machine, &lubricant.shear_thinning) else {
        return Ok(false);
    };
    let by_kind = lubricant.is_shear_by_kind;
    if by_kind && !asked && !heat {
        solver.newtonian = true;
    }
    // A rig compares friction with and without the law.
    let kind = match root.optional_table("machine")? {
        Some(table) => table.unnoted().optional_str("kind")?.unwrap_or_default(),
        None => "",
    };
    let is_rig = kind.replace('_', "-") == "ball-on-disc";
    let by_law = solver.newtonian && !heat && (by_kind || !is_rig);
    let law = match by_kind {
        true => {
            "law estimated for the kind of the base oil (Eyring and limiting stress), since no `shear_thinning` is given"
        }
        false => "shear thinning of the lubricant",
    };
    let films = match by_law {
        true => "films are Newtonian",
        false => "films follow the same law",
    };
    if by_kind || by_law {
        let row = ("friction".to_owned(), format!("{law}; {films}"));
        machine.rows.push(row);
    }
    Ok(by_law)
}
