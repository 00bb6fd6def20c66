//! Film and heat in turn: how the rounds of both numerical methods are relaxed, and when those of finite elements end.

mod relaxation;
mod stopping;

pub use relaxation::Relaxation;
pub use stopping::StoppingRule;

/// Change of a temperature rise from round to round that does not matter, K.
pub const NEGLIGIBLE_RISE: f64 = 1e-3;

/// Share of a round's change to which each of its halves is solved.
pub const INNER_SHARE: f64 = 0.1;
