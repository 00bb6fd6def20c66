//! Comparison of numbers in tests of all crates.

use approx::assert_relative_eq;

/// Two numbers within a relative tolerance.
#[track_caller]
pub fn near(found: f64, expected: f64, tolerance: f64) {
    assert_relative_eq!(found, expected, max_relative = tolerance);
}
