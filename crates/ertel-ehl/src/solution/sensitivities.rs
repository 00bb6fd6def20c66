//! How much each input counts.

use ertel_quantity::Uncertainty;
use serde::ser::{Serialize, SerializeMap, Serializer};

use super::Figure;

/// Derivatives of figures by the inputs of a case.
#[derive(Clone, Debug, PartialEq)]
pub struct Sensitivities {
    /// How they were found.
    pub by: SensitivityMethod,
    /// The inputs that derivatives are by.
    pub inputs: Vec<SensitivityInput>,
    /// The figures that derivatives are of.
    pub figures: Vec<FigureSensitivity>,
    /// Inputs whose derivatives are not known.
    pub left_out: Vec<LeftOut>,
}

/// How derivatives are found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SensitivityMethod {
    /// A linear solve for each input on coarser grids, good to a few per cent of the largest.
    LinearSolves,
    /// Differences of two solves for each input, good to about a per cent.
    Differences,
}

impl SensitivityMethod {
    /// In words.
    pub fn words(self) -> &'static str {
        match self {
            SensitivityMethod::LinearSolves => "linear solves",
            SensitivityMethod::Differences => "differences of solves",
        }
    }
}

/// An input.
#[derive(Clone, Debug, PartialEq)]
pub struct SensitivityInput {
    /// Key path in the case file; for data behind a name, below the key of the name.
    pub key: String,
    /// Its value, SI.
    pub value: f64,
    /// SI unit; empty of pure numbers.
    pub unit: String,
    /// Its uncertainty, if the case gives one.
    pub uncertainty: Option<Uncertainty>,
}

/// A figure with its derivatives.
#[derive(Clone, Debug, PartialEq)]
pub struct FigureSensitivity {
    /// The figure.
    pub figure: Figure,
    /// Its value, SI.
    pub value: f64,
    /// Its derivative by each input, SI.
    pub derivatives: Vec<f64>,
}

/// An input whose derivatives are not known.
#[derive(Clone, Debug, PartialEq)]
pub struct LeftOut {
    /// Its key path.
    pub key: String,
    /// Why.
    pub reason: String,
}

impl Sensitivities {
    /// d ln(figure)/d ln(input) with the key of each input, the largest first; none where the figure is zero. Temperatures count from
    /// absolute zero.
    pub fn logarithmic(&self, figure: &FigureSensitivity) -> Vec<(&str, f64)> {
        if figure.value == 0.0 {
            return Vec::new();
        }
        let inputs = self.inputs.iter().zip(&figure.derivatives);
        let mut sorted: Vec<(&str, f64)> = inputs
            .filter(|(input, _)| input.value != 0.0)
            .map(|(input, by)| (input.key.as_str(), by * input.value / figure.value))
            .collect();
        sorted.sort_by(|a, b| b.1.abs().total_cmp(&a.1.abs()));
        sorted
    }

    /// d ln(figure)/d(input) per kelvin with the key of each input that is a temperature.
    pub fn per_kelvin(&self, figure: &FigureSensitivity) -> Vec<(&str, f64)> {
        if figure.value == 0.0 {
            return Vec::new();
        }
        (self.inputs.iter().zip(&figure.derivatives))
            .filter(|(input, _)| input.is_temperature())
            .map(|(input, by)| (input.key.as_str(), by / figure.value))
            .collect()
    }
}

impl SensitivityInput {
    /// Whether it is a temperature, whose effects are given per kelvin: per cent of a temperature has no meaning.
    pub fn is_temperature(&self) -> bool {
        self.unit == "K"
    }
}

/// For each figure a map from the key of an input to d ln(figure)/d ln(input).
impl Serialize for Sensitivities {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(self.figures.len()))?;
        for figure in &self.figures {
            map.serialize_entry(figure.figure.name(), &ByKey(self.logarithmic(figure)))?;
        }
        map.end()
    }
}

/// Numbers by the keys of their inputs, in this order.
pub(super) struct ByKey<'a>(pub Vec<(&'a str, f64)>);

impl Serialize for ByKey<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().copied())
    }
}
