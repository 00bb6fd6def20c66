use std::f64::consts::PI;

use super::*;
use crate::bearing::geometry::{BallGeometry, Play, RollerGeometry, RollerProfile};
use crate::bearing::kinematics::Speeds;
use crate::bearing::test_data::{rows, tapered};
use crate::bearing::{Bearing, Geometry, Material};
use crate::near::near;
use approx::{assert_abs_diff_eq, assert_relative_eq};
use ertel_ehl::contact::Ellipse;

fn free_angle() -> Params {
    Params {
        curvature_angle: CurvatureAngle::Free,
        ..Params::default()
    }
}

fn typical(clearance: f64) -> BallGeometry {
    BallGeometry {
        ball_diameter: 12.7e-3,
        pitch_diameter: 70e-3,
        number: 14,
        groove: [0.52, 0.53],
        play: Play::Clearance(clearance),
    }
}

fn cylindrical(clearance: f64) -> RollerGeometry {
    RollerGeometry {
        roller_diameter: 10e-3,
        length: 10e-3,
        pitch_diameter: 54e-3,
        number: 14,
        clearance,
        profile: RollerProfile::Logarithmic,
    }
}

fn at_rest(geometry: Geometry, loads: &Loads, params: &Params) -> Distribution {
    let found = Bearing::steel(geometry).solve(loads, Speeds::default(), params);
    found.unwrap_or_else(|error| panic!("{error}: {geometry:?} {loads:?}"))
}

/// Every row of data/ball_loads.csv.
#[test]
fn loads_of_an_independent_program() {
    let rows = rows(include_str!("data/ball_loads.csv"));
    assert_eq!(rows.len(), 9);
    for row in rows {
        let v = |i: usize| row[i].parse::<f64>().unwrap();
        let geometry = BallGeometry {
            ball_diameter: v(1) * 1e-3,
            pitch_diameter: v(2) * 1e-3,
            number: v(3) as usize,
            groove: [v(4), v(5)],
            play: Play::Clearance(v(6) * 1e-6),
        };
        near(geometry.free_angle().to_degrees(), v(9), 1e-6);
        let loads = Loads::forces(v(7), v(8));
        let found = at_rest(Geometry::Ball(geometry), &loads, &free_angle());
        assert_relative_eq!(found.shift[0], v(10) * 1e-6, max_relative = 1e-6);
        assert_relative_eq!(found.shift[2], v(11) * 1e-6, max_relative = 1e-5);
        let first = &found.elements[0].contacts;
        assert_relative_eq!(first[0].load, v(12), max_relative = 1e-6);
        assert_abs_diff_eq!(first[0].angle.to_degrees(), v(13), epsilon = 1e-5);
        let each = row[14].split(' ').map(|q| q.parse::<f64>().unwrap());
        for (load, expected) in found.loads(Ring::Outer).iter().zip(each) {
            assert_abs_diff_eq!(*load, expected, epsilon = 6e-3);
        }
        for (contact, [p, a, b]) in first.iter().zip([[15, 16, 17], [18, 19, 20]]) {
            assert_relative_eq!(contact.pressure, v(p) * 1e9, max_relative = 1e-6);
            assert_relative_eq!(contact.semi_axes[1], v(a) * 1e-3, max_relative = 1e-6);
            assert_relative_eq!(contact.semi_axes[0], v(b) * 1e-3, max_relative = 1e-6);
        }
    }
}

/// With stiffnesses at the loaded angle the same bearings carry almost alike: the curvature along rolling changes by γ (1 − cos α), 6 % of
/// 0.2 at 20 degrees, and the stiffness by less.
#[test]
fn loaded_and_free_angle_differ_little() {
    let geometry = Geometry::Ball(typical(15e-6));
    let loads = Loads::forces(1000.0, 3000.0);
    let loaded = at_rest(geometry, &loads, &Params::default());
    let free = at_rest(geometry, &loads, &free_angle());
    let largest = |d: &Distribution| d.heaviest(Ring::Inner).unwrap().load;
    assert_relative_eq!(largest(&loaded), largest(&free), max_relative = 1e-3);
    assert_ne!(largest(&loaded), largest(&free));
    // The solution satisfies Hertz: δ of both contacts at its angle is the approach of the grooves.
    let Geometry::Ball(ball) = geometry else {
        unreachable!()
    };
    let first = &loaded.elements[0].contacts;
    let [radial, axial] = ball.centres();
    let distance = (radial + loaded.shift[0]).hypot(axial + loaded.shift[2]);
    let approach: f64 = first
        .iter()
        .map(|c| Ellipse::of_radii(c.radii).approach(c.load, Material::STEEL.reduced_modulus))
        .sum();
    near(approach, distance - ball.centre_distance(), 1e-9);
}

