//! `result.json`: everything except the fields, in machine-readable form.

use serde_json::{Value, json};

use crate::case::CaseEcho;
use crate::run::NUMERICS;
use crate::solution::{Figure, Located, Section, Solution};
use crate::warning::{codes, notes, silenced, texts};

/// Value of the key `format` that identifies a result.
pub const FORMAT: &str = "ertel-result";
/// Version of the layout of `result.json`.
pub const FORMAT_VERSION: u64 = 2;

/// The JSON document in SI units.
pub fn result_json(case: &CaseEcho, solution: &Solution) -> serde_json::Result<Value> {
    let s = &solution.summary;
    // Relative difference of a formula from the computed film, if both exist
    let difference = |formula: Option<f64>, film: f64| formula.map(|h| h / film - 1.0);
    let formulas: Vec<Value> = solution
        .formulas
        .iter()
        .map(|f| {
            json!({
                "name": f.name,
                "film_central": f.central,
                "film_minimum": f.minimum,
                "difference_central": difference(f.central, s.film_central.value),
                "difference_minimum": difference(f.minimum, s.film_minimum.value),
                "source": f.source,
            })
        })
        .collect();
    let [inlet, outlet, side] = solution.extents;
    let mut document = json!({
        "format": FORMAT,
        "format_version": FORMAT_VERSION,
        "ertel_version": env!("CARGO_PKG_VERSION"),
        "numerics_version": NUMERICS,
        "title": case.title,
        "kind": solution.kind,
        "figures": figures_json(solution),
        "summary": s,
        "traction": solution.traction,
        "summed_to": solution.summed_to,
        "checks": solution.checks,
        "film_reduction": solution.film_reduction,
        "hertz": solution.hertz,
        "reduced_modulus": solution.reduced_modulus,
        "groups": solution.groups,
        "groups_asymptotic": solution.groups_asymptotic,
        "formulas": formulas,
        "unresolved": solution.unresolved,
        "warnings": texts(&solution.warnings),
        "warning_codes": codes(&solution.warnings),
        "silenced": silenced(&solution.warnings),
        "notes": notes(&solution.warnings),
        "left_out": solution.left_out,
        "body_1_speed": case.motion.body_1_speed(),
        "body_2_speed": case.motion.body_2_speed(),
        "case": { "given": case.given, "si": serde_json::to_value(case)? },
        "scales": solution.scales,
        "extents": { "inlet": inlet, "outlet": outlet, "side": side },
        "stats": serde_json::to_value(&solution.stats)?,
        "history": serde_json::to_value(&solution.history)?,
        "units": units(solution.shape.is_line()),
    });
    if let Some(starvation) = &solution.starvation {
        document["starvation"] = serde_json::to_value(starvation)?;
    }
    for (figure, at) in solution.figures() {
        if figure.section() == Section::Roller {
            document["roller"][figure.name()] = match figure.has_place() {
                true => serde_json::to_value(at)?,
                false => serde_json::to_value(at.estimate())?,
            };
        }
    }
    if let Some(sensitivities) = &solution.sensitivities {
        document["sensitivities"] = serde_json::to_value(sensitivities)?;
        let per_kelvin: serde_json::Map<String, Value> = (sensitivities.figures.iter())
            .map(|figure| {
                let by = sensitivities.per_kelvin(figure).into_iter();
                let by: serde_json::Map<String, Value> =
                    by.map(|(key, by)| (key.to_owned(), by.into())).collect();
                (figure.figure.name().to_owned(), by.into())
            })
            .collect();
        document["sensitivities_per_kelvin"] = per_kelvin.into();
        document["sensitivities_by"] = sensitivities.by.words().into();
        let left_out: serde_json::Map<String, Value> = (sensitivities.left_out.iter())
            .map(|input| (input.key.clone(), input.reason.clone().into()))
            .collect();
        document["sensitivities_left_out"] = left_out.into();
    }
    if let Some(uncertainty) = &solution.uncertainty {
        document["uncertainty"] = serde_json::to_value(uncertainty)?;
    }
    if let Some(mixed) = &solution.mixed {
        document["mixed"] = serde_json::to_value(mixed)?;
    }
    if let Some(stresses) = &solution.stresses {
        document["stress"] = serde_json::to_value(stresses)?;
    }
    if let Some(wear) = &solution.wear {
        document["wear"] = serde_json::to_value(wear)?;
    }
    if let Some(thermal) = &solution.thermal {
        document["thermal"] = serde_json::to_value(thermal)?;
    }
    Ok(document)
}

