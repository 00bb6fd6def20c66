//! The balls of a bearing together.

use std::f64::consts::PI;

use ertel_ehl::contact::Ellipse;
use nalgebra::{SMatrix, Vector2};

use super::ball::{Ball, BallState};
use super::newton::{Push, Row, Vector, direction};
use super::{Element, RingContact};
use crate::bearing::geometry::{BallGeometry, Ring};
use crate::bearing::kinematics::{BallMotion, RacewayControl};

/// Contact angles of a ball, both that of the outer ring where the ball does not touch the inner one.
fn motion_angles(state: &BallState) -> [f64; 2] {
    let [_, outer] = state.angles;
    match state.loads[0] > 0.0 {
        true => state.angles,
        false => [outer; 2],
    }
}

pub(super) struct Balls<'a> {
    pub geometry: &'a BallGeometry,
    pub ball: Ball<'a>,
    pub angles: Vec<f64>,
    /// Which raceway controls the balls.
    pub control: RacewayControl,
}

impl Balls<'_> {
    /// δ/Q^(2/3) of a ball between both rings at the free angle, m/N^(2/3).
    fn compliance(&self) -> f64 {
        let angle = self.geometry.free_angle();
        let of = |ring| {
            Ellipse::of_radii(self.geometry.radii(ring, angle))
                .approach(1.0, self.ball.reduced_modulus)
        };
        of(Ring::Inner) + of(Ring::Outer)
    }

    /// Contact angle of balls under an axial load (N) alone, rad, by bisection.
    ///
    /// A (cos α0/cos α − 1) = C [F_a/(Z sin α)]^(2/3)
    fn axial_angle(&self, load: f64) -> f64 {
        let a = self.geometry.centre_distance();
        let [radial, _] = self.geometry.centres();
        let (mut low, mut high) = (self.geometry.free_angle(), 0.499 * PI);
        for _ in 0..60 {
            let angle = 0.5 * (low + high);
            let of_ball = load / (self.geometry.number as f64 * angle.sin());
            match radial / angle.cos() - a < self.compliance() * of_ball.powf(2.0 / 3.0) {
                true => low = angle,
                false => high = angle,
            }
        }
        0.5 * (low + high)
    }
}

impl Row for Balls<'_> {
    type State = BallState;

    fn angles(&self) -> &[f64] {
        &self.angles
    }

    /// Radial and axial shift of the groove at ψ.
    fn map(&self, angle: f64) -> SMatrix<f64, 2, 5> {
        let (s, c) = angle.sin_cos();
        let arm = self.geometry.arm();
        SMatrix::<f64, 2, 5>::from_row_slice(&[
            c,
            s,
            0.0,
            0.0,
            0.0, //
            0.0,
            0.0,
            1.0,
            arm * s,
            -arm * c,
        ])
    }

    fn state(&self, moved: Vector2<f64>) -> Option<BallState> {
        let [radial, axial] = self.geometry.centres();
        let centre = Vector2::new(radial + moved[0], axial + moved[1]);
        (centre.norm() > 0.0).then(|| self.ball.state(centre))?
    }

    fn push(&self, _angle: f64, state: &BallState) -> Push {
        Push {
            force: state.force,
            stiffness: state.stiffness,
            load: state.loads[0],
            thrust: Vector::zeros(),
        }
    }

    fn element(&self, position: f64, state: &BallState) -> Element {
        let (g, speeds) = (self.geometry, self.ball.speeds);
        let ratio = g.ball_diameter / g.pitch_diameter;
        let angles = motion_angles(state);
        let motion = BallMotion::new(ratio, angles, speeds, self.control);
        let contacts = Ring::BOTH.map(|ring| {
            let (load, angle) = (state.loads[ring.index()], angles[ring.index()]);
            let radii = g.radii(ring, angle);
            let semi_axes = Ellipse::of_radii(radii).semi_axes(load, self.ball.reduced_modulus);
            let area = PI * semi_axes[0] * semi_axes[1];
            RingContact {
                ring,
                load,
                angle,
                radii,
                curvatures: g.curvatures(ring, angle),
                semi_axes,
                pressure: if load > 0.0 { 1.5 * load / area } else { 0.0 },
                entrainment_speed: motion.entrainment_speed(
                    ring,
                    ratio,
                    g.pitch_diameter,
                    angle,
                    speeds,
                ),
                spin: motion.spin(ring, angle, speeds),
                slices: Vec::new(),
                tilt: 0.0,
            }
        });
        Element {
            position,
            contacts,
            cage_speed: motion.cage,
            own_speed: motion.element,
            attitude: motion.attitude,
            centrifugal_force: state.centrifugal_force,
            gyroscopic_moment: state.gyroscopic_moment,
            rib_load: 0.0,
        }
    }

    fn start(&self, load: &Vector) -> Vector {
        let [x, y] = direction(load);
        let (radial_load, axial_load) = (load[0].hypot(load[1]), load[2]);
        let of_ball = 5.0 * radial_load / self.geometry.number as f64;
        let [radial, axial] = self.geometry.centres();
        let squeeze = self.compliance() * of_ball.powf(2.0 / 3.0);
        let (radial, axial) = match axial_load.abs() > 1e-3 * radial_load {
            true => {
                let angle = self.axial_angle(axial_load.abs());
                (squeeze, axial_load.signum() * radial * angle.tan() - axial)
            }
            // Centres of both grooves at one height.
            false => (squeeze + self.geometry.centre_distance() - radial, -axial),
        };
        Vector::from([radial * x, radial * y, axial, 0.0, 0.0])
    }

    fn longest_step(&self) -> f64 {
        0.3 * self.geometry.centre_distance()
    }

    fn arm(&self) -> f64 {
        self.geometry.arm()
    }

    fn typical_stiffness(&self) -> f64 {
        // At δ = A/10.
        let approach = 0.1 * self.geometry.centre_distance();
        1.5 * approach.sqrt() / self.compliance().powf(1.5)
    }
}
