//! By which law the friction of machines goes.

use ertel_input::{InputError, Table};

use super::lubricant::Lubricant;
use super::{MachineEcho, SolverParams};

/// Whether the friction of a machine goes by the law of its lubricant while its films are solved without it; says so among the rows of the machine. Films of a
/// law that is estimated because none is given are Newtonian, unless `asked` for otherwise or warmed by their friction: its constants come from traction, and are
/// not known to hold in the inlet.
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
            "by a law estimated for the kind of the base oil (Eyring and limiting stress), since no `shear_thinning` is given"
        }
        false => "by the shear thinning of the lubricant",
    };
    let films = match by_law {
        true => "films are Newtonian",
        false => "so are films",
    };
    if by_kind || by_law {
        let row = ("friction".to_owned(), format!("{law}; {films}"));
        machine.rows.push(row);
    }
    Ok(by_law)
}
