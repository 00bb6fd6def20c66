//! Which bodies wear, how far they slide, and the steps.

/// How a body wears.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WearingBody {
    /// k, dimensionless.
    pub coefficient: f64,
    /// H, Pa.
    pub hardness: f64,
    /// L, m; `None` of a body at rest in the contact.
    pub track_length: Option<f64>,
}

/// Wear over a sliding distance.
#[derive(Clone, Debug, PartialEq)]
pub struct WearParams {
    /// Body 1 and body 2; `None` where a body does not wear.
    pub bodies: [Option<WearingBody>; 2],
    /// Sliding distance, m.
    pub distance: f64,
    /// Largest depth that both bodies together lose in a step, over the composite rms height.
    pub step: f64,
    /// Most steps.
    pub max_steps: usize,
}

impl WearParams {
    /// Default of `step`: a pressure of asperities falls to 1/e over 0.3 to 0.6 of the rms height, and explicit steps oscillate where one changes it by more than itself.
    pub const STEP: f64 = 0.1;

    /// Default of `max_steps`.
    pub const MAX_STEPS: usize = 400;
}
