//! Oil in the cavitated region: only oil that leaves the film is there.
//!
//! ```text
//!   c ū = F at the rupture,  ∇·(c ū) = 0 behind it       c: content, ρ̄H of what flows
//!   θ = c/m                                             share of the gap that oil fills, and of the area on which it shears
//! ```
//! Streamers of oil fill the gap over the share θ of the width, air or vapour the rest (Jakobsson and Floberg 1957; Elrod, J. Lubr. Technol. 103, 1981, 350–354).
//! Contents follow from the balances of the nodes as those of a starved contact do. A flooded contact is solved without them; they only determine the shear there.
//!
//! Theory: Behind the film.

use super::contents::{Edges, distribute};
use super::faces::Face;
use super::grid::Grid;
use super::rows::RING;
use super::system::{State, System};

impl System {
    /// Contents of the nodes at a solution, infinite where gaps are full: those that are known, or by the fluxes of full gaps. `faces` returns the faces around the nodes that are not full.
    pub fn held(
        &self,
        state: &State,
        known: &[f64],
        faces: impl FnOnce(&[bool]) -> [Vec<Face>; 2],
    ) -> Vec<f64> {
        let grid = &self.grid;
        let mut contents = match known.is_empty() {
            false => known.to_vec(),
            true => {
                let full: Vec<bool> = state.oil().iter().map(|p| *p > 0.0).collect();
                let before: Vec<f64> = (grid.nodes().enumerate())
                    .map(|(k, [i, j])| match full[k] || grid.is_unknown(i, j) {
                        true => f64::INFINITY,
                        false => self.entering(state.separation, k, grid.place(i, j)),
                    })
                    .collect();
                distribute(grid, &mut faces(&full), None, &full, &before)
            }
        };
        for (k, [i, j]) in grid.nodes().enumerate() {
            if grid.is_unknown(i, j) || state.oil()[k] > 0.0 {
                continue;
            }
            let inner = nearest(grid, i, j);
            let [x, y] = grid.place(i, j);
            let [from_x, from_y] = grid.place(inner[0], inner[1]);
            let [u, v] = self.entrainment.at([x, y]);
            // Flow out through the edge, or along it.
            if u * (x - from_x) + v * (y - from_y) >= 0.0 {
                contents[k] = contents[grid.index(inner[0], inner[1])];
            }
        }
        contents
    }

    /// Content of the oil that enters through the edge at a node without pressure.
    fn entering(&self, separation: f64, k: usize, place: [f64; 2]) -> f64 {
        match &self.edges {
            Edges::Known(contents) => contents.get(k).copied().unwrap_or(f64::INFINITY),
            Edges::Rigid(gap) => {
                let [u, v] = self.entrainment.at(place);
                let since = gap.since_closest(place, [u, v]);
                if since <= 0.0 {
                    return f64::INFINITY;
                }
                let closest = [place[0] - since * u, place[1] - since * v];
                let film = self.gap_at(separation + gap.value(closest));
                self.fluid.at(0.0).density[0] * film.max(0.0)
            }
        }
    }
}

/// The node next to one along the edge whose pressure is unknown.
fn nearest(grid: &Grid, i: usize, j: usize) -> [usize; 2] {
    let rows = grid.inner_rows();
    [
        i.clamp(RING, grid.n[0] - RING - 1),
        j.clamp(rows.start, rows.end - 1),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::{Gap, Planar};
    use crate::volumes::tests::system;
    use approx::assert_relative_eq;

    /// By hand: between a sphere and a plane 0.4 apart, oil at (1, 0.5) has passed (0, 0.5), where the gap is 0.4 + 0.125; before the contact the gap is full.
    #[test]
    fn oil_behind_has_passed_the_narrowest_place() {
        let (mut system, _) = system(false, Planar::along_x(1.0));
        system.edges = Edges::Rigid(Gap::paraboloid(1.0));
        let content = system.entering(0.4, 0, [1.0, 0.5]);
        let density = system.fluid.at(0.0).density[0];
        assert_relative_eq!(content, 0.525 * density, max_relative = 1e-12);
        assert_eq!(system.entering(0.4, 0, [-1.0, 0.5]), f64::INFINITY);
    }

    /// The faces around nodes without pressure are enough: contents are those by all faces, which include the pressures next to the rupture.
    #[test]
    fn faces_around_the_broken_film_are_enough() {
        let (system, mut state) = system(false, Planar::along_x(1.0));
        let grid = &system.grid;
        for (k, [i, j]) in grid.nodes().enumerate() {
            let [x, y] = grid.place(i, j);
            if x + 0.5 * y > 0.3 {
                state.pressure[k] = 0.0;
                state.wetted[k] = false;
            }
        }
        let films = system.films(&state);
        let all = system.held(&state, &[], |_| system.linearise(&state).faces);
        let around = system.held(&state, &[], |full| {
            system.faces_around(&state, &films, full)
        });
        assert!(all.iter().filter(|content| content.is_finite()).count() > 20);
        assert_eq!(all, around);
    }

    /// Flow across the motion alone: along the edge that it enters contents stay those that are known, along the one that it leaves they are those of the next nodes within.
    #[test]
    fn contents_along_edges_follow_the_flow() {
        let across = Planar {
            centre: [0.0, 1.0],
            spin: 0.0,
        };
        let (system, mut state) = system(false, across);
        state.pressure.fill(0.0);
        let grid = &system.grid;
        let [nx, ny] = grid.n;
        let known: Vec<f64> = (0..nx * ny).map(|k| 0.1 + 0.001 * k as f64).collect();
        let held = system.held(&state, &known, |_| unreachable!());
        let at = |values: &[f64], j: usize| values[grid.index(nx / 2, j)];
        assert_eq!(at(&held, 0), at(&known, 0));
        assert_eq!(at(&held, ny - 1), at(&known, ny - 1 - RING));
    }
}
