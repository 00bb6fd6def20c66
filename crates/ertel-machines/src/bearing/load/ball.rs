//! A ball between its grooves: at rest, and at speed under centrifugal force and gyroscopic moment.

use ertel_ehl::contact::Ellipse;
use nalgebra::{Matrix2, RowVector2, Vector2};

use super::CurvatureAngle;
use super::newton::{ACCEPTED, NEGLIGIBLE, RESIDUAL, STEPS};
use crate::bearing::geometry::{BallGeometry, Ring};
use crate::bearing::kinematics::{BallMotion, RacewayControl, Speeds};

/// Data of the equilibrium of a ball.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ball<'a> {
    pub geometry: &'a BallGeometry,
    pub reduced_modulus: f64,
    /// kg.
    pub mass: f64,
    pub speeds: Speeds,
    pub curvature_angle: CurvatureAngle,
    /// Moment of inertia J = m D²/10, kg m²; 0 where the gyroscopic moment is left out.
    moment_of_inertia: f64,
    /// A force that does not count, N.
    negligible: f64,
    /// δ/Q^(2/3) of both contacts at the free contact angle.
    compliance: [f64; 2],
}

/// A ball in balance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct BallState {
    /// Q_i, Q_o, N.
    pub loads: [f64; 2],
    /// α_i, α_o, rad.
    pub angles: [f64; 2],
    /// Under outer control.
    pub motion: BallMotion,
    pub centrifugal_force: f64,
    pub gyroscopic_moment: f64,
    /// On the inner ring, radial and axial, N.
    pub force: Vector2<f64>,
    /// Change of the force with the shift of the inner groove, radial and axial.
    pub stiffness: Matrix2<f64>,
}

/// Load of a contact and its slopes by approach and angle.
#[derive(Clone, Copy)]
struct Pressed {
    load: f64,
    by_approach: f64,
    by_angle: f64,
}

/// A contact in the plane of r and z: direction n of its normal, e = dn/dα, distance of the centres L.
struct Side {
    n: Vector2<f64>,
    e: Vector2<f64>,
    angle: f64,
    distance: f64,
    pressed: Pressed,
}

impl Side {
    /// Q n + T e and its change with the distance vector, T being held.
    fn force(&self, friction: f64) -> (Vector2<f64>, Matrix2<f64>) {
        let Side { n, e, .. } = self;
        let Pressed {
            load,
            by_approach,
            by_angle,
        } = self.pressed;
        let slope = by_approach * n.transpose() + by_angle / self.distance * e.transpose();
        let change = n * slope + (load * e - friction * n) / self.distance * e.transpose();
        (load * n + friction * e, change)
    }

    /// dα by the distance vector.
    fn turn(&self) -> RowVector2<f64> {
        self.e.transpose() / self.distance
    }
}

/// Rounds for the place of a loose ball.
const ROUNDS: usize = 20;
/// Largest angle towards the inner ring that counts for the speed of cage and ball, rad: balls that touch nothing may lie anywhere to it.
const MAX_INNER_ANGLE: f64 = 1.4;

