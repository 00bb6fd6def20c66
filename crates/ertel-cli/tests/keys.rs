//! The table of keys against the readers: each key is given a wrong value, and the reader's refusal shows kind, dimension, bounds, choices.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use ertel::case::Case;
use ertel_input::InputError;
use ertel_input::keys::{self, Kind, Laws, Row};

use crate::common::root;
use crate::schema::cases;

/// Whether a refusal is the expected one.
type Check<'a> = Box<dyn Fn(&InputError) -> bool + 'a>;

/// A wrong value of a row, and whether a refusal of it is that of a reader that sees the key as the row does.
fn wrong<'a>(path: &str, row: &'a Row) -> (&'static str, Check<'a>) {
    let says = |words: String| move |error: &InputError| error.message().contains(&words);
    // A curve lists the quantities that the case has.
    let is_of_case = path == "curve.quantity";
    let names = |choices: Vec<&'static str>| {
        let choices: BTreeSet<&str> = choices.into_iter().collect();
        move |error: &InputError| {
            let word = |word: &str| word.trim_matches('"').to_owned();
            let of = |text: &str| -> BTreeSet<String> { text.split(", ").map(word).collect() };
            let texts = error
                .help()
                .iter()
                .map(String::as_str)
                .chain([error.message()]);
            let lists = texts.filter_map(|text| {
                ["is one of: ", "choices are ", "formats are ", "codes are "]
                    .iter()
                    .find_map(|m| Some(text.split_once(m)?.1))
            });
            let own: BTreeSet<String> = choices.iter().map(|c| (*c).to_owned()).collect();
            lists
                .map(of)
                .any(|list| list == own || is_of_case && list.is_subset(&own))
        }
    };
    let lacks_unit = |error: &InputError| {
        let (Kind::Quantity(all) | Kind::Quantities(all)) = row.kind else {
            return true;
        };
        let text = error.to_string();
        error.message().ends_with("has no unit")
            && all
                .iter()
                .any(|d| text.contains(&format!("{} is needed", d.name())))
    };
    if let Some(laws) = path.strip_suffix(".law").and_then(laws_of) {
        return (
            "\"zzzz\"",
            Box::new(names(laws.laws.iter().map(|law| law.name).collect())),
        );
    }
    match (row.kind, row.bounds.and_then(|bounds| bounds.ends())) {
        (Kind::Text | Kind::Fluid | Kind::Solid, _) => {
            // Numbers are texts, too: `designation = 6206`.
            ("true", Box::new(says("must be a string".to_owned())))
        }
        (Kind::Switch, _) => ("1", Box::new(says("must be true or false".to_owned()))),
        (Kind::Count, Some([low, high])) => (
            "99999999999",
            Box::new(says(format!("must be a whole number from {low} to {high}"))),
        ),
        (Kind::Count, None) => (
            "99999999999",
            Box::new(says("must be a whole number from".to_owned())),
        ),
        (Kind::Number | Kind::Share, Some(_)) => (
            "1e300",
            Box::new(says(format!("must be {}", row.bounds.unwrap()))),
        ),
        (Kind::Number | Kind::Share, None) => {
            ("true", Box::new(says("must be a number".to_owned())))
        }
        (Kind::Numbers, _) => ("[true]", Box::new(says("must be a number".to_owned()))),
        (Kind::Quantity(_) | Kind::QuantityOr(_) | Kind::LawOr(..), _) => {
            ("1", Box::new(lacks_unit))
        }
        (Kind::Quantities(_), _) => ("[1]", Box::new(lacks_unit)),
        (Kind::Points, _) => ("1", Box::new(says("must be an array of points".to_owned()))),
        (Kind::Choice(choices) | Kind::AnyCase(choices), _) => {
            ("\"zzzz\"", Box::new(names(choices.to_vec())))
        }
        (Kind::Choices(choices), _) => ("[\"zzzz\"]", Box::new(names(choices.to_vec()))),
        (Kind::Table(_) | Kind::Law(_), _) => ("1", Box::new(says("must be a table".to_owned()))),
        (Kind::Tables(_), _) => ("1", Box::new(says("must be an array of tables".to_owned()))),
        (Kind::FluidOrTable(_) | Kind::SolidOrTable(_), _) => {
            ("1", Box::new(says("must be a name or a table".to_owned())))
        }
        (Kind::Machine(_), _) => ("1", Box::new(says("must be a table".to_owned()))),
        (Kind::List, _) => ("1", Box::new(says("must be an array".to_owned()))),
        (Kind::Scalar, _) => ("true", Box::new(says("must be".to_owned()))),
        (Kind::Texts, _) => ("1", Box::new(says("must be a table".to_owned()))),
    }
}

