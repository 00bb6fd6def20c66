//! A ball bearing under its loads: how its balls share them, and the contact of each with both rings.

use ertel_input::{Bounds, InputError, Table};
use ertel_machines::bearing::geometry::{BallGeometry, Play, Ring};
use ertel_machines::bearing::kinematics::{RacewayControl, Speeds};
use ertel_machines::bearing::load::{Distribution, Error, Given, Loads, Params, RingContact};
use ertel_machines::bearing::{Bearing, Geometry, Material};
use ertel_quantity::Dimension;

use super::whole::{Axis, Choice, MachineContact, WholeMachine, like};
use super::{ANGULAR_SPEED, Machine, Mechanics, Rows, Steel, required_length};
use crate::contact::Motion;
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
/// Clearances, m; negative where the balls are squeezed.
const CLEARANCE: Bounds = Bounds::closed(-1e-3, 1e-2);
/// Free contact angles, rad.
const ANGLE: Bounds = Bounds::closed(0.0, std::f64::consts::FRAC_PI_2);
/// Radius of a groove over the diameter of the ball.
const CURVATURE: Bounds = Bounds::open(0.5, f64::INFINITY);

/// A bearing, what acts on it, and how its balls share that.
#[derive(Clone, Debug)]
pub struct BearingMechanics {
    /// The bearing.
    pub bearing: Bearing,
    /// Radial and axial force on the inner ring that are in balance with the balls, N.
    pub loads: [f64; 2],
    /// Speeds of both rings.
    pub speeds: Speeds,
    /// Loads, angles and speeds of all balls.
    pub distribution: Distribution,
}

/// A ball, by its number from the load on, and a ring.
type Place = (usize, Ring);

/// Reads the keys of a bearing under its loads; `steel` is what rings and balls are made of.
pub(super) fn read(table: &mut Table<'_>, steel: &Steel) -> Result<Machine, InputError> {
    let geometry = geometry(table)?;
    geometry
        .check()
        .map_err(|error| table.error_here(error.to_string()))?;
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
    let loads = loads(table)?;
    let controls = [
        ("outer", RacewayControl::Outer),
        ("inner", RacewayControl::Inner),
    ];
    let params = Params {
        control: table
            .optional_choice("raceway_control", &controls)?
            .unwrap_or_default(),
        ..Params::default()
    };
    let bearing = Bearing {
        geometry: Geometry::Ball(geometry),
        material: Material {
            reduced_modulus: steel.reduced_modulus,
            density: steel.density.unwrap_or(0.0),
        },
    };
    let mut warnings = Vec::new();
    if steel.density.is_none() {
        warnings.push(Warning::new(
            WarningKind::Other,
            "the centrifugal force of the balls is left out: [bodies] gives no density of body_2",
        ));
    }
    let distribution = bearing
        .solve(&loads, speeds, &params)
        .map_err(|error| not_distributed(table, &error))?;
    let chosen = chosen(table, distribution.elements.len())?;
    let governing = chosen.unwrap_or_else(|| heaviest(&distribution));
    let found = at(&distribution, governing);
    let contact = found
        .ellipse()
        .ok_or_else(|| table.error("element", format!("{} carries no load", name(governing))))?;
    let motion = motion(table, found)?;
    let mut rows = Rows::default();
    tell(&mut rows, &geometry, &distribution, governing);
    let folders = table.optional_bool("folders")?.unwrap_or(false);
    let [x, y, axial] = distribution.force;
    let whole = chosen.is_none().then(|| {
        let contacts = contacts(&distribution);
        let is_it = |c: &MachineContact| c.name == name(governing);
        WholeMachine {
            title: format!(
                "ball bearing, {} balls of {} on {}",
                geometry.number,
                length(geometry.ball_diameter),
                length(geometry.pitch_diameter)
            ),
            axis: Axis::Around,
            governing: contacts.iter().position(is_it).unwrap_or(0),
            contacts,
            is_line: false,
            folders,
            mechanics: Mechanics::Bearing(Box::new(BearingMechanics {
                bearing,
                loads: [x.hypot(y), axial],
                speeds,
                distribution,
            })),
        }
    });
    Ok(Machine {
        contact,
        motion,
        load_key: "radial_load",
        body_radii: [0.5 * geometry.ball_diameter; 2],
        warnings,
        echo: rows.echo(),
        whole,
    })
}

