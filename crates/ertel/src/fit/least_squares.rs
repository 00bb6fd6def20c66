//! Nonlinear least squares with confidence intervals.

use faer::Mat;
use rmpfit::{MPConfig, MPFitter, MPPar, MPResult, MPSide, MPSuccess};

/// Step of the central differences, for unknowns of order one: truncation and rounding are near 1e-11.
const STEP: f64 = 1e-5;

/// Iterations, at most.
const MOST_ITERATIONS: usize = 2000;
/// Residuals evaluated, at most, all evaluations together: a second at most. Data that determine their constants take a
/// thousand evaluations; a diverging search should not take minutes because a table is long.
const MOST_RESIDUALS: usize = 2_000_000;
/// Evaluations that are always allowed.
const LEAST_EVALUATIONS: usize = 1000;

/// Where the sum of squares is smallest, and how well that is known.
#[derive(Clone, Debug, PartialEq)]
pub struct Minimum {
    /// The unknowns.
    pub x: Vec<f64>,
    /// The residuals there.
    pub residuals: Vec<f64>,
    /// Half-widths of the confidence intervals: Student's t times standard error.
    pub half_widths: Vec<f64>,
    /// Standard deviation of the residuals, `√(Σr²/(n - k))`.
    pub scatter: f64,
    /// Condition number of the Jacobian with its columns scaled to length 1.
    pub condition: f64,
    /// By how much each unknown moves with each residual: the pseudo-inverse of the Jacobian, by unknown, then residual.
    pub sensitivity: Vec<Vec<f64>>,
    /// The direction least determined: components by unknown, of length 1, in units of the scaled columns.
    pub weakest: Vec<f64>,
}

/// Share of the least determined direction from which an unknown is named as part of it.
const LEAST_SHARE: f64 = 0.2;

impl Minimum {
    /// Standard deviation of an unknown: with the pseudo-inverse J⁺ of the Jacobian, the covariance is s² J⁺ J⁺ᵀ.
    pub fn standard(&self, unknown: usize) -> f64 {
        self.scatter * dot(&self.sensitivity[unknown], &self.sensitivity[unknown]).sqrt()
    }

    /// Coefficient of correlation of two unknowns.
    pub fn correlation(&self, one: usize, other: usize) -> f64 {
        let [a, b] = [&self.sensitivity[one], &self.sensitivity[other]];
        dot(a, b) / (dot(a, a) * dot(b, b)).sqrt()
    }

    /// Names of the unknowns that trade off most, of `names` by unknown: a change of one of them is nearly made
    /// up for by the others.
    pub fn trading<'n>(&self, names: impl IntoIterator<Item = &'n str>) -> Vec<&'n str> {
        let shares = names.into_iter().zip(&self.weakest);
        let named = shares.filter(|(_, share)| share.abs() > LEAST_SHARE);
        named.map(|(name, _)| name).collect()
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Why there is no minimum.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum MinimumError {
    /// This unknown changes no residual.
    #[error("unknown {0} has no influence")]
    NoInfluence(usize),
    /// The search did not end.
    #[error("{0}")]
    NotConverged(String),
}

/// Unknowns `x` for which `Σ r(x)²` of `n_residuals` residuals is smallest, by the Levenberg-Marquardt method (Moré 1978).
///
/// The unknowns should be of order one. Intervals hold with probability `confidence` if the residuals scatter normally and
/// the problem is linear over the interval: `t s √[(JᵀJ)⁻¹]ᵢᵢ`, `s² = Σr²/(n - k)`. `n_residuals` must exceed the number of
/// unknowns; without unknowns the residuals are evaluated.
///
/// # Errors
///
/// [`MinimumError`].
pub fn minimise(
    n_residuals: usize,
    start: &[f64],
    confidence: f64,
    residuals: impl Fn(&[f64], &mut [f64]),
) -> Result<Minimum, MinimumError> {
    let n_unknowns = start.len();
    let mut x = start.to_vec();
    if n_unknowns > 0 {
        let mut problem = Problem {
            n_residuals,
            residuals: &residuals,
            config: MPConfig {
                ftol: 1e-14,
                xtol: 1e-11,
                gtol: 1e-13,
                max_iter: MOST_ITERATIONS,
                max_fev: rmpfit::MPMaxFev::Limited(
                    (MOST_RESIDUALS / n_residuals.max(1)).max(LEAST_EVALUATIONS),
                ),
                ..MPConfig::new()
            },
            parameters: (0..n_unknowns)
                .map(|_| MPPar {
                    step: STEP,
                    side: MPSide::Both,
                    ..MPPar::new()
                })
                .collect(),
        };
        let status = problem
            .mpfit(&mut x)
            .map_err(|error| MinimumError::NotConverged(error.to_string()))?;
        if status.success == MPSuccess::MaxIter {
            return Err(MinimumError::NotConverged(format!(
                "no minimum after {} iterations",
                status.n_iter
            )));
        }
    }
    evaluated(n_residuals, x, confidence, residuals)
}

