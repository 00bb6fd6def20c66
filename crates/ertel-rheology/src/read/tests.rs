//! Laws, fluids and solids from text: what is right is read in SI, what is wrong is named with its line.

use crate::near::near;
use approx::assert_relative_eq;

use super::Files;
use crate::provenance::Status;
use crate::{DensityLaw, Fluid, ShearThinning, Solid, ViscosityLaw, database};
use ertel_input::{Document, InputError};

const NO_FILES: Files<'_> = Files::Embedded(&[]);

fn fluid_with(text: &str, files: Files<'_>) -> Result<Fluid, InputError> {
    let document = Document::parse("case.toml", text)?;
    let mut root = document.root();
    let fluid = Fluid::from_table(&mut root, "lubricant", files)?;
    root.finish()?;
    Ok(fluid)
}

fn fluid(text: &str) -> Result<Fluid, InputError> {
    fluid_with(text, NO_FILES)
}

fn viscosity(law: &str) -> Result<ViscosityLaw, InputError> {
    fluid(&format!("viscosity = {{ {law} }}")).map(|fluid| fluid.viscosity)
}

fn density(law: &str) -> Result<DensityLaw, InputError> {
    let fluid = fluid(&format!(
        "viscosity = {{ law = \"constant\", mu_0 = \"1 mPa.s\" }}\ndensity = {{ {law} }}"
    ))?;
    Ok(fluid.density.expect("the text gives a density"))
}

/// The same values as in `tests/laws.rs`, computed independently there, now through text and units.
#[test]
fn every_law_is_read_in_si() {
    let at = |law: &str, p: f64, t: f64| viscosity(law).unwrap().viscosity(p, t);
    let close =
        |value: f64, expected: f64| assert_relative_eq!(value, expected, max_relative = 1e-9);
    close(at("law = 'constant', mu_0 = '40 mPa.s'", 1e9, 300.0), 0.04);
    close(
        at(
            "law = 'barus', mu_0 = '10 mPa.s', alpha = '20 1/GPa'",
            0.5e9,
            300.0,
        ),
        220.264657948067,
    );
    close(
        at(
            "law = 'cheng', mu_0 = '0.465 mPa.s', alpha = '0.409 1/GPa', beta = '1396.34 K', \
             gamma = '1118.62 K/GPa', reference_temperature = '24.5 degC'",
            0.4e9,
            257.15,
        ),
        6.53227392762e-3,
    );
    close(
        at(
            "law = 'roelands', mu_0 = '40 mPa.s', alpha = '22 1/GPa'",
            1e9,
            300.0,
        ),
        154144.908831,
    );
    close(
        at(
            "law = 'roelands', mu_0 = '40 mPa.s', z = 0.68, p_0 = '196 MPa'",
            0.5e9,
            300.0,
        ),
        270.773878418,
    );
    close(
        at(
            "law = 'roelands', mu_0 = '40 mPa.s', alpha = '22 1/GPa', reference_temperature = '313 K', beta = '0.04 1/K'",
            0.5e9,
            353.0,
        ),
        10.675995325,
    );
    close(
        at(
            "law = 'wlf', mu_g = '1e12 Pa.s', t_g0 = '-73.86 degC', a_1 = '19.17 K', a_2 = '4.07e-3 1/MPa', b_1 = 0.23, \
             b_2 = '0.0249 1/MPa', c_1 = 16.04, c_2 = '18.18 K'",
            0.5e9,
            333.15,
        ),
        3.58883805896,
    );
    close(
        at(
            "law = 'doolittle', mu_0 = '1.42 Pa.s', b = 4.422, r_0 = 0.6694, \
             equation_of_state = { k_0r = '1.4252 GPa', k_0r_prime = 12.82 }",
            0.5e9,
            348.0,
        ),
        400.597643019,
    );

    let at = |law: &str, p: f64, t: f64| density(law).unwrap().density(p, t);
    close(
        at("law = 'constant', rho_0 = '870 kg/m^3'", 1e9, 300.0),
        870.0,
    );
    close(
        at(
            "law = 'dowson-higginson', rho_0 = '0.87 g/cm^3'",
            1e9,
            300.0,
        ),
        1063.33333333333,
    );
    close(
        at(
            "law = 'dowson-higginson', rho_0 = '870 kg/m^3', reference_temperature = '300 K', beta = '7e-4 1/K'",
            1e9,
            320.0,
        ),
        1051.15333333333,
    );
    // By hand: (5.9e8 + 1.34e9)/(5.9e8 + 1e9) at 1 GPa.
    close(
        at(
            "law = 'dowson-higginson', rho_0 = '1000 kg/m^3', c_1 = '5.76271186440678e-10 1/Pa', c_2 = '1.69491525423729e-9 1/Pa'",
            1e9,
            300.0,
        ),
        1000.0 * 1.93 / 1.59,
    );
    close(
        at(
            "law = 'tait', rho_0 = '1260 kg/m^3', k_0r = '12.43 GPa', k_0r_prime = 4.5432, reference_temperature = '313 K', \
             beta_k = '0.0035 1/K', beta_k_prime = '0.0018 1/K', a_v = '5.2e-4 1/K'",
            0.5e9,
            343.0,
        ),
        1358.1014989,
    );
}

