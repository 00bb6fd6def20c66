//! Figures of machines and transient runs that are drawn over the quantity of a curve or the axis of a study, and listed per point in its report.

use super::super::pictures::film_unit;
use ertel_plot::Look;

/// Figures drawn in one picture.
pub(in crate::output) struct Drawn {
    /// Name of the picture in a study.
    pub name: &'static str,
    /// Name of the picture in a curve.
    pub curve: &'static str,
    /// Label of the vertical axis.
    pub axis: &'static str,
    scale: Scale,
    /// The figures, by registry name.
    pub figures: &'static [&'static str],
}

/// Display unit of the values.
#[derive(Clone, Copy)]
enum Scale {
    Film,
    Torque,
    Unit(&'static str),
    Share,
    Celsius,
    Pressure,
    Pure,
}

/// Every picture of machines over a varied quantity; a machine has those for which it has figures.
pub(in crate::output) const DRAWN: [Drawn; 8] = [
    Drawn {
        name: "film",
        curve: "film-curve",
        axis: "Film thickness *h*",
        scale: Scale::Film,
        figures: &["film_central", "film_minimum"],
    },
    Drawn {
        name: "friction-torque",
        curve: "friction-torque-curve",
        axis: "Friction torque",
        scale: Scale::Torque,
        figures: &[
            "friction_torque",
            "friction_torque_skf",
            "friction_torque_palmgren",
        ],
    },
    Drawn {
        name: "friction-power",
        curve: "friction-power-curve",
        axis: "Power lost",
        scale: Scale::Unit("W"),
        figures: &[
            "friction_power",
            "friction_power_rolling",
            "friction_power_models",
        ],
    },
    Drawn {
        name: "mesh-loss",
        curve: "mesh-loss-curve",
        axis: "Power lost over the power at the pinion",
        scale: Scale::Share,
        figures: &["mesh_loss"],
    },
    Drawn {
        name: "friction-coefficient",
        curve: "friction-coefficient-curve",
        axis: "Mean coefficient of friction",
        scale: Scale::Pure,
        figures: &["friction_coefficient_mean", "friction_coefficient_schlenk"],
    },
    Drawn {
        name: "temperature",
        curve: "temperature-curve",
        axis: "Temperature",
        scale: Scale::Celsius,
        figures: &[
            "bearing_temperature",
            "contact_temperature",
            "contact_temperature_blok",
        ],
    },
    Drawn {
        name: "safety",
        curve: "safety-curve",
        axis: "Safety",
        scale: Scale::Pure,
        figures: &[
            "static_safety_factor",
            "scuffing_safety",
            "micropitting_safety",
        ],
    },
    Drawn {
        name: "life",
        curve: "life-curve",
        axis: "Rating life",
        scale: Scale::Unit("million revolutions"),
        figures: &[
            "modified_rating_life",
            "reference_rating_life",
            "basic_rating_life",
        ],
    },
];

/// Every picture of transient runs over a varied quantity.
pub(in crate::output) const DRAWN_IN_TIME: [Drawn; 4] = [
    Drawn {
        name: "film",
        curve: "film-curve",
        axis: "Film thickness *h*",
        scale: Scale::Film,
        figures: &["film_central_lowest", "film_minimum_lowest"],
    },
    Drawn {
        name: "traction",
        curve: "traction-curve",
        axis: "Friction coefficient",
        scale: Scale::Pure,
        figures: &["traction_coefficient_highest", "traction_coefficient_mean"],
    },
    Drawn {
        name: "pressure",
        curve: "pressure-curve",
        axis: "Pressure *p*",
        scale: Scale::Pressure,
        figures: &["pressure_maximum_highest"],
    },
    Drawn {
        name: "amplitude-ratio",
        curve: "amplitude-ratio-curve",
        axis: "Amplitude ratio *A*_{d}/*A*_{i}",
        scale: Scale::Pure,
        figures: &["amplitude_ratio_last"],
    },
];

/// Figures listed in the report of a curve for each transient run.
pub(in crate::output) const REPORTED_IN_TIME: [&str; 8] = [
    "film_central_lowest",
    "film_minimum_lowest",
    "film_central_last",
    "pressure_maximum_highest",
    "traction_coefficient_highest",
    "traction_coefficient_mean",
    "amplitude_ratio_last",
    "coefficient_of_restitution",
];

/// Figures listed in the report of a curve for each machine.
pub(in crate::output) const REPORTED: [&str; 12] = [
    "film_minimum",
    "lambda_minimum",
    "friction_torque",
    "friction_power",
    "mesh_loss",
    "friction_coefficient_mean",
    "bearing_temperature",
    "contact_temperature",
    "static_safety_factor",
    "scuffing_safety",
    "micropitting_safety",
    "modified_rating_life",
];

impl Drawn {
    /// SI unit of the figures in the registry.
    pub fn unit(&self) -> &'static str {
        match self.scale {
            Scale::Film => "m",
            Scale::Torque => "N m",
            Scale::Unit(unit) => unit,
            Scale::Celsius => "K",
            Scale::Pressure => "Pa",
            Scale::Share | Scale::Pure => "",
        }
    }

    /// Factor and offset from SI to the display unit, and the axis label, given the largest value (SI).
    pub fn scale(&self, largest: f64) -> ([f64; 2], String) {
        let (factor, summand, unit) = match self.scale {
            Scale::Film => {
                let (factor, unit) = film_unit(largest);
                (factor, 0.0, unit)
            }
            Scale::Torque if largest < 1.0 => (1e3, 0.0, "N mm"),
            Scale::Torque => (1.0, 0.0, "N m"),
            Scale::Unit(unit) => (1.0, 0.0, unit),
            Scale::Share => (100.0, 0.0, "%"),
            Scale::Celsius => (1.0, -273.15, "°C"),
            Scale::Pressure => (1e-9, 0.0, "GPa"),
            Scale::Pure => (1.0, 0.0, ""),
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
