//! `[mesh]`, `[solver]` and `[output]`: all optional.

use std::path::PathBuf;

use ertel_input::{Bounds, InputError, Table};

use crate::contact::Contact;
use crate::params::SensitivityDemand;
use crate::params::{
    DEFAULT_TARGET_ERROR, ElasticModel, Formulation, LinearSolver, MeshParams, MeshPreset, Method,
    OutputParams, PenaltyScaling, PictureFormats, SolverParams,
};
use crate::warning::WarningKind;

/// Replaces `field` if the file gives a value.
pub(super) fn set<T>(field: &mut T, value: Option<T>) {
    if let Some(value) = value {
        *field = value;
    }
}

/// Largest extent of a contact area from its centre, in half-widths.
pub(super) const FARTHEST: f64 = 300.0;

/// Keys that define the mesh explicitly; such a mesh is not refined to a target.
const FIXED_MESH: [&str; 6] = [
    "preset",
    "hertz_size",
    "constriction_size",
    "edge_size",
    "growth",
    "depth_growth",
];

/// Targets that meshes of reasonable size reach, and above which films are meaningless.
const TARGET_ERROR: Bounds = Bounds::closed(2e-4, 0.1);

/// The same for the pressure.
const PRESSURE_ERROR: Bounds = Bounds::closed(1e-4, 0.2);

/// Default mesh.
pub(super) fn default_mesh(contact: &Contact, error_estimate: bool) -> MeshParams {
    if error_estimate {
        MeshParams::adaptive(DEFAULT_TARGET_ERROR, contact.kind)
    } else {
        MeshParams::preset(MeshPreset::default(), contact.kind)
    }
}

/// The mesh that `preset`, `target_error` and the sizes given choose.
fn chosen_mesh(
    table: &mut Table<'_>,
    contact: &Contact,
    error_estimate: bool,
) -> Result<MeshParams, InputError> {
    let preset = table.optional_choice(
        "preset",
        &[
            ("coarse", MeshPreset::Coarse),
            ("normal", MeshPreset::Normal),
            ("fine", MeshPreset::Fine),
        ],
    )?;
    let fixed = FIXED_MESH.into_iter().find(|key| table.contains(key));
    let target = table.optional_number("target_error", TARGET_ERROR)?;
    match (fixed, target) {
        (Some(key), Some(_)) => {
            Err(table
                .error(
                    "target_error",
                    format!("`target_error` and `{key}` are both given"),
                )
                .with_help(
                    "`target_error` refines the mesh until the films are that accurate; sizes and growth \
                     prescribe the mesh: give one or the other",
                ))
        }
        (None, Some(_)) if !error_estimate => {
            Err(table
                .error(
                    "target_error",
                    "`target_error` needs error estimates, but solver.error_estimate is false",
                )
                .with_help("remove one of the two"))
        }
        (None, Some(target)) => Ok(MeshParams::adaptive(target, contact.kind)),
        (Some(_), None) => Ok(MeshParams::preset(preset.unwrap_or_default(), contact.kind)),
        (None, None) => Ok(default_mesh(contact, error_estimate)),
    }
}

/// Reads `[mesh]`; without error estimates there is no target.
pub fn read_mesh(
    mut table: Table<'_>,
    contact: &Contact,
    error_estimate: bool,
) -> Result<MeshParams, InputError> {
    let mut mesh = chosen_mesh(&mut table, contact, error_estimate)?;
    let unknowns = table.optional_integer("max_unknowns", 1_000..=2_000_000)?;
    mesh.max_unknowns = unknowns.and_then(|n| usize::try_from(n).ok());
    read_pressure_error(&mut table, &mut mesh)?;
    // Sizes in Hertz half-widths; below these, no memory is large enough.
    let finest = if contact.kind.is_line() { 0.0002 } else { 0.01 };
    let size = Bounds::closed(finest, 2.0);
    set(
        &mut mesh.hertz_size,
        table.optional_number("hertz_size", size)?,
    );
    set(
        &mut mesh.constriction_size,
        table.optional_number("constriction_size", size)?,
    );
    set(
        &mut mesh.edge_size,
        table.optional_number("edge_size", size)?,
    );
    let growth = Bounds::closed(0.05, 2.0);
    set(&mut mesh.growth, table.optional_number("growth", growth)?);
    set(
        &mut mesh.depth_growth,
        table.optional_number("depth_growth", growth)?,
    );
    let extent = Bounds::closed(8.0, 2.0 * FARTHEST);
    mesh.body_width = table.optional_number("body_width", extent)?;
    mesh.body_depth = table.optional_number("body_depth", extent)?;
    for (larger, smaller, key) in [
        (mesh.hertz_size, mesh.constriction_size, "constriction_size"),
        (mesh.edge_size, mesh.hertz_size, "hertz_size"),
    ] {
        if smaller > larger {
            return Err(table.error(
                key,
                format!("`{key}` is {smaller}, but the cells farther out are {larger}"),
            )
            .with_help("sizes must not grow towards the constriction: constriction_size <= hertz_size <= edge_size"));
        }
    }
    mesh.rim_size = table.optional_number("rim_size", Bounds::above_to(0.0, mesh.edge_size))?;
    // The contact area must contain the dry contact and lie on the body.
    let half_width = mesh.body_width.map_or(FARTHEST, |width| 0.5 * width);
    mesh.inlet = table.optional_number("inlet", Bounds::from_to(-half_width, -1.0))?;
    mesh.outlet = table.optional_number("outlet", Bounds::above_to(1.0, half_width))?;
    let no_side = match contact.roller {
        Some(_) => Some("under a roller the film ends with its `length`"),
        None => contact.kind.is_line().then_some("a line contact has none"),
    };
    if let Some(reason) = no_side.filter(|_| table.contains("side")) {
        let text = format!("`side` is for circular and elliptical contacts; {reason}");
        return Err(table.error("side", text));
    }
    mesh.side = table.optional_number("side", Bounds::above_to(1.0, half_width))?;
    set(
        &mut mesh.pressure_order,
        order(&mut table, "pressure_order", 5)?,
    );
    mesh.elastic_order = order(&mut table, "elastic_order", 5)?;
    table.finish()?;
    Ok(mesh)
}

