//! Fits of laws: published tables, known constants from made data, coverage of the intervals.

use ertel_input::Document;
use ertel_rheology::{Files, Fluid};

use ertel::fit::*;

/// Standard normal numbers (Box and Muller 1958).
fn normal(random: &mut fastrand::Rng) -> f64 {
    let radius = (-2.0 * (1.0 - random.f64()).ln()).sqrt();
    radius * (std::f64::consts::TAU * random.f64()).cos()
}

fn grid(property: Property, temperatures: &[f64], law: impl Fn(f64, f64) -> f64) -> Data {
    let mut states = Vec::new();
    for temperature in temperatures {
        for k in 0..9 {
            let pressure = 50e6 * f64::from(k);
            states.push(State {
                pressure,
                temperature: *temperature,
                value: law(pressure, *temperature),
                line: states.len() + 2,
            });
        }
    }
    Data {
        file: "made.csv".into(),
        property,
        states,
        notes: Vec::new(),
    }
}

const TEMPERATURES: [f64; 4] = [293.15, 313.15, 333.15, 373.15];

/// Fits the states of a law of the database, and of them with noise.
fn recovered(law: LawName, fluid: &str, temperatures: &[f64], params: &Params, keys: &[&str]) {
    let fluid = ertel_rheology::database::fluid(fluid).unwrap();
    let data = grid(law.property(), temperatures, |p, t| match law.property() {
        Property::Viscosity => fluid.viscosity(p, t),
        Property::Density => fluid.density(p, t).unwrap(),
    });
    let fit = fit(&data, law, params).unwrap();
    assert!(fit.rms() < 1e-7, "{}: rms {}", law.name(), fit.rms());
    for key in keys {
        let prefix = format!("{}.{key}", law.property().name());
        let datum = fluid.provenance.iter().find(|d| d.key == prefix).unwrap();
        let unit = if datum.unit == "1" { "" } else { &datum.unit };
        let expected = parse_constant(law, key, &format!("{} {unit}", datum.value)).unwrap();
        let found = fit.constants.iter().find(|c| c.key == *key).unwrap().value;
        assert!(
            (found / expected - 1.0).abs() < 1e-3,
            "{}: {key} is {found}, expected {expected}",
            law.name()
        );
    }
    reads_back(&fit, &data);
}

/// The entry, read as a fluid, has the law that was fitted, to the six digits written.
fn reads_back(fit: &Fit, data: &Data) {
    let heading = Heading {
        title: "A \"fluid\"".into(),
        source: "none".into(),
    };
    let mut text = entry(fit, data, &heading);
    if data.property == Property::Density {
        text += "\n[viscosity]\nlaw = \"constant\"\nmu_0 = \"1 mPa.s\"\n";
    }
    let document = Document::parse("entry.toml", text.as_str()).unwrap();
    let folder = std::path::Path::new(".");
    let fluid = Fluid::from_table(&mut document.root(), "x", Files::Folder(folder))
        .unwrap_or_else(|error| panic!("{error}\n{text}"));
    for state in &data.states {
        let (p, t) = (state.pressure, state.temperature);
        let read = match data.property {
            Property::Viscosity => fluid.viscosity(p, t),
            Property::Density => fluid.density(p, t).unwrap(),
        };
        let ratio = read / fit.law.ln_value(p, t).exp();
        assert!((ratio - 1.0).abs() < 1e-3, "{ratio}\n{text}");
    }
    let validity = fluid.validity.unwrap();
    assert_eq!(validity.pressure, Some((0.0, 400e6)));
}

#[test]
fn constants_of_known_laws_are_recovered() {
    let at = |t: f64| Params {
        reference_temperature: Some(t),
        ..Params::default()
    };
    recovered(
        LawName::Cheng,
        "thesis-fluid-a",
        &TEMPERATURES,
        &at(297.65),
        &["mu_0", "alpha", "beta", "gamma"],
    );
    recovered(
        LawName::Roelands,
        "thesis-roelands-oil",
        &[313.15],
        &Params::default(),
        &["mu_0", "alpha"],
    );
    recovered(
        LawName::Wlf,
        "thesis-wlf-oil",
        &TEMPERATURES,
        &Params::default(),
        &["t_g0", "a_1", "a_2", "b_1", "b_2", "c_1", "c_2"],
    );
    recovered(
        LawName::Barus,
        "thesis-fluid-c",
        &[313.15],
        &Params::default(),
        &["mu_0", "alpha"],
    );
    recovered(
        LawName::Tait,
        "squalane-pip",
        &TEMPERATURES,
        &at(313.0),
        &["rho_0", "k_0r", "k_0r_prime", "beta_k", "a_v"],
    );
    recovered(
        LawName::DowsonHigginson,
        "holmes-evans-oil",
        &[313.15],
        &Params::default(),
        &["rho_0", "c_1", "c_2"],
    );
    let squalane = ertel_rheology::database::fluid("squalane-pip").unwrap();
    let Some(ertel_rheology::DensityLaw::Tait(tait)) = squalane.density else {
        panic!()
    };
    let params = Params {
        equation_of_state: Some(tait.volume),
        ..Params::default()
    };
    recovered(
        LawName::Doolittle,
        "squalane-pip",
        &TEMPERATURES,
        &params,
        &["mu_0", "b", "r_0", "epsilon"],
    );
}

