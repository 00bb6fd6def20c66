//! Lagrange elements of any order on the reference simplex of dimension 1 to 3.
//!
//! Nodes sit on the lattice of barycentric multi-indices α, Σα_i = order, at λ_i = α_i/order.
//! Reference vertices: v0 at the origin, v_i at the unit vector i; λ_0 = 1 − Σξ.
//!
//! ```text
//!   order 2, dim 2      v2            node order: all vertices first, then the rest of the
//!                       | \           lattice in lexicographic order of α
//!                       4   5
//!                       |     \
//!                       v0--3--v1
//! ```

use faer::Mat;
use faer::linalg::solvers::Solve;

use crate::quadrature::Quadrature;

/// A Lagrange element.
#[derive(Clone, Debug)]
pub struct Lagrange {
    dim: usize,
    order: usize,
    lattice: Vec<[u8; 4]>,
}

/// Shape functions at the points of a quadrature rule, derivatives by reference coordinates.
#[derive(Clone, Debug)]
pub struct Tabulation {
    /// Number of shape functions.
    pub n_nodes: usize,
    /// Values, `[point * n_nodes + node]`.
    pub values: Vec<f64>,
    /// Gradients ∂N/∂ξ_a.
    pub gradients: Vec<[f64; 3]>,
    /// Second derivatives ∂²N/∂ξ_a∂ξ_b.
    pub hessians: Vec<[[f64; 3]; 3]>,
}

impl Lagrange {
    /// Element of the given dimension (1 to 3) and order (1 to 5).
    ///
    /// # Panics
    /// Outside these ranges: callers check user input first.
    pub fn new(dim: usize, order: usize) -> Lagrange {
        assert!((1..=3).contains(&dim) && (1..=5).contains(&order));
        let k = order as u8;
        let mut lattice: Vec<[u8; 4]> = (0..=dim)
            .map(|v| {
                let mut a = [0; 4];
                a[v] = k;
                a
            })
            .collect();
        let limit = |axis: usize| if axis <= dim { k } else { 0 };
        for a1 in 0..=limit(1) {
            for a2 in 0..=limit(2) {
                for a3 in 0..=limit(3) {
                    if a1 + a2 + a3 <= k {
                        let a = [k - a1 - a2 - a3, a1, a2, a3];
                        if !a.contains(&k) {
                            lattice.push(a);
                        }
                    }
                }
            }
        }
        Lagrange {
            dim,
            order,
            lattice,
        }
    }

    /// Dimension of the simplex.
    pub fn dim(&self) -> usize {
        self.dim
    }

    /// Polynomial order.
    pub fn order(&self) -> usize {
        self.order
    }

    /// Number of nodes.
    pub fn n_nodes(&self) -> usize {
        self.lattice.len()
    }

    /// Barycentric multi-indices of the nodes, in units of 1/order.
    pub fn lattice(&self) -> &[[u8; 4]] {
        &self.lattice
    }

    /// Reference coordinates of the nodes.
    pub fn points(&self) -> impl Iterator<Item = [f64; 3]> {
        let order = self.order as f64;
        (self.lattice.iter()).map(move |a| [a[1], a[2], a[3]].map(|i| f64::from(i) / order))
    }

    /// Value, gradient and Hessian of every shape function at a reference point.
    ///
    /// N_α = Π_i φ(α_i, λ_i), φ(m, λ) = Π_{j<m} (kλ − j)/(j + 1)   (Silvester 1969)
    pub fn evaluate(&self, xi: [f64; 3]) -> Vec<(f64, [f64; 3], [[f64; 3]; 3])> {
        let d = self.dim;
        let lambda = [1.0 - xi[..d].iter().sum::<f64>(), xi[0], xi[1], xi[2]];
        self.lattice
            .iter()
            .map(|alpha| {
                let mut f = [(1.0, 0.0, 0.0); 4];
                for i in 0..=d {
                    f[i] = silvester(self.order, alpha[i], lambda[i]);
                }
                // Derivatives by the barycentric coordinates, then ∂/∂ξ_a = ∂/∂λ_a − ∂/∂λ_0.
                let product = |orders: [usize; 4]| -> f64 {
                    (0..=d)
                        .map(|i| [f[i].0, f[i].1, f[i].2][orders[i]])
                        .product()
                };
                let first = |i: usize| {
                    let mut o = [0; 4];
                    o[i] += 1;
                    product(o)
                };
                let second = |i: usize, j: usize| {
                    let mut o = [0; 4];
                    o[i] += 1;
                    o[j] += 1;
                    product(o)
                };
                let mut gradient = [0.0; 3];
                let mut hessian = [[0.0; 3]; 3];
                for a in 0..d {
                    gradient[a] = first(a + 1) - first(0);
                    for b in 0..d {
                        hessian[a][b] = second(a + 1, b + 1) - second(a + 1, 0) - second(0, b + 1)
                            + second(0, 0);
                    }
                }
                (product([0; 4]), gradient, hessian)
            })
            .collect()
    }