/// Further quantities that the mesh is refined for.
fn read_pressure_error(table: &mut Table<'_>, mesh: &mut MeshParams) -> Result<(), InputError> {
    let films_alone = table.optional_choice("refine_for", &[("films", true), ("fields", false)])?;
    let error = table.optional_number("pressure_error", PRESSURE_ERROR)?;
    for (key, given) in [
        ("refine_for", films_alone.is_some()),
        ("pressure_error", error.is_some()),
    ] {
        if given && mesh.target_error.is_none() {
            return Err(table
                .error(
                    key,
                    format!("`{key}` is for meshes that are refined to a target"),
                )
                .with_help(
                    "set `target_error`, or remove sizes, growth, preset and error_estimate",
                ));
        }
    }
    match (films_alone, error) {
        (Some(true), Some(_)) => {
            return Err(table
                .error(
                    "pressure_error",
                    "`pressure_error` is given, but the mesh is refined for films alone",
                )
                .with_help("remove `refine_for`, or `pressure_error`"));
        }
        (Some(true), None) => mesh.pressure_error = None,
        (_, Some(error)) => mesh.pressure_error = Some(error),
        _ => {}
    }
    Ok(())
}

/// A Lagrange order from 1 to `highest`.
pub(super) fn order(
    table: &mut Table<'_>,
    key: &str,
    highest: i64,
) -> Result<Option<usize>, InputError> {
    let order = table.optional_integer(key, 1..=highest)?;
    Ok(order.and_then(|order| usize::try_from(order).ok()))
}

/// Refuses half-spaces for a `wish`, given at `key`, that needs a finite-element body.
fn needs_body(
    table: &Table<'_>,
    solver: &SolverParams,
    key: &str,
    wish: &str,
) -> Result<(), InputError> {
    if solver.elasticity != Some(ElasticModel::HalfSpace) {
        return Ok(());
    }
    Err(table
        .error(
            key,
            format!("{wish} needs a finite-element body, but solver.elasticity is \"half-space\""),
        )
        .with_help(format!(
            "write `elasticity = \"equivalent\"` in [solver], or remove {wish}"
        )))
}

/// Rounding keeps the residual from falling below this.
const MIN_TOLERANCE: f64 = 1e-11;

