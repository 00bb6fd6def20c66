//! Shear-thinning laws against numbers computed elsewhere, their limits, and their derivatives.
//!
//! Numbers with ten and more digits: mpmath with 40 digits from the formulas as printed, the Carreau-Yasuda shear rate
//! by bracketing (Anderson-Björck) of `G η(γ̇) λγ̇/μ₁ = τ_e`.

use crate::common::near;
use approx::assert_relative_eq;
use ertel_rheology::shear::{
    Carreau, CarreauYasuda, Rabinowitsch, ReeEyring, ShearLaw, StressLimit,
};
use ertel_rheology::{ShearThinning, database};
use num_dual::{DualNum as _, HyperDual64};
use proptest::prelude::*;

const MPA: f64 = 1e6;

fn carreau(critical_stress: f64, n: f64, beta: f64, ratio: f64) -> ShearThinning {
    let law = Carreau::new(critical_stress, n, beta, ratio).unwrap();
    ShearThinning::of(ShearLaw::Carreau(law))
}

fn carreau_yasuda(shear_modulus: f64, n: f64, a: f64, ratio: f64) -> ShearThinning {
    let law = CarreauYasuda::new(shear_modulus, n, a, ratio).unwrap();
    ShearThinning::of(ShearLaw::CarreauYasuda(law))
}

fn eyring(stress: f64) -> ShearThinning {
    ShearThinning::of(ShearLaw::ReeEyring(ReeEyring::new(stress).unwrap()))
}

fn rabinowitsch(stress: f64, n: f64) -> ShearThinning {
    ShearThinning::of(ShearLaw::Rabinowitsch(
        Rabinowitsch::new(stress, n).unwrap(),
    ))
}

/// 5 MPa + 0.05 p: 30 MPa at 500 MPa.
fn limit() -> StressLimit {
    StressLimit::new(5.0 * MPA, 0.05).unwrap()
}

fn squalane() -> ShearThinning {
    carreau(1e4, 0.8, 2.198, 0.0157 / 0.0705)
}

/// μ₁/η at a stress (Pa), 500 MPa and 313 K.
fn fluidity(law: &ShearThinning, stress: f64) -> f64 {
    law.relative_fluidity(stress * stress, 500.0 * MPA)
}

/// Every law, every kind of limit, with and without second plateau.
fn laws() -> Vec<ShearThinning> {
    let limited = |law: ShearThinning| ShearThinning {
        limit: Some(limit()),
        ..law
    };
    vec![
        squalane(),
        carreau(3.1e4, 0.74, 2.0, 0.0),
        carreau(1e5, 0.3, 1.2, 1e-3),
        carreau(1e5, 0.5, 6.0, 0.0),
        carreau(1e5, 1.0, 2.0, 0.3),
        carreau(1e5, 0.5, 2.0, 1.0),
        carreau_yasuda(1e5, 0.5, 2.0, 0.01),
        carreau_yasuda(1e6, 0.3, 0.7, 0.0),
        carreau_yasuda(1e6, 0.8, 5.0, 0.4),
        carreau_yasuda(1e6, 1.0, 2.0, 0.4),
        eyring(5.0 * MPA),
        rabinowitsch(MPA, 1.0 / 3.0),
        rabinowitsch(MPA, 0.7),
        ShearThinning::limited(limit()),
        ShearThinning::limited(StressLimit::new(5.0 * MPA, 0.0).unwrap()),
        limited(squalane()),
        limited(eyring(5.0 * MPA)),
        limited(carreau_yasuda(1e6, 0.4, 2.0, 0.0)),
    ]
}

/// Habchi 2008, eq. 4.3.
#[test]
fn carreau_values() {
    for (stress, expected) in [
        (1e1, 1.0000000225166465),
        (1e3, 1.0005587499481574),
        (1e4, 1.0626180193284311),
        (1e5, 1.5163192956456175),
        (1e6, 2.134474795285849),
        (1e8, 3.328611898175133),
    ] {
        near(fluidity(&squalane(), stress), expected, 1e-13);
    }
    for (stress, expected) in [
        (1e1, 1.0000000182805067),
        (1e3, 1.0001827267200665),
        (3.1e4, 1.1294932708675138),
        (1e6, 3.389498076876157),
        (1e8, 17.090895455042478),
        (1e12, 434.68055778636693),
    ] {
        let pao = carreau(3.1e4, 0.74, 2.0, 0.0);
        assert_relative_eq!(fluidity(&pao, stress), expected, max_relative = 1e-13);
    }
}

