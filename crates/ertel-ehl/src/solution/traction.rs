//! Traction and friction, SI.

use serde::Serialize;

use super::Estimate;

/// Traction and friction.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Traction {
    /// Traction coefficient from the stress at mid-film; positive where body 2 is the faster surface.
    #[serde(rename = "traction_coefficient")]
    pub coefficient: Estimate,
    /// The same from the stress at body 1.
    #[serde(rename = "traction_coefficient_body_1")]
    pub coefficient_body_1: Estimate,
    /// The same from the stress at body 2.
    #[serde(rename = "traction_coefficient_body_2")]
    pub coefficient_body_2: Estimate,
    /// Traction force at mid-film: N (circular), N/m (line).
    #[serde(rename = "traction_force")]
    pub force: Estimate,
    /// Traction across the motion, where the contact is not symmetric about y = 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub across: Option<TractionAcross>,
    /// Moment of the traction at mid-film about the contact normal, from x towards y, N m, with which body 2 turns body 1; likewise,
    /// and not of line contacts.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[serde(rename = "traction_moment")]
    pub moment: Option<Estimate>,
    /// Friction power, the work of the surfaces on the film: W (circular), W/m (line).
    pub friction_power: Estimate,
    /// Largest shear stress anywhere in the film, Pa.
    pub shear_stress_maximum: Estimate,
    /// Share of the Hertz zone where the stress, at its largest across the film, thins the fluid by more than
    /// 5 %; `None` for Newtonian fluids.
    pub beyond_first_limit: Option<Estimate>,
    /// Share where it brings the fluid within 5 % of its second plateau; `None` without one.
    pub beyond_second_limit: Option<Estimate>,
}

impl Traction {
    /// Size of the traction coefficient of both components, with the larger of their error bars.
    pub fn size(&self) -> Estimate {
        let Some(across) = &self.across else {
            return Estimate {
                value: self.coefficient.value.abs(),
                error: self.coefficient.error,
            };
        };
        let (along, across) = (self.coefficient, across.coefficient);
        Estimate {
            value: along.value.hypot(across.value),
            error: along.error.zip(across.error).map(|(a, b)| a.max(b)),
        }
    }
}

/// Traction across the motion.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct TractionAcross {
    /// Traction coefficient from the stress at mid-film; positive where body 2 drags body 1 towards +y.
    #[serde(rename = "traction_coefficient_across")]
    pub coefficient: Estimate,
    /// The same from the stress at body 1.
    #[serde(rename = "traction_coefficient_across_body_1")]
    pub coefficient_body_1: Estimate,
    /// The same from the stress at body 2.
    #[serde(rename = "traction_coefficient_across_body_2")]
    pub coefficient_body_2: Estimate,
    /// Traction force at mid-film: N, N/m (line).
    #[serde(rename = "traction_force_across")]
    pub force: Estimate,
}