/// Reads the section `[solver]`.
///
/// # Errors
/// Unknown keys, and values out of their bounds.
pub fn read_solver(mut table: Table<'_>) -> Result<SolverParams, InputError> {
    let mut solver = SolverParams::default();
    let method = table.optional_choice(
        "method",
        &[Method::FiniteElements, Method::FiniteVolumes].map(|method| (method.name(), method)),
    )?;
    solver.method = method;
    let formulation = table.optional_choice(
        "formulation",
        &[
            ("galerkin", Formulation::Galerkin),
            ("supg", Formulation::Supg),
            ("gls", Formulation::Gls),
        ],
    )?;
    set(&mut solver.formulation, formulation);
    set(
        &mut solver.isotropic_diffusion,
        table.optional_number("isotropic_diffusion", Bounds::closed(0.0, 10.0))?,
    );
    solver.ridge_diffusion = table.optional_number("ridge_diffusion", Bounds::closed(0.0, 10.0))?;
    set(
        &mut solver.elastic_stabilisation,
        table.optional_bool("elastic_stabilisation")?,
    );
    set(
        &mut solver.penalty,
        table.optional_number("penalty", Bounds::closed(1.0, 1e15))?,
    );
    let scaling = table.optional_choice(
        "penalty_scaling",
        &[
            ("element-squared", PenaltyScaling::ElementSquared),
            ("film", PenaltyScaling::Film),
            ("constant", PenaltyScaling::Constant),
            (
                "inverse-element-squared",
                PenaltyScaling::InverseElementSquared,
            ),
        ],
    )?;
    set(&mut solver.penalty_scaling, scaling);
    let elasticity = table.optional_choice(
        "elasticity",
        &[
            ("half-space", ElasticModel::HalfSpace),
            ("equivalent", ElasticModel::Equivalent),
            ("two-bodies", ElasticModel::TwoBodies),
        ],
    )?;
    solver.elasticity = elasticity;
    let linear = table.optional_choice(
        "linear",
        &[
            ("condensed", LinearSolver::Condensed),
            ("monolithic", LinearSolver::Monolithic),
        ],
    )?;
    set(&mut solver.linear, linear);
    if solver.linear == LinearSolver::Monolithic {
        needs_body(&table, &solver, "linear", "`linear = \"monolithic\"`")?;
    }
    set(
        &mut solver.tolerance,
        table.optional_number("tolerance", Bounds::closed(MIN_TOLERANCE, 1e-2))?,
    );
    let iterations = table.optional_integer("max_iterations", 1..=10_000)?;
    set(
        &mut solver.max_iterations,
        iterations.and_then(|n| usize::try_from(n).ok()),
    );
    set(
        &mut solver.error_estimate,
        table.optional_bool("error_estimate")?,
    );
    set(&mut solver.newtonian, table.optional_bool("newtonian")?);
    set(&mut solver.isothermal, table.optional_bool("isothermal")?);
    table.finish()?;
    Ok(solver)
}

/// Kinds of warnings by their codes.
fn read_silence(table: &Table<'_>, codes: &[&str]) -> Result<Vec<WarningKind>, InputError> {
    let kind = |code: &&str| {
        let kind = WarningKind::with_code(code).ok_or_else(|| unknown_code(table, code))?;
        match kind.may_be_silenced() {
            true => Ok(kind),
            false => Err(table
                .error("silence", format!("`{code}` cannot be silenced"))
                .with_help(
                    "it marks figures that are not to be used; `ertel explain` shows the remedy",
                )),
        }
    };
    codes.iter().map(kind).collect()
}

fn unknown_code(table: &Table<'_>, code: &str) -> InputError {
    let all = WarningKind::ALL
        .iter()
        .filter(|kind| kind.may_be_silenced());
    let all: Vec<&str> = all.map(|kind| kind.code()).collect();
    (table.error("silence", format!("`{code}` is not a code of warnings")))
        .with_help(format!("the codes are {}", all.join(", ")))
}

pub(super) fn read_output(
    mut table: Table<'_>,
    solver: &SolverParams,
    contact: &Contact,
    is_in_time: bool,
) -> Result<OutputParams, InputError> {
    let mut output = OutputParams::default();
    if let Some(folder) = table.optional_str("folder")? {
        if folder.trim().is_empty() {
            return Err(table.error("folder", "`folder` must not be empty"));
        }
        output.folder = Some(PathBuf::from(folder));
    }
    if let Some(names) = table.optional_strs("pictures")? {
        let known = PictureFormats::NAMES
            .map(|name| format!("\"{name}\""))
            .join(", ");
        output.pictures = PictureFormats::named(names.iter().copied()).ok_or_else(|| {
            let unknown = names.iter().find(|n| !PictureFormats::NAMES.contains(n));
            let unknown = unknown.copied().unwrap_or_default();
            table
                .error("pictures", format!("`{unknown}` is not a picture format"))
                .with_help(format!("the formats are {known}"))
        })?;
    }
    set(&mut output.body_field, table.optional_bool("body_field")?);
    set(&mut output.netcdf, table.optional_bool("netcdf")?);
    for (key, asked, instead) in [
        (
            "vtu",
            &mut output.vtu,
            "other cases always write surface.vtu",
        ),
        ("animation", &mut output.animation, "other cases are steady"),
    ] {
        set(asked, table.optional_bool(key)?);
        if *asked && !is_in_time {
            return Err(table.error(
                key,
                format!("`{key} = true` is for cases with [transient]: {instead}"),
            ));
        }
    }
    if let Some(wanted) = table.optional_bool("sensitivities")? {
        output.sensitivities = match wanted {
            true => SensitivityDemand::All,
            false => SensitivityDemand::Off,
        };
    }
    if let Some(codes) = table.optional_strs("silence")? {
        output.silence = read_silence(&table, &codes)?;
    }
    if output.body_field {
        needs_body(&table, solver, "body_field", "`body_field = true`")?;
    }
    if let Some(light) = table.optional_table("interferogram")? {
        output.interferogram = Some(super::interferogram::read(light, contact)?);
    }
    table.finish()?;
    Ok(output)
}