#[test]
fn a_table_is_read_from_isotherms_and_from_a_file() {
    let inline = viscosity(
        "law = 'table', units = { pressure = 'MPa', viscosity = 'mPa.s' }, isotherms = [ \
         { temperature = '0 degC', pressure = [0, 50, 100], viscosity = [2.0, 3.0, 4.5] }, \
         { temperature = '50 degC', pressure = [0, 100], viscosity = [1.0, 2.0] } ]",
    )
    .unwrap();
    assert_relative_eq!(inline.viscosity(50e6, 273.15), 3e-3, max_relative = 1e-12);
    near(inline.viscosity(50e6, 323.15), 1e-3 * 2.0_f64.sqrt(), 1e-12);

    let csv = "# from a viscometer\n temperature [degC], note, pressure [MPa], viscosity [mPa.s]\n50, x, 0, 1\n50, x, 50, \n\
               50,x,100,2.0\n\n0,y,0,2\n0,y,50,3\n0,y,100,4.5\n";
    let files = [("oil.csv", csv)];
    let text = "viscosity = { law = 'table', file = 'oil.csv' }";
    let from_file = fluid_with(text, Files::Embedded(&files)).unwrap().viscosity;
    assert_eq!(from_file.tabulated_range(), inline.tabulated_range());
    for (p, t) in [(0.0, 273.15), (20e6, 280.0), (150e6, 340.0)] {
        near(from_file.viscosity(p, t), inline.viscosity(p, t), 1e-12);
    }

    let folder = tempfile::tempdir().unwrap();
    std::fs::write(
        folder.path().join("oil.csv"),
        csv.replace("pressure", "absolute pressure"),
    )
    .unwrap();
    let absolute = fluid_with(text, Files::Folder(folder.path()))
        .unwrap()
        .viscosity;
    near(absolute.viscosity(50e6 - 101_325.0, 273.15), 3e-3, 1e-12);
}

/// As spreadsheets write it: a mark of the byte order, quotes, semicolons with decimal commas, units after underscores.
#[test]
fn a_table_is_read_as_spreadsheets_write_it() {
    let plain = "temperature [degC], pressure [MPa], viscosity [mPa.s]\n40,0,40\n40,500,4000.5\n";
    let read = |csv: &str| {
        let files = [("oil.csv", csv)];
        let text = "viscosity = { law = 'table', file = 'oil.csv' }";
        fluid_with(text, Files::Embedded(&files)).unwrap().viscosity
    };
    for csv in [
        "\u{feff}temperature_degC;pressure_MPa;viscosity_mPa_s\r\n40;0;40\r\n40;500;4000,5\r\n",
        "\"temperature [degC]\",\"pressure [MPa]\",\"viscosity [mPa.s]\"\n\"40\",\"0\",\"40\"\n40,500,4000.5",
        "temperature_degC\tpressure_GPa\tviscosity_Pa_s\n40\t0\t0,04\n40\t0,5\t4,0005\n",
    ] {
        let (found, expected) = (read(csv), read(plain));
        for p in [0.0, 1e8, 5e8] {
            assert_relative_eq!(
                found.viscosity(p, 313.15),
                expected.viscosity(p, 313.15),
                max_relative = 1e-12
            );
        }
    }
}