/// Tables 4.1 and 4.2 of Habchi (2008). Section 4.5.1.2 says that squalane + PIP loses more than half of its viscosity
/// at 1 MPa; Habchi 2008, eq. 4.3, leaves 47 %.
#[test]
fn the_database_has_the_laws_of_the_thesis() {
    let at_1_mpa = |name: &str| {
        let fluid = database::fluid(name).unwrap();
        let law = fluid.shear_thinning.unwrap();
        assert_eq!(law.name(), "carreau");
        law.relative_fluidity(MPA * MPA, 0.0).recip()
    };
    near(at_1_mpa("squalane-pip"), 0.4684993246153932, 1e-12);
    near(at_1_mpa("pao-650"), 1.0 / 3.389498076876157, 1e-12);
    let newtonian = database::fluid("glycerol").unwrap();
    assert_eq!(newtonian.shear_thinning, None);
}

/// Theory: Carreau-Yasuda.
#[test]
fn carreau_yasuda_values() {
    let second = carreau_yasuda(1e5, 0.5, 2.0, 0.01);
    for (stress, expected) in [
        (1e3, 1.0000247502908042),
        (1e5, 1.267060026809313),
        (1e7, 38.540119165198966),
        (1e9, 90.57792868302421),
    ] {
        assert_relative_eq!(fluidity(&second, stress), expected, max_relative = 1e-13);
    }
    for (law, stress, expected) in [
        (carreau_yasuda(1e5, 0.8, 0.7, 0.0), 2e4, 1.0881114011187512),
        (carreau_yasuda(1e5, 0.3, 2.0, 0.0), 1e7, 46415.8883361303),
        (carreau_yasuda(1e5, 0.3, 2.0, 0.5), 1e7, 1.9513484749791303),
    ] {
        // The smoothing at zero stress changes the first of them by 1e-12.
        assert_relative_eq!(fluidity(&law, stress), expected, max_relative = 2e-12);
    }
}

/// Theory: Ree-Eyring.
#[test]
fn eyring_values() {
    let law = eyring(5.0 * MPA);
    for (stress, expected) in [
        (1e3, 1.0000000066666668),
        (1e6, 1.0066800127054698),
        (4.9e6, 1.1679311954479683),
        (5.1e6, 1.1826469724466764),
        (5e7, 1101.3232874703392),
        (5e8, 1.3440585709080677e41),
    ] {
        assert_relative_eq!(fluidity(&law, stress), expected, max_relative = 1e-13);
    }
}

/// Theory: Rabinowitsch and power laws.
#[test]
fn rabinowitsch_values() {
    let cubic = rabinowitsch(MPA, 1.0 / 3.0);
    assert_relative_eq!(fluidity(&cubic, 0.1 * MPA), 1.01, max_relative = 1e-14);
    assert_relative_eq!(fluidity(&cubic, 10.0 * MPA), 101.0, max_relative = 1e-14);
    let law = rabinowitsch(MPA, 0.7);
    near(fluidity(&law, 10.0 * MPA), 3.682695795279726, 1e-12);
}

/// Theory: Laws, Limiting stress.
#[test]
fn limiting_stress_values() {
    let law = ShearThinning::limited(limit());
    for (stress, expected) in [
        (1e5, 1.0000037037283953),
        (2.9e6, 1.0031323959603673),
        (3.1e6, 1.0035822376220507),
        (1e7, 1.039720770839918),
        (2.5e7, 1.4387371636790223),
        (2.99e7, 3.2083252164458775),
    ] {
        assert_relative_eq!(fluidity(&law, stress), expected, max_relative = 1e-14);
    }
    // The fluidities of a law and of the limit multiply.
    let both = ShearThinning {
        limit: Some(limit()),
        ..eyring(5.0 * MPA)
    };
    assert_relative_eq!(
        fluidity(&both, 1e7),
        1.039720770839918 * f64::sinh(2.0) / 2.0,
        max_relative = 1e-12
    );
}

/// Near the limit the exponential takes over with the value and two derivatives of the inverse hyperbolic tangent,
/// and keeps the stress within a few per cent of the limit.
///
/// Theory: Laws, Limiting stress.
#[test]
fn the_limit_continues_smoothly() {
    let limit = StressLimit::new(1.0, 0.0).unwrap();
    // r A(r) = atanh r by r² is smooth; derivatives of the factor at r² on both sides of 0.999².
    let at = |square: f64| {
        let dual = limit.factor(HyperDual64::new(square, 1.0, 1.0, 0.0), 0.0.into());
        [dual.re, dual.eps1, dual.eps1eps2]
    };
    let square = 0.999 * 0.999;
    let (below, above) = (at(square * (1.0 - 1e-12)), at(square * (1.0 + 1e-12)));
    for (a, b) in below.into_iter().zip(above) {
        assert_relative_eq!(a, b, max_relative = 1e-8);
    }
    let flow = |r: f64| r * limit.factor(r * r, 0.0);
    assert_relative_eq!(flow(0.999), 0.5 * 1999.0_f64.ln(), max_relative = 1e-12);
    for (target, most) in [(1e3, 1.0067), (1e6, 1.0136), (1e12, 1.028)] {
        assert!(flow(most) > target, "{}", flow(most));
    }
    assert!(flow(1.0066) < 1e3 && flow(1.0135) < 1e6);
}

