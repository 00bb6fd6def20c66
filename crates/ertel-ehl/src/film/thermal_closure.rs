//! The flow through a film whose temperature varies across it.
//!
//! ```text
//!   F(t) = t f(|t|², P) e^{E(s)},   t(s) = τ + sG              shear rate over 12H/(λμ̄)
//!   ∫ F ds = Ω                                                 the surfaces slide: for τ
//!   q = ∫ e F ds                                               with the moment weight e(s) of the density
//!
//!   q_d  = ∫ e(F_t t_d + F_d) + e_d F ds,       t_d = τ_d + ∂(sG)/∂d
//!   q_dg = ∫ (e − K)S ds + ∫ e_d(F_t t_g + F_g) + e_g(F_t t_d + F_d) + e_dg F ds
//!   S = F_tt[t_d, t_g] + F_td t_g + F_tg t_d + F_dg,   K = ∫eF_t ds (∫F_t ds)⁻¹
//! ```
//! As [`super::closure`], with E and e of [`super::thermal`]; d and g stand for G_x, G_y, Ω_x, Ω_y, P and for X, Y, along
//! which the temperature changes. Of the latter only the terms of the divergence are kept.
//!
//! Theory: The film when its temperature varies.

use super::closure::{
    ACROSS_MOTION, Closure, N_DEMANDS, PRESSURE, contract, mid_stress, multiply, plus, solve,
};
use super::cross_film::CrossFilm;
use super::fluidity::{Jet, UniformFluidity};
use super::lanes::{Lanes, WIDTH};
use super::thermal::ThermalLaw;

/// Solution of the local problem.
#[derive(Clone, Copy, Debug, Default)]
pub struct ThermalClosure {
    /// As in a film of one temperature.
    pub closure: Closure,
    /// ∂q_x/∂X + ∂q_y/∂Y by the temperature alone.
    pub drift: f64,
    /// Its derivatives by G_x, G_y, Ω_x, Ω_y, P.
    pub drift_slopes: [f64; N_DEMANDS],
}

/// Quantities that q is differentiated by: G_x, G_y, Ω_x, Ω_y, P, X, Y.
const N: usize = N_DEMANDS + 2;
const P: usize = PRESSURE;

/// F and the moment weight at several heights of the film, with their direct derivatives by P, X and Y.
struct Heights {
    /// s and the weights.
    points: [Lanes; 2],
    /// F.
    rate: [Lanes; 2],
    /// F_t, F_tP, F_tX, F_tY: xx, xy, yy.
    by_stress: [[Lanes; 3]; 4],
    /// F_tt: xxx, xxy, xyy, yyy.
    curvature: [Lanes; 4],
    /// F_P, F_X, F_Y.
    direct: [[Lanes; 2]; 3],
    /// F_PP, F_PX, F_PY.
    direct_by_p: [[Lanes; 2]; 3],
    /// e; e_P, e_X, e_Y; e_PP, e_PX, e_PY.
    moment_weight: Lanes,
    moment_weight_by: [Lanes; 3],
    moment_weight_by_p: [Lanes; 3],
}

