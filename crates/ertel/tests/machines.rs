//! Whole machines from a case file to their figures.

use std::sync::LazyLock;

use approx::assert_relative_eq;
use ertel::case::Mechanics;
use ertel::engine::{NoObserver, Observer};
use ertel::machine::{estimate, figures};
use ertel::output;
use ertel::run;
use ertel::solution::Figure;
use ertel::study::{CurveObserver, MachineSolution, solve_curve, solve_in_balance, solve_machine};
use ertel_machines::bearing::load::{Given, Loads, Params};

use crate::common::text::{GEARS, read, with};
use crate::common::{assert_figures, contains, near, value};

/// All balls of a bearing under thrust are identical.
const THRUST: &str = concat!(
    "title = \"6206 under thrust\"\n",
    "[machine]\nkind = \"ball-bearing\"\ndesignation = \"6206\"\ninner_ring_speed = \"3000 rpm\"\naxial_load = \"500 N\"\ncontamination_factor = 0.5\nthermal_resistance = \"0.5 K/W\"\nambient_temperature = \"20 degC\"\n",
    "[bodies]\nbody_1 = \"steel\"\nbody_2 = \"steel\"\n",
    "[lubricant]\ntemperature = \"70 degC\"\niso_vg = 68\nbase_oil = \"mineral\"\nshear_thinning = { law = \"estimate\" }\n",
    "[mesh]\ntarget_error = 0.05\n",
    "[solver]\nnewtonian = true\n"
);

/// Its contacts, solved.
static UNDER_THRUST: LazyLock<MachineSolution> = LazyLock::new(|| {
    let case = read(THRUST);
    solve_machine(case.contacts.as_ref().unwrap(), &mut NoObserver)
});

/// The friction of spin follows from the law: contacts have none, nor have they with another temperature; one contact alone has it.
#[test]
fn contacts_of_a_bearing_are_solved_without_spin() {
    let case = read(THRUST);
    assert!(case.friction_by_law && case.motion.spin[0] != case.motion.spin[1]);
    for point in &case.contacts.as_ref().unwrap().study.points {
        let warmer = [("lubricant.temperature".to_owned(), 350.0)];
        let warmer = point.case.with_values(warmer.into()).unwrap();
        assert_eq!(warmer.lubricant.temperature, 350.0);
        for contact in [&point.case, &warmer] {
            assert_eq!(contact.motion.spin, [0.0; 2]);
        }
    }
}

