//! Figures along the path of contact, on both sides of the places where a pair of teeth takes over.

use ertel_machines::gear::PathPoint;

use super::contacts::Values;
use super::gears::safety::{
    Flanks, blok_rise, bulk_temperature, contact, rise_above, specific, teeth,
};
use crate::case::{Case, GearMechanics};
use crate::figures::at_contacts::{Beyond, ContactFigures, Place};
use crate::figures::path::{
    CONTACT_TEMPERATURE, FLASH_TEMPERATURE, FLASH_TEMPERATURE_BLOK, FRICTION_COEFFICIENT,
    FRICTION_POWER, HERTZ_PRESSURE, LOAD, LOAD_SHARE, ROLL_ANGLE, ROLL_DISTANCE, SLIDING_SPEED,
    SPECIFIC_FILM, SPECIFIC_SLIDING_PINION, SPECIFIC_SLIDING_WHEEL,
};
use crate::mark::Marked;

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

/// The figures along the path.
pub(super) fn figures(case: &Case, gears: &GearMechanics, flanks: &Flanks<'_>) -> ContactFigures {
    let spots = spots(gears);
    let mut figures = ContactFigures {
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
    mechanics(gears, &spots, &mut figures);
    friction(case, gears, flanks, &spots, &mut figures);
    // Beyond a jump there is no film.
    let films = spots.iter().map(|spot| match spot.beyond {
        None => specific(case, gears, flanks.films.minimum[spot.contact]?),
        Some(_) => None,
    });
    figures.push(SPECIFIC_FILM, true, films);
    figures
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
            Some((at, Beyond::After)) => spots.extend([own, spot(at, Some(Beyond::After))]),
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
        (at(point.position + step)?, Beyond::After),
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
fn mechanics(gears: &GearMechanics, spots: &[Spot], figures: &mut ContactFigures) {
    let pair = &gears.pair;
    let mut add = |figure, of: &dyn Fn(&PathPoint) -> f64| {
        let values = spots.iter().map(|spot| Some(Marked::exact(of(&spot.at))));
        figures.push(figure, true, values);
    };
    add(ROLL_DISTANCE, &|at| pair.curvature_radii(at.position)[0]);
    add(ROLL_ANGLE, &|at| pair.roll_angle(at.position));
    add(LOAD_SHARE, &|at| at.load_share);
    add(LOAD, &|at| at.load_per_length);
    add(SLIDING_SPEED, &|at| at.sliding_speed);
    add(HERTZ_PRESSURE, &|at| at.hertz_pressure);
    add(SPECIFIC_SLIDING_PINION, &|at| at.specific_sliding()[0]);
    add(SPECIFIC_SLIDING_WHEEL, &|at| at.specific_sliding()[1]);
}

/// Friction and temperatures. Beyond a jump µ is that of the contact at the place, under the load there; flanks that are solved with heat have no
/// temperature there.
fn friction(
    case: &Case,
    gears: &GearMechanics,
    flanks: &Flanks<'_>,
    spots: &[Spot],
    figures: &mut ContactFigures,
) {
    let coefficients = (spots.iter()).map(|spot| Some(flanks.friction[spot.contact]?.abs()));
    figures.push(FRICTION_COEFFICIENT, true, coefficients);
    let powers = spots.iter().map(|spot| {
        let rubbing = flanks.rubbing.get(spot.contact)?.as_ref()?;
        Some(rubbing.power(&spot.at))
    });
    figures.push(FRICTION_POWER, true, powers);
    let bulk = bulk_temperature(case, gears);
    let teeth = teeth(case, bulk);
    let blok = spots.iter().map(|spot| {
        let friction = flanks.friction[spot.contact]?;
        Some(blok_rise(&spot.at, friction, teeth?))
    });
    let blok: Vec<Option<Marked>> = blok.collect();
    let solved = |hottest: &Values| -> Values {
        let rise = |spot: &Spot| match spot.beyond {
            None => Some(rise_above(hottest[spot.contact]?, bulk)),
            Some(_) => None,
        };
        spots.iter().map(rise).collect()
    };
    let rises = flanks.hottest.as_ref().map_or_else(|| blok.clone(), solved);
    let hot = rises.clone().into_iter();
    figures.push(FLASH_TEMPERATURE, true, rises.into_iter());
    let hot = hot.map(|rise| Some(contact(rise?, bulk)));
    figures.push(CONTACT_TEMPERATURE, true, hot);
    if flanks.hottest.is_some() {
        figures.push(FLASH_TEMPERATURE_BLOK, true, blok.into_iter());
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;
    use crate::case::Mechanics;
    use crate::figures::Definition;
    use crate::machine::films::Films;
    use crate::machine::gears::estimated_flanks;

    fn figures_of(sharing: &str) -> (Case, ContactFigures) {
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
        let films = Films::by_formulas(&case, &machine);
        let flanks = estimated_flanks(&case, &machine, gears, &films);
        let figures = figures(&case, gears, &flanks);
        (case, figures)
    }

    fn values(figures: &ContactFigures, figure: Definition) -> Vec<f64> {
        let entry = figures.find(figure).unwrap();
        entry.values.iter().map(|v| v.unwrap().value).collect()
    }

    /// One pair carries all from B to D, both sides of the jumps have the same place, and elsewhere the shares of the pair and of the one a base pitch apart are 1 in sum: by thirds 1/3 and
    /// 2/3 at the ends, of equal pairs 1/2. Nothing slides at C.
    #[test]
    fn shares_and_sliding_along_the_path() {
        for (sharing, ends) in [
            ("load_sharing = \"thirds\"", [1.0 / 3.0, 2.0 / 3.0]),
            ("load_sharing = \"uniform\"", [0.5, 0.5]),
        ] {
            let (case, figures) = figures_of(sharing);
            let machine = case.whole.as_ref().unwrap();
            let Mechanics::Gears(gears) = &machine.mechanics else {
                panic!("gears")
            };
            let pair = &gears.pair;
            let share = values(&figures, LOAD_SHARE);
            let places = &figures.places;
            assert_eq!(places.len(), machine.contacts.len() + 2);
            let labelled = |label: &str, beyond: Option<Beyond>| {
                let is_it = |p: &Place| p.label.as_deref() == Some(label) && p.beyond == beyond;
                places.iter().position(is_it).unwrap()
            };
            let (b, d) = (labelled("B", None), labelled("D", None));
            assert!(share[b..=d].iter().all(|x| *x == 1.0), "{share:?}");
            let (before, behind) = (
                labelled("B", Some(Beyond::Before)),
                labelled("D", Some(Beyond::After)),
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
                assert!(values(&figures, figure)[pitch].abs() < 1e-12);
            }
            // Loads are as the shares, and Hertz pressures as the roots of the loads.
            let (load, pressure) = (values(&figures, LOAD), values(&figures, HERTZ_PRESSURE));
            let force = gears.operation.base_force(pair) / pair.face_width;
            assert_relative_eq!(load[before], share[before] * force, max_relative = 1e-12);
            let root = (load[before] / load[b]).sqrt();
            assert_relative_eq!(pressure[before] / pressure[b], root, max_relative = 1e-5);
            // No roughness is given for the friction after Schlenk, and nothing is solved.
            assert!(figures.find(FLASH_TEMPERATURE).is_none());
            assert!(figures.find(FRICTION_POWER).is_none());
        }
    }

    /// Pairs in contact along helical lines over the mean length have no jump.
    #[test]
    fn places_without_a_jump_are_those_of_the_contacts() {
        let (_, figures) = figures_of("load_sharing = \"mean-length\"");
        assert!(figures.places.iter().all(|place| place.beyond.is_none()));
    }
}
