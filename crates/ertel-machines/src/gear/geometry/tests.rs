use crate::near::near;
use approx::assert_relative_eq;

use super::*;
use crate::gear::test_data::{fzg, rows};

const ALPHA: f64 = std::f64::consts::PI / 9.0;

fn internal(teeth: [u32; 2]) -> GearDimensions {
    GearDimensions {
        meshing: Meshing::Internal,
        ..GearDimensions::spur(2e-3, teeth, ALPHA, 20e-3)
    }
}

/// All rows of a separate program: the working angle, the contact ratio and the points of the path.
#[test]
fn fzg_gears_of_a_separate_program() {
    let table = rows(include_str!("../data/fzg_line_of_action.csv"));
    for row in &table {
        let pair = GearPair::new(&fzg(row.text("gear"))).expect("a pair");
        let angle = pair.working_pressure_angle.to_degrees();
        assert_relative_eq!(angle, row.number("working_angle_deg"), max_relative = 1e-9);
        near(pair.contact_ratio, row.number("contact_ratio"), 1e-9);
        let points = pair.points;
        let s = match row.text("point") {
            "A" => points.a,
            "B" => points.b,
            "C" => 0.0,
            "D" => points.d,
            _ => points.e,
        };
        let [pinion, wheel] = pair.curvature_radii(s);
        assert_relative_eq!(1e3 * pinion, row.number("rho1_mm"), max_relative = 1e-9);
        assert_relative_eq!(1e3 * wheel, row.number("rho2_mm"), max_relative = 1e-9);
        let reduced = 1e3 * pair.reduced_radius(s);
        assert_relative_eq!(reduced, row.number("R_mm"), max_relative = 1e-9);
    }
    assert_eq!(table.len(), 15);
}

/// To the printed digits; the centre distance follows from the shifts, to the 4 digits that these have.
#[test]
fn pairs_of_a_published_program() {
    for row in rows(include_str!("../data/published_pairs.csv")) {
        let number = |key| row.number(key);
        let dimensions = GearDimensions {
            helix_angle: number("beta_deg").to_radians(),
            pinion_shift: number("x1"),
            wheel_shift: Some(number("x2")),
            tip_alteration: if number("shortened") == 1.0 {
                TipAlteration::KeepClearance
            } else {
                TipAlteration::None
            },
            ..GearDimensions::spur(
                1e-3 * number("module"),
                [number("z1") as u32, number("z2") as u32],
                ALPHA,
                1e-3 * number("b"),
            )
        };
        let pair = GearPair::new(&dimensions).expect("a pair");
        assert!((1e3 * pair.centre_distance - 91.5).abs() < 1e-3);
        let points = pair.points;
        let lengths = [
            ("r1", pair.reference_radii[0], 6e-4),
            ("r2", pair.reference_radii[1], 6e-4),
            ("ra1", pair.tip_radii[0], 6e-4),
            ("ra2", pair.tip_radii[1], 6e-4),
            ("rf1", pair.root_radii[0], 6e-4),
            ("rf2", pair.root_radii[1], 6e-4),
            ("pbt", pair.base_pitch, 6e-4),
            ("T1T2", points.wheel_tangent - points.pinion_tangent, 6e-3),
            ("AB", points.b - points.a, 6e-3),
            ("AC", -points.a, 6e-3),
            ("AD", points.d - points.a, 6e-3),
            ("AE", points.e - points.a, 6e-3),
        ];
        for (key, value, digits) in lengths {
            assert!(
                (1e3 * value - number(key)).abs() < digits,
                "{} {key}: {value}",
                row.text("gear")
            );
        }
        assert!((pair.contact_ratio - number("eps_alpha")).abs() < 6e-3);
        assert!((pair.overlap_ratio - number("eps_beta")).abs() < 6e-3);
    }
}