/// How well the unknowns are known at a minimum that was found otherwise, as [`minimise`] finds it.
///
/// # Errors
///
/// [`MinimumError`].
pub fn evaluated(
    n_residuals: usize,
    x: Vec<f64>,
    confidence: f64,
    residuals: impl Fn(&[f64], &mut [f64]),
) -> Result<Minimum, MinimumError> {
    let n_unknowns = x.len();
    let mut r = vec![0.0; n_residuals];
    residuals(&x, &mut r);
    let freedom = n_residuals.saturating_sub(n_unknowns);
    let scatter = (r.iter().map(|r| r * r).sum::<f64>() / freedom as f64).sqrt();
    let mut minimum = Minimum {
        half_widths: vec![0.0; n_unknowns],
        scatter,
        condition: 1.0,
        sensitivity: vec![vec![0.0; n_residuals]; n_unknowns],
        weakest: vec![0.0; n_unknowns],
        residuals: r,
        x,
    };
    if n_unknowns > 0 {
        uncertainty(&mut minimum, student_t(confidence, freedom), &residuals)?;
    }
    Ok(minimum)
}

/// Half-widths, condition and the weakest direction from the singular values of the Jacobian.
fn uncertainty(
    minimum: &mut Minimum,
    t: f64,
    residuals: &impl Fn(&[f64], &mut [f64]),
) -> Result<(), MinimumError> {
    let (m, n) = (minimum.residuals.len(), minimum.x.len());
    let mut jacobian = Mat::<f64>::zeros(m, n);
    let mut lengths = vec![0.0; n];
    for j in 0..n {
        let shifted = |step: f64| {
            let mut x = minimum.x.clone();
            x[j] += step;
            let mut r = vec![0.0; m];
            residuals(&x, &mut r);
            r
        };
        let column: Vec<f64> = shifted(STEP)
            .iter()
            .zip(shifted(-STEP))
            .map(|(up, down)| (up - down) / (2.0 * STEP))
            .collect();
        lengths[j] = column.iter().map(|v| v * v).sum::<f64>().sqrt();
        // Below the rounding of the differences there is no influence.
        if lengths[j] < 1e-9 {
            return Err(MinimumError::NoInfluence(j));
        }
        for (i, v) in column.iter().enumerate() {
            jacobian[(i, j)] = v / lengths[j];
        }
    }
    let svd = jacobian
        .thin_svd()
        .map_err(|_| MinimumError::NotConverged("no singular values of the Jacobian".into()))?;
    let (singular, u, v) = (svd.S().column_vector(), svd.U(), svd.V());
    let smallest = singular[n - 1].max(f64::MIN_POSITIVE);
    minimum.condition = singular[0] / smallest;
    minimum.weakest = (0..n).map(|j| v[(j, n - 1)]).collect();
    for j in 0..n {
        let inverse: f64 = (0..n)
            .map(|k| (v[(j, k)] / singular[k].max(f64::MIN_POSITIVE)).powi(2))
            .sum();
        minimum.half_widths[j] = t * minimum.scatter * inverse.sqrt() / lengths[j];
        for i in 0..m {
            let moved: f64 = (0..n)
                .map(|k| v[(j, k)] * u[(i, k)] / singular[k].max(f64::MIN_POSITIVE))
                .sum();
            minimum.sensitivity[j][i] = moved / lengths[j];
        }
    }
    Ok(())
}

/// Student's t with `freedom` degrees: `|T| < t` with probability `confidence`.
fn student_t(confidence: f64, freedom: usize) -> f64 {
    // The probability grows with the angle θ = atan(t/√ν) from 0 to π/2.
    let (mut low, mut high) = (0.0, std::f64::consts::FRAC_PI_2);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if student_probability(middle, freedom) < confidence {
            low = middle;
        } else {
            high = middle;
        }
    }
    (freedom as f64).sqrt() * low.tan()
}