    /// Value of every shape function at a reference point.
    pub fn values(&self, xi: [f64; 3]) -> impl Iterator<Item = f64> {
        let factors = self.factors(xi);
        self.lattice.iter().map(move |alpha| {
            let factors = factors.iter().zip(alpha).take(self.dim + 1);
            factors.map(|(f, a)| f[*a as usize].0).product()
        })
    }

    /// Value and gradient of every shape function at a reference point.
    pub fn gradients(&self, xi: [f64; 3]) -> impl Iterator<Item = (f64, [f64; 3])> {
        let (d, factors) = (self.dim, self.factors(xi));
        self.lattice.iter().map(move |alpha| {
            let f: [(f64, f64); 4] = std::array::from_fn(|i| factors[i][alpha[i] as usize]);
            let value = f[..=d].iter().map(|f| f.0).product();
            let mut by_lambda = [0.0; 4];
            for (i, by) in by_lambda[..=d].iter_mut().enumerate() {
                *by = (0..=d)
                    .map(|j| if j == i { f[j].1 } else { f[j].0 })
                    .product();
            }
            let gradient = std::array::from_fn(|a| match a < d {
                true => by_lambda[a + 1] - by_lambda[0],
                false => 0.0,
            });
            (value, gradient)
        })
    }

    /// φ(m, λ_i) and its derivative at a reference point, for each barycentric coordinate and each m.
    fn factors(&self, xi: [f64; 3]) -> [[(f64, f64); 6]; 4] {
        let (d, k) = (self.dim, self.order as f64);
        let lambda = [1.0 - xi[..d].iter().sum::<f64>(), xi[0], xi[1], xi[2]];
        let mut factors = [[(1.0, 0.0); 6]; 4];
        for (f, lambda) in factors.iter_mut().zip(lambda).take(d + 1) {
            for j in 0..self.order {
                let c = 1.0 / (j as f64 + 1.0);
                let (g, dg) = ((k * lambda - j as f64) * c, k * c);
                f[j + 1] = (f[j].0 * g, f[j].1 * g + f[j].0 * dg);
            }
        }
        factors
    }

    /// Shape functions at all points of a rule.
    pub fn tabulate(&self, rule: &Quadrature) -> Tabulation {
        let mut table = Tabulation {
            n_nodes: self.n_nodes(),
            values: Vec::new(),
            gradients: Vec::new(),
            hessians: Vec::new(),
        };
        for point in &rule.points {
            for (value, gradient, hessian) in self.evaluate(*point) {
                table.values.push(value);
                table.gradients.push(gradient);
                table.hessians.push(hessian);
            }
        }
        table
    }

    /// Difference of each shape function and its best polynomial of a lower degree (in the L² sense), at
    /// the points of a rule: N − πN, `[point * n_nodes + node]`; zero if the degree is not
    /// lower. The rule must be exact for twice the order.
    pub fn fluctuations(&self, degree: usize, rule: &Quadrature) -> Vec<f64> {
        let n = self.n_nodes();
        if degree >= self.order {
            return vec![0.0; n * rule.len()];
        }
        let values = |element: &Lagrange| {
            let table = element.tabulate(rule).values;
            Mat::from_fn(rule.len(), element.n_nodes(), |q, j| {
                table[q * element.n_nodes() + j]
            })
        };
        let low = match degree {
            0 => Mat::from_fn(rule.len(), 1, |_, _| 1.0),
            _ => values(&Lagrange::new(self.dim, degree)),
        };
        let high = values(self);
        let weighted = Mat::from_fn(low.ncols(), rule.len(), |i, q| {
            rule.weights[q] * low[(q, i)]
        });
        let projection = (&weighted * &low).partial_piv_lu().solve(&weighted * &high);
        let rest = &high - &low * projection;
        (0..rule.len())
            .flat_map(|q| (0..n).map(move |j| (q, j)))
            .map(|(q, j)| rest[(q, j)])
            .collect()
    }
}