/// No pipe, device, folder, or file of the kernel is read as a table, and nothing of it is shown.
#[cfg(target_os = "linux")]
#[test]
fn a_table_is_a_regular_file() {
    let folder = tempfile::tempdir().unwrap();
    for (file, part) in [
        ("/proc/self/environ", "not a regular file"),
        ("/dev/zero", "not a regular file"),
        (".", "it is a folder"),
    ] {
        let text = format!("viscosity = {{ law = 'table', file = '{file}' }}");
        let error = fluid_with(&text, Files::Folder(folder.path())).unwrap_err();
        assert_eq!(error.key(), "viscosity.file");
        assert!(error.message().contains(part), "{error}");
        assert!(!error.to_string().contains("PATH="), "{error}");
    }
}

#[test]
fn a_table_at_fault_names_what_is_wrong() {
    let file_error = |csv: &str| {
        let files = [("oil.csv", csv)];
        let error = fluid_with(
            "\nviscosity = { law = 'table', file = 'oil.csv' }",
            Files::Embedded(&files),
        )
        .unwrap_err();
        assert_eq!(
            (error.line(), error.key()),
            (Some(2), "viscosity.file"),
            "{error}"
        );
        error.message().to_owned()
    };
    assert!(file_error("").contains("empty"));
    assert!(
        file_error("temperature [K], pressure [MPa]\n")
            .contains("oil.csv:1:1: there is no column `viscosity [unit]`")
    );
    let header = "temperature [K], pressure [MPa], viscosity [mPa.s]\n";
    assert!(file_error(&format!("{header}300, zero, 1")).contains("oil.csv:2:2: pressure: `zero`"));
    assert!(
        file_error("temperature [K], pressure [MPa], viscosity [m]\n300, 0, 1")
            .contains("oil.csv:1:3: the column `viscosity [m]` has a unit of a length")
    );

    for (rows, part) in [
        (
            "300, 50, 2\n280, 0, 1\n300, 0, 1",
            "oil.csv:4:2: pressures must increase",
        ),
        ("300, 0, -1", "oil.csv:2:3: viscosity: -1 is impossible"),
        ("-1, 0, 1", "oil.csv:2:1: temperature: -1 is impossible"),
        (
            "300, 0, 1e400",
            "oil.csv:2:3: viscosity: `1e400` is not a number",
        ),
    ] {
        let error = file_error(&format!("{header}{rows}"));
        assert!(error.contains(part), "{error}");
    }
    let twice =
        "temperature [degC], pressure [MPa], viscosity [mPa.s], viscosity [Pa.s]\n40,0,40,7\n";
    assert!(file_error(twice).contains("is a second column `viscosity`"));

    let descending = viscosity(
        "law = 'table', units = { pressure = 'MPa', viscosity = 'mPa.s' }, \
         isotherms = [{ temperature = '0 degC', pressure = [50, 0], viscosity = [2.0, 3.0] }]",
    );
    assert!(descending.unwrap_err().message().contains("must increase"));
    let both = viscosity("law = 'table', file = 'oil.csv', units = { pressure = 'MPa' }");
    assert!(both.unwrap_err().message().contains("give one form"));
    let missing = viscosity("law = 'table', file = 'absent.csv'");
    assert!(
        missing
            .unwrap_err()
            .message()
            .contains("there is no built-in file absent.csv")
    );
}

#[test]
fn doolittle_takes_the_equation_of_state_of_the_density() {
    let text = "density = { law = 'tait', rho_0 = '850 kg/m^3', k_0r = '1.4252 GPa', k_0r_prime = 12.82 }\n\
                viscosity = { law = 'doolittle', mu_0 = '1.42 Pa.s', b = 4.422, r_0 = 0.6694 }";
    let fluid = fluid(text).unwrap();
    near(fluid.viscosity(0.5e9, 348.0), 400.597643019, 1e-9);
    let error =
        viscosity("law = 'doolittle', mu_0 = '1.42 Pa.s', b = 4.422, r_0 = 0.6694").unwrap_err();
    assert!(
        error.message().contains("missing key `equation_of_state`"),
        "{error}"
    );
}

