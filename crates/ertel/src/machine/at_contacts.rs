//! Figures at each contact of a machine.

use ertel_machines::bearing::load::{Element, RingContact};
use ertel_machines::cam::CamPoint;

use super::films::Films;
use super::gears::{estimated_flanks, solved_flanks};
use super::path;
use crate::case::{BearingMechanics, CamMechanics, Case, Mechanics, WholeMachine};
use crate::figures::at_contacts::{ContactFigures, Place};
use crate::figures::{Definition, element, turn};
use crate::mark::Marked;
use crate::point::MachineSolution;

/// Those of a machine; of films and friction as they are solved, or as they are estimated where nothing is.
pub(super) fn figures(
    case: &Case,
    machine: &WholeMachine,
    films: &Films,
    solved: Option<&MachineSolution>,
) -> ContactFigures {
    match &machine.mechanics {
        Mechanics::Gears(own) => {
            let flanks = match solved {
                Some(solved) => solved_flanks(case, own, solved, films),
                None => estimated_flanks(case, machine, own, films),
            };
            path::figures(case, own, &flanks)
        }
        Mechanics::Bearing(bearing) => elements(machine, bearing),
        Mechanics::Cam(cam) => over_turn(machine, cam),
    }
}

/// One place for each contact.
fn one_for_each(machine: &WholeMachine) -> ContactFigures {
    let contacts = machine.contacts.iter().enumerate();
    ContactFigures {
        places: contacts
            .map(|(contact, of)| Place {
                contact,
                at: of.place,
                label: None,
                beyond: None,
            })
            .collect(),
        all: Vec::new(),
    }
}

/// Elements at both rings, in the order of the contacts.
fn elements(machine: &WholeMachine, bearing: &BearingMechanics) -> ContactFigures {
    let mut figures = one_for_each(machine);
    let elements = &bearing.distribution.elements;
    type Of = fn(&Element, &RingContact) -> f64;
    let all: [(Definition, Of); 9] = [
        (element::ELEMENT_LOAD, |_, contact| contact.load),
        (element::CONTACT_ANGLE, |_, contact| contact.angle),
        (element::SPIN_SPEED, |_, contact| {
            let [ring, element] = contact.spin;
            element - ring
        }),
        (element::ELEMENT_SPEED, |element, _| element.own_speed),
        (element::ORBIT_SPEED, |element, _| element.cage_speed),
        (element::ATTITUDE, |element, _| element.attitude),
        (element::CENTRIFUGAL_FORCE, |element, _| {
            element.centrifugal_force
        }),
        (element::GYROSCOPIC_MOMENT, |element, _| {
            element.gyroscopic_moment
        }),
        (element::RIB_LOAD, |element, _| element.rib_load),
    ];
    for (figure, of) in all {
        let values = elements.iter().flat_map(|element| {
            let contacts = element.contacts.iter();
            contacts.map(move |contact| Some(Marked::exact(of(element, contact))))
        });
        figures.push(figure, false, values);
    }
    figures
}

/// Angles of a cam.
fn over_turn(machine: &WholeMachine, cam: &CamMechanics) -> ContactFigures {
    let mut figures = one_for_each(machine);
    type Of = fn(&CamPoint) -> f64;
    let all: [(Definition, Of); 5] = [
        (turn::LIFT, |point| point.lift),
        (turn::FOLLOWER_FORCE, |point| point.force),
        (turn::PRESSURE_ANGLE, |point| point.pressure_angle),
        (turn::ENTRAINMENT_SPEED, |point| point.entrainment_speed),
        (turn::SLIDING_SPEED, |point| point.sliding_speed),
    ];
    for (figure, of) in all {
        let values = cam.points.iter().map(|point| Some(of(point).into()));
        figures.push(figure, false, values);
    }
    figures
}
