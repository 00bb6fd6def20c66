//! Estimated ratio of the film of a shear-thinning fluid to the Newtonian film, for the size of its cells.

use ertel_rheology::shear::ShearThinning;

use crate::case::Case;

/// Exponent of viscosity times speed in the formulas of films: 0.67 (Hamrock and Dowson 1977, circular) to 0.7 (Dowson and Higginson 1966, line).
const SPEED_EXPONENT: f64 = 0.68;

/// Largest shear rate that rolling makes in the inlet, over u/h_c: the wall's, 6u(h − h_c)/h², where h = 2h_c.
const RATE_OF_ROLLING: f64 = 1.5;

/// Share of the Newtonian film above which the mesh of the Newtonian film serves: within the range of refinement in any case.
const THICK_ENOUGH: f64 = 1.0 / 3.0;

/// The central film that a mesh is made for, m: `newtonian`, or the estimated thinned film where it is less than a
/// third.
pub(super) fn film_of_mesh(case: &Case, newtonian: f64) -> f64 {
    let Some(thinning) = case.shear_thinning() else {
        return newtonian;
    };
    let lubricant = &case.lubricant;
    let slope = (lubricant.viscosity).pressure_viscosity_slope(lubricant.temperature);
    let slides = case.motion.slide_to_roll_ratio;
    let rate = case.motion.entrainment_speed / newtonian * RATE_OF_ROLLING.hypot(slides);
    // Films are made where viscosity has grown by e.
    let pressure = if slope > 0.0 { slope.recip() } else { 0.0 };
    let share = remaining_share(thinning, lubricant.ambient_viscosity() * rate, pressure);
    match share < THICK_ENOUGH {
        true => share * newtonian,
        false => newtonian,
    }
}

/// Film over that of the Newtonian fluid, whose shear stress in the inlet is `stress`, Pa, at `pressure`, Pa:
///
/// ```text
///   h = h_N φ^(−m),   φ = μ₁/η at τ,   τφ = μ₁γ̇ = S h_N/h   ⇒   τ φ(τ²)^(1 − m) = S
/// ```
fn remaining_share(thinning: &ShearThinning, stress: f64, pressure: f64) -> f64 {
    let ln_fluidity =
        |ln_tau: f64| -> f64 { (thinning.relative_fluidity((2.0 * ln_tau).exp(), pressure)).ln() };
    let target = stress.ln();
    // φ ≥ 1: τ is S at most.
    let (mut below, mut above) = (target - LOWEST_STRESS, target);
    for _ in 0..BISECTIONS {
        let middle = 0.5 * (below + above);
        match middle + (1.0 - SPEED_EXPONENT) * ln_fluidity(middle) < target {
            true => below = middle,
            false => above = middle,
        }
    }
    (-SPEED_EXPONENT * ln_fluidity(below)).exp()
}

/// Logarithm of S over the least stress that is looked for, and steps to it.
const LOWEST_STRESS: f64 = 60.0;
const BISECTIONS: usize = 80;

#[cfg(test)]
mod tests {
    use ertel_rheology::shear::{Carreau, ShearLaw, StressLimit};

    use super::*;
    use crate::near::near;

    /// Carreau's law with n = 0.5 is φ = τ/G far above G: τ = G (S/G)^(1/1.32), h/h_N = (S/G)^(−0.68/1.32), by hand 0.02850 at S = 1,000 G.
    #[test]
    fn a_power_law_thins_the_film_by_a_power() {
        let law = ShearLaw::Carreau(Carreau::new(1e4, 0.5, 2.0, 0.0).unwrap());
        let thinning = ShearThinning::of(law);
        near(remaining_share(&thinning, 1e7, 0.0), 0.02850, 2e-3);
        // Far below G it is Newtonian.
        near(remaining_share(&thinning, 10.0, 0.0), 1.0, 1e-6);
    }

    /// A limit far above the stress in the inlet leaves the film as it is; ten times below it next to nothing: φ = 10^(1/0.32), by hand
    /// 0.0075 and more or less as the limit is rounded off.
    #[test]
    fn a_limit_counts_where_it_is_reached() {
        let limited = |limit| ShearThinning::limited(StressLimit::new(limit, 0.0).unwrap());
        near(remaining_share(&limited(1e7), 1e5, 0.0), 1.0, 1e-3);
        let left = remaining_share(&limited(1e4), 1e5, 0.0);
        assert!((0.005..0.015).contains(&left), "{left}");
    }
}
