//! The flow through a film of generalized-Newtonian fluid, from its stress across the film.
//!
//! ```text
//!   t(s) = τ + sG,  G = H∇P          stress across the film, s from −½ (body 1) to ½ (body 2)
//!   ∫ t f(|t|²) ds = Ω               the surfaces slide: two equations for the mid-plane stress τ
//!   q = ∫ s t f(|t|²) ds             flow that the pressure drives; Newtonian q = G/12
//!
//!   f = μ₁/η the relative fluidity, Ω = μ₁Δu/h; stresses in units of a p_h/R
//! ```
//! The momentum balance of a thin film makes the stress linear across it (Habchi 2008, eq. 4.4); f
//! depends on the stress, so a small problem remains at each point of the contact, solved
//! to round-off. It is convex: τ is the minimum of ∫ W(|t|²) ds − Ω·τ, W' = f/2. First and second
//! derivatives of q by y = (G_x, G_y, Ω_x, Ω_y, P) follow by implicit differentiation.
//!
//! Theory: The flow through the film.

use std::ops::{Add, Mul};

use super::cross_film::CrossFilm;
use super::fluidity::{Fluidity, UniformFluidity};
use super::stress_scales::{LimitScale, StressScales};

/// Number of quantities that the flow depends on: G_x, G_y, Ω_x, Ω_y, P.
pub const N_DEMANDS: usize = 5;
/// Ω_y and P among them.
pub(super) const ACROSS_MOTION: usize = 3;
pub(super) const PRESSURE: usize = 4;

/// Solution of the local problem.
#[derive(Clone, Copy, Debug, Default)]
pub struct Closure {
    /// τ.
    pub mid_stress: [f64; 2],
    /// q.
    pub flow: [f64; 2],
    /// ∂q/∂y; those by Ω_y are left out where the surfaces nowhere slide across the motion.
    pub slopes: [[f64; N_DEMANDS]; 2],
    /// ∂²q/∂y∂y, likewise.
    pub curvatures: [[[f64; N_DEMANDS]; N_DEMANDS]; 2],
    /// ∂τ/∂y, for each y.
    pub stress_slopes: [[f64; 2]; N_DEMANDS],
}

impl Closure {
    /// Solution for a Newtonian film: q = G/12, τ = Ω.
    pub fn newtonian(pressure_stress: [f64; 2], sliding_stress: [f64; 2]) -> Closure {
        let mut closure = Closure {
            mid_stress: sliding_stress,
            flow: pressure_stress.map(|g| g / 12.0),
            ..Closure::default()
        };
        for i in 0..2 {
            closure.slopes[i][i] = 1.0 / 12.0;
            closure.stress_slopes[2 + i][i] = 1.0;
        }
        closure
    }
}

/// Mid-plane stress at which the surfaces slide by Ω; the points across the film are left in `rule`. Not a
/// number where it cannot be computed.
#[inline(always)]
pub fn mid_stress(
    law: &impl Fluidity,
    pressure_stress: [f64; 2],
    sliding_stress: [f64; 2],
    rule: &mut CrossFilm,
) -> [f64; 2] {
    let [x, y] = sliding_stress;
    let g = pressure_stress;
    if y == 0.0 {
        return mid_stress_along(law, g, x, rule);
    }
    // The fluid is isotropic: solved along the sliding and turned back.
    let size = x.hypot(y);
    let [c, s] = [x / size, y / size];
    let turned = [c * g[0] + s * g[1], c * g[1] - s * g[0]];
    let [along, across] = mid_stress_along(law, turned, size, rule);
    [c * along - s * across, s * along + c * across]
}

