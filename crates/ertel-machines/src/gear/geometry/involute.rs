//! The involute function and its inverse.

/// inv α = tan α − α, α in rad.
pub fn involute(angle: f64) -> f64 {
    angle.tan() - angle
}

/// The angle α (rad) of which inv α = y, y > 0; `None` if y is negative or not finite.
///
/// Newton's method: d(inv α)/dα = tan² α, from α ≈ ∛(3y) for small y, which is above the root: inv is convex, so the steps come from one side.
pub fn inverse_involute(y: f64) -> Option<f64> {
    if !(0.0..f64::INFINITY).contains(&y) {
        return None;
    }
    if y == 0.0 {
        return Some(0.0);
    }
    // For large y the root approaches π/2, with tan α = y + α.
    let mut angle = (3.0 * y).cbrt().min((y + 1.6).atan());
    for _ in 0..100 {
        let tangent = angle.tan();
        let step = (tangent - angle - y) / (tangent * tangent);
        angle -= step;
        if step.abs() <= 1e-15 * angle {
            break;
        }
    }
    Some(angle)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// inv 20° = 0.014904 and inv 30° = 0.053751 in every table of the function.
    #[test]
    fn values_of_tables() {
        for (degrees, value) in [(20.0_f64, 0.014904), (30.0, 0.053751)] {
            assert!((involute(degrees.to_radians()) - value).abs() < 5e-7);
        }
    }

    #[test]
    fn inverse_leads_back() {
        for degrees in [0.5_f64, 3.0, 14.5, 20.0, 25.0, 45.0, 70.0, 85.0] {
            let angle = degrees.to_radians();
            let back = inverse_involute(involute(angle)).expect("positive");
            assert!((back / angle - 1.0).abs() < 1e-10, "{degrees}");
        }
        assert_eq!(inverse_involute(-1e-3), None);
        assert_eq!(inverse_involute(f64::NAN), None);
    }
}
