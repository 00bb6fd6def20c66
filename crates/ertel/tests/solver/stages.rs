//! Start and measurements of a stage.

use ertel::problem::problem;
use ertel::solve::evaluate::{central_film, minimum_film};
use ertel::solve::newton_level::NewtonStats;
use ertel::solve::sequence::Stage;
use ertel::solve::sequence::stage_run::{Finish, StageRun};
use ertel::solve::sequence::start::cold_start;
use ertel::solve::state::{FilmConstants, State};
use ertel::solve::system::System;

use super::{BALL, COARSE, ROLLING, ball, case, discretisation};

/// The dry contact with oil in it lacks the entrained flow and little else, in circles and along the longer axis of an ellipse ten
/// times as long as wide: 38 times the entrained flow with a stabilisation that has no regard for how long its cells are.
#[test]
fn cold_starts_lack_the_entrained_flow() {
    let slender =
        "kind = \"elliptical\"\nradius_x = \"730 mm\"\nradius_y = \"20 mm\"\nload = \"20 N\"";
    for contact in [BALL, slender] {
        let problem = problem(&case(contact, ROLLING, COARSE));
        let d = discretisation(&problem, &problem.plan.stages[0]);
        let run = StageRun::new(&problem, &problem.plan.stages[0], 0, &d);
        let (model, state) = (run.model(1.0), cold_start(&problem, &d));
        let system = System::assemble(&d, &model.fluid, &model.constants, &state, None);
        let residual = system.relative_residual();
        println!("{residual}");
        assert!((0.5..2.0).contains(&residual), "{residual}");
    }
}

/// Effect of the diffusion at a ridge on both films by the adjoints, against solves without it.
#[test]
fn the_effect_of_diffusion_at_a_ridge_is_reported() {
    let problem = ball();
    let mut stage = *problem.plan.stages.last().unwrap();
    let mut d = discretisation(&problem, &stage);
    d.at_ridge = vec![1.0; d.contact.n_elements()];
    stage.constants.ridge_diffusion = 0.02;
    let solve = |stage: &Stage, state: &mut State| {
        let (run, mut effort) = (
            StageRun::new(&problem, stage, 0, &d),
            NewtonStats::default(),
        );
        let end = run.solve(
            Finish::Exact,
            state,
            &mut effort,
            &mut ertel::engine::NoObserver,
        );
        end.unwrap();
        let reported = run.measure(state, &mut effort).unwrap().ridge;
        (
            [central_film(&d, state), minimum_film(&d, state).0],
            reported,
        )
    };
    let mut state = cold_start(&problem, &d);
    solve(&problem.plan.stages[0], &mut state);
    let (with, reported) = solve(&stage, &mut state);
    let plain = Stage {
        constants: FilmConstants {
            ridge_diffusion: 0.0,
            ..stage.constants
        },
        ..stage
    };
    let (without, nothing) = solve(&plain, &mut state);
    assert_eq!(nothing, [0.0; 2]);
    let found = [0, 1].map(|j: usize| with[j] / without[j] - 1.0);
    println!("{found:?} found, {reported:?} reported");
    // In h_min, elements cancel each other.
    let size = found[0].abs().max(found[1].abs());
    for (found, reported) in found.into_iter().zip(reported) {
        assert!(found.abs() > 1e-4 && (reported - found.abs()).abs() < 0.03 * size);
    }
}

/// A film below zero has errors as one above has: shares of negative sign would indicate nothing to refine.
#[test]
fn films_below_zero_have_errors() {
    let problem = ball();
    let stage = problem.plan.stages[0];
    let d = discretisation(&problem, &stage);
    let mut state = cold_start(&problem, &d);
    let (film, _) = minimum_film(&d, &state);
    state.rigid_separation -= 1.01 * film;
    assert!(minimum_film(&d, &state).0 < 0.0);
    let run = StageRun::new(&problem, &stage, 0, &d);
    let indicator = run.measure(&state, &mut NewtonStats::default()).unwrap();
    assert!(indicator.minimum.iter().all(|share| *share >= 0.0));
    assert!(indicator.totals()[1] > 0.0);
}