/// Keys that no shipped case has: a file, and the added or replaced lines.
const OTHERS: &str = r#"
cases/ball-on-disc-starved.toml
    transient={ duration = "1 ms", oil_layer = { course = "ramp", end = "1 ms", to = "100 nm" } }
crates/ertel-cli/tests/good/quick.toml
    motion={ plane_speed = "1 m/s", ball_speed = "1 m/s" }
    bodies={ plane = "steel", ball = "steel" }
    surface_roughness={ body_1_ra = "1 um", body_2_ra = "1 um" }
    surface_roughness={ body_1_rq = "1 um", body_2_rq = "1 um" }
    surface_roughness={ body_1_rz = "1 um", body_2_rz = "1 um" }
    stress={ depth = "1 mm", planes = 40, cut_depth = "10 um", fatigue_limit = "300 MPa", dang_van_weight = 0.3, fatemi_socie_weight = 1.0, body_1_hardness = { surface = 700, core = 350, case_depth = "1 mm" }, body_2_hardness = { surface = 700, core = 350, case_depth = "1 mm" } }
    stress={ body_1_hardness = { depth = ["0 mm", "1 mm"], hardness = [700, 350] }, body_2_hardness = { depth = ["0 mm", "1 mm"], hardness = [700, 350] } }
    stress={ body_1_hardness = { uniform = 700 }, body_2_hardness = { uniform = 700 } }
    stress={ body_1_residual_stress = { depth = ["0 mm", "1 mm"], along = ["-1 MPa", "0 MPa"], across = ["-1 MPa", "0 MPa"] }, body_2_residual_stress = { depth = ["0 mm", "1 mm"], along = ["-1 MPa", "0 MPa"], across = ["-1 MPa", "0 MPa"] } }
    stress={ body_1_residual_stress = { file = "none.csv" }, body_2_residual_stress = { file = "none.csv" } }
    transient={ duration = "1 ms" }
    transient={ duration = "1 ms", load = { course = "ramp", end = "1 ms", to = "50 N" }, entrainment_speed = { course = "sine", amplitude = "0.1 m/s", period = "1 ms" } }
    transient={ duration = "1 ms", body_1_speed = { course = "step", at = "1 ms", to = "1 m/s" }, body_2_speed = { course = "table", file = "none.csv" } }
    transient={ duration = "1 ms", slide_to_roll_ratio_across = { course = "ramp", end = "1 ms", to = 0.1 }, body_1_spin = { course = "ramp", end = "1 ms", to = "10 rad/s" }, body_2_spin = { course = "step", at = "1 ms", to = "-10 rad/s" } }
    transient={ duration = "1 ms", slide_to_roll_ratio = { course = "table", times = ["0 s", "1 ms"], values = [0.0, 0.1] } }
    transient={ duration = "1 ms", mass = "1 kg", damping = "1 N.s/m", stiffness = "1 N/m", start = "apart", gap = "5 um", approach_velocity = "1 mm/s" }
    transient={ duration = "1 ms", cavities = "conserved", temperature = { course = "ramp", end = "1 ms", to = "50 degC" }, radius = { course = "ramp", end = "1 ms", to = "20 mm" } }
    transient={ duration = "1 ms", approach = { course = "ramp", end = "1 ms", to = "10 nm" } }
    curve={ quantity = "contact.radius", from = "10 mm", to = "20 mm", points = 3 }
    lubricant.viscosity={ law = "walther", a = 8.0, b = 3.0, alpha = "20 1/GPa", reference_temperature = "40 degC" }
    lubricant.viscosity={ law = "roelands", mu_0 = "40 mPa.s", z = 0.6 }
    lubricant.viscosity={ law = "cheng", mu_0 = "1 Pa.s", alpha = "9 1/GPa", beta = "1 K", gamma = "1 K/GPa", reference_temperature = "40 degC" }
    lubricant.viscosity={ law = "yasutomi", mu_g = "1e12 Pa.s", t_g0 = "200 K", a_1 = "100 K", a_2 = "1 1/GPa", b_1 = "5 1/GPa", b_2 = -0.4, c_1 = 16.0, c_2 = "20 K" }
    lubricant.viscosity={ law = "mcewen-paluch", mu_0 = "40 mPa.s", a_0 = "10 1/GPa", q = 4.0, c_f = 10.0, p_inf = "10 GPa" }
    lubricant.viscosity={ law = "paluch", mu_inf = "1e-6 Pa.s", c_f = 10.0, p_inf = "10 GPa" }
    lubricant.viscosity={ law = "doolittle", mu_0 = "40 mPa.s", b = 4.0, r_0 = 0.66, reference_temperature = "40 degC", epsilon = "-1e-3 1/K", equation_of_state = { k_0r = "9 GPa", k_0r_prime = 11.0, reference_temperature = "40 degC", beta_k = "6e-3 1/K", beta_k_prime = "0 1/K", a_v = "8e-4 1/K" } }
    lubricant.viscosity={ law = "table", file = "oil.csv" }
    lubricant={ temperature = "70 degC", base_oil = "mineral", kinematic_viscosity = "20 mm^2/s", viscosity_temperature = "70 degC" }
    lubricant={ temperature = "70 degC", base_oil = "mineral", dynamic_viscosity = "20 mPa.s", viscosity_temperature = "70 degC" }
    lubricant.density={ law = "table", file = "oil.csv" }
    lubricant.shear_thinning={ law = "carreau", g_c = "10 kPa", n = 0.8, beta_c = 2.0, mu_2 = "0 Pa.s" }
    lubricant.thermal_conductivity={ law = "linear", k_0 = "0.1 W/(m.K)", reference_temperature = "40 degC", a_t = "1e-3 1/K" }
    lubricant.thermal_conductivity={ law = "larsson-andersson", k_0 = "0.1 W/(m.K)", d_1 = "1 1/GPa", d_2 = "1 1/GPa" }
    lubricant.thermal_conductivity={ law = "scaling", b = "0.1 W/(m.K)", c = "0.1 W/(m.K)", s = 4.0, a = 0.1, q = 1.0, reference_temperature = "40 degC" }
    lubricant.thermal_conductivity={ law = "table", file = "oil.csv" }
    lubricant.thermal_conductivity={ law = "table", units = { thermal_conductivity = "W/(m.K)" }, isotherms = [] }
    lubricant.heat_capacity={ law = "linear", c_0 = "1700 J/(kg.K)", reference_temperature = "40 degC", a_t = "1e-3 1/K" }
    lubricant.heat_capacity={ law = "larsson-andersson", rho_c_0 = "2 MJ/(m^3.K)", reference_temperature = "40 degC", beta_0 = "1e-3 1/K", b_1 = "1 1/GPa", b_2 = "1 1/GPa^2", k_1 = "1 1/GPa", k_2 = "1 1/GPa" }
    lubricant.heat_capacity={ law = "scaling", rho_c_0 = "1 MJ/(m^3.K)", m = "1 MJ/(m^3.K)", reference_temperature = "40 degC" }
    lubricant.heat_capacity={ law = "table", file = "oil.csv" }
    lubricant.heat_capacity={ law = "table", units = { heat_capacity = "J/(kg.K)" }, isotherms = [] }