/// Two contacts represent eighteen; their sums are nine times theirs, and each is what it is when solved alone.
#[test]
fn a_bearing_under_thrust() {
    let case = read(THRUST);
    let solved = &*UNDER_THRUST;
    assert_eq!(solved.n_contacts(), 2);
    assert_eq!(solved.n_failed(), 0);
    assert!(!solved.is_partial());
    let found = figures(&case, solved);
    let value = |name: &str| found.find(name).unwrap().estimate.value;
    let power = |contact: usize| {
        let solution = solved.solution(contact).unwrap();
        solution.figure(Figure::FrictionPower).unwrap().value
    };
    // Films are solved without spin, whose friction follows the law: all of their power is rolling.
    let films = 9.0 * (power(0) + power(1));
    assert_relative_eq!(value("friction_power_rolling"), films, max_relative = 1e-12);
    let rolling = found.find("friction_power_rolling").unwrap().estimate;
    let share = rolling.error.unwrap() / rolling.value;
    assert!(share < 0.12, "{share}");
    // 0.1 of the pressure at 2/3 of the longer half-axis is more than any oil transmits.
    let contact = &case.contact;
    let [ring, ball] = case.motion.spin;
    let reach = solved.solution(0).unwrap().hertz.half_width_y.unwrap();
    let most = 9.0 * 0.1 * contact.load * (ring - ball).abs() * reach * 2.0 / 3.0;
    assert!(value("friction_power_spin") < most, "{most}");
    let slip = value("friction_power_differential_slip");
    assert!(slip > 0.0);
    let all = films + value("friction_power_spin") + slip;
    assert_relative_eq!(value("friction_power"), all, max_relative = 1e-12);
    // 3000 rpm = 314.159 rad/s; 20 °C and half a Kelvin per Watt.
    let torque = value("friction_power") / 314.159_265;
    assert_relative_eq!(value("friction_torque"), torque, max_relative = 1e-8);
    let temperature = 293.15 + 0.5 * value("friction_power");
    near(value("bearing_temperature"), temperature, 1e-12);
    // The contact of the last ball is the one of the first; alone, solved with its spin, it has the same film.
    let central = |contact: usize| solved.solution(contact).unwrap().summary.film_central.value;
    assert_eq!(central(0), central(16));
    let alone = read(format!(
        "{}\n",
        THRUST.replace("axial_load", "element = 5\nring = \"outer\"\naxial_load")
    ));
    let alone = run::solve(&alone, &mut NoObserver).unwrap();
    assert_relative_eq!(
        alone.summary.film_central.value,
        central(11),
        max_relative = 1e-5
    );

    let json = output::machine_json(&case.echo(), solved, &found).unwrap();
    assert_eq!(json["format"], "ertel-machine");
    assert_eq!(json["n_solved"], 2);
    assert_eq!(json["contacts"][17]["solved_as"], 2);
    assert_eq!(json["figures"]["friction_torque"]["unit"], "N m");
    // Nine balls under 500 N along the bearing: each Q sin α is a ninth of it.
    let entry = |name: &str| &json["contact_figures"]["figures"][name]["value"];
    let number = |value: &serde_json::Value| value.as_f64().unwrap();
    for i in 0..18 {
        let of = |name: &str| number(&entry(name)[i]);
        let axial = of("element_load") * of("contact_angle").sin();
        assert_relative_eq!(axial, 500.0 / 9.0, max_relative = 1e-2);
    }
    // The slope of the axial force: a shift that is larger by 10 nm.
    let shaft = &json["shaft"];
    assert_eq!(shaft["coordinates"][2], "z");
    assert_relative_eq!(number(&shaft["load"][2]), 500.0, max_relative = 1e-6);
    let Mechanics::Bearing(bearing) = &solved.machine.mechanics else {
        panic!("a bearing")
    };
    let step = 1e-8;
    let pushed = |by: f64| {
        let loads = Loads {
            axial: Given::Shift(bearing.distribution.shift[2] + by),
            ..Loads::forces(0.0, 0.0)
        };
        let found = (bearing.bearing).solve(&loads, bearing.speeds, &Params::default());
        found.unwrap().force[2]
    };
    let slope = (pushed(step) - pushed(-step)) / (2.0 * step);
    assert_relative_eq!(
        number(&shaft["stiffness"][2][2]),
        slope,
        max_relative = 1e-4
    );
    let table = output::machine_table(solved, &found.at_contacts);
    assert_eq!(table.lines().count(), 19);
    let widths: Vec<usize> = table
        .lines()
        .map(|line| line.matches(',').count())
        .collect();
    assert!(widths[1..].iter().all(|w| *w >= widths[0]), "{widths:?}");
    let report = output::machine_report(&case.echo(), solved, &found, None);
    for expected in [
        "friction torque of all contacts",
        "ball 0, inner ring and 8 more",
        "modified rating life",
    ] {
        assert!(report.contains(expected), "{expected} is not in\n{report}");
    }
    assert!(!report.contains("(!)"), "{report}");
    // The heat balance does not give 70 °C.
    assert!(report.contains("solve again at"), "{report}");
}

/// Figures of an estimate are those of the solved machine to the last bit, except for the films; films of formulas are within a quarter of the solved ones.
#[test]
fn an_estimate_agrees_with_the_solved_machine() {
    let case = read(THRUST);
    let solved = figures(&case, &UNDER_THRUST);
    let found = estimate(&case).unwrap();
    let films = ["film_central", "film_minimum"];
    for row in &found.figures.all {
        let (name, value) = (row.figure.name, row.estimate.value);
        let other = solved.find(name).unwrap_or_else(|| panic!("no {name}"));
        match films.contains(&name) {
            true => near(value, other.estimate.value, 0.25),
            false => assert_eq!((row.estimate, row.source), (other.estimate, other.source)),
        }
    }
    for name in [
        "dynamic_load_rating",
        "kappa",
        "life_factor",
        "modified_rating_life",
        "friction_torque_skf",
    ] {
        assert!(found.figures.find(name).is_some(), "{name}");
    }
    // Each figure of the solved machine is either estimated, or a part of the friction.
    for row in &solved.all {
        let name = row.figure.name;
        let is_absent = found.absent.iter().any(|(figure, _)| figure.name == name);
        let is_part = name.starts_with("friction_power_");
        assert!(
            found.figures.find(name).is_some() || is_absent || is_part,
            "{name}"
        );
    }
}

