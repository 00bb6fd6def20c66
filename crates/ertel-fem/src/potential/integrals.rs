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
use pulp::{Arch, Simd, WithSimd};

use super::Kernel;
use super::lanes::{Lanes, logarithms};
use crate::element::Lagrange;
use crate::quadrature::Quadrature;

/// Highest order of a density.
const MAX_ORDER: usize = 5;
/// Monomials of that order.
const MAX_TERMS: usize = (MAX_ORDER + 1) * (MAX_ORDER + 2) / 2;
/// Distance from the middle of a segment, in its lengths, from which Gauss sums take the place of closed forms.
const FAR: f64 = 4.0;
/// Numbers of points that [`ElementIntegrals::at_all`] takes are multiples of this, the width of the widest vector.
pub const POINTS: usize = 8;

/// Integrals of the shape functions of one element type.
#[derive(Clone, Debug)]
pub struct ElementIntegrals {
    kernel: Kernel,
    order: usize,
    n_nodes: usize,
    /// Shape functions by the monomials ξ^a η^b, `[node * n_nodes + term]`, all b of one a together.
    coefficients: Vec<f64>,
    /// For segments seen from far away.
    rule: Quadrature,
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
            n_nodes: n,
            coefficients,
            rule: Quadrature::simplex(1, 2 * (order + 6)),
        }
    }

    /// Number of shape functions.
    pub fn n_nodes(&self) -> usize {
        self.n_nodes
    }

    /// ∫ N_j(y) K(|x − y|) dy for every shape function of the element with these vertices (two or three), into
    /// `out`.
    pub fn at(&self, vertices: &[[f64; 2]], x: [f64; 2], out: &mut [f64]) {
        let points = x.map(|x| [x; POINTS]);
        let mut all = [0.0; MAX_TERMS * POINTS];
        let all = &mut all[..self.n_nodes * POINTS];
        self.at_all(vertices, [&points[0], &points[1]], &mut Vec::new(), all);
        for (value, all) in out.iter_mut().zip(all.chunks_exact(POINTS)) {
            *value = all[0];
        }
    }

    /// The same at many points, given by their x and their y: shape function by shape function into `out`. The number of points is
    /// a multiple of [`POINTS`].
    pub fn at_all(
        &self,
        vertices: &[[f64; 2]],
        points: [&[f64]; 2],
        work: &mut Vec<f64>,
        out: &mut [f64],
    ) {
        match self.kernel {
            Kernel::InverseDistance => Arch::new().dispatch(Triangle {
                integrals: self,
                edges: edges(vertices),
                points,
                work,
                out,
            }),
            Kernel::Logarithm => {
                for (k, x) in points[0].iter().enumerate() {
                    let moments = self.segment(vertices, *x);
                    let coefficients = self.coefficients.chunks_exact(self.n_nodes);
                    for (j, coefficients) in coefficients.enumerate() {
                        out[j * points[0].len() + k] =
                            coefficients.iter().zip(&moments).map(|(c, m)| c * m).sum();
                    }
                }
            }
        }
    }

    /// ∫ ξ^a (−ln r) over a segment.
    fn segment(&self, v: &[[f64; 2]], x: f64) -> [f64; MAX_ORDER + 1] {
        let length = v[1][0] - v[0][0];
        let xi = (x - v[0][0]) / length;
        let size = length.abs();
        let mut moments = [0.0; MAX_ORDER + 1];
        // Far away, powers of ξ(x) would cancel: Gauss sums are exact to rounding there.
        if (xi - 0.5).abs() > FAR {
            for (point, weight) in self.rule.points.iter().zip(&self.rule.weights) {
                let mut term = -weight * size * (size * (xi - point[0]).abs()).ln();
                for value in &mut moments[..=self.order] {
                    *value += term;
                    term *= point[0];
                }
            }
            return moments;
        }
        // of U = ξ − ξ(x) first
        for (u, sign) in [(-xi, -1.0), (1.0 - xi, 1.0)] {
            if u == 0.0 {
                continue;
            }
            let logarithm = (u.abs() * size).ln();
            let mut power = sign * size * u;
            for (a, value) in moments[..=self.order].iter_mut().enumerate() {
                let m = a as f64 + 1.0;
                *value -= power / m * (logarithm - 1.0 / m);
                power *= u;
            }
        }
        for pass in 1..=self.order {
            for a in (pass..=self.order).rev() {
                moments[a] += xi * moments[a - 1];
            }
        }
        moments
    }
}

