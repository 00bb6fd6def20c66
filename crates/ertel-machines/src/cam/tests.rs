use std::f64::consts::{FRAC_PI_2, PI, TAU};

use crate::near::near;
use approx::assert_relative_eq;

use super::*;

fn operation(speed: f64) -> CamOperation {
    CamOperation {
        speed,
        width: 12e-3,
        mass: 0.12,
        spring_rate: 30e3,
        preload: 250.0,
        extra_force: 0.0,
        reduced_modulus: 226.4e9,
    }
}

/// All rows of a separate program.
#[test]
fn flat_followers_of_a_separate_program() {
    let text = include_str!("data/flat_followers.csv");
    let rows: Vec<&str> = text.lines().skip(2).collect();
    assert_eq!(rows.len(), 12);
    for row in rows {
        let cells: Vec<&str> = row.split(',').collect();
        let number = |i: usize| cells[i].parse::<f64>().expect("a number");
        let e = 1e-3 * number(2);
        let law = match cells[0] {
            "eccentric disc" => LiftLaw::Eccentric { eccentricity: e },
            _ => LiftLaw::Harmonic { lift: e, lobes: 2 },
        };
        let cam = Cam::new(law, Follower::Flat, 1e-3 * number(1)).expect("a cam");
        let speed = PI / 30.0 * number(3);
        let angle = number(4).to_radians();
        let point = cam.at(&operation(speed), angle).expect("a contact");
        let close = |value: f64, right: f64| {
            assert_relative_eq!(value, right, max_relative = 1e-9, epsilon = 1e-12);
        };
        close(1e3 * point.lift, number(5));
        close(1e3 * point.radius_body_2, number(6));
        close(1e3 * point.reduced_radius, number(6));
        close(point.u_2, number(7));
        close(point.u_1, number(8));
        close(point.entrainment_speed, number(9));
        close(point.sliding_speed, number(10));
    }
}

/// Entrainment under a flat face vanishes where r_b + s + 2 s'' = 0: of s = h (1 − cos 2θ)/2 with r_b = 18 and h = 8 mm that is 22 + 28 cos 2θ = 0.
#[test]
fn entrainment_vanishes() {
    let law = LiftLaw::Harmonic {
        lift: 8e-3,
        lobes: 2,
    };
    let cam = Cam::new(law, Follower::Flat, 18e-3).expect("a cam");
    let found = cam.reversals(&operation(200.0), 100).expect("angles");
    let first = 0.5 * (-22.0_f64 / 28.0).acos();
    let right = [first, PI - first, PI + first, TAU - first];
    assert_eq!(found.len(), 4);
    for (angle, right) in found.iter().zip(right) {
        assert_relative_eq!(*angle, right, max_relative = 1e-12);
    }
    let points = cam.turn(&operation(200.0), 100).expect("a turn");
    let marked = points.iter().filter(|point| point.entrainment_reverses);
    assert_eq!(marked.count(), 4);
}

/// The lift of a roller on an eccentric disc (radius r_d, eccentricity e): its centre is at e cos θ + √((r_d + r_f)² − (ε + e sin θ)²), as the disc's centre is at
/// (−e sin θ, e cos θ). The cam is round everywhere, and the contact is r_d from the disc's centre.
#[test]
fn roller_on_an_eccentric_disc() {
    let (disc, e, roller) = (25e-3, 6e-3, 10e-3);
    for offset in [0.0, 4e-3, -3e-3] {
        let sum: f64 = disc + roller;
        let height = |angle: f64| {
            let side = offset + e * angle.sin();
            e * angle.cos() + (sum * sum - side * side).sqrt()
        };
        // Any base circle does; s = 0 lies where the centre is as high as over that circle.
        let base = 20e-3_f64;
        let zero = ((base + roller).powi(2) - offset * offset).sqrt();
        let angles: Vec<f64> = (0..120).map(|i| TAU * f64::from(i) / 120.0).collect();
        let lifts: Vec<f64> = angles.iter().map(|angle| height(*angle) - zero).collect();
        let law = LiftLaw::table(&angles, &lifts).expect("a law");
        let follower = Follower::Roller {
            radius: roller,
            offset,
            slip: 0.0,
        };
        let cam = Cam::new(law, follower, base).expect("a cam");
        for point in cam.turn(&operation(150.0), 77).expect("a turn") {
            assert_relative_eq!(point.radius_body_2, disc, max_relative = 1e-5);
            let reduced = disc * roller / (disc + roller);
            assert_relative_eq!(point.reduced_radius, reduced, max_relative = 1e-5);
            let centre = [-e * point.angle.sin(), e * point.angle.cos()];
            let distance = (point.contact[0] - centre[0]).hypot(point.contact[1] - centre[1]);
            assert_relative_eq!(distance, disc, max_relative = 1e-8);
            assert_relative_eq!(point.slide_to_roll_ratio, 0.0, epsilon = 1e-12);
            // From the disc's centre to the roller's: the side over the sum of radii.
            let sine = (offset + e * point.angle.sin()) / sum;
            assert_relative_eq!(-point.pressure_angle.sin(), sine, epsilon = 1e-7);
            assert!(!point.concave && !point.undercut);
        }
    }
}

