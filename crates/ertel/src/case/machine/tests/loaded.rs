//! Bearings under their loads.

use crate::near::near;
use approx::assert_relative_eq;

use super::bad::refused;
use super::read_with;
use crate::case::{Case, Mechanics};

/// 6206 as in the table of loads: E = 206 GPa, no clearance to speak of, hardly any speed.
const LOADED: &str = include_str!("data/6206_by_dimensions.toml");

const NAMED: &str = include_str!("data/6206.toml");

/// 40 degrees, one shoulder.
const ANGULAR: &str = include_str!("data/7210b.toml");

const ROLLERS: &str = include_str!("data/nu206e.toml");

const TAPERED: &str = include_str!("data/30206.toml");

fn read(machine: &str) -> Case {
    read_of(machine, ", density = \"7850 kg/m^3\"")
}

/// With elements of some density, or of none that is known.
fn read_of(machine: &str, density: &str) -> Case {
    let steel = &format!("{{ youngs_modulus = \"206 GPa\", poissons_ratio = 0.3{density} }}");
    read_with(machine, steel, "").unwrap()
}

/// The induced axial force holds the rings of a single-row angular contact bearing together. A preload does so without any axial load, and bearings with two shoulders need none.
#[test]
fn induced_axial_loads() {
    let loaded = |machine: &str| {
        let case = read(machine);
        let contacts = &case.whole.as_ref().unwrap().contacts;
        // Inertia presses all balls on the outer ring, and wedges free ones between offset grooves.
        let inner = contacts.iter().filter(|c| c.name.ends_with("inner ring"));
        let loads: Vec<f64> = inner.map(|c| c.load).collect();
        let largest = loads.iter().fold(0.0, |most: f64, load| most.max(*load));
        let n = loads.iter().filter(|load| **load > 0.1 * largest).count();
        n as f64 / loads.len() as f64
    };
    // By the shift, 38.25 µm cos 40° cos ψ − 18.31 µm sin 40° > 0: |ψ| < 66°, 5 of 15 balls.
    let induced = ANGULAR.replace("3 kN", "1754 N");
    assert_eq!(loaded(&induced), 5.0 / 15.0);
    let rows = read(&induced).machine.unwrap().rows;
    let row = rows
        .iter()
        .find(|(name, _)| name.trim() == "loaded elements");
    let text = "15 of 15, 5 with more than a tenth of the largest load";
    assert_eq!(row.unwrap().1, text);
    let two_shoulders = ANGULAR.replace("7210 B", "6210");
    for machine in [
        ANGULAR.replace("axial_load = \"3 kN\"", "axial_preload = \"5 um\""),
        two_shoulders.replace("\"3 kN\"", "\"-3 kN\""),
        two_shoulders.replace("axial_load = \"3 kN\"", ""),
    ] {
        assert!(loaded(&machine) > 0.2, "{machine}");
    }
}

/// Without a density of the elements there is no centrifugal force: loads are those of a bearing at rest, and the report says so.
#[test]
fn missing_density_of_elements_is_reported() {
    let without = read_of(NAMED, "");
    let said = |case: &Case| {
        (case.warnings.iter())
            .any(|warning| warning.contains("the centrifugal force of the elements is neglected"))
    };
    assert!(said(&without) && !said(&read(NAMED)));
    let slow = read(&NAMED.replace("3000 rpm", "1 rpm"));
    let load = |case: &Case| case.whole.as_ref().unwrap().contacts[1].load;
    assert_relative_eq!(load(&without), load(&slow), max_relative = 1e-6);
}

