//! Cams over a turn, against a separate program and figures worked out by hand.

use crate::near::near;
use approx::assert_relative_eq;
use ertel_input::InputError;

use super::bad::refused;
use super::{REST, read, row};
use crate::case::{Case, MachineAxis, Mechanics, WholeMachine};

/// Two lobes of 4 mm on a base circle of 18 mm, at 2000 1/min.
const CAM: &str = include_str!("data/cam.toml");

fn whole(case: &Case) -> &WholeMachine {
    case.whole.as_ref().unwrap()
}

/// Speeds by a separate program at 40°: R = 21.04188907 mm, the cam at 4.40700294 m/s and the follower at 0.2909503143 m/s.
/// Loads by hand at 90°: s = 4 mm, s'' = −8 mm, F = 250 + 30 · 4 − 0.1 · 209.4395² · 0.008 = 334.908 N, over 12 mm 27,909.0 N/m.
#[test]
fn contacts_of_a_turn() {
    let case = read(CAM).unwrap();
    assert_eq!(whole(&case).axis, MachineAxis::CamAngle);
    assert_eq!(whole(&case).contacts.len(), 36);
    let contacts = case.contacts.as_ref().unwrap();
    let alone = |degrees: &str| {
        let case = read(&CAM.replace("\"turn\"", &format!("\"{degrees} deg\""))).unwrap();
        assert!(case.whole.is_none());
        case
    };
    let at = alone("40");
    assert_relative_eq!(at.contact.radius, 21.041_889_07e-3, max_relative = 1e-9);
    assert_relative_eq!(at.motion.body_2_speed(), 4.407_002_94, max_relative = 1e-8);
    near(at.motion.body_1_speed(), 0.290_950_314_3, 1e-8);
    let [tappet, cam] = at.contact.body_curvatures.unwrap();
    assert_eq!(tappet[0], 0.0);
    assert_relative_eq!(1.0 / cam[0], 21.041_889_07e-3, max_relative = 1e-9);
    assert_relative_eq!(alone("90").contact.load, 27_909.0, max_relative = 1e-5);
    // The contact of the turn at 40° is the same, and those half a turn on are like it.
    let place = whole(&case)
        .contacts
        .iter()
        .position(|c| c.name == "40 deg");
    let place = place.unwrap();
    let contact = &whole(&case).contacts[place];
    assert_relative_eq!(contact.load, at.contact.load, max_relative = 1e-12);
    assert_eq!(contact.like, Some(place));
    assert_eq!(whole(&case).contacts[place + 18].like, Some(place));
    let point = contacts.study.points.iter().find(|p| p.label == "40 deg");
    let point = point.unwrap();
    near(point.case.contact.radius, at.contact.radius, 1e-12);
    // The governing contact has the largest pressure.
    let governing = &whole(&case).contacts[whole(&case).governing];
    let pressures = whole(&case).contacts.iter().map(|c| c.hertz_pressure);
    assert_eq!(pressures.fold(0.0, f64::max), governing.hertz_pressure);
    assert_eq!(row(&case, "most loaded contact"), governing.name);
    near(case.hertz().pressure, governing.hertz_pressure, 1e-9);
}

