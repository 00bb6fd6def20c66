use std::f64::consts::PI;

use crate::near::near;
use approx::assert_relative_eq;
use ertel_ehl::contact::Material;

use super::*;
use crate::gear::geometry::{
    GearDimensions, GearError, GearPair, Meshing, Relief, ReliefShape, TipAlteration,
};
use crate::gear::test_data::{c14, fzg, h501, rows, steel, steel_operation};

fn labelled(path: &[PathPoint], label: PathLabel) -> PathPoint {
    let found = path.iter().find(|point| point.label == Some(label));
    *found.expect("a labelled point")
}

/// All rows of a separate program.
#[test]
fn fzg_contacts_of_a_separate_program() {
    for row in rows(include_str!("../data/fzg_line_of_action.csv")) {
        let number = |key: &str| row.number(key);
        let pair = GearPair::new(&fzg(row.text("gear"))).expect("a pair");
        let operation = steel_operation(number("T1_Nm"), number("n1_rpm"));
        let params = PathParams {
            sharing: LoadSharing::Thirds,
            ..PathParams::default()
        };
        let path = pair.path(&operation, &params).expect("a path");
        let label = match row.text("point") {
            "A" => PathLabel::A,
            "B" => PathLabel::B,
            "C" => PathLabel::C,
            "D" => PathLabel::D,
            _ => PathLabel::E,
        };
        let point = labelled(&path, label);
        let close = |value: f64, key: &str| {
            assert_relative_eq!(value, number(key), max_relative = 1e-9, epsilon = 1e-14);
        };
        close(1e3 * point.radius_body_2, "rho1_mm");
        close(1e3 * point.radius_body_1, "rho2_mm");
        close(1e3 * point.reduced_radius, "R_mm");
        close(point.u_2, "u1_m/s");
        close(point.u_1, "u2_m/s");
        close(point.entrainment_speed, "entrainment_m/s");
        close(point.slide_to_roll_ratio, "SRR=");
        close(point.load_share, "load_share");
        close(1e-3 * point.load_per_length, "load_N/mm");
        close(1e-6 * point.hertz_pressure, "pH_MPa");
    }
}

/// FZG C by hand: ρ_1 = 4.472298 mm at A and 23.569389 mm at E, ρ_1 + ρ_2 = a_w sin α_wt; ζ_1 = 1 − ρ_2/(1.5 ρ_1), ζ_2 = 1 − 1.5 ρ_1/ρ_2, ξ = ρ_1/r_b1, and tan α_wt at
/// the pitch point, where nothing slides.
#[test]
fn specific_sliding_and_roll_angles() {
    let pair = GearPair::new(&fzg("FZG C")).expect("a pair");
    let operation = steel_operation(135.5, 1500.0);
    let path = pair
        .path(&operation, &PathParams::default())
        .expect("a path");
    for (label, sliding, roll) in [
        (PathLabel::A, [-3.539487064, 0.779710794], 0.132203335),
        (PathLabel::C, [0.0, 0.0], 0.412962531),
        (PathLabel::E, [0.678797591, -2.113301684], 0.696722776),
    ] {
        let point = labelled(&path, label);
        let found = point.specific_sliding();
        for (found, right) in found.into_iter().zip(sliding) {
            assert_relative_eq!(found, right, max_relative = 1e-8, epsilon = 1e-12);
        }
        assert_relative_eq!(pair.roll_angle(point.position), roll, max_relative = 1e-8);
    }
}

