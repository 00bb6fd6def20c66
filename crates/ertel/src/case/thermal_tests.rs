//! `[thermal]`: inputs, refusals, warnings.

use std::path::Path;

use approx::assert_relative_eq;
use ertel_input::InputError;
use ertel_rheology::provenance::TemperatureRange;

use super::Case;
use crate::contains::contains;
use crate::params::ThermalParams;

const SQUALANE: &str = include_str!("../../tests/common/cases/squalane.toml");

fn read(text: &str) -> Result<Case, InputError> {
    Case::from_text("case.toml", text, Path::new(""))
}

fn thermal(lines: &str) -> Result<Case, InputError> {
    read(&format!("{SQUALANE}[thermal]\n{lines}"))
}

fn message(result: Result<Case, InputError>) -> String {
    result.unwrap_err().to_string()
}

#[test]
fn its_presence_switches_heat_on() {
    assert_eq!(read(SQUALANE).unwrap().thermal(), None);
    assert!(read(SQUALANE).unwrap().heat().unwrap().is_none());
    let case = thermal("").unwrap();
    assert_eq!(case.thermal(), Some(&ThermalParams::default()));
    // Habchi 2008, Table 5.2.
    let heat = case.heat().unwrap().unwrap();
    assert_eq!(heat.conductivity.conductivity(0.5e9, 350.0), 0.13);
    assert_eq!(heat.heat_capacity.heat_capacity(0.5e9, 350.0), 1700.0);
    let solid = |s: &super::SolidHeat<'_>| {
        let (k, c) = (s.conductivity, s.heat_capacity);
        [
            s.density,
            k.conductivity(0.0, 313.0),
            c.heat_capacity(0.0, 313.0),
            s.temperature,
        ]
    };
    assert_eq!(solid(&heat.body_1), [2510.0, 1.114, 858.0, 313.0]);
    assert_eq!(solid(&heat.body_2), [7850.0, 46.0, 470.0, 313.0]);

    let left_out = thermal("[solver]\nisothermal = true").unwrap();
    assert!(left_out.thermal.is_some());
    assert_eq!(left_out.thermal(), None);
    assert!(left_out.heat().unwrap().is_none());
    assert!(left_out.echo().thermal.is_none());
}

#[test]
fn every_setting_is_read() {
    let case = thermal(
        "depth = 2.5\nfilm_order = 10\nsolid_elements = 12\nsurface_order = 2\n\
         tolerance = 1e-6\nmax_iterations = 7\nbody_1_temperature = \"30 degC\"\nbody_2_temperature = \"323 K\"\n\
         profiles = [[-0.5, 0.25], [0, 1]]\nfield = true",
    )
    .unwrap();
    let t = case.thermal().unwrap();
    assert_eq!(
        *t,
        ThermalParams {
            depth: 2.5,
            film_order: 10,
            solid_elements: 12,
            surface_order: 2,
            tolerance: 1e-6,
            max_iterations: 7,
            body_1_temperature: Some(303.15),
            body_2_temperature: Some(323.0),
            profiles: vec![[-0.5, 0.25], [0.0, 1.0]],
            field: true,
        }
    );
    let heat = case.heat().unwrap().unwrap();
    assert_eq!(
        (heat.body_1.temperature, heat.body_2.temperature),
        (303.15, 323.0)
    );
    let echo = serde_json::to_value(case.echo()).unwrap();
    assert_eq!(echo["thermal"]["depth"], 2.5);
    assert_eq!(echo["thermal"]["body_2_temperature"], 323.0);
    assert_eq!(echo["thermal"]["body_1"]["thermal_conductivity"], 1.114);
    assert_eq!(
        thermal("profiles = []")
            .unwrap()
            .thermal()
            .unwrap()
            .profiles,
        [[0.0; 2]; 0]
    );
}

/// Other ones are among the bad cases of the command.
#[test]
fn impossible_values_are_refused_with_their_line() {
    for (line, words) in [
        ("body_2_temperature = \"-300 degC\"", "below absolute zero"),
        ("profiles = [[0, 1, 2]]", "points of two numbers"),
        ("profiles = 3", "an array of points"),
        ("field = 1", "true or false"),
    ] {
        let error = thermal(line).unwrap_err();
        assert!(error.line().is_some_and(|l| l > 13), "{error}");
        let text = error.to_string();
        assert!(text.contains(words), "{text}");
    }
    let load = SQUALANE
        .replace("circular", "line")
        .replace("23 N", "23 kN/m");
    assert!(read(&format!("{load}[thermal]\nprofiles = [[0.5, 0]]")).is_ok());
}

