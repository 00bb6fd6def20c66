//! Derivatives of the figures of a solution by the inputs of its case file.
//!
//! Each input is moved a little, the case is read again with it, and the resulting problem is passed to the method:
//! machines, data sheets and laws of any kind need no special treatment. Finite volumes linearise; finite elements solve the problems on either side on the
//! mesh of the solution.

use std::collections::BTreeMap;

use ertel_input::Input;
use rayon::prelude::*;

use crate::case::Case;
use crate::engine::sensitivity::{Derivatives, NoDerivative, Perturbed};
use crate::engine::{Observer, SolveError};
use crate::params::{ElasticModel, SensitivityDemand};
use crate::problem::{nearby_problem, problem};
use crate::solution::{
    Figure, FigureSensitivity, LeftOut, Sensitivities, SensitivityInput, SensitivityMethod,
};
use crate::solve::figures::{Scope, figures};
use crate::solve::sequence::{Plan, Problem, StageSolution, Start, solve_on_mesh};

/// Step of an input of linearised equations, over its size.
const STEP: f64 = 1e-5;

/// Step of an input that is zero, over its uncertainty.
const STEP_FROM_ZERO: f64 = 1e-3;

/// Step of differences of solves, of an input without an uncertainty; with one, the step is its standard deviation.
const STEP_OF_SOLVES: f64 = 0.01;

/// Why an input has no derivative where values on neither side of it are allowed.
const AT_ITS_BOUND: &str = "it is at the bound of its range";

/// Reason why an input has no derivative: grade numbers are names without neighbours.
fn why_not(key: &str, reason: &str) -> String {
    let is_grade = key.rsplit('.').next() == Some("iso_vg");
    match is_grade && reason == AT_ITS_BOUND {
        true => "grades are discrete; kinematic_viscosity_40 has a derivative".to_owned(),
        false => reason.to_owned(),
    }
}

fn left_out(input: &Input, reason: String) -> LeftOut {
    LeftOut {
        key: input.key.clone(),
        reason,
    }
}

fn described(input: &Input) -> SensitivityInput {
    SensitivityInput {
        key: input.key.clone(),
        value: input.value,
        unit: input.dimension.si_unit(),
        uncertainty: input.uncertainty,
    }
}

/// Adds the derivatives by an input, or the reason why it has none. Files of results refuse numbers that are not finite: the whole solution would be lost with one.
fn add(all: &mut Sensitivities, input: &Input, derivatives: Result<Vec<f64>, NoDerivative>) {
    let finite = derivatives.and_then(|by| match by.iter().all(|by| by.is_finite()) {
        true => Ok(by),
        false => Err(NoDerivative::NotFinite),
    });
    match finite {
        Ok(derivatives) => {
            for (figure, by) in all.figures.iter_mut().zip(derivatives) {
                figure.derivatives.push(by);
            }
            all.inputs.push(described(input));
        }
        Err(reason) => all.left_out.push(left_out(input, reason.to_string())),
    }
}

/// Derivatives of those figures of finite elements that are `resolved`: for each input two solves on the mesh of `start`, for `only_uncertain`
/// inputs or all of them.
///
/// # Errors
/// Only when the user wants to stop.
pub fn by_differences(
    case: &Case,
    own: &Problem,
    start: &Start,
    only_uncertain: bool,
    resolved: impl Fn(Figure) -> bool,
    observer: &mut dyn Observer,
) -> Result<Sensitivities, SolveError> {
    let of = |problem: &Problem, solution: &StageSolution| -> Vec<Option<f64>> {
        let (d, state) = (&solution.discretisation, &solution.state);
        let found = figures(problem, &problem.fluid, d, state, Scope::All);
        Figure::TRACED.map(|figure| found.value(figure)).to_vec()
    };
    let values = of(own, start.solution());
    let present: Vec<usize> = (0..values.len())
        .filter(|i| values[*i].is_some() && resolved(Figure::TRACED[*i]))
        .collect();
    let mut sensitivities = Sensitivities {
        by: SensitivityMethod::Differences,
        inputs: Vec::new(),
        figures: (present.iter())
            .map(|i| FigureSensitivity {
                figure: Figure::TRACED[*i],
                value: values[*i].unwrap_or(f64::NAN),
                derivatives: Vec::new(),
            })
            .collect(),
        left_out: Vec::new(),
    };
    let asked = case.inputs().iter().filter(|input| match only_uncertain {
        true => input.uncertainty.is_some(),
        false => input.value != 0.0 || input.uncertainty.is_some(),
    });
    for input in asked {
        if let Some(reason) = no_temperature(case, input) {
            sensitivities.left_out.push(left_out(input, reason));
            continue;
        }
        let step = (input.uncertainty).map_or(STEP_OF_SOLVES * input.value.abs(), |u| u.standard());
        let mut side = |value: f64| -> Result<Result<Vec<Option<f64>>, &str>, SolveError> {
            let values = BTreeMap::from([(input.key.clone(), value)]);
            let Ok(case) = case.with_values(values) else {
                return Ok(Err(AT_ITS_BOUND));
            };
            let mut problem = problem(&case);
            problem.plan.target = None;
            Ok(match solve_on_mesh(&problem, start, observer)? {
                Some(solution) => Ok(of(&problem, &solution)),
                None => {
                    Err("a solve with a changed input did not converge on the mesh of the solution")
                }
            })
        };
        let sides = [side(input.value - step)?, side(input.value + step)?];
        // At a bound, the derivative towards the side that there is.
        let (sides, distance) = match sides {
            [Err(AT_ITS_BOUND), Ok(above)] => ([Ok(values.clone()), Ok(above)], step),
            [Ok(below), Err(AT_ITS_BOUND)] => ([Ok(below), Ok(values.clone())], step),
            sides => (sides, 2.0 * step),
        };
        match sides {
            [Ok(below), Ok(above)] if below == above && !input.written => {}
            [Ok(below), Ok(above)] => {
                let of = |i: &usize| {
                    let [below, above] = [below[*i], above[*i]].map(|v| v.unwrap_or(f64::NAN));
                    (above - below) / distance
                };
                let derivatives = present.iter().map(of).collect();
                add(&mut sensitivities, input, Ok(derivatives));
            }
            [Err(reason), _] | [_, Err(reason)] => {
                let reason = why_not(&input.key, reason);
                sensitivities.left_out.push(left_out(input, reason));
            }
        }
    }
    Ok(sensitivities)
}

