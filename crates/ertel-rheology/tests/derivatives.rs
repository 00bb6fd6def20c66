//! Exact derivatives of every law against central differences, and the behaviour of tables, on random states.

use crate::common::{gear_oil, hybrid, near, softening, squalane, wlf_oil};
use ertel_rheology::density::{DowsonHigginson, Murnaghan, Tait, TaitVolume, ThermalExpansion};
use ertel_rheology::viscosity::{
    Cheng, Hybrid, ImprovedYasutomi, McEwen, Paluch, PressureLaw, Roelands, TemperatureSlope,
    Walther,
};
use ertel_rheology::{DensityLaw, Isotherms, ViscosityLaw};
use num_dual::{HyperDual64, second_derivative, second_partial_derivative};
use proptest::prelude::*;

fn volume() -> TaitVolume {
    let thermal = softening([313.0, 0.006765, 0.0018, 7.52e-4]);
    TaitVolume::new(8.375e9, 7.0, Some(thermal)).unwrap()
}

/// A smooth table: the knots are those of `ln μ = -7 + 20 p - 0.03 (T - 300) - 4 p²`, p in GPa.
fn table_knots() -> (Vec<f64>, Vec<Vec<f64>>, Vec<Vec<f64>>) {
    let temperatures = vec![280.0, 300.0, 330.0, 370.0];
    let pressures: Vec<f64> = vec![0.0, 0.05, 0.1, 0.2, 0.4, 0.7, 1.0];
    let values = temperatures
        .iter()
        .map(|t| {
            pressures
                .iter()
                .map(|p| (-7.0 + 20.0 * p - 0.03 * (t - 300.0) - 4.0 * p * p).exp())
                .collect()
        })
        .collect();
    let pressures: Vec<f64> = pressures.iter().map(|p| p * 1e9).collect();
    (temperatures, vec![pressures; 4], values)
}

fn viscosity_laws() -> Vec<ViscosityLaw> {
    let (t, p, v) = table_knots();
    vec![
        ViscosityLaw::constant(0.04).unwrap(),
        ViscosityLaw::barus(0.04, 15e-9).unwrap(),
        ViscosityLaw::Cheng(Cheng::new(0.268e-3, -4.567e-9, 959.02, 1940.72e-9, 272.65).unwrap()),
        ViscosityLaw::Roelands(
            Roelands::from_alpha(
                0.04,
                22e-9,
                Roelands::PRESSURE_CONSTANT,
                Some(TemperatureSlope {
                    reference_temperature: 313.0,
                    beta: 0.04,
                }),
            )
            .unwrap(),
        ),
        wlf_oil(),
        squalane(volume()),
        ViscosityLaw::ImprovedYasutomi(ImprovedYasutomi::new(gear_oil()).unwrap()),
        ViscosityLaw::McEwen(McEwen::new(0.04, 20e-9, 8.0).unwrap()),
        ViscosityLaw::Paluch(Paluch::new(0.024, 27.5, 2.73e9).unwrap()),
        ViscosityLaw::Hybrid(Hybrid::new(hybrid()).unwrap()),
        walther(PressureLaw::Roelands, 0.0),
        walther(PressureLaw::Barus, 0.0),
        walther(PressureLaw::Roelands, -0.8),
        walther(PressureLaw::Barus, -2.5),
        ViscosityLaw::Table(Isotherms::of_logarithms(t, p, v).unwrap()),
    ]
}

fn walther(pressure: PressureLaw, alpha_exponent: f64) -> ViscosityLaw {
    let thermal = ThermalExpansion {
        reference_temperature: 288.15,
        temperature_coefficient: 6.4e-4,
    };
    let density = DensityLaw::DowsonHigginson(DowsonHigginson::new(870.0, Some(thermal)).unwrap());
    let (a, b) = Walther::constants([(313.15, 46e-6), (373.15, 6.9e-6)]);
    let law = Walther {
        a,
        b,
        density,
        alpha: 20e-9,
        reference_temperature: 313.15,
        alpha_exponent,
        pressure,
    };
    ViscosityLaw::Walther(Walther::new(law).unwrap())
}

fn density_laws() -> Vec<DensityLaw> {
    let (t, p, v) = table_knots();
    let thermal = ThermalExpansion {
        reference_temperature: 300.0,
        temperature_coefficient: 7e-4,
    };
    vec![
        DensityLaw::constant(870.0).unwrap(),
        DensityLaw::DowsonHigginson(DowsonHigginson::new(870.0, Some(thermal)).unwrap()),
        DensityLaw::Tait(Tait::new(818.0, volume()).unwrap()),
        DensityLaw::Murnaghan(Murnaghan::new(872.0, 9.234e9, 10.545, volume().thermal).unwrap()),
        DensityLaw::Table(Isotherms::straight(t, p, v).unwrap()),
    ]
}

