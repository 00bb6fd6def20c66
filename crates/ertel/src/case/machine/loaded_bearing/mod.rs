//! A bearing under its loads: how its elements share them, and the contact of each with both rings.

mod geometry;
mod life;
mod refusal;
mod rollers;

use std::fmt::Write;

use ertel_input::{Bounds, InputError, Table};
use ertel_machines::bearing::catalogue::{Entry, Series};
use ertel_machines::bearing::geometry::Ring;
use ertel_machines::bearing::kinematics::{
    RacewayControl, Speeds, recommended_speed_factor, speed_factor,
};
use ertel_machines::bearing::load::{Distribution, Given, Loads, Params, RingContact};
use ertel_machines::bearing::{Bearing, Geometry, Material, life as ratings};
use ertel_quantity::Dimension;

pub(super) use geometry::Elements;
use geometry::Inside;
pub use geometry::RatingBasis;
pub use life::{Contamination, LifeInputs};
use refusal::{check_axial_load, not_distributed};

use super::whole::{Axis, Choice, MachineContact, WholeMachine, like};
use super::{ANGULAR_SPEED, Machine, Mechanics, Rows, Steel};
use crate::contact::roller::{Profile, Roller};
use crate::contact::{Contact, Motion};
use crate::warning::{Warning, WarningKind};
use crate::words::{digits, length, pressure};

/// Keys of loads: with one of them the file describes a bearing, else a single contact.
pub(super) const LOADS: [&str; 3] = ["radial_load", "axial_load", "axial_preload"];

/// Forces on a bearing, N, and moments, N m.
const LOAD: Bounds = Bounds::closed(-1e9, 1e9);
/// Tilts of rings, rad.
const TILT: Bounds = Bounds::closed(-0.1, 0.1);
/// Axial shifts, m.
const SHIFT: Bounds = Bounds::closed(0.0, 1e-2);

/// A bearing, its loads, and how its elements share them.
#[derive(Clone, Debug)]
pub struct BearingMechanics {
    /// The bearing.
    pub bearing: Bearing,
    /// Its catalogue entry, if it has a designation.
    pub entry: Option<Entry>,
    /// Radial and axial force on the inner ring that are in balance with the elements, N.
    pub loads: [f64; 2],
    /// Speeds of both rings.
    pub speeds: Speeds,
    /// Loads, angles and speeds of all elements.
    pub distribution: Distribution,
    /// Ratings, cleanliness, cooling.
    pub life: LifeInputs,
    /// Where load ratings come from that the file does not give.
    pub ratings: RatingBasis,
    /// How its contacts are solved.
    pub contacts: ContactKind,
}

impl BearingMechanics {
    /// Its series, if it has a designation.
    pub fn series(&self) -> Option<Series> {
        self.entry.as_ref().map(|entry| entry.designation.series)
    }

    /// δ_x, δ_y, δ_z of the inner ring (m), θ_x, θ_y (rad); δ_z of balls between shoulders on both sides from the middle of the play, else from where the elements touch.
    pub fn displacement(&self) -> [f64; 5] {
        let found = &self.distribution;
        let ([x, y, _], [a, b]) = (found.shift, found.tilt);
        let (z, _) = axial_shift(&self.bearing.geometry, self.series(), found);
        [x, y, z, a, b]
    }
}

/// δ_z of the inner ring, m, and where it is counted from: of balls between shoulders on both sides the middle of the play, else where the elements touch.
fn axial_shift(
    geometry: &Geometry,
    series: Option<Series>,
    found: &Distribution,
) -> (f64, &'static str) {
    let [_, _, z] = found.shift;
    match geometry {
        Geometry::Ball(ball) if !ratings::is_one_sided(geometry, series) => {
            (z + 0.5 * ball.axial_play(), " from the middle of the play")
        }
        _ => (z, ""),
    }
}

/// How contacts of a bearing are solved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ContactKind {
    /// Ellipses of balls.
    Ellipses,
    /// Rollers as lines under their mean load per length.
    Lines,
    /// Rollers over their whole length, with relief and tilt.
    FiniteRollers,
}

/// Share of the largest force on a ring below which a force is rounding: the balance holds to 1e-9 of it.
const ROUNDING: f64 = 1e-8;