/// φ(m, λ) and its first two derivatives.
fn silvester(order: usize, m: u8, lambda: f64) -> (f64, f64, f64) {
    let k = order as f64;
    let (mut f, mut d, mut dd) = (1.0, 0.0, 0.0);
    for j in 0..m {
        let c = 1.0 / (j as f64 + 1.0);
        let (g, dg) = ((k * lambda - j as f64) * c, k * c);
        (f, d, dd) = (f * g, d * g + f * dg, dd * g + 2.0 * d * dg);
    }
    (f, d, dd)
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Every element of the family; a new one joins here and inherits the tests.
    fn family() -> Vec<Lagrange> {
        (1..=3)
            .flat_map(|dim| (1..=5).map(move |order| Lagrange::new(dim, order)))
            .collect()
    }

    /// Values alone, and with gradients, equal those with all derivatives, inside of the element and beyond.
    #[test]
    fn values_are_those_of_evaluate() {
        for element in family() {
            for x in [[0.2, 0.3, 0.1], [1.4, -0.7, 0.6]] {
                let both = element.values(x).zip(element.gradients(x));
                for ((a, (b, gradient)), exact) in both.zip(element.evaluate(x)) {
                    assert_relative_eq!(a, exact.0, epsilon = 1e-12);
                    assert_relative_eq!(b, exact.0, epsilon = 1e-12);
                    for (g, exact) in gradient.iter().zip(exact.1) {
                        assert_relative_eq!(*g, exact, epsilon = 1e-11);
                    }
                }
            }
        }
    }

    fn node_point(element: &Lagrange, alpha: &[u8; 4]) -> [f64; 3] {
        let k = element.order() as f64;
        [
            alpha[1] as f64 / k,
            alpha[2] as f64 / k,
            alpha[3] as f64 / k,
        ]
    }

    #[test]
    fn shape_functions_are_nodal() {
        for element in family() {
            for (i, alpha) in element.lattice().iter().enumerate() {
                for (j, (v, _, _)) in element
                    .evaluate(node_point(&element, alpha))
                    .iter()
                    .enumerate()
                {
                    assert_relative_eq!(*v, if i == j { 1.0 } else { 0.0 }, epsilon = 1e-12);
                }
            }
        }
    }

    /// In one dimension the rest of a cubic after projection onto quadratics is its third Legendre polynomial, of a
    /// quadratic onto linear ones the second (closed forms): x³ = (2P₃ + 3x)/5, x² = (2P₂ + 1)/3 on
    /// [−1, 1]; ξ = (1 + x)/2. Lower polynomials leave nothing, in any dimension.
    #[test]
    fn fluctuations_are_projection_residuals() {
        for (order, legendre) in [
            (3, (|x| (5.0 * x * x * x - 3.0 * x) / 2.0) as fn(f64) -> f64),
            (2, |x| (3.0 * x * x - 1.0) / 2.0),
        ] {
            let element = Lagrange::new(1, order);
            let rule = Quadrature::simplex(1, 2 * order);
            let rest = element.fluctuations(order - 1, &rule);
            let leading = if order == 3 { 2.0 / 5.0 } else { 2.0 / 3.0 };
            for (q, xi) in rule.points.iter().enumerate() {
                let sum: f64 = element
                    .lattice()
                    .iter()
                    .enumerate()
                    .map(|(j, alpha)| {
                        let x = 2.0 * node_point(&element, alpha)[0] - 1.0;
                        x.powi(order as i32) * rest[q * element.n_nodes() + j]
                    })
                    .sum();
                let exact = leading * legendre(2.0 * xi[0] - 1.0);
                assert_relative_eq!(sum, exact, epsilon = 1e-13);
            }
        }
        for element in family().into_iter().filter(|e| e.order() > 1) {
            let n = element.n_nodes();
            let rule = Quadrature::simplex(element.dim(), 2 * element.order());
            for degree in 1..element.order() {
                let rest = element.fluctuations(degree, &rule);
                for q in 0..rule.len() {
                    let sum: f64 = (0..n)
                        .map(|j| {
                            let p = node_point(&element, &element.lattice()[j]);
                            (1.0 + 2.0 * p[0] - p[1] + p[2]).powi(degree as i32) * rest[q * n + j]
                        })
                        .sum();
                    assert_relative_eq!(sum, 0.0, epsilon = 1e-11);
                }
            }
        }
    }

    /// Number of nodes = binomial(order + dim, dim).
    #[test]
    fn node_counts() {
        let counts: Vec<usize> = family().iter().map(Lagrange::n_nodes).collect();
        assert_eq!(counts, [2, 3, 4, 5, 6, 3, 6, 10, 15, 21, 4, 10, 20, 35, 56]);
    }

    /// Interpolating f = (1 + 2x − y + 3z)^order is exact, with its gradient and Hessian
    /// (closed form) at a point off the nodes.
    #[test]
    fn polynomials_are_reproduced_with_derivatives() {
        let slope = [2.0, -1.0, 3.0];
        let x = [0.17, 0.31, 0.22];
        for element in family() {
            let (d, k) = (element.dim(), element.order() as i32);
            let linear = |p: [f64; 3]| 1.0 + (0..d).map(|a| slope[a] * p[a]).sum::<f64>();
            let (mut v, mut g, mut h) = (0.0, [0.0; 3], [[0.0; 3]; 3]);
            for (alpha, (n, dn, ddn)) in element.lattice().iter().zip(element.evaluate(x)) {
                let f = linear(node_point(&element, alpha)).powi(k);
                v += f * n;
                for a in 0..d {
                    g[a] += f * dn[a];
                    for b in 0..d {
                        h[a][b] += f * ddn[a][b];
                    }
                }
            }
            let s = linear(x);
            let kf = k as f64;
            assert_relative_eq!(v, s.powi(k), max_relative = 1e-11);
            for a in 0..d {
                assert_relative_eq!(g[a], kf * slope[a] * s.powi(k - 1), max_relative = 1e-10);
                for b in 0..d {
                    let exact = if k > 1 {
                        kf * (kf - 1.0) * slope[a] * slope[b] * s.powi(k - 2)
                    } else {
                        0.0
                    };
                    assert_relative_eq!(h[a][b], exact, max_relative = 1e-9, epsilon = 1e-10);
                }
            }
        }
    }
}
