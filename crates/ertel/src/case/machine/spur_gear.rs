//! The contact of two teeth of an external spur gear pair without profile shift.

use std::f64::consts::{FRAC_PI_4, PI};

use ertel_rheology::input::{Bounds, InputError, Table};
use ertel_rheology::quantity::Dimension;

use super::{Machine, Rows, required_length};
use crate::contact::Contact;

/// Pressure angles, rad.
const PRESSURE_ANGLE: Bounds = Bounds::open(0.0, FRAC_PI_4);
/// Places on the line of action, m.
const POSITION: Bounds = Bounds::closed(-1e3, 1e3);
/// The pinion drives, in the direction that x has.
const PINION_SPEED: Bounds = Bounds::above_to(0.0, 1e6);

/// Two involute gears that touch at the pitch circles; lengths in m, angles in rad, pinion first.
struct Pair {
    pitch_radii: [f64; 2],
    addenda: [f64; 2],
    pressure_angle: f64,
}

impl Pair {
    /// Radius of the pinion's base circle: r_b = r cos α.
    fn base_radius(&self) -> f64 {
        self.pitch_radii[0] * self.pressure_angle.cos()
    }

    /// Radii of curvature of the two flanks at the distance s from the pitch point along the line of action: the distances
    /// from the points where it touches the base circles.
    ///
    /// R_1 = r_1 sin α + s,  R_2 = r_2 sin α − s
    fn flank_radii(&self, s: f64) -> [f64; 2] {
        let sine = self.pressure_angle.sin();
        [
            self.pitch_radii[0] * sine + s,
            self.pitch_radii[1] * sine - s,
        ]
    }

    /// How far the flank of one gear reaches beyond the pitch point: its addendum circle r_a cuts the line of action at
    /// √(r_a² − r_b²) from the base circle.
    ///
    /// s = √((r + h_a)² − r² cos² α) − r sin α
    fn reach(&self, gear: usize) -> f64 {
        let (r, tip) = (
            self.pitch_radii[gear],
            self.pitch_radii[gear] + self.addenda[gear],
        );
        let base = r * self.pressure_angle.cos();
        (tip * tip - base * base).sqrt() - r * self.pressure_angle.sin()
    }

    /// The path of contact, from the tip of the wheel to that of the pinion, but not beyond the base circles, inside which
    /// there is no involute.
    fn path(&self) -> [f64; 2] {
        let [first, second] = self.flank_radii(0.0);
        [-self.reach(1).min(first), self.reach(0).min(second)]
    }
}

/// Reads the keys of `kind = "spur-gear"`.
///
/// Both flanks are pressed together along the line of action and move past the contact at u = ω R, R being the radii of
/// curvature of [`Pair::flank_radii`]:
///
/// 1/R = 1/R_1 + 1/R_2,  u_1 = ω_1 R_1,  u_2 = ω_1 (z_1/z_2) R_2,  w = X T_1/(r_b1 b)
///
/// with ω_1 in rad/s, the torque T_1 in N·m, the face width b in m, and the share X of the load that this pair of teeth takes.
/// Sources: Stachowiak and Batchelor, Engineering Tribology, chapter 7 (gear teeth); ISO/TR 15144-1 (local radii, speeds, load).
pub(super) fn read(table: &mut Table<'_>) -> Result<Machine, InputError> {
    if table.keys().any(|key| key == "helix_angle") {
        return Err(table
            .error(
                "helix_angle",
                "helical gears are not covered: the teeth must be straight",
            )
            .with_help("remove `helix_angle`, or give the contact in [contact] and [motion]"));
    }
    let module = required_length(table, "module")?;
    let teeth = [
        table.required_integer("pinion_teeth", 5..=10_000)? as f64,
        table.required_integer("wheel_teeth", 5..=10_000)? as f64,
    ];
    let pressure_angle =
        table.required_quantity("pressure_angle", Dimension::ANGLE, PRESSURE_ANGLE)?;
    let mut addendum =
        |key: &str| table.optional_quantity(key, Dimension::LENGTH, Bounds::POSITIVE);
    let addenda = [addendum("addendum_pinion")?, addendum("addendum_wheel")?]
        .map(|given| given.unwrap_or(module));
    let pair = Pair {
        pitch_radii: teeth.map(|z| 0.5 * module * z),
        addenda,
        pressure_angle,
    };
    let position = read_position(table, &pair)?;
    let flanks = pair.flank_radii(position);
    let radius = flanks[0] * flanks[1] / (flanks[0] + flanks[1]);
    let mut contact = Contact::line(radius, 0.0);
    super::check_radii(table, &contact)?;

    let width = required_length(table, "face_width")?;
    let torque = table.required_quantity("pinion_torque", Dimension::ENERGY, Bounds::POSITIVE)?;
    let share = table.required_number("load_share", Bounds::above_to(0.0, 1.0))?;
    let force = torque / pair.base_radius();
    contact.load = share * force / width;
    let omega = table.required_quantity("pinion_speed", Dimension::ANGULAR_SPEED, PINION_SPEED)?;
    let speeds = [omega * flanks[0], omega * teeth[0] / teeth[1] * flanks[1]];
    let motion = super::motion(table, "pinion_speed", speeds[0], speeds[1])?;

    let path = pair.path();
    let mut rows = Rows::default();
    rows.text("machine", "pinion (ball) and wheel (plane) of a spur gear");
    rows.number("position s from the pitch point", 1e3 * position, "mm");
    rows.text("path of contact", interval(path));
    let pitch = PI * module * pressure_angle.cos();
    rows.number("contact ratio", (path[1] - path[0]) / pitch, "");
    rows.length("R_1 = r_1 sin α + s", flanks[0]);
    rows.length("R_2 = r_2 sin α − s", flanks[1]);
    rows.length("R = R_1 R_2/(R_1 + R_2)", radius);
    rows.number("normal force T_1/(r_1 cos α)", force, "N");
    rows.number("load per length w", contact.load, "N/m");
    rows.number("u_1 = ω_1 R_1", speeds[0], "m/s");
    rows.number("u_2 = ω_2 R_2", speeds[1], "m/s");
    rows.text(
        "source",
        "Stachowiak and Batchelor, chapter 7; ISO/TR 15144-1",
    );
    Ok(Machine {
        contact,
        motion,
        load_key: "pinion_torque",
        echo: rows.echo(),
    })
}

/// The place of the contact on the line of action, m from the pitch point and positive towards the pinion's tip.
fn read_position(table: &mut Table<'_>, pair: &Pair) -> Result<f64, InputError> {
    if table.required_str("position")? == "pitch point" {
        return Ok(0.0);
    }
    let position = table
        .required_quantity("position", Dimension::LENGTH, POSITION)
        .map_err(|error| {
            error.with_help(
                "`position` is \"pitch point\" or the distance from it along the line of action, negative towards the \
                 pinion's root",
            )
        })?;
    let path = pair.path();
    let ends = pair.flank_radii(position);
    if !(path[0]..=path[1]).contains(&position) || ends.iter().any(|radius| *radius <= 0.0) {
        let text = format!(
            "the teeth do not touch here; `position` must be {}",
            interval(path)
        );
        return Err(table.error("position", text).with_help(
            "the path of contact ends at the addendum circles; `addendum_pinion` and `addendum_wheel` are the module if absent",
        ));
    }
    Ok(position)
}

/// A path of contact (m) with whole micrometres, none of them beyond its ends.
fn interval(path: [f64; 2]) -> String {
    let [from, to] = path.map(|s| (1e6 * s).trunc() / 1e3);
    format!("from {from:.3} mm to {to:.3} mm")
}