/// An element, by its number from the load on, and a ring.
type Place = (usize, Ring);

/// Reads the keys of a bearing under its loads; `steel` is the material of rings and elements.
pub(super) fn read(
    table: &mut Table<'_>,
    elements: Elements,
    steel: &Steel,
) -> Result<Machine, InputError> {
    let elements = match elements {
        Elements::Balls => Elements::Balls,
        Elements::Rollers | Elements::TaperedRollers => Elements::of_rollers(table)?,
    };
    let inside = geometry::read(table, elements)?;
    let kind = contact_kind(table, elements, &inside.geometry)?;
    let speeds = Speeds {
        inner: table.required_quantity(
            "inner_ring_speed",
            Dimension::ANGULAR_SPEED,
            ANGULAR_SPEED,
        )?,
        outer: table
            .optional_quantity("outer_ring_speed", Dimension::ANGULAR_SPEED, ANGULAR_SPEED)?
            .unwrap_or(0.0),
    };
    let loads = loads(table, elements)?;
    check_axial_load(table, &inside, &loads)?;
    let params = params(table, elements)?;
    let bearing = Bearing {
        geometry: inside.geometry,
        material: Material {
            reduced_modulus: steel.reduced_modulus,
            density: steel.density.unwrap_or(0.0),
        },
    };
    let warnings = input_warnings(&bearing, &inside, speeds, steel.density.is_some());
    let distribution = bearing
        .solve(&loads, speeds, &params)
        .map_err(|error| not_distributed(table, &error, &inside, &loads, (&bearing, speeds)))?;
    let word = elements.word();
    let chosen = chosen(table, distribution.elements.len(), word)?;
    let governing = chosen.unwrap_or_else(|| heaviest(&distribution));
    let found = at(&distribution, governing);
    let contact = contact(&inside.geometry, kind, found).ok_or_else(|| {
        table.error(
            "element",
            format!("{} carries no load", name(governing, word)),
        )
    })?;
    let motion = motion(table, kind, found)?;
    let life = life::read(table)?;
    let folders = table.optional_bool("folders")?.unwrap_or(false);
    let mut rows = Rows::default();
    rows.text(
        "machine",
        format!("bearing: {word}s (body 2) on the rings (body 1)"),
    );
    rows.0.extend(inside.rows.clone());
    add_rows(&mut rows, &inside, &distribution, (governing, word));
    let whole = chosen.is_none().then(|| {
        let contacts = contacts(&inside.geometry, kind, &distribution, word);
        let is_it = |c: &MachineContact| c.name == name(governing, word);
        let [x, y, axial] = distribution.force;
        WholeMachine {
            title: title(&inside, word),
            axis: Axis::Around,
            governing: contacts.iter().position(is_it).unwrap_or(0),
            contacts,
            is_line: kind == ContactKind::Lines,
            folders,
            mechanics: Mechanics::Bearing(Box::new(BearingMechanics {
                bearing,
                entry: inside.entry.clone(),
                loads: [x.hypot(y), axial],
                speeds,
                distribution: distribution.clone(),
                life,
                ratings: inside.ratings,
                contacts: kind,
            })),
        }
    });
    let across = match elements {
        Elements::Balls => 0.5 * inside.geometry.element_diameter(),
        Elements::Rollers | Elements::TaperedRollers => f64::INFINITY,
    };
    Ok(Machine {
        body_radii: [0.5 * inside.geometry.element_diameter(), across],
        warnings,
        whole,
        ..Machine::of_contact(contact, motion, "radial_load", rows)
    })
}

fn title(inside: &Inside, word: &str) -> String {
    let named = inside.entry.as_ref().map(|e| e.designation.name());
    format!(
        "{}bearing with {} {word}s of {}",
        named.map_or(String::new(), |name| format!("{name}, ")),
        inside.geometry.number(),
        length(inside.geometry.element_diameter()),
    )
}

/// Warnings about inertia, designation and speed.
fn input_warnings(
    bearing: &Bearing,
    inside: &Inside,
    speeds: Speeds,
    has_density: bool,
) -> Vec<Warning> {
    let mut warnings = Vec::new();
    if !has_density {
        warnings.push(Warning::new(
            WarningKind::MissingData,
            "the centrifugal force of the elements is neglected: [bodies] gives no density of body_2",
        ));
    }
    let left_out = (inside.entry.iter()).flat_map(|entry| &entry.designation.left_out);
    warnings.extend(left_out.map(|what| {
        let text = format!("the designation names {what}");
        Warning::new(WarningKind::DesignationSuffix, text)
    }));
    warnings.extend(too_fast(&bearing.geometry, speeds));
    warnings
}

