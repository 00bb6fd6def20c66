//! Half-space under loads on the cells of a regular grid.
//!
//! In planes of constant depth by fast Fourier transforms: the stresses are those of uniform loads on the cells, seen from their centres, so that a convolution over
//! twice the lengths is exact and has no periodic images (Liu and Wang 2002). Layers add images to the closed forms of a cell ([`super::layered`]).

use std::sync::Arc;

use realfft::num_complex::Complex64;
use realfft::{ComplexToReal, RealFftPlanner, RealToComplex};
use rustfft::Fft;

use rayon::prelude::*;

use super::Stress;
use super::layered::Response;
use super::rectangle::{Image, PARITY, corner, image, images};

/// Pressure and shear, uniform on each cell of a grid.
#[derive(Clone, Debug)]
pub struct GridLoad {
    /// Centres of the cells along x and along y, equally spaced.
    pub centres: [Vec<f64>; 2],
    /// Pressure, and shear on the body along x and along y, `[j * nx + i]`; all may be zero.
    pub values: [Vec<f64>; 3],
}

impl GridLoad {
    /// Number of cells along x and along y.
    pub fn n(&self) -> [usize; 2] {
        [self.centres[0].len(), self.centres[1].len()]
    }

    /// Lengths of a cell.
    pub fn spacing(&self) -> [f64; 2] {
        [0, 1].map(|axis: usize| {
            let centres = &self.centres[axis];
            (centres[centres.len() - 1] - centres[0]) / (centres.len() - 1) as f64
        })
    }
}

/// The corners of a quadrant of cells, from the centre of the first one.
fn corners(load: &GridLoad) -> Vec<[f64; 2]> {
    let ([nx, ny], [dx, dy]) = (load.n(), load.spacing());
    let row = |j: usize| (0..=nx).map(move |i| [(i as f64 - 0.5) * dx, (j as f64 - 0.5) * dy]);
    (0..=ny).flat_map(row).collect()
}

/// The next length at least as large that transforms fast.
fn smooth(least: usize) -> usize {
    let is_smooth = |n: &usize| {
        let rest = [2, 3, 5].into_iter().fold(*n, |mut n, p| {
            while n % p == 0 {
                n /= p;
            }
            n
        });
        rest == 1
    };
    (least..).find(is_smooth).unwrap_or(least)
}

/// Stresses in planes of constant depth under a load.
pub struct Planes<'a> {
    load: &'a GridLoad,
    response: &'a Response,
    /// The images seen from the corners of a quadrant of cells, one row of them per corner.
    images: Vec<Image>,
    /// Transformed lengths: even, and at least twice those of the grid.
    padded: [usize; 2],
    forward: Arc<dyn RealToComplex<f64>>,
    backward: Arc<dyn ComplexToReal<f64>>,
    along: [Arc<dyn Fft<f64>>; 2],
    /// Loads that are not zero, transformed.
    loads: Vec<(usize, Vec<Complex64>)>,
}

