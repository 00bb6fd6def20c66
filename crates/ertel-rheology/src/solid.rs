//! A solid: elastic and thermal properties, and where its numbers come from.

use crate::provenance::Datum;
use crate::{ConductivityLaw, HeatCapacityLaw};

/// An isotropic linear elastic solid.
#[derive(Debug, Clone, PartialEq)]
pub struct Solid {
    /// Name in the database or in the case file.
    pub name: String,
    /// Description in a few words.
    pub title: String,
    /// Young's modulus (Pa).
    pub youngs_modulus: f64,
    /// Poisson's ratio (-).
    pub poissons_ratio: f64,
    /// Largest Hertz pressure (Pa) without permanent damage of the solid: yield of ductile ones, cracks of brittle ones.
    pub hertz_pressure_limit: Option<f64>,
    /// Density (kg/m³).
    pub density: Option<f64>,
    /// Law of the thermal conductivity, evaluated at ambient pressure.
    pub thermal_conductivity: Option<ConductivityLaw>,
    /// Law of the heat capacity, evaluated at ambient pressure.
    pub heat_capacity: Option<HeatCapacityLaw>,
    /// Notes for users of this solid.
    pub notes: Vec<String>,
    /// Every number with its source.
    pub provenance: Vec<Datum>,
}
