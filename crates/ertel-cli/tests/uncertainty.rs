//! Sensitivities and uncertain inputs from the command line.

use serde_json::Value;

use crate::common::{Workspace, code, contains};

const CASE: &str = concat!(
    "[contact]\nkind = \"line\"\nradius = \"10 mm ± 0.5 %\"\nload = \"50 kN/m ± 5 %\"\n",
    "[bodies]\nbody_1 = \"steel\"\nbody_2 = \"steel\"\n",
    "[motion]\nentrainment_speed = \"[1.9, 2.1] m/s\"\nslide_to_roll_ratio = 0\n",
    "[lubricant]\ntemperature = \"60 degC\"\ndensity = { law = \"dowson-higginson\", rho_0 = \"870 kg/m^3\" }\nviscosity = { law = \"roelands\", mu_0 = \"20 ± 1 mPa.s\", alpha = \"18 1/GPa ± 4 %\" }\n",
    "[mesh]\ntarget_error = \"1 %\"\n"
);

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value}"))
}

/// Standard deviations by hand: 0.25, 2.5, 0.1/√3/2 = 2.887, 2.5 and 2 %; with the sensitivities of the file, the root of the sum of squares.
#[test]
fn uncertainty_is_the_root_of_the_sum_of_squares() {
    let workspace = Workspace::new(&[("line.toml", CASE)]);
    let report = workspace.succeed("solve line.toml --output out");
    contains(&report, "Uncertainty of the inputs, to first order");
    contains(&report, "Sensitivities: per cent");
    let result = workspace.json("out/result.json");
    assert_eq!(result["sensitivities_by"], "linear solves");
    for figure in ["film_central", "film_minimum", "friction_power"] {
        let by = &result["sensitivities"][figure];
        let square: f64 = [
            ("contact.radius", 0.0025),
            ("contact.load", 0.025),
            ("motion.entrainment_speed", 0.05 / 3.0_f64.sqrt()),
            ("lubricant.viscosity.mu_0", 0.025),
            ("lubricant.viscosity.alpha", 0.02),
        ]
        .iter()
        .map(|(key, standard)| (number(&by[key]) * standard).powi(2))
        .sum();
        let found = &result["uncertainty"][figure];
        let expected = 2.0 * square.sqrt() * number(&found["value"]);
        let error = number(&found["half_width"]) / expected - 1.0;
        assert!(error.abs() < 1e-10, "{figure}: {error:e}");
    }
}

/// Both are near linear here: standard deviations agree within three standard errors. A second run finds all samples in the journal and
/// gives the same bytes.
#[test]
fn samples_agree_with_the_first_order() {
    let workspace = Workspace::new(&[("line.toml", CASE)]);
    let run = "solve line.toml --output out --monte-carlo 120";
    let report = workspace.succeed(run);
    contains(&report, "120 of 120 samples solved");
    let found = workspace.json("out-monte-carlo/monte-carlo.json");
    for figure in ["film_central", "film_minimum"] {
        let figure = &found["figures"][figure];
        let [sampled, first, error] = ["standard", "standard_of_first_order", "standard_error"]
            .map(|key| number(&figure[key]));
        assert!((sampled - first).abs() < 3.0 * error, "{figure}");
        let correlation = number(&figure["correlations"]["motion.entrainment_speed"]);
        assert!((0.3..0.9).contains(&correlation), "{correlation}");
        let median = number(&figure["quantiles"]["0.5"]);
        assert!((median / number(&figure["mean"]) - 1.0).abs() < 0.02);
    }
    let text = std::fs::read(workspace.path("out-monte-carlo/monte-carlo.json")).unwrap();
    workspace.succeed(run);
    let again = std::fs::read(workspace.path("out-monte-carlo/monte-carlo.json")).unwrap();
    assert_eq!(text, again);
    assert!(workspace.path("out-monte-carlo/monte-carlo.svg").is_file());
}

