//! The correlations against measured oils.

use approx::assert_relative_eq;

use super::BaseOil;

/// Evaluated by hand: 0.9904 · 100^0.139 = 1.8785, 0.7382 · 46^0.1335 = 1.2307.
#[test]
fn coefficients_by_hand() {
    let at = |oil: BaseOil, nu: f64| oil.pressure_viscosity(nu * 1e-6).value * 1e9;
    assert_relative_eq!(at(BaseOil::Mineral, 100.0), 18.785, max_relative = 1e-4);
    assert_relative_eq!(at(BaseOil::Pao, 46.0), 12.307, max_relative = 1e-4);
    assert_relative_eq!(at(BaseOil::Ester, 100.0), 12.355, max_relative = 1e-4);
    assert_relative_eq!(at(BaseOil::Pag, 220.0), 12.227, max_relative = 1e-4);
}

/// Viscosity (mPa·s) and coefficient (1/GPa) of mineral oils at 30, 60 and 100 degC, from Stachowiak and Batchelor,
/// Engineering Tribology, table 2.3. Their densities are not printed; 890 kg/m³ at 15 degC moves ν^t by less than 1 %.
const MINERAL: [[(f64, f64); 3]; 13] = [
    [(38.0, f64::NAN), (12.1, 18.4), (5.3, 13.4)],
    [(153.0, 23.7), (34.0, 20.5), (9.1, 15.8)],
    [(250.0, 25.0), (50.5, 21.3), (12.6, 17.6)],
    [(810.0, 34.0), (135.0, 28.0), (26.8, 22.0)],
    [(18.6, 20.0), (6.3, 16.0), (2.4, 13.0)],
    [(45.0, 28.0), (12.0, 20.0), (3.9, 16.0)],
    [(107.0, 29.6), (23.3, 22.8), (6.4, 17.8)],
    [(122.0, 27.0), (26.3, 21.6), (7.3, 17.5)],
    [(171.0, 28.0), (31.0, 23.0), (7.5, 18.0)],
    [(30.7, 25.7), (8.6, 20.3), (3.1, 15.4)],
    [(165.0, 33.0), (30.0, 23.8), (6.8, 16.0)],
    [(310.0, 34.6), (44.2, 26.3), (9.4, 19.5)],
    [(2000.0, 41.5), (180.0, 29.4), (24.0, 25.0)],
];

/// What the range of the estimate says.
#[test]
fn measured_mineral_oils_lie_above_the_correlation() {
    let mut ratios = Vec::new();
    for oil in MINERAL {
        for ((mu, alpha), celsius) in oil.into_iter().zip([30.0, 60.0, 100.0]) {
            let density = 890.0 * (1.0 - 6.5e-4 * (celsius - 15.0));
            let estimate = BaseOil::Mineral.pressure_viscosity(1e-3 * mu / density);
            if alpha.is_finite() {
                ratios.push(1e-9 * alpha / estimate.value);
            }
        }
    }
    ratios.sort_by(f64::total_cmp);
    let estimate = BaseOil::Mineral.pressure_viscosity(1e-4);
    let outside = (ratios.iter())
        .filter(|ratio| !(1.0 - estimate.below..1.0 + estimate.above).contains(*ratio))
        .count();
    assert_eq!(ratios.len(), 38);
    assert_relative_eq!(ratios[0], 1.05, epsilon = 0.005);
    assert_relative_eq!(ratios[37], 1.64, epsilon = 0.01);
    assert!(outside <= 2, "{outside} of 38 outside the range");
}

/// Polyalphaolefins (mm²/s, 1/GPa) of a public program (kreuz_pao), temperature not stated but 40 degC by viscosity.
#[test]
fn polyalphaolefins_lie_above_the_correlation() {
    for (nu, alpha) in [
        (16.70, 14.8),
        (62.90, 17.1),
        (410.0, 23.89),
        (1250.3, 23.06),
    ] {
        let ratio = 1e-9 * alpha / BaseOil::Pao.pressure_viscosity(1e-6 * nu).value;
        assert!((1.19..1.46).contains(&ratio), "{nu}: {ratio}");
    }
}
