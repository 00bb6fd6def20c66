//! A cam and its follower: the contact at one angle, or all over a turn.

mod doubts;
mod lift;

use std::f64::consts::TAU;
use std::path::Path;

use ertel_input::{Bounds, InputError, Table};
use ertel_machines::cam::{Cam, CamBars, CamError, CamOperation, CamPoint, Follower};
use ertel_quantity::Dimension;

use super::whole::{Axis, Choice, MachineContact, WholeMachine, like};
use super::{ANGULAR_SPEED, Machine, Mechanics, Rows, required_length};
use crate::case::check::HERTZ_PRESSURE;
use crate::case::contact::RADIUS;
use crate::warning::{Warning, WarningKind};
use crate::words::{digits, force, length, pressure};

/// Angles of the cam, rad.
const ANGLE: Bounds = Bounds::closed(-100.0, 100.0);
/// Distances of paths and pivots from the axis of the cam, m.
const OFFSET: Bounds = Bounds::closed(-1e3, 1e3);
/// Slip of rollers.
const SLIP: Bounds = Bounds::closed(-1.0, 1.0);
/// Forces, N.
const FORCE: Bounds = Bounds::closed(-1e9, 1e9);
/// Spring rates, N/m.
const RATE: Bounds = Bounds::closed(0.0, 1e12);
/// Masses, kg.
const MASS: Bounds = Bounds::closed(0.0, 1e6);
/// Points of a turn.
const POINTS: std::ops::RangeInclusive<i64> = 3..=3600;
const USUAL_POINTS: i64 = 90;
/// Entrainment speed over the largest of the turn below which no film is solved: near its reversal squeeze sustains the film,
/// which a steady solution does not include.
const SLOWEST: f64 = 0.02;

/// A cam, how it runs, and its contacts.
#[derive(Clone, Debug)]
pub struct CamMechanics {
    /// The cam and its follower.
    pub cam: Cam,
    /// Speed and forces.
    pub operation: CamOperation,
    /// The contacts, in the order of those of the machine.
    pub points: Vec<CamPoint>,
    /// Angles at which the entrainment reverses, rad.
    pub reversals: Vec<f64>,
}

/// Kinds of followers.
#[derive(Clone, Copy)]
enum Kind {
    Flat,
    Roller,
    Curved,
    Finger,
}

const KINDS: [(&str, Kind); 4] = [
    ("flat", Kind::Flat),
    ("roller", Kind::Roller),
    ("curved", Kind::Curved),
    ("finger", Kind::Finger),
];

/// Reads the keys of `kind = "cam"`; `reduced_modulus` in Pa, a table of lifts lies in `folder`.
///
/// Places, motions and forces are those of [`ertel_machines::cam`].
pub(super) fn read(
    table: &mut Table<'_>,
    reduced_modulus: f64,
    folder: &Path,
) -> Result<Machine, InputError> {
    let base_radius = required_length(table, "base_radius")?;
    let (law, law_words) = lift::read(table, folder)?;
    let (follower, follower_words) = follower(table)?;
    let speed = table.required_quantity("cam_speed", Dimension::ANGULAR_SPEED, ANGULAR_SPEED)?;
    if speed == 0.0 {
        return Err(table.error("cam_speed", "the entrainment speed must not be zero"));
    }
    let width = required_length(table, "width")?;
    let (operation, load_key) = operation(table, (speed, width), reduced_modulus)?;
    let points = table
        .optional_integer("points", POINTS)?
        .unwrap_or(USUAL_POINTS);
    let points = usize::try_from(points).unwrap_or_default();
    let folders = table.optional_bool("folders")?.unwrap_or(false);
    let angle = angle(table)?;
    let is_straight = !matches!(follower, Follower::Finger { .. });
    let cam = Cam::new(law, follower, base_radius).map_err(|error| refused(table, &error))?;
    let text = CamText {
        base_radius,
        law: &law_words,
        follower: &follower_words,
        speed,
        width,
    };
    if let Some(angle) = angle {
        let point = cam
            .at(&operation, angle)
            .map_err(|error| refused(table, &error))?;
        check_undercut(table, &[point])?;
        let bars = cam.bars(&operation, angle);
        let warnings = doubts::warnings(&cam, &operation, &[point], is_straight);
        let machine = single(table, &text, (&point, &bars), load_key, None, Vec::new())?;
        return Ok(Machine {
            warnings,
            ..machine
        });
    }
    let turn = cam
        .turn(&operation, points)
        .map_err(|error| refused(table, &error))?;
    check_undercut(table, &turn)?;
    let reversals = cam
        .reversals(&operation, points.max(360))
        .map_err(|error| refused(table, &error))?;
    let mechanics = CamMechanics {
        cam,
        operation,
        points: turn,
        reversals,
    };
    over_turn(table, &text, (load_key, folders), mechanics, is_straight)
}

