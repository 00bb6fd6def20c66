//! Loads and films around a bearing; along a path of contact and over a turn of a cam those of `along`.

use ertel_plot::{Axis, Drawing, Look, PALETTE, Polar, polar_row};

use super::super::pictures::{Picture, film_unit};
use super::along::{along, flanks};
use super::values::{film, largest};
use crate::case::{MachineAxis, RINGS};
use crate::figures::at_contacts::ContactFigures;
use crate::solution::Figure;
use crate::study::MachineSolution;
use crate::words::force_unit;

/// Every picture of a machine.
pub(in crate::output) fn machine_pictures(
    title: &str,
    machine: &MachineSolution,
    at_contacts: &ContactFigures,
) -> Vec<Picture> {
    let title = match machine.interruption() {
        Some(text) => format!("{title} ({text})"),
        None => title.to_owned(),
    };
    let path = || Picture::new("path", along(&title, machine, at_contacts));
    match machine.machine.axis {
        MachineAxis::Around => vec![Picture::new("around", around(&title, machine))],
        MachineAxis::CamAngle => vec![path()],
        MachineAxis::LineOfAction => {
            vec![
                path(),
                Picture::new("flanks", flanks(&title, machine, at_contacts)),
            ]
        }
    }
}

/// Angular separation of the two rings' points, relative to the element spacing: otherwise equal films would hide each other.
const RING_SEPARATION: f64 = 0.12;

/// Shifts the points of a ring slightly from the angle of their element.
fn offset(points: Vec<[f64; 2]>, side: usize, n_elements: usize) -> Vec<[f64; 2]> {
    let by = RING_SEPARATION * std::f64::consts::TAU / n_elements.max(1) as f64;
    let by = if side == 0 { -0.5 * by } else { 0.5 * by };
    (points.into_iter())
        .map(|[angle, value]| [angle + by, value])
        .collect()
}

fn ring(side: usize) -> String {
    format!("{} ring", RINGS[side])
}

/// A value of each contact of a side with its place, without unsolved contacts.
fn values(
    machine: &MachineSolution,
    side: usize,
    value: impl Fn(usize) -> Option<f64>,
) -> Vec<[f64; 2]> {
    let contacts = machine.machine.contacts.iter().enumerate();
    let of = contacts.filter(|(_, contact)| contact.side == side);
    of.filter_map(|(i, contact)| Some([contact.place, value(i)?]))
        .collect()
}

/// Loads, and central and minimum films, around a bearing.
fn around(title: &str, machine: &MachineSolution) -> Drawing {
    let whole = &machine.machine;
    let first: Vec<f64> = (whole.contacts.iter())
        .filter(|contact| contact.side == 0)
        .map(|contact| contact.place)
        .collect();
    let labels: Vec<(f64, String)> = (first.iter().enumerate())
        .map(|(i, angle)| (*angle, i.to_string()))
        .collect();
    let polar = |heading: &str, label: String, high: f64| Polar {
        title: title.to_owned(),
        heading: heading.to_owned(),
        // Margin for the points at the rim.
        radius: Axis::linear(&label, 0.0, 1.08 * high),
        series: Vec::new(),
        labels: labels.clone(),
    };
    let largest_load = whole
        .contacts
        .iter()
        .map(|contact| contact.load)
        .fold(0.0, f64::max);
    let (factor, unit) = force_unit(largest_load, whole.is_line);
    let load = |side| values(machine, side, |i| Some(factor * whole.contacts[i].load));
    let loads = [load(0), load(1)];
    let mut of_loads = polar(
        "Load of each element",
        format!("load ({unit})"),
        largest(&loads),
    );
    let looks = [Look::Dots, Look::Circles];
    for (side, points) in loads.into_iter().enumerate().rev() {
        let points = offset(points, side, first.len());
        of_loads.add(&ring(side), points, looks[side], PALETTE[side]);
    }
    let films: Vec<[Vec<[f64; 2]>; 2]> = [0, 1]
        .map(|side| {
            [Figure::FilmCentral, Figure::FilmMinimum]
                .map(|figure| values(machine, side, |i| film(machine, i, figure)))
        })
        .to_vec();
    let all: Vec<Vec<[f64; 2]>> = films.iter().flatten().cloned().collect();
    let (factor, unit) = film_unit(largest(&all));
    let high = factor * largest(&all);
    let mut of_films = polar("Film thickness", format!("*h* ({unit})"), high);
    for (side, [central, minimum]) in films.into_iter().enumerate().rev() {
        let scaled = |points: Vec<[f64; 2]>| -> Vec<[f64; 2]> {
            let scaled = points.into_iter().map(|[angle, h]| [angle, factor * h]);
            offset(scaled.collect(), side, first.len())
        };
        let label = |what: &str| format!("{what}, {}", ring(side));
        of_films.add(
            &label("central"),
            scaled(central),
            looks[side],
            PALETTE[side],
        );
        of_films.add(
            &label("minimum"),
            scaled(minimum),
            Look::Crosses,
            PALETTE[side],
        );
    }
    polar_row(title, &[of_loads, of_films])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// For nine elements, 40° apart, the points of the rings are 2.4° to either side.
    #[test]
    fn points_of_both_rings_are_seen() {
        let at = |side| offset(vec![[1.0, 5.0]], side, 9)[0];
        let by = 2.4_f64.to_radians();
        for (side, expected) in [(0, 1.0 - by), (1, 1.0 + by)] {
            assert!((at(side)[0] - expected).abs() < 1e-12);
            assert_eq!(at(side)[1], 5.0);
        }
    }
}