/// Compares exact first and second derivatives with central differences of the value and of the first derivative.
///
/// `f` maps (pressure in GPa, temperature in 100 K), so that both are of order one. A central difference with step 1e-4
/// has a truncation error of about 1e-8 times the third derivative, which is below a few 1e3 times the value here.
fn check_derivatives(
    f: impl Fn(HyperDual64, HyperDual64) -> HyperDual64,
    p: f64,
    t: f64,
) -> Result<(), TestCaseError> {
    let step = 1e-4;
    let value = |p: f64, t: f64| f(p.into(), t.into()).re;
    let gradient = |p: f64, t: f64| {
        let (_, f_p, f_t, f_pt) = second_partial_derivative(|(p, t)| f(p, t), (p, t));
        (f_p, f_t, f_pt)
    };
    let second = |p: f64, t: f64| {
        // Both partials of a hyper-dual number along the same variable give the second derivative.
        let p_twice = HyperDual64::new(p, 1.0, 1.0, 0.0);
        let t_twice = HyperDual64::new(t, 1.0, 1.0, 0.0);
        (f(p_twice, t.into()).eps1eps2, f(p.into(), t_twice).eps1eps2)
    };
    let scale = value(p, t).abs();
    let close = |what: &str, exact: f64, difference: f64, scale: f64| {
        prop_assert!(
            (exact - difference).abs() <= 2e-4 * scale.max(exact.abs()),
            "{what} at p = {p}, t = {t}: exact {exact}, difference {difference}"
        );
        Ok(())
    };
    let central = |plus: f64, minus: f64| (plus - minus) / (2.0 * step);
    let (f_p, f_t, f_pt) = gradient(p, t);
    let (f_pp, f_tt) = second(p, t);
    close(
        "df/dp",
        f_p,
        central(value(p + step, t), value(p - step, t)),
        scale,
    )?;
    close(
        "df/dt",
        f_t,
        central(value(p, t + step), value(p, t - step)),
        scale,
    )?;
    let slope = scale.max(f_p.abs()).max(f_t.abs());
    // Where a law passes into another with its slope alone, at its glass transition, the second derivative is that of the side.
    let by_sides = |what: &str, exact: f64, gradient: &dyn Fn(f64) -> f64| {
        let short = 1e-6;
        let here = gradient(0.0);
        let differences = [
            central(gradient(step), gradient(-step)),
            (gradient(short) - here) / short,
            (here - gradient(-short)) / short,
        ];
        let near = |d: &f64| (exact - d).abs() <= 2e-4 * slope.max(exact.abs());
        prop_assert!(
            differences.iter().any(near),
            "{what} at p = {p}, t = {t}: exact {exact}, differences {differences:?}"
        );
        Ok(())
    };
    by_sides("d2f/dp2", f_pp, &|d| gradient(p + d, t).0)?;
    by_sides("d2f/dt2", f_tt, &|d| gradient(p, t + d).1)?;
    by_sides("d2f/dpdt", f_pt, &|d| gradient(p, t + d).0)
}

/// Away from the knots of the table, where the second derivative jumps.
fn between_knots(p: f64, t: f64) -> bool {
    let apart = |knots: &[f64], x: f64| knots.iter().all(|knot| (knot - x).abs() > 2e-4);
    apart(&[0.0, 0.05, 0.1, 0.2, 0.4, 0.7, 1.0], p) && apart(&[2.8, 3.0, 3.3, 3.7], t)
}