/// The angle of the one contact, rad; `None` for all over a turn.
fn angle(table: &mut Table<'_>) -> Result<Option<f64>, InputError> {
    if table.required_str("angle")? == "turn" {
        return Ok(None);
    }
    let angle = table.required_quantity("angle", Dimension::ANGLE, ANGLE);
    angle.map(Some).map_err(|error| {
        error.with_help("`angle` is that of one contact, or \"turn\" for all over a turn")
    })
}

/// All contacts over a turn.
fn over_turn(
    table: &Table<'_>,
    text: &CamText<'_>,
    (load_key, folders): (&'static str, bool),
    mechanics: CamMechanics,
    is_straight: bool,
) -> Result<Machine, InputError> {
    let CamMechanics {
        cam,
        operation,
        points: turn,
        reversals,
    } = &mechanics;
    let contacts = contacts(turn);
    let Some(governing) = heaviest(&contacts) else {
        return Err(table.error(
            load_key,
            "no contact of the turn can be solved: the follower leaves the cam everywhere, or pressures are out of range",
        ));
    };
    let reversal_rows = doubts::reversals(cam, operation, reversals);
    let (mut of_turn, mut warnings) = unsolved(turn, &contacts, reversal_rows);
    of_turn.push(doubts::steepest(turn));
    warnings.extend(doubts::warnings(cam, operation, turn, is_straight));
    let title = format!(
        "cam on {}, base radius {}",
        text.follower,
        length(text.base_radius)
    );
    let point = turn[governing];
    let bars = cam.bars(operation, point.angle);
    let whole = WholeMachine {
        title,
        mechanics: Mechanics::Cam(Box::new(mechanics)),
        contacts,
        axis: Axis::CamAngle,
        governing,
        is_line: true,
        folders,
    };
    let of_point = (&point, &bars);
    let machine = single(table, text, of_point, load_key, Some(whole), of_turn)?;
    Ok(Machine {
        warnings,
        ..machine
    })
}

/// The follower, and its description.
fn follower(table: &mut Table<'_>) -> Result<(Follower, String), InputError> {
    let kind = table.required_choice("follower", &KINDS)?;
    let radius = table.optional_quantity("follower_radius", Dimension::LENGTH, RADIUS)?;
    let offset = table.optional_quantity("follower_offset", Dimension::LENGTH, OFFSET)?;
    let slip = table.optional_number("roller_slip", SLIP)?;
    let arm = table.optional_quantity("arm_length", Dimension::LENGTH, RADIUS)?;
    let pivot = [
        table.optional_quantity("pivot_x", Dimension::LENGTH, OFFSET)?,
        table.optional_quantity("pivot_y", Dimension::LENGTH, OFFSET)?,
    ];
    let (is_round, slides, is_finger) = match kind {
        Kind::Flat => (false, false, false),
        Kind::Roller | Kind::Curved => (true, true, false),
        Kind::Finger => (true, false, true),
    };
    let turns = matches!(kind, Kind::Roller | Kind::Finger);
    for (key, is_given, may_be) in [
        ("follower_radius", radius.is_some(), is_round),
        ("follower_offset", offset.is_some(), slides),
        ("roller_slip", slip.is_some(), turns),
        ("arm_length", arm.is_some(), is_finger),
        ("pivot_x", pivot[0].is_some(), is_finger),
        ("pivot_y", pivot[1].is_some(), is_finger),
    ] {
        if is_given && !may_be {
            return Err(table.error(key, "a follower of this kind has no such key"));
        }
    }
    let need = |key: &str, value: Option<f64>| value.ok_or_else(|| table.missing(key));
    let of_radius = |radius: f64, what: &str| format!("{what} of the radius {}", length(radius));
    Ok(match kind {
        Kind::Flat => (Follower::Flat, "flat follower".to_owned()),
        Kind::Roller => {
            let radius = need("follower_radius", radius)?;
            let follower = Follower::Roller {
                radius,
                offset: offset.unwrap_or(0.0),
                slip: slip.unwrap_or(0.0),
            };
            (follower, of_radius(radius, "roller"))
        }
        Kind::Curved => {
            let radius = need("follower_radius", radius)?;
            let follower = Follower::Curved {
                radius,
                offset: offset.unwrap_or(0.0),
            };
            (follower, of_radius(radius, "curved follower"))
        }
        Kind::Finger => {
            let radius = need("follower_radius", radius)?;
            let follower = Follower::Finger {
                pivot: [need("pivot_x", pivot[0])?, need("pivot_y", pivot[1])?],
                arm: need("arm_length", arm)?,
                radius,
                roller_slip: slip,
            };
            let what = match slip {
                Some(_) => "finger with a roller",
                None => "finger with a face",
            };
            (follower, of_radius(radius, what))
        }
    })
}

/// Speed (rad/s), width (m) and forces; and the key that the load comes from.
fn operation(
    table: &mut Table<'_>,
    (speed, width): (f64, f64),
    reduced_modulus: f64,
) -> Result<(CamOperation, &'static str), InputError> {
    let load = table.optional_quantity("load", Dimension::FORCE, Bounds::POSITIVE)?;
    let rate_dimension = Dimension::FORCE_PER_LENGTH;
    let spring_rate = table.optional_quantity("spring_rate", rate_dimension, RATE)?;
    let preload = table.optional_quantity("preload", Dimension::FORCE, FORCE)?;
    let mass = table.optional_quantity("moving_mass", Dimension::MASS, MASS)?;
    let extra = table.optional_quantity("extra_force", Dimension::FORCE, FORCE)?;
    let own = [
        ("spring_rate", spring_rate),
        ("preload", preload),
        ("moving_mass", mass),
        ("extra_force", extra),
    ];
    if let (Some(_), Some((key, _))) = (load, own.iter().find(|(_, value)| value.is_some())) {
        return Err(table.error(
            key,
            "`load` is the force at all angles; give it alone, or the spring, masses and other forces without it",
        ));
    }
    if load.is_none() && preload.is_none() && extra.is_none() {
        return Err(table.missing("preload").with_help(
            "the force of the spring at no lift, with `spring_rate`, `moving_mass` and `extra_force`; or `load`, a force at all angles",
        ));
    }
    let operation = CamOperation {
        speed,
        width,
        mass: mass.unwrap_or(0.0),
        spring_rate: spring_rate.unwrap_or(0.0),
        preload: load.or(preload).unwrap_or(0.0),
        extra_force: extra.unwrap_or(0.0),
        reduced_modulus,
    };
    Ok((operation, if load.is_some() { "load" } else { "preload" }))
}

/// Says why a cam is refused.
fn refused(table: &Table<'_>, error: &CamError) -> InputError {
    table.error_here(error.to_string())
}

/// Refuses cams that the follower would cut away.
fn check_undercut(table: &Table<'_>, points: &[CamPoint]) -> Result<(), InputError> {
    let cut = ranges(points, |point| point.undercut);
    if cut.is_empty() {
        return Ok(());
    }
    Err(table
        .error(
            "base_radius",
            format!("the cam is undercut: its follower cannot follow this lift, at {cut}"),
        )
        .with_help("give a larger base radius, a smaller follower or a smoother lift"))
}

/// Description of a cam in the report.
struct CamText<'a> {
    base_radius: f64,
    law: &'a str,
    follower: &'a str,
    speed: f64,
    width: f64,
}