/// A softened limit is the inverse hyperbolic tangent up to its joint, continues with the same value and two derivatives, and
/// its shear rate grows e-fold per (1 − r₁²)/(2r₁) far beyond: γ̇ ~ e^{(r − r₁)/ε}/(2r₁).
#[test]
fn a_softened_limit_continues_smoothly() {
    for joint in [0.5, 0.92, 0.992] {
        let limit = StressLimit::new(1.0, 0.0).unwrap().softened(joint);
        let at = |square: f64| {
            let dual = limit.factor(HyperDual64::new(square, 1.0, 1.0, 0.0), 0.0.into());
            [dual.re, dual.eps1, dual.eps1eps2]
        };
        let square = joint * joint;
        let (below, above) = (at(square * (1.0 - 1e-12)), at(square * (1.0 + 1e-12)));
        for (a, b) in below.into_iter().zip(above) {
            assert_relative_eq!(a, b, max_relative = 1e-8);
        }
        let flow = |r: f64| r * limit.factor(r * r, 0.0);
        assert_relative_eq!(flow(0.4), 0.4_f64.atanh(), max_relative = 1e-12);
        let fold = (1.0 - square) / (2.0 * joint);
        let far = joint + 20.0 * fold;
        assert_relative_eq!(flow(far), 20f64.exp() / (2.0 * joint), max_relative = 1e-7);
    }
}

#[test]
fn the_limiting_stress_follows_the_pressure() {
    let limit = limit();
    assert_eq!(limit.limiting_stress(0.0), 5.0 * MPA);
    assert_eq!(limit.limiting_stress(500.0 * MPA), 30.0 * MPA);
    // Below ambient: the straight line up to the third order, and never zero.
    assert_relative_eq!(limit.limiting_stress(-MPA), 4.95 * MPA, max_relative = 2e-6);
    for p in [-50.0, -100.0, -1e4] {
        assert!(limit.limiting_stress(p * MPA) > 0.0);
    }
}

/// Newtonian at zero stress, as at equal plateaus, and at exponent 1.
#[test]
fn newtonian_limits_of_the_laws() {
    for law in laws() {
        assert_eq!(fluidity(&law, 0.0), 1.0, "{law:?}");
    }
    for law in [
        carreau(1e4, 0.5, 2.2, 1.0),
        carreau(1e4, 1.0, 2.2, 0.2),
        carreau_yasuda(1e4, 0.5, 2.2, 1.0),
        carreau_yasuda(1e4, 1.0, 2.2, 0.2),
    ] {
        for stress in [1.0, 1e4, 1e9] {
            assert_relative_eq!(fluidity(&law, stress), 1.0, max_relative = 1e-14);
        }
        assert_eq!(law.newtonian_limits(0.0), [None, None]);
    }
}

/// Far beyond the knee: the second plateau, or the power of the exponent.
#[test]
fn closed_limits_at_high_stress() {
    for law in [
        carreau(1e4, 0.2, 2.198, 0.01),
        carreau_yasuda(1e4, 0.2, 2.0, 0.01),
    ] {
        assert_relative_eq!(fluidity(&law, 1e20), 100.0, max_relative = 1e-11);
    }
    // η/μ₁ = (τ/G)^(1 - 1/n) in all power laws.
    for law in [
        carreau(1e4, 0.4, 2.198, 0.0),
        carreau_yasuda(1e4, 0.4, 1.3, 0.0),
        rabinowitsch(1e4, 0.4),
    ] {
        let power = f64::powf(1e10, 1.5);
        assert_relative_eq!(fluidity(&law, 1e14), power, max_relative = 1e-9);
    }
}

