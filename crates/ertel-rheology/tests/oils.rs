//! The oils of the database against figures that did not serve to make their entries.

use crate::common::{gear_oil, near};
use approx::assert_relative_eq;
use ertel_rheology::data_sheet::{ISO_VG_TOLERANCE, viscosity_index};
use ertel_rheology::database;
use ertel_rheology::provenance::Status;
use ertel_rheology::viscosity::ImprovedYasutomi;
use ertel_rheology::{Fluid, ViscosityLaw};

fn fluid(name: &str) -> Fluid {
    database::fluid(name).unwrap_or_else(|error| panic!("{error}"))
}

/// Kinematic viscosity in mm²/s at ambient pressure, `celsius` in degC.
fn kinematic(fluid: &Fluid, celsius: f64) -> f64 {
    let temperature = celsius + 273.15;
    1e6 * fluid.viscosity(0.0, temperature) / fluid.density(0.0, temperature).unwrap()
}

/// Initial slope in 1/GPa.
fn alpha(fluid: &Fluid, celsius: f64) -> f64 {
    1e9 * fluid.pressure_viscosity_slope(celsius + 273.15)
}

#[test]
fn there_are_more_than_thirty_of_many_kinds() {
    let names = database::fluid_names();
    assert!(names.len() > 60, "{}", names.len());
    for part in [
        "mineral",
        "pao",
        "ester",
        "pag",
        "santotrac",
        "r1234yf",
        "water",
        "glycerol",
        "gear-oil",
    ] {
        assert!(names.iter().any(|name| name.contains(part)), "{part}");
    }
}

/// ISO 3448 allows 10 %; the index is what its kind has.
#[test]
fn grades_are_in_their_grade() {
    for grade in [32, 46, 68, 100, 150, 220, 320, 460, 680] {
        for (kind, indices, alphas) in [
            ("mineral", 85.0..103.0, 21.0..34.0),
            ("pao", 141.0..191.0, 15.0..25.0),
        ] {
            let oil = fluid(&format!("iso-vg-{grade}-{kind}"));
            let (nu_40, nu_100) = (kinematic(&oil, 40.0), kinematic(&oil, 100.0));
            let off = nu_40 / f64::from(grade) - 1.0;
            assert!(off.abs() < ISO_VG_TOLERANCE, "{} {nu_40}", oil.name);
            let index = viscosity_index(1e-6 * nu_40, 1e-6 * nu_100).unwrap();
            assert!(indices.contains(&index), "{} {index}", oil.name);
            assert!(alphas.contains(&alpha(&oil, 40.0)), "{}", oil.name);
            let estimate = oil
                .provenance
                .iter()
                .find(|datum| datum.status == Status::Estimated);
            assert!(estimate.is_some(), "{}", oil.name);
        }
    }
}

/// Another public program has these for FVA 3, mm²/s; its coefficient is that of the entry.
#[test]
fn reference_oil_fva_3() {
    let oil = fluid("fva-3");
    for (celsius, nu) in [(40.0, 96.0), (60.0, 36.0), (80.0, 18.5)] {
        assert_relative_eq!(kinematic(&oil, celsius), nu, max_relative = 0.12);
    }
    assert_relative_eq!(alpha(&oil, 40.0), 20.0, max_relative = 1e-9);
}

/// The oil has two sets of constants on one page: the free volume of the entry, and improved Yasutomi.
#[test]
fn gear_oil_by_two_laws() {
    let oil = fluid("gear-oil-80w-90");
    // By mpmath from the formula of Doolittle with the volume at 323 K.
    for (temperature, mu) in [
        (293.15, 0.456),
        (313.15, 0.142),
        (323.15, 0.0847),
        (373.15, 0.0111),
    ] {
        assert_relative_eq!(oil.viscosity(0.0, temperature), mu, max_relative = 0.02);
    }
    let yasutomi = ViscosityLaw::ImprovedYasutomi(ImprovedYasutomi::new(gear_oil()).unwrap());
    for temperature in [293.15, 313.15, 343.15, 373.15] {
        let ratio: f64 = oil.viscosity(0.0, temperature) / yasutomi.viscosity(0.0, temperature);
        assert!((ratio - 1.0).abs() < 0.16, "{temperature}: {ratio}");
    }
    let [free_volume, other] = [&oil.viscosity, &yasutomi].map(|law| {
        law.pressure_viscosity_reciprocal_asymptotic(323.15)
            .unwrap()
    });
    assert_relative_eq!(free_volume, other, max_relative = 0.08);
}

/// Between the two temperatures of the data sheet the formulas of the source go their own way, mm²/s.
#[test]
fn walther_between_the_temperatures_of_a_sheet() {
    for (name, celsius, nu) in [
        ("santotrac-30", 60.0, 7.024636),
        ("santotrac-30", 80.0, 4.250394),
        ("santotrac-50", 60.0, 16.028806),
        ("santotrac-50", 80.0, 8.872978),
        ("mil-l-23699-ester", 60.0, 14.0523),
    ] {
        assert_relative_eq!(kinematic(&fluid(name), celsius), nu, max_relative = 0.02);
    }
    // A second program for oils of this specification: 27.6 and 5.1 mm²/s, 1003.5 kg/m³ at 15 degC, 12.0 1/GPa.
    let ester = fluid("mil-l-23699-ester");
    assert_relative_eq!(kinematic(&ester, 40.0), 27.6, max_relative = 0.05);
    assert_relative_eq!(kinematic(&ester, 100.0), 5.1, max_relative = 0.08);
    near(ester.density(0.0, 288.15).unwrap(), 1003.5, 0.03);
    assert_relative_eq!(alpha(&ester, 40.0), 12.0, max_relative = 0.2);
}

/// Every fluid has a row and a picture in the reference.
#[test]
fn every_fluid_is_in_the_reference() {
    let docs = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs");
    let page = std::fs::read_to_string(format!("{docs}/reference/fluids.md")).unwrap();
    for name in database::fluid_names() {
        let link = format!("../pictures/fluids/{name}.svg");
        assert!(
            page.contains(&format!("`{name}`")) && page.contains(&link),
            "{name}"
        );
        let picture =
            std::fs::read_to_string(format!("{docs}/pictures/fluids/{name}.svg")).unwrap();
        assert!(
            picture.starts_with("<svg") && picture.trim_end().ends_with("</svg>"),
            "{name}"
        );
    }
}
