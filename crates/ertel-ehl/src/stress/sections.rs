//! Stresses of a body for output: profiles over depth, and the plane of motion.

use super::body::{Body, Contact};
use super::results::{Profile, Section};
use super::{Level, Load};

/// Most columns of a section.
const COLUMNS: usize = 200;

/// Stresses below a place; on a grid below the centre of its cell.
pub(super) fn profile(
    contact: &Contact<'_>,
    body: &Body<'_>,
    levels: &[Level],
    place: [f64; 2],
) -> Profile {
    let rows = body.load.rows();
    let nearest = |places: &[f64], at: f64| {
        let distance = |i: &usize| (places[*i] - at).abs();
        let all = 0..places.len();
        all.min_by(|a, b| distance(a).total_cmp(&distance(b)))
            .unwrap_or(0)
    };
    let row = nearest(&rows, place[1]);
    let (x, y) = match body.load {
        Load::Grid(load) => (
            load.centres[0][nearest(&load.centres[0], place[0])],
            rows[row],
        ),
        _ => (place[0], 0.0),
    };
    let depth = contact.depths.all();
    Profile {
        x,
        y,
        stress: (depth.iter())
            .map(|z| body.load.at([x, y, *z], body.poisson))
            .collect(),
        orthogonal_range: (levels.iter())
            .map(|level| 2.0 * level.rows[row].half_range)
            .collect(),
        depth,
    }
}

/// The plane of motion through the middle.
pub(super) fn section(contact: &Contact<'_>, levels: &[Level]) -> Section {
    let near = |i: &usize| contact.x[*i].abs() <= contact.reach;
    let columns: Vec<usize> = (0..contact.x.len()).filter(near).collect();
    let step = columns.len().div_ceil(COLUMNS).max(1);
    let columns: Vec<usize> = columns.into_iter().step_by(step).collect();
    Section {
        x: columns.iter().map(|i| contact.x[*i]).collect(),
        depth: contact.depths.all(),
        stress: (levels.iter())
            .flat_map(|level| columns.iter().map(|i| level.middle[*i]))
            .collect(),
    }
}
