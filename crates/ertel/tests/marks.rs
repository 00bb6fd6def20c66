//! Marks of contacts apply to all figures derived from them; friction of machines follows a law by default; bars include the distance of the contacts.

use std::sync::LazyLock;

use ertel::case::Case;
use ertel::engine::NoObserver;
use ertel::machine::MachineFigures;
use ertel::output;
use ertel::study::{MachineSolution, solve_curve};

use crate::common::text::read;
use crate::common::{contains, solved_machine, value};

const STEEL: &str = "
[bodies]
body_1 = 'steel'
body_2 = 'steel'
";

/// FZG C at load stage 3 with an ISO VG 32 that is known by its name.
fn gears(solver: &str) -> String {
    format!(
        "
[machine]
kind = 'spur-gear'
template = 'FZG-C'
load_stage = 3
pinion_speed = '1440 rpm'
position = 'path'
pinion_ra = '0.5 um'
wheel_ra = '0.5 um'
scuffing_temperature = '300 degC'
points = 6
{STEEL}
[lubricant]
temperature = '90 degC'
iso_vg = 32
base_oil = 'mineral'
[mesh]
target_error = 0.05
{solver}"
    )
}

/// Their path without a law of the shear, solved.
static NEWTONIAN_GEARS: LazyLock<(Case, MachineSolution, MachineFigures)> =
    LazyLock::new(|| solved_machine(gears("[solver]\nnewtonian = true")));

/// Effect of contact friction on a pair of gears.
const OF_FRICTION: [&str; 8] = [
    "friction_coefficient_mean",
    "friction_power_sliding",
    "friction_power",
    "mesh_loss",
    "mesh_efficiency",
    "flash_temperature",
    "contact_temperature",
    "scuffing_safety",
];

/// Without a law some contacts have a traction above 0.15: all figures derived from friction have their mark, in the report, in JSON and in tables; films have none.
#[test]
fn friction_that_no_lubricant_transmits_marks_totals_of_gears() {
    let (case, solved, found) = &*NEWTONIAN_GEARS;
    let json = output::machine_json(&case.echo(), solved, found).unwrap();
    for name in OF_FRICTION {
        let marks = &json["figures"][name]["marks"];
        assert_eq!(marks[0], "friction-beyond-lubricants", "{name}: {marks}");
        assert!(found.find(name).unwrap().estimate.is_doubtful(), "{name}");
    }
    for name in [
        "film_minimum",
        "specific_film_minimum",
        "friction_coefficient_schlenk",
    ] {
        assert_eq!(
            json["figures"][name]["marks"],
            serde_json::json!([]),
            "{name}"
        );
    }
    let report = output::machine_report(&case.echo(), solved, found, None);
    let line = |words: &str| {
        let mut lines = report.lines();
        lines.find(|line| line.contains(words)).unwrap().to_owned()
    };
    contains(&line("efficiency of the mesh"), "(!) (f)");
    contains(&line("safety against scuffing S_B"), "(!)");
    assert!(report.contains("(!) derived from friction that no lubricant transmits"));
}

/// Of the law that machines take by default the friction by the estimated law is 0.0199, 20.7 W; the films are those without it. They do not separate
/// flanks of Ra 0.5 µm, which a warning and a label say.
#[test]
fn friction_of_gears_follows_a_law_by_default() {
    let (case, solved, found) = solved_machine(gears(""));
    assert!(case.friction_by_law && case.shear_thinning().is_none());
    let friction = value(&found, "friction_coefficient_mean");
    assert!((0.018..0.0225).contains(&friction), "{friction}");
    let power = value(&found, "friction_power");
    assert!((18.5..23.5).contains(&power), "{power}");
    let (_, _, newtonian) = &*NEWTONIAN_GEARS;
    assert_eq!(
        value(&found, "film_minimum"),
        value(newtonian, "film_minimum")
    );
    for name in OF_FRICTION {
        let estimate = found.find(name).unwrap().estimate;
        let marks: Vec<&str> = estimate.marks.iter().map(|mark| mark.name()).collect();
        assert_eq!(marks, ["film-alone"], "{name}");
        assert!(!estimate.is_doubtful(), "{name}");
    }
    let warned = |words: &str| found.warnings.iter().any(|w| w.contains(words));
    assert!(warned("those of the film alone"), "{:?}", found.warnings);
    let report = output::machine_report(&case.echo(), &solved, &found, None);
    contains(&report, "since no `shear_thinning` is given");
    // A law that the user names acts in the films.
    let named = gears("").replace(
        "base_oil = 'mineral'",
        "base_oil = 'mineral'\nshear_thinning = { law = 'estimate' }",
    );
    let named = read(&named);
    assert!(!named.friction_by_law && named.shear_thinning().is_some());
}

/// Nine balls under 3 kN of thrust, in an oil without a law and in one with the estimate.
fn bearing(lubricant: &str) -> String {
    format!(
        "
[machine]
designation = '6206'
inner_ring_speed = '1000 rpm'
axial_load = '3 kN'
thermal_resistance = '0.5 K/W'
ambient_temperature = '20 degC'
{STEEL}
[lubricant]
temperature = '70 degC'
density = {{ law = 'constant', rho_0 = '850 kg/m^3' }}
viscosity = {{ law = 'roelands', mu_0 = '17 mPa.s', alpha = '18 1/GPa' }}
{lubricant}
[mesh]
target_error = 0.1
"
    )
}

