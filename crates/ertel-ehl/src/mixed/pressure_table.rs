//! Asperity pressures in a table over distances.

use std::sync::Arc;

use ertel_rheology::Isotherms;
use num_dual::Dual64;
use serde::Serialize;

/// Asperity pressures over distances of the mean planes: their logarithm by monotone cubic pieces, outside in straight lines.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PressureTable {
    /// Increasing distances of the mean planes, m.
    pub asperity_distances: Vec<f64>,
    /// Falling asperity pressures, Pa.
    pub asperity_pressures: Vec<f64>,
    #[serde(skip)]
    law: Arc<Isotherms>,
}

impl PressureTable {
    /// Of increasing distances, m, and falling positive pressures, Pa, at least two of each.
    ///
    /// # Errors
    /// Other lists: what is wrong with them.
    pub fn new(distances: Vec<f64>, pressures: Vec<f64>) -> Result<PressureTable, String> {
        if pressures.windows(2).any(|pair| pair[1] >= pair[0]) {
            return Err("asperity pressures must fall from distance to distance".to_owned());
        }
        // A single isotherm of the law of tables.
        let any = 300.0;
        let rows = (vec![distances.clone()], vec![pressures.clone()]);
        let law = Isotherms::of_logarithms(vec![any], rows.0, rows.1);
        Ok(PressureTable {
            law: Arc::new(law.map_err(|error| error.to_string())?),
            asperity_distances: distances,
            asperity_pressures: pressures,
        })
    }

    /// p_a, Pa, and its derivative by the distance, Pa/m, at a distance in m.
    pub fn at(&self, distance: f64) -> [f64; 2] {
        let ln = (self.law).evaluate(Dual64::from(distance).derivative(), Dual64::from(300.0));
        let value = ln.re.exp();
        [value, value * ln.eps]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Exponential pressures are met exactly, between and beyond the rows; pressures that rise are refused.
    #[test]
    fn exponential_pressures() {
        let at = |h: f64| 1e8 * (-h / 0.2e-6).exp();
        let distances = vec![-0.2e-6, 0.1e-6, 0.5e-6, 0.9e-6];
        let pressures: Vec<f64> = distances.iter().map(|h| at(*h)).collect();
        let table = PressureTable::new(distances.clone(), pressures).unwrap();
        for h in [-0.5e-6, 0.0, 0.33e-6, 1.5e-6] {
            let [value, slope] = table.at(h);
            assert_relative_eq!(value, at(h), max_relative = 1e-12);
            assert_relative_eq!(slope, -at(h) / 0.2e-6, max_relative = 1e-10);
        }
        assert!(PressureTable::new(distances, vec![1e6, 2e6, 1e5, 1e4]).is_err());
    }
}
