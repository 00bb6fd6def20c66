//! Rules for steep laws against closed forms.

use super::*;
use approx::assert_relative_eq;

/// ∫√(1 + t²/κ²) ds along the x axis is the difference of κ[u√(1 + u²) + asinh u]/(2G), u = t/κ, between
/// the walls: knees a thousand times thinner than the film, in its middle, off it, beyond a wall.
#[test]
fn resolves_a_knee_wherever_it_lies() {
    let mut rule = CrossFilm::default();
    for g in [1e-6, 0.1, 1.0, 3.0, 100.0, 2000.0] {
        for tau in [0.0, 0.3, 0.49 * g, 0.6 * g, 50.0] {
            for knee in [0.1, 1.0] {
                let scales = StressScales {
                    knee: Some(knee),
                    ..StressScales::default()
                };
                rule.lay(&scales, [tau, 0.0], [g, 0.0]);
                let sum: f64 = (rule.points().iter())
                    .map(|[s, w]| w * (1.0 + ((tau + s * g) / knee).powi(2)).sqrt())
                    .sum();
                let primitive = |t: f64| {
                    let u = t / knee;
                    0.5 * knee / g * (u * u.hypot(1.0) + u.asinh())
                };
                let (low, high) = (primitive(tau - 0.5 * g), primitive(tau + 0.5 * g));
                let round_off = 1e-15 * high;
                assert_relative_eq!(sum, high - low, max_relative = 1e-10, epsilon = round_off);
            }
        }
    }
}

/// |τ + sG|² = |G|²((s − s₀)² + b²), b = |τ×G|/|G|²: a knee that is passed at a distance is as wide as both together.
#[test]
fn resolves_a_knee_that_is_passed_obliquely() {
    let mut rule = CrossFilm::default();
    for (tau, g) in [
        ([3.0, 40.0], [300.0, 20.0]),
        ([-90.0, 6.0], [200.0, -150.0]),
        ([10.0, -0.5], [-1000.0, 50.0]),
    ] {
        let knee = 0.1;
        let scales = StressScales {
            knee: Some(knee),
            ..StressScales::default()
        };
        rule.lay(&scales, tau, g);
        let square = |s: f64| (tau[0] + s * g[0]).powi(2) + (tau[1] + s * g[1]).powi(2);
        let sum: f64 = (rule.points().iter())
            .map(|[s, w]| w * (1.0 + square(*s) / (knee * knee)).sqrt())
            .sum();
        let length: f64 = f64::hypot(g[0], g[1]);
        let centre = -(tau[0] * g[0] + tau[1] * g[1]) / (length * length);
        let passed = (tau[0] * g[1] - tau[1] * g[0]) / length;
        let width = passed.hypot(knee) / length;
        let primitive = |s: f64| {
            let u = (s - centre) / width;
            0.5 * width * width * length / knee * (u * u.hypot(1.0) + u.asinh())
        };
        assert_relative_eq!(sum, primitive(0.5) - primitive(-0.5), max_relative = 1e-10);
    }
}

/// ∫ e^{kt} ds = sinh(kG/2)/(kG/2) for a stress that grows exponentially.
#[test]
fn resolves_exponential_growth() {
    let mut rule = CrossFilm::default();
    for g in [0.01, 1.0, 10.0, 40.0] {
        let scales = StressScales {
            growth: Some(1.0),
            ..StressScales::default()
        };
        rule.lay(&scales, [0.0; 2], [g, 0.0]);
        let sum: f64 = rule.points().iter().map(|[s, w]| w * (s * g).exp()).sum();
        assert_relative_eq!(sum, (0.5 * g).sinh() / (0.5 * g), max_relative = 1e-10);
    }
}