/// The same where the surfaces slide along x.
#[inline(always)]
fn mid_stress_along(
    law: &impl Fluidity,
    g: [f64; 2],
    slide: f64,
    rule: &mut CrossFilm,
) -> [f64; 2] {
    let scales = law.scales();
    if slide == 0.0 && law.is_symmetric() {
        // Odd in s: no stress at mid-plane.
        rule.lay(&scales, [0.0; 2], g);
        return [0.0; 2];
    }
    let limit = scales.limit.map(|limit| Limit::new(&limit, g, slide));
    let mut tau = [0.0; 2];
    if slide != 0.0 {
        tau[0] = without_pressure(law, &scales, slide);
    }
    if let Some(limit) = &limit {
        tau = limit.start(tau, g);
    }
    rule.lay(&scales, tau, g);
    weigh(law, rule);
    let mut now = rate(law, rule, tau, g, slide);
    let negligible = match law.is_symmetric() {
        true => NEGLIGIBLE,
        false => NEGLIGIBLE_ASYMMETRIC,
    };
    for _ in 0..MOST_ITERATIONS {
        if now.excess == [0.0; 2] {
            // Nothing moves.
            return tau;
        }
        let step = solve(now.slopes, now.excess).map(|v| -v);
        let slope = dot(step, now.excess);
        let mut size = dot(tau, tau).sqrt() + negligible * dot(g, g).sqrt();
        if let Some(limit) = &limit {
            size = size.min(100.0 * limit.fold);
        }
        let small = dot(step, step).sqrt() < CLOSE * size;
        let first = match &limit {
            Some(limit) if !small => limit.share(&now, tau, step, g, slide),
            _ => 1.0,
        };
        let mut share = first;
        // Shares between which the potential is least.
        let (mut low, mut high) = (0.0, f64::INFINITY);
        let mut halves = true;
        for trial in 0..MOST_TRIALS {
            let next = [0, 1].map(|i| tau[i] + share * step[i]);
            rule.move_to(&scales, next, g);
            weigh(law, rule);
            let there = rate(law, rule, next, g, slide);
            // The potential is convex: no further than where it has risen again as steeply.
            let steepness = dot(step, there.excess) / -slope;
            let falls_on = first < 1.0 && share < 1.0 && steepness < -0.7;
            if falls_on && high - low > 1e-6 {
                low = share;
                share = (2.0 * share).min(1.0).min(0.5 * (share + high));
                continue;
            }
            if small || steepness < 0.5 || share < 1e-6 * first || trial + 1 == MOST_TRIALS {
                (tau, now) = (next, there);
                break;
            }
            high = share;
            share = 0.5 * (low + high);
            if let Some(limit) = &limit {
                halves = !halves;
                if !halves {
                    share = share.max(high - limit.folds_back(steepness, step));
                }
            }
        }
        if small {
            return tau;
        }
        if !slope.is_finite() {
            break;
        }
    }
    [f64::NAN; 2]
}

/// Fills in the factors of heights that the rule is new to.
#[inline(always)]
fn weigh(law: &impl Fluidity, rule: &mut CrossFilm) {
    if !law.is_symmetric() {
        rule.fill_in(law);
    }
}

/// Newton iterations at most; convexity makes five typical.
const MOST_ITERATIONS: usize = 60;
/// Shares of a step that are tried at most.
const MOST_TRIALS: usize = 60;
/// Step, over the stress, after which the next would be below round-off.
const CLOSE: f64 = 1e-8;
/// Mid-plane stress, over the stress of the pressure, that no longer matters.
const NEGLIGIBLE: f64 = 1e-6;
/// The same in asymmetric films, where it is the difference between the halves.
const NEGLIGIBLE_ASYMMETRIC: f64 = 1e-3;

/// Resolution of a limiting stress: shear rates that grow e-fold by a small share of it.
struct Limit {
    /// Stress by which the fluidity grows e-fold beyond the limit.
    fold: f64,
    /// Stress that the walls need at most for the surfaces to slide by Ω.
    ceiling: f64,
}

impl Limit {
    fn new(limit: &LimitScale, g: [f64; 2], slide: f64) -> Limit {
        let fold = limit.fold;
        // A layer at the wall, of thickness δ = fold/(|G| + fold), where tf = eᴱτ_L/2, carries all of Ω.
        let thickness = fold / (dot(g, g).sqrt() + fold);
        let folds = (2.0 * slide.abs() / (limit.stress * thickness)).ln_1p();
        Limit {
            fold,
            ceiling: limit.joint + (folds + 1.0) * fold,
        }
    }

