//! Gauss quadrature on the reference simplex {ξ ≥ 0, Σξ ≤ 1} of any dimension and degree.

/// Points and weights on the reference simplex; weights sum to its measure 1/dim!.
#[derive(Clone, Debug)]
pub struct Quadrature {
    /// Reference coordinates, the first `dim` entries are used.
    pub points: Vec<[f64; 3]>,
    /// Weights.
    pub weights: Vec<f64>,
}

impl Quadrature {
    /// Conical product rule, exact for polynomials up to `degree` in dimension 1, 2 or 3.
    ///
    /// Gauss-Jacobi rules in collapsed coordinates, the Jacobian (1−u)^m taken up by the Jacobi
    /// weight (Stroud 1971, section 2.4): n = ⌈(degree+1)/2⌉ points in each direction.
    pub fn simplex(dim: usize, degree: usize) -> Quadrature {
        assert!((1..=3).contains(&dim), "simplices of dimension 1 to 3");
        let n = degree / 2 + 1;
        let mut rule = Quadrature {
            points: vec![[0.0; 3]],
            weights: vec![1.0],
        };
        // Collapse axis by axis: the first axis carries weight (1−u)^(dim−1), the last none.
        for axis in 0..dim {
            let (nodes, weights) = gauss_jacobi_unit(n, dim - 1 - axis);
            let mut next = Quadrature {
                points: Vec::new(),
                weights: Vec::new(),
            };
            for (point, weight) in rule.points.iter().zip(&rule.weights) {
                let rest = 1.0 - point.iter().sum::<f64>();
                for (u, w) in nodes.iter().zip(&weights) {
                    let mut p = *point;
                    p[axis] = u * rest;
                    next.points.push(p);
                    next.weights.push(weight * w);
                }
            }
            rule = next;
        }
        rule
    }

    /// Number of points.
    pub fn len(&self) -> usize {
        self.weights.len()
    }

    /// Whether the rule has no points (it never has none).
    pub fn is_empty(&self) -> bool {
        self.weights.is_empty()
    }
}

/// Nodes u and weights on [0, 1] for ∫ f(u) (1−u)^a du, exact to degree 2n−1.
fn gauss_jacobi_unit(n: usize, a: usize) -> (Vec<f64>, Vec<f64>) {
    let alpha = a as f64;
    let mut nodes: Vec<f64> = Vec::with_capacity(n);
    for k in 0..n {
        // Chebyshev guess, then Newton with the roots already found divided out.
        let mut x = -((2.0 * k as f64 + 1.0) * std::f64::consts::PI / (2.0 * n as f64)).cos();
        if let Some(last) = nodes.last() {
            x = 0.5 * (x + last);
        }
        for _ in 0..100 {
            let (p, dp) = jacobi(n, alpha, x);
            let deflation: f64 = nodes.iter().map(|r| 1.0 / (x - r)).sum();
            let dx = -p / (dp - p * deflation);
            x += dx;
            if dx.abs() < 1e-15 {
                break;
            }
        }
        nodes.push(x);
    }
    // w = 2^(α+1) / [(1−x²) P'(x)²] on [−1, 1] for β = 0 (Abramowitz and Stegun 25.4.33),
    // and 2^−(α+1) of the map to [0, 1].
    let weights = nodes
        .iter()
        .map(|&x| {
            let (_, dp) = jacobi(n, alpha, x);
            1.0 / ((1.0 - x * x) * dp * dp)
        })
        .collect();
    (nodes.iter().map(|x| 0.5 * (1.0 + x)).collect(), weights)
}

/// Jacobi polynomial P_n^(α,0)(x) and its derivative.
fn jacobi(n: usize, alpha: f64, x: f64) -> (f64, f64) {
    let (mut p0, mut p1) = (1.0, 0.5 * (alpha + (alpha + 2.0) * x));
    let (mut d0, mut d1) = (0.0, 0.5 * (alpha + 2.0));
    if n == 0 {
        return (p0, d0);
    }
    for k in 2..=n {
        let k = k as f64;
        let s = 2.0 * k + alpha;
        let a1 = 2.0 * k * (k + alpha) * (s - 2.0);
        let a2 = (s - 1.0) * alpha * alpha;
        let a3 = (s - 2.0) * (s - 1.0) * s;
        let a4 = 2.0 * (k + alpha - 1.0) * (k - 1.0) * s;
        let p2 = ((a2 + a3 * x) * p1 - a4 * p0) / a1;
        let d2 = ((a2 + a3 * x) * d1 + a3 * p1 - a4 * d0) / a1;
        (p0, p1, d0, d1) = (p1, p2, d1, d2);
    }
    (p1, d1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    fn factorial(n: usize) -> f64 {
        (1..=n).map(|k| k as f64).product()
    }

    /// Closed form: ∫ x^a y^b z^c over the unit simplex = a! b! c!/(a+b+c+dim)!.
    #[test]
    fn monomials_are_integrated_exactly() {
        for dim in 1..=3 {
            for degree in 0..=14 {
                let rule = Quadrature::simplex(dim, degree);
                for a in 0..=degree {
                    for b in 0..=(if dim > 1 { degree - a } else { 0 }) {
                        for c in 0..=(if dim > 2 { degree - a - b } else { 0 }) {
                            let sum: f64 = rule
                                .points
                                .iter()
                                .zip(&rule.weights)
                                .map(|(p, w)| {
                                    w * p[0].powi(a as i32)
                                        * p[1].powi(b as i32)
                                        * p[2].powi(c as i32)
                                })
                                .sum();
                            let exact = factorial(a) * factorial(b) * factorial(c)
                                / factorial(a + b + c + dim);
                            assert_relative_eq!(sum, exact, max_relative = 1e-12);
                        }
                    }
                }
            }
        }
    }

    /// One degree more than promised is not exact: the test above can fail.
    #[test]
    fn the_degree_is_sharp() {
        let rule = Quadrature::simplex(1, 3);
        let sum: f64 = rule
            .points
            .iter()
            .zip(&rule.weights)
            .map(|(p, w)| w * p[0].powi(4))
            .sum();
        assert!((sum - 0.2).abs() > 1e-3);
    }

    #[test]
    fn all_points_lie_inside() {
        for dim in 1..=3 {
            let rule = Quadrature::simplex(dim, 11);
            for p in &rule.points {
                assert!(p[..dim].iter().all(|x| *x > 0.0) && p.iter().sum::<f64>() < 1.0);
            }
        }
    }
}
