//! Keys of `[transient]` that determine the distance of the bodies: `start`, `gap`, `approach_velocity`, `approach`, `mass`, `damping`, `stiffness`.

use std::f64::consts::{PI, SQRT_2};

use ertel_input::{Bounds, InputError, Table};
use ertel_quantity::Dimension;

use super::Case;
use super::course::Reader;
use super::motion::MAX_SPEED;
use crate::contact::Family;
use crate::transient::{Approach, Course, Mover, Start};

/// Gaps, m: below, the film is no continuum; above, no film of a contact.
const GAP: Bounds = Bounds::closed(1e-9, 1e-2);
/// Approaches beyond the start, m.
const APPROACH: Bounds = Bounds::closed(-1e-2, 1e-2);
/// Velocities of an approach, m/s.
const VELOCITY: Bounds = Bounds::closed(0.0, MAX_SPEED);
/// Masses, kg, of line contacts kg/m; damping, N s/m, N s/m²; stiffness, N/m, N/m²: values outside indicate a wrong unit.
const MASS: Bounds = Bounds::closed(1e-12, 1e9);
const DAMPING: Bounds = Bounds::closed(0.0, 1e15);
const STIFFNESS: Bounds = Bounds::closed(0.0, 1e15);

/// Reads the keys that determine the distance (kg, N s/m, N/m, of line contacts per length; m over s), and the start (m, m/s).
pub(super) fn read(
    reader: &mut Reader<'_, '_>,
    case: &Case,
) -> Result<(Approach, Start), InputError> {
    let course = reader.course("approach", 0.0, Dimension::LENGTH, APPROACH)?;
    let table = &mut *reader.table;
    let body = body(table, case.contact.kind.is_line())?;
    let approach = match (course, body) {
        (None, None) => Approach::Massless,
        (None, Some(body)) => Approach::Body(body),
        (Some(course), None) => Approach::Given(course),
        (Some(_), Some(_)) => {
            return Err(table
                .error(
                    "approach",
                    "`approach` prescribes the motion of the bodies, which the mass cannot change",
                )
                .with_help("remove `approach`, or `mass`, `damping` and `stiffness`"));
        }
    };
    let start = start(table, &approach)?;
    Ok((approach, start))
}

fn body(table: &mut Table<'_>, is_line: bool) -> Result<Option<Mover>, InputError> {
    let per_length = |dimension: Dimension| match is_line {
        true => dimension.per(Dimension::LENGTH),
        false => dimension,
    };
    let [of_mass, of_damping, of_stiffness] = [
        Dimension::MASS,
        Dimension::FORCE.per(Dimension::SPEED),
        Dimension::FORCE_PER_LENGTH,
    ]
    .map(per_length);
    let mass = table.optional_quantity("mass", of_mass, MASS)?;
    let damping = table.optional_quantity("damping", of_damping, DAMPING)?;
    let stiffness = table.optional_quantity("stiffness", of_stiffness, STIFFNESS)?;
    let forces = [("damping", damping), ("stiffness", stiffness)];
    let Some(mass) = mass else {
        return match forces.into_iter().find(|(_, value)| value.is_some()) {
            None => Ok(None),
            Some((key, _)) => Err(table
                .error(
                    key,
                    format!("`{key}` acts on a moving body, but no `mass` is given"),
                )
                .with_help("give the mass of the moving body, such as mass = \"30 g\"")),
        };
    };
    Ok(Some(Mover {
        mass,
        damping: damping.unwrap_or(0.0),
        stiffness: stiffness.unwrap_or(0.0),
    }))
}

fn start(table: &mut Table<'_>, approach: &Approach) -> Result<Start, InputError> {
    let choices = [("steady", false), ("apart", true)];
    let is_apart = table.optional_choice("start", &choices)?.unwrap_or(false);
    if !is_apart {
        let keys = ["gap", "approach_velocity"];
        return match keys.into_iter().find(|key| table.contains(key)) {
            None => Ok(Start::Steady),
            Some(key) => Err(table
                .error(
                    key,
                    format!("`{key}` is for bodies that are apart at t = 0, but this run starts from the steady contact"),
                )
                .with_help("start = \"apart\"")),
        };
    }
    let gap = table.required_quantity("gap", Dimension::LENGTH, GAP)?;
    let velocity = match approach {
        Approach::Body(_) => {
            table.required_quantity("approach_velocity", Dimension::SPEED, VELOCITY)?
        }
        Approach::Massless | Approach::Given(_) if table.contains("approach_velocity") => {
            return Err(table
                .error(
                    "approach_velocity",
                    "only a body with `mass` has an initial velocity",
                )
                .with_help("give `mass`, or the distance over time as `approach`"));
        }
        Approach::Given(_) | Approach::Massless => 0.0,
    };
    Ok(Start::Apart { gap, velocity })
}

