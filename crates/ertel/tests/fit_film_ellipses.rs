//! The film formula with ellipticity and the angle of the motion, from made films of ellipses.

use crate::common::near;
use std::f64::consts::{FRAC_PI_2, PI};
use std::fmt::Write as _;

use approx::assert_relative_eq;
use ertel::fit::{FilmFit, FilmFitError, FilmForm, FilmKind, FilmState, fit_film, read_films};

/// Chittenden et al. 1985, central film, c, a, b, d, e and f.
const CHITTENDEN: [f64; 6] = [4.31, 0.68, 0.49, -0.073, 1.23, 2.0 / 3.0];

const MODULUS: f64 = 230e9;
const ALPHA: f64 = 20e-9;

/// An ellipse: reduced radii (m), angle of the motion (degrees), viscosity times speed (N/m) and load (N).
#[derive(Clone, Copy)]
struct Point {
    radii: [f64; 2],
    angle: f64,
    speed: f64,
    load: f64,
    alpha: f64,
}

impl Point {
    /// Film of a motion along the axis `i`, by the formula as it is printed, with the groups of this axis.
    fn along(&self, i: usize) -> f64 {
        let [c, a, b, d, e, f] = CHITTENDEN;
        let (radius, other) = (self.radii[i], self.radii[1 - i]);
        let u = self.speed / (MODULUS * radius);
        let w = self.load / (MODULUS * radius * radius);
        let g = self.alpha * MODULUS;
        let shape = 1.0 - (-e * (other / radius).powf(f)).exp();
        c * radius * u.powf(a) * g.powf(b) * w.powf(d) * shape
    }

    /// h^(2/a) of the motions along the two axes, added by the squares of the components.
    fn film(&self) -> f64 {
        let n = 2.0 / CHITTENDEN[1];
        let (s, c) = self.angle.to_radians().sin_cos();
        let sum = self.along(0).powf(n) * c * c + self.along(1).powf(n) * s * s;
        sum.powf(1.0 / n)
    }

    /// A line of a table of a study: the groups are those of the radius along the motion.
    fn line(&self, film: f64, error: &str) -> String {
        let (s, c) = self.angle.to_radians().sin_cos();
        let [x, y] = self.radii;
        let along = 1.0 / (c * c / x + s * s / y);
        let u = self.speed / (MODULUS * along);
        let m = self.load / (MODULUS * along * along) * (2.0 * u).powf(-0.75);
        let l = self.alpha * MODULUS * (2.0 * u).powf(0.25);
        let angle = self.angle.to_radians();
        format!("{x:e},{y:e},{angle:e},{u:e},{m:e},{l:e},{film:e},{error}\n")
    }
}

const HEAD: &str = "radius_m,radius_y_m,entrainment_angle_rad,speed_group,moes_load,moes_material,film_central_m,film_central_error_m\n";

fn table(points: &[Point], mut factor: impl FnMut() -> f64, error: f64) -> String {
    let mut text = HEAD.to_owned();
    for point in points {
        let film = point.film() * factor();
        let error = if error > 0.0 {
            (error * film).to_string()
        } else {
            String::new()
        };
        let _ = write!(text, "{}", point.line(film, &error));
    }
    text
}

/// Ratios of axes of the Hertz ellipse from about 0.2 to 10, angles from 0 to 90 degrees, speeds, loads, lubricants.
fn points() -> Vec<Point> {
    let mut points = Vec::new();
    for (i, ratio) in [0.08, 0.35, 1.0, 1.7, 8.0, 37.0].into_iter().enumerate() {
        for (j, angle) in [0.0, 20.0, 45.0, 70.0, 90.0].into_iter().enumerate() {
            for speed in [0.004, 0.04] {
                points.push(Point {
                    radii: [0.016, 0.016 * ratio],
                    angle,
                    speed,
                    load: [20.0, 60.0, 180.0][(i + j) % 3],
                    alpha: ALPHA * [0.7, 1.0, 1.3, 1.1][(i + 2 * j) % 4],
                });
            }
        }
    }
    points
}

fn fitted(text: &str) -> Result<FilmFit, FilmFitError> {
    let films = read_films("e.csv", text, FilmForm::Elliptical, FilmKind::Central, None);
    fit_film(&films.unwrap().unwrap(), 0.95)
}