impl Heights {
    /// Heights (s, weight), at most [`WIDTH`], with e^E at each. Unused lanes have zero weight.
    #[inline(always)]
    fn new(
        law: &ThermalLaw,
        points: &[[f64; 2]],
        factors: &[f64],
        tau: [f64; 2],
        g: [f64; 2],
    ) -> Heights {
        let (mut s, mut weights) = (Lanes::default(), Lanes::default());
        let mut thinning_by_heat = Lanes::default();
        for (k, ([height, weight], factor)) in points.iter().zip(factors).enumerate() {
            s.0[k] = *height;
            weights.0[k] = *weight;
            thinning_by_heat.0[k] = *factor;
        }
        let x = s * g[0] + Lanes::all(tau[0]);
        let y = s * g[1] + Lanes::all(tau[1]);
        let mut b = LaneJet {
            f: Lanes::all(1.0),
            ..LaneJet::default()
        };
        if let Some(thinning) = &law.thinning {
            let square = x * x + y * y;
            for k in 0..points.len() {
                b.set(k, &thinning.jet(square.0[k]));
            }
        }
        let exponent = &law.fluid.exponent;
        let (a1, a2) = (exponent.by_p[1].at_lanes(s), exponent.by_p[2].at_lanes(s));
        // f e^E and its derivatives: by x = |t|², P, X, Y
        let f = thinning_by_heat * b.f;
        let [d, dd] = [thinning_by_heat * b.x * 2.0, thinning_by_heat * b.xx * 4.0];
        let f_p = thinning_by_heat * (b.p + b.f * a1);
        let d_p = thinning_by_heat * (b.xp + b.x * a1) * 2.0;
        let f_pp = thinning_by_heat * (b.pp + b.p * a1 * 2.0 + b.f * (a1 * a1 + a2));
        let moment_weight = &law.fluid.moment_weight;
        let mut along = [[Lanes::default(); 2]; 2];
        let mut moment_weight_along = [[Lanes::default(); 2]; 2];
        for i in 0..2 {
            for k in 0..2 {
                along[i][k] = exponent.along[i][k].at_lanes(s);
                moment_weight_along[i][k] = moment_weight.along[i][k].at_lanes(s);
            }
        }
        let tensor = |f: Lanes, d: Lanes| [f + d * x * x, d * x * y, f + d * y * y];
        let vector = |f: Lanes| [f * x, f * y];
        Heights {
            points: [s, weights],
            rate: vector(f),
            by_stress: [
                tensor(f, d),
                tensor(f_p, d_p),
                tensor(f * along[0][0], d * along[0][0]),
                tensor(f * along[1][0], d * along[1][0]),
            ],
            curvature: [
                x * (d * 3.0 + dd * x * x),
                y * (d + dd * x * x),
                x * (d + dd * y * y),
                y * (d * 3.0 + dd * y * y),
            ],
            direct: [
                vector(f_p),
                vector(f * along[0][0]),
                vector(f * along[1][0]),
            ],
            direct_by_p: [
                vector(f_pp),
                vector(f_p * along[0][0] + f * along[0][1]),
                vector(f_p * along[1][0] + f * along[1][1]),
            ],
            moment_weight: moment_weight.by_p[0].at_lanes(s),
            moment_weight_by: [
                moment_weight.by_p[1].at_lanes(s),
                moment_weight_along[0][0],
                moment_weight_along[1][0],
            ],
            moment_weight_by_p: [
                moment_weight.by_p[2].at_lanes(s),
                moment_weight_along[0][1],
                moment_weight_along[1][1],
            ],
        }
    }
}

/// The thinning at several heights, as [`Jet`].
#[derive(Clone, Copy, Default)]
struct LaneJet {
    f: Lanes,
    x: Lanes,
    p: Lanes,
    xx: Lanes,
    xp: Lanes,
    pp: Lanes,
}

impl LaneJet {
    #[inline(always)]
    fn set(&mut self, k: usize, jet: &Jet) {
        self.f.0[k] = jet.f;
        self.x.0[k] = jet.x;
        self.p.0[k] = jet.p;
        self.xx.0[k] = jet.xx;
        self.xp.0[k] = jet.xp;
        self.pp.0[k] = jet.pp;
    }
}

#[inline(always)]
fn sums<const C: usize>(lanes: &[Lanes; C]) -> [f64; C] {
    let mut sums = [0.0; C];
    for (sum, v) in sums.iter_mut().zip(lanes) {
        *sum = v.sum();
    }
    sums
}

