//! The laws of Murnaghan, improved Yasutomi, McEwen, Paluch, their hybrid and Walther, and thermal properties by
//! scaling: values by mpmath at 30 digits from the formulas, written independently of this code, limits, and constants
//! that are refused.

use crate::common::{gear_oil, hybrid, near, t9_density};
use approx::assert_relative_eq;
use ertel_rheology::conductivity::{self, Scaling as ConductivityScaling};
use ertel_rheology::density::{DowsonHigginson, Murnaghan, ThermalExpansion};
use ertel_rheology::heat_capacity::{self, Scaling as HeatCapacityScaling};
use ertel_rheology::viscosity::{Hybrid, ImprovedYasutomi, McEwen, Paluch, PressureLaw, Walther};
use ertel_rheology::{ConductivityLaw, DensityLaw, HeatCapacityLaw, LawError, ViscosityLaw};
use num_dual::first_derivative;

const GPA: f64 = 1e9;

fn expanding() -> DensityLaw {
    let thermal = ThermalExpansion {
        reference_temperature: 288.15,
        temperature_coefficient: 6.4e-4,
    };
    DensityLaw::DowsonHigginson(DowsonHigginson::new(870.0, Some(thermal)).unwrap())
}

fn walther(pressure: PressureLaw) -> Walther {
    let (a, b) = Walther::constants([(313.15, 46e-6), (373.15, 6.9e-6)]);
    Walther {
        a,
        b,
        density: expanding(),
        alpha: 20e-9,
        reference_temperature: 313.15,
        alpha_exponent: 0.0,
        pressure,
    }
}

fn slope(law: &ViscosityLaw, pressure: f64, temperature: f64) -> f64 {
    first_derivative(|p| law.ln_viscosity(p, temperature.into()), pressure).1
}

fn close(value: f64, expected: f64) {
    assert_relative_eq!(value, expected, max_relative = 1e-10);
}

/// Theory: Murnaghan.
#[test]
fn murnaghan() {
    let law = t9_density();
    close(law.density(0.0, 298.0), 872.0);
    close(law.density(GPA, 313.15), 1058.04323564727);
    close(law.density(0.5 * GPA, 373.15), 984.752936484343);
    let isotherm = Murnaghan::new(1000.0, 1.2e9, 10.0, None).unwrap();
    close(isotherm.density(0.3 * GPA, 300.0), 1133.4615816707);
    // The bulk modulus ρ dp/dρ is K₀ + K₀' p.
    let law = DensityLaw::Murnaghan(isotherm);
    let (rho, rho_p) = first_derivative(|p| law.density(p, 300.0.into()), 0.3 * GPA);
    close(rho / rho_p, 1.2e9 + 10.0 * 0.3 * GPA);
    assert!(!law.depends_on_temperature() && t9_density().depends_on_temperature());
}

/// Theory: Improved Yasutomi.
#[test]
fn improved_yasutomi() {
    let law = ViscosityLaw::ImprovedYasutomi(ImprovedYasutomi::new(gear_oil()).unwrap());
    close(law.viscosity(0.0, 313.15), 0.1232990290917);
    close(law.viscosity(0.5 * GPA, 313.15), 1332.249146709);
    close(law.viscosity(GPA, 373.15), 776.8027003939);
    close(law.viscosity(0.0, 373.15), 0.01147887140287);
    close(law.pressure_viscosity_slope(313.15), 2.54616263826e-8);
}

