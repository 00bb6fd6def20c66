//! Monotone cubic interpolation in a table of isotherms.

use crate::Scalar;
use crate::error::{Check, LawError};

/// The law of tables: values along isotherms, interpolated in pressure and then in temperature.
///
/// Both steps use the piecewise cubic Hermite interpolant of Fritsch and Butland (SIAM J. Sci. Stat. Comput. 5, 1984,
/// 300-304; end slopes after Moler): exact at the knots, continuous first derivative, monotone wherever the data are.
/// Outside the knots it continues in a straight line or with the end value, as the law needs.
#[derive(Debug, Clone, PartialEq)]
pub struct Isotherms {
    /// Increasing (K).
    temperatures: Vec<f64>,
    /// One for each temperature.
    rows: Vec<Isotherm>,
    beyond: Beyond,
}

/// How a table continues outside its knots.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Beyond {
    /// The end tangent as a straight line: what keeps changing must go on changing.
    Straight,
    /// The end value: what varies little must not run away, nor change its sign.
    Held,
}

#[derive(Debug, Clone, PartialEq)]
struct Isotherm {
    /// Increasing (Pa).
    pressures: Vec<f64>,
    values: Vec<f64>,
    /// Slope of the interpolant at each pressure.
    slopes: Vec<f64>,
}

const LAW: &str = "table";

impl Isotherms {
    /// One isotherm for each of `temperatures` (K, increasing): `pressures[i]` (Pa above ambient, increasing) and `values[i]` (SI, positive)
    /// of equal length, at least two; isotherms may have different pressures. Beyond them the table continues in straight lines.
    ///
    /// # Errors
    ///
    /// Lists of other lengths, numbers that do not increase or are not positive.
    pub fn straight(
        temperatures: Vec<f64>,
        pressures: Vec<Vec<f64>>,
        values: Vec<Vec<f64>>,
    ) -> Result<Self, LawError> {
        Self::with_ends(temperatures, pressures, values, Beyond::Straight)
    }

    /// The same of the logarithms of `values`.
    ///
    /// # Errors
    ///
    /// As [`Isotherms::straight`].
    pub fn of_logarithms(
        temperatures: Vec<f64>,
        pressures: Vec<Vec<f64>>,
        values: Vec<Vec<f64>>,
    ) -> Result<Self, LawError> {
        Ok(Self::straight(temperatures, pressures, values)?.map(f64::ln))
    }

    /// The same that holds its end values outside. Here a row may have a single pressure, whose value then holds at
    /// every pressure.
    ///
    /// # Errors
    ///
    /// As [`Isotherms::straight`].
    pub fn held(
        temperatures: Vec<f64>,
        pressures: Vec<Vec<f64>>,
        values: Vec<Vec<f64>>,
    ) -> Result<Self, LawError> {
        Self::with_ends(temperatures, pressures, values, Beyond::Held)
    }

    fn with_ends(
        temperatures: Vec<f64>,
        pressures: Vec<Vec<f64>>,
        values: Vec<Vec<f64>>,
        beyond: Beyond,
    ) -> Result<Self, LawError> {
        let fail = |key, problem: String| {
            Err(LawError::Table {
                law: LAW,
                key,
                problem,
            })
        };
        if temperatures.is_empty() {
            return fail("temperature", "no temperature given".into());
        }
        for &t in &temperatures {
            Check(LAW).positive("temperature", t)?;
        }
        check_increasing("temperature", &temperatures)?;
        if pressures.len() != temperatures.len() {
            return fail(
                "pressure",
                format!(
                    "{} rows of pressures for {} temperatures",
                    pressures.len(),
                    temperatures.len()
                ),
            );
        }
        if values.len() != temperatures.len() {
            return fail(
                "values",
                format!(
                    "{} rows for {} temperatures",
                    values.len(),
                    temperatures.len()
                ),
            );
        }
        let mut rows = Vec::with_capacity(values.len());
        for (i, (pressures, values)) in pressures.into_iter().zip(values).enumerate() {
            if pressures.len() != values.len() {
                return fail(
                    "values",
                    format!(
                        "row {} has {} values for {} pressures",
                        i + 1,
                        values.len(),
                        pressures.len()
                    ),
                );
            }
            let fewest = match beyond {
                Beyond::Straight => 2,
                Beyond::Held => 1,
            };
            if pressures.len() < fewest {
                let too_few = ["no pressure", "fewer than two pressures"][fewest - 1];
                return fail("pressure", format!("row {} has {too_few}", i + 1));
            }
            for &p in &pressures {
                Check(LAW).finite("pressure", p)?;
            }
            check_increasing("pressure", &pressures)?;
            for &value in &values {
                Check(LAW).positive("values", value)?;
            }
            rows.push(Isotherm::new(pressures, values));
        }
        Ok(Self {
            temperatures,
            rows,
            beyond,
        })
    }

    /// The same table with `f` applied to every value.
    fn map(self, f: impl Fn(f64) -> f64) -> Self {
        let rows = self
            .rows
            .into_iter()
            .map(|row| {
                let values = row.values.into_iter().map(&f).collect();
                Isotherm::new(row.pressures, values)
            })
            .collect();
        Self {
            temperatures: self.temperatures,
            rows,
            beyond: self.beyond,
        }
    }

    /// Whether the value changes with temperature.
    pub fn depends_on_temperature(&self) -> bool {
        self.rows.len() > 1
    }

