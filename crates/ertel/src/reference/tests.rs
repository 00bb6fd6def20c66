use crate::near::near;
use approx::assert_relative_eq;

use super::*;

/// One case of the table: groups, R in m, and films in nm.
struct Case {
    speed: f64,
    material: f64,
    load: f64,
    moes_load: f64,
    moes_material: f64,
    radius: f64,
    hamrock_dowson: (f64, f64),
    nijenbanning_venner_moes: f64,
}

impl Case {
    fn groups(&self) -> Groups {
        Groups {
            load: self.load,
            speed: self.speed,
            material: self.material,
            moes_load: self.moes_load,
            moes_material: self.moes_material,
        }
    }
}

/// Films computed by an independent script from the published formulas, six digits, for cases of
/// Habchi 2008: Table 3.3 (M 200, L 10), Table 3.1, Fig. 3.4, chapter 4, Table 5.1.
const CASES: [Case; 5] = [
    Case {
        speed: 8.66667e-12,
        material: 5076.92,
        load: 1.69271e-06,
        moes_load: 199.26,
        moes_material: 10.3591,
        radius: 0.016,
        hamrock_dowson: (264.066, 148.596),
        nijenbanning_venner_moes: 298.135,
    },
    Case {
        speed: 4.09449e-12,
        material: 5307.69,
        load: 5.28873e-07,
        moes_load: 109.252,
        moes_material: 8.97869,
        radius: 0.0127,
        hamrock_dowson: (140.376, 78.8115),
        nijenbanning_venner_moes: 152.918,
    },
    Case {
        speed: 4.09449e-12,
        material: 5307.69,
        load: 4.54139e-05,
        moes_load: 9381.37,
        moes_material: 8.97869,
        radius: 0.0127,
        hamrock_dowson: (104.166, 56.9402),
        nijenbanning_venner_moes: 116.402,
    },
    Case {
        speed: 6.58731e-11,
        material: 2343.78,
        load: 1.15113e-06,
        moes_load: 29.6021,
        moes_material: 7.94055,
        radius: 0.0127,
        hamrock_dowson: (555.747, 329.923),
        nijenbanning_venner_moes: 597.344,
    },
    Case {
        speed: 6.7703e-11,
        material: 668.942,
        load: 1.50148e-06,
        moes_load: 37.826,
        moes_material: 2.28191,
        radius: 0.0127,
        hamrock_dowson: (286.101, 178.346),
        nijenbanning_venner_moes: 334.678,
    },
];

/// Six-digit groups raised to powers below 1 give films to about five digits.
const TABLE_TOLERANCE: f64 = 1e-5;

#[test]
fn hamrock_dowson_films_match_independent_values() {
    for case in &CASES {
        let (central, minimum) =
            FilmFormula::HamrockDowson.film(&Contact::circular(case.radius, 1.0), &case.groups());
        let (expected_central, expected_minimum) = case.hamrock_dowson;
        near(central.unwrap() * 1e9, expected_central, TABLE_TOLERANCE);
        near(minimum.unwrap() * 1e9, expected_minimum, TABLE_TOLERANCE);
    }
}

#[test]
fn nijenbanning_venner_moes_films_match_independent_values() {
    for case in &CASES {
        let (central, _) = FilmFormula::NijenbanningVennerMoes
            .film(&Contact::circular(case.radius, 1.0), &case.groups());
        assert_relative_eq!(
            central.unwrap() * 1e9,
            case.nijenbanning_venner_moes,
            max_relative = TABLE_TOLERANCE
        );
    }
}

/// Values of a second implementation (Python, double precision) of the printed formula.
#[test]
fn moes_line_film_matches_independent_values() {
    for (m, l, h) in [
        (0.5, 0.0, 6.487830021651974),
        (0.5, 5.0, 7.33573545566088),
        (10.0, 10.0, 5.464316870977172),
        (20.0, 5.0, 3.466292313296523),
        (200.0, 14.0, 4.949253216906674),
        (1000.0, 0.0, 0.6583664049903828),
    ] {
        assert_relative_eq!(moes_line_film(m, l), h, max_relative = 1e-12);
    }
}

