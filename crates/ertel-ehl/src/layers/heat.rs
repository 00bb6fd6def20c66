//! Heat in a body with layers: how its surface warms up.
//!
//! Waves e^(ikx + st) of the heat q that flows in through the surface, with conduction in every direction:
//!
//! ```text
//!   T = Z q,  Z = (Z_b y + t)/(1 + Z_b y t)/y,  y = k γ,  t = tanh γd,  γ² = k_x² + s ρc/k      layer by layer from below
//!   Z_b = 0 at the depth D, where the bulk temperature is prescribed
//! ```
//! A pulse of heat that enters at t = 0 leaves a rise g(t) and has spread along the surface over the variance 2V, the mean of χ over the time that heat spent in each
//! material. Both follow from Z by inverting the Laplace transform (Talbot; Abate and Whitt 2006, INFORMS J. Comput. 18, 408):
//!
//! ```text
//!   G(k_x², t) = g E[e^(−k_x² V)] ≈ g Σ p_i e^(−k_x² V_i)       two points V_i by the first three moments of V
//! ```
//! A homogeneous body has V = χt exactly. Fluxes at interfaces and temperatures there are continuous.
//!
//! Theory: Layers on the bodies.

use std::f64::consts::PI;

use realfft::num_complex::Complex64;

/// Thermal constants of a material.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ThermalMaterial {
    /// k, W/(m·K).
    pub conductivity: f64,
    /// ρc, J/(m³·K).
    pub capacity: f64,
}

impl ThermalMaterial {
    /// χ, m²/s.
    pub fn diffusivity(&self) -> f64 {
        self.conductivity / self.capacity
    }
}

/// A layer that conducts heat.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HeatLayer {
    /// m.
    pub thickness: f64,
    /// Its material.
    pub material: ThermalMaterial,
}

impl HeatLayer {
    /// Of a thickness in m, k in W/(m·K) and ρc in J/(m³·K).
    pub fn new(thickness: f64, conductivity: f64, capacity: f64) -> HeatLayer {
        HeatLayer {
            thickness,
            material: ThermalMaterial {
                conductivity,
                capacity,
            },
        }
    }
}

/// A pulse of heat of 1 J/m² at the surface, some time later.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pulse {
    /// g, K·m²/J.
    pub rise: f64,
    /// Shares p_i of the rise and their V_i, m².
    pub spread: [[f64; 2]; 2],
}

/// A body of layers from the surface to the depth at which its temperature is prescribed.
#[derive(Clone, Debug, PartialEq)]
pub struct HeatedBody {
    /// All slabs from the surface down; the last one is the substrate.
    slabs: Vec<HeatLayer>,
}

/// Points of the contour: relative errors of 1e-7.
const CONTOUR: usize = 12;
/// Points of the circle in k_x² around 0 from which the moments of V follow, and its radius over 1/V: g errs by its eighth power over 8!.
const CIRCLE: usize = 8;
const RADIUS: f64 = 0.5;
/// Variance of V over the square of its mean from which two points of it are distinct from noise.
const VARIED: f64 = 1e-5;

impl HeatedBody {
    /// Layers on a substrate, down to a depth in m; layers below it have no effect.
    pub fn new(layers: &[HeatLayer], substrate: ThermalMaterial, depth: f64) -> HeatedBody {
        let mut left = depth;
        let mut slabs = Vec::new();
        let below = HeatLayer {
            thickness: f64::INFINITY,
            material: substrate,
        };
        for layer in layers.iter().chain([&below]) {
            let thickness = layer.thickness.min(left);
            slabs.push(HeatLayer {
                thickness,
                ..*layer
            });
            left -= thickness;
            if left <= 0.0 {
                break;
            }
        }
        HeatedBody { slabs }
    }

    /// Z of waves whose k_x² is `along`, 1/m², and that change like e^(st), 1/s; K·m²/W.
    pub fn impedance(&self, along: Complex64, s: Complex64) -> Complex64 {
        let mut below = Complex64::default();
        for HeatLayer {
            thickness,
            material,
        } in self.slabs.iter().rev()
        {
            let gamma = (along + s / material.diffusivity()).sqrt();
            if gamma.norm() == 0.0 {
                // Steady and uniform: resistances add up.
                below += thickness / material.conductivity;
                continue;
            }
            let y = material.conductivity * gamma;
            let e = (-2.0 * thickness * gamma).exp();
            let t = (1.0 - e) / (1.0 + e);
            below = (below * y + t) / ((1.0 + below * y * t) * y);
        }
        below
    }

