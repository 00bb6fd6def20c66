//! Density and viscosity of the film as the dimensionless equations need them.

use ertel_rheology::density::DensityLaw;
use ertel_rheology::viscosity::ViscosityLaw;
use num_dual::{Dual2_64, DualNum};

use crate::contact::Scales;
use crate::forms::reynolds::PointFluid;

/// Isothermal fluid in the scales of a contact.
///
/// Below ambient pressure (P < 0, an artefact of the cavitation penalty) the properties stay at
/// their ambient values.
#[derive(Clone, Debug)]
pub struct FilmFluid {
    density: DensityLaw,
    viscosity: ViscosityLaw,
    /// K.
    temperature: f64,
    /// p_h, Pa.
    pressure_scale: f64,
    /// ρ_R, kg/m³.
    density_scale: f64,
    /// ln(μ_R / Pa·s).
    ln_viscosity_scale: f64,
}

impl FilmFluid {
    /// Fluid with the given laws at a temperature in K.
    pub fn new(
        density: &DensityLaw,
        viscosity: &ViscosityLaw,
        temperature: f64,
        scales: &Scales,
    ) -> FilmFluid {
        FilmFluid {
            density: density.clone(),
            viscosity: viscosity.clone(),
            temperature,
            pressure_scale: scales.pressure,
            density_scale: scales.density,
            ln_viscosity_scale: scales.viscosity.ln(),
        }
    }

    /// ρ̄, μ̄ and their first two derivatives by P, exact.
    pub fn at(&self, pressure: f64) -> PointFluid {
        let ambient = pressure <= 0.0;
        let scale = self.pressure_scale;
        let p = Dual2_64::from_re(pressure.max(0.0) * scale).derivative();
        let t = Dual2_64::from_re(self.temperature);
        let rho = self.density.density(p, t) / self.density_scale;
        let mu = (self.viscosity.ln_viscosity(p, t) - self.ln_viscosity_scale).exp();
        let by_p = |v: Dual2_64| {
            if ambient {
                [v.re, 0.0, 0.0]
            } else {
                [v.re, v.v1 * scale, v.v2 * scale * scale]
            }
        };
        PointFluid {
            density: by_p(rho),
            viscosity: by_p(mu),
        }
    }
}
