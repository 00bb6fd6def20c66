//! First-order propagation of the uncertainty of the inputs.
//!
//! ```text
//!   u² = Σ_i Σ_j g_i g_j ρ_ij σ_i σ_j,      g_i = ∂figure/∂input_i
//! ```
//! (JCGM 100:2008, eq. 13). The half-width of the 95 % interval is 2u.

use ertel_quantity::COVERAGE;
use ertel_quantity::Correlation;
use serde::Serialize;
use serde::ser::{SerializeMap, Serializer};

use super::sensitivities::ByKey;
use super::{Figure, Sensitivities};

/// Uncertainties of the figures.
#[derive(Clone, Debug, PartialEq)]
pub struct Uncertainties(pub Vec<FigureUncertainty>);

/// Uncertainty of a figure.
#[derive(Clone, Debug, PartialEq)]
pub struct FigureUncertainty {
    /// The figure.
    pub figure: Figure,
    /// Its value, SI.
    pub value: f64,
    /// Half-width of the interval that holds it with a probability of 95 %, SI.
    pub half_width: f64,
    /// Keys of the uncertain inputs with their shares of u², the largest first; they add up to one.
    pub shares: Vec<(String, f64)>,
}

impl Uncertainties {
    /// By the derivatives of the figures; `None` where no input has an uncertainty.
    pub fn first_order(
        sensitivities: &Sensitivities,
        correlations: &[Correlation],
    ) -> Option<Uncertainties> {
        let inputs = &sensitivities.inputs;
        let uncertain: Vec<(usize, f64)> = (inputs.iter().enumerate())
            .filter_map(|(i, input)| Some((i, input.uncertainty?.standard())))
            .collect();
        if uncertain.is_empty() {
            return None;
        }
        let correlation = |i: usize, j: usize| {
            let [a, b] = [&inputs[i].key, &inputs[j].key];
            let given = correlations.iter().find(|c| {
                let [of, with] = &c.keys;
                (of == a && with == b) || (of == b && with == a)
            });
            if i == j {
                1.0
            } else {
                given.map_or(0.0, |c| c.coefficient)
            }
        };
        let of = |figure: &super::FigureSensitivity| {
            let effect = |(i, standard): &(usize, f64)| figure.derivatives[*i] * standard;
            let parts: Vec<f64> = (uncertain.iter())
                .map(|one| {
                    let others = uncertain.iter();
                    let with: f64 = others
                        .map(|other| correlation(one.0, other.0) * effect(other))
                        .sum();
                    effect(one) * with
                })
                .collect();
            let square: f64 = parts.iter().sum::<f64>().max(0.0);
            let share = |part: f64| if square > 0.0 { part / square } else { 0.0 };
            let mut shares: Vec<(String, f64)> = (uncertain.iter().zip(&parts))
                .map(|((i, _), part)| (inputs[*i].key.clone(), share(*part)))
                .collect();
            shares.sort_by(|a, b| b.1.abs().total_cmp(&a.1.abs()));
            FigureUncertainty {
                figure: figure.figure,
                value: figure.value,
                half_width: COVERAGE * square.sqrt(),
                shares,
            }
        };
        Some(Uncertainties(
            sensitivities.figures.iter().map(of).collect(),
        ))
    }

    /// That of a figure.
    pub fn get(&self, figure: Figure) -> Option<&FigureUncertainty> {
        self.0.iter().find(|u| u.figure == figure)
    }
}

/// For each figure its value, the half-width of its 95 % interval, and the shares of the inputs.
impl Serialize for Uncertainties {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(self.0.len()))?;
        for figure in &self.0 {
            let shares = figure
                .shares
                .iter()
                .map(|(key, share)| (key.as_str(), *share));
            let entry = Written {
                value: figure.value,
                half_width: figure.half_width,
                shares: ByKey(shares.collect()),
            };
            map.serialize_entry(figure.figure.name(), &entry)?;
        }
        map.end()
    }
}

/// The uncertainty of a figure as it is written.
#[derive(Serialize)]
struct Written<'a> {
    value: f64,
    half_width: f64,
    shares: ByKey<'a>,
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;
    use ertel_quantity::Uncertainty;

    use super::*;
    use crate::solution::{FigureSensitivity, SensitivityInput, SensitivityMethod};

    fn sensitivities() -> Sensitivities {
        let input = |key: &str, value: f64, standard: Option<f64>| SensitivityInput {
            key: key.to_owned(),
            value,
            unit: String::new(),
            uncertainty: standard.map(|standard| Uncertainty::Normal { standard }),
        };
        Sensitivities {
            by: SensitivityMethod::LinearSolves,
            inputs: vec![
                input("a", 2.0, Some(0.1)),
                input("b", 5.0, Some(0.2)),
                input("c", 1.0, None),
            ],
            figures: vec![FigureSensitivity {
                figure: Figure::FilmCentral,
                value: 10.0,
                derivatives: vec![3.0, -2.0, 7.0],
            }],
            left_out: Vec::new(),
        }
    }

    /// By hand: effects 0.3 and −0.4 of one standard deviation each; u = 0.5, and with ρ = 0.5 u² = 0.09 + 0.16 − 0.12.
    #[test]
    fn two_inputs_by_hand() {
        let found = Uncertainties::first_order(&sensitivities(), &[]).unwrap();
        let film = found.get(Figure::FilmCentral).unwrap();
        assert_relative_eq!(film.half_width, 1.0, max_relative = 1e-14);
        assert_eq!(film.shares[0].0, "b");
        assert_relative_eq!(film.shares[0].1, 0.64, max_relative = 1e-14);
        let correlation = Correlation {
            keys: ["b".to_owned(), "a".to_owned()],
            coefficient: 0.5,
        };
        let found = Uncertainties::first_order(&sensitivities(), &[correlation]).unwrap();
        let film = found.get(Figure::FilmCentral).unwrap();
        assert_relative_eq!(film.half_width, 2.0 * 0.13_f64.sqrt(), max_relative = 1e-14);
        let sum: f64 = film.shares.iter().map(|(_, share)| share).sum();
        assert_relative_eq!(sum, 1.0, max_relative = 1e-14);
    }

    #[test]
    fn logarithms_and_order() {
        let sensitivities = sensitivities();
        let found = sensitivities.logarithmic(&sensitivities.figures[0]);
        let keys: Vec<&str> = found.iter().map(|(key, _)| *key).collect();
        assert_eq!(keys, ["b", "c", "a"]);
        assert_relative_eq!(found[0].1, -1.0);
        assert_relative_eq!(found[2].1, 0.6);
    }
}