    /// After a time in s.
    pub fn pulse(&self, time: f64) -> Pulse {
        let bounds = self.diffusivities().map(|chi| chi * time);
        let radius = RADIUS / bounds[1];
        // Coefficients of the powers of k_x², by values on a circle; those of conjugate points are conjugate.
        let mut powers = [0.0; 4];
        for l in 0..=CIRCLE / 2 {
            let mut turn = Complex64::cis(2.0 * PI * l as f64 / CIRCLE as f64);
            if l == CIRCLE / 2 {
                turn = Complex64::from(-1.0);
            }
            let value = self.inverted(radius * turn, time);
            let weight = if l % (CIRCLE / 2) == 0 { 1.0 } else { 2.0 };
            for (j, power) in powers.iter_mut().enumerate() {
                *power += weight / CIRCLE as f64 * (value * turn.conj().powu(j as u32)).re;
            }
        }
        let [rise, first, second, third] = powers;
        // E[V^j] = (−1)^j j! times the coefficient.
        let mean = -first / (radius * rise);
        let square = 2.0 * second / (radius * radius * rise);
        let cube = -6.0 * third / (radius.powi(3) * rise);
        Pulse {
            rise,
            spread: two_points([mean, square, cube], bounds),
        }
    }

    /// Rises of the surface by waves of a pulse, K·m²/J: the inverse transform of Z in time.
    fn inverted(&self, along: Complex64, time: f64) -> Complex64 {
        let n = CONTOUR as f64;
        let of = |s: Complex64, weight: Complex64| {
            let above = weight * self.impedance(along, s / time);
            // The other half of the contour is its conjugate where k_x² is real.
            match along.im == 0.0 {
                true => Complex64::from(above.re),
                false => 0.5 * (above + weight.conj() * self.impedance(along, s.conj() / time)),
            }
        };
        let mut sum = of(
            Complex64::from(0.4 * n),
            Complex64::from(0.5 * (0.4 * n).exp()),
        );
        for k in 1..CONTOUR {
            let angle = k as f64 * PI / n;
            let cot = 1.0 / angle.tan();
            let s = Complex64::new(cot, 1.0) * (0.4 * k as f64 * PI);
            let weight = Complex64::new(1.0, angle * (1.0 + cot * cot) - cot) * s.exp();
            sum += of(s, weight);
        }
        sum * (0.4 / time)
    }

    /// Smallest and largest χ, m²/s.
    pub fn diffusivities(&self) -> [f64; 2] {
        (self.slabs.iter()).fold([f64::INFINITY, 0.0], |[low, high], slab| {
            let chi = slab.material.diffusivity();
            [low.min(chi), high.max(chi)]
        })
    }

    /// Shortest time in which heat passes a slab, and one in which the whole body falls to 1/e at the latest, s.
    pub fn times(&self) -> [f64; 2] {
        let passages = self
            .slabs
            .iter()
            .map(|slab| slab.thickness.powi(2) / slab.material.diffusivity());
        let resistance: f64 = self
            .slabs
            .iter()
            .map(|slab| slab.thickness / slab.material.conductivity)
            .sum();
        let capacity: f64 = self
            .slabs
            .iter()
            .map(|slab| slab.thickness * slab.material.capacity)
            .sum();
        [
            passages.fold(f64::INFINITY, f64::min),
            resistance * capacity,
        ]
    }
}