/// Probability of `|T| < t` with ν degrees of freedom, `θ = atan(t/√ν)` (Abramowitz and Stegun 1964, eqs. 26.7.3, 26.7.4):
///
/// ```text
/// ν odd:  2/π {θ + sin θ [cos θ + 2/3 cos³θ + ... + (2·4···(ν-3))/(3·5···(ν-2)) cos^(ν-2) θ]}
/// ν even: sin θ {1 + 1/2 cos²θ + ... + (1·3···(ν-3))/(2·4···(ν-2)) cos^(ν-2) θ}
/// ```
fn student_probability(theta: f64, freedom: usize) -> f64 {
    let (sin, cos) = theta.sin_cos();
    let odd = freedom % 2 == 1;
    let (mut power, mut term) = if odd { (1, cos) } else { (0, 1.0) };
    let mut sum = 0.0;
    while power + 2 <= freedom {
        sum += term;
        term *= cos * cos * (power + 1) as f64 / (power + 2) as f64;
        power += 2;
    }
    if odd {
        (theta + sin * sum) * std::f64::consts::FRAC_2_PI
    } else {
        sin * sum
    }
}

/// The problem as the library takes it.
struct Problem<'a, F> {
    n_residuals: usize,
    residuals: &'a F,
    config: MPConfig,
    parameters: Vec<MPPar>,
}

impl<F: Fn(&[f64], &mut [f64])> MPFitter for Problem<'_, F> {
    fn eval(&mut self, params: &[f64], deviates: &mut [f64]) -> MPResult<()> {
        (self.residuals)(params, deviates);
        Ok(())
    }

    fn number_of_points(&self) -> usize {
        self.n_residuals
    }

    fn config(&self) -> &MPConfig {
        &self.config
    }

    fn parameters(&self) -> &[MPPar] {
        &self.parameters
    }
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;

    use super::*;

    /// Residuals that bend away from every step: the search ends after so many evaluations as a long table affords.
    #[test]
    fn a_search_that_strays_ends() {
        let n_evaluations = Cell::new(0);
        let n_residuals = 100_000;
        let found = minimise(n_residuals, &[1.0, 1.0], 0.95, |x, r| {
            n_evaluations.set(n_evaluations.get() + 1);
            r.fill(0.0);
            // Rosenbrock's valley, without end.
            (r[0], r[1]) = (1e3 * (x[1] - x[0] * x[0]), (-x[0] / 1e4).exp());
        });
        assert!(
            matches!(found, Err(MinimumError::NotConverged(_))),
            "{found:?}"
        );
        assert!(
            n_evaluations.get() < 2 * LEAST_EVALUATIONS,
            "{n_evaluations:?}"
        );
    }

    /// Printed tables of Student's t.
    #[test]
    fn student_t_is_that_of_tables() {
        for (confidence, freedom, t) in [
            (0.95, 1, 12.706),
            (0.95, 10, 2.228),
            (0.99, 5, 4.032),
            (0.90, 30, 1.697),
        ] {
            assert!((student_t(confidence, freedom) - t).abs() < 6e-4, "{t}");
        }
    }

    /// A straight line by hand: x = 0, 1, 2, y = 0, 2, 1: slope 1/2, intercept 1/2, Σr² = 3/2,
    /// s² = 3/2, standard errors √(s²/2) and √(s² 5/6).
    #[test]
    fn straight_line_by_hand() {
        let y = [0.0, 2.0, 1.0];
        let minimum = minimise(3, &[0.0, 0.0], 0.95, |x, r| {
            for (i, r) in r.iter_mut().enumerate() {
                *r = x[0] + x[1] * i as f64 - y[i];
            }
        })
        .unwrap();
        let t = 12.7062;
        for (value, expected) in minimum.x.iter().zip([0.5, 0.5]) {
            assert!((value - expected).abs() < 1e-9, "{value}");
        }
        for (half, variance) in minimum.half_widths.iter().zip([1.25f64, 0.75]) {
            assert!((half / (t * variance.sqrt()) - 1.0).abs() < 1e-5);
        }
        // Intercept Σ(5/6, 1/3, -1/6) y, slope Σ(-1/2, 0, 1/2) y.
        let expected = [[5.0 / 6.0, 1.0 / 3.0, -1.0 / 6.0], [-0.5, 0.0, 0.5]];
        for (row, expected) in minimum.sensitivity.iter().zip(expected) {
            for (value, expected) in row.iter().zip(expected) {
                assert!((value - expected).abs() < 1e-9, "{value}");
            }
        }
    }

    #[test]
    fn an_unknown_without_influence_is_named() {
        let error = minimise(3, &[0.0, 1.0], 0.95, |x, r| {
            r.copy_from_slice(&[x[0], x[0] - 1.0, x[0] + 1.0])
        });
        assert_eq!(error, Err(MinimumError::NoInfluence(1)));
    }
}