/// Warns of a speed above that which makers recommend.
fn too_fast(geometry: &Geometry, speeds: Speeds) -> Option<Warning> {
    let [factor, most] = [
        speed_factor(speeds, geometry.pitch_diameter()),
        recommended_speed_factor(geometry),
    ];
    (factor > most).then(|| {
        Warning::new(
            WarningKind::BearingSpeed,
            format!(
                "the speed factor n d_m is {factor:.2e} mm/min, beyond {most:.1e} mm/min, up to which makers recommend such bearings with standard cages (SKF, General \
                 catalogue, 2006, in grease under light loads; limits in oil are about a fifth higher): ask the maker for the limiting speed"
            ),
        )
    })
}

/// How contacts are solved.
fn contact_kind(
    table: &mut Table<'_>,
    elements: Elements,
    geometry: &Geometry,
) -> Result<ContactKind, InputError> {
    if elements == Elements::Balls {
        return Ok(ContactKind::Ellipses);
    }
    let kinds = [
        ("lines", ContactKind::Lines),
        ("finite", ContactKind::FiniteRollers),
    ];
    let kind = table.optional_choice("roller_contacts", &kinds)?;
    let kind = kind.unwrap_or(ContactKind::Lines);
    match kind == ContactKind::FiniteRollers && relief(geometry).is_none() {
        true => Err(table
            .error(
                "roller_contacts",
                "rollers without relief have sharp ends, where the elastic pressure is unbounded",
            )
            .with_help("give `roller_profile = \"logarithmic\"`, or solve them as \"lines\"")),
        false => Ok(kind),
    }
}

/// Length of rollers, m, and their relief; `None` of balls and of rollers without relief.
fn relief(geometry: &Geometry) -> Option<(f64, Profile)> {
    match geometry {
        Geometry::Ball(_) => None,
        Geometry::CylindricalRoller(roller) => Some((roller.length, roller.relief()?)),
        Geometry::TaperedRoller(roller) => Some((roller.length, roller.relief()?)),
    }
}

/// Which raceway controls balls; rollers have none.
fn params(table: &mut Table<'_>, elements: Elements) -> Result<Params, InputError> {
    let controls = [
        ("outer", RacewayControl::Outer),
        ("inner", RacewayControl::Inner),
    ];
    let control = match elements {
        Elements::Balls => table.optional_choice("raceway_control", &controls)?,
        Elements::Rollers | Elements::TaperedRollers => None,
    };
    Ok(Params {
        control: control.unwrap_or_default(),
        ..Params::default()
    })
}

/// Loads on the inner ring.
fn loads(table: &mut Table<'_>, elements: Elements) -> Result<Loads, InputError> {
    let radial = table
        .optional_quantity("radial_load", Dimension::FORCE, LOAD)?
        .unwrap_or(0.0);
    if elements == Elements::Rollers {
        let key = ["axial_load", "axial_preload"]
            .into_iter()
            .find(|key| table.contains(key));
        if let Some(key) = key {
            return Err(table.error(
                key,
                "cylindrical rollers carry no axial load here: ribs are not part of the model",
            ));
        }
    }
    let axial = table.optional_quantity("axial_load", Dimension::FORCE, LOAD)?;
    let preload = table.optional_quantity("axial_preload", Dimension::LENGTH, SHIFT)?;
    let axial = match (axial, preload) {
        (Some(_), Some(_)) => {
            return Err(table.error(
                "axial_preload",
                "`axial_load` and `axial_preload` both define the axial load of the rings; keep one of them",
            ));
        }
        (None, Some(shift)) => Given::Shift(shift),
        (axial, None) => Given::Load(axial.unwrap_or(0.0)),
    };
    let tilt = table.optional_quantity("misalignment", Dimension::ANGLE, TILT)?;
    let moment = table.optional_quantity("moment", Dimension::ENERGY, LOAD)?;
    let about_y = match (tilt, moment) {
        (Some(_), Some(_)) => {
            return Err(table.error(
                "misalignment",
                "`moment` and `misalignment` both define the tilt of the inner ring; keep one of them",
            ));
        }
        (_, Some(moment)) => Given::Load(moment),
        (tilt, None) => Given::Shift(tilt.unwrap_or(0.0)),
    };
    Ok(Loads {
        axial,
        tilt: [Given::Shift(0.0), about_y],
        ..Loads::forces(radial, 0.0)
    })
}

