//! A fitted law as an entry of the database.

use std::fmt::Write;

use ertel_quantity::COVERAGE;
use ertel_rheology::density::TaitVolume;
use ertel_rheology::viscosity::{Doolittle, PressureLaw, Walther};
use ertel_rheology::{DensityLaw, ViscosityLaw};

use super::law::{written, written_to};
use super::walther::AMBIENT;
use super::{Data, Fit, FittedConstant, FittedLaw, LawName, Residual, density};
use crate::words::digits;

/// Head of an entry.
#[derive(Clone, Debug, PartialEq)]
pub struct Heading {
    /// Title of the fluid.
    pub title: String,
    /// Where the data come from: a key of the bibliography, or words.
    pub source: String,
}

/// TOML text of the fitted law in the format of the database: head, range, the law with its constants, and in notes the
/// scatter and the intervals.
///
/// An entry for the viscosity is complete without density; that of Walther's law has the density that it was fitted with. One for the density is completed by a viscosity.
pub fn entry(fit: &Fit, data: &Data, heading: &Heading) -> String {
    let lines = [
        head(fit, data, heading),
        validity(fit, data),
        law(fit, data),
    ];
    lines.concat().join("\n") + "\n"
}

/// Title, source and notes.
fn head(fit: &Fit, data: &Data, heading: &Heading) -> Vec<String> {
    let residual = match fit.residual {
        Residual::Relative => "relative",
        Residual::Absolute => "absolute",
    };
    let locator = format!(
        "fit of the law {} to {} states of {}, least squares of {residual} deviations",
        fit.name.name(),
        data.states.len(),
        data.file
    );
    let (_, worst) = fit.worst();
    let mut notes = vec![
        format!(
            "The {} fits within {} % (rms), {} % at most.",
            data.property.name(),
            digits(100.0 * fit.rms(), 2),
            digits(100.0 * worst.abs(), 2)
        ),
        intervals(fit),
    ];
    if !has_narrow_intervals(fit) {
        let text = "The intervals are too wide, or none, for an uncertainty of films and friction.";
        notes.push(text.to_owned());
    }
    if is_ambient(fit, data) {
        let text = "All states are at ambient pressure: alpha was given, and the range of pressures is not known.";
        notes.push(text.to_owned());
    }
    notes.extend(
        fit.warnings
            .iter()
            .map(|warning| format!("Warning: {warning}.")),
    );
    let mut lines = vec![
        format!("title = {}", quoted(&heading.title)),
        format!("source = {}", quoted(&heading.source)),
        format!("locator = {}", quoted(&locator)),
        "status = \"computed\"".to_owned(),
        "notes = [".to_owned(),
    ];
    lines.extend(notes.iter().map(|note| format!("    {},", quoted(note))));
    lines.push("]\n".to_owned());
    lines
}

/// Reference temperature and range of the states.
fn validity(fit: &Fit, data: &Data) -> Vec<String> {
    let mut lines = Vec::new();
    if let Some(t_r) = fit.reference_temperature {
        let t_r = written(t_r, "K");
        lines.push(format!("reference_temperature = \"{t_r}\"\n"));
    }
    let [p_low, p_high] = data.pressure_range();
    let [t_low, t_high] = data.temperature_range();
    lines.push("[validity]".to_owned());
    if !is_ambient(fit, data) {
        lines.push(format!(
            "pressure = [\"{}\", \"{}\"]",
            // Data taken at ambient pressure begin there
            written(p_low.max(0.0), "MPa"),
            written(p_high, "MPa")
        ));
    }
    lines.push(format!(
        "temperature = [\"{}\", \"{}\"]",
        written(t_low, "K"),
        written(t_high, "K")
    ));
    let source = format!("range of the states in {}", data.file);
    lines.push(format!("source = {}\n", quoted(&source)));
    lines
}

/// The law with its constants and their correlations.
fn law(fit: &Fit, data: &Data) -> Vec<String> {
    let property = data.property.name();
    let mut lines = vec![
        format!("[{property}]"),
        format!("law = \"{}\"", fit.name.name()),
    ];
    let uncertain = has_narrow_intervals(fit);
    for constant in &fit.constants {
        let text = match constant.standard.filter(|_| uncertain) {
            Some(standard) => format!(
                "\"{} ± {}\"",
                written_to(n_digits(fit, constant), constant.value, constant.unit),
                written(COVERAGE * standard, constant.unit)
            ),
            None => value(n_digits(fit, constant), constant.value, constant.unit),
        };
        lines.push(format!("{} = {text}", constant.key));
    }
    if let Some(t_r) = law_reference(fit) {
        let t_r = written(t_r, "K");
        lines.push(format!("reference_temperature = \"{t_r}\""));
    }
    if let FittedLaw::Viscosity(ViscosityLaw::Doolittle(Doolittle { volume, .. })) = &fit.law {
        lines.push(format!("equation_of_state = {}", equation(volume)));
    }
    let walther = match &fit.law {
        FittedLaw::Viscosity(ViscosityLaw::Walther(law)) => Some(law),
        _ => None,
    };
    lines.extend(walther.map(|law| format!("pressure = \"{}\"", pressure_law(law))));
    let known = fit.correlations.iter().filter(|_| uncertain);
    lines.extend(known.map(|([one, other], coefficient)| {
        let [of, with] = [one, other].map(|i| fit.constants[*i].key);
        format!(
            "\n[[correlation]]\nof = \"{property}.{of}\"\nwith = \"{property}.{with}\"\ncoefficient = {coefficient:.9}"
        )
    }));
    lines.extend(walther.map(|law| format!("\n{}", density::section(&law.density).trim_end())));
    lines
}

