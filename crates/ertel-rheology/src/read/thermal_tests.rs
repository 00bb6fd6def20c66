//! Laws of conductivity and heat capacity from text, of lubricants and solids.

use approx::assert_relative_eq;

use super::Files;
use crate::provenance::{Datum, Status};
use crate::{DensityLaw, Fluid, HeatCapacityLaw, Solid};
use ertel_input::{Document, InputError};

const NO_FILES: Files<'_> = Files::Embedded(&[]);
const CSV: &str = "# made up\n\
    temperature [degC], pressure [MPa], thermal conductivity [mW/(m.K)], heat capacity [kJ/(kg.K)]\n\
    20, 0, 120, 1.9\n20, 100, 140, 1.8\n60, 0, 110, 2.1\n60, 100, 130, 2.0\n";
const SOLID_CSV: &str =
    "temperature [K], heat capacity [J/(kg.K)]\n273.15, 450\n373.15, 490\n473.15, 530\n";
const FILES: Files<'_> = Files::Embedded(&[("oil.csv", CSV), ("steel.csv", SOLID_CSV)]);

fn fluid(text: &str) -> Result<Fluid, InputError> {
    let head = "viscosity = { law = 'constant', mu_0 = '1 mPa.s' }\n";
    let document = Document::parse("case.toml", format!("{head}{text}"))?;
    let mut root = document.root();
    let fluid = Fluid::from_table(&mut root, "lubricant", FILES)?;
    root.finish()?;
    Ok(fluid)
}

fn solid(text: &str) -> Result<Solid, InputError> {
    let head = "youngs_modulus = '210 GPa'\npoissons_ratio = 0.3\n";
    let document = Document::parse("case.toml", format!("{head}{text}"))?;
    let mut root = document.root();
    let solid = Solid::from_table(&mut root, "ball", FILES)?;
    root.finish()?;
    Ok(solid)
}

fn conductivity(law: &str, p: f64, t: f64) -> f64 {
    let fluid = fluid(&format!("thermal_conductivity = {law}")).unwrap();
    fluid.thermal_conductivity.unwrap().conductivity(p, t)
}

fn heat_capacity(law: &str, p: f64, t: f64) -> f64 {
    let fluid = fluid(&format!("heat_capacity = {law}")).unwrap();
    fluid.heat_capacity.unwrap().heat_capacity(p, t)
}

const DOWSON: &str = "density = { law = 'dowson-higginson', rho_0 = '870 kg/m^3', reference_temperature = '300 K', \
                      beta = '7e-4 1/K' }";
const PER_VOLUME: &str = "heat_capacity = { law = 'larsson-andersson', rho_c_0 = '1.71 MJ/(m^3.K)', \
                          reference_temperature = '295 K', beta_0 = '6.5e-4 1/K', b_1 = '2.7 1/GPa', \
                          b_2 = '-1.5 1/GPa^2', k_1 = '0.47 1/GPa', k_2 = '0.81 1/GPa' }";

/// Values by mpmath from the formulas, with the units converted by hand.
#[test]
fn every_law_is_read_in_si() {
    let close =
        |value: f64, expected: f64| assert_relative_eq!(value, expected, max_relative = 1e-12);
    close(conductivity("'0.29 W/(m.K)'", 1e9, 400.0), 0.29);
    close(
        conductivity("{ law = 'constant', k_0 = '290 mW/(m.K)' }", 1e9, 400.0),
        0.29,
    );
    let larsson = "{ law = 'larsson-andersson', k_0 = '0.137 W/(m.K)', d_1 = '1.72 1/GPa', d_2 = '0.54 1/GPa' }";
    close(conductivity(larsson, 0.7e9, 300.0), 0.256701015965167);
    close(heat_capacity("'2.4 kJ/(kg.K)'", 1e9, 400.0), 2400.0);
    let linear = "{ law = 'linear', c_0 = '1700 J/(kg.K)', reference_temperature = '313 K', a_t = '1.5e-3 1/K', \
                  a_p = '-0.1 1/GPa' }";
    close(heat_capacity(linear, 0.7e9, 350.0), 1675.35);
    let fluid = fluid(&format!("{DOWSON}\n{PER_VOLUME}")).unwrap();
    let law = fluid.heat_capacity.unwrap();
    close(law.heat_capacity(0.7e9, 350.0), 2214.25406792291);

    let steel = solid(
        "thermal_conductivity = { law = 'linear', k_0 = '46 W/(m.K)', reference_temperature = '300 K', \
         a_t = '-8e-4 1/K' }",
    )
    .unwrap();
    let k = steel.thermal_conductivity.unwrap();
    close(k.conductivity(0.0, 350.0), 44.16);
}