/// A fitted oil brings its uncertainty along: its constants are correlated, which makes a film less uncertain than each of them alone would.
#[test]
fn fits_hand_their_uncertainty_on() {
    let mut data = String::from("pressure [MPa],temperature [degC],viscosity [Pa.s]\n");
    // Roelands' law by hand (Pa, K), scattered by ±1 % in turn.
    for (i, p) in [0.0, 100.0, 200.0, 300.0, 400.0, 600.0, 800.0]
        .into_iter()
        .enumerate()
    {
        for (j, t) in [40.0, 60.0, 80.0].into_iter().enumerate() {
            let cold: f64 = 0.04 * (-0.04 * (t - 40.0_f64)).exp();
            let scatter = 1.0 + 0.01 * [1.0, -1.0, 0.5][(i + 2 * j) % 3];
            let mu =
                (cold.ln() + (cold.ln() + 9.67) * ((1.0_f64 + p / 196.0).powf(0.6) - 1.0)).exp();
            data += &format!("{p},{t},{}\n", mu * scatter);
        }
    }
    let contact = "[contact]\nkind = \"line\"\nradius = \"10 mm\"\nload = \"50 kN/m\"\n";
    let bodies = "[bodies]\nbody_1 = \"steel\"\nbody_2 = \"steel\"\n";
    let motion = "[motion]\nentrainment_speed = \"2 m/s\"\nslide_to_roll_ratio = 0\n";
    let oil = "lubricant = \"oil.toml\"\ntemperature = \"75 degC\"\n";
    let case = &[oil, contact, bodies, motion].concat();
    let workspace = Workspace::new(&[("data.csv", &data), ("line.toml", case)]);
    workspace.succeed("fit viscosity data.csv --law roelands --output oil.toml");
    let oil = std::fs::read_to_string(workspace.path("oil.toml")).unwrap();
    contains(&oil, " ± ");
    contains(&oil, "[[correlation]]");
    let complete = oil.replacen(
        "[viscosity]",
        "[density]\nlaw = \"dowson-higginson\"\nrho_0 = \"870 kg/m^3\"\n\n[viscosity]",
        1,
    );
    std::fs::write(workspace.path("oil.toml"), &complete).unwrap();
    workspace.succeed("solve line.toml --output out");
    let result = workspace.json("out/result.json");
    // By hand from the entry: relative standard deviations, half of what follows the ±, and the coefficients.
    let relative = |key: &str| {
        let line = (oil.lines().find(|l| l.starts_with(&format!("{key} = \"")))).unwrap();
        let text = line.split('"').nth(1).unwrap();
        let (value, width) = text.split_once(" ± ").unwrap();
        let [value, width] =
            [value, width].map(|t| t.split(' ').next().unwrap().parse::<f64>().unwrap());
        0.5 * width / value
    };
    let coefficient = |of: &str, with: &str| {
        let named = |block: &&str| {
            block.contains(&format!("of = \"viscosity.{of}\""))
                && block.contains(&format!("with = \"viscosity.{with}\""))
        };
        let block = oil.split("[[correlation]]").skip(1).find(named)?;
        block
            .split("coefficient = ")
            .nth(1)?
            .trim()
            .parse::<f64>()
            .ok()
    };
    let keys = ["mu_0", "alpha", "beta"];
    let by = &result["sensitivities"]["film_central"];
    let effect = |key: &str| number(&by[format!("lubricant.viscosity.{key}")]) * relative(key);
    let (mut square, mut alone) = (0.0, 0.0);
    for one in keys {
        alone += effect(one).powi(2);
        for other in keys {
            let correlation = match one == other {
                true => Some(1.0),
                false => coefficient(one, other).or_else(|| coefficient(other, one)),
            };
            square += effect(one) * effect(other) * correlation.unwrap();
        }
    }
    let found = &result["uncertainty"]["film_central"];
    let expected = 2.0 * square.sqrt() * number(&found["value"]);
    let error = number(&found["half_width"]) / expected - 1.0;
    assert!(error.abs() < 1e-4, "{error:e}");
    assert!((square / alone - 1.0).abs() > 0.01, "{square:e} {alone:e}");
}

