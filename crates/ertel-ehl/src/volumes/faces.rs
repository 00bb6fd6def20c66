//! Mass flux through the faces between nodes, with its derivatives.
//!
//! ```text
//!   F = ū m − H₊³/λ · ½(ρ̄_a + ρ̄_b) · φ · (P_b − P_a)/h,     H₊ = max(H, 0) at the face,  m = ρ̄H
//!   φ = (e^(−l_a) − e^(−l_b))/(l_b − l_a),  l = ln μ̄         exponential fitting (Scharfetter and Gummel 1969)
//!   m = m_u + ¼s((1 − ⅓s) b + (1 + ⅓s) a),  a = m_d − m_u,  b = m_u − m_uu      third-order upwind where s = 1
//!   s = (1 − r²)² or 0,  r = (a − b)²/(a² + b² + e²),  e = m/5  limited where slopes differ much (van Albada et al. 1982: s = 1 − r)
//! ```
//! Where slopes differ a little, s = 1 − r takes 6 % off the correction and films converge at first order; (1 − r²)² leaves them at second order and has no kink at r = 1.
//! φ is exact where ln μ̄ is linear between the nodes. Where stress thins the film, l is ln(μ̄/K) of the nodes, and −H₊³ρ̄/λ · ½(c_a + c_b) is added for the gradient
//! across (see [`super::thinning`]). A negative film has no pressure-driven flow; its entrained flow keeps its sign, and
//! a grid too coarse for a film still has a solution.

use super::node::Node;
use super::thinning::Thinned;

/// Flux through a face and its derivatives.
#[derive(Clone, Copy, Debug, Default)]
pub struct Face {
    /// F.
    pub flux: f64,
    /// ∂F by the pressures on either side, at fixed film and entrained mass.
    pub by_pressure: [f64; 2],
    /// ∂F by the films on either side, at fixed entrained mass.
    pub by_film: [f64; 2],
    /// ∂F by l of either side.
    pub by_resistance: [f64; 2],
    /// ∂F by c of either side.
    pub by_oblique: f64,
    /// ∂F by m of the nodes uu, u, d.
    pub by_mass: [f64; 3],
    /// ∂F by the content of the node upstream, where that does not fill the face.
    pub by_content: f64,
    /// u.
    pub entrainment: f64,
    /// m at the face where the gap is full upstream.
    pub mass: f64,
    /// Whether the flow comes from the second node.
    pub from_second: bool,
}

/// Difference of ln μ̄ below which φ is taken by its series.
const NEAR: f64 = 1e-2;

/// φ and its derivatives by l_a and l_b.
#[inline(always)]
pub fn fitted(a: f64, b: f64) -> [f64; 3] {
    let d = b - a;
    if d.abs() < NEAR {
        let mean = (-0.5 * (a + b)).exp();
        let x = 0.25 * d * d;
        let phi = mean * (1.0 + x / 6.0 * (1.0 + x / 20.0));
        let slope = mean * d / 12.0 * (1.0 + x / 10.0);
        return [phi, -0.5 * phi - slope, -0.5 * phi + slope];
    }
    let (ea, eb) = ((-a).exp(), (-b).exp());
    let phi = (ea - eb) / d;
    [phi, (phi - ea) / d, (eb - phi) / d]
}

/// Relative change of m from node to node below which differing slopes do not count as a kink. At half this value, a ball in a groove needs a grid of three times as many
/// nodes for the film at its steep lobe; without a limiter, the pressure ridge has ripples of a tenth of its height.
const SMOOTH: f64 = 0.2;

/// m at a face from the nodes uu, u, d, and its derivatives by them.
#[inline(always)]
pub fn upwind([uu, u, d]: [f64; 3]) -> (f64, [f64; 3]) {
    let (a, b) = (d - u, u - uu);
    let mean = 0.5 * SMOOTH * (u.abs() + d.abs()) + f64::MIN_POSITIVE;
    let second = a - b;
    let m = a * a + b * b + mean * mean;
    let r = second * second / m;
    if r >= 1.0 {
        return (u, [0.0, 1.0, 0.0]);
    }
    let root = 1.0 - r * r;
    let (s, slope) = (root * root, -4.0 * r * root);
    let value = u + 0.25 * s * ((1.0 - s / 3.0) * b + (1.0 + s / 3.0) * a);
    let by_r = 0.25 * slope * ((1.0 - s / 1.5) * b + (1.0 + s / 1.5) * a) / m;
    let by_a = 0.25 * s * (1.0 + s / 3.0) + by_r * 2.0 * (second - r * a);
    let by_b = 0.25 * s * (1.0 - s / 3.0) - by_r * 2.0 * (second + r * b);
    let by_mean = -by_r * r * SMOOTH * mean;
    let slopes = [
        -by_b,
        1.0 - by_a + by_b + by_mean * u.signum(),
        by_a + by_mean * d.signum(),
    ];
    (value, slopes)
}