/// At the glass transition the viscosity is μ_g by definition; beyond it the law keeps growing with a continuous slope.
///
/// Theory: Improved Yasutomi.
#[test]
fn improved_yasutomi_beyond_the_glass_transition() {
    let law = ViscosityLaw::ImprovedYasutomi(gear_oil());
    for temperature in [313.15, 373.15, 190.0] {
        let limit = gear_oil().limiting_pressure(temperature);
        assert_relative_eq!(law.viscosity(limit, temperature), 1e12, max_relative = 1e-9);
        if limit > 0.0 {
            let before = slope(&law, limit - 1.0, temperature);
            assert!(before > 0.0);
            near(before, slope(&law, limit + 1.0, temperature), 1e-6);
        }
        let mut last = law.ln_viscosity(limit, temperature);
        for i in 1..50 {
            let next = law.ln_viscosity(limit + 0.1 * GPA * f64::from(i), temperature);
            assert!(next > last);
            last = next;
        }
    }
    close(gear_oil().limiting_pressure(313.15), 1537569098.9585);
}

/// Theory: McEwen.
#[test]
fn mcewen() {
    let law = ViscosityLaw::McEwen(McEwen::new(0.04, 20e-9, 8.0).unwrap());
    close(law.viscosity(0.5 * GPA, 300.0), 26.273633422852);
    close(law.viscosity(GPA, 300.0), 900.75015625);
    close(law.pressure_viscosity_slope(300.0), 20e-9);
    // 1/α* = ∫ (1 + α p/q)^(-q) dp = q/(α (q - 1)); the rest of the integral beyond the largest pressure is below 1e-10.
    let asymptotic = law.pressure_viscosity_reciprocal_asymptotic(300.0).unwrap();
    assert_relative_eq!(asymptotic, 20e-9 * 7.0 / 8.0, max_relative = 1e-8);
    // Barus in the limit.
    let steep = McEwen::new(0.04, 20e-9, 1e9).unwrap();
    let barus = ViscosityLaw::barus(0.04, 20e-9).unwrap();
    near(
        steep.ln_viscosity(GPA, 300.0),
        barus.ln_viscosity(GPA, 300.0),
        1e-7,
    );
}

/// The first constants are those of a mineral oil in a public program.
///
/// Theory: Paluch.
#[test]
fn paluch() {
    let law = ViscosityLaw::Paluch(Paluch::from_factor(2.78e-14, 27.5, 2.73e9).unwrap());
    close(law.viscosity(0.0, 311.0), 0.024386139186662);
    close(law.viscosity(0.5 * GPA, 311.0), 11.613624192687);
    close(law.viscosity(GPA, 311.0), 195284.62388374);
    close(law.pressure_viscosity_slope(311.0), 1.007326007326e-8);
    let asymptotic = law.pressure_viscosity_reciprocal_asymptotic(311.0).unwrap();
    assert_relative_eq!(asymptotic, 1.078246926173e-8, max_relative = 1e-8);
}

/// Theory: hybrid.
#[test]
fn hybrid_of_both() {
    let law = ViscosityLaw::Hybrid(Hybrid::new(hybrid()).unwrap());
    close(law.viscosity(0.2 * GPA, 300.0), 0.73006152027432);
    close(law.viscosity(GPA, 300.0), 82599.246730525);
    close(law.pressure_viscosity_slope(300.0), 18.666666666667e-9);
    let asymptotic = law.pressure_viscosity_reciprocal_asymptotic(300.0).unwrap();
    assert_relative_eq!(asymptotic, 1.686080281465e-8, max_relative = 1e-7);
    // An inflection: the slope falls first and rises later.
    let slopes = [0.0, 0.4, 2.0].map(|p| slope(&law, p * GPA, 300.0));
    assert!(slopes[1] < slopes[0] && slopes[2] > slopes[1], "{slopes:?}");
    // Without McEwen's factor it is the law of Paluch.
    let alone = Hybrid::new(Hybrid {
        a_0: 0.0,
        ..hybrid()
    })
    .unwrap();
    let paluch = Paluch::new(0.03, 20.0, 3e9).unwrap();
    for p in [0.0, 0.7 * GPA, 2.9 * GPA, 8.0 * GPA] {
        close(alone.ln_viscosity(p, 300.0), paluch.ln_viscosity(p, 300.0));
    }
}

