//! The transitions of the driver, with a scripted solver.

mod scripted;

use super::*;
use crate::solve::sequence::paths::tests::outline;
use scripted::{COARSE, Ending, Point, Scripted, Trace, level_of, run};

use Ending::{Diverged, Interrupted, Solved, Stalled};

fn diffusions(trace: &Trace) -> Vec<f64> {
    let stages = trace.iter();
    stages
        .map(|(s, _)| s.constants.isotropic_diffusion)
        .collect()
}

#[test]
fn each_stage_starts_from_the_one_before() {
    let (end, trace) = run(outline(3), |_, _| Solved);
    assert_eq!(end.unwrap().stage, trace[1].0);
    assert_eq!(trace.len(), 2);
    assert_eq!(trace[0].1, None);
    assert_eq!(trace[1].1, Some(trace[0].0));
}

#[test]
fn a_failed_start_is_replaced_by_one_of_a_thinner_fluid() {
    for ending in [Stalled, Diverged] {
        let (end, trace) = run(outline(3), |n, _| if n == 0 { ending } else { Solved });
        assert_eq!(end.unwrap().stage.role, Role::Final);
        assert!(trace[1].0.cold && trace[1].0.viscosity_exponent < 0.5);
        assert!(trace[2].0.viscosity_exponent > trace[1].0.viscosity_exponent);
    }
}

#[test]
fn a_failed_solution_is_led_up_to_by_diminishing_diffusion() {
    let (end, trace) = run(outline(3), |n, _| if n == 1 { Diverged } else { Solved });
    assert_eq!(end.unwrap().stage.role, Role::Final);
    assert_eq!(diffusions(&trace), [2.0, 0.0, 1.0, 0.25, 0.06, 0.015, 0.0]);
    // A failed stage is no start.
    assert_eq!(trace[2].1, Some(trace[0].0));
}

#[test]
fn a_step_that_is_too_long_is_halved() {
    let (end, trace) = run(outline(3), |n, _| match n {
        1 | 4 => Diverged,
        _ => Solved,
    });
    assert!(end.is_ok());
    let expected = [
        2.0,
        0.0,
        1.0,
        0.25,
        0.06,
        (0.25_f64 * 0.06).sqrt(),
        0.06,
        0.015,
        0.0,
    ];
    assert_eq!(diffusions(&trace), expected);
}

/// Six times in one continuation; then it continues from a nearly converged state.
#[test]
fn halving_has_an_end() {
    let (_, trace) = run(outline(2), |n, stage| match n {
        0 => Solved,
        _ if stage.role == Role::Path => Stalled,
        _ => Diverged,
    });
    let first = trace[2..].iter().take_while(|(s, _)| s.role == Role::Path);
    let first: Vec<f64> = first
        .map(|(s, _)| s.constants.isotropic_diffusion)
        .collect();
    // The four steps, and twice six: the half step, and the step again.
    assert_eq!(first.len(), 4 + 2 * 6);
    assert_eq!(first[first.len() - 1], 0.015);
}

#[test]
fn the_first_failure_is_reported_when_all_strategies_fail() {
    let (end, trace) = run(outline(3), |n, _| if n == 0 { Solved } else { Diverged });
    assert_eq!(level_of(&end.unwrap_err()), 1);
    let finest = trace.iter().map(|(s, _)| s.sizes.rim);
    assert_eq!(finest.fold(1.0, f64::min), 0.05, "to the last");
    let (end, _) = run(outline(3), |_, _| Diverged);
    assert_eq!(level_of(&end.unwrap_err()), 0);
}

#[test]
fn comparisons_may_fail() {
    for role in [Role::Estimate, Role::Comparison, Role::Isothermal] {
        let mut outline = outline(3);
        let compared = Stage {
            role,
            ..*outline.last()
        };
        outline.usual.insert(1, compared);
        let (end, trace) = run(outline, |n, _| if n == 1 { Diverged } else { Solved });
        assert!(end.is_ok());
        assert_eq!(trace.len(), 3);
        assert_eq!(trace[2].1, Some(trace[0].0));
    }
}

