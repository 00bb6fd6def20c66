//! Flash temperature of two bodies that rub along a line: Blok's theory with the heat of a Hertz pressure.

use std::f64::consts::PI;

use super::path::PathPoint;

/// Thermal constants of a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ThermalBody {
    /// Heat conductivity k, W/(m·K).
    pub conductivity: f64,
    /// Density ρ, kg/m³.
    pub density: f64,
    /// Specific heat capacity c, J/(kg·K).
    pub heat_capacity: f64,
}

impl ThermalBody {
    /// Diffusivity κ = k/(ρ c), m²/s.
    pub fn diffusivity(&self) -> f64 {
        self.conductivity / (self.density * self.heat_capacity)
    }
}

/// Rise (K) over the bulk temperature of the hottest place of two bodies with the speeds u_i (m/s) through a band of the half-width a (m), in which Q (W/m) is set free as
/// the Hertz pressure is distributed.
///
/// All of Q in one body: Θ_i = Q/(π k_i) max_x ∫ q(ξ) e^{P(x−ξ)} K_0(P|x − ξ|) dξ, q = (2/π) √(1 − ξ²), P = u_i a/(2κ_i). The bodies have the same temperature at
/// their hottest places:
///
/// 1/Θ = 1/Θ_1 + 1/Θ_2
///
/// A fast body has Θ_i = 0.78598 Q/(e_i √(u_i a)), e = √(k ρ c). With two of them that is Θ = 1.1115 Q/[√(2a) (e_1 √u_1 + e_2 √u_2)], the formula of ISO/TS 6336-20. A body at rest takes no heat, as its steady state under a
/// line of heat has no bound. Of bodies that move in opposite directions the hottest places differ, and Θ is an estimate.
///
/// Sources: Blok, Proc. Inst. Mech. Eng. 2, 1937, 222–235; Jaeger, J. Proc. R. Soc. N.S.W. 76, 1942, 203–224; Carslaw and Jaeger, Conduction of
/// Heat in Solids, 1959, section 10.7.
pub fn flash(heat: f64, half_width: f64, speeds: [f64; 2], bodies: [ThermalBody; 2]) -> f64 {
    if heat == 0.0 {
        return 0.0;
    }
    // 1/Θ_i per heat, m·K/W.
    let conductances = [0, 1].map(|i| {
        let (speed, body) = (speeds[i].abs(), bodies[i]);
        let peclet = 0.5 * speed * half_width / body.diffusivity();
        PI * body.conductivity / band_maximum(peclet)
    });
    heat / (conductances[0] + conductances[1])
}

impl PathPoint {
    /// Flash temperature (K) of teeth with the coefficient of friction μ: Q = μ w |u_2 − u_1|. The thermal constants are those of the pinion and the wheel.
    pub fn flash(&self, friction: f64, [pinion, wheel]: [ThermalBody; 2]) -> f64 {
        let heat = friction * self.load_per_length * self.sliding_speed.abs();
        let speeds = [self.u_1, self.u_2];
        flash(heat, self.half_width, speeds, [wheel, pinion])
    }
}

/// max_x ∫ q(ξ) e^{P(x−ξ)} K_0(P|x − ξ|) dξ over −1 to 1; infinite at P = 0.
fn band_maximum(peclet: f64) -> f64 {
    if peclet <= 0.0 {
        return f64::INFINITY;
    }
    // The rise has one maximum, between the middle and the place of the fast band, 0.652.
    let (mut from, mut to) = (0.0, 0.66);
    let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
    let (mut one, mut two) = (to - golden * (to - from), from + golden * (to - from));
    let mut values = [one, two].map(|x| band(peclet, x));
    // The maximum is flat: 1e-4 of its place is 1e-8 of its value.
    while to - from > 1e-4 {
        if values[0] > values[1] {
            (to, two, values[1]) = (two, one, values[0]);
            one = to - golden * (to - from);
            values[0] = band(peclet, one);
        } else {
            (from, one, values[0]) = (one, two, values[1]);
            two = from + golden * (to - from);
            values[1] = band(peclet, two);
        }
    }
    values[0].max(values[1])
}

/// ∫ q(ξ) e^{P(x−ξ)} K_0(P|x − ξ|) dξ over −1 to 1 by the double exponential rule on each side of x.
fn band(peclet: f64, x: f64) -> f64 {
    let side = |length: f64, direction: f64| {
        let steps = 40;
        let step = 0.09;
        (-steps..=steps)
            .map(|i| {
                let t = step * f64::from(i);
                let stretch = (-PI * t.sinh()).exp();
                let distance = length / (1.0 + stretch);
                let weight = length * PI * t.cosh() * stretch / (1.0 + stretch).powi(2);
                let xi = x - direction * distance;
                let heat = 2.0 / PI * (1.0 - xi * xi).max(0.0).sqrt();
                let z = peclet * distance;
                // Heat set free behind x in the motion has passed it; that ahead fades as e^{−2z}.
                let ahead = if direction < 0.0 {
                    (-2.0 * z).exp()
                } else {
                    1.0
                };
                weight * heat * ahead * scaled_k0(z)
            })
            .sum::<f64>()
            * step
    };
    side(1.0 + x, 1.0) + side(1.0 - x, -1.0)
}

