//! Ellipses with the motion at any angle.

use super::form::factor;
use super::found::{Estimate, FilmFitError, Found, LARGEST_CONDITION, LARGEST_EFFECT, moved};
use super::table::Films;
use crate::fit::{Minimum, MinimumError, minimise};
use crate::words::digits;

/// Ratio of largest to smallest value of a group below which it does not vary, as for power laws.
const LEAST_VARIATION: f64 = 1.0 + 2e-3;
/// Condition number above which constants are collinear in double precision.
const COLLINEAR: f64 = 1e6;
/// Where the search starts: a, b, d, e and f of the published central films (Hamrock and Dowson 1977; Chittenden et al. 1985).
const START: [f64; 5] = [0.67, 0.53, -0.067, 1.23, 2.0 / 3.0];
/// Index of b among the constants, the only one that can be omitted.
const MATERIAL_EXPONENT: usize = 2;

/// The constants from the unknowns, ln c, ln a, d, ln e, ln f and, last, b where it is one.
fn constants(x: &[f64]) -> [f64; 6] {
    let b = x.get(5).copied().unwrap_or(0.0);
    [x[0].exp(), x[1].exp(), b, x[2], x[3].exp(), x[4].exp()]
}

/// Constants by unknown.
const ORDER: [usize; 6] = [0, 1, 3, 4, 5, MATERIAL_EXPONENT];
/// Whether an unknown is the logarithm of its constant.
const IS_LOG: [bool; 6] = [true, true, false, true, true, false];

/// Fits all constants at once; without b where G does not vary.
pub(super) fn fit(
    films: &Films,
    ranges: &[[f64; 2]],
    confidence: f64,
) -> Result<Found, FilmFitError> {
    let names = films.form.constants();
    let [low, high] = ranges[1];
    let has_material = high > LEAST_VARIATION * low;
    let n_unknowns = if has_material { 6 } else { 5 };
    let n_states = films.states.len();
    if n_states <= n_unknowns {
        return Err(FilmFitError::TooFew {
            n_states,
            n_unknowns,
        });
    }
    let [a, b, d, e, f] = START;
    let mut start = vec![0.0, a.ln(), d, e.ln(), f.ln()];
    if has_material {
        start.push(b);
    }
    // Logarithms of U, G, W about an origin: about their means, the factor is independent of the exponents.
    let logs: Vec<[f64; 3]> = (films.states.iter())
        .map(|s| [0, 1, 2].map(|i| s.variables[i].ln()))
        .collect();
    let means = [0, 1, 2].map(|i| logs.iter().map(|l| l[i]).sum::<f64>() / n_states as f64);
    let residuals = |origin: [f64; 3], x: &[f64], r: &mut [f64]| {
        let [_, a, b, d, e, f] = constants(x);
        for ((r, state), log) in r.iter_mut().zip(&films.states).zip(&logs) {
            let [u, g, w] = [0, 1, 2].map(|i| log[i] - origin[i]);
            let shape = factor([a, d, e, f], state.variables[3], state.variables[4]);
            *r = x[0] + a * u + b * g + d * w + (shape * state.scale / state.film).ln();
        }
    };
    let solve = |start: &[f64], origin: [f64; 3]| {
        let names = |i: usize| FilmFitError::Unvaried(names[ORDER[i]]);
        minimise(n_states, start, confidence, |x, r| residuals(origin, x, r)).map_err(|error| {
            match error {
                MinimumError::NoInfluence(i) => names(i),
                error => FilmFitError::Minimum(error),
            }
        })
    };
    // The factor first: films of the published constants may be far from those given.
    let mut off = vec![0.0; n_states];
    residuals(means, &start, &mut off);
    start[0] = -off.iter().sum::<f64>() / n_states as f64;
    let minimum = solve(&start, means)?;
    let order = || ORDER.iter().take(n_unknowns).map(|i| names[*i]);
    if minimum.condition > COLLINEAR {
        let trading = minimum.trading(order()).join(" and ");
        return Err(FilmFitError::Inseparable(trading));
    }
    let [_, a, b, d, ..] = constants(&minimum.x);
    let mut at_one = minimum.x.clone();
    at_one[0] -= a * means[0] + b * means[1] + d * means[2];
    let at_one = solve(&at_one, [0.0; 3])?;
    let mut found = Found {
        constants: vec![None; names.len()],
        widened: vec![None; names.len()],
        residuals: minimum.residuals.clone(),
        warnings: Vec::new(),
    };
    if !has_material {
        found.warnings.push(format!(
            "G does not vary (it is {}): its exponent cannot be determined and its power is part of the factor",
            digits(low, 4)
        ));
    }
    for (i, place) in ORDER.iter().take(n_unknowns).enumerate() {
        // c is the film where all groups are 1.
        let minimum = if i == 0 { &at_one } else { &minimum };
        let (value, half) = (minimum.x[i], minimum.half_widths[i]);
        let estimate = |half: f64| match IS_LOG[i] {
            true => Estimate::of_log(value, half),
            false => Estimate {
                value,
                interval: [value - half, value + half],
            },
        };
        found.constants[*place] = Some(estimate(half));
        let wide = half + moved(films, minimum, i);
        found.widened[*place] = Some(estimate(wide).interval);
        let origin = if i == 0 { [0.0; 3] } else { means };
        if i > 0 && effect(minimum, i, |x, r| residuals(origin, x, r)) > LARGEST_EFFECT {
            let [low, high] = estimate(half).interval.map(|v| digits(v, 3));
            found.warnings.push(format!(
                "the data hardly determine {}: it lies between {low} and {high}",
                names[*place]
            ));
        }
    }
    if minimum.condition > LARGEST_CONDITION {
        found.warnings.push(format!(
            "{} trade off (condition number {})",
            minimum.trading(order()).join(" and "),
            digits(minimum.condition, 2)
        ));
    }
    Ok(found)
}

/// Share of the film by which an unknown, from one end of its interval to the other, moves some films against others.
fn effect(minimum: &Minimum, unknown: usize, residuals: impl Fn(&[f64], &mut [f64])) -> f64 {
    let at = |sign: f64| {
        let mut x = minimum.x.clone();
        // Beyond a few units, exponentials of undetermined constants carry no further information.
        x[unknown] += sign * minimum.half_widths[unknown].min(5.0);
        let mut r = vec![0.0; minimum.residuals.len()];
        residuals(&x, &mut r);
        r
    };
    let (low, high) = (at(-1.0), at(1.0));
    let moves = high.iter().zip(&low).map(|(high, low)| high - low);
    let [least, most] = moves.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], v| {
        [low.min(v), high.max(v)]
    });
    most - least
}