/// A published report (GEARpie, MIT): 200 N·m on the pinion of type C14 of the width 14 mm: 5912.1 N, 1347.3 MPa and a half-width of
/// 199.567 µm at the pitch point.
#[test]
fn published_pressure_of_spur_teeth() {
    let pair = GearPair::new(&c14()).expect("a pair");
    let operation = steel_operation(200.0, 1500.0);
    assert_relative_eq!(operation.base_force(&pair), 5912.1, max_relative = 1e-5);
    let path = pair
        .path(&operation, &PathParams::default())
        .expect("a path");
    let pitch = labelled(&path, PathLabel::C);
    assert!((1e-6 * pitch.hertz_pressure - 1347.3).abs() < 0.06);
    // Of the report's place next to the pitch point.
    assert_relative_eq!(1e6 * pitch.half_width, 199.567, max_relative = 5e-4);
    assert_relative_eq!(pitch.slide_to_roll_ratio, 0.0, epsilon = 1e-12);
    // Two pairs share evenly, one carries all.
    near(labelled(&path, PathLabel::A).load_share, 0.5, 1e-12);
    near(labelled(&path, PathLabel::B).load_share, 1.0, 1e-12);
}

/// The same of type H501 at 100 N·m: 600.3 MPa at the pitch point of the end of the face that touches last, over 1000 equal steps of the phase, so
/// to 0.2 %; the report leaves the base helix angle out of the radius at this place.
#[test]
fn published_pressure_of_helical_teeth() {
    let pair = GearPair::new(&h501()).expect("a pair");
    let operation = steel_operation(100.0, 1000.0);
    let params = PathParams {
        axial_position: 0.5,
        ..PathParams::default()
    };
    let path = pair.path(&operation, &params).expect("a path");
    let pressure = labelled(&path, PathLabel::C).hertz_pressure;
    let report = 600.3e6 * pair.base_helix_angle.cos().sqrt();
    assert_relative_eq!(pressure, report, max_relative = 2e-3);
}

/// The mean of the length is b ε_α/cos β_b. The least is, with the fractions n of the ratios ε_α and ε_β, (b/cos β_b)[ε_α − n_α n_β/ε_β] if
/// n_α + n_β ≤ 1, else (b/cos β_b)[ε_α − (1 − n_α)(1 − n_β)/ε_β] (ISO/TR 13989-1).
#[test]
fn lengths_of_contact_lines() {
    for width in [8e-3, 23e-3, 50e-3] {
        let mut dimensions = h501();
        dimensions.face_widths = [width; 2];
        let pair = GearPair::new(&dimensions).expect("a pair");
        let steps = 20_000;
        let lengths: Vec<f64> = (0..steps)
            .map(|i| line_length(&pair, pair.base_pitch * f64::from(i) / f64::from(steps)))
            .collect();
        let mean = lengths.iter().sum::<f64>() / f64::from(steps);
        assert_relative_eq!(mean, mean_line_length(&pair), max_relative = 1e-5);
        let [n_alpha, n_beta] = [pair.contact_ratio, pair.overlap_ratio].map(f64::fract);
        let lost = if n_alpha + n_beta <= 1.0 {
            n_alpha * n_beta
        } else {
            (1.0 - n_alpha) * (1.0 - n_beta)
        };
        let least =
            width / pair.base_helix_angle.cos() * (pair.contact_ratio - lost / pair.overlap_ratio);
        let found = lengths.iter().copied().fold(f64::INFINITY, f64::min);
        assert_relative_eq!(found, least, max_relative = 1e-3);
    }
}

/// The plane of action carries F_bt in every slice and law of even sharing: Σ w b over the pairs of a phase.
#[test]
fn pairs_carry_the_torque() {
    let operation = steel_operation(200.0, 1500.0);
    let stiffness = LoadSharing::Stiffness(ToothStiffness::Given(14e9));
    for (dimensions, sharing) in [
        (c14(), LoadSharing::Uniform),
        (c14(), LoadSharing::Thirds),
        (c14(), stiffness),
        (h501(), LoadSharing::Uniform),
        (h501(), stiffness),
    ] {
        let mut dimensions = dimensions;
        dimensions.reliefs = [Some(Relief {
            amount: 8e-6,
            length: 2e-3,
            shape: ReliefShape::Parabolic,
        }); 2];
        let pair = GearPair::new(&dimensions).expect("a pair");
        let law = sharing::Sharing::new(&pair, &operation, sharing).expect("a law");
        for phase in [0.03, 0.31, 0.77] {
            let start = pair.points.a + phase * pair.base_pitch;
            let slices = 200;
            let mut sum = 0.0;
            for slice in 0..slices {
                let y = ((f64::from(slice) + 0.5) / f64::from(slices) - 0.5) * pair.face_width;
                for k in -3..4 {
                    let s =
                        start + f64::from(k) * pair.base_pitch + y * pair.base_helix_angle.tan();
                    if s >= pair.points.a && s <= pair.points.e {
                        sum += law.share(s, y) / f64::from(slices);
                    }
                }
            }
            assert_relative_eq!(sum, 1.0, max_relative = 1e-2);
        }
    }
}

