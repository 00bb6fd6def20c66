//! Differential slip across a groove (Heathcote).

/// Radius of the surface on which ball and groove touch, across rolling, m.
///
/// R_d = 2 f D/(2 f + 1),  f the groove's radius over the diameter D (m)
///
/// Source: Harris and Kotzalas 2007, chapter 2 (deformed surface).
pub fn deformed_radius(groove: f64, diameter: f64) -> f64 {
    2.0 * groove * diameter / (2.0 * groove + 1.0)
}

/// Slide-to-roll ratio (u_2 − u_1)/u at y across rolling (m), body 1 the ring, body 2 the ball, where both roll on the lines y = ±c (m).
///
/// ```text
///   Σ(y) = (c² − y²)/(2 R_d R_x)
/// ```
/// The touching surface lies y²/(2R_d) further from the inner ring's axis at y than in the middle, or nearer to the outer ring's, and nearer
/// to that of the ball: curvatures of both add up to 1/R_x, R_x (m) being the reduced radius along rolling.
/// Source: Harris and Kotzalas 2007, chapter 9; the expression follows from the sentence above.
pub fn heathcote_slip(y: f64, c: f64, deformed_radius: f64, radius_along: f64) -> f64 {
    (c * c - y * y) / (2.0 * deformed_radius * radius_along)
}

/// Slip at the ends of an ellipse of the semi-axis b across rolling (m) against that in the middle, a positive number.
///
/// b²/(2 R_d R_x)
pub fn heathcote_number(b: f64, deformed_radius: f64, radius_along: f64) -> f64 {
    -heathcote_slip(b, 0.0, deformed_radius, radius_along)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::near::near;
    use approx::assert_relative_eq;

    /// By hand for the inner ring of a 6206: R_d = 1.04 · 9.525/2.04 = 4.855882 mm, R_x = 3.776352 mm, b = 1.2 mm: 1.44/(2 · 18.33752) =
    /// 0.0392637; zero on the lines of rolling.
    #[test]
    fn by_hand() {
        let deformed = deformed_radius(0.52, 9.525e-3);
        assert_relative_eq!(deformed, 4.855_882e-3, max_relative = 1e-6);
        let number = heathcote_number(1.2e-3, deformed, 3.776_352e-3);
        assert_relative_eq!(number, 0.039_263_7, max_relative = 1e-5);
        assert_eq!(heathcote_slip(4e-4, 4e-4, deformed, 3.8e-3), 0.0);
        assert!(heathcote_slip(0.0, 4e-4, deformed, 3.8e-3) > 0.0);
    }

    /// Speeds of both surfaces at y from their distances to the axes: ball of 5 mm in a groove of 5.2 mm on a raceway of 20 mm.
    /// At y both touch at √(R_d² − y²) from the centre of the touching arc, which lies R_d above its lowest point.
    #[test]
    fn distances_from_the_axes() {
        let (ball, raceway, deformed, y) = (5e-3, 20e-3, 5.1e-3_f64, 3e-4_f64);
        let rise = deformed - (deformed * deformed - y * y).sqrt();
        let ring_speed = (raceway + rise) / raceway;
        let ball_speed = (ball - rise) / ball;
        let slip = ball_speed - ring_speed;
        let along = 1.0 / (1.0 / ball + 1.0 / raceway);
        near(heathcote_slip(y, 0.0, deformed, along), slip, 1e-3);
    }
}
