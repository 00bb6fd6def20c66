//! Why a Stribeck curve is not fitted.

/// Why there is no fit.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum StribeckError {
    /// A wrong kind of case.
    #[error("the case changes in time; a Stribeck curve is fitted to steady contacts")]
    InTime,
    /// Smooth surfaces.
    #[error(
        "the case describes no asperities: `asperity_group` and `rms_height_to_asperity_radius` in [surface_roughness], or another `asperity_law`"
    )]
    NoAsperities,
    /// Pure rolling.
    #[error("the surfaces do not slide: no friction of asperities depends on their constants")]
    NoSliding,
    /// The law of the case has no such number.
    #[error("asperity_group is not a number of the law of asperities of this case")]
    NoGroup,
    /// The table has no friction.
    #[error("no column `traction_coefficient` with the measured friction")]
    NoFriction,
    /// Too few readings.
    #[error("{0} readings do not determine {1} constants; {2} or more are needed")]
    TooFew(usize, usize, usize),
    /// The contacts do not converge.
    #[error("too few contacts converge around σ = {0}: {1}")]
    NotConverged(String, String),
    /// No uncertainty.
    #[error("{0}")]
    NoMinimum(String),
    /// The user stopped the fit.
    #[error("interrupted")]
    Interrupted,
}
