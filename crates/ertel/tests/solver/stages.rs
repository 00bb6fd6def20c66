//! Start of a stage.

use ertel::problem::problem;
use ertel::solve::sequence::stage_run::StageRun;
use ertel::solve::sequence::start::cold_start;
use ertel::solve::system::System;

use super::{BALL, COARSE, ROLLING, case, discretisation};

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
