//! The laws with their constants, starting values and scales.

use ertel_quantity::{Dimension, Unit};
use ertel_rheology::density::{
    BulkModulusSoftening, DowsonHigginson, Tait, TaitVolume, ThermalExpansion,
};
use ertel_rheology::viscosity::{
    Barus, Cheng, Doolittle, GlassTransition, Hybrid, ImprovedYasutomi, McEwen, ModifiedWlf,
    OccupiedVolume, Paluch, PressureLaw, Roelands, TemperatureSlope, Walther,
};
use ertel_rheology::{DensityLaw, LawError, ViscosityLaw};

use super::{Data, FitError, Params, Property, walther};

/// Spread of temperatures (K) below which the data count as one isotherm: thermostats hold less.
pub(super) const ISOTHERM: f64 = 0.5;

/// Start of the pressure at which a law diverges, Pa: beyond all measurements.
const FAR: f64 = 5e9;

/// A law that can be fitted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LawName {
    /// Viscosity, one isotherm.
    Barus,
    /// Viscosity.
    Cheng,
    /// Viscosity.
    Roelands,
    /// Viscosity, modified WLF.
    Wlf,
    /// Viscosity, with a Tait equation of state.
    Doolittle,
    /// Viscosity, improved Yasutomi.
    Yasutomi,
    /// Viscosity, one isotherm.
    McEwen,
    /// Viscosity, one isotherm.
    Paluch,
    /// Viscosity, one isotherm: the product of both.
    Hybrid,
    /// Viscosity, with a density law.
    Walther,
    /// Density.
    Tait,
    /// Density.
    DowsonHigginson,
}

impl LawName {
    /// All laws.
    pub const ALL: [Self; 12] = [
        Self::Cheng,
        Self::Roelands,
        Self::Wlf,
        Self::Yasutomi,
        Self::Doolittle,
        Self::Barus,
        Self::McEwen,
        Self::Paluch,
        Self::Hybrid,
        Self::Walther,
        Self::Tait,
        Self::DowsonHigginson,
    ];

    /// Name as written in data files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Barus => "barus",
            Self::Cheng => "cheng",
            Self::Roelands => "roelands",
            Self::Wlf => "wlf",
            Self::Yasutomi => "yasutomi",
            Self::Doolittle => "doolittle",
            Self::McEwen => "mcewen",
            Self::Paluch => "paluch",
            Self::Hybrid => "mcewen-paluch",
            Self::Walther => "walther",
            Self::Tait => "tait",
            Self::DowsonHigginson => "dowson-higginson",
        }
    }

    /// The property it describes.
    pub fn property(self) -> Property {
        match self {
            Self::Tait | Self::DowsonHigginson => Property::Density,
            _ => Property::Viscosity,
        }
    }

    /// Whether it depends on temperature; constants of the others are those of one isotherm.
    pub fn is_thermal(self) -> bool {
        !matches!(
            self,
            Self::Barus | Self::McEwen | Self::Paluch | Self::Hybrid
        )
    }

    /// The laws for a property, as a list.
    pub fn choices(property: Property) -> String {
        let names = Self::ALL.iter().filter(|law| law.property() == property);
        names.map(|law| law.name()).collect::<Vec<_>>().join(", ")
    }
}

/// A law with fitted constants.
#[derive(Clone, Debug, PartialEq)]
pub enum FittedLaw {
    /// Of the viscosity.
    Viscosity(ViscosityLaw),
    /// Of the density.
    Density(DensityLaw),
}

impl FittedLaw {
    /// Logarithm of the viscosity (Pa·s) or density (kg/m³) at `pressure` (Pa above ambient) and `temperature` (K).
    pub fn ln_value(&self, pressure: f64, temperature: f64) -> f64 {
        match self {
            Self::Viscosity(law) => law.ln_viscosity(pressure, temperature),
            Self::Density(law) => law.density(pressure, temperature).ln(),
        }
    }
}

/// A constant before the fit.
pub(super) struct Constant {
    pub(super) key: &'static str,
    pub(super) unit: &'static str,
    dimension: Dimension,
    /// Starting value, or the value held (SI).
    pub(super) start: f64,
    scale: Scale,
    pub(super) held: bool,
}

/// The unknown that represents a constant.
#[derive(Clone, Copy)]
enum Scale {
    /// Its logarithm: the constant is positive.
    Logarithm,
    /// Its multiple of a typical size (SI): any sign.
    Multiple(f64),
}