/// Beyond p∞ the formula itself is negative or infinite; the law keeps growing, and joins with value and slope.
#[test]
fn the_divergence_is_continued() {
    for law in [
        ViscosityLaw::Paluch(Paluch::new(0.03, 20.0, 3e9).unwrap()),
        ViscosityLaw::Hybrid(hybrid()),
    ] {
        let mut last = law.ln_viscosity(0.0, 300.0);
        for i in 1..400 {
            let next = law.ln_viscosity(0.02 * GPA * f64::from(i), 300.0);
            assert!(next > last && next.is_finite());
            last = next;
        }
        // ln(μ/μ₀) = 300 of the diverging factor at p = 3 GPa · 300/320.
        let join = 3e9 * 300.0 / 320.0;
        let at = |p: f64| (law.ln_viscosity(p, 300.0), slope(&law, p, 300.0));
        let (before, after) = (at(join * (1.0 - 1e-9)), at(join * (1.0 + 1e-9)));
        assert_relative_eq!(before.0, after.0, max_relative = 1e-6);
        assert_relative_eq!(before.1, after.1, max_relative = 1e-6);
    }
}

/// Theory: Walther.
#[test]
fn walther_over_temperature() {
    let law = walther(PressureLaw::Roelands);
    close(law.a, 9.324708845456);
    close(law.b, 3.64706450923);
    for (temperature, nu) in [
        (293.15, 132.223136647),
        (313.15, 46.0),
        (353.15, 11.234533054),
        (373.15, 6.9),
        (423.15, 2.9042868657),
    ] {
        near(law.kinematic_viscosity(temperature) * 1e6, nu, 1e-9);
    }
    // Below 2 mm²/s with the exponential term, whose approximate inverse is off by 4e-5 here.
    let (a, b) = Walther::constants([(313.15, 3.7e-6), (373.15, 1.3e-6)]);
    let thin = Walther { a, b, ..law };
    close(thin.kinematic_viscosity(373.15) * 1e6, 1.30004650305);
    close(thin.kinematic_viscosity(413.15) * 1e6, 0.834108429259);
}

/// Theory: Walther.
#[test]
fn walther_over_pressure() {
    let law = ViscosityLaw::Walther(Walther::new(walther(PressureLaw::Roelands)).unwrap());
    let close =
        |value: f64, expected: f64| assert_relative_eq!(value, expected, max_relative = 1e-9);
    close(law.viscosity(0.0, 313.15), 0.03937968);
    close(law.viscosity(0.5 * GPA, 313.15), 70.6308247329);
    close(law.viscosity(0.5 * GPA, 353.15), 3.15726434909);
    close(law.pressure_viscosity_slope(313.15), 20e-9);
    let barus = ViscosityLaw::Walther(walther(PressureLaw::Barus));
    close(
        barus.viscosity(0.5 * GPA, 313.15),
        0.03937968 * 10_f64.exp(),
    );
    // At one temperature it is the law of Roelands.
    let roelands = ViscosityLaw::roelands(0.03937968, 20e-9).unwrap();
    close(law.viscosity(GPA, 313.15), roelands.viscosity(GPA, 313.15));
    // Far outside, where a solver may stray: finite, and never falling with pressure.
    for temperature in [100.0, 200.0, 700.0, 1500.0] {
        let [low, high] = [0.0, GPA].map(|p| law.ln_viscosity(p, temperature));
        assert!(
            low.is_finite() && high.is_finite() && high >= low,
            "{temperature}"
        );
    }
}

fn conductivity_constants() -> conductivity::ScalingConstants {
    conductivity::ScalingConstants {
        b: 0.053,
        c: 0.026,
        s: 7.6,
        a: -0.101,
        q: 3.0,
        reference_temperature: 298.0,
    }
}

fn heat_capacity_constants() -> heat_capacity::ScalingConstants {
    heat_capacity::ScalingConstants {
        rho_c_0: 1.17e6,
        m: 0.39e6,
        w: 4.0,
        reference_temperature: 298.0,
    }
}

