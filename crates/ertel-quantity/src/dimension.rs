//! Dimension vectors over length, mass, time and temperature.

use std::borrow::Cow;
use std::fmt;

/// The physical dimension of a quantity: integer exponents of length, mass, time, temperature and angle.
///
/// A temperature and a temperature difference have the same exponents but convert differently from `degC`,
/// so [`Dimension::TEMPERATURE_DIFFERENCE`] is a separate dimension.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Dimension {
    /// Exponents of length, mass, time, temperature, angle.
    exponents: [i8; 5],
    is_difference: bool,
}

/// Dimension, its name with article, and unit examples, the SI unit first.
type Named = (Dimension, &'static str, &'static [&'static str]);

impl Dimension {
    /// A pure number.
    pub const DIMENSIONLESS: Self = Self::new(0, 0, 0, 0);
    /// Length, m.
    pub const LENGTH: Self = Self::new(1, 0, 0, 0);
    /// Mass, kg.
    pub const MASS: Self = Self::new(0, 1, 0, 0);
    /// Time, s.
    pub const TIME: Self = Self::new(0, 0, 1, 0);
    /// Absolute temperature, K.
    pub const TEMPERATURE: Self = Self::new(0, 0, 0, 1);
    /// Difference of two temperatures, K.
    pub const TEMPERATURE_DIFFERENCE: Self = Self {
        exponents: [0, 0, 0, 1, 0],
        is_difference: true,
    };
    /// Plane angle, rad; a separate dimension, so that no bare number is taken for degrees.
    pub const ANGLE: Self = Self {
        exponents: [0, 0, 0, 0, 1],
        is_difference: false,
    };
    /// Angular speed, rad/s.
    pub const ANGULAR_SPEED: Self = Self::ANGLE.per(Self::TIME);
    /// Area, m².
    pub const AREA: Self = Self::new(2, 0, 0, 0);
    /// Volume, m³.
    pub const VOLUME: Self = Self::new(3, 0, 0, 0);
    /// Speed, m/s.
    pub const SPEED: Self = Self::LENGTH.per(Self::TIME);
    /// Shear rate or frequency, 1/s.
    pub const SHEAR_RATE: Self = Self::TIME.inverse();
    /// Force, N.
    pub const FORCE: Self = Self::new(1, 1, -2, 0);
    /// Force per length, N/m.
    pub const FORCE_PER_LENGTH: Self = Self::FORCE.per(Self::LENGTH);
    /// Energy, J.
    pub const ENERGY: Self = Self::FORCE.times(Self::LENGTH);
    /// Power, W.
    pub const POWER: Self = Self::ENERGY.per(Self::TIME);
    /// Pressure, stress or elastic modulus, Pa.
    pub const PRESSURE: Self = Self::FORCE.per(Self::AREA);
    /// Inverse pressure (pressure-viscosity coefficient, compressibility), 1/Pa.
    pub const INVERSE_PRESSURE: Self = Self::PRESSURE.inverse();
    /// Inverse pressure squared, 1/Pa².
    pub const INVERSE_PRESSURE_SQUARED: Self = Self::INVERSE_PRESSURE.times(Self::INVERSE_PRESSURE);
    /// Density, kg/m³.
    pub const DENSITY: Self = Self::MASS.per(Self::VOLUME);
    /// Dynamic viscosity, Pa·s.
    pub const VISCOSITY: Self = Self::PRESSURE.times(Self::TIME);
    /// Kinematic viscosity, m²/s.
    pub const KINEMATIC_VISCOSITY: Self = Self::AREA.per(Self::TIME);
    /// Thermal conductivity, W/(m·K).
    pub const THERMAL_CONDUCTIVITY: Self = Self::POWER.per(Self::LENGTH).per(Self::TEMPERATURE);
    /// Heat capacity per mass, J/(kg·K).
    pub const SPECIFIC_HEAT: Self = Self::ENERGY.per(Self::MASS).per(Self::TEMPERATURE);
    /// Heat capacity per volume, J/(m³·K).
    pub const VOLUMETRIC_HEAT: Self = Self::PRESSURE.per(Self::TEMPERATURE);
    /// Inverse temperature (thermal expansivity), 1/K.
    pub const INVERSE_TEMPERATURE: Self = Self::TEMPERATURE.inverse();
    /// Temperature per pressure, K/Pa.
    pub const TEMPERATURE_PER_PRESSURE: Self = Self::TEMPERATURE.per(Self::PRESSURE);

    const NAMED: &[Named] = &[
        (Self::DIMENSIONLESS, "a number without unit", &["1", "%"]),
        (Self::LENGTH, "a length", &["m", "mm", "um", "nm"]),
        (Self::MASS, "a mass", &["kg", "g"]),
        (Self::TIME, "a time", &["s", "ms", "min"]),
        (Self::TEMPERATURE, "a temperature", &["K", "degC"]),
        (
            Self::TEMPERATURE_DIFFERENCE,
            "a temperature difference",
            &["K"],
        ),
        (Self::ANGLE, "an angle", &["rad", "deg"]),
        (Self::ANGULAR_SPEED, "an angular speed", &["rad/s", "rpm"]),
        (Self::AREA, "an area", &["m^2", "mm^2"]),
        (Self::VOLUME, "a volume", &["m^3", "mm^3"]),
        (Self::SPEED, "a speed", &["m/s", "mm/s"]),
        (Self::SHEAR_RATE, "a rate", &["1/s"]),
        (Self::FORCE, "a force", &["N", "kN", "mN"]),
        (
            Self::FORCE_PER_LENGTH,
            "a force per length",
            &["N/m", "kN/m", "N/mm"],
        ),
        (Self::ENERGY, "an energy", &["J", "N.m"]),
        (Self::POWER, "a power", &["W", "kW"]),
        (Self::PRESSURE, "a pressure", &["Pa", "MPa", "GPa", "bar"]),
        (
            Self::INVERSE_PRESSURE,
            "an inverse pressure",
            &["1/Pa", "1/MPa", "1/GPa"],
        ),
        (
            Self::INVERSE_PRESSURE_SQUARED,
            "an inverse pressure squared",
            &["1/Pa^2", "1/GPa^2"],
        ),
        (Self::DENSITY, "a density", &["kg/m^3", "g/cm^3"]),
        (
            Self::VISCOSITY,
            "a dynamic viscosity",
            &["Pa.s", "mPa.s", "cP"],
        ),
        (
            Self::KINEMATIC_VISCOSITY,
            "a kinematic viscosity",
            &["m^2/s", "mm^2/s", "cSt"],
        ),
        (
            Self::THERMAL_CONDUCTIVITY,
            "a thermal conductivity",
            &["W/(m.K)", "mW/(m.K)"],
        ),
        (
            Self::SPECIFIC_HEAT,
            "a specific heat capacity",
            &["J/(kg.K)", "kJ/(kg.K)"],
        ),
        (
            Self::VOLUMETRIC_HEAT,
            "a volumetric heat capacity",
            &["J/(m^3.K)", "MPa/K"],
        ),
        (
            Self::INVERSE_TEMPERATURE,
            "an inverse temperature",
            &["1/K"],
        ),
        (
            Self::TEMPERATURE_PER_PRESSURE,
            "a temperature per pressure",
            &["K/Pa", "K/GPa"],
        ),
    ];

    /// The dimension with these exponents of length, mass, time and temperature.
    #[must_use]
    pub const fn new(length: i8, mass: i8, time: i8, temperature: i8) -> Self {
        Self {
            exponents: [length, mass, time, temperature, 0],
            is_difference: false,
        }
    }

    /// The dimension of a product.
    #[must_use]
    pub const fn times(self, other: Self) -> Self {
        self.combine(other, 1)
    }

    /// The dimension of a quotient.
    #[must_use]
    pub const fn per(self, other: Self) -> Self {
        self.combine(other, -1)
    }

    /// The dimension of the reciprocal.
    #[must_use]
    pub const fn inverse(self) -> Self {
        Self::DIMENSIONLESS.per(self)
    }

    /// The dimension of the `power`-th power.
    #[must_use]
    pub const fn power(self, power: i8) -> Self {
        Self::DIMENSIONLESS.combine(self, power)
    }

    const fn combine(self, other: Self, power: i8) -> Self {
        let mut exponents = self.exponents;
        let mut k = 0;
        while k < exponents.len() {
            // Saturation instead of overflow: an absurd power is then simply a wrong dimension.
            exponents[k] = exponents[k].saturating_add(other.exponents[k].saturating_mul(power));
            k += 1;
        }
        Self {
            exponents,
            is_difference: false,
        }
    }

    /// Whether the exponents agree; a temperature and a temperature difference do.
    #[must_use]
    pub fn same_exponents(self, other: Self) -> bool {
        self.exponents == other.exponents
    }

    fn named(self) -> Option<&'static Named> {
        Self::NAMED
            .iter()
            .find(|(dimension, ..)| *dimension == self)
    }

    /// The name with its article, `a length`; the SI unit in words for a dimension without a name.
    #[must_use]
    pub fn name(self) -> Cow<'static, str> {
        match self.named() {
            Some((_, name, _)) => Cow::Borrowed(name),
            None => Cow::Owned(format!("a quantity in {self}")),
        }
    }

    /// Units to write it in, as a list: `m, mm, um, nm`.
    #[must_use]
    pub fn examples(self) -> String {
        match self.named() {
            Some((_, _, examples)) => examples.join(", "),
            None => self.to_string(),
        }
    }

    /// The unit it has in SI: `m`, `1/Pa`, `W/(m.K)`; empty for a pure number.
    #[must_use]
    pub fn si_unit(self) -> String {
        if self == Self::DIMENSIONLESS {
            return String::new();
        }
        match self.named() {
            Some((_, _, examples)) => examples[0].to_owned(),
            None => self.to_string(),
        }
    }
}

impl fmt::Display for Dimension {
    /// Writes the exponents as a unit that [`parse`](super::parse) reads: `kg.m^-1.s^-2`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [length, mass, time, temperature, angle] = self.exponents;
        let units = [
            ("kg", mass),
            ("m", length),
            ("s", time),
            ("K", temperature),
            ("rad", angle),
        ];
        let factors: Vec<String> = (units.into_iter())
            .filter(|(_, power)| *power != 0)
            .map(|(symbol, power)| match power {
                1 => symbol.to_owned(),
                _ => format!("{symbol}^{power}"),
            })
            .collect();
        f.write_str(
            if factors.is_empty() {
                "1".to_owned()
            } else {
                factors.join(".")
            }
            .as_str(),
        )
    }
}