impl Constant {
    fn new(
        key: &'static str,
        unit: &'static str,
        dimension: Dimension,
        start: f64,
        scale: Scale,
    ) -> Self {
        Self {
            key,
            unit,
            dimension,
            start,
            scale,
            held: false,
        }
    }

    fn hold(self) -> Self {
        Self { held: true, ..self }
    }

    pub(super) fn is_positive(&self) -> bool {
        matches!(self.scale, Scale::Logarithm)
    }

    pub(super) fn scaled(&self, value: f64) -> f64 {
        match self.scale {
            Scale::Logarithm => (value / self.start).ln(),
            Scale::Multiple(size) => value / size,
        }
    }

    pub(super) fn unscaled(&self, x: f64) -> f64 {
        match self.scale {
            Scale::Logarithm => self.start * x.exp(),
            Scale::Multiple(size) => size * x,
        }
    }
}

/// Basis of the starting values.
struct Start {
    /// Reference temperature, K.
    t_r: f64,
    /// Viscosity or density near ambient pressure and T_R.
    value: f64,
    /// Slope of its logarithm over pressure there, 1/Pa.
    slope: f64,
    /// Whether there is more than one temperature.
    thermal: bool,
    /// A and B of Walther's equation.
    walther: (f64, f64),
}

impl Start {
    fn of(data: &Data, reference_temperature: Option<f64>, density: Option<&DensityLaw>) -> Self {
        let [low, high] = data.temperature_range();
        let nearest = |to: f64| {
            let distance = |s: &super::State| (s.temperature - to).abs();
            let states = data.states.iter();
            states
                .min_by(|a, b| distance(a).total_cmp(&distance(b)))
                .map_or(to, |s| s.temperature)
        };
        let t_r = reference_temperature.unwrap_or_else(|| nearest(0.5 * (low + high)));
        let t = nearest(t_r);
        let isotherm = data
            .states
            .iter()
            .filter(|s| (s.temperature - t).abs() <= ISOTHERM);
        let first = isotherm
            .clone()
            .min_by(|a, b| a.pressure.total_cmp(&b.pressure));
        let last = isotherm.max_by(|a, b| a.pressure.total_cmp(&b.pressure));
        let (mut value, mut slope) = (1.0, 1e-9);
        if let (Some(first), Some(last)) = (first, last) {
            value = first.value;
            let rise = (last.value / first.value).ln() / (last.pressure - first.pressure);
            if rise.is_finite() && rise > 0.0 {
                slope = rise;
            }
        }
        Self {
            t_r,
            value,
            slope,
            thermal: high - low > ISOTHERM,
            walther: walther::start(data, density),
        }
    }
}