/// The internal geometry, from dimensions.
fn geometry(table: &mut Table<'_>) -> Result<BallGeometry, InputError> {
    let curvature = |table: &mut Table<'_>, key: &str| table.required_number(key, CURVATURE);
    Ok(BallGeometry {
        ball_diameter: required_length(table, "ball_diameter")?,
        pitch_diameter: required_length(table, "pitch_diameter")?,
        number: table.required_integer("balls", 3..=1000)? as usize,
        groove: [
            curvature(table, "inner_groove_curvature")?,
            curvature(table, "outer_groove_curvature")?,
        ],
        play: play(table)?,
    })
}

/// `radial_clearance` or `contact_angle`.
fn play(table: &mut Table<'_>) -> Result<Play, InputError> {
    let angle = table.optional_quantity("contact_angle", Dimension::ANGLE, ANGLE)?;
    let clearance = table.optional_quantity("radial_clearance", Dimension::LENGTH, CLEARANCE)?;
    match (angle, clearance) {
        (Some(angle), None) => Ok(Play::FreeAngle(angle)),
        (None, Some(clearance)) => Ok(Play::Clearance(clearance)),
        (Some(_), Some(_)) => Err(table.error(
            "radial_clearance",
            "`contact_angle` and `radial_clearance` say the same thing twice; keep one of them",
        )),
        (None, None) => Err(table.missing("radial_clearance").with_help(
            "the radial internal clearance, such as \"10 um\", or `contact_angle`, the contact angle without load",
        )),
    }
}

