//! Stresses of a body for output: profiles over depth, and the plane of motion.

use super::Load;
use super::body::{Body, Contact, Sampled};
use super::results::{Profile, Section};

/// Most columns of a section.
const COLUMNS: usize = 200;

/// Stresses below a place; on a grid below the centre of its cell.
pub(super) fn profile(
    contact: &Contact<'_>,
    body: &Body<'_>,
    sampled: &Sampled,
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
    let (x, stress) = match body.load {
        Load::Grid(_) => {
            let column = nearest(&contact.x, place[0]);
            let levels = sampled.levels.iter();
            let stress = levels.map(|level| level.row(row)[column]);
            (contact.x[column], stress.collect())
        }
        load => (place[0], load.column(place[0], &sampled.response)),
    };
    Profile {
        x,
        y: rows[row],
        stress,
        orthogonal_range: (sampled.levels.iter())
            .map(|level| 2.0 * level.rows[row].half_range)
            .collect(),
        depth: sampled.depths.values(),
    }
}

/// The plane of motion through the middle.
pub(super) fn section(contact: &Contact<'_>, sampled: &Sampled) -> Section {
    let near = |i: &usize| contact.x[*i].abs() <= contact.reach;
    let columns: Vec<usize> = (0..contact.x.len()).filter(near).collect();
    let step = columns.len().div_ceil(COLUMNS).max(1);
    let columns: Vec<usize> = columns.into_iter().step_by(step).collect();
    Section {
        x: columns.iter().map(|i| contact.x[*i]).collect(),
        depth: sampled.depths.values(),
        stress: (sampled.levels.iter())
            .flat_map(|level| columns.iter().map(|i| level.middle()[*i]))
            .collect(),
    }
}
