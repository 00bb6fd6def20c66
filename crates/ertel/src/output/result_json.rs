//! `result.json`: everything but the fields, for programs.

use serde_json::{Value, json};

use super::CaseEcho;
use crate::solution::Solution;

/// Value of the key `format` by which a result is recognised.
pub const FORMAT: &str = "ertel-result";
/// Version of the layout of `result.json`.
pub const FORMAT_VERSION: u64 = 1;

/// The document; SI throughout.
pub fn result_json(case: &CaseEcho, solution: &Solution) -> serde_json::Result<Value> {
    let s = &solution.summary;
    // Share of the computed film by which a formula is off, where both exist
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
    Ok(json!({
        "format": FORMAT,
        "format_version": FORMAT_VERSION,
        "ertel_version": env!("CARGO_PKG_VERSION"),
        "title": case.title,
        "kind": solution.kind,
        "summary": s,
        "hertz": solution.hertz,
        "reduced_modulus": solution.reduced_modulus,
        "groups": solution.groups,
        "groups_asymptotic": solution.groups_asymptotic,
        "formulas": formulas,
        "warnings": solution.warnings,
        "case": { "given": case.given, "si": serde_json::to_value(case)? },
        "scales": solution.scales,
        "extents": { "inlet": inlet, "outlet": outlet, "side": side },
        "stats": serde_json::to_value(&solution.stats)?,
        "history": serde_json::to_value(&solution.history)?,
        "units": units(),
    }))
}

/// Units of the keys that have one; all others are dimensionless.
fn units() -> Value {
    json!({
        "film_central, film_minimum, film_centreline_minimum, rigid_separation": "m",
        "x, y, outlet_position, half_width, length, film, radius": "m",
        "pressure, pressure_maximum, pressure_minimum, spike, reduced_modulus, youngs_modulus, elastic_stress": "Pa",
        "viscosity": "Pa s",
        "density": "kg/m^3",
        "pressure_viscosity, pressure_viscosity_asymptotic": "1/Pa",
        "contact.load": "N (circular), N/m (line)",
        "entrainment_speed": "m/s",
        "temperature": "K",
        "seconds, wall_seconds": "s",
        "peak_memory": "byte",
        "extents, mesh": "half-widths a",
    })
}
