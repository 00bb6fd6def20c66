//! Reynolds number of the film.

use serde::Serialize;

/// Reynolds number up to which flow between parallel plates is laminar; Habchi 2008, section 6.1, has 2000 to 2500.
pub const CRITICAL_REYNOLDS: f64 = 2000.0;

/// Share of the viscous forces that inertia may reach before it counts.
pub const NEGLIGIBLE_INERTIA: f64 = 0.1;

/// Reynolds numbers of the film, both on its safe side: ambient viscosity, where the film has far more.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct FilmReynolds {
    /// Re = ρ u_m h/μ (Habchi 2008, eq. 6.1): the flow is laminar below the critical one.
    pub reynolds: f64,
    /// The same from which the flow may be turbulent.
    pub critical: f64,
    /// Re h/a: inertia over viscous forces in a film far thinner than long (order of magnitude).
    pub reduced: f64,
    /// Whether the flow may be turbulent, or inertia exceeds a tenth of the viscous forces.
    pub inertia_matters: bool,
}

/// Reynolds numbers for ambient density ρ (kg/m³), entrainment speed u_m (m/s), central film h (m), ambient viscosity μ
/// (Pa·s) and Hertz half-width a (m).
pub fn film_reynolds(
    density: f64,
    entrainment_speed: f64,
    film: f64,
    viscosity: f64,
    half_width: f64,
) -> FilmReynolds {
    let reynolds = density * entrainment_speed * film / viscosity;
    let reduced = reynolds * film / half_width;
    FilmReynolds {
        reynolds,
        critical: CRITICAL_REYNOLDS,
        reduced,
        inertia_matters: reynolds > CRITICAL_REYNOLDS || reduced > NEGLIGIBLE_INERTIA,
    }
}

/// The same of bodies that come near to each other at a velocity V (m/s), a gap h (m) apart, for density ρ (kg/m³), viscosity μ (Pa·s) and radius R (m): oil leaves at
/// u = V r/h, so that Re = ρ V r/μ at r = √(2Rh), where the gap has doubled, and Re h/r = ρ V h/μ.
pub fn squeeze_reynolds(
    density: f64,
    [velocity, gap]: [f64; 2],
    viscosity: f64,
    radius: f64,
) -> FilmReynolds {
    let place = (2.0 * radius * gap).sqrt();
    film_reynolds(density, velocity * place / gap, gap, viscosity, place)
}