/// Ree-Eyring: τ = τ₀ asinh(μγ̇/τ₀), from far below τ₀ to far above; any other law: τ φ(τ²) = μγ̇, with the sign of the rate.
#[test]
fn stresses_at_shear_rates() {
    for rate in [-1e5, 1e-9, 3.0, 1e6, 1e30_f64] {
        let expected = 5e6 * (10.0 * rate / 5e6).asinh();
        near(eyring(5e6).stress(10.0, 1e9, rate), expected, 1e-9);
    }
    for law in laws() {
        assert_eq!(law.stress(10.0, 0.0, 0.0), 0.0);
        for rate in [-1e3, 1e6] {
            let stress = law.stress(10.0, 500.0 * MPA, rate);
            let product = stress * fluidity(&law, stress);
            assert_relative_eq!(product, 10.0 * rate, max_relative = 1e-8);
        }
    }
    let limited = ShearThinning::limited(StressLimit::new(20e6, 0.05).unwrap());
    let stress = limited.stress(1e6, 1e9, 1e9);
    let limit = 20e6 + 0.05 * 1e9;
    assert!(stress > 0.9 * limit && stress < 1.1 * limit, "{stress}");
}

/// Theory: Newtonian limits.
#[test]
fn stresses_at_the_newtonian_limits() {
    let limits = |law: &ShearThinning| law.newtonian_limits(500.0 * MPA);
    let close = |found: Option<f64>, expected: f64| {
        assert_relative_eq!(found.unwrap(), expected, max_relative = 1e-11);
    };
    let [first, second] = limits(&squalane());
    close(first, 9004.700886704899);
    close(second, 237489059142.35673);
    let [first, second] = limits(&carreau_yasuda(1e5, 0.5, 2.0, 0.01));
    close(first, 45595.24538769457);
    // Closed form: 1.05 μ₂ at λγ̇ = (0.99/0.0005)² to eight digits.
    assert_relative_eq!(second.unwrap(), 4116419999.999866, max_relative = 1e-11);
    for (law, expected) in [
        (carreau(3.1e4, 0.74, 2.0, 0.0), 18051.279116685626),
        (eyring(5.0 * MPA), 2788009.9310314874),
        (rabinowitsch(MPA, 1.0 / 3.0), 229415.73387056176),
        (ShearThinning::limited(limit()), 11384556.200342694),
    ] {
        let [first, second] = limits(&law);
        close(first, expected);
        assert_eq!(second, None);
    }
    // 237 GPa is beyond the limiting stress of 30 MPa.
    let cut = ShearThinning {
        limit: Some(limit()),
        ..squalane()
    };
    let [first, second] = limits(&cut);
    assert_relative_eq!(first.unwrap(), 9004.7, max_relative = 1e-4);
    assert_eq!(second, None);
}

#[test]
fn scales_and_dependence() {
    let scales = |law: &ShearThinning| law.scales(500.0 * MPA);
    assert_eq!(scales(&squalane()).knee, Some(1e4));
    assert_eq!(scales(&carreau_yasuda(1e5, 0.5, 2.0, 0.0)).knee, Some(1e5));
    assert_eq!(scales(&rabinowitsch(1e6, 0.5)).knee, Some(1e6));
    assert_eq!(scales(&eyring(5e6)).growth, Some(5e6));
    let limited = ShearThinning::limited(limit());
    assert_eq!(scales(&limited).limit, Some(30.0 * MPA));
    assert!(limited.depends_on_pressure());
    assert!(!squalane().depends_on_pressure());
    let constant = ShearThinning::limited(StressLimit::new(5.0 * MPA, 0.0).unwrap());
    assert!(!constant.depends_on_pressure());
}

#[test]
fn impossible_constants_are_rejected() {
    let key = |error: ertel_rheology::LawError| error.key();
    assert_eq!(key(Carreau::new(0.0, 0.8, 2.0, 0.1).unwrap_err()), "g_c");
    assert_eq!(key(Carreau::new(1e4, 0.0, 2.0, 0.1).unwrap_err()), "n");
    assert_eq!(key(Carreau::new(1e4, 1.1, 2.0, 0.1).unwrap_err()), "n");
    assert_eq!(key(Carreau::new(1e4, 0.8, 0.0, 0.1).unwrap_err()), "beta_c");
    assert_eq!(key(Carreau::new(1e4, 0.8, 2.0, 1.1).unwrap_err()), "mu_2");
    assert_eq!(
        key(CarreauYasuda::new(f64::NAN, 0.8, 2.0, 0.1).unwrap_err()),
        "g"
    );
    assert_eq!(
        key(CarreauYasuda::new(1e5, 0.8, -2.0, 0.1).unwrap_err()),
        "a"
    );
    assert_eq!(key(ReeEyring::new(-1.0).unwrap_err()), "tau_0");
    assert_eq!(key(Rabinowitsch::new(1e6, 1.0).unwrap_err()), "n");
    assert_eq!(key(StressLimit::new(0.0, 0.05).unwrap_err()), "tau_l0");
    assert_eq!(key(StressLimit::new(5e6, -0.1).unwrap_err()), "lambda");
}

