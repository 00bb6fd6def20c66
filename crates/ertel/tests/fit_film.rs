//! Film-thickness formulas from made films.

use ertel::contact::Family;
use ertel::fit::{
    Estimate, FilmFit, FilmFitError, FilmForm, FilmKind, FilmState, Films, FormError,
    contact_of_films, fit_film,
};
use ertel::reference::{moes_line_asymptotes, nijenbanning_venner_moes_asymptotes};

/// Habchi 2008, eq. 6.4: fluid C, central film.
const FACTOR: f64 = 2.2318;
const EXPONENT_M: f64 = -0.1362;
const EXPONENT_L: f64 = 0.0198;

const RADIUS: f64 = 12.7e-3;
const SPEED_GROUP: f64 = 1e-12;

fn film(load: f64, material: f64, noise: f64) -> FilmState {
    let scale = RADIUS * f64::sqrt(2.0 * SPEED_GROUP);
    let powers = load.powf(EXPONENT_M) * material.powf(EXPONENT_L);
    FilmState {
        film: FACTOR * scale * powers * noise.exp(),
        scale,
        variables: vec![load, material],
        error: None,
    }
}

fn films(form: FilmForm, states: Vec<FilmState>) -> Films {
    Films {
        form,
        kind: FilmKind::Central,
        states,
        warnings: Vec::new(),
    }
}