/// Spin that takes more than dry metal would is not resolved, and nothing made of it. By the law spin and differential slip together lose
/// less than under the limiting stress everywhere, 0.056 of the pressure: 11.69 W (9.36 W of spin alone, 7.14 W of slip alone; computed outside).
#[test]
fn spin_is_bounded_or_not_resolved() {
    let (case, solved, found) = solved_machine(bearing(""));
    for name in [
        "friction_power_spin",
        "friction_power",
        "friction_torque",
        "bearing_temperature",
    ] {
        let estimate = found.find(name).unwrap().estimate;
        assert!(!estimate.is_resolved() && estimate.is_doubtful(), "{name}");
    }
    let rolling = found.find("friction_power_rolling").unwrap().estimate;
    assert!(!rolling.is_doubtful(), "{rolling:?}");
    let report = output::machine_report(&case.echo(), &solved, &found, None);
    assert!(!report.contains("solve again at"), "{report}");
    assert!(report.contains("not resolved (!)"), "{report}");
    // The contacts name what is not to be used in their table.
    let table = output::machine_table(&solved, &found.at_contacts);
    contains(&table, "friction_power shear_stress_maximum");

    let (_, solved, found) = solved_machine(bearing("base_oil = 'mineral'"));
    let spin = value(&found, "friction_power_spin");
    let slip = value(&found, "friction_power_differential_slip");
    assert!(
        spin > 0.0 && slip < 7.14 && spin + slip < 11.69,
        "{spin} {slip}"
    );
    assert!(
        !found
            .find("friction_torque")
            .unwrap()
            .estimate
            .is_doubtful()
    );
    // One machine has one power: that of its films, of spin and of differential slip.
    let power = |contact: usize| {
        let solution = solved.solution(contact).unwrap();
        solution.traction.friction_power.value
    };
    let contacts = 9.0 * (power(0) + power(1));
    let whole = value(&found, "friction_power");
    assert!((contacts + spin + slip - whole).abs() < 1e-9 * whole);

    // A law whose stress grows to a third of the pressure gives no spin: the power lacks it.
    let growing =
        "shear_thinning = { law = 'ree-eyring', tau_0 = '60 MPa' }\n[solver]\nnewtonian = true";
    let (_, _, found) = solved_machine(bearing(growing));
    assert!(found.find("friction_power_spin").is_none());
    assert!(
        found
            .warnings
            .iter()
            .any(|w| w.contains("and spin are omitted"))
    );
    assert!(
        found
            .find("friction_torque")
            .unwrap()
            .estimate
            .is_doubtful()
    );
}

/// A curve over the load stage: its table names the figures that are not to be used, and the warnings.
#[test]
fn tables_of_curves_name_marked_figures_and_warnings() {
    let text =
        gears("[solver]\nnewtonian = true\n[curve]\nquantity = 'machine.pinion_speed'\nvalues = ['1440 rpm', '1500 rpm']")
            .replace("points = 6", "points = 2");
    let case = read(&text);
    let curve = solve_curve(case.curve.as_ref().unwrap(), &mut NoObserver);
    let table = output::curve_table(&curve);
    let fields: Vec<Vec<&str>> = table
        .lines()
        .map(|line| line.split(',').collect())
        .collect();
    let field = |title: &str| {
        let place = fields[0].iter().position(|own| *own == title).unwrap();
        fields[1][place]
    };
    for name in OF_FRICTION {
        assert!(field("uncertain_figures").contains(name), "{name}");
    }
    let warnings = field("warnings");
    assert!(
        warnings.contains("friction") && warnings.contains("roughness"),
        "{warnings}"
    );
}

/// A cam at few angles: the bar of the torque covers the value from many angles, and a smallest film next to a reversal says so.
#[test]
fn bars_of_a_turn_hold_the_distance_of_its_angles() {
    let cam = |points: usize| {
        let (_, _, found) = solved_machine(format!(
            "
[machine]
kind = 'cam'
follower = 'flat'
base_radius = '18 mm'
lift = '6 mm'
rise = {{ angle = '80 deg', law = '3-4-5' }}
cam_speed = '1000 rpm'
width = '14 mm'
spring_rate = '25 N/mm'
preload = '200 N'
moving_mass = '0.15 kg'
angle = 'turn'
points = {points}
{STEEL}
[lubricant]
temperature = '100 degC'
iso_vg = 100
base_oil = 'mineral'
[mesh]
preset = 'coarse'
"
        ));
        ["friction_torque", "film_minimum", "hertz_pressure_maximum"]
            .map(|name| found.find(name).unwrap().estimate)
    };
    let [torque, film, pressure] = cam(24);
    let [fine_torque, _, fine_pressure] = cam(90);
    let off = (torque.value - fine_torque.value).abs();
    assert!(
        off < torque.error.unwrap() + fine_torque.error.unwrap(),
        "{torque:?} {fine_torque:?}"
    );
    // Films vanish between the angles where the entrainment reverses.
    let names: Vec<&str> = film.marks.iter().map(|mark| mark.name()).collect();
    assert_eq!(names, ["between-points"]);
    // Forces and radii are known at any angle.
    assert_eq!(pressure.value, fine_pressure.value);
}
