//! Figures along the path of contact, on both sides of the places where a pair of teeth takes over.

use ertel_machines::gear::PathPoint;

use super::contacts::figure_of;
use super::gears::safety::{blok_rise, bulk_temperature, contact, rise_above, specific, teeth};
use super::gears::{hotter_flank, rubbing, traction};
use crate::case::{Case, GearMechanics};
use crate::figures::courses::{Beyond, Courses, Place};
use crate::figures::path::{
    CONTACT_TEMPERATURE, FLASH_TEMPERATURE, FLASH_TEMPERATURE_BLOK, FRICTION_COEFFICIENT,
    FRICTION_POWER, HERTZ_PRESSURE, LOAD, LOAD_SHARE, ROLL_ANGLE, ROLL_DISTANCE, SPECIFIC_FILM,
    SPECIFIC_SLIDING_PINION, SPECIFIC_SLIDING_WHEEL,
};
use crate::mark::Marked;
use crate::point::MachineSolution;
use crate::solution::Figure;

/// Distance from a named place at which the loads on both sides are taken, relative to the path length.
const JUMP_STEP: f64 = 1e-6;
/// Smallest relative load difference that counts as a jump.
const JUMP: f64 = 1e-3;

/// A place of the path: the mechanics there, and whether they are those beyond a jump of the load.
struct Spot {
    contact: usize,
    at: PathPoint,
    beyond: Option<Beyond>,
}

/// The figures along the path; those that need a film where it is solved.
pub(super) fn courses(case: &Case, gears: &GearMechanics, solved: &MachineSolution) -> Courses {
    let spots = spots(gears);
    let mut courses = Courses {
        places: (spots.iter())
            .map(|spot| Place {
                contact: spot.contact,
                at: spot.at.position,
                label: spot.at.label.map(|label| label.to_string()),
                beyond: spot.beyond,
            })
            .collect(),
        all: Vec::new(),
    };
    mechanics(gears, &spots, &mut courses);
    friction(case, gears, solved, &spots, &mut courses);
    let films = spots.iter().map(|spot| {
        let own = spot.beyond.is_none().then(|| solved.of(spot.contact))??;
        specific(case, gears, figure_of(own, Figure::FilmMinimum)?)
    });
    courses.push(SPECIFIC_FILM, true, films);
    courses
}

/// The contacts, and at jumps of the load the other side: a contact there is that of fewer pairs of teeth, under the larger load.
fn spots(gears: &GearMechanics) -> Vec<Spot> {
    let mut spots = Vec::with_capacity(gears.path.len() + 2);
    for (contact, point) in gears.path.iter().enumerate() {
        let spot = |at, beyond| Spot {
            contact,
            at,
            beyond,
        };
        let own = spot(*point, None);
        match jump(gears, point) {
            None => spots.push(own),
            Some((at, Beyond::Before)) => spots.extend([spot(at, Some(Beyond::Before)), own]),
            Some((at, Beyond::Behind)) => spots.extend([own, spot(at, Some(Beyond::Behind))]),
        }
    }
    spots
}

/// The other side of a named place at which the load jumps.
fn jump(gears: &GearMechanics, point: &PathPoint) -> Option<(PathPoint, Beyond)> {
    point.label?;
    let points = gears.pair.points;
    let step = JUMP_STEP * (points.e - points.a);
    let at = |s: f64| (gears.pair.contact_at(&gears.operation, gears.sharing, s)).ok();
    let sides = [
        (at(point.position - step)?, Beyond::Before),
        (at(point.position + step)?, Beyond::Behind),
    ];
    let off = |side: &PathPoint| (side.load_per_length / point.load_per_length).ln().abs();
    let other = sides.into_iter().find(|(side, _)| off(side) > JUMP);
    other.map(|(side, beyond)| {
        let at = PathPoint {
            label: point.label,
            position: point.position,
            ..side
        };
        (at, beyond)
    })
}