/// Loads of each ball, largest pressures and semi-axes, computed by an independent program (rigid rings, exact Hertz contacts): 974.50 N, 653.37 N and
/// 70.50 N on five balls, none on the others, 2.126484 and 1.950190 GPa.
#[test]
fn loads_of_each_ball() {
    let case = read(LOADED);
    let whole = case.whole.as_ref().unwrap();
    assert_eq!(whole.contacts.len(), 18);
    let loads: Vec<f64> = whole.contacts.iter().step_by(2).map(|c| c.load).collect();
    for (ball, expected) in [974.498, 653.37, 70.50, 0.0, 0.0, 0.0, 0.0, 70.50, 653.37]
        .iter()
        .enumerate()
    {
        assert_relative_eq!(loads[ball], *expected, max_relative = 1e-4, epsilon = 0.01);
    }
    near(whole.contacts[0].hertz_pressure, 2.126_484e9, 1e-5);
    near(whole.contacts[1].hertz_pressure, 1.950_190e9, 1e-5);
    // Σ Q cos ψ
    let along: f64 = (whole.contacts.iter().step_by(2))
        .map(|contact| contact.load * contact.place.cos())
        .sum();
    assert_relative_eq!(along, 2000.0, max_relative = 1e-6);
}

/// The case is the governing contact; balls on both sides of the load are alike, and those without load are not solved.
#[test]
fn contacts_that_are_solved() {
    let case = read(LOADED);
    let whole = case.whole.as_ref().unwrap();
    assert_eq!(whole.contacts[whole.governing].name, "ball 0, inner ring");
    assert_relative_eq!(case.contact.load, 974.498, max_relative = 1e-4);
    assert_eq!(whole.contacts[16].like, Some(2));
    assert_eq!(whole.contacts[6].like, None);
    assert_eq!(whole.count(2), 2);
    let contacts = case.contacts.as_ref().unwrap();
    let names: Vec<&str> = contacts
        .study
        .points
        .iter()
        .map(|p| p.label.as_str())
        .collect();
    let rings = |ball: usize| ["inner", "outer"].map(|ring| format!("ball {ball}, {ring} ring"));
    let expected: Vec<String> = (0..3).flat_map(rings).collect();
    assert_eq!(names, expected);
    // One of them alone, by its keys.
    let alone = read(&format!("{LOADED}element = 2\nring = \"outer\"\n"));
    assert!(alone.whole.is_none() && alone.contacts.is_none());
    let of_study = &contacts.study.points[5].case;
    assert_eq!(alone.contact, of_study.contact);
    assert_eq!(alone.motion, of_study.motion);
}

/// Entrainment as of a single contact: u = ω d_m (1 − γ²)/4 = 314.159 · 0.046 (1 − 0.2070652²)/4 = 3.45793 m/s; no spin where no ball is at an angle.
#[test]
fn motion_of_the_contacts() {
    let case = read(NAMED);
    assert_relative_eq!(case.motion.entrainment_speed, 3.457_93, max_relative = 1e-5);
    assert_eq!(case.motion.spin, [0.0; 2]);
    let thrust = read(&NAMED.replace("radial_load = \"2 kN\"", "axial_load = \"1 kN\""));
    let whole = thrust.whole.as_ref().unwrap();
    // All balls alike: at both rings one contact each.
    assert_eq!(thrust.contacts.as_ref().unwrap().study.points.len(), 2);
    assert!(whole.contacts.iter().all(|c| c.like == Some(c.side)));
    let spins = |point: usize| {
        thrust.contacts.as_ref().unwrap().study.points[point]
            .case
            .motion
            .spin
    };
    // Outer control: spin on the inner raceway alone.
    assert_ne!(spins(0)[0], spins(0)[1]);
    assert_relative_eq!(spins(1)[0], spins(1)[1], max_relative = 1e-9);
}