/// An edge of a triangle, and reference coordinates of the triangle along it.
#[derive(Clone, Copy)]
struct Edge {
    start: [f64; 2],
    tangent: [f64; 2],
    length: f64,
    /// ξ and η at the start, and their slopes.
    from: [f64; 2],
    slopes: [f64; 2],
    /// Takes tangents to the normal inwards.
    orientation: f64,
    /// Gradients of ξ and η.
    gradients: [[f64; 2]; 2],
}

fn edges(v: &[[f64; 2]]) -> [Edge; 3] {
    let minus = |a: [f64; 2], b: [f64; 2]| [a[0] - b[0], a[1] - b[1]];
    let (e1, e2) = (minus(v[1], v[0]), minus(v[2], v[0]));
    let area = e1[0] * e2[1] - e1[1] * e2[0];
    let gradients = [[e2[1] / area, -e2[0] / area], [-e1[1] / area, e1[0] / area]];
    const CORNERS: [[f64; 2]; 3] = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
    [0, 1, 2].map(|k: usize| {
        let along = minus(v[(k + 1) % 3], v[k]);
        let length = along[0].hypot(along[1]);
        let (from, to) = (CORNERS[k], CORNERS[(k + 1) % 3]);
        Edge {
            start: v[k],
            tangent: along.map(|c| c / length),
            length,
            from,
            slopes: minus(to, from).map(|c| c / length),
            orientation: area.signum(),
            gradients,
        }
    })
}

/// Integrals over one triangle at many points.
struct Triangle<'a> {
    integrals: &'a ElementIntegrals,
    edges: [Edge; 3],
    points: [&'a [f64]; 2],
    work: &'a mut Vec<f64>,
    out: &'a mut [f64],
}

impl WithSimd for Triangle<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        match self.integrals.order {
            1 => self.run::<S, 2>(simd),
            2 => self.run::<S, 3>(simd),
            3 => self.run::<S, 4>(simd),
            4 => self.run::<S, 5>(simd),
            _ => self.run::<S, 6>(simd),
        }
    }
}

impl Triangle<'_> {
    /// With `W` one more than the order.
    #[inline(always)]
    fn run<S: Simd, const W: usize>(self, simd: S) {
        let n = self.points[0].len();
        self.work.resize(6 * n, 0.0);
        let (radii, logs) = self.work.split_at_mut(3 * n);
        // No closures around vectors here: what they do would be compiled without the wide instructions.
        let [xs, ys] = self.points;
        let (xs, ys) = (S::as_simd_f64s(xs).0, S::as_simd_f64s(ys).0);
        let m = xs.len();
        let radii = S::as_mut_simd_f64s(radii).0;
        {
            let logs = S::as_mut_simd_f64s(logs).0;
            for i in 0..m {
                let x = [Lanes(simd, xs[i]), Lanes(simd, ys[i])];
                let [e0, e1, e2] = &self.edges;
                let distances = [e0.distance(x), e1.distance(x), e2.distance(x)];
                for k in 0..3 {
                    radii[k * m + i] = distances[k].1;
                    let edge = &self.edges[k];
                    let ratio = edge.ratio(edge.frame(x), distances[k], distances[(k + 1) % 3]);
                    logs[k * m + i] = ratio.1;
                }
            }
        }
        logarithms(logs);
        let logs = S::as_simd_f64s(logs).0;
        let out = S::as_mut_simd_f64s(self.out).0;
        for i in 0..m {
            let x = [Lanes(simd, xs[i]), Lanes(simd, ys[i])];
            let xi = self.edges[0].coordinates(x);
            let mut moments = [Lanes::of(simd, 0.0); MAX_TERMS];
            for k in 0..3 {
                let edge = &self.edges[k];
                let (h, t) = edge.frame(x);
                let r = [
                    Lanes(simd, radii[k * m + i]),
                    Lanes(simd, radii[(k + 1) % 3 * m + i]),
                ];
                let j = edge_integrals::<S, W>(h, t, r, Lanes(simd, logs[k * m + i]));
                // U and V are linear along the edge: c_0 + c_1 t.
                let linear = [edge.linear(0, xi[0], t[0]), edge.linear(1, xi[1], t[0])];
                add_moments::<S, W>(h, linear, &j, &mut moments);
            }
            shift::<S, W>(&mut moments, xi);
            let coefficients = &self.integrals.coefficients;
            let terms = W * (W + 1) / 2;
            for (j, row) in coefficients.chunks_exact(terms).enumerate() {
                let mut sum = Lanes::of(simd, 0.0);
                for term in 0..terms {
                    sum = Lanes::of(simd, row[term]).times_plus(moments[term], sum);
                }
                out[j * m + i] = sum.1;
            }
        }
    }
}

