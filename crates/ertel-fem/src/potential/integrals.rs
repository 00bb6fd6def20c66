//! Closed forms of ∫ N_j(y) K(|x − y|) dy over one element, x in its plane, inside of it or not.
//!
//! Triangles, K = 1/r. In polar coordinates around x a homogeneous polynomial f_m of degree m (about x) integrates along each ray
//! to f_m(y) R^(m+1)/(m + 1) at the edge, and what is left is one integral along each edge:
//!
//! ```text
//!   ∫_T f_m/r dA = Σ_edges h/(m + 1) ∫ f_m(t)/√(h² + t²) dt
//!
//!   h: distance of the edge's line from x, positive where x is on the inner side;  t along it from x's foot
//!   J_k = ∫ t^k/R dt,  R = √(h² + t²):   J_0 = ln(t + R),  J_1 = R,  J_k = t^(k−1) R/k − (k − 1)/k h² J_(k−2)
//! ```
//! Segments, K = −ln r: ∫ u^m ln|u| du = u^(m+1)/(m + 1) (ln|u| − 1/(m + 1)).

use faer::Mat;
use faer::linalg::solvers::Solve;

use super::Kernel;
use crate::element::Lagrange;

/// Highest order of a density.
const MAX_ORDER: usize = 5;
/// Monomials of that order.
const MAX_TERMS: usize = (MAX_ORDER + 1) * (MAX_ORDER + 2) / 2;

/// Integrals of the shape functions of one element type.
#[derive(Clone, Debug)]
pub struct ElementIntegrals {
    kernel: Kernel,
    order: usize,
    /// Exponents (a, b) of the monomials ξ^a η^b.
    exponents: Vec<[usize; 2]>,
    /// Shape functions by monomials, `[node * n_terms + term]`.
    coefficients: Vec<f64>,
}

impl ElementIntegrals {
    /// For a density on `element`, of dimension 1 with [`Kernel::Logarithm`] or 2 with [`Kernel::InverseDistance`].
    ///
    /// # Panics
    /// When kernel and dimension do not belong together.
    pub fn new(element: &Lagrange, kernel: Kernel) -> ElementIntegrals {
        let (dim, order) = (element.dim(), element.order());
        assert_eq!(dim == 1, kernel == Kernel::Logarithm);
        let exponents: Vec<[usize; 2]> = (0..=order)
            .flat_map(|a| (0..=(if dim == 2 { order - a } else { 0 })).map(move |b| [a, b]))
            .collect();
        let n = exponents.len();
        // N_j(ξ_i) = δ_ij: the coefficients are the inverse of the monomials at the nodes.
        let nodes = element.lattice();
        let monomials = Mat::from_fn(n, n, |node, term| {
            let xi = [1, 2].map(|v: usize| f64::from(nodes[node][v]) / order as f64);
            let [a, b] = exponents[term];
            xi[0].powi(a as i32) * xi[1].powi(b as i32)
        });
        let inverse = monomials.partial_piv_lu().solve(Mat::<f64>::identity(n, n));
        let coefficients = (0..n)
            .flat_map(|node| (0..n).map(move |term| (node, term)))
            .map(|(node, term)| inverse[(term, node)])
            .collect();
        ElementIntegrals {
            kernel,
            order,
            exponents,
            coefficients,
        }
    }

    /// Number of shape functions.
    pub fn n_nodes(&self) -> usize {
        self.exponents.len()
    }

    /// ∫ N_j(y) K(|x − y|) dy for every shape function of the element with these vertices (two or three), into
    /// `out`.
    pub fn at(&self, vertices: &[[f64; 2]], x: [f64; 2], out: &mut [f64]) {
        let mut about_x = [0.0; MAX_TERMS];
        let origin = match self.kernel {
            Kernel::InverseDistance => self.triangle(vertices, x, &mut about_x),
            Kernel::Logarithm => self.segment(vertices, x, &mut about_x),
        };
        let moments = self.shifted(&about_x, origin);
        let n = self.n_nodes();
        for (value, coefficients) in out.iter_mut().zip(self.coefficients.chunks_exact(n)) {
            *value = coefficients.iter().zip(&moments).map(|(c, m)| c * m).sum();
        }
    }

