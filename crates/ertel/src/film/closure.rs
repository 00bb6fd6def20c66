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
use super::fluidity::{Fluidity, Jet};

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

/// Scratch memory of the local problem.
#[derive(Clone, Debug, Default)]
pub struct Workspace {
    rule: CrossFilm,
    fluidities: Vec<Jet>,
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

/// Solves the local problem and differentiates it.
#[inline(always)]
pub fn close(
    law: &impl Fluidity,
    pressure_stress: [f64; 2],
    slide: f64,
    workspace: &mut Workspace,
) -> Closure {
    let Workspace { rule, fluidities } = workspace;
    let g = pressure_stress;
    let tau = mid_stress(law, g, slide, rule);
    fluidities.clear();
    // Moments of ∂(tf)/∂t = f I + 2f' t tᵀ and of ∂(tf)/∂P.
    let mut k = [[0.0; 3]; 3];
    let mut by_p = [[0.0; 2]; 2];
    let mut flow = [0.0; 2];
    for [s, w] in rule.points() {
        let t = [tau[0] + s * g[0], tau[1] + s * g[1]];
        let f = law.jet(dot(t, t));
        let slope = 2.0 * f.x;
        let rows = [
            f.f + slope * t[0] * t[0],
            slope * t[0] * t[1],
            f.f + slope * t[1] * t[1],
        ];
        let mut weight = *w;
        for (power, k) in k.iter_mut().enumerate() {
            for i in 0..3 {
                k[i] += weight * rows[i];
            }
            if power < 2 {
                by_p[power][0] += weight * f.p * t[0];
                by_p[power][1] += weight * f.p * t[1];
            }
            weight *= s;
        }
        flow[0] += w * s * f.f * t[0];
        flow[1] += w * s * f.f * t[1];
        fluidities.push(f);
    }
    let [k0, k1, k2] = k;
    // Columns ∂τ/∂y: K₀ τ_y = (−K₁, e_x, −a_P).
    let mid_by = [
        solve(k0, [-k1[0], -k1[1]]),
        solve(k0, [-k1[1], -k1[2]]),
        solve(k0, [1.0, 0.0]),
        solve(k0, by_p[0].map(|v| -v)),
    ];
    let mut closure = Closure {
        mid_stress: tau,
        flow,
        ..Closure::default()
    };
    // q_y = K₁ τ_y + (K₂, 0, q_P).
    let direct = [[k2[0], k2[1]], [k2[1], k2[2]], [0.0; 2], by_p[1]];
    for (y, (mid, direct)) in mid_by.iter().zip(&direct).enumerate() {
        let through = multiply(k1, *mid);
        for i in 0..2 {
            closure.slopes[i][y] = through[i] + direct[i];
        }
    }
    // q_yy' = ∫ (s − K₁K₀⁻¹) d²(tf)[y, y'] ds, with t moving by t_y = τ_y + s G_y.
    let lever = [solve(k0, [k1[0], k1[1]]), solve(k0, [k1[1], k1[2]])];
    for ([s, w], f) in rule.points().iter().zip(&*fluidities) {
        let t = [tau[0] + s * g[0], tau[1] + s * g[1]];
        let mut moves = mid_by;
        moves[0][0] += s;
        moves[1][1] += s;
        let along = moves.map(|m| dot(t, m));
        // The test direction of each component: row i of s − K₁K₀⁻¹, by symmetry of both.
        let tests = [
            [s - lever[0][0], -lever[0][1]],
            [-lever[1][0], s - lever[1][1]],
        ];
        for (i, test) in tests.iter().enumerate() {
            let test_along = dot(*test, t);
            let across = moves.map(|m| dot(*test, m));
            for y in 0..N_DEMANDS {
                for z in 0..=y {
                    // c·T[a, b] for T = ∂²(tf)/∂t²
                    let mut second = 2.0
                        * f.x
                        * (test_along * dot(moves[y], moves[z])
                            + across[y] * along[z]
                            + across[z] * along[y])
                        + 4.0 * f.xx * test_along * along[y] * along[z];
                    if y == 3 {
                        second += f.p * across[z] + 2.0 * f.xp * test_along * along[z];
                        if z == 3 {
                            second += f.p * across[3]
                                + 2.0 * f.xp * test_along * along[3]
                                + f.pp * test_along;
                        }
                    }
                    closure.curvatures[i][y][z] += w * second;
                }
            }
        }
    }
    for c in &mut closure.curvatures {
        for y in 0..N_DEMANDS {
            for z in y + 1..N_DEMANDS {
                c[y][z] = c[z][y];
            }
        }
    }
    closure
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
