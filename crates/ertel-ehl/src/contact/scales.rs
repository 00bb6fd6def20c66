//! Scales between SI units and the dimensionless variables of the solver.

use serde::Serialize;

use super::{Contact, Hertz, Motion, Shape};

/// Scales of the dimensionless variables (Habchi 2008, eq. 2.28):
/// X = x/a, P = p/p_h, H = hR/a², ρ̄ = ρ/ρ_R, μ̄ = μ/μ_R.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Scales {
    /// Length a, m (Hertz half-width; of ellipses the semi-axis along x).
    pub length: f64,
    /// Pressure p_h, Pa.
    pub pressure: f64,
    /// Film thickness a²/R, m.
    pub film: f64,
    /// Viscosity μ_R at ambient pressure and the case's temperature, Pa·s.
    pub viscosity: f64,
    /// Density ρ_R at ambient pressure and the case's temperature, kg/m³.
    pub density: f64,
    /// λ = 12 u_m μ_R R²/(a³ p_h); the Reynolds diffusion is ρ̄H³/(μ̄λ) (Habchi 2008, eq. 2.29).
    pub lambda: f64,
    /// Stress scale of the elastic problem, R p_h/a, Pa: a body of modulus E has the
    /// dimensionless modulus E/(R p_h/a) (Habchi 2008, eq. 3.6).
    pub elastic_stress: f64,
    /// ∫P over the part that is solved: π/2 of a line, π/3 of half a circle.
    pub load: f64,
}

impl Scales {
    /// Scales of a contact of some shape with ambient viscosity (Pa·s) and density (kg/m³).
    pub fn new(
        (contact, hertz, shape): (&Contact, &Hertz, &Shape),
        motion: &Motion,
        viscosity: f64,
        density: f64,
    ) -> Scales {
        let (a, p_h, r) = (hertz.half_width, hertz.pressure, contact.radius);
        Scales {
            length: a,
            pressure: p_h,
            film: a * a / r,
            viscosity,
            density,
            lambda: 12.0 * motion.entrainment_speed * viscosity * r * r / (a * a * a * p_h),
            elastic_stress: r * p_h / a,
            load: shape.load(),
        }
    }

    /// Entrainment speed u_m, m/s.
    pub fn entrainment_speed(&self) -> f64 {
        let radius = self.length * self.length / self.film;
        self.lambda * self.length.powi(3) * self.pressure
            / (12.0 * self.viscosity * radius * radius)
    }

    /// Factor from an integral over the solved part of the contact area, in half-widths squared or half-widths,
    /// to one over all of it, m² or m.
    pub fn area(&self, shape: &Shape) -> f64 {
        let part = match shape.is_line() {
            true => self.length,
            false => self.length * self.length,
        };
        shape.symmetry.multiplicity() * part
    }
}