/// Without relief even springs share evenly, on wide faces with many lines too.
#[test]
fn wide_faces() {
    for width in [23e-3, 200e-3] {
        let mut dimensions = h501();
        dimensions.face_widths = [width; 2];
        let pair = GearPair::new(&dimensions).expect("a pair");
        let operation = steel_operation(200.0, 1500.0);
        let even = LoadSharing::Stiffness(ToothStiffness::Given(14e9));
        let [one, other] = [LoadSharing::Uniform, even].map(|sharing| {
            let params = PathParams {
                points: 9,
                sharing,
                axial_position: 0.2,
            };
            pair.path(&operation, &params).expect("a path")
        });
        for (a, b) in one.iter().zip(&other) {
            assert_relative_eq!(a.load_share, b.load_share, max_relative = 1e-2);
        }
    }
}

/// By hand: at the middle of AB and of DE of teeth with 10 µm of linear relief over AB at both tips each of the two pairs has 5 µm: halves. At the
/// tip A the first pair has 10 µm and the second, at D, none: X_A = 1/2 − c' C_a/(2 F_bt/b).
#[test]
fn relief_takes_load_from_the_tips() {
    let mut dimensions = c14();
    let plain = GearPair::new(&dimensions).expect("a pair");
    dimensions.reliefs = [Some(Relief {
        amount: 10e-6,
        length: plain.points.b - plain.points.a,
        shape: ReliefShape::Linear,
    }); 2];
    let pair = GearPair::new(&dimensions).expect("a pair");
    let operation = steel_operation(200.0, 1500.0);
    let params = PathParams {
        points: 41,
        sharing: LoadSharing::Stiffness(ToothStiffness::Given(14e9)),
        axial_position: 0.0,
    };
    let path = pair.path(&operation, &params).expect("a path");
    // F_bt/b = 5912.1/0.014 N/m; c' C_a = 14e4 N/m.
    let at_tip = 0.5 - 14e4 / (2.0 * 5912.1 / 0.014);
    let tip = labelled(&path, PathLabel::A);
    assert_relative_eq!(tip.load_share, at_tip, max_relative = 1e-4);
    near(labelled(&path, PathLabel::E).load_share, at_tip, 1e-4);
    near(labelled(&path, PathLabel::C).load_share, 1.0, 1e-12);
    // A tenth of the torque leaves the tip free: c' C_a exceeds the load, and the other pair carries all of it.
    let light = steel_operation(20.0, 1500.0);
    let path = pair.path(&light, &params).expect("a path");
    let tip = labelled(&path, PathLabel::A);
    assert_eq!((tip.load_share, tip.hertz_pressure), (0.0, 0.0));
    let law = sharing::Sharing::new(&pair, &light, params.sharing).expect("a law");
    let partner = law.share(pair.points.d + 1e-7, 0.0);
    assert_relative_eq!(partner, 1.0, max_relative = 1e-12);
}