/// The machine of one contact, which may represent `whole`.
fn single(
    table: &Table<'_>,
    text: &CamText<'_>,
    (point, bars): (&CamPoint, &CamBars),
    load_key: &'static str,
    whole: Option<WholeMachine>,
    of_turn: Vec<(&str, String)>,
) -> Result<Machine, InputError> {
    let Some(contact) = point.line_contact() else {
        return Err(table
            .error("angle", "the follower leaves the cam at this angle")
            .with_help(format!(
                "spring, masses and other forces press with {} N here",
                digits(point.force, 4)
            )));
    };
    super::check_radii(table, &contact)?;
    // x points along the entrainment, which may run against the turning of the cam.
    let sign = match point.entrainment_speed < 0.0 {
        true => -1.0,
        false => 1.0,
    };
    let motion = super::motion(table, "cam_speed", sign * point.u_2, sign * point.u_1)?;
    let mut rows = Rows::default();
    rows.text(
        "machine",
        format!("cam (body 2) on {} (body 1)", text.follower),
    );
    rows.length("base radius r_b", text.base_radius);
    rows.text("lift s(θ)", text.law);
    rows.number("cam speed ω", text.speed, "rad/s");
    if let Some(whole) = &whole {
        let name = whole.contacts[whole.governing].name.clone();
        rows.text("most loaded contact", name);
    }
    for (name, text) in of_turn {
        rows.text(name, text);
    }
    rows.number("angle θ", point.angle.to_degrees(), "deg");
    rows.number("lift s", 1e3 * point.lift, "mm");
    let acceleration = format!("{} mm", digits(1e3 * point.lift_acceleration, 6));
    let with_bar = [point.lift_acceleration, bars.lift_acceleration];
    rows.text("s''", doubts::with_bar(acceleration, with_bar, 1e3, "mm"));
    let with_bar = [contact.radius, bars.reduced_radius];
    let radius = length(contact.radius);
    rows.text(
        "reduced radius R",
        doubts::with_bar(radius, with_bar, 1e3, "mm"),
    );
    rows.number("force along the follower's motion", point.force, "N");
    rows.number("pressure angle", point.pressure_angle.to_degrees(), "deg");
    rows.length("width b", text.width);
    rows.text("load per length w", force(contact.load, true, 6));
    let with_bar = [point.hertz_pressure, bars.hertz_pressure];
    let highest = pressure(point.hertz_pressure);
    rows.text(
        "Hertz pressure",
        doubts::with_bar(highest, with_bar, 1e-6, "MPa"),
    );
    rows.number("u of the cam", point.u_2, "m/s");
    rows.number("u of the follower", point.u_1, "m/s");
    rows.number("u_m", point.entrainment_speed, "m/s");
    rows.text("source", "Norton 2002, chapters 2, 3 and 7; Müller 1966");
    Ok(Machine {
        body_radii: [smallest_radius(point), f64::INFINITY],
        whole,
        ..Machine::of_contact(contact, motion, load_key, rows)
    })
}

