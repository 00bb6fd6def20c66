//! Shear-thinning contacts against what theory says of their solutions.

use crate::common;

use approx::assert_relative_eq;
use common::{near, solved};
use ertel::case::Case;
use ertel::contact::ContactKind;
use ertel::params::Method;
use ertel::params::{MeshParams, MeshPreset};
use ertel::solution::{Centreline, Solution};
use ertel_rheology::shear::{Carreau, ReeEyring, ShearLaw, ShearThinning};

/// A case on a mesh that is cheap rather than accurate, solved until nothing moves.
fn case(kind: ContactKind, law: ShearLaw, slide_to_roll_ratio: f64) -> Case {
    let load = if kind == ContactKind::Line { 2e5 } else { 60.0 };
    let mut case = common::case(kind, load);
    if kind == ContactKind::Circular {
        case.mesh.hertz_size = 0.3;
        case.mesh.constriction_size = 0.15;
        case.mesh.edge_size = 0.8;
        case.mesh.depth_growth = 0.9;
        case.mesh.pressure_order = 2;
    }
    case.lubricant.shear_thinning = Some(ShearThinning::of(law));
    case.motion.slide_to_roll_ratio = slide_to_roll_ratio;
    case.solver.error_estimate = false;
    case.solver.tolerance = 1e-10;
    case
}

fn carreau(plateau_ratio: f64) -> ShearLaw {
    ShearLaw::Carreau(Carreau::new(3e4, 0.7, 2.0, plateau_ratio).unwrap())
}

fn eyring(stress: f64) -> ShearLaw {
    ShearLaw::ReeEyring(ReeEyring::new(stress).unwrap())
}

/// Largest difference of the pressures on the centreline, over the Hertz pressure.
fn pressure_difference(a: &Solution, b: &Solution) -> f64 {
    let pairs = a.centreline.pressure.iter().zip(&b.centreline.pressure);
    let largest = pairs.fold(0.0_f64, |m, (p, q)| m.max((p - q).abs()));
    largest / a.hertz.pressure
}

fn films(s: &Solution) -> [f64; 2] {
    [s.summary.film_central.value, s.summary.film_minimum.value]
}

/// With its plateaus alike the fluid is Newtonian, and the general flow must give the Newtonian solver's answer.
/// Newton's method ends at 1e-10; 1e-8 is asked for.
#[test]
fn equal_plateaus_are_newtonian() {
    for kind in [ContactKind::Line, ContactKind::Circular] {
        let mut general = case(kind, carreau(1.0), 0.3);
        general.solver.method = Some(Method::FiniteElements);
        let mut newtonian = general.clone();
        newtonian.solver.newtonian = true;
        let (a, b) = (solved(&general), solved(&newtonian));
        for (x, y) in films(&a).into_iter().zip(films(&b)) {
            assert_relative_eq!(x, y, max_relative = 1e-8);
        }
        assert!(pressure_difference(&a, &b) < 1e-8);
        let (a, b) = (&a.traction, &b.traction);
        near(a.coefficient.value, b.coefficient.value, 1e-8);
        near(a.friction_power.value, b.friction_power.value, 1e-8);
        // And plateaus that differ do not.
        let thinned = solved(&case(kind, carreau(0.2), 0.3));
        assert!(films(&thinned)[0] < 0.95 * films(&solved(&newtonian))[0]);
    }
}

/// Whichever surface is the faster one, the film is the same. Turned upside down, the ball's stress
/// is that of the plane.
#[test]
fn the_sign_of_sliding_turns_the_traction() {
    for kind in [ContactKind::Line, ContactKind::Circular] {
        let [forward, backward] = [0.5, -0.5].map(|srr| solved(&case(kind, carreau(0.2), srr)));
        for (x, y) in films(&forward).into_iter().zip(films(&backward)) {
            assert_relative_eq!(x, y, max_relative = 1e-8);
        }
        assert!(pressure_difference(&forward, &backward) < 1e-8);
        let (f, b) = (&forward.traction, &backward.traction);
        assert!(f.coefficient.value > 0.01);
        for (x, y) in [
            (f.coefficient.value, -b.coefficient.value),
            (f.coefficient_body_2.value, -b.coefficient_body_1.value),
            (f.coefficient_body_1.value, -b.coefficient_body_2.value),
            (f.friction_power.value, b.friction_power.value),
        ] {
            assert_relative_eq!(x, y, max_relative = 1e-8);
        }
    }
}

/// ∫f dx along the centreline by the trapezoidal rule; f has the values at both ends of a piece, and its length.
fn integral(line: &Centreline, f: impl Fn(usize, f64) -> [f64; 2]) -> f64 {
    (1..line.x.len())
        .map(|i| {
            let dx = line.x[i] - line.x[i - 1];
            let slope = if dx > 0.0 {
                (line.pressure[i] - line.pressure[i - 1]) / dx
            } else {
                0.0
            };
            0.5 * dx * f(i, slope).iter().sum::<f64>()
        })
        .sum()
}