/// A 6206 under 2 kN at 3000/min in VG 68 at 70 °C. By hand: C of ISO 281 as in the tests of its wide grooves, 19 452.5 N, L_10 = (C/P)³; κ = 19.857/12.114 mm²/s with
/// ν_1 = 4500/√(n d_m); C_u 592.3 N; a_ISO of balls for κ from 1 to 4.
#[test]
fn a_bearing_by_closed_forms() {
    let case = read(
        THRUST
            .replace("steel", "bearing-steel")
            .replace("axial_load = \"500 N\"", "radial_load = \"2 kN\""),
    );
    let found = estimate(&case).unwrap().figures;
    let kappa = 19.857_f64 / 12.1136;
    let reference = value(&found, "reference_equivalent_load");
    let bracket = (2.5671 - 1.9987 / kappa.powf(0.071_739)).powf(0.83);
    let a_iso = 0.1 * (1.0 - bracket * (0.5 * 592.3 / reference).cbrt()).powf(-9.3);
    assert_figures(
        &found,
        &[
            ("dynamic_load_rating", 19_452.5, 1e-4),
            ("basic_rating_life", (19_452.5_f64 / 2e3).powi(3), 3e-4),
            ("kappa", kappa, 2e-3),
            ("fatigue_load_limit", 592.3, 2e-4),
            ("life_factor", a_iso, 5e-3),
            (
                "modified_rating_life",
                a_iso * value(&found, "reference_rating_life"),
                5e-3,
            ),
        ],
    );
}

/// Lives by hand: P = 500 · Y with F_a/(Z D²) = 500/(9 · 90.7256) = 0.6123 MPa between 0.345 (Y 1.99) and 0.689 (Y 1.71): Y = 1.99 − 0.28 · 0.7772 = 1.77238,
/// P = 886.2 N, C = 19452.5 N: L_10 = (C/P)³ = 10576 million.
#[test]
fn lives_of_a_bearing() {
    let case = read(THRUST.replace("target_error = 0.05", "target_error = 0.1"));
    let mut solved = solve_machine(case.contacts.as_ref().unwrap(), &mut NoObserver);
    let found = figures(&case, &solved);
    let value = |name: &str| found.find(name).unwrap().estimate.value;
    assert_figures(
        &found,
        &[
            ("equivalent_load", 886.2, 1e-3),
            ("basic_rating_life", 10_576.0, 3e-3),
        ],
    );
    // Revolutions to seconds: 2π/ω = 0.02 s each.
    let seconds = 1e6 * value("basic_rating_life") * 0.02;
    near(value("basic_rating_life_time"), seconds, 1e-9);
    // Without a contact there are no sums over the contacts.
    solved.contacts[1] = None;
    let partial = figures(&case, &solved);
    assert!(partial.find("friction_torque").is_none());
    assert!(partial.find("basic_rating_life").is_some());
}

/// The temperature of the lubricant is that of the surroundings and the heat times the thermal resistance, which is not where the case starts.
#[test]
fn a_bearing_in_balance_of_heat() {
    let text = THRUST
        .replace("target_error = 0.05", "target_error = 0.1")
        .replace("[bodies]", "heat_balance = true\n[bodies]");
    let solved = solve_in_balance(&read(&text), &mut NoObserver)
        .unwrap()
        .unwrap();
    let balance = solved.balance.unwrap();
    assert!(balance.is_found() && balance.rounds > 1, "{balance:?}");
    let own = solved.case.lubricant.temperature;
    assert!((own - 343.15).abs() > 1.0, "{own}");
    assert_eq!(own, balance.temperature);
    let found = figures(&solved.case, &solved.solution);
    let power = found.find("friction_power").unwrap().estimate.value;
    assert!((own - 293.15 - 0.5 * power).abs() < 0.1, "{own} {power}");
    assert!(
        found
            .warnings
            .iter()
            .all(|w| !w.text.contains("solve again at"))
    );
    let rows = solved.case.machine.unwrap().rows;
    assert!(rows.iter().any(|(name, _)| name == "heat balance"));
}

