use super::*;
use crate::bearing::Material;
use crate::bearing::geometry::Play;
use crate::bearing::load::Params;
use approx::{assert_abs_diff_eq, assert_relative_eq};
use nalgebra::Vector3;

fn angular() -> BallGeometry {
    BallGeometry {
        ball_diameter: 12.7e-3,
        pitch_diameter: 70e-3,
        number: 14,
        groove: [0.52, 0.53],
        play: Play::FreeAngle(25_f64.to_radians()),
    }
}

fn ball(geometry: &BallGeometry, inner: f64, curvature_angle: CurvatureAngle) -> Ball<'_> {
    let speeds = Speeds { inner, outer: 0.0 };
    let params = Params {
        curvature_angle,
        ..Params::default()
    };
    Ball::new(geometry, Material::STEEL, speeds, &params)
}

const ANGLES: [CurvatureAngle; 2] = [CurvatureAngle::Loaded, CurvatureAngle::Free];

/// Centres of the grooves pressed together along 30 degrees.
fn centre(geometry: &BallGeometry) -> Vector2<f64> {
    let (s, c) = 30_f64.to_radians().sin_cos();
    (geometry.centre_distance() + 25e-6) * Vector2::new(c, s)
}

/// The same equations at a speed that tends to zero are those of rest.
#[test]
fn slow_is_at_rest() {
    let geometry = angular();
    for angle in ANGLES {
        let rest = ball(&geometry, 0.0, angle).state(centre(&geometry));
        let slow = ball(&geometry, 1e-3, angle).state(centre(&geometry));
        let (rest, slow) = (rest.unwrap(), slow.unwrap());
        for k in [0, 1] {
            assert_relative_eq!(slow.loads[k], rest.loads[k], max_relative = 1e-8);
            assert_relative_eq!(slow.angles[k], rest.angles[k], max_relative = 1e-10);
        }
        assert_relative_eq!(
            slow.stiffness,
            rest.stiffness,
            max_relative = 1e-7,
            epsilon = 1.0
        );
    }
}

/// Change of the forces against differences, at rest and at 3000 rad/s, with one ball in balance on its own each.
#[test]
fn stiffness_is_the_slope() {
    let geometry = angular();
    for inner in [0.0, 3000.0] {
        for angle in ANGLES {
            let ball = ball(&geometry, inner, angle);
            let at = |v| ball.state(v).unwrap();
            let slope = at(centre(&geometry)).stiffness;
            let step = 1e-9;
            for k in [0, 1] {
                let mut shift = Vector2::zeros();
                shift[k] = step;
                let high = at(centre(&geometry) + shift).force;
                let low = at(centre(&geometry) - shift).force;
                let difference = (high - low) / (2.0 * step);
                let size = slope.amax();
                assert_abs_diff_eq!(
                    slope.column(k).into_owned(),
                    difference,
                    epsilon = 1e-6 * size
                );
            }
        }
    }
}

/// Newton and Euler for the ball in three dimensions, with the forces of friction and the normal loads as found: Σ F = −m ω_m² r and Σ M =
/// dH/dt, the latter by turning the angular momentum about the bearing's axis by a small angle.
#[test]
fn newton_and_euler() {
    let geometry = angular();
    let ball = ball(&geometry, 3000.0, CurvatureAngle::Loaded);
    let state = ball.state(centre(&geometry)).unwrap();
    let [a_i, a_o] = state.angles;
    assert!(a_o < a_i, "centrifugal force flattens the outer angle");
    let friction = state.gyroscopic_moment / geometry.ball_diameter;
    // (r, t, z)
    let along = |a: f64| Vector3::new(a.cos(), 0.0, a.sin());
    let across = |a: f64| Vector3::new(-a.sin(), 0.0, a.cos());
    let inner = state.loads[0] * along(a_i);
    let outer = -state.loads[1] * along(a_o) - 2.0 * friction * across(a_o);
    let weight = ball.mass * 0.5 * geometry.pitch_diameter * state.motion.cage.powi(2);
    let sum = inner + outer + Vector3::new(weight, 0.0, 0.0);
    assert_abs_diff_eq!(sum.norm(), 0.0, epsilon = 1e-8 * state.loads[1]);
    let half = 0.5 * geometry.ball_diameter;
    let moment = (-half * along(a_i)).cross(&inner) + (half * along(a_o)).cross(&outer);
    let (s, c) = state.motion.attitude.sin_cos();
    let spin = state.motion.element * Vector3::new(s, 0.0, -c);
    let momentum = ball.mass * geometry.ball_diameter.powi(2) / 10.0 * spin;
    let turned = |angle: f64| {
        let (s, c) = angle.sin_cos();
        Vector3::new(
            c * momentum[0] - s * momentum[1],
            s * momentum[0] + c * momentum[1],
            momentum[2],
        )
    };
    let step = 1e-6;
    let change = (turned(step) - turned(-step)) / (2.0 * step) * state.motion.cage;
    assert_relative_eq!(moment, change, max_relative = 1e-6, epsilon = 1e-9);
}

/// A ball that the inner ring does not reach presses on the outer ring with F_c = m d_m ω_m²/2 alone.
#[test]
fn a_loose_ball() {
    let geometry = angular();
    let ball = ball(&geometry, 1000.0, CurvatureAngle::Loaded);
    let state = ball.state(0.5 * centre(&geometry)).unwrap();
    // By hand: m = 7850 π/6 · 0.0127³ = 8.41940e-3 kg, on the pitch radius of 35 mm.
    let force = 8.4194e-3 * 0.035 * state.motion.cage.powi(2);
    assert_relative_eq!(state.loads[1], force, max_relative = 1e-4);
    assert_eq!(state.loads[0], 0.0);
    assert_eq!(state.force, Vector2::zeros());
}

/// Forces do not jump where a ball comes into touch with the inner ring: under a load of nearly nothing, it is as loose.
#[test]
fn touching_is_continuous() {
    let geometry = angular();
    let ball = ball(&geometry, 1000.0, CurvatureAngle::Loaded);
    let at = |part: f64| ball.state(part * centre(&geometry)).unwrap();
    let (mut loose, mut held) = (0.5, 1.0);
    for _ in 0..60 {
        let part = 0.5 * (loose + held);
        match at(part).loads[0] > 0.0 {
            true => held = part,
            false => loose = part,
        }
    }
    let (loose, held) = (at(loose), at(held));
    assert!(loose.loads[0] == 0.0 && held.loads[0] < 1e-3);
    assert_relative_eq!(loose.loads[1], held.loads[1], max_relative = 1e-4);
    assert_relative_eq!(loose.motion.cage, held.motion.cage, max_relative = 1e-4);
}
