//! Share of each element where the surfaces face each other ([`Region`]).
//!
//! Elements that the end cuts have the weights w_q c(ξ_q): c is the projection of the region, 1 inside and 0 outside, onto polynomials
//! of the second order, with which every such polynomial is summed over the part inside as if it had a separate rule (moment
//! fitting, as in Müller, Kummer and Oberlack, International Journal for Numerical Methods in Engineering 96 (2013) 512-528).
//!
//! Theory: Where the sums end.

use ertel_fem::quadrature::Quadrature;

use super::discretisation::Discretisation;
use crate::engine::region::Region;

/// Share of an element inside.
#[derive(Clone, Debug, PartialEq)]
pub enum Share {
    /// Nothing.
    None,
    /// All of it.
    All,
    /// A part: factors on the weights of its quadrature points.
    Part(Vec<f64>),
}

impl Share {
    /// Factor on the weight of a quadrature point.
    #[inline]
    pub fn at(&self, q: usize) -> f64 {
        match self {
            Share::None => 0.0,
            Share::All => 1.0,
            Share::Part(factors) => factors[q],
        }
    }
}

/// Corners of a part of an element: reference coordinates, and the place in lengths of the region.
type Corner = [[f64; 2]; 2];

/// How often cut parts are halved: the moments of a part of a triangle are right to 1e-4 or so of it.
const HALVINGS: usize = 6;

/// Polynomials of the second order in two dimensions at most.
const N: usize = 6;

/// The elements of a mesh in a region.
pub struct Elements<'a> {
    d: &'a Discretisation,
    basis: Basis,
}

impl<'a> Elements<'a> {
    /// Of a discretisation.
    pub fn new(d: &'a Discretisation) -> Elements<'a> {
        Elements {
            d,
            basis: Basis::new(&d.rule, d.contact.surface.dim),
        }
    }

    /// Share of an element in a region.
    pub fn share(&self, region: &Region, cell: usize) -> Share {
        let surface = &self.d.contact.surface;
        let corner = |k: usize| -> Corner {
            let xi = [[0.0; 2], [1.0, 0.0], [0.0, 1.0]][k];
            let [x, y, _] = surface.vertices[surface.cell(cell)[k] as usize];
            [xi, region.unit([x, y])]
        };
        let corners: Vec<Corner> = (0..=surface.dim).map(corner).collect();
        match place(&corners) {
            Place::Inside => Share::All,
            Place::Outside => Share::None,
            Place::Cut => {
                let mut moments = [0.0; N];
                self.basis
                    .add(&corners, self.basis.measure, HALVINGS, &mut moments);
                Share::Part(self.basis.factors(&moments))
            }
        }
    }
}

/// Position of a part.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Place {
    Inside,
    Outside,
    Cut,
}

/// Position of the part between corners: the unit circle is convex.
fn place(corners: &[Corner]) -> Place {
    let inside = |p: [f64; 2]| p[0].hypot(p[1]) <= 1.0;
    if corners.iter().all(|c| inside(c[1])) {
        return Place::Inside;
    }
    // The nearest point of the rim to the centre.
    let n = corners.len();
    let mut nearest = f64::INFINITY;
    let (mut left, mut right) = (false, false);
    for k in 0..n {
        let (p, q) = (corners[k][1], corners[(k + 1) % n][1]);
        let e = [q[0] - p[0], q[1] - p[1]];
        let length = e[0] * e[0] + e[1] * e[1];
        let t = match length > 0.0 {
            true => (-(p[0] * e[0] + p[1] * e[1]) / length).clamp(0.0, 1.0),
            false => 0.0,
        };
        nearest = nearest.min((p[0] + t * e[0]).hypot(p[1] + t * e[1]));
        let side = p[0] * e[1] - p[1] * e[0];
        left |= side > 0.0;
        right |= side < 0.0;
    }
    let around_centre = n == 3 && !(left && right);
    match nearest >= 1.0 && !around_centre {
        true => Place::Outside,
        false => Place::Cut,
    }
}

/// Share of a part that is inside, from how far its corners are outside: exact for straight ends.
fn share_inside(outside: &[f64]) -> f64 {
    let (mut low, mut high): (Vec<f64>, Vec<f64>) = outside.iter().partition(|s| **s <= 0.0);
    match (low.len(), high.len()) {
        (_, 0) => 1.0,
        (0, _) => 0.0,
        (1, 1) => low[0] / (low[0] - high[0]),
        (1, _) => low[0] * low[0] / ((low[0] - high[0]) * (low[0] - high[1])),
        _ => {
            std::mem::swap(&mut low, &mut high);
            1.0 - low[0] * low[0] / ((low[0] - high[0]) * (low[0] - high[1]))
        }
    }
}

