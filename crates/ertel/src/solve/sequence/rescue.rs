//! What is tried when a contact does not converge at once.

use super::{Problem, Role, Stage};
use crate::solve::system::FilmConstants;

/// Shares of the fluid's thickening through which a contact is led that does not start otherwise.
const THICKENING: [f64; 5] = [0.4, 0.6, 0.75, 0.88, 1.0];

/// Number of rescues that follow from the start, and with it fail.
pub(super) const FROM_START: usize = 2;

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

/// What is tried, in turn, when the start or the final stage does not converge: the way from the start to
/// the case in steps of diminishing diffusion, if the start converged, and from its end
/// to pressures of lower order, which overshoot less at a spike that the mesh does not resolve (those of the case once more if it has no higher ones); a start with a fluid that
/// thickens less, made thicker step by step; then the start on the fine mesh, which may carry what the
/// coarse one could not; then pressures of lower order from the beginning.
pub(super) fn rescues(problem: &Problem) -> Vec<Vec<Stage>> {
    let (Some(start), Some(last)) = (problem.stages.first(), problem.stages.last()) else {
        return Vec::new();
    };
    // A mesh that only starts refinements may be too coarse for the film.
    let finer = match problem.adapt {
        Some(_) => last.sizes.scaled(0.5),
        None => last.sizes,
    };
    let mut continuation: Vec<Stage> = THICKENING
        .iter()
        .enumerate()
        .map(|(i, thickening)| Stage {
            thickening: *thickening,
            cold: i == 0,
            role: if i == 0 { Role::Start } else { Role::Path },
            ..*start
        })
        .collect();
    let mut path: Vec<Stage> = diffusion_path(start, last).collect();
    path.extend(&problem.stages[1..]);
    continuation.extend(&path);
    let on_finer = |stage: &Stage| Stage {
        sizes: finer,
        ..*stage
    };
    let mut restart = vec![on_finer(start)];
    restart.extend(diffusion_path(&restart[0], last));
    restart.push(on_finer(last));
    let lower = Stage {
        pressure_order: last.pressure_order.min(LOWER_ORDER),
        ..*last
    };
    let mut rescues = vec![path, vec![lower], continuation, restart];
    rescues.extend((1..last.pressure_order).rev().map(|pressure_order| {
        let lower = |stage: &Stage| Stage {
            pressure_order,
            ..*stage
        };
        problem.stages.iter().map(lower).collect()
    }));
    rescues
}