/// 30206 under 5 kN and 2 kN by hand: F_a/F_r = 0.4 above e = 0.375, P = 0.4 · 5 + 1.6 · 2 = 5.2 kN; C = 43 kN (NSK): (43/5.2)^(10/3) = 1143.6 million; P_0 =
/// max(0.5 · 5 + 0.88 · 2, 5) = 5 kN, C_0 = 47.5 kN.
#[test]
fn tapered_rollers_by_their_designation() {
    let text = THRUST
        .replace("kind = \"ball-bearing\"\n", "")
        .replace("\"6206\"", "\"30206\"")
        .replace(
            "axial_load = \"500 N\"",
            "radial_load = \"5 kN\"\naxial_load = \"2 kN\"",
        )
        .replace("target_error = 0.05", "target_error = 0.1");
    let case = read(&text);
    let solved = solve_in_balance(&case, &mut NoObserver)
        .unwrap()
        .unwrap()
        .solution;
    assert_eq!(solved.n_failed(), 0);
    let found = figures(&case, &solved);
    let value = |name: &str| found.find(name).unwrap().estimate.value;
    assert_figures(
        &found,
        &[
            ("equivalent_load", 5200.0, 1e-4),
            ("basic_rating_life", 1143.6, 2e-3),
            ("static_safety_factor", 9.5, 1e-6),
        ],
    );
    assert!(value("film_minimum") > 1e-8 && value("friction_torque") > 0.0);
    let reference = value("reference_rating_life") / value("basic_rating_life");
    assert!((0.3..5.0).contains(&reference), "{reference}");
    for name in [
        "rib_load_maximum",
        "friction_torque_skf",
        "friction_torque_palmgren",
        "modified_rating_life",
    ] {
        assert!(value(name) > 0.0, "{name}");
    }
}

/// After one of two contacts all files say so; sums and extremes over all contacts are omitted, figures from mechanics remain.
#[test]
fn an_interrupted_machine_is_marked_in_every_file() {
    let case = read(THRUST);
    let mut solved = UNDER_THRUST.clone();
    let found = figures(&case, &solved);
    let last = solved.contacts.iter().rposition(Option::is_some).unwrap();
    solved.contacts[last] = None;
    assert_eq!(
        [solved.n_contacts(), solved.n_solved(), solved.n_failed()],
        [2, 1, 0]
    );
    let part = figures(&case, &solved);
    for name in [
        "film_central",
        "film_minimum",
        "friction_torque",
        "bearing_temperature",
    ] {
        assert!(
            found.find(name).is_some() && part.find(name).is_none(),
            "{name}"
        );
    }
    assert_eq!(
        part.find("hertz_pressure_maximum"),
        found.find("hertz_pressure_maximum")
    );
    let folder = tempfile::tempdir().unwrap();
    let target = folder.path().join("out");
    output::write_machine(&case.echo(), &solved, &part, &target, &case.output).unwrap();
    let file = |name: &str| std::fs::read_to_string(target.join(name)).unwrap();
    for name in ["report.txt", "report.html", "machine.json", "around.svg"] {
        contains(&file(name), "nterrupted: 1 of 2 different contacts solved");
    }
    let json: serde_json::Value = serde_json::from_str(&file("machine.json")).unwrap();
    assert_eq!(json["n_solved"], 1);
    assert_eq!(json["complete"], false);
}

/// Stops at once.
struct Stop;

impl Observer for Stop {
    fn cancelled(&self) -> bool {
        true
    }
}

impl CurveObserver for Stop {}

/// A machine that is stopped keeps its finished contacts, and no contact counts as failed.
#[test]
fn a_machine_that_is_stopped() {
    let case = read(THRUST);
    let solved = solve_machine(case.contacts.as_ref().unwrap(), &mut Stop);
    assert!(solved.is_partial());
    assert_eq!(solved.n_failed(), 0);
    let found = figures(&case, &solved);
    assert!(found.find("friction_power").is_none());
}