#[test]
fn unknown_names_list_the_choices() {
    let error = viscosity("law = 'roelans', mu_0 = '40 mPa.s'").unwrap_err();
    assert!(
        error.to_string().contains("did you mean `roelands`?"),
        "{error}"
    );
    assert_eq!(
        error.help(),
        [
            "`law` is one of: constant, barus, cheng, roelands, wlf, doolittle, yasutomi, mcewen, paluch, mcewen-paluch, \
          walther, table"
        ]
    );
    let error = viscosity("law = 'barus', mu_0 = '40 mPa.s', alpha = '22 1/GPa', beta = '1 1/K'")
        .unwrap_err();
    assert_eq!(error.message(), "unknown key `beta` in [viscosity]");
    let error = density("law = 'tate'").unwrap_err();
    assert!(
        error.help()[0].contains("constant, dowson-higginson, tait, murnaghan, table"),
        "{error}"
    );
}

#[test]
fn wrong_values_are_refused_at_their_key() {
    for (law, key) in [
        ("law = 'constant', mu_0 = '0 Pa.s'", "mu_0"),
        (
            "law = 'barus', mu_0 = '40 mPa.s', alpha = '22 GPa'",
            "alpha",
        ),
        ("law = 'barus', mu_0 = '40 mPa.s', alpha = 22", "alpha"),
        ("law = 'barus', mu_0 = '40 mPa.s'", "alpha"),
        (
            "law = 'roelands', mu_0 = '0.06 mPa.s', alpha = '22 1/GPa'",
            "mu_0",
        ),
        (
            "law = 'roelands', mu_0 = '40 mPa.s', alpha = '22 1/GPa', z = 0.6",
            "z",
        ),
        (
            "law = 'roelands', mu_0 = '40 mPa.s', alpha = '22 1/GPa', beta = '0.04 1/K'",
            "reference_temperature",
        ),
        (
            "law = 'roelands', mu_0 = '40 mPa.s', alpha = '22 1/GPa', beta = '0.04 1/K', reference_temperature = '-150 degC'",
            "reference_temperature",
        ),
        (
            "law = 'doolittle', mu_0 = '1 Pa.s', b = 4, r_0 = 1.0, equation_of_state = { k_0r = '1 GPa', k_0r_prime = 10 }",
            "r_0",
        ),
        (
            "law = 'doolittle', mu_0 = '1 Pa.s', b = 4, r_0 = 0.6, equation_of_state = { k_0r = '-1 GPa', k_0r_prime = 10 }",
            "equation_of_state.k_0r",
        ),
    ] {
        let error = viscosity(law).unwrap_err();
        assert_eq!(error.key(), format!("viscosity.{key}"), "{error}");
        assert_eq!(error.line(), Some(1));
    }
}

#[test]
fn a_database_fluid_takes_overrides() {
    let mut fluid = database::fluid("thesis-fluid-a").unwrap();
    let error = fluid.density(0.0, 300.0).unwrap_err().to_string();
    assert!(
        error.contains("`thesis-fluid-a`")
            && error.contains("no density law")
            && error.contains("density ="),
        "{error}"
    );

    let text = "name = 'thesis-fluid-a'\ndensity = { law = 'dowson-higginson', rho_0 = '1465.2 kg/m^3' }\n\
                heat_capacity = '1 kJ/(kg.K)'";
    let document = Document::parse("case.toml", text).unwrap();
    let mut root = document.root();
    root.required_str("name").unwrap();
    fluid.override_from(&mut root, NO_FILES).unwrap();
    root.finish().unwrap();
    assert_relative_eq!(fluid.density(0.0, 300.0).unwrap(), 1465.2);
    let heat_capacity = fluid.heat_capacity.as_ref().unwrap();
    assert_eq!(heat_capacity.constant_value(), Some(1000.0));
    let status = |key: &str| {
        let data: Vec<_> = fluid
            .provenance
            .iter()
            .filter(|datum| datum.key == key)
            .collect();
        assert_eq!(data.len(), 1, "{key}");
        data[0].status
    };
    assert_eq!(status("density.law"), Status::User);
    assert_eq!(status("heat_capacity"), Status::User);
    assert_eq!(status("viscosity.mu_0"), Status::Thesis);
}