/// Many balls and rollers of a bearing whose loaded zone is prescribed: F_r/(Z Q_max) against Sjoevall's integrals. A shift δ_r under a
/// clearance s gives ε = ½ (1 − s/(2δ_r)).
#[test]
fn sjoevalls_integrals() {
    let shift = 60e-6;
    for line in include_str!("data/sjoevall.csv").lines() {
        let row: Vec<&str> = line.split(',').collect();
        let Ok(epsilon) = row[2..3].concat().parse::<f64>() else {
            continue;
        };
        let clearance = 2.0 * shift * (1.0 - 2.0 * epsilon);
        let radial = [Given::Shift(shift), Given::Shift(0.0)];
        let loads = Loads {
            radial,
            axial: Given::Shift(0.0),
            tilt: [Given::Shift(0.0); 2],
        };
        let integral: f64 = row[3].parse().unwrap();
        let found = match row[0] {
            "point" => {
                // A groove of one height: contact angles of zero, without the axial part of the free angle.
                let geometry = BallGeometry {
                    ball_diameter: 2e-3,
                    number: 100,
                    ..typical(clearance)
                };
                let axial = Given::Shift(-geometry.centres()[1]);
                at_rest(
                    Geometry::Ball(geometry),
                    &Loads { axial, ..loads },
                    &free_angle(),
                )
            }
            _ => {
                let geometry = RollerGeometry {
                    roller_diameter: 1e-3,
                    number: 160,
                    profile: RollerProfile::Cylinder,
                    ..cylindrical(clearance)
                };
                at_rest(
                    Geometry::CylindricalRoller(geometry),
                    &loads,
                    &Params::default(),
                )
            }
        };
        let largest = found.heaviest(Ring::Inner).unwrap().load;
        let number = found.elements.len() as f64;
        near(found.force[0] / (number * largest), integral, 2e-4);
    }
}

/// Harris and Kotzalas, Essential Concepts of Bearing Technology, 5th ed., 2007, table 7.4, point contact, single row: J_r and J_a of F_r =
/// Z Q_max J_r cos α and F_a = Z Q_max J_a sin α under ε = ½ (1 + δ_a tan α/δ_r), to the printed digits (1.67 stands for 5/3), with so many
/// balls and such small shifts that loads are integrals and all angles one.
#[test]
fn table_of_harris() {
    let table = [
        [0.2, 0.1590, 0.1707],
        [0.3, 0.1892, 0.2110],
        [0.4, 0.2117, 0.2462],
        [0.5, 0.2288, 0.2782],
        [0.6, 0.2416, 0.3084],
        [0.7, 0.2505, 0.3374],
        [0.8, 0.2559, 0.3658],
        [0.9, 0.2576, 0.3945],
        [1.0, 0.2546, 0.4244],
        [1.25, 0.2289, 0.5044],
        [5.0 / 3.0, 0.1871, 0.6060],
        [2.5, 0.1339, 0.7240],
        [5.0, 0.0711, 0.8558],
    ];
    let angle = 40_f64.to_radians();
    let geometry = BallGeometry {
        ball_diameter: 1e-3,
        number: 200,
        play: Play::FreeAngle(angle),
        ..typical(0.0)
    };
    for [epsilon, j_r, j_a] in table {
        let (radial, tan) = (1e-10, angle.tan());
        let loads = Loads {
            radial: [Given::Shift(radial), Given::Shift(0.0)],
            axial: Given::Shift(radial * (2.0 * epsilon - 1.0) / tan),
            tilt: [Given::Shift(0.0); 2],
        };
        let found = at_rest(Geometry::Ball(geometry), &loads, &free_angle());
        let all = 200.0 * found.heaviest(Ring::Inner).unwrap().load;
        assert_abs_diff_eq!(found.force[0] / (all * angle.cos()), j_r, epsilon = 6e-5);
        assert_abs_diff_eq!(found.force[2] / (all * angle.sin()), j_a, epsilon = 6e-5);
    }
}

