//! Mass that flows through the film of a grid at each height, and the convection of heat with it.

use rayon::prelude::*;

use super::columns::{Columns, FilmHeat};
use crate::film::MOST_NODES;
use crate::forms::energy::Heights;
use crate::volumes::contents::sides;
use crate::volumes::faces::Face;
use crate::volumes::grid::Grid;
use crate::volumes::storage::Storage;

/// Mass that flows through the film of a grid, and the heat that it carries.
pub struct Flow<'a> {
    pub(super) grid: &'a Grid,
    pub(super) heights: &'a Heights,
    pub(super) columns: &'a Columns,
    /// Of the temperature of each node across the film, that at all heights.
    pub(super) raised: Vec<AtHeights>,
    /// Sides of the unknown nodes.
    pub(super) sides: Vec<[Side; 4]>,
    /// m through the faces behind each node along both directions, height by height.
    pub(super) through: [Vec<AtHeights>; 2],
    /// How temperatures change in time, where they do.
    pub(super) stored: Option<&'a Storage>,
}

/// A side of a node.
#[derive(Clone, Copy, Default)]
pub(super) struct Side {
    pub(super) direction: u8,
    pub(super) face: u32,
    /// 0 where there is none.
    pub(super) weight: f64,
    /// The node beyond it, the next one, and the one behind the node itself.
    pub(super) next: [u32; 2],
    pub(super) behind: u32,
    /// a of inflow and of outflow.
    pub(super) ahead: [f64; 2],
}

/// Values at the heights over a node, filled up with zeros to whole vectors.
pub type AtHeights = [f64; 16];

const _: () = assert!(MOST_NODES <= 16);

fn sides_of(grid: &Grid, k: usize) -> [Side; 4] {
    let [nx, ny] = grid.n;
    let (i, j) = (k % nx, k / nx);
    // Beyond the centreline of a half all is mirrored.
    let row = |j: usize| match j < ny {
        true => j,
        false => 2 * (ny - 1) - j,
    };
    let along = |di: i64| (i as i64 + di) as usize + nx * j;
    let across = |dj: i64| match grid.is_line() {
        true => k,
        false => i + nx * row((j as i64 + dj) as usize),
    };
    let own = sides(grid, k);
    // Steps between the node behind, the node, the next one and the one beyond it.
    let ahead = |towards: bool, direction: usize| match (&grid.rows, direction) {
        (Some(rows), 1) => {
            let step = |j: i64| rows.step(row(j as usize).min(row((j + 1) as usize)));
            let j = j as i64;
            let [behind, own, beyond] = match towards {
                true => [step(j - 1), step(j), step(j + 1)],
                false => [step(j), step(j - 1), step(j - 2)],
            };
            [0.5 * own / beyond, 0.5 * own / behind]
        }
        _ => [0.5; 2],
    };
    let reach = [
        ([along(1), along(2)], along(-1)),
        ([along(-1), along(-2)], along(1)),
        ([across(1), across(2)], across(-1)),
        ([across(-1), across(-2)], across(1)),
    ];
    std::array::from_fn(|s| Side {
        direction: own[s].direction as u8,
        face: own[s].face as u32,
        weight: own[s].weight,
        next: reach[s].0.map(|k| k as u32),
        behind: reach[s].1 as u32,
        ahead: ahead(s % 2 == 0, own[s].direction),
    })
}

/// Ratios of a face's mass flow to the mean of its nodes within which the profile is scaled, and not shifted.
const SCALED: [f64; 2] = [0.5, 2.0];

/// Convection of a node at each height.
pub(super) struct Convection {
    /// Heat that it carries off per own temperature.
    pub(super) diagonal: [f64; MOST_NODES],
    /// ω.
    pub(super) up: [f64; MOST_NODES],
    /// C over the capacity.
    pub(super) value: [f64; MOST_NODES],
}

/// Nodes that a thread takes at a time.
pub(super) const BATCH: usize = 256;

