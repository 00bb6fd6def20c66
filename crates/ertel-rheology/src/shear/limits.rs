//! Where the Newtonian plateaus end and begin, and the stress at a shear rate.
//!
//! Theory: Newtonian limits.

use num_dual::{Dual64, DualNum as _};

use super::numbers::increasing_root;
use super::{ShearLaw, ShearThinning};

/// Deviation of the viscosity from a plateau that counts as leaving it.
const DEVIATION: f64 = 0.05;
/// Logarithm of the largest stress (Pa) looked at; its square is still far from overflow.
const LN_LARGEST_STRESS: f64 = 250.0;
/// How far below the smallest stress of the law (natural logarithm) the search begins.
const LN_BELOW: f64 = 60.0;

impl ShearThinning {
    /// Newtonian limits: the equivalent stresses (Pa) at which the viscosity η has fallen to `0.95 μ₁`, and at which it
    /// has come down to `1.05 μ₂`, at `pressure` (Pa above ambient).
    ///
    /// The second is `None` without a second plateau, or where a limiting stress is reached before it. Both are `None`
    /// where the law does not thin by as much.
    pub fn newtonian_limits(&self, pressure: f64) -> [Option<f64>; 2] {
        let scales = self.scales(pressure);
        let stresses = [scales.knee, scales.growth, scales.limit];
        let smallest = stresses.into_iter().flatten().fold(f64::INFINITY, f64::min);
        if !smallest.is_finite() {
            return [None, None];
        }
        let from = smallest.ln() - LN_BELOW;
        let first = stress_at(from, 1.0 - DEVIATION, |stress_squared: Dual64| {
            self.relative_fluidity(stress_squared, pressure.into())
        });
        let second = self.law.as_ref().and_then(|law| {
            let share = law.plateau_ratio().filter(|ratio| *ratio > 0.0)? * (1.0 + DEVIATION);
            let stress = stress_at(from, share, |s: Dual64| law.relative_fluidity(s))?;
            scales
                .limit
                .is_none_or(|limit| stress < limit)
                .then_some(stress)
        });
        [first, second]
    }

    /// Shear stress τ (Pa) of simple shear at a rate γ̇ (1/s), for a viscosity μ₁ (Pa·s) at `pressure` (Pa above ambient): τ φ(τ², p) = μ₁ γ̇.
    pub fn stress(&self, viscosity: f64, pressure: f64, rate: f64) -> f64 {
        let newtonian = (viscosity * rate).abs();
        let scales = self.scales(pressure);
        let stresses = [scales.knee, scales.growth, scales.limit];
        let smallest = stresses.into_iter().flatten().fold(newtonian, f64::min);
        if smallest <= 0.0 {
            return 0.0;
        }
        let residual = |ln_stress: f64| {
            let square = (Dual64::new(ln_stress, 1.0) * 2.0).exp();
            let ln = self.relative_fluidity(square, pressure.into()).ln();
            (ln_stress + ln.re - newtonian.ln(), 1.0 + ln.eps)
        };
        let from = smallest.ln() - LN_BELOW;
        increasing_root(residual, from, newtonian.ln(), smallest.ln())
            .exp()
            .copysign(rate)
    }
}

impl ShearLaw {
    /// Second plateau over first; `None` for laws without.
    pub fn plateau_ratio(&self) -> Option<f64> {
        match self {
            Self::Carreau(law) => Some(law.plateau_ratio),
            Self::CarreauYasuda(law) => Some(law.plateau_ratio),
            Self::ReeEyring(_) | Self::Rabinowitsch(_) => None,
        }
    }
}

/// The stress (Pa) at which the viscosity is `share` of μ₁; `from` is the logarithm of a stress below.
fn stress_at(from: f64, share: f64, fluidity: impl Fn(Dual64) -> Dual64) -> Option<f64> {
    let residual = |ln_stress: f64| {
        let ln = fluidity((Dual64::new(ln_stress, 1.0) * 2.0).exp()).ln();
        (ln.re + share.ln(), ln.eps)
    };
    let straddled = residual(from).0 < 0.0 && residual(LN_LARGEST_STRESS).0 > 0.0;
    straddled.then(|| increasing_root(residual, from, LN_LARGEST_STRESS, from + LN_BELOW).exp())
}
