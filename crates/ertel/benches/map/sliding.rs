//! The map of sliding and heat: fluids that thin, limit their stress or heat up, at pressures, speeds and slidings of machines.
//!
//! The conditions of a family are three lists, each walked in another stride, so that every pressure meets many speeds and
//! slidings. Thirteen is prime: no stride repeats a condition before all have come.

use ertel::contact::ContactKind;

use super::cases::{Family, MapCase};

/// Hertz pressures, GPa, between bodies of steel and ceramics.
const PRESSURES: [f64; 13] = [
    0.3, 0.5, 0.7, 0.9, 1.1, 1.3, 1.5, 1.7, 1.9, 2.1, 2.3, 2.5, 0.4,
];

/// Entrainment speeds, m/s.
const SPEEDS: [f64; 13] = [
    0.05, 0.1, 0.2, 0.4, 0.8, 1.5, 2.5, 4.0, 7.0, 11.0, 16.0, 22.0, 30.0,
];

/// Slide-to-roll ratios; beyond 2 the surfaces move against one another.
const SLIDINGS: [f64; 13] = [
    0.0, 0.01, 0.03, 0.1, 0.2, 0.4, 0.7, 1.0, 1.5, 2.0, -0.5, -2.0, 3.0,
];

/// Radii, mm.
const RADII: [f64; 4] = [10.0, 12.7, 20.0, 5.0];

/// Plane and ball, the largest Hertz pressure that they bear, GPa, and their share of the pressures of the list.
const BODIES: [(&str, &str, f64, f64); 7] = [
    (STEEL, STEEL, 2.5, 1.0),
    (GEAR_STEEL, GEAR_STEEL, 2.5, 1.0),
    (GLASS, STEEL, 0.9, 1.0),
    (STEEL, NITRIDE, 2.5, 1.0),
    ("\"sapphire\"", STEEL, 1.9, 1.0),
    (STEEL, STEEL, 2.5, 1.0),
    // Polymers bear less, and heat stays in them.
    (PEEK, STEEL, 0.12, 0.05),
];

const STEEL: &str = "\"steel\"";
const GEAR_STEEL: &str = "\"gear-steel\"";
const GLASS: &str = "\"glass\"";
const PEEK: &str = "\"peek\"";

// Thermal data are nominal: the sources of the database print none.
const NITRIDE: &str = "{ name = \"silicon-nitride\", thermal_conductivity = \"29 W/(m.K)\", heat_capacity = \"680 J/(kg.K)\" }";

/// A lubricant with its temperature, as a case file names it.
struct Oil {
    text: &'static str,
    /// Largest Hertz pressure for which it has data or is liquid, GPa.
    most: f64,
    /// Whether it has what heat needs.
    heated: bool,
}

const fn oil(text: &'static str, most: f64, heated: bool) -> Oil {
    Oil { text, most, heated }
}

/// A mineral oil of 40 mPa·s and one of 10 mPa·s as gear calculations take them.
macro_rules! mineral {
    (40) => {
        "temperature = \"40 degC\"\n\
         density = { law = \"dowson-higginson\", rho_0 = \"870 kg/m^3\" }\n\
         viscosity = { law = \"roelands\", mu_0 = \"40 mPa.s\", alpha = \"20 1/GPa\", beta = \"0.04 1/K\", reference_temperature = \"40 degC\" }\n\
         thermal_conductivity = \"0.14 W/(m.K)\"\nheat_capacity = \"2000 J/(kg.K)\"\n"
    };
    (10) => {
        "temperature = \"80 degC\"\n\
         density = { law = \"dowson-higginson\", rho_0 = \"850 kg/m^3\" }\n\
         viscosity = { law = \"roelands\", mu_0 = \"10 mPa.s\", alpha = \"17 1/GPa\", beta = \"0.03 1/K\", reference_temperature = \"80 degC\" }\n\
         thermal_conductivity = \"0.14 W/(m.K)\"\nheat_capacity = \"2100 J/(kg.K)\"\n"
    };
}

const NEWTONIAN: [Oil; 4] = [
    oil("name = \"glycerol\"\ntemperature = \"313 K\"\n", 2.5, true),
    oil(mineral!(40), 2.5, true),
    oil("name = \"water\"\ntemperature = \"40 degC\"\n", 0.7, true),
    oil(mineral!(10), 2.5, true),
];

const CARREAU: [Oil; 3] = [
    oil(
        "name = \"squalane-pip\"\ntemperature = \"313 K\"\n",
        2.5,
        true,
    ),
    oil("name = \"pao-650\"\ntemperature = \"348 K\"\n", 1.3, false),
    oil(
        concat!(
            mineral!(40),
            "shear_thinning = { law = \"carreau\", g_c = \"3 MPa\", n = 0.6, beta_c = 2.0, mu_2 = \"0 Pa.s\" }\n"
        ),
        2.5,
        true,
    ),
];

