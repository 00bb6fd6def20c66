//! Constants of viscosity and density laws from measured states, film-thickness formulas from films, and rough surfaces from Stribeck curves, by least squares.
//!
//! ```
//! use ertel::fit::{Data, LawName, Params, Property, fit};
//!
//! let csv = "pressure_MPa, temperature_degC, viscosity_mPa_s\n0, 40, 10\n100, 40, 49.5\n200, 40, 221\n";
//! let data = Data::parse("oil.csv", csv, Property::Viscosity)?;
//! let result = fit(&data, LawName::Barus, &Params::default())?;
//! let alpha = result.constants.iter().find(|c| c.key == "alpha").unwrap();
//! assert!((alpha.value - 15.5e-9).abs() < 0.2e-9); // 1/Pa
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod data;
mod density;
mod entry;
mod film;
mod header;
mod law;
mod least_squares;
mod picture;
mod ranking;
mod sense;
mod state;
mod stribeck;
mod walther;

pub use data::{Data, DataError};
pub use density::{DensityError, density_of};
pub use entry::{Heading, entry};
pub use film::{
    Estimate, FilmFit, FilmFitError, FilmForm, FilmKind, FilmState, Films, FormError, Given,
    Variable, contact_of_films, contact_of_films_with, fit_film, parity, read_films,
    read_films_with,
};
pub use law::{FittedLaw, LawName};
pub use least_squares::{Minimum, MinimumError, minimise};
pub use picture::picture;
pub use ranking::{Ranked, Ranking, Unranked, rank};
pub use sense::{LARGEST_RMS, nonsense};
pub use state::{Property, Reading, State};
pub use stribeck::{
    FitObserver, FittedPoint, StribeckError, StribeckFit, SurfaceConstant, SurfaceEstimate,
    TARGET_ERROR, fit_stribeck,
};

use ertel_quantity::QuantityError;
use ertel_rheology::density::TaitVolume;
use ertel_rheology::viscosity::PressureLaw;
use ertel_rheology::{DensityLaw, LawError};

use law::{Constant, Model};

/// Condition number of the scaled Jacobian above which a combination of constants is called undetermined. The
/// standard errors are larger by about this factor than those of constants that do not trade off.
const LARGEST_CONDITION: f64 = 1e3;

/// Residual of the sum of squares.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Residual {
    /// `ln(law/measured)`: each state counts by its relative deviation.
    #[default]
    Relative,
    /// `law - measured`: large values count most.
    Absolute,
}

/// How to fit.
#[derive(Clone, Debug, PartialEq)]
pub struct Params {
    /// Constants that keep a value (SI), by key.
    pub held: Vec<(String, f64)>,
    /// Constants to fit that are held by default, by key.
    pub freed: Vec<String>,
    /// Reference temperature of the law (K); without it the isotherm nearest to the middle of the data.
    pub reference_temperature: Option<f64>,
    /// Residual of the sum of squares.
    pub residual: Residual,
    /// Confidence of the intervals, between 0 and 1.
    pub confidence: f64,
    /// Volume for Doolittle's law.
    pub equation_of_state: Option<TaitVolume>,
    /// Density for Walther's law.
    pub density: Option<DensityLaw>,
    /// How the viscosity of Walther's law grows with pressure.
    pub pressure_law: PressureLaw,
}

impl Default for Params {
    fn default() -> Self {
        Self {
            held: Vec::new(),
            freed: Vec::new(),
            reference_temperature: None,
            residual: Residual::Relative,
            confidence: 0.95,
            equation_of_state: None,
            density: None,
            pressure_law: PressureLaw::Roelands,
        }
    }
}

