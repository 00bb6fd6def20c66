//! Continuations: from a contact that is easily solved to the case's own, along one [`Parameter`] at a time.
//!
//! [`paths`] is the table of them, in the order in which they are tried; docs/theory/isothermal-contact.md says which difficulty each overcomes.

pub(super) mod parameter;
#[cfg(test)]
pub(super) mod tests;

use super::stage::Stage;
use crate::solution::Role;
use crate::solve::tuning::continuation::{EXPONENTS, MEDIUM_SOFTNESS, SLIDING, SPEEDS, THICKEST};
use parameter::Parameter;

/// Properties of a problem that continuations use.
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
    /// The quantity that it changes step by step, in words for users.
    pub name: &'static str,
    /// Whether it continues from the usual start, so that it is of no use where that has failed.
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

    /// Final stages of a path: the usual stages after the start that a rule names, with the full iteration budget; but exponential laws
    /// seldom tolerate the overshoots of cubic pressures and use quadratic ones.
    fn ends(&self, rule: impl Fn(&Stage) -> bool) -> impl Iterator<Item = Stage> {
        let early = |stage: &Stage| self.exponential && stage.with_quadratic_pressures().is_some();
        let ends = self.usual[1..].iter().filter(move |stage| rule(stage));
        ends.map(move |stage| Stage {
            given_up_early: early(stage),
            ..*stage
        })
    }

    /// From the stages so far to the case: the shear law where that is the difficulty, then diffusion, then what a rule names.
    fn to_case(&self, mut path: Vec<Stage>, rule: impl Fn(&Stage) -> bool) -> Vec<Stage> {
        if self.exponential && path[path.len() - 1].newtonian {
            path.extend(march(&path[path.len() - 1], Parameter::Softness, |_| true));
        }
        path.extend(less_diffusion(&path[path.len() - 1], self.last()));
        path.extend(self.ends(rule));
        path
    }
}

/// Steps along a parameter at which nothing else changes.
fn march(at: &Stage, parameter: Parameter, within: impl Fn(f64) -> bool) -> Vec<Stage> {
    let step = Stage {
        cold: false,
        role: Role::Path,
        ..*at
    };
    let values = parameter.values().iter().filter(|value| within(**value));
    values.map(|value| parameter.set(step, *value)).collect()
}

/// Steps from a diffusive stage towards the diffusion of another.
pub(super) fn less_diffusion(from: &Stage, to: &Stage) -> Vec<Stage> {
    let [from_value, end] = [from, to].map(|stage| Parameter::Diffusion.of(stage));
    let within = end..from_value;
    march(from, Parameter::Diffusion, |value| within.contains(&value))
}

/// Continuations that are tried, in turn, when the first start or the final stage does not converge. First those that change least: mesh and start stay
/// while the difficulty itself (heat, shear law, spike) is led up to; then another start, then another mesh.
pub(super) fn paths(outline: &Outline) -> Vec<Path> {
    let (start, last) = (*outline.start(), outline.last());
    let measured = |stage: &Stage| !stage.role.compares() || !outline.exponential;
    let heats_up = last.heated && outline.slides;
    let mut paths = Vec::new();
    let mut push = |name, needs_start, stages: Vec<Stage>| {
        paths.push(Path {
            name,
            needs_start,
            stages,
        });
    };
    if outline.exponential && heats_up {
        // To a medium softness with little sliding, through sliding, and the rest of the way when hot: heat thins the film and its spikes.
        let slow = Parameter::Sliding.set(start, SLIDING[0]);
        let hot = Stage {
            heated: true,
            ..Parameter::Softness.set(start, MEDIUM_SOFTNESS)
        };
        let mut path = vec![start];
        path.extend(march(&slow, Parameter::Softness, |s| s >= MEDIUM_SOFTNESS));
        path.extend(march(&hot, Parameter::Sliding, |_| true));
        path.extend(march(&hot, Parameter::Softness, |s| s < MEDIUM_SOFTNESS));
        let name = "shear law, sliding, then the rest of the shear law";
        push(name, true, outline.to_case(path, measured));
    }
    if outline.exponential {
        push("shear law", true, outline.to_case(vec![start], measured));
    } else {
        let path = speeds(outline);
        if !path.is_empty() {
            push("speed", false, path);
        }
        if heats_up {
            let hot = Stage {
                sizes: start.sizes,
                pressure_order: start.pressure_order,
                given_up_early: false,
                ..*last
            };
            let mut path = march(&hot, Parameter::Sliding, |_| true);
            // Without heat first: what was reached so far slides more.
            let unheated = Stage {
                heated: false,
                ..path[0]
            };
            path.insert(0, unheated);
            path.extend(outline.ends(|stage| stage.heated));
            push("sliding", true, path);
        }
        let path = outline.to_case(vec![start], measured);
        push("diffusion", true, path[1..].to_vec());
    }
    let mut thinner = march(&start, Parameter::Exponent, |_| true);
    thinner[0] = Parameter::Exponent.set(start, EXPONENTS[0]);
    let path = outline.to_case(thinner.clone(), measured);
    push("viscosity exponent", false, path);
    // Where the mesh is not refined, on the case's own, which is finer than that of the start.
    let sizes = match outline.refined {
        true => last.sizes.with_finer_rim(),
        false => last.sizes,
    };
    for (name, path) in [
        ("finer rim", vec![start]),
        ("finer rim and viscosity exponent", thinner),
    ] {
        let path = outline.to_case(path, |stage| stage.role == Role::Final);
        let path = path.iter().map(|stage| Stage { sizes, ..*stage });
        push(name, false, path.collect());
    }
    paths
}

/// From a film that is thick at the steep ends of a roller, too, down to the case's speed; empty for other contacts.
fn speeds(outline: &Outline) -> Vec<Stage> {
    let (start, last) = (outline.start(), outline.last());
    let at = |stage: &Stage, multiple: f64| {
        let stage = Stage {
            newtonian: start.newtonian,
            heated: false,
            ..*stage
        };
        Parameter::Speed.set(stage, multiple * stage.constants.lambda)
    };
    // Thick films have other shapes, and other difficulties.
    let is_thin = |multiple: &f64| at(start, *multiple).constants.film_scale < THICKEST;
    let speeds: Vec<f64> = SPEEDS.into_iter().filter(is_thin).collect();
    let Some(first) = speeds.first().filter(|_| outline.roller) else {
        return Vec::new();
    };
    let mut path = vec![at(start, *first)];
    path.extend(speeds.iter().map(|multiple| Stage {
        cold: false,
        role: Role::Path,
        given_up_early: false,
        ..at(last, *multiple)
    }));
    path.extend(outline.ends(|_| true));
    path
}