/// Places, loads and motion.
fn mechanics(gears: &GearMechanics, spots: &[Spot], courses: &mut Courses) {
    let pair = &gears.pair;
    let mut add = |figure, of: &dyn Fn(&PathPoint) -> f64| {
        let values = spots.iter().map(|spot| Some(Marked::exact(of(&spot.at))));
        courses.push(figure, true, values);
    };
    add(ROLL_DISTANCE, &|at| pair.curvature_radii(at.position)[0]);
    add(ROLL_ANGLE, &|at| pair.roll_angle(at.position));
    add(LOAD_SHARE, &|at| at.load_share);
    add(LOAD, &|at| at.load_per_length);
    add(HERTZ_PRESSURE, &|at| at.hertz_pressure);
    add(SPECIFIC_SLIDING_PINION, &|at| at.specific_sliding()[0]);
    add(SPECIFIC_SLIDING_WHEEL, &|at| at.specific_sliding()[1]);
}

/// Friction and temperatures. Beyond a jump µ is that of the contact at the place, under the load there; flanks that are solved with heat have no
/// temperature there.
fn friction(
    case: &Case,
    gears: &GearMechanics,
    solved: &MachineSolution,
    spots: &[Spot],
    courses: &mut Courses,
) {
    let of = |spot: &Spot| solved.of(spot.contact);
    let coefficients = spots
        .iter()
        .map(|spot| Some(traction(gears, of(spot)?)?.abs()));
    courses.push(FRICTION_COEFFICIENT, true, coefficients);
    let powers = spots.iter().map(|spot| {
        let own = rubbing(gears, &gears.path[spot.contact], of(spot)?)?;
        Some(own.power(&spot.at))
    });
    courses.push(FRICTION_POWER, true, powers);
    let bulk = bulk_temperature(case, gears);
    let has_heat = case.heat().ok().flatten().is_some();
    let teeth = teeth(case, bulk);
    let blok = spots.iter().map(|spot| {
        let friction = traction(gears, of(spot)?)?;
        Some(blok_rise(&spot.at, friction, teeth?))
    });
    let blok: Vec<Option<Marked>> = blok.collect();
    let rises = match has_heat {
        false => blok.clone(),
        true => (spots.iter())
            .map(|spot| match spot.beyond {
                None => Some(rise_above(hotter_flank(gears, of(spot)?)?, bulk)),
                Some(_) => None,
            })
            .collect(),
    };
    let hot = rises.clone().into_iter();
    courses.push(FLASH_TEMPERATURE, true, rises.into_iter());
    let hot = hot.map(|rise| Some(contact(rise?, bulk)));
    courses.push(CONTACT_TEMPERATURE, true, hot);
    if has_heat {
        courses.push(FLASH_TEMPERATURE_BLOK, true, blok.into_iter());
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;
    use crate::case::Mechanics;
    use crate::figures::Definition;

    fn courses_of(sharing: &str) -> (Case, Courses) {
        let text = format!(
            r#"
[machine]
kind = "spur-gear"
template = "FZG-C14"
pinion_torque = "135.5 N.m"
pinion_speed = "1500 rpm"
position = "path"
points = 9
{sharing}
[bodies]
body_1 = "steel"
body_2 = "steel"
[lubricant]
temperature = "90 degC"
density = {{ law = "constant", rho_0 = "870 kg/m^3" }}
viscosity = {{ law = "barus", mu_0 = "17 mPa.s", alpha = "20 1/GPa" }}
"#
        );
        let case = Case::from_text("gears.toml", &text, std::path::Path::new("")).unwrap();
        let machine = case.whole.clone().unwrap();
        let Mechanics::Gears(gears) = &machine.mechanics else {
            panic!("gears")
        };
        let solved = MachineSolution {
            contacts: vec![None; machine.contacts.len()],
            machine: machine.clone(),
            wall_seconds: 0.0,
        };
        let courses = courses(&case, gears, &solved);
        (case, courses)
    }

    fn values(courses: &Courses, figure: Definition) -> Vec<f64> {
        let course = courses.find(figure).unwrap();
        course.values.iter().map(|v| v.unwrap().value).collect()
    }

    /// One pair carries all from B to D, both sides of the jumps have the same place, and elsewhere the shares of the pair and of the one a base pitch apart are 1 in sum: by thirds 1/3 and
    /// 2/3 at the ends, of equal pairs 1/2. Nothing slides at C.
    #[test]
    fn shares_and_sliding_along_the_path() {
        for (sharing, ends) in [
            ("load_sharing = \"thirds\"", [1.0 / 3.0, 2.0 / 3.0]),
            ("load_sharing = \"uniform\"", [0.5, 0.5]),
        ] {
            let (case, courses) = courses_of(sharing);
            let machine = case.whole.as_ref().unwrap();
            let Mechanics::Gears(gears) = &machine.mechanics else {
                panic!("gears")
            };
            let pair = &gears.pair;
            let share = values(&courses, LOAD_SHARE);
            let places = &courses.places;
            assert_eq!(places.len(), machine.contacts.len() + 2);
            let labelled = |label: &str, beyond: Option<Beyond>| {
                let is_it = |p: &Place| p.label.as_deref() == Some(label) && p.beyond == beyond;
                places.iter().position(is_it).unwrap()
            };
            let (b, d) = (labelled("B", None), labelled("D", None));
            assert!(share[b..=d].iter().all(|x| *x == 1.0), "{share:?}");
            let (before, behind) = (
                labelled("B", Some(Beyond::Before)),
                labelled("D", Some(Beyond::Behind)),
            );
            assert_eq!((before + 1, behind), (b, d + 1));
            assert_eq!(places[before].at, places[b].at);
            assert_eq!(places[behind].at, places[d].at);
            for (i, right) in [
                (labelled("A", None), ends[0]),
                (before, ends[1]),
                (behind, ends[1]),
                (labelled("E", None), ends[0]),
            ] {
                assert_relative_eq!(share[i], right, max_relative = 1e-5);
            }
            for (place, own) in places.iter().zip(&share) {
                let points = pair.points;
                let slack = 1e-7 * pair.base_pitch;
                let apart = [-1.0, 1.0].map(|side| place.at + side * pair.base_pitch);
                let inside = |s: &f64| *s > points.a - slack && *s < points.e + slack;
                let other = apart.into_iter().find(inside).filter(|_| *own < 1.0);
                let other = other.map_or(0.0, |s| {
                    // On the side of two pairs.
                    let s = (s + slack * s.signum()).clamp(points.a, points.e);
                    let at = (pair.contact_at(&gears.operation, gears.sharing, s)).unwrap();
                    at.load_share
                });
                assert_relative_eq!(own + other, 1.0, max_relative = 1e-5);
            }
            let pitch = labelled("C", None);
            for figure in [SPECIFIC_SLIDING_PINION, SPECIFIC_SLIDING_WHEEL] {
                assert!(values(&courses, figure)[pitch].abs() < 1e-12);
            }
            // Loads are as the shares, and Hertz pressures as the roots of the loads.
            let (load, pressure) = (values(&courses, LOAD), values(&courses, HERTZ_PRESSURE));
            let force = gears.operation.base_force(pair) / pair.face_width;
            assert_relative_eq!(load[before], share[before] * force, max_relative = 1e-12);
            let root = (load[before] / load[b]).sqrt();
            assert_relative_eq!(pressure[before] / pressure[b], root, max_relative = 1e-5);
            // Nothing is solved.
            assert!(courses.find(FLASH_TEMPERATURE).is_none());
        }
    }

    /// Pairs in contact along helical lines over the mean length have no jump.
    #[test]
    fn places_without_a_jump_are_those_of_the_contacts() {
        let (_, courses) = courses_of("load_sharing = \"mean-length\"");
        assert!(courses.places.iter().all(|place| place.beyond.is_none()));
    }
}
