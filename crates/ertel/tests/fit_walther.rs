//! Fits of Walther's law to tables as data sheets have them, made by hand from ASTM D341 and Roelands' formula.

use ertel_input::Document;
use ertel_rheology::viscosity::PressureLaw;
use ertel_rheology::{DensityLaw, Files, Fluid};

use crate::common::contains;
use ertel::fit::*;

/// An oil of 46 mm²/s at 40 degC and 6.8 mm²/s at 100 degC: A and B from lg lg(ν + 0.7) = A - B lg T, the terms below 2 mm²/s
/// being below 1e-9 here. By a calculator: lg lg 46.7 = 0.222474, lg lg 7.5 = -0.057966, lg(373.15/313.15) = 0.076115.
fn by_hand() -> (f64, f64) {
    let lg_lg = |nu: f64| (nu + 0.7).log10().log10();
    let b = (lg_lg(46.0) - lg_lg(6.8)) / (373.15f64 / 313.15).log10();
    (lg_lg(46.0) + b * 313.15f64.log10(), b)
}

/// Kinematic viscosity (mm²/s) of that oil.
fn kinematic(temperature: f64) -> f64 {
    let (a, b) = by_hand();
    10f64.powf(10f64.powf(a - b * temperature.log10())) - 0.7
}

const CELSIUS: [f64; 6] = [20.0, 40.0, 50.0, 60.0, 80.0, 100.0];

fn sheet() -> String {
    let rows = CELSIUS.map(|t| format!("{t}; {:.12}\n", kinematic(t + 273.15)));
    format!(
        "Temperatur / °C; kin. Viskosität / mm²/s\n{}",
        rows.concat()
    )
}

fn density(law: &str) -> DensityLaw {
    let document = Document::parse("density.toml", format!("density = {{ {law} }}\n")).unwrap();
    let files = Files::Embedded(&[]);
    Fluid::density_from_table(&mut document.root(), files)
        .unwrap()
        .unwrap()
}

const EXPANDING: &str = "law = 'dowson-higginson', rho_0 = '870 kg/m^3', reference_temperature = '15 degC', beta = '6.4e-4 1/K'";

/// Density (kg/m³) of [`EXPANDING`] at ambient pressure, by hand.
fn expanding(temperature: f64) -> f64 {
    870.0 * (1.0 - 6.4e-4 * (temperature - 288.15))
}

fn given(law: &str, held: bool) -> Params {
    Params {
        held: held
            .then(|| ("alpha".to_owned(), 22e-9))
            .into_iter()
            .collect(),
        reference_temperature: Some(313.15),
        density: Some(density(law)),
        ..Params::default()
    }
}

fn read(text: &str, law: &str) -> Result<Data, DataError> {
    let reading = Reading {
        density: Some(density(law)),
        may_be_ambient: true,
        ..Reading::default()
    };
    Data::read("oil.csv", text, Property::Viscosity, &reading)
}

fn constant(fit: &Fit, key: &str) -> f64 {
    fit.constants.iter().find(|c| c.key == key).unwrap().value
}

/// The entry, read as a lubricant.
fn read_back(fit: &Fit, data: &Data) -> (Fluid, String) {
    let heading = Heading {
        title: "An oil".into(),
        source: "none".into(),
    };
    let text = entry(fit, data, &heading);
    let document = Document::parse("entry.toml", text.as_str()).unwrap();
    let fluid = Fluid::from_table(&mut document.root(), "x", Files::Embedded(&[]));
    (fluid.unwrap_or_else(|e| panic!("{e}\n{text}")), text)
}

