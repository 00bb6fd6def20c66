//! The cases of the map of rolling: a fixed list over load, material, laws, bodies and speeds.
//!
//! Cases by Moes' groups M (load) and L (material) take the pressure-viscosity coefficient from a
//! list and let viscosity times speed follow from L; the first coefficient whose Hertz pressure
//! lies between 1 MPa and 4 GPa is taken, and a point of the grid without one is omitted.
//! Cases of database fluids vary Hertz pressure and speed. Each case is a case file, read like that
//! of a user.

use std::fmt::Write;
use std::path::Path;

use ertel::case::Case;
use ertel::contact::{Contact, ContactKind, Hertz};
use ertel_input::InputError;
use ertel_rheology::database;

/// A case of the map.
pub struct MapCase {
    /// Name: kind, law, and what sets it apart.
    pub name: String,
    /// Line or circular.
    pub kind: ContactKind,
    /// Family of laws, for tables and the picture.
    pub family: Family,
    /// The case file.
    pub text: String,
}

impl MapCase {
    /// The case, read from its text.
    ///
    /// # Errors
    /// When the text is no valid case.
    pub fn read(&self) -> Result<Case, InputError> {
        Case::from_text(&self.name, &self.text, Path::new(""))
    }
}

/// Laws of the maps: of the viscosity under pressure in rolling, of the shear in sliding.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Family {
    Constant,
    Barus,
    Roelands,
    Wlf,
    Doolittle,
    Newtonian,
    Carreau,
    CarreauYasuda,
    ReeEyring,
    Limiting,
}

impl Family {
    pub const ALL: [Family; 10] = [
        Family::Constant,
        Family::Barus,
        Family::Roelands,
        Family::Wlf,
        Family::Doolittle,
        Family::Newtonian,
        Family::Carreau,
        Family::CarreauYasuda,
        Family::ReeEyring,
        Family::Limiting,
    ];

    pub fn name(self) -> &'static str {
        match self {
            Family::Constant => "constant",
            Family::Barus => "Barus",
            Family::Roelands => "Roelands",
            Family::Wlf => "WLF",
            Family::Doolittle => "Doolittle",
            Family::Newtonian => "Newtonian",
            Family::Carreau => "Carreau",
            Family::CarreauYasuda => "Carreau-Yasuda",
            Family::ReeEyring => "Ree-Eyring",
            Family::Limiting => "limiting stress",
        }
    }
}

/// Hertz pressures of the map, Pa.
const PRESSURES: std::ops::RangeInclusive<f64> = 1e6..=4e9;

/// Pressure-viscosity coefficients, 1/GPa.
const COEFFICIENTS: [f64; 8] = [22.0, 15.0, 28.0, 12.0, 18.0, 30.0, 10.0, 25.0];

/// Speed groups 2U of contacts of constant viscosity.
const SPEED_GROUPS: [f64; 5] = [1e-11, 1e-13, 1e-9, 1e-12, 1e-10];

/// Radii, mm.
const RADII: [f64; 5] = [16.0, 5.0, 12.7, 20.0, 10.0];

/// Ambient viscosities, mPa·s.
const VISCOSITIES: [f64; 5] = [40.0, 10.0, 100.0, 3.0, 400.0];

/// Entrainment speeds looked for, m/s.
const SPEEDS: std::ops::RangeInclusive<f64> = 0.01..=20.0;

/// Density law of a group of cases.
#[derive(Clone, Copy, PartialEq)]
enum Density {
    Constant,
    DowsonHigginson,
    Tait,
}

impl Density {
    fn toml(self) -> &'static str {
        match self {
            Density::Constant => r#"{ law = "constant", rho_0 = "870 kg/m^3" }"#,
            Density::DowsonHigginson => r#"{ law = "dowson-higginson", rho_0 = "870 kg/m^3" }"#,
            // Typical of hydrocarbons (squalane at 40 degC)
            Density::Tait => {
                r#"{ law = "tait", rho_0 = "870 kg/m^3", k_0r = "1.0 GPa", k_0r_prime = 11.3 }"#
            }
        }
    }

    fn tag(self) -> &'static str {
        match self {
            Density::Constant => "-inc",
            Density::DowsonHigginson => "",
            Density::Tait => "-tait",
        }
    }
}

/// Both bodies by their names in the database.
#[derive(Clone, Copy)]
struct Bodies {
    body_1: &'static str,
    body_2: &'static str,
}

const fn bodies(body_1: &'static str, body_2: &'static str) -> Bodies {
    Bodies { body_1, body_2 }
}

const STEEL: Bodies = bodies("steel", "steel");

/// Every sixth or so of the cases by M and L has dissimilar bodies.
const BODIES: [Bodies; 12] = [
    STEEL,
    STEEL,
    STEEL,
    bodies("glass", "steel"),
    STEEL,
    STEEL,
    STEEL,
    bodies("sapphire", "steel"),
    STEEL,
    STEEL,
    STEEL,
    bodies("glass", "steel"),
];

const LINE: ContactKind = ContactKind::Line;
const CIRCULAR: ContactKind = ContactKind::Circular;

