//! Oil in partly filled gaps: starved inlets, and the region behind the contact.
//!
//! ```text
//!   P ≥ 0,  c ≤ m,  P (m − c) = 0,  G = 0         c: content of a node, the oil that the flow carries away
//!   F = ū min(c_u, m) − …                          u: the node upstream, m: at the face of a filled gap
//!   ∂/∂T min(c, m) in time                         m: of the node
//! ```
//! Where there is pressure the gap is full, and the pressure is unknown; elsewhere the content is (Jakobsson and Floberg 1957; Elrod, J. Lubr.
//! Technol. 103, 1981, 350–354; Woloszynski, Podsiadlo and Stachowiak, Tribol. Lett. 58, 2015, 18). The minimum of both sides makes the flux
//! continuous where a gap fills up, for all faces of a node, so that each set has a solution where the other one ends. A layer of uniform thickness
//! arrives unchanged, whatever the gap is: ū is that of a rigid body, whose fluxes into each volume cancel. The node before the meniscus is partly
//! filled, and the backflow by pressure grows with its content: where gap and viscosity change slowly, this content places the meniscus between the
//! nodes.
//!
//! Theory: Starved inlets.

use super::faces::Face;

use super::grid::Grid;
use super::node::Node;
use super::storage::Storage;
use crate::contact::{Gap, Inlet};
use crate::engine::Problem;

/// How oil arrives.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Arrival {
    /// The gap is full as far as the grids go.
    #[default]
    Flooded,
    /// It is full along the edges; within, where the film has broken, it holds what has arrived.
    FromEdges,
    /// It is full from this X on; there is no pressure before.
    From(f64),
    /// A layer with this m = ρ̄H arrives.
    Layer(f64),
}

impl Arrival {
    /// That of a problem.
    pub fn of<Plan>(problem: &Problem<Plan>) -> Arrival {
        match problem.shape.inlet {
            Inlet::Flooded => Arrival::Flooded,
            Inlet::Meniscus => Arrival::From(problem.extents.inlet),
            Inlet::Layer(layer) => {
                Arrival::Layer(problem.fluid.at(0.0).density[0] * layer.thickness)
            }
        }
    }

    /// Contents of nodes before anything is solved, by whether they are wetted; none where gaps are full.
    pub fn contents(&self, wetted: &[bool]) -> Vec<f64> {
        let arriving = match self {
            Arrival::Flooded | Arrival::From(_) => return Vec::new(),
            Arrival::FromEdges => f64::INFINITY,
            Arrival::Layer(layer) => *layer,
        };
        let content = |wetted: &bool| if *wetted { f64::INFINITY } else { arriving };
        wetted.iter().map(content).collect()
    }

    /// Whether there may be pressure at X, for nodes at the distance h.
    pub fn may_press(&self, x: f64, h: f64) -> bool {
        match self {
            Arrival::Flooded | Arrival::FromEdges | Arrival::Layer(_) => true,
            Arrival::From(meniscus) => x > meniscus + ON_MENISCUS * h,
        }
    }
}

/// Storage of the nodes in time, with their mass while they are full; none in steady contacts.
pub type Stored<'a> = Option<(&'a Storage, &'a [Node])>;

/// Share of a cell by which rounding may move a node off the meniscus.
const ON_MENISCUS: f64 = 1e-6;

/// A face of a node: its direction and number, and the weight of its flux in the balance of the node.
#[derive(Clone, Copy)]
pub(super) struct Side {
    pub direction: usize,
    pub face: usize,
    pub weight: f64,
}

/// The faces of an unknown node; beyond the centreline of a half all is mirrored.
pub(super) fn sides(grid: &Grid, k: usize) -> [Side; 4] {
    let [nx, ny] = grid.n;
    let [dx, dy] = [0, 1].map(|d: usize| grid.length(d, k / nx));
    let (north, south, below) = match grid.half && k / nx + 1 == ny {
        _ if grid.is_line() => (0.0, 0.0, k),
        true => (0.0, -2.0 / dy, k - nx),
        false => (1.0 / dy, -1.0 / dy, k - nx),
    };
    let side = |direction, face, weight| Side {
        direction,
        face,
        weight,
    };
    [
        side(0, k, 1.0 / dx),
        side(0, k - 1, -1.0 / dx),
        side(1, k, north),
        side(1, below, south),
    ]
}

/// Contents of the nodes that are not wetted, from those of the nodes along the edge: outflow is inflow minus storage. Infinite where the inflow
/// exceeds the largest outflow. The fluxes, which are those of full gaps, become those of the contents.
pub fn distribute(
    grid: &Grid,
    faces: &mut [Vec<Face>; 2],
    stored: Stored<'_>,
    wetted: &[bool],
    before: &[f64],
) -> Vec<f64> {
    let mut contents: Vec<f64> = (before.iter().zip(wetted))
        .map(|(content, wetted)| if *wetted { f64::INFINITY } else { *content })
        .collect();
    let (order, turns) = downstream(grid, faces, wetted);
    for _ in 0..rounds(turns) {
        let mut is_unchanged = true;
        for k in &order {
            let content = passed_on(grid, faces, stored, &contents, *k as usize);
            let old = std::mem::replace(&mut contents[*k as usize], content);
            is_unchanged &= content == old || (content - old).abs() <= UNCHANGED * content.abs();
        }
        if is_unchanged {
            break;
        }
    }
    for (direction, faces) in faces.iter_mut().enumerate() {
        let step = [1, grid.n[0]][direction];
        for (k, face) in faces.iter_mut().enumerate() {
            if face.entrainment == 0.0 {
                continue;
            }
            let content = contents[upstream(face, k, step)];
            if content < face.mass {
                face.flux += face.entrainment * (content - face.mass);
                face.by_mass = [0.0; 3];
                face.by_content = face.entrainment;
            }
        }
    }
    contents
}