/// Whether the states say nothing of pressure, which is then that of a coefficient that the user gives.
fn is_ambient(fit: &Fit, data: &Data) -> bool {
    fit.name == LawName::Walther && data.pressure_range()[1] < AMBIENT
}

/// Digits of a constant: A and B of Walther's equation are two exponents above the viscosity.
fn n_digits(fit: &Fit, constant: &FittedConstant) -> usize {
    match (fit.name, constant.key) {
        (LawName::Walther, "a" | "b") => 10,
        _ => 6,
    }
}

/// The name of the growth with pressure.
fn pressure_law(law: &Walther) -> &'static str {
    let names = PressureLaw::NAMES.iter();
    let mut own = names.filter(|(_, pressure)| *pressure == law.pressure);
    own.next().map_or("roelands", |(name, _)| name)
}

/// Whether all intervals are so narrow that the constants keep their sign within four standard deviations: then the entry hands their
/// uncertainty on. Some of them alone would be wrong, as what they are correlated with would be missing.
fn has_narrow_intervals(fit: &Fit) -> bool {
    let fitted = fit
        .constants
        .iter()
        .filter_map(|c| Some((c.value, c.standard?)));
    let mut widths = fitted.map(|(value, standard)| standard / value.abs());
    widths.all(|width| width > 0.0 && width < WIDEST)
}

/// Standard deviation, over the size of a constant, from which on its uncertainty is not handed on.
const WIDEST: f64 = 0.2;

/// Reference temperature among the constants of the law.
fn law_reference(fit: &Fit) -> Option<f64> {
    match &fit.law {
        FittedLaw::Viscosity(law) => law.reference_temperature(),
        FittedLaw::Density(DensityLaw::Tait(law)) => {
            Some(law.volume.thermal.as_ref()?.reference_temperature)
        }
        FittedLaw::Density(DensityLaw::DowsonHigginson(law)) => {
            Some(law.thermal.as_ref()?.reference_temperature)
        }
        FittedLaw::Density(_) => None,
    }
}

/// The intervals in a sentence.
fn intervals(fit: &Fit) -> String {
    let mut text = format!("{} % intervals:", digits(100.0 * fit.confidence, 4));
    for (i, constant) in fit.constants.iter().enumerate() {
        text += if i > 0 { ", " } else { " " };
        let _ = match constant.interval {
            Some([low, high]) => write!(
                text,
                "{} {} to {}",
                constant.key,
                written(low, constant.unit),
                written(high, constant.unit)
            ),
            None => write!(text, "{} fixed", constant.key),
        };
    }
    text + "."
}

fn value(n_digits: usize, value: f64, unit: &str) -> String {
    let text = written_to(n_digits, value, unit);
    if unit.is_empty() {
        text
    } else {
        format!("\"{text}\"")
    }
}

fn equation(volume: &TaitVolume) -> String {
    let mut text = format!(
        "{{ k_0r = \"{}\", k_0r_prime = {}",
        written(volume.bulk_modulus, "GPa"),
        written(volume.bulk_modulus_slope, "")
    );
    if let Some(thermal) = &volume.thermal {
        let _ = write!(
            text,
            ", reference_temperature = \"{}\", beta_k = \"{}\", beta_k_prime = \"{}\", a_v = \"{}\"",
            written(thermal.reference_temperature, "K"),
            written(thermal.bulk_modulus_coefficient, "1/K"),
            written(thermal.bulk_modulus_slope_coefficient, "1/K"),
            written(thermal.expansivity, "1/K")
        );
    }
    text + " }"
}

/// A TOML string.
fn quoted(text: &str) -> String {
    let mut quoted = String::from("\"");
    for c in text.chars() {
        match c {
            '"' => quoted.push_str("\\\""),
            '\\' => quoted.push_str("\\\\"),
            c if c.is_control() => {
                let _ = write!(quoted, "\\u{:04X}", c as u32);
            }
            c => quoted.push(c),
        }
    }
    quoted.push('"');
    quoted
}