/// Derivatives of the figures of a solution by every input of an isothermal contact.
pub fn by_derivatives(
    case: &Case,
    problem: &Problem,
    solution: &impl Derivatives<Plan>,
) -> Sensitivities {
    let modulus = ByModulus::of(case);
    let mut missing = Vec::new();
    let follows = |input: &Input| modulus.as_ref().is_some_and(|m| m.follows(input));
    let inputs: Vec<&Input> = case.inputs().iter().filter(|i| !follows(i)).collect();
    let asked = perturbed(case, problem, inputs, &mut missing);
    let (inputs, sides): (Vec<&Input>, Vec<Perturbed<Plan>>) = asked.into_iter().unzip();
    let figures = (solution.figures().into_iter()).map(|figure| FigureSensitivity {
        figure,
        value: solution.value(figure),
        derivatives: Vec::new(),
    });
    let mut all = Sensitivities {
        by: SensitivityMethod::LinearSolves,
        inputs: Vec::new(),
        figures: figures.collect(),
        left_out: missing,
    };
    for (input, derivatives) in inputs.into_iter().zip(solution.derivatives(&sides)) {
        // A constant of a database law that has no effect here.
        let is_zero = (derivatives.as_ref()).is_ok_and(|by| by.iter().all(|by| *by == 0.0));
        if is_zero && !input.written {
            continue;
        }
        add(&mut all, input, derivatives.clone());
        for (other, ratio) in modulus.iter().flat_map(|modulus| modulus.others(input)) {
            let scaled = |by: &Vec<f64>| by.iter().map(|by| ratio * by).collect();
            add(
                &mut all,
                other,
                derivatives.as_ref().map(scaled).map_err(|reason| *reason),
            );
        }
    }
    all
}

/// The inputs that have a derivative, each with the problem next to the solution's; those that have none are added to `missing`.
fn perturbed<'a>(
    case: &Case,
    problem: &Problem,
    inputs: Vec<&'a Input>,
    missing: &mut Vec<LeftOut>,
) -> Vec<(&'a Input, Perturbed<Plan>)> {
    let next: Vec<_> = (inputs.par_iter())
        .map(|input| next_to(case, problem, input))
        .collect();
    let mut asked = Vec::new();
    for (input, next) in inputs.into_iter().zip(next) {
        if let Some(reason) = no_temperature(case, input) {
            missing.push(left_out(input, reason));
            continue;
        }
        match next {
            Some(Ok(next))
                if is_costly(case, input) && !problem.shape.is_like(&next.problem.shape) =>
            {
                let reason = "it changes the length of the roller in half-widths; [output] sensitivities = true makes another mesh for it";
                missing.push(left_out(input, reason.to_owned()));
            }
            Some(Ok(next)) => asked.push((input, next)),
            Some(Err(reason)) if input.written || input.estimated => {
                missing.push(left_out(input, reason));
            }
            // Of no effect, or at the end of what a law of the database allows.
            _ => {}
        }
    }
    asked
}

