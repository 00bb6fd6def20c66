//! The pressure far from a contact, where the surfaces are parabolas and rigid (Kapitza 1955).

use crate::contact::Gap;

/// c of the pressure −λ c·X/H² far from a contact, along and across the motion.
pub fn far_field(gap: &Gap) -> [f64; 2] {
    let kappa = gap.curvature_ratio;
    let [along, across] = gap.turn.to_axes([1.0, 0.0]);
    let first = 1.0 / (3.0 + 2.0 * kappa);
    let second = kappa / (3.0 * kappa + 2.0);
    gap.turn.to_motion([first * along, second * across])
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;
    use crate::contact::Turn;

    /// −λ c·X/H² solves ∇·(H³∇P) = λ ∂H/∂X of rigid parabolas: by differences at a point, along the first principal direction and at an angle to it.
    #[test]
    fn far_pressures_solve_reynolds_equation() {
        for (ratio, turn) in [(1.0, Turn::NONE), (0.3, Turn::NONE), (0.3, Turn::by(0.6))] {
            let gap = Gap {
                curvature_ratio: ratio,
                turn,
                terms: Vec::new(),
            };
            let [a, b] = far_field(&gap);
            let film = |x: [f64; 2]| gap.value(x);
            let pressure = |x: [f64; 2]| -(a * x[0] + b * x[1]) / film(x).powi(2);
            let (x, y, h) = (-3.0, 1.3, 1e-3);
            let along = |f: &dyn Fn([f64; 2]) -> f64, at: [f64; 2], axis: usize| {
                let mut ends = [at, at];
                ends[0][axis] -= h;
                ends[1][axis] += h;
                (f(ends[1]) - f(ends[0])) / (2.0 * h)
            };
            let divergence: f64 = (0..2)
                .map(|axis| {
                    let flow = |at: [f64; 2]| film(at).powi(3) * along(&pressure, at, axis);
                    along(&flow, [x, y], axis)
                })
                .sum();
            let wedge = along(&film, [x, y], 0);
            assert_relative_eq!(divergence, wedge, max_relative = 1e-5);
        }
    }
}