/// Solves the local problem and differentiates it, by Ω_y only if `ACROSS`.
#[inline(always)]
pub fn close_thermal<const ACROSS: bool>(
    law: &ThermalLaw,
    pressure_stress: [f64; 2],
    sliding_stress: [f64; 2],
    rule: &mut CrossFilm,
) -> ThermalClosure {
    let tau = mid_stress(law, pressure_stress, sliding_stress, rule);
    let g = pressure_stress;
    let mut heights = Vec::with_capacity(rule.points().len().div_ceil(WIDTH));
    // ∫F_t, ∫sF_t, ∫eF_t, and ∫F_P, ∫F_X, ∫F_Y
    let mut stiffness = [[Lanes::default(); 3]; 3];
    let mut direct = [[Lanes::default(); 2]; 3];
    let points = rule.points().chunks(WIDTH);
    for (points, factors) in points.zip(rule.factors().chunks(WIDTH)) {
        let h = Heights::new(law, points, factors, tau, g);
        let [s, w] = h.points;
        for i in 0..3 {
            let k = w * h.by_stress[0][i];
            stiffness[0][i] += k;
            stiffness[1][i] += s * k;
            stiffness[2][i] += h.moment_weight * k;
            for a in 0..2 {
                direct[i][a] += w * h.direct[i][a];
            }
        }
        heights.push(h);
    }
    let [k0, k1, ke] = [
        sums(&stiffness[0]),
        sums(&stiffness[1]),
        sums(&stiffness[2]),
    ];
    let direct = [sums(&direct[0]), sums(&direct[1]), sums(&direct[2])];
    let inverse = |b: [f64; 2]| solve(k0, b);
    // ∂τ/∂d: K⁰ τ_d = (−K¹, e_x, e_y, −∫F_d).
    let moved = [
        inverse([-k1[0], -k1[1]]),
        inverse([-k1[1], -k1[2]]),
        inverse([1.0, 0.0]),
        inverse([0.0, 1.0]),
        inverse([-direct[0][0], -direct[0][1]]),
        inverse([-direct[1][0], -direct[1][1]]),
        inverse([-direct[2][0], -direct[2][1]]),
    ];
    // Rows of K.
    let rows = [inverse([ke[0], ke[1]]), inverse([ke[1], ke[2]])];
    let mut first = [[Lanes::default(); N]; 2];
    let mut second = [[[Lanes::default(); N]; N_DEMANDS]; 2];
    let mut flow = [Lanes::default(); 2];
    for h in &heights {
        let [s, w] = h.points;
        let moment_weight = w * h.moment_weight;
        // −K by the weight
        let mut held = [[Lanes::default(); 2]; 2];
        let mut rate = [Lanes::default(); 2];
        for i in 0..2 {
            rate[i] = w * h.rate[i];
            flow[i] += h.moment_weight * rate[i];
            for a in 0..2 {
                held[i][a] = w * -rows[i][a];
            }
        }
        // t_d, F_t t_d + F_d, F_td where there is one, e_d
        let mut shift = [[Lanes::default(); 2]; N];
        let mut change = [[Lanes::default(); 2]; N];
        for d in 0..N {
            if !ACROSS && d == ACROSS_MOTION {
                continue;
            }
            shift[d] = [Lanes::all(moved[d][0]), Lanes::all(moved[d][1])];
            if d < 2 {
                shift[d][d] += s;
            }
            change[d] = multiply(h.by_stress[0], shift[d]);
            if d >= P {
                change[d] = plus(change[d], h.direct[d - P]);
            }
        }
        let moment_weight_by = [
            w * h.moment_weight_by[0],
            w * h.moment_weight_by[1],
            w * h.moment_weight_by[2],
        ];
        for d in 0..N {
            for i in 0..2 {
                first[i][d] += moment_weight * change[d][i];
                if d >= P {
                    first[i][d] += moment_weight_by[d - P] * h.rate[i];
                }
            }
        }
        for d in 0..N_DEMANDS {
            for e in d..N {
                if !ACROSS && (d == ACROSS_MOTION || e == ACROSS_MOTION) {
                    continue;
                }
                let mut sum = contract(h.curvature, shift[d], shift[e]);
                if d == P {
                    sum = plus(sum, multiply(h.by_stress[1], shift[e]));
                    sum = plus(sum, h.direct_by_p[e - P]);
                }
                if e >= P {
                    sum = plus(sum, multiply(h.by_stress[e - P + 1], shift[d]));
                }
                for i in 0..2 {
                    let mut value =
                        moment_weight * sum[i] + held[i][0] * sum[0] + held[i][1] * sum[1];
                    if d >= P {
                        value += moment_weight_by[d - P] * change[e][i];
                        value += h.moment_weight_by_p[e - P] * rate[i];
                    }
                    if e >= P {
                        value += moment_weight_by[e - P] * change[d][i];
                    }
                    second[i][d][e] += value;
                }
            }
        }
    }
    let flow = sums(&flow);
    let first = [sums(&first[0]), sums(&first[1])];
    let mut totals = [[[0.0; N]; N_DEMANDS]; 2];
    for i in 0..2 {
        for d in 0..N_DEMANDS {
            totals[i][d] = sums(&second[i][d]);
        }
    }
    let second = totals;
    let mut thermal = ThermalClosure {
        closure: Closure {
            mid_stress: tau,
            flow,
            ..Closure::default()
        },
        drift: first[0][P + 1] + first[1][P + 2],
        drift_slopes: std::array::from_fn(|d| second[0][d][P + 1] + second[1][d][P + 2]),
    };
    for i in 0..2 {
        for d in 0..N_DEMANDS {
            thermal.closure.slopes[i][d] = first[i][d];
            for e in d..N_DEMANDS {
                thermal.closure.curvatures[i][d][e] = second[i][d][e];
                thermal.closure.curvatures[i][e][d] = second[i][d][e];
            }
        }
    }
    thermal
}

#[cfg(test)]
mod tests;
