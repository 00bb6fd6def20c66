//! Polynomials across the film, through their values at its nodes.
//!
//! Nodes are those of Gauss and Lobatto: both walls are among them. A quantity that varies smoothly across
//! the film is interpolated from its values there with spectral accuracy.

use ertel_fem::quadrature::Quadrature;
use nalgebra::DMatrix;

use super::lanes::Lanes;

/// Most nodes across the film.
pub const MOST_NODES: usize = 13;

/// Values at the nodes across the film, plane first; those beyond the last node are zero.
pub type Nodal = [f64; MOST_NODES];

/// Coefficients of a polynomial, rounded up to whole vectors, and of one that most films need.
const LENGTH: usize = 16;
const COMMON: usize = 12;
const _: () = assert!(LENGTH > MOST_NODES);

/// Polynomial in s, −½ (body 1) ≤ s ≤ ½ (body 2).
#[derive(Clone, Copy, Debug, Default)]
pub struct Polynomial {
    /// Coefficients of powers of 2s.
    coefficients: [f64; LENGTH],
    /// Number of them in use.
    n: usize,
}

impl Polynomial {
    /// The constant `value`.
    pub fn constant(value: f64) -> Polynomial {
        let mut coefficients = [0.0; LENGTH];
        coefficients[0] = value;
        Polynomial { coefficients, n: 1 }
    }

    /// Value at s.
    #[inline(always)]
    pub fn at(&self, s: f64) -> f64 {
        let x = 2.0 * s;
        let coefficients = self.coefficients[..self.n].iter().rev();
        coefficients.fold(0.0, |sum, c| sum * x + c)
    }

    /// Values at several s.
    #[inline(always)]
    pub fn at_lanes(&self, s: Lanes) -> Lanes {
        let x = s * 2.0;
        let coefficients = self.coefficients[..self.n].iter().rev();
        coefficients.fold(Lanes::default(), |sum, c| sum * x + Lanes::all(*c))
    }

    /// The polynomial plus a constant.
    #[inline(always)]
    pub fn plus(mut self, value: f64) -> Polynomial {
        self.coefficients[0] += value;
        self.n = self.n.max(1);
        self
    }
}

/// The nodes across the film.
#[derive(Clone, Debug)]
pub struct FilmNodes {
    /// s of each node, −½ first.
    points: Vec<f64>,
    /// Weights of the mean over the film.
    weights: Vec<f64>,
    /// Coefficients of each node's shape function.
    shapes: Vec<Polynomial>,
    /// ∫_s^½ of each shape function.
    above: Vec<Polynomial>,
}

impl FilmNodes {
    /// Nodes of polynomials of an order from 1 to [`MOST_NODES`] − 1.
    pub fn new(order: usize) -> FilmNodes {
        assert!((1..MOST_NODES).contains(&order));
        FilmNodes::at(&lobatto(order + 1))
    }

    /// The n Gauss points across the film instead, n up to [`MOST_NODES`].
    pub fn gauss(n: usize) -> FilmNodes {
        let rule = Quadrature::simplex(1, 2 * n - 1);
        let x: Vec<f64> = rule.points.iter().map(|x| 2.0 * x[0] - 1.0).collect();
        assert!(x.len() == n && n <= MOST_NODES);
        FilmNodes::at(&x)
    }

    /// Nodes at some points of [−1, 1].
    fn at(x: &[f64]) -> FilmNodes {
        let n = x.len();
        let powers = DMatrix::from_fn(n, n, |i, k| x[i].powi(k as i32));
        let inverse = powers.try_inverse().expect("nodes are distinct");
        let shape = |m: usize| {
            let mut p = Polynomial::constant(0.0);
            p.n = n;
            for k in 0..n {
                p.coefficients[k] = inverse[(k, m)];
            }
            p
        };
        let shapes: Vec<Polynomial> = (0..n).map(shape).collect();
        let above = |p: &Polynomial| {
            // ds = dx/2
            let mut integral = Polynomial::constant(0.0);
            integral.n = n + 1;
            for k in 0..n {
                let c = 0.5 * p.coefficients[k] / (k + 1) as f64;
                integral.coefficients[k + 1] = -c;
                integral.coefficients[0] += c;
            }
            integral
        };
        let above: Vec<Polynomial> = shapes.iter().map(above).collect();
        FilmNodes {
            points: x.iter().map(|x| 0.5 * x).collect(),
            weights: above.iter().map(|p| p.at(-0.5)).collect(),
            shapes,
            above,
        }
    }

    /// Number of nodes.
    pub fn n(&self) -> usize {
        self.points.len()
    }

    /// s of each node, −½ (body 1) first.
    pub fn points(&self) -> &[f64] {
        &self.points
    }

    /// Weights of the mean over the film.
    pub fn weights(&self) -> &[f64] {
        &self.weights
    }

    /// Mean over the film.
    #[inline(always)]
    pub fn mean(&self, values: &Nodal) -> f64 {
        self.weights.iter().zip(values).map(|(w, v)| w * v).sum()
    }

    /// Polynomial through values at the nodes.
    #[inline(always)]
    pub fn through(&self, values: &Nodal) -> Polynomial {
        combine(&self.shapes, values)
    }

    /// ∫_s^½ of that polynomial.
    #[inline(always)]
    pub fn above(&self, values: &Nodal) -> Polynomial {
        combine(&self.above, values)
    }