/// Theory: Scaling.
#[test]
fn thermal_properties_by_scaling() {
    let law = ConductivityScaling::new(conductivity_constants(), t9_density()).unwrap();
    let k = ConductivityLaw::Scaling(law);
    let law = HeatCapacityScaling::new(heat_capacity_constants(), t9_density()).unwrap();
    let c = HeatCapacityLaw::Scaling(law);
    for (p, t, conductivity, heat_capacity) in [
        (0.0, 298.0, 0.1113982308845, 1788.990825688),
        (GPA, 313.15, 0.2330732288245, 1945.362020665),
        (0.4 * GPA, 353.15, 0.1714754556821, 1938.621626362),
    ] {
        close(k.conductivity(p, t), conductivity);
        close(c.heat_capacity(p, t), heat_capacity);
    }
    // Wherever a solver may stray: positive and not enormous.
    for t in [100.0, 298.0, 700.0, 1500.0] {
        for p in [-1.0, 0.0, 1.0, 20.0] {
            let k = k.conductivity(p * GPA, t);
            assert!(k > 0.05 && k < 100.0, "{p} {t}: {k}");
        }
    }
    // In tension as at ambient pressure.
    close(
        k.conductivity(-0.2 * GPA, 298.0),
        k.conductivity(0.0, 298.0),
    );
}

#[test]
fn impossible_constants_are_refused() {
    let key = |error: LawError| error.key();
    assert_eq!(
        key(Murnaghan::new(0.0, 1e9, 10.0, None).unwrap_err()),
        "rho_0"
    );
    assert_eq!(
        key(Murnaghan::new(1e3, -1e9, 10.0, None).unwrap_err()),
        "k_0r"
    );
    assert_eq!(
        key(Murnaghan::new(1e3, 1e9, 0.0, None).unwrap_err()),
        "k_0r_prime"
    );
    let growing = ImprovedYasutomi {
        b_2: 0.4,
        ..gear_oil()
    };
    let error = ImprovedYasutomi::new(growing).unwrap_err();
    assert!(error.to_string().contains("it must be negative"), "{error}");
    let mut frozen = gear_oil();
    frozen.glass.c_2 = -30.0;
    assert_eq!(key(ImprovedYasutomi::new(frozen).unwrap_err()), "c_2");
    assert_eq!(key(McEwen::new(0.04, 2e-8, 0.0).unwrap_err()), "q");
    assert_eq!(key(McEwen::new(0.04, -2e-8, 8.0).unwrap_err()), "alpha");
    assert_eq!(key(Paluch::new(0.04, 0.0, 3e9).unwrap_err()), "c_f");
    assert_eq!(key(Paluch::new(0.04, 20.0, 0.0).unwrap_err()), "p_inf");
    assert_eq!(
        key(Paluch::from_factor(f64::NAN, 20.0, 3e9).unwrap_err()),
        "mu_inf"
    );
    let negative = Hybrid {
        a_0: -1e-9,
        ..hybrid()
    };
    assert_eq!(key(Hybrid::new(negative).unwrap_err()), "a_0");
    let law = walther(PressureLaw::Roelands);
    let falling = Walther {
        b: -1.0,
        ..law.clone()
    };
    assert_eq!(key(Walther::new(falling).unwrap_err()), "b");
    let vapour = Walther { a: 20.0, ..law };
    assert_eq!(key(Walther::new(vapour).unwrap_err()), "a");
    let bad = conductivity::ScalingConstants {
        a: -0.6,
        ..conductivity_constants()
    };
    assert_eq!(
        key(ConductivityScaling::new(bad, t9_density()).unwrap_err()),
        "a"
    );
    let bad = heat_capacity::ScalingConstants {
        m: -1.0,
        ..heat_capacity_constants()
    };
    assert_eq!(
        key(HeatCapacityScaling::new(bad, t9_density()).unwrap_err()),
        "m"
    );
}