/// Why there is no fit.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum FitError {
    /// The law is one for another property.
    #[error("`{}` is not a law for the {}; choose one of {}", law.name(), property.name(), LawName::choices(*property))]
    WrongProperty {
        /// The law.
        law: LawName,
        /// Property of the data.
        property: Property,
    },
    /// No such constant, or not one in use.
    #[error("the law `{}` has no constant `{key}` to hold or free here; it has {choices}", law.name())]
    UnknownConstant {
        /// The law.
        law: LawName,
        /// The key asked for.
        key: String,
        /// Its constants.
        choices: String,
    },
    /// A value of a constant cannot be read.
    #[error("{key}: {source}")]
    Value {
        /// The constant.
        key: String,
        /// The error.
        source: QuantityError,
    },
    /// Doolittle's law without volume.
    #[error("Doolittle's law needs the volume of the fluid: give a Tait equation of state")]
    NoEquationOfState,
    /// Walther's law without density.
    #[error(
        "Walther's law of the kinematic viscosity needs the density of the fluid: give a density law"
    )]
    NoDensity,
    /// Walther's law with a density that an entry cannot hold.
    #[error(
        "the density of the fluid is a table, which does not fit into an entry: give a formula, such as `tait` or `dowson-higginson`"
    )]
    TabulatedDensity,
    /// No pressures for the coefficient of Walther's law.
    #[error(
        "the data have no pressures above ambient, so they do not determine `alpha` of the law `walther`: hold it, and give the reference temperature at which it holds"
    )]
    NoPressures,
    /// A coefficient is held, but its reference temperature is missing.
    #[error(
        "`alpha` of the law `walther` is fixed: give the reference temperature at which it holds"
    )]
    NoReferenceTemperature,
    /// A constant is held at a value that the law does not allow.
    #[error("the value of a fixed constant is not allowed: {0}")]
    Held(LawError),
    /// The confidence is no probability.
    #[error("the confidence {0} is not between 0 and 1")]
    Confidence(f64),
    /// Fewer states than constants, or none remaining for an estimate of the scatter.
    #[error("{n_states} states cannot determine {n_constants} constants with their intervals; at least {} are needed, or hold some constants", n_constants + 1)]
    TooFew {
        /// Number of states.
        n_states: usize,
        /// Number of constants to fit.
        n_constants: usize,
    },
    /// A constant has no influence on any state.
    #[error("the data do not determine `{key}` of the law `{}`: they do not vary in what it describes, or would make a constant negative that must be positive; hold it", law.name())]
    Undetermined {
        /// The law.
        law: LawName,
        /// The constant.
        key: &'static str,
    },
    /// The search did not end.
    #[error("the fit of the law `{}` did not converge: {reason}", law.name())]
    NotConverged {
        /// The law.
        law: LawName,
        /// Why.
        reason: String,
    },
    /// The fitted law has no value at a state.
    #[error("the law `{}` fitted to the data has no finite value at the state of line {line}: omit it, or fit another law", law.name())]
    NotFinite {
        /// The law.
        law: LawName,
        /// Line of the state in its file.
        line: usize,
    },
    /// A constant, or its interval, is not finite.
    #[error("`{key}` of the law `{}` and its interval are not finite: the data do not determine it; hold it", law.name())]
    NoInterval {
        /// The law.
        law: LawName,
        /// The constant.
        key: &'static str,
    },
    /// The best constants are none that the law allows.
    #[error("the best constants are not allowed: {0}")]
    Law(#[from] LawError),
}

/// A constant of the fitted law.
#[derive(Clone, Debug, PartialEq)]
pub struct FittedConstant {
    /// Key as in data files.
    pub key: &'static str,
    /// Unit in which it is shown and written; empty for a pure number.
    pub unit: &'static str,
    /// Value (SI).
    pub value: f64,
    /// Confidence interval (SI); `None` where the constant was held.
    pub interval: Option<[f64; 2]>,
    /// Standard deviation (SI) of the linearised problem; likewise.
    pub standard: Option<f64>,
}