    /// Shape functions at s.
    pub fn shapes_at(&self, s: f64) -> Nodal {
        let mut values = [0.0; MOST_NODES];
        for (value, shape) in values.iter_mut().zip(&self.shapes) {
            *value = shape.at(s);
        }
        values
    }

    /// First and second derivatives of the shape functions by s.
    pub fn slopes_at(&self, s: f64) -> [Nodal; 2] {
        let mut slopes = [[0.0; MOST_NODES]; 2];
        let x = 2.0 * s;
        for (m, shape) in self.shapes.iter().enumerate() {
            for k in (1..shape.n).rev() {
                let c = shape.coefficients[k] * k as f64;
                slopes[0][m] += 2.0 * c * x.powi(k as i32 - 1);
                if k > 1 {
                    slopes[1][m] += 4.0 * c * (k - 1) as f64 * x.powi(k as i32 - 2);
                }
            }
        }
        slopes
    }
}

#[inline(always)]
fn combine(basis: &[Polynomial], values: &Nodal) -> Polynomial {
    let n = basis[0].n;
    Polynomial {
        coefficients: match n {
            0..=COMMON => sum::<COMMON>(basis, values),
            _ => sum::<LENGTH>(basis, values),
        },
        n,
    }
}

/// Sum of the first N coefficients.
#[inline(always)]
fn sum<const N: usize>(basis: &[Polynomial], values: &Nodal) -> [f64; LENGTH] {
    let mut sum = [0.0; N];
    for (p, value) in basis.iter().zip(values) {
        for k in 0..N {
            sum[k] += value * p.coefficients[k];
        }
    }
    let mut coefficients = [0.0; LENGTH];
    coefficients[..N].copy_from_slice(&sum);
    coefficients
}

/// The n points of Gauss and Lobatto on [−1, 1]: the ends and the extrema of Legendre's polynomial of order
/// n − 1, by Newton's method on (1 − x²)P'.
fn lobatto(n: usize) -> Vec<f64> {
    let order = n - 1;
    let mut x: Vec<f64> = (0..n)
        .map(|i| -(std::f64::consts::PI * i as f64 / order as f64).cos())
        .collect();
    for x in &mut x {
        for _ in 0..100 {
            let (mut before, mut p) = (1.0, *x);
            for k in 2..=order {
                let next = ((2 * k - 1) as f64 * *x * p - (k - 1) as f64 * before) / k as f64;
                (before, p) = (p, next);
            }
            let step = (*x * p - before) / (n as f64 * p);
            *x -= step;
            if step.abs() < 1e-16 {
                break;
            }
        }
    }
    x
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Published nodes and weights (Abramowitz and Stegun 1964, table 25.6): five points at 0, √(3/7), 1 with
    /// weights 32/45, 49/90, 1/10.
    #[test]
    fn five_nodes() {
        let nodes = FilmNodes::new(4);
        let inner = (3.0_f64 / 7.0).sqrt();
        for (s, x) in nodes.points().iter().zip([-1.0, -inner, 0.0, inner, 1.0]) {
            assert_relative_eq!(2.0 * s, x, epsilon = 1e-14);
        }
        let weights = [0.1, 49.0 / 90.0, 32.0 / 45.0, 49.0 / 90.0, 0.1];
        for (m, w) in weights.into_iter().enumerate() {
            let mut unit = [0.0; MOST_NODES];
            unit[m] = 1.0;
            assert_relative_eq!(2.0 * nodes.mean(&unit), w, epsilon = 1e-13);
        }
    }

    /// Weights of Gauss points are those of the library's rule, for every number of them.
    #[test]
    fn gauss_weights() {
        for n in 1..=MOST_NODES {
            let rule = Quadrature::simplex(1, 2 * n - 1);
            let nodes = FilmNodes::gauss(n);
            for ((w, exact), (s, x)) in (nodes.weights().iter().zip(&rule.weights))
                .zip(nodes.points().iter().zip(&rule.points))
            {
                assert_relative_eq!(w, exact, epsilon = 1e-10);
                assert_relative_eq!(*s, x[0] - 0.5, epsilon = 1e-14);
            }
        }
    }

    /// e^{3s}: value, slopes and integral above s, at the highest order.
    #[test]
    fn spectral_accuracy() {
        let nodes = FilmNodes::new(MOST_NODES - 1);
        let mut values = [0.0; MOST_NODES];
        for (v, s) in values.iter_mut().zip(nodes.points()) {
            *v = (3.0 * s).exp();
        }
        let (p, above) = (nodes.through(&values), nodes.above(&values));
        for s in [-0.5, -0.31, 0.0, 0.2, 0.5_f64] {
            let e = (3.0 * s).exp();
            assert_relative_eq!(p.at(s), e, max_relative = 1e-10);
            assert_relative_eq!(above.at(s), (1.5_f64.exp() - e) / 3.0, epsilon = 1e-10);
            let dot = |basis: Nodal| -> f64 { basis.iter().zip(&values).map(|(b, v)| b * v).sum() };
            assert_relative_eq!(dot(nodes.shapes_at(s)), e, max_relative = 1e-10);
            let [first, second] = nodes.slopes_at(s);
            assert_relative_eq!(dot(first), 3.0 * e, max_relative = 1e-8);
            assert_relative_eq!(dot(second), 9.0 * e, max_relative = 1e-6);
        }
    }
}
