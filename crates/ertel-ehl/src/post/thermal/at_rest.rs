//! Bodies whose computed depth heat reaches: how that depth affects the result.

use crate::forms::energy::Heat;
use crate::params::ThermalParams;
use crate::solution::Thermal;
use crate::warning::{Warning, WarningKind};

/// Diffusion depth over √(χ/(u a)) of a body that passes through the contact, 2a wide: 2√(χt) with t = 2a/u, where the heat has fallen
/// to erfc(1) = 16 % (Carslaw and Jaeger, Conduction of Heat in Solids, section 2.4).
const PASSAGE: f64 = 2.828;

/// Rise of a surface that counts, K.
const LEAST_RISE: f64 = 0.5;

/// Warnings about bodies so slow that heat reaches the depth at which they are cut off: their surface temperatures depend on that
/// depth.
pub fn warnings(heat: &Heat, thermal: &Thermal, params: &ThermalParams) -> Vec<Warning> {
    let means = [thermal.body_1_mean, thermal.body_2_mean];
    let bodies = heat.bodies.iter().zip(means).enumerate();
    bodies
        .filter_map(|(i, (body, mean))| {
            let reach = PASSAGE * body.diffusion_depth(heat.length);
            warning(
                i + 1,
                reach,
                mean.value - body.bulk_temperature,
                params.depth,
            )
        })
        .collect()
}

/// The warning for a body that heat enters to `reach` half-widths, whose surface rises by `rise`, K, and that is cut off at `depth`.
fn warning(body: usize, reach: f64, rise: f64, depth: f64) -> Option<Warning> {
    if reach <= depth || rise.abs() <= LEAST_RISE {
        return None;
    }
    let why = match reach.is_finite() {
        true => "moves so slowly that",
        false => "is at rest:",
    };
    let text = format!(
        "body {body} {why} heat reaches the depth of {depth} half-widths ([thermal] depth), where the bulk temperature is prescribed: its \
         surface rise of {rise:.1} K depends on that depth, and so do film and traction. No error bar covers this; set depth to where the \
         temperature is known"
    );
    Some(Warning::new(WarningKind::BodyDepth, text))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A pin at rest, 40 K above its bulk, is reported with its rise; a moving body, whose heat stays within the depth, and a rise of 0.1 K are not.
    #[test]
    fn bodies_at_rest_are_reported() {
        let text = warning(2, f64::INFINITY, 40.0, 3.15).unwrap().text;
        assert!(
            text.starts_with("body 2 is at rest: heat reaches the depth of 3.15"),
            "{text}"
        );
        assert!(text.contains("rise of 40.0 K"), "{text}");
        let slow = warning(1, 5.0, -3.0, 3.15).unwrap().text;
        assert!(slow.starts_with("body 1 moves so slowly that"), "{slow}");
        assert_eq!(warning(1, 0.9, 40.0, 3.15), None);
        assert_eq!(warning(1, f64::INFINITY, 0.1, 3.15), None);
    }
}
