//! Solutions of whole cases: common properties from theory.

use crate::common;

use approx::assert_relative_eq;
use common::solved;
use ertel::case::Case;
use ertel::contact::{Contact, ContactKind, reduced_modulus};
use ertel::params::ElasticModel;
use ertel_rheology::{DensityLaw, ViscosityLaw};

/// Circular contacts on a mesh that is cheap rather than accurate: the statements below hold on any.
fn cheap(case: &mut Case) {
    if case.contact.kind == ContactKind::Circular {
        case.mesh.hertz_size = 0.3;
        case.mesh.constriction_size = 0.15;
        case.mesh.edge_size = 0.8;
        case.mesh.depth_growth = 0.9;
        case.mesh.pressure_order = 2;
    }
    case.solver.error_estimate = false;
}

/// Glass on steel, each body for itself and as one equivalent body (Habchi 2008, appendix A).
///
/// On a half-space both deflect equally, everywhere in the body, for any pressure; the finite body
/// shifts the surface as a whole, which H0 takes up, and discretisation errors of the elastic
/// problem depend on Poisson's ratio: 1e-4 of the film leaves room for both. A wrong equivalent
/// ratio of 0.3 instead of 0.23 changes the film by per cents.
#[test]
fn equivalent_body_replaces_two_bodies() {
    for (kind, load) in [(ContactKind::Line, 3e5), (ContactKind::Circular, 50.0)] {
        let mut case = common::case(kind, load);
        case.body_1.elasticity = common::GLASS;
        cheap(&mut case);
        let [one, two] = [ElasticModel::Equivalent, ElasticModel::TwoBodies].map(|e| {
            case.solver.elasticity = Some(e);
            solved(&case).summary
        });
        for (a, b, tolerance) in [
            (one.film_central.value, two.film_central.value, 1e-4),
            (one.film_minimum.value, two.film_minimum.value, 1e-4),
            // The coarse circular mesh leaves the pressure rough.
            (one.pressure_maximum.value, two.pressure_maximum.value, 1e-3),
        ] {
            println!("{kind:?}: {:.1e}", a / b - 1.0);
            assert_relative_eq!(a, b, max_relative = tolerance);
        }
    }
}

/// Two contacts of unlike size, stiffness, speed and oil that share M, L and ν.
///
/// With constant density and Barus's law the dimensionless equations depend on M and L alone (λ and
/// α p_h follow from them), so the films in a²/R, and h/(R √(2U)) with them, are the same number.
///
/// Habchi 2008, eq. 2.28.
#[test]
fn similar_contacts_have_similar_films() {
    let (m, l) = (30.0, 3.0);
    for kind in [ContactKind::Line, ContactKind::Circular] {
        let similar = |radius: f64, modulus: f64, viscosity: f64, speed: f64, density: f64| {
            let mut case = common::case(kind, 1.0);
            for body in [&mut case.body_1, &mut case.body_2] {
                body.elasticity.youngs_modulus = modulus;
            }
            let reduced = reduced_modulus(case.body_1.elasticity, case.body_2.elasticity);
            let u = 2.0 * viscosity * speed / (reduced * radius);
            let load = match kind {
                ContactKind::Line => m * reduced * radius * u.sqrt(),
                _ => m * reduced * radius * radius * u.powf(0.75),
            };
            case.contact = Contact::of_one_radius(kind, radius, load);
            case.motion.entrainment_speed = speed;
            case.lubricant.density = DensityLaw::constant(density).unwrap();
            let alpha = l / (u.powf(0.25) * reduced);
            case.lubricant.viscosity = ViscosityLaw::barus(viscosity, alpha).unwrap();
            cheap(&mut case);
            // Cells of half-spaces are halved or not by the last digit of the predicted film.
            case.solver.elasticity = Some(ElasticModel::Equivalent);
            let s = solved(&case);
            let film = |h: f64| h / (radius * u.sqrt());
            [
                film(s.summary.film_central.value),
                film(s.summary.film_minimum.value),
                s.summary.pressure_maximum.value / s.hertz.pressure,
                s.groups.moes_load / m,
                s.groups.moes_material / l,
            ]
        };
        let a = similar(0.016, 210e9, 0.04, 0.8, 870.0);
        let b = similar(0.005, 70e9, 0.9, 0.1, 1200.0);
        println!("{kind:?}: {a:?} {b:?}");
        assert_relative_eq!(a[3], 1.0, max_relative = 1e-12);
        assert_relative_eq!(a[4], 1.0, max_relative = 1e-12);
        for (a, b) in a.iter().zip(&b) {
            // Newton's tolerance of 1e-8 p_h, met quadratically
            assert_relative_eq!(a, b, max_relative = 1e-9);
        }
    }
}

/// An isothermal Newtonian film depends on the mean speed only (Habchi 2008, eq. 2.29).
#[test]
fn sliding_changes_neither_film_nor_pressure() {
    let mut case = common::case(ContactKind::Line, 3e5);
    let rolling = solved(&case);
    case.motion.slide_to_roll_ratio = 1.5;
    let sliding = solved(&case);
    assert_eq!(rolling.summary, sliding.summary);
    assert_eq!(rolling.surface.pressure, sliding.surface.pressure);
    assert_eq!(
        rolling.surface.film_thickness,
        sliding.surface.film_thickness
    );
    assert_eq!(rolling.traction.coefficient.value, 0.0);
    assert!(sliding.traction.coefficient.value > 0.0);
    // The mean speed itself does matter: thicker with speed.
    case.motion.entrainment_speed *= 2.0;
    assert!(solved(&case).summary.film_central.value > 1.3 * sliding.summary.film_central.value);
}