/// With a lift of 8 mm, u_m = (ω/2)(r_b + h/2 + 3.5 h cos 2θ) vanishes at cos 2θ = −22/28, θ = 70.893°. Beyond, about the nose, x is turned.
#[test]
fn entrainment_reverses() {
    let case = read(&CAM.replace("lift = \"4 mm\"", "lift = \"8 mm\"")).unwrap();
    let Mechanics::Cam(cam) = &whole(&case).mechanics else {
        panic!("a cam")
    };
    let degrees: Vec<f64> = cam.reversals.iter().map(|a| a.to_degrees()).collect();
    let right = (-22.0_f64 / 28.0).acos().to_degrees() / 2.0;
    assert_eq!(degrees.len(), 4);
    assert_relative_eq!(degrees[0], right, max_relative = 1e-9);
    assert_relative_eq!(degrees[1], 180.0 - right, max_relative = 1e-9);
    assert!(row(&case, "entrainment reverses").starts_with("at 70.89, 109.1, 250.9,"));
    let nose = case.contacts.as_ref().unwrap();
    let nose = nose.study.points.iter().find(|p| p.label == "90 deg");
    let motion = nose.unwrap().case.motion;
    // r_b + s + s'' = 10 mm and s'' = −16 mm at 209.4395 rad/s: cam 2.094395 m/s, tappet −3.351032 m/s, turned around.
    assert_relative_eq!(motion.body_2_speed(), -2.094_395, max_relative = 1e-6);
    assert_relative_eq!(motion.body_1_speed(), 3.351_032, max_relative = 1e-6);
    // Where two of 360 points are too slow, they are not solved.
    let fine = CAM
        .replace("lift = \"4 mm\"", "lift = \"8 mm\"")
        .replace("points = 36", "points = 360");
    let case = read(&fine).unwrap();
    let slow = whole(&case).contacts.iter().find(|c| c.name == "71 deg");
    assert_eq!(slow.unwrap().like, None);
    assert!(row(&case, "too slow").contains("70 to 72 deg"));
}

/// Without enough spring the follower leaves the cam about the nose, where s'' = −8 mm: 10 N + 0.1 kg · 43 865 · (−0.008) m is below zero.
#[test]
fn the_follower_leaves_the_cam() {
    let text = CAM
        .replace("250 N", "10 N")
        .replace("spring_rate = \"30 N/mm\"\n", "");
    let case = read(&text).unwrap();
    let nose = whole(&case).contacts.iter().find(|c| c.name == "90 deg");
    let nose = nose.unwrap();
    assert_eq!((nose.load, nose.like), (0.0, None));
    assert!(
        case.warnings
            .iter()
            .any(|w| w.text.contains("leaves the cam"))
    );
    refused(
        &text,
        "\"turn\"",
        "\"90 deg\"",
        &["the follower leaves the cam"],
    );
}

/// On the base circle all contacts are alike.
#[test]
fn a_rise_and_a_return() {
    let text = CAM.replace(
        "lobes = 2\n",
        "rise = { angle = \"60 deg\", law = \"3-4-5\" }\n",
    );
    let case = read(&text).unwrap();
    let contacts = &whole(&case).contacts;
    // From 120° to 350°, and 0°: 25 points of 36 under 250 N at ρ = 18 mm.
    let base = contacts[0].like;
    assert_eq!(contacts.iter().filter(|c| c.like == base).count(), 25);
    assert_relative_eq!(contacts[20].load, 250.0 / 12e-3, max_relative = 1e-9);
    // In the middle of the rise s = 2 mm and s'' = 0: F = 310 N.
    assert_relative_eq!(contacts[3].load, 310.0 / 12e-3, max_relative = 1e-9);
    // Both flanks are alike: 30° and 90°, but the surfaces move as the lift says.
    assert_eq!(contacts[9].like, Some(3));
    refused(
        &text,
        "60 deg",
        "200 deg",
        &["take 400 deg of the turn", "rise"],
    );
}

/// A roller of 10 mm rolls: the entrainment speed is that of the cam's surface, and R = 10 · 18/28 mm on the base circle.
#[test]
fn a_roller() {
    let text = CAM
        .replace("\"flat\"", "\"roller\"\nfollower_radius = \"10 mm\"")
        .replace("\"turn\"", "\"0 deg\"")
        .replace(
            "lobes = 2\n",
            "rise = { angle = \"60 deg\", law = \"3-4-5\" }\n",
        );
    let case = read(&text).unwrap();
    assert_relative_eq!(case.contact.radius, 180.0e-3 / 28.0, max_relative = 1e-9);
    near(case.motion.entrainment_speed, 209.4395 * 18e-3, 1e-6);
    assert_eq!(case.motion.slide_to_roll_ratio, 0.0);
}

