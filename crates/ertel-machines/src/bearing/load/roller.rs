//! A roller between its raceways, slice by slice.

use std::convert::Infallible;

use nalgebra::{Matrix2, Vector2};

use super::newton::{ACCEPTED, NEGLIGIBLE, RESIDUAL, STEPS, part_of_step};
use crate::bearing::Material;

/// Exponent of the load of a slice.
const EXPONENT: f64 = 10.0 / 9.0;

/// Stiffness of a roller of steel of the length L (m) between both raceways, N/m^(10/9).
///
/// q = c_L δ^(10/9),  c_L = 35948 L^(8/9) with L and δ in mm
///
/// Source: ISO/TS 16281, as MESYS's manual and public implementations quote it; it applies to E' = 226 GPa, and other materials are taken
/// to be stiffer or softer in proportion to E'.
fn stiffness(length: f64, material: Material) -> f64 {
    // mm^(−8/9) mm^(−10/9) = mm^(−2)
    let steel = 35_948.0 * 1e6 * length.powf(8.0 / 9.0);
    steel * material.reduced_modulus / Material::STEEL.reduced_modulus
}

/// A roller in slices.
#[derive(Clone, Debug)]
pub(crate) struct Roller {
    /// Middles of the slices, m, and the drop there.
    pub slices: Vec<[f64; 2]>,
    /// Length of a slice, m.
    pub width: f64,
    /// Of one contact of a slice, N/m^(10/9).
    stiffness: f64,
    /// N.
    centrifugal: f64,
}

/// A roller in balance.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct RollerState {
    /// Loads of the slices on both rings, N.
    pub slices: [Vec<f64>; 2],
    /// Radial force, N, and moment, N·m, on the inner ring.
    pub force: Vector2<f64>,
    /// Change of both with shift, m, and tilt, rad, of the inner raceway.
    pub stiffness: Matrix2<f64>,
    /// Tilts of the roller against both raceways, rad.
    pub tilts: [f64; 2],
}

/// Force and moment of one contact with their slopes by shift and tilt, and the load of each slice.
struct Contact {
    force: Vector2<f64>,
    slope: Matrix2<f64>,
    slices: Vec<f64>,
}

/// Most trials along a step.
const TRIALS: usize = 40;

impl Roller {
    /// Of a length (m), a drop (m) along it, and a force outwards (N) along the normal.
    pub fn new(
        length: f64,
        drop: impl Fn(f64) -> f64,
        material: Material,
        centrifugal: f64,
        slices: usize,
    ) -> Roller {
        let width = length / slices as f64;
        let middle = |k: usize| (k as f64 + 0.5) * width - 0.5 * length;
        // Both contacts in series: δ = 2 (q/c)^(9/10).
        let one = stiffness(length, material) * 2_f64.powf(EXPONENT);
        Roller {
            slices: (0..slices).map(|k| [middle(k), drop(middle(k))]).collect(),
            width,
            stiffness: one / slices as f64,
            centrifugal,
        }
    }

    /// One contact under a shift (m) and a tilt (rad), by which the roller approaches the raceway: δ_k = shift + tilt z_k − drop.
    fn contact(&self, shift: f64, tilt: f64) -> Contact {
        let mut force = Vector2::zeros();
        let mut slope = Matrix2::zeros();
        let slices = self
            .slices
            .iter()
            .map(|[z, drop]| {
                let approach = shift + tilt * z - drop;
                if approach <= 0.0 {
                    return 0.0;
                }
                let load = self.stiffness * approach.powf(EXPONENT);
                let arm = Vector2::new(1.0, *z);
                force += load * arm;
                slope += EXPONENT * load / approach * arm * arm.transpose();
                load
            })
            .collect();
        Contact {
            force,
            slope,
            slices,
        }
    }

