//! What is tried when a contact does not converge at once.

use super::{Problem, Stage};

/// Shares of the fluid's thickening through which a contact is led that does not start otherwise.
const THICKENING: [f64; 5] = [0.4, 0.6, 0.75, 0.88, 1.0];

/// What is tried, in turn, when the start or the final stage does not converge: a start with a fluid that
/// thickens less, made thicker step by step; then the start on the fine mesh, which may carry what the
/// coarse one could not; then pressures of lower order, which overshoot
/// less at a spike that the mesh does not resolve.
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
            ..*start
        })
        .collect();
    continuation.extend(&problem.stages[1..]);
    let restart = vec![
        Stage {
            sizes: finer,
            ..*start
        },
        Stage {
            sizes: finer,
            ..*last
        },
    ];
    let mut rescues = vec![continuation, restart];
    rescues.extend((1..last.pressure_order).rev().map(|pressure_order| {
        let lower = |stage: &Stage| Stage {
            pressure_order,
            ..*stage
        };
        problem.stages.iter().map(lower).collect()
    }));
    rescues
}
