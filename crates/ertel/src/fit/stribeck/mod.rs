//! Constants of rough surfaces from a measured Stribeck curve.
//!
//! ```text
//!   f_i = |f_film(i; σ) + f_b a(i; σ)|,   a = ∫ p_a e dA/W,   Σ [(f_i − m_i)/w_i]² → min
//! ```
//! i: the readings at different speeds, m the measured friction, w its uncertainty. f_film and a come from solved contacts of oil and asperities at some σ (and
//! σβη), and follow polynomials of their logarithms between them; the range of σ shrinks around the minimum in a few rounds.

mod error;
mod found;
mod search;
mod solves;
mod surrogate;

use crate::compare::{Measurand, Measured, MeasuredRow, Measurement};
use crate::fit::least_squares::Minimum;
use crate::mixed::AsperityLaw;

pub use error::StribeckError;
pub use found::{FittedPoint, StribeckFit, SurfaceConstant, SurfaceEstimate};
use search::{Model, Reading};
use solves::Contacts;
pub use solves::{FitObserver, TARGET_ERROR};
use surrogate::{Range, Surrogate};

/// Half-widths of the ranges of ln σ: a factor of 4, 1.5 and 1.15.
const HALF_WIDTHS: [f64; 3] = [1.3863, 0.4055, 0.1398];
/// Chebyshev's points of each unknown in these ranges, of one unknown and of two; the degree of the polynomials is less by 2.
const NODES: [[usize; 3]; 2] = [[8, 6, 5], [6, 5, 4]];
/// Rounds at most: a range moves where the minimum is at its end.
const MOST_ROUNDS: usize = 7;
/// Place in a range, from −1 to 1, beyond which the minimum may be outside.
const AT_THE_END: f64 = 0.999;
/// Correlation from which two constants are reported as not separable.
const CORRELATED: f64 = 0.95;

/// Standard deviation of the residuals over the uncertainties of the readings above which chance hardly explains it: it does in 0.03 % of cases with three readings more than constants (χ²), less often with more.
const POOR: f64 = 2.5;

/// Fits the boundary friction coefficient and σ, with `fit_group` also σβη, to measured friction. σ/β, the law and the gap that flows are those of the case.
///
/// # Errors
///
/// [`StribeckError`].
pub fn fit_stribeck(
    measured: &Measured,
    fit_group: bool,
    observer: &dyn FitObserver,
) -> Result<StribeckFit, StribeckError> {
    let (readings, is_weighted) = readings(measured)?;
    let n_constants = 2 + usize::from(fit_group);
    if readings.len() <= n_constants {
        let least = n_constants + 1;
        return Err(StribeckError::TooFew(readings.len(), n_constants, least));
    }
    let contacts = Contacts::new(&measured.study)?;
    let start = start(&contacts, fit_group)?;
    let mut rounds = Rounds {
        contacts,
        readings: &readings,
        observer,
        n_solves: 0,
        n_rounds: 0,
        bar: 0.0,
    };
    let (last, mut warnings) = rounds.run(start)?;
    let model = Model {
        friction: last.friction,
        readings: &readings,
    };
    let (minimum, places) = (model.uncertainty(last.boundary, &last.x))
        .map_err(|error| StribeckError::NoMinimum(error.to_string()))?;
    let constants = constants(last.boundary, &last.x, |i| {
        places[i].map(|place| minimum.standard(place))
    });
    let correlations = correlations(&constants, &minimum, &places);
    warnings.extend(inseparable(&correlations));
    warnings.extend(poor(minimum.scatter, is_weighted));
    let base = &measured.study.points[0].case;
    let (Some(asperities), Some(rms_height)) = (base.asperities.clone(), base.roughness) else {
        return Err(StribeckError::NoAsperities);
    };
    Ok(StribeckFit {
        constants,
        correlations,
        points: model.points(&measured.study, last.boundary, &last.x),
        scatter: minimum.scatter,
        is_weighted,
        n_solves: rounds.n_solves,
        target_error: TARGET_ERROR,
        largest_bar: rounds.bar,
        warnings,
        asperities,
        rms_height,
    })
}

/// Coefficients of correlation of the constants that are resolved.
fn correlations(
    constants: &[SurfaceEstimate],
    minimum: &Minimum,
    places: &[Option<usize>],
) -> Vec<(SurfaceConstant, SurfaceConstant, f64)> {
    let resolved: Vec<(SurfaceConstant, usize)> = (constants.iter().zip(places))
        .filter(|(own, _)| own.is_resolved())
        .filter_map(|(own, place)| Some((own.constant, (*place)?)))
        .collect();
    let pairs = resolved.iter().enumerate().flat_map(|(i, (one, a))| {
        let others = resolved[i + 1..].iter();
        others.map(move |(other, b)| (*one, *other, minimum.correlation(*a, *b)))
    });
    pairs.collect()
}

/// Warnings about constants that trade off.
fn inseparable(correlations: &[(SurfaceConstant, SurfaceConstant, f64)]) -> Vec<String> {
    let close = (correlations.iter()).filter(|(_, _, found)| found.abs() > CORRELATED);
    close
        .map(|(one, other, _)| {
            let [one, other] = [one, other].map(|own| own.words());
            format!("{one} and {other} can hardly be separated by these readings")
        })
        .collect()
}

/// Warning about residuals beyond the uncertainties of the readings.
fn poor(scatter: f64, is_weighted: bool) -> Option<String> {
    (is_weighted && scatter > POOR).then(|| {
        let ratio = crate::words::digits(scatter, 2);
        format!("the readings deviate from the fit by {ratio} times their uncertainties: check the oil, the law of the asperities and σ/β of the case")
    })
}

