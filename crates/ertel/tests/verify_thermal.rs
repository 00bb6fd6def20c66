//! Whole thermal contacts: limits in which the answer is known, symmetries, and heat that is neither lost nor made.

use crate::common;

use approx::assert_relative_eq;
use common::{heated, near, solved};
use ertel::case::Case;
use ertel::contact::ContactKind;
use ertel::params::Method;
use ertel_rheology::ConductivityLaw;

fn case(kind: ContactKind, slide_to_roll_ratio: f64) -> Case {
    let load = if kind == ContactKind::Line { 8e4 } else { 30.0 };
    let mut case = heated(common::case(kind, load));
    case.motion.slide_to_roll_ratio = slide_to_roll_ratio;
    case.mesh.target_error = Some(0.01);
    case
}

/// Where heat flows off without resistance nothing warms up: film and traction are those of the isothermal contact.
/// The remaining rise, 1e-7 K and less, has no effect; the tolerance is that of the coupling.
#[test]
fn perfect_conductors_are_isothermal() {
    let mut heated = case(ContactKind::Line, 0.4);
    heated.lubricant.thermal_conductivity = Some(ConductivityLaw::constant(1e4).unwrap());
    for body in [&mut heated.body_1, &mut heated.body_2] {
        body.thermal_conductivity = Some(ConductivityLaw::constant(1e7).unwrap());
    }
    // The same method and contact area for both.
    heated.solver.method = Some(Method::FiniteElements);
    (heated.mesh.inlet, heated.mesh.outlet) = (Some(-6.0), Some(2.0));
    let mut isothermal = heated.clone();
    isothermal.solver.isothermal = true;
    let (thermal, isothermal) = (solved(&heated), solved(&isothermal));
    for (thermal, isothermal) in [
        (
            thermal.summary.film_central.value,
            isothermal.summary.film_central.value,
        ),
        (
            thermal.summary.film_minimum.value,
            isothermal.summary.film_minimum.value,
        ),
        (
            thermal.summary.pressure_maximum.value,
            isothermal.summary.pressure_maximum.value,
        ),
        (
            thermal.traction.coefficient.value,
            isothermal.traction.coefficient.value,
        ),
        (
            thermal.traction.friction_power.value,
            isothermal.traction.friction_power.value,
        ),
    ] {
        assert_relative_eq!(thermal, isothermal, max_relative = 2e-5);
    }
}

/// Bodies of one material, rolling: what happens at one wall happens at the other, and no stress is left at mid-film.
/// Sliding the other way round changes nothing but the sign of the traction, and which body is hotter.
#[test]
fn bodies_of_one_material() {
    let with = |slide| {
        let mut case = case(ContactKind::Line, slide);
        case.body_1 = case.body_2.clone();
        solved(&case)
    };
    let rolling = with(0.0);
    assert!(
        rolling.traction.coefficient.value.abs()
            < 1e-6 * rolling.traction.coefficient_body_1.value.abs()
    );
    let (one, other) = (with(0.5), with(-0.5));
    near(
        one.traction.coefficient.value,
        -other.traction.coefficient.value,
        1e-4,
    );
    near(
        one.summary.film_minimum.value,
        other.summary.film_minimum.value,
        1e-5,
    );
}

/// All heat that is made is carried off, on a fine mesh to 2e-4. Without the flow across the film 2 % are missing in
/// contacts like these.
#[test]
fn heat_is_balanced() {
    let error = |kind, target: f64| {
        let mut case = case(kind, 0.5);
        case.motion.entrainment_speed = 2.0;
        case.mesh.target_error = Some(target);
        let thermal = solved(&case).thermal.expect("a thermal contact");
        let balance = thermal.balance;
        println!("{kind:?} {target}: {balance:?}");
        assert!(
            balance.by_film.value > 0.01 * balance.shear.value,
            "{balance:?}"
        );
        balance.error.abs()
    };
    let (coarse, fine) = (
        error(ContactKind::Line, 0.02),
        error(ContactKind::Line, 2e-4),
    );
    assert!(coarse < 0.01 && fine < 2e-4, "{coarse} {fine}");
    let circular = error(ContactKind::Circular, 0.02);
    assert!(circular < 0.01, "{circular}");
}
