//! What is tried when a contact does not converge at once.

use super::{Problem, Role, Stage};
use crate::solve::system::FilmConstants;

/// Shares of the fluid's thickening through which a contact is led that does not start otherwise.
const THICKENING: [f64; 5] = [0.4, 0.6, 0.75, 0.88, 1.0];

/// Order of pressures that overshoot little at a spike that the mesh does not resolve.
const LOWER_ORDER: usize = 2;

/// Diffusion between that of a start and none.
const DIFFUSION: [f64; 4] = [1.0, 0.25, 0.06, 0.015];

/// Steps from a diffusive start towards the stage `end`.
pub(super) fn diffusion_path(start: &Stage, end: &Stage) -> impl Iterator<Item = Stage> + use<> {
    let (start, end) = (*start, end.constants.isotropic_diffusion);
    let between = move |d: &f64| (end..start.constants.isotropic_diffusion).contains(d);
    DIFFUSION
        .into_iter()
        .filter(between)
        .map(move |isotropic_diffusion| Stage {
            constants: FilmConstants {
                isotropic_diffusion,
                ..start.constants
            },
            cold: false,
            role: Role::Path,
            ..start
        })
}

/// Between a stage and the one before on a way, if they differ enough.
pub(super) fn halfway(from: &Stage, to: &Stage) -> Option<Stage> {
    let diffusion = |s: &Stage| s.constants.isotropic_diffusion;
    let thickening = 0.5 * (from.thickening + to.thickening);
    let isotropic_diffusion = (diffusion(from) * diffusion(to)).sqrt();
    let near = to.thickening - thickening < 0.02 && isotropic_diffusion < 1.4 * diffusion(to);
    (to.role == Role::Path && !near).then_some(Stage {
        thickening,
        constants: FilmConstants {
            isotropic_diffusion,
            ..to.constants
        },
        ..*to
    })
}

/// A stage with pressures that overshoot less at a spike that the mesh does not resolve, unless its own are as low.
pub(super) fn of_lower_order(stage: &Stage) -> Option<Stage> {
    (stage.pressure_order > LOWER_ORDER).then_some(Stage {
        pressure_order: LOWER_ORDER,
        ..*stage
    })
}

/// What is tried, in turn, when the first start or the final stage does not converge:
///
/// - the way from the start to the case in steps of diminishing diffusion;
/// - a start with a fluid that thickens less, made thicker step by step;
/// - the start and then the second of these on a mesh of finer rim, where a film thinner than foreseen builds up its pressure (or, where
///   the mesh is not refined, on the case's own, finer than the first);
/// - pressures of lower order from the beginning.
///
/// If the start has failed (`started` is false), nothing is tried that follows from it.
pub(super) fn rescues(problem: &Problem, started: bool) -> Vec<Vec<Stage>> {
    let (Some(start), Some(last)) = (problem.stages.first(), problem.stages.last()) else {
        return Vec::new();
    };
    let mut path: Vec<Stage> = diffusion_path(start, last).collect();
    path.extend(&problem.stages[1..]);
    let thickening = |start: &Stage| -> Vec<Stage> {
        let steps = THICKENING.iter().enumerate().map(|(i, thickening)| Stage {
            thickening: *thickening,
            cold: i == 0,
            role: if i == 0 { Role::Start } else { Role::Path },
            ..*start
        });
        steps.collect()
    };
    let mut continuation = thickening(start);
    continuation.extend(&path);
    let sizes = match problem.adapt {
        Some(_) => last.sizes.with_finer_rim(),
        // The case's own, finer than those that it starts on.
        None => last.sizes,
    };
    let on_finer = |stage: &Stage| Stage { sizes, ..*stage };
    let mut restart = vec![on_finer(start)];
    restart.extend(diffusion_path(&restart[0], last));
    restart.push(on_finer(last));
    let mut finer_continuation = thickening(&restart[0]);
    finer_continuation.extend(&restart[1..]);
    let lower_orders = (1..last.pressure_order)
        .rev()
        .filter(|order| started || *order < start.pressure_order)
        .map(|pressure_order| {
            let lower = |stage: &Stage| Stage {
                pressure_order: stage.pressure_order.min(pressure_order),
                ..*stage
            };
            problem.stages.iter().map(lower).collect()
        });
    let mut rescues = Vec::new();
    rescues.extend(started.then_some(path));
    rescues.extend([continuation, restart, finer_continuation]);
    rescues.extend(lower_orders);
    rescues
}