/// Smoothing at zero stress, from the documented formula: `u = r² (r² + δ)^(k/2 - 1)`, `δ = 1e-12`, has at zero the
/// derivatives `δ^(k/2 - 1)` and `(k - 2) δ^(k/2 - 2)` by r², and the fluidity is `1 + c u` there.
///
/// Theory: Zero stress.
#[test]
fn derivatives_at_zero_stress_are_finite() {
    let at_zero = |law: &ShearThinning, scale: f64| {
        let square = HyperDual64::new(0.0, 1.0, 1.0, 0.0) * (scale * scale);
        let phi = law.relative_fluidity(square, 0.0.into());
        [phi.re, phi.eps1, phi.eps1eps2]
    };
    for (law, scale, k, c) in [
        (
            carreau(1e4, 0.8, 2.198, 0.25),
            1e4,
            2.198,
            0.75 * 0.25 / 2.198,
        ),
        (carreau(1e4, 0.5, 1.5, 0.0), 1e4, 1.5, 1.0 / 1.5),
        (
            carreau_yasuda(1e5, 0.5, 2.7, 0.2),
            1e5,
            2.7,
            0.8 * 0.5 / 2.7,
        ),
        (rabinowitsch(1e6, 0.25), 1e6, 3.0, 1.0),
        (rabinowitsch(1e6, 0.5), 1e6, 1.0, 1.0),
    ] {
        let delta: f64 = 1e-12;
        let [value, first, second] = at_zero(&law, scale);
        assert_eq!(value, 1.0);
        assert_relative_eq!(first, c * delta.powf(0.5 * k - 1.0), max_relative = 1e-10);
        near(second, c * (k - 2.0) * delta.powf(0.5 * k - 2.0), 1e-4);
    }
    // sinh y/y = 1 + y²/6 + y⁴/120; atanh r/r = 1 + r²/3 + r⁴/5.
    let [_, first, second] = at_zero(&eyring(5e6), 5e6);
    assert_relative_eq!(first, 1.0 / 6.0, max_relative = 1e-14);
    assert_relative_eq!(second, 1.0 / 60.0, max_relative = 1e-14);
    let [_, first, second] = at_zero(&ShearThinning::limited(limit()), 5e6);
    assert_relative_eq!(first, 1.0 / 3.0, max_relative = 1e-14);
    assert_relative_eq!(second, 2.0 / 5.0, max_relative = 1e-14);
}

/// Where the exponential becomes a parabola, value and two derivatives by τ_e² join: at `τ = 150 τ₀` of the sinh law.
#[test]
fn the_end_of_the_exponential_is_smooth() {
    let at = |share: f64| {
        let square = HyperDual64::new(share * 150.0 * 150.0, 1.0, 1.0, 0.0);
        let phi = eyring(1.0).relative_fluidity(square, 0.0.into());
        [phi.re, phi.eps1, phi.eps1eps2]
    };
    for (below, above) in at(1.0 - 1e-10).into_iter().zip(at(1.0 + 1e-10)) {
        assert_relative_eq!(below, above, max_relative = 1e-6);
    }
}

/// No stress that a Newton iterate can have makes a number that is none.
#[test]
fn absurd_stresses_stay_finite() {
    for law in laws() {
        let mut last = 0.0;
        for decade in -30..=30 {
            let stress = f64::powi(10.0, decade);
            let square = HyperDual64::new(stress * stress, stress * stress, 0.3, 0.0);
            let pressure = HyperDual64::new(1e9, 0.0, 1e9, 0.0);
            let phi = law.relative_fluidity(square, pressure);
            for number in [phi.re, phi.eps1, phi.eps2, phi.eps1eps2] {
                assert!(number.is_finite(), "{law:?} at {stress}: {phi}");
            }
            assert!(phi.re >= last * (1.0 - 1e-14), "{law:?} at {stress}");
            assert!(phi.re >= 1.0 - 1e-14);
            last = phi.re;
        }
    }
}

/// Whether the third derivative jumps close by: where the exponential beyond the limiting stress begins, and where
/// exponentials become parabolas.
fn near_a_join(law: &ShearThinning, stress: f64, pressure: f64) -> bool {
    let near = |ratio: f64, join: f64| (ratio / join - 1.0).abs() < 1e-4;
    let scales = law.scales(pressure);
    let parabola = 0.999 + 150.0 * (1.0 - 0.999 * 0.999) / (2.0 * 0.999);
    scales
        .limit
        .is_some_and(|limit| near(stress / limit, 0.999) || near(stress / limit, parabola))
        || scales
            .growth
            .is_some_and(|growth| near(stress / growth, 150.0))
}

