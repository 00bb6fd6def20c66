use std::path::Path;

use approx::assert_relative_eq;
use ertel_input::InputError;

use crate::case::Case;
use crate::contains::contains;

fn read(contact: &str, folder: &Path, surface: &str) -> Result<Case, InputError> {
    let text = format!(
        "lubricant = \"squalane-pip\"\ntemperature = \"40 degC\"\n[contact]\n{contact}\n[bodies]\nbody_1 = \"steel\"\nbody_2 = \"steel\"\n\
         [motion]\nbody_1_speed = \"1 m/s\"\nbody_2_speed = \"0 m/s\"\n[[surface]]\nbody = \"body_2\"\nx = \"0 m\"\n{surface}"
    );
    Case::from_text("case.toml", &text, folder)
}

const BALL: &str = "kind = \"circular\"\nradius = \"16 mm\"\nload = \"20 N\"";
const LINE: &str = "kind = \"line\"\nradius = \"10 mm\"\nload = \"50 kN/m\"";

fn map(folder: &Path, contact: &str, text: &str, more: &str) -> Result<Case, InputError> {
    std::fs::write(folder.join("map.txt"), text).unwrap();
    let surface = format!(
        "kind = \"map\"\nfile = \"map.txt\"\nspacing = \"2 um\"\nheight_unit = \"nm\"\n{more}"
    );
    read(contact, folder, &surface)
}

/// 40 x 30 heights with a tilt, and holes.
fn rows(holes: usize) -> String {
    (0..30)
        .map(|j| {
            let row: Vec<String> = (0..40)
                .map(|i| match j * 40 + i < holes {
                    true => "nan".to_owned(),
                    false => format!("{}", 3 * i + 20 * ((i * i + 7 * j) % 5)),
                })
                .collect();
            row.join(" ") + "\n"
        })
        .collect()
}

/// The echo reports the treatment of a map: points, holes, a hash of the file that changes with it, parameters before and after the filter.
#[test]
fn a_map_is_echoed() {
    let folder = tempfile::tempdir().unwrap();
    let of = |text: &str| {
        let case = map(folder.path(), BALL, text, "low_pass = \"20 um\"").unwrap();
        case.reliefs[0].echo.clone().unwrap()
    };
    let one = of(&rows(3));
    assert_eq!((one.points, one.missing, one.level), ([40, 30], 3, "plane"));
    assert_relative_eq!(one.taper, 0.1 * 58e-6, max_relative = 1e-12);
    assert!(one.filtered.sq < 0.5 * one.levelled.sq && one.filtered.sq > 0.0);
    assert!(one.levelled.sz < 200e-9);
    let other = of(&rows(4));
    assert_eq!(one.hash.as_ref().map(String::len), Some(16));
    assert_ne!(one.hash, other.hash);
    let case = map(folder.path(), BALL, &rows(0), "").unwrap();
    // Without a filter the shortest wave is that of two points.
    assert_relative_eq!(case.reliefs[0].form.finest(), 4e-6, max_relative = 1e-12);
    assert_eq!(case.files(folder.path()), [folder.path().join("map.txt")]);
}

/// A map that covers a part of the contact area gives a warning with that part.
#[test]
fn maps_smaller_than_the_contact_are_warned_about() {
    let folder = tempfile::tempdir().unwrap();
    let share = |case: &Case| -> Option<f64> {
        let is_it = |text: &&str| text.contains("of the contact area");
        let text = case.warnings.iter().map(|w| w.text.as_str()).find(is_it)?;
        let (_, behind) = text.split_once("covers ")?;
        behind.split_once(" %")?.0.parse().ok()
    };
    let case = map(folder.path(), BALL, &rows(0), "taper = \"6 um\"").unwrap();
    // 39 x 29 distances of 2 um, less the rim, in the circle.
    let expected = 66e-6 * 46e-6 / (std::f64::consts::PI * case.hertz().half_width.powi(2));
    assert!(case.hertz().half_width > 60e-6);
    assert_relative_eq!(share(&case).unwrap(), 100.0 * expected, max_relative = 0.05);
    let text = case
        .warnings
        .iter()
        .map(|w| w.text.as_str())
        .find(|text| text.contains("covers"));
    assert!(
        text.unwrap()
            .starts_with("surface 1: the map of 78 µm x 58 µm"),
        "{text:?}"
    );
    // Points as far apart as ten of them make a map that is large enough, unless it lies elsewhere.
    let wide = |more: &str| {
        std::fs::write(folder.path().join("map.txt"), rows(0)).unwrap();
        let surface = format!(
            "kind = \"map\"\nfile = \"map.txt\"\nspacing = \"20 um\"\nheight_unit = \"nm\"\n{more}"
        );
        read(BALL, folder.path(), &surface).unwrap()
    };
    assert_eq!(share(&wide("")), None);
    assert_eq!(share(&wide("y = \"5 mm\"")), Some(0.0));
    // A profile in a line contact.
    let profile: String = (0..31).map(|i| format!("{}\n", 20 * (i % 5))).collect();
    let case = map(folder.path(), LINE, &profile, "taper = \"6 um\"").unwrap();
    let expected = 24e-6 / case.hertz().half_width;
    assert_relative_eq!(share(&case).unwrap(), 100.0 * expected, max_relative = 0.05);
}