/// W = 5e-5, U = 1e-11, G = 4000, R = 10 mm evaluated independently (Python): Dowson-Higginson
/// 168.8465 nm, Dowson-Toyoda 220.2815 nm.
#[test]
fn line_power_laws_match_independent_values() {
    let groups = Groups {
        load: 5e-5,
        speed: 1e-11,
        material: 4000.0,
        moes_load: 11.18034,
        moes_material: 8.45897,
    };
    let (_, minimum) = FilmFormula::DowsonHigginson.film(&Contact::line(0.01, 1.0), &groups);
    assert_relative_eq!(minimum.unwrap(), 168.84654e-9, max_relative = 1e-6);
    let (central, _) = FilmFormula::DowsonToyoda.film(&Contact::line(0.01, 1.0), &groups);
    assert_relative_eq!(central.unwrap(), 220.28150e-9, max_relative = 1e-6);
    let names: Vec<_> = film_formulas(&Contact::line(0.01, 1.0), &groups, 1.0)
        .into_iter()
        .map(|f| f.name)
        .collect();
    assert_eq!(
        names,
        [
            "Dowson-Toyoda 1978",
            "Dowson-Higginson 1977",
            "Dowson-Higginson 1966",
            "Moes (line)"
        ]
    );
    // 1.6 U^0.7 G^0.6 W^(-0.13), Python
    let (_, minimum) = FilmFormula::DowsonHigginson1966.film(&Contact::line(0.01, 1.0), &groups);
    assert_relative_eq!(minimum.unwrap(), 167.68332e-9, max_relative = 1e-6);
}

/// Values of the printed formulas by Python; slide-to-roll ratios by their size.
#[test]
fn thermal_reductions_match_independent_values() {
    use super::thermal::{ThermalReduction, thermal_loading};
    for (loading, ratio, slide_to_roll, expected) in [
        (
            0.5,
            0.004,
            0.0,
            [0.845_032_792_510, 0.866_061_193_556, 0.858_169_903_378],
        ),
        (
            0.5,
            0.004,
            -0.3,
            [0.769_108_071_450, 0.500_683_485_000, f64::NAN],
        ),
        (
            3.0,
            0.005,
            1.0,
            [0.374_641_363_112, 0.115_050_088_625, f64::NAN],
        ),
    ] {
        for (formula, value) in ThermalReduction::ALL.into_iter().zip(expected) {
            match formula.factor(loading, ratio, slide_to_roll) {
                Some(factor) => assert_relative_eq!(factor, value, max_relative = 1e-10),
                None => assert!(value.is_nan(), "{formula:?}"),
            }
        }
    }
    // Beyond its range the first factor turns negative
    assert_eq!(ThermalReduction::GuptaCheng.factor(300.0, 0.01, 0.0), None);
    // 0.1 Pa.s 0.04 1/K (5 m/s)² / 0.125 W/(m.K) = 0.8
    assert_relative_eq!(thermal_loading(0.1, 0.04, 5.0, 0.125), 0.8);
}

/// An isoviscous fluid (G = 0) has no power law in G, and gains the isoviscous limit:
/// 1.96 · 1000^(−1/9) = 0.909751.
#[test]
fn isoviscous_contact_lists_only_applicable_formulas() {
    let groups = Groups {
        load: 1e-6,
        speed: 5e-13,
        material: 0.0,
        moes_load: 1000.0,
        moes_material: 0.0,
    };
    let films = film_formulas(&Contact::circular(0.01, 1.0), &groups, 1.0);
    let names: Vec<_> = films.iter().map(|f| f.name).collect();
    assert_eq!(
        names,
        ["Nijenbanning-Venner-Moes 1994", "Venner isoviscous-elastic"]
    );
    // h = H R √(2U), √(2U) = 1e-6
    assert_relative_eq!(films[1].central.unwrap(), 0.909_751e-8, max_relative = 1e-5);
}
