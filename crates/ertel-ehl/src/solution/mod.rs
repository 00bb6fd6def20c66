//! Result of a solve: plain data in SI, ready for output.

mod asked;
mod checks;
mod contact_fields;
mod elements;
mod estimate;
mod field;
mod figure_kinds;
mod figures;
mod history;
pub mod limits;
mod mixed;
mod neglected;
mod other_films;
mod point_fields;
mod role;
mod roller;
mod sensitivities;
mod separation;
mod starvation;
mod stats;
mod summary;
mod thermal;
mod traction;
mod uncertainty;
mod unresolved;
mod wear;
mod whole;

pub use asked::Asked;
pub use checks::{Balance, Checks, SummedTo};
pub use contact_fields::{ContactFields, GridField};
pub use contact_fields::{Mirrored, mirror, near_zero};
pub use elements::{ElementFields, Polynomials, TemperaturePolynomials};
pub use estimate::{Estimate, Located, WIDEST};
pub use field::Field;
pub use figures::{
    Bar, Bars, ErrorClass, Figure, Figures, Kind, LEAST_RISE, Measured, PerFigure, ROUNDING,
    Reading, Section, Sizes, WIDEST_OF_PLACE,
};
pub use history::{HeatRound, IterationRecord};
pub use mixed::{AsperityFigures, MixedFriction, MixedLubrication, OtherGap};
pub use neglected::{Neglected, NeglectedHeat};
pub use other_films::{FilmReduction, FormulaFilm};
pub use point_fields::{BodyField, Centreline, ShearFields, SurfaceField};
pub use role::Role;
pub use sensitivities::{
    FigureSensitivity, LeftOut, Sensitivities, SensitivityInput, SensitivityMethod,
};
pub use separation::{BOUNDARY_BELOW, FULL_FROM, Separation, roughness_warning};
pub use starvation::Starvation;
pub use stats::{LevelStats, Stats, Timings};
pub use summary::Summary;
pub use thermal::{
    Coupling, CrossProfile, FilmTemperatures, HeatBalance, TemperatureField, Thermal,
    ThermalReduction,
};
pub use traction::{Traction, TractionAcross};
pub use uncertainty::{FigureUncertainty, Uncertainties};
pub use unresolved::{OPEN_MASS_BALANCE, Unresolved, Why};
pub use wear::{BodyWear, Wear, WearStep};
pub use whole::Solution;