/// The path of FZG gears on few points, with roughness and without a law of the shear.
static ROUGH_GEARS: LazyLock<String> = LazyLock::new(|| {
    with(
        GEARS,
        &[
            [
                "[bodies]",
                "pinion_ra = \"0.4 um\"\nwheel_ra = \"0.4 um\"\n[bodies]",
            ],
            ["shear_thinning = { law = \"estimate\" }\n", ""],
        ],
    )
});

/// Each point of a curve is the machine that its case is alone; where it starts from the point before, within the error bars.
#[test]
fn a_curve_of_whole_machines() {
    let curve =
        "[curve]\nquantity = \"machine.pinion_torque\"\nvalues = [\"100 N.m\", \"110 N.m\"]\n";
    let case = read(format!("{}{curve}", *ROUGH_GEARS));
    let curve = case.curve.as_ref().unwrap();
    assert!(case.contacts.is_none(), "its points have the contacts");
    let solved = solve_curve(curve, &mut NoObserver);
    assert_eq!((solved.points.len(), solved.n_failed()), (2, 0));
    for (point, torque) in solved.points.iter().zip(["100 N.m", "110 N.m"]) {
        let alone = read(ROUGH_GEARS.replace("100 N.m", torque));
        let machine = solve_machine(alone.contacts.as_ref().unwrap(), &mut NoObserver);
        let expected = figures(&alone, &machine);
        let found = &point.machine.as_ref().unwrap().figures;
        assert_eq!(found.all.len(), expected.all.len());
        for (found, expected) in found.all.iter().zip(&expected.all) {
            assert_eq!(found.figure, expected.figure);
            let (a, b) = (found.estimate, expected.estimate);
            let bars = [a, b].map(|e| e.error.unwrap_or(1e-9 * e.value.abs()));
            assert!(
                (a.value - b.value).abs() <= bars[0] + bars[1],
                "{torque}: {} is {a:?}, alone {b:?}",
                found.figure.name
            );
        }
        let governing = machine.solution(machine.machine.governing).unwrap();
        let own = point.outcome.solution().unwrap();
        near(own.hertz.pressure, governing.hertz.pressure, 1e-12);
    }
    let table = output::curve_table(&solved);
    let (head, rows) = table.split_once('\n').unwrap();
    for title in [
        "pinion_torque_J",
        "mesh_loss",
        "mesh_loss_error",
        "friction_power_W",
        "contacts",
    ] {
        assert!(head.split(',').any(|t| t == title), "{title}: {head}");
    }
    assert!(
        rows.lines()
            .all(|row| row.split(',').count() == head.split(',').count())
    );
    let report = output::curve_report(&case.echo(), &solved, None);
    assert!(report.contains("over the power at the pinion"), "{report}");
    let json = output::curve_json(&case.echo(), &solved).unwrap();
    let last = &solved.points[1].machine.as_ref().unwrap().figures;
    let power = last.find("friction_power").unwrap().estimate.value;
    assert_eq!(
        json["points"][1]["figures"]["friction_power"]["value"],
        power
    );
    let files = output::curve_files(&case.echo(), &solved, &case.output).unwrap();
    assert!(files.iter().any(|f| f.name == "mesh-loss-curve.svg"));
}

/// A curve of a chosen contact has that contact alone.
#[test]
fn a_curve_of_one_contact_of_a_machine() {
    let text = ROUGH_GEARS
        .replace("\"path\"", "\"pitch point\"")
        .replace("points = 3\n", "");
    let curve =
        "[curve]\nquantity = \"machine.pinion_speed\"\nvalues = [\"500 rpm\", \"1000 rpm\"]\n";
    let case = read(format!("{text}{curve}"));
    let points = &case.curve.as_ref().unwrap().points;
    assert!(
        points
            .iter()
            .all(|p| p.case.contacts.is_none() && p.case.whole.is_none())
    );
}

