//! The flow through a film whose temperature varies across it.
//!
//! ```text
//!   F(t) = t f(|t|², P) e^{E(s)},   t(s) = τ + sG              shear rate over 12H/(λμ̄)
//!   ∫ F ds = Ω e_x                                             the surfaces slide: for τ
//!   q = ∫ e F ds                                               with the lever e(s) of the density
//!
//!   q_d  = ∫ e(F_t t_d + F_d) + e_d F ds,       t_d = τ_d + ∂(sG)/∂d
//!   q_dg = ∫ (e − K)S ds + ∫ e_d(F_t t_g + F_g) + e_g(F_t t_d + F_d) + e_dg F ds
//!   S = F_tt[t_d, t_g] + F_td t_g + F_tg t_d + F_dg,   K = ∫eF_t ds (∫F_t ds)⁻¹
//! ```
//! As [`super::closure`], with E and e of [`super::warm`]; d and g stand for G_x, G_y, Ω, P and for X, Y, along
//! which the temperature changes. Of the latter only what a divergence needs is kept.

use super::closure::{Closure, N_DEMANDS, contract, mid_stress, multiply, plus, solve};
use super::cross_film::CrossFilm;
use super::fluidity::{Jet, UniformFluidity};
use super::warm::WarmLaw;

/// Solution of the local problem.
#[derive(Clone, Copy, Debug, Default)]
pub struct WarmClosure {
    /// As in a film of one temperature.
    pub closure: Closure,
    /// ∂q_x/∂X + ∂q_y/∂Y by the temperature alone.
    pub drift: f64,
    /// Its derivatives by G_x, G_y, Ω, P.
    pub drift_slopes: [f64; N_DEMANDS],
}

/// Quantities that q is differentiated by: G_x, G_y, Ω, P, X, Y.
const N: usize = N_DEMANDS + 2;
const P: usize = 3;

/// F and the lever at a height of the film, with their direct derivatives by P, X and Y.
struct Height {
    /// s and the weight.
    point: [f64; 2],
    /// F.
    rate: [f64; 2],
    /// F_t, F_tP, F_tX, F_tY: xx, xy, yy.
    by_stress: [[f64; 3]; 4],
    /// F_tt: xxx, xxy, xyy, yyy.
    curvature: [f64; 4],
    /// F_P, F_X, F_Y.
    direct: [[f64; 2]; 3],
    /// F_PP, F_PX, F_PY.
    direct_by_p: [[f64; 2]; 3],
    /// e; e_P, e_X, e_Y; e_PP, e_PX, e_PY.
    lever: f64,
    lever_by: [f64; 3],
    lever_by_p: [f64; 3],
}

