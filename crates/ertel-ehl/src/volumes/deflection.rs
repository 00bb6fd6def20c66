//! Deflection on a grid: with even rows, with those of a roller, or with the one of a line contact.
//!
//! ```text
//!   δ_i = Σ_j K_{i−j} P_j         K: influence coefficients of the cells, by the kernel of the bodies ([`super::kernel`])
//! ```

use super::convolution::Convolution;
use super::grid::Grid;
use super::inverse::{self, Stencils};
use super::kernel::Kernel;
use super::padded::Padded;
use super::rows_convolution::RowsConvolution;

/// How the bodies deflect under pressures at the nodes.
pub enum Deflection {
    /// Of a regular grid.
    Even(Convolution<f64>),
    /// Of a grid with uneven rows.
    Rows(RowsConvolution),
    /// Of the row of a line contact, with the coefficients of nodes 0, 1, … apart.
    Line(Convolution<f64>, Vec<f64>),
}

impl Deflection {
    /// Of bodies under a grid.
    pub fn new(grid: &Grid, kernel: Kernel) -> Deflection {
        if let Some(rows) = &grid.rows {
            return Deflection::Rows(RowsConvolution::new(grid, rows, kernel));
        }
        let transforms = Padded::new(grid);
        let coefficients = kernel.cells(grid.cell_size(1.0), transforms.covered());
        Deflection::of_coefficients(transforms, coefficients)
    }

    /// By influence coefficients of the cells of a regular grid or of a line: deflections by a unit pressure 0, 1, … nodes away along the rows, row by row.
    pub fn of_coefficients(transforms: Padded, coefficients: Vec<f64>) -> Deflection {
        let is_line = transforms.covered()[1] == 1;
        let symbol = transforms.of_even(&coefficients);
        let convolution = Convolution::new(transforms, symbol);
        match is_line {
            true => Deflection::Line(convolution, coefficients),
            false => Deflection::Even(convolution),
        }
    }

    /// At the nodes, under pressures there.
    pub fn apply(&self, pressure: &[f64]) -> Vec<f64> {
        match self {
            Deflection::Even(convolution) | Deflection::Line(convolution, _) => {
                convolution.apply(pressure)
            }
            Deflection::Rows(convolution) => convolution.apply(pressure),
        }
    }

