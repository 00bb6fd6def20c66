//! Estimates of a case, as text and JSON.

use std::fmt::Write;

use serde_json::{Value, json};

use super::FORMAT_VERSION;
use super::figure::{percent_or_power, power};
use super::lines::Lines;
use super::machine::{estimate_units, estimate_values, write_estimate};
use super::report::{write_case, write_contact};
use super::result_json::units;
use crate::case::CaseEcho;
use crate::estimate::{CaseEstimate, NEGLIGIBLE_INERTIA};
use crate::machine::MachineEstimate;
use crate::reference::biboulet_houpert::SOURCE;
use crate::solution::FormulaFilm;
use crate::warning::Warning;
use crate::words::{digits, length};

/// Value of the key `format` in the JSON document.
pub const ESTIMATE_FORMAT: &str = "ertel-estimate";

/// The estimates as text: the case in SI, figures and contacts of a whole machine, then of its most loaded contact or of the only one Hertz contact, groups, regime,
/// film formulas, and their consequences.
pub fn estimate_report(
    case: &CaseEcho,
    estimate: &CaseEstimate,
    machine: Option<&MachineEstimate>,
) -> String {
    let mut out = Lines::default();
    out.title(&case.title);
    write_case(&mut out, case);
    if let Some(of) = machine {
        write_estimate(&mut out, of);
        out.heading("Most loaded contact");
        out.row("contact", &of.machine.contacts[of.machine.governing].name);
    }
    write_contact(
        &mut out,
        (&case.contact, &estimate.hertz),
        estimate.reduced_modulus,
        &estimate.groups,
        estimate.groups_asymptotic.as_ref(),
    );
    if let (Some(g_v), Some(g_e)) = (
        estimate.chart.viscosity_parameter,
        estimate.chart.elasticity_parameter,
    ) {
        out.row(
            "  regime chart",
            format!("g_V {}   g_E {}", power(g_v), power(g_e)),
        );
    }
    write_regime(&mut out, estimate);
    write_formulas(&mut out, estimate);
    write_film(&mut out, estimate);
    write_thermal(&mut out, estimate);
    out.warnings(&warnings(estimate, machine));
    out.text()
}

/// The warnings of the contact, and of the machine.
fn warnings(estimate: &CaseEstimate, machine: Option<&MachineEstimate>) -> Vec<Warning> {
    let of_machine = machine.iter().flat_map(|of| &of.figures.warnings);
    estimate
        .warnings
        .iter()
        .chain(of_machine)
        .cloned()
        .collect()
}

fn write_regime(out: &mut Lines, estimate: &CaseEstimate) {
    let regime = &estimate.regime;
    out.heading("Lubrication regime (Moes' asymptotes of the central film, over the relative density at p_h)");
    let mut text = regime.regime.name().to_owned();
    if let Some(neighbour) = regime.neighbour {
        let _ = write!(text, ", close to {}", neighbour.name());
    }
    out.row("regime", text);
    let films = &regime.films;
    for (name, film) in [
        ("  isoviscous-rigid", films.isoviscous_rigid),
        ("  isoviscous-elastic", films.isoviscous_elastic),
        ("  piezoviscous-rigid", films.piezoviscous_rigid),
        ("  piezoviscous-elastic", films.piezoviscous_elastic),
    ] {
        out.row(name, length(film));
    }
}

/// Width of a film column.
const COLUMN: usize = 14;

fn write_formulas(out: &mut Lines, estimate: &CaseEstimate) {
    let cell = |film: Option<f64>| film.map_or_else(|| "–".to_owned(), length);
    let asymptotic = estimate.formulas_asymptotic.as_deref();
    let thinning = if estimate.newtonian_only {
        ", all for a Newtonian lubricant"
    } else {
        ""
    };
    out.heading(&format!("Published film formulas{thinning}"));
    let mut header = format!("{:<COLUMN$}{:<COLUMN$}", "central", "minimum");
    if asymptotic.is_some() {
        let _ = write!(header, "{:<COLUMN$}minimum, α*", "central, α*");
    }
    out.row("", header.trim_end());
    let row = |out: &mut Lines, f: &FormulaFilm, star: Option<&FormulaFilm>| {
        let mut text = format!("{:<COLUMN$}{:<COLUMN$}", cell(f.central), cell(f.minimum));
        if let Some(star) = star {
            let _ = write!(
                text,
                "{:<COLUMN$}{}",
                cell(star.central),
                cell(star.minimum)
            );
        }
        out.row(f.name, text.trim_end());
    };
    for f in &estimate.formulas {
        let star = asymptotic.and_then(|films| films.iter().find(|s| s.name == f.name));
        row(out, f, star);
    }
    for f in &estimate.formulas {
        out.note(f.source);
    }
}