impl<'a> Planes<'a> {
    /// Of a body.
    pub fn new(load: &'a GridLoad, response: &'a Response) -> Planes<'a> {
        let [nx, ny] = load.n();
        let seen = corners(load).into_par_iter();
        let images =
            seen.flat_map_iter(|[x, y]| response.images.iter().map(move |z| image(x, y, *z)));
        let padded = [2 * smooth(nx), 2 * smooth(ny)];
        let mut real = RealFftPlanner::<f64>::new();
        let mut complex = rustfft::FftPlanner::<f64>::new();
        let mut planes = Planes {
            load,
            images: images.collect(),
            response,
            padded,
            forward: real.plan_fft_forward(padded[0]),
            backward: real.plan_fft_inverse(padded[0]),
            along: [
                complex.plan_fft_forward(padded[1]),
                complex.plan_fft_inverse(padded[1]),
            ],
            loads: Vec::new(),
        };
        let scale = 1.0 / (padded[0] * padded[1]) as f64;
        for (which, values) in load.values.iter().enumerate() {
            if values.iter().any(|v| *v != 0.0) {
                let transform = planes.transformed(|j, row| {
                    if j >= ny {
                        return false;
                    }
                    for (row, value) in row.iter_mut().zip(&values[j * nx..(j + 1) * nx]) {
                        *row = scale * value;
                    }
                    true
                });
                planes.loads.push((which, transform));
            }
        }
        planes
    }

    /// Transform of rows that are filled in one after the other, one line of `padded[1]` for each wave along the rows; rows that are not filled are zero.
    fn transformed(&self, fill: impl Fn(usize, &mut [f64]) -> bool) -> Vec<Complex64> {
        let [px, py] = self.padded;
        let waves = px / 2 + 1;
        let mut lines = vec![Complex64::default(); waves * py];
        let mut row = self.forward.make_input_vec();
        let mut out = self.forward.make_output_vec();
        for j in 0..py {
            row.fill(0.0);
            if fill(j, &mut row) {
                (self.forward.process(&mut row, &mut out)).expect("lengths agree");
                for (k, value) in out.iter().enumerate() {
                    lines[k * py + j] = *value;
                }
            }
        }
        self.along[0].process(&mut lines);
        lines
    }

    /// Transform of the stress `component` under a unit load on one cell, from its values in a quadrant.
    fn kernel(&self, quadrant: &[f64], [by_x, by_y]: [f64; 2]) -> Vec<Complex64> {
        let ([nx, ny], [px, py]) = (self.load.n(), self.padded);
        self.transformed(|j, row| {
            let (from, sign) = match (j < ny, py - j < ny) {
                (true, _) => (j, 1.0),
                (_, true) => (py - j, by_y),
                _ => return false,
            };
            for (i, value) in quadrant[from * nx..(from + 1) * nx].iter().enumerate() {
                row[i] = sign * value;
                if i > 0 {
                    row[px - i] = sign * by_x * value;
                }
            }
            true
        })
    }

    /// Stresses under the centres of the cells in a plane of the depths, `[j * nx + i]`.
    pub fn at(&self, plane: usize) -> Vec<Stress> {
        let [nx, ny] = self.load.n();
        let plane = &self.response.planes[plane];
        let n_images = self.response.images.len();
        let corners: Vec<[[f64; 6]; 3]> = (corners(self.load).into_iter().enumerate())
            .map(|(i, [x, y])| {
                let own = corner(x, y, plane.depth, plane.poisson);
                let seen = &self.images[i * n_images..(i + 1) * n_images];
                let more = images(seen.iter().zip(&plane.weights), plane.poisson);
                std::array::from_fn(|load| {
                    std::array::from_fn(|component| own[load][component] + more[load][component])
                })
            })
            .collect();
        let mut stresses = vec![Stress::default(); nx * ny];
        let mut quadrant = vec![0.0; nx * ny];
        for component in 0..6 {
            let mut sum: Vec<Complex64> = Vec::new();
            for (which, load) in &self.loads {
                let at = |i: usize, j: usize| corners[j * (nx + 1) + i][*which][component];
                for (cell, value) in quadrant.iter_mut().enumerate() {
                    let (i, j) = (cell % nx, cell / nx);
                    *value = at(i + 1, j + 1) - at(i, j + 1) - at(i + 1, j) + at(i, j);
                }
                let signs = [0, 1].map(|axis: usize| PARITY[*which][axis][component]);
                let mut product = self.kernel(&quadrant, signs);
                for (value, load) in product.iter_mut().zip(load) {
                    *value *= load;
                }
                match sum.is_empty() {
                    true => sum = product,
                    false => sum.iter_mut().zip(product).for_each(|(s, p)| *s += p),
                }
            }
            self.put(&mut sum, component, &mut stresses);
        }
        stresses
    }

    /// One component from its waves.
    fn put(&self, lines: &mut [Complex64], component: usize, stresses: &mut [Stress]) {
        if lines.is_empty() {
            return;
        }
        let ([nx, ny], [px, py]) = (self.load.n(), self.padded);
        self.along[1].process(lines);
        let mut waves = self.backward.make_input_vec();
        let mut row = self.backward.make_output_vec();
        for j in 0..ny {
            for (k, wave) in waves.iter_mut().enumerate() {
                *wave = lines[k * py + j];
            }
            // Real by symmetry, up to rounding.
            waves[0].im = 0.0;
            waves[px / 2].im = 0.0;
            (self.backward.process(&mut waves, &mut row)).expect("lengths agree");
            for (i, value) in row[..nx].iter().enumerate() {
                stresses[j * nx + i].0[component] = *value;
            }
        }
    }
}