/// Two points between bounds that have the first three moments; one where the variance is noise.
fn two_points([mean, square, cube]: [f64; 3], [low, high]: [f64; 2]) -> [[f64; 2]; 2] {
    let variance = square - mean * mean;
    // Neither where the rise itself is noise.
    let is_varied = variance > VARIED * mean * mean;
    if !is_varied {
        return [[1.0, mean.clamp(low, high)], [0.0, low]];
    }
    let width = variance.sqrt();
    let skewness = (cube - 3.0 * mean * square + 2.0 * mean.powi(3)) / variance.powf(1.5);
    let half = (1.0 + 0.25 * skewness * skewness).sqrt();
    let [first, second] =
        [1.0, -1.0].map(|sign| (mean + width * (0.5 * skewness + sign * half)).clamp(low, high));
    let share = ((mean - second) / (first - second)).clamp(0.0, 1.0);
    [[share, first], [1.0 - share, second]]
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// k₁/k₂, ρc₁/ρc₂, k_x d, u d/χ₂, and T k₂/(q d) of a moving body with one layer, in closed form, computed separately.
    const WAVES: &[[f64; 6]] = &[
        [0.05, 0.55, 0.1, 0.0, 29.78516753, 0.0],
        [0.05, 0.55, 0.1, 10.0, 4.210957278, -4.318908854],
        [0.05, 0.55, 0.5, 0.0, 20.02205943, 0.0],
        [0.05, 0.55, 0.5, 10.0, 1.911217308, -1.902678058],
        [0.05, 0.55, 1.0, 0.0, 15.63645161, 0.0],
        [0.05, 0.55, 1.0, 10.0, 1.354487625, -1.34222903],
        [0.05, 0.55, 2.0, 0.0, 9.67397678, 0.0],
        [0.05, 0.55, 2.0, 10.0, 0.9620104723, -0.9446783681],
        [0.2, 0.55, 0.1, 0.0, 14.69056392, 0.0],
        [0.2, 0.55, 0.1, 10.0, 2.434083527, -2.113149016],
        [0.2, 0.55, 0.5, 0.0, 6.060993734, 0.0],
        [0.2, 0.55, 0.5, 10.0, 0.9555013922, -0.9466650373],
        [0.2, 0.55, 1.0, 0.0, 4.172430971, 0.0],
        [0.2, 0.55, 1.0, 10.0, 0.686223323, -0.6611266538],
        [0.2, 0.55, 2.0, 0.0, 2.43968435, 0.0],
        [0.2, 0.55, 2.0, 10.0, 0.4930690704, -0.4585235613],
        [5.0, 1.0, 0.1, 0.0, 6.807090628, 0.0],
        [5.0, 1.0, 0.1, 10.0, 0.3301715348, -0.5186734084],
        [5.0, 1.0, 0.5, 0.0, 0.6599577851, 0.0],
        [5.0, 1.0, 0.5, 10.0, 0.1394342395, -0.148500077],
        [5.0, 1.0, 1.0, 0.0, 0.2396684348, 0.0],
        [5.0, 1.0, 1.0, 10.0, 0.1077399121, -0.07651435169],
        [5.0, 1.0, 2.0, 0.0, 0.1024722727, 0.0],
        [5.0, 1.0, 2.0, 10.0, 0.07692357481, -0.03278800531],
        [10.0, 0.5, 0.1, 0.0, 5.058230796, 0.0],
        [10.0, 0.5, 0.1, 10.0, 0.4550027804, -0.5828885203],
        [10.0, 0.5, 0.5, 0.0, 0.3722397376, 0.0],
        [10.0, 0.5, 0.5, 10.0, 0.1730488306, -0.1233088623],
        [10.0, 0.5, 1.0, 0.0, 0.1249032863, 0.0],
        [10.0, 0.5, 1.0, 10.0, 0.0991086925, -0.0350243252],
        [10.0, 0.5, 2.0, 0.0, 0.05152135051, 0.0],
        [10.0, 0.5, 2.0, 10.0, 0.04965941449, -0.006946591285],
    ];

    /// The unit of length is the thickness, and the substrate has k = ρc = 1.
    fn coated(k: f64, capacity: f64) -> HeatedBody {
        let layer = HeatLayer::new(1.0, k, capacity);
        let substrate = ThermalMaterial {
            conductivity: 1.0,
            capacity: 1.0,
        };
        HeatedBody::new(&[layer], substrate, 1e4)
    }

    #[test]
    fn waves_of_heat() {
        for [k, capacity, wave, speed, real, imaginary] in WAVES {
            let s = Complex64::new(0.0, wave * speed);
            let found = coated(*k, *capacity).impedance((wave * wave).into(), s);
            let exact = Complex64::new(*real, *imaginary);
            assert!(
                (found - exact).norm() < 1e-9 * exact.norm(),
                "{found} {exact}"
            );
        }
    }

    /// The same by pulses, which have three moments of the spread: enough for moving bodies. Heat in a body at rest has spread much further along a good conductor.
    #[test]
    fn waves_of_heat_by_pulses() {
        // Longer waves of moving bodies would need many more steps.
        let rows = WAVES.iter().filter(|row| row[3] == 0.0 || row[2] > 0.1);
        for [k, capacity, wave, speed, real, imaginary] in rows {
            let body = coated(*k, *capacity);
            let (low, high, n) = (1e-9_f64.ln(), (60.0 / (wave * wave)).ln(), 1600);
            let step = (high - low) / f64::from(n);
            let mut sum = Complex64::default();
            for i in 0..n {
                let t = (low + (f64::from(i) + 0.5) * step).exp();
                let pulse = body.pulse(t);
                let spread = (pulse.spread.iter()).map(|[p, v]| p * (-wave * wave * v).exp());
                let phase = Complex64::cis(-wave * speed * t);
                sum += t * step * pulse.rise * spread.sum::<f64>() * phase;
            }
            // Before the first of these times, g ~ 1/√t.
            let first = 1e-9_f64;
            sum += 2.0 * first * body.pulse(first).rise;
            let exact = Complex64::new(*real, *imaginary);
            let most = match (*speed == 0.0, *k < 1.0) {
                (true, true) => 8e-3,
                (true, false) => 2.5e-2,
                (false, true) => 1e-4,
                (false, false) => 2e-3,
            };
            let error = (sum - exact).norm() / exact.norm();
            assert!(error < most, "{k} {wave} {speed}: {error}");
        }
    }

    /// Uniform heat q from t = 0 on, for so long; rise in K with 1e8 W/m² (the sum over images of the interface, computed separately): k, ρc, d, t.
    #[test]
    fn uniform_heat() {
        let steel = ThermalMaterial {
            conductivity: 46.0,
            capacity: 7850.0 * 460.0,
        };
        for [k, capacity, thickness, time, known] in [
            [2.2, 2000000.0, 2e-6, 1e-8, 5.379336612],
            [2.2, 2000000.0, 2e-6, 1e-6, 53.58534643],
            [2.2, 2000000.0, 2e-6, 0.0001, 174.4839855],
            [2.2, 2000000.0, 5e-7, 1e-8, 5.379336612],
            [2.2, 2000000.0, 5e-7, 1e-6, 29.82256393],
            [2.2, 2000000.0, 5e-7, 0.0001, 109.579582],
            [600.0, 1820000.0, 2e-6, 1e-8, 0.3608202087],
            [600.0, 1820000.0, 2e-6, 1e-6, 7.183516949],
            [600.0, 1820000.0, 2e-6, 0.0001, 85.72281728],
            [1.0, 2700000.0, 1e-6, 1e-8, 6.867096925],
            [1.0, 2700000.0, 1e-6, 1e-6, 67.76143302],
            [1.0, 2700000.0, 1e-6, 0.0001, 184.7526178],
        ] {
            let layer = HeatLayer::new(thickness, k, capacity);
            let body = HeatedBody::new(&[layer], steel, 0.1);
            // dt = 2√t d√t
            let n = 4000;
            let step = time.sqrt() / f64::from(n);
            let rise = |i: i32| {
                let root = (f64::from(i) + 0.5) * step;
                2.0 * root * step * body.pulse(root * root).rise
            };
            let found: f64 = (0..n).map(rise).sum();
            assert_relative_eq!(1e8 * found, known, max_relative = 1e-6);
        }
    }

    /// Layers of the same material, one of no thickness, and one that reaches below the depth.
    #[test]
    fn limits_of_layers() {
        let material = |conductivity: f64, capacity: f64| ThermalMaterial {
            conductivity,
            capacity,
        };
        let of = |layers: &[(f64, ThermalMaterial)], substrate| {
            let layers: Vec<HeatLayer> = (layers.iter())
                .map(|&(thickness, material)| HeatLayer {
                    thickness,
                    material,
                })
                .collect();
            HeatedBody::new(&layers, substrate, 3.0)
        };
        let (one, other) = (material(2.0, 3.0), material(0.4, 1.0));
        // Steady, uniform heat passes all layers.
        let steady = of(&[(0.5, other)], one).impedance(0.0.into(), 0.0.into());
        assert_relative_eq!(steady.re, 0.5 / 0.4 + 2.5 / 2.0, max_relative = 1e-14);
        for t in [1e-3, 0.1, 10.0] {
            let bare = of(&[], one).pulse(t);
            // One material spreads by χt at all times.
            assert_relative_eq!(bare.spread[0][1], 2.0 / 3.0 * t, max_relative = 1e-6);
            for same in [
                of(&[(0.2, one), (0.5, one)], one),
                of(&[(1e-12, other)], one),
                of(&[(5.0, one)], other),
            ] {
                assert_relative_eq!(same.pulse(t).rise, bare.rise, max_relative = 1e-6);
            }
        }
    }
}
