//! Warnings about implausible inputs, on both sides of each bound.

use std::path::Path;

use super::Case;
use crate::contains::contains;
use crate::warning::{Warning, WarningKind};

const CASE: &str = concat!(
    "[contact]\nkind = \"circular\"\nradius = \"10 mm\"\nhertz_pressure = \"1 GPa\"\n",
    "[motion]\nentrainment_speed = \"1 m/s\"\nslide_to_roll_ratio = 0.0\n",
    include_str!("../../tests/common/cases/steel.toml")
);

const WITH_BETA: &str = r#"viscosity = { law = "roelands", mu_0 = "40 mPa.s", alpha = "22 1/GPa", beta = "0.04 1/K", reference_temperature = "40 degC" }"#;

fn read(text: &str, settings: &[&str]) -> Case {
    let settings: Vec<String> = settings.iter().map(|s| (*s).to_owned()).collect();
    Case::from_text_with("case.toml", text, Path::new(""), &settings).unwrap()
}

fn has(warnings: &[Warning], kind: WarningKind) -> bool {
    warnings.iter().any(|w| w.kind == kind)
}

fn with_beta() -> String {
    let lines = CASE.lines().filter(|line| !line.starts_with("viscosity"));
    lines.collect::<Vec<_>>().join("\n") + "\n" + WITH_BETA + "\n"
}

/// A temperature that is set, varies or is uncertain, and a law that does not depend on it; not where the viscosity is given with it, nor where
/// the temperature is not changed.
#[test]
fn temperatures_without_effect() {
    let ignored = |case: &Case| has(&case.warnings, WarningKind::TemperatureIgnored);
    let set = "lubricant.temperature=80 degC";
    assert!(!ignored(&read(CASE, &[])));
    assert!(ignored(&read(CASE, &[set])));
    assert!(!ignored(&read(
        CASE,
        &[set, "lubricant.viscosity.mu_0=10 mPa.s"]
    )));
    assert!(!ignored(&read(&with_beta(), &[set])));
    let uncertain = CASE.replace("40 degC", "40 degC ± 2 K");
    assert!(ignored(&read(&uncertain, &[])));
    let curve =
        "[curve]\nquantity = \"lubricant.temperature\"\nvalues = [\"40 degC\", \"60 degC\"]\n";
    for (text, expected) in [(CASE.to_owned(), true), (with_beta(), false)] {
        let case = read(&format!("{text}{curve}"), &[]);
        let points = &case.curve.as_ref().unwrap().points;
        assert!(
            points.iter().all(|p| ignored(&p.case) == expected),
            "{text}"
        );
    }
}

/// The temperature at which the constants hold can be said.
#[test]
fn constants_that_hold_at_another_temperature() {
    let at = |celsius: f64| {
        let text = format!("{CASE}reference_temperature = \"{celsius} degC\"\n");
        has(&read(&text, &[]).warnings, WarningKind::TemperatureIgnored)
    };
    assert!(!at(40.4) && at(40.6) && at(60.0));
}

/// Limits of the database (ISO 76 for steel, yield of PEEK and POM, glass), one of the case itself, and that of the hardest steel where a
/// body says none.
#[test]
fn pressures_beyond_strength() {
    for (body, limit) in [
        ("\"steel\"", 4.2e9),
        ("\"gear-steel\"", 4.0e9),
        ("\"glass\"", 0.8e9),
        ("\"sapphire\"", 3.0e9),
        ("\"peek\"", 160e6),
        ("\"pom\"", 105e6),
        ("\"pa66\"", 136e6),
        (
            "{ youngs_modulus = \"210 GPa\", poissons_ratio = 0.3, hertz_pressure_limit = \"1 GPa\" }",
            1e9,
        ),
        (
            "{ youngs_modulus = \"210 GPa\", poissons_ratio = 0.3 }",
            4.2e9,
        ),
    ] {
        let warned = |pressure: f64| {
            let text = CASE
                .replace("1 GPa", &format!("{pressure} Pa"))
                .replace("body_2 = \"steel\"", &format!("body_2 = {body}"))
                .replace("body_1 = \"steel\"", &format!("body_1 = {body}"));
            has(&read(&text, &[]).warnings, WarningKind::Strength)
        };
        assert!(!warned(0.999 * limit), "{body}");
        assert!(warned(1.001 * limit), "{body}");
    }
}

/// A head in its cup: the reduced radius is 1974 mm, the head's own 14 mm, and the contact 0.88 of it. Under 40 N it is 0.26, under 80 N 0.33.
#[test]
fn contacts_as_wide_as_a_body() {
    let warned = |load: f64| {
        let text = format!(
            r#"
[contact]
kind = "elliptical"
load = "{load} N"
[bodies]
body_1 = {{ youngs_modulus = "1 GPa", poissons_ratio = 0.4, radius_x = "-14.1 mm", radius_y = "-14.1 mm" }}
body_2 = {{ youngs_modulus = "210 GPa", poissons_ratio = 0.3, radius_x = "14 mm", radius_y = "14 mm" }}
[motion]
entrainment_speed = "0.01 m/s"
slide_to_roll_ratio = 2
[lubricant]
temperature = "37 degC"
density = {{ law = "constant", rho_0 = "1000 kg/m^3" }}
viscosity = {{ law = "constant", mu_0 = "5 mPa.s" }}
"#
        );
        let found = Case::from_text("hip.toml", &text, Path::new(""));
        found.map(|case| has(&case.warnings, WarningKind::WideContact))
    };
    // a = (3 F R/(2 E'))^(1/3), so that a is proportional to F^(1/3): 0.3 of 14 mm at 1500 (0.3/0.8807)³ N.
    let bound = 1500.0 * (0.3_f64 / 0.8807).powi(3);
    assert!(!warned(0.97 * bound).unwrap());
    assert!(warned(1.03 * bound).unwrap());
    assert!(warned(1500.0).unwrap());
    let error = warned(3000.0).unwrap_err();
    contains(&error.to_string(), "exceeds the radius of a body");
}

/// Barus' law reaches 1e12 Pa.s where α p = ln(1e12/0.04) = 30.85: at 1.402 GPa.
#[test]
fn oils_that_become_glass() {
    let barus = CASE.replace("roelands", "barus");
    let warned = |gpa: f64| {
        let text = barus.replace("1 GPa", &format!("{gpa} GPa"));
        has(&read(&text, &[]).warnings, WarningKind::Glass)
    };
    assert!(!warned(1.400) && warned(1.404));
}