    /// ∫ U^a V^b/r over a triangle, (U, V) = (ξ, η) − (ξ, η)(x); returns the reference coordinates of x.
    fn triangle(&self, v: &[[f64; 2]], x: [f64; 2], out: &mut [f64; MAX_TERMS]) -> [f64; 2] {
        let minus = |a: [f64; 2], b: [f64; 2]| [a[0] - b[0], a[1] - b[1]];
        let cross = |a: [f64; 2], b: [f64; 2]| a[0] * b[1] - a[1] * b[0];
        let (e1, e2, d) = (minus(v[1], v[0]), minus(v[2], v[0]), minus(x, v[0]));
        let area = cross(e1, e2);
        let xi = [cross(d, e2) / area, cross(e1, d) / area];
        let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]].map(|c| minus(c, xi));
        let orientation = area.signum();
        let width = self.order + 1;
        for k in 0..3 {
            let (start, end) = (minus(v[k], x), minus(v[(k + 1) % 3], x));
            let along = minus(end, start);
            let length = along[0].hypot(along[1]);
            let tangent = along.map(|c| c / length);
            let h = orientation * cross(start, tangent);
            if h.abs() < 1e-14 * length {
                continue;
            }
            let t = [start, end].map(|p| p[0] * tangent[0] + p[1] * tangent[1]);
            let integrals = edge_integrals(h, t, width);
            // U and V are linear along the edge: c_0 + c_1 t.
            let (from, to) = (corners[k], corners[(k + 1) % 3]);
            let linear = [0, 1].map(|a: usize| {
                let slope = (to[a] - from[a]) / length;
                [from[a] - slope * t[0], slope]
            });
            let mut by_u = [0.0; MAX_ORDER + 1];
            by_u[0] = orientation * h;
            let mut term = 0;
            for a in 0..width {
                let mut polynomial = by_u;
                for b in 0..width - a {
                    let degree = a + b;
                    let sum: f64 = (polynomial[..=degree].iter().zip(&integrals))
                        .map(|(p, j)| p * j)
                        .sum();
                    out[term] += orientation * sum / (degree as f64 + 1.0);
                    term += 1;
                    multiply(&mut polynomial, linear[1], degree);
                }
                multiply(&mut by_u, linear[0], a);
            }
        }
        xi
    }

    /// ∫ U^a (−ln r) over a segment, U = ξ − ξ(x); returns ξ(x).
    fn segment(&self, v: &[[f64; 2]], x: [f64; 2], out: &mut [f64; MAX_TERMS]) -> [f64; 2] {
        let length = v[1][0] - v[0][0];
        let xi = (x[0] - v[0][0]) / length;
        let size = length.abs();
        for (u, sign) in [(-xi, -1.0), (1.0 - xi, 1.0)] {
            if u == 0.0 {
                continue;
            }
            let logarithm = (u.abs() * size).ln();
            let mut power = sign * size * u;
            for (a, value) in out[..=self.order].iter_mut().enumerate() {
                let m = a as f64 + 1.0;
                *value -= power / m * (logarithm - 1.0 / m);
                power *= u;
            }
        }
        [xi, 0.0]
    }

    /// Moments of ξ^a η^b from those about x.
    fn shifted(&self, about_x: &[f64; MAX_TERMS], xi: [f64; 2]) -> [f64; MAX_TERMS] {
        let width = self.order + 1;
        // Pascal's triangle with powers of the origin: ξ^a = Σ_c (a over c) ξ_x^(a−c) U^c
        let row = |x: f64| {
            let mut rows = [[0.0; MAX_ORDER + 1]; MAX_ORDER + 1];
            rows[0][0] = 1.0;
            for a in 1..width {
                for c in 0..=a {
                    let below = if c > 0 { rows[a - 1][c - 1] } else { 0.0 };
                    rows[a][c] = below + x * rows[a - 1][c];
                }
            }
            rows
        };
        let mut moments = [0.0; MAX_TERMS];
        let by_xi = row(xi[0]);
        if self.kernel == Kernel::Logarithm {
            for a in 0..width {
                moments[a] = (0..=a).map(|c| by_xi[a][c] * about_x[c]).sum();
            }
            return moments;
        }
        let by_eta = row(xi[1]);
        // Place of (a, b) among the terms: rows of falling length.
        let place = |a: usize, b: usize| a * (2 * width + 1 - a) / 2 + b;
        for (moment, [a, b]) in moments.iter_mut().zip(&self.exponents) {
            for c in 0..=*a {
                for d in 0..=*b {
                    *moment += by_xi[*a][c] * by_eta[*b][d] * about_x[place(c, d)];
                }
            }
        }
        moments
    }
}