#[test]
fn bad_uncertainties_exit_with_2() {
    for (old, new, part) in [
        ("± 5 %", "± 60 %", "reaches"),
        ("± 5 %", "± 5 mm", "is a length"),
        ("± 5 %", "± -5 %", "above zero"),
        ("± 5 %", "± nan %", "no number"),
        ("[1.9, 2.1] m/s", "[2.1, 1.9] m/s", "below the second"),
        ("[1.9, 2.1] m/s", "[1.9, 2.1", "not closed"),
        ("60 degC", "60 degC ± 5 %", "write the ± in K"),
        ("\"1 %\"", "\"1 % ± 10 %\"", "numerical setting"),
        (
            "[bodies]",
            "[[correlation]]\nof = \"contact.load\"\nwith = \"motion.slide_to_roll_ratio\"\ncoefficient = 0.5\n[bodies]",
            "has no uncertainty",
        ),
        (
            "[bodies]",
            "[[correlation]]\nof = \"contact.load\"\nwith = \"contact.radius\"\ncoefficient = 1.5\n[bodies]",
            "between -1 and 1",
        ),
    ] {
        let workspace = Workspace::new(&[("line.toml", &CASE.replacen(old, new, 1))]);
        let output = workspace.ertel("solve line.toml --output out");
        let error = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{new}: {error}");
        assert!(
            error.contains(part) && error.contains("line.toml:"),
            "{new}: {error}"
        );
        assert!(!workspace.path("out").exists());
    }
    // Three correlations that no three quantities can have.
    let pairs = [
        ("load", "radius", 0.9),
        ("load", "mu", 0.9),
        ("radius", "mu", -0.9),
    ];
    let name = |key: &str| match key {
        "mu" => "lubricant.viscosity.mu_0".to_owned(),
        key => format!("contact.{key}"),
    };
    let mut text = CASE.to_owned();
    for (of, with, coefficient) in pairs {
        text += &format!(
            "[[correlation]]\nof = \"{}\"\nwith = \"{}\"\ncoefficient = {coefficient}\n",
            name(of),
            name(with)
        );
    }
    let certain = CASE
        .replace(" ± 0.5 %", "")
        .replace(" ± 5 %", "")
        .replace(" ± 4 %", "");
    let certain = certain.replace("[1.9, 2.1]", "2").replace("20 ± 1", "20");
    let curve = format!(
        "{CASE}[curve]\nquantity = \"contact.load\"\nvalues = [\"50 kN/m\", \"60 kN/m\"]\n"
    );
    for (text, arguments, part) in [
        (text, "", "negative variance"),
        (
            certain.clone(),
            "--monte-carlo 20",
            "no input has an uncertainty",
        ),
        (CASE.to_owned(), "--monte-carlo 1", "from 2 to"),
        (curve, "--monte-carlo 20", "[curve]"),
    ] {
        let workspace = Workspace::new(&[("line.toml", &text)]);
        let output = workspace.ertel(&format!("solve line.toml --output out {arguments}"));
        let error = String::from_utf8_lossy(&output.stderr).into_owned();
        code(&output, 2);
        contains(&error, part);
    }
}

/// Contacts with heat: differences of solves for the uncertain inputs, and only for them.
#[test]
fn heat_takes_differences_of_solves() {
    let heat = CASE.replacen(" ± 0.5 %", "", 1).replacen(" ± 4 %", "", 1)
        .replace("[1.9, 2.1]", "2").replace("20 ± 1", "20")
        .replace("slide_to_roll_ratio = 0", "slide_to_roll_ratio = 0.2")
        .replace("density = {", "thermal_conductivity = \"0.13 W/(m.K)\"\nheat_capacity = \"2000 J/(kg.K)\"\ndensity = {")
        .replace("alpha = \"18 1/GPa\"", "alpha = \"18 1/GPa\", beta = \"0.04 1/K\", reference_temperature = \"60 degC\"")
        + "[thermal]\n";
    let workspace = Workspace::new(&[("line.toml", &heat)]);
    workspace.succeed("solve line.toml --output out");
    let result = workspace.json("out/result.json");
    assert_eq!(result["sensitivities_by"], "differences of solves");
    let by = result["sensitivities"]["film_central"].as_object().unwrap();
    assert_eq!(by.keys().collect::<Vec<_>>(), ["contact.load"]);
    // The same by two solves from the command line, 3 % apart on separate meshes.
    let at = |load: &str| {
        let text = heat.replace("50 kN/m ± 5 %", load);
        std::fs::write(workspace.path("side.toml"), text).unwrap();
        workspace.succeed("solve side.toml --output side");
        let result = workspace.json("side/result.json");
        assert!(result["sensitivities"].is_null());
        number(&result["figures"]["traction_coefficient"]["value"])
    };
    let slope = (at("52 kN/m").ln() - at("48 kN/m").ln()) / (52.0_f64.ln() - 48.0_f64.ln());
    let found = number(&result["sensitivities"]["traction_coefficient"]["contact.load"]);
    assert!(
        (found - slope).abs() < 0.05 * slope.abs().max(0.2),
        "{found} {slope}"
    );
}

/// Inputs without a derivative are reported, with a warning if they are uncertain: a meniscus ends the mesh.
#[test]
fn neglected_uncertainties_are_reported() {
    let inlet = "[inlet]\nmeniscus_distance = \"0.6 mm ± 5 %\"\n[bodies]";
    let workspace = Workspace::new(&[("line.toml", &CASE.replacen("[bodies]", inlet, 1))]);
    workspace.succeed("solve line.toml --output out");
    let result = workspace.json("out/result.json");
    let left_out = &result["sensitivities_left_out"];
    for key in [
        "inlet.meniscus_distance",
        "bodies.body_1.youngs_modulus",
        "bodies.body_2.youngs_modulus",
    ] {
        contains(left_out[key].as_str().unwrap(), "edge");
    }
    let warnings = result["warnings"].as_array().unwrap();
    let is_it = |w: &&Value| {
        w.as_str()
            .is_some_and(|w| w.contains("neglects that of inlet.meniscus_distance"))
    };
    assert_eq!(warnings.iter().filter(is_it).count(), 1, "{warnings:?}");
}