/// What acts on the inner ring.
fn loads(table: &mut Table<'_>) -> Result<Loads, InputError> {
    let radial = table
        .optional_quantity("radial_load", Dimension::FORCE, LOAD)?
        .unwrap_or(0.0);
    let axial = table.optional_quantity("axial_load", Dimension::FORCE, LOAD)?;
    let preload = table.optional_quantity("axial_preload", Dimension::LENGTH, SHIFT)?;
    let axial = match (axial, preload) {
        (Some(_), Some(_)) => {
            return Err(table.error(
                "axial_preload",
                "`axial_load` and `axial_preload` both say how the rings are pressed together along the axis; keep one of them",
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
                "`moment` and `misalignment` both say how the inner ring tilts; keep one of them",
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

/// Says why a bearing has no load distribution.
fn not_distributed(table: &Table<'_>, error: &Error) -> InputError {
    let told = table.error_here(error.to_string());
    match error {
        Error::Unloaded => {
            told.with_help("give `radial_load`, `axial_load` or `axial_preload` other than zero")
        }
        Error::NoConvergence { .. } | Error::Element { .. } => told.with_help(
            "check loads, speeds and dimensions: such a bearing has no equilibrium that was found",
        ),
        _ => told,
    }
}

/// The single contact that the file asks for.
fn chosen(table: &mut Table<'_>, n: usize) -> Result<Option<Place>, InputError> {
    let most = i64::try_from(n).unwrap_or(i64::MAX) - 1;
    let element = table.optional_integer("element", 0..=most)?;
    let ring = table.optional_choice("ring", &[("inner", Ring::Inner), ("outer", Ring::Outer)])?;
    match (element, ring) {
        (Some(element), Some(ring)) => Ok(Some((element as usize, ring))),
        (None, None) => Ok(None),
        (Some(_), None) => Err(table.missing("ring")),
        (None, Some(_)) => Err(table.error("ring", "which ball is not said").with_help(
            "a bearing under its loads has a contact of each ball with both rings: give `element`, the number of the ball, or leave `ring` out",
        )),
    }
}

fn at(distribution: &Distribution, (element, ring): Place) -> &RingContact {
    &distribution.elements[element].contacts[ring.index()]
}

/// What a contact is called.
fn name((element, ring): Place) -> String {
    format!("ball {element}, {} ring", ring.name())
}

/// The contact under the largest pressure.
fn heaviest(distribution: &Distribution) -> Place {
    let mut best = (0, Ring::Inner);
    for element in 0..distribution.elements.len() {
        for ring in Ring::BOTH {
            // A hair more, so that of equal ones the first is taken.
            let pressure = |place| at(distribution, place).pressure;
            if pressure((element, ring)) > pressure(best) * (1.0 + 1e-9) {
                best = (element, ring);
            }
        }
    }
    best
}

/// Every ball at both rings.
fn contacts(distribution: &Distribution) -> Vec<MachineContact> {
    let places = || (0..distribution.elements.len()).flat_map(|e| Ring::BOTH.map(|r| (e, r)));
    let apart: Vec<Option<[f64; 6]>> = places()
        .map(|place| {
            let contact = at(distribution, place);
            let [along, across] = contact.radii;
            let [own, other] = contact.spin;
            (contact.load > 0.0).then_some([
                contact.load,
                along,
                across,
                contact.entrainment_speed,
                own,
                other,
            ])
        })
        .collect();
    (places().zip(like(&apart)))
        .map(|((element, ring), like)| {
            let contact = at(distribution, (element, ring));
            MachineContact {
                name: name((element, ring)),
                keys: vec![
                    ("element", Choice::Number(element as i64)),
                    ("ring", Choice::Name(ring.name())),
                ],
                place: distribution.elements[element].position,
                side: ring.index(),
                load: contact.load,
                hertz_pressure: contact.pressure,
                like,
            }
        })
        .collect()
}

/// The motion of a contact, which rolls and may spin.
fn motion(table: &Table<'_>, contact: &RingContact) -> Result<Motion, InputError> {
    let speed = contact.entrainment_speed;
    let straight = super::motion(table, "inner_ring_speed", speed, speed)?;
    Ok(Motion {
        spin: contact.spin,
        ..straight
    })
}

/// Rows of the report.
fn tell(rows: &mut Rows, geometry: &BallGeometry, found: &Distribution, governing: Place) {
    rows.text(
        "machine",
        "ball bearing: balls (body 2) on the rings (body 1)",
    );
    rows.length("ball diameter D", geometry.ball_diameter);
    rows.length("pitch diameter d_m", geometry.pitch_diameter);
    rows.number("balls Z", geometry.number as f64, "");
    let [inner, outer] = geometry.groove;
    rows.text(
        "groove radii over D",
        format!("{} inner, {} outer", digits(inner, 4), digits(outer, 4)),
    );
    rows.number("radial clearance", 1e6 * geometry.clearance(), "µm");
    rows.number(
        "contact angle without load",
        geometry.free_angle().to_degrees(),
        "deg",
    );
    let [x, y, z] = found.shift.map(|shift| digits(1e6 * shift, 4));
    rows.text(
        "shift of the inner ring",
        format!("{x}, {y} radially, {z} µm axially"),
    );
    let [rx, ry, axial] = found.force;
    rows.text(
        "force on the inner ring",
        format!(
            "{} N radially, {} N axially",
            digits(rx.hypot(ry), 5),
            digits(axial, 5)
        ),
    );
    let of = &found.elements[governing.0];
    rows.number("cage speed", of.cage_speed, "rad/s");
    rows.number("centrifugal force of a ball", of.centrifugal_force, "N");
    if of.gyroscopic_moment != 0.0 {
        rows.number("gyroscopic moment", 1e3 * of.gyroscopic_moment, "N mm");
    }
    let contact = at(found, governing);
    rows.text("governing contact", name(governing));
    rows.number("load", contact.load, "N");
    rows.text("Hertz pressure", pressure(contact.pressure));
    rows.number("contact angle", contact.angle.to_degrees(), "deg");
    rows.text(
        "source",
        "loads: ISO/TS 16281 with forces of inertia; motion: Jones 1959, Harris and Kotzalas 2007",
    );
}
