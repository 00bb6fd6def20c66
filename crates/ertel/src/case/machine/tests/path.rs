//! All contacts along the path of contact of gears, against a separate program and figures worked out by hand.

use std::path::Path;

use crate::near::near;
use approx::assert_relative_eq;
use ertel_input::InputError;

use super::bad::refused;
use super::{GEAR, read, read_with, row, with};
use crate::case::{Case, MachineAxis, MachineContact, Mechanics, WholeMachine};
use crate::warning::WarningKind;

/// FZG gears, at 94.1 N m.
const FZG: &str = include_str!("data/fzg_c.toml");

const STEEL: &str = "{ youngs_modulus = \"206 GPa\", poissons_ratio = 0.3 }";

fn fzg(machine: &str) -> Result<Case, InputError> {
    read_with(machine, STEEL, "")
}

fn whole(case: &Case) -> &WholeMachine {
    case.whole.as_ref().unwrap()
}

fn named<'c>(case: &'c Case, name: &str) -> (usize, &'c MachineContact) {
    let mut contacts = whole(case).contacts.iter().enumerate();
    contacts.find(|(_, c)| c.name.starts_with(name)).unwrap()
}

#[test]
fn against_a_separate_program() {
    let case = fzg(FZG).unwrap();
    let contacts = case.contacts.as_ref().unwrap();
    assert_eq!(whole(&case).axis, MachineAxis::LineOfAction);
    assert!(whole(&case).is_line);
    // Five points, and B, C and D.
    assert_eq!(whole(&case).contacts.len(), 8);
    assert_eq!(contacts.study.points.len(), 8);
    let table = include_str!("data/fzg_c_path.csv");
    let rows = table.lines().filter(|line| !line.starts_with('#')).skip(1);
    let mut n = 0;
    for line in rows {
        let cells: Vec<&str> = line.split(',').collect();
        let number = |i: usize| cells[i].parse::<f64>().unwrap();
        let (i, contact) = named(&case, cells[0]);
        assert_relative_eq!(contact.load, 1e3 * number(7), max_relative = 1e-8);
        assert_relative_eq!(contact.hertz_pressure, 1e6 * number(8), max_relative = 1e-8);
        assert_relative_eq!(
            contact.place,
            1e-3 * (number(1) - 13.97008235),
            epsilon = 1e-11
        );
        // The case of this contact alone is the same.
        let one = &contacts.study.points[i].case;
        assert_relative_eq!(one.contact.load, contact.load, max_relative = 1e-12);
        assert_relative_eq!(one.contact.radius, 1e-3 * number(3), max_relative = 1e-8);
        let [wheel, pinion] = one.contact.body_curvatures.unwrap();
        assert_relative_eq!(1e3 / pinion[0], number(1), max_relative = 1e-8);
        assert_relative_eq!(1e3 / wheel[0], number(2), max_relative = 1e-8);
        assert_relative_eq!(one.motion.body_2_speed(), number(4), max_relative = 1e-8);
        assert_relative_eq!(one.motion.body_1_speed(), number(5), max_relative = 1e-8);
        assert_relative_eq!(one.motion.slide_to_roll_ratio, number(6), epsilon = 1e-8);
        assert!(one.whole.is_none());
        n += 1;
    }
    assert_eq!(n, 3);
    // The case itself is the contact under the largest pressure.
    let (governing, contact) = named(&case, "B, inner single contact");
    assert_eq!(whole(&case).governing, governing);
    let pressures = whole(&case).contacts.iter().map(|c| c.hertz_pressure);
    assert_eq!(contact.hertz_pressure, pressures.fold(0.0, f64::max));
    assert_relative_eq!(case.contact.load, contact.load, max_relative = 1e-12);
    assert_eq!(row(&case, "most loaded contact"), "B, inner single contact");
    assert!(whole(&case).title.contains("16 and 24 teeth"));
    let Mechanics::Gears(gears) = &whole(&case).mechanics else {
        panic!("gears")
    };
    assert_relative_eq!(gears.pair.contact_ratio, 1.437536954, max_relative = 1e-8);
}

/// At B and D the load jumps; a contact read alone is that of the machine.
#[test]
fn each_contact_alone_is_that_of_the_machine() {
    for sharing in ["load_sharing = \"thirds\"\n", ""] {
        let case = fzg(&FZG.replace("load_sharing = \"thirds\"\n", sharing)).unwrap();
        let contacts = case.contacts.as_ref().unwrap();
        for (contact, point) in whole(&case).contacts.iter().zip(&contacts.study.points) {
            assert_eq!(contact.name, point.label);
            let load = point.case.contact.load;
            assert_relative_eq!(load, contact.load, max_relative = 1e-12);
            let pressure = point.case.hertz().pressure;
            assert_relative_eq!(pressure, contact.hertz_pressure, max_relative = 1e-12);
        }
        // 94.1 N m over 36 mm cos 20° and 14 mm: 198.689 N/mm where one pair carries.
        for name in ["B", "D"] {
            let (_, single) = named(&case, name);
            assert_relative_eq!(single.load, 198_688.7, max_relative = 1e-6);
        }
    }
}