/// A table of the two lobes is the lobes; one row is no table.
#[test]
fn tables_of_lifts() {
    let folder = std::env::temp_dir().join(format!("ertel-cam-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let mut table = "angle [deg],lift [mm]\n".to_owned();
    for degrees in (0..=360).step_by(3) {
        let lift = 2.0 * (1.0 - (2.0 * f64::from(degrees).to_radians()).cos());
        table += &format!("{degrees},{lift}\n");
    }
    // The last row repeats the first.
    std::fs::write(folder.join("cam.csv"), table).unwrap();
    std::fs::write(folder.join("short.csv"), "angle [deg],lift [mm]\n0,0\n").unwrap();
    std::fs::write(folder.join("plain.csv"), "angle,lift\n0,0\n").unwrap();
    let read_with = |file: &str| -> Result<Case, InputError> {
        let text = CAM
            .replace(
                "lift = \"4 mm\"\nlobes = 2",
                &format!("lift_table = \"{file}\""),
            )
            .replace("\"turn\"", "\"40 deg\"");
        let text = format!("[machine]\n{text}{REST}");
        Case::from_text("machine.toml", &text, &folder)
    };
    let case = read_with("cam.csv").unwrap();
    assert_relative_eq!(case.contact.radius, 21.041_889_07e-3, max_relative = 1e-5);
    for (file, words) in [
        ("short.csv", "1 rows"),
        ("plain.csv", "unit"),
        ("absent.csv", "absent.csv"),
    ] {
        let error = read_with(file).unwrap_err();
        assert!(error.to_string().contains(words), "{error}");
        assert!(error.to_string().contains("lift_table"), "{error}");
    }
    std::fs::remove_dir_all(&folder).unwrap();
}

/// A cam of the closed form s = h (1 − (θ/80°)²)³, h = 6.604 mm, at each degree as on paper: by hand the entrainment r_b + s + 2 s'' vanishes at ± 22.11°, and at the nose
/// s'' = −6 h/θ_0², R = r_b + s + s'' = 4.279 mm.
#[test]
fn tables_rounded_on_paper() {
    const INCH: f64 = 25.4;
    let folder = std::env::temp_dir().join(format!("ertel-cam-rounded-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let lift = |degrees: i32| 6.604 * (1.0 - (f64::from(degrees) / 80.0).powi(2)).powi(3);
    let mut bars = Vec::new();
    for (titles, unit, digits) in [
        ("angle [deg];lift [in]", INCH, 3),
        ("Cam angle [deg];Valve lift [in]", INCH, 4),
        ("Nockenwinkel (°);Hub (mm)", 1.0, 3),
        ("theta / deg;s / mm", 1.0, 5),
        ("rotation, deg;ordinate, um", 1e-3, 0),
    ] {
        let mut table = format!("{titles}\n");
        for degrees in -80..=80 {
            table += &format!("{degrees};{:.digits$}\n", lift(degrees) / unit);
        }
        std::fs::write(folder.join("cam.csv"), table).unwrap();
        let text = CAM
            .replace("lift = \"4 mm\"\nlobes = 2", "lift_table = \"cam.csv\"")
            .replace("points = 12", "points = 36");
        let text = format!("[machine]\n{text}{REST}");
        let case = Case::from_text("machine.toml", &text, &folder).unwrap();
        let Mechanics::Cam(cam) = &case.whole.as_ref().unwrap().mechanics else {
            panic!("a cam")
        };
        let reversals: Vec<f64> = cam.reversals.iter().map(|a| a.to_degrees()).collect();
        assert_eq!(reversals.len(), 2, "{titles}: {reversals:?}");
        for (found, right) in cam.reversals.iter().zip([22.11_f64, 337.89]) {
            let bar = cam.cam.reversal_bar(&cam.operation, *found);
            let off = (found - right.to_radians()).abs();
            assert!(off < bar + 1e-3, "{titles}: {reversals:?} {bar}");
        }
        let bar = cam.cam.bars(&cam.operation, 0.0).reduced_radius;
        let off = (cam.points[0].reduced_radius - 4.279e-3).abs();
        assert!(off < bar + 1e-6, "{titles}: {off} {bar}");
        bars.push(bar);
        // The base circle has no rows.
        assert!(cam.points[18].lift.abs() < 1e-5, "{titles}");
        let rows = &case.machine.as_ref().unwrap().rows;
        let (_, law) = rows.iter().find(|(name, _)| name == "lift s(θ)").unwrap();
        assert!(law.contains("by its last digit"), "{law}");
    }
    assert!(bars[0] > bars[1] && bars[2] > bars[3], "{bars:?}");
    let crank = "Crank angle [deg];lift [mm]\n0;0\n1;1\n";
    std::fs::write(folder.join("cam.csv"), crank).unwrap();
    let text = CAM.replace("lift = \"4 mm\"\nlobes = 2", "lift_table = \"cam.csv\"");
    let text = format!("[machine]\n{text}{REST}");
    let error = Case::from_text("machine.toml", &text, &folder).unwrap_err();
    assert!(error.to_string().contains("crank"), "{error}");
    std::fs::remove_dir_all(&folder).unwrap();
}

/// By hand: a roller whose path is off the axis by 27 mm, of r_b + r_f = 28 mm, has sin φ = 27/28 on the base circle, 74.6°, and tan φ = (s' + 27 mm)/(7.416 mm + s) on the flank, at
/// most 75.4° where s = 0.41 mm and s' = 3.02 mm.
#[test]
fn steep_pressure_angles_are_reported() {
    let of = |offset: &str| {
        let text = CAM
            .replace(
                "\"flat\"",
                &format!("\"roller\"\nfollower_radius = \"10 mm\"\nfollower_offset = \"{offset}\""),
            )
            .replace(
                "lobes = 2\n",
                "rise = { angle = \"80 deg\", law = \"3-4-5\" }\n",
            );
        read(&text).unwrap()
    };
    let warned = |case: &Case, words: &str| case.warnings.iter().any(|w| w.contains(words));
    let steep = of("27 mm");
    assert!(
        warned(&steep, "the pressure angle reaches 75.4 deg"),
        "{:?}",
        steep.warnings
    );
    let rows = &steep.machine.as_ref().unwrap().rows;
    let (_, angle) = rows
        .iter()
        .find(|(name, _)| name == "largest pressure angle")
        .unwrap();
    assert!(angle.starts_with("75.38"), "{angle}");
    assert!(!warned(&of("0 mm"), "the pressure angle reaches"));
}

/// Other ones are among the bad cases of the command.
#[test]
fn bad_cams_are_refused() {
    for (old, new, words) in [
        ("\"flat\"", "\"flatt\"", &["`follower` is one of"][..]),
        ("\"flat\"", "\"roller\"", &["missing key `follower_radius`"]),
        ("lift = \"4 mm\"\n", "", &["missing key `lift`"]),
        (
            "lobes = 2",
            "lobes = 2\neccentricity = \"2 mm\"",
            &["both define the lift"],
        ),
        ("lobes", "top_dwell = \"3 deg\"\nlobes", &["no such key"]),
        ("preload", "load = \"300 N\"\npreload", &["give it alone"]),
        ("\"2000 rpm\"", "\"0 rpm\"", &["must not be zero"]),
        ("points = 36", "points = 1", &["points", "3 to 3600"]),
        ("\"turn\"", "\"all\"", &["or \"turn\""]),
        ("width", "arm_length = \"30 mm\"\nwidth", &["no such key"]),
    ] {
        refused(CAM, old, new, words);
    }
}
