//! Mean coefficients of friction of gear meshes.

/// Mean coefficient of friction of a mesh after Schlenk, of the load per face width w = F_bt/b (N/m), the sum of the surface speeds at the pitch
/// point v_ΣC (m/s), the reduced radius there in the transverse section ρ_C (m), the viscosity η at the oil temperature (Pa·s), the mean
/// roughness Ra = (Ra_1 + Ra_2)/2 (m) and the oil factor X_L.
///
/// μ_mz = 0.048 [w/(v_ΣC ρ_C)]^0.2 η^−0.05 Ra^0.25 X_L,  w = F_bt/b
///
/// with N/mm, m/s, mm, mPa·s and µm. Source: Schlenk 1994, in Niemann and Winter, Maschinenelemente II, and ISO/TR 14179-2.
pub fn schlenk(
    load_per_length: f64,
    sum_speed: f64,
    reduced_radius: f64,
    viscosity: f64,
    roughness: f64,
    oil_factor: f64,
) -> f64 {
    let load = 1e-3 * load_per_length / (sum_speed * 1e3 * reduced_radius);
    0.048
        * load.powf(0.2)
        * (1e3 * viscosity).powf(-0.05)
        * (1e6 * roughness).powf(0.25)
        * oil_factor
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Report of GEARpie for type C40 (C14 of the width 40 mm): 6370.7 N, 1800 1/min, 49.85 mPa·s, 20.36 1/GPa, Ra = 0.4 and 0.31 µm, X_L = 0.65: 0.0256.
    /// v_ΣC = 2·188.496·0.0366 sin 22.4388° = 5.2670 m/s; R_C = 8.38205 mm.
    #[test]
    fn published_report() {
        let [force, width, speed, radius] = [6370.7, 40e-3, 5.2670, 8.38205e-3];
        let found = schlenk(force / width, speed, radius, 49.85e-3, 0.355e-6, 0.65);
        assert!((found - 0.0256).abs() < 6e-5, "{found}");
    }
}