/// Exact derivatives of `ln(μ₁/η)` by `ln τ_e²` and pressure (100 MPa), against central
/// differences of fourth order. Their truncation error is 1e-21 fifth derivatives, which are up to 1e14 times the first
/// near a limiting stress; rounding leaves 1e-11.
fn check_derivatives(law: &ShearThinning, x: [f64; 2]) -> Result<(), TestCaseError> {
    const STEP: f64 = 1e-5;
    if near_a_join(law, (0.5 * x[0]).exp(), 1e8 * x[1]) {
        return Ok(());
    }
    let f = |x: [HyperDual64; 2]| {
        let phi = law.relative_fluidity(x[0].exp(), x[1] * 1e8);
        phi.ln()
    };
    let seeded = |i: usize, j: usize, x: [f64; 2]| {
        let mut dual = x.map(HyperDual64::from);
        dual[i].eps1 = 1.0;
        dual[j].eps2 = 1.0;
        f(dual)
    };
    for i in 0..2 {
        for j in 0..2 {
            let moved = |by: f64| {
                let mut at = x;
                at[j] += by;
                seeded(i, j, at)
            };
            let [p, pp, m, mm] = [1.0, 2.0, -1.0, -2.0].map(|n| moved(n * STEP));
            let difference = |f: fn(&HyperDual64) -> f64| {
                (8.0 * (f(&p) - f(&m)) - (f(&pp) - f(&mm))) / (12.0 * STEP)
            };
            let (first, second) = (difference(|f| f.re), difference(|f| f.eps1));
            let exact = seeded(i, j, x);
            let size = exact.re.abs().max(exact.eps2.abs()).max(1.0);
            prop_assert!(
                (exact.eps2 - first).abs() < 1e-6 * size,
                "{law:?} at {x:?}: first by {j}: {} and {first}",
                exact.eps2
            );
            let size = size.max(exact.eps1.abs()).max(exact.eps1eps2.abs());
            prop_assert!(
                (exact.eps1eps2 - second).abs() < 1e-6 * size,
                "{law:?} at {x:?}: second by {i} and {j}: {} and {second}",
                exact.eps1eps2
            );
        }
    }
    Ok(())
}

/// A law with constants anywhere within what a case file may give.
fn extreme_law() -> impl Strategy<Value = ShearThinning> {
    let decades = |from: f64, to: f64| (from..=to).prop_map(|x: f64| 10.0_f64.powf(x));
    let ratio = || prop_oneof![Just(0.0), decades(-49.999, 0.0)];
    let exponent = || prop_oneof![Just(0.01), 0.01..1.0_f64];
    let width = || prop_oneof![Just(0.2), Just(50.0), 0.2..50.0_f64];
    let stress = || decades(-2.999, 19.999);
    let limit = (stress(), 0.0..=10.0_f64).prop_map(|(s, l)| StressLimit::new(s, l).unwrap());
    let law = prop_oneof![
        (stress(), exponent(), width(), ratio()).prop_map(|(g, n, a, r)| carreau(g, n, a, r)),
        (stress(), exponent(), width(), ratio())
            .prop_map(|(g, n, a, r)| carreau_yasuda(g, n, a, r)),
        stress().prop_map(eyring),
        (stress(), exponent()).prop_map(|(s, n)| rabinowitsch(s, n)),
    ];
    (law, proptest::option::of(limit)).prop_map(|(law, limit)| ShearThinning { limit, ..law })
}

/// `ln(1 + exp x)`.
fn ln_one_plus_exp(x: f64) -> f64 {
    if x > 0.0 {
        x + (-x).exp().ln_1p()
    } else {
        x.exp().ln_1p()
    }
}

