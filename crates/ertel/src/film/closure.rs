//! The flow through a film of generalized-Newtonian fluid, from its stress across the film.
//!
//! ```text
//!   t(s) = τ + sG,  G = H∇P          stress across the film, s from −½ (plane) to ½ (ball)
//!   ∫ t f(|t|²) ds = Ω e_x           the surfaces slide: two equations for the mid-plane stress τ
//!   q = ∫ s t f(|t|²) ds             flow that the pressure drives; Newtonian q = G/12
//!
//!   f = μ₁/η the relative fluidity, Ω = μ₁Δu/h; stresses in units of a p_h/R
//! ```
//! The momentum balance of a thin film makes the stress linear across it (Habchi 2008, eq. 4.4); f
//! depends on the stress, so that what is left is this small problem at each point of the contact, solved
//! to round-off. It is convex: τ is the minimum of ∫ W(|t|²) ds − Ωτ_x, W' = f/2. First and second
//! derivatives of q by y = (G_x, G_y, Ω, P) follow by implicit differentiation.

use super::cross_film::{CrossFilm, StressScales};
use super::fluidity::Fluidity;

/// Number of quantities that the flow depends on: G_x, G_y, Ω, P.
pub const N_DEMANDS: usize = 4;

/// Solution of the local problem.
#[derive(Clone, Copy, Debug, Default)]
pub struct Closure {
    /// τ.
    pub mid_stress: [f64; 2],
    /// q.
    pub flow: [f64; 2],
    /// ∂q/∂y.
    pub slopes: [[f64; N_DEMANDS]; 2],
    /// ∂²q/∂y∂y.
    pub curvatures: [[[f64; N_DEMANDS]; N_DEMANDS]; 2],
}

impl Closure {
    /// Solution for a Newtonian film: q = G/12, τ = Ω e_x.
    pub fn newtonian(pressure_stress: [f64; 2], slide: f64) -> Closure {
        Closure {
            mid_stress: [slide, 0.0],
            flow: pressure_stress.map(|g| g / 12.0),
            slopes: [[1.0 / 12.0, 0.0, 0.0, 0.0], [0.0, 1.0 / 12.0, 0.0, 0.0]],
            ..Closure::default()
        }
    }
}

/// Mid-plane stress at which the surfaces slide by Ω; the points across the film are left in `rule`.
#[inline(always)]
pub fn mid_stress(
    law: &impl Fluidity,
    pressure_stress: [f64; 2],
    slide: f64,
    rule: &mut CrossFilm,
) -> [f64; 2] {
    let scales = law.scales();
    let g = pressure_stress;
    if slide == 0.0 {
        // Odd in s: no stress at mid-plane.
        rule.lay(&scales, [0.0; 2], g);
        return [0.0; 2];
    }
    let mut tau = [without_pressure(law, &scales, slide), 0.0];
    rule.lay(&scales, tau, g);
    let mut now = rate(law, rule, tau, g, slide);
    for _ in 0..MOST_ITERATIONS {
        let step = solve(now.slopes, now.excess).map(|v| -v);
        let slope = dot(step, now.excess);
        let size = dot(tau, tau).sqrt() + NEGLIGIBLE * dot(g, g).sqrt();
        let small = dot(step, step).sqrt() < CLOSE * size;
        let mut share = 1.0;
        loop {
            let next = [0, 1].map(|i| tau[i] + share * step[i]);
            rule.move_to(&scales, next, g);
            let there = rate(law, rule, next, g, slide);
            // The potential is convex: no further than where it has risen again as steeply.
            if small || dot(step, there.excess) < -0.5 * slope || share < 1e-6 {
                (tau, now) = (next, there);
                break;
            }
            share *= 0.5;
        }
        if small {
            break;
        }
    }
    tau
}

/// Newton iterations at most; convexity makes five typical.
const MOST_ITERATIONS: usize = 60;
/// Step, over the stress, after which the next would be below round-off.
const CLOSE: f64 = 1e-8;
/// Mid-plane stress, over the stress of the pressure, that no longer matters.
const NEGLIGIBLE: f64 = 1e-6;