cases/ball-on-disc.toml
    output.interferogram={ wavelength = "600 nm", refractive_index = 1.47, phase_change = "180 deg" }
    output.interferogram={ wavelengths = ["1 um", "1 um", "1 um"], refractive_index = 1.47, phase_change = "180 deg" }
    output.interferogram={ light = "cie-rgb", refractive_index = 1.47, phase_change = "180 deg", spacer_thickness = "1 um", spacer_refractive_index = 1.4 }
cases/machine/ball-on-disc.toml
    machine={ kind = "ball-on-disc", ball_radius = "10 mm", load = "20 N", entrainment_speed = "1 m/s", slide_to_roll_ratio = 0.0 }
    machine={ kind = "ball-on-disc", ball_radius = "10 mm", load = "20 N", body_1_speed = "1 m/s", body_2_speed = "1 m/s" }
cases/stribeck.toml
    surface_roughness={ body_1_rms_height = "0.2 um", body_2_rms_height = "0.15 um", asperity_law = "persson", rms_slope = 0.1, decay_length_to_rms_height = 0.45, pressure_factor = 0.02 }
    surface_roughness={ body_1_rms_height = "0.2 um", body_2_rms_height = "0.15 um", asperity_law = "table", asperity_distances = ["0 nm", "250 nm", "500 nm"], asperity_pressures = ["200 MPa", "20 MPa", "1 MPa"] }
cases/wear.toml
    motion={ body_1_speed = "20 mm/s", body_2_speed = "10 mm/s" }
cases/machine/cam-turn.toml
    machine={ kind = "cam", follower = "flat", base_radius = "16 mm", eccentricity = "4 mm", cam_speed = "100 rad/s", width = "14 mm", load = "200 N", angle = "40 deg" }
cases/machine/roller-bearing.toml
    machine.profile={ kind = "crown", crown_radius = "1 m" }
    machine.profile={ kind = "crown", end_drop = "1 um" }
    machine.profile={ kind = "iso-16281", diameter = "10 mm" }
    machine.profile={ kind = "table", position = ["0 mm", "3 mm", "6 mm"], drop = ["0 um", "1 um", "9 um"] }
    machine.profile={ kind = "table", file = "trace.csv" }