impl Ball<'_> {
    pub fn new<'a>(
        geometry: &'a BallGeometry,
        material: crate::bearing::Material,
        speeds: Speeds,
        params: &super::Params,
    ) -> Ball<'a> {
        let angle = geometry.free_angle();
        let modulus = material.reduced_modulus;
        let mass = geometry.mass(material.density);
        let compliance = Ring::BOTH
            .map(|ring| Ellipse::of_radii(geometry.radii(ring, angle)).approach(1.0, modulus));
        let squeeze = NEGLIGIBLE * geometry.ball_diameter;
        Ball {
            geometry,
            reduced_modulus: modulus,
            mass,
            moment_of_inertia: match params.gyroscopic_moment {
                true => mass * geometry.ball_diameter.powi(2) / 10.0,
                false => 0.0,
            },
            negligible: (squeeze / compliance[0]).powf(1.5),
            compliance,
            speeds,
            curvature_angle: params.curvature_angle,
        }
    }

    /// δ/Q^(2/3) of a contact and its slope by the angle.
    ///
    /// At one load dδ/d(1/R_x) = a_x²/6: the energy ∫δ dQ = ⅗ δQ changes by ½ d(1/R_x) ∫p x² dA = Q a_x²/10 d(1/R_x).
    fn compliance(&self, ring: Ring, angle: f64) -> [f64; 2] {
        match self.curvature_angle {
            CurvatureAngle::Free => [self.compliance[ring.index()], 0.0],
            CurvatureAngle::Loaded => {
                let ellipse = Ellipse::of_radii(self.geometry.radii(ring, angle));
                let [a, _] = ellipse.semi_axes(1.0, self.reduced_modulus);
                let slope = a * a / 6.0 * self.geometry.curvature_slope(ring, angle);
                [ellipse.approach(1.0, self.reduced_modulus), slope]
            }
        }
    }

    /// Load of one contact at its approach.
    fn pressed(&self, ring: Ring, approach: f64, angle: f64) -> Pressed {
        pressed(approach, self.compliance(ring, angle))
    }

    /// One side, with the vector from groove to ball or from ball to groove.
    fn side(&self, ring: Ring, between: Vector2<f64>) -> Side {
        let distance = between.norm();
        let n = between / distance;
        let angle = n[1].atan2(n[0]);
        let approach = distance - self.geometry.reach(ring);
        Side {
            n,
            e: Vector2::new(-n[1], n[0]),
            angle,
            distance,
            pressed: self.pressed(ring, approach, angle),
        }
    }

    /// Motion, centrifugal force and gyroscopic moment.
    ///
    /// F_c = m d_m ω_m²/2,  M_g = J ω_m ω_R sin β,  J = m D²/10
    fn inertia(&self, angles: [f64; 2]) -> (BallMotion, f64, f64) {
        let g = self.geometry;
        let angles = [
            angles[0].clamp(-MAX_INNER_ANGLE, MAX_INNER_ANGLE),
            angles[1],
        ];
        let ratio = g.ball_diameter / g.pitch_diameter;
        let motion = BallMotion::new(ratio, angles, self.speeds, RacewayControl::Outer);
        (
            motion,
            0.5 * self.mass * g.pitch_diameter * motion.cage.powi(2),
            self.moment_of_inertia * motion.cage * motion.element * motion.attitude.sin(),
        )
    }

    /// Derivatives of both by α_i and α_o.
    fn inertia_slopes(&self, motion: &BallMotion, angles: [f64; 2]) -> [[f64; 2]; 2] {
        let g = self.geometry;
        let ratio = g.ball_diameter / g.pitch_diameter;
        let mut slopes = motion.slopes_under_outer_control(ratio, angles, self.speeds);
        let (s, c) = motion.attitude.sin_cos();
        if angles[0].abs() > MAX_INNER_ANGLE {
            slopes[0] = BallMotion {
                cage: 0.0,
                element: 0.0,
                attitude: 0.0,
            };
        }
        let force = slopes.map(|d| self.mass * g.pitch_diameter * motion.cage * d.cage);
        let moment = slopes.map(|d| {
            let product = d.cage * motion.element + motion.cage * d.element;
            self.moment_of_inertia * (product * s + motion.cage * motion.element * c * d.attitude)
        });
        [force, moment]
    }

    /// The ball in balance with the inner groove's centre at `centre` (radial, axial, m) from the outer one's; `None` where no balance is
    /// found.
    pub fn state(&self, centre: Vector2<f64>) -> Option<BallState> {
        match self.speeds == Speeds::default() {
            true => Some(self.at_rest(centre)),
            false => self.at_speed(centre),
        }
    }

    /// At rest: Q n along the line of both centres, (C_i + C_o) Q^(2/3) = |centre| − A.
    fn at_rest(&self, centre: Vector2<f64>) -> BallState {
        let distance = centre.norm();
        let n = centre / distance;
        let angle = n[1].atan2(n[0]);
        let (motion, _, _) = self.inertia([angle; 2]);
        let both = Ring::BOTH.map(|ring| self.compliance(ring, angle));
        let sum = [both[0][0] + both[1][0], both[0][1] + both[1][1]];
        let side = Side {
            n,
            e: Vector2::new(-n[1], n[0]),
            angle,
            distance,
            pressed: pressed(distance - self.geometry.centre_distance(), sum),
        };
        let (force, change) = side.force(0.0);
        BallState {
            loads: [side.pressed.load; 2],
            angles: [angle; 2],
            motion,
            centrifugal_force: 0.0,
            gyroscopic_moment: 0.0,
            force,
            stiffness: change,
        }
    }

    /// At speed, with d_i from the ball's centre to that of the inner groove, d_o from that of the outer groove to the ball's:
    ///
    /// ```text
    ///   0 = Q_i n_i − Q_o n_o − 2 (M_g/D) e_o + F_c r,   n = d/|d|,  e = dn/dα
    ///   M_g t = dH/dt = ω_m z × J ω_R (sin β r − cos β z)
    /// ```
    /// The outer raceway, which controls the ball, resists the gyroscopic moment alone: its friction turns the ball's angular momentum
    /// along with the cage, and its direction follows from dH/dt as it stands here. (Harris and Kotzalas 2007, Advanced Concepts, chapter
    /// 3, with λ_o = 2, λ_i = 0.) A ball that touches the outer ring alone lies at α_o = 0 and Q_o = F_c.
    fn at_speed(&self, centre: Vector2<f64>) -> Option<BallState> {
        let g = self.geometry;
        let (loose, mut place) = self.loose(centre);
        if (centre - place).norm() <= g.reach(Ring::Inner) {
            return Some(loose);
        }
        // A ball that both rings hold starts from the line between the grooves.
        let squeeze = centre.norm() - g.centre_distance();
        if squeeze > 0.0 {
            let out = g.reach(Ring::Outer) + 0.5 * squeeze;
            place = centre * (out / centre.norm());
        }
        let mut here = self.out_of_balance(centre, place);
        for _ in 0..STEPS {
            if here.size() <= RESIDUAL {
                break;
            }
            let step = here.by_place.lu().solve(&-here.rest)?;
            let cap = 0.5 * g.reach(Ring::Outer).min(g.reach(Ring::Inner));
            let step = step * (cap / step.norm().max(cap));
            let before = step.dot(&here.rest).abs();
            let mut part = 1.0;
            here = loop {
                let next = place + step * part;
                let there = self.out_of_balance(centre, next);
                let work = -step.dot(&there.rest);
                if work <= 0.9 * before || part < 1e-6 || there.size() <= here.size() {
                    place = next;
                    break there;
                }
                part *= 0.5;
            };
        }
        (here.size() <= ACCEPTED).then(|| here.state())?
    }

    /// A ball that touches the outer ring alone, and where its centre is. Its cage speed is that of the angle at which it would touch the
    /// inner ring, so that forces do not jump where it does.
    fn loose(&self, centre: Vector2<f64>) -> (BallState, Vector2<f64>) {
        let [compliance, _] = self.compliance(Ring::Outer, 0.0);
        let reach = self.geometry.reach(Ring::Outer);
        let mut place = Vector2::new(reach, 0.0);
        let (mut angles, mut motion, mut force) = ([0.0; 2], self.inertia([0.0; 2]).0, 0.0);
        // The ball moves by nanometres with its own angle.
        for _ in 0..ROUNDS {
            let inner = centre - place;
            angles = [inner[1].atan2(inner[0]), 0.0];
            (motion, force, _) = self.inertia(angles);
            let next = reach + compliance * force.powf(2.0 / 3.0);
            if next == place[0] {
                break;
            }
            place[0] = next;
        }
        let state = BallState {
            loads: [0.0, force],
            angles,
            motion,
            centrifugal_force: force,
            gyroscopic_moment: 0.0,
            force: Vector2::zeros(),
            stiffness: Matrix2::zeros(),
        };
        (state, place)
    }

    fn out_of_balance(&self, centre: Vector2<f64>, place: Vector2<f64>) -> Imbalance {
        let g = self.geometry;
        let sides = [
            self.side(Ring::Inner, centre - place),
            self.side(Ring::Outer, place),
        ];
        let angles = [sides[0].angle, sides[1].angle];
        let (motion, centrifugal, moment) = self.inertia(angles);
        let [force_by, moment_by] = self.inertia_slopes(&motion, angles);
        let share = 2.0 / g.ball_diameter;
        let inner = sides[0].force(0.0);
        let outer = sides[1].force(share * moment);
        let turns = [sides[0].turn(), sides[1].turn()];
        // Slopes of moment and centrifugal force by the place of the ball and by that of the groove.
        let by = |slopes: [f64; 2]| {
            let by_inner = slopes[0] * turns[0];
            (slopes[1] * turns[1] - by_inner, by_inner)
        };
        let (moment_by_place, moment_by_centre) = by(moment_by);
        let (force_by_place, force_by_centre) = by(force_by);
        let friction = -share * sides[1].e;
        let radial = Vector2::new(1.0, 0.0);
        Imbalance {
            rest: inner.0 - outer.0 + centrifugal * radial,
            by_place: -inner.1 - outer.1 + friction * moment_by_place + radial * force_by_place,
            by_centre: inner.1 + friction * moment_by_centre + radial * force_by_centre,
            inner: inner.1,
            force: inner.0,
            loads: [sides[0].pressed.load, sides[1].pressed.load],
            angles,
            motion,
            centrifugal,
            moment,
            negligible: self.negligible,
        }
    }
}

