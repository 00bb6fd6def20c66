//! Continuations: from a contact that is easily solved to the case's own, along one [`Knob`] at a time.
//!
//! [`paths`] is the table of them, in the order in which they are tried; what each cures stands in docs/theory/isothermal-contact.md.

pub(super) mod knob;
#[cfg(test)]
pub(super) mod tests;

use super::stage::Stage;
use crate::solution::Role;
use crate::solve::tuning::continuation::{EXPONENTS, MEDIUM_SOFTNESS, SLIDING, THICKEST};
use knob::Knob;

/// What continuations know of a problem.
#[derive(Clone, Debug)]
pub(super) struct Outline {
    /// The usual stages: start, comparisons, solution; never empty.
    pub usual: Vec<Stage>,
    /// Whether shear rates grow exponentially with the stress (Eyring, limiting stress).
    pub exponential: bool,
    /// Whether it is a roller, whose film is much thinner at the ends than in the middle.
    pub roller: bool,
    /// ρ_r of stages that do not converge without, and of meshes refined for the pressure alone; 0 where there is none.
    pub ridge_diffusion: f64,
    /// Whether the surfaces slide.
    pub slides: bool,
    /// Whether the mesh is refined locally after the first solution.
    pub refined: bool,
}

/// A continuation laid out for a problem.
#[derive(Clone, Debug)]
pub(super) struct Path {
    /// What it changes step by step, in words for users.
    pub name: &'static str,
    /// Whether it goes on from the usual start, so that it is of no use where that has failed.
    pub needs_start: bool,
    /// Its stages; never empty.
    pub stages: Vec<Stage>,
}

impl Outline {
    /// The start.
    pub fn start(&self) -> &Stage {
        &self.usual[0]
    }

    /// The solution.
    pub fn last(&self) -> &Stage {
        &self.usual[self.usual.len() - 1]
    }

    /// What a path ends with: the usual stages after the start that a rule names, none of them given up early, for what was is tried in
    /// earnest; but an exponential seldom bears the overshoots of cubic pressures, and quadratic ones stand in for them.
    fn ends(&self, rule: impl Fn(&Stage) -> bool) -> impl Iterator<Item = Stage> {
        self.usual[1..]
            .iter()
            .filter(move |stage| rule(stage))
            .map(|stage| Stage {
                given_up_early: self.exponential && stage.with_quadratic_pressures().is_some(),
                ..*stage
            })
    }

    /// What leads from a start to the stages that a path ends with: the shear law where that is the difficulty, then diffusion.
    fn steps_after(&self, start: &Stage) -> Vec<Stage> {
        let mut path = Vec::new();
        if self.exponential {
            path = march(&thinned(start), Knob::Softness, |_| true);
        }
        path.extend(less_diffusion(path.last().unwrap_or(start), self.last()));
        path
    }
}

/// Steps along a knob at which nothing else changes.
fn march(at: &Stage, knob: Knob, within: impl Fn(f64) -> bool) -> Vec<Stage> {
    let step = Stage {
        cold: false,
        role: Role::Path,
        ..*at
    };
    let values = knob.values().iter().filter(|value| within(**value));
    values.map(|value| knob.set(step, *value)).collect()
}

/// Steps from a diffusive stage towards the diffusion of another.
pub(super) fn less_diffusion(from: &Stage, to: &Stage) -> Vec<Stage> {
    let [from_value, end] = [from, to].map(|stage| Knob::Diffusion.of(stage));
    march(from, Knob::Diffusion, |value| {
        (end..from_value).contains(&value)
    })
}

/// The same stage with the case's own shear law.
fn thinned(stage: &Stage) -> Stage {
    Stage {
        newtonian: false,
        ..*stage
    }
}

/// What is tried, in turn, when the first start or the final stage does not converge. First what changes least: mesh and start stay
/// while the difficulty itself (heat, shear law, spike) is led up to; then another start, then another mesh.
pub(super) fn paths(outline: &Outline) -> Vec<Path> {
    let (start, last) = (outline.start(), outline.last());
    let any = |_: &Stage| true;
    let measured = |stage: &Stage| !stage.role.compares() || !outline.exponential;
    let from_start = |start: &Stage| {
        let ends = outline.ends(measured);
        outline.steps_after(start).into_iter().chain(ends)
    };
    let mut paths = Vec::new();
    let mut push = |name, needs_start, stages: Vec<Stage>| {
        paths.push(Path {
            name,
            needs_start,
            stages,
        });
    };
    if outline.exponential {
        if last.heated && outline.slides {
            // To a medium softness with little sliding, through sliding, and the rest of the way when hot: heat thins the film and its spikes.
            let slow = Knob::Sliding.set(thinned(start), SLIDING[0]);
            let hot = Knob::Softness.set(thinned(start), MEDIUM_SOFTNESS);
            let hot = Stage {
                heated: true,
                ..hot
            };
            let mut path = vec![*start];
            path.extend(march(&slow, Knob::Softness, |s| s >= MEDIUM_SOFTNESS));
            path.extend(march(&hot, Knob::Sliding, |_| true));
            path.extend(march(&hot, Knob::Softness, |s| s < MEDIUM_SOFTNESS));
            path.extend(less_diffusion(&path[path.len() - 1], last));
            path.extend(outline.ends(measured));
            push(
                "shear law, sliding, then the rest of the shear law",
                true,
                path,
            );
        }
        let path = [*start].into_iter().chain(from_start(start));
        push("shear law", true, path.collect());
    } else {
        let faster = |stage: &Stage, speed: f64| {
            let stage = Stage {
                newtonian: start.newtonian,
                heated: false,
                ..*stage
            };
            Knob::Speed.set(stage, speed * stage.constants.lambda)
        };
        // Thick films have other shapes, and other difficulties.
        let speeds = Knob::Speed.values().iter().copied();
        let mut speeds = speeds
            .filter(|speed| faster(start, *speed).constants.film_scale < THICKEST)
            .peekable();
        if let Some(first) = speeds.peek().copied().filter(|_| outline.roller) {
            let mut path = vec![faster(start, first)];
            path.extend(speeds.map(|speed| Stage {
                cold: false,
                role: Role::Path,
                given_up_early: false,
                ..faster(last, speed)
            }));
            path.extend(outline.ends(any));
            push("speed", false, path);
        }
        if last.heated && outline.slides {
            let hot = Stage {
                sizes: start.sizes,
                pressure_order: start.pressure_order,
                given_up_early: false,
                ..*last
            };
            let mut path = march(&hot, Knob::Sliding, |_| true);
            // Without heat first: what was reached so far slides more.
            let unheated = Stage {
                heated: false,
                ..path[0]
            };
            path.insert(0, unheated);
            path.extend(outline.ends(|stage| stage.heated));
            push("sliding", true, path);
        }
        push("diffusion", true, from_start(start).collect());
    }
    let mut path = march(start, Knob::Exponent, |_| true);
    path[0] = Knob::Exponent.set(*start, EXPONENTS[0]);
    path.extend(from_start(start));
    push("viscosity exponent", false, path);
    // Where the mesh is not refined, on the case's own, which is finer than that of the start.
    let sizes = match outline.refined {
        true => last.sizes.with_finer_rim(),
        false => last.sizes,
    };
    let path = [*start].into_iter().chain(outline.steps_after(start));
    let path = path.chain(outline.ends(|stage| stage.role == Role::Final));
    push(
        "finer rim",
        false,
        path.map(|stage| Stage { sizes, ..stage }).collect(),
    );
    paths
}