/// Scales of the approach velocity, m/s, and of the resulting film force, N (N/m): of rigid bodies at the start under a load (Stefan
/// 1874; Cameron 1966 for cylinders), of the impact of a dry ball (Hertz 1882).
pub(super) fn reference(case: &Case, approach: &Approach, start: Start, load: f64) -> [f64; 2] {
    let Start::Apart { gap, velocity } = start else {
        return [0.0, load];
    };
    let eta = case.lubricant.ambient_viscosity();
    let [along, across] = case.contact.radii_along_and_across();
    let is_line = case.contact.kind.family() != Family::Point;
    let sinking = match is_line {
        true => {
            let load = case.contact.line_load() * load / case.contact.load;
            load / (3.0 * SQRT_2 * PI * eta) * (gap / along).powf(1.5)
        }
        false => {
            let curvature = 1.0 / along + 1.0 / across;
            load * gap * curvature / (12.0 * PI * eta * (along * across).sqrt())
        }
    };
    match approach {
        Approach::Massless => [sinking, load],
        Approach::Given(course) => [steepest(course), load],
        Approach::Body(body) => {
            let falling = (2.0 * load * gap / body.mass).sqrt();
            let fastest = velocity.max(sinking.min(falling));
            let modulus = 0.5 * case.reduced_modulus();
            let impact = match is_line {
                // Half the energy in springs of about this stiffness for a unit of length.
                true => {
                    let length = case.contact.load / case.contact.line_load();
                    fastest * (0.125 * PI * modulus * length * body.mass).sqrt()
                }
                false => {
                    let stiffness = 4.0 / 3.0 * modulus * (along * across).powf(0.25);
                    let energy = 1.25 * body.mass * fastest * fastest;
                    stiffness.powf(0.4) * energy.powf(0.6)
                }
            };
            [fastest, load.max(impact)]
        }
    }
}

/// Largest slope of a course.
fn steepest(course: &Course) -> f64 {
    match course {
        Course::Constant(_) | Course::Step { .. } => 0.0,
        Course::Sine {
            amplitude, period, ..
        } => 2.0 * PI * (amplitude / period).abs(),
        Course::Table(rows) | Course::Smooth(rows) => (rows.windows(2))
            .map(|rows| ((rows[1][1] - rows[0][1]) / (rows[1][0] - rows[0][0])).abs())
            .fold(0.0, f64::max),
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    /// Hertz's impact of a steel ball of 5 mm at 0.05 m/s gives 12.0188 N (closed form); the load of the ball is negligible.
    #[test]
    fn an_impact_is_measured_by_the_dry_one() {
        let text = "[contact]\nkind = \"circular\"\nradius = \"5 mm\"\nload = \"0.1 N\"\n[bodies]\nbody_1 = { youngs_modulus = \"210 GPa\", poissons_ratio = 0.3 }\nbody_2 = { youngs_modulus = \"210 GPa\", poissons_ratio = 0.3 }\n[motion]\nentrainment_speed = \"1 m/s\"\nslide_to_roll_ratio = 0.0\n[lubricant]\ntemperature = \"40 degC\"\ndensity = { law = \"constant\", rho_0 = \"870 kg/m^3\" }\nviscosity = { law = \"constant\", mu_0 = \"40 mPa.s\" }\n";
        let case = Case::from_text("case.toml", text, std::path::Path::new(".")).unwrap();
        let body = Approach::Body(Mover {
            mass: 0.004_110_250_388,
            ..Mover::default()
        });
        let start = Start::Apart {
            gap: 5e-6,
            velocity: 0.05,
        };
        let [velocity, force] = reference(&case, &body, start, 0.1);
        assert_relative_eq!(velocity, 0.05);
        assert_relative_eq!(force, 12.018_759_33, max_relative = 1e-6);
        // A sphere that sinks under its load: V = W h/6πηR².
        let [velocity, load] = reference(&case, &Approach::Massless, start, 0.1);
        let stefan = 0.1 * 5e-6 / (6.0 * PI * 0.04 * 25e-6);
        assert_relative_eq!(velocity, stefan, max_relative = 1e-12);
        assert_relative_eq!(load, 0.1);
    }
}