    /// The roller in balance under shift (m) and tilt (rad) of the inner raceway towards the outer, from where both touch a cylinder.
    ///
    /// Without centrifugal force, it lies in the middle: each contact takes half of shift and tilt. With it, outwards shift v and tilt φ
    /// follow from
    /// ```text
    ///   Σ q_o − Σ q_i = F_c,   Σ z (q_o − q_i) = 0,   δ_i = shift − v + (tilt − φ) z − drop,  δ_o = v + φ z − drop
    /// ```
    pub fn state(&self, shift: f64, tilt: f64) -> Option<RollerState> {
        if self.centrifugal == 0.0 {
            let both = self.contact(0.5 * shift, 0.5 * tilt);
            return Some(RollerState {
                slices: [both.slices.clone(), both.slices],
                force: both.force,
                stiffness: 0.5 * both.slope,
                tilts: [0.5 * tilt; 2],
            });
        }
        let push = Vector2::new(self.centrifugal, 0.0);
        // A roller that the inner ring hardly reaches lies flat on the outer one.
        let total = self.stiffness * self.slices.len() as f64;
        let alone = (self.centrifugal / total).powf(1.0 / EXPONENT);
        let mut place = match 0.5 * shift > alone {
            true => Vector2::new(0.5 * shift, 0.5 * tilt),
            false => Vector2::new(alone, 0.0),
        };
        // A roller on one slice alone may turn: what is added keeps the matrix regular.
        let soft = 1e-10 * total * alone.powf(EXPONENT - 1.0);
        let length = self.width * self.slices.len() as f64;
        let soft = Matrix2::from_diagonal(&Vector2::new(soft, soft * length * length));
        let at = |place: Vector2<f64>| {
            let inner = self.contact(shift - place[0], tilt - place[1]);
            let outer = self.contact(place[0], place[1]);
            let rest = outer.force - inner.force - push;
            (inner, outer, rest)
        };
        let size = |rest: &Vector2<f64>, inner: &Contact| {
            let negligible = total * (NEGLIGIBLE * length).powf(EXPONENT);
            let largest = (self.centrifugal + inner.force[0]).max(negligible);
            (rest[0].abs().max(rest[1].abs() / length)) / largest
        };
        let (mut inner, mut outer, mut rest) = at(place);
        for _ in 0..STEPS {
            let now = size(&rest, &inner);
            if now <= RESIDUAL {
                break;
            }
            let slope = inner.slope + outer.slope + soft;
            let step = slope.lu().solve(&-rest)?;
            let before = step.dot(&rest).abs();
            let along = |part: f64| {
                let there = at(place + part * step);
                let work = step.dot(&there.2) / before;
                Ok::<_, Infallible>((there, work))
            };
            let Ok((part, there)) = part_of_step(TRIALS, along, |_| false);
            place += part * step;
            (inner, outer, rest) = there;
        }
        if size(&rest, &inner) > ACCEPTED {
            return None;
        }
        // dv/dX = (k_i + k_o)⁻¹ k_i
        let follow = (inner.slope + outer.slope + soft).try_inverse()? * inner.slope;
        Some(RollerState {
            force: inner.force,
            stiffness: inner.slope - inner.slope * follow,
            slices: [inner.slices, outer.slices],
            tilts: [tilt - place[1], place[1]],
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bearing::geometry::{RollerGeometry, RollerProfile};
    use crate::near::near;
    use approx::assert_relative_eq;

    fn roller(profile: RollerProfile, centrifugal: f64) -> Roller {
        let geometry = RollerGeometry {
            roller_diameter: 10e-3,
            length: 10e-3,
            pitch_diameter: 54e-3,
            number: 14,
            clearance: 0.0,
            profile,
        };
        let drop = |z| geometry.drop(z);
        Roller::new(10e-3, drop, Material::STEEL, centrifugal, 41)
    }

    /// By hand: 35948 · 10^(8/9) · 0.01^(10/9) = 278355 · 0.00599484 = 1668.7 N at 10 µm and L = 10 mm.
    #[test]
    fn norm_by_hand() {
        let state = roller(RollerProfile::Cylinder, 0.0)
            .state(10e-6, 0.0)
            .unwrap();
        assert_relative_eq!(state.force[0], 1668.7, max_relative = 1e-4);
        assert_relative_eq!(state.force[1], 0.0, epsilon = 1e-9);
        // tilted by so much that one end just leaves: 1/(1 + 10/9) of the load by integration of t^(10/9) from 0 to 1, with twice the
        // approach at the other end, by the midpoint rule within 0.1 %
        let state = roller(RollerProfile::Cylinder, 0.0)
            .state(10e-6, 2e-3)
            .unwrap();
        let expected = 1668.7 * 2_f64.powf(10.0 / 9.0) * 9.0 / 19.0;
        assert_relative_eq!(state.force[0], expected, max_relative = 1e-3);
    }

    /// A centrifugal force that vanishes leaves the solution at rest, and one that does not is the difference of both loads.
    #[test]
    fn centrifugal_force() {
        let profile = RollerProfile::Logarithmic;
        let rest = roller(profile, 0.0).state(20e-6, 1e-3).unwrap();
        let slow = roller(profile, 1e-6).state(20e-6, 1e-3).unwrap();
        assert_relative_eq!(slow.force, rest.force, max_relative = 1e-8);
        assert_relative_eq!(slow.stiffness, rest.stiffness, max_relative = 1e-6);
        let fast = roller(profile, 300.0).state(20e-6, 1e-3).unwrap();
        let sum = |k: usize| fast.slices[k].iter().sum::<f64>();
        assert_relative_eq!(sum(1) - sum(0), 300.0, max_relative = 1e-9);
        let alone = roller(profile, 300.0).state(-20e-6, 0.0).unwrap();
        assert_eq!(alone.force, Vector2::zeros());
        near(alone.slices[1].iter().sum::<f64>(), 300.0, 1e-9);
    }

    #[test]
    fn stiffness_is_the_slope() {
        for centrifugal in [0.0, 200.0] {
            let roller = roller(RollerProfile::Crown(3.0), centrifugal);
            let at = |shift, tilt| roller.state(shift, tilt).unwrap().force;
            let [s, t, ds, dt] = [30e-6, 1e-3, 1e-10, 1e-8];
            let slope = roller.state(s, t).unwrap().stiffness;
            let by_shift = (at(s + ds, t) - at(s - ds, t)) / (2.0 * ds);
            let by_tilt = (at(s, t + dt) - at(s, t - dt)) / (2.0 * dt);
            assert_relative_eq!(slope.column(0).into_owned(), by_shift, max_relative = 1e-5);
            assert_relative_eq!(slope.column(1).into_owned(), by_tilt, max_relative = 1e-5);
        }
    }
}
