//! Loads on a body, and its stresses in planes of constant depth, as they pass along x.

use rayon::prelude::*;

use super::depths::{crest, place};
use super::grid::{GridLoad, Planes};
use super::layered::{PlaneResponse, Response};
use super::{HertzLoad, LineLoad, Stress};

/// Pressure and shear on a body.
#[derive(Clone, Debug)]
pub enum Load {
    /// A line contact.
    Line(LineLoad),
    /// A contact on a grid.
    Grid(GridLoad),
    /// A dry contact in closed form, in the plane y = 0; that of a line has layers, others have none.
    Hertz(HertzLoad),
}

/// A value with its place in a plane.
#[derive(Clone, Copy, Debug, Default)]
pub struct Peak {
    /// The value.
    pub value: f64,
    /// Where along the motion.
    pub x: f64,
    /// Where across.
    pub y: f64,
}

/// Shear that a row of points sees while the contact passes.
#[derive(Clone, Copy, Debug, Default)]
pub struct RowShear {
    /// Half the range of σ_xz.
    pub half_range: f64,
    /// Mean of its extremes.
    pub mean: f64,
    /// Largest shear stress in the plane of motion.
    pub largest: f64,
}

/// A plane of constant depth, reduced to what is reported.
#[derive(Clone, Debug)]
pub struct Level {
    /// Largest stress after von Mises.
    pub von_mises: Peak,
    /// Largest shear stress.
    pub largest_shear: Peak,
    /// Largest principal stress.
    pub tension: Peak,
    /// Largest shear on the plane.
    pub shear: Peak,
    /// Largest σ_zz: the tension across the plane.
    pub pull: Peak,
    /// Half the largest range of σ_xz over a passage; x where σ_xz is largest in size.
    pub half_range: Peak,
    /// The same in the middle row.
    pub middle_range: Peak,
    /// Largest |σ_xz| of the middle row.
    pub middle_orthogonal: f64,
    /// Shear row by row.
    pub rows: Vec<RowShear>,
    /// Stresses at all points, row by row.
    pub stresses: Vec<Stress>,
}

impl Load {
    /// Stresses at all depths below x of a line or of a dry contact; none of a grid.
    pub(super) fn column(&self, x: f64, response: &Response) -> Vec<Stress> {
        match self {
            Load::Line(load) => response.line(|z| load.potentials(x, z)),
            Load::Hertz(load) if load.half_width_y.is_none() => {
                response.line(|z| load.potentials(x, z))
            }
            Load::Hertz(load) => {
                let at = |plane: &PlaneResponse| {
                    let poisson = plane.poisson;
                    HertzLoad { poisson, ..*load }.at(x, 0.0, plane.depth)
                };
                response.planes.iter().map(at).collect()
            }
            Load::Grid(_) => Vec::new(),
        }
    }

    /// Rows of points across the motion.
    pub fn rows(&self) -> Vec<f64> {
        match self {
            Load::Grid(load) => load.centres[1].clone(),
            _ => vec![0.0],
        }
    }

    /// The levels at all depths; `x`: the points of a row, of a grid its own.
    pub fn levels(&self, x: &[f64], response: &Response) -> Vec<Level> {
        let (planes, rows) = (response.planes.len(), self.rows());
        if let Load::Grid(load) = self {
            let stresses = Planes::new(load, response);
            return (0..planes)
                .into_par_iter()
                .map(|plane| Level::new(x, &rows, stresses.at(plane)))
                .collect();
        }
        let columns: Vec<Vec<Stress>> = (x.par_iter()).map(|x| self.column(*x, response)).collect();
        (0..planes)
            .into_par_iter()
            .map(|plane| {
                let row = columns.iter().map(|column| column[plane]);
                Level::new(x, &rows, row.collect())
            })
            .collect()
    }
}

impl Level {
    /// Largest stress after von Mises with a residual stress everywhere.
    pub(super) fn von_mises_with(&self, residual: Stress) -> f64 {
        let rows = (0..self.rows.len()).map(|j| self.row(j));
        let of_row = |row: &[Stress]| crest(row.len(), |i| (row[i] + residual).von_mises()).0;
        let rows: Vec<f64> = rows.map(of_row).collect();
        crest(rows.len(), |j| rows[j]).0
    }

    /// Stresses along the middle row.
    pub fn middle(&self) -> &[Stress] {
        self.row(self.rows.len() / 2)
    }

    /// Stresses along a row.
    pub fn row(&self, j: usize) -> &[Stress] {
        let n = self.stresses.len() / self.rows.len();
        &self.stresses[j * n..(j + 1) * n]
    }

    fn new(x: &[f64], y: &[f64], stresses: Vec<Stress>) -> Level {
        let n = x.len();
        let row = |j: usize| &stresses[j * n..(j + 1) * n];
        let of = |f: &dyn Fn(&Stress) -> f64| {
            let values: Vec<f64> = stresses.iter().map(f).collect();
            peak(x, y, &values)
        };
        let orthogonal = of(&|s| s.xz().abs());
        let rows: Vec<RowShear> = (0..y.len())
            .map(|j| {
                let (high, _) = crest(n, |i| row(j)[i].xz());
                let (low, _) = crest(n, |i| -row(j)[i].xz());
                RowShear {
                    half_range: 0.5 * (high + low),
                    mean: 0.5 * (high - low),
                    largest: crest(n, |i| row(j)[i].shear_in_plane()).0,
                }
            })
            .collect();
        let middle = y.len() / 2;
        let (middle_orthogonal, along) = crest(n, |i| row(middle)[i].xz().abs());
        let (value, t) = crest(y.len(), |j| rows[j].half_range);
        Level {
            von_mises: of(&Stress::von_mises),
            largest_shear: of(&Stress::largest_shear),
            tension: of(&|s| s.principal()[0]),
            shear: of(&|s| s.0[4].hypot(s.0[5])),
            pull: of(&|s| s.0[2]),
            half_range: Peak {
                value,
                x: orthogonal.x,
                y: place(y, t),
            },
            middle_range: Peak {
                value: rows[middle].half_range,
                x: place(x, along),
                y: y[middle],
            },
            middle_orthogonal,
            rows,
            stresses,
        }
    }
}

/// The largest value of a plane, by parabolas along both directions.
fn peak(x: &[f64], y: &[f64], values: &[f64]) -> Peak {
    let n = x.len();
    let crests: Vec<(f64, f64)> = (0..y.len())
        .map(|j| crest(n, |i| values[j * n + i]))
        .collect();
    let (value, t) = crest(y.len(), |j| crests[j].0);
    let (_, along) = crests[t.round() as usize];
    Peak {
        value,
        x: place(x, along),
        y: place(y, t),
    }
}