fn write_film(out: &mut Lines, estimate: &CaseEstimate) {
    let film = &estimate.film;
    out.heading("The film");
    let by = |name: &str, h: f64| format!("{} ({name})", length(h));
    out.row(
        "central film used below",
        by(film.central_formula, film.central),
    );
    if let (Some(h), Some(name)) = (film.minimum, film.minimum_formula) {
        out.row("minimum film used below", by(name, h));
    } else {
        out.row(
            "minimum film",
            "not estimated: the formulas for it are for piezoviscous contacts",
        );
    }
    if let Some(lambda) = &estimate.lambda {
        let minimum = lambda
            .of_minimum
            .map_or_else(String::new, |l| format!("h_min/σ {}, ", digits(l, 3)));
        out.row(
            "lambda ratio",
            format!(
                "{minimum}h_c/σ {}: {}",
                digits(lambda.of_central, 3),
                lambda.separation.name()
            ),
        );
        if let Some(share) = lambda.asperity_load_share {
            let text = format!(
                "{} of the load, central film assumed everywhere",
                percent_or_power(share)
            );
            out.row("asperity load share", text);
        }
    }
    if let Some(force) = estimate.rolling_resistance {
        let unit = estimate.kind.load_unit();
        let text = format!("{} {unit} on each surface ({SOURCE})", digits(force, 4));
        out.row("rolling resistance", text);
    }
    let re = &estimate.reynolds;
    out.row(
        "Reynolds number ρ u_m h_c/μ",
        format!(
            "{} (ambient properties; critical {})",
            digits(re.reynolds, 3),
            digits(re.critical, 4)
        ),
    );
    let verdict = if re.inertia_matters {
        "inertia may matter"
    } else {
        "inertia is negligible"
    };
    out.row(
        "  times h_c/a",
        format!(
            "{}: {verdict} (bound {NEGLIGIBLE_INERTIA})",
            digits(re.reduced, 3)
        ),
    );
}

fn write_thermal(out: &mut Lines, estimate: &CaseEstimate) {
    let thermal = &estimate.thermal;
    out.heading("Heat of shear in the inlet (films above are isothermal)");
    if let Some(missing) = thermal.missing {
        out.row("no estimate", missing);
        return;
    }
    out.row(
        "β = -d ln μ/dT",
        format!("{} 1/K", digits(thermal.temperature_coefficient, 4)),
    );
    if let Some(loading) = thermal.loading {
        out.row("thermal loading L_T = μ β u_m²/k", digits(loading, 3));
    }
    for f in &thermal.factors {
        let name = format!("  thermal reduction factor, {}", f.name);
        out.row(&name, digits(f.factor, 4));
    }
    match &thermal.recommended {
        Some(heated) => {
            let range = match heated.in_range {
                true => String::new(),
                false => format!(
                    "; the formulas differ by {:.0} %: solve with [thermal]",
                    100.0 * heated.difference
                ),
            };
            let by = format!("recommended: {}{range}", heated.name);
            out.row(
                "central film with this heat",
                format!("{} ({by})", length(heated.central)),
            );
            if let Some(minimum) = heated.minimum {
                out.row("minimum film with this heat", length(minimum));
            }
        }
        None => out.row(
            "films with this heat",
            "beyond the recommended formula: `ertel solve` with [thermal] computes them",
        ),
    }
    for f in &thermal.factors {
        out.note(f.source);
    }
}

/// The JSON document in SI units.
///
/// # Errors
/// Those of the JSON writer.
pub fn estimate_json(
    case: &CaseEcho,
    estimate: &CaseEstimate,
    machine: Option<&MachineEstimate>,
) -> serde_json::Result<Value> {
    let mut units = units(case.contact.kind.is_line());
    for (key, unit) in [
        ("temperature_rise", "K"),
        ("isoviscous_rigid", "m"),
        ("isoviscous_elastic", "m"),
        ("piezoviscous_rigid", "m"),
        ("piezoviscous_elastic", "m"),
        ("temperature_coefficient", "1/K"),
    ] {
        units[key] = unit.into();
    }
    if let (Some(keys), Some(of)) = (units.as_object_mut(), machine) {
        keys.extend(estimate_units(of));
    }
    // Mesh and solver settings are not used.
    let mut si = serde_json::to_value(case)?;
    if let Some(keys) = si.as_object_mut() {
        keys.remove("mesh");
        keys.remove("solver");
    }
    let mut document = json!({
        "format": ESTIMATE_FORMAT,
        "format_version": FORMAT_VERSION,
        "ertel_version": env!("CARGO_PKG_VERSION"),
        "title": case.title,
        "case": { "given": case.given, "si": si },
        "units": units,
    });
    if let (Some(keys), Value::Object(figures)) =
        (document.as_object_mut(), serde_json::to_value(estimate)?)
    {
        keys.extend(figures);
    }
    if let (Some(keys), Some(of)) = (document.as_object_mut(), machine) {
        keys.extend(estimate_values(case, of));
        keys.insert(
            "warnings".to_owned(),
            serde_json::to_value(warnings(estimate, machine))?,
        );
    }
    Ok(document)
}