/// Places of the contact on the cam, in its frame, and radii of the circles through three neighbours: an envelope that knows no formula of curvature. The
/// contact travels on the cam at |u_2|, and on the face at |u_1|.
#[test]
fn round_followers_against_the_envelope() {
    let law = LiftLaw::segments(vec![
        Segment::Move {
            angle: 0.9,
            lift: 9e-3,
            law: MotionLaw::Polynomial4567,
        },
        Segment::Dwell { angle: 1.0 },
        Segment::Move {
            angle: 1.6,
            lift: -9e-3,
            law: MotionLaw::Polynomial345,
        },
        Segment::Dwell { angle: TAU - 3.5 },
    ])
    .expect("a law");
    let speed = 100.0;
    let finger = |pivot| Follower::Finger {
        pivot,
        arm: 45e-3,
        radius: 12e-3,
        roller_slip: None,
    };
    for follower in [
        Follower::Curved {
            radius: 12e-3,
            offset: 2e-3,
        },
        finger([-44e-3, 35e-3]),
        finger([41e-3, 30e-3]),
    ] {
        let cam = Cam::new(law.clone(), follower, 24e-3).expect("a cam");
        let operation = operation(speed);
        let mut concave = 0;
        for i in 0..60 {
            let angle = 0.013 + TAU * f64::from(i) / 60.0;
            let step = 1e-4;
            let points =
                [-step, 0.0, step].map(|turn| cam.at(&operation, angle + turn).expect("a contact"));
            let in_cam = points.map(|point| {
                let (sine, cosine) = point.angle.sin_cos();
                let [x, y] = point.contact;
                [x * cosine + y * sine, -x * sine + y * cosine]
            });
            let side = |i: usize, j: usize| {
                (in_cam[i][0] - in_cam[j][0]).hypot(in_cam[i][1] - in_cam[j][1])
            };
            let (a, b, c) = (side(0, 1), side(1, 2), side(0, 2));
            let area = 0.5
                * ((in_cam[1][0] - in_cam[0][0]) * (in_cam[2][1] - in_cam[0][1])
                    - (in_cam[1][1] - in_cam[0][1]) * (in_cam[2][0] - in_cam[0][0]));
            // The contact goes around the cam against its turning: clockwise where convex.
            let curvature = -4.0 * area / (a * b * c);
            let point = points[1];
            assert_relative_eq!(
                point.radius_body_2.recip(),
                curvature,
                max_relative = 2e-4,
                epsilon = 2e-2
            );
            concave += usize::from(point.concave);
            assert_eq!(point.concave, curvature < 0.0);
            let on_cam = speed * c / (2.0 * step);
            assert_relative_eq!(point.u_2, on_cam, max_relative = 1e-4);
            // On the face the contact moves as the normal turns relative to it, by the pressure angle: the motion turns with the finger.
            let turned = points[2].pressure_angle - points[0].pressure_angle;
            let on_face = speed * 12e-3 * turned / (2.0 * step);
            assert_relative_eq!(point.u_1, on_face, max_relative = 1e-4, epsilon = 1e-6);
            // Velocity over ω of the cam at the contact less that of the follower: nothing along the normal, the sliding along the face.
            let [x, y] = point.contact;
            let (body, motion_angle) = body_velocity(follower, &point);
            let relative = [-y - body[0], x - body[1]];
            let (sine, cosine) = (motion_angle + point.pressure_angle).sin_cos();
            let along = relative[0] * cosine + relative[1] * sine;
            let across = -relative[0] * sine + relative[1] * cosine;
            assert_relative_eq!(across, 0.0, epsilon = 1e-12);
            assert_relative_eq!(point.sliding_speed, -speed * along, max_relative = 1e-9);
        }
        assert!(concave > 0);
    }
}

