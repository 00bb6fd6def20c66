//! Film-thickness formulas from made films.

use ertel::contact::ContactKind;
use ertel::fit::{
    FilmFit, FilmFitError, FilmKind, FilmState, contact_of_films, fit_film, read_films,
};

/// Habchi 2008, eq. 6.4: fluid C, central film.
const FACTOR: f64 = 2.2318;
const EXPONENT_M: f64 = -0.1362;
const EXPONENT_L: f64 = 0.0198;

fn film(load: f64, material: f64, noise: f64) -> FilmState {
    let (radius, speed) = (12.7e-3, 1e-12);
    let h = FACTOR * radius * f64::sqrt(2.0 * speed);
    FilmState {
        load,
        material,
        speed,
        radius,
        film: h * load.powf(EXPONENT_M) * material.powf(EXPONENT_L) * noise.exp(),
    }
}

fn grid(mut noise: impl FnMut() -> f64) -> Vec<FilmState> {
    let mut states = Vec::new();
    for load in [20.0, 100.0, 500.0, 2500.0] {
        for material in [0.1, 0.3, 1.0, 3.0] {
            states.push(film(load, material, noise()));
        }
    }
    states
}

fn normal(random: &mut fastrand::Rng) -> f64 {
    let radius = (-2.0 * (1.0 - random.f64()).ln()).sqrt();
    radius * (std::f64::consts::TAU * random.f64()).cos()
}

fn estimates(fit: &FilmFit) -> [ertel::fit::Estimate; 3] {
    [
        fit.factor,
        fit.load_exponent.unwrap(),
        fit.material_exponent.unwrap(),
    ]
}

/// The groups of Hamrock and Dowson give the same films.
#[test]
fn a_formula_is_the_same_in_other_groups() {
    let fit = fit_film(&grid(|| 0.0), FilmKind::Central, 0.95).unwrap();
    for (kind, power) in [(ContactKind::Circular, 0.75), (ContactKind::Line, 0.5)] {
        let [factor, speed, material, load] = fit.hamrock_dowson(kind);
        for state in grid(|| 0.0) {
            // M = W (2U)^-power, L = G (2U)^(1/4).
            let w = state.load * (2.0 * state.speed).powf(power);
            let g = state.material / (2.0 * state.speed).powf(0.25);
            let film =
                factor * state.radius * state.speed.powf(speed) * g.powf(material) * w.powf(load);
            assert!((film / state.film - 1.0).abs() < 1e-6);
        }
    }
    let circular = contact_of_films("load_N,film_central_m\n1,1e-7\n");
    assert_eq!(circular, Some(ContactKind::Circular));
    let line = contact_of_films("load [kN/m]; film_central_m\n1; 1e-7\n");
    assert_eq!(line, Some(ContactKind::Line));
    assert_eq!(contact_of_films("moes_load,film_central_m\n1,1e-7\n"), None);
}

#[test]
fn the_formula_of_exact_films_is_found() {
    let fit = fit_film(&grid(|| 0.0), FilmKind::Central, 0.95).unwrap();
    for (found, expected) in estimates(&fit).iter().zip([FACTOR, EXPONENT_M, EXPONENT_L]) {
        assert!((found.value - expected).abs() < 1e-8, "{found:?}");
    }
    assert!(fit.warnings.is_empty() && fit.rms() < 1e-9);
    assert_eq!(fit.text(), "h_c = 2.2318 R √(2U) M^-0.1362 L^0.0198");
    assert_eq!(
        fit.latex(),
        "h_c = 2.2318\\, R \\sqrt{2U}\\, M^{-0.1362}\\, L^{0.0198}"
    );
    assert_eq!(
        fit.code(),
        "h_c = 2.2318 * R * (2 * U) ** 0.5 * M ** (-0.1362) * L ** (0.0198)"
    );
}