impl Edge {
    /// ξ and η of points, for an edge that starts at their origin.
    #[inline(always)]
    fn coordinates<S: Simd>(&self, x: [Lanes<S>; 2]) -> [Lanes<S>; 2] {
        let simd = x[0].0;
        let dx = x[0] - Lanes::of(simd, self.start[0]);
        let dy = x[1] - Lanes::of(simd, self.start[1]);
        let [g, h] = self.gradients;
        [
            dx * Lanes::of(simd, g[0]) + dy * Lanes::of(simd, g[1]),
            dx * Lanes::of(simd, h[0]) + dy * Lanes::of(simd, h[1]),
        ]
    }

    /// One of the coordinates about x, as c_0 + c_1 t.
    #[inline(always)]
    fn linear<S: Simd>(&self, axis: usize, xi: Lanes<S>, t0: Lanes<S>) -> [Lanes<S>; 2] {
        let slope = Lanes::of(xi.0, self.slopes[axis]);
        [Lanes::of(xi.0, self.from[axis]) - xi - slope * t0, slope]
    }

    /// Distance of points from the start.
    #[inline(always)]
    fn distance<S: Simd>(&self, x: [Lanes<S>; 2]) -> Lanes<S> {
        let dx = Lanes::of(x[0].0, self.start[0]) - x[0];
        let dy = Lanes::of(x[0].0, self.start[1]) - x[1];
        dx.times_plus(dx, dy * dy).sqrt()
    }

    /// h, zero for points on the edge's line, and t at the edge's ends.
    #[inline(always)]
    fn frame<S: Simd>(&self, x: [Lanes<S>; 2]) -> (Lanes<S>, [Lanes<S>; 2]) {
        let simd = x[0].0;
        let dx = Lanes::of(simd, self.start[0]) - x[0];
        let dy = Lanes::of(simd, self.start[1]) - x[1];
        let along = Lanes::of(simd, self.tangent[0]);
        let up = Lanes::of(simd, self.tangent[1]);
        let h = Lanes::of(simd, self.orientation) * (dx * up - dy * along);
        let t = dx * along + dy * up;
        let (smallest, zero) = (Lanes::of(simd, 1e-14 * self.length), Lanes::of(simd, 0.0));
        (
            h.abs().below(smallest, zero, h),
            [t, t + Lanes::of(simd, self.length)],
        )
    }

    /// (t_1 + R_1)/(t_0 + R_0) without cancellation: t + R = h²/(R − t). One for points on the edge's line.
    #[inline(always)]
    fn ratio<S: Simd>(
        &self,
        (h, t): (Lanes<S>, [Lanes<S>; 2]),
        r0: Lanes<S>,
        r1: Lanes<S>,
    ) -> Lanes<S> {
        let (zero, one, square) = (Lanes::of(h.0, 0.0), Lanes::of(h.0, 1.0), h * h);
        let (a, b) = (r0 + t[0].abs(), r1 + t[1].abs());
        let above = t[1].below(zero, square, b) * t[0].below(zero, a, one);
        let below = t[1].below(zero, b, one) * t[0].below(zero, square, a);
        h.abs()
            .below(Lanes::of(h.0, f64::MIN_POSITIVE), one, above / below)
    }
}