/// Published report of the gears C14 (GEARpie): AC = 9.50 mm, AE = 19.10 mm, ε_α = 1.44; 200 N m press the pitch point with
/// √(200/94.1) times the 924.133 MPa of 94.1 N m, 1347.3 MPa.
#[test]
fn gears_c14() {
    let text = FZG
        .replace("FZG-C", "FZG-C14")
        .replace("94.1 N.m", "200 N.m");
    let case = fzg(&text).unwrap();
    let (_, first) = named(&case, "A");
    let (_, last) = named(&case, "E");
    assert!((1e3 * first.place + 9.50).abs() < 5e-3);
    assert!((1e3 * (last.place - first.place) - 19.10).abs() < 5e-3);
    let (_, pitch) = named(&case, "C");
    assert!((1e-6 * pitch.hertz_pressure - 1347.3).abs() < 0.1);
    assert!(row(&case, "contact ratio").starts_with("1.4"));
    // The tips of type C and A are an estimate, unless they are given.
    let estimated = |text: &str| {
        let case = fzg(text).unwrap();
        let rows = &case.machine.as_ref().unwrap().rows;
        rows.iter().any(|(name, _)| name == "estimated")
    };
    assert!(!estimated(&text) && estimated(FZG));
    let tips = "pinion_tip_diameter = \"82.46 mm\"\nwheel_tip_diameter = \"118.36 mm\"\npoints";
    assert!(!estimated(&FZG.replace("points", tips)));
}

/// Load stage 5 with the long lever arm is 94.1 N m. Keys replace dimensions of a template, and dimensions that disagree with them follow from them.
#[test]
fn templates_and_load_stages() {
    let torque = |text: &str| {
        let case = fzg(text).unwrap();
        let Mechanics::Gears(gears) = &whole(&case).mechanics else {
            panic!("gears")
        };
        (
            gears.operation.pinion_torque,
            gears.pair.shifts,
            gears.pair.centre_distance,
            gears.pair.face_width,
        )
    };
    let stage = FZG.replace("pinion_torque = \"94.1 N.m\"", "load_stage = 5");
    assert_eq!(torque(&stage).0, 94.1);
    let short = stage.replace("load_stage", "lever_arm = \"short\"\nload_stage");
    assert_eq!(torque(&short).0, 69.98);
    let (_, shifts, distance, width) = torque(&FZG.replace(
        "points",
        "pinion_profile_shift = 0.1\nface_width = \"20 mm\"\npoints",
    ));
    // Both shifts make up 0.3532 at this centre distance.
    assert_relative_eq!(shifts[1], 0.2532, epsilon = 1e-4);
    assert_relative_eq!(distance, 91.5e-3, max_relative = 1e-12);
    assert_eq!(width, 20e-3);
    let both = "pinion_profile_shift = 0.0\nwheel_profile_shift = 0.0\npoints";
    near(torque(&FZG.replace("points", both)).2, 90e-3, 1e-12);
}

/// Pinion and wheel of 20 and 60 teeth inside, m = 4 mm: 13.68081 mm convex in 41.04242 mm concave is R = 20.52121 mm; both move at
/// 157.0796 · 0.01368081 = 2.148976 m/s.
#[test]
fn an_internal_wheel() {
    let text = GEAR.replace("wheel_teeth = 40", "wheel_teeth = 60\ninternal = true");
    let case = read(&text).unwrap();
    assert_relative_eq!(case.contact.radius, 20.521_21e-3, max_relative = 1e-6);
    near(case.motion.entrainment_speed, 2.148_976, 1e-6);
    assert!(case.motion.slide_to_roll_ratio.abs() < 1e-12);
    assert!(row(&case, "R_2").contains("concave"));
    let [wheel, pinion] = case.contact.body_curvatures.unwrap();
    assert!(wheel[0] < 0.0 && pinion[0] > 0.0);
}

/// Body 1 is the wheel: R_1 = 18.68081 mm of the pinion and R_2 = 22.36161 mm of the wheel at s = 5 mm.
#[test]
fn curvatures_are_those_of_their_bodies() {
    let case = with(GEAR, "\"pitch point\"", "\"5 mm\"").unwrap();
    let [wheel, pinion] = case.contact.body_curvatures.unwrap();
    assert_relative_eq!(1.0 / wheel[0], 22.361_61e-3, max_relative = 1e-6);
    assert_relative_eq!(1.0 / pinion[0], 18.680_81e-3, max_relative = 1e-6);
    // The faster body, the pinion, is body 2.
    assert!(case.motion.body_2_speed() > case.motion.body_1_speed());
}