impl<'a> Flow<'a> {
    /// With the mass flow of the film equation through the faces.
    pub fn new(of: &FilmHeat<'a>, columns: &'a Columns, faces: &[Vec<Face>; 2]) -> Flow<'a> {
        let (grid, heights) = (of.grid, of.heights);
        let [f, h] = columns.n;
        let mut raised = vec![AtHeights::default(); f];
        for (m, raised) in raised.iter_mut().enumerate() {
            for (l, value) in raised[..h].iter_mut().enumerate() {
                *value = heights.shapes[l][m];
            }
        }
        let all = (0..grid.n_nodes()).into_par_iter().with_min_len(BATCH);
        let sides = all.map(|k| match grid.is_unknown(k % grid.n[0], k / grid.n[0]) {
            true => sides_of(grid, k),
            false => Default::default(),
        });
        Flow {
            grid,
            heights,
            columns,
            raised,
            sides: sides.collect(),
            stored: of.stored,
            through: [0, 1].map(|d| through(grid, heights, columns, &faces[d], d)),
        }
    }

    /// R at temperatures; without convection where they are given.
    pub fn residual(&self, temperature: &[f64]) -> Vec<f64> {
        let [f, h] = self.columns.n;
        let at_heights = self.at_heights(temperature);
        let mut residual = self.columns.rows.clone();
        let nodes = residual
            .par_chunks_exact_mut(f)
            .enumerate()
            .with_min_len(BATCH);
        nodes
            .filter(|(k, _)| self.is_unknown(*k))
            .for_each(|(k, rows)| {
                let convection = self.convection(k, &temperature[k * f..][..f], &at_heights);
                let capacity = &self.columns.capacity[k * h..][..h];
                for l in 0..h {
                    let weight = self.heights.weights()[l] * capacity[l];
                    for (row, shape) in rows.iter_mut().zip(&self.heights.shapes[l]) {
                        *row += weight * shape * convection.value[l];
                    }
                }
            });
        residual
    }

    /// Whether the temperatures over a node are to be found.
    pub(super) fn is_unknown(&self, k: usize) -> bool {
        let nx = self.grid.n[0];
        self.grid.is_unknown(k % nx, k / nx)
    }

    /// Temperatures at all heights.
    pub(super) fn at_heights(&self, temperature: &[f64]) -> Vec<AtHeights> {
        let f = self.columns.n[0];
        let nodes = temperature.par_chunks_exact(f).with_min_len(BATCH);
        nodes.map(|nodes| self.raise(nodes)).collect()
    }

    /// Temperatures at the heights over a node.
    fn raise(&self, nodes: &[f64]) -> AtHeights {
        let mut values = AtHeights::default();
        for (t, raised) in nodes.iter().zip(&self.raised) {
            for (value, shape) in values.iter_mut().zip(raised) {
                *value += t * shape;
            }
        }
        values
    }

    /// ∂R/∂T of a row across the film by what arrives at a height: ∫ φ c ds.
    pub(super) fn projection(&self, k: usize, height: usize, row: usize) -> f64 {
        let h = self.columns.n[1];
        self.heights.weights()[height]
            * self.columns.capacity[k * h + height]
            * self.heights.shapes[height][row]
    }

    /// Adds the convection of a node to its equation; returns it, W/m².
    pub(super) fn add(
        &self,
        k: usize,
        convection: &Convection,
        rows: &mut [f64],
        slopes: &mut [f64],
    ) -> f64 {
        let [f, h] = self.columns.n;
        let Convection {
            diagonal,
            up,
            value,
        } = convection;
        let capacity = &self.columns.capacity[k * h..][..h];
        let mut carried = 0.0;
        for l in 0..h {
            let (shapes, [first, _]) = (&self.heights.shapes[l], &self.heights.slopes[l]);
            let weight = self.heights.weights()[l] * capacity[l];
            carried += weight * value[l];
            for a in 0..f {
                rows[a] += weight * shapes[a] * value[l];
            }
            for b in 0..f {
                let by = weight * (diagonal[l] * shapes[b] + up[l] * first[b]);
                for a in 0..f {
                    slopes[b * f + a] += shapes[a] * by;
                }
            }
        }
        carried
    }

    pub(super) fn convection(&self, k: usize, own: &[f64], at_heights: &[AtHeights]) -> Convection {
        let h = self.columns.n[1];
        let from = self.arriving(k, at_heights);
        let mut diagonal = [0.0; MOST_NODES];
        let mut up = [0.0; MOST_NODES];
        let mut outflow = 0.0;
        for side in self.sides[k].iter().filter(|side| side.weight != 0.0) {
            let flow = &self.through[usize::from(side.direction)][side.face as usize];
            for l in 0..h {
                let out = side.weight * flow[l];
                diagonal[l] += if out > 0.0 { side.ahead[1] * out } else { -out };
                outflow += self.heights.weights()[l] * out;
                for (m, up) in up[..h].iter_mut().enumerate() {
                    *up -= self.heights.below()[m][l] * out;
                }
            }
        }
        let mut value = [0.0; MOST_NODES];
        for l in 0..h {
            up[l] += (self.heights.points()[l] + 0.5) * outflow;
            let [first, _] = &self.heights.slopes[l];
            let slope: f64 = own.iter().zip(first).map(|(t, s)| t * s).sum();
            value[l] = from[l] + diagonal[l] * at_heights[k][l] + up[l] * slope;
        }
        if let Some(stored) = self.stored {
            let f = own.len();
            let past = self.raise(&stored.past[k * f..][..f]);
            for l in 0..h {
                let content = self.columns.content[k * h + l];
                diagonal[l] += content * stored.rate;
                value[l] += content * (stored.rate * at_heights[k][l] + past[l]);
            }
        }
        Convection {
            diagonal,
            up,
            value,
        }
    }

    /// Σ_f m_f T_f of the temperatures around a node, its own left out, at each height.
    #[inline(always)]
    pub(super) fn arriving(&self, k: usize, at_heights: &[AtHeights]) -> AtHeights {
        let mut sums = AtHeights::default();
        for side in &self.sides[k] {
            if side.weight == 0.0 {
                continue;
            }
            let flow = &self.through[usize::from(side.direction)][side.face as usize];
            let [next, second] = side.next.map(|n| &at_heights[n as usize]);
            let behind = &at_heights[side.behind as usize];
            let [inwards, outwards] = side.ahead;
            for l in 0..sums.len() {
                let out = side.weight * flow[l];
                sums[l] += match out > 0.0 {
                    true => -outwards * out * behind[l],
                    false => out * ((1.0 + inwards) * next[l] - inwards * second[l]),
                };
            }
        }
        sums
    }
}