#[test]
fn meshes_are_refined_until_errors_are_small() {
    let (end, trace) = run(outline(3), |n, _| if n == 1 { COARSE } else { Solved });
    assert_eq!(end.unwrap().stage.refinements, 1);
    assert_eq!(trace.len(), 3);
}

/// In steps of diminishing diffusion on the same mesh, from the solution on the mesh before.
#[test]
fn a_failed_refined_mesh_is_retried() {
    let (end, trace) = run(outline(3), |n, _| match n {
        1 => COARSE,
        2 => Diverged,
        _ => Solved,
    });
    assert_eq!(end.unwrap().stage.refinements, 1);
    assert_eq!(
        diffusions(&trace)[2..],
        [0.0, 2.0, 1.0, 0.25, 0.06, 0.015, 0.0]
    );
    assert!(
        trace[2..]
            .iter()
            .all(|(s, _)| s.refinements == 1 && !s.cold)
    );
    assert_eq!(trace[3].1, Some(trace[1].0));
}

/// It was only measured, and is brought to the end.
#[test]
fn the_previous_mesh_is_kept_where_the_refined_one_fails_again() {
    for (fails, stages) in [(3, 4), (5, 6), (8, 9)] {
        let (end, trace) = run(outline(3), |n, _| match n {
            1 => COARSE,
            2 => Diverged,
            n if n == fails => Diverged,
            _ => Solved,
        });
        let end = end.unwrap();
        assert_eq!((end.stage, end.finished), (trace[1].0, true));
        assert_eq!(trace.len(), stages);
    }
}

#[test]
fn a_mesh_for_the_pressure_alone_is_tried_once() {
    let (end, trace) = run(outline(3), |n, _| match n {
        1 => Ending::Inaccurate {
            aim: RefinementTarget::Pressure,
        },
        2 => Diverged,
        _ => Solved,
    });
    assert_eq!(end.unwrap().stage.refinements, 0);
    assert_eq!(trace.len(), 3);
}

/// Where a contact has it: the same stage with diffusion at ridges of the pressure, which all later ones keep; a refined mesh that fails with it is given up.
#[test]
fn failures_are_retried_with_a_diffused_ridge() {
    let diffused = |trace: &Trace| -> Vec<(Role, f64)> {
        let stages = trace.iter();
        stages
            .map(|(s, _)| (s.role, s.constants.ridge_diffusion))
            .collect()
    };
    let outline = || Outline {
        ridge_diffusion: 1.0,
        ..outline(3)
    };
    let (end, trace) = run(outline(), |n, _| match n {
        1 => Diverged,
        2 => COARSE,
        _ => Solved,
    });
    assert_eq!(end.unwrap().stage.refinements, 1);
    let (start, solution) = (Role::Start, Role::Final);
    let expected = [
        (start, 0.0),
        (solution, 0.0),
        (solution, 1.0),
        (solution, 1.0),
    ];
    assert_eq!(diffused(&trace), expected);
    assert_eq!(trace[2].1, Some(trace[0].0));

    let (end, trace) = run(outline(), |n, _| match n {
        1 => COARSE,
        2..=4 => Diverged,
        _ => Solved,
    });
    let end = end.unwrap();
    assert_eq!((end.stage, end.finished), (trace[1].0, true));
    let expected = [
        (start, 0.0),
        (solution, 0.0),
        (solution, 0.0),
        (solution, 1.0),
        (solution, 1.0),
    ];
    assert_eq!(diffused(&trace), expected);
    let orders: Vec<usize> = trace.iter().map(|(s, _)| s.pressure_order).collect();
    assert_eq!(orders[1..], [3, 3, 3, 2]);
}

