//! The database: every entry loads and every number has unit, source and status; checks against published figures.

use crate::common::near;
use approx::assert_relative_eq;
use ertel_rheology::database::{self, DatabaseError, REFERENCES};
use ertel_rheology::provenance::{Datum, RangeWarning, Status};
use ertel_rheology::viscosity::Barus;
use ertel_rheology::{GLASS_VISCOSITY, ViscosityLaw};

fn check_provenance(entry: &str, provenance: &[Datum]) {
    assert!(!provenance.is_empty(), "{entry} has no data");
    for datum in provenance {
        let Datum {
            key,
            value,
            unit,
            source,
            status,
            ..
        } = datum;
        assert!(!value.is_empty(), "{entry}: {key}");
        let name = key.ends_with(".law") || key.ends_with(".file") || key == "base_oil";
        assert!(name == unit.is_empty(), "{entry}: {key} = {value} [{unit}]");
        if *status == Status::Nominal {
            assert!(
                datum.note.is_some(),
                "{entry}: {key} is nominal without saying why"
            );
        } else if *status == Status::Estimated {
            let note = datum.note.as_deref().unwrap_or_default();
            assert!(note.starts_with("estimate, "), "{entry}: {key}: {note}");
        } else {
            let reference = source.split(',').next().unwrap();
            assert!(
                REFERENCES.contains(&format!("{{{reference},")),
                "{entry}: {key}: no reference `{reference}`"
            );
        }
        assert_ne!(*status, Status::User, "{entry}: {key}");
    }
}

#[test]
fn every_fluid_loads_with_sources() {
    let names = database::fluid_names();
    assert!(names.is_sorted());
    for name in names {
        let fluid = database::fluid(name).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(fluid.name, name);
        check_provenance(name, &fluid.provenance);
        let validity = fluid
            .validity
            .as_ref()
            .unwrap_or_else(|| panic!("{name} states no range"));
        assert!(!validity.source.is_empty());
        let temperature = fluid.reference_temperature.unwrap_or(333.15);
        let mu = fluid.viscosity(0.0, temperature);
        assert!(mu > 1e-4 && mu < 10.0, "{name}: {mu} Pa.s");
        assert!(fluid.viscosity(1e8, temperature) > mu * 0.99, "{name}");
        match fluid.density(0.0, temperature) {
            Ok(rho) => {
                assert!(rho > 600.0 && rho < 1600.0, "{name}: {rho} kg/m3");
                assert!(fluid.density(1e8, temperature).unwrap() > rho, "{name}");
            }
            Err(error) => {
                assert!(
                    fluid
                        .notes
                        .iter()
                        .any(|note| note.contains("No density law")),
                    "{name}"
                );
                assert!(error.to_string().contains("density = {"), "{error}");
            }
        }
    }
}

#[test]
fn every_solid_loads_with_sources() {
    let names = database::solid_names();
    assert!(names.is_sorted());
    for name in names {
        let solid = database::solid(name).unwrap_or_else(|error| panic!("{error}"));
        check_provenance(name, &solid.provenance);
    }
    let steel = database::solid("steel").unwrap();
    assert_eq!((steel.youngs_modulus, steel.poissons_ratio), (210e9, 0.3));
    let conductivity = steel.thermal_conductivity.unwrap();
    assert_eq!(conductivity.constant_value(), Some(46.0));
    // Habchi 2008, Tables 5.1 and 5.2: what a thermal contact needs of both bodies.
    for (name, density, conductivity, heat_capacity) in [
        ("steel", 7850.0, 46.0, 470.0),
        ("glass", 2510.0, 1.114, 858.0),
    ] {
        let solid = database::solid(name).unwrap();
        assert_eq!(solid.density, Some(density));
        let k = solid.thermal_conductivity.unwrap();
        assert_eq!(k.conductivity(0.0, 300.0), conductivity);
        let c = solid.heat_capacity.unwrap();
        assert_eq!(c.heat_capacity(0.0, 300.0), heat_capacity);
    }
}

/// A file in the folder that is not in the list would never be found.
#[test]
fn every_file_is_listed() {
    for (folder, names) in [
        ("fluids", database::fluid_names()),
        ("solids", database::solid_names()),
    ] {
        let path = format!("{}/data/{folder}", env!("CARGO_MANIFEST_DIR"));
        let mut files: Vec<String> = std::fs::read_dir(path)
            .unwrap()
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .filter_map(|name| name.strip_suffix(".toml").map(str::to_owned))
            .collect();
        files.sort();
        assert_eq!(files, names);
    }
}

