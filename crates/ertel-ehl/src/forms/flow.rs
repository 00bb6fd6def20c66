//! The flow that the pressure drives through the film, dimensionless, and its divergence.
//!
//! ```text
//!   Newtonian:            Q = ε∇P,  ε = ρ̄H³/(μ̄λ)
//!   generalized:          Q = 12ρ̄H²/(μ̄λ) q(G, Ω, P),  G = H∇P,  Ω = σμ̄/H      q from the closure
//!   sliding:              σ = λ Δu/(12 u_m) = σ_0 + ς(−Y, X)                      ς of the spin
//! ```
//! Mass flows by ρ̄H ū − Q, ū the mean velocity of the surfaces, e_x without spin. A generalized-Newtonian film has one viscosity at each height; its Q,
//! from the stress across the film, contains what sliding does to the flow (Habchi 2008, eqs. 4.9 and
//! 4.11, where the same is written with integrals of 1/η). With q = G/12 it is the Newtonian one. Where the
//! temperature varies, ρ̄ is the mean over the film and μ̄ the geometric mean of the viscosity (see [`crate::film::thermal`]).

use crate::contact::Planar;
use crate::film::closure::N_DEMANDS;
use crate::film::thermal::Mean;
use crate::film::thermal_closure::ThermalClosure;
use crate::film::{Closure, PointFluid};
use crate::forms::dual::Number;

/// Variables of the equation at a point; derivatives are taken by these numbers.
#[derive(Clone, Copy, Debug)]
pub struct PointState<D> {
    /// Pressure P.
    pub pressure: D,
    /// ∇P.
    pub pressure_gradient: [D; 2],
    /// P_xx, P_xy, P_yy inside the element; where only their sum counts, P_xx may stand for ΔP.
    pub pressure_curvature: [D; 3],
    /// Film thickness H.
    pub film: D,
    /// ∇H.
    pub film_gradient: [D; 2],
    /// κP, the part of P that the deflection cannot represent.
    pub pressure_unresolved: D,
}

/// Density and low-shear viscosity around a point, exact to first order in P.
#[derive(Clone, Copy, Debug)]
pub struct Properties<D> {
    /// ρ̄.
    pub density: D,
    /// ρ̄'.
    pub density_slope: D,
    /// μ̄.
    pub viscosity: D,
    /// μ̄'.
    pub viscosity_slope: D,
}

impl<D: Number> Properties<D> {
    /// Properties at the pressure of a point.
    #[inline(always)]
    pub fn around(pressure: D, fluid: &PointFluid) -> Properties<D> {
        let dp = pressure - pressure.re();
        Properties {
            density: dp * fluid.density[1] + fluid.density[0],
            density_slope: dp * fluid.density[2] + fluid.density[1],
            viscosity: dp * fluid.viscosity[1] + fluid.viscosity[0],
            viscosity_slope: dp * fluid.viscosity[2] + fluid.viscosity[1],
        }
    }

    /// (ln ρ̄/μ̄)'.
    #[inline(always)]
    pub fn log_slope(&self) -> D {
        self.density_slope / self.density - self.viscosity_slope / self.viscosity
    }
}

/// Pressure-driven flow at a point.
#[derive(Clone, Copy, Debug)]
pub struct Flow<D> {
    /// Q.
    pub flux: [D; 2],
    /// ∇·Q, inside the element.
    pub divergence: D,
    /// ∂Q_x/∂P_x, by which the stabilisation measures diffusion.
    pub diffusivity: D,
    /// H ∇ρ̄ at a fixed pressure, where the temperature changes along the film.
    pub drift: [D; 2],
}

/// Flow of a Newtonian film.
#[inline(always)]
pub fn newtonian<D: Number>(s: &PointState<D>, m: &Properties<D>, lambda: f64) -> Flow<D> {
    let [px, py] = s.pressure_gradient;
    let [hx, hy] = s.film_gradient;
    let [pxx, _, pyy] = s.pressure_curvature;
    let h = s.film;
    let epsilon = m.density * h * h * h / (m.viscosity * lambda);
    // ∇ε = ε[(ρ'/ρ − μ'/μ)∇P + 3∇H/H]
    let along = m.log_slope() * (px * px + py * py) + (hx * px + hy * py) * 3.0 / h;
    Flow {
        flux: [epsilon * px, epsilon * py],
        divergence: epsilon * (along + pxx + pyy),
        diffusivity: epsilon,
        drift: [D::from(0.0); 2],
    }
}

/// Stress G = H∇P that the pressure puts on the film, in units of a p_h/R.
#[inline(always)]
pub fn pressure_stress<D: Number>(s: &PointState<D>) -> [D; 2] {
    s.pressure_gradient.map(|g| s.film * g)
}

