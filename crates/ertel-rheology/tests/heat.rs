//! Laws of conductivity and heat capacity: values computed outside, exact derivatives against differences, and
//! positive numbers wherever a solver may stray.

use crate::common::{near, t9_density};
use approx::assert_relative_eq;
use ertel_rheology::conductivity;
use ertel_rheology::density::{DowsonHigginson, ThermalExpansion};
use ertel_rheology::heat_capacity::{self, VolumetricConstants};
use ertel_rheology::property::LinearFactor;
use ertel_rheology::{ConductivityLaw, DensityLaw, HeatCapacityLaw, Isotherms, LawError};
use num_dual::{Dual64, DualVec64, first_derivative};
use proptest::prelude::*;

fn density() -> DensityLaw {
    let thermal = ThermalExpansion {
        reference_temperature: 300.0,
        temperature_coefficient: 7e-4,
    };
    DensityLaw::DowsonHigginson(DowsonHigginson::new(870.0, Some(thermal)).unwrap())
}

fn constants() -> VolumetricConstants {
    VolumetricConstants {
        rho_c_0: 1.71e6,
        reference_temperature: 295.0,
        beta_0: 6.5e-4,
        b_1: 2.7e-9,
        b_2: -1.5e-18,
        k_1: 0.47e-9,
        k_2: 0.81e-9,
    }
}

/// Isotherms of a smooth function of p and T.
fn knots(scale: f64) -> (Vec<f64>, Vec<Vec<f64>>, Vec<Vec<f64>>) {
    let temperatures = vec![280.0, 300.0, 330.0, 370.0];
    let pressures: Vec<f64> = vec![0.0, 0.05e9, 0.1e9, 0.2e9, 0.4e9, 0.7e9, 1e9];
    let value = |p: f64, t: f64| scale * (1.0 + 0.9e-9 * p - 1e-3 * (t - 300.0));
    let values = temperatures
        .iter()
        .map(|t| pressures.iter().map(|p| value(*p, *t)).collect());
    (
        temperatures.clone(),
        vec![pressures.clone(); 4],
        values.collect(),
    )
}

fn conductivity_laws() -> Vec<ConductivityLaw> {
    let (t, p, v) = knots(0.13);
    vec![
        ConductivityLaw::constant(0.29).unwrap(),
        ConductivityLaw::linear(0.13, LinearFactor::new(313.0, -1.2e-3, 0.8e-9).unwrap()).unwrap(),
        ConductivityLaw::LarssonAndersson(
            conductivity::LarssonAndersson::new(0.137, 1.72e-9, 0.54e-9).unwrap(),
        ),
        ConductivityLaw::Table(Isotherms::held(t, p, v).unwrap()),
        ConductivityLaw::Scaling(
            conductivity::Scaling::new(
                conductivity::ScalingConstants {
                    b: 0.053,
                    c: 0.026,
                    s: 7.6,
                    a: -0.101,
                    q: 3.0,
                    reference_temperature: 298.0,
                },
                t9_density(),
            )
            .unwrap(),
        ),
    ]
}

fn heat_capacity_laws() -> Vec<HeatCapacityLaw> {
    let (t, p, v) = knots(1700.0);
    vec![
        HeatCapacityLaw::constant(2400.0).unwrap(),
        HeatCapacityLaw::linear(1700.0, LinearFactor::new(313.0, 1.5e-3, -0.1e-9).unwrap())
            .unwrap(),
        HeatCapacityLaw::LarssonAndersson(
            heat_capacity::LarssonAndersson::new(constants(), density()).unwrap(),
        ),
        HeatCapacityLaw::Table(Isotherms::held(t, p, v).unwrap()),
        HeatCapacityLaw::Scaling(
            heat_capacity::Scaling::new(
                heat_capacity::ScalingConstants {
                    rho_c_0: 1.17e6,
                    m: 0.39e6,
                    w: 4.0,
                    reference_temperature: 298.0,
                },
                t9_density(),
            )
            .unwrap(),
        ),
    ]
}

/// By mpmath with 20 digits from the formulas, at 0.7 GPa and 350 K.
///
/// Theory: Conductivity and heat capacity, Constant.
/// Theory: Conductivity and heat capacity, Linear.
/// Theory: Larsson and Andersson.
#[test]
fn values_at_one_state() {
    let k: Vec<f64> = conductivity_laws()
        .iter()
        .map(|law| law.conductivity(0.7e9, 350.0))
        .collect();
    assert_relative_eq!(k[0], 0.29);
    assert_relative_eq!(k[1], 0.197028, max_relative = 1e-12);
    assert_relative_eq!(k[2], 0.256701015965167, max_relative = 1e-12);
    let c: Vec<f64> = heat_capacity_laws()
        .iter()
        .map(|law| law.heat_capacity(0.7e9, 350.0))
        .collect();
    assert_relative_eq!(c[0], 2400.0);
    assert_relative_eq!(c[1], 1675.35, max_relative = 1e-12);
    assert_relative_eq!(c[2], 2214.25406792291, max_relative = 1e-12);
    let HeatCapacityLaw::LarssonAndersson(law) = &heat_capacity_laws()[2] else {
        panic!("the third law is per volume");
    };
    near(law.volumetric(0.7e9, 350.0), 2228423.77734525, 1e-12);
}