/// An exception whose key is misspelt would silently not apply.
#[test]
fn every_exception_belongs_to_a_datum() {
    for name in database::fluid_names() {
        let path = format!("{}/data/fluids/{name}.toml", env!("CARGO_MANIFEST_DIR"));
        let text = std::fs::read_to_string(path).unwrap();
        let fluid = database::fluid(name).unwrap();
        for line in text.lines() {
            if let Some(key) = line.strip_prefix("[provenance.") {
                let key = key.trim_end_matches(']').trim_matches('"');
                assert!(
                    fluid.provenance.iter().any(|datum| datum.key == key),
                    "{name}: {key}"
                );
            }
        }
    }
}

#[test]
fn unknown_names_are_answered_with_the_nearest() {
    let near = |result: Result<_, DatabaseError>| match result {
        Err(DatabaseError::Unknown { near, .. }) => near,
        _ => panic!("such a fluid exists"),
    };
    assert_eq!(near(database::fluid("squalane")), Some("squalane-pip"));
    assert_eq!(near(database::fluid("glycerine")), Some("glycerol"));
    assert_eq!(near(database::fluid("R134a")), Some("r134a"));
    assert_eq!(near(database::fluid("zzz")), None);
    let error = database::solid("stel").unwrap_err().to_string();
    assert!(
        error.contains("did you mean `steel`?") && error.contains("silicon-nitride"),
        "{error}"
    );
}

/// Expected values computed independently from the printed constants with mpmath; α* and slopes in 1/GPa.
#[test]
fn coefficients_of_the_thesis_fluids() {
    for (name, temperature, mu_0, asymptotic, slope) in [
        ("squalane-pip", 313.0, 0.0705, 18.9247577595, 23.4440606062),
        ("pao-650", 348.0, 1.42, 14.9967776857, 19.0030335067),
        (
            "thesis-wlf-oil",
            313.15,
            0.0147392783087,
            20.4679206991,
            28.1179808201,
        ),
        ("thesis-roelands-oil", 313.0, 0.04, 20.5255121643, 22.0),
        ("glycerol", 313.0, 0.2803, 5.4, 5.4),
        ("thesis-fluid-c", 313.0, 0.5e-3, 0.5, 0.5),
    ] {
        let fluid = database::fluid(name).unwrap();
        near(fluid.viscosity(0.0, temperature), mu_0, 1e-10);
        let alpha = fluid
            .pressure_viscosity_reciprocal_asymptotic(temperature)
            .unwrap()
            * 1e9;
        assert_relative_eq!(alpha, asymptotic, max_relative = 1e-8);
        assert_relative_eq!(
            fluid.pressure_viscosity_slope(temperature) * 1e9,
            slope,
            max_relative = 1e-9
        );
    }
    // Mean slopes of ln μ up to 40 MPa, from CoolProp itself.
    for (name, temperature, mean_slope) in [
        ("r123", 297.65, 11.2),
        ("r134a", 272.65, 10.8),
        ("n-dodecane", 313.15, 10.9),
    ] {
        let fluid = database::fluid(name).unwrap();
        let mu = |pressure: f64| fluid.viscosity(pressure, temperature);
        let mean = (mu(40e6) / mu(0.0)).ln() / 0.04;
        assert_relative_eq!(mean, mean_slope, max_relative = 0.01);
    }
}

#[test]
fn tables_return_their_states() {
    // Lines of the CoolProp tables: absolute pressure 150 MPa at 313.15 K, 40 MPa at 240.65 K.
    let dodecane = database::fluid("n-dodecane").unwrap();
    let p = 150e6 - 101_325.0;
    near(dodecane.viscosity(p, 313.15), 4.08781e-3, 1e-9);
    near(dodecane.density(p, 313.15).unwrap(), 809.0, 1e-9);
    let refrigerant = database::fluid("r134a").unwrap();
    assert_relative_eq!(
        refrigerant.viscosity(40e6 - 101_325.0, 240.65),
        0.617649e-3,
        max_relative = 1e-9
    );
}