/// 200 tables with 3 % noise: a 95 % interval must hold the true constant in 190 ± 3 of them; 91 to 99 % is
/// ±2.6 standard deviations.
fn coverage(law: LawName, fluid: &str, temperatures: &[f64], noise: f64, keys: &[&str]) {
    let fluid = ertel_rheology::database::fluid(fluid).unwrap();
    let truth = grid(law.property(), temperatures, |p, t| match law.property() {
        Property::Viscosity => fluid.viscosity(p, t),
        Property::Density => fluid.density(p, t).unwrap(),
    });
    let params = Params {
        reference_temperature: fluid.reference_temperature,
        ..Params::default()
    };
    let exact = fit(&truth, law, &params).unwrap();
    let mut random = fastrand::Rng::with_seed(2008);
    let mut n_held = vec![0; keys.len()];
    let n_tables = 200;
    for _ in 0..n_tables {
        let mut data = truth.clone();
        for state in &mut data.states {
            state.value *= (noise * normal(&mut random)).exp();
        }
        let fit = fit(&data, law, &params).unwrap();
        for (key, n) in keys.iter().zip(&mut n_held) {
            let constant = |fit: &Fit| fit.constants.iter().find(|c| c.key == *key).cloned();
            let [low, high] = constant(&fit).unwrap().interval.unwrap();
            let value = constant(&exact).unwrap().value;
            *n += usize::from(low <= value && value <= high);
        }
    }
    for (key, n) in keys.iter().zip(n_held) {
        let share = n as f64 / f64::from(n_tables);
        assert!(
            (0.91..=0.99).contains(&share),
            "{} {key}: {share}",
            law.name()
        );
    }
}

#[test]
fn intervals_cover_at_the_stated_rate() {
    coverage(
        LawName::Cheng,
        "thesis-fluid-a",
        &TEMPERATURES,
        0.03,
        &["mu_0", "alpha", "beta", "gamma"],
    );
    coverage(
        LawName::Roelands,
        "thesis-roelands-oil",
        &[313.15],
        0.03,
        &["mu_0", "alpha"],
    );
    coverage(
        LawName::Barus,
        "thesis-fluid-c",
        &[313.15],
        0.03,
        &["mu_0", "alpha"],
    );
    coverage(
        LawName::Tait,
        "squalane-pip",
        &TEMPERATURES,
        2e-4,
        &["rho_0", "k_0r", "k_0r_prime", "beta_k", "a_v"],
    );
}

fn published(file: &str) -> Data {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../../validation/appendix-c")
        .join(file);
    Data::parse(
        file,
        &std::fs::read_to_string(path).unwrap(),
        Property::Viscosity,
    )
    .unwrap()
}

/// Habchi 2008, appendix C: its constants of Cheng's law lie in the intervals of fits to its tables, with the reference
/// viscosity held at the measured one as there. Its own fit seems to have minimised absolute deviations: so fitted, ours
/// differ by 1.2 % (A) and 3.4 % (B) of the half-width at most; minimising relative deviations, by up to 70 %.
#[test]
fn appendix_c_of_habchi() {
    for (file, t_r, mu_0, printed) in [
        (
            "fluid-a.csv",
            297.65,
            0.465e-3,
            [0.409e-9, 1396.34, 1118.62e-9],
        ),
        (
            "fluid-b.csv",
            272.65,
            0.268e-3,
            [-4.567e-9, 959.02, 1940.72e-9],
        ),
    ] {
        let data = published(file);
        for residual in [Residual::Relative, Residual::Absolute] {
            let params = Params {
                held: vec![("mu_0".into(), mu_0)],
                reference_temperature: Some(t_r),
                residual,
                ..Params::default()
            };
            let fit = fit(&data, LawName::Cheng, &params).unwrap();
            for (constant, printed) in fit.constants[1..].iter().zip(printed) {
                let [low, high] = constant.interval.unwrap();
                assert!(
                    low < printed && printed < high,
                    "{file} {residual:?} {}: {low} to {high}",
                    constant.key
                );
                if residual == Residual::Absolute {
                    let off = (constant.value - printed).abs() / (0.5 * (high - low));
                    assert!(off < 0.04, "{file} {}: {off}", constant.key);
                }
            }
        }
    }
}

#[test]
fn undetermined_constants_are_refused_or_give_a_warning() {
    let params = Params::default();
    let isotherm = grid(Property::Viscosity, &[313.15], |p, _| {
        0.01 * (15e-9 * p).exp()
    });
    // One isotherm has no β
    let error = fit(&isotherm, LawName::Cheng, &params).unwrap_err();
    assert!(
        matches!(error, FitError::Undetermined { key: "beta", .. }),
        "{error}"
    );
    // nearly equal temperatures determine only α + γ/T
    let near = grid(Property::Viscosity, &[313.15, 314.15], |p, t| {
        0.01 * (10e-9 * p + 1000.0 * (1.0 / t - 1.0 / 313.15) + 2e-6 * p / t).exp()
    });
    let fitted = fit(&near, LawName::Cheng, &params).unwrap();
    assert!(
        fitted.warnings.iter().any(|w| w.contains("alpha, gamma")),
        "{:?}",
        fitted.warnings
    );
    // Barus and several temperatures
    let fitted = fit(&near, LawName::Barus, &params).unwrap();
    assert!(fitted.warnings.iter().any(|w| w.contains("temperature")));
    // Three states, four constants
    let mut few = near.clone();
    few.states.truncate(3);
    assert!(matches!(
        fit(&few, LawName::Cheng, &params),
        Err(FitError::TooFew { .. })
    ));
    let wrong = fit(&near, LawName::Tait, &params).unwrap_err();
    assert!(wrong.to_string().contains("cheng, roelands"), "{wrong}");
    assert_eq!(
        fit(&near, LawName::Doolittle, &params).unwrap_err(),
        FitError::NoEquationOfState
    );
    let unknown = parse_constant(LawName::Cheng, "delta", "1").unwrap_err();
    assert!(unknown.to_string().contains("mu_0, alpha"), "{unknown}");
    let unit = parse_constant(LawName::Cheng, "beta", "1 MPa").unwrap_err();
    assert!(unit.to_string().contains("beta"), "{unit}");
}