    /// Nine-point stencils that are nearest to the inverse.
    pub fn stencils(&self) -> Stencils {
        match self {
            Deflection::Even(convolution) => inverse::of_grid(convolution).into(),
            Deflection::Rows(convolution) => convolution.stencils(),
            Deflection::Line(convolution, coefficients) => {
                inverse::of_line(convolution.transforms(), coefficients).into()
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use approx::assert_relative_eq;

    use super::*;
    use crate::contact::{HertzZone, Turn};
    use crate::elastic::LINE_REFERENCE;
    use crate::volumes::line_factors::{LineFactors, LineKernel, Triple};

    const C: f64 = 0.7;
    const BODIES: Kernel = Kernel::HalfSpace { compliance: C };

    fn grid(h: f64, half: bool) -> Grid {
        let zone = HertzZone {
            axis_ratio: 1.0,
            turn: Turn::NONE,
            roller: None,
        };
        Grid::covering([[-1.5, 1.25], [-1.5, 1.5]], [h; 2], half, &zone)
    }

    /// Pressures without any symmetry.
    fn rough(grid: &Grid, phase: f64) -> Vec<f64> {
        (0..grid.n_nodes())
            .map(|k| 1.0 + (1.7 * k as f64 + phase).sin())
            .collect()
    }

    /// Hertz's pressure √(1 − r²) deflects half-spaces by C π/4 (2 − r²) within the circle (Johnson 1985, eq. 3.41a); the error falls with
    /// the power 1.5 of the cell at least, as the pressure ends with a square root. A half with its mirror image is the whole.
    #[test]
    fn deflection_under_hertz_pressure() {
        let error = |h: f64, half: bool| {
            let grid = grid(h, half);
            let pressure: Vec<f64> = (grid.nodes())
                .map(|[i, j]| {
                    let [x, y] = grid.on_axes(i, j);
                    (1.0 - x * x - y * y).max(0.0).sqrt()
                })
                .collect();
            let deflection = Deflection::new(&grid, BODIES).apply(&pressure);
            let errors = grid.nodes().zip(deflection).map(|([i, j], found)| {
                let [x, y] = grid.on_axes(i, j);
                let r2 = x * x + y * y;
                match r2 < 0.9 {
                    true => (found - C * PI / 4.0 * (2.0 - r2)).abs(),
                    false => 0.0,
                }
            });
            errors.fold(0.0, f64::max)
        };
        let errors = [0.125, 0.0625, 0.03125].map(|h| error(h, true));
        assert!(errors[2] < 1e-3, "{errors:?}");
        assert!(errors[0] > 6.0 * errors[2], "{errors:?}");
        assert_relative_eq!(errors[1], error(0.0625, false), max_relative = 1e-6);
    }

    /// Hertz's pressure √(1 − x²) deflects by C (ln 2d + ½ − x²) within |x| < 1 (Johnson 1985, section 4.2c); the error falls with the power 1.5 of the cell at least, as the
    /// pressure ends with a square root. Far away it deflects as the line load π/2 with its second moment: −C (ln(|x|/d) − 1/8x²).
    #[test]
    fn line_under_hertz_pressure() {
        let error = |h: f64| {
            let reach = (8.0 / h) as i64;
            let grid = Grid::of_line([-reach, reach], h);
            let x = |i: usize| grid.on_axes(i, 0)[0];
            let pressure: Vec<f64> = (0..grid.n[0])
                .map(|i| (1.0 - x(i) * x(i)).max(0.0).sqrt())
                .collect();
            let deflection = Deflection::new(&grid, BODIES).apply(&pressure);
            let [centre, _] = grid.centre();
            // At the middle −2C/π ∫ √(1 − x²) ln(|x|/d) dx = C (ln 2d + ½).
            let middle = C * ((2.0 * LINE_REFERENCE).ln() + 0.5);
            let inside = (0..grid.n[0]).filter(|i| x(*i).abs() < 0.95);
            let errors = inside.map(|i| (deflection[i] - middle + C * x(i) * x(i)).abs());
            let far = deflection[2 * centre];
            let by_hand = -C * ((8.0 / LINE_REFERENCE).ln() - 1.0 / (8.0 * 64.0));
            assert_relative_eq!(far, by_hand, max_relative = 0.5 * h.powf(1.5));
            errors.fold(0.0, f64::max)
        };
        let errors = [0.125, 0.0625, 0.03125].map(error);
        assert!(errors[2] < 0.01, "{errors:?}");
        assert!(errors[0] > 6.0 * errors[2], "{errors:?}");
    }

    /// Coefficients computed elsewhere: a foundation of springs (Winkler: Johnson 1985, section 4.3), p = kδ, has one that is not zero. It deflects by p/k at each node, its stencil
    /// is k and nothing else, and the factors of a line solve rows of a film equation, whose matrix has three diagonals then.
    #[test]
    fn a_foundation_of_springs() {
        let k = 3.7;
        let springs = |grid: &Grid| {
            let transforms = Padded::new(grid);
            let mut coefficients = vec![0.0; transforms.covered().iter().product()];
            coefficients[0] = 1.0 / k;
            Deflection::of_coefficients(transforms, coefficients)
        };
        let line = Grid::of_line([-150, 149], 0.01);
        for grid in [grid(0.125, false), grid(0.125, true), line.clone()] {
            let deflection = springs(&grid);
            let pressure = rough(&grid, 0.0);
            for (found, p) in deflection.apply(&pressure).iter().zip(&pressure) {
                assert_relative_eq!(*found, p / k, epsilon = 1e-14);
            }
            let [centre, others @ ..] = *deflection.stencils().of(0);
            assert_relative_eq!(centre, k, max_relative = 1e-12);
            assert!(
                others.iter().all(|weight| weight.abs() < 1e-12),
                "{others:?}"
            );
        }
        let Deflection::Line(_, coefficients) = springs(&line) else {
            panic!("no line");
        };
        let n = 296;
        let kernel = LineKernel::new(&coefficients, n);
        let row = Triple {
            by_pressure: [-1.0, 2.2, -1.1],
            by_film: [-3.0, 4.0, 0.5],
        };
        let known = &rough(&line, 0.3)[..n];
        let mut b: Vec<f64> = (0..n as i64)
            .map(|i| {
                let at = |d: usize| known.get((i + d as i64 - 1) as usize).unwrap_or(&0.0);
                (0..3)
                    .map(|d| (row.by_pressure[d] + row.by_film[d] / k) * at(d))
                    .sum()
            })
            .collect();
        let factors = LineFactors::new(&kernel, &vec![row; n]).unwrap();
        factors.solve(&mut b);
        for (found, known) in b.iter().zip(known) {
            assert_relative_eq!(*found, *known, max_relative = 1e-9);
        }
    }

    /// ∫∫ dA/r over a rectangle about (x, y) by logarithms, as Love (1929) has it.
    fn love([x, y]: [f64; 2], [dx, dy]: [f64; 2]) -> f64 {
        let corner = |x: f64, y: f64| {
            let r = x.hypot(y);
            x * (y + r).ln() + y * (x + r).ln()
        };
        let [west, east] = [x - 0.5 * dx, x + 0.5 * dx];
        let [south, north] = [y - 0.5 * dy, y + 0.5 * dy];
        corner(east, north) - corner(west, north) - corner(east, south) + corner(west, south)
    }

    /// Coefficients by another form of the closed one give the deflection of half-spaces; those of springs in series add up. What pressures do to each other is mutual: the operator is its
    /// own transpose.
    #[test]
    fn coefficients_of_another_source() {
        let k = 2.3;
        let grid = grid(0.125, false);
        let transforms = Padded::new(&grid);
        let [nx, ny] = transforms.covered();
        let mut coefficients: Vec<f64> = (0..ny)
            .flat_map(|j| (0..nx).map(move |i| [i, j]))
            .map(|at| C / PI * love(at.map(|n| 0.125 * n as f64), grid.spacing))
            .collect();
        coefficients[0] += 1.0 / k;
        let layered = Deflection::of_coefficients(transforms, coefficients);
        let [p, q] = [0.0, 0.4].map(|phase| rough(&grid, phase));
        let by_p = layered.apply(&p);
        let half_spaces = Deflection::new(&grid, BODIES).apply(&p);
        for ((found, own), p) in by_p.iter().zip(half_spaces).zip(&p) {
            assert_relative_eq!(*found, own + p / k, max_relative = 1e-11);
        }
        let product = |a: &[f64], b: &[f64]| -> f64 { a.iter().zip(b).map(|(a, b)| a * b).sum() };
        let mutual = product(&layered.apply(&q), &p);
        assert_relative_eq!(product(&by_p, &q), mutual, max_relative = 1e-13);
    }
}
