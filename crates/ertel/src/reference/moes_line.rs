//! Moes' film formula for line contacts over all lubrication regimes.

use super::{Asymptotes, ElasticExponents, Fraction};

pub(super) const SOURCE: &str = "Moes; Venner & Lubrecht 2000, Multilevel Methods in Lubrication; central film of an incompressible fluid, here divided by the relative density at p_h";

/// Dimensionless central film H = h/(R √(2U)) of a line contact for M = W (2U)^(−1/2) > 0 and
/// L = G (2U)^(1/4) ≥ 0.
///
/// H = {(H_RI^(7/3) + H_EI^(7/3))^(3s/7) + (H_RP^(−7/2) + H_EP^(−7/2))^(−2s/7)}^(1/s)
///
/// s = (7 + 8 exp(−2 H_EI/H_RI))/5, the others as in [`moes_line_asymptotes`].
pub fn moes_line_film(load: f64, material: f64) -> f64 {
    let Asymptotes {
        isoviscous_rigid,
        isoviscous_elastic,
        piezoviscous_rigid,
        piezoviscous_elastic,
    } = moes_line_asymptotes(load, material);
    let s = (7.0 + 8.0 * (-2.0 * isoviscous_elastic / isoviscous_rigid).exp()) / 5.0;
    let isoviscous = isoviscous_rigid.powf(7.0 / 3.0) + isoviscous_elastic.powf(7.0 / 3.0);
    // L = 0 makes the second term ∞^(−2s/7) = 0, as it should
    let piezoviscous =
        (piezoviscous_rigid.powf(-3.5) + piezoviscous_elastic.powf(-3.5)).powf(-2.0 * s / 7.0);
    (isoviscous.powf(3.0 * s / 7.0) + piezoviscous).powf(1.0 / s)
}

/// Exponents of H_EI and H_EP.
pub(super) const EXPONENTS: ElasticExponents = ElasticExponents {
    isoviscous_load: Fraction::new(-1, 5),
    piezoviscous_load: Fraction::new(-1, 8),
    piezoviscous_material: Fraction::new(3, 4),
};

/// The four asymptotes of [`moes_line_film`].
///
/// H_RI = 3 M^(−1), H_EI = 2.621 M^(−1/5), H_RP = 1.287 L^(2/3), H_EP = 1.311 M^(−1/8) L^(3/4)
pub fn moes_line_asymptotes(load: f64, material: f64) -> Asymptotes {
    let (m, l) = (load, material);
    Asymptotes {
        isoviscous_rigid: 3.0 / m,
        isoviscous_elastic: 2.621 * m.powf(EXPONENTS.isoviscous_load.value()),
        piezoviscous_rigid: 1.287 * l.powf(2.0 / 3.0),
        piezoviscous_elastic: 1.311
            * m.powf(EXPONENTS.piezoviscous_load.value())
            * l.powf(EXPONENTS.piezoviscous_material.value()),
    }
}
