//! A gap that is filled by a layer of oil thinner than itself: the inlet of a starved contact, dimensionless.
//!
//! ```text
//!   θH = H − F,   F = D g(κP/D),   D = max(H − H_oil, 0),   κ = H³/(λl)
//!   g(t) = 1 − t/(1 − t) for t < 0,   (1 − t)²(1 + t) up to 1,   0 beyond: g(0) = 1, g'(0) = −1, smooth
//!   ∇·(ρ̄ θH ū) = ∇·(ε∇P)
//! ```
//! Where there is no pressure, the gap carries the layer that arrives, H_oil; where there is, it is full. Between them is the
//! meniscus: oil that arrives flows on at once or is held back by pressure, (H − H_oil) u = ε ∂P/∂X there, as mass conservation asks
//! for (Jakobsson and Floberg 1957; Elrod, J. Lubr. Technol. 103 (1981) 350-354). Here the gap fills up over a length l: P grows
//! e-fold over l, at first, until θ = 1. Pressures just below zero, where the film has broken, stand for less oil than the layer. What flows in is ρ̄H_oil whatever l is, so that a line contact is the same downstream of it.

use super::dual::Number;
use crate::contact::OilLayer;

/// What a gap lacks, and how that changes.
#[derive(Clone, Copy, Debug)]
pub struct Missing<D> {
    /// F.
    pub film: D,
    /// ∂F/∂P.
    pub by_pressure: D,
    /// ∂F/∂H.
    pub by_film: D,
}

/// What a gap H lacks at the pressure P where it fills up over the length l; `None` where it is full.
#[inline(always)]
pub fn missing<D: Number>(
    layer: &OilLayer,
    pressure: D,
    film: D,
    length: f64,
) -> Option<Missing<D>> {
    let lacking = film - layer.thickness;
    if lacking.re() <= 0.0 {
        return None;
    }
    let stiffness = film * film * film / (layer.lambda * length);
    let held = stiffness * pressure / lacking;
    let [share, slope] = share(held)?;
    Some(Missing {
        film: lacking * share,
        by_pressure: stiffness * slope,
        by_film: share + slope * held * (lacking * 3.0 / film - 1.0),
    })
}

/// g(t) and its derivative; `None` where it is zero.
#[inline(always)]
fn share<D: Number>(t: D) -> Option<[D; 2]> {
    if t.re() >= 1.0 {
        None
    } else if t.re() >= 0.0 {
        let left = -t + 1.0;
        Some([left * left * (t + 1.0), -left * (t * 3.0 + 1.0)])
    } else {
        let r = (-t + 1.0).recip();
        Some([-t * r + 1.0, -r * r])
    }
}

/// Length over which a gap fills up on elements of a size and order: the distance of their nodes. Measured on a ball: over a third of
/// it pressures oscillate and Newton's method takes five times as long, over three of it films err three times as much.
pub fn filling_length(size: f64, order: usize) -> f64 {
    size / order as f64
}
