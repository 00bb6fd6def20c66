//! What is tried when a contact does not converge at once.

use super::paths::{MEDIUM_SOFTNESS, diffusion_path, hardening_path, sliding_path};
use super::{Problem, Role, Stage};

/// Shares of the fluid's thickening through which a contact is led that does not start otherwise.
const THICKENING: [f64; 5] = [0.4, 0.6, 0.75, 0.88, 1.0];

/// Order of pressures that overshoot little at a spike that the mesh does not resolve.
const LOWER_ORDER: usize = 2;

/// A stage with pressures that overshoot less at a spike that the mesh does not resolve, unless its own are as low.
pub(super) fn of_lower_order(stage: &Stage) -> Option<Stage> {
    (stage.pressure_order > LOWER_ORDER).then_some(Stage {
        pressure_order: LOWER_ORDER,
        impatient: false,
        ..*stage
    })
}

/// What is tried, in turn, when the first start or the final stage does not converge:
///
/// - with heat: the way through sliding;
/// - with a limiting stress, or in Eyring's fluid: the way through softer laws, with little sliding and then more where there is
///   heat, and with the sliding of the case;
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
    // What was given up early is tried in earnest.
    let stages: Vec<Stage> = (problem.stages.iter())
        .map(|stage| Stage {
            impatient: false,
            ..*stage
        })
        .collect();
    let mut path: Vec<Stage> = diffusion_path(start, last).collect();
    path.extend(&stages[1..]);
    let exponential = exponential_ways(problem, &stages);
    let sliding = match exponential.is_empty() {
        true => sliding_way(problem, start, &stages),
        false => Vec::new(),
    };
    if let Some(way) = exponential.last() {
        path.clone_from(way);
    }
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
    match exponential.last() {
        Some(way) => restart.extend(way.iter().map(on_finer)),
        None => {
            restart.extend(diffusion_path(&restart[0], last));
            restart.extend(stages.last().map(on_finer));
        }
    }
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
            match exponential.last() {
                Some(way) => stages[..1].iter().chain(way).map(lower).collect(),
                None => stages.iter().map(lower).collect(),
            }
        });
    let mut rescues = Vec::new();
    if started {
        rescues.extend(Some(sliding).filter(|way| !way.is_empty()));
        rescues.extend(exponential.iter().map(|way| [&[*start], &way[..]].concat()));
        rescues.extend(exponential.is_empty().then_some(path));
    }
    rescues.extend([continuation, restart, finer_continuation]);
    rescues.extend(lower_orders);
    rescues
}

/// Through sliding to a heated contact, on the mesh of the start.
fn sliding_way(problem: &Problem, start: &Stage, stages: &[Stage]) -> Vec<Stage> {
    let Some(heated) = stages.iter().find(|stage| stage.heated) else {
        return Vec::new();
    };
    // Where an exponential would punish the overshoots of pressures, in those of the start, and with its diffusion.
    let first = match problem.fluid.is_exponential() {
        true => Stage {
            heated: true,
            newtonian: false,
            ..*start
        },
        false => Stage {
            sizes: start.sizes,
            pressure_order: start.pressure_order.min(heated.pressure_order),
            ..*heated
        },
    };
    let mut way = sliding_path(problem, &first);
    // Without heat first: what was reached so far slides more.
    if let Some(slow) = way.first().copied() {
        let unheated = Stage {
            heated: false,
            ..slow
        };
        way.insert(0, unheated);
    }
    if let Some(sliding) = way.last().copied() {
        way.extend(diffusion_path(&sliding, heated));
    }
    if !way.is_empty() {
        let heated = stages.iter().filter(|stage| stage.heated);
        way.extend(heated.map(|stage| goal(problem, stage)));
    }
    way
}

/// A stage at the end of a way: that of an exponential fluid is given up early, because quadratic pressures, which overshoot less,
/// stand in for those of higher order.
fn goal(problem: &Problem, stage: &Stage) -> Stage {
    Stage {
        impatient: problem.fluid.is_exponential() && of_lower_order(stage).is_some(),
        ..*stage
    }
}

/// From a Newtonian start to a fluid whose shear rate grows exponentially with the stress: the sliding of the case after the
/// fluid of the case, where there is heat, and before it. Nothing for other fluids.
fn exponential_ways(problem: &Problem, stages: &[Stage]) -> Vec<Vec<Stage>> {
    let (Some(start), Some(last)) = (stages.first(), stages.last()) else {
        return Vec::new();
    };
    let goals = |stage: &&Stage| !stage.role.compares() && !stage.role.leads();
    let mut whole = hardening_path(problem, start);
    let Some(hard) = whole.last().copied() else {
        return Vec::new();
    };
    whole.extend(diffusion_path(&hard, last));
    whole.extend(
        stages
            .iter()
            .filter(goals)
            .map(|stage| goal(problem, stage)),
    );
    let mut ways = Vec::new();
    // Hardened when hot: heat thins the film and its spikes.
    let soft = Stage {
        heated: true,
        softness: MEDIUM_SOFTNESS,
        newtonian: false,
        ..*start
    };
    let sliding = sliding_path(problem, &soft);
    if let (true, Some(slow)) = (last.heated, sliding.first()) {
        let slow = Stage {
            sliding: slow.sliding,
            ..*start
        };
        let mut way = hardening_path(problem, &slow);
        way.retain(|stage| stage.softness >= MEDIUM_SOFTNESS);
        way.extend(sliding);
        let mut harder = hardening_path(problem, &soft);
        harder.retain(|stage| stage.softness < MEDIUM_SOFTNESS);
        way.extend(harder);
        way.extend(diffusion_path(
            &Stage {
                heated: true,
                ..hard
            },
            last,
        ));
        way.extend(
            stages
                .iter()
                .filter(goals)
                .map(|stage| goal(problem, stage)),
        );
        ways.push(way);
    }
    let heated = sliding_way(problem, start, stages);
    if let Some(first) = heated.first() {
        let slow = Stage {
            sliding: first.sliding,
            ..*start
        };
        let mut way = hardening_path(problem, &slow);
        way.extend(&heated);
        ways.push(way);
    }
    ways.push(whole);
    ways
}
