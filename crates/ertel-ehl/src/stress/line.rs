//! Half-space in plane strain under pressures and shears on a strip, by complex functions of w = x + iz.
//!
//! ```text
//!   G(w) = ∫ f ds/(w − s),  −G'(w) = ∫ f ds/(w − s)²;   p: pressure, q: shear on the body along +x
//!   σ_xx = −[−Im G_p − z Re G_p']/π − [2 Re G_q − z Im G_q']/π     σ_zz = −[−Im G_p + z Re G_p']/π − z Im G_q'/π
//!   σ_xz = −z Im G_p'/π − [−Im G_q − z Re G_q']/π                  σ_yy = ν (σ_xx + σ_zz)
//! ```
//! From the line loads of Flamant. Of a load that is linear between nodes s_i with slopes that change by Δm_i:
//!
//! ```text
//!   G = Σ Δm_i ζ_i ln ζ_i + Σ_ends Δf (1 + ln ζ),   −G' = −Σ Δm_i ln ζ_i − Σ_ends Δf/ζ,   ζ_i = w − s_i
//! ```

use std::f64::consts::PI;

use realfft::num_complex::Complex64;

use super::Stress;

/// Pressure and shear, linear between nodes along x.
#[derive(Clone, Debug)]
pub struct LineLoad {
    nodes: Vec<f64>,
    /// Pressure and shear at the nodes.
    values: Vec<[f64; 2]>,
    /// Changes of their slopes at the nodes.
    kinks: Vec<[f64; 2]>,
}

/// G and −G' of pressure and shear.
#[derive(Clone, Copy, Default)]
pub(super) struct Potentials {
    pub(super) first: [Complex64; 2],
    pub(super) second: [Complex64; 2],
}

/// Smallest distance from a node: zero would be infinitely far down the logarithm.
const NEAREST: f64 = 1e-150;

/// Slopes of a chord of pressure and shear that has passed no node.
const ANY_SLOPE: [[f64; 2]; 2] = [[f64::NEG_INFINITY, f64::INFINITY]; 2];

impl LineLoad {
    /// Pressure and shear on the body along x, at ascending nodes.
    pub fn new(nodes: Vec<f64>, values: Vec<[f64; 2]>) -> LineLoad {
        let mut kinks = vec![[0.0; 2]; nodes.len()];
        for i in 1..nodes.len() {
            let length = nodes[i] - nodes[i - 1];
            for k in 0..2 {
                let slope = (values[i][k] - values[i - 1][k]) / length;
                kinks[i - 1][k] += slope;
                kinks[i][k] -= slope;
            }
        }
        LineLoad {
            nodes,
            values,
            kinks,
        }
    }

    /// The same with every second node.
    #[must_use]
    pub fn coarser(&self) -> LineLoad {
        let last = self.nodes.len() - 1;
        let kept = |i: &usize| i.is_multiple_of(2) || *i == last;
        LineLoad::new(
            (0..=last).filter(kept).map(|i| self.nodes[i]).collect(),
            (0..=last).filter(kept).map(|i| self.values[i]).collect(),
        )
    }

    /// The same without nodes that lie within a share `tolerance` of the largest values of the straight lines between the others: a chord is extended while its slope
    /// passes all nodes on its way at that distance.
    #[must_use]
    pub fn thinned(&self, tolerance: f64) -> LineLoad {
        let largest = (self.values.iter()).fold([0.0_f64; 2], |m, v| {
            [m[0].max(v[0].abs()), m[1].max(v[1].abs())]
        });
        let off = largest.map(|m| tolerance * m);
        let n = self.nodes.len();
        let mut kept = vec![0];
        let (mut start, mut cone) = (0, ANY_SLOPE);
        for i in 1..n {
            let length = self.nodes[i] - self.nodes[start];
            let slope = |k: usize| (self.values[i][k] - self.values[start][k]) / length;
            let fits = (0..2).all(|k| (cone[k][0]..=cone[k][1]).contains(&slope(k)));
            if !fits {
                start = i - 1;
                kept.push(start);
                cone = ANY_SLOPE;
            }
            let length = self.nodes[i] - self.nodes[start];
            for k in 0..2 {
                let slope = (self.values[i][k] - self.values[start][k]) / length;
                let [low, high] = cone[k];
                cone[k] = [
                    low.max(slope - off[k] / length),
                    high.min(slope + off[k] / length),
                ];
            }
        }
        if n > 1 {
            kept.push(n - 1);
        }
        LineLoad::new(
            kept.iter().map(|i| self.nodes[*i]).collect(),
            kept.iter().map(|i| self.values[*i]).collect(),
        )
    }