#[test]
fn a_data_sheet_without_pressures_gives_a_and_b() {
    let (a, b) = by_hand();
    assert!((a - 9.417992554).abs() < 1e-8 && (b - 3.684441498).abs() < 1e-8);
    let dynamic = CELSIUS.map(|t| {
        let (t, k) = (t, t + 273.15);
        format!("{t},{:.12}\n", 1e-3 * kinematic(k) * expanding(k))
    });
    let dynamic = format!("temperature_degC,viscosity_mPa_s\n{}", dynamic.concat());
    let ambient = sheet()
        .replace('\n', "; 0\n")
        .replacen("; 0", "; Druck / MPa", 1);
    for table in [&sheet(), &dynamic, &ambient] {
        let data = read(table, EXPANDING).unwrap();
        assert_eq!(data.pressure_range(), [0.0, 0.0]);
        let notes = data.notes.join("\n");
        assert_eq!(
            notes.contains("ambient pressure"),
            table != &ambient,
            "{notes}"
        );
        let fit = fit(&data, LawName::Walther, &given(EXPANDING, true)).unwrap();
        assert!((constant(&fit, "a") / a - 1.0).abs() < 1e-6);
        assert!((constant(&fit, "b") / b - 1.0).abs() < 1e-6);
        assert_eq!(constant(&fit, "alpha"), 22e-9);
        assert!(fit.rms() < 1e-6, "{}", fit.rms());

        let (fluid, text) = read_back(&fit, &data);
        contains(&text, "[density]\nlaw = \"dowson-higginson\"");
        assert!(text.contains("alpha was given"), "{text}");
        assert_eq!(fluid.validity.as_ref().unwrap().pressure, None);
        for celsius in [10.0, 40.0, 70.0, 100.0, 120.0] {
            let t = celsius + 273.15;
            let nu = 1e6 * fluid.viscosity(0.0, t) / fluid.density(0.0, t).unwrap();
            assert!((nu / kinematic(t) - 1.0).abs() < 1e-6, "{celsius}: {nu}");
            assert_eq!(
                fluid.density(0.0, t).unwrap(),
                density(EXPANDING).density(0.0, t)
            );
        }
        let slope = fluid.pressure_viscosity_slope(313.15);
        assert!((slope / 22e-9 - 1.0).abs() < 1e-9, "{slope}");
        // The picture is one over temperature.
        let svg = picture(&fit, &data, "An oil").svg();
        assert!(svg.contains("Temperature"), "{svg}");
    }
}

/// Roelands' formula by hand, with the same index at every temperature: Z = α/5.1e-9/(ln μ₀(40 degC) + 9.67).
fn roelands(pressure: f64, temperature: f64) -> f64 {
    let ln_mu = |t: f64| (1e-6 * kinematic(t) * expanding(t)).ln();
    let z = 22e-9 / 5.1e-9 / (ln_mu(313.15) + 9.67);
    let exponent = (1.0 + 5.1e-9 * pressure).powf(z) - 1.0;
    (ln_mu(temperature) + (ln_mu(temperature) + 9.67) * exponent).exp()
}

fn barus(pressure: f64, temperature: f64) -> f64 {
    1e-6 * kinematic(temperature) * expanding(temperature) * (22e-9 * pressure).exp()
}

#[test]
fn pressures_give_the_coefficient() {
    let (a, b) = by_hand();
    for (law, made) in [
        (PressureLaw::Roelands, roelands as fn(f64, f64) -> f64),
        (PressureLaw::Barus, barus),
    ] {
        let mut table = "pressure_MPa,temperature_K,viscosity_Pa_s\n".to_owned();
        for t in [293.15, 313.15, 353.15, 373.15] {
            for p in [0.0, 100.0, 200.0, 400.0] {
                table += &format!("{p},{t},{:.12e}\n", made(1e6 * p, t));
            }
        }
        let data = read(&table, EXPANDING).unwrap();
        let params = Params {
            pressure_law: law,
            ..given(EXPANDING, false)
        };
        let fit = fit(&data, LawName::Walther, &params).unwrap();
        for (key, expected) in [("a", a), ("b", b), ("alpha", 22e-9)] {
            let found = constant(&fit, key);
            assert!(
                (found / expected - 1.0).abs() < 1e-6,
                "{law:?} {key}: {found}"
            );
        }
        let (fluid, text) = read_back(&fit, &data);
        assert_eq!(
            fluid.validity.as_ref().unwrap().pressure,
            Some((0.0, 400e6))
        );
        for (p, t) in [
            (0.0, 293.15),
            (250e6, 333.15),
            (400e6, 373.15),
            (800e6, 313.15),
        ] {
            let ratio = fluid.viscosity(p, t) / made(p, t);
            assert!((ratio - 1.0).abs() < 1e-4, "{ratio}\n{text}");
        }
        // The exponent of the temperature in the index is held at none; the data know that it is.
        let freed = Params {
            freed: vec!["alpha_exponent".into()],
            ..params
        };
        let fit = fit_of(&data, &freed);
        assert!(constant(&fit, "alpha_exponent").abs() < 1e-4);
    }
}

fn fit_of(data: &Data, params: &Params) -> Fit {
    fit(data, LawName::Walther, params).unwrap()
}

