//! Elliptical contacts in case files.

use std::path::Path;

use crate::near::near;
use approx::assert_relative_eq;
use ertel_input::InputError;

use super::Case;

const REST: &str = r#"
[motion]
entrainment_speed = "1 m/s"
slide_to_roll_ratio = 0.0
[lubricant]
temperature = "40 degC"
density = { law = "dowson-higginson", rho_0 = "870 kg/m^3" }
viscosity = { law = "roelands", mu_0 = "40 mPa.s", alpha = "20 1/GPa" }
"#;

const STEEL: &str = "youngs_modulus = \"210 GPa\", poissons_ratio = 0.3";

fn read(contact: &str, radii: [&str; 2], more: &str) -> Result<Case, InputError> {
    let text = format!(
        "[contact]\nkind = \"elliptical\"\nload = \"100 N\"\n{contact}\n[bodies]\nbody_1 = {{ {STEEL}{} }}\n\
         body_2 = {{ {STEEL}{} }}\n{more}\n{REST}",
        radii[0], radii[1]
    );
    Case::from_text("case.toml", &text, Path::new(""))
}

const NONE: [&str; 2] = ["", ""];
const BALL: &str = ", radius_x = \"5 mm\", radius_y = \"5 mm\"";

/// Reduced radii as given, and those of a ball in a groove: 1/R = 1/5 ± …, by hand.
#[test]
fn radii_of_the_contact_or_of_the_bodies() {
    let given = "radius_x = \"10 mm\"\nradius_y = \"30 mm\"\nentrainment_angle = \"30 deg\"";
    let contact = read(given, NONE, "").unwrap().contact;
    assert_eq!((contact.radius, contact.radius_y), (0.01, 0.03));
    assert_relative_eq!(
        contact.entrainment_angle,
        std::f64::consts::FRAC_PI_6,
        max_relative = 1e-14
    );
    let groove = ", radius_x = \"15 mm\", radius_y = \"-5.2 mm\"";
    let contact = read("", [groove, BALL], "").unwrap().contact;
    assert_relative_eq!(contact.radius, 3.75e-3, max_relative = 1e-12);
    assert_relative_eq!(contact.radius_y, 0.13, max_relative = 1e-12);
    // A cylinder turned by a quarter against a flat is one whose axes are exchanged.
    let cylinder = ", radius_x = \"20 mm\", radius_y = \"40 mm\"";
    let flat = ", radius_x = \"flat\", radius_y = \"flat\"";
    let contact = read("", [flat, cylinder], "axes_angle = \"90 deg\"")
        .unwrap()
        .contact;
    assert_relative_eq!(contact.radius, 0.04, max_relative = 1e-12);
    assert_relative_eq!(contact.radius_y, 0.02, max_relative = 1e-12);
    assert!(contact.entrainment_angle.abs() < 1e-12);
    // Turned by 20 degrees, the motion along x of body 1 is at −20 degrees to the principal direction.
    let contact = read("", [flat, cylinder], "axes_angle = \"20 deg\"")
        .unwrap()
        .contact;
    near(contact.entrainment_angle.to_degrees(), -20.0, 1e-12);
}

#[test]
fn impossible_ellipses_are_refused() {
    let radii = "radius_x = \"10 mm\"\nradius_y = \"30 mm\"";
    let conformal = ", radius_x = \"flat\", radius_y = \"-4.9 mm\"";
    let flat = ", radius_x = \"flat\", radius_y = \"flat\"";
    let cylinder = ", radius_x = \"10 mm\", radius_y = \"flat\"";
    for (contact, bodies, more, expected) in [
        ("", NONE, "", "missing key `radius_x`"),
        (
            "radius_x = \"10 mm\"\nradius_y = \"30 m\"",
            NONE,
            "",
            "outside 1/1000 to 1000",
        ),
        (
            "radius_x = \"-10 mm\"\nradius_y = \"30 mm\"",
            NONE,
            "",
            "`radius_x`",
        ),
        (
            "radius_x = \"10 mm\"\nradius_y = \"30 mm\"\nentrainment_angle = 30",
            NONE,
            "",
            "unit",
        ),
        (
            radii,
            [flat, BALL],
            "",
            "follows from the radii of the bodies",
        ),
        ("", [conformal, BALL], "", "no Hertz ellipse exists"),
        ("", [flat, cylinder], "", "touch along a line"),
        (
            "",
            [flat, ""],
            "",
            "one body has radii and the other has none",
        ),
        (radii, NONE, "axes_angle = \"10 deg\"", "neither has radii"),
        (radii, NONE, "plane = \"steel\"", "are the same body"),
        (
            "",
            [flat, ", radius_x = \"1 nm\", radius_y = \"5 mm\""],
            "",
            "must not be below 1 um",
        ),
    ] {
        let error = read(contact, bodies, more).unwrap_err().to_string();
        assert!(error.contains(expected), "{expected}: {error}");
        assert!(error.contains("case.toml:"), "{error}");
    }
    let body = format!("{REST}[solver]\nelasticity = \"equivalent\"\n");
    let text = format!(
        "[contact]\nkind = \"elliptical\"\nload = \"100 N\"\n{radii}\n[bodies]\nplane = \"steel\"\nball = \"steel\"\n{body}"
    );
    let error = Case::from_text("case.toml", &text, Path::new("")).unwrap_err();
    assert!(error.to_string().contains("needs half-spaces"), "{error}");
}
