//! Change of the contents of partly filled gaps with the pressures.
//!
//! ```text
//!   ∂G_k/∂c_k δc_k = −δG_k − Σ ∂G_k/∂c_u δc_u        broken nodes k with nodes u upstream of them, in the order of the flow
//! ```
//! G stays zero there, so contents are not unknowns of the linear systems: backflow into a node by pressure leaves it again, downstream.

use super::contents::{downstream, rounds, sides, upstream};
use super::faces::Face;
use super::grid::Grid;

/// Change of contents with the inflow of their nodes.
#[derive(Clone, Debug, Default)]
pub struct Passing {
    /// Nodes that are not wetted, each behind those upstream of it, then those that receive flow from them.
    nodes: Vec<Passed>,
    /// Nodes upstream of each, and the change of its balance with their contents.
    from: Vec<(u32, f64)>,
    turns: bool,
}

/// A node of a [`Passing`].
#[derive(Clone, Copy, Debug)]
struct Passed {
    node: u32,
    /// Where its part of `from` ends.
    end: u32,
    /// How its balance changes with its own content; `None` where it is wetted.
    rate: Option<f64>,
}

impl Passing {
    /// Of faces with the fluxes of contents; `stores` is the change of the storage of a node with its content.
    pub fn new(
        grid: &Grid,
        faces: &[Vec<Face>; 2],
        wetted: &[bool],
        stores: impl Fn(usize) -> f64,
    ) -> Passing {
        let (order, turns) = downstream(grid, faces, wetted);
        let mut passing = Passing {
            turns,
            ..Passing::default()
        };
        let full = (0..wetted.len()).filter(|k| wetted[*k]);
        for k in order.into_iter().map(|k| k as usize).chain(full) {
            let (mut rate, start) = (stores(k), passing.from.len());
            for side in sides(grid, k) {
                let face = &faces[side.direction][side.face];
                let by_content = side.weight * face.by_content;
                if by_content > 0.0 {
                    rate += by_content;
                } else if by_content < 0.0 {
                    let from = upstream(face, side.face, [1, grid.n[0]][side.direction]);
                    passing.from.push((from as u32, by_content));
                }
            }
            if wetted[k] && passing.from.len() == start {
                continue;
            }
            passing.nodes.push(Passed {
                node: k as u32,
                end: passing.from.len() as u32,
                rate: (!wetted[k]).then_some(rate),
            });
        }
        passing
    }

    /// From changes of the balances at fixed contents to those with dependent contents: zero where contents change.
    pub fn follow(&self, change: &mut [f64]) {
        if self.nodes.is_empty() {
            return;
        }
        let mut contents = vec![0.0; change.len()];
        for _ in 0..rounds(self.turns) {
            let mut start = 0;
            for passed in &self.nodes {
                let (k, end) = (passed.node as usize, passed.end as usize);
                let arriving = (self.from[start..end].iter())
                    .map(|(from, by_content)| by_content * contents[*from as usize])
                    .sum::<f64>();
                start = end;
                if let Some(rate) = passed.rate.filter(|rate| *rate > 0.0) {
                    contents[k] = -(change[k] + arriving) / rate;
                }
            }
        }
        let mut start = 0;
        for passed in &self.nodes {
            let (k, end) = (passed.node as usize, passed.end as usize);
            change[k] = match passed.rate {
                Some(_) => 0.0,
                None => {
                    let arriving = self.from[start..end].iter();
                    change[k]
                        + arriving
                            .map(|(from, by_content)| by_content * contents[*from as usize])
                            .sum::<f64>()
                }
            };
            start = end;
        }
    }
}