    /// Mid-plane stress no larger than asked for, with the walls below the ceiling if that can be.
    fn start(&self, tau: [f64; 2], g: [f64; 2]) -> [f64; 2] {
        let room = self.ceiling * self.ceiling - 0.25 * g[1] * g[1];
        let most = room.max(0.0).sqrt() - 0.5 * g[0].abs();
        if most >= tau[0].abs() {
            return tau;
        }
        [most.max(1e-3 * tau[0].abs()).copysign(tau[0]), 0.0]
    }

    /// Share of a Newton step that leads to the goal where the mean shear rate R grows as a hyperbolic sine of
    /// the stress, and no wall far beyond the limit.
    fn share(&self, now: &Rate, tau: [f64; 2], step: [f64; 2], g: [f64; 2], slide: f64) -> f64 {
        let goal = slide.abs();
        let excess = dot(now.excess, now.excess).sqrt();
        let rate = (now.excess[0] + slide).hypot(now.excess[1]);
        let length = dot(step, step).sqrt();
        // R = c sinh(t/fold): c² = (fold R')² − R²
        let by_fold = self.fold * excess / length;
        let unit = by_fold * (1.0 - (rate / by_fold).powi(2)).max(1e-30).sqrt();
        let distance = goal - rate;
        let mut share = 1.0;
        if distance.abs() > 1e-3 * goal {
            let folds = (goal / unit).asinh() - (rate / unit).asinh();
            share = folds * rate.hypot(unit) / distance;
        }
        for s in [-0.5, 0.5] {
            let t = [0, 1].map(|i| tau[i] + s * g[i]);
            // |t + share·step|² = ceiling²
            let remaining = self.ceiling * self.ceiling - dot(t, t);
            if remaining > 0.0 {
                let along = dot(t, step);
                let most =
                    remaining / (along + (along * along + remaining * length * length).sqrt());
                share = share.min(most);
            }
        }
        share
    }

    /// Share of a step after which a shear rate too high by a factor is still too high.
    fn folds_back(&self, factor: f64, step: [f64; 2]) -> f64 {
        factor.max(2.0).ln() * self.fold / dot(step, step).sqrt()
    }
}

