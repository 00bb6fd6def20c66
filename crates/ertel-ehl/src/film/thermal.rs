//! The fluid of a film whose temperature varies across it and along it.
//!
//! ```text
//!   1/η(s) = f(|t|², P) e^{E(s)}/μ̄,   E = ln μ̄ − ln μ(P, T(s))      ln μ̄ = ∫ln μ ds
//!   ρ_m = ∫ρ ds,   e(s) = ½ − ∫_s^½ ρ ds'/ρ_m                        mean density, moment weight of the shear rate
//!
//!   mass flow = H∫ρu ds = ρ_m H e_x + H∫ ρ_m e ∂u/∂s ds             (by parts; e = s where ρ is uniform)
//! ```
//! This is the generalized Reynolds equation of Yang and Wen (Habchi 2008, eqs. 5.4 and 5.5) with the flow
//! written by the shear rate. ln μ and ρ are polynomials across the film through their values at its nodes.

use nalgebra::SVector;
use num_dual::{Dual2SVec64, hessian};

use super::fluidity::{Fluidity, PointThinning};
use super::lanes::{Lanes, WIDTH, exp};
use super::point::PointFluid;
use super::polynomial::{FilmNodes, MOST_NODES, Nodal, Polynomial};
use super::stress_scales::StressScales;

/// Temperature across the film at a point of the contact area, at the nodes of the film.
#[derive(Clone, Copy, Debug, Default)]
pub struct TemperatureProfile {
    /// T, K.
    pub temperature: Nodal,
    /// ∂T/∂X and ∂T/∂Y, K.
    pub slopes: [Nodal; 2],
}

/// A property by P and T: value, slopes by P and T, curvatures PP and PT.
#[derive(Clone, Copy, Debug, Default)]
pub struct Jet2 {
    /// Value.
    pub value: f64,
    /// ∂/∂P.
    pub p: f64,
    /// ∂/∂T, 1/K.
    pub t: f64,
    /// ∂²/∂P².
    pub pp: f64,
    /// ∂²/∂P∂T, 1/K.
    pub pt: f64,
}

impl Jet2 {
    /// A function of the property, given by its value and two derivatives there.
    #[inline(always)]
    pub fn through(&self, [value, first, second]: [f64; 3]) -> Jet2 {
        Jet2 {
            value,
            p: first * self.p,
            t: first * self.t,
            pp: second * self.p * self.p + first * self.pp,
            pt: second * self.p * self.t + first * self.pt,
        }
    }

    /// Differentiates a function of P and T (K).
    pub fn of(
        f: impl Fn(Dual2SVec64<2>, Dual2SVec64<2>) -> Dual2SVec64<2>,
        pressure: f64,
        temperature: f64,
    ) -> Jet2 {
        let (value, by, second) = hessian(
            |v: SVector<Dual2SVec64<2>, 2>| f(v[0], v[1]),
            &SVector::from([pressure, temperature]),
        );
        Jet2 {
            value,
            p: by[0],
            t: by[1],
            pp: second[(0, 0)],
            pt: second[(0, 1)],
        }
    }
}

/// A quantity across the film with its changes by P, and along X and Y at a fixed P.
#[derive(Clone, Copy, Debug, Default)]
pub struct Field {
    /// Value, first and second derivative by P.
    pub by_p: [Polynomial; 3],
    /// Derivatives along X and Y: value and derivative by P.
    pub along: [[Polynomial; 2]; 2],
}

/// A number with its changes alike.
#[derive(Clone, Copy, Debug, Default)]
pub struct Mean {
    /// Value, first and second derivative by P.
    pub by_p: [f64; 3],
    /// Derivatives along X and Y: value and derivative by P.
    pub along: [[f64; 2]; 2],
}