/// 200 sets with 2 % noise; 91 to 99 % is ±2.6 standard deviations about 95 %.
#[test]
fn intervals_cover_at_the_stated_rate() {
    let mut random = fastrand::Rng::with_seed(64);
    let mut n_held = [0; 3];
    for _ in 0..200 {
        let states = grid(|| 0.02 * normal(&mut random));
        let fit = fit_film(&states, FilmKind::Central, 0.95).unwrap();
        for ((n, found), value) in n_held
            .iter_mut()
            .zip(estimates(&fit))
            .zip([FACTOR, EXPONENT_M, EXPONENT_L])
        {
            *n += usize::from(found.interval[0] <= value && value <= found.interval[1]);
        }
    }
    assert!(n_held.iter().all(|n| (182..=198).contains(n)), "{n_held:?}");
}

#[test]
fn exponents_that_films_do_not_tell_are_warned_of() {
    let fit = |states: &[FilmState]| fit_film(states, FilmKind::Minimum, 0.95);
    // L stays
    let one = [20.0, 100.0, 500.0, 2500.0].map(|m| film(m, 0.5, 0.0));
    let fitted = fit(&one).unwrap();
    assert_eq!(fitted.material_exponent, None);
    assert!(
        fitted.warnings[0].contains("L does not vary"),
        "{:?}",
        fitted.warnings
    );
    assert!((fitted.load_exponent.unwrap().value - EXPONENT_M).abs() < 1e-8);
    assert!((fitted.factor.value - FACTOR * 0.5f64.powf(EXPONENT_L)).abs() < 1e-8);
    // Only the speed varies: M falls and L grows as powers of it
    let speeds =
        [1.0f64, 2.0, 4.0, 8.0, 16.0].map(|u| film(1e3 * u.powf(-0.75), u.powf(0.25), 0.0));
    assert_eq!(fit(&speeds).unwrap_err(), FilmFitError::Collinear);
    // Nearly so
    let mut nearly = speeds.to_vec();
    nearly.push(film(400.0, 1.4, 0.0));
    let fitted = fit(&nearly).unwrap();
    assert!(
        fitted.warnings.iter().any(|w| w.contains("vary together")),
        "{:?}",
        fitted.warnings
    );
    // L varies by 1 %, films scatter by 2 %
    let mut random = fastrand::Rng::with_seed(7);
    let narrow: Vec<FilmState> = (0..20)
        .map(|i| {
            let load = 100.0 * f64::from(1 + i % 5);
            film(
                load,
                1.0 + 0.01 * f64::from(i / 5),
                0.02 * normal(&mut random),
            )
        })
        .collect();
    assert!(estimates(&fit(&narrow).unwrap())[2].interval[1] > 0.3);
    // One M, two L: two constants
    assert!(matches!(
        fit(&grid(|| 0.0)[..2]),
        Err(FilmFitError::TooFew { .. })
    ));
}

#[test]
fn results_are_read_by_their_columns() {
    let csv = "point,film_central_m,film_central_error_m,moes_load,moes_material,speed_group\n\
               1,1e-7,1e-10,20,1,1e-12\n2,,,,,\n3,2e-7,1e-10,10,1,2e-12\n";
    let read = |text: &str, kind| read_films("r.csv", text, kind, Some(0.01));
    let states = read(csv, FilmKind::Central).unwrap().unwrap();
    assert_eq!(states.len(), 2);
    assert_eq!((states[1].film, states[1].load), (2e-7, 10.0));
    assert_eq!((states[1].speed, states[1].radius), (2e-12, 0.01));
    assert_eq!(read(csv, FilmKind::Minimum), Ok(None));
    let error = read(&csv.replace("moes_load", "m"), FilmKind::Central).unwrap_err();
    assert!(
        error
            .to_string()
            .starts_with("r.csv:1:1: there is no column `moes_load`")
    );
    let error = read(&csv.replace(",20,", ",-20,"), FilmKind::Central).unwrap_err();
    assert_eq!((error.line, error.column), (2, 4), "{error}");
    let error = read_films("r.csv", csv, FilmKind::Central, None).unwrap_err();
    assert!(error.to_string().contains("radius_m"), "{error}");
}