/// A fitted law.
#[derive(Clone, Debug)]
pub struct Fit {
    /// Which law.
    pub name: LawName,
    /// The law with its constants.
    pub law: FittedLaw,
    /// Its constants, in the order of data files.
    pub constants: Vec<FittedConstant>,
    /// Reference temperature (K) where the law has one.
    pub reference_temperature: Option<f64>,
    /// `law/measured - 1` of every state, in the order of the data.
    pub deviations: Vec<f64>,
    /// Condition number of the Jacobian with columns of unit length.
    pub condition: f64,
    /// Coefficients of correlation of each pair of constants that were fitted, by their places.
    pub correlations: Vec<([usize; 2], f64)>,
    /// Warnings on constants that the data do not determine.
    pub warnings: Vec<String>,
    /// Confidence of the intervals.
    pub confidence: f64,
    /// Residual of the sum of squares.
    pub residual: Residual,
}

impl Fit {
    /// Root mean square of the relative deviations.
    pub fn rms(&self) -> f64 {
        let n = self.deviations.len() as f64;
        (self.deviations.iter().map(|d| d * d).sum::<f64>() / n).sqrt()
    }

    /// Place and value of the largest relative deviation.
    pub fn worst(&self) -> (usize, f64) {
        let worst = self.deviations.iter().copied().enumerate();
        worst
            .max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()))
            .unwrap_or((0, 0.0))
    }
}

/// Value (SI) of the constant `key` of a law from text such as `"0.465 mPa.s"`.
///
/// # Errors
///
/// [`FitError::UnknownConstant`] and [`FitError::Value`].
pub fn parse_constant(law: LawName, key: &str, text: &str) -> Result<f64, FitError> {
    law::parse_constant(law, key, text)
}

/// Fits the constants of `law` to the data.
///
/// Constants that must be positive are fitted by their logarithm; their intervals are symmetric on that scale.
/// Intervals are those of the linearised problem, with Student's t and the scatter of the residuals.
///
/// # Errors
///
/// [`FitError`]: unusable requests, too few states, constants without influence, no convergence, forbidden values.
pub fn fit(data: &Data, law: LawName, params: &Params) -> Result<Fit, FitError> {
    if law.property() != data.property {
        return Err(FitError::WrongProperty {
            law,
            property: data.property,
        });
    }
    if !(params.confidence > 0.0 && params.confidence < 1.0) {
        return Err(FitError::Confidence(params.confidence));
    }
    let model = Model::new(data, law, params)?;
    let free: Vec<usize> = (0..model.constants.len())
        .filter(|i| !model.constants[*i].held)
        .collect();
    if data.states.len() <= free.len() {
        return Err(FitError::TooFew {
            n_states: data.states.len(),
            n_constants: free.len(),
        });
    }
    let is_held = |key: &str| params.held.iter().any(|(held, _)| held == key);
    if let Err(error) = model.build(&model.values(&free, &[]))
        && is_held(error.key())
    {
        return Err(FitError::Held(error));
    }
    let minimum = search(data, &model, &free, params).map_err(|error| match error {
        MinimumError::NoInfluence(i) => FitError::Undetermined {
            law,
            key: model.constants[free[i]].key,
        },
        MinimumError::NotConverged(reason) => FitError::NotConverged { law, reason },
    })?;
    let best = model.values(&free, &minimum.x);
    let fitted = model.build_checked(&best)?;
    let constants = fitted_constants(&model, &free, &best, &minimum);
    let correlations = (0..free.len())
        .flat_map(|j| (0..j).map(move |k| [k, j]))
        .map(|[k, j]| ([free[k], free[j]], minimum.correlation(k, j)))
        .collect();
    let deviation =
        |s: &State| (fitted.ln_value(s.pressure, s.temperature) - s.value.ln()).exp_m1();
    let deviations: Vec<f64> = data.states.iter().map(deviation).collect();
    if let Some(i) = deviations.iter().position(|d| !d.is_finite()) {
        let line = data.states[i].line;
        return Err(FitError::NotFinite { law, line });
    }
    let is_finite = |c: &FittedConstant| {
        let ends = c.interval.unwrap_or_default();
        c.value.is_finite() && ends.iter().all(|end| end.is_finite())
    };
    if let Some(constant) = constants.iter().find(|c| !is_finite(c)) {
        let key = constant.key;
        return Err(FitError::NoInterval { law, key });
    }
    let mut warnings = warnings(&minimum, &free, &model.constants, &constants);
    let [low, high] = data.temperature_range();
    if !law.is_thermal() && high - low > law::ISOTHERM {
        warnings.push(format!(
            "the law `{}` does not depend on temperature, but the data go from {:.1} °C to {:.1} °C: fit one isotherm, or `cheng`",
            law.name(),
            low - 273.15,
            high - 273.15
        ));
    }
    Ok(Fit {
        name: law,
        law: fitted,
        warnings,
        constants,
        correlations,
        reference_temperature: model.reference_temperature(),
        deviations,
        condition: minimum.condition,
        confidence: params.confidence,
        residual: params.residual,
    })
}

