//! The blend of asymptotes.

use super::found::{Estimate, FilmFitError, Found, LARGEST_CONDITION, LARGEST_EFFECT, moved};
use super::table::Films;
use crate::contact::Family;
use crate::fit::{Minimum, MinimumError, minimise};
use crate::reference::{Asymptotes, moes_line_asymptotes, nijenbanning_venner_moes_asymptotes};
use crate::words::digits;

/// Exponents s that the search starts from: published blends have 1.4 to 3.
const STARTS: [f64; 3] = [1.0, 2.0, 4.0];

/// Fits ln c_1, ln c_2 and ln s, from the published asymptotes.
pub(super) fn fit(films: &Films, family: Family, confidence: f64) -> Result<Found, FilmFitError> {
    let names = films.form.constants();
    let n_states = films.states.len();
    if n_states <= names.len() {
        return Err(FilmFitError::TooFew {
            n_states,
            n_unknowns: names.len(),
        });
    }
    let Asymptotes {
        isoviscous_elastic,
        piezoviscous_elastic,
        ..
    } = match family {
        Family::Point => nijenbanning_venner_moes_asymptotes(1.0, 1.0, 1.0),
        Family::Cylinder => moes_line_asymptotes(1.0, 1.0),
    };
    let residuals = |x: &[f64], r: &mut [f64]| {
        let constants = [x[0].exp(), x[1].exp(), x[2].exp()];
        for (r, state) in r.iter_mut().zip(&films.states) {
            *r = (films.form.film(&constants, state) / state.film).ln();
        }
    };
    let mut best: Result<Minimum, MinimumError> =
        Err(MinimumError::NotConverged("no minimum".to_owned()));
    for s in STARTS {
        let start = [isoviscous_elastic.ln(), piezoviscous_elastic.ln(), s.ln()];
        let found = minimise(n_states, &start, confidence, residuals);
        let better = match (&found, &best) {
            (Ok(found), Ok(best)) => found.scatter < best.scatter,
            (_, Err(_)) => true,
            (Err(_), Ok(_)) => false,
        };
        if better {
            best = found;
        }
    }
    let minimum = best.map_err(|error| match error {
        MinimumError::NoInfluence(i) => FilmFitError::Undetermined(names[i]),
        error => FilmFitError::Minimum(error),
    })?;
    let mut warnings = Vec::new();
    let (mut constants, mut widened) = (Vec::new(), Vec::new());
    for (i, name) in names.iter().enumerate() {
        let (log, half) = (minimum.x[i], minimum.half_widths[i]);
        let estimate = Estimate::of_log(log, half);
        let [low, high] = estimate.interval;
        if 2.0 * half > LARGEST_EFFECT {
            warnings.push(format!(
                "the data hardly determine {name}: it lies between {} and {}",
                digits(low, 3),
                digits(high, 3)
            ));
        }
        constants.push(Some(estimate));
        let wide = half + moved(films, &minimum, i);
        widened.push(Some(Estimate::of_log(log, wide).interval));
    }
    if minimum.condition > LARGEST_CONDITION {
        warnings.push(format!(
            "{} trade off (condition number {})",
            minimum.trading(names.iter().copied()).join(" and "),
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