/// Stress with τf(τ²) = Ω: what the pressure gradient then changes is small where sliding counts.
fn without_pressure(law: &impl Fluidity, scales: &StressScales, slide: f64) -> f64 {
    let goal = slide.abs();
    let mut tau = goal;
    if let Some(growth) = scales.growth {
        tau = tau.min(growth * (goal / growth).asinh());
    }
    if let Some(limit) = scales.limit {
        tau = tau.min(limit * (goal / limit).tanh());
    }
    // Newton's method for ln τ + ln f = ln Ω, of slope at least one.
    for _ in 0..MOST_ITERATIONS {
        let [f, by_square] = law.slope(tau * tau);
        let slope = 1.0 + 2.0 * tau * tau * by_square / f;
        let step = (tau * f / goal).ln() / slope;
        tau *= (-step).exp();
        if step.abs() < 1e-3 {
            break;
        }
    }
    tau.copysign(slide)
}

/// Mean shear rate beyond Ω, and its derivatives by τ: xx, xy, yy.
struct Rate {
    excess: [f64; 2],
    slopes: [f64; 3],
}

#[inline(always)]
fn rate(law: &impl Fluidity, rule: &CrossFilm, tau: [f64; 2], g: [f64; 2], slide: f64) -> Rate {
    let mut excess = [-slide, 0.0];
    let mut slopes = [0.0; 3];
    for [s, w] in rule.points() {
        let [x, y] = [tau[0] + s * g[0], tau[1] + s * g[1]];
        let [f, by_square] = law.slope(x * x + y * y);
        let (value, slope) = (w * f, 2.0 * w * by_square);
        excess[0] += value * x;
        excess[1] += value * y;
        slopes[0] += value + slope * x * x;
        slopes[1] += slope * x * y;
        slopes[2] += value + slope * y * y;
    }
    Rate { excess, slopes }
}

/// Integrals over the film of Kⁿ = ∫sⁿ ∂(tf)/∂t ds and their like; symmetric tensors by xx, xy, yy and xxx, xxy, xyy, yyy.
#[derive(Default)]
struct Moments {
    /// ∂(tf)/∂t = f I + 2f' t tᵀ; n = 0, 1, 2.
    first: [[f64; 3]; 3],
    /// ∂²(tf)/∂t²; n = 0 to 3.
    second: [[f64; 4]; 4],
    /// tf; n = 1.
    flow: [f64; 2],
    /// ∂(tf)/∂P; n = 0, 1.
    by_p: [[f64; 2]; 2],
    /// ∂²(tf)/∂t∂P; n = 0, 1, 2.
    mixed: [[f64; 3]; 3],
    /// ∂²(tf)/∂P²; n = 0, 1.
    second_by_p: [[f64; 2]; 2],
}

impl Moments {
    #[inline(always)]
    fn new(law: &impl Fluidity, rule: &CrossFilm, tau: [f64; 2], g: [f64; 2]) -> Moments {
        let mut m = Moments::default();
        let with_pressure = law.depends_on_pressure();
        for &[s, w] in rule.points() {
            let [x, y] = [tau[0] + s * g[0], tau[1] + s * g[1]];
            let f = law.jet(x * x + y * y);
            let powers = [w, w * s, w * s * s, w * s * s * s];
            let (d, dd) = (2.0 * f.x, 4.0 * f.xx);
            let first = [f.f + d * x * x, d * x * y, f.f + d * y * y];
            let second = [
                x * (3.0 * d + dd * x * x),
                y * (d + dd * x * x),
                x * (d + dd * y * y),
                y * (3.0 * d + dd * y * y),
            ];
            add(&mut m.first, &powers, &first);
            add(&mut m.second, &powers, &second);
            m.flow[0] += powers[1] * f.f * x;
            m.flow[1] += powers[1] * f.f * y;
            if with_pressure {
                let d = 2.0 * f.xp;
                let mixed = [f.p + d * x * x, d * x * y, f.p + d * y * y];
                add(&mut m.mixed, &powers, &mixed);
                add(&mut m.by_p, &powers, &[f.p * x, f.p * y]);
                add(&mut m.second_by_p, &powers, &[f.pp * x, f.pp * y]);
            }
        }
        m
    }
}

/// Adds a tensor times each of the powers.
#[inline(always)]
fn add<const C: usize, const N: usize>(sums: &mut [[f64; C]; N], powers: &[f64; 4], v: &[f64; C]) {
    for (sum, power) in sums.iter_mut().zip(powers) {
        for (sum, v) in sum.iter_mut().zip(v) {
            *sum += power * v;
        }
    }
}

/// Mid-plane stress and flow alone.
#[inline(always)]
pub fn flow(
    law: &impl Fluidity,
    pressure_stress: [f64; 2],
    slide: f64,
    rule: &mut CrossFilm,
) -> [[f64; 2]; 2] {
    let tau = mid_stress(law, pressure_stress, slide, rule);
    let mut flow = [0.0; 2];
    for &[s, w] in rule.points() {
        let t = [0, 1].map(|i| tau[i] + s * pressure_stress[i]);
        let [f, _] = law.slope(dot(t, t));
        flow[0] += w * s * f * t[0];
        flow[1] += w * s * f * t[1];
    }
    [tau, flow]
}

