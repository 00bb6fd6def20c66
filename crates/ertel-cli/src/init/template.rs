//! The cases that one starts from: those that come with ertel.

use std::path::Path;

use ertel::case::Case;
use ertel_input::InputError;

use crate::failure::Failure;

/// A case to start from.
pub struct Template {
    /// Name on the command line.
    pub name: &'static str,
    /// What it is.
    pub about: &'static str,
    /// The shipped case.
    case: &'static str,
    /// Keys to ask for, each with what it is called.
    pub questions: &'static [(&'static str, &'static str)],
}

/// Questions that every case has.
pub const COMMON: &[(&str, &str)] = &[
    (
        "bodies.body_2",
        "material of the ball, roller, pinion or cam (`ertel solids` lists them)",
    ),
    (
        "bodies.body_1",
        "material of the disc, ring, wheel or tappet",
    ),
    (
        "lubricant.temperature",
        "temperature of the lubricant at the inlet",
    ),
    (
        "lubricant.viscosity.reference_temperature",
        "temperature at which its viscosity is known",
    ),
    (
        "lubricant.viscosity.mu_0",
        "viscosity at that temperature and ambient pressure",
    ),
    (
        "lubricant.viscosity.beta",
        "how fast it falls with temperature, ln(mu_1/mu_2)/(T_2 - T_1), 0.03 to 0.05 1/K for oils",
    ),
    (
        "lubricant.viscosity.alpha",
        "pressure-viscosity coefficient",
    ),
    ("lubricant.density.rho_0", "density at ambient pressure"),
];

/// The templates.
pub const TEMPLATES: &[Template] = &[
    Template {
        name: "bearing",
        about: "a ball on the raceway of a ball bearing (elliptical contact)",
        case: include_str!("../../../../cases/machine/ball-bearing.toml"),
        questions: &[
            ("machine.ring", "ring, \"inner\" or \"outer\""),
            ("machine.ball_diameter", "diameter of the balls"),
            ("machine.pitch_diameter", "pitch diameter of the bearing"),
            (
                "machine.inner_groove_curvature",
                "radius of the inner groove over the diameter of the balls",
            ),
            (
                "machine.outer_groove_curvature",
                "the same of the outer groove",
            ),
            ("machine.contact_angle", "contact angle"),
            ("machine.inner_ring_speed", "speed of the inner ring"),
            ("machine.outer_ring_speed", "speed of the outer ring"),
            ("machine.ball_load", "load of one ball"),
        ],
    },
    Template {
        name: "roller-bearing",
        about: "a cylindrical roller on the raceway of a bearing (line contact)",
        case: include_str!("../../../../cases/machine/roller-bearing.toml"),
        questions: &[
            ("machine.ring", "ring, \"inner\" or \"outer\""),
            ("machine.roller_diameter", "diameter of the rollers"),
            ("machine.roller_length", "length of a roller that carries"),
            ("machine.pitch_diameter", "pitch diameter of the bearing"),
            ("machine.inner_ring_speed", "speed of the inner ring"),
            ("machine.roller_load", "load of one roller"),
        ],
    },
    Template {
        name: "gear",
        about: "two teeth of spur gears (line contact)",
        case: include_str!("../../../../cases/machine/spur-gear.toml"),
        questions: &[
            ("machine.module", "module"),
            ("machine.pinion_teeth", "teeth of the pinion"),
            ("machine.wheel_teeth", "teeth of the wheel"),
            ("machine.pressure_angle", "pressure angle"),
            ("machine.face_width", "face width"),
            ("machine.pinion_torque", "torque of the pinion"),
            ("machine.pinion_speed", "speed of the pinion"),
            (
                "machine.position",
                "distance from the pitch point along the line of action, or \"pitch point\"",
            ),
        ],
    },
    Template {
        name: "helical-gear",
        about: "two teeth of helical gears (line contact)",
        case: include_str!("../../../../cases/machine/helical-gear.toml"),
        questions: &[
            ("machine.normal_module", "normal module"),
            ("machine.pinion_teeth", "teeth of the pinion"),
            ("machine.wheel_teeth", "teeth of the wheel"),
            ("machine.helix_angle", "helix angle"),
            ("machine.face_width", "face width"),
            ("machine.pinion_torque", "torque of the pinion"),
            ("machine.pinion_speed", "speed of the pinion"),
            (
                "machine.position",
                "distance from the pitch point along the line of action, or \"pitch point\"",
            ),
        ],
    },
    Template {
        name: "cam",
        about: "a cam on a flat tappet (line contact)",
        case: include_str!("../../../../cases/machine/cam-and-flat-tappet.toml"),
        questions: &[
            ("machine.base_radius", "radius of the base circle"),
            ("machine.lift", "lift at this angle of the cam"),
            (
                "machine.lift_acceleration",
                "second derivative of the lift by the angle in rad, a length",
            ),
            ("machine.cam_speed", "speed of the cam"),
            ("machine.width", "width of the contact"),
            ("machine.load", "load"),
        ],
    },
    Template {
        name: "rig",
        about: "a ball on the disc of a test rig (circular contact)",
        case: include_str!("../../../../cases/machine/ball-on-disc.toml"),
        questions: &[
            ("machine.ball_diameter", "diameter of the ball"),
            ("machine.load", "load"),
            ("machine.ball_speed", "surface speed of the ball"),
            ("machine.disc_speed", "surface speed of the disc"),
        ],
    },
    Template {
        name: "ball",
        about: "a circular contact by its reduced radius",
        case: include_str!("../../../../cases/ball-on-disc.toml"),
        questions: &[
            ("contact.radius", "reduced radius"),
            ("contact.load", "load"),
            (
                "motion.entrainment_speed",
                "entrainment speed, the mean of both surfaces",
            ),
            ("motion.slide_to_roll_ratio", "slide-to-roll ratio"),
        ],
    },
    Template {
        name: "line",
        about: "a line contact by its reduced radius",
        case: include_str!("../../../../cases/roller.toml"),
        questions: &[
            ("contact.radius", "reduced radius"),
            ("contact.load", "load per length"),
            (
                "motion.entrainment_speed",
                "entrainment speed, the mean of both surfaces",
            ),
            ("motion.slide_to_roll_ratio", "slide-to-roll ratio"),
        ],
    },
    Template {
        name: "roller",
        about: "a roller of finite length with a profile",
        case: include_str!("../../../../cases/cylindrical-roller.toml"),
        questions: &[
            ("contact.radius", "reduced radius"),
            ("contact.length", "length of the roller"),
            ("contact.load", "load"),
            (
                "motion.entrainment_speed",
                "entrainment speed, the mean of both surfaces",
            ),
            ("motion.slide_to_roll_ratio", "slide-to-roll ratio"),
        ],
    },
];