/// Values of the catalogue may be replaced one by one.
#[test]
fn designations_and_their_values() {
    let balls = |case: &Case| {
        let Mechanics::Bearing(bearing) = &case.whole.as_ref().unwrap().mechanics else {
            panic!("a bearing");
        };
        bearing.bearing.geometry.number()
    };
    assert_eq!(balls(&read(NAMED)), 9);
    assert_eq!(balls(&read(&format!("{NAMED}balls = 8\n"))), 8);
    let rows = read(NAMED).machine.unwrap().rows;
    let row = |name: &str| rows.iter().find(|(n, _)| n == name).unwrap().1.clone();
    assert!(row("ball diameter D").contains("9.525 mm (published"));
    assert!(row("inner groove radius over D").contains("0.52 (estimated"));
    // C3 of a bore of 30 mm: 13 to 28 µm.
    let c3 = read(&NAMED.replace("6206", "6206-2RS/C3"))
        .machine
        .unwrap()
        .rows;
    assert!(c3.iter().any(|(_, value)| value.starts_with("20.5 µm")));
}

/// Rollers are lines under their mean load per length: Q/L, with 4.08 F/Z of the heaviest one within the clearance's effect.
#[test]
fn rollers_are_lines() {
    let case = read(ROLLERS);
    assert!(case.contact.kind.is_line());
    let whole = case.whole.as_ref().unwrap();
    let Mechanics::Bearing(bearing) = &whole.mechanics else {
        panic!("a bearing");
    };
    let heaviest = bearing.distribution.elements[0].contacts[0].load;
    let number = bearing.bearing.geometry.number() as f64;
    assert!(
        (4.08..6.5).contains(&(heaviest * number / 5000.0)),
        "{heaviest}"
    );
    let along: f64 = (bearing.distribution.elements.iter())
        .map(|e| e.contacts[0].load * e.position.cos())
        .sum();
    assert_relative_eq!(along, 5000.0, max_relative = 1e-6);
}

/// A designation says the kind of bearing. Loads by hand: at the cup Σ Q sin α = F_a, each Q over 10.9 mm/0.8·14 mm of length.
#[test]
fn tapered_rollers() {
    let case = read(TAPERED);
    let without_kind = read(&TAPERED.replace("kind = \"roller-bearing\"", ""));
    assert_eq!(case.contact, without_kind.contact);
    let whole = case.whole.as_ref().unwrap();
    let Mechanics::Bearing(bearing) = &whole.mechanics else {
        panic!("a bearing");
    };
    let elements = &bearing.distribution.elements;
    // The cup bears all; the centrifugal force of the rollers acts outwards, across the axis.
    let cup = |part: &dyn Fn(f64) -> f64| -> f64 {
        elements
            .iter()
            .map(|e| e.contacts[1].load * part(e.position))
            .sum()
    };
    let angle = 14.036_1_f64.to_radians();
    assert_relative_eq!(cup(&|_| angle.sin()), 2000.0, max_relative = 1e-6);
    near(cup(&|psi| angle.cos() * psi.cos()), 5000.0, 1e-4);
    assert!(whole.is_line && elements.iter().all(|e| e.rib_load > 0.0));
    let length = 0.8 * 14e-3;
    assert_relative_eq!(
        whole.contacts[0].load * length,
        elements[0].contacts[0].load,
        max_relative = 1e-12
    );
    assert_eq!(case.motion.spin, [0.0; 2]);
}

/// Tilted rollers are solved over their length with the tilt of each contact: half of the tilt of the rings in the plane of the load, nearly nothing across it.
#[test]
fn finite_rollers_are_tilted() {
    let tilted = format!("{ROLLERS}misalignment = \"0.5 mrad\"\n");
    let case = read(&format!("{tilted}roller_contacts = \"finite\"\n"));
    let roller = case.contact.roller.as_ref().unwrap();
    assert_relative_eq!(roller.misalignment.abs(), 0.25e-3, max_relative = 0.05);
    let whole = case.whole.as_ref().unwrap();
    assert!(!whole.is_line);
    assert_relative_eq!(case.contact.load, whole.contacts[whole.governing].load);
    let straight = read(&format!("{ROLLERS}roller_contacts = \"finite\"\n"));
    assert_eq!(straight.contact.roller.as_ref().unwrap().misalignment, 0.0);
}