/// d = 80 mm: an addendum of 6 mm is a tip diameter of 92 mm.
#[test]
fn tip_diameters_replace_addenda() {
    let of = |key: &str| with(GEAR, "position =", &format!("{key}\nposition =")).unwrap();
    let addendum = of("addendum_pinion = \"6 mm\"");
    let diameter = of("pinion_tip_diameter = \"92 mm\"");
    assert_eq!(
        row(&addendum, "path of contact"),
        row(&diameter, "path of contact")
    );
    assert_eq!(
        row(&diameter, "path of contact"),
        "from -10.117 mm to 12.836 mm"
    );
}

/// Kinds may be written with underscores.
#[test]
fn underscores() {
    let [hyphens, underscores] =
        [GEAR.to_owned(), GEAR.replace("spur-gear", "spur_gear")].map(|text| read(&text).unwrap());
    assert_eq!(hyphens.contact, underscores.contact);
}

/// A relief of 60 µm is more than the teeth deflect: they do not touch at their tips, and these contacts are not solved.
#[test]
fn relief_takes_the_load_off_the_ends() {
    let text = GEAR
        .replace("load_share = 1\n", "load_sharing = \"stiffness\"\n")
        .replace(
            "\"pitch point\"",
            "\"path\"\ntip_relief = \"60 um\"\ntip_relief_length = \"3 mm\"",
        );
    let case = read(&text).unwrap();
    for name in ["A", "E"] {
        let (_, end) = named(&case, name);
        assert_eq!((end.load, end.like), (0.0, None), "{name}");
    }
    let (i, pitch) = named(&case, "C");
    assert!(pitch.load > 0.0 && pitch.like == Some(i));
    let contacts = case.contacts.as_ref().unwrap();
    assert!(contacts.study.points.len() < whole(&case).contacts.len());
    // Only stiffness includes relief.
    let even = text.replace("\"stiffness\"", "\"uniform\"");
    let warned = read(&even).unwrap();
    let warned = warned
        .warnings
        .iter()
        .filter(|w| w.kind == WarningKind::Gears);
    assert!(
        warned
            .map(|w| w.text.clone())
            .any(|text| text.contains("no effect"))
    );
}

/// Other ones are among the bad cases of the command.
#[test]
fn bad_gears_are_refused() {
    let path = GEAR
        .replace("load_share = 1\n", "")
        .replace("\"pitch point\"", "\"path\"");
    assert!(read(&path).is_ok());
    for (new, words) in [
        (
            "centre_distance = \"110 mm\"",
            &["base circles would touch", "centre_distance"][..],
        ),
        (
            "addendum_pinion = \"4 mm\"\npinion_tip_diameter = \"88 mm\"",
            &["give the same quantity"],
        ),
        (
            "pinion_tip_diameter = \"70 mm\"",
            &["the tip circle of the pinion", "pinion_tip_diameter"],
        ),
        ("load_share = 0.5", &["load of a single contact"]),
        ("load_stage = 5", &["give the same quantity"]),
        ("tip_relief = \"20 um\"", &["tip_relief_length"]),
        ("tooth_stiffness = \"14 GPa\"", &["\"stiffness\""]),
        ("load_sharing = \"beams\"", &["pinion_bore_diameter"]),
        ("template = \"FZG-H501\"", &["helical gears"]),
        ("pinion_ra = \"0.4 um\"", &["wheel_ra"]),
        (
            "bulk_temperature = \"100 degC\"\nscuffing_temperature = \"90 degC\"",
            &["hotter than this"],
        ),
        (
            "pinion_face_width = \"10 mm\"",
            &["`face_width` is that of both gears"],
        ),
    ] {
        refused(&path, "kind", &format!("{new}\nkind"), words);
    }
    // One contact has one load.
    refused(
        GEAR,
        "load_share = 1",
        "load_share = 1\nload_sharing = \"uniform\"",
        &["keep one of them"],
    );
    let helical = "load_sharing = \"thirds\"\nhelix_angle = \"15 deg\"\nkind = \"helical-gear\"";
    let path = path
        .replace("kind = \"spur-gear\"", helical)
        .replace("module", "normal_module")
        .replace("pressure_angle", "normal_pressure_angle");
    refused(&path, "kind", "kind", &["straight teeth", "load_sharing"]);
}