/// Stress with τf(τ²) = Ω: what the pressure gradient then changes is small where sliding counts.
fn without_pressure(law: &impl Fluidity, scales: &StressScales, slide: f64) -> f64 {
    let goal = slide.abs() / law.factor(0.0);
    let mut tau = goal;
    if let Some(growth) = scales.growth {
        tau = tau.min(growth * (goal / growth).asinh());
    }
    if let Some(limit) = scales.limit {
        tau = tau.min(limit.stress * (goal / limit.stress).tanh());
    }
    let (mut low, mut high) = (0.0_f64, f64::INFINITY);
    // Newton's method for ln τ + ln f = ln Ω, of slope at least one, within a bracket.
    for _ in 0..MOST_ITERATIONS {
        let [f, by_square] = law.slope(tau * tau);
        let slope = 1.0 + 2.0 * tau * tau * by_square / f;
        let step = (tau * f / goal).ln() / slope;
        if step > 0.0 {
            high = tau;
        } else {
            low = tau;
        }
        let next = tau * (-step).exp();
        if step.abs() < 1e-3 {
            // Accepted without checking the bracket: a step as small as rounding stays on its edge, and bisection would halve the stress.
            tau = next;
            break;
        }
        tau = match next > low && next < high {
            true => next,
            false if high.is_finite() => 0.5 * (low + high),
            false => next,
        };
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
    let even = law.is_symmetric();
    for (k, [s, w]) in rule.points().iter().enumerate() {
        let [x, y] = [tau[0] + s * g[0], tau[1] + s * g[1]];
        let [f, by_square] = law.slope(x * x + y * y);
        let w = if even { *w } else { w * rule.factors()[k] };
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
    /// At the points of `rule`; second derivatives only if `SECOND`.
    #[inline(always)]
    fn new<const SECOND: bool>(
        law: &impl UniformFluidity,
        rule: &CrossFilm,
        tau: [f64; 2],
        g: [f64; 2],
    ) -> Moments {
        let mut m = Moments::default();
        let with_pressure = law.depends_on_pressure();
        for &[s, w] in rule.points() {
            let [x, y] = [tau[0] + s * g[0], tau[1] + s * g[1]];
            let f = law.jet(x * x + y * y);
            let powers = [w, w * s, w * s * s, w * s * s * s];
            let (d, dd) = (2.0 * f.x, 4.0 * f.xx);
            let first = [f.f + d * x * x, d * x * y, f.f + d * y * y];
            add(&mut m.first, &powers, &first);
            m.flow[0] += powers[1] * f.f * x;
            m.flow[1] += powers[1] * f.f * y;
            if with_pressure {
                add(&mut m.by_p, &powers, &[f.p * x, f.p * y]);
            }
            if !SECOND {
                continue;
            }
            let second = [
                x * (3.0 * d + dd * x * x),
                y * (d + dd * x * x),
                x * (d + dd * y * y),
                y * (3.0 * d + dd * y * y),
            ];
            add(&mut m.second, &powers, &second);
            if with_pressure {
                let d = 2.0 * f.xp;
                let mixed = [f.p + d * x * x, d * x * y, f.p + d * y * y];
                add(&mut m.mixed, &powers, &mixed);
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

/// Solution of the local problem without derivatives.
#[derive(Clone, Copy, Debug, Default)]
pub struct FilmFlow {
    /// τ.
    pub mid_stress: [f64; 2],
    /// q.
    pub flow: [f64; 2],
    /// ∫ t·tf ds, the work of the stresses: Ω·τ + G·q where e = s.
    pub work: f64,
}

/// Solves the local problem; q = ∫ e tf ds with the moment weight e(s), which is s where the density is uniform.
#[inline(always)]
pub fn flow(
    law: &impl Fluidity,
    moment_weight: impl Fn(f64) -> f64,
    pressure_stress: [f64; 2],
    sliding_stress: [f64; 2],
    rule: &mut CrossFilm,
) -> FilmFlow {
    let tau = mid_stress(law, pressure_stress, sliding_stress, rule);
    let mut film = FilmFlow {
        mid_stress: tau,
        ..FilmFlow::default()
    };
    let even = law.is_symmetric();
    for (k, &[s, w]) in rule.points().iter().enumerate() {
        let t = [0, 1].map(|i| tau[i] + s * pressure_stress[i]);
        let square = dot(t, t);
        let factor = if even { 1.0 } else { rule.factors()[k] };
        let f = factor * law.slope(square)[0];
        let e = moment_weight(s);
        film.flow[0] += w * e * f * t[0];
        film.flow[1] += w * e * f * t[1];
        film.work += w * f * square;
    }
    film
}

/// Solves the local problem and differentiates it, by Ω_y only if `ACROSS`.
#[inline(always)]
pub fn close<const ACROSS: bool>(
    law: &impl UniformFluidity,
    pressure_stress: [f64; 2],
    sliding_stress: [f64; 2],
    rule: &mut CrossFilm,
) -> Closure {
    let tau = mid_stress(law, pressure_stress, sliding_stress, rule);
    let m = Moments::new::<true>(law, rule, tau, pressure_stress);
    let mut closure = first_order::<ACROSS>(tau, &m);
    let mid_by = closure.stress_slopes;
    let [k0, k1, _] = m.first;
    let inverse = |b: [f64; 2]| solve(k0, b);
    // q_yz = ∫(s − K¹(K⁰)⁻¹) d²(tf)[y, z] ds, t moving by t_y = τ_y + s e_y.
    let moment_weight = [inverse([k1[0], k1[1]]), inverse([k1[1], k1[2]])];
    let moves = [[1.0, 0.0], [0.0, 1.0], [0.0; 2], [0.0; 2], [0.0; 2]];
    for y in 0..N_DEMANDS {
        for z in 0..=y {
            if !ACROSS && (y == ACROSS_MOTION || z == ACROSS_MOTION) {
                continue;
            }
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
                if y == PRESSURE {
                    // P acts by itself, too.
                    let mixed = |v, f| plus(multiply(m.mixed[n], v), multiply(m.mixed[n + 1], f));
                    sum = plus(sum, mixed(v, f));
                    if z == PRESSURE {
                        sum = plus(plus(sum, mixed(u, e)), m.second_by_p[n]);
                    }
                }
                sum
            };
            let (zeroth, first) = (moment(0), moment(1));
            for i in 0..2 {
                let value = first[i] - dot(moment_weight[i], zeroth);
                closure.curvatures[i][y][z] = value;
                closure.curvatures[i][z][y] = value;
            }
        }
    }
    closure
}

/// The solution's flow, stress and first derivatives, by Ω_y only if `ACROSS`.
#[inline(always)]
fn first_order<const ACROSS: bool>(tau: [f64; 2], m: &Moments) -> Closure {
    let [k0, k1, k2] = m.first;
    let inverse = |b: [f64; 2]| solve(k0, b);
    // Columns ∂τ/∂y: K⁰ τ_y = (−K¹, e_x, e_y, −a_P).
    let mid_by = [
        inverse([-k1[0], -k1[1]]),
        inverse([-k1[1], -k1[2]]),
        inverse([1.0, 0.0]),
        inverse([0.0, 1.0]),
        inverse(m.by_p[0].map(|v| -v)),
    ];
    let mut closure = Closure {
        mid_stress: tau,
        flow: m.flow,
        stress_slopes: mid_by,
        ..Closure::default()
    };
    // q_y = K¹ τ_y + (K², 0, 0, q_P).
    let direct = [
        [k2[0], k2[1]],
        [k2[1], k2[2]],
        [0.0; 2],
        [0.0; 2],
        m.by_p[1],
    ];
    for (y, (mid, direct)) in mid_by.iter().zip(&direct).enumerate() {
        if !ACROSS && y == ACROSS_MOTION {
            continue;
        }
        let through = multiply(k1, *mid);
        for i in 0..2 {
            closure.slopes[i][y] = through[i] + direct[i];
        }
    }
    closure
}

/// A number, or several side by side.
pub(super) trait Number: Copy + Add<Output = Self> + Mul<Output = Self> {}

impl<T: Copy + Add<Output = T> + Mul<Output = T>> Number for T {}

/// T[·, u, v] for a symmetric T given by xxx, xxy, xyy, yyy.
#[inline(always)]
pub(super) fn contract<T: Number>(t: [T; 4], u: [T; 2], v: [T; 2]) -> [T; 2] {
    let (xx, xy, yy) = (u[0] * v[0], u[0] * v[1] + u[1] * v[0], u[1] * v[1]);
    [
        t[0] * xx + t[1] * xy + t[2] * yy,
        t[1] * xx + t[2] * xy + t[3] * yy,
    ]
}

#[inline(always)]
pub(super) fn plus<T: Number>(a: [T; 2], b: [T; 2]) -> [T; 2] {
    [a[0] + b[0], a[1] + b[1]]
}

/// K x for a symmetric K given by xx, xy, yy.
#[inline(always)]
pub(super) fn multiply<T: Number>(k: [T; 3], x: [T; 2]) -> [T; 2] {
    [k[0] * x[0] + k[1] * x[1], k[1] * x[0] + k[2] * x[1]]
}

/// K⁻¹ b, likewise.
#[inline(always)]
pub(crate) fn solve(k: [f64; 3], b: [f64; 2]) -> [f64; 2] {
    let factor = k[1] / k[0];
    let y = (b[1] - factor * b[0]) / (k[2] - factor * k[1]);
    [(b[0] - k[1] * y) / k[0], y]
}

#[inline(always)]
pub(crate) fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

#[cfg(test)]
mod tests;