#[test]
fn bad_bearings_are_refused_with_their_reason() {
    for (machine, old, new, words) in [
        (
            NAMED,
            "6206",
            "6299",
            &["no bearing `6299`", "the nearest ones are 62"][..],
        ),
        (
            NAMED,
            "6206",
            "NU 206 E",
            &["has cylindrical rollers", "roller-bearing"],
        ),
        (
            NAMED,
            "6206",
            "30206",
            &["has tapered rollers", "roller-bearing"],
        ),
        (
            TAPERED,
            "axial_load = \"2 kN\"",
            "",
            &["its rings come apart", "1562 N or more", "`axial_preload`"],
        ),
        (
            TAPERED,
            "axial_load = \"2 kN\"",
            "axial_load = \"1 N\"",
            &["its axial load is 1 N", "1562 N or more"],
        ),
        (
            TAPERED,
            "axial_load = \"2 kN\"",
            "axial_load = \"1.5 kN\"",
            &["its axial load is 1500 N", "F_r/(2Y) with Y = 1.6"],
        ),
        // F_r/(2Y) with Y = 0.57 of ISO 281, table 3: 1754 N.
        (
            ANGULAR,
            "axial_load = \"3 kN\"",
            "",
            &["1754 N in a single-row angular contact", "`axial_preload`"],
        ),
        (
            ANGULAR,
            "\"3 kN\"",
            "\"1.7 kN\"",
            &["axial_load", "1754 N or more", "Y = 0.57"],
        ),
        (
            ANGULAR,
            "\"3 kN\"",
            "\"-3 kN\"",
            &["in one direction only", "-3000 N push its rings apart"],
        ),
        (
            ANGULAR,
            "radial_load = \"2 kN\"\naxial_load = \"3 kN\"",
            "moment = \"20 N m\"",
            &["moment", "come apart without axial load"],
        ),
        (
            TAPERED,
            "radial_load",
            "radial_clearance = \"5 um\"\nradial_load",
            &["adjustment of the bearing"],
        ),
        (
            NAMED,
            "\"2 kN\"",
            "\"2000 kN\"",
            &["radial_load", "static load rating", "11.26 kN"],
        ),
        (
            ROLLERS,
            "radial_load",
            "roller_profile = \"cylinder\"\nroller_contacts = \"finite\"\nradial_load",
            &["without relief", "logarithmic"],
        ),
        (
            NAMED,
            "radial_load",
            "contamination_factor = 0.5\ncleanliness = \"high\"\nradial_load",
            &["give the same quantity"],
        ),
        (
            NAMED,
            "\"2 kN\"",
            "\"0 N\"",
            &["no element carries load", "radial_load"],
        ),
        (NAMED, "\"2 kN\"", "\"2 m\"", &["radial_load"]),
        (
            NAMED,
            "radial_load",
            "ring = \"inner\"\nradial_load",
            &["the number of the ball, is missing"],
        ),
        (
            NAMED,
            "radial_load",
            "element = 9\nring = \"inner\"\nradial_load",
            &["element", "8"],
        ),
        (
            NAMED,
            "radial_load",
            "element = 4\nring = \"inner\"\nradial_load",
            &["carries no load"],
        ),
        (
            NAMED,
            "radial_load",
            "contact_angle = \"0 deg\"\nradial_clearance = \"5 um\"\nradial_load",
            &["give the same quantity"],
        ),
        (
            NAMED,
            "radial_load",
            "balls = 40\nradial_load",
            &["40 elements"],
        ),
        (
            NAMED,
            "radial_load",
            "thermal_resistance = \"1 K/W\"\nradial_load",
            &["ambient_temperature"],
        ),
        (
            NAMED,
            "radial_load",
            "contamination_factor = 2\nradial_load",
            &["contamination_factor"],
        ),
        (
            ROLLERS,
            "radial_load",
            "axial_load = \"1 kN\"\nradial_load",
            &["no axial load"],
        ),
        (LOADED, "balls = 9", "", &["missing key `balls`"]),
    ] {
        refused(machine, old, new, words);
    }
}