/// Every density law comes back from the entry as it went in.
#[test]
fn the_entry_holds_the_density() {
    let thermal = "reference_temperature = '313 K', beta_k = '6.09e-3 1/K', beta_k_prime = '0 1/K', a_v = '8.36e-4 1/K'";
    for law in [
        "law = 'constant', rho_0 = '0.87 g/cm^3'".to_owned(),
        EXPANDING.to_owned(),
        "law = 'tait', rho_0 = '795.5 kg/m^3', k_0r = '1.42 GPa', k_0r_prime = 10.74".to_owned(),
        format!(
            "law = 'tait', rho_0 = '795.5 kg/m^3', k_0r = '8.658 GPa', k_0r_prime = 11.74, {thermal}"
        ),
        format!(
            "law = 'murnaghan', rho_0 = '795.5 kg/m^3', k_0r = '8.658 GPa', k_0r_prime = 11.74, {thermal}"
        ),
    ] {
        let data = read(&sheet(), &law).unwrap();
        let fit = fit_of(&data, &given(&law, true));
        let (fluid, text) = read_back(&fit, &data);
        assert_eq!(fluid.density, Some(density(&law)), "{text}");
    }
}

/// Missing inputs are reported, with advice.
#[test]
fn nothing_is_assumed() {
    let data = read(&sheet(), EXPANDING).unwrap();
    let error = |params: &Params| fit(&data, LawName::Walther, params).unwrap_err();
    let none = Params::default();
    assert_eq!(error(&none), FitError::NoDensity);
    assert_eq!(error(&given(EXPANDING, false)), FitError::NoPressures);
    let nowhere = Params {
        reference_temperature: None,
        ..given(EXPANDING, true)
    };
    assert_eq!(error(&nowhere), FitError::NoReferenceTemperature);
    let tabulated = "law = 'table', units = { pressure = 'MPa', density = 'kg/m^3' }, isotherms = [{ temperature = '40 degC', pressure = \
                     [0, 100], density = [850, 890] }]";
    assert_eq!(error(&given(tabulated, true)), FitError::TabulatedDensity);
    let negative = Params {
        held: vec![("alpha".to_owned(), -1e-9)],
        ..given(EXPANDING, true)
    };
    assert!(matches!(error(&negative), FitError::Held(_)));
    // One temperature, and two viscosities for two constants.
    let one = "temperature_degC,viscosity_mPa_s\n40,39\n40,40\n40,38\n";
    let one = read(one, EXPANDING).unwrap();
    assert!(matches!(
        fit(&one, LawName::Walther, &given(EXPANDING, true)),
        Err(FitError::Undetermined { key: "b", .. })
    ));
    let two = "temperature_degC,viscosity_mPa_s\n40,39\n100,5.6\n";
    let two = read(two, EXPANDING).unwrap();
    assert!(matches!(
        fit(&two, LawName::Walther, &given(EXPANDING, true)),
        Err(FitError::TooFew { .. })
    ));
    // A column of pressures by another name is not taken for none; without density, a kinematic viscosity is none.
    let hidden = read(
        "Sensor A [MPa],temperature_degC,viscosity_mPa_s\n100,40,39\n",
        EXPANDING,
    );
    let hidden = hidden.unwrap_err();
    assert!(
        hidden.problem.contains("Sensor A") && hidden.column == 1,
        "{hidden}"
    );
    let bare = Data::parse("oil.csv", &sheet(), Property::Viscosity).unwrap_err();
    assert!(bare.problem.contains("no column `pressure`"), "{bare}");
    let ambient = Reading {
        may_be_ambient: true,
        ..Reading::default()
    };
    let kinematic = Data::read("oil.csv", &sheet(), Property::Viscosity, &ambient).unwrap_err();
    assert!(kinematic.problem.contains("--density"), "{kinematic}");
}

/// Cross-validation takes the law where there are pressures and a density.
#[test]
fn the_law_is_ranked() {
    let mut table = "pressure_MPa,temperature_K,viscosity_Pa_s\n".to_owned();
    for t in [293.15, 313.15, 333.15, 353.15, 373.15] {
        for p in [0.0, 100.0, 200.0, 300.0] {
            table += &format!("{p},{t},{:.12e}\n", roelands(1e6 * p, t));
        }
    }
    let data = read(&table, EXPANDING).unwrap();
    let ranking = rank(&data, &given(EXPANDING, false));
    let best = &ranking.ranked[0];
    assert_eq!(best.fit.name, LawName::Walther);
    assert!(best.rms_left_out < 1e-6, "{}", best.rms_left_out);
    let without = rank(&data, &Params::default());
    let reason = without.unranked.iter().find(|u| u.law == LawName::Walther);
    assert!(reason.unwrap().reason.contains("density"));
}