fn constants(law: LawName, start: &Start) -> Vec<Constant> {
    use Scale::{Logarithm, Multiple};
    let per_pressure = Dimension::INVERSE_PRESSURE;
    let kelvin = Dimension::TEMPERATURE_DIFFERENCE;
    let number = |key, value| Constant::new(key, "", Dimension::DIMENSIONLESS, value, Logarithm);
    let positive =
        |key, unit, dimension, value| Constant::new(key, unit, dimension, value, Logarithm);
    let any = |key, unit, dimension, value: f64, size: f64| {
        Constant::new(key, unit, dimension, value, Multiple(size))
    };
    let mu_0 = || positive("mu_0", "mPa.s", Dimension::VISCOSITY, start.value);
    let rho_0 = || positive("rho_0", "kg/m^3", Dimension::DENSITY, start.value);
    // Glass viscosity, C₁ and C₂ as usual (Yasutomi, Bair and Winer 1984); T_g0 then follows from μ at T_R:
    // lg(μ_g/μ) = C₁ x/(C₂ + x),  x = T_R - T_g0
    let glass = |[b_1, b_2]: [Constant; 2]| {
        let (mu_g, c_1, c_2) = (1e12, 16.0, 20.0);
        let decades = (mu_g / start.value).log10().clamp(1.0, c_1 - 0.8);
        let t_g0 = (start.t_r - c_2 * decades / (c_1 - decades)).max(50.0);
        vec![
            positive("mu_g", "Pa.s", Dimension::VISCOSITY, mu_g).hold(),
            positive("t_g0", "K", Dimension::TEMPERATURE, t_g0),
            positive("a_1", "K", kelvin, 20.0),
            positive("a_2", "1/GPa", per_pressure, 4e-9),
            b_1,
            b_2,
            number("c_1", c_1),
            positive("c_2", "K", kelvin, c_2),
        ]
    };
    let mut list = match law {
        LawName::Barus => vec![
            mu_0(),
            positive("alpha", "1/GPa", per_pressure, start.slope),
        ],
        LawName::Cheng => vec![
            mu_0(),
            any("alpha", "1/GPa", per_pressure, start.slope, 1e-9),
            any("beta", "K", kelvin, 1e3, 1e3),
            any(
                "gamma",
                "K/GPa",
                Dimension::TEMPERATURE_PER_PRESSURE,
                0.0,
                1e-6,
            ),
        ],
        LawName::Roelands => vec![
            mu_0(),
            positive("alpha", "1/GPa", per_pressure, start.slope),
            positive(
                "p_0",
                "MPa",
                Dimension::PRESSURE,
                Roelands::PRESSURE_CONSTANT,
            )
            .hold(),
        ],
        LawName::Wlf => glass([
            number("b_1", 0.2),
            positive("b_2", "1/GPa", per_pressure, 20e-9),
        ]),
        // Usual constants of F (Bair and others 2013).
        LawName::Yasutomi => glass([
            positive("b_1", "1/GPa", per_pressure, 8e-9),
            any("b_2", "", Dimension::DIMENSIONLESS, -0.4, 0.1),
        ]),
        LawName::McEwen => vec![
            mu_0(),
            positive("alpha", "1/GPa", per_pressure, 1.2 * start.slope),
            number("q", 10.0),
        ],
        LawName::Paluch => vec![
            mu_0(),
            number("c_f", start.slope * FAR),
            positive("p_inf", "GPa", Dimension::PRESSURE, FAR),
        ],
        LawName::Hybrid => vec![
            mu_0(),
            positive("a_0", "1/GPa", per_pressure, start.slope),
            number("q", 4.0),
            number("c_f", 0.2 * start.slope * FAR),
            positive("p_inf", "GPa", Dimension::PRESSURE, FAR),
        ],
        LawName::Doolittle => vec![mu_0(), number("b", 4.0), number("r_0", 0.65)],
        LawName::Walther => {
            let (a, b) = start.walther;
            vec![
                any("a", "", Dimension::DIMENSIONLESS, a, 1.0),
                number("b", b),
                positive("alpha", "1/GPa", per_pressure, start.slope),
                any("alpha_exponent", "", Dimension::DIMENSIONLESS, 0.0, 1.0).hold(),
            ]
        }
        LawName::Tait => {
            // The secant modulus over the data is about twice that at ambient pressure; exp(-β_K T_R) belongs to it.
            let k_0 = 0.5 / start.slope;
            let factor = if start.thermal {
                (0.006 * start.t_r).exp()
            } else {
                1.0
            };
            vec![
                rho_0(),
                positive("k_0r", "GPa", Dimension::PRESSURE, k_0 * factor),
                number("k_0r_prime", 10.0),
            ]
        }
        LawName::DowsonHigginson => vec![
            rho_0(),
            positive("c_1", "1/GPa", per_pressure, 2.0 * start.slope),
            positive("c_2", "1/GPa", per_pressure, DowsonHigginson::SATURATION),
        ],
    };
    if start.thermal {
        list.extend(thermal_constants(law));
    }
    list
}

/// Constants of the temperature terms that data at several temperatures determine.
fn thermal_constants(law: LawName) -> Vec<Constant> {
    let slope = |key, value| {
        let dimension = Dimension::INVERSE_TEMPERATURE;
        Constant::new(key, "1/K", dimension, value, Scale::Logarithm)
    };
    let any = |key, value| Constant {
        scale: Scale::Multiple(1e-3),
        ..slope(key, value)
    };
    match law {
        LawName::Roelands => vec![slope("beta", 0.03)],
        LawName::Doolittle => vec![any("epsilon", -1e-3)],
        LawName::Tait => vec![
            any("beta_k", 6e-3),
            any("beta_k_prime", 0.0).hold(),
            slope("a_v", 7e-4),
        ],
        LawName::DowsonHigginson => vec![slope("beta", 7e-4)],
        LawName::Barus
        | LawName::Cheng
        | LawName::Wlf
        | LawName::Yasutomi
        | LawName::McEwen
        | LawName::Paluch
        | LawName::Hybrid
        | LawName::Walther => Vec::new(),
    }
}