/// Velocity over ω of the follower's face at the contact as that of a rigid body, and the angle of its motion from y.
fn body_velocity(follower: Follower, point: &CamPoint) -> ([f64; 2], f64) {
    let Follower::Finger {
        pivot, arm, radius, ..
    } = follower
    else {
        return ([0.0, point.lift_velocity], 0.0);
    };
    // The finger of a pivot on the left lifts counter-clockwise. Its arm at s = 0 closes the triangle of axis, pivot and face's centre.
    let sense = -pivot[0].signum();
    let (distance, sum) = (pivot[0].hypot(pivot[1]), 24e-3 + radius);
    let at_pivot = ((arm * arm + distance * distance - sum * sum) / (2.0 * arm * distance)).acos();
    let towards_axis = (-pivot[1]).atan2(-pivot[0]);
    let arm_angle = towards_axis + sense * (at_pivot + point.lift / arm);
    let turning = sense * point.lift_velocity / arm;
    let lever = [point.contact[0] - pivot[0], point.contact[1] - pivot[1]];
    let motion_angle = if sense > 0.0 {
        arm_angle
    } else {
        arm_angle - PI
    };
    ([-turning * lever[1], turning * lever[0]], motion_angle)
}

/// The tangent of an arm of 100 m is a line: a finger that moves along y there.
#[test]
fn long_fingers_are_straight() {
    let law = LiftLaw::Harmonic {
        lift: 4e-3,
        lobes: 2,
    };
    let straight = Follower::Curved {
        radius: 12e-3,
        offset: 0.0,
    };
    for side in [-100.0, 100.0] {
        let long = Follower::Finger {
            pivot: [side, 30e-3],
            arm: 100.0,
            radius: 12e-3,
            roller_slip: None,
        };
        let [one, other] =
            [straight, long].map(|follower| Cam::new(law.clone(), follower, 18e-3).expect("a cam"));
        for i in 0..20 {
            let angle = 0.3 * f64::from(i);
            let [a, b] =
                [&one, &other].map(|cam| cam.at(&operation(100.0), angle).expect("a contact"));
            assert_relative_eq!(a.reduced_radius, b.reduced_radius, max_relative = 2e-3);
            assert_relative_eq!(a.u_1, b.u_1, max_relative = 2e-3, epsilon = 1e-3);
            assert_relative_eq!(a.u_2, b.u_2, max_relative = 2e-3);
            assert_relative_eq!(a.load_per_length, b.load_per_length, max_relative = 2e-3);
        }
    }
}

/// A face of 1 km is flat.
#[test]
fn large_faces_are_flat() {
    let law = LiftLaw::Harmonic {
        lift: 4e-3,
        lobes: 2,
    };
    let follower = Follower::Curved {
        radius: 1e3,
        offset: 0.0,
    };
    let [round, flat] = [follower, Follower::Flat]
        .map(|follower| Cam::new(law.clone(), follower, 18e-3).expect("a cam"));
    for i in 0..20 {
        let angle = 0.3 * f64::from(i);
        let [one, other] =
            [&round, &flat].map(|cam| cam.at(&operation(100.0), angle).expect("a contact"));
        near(one.reduced_radius, other.reduced_radius, 1e-3);
        assert_relative_eq!(one.u_1, other.u_1, max_relative = 1e-3, epsilon = 1e-6);
        assert_relative_eq!(one.u_2, other.u_2, max_relative = 1e-3);
        assert_relative_eq!(
            one.contact[0],
            other.contact[0],
            max_relative = 1e-3,
            epsilon = 1e-9
        );
    }
}