/// Smallest radius of a body (m) where the cam is concave; else the reduced radius is smaller.
fn smallest_radius(point: &CamPoint) -> f64 {
    match point.concave {
        true => point.radius_body_1.min(point.radius_body_2.abs()),
        false => f64::INFINITY,
    }
}

/// Contacts of the turn.
fn contacts(turn: &[CamPoint]) -> Vec<MachineContact> {
    let sizes = turn.iter().map(|point| point.entrainment_speed.abs());
    let fastest = sizes.fold(0.0, f64::max);
    let apart: Vec<Option<[f64; 4]>> = (turn.iter())
        .map(|point| {
            let is_fast = point.entrainment_speed.abs() >= SLOWEST * fastest && fastest > 0.0;
            (is_fast && is_contact(point)).then_some([
                point.load_per_length,
                point.reduced_radius,
                // Not u_1, which may vanish but for rounding.
                point.entrainment_speed,
                point.u_2,
            ])
        })
        .collect();
    (turn.iter().zip(like(&apart)))
        .map(|(point, like)| MachineContact {
            name: format!("{} deg", digits(point.angle.to_degrees(), 5)),
            keys: vec![("angle", Choice::Quantity(point.angle, Dimension::ANGLE))],
            place: point.angle,
            side: 0,
            load: point.load_per_length,
            hertz_pressure: point.hertz_pressure,
            like,
        })
        .collect()
}

