//! Figures at each contact of a machine.

use ertel_machines::bearing::load::{Element, RingContact};
use ertel_machines::cam::CamPoint;

use super::path;
use crate::case::{BearingMechanics, CamMechanics, Case, Mechanics};
use crate::figures::courses::{Courses, Place};
use crate::figures::{Definition, element, turn};
use crate::mark::Marked;
use crate::point::MachineSolution;

/// Those of a machine, of films where they are solved.
pub(super) fn courses(case: &Case, solved: &MachineSolution) -> Courses {
    match &solved.machine.mechanics {
        Mechanics::Gears(gears) => path::courses(case, gears, solved),
        Mechanics::Bearing(bearing) => elements(bearing, solved),
        Mechanics::Cam(cam) => over_turn(cam, solved),
    }
}

/// One place for each contact.
fn at_contacts(solved: &MachineSolution) -> Courses {
    let contacts = solved.machine.contacts.iter().enumerate();
    Courses {
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
fn elements(bearing: &BearingMechanics, solved: &MachineSolution) -> Courses {
    let mut courses = at_contacts(solved);
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
        courses.push(figure, false, values);
    }
    courses
}

/// Angles of a cam.
fn over_turn(cam: &CamMechanics, solved: &MachineSolution) -> Courses {
    let mut courses = at_contacts(solved);
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
        courses.push(figure, false, values);
    }
    courses
}