cases/machine/bearing-6206.toml
    machine.thermal_resistance="0.5 K/W"
    machine.heat_balance=true
    machine={ kind = "roller-bearing", designation = "NU 206", radial_load = "2 kN", inner_ring_speed = "3000 rpm" }
    machine={ kind = "roller-bearing", designation = "NU 206", radial_load = "2 kN", inner_ring_speed = "3000 rpm", thermal_resistance = "0.5 K/W" }
    machine={ kind = "roller-bearing", designation = "30206", radial_load = "2 kN", axial_load = "1 kN", inner_ring_speed = "3000 rpm" }
"#;

/// Keys in tables of a list, which cannot be set by their path.
fn is_in_list(path: &str) -> bool {
    [
        "isotherms.",
        "correlation.",
        "blend.",
        "surface.",
        "layers.",
    ]
    .iter()
    .any(|list| path.contains(list))
}

/// The laws of the property at a key path.
fn laws_of(path: &str) -> Option<&'static Laws> {
    (keys::rows_of(path).into_iter()).find_map(|row| match row.kind {
        Kind::Law(laws) | Kind::LawOr(laws, _) => Some(laws),
        _ => None,
    })
}

#[test]
fn readers_see_keys_as_the_table_does() {
    let mut all: Vec<(PathBuf, Option<&str>)> = Vec::new();
    for line in OTHERS.lines().filter(|line| !line.is_empty()) {
        match (line.strip_prefix(' '), all.last()) {
            (Some(set), Some((file, _))) => all.push((file.clone(), Some(set.trim_start()))),
            _ => all.push((root().join(line), None)),
        }
    }
    all.extend(cases().into_iter().map(|(file, _)| (file, None)));
    // The keys that no reader has confirmed yet, and what was said.
    let mut left = BTreeMap::new();
    let id = |path: &str, row: &Row| {
        let key = path.rsplit('.').next().unwrap_or_default().to_owned();
        (std::ptr::from_ref(row).addr(), key)
    };
    for (path, row) in keys::all().iter().filter(|(path, _)| !is_in_list(path)) {
        left.insert(id(path, row), (path.clone(), String::new()));
    }
    assert!(left.len() > 300, "{}", left.len());
    for (file, set) in all {
        let text = std::fs::read_to_string(&file).unwrap();
        let here = |key: &str, value: &str| {
            let own = set.map(str::to_owned).into_iter();
            let sets: Vec<String> = own.chain([format!("{key}={value}")]).collect();
            let read = Case::from_text_with("case.toml", &text, file.parent().unwrap(), &sets);
            read.err().filter(|error| error.key().starts_with(key))
        };
        for (path, row) in keys::all() {
            let id = id(path, row);
            let (value, is_expected) = wrong(path, row);
            let said = left.get(&id).and_then(|_| here(path, value));
            let Some(error) = said else { continue };
            if is_expected(&error) {
                left.remove(&id);
            } else if !error.message().starts_with("unknown key") {
                let said = format!("{} {:?}", error.message(), error.help());
                left.insert(id, (path.clone(), said));
            }
        }
    }
    let left: Vec<String> = (left.into_values())
        .map(|(path, said)| format!("{path}: {said}"))
        .collect();
    assert!(
        left.is_empty(),
        "no reader has these keys so:\n{}",
        left.join("\n")
    );
}

/// Kinds of machines, and the keys of each law.
#[test]
fn readers_know_machines_and_laws_as_the_table_does() {
    let text = std::fs::read_to_string(root().join("cases/machine/ball-on-disc.toml")).unwrap();
    let read =
        |set: &str| Case::from_text_with("case.toml", &text, Path::new(""), &[set.to_owned()]);
    let kinds: Vec<&str> = keys::MACHINES.iter().map(|(kind, _)| *kind).collect();
    let error = read("machine.kind=\"zzzz\"").unwrap_err();
    assert_eq!(
        error.help(),
        [format!("`kind` is one of: {}", kinds.join(", "))]
    );
    let mut n_laws = 0;
    for line in OTHERS.lines().filter(|line| line.contains("{ law = ")) {
        let (path, table) = line.trim().split_once("={").unwrap();
        let error = read(&format!("{path}={{ zzzz = 1, {table}")).unwrap_err();
        let keys = error
            .help()
            .iter()
            .find_map(|h| h.strip_prefix("the keys here are "));
        let Some(keys) = keys else { continue };
        let laws = laws_of(path).unwrap();
        let law = laws
            .laws
            .iter()
            .find(|law| table.contains(&format!("\"{}\"", law.name)));
        let known = laws.keys_of(law.unwrap());
        for key in keys.split(", ").filter(|key| *key != "law") {
            assert!(known.contains(&key), "{path}, {}: {key}", law.unwrap().name);
        }
        n_laws += 1;
    }
    assert!(n_laws > 10, "{n_laws}");
}
