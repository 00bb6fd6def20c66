//! Asperity heights with a Gaussian distribution.

use std::f64::consts::PI;

/// Width of a step of the trapezoidal rule over that of the integrand.
const STEP: f64 = 0.15;

/// Terms smaller than their sum by this factor are neglected.
const NEGLIGIBLE: f64 = 1e-18;

/// Separation over rms height above which exp(−u²/2), and with it F, underflows.
const NOTHING_FROM: f64 = 39.0;

/// The integral F_{5/2} of Greenwood and Tripp (1970, Proc. IMechE 185, 625-633) at the separation over rms height u.
///
/// ```text
///   F_{5/2}(u) = 1/√(2π) ∫_u^∞ (s − u)^{5/2} exp(−s²/2) ds
///              = 1/√(2π) ∫_{−∞}^∞ x⁶ exp(−(x² + u)²/2) dx,   s = u + x²
///              = Γ(7/2)/√(2π) exp(−u²/4) D_{−7/2}(u),   D the parabolic cylinder function
/// ```
/// The second form is smooth, even, and falls faster than any exponential: the trapezoidal rule converges to round-off with a few
/// dozen points (Trefethen and Weideman 2014, SIAM Review 56, 385-458). Relative error below 1e-13 up to u = 20 (measured).
pub fn five_halves_integral(u: f64) -> f64 {
    integral(u, 3)
}

/// F_{3/2}, with F_{5/2}' = −5/2 F_{3/2}.
pub fn three_halves_integral(u: f64) -> f64 {
    integral(u, 2)
}

/// F_1(−u) = E[max(u + s, 0)], the mean gap in σ where the mean planes are u rms heights apart.
pub fn mean_gap(u: f64) -> f64 {
    let density = (-0.5 * u * u).exp() / (2.0 * PI).sqrt();
    // The difference of the tail cancels where mean planes overlap.
    match u > OVERLAP {
        true => density + u * share_apart(u),
        false => {
            let v = 1.0 / (u * u);
            density * v * (1.0 - v * (3.0 - v * (15.0 - v * (105.0 - v * 945.0))))
        }
    }
}

/// u below which the mean gap follows from the series of the tail of the distribution: by then it is below 1e-30.
const OVERLAP: f64 = -12.0;

/// Φ(u), the share of the area that is apart: the derivative of the mean gap.
pub fn share_apart(u: f64) -> f64 {
    0.5 * libm::erfc(-u / std::f64::consts::SQRT_2)
}

/// Q(u), the share of the area of one surface above the mean plane of the other: of a smooth and a rough one, what touches where asperities flow.
pub fn area_above(u: f64) -> f64 {
    share_apart(-u)
}