/// Polynomials that a rule finds to be orthonormal, and what they are at its points.
struct Basis {
    dim: usize,
    /// Size of the element in reference coordinates.
    measure: f64,
    /// Coefficients of each in the monomials.
    polynomials: Vec<[f64; N]>,
    /// Monomials at each point.
    at_points: Vec<[f64; N]>,
}

/// 1, s, t, s², st, t²; in one dimension those of s.
fn monomials(dim: usize, [s, t]: [f64; 2]) -> [f64; N] {
    match dim {
        1 => [1.0, s, s * s, 0.0, 0.0, 0.0],
        _ => [1.0, s, t, s * s, s * t, t * t],
    }
}

/// The middle of an edge.
fn middle(a: &Corner, b: &Corner) -> Corner {
    [0, 1].map(|k: usize| [0, 1].map(|i: usize| 0.5 * (a[k][i] + b[k][i])))
}

/// Adds the monomials at a point with a weight.
fn add_at(dim: usize, at: [f64; 2], weight: f64, moments: &mut [f64; N]) {
    for (sum, m) in moments.iter_mut().zip(monomials(dim, at)) {
        *sum += weight * m;
    }
}

/// Adds the integrals of the monomials over a line of a size by Simpson's rule, exact for the second order.
fn add_simpson(dim: usize, line: &[Corner; 2], size: f64, moments: &mut [f64; N]) {
    let [a, b] = line;
    add_at(dim, a[0], size / 6.0, moments);
    add_at(dim, middle(a, b)[0], size * (2.0 / 3.0), moments);
    add_at(dim, b[0], size / 6.0, moments);
}

