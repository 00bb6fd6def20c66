//! A fitted formula, or why there is none.

use super::{FilmForm, FilmKind, Films};
use crate::contact::Family;
use crate::fit::{Minimum, MinimumError};

/// Condition number of the scaled columns above which constants are called hardly separable: the intervals are about
/// this many times wider than those of independent variation.
pub(super) const LARGEST_CONDITION: f64 = 30.0;

/// Share of the film by which an uncertain constant may move it over the range of the films before a warning.
pub(super) const LARGEST_EFFECT: f64 = 0.2;

/// A number with its confidence interval.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// The number.
    pub value: f64,
    /// Lower and upper end.
    pub interval: [f64; 2],
}

impl Estimate {
    /// Of a number whose logarithm is known within ± `half`.
    pub(super) fn of_log(log: f64, half: f64) -> Estimate {
        Estimate {
            value: log.exp(),
            interval: [(log - half).exp(), (log + half).exp()],
        }
    }
}

/// A formula with its constants.
#[derive(Clone, Debug, PartialEq)]
pub struct FilmFit {
    /// Its form.
    pub form: FilmForm,
    /// Which film.
    pub kind: FilmKind,
    /// The constants in the order of [`FilmForm::constants`]; `None` for the exponent of a variable that does not vary,
    /// whose power is then part of c.
    pub constants: Vec<Option<Estimate>>,
    /// The intervals widened by what the error bars of the films do at most, all of them in the worst direction; `None`
    /// where a film has no error bar. Errors of discretisation are no scatter: those of like contacts have one sign.
    pub widened: Option<Vec<Option<[f64; 2]>>>,
    /// Smallest and largest value of each variable.
    pub ranges: Vec<[f64; 2]>,
    /// `formula/film - 1` of every state.
    pub deviations: Vec<f64>,
    /// Confidence of the intervals.
    pub confidence: f64,
    /// Warnings on constants that the films do not determine.
    pub warnings: Vec<String>,
}

impl FilmFit {
    /// Values of the constants, 0 for exponents that are not determined.
    pub fn values(&self) -> Vec<f64> {
        let value = |e: &Option<Estimate>| e.map_or(0.0, |e| e.value);
        self.constants.iter().map(value).collect()
    }

    /// A formula in Moes' groups in those of Hamrock and Dowson, `h = k R U^u G^g W^w`, by `M = W (2U)^(-3/4)`, in line
    /// contacts `W (2U)^(-1/2)`, and `L = G (2U)^(1/4)`: the constants k, u, g, w. `None` of another form.
    pub fn hamrock_dowson(&self, family: Family) -> Option<[f64; 4]> {
        if self.form != FilmForm::Moes {
            return None;
        }
        let [c, a, b] = self.values()[..] else {
            return None;
        };
        let speed = 0.5 - family.moes_power() * a + 0.25 * b;
        Some([c * 2f64.powf(speed), speed, b, a])
    }

    /// Root mean square of the deviations.
    pub fn rms(&self) -> f64 {
        let n = self.deviations.len() as f64;
        (self.deviations.iter().map(|d| d * d).sum::<f64>() / n).sqrt()
    }

    /// Largest deviation by size.
    pub fn largest(&self) -> f64 {
        self.deviations
            .iter()
            .copied()
            .max_by(|a, b| a.abs().total_cmp(&b.abs()))
            .unwrap_or(0.0)
    }
}

/// Why there is no formula.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum FilmFitError {
    /// Too few films.
    #[error("{n_states} films cannot determine {n_unknowns} constants with their intervals; at least {} are needed", n_unknowns + 1)]
    TooFew {
        /// Number of films.
        n_states: usize,
        /// Number of constants.
        n_unknowns: usize,
    },
    /// Collinear variables, by their symbols.
    #[error(
        "{0} are powers of each other in all films: their exponents cannot be determined separately; vary one without the other, or \
         use a form with fewer exponents"
    )]
    Collinear(String),
    /// A constant that no film depends on, by its name.
    #[error(
        "no film depends on {0}: it cannot be determined; vary M and L more, or use another form"
    )]
    Undetermined(&'static str),
    /// A constant of ellipses that no film depends on, by its name.
    #[error(
        "no film depends on {0}: it cannot be determined; vary speed, load, R_y/R_x and the angle, or use the form \
         `hamrock-dowson` for ellipses of one shape"
    )]
    Unvaried(&'static str),
    /// Constants of ellipses that compensate each other in all films.
    #[error(
        "{0} compensate each other in all films: they cannot be determined separately; vary speed, load, R_y/R_x and the angle one \
         without the other, or use the form `hamrock-dowson` for ellipses of one shape"
    )]
    Inseparable(String),
    /// The confidence is no probability.
    #[error("the confidence {0} is not between 0 and 1")]
    Confidence(f64),
    /// The formula has no value at a film, from 1.
    #[error(
        "the formula fitted to the films has no finite value at film {0}: omit it, or use another form"
    )]
    NotFinite(usize),
    /// A constant or its interval is not finite, by its name.
    #[error("{0} and its interval are not finite: the films do not determine it; use another form")]
    NoInterval(&'static str),
    /// The search did not end.
    #[error(transparent)]
    Minimum(#[from] MinimumError),
}

/// Result of a least-squares solve of one kind of form.
pub(super) struct Found {
    /// As in [`FilmFit`].
    pub(super) constants: Vec<Option<Estimate>>,
    /// The intervals widened by error bars; none without these.
    pub(super) widened: Vec<Option<[f64; 2]>>,
    /// `ln(formula/film)`.
    pub(super) residuals: Vec<f64>,
    /// As in [`FilmFit`].
    pub(super) warnings: Vec<String>,
}

/// How far the error bars of the films move an unknown at most; 0 where they have none.
pub(super) fn moved(films: &Films, minimum: &Minimum, unknown: usize) -> f64 {
    let weights = films.states.iter().zip(&minimum.sensitivity[unknown]);
    weights
        .map(|(state, weight)| weight.abs() * state.error.unwrap_or(0.0))
        .sum()
}