#[test]
fn the_constants_of_exact_films_are_found() {
    let fit = fitted(&table(&points(), || 1.0, 0.0)).unwrap();
    for (found, expected) in fit.values().iter().zip(CHITTENDEN) {
        assert_relative_eq!(*found, expected, max_relative = 1e-6);
    }
    assert!(fit.warnings.is_empty(), "{:?}", fit.warnings);
    assert_eq!(fit.widened, None);
    assert_eq!(
        fit.text(),
        "h_c = 4.31 R_x U^0.6800 G^0.4900 W^-0.0730 [(1 - exp(-1.2300 D^0.6667))^2.9412 cos²θ + (D^0.4660 (1 - exp(-1.2300 \
         D^(-0.6667))))^2.9412 sin²θ]^0.3400, D = R_y/R_x"
    );
    assert!(fit.code().contains(
        "* ((1 - exp(-1.2300 * (R_y / R_x) ** 0.6667)) ** 2.9412 * cos(theta) ** 2 + ((R_y / R_x) ** (0.4660) *"
    ));
    assert!(fit.latex().contains("\\cos^2\\theta"));
}

/// 91 to 99 % is ±2.6 standard deviations about 95 %.
#[test]
fn intervals_cover_at_the_stated_rate() {
    let mut random = fastrand::Rng::with_seed(85);
    let mut normal = || {
        let radius = (-2.0 * (1.0 - random.f64()).ln()).sqrt();
        radius * (2.0 * PI * random.f64()).cos()
    };
    let points = points();
    let mut n_held = [0; 6];
    for _ in 0..200 {
        let fit = fitted(&table(&points, || (0.02 * normal()).exp(), 0.0)).unwrap();
        for ((n, found), value) in n_held.iter_mut().zip(&fit.constants).zip(CHITTENDEN) {
            let [low, high] = found.unwrap().interval;
            *n += usize::from(low <= value && value <= high);
        }
    }
    assert!(n_held.iter().all(|n| (182..=198).contains(n)), "{n_held:?}");
}

/// Error bars of all films move the constants, all of them one way, by more than the exact films' scatter, which is none.
#[test]
fn error_bars_widen_the_intervals() {
    let fit = fitted(&table(&points(), || 1.0, 0.01)).unwrap();
    let widened = fit.widened.unwrap();
    for (constant, wide) in fit.constants.iter().zip(widened) {
        let ([low, high], [wide_low, wide_high]) = (constant.unwrap().interval, wide.unwrap());
        assert!(wide_high - wide_low > 1e3 * (high - low));
        assert!(wide_low < low && high < wide_high);
    }
}

/// Ratio and angle alone determine all but the exponent of G.
#[test]
fn ratio_and_angle_alone_are_enough() {
    let mut points = points();
    for point in &mut points {
        (point.speed, point.load, point.alpha) = (0.02, 50.0, ALPHA);
    }
    let fit = fitted(&table(&points, || 1.0, 0.0)).unwrap();
    assert_eq!(fit.constants[2], None);
    assert!(
        fit.warnings[0].starts_with("G does not vary"),
        "{:?}",
        fit.warnings
    );
    let [c, a, b, d, e, f] = CHITTENDEN;
    let expected = [c * (ALPHA * MODULUS).powf(b), a, 0.0, d, e, f];
    for (found, expected) in fit.values().iter().zip(expected) {
        assert_relative_eq!(*found, expected, max_relative = 1e-5);
    }
}

