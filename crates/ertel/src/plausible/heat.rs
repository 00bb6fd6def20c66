//! Heat that an isothermal contact neglects.

use std::f64::consts::PI;

use num_dual::first_derivative;

use crate::case::{Body, Case};
use crate::contact::Hertz;
use crate::layers::HeatedBody;
use crate::reference::thermal::{ThermalReduction, thermal_loading};

/// Mean rise of the film, K, from which isothermal friction is doubted: oils lose 3 to 5 % of their viscosity per kelvin, so that a third
/// of it is lost.
pub const LARGEST_RISE: f64 = 10.0;

/// Factor of the film by the heat of the inlet below which isothermal films are doubted: formulas for isothermal films are no closer.
pub const SMALLEST_FACTOR: f64 = 0.9;

/// Effusivity √(kρc) of steel, W√s/(m²K): 46 W/(m·K), 7850 kg/m³, 470 J/(kg·K) (Habchi 2008, tables 4.1, 5.1 and 6.1). Few bodies take
/// up more heat.
const STEEL: f64 = 13_027.0;

/// Heating of the inlet by the formula that is recommended.
#[derive(Clone, Debug, PartialEq)]
pub struct InletHeat {
    /// β = −d ln μ/dT at ambient pressure, 1/K.
    pub temperature_coefficient: f64,
    /// L_T = μ₀ β u_m²/k, or why there is none.
    pub loading: Result<f64, &'static str>,
}

/// Heating of the inlet of a case.
pub fn inlet_heat(case: &Case) -> InletHeat {
    let lubricant = &case.lubricant;
    let logarithm = |t| lubricant.viscosity.ln_viscosity(0.0.into(), t);
    // no −0 in reports
    let beta = 0.0 - first_derivative(logarithm, lubricant.temperature).1;
    let loading = if beta.is_nan() || beta <= 0.0 {
        Err("the viscosity law does not fall with temperature")
    } else if let Some(conductivity) = lubricant
        .ambient_conductivity()
        .or(lubricant.typical_conductivity)
    {
        let viscosity = lubricant.ambient_viscosity();
        Ok(thermal_loading(
            viscosity,
            beta,
            case.motion.entrainment_speed,
            conductivity,
        ))
    } else {
        Err("the lubricant has no thermal_conductivity")
    };
    InletHeat {
        temperature_coefficient: beta,
        loading,
    }
}

impl InletHeat {
    /// The recommended factor; `None` where it gives none.
    pub fn factor(&self, case: &Case) -> Option<f64> {
        let pressure_over_modulus = case.hertz().pressure / case.reduced_modulus();
        let slide_to_roll_ratio = case.motion.sliding_at_centre();
        let loading = self.loading.ok()?;
        ThermalReduction::RECOMMENDED.factor(loading, pressure_over_modulus, slide_to_roll_ratio)
    }
}

/// Mean rise of temperature of a film in its contact, K.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rise {
    /// Of surfaces and film.
    pub mean: f64,
    /// Whether it is a lower bound.
    pub is_lower_bound: bool,
}

/// Effect of frictional heat: both bodies pass below a band of heat that they share, and the film is warmer still.
///
/// ```text
///   ΔT = (4/3) q √(2a/π)/(e₁√u₁ + e₂√u₂) + q h/(12 k),   q = P/A,  e = √(kρc)
/// ```
/// The first part is the mean of a uniform band on half-spaces that move fast, equal for both (Blok; Carslaw and Jaeger 1959, section 2.9),
/// the second that of a film in which heat arises all over. `power` in W (W/m of a line), `film` the central film in m; the surfaces
/// move at |u|, m/s.
pub fn rise(case: &Case, power: f64, film: f64) -> Rise {
    let along = Hertz::new(&case.contact.along_motion(), case.reduced_modulus());
    let flux = power.abs() / case.hertz().area(&case.contact);
    let temperature = case.lubricant.temperature;
    let speeds = [case.motion.body_1_speed(), case.motion.body_2_speed()];
    let width = 2.0 * along.half_width;
    let own = [0, 1].map(|b: usize| {
        let body = [&case.body_1, &case.body_2][b];
        uptake(body, temperature, speeds[b].abs(), width)
    });
    let steel = speeds.map(|u| STEEL * u.abs().sqrt());
    let taken: f64 = own
        .iter()
        .zip(steel)
        .map(|(own, steel)| own.unwrap_or(steel))
        .sum();
    let surfaces = 4.0 / 3.0 * flux * (2.0 * along.half_width / PI).sqrt() / taken;
    let conductivity = (case.lubricant.thermal_conductivity.as_ref())
        .map(|law| law.conductivity(case.hertz().pressure, temperature));
    let within = conductivity.map_or(0.0, |k| flux * film / (12.0 * k));
    Rise {
        mean: surfaces + within,
        is_lower_bound: own.iter().any(Option::is_none) || conductivity.is_none(),
    }
}

/// e√u of a body that passes the band of a width, m, at a speed, m/s, if its data are known; with layers √w/Z of heat that grows over the passage, s = u/w.
fn uptake(body: &Body, temperature: f64, speed: f64, width: f64) -> Option<f64> {
    let mut missing = Vec::new();
    let heat = body.heat(["body"; 2], temperature, &mut missing)?;
    let material = heat.constants();
    if heat.layers.is_empty() || !missing.is_empty() {
        return Some((material.conductivity * material.capacity).sqrt() * speed.sqrt());
    }
    let body = HeatedBody::new(&heat.heat_layers(), material, DEEP);
    let rise = body.impedance(0.0.into(), (speed / width).into());
    Some(width.sqrt() / rise.re)
}

/// Depth that no heat reaches in a passage, m.
const DEEP: f64 = 1.0;