fn dot(a: &[f64; N], b: &[f64; N]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

impl Basis {
    /// By Gram and Schmidt, twice.
    fn new(rule: &Quadrature, dim: usize) -> Basis {
        let at_points: Vec<[f64; N]> = (rule.points.iter())
            .map(|p| monomials(dim, [p[0], p[1]]))
            .collect();
        let product = |a: &[f64; N], b: &[f64; N]| -> f64 {
            let points = rule.weights.iter().zip(&at_points);
            points.map(|(w, m)| w * dot(a, m) * dot(b, m)).sum()
        };
        let mut polynomials: Vec<[f64; N]> = Vec::new();
        for k in 0..if dim == 1 { 3 } else { N } {
            let mut own = [0.0; N];
            own[k] = 1.0;
            for _ in 0..2 {
                for other in &polynomials {
                    let share = product(&own, other);
                    for (c, o) in own.iter_mut().zip(other) {
                        *c -= share * o;
                    }
                }
            }
            let norm = product(&own, &own).sqrt();
            // With few points in a rule some of them coincide.
            if norm > 1e-9 {
                polynomials.push(own.map(|c| c / norm));
            }
        }
        Basis {
            dim,
            measure: rule.weights.iter().sum(),
            polynomials,
            at_points,
        }
    }

    /// Adds the integrals of the monomials over the inside of a part of a size.
    fn add(&self, corners: &[Corner], size: f64, halvings: usize, moments: &mut [f64; N]) {
        let place = place(corners);
        let n = corners.len();
        match place {
            Place::Outside => {}
            Place::Inside => {
                // Exact for the second order: Simpson's rule, or the middles of the edges.
                if n == 2 {
                    add_simpson(self.dim, &[corners[0], corners[1]], size, moments);
                    return;
                }
                for k in 0..n {
                    let at = middle(&corners[k], &corners[(k + 1) % n])[0];
                    add_at(self.dim, at, size / 3.0, moments);
                }
            }
            Place::Cut if halvings == 0 => {
                let outside: Vec<f64> = (corners.iter())
                    .map(|c| c[1][0].hypot(c[1][1]) - 1.0)
                    .collect();
                let share = share_inside(&outside) * size;
                if let ([a, b], [at_a, at_b]) = (corners, &outside[..])
                    && (*at_a <= 0.0) != (*at_b <= 0.0)
                {
                    // Up to where the line ends.
                    let end =
                        |k: usize, i: usize| a[k][i] + at_a / (at_a - at_b) * (b[k][i] - a[k][i]);
                    let end = [0, 1].map(|k: usize| [0, 1].map(|i: usize| end(k, i)));
                    let inner = [if *at_a <= 0.0 { *a } else { *b }, end];
                    add_simpson(self.dim, &inner, share, moments);
                    return;
                }
                let centre =
                    [0, 1].map(|i: usize| corners.iter().map(|c| c[0][i]).sum::<f64>() / n as f64);
                add_at(self.dim, centre, share, moments);
            }
            Place::Cut if n == 2 => {
                let [a, b] = [corners[0], corners[1]];
                let m = middle(&a, &b);
                for part in [[a, m], [m, b]] {
                    self.add(&part, 0.5 * size, halvings - 1, moments);
                }
            }
            Place::Cut => {
                let [a, b, c] = [corners[0], corners[1], corners[2]];
                let [ab, bc, ca] = [middle(&a, &b), middle(&b, &c), middle(&c, &a)];
                for part in [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]] {
                    self.add(&part, 0.25 * size, halvings - 1, moments);
                }
            }
        }
    }

    /// The factors c(ξ_q) of the projection with these moments.
    fn factors(&self, moments: &[f64; N]) -> Vec<f64> {
        let mut projection = [0.0; N];
        for polynomial in &self.polynomials {
            let share = dot(polynomial, moments);
            for (sum, c) in projection.iter_mut().zip(polynomial) {
                *sum += share * c;
            }
        }
        (self.at_points.iter())
            .map(|m| dot(&projection, m))
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use approx::assert_relative_eq;

    use super::*;

    /// The projection sums polynomials of the second order over the inside: of a triangle cut by a circle of the radius ½ around its right
    /// angle, the quarter of the circle: area π/16, ∫x = 1/24, ∫x² = π/256, ∫xy = 1/128; of a segment, by hand.
    #[test]
    fn cut_elements_sum_their_inside() {
        let rule = Quadrature::simplex(2, 6);
        let basis = Basis::new(&rule, 2);
        let corners: Vec<Corner> = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]
            .map(|p: [f64; 2]| [p, p.map(|x| 2.0 * x)])
            .to_vec();
        let mut moments = [0.0; N];
        basis.add(&corners, 0.5, HALVINGS, &mut moments);
        let factors = basis.factors(&moments);
        let sum = |f: fn(f64, f64) -> f64| -> f64 {
            let points = rule.points.iter().zip(&rule.weights).zip(&factors);
            points.map(|((p, w), c)| w * c * f(p[0], p[1])).sum()
        };
        for (found, exact) in [
            (sum(|_, _| 1.0), PI / 16.0),
            (sum(|x, _| x), 1.0 / 24.0),
            (sum(|x, _| x * x), PI / 256.0),
            (sum(|x, y| x * y), 1.0 / 128.0),
        ] {
            assert_relative_eq!(found, exact, max_relative = 5e-4);
        }
        let rule = Quadrature::simplex(1, 6);
        let basis = Basis::new(&rule, 1);
        let line: Vec<Corner> = vec![[[0.0; 2], [0.7, 0.0]], [[1.0, 0.0], [1.7, 0.0]]];
        let mut moments = [0.0; N];
        basis.add(&line, 1.0, HALVINGS, &mut moments);
        let factors = basis.factors(&moments);
        let points = rule.points.iter().zip(&rule.weights).zip(&factors);
        let found: f64 = points.map(|((p, w), c)| w * c * p[0] * p[0]).sum();
        assert_relative_eq!(found, 0.3_f64.powi(3) / 3.0, max_relative = 1e-4);
    }

    /// A triangle around all of the circle is cut, and so is one into whose side the circle bulges; one next to it is outside.
    #[test]
    fn the_circle_is_found() {
        let of = |points: [[f64; 2]; 3]| place(&points.map(|p| [p, p]));
        assert_eq!(of([[-9.0, -9.0], [9.0, -9.0], [0.0, 9.0]]), Place::Cut);
        assert_eq!(of([[0.9, -2.0], [0.9, 2.0], [5.0, 0.0]]), Place::Cut);
        assert_eq!(of([[1.1, -2.0], [1.1, 2.0], [5.0, 0.0]]), Place::Outside);
        assert_eq!(of([[0.1, 0.0], [0.5, 0.0], [0.0, 0.9]]), Place::Inside);
    }
}
