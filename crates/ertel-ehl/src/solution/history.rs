//! Every Newton iteration of a solve.

use serde::Serialize;

/// One Newton iteration.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct IterationRecord {
    /// Mesh level, 0 the coarsest.
    pub level: usize,
    /// Pressure order on this level.
    pub pressure_order: usize,
    /// Share of the full cavitation penalty in force.
    pub penalty_share: f64,
    /// Iteration count on this level, from 1.
    pub iteration: usize,
    /// Reynolds residual relative to the entrained flow (dimensionless).
    pub residual: f64,
    /// Largest pressure update over p_h.
    pub update: f64,
    /// Share of the Newton step taken.
    pub step: f64,
    /// Krylov iterations of the linear solve.
    pub krylov_iterations: usize,
    /// Central film thickness after the step, m.
    pub film_central: f64,
    /// The round of the film-temperature coupling that this step ended.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub heat: Option<HeatRound>,
}

/// A round in which films are computed at given temperatures, and temperatures at given films.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct HeatRound {
    /// Relative change of temperature rise, pressure and film from the round before.
    pub change: f64,
    /// Largest temperature rise, K.
    pub temperature_rise: f64,
}
