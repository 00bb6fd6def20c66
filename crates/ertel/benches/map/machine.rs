//! The map of machine contacts: ellipses from slender to wide with the motion at any angle, and rollers with each profile, tilted or not.
//!
//! Conditions are lists walked in different strides, as in the map of sliding; pure rolling, bodies of steel, oils of the database.

use ertel::contact::roller::Profile;
use ertel::contact::{Contact, ContactKind, Hertz, reduced_modulus};
use ertel_rheology::database;

use super::cases::{Family, MapCase};

/// R_y/R_x of ellipses, which have axis ratios of 1/10, 1/5, ... 10.
const RATIOS: [f64; 11] = [
    1.0 / 36.5,
    1.0 / 12.0,
    1.0 / 6.0,
    1.0 / 3.0,
    1.0 / 1.5,
    1.1,
    1.5,
    3.0,
    6.0,
    12.0,
    36.5,
];

/// Angles of the entrainment, degrees.
const ANGLES: [f64; 10] = [0.0, 90.0, 30.0, 45.0, 0.0, 60.0, 10.0, 80.0, 20.0, 70.0];

/// Hertz pressures, GPa; those of rollers up to the ninth.
const PRESSURES: [f64; 13] = [
    0.3, 0.45, 0.6, 0.8, 1.0, 1.2, 1.4, 1.7, 2.0, 2.3, 2.6, 2.8, 3.0,
];

/// Entrainment speeds, m/s.
const SPEEDS: [f64; 7] = [0.05, 0.2, 0.5, 1.0, 2.0, 5.0, 12.0];

/// Reduced radii along x, mm.
const RADII: [f64; 4] = [5.0, 10.0, 20.0, 3.0];

/// Lengths of rollers over the half-width of their contact.
const LENGTHS: [f64; 5] = [40.0, 12.0, 80.0, 20.0, 150.0];

/// Tilts, as shares of the slope from the middle to the end of the profile for uniform pressure.
const TILTS: [f64; 3] = [0.0, 0.15, 0.5];

/// A fluid of the database with its temperature and the largest Hertz pressure it is taken to, GPa.
const OILS: [(&str, &str, Family, f64); 6] = [
    ("venner-oil", "40 degC", Family::Roelands, 3.0),
    ("squalane-pip", "313 K", Family::Doolittle, 1.4),
    ("holmes-evans-oil", "60 degC", Family::Roelands, 3.0),
    ("thesis-wlf-oil", "40 degC", Family::Wlf, 3.0),
    ("pao-650", "348 K", Family::Doolittle, 1.0),
    ("thesis-roelands-oil", "40 degC", Family::Roelands, 3.0),
];

const N_ELLIPSES: usize = 90;
const N_ROLLERS: usize = 60;

/// All cases, in a fixed order: ellipses and rollers in turn, three to two.
pub fn cases() -> Vec<MapCase> {
    let mut ellipses = (0..N_ELLIPSES).map(ellipse);
    let mut rollers = (0..N_ROLLERS).map(roller);
    let mut cases = Vec::new();
    while cases.len() < N_ELLIPSES + N_ROLLERS {
        cases.extend(ellipses.by_ref().take(3));
        cases.extend(rollers.by_ref().take(2));
    }
    cases
}

fn text(name: &str, contact: &str, speed: f64, oil: usize) -> String {
    let (fluid, temperature, _, _) = OILS[oil];
    format!(
        "title = \"{name}\"\n\n[contact]\n{contact}\n[bodies]\nbody_1 = \"steel\"\nbody_2 = \"steel\"\n\n\
         [motion]\nentrainment_speed = \"{speed} m/s\"\nslide_to_roll_ratio = 0.0\n\n\
         [lubricant]\nname = \"{fluid}\"\ntemperature = \"{temperature}\"\n\n[output]\nbody_field = false\n"
    )
}

