//! Checks of the effects that a model neglects, and their line in the report.

use super::heat::{LARGEST_RISE, SMALLEST_FACTOR, inlet_heat, rise};
use super::inertia::{FilmReynolds, film_reynolds, squeeze_reynolds};
use crate::case::Case;
use crate::solution::{Neglected, NeglectedHeat};
use crate::warning::{Warning, WarningKind};
use crate::words::digits;

/// Figures of a contact from which neglected effects are estimated.
pub struct Known {
    /// Central film, m.
    pub film_central: f64,
    /// Minimum film, m.
    pub film_minimum: f64,
    /// Friction power, W (W/m of a line); zero where none is known.
    pub friction_power: f64,
}

/// Reynolds numbers of the film of a case; of surfaces at rest those of the squeeze.
pub fn reynolds(case: &Case, film_central: f64) -> FilmReynolds {
    let (density, viscosity) = (
        case.lubricant.ambient_density(),
        case.lubricant.ambient_viscosity(),
    );
    match squeeze(case) {
        Some(squeeze) => {
            let radius = case.contact.along_motion().radius;
            squeeze_reynolds(density, squeeze, viscosity, radius)
        }
        None => film_reynolds(
            density,
            case.motion.entrainment_speed,
            film_central,
            viscosity,
            case.hertz().half_width,
        ),
    }
}

/// Velocity of approach (m/s) and gap (m) at the start of bodies whose surfaces are at rest.
pub fn squeeze(case: &Case) -> Option<[f64; 2]> {
    let transient = case.transient.as_ref()?;
    transient.squeeze(case)
}

/// Estimates of neglected effects.
pub fn neglected(case: &Case, known: &Known) -> Neglected {
    let heat = case.thermal().is_none().then(|| {
        let inlet = inlet_heat(case);
        let rise = rise(case, known.friction_power, known.film_central);
        NeglectedHeat {
            film_factor: inlet.factor(case),
            film_factor_missing: inlet.loading.err(),
            temperature_rise: rise.mean,
            is_lower_bound: rise.is_lower_bound,
        }
    });
    Neglected {
        heat,
        inertia: reynolds(case, known.film_central).reduced,
        plasticity: case.hertz().pressure / case.pressure_limit().0,
        lambda: case.roughness.map(|sigma| known.film_minimum / sigma),
        has_asperities: case.asperities.is_some(),
    }
}

/// Warnings where neglected effects matter.
pub fn warnings(case: &Case, film_central: f64, neglected: &Neglected) -> Vec<Warning> {
    // Without motion there is no inlet to heat.
    let heat = match squeeze(case) {
        None => neglected.heat.as_ref().and_then(heat_warning),
        Some(_) => None,
    };
    let reynolds = reynolds(case, film_central);
    let inertia = inertia_warning(&reynolds);
    heat.into_iter().chain(inertia).collect()
}

/// Warns if an isothermal contact generates enough heat to change films or friction.
pub fn heat_warning(heat: &NeglectedHeat) -> Option<Warning> {
    let factor = heat.film_factor.unwrap_or(1.0);
    let mut parts = Vec::new();
    if factor < SMALLEST_FACTOR {
        parts.push(format!(
            "shear in the inlet thins the film by {} %",
            digits(100.0 * (1.0 - factor), 2)
        ));
    }
    if heat.temperature_rise > LARGEST_RISE {
        let more = if heat.is_lower_bound { " or more" } else { "" };
        parts.push(format!(
            "friction heats the film by {} K{more}; losses are too high",
            digits(heat.temperature_rise, 2)
        ));
    }
    if parts.is_empty() {
        return None;
    }
    let text = format!("isothermal, yet {}; add [thermal]", parts.join(" and "));
    let excess = (SMALLEST_FACTOR / factor).max(heat.temperature_rise / LARGEST_RISE);
    Some(Warning::beyond(WarningKind::HeatLeftOut, excess, text))
}

/// The rise in the line of a report.
fn about(heat: &NeglectedHeat) -> &'static str {
    match heat.is_lower_bound {
        true => "at least about",
        false => "about",
    }
}

/// Warns if inertia or turbulence may count.
pub fn inertia_warning(reynolds: &FilmReynolds) -> Option<Warning> {
    let text = format!(
        "inertia may matter (Reynolds number of the film {:.3e}, reduced {:.3e}): Reynolds' equation has none",
        reynolds.reynolds, reynolds.reduced
    );
    (reynolds.inertia_matters)
        .then(|| Warning::beyond(WarningKind::Inertia, reynolds.reduced, text))
}

/// The line of a report.
pub fn words(neglected: &Neglected) -> String {
    let mut parts = Vec::new();
    if let Some(heat) = &neglected.heat {
        let film = match (heat.film_factor, heat.film_factor_missing) {
            (Some(factor), _) => format!(
                "inlet heating thins the film by about {} %",
                digits(100.0 * (1.0 - factor), 2)
            ),
            (None, Some(reason)) => format!("effect on the film unknown: {reason}"),
            (None, None) => "effect on the film beyond the formula".to_owned(),
        };
        let rise = match heat.temperature_rise > 0.0 {
            true => format!(
                "; friction warms the film by {} {} K",
                about(heat),
                digits(heat.temperature_rise, 2)
            ),
            false => String::new(),
        };
        parts.push(format!("heat ({film}{rise})"));
    }
    parts.push(format!(
        "inertia ({} of viscous forces)",
        percent(neglected.inertia)
    ));
    parts.push(format!(
        "plasticity (p_h is {} of the limit of the bodies)",
        digits(neglected.plasticity, 2)
    ));
    parts.push(match neglected.lambda {
        Some(_) if neglected.has_asperities => {
            "wear but that of [wear], flow factors but those of `flow`".to_owned()
        }
        Some(lambda) => format!(
            "roughness in the film (h_min is {} times the rms height)",
            digits(lambda, 3)
        ),
        None => "roughness (none given)".to_owned(),
    });
    parts.join("; ")
}

/// A share as per cent; none below 0.01 %.
fn percent(share: f64) -> String {
    match share < 1e-4 {
        true => "below 0.01 %".to_owned(),
        false => format!("{} %", digits(100.0 * share, 2)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn heat(film_factor: f64, temperature_rise: f64) -> NeglectedHeat {
        NeglectedHeat {
            film_factor: Some(film_factor),
            temperature_rise,
            ..NeglectedHeat::default()
        }
    }

    /// Both sides of both thresholds.
    #[test]
    fn heat_at_the_limits() {
        assert_eq!(heat_warning(&heat(0.901, 9.99)), None);
        let thin = heat_warning(&heat(0.889, 9.99)).unwrap();
        assert!(thin.contains("thins the film by 11 %"), "{thin}");
        assert!(!thin.contains("friction heats"), "{thin}");
        let warm = heat_warning(&heat(0.901, 10.1)).unwrap();
        assert!(warm.contains("friction heats the film by 10 K"), "{warm}");
        assert!(!warm.contains("thins the film"), "{warm}");
    }

    #[test]
    fn the_line() {
        let known = Neglected {
            heat: Some(heat(0.97, 2.0)),
            inertia: 7e-6,
            plasticity: 0.2386,
            lambda: None,
            has_asperities: false,
        };
        assert_eq!(
            words(&known),
            "heat (inlet heating thins the film by about 3 %; friction warms the film by about 2 K); inertia (below 0.01 % of viscous \
             forces); plasticity (p_h is 0.24 of the limit of the bodies); roughness (none given)"
        );
    }
}