/// Stiffness of the ring against differences of the forces, all five directions, balls at rest and at speed, rollers likewise.
#[test]
fn stiffness_of_the_ring() {
    let held = [20e-6, -8e-6, 30e-6, 2e-4, -1e-4];
    for geometry in [
        Geometry::Ball(typical(15e-6)),
        Geometry::CylindricalRoller(cylindrical(5e-6)),
        Geometry::TaperedRoller(tapered()),
    ] {
        for inner in [0.0, 2000.0] {
            let at = |shift: [f64; 5]| {
                let [x, y, z, a, b] = shift.map(Given::Shift);
                let loads = Loads {
                    radial: [x, y],
                    axial: z,
                    tilt: [a, b],
                };
                let speeds = Speeds { inner, outer: 0.0 };
                let bearing = Bearing::steel(geometry);
                bearing.solve(&loads, speeds, &Params::default()).unwrap()
            };
            let found = at(held);
            for j in 0..5 {
                let step = if j < 3 { 1e-9 } else { 1e-7 };
                let shifted = |sign: f64| {
                    let mut shift = held;
                    shift[j] += sign * step;
                    at(shift).reaction()
                };
                let (low, high) = (shifted(-1.0), shifted(1.0));
                for i in 0..5 {
                    let difference = (high[i] - low[i]) / (2.0 * step);
                    let size = (found.stiffness[i][i] * found.stiffness[j][j]).sqrt();
                    assert_abs_diff_eq!(
                        found.stiffness[i][j],
                        difference,
                        epsilon = 2e-5 * size.max(1.0)
                    );
                }
            }
        }
    }
}

/// Under a moment alone half of the balls carry to either side; the sums of forces are checked by hand from the elements.
#[test]
fn five_loads() {
    let geometry = BallGeometry {
        play: Play::FreeAngle(25_f64.to_radians()),
        ..typical(0.0)
    };
    let loads = Loads {
        radial: [Given::Load(800.0), Given::Load(-500.0)],
        axial: Given::Load(4000.0),
        tilt: [Given::Load(10.0), Given::Load(-20.0)],
    };
    let found = at_rest(Geometry::Ball(geometry), &loads, &Params::default());
    let mut sum = [0.0; 5];
    for element in &found.elements {
        let contact = &element.contacts[0];
        let (s, c) = element.position.sin_cos();
        let radial = contact.load * contact.angle.cos();
        let axial = contact.load * contact.angle.sin();
        let arm = 35e-3 + 0.02 * 12.7e-3 * 25_f64.to_radians().cos();
        let parts = [
            radial * c,
            radial * s,
            axial,
            arm * s * axial,
            -arm * c * axial,
        ];
        (0..5).for_each(|i| sum[i] += parts[i]);
    }
    for (found, given) in sum.iter().zip([800.0, -500.0, 4000.0, 10.0, -20.0]) {
        assert_relative_eq!(*found, given, max_relative = 1e-5);
    }
}

/// A moment alone presses balls and rollers on opposite sides, and a preload needs no load at all: shifts that follow from it are zero.
#[test]
fn moments_and_preloads_alone() {
    let squeezed = BallGeometry {
        play: Play::Clearance(-6e-6),
        ..typical(0.0)
    };
    for geometry in [
        Geometry::Ball(typical(15e-6)),
        Geometry::Ball(squeezed),
        Geometry::CylindricalRoller(cylindrical(5e-6)),
        Geometry::CylindricalRoller(cylindrical(-5e-6)),
    ] {
        let loads = Loads {
            tilt: [Given::Load(0.0), Given::Load(15.0)],
            ..Loads::forces(0.0, 0.0)
        };
        let found = at_rest(geometry, &loads, &Params::default());
        assert_relative_eq!(found.moment[1], 15.0, max_relative = 1e-7);
        assert!(found.tilt[1] > 0.0);
    }
    let still = at_rest(
        Geometry::Ball(squeezed),
        &Loads::forces(0.0, 0.0),
        &Params::default(),
    );
    assert_abs_diff_eq!(still.shift[0], 0.0, epsilon = 1e-12);
    let loads = still.loads(Ring::Inner);
    assert!(loads[0] > 0.0 && loads.iter().all(|q| (q - loads[0]).abs() < 1e-6 * loads[0]));
    // δ = 3 µm of both contacts
    let approach: f64 = (still.elements[0].contacts.iter())
        .map(|c| Ellipse::of_radii(c.radii).approach(c.load, Material::STEEL.reduced_modulus))
        .sum();
    assert_relative_eq!(approach, 3e-6, max_relative = 1e-6);
}