/// J_0 to J_(W−1) along an edge.
#[inline(always)]
fn edge_integrals<S: Simd, const W: usize>(
    h: Lanes<S>,
    t: [Lanes<S>; 2],
    r: [Lanes<S>; 2],
    logarithm: Lanes<S>,
) -> [Lanes<S>; W] {
    let mut integrals = [logarithm; W];
    integrals[1] = r[1] - r[0];
    let square = h * h;
    let mut ends = r;
    for k in 2..W {
        let m = k as f64;
        ends = [ends[0] * t[0], ends[1] * t[1]];
        let by_parts = (ends[1] - ends[0]) * Lanes::of(h.0, 1.0 / m);
        integrals[k] = by_parts - Lanes::of(h.0, (m - 1.0) / m) * (square * integrals[k - 2]);
    }
    integrals
}

/// Adds h/(m + 1) ∫ U^a V^b/R dt, m = a + b, of one edge.
#[inline(always)]
fn add_moments<S: Simd, const W: usize>(
    h: Lanes<S>,
    linear: [[Lanes<S>; 2]; 2],
    integrals: &[Lanes<S>; W],
    moments: &mut [Lanes<S>; MAX_TERMS],
) {
    let mut by_u = [h; W];
    let mut term = 0;
    for a in 0..W {
        let mut polynomial = by_u;
        for b in 0..W - a {
            let degree = a + b;
            let mut sum = polynomial[0] * integrals[0];
            for k in 1..=degree {
                sum = polynomial[k].times_plus(integrals[k], sum);
            }
            let weight = Lanes::of(h.0, 1.0 / (degree as f64 + 1.0));
            moments[term] = weight.times_plus(sum, moments[term]);
            term += 1;
            multiply(&mut polynomial, linear[1], degree);
        }
        multiply(&mut by_u, linear[0], a);
    }
}

/// Multiplies a polynomial of the given degree by c_0 + c_1 t, up to the length of the array.
#[inline(always)]
fn multiply<S: Simd, const W: usize>(
    polynomial: &mut [Lanes<S>; W],
    linear: [Lanes<S>; 2],
    degree: usize,
) {
    if degree + 1 < W {
        polynomial[degree + 1] = polynomial[degree] * linear[1];
        for k in (1..=degree).rev() {
            polynomial[k] = polynomial[k].times_plus(linear[0], polynomial[k - 1] * linear[1]);
        }
        polynomial[0] = polynomial[0] * linear[0];
    }
}

/// Moments of ξ^a η^b from those of U^a V^b: ξ^a = ξ^(a−1) (U + ξ_x), power by power.
#[inline(always)]
fn shift<S: Simd, const W: usize>(moments: &mut [Lanes<S>; MAX_TERMS], xi: [Lanes<S>; 2]) {
    // Place of (a, b) among the terms: rows of falling length.
    let place = |a: usize, b: usize| a * (2 * W + 1 - a) / 2 + b;
    for b in 0..W {
        for pass in 1..W - b {
            for a in (pass..W - b).rev() {
                moments[place(a, b)] =
                    xi[0].times_plus(moments[place(a - 1, b)], moments[place(a, b)]);
            }
        }
    }
    for a in 0..W {
        for pass in 1..W - a {
            for b in (pass..W - a).rev() {
                moments[place(a, b)] =
                    xi[1].times_plus(moments[place(a, b - 1)], moments[place(a, b)]);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
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
        // ∫ over a short segment seen from far: −∫ N_j times the logarithm of about the distance
        integrals.at(&[[0.0, 0.0], [1e-6, 0.0]], [1.0, 0.0], &mut found);
        assert_relative_eq!(found.iter().sum::<f64>(), 0.5e-12, max_relative = 1e-5);
    }
}