#[test]
fn tables_of_columns_and_of_temperature_alone() {
    let close =
        |value: f64, expected: f64| assert_relative_eq!(value, expected, max_relative = 1e-12);
    let file = "{ law = 'table', file = 'oil.csv' }";
    close(conductivity(file, 50e6, 293.15), 0.130);
    close(heat_capacity(file, 100e6, 313.15), 1900.0);
    // The last value holds outside.
    close(conductivity(file, 1e9, 250.0), 0.140);
    let in_place = "{ law = 'table', units = { pressure = 'MPa', heat_capacity = 'kJ/(kg.K)' }, isotherms = [\
                    { temperature = '20 degC', pressure = [0, 100], heat_capacity = [1.9, 1.8] }] }";
    close(heat_capacity(in_place, 50e6, 400.0), 1850.0);

    let steel = solid(
        "heat_capacity = { law = 'table', file = 'steel.csv' }\n\
         thermal_conductivity = { law = 'table', units = { thermal_conductivity = 'W/(m.K)' }, isotherms = [\
         { temperature = '0 degC', thermal_conductivity = [47] }, \
         { temperature = '200 degC', thermal_conductivity = [43] }] }",
    )
    .unwrap();
    let (k, c) = (
        steel.thermal_conductivity.unwrap(),
        steel.heat_capacity.unwrap(),
    );
    close(k.conductivity(0.0, 373.15), 45.0);
    close(k.conductivity(1e9, 900.0), 43.0);
    close(c.heat_capacity(0.0, 373.15), 490.0);
    close(c.heat_capacity(0.0, 323.15), 470.0);
    let [pressure, temperature] = c.tabulated_range().unwrap();
    assert_eq!(temperature, (273.15, 473.15));
    assert_eq!(pressure, (f64::NEG_INFINITY, f64::INFINITY));
}

