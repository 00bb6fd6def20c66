//! Moes' film formula for line contacts over all lubrication regimes.

pub(super) const SOURCE: &str = "Moes; Venner & Lubrecht 2000, Multilevel Methods in Lubrication; central film (constants \
     recalled, not verified against the publication)";

/// Dimensionless central film H = h/(R √(2U)) of a line contact for M = W (2U)^(−1/2) > 0 and
/// L = G (2U)^(1/4) ≥ 0.
///
/// H = {(H_RI^(7/3) + H_EI^(7/3))^(3s/7) + (H_RP^(−7/2) + H_EP^(−7/2))^(−2s/7)}^(1/s)
///
/// H_RI = 3 M^(−1), H_EI = 2.621 M^(−1/5), H_RP = 1.287 L^(2/3), H_EP = 1.311 M^(−1/8) L^(3/4),
/// s = (7 + 8 exp(−2 H_EI/H_RI))/5
pub fn moes_line_film(load: f64, material: f64) -> f64 {
    let (m, l) = (load, material);
    let rigid_isoviscous = 3.0 / m;
    let elastic_isoviscous = 2.621 * m.powf(-0.2);
    let rigid_piezoviscous = 1.287 * l.powf(2.0 / 3.0);
    let elastic_piezoviscous = 1.311 * m.powf(-0.125) * l.powf(0.75);
    let s = (7.0 + 8.0 * (-2.0 * elastic_isoviscous / rigid_isoviscous).exp()) / 5.0;
    let isoviscous = rigid_isoviscous.powf(7.0 / 3.0) + elastic_isoviscous.powf(7.0 / 3.0);
    // L = 0 makes the second term ∞^(−2s/7) = 0, as it should
    let piezoviscous =
        (rigid_piezoviscous.powf(-3.5) + elastic_piezoviscous.powf(-3.5)).powf(-2.0 * s / 7.0);
    (isoviscous.powf(3.0 * s / 7.0) + piezoviscous).powf(1.0 / s)
}