/// Without sliding nothing is dragged at mid-film, and momentum alone gives the stress of the walls,
/// ±(h/2) dp/dx, whatever the law.
#[test]
fn rolling_alone_has_the_traction_of_the_pressure_gradient() {
    for law in [carreau(0.2), eyring(2e6)] {
        let case = case(ContactKind::Line, law, 0.0);
        let solution = solved(&case);
        let t = &solution.traction;
        assert_eq!(t.coefficient.value, 0.0);
        near(
            t.coefficient_body_2.value,
            -t.coefficient_body_1.value,
            1e-12,
        );
        let line = &solution.centreline;
        let h = &line.film_thickness;
        let force = integral(line, |i, slope| [h[i - 1], h[i]].map(|h| 0.5 * h * slope));
        println!(
            "{:.5e} {:.5e}",
            t.coefficient_body_2.value,
            force / case.contact.load
        );
        // The profile's points are dense, and its slopes differences of second order. Behind the film the penalty leaves slopes of which streams have a share.
        near(t.coefficient_body_2.value, force / case.contact.load, 3e-3);
    }
}

/// Eyring's law has a closed form for the flow along a line: the mean of sinh over a linear stress is
/// sinh τ times sinh(x)/x, x = h p'/(2τ₀), and so
///
/// ```text
///   τ = τ₀ asinh[μΔu/(hτ₀) · x/sinh x]
/// ```
/// at mid-film. Integrated over the profiles as they are written, compared with the solver's traction; behind the film, the outflow fills a share of the gap.
#[test]
fn sliding_in_eyrings_fluid_has_the_traction_of_its_closed_form() {
    for (stress, srr) in [(2e6, 0.5), (5e6, 0.1), (5e6, 1.5)] {
        let case = case(ContactKind::Line, eyring(stress), srr);
        let solution = solved(&case);
        let sliding = case.motion.body_2_speed() - case.motion.body_1_speed();
        let line = &solution.centreline;
        let middle = line.x.iter().position(|x| *x >= 0.0).unwrap();
        let end = (middle..line.x.len()).find(|i| line.pressure[*i] <= 0.0);
        let force = integral(line, |i, slope| {
            [i - 1, i].map(|i| {
                let (h, mu) = (line.film_thickness[i], line.viscosity[i]);
                let filling = end
                    .filter(|end| i >= *end)
                    .map_or(1.0, |end| line.film_thickness[end] / h);
                let x = 0.5 * h * slope / stress;
                let flattened = if x.abs() < 1e-4 { 1.0 } else { x / x.sinh() };
                filling * stress * (mu * sliding / (h * stress) * flattened).asinh()
            })
        });
        let (ours, expected) = (
            solution.traction.coefficient.value,
            force / case.contact.load,
        );
        println!("tau_0 {stress:e}, SRR {srr}: {ours:.6} {expected:.6}");
        assert_relative_eq!(ours, expected, max_relative = 2e-3);
    }
}

/// The power of the surfaces becomes heat: power = F_2 u_2 − F_1 u_1.
///
/// The rest of the balance, −∫∇p·(ṁ/ρ) dA, vanishes: ∇p/ρ(p) is a gradient, ṁ is free of sources, and
/// the pressure is zero around the contact area. The remaining difference is the error of the mesh, which counts most where
/// nothing slides and all power goes into the pressure's work: lines take the finer one.
///
/// Theory: Traction and heat.
/// Habchi 2008, eq. 4.15.
#[test]
fn friction_power_equals_the_power_of_the_surfaces() {
    for (kind, law, srr) in [
        (ContactKind::Line, carreau(0.2), 0.3),
        (ContactKind::Line, carreau(0.2), 0.0),
        (ContactKind::Line, eyring(5e6), -0.8),
        (ContactKind::Circular, carreau(0.2), 0.1),
    ] {
        let mut case = case(kind, law, srr);
        if kind == ContactKind::Line {
            case.mesh = MeshParams::preset(MeshPreset::Normal, kind);
        }
        let t = solved(&case).traction;
        let power = case.contact.load
            * (t.coefficient_body_2.value * case.motion.body_2_speed()
                - t.coefficient_body_1.value * case.motion.body_1_speed());
        println!(
            "{kind:?}, SRR {srr}: {:.6e} {power:.6e}, sliding {:.6e}",
            t.friction_power.value,
            t.force.value * (case.motion.body_2_speed() - case.motion.body_1_speed())
        );
        assert_relative_eq!(t.friction_power.value, power, max_relative = 2e-3);
    }
}
