//! From the shapes of two bodies to the gap between them.

/// Principal curvatures of a body along its axes x and y, 1/m: positive convex, negative concave, zero flat.
pub type Curvatures = [f64; 2];

/// Principal curvatures of the gap between two bodies, 1/m, and the angle of the first principal direction to the x axis of
/// body 1, rad, from −45 to 45 degrees. The x axis of body 2 stands at `angle` (rad) to that of body 1.
///
/// ```text
///   G = ½ rᵀ K r,   K = diag(κ₁x, κ₁y) + Q diag(κ₂x, κ₂y) Qᵀ,   Q the rotation by the angle
/// ```
/// Source: Johnson 1985, eqs. 4.1 to 4.4, where K is written with its invariants.
pub fn gap_between(body_1: Curvatures, body_2: Curvatures, angle: f64) -> (Curvatures, f64) {
    let (s, c) = angle.sin_cos();
    let xx = body_1[0] + body_2[0] * c * c + body_2[1] * s * s;
    let yy = body_1[1] + body_2[0] * s * s + body_2[1] * c * c;
    let xy = (body_2[0] - body_2[1]) * s * c;
    let (mean, half) = (0.5 * (xx + yy), 0.5 * (xx - yy));
    let radius = half.hypot(xy);
    // The direction of the larger curvature, then the one of both that lies nearer to x.
    let largest = 0.5 * xy.atan2(half);
    let quarter = std::f64::consts::FRAC_PI_4;
    if largest.abs() <= quarter {
        return ([mean + radius, mean - radius], largest);
    }
    let direction = largest - largest.signum() * 2.0 * quarter;
    ([mean - radius, mean + radius], direction)
}

/// Curvature of a body, 1/m, along a direction at `angle` (rad) to its x axis (Euler).
///
/// κ = κ_x cos² φ + κ_y sin² φ
pub fn curvature_along(body: Curvatures, angle: f64) -> f64 {
    let (s, c) = angle.sin_cos();
    body[0] * c * c + body[1] * s * s
}

/// The same along both of two perpendicular directions, the first at `angle` (rad).
pub fn along(body: Curvatures, angle: f64) -> Curvatures {
    [0.0, std::f64::consts::FRAC_PI_2].map(|quarter| curvature_along(body, angle + quarter))
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use std::f64::consts::{FRAC_PI_2, FRAC_PI_3};

    /// Crossed cylinders of one radius are a ball on a plane; parallel ones a cylinder of half the radius.
    #[test]
    fn cylinders() {
        let cylinder = [50.0, 0.0];
        let (crossed, _) = gap_between(cylinder, cylinder, FRAC_PI_2);
        assert_relative_eq!(crossed[0], 50.0, max_relative = 1e-12);
        assert_relative_eq!(crossed[1], 50.0, max_relative = 1e-12);
        let (parallel, angle) = gap_between(cylinder, cylinder, 0.0);
        assert_eq!((parallel, angle), ([100.0, 0.0], 0.0));
    }

    /// Cylinders crossed at 60 degrees, by Johnson's invariants: A + B = ½(1/R₁ + 1/R₂), B − A = ½√(1/R₁² + 1/R₂² + 2 cos 2α/(R₁R₂)); with
    /// equal radii the principal directions halve the angle between the axes.
    #[test]
    fn skewed_cylinders() {
        let ([a, b], direction) = gap_between([50.0, 0.0], [50.0, 0.0], FRAC_PI_3);
        assert_relative_eq!(a + b, 100.0, max_relative = 1e-12);
        let difference = (2.0 * 50.0_f64.powi(2) * (1.0 - 0.5)).sqrt();
        assert_relative_eq!(a - b, difference, max_relative = 1e-12);
        assert_relative_eq!(direction, 0.5 * FRAC_PI_3, max_relative = 1e-12);
    }

    /// Exchanged axes of both bodies exchange the curvatures.
    #[test]
    fn the_nearer_direction_comes_first() {
        let (along, angle) = gap_between([20.0, 80.0], [0.0, 0.0], 0.3);
        assert_eq!((along, angle), ([20.0, 80.0], 0.0));
        let (curvatures, angle) = gap_between([0.0, 0.0], [20.0, 80.0], 0.3);
        assert_relative_eq!(curvatures[0], 20.0, max_relative = 1e-12);
        assert_relative_eq!(curvatures[1], 80.0, max_relative = 1e-12);
        assert_relative_eq!(angle, 0.3, max_relative = 1e-12);
    }
}