/// Fluid of the film at one point and pressure.
#[derive(Clone, Copy, Debug)]
pub struct ThermalFluid {
    /// E.
    pub exponent: Field,
    /// e.
    pub moment_weight: Field,
    /// ρ_m.
    pub density: Mean,
    /// μ̄, the geometric mean over the film, with two derivatives by P. It cancels, and has no others.
    pub viscosity: [f64; 3],
    /// ln μ at the nodes, and its derivative by T, 1/K.
    pub ln_viscosities: [Nodal; 2],
    /// ρ̄ at the nodes, and its derivative by T, 1/K.
    pub densities: [Nodal; 2],
    /// e-folds by which μ varies across the film.
    pub variation: f64,
}

impl ThermalFluid {
    /// Fluid from ρ̄ and ln μ̄ at the nodes.
    #[inline(always)]
    pub fn new(
        nodes: &FilmNodes,
        profile: &TemperatureProfile,
        properties: impl FnMut(f64) -> [Jet2; 2],
    ) -> ThermalFluid {
        ThermalFluid::sampled::<true>(nodes, profile, properties)
    }

    /// The same with only the values of E and e, without derivatives by P and along X and Y.
    #[inline(always)]
    pub fn values(
        nodes: &FilmNodes,
        profile: &TemperatureProfile,
        properties: impl FnMut(f64) -> [Jet2; 2],
    ) -> ThermalFluid {
        ThermalFluid::sampled::<false>(nodes, profile, properties)
    }

    #[inline(always)]
    fn sampled<const DERIVATIVES: bool>(
        nodes: &FilmNodes,
        profile: &TemperatureProfile,
        mut properties: impl FnMut(f64) -> [Jet2; 2],
    ) -> ThermalFluid {
        let n = nodes.n();
        let mut density = Sampled::default();
        let mut ln_mu = Sampled::default();
        for m in 0..n {
            let [rho, mu] = properties(profile.temperature[m]);
            let slopes = [profile.slopes[0][m], profile.slopes[1][m]];
            density.set(m, &rho, slopes);
            ln_mu.set(m, &mu, slopes);
        }
        let rho = density.mean(nodes);
        let mut reference = [0.0; 3];
        let mut exponent = Field::default();
        // E and e at the nodes: the polynomials are linear in their values
        for k in 0..if DERIVATIVES { 3 } else { 1 } {
            reference[k] = nodes.mean(&ln_mu.by_p[k]);
            exponent.by_p[k] = nodes.through(&affine(reference[k], -1.0, &ln_mu.by_p[k]));
        }
        if DERIVATIVES {
            for i in 0..2 {
                for k in 0..2 {
                    exponent.along[i][k] = nodes.through(&affine(0.0, -1.0, &ln_mu.along[i][k]));
                }
            }
        }
        let [l, l1, l2] = reference;
        let mu = l.exp();
        ThermalFluid {
            exponent,
            moment_weight: moment_weight::<DERIVATIVES>(nodes, &density, &rho),
            density: rho,
            viscosity: [mu, mu * l1, mu * (l1 * l1 + l2)],
            ln_viscosities: [ln_mu.by_p[0], ln_mu.by_t],
            densities: [density.by_p[0], density.by_t],
            variation: spread(&ln_mu.by_p[0][..n]),
        }
    }

    /// Mean density and standing viscosity as the isothermal equations have them.
    pub fn point(&self) -> PointFluid {
        PointFluid {
            density: self.density.by_p,
            viscosity: self.viscosity,
        }
    }
}

fn spread(values: &[f64]) -> f64 {
    let largest = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    largest - values.iter().copied().fold(f64::INFINITY, f64::min)
}

/// a + b v.
#[inline(always)]
fn affine(a: f64, b: f64, values: &Nodal) -> Nodal {
    let mut sum = [a; MOST_NODES];
    for (sum, v) in sum.iter_mut().zip(values) {
        *sum += b * v;
    }
    sum
}