/// A circle keeps the power law at all angles, with c (1 − e^(−e)); a long cylinder feels the component of the speed across its
/// axis alone; exchanged axes are the same contact.
#[test]
fn limits_of_the_form() {
    let film = |radii: [f64; 2], angle: f64| {
        let point = Point {
            radii,
            angle,
            speed: 0.02,
            load: 50.0,
            alpha: ALPHA,
        };
        let text = HEAD.to_owned() + &point.line(1e-7, "");
        let films = read_films(
            "e.csv",
            &text,
            FilmForm::Elliptical,
            FilmKind::Central,
            None,
        );
        let state: FilmState = films.unwrap().unwrap().states[0].clone();
        let by_form = FilmForm::Elliptical.film(&CHITTENDEN, &state);
        assert_relative_eq!(by_form, point.film(), max_relative = 1e-10);
        assert!(state.variables[4] < 0.5 * FRAC_PI_2 + 1e-9);
        by_form
    };
    let [c, a, b, d, e, _] = CHITTENDEN;
    let (u, w) = (0.02 / (MODULUS * 0.016), 50.0 / (MODULUS * 0.016 * 0.016));
    let power_law = 0.016 * u.powf(a) * (ALPHA * MODULUS).powf(b) * w.powf(d);
    for angle in [0.0, 33.0, 90.0] {
        let expected = c * (1.0 - (-e).exp()) * power_law;
        assert_relative_eq!(film([0.016; 2], angle), expected, max_relative = 1e-10);
    }
    // D = 1e9: the film of a motion along the axis is e D^(1 - a - 2d - f) = 2 % of that across it, its power 2/a 9e-6.
    let angle = 40f64;
    near(
        film([0.016, 1.6e7], angle),
        c * power_law * angle.to_radians().cos().powf(a),
        1e-5,
    );
    near(
        film([0.016, 0.064], 25.0),
        film([0.064, 0.016], 65.0),
        1e-10,
    );
    near(
        film([0.016, 0.064], 25.0),
        film([0.016, 0.064], -25.0),
        1e-12,
    );
}

/// Ellipses of one shape rolling along x do not determine the effect of ellipticity.
#[test]
fn undetermined_constants_are_an_error() {
    let mut points = points();
    for point in &mut points {
        (point.radii, point.angle) = ([0.016, 0.032], 0.0);
    }
    let error = fitted(&table(&points, || 1.0, 0.0)).unwrap_err();
    assert!(
        matches!(error, FilmFitError::Inseparable(_)),
        "{error:?}: {error}"
    );
    assert!(error.to_string().contains("`hamrock-dowson`"), "{error}");
    let error = fitted(&table(&points[..5], || 1.0, 0.0)).unwrap_err();
    assert!(matches!(error, FilmFitError::TooFew { .. }), "{error}");
}

#[test]
fn bad_tables_are_refused_with_their_place() {
    let good = table(&points(), || 1.0, 0.0);
    let read = |text: &str, form| read_films("e.csv", text, form, FilmKind::Central, None);
    let first = |column: usize, cell: &str| {
        let mut lines: Vec<String> = good.lines().map(str::to_owned).collect();
        let mut cells: Vec<&str> = lines[1].split(',').collect();
        cells[column] = cell;
        lines[1] = cells.join(",");
        lines.join("\n")
    };
    for (text, starts) in [
        (
            good.replace("radius_y_m", "other_m"),
            "e.csv:1:1: there is no column `radius_y` with a unit",
        ),
        (
            good.replace("radius_m,", "other_m,"),
            "e.csv:1:1: there is no column `radius` with a unit",
        ),
        (
            first(1, "-0.01"),
            "e.csv:2:2: radius y: -0.01 has no logarithm",
        ),
        (
            first(2, "45"),
            "e.csv:2:3: entrainment angle: 45 rad is more than a turn",
        ),
        (first(2, "along"), "e.csv:2:3: entrainment angle"),
    ] {
        let error = read(&text, FilmForm::Elliptical).unwrap_err().to_string();
        assert!(error.starts_with(starts), "{error}");
    }
    // Other forms warn that they neglect the shape, and use the radius along the motion.
    let films = read(&good, FilmForm::Moes).unwrap().unwrap();
    assert!(
        films.warnings[0].starts_with("the ellipses differ, R_y/R_x from"),
        "{:?}",
        films.warnings
    );
    // Axes of studies name the inputs.
    let axes = good
        .replace("radius_m,", "radius_x_m,")
        .replace("radius_y_m", "contact.radius_y_m")
        .replace("entrainment_angle_rad", "contact.entrainment_angle [rad]");
    let named = read(&axes, FilmForm::Elliptical).unwrap().unwrap();
    assert_eq!(
        named.states,
        read(&good, FilmForm::Elliptical).unwrap().unwrap().states
    );
}