/// All cases, in a fixed order.
pub fn cases() -> Vec<MapCase> {
    use Density::{Constant, DowsonHigginson, Tait};
    const ALL_M: [f64; 13] = [
        1., 2., 5., 10., 20., 50., 100., 200., 500., 1000., 2000., 5000., 10000.,
    ];
    const SOME_M: [f64; 7] = [1., 5., 20., 100., 500., 2000., 10000.];
    const OTHER_M: [f64; 6] = [2., 10., 50., 200., 1000., 5000.];
    let mut list = List::default();
    for kind in [LINE, CIRCULAR] {
        list.constant(kind, DowsonHigginson, &ALL_M);
        list.constant(kind, Constant, &SOME_M);
        let materials: &[f64] = match kind {
            LINE => &[1., 2.5, 5., 7.5, 10., 12.5, 15., 20., 25.],
            _ => &[1., 2.5, 5., 10., 15., 20., 25.],
        };
        list.grid(kind, Family::Roelands, DowsonHigginson, &ALL_M, materials);
        let some = [2.5, 5., 10., 20.];
        list.grid(kind, Family::Roelands, Constant, &SOME_M, &some);
        list.grid(kind, Family::Roelands, Tait, &OTHER_M, &[2.5, 10., 20.]);
        let some = [1., 2.5, 5., 10., 15., 25.];
        list.grid(kind, Family::Barus, DowsonHigginson, &OTHER_M, &some);
        list.grid(kind, Family::Barus, Constant, &SOME_M, &[2.5, 5., 10.]);
        list.grid(kind, Family::Barus, Tait, &OTHER_M, &[5., 15.]);

        let heavy = [0.2, 0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 3.5];
        let speeds: &[f64] = match kind {
            LINE => &[0.05, 0.3, 1.0, 5.0],
            _ => &[0.1, 1.0, 5.0],
        };
        let wlf = Fluid::new("thesis-wlf-oil", Family::Wlf, "40 degC", STEEL);
        list.fluid(kind, wlf, &heavy, speeds);
        let pip = Fluid::new(
            "squalane-pip",
            Family::Doolittle,
            "313 K",
            bodies("glass", "steel"),
        );
        list.fluid(kind, pip, &[0.1, 0.3, 0.5], &[0.01, 0.1, 1.0]);
        let pip = Fluid {
            bodies: STEEL,
            ..pip
        };
        list.fluid(kind, pip, &[0.6, 0.8, 1.0, 1.2], &[0.02, 0.3, 3.0]);
        let pao = Fluid::new(
            "pao-650",
            Family::Doolittle,
            "348 K",
            bodies("glass", "steel"),
        );
        list.fluid(kind, pao, &[0.1, 0.3, 0.528, 0.8], &[0.003, 0.05, 1.0]);
    }
    list.cases
}

/// A fluid of the database between bodies.
#[derive(Clone, Copy)]
struct Fluid {
    name: &'static str,
    family: Family,
    temperature: &'static str,
    bodies: Bodies,
}

impl Fluid {
    fn new(name: &'static str, family: Family, temperature: &'static str, bodies: Bodies) -> Fluid {
        Fluid {
            name,
            family,
            temperature,
            bodies,
        }
    }
}

#[derive(Default)]
struct List {
    cases: Vec<MapCase>,
}