/// The single contact that the file selects.
fn chosen(table: &mut Table<'_>, n: usize, word: &str) -> Result<Option<Place>, InputError> {
    let most = i64::try_from(n).unwrap_or(i64::MAX) - 1;
    let element = table.optional_integer("element", 0..=most)?;
    let ring = table.optional_choice("ring", &[("inner", Ring::Inner), ("outer", Ring::Outer)])?;
    match (element, ring) {
        (Some(element), Some(ring)) => Ok(Some((element as usize, ring))),
        (None, None) => Ok(None),
        (Some(_), None) => Err(table.missing("ring")),
        (None, Some(_)) => Err(table.error("ring", format!("`element`, the number of the {word}, is missing")).with_help(
            "a bearing under its loads has a contact of each element with both rings: give `element`, its number, or remove `ring`",
        )),
    }
}

fn at(distribution: &Distribution, (element, ring): Place) -> &RingContact {
    &distribution.elements[element].contacts[ring.index()]
}

/// Name of a contact.
fn name((element, ring): Place, word: &str) -> String {
    format!("{word} {element}, {} ring", ring.name())
}

/// The contact for a solver: an ellipse of a ball; of a roller the line under its mean load per length, or the whole roller with its tilt. `None` where
/// nothing presses.
fn contact(geometry: &Geometry, kind: ContactKind, found: &RingContact) -> Option<Contact> {
    if found.load <= 0.0 {
        return None;
    }
    let radius = found.radii[0];
    let contact = match kind {
        ContactKind::Ellipses => return found.ellipse(),
        ContactKind::Lines => Contact::line(radius, 0.5 * found.load / found.semi_axes[1]),
        ContactKind::FiniteRollers => {
            let (length, profile) = relief(geometry)?;
            let roller = Roller {
                length,
                profile,
                // Angles below a picoradian are rounding, and would make equal rollers differ.
                misalignment: if found.tilt.abs() < 1e-12 {
                    0.0
                } else {
                    found.tilt
                },
            };
            Contact::of_roller(radius, found.load, roller)
        }
    };
    Some(contact.between(found.curvatures))
}

/// The contact under the largest pressure.
fn heaviest(distribution: &Distribution) -> Place {
    let mut best = (0, Ring::Inner);
    for element in 0..distribution.elements.len() {
        for ring in Ring::BOTH {
            // Slightly more, to select the first of equal ones.
            let pressure = |place| at(distribution, place).pressure;
            if pressure((element, ring)) > pressure(best) * (1.0 + 1e-9) {
                best = (element, ring);
            }
        }
    }
    best
}

/// Every element at both rings. An element that the inner ring does not touch is pressed by its inertia alone: such contacts are listed, not solved.
fn contacts(
    geometry: &Geometry,
    kind: ContactKind,
    distribution: &Distribution,
    word: &str,
) -> Vec<MachineContact> {
    let places = || (0..distribution.elements.len()).flat_map(|e| Ring::BOTH.map(|r| (e, r)));
    let apart: Vec<Option<[f64; 7]>> = places()
        .map(|place| {
            let found = at(distribution, place);
            let is_held = at(distribution, (place.0, Ring::Inner)).load > 0.0;
            let solved = contact(geometry, kind, found).filter(|_| is_held)?;
            let [own, other] = found.spin;
            Some([
                solved.load,
                solved.radius,
                if solved.radius_y.is_finite() {
                    solved.radius_y
                } else {
                    0.0
                },
                found.entrainment_speed,
                own,
                other,
                (solved.roller.as_ref()).map_or(0.0, |roller| roller.misalignment),
            ])
        })
        .collect();
    (places().zip(like(&apart)))
        .map(|((element, ring), like)| {
            let found = at(distribution, (element, ring));
            MachineContact {
                name: name((element, ring), word),
                keys: vec![
                    ("element", Choice::Number(element as i64)),
                    ("ring", Choice::Name(ring.name())),
                ],
                place: distribution.elements[element].position,
                side: ring.index(),
                load: contact(geometry, kind, found).map_or(0.0, |contact| contact.load),
                hertz_pressure: found.pressure,
                like,
            }
        })
        .collect()
}

