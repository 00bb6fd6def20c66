//! The laws for measurements at high pressure from text, with values of `tests/high_pressure_laws.rs`.

use approx::assert_relative_eq;

use super::Files;
use crate::{DensityLaw, Fluid};
use ertel_input::{Document, InputError};

const T9: &str = "{ law = 'murnaghan', rho_0 = '872 kg/m^3', k_0r = '9.234 GPa', k_0r_prime = 10.545, \
     reference_temperature = '298 K', beta_k = '6.09e-3 1/K', beta_k_prime = '0 1/K', a_v = '7.734e-4 1/K' }";
const CONSTANT: &str = "{ law = 'constant', mu_0 = '10 mPa.s' }";

fn fluid(text: &str) -> Result<Fluid, InputError> {
    let document = Document::parse("case.toml", text)?;
    let mut root = document.root();
    let fluid = Fluid::from_table(&mut root, "lubricant", Files::Embedded(&[]))?;
    root.finish()?;
    Ok(fluid)
}

fn viscosity(law: &str, p: f64, t: f64) -> Result<f64, InputError> {
    let fluid = fluid(&format!("density = {T9}\nviscosity = {{ {law} }}"))?;
    Ok(fluid.viscosity(p, t))
}

fn refused(law: &str) -> InputError {
    viscosity(law, 0.0, 300.0).unwrap_err()
}

fn close(value: f64, expected: f64) {
    assert_relative_eq!(value, expected, max_relative = 1e-9);
}

#[test]
fn they_are_read_in_si() {
    let yasutomi = "law = 'yasutomi', mu_g = '1e12 Pa.s', t_g0 = '-71.7 degC', a_1 = '210.6 K', a_2 = '0.455 1/GPa', \
                    b_1 = '7.606 1/GPa', b_2 = -0.4193, c_1 = 16.372, c_2 = '29.99 K'";
    close(viscosity(yasutomi, 0.5e9, 313.15).unwrap(), 1332.249146709);
    let mcewen = "law = 'mcewen', mu_0 = '40 mPa.s', alpha = '20 1/GPa', q = 8";
    close(viscosity(mcewen, 0.5e9, 300.0).unwrap(), 26.273633422852);
    let paluch = "law = 'paluch', mu_inf = '2.78e-14 Pa.s', c_f = 27.5, p_inf = '2.73 GPa'";
    close(viscosity(paluch, 1e9, 311.0).unwrap(), 195284.62388374);
    let hybrid = "law = 'mcewen-paluch', mu_0 = '30 mPa.s', a_0 = '12 1/GPa', q = 3, c_f = 20, p_inf = '3 GPa'";
    close(viscosity(hybrid, 1e9, 300.0).unwrap(), 82599.246730525);
    let walther = fluid(
        "density = { law = 'dowson-higginson', rho_0 = '870 kg/m^3', reference_temperature = '15 degC', \
         beta = '6.4e-4 1/K' }\n\
         viscosity = { law = 'walther', a = 9.324708845456, b = 3.64706450923, alpha = '20 1/GPa', \
         reference_temperature = '40 degC', pressure = 'roelands' }",
    )
    .unwrap();
    close(walther.viscosity(0.5e9, 353.15), 3.15726434909);
    assert_eq!(walther.viscosity.reference_temperature(), Some(313.15));
}

#[test]
fn thermal_properties_follow_the_density() {
    let text = format!(
        "density = {T9}\nviscosity = {CONSTANT}\n\
         thermal_conductivity = {{ law = 'scaling', b = '0.053 W/(m.K)', c = '0.026 W/(m.K)', s = 7.6, a = -0.101, \
         q = 3, reference_temperature = '298 K' }}\n\
         heat_capacity = {{ law = 'scaling', rho_c_0 = '1.17 MJ/(m^3.K)', m = '0.39 MJ/(m^3.K)', \
         reference_temperature = '298 K' }}"
    );
    let mut fluid = fluid(&text).unwrap();
    let k = |fluid: &Fluid| {
        fluid
            .thermal_conductivity
            .clone()
            .unwrap()
            .conductivity(1e9, 313.15)
    };
    let c = |fluid: &Fluid| {
        fluid
            .heat_capacity
            .clone()
            .unwrap()
            .heat_capacity(1e9, 313.15)
    };
    close(k(&fluid), 0.2330732288245);
    close(c(&fluid), 1945.362020665);
    // A case that replaces the density by one that does not change: volume one, and temperature is left.
    let document = Document::parse(
        "case.toml",
        "density = { law = 'constant', rho_0 = '872 kg/m^3' }",
    )
    .unwrap();
    fluid
        .override_from(&mut document.root(), Files::Embedded(&[]))
        .unwrap();
    assert!(matches!(fluid.density, Some(DensityLaw::Constant(_))));
    let warmth = 313.15 / 298.0;
    close(
        k(&fluid),
        0.053 + 0.026 * (1.0_f64 - 0.101 * warmth).powf(-7.6),
    );
    close(c(&fluid), (1.17e6 + 0.39e6 * warmth) / 872.0);
}

#[test]
fn errors_name_the_problem() {
    for (law, key, part) in [
        (
            "law = 'mcewen', mu_0 = '1 mPa.s', alpha = '2 1/GPa', q = 0",
            "viscosity.q",
            "positive",
        ),
        (
            "law = 'paluch', mu_0 = '1 mPa.s', mu_inf = '1 mPa.s', c_f = 20, p_inf = '3 GPa'",
            "viscosity.mu_inf",
            "give one of them",
        ),
        (
            "law = 'paluch', mu_0 = '1 mPa.s', c_f = 20",
            "viscosity.p_inf",
            "missing key",
        ),
        (
            "law = 'mcewen-paluch', mu_0 = '1 mPa.s', a_0 = '1 GPa', q = 3, c_f = 20, p_inf = '3 GPa'",
            "viscosity.a_0",
            "1/GPa",
        ),
        (
            "law = 'walther', a = 9, b = 3.5, alpha = '2 1/GPa', reference_temperature = '40 degC', pressure = 'barrus'",
            "viscosity.pressure",
            "barus",
        ),
    ] {
        let error = refused(law);
        assert_eq!((error.line(), error.key()), (Some(2), key), "{error}");
        assert!(error.to_string().contains(part), "{error}");
    }
    let error = fluid(
        "viscosity = { law = 'walther', a = 9, b = 3.5, alpha = '2 1/GPa', reference_temperature = '40 degC' }",
    )
    .unwrap_err();
    assert!(error.message().contains("needs a density law"), "{error}");
}
