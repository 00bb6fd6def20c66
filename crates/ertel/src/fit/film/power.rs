//! Power laws.

use super::form::FilmState;
use super::found::{Estimate, FilmFitError, Found, LARGEST_CONDITION, LARGEST_EFFECT, moved};
use super::table::Films;
use crate::fit::{Minimum, MinimumError, minimise};
use crate::words::digits;

/// Ratio of largest to smallest value of a variable below which it does not vary. In a table of four digits a number is off by
/// up to 5e-4 of itself, a group of several by more: most of all W = M (2U)^(3/4), by (1 + 3/4) 5e-4, to either side.
const LEAST_VARIATION: f64 = 1.0 + 2e-3;
/// Condition number above which variables are collinear in double precision.
const COLLINEAR: f64 = 1e6;

/// Fits `ln(h/scale) = ln c + Σ aᵢ ln xᵢ`.
pub(super) fn fit(
    films: &Films,
    ranges: &[[f64; 2]],
    confidence: f64,
) -> Result<Found, FilmFitError> {
    let variables = films.form.variables();
    let varies: Vec<bool> = ranges
        .iter()
        .map(|[low, high]| *high > LEAST_VARIATION * low)
        .collect();
    let axes: Vec<usize> = (0..variables.len()).filter(|i| varies[*i]).collect();
    let n_states = films.states.len();
    if n_states <= 1 + axes.len() {
        return Err(FilmFitError::TooFew {
            n_states,
            n_unknowns: 1 + axes.len(),
        });
    }
    // Logarithms as multiples of their spread, about the mean and about 0: the unknowns are then of order one.
    let spread: Vec<f64> = axes
        .iter()
        .map(|i| (ranges[*i][1] / ranges[*i][0]).ln())
        .collect();
    let logs: Vec<Vec<f64>> = axes
        .iter()
        .zip(&spread)
        .map(|(i, spread)| {
            let log = |s: &FilmState| s.variables[*i].ln() / spread;
            films.states.iter().map(log).collect()
        })
        .collect();
    let means: Vec<f64> = logs
        .iter()
        .map(|log| log.iter().sum::<f64>() / n_states as f64)
        .collect();
    let film: Vec<f64> = (films.states.iter())
        .map(|s| (s.film / s.scale).ln())
        .collect();
    let solve = |start: &[f64], origin: &[f64]| -> Result<Minimum, MinimumError> {
        minimise(n_states, start, confidence, |x, r| {
            for (state, (r, film)) in r.iter_mut().zip(&film).enumerate() {
                *r = x[0] - film;
                for ((x, log), origin) in x[1..].iter().zip(&logs).zip(origin) {
                    *r += x * (log[state] - origin);
                }
            }
        })
    };
    let minimum = solve(&vec![0.0; 1 + axes.len()], &means)?;
    let together = || {
        // About the means, the factor is independent of the exponents.
        let exponents = axes.iter().map(|i| variables[*i].symbol);
        minimum
            .trading(["c"].into_iter().chain(exponents))
            .join(" and ")
    };
    if minimum.condition > COLLINEAR {
        return Err(FilmFitError::Collinear(together()));
    }
    // c is the film where all variables are 1; solved again without centring, for its interval.
    let mut start = minimum.x.clone();
    start[0] -= (minimum.x[1..].iter().zip(&means))
        .map(|(x, mean)| x * mean)
        .sum::<f64>();
    let at_one = solve(&start, &vec![0.0; axes.len()])?;
    let mut constants = vec![None; 1 + variables.len()];
    constants[0] = Some(Estimate::of_log(at_one.x[0], at_one.half_widths[0]));
    let mut widened = vec![None; 1 + variables.len()];
    let half = at_one.half_widths[0] + moved(films, &at_one, 0);
    widened[0] = Some(Estimate::of_log(at_one.x[0], half).interval);
    let mut warnings = Vec::new();
    for (i, variable) in variables.iter().enumerate() {
        let [low, high] = ranges[i].map(|v| format!("{} {}", digits(v, 4), variable.unit));
        let [low, high] = [low.trim_end(), high.trim_end()];
        let name = variable.name;
        let Some(j) = axes.iter().position(|axis| *axis == i) else {
            warnings.push(format!(
                "{name} does not vary (it is {low}): its exponent cannot be determined and its power is part of the factor"
            ));
            continue;
        };
        let [value, half] = [minimum.x[j + 1], minimum.half_widths[j + 1]].map(|v| v / spread[j]);
        constants[i + 1] = Some(Estimate {
            value,
            interval: [value - half, value + half],
        });
        let wide = half + moved(films, &minimum, j + 1) / spread[j];
        widened[i + 1] = Some([value - wide, value + wide]);
        if 2.0 * minimum.half_widths[j + 1] > LARGEST_EFFECT {
            warnings.push(format!(
                "the data hardly determine the exponent of {name}: with {name} from {low} to {high} it lies between {} and {}",
                digits(value - half, 3),
                digits(value + half, 3)
            ));
        }
    }
    if minimum.condition > LARGEST_CONDITION {
        warnings.push(format!(
            "{} vary together (condition number {}): their exponents trade off",
            together(),
            digits(minimum.condition, 2)
        ));
    }
    Ok(Found {
        constants,
        widened,
        residuals: minimum.residuals,
        warnings,
    })
}