/// Whether a point is a contact that Hertz theory covers.
pub(super) fn is_contact(point: &CamPoint) -> bool {
    !point.contact_lost
        && RADIUS.contains(point.reduced_radius)
        && HERTZ_PRESSURE.contains(point.hertz_pressure)
        && point.half_width < point.reduced_radius
        && point.half_width < smallest_radius(point)
}

/// The contact under the largest pressure.
fn heaviest(contacts: &[MachineContact]) -> Option<usize> {
    let solved = (0..contacts.len()).filter(|i| contacts[*i].like == Some(*i));
    solved.max_by(|a, b| {
        let pressure = |i: usize| contacts[i].hertz_pressure;
        pressure(*a).total_cmp(&pressure(*b))
    })
}

/// Says where the entrainment reverses, in rows of the report, and where nothing is solved, and why.
fn unsolved(
    turn: &[CamPoint],
    contacts: &[MachineContact],
    reversals: Option<String>,
) -> (Vec<(&'static str, String)>, Vec<Warning>) {
    let is_unsolved = |point: &CamPoint| {
        let found = turn.iter().position(|other| other.angle == point.angle);
        found.is_some_and(|i| contacts[i].like.is_none())
    };
    let mut rows = Vec::new();
    rows.extend(reversals.map(|at| ("entrainment reverses", at)));
    let slow = ranges(turn, |point| is_unsolved(point) && is_contact(point));
    if !slow.is_empty() {
        let text = format!("{slow}: only squeeze sustains the film there");
        rows.push(("too slow for a steady film, not solved", text));
    }
    let mut warnings = Vec::new();
    let mut warn = |kind, text: String| warnings.push(Warning::new(kind, text));
    let lost = ranges(turn, |point| point.contact_lost);
    if !lost.is_empty() {
        warn(
            WarningKind::ContactLost,
            format!("the follower leaves the cam: {lost}"),
        );
    }
    let others = ranges(turn, |point| {
        is_unsolved(point) && !point.contact_lost && !is_contact(point)
    });
    if !others.is_empty() {
        warn(
            WarningKind::NotSolved,
            format!(
                "not solved, as Hertz theory does not cover these radii, or pressures are outside 1 kPa to 5 GPa: {others}"
            ),
        );
    }
    (rows, warnings)
}

/// The angles of consecutive points with a property, in words: `12 to 16 deg, 90 deg`.
fn ranges(points: &[CamPoint], is_it: impl Fn(&CamPoint) -> bool) -> String {
    let degrees = |point: &CamPoint| digits(point.angle.to_degrees(), 5);
    let mut parts: Vec<(usize, usize)> = Vec::new();
    for (i, _) in points.iter().enumerate().filter(|(_, point)| is_it(point)) {
        match parts.last_mut() {
            Some((_, end)) if *end + 1 == i => *end = i,
            _ => parts.push((i, i)),
        }
    }
    let texts: Vec<String> = parts
        .into_iter()
        .map(|(from, to)| match from == to {
            true => format!("{} deg", degrees(&points[from])),
            false => format!("{} to {} deg", degrees(&points[from]), degrees(&points[to])),
        })
        .collect();
    texts.join(", ")
}

/// A turn, rad.
const TURN: f64 = TAU;