/// Without relief two pairs share as their stiffness: at A of C14 9.66329e9 (a separate program) to 13.01077e9 at D, which carries the rest; the pitch point is alone.
#[test]
fn beams_share_by_stiffness() {
    let pair = GearPair::new(&c14()).expect("a pair");
    let operation = steel_operation(200.0, 1500.0);
    let model = ToothStiffness::Beams {
        bore_radii: [15e-3; 2],
    };
    let params = PathParams {
        sharing: LoadSharing::Stiffness(model),
        ..PathParams::default()
    };
    let path = pair.path(&operation, &params).expect("a path");
    let law = sharing::Sharing::new(&pair, &operation, params.sharing).expect("a law");
    let at_a = labelled(&path, PathLabel::A).load_share;
    // Next to D, where A is still in contact.
    let at_d = law.share(pair.points.d + 1e-7, 0.0);
    assert_relative_eq!(at_a + at_d, 1.0, max_relative = 1e-4);
    assert_relative_eq!(at_a, 9.663293 / (9.663293 + 13.010767), max_relative = 1e-4);
    near(labelled(&path, PathLabel::C).load_share, 1.0, 1e-12);
    let helical = GearPair::new(&h501()).expect("a pair");
    assert!(matches!(
        helical.path(&operation, &params),
        Err(GearError::Sharing { .. })
    ));
}

/// Worked example 1 of ISO/TR 6336-30 (as quoted by the program Drivetrain): m_n = 8 mm, z = 17/103, β = 15.8°, x = 0.145/0, rack D with h_fP* = 1.4, a = 500 mm:
/// c' = 12.37047 and c_γα = 17.46485 N/(mm µm), the latter with ε_α to three digits.
#[test]
fn single_stiffness_of_the_norm() {
    let mut dimensions = GearDimensions {
        helix_angle: 15.8_f64.to_radians(),
        pinion_shift: 0.145,
        wheel_shift: Some(0.0),
        centre_distance: Some(0.5),
        ..GearDimensions::spur(8e-3, [17, 103], PI / 9.0, 0.1)
    };
    dimensions.basic_rack.dedendum = 1.4;
    let pair = GearPair::new(&dimensions).expect("a pair");
    let load = 127352.0 / 0.1;
    let single = iso_single_stiffness(&pair, load, 1.0).expect("in range");
    assert_relative_eq!(single, 12.37047e9, max_relative = 1e-6);
    // A sixteenth of 100 N/mm halves it.
    let light = iso_single_stiffness(&pair, 1e5 / 16.0, 1.0).expect("in range");
    assert_relative_eq!(light, 0.5 * single, max_relative = 1e-12);
}

/// By hand, C14: z = 16/24, x = 0.1817/0.1715, h_fP* = 1.25, so C_B = 0.975:
/// 0.04723 + 0.009719375 + 0.01074625 − 0.001153795 − 0.0013234574 − 0.000330995 − 0.0017284342 + 0.0001746488 + 0.0000535303 = 0.0633871225.
/// Internal, z = 20/−60: 0.04723 + 0.15551/20 = 0.0550055.
#[test]
fn single_stiffness_by_hand() {
    let pair = GearPair::new(&c14()).expect("a pair");
    let single = iso_single_stiffness(&pair, 1e5, 1.0).expect("in range");
    assert_relative_eq!(single, 0.78e9 / 0.0633871225, max_relative = 1e-8);
    let internal = GearDimensions {
        meshing: Meshing::Internal,
        tip_diameters: [None, Some(117e-3)],
        ..GearDimensions::spur(2e-3, [20, 60], PI / 9.0, 20e-3)
    };
    let pair = GearPair::new(&internal).expect("a pair");
    let single = iso_single_stiffness(&pair, 1e5, 1.0).expect("in range");
    assert_relative_eq!(single, 0.78e9 / 0.0550055, max_relative = 1e-9);
    let operation = steel_operation(200.0, 1500.0);
    let params = PathParams {
        sharing: LoadSharing::Stiffness(ToothStiffness::Iso6336 { blank_factor: 1.0 }),
        ..PathParams::default()
    };
    let path = pair.path(&operation, &params).expect("a path");
    near(labelled(&path, PathLabel::A).load_share, 0.5, 1e-12);
}