proptest! {
    /// Theory: Viscosity, Constant.
    #[test]
    fn viscosity_derivatives_are_exact(p in -0.005..1.2_f64, t in 2.6..3.9_f64) {
        prop_assume!(between_knots(p, t));
        for law in viscosity_laws() {
            check_derivatives(|p, t| law.ln_viscosity(p * 1e9, t * 100.0), p, t)?;
            // The same through the exponential, along pressure only: the values span many decades.
            let (mu, mu_p, mu_pp) = second_derivative(|p| law.viscosity(p * 1e9, (t * 100.0).into()), p);
            let (_, ln_p, ln_pp) = second_derivative(|p| law.ln_viscosity(p * 1e9, (t * 100.0).into()), p);
            prop_assert!((mu_p - mu * ln_p).abs() <= 1e-9 * mu_p.abs());
            prop_assert!((mu_pp - mu * (ln_pp + ln_p * ln_p)).abs() <= 1e-9 * mu_pp.abs().max(mu));
        }
    }

    /// Theory: Density, Constant.
    #[test]
    fn density_derivatives_are_exact(p in -0.005..1.2_f64, t in 2.6..3.9_f64) {
        prop_assume!(between_knots(p, t));
        for law in density_laws() {
            check_derivatives(|p, t| law.density(p * 1e9, t * 100.0), p, t)?;
        }
    }

    /// Data that grow with pressure are interpolated without a dip, also between knots far apart.
    #[test]
    fn a_table_is_monotone_and_exact_at_its_knots(
        steps in prop::collection::vec((1e-3..1.0_f64, 1e-6..3.0_f64), 2..8),
    ) {
        let (mut pressure, mut ln_mu) = (0.0, -5.0);
        let (mut pressures, mut values) = (vec![0.0], vec![f64::exp(-5.0)]);
        for (dp, growth) in steps {
            pressure += dp * 1e8;
            ln_mu += growth;
            pressures.push(pressure);
            values.push(f64::exp(ln_mu));
        }
        let table = Isotherms::of_logarithms(vec![300.0], vec![pressures.clone()], vec![values.clone()]).unwrap();
        let law = ViscosityLaw::Table(table);
        for (p, value) in pressures.iter().zip(&values) {
            prop_assert!((law.viscosity(*p, 300.0) / value - 1.0).abs() < 1e-12);
        }
        let mut last = law.ln_viscosity(-1e7, 300.0);
        for i in 0..=400 {
            let next = law.ln_viscosity(-1e7 + 1.2 * pressure * f64::from(i) / 400.0, 300.0);
            prop_assert!(next >= last - 1e-12);
            last = next;
        }
    }
}

/// Theory: Viscosity, Table.
#[test]
fn a_table_is_exact_at_every_isotherm_and_linear_outside() {
    let (temperatures, pressures, values) = table_knots();
    let law = ViscosityLaw::Table(
        Isotherms::of_logarithms(temperatures.clone(), pressures.clone(), values.clone()).unwrap(),
    );
    for (i, t) in temperatures.iter().enumerate() {
        for (p, value) in pressures[i].iter().zip(&values[i]) {
            approx::assert_relative_eq!(law.viscosity(*p, *t), *value, max_relative = 1e-12);
        }
    }
    // Linear in T by construction of the data: exact between and outside isotherms too.
    for t in [270.0, 290.0, 317.0, 400.0] {
        let expected = -7.0 + 20.0 * 0.4 - 0.03 * (t - 300.0) - 4.0 * 0.16;
        approx::assert_relative_eq!(law.ln_viscosity(0.4e9, t), expected, max_relative = 1e-12);
    }
    // A straight line above the last pressure.
    let at = |p: f64| law.ln_viscosity(p, 300.0);
    approx::assert_relative_eq!(at(3e9) - at(2e9), at(2e9) - at(1e9), max_relative = 1e-12);
    assert_eq!(law.tabulated_range(), Some([(0.0, 1e9), (280.0, 370.0)]));
}

/// Independent evaluation of the Fritsch-Butland interpolant: slopes and values worked out by hand as fractions.
///
/// Theory: Viscosity, Table.
#[test]
fn a_table_follows_the_published_interpolant() {
    // Knots x = 0, 1, 3; y = 0, 1, 2: secants 1, 1/2; widths 1, 2.
    // d0 = ((2·1 + 2)·1 - 1·1/2)/3 = 7/6;  d1 = (5 + 4)/(5/1 + 4/(1/2)) = 9/13;  d2 = ((2·2 + 1)/2 - 2·1)/3 = 1/6.
    // At x = 1/2: 1/2 + (7/6 - 9/13)/8.  At x = 2: 3/2 + 2 (9/13 - 1/6)/8.
    let e = |y: f64| (1.0 + y).exp();
    let table = Isotherms::of_logarithms(
        vec![300.0],
        vec![vec![0.0, 1.0, 3.0]],
        vec![vec![e(0.0), e(1.0), e(2.0)]],
    )
    .unwrap();
    let law = ViscosityLaw::Table(table);
    let y = |x: f64| law.ln_viscosity(x, 300.0) - 1.0;
    near(y(0.5), 0.5 + (7.0 / 6.0 - 9.0 / 13.0) / 8.0, 1e-12);
    near(y(2.0), 1.5 + 2.0 * (9.0 / 13.0 - 1.0 / 6.0) / 8.0, 1e-12);
    approx::assert_relative_eq!(y(5.0), 2.0 + 2.0 / 6.0, max_relative = 1e-12);
    approx::assert_relative_eq!(y(-1.0), -7.0 / 6.0, max_relative = 1e-12);
}

/// A point within 1e-4 of a glass transition, where the second derivative of a law jumps.
#[test]
fn viscosity_derivatives_at_a_glass_transition() {
    let (p, t) = (1.0440303879180661, 2.833068685549382);
    for law in viscosity_laws() {
        check_derivatives(|p, t| law.ln_viscosity(p * 1e9, t * 100.0), p, t).unwrap();
    }
}