pub(super) fn parse_constant(law: LawName, key: &str, text: &str) -> Result<f64, FitError> {
    let start = Start {
        t_r: 300.0,
        value: 1.0,
        slope: 1e-9,
        thermal: true,
        walther: walther::USUAL,
    };
    let constants = constants(law, &start);
    let constant = constants
        .iter()
        .find(|c| c.key == key)
        .ok_or_else(|| unknown(law, key, &constants))?;
    ertel_quantity::parse(text, constant.dimension).map_err(|source| FitError::Value {
        key: key.to_owned(),
        source,
    })
}

fn unknown(law: LawName, key: &str, constants: &[Constant]) -> FitError {
    FitError::UnknownConstant {
        law,
        key: key.to_owned(),
        choices: constants
            .iter()
            .map(|c| c.key)
            .collect::<Vec<_>>()
            .join(", "),
    }
}

/// Text of a value (SI) in a unit, as a data file has it: `40 mPa.s`, or a bare number.
pub(super) fn written(value: f64, unit: &str) -> String {
    written_to(6, value, unit)
}

/// The same with so many significant digits.
pub(super) fn written_to(n_digits: usize, value: f64, unit: &str) -> String {
    // The units are those of the table above, which parse.
    let shown = Unit::parse(unit).map_or(value, |unit| unit.from_si(value));
    let number = crate::words::digits(shown, n_digits);
    if unit.is_empty() {
        number
    } else {
        format!("{number} {unit}")
    }
}

/// A law and what the fit may change in it.
pub(super) struct Model {
    law: LawName,
    pub(super) constants: Vec<Constant>,
    t_r: f64,
    thermal: bool,
    equation_of_state: Option<TaitVolume>,
    density: Option<DensityLaw>,
    pressure_law: PressureLaw,
}

impl Model {
    pub(super) fn new(data: &Data, law: LawName, params: &Params) -> Result<Self, FitError> {
        if law == LawName::Doolittle && params.equation_of_state.is_none() {
            return Err(FitError::NoEquationOfState);
        }
        // The volume of Doolittle's law is relative to that at its own reference temperature.
        let of_volume = params.equation_of_state.as_ref().and_then(|volume| {
            let thermal = volume.thermal.as_ref()?;
            (law == LawName::Doolittle).then_some(thermal.reference_temperature)
        });
        let start = Start::of(
            data,
            params.reference_temperature.or(of_volume),
            params.density.as_ref(),
        );
        let mut constants = constants(law, &start);
        let place = |constants: &[Constant], key: &str| {
            constants
                .iter()
                .position(|c| c.key == key)
                .ok_or_else(|| unknown(law, key, constants))
        };
        for key in &params.freed {
            let i = place(&constants, key)?;
            constants[i].held = false;
        }
        for (key, value) in &params.held {
            let i = place(&constants, key)?;
            constants[i].held = true;
            constants[i].start = *value;
        }
        if law == LawName::Walther {
            let is_held = |key: &str| constants.iter().any(|c| c.key == key && c.held);
            walther::check(data, params, is_held)?;
        }
        Ok(Self {
            law,
            constants,
            t_r: start.t_r,
            thermal: start.thermal,
            equation_of_state: params.equation_of_state.clone(),
            density: params.density.clone(),
            pressure_law: params.pressure_law,
        })
    }

    /// Reference temperature (K) where the law has one.
    pub(super) fn reference_temperature(&self) -> Option<f64> {
        match self.law {
            LawName::Cheng | LawName::Walther => Some(self.t_r),
            LawName::Barus
            | LawName::Wlf
            | LawName::Yasutomi
            | LawName::McEwen
            | LawName::Paluch
            | LawName::Hybrid => None,
            _ => self.thermal.then_some(self.t_r),
        }
    }

    /// Its constants (SI), of which the `free` ones are `x` on their scales; those without one are as at the start.
    pub(super) fn values(&self, free: &[usize], x: &[f64]) -> Vec<f64> {
        let mut values: Vec<f64> = self.constants.iter().map(|c| c.start).collect();
        for (i, x) in free.iter().zip(x) {
            values[*i] = self.constants[*i].unscaled(*x);
        }
        values
    }

