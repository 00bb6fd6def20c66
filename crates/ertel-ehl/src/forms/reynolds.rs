//! Reynolds' equation with cavitation penalty and stabilisation, dimensionless.
//!
//! ```text
//!   R(P) = −∇·Q + ū·∇(ρ̄H) + ξP⁻ = f,      Q = ε∇P, ε = ρ̄H³/(μ̄λ) if Newtonian,  P⁻ = min(P, 0)
//!
//!   ∫ (Q − ρ̄H ū)·∇W + (ξP⁻ − f) W                            Galerkin
//!   + Σ_e ∫ τ (R − f) [β·∇W]                                  SUPG
//!   + Σ_e ∫ τ (R − f) [β·∇W − ∇·(ε∇W)]                        GLS
//!   + Σ_e ∫ ρ_id h_e H ∂ρ̄/∂P/(2l) (T∇P)·∇W                    isotropic diffusion
//!   + Σ_e ∫ (coth Pe_δ − 1/Pe_δ) ρ̄/h_e κP κW                  unresolved pressure
//!
//!   β = (H ∂ρ̄/∂P + c ρ̄ h_e) ū,  τ = h_e/(2l|β|) (coth Pe − 1/Pe),  Pe = |β|h_e/(2lr²ε),  l the order
//!   κ = I − π, π the L² projection onto the polynomials that the deflection sees,  Pe_δ = ρ̄h_e²/(2lε)
//! ```
//! h_e is the length of a cell along the motion, and r ≥ 1 the ratio of that to its length across, where it is shorter across. Without
//! r, τ there is r² times what the diffusion allows (of the order of h²/ε for the shortest length h), GLS is no longer stable, and a slender contact
//! along its longer axis starts with a residual of 38 times the entrained flow instead of 1.2 (axis ratio 10).
//!
//! ū is the mean velocity of the surfaces over the entrainment speed, free of divergence: e_x + ω̄(−Y, X), with the mean spin ω̄.
//! Where a layer of oil arrives that does not fill the gap, ρ̄H in the wedge is ρ̄θH and β = ∂(ρ̄θH)/∂P (see [`super::oil_layer`]).
//! In generalized-Newtonian films Q comes from the closure and ε is ∂Q_x/∂P_x (see [`super::flow`]).
//!
//! The wedge ū·∇(ρ̄H) depends on pressure in two ways: by the density, H ∂ρ̄/∂P, which alone is the β
//! of the source, and by the deflection, ρ̄ ∂H/∂P, which at the scale of an element is ρ̄ h_e times a
//! number and, in thin films, a hundred times more. Where the fluid is nearly solid (ε → 0), no other
//! term remains in the equation; then a pressure of higher order than the deflection has modes without
//! deflection. Only the last term controls these; on smooth pressures it vanishes with the order of the
//! deflection. Both can be switched off (`elastic_stabilisation`).
//!
//! Habchi 2008, eqs. 2.29, 3.8, 3.9, 3.13 to 3.18, 4.12; f = 0 but for manufactured solutions. The
//! convection term is integrated by parts, so that the discrete equation conserves mass.
//!
//! Theory: Weak form.

use crate::contact::{OilLayer, Planar};
use crate::forms::dual::Number;
use crate::forms::flow::{Flow, PointState, Properties};
use crate::forms::oil_layer::missing;
use crate::params::Formulation;

/// Constants of the equation on one element.
#[derive(Clone, Copy, Debug)]
pub struct ElementConstants {
    /// λ of the Reynolds equation.
    pub lambda: f64,
    /// ū.
    pub entrainment: Planar,
    /// Element size h_e.
    pub size: f64,
    /// Order l of the pressure element.
    pub order: usize,
    /// Cavitation penalty ξ on this element.
    pub penalty: f64,
    /// Galerkin, SUPG or GLS.
    pub formulation: Formulation,
    /// ρ_id.
    pub isotropic_diffusion: f64,
    /// T, xx, xy, yy; `None`: the unit tensor.
    pub diffusion_tensor: Option<[f64; 3]>,
    /// r².
    pub slenderness: f64,
    /// Whether β and κ include the deflection; only in SUPG and GLS.
    pub elastic_stabilisation: bool,
    /// The layer of oil that arrives; `None`: the gap is full.
    pub oil_layer: Option<OilLayer>,
    /// Length over which the gap fills up.
    pub filling_length: f64,
}

impl ElementConstants {
    /// Adds κ T∇P to the coefficients of ∇W, with the diffusion κ.
    #[inline(always)]
    fn diffuse<D: Number>(&self, diffusion: D, [px, py]: [D; 2], gradient: &mut [D; 2]) {
        let [dx, dy] = match self.diffusion_tensor {
            None => [px, py],
            Some([xx, xy, yy]) => [px * xx + py * xy, px * xy + py * yy],
        };
        gradient[0] += diffusion * dx;
        gradient[1] += diffusion * dy;
    }
}

