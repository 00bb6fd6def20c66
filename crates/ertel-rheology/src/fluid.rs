//! A lubricant: its laws, and where its numbers come from.

use thiserror::Error;

use crate::data_sheet::BaseOil;
use crate::provenance::{Datum, RangeWarning, TemperatureRange, ValidityRange};
use crate::viscosity::NoAsymptote;
use crate::{ConductivityLaw, DensityLaw, HeatCapacityLaw, Scalar, ShearThinning, ViscosityLaw};

/// Viscosity from which on a liquid counts as a glass (Pa·s).
///
/// Source: Angell, Science 267 (1995) 1924-1935.
pub const GLASS_VISCOSITY: f64 = 1e12;
/// Highest pressure at which a glass is looked for (Pa).
const HIGHEST_PRESSURE: f64 = 10e9;

/// A lubricant.
#[derive(Debug, Clone, PartialEq)]
pub struct Fluid {
    /// Name in the database or in the case file.
    pub name: String,
    /// Description in a few words.
    pub title: String,
    /// Law of the viscosity, at low shear where the fluid thins.
    pub viscosity: ViscosityLaw,
    /// Shear thinning; `None` for a Newtonian lubricant, or where the source of the fluid says nothing about it.
    pub shear_thinning: Option<ShearThinning>,
    /// Density law; `None` where the source of the fluid gives none.
    pub density: Option<DensityLaw>,
    /// Temperature at which the reference viscosity and density hold (K).
    pub reference_temperature: Option<f64>,
    /// Law of the thermal conductivity.
    pub thermal_conductivity: Option<ConductivityLaw>,
    /// Law of the heat capacity.
    pub heat_capacity: Option<HeatCapacityLaw>,
    /// Kind of the base oil, if known: estimates of heat and shear are based on it.
    pub base_oil: Option<BaseOil>,
    /// Range of the data; `None` if nothing is known about it.
    pub validity: Option<ValidityRange>,
    /// Notes for users of this fluid.
    pub notes: Vec<String>,
    /// Every number with its source.
    pub provenance: Vec<Datum>,
}

/// A datum is missing that a computation needs.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum FluidError {
    /// The fluid has no density law.
    #[error(
        "the data of `{fluid}` have no density law. Add one to the lubricant of the case, for example \
         `density = {{ law = \"dowson-higginson\", rho_0 = \"...\" }}`"
    )]
    NoDensityLaw {
        /// Name of the fluid.
        fluid: String,
    },
}

impl Fluid {
    /// The density law.
    ///
    /// # Errors
    ///
    /// [`FluidError::NoDensityLaw`], which names what is missing and where to add it.
    pub fn density_law(&self) -> Result<&DensityLaw, FluidError> {
        self.density
            .as_ref()
            .ok_or_else(|| FluidError::NoDensityLaw {
                fluid: self.name.clone(),
            })
    }

    /// Density (kg/m³) at `pressure` (Pa above ambient) and `temperature` (K).
    ///
    /// # Errors
    ///
    /// [`FluidError::NoDensityLaw`].
    pub fn density<D: Scalar>(&self, pressure: D, temperature: D) -> Result<D, FluidError> {
        Ok(self.density_law()?.density(pressure, temperature))
    }

    /// Viscosity (Pa·s), at low shear where the fluid thins, at `pressure` (Pa above ambient) and `temperature` (K).
    pub fn viscosity<D: Scalar>(&self, pressure: D, temperature: D) -> D {
        self.viscosity.viscosity(pressure, temperature)
    }

    /// Initial slope `d ln μ/dp` at ambient pressure and `temperature` (K), in 1/Pa.
    pub fn pressure_viscosity_slope(&self, temperature: f64) -> f64 {
        self.viscosity.pressure_viscosity_slope(temperature)
    }

    /// Reciprocal asymptotic coefficient α* at `temperature` (K), in 1/Pa; see
    /// [`ViscosityLaw::pressure_viscosity_reciprocal_asymptotic`].
    ///
    /// # Errors
    ///
    /// [`NoAsymptote`] if the viscosity does not grow with pressure.
    pub fn pressure_viscosity_reciprocal_asymptotic(
        &self,
        temperature: f64,
    ) -> Result<f64, NoAsymptote> {
        self.viscosity
            .pressure_viscosity_reciprocal_asymptotic(temperature)
    }

    /// Warnings where pressures up to `pressure_max` (Pa above ambient) or `temperature` (K) leave the range of the
    /// data: the declared range, that of the tables of viscosity and density, and the glass transition of the WLF law.
    /// Of several limits that are passed, the tightest is reported.
    pub fn check_range(&self, pressure_max: f64, temperature: f64) -> Vec<RangeWarning> {
        self.check_tables(&self.mechanical_tables(), pressure_max, temperature)
    }

    /// [`Fluid::check_range`] that looks at the tables of conductivity and heat capacity, too.
    pub fn check_range_with_heat(&self, pressure_max: f64, temperature: f64) -> Vec<RangeWarning> {
        let mut tables = self.mechanical_tables();
        tables.extend(self.thermal_tables());
        self.check_tables(&tables, pressure_max, temperature)
    }

    /// Temperatures that the data cover: the declared range and that of every table.
    pub fn temperature_ranges(&self) -> Vec<TemperatureRange> {
        self.temperatures_of(&[self.mechanical_tables(), self.thermal_tables()].concat())
    }