/// A contact that fails leaves its point without sums, and with its reason.
#[test]
fn a_point_with_a_failed_contact() {
    let curve =
        "[curve]\nquantity = \"machine.pinion_torque\"\nvalues = [\"50 N.m\", \"200 N.m\"]\n";
    let text = ROUGH_GEARS.replace("newtonian = true", "newtonian = true\nmax_iterations = 1");
    let case = read(format!("{text}{curve}"));
    let solved = solve_curve(case.curve.as_ref().unwrap(), &mut NoObserver);
    assert_eq!(solved.n_failed(), 2);
    let reason = solved.points[0].outcome.reason().unwrap();
    assert!(reason.contains("contacts failed"), "{reason}");
    let table = output::curve_table(&solved);
    contains(table.lines().next().unwrap(), "loss_factor_ohlendorf");
    assert!(!table.contains("mesh_loss"), "{table}");
}

/// Every key of a machine with a number may vary along a curve.
#[test]
fn any_number_of_a_machine_varies() {
    for (base, key, old, values) in [
        (THRUST, "axial_load", "", "[\"400 N\", \"500 N\"]"),
        (THRUST, "contamination_factor", "", "[0.3, 0.5]"),
        (
            THRUST,
            "thermal_resistance",
            "",
            "[\"0.4 K/W\", \"0.6 K/W\"]",
        ),
        (
            THRUST,
            "ambient_temperature",
            "",
            "[\"20 degC\", \"30 degC\"]",
        ),
        (
            THRUST,
            "radial_clearance",
            "radial_clearance = \"10 um\"\n",
            "[\"5 um\", \"15 um\"]",
        ),
        (
            ROUGH_GEARS.as_str(),
            "face_width",
            "face_width = \"14 mm\"\n",
            "[\"10 mm\", \"20 mm\"]",
        ),
        (
            ROUGH_GEARS.as_str(),
            "pinion_ra",
            "",
            "[\"0.2 um\", \"0.8 um\"]",
        ),
        (
            ROUGH_GEARS.as_str(),
            "tip_relief",
            "tip_relief = \"10 um\"\ntip_relief_length = \"2 mm\"\n",
            "[\"5 um\", \"15 um\"]",
        ),
    ] {
        let text = base.replace("[bodies]", &format!("{old}[bodies]"));
        let curve = format!("[curve]\nquantity = \"machine.{key}\"\nvalues = {values}\n");
        let case = read(format!("{text}{curve}"));
        let points = &case.curve.as_ref().unwrap().points;
        assert!(points.iter().all(|p| p.case.contacts.is_some()), "{key}");
    }
}

/// A 6206 at 20/min, κ 0.036, on rough rings: all contacts are solved with their mass balances, the asperities bear more than at 100/min, and the torque is higher.
#[test]
fn a_bearing_in_boundary_lubrication() {
    let at = |speed: &str| {
        let rough = "[surface_roughness]\nbody_1_rms_height = \"0.15 um\"\nbody_2_rms_height = \"0.10 um\"\nasperity_group = 0.05\nrms_height_to_asperity_radius = 5e-3\nboundary_friction_coefficient = 0.11\n";
        let text = THRUST
            .replace("3000 rpm", speed)
            .replace("axial_load = \"500 N\"", "radial_load = \"2 kN\"");
        let case = read(text + rough);
        let solved = solve_machine(case.contacts.as_ref().unwrap(), &mut NoObserver);
        assert_eq!((solved.n_contacts(), solved.n_failed()), (4, 0));
        let shares = (0..4).map(|contact| {
            let found = solved.solution(contact).unwrap();
            assert!(found.checks.mass.abs() < 0.05);
            found
                .measured
                .find(Figure::AsperityLoadShare)
                .unwrap()
                .value
        });
        let shares: Vec<f64> = shares.collect();
        (shares, figures(&case, &solved))
    };
    let [(fast, of_fast), (slow, of_slow)] = ["100 rpm", "20 rpm"].map(at);
    for (fast, slow) in fast.iter().zip(&slow) {
        assert!(0.05 < *fast && fast < slow && *slow < 0.5, "{fast} {slow}");
    }
    let torque = |of| value(of, "friction_torque");
    assert!(torque(&of_slow) > torque(&of_fast));
}