const CARREAU_YASUDA: [Oil; 2] = [
    oil(
        concat!(
            mineral!(40),
            "shear_thinning = { law = \"carreau-yasuda\", g = \"5 MPa\", n = 0.45, a = 5.0, mu_2 = \"0 Pa.s\" }\n"
        ),
        2.5,
        true,
    ),
    oil(
        "name = \"squalane-pip\"\ntemperature = \"313 K\"\nshear_thinning = { law = \"carreau-yasuda\", g = \"0.02 MPa\", n = 0.8, a = 3.0, mu_2 = \"15.7 mPa.s\" }\n",
        2.5,
        true,
    ),
];

const REE_EYRING: [Oil; 3] = [
    oil(
        concat!(
            mineral!(10),
            "shear_thinning = { law = \"ree-eyring\", tau_0 = \"5 MPa\" }\n"
        ),
        2.5,
        true,
    ),
    oil(
        "name = \"glycerol\"\ntemperature = \"313 K\"\nshear_thinning = { law = \"ree-eyring\", tau_0 = \"10 MPa\" }\n",
        2.5,
        true,
    ),
    oil(
        concat!(
            mineral!(40),
            "shear_thinning = { law = \"ree-eyring\", tau_0 = \"7 MPa\" }\n"
        ),
        2.5,
        true,
    ),
];

const LIMITING: [Oil; 3] = [
    oil(
        concat!(
            mineral!(40),
            "shear_thinning = { law = \"limiting-stress\", tau_l0 = \"5 MPa\", lambda = 0.05 }\n"
        ),
        2.5,
        true,
    ),
    oil(
        concat!(
            mineral!(10),
            "shear_thinning = { law = \"ree-eyring\", tau_0 = \"5 MPa\", limit = { tau_l0 = \"5 MPa\", lambda = 0.06 } }\n"
        ),
        2.5,
        true,
    ),
    oil(
        "name = \"squalane-pip\"\ntemperature = \"313 K\"\nshear_thinning = { law = \"carreau\", mu_2 = \"15.7 mPa.s\", g_c = \"0.01 MPa\", n = 0.8, beta_c = 2.198, limit = { tau_l0 = \"5 MPa\", lambda = 0.07 } }\n",
        2.5,
        true,
    ),
];

/// All cases, in a fixed order.
pub fn cases() -> Vec<MapCase> {
    let families: [(Family, &str, &[Oil]); 5] = [
        (Family::Newtonian, "newtonian", &NEWTONIAN),
        (Family::Carreau, "carreau", &CARREAU),
        (Family::CarreauYasuda, "carreau-yasuda", &CARREAU_YASUDA),
        (Family::ReeEyring, "ree-eyring", &REE_EYRING),
        (Family::Limiting, "limiting", &LIMITING),
    ];
    let kinds = [ContactKind::Line, ContactKind::Circular];
    let mut cases = Vec::new();
    for (k, kind) in kinds.into_iter().enumerate() {
        for (f, (family, name, oils)) in families.iter().enumerate() {
            for i in 0..PRESSURES.len() {
                let turn = i + 3 * f + 5 * k;
                cases.push(case(
                    kind,
                    *family,
                    name,
                    &oils[i % oils.len()],
                    [i, turn, 7 * k + f],
                ));
            }
        }
    }
    cases
}

/// A case of a family by its number, its turn in the lists of bodies, radii and speeds, and the start of that of slidings.
fn case(
    kind: ContactKind,
    family: Family,
    law: &str,
    oil: &Oil,
    [i, turn, start]: [usize; 3],
) -> MapCase {
    let (plane, ball, most, share) = BODIES[turn % BODIES.len()];
    let pressure = (1e3 * (share * PRESSURES[i]).min(most).min(oil.most)).round();
    let speed = SPEEDS[(5 * turn) % SPEEDS.len()];
    let sliding = SLIDINGS[(8 * i + 2 * start) % SLIDINGS.len()];
    let radius = RADII[turn % RADII.len()];
    // Laws that thin are solved without heat, too.
    let thermal = oil.heated && (family == Family::Newtonian || i % 4 != 3);
    let contact = match kind {
        ContactKind::Line => "line",
        ContactKind::Circular | ContactKind::Elliptical | ContactKind::Roller => "circular",
    };
    let heat = if thermal { "[thermal]\n" } else { "" };
    let name = format!(
        "{contact}-{law}-{pressure}MPa-{speed}mps-srr{sliding}{}",
        if thermal { "-heat" } else { "" }
    );
    let text = format!(
        "title = \"{name}\"\n\n[contact]\nkind = \"{contact}\"\nradius = \"{radius} mm\"\n\
         hertz_pressure = \"{pressure} MPa\"\n\n[bodies]\nbody_1 = {plane}\nbody_2 = {ball}\n\n\
         [motion]\nentrainment_speed = \"{speed} m/s\"\nslide_to_roll_ratio = {sliding}\n\n\
         [lubricant]\n{}\n{heat}[output]\nbody_field = false\n",
        oil.text
    );
    MapCase {
        name,
        kind,
        family,
        text,
    }
}
