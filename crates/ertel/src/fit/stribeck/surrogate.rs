//! Functions of one or two unknowns that are expensive to evaluate, as polynomials over a range.
//!
//! ```text
//!   f(x) = Σ c_ij T_i(ξ) T_j(η),  i + j ≤ n,   ξ, η from −1 to 1 over the range      T: Chebyshev's polynomials
//! ```
//! c by least squares of the values at Chebyshev's points, which keep the largest error of the polynomial near its smallest (Trefethen 2013, Approximation
//! Theory and Approximation Practice, chapters 2 and 15).

use std::f64::consts::PI;

use faer::Mat;

/// Where the unknowns are searched.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Range {
    /// Its middle, by unknown.
    pub centre: Vec<f64>,
    /// Its half-width, the same of all unknowns.
    pub half_width: f64,
}

impl Range {
    /// Chebyshev's points, `n` of each unknown, in all combinations.
    pub(super) fn nodes(&self, n: usize) -> Vec<Vec<f64>> {
        let points: Vec<f64> = (0..n)
            .map(|i| (PI * (2 * i + 1) as f64 / (2 * n) as f64).cos())
            .collect();
        self.lattice(&points)
    }

    /// All combinations of places from −1 to 1 of each unknown.
    pub(super) fn lattice(&self, places: &[f64]) -> Vec<Vec<f64>> {
        let mut all = vec![Vec::new()];
        for centre in &self.centre {
            let longer = |start: &Vec<f64>| {
                let ends = places.iter().map(|t| centre + t * self.half_width);
                ends.map(|end| [start.as_slice(), &[end]].concat())
                    .collect::<Vec<_>>()
            };
            all = all.iter().flat_map(longer).collect();
        }
        all
    }

    /// Place in the range, each from −1 to 1.
    pub(super) fn place(&self, x: &[f64]) -> Vec<f64> {
        let place = |(x, centre): (&f64, &f64)| (x - centre) / self.half_width;
        x.iter().zip(&self.centre).map(place).collect()
    }

    /// T_i(ξ) T_j(η) with i + j up to the degree.
    fn basis(&self, x: &[f64], degree: usize) -> Vec<f64> {
        let mut products = vec![(0, 1.0)];
        for t in self.place(x) {
            let mut values = vec![1.0, t];
            for i in 2..=degree {
                values.push(2.0 * t * values[i - 1] - values[i - 2]);
            }
            let longer = |(order, value): &(usize, f64)| {
                let ends = values.iter().enumerate().take(degree + 1 - order);
                ends.map(|(i, t)| (order + i, value * t))
                    .collect::<Vec<_>>()
            };
            products = products.iter().flat_map(longer).collect();
        }
        products.into_iter().map(|(_, value)| value).collect()
    }
}

/// Several functions over one range.
#[derive(Clone, Debug)]
pub(super) struct Surrogate {
    range: Range,
    degree: usize,
    /// By function.
    coefficients: Vec<Vec<f64>>,
}

impl Surrogate {
    /// Through the values of the functions, by node, then function; `None` where the nodes are too few for the degree.
    pub(super) fn new(
        range: &Range,
        degree: usize,
        nodes: &[Vec<f64>],
        values: &[Vec<f64>],
    ) -> Option<Surrogate> {
        let rows: Vec<Vec<f64>> = nodes.iter().map(|x| range.basis(x, degree)).collect();
        let n = range.basis(&range.centre, degree).len();
        if rows.len() < n {
            return None;
        }
        let svd = Mat::from_fn(rows.len(), n, |i, j| rows[i][j])
            .thin_svd()
            .ok()?;
        let (singular, u, v) = (svd.S().column_vector(), svd.U(), svd.V());
        if singular[n - 1] <= 1e-9 * singular[0] {
            return None;
        }
        let coefficients = |function: usize| {
            let parts: Vec<f64> = (0..n)
                .map(|k| {
                    let along = values.iter().enumerate();
                    along.map(|(i, at)| u[(i, k)] * at[function]).sum::<f64>() / singular[k]
                })
                .collect();
            (0..n)
                .map(|j| (0..n).map(|k| v[(j, k)] * parts[k]).sum())
                .collect::<Vec<f64>>()
        };
        let n_functions = values.first().map_or(0, Vec::len);
        Some(Surrogate {
            range: range.clone(),
            degree,
            coefficients: (0..n_functions).map(coefficients).collect(),
        })
    }

    /// The functions.
    pub(super) fn at(&self, x: &[f64]) -> Vec<f64> {
        let basis = self.range.basis(x, self.degree);
        let value = |own: &Vec<f64>| own.iter().zip(&basis).map(|(c, t)| c * t).sum();
        self.coefficients.iter().map(value).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Polynomials of the degree are met exactly, of one unknown and of two, also without one of the nodes.
    #[test]
    fn polynomials_are_met() {
        let range = Range {
            centre: vec![1.0],
            half_width: 0.5,
        };
        let of_one = |x: f64| vec![1.0 - 3.0 * x + x.powi(3), 2.0];
        let mut nodes = range.nodes(5);
        nodes.pop();
        let values: Vec<_> = nodes.iter().map(|x| of_one(x[0])).collect();
        let found = Surrogate::new(&range, 3, &nodes, &values).unwrap();
        for x in [0.5, 0.8, 1.4] {
            for (value, exact) in found.at(&[x]).iter().zip(of_one(x)) {
                assert_relative_eq!(*value, exact, max_relative = 1e-12);
            }
        }
        let range = Range {
            centre: vec![-1.0, 2.0],
            half_width: 0.3,
        };
        let of_two = |x: &[f64]| 1.0 + x[0] * x[1] + x[1] * x[1];
        let nodes = range.nodes(4);
        let values: Vec<_> = nodes.iter().map(|x| vec![of_two(x)]).collect();
        let found = Surrogate::new(&range, 2, &nodes, &values).unwrap();
        let x = [-0.9, 1.8];
        assert_relative_eq!(found.at(&x)[0], of_two(&x), max_relative = 1e-12);
        assert!(Surrogate::new(&range, 2, &nodes[..5], &values[..5]).is_none());
    }
}