    /// Range `(min, max)` of pressure and temperature that every isotherm covers; infinite in pressure where the rows
    /// have a single one.
    pub fn range(&self) -> [(f64, f64); 2] {
        let rows = || self.rows.iter().filter(|row| row.pressures.len() > 1);
        let first = rows()
            .map(|row| row.pressures[0])
            .fold(f64::NEG_INFINITY, f64::max);
        let last = rows()
            .map(|row| row.pressures[row.pressures.len() - 1])
            .fold(f64::INFINITY, f64::min);
        [
            (first, last),
            (
                self.temperatures[0],
                self.temperatures[self.temperatures.len() - 1],
            ),
        ]
    }

    /// Value (SI, or its logarithm) at `pressure` (Pa above ambient) and `temperature` (K).
    pub fn evaluate<D: Scalar>(&self, pressure: D, temperature: D) -> D {
        let n = self.temperatures.len();
        if n == 1 {
            return self.rows[0].evaluate(pressure, self.beyond);
        }
        let i = interval(&self.temperatures, temperature.re());
        // The slope at a knot needs one neighbour on each side: at most four isotherms take part.
        let first = i.saturating_sub(1);
        let last = (i + 2).min(n - 1);
        let mut values = [D::from(0.0); 4];
        for j in first..=last {
            values[j - first] = self.rows[j].evaluate(pressure, self.beyond);
        }
        let knots = &self.temperatures[first..=last];
        let values = &values[..=last - first];
        let (left, right) = (i - first, i + 1 - first);
        let slopes = (
            slope_at(knots, values, left),
            slope_at(knots, values, right),
        );
        hermite(
            (knots[left], knots[right]),
            (values[left], values[right]),
            slopes,
            temperature,
            self.beyond,
        )
    }
}

impl Isotherm {
    fn new(pressures: Vec<f64>, values: Vec<f64>) -> Self {
        let slopes = match values.len() {
            1 => vec![0.0],
            n => (0..n).map(|i| slope_at(&pressures, &values, i)).collect(),
        };
        Self {
            pressures,
            values,
            slopes,
        }
    }

    fn evaluate<D: Scalar>(&self, pressure: D, beyond: Beyond) -> D {
        if let [value] = self.values[..] {
            return D::from(value);
        }
        let i = interval(&self.pressures, pressure.re());
        hermite(
            (self.pressures[i], self.pressures[i + 1]),
            (D::from(self.values[i]), D::from(self.values[i + 1])),
            (D::from(self.slopes[i]), D::from(self.slopes[i + 1])),
            pressure,
            beyond,
        )
    }
}

fn check_increasing(key: &'static str, knots: &[f64]) -> Result<(), LawError> {
    match knots.windows(2).find(|pair| pair[1] <= pair[0]) {
        None => Ok(()),
        Some(pair) => Err(LawError::Table {
            law: LAW,
            key,
            problem: format!("must increase, but {} follows {} (SI)", pair[1], pair[0]),
        }),
    }
}

/// Index of the interval that holds `x`; the first or last one when `x` lies outside.
fn interval(knots: &[f64], x: f64) -> usize {
    knots
        .partition_point(|&knot| knot <= x)
        .clamp(1, knots.len() - 1)
        - 1
}

/// Slope of the monotone interpolant at knot `i`.
fn slope_at<D: Scalar>(knots: &[f64], values: &[D], i: usize) -> D {
    let n = knots.len();
    let width = |j: usize| knots[j + 1] - knots[j];
    let secant = |j: usize| (values[j + 1] - values[j]) / width(j);
    if n == 2 {
        return secant(0);
    }
    if i == 0 {
        return end_slope((width(0), width(1)), (secant(0), secant(1)));
    }
    if i == n - 1 {
        return end_slope((width(n - 2), width(n - 3)), (secant(n - 2), secant(n - 3)));
    }
    let (before, after) = (secant(i - 1), secant(i));
    if before.re() * after.re() <= 0.0 {
        return D::from(0.0); // a turning point of the data
    }
    // Harmonic mean weighted by the widths.
    let weight_before = 2.0 * width(i) + width(i - 1);
    let weight_after = width(i) + 2.0 * width(i - 1);
    (before.recip() * weight_before + after.recip() * weight_after).recip()
        * (weight_before + weight_after)
}

/// One-sided slope from the two nearest secants, limited so that the end interval stays monotone.
fn end_slope<D: Scalar>(width: (f64, f64), secant: (D, D)) -> D {
    let slope = (secant.0 * (2.0 * width.0 + width.1) - secant.1 * width.0) / (width.0 + width.1);
    if slope.re() * secant.0.re() <= 0.0 {
        D::from(0.0)
    } else if secant.0.re() * secant.1.re() <= 0.0 && slope.re().abs() > 3.0 * secant.0.re().abs() {
        secant.0 * 3.0
    } else {
        slope
    }
}

/// Cubic through both ends with the given slopes; what `beyond` says outside.
fn hermite<D: Scalar>(
    knots: (f64, f64),
    values: (D, D),
    slopes: (D, D),
    x: D,
    beyond: Beyond,
) -> D {
    let outside = |knot: f64, value: D, slope: D| match beyond {
        Beyond::Straight => value + slope * (x - knot),
        Beyond::Held => value,
    };
    if x.re() < knots.0 {
        return outside(knots.0, values.0, slopes.0);
    }
    if x.re() > knots.1 {
        return outside(knots.1, values.1, slopes.1);
    }
    let width = knots.1 - knots.0;
    let t = (x - knots.0) / width;
    let s = -t + 1.0;
    // s + t = 1: values weighted by 3s²t + s³ and 3t²s + t³, slopes by s²t and -t²s.
    let value = s * s * (values.0 * (t * 2.0 + 1.0)) + t * t * (values.1 * (s * 2.0 + 1.0));
    value + s * t * (s * slopes.0 - t * slopes.1) * width
}