/// Resistance to pressure-driven flow at a node along the direction of a face, also that of rough surfaces: l and c with their derivatives by P and by H.
#[derive(Clone, Copy, Debug)]
pub struct Resistance {
    /// l.
    pub ln: [f64; 3],
    /// c.
    pub oblique: [f64; 3],
}

impl Resistance {
    /// Of a node, thinned or not, along a direction of the grid.
    #[inline(always)]
    pub fn new(node: &Node, thinned: Option<&Thinned>, direction: usize) -> Resistance {
        let ([ln, by_p], [passage, by_film]) = (node.ln_viscosity, node.ln_passage[direction]);
        let Some(thinned) = thinned else {
            return Resistance {
                ln: [ln - passage, by_p, -by_film],
                oblique: [0.0; 3],
            };
        };
        let [flow, flow_by_p, flow_by_film, ..] = thinned.ln_flow[direction];
        let [c, c_by_p, c_by_film, ..] = thinned.oblique[direction];
        Resistance {
            ln: [
                ln - flow - passage,
                by_p - flow_by_p,
                -flow_by_film - by_film,
            ],
            oblique: [c, c_by_p, c_by_film],
        }
    }
}

/// Flux from node a to node b at the distance h, with the entrainment u along that direction; `beyond` are the nodes before a and behind b.
#[inline(always)]
pub fn face(
    [a, b]: [&Node; 2],
    resistance: [Resistance; 2],
    beyond: [&Node; 2],
    u: f64,
    lambda: f64,
    h: f64,
) -> Face {
    let film = (0.5 * (a.film + b.film)).max(0.0);
    let [from, to] = resistance;
    let [phi, by_a, by_b] = fitted(from.ln[0], to.ln[0]);
    let density = 0.5 * (a.density[0] + b.density[0]);
    let scale = film * film * film / (lambda * h);
    let difference = b.pressure - a.pressure;
    let conductance = scale * density * phi;
    // Both sides weigh the same in the gradient across.
    let across = 0.5 * scale * h * density;
    let oblique = from.oblique[0] + to.oblique[0];
    let by = |node: &Node, own: &Resistance, slope: f64| {
        let by_density = 0.5 * node.density[1] / density;
        [
            -scale * difference * density * (slope * own.ln[1] + phi * by_density)
                - across * (own.oblique[1] + oblique * by_density),
            -scale * difference * density * slope * own.ln[2] - across * own.oblique[2],
        ]
    };
    let driven = -conductance * difference - across * oblique;
    let by_height = if film > 0.0 { 1.5 * driven / film } else { 0.0 };
    let [[a_by_p, a_by_film], [b_by_p, b_by_film]] = [by(a, &from, by_a), by(b, &to, by_b)];
    let mut face = Face {
        flux: driven,
        by_pressure: [conductance + a_by_p, -conductance + b_by_p],
        by_film: [by_height + a_by_film, by_height + b_by_film],
        by_resistance: [by_a, by_b].map(|slope| -scale * difference * density * slope),
        by_oblique: -across,
        by_mass: [0.0; 3],
        by_content: 0.0,
        entrainment: u,
        mass: 0.0,
        from_second: u < 0.0,
    };
    if u != 0.0 {
        let [uu, up, down] = match face.from_second {
            false => [beyond[0], a, b],
            true => [beyond[1], b, a],
        };
        let (mass, by_mass) = upwind([uu.mass, up.mass, down.mass]);
        face.flux += u * mass;
        face.by_mass = by_mass.map(|slope| u * slope);
        face.mass = mass;
    }
    face
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    fn node(pressure: f64, film: f64) -> Node {
        // ρ̄ = 1 + 0.2 P, ln μ̄ = 15 P^0.8, m = ρ̄H
        let density = [1.0 + 0.2 * pressure, 0.2];
        Node {
            pressure,
            film,
            density,
            ln_viscosity: [15.0 * pressure.powf(0.8), 12.0 * pressure.powf(-0.2)],
            mass: density[0] * film,
            mass_by: [density[1] * film, density[0]],
            ..Node::default()
        }
    }

    /// Where ln μ̄ grows in proportion to the pressure, the flux is that of the reduced pressure (1 − e^(−αP))/α, whatever the step is: by
    /// hand for α = 20 from P = 0.1 to 0.9, φ ΔP = (e^−2 − e^−18)/20.
    #[test]
    fn fitting_is_exact_for_barus() {
        let [phi, ..] = fitted(2.0, 18.0);
        assert_relative_eq!(
            phi * 0.8,
            (0.135_335_283_2 - 1.523e-8) / 20.0,
            max_relative = 1e-9
        );
        let near = fitted(1.0, 1.0 + 0.999 * NEAR);
        let far = fitted(1.0, 1.0 + 1.001 * NEAR);
        for (near, far) in near.into_iter().zip(far) {
            assert_relative_eq!(near, far, max_relative = 1e-4);
        }
    }

    /// Thinned as ln K = 0.3 P − 0.4 H, c = 0.2 P H, or not at all.
    fn resistances(nodes: [&Node; 2], thins: bool) -> [Resistance; 2] {
        nodes.map(|node| {
            let (p, h) = (node.pressure, node.film);
            let thinned = Thinned {
                ln_flow: [[0.3 * p - 0.4 * h, 0.3, -0.4, 0.0, 0.0]; 2],
                oblique: [[0.2 * p * h, 0.2 * h, 0.2 * p, 0.0, 0.0]; 2],
            };
            Resistance::new(node, thins.then_some(&thinned), 0)
        })
    }

    /// By hand: H = 0.1, ρ̄ = 1.06 and c = 0.2 P H = 0.006 at both nodes, which have the same pressure: −H³ρ̄c/λ = −0.001 · 1.06 · 0.006/0.02.
    #[test]
    fn oblique_flow_by_hand() {
        let nodes = [node(0.3, 0.1), node(0.3, 0.1)];
        let ends = [&nodes[0], &nodes[1]];
        let flux = face(ends, resistances(ends, true), ends, 0.0, 0.02, 0.05).flux;
        assert_relative_eq!(flux, -3.18e-4, max_relative = 1e-12);
    }

    /// All derivatives of a flux against differences, flow from either side, where it is smooth, at a kink and where it turns, thinned and not.
    #[test]
    fn derivatives_against_differences() {
        let films = [
            [0.11, 0.10, 0.098, 0.097],
            [0.2, 0.1, 0.09, 0.3],
            [0.1, 0.2, 0.1, 0.05],
        ];
        let pressures = [0.25, 0.3, 0.36, 0.4];
        for films in films {
            for (u, thins) in [(1.0, false), (-0.7, true)] {
                let at = |p: [f64; 4], h: [f64; 4]| {
                    let n = [0, 1, 2, 3].map(|i: usize| node(p[i], h[i]));
                    let ends = [&n[1], &n[2]];
                    let resistance = resistances(ends, thins);
                    face(ends, resistance, [&n[0], &n[3]], u, 0.02, 0.05)
                };
                let f = at(pressures, films);
                let nodes = [0, 1, 2, 3].map(|i: usize| node(pressures[i], films[i]));
                // uu, u, d among the four.
                let order = if u > 0.0 { [0, 1, 2] } else { [3, 2, 1] };
                for i in 0..4 {
                    let by_mass = (0..3)
                        .find(|k| order[*k] == i)
                        .map_or(0.0, |k| f.by_mass[k]);
                    let side = [None, Some(0), Some(1), None][i];
                    let by_pressure = side.map_or(0.0, |s: usize| f.by_pressure[s]);
                    let by_film = side.map_or(0.0, |s: usize| f.by_film[s]);
                    let step = 1e-6;
                    let moved = |dp: f64, dh: f64| {
                        let (mut p, mut h) = (pressures, films);
                        p[i] += dp;
                        h[i] += dh;
                        at(p, h).flux
                    };
                    let difference = (moved(step, 0.0) - moved(-step, 0.0)) / (2.0 * step);
                    let own = by_pressure + by_mass * nodes[i].mass_by[0];
                    assert_relative_eq!(own, difference, max_relative = 1e-5, epsilon = 1e-7);
                    let difference = (moved(0.0, step) - moved(0.0, -step)) / (2.0 * step);
                    let own = by_film + by_mass * nodes[i].mass_by[1];
                    assert_relative_eq!(own, difference, max_relative = 1e-5, epsilon = 1e-7);
                }
            }
        }
    }

    /// A higher pressure drives more flow out of its node and none in, though the viscosity changes by ten decades between the nodes.
    #[test]
    fn fluxes_are_monotone() {
        for (a, b) in [(0.05, 0.95), (0.95, 0.05), (0.3, 0.31), (0.0001, 1.2)] {
            let nodes = [node(a, 0.01), node(b, 0.01)];
            let ends = [&nodes[0], &nodes[1]];
            let f = face(ends, resistances(ends, false), ends, 0.0, 0.02, 0.05);
            assert!(
                f.by_pressure[0] > 0.0 && f.by_pressure[1] < 0.0,
                "{a} {b} {f:?}"
            );
        }
    }

    /// A quadratic comes back exactly where it is smooth (differences of face values are those of third order), and a step overshoots by less than a fiftieth of it.
    #[test]
    fn upwind_values() {
        let q = |x: f64| 5.0 + 0.01 * x + 0.004 * x * x;
        let (value, _) = upwind([q(-1.0), q(0.0), q(1.0)]);
        let (before, _) = upwind([q(-2.0), q(-1.0), q(0.0)]);
        assert_relative_eq!(value - before, 0.01, max_relative = 1e-3);
        for step in [[1.0, 1.0, 3.0], [3.0, 1.0, 1.0], [1.0, 3.0, 3.0]] {
            let (value, _) = upwind(step);
            assert!((0.97..=3.03).contains(&value), "{step:?} {value}");
        }
    }
}