impl List {
    /// Constant viscosity: L = 0, the speed group from the list.
    fn constant(&mut self, kind: ContactKind, density: Density, loads: &[f64]) {
        for m in loads {
            let turn = self.cases.len();
            let bodies = BODIES[turn % BODIES.len()];
            let modulus = reduced_modulus(bodies);
            let radius = RADII[turn % RADII.len()] * 1e-3;
            let group = rotated(&SPEED_GROUPS, turn)
                .find(|u| PRESSURES.contains(&moes_pressure(kind, modulus, radius, *m, *u).1));
            let Some(group) = group else { continue };
            let (mu_0, speed) = viscosity_and_speed(0.5 * group * modulus * radius, turn);
            let viscosity = format!(r#"{{ law = "constant", mu_0 = "{mu_0} mPa.s" }}"#);
            let (load, _) = moes_pressure(kind, modulus, radius, *m, group);
            let name = format!("constant{}-M{m}", density.tag());
            let lubricant = lubricant(density, &viscosity);
            let contact = Contact::of_one_radius(kind, radius, load);
            self.push(Family::Constant, &name, contact, bodies, speed, &lubricant);
        }
    }

    /// Loads and materials of Moes: the speed follows from L.
    fn grid(
        &mut self,
        kind: ContactKind,
        family: Family,
        density: Density,
        loads: &[f64],
        materials: &[f64],
    ) {
        for l in materials {
            for m in loads {
                let turn = self.cases.len();
                let bodies = BODIES[turn % BODIES.len()];
                let modulus = reduced_modulus(bodies);
                let radius = RADII[turn % RADII.len()] * 1e-3;
                // L = αE' (2U)^(1/4)
                let group = |alpha: f64| (l / (alpha * 1e-9 * modulus)).powi(4);
                let alpha = rotated(&COEFFICIENTS, turn).find(|alpha| {
                    PRESSURES.contains(&moes_pressure(kind, modulus, radius, *m, group(*alpha)).1)
                });
                let Some(alpha) = alpha else { continue };
                let (load, _) = moes_pressure(kind, modulus, radius, *m, group(alpha));
                let (mu_0, speed) =
                    viscosity_and_speed(0.5 * group(alpha) * modulus * radius, turn);
                let law = family.name().to_lowercase();
                let viscosity = format!(
                    r#"{{ law = "{law}", mu_0 = "{mu_0} mPa.s", alpha = "{alpha} 1/GPa" }}"#
                );
                let name = format!("{law}{}-M{m}-L{l}", density.tag());
                let lubricant = lubricant(density, &viscosity);
                let contact = Contact::of_one_radius(kind, radius, load);
                self.push(family, &name, contact, bodies, speed, &lubricant);
            }
        }
    }

    /// A fluid of the database at Hertz pressures, GPa, and entrainment speeds, m/s.
    fn fluid(&mut self, kind: ContactKind, fluid: Fluid, pressures: &[f64], speeds: &[f64]) {
        for p in pressures {
            for speed in speeds {
                let turn = self.cases.len();
                let radius = RADII[turn % RADII.len()] * 1e-3;
                let modulus = reduced_modulus(fluid.bodies);
                let contact = Contact::of_one_radius(kind, radius, 0.0);
                let load = Hertz::load_for_pressure(&contact, modulus, p * 1e9);
                let name = format!("{}-{p}GPa-{speed}mps", fluid.name);
                let lubricant = format!(
                    "name = \"{}\"\ntemperature = \"{}\"\n",
                    fluid.name, fluid.temperature
                );
                let contact = Contact::of_one_radius(kind, radius, load);
                let bodies = fluid.bodies;
                self.push(fluid.family, &name, contact, bodies, *speed, &lubricant);
            }
        }
    }

    fn push(
        &mut self,
        family: Family,
        name: &str,
        contact: Contact,
        bodies: Bodies,
        speed: f64,
        lubricant: &str,
    ) {
        let (kind, unit) = match contact.kind {
            LINE => ("line", "N/m"),
            _ => ("circular", "N"),
        };
        let name = format!("{kind}-{name}");
        let mut text = format!("title = \"{name}\"\n\n[contact]\n");
        let radius = contact.radius * 1e3;
        let load = contact.load;
        // Writing into a String cannot fail
        let _ = write!(
            text,
            "kind = \"{kind}\"\nradius = \"{radius} mm\"\nload = \"{load:e} {unit}\"\n\n\
             [bodies]\nbody_1 = \"{}\"\nbody_2 = \"{}\"\n\n\
             [motion]\nentrainment_speed = \"{speed:e} m/s\"\nslide_to_roll_ratio = 0.0\n\n\
             [lubricant]\n{lubricant}\n[output]\nbody_field = false\n",
            bodies.body_1, bodies.body_2
        );
        self.cases.push(MapCase {
            name,
            kind: contact.kind,
            family,
            text,
        });
    }
}

fn lubricant(density: Density, viscosity: &str) -> String {
    format!(
        "temperature = \"40 degC\"\ndensity = {}\nviscosity = {viscosity}\n",
        density.toml()
    )
}

/// Values of a list, starting at another one each turn.
fn rotated(list: &[f64], turn: usize) -> impl Iterator<Item = f64> {
    list.iter()
        .copied()
        .cycle()
        .skip(turn % list.len())
        .take(list.len())
}

/// Reduced modulus of two solids of the database, Pa.
fn reduced_modulus(bodies: Bodies) -> f64 {
    let compliance = |name: &str| {
        let solid = database::solid(name).expect("a solid of the database");
        (1.0 - solid.poissons_ratio.powi(2)) / solid.youngs_modulus
    };
    2.0 / (compliance(bodies.body_1) + compliance(bodies.body_2))
}

/// Load and Hertz pressure, Pa, for Moes' load group and 2U.
///
/// Line: w = M E'R √(2U), N/m; circular: F = M E'R² (2U)^¾, N.
fn moes_pressure(kind: ContactKind, modulus: f64, radius: f64, m: f64, two_u: f64) -> (f64, f64) {
    let load = match kind {
        LINE => m * modulus * radius * two_u.sqrt(),
        _ => m * modulus * radius * radius * two_u.powf(0.75),
    };
    let contact = Contact::of_one_radius(kind, radius, load);
    (load, Hertz::new(&contact, modulus).pressure)
}

/// Viscosity, mPa·s, and speed, m/s, with this product in Pa·m.
fn viscosity_and_speed(product: f64, turn: usize) -> (f64, f64) {
    let speed = |mu: f64| product / (1e-3 * mu);
    let fits = rotated(&VISCOSITIES, turn).find(|mu| SPEEDS.contains(&speed(*mu)));
    let nearest = if speed(3.0) < *SPEEDS.start() {
        3.0
    } else {
        400.0
    };
    let mu = fits.unwrap_or(nearest);
    (mu, speed(mu))
}