/// Lines of the CoolProp tables, and the straight-through values that the entries had as constants before, at one
/// atmosphere: conductivity in W/(m.K), heat capacity in J/(kg.K).
#[test]
fn tables_return_thermal_data() {
    for (name, temperature, conductivity, heat_capacity) in [
        ("n-decane", 313.15, 0.1256, 2249.0),
        ("n-dodecane", 313.15, 0.1318, 2262.0),
        ("r123", 297.65, 0.07656, 1019.0),
        ("r134a", 272.65, 0.09224, 1340.0),
        ("r245fa", 298.15, 0.09196, 1317.0),
        ("water", 313.15, 0.6285, 4179.0),
    ] {
        let fluid = database::fluid(name).unwrap();
        let k = fluid.thermal_conductivity.unwrap();
        let c = fluid.heat_capacity.unwrap();
        let (k, c) = (
            k.conductivity(0.0, temperature),
            c.heat_capacity(0.0, temperature),
        );
        assert_relative_eq!(k, conductivity, max_relative = 1e-3);
        assert_relative_eq!(c, heat_capacity, max_relative = 1e-3);
    }
    // A knot, and far outside, where the last value holds.
    let decane = database::fluid("n-decane").unwrap();
    let k = decane.thermal_conductivity.as_ref().unwrap();
    let c = decane.heat_capacity.as_ref().unwrap();
    let p = 5e6 - 101_325.0;
    assert_relative_eq!(k.conductivity(p, 293.15), 0.132648, max_relative = 1e-9);
    assert_relative_eq!(c.heat_capacity(p, 293.15), 2170.21, max_relative = 1e-9);
    assert_eq!(k.conductivity(0.2e9, 353.15), k.conductivity(5e9, 900.0));
    assert_eq!(decane.check_range_with_heat(0.19e9, 293.15), []);
    assert_eq!(decane.check_range_with_heat(0.21e9, 293.15).len(), 1);
    let ranges = decane.temperature_ranges();
    assert_eq!(ranges.len(), 5); // declared, viscosity, density, conductivity, heat capacity
    assert!(
        ranges
            .iter()
            .all(|range| range.contains(353.15) && !range.contains(354.0))
    );
}

#[test]
fn states_outside_the_data_are_reported() {
    let pao = database::fluid("pao-650").unwrap();
    assert_eq!(pao.check_range(0.5e9, 348.0), []);
    let warnings = pao.check_range(0.6e9, 313.0);
    assert!(matches!(
        warnings[0],
        RangeWarning::PressureAbove { limit: 0.528e9, .. }
    ));
    for (warning, start) in warnings.iter().zip([
        "pao-650: the pressure reaches 0.600 GPa, its data are valid up to 0.528 GPa (",
        "pao-650: the temperature is 39.85 °C, its data are valid at 74.85 °C only (",
    ]) {
        let text = warning.to_string();
        assert!(text.starts_with(start), "{text}");
    }

    let refrigerant = database::fluid("r134a").unwrap();
    let warnings = refrigerant.check_range(0.5e9, 272.65);
    assert_eq!(warnings.len(), 1);
    let warm = database::fluid("r245fa").unwrap().check_range(0.0, 330.0);
    let text = warm[0].to_string();
    assert!(
        text.contains("data are valid from 0 °C to 50 °C ("),
        "{text}"
    );
    // A WLF law ends at the glass transition, 0.343 GPa at 40 degC.
    let ether = database::fluid("polyphenyl-ether-5p4e").unwrap();
    assert_eq!(ether.check_range(0.34e9, 313.15), []);
    assert_eq!(ether.check_range(0.35e9, 313.15).len(), 1);
}

/// A fluid ends where its viscosity is that of a glass.
#[test]
fn viscosities_end_where_the_liquid_is_a_glass() {
    let ether = database::fluid("polyphenyl-ether-5p4e").unwrap();
    let end = ether.highest_pressure_of_viscosity(313.15).unwrap();
    assert_relative_eq!(end, 0.343e9, max_relative = 2e-3);
    assert!(ether.viscosity(end, 313.15) < 1.01 * GLASS_VISCOSITY);
    // Below the ambient glass temperature of -28.2 degC nothing is left.
    assert_eq!(ether.highest_pressure_of_viscosity(240.0), Some(0.0));
    // A law without an upper limit: Barus with 20 1/GPa and 0.1 Pa.s has 1e12 Pa.s at ln(1e13)/20 GPa.
    let mut barus = database::fluid("squalane-pip").unwrap();
    barus.validity = None;
    barus.viscosity = ViscosityLaw::Barus(Barus::new(0.1, 20e-9).unwrap());
    assert_relative_eq!(
        barus.highest_pressure_of_viscosity(313.15).unwrap(),
        1e13_f64.ln() / 20e-9,
        max_relative = 1e-4
    );
}

#[test]
fn shear_thinning_data_are_shown() {
    let squalane = database::fluid("squalane-pip").unwrap();
    let datum = squalane
        .provenance
        .iter()
        .find(|datum| datum.key == "shear_thinning.g_c")
        .unwrap();
    assert_eq!((datum.value.as_str(), datum.unit.as_str()), ("0.01", "MPa"));
}
