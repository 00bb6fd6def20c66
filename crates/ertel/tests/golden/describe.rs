//! A case solved, and all that it gives as a record.

use std::path::Path;

use ertel::case::Case;
use ertel::engine::NoObserver;
use ertel::run::solve;
use ertel::solution::{Figure, Solution};
use ertel::study::curve::solve_curve;
use serde::Serialize;
use serde_json::Value;

use super::figures::{PlacedFigure, placed_figure};
use super::machine::Machine;
use super::record::Record;
use super::whole;

/// The record of a case, or of the points of its curve, each of which starts from the last.
pub fn record(path: &Path, machine: &Machine) -> Result<Record, String> {
    let case = Case::read(path).map_err(|error| error.to_string())?;
    let mut record = Record::default();
    machine.note(&mut record);
    if case.curve.is_none() && whole::note(&mut record, &case)? {
        return Ok(record);
    }
    let Some(curve) = &case.curve else {
        let solution = solve(&case, &mut NoObserver).map_err(|error| error.to_string())?;
        describe(&mut record, &solution)?;
        return Ok(record);
    };
    let mut curve = curve.clone();
    // Else the fields of the points are not kept.
    curve.folders = true;
    let found = solve_curve(&curve, &mut NoObserver);
    for (i, point) in found.points.iter().enumerate() {
        let mut own = Record::default();
        match point.outcome.solution() {
            Some(solution) => describe(&mut own, solution)?,
            None => {
                let reason = point.outcome.reason().unwrap_or("no reason");
                return Err(format!("point {}: {reason}", i + 1));
            }
        }
        record.append(&format!("point {}", i + 1), own);
    }
    Ok(record)
}

/// As a document of its serialized parts.
fn document(value: &impl Serialize) -> Result<Value, String> {
    serde_json::to_value(value).map_err(|error| error.to_string())
}

fn describe(record: &mut Record, solution: &Solution) -> Result<(), String> {
    for figure in Figure::ALL {
        if let Some(found) = placed_figure(solution, figure) {
            note_figure(record, figure, &found);
        }
    }
    for unresolved in &solution.unresolved {
        let why = format!("{:?}", unresolved.why);
        record.put("unresolved", unresolved.name(), why);
    }
    for (i, warning) in solution.warnings.iter().enumerate() {
        let kind = document(&warning.kind)?;
        record.document("warnings", &i.to_string(), &kind);
    }
    note_parts(record, solution)?;
    note_derivatives(record, solution);
    note_levels(record, solution)?;
    note_fields(record, solution);
    Ok(())
}

fn note_figure(record: &mut Record, figure: Figure, found: &PlacedFigure) {
    let name = figure.name();
    record.float("figures", name, found.estimate.value);
    if let Some(bar) = found.estimate.error {
        record.float("figures", format!("{name} bar"), bar);
    }
    let Some(place) = &found.place else {
        return;
    };
    record.float("figures", format!("{name} x"), place.x);
    record.float("figures", format!("{name} y"), place.y);
    if let Some(bar) = place.place_error {
        record.float("figures", format!("{name} place bar"), bar);
    }
}

/// Values outside the registry of figures, as in `result.json`.
fn note_parts(record: &mut Record, solution: &Solution) -> Result<(), String> {
    let s = &solution.summary;
    record.float("checks", "pressure_minimum", s.pressure_minimum);
    record.float("checks", "rigid_separation", s.rigid_separation);
    record.document("checks", "", &document(&solution.checks)?);
    record.document("checks", "summed_to", &document(&solution.summed_to)?);
    record.document("contact", "hertz", &document(&solution.hertz)?);
    record.float("contact", "reduced_modulus", solution.reduced_modulus);
    record.document("contact", "groups", &document(&solution.groups)?);
    let asymptotic = document(&solution.groups_asymptotic)?;
    record.document("contact", "groups_asymptotic", &asymptotic);
    record.document("contact", "scales", &document(&solution.scales)?);
    record.document("contact", "extents", &document(&solution.extents)?);
    for formula in &solution.formulas {
        let mut put = |which: &str, film: Option<f64>| {
            if let Some(film) = film {
                record.float("formulas", format!("{} {which}", formula.name), film);
            }
        };
        put("central", formula.central);
        put("minimum", formula.minimum);
    }
    record.document("left_out", "", &document(&solution.left_out)?);
    if let Some(starvation) = &solution.starvation {
        record.document("starvation", "", &document(starvation)?);
    }
    if let Some(mixed) = &solution.mixed {
        record.document("mixed", "", &document(mixed)?);
    }
    if let Some(reduction) = &solution.film_reduction {
        record.document("film_reduction", "", &document(reduction)?);
    }
    let Some(thermal) = &solution.thermal else {
        return Ok(());
    };
    record.float(
        "thermal",
        "balance heat_balance_error",
        thermal.balance.error,
    );
    record.document("thermal", "reduction", &document(&thermal.reduction)?);
    record.document("thermal", "coupling", &document(&thermal.coupling)?);
    for (i, profile) in thermal.profiles.iter().enumerate() {
        let columns = [
            ("temperature", &profile.temperature),
            ("velocity_x", &profile.velocity_x),
            ("velocity_y", &profile.velocity_y),
            ("shear_rate", &profile.shear_rate),
            ("viscosity", &profile.viscosity),
        ];
        for (name, values) in columns {
            let sum = values.iter().sum();
            record.float("thermal", format!("profile {i} {name} sum"), sum);
        }
    }
    Ok(())
}

