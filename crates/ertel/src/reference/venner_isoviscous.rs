//! Isoviscous-elastic limit of the circular contact.

pub(super) const SOURCE: &str = "Habchi 2008, eq. 6.2 (exponent read as -1/9); central film of an incompressible fluid for L = 0 and large M, here divided by the relative density at p_h";

/// Dimensionless central film H = h/(R √(2U)) for Moes' load group M, L = 0 and large M.
///
/// H = 1.96 M^(−1/9)
pub fn venner_isoviscous_film(load: f64) -> f64 {
    1.96 * load.powf(-1.0 / 9.0)
}