/// F_{n − 1/2}: 1/√(2π) ∫ x^{2n} exp(−(x² + u)²/2) dx.
pub fn integral(u: f64, n: i32) -> f64 {
    if u >= NOTHING_FROM {
        return 0.0;
    }
    // The integrand is as wide as exp(−u x² − x⁴/2); where u < 0 it has two hills of the width 1/(2√−u) each.
    let step = STEP / (1.0 + u.abs()).sqrt();
    let (mut sum, mut last) = (0.0, 0.0);
    for k in 1.. {
        let square = (f64::from(k) * step).powi(2);
        let term = square.powi(n) * (-0.5 * (square + u).powi(2)).exp();
        sum += term;
        if term < last && term <= NEGLIGIBLE * sum || square > 2.0 * NOTHING_FROM {
            break;
        }
        last = term;
    }
    2.0 * step * sum / (2.0 * PI).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// mpmath 1.3, 40 digits: gamma(3.5)*exp(-u^2/4)*pcfd(-3.5, u)/sqrt(2*pi), up to u = 10 the same by quad over s.
    #[test]
    fn integral_as_by_parabolic_cylinder_functions() {
        for (u, expected) in [
            (0.0, 0.6166342189968439),
            (0.5, 0.2404015706740721),
            (1.0, 0.08056233557081147),
            (1.5, 0.02286305602081809),
            (2.0, 5.423705197484414e-3),
            (2.5, 1.063688950133279e-3),
            (3.0, 1.708729962144244e-4),
            (3.5, 2.231240719823469e-5),
            (4.0, 2.353381052587606e-6),
            (6.0, 3.142968531919884e-11),
            (10.0, 7.501244003924727e-26),
            (20.0, 5.029667393262765e-92),
        ] {
            assert_relative_eq!(five_halves_integral(u), expected, max_relative = 1e-13);
        }
    }

    /// Computed by Gauss quadrature, recursions met to 1e-12: F_{3/2} and F_{5/2}, overlapping and apart.
    #[test]
    fn integrals_by_quadrature() {
        for (u, three_halves, five_halves) in [
            (-3.0, 5.41837728, 18.8113298),
            (-2.0, 3.11129289, 8.25754667),
            (-0.5, 0.82444842, 1.38222839),
            (0.0, 0.430019994, 0.616634219),
            (0.75, 0.12409268, 0.141962114),
            (1.0, 0.0756681774, 0.0805623356),
            (2.0, 0.00664817762, 0.0054237052),
            (2.25, 0.00320680438, 0.00246124137),
            (3.25, 0.000103230117, 6.3393096e-05),
            (4.0, 4.43915596e-06, 2.35338105e-06),
            (5.0, 3.03385056e-08, 1.352592e-08),
        ] {
            assert_relative_eq!(three_halves_integral(u), three_halves, max_relative = 1e-8);
            assert_relative_eq!(five_halves_integral(u), five_halves, max_relative = 1e-8);
        }
    }

    /// ∫_{-∞}^u Φ is the mean gap: against sums; F_1(0) = 1/√(2π); and the tail, φ/u².
    #[test]
    fn mean_gap_against_sums() {
        for u in [-3.0, -1.0, 0.0, 2.5] {
            let n = 40_000;
            let step = (u + 12.0) / f64::from(n);
            let sum: f64 = (0..n)
                .map(|i| step * share_apart(-12.0 + step * (f64::from(i) + 0.5)))
                .sum();
            assert_relative_eq!(mean_gap(u), sum, max_relative = 1e-6);
        }
        assert_relative_eq!(mean_gap(0.0), 1.0 / (2.0 * PI).sqrt(), max_relative = 1e-15);
        let (above, below) = (mean_gap(OVERLAP + 1e-9), mean_gap(OVERLAP - 1e-9));
        assert_relative_eq!(above, below, max_relative = 1e-3);
    }

    /// u = 0: half of the moment E(abs(s)^{5/2}) = 2^{5/4} Γ(7/4)/√π of a normal variable s.
    #[test]
    fn half_the_moment_of_a_normal_variable_where_mean_planes_meet() {
        // Γ(7/4), DLMF 5.4 and tables.
        const GAMMA_7_4: f64 = 0.919_062_526_848_883_2;
        let moment = 2f64.powf(1.25) * GAMMA_7_4 / PI.sqrt();
        assert_relative_eq!(
            five_halves_integral(0.0),
            0.5 * moment,
            max_relative = 1e-14
        );
    }

    /// dF_{5/2}/du = −5/2 F_{3/2}, positive and falling; large u: Γ(7/2) φ(u)/u^{7/2}.
    #[test]
    fn falls_as_the_tail_of_the_distribution() {
        let mut last = f64::INFINITY;
        for k in 0..390 {
            let value = five_halves_integral(0.1 * f64::from(k));
            assert!(value < last && value > 0.0 || value == 0.0, "{k}");
            last = value;
        }
        // Γ(7/2) = 15 √π/8; next term of the series −(63/8)/u² of the relative size.
        let u: f64 = 30.0;
        let tail = 15.0 * PI.sqrt() / 8.0 * (-0.5 * u * u).exp() / (2.0 * PI).sqrt() / u.powf(3.5);
        let relative = five_halves_integral(u) / tail - 1.0;
        assert_relative_eq!(relative, -63.0 / 8.0 / (u * u), max_relative = 0.02);
        assert_eq!(five_halves_integral(40.0), 0.0);
    }
}
