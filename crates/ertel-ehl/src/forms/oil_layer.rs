//! A gap that is filled by a layer of oil thinner than itself: the inlet of a starved contact, dimensionless.
//!
//! ```text
//!   θH = H − F,   F = D g(κP/D),   D = max(H − H_oil, 0),   κ = H³/(λl)
//!   g(t) = 1 − t/(1 − t) for t < 0,   (1 − t)²(1 + t) up to 1,   0 beyond: g(0) = 1, g'(0) = −1, smooth
//!   ∇·(ρ̄ θH ū) = ∇·(ε∇P)
//! ```
//! Where there is no pressure, the gap carries the layer that arrives, H_oil; where there is, it is full. Between them is the
//! meniscus: arriving oil flows on or is held back by pressure, (H − H_oil) u = ε ∂P/∂X there, as mass conservation
//! requires (Jakobsson and Floberg 1957; Elrod, J. Lubr. Technol. 103 (1981) 350-354). Here the gap fills up over a length l: P grows
//! e-fold over l, at first, until θ = 1. Pressures just below zero, where the film has cavitated, represent less oil than the layer. The inflow is ρ̄H_oil for any l, so a line contact does not depend on l downstream.
//!
//! Theory: Starved inlet.

use super::dual::Number;
use crate::contact::OilLayer;

/// Missing oil of a gap, and its derivatives.
#[derive(Clone, Copy, Debug)]
pub struct Missing<D> {
    /// F.
    pub film: D,
    /// ∂F/∂P.
    pub by_pressure: D,
    /// ∂F/∂H.
    pub by_film: D,
}

/// Missing oil of a gap H at the pressure P where it fills up over the length l; `None` where it is filled.
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
        let empty = -t + 1.0;
        Some([empty * empty * (t + 1.0), -empty * (t * 3.0 + 1.0)])
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

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;
    use crate::forms::dual::Dual;

    const LAYER: OilLayer = OilLayer {
        thickness: 0.05,
        lambda: 0.02,
    };

    fn film(pressure: f64, film: f64) -> f64 {
        missing(&LAYER, pressure, film, 0.1).map_or(0.0, |m| m.film)
    }

    /// Slopes as printed and as the dual numbers carry them, against differences.
    #[test]
    fn slopes_against_differences() {
        // κ = 500 H³: full from P = 0.29 at H = 0.08, 0.3 at 0.1
        for (p, h) in [
            (-2e-3, 0.1),
            (0.0, 0.1),
            (0.02, 0.1),
            (0.08, 0.1),
            (0.01, 0.3),
            (0.05, 0.06),
        ] {
            let variables = [Dual::<2>::variable(p, 0), Dual::<2>::variable(h, 1)];
            let found = missing(&LAYER, variables[0], variables[1], 0.1).unwrap();
            let e = 1e-7;
            let by_pressure = (film(p + e, h) - film(p - e, h)) / (2.0 * e);
            let by_film = (film(p, h + e) - film(p, h - e)) / (2.0 * e);
            assert_relative_eq!(
                found.by_pressure.re,
                by_pressure,
                max_relative = 1e-5,
                epsilon = 1e-7
            );
            assert_relative_eq!(
                found.by_film.re,
                by_film,
                max_relative = 1e-5,
                epsilon = 1e-7
            );
            assert_relative_eq!(
                found.film.slopes[0],
                by_pressure,
                max_relative = 1e-5,
                epsilon = 1e-7
            );
            assert_relative_eq!(
                found.film.slopes[1],
                by_film,
                max_relative = 1e-5,
                epsilon = 1e-7
            );
        }
    }

    /// Without pressure the gap carries the layer, under pressure it is full; a gap thinner than the layer is always full.
    #[test]
    fn limits() {
        assert_relative_eq!(film(0.0, 0.2), 0.15, max_relative = 1e-14);
        // κ = 4: D/κ = 0.0375
        assert_eq!(film(0.0376, 0.2), 0.0);
        assert!(film(0.0374, 0.2) > 0.0);
        assert_eq!(film(-1.0, 0.049), 0.0);
        assert!(film(-1.0, 0.2) < 0.3);
    }
}