/// Unknown nodes that are not wetted, each behind those upstream of it, and whether the flow turns in circles among some, which come last.
pub(super) fn downstream(grid: &Grid, faces: &[Vec<Face>; 2], wetted: &[bool]) -> (Vec<u32>, bool) {
    let nx = grid.n[0];
    let is_broken = |k: usize| !wetted[k] && grid.is_unknown(k % nx, k / nx);
    // Entrained flow into a node through a side comes from the neighbour there.
    let neighbour = |side: &Side| {
        let face = &faces[side.direction][side.face];
        let step = [1, nx][side.direction];
        let rate = side.weight * face.entrainment;
        let [here, there] = [side.face, side.face + step];
        (
            rate,
            if face.from_second {
                [there, here]
            } else {
                [here, there]
            },
        )
    };
    let mut waiting = vec![0_u8; grid.n_nodes()];
    let mut order: Vec<u32> = Vec::new();
    let mut count = 0;
    for k in (0..grid.n_nodes()).filter(|k| is_broken(*k)) {
        count += 1;
        waiting[k] = (sides(grid, k).iter().map(neighbour))
            .filter(|(rate, [from, _])| *rate < 0.0 && is_broken(*from))
            .count() as u8;
        if waiting[k] == 0 {
            order.push(k as u32);
        }
    }
    let mut next = 0;
    while let Some(k) = order.get(next).copied() {
        next += 1;
        for (rate, [_, to]) in sides(grid, k as usize).iter().map(neighbour) {
            if rate > 0.0 && is_broken(to) {
                waiting[to] -= 1;
                if waiting[to] == 0 {
                    order.push(to as u32);
                }
            }
        }
    }
    let turns = order.len() < count;
    order.extend(
        (0..grid.n_nodes())
            .filter(|k| waiting[*k] > 0)
            .map(|k| k as u32),
    );
    (order, turns)
}

/// Sweeps of contents along the flow.
pub(super) fn rounds(turns: bool) -> usize {
    if turns { MOST_ROUNDS } else { 1 }
}

/// The node upstream of a face, whose nodes are k and k + step.
pub(super) fn upstream(face: &Face, k: usize, step: usize) -> usize {
    if face.from_second { k + step } else { k }
}

/// Net outflow of a node with the inflow from the contents around it; faces are those of full gaps.
fn passed_on(
    grid: &Grid,
    faces: &[Vec<Face>; 2],
    stored: Stored<'_>,
    contents: &[f64],
    k: usize,
) -> f64 {
    // Outflow and storage minus inflow while the node itself is full; then storage in it and entrainment out of it: rates and m at the faces.
    let mut excess = 0.0;
    let mut leaving = [(0.0, 0.0); 5];
    if let Some((storage, nodes)) = stored {
        let full = nodes[k].mass;
        excess += storage.rate * full + storage.past[k];
        leaving[4] = (storage.rate, full);
    }
    for (side, leaving) in sides(grid, k).into_iter().zip(&mut leaving) {
        let face = &faces[side.direction][side.face];
        excess += side.weight * face.flux;
        let rate = side.weight * face.entrainment;
        if rate > 0.0 {
            *leaving = (rate, face.mass);
        } else if rate < 0.0 {
            let step = [1, grid.n[0]][side.direction];
            let arriving = contents[upstream(face, side.face, step)].min(face.mass);
            excess += rate * (arriving - face.mass);
        }
    }
    if leaving.iter().all(|(rate, _)| *rate == 0.0) {
        return contents[k];
    }
    match excess > 0.0 {
        true => lowered(leaving, excess),
        false => f64::INFINITY,
    }
}

/// The content c at which Σ rate max(m − c, 0) is a given excess.
fn lowered(leaving: [(f64, f64); 5], excess: f64) -> f64 {
    let mut content = f64::NEG_INFINITY;
    // Each round removes those that are full by the current estimate, five at most.
    for _ in 0..leaving.len() {
        let short = leaving.iter().filter(|(_, mass)| *mass > content);
        let (rates, full) = short.fold((0.0, 0.0), |(rates, full), (rate, mass)| {
            (rates + rate, full + rate * mass)
        });
        if rates == 0.0 {
            break;
        }
        content = (full - excess) / rates;
    }
    content
}

/// Rounds at most where the flow turns in circles.
const MOST_ROUNDS: usize = 20;

/// Relative change of contents in a round that counts as zero.
const UNCHANGED: f64 = 1e-12;

/// F, what a gap H lacks with some content at the density of no pressure.
pub fn missing(film: f64, content: f64, density: f64) -> f64 {
    (film - content / density).max(0.0)
}

/// Oil that enters a grid along its edge where there is no pressure.
#[derive(Clone, Debug)]
pub enum Edges {
    /// It has passed the contact beyond the edge, between rigid parabolas.
    Rigid(Gap),
    /// Contents of the nodes, infinite where gaps are full; none where all are.
    Known(Vec<f64>),
}

impl Default for Edges {
    fn default() -> Edges {
        Edges::Known(Vec::new())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By hand: 0.2 of a density of 0.8 fills 0.25 of a gap of 0.5; a full gap lacks nothing.
    #[test]
    fn missing_by_hand() {
        assert!((missing(0.5, 0.2, 0.8) - 0.25).abs() < 1e-12);
        assert_eq!(missing(0.5, f64::INFINITY, 0.8), 0.0);
    }
}