/// Q = (δ/C)^(3/2) of δ and C with its slope by the angle.
fn pressed(approach: f64, [compliance, slope]: [f64; 2]) -> Pressed {
    if approach <= 0.0 {
        return Pressed {
            load: 0.0,
            by_approach: 0.0,
            by_angle: 0.0,
        };
    }
    let load = (approach / compliance).powf(1.5);
    let by_approach = 1.5 * load / approach;
    Pressed {
        load,
        by_approach,
        by_angle: -1.5 * load * slope / compliance,
    }
}

/// A ball out of balance, and all slopes.
struct Imbalance {
    rest: Vector2<f64>,
    by_place: Matrix2<f64>,
    by_centre: Matrix2<f64>,
    /// Change of the inner ring's force with the distance of its groove from the ball.
    inner: Matrix2<f64>,
    force: Vector2<f64>,
    loads: [f64; 2],
    angles: [f64; 2],
    motion: BallMotion,
    centrifugal: f64,
    moment: f64,
    negligible: f64,
}

impl Imbalance {
    fn size(&self) -> f64 {
        let largest = self.loads[0].max(self.loads[1]).max(self.centrifugal);
        self.rest.amax() / largest.max(self.negligible)
    }

    /// The ball's place follows the groove's centre: dV/dX = −(∂g/∂V)⁻¹ ∂g/∂X.
    fn state(&self) -> Option<BallState> {
        let follow = -self.by_place.try_inverse()? * self.by_centre;
        Some(BallState {
            loads: self.loads,
            angles: self.angles,
            motion: self.motion,
            centrifugal_force: self.centrifugal,
            gyroscopic_moment: self.moment,
            force: self.force,
            stiffness: self.inner - self.inner * follow,
        })
    }
}

#[cfg(test)]
#[path = "ball_tests.rs"]
mod tests;