/// e = ½ − ∫_s^½ r ds' and its derivatives, r = ρ/ρ_m.
#[inline(always)]
fn moment_weight<const DERIVATIVES: bool>(
    nodes: &FilmNodes,
    density: &Sampled,
    mean: &Mean,
) -> Field {
    let [rho, rho_p, rho_pp] = mean.by_p;
    let scale = 1.0 / rho;
    // (a − Σ bᵢ cᵢ)/ρ_m
    let quotient = |a: &Nodal, terms: &[(f64, &Nodal)]| -> Nodal {
        let mut sum = affine(0.0, scale, a);
        for (factor, values) in terms {
            for (sum, v) in sum.iter_mut().zip(*values) {
                *sum -= scale * factor * v;
            }
        }
        sum
    };
    let below = |values: &Nodal| nodes.above(&affine(0.0, -1.0, values));
    let mut field = Field::default();
    let r = quotient(&density.by_p[0], &[]);
    field.by_p[0] = below(&r).plus(0.5);
    if !DERIVATIVES {
        return field;
    }
    let r_p = quotient(&density.by_p[1], &[(rho_p, &r)]);
    let r_pp = quotient(&density.by_p[2], &[(2.0 * rho_p, &r_p), (rho_pp, &r)]);
    field.by_p[1] = below(&r_p);
    field.by_p[2] = below(&r_pp);
    for i in 0..2 {
        let [rho_x, rho_px] = mean.along[i];
        let [a_x, a_px] = &density.along[i];
        let r_x = quotient(a_x, &[(rho_x, &r)]);
        let r_px = quotient(a_px, &[(rho_x, &r_p), (rho_p, &r_x), (rho_px, &r)]);
        field.along[i] = [below(&r_x), below(&r_px)];
    }
    field
}

/// A property at the nodes.
#[derive(Default)]
struct Sampled {
    by_p: [Nodal; 3],
    by_t: Nodal,
    along: [[Nodal; 2]; 2],
}

impl Sampled {
    #[inline(always)]
    fn set(&mut self, m: usize, jet: &Jet2, slopes: [f64; 2]) {
        self.by_p[0][m] = jet.value;
        self.by_p[1][m] = jet.p;
        self.by_p[2][m] = jet.pp;
        self.by_t[m] = jet.t;
        for (along, slope) in self.along.iter_mut().zip(slopes) {
            along[0][m] = jet.t * slope;
            along[1][m] = jet.pt * slope;
        }
    }

    #[inline(always)]
    fn mean(&self, nodes: &FilmNodes) -> Mean {
        let mut mean = Mean::default();
        for k in 0..3 {
            mean.by_p[k] = nodes.mean(&self.by_p[k]);
        }
        for i in 0..2 {
            for k in 0..2 {
                mean.along[i][k] = nodes.mean(&self.along[i][k]);
            }
        }
        mean
    }
}

/// The law of a thermal film: shear thinning times the effect of temperature.
pub struct ThermalLaw<'a> {
    /// How stress thins the fluid, if it does.
    pub thinning: Option<PointThinning<'a>>,
    /// The fluid.
    pub fluid: &'a ThermalFluid,
}

impl ThermalLaw<'_> {
    /// e^E at some heights, no more than there can be nodes.
    #[inline(always)]
    pub fn factors_at(&self, heights: &[f64]) -> Nodal {
        let mut factors = [1.0; MOST_NODES];
        for (values, heights) in factors.chunks_mut(WIDTH).zip(heights.chunks(WIDTH)) {
            let mut s = Lanes::default();
            s.0[..heights.len()].copy_from_slice(heights);
            let n = values.len();
            values.copy_from_slice(&self.factors(s).0[..n]);
        }
        factors
    }
}

impl Fluidity for ThermalLaw<'_> {
    #[inline(always)]
    fn slope(&self, stress_squared: f64) -> [f64; 2] {
        match &self.thinning {
            None => [1.0, 0.0],
            Some(law) => law.slope(stress_squared),
        }
    }

    #[inline(always)]
    fn factors(&self, s: Lanes) -> Lanes {
        exp(self.fluid.exponent.by_p[0].at_lanes(s))
    }

    fn is_symmetric(&self) -> bool {
        false
    }

    fn scales(&self) -> StressScales {
        StressScales {
            variation: Some(self.fluid.variation),
            ..(self.thinning.as_ref()).map_or_else(Default::default, Fluidity::scales)
        }
    }
}
