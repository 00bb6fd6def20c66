//! Samples of uncertain inputs by a Latin hypercube (McKay, Beckman and Conover, Technometrics 21 (1979) 239-245).
//!
//! Each input has one sample in each of n intervals of equal probability; the order is random. Correlated inputs are correlated as normal
//! variables, which are then distributed as the inputs are: exact for normal ones, a Gaussian copula for others.

use ertel_input::Input;
use ertel_quantity::Correlation;
use ertel_quantity::{CUT, Uncertainty};
use nalgebra::DMatrix;

use crate::case::study::MOST_POINTS;

/// Samples that cannot be made.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SampleError {
    /// Nothing to vary.
    #[error("no input has an uncertainty: write one as in load = \"100 N ± 5 %\"")]
    NothingUncertain,
    /// Too few or too many.
    #[error("the number of samples must be from 2 to {MOST_SAMPLES}, not {0}")]
    Number(usize),
    /// A sample that no contact can have.
    #[error("a sample of the inputs is no contact ({label}): {reason}")]
    Impossible {
        /// Its values.
        label: String,
        /// Why.
        reason: String,
    },
}

/// Values of the inputs, sample by sample.
pub(super) fn samples(
    inputs: &[&Input],
    correlations: &[Correlation],
    params: &MonteCarloParams,
) -> Result<Vec<Vec<f64>>, SampleError> {
    let (n, k) = (params.n, inputs.len());
    if k == 0 {
        return Err(SampleError::NothingUncertain);
    }
    if !(2..=MOST_SAMPLES).contains(&n) {
        return Err(SampleError::Number(n));
    }
    let mut random = fastrand::Rng::with_seed(params.seed);
    let mut normal = DMatrix::zeros(k, n);
    for row in 0..k {
        let mut strata: Vec<usize> = (0..n).collect();
        random.shuffle(&mut strata);
        for (column, stratum) in strata.into_iter().enumerate() {
            let probability = (stratum as f64 + random.f64()) / n as f64;
            normal[(row, column)] = normal_quantile(probability);
        }
    }
    let normal = factor(inputs, correlations) * normal;
    let value = |input: &Input, z: f64| match input.uncertainty {
        Some(Uncertainty::Normal { standard }) => input.value + standard * z.clamp(-CUT, CUT),
        Some(Uncertainty::Uniform { half_width }) => {
            input.value + half_width * (2.0 * normal_probability(z) - 1.0)
        }
        None => input.value,
    };
    Ok((0..n)
        .map(|column| {
            let row = inputs.iter().enumerate();
            row.map(|(i, input)| value(input, normal[(i, column)]))
                .collect()
        })
        .collect())
}

/// L with L Lᵀ the correlations, from their eigenvectors: these may be singular.
fn factor(inputs: &[&Input], correlations: &[Correlation]) -> DMatrix<f64> {
    let k = inputs.len();
    let mut matrix = DMatrix::<f64>::identity(k, k);
    let place = |key: &str| inputs.iter().position(|input| input.key == key);
    for correlation in correlations {
        let [of, with] = &correlation.keys;
        if let (Some(i), Some(j)) = (place(of), place(with)) {
            matrix[(i, j)] = correlation.coefficient;
            matrix[(j, i)] = correlation.coefficient;
        }
    }
    if correlations.is_empty() {
        return matrix;
    }
    let eigen = matrix.symmetric_eigen();
    let roots = eigen.eigenvalues.map(|value| value.max(0.0).sqrt());
    let mut factor = &eigen.eigenvectors * DMatrix::from_diagonal(&roots);
    // A variance of one, whatever was cut off.
    for mut row in factor.row_iter_mut() {
        let size = row.norm();
        row /= size;
    }
    factor
}

/// Φ(z).
fn normal_probability(z: f64) -> f64 {
    0.5 * libm::erfc(-z / std::f64::consts::SQRT_2)
}