/// Reason why a derivative by the temperature of the lubricant would be a meaningless zero: a law is missing.
fn no_temperature(case: &Case, input: &Input) -> Option<String> {
    let is_temperature = matches!(input.key.as_str(), "temperature" | "lubricant.temperature");
    is_temperature.then(|| case.lubricant.no_temperature())?
}

/// Whether another mesh for an input costs more than was requested.
fn is_costly(case: &Case, input: &Input) -> bool {
    case.contact.roller.is_some()
        && case.output.sensitivities != SensitivityDemand::All
        && input.uncertainty.is_none()
}

/// The problem with a slightly larger value of an input, or a smaller one at a bound; `None` where it has no effect that a derivative could show. A second
/// one on the other side would double the time and improve no more than the error of a step of 1e-5.
fn next_to(case: &Case, own: &Problem, input: &Input) -> Option<Result<Perturbed<Plan>, String>> {
    let size = match input.value {
        0.0 => STEP_FROM_ZERO / STEP * input.uncertainty?.standard(),
        value => value.abs(),
    };
    let by = |step: f64| {
        let values = BTreeMap::from([(input.key.clone(), input.value + step)]);
        let case = case.with_values(values).ok()?;
        let problem = nearby_problem(&case, own);
        Some(Perturbed { problem, step })
    };
    let found = by(STEP * size).or_else(|| by(-STEP * size));
    Some(found.ok_or_else(|| why_not(&input.key, AT_ITS_BOUND)))
}

/// Elastic constants of half-spaces count by the reduced modulus alone.
struct ByModulus<'a> {
    /// The first of them, which is asked for, and d E'/d of it.
    first: (&'a Input, f64),
    others: Vec<(&'a Input, f64)>,
}

impl<'a> ByModulus<'a> {
    fn of(case: &'a Case) -> Option<ByModulus<'a>> {
        if case.elastic_model() != ElasticModel::HalfSpace {
            return None;
        }
        let is_elastic = |input: &&Input| {
            input.key.starts_with("bodies.")
                && (input.key.ends_with(".youngs_modulus")
                    || input.key.ends_with(".poissons_ratio"))
                && input.value != 0.0
        };
        let slope = |input: &'a Input| -> Option<(&'a Input, f64)> {
            let modulus = |value: f64| {
                let values = BTreeMap::from([(input.key.clone(), value)]);
                Some(case.with_values(values).ok()?.reduced_modulus())
            };
            let step = STEP * input.value.abs();
            let [below, above] = [modulus(input.value - step)?, modulus(input.value + step)?];
            Some((input, (above - below) / (2.0 * step)))
        };
        let mut all = case.inputs().iter().filter(is_elastic).filter_map(slope);
        Some(ByModulus {
            first: all.next()?,
            others: all.collect(),
        })
    }

    /// Whether an input follows from the first.
    fn follows(&self, input: &Input) -> bool {
        self.others.iter().any(|(other, _)| other.key == input.key)
    }

    /// The others, with the ratio of derivatives by them and by this one, if it is the first.
    fn others(&self, input: &Input) -> impl Iterator<Item = (&'a Input, f64)> + '_ {
        let is_first = input.key == self.first.0.key;
        (self.others.iter().filter(move |_| is_first))
            .map(|(other, slope)| (*other, slope / self.first.1))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Derivatives of two figures; one by the first input is not a number.
    struct Broken;

    impl Derivatives<Plan> for Broken {
        fn figures(&self) -> Vec<Figure> {
            vec![Figure::FilmCentral, Figure::FilmMinimum]
        }

        fn value(&self, _: Figure) -> f64 {
            1.0
        }

        fn derivatives(&self, inputs: &[Perturbed<Plan>]) -> Vec<Result<Vec<f64>, NoDerivative>> {
            let of = |i: usize| match i {
                0 => Ok(vec![1.0, f64::NAN]),
                _ => Ok(vec![1.0, 2.0]),
            };
            (0..inputs.len()).map(of).collect()
        }
    }

    #[test]
    fn an_input_whose_derivative_is_not_finite_is_left_out() {
        let text = include_str!("../../../cases/ball-on-disc.toml");
        let case = Case::from_text("case.toml", text, std::path::Path::new("")).unwrap();
        let found = by_derivatives(&case, &problem(&case), &Broken);
        // The elastic constants follow from the first of them.
        assert!(!found.left_out.is_empty());
        for own in &found.left_out {
            assert_eq!(own.reason, "one of its derivatives is not a finite number");
            assert!(found.inputs.iter().all(|input| input.key != own.key));
        }
        for figure in &found.figures {
            assert_eq!(figure.derivatives.len(), found.inputs.len());
            assert!(figure.derivatives.iter().all(|by| by.is_finite()));
        }
    }
}