/// J_0 to J_(n−1) along an edge from t_0 to t_1 at the distance h ≠ 0.
fn edge_integrals(h: f64, t: [f64; 2], n: usize) -> [f64; MAX_ORDER + 1] {
    let square = h * h;
    let r = t.map(|t| (square + t * t).sqrt());
    // ln((t_1 + R_1)/(t_0 + R_0)) without cancellation: t + R = h²/(R − t).
    let ratio = match (t[0] < 0.0, t[1] < 0.0) {
        (true, true) => (r[0] - t[0]) / (r[1] - t[1]),
        (true, false) => (t[1] + r[1]) * (r[0] - t[0]) / square,
        (false, true) => square / ((t[0] + r[0]) * (r[1] - t[1])),
        (false, false) => (t[1] + r[1]) / (t[0] + r[0]),
    };
    let mut integrals = [0.0; MAX_ORDER + 1];
    integrals[0] = ratio.ln();
    if n > 1 {
        integrals[1] = r[1] - r[0];
    }
    let mut powers = t;
    for k in 2..n {
        let m = k as f64;
        integrals[k] =
            (powers[1] * r[1] - powers[0] * r[0]) / m - (m - 1.0) / m * square * integrals[k - 2];
        powers = [powers[0] * t[0], powers[1] * t[1]];
    }
    integrals
}