/// The best free constants.
fn search(
    data: &Data,
    model: &Model,
    free: &[usize],
    params: &Params,
) -> Result<Minimum, MinimumError> {
    let measured = data.states.iter().map(|s| s.value);
    let mean = measured.sum::<f64>() / data.states.len() as f64;
    let residuals = |x: &[f64], r: &mut [f64]| {
        let law = model.build(&model.values(free, x)).ok();
        for (r, state) in r.iter_mut().zip(&data.states) {
            // A forbidden constant or an overflow counts as very bad: the step is refused.
            *r = law.as_ref().map_or(f64::INFINITY, |law| {
                let ln = law.ln_value(state.pressure, state.temperature);
                match params.residual {
                    Residual::Relative => ln - state.value.ln(),
                    Residual::Absolute => (ln.exp() - state.value) / mean,
                }
            });
            *r = if r.is_finite() {
                r.clamp(-1e6, 1e6)
            } else {
                1e6
            };
        }
    };
    let start: Vec<f64> = free
        .iter()
        .map(|i| model.constants[*i].scaled(model.constants[*i].start))
        .collect();
    minimise(data.states.len(), &start, params.confidence, residuals)
}

/// The constants with the intervals of the free ones.
fn fitted_constants(
    model: &Model,
    free: &[usize],
    best: &[f64],
    minimum: &Minimum,
) -> Vec<FittedConstant> {
    let mut constants: Vec<FittedConstant> = model
        .constants
        .iter()
        .zip(best)
        .map(|(constant, value)| FittedConstant {
            key: constant.key,
            unit: constant.unit,
            value: *value,
            interval: None,
            standard: None,
        })
        .collect();
    for (j, i) in free.iter().enumerate() {
        let half = minimum.half_widths[j];
        let ends = [minimum.x[j] - half, minimum.x[j] + half];
        constants[*i].interval = Some(ends.map(|x| model.constants[*i].unscaled(x)));
        let step = 1e-6;
        let sides = [-step, step].map(|s| model.constants[*i].unscaled(minimum.x[j] + s));
        let slope = (sides[1] - sides[0]) / (2.0 * step);
        constants[*i].standard = Some(minimum.standard(j) * slope.abs());
    }
    constants
}

/// Warnings on constants that the data do not determine.
fn warnings(
    minimum: &Minimum,
    free: &[usize],
    constants: &[Constant],
    fitted: &[FittedConstant],
) -> Vec<String> {
    let mut warnings = Vec::new();
    if minimum.condition > LARGEST_CONDITION {
        let keys = minimum.trading(free.iter().map(|i| constants[*i].key));
        warnings.push(format!(
            "the data hardly determine {} separately (condition number {:.0e}): the others compensate a change of one; \
             hold some, or measure over a wider range",
            keys.join(", "),
            minimum.condition
        ));
    }
    for i in free {
        let constant = &fitted[*i];
        if let Some([low, high]) = constant.interval
            && constants[*i].is_positive()
            && high > 10.0 * low
        {
            warnings.push(format!(
                "the data do not determine {}: its interval spans a factor of {}",
                constant.key,
                crate::words::digits(high / low, 2)
            ));
        }
    }
    warnings
}