/// On a refined mesh where cubic pressures fail with a diffused ridge, too; those that follow are quadratic, and cubic ones are not tried again.
#[test]
fn refined_meshes_continue_with_quadratic_pressures() {
    let outline = Outline {
        ridge_diffusion: 1.0,
        ..outline(3)
    };
    let (end, trace) = run(outline, |n, stage| match n {
        1 => COARSE,
        4 => COARSE,
        _ if stage.refinements > 0 && stage.pressure_order == 3 => Diverged,
        _ => Solved,
    });
    let end = end.unwrap().stage;
    assert_eq!((end.refinements, end.pressure_order), (2, 2));
    assert_eq!(trace.len(), 6);
}

/// The ridge is what such a mesh is for.
#[test]
fn a_mesh_for_the_pressure_has_a_diffused_ridge() {
    let outline = Outline {
        ridge_diffusion: 1.0,
        ..outline(3)
    };
    for aim in [RefinementTarget::Pressure, RefinementTarget::Both] {
        let (_, trace) = run(outline.clone(), |n, _| match n {
            1 => Ending::Inaccurate { aim },
            _ => Solved,
        });
        assert_eq!(trace[2].0.constants.ridge_diffusion, 1.0);
        assert!(trace[2].0.given_up_early);
    }
}

/// Quadratic pressures where a continuation ends short of cubic ones.
#[test]
fn the_order_is_lowered() {
    let (end, trace) = run(outline(3), |_, stage| {
        match stage.role == Role::Final && stage.pressure_order == 3 {
            true => Diverged,
            false => Solved,
        }
    });
    let orders: Vec<usize> = trace[6..].iter().map(|(s, _)| s.pressure_order).collect();
    assert_eq!(orders, [3, 2]);
    assert_eq!(end.unwrap().stage.pressure_order, 2);
}

#[test]
fn an_interruption_ends_all() {
    for number in 0..3 {
        let (end, trace) = run(outline(3), |n, _| match n {
            n if n == number => Interrupted,
            1 => Diverged,
            _ => Solved,
        });
        assert!(matches!(end, Err(SolveError::Interrupted)));
        assert_eq!(trace.len(), number + 1);
    }
}

struct Cancelled;

impl Observer for Cancelled {
    fn cancelled(&self) -> bool {
        true
    }
}

#[test]
fn nothing_starts_after_a_cancellation() {
    let mut trace = Vec::new();
    let solver = Scripted {
        rule: |_, _: &Stage| Solved,
        trace: &mut trace,
    };
    let end = Driver::new(outline(3), solver, &mut Cancelled).run();
    assert!(matches!(end, Err(SolveError::Interrupted)));
    assert!(trace.is_empty());
}

/// One stage from a given solution, refined further; there are no fallbacks, for a cold start is the caller's.
#[test]
fn a_warm_start_succeeds_or_fails_at_once() {
    let warm = |script: [Ending; 3]| {
        let (outline, mut trace) = (outline(3), Vec::new());
        let stage = Stage {
            refinements: 2,
            ..*outline.last()
        };
        let from = Point {
            stage,
            ending: Solved,
            finished: true,
        };
        let solver = Scripted {
            rule: |n: usize, _: &Stage| script[n],
            trace: &mut trace,
        };
        let observer = &mut crate::engine::NoObserver;
        let mut driver = Driver::new(outline, solver, observer);
        driver.halvings = vec![1];
        let end = driver.run_from(from, stage);
        (end.map(|(point, _)| point.stage.refinements), trace.len())
    };
    let (end, n) = warm([Solved; 3]);
    assert_eq!((end.unwrap(), n), (2, 1));
    let (end, n) = warm([COARSE, Solved, Solved]);
    assert_eq!((end.unwrap(), n), (3, 2));
    let (end, n) = warm([Diverged, Solved, Solved]);
    assert_eq!((level_of(&end.unwrap_err()), n), (0, 1));
}