/// The measured friction, and whether all of it has uncertainties.
fn readings(measured: &Measured) -> Result<(Vec<Reading>, bool), StribeckError> {
    let figure = Measurand::Traction as usize;
    let with_friction = measured.rows.iter().filter_map(|row| {
        let own = row.figures[figure]?;
        Some((row, own, own.uncertainty.filter(|width| *width > 0.0)))
    });
    let found: Vec<_> = with_friction.collect();
    if found.is_empty() {
        return Err(StribeckError::NoFriction);
    }
    let is_weighted = found.iter().all(|(_, _, width)| width.is_some());
    let reading = |(row, own, width): &(&MeasuredRow, Measurement, Option<f64>)| Reading {
        line: row.line,
        point: row.point,
        measured: own.value.abs(),
        width: width.filter(|_| is_weighted).unwrap_or(1.0),
    };
    Ok((found.iter().map(reading).collect(), is_weighted))
}

/// ln σ and perhaps ln σβη of the case.
fn start(contacts: &Contacts, fit_group: bool) -> Result<Vec<f64>, StribeckError> {
    let case = contacts.first().ok_or(StribeckError::NoFriction)?;
    let (Some(asperities), Some(sigma)) = (&case.asperities, case.roughness) else {
        return Err(StribeckError::NoAsperities);
    };
    match (&asperities.law, fit_group) {
        (_, false) => Ok(vec![sigma.ln()]),
        (
            AsperityLaw::GreenwoodTripp(summits) | AsperityLaw::GreenwoodWilliamson(summits),
            true,
        ) => Ok(vec![sigma.ln(), summits.asperity_group.ln()]),
        _ => Err(StribeckError::NoGroup),
    }
}

/// The constants with their standard uncertainties; those of logarithms times the value.
fn constants(
    boundary: f64,
    x: &[f64],
    standard: impl Fn(usize) -> Option<f64>,
) -> Vec<SurfaceEstimate> {
    let names = [SurfaceConstant::RmsHeight, SurfaceConstant::AsperityGroup];
    let friction = SurfaceEstimate {
        constant: SurfaceConstant::BoundaryFriction,
        value: boundary,
        standard: standard(0),
    };
    let others = names.iter().zip(x).enumerate();
    let of = |(i, (constant, ln)): (usize, (&SurfaceConstant, &f64))| SurfaceEstimate {
        constant: *constant,
        value: ln.exp(),
        standard: standard(i + 1).map(|own| own * ln.exp()),
    };
    std::iter::once(friction).chain(others.map(of)).collect()
}

/// Rounds of solved contacts.
struct Rounds<'a> {
    contacts: Contacts,
    readings: &'a [Reading],
    observer: &'a dyn FitObserver,
    n_solves: usize,
    n_rounds: usize,
    bar: f64,
}

/// Outcome of a round.
struct Round {
    friction: Surrogate,
    boundary: f64,
    x: Vec<f64>,
}

impl Rounds<'_> {
    /// Rounds from the constants of the case to the minimum, and warnings.
    fn run(&mut self, start: Vec<f64>) -> Result<(Round, Vec<String>), StribeckError> {
        let mut centre = start;
        let mut stage = 0;
        loop {
            let range = Range {
                centre: centre.clone(),
                half_width: HALF_WIDTHS[stage],
            };
            let round = self.round(&range, NODES[centre.len() - 1][stage])?;
            let is_outside = range.place(&round.x).iter().any(|t| t.abs() > AT_THE_END);
            let is_last = self.n_rounds >= MOST_ROUNDS;
            if is_last || !is_outside && stage + 1 == HALF_WIDTHS.len() {
                let outside =
                    "the smallest deviation lies at the end of the range that was searched";
                let warnings = is_outside.then(|| outside.to_owned());
                return Ok((round, warnings.into_iter().collect()));
            }
            if self.contacts.are_thermal() {
                self.contacts.set_friction(round.boundary);
            }
            centre = round.x;
            stage += usize::from(!is_outside);
        }
    }

    /// Solves the contacts of a range, and finds the minimum in it.
    fn round(&mut self, range: &Range, n_nodes: usize) -> Result<Round, StribeckError> {
        let nodes = range.nodes(n_nodes);
        let n_points = self.contacts.len();
        self.n_rounds += 1;
        self.n_solves += nodes.len() * n_points;
        self.observer.round(self.n_rounds, nodes.len() * n_points);
        let (mut kept, mut values) = (Vec::new(), Vec::new());
        let mut reason = String::new();
        self.bar = 0.0;
        let all = self.contacts.solve(&nodes, self.observer)?;
        for (node, solved) in nodes.into_iter().zip(all) {
            match solved {
                Ok(solved) => {
                    self.bar = self.bar.max(solved.bar);
                    kept.push(node);
                    values.push(solved.parts);
                }
                Err(why) => reason = why,
            }
        }
        let friction = Surrogate::new(range, n_nodes - 2, &kept, &values).ok_or_else(|| {
            let sigma = crate::words::length(range.centre[0].exp());
            StribeckError::NotConverged(sigma, reason)
        })?;
        let model = Model {
            friction,
            readings: self.readings,
        };
        let (boundary, x) = model.search(range);
        Ok(Round {
            friction: model.friction,
            boundary,
            x,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn poor_fits_have_a_warning() {
        assert!(poor(5.62, true).is_some_and(|words| words.contains("by 5.6 times")));
        assert_eq!(poor(1.2, true), None);
        // Without uncertainties the scatter has no scale.
        assert_eq!(poor(5.62, false), None);
    }
}