/// By hand at θ = π/2 of s = (h/2)(1 − cos 2θ), h = 4 mm: s = 4 mm, s'' = −8 mm; ω = 200: F = 250 + 30e3·0.004 − 0.12·4e4·0.008 = 331.6 N;
/// R = 18 + 4 − 8 = 14 mm; p = √(w E'/(2π R)) with w = 331.6/0.012. At ω = 700: 370 − 0.12·49e4·0.008 < 0, the follower leaves the cam.
#[test]
fn forces_by_hand() {
    let law = LiftLaw::Harmonic {
        lift: 4e-3,
        lobes: 2,
    };
    let cam = Cam::new(law, Follower::Flat, 18e-3).expect("a cam");
    let at = |speed| cam.at(&operation(speed), FRAC_PI_2).expect("a contact");
    let point = at(200.0);
    assert_relative_eq!(point.force, 331.6, max_relative = 1e-12);
    // An additional force on the follower adds to it.
    let pressed = CamOperation {
        extra_force: 40.0,
        ..operation(200.0)
    };
    let found = cam.at(&pressed, FRAC_PI_2).expect("a contact");
    assert_relative_eq!(found.force, 371.6, max_relative = 1e-12);
    let load = 331.6 / 12e-3;
    assert_relative_eq!(point.load_per_length, load, max_relative = 1e-12);
    let pressure = (load * 226.4e9 / (TAU * 14e-3)).sqrt();
    assert_relative_eq!(point.hertz_pressure, pressure, max_relative = 1e-9);
    // At the nose 2 s'' outweighs r_b + s where u_m < 0: 18 + 4 − 16 = 6 mm > 0 here.
    let motion = point.motion().expect("a motion");
    assert_relative_eq!(motion.entrainment_speed, 0.6, max_relative = 1e-9);
    assert_relative_eq!(motion.body_1_speed(), point.u_1, max_relative = 1e-9);
    let contact = point.line_contact().expect("a contact");
    assert_eq!(
        contact.body_curvatures,
        Some([[0.0, 0.0], [14e-3_f64.recip(), 0.0]])
    );
    let lost = at(700.0);
    assert_eq!(lost.line_contact(), None);
    assert!(lost.contact_lost && lost.hertz_pressure == 0.0 && lost.load_per_length == 0.0);
    // A roller under the pressure angle φ: the normal force is F/cos φ.
    let roller = Follower::Roller {
        radius: 10e-3,
        offset: 0.0,
        slip: 0.05,
    };
    let law = LiftLaw::Eccentric { eccentricity: 5e-3 };
    let cam = Cam::new(law, roller, 18e-3).expect("a cam");
    let point = cam.at(&operation(200.0), 1.0).expect("a contact");
    let tangent = -5e-3 * 1.0_f64.sin() / (28e-3 + 5e-3 * 1.0_f64.cos());
    assert_relative_eq!(point.pressure_angle.tan(), tangent, max_relative = 1e-12);
    let load = point.force * (1.0 + tangent * tangent).sqrt() / 12e-3;
    assert_relative_eq!(point.load_per_length, load, max_relative = 1e-12);
    assert_relative_eq!(point.u_1, 0.95 * point.u_2, max_relative = 1e-12);
}

/// r_b + s + s'' < 0 under a flat face; a roller larger than the path of its centre is round.
#[test]
fn undercut_cams() {
    let law = LiftLaw::Harmonic {
        lift: 10e-3,
        lobes: 2,
    };
    let cam = Cam::new(law.clone(), Follower::Flat, 8e-3).expect("a cam");
    let points = cam.turn(&operation(100.0), 72).expect("a turn");
    for point in points {
        // ρ = 8 + 5 (1 − cos 2θ) + 20 cos 2θ = 13 + 15 cos 2θ mm.
        assert_eq!(
            point.undercut,
            13.0 + 15.0 * (2.0 * point.angle).cos() <= 0.0
        );
        assert!(point.hertz_pressure.is_finite());
    }
    let roller = |radius| Follower::Roller {
        radius,
        offset: 0.0,
        slip: 0.0,
    };
    // At the top y = 18 + r_f and s'' = −20 mm: κ_p = [1 + 20/y]/y, and κ_p r_f = 1 at y² = r_f (y + 20): r_f (18 + r_f + 20) = (18 + r_f)², r_f = 162 mm.
    for (radius, undercut) in [(160e-3, false), (164e-3, true)] {
        let cam = Cam::new(law.clone(), roller(radius), 8e-3).expect("a cam");
        let point = cam.at(&operation(100.0), FRAC_PI_2).expect("a contact");
        assert_eq!(point.undercut, undercut);
    }
}

