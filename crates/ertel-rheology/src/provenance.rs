//! Where a number comes from.

use std::fmt;

use thiserror::Error;

/// One number of a fluid or solid, as it is written in its file, with its origin.
#[derive(Debug, Clone, PartialEq)]
pub struct Datum {
    /// Key path, `viscosity.mu_0`.
    pub key: String,
    /// The value as written, without its unit.
    pub value: String,
    /// The unit as written; `1` for a pure number, empty for a name.
    pub unit: String,
    /// Key in the bibliography and place in the source, `habchi2008, Table 5.1`.
    pub source: String,
    /// How well the number is attested.
    pub status: Status,
    /// Note for users.
    pub note: Option<String>,
}

/// How well a number is attested.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Status {
    /// Printed in the thesis of Habchi (2008).
    Thesis,
    /// Printed in a publication.
    Published,
    /// Read in the source code of a public program that cites a publication.
    Code,
    /// Read on a public web page.
    Page,
    /// Computed with the CoolProp library.
    Coolprop,
    /// Computed from other data of the same entry.
    Computed,
    /// Estimated from other data by a correlation or a typical value; a note states its uncertainty.
    Estimated,
    /// Not from any source: placeholder for a number that does not influence an isothermal film.
    Nominal,
    /// Given by the user.
    User,
}

impl Status {
    /// All statuses with the names used in data files.
    pub const NAMES: [(&'static str, Status); 9] = [
        ("thesis", Self::Thesis),
        ("published", Self::Published),
        ("code", Self::Code),
        ("page", Self::Page),
        ("coolprop", Self::Coolprop),
        ("computed", Self::Computed),
        ("estimated", Self::Estimated),
        ("nominal", Self::Nominal),
        ("user", Self::User),
    ];

    /// The name used in data files.
    pub fn name(self) -> &'static str {
        Self::NAMES
            .iter()
            .find(|(_, status)| *status == self)
            .map_or("", |(name, _)| name)
    }
}

impl fmt::Display for Status {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// Pressures and temperatures for which the data of a fluid hold.
#[derive(Debug, Clone, PartialEq)]
pub struct ValidityRange {
    /// Lowest and highest pressure (Pa above ambient); `None` if the source does not say.
    pub pressure: Option<(f64, f64)>,
    /// Lowest and highest temperature (K); `None` if the source does not say.
    pub temperature: Option<(f64, f64)>,
    /// Basis of the range.
    pub source: String,
    /// Whether it is what is stated for a law in general, and not for this fluid.
    pub of_law: bool,
}

/// Temperatures that some of the data of a fluid cover.
#[derive(Debug, Clone, PartialEq)]
pub struct TemperatureRange {
    /// Lowest temperature (K).
    pub lowest: f64,
    /// Highest temperature (K).
    pub highest: f64,
    /// Basis of the range.
    pub basis: String,
}

impl TemperatureRange {
    /// The narrowest of the ranges that do not contain `temperature`, K.
    #[must_use]
    pub fn left(ranges: &[TemperatureRange], temperature: f64) -> Option<&TemperatureRange> {
        let left = ranges.iter().filter(|range| !range.contains(temperature));
        left.min_by(|a, b| a.width().total_cmp(&b.width()))
    }

    /// Whether `temperature` (K) lies inside, or within 0.01 K of the ends: a temperature rounds when it is converted.
    pub fn contains(&self, temperature: f64) -> bool {
        temperature >= self.lowest - 0.01 && temperature <= self.highest + 0.01
    }

    /// From the lowest to the highest temperature, K.
    pub fn width(&self) -> f64 {
        self.highest - self.lowest
    }
}

/// A temperature (K) in °C, to hundredths: `74.85 °C`, `40 °C`.
pub fn celsius(temperature: f64) -> String {
    let text = format!("{:.2}", temperature - 273.15);
    let text = text.trim_end_matches('0').trim_end_matches('.');
    format!("{} °C", if text == "-0" { "0" } else { text })
}

/// `from 40 °C to 80 °C`, or `at 74.85 °C only` where the ends read alike.
impl fmt::Display for TemperatureRange {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [lowest, highest] = [self.lowest, self.highest].map(celsius);
        if lowest == highest {
            write!(f, "at {lowest} only")
        } else {
            write!(f, "from {lowest} to {highest}")
        }
    }
}

/// `pressure` beyond `limit`, Pa, of a fluid or of its law in general.
fn beyond(fluid: &str, [pressure, limit]: [f64; 2], basis: &str, of_law: bool) -> String {
    let [pressure, limit] = [pressure, limit].map(|p| p / 1e9);
    match of_law {
        true => format!("viscosity law extrapolated above {limit:.2} GPa ({basis})"),
        false => format!(
            "{fluid}: the pressure reaches {pressure:.3} GPa, its data are valid up to {limit:.3} GPa ({basis})"
        ),
    }
}

/// A state outside the range for which the data of a fluid hold.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum RangeWarning {
    /// The pressure exceeds the range.
    #[error("{}", beyond(.fluid, [*.pressure, *.limit], .basis, *.of_law))]
    PressureAbove {
        /// Name of the fluid.
        fluid: String,
        /// Largest pressure (Pa).
        pressure: f64,
        /// Upper end of the range (Pa).
        limit: f64,
        /// Basis of the range.
        basis: String,
        /// Whether it is what is stated for the law in general.
        of_law: bool,
    },
    /// The temperature lies outside the range.
    #[error(
        "{fluid}: the temperature is {}, its data are valid {range} ({})", celsius(*.temperature), .range.basis
    )]
    Temperature {
        /// Name of the fluid.
        fluid: String,
        /// Temperature (K).
        temperature: f64,
        /// The range that it is outside of.
        range: TemperatureRange,
    },
}