/// By hand: z = 20/60, m = 2 mm: r = 20 and 60 mm, r_b = 18.793852 and 56.381557 mm, r_a = 22 and 58.5 mm, a = 40 mm.
/// AE = √(22² − r_b1²) − √(58.5² − r_b2²) + 40 sin 20° = 11.436394 − 15.600321 + 13.680806 mm; p_b = 2π cos 20° = 5.904263 mm.
/// At the pinion's tip ρ_1 = 11.436394 mm, the wheel's is concave: 11.436394 + 13.680806 mm.
#[test]
fn internal_pair_by_hand() {
    let dimensions = GearDimensions {
        tip_diameters: [None, Some(117e-3)],
        ..internal([20, 60])
    };
    let pair = GearPair::new(&dimensions).expect("a pair");
    assert_relative_eq!(pair.centre_distance, 40e-3, max_relative = 1e-12);
    let ratio = (11.436394 - 15.600321 + 13.680806) / 5.904263;
    assert_relative_eq!(pair.contact_ratio, ratio, max_relative = 1e-6);
    let [pinion, wheel] = pair.curvature_radii(pair.points.e);
    assert_relative_eq!(1e3 * pinion, 11.436394, max_relative = 1e-6);
    assert_relative_eq!(1e3 * wheel, -25.117200, max_relative = 1e-6);
    // Conformal: 1/R = 1/11.436394 − 1/25.117200.
    let reduced = 1e3 * pair.reduced_radius(pair.points.e);
    assert_relative_eq!(reduced, 20.996585, max_relative = 1e-6);
    // Tip thickness of the wheel: 2·58.5 (π/120 − inv 20° + inv α_a), cos α_a = 56.381557/58.5.
    let at_tip = 56.381557_f64 / 58.5;
    let thickness = 117.0
        * (std::f64::consts::PI / 120.0 - 0.014904384 + (at_tip.acos().tan() - at_tip.acos()));
    let found = 1e3 * pair.tip_thickness(Member::Wheel);
    assert_relative_eq!(found, thickness, max_relative = 1e-6);
    assert!(pair.warnings.is_empty(), "{:?}", pair.warnings);
    // With a full addendum, 58 mm, the wheel's tips pass the tangent point of the pinion: √(58² − r_b2²) < 40 sin 20°.
    let full = GearPair::new(&internal([20, 60])).expect("a pair");
    assert!(full.warnings.contains(&GearWarning::TipBeyondTangent {
        member: Member::Pinion
    }));
    near(full.contact_ratio, 11.436394 / 5.904263, 1e-6);
}

/// The corner of the driving tooth is followed in the wheel's frame from the pitch point to the tip circle of the wheel, and must stay behind the flank.
#[test]
fn tips_of_internal_pairs_against_motion() {
    let mut seen = [0, 0];
    for pinion in [26, 30, 34, 50] {
        for wheel in (pinion + 4..pinion + 12).filter(|wheel| *wheel >= 34) {
            let result = GearPair::new(&internal([pinion, wheel]));
            let refused = matches!(result, Err(GearError::InternalTips { .. }));
            assert!(refused || result.is_ok(), "{:?}", result.err());
            assert_eq!(refused, collides([pinion, wheel]), "{pinion} in {wheel}");
            seen[usize::from(refused)] += 1;
        }
    }
    assert!(seen[0] > 5 && seen[1] > 5, "{seen:?}");
    let margin = GearPair::new(&internal([20, 60]))
        .expect("a pair")
        .internal_tip_margin();
    assert!(margin.is_none_or(|margin| margin > 0.0));
}