/// An internal wheel turns the same way: both surfaces move on, the wheel's by z_1/z_2 at its radius; at the pitch point they roll.
#[test]
fn internal_wheel() {
    let dimensions = GearDimensions {
        meshing: Meshing::Internal,
        tip_diameters: [None, Some(117e-3)],
        ..GearDimensions::spur(2e-3, [20, 60], PI / 9.0, 20e-3)
    };
    let pair = GearPair::new(&dimensions).expect("a pair");
    let operation = steel_operation(50.0, 1000.0);
    let path = pair
        .path(&operation, &PathParams::default())
        .expect("a path");
    let pitch = labelled(&path, PathLabel::C);
    // ω r sin α = 104.720·0.02·0.342020 m/s of both.
    assert_relative_eq!(pitch.u_2, 0.716324, max_relative = 1e-5);
    assert_relative_eq!(pitch.u_1, 0.716324, max_relative = 1e-5);
    // At E 104.720·0.011436394 and 104.720/3·0.025117200.
    let end = labelled(&path, PathLabel::E);
    assert_relative_eq!(end.u_2, 1.197619, max_relative = 1e-5);
    assert_relative_eq!(end.u_1, 0.876753, max_relative = 1e-5);
    assert!(end.radius_body_1 < 0.0 && end.reduced_radius > end.radius_body_2);
}

/// Body 1 is the wheel: its surface moves at the speed that the motion of the contact gives to body 1, and its curvature comes first.
#[test]
fn bodies_of_the_contact() {
    let pair = GearPair::new(&c14()).expect("a pair");
    let operation = steel_operation(200.0, 1500.0);
    let path = pair
        .path(&operation, &PathParams::default())
        .expect("a path");
    let end = labelled(&path, PathLabel::E);
    let (contact, motion) = (end.contact(), end.motion());
    // At its tip the pinion has the larger radius of curvature, and is faster.
    assert_relative_eq!(motion.body_1_speed(), end.u_1, max_relative = 1e-12);
    assert_relative_eq!(motion.body_2_speed(), end.u_2, max_relative = 1e-12);
    assert!(end.u_2 > end.u_1);
    let [wheel, pinion] = contact.body_curvatures.expect("curvatures");
    assert!(wheel[0] > pinion[0]);
    near(wheel[0] + pinion[0], contact.radius.recip(), 1e-12);
}

#[test]
fn the_mean_length_carries_one_share() {
    let pair = GearPair::new(&h501()).expect("a pair");
    let params = PathParams {
        sharing: LoadSharing::MeanLength,
        ..PathParams::default()
    };
    let path = pair.path(&steel_operation(100.0, 1000.0), &params);
    for point in path.expect("a path") {
        near(point.load_share, pair.contact_ratio.recip(), 1e-12);
    }
}

#[test]
fn refusals() {
    let helical = GearPair::new(&h501()).expect("a pair");
    let operation = steel_operation(100.0, 1000.0);
    let thirds = PathParams {
        sharing: LoadSharing::Thirds,
        ..PathParams::default()
    };
    assert!(matches!(
        helical.path(&operation, &thirds),
        Err(GearError::Sharing { .. })
    ));
    let still = Operation {
        pinion_speed: 0.0,
        ..operation
    };
    let soft = Operation {
        materials: [Material {
            youngs_modulus: 0.0,
            ..steel()
        }; 2],
        ..operation
    };
    for operation in [still, soft] {
        assert!(helical.path(&operation, &PathParams::default()).is_err());
    }
    let single = PathParams {
        points: 1,
        ..PathParams::default()
    };
    assert!(helical.path(&operation, &single).is_err());
    let plain = GearDimensions {
        tip_alteration: TipAlteration::None,
        pinion_shift: -0.1,
        wheel_shift: Some(0.1),
        ..GearDimensions::spur(2e-3, [30, 40], PI / 9.0, 20e-3)
    };
    let pair = GearPair::new(&plain).expect("a pair");
    assert!(matches!(
        iso_single_stiffness(&pair, 1e5, 1.0),
        Err(GearError::Sharing { .. })
    ));
}
