//! Numbers with their units as people read them: in reports, pictures and warnings.

/// Factor from SI and name of a readable unit of length.
pub fn length_unit(value: f64) -> (f64, &'static str) {
    match value.abs() {
        v if v < 1e-6 => (1e9, "nm"),
        v if v < 1e-3 => (1e6, "µm"),
        v if v < 1.0 => (1e3, "mm"),
        _ => (1.0, "m"),
    }
}

/// The same of pressure.
pub fn pressure_unit(value: f64) -> (f64, &'static str) {
    match value.abs() {
        v if v < 1e3 => (1.0, "Pa"),
        v if v < 1e6 => (1e-3, "kPa"),
        v if v < 1e9 => (1e-6, "MPa"),
        _ => (1e-9, "GPa"),
    }
}

/// Length with a readable unit, four digits.
pub fn length(value: f64) -> String {
    let (factor, unit) = length_unit(value);
    format!("{} {unit}", digits(factor * value, 4))
}

/// Pressure with a readable unit, four digits.
pub fn pressure(value: f64) -> String {
    let (factor, unit) = pressure_unit(value);
    format!("{} {unit}", digits(factor * value, 4))
}

/// Factor from SI and name of a readable unit of a force, or of a force per length of a line.
pub fn force_unit(value: f64, is_line: bool) -> (f64, &'static str) {
    match is_line {
        false => (1.0, "N"),
        true if value.abs() < 1e3 => (1.0, "N/m"),
        true => (1e-3, "kN/m"),
    }
}

/// A force, or a force per length of a line, with a readable unit and `n` digits.
pub fn force(value: f64, is_line: bool, n: usize) -> String {
    let (factor, unit) = force_unit(value, is_line);
    format!("{} {unit}", digits(factor * value, n))
}

/// Number with `n` significant digits, zeros at the end of the fraction left out.
pub fn digits(value: f64, n: usize) -> String {
    if value == 0.0 || !value.is_finite() {
        return format!("{value}");
    }
    let exponent = value.abs().log10().floor();
    if !(-4.0..9.0).contains(&exponent) {
        return format!("{value:.*e}", n.saturating_sub(1));
    }
    let decimals = (n as f64 - 1.0 - exponent).max(0.0) as usize;
    let text = format!("{value:.decimals$}");
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        text
    }
}

/// 0 °C, K.
pub const CELSIUS: f64 = 273.15;

/// Scale in which temperatures are shown first; the other one follows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum TemperatureScale {
    /// K.
    #[default]
    Kelvin,
    /// °C.
    Celsius,
}

impl TemperatureScale {
    /// The scale in which a user gave a temperature, `"40 degC"`; Kelvin of anything else.
    pub fn of(given: &str) -> TemperatureScale {
        let has = |unit: &str| given.contains(unit);
        match has("degC") || has("°C") || has("℃") {
            true => TemperatureScale::Celsius,
            false => TemperatureScale::Kelvin,
        }
    }

    /// A temperature in K in this scale.
    pub fn shown(self, kelvin: f64) -> f64 {
        match self {
            TemperatureScale::Kelvin => kelvin,
            TemperatureScale::Celsius => kelvin - CELSIUS,
        }
    }

    /// Its unit.
    pub fn unit(self) -> &'static str {
        match self {
            TemperatureScale::Kelvin => "K",
            TemperatureScale::Celsius => "°C",
        }
    }

    /// The other one.
    pub fn other(self) -> TemperatureScale {
        match self {
            TemperatureScale::Kelvin => TemperatureScale::Celsius,
            TemperatureScale::Celsius => TemperatureScale::Kelvin,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_readable() {
        assert_eq!(length(244.824e-9), "244.8 nm");
        assert_eq!(length(218.279e-6), "218.3 µm");
        assert_eq!(length(0.016), "16 mm");
        assert_eq!(pressure(1.00212e9), "1.002 GPa");
        assert_eq!(pressure(6.8e8), "680 MPa");
        assert_eq!(digits(2e5, 6), "200000");
        assert_eq!(force(1.08332e6, true, 6), "1083.32 kN/m");
        assert_eq!(force(250.0, true, 4), "250 N/m");
        assert_eq!(force(2500.0, false, 4), "2500 N");
        assert_eq!(digits(0.0, 4), "0");
        assert_eq!(digits(1.23456e-11, 3), "1.23e-11");
    }
}