/// Whether the corner of a pinion's tooth of an unshifted pair (m = 2 mm, addendum 2 mm) enters the flank of the wheel it drives.
fn collides(teeth: [u32; 2]) -> bool {
    let [z_1, z_2] = teeth.map(f64::from);
    let [r_1, r_2] = [z_1, z_2];
    let (tip_1, tip_2) = (r_1 + 2.0, r_2 - 2.0);
    let [base_1, base_2] = [r_1, r_2].map(|r| r * ALPHA.cos());
    let inv = |base: f64, r: f64| involute((base / r).acos());
    let behind = inv(base_1, tip_1) - involute(ALPHA);
    // From the end of contact on: the corner is on the flank there.
    let steps = 20_000;
    (0..steps).any(|i| {
        let turn = 2.0 * f64::from(i) / f64::from(steps);
        let at = turn - behind;
        let place = [(r_2 - r_1) + tip_1 * at.cos(), tip_1 * at.sin()];
        let radius = place[0].hypot(place[1]);
        if !(tip_2..r_2 + 2.0).contains(&radius) {
            return false;
        }
        let seen = place[1].atan2(place[0]) - turn * z_1 / z_2;
        // The flank passes through the pitch point at the angle 0 and leans ahead towards the tip.
        let flank = involute(ALPHA) - inv(base_2, radius);
        seen > flank + 1e-9
    })
}

#[test]
fn shift_from_the_centre_distance() {
    // inv α_wt − inv 20° with cos α_wt = 90 cos 20°/91.5: α_wt = 22.438791°, and x_1 + x_2 = 0.35313 (published: 0.1817 + 0.1715).
    let dimensions = GearDimensions {
        centre_distance: Some(91.5e-3),
        pinion_shift: 0.1817,
        ..GearDimensions::spur(4.5e-3, [16, 24], ALPHA, 14e-3)
    };
    let pair = GearPair::new(&dimensions).expect("a pair");
    assert!((pair.shifts[1] - 0.1715).abs() < 1e-4, "{}", pair.shifts[1]);
    let wrong = GearDimensions {
        wheel_shift: Some(0.0),
        ..dimensions
    };
    assert!(matches!(
        GearPair::new(&wrong),
        Err(GearError::Inconsistent { .. })
    ));
}

#[test]
fn refusals() {
    let spur = GearDimensions::spur(2e-3, [20, 40], ALPHA, 20e-3);
    let refuse = |dimensions: GearDimensions| GearPair::new(&dimensions).expect_err("refused");
    assert!(matches!(
        refuse(GearDimensions {
            centre_distance: Some(-60e-3),
            ..spur.clone()
        }),
        GearError::Value { .. }
    ));
    assert!(matches!(
        refuse(GearDimensions {
            centre_distance: Some(56e-3),
            ..spur.clone()
        }),
        GearError::CentreDistance { .. }
    ));
    assert!(matches!(
        refuse(GearDimensions {
            tip_diameters: [Some(48e-3), None],
            ..spur.clone()
        }),
        GearError::Pointed {
            member: Member::Pinion,
            ..
        }
    ));
    assert!(matches!(
        refuse(GearDimensions {
            tip_diameters: [Some(40.5e-3), Some(80.5e-3)],
            ..spur.clone()
        }),
        GearError::ContactRatio { .. }
    ));
    assert!(matches!(
        refuse(GearDimensions {
            tip_diameters: [Some(30e-3), None],
            ..spur.clone()
        }),
        GearError::TipInsideBase { .. }
    ));
    assert!(matches!(
        refuse(internal([20, 20])),
        GearError::InternalTeeth { .. }
    ));
    assert!(matches!(
        refuse(GearDimensions {
            pinion_shift: -2.0,
            ..spur.clone()
        }),
        GearError::ProfileShift { .. }
    ));
    assert!(matches!(
        refuse(GearDimensions {
            normal_module: f64::NAN,
            ..spur
        }),
        GearError::Value { .. }
    ));
}

/// Without shift a rack of the addendum m undercuts fewer than 2/sin² 20° = 17.1 teeth: 17 are, 18 are not. The tip of the rack's straight
/// flank is at h_fP* − ρ_fP* (1 − sin 20°) = 1.25 − 0.38·0.65798 = 0.99997 modules.
#[test]
fn undercut() {
    let warnings = |z| {
        GearPair::new(&GearDimensions::spur(2e-3, [z, 60], ALPHA, 20e-3))
            .expect("a pair")
            .warnings
    };
    let undercut = GearWarning::Undercut {
        member: Member::Pinion,
    };
    assert!(warnings(17).contains(&undercut));
    assert!(!warnings(18).contains(&undercut));
    // z = 10 against 60: the wheel's tip passes the tangent point of the pinion.
    assert!(warnings(10).contains(&GearWarning::TipBeyondTangent {
        member: Member::Pinion
    }));
}