#[test]
fn solids_are_read_and_checked() {
    let solid = |text: &str| {
        let document = Document::parse("case.toml", text)?;
        let mut root = document.root();
        let solid = Solid::from_table(&mut root, "ball", NO_FILES)?;
        root.finish()?;
        Ok::<_, InputError>(solid)
    };
    let steel =
        solid("youngs_modulus = '210 GPa'\npoissons_ratio = 0.3\ndensity = '7.85 g/cm^3'").unwrap();
    assert_eq!((steel.youngs_modulus, steel.poissons_ratio), (210e9, 0.3));
    assert_relative_eq!(steel.density.unwrap(), 7850.0);
    assert_eq!(steel.heat_capacity, None);
    assert_eq!(
        solid("youngs_modulus = '210 GPa'\npoissons_ratio = 0.51")
            .unwrap_err()
            .key(),
        "poissons_ratio"
    );
    assert_eq!(
        solid("youngs_modulus = '210 GPa'").unwrap_err().key(),
        "poissons_ratio"
    );
    assert_eq!(
        solid("youngs_modulus = '0 GPa'\npoissons_ratio = 0.3")
            .unwrap_err()
            .line(),
        Some(1)
    );
}

fn shear_thinning(law: &str) -> Result<ShearThinning, InputError> {
    let viscosity = "viscosity = { law = 'roelands', mu_0 = '40 mPa.s', alpha = '22 1/GPa' }";
    let fluid = fluid(&format!("{viscosity}\nshear_thinning = {{ {law} }}"))?;
    Ok(fluid.shear_thinning.expect("the text gives shear thinning"))
}

/// Closed forms at stresses where they are simple: what is read is what is written, in SI.
#[test]
fn every_shear_thinning_law_is_read_in_si() {
    let at = |law: &str, stress: f64, p: f64| {
        shear_thinning(law)
            .unwrap()
            .relative_fluidity(stress * stress, p)
    };
    let close =
        |value: f64, expected: f64| assert_relative_eq!(value, expected, max_relative = 1e-11);
    // τ = G_c, μ₂ = μ₁/4: η/μ₁ = 1/4 + 3/4 2^(-1/2) with n = 1/2, β = 2.
    let expected = (0.25 + 0.75 / f64::sqrt(2.0)).recip();
    close(
        at(
            "law = 'carreau', g_c = '10 kPa', n = 0.5, beta_c = 2, mu_2 = '10 mPa.s'",
            1e4,
            0.0,
        ),
        expected,
    );
    // λγ̇ = 1, a = 2, n = 1/2: η/μ₁ = 1/4 + 3/4 2^(-1/4), τ = G η/μ₁.
    let share = 0.25 + 0.75 * 2.0_f64.powf(-0.25);
    close(
        at(
            "law = 'carreau-yasuda', g = '0.1 MPa', n = 0.5, a = 2, mu_2 = '10 mPa.s'",
            1e5 * share,
            0.0,
        ),
        share.recip(),
    );
    let sinh = "law = 'ree-eyring', tau_0 = '5 MPa'";
    close(at(sinh, 1e7, 0.0), 2.0_f64.sinh() / 2.0);
    close(
        at("law = 'rabinowitsch', tau_0 = '1 MPa', n = 0.5", 3e6, 0.0),
        4.0,
    );
    // τ_L = 5 + 0.05·500 = 30 MPa; atanh(1/2) = ln(3)/2.
    let limit = "tau_l0 = '5 MPa', lambda = 0.05";
    let factor = 3.0_f64.ln();
    close(
        at(&format!("law = 'limiting-stress', {limit}"), 15e6, 0.5e9),
        factor,
    );
    close(
        at(&format!("{sinh}, limit = {{ {limit} }}"), 15e6, 0.5e9),
        factor * 3.0_f64.sinh() / 3.0,
    );
}