/// e^z K_0(z) = ∫_0^∞ exp(−z (cosh t − 1)) dt. The trapezoidal rule is exact to about exp(−π²/h) at small z, where the integrand ends like a double
/// exponential, and to exp(−2π²/(h² z)) at large z, where it is a Gaussian of the width 1/√z.
fn scaled_k0(z: f64) -> f64 {
    let step = 0.35 / (1.0 + 0.25 * z).sqrt();
    let mut sum = 0.5;
    for i in 1..200 {
        // cosh t − 1 = 2 sinh²(t/2)
        let sinh = (0.5 * step * f64::from(i)).sinh();
        let term = (-2.0 * z * sinh * sinh).exp();
        sum += term;
        if term < 1e-13 {
            break;
        }
    }
    step * sum
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;
    use crate::gear::geometry::GearPair;
    use crate::gear::path::PathParams;
    use crate::gear::test_data::{c14, steel_operation};

    const STEEL: ThermalBody = ThermalBody {
        conductivity: 46.0,
        density: 7830.0,
        heat_capacity: 465.0,
    };

    /// K_0(0.1) = 2.427069, K_0(1) = 0.421024, K_0(5) = 0.0036911 (Abramowitz and Stegun, table 9.8).
    #[test]
    fn bessel_function() {
        for (z, value) in [(0.1, 2.4270690), (1.0, 0.4210244), (5.0, 0.0036910983)] {
            assert_relative_eq!(scaled_k0(z) * f64::exp(-z), value, max_relative = 1e-6);
        }
    }

    /// Against the integral over time of instantaneous line sources, evaluated by a separate program.
    #[test]
    fn band_against_instantaneous_sources() {
        for (peclet, middle, maximum) in REFERENCE {
            assert_relative_eq!(band(peclet, 0.0), middle, max_relative = 1e-7);
            assert_relative_eq!(band_maximum(peclet), maximum, max_relative = 1e-7);
        }
    }

    /// Péclet number, and π k T/Q in the middle and at the hottest place.
    const REFERENCE: [(f64, f64, f64); 4] = [
        (0.05, 4.306_634_134, 4.313_503_620),
        (0.5, 2.079_307_995, 2.171_663_038),
        (2.0, 1.049_234_596, 1.206_700_372),
        (10.0, 0.448_291_118, 0.551_639_446),
    ];

    /// The solution for any speed approaches the one for Péclet numbers u a/(2κ) far above 1, 475 and 831 here: 0.7859833957 Q/(e_i √(u_i a)) with the factor of a
    /// separate program, e = √(46·7830·465).
    #[test]
    fn fast_limit() {
        let rise = flash(5e4, 0.3e-3, [40.0, 70.0], [STEEL; 2]);
        let speeds = 40.0_f64.sqrt() + 70.0_f64.sqrt();
        let effusivity = (46.0 * 7830.0 * 465.0_f64).sqrt();
        let fast = 0.7859833957 * 5e4 / (0.3e-3_f64.sqrt() * effusivity * speeds);
        assert_relative_eq!(rise, fast, max_relative = 1e-6);
        // The formula of ISO/TS 6336-20: 1.11 μ w |u_1 − u_2|/[√(2a) (B_1 √u_1 + B_2 √u_2)].
        let by_norm = 1.11 * 5e4 / ((2.0 * 0.3e-3_f64).sqrt() * 12941.6 * speeds);
        assert_relative_eq!(rise, by_norm, max_relative = 2e-3);
    }

    /// C14 at its point E, 200 N·m, μ = 0.05, the wheel of a metal that conducts four times as well: by hand from the point's load and speeds, so fast that heat flows
    /// normal to the surface only; and some tens of kelvins at 1500 1/min.
    #[test]
    fn teeth_have_their_own_bodies() {
        let pair = GearPair::new(&c14()).expect("a pair");
        let end = |speed| {
            let path = pair.path(&steel_operation(200.0, speed), &PathParams::default());
            *path.expect("a path").last().expect("E")
        };
        let wheel = ThermalBody {
            conductivity: 4.0 * STEEL.conductivity,
            ..STEEL
        };
        let fast = end(150e3);
        // e = 12941.6 J/(m² K √s) of the pinion and twice that of the wheel.
        let parts = 12941.6 * (2.0 * fast.u_1.sqrt() + fast.u_2.sqrt());
        let heat = 0.05 * fast.load_per_length * (fast.u_2 - fast.u_1);
        let rise = 0.7859834 * heat / (fast.half_width.sqrt() * parts);
        let found = fast.flash(0.05, [STEEL, wheel]);
        assert_relative_eq!(found, rise, max_relative = 1e-5);
        let usual = end(1500.0).flash(0.05, [STEEL, wheel]);
        assert!(usual > 10.0 && usual < 100.0, "{usual}");
    }

    #[test]
    fn a_body_at_rest_takes_nothing() {
        let hot = ThermalBody {
            conductivity: 460.0,
            ..STEEL
        };
        let found = flash(1e4, 0.2e-3, [0.0, 3.0], [STEEL; 2]);
        assert_eq!(found, flash(1e4, 0.2e-3, [0.0, 3.0], [hot, STEEL]));
        assert!(found.is_finite() && found > 0.0);
        assert_eq!(flash(0.0, 0.2e-3, [1.0, 1.0], [STEEL; 2]), 0.0);
    }
}