/// Φ⁻¹(p), by bisection: p = 1e-16 lies at −8.2.
fn normal_quantile(probability: f64) -> f64 {
    let (mut low, mut high) = (-9.0, 9.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        match normal_probability(middle) < probability {
            true => low = middle,
            false => high = middle,
        }
    }
    0.5 * (low + high)
}

/// Most samples.
pub const MOST_SAMPLES: usize = MOST_POINTS;

/// How the inputs are sampled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MonteCarloParams {
    /// Number of samples.
    pub n: usize,
    /// The same number makes the same samples.
    pub seed: u64,
}

impl Default for MonteCarloParams {
    fn default() -> Self {
        Self { n: 100, seed: 1 }
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;
    use ertel_quantity::Dimension;

    use super::*;

    fn input(key: &str, value: f64, uncertainty: Uncertainty) -> Input {
        Input {
            key: key.to_owned(),
            value,
            dimension: Dimension::FORCE,
            uncertainty: Some(uncertainty),
            written: true,
            estimated: false,
        }
    }

    /// Printed values of the normal distribution.
    #[test]
    fn quantiles_of_tables() {
        for (p, z) in [(0.5, 0.0), (0.975, 1.959_963_985), (0.001, -3.090_232_306)] {
            assert_relative_eq!(normal_quantile(p), z, epsilon = 1e-9);
        }
    }

    /// One sample in each of n intervals of equal probability; moments of both distributions.
    #[test]
    fn a_latin_hypercube() {
        let (normal, uniform) = (
            input("a", 10.0, Uncertainty::Normal { standard: 2.0 }),
            input("b", 5.0, Uncertainty::Uniform { half_width: 1.0 }),
        );
        let params = MonteCarloParams { n: 400, seed: 7 };
        let samples = samples(&[&normal, &uniform], &[], &params).unwrap();
        let mut strata = vec![[0; 2]; 400];
        let (mut mean, mut square) = ([0.0; 2], [0.0; 2]);
        for sample in &samples {
            let p = [
                normal_probability((sample[0] - 10.0) / 2.0),
                0.5 * (sample[1] - 4.0),
            ];
            for i in 0..2 {
                strata[(p[i] * 400.0) as usize][i] += 1;
                mean[i] += sample[i] / 400.0;
                square[i] += (sample[i] - [10.0, 5.0][i]).powi(2) / 400.0;
            }
        }
        assert!(strata.iter().all(|counts| *counts == [1, 1]));
        // At random they would be off by 0.1.
        assert_relative_eq!(mean[0], 10.0, epsilon = 1e-2);
        assert_relative_eq!(square[0].sqrt(), 2.0, max_relative = 1e-2);
        assert_relative_eq!(square[1].sqrt(), 1.0 / 3.0_f64.sqrt(), max_relative = 1e-3);
        let again = super::samples(&[&normal, &uniform], &[], &params).unwrap();
        assert_eq!(samples, again);
    }

    /// A coefficient of −0.8 is found again in the samples.
    #[test]
    fn correlated_samples() {
        let normal = |key| input(key, 0.0, Uncertainty::Normal { standard: 1.0 });
        let (a, b) = (normal("a"), normal("b"));
        let correlation = Correlation {
            keys: ["b".to_owned(), "a".to_owned()],
            coefficient: -0.8,
        };
        let params = MonteCarloParams { n: 4000, seed: 3 };
        let samples = samples(&[&a, &b], &[correlation], &params).unwrap();
        let product: f64 = samples.iter().map(|s| s[0] * s[1] / 4000.0).sum();
        assert_relative_eq!(product, -0.8, epsilon = 0.02);
    }

    #[test]
    fn nothing_to_sample() {
        let params = MonteCarloParams::default();
        assert_eq!(
            samples(&[], &[], &params),
            Err(SampleError::NothingUncertain)
        );
        let a = input("a", 0.0, Uncertainty::Normal { standard: 1.0 });
        let one = MonteCarloParams { n: 1, ..params };
        assert_eq!(samples(&[&a], &[], &one), Err(SampleError::Number(1)));
    }
}