/// The motion of a contact, which rolls; balls may spin. Tapered rollers spin with their raceways, so that nothing slides: along the contact their
/// speed is that of its middle.
fn motion(
    table: &Table<'_>,
    kind: ContactKind,
    contact: &RingContact,
) -> Result<Motion, InputError> {
    let speed = contact.entrainment_speed;
    let straight = super::motion(table, "inner_ring_speed", speed, speed)?;
    Ok(match kind {
        ContactKind::Ellipses => Motion {
            spin: contact.spin,
            ..straight
        },
        ContactKind::Lines | ContactKind::FiniteRollers => straight,
    })
}

/// Rows of the report: how the elements share the load.
fn add_rows(
    rows: &mut Rows,
    inside: &Inside,
    found: &Distribution,
    (governing, word): (Place, &str),
) {
    let [x, y, _] = found.shift;
    let (z, from) = axial_shift(&inside.geometry, inside.series(), found);
    // Shifts below a picometre are rounding.
    let [x, y, z] =
        [x, y, z].map(|shift| digits(1e6 * if shift.abs() < 1e-12 { 0.0 } else { shift }, 4));
    rows.text(
        "shift of the inner ring",
        format!("{x} and {y} µm radially, {z} µm axially{from}"),
    );
    let [rx, ry, axial] = found.force;
    let largest = rx.hypot(ry).max(axial.abs());
    let [radial, axial] = [rx.hypot(ry), axial].map(|force| {
        digits(
            if force.abs() < ROUNDING * largest {
                0.0
            } else {
                force
            },
            5,
        )
    });
    rows.text(
        "force on the inner ring",
        format!("{radial} N radially, {axial} N axially"),
    );
    let loads: Vec<f64> = (found.elements.iter())
        .map(|element| element.contacts[0].load)
        .collect();
    let above = |least: f64| loads.iter().filter(|load| **load > least).count();
    let loaded = above(0.0);
    let mut text = format!("{loaded} of {}", loads.len());
    // Centrifugal force wedges balls between offset grooves: they are pressed without a part of the load.
    let heavy = above(0.1 * loads.iter().fold(0.0, |most: f64, load| most.max(*load)));
    if heavy < loaded {
        let _ = write!(text, ", {heavy} with more than a tenth of the largest load");
    }
    rows.text("loaded elements", text);
    add_contact_rows(rows, found, (governing, word));
    let ribs = found.elements.iter().map(|e| e.rib_load);
    let rib = ribs.fold(0.0, f64::max);
    if rib > 0.0 {
        rows.number("largest load of a roller on the rib", rib, "N");
    }
    rows.text(
        "source",
        "loads: ISO/TS 16281 with forces of inertia; motion: Jones 1959, Harris and Kotzalas 2007",
    );
}

/// Rows of the report: an element and its contact.
fn add_contact_rows(rows: &mut Rows, found: &Distribution, (governing, word): (Place, &str)) {
    let of = &found.elements[governing.0];
    rows.number("cage speed", of.cage_speed, "rad/s");
    rows.number("centrifugal force of an element", of.centrifugal_force, "N");
    if of.gyroscopic_moment != 0.0 {
        rows.number("gyroscopic moment", 1e3 * of.gyroscopic_moment, "N mm");
    }
    let contact = at(found, governing);
    rows.text("most loaded contact", name(governing, word));
    rows.number("  its load", contact.load, "N");
    let hertz = match contact.peak_slice() {
        Some(_) => "  its Hertz pressure, of the heaviest slice",
        None => "  its Hertz pressure",
    };
    rows.text(hertz, pressure(contact.pressure));
    rows.number("  its contact angle", contact.angle.to_degrees(), "deg");
    if let Some(share) = contact.peak_slice() {
        rows.number(
            "  load per length of its heaviest slice, over the mean",
            share,
            "",
        );
    }
}