#[test]
fn missing_data_are_named_with_their_place() {
    let ceramic = SQUALANE.replace("body_2 = \"steel\"", "body_2 = \"silicon-nitride\"");
    let text = message(read(&format!("{ceramic}[thermal]")));
    for words in [
        "the thermal_conductivity of body 2 (silicon-nitride), the heat_capacity of body 2",
        "body_2 = { name = \"silicon-nitride\", heat_capacity = \"... J/(kg.K)\" }",
        "isothermal = true",
        "database",
    ] {
        assert!(text.contains(words), "{text}");
    }
    let isothermal = read(&format!("{ceramic}[thermal]\n[solver]\nisothermal = true"));
    assert!(isothermal.is_ok());
    let given = ceramic.replace(
        "\"silicon-nitride\"",
        "{ name = \"silicon-nitride\", thermal_conductivity = \"29 W/(m.K)\", heat_capacity = \"680 J/(kg.K)\" }",
    );
    assert!(read(&format!("{given}[thermal]")).is_ok());

    let bare = SQUALANE.replace(
        "\"steel\"",
        "{ youngs_modulus = \"210 GPa\", poissons_ratio = 0.3, heat_capacity = \"470 J/(kg.K)\" }",
    );
    let text = message(read(&format!("{bare}[thermal]")));
    let words = "without the density of body 2, the thermal_conductivity of body 2\n";
    assert!(text.contains(words), "{text}");
    assert!(
        text.contains("to `body_2` in [bodies]") && !text.contains("database"),
        "{text}"
    );

    let oil = SQUALANE.replace("squalane-pip", "thesis-roelands-oil");
    let text = message(read(&format!("{oil}[thermal]")));
    let words = "the thermal_conductivity of the lubricant (thesis-roelands-oil), the heat_capacity of the lubricant";
    contains(&text, words);
    contains(&text, "to [lubricant]");
}

#[test]
fn units_that_were_mistaken_are_refused() {
    let ball = |data: &str| {
        let body = format!("body_2 = {{ name = \"steel\", {data} }}");
        read(&format!(
            "{}[thermal]",
            SQUALANE.replace("body_2 = \"steel\"", &body)
        ))
    };
    let text = message(ball("thermal_conductivity = \"46 kW/(m.K)\""));
    contains(&text, "thermal conductivity of body 2 is 4.6e4");
    assert!(message(ball("heat_capacity = \"470 kJ/(kg.K)\"")).contains("heat capacity of body 2"));
    assert!(message(ball("density = \"7.85 kg/m^3\"")).contains("density of body 2 is 7.85"));
}

#[test]
fn laws_independent_of_temperature_bring_warnings() {
    // The pressure of this contact is slightly above that of the data, heat or not.
    let range = read(SQUALANE).unwrap().warnings;
    assert_eq!(thermal("").unwrap().warnings, range);
    let oil = "[lubricant]\ntemperature = \"40 degC\"\n\
               viscosity = { law = \"barus\", mu_0 = \"40 mPa.s\", alpha = \"20 1/GPa\" }\n\
               density = { law = \"dowson-higginson\", rho_0 = \"870 kg/m^3\" }\n\
               thermal_conductivity = \"0.13 W/(m.K)\"\n\
               heat_capacity = { law = \"linear\", c_0 = \"2 kJ/(kg.K)\", reference_temperature = \"40 degC\", a_t = \"1e-3 1/K\" }\n";
    let head = SQUALANE.replace(
        "lubricant = \"squalane-pip\"\ntemperature = \"313 K\"\n",
        "",
    );
    let warnings = read(&format!("{head}{oil}[thermal]")).unwrap().warnings;
    assert_eq!(warnings.len(), 2, "{warnings:?}");
    assert!(warnings[0].contains("heat will not thin"));
    assert!(warnings[1].contains("by compression"));
    assert!(read(&format!("{head}{oil}")).unwrap().warnings.is_empty());
}

#[test]
fn temperature_outside_a_range_is_reported() {
    let head = SQUALANE.replace("squalane-pip", "r245fa");
    let case = read(&format!("{head}[thermal]")).unwrap();
    let ranges = &case.lubricant.temperature_ranges;
    assert_eq!(TemperatureRange::left(ranges, 313.0), None);
    let range = TemperatureRange::left(ranges, 330.0).unwrap();
    assert_relative_eq!(range.highest, 323.15);
}

/// A body at 150 K freezes squalane, whose viscosity there is beyond that of pitch: refused, by the key of the body.
#[test]
fn a_body_that_freezes_the_lubricant_is_refused() {
    for key in ["body_1_temperature", "body_2_temperature"] {
        let text = message(thermal(&format!("{key} = \"150 K\"")));
        contains(&text, "the viscosity of the lubricant at -123.15 °C");
        assert!(
            text.contains(key) && text.contains("must be liquid"),
            "{text}"
        );
    }
    assert!(thermal("body_1_temperature = \"300 K\"").is_ok());
}