/// What stands above every template.
const HEAD: &str = "\
# Numbers have units, inside quotes; a ± gives an uncertainty: \"30 N ± 2 %\". All keys: docs/reference/case-file.md.
#
#   ertel solve --check FILE.toml    reads and checks this file, and says what it is
#   ertel estimate FILE.toml         films by published formulas, at once
#   ertel solve FILE.toml            solves it and writes films, pressures and pictures into a folder
#
";

/// What stands below: sections that a case may have, without effect until the `# ` before them is removed.
const OPTIONS: &str = "
## More that may be said; remove the `# ` before a line.

## Roughness, for the lambda ratio and the share of the load that asperities carry. The asperities here are usual numbers, of which the load
## of thin films is more than they can carry (a warning says so): measure those of your surfaces.
# [surface_roughness]
# body_1_rms_height = \"50 nm\"
# body_2_rms_height = \"50 nm\"
# asperity_group = 0.05
# rms_height_to_asperity_radius = 0.001
# boundary_friction_coefficient = 0.1

## How exact the films shall be.
# [mesh]
# target_error = \"0.2 %\"

## Where the results go.
# [output]
# folder = \"results/my-case\"
";

impl Template {
    /// The case file.
    pub fn text(&self) -> String {
        format!("{HEAD}{}{OPTIONS}", self.case)
    }

    /// The case with values in place of its own.
    ///
    /// # Errors
    ///
    /// Values that no such contact can have.
    pub fn read(&self, settings: &[String]) -> Result<Case, InputError> {
        Case::from_text_with(self.name, &self.text(), Path::new(""), settings)
    }
}

/// The template of a name, or of its number in the list.
///
/// # Errors
///
/// A name that is none; the message lists them.
pub fn named(name: &str) -> Result<&'static Template, Failure> {
    let number = name.parse::<usize>().ok().and_then(|n| n.checked_sub(1));
    let found = TEMPLATES
        .iter()
        .find(|t| t.name == name)
        .or_else(|| TEMPLATES.get(number?));
    found.ok_or_else(|| {
        let names: Vec<&str> = TEMPLATES.iter().map(|t| t.name).collect();
        Failure::Argument(format!(
            "there is no template `{name}`; it is one of: {}",
            names.join(", ")
        ))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// As it stands, and with all that may be added.
    #[test]
    fn every_template_is_a_good_case() {
        for template in TEMPLATES {
            let case = template
                .read(&[])
                .unwrap_or_else(|e| panic!("{}: {e}", template.name));
            assert_eq!(case.warnings, [], "{}", template.name);
            let uncommented: Vec<String> = OPTIONS
                .lines()
                .map(|line| line.strip_prefix("# ").unwrap_or(line).to_owned())
                .collect();
            let text = format!("{HEAD}{}{}", template.case, uncommented.join("\n"));
            let case = Case::from_text(template.name, &text, Path::new(""));
            let case = case.unwrap_or_else(|e| panic!("{}: {e}", template.name));
            assert!(case.asperities.is_some(), "{}", template.name);
        }
    }

    #[test]
    fn every_question_is_about_a_key_of_its_template() {
        for template in TEMPLATES {
            let case = template.read(&[]).unwrap();
            for (key, _) in template.questions.iter().chain(COMMON) {
                let pointer = format!("/{}", key.replace('.', "/"));
                assert!(
                    case.given.pointer(&pointer).is_some(),
                    "{}: {key}",
                    template.name
                );
            }
        }
    }
}