fn ellipse(i: usize) -> MapCase {
    let oil = (5 * i + i / 6) % OILS.len();
    let (fluid, _, family, most) = OILS[oil];
    let (ratio, angle) = (RATIOS[i % RATIOS.len()], ANGLES[i % ANGLES.len()]);
    let pressure = PRESSURES[(4 * i) % PRESSURES.len()].min(most);
    let speed = SPEEDS[(3 * i) % SPEEDS.len()];
    // The smaller radius from the list.
    let radius = RADII[(i / 3) % RADII.len()];
    let radii = [1.0_f64.max(1.0 / ratio), 1.0_f64.max(ratio)].map(|r| r * radius);
    let name = format!("ellipse{i}-{ratio:.3}-{angle}deg-{pressure}GPa-{speed}mps-{fluid}");
    let contact = format!(
        "kind = \"elliptical\"\nradius_x = \"{:.4} mm\"\nradius_y = \"{:.4} mm\"\n\
         hertz_pressure = \"{pressure} GPa\"\nentrainment_angle = \"{angle} deg\"\n",
        radii[0], radii[1]
    );
    MapCase {
        text: text(&name, &contact, speed, oil),
        name,
        kind: ContactKind::Elliptical,
        family,
    }
}

fn roller(i: usize) -> MapCase {
    let oil = (5 * i + i / 6) % OILS.len();
    let (fluid, _, family, most) = OILS[oil];
    let pressure = PRESSURES[(4 * i) % 9].min(most);
    let speed = SPEEDS[(3 * i) % SPEEDS.len()];
    let radius = 1e-3 * RADII[(i / 3) % RADII.len()];
    let steel = database::solid("steel").expect("a solid of the database");
    let body = ertel::contact::Material {
        youngs_modulus: steel.youngs_modulus,
        poissons_ratio: steel.poissons_ratio,
    };
    let modulus = reduced_modulus(body, body);
    let line = Contact::line(radius, 1.0);
    let w = Hertz::load_for_pressure(&line, modulus, 1e9 * pressure);
    let b = Hertz::new(&Contact::line(radius, w), modulus).half_width;
    let ratio = LENGTHS[(i / 2) % LENGTHS.len()];
    let length = ratio * b;
    // The drop required at the ends.
    let drop = Profile::lundberg(length, w, b, modulus).drop(length, 0.5 * length)[0];
    let share = TILTS[(i / 6) % TILTS.len()];
    let um = |x: f64| format!("\"{:.6} um\"", 1e6 * x);
    let (label, profile) = match i % 6 {
        0 => (
            "log",
            format!(
                "kind = \"logarithmic\", design_load = \"{:.6} N\"",
                w * length
            ),
        ),
        1 => (
            "crown",
            format!("kind = \"crown\", end_drop = {}", um(1.5 * drop)),
        ),
        2 => (
            "straight",
            format!(
                "kind = \"straight\", straight_length = {}, end_radius = {}",
                um(0.8 * length),
                um((0.1 * length).powi(2) / (2.4 * drop))
            ),
        ),
        3 => (
            "iso",
            format!("kind = \"iso-16281\", diameter = {}", um(2.0 * radius)),
        ),
        4 => (
            "log1.5",
            format!(
                "kind = \"logarithmic\", design_load = \"{:.6} N\"",
                1.5 * w * length
            ),
        ),
        _ => {
            let places = [0.0, 0.2, 0.4, 0.6, 0.7, 0.8, 0.9, 1.0_f64];
            let list = |f: &dyn Fn(f64) -> f64| places.map(|t| um(f(t))).join(", ");
            (
                "table",
                format!(
                    "kind = \"table\", position = [{}], drop = [{}]",
                    list(&|t| 0.5 * length * t),
                    list(&|t| 1.3 * drop * t.powi(4))
                ),
            )
        }
    };
    let tilt = share * drop / (0.5 * length);
    let name = format!("roller{i}-{label}-tilt{share}-l{ratio}-{pressure}GPa-{speed}mps-{fluid}");
    let contact = format!(
        "kind = \"roller\"\nradius = \"{:.4} mm\"\nlength = {}\nload = \"{:.6} N\"\nprofile = {{ {profile} }}\n\
         misalignment = \"{tilt:.9} rad\"\n",
        1e3 * radius,
        um(length),
        w * length
    );
    MapCase {
        text: text(&name, &contact, speed, oil),
        name,
        kind: ContactKind::Roller,
        family,
    }
}
