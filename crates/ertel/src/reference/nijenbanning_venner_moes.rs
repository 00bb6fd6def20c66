//! Central film of circular and elliptical contacts over all lubrication regimes.

use super::{Asymptotes, ElasticExponents, Fraction};

pub(super) const SOURCE: &str = "Nijenbanning, Venner & Moes 1994, Wear 176, 217-229; incompressible fluid, here divided by the relative density at p_h";

/// Dimensionless central film H = h/(R √(2U)) for D = R_x/R_y, x along the motion, Moes'
/// load group M > 0 and material group L ≥ 0.
///
/// H = {[H_RI^(3/2) + (H_EI^(−4) + H_00^(−4))^(−3/8)]^(2s/3) + (H_RP^(−8) + H_EP^(−8))^(−s/8)}^(1/s)
///
/// H_00 = 1.8 D^(−1), s = 1.5 (1 + exp(−1.2 H_EI/H_RI)), the others as in
/// [`nijenbanning_venner_moes_asymptotes`].
pub fn nijenbanning_venner_moes_film(load: f64, material: f64, ratio: f64) -> f64 {
    let Asymptotes {
        isoviscous_rigid,
        isoviscous_elastic,
        piezoviscous_rigid,
        piezoviscous_elastic,
    } = nijenbanning_venner_moes_asymptotes(load, material, ratio);
    let light_load = 1.8 / ratio;
    let s = 1.5 * (1.0 + (-1.2 * isoviscous_elastic / isoviscous_rigid).exp());
    let isoviscous = isoviscous_rigid.powf(1.5)
        + (isoviscous_elastic.powi(-4) + light_load.powi(-4)).powf(-0.375);
    // L = 0 makes the second term ∞^(−s/8) = 0, as it should
    let piezoviscous = (piezoviscous_rigid.powi(-8) + piezoviscous_elastic.powi(-8)).powf(-s / 8.0);
    (isoviscous.powf(2.0 * s / 3.0) + piezoviscous).powf(1.0 / s)
}

/// Exponents of H_EI and H_EP.
pub(super) const EXPONENTS: ElasticExponents = ElasticExponents {
    isoviscous_load: Fraction::new(-2, 15),
    piezoviscous_load: Fraction::new(-1, 12),
    piezoviscous_material: Fraction::new(3, 4),
};

/// The four asymptotes of [`nijenbanning_venner_moes_film`].
///
/// H_RI = 145 (1 + 0.796 D^(14/15))^(−15/7) D^(−1) M^(−2)
/// H_EI = 3.18 (1 + 0.006 ln D + 0.63 D^(4/7))^(−14/25) D^(−1/15) M^(−2/15)
/// H_RP = 1.29 (1 + 0.691 D)^(−2/3) L^(2/3)
/// H_EP = 1.48 (1 + 0.006 ln D + 0.63 D^(4/7))^(−7/20) D^(−1/24) M^(−1/12) L^(3/4)
pub fn nijenbanning_venner_moes_asymptotes(load: f64, material: f64, ratio: f64) -> Asymptotes {
    let (m, l, d) = (load, material, ratio);
    let elastic = 1.0 + 0.006 * d.ln() + 0.63 * d.powf(4.0 / 7.0);
    Asymptotes {
        isoviscous_rigid: 145.0 * (1.0 + 0.796 * d.powf(14.0 / 15.0)).powf(-15.0 / 7.0) / d
            * m.powi(-2),
        isoviscous_elastic: 3.18
            * elastic.powf(-14.0 / 25.0)
            * d.powf(-1.0 / 15.0)
            * m.powf(EXPONENTS.isoviscous_load.value()),
        piezoviscous_rigid: 1.29 * (1.0 + 0.691 * d).powf(-2.0 / 3.0) * l.powf(2.0 / 3.0),
        piezoviscous_elastic: 1.48
            * elastic.powf(-7.0 / 20.0)
            * d.powf(-1.0 / 24.0)
            * m.powf(EXPONENTS.piezoviscous_load.value())
            * l.powf(EXPONENTS.piezoviscous_material.value()),
    }
}