/// Bearings of all kinds under loads of many sizes and directions converge, in few steps.
#[test]
fn a_sweep_of_loads_converges() {
    let mut worst = 0;
    for clearance in [-10e-6, 0.0, 30e-6, 300e-6] {
        for radial in [0.0, 1.0, 100.0, 20_000.0] {
            for axial in [-30_000.0, -100.0, 0.0, 1.0, 3000.0] {
                for inner in [0.0, 1000.0] {
                    if radial == 0.0 && axial == 0.0 {
                        continue;
                    }
                    let speeds = Speeds { inner, outer: 0.0 };
                    let bearing = Bearing::steel(Geometry::Ball(typical(clearance)));
                    for tilt in [Given::Shift(0.0), Given::Load(0.0)] {
                        let loads = Loads {
                            tilt: [tilt; 2],
                            ..Loads::forces(radial, axial)
                        };
                        let found = bearing.solve(&loads, speeds, &Params::default());
                        let found = found.unwrap_or_else(|e| {
                            panic!("{e}: {clearance} {radial} {axial} {inner} {tilt:?}")
                        });
                        worst = worst.max(found.info.iterations);
                    }
                }
            }
        }
    }
    assert!(worst <= 60, "{worst}");
}

/// Signs: an axial load that turns around mirrors the contact angles.
#[test]
fn axial_loads_mirror() {
    let geometry = Geometry::Ball(typical(15e-6));
    let there = at_rest(geometry, &Loads::forces(500.0, 2000.0), &Params::default());
    let back = at_rest(geometry, &Loads::forces(500.0, -2000.0), &Params::default());
    for (a, b) in there.elements.iter().zip(&back.elements) {
        assert_relative_eq!(a.contacts[0].load, b.contacts[0].load, max_relative = 1e-6);
        near(a.contacts[0].angle, -b.contacts[0].angle, 1e-6);
    }
}

/// At speed the outer ring also carries the centrifugal force: Σ over balls of (Q_o cos α_o − Q_i cos α_i) = F_c each under outer
/// control but for the part of the gyroscopic moment.
#[test]
fn balls_at_speed() {
    let geometry = BallGeometry {
        play: Play::FreeAngle(25_f64.to_radians()),
        ..typical(0.0)
    };
    let bearing = Bearing::steel(Geometry::Ball(geometry));
    let speeds = Speeds {
        inner: 2000.0,
        outer: 0.0,
    };
    let loads = Loads::forces(0.0, 3000.0);
    let found = bearing.solve(&loads, speeds, &Params::default()).unwrap();
    let element = &found.elements[3];
    let [inner, outer] = &element.contacts;
    let friction = 2.0 * element.gyroscopic_moment / 12.7e-3;
    assert_relative_eq!(
        outer.load * outer.angle.cos() - friction * outer.angle.sin(),
        inner.load * inner.angle.cos() + element.centrifugal_force,
        max_relative = 1e-9
    );
    near(inner.load * inner.angle.sin() * 14.0, 3000.0, 1e-8);
    assert!(outer.angle < inner.angle && outer.load > inner.load);
    assert!(element.gyroscopic_moment > 0.0);
    // outer control: no relative spin there
    assert_relative_eq!(outer.spin[0], outer.spin[1], max_relative = 1e-9);
    assert!((inner.spin[0] - inner.spin[1]).abs() > 1.0);
}

/// By hand: a ball of 12.7 mm has 8.41940e-3 kg; γ = 12.7/70, ω_m = [1000 (1 − γ) − 200 (1 + γ)]/2 = 291.143 rad/s at 35 mm: 24.978 N. A roller of 10 mm by 10 mm has 6.16538e-3 kg; γ = 10/54,
/// ω_m = 288.889 rad/s at 27 mm: 13.893 N, which is also what the rollers of a solved bearing have.
#[test]
fn centrifugal_forces_by_hand() {
    let speeds = Speeds {
        inner: 1000.0,
        outer: -200.0,
    };
    let density = Material::STEEL.density;
    let ball = Geometry::Ball(typical(0.0)).centrifugal_force(density, speeds);
    assert_relative_eq!(ball, 24.978, max_relative = 1e-4);
    let rollers = Geometry::CylindricalRoller(cylindrical(0.0));
    let roller = rollers.centrifugal_force(density, speeds);
    assert_relative_eq!(roller, 13.893, max_relative = 1e-4);
    let loads = Loads::forces(5000.0, 0.0);
    let found = Bearing::steel(rollers).solve(&loads, speeds, &Params::default());
    let element = &found.unwrap().elements[0];
    assert_relative_eq!(element.centrifugal_force, roller, max_relative = 1e-12);
}