/// Solves the local problem and differentiates it.
#[inline(always)]
pub fn close(
    law: &impl Fluidity,
    pressure_stress: [f64; 2],
    slide: f64,
    rule: &mut CrossFilm,
) -> Closure {
    let tau = mid_stress(law, pressure_stress, slide, rule);
    let m = Moments::new(law, rule, tau, pressure_stress);
    let [k0, k1, k2] = m.first;
    let inverse = |b: [f64; 2]| solve(k0, b);
    // Columns ∂τ/∂y: K⁰ τ_y = (−K¹, e_x, −a_P).
    let mid_by = [
        inverse([-k1[0], -k1[1]]),
        inverse([-k1[1], -k1[2]]),
        inverse([1.0, 0.0]),
        inverse(m.by_p[0].map(|v| -v)),
    ];
    let mut closure = Closure {
        mid_stress: tau,
        flow: m.flow,
        ..Closure::default()
    };
    // q_y = K¹ τ_y + (K², 0, q_P).
    let direct = [[k2[0], k2[1]], [k2[1], k2[2]], [0.0; 2], m.by_p[1]];
    for (y, (mid, direct)) in mid_by.iter().zip(&direct).enumerate() {
        let through = multiply(k1, *mid);
        for i in 0..2 {
            closure.slopes[i][y] = through[i] + direct[i];
        }
    }
    // q_yz = ∫(s − K¹(K⁰)⁻¹) d²(tf)[y, z] ds, t moving by t_y = τ_y + s e_y.
    let lever = [inverse([k1[0], k1[1]]), inverse([k1[1], k1[2]])];
    let moves = [[1.0, 0.0], [0.0, 1.0], [0.0; 2], [0.0; 2]];
    for y in 0..N_DEMANDS {
        for z in 0..=y {
            let [u, v, e, f] = [mid_by[y], mid_by[z], moves[y], moves[z]];
            let moment = |n: usize| {
                let mut sum = contract(m.second[n], u, v);
                if y < 2 {
                    sum = plus(sum, contract(m.second[n + 1], e, v));
                    if z < 2 {
                        sum = plus(sum, contract(m.second[n + 2], e, f));
                    }
                }
                if z < 2 {
                    sum = plus(sum, contract(m.second[n + 1], u, f));
                }
                if y == 3 {
                    // P acts by itself, too.
                    let mixed = |v, f| plus(multiply(m.mixed[n], v), multiply(m.mixed[n + 1], f));
                    sum = plus(sum, mixed(v, f));
                    if z == 3 {
                        sum = plus(plus(sum, mixed(u, e)), m.second_by_p[n]);
                    }
                }
                sum
            };
            let (zeroth, first) = (moment(0), moment(1));
            for i in 0..2 {
                let value = first[i] - dot(lever[i], zeroth);
                closure.curvatures[i][y][z] = value;
                closure.curvatures[i][z][y] = value;
            }
        }
    }
    closure
}

/// T[·, u, v] for a symmetric T given by xxx, xxy, xyy, yyy.
#[inline(always)]
fn contract(t: [f64; 4], u: [f64; 2], v: [f64; 2]) -> [f64; 2] {
    let (xx, xy, yy) = (u[0] * v[0], u[0] * v[1] + u[1] * v[0], u[1] * v[1]);
    [
        t[0] * xx + t[1] * xy + t[2] * yy,
        t[1] * xx + t[2] * xy + t[3] * yy,
    ]
}

#[inline(always)]
fn plus(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] + b[0], a[1] + b[1]]
}

/// K x for a symmetric K given by xx, xy, yy.
#[inline(always)]
fn multiply(k: [f64; 3], x: [f64; 2]) -> [f64; 2] {
    [k[0] * x[0] + k[1] * x[1], k[1] * x[0] + k[2] * x[1]]
}

/// K⁻¹ b, likewise.
#[inline(always)]
fn solve(k: [f64; 3], b: [f64; 2]) -> [f64; 2] {
    let factor = k[1] / k[0];
    let y = (b[1] - factor * b[0]) / (k[2] - factor * k[1]);
    [(b[0] - k[1] * y) / k[0], y]
}

#[inline(always)]
fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

#[cfg(test)]
mod tests;