/// Invalid maps are reported with their key.
#[test]
fn maps_that_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let holes = rows(100);
    let full = rows(0);
    let flat = "1 1 1 1\n".repeat(30).replace('\n', " 1 1 1 1\n");
    for (contact, text, more, key, says) in [
        (
            BALL,
            holes.as_str(),
            "",
            "file",
            "100 of 1200 points have no height, 8.33 %",
        ),
        (LINE, &full, "", "file", "a profile of one row"),
        (
            BALL,
            &full,
            "low_pass = \"3 um\"",
            "low_pass",
            "outside the wavelengths of the surface",
        ),
        (
            BALL,
            &full,
            "high_pass = \"1 mm\"",
            "high_pass",
            "outside the wavelengths of the surface",
        ),
        (
            BALL,
            &full,
            "low_pass = \"20 um\"\nhigh_pass = \"10 um\"",
            "low_pass",
            "no wave passes",
        ),
        (BALL, &full, "taper = \"1 um\"", "taper", "a taper of"),
        (
            BALL,
            &full,
            "length_unit = \"um\"",
            "length_unit",
            "remove `length_unit`",
        ),
        (
            BALL,
            &full,
            "direction = \"190 deg\"",
            "direction",
            "must be between",
        ),
        (BALL, &full, "pitch = \"1 mm\"", "pitch", "unknown key"),
        (BALL, &flat, "", "file", "check `height_unit`"),
        (BALL, "", "", "file", "no heights"),
        (BALL, "1 2 3 4\n1 2 3\n", "", "file", "line 2"),
    ] {
        let error = map(folder.path(), contact, text, more).unwrap_err();
        assert!(error.key().ends_with(key), "{more}: {error}");
        assert!(error.message().contains(says), "{more}: {error}");
    }
    let filled = map(folder.path(), BALL, &holes, "missing_share = 0.1").unwrap();
    assert_eq!(filled.reliefs[0].echo.as_ref().unwrap().missing, 100);
    // One number a line is a profile, of lines, too.
    let column = "1\n5\n3\n2\n".repeat(20);
    for contact in [LINE, BALL] {
        let case = map(folder.path(), contact, &column, "").unwrap();
        assert_eq!(case.reliefs[0].echo.as_ref().unwrap().points, [80, 1]);
    }
}

const GENERATED: &str = "kind = \"generated\"\nlength = \"200 um\"\nrolloff_wavelength = \"80 um\"\nshortest_wavelength = \"20 um\"\n\
                         hurst_exponent = 0.8\nrms_height = \"30 nm\"\n";

/// The same number gives the same heights, to the bit, and another one others; Sq is the given one.
#[test]
fn surfaces_are_made_by_their_number() {
    let of = |contact: &str, more: &str| {
        let text = format!("{GENERATED}{more}");
        read(contact, Path::new(""), &text)
            .unwrap()
            .reliefs
            .remove(0)
    };
    let [one, same, other] =
        [1, 1, 2].map(|seed| of(BALL, &format!("width = \"150 um\"\nseed = {seed}\n")));
    assert_eq!(one, same);
    assert_ne!(one.form, other.form);
    let echo = one.echo.unwrap();
    assert_eq!(echo.points, [61, 46]);
    assert_relative_eq!(echo.levelled.sq, 30e-9, max_relative = 1e-9);
    let at = one.form.at([10e-6, 5e-6]).value;
    // As made on another machine: wyrand of fastrand.
    assert_relative_eq!(at, HEIGHT_OF_ONE, max_relative = 1e-9);
    let line = of(LINE, "seed = 1\n").echo.unwrap();
    assert_eq!(line.points, [61, 1]);
    let width = read(
        LINE,
        Path::new(""),
        &format!("{GENERATED}seed = 1\nwidth = \"1 mm\"\n"),
    );
    assert!(width.unwrap_err().message().contains("unknown key"));
}

/// Height of surface 1 at (10, 5) µm.
const HEIGHT_OF_ONE: f64 = 3.153_442_907_478e-8;

/// Repeated reliefs, and those allowed without [transient].
#[test]
fn repeated_and_standing_reliefs() {
    let groove = "kind = \"groove\"\nhalf_width = \"5 um\"\ndepth = \"10 nm\"\n";
    let of = |more: &str| read(BALL, Path::new(""), &format!("{groove}{more}"));
    let repeated = of("pitch = \"20 um\"\ncount = 4\ndirection = \"90 deg\"\n").unwrap();
    let form = &repeated.reliefs[0].form;
    for (y, depth) in [(10e-6, -10e-9), (-30e-6, -10e-9), (0.0, 0.0), (50e-6, 0.0)] {
        assert_relative_eq!(form.at([0.0, y]).value, depth, epsilon = 1e-15);
    }
    let both = |more: &str| {
        let text = format!(
            "lubricant = \"squalane-pip\"\ntemperature = \"40 degC\"\n[contact]\n{BALL}\n[bodies]\nbody_1 = \"steel\"\nbody_2 = \"steel\"\n\
             [motion]\nbody_1_speed = \"1 m/s\"\nbody_2_speed = \"0.5 m/s\"\n[[surface]]\nbody = \"body_2\"\nx = \"0 m\"\n{groove}{more}"
        );
        Case::from_text("case.toml", &text, Path::new(""))
    };
    let error = both("").unwrap_err();
    contains(error.message(), "0.5 m/s: the contact is not steady");
    assert!(error.help()[0].contains("[transient]"));
    assert!(both("direction = \"90 deg\"\n").is_ok());
}
