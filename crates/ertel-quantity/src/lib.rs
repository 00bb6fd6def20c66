//! Numbers with units: `"16 mm"`, `"22 1/GPa"`, `"40 degC"` to SI, with the dimension checked.
//!
//! A quantity is a number followed by a unit expression. Units multiply with `.`, `*` or a space, divide
//! with `/` and take integer powers (`m^3`, `m3`, `m³`, `GPa^-1`). A product after a slash needs
//! parentheses, `J/(kg.K)`, because `J/kg.K` is read both ways by people.
//!
//! `degC` and `degF` are offset units: alone, and where a temperature is asked for, `40 degC` is 313.15 K;
//! where a temperature difference is asked for, or inside a compound unit, `degC` is the same as `K`.

mod comma;
mod dimension;
mod number;
mod quantity;
mod saybolt;
mod symbols;
mod uncertain;
mod unit;

pub use dimension::Dimension;
pub use quantity::{QuantityError, parse, parse_any};
pub use saybolt::{corrected as saybolt_corrected, is_saybolt};
pub use symbols::STANDARD_ATMOSPHERE;
pub use uncertain::{COVERAGE, CUT, Correlation, Uncertainty, parse_uncertain};
pub use unit::{Unit, UnitError};

#[cfg(test)]
mod tests;
