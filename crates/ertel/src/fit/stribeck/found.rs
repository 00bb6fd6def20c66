//! Constants of rough surfaces by a measured Stribeck curve, with their uncertainties, and the readings next to the fit.

use crate::mixed::{Asperities, AsperityLaw, Flow};
use crate::words::{digits, length};

/// Standard uncertainty over the value from which a constant is not resolved.
const NOT_RESOLVED: f64 = 0.5;

/// A constant of rough surfaces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SurfaceConstant {
    /// f_b.
    BoundaryFriction,
    /// σ, m.
    RmsHeight,
    /// σβη.
    AsperityGroup,
}

impl SurfaceConstant {
    /// Its name in programs.
    pub fn name(self) -> &'static str {
        match self {
            SurfaceConstant::BoundaryFriction => "boundary_friction_coefficient",
            SurfaceConstant::RmsHeight => "rms_height",
            SurfaceConstant::AsperityGroup => "asperity_group",
        }
    }

    /// Its name in words.
    pub fn words(self) -> &'static str {
        match self {
            SurfaceConstant::BoundaryFriction => "boundary friction coefficient",
            SurfaceConstant::RmsHeight => "composite rms height σ",
            SurfaceConstant::AsperityGroup => "asperity group σβη",
        }
    }

    /// A value with its unit.
    pub fn text(self, value: f64) -> String {
        match self {
            SurfaceConstant::RmsHeight => length(value),
            _ => digits(value, 4),
        }
    }
}

/// A constant that was fitted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfaceEstimate {
    /// Which one.
    pub constant: SurfaceConstant,
    /// Where the sum of squares is smallest, SI.
    pub value: f64,
    /// Standard uncertainty, same unit; `None` where the constant has no influence on the friction at these speeds.
    pub standard: Option<f64>,
}

impl SurfaceEstimate {
    /// Whether the data determine the constant.
    pub fn is_resolved(&self) -> bool {
        (self.standard).is_some_and(|standard| standard <= NOT_RESOLVED * self.value.abs())
    }
}

/// A measured friction coefficient and the fitted one.
#[derive(Clone, Debug, PartialEq)]
pub struct FittedPoint {
    /// Line of the table, from 1.
    pub line: usize,
    /// The operating point: `motion.entrainment_speed = 0.1 m/s`.
    pub label: String,
    /// Measured friction coefficient.
    pub measured: f64,
    /// Of film and asperities together, with the fitted constants.
    pub fitted: f64,
    /// Part of the asperities.
    pub asperities: f64,
}

/// Constants of rough surfaces from a measured Stribeck curve.
#[derive(Clone, Debug, PartialEq)]
pub struct StribeckFit {
    /// Boundary friction coefficient, σ, and σβη where it was fitted.
    pub constants: Vec<SurfaceEstimate>,
    /// Coefficients of correlation of pairs of constants that are resolved.
    pub correlations: Vec<(SurfaceConstant, SurfaceConstant, f64)>,
    /// The readings, in the order of the table.
    pub points: Vec<FittedPoint>,
    /// Standard deviation of the readings from the fit; over their uncertainty where the table gives it for all.
    pub scatter: f64,
    /// Whether the readings are weighted by their uncertainties.
    pub is_weighted: bool,
    /// Contacts solved.
    pub n_solves: usize,
    /// Target error of the films of these contacts.
    pub target_error: f64,
    /// Largest error bar of their friction coefficients near the fitted constants.
    pub largest_bar: f64,
    /// Limits of the fit, in words.
    pub warnings: Vec<String>,
    /// The asperities of the case.
    pub(super) asperities: Asperities,
    /// Composite rms height of the case, m.
    pub(super) rms_height: f64,
}

impl StribeckFit {
    /// A constant, if it was fitted.
    pub fn constant(&self, constant: SurfaceConstant) -> Option<&SurfaceEstimate> {
        self.constants.iter().find(|own| own.constant == constant)
    }

    /// `[surface_roughness]` with the fitted constants, and those of the case where the data do not determine them.
    pub fn section(&self) -> String {
        let line = |key: &str, constant: SurfaceConstant, given: Option<f64>| -> String {
            let write = |value: f64| match constant {
                SurfaceConstant::RmsHeight => format!("\"{}\"", length(value).replace('µ', "u")),
                _ => digits(value, 4),
            };
            match (self.constant(constant), given) {
                (Some(own), _) if own.is_resolved() => format!(
                    "{key} = {}    # ± {}\n",
                    write(own.value),
                    constant.text(own.standard.unwrap_or(0.0))
                ),
                (Some(_), Some(given)) => {
                    format!(
                        "{key} = {}    # not resolved: value of the case\n",
                        write(given)
                    )
                }
                (Some(_), None) => format!("# {key}: not resolved\n"),
                (None, Some(given)) => format!("{key} = {}\n", write(given)),
                (None, None) => String::new(),
            }
        };
        let own = &self.asperities;
        let flow = (Flow::ALL.iter()).find_map(|(name, flow)| (*flow == own.flow).then_some(*name));
        let flow = flow.unwrap_or_default();
        let mut text = "[surface_roughness]\n".to_owned();
        text += "# Composite rms height of both surfaces.\n";
        let given = Some(self.rms_height);
        text += &line("body_1_rms_height", SurfaceConstant::RmsHeight, given);
        text += "body_2_rms_height = \"0 nm\"\n";
        text += &self.law(&line);
        if let Some(hardness) = own.hardness {
            text += &format!("hardness = \"{} GPa\"\n", digits(hardness / 1e9, 6));
        }
        let friction = SurfaceConstant::BoundaryFriction;
        let given = own.boundary_friction_coefficient;
        text += &line("boundary_friction_coefficient", friction, given);
        text += &format!("flow = \"{flow}\"\n");
        if let Some(orientation) = own.orientation {
            text += &format!("orientation = \"{}\"\n", orientation.name());
        }
        text
    }

    /// The law of the asperities with its numbers; `line` writes a key of a constant.
    fn law(&self, line: &dyn Fn(&str, SurfaceConstant, Option<f64>) -> String) -> String {
        match &self.asperities.law {
            law @ (AsperityLaw::GreenwoodTripp(of) | AsperityLaw::GreenwoodWilliamson(of)) => {
                let name = match law {
                    AsperityLaw::GreenwoodWilliamson(_) => {
                        "asperity_law = \"greenwood-williamson\"\n"
                    }
                    _ => "",
                };
                let constant = SurfaceConstant::AsperityGroup;
                let group = line("asperity_group", constant, Some(of.asperity_group));
                let ratio = digits(of.rms_height_to_asperity_radius, 6);
                format!("{name}{group}rms_height_to_asperity_radius = {ratio}\n")
            }
            AsperityLaw::Persson(of) => format!(
                "asperity_law = \"persson\"\nrms_slope = {}\ndecay_length_to_rms_height = {}\npressure_factor = {}\n",
                digits(of.rms_slope, 6),
                digits(of.decay_length_to_rms_height, 6),
                digits(of.pressure_factor, 6)
            ),
            AsperityLaw::Table(_) => {
                "# asperity_law = \"table\" with the table of the case\n".to_owned()
            }
        }
    }
}
