use super::parameter::halfway;
use super::*;
use crate::contact::Planar;
use crate::params::{Formulation, PenaltyScaling};
use crate::solution::Role;
use crate::solve::discretisation::LevelSizes;
use crate::solve::state::FilmConstants;
use crate::solve::tuning::continuation::SOFTNESS;

/// Start and solution of an isothermal contact in a Newtonian fluid, with pressures of some order.
pub(in super::super) fn outline(order: usize) -> Outline {
    let solution = Stage {
        sizes: LevelSizes {
            hertz: 0.2,
            constriction: 0.1,
            rim: 0.1,
            outlet_rim: 0.1,
            rim_width: 0.2,
            edge: 0.5,
            growth: 0.3,
            depth_growth: 0.3,
        },
        refinements: 0,
        pressure_order: order,
        constants: FilmConstants {
            lambda: 1.0,
            entrainment: Planar::along_x(1.0),
            formulation: Formulation::Gls,
            isotropic_diffusion: 0.0,
            ridge_diffusion: 0.0,
            elastic_stabilisation: true,
            penalty: 1.0,
            penalty_scaling: PenaltyScaling::default(),
            film_scale: 0.1,
            far_outlet: false,
        },
        viscosity_exponent: 1.0,
        softness: 1.0,
        sliding: 1.0,
        newtonian: false,
        heated: false,
        cold: false,
        undamped: false,
        given_up_early: false,
        role: Role::Final,
    };
    let start = Stage {
        pressure_order: order.min(2),
        constants: FilmConstants {
            isotropic_diffusion: 2.0,
            ridge_diffusion: 0.0,
            ..solution.constants
        },
        cold: true,
        role: Role::Start,
        ..solution
    };
    Outline {
        usual: vec![start, solution],
        exponential: false,
        roller: false,
        ridge_diffusion: 0.0,
        slides: false,
        refined: true,
    }
}

/// The same, for each kind of contact that paths distinguish.
fn outlines() -> Vec<Outline> {
    let mut outlines = Vec::new();
    for (exponential, heated, slides, refined) in [
        (false, false, false, true),
        (false, true, true, false),
        (false, true, false, true),
        (true, false, true, true),
        (true, true, true, true),
        (true, true, false, false),
    ] {
        let mut outline = Outline {
            exponential,
            slides,
            refined,
            ..outline(3)
        };
        outline.usual[0].newtonian = exponential;
        outline.usual[1].heated = heated;
        outline.usual[1].given_up_early = exponential;
        outlines.push(outline);
    }
    let mut roller = outline(3);
    roller.roller = true;
    for stage in &mut roller.usual {
        stage.constants.film_scale = 0.005;
    }
    outlines.push(roller);
    outlines
}

fn names(outline: &Outline) -> Vec<&'static str> {
    paths(outline).iter().map(|f| f.name).collect()
}

/// The order in which they are tried, as docs/theory/isothermal-contact.md has it.
#[test]
fn paths_keep_their_order() {
    let outlines = outlines();
    let others = [
        "viscosity exponent",
        "finer rim",
        "finer rim and viscosity exponent",
    ];
    let first: [&[&str]; 7] = [
        &["diffusion"],
        &["sliding", "diffusion"],
        &["diffusion"],
        &["shear law"],
        &[
            "shear law, sliding, then the rest of the shear law",
            "shear law",
        ],
        &["shear law"],
        &["speed", "diffusion"],
    ];
    for (outline, first) in outlines.iter().zip(first) {
        assert_eq!(names(outline), [first, &others].concat());
    }
}