/// A ball that the inner ring does not reach is pressed outwards: its contact angle is 0 at both rings, and it rolls as fast as one with that angle, ω_m = ω_i (1 − D/d_m)/2.
#[test]
fn loose_balls_have_the_angle_of_the_outer_ring() {
    let bearing = Bearing::steel(Geometry::Ball(typical(30e-6)));
    let speeds = Speeds {
        inner: 500.0,
        outer: 0.0,
    };
    let loads = Loads {
        axial: Given::Shift(-150e-6),
        ..Loads::forces(3000.0, 0.0)
    };
    let found = bearing.solve(&loads, speeds, &Params::default()).unwrap();
    let loose: Vec<&Element> = (found.elements.iter())
        .filter(|element| element.contacts[0].load == 0.0)
        .collect();
    assert!(!loose.is_empty());
    for element in loose {
        assert_eq!(element.contacts.each_ref().map(|c| c.angle), [0.0; 2]);
        let cage = 250.0 * (1.0 - 12.7 / 70.0);
        assert_relative_eq!(element.cage_speed, cage, max_relative = 1e-9);
    }
}

/// A roller bearing of zero clearance and two directions of load: F_r = Σ Q cos ψ, slices add up, and tilt shifts the load along the rollers.
#[test]
fn rollers() {
    let geometry = Geometry::CylindricalRoller(cylindrical(0.0));
    let upright = at_rest(geometry, &Loads::forces(5000.0, 0.0), &Params::default());
    let sum: f64 = (upright.elements.iter())
        .map(|e| e.contacts[1].load * e.position.cos())
        .sum();
    assert_relative_eq!(sum, 5000.0, max_relative = 1e-8);
    let first = &upright.elements[0].contacts[0];
    let width = 10e-3 / 41.0;
    let slices: f64 = first.slices.iter().map(|s| s.line_load * width).sum();
    assert_relative_eq!(slices, first.load, max_relative = 1e-12);
    // p = √(w E'/(2π R)) in the middle
    let middle = first.slices[20];
    let modulus = Material::STEEL.reduced_modulus;
    let pressure = (middle.line_load * modulus / (2.0 * PI * first.radii[0])).sqrt();
    assert_relative_eq!(middle.pressure, pressure, max_relative = 1e-9);
    // Half-width b = √(8 w R/(π E')) under the mean load per length w = Q/L.
    let mean = first.load / 10e-3;
    let half_width = (8.0 * mean * first.radii[0] / (PI * modulus)).sqrt();
    assert_relative_eq!(first.semi_axes[0], half_width, max_relative = 1e-9);
    let tilted = Loads {
        tilt: [Given::Shift(0.0), Given::Shift(1e-3)],
        ..Loads::forces(5000.0, 0.0)
    };
    let tilted = at_rest(geometry, &tilted, &Params::default());
    let loads = &tilted.elements[0].contacts[0].slices;
    // θ_y lifts z > 0 towards x.
    assert!(loads[32].line_load > loads[8].line_load);
    assert!(tilted.moment[1] > 0.0);
}