/// `mu_2` is a viscosity at a temperature, the share of it in the first plateau holds at all.
#[test]
fn the_second_plateau_is_that_of_the_reference_temperature() {
    let roelands = |more: &str| {
        format!(
            "viscosity = {{ law = 'roelands', mu_0 = '40 mPa.s', alpha = '22 1/GPa', \
             reference_temperature = '313 K', beta = '0.04 1/K' }}\n\
             shear_thinning = {{ law = 'carreau', g_c = '10 kPa', n = 0.5, beta_c = 2, mu_2 = '10 mPa.s' {more} }}"
        )
    };
    let ratio = |text: &str| {
        let law = fluid(text).unwrap().shear_thinning.unwrap().law.unwrap();
        law.plateau_ratio().unwrap()
    };
    assert_relative_eq!(ratio(&roelands("")), 0.25, max_relative = 1e-12);
    // The temperature of the law takes precedence over that of the fluid, the one given with `mu_2` over both.
    let fluid_too = format!("reference_temperature = '353 K'\n{}", roelands(""));
    assert_relative_eq!(ratio(&fluid_too), 0.25, max_relative = 1e-12);
    let own = roelands(", reference_temperature = '333 K'");
    let expected = 0.010
        / viscosity(
            "law = 'roelands', mu_0 = '40 mPa.s', alpha = '22 1/GPa', \
                                      reference_temperature = '313 K', beta = '0.04 1/K'",
        )
        .unwrap()
        .viscosity(0.0, 333.0);
    assert!(expected > 0.4);
    assert_relative_eq!(ratio(&own), expected, max_relative = 1e-12);

    // A law without such a constant takes that of the fluid: 14.74 mPa.s at 40 °C.
    let wlf = "viscosity = { law = 'wlf', mu_g = '1e12 Pa.s', t_g0 = '-73.86 degC', a_1 = '19.17 K', \
               a_2 = '4.07e-3 1/MPa', b_1 = 0.23, b_2 = '0.0249 1/MPa', c_1 = 16.04, c_2 = '18.18 K' }\n\
               shear_thinning = { law = 'carreau', g_c = '10 kPa', n = 0.5, beta_c = 2, mu_2 = '10 mPa.s' }";
    let error = fluid(wlf).unwrap_err().to_string();
    assert!(error.contains("`mu_2` belongs to a temperature"), "{error}");
    let with_temperature = format!("reference_temperature = '40 degC'\n{wlf}");
    near(ratio(&with_temperature), 0.010 / 0.0147392783087, 1e-10);
    // Equal plateaus: Newtonian, to round-off.
    for viscosity in ["70.5 mPa.s", "40 mPa.s", "0.3 mPa.s", "1.42 Pa.s"] {
        let text = roelands("").replace("10 mPa.s", viscosity);
        let text = text.replace("40 mPa.s", viscosity);
        assert_relative_eq!(ratio(&text), 1.0, max_relative = 1e-12);
    }
    // No second plateau needs no temperature.
    let none = wlf.replace("10 mPa.s", "0 Pa.s");
    assert_eq!(ratio(&none), 0.0);
}

#[test]
fn shear_thinning_of_the_database_can_be_replaced() {
    let squalane = database::fluid("squalane-pip").unwrap();
    let document = Document::parse(
        "case.toml",
        "shear_thinning = { law = 'ree-eyring', tau_0 = '5 MPa', limit = { tau_l0 = '5 MPa', lambda = 0.05 } }",
    )
    .unwrap();
    let mut root = document.root();
    let mut replaced = squalane.clone();
    replaced.override_from(&mut root, NO_FILES).unwrap();
    let law = replaced.shear_thinning.as_ref().unwrap();
    assert_eq!(law.describe(), "ree-eyring with limiting stress");
    let records: Vec<_> = replaced
        .provenance
        .iter()
        .filter(|datum| datum.key.starts_with("shear_thinning"))
        .collect();
    assert_eq!(records.len(), 1);
    assert_eq!(records[0].value, "ree-eyring with limiting stress");
    assert_eq!(records[0].status, Status::User);
    assert_eq!(replaced.viscosity, squalane.viscosity);
}