/// Teeth have the temperature that the machine says, in each contact, unless `[thermal]` says another.
#[test]
fn teeth_have_their_temperature() {
    let path = FZG.replace("kind =", "bulk_temperature = \"90 degC\"\nkind =");
    let alone = path
        .replace("points = 5\n", "")
        .replace("\"path\"", "\"pitch point\"");
    for machine in [path, alone] {
        let of = |thermal: &str| {
            let heat =
                "thermal_conductivity = \"0.14 W/(m.K)\"\nheat_capacity = \"2000 J/(kg.K)\"\n";
            let steel = STEEL.replace(" }", ", density = \"7850 kg/m^3\", thermal_conductivity = \"46 W/(m.K)\", heat_capacity = \"470 J/(kg.K)\" }");
            let more = format!("{heat}[thermal]\n{thermal}");
            let thermal = read_with(&machine, &steel, &more).unwrap().thermal.unwrap();
            [thermal.body_1_temperature, thermal.body_2_temperature]
        };
        assert_eq!(of(""), [Some(363.15); 2]);
        assert_eq!(
            of("body_1_temperature = \"80 degC\"\n"),
            [Some(353.15), Some(363.15)]
        );
    }
}

/// Oil on teeth has their temperature before it enters a contact: viscosity and α are those of an oil at the bulk temperature, in the whole path and in one
/// contact of it, with and without heat.
#[test]
fn films_are_those_at_the_temperature_of_the_teeth() {
    let heat =
        "thermal_conductivity = \"0.14 W/(m.K)\"\nheat_capacity = \"2000 J/(kg.K)\"\n[thermal]\n";
    let of = |bulk: &str, oil: &str, position: &str, heat: &str| {
        let mut machine = FZG.replace("kind =", &format!("{bulk}kind ="));
        if position != "path" {
            machine = machine
                .replace("points = 5\n", "")
                .replace("\"path\"", "\"pitch point\"");
        }
        let text = format!(
            "[machine]\n{machine}\n[bodies]\nbody_1 = \"steel\"\nbody_2 = \"steel\"\n[lubricant]\ntemperature = \"{oil}\"\niso_vg = 100\nbase_oil = \"mineral\"\n{heat}"
        );
        Case::from_text("machine.toml", &text, Path::new("")).unwrap()
    };
    let bulk = "bulk_temperature = \"110 degC\"\n";
    for (position, heat) in [
        ("path", ""),
        ("path", heat),
        ("pitch point", ""),
        ("pitch point", heat),
    ] {
        let case = of(bulk, "90 degC", position, heat);
        let hot = of("", "110 degC", position, heat);
        assert_eq!(
            case.lubricant.ambient_viscosity(),
            hot.lubricant.ambient_viscosity()
        );
        assert_eq!(case.lubricant.temperature, 383.15);
        assert_eq!(case.lubricant.oil_temperature(), 363.15);
        let film = |case: &Case| crate::estimate::estimate(case).film.central;
        assert_eq!(film(&case), film(&hot));
    }
    // Without it, films are at the temperature of the oil.
    let plain = of("", "90 degC", "path", "");
    assert_eq!(plain.lubricant.temperature, 363.15);
    assert_eq!(plain.lubricant.supply_temperature, None);
}

/// A law without temperature cannot follow the teeth, and the temperature of the oil then changes nothing: both are reported.
#[test]
fn temperatures_of_oil_and_teeth_without_effect_are_reported() {
    let with_bulk = FZG.replace("kind =", "bulk_temperature = \"110 degC\"\nkind =");
    let warned = |warnings: &[crate::warning::Warning], words: &str| {
        warnings.iter().any(|w| w.contains(words))
    };
    let case = fzg(&with_bulk).unwrap();
    assert!(
        warned(&case.warnings, "does not depend on temperature")
            || warned(&case.warnings, "depends on temperature")
    );
    let text = format!(
        "[machine]\n{with_bulk}\n[bodies]\nbody_1 = \"steel\"\nbody_2 = \"steel\"\n[lubricant]\ntemperature = \"90 degC\"\niso_vg = 100\nbase_oil = \"mineral\"\n"
    );
    let set = ["lubricant.temperature=70 degC".to_owned()];
    let case = Case::from_text_with("machine.toml", &text, Path::new(""), &set).unwrap();
    assert!(warned(&case.warnings, "machine.bulk_temperature"));
}

/// Results that a machine does not have are reported.
#[test]
fn uncertainties_of_a_machine_are_reported_without_effect() {
    let warned = |machine: &str| {
        let case = fzg(machine).unwrap();
        let text = "the uncertainty of machine.pinion_torque has no effect";
        case.warnings.iter().any(|w| w.contains(text))
    };
    assert!(!warned(FZG));
    assert!(warned(&FZG.replace("94.1 N.m", "94.1 N.m ± 5 %")));
}