/// By hand: z = 20/40, m = 2 mm, a = 60 mm, r_f = 17.5 and 37.5 mm. A wheel of the tip radius 43 mm leaves 60 − 43 − 17.5 = −0.5 mm at the pinion's root.
/// One of r_a2 touches the pinion down to 60 sin 20° − √(r_a2² − r_b2²) from the tangent point, and the rack leaves an involute from
/// 20 sin 20° − 2 (1.25 − 0.38 (1 − sin 20°))/sin 20° on: that is at r_a2 between 42.3 and 42.4 mm.
#[test]
fn roots() {
    let mut dimensions = GearDimensions::spur(2e-3, [20, 40], ALPHA, 20e-3);
    assert!(
        GearPair::new(&dimensions)
            .expect("a pair")
            .warnings
            .is_empty()
    );
    dimensions.tip_diameters[1] = Some(86e-3);
    dimensions.root_diameters[1] = Some(75e-3);
    let pair = GearPair::new(&dimensions).expect("a pair");
    let clearance = pair.warnings.iter().find_map(|warning| match warning {
        GearWarning::NoClearance { member, clearance } => Some((*member, *clearance)),
        _ => None,
    });
    let (member, clearance) = clearance.expect("a warning");
    assert_eq!(member, Member::Pinion);
    assert_relative_eq!(clearance, -0.5e-3, max_relative = 1e-9);
    let form = |tip: f64| {
        let mut dimensions = GearDimensions::spur(2e-3, [20, 40], ALPHA, 20e-3);
        dimensions.tip_diameters[1] = Some(2.0 * tip);
        let warnings = GearPair::new(&dimensions).expect("a pair").warnings;
        warnings.iter().find_map(|warning| match warning {
            GearWarning::BelowForm {
                member: Member::Pinion,
                form_diameter,
                contact_diameter,
            } => Some([*form_diameter, *contact_diameter]),
            _ => None,
        })
    };
    let sine = ALPHA.sin();
    let bases = [20.0, 40.0].map(|r: f64| r * ALPHA.cos());
    let flank_end: f64 = 20.0 * sine - 2.0 * (1.25 - 0.38 * (1.0 - sine)) / sine;
    let start = |tip: f64| 60.0 * sine - (tip * tip - bases[1] * bases[1]).sqrt();
    assert!(
        start(42.3) > flank_end && start(42.4) < flank_end,
        "{} {} {flank_end}",
        start(42.3),
        start(42.4)
    );
    assert_eq!(form(42.3e-3), None);
    let [form_diameter, contact_diameter] = form(42.4e-3).expect("a warning");
    near(1e3 * form_diameter, 2.0 * bases[0].hypot(flank_end), 1e-9);
    assert_relative_eq!(
        1e3 * contact_diameter,
        2.0 * bases[0].hypot(start(42.4)),
        max_relative = 1e-9
    );
}

/// C_a = 20 µm over 2 mm: halfway 10 µm if linear, 5 µm if parabolic.
#[test]
fn reliefs() {
    let relief = |shape| Relief {
        amount: 20e-6,
        length: 2e-3,
        shape,
    };
    let mut dimensions = GearDimensions::spur(2e-3, [20, 40], ALPHA, 20e-3);
    dimensions.reliefs = [
        Some(relief(ReliefShape::Linear)),
        Some(relief(ReliefShape::Parabolic)),
    ];
    let pair = GearPair::new(&dimensions).expect("a pair");
    near(pair.relief(pair.points.e - 1e-3), 10e-6, 1e-9);
    assert_relative_eq!(pair.relief(pair.points.a + 1e-3), 5e-6, max_relative = 1e-9);
    assert_eq!(pair.relief(0.0), 0.0);
}