/// Multiplies a polynomial of the given degree by c_0 + c_1 t.
fn multiply(polynomial: &mut [f64; MAX_ORDER + 1], linear: [f64; 2], degree: usize) {
    for k in (0..=(degree + 1).min(MAX_ORDER)).rev() {
        let below = if k > 0 { polynomial[k - 1] } else { 0.0 };
        let own = if k <= degree { polynomial[k] } else { 0.0 };
        polynomial[k] = own * linear[0] + below * linear[1];
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quadrature::Quadrature;
    use approx::assert_relative_eq;

    const TRIANGLE: [[f64; 2]; 3] = [[0.1, 0.2], [1.3, 0.4], [0.5, 1.1]];

    /// ∫ N_j/r by brute force: the triangle seen from x is cut into three with a corner in x, and Duffy's coordinates take the
    /// singularity away.
    fn by_quadrature(element: &Lagrange, v: &[[f64; 2]; 3], x: [f64; 2]) -> Vec<f64> {
        let rule = Quadrature::simplex(1, 79);
        let cross = |a: [f64; 2], b: [f64; 2]| a[0] * b[1] - a[1] * b[0];
        let minus = |a: [f64; 2], b: [f64; 2]| [a[0] - b[0], a[1] - b[1]];
        let area = cross(minus(v[1], v[0]), minus(v[2], v[0]));
        let mut sums = vec![0.0; element.n_nodes()];
        for k in 0..3 {
            let (a, b) = (v[k], v[(k + 1) % 3]);
            let twice = cross(minus(a, x), minus(b, x));
            for (s, ws) in rule.points.iter().zip(&rule.weights) {
                let edge = [0, 1].map(|i: usize| a[i] + s[0] * (b[i] - a[i]));
                let r = minus(edge, x);
                for (u, wu) in rule.points.iter().zip(&rule.weights) {
                    let y = [x[0] + u[0] * r[0], x[1] + u[0] * r[1]];
                    let d = minus(y, v[0]);
                    let xi = [
                        cross(d, minus(v[2], v[0])) / area,
                        cross(minus(v[1], v[0]), d) / area,
                        0.0,
                    ];
                    let weight = ws * wu * twice / r[0].hypot(r[1]);
                    for (sum, n) in sums.iter_mut().zip(element.values(xi)) {
                        *sum += weight * n;
                    }
                }
            }
        }
        sums
    }

    #[test]
    fn triangles_equal_brute_force_inside_on_corners_and_outside() {
        for order in 1..=5 {
            let element = Lagrange::new(2, order);
            let integrals = ElementIntegrals::new(&element, Kernel::InverseDistance);
            let middle = [0.7, 0.75];
            for x in [[0.6, 0.55], TRIANGLE[1], middle, [0.4, 0.1], [-1.0, 2.0]] {
                let mut found = vec![0.0; element.n_nodes()];
                integrals.at(&TRIANGLE, x, &mut found);
                let exact = by_quadrature(&element, &TRIANGLE, x);
                for (f, e) in found.iter().zip(&exact) {
                    assert_relative_eq!(f, e, epsilon = 1e-9);
                }
                // the other way round it is the same triangle
                let turned = [TRIANGLE[0], TRIANGLE[2], TRIANGLE[1]];
                let mut other = found.clone();
                integrals.at(&turned, x, &mut other);
                assert_relative_eq!(other[0], found[0], epsilon = 1e-10);
            }
        }
    }

    /// By hand: ∫ dA/r over a square of side 2 around its centre is 8 ln(1 + √2).
    #[test]
    fn unit_density_on_a_square() {
        let integrals = ElementIntegrals::new(&Lagrange::new(2, 3), Kernel::InverseDistance);
        let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
        let mut sum = 0.0;
        for other in [1, 3] {
            let mut found = vec![0.0; 10];
            integrals.at(
                &[corners[0], corners[2], corners[other]],
                [0.0; 2],
                &mut found,
            );
            sum += found.iter().sum::<f64>();
        }
        assert_relative_eq!(sum, 8.0 * 2.0_f64.sqrt().ln_1p(), max_relative = 1e-12);
    }

    /// −∫ ln|x − y| dy over (0, 2): 2(1 − ln 1) at its middle, 2 − 2 ln 2 at its end; and against Gauss sums for
    /// x outside.
    #[test]
    fn segments_equal_closed_forms() {
        let element = Lagrange::new(1, 3);
        let integrals = ElementIntegrals::new(&element, Kernel::Logarithm);
        let ends = [[0.0, 0.0], [2.0, 0.0]];
        let mut found = vec![0.0; 4];
        for (x, exact) in [(1.0, 2.0), (0.0, 2.0 - 2.0 * 2.0_f64.ln())] {
            integrals.at(&ends, [x, 0.0], &mut found);
            assert_relative_eq!(found.iter().sum::<f64>(), exact, epsilon = 1e-13);
        }
        integrals.at(&ends, [3.1, 0.0], &mut found);
        let rule = Quadrature::simplex(1, 41);
        for (j, f) in found.iter().enumerate() {
            let sum: f64 = (rule.points.iter().zip(&rule.weights))
                .map(|(p, w)| {
                    let n = element.values(*p).nth(j).unwrap();
                    -2.0 * w * n * (3.1 - 2.0 * p[0]).ln()
                })
                .sum();
            assert_relative_eq!(*f, sum, epsilon = 1e-13);
        }
    }
}