    /// The law with these constants (SI, in the order of [`Model::constants`]); on the way of the search, constants of
    /// Cheng's law may be such that the viscosity falls with pressure.
    pub(super) fn build(&self, values: &[f64]) -> Result<FittedLaw, LawError> {
        if self.law == LawName::Cheng {
            return Ok(FittedLaw::Viscosity(ViscosityLaw::Cheng(Cheng {
                mu_0: values[0],
                alpha: values[1],
                beta: values[2],
                gamma: values[3],
                reference_temperature: self.t_r,
            })));
        }
        self.build_checked(values)
    }

    /// The law with these constants, checked.
    pub(super) fn build_checked(&self, v: &[f64]) -> Result<FittedLaw, LawError> {
        let viscosity = |law| Ok(FittedLaw::Viscosity(law));
        // `new` has seen to it that there is one.
        let missing = |law, key| LawError::NotFinite {
            law,
            key,
            value: f64::NAN,
        };
        let glass = |v: &[f64]| GlassTransition {
            glass_viscosity: v[0],
            glass_temperature: v[1],
            a_1: v[2],
            a_2: v[3],
            c_1: v[6],
            c_2: v[7],
        };
        let density = |law| Ok(FittedLaw::Density(law));
        let (t_r, thermal) = (self.t_r, self.thermal);
        match self.law {
            LawName::Barus => viscosity(ViscosityLaw::Barus(Barus::new(v[0], v[1])?)),
            LawName::Cheng => viscosity(ViscosityLaw::Cheng(Cheng::new(
                v[0], v[1], v[2], v[3], t_r,
            )?)),
            LawName::Roelands => {
                let slope = thermal.then(|| TemperatureSlope {
                    reference_temperature: t_r,
                    beta: v[3],
                });
                let law = Roelands::from_alpha(v[0], v[1], v[2], slope)?;
                viscosity(ViscosityLaw::Roelands(law))
            }
            LawName::Wlf => viscosity(ViscosityLaw::ModifiedWlf(ModifiedWlf::new(ModifiedWlf {
                glass: glass(v),
                b_1: v[4],
                b_2: v[5],
            })?)),
            LawName::Yasutomi => {
                let constants = ImprovedYasutomi {
                    glass: glass(v),
                    b_1: v[4],
                    b_2: v[5],
                };
                viscosity(ViscosityLaw::ImprovedYasutomi(ImprovedYasutomi::new(
                    constants,
                )?))
            }
            LawName::McEwen => viscosity(ViscosityLaw::McEwen(McEwen::new(v[0], v[1], v[2])?)),
            LawName::Paluch => viscosity(ViscosityLaw::Paluch(Paluch::new(v[0], v[1], v[2])?)),
            LawName::Hybrid => viscosity(ViscosityLaw::Hybrid(Hybrid::new(Hybrid {
                mu_0: v[0],
                a_0: v[1],
                q: v[2],
                fragility: v[3],
                divergence_pressure: v[4],
            })?)),
            LawName::Doolittle => {
                let occupied = thermal.then(|| OccupiedVolume {
                    reference_temperature: t_r,
                    expansivity: v[3],
                });
                let volume = self.equation_of_state.clone();
                let volume = volume.ok_or(missing("doolittle", "equation_of_state"))?;
                let law = Doolittle::new(v[0], v[1], v[2], occupied, volume)?;
                viscosity(ViscosityLaw::Doolittle(law))
            }
            LawName::Walther => {
                let law = Walther::new(Walther {
                    a: v[0],
                    b: v[1],
                    density: (self.density.clone()).ok_or(missing("walther", "density"))?,
                    alpha: v[2],
                    reference_temperature: t_r,
                    alpha_exponent: v[3],
                    pressure: self.pressure_law,
                })?;
                viscosity(ViscosityLaw::Walther(law))
            }
            LawName::Tait => {
                let softening = thermal.then(|| BulkModulusSoftening {
                    reference_temperature: t_r,
                    bulk_modulus_coefficient: v[3],
                    bulk_modulus_slope_coefficient: v[4],
                    expansivity: v[5],
                });
                let volume = TaitVolume::new(v[1], v[2], softening)?;
                density(DensityLaw::Tait(Tait::new(v[0], volume)?))
            }
            LawName::DowsonHigginson => {
                let expansion = thermal.then(|| ThermalExpansion {
                    reference_temperature: t_r,
                    temperature_coefficient: v[3],
                });
                let law = DowsonHigginson::with_constants(v[0], v[1], v[2], expansion)?;
                density(DensityLaw::DowsonHigginson(law))
            }
        }
    }
}