/// m through the faces behind all nodes along a direction.
fn through(
    grid: &Grid,
    heights: &Heights,
    columns: &Columns,
    faces: &[Face],
    direction: usize,
) -> Vec<AtHeights> {
    let h = columns.n[1];
    let step = [1, grid.n[0]][direction];
    let n = grid.n_nodes();
    let mut through = vec![AtHeights::default(); n];
    for (k, flow) in through.iter_mut().enumerate() {
        let flow = &mut flow[..h];
        if k + step >= n {
            break;
        }
        let [here, there] = [k, k + step].map(|k| &columns.mass[k * h..][..h]);
        let mut whole = 0.0;
        for l in 0..h {
            flow[l] = 0.5 * (here[l][direction] + there[l][direction]);
            whole += heights.weights()[l] * flow[l];
        }
        let wanted = faces[k].flux;
        let ratio = wanted / whole;
        match SCALED[0] < ratio && ratio < SCALED[1] {
            true => flow.iter_mut().for_each(|m| *m *= ratio),
            false => flow.iter_mut().for_each(|m| *m += wanted - whole),
        }
    }
    through
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::volumes::rows::Rows;

    /// Rows at 0, 1, 2, 4 and 8: from the one at 2, whose face towards 4 is half of 2 away, inflow comes from 4 and 8, 4 apart, and outflow from 1, 1 behind: a = ½ · 2/4 and ½ · 2/1. Towards 1
    /// half of 1 is to be bridged: inflow from 1 and 0, ½ · 1/1, and outflow from 4, ½ · 1/2.
    #[test]
    fn uneven_steps_by_hand() {
        let rows = Rows::at(vec![0.0, 1.0, 2.0, 4.0, 8.0], false);
        let grid = Grid::of_roller([-3, 3], 0.5, rows, 2, false);
        let [.., after, before] = sides_of(&grid, grid.index(3, 2));
        assert_eq!(after.ahead, [0.25, 1.0]);
        assert_eq!(before.ahead, [0.5, 0.25]);
    }
}