/// Both polynomials from 0 to 1; derivatives against differences; the largest velocity and acceleration of Norton's tables: 3-4-5 has 1.875 and 5.7735,
/// 4-5-6-7 has 2.1875 and 7.5132, cycloidal 2 and 6.2832.
#[test]
fn motion_laws() {
    for (law, velocity, acceleration) in [
        (MotionLaw::Polynomial345, 1.875, 5.7735),
        (MotionLaw::Polynomial4567, 2.1875, 7.5132),
        (MotionLaw::Cycloidal, 2.0, TAU),
        (MotionLaw::Harmonic, FRAC_PI_2, PI * FRAC_PI_2),
    ] {
        assert_relative_eq!(law.at(0.0)[0], 0.0, epsilon = 1e-15);
        assert_relative_eq!(law.at(1.0)[0], 1.0, max_relative = 1e-14);
        let mut largest = [0.0_f64; 2];
        for i in 0..=1000 {
            let tau = f64::from(i) / 1000.0;
            let at = law.at(tau);
            largest = [largest[0].max(at[1].abs()), largest[1].max(at[2].abs())];
            let step = 1e-5;
            let [before, after] = [law.at(tau - step), law.at(tau + step)];
            for d in 0..2 {
                let difference = (after[d] - before[d]) / (2.0 * step);
                assert_relative_eq!(at[d + 1], difference, epsilon = 1e-6);
            }
        }
        assert_relative_eq!(largest[0], velocity, max_relative = 1e-5);
        assert_relative_eq!(largest[1], acceleration, max_relative = 1e-4);
    }
}

#[test]
fn refusals() {
    let dwell = |angle| Segment::Dwell { angle };
    let rise = |angle, lift| Segment::Move {
        angle,
        lift,
        law: MotionLaw::Cycloidal,
    };
    assert!(matches!(
        LiftLaw::segments(vec![dwell(1.0)]),
        Err(CamError::Turn { .. })
    ));
    assert!(matches!(
        LiftLaw::segments(vec![rise(1.0, 1e-3), dwell(TAU - 1.0)]),
        Err(CamError::NotClosed { .. })
    ));
    assert!(matches!(
        LiftLaw::segments(vec![rise(-1.0, 0.0), dwell(TAU + 1.0)]),
        Err(CamError::Value { .. })
    ));
    let law = LiftLaw::Eccentric { eccentricity: 5e-3 };
    assert!(Cam::new(law.clone(), Follower::Flat, 0.0).is_err());
    let roller = Follower::Roller {
        radius: 10e-3,
        offset: 30e-3,
        slip: 0.0,
    };
    assert!(Cam::new(law.clone(), roller, 18e-3).is_err());
    let finger = Follower::Finger {
        pivot: [-80e-3, 0.0],
        arm: 40e-3,
        radius: 10e-3,
        roller_slip: Some(0.0),
    };
    assert!(Cam::new(law.clone(), finger, 18e-3).is_err());
    let cam = Cam::new(law, Follower::Flat, 18e-3).expect("a cam");
    assert!(cam.turn(&operation(0.0), 10).is_err());
    assert!(cam.turn(&operation(1.0), 0).is_err());
    let wide = CamOperation {
        width: f64::NAN,
        ..operation(1.0)
    };
    assert!(cam.turn(&wide, 10).is_err());
}