impl Height {
    #[inline(always)]
    fn new(law: &WarmLaw, point: [f64; 2], stress: [f64; 2]) -> Height {
        let (s, [x, y]) = (point[0], stress);
        let b = match &law.thinning {
            None => Jet {
                f: 1.0,
                ..Jet::default()
            },
            Some(thinning) => thinning.jet(x * x + y * y),
        };
        let exponent = &law.fluid.exponent;
        let warmth = exponent.by_p[0].at(s).exp();
        let [a1, a2] = [1, 2].map(|k: usize| exponent.by_p[k].at(s));
        // f e^E and its derivatives: by x = |t|², P, X, Y
        let f = warmth * b.f;
        let [d, dd] = [2.0 * warmth * b.x, 4.0 * warmth * b.xx];
        let f_p = warmth * (b.p + b.f * a1);
        let d_p = 2.0 * warmth * (b.xp + b.x * a1);
        let f_pp = warmth * (b.pp + 2.0 * b.p * a1 + b.f * (a1 * a1 + a2));
        let along = exponent
            .along
            .each_ref()
            .map(|a| a.each_ref().map(|p| p.at(s)));
        let lever = &law.fluid.lever;
        let lever_along = lever
            .along
            .each_ref()
            .map(|a| a.each_ref().map(|p| p.at(s)));
        let tensor = |f: f64, d: f64| [f + d * x * x, d * x * y, f + d * y * y];
        let vector = |f: f64| [f * x, f * y];
        Height {
            point,
            rate: vector(f),
            by_stress: [
                tensor(f, d),
                tensor(f_p, d_p),
                tensor(f * along[0][0], d * along[0][0]),
                tensor(f * along[1][0], d * along[1][0]),
            ],
            curvature: [
                x * (3.0 * d + dd * x * x),
                y * (d + dd * x * x),
                x * (d + dd * y * y),
                y * (3.0 * d + dd * y * y),
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
            lever: lever.by_p[0].at(s),
            lever_by: [lever.by_p[1].at(s), lever_along[0][0], lever_along[1][0]],
            lever_by_p: [lever.by_p[2].at(s), lever_along[0][1], lever_along[1][1]],
        }
    }
}

/// Solves the local problem and differentiates it.
pub fn close_warm(
    law: &WarmLaw,
    pressure_stress: [f64; 2],
    slide: f64,
    rule: &mut CrossFilm,
) -> WarmClosure {
    let tau = mid_stress(law, pressure_stress, slide, rule);
    let g = pressure_stress;
    let mut heights = Vec::with_capacity(rule.points().len());
    // ∫F_t, ∫sF_t, ∫eF_t, and ∫F_P, ∫F_X, ∫F_Y
    let (mut k0, mut k1, mut ke) = ([0.0; 3], [0.0; 3], [0.0; 3]);
    let mut direct = [[0.0; 2]; 3];
    for &[s, w] in rule.points() {
        let h = Height::new(law, [s, w], [tau[0] + s * g[0], tau[1] + s * g[1]]);
        for i in 0..3 {
            let k = w * h.by_stress[0][i];
            k0[i] += k;
            k1[i] += s * k;
            ke[i] += h.lever * k;
            direct[i] = plus(direct[i], h.direct[i].map(|v| w * v));
        }
        heights.push(h);
    }
    let inverse = |b: [f64; 2]| solve(k0, b);
    // ∂τ/∂d: K⁰ τ_d = (−K¹, e_x, −∫F_d).
    let moved = [
        inverse([-k1[0], -k1[1]]),
        inverse([-k1[1], -k1[2]]),
        inverse([1.0, 0.0]),
        inverse(direct[0].map(|v| -v)),
        inverse(direct[1].map(|v| -v)),
        inverse(direct[2].map(|v| -v)),
    ];
    // Rows of K.
    let rows = [inverse([ke[0], ke[1]]), inverse([ke[1], ke[2]])];
    let mut first = [[0.0; N]; 2];
    let mut second = [[[0.0; N]; N_DEMANDS]; 2];
    let mut flow = [0.0; 2];
    for h in &heights {
        let ([s, w], k) = (h.point, h.by_stress[0]);
        flow = plus(flow, h.rate.map(|v| w * h.lever * v));
        // t_d, F_t t_d + F_d, F_td where there is one, e_d
        let shift: [[f64; 2]; N] = std::array::from_fn(|d| match d {
            0 => [moved[0][0] + s, moved[0][1]],
            1 => [moved[1][0], moved[1][1] + s],
            _ => moved[d],
        });
        let change: [[f64; 2]; N] = std::array::from_fn(|d| {
            let by_stress = multiply(k, shift[d]);
            if d < P {
                by_stress
            } else {
                plus(by_stress, h.direct[d - P])
            }
        });
        let lever_by = |d: usize| if d < P { 0.0 } else { h.lever_by[d - P] };
        for d in 0..N {
            for i in 0..2 {
                first[i][d] += w * (h.lever * change[d][i] + lever_by(d) * h.rate[i]);
            }
        }
        for d in 0..N_DEMANDS {
            for e in d..N {
                let mut sum = contract(h.curvature, shift[d], shift[e]);
                if d == P {
                    sum = plus(sum, multiply(h.by_stress[1], shift[e]));
                    sum = plus(sum, h.direct_by_p[e - P]);
                }
                if e >= P {
                    sum = plus(sum, multiply(h.by_stress[e - P + 1], shift[d]));
                }
                let both = match d == P {
                    true => h.lever_by_p[e - P],
                    false => 0.0,
                };
                for i in 0..2 {
                    let held = rows[i][0] * sum[0] + rows[i][1] * sum[1];
                    second[i][d][e] += w
                        * (h.lever * sum[i] - held
                            + lever_by(d) * change[e][i]
                            + lever_by(e) * change[d][i]
                            + both * h.rate[i]);
                }
            }
        }
    }
    let mut warm = WarmClosure {
        closure: Closure {
            mid_stress: tau,
            flow,
            ..Closure::default()
        },
        drift: first[0][4] + first[1][5],
        drift_slopes: std::array::from_fn(|d| second[0][d][4] + second[1][d][5]),
    };
    for i in 0..2 {
        for d in 0..N_DEMANDS {
            warm.closure.slopes[i][d] = first[i][d];
            for e in d..N_DEMANDS {
                warm.closure.curvatures[i][d][e] = second[i][d][e];
                warm.closure.curvatures[i][e][d] = second[i][d][e];
            }
        }
    }
    warm
}

#[cfg(test)]
mod tests;