/// The key and, in part, the message of an error.
#[test]
fn errors_name_the_problem() {
    let check = |error: InputError, key: &str, words: &str| {
        assert_eq!(error.key(), key, "{error}");
        assert!(error.to_string().contains(words), "{error}");
        assert!(error.line().is_some());
    };
    for (text, key, words) in [
        (
            "thermal_conductivity = '0 W/(m.K)'",
            "thermal_conductivity",
            "positive",
        ),
        (
            "thermal_conductivity = '-0.1 W/(m.K)'",
            "thermal_conductivity",
            "positive",
        ),
        (
            "thermal_conductivity = 'inf W/(m.K)'",
            "thermal_conductivity",
            "",
        ),
        (
            "thermal_conductivity = nan",
            "thermal_conductivity",
            "finite",
        ),
        (
            "thermal_conductivity = 0.1",
            "thermal_conductivity",
            "no unit",
        ),
        (
            "thermal_conductivity = '0.1 W'",
            "thermal_conductivity",
            "needs a thermal conductivity",
        ),
        ("heat_capacity = '-1 J/(kg.K)'", "heat_capacity", "positive"),
        (
            "heat_capacity = ['1 J/(kg.K)']",
            "heat_capacity",
            "must be a number with a unit",
        ),
        (
            "heat_capacity = { law = 'constant', c_0 = '0 J/(kg.K)' }",
            "heat_capacity.c_0",
            "positive",
        ),
        (
            "heat_capacity = { law = 'constant', k_0 = '1 J/(kg.K)' }",
            "heat_capacity.k_0",
            "missing key `c_0`",
        ),
        (
            "heat_capacity = { law = 'larson', c_0 = '1 J/(kg.K)' }",
            "heat_capacity.law",
            "constant, linear, larsson-andersson, scaling, table",
        ),
        (
            "thermal_conductivity = { law = 'larsson-andersson', k_0 = '0.1 W/(m.K)', d_1 = '-1 1/GPa', \
             d_2 = '0 1/GPa' }",
            "thermal_conductivity.d_1",
            "zero or positive",
        ),
        (PER_VOLUME, "heat_capacity.law", "needs a density law"),
        (
            "thermal_conductivity = { law = 'table', file = 'steel.csv' }",
            "thermal_conductivity.file",
            "no column `thermal conductivity [unit]`",
        ),
    ] {
        check(fluid(text).unwrap_err(), key, words);
    }
    for (text, key, words) in [
        (
            "thermal_conductivity = { law = 'larsson-andersson', k_0 = '0.1 W/(m.K)' }",
            "thermal_conductivity.law",
            "constant, linear, table",
        ),
        (
            "heat_capacity = { law = 'linear', c_0 = '470 J/(kg.K)', reference_temperature = '300 K', \
             a_t = '0 1/K', a_p = '1 1/GPa' }",
            "heat_capacity.a_p",
            "unknown key",
        ),
        (
            "thermal_conductivity = '0 W/(m.K)'",
            "thermal_conductivity",
            "positive",
        ),
    ] {
        check(solid(text).unwrap_err(), key, words);
    }
}

/// A case that replaces the density keeps ρ c, the measured quantity.
#[test]
fn a_heat_capacity_per_volume_follows_the_density() {
    let mut fluid = fluid(&format!("{DOWSON}\n{PER_VOLUME}")).unwrap();
    let document = Document::parse(
        "case.toml",
        "density = { law = 'constant', rho_0 = '1000 kg/m^3' }",
    )
    .unwrap();
    fluid.override_from(&mut document.root(), NO_FILES).unwrap();
    assert_eq!(fluid.density, Some(DensityLaw::constant(1000.0).unwrap()));
    assert!(matches!(
        fluid.heat_capacity,
        Some(HeatCapacityLaw::LarssonAndersson(_))
    ));
    let c = fluid.heat_capacity.unwrap().heat_capacity(0.7e9, 350.0);
    assert_relative_eq!(c, 2228.42377734525, max_relative = 1e-12);
}

#[test]
fn records_show_a_constant_by_its_number_and_a_law_by_its_name() {
    let of = |data: &[Datum], key: &str| -> (String, String) {
        let datum = data.iter().find(|datum| datum.key == key).unwrap();
        assert_eq!(datum.status, Status::User);
        (datum.value.clone(), datum.unit.clone())
    };
    let pair = |value: &str, unit: &str| (value.to_owned(), unit.to_owned());
    let data = fluid("thermal_conductivity = '0.13 W/(m.K)'\nheat_capacity = { law = 'table', file = 'oil.csv' }")
        .unwrap()
        .provenance;
    assert_eq!(of(&data, "thermal_conductivity"), pair("0.13", "W/(m.K)"));
    assert_eq!(of(&data, "heat_capacity.law"), pair("table", ""));
    let data = solid("heat_capacity = { law = 'table', file = 'steel.csv' }\nthermal_conductivity = '46 W/(m.K)'")
        .unwrap()
        .provenance;
    assert_eq!(of(&data, "thermal_conductivity"), pair("46", "W/(m.K)"));
    assert_eq!(of(&data, "heat_capacity.law"), pair("table", ""));
}