    /// The declared range and that of these tables.
    fn temperatures_of(&self, tables: &[Tabulated]) -> Vec<TemperatureRange> {
        let declared = self.validity.as_ref();
        let declared = declared.and_then(|v| Some((v.temperature?, v.source.as_str())));
        let tabulated = (tables.iter()).map(|([_, temperature], basis)| (*temperature, *basis));
        declared
            .into_iter()
            .chain(tabulated)
            .map(|((lowest, highest), basis)| TemperatureRange {
                lowest,
                highest,
                basis: basis.to_owned(),
            })
            .collect()
    }

    /// Highest pressure (Pa above ambient) at which the viscosity at `temperature` (K) is known: the end of the declared
    /// range, of the table, of the law, or where the law passes [`GLASS_VISCOSITY`]; `None` if none of these is below
    /// 10 GPa.
    pub fn highest_pressure_of_viscosity(&self, temperature: f64) -> Option<f64> {
        let declared = self.validity.as_ref().and_then(|v| v.pressure);
        let table = self.viscosity.tabulated_range();
        let limits = [
            declared.map(|range| range.1),
            table.map(|[pressure, _]| pressure.1),
            self.end_of_law(temperature).map(|(limit, _)| limit),
            self.glass_pressure(temperature),
        ];
        limits
            .into_iter()
            .flatten()
            .min_by(f64::total_cmp)
            .map(|limit| limit.max(0.0))
    }

    /// Pressure (Pa above ambient) at which the viscosity at `temperature` (K) is that of a glass, by bisection.
    fn glass_pressure(&self, temperature: f64) -> Option<f64> {
        let is_glass = |pressure| self.viscosity(pressure, temperature) > GLASS_VISCOSITY;
        let [mut liquid, mut glass] = [0.0, HIGHEST_PRESSURE];
        if !is_glass(glass) {
            return None;
        }
        while glass - liquid > 1e-6 * HIGHEST_PRESSURE {
            let middle = 0.5 * (liquid + glass);
            match is_glass(middle) {
                true => glass = middle,
                false => liquid = middle,
            }
        }
        Some(glass)
    }

    /// Pressure (Pa above ambient) at which the law itself ends at `temperature` (K), and what ends it.
    fn end_of_law(&self, temperature: f64) -> Option<(f64, &'static str)> {
        match &self.viscosity {
            ViscosityLaw::ModifiedWlf(law) => Some((
                law.limiting_pressure(temperature),
                "end of the WLF law: glass transition or F = 0",
            )),
            ViscosityLaw::ImprovedYasutomi(law) => Some((
                law.limiting_pressure(temperature),
                "end of the Yasutomi law: glass transition",
            )),
            _ => None,
        }
    }

    fn mechanical_tables(&self) -> Vec<Tabulated> {
        let density = self.density.as_ref().and_then(DensityLaw::tabulated_range);
        named([
            (self.viscosity.tabulated_range(), "viscosity table"),
            (density, "density table"),
        ])
    }

    fn thermal_tables(&self) -> Vec<Tabulated> {
        let conductivity = self.thermal_conductivity.as_ref();
        let heat_capacity = self.heat_capacity.as_ref();
        named([
            (
                conductivity.and_then(ConductivityLaw::tabulated_range),
                "thermal conductivity table",
            ),
            (
                heat_capacity.and_then(HeatCapacityLaw::tabulated_range),
                "heat capacity table",
            ),
        ])
    }

    fn check_tables(
        &self,
        tables: &[Tabulated],
        pressure_max: f64,
        temperature: f64,
    ) -> Vec<RangeWarning> {
        let mut pressure_limits = Vec::new();
        if let Some(validity) = &self.validity {
            pressure_limits.extend(
                validity
                    .pressure
                    .map(|range| (range.1, validity.source.as_str(), validity.of_law)),
            );
        }
        for ([pressure, _], basis) in tables {
            pressure_limits.push((pressure.1, *basis, false));
        }
        if let Some((limit, basis)) = self.end_of_law(temperature) {
            pressure_limits.push((limit, basis, false));
        }

        let mut warnings = Vec::new();
        let tightest = pressure_limits
            .into_iter()
            .min_by(|a, b| a.0.total_cmp(&b.0));
        if let Some((limit, basis, of_law)) = tightest.filter(|(limit, ..)| pressure_max > *limit) {
            warnings.push(RangeWarning::PressureAbove {
                fluid: self.name.clone(),
                pressure: pressure_max,
                limit,
                basis: basis.to_owned(),
                of_law,
            });
        }
        let mut left = self.temperatures_of(tables);
        left.retain(|range| !range.contains(temperature));
        if let Some(range) = (left.into_iter()).min_by(|a, b| a.width().total_cmp(&b.width())) {
            warnings.push(RangeWarning::Temperature {
                fluid: self.name.clone(),
                temperature,
                range,
            });
        }
        warnings
    }
}

/// Range of pressure and temperature of a table, and what it is called.
type Tabulated = (Range, &'static str);
type Range = [(f64, f64); 2];

/// Those that are tables.
fn named(ranges: [(Option<Range>, &'static str); 2]) -> Vec<Tabulated> {
    let tables = ranges
        .into_iter()
        .filter_map(|(range, name)| Some((range?, name)));
    tables.collect()
}