fn moes(states: &[FilmState]) -> Result<FilmFit, FilmFitError> {
    fit_film(&films(FilmForm::Moes, states.to_vec()), 0.95)
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

fn estimates(fit: &FilmFit) -> Vec<Estimate> {
    fit.constants.iter().map(|c| c.unwrap()).collect()
}

/// The groups of Hamrock and Dowson give the same films.
#[test]
fn a_formula_is_the_same_in_other_groups() {
    let fit = moes(&grid(|| 0.0)).unwrap();
    for (family, power) in [(Family::Point, 0.75), (Family::Cylinder, 0.5)] {
        let [factor, speed, material, load] = fit.hamrock_dowson(family).unwrap();
        for state in grid(|| 0.0) {
            // M = W (2U)^-power, L = G (2U)^(1/4).
            let (u, twice) = (SPEED_GROUP, 2.0 * SPEED_GROUP);
            let w = state.variables[0] * twice.powf(power);
            let g = state.variables[1] / twice.powf(0.25);
            let film = factor * RADIUS * u.powf(speed) * g.powf(material) * w.powf(load);
            assert!((film / state.film - 1.0).abs() < 1e-6);
        }
    }
    let circular = contact_of_films("load_N,film_central_m\n1,1e-7\n");
    assert_eq!(circular, Some(Family::Point));
    let line = contact_of_films("load [kN/m]; film_central_m\n1; 1e-7\n");
    assert_eq!(line, Some(Family::Cylinder));
    assert_eq!(contact_of_films("moes_load,film_central_m\n1,1e-7\n"), None);
}

/// Habchi 2008, eqs. 6.3 and 6.4.
#[test]
fn the_formula_of_exact_films_is_found() {
    let fit = moes(&grid(|| 0.0)).unwrap();
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

/// How many of 200 fits to sets with 2 % noise hold each of the true constants.
fn n_held(form: FilmForm, truth: &[f64], states: &[FilmState]) -> Vec<usize> {
    let mut random = fastrand::Rng::with_seed(64);
    let mut n_held = vec![0; truth.len()];
    for _ in 0..200 {
        let mut states = states.to_vec();
        for state in &mut states {
            state.film = form.film(truth, state) * (0.02 * normal(&mut random)).exp();
        }
        let fit = fit_film(&films(form, states), 0.95).unwrap();
        for ((n, found), value) in n_held.iter_mut().zip(estimates(&fit)).zip(truth) {
            *n += usize::from(found.interval[0] <= *value && *value <= found.interval[1]);
        }
    }
    n_held
}

/// 91 to 99 % is ±2.6 standard deviations about 95 %.
#[test]
fn intervals_cover_at_the_stated_rate() {
    for case in forms() {
        let n_held = n_held(case.form, &case.truth, &case.states);
        assert!(
            n_held.iter().all(|n| (182..=198).contains(n)),
            "{:?}: {n_held:?}",
            case.form
        );
    }
}

/// A form with constants, and films at which it determines them; the films themselves are to be made.
struct FormCase {
    form: FilmForm,
    truth: Vec<f64>,
    states: Vec<FilmState>,
}

/// Points of a grid over the values of each variable.
fn crossed(scale: f64, values: &[&[f64]]) -> Vec<FilmState> {
    let mut points = vec![Vec::new()];
    for axis in values {
        let extend = |point: &Vec<f64>, v: f64| [point.clone(), vec![v]].concat();
        points = (points.iter())
            .flat_map(|point| axis.iter().map(move |v| extend(point, *v)))
            .collect();
    }
    let state = |variables| FilmState {
        film: f64::NAN,
        scale,
        variables,
        error: None,
    };
    points.into_iter().map(state).collect()
}

fn forms() -> Vec<FormCase> {
    use Family::{Cylinder, Point};
    let loads: &[f64] = &[20.0, 100.0, 500.0, 2500.0];
    let materials: &[f64] = &[0.1, 0.5, 2.0, 8.0];
    let speeds: &[f64] = &[0.1, 0.3, 1.0, 3.0];
    let asymptotes = [
        (Point, nijenbanning_venner_moes_asymptotes(1.0, 1.0, 1.0)),
        (Cylinder, moes_line_asymptotes(1.0, 1.0)),
    ];
    let mut cases = vec![
        FormCase {
            form: FilmForm::Moes,
            truth: vec![FACTOR, EXPONENT_M, EXPONENT_L],
            states: crossed(2e-8, &[loads, materials]),
        },
        // Hamrock and Dowson 1977, central film of a circle: 2.69 (1 - 0.61 e^-0.73) = 1.899.
        FormCase {
            form: FilmForm::HamrockDowson(Point),
            truth: vec![1.899, 0.67, 0.53, -0.067],
            states: crossed(
                RADIUS,
                &[
                    &[1e-12, 1e-11, 1e-10],
                    &[500.0, 2000.0, 5000.0],
                    &[1e-7, 1e-6, 1e-5],
                ],
            ),
        },
        FormCase {
            form: FilmForm::Speed,
            truth: vec![4.5e-8, 0.67],
            states: crossed(1.0, &[speeds]),
        },
        FormCase {
            form: FilmForm::SpeedLoad(Point),
            truth: vec![4.5e-8, 0.67, -0.07],
            states: crossed(1.0, &[speeds, &[5.0, 20.0, 80.0]]),
        },
    ];
    for (contact, asymptotes) in asymptotes {
        cases.push(FormCase {
            form: FilmForm::Blend(contact),
            truth: vec![
                asymptotes.isoviscous_elastic,
                asymptotes.piezoviscous_elastic,
                2.5,
            ],
            states: crossed(2e-8, &[loads, materials]),
        });
    }
    cases
}

#[test]
fn the_constants_of_exact_films_are_found_in_every_form() {
    for case in forms() {
        let mut states = case.states.clone();
        for state in &mut states {
            state.film = case.form.film(&case.truth, state);
        }
        let fit = fit_film(&films(case.form, states), 0.95).unwrap();
        for (found, expected) in estimates(&fit).iter().zip(&case.truth) {
            let off = (found.value / expected - 1.0).abs();
            assert!(off < 1e-6, "{:?}: {found:?} for {expected}", case.form);
        }
        assert!(fit.warnings.is_empty(), "{:?}", fit.warnings);
    }
}

/// The blend tends to the published asymptotes of either contact, and lies above both.
#[test]
fn the_blend_has_the_published_asymptotes() {
    type Published = fn(f64, f64) -> ertel::reference::Asymptotes;
    let families: [(Family, Published); 2] = [
        (Family::Point, |m, l| {
            nijenbanning_venner_moes_asymptotes(m, l, 1.0)
        }),
        (Family::Cylinder, moes_line_asymptotes),
    ];
    for (contact, asymptotes) in families {
        let form = FilmForm::Blend(contact);
        let one = asymptotes(1.0, 1.0);
        let constants = [one.isoviscous_elastic, one.piezoviscous_elastic, 2.0];
        let film = |m: f64, l: f64| {
            let states = crossed(1.0, &[&[m], &[l]]);
            form.film(&constants, &states[0])
        };
        for m in [20.0, 1000.0] {
            let isoviscous = asymptotes(m, 0.0).isoviscous_elastic;
            assert!((film(m, 0.0) / isoviscous - 1.0).abs() < 1e-12);
            let piezoviscous = asymptotes(m, 1e5).piezoviscous_elastic;
            assert!((film(m, 1e5) / piezoviscous - 1.0).abs() < 1e-6);
            let both = asymptotes(m, 3.0);
            let sum = both.isoviscous_elastic.powi(2) + both.piezoviscous_elastic.powi(2);
            assert!((film(m, 3.0) / sum.sqrt() - 1.0).abs() < 1e-12);
        }
    }
}

/// Text, LaTeX and code of every form.
#[test]
fn formulas_are_written_in_every_form() {
    let written: Vec<[String; 3]> = forms()
        .into_iter()
        .map(|case| {
            let mut states = case.states;
            for state in &mut states {
                state.film = case.form.film(&case.truth, state);
            }
            let fit = fit_film(&films(case.form, states), 0.95).unwrap();
            [fit.text(), fit.latex(), fit.code()]
        })
        .collect();
    assert_eq!(
        written[1],
        [
            "h_c = 1.899 R U^0.6700 G^0.5300 W^-0.0670",
            "h_c = 1.899\\, R\\, U^{0.6700}\\, G^{0.5300}\\, W^{-0.0670}",
            "h_c = 1.899 * R * U ** (0.6700) * G ** (0.5300) * W ** (-0.0670)",
        ]
    );
    assert_eq!(
        written[2],
        [
            "h_c = 4.5000e-8 m (u/(1 m/s))^0.6700",
            "h_c = 4.5000 \\cdot 10^{-8}\\, \\mathrm{m}\\, \\left(\\frac{u}{1\\,\\mathrm{m/s}}\\right)^{0.6700}",
            "h_c = 4.5000e-8 * u ** (0.6700)",
        ]
    );
    assert_eq!(
        written[3][0],
        "h_c = 4.5000e-8 m (u/(1 m/s))^0.6700 (F/(1 N))^-0.0700"
    );
    assert_eq!(
        written[4],
        [
            "h_c = R √(2U) [(2.4188 M^(-2/15))^2.5 + (1.2474 M^(-1/12) L^(3/4))^2.5]^(1/2.5)",
            "h_c = R \\sqrt{2U} \\left[\\left(2.4188\\, M^{-2/15}\\right)^{2.5} + \\left(1.2474\\, \
             M^{-1/12} L^{3/4}\\right)^{2.5}\\right]^{1/2.5}",
            "h_c = R * (2 * U) ** 0.5 * ((2.4188 * M ** (-2/15)) ** 2.5 + (1.2474 * M ** (-1/12) * L ** (3/4)) ** 2.5) \
             ** (1 / 2.5)",
        ]
    );
    assert!(written[5][0].contains("(2.621 M^(-1/5))^2.5 + (1.311 M^(-1/8) L^(3/4))^2.5"));
}

/// Where the films lie on one asymptote, the other one and the blend are not determined.
#[test]
fn an_undetermined_blend_gives_a_warning() {
    let form = FilmForm::Blend(Family::Point);
    let truth = [2.42, 1.25, 2.5];
    let made = |materials: &[f64], noise: f64| {
        let mut random = fastrand::Rng::with_seed(3);
        let mut states = crossed(2e-8, &[&[20.0, 100.0, 500.0, 2500.0], materials]);
        for state in &mut states {
            state.film = form.film(&truth, state) * (noise * normal(&mut random)).exp();
        }
        fit_film(&films(form, states), 0.95)
    };
    let error = made(&[0.0], 0.0).unwrap_err();
    assert_eq!(error, FilmFitError::Undetermined("c_2"));
    let fit = made(&[0.2, 0.5, 1.0], 0.02).unwrap();
    let warned = |name: &str| {
        let start = format!("the data hardly determine {name}");
        fit.warnings.iter().any(|w| w.starts_with(&start))
    };
    assert!(warned("c_2") && warned("s"), "{:?}", fit.warnings);
    assert!(fit.warnings.iter().any(|w| w.contains("trade off")));
}

#[test]
fn undetermined_exponents_give_a_warning() {
    let fit = moes;
    // L stays
    let one = [20.0, 100.0, 500.0, 2500.0].map(|m| film(m, 0.5, 0.0));
    let fitted = fit(&one).unwrap();
    assert_eq!(fitted.constants[2], None);
    assert!(
        fitted.warnings[0].contains("L does not vary"),
        "{:?}",
        fitted.warnings
    );
    assert!((fitted.constants[1].unwrap().value - EXPONENT_M).abs() < 1e-8);
    assert!((fitted.constants[0].unwrap().value - FACTOR * 0.5f64.powf(EXPONENT_L)).abs() < 1e-8);
    // Only the speed varies: M falls and L grows as powers of it
    let speeds =
        [1.0f64, 2.0, 4.0, 8.0, 16.0].map(|u| film(1e3 * u.powf(-0.75), u.powf(0.25), 0.0));
    assert_eq!(
        fit(&speeds).unwrap_err(),
        FilmFitError::Collinear("M and L".to_owned())
    );
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

/// Exact films have no scatter; their error bars move the line by hand: ln c by the mean of the bars, the slope over
/// ln u = -l, 0, l by half the outer ones over l.
#[test]
fn error_bars_widen_the_intervals() {
    let mut states = crossed(1.0, &[&[0.5, 1.0, 2.0]]);
    for (state, bar) in states.iter_mut().zip([0.01, 0.02, 0.03]) {
        state.film = FilmForm::Speed.film(&[4.5e-8, 0.67], state);
        state.error = Some(bar);
    }
    let fit = |states: &[FilmState]| fit_film(&films(FilmForm::Speed, states.to_vec()), 0.95);
    let widened = fit(&states).unwrap().widened.unwrap();
    let [Some([low_c, high_c]), Some([low_a, high_a])] = widened[..] else {
        panic!("{widened:?}");
    };
    assert!(((high_c / 4.5e-8).ln() - 0.02).abs() < 1e-8, "{high_c}");
    assert!(((low_c / 4.5e-8).ln() + 0.02).abs() < 1e-8, "{low_c}");
    let moved = 0.02 / 2f64.ln();
    assert!((high_a - 0.67 - moved).abs() < 1e-8 && (0.67 - low_a - moved).abs() < 1e-8);
    states[1].error = None;
    assert_eq!(fit(&states).unwrap().widened, None);
}

#[test]
fn forms_have_names() {
    for name in FilmForm::NAMES {
        assert!(FilmForm::named(name, Some(Family::Cylinder)).is_ok());
    }
    for name in ["hamrock-dowson", "blend", "speed-load"] {
        let error = FilmForm::named(name, None).unwrap_err();
        assert_eq!(error, FormError::Shape(name.to_owned()));
    }
    let error = FilmForm::named("grubin", None).unwrap_err().to_string();
    assert!(error.contains("moes, hamrock-dowson, elliptical, blend, speed, speed-load"));
}
