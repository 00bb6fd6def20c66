//! Figures of machines and runs in time that are drawn over the quantity of a curve or the axis of a study.

use super::pictures::film_unit;
use crate::figures::{Definition, bearing, gears, machine, run};
use crate::solution::Kind;
use crate::words::CELSIUS;
use ertel_plot::Look;

/// Figures drawn in one picture.
pub(super) struct Drawn {
    /// Name of the picture in a study.
    pub name: &'static str,
    /// Name of the picture in a curve.
    pub curve: &'static str,
    /// Label of the vertical axis.
    axis: &'static str,
    /// The figures, all of one kind.
    pub figures: &'static [Definition],
}

macro_rules! drawn {
    ($($name:literal, $axis:literal, [$($figure:path),*];)*) => {
        [$(Drawn {
            name: $name,
            curve: concat!($name, "-curve"),
            axis: $axis,
            figures: &[$($figure),*],
        }),*]
    };
}

/// Every picture over a varied quantity; a machine or a run has those for which it has figures.
#[rustfmt::skip]
pub(super) const DRAWN: [Drawn; 12] = drawn! {
    "film", "Film thickness *h*", [machine::FILM_CENTRAL, machine::FILM_MINIMUM];
    "friction-torque", "Friction torque",
        [bearing::FRICTION_TORQUE, bearing::FRICTION_TORQUE_SKF, bearing::FRICTION_TORQUE_PALMGREN];
    "friction-power", "Power lost",
        [bearing::FRICTION_POWER, machine::FRICTION_POWER_ROLLING, gears::FRICTION_POWER_MODELS];
    "mesh-loss", "Power lost over the power at the pinion", [gears::MESH_LOSS];
    "friction-coefficient", "Mean coefficient of friction",
        [gears::FRICTION_COEFFICIENT_MEAN, gears::FRICTION_COEFFICIENT_SCHLENK];
    "temperature", "Temperature",
        [bearing::BEARING_TEMPERATURE, gears::CONTACT_TEMPERATURE, gears::CONTACT_TEMPERATURE_BLOK];
    "safety", "Safety", [bearing::STATIC_SAFETY_FACTOR, gears::SCUFFING_SAFETY, gears::MICROPITTING_SAFETY];
    "life", "Rating life",
        [bearing::MODIFIED_RATING_LIFE, bearing::REFERENCE_RATING_LIFE, bearing::BASIC_RATING_LIFE];
    "film", "Film thickness *h*", [run::FILM_CENTRAL_LOWEST, run::FILM_MINIMUM_LOWEST];
    "traction", "Friction coefficient", [run::TRACTION_COEFFICIENT_HIGHEST, run::TRACTION_COEFFICIENT_MEAN];
    "pressure", "Pressure *p*", [run::PRESSURE_MAXIMUM_HIGHEST];
    "amplitude-ratio", "Amplitude ratio *A*_{d}/*A*_{i}", [run::AMPLITUDE_RATIO_LAST];
};

impl Drawn {
    /// Whether its figures are those of runs in time.
    pub fn is_of_run(&self) -> bool {
        self.figures[0].is_of_run()
    }

    /// Factor and offset from SI to the display unit, and the axis label, given the largest value (SI).
    pub fn scale(&self, largest: f64) -> ([f64; 2], String) {
        let kind = self.figures[0].kind;
        let (factor, unit) = match kind {
            Kind::Length => film_unit(largest),
            Kind::Moment if largest < 1.0 => (1e3, "N mm"),
            Kind::Share => (100.0, "%"),
            Kind::Temperature => (1.0, "°C"),
            Kind::PeakPressure => (1e-9, "GPa"),
            _ => (1.0, kind.unit(false)),
        };
        let summand = match kind {
            Kind::Temperature => -CELSIUS,
            _ => 0.0,
        };
        let label = match unit {
            "" => self.axis.to_owned(),
            unit => format!("{} ({unit})", self.axis),
        };
        ([factor, summand], label)
    }

    /// Line style of the figure with this index: dashed for all but the first if they are formula results without bars.
    pub fn look(&self, figure: usize, has_bars: bool) -> Look {
        match (figure, has_bars) {
            (0, _) => Look::LineAndDots,
            (_, true) => Look::LineAndRings,
            (_, false) => Look::Dashed,
        }
    }
}