/// Each ends with the case itself, with the full iteration budget or in quadratic pressures; paths that do not continue from the usual start have
/// their own.
#[test]
fn paths_lead_to_the_case() {
    for outline in outlines() {
        for Path {
            name,
            needs_start,
            stages,
        } in paths(&outline)
        {
            let (first, last) = (&stages[0], &stages[stages.len() - 1]);
            assert!(needs_start || first.cold, "{name}");
            assert_eq!(last.role, Role::Final, "{name}");
            for parameter in Parameter::ALL {
                assert_eq!(
                    parameter.of(last),
                    parameter.of(outline.last()),
                    "{name}: {parameter:?}"
                );
            }
            assert_eq!(last.heated, outline.last().heated, "{name}");
            assert_eq!(last.constants, outline.last().constants, "{name}");
            assert!(!last.newtonian && !last.cold, "{name}");
            assert!(stages[1..].iter().all(|stage| !stage.cold), "{name}");
        }
    }
}

/// No step of a continuation changes two quantities at a time, but for the heat that comes with sliding and the fluid that a softened
/// one takes the place of.
#[test]
fn steps_change_one_quantity() {
    for outline in outlines() {
        for Path { name, stages, .. } in paths(&outline) {
            for pair in stages.windows(2) {
                let (from, to) = (&pair[0], &pair[1]);
                let changes = [
                    from.viscosity_exponent != to.viscosity_exponent,
                    from.softness != to.softness && from.newtonian == to.newtonian,
                    from.sliding != to.sliding && from.role == to.role,
                    from.constants != to.constants,
                ];
                let n = changes.iter().filter(|changed| **changed).count();
                assert!(n <= 1, "{name}: {from:?} {to:?}");
            }
        }
    }
}

/// A film of 0.005 b²/R is led down from 32 times the speed, one of 0.1 from twice the speed, thicker ones not at all.
#[test]
fn speeds_fall_to_that_of_the_case() {
    let speeds = |film_scale| {
        let mut outline = outline(3);
        outline.usual[0].constants.film_scale = film_scale;
        outline.roller = true;
        let speed = paths(&outline)
            .into_iter()
            .find(|path| path.name == "speed");
        let stages = speed.map_or_else(Vec::new, |path| path.stages);
        let lambdas: Vec<f64> = stages.iter().map(|s| s.constants.lambda).collect();
        lambdas
    };
    assert_eq!(speeds(0.005), [32.0, 32.0, 16.0, 8.0, 4.0, 2.0, 1.0]);
    assert_eq!(speeds(0.1), [2.0, 2.0, 1.0]);
    assert!(speeds(0.15).is_empty());
}

#[test]
fn parameters_grow_steadily_to_those_of_the_case() {
    for pair in SOFTNESS.windows(2) {
        let ratio = pair[0] / pair[1];
        assert!(ratio > 1.0 && ratio < 4.0, "{pair:?}");
    }
    assert_eq!(SOFTNESS[SOFTNESS.len() - 1], 1.0);
    assert!(SLIDING.windows(2).all(|pair| pair[0] < pair[1]));
    assert_eq!(SLIDING[SLIDING.len() - 1], 1.0);
}

/// Halves lie between, and end where steps are short.
#[test]
fn halves_converge_to_the_step() {
    let start = *outline(3).start();
    let step = Stage {
        role: Role::Path,
        constants: outline(3).last().constants,
        ..start
    };
    let to = |viscosity_exponent, softness, sliding, isotropic_diffusion| Stage {
        viscosity_exponent,
        softness,
        sliding,
        constants: FilmConstants {
            isotropic_diffusion,
            ..step.constants
        },
        ..step
    };
    let goal = to(1.0, 1.0, 1.0, 0.015);
    for from in [
        to(0.4, 1.0, 1.0, 0.015),
        to(1.0, 750.0, 1.0, 0.015),
        to(1.0, 1.0, 0.03, 0.015),
        to(1.0, 1.0, 1.0, 2.0),
    ] {
        let (mut from, mut n) = (from, 0);
        while let Some(half) = halfway(&from, &goal) {
            assert!(half != from && half != goal);
            (from, n) = (half, n + 1);
        }
        assert!((2..12).contains(&n), "{n}");
    }
    let solution = Stage {
        role: Role::Final,
        ..goal
    };
    assert_eq!(halfway(&start, &solution), None);
}