/// The integrand as a linear form of the test function: a W + b·∇W + c ΔW + d κW.
#[derive(Clone, Copy, Debug)]
pub struct TestCoefficients<D> {
    /// a.
    pub value: D,
    /// b.
    pub gradient: [D; 2],
    /// c.
    pub laplacian: D,
    /// d.
    pub unresolved: D,
}

/// Deflection of a pressure that varies from element to element, in units of h_e times the pressure: a
/// wave of length 4 h_e deflects by 2/π h_e. Measured on line contacts, L up to 20: from 0.1 to 1 the films agree to 3e-4.
const DEFLECTION_SHARE: f64 = 0.3;

/// Weight of the term that controls the unresolved pressure. Measured: from 1 to 10 the central
/// film agrees to 2e-4, the minimum film to 1e-3 (M = 200, L = 15);
/// at 0.1 incompressible contacts stop converging.
const UNSEEN_WEIGHT: f64 = 1.0;

/// Integrand of the weak form at a point where the surfaces move at the mean velocity ū; `source` is f.
#[inline(always)]
pub fn reynolds_point<D: Number>(
    s: &PointState<D>,
    m: &Properties<D>,
    flow: &Flow<D>,
    e: &ElementConstants,
    [u, v]: [f64; 2],
    source: f64,
) -> TestCoefficients<D> {
    let zero = D::from(0.0);
    let [px, py] = s.pressure_gradient;
    let [hx, hy] = s.film_gradient;
    let h = s.film;
    let penalty = if s.pressure.re() < 0.0 {
        s.pressure * e.penalty
    } else {
        zero
    };
    let missing =
        (e.oil_layer.as_ref()).and_then(|layer| missing(layer, s.pressure, h, e.filling_length));
    let carried = missing.map_or(h, |missing| h - missing.film);
    let mut test = TestCoefficients {
        value: penalty - source,
        gradient: [
            flow.flux[0] - m.density * carried * u,
            flow.flux[1] - m.density * carried * v,
        ],
        laplacian: zero,
        unresolved: zero,
    };
    let l2 = 2.0 * e.order as f64;
    if e.isotropic_diffusion != 0.0 {
        let diffusion = h * m.density_slope * (e.isotropic_diffusion * e.size / l2);
        e.diffuse(diffusion, s.pressure_gradient, &mut test.gradient);
    }
    if e.formulation == Formulation::Galerkin {
        return test;
    }
    let epsilon = flow.diffusivity;
    let mut beta = h * m.density_slope;
    if e.elastic_stabilisation {
        beta += m.density * (DEFLECTION_SHARE * e.size);
        let peclet = m.density * (e.size * e.size / l2) / epsilon;
        let weight = upwind(peclet) * peclet * m.density * (UNSEEN_WEIGHT / e.size);
        test.unresolved = weight * s.pressure_unresolved;
    }
    let mut wedge = m.density_slope * (px * u + py * v) * carried
        + (flow.drift[0] * u + flow.drift[1] * v)
        + m.density * (hx * u + hy * v);
    if let Some(missing) = missing {
        let along = missing.by_pressure * (px * u + py * v) + missing.by_film * (hx * u + hy * v);
        wedge -= m.density * along;
        beta -= missing.film * m.density_slope + m.density * missing.by_pressure;
    }
    let residual = -flow.divergence + wedge + penalty - source;
    let spread = epsilon * e.slenderness;
    let peclet = beta * (u.hypot(v) * e.size / l2) / spread;
    let tau = upwind(peclet) * (e.size * e.size / (l2 * l2)) / spread;
    let weight = tau * residual;
    test.gradient[0] += weight * beta * u;
    test.gradient[1] += weight * beta * v;
    if e.formulation == Formulation::Gls {
        // ∇ε without the effect of stress: the equation is consistent with any weight.
        let by_p = epsilon * m.log_slope();
        let by_h = epsilon * 3.0 / h;
        test.gradient[0] -= weight * (by_p * px + by_h * hx);
        test.gradient[1] -= weight * (by_p * py + by_h * hy);
        test.laplacian -= weight * epsilon;
    }
    test
}

/// (coth Pe − 1/Pe)/Pe, smooth through Pe = 0 where it is 1/3; τ = h_e²/(4l²ε) of it.
#[inline(always)]
fn upwind<D: Number>(peclet: D) -> D {
    let pe = peclet.re();
    if pe.abs() < 0.1 {
        // 1/3 − Pe²/45 + 2Pe⁴/945 − Pe⁶/4725; the next term is below 1e-11
        let q = peclet * peclet;
        ((q * (-1.0 / 4725.0) + 2.0 / 945.0) * q - 1.0 / 45.0) * q + 1.0 / 3.0
    } else if pe > 20.0 {
        (-peclet.recip() + 1.0) / peclet
    } else {
        (peclet.tanh().recip() - peclet.recip()) / peclet
    }
}

#[cfg(test)]
mod tests;