    /// Stress at (x, z), z ≥ 0.
    pub fn at(&self, x: f64, z: f64, poisson: f64) -> Stress {
        plane_strain(&self.potentials(x, z), z, poisson)
    }

    /// G and −G' at (x, z), z ≥ 0.
    pub(super) fn potentials(&self, x: f64, z: f64) -> Potentials {
        let mut g = Potentials::default();
        for (node, kink) in self.nodes.iter().zip(&self.kinks) {
            let (zeta, ln) = logarithm(x - node, z);
            for k in 0..2 {
                g.first[k] += kink[k] * zeta * ln;
                g.second[k] -= kink[k] * ln;
            }
        }
        for (node, values, sign) in [
            (self.nodes.first(), self.values.first(), 1.0),
            (self.nodes.last(), self.values.last(), -1.0),
        ] {
            let (Some(node), Some(values)) = (node, values) else {
                continue;
            };
            let (zeta, ln) = logarithm(x - node, z);
            for k in (0..2).filter(|k| values[*k] != 0.0) {
                g.first[k] += sign * values[k] * (1.0 + ln);
                g.second[k] -= sign * values[k] / zeta;
            }
        }
        g
    }
}

/// ζ and ln ζ.
fn logarithm(x: f64, z: f64) -> (Complex64, Complex64) {
    let squared = (x * x + z * z).max(NEAREST * NEAREST);
    let zeta = match x == 0.0 && z == 0.0 {
        true => Complex64::new(NEAREST, 0.0),
        false => Complex64::new(x, z),
    };
    (zeta, Complex64::new(0.5 * squared.ln(), z.atan2(x)))
}

/// The stress that belongs to the functions at a depth.
pub(super) fn plane_strain(g: &Potentials, z: f64, poisson: f64) -> Stress {
    let [p, q] = g.first;
    // At the surface these products vanish, also where the functions do not exist.
    let [dp, dq] = match z == 0.0 {
        true => [Complex64::default(); 2],
        false => g.second.map(|g| z * g),
    };
    let xx = -(-p.im + dp.re) / PI - (2.0 * q.re + dq.im) / PI;
    let zz = -(-p.im - dp.re) / PI + dq.im / PI;
    let xz = dp.im / PI - (-q.im + dq.re) / PI;
    Stress([xx, poisson * (xx + zz), zz, 0.0, xz, 0.0])
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    /// Hertz's pressure and a shear of a tenth on 4,001 nodes: a tolerance of 1e-5 keeps less than an eighth of them, and all stresses to 2e-5 of the largest pressure. Nodes on
    /// a straight line are not needed.
    #[test]
    fn thinned_loads() {
        let hertz = |x: f64| (1.0 - x * x).max(0.0).sqrt();
        let nodes: Vec<f64> = (0..=4000).map(|i| -2.0 + 1e-3 * f64::from(i)).collect();
        let values = nodes.iter().map(|x| [hertz(*x), 0.1 * hertz(*x)]).collect();
        let load = LineLoad::new(nodes, values);
        let thinned = load.thinned(1e-5);
        assert!(thinned.nodes.len() < 500, "{}", thinned.nodes.len());
        for (x, z) in [(0.0, 0.786), (0.9, 0.01), (-0.99, 0.0), (0.3, 0.2)] {
            let [own, other] = [&load, &thinned].map(|load| load.at(x, z, 0.3).0);
            for (own, other) in own.into_iter().zip(other) {
                assert_relative_eq!(own, other, epsilon = 2e-5);
            }
        }
        let line = LineLoad::new(
            vec![0.0, 1.0, 2.0, 4.0],
            vec![[0.0; 2], [1.0; 2], [2.0; 2], [4.0; 2]],
        );
        assert_eq!(line.thinned(1e-9).nodes, [0.0, 4.0]);
    }
}