/// Derivatives of the figures by the inputs, and the resulting uncertainties.
fn note_derivatives(record: &mut Record, solution: &Solution) {
    if let Some(found) = &solution.sensitivities {
        for figure in &found.figures {
            for (input, by) in found.inputs.iter().zip(&figure.derivatives) {
                let key = format!("{} by {}", figure.figure.name(), input.key);
                record.float("sensitivities", key, *by);
            }
        }
        for input in &found.left_out {
            record.put("sensitivities", format!("by {}", input.key), "left out");
        }
    }
    for found in solution.uncertainty.iter().flat_map(|u| &u.0) {
        let name = found.figure.name();
        record.float("uncertainty", name, found.half_width);
        for (key, share) in &found.shares {
            record.float("uncertainty", format!("{name} share of {key}"), *share);
        }
    }
}

/// The meshes with their counts.
fn note_levels(record: &mut Record, solution: &Solution) -> Result<(), String> {
    let (section, stats) = ("levels", &solution.stats);
    record.put(section, "number", stats.levels.len());
    record.put(section, "warm", stats.warm);
    record.put(section, "iterations", solution.history.len());
    for (i, level) in stats.levels.iter().enumerate() {
        let key = |name: &str| format!("{i} {name}");
        record.document(section, &key("role"), &document(&level.role)?);
        record.put(section, key("converged"), level.converged);
        for (name, count) in [
            ("pressure order", level.pressure_order),
            ("contact elements", level.n_contact_elements),
            ("body cells", level.n_body_cells),
            ("pressures", level.n_pressure_dofs),
            ("displacements", level.n_displacement_dofs),
            ("surface displacements", level.n_contact_dofs),
            ("Newton iterations", level.newton_iterations),
            ("Krylov iterations", level.krylov_iterations),
            ("factorisations", level.factorisations),
        ] {
            record.put(section, key(name), count);
        }
        let [central, minimum] = level.films();
        record.float(section, key("film_central"), central);
        record.float(section, key("film_minimum"), minimum);
    }
    Ok(())
}

/// Places along the motion in half-widths, of which point contacts have every third.
const X: [f64; 9] = [-1.3, -0.8, -0.5, -0.2, 0.1, 0.3, 0.5, 0.75, 0.95];

/// Places across it in semi-axes, or half-lengths of a roller.
const Y: [f64; 3] = [-0.55, 0.0, 0.35];

/// The fields at nine points, and their sums over all points that there are.
fn note_fields(record: &mut Record, solution: &Solution) {
    let fields = solution.fields();
    let is_line = solution.shape.is_line();
    let x: Vec<f64> = (X.into_iter().skip(usize::from(!is_line)))
        .step_by(if is_line { 1 } else { 3 })
        .collect();
    let roller = solution.shape.zone.roller.as_ref();
    let hertz = &solution.hertz;
    let width = match roller {
        Some(roller) => roller.half_length() * solution.scales.length,
        None => hertz.half_width_y.unwrap_or(hertz.half_width),
    };
    let scaled = |places: &[f64], size: f64| places.iter().map(|v| v * size).collect::<Vec<_>>();
    let grids = fields.on_grid(&scaled(&x, hertz.half_width), &scaled(&Y, width));
    for (grid, (field, values)) in grids.iter().zip(&fields.fields) {
        let name = field.column();
        for (i, value) in grid.values.iter().enumerate() {
            let [at_x, at_y] = [x[i % x.len()], Y[i / x.len()]];
            let place = match is_line {
                true => format!("{at_x}"),
                false => format!("{at_x}, {at_y}"),
            };
            record.float("fields", format!("{name} at {place}"), *value);
        }
        record.float("fields", format!("{name} sum"), values.iter().sum());
    }
    if let Some(body) = &solution.body {
        for axis in 0..3 {
            let sum = body.displacement.iter().map(|u| u[axis]).sum();
            record.float("fields", format!("body displacement {axis} sum"), sum);
        }
    }
}