/// Reversals under a flat face of rounded tables: 22 + 28 cos 2θ = 0 (see [`entrainment_vanishes`]) lies within the bar, and at its ends, on either side, the entrainment exceeds its own bar.
#[test]
fn reversals_of_rounded_tables_are_bracketed() {
    let first = 0.5 * (-22.0_f64 / 28.0).acos();
    let right = [first, PI - first, PI + first, TAU - first];
    for (digit, n) in [(1e-5, 180_i32), (2e-5, 90), (3e-5, 120), (5e-5, 180)] {
        let angles: Vec<f64> = (0..n).map(|i| TAU * f64::from(i) / f64::from(n)).collect();
        let lifts: Vec<f64> = (angles.iter())
            .map(|angle| digit * (4e-3 * (1.0 - (2.0 * angle).cos()) / digit).round())
            .collect();
        let law = LiftLaw::rounded_table(&angles, &lifts, digit, None).expect("a law");
        let cam = Cam::new(law, Follower::Flat, 18e-3).expect("a cam");
        let operation = operation(200.0);
        let found = cam.reversals(&operation, 720).expect("angles");
        assert_eq!(found.len(), 4);
        for (angle, right) in found.into_iter().zip(right) {
            let bar = cam.reversal_bar(&operation, angle);
            assert!((angle - right).abs() < bar, "{angle} {right} {bar}");
            for end in [angle - bar, angle + bar] {
                let speed = cam
                    .at(&operation, end)
                    .expect("a contact")
                    .entrainment_speed;
                let own = cam.bars(&operation, end).entrainment_speed;
                assert!(speed.abs() >= 0.999_999 * own, "{end}: {speed} {own}");
            }
        }
    }
}

/// Lifts rounded on paper, in mm and inch: the bar of s'' holds the closed form at every angle, and is far below what a law through all lifts is off by.
#[test]
fn bars_of_rounded_tables_cover_the_closed_form() {
    const INCH: f64 = 25.4e-3;
    let moved = |law| {
        let part = |angle: f64, lift| Segment::Move {
            angle: angle.to_radians(),
            lift,
            law,
        };
        let angle = 140_f64.to_radians();
        let parts = vec![
            part(110.0, 8e-3),
            part(110.0, -8e-3),
            Segment::Dwell { angle },
        ];
        LiftLaw::segments(parts).expect("a law")
    };
    let laws = [
        LiftLaw::Eccentric { eccentricity: 5e-3 },
        LiftLaw::Harmonic {
            lift: 6e-3,
            lobes: 2,
        },
        moved(MotionLaw::Polynomial345),
        moved(MotionLaw::Polynomial4567),
        moved(MotionLaw::Cycloidal),
    ];
    let places: Vec<f64> = (0..2000).map(|i| TAU * f64::from(i) / 2000.0).collect();
    for exact in &laws {
        for (digit, n) in [
            (1e-3 * INCH, 180_i32),
            (1e-4 * INCH, 360),
            (1e-5, 720),
            (1e-6, 360),
        ] {
            let angles: Vec<f64> = (0..n).map(|i| TAU * f64::from(i) / f64::from(n)).collect();
            let lifts: Vec<f64> = (angles.iter())
                .map(|angle| digit * (exact.at(*angle)[0] / digit).round())
                .collect();
            let law = LiftLaw::rounded_table(&angles, &lifts, digit, None).expect("a law");
            let through = LiftLaw::rounded_table(&angles, &lifts, digit, Some(0.0)).expect("a law");
            let mut largest = [0.0_f64; 2];
            for angle in &places {
                let right = exact.at(*angle)[2];
                let off = |law: &LiftLaw| (law.at(*angle)[2] - right).abs();
                let bar = law.acceleration_bar(*angle);
                assert!(off(&law) <= bar, "{exact:?} {digit} {n} {angle}");
                largest = [largest[0].max(bar), largest[1].max(off(&through))];
            }
            assert!(
                largest[0] < 0.5 * largest[1],
                "{exact:?} {digit} {n} {largest:?}"
            );
        }
    }
}

/// By hand: s'' = −e cos θ = −4 mm at the nose of a flat-faced eccentric of r_b = 18 mm, off by 2 mm, changes R = r_b + s + s'' by as much.
#[test]
fn bars_of_contacts_follow_those_of_lifts() {
    let angles: Vec<f64> = (0..90).map(|i| TAU * f64::from(i) / 90.0).collect();
    let rounded = |angle: &f64| 1e-4 * (40.0 * angle.cos()).round();
    let lifts: Vec<f64> = angles.iter().map(rounded).collect();
    let law = LiftLaw::rounded_table(&angles, &lifts, 1e-4, None).expect("a law");
    let bar = law.acceleration_bar(0.0);
    let cam = Cam::new(law, Follower::Flat, 18e-3).expect("a cam");
    let bars = cam.bars(&operation(150.0), 0.0);
    assert!(bar > 0.0);
    assert_eq!(bars.lift_acceleration, bar);
    assert_relative_eq!(bars.reduced_radius, bar, max_relative = 1e-9);
}