/// Tapered rollers under an axial load alone: Z Q_o sin α_o = F_a, and the forces of cone, cup, rib and inertia on a roller are in balance.
#[test]
fn tapered_rollers() {
    let bearing = Bearing::steel(Geometry::TaperedRoller(tapered()));
    let angle = 14_f64.to_radians();
    for inner_speed in [0.0, 1000.0] {
        let speeds = Speeds {
            inner: inner_speed,
            outer: 0.0,
        };
        let loads = Loads::forces(0.0, 4000.0);
        let found = bearing.solve(&loads, speeds, &Params::default()).unwrap();
        let element = &found.elements[2];
        let [inner, outer] = &element.contacts;
        if inner_speed == 0.0 {
            assert_relative_eq!(16.0 * outer.load * angle.sin(), 4000.0, max_relative = 1e-8);
        }
        // (r, z) on the roller: the cone pushes out, the cup in, the rib along the axis towards the apex.
        let beta = element.attitude;
        let sum = [
            inner.load * inner.angle.cos()
                - outer.load * angle.cos()
                - element.rib_load * beta.sin()
                + element.centrifugal_force,
            inner.load * inner.angle.sin() - outer.load * angle.sin()
                + element.rib_load * beta.cos(),
        ];
        for part in sum {
            assert_abs_diff_eq!(part, 0.0, epsilon = 1e-8 * outer.load);
        }
        // The ring bears cone and rib.
        let axial = inner.load * inner.angle.sin() + element.rib_load * beta.cos();
        assert_relative_eq!(16.0 * axial, 4000.0, max_relative = 1e-8);
        assert_relative_eq!(inner.spin[0], inner.spin[1], max_relative = 1e-12);
    }
    let combined = Loads::forces(6000.0, 3000.0);
    let found = bearing
        .solve(&combined, Speeds::default(), &Params::default())
        .unwrap();
    let radial: f64 = (found.elements.iter())
        .map(|e| e.contacts[1].load * angle.cos() * e.position.cos())
        .sum();
    assert_relative_eq!(radial, 6000.0, max_relative = 1e-8);
    let loose = bearing.solve(
        &Loads::forces(1000.0, 0.0),
        Speeds::default(),
        &Params::default(),
    );
    assert_eq!(loose, Err(Error::Separation(0.0)));
}

#[test]
fn unsolvable_loads_are_refused() {
    let ball = Bearing::steel(Geometry::Ball(typical(15e-6)));
    let roller = Bearing::steel(Geometry::CylindricalRoller(cylindrical(5e-6)));
    let solve = |bearing: &Bearing, loads: Loads, params: &Params| {
        bearing
            .solve(&loads, Speeds::default(), params)
            .unwrap_err()
    };
    let defaults = Params::default();
    assert_eq!(
        solve(&ball, Loads::forces(0.0, 0.0), &defaults),
        Error::Unloaded
    );
    assert_eq!(
        solve(&roller, Loads::forces(0.0, 0.0), &defaults),
        Error::Unloaded
    );
    let loose = Loads {
        radial: [Given::Shift(1e-6), Given::Shift(0.0)],
        ..Loads::forces(0.0, 0.0)
    };
    assert_eq!(solve(&roller, loose, &defaults), Error::Unloaded);
    let axial = solve(&roller, Loads::forces(100.0, 50.0), &defaults);
    assert_eq!(axial, Error::AxialLoad(50.0));
    let held = Loads {
        axial: Given::Shift(0.0),
        ..Loads::forces(0.0, 0.0)
    };
    assert_eq!(solve(&ball, held, &defaults), Error::Unloaded);
    let nan = solve(&ball, Loads::forces(f64::NAN, 0.0), &defaults);
    assert!(matches!(nan, Error::Value { .. }));
    let hasty = Params {
        iterations: 1,
        ..defaults
    };
    let hasty = solve(&ball, Loads::forces(2000.0, 500.0), &hasty);
    assert!(matches!(hasty, Error::NoConvergence { .. }), "{hasty}");
    let bad = Geometry::Ball(BallGeometry {
        number: 2,
        ..typical(0.0)
    });
    let bad = solve(&Bearing::steel(bad), Loads::forces(1.0, 0.0), &defaults);
    assert!(matches!(bad, Error::Geometry(_)));
}

/// Rollers that are cylinders bear evenly without tilt; tilted so that one end is just relieved, the load grows from it as t^(10/9): 19/9 of the mean at the
/// other end, in the last slice of 41 less by its half width.
#[test]
fn the_heaviest_slice_of_a_roller() {
    let geometry = crate::bearing::geometry::RollerGeometry {
        profile: RollerProfile::Cylinder,
        ..cylindrical(0.0)
    };
    let ratio = |tilt: f64| {
        let loads = Loads {
            radial: [Given::Shift(20e-6), Given::Shift(0.0)],
            axial: Given::Shift(0.0),
            tilt: [Given::Shift(0.0), Given::Shift(tilt)],
        };
        let found = Bearing::steel(Geometry::CylindricalRoller(geometry))
            .solve(&loads, Speeds::default(), &Params::default())
            .unwrap();
        found.elements[0].contacts[0].peak_slice().unwrap()
    };
    assert_relative_eq!(ratio(0.0), 1.0, max_relative = 1e-12);
    let last = 19.0 / 9.0 * (40.5_f64 / 41.0).powf(10.0 / 9.0);
    assert_relative_eq!(ratio(4e-3), last, max_relative = 2e-3);
}