/// The data of a table are linear in p and T, so that monotone cubics return them between the knots, too.
///
/// Theory: Conductivity and heat capacity, Table.
#[test]
fn tables_return_linear_data() {
    let (k, c) = (&conductivity_laws()[3], &heat_capacity_laws()[3]);
    for (p, t) in [
        (0.03e9, 290.0),
        (0.55e9, 345.0),
        (0.99e9, 281.0),
        (0.4e9, 330.0),
    ] {
        let share = 1.0 + 0.9 * (p / 1e9) - 1e-3 * (t - 300.0);
        assert_relative_eq!(k.conductivity(p, t), 0.13 * share, max_relative = 1e-12);
        assert_relative_eq!(c.heat_capacity(p, t), 1700.0 * share, max_relative = 1e-12);
    }
    // The corner values hold beyond, without slope.
    let corner = 0.13 * (1.0 + 0.9 - 0.07);
    let (value, slope): (f64, f64) =
        first_derivative(|p: Dual64| k.conductivity(p, 500.0.into()), 3e9);
    assert_relative_eq!(value, corner, max_relative = 1e-12);
    assert_eq!(slope, 0.0);
    assert_eq!(k.tabulated_range(), Some([(0.0, 1e9), (280.0, 370.0)]));
}

#[test]
fn impossible_constants_are_refused() {
    let key = |error: LawError| error.key();
    for bad in [0.0, -0.1, f64::NAN, f64::INFINITY] {
        assert_eq!(key(ConductivityLaw::constant(bad).unwrap_err()), "k_0");
        assert_eq!(key(HeatCapacityLaw::constant(bad).unwrap_err()), "c_0");
        let (t, p, mut v) = knots(0.13);
        v[1][2] = bad;
        assert_eq!(
            key(Isotherms::held(t.clone(), p.clone(), v.clone()).unwrap_err()),
            "values"
        );
        assert_eq!(key(Isotherms::held(t, p, v).unwrap_err()), "values");
        let constants = VolumetricConstants {
            rho_c_0: bad,
            ..constants()
        };
        let law = heat_capacity::LarssonAndersson::new(constants, density());
        assert_eq!(key(law.unwrap_err()), "rho_c_0");
    }
    let law = conductivity::LarssonAndersson::new(0.1, 1e-9, -1e-9);
    assert_eq!(key(law.unwrap_err()), "d_2");
    assert_eq!(
        key(LinearFactor::new(0.0, 0.0, 0.0).unwrap_err()),
        "reference_temperature"
    );
    assert_eq!(
        key(LinearFactor::new(300.0, f64::NAN, 0.0).unwrap_err()),
        "a_t"
    );
    // A row without pressures, which a table over temperature alone is not.
    let law = Isotherms::held(vec![300.0], vec![vec![]], vec![vec![]]);
    assert_eq!(key(law.unwrap_err()), "pressure");
}

/// Exact slopes in GPa and 100 K against central differences of step 1e-4: truncation and rounding stay below 1e-7 of
/// the value where the law is smooth.
fn check_slopes(
    f: impl Fn(
        DualVec64<nalgebra::Const<2>>,
        DualVec64<nalgebra::Const<2>>,
    ) -> DualVec64<nalgebra::Const<2>>,
    p: f64,
    t: f64,
) -> Result<(), TestCaseError> {
    let value = |p: f64, t: f64| f((p * 1e9).into(), (t * 100.0).into()).re;
    let (_, slopes) = num_dual::gradient(
        |x: nalgebra::SVector<DualVec64<nalgebra::Const<2>>, 2>| f(x[0] * 1e9, x[1] * 100.0),
        &nalgebra::SVector::from([p, t]),
    );
    let step = 1e-4;
    let size = value(p, t);
    let difference = [
        (value(p + step, t) - value(p - step, t)) / (2.0 * step),
        (value(p, t + step) - value(p, t - step)) / (2.0 * step),
    ];
    for (exact, difference) in slopes.iter().zip(difference) {
        prop_assert!(
            (exact - difference).abs() < 1e-6 * size,
            "{exact} {difference} at {p} {t}"
        );
    }
    Ok(())
}

proptest! {
    #[test]
    fn slopes_are_exact(p in 0.01..0.99_f64, t in 2.81..3.69_f64) {
        for law in conductivity_laws() {
            check_slopes(|p, t| law.conductivity(p, t), p, t)?;
        }
        for law in heat_capacity_laws() {
            check_slopes(|p, t| law.heat_capacity(p, t), p, t)?;
        }
    }

    /// Newton iterates may be anywhere; neither property may vanish or change sign there.
    #[test]
    fn both_stay_positive(p in -1.0..20.0_f64, t in 100.0..1500.0_f64) {
        for law in conductivity_laws() {
            let k = law.conductivity(p * 1e9, t);
            prop_assert!(k > 0.01 && k < 1e3, "{law:?}: {k}");
        }
        // The density of Dowson and Higginson falls to zero at 1700 K, and is singular in tension.
        if (0.0..20.0).contains(&p) {
            for law in heat_capacity_laws() {
                let c = law.heat_capacity(p * 1e9, t);
                prop_assert!(c > 50.0 && c < 1e6, "{law:?}: {c}");
            }
        }
    }
}