/// `ln(μ₁/η)` of a law without limit at the logarithm of a stress (Pa), from the formula of the law as it is written; that
/// of Carreau and Yasuda by bisection for the logarithm of the shear rate.
fn ln_fluidity(law: &ShearLaw, ln_stress: f64) -> f64 {
    let thinned = |r: f64, ln_power: f64| -(r + (1.0 - r) * ln_power.exp()).ln();
    match law {
        ShearLaw::Carreau(law) => {
            let bracket = ln_one_plus_exp(law.transition * (ln_stress - law.critical_stress.ln()));
            let outer = (law.exponent.recip() - 1.0) / law.transition;
            if law.plateau_ratio == 0.0 {
                return outer * bracket;
            }
            thinned(law.plateau_ratio, -outer * bracket)
        }
        ShearLaw::CarreauYasuda(law) => {
            let ln_relative = ln_stress - law.shear_modulus.ln();
            // ln η/μ₁ at ln λγ̇.
            let ln_eta = |ln_rate: f64| {
                let ln_power = (law.exponent - 1.0) / law.transition
                    * ln_one_plus_exp(law.transition * ln_rate);
                match law.plateau_ratio {
                    0.0 => ln_power,
                    r => -thinned(r, ln_power),
                }
            };
            let (mut low, mut high) = (-1e4, 1e6);
            for _ in 0..200 {
                let middle = 0.5 * (low + high);
                if ln_eta(middle) + middle > ln_relative {
                    high = middle;
                } else {
                    low = middle;
                }
            }
            high - ln_relative
        }
        ShearLaw::ReeEyring(law) => {
            let y = (ln_stress - law.eyring_stress.ln()).exp();
            if y < 1e-4 {
                return y * y / 6.0;
            }
            y + (-(-2.0 * y).exp()).ln_1p() - (2.0 * y).ln()
        }
        ShearLaw::Rabinowitsch(law) => {
            let m = law.exponent.recip() - 1.0;
            ln_one_plus_exp(m * (ln_stress - law.critical_stress.ln()))
        }
    }
}

/// A solver's iterate may be no number: no law panics, and what follows is no number either.
#[test]
fn a_stress_that_is_no_number_gives_none() {
    for law in laws() {
        for stress in [f64::NAN, f64::INFINITY] {
            let phi = law.relative_fluidity(stress, 0.0);
            assert!(!phi.is_finite() || stress.is_infinite(), "{law:?}: {phi}");
        }
        assert!(
            !law.relative_fluidity(HyperDual64::from(f64::NAN), 1e9.into())
                .re
                .is_finite()
        );
        let _ = law.newtonian_limits(f64::NAN);
    }
}

/// Constants for which the numbers of a law would leave floating point are refused, with what is allowed.
#[test]
fn constants_far_from_any_lubricant_are_refused() {
    for (error, key, allowed) in [
        (
            Carreau::new(1e-200, 0.5, 2.0, 0.0).unwrap_err(),
            "g_c",
            "1e-3 Pa",
        ),
        (Carreau::new(1e5, 1e-5, 2.0, 0.0).unwrap_err(), "n", "0.01"),
        (
            Carreau::new(1e5, 0.5, 1e-3, 0.0).unwrap_err(),
            "beta_c",
            "0.2 and 50",
        ),
        (
            CarreauYasuda::new(1e200, 0.5, 2.0, 0.0).unwrap_err(),
            "g",
            "1e20 Pa",
        ),
        (
            CarreauYasuda::new(1e5, 0.5, 0.05, 0.0).unwrap_err(),
            "a",
            "0.2 and 50",
        ),
        (
            CarreauYasuda::new(1e5, 0.5, 1e4, 0.0).unwrap_err(),
            "a",
            "0.2 and 50",
        ),
        (ReeEyring::new(1e-9).unwrap_err(), "tau_0", "1e-3 Pa"),
        (Rabinowitsch::new(1e6, 1e-3).unwrap_err(), "n", "0.01"),
        (
            StressLimit::new(1e6, 1e200).unwrap_err(),
            "lambda",
            "0 and 10",
        ),
    ] {
        assert_eq!(error.key(), key);
        assert!(error.to_string().contains(allowed), "{error}");
    }
}