/// Every figure of the contact by name: value, error bar, unit, and place if it has one.
pub(super) fn figures_json(solution: &Solution) -> Value {
    let is_line = solution.shape.is_line();
    let entry = |(figure, at): (Figure, Located)| {
        let mut entry = json!({
            "value": at.value,
            "error": at.error,
            "resolved": at.error.map(|_| at.resolved),
            "unit": figure.unit(is_line),
        });
        if figure.has_place() {
            entry["x"] = at.x.into();
            entry["y"] = at.y.into();
            entry["place_error"] = at.place_error.into();
            entry["place_resolved"] = at.place_resolved.into();
        }
        (figure.name().to_owned(), entry)
    };
    let figures: serde_json::Map<String, Value> = solution.figures().map(entry).collect();
    figures.into()
}

/// Unit of each key with a dimension, wherever it occurs; all others are dimensionless.
pub(super) fn units(is_line: bool) -> Value {
    const UNITS: [(&str, &[&str]); 11] = [
        (
            "m",
            &[
                "x",
                "y",
                "place_error",
                "rigid_separation",
                "half_width",
                "radius",
                "roughness",
                "thickness",
                "distance",
                "asperity_distances",
                "film_central_flooded",
                "film_minimum_flooded",
                "length",
                "body_end_x",
                "body_end_y",
                "depth",
                "depth_error",
                "cut_depth",
                "width",
                "sliding_distance",
                "track_length",
                "body_1_depth",
                "body_2_depth",
            ],
        ),
        (
            "Pa",
            &[
                "pressure",
                "pressure_minimum",
                "asperity_pressure_maximum",
                "asperity_pressures",
                "hardness",
                "reduced_modulus",
                "youngs_modulus",
                "von_mises",
                "largest_shear",
                "tension",
                "orthogonal_half_range",
                "dang_van",
                "fatemi_socie",
                "fatigue_limit",
                "orthogonal_range",
            ],
        ),
        ("Pa s", &["viscosity"]),
        ("kg/m^3", &["density"]),
        (
            "1/Pa",
            &["pressure_viscosity", "pressure_viscosity_asymptotic"],
        ),
        (
            "m/s",
            &["entrainment_speed", "body_1_speed", "body_2_speed"],
        ),
        (
            "K",
            &[
                "temperature",
                "temperature_rise",
                "inlet_temperature",
                "body_1_temperature",
                "body_2_temperature",
            ],
        ),
        ("W/(m K)", &["thermal_conductivity"]),
        ("J/(kg K)", &["heat_capacity"]),
        ("s", &["seconds", "wall_seconds"]),
        ("byte", &["peak_memory"]),
    ];
    let others = UNITS
        .iter()
        .flat_map(|(unit, keys)| keys.iter().map(|k| ((*k).to_owned(), *unit)));
    let figures = Figure::ALL.into_iter().flat_map(|figure| {
        let name = figure.name();
        let place = (figure.has_place()).then(|| (format!("{name}_at"), "m"));
        let own =
            Some((name.to_owned(), figure.unit(is_line))).filter(|(_, unit)| !unit.is_empty());
        own.into_iter().chain(place)
    });
    let volume = if is_line { "m^2" } else { "m^3" };
    let volumes = ["volume", "body_1_volume", "body_2_volume"].map(|key| (key.to_owned(), volume));
    others
        .chain(volumes)
        .chain(figures)
        .map(|(key, unit)| (key, Value::from(unit)))
        .collect()
}