/// Ω = σμ̄/H: mean Newtonian stress of the sliding, likewise.
#[inline(always)]
pub fn sliding_stress<D: Number>(s: &PointState<D>, m: &Properties<D>, slide: [f64; 2]) -> [D; 2] {
    slide.map(|slide| m.viscosity * slide / s.film)
}

/// Sliding of the surfaces at a point.
#[derive(Clone, Copy, Debug)]
pub struct PointSliding {
    /// σ.
    pub value: [f64; 2],
    /// ς, by which ∂σ/∂X = ς(0, 1) and ∂σ/∂Y = ς(−1, 0).
    pub spin: f64,
}

impl PointSliding {
    /// Of a field at a place.
    #[inline(always)]
    pub fn new(slide: &Planar, place: [f64; 2]) -> PointSliding {
        PointSliding {
            value: slide.at(place),
            spin: slide.spin,
        }
    }
}

/// Flow of a generalized-Newtonian film; `closure` holds at the values of the point.
#[inline(always)]
pub fn generalized<D: Number>(
    s: &PointState<D>,
    m: &Properties<D>,
    lambda: f64,
    slide: &PointSliding,
    closure: &Closure,
) -> Flow<D> {
    let (h, grad_p, grad_h) = (s.film, s.pressure_gradient, s.film_gradient);
    let omega = sliding_stress(s, m, slide.value);
    let changes = changes(s, omega);
    let expand = |value: f64, slopes: &[f64; N_DEMANDS]| expanded(value, slopes, &changes);
    let factor = m.density * h * h * 12.0 / (m.viscosity * lambda);
    let mut flow = Flow {
        flux: [D::from(0.0); 2],
        divergence: D::from(0.0),
        diffusivity: D::from(0.0),
        drift: [D::from(0.0); 2],
    };
    let [pxx, pxy, pyy] = s.pressure_curvature;
    let curvature = [[pxx, pxy], [pxy, pyy]];
    let viscosity_slope = m.viscosity_slope / m.viscosity;
    for i in 0..2 {
        let q = expand(closure.flow[i], &closure.slopes[i]);
        let [by_gx, by_gy, by_omega, by_omega_y, by_p] =
            [0, 1, 2, 3, 4].map(|y| expand(closure.slopes[i][y], &closure.curvatures[i][y]));
        // ∂_iG = ∂_iH ∇P + H ∂_i∇P,  ∂_iΩ = Ω(μ'/μ ∂_iP − ∂_iH/H) + μ/H ∂_iσ
        let moved = |j: usize| grad_h[i] * grad_p[j] + h * curvature[i][j];
        flow.divergence += q * (m.log_slope() * grad_p[i] + grad_h[i] * 2.0 / h)
            + by_gx * moved(0)
            + by_gy * moved(1)
            + (by_omega * omega[0] + by_omega_y * omega[1])
                * (viscosity_slope * grad_p[i] - grad_h[i] / h)
            + by_p * grad_p[i];
        if slide.spin != 0.0 {
            let turned = [by_omega_y, -by_omega][i];
            flow.divergence += turned * (m.viscosity * slide.spin / h);
        }
        flow.flux[i] = factor * q;
        if i == 0 {
            flow.diffusivity = factor * h * by_gx;
        }
    }
    flow.divergence = factor * flow.divergence;
    flow
}

/// By how much G, Ω and P differ from their values at the point.
#[inline(always)]
fn changes<D: Number>(s: &PointState<D>, omega: [D; 2]) -> [D; N_DEMANDS] {
    let [gx, gy] = pressure_stress(s);
    [gx, gy, omega[0], omega[1], s.pressure].map(|y| y - y.re())
}

/// A value with its slopes, exact to first order around the point.
#[inline(always)]
fn expanded<D: Number>(value: f64, slopes: &[f64; N_DEMANDS], changes: &[D; N_DEMANDS]) -> D {
    let mut sum = D::from(value);
    for (change, slope) in changes.iter().zip(slopes) {
        sum += *change * *slope;
    }
    sum
}

/// Flow of a film whose temperature varies, `density` its mean: what the temperature does along the film
/// comes on top.
#[inline(always)]
pub fn thermal<D: Number>(
    s: &PointState<D>,
    m: &Properties<D>,
    lambda: f64,
    slide: &PointSliding,
    closure: &ThermalClosure,
    density: &Mean,
) -> Flow<D> {
    let mut flow = generalized(s, m, lambda, slide, &closure.closure);
    let changes = changes(s, sliding_stress(s, m, slide.value));
    let drift = expanded(closure.drift, &closure.drift_slopes, &changes);
    flow.divergence += m.density * s.film * s.film * 12.0 / (m.viscosity * lambda) * drift;
    let dp = s.pressure - s.pressure.re();
    let [by_x, by_y] = density.along.map(|[value, by_p]| dp * by_p + value);
    flow.divergence += (flow.flux[0] * by_x + flow.flux[1] * by_y) / m.density;
    flow.drift = [s.film * by_x, s.film * by_y];
    flow
}