proptest! {
    /// From far below the first plateau's end to far beyond any limit.
    #[test]
    fn derivatives_are_exact(
        ln_stress in -5.0..25.0_f64,
        pressure in -0.5..20.0_f64,
    ) {
        for law in laws() {
            check_derivatives(&law, [2.0 * ln_stress, pressure])?;
        }
    }

    /// As above, within a few per cent of a limiting stress.
    #[test]
    fn derivatives_are_exact_near_the_limit(
        share in 0.9..1.05_f64,
        pressure in 0.0..20.0_f64,
    ) {
        let ln_stress = (share * limit().limiting_stress(pressure * 1e8)).ln();
        for law in laws() {
            check_derivatives(&law, [2.0 * ln_stress, pressure])?;
        }
    }

    /// Carreau-Yasuda: the fluidity gives back the stress through the law as it is written, in shear rate.
    ///
    /// Theory: Carreau-Yasuda.
    #[test]
    fn carreau_yasuda_is_inverted_to_round_off(
        ln_stress in -12.0..18.0_f64,
        n in 0.05..1.0_f64,
        a in 0.3..6.0_f64,
        ratio in prop_oneof![Just(0.0), 1e-6..1.0_f64],
    ) {
        let law = carreau_yasuda(1.0, n, a, ratio);
        let stress = ln_stress.exp();
        let phi = law.relative_fluidity(stress * stress, 0.0);
        // Beyond, the fluidity is a parabola of its logarithm.
        prop_assume!(phi < 1e65);
        let rate = phi * stress;
        // The power by its logarithm, which does not overflow.
        let ln_power = a * rate.ln();
        let bracket = if ln_power > 0.0 {
            ln_power + (-ln_power).exp().ln_1p()
        } else {
            ln_power.exp().ln_1p()
        };
        let eta = ratio + (1.0 - ratio) * ((n - 1.0) / a * bracket).exp();
        // Smoothing at zero stress moves the power by (1 - a/2) 1e-12/rate².
        let smoothing = 1e-11 / (rate * rate) * rate.powf(a).min(1.0);
        prop_assert!((eta * rate / stress - 1.0).abs() < 1e-12 + smoothing);
    }

    /// Any constants that a case file may give, and any stress: finite with two derivatives, never below the last, and
    /// equal to the formula.
    #[test]
    fn extreme_constants_are_sound(law in extreme_law(), ln_stress in -30.0..69.0_f64) {
        let at = |ln_stress: f64| {
            let square = (2.0 * ln_stress).exp();
            let square = HyperDual64::new(square, square, square, 0.0);
            law.relative_fluidity(square, HyperDual64::new(1e9, 0.0, 1e6, 0.0))
        };
        let phi = at(ln_stress);
        for number in [phi.re, phi.eps1, phi.eps2, phi.eps1eps2] {
            prop_assert!(number.is_finite(), "{law:?}: {phi}");
        }
        prop_assert!(at(ln_stress + 0.1).re >= phi.re * (1.0 - 1e-12));
        // Below ambient the limit is lowest.
        prop_assert!(law.relative_fluidity((2.0 * ln_stress).exp(), -1e9).is_finite());
        let alone = law.law.as_ref().unwrap();
        let found = alone.relative_fluidity((2.0 * ln_stress).exp());
        let expected = ln_fluidity(alone, ln_stress);
        // Smoothing at zero stress moves the power by (1 - k/2) 1e-12/r², r the stress or rate over that of the knee;
        // beyond 1e65 the fluidity continues as a parabola.
        let smoothing = law.scales(0.0).knee.map_or(0.0, |knee| {
            let ln_rate = match alone {
                ShearLaw::CarreauYasuda(_) => expected,
                _ => 0.0,
            };
            50.0 * 1e-12 / (2.0 * (ln_stress + ln_rate - knee.ln())).exp()
        });
        if expected < 140.0 && smoothing < 1e-3 {
            let tolerance = 1e-9 * expected.max(1.0) + smoothing * expected;
            prop_assert!(
                (found.ln() - expected).abs() < tolerance,
                "{law:?}: {} and {expected}", found.ln()
            );
        }
        for stress in law.newtonian_limits(1e9).into_iter().flatten() {
            prop_assert!(stress.is_finite() && stress > 0.0);
        }
    }
}

/// Constants of each law in the order of its constructor, and back.
#[test]
fn constants_make_the_same_law() {
    let limit = StressLimit::new(3e6, 0.05).unwrap();
    let laws = [
        (
            ShearLaw::Carreau(Carreau::new(1e4, 0.8, 2.2, 0.22).unwrap()),
            vec![1e4, 0.8, 2.2, 0.22],
        ),
        (
            ShearLaw::CarreauYasuda(CarreauYasuda::new(1e5, 0.5, 2.0, 0.1).unwrap()),
            vec![1e5, 0.5, 2.0, 0.1],
        ),
        (ShearLaw::ReeEyring(ReeEyring::new(5e6).unwrap()), vec![5e6]),
        (
            ShearLaw::Rabinowitsch(Rabinowitsch::new(1e6, 0.4).unwrap()),
            vec![1e6, 0.4],
        ),
    ];
    for (law, constants) in laws {
        let law = ShearThinning {
            law: Some(law),
            limit: Some(limit.clone()),
        };
        assert_eq!(law.constants(), [&constants[..], &[3e6, 0.05]].concat());
        assert_eq!(law.with_constants(&law.constants()).unwrap(), law);
        let mut impossible = law.constants();
        impossible[0] = -1.0;
        assert!(law.with_constants(&impossible).is_err());
    }
}
