//! Starved contacts: against the closed form of the line contact, the limits of thick and thin layers, and
//! Reynolds' equation integrated upstream to the meniscus.

use crate::common;

use approx::assert_relative_eq;
use common::{case, heated, solved};
use ertel::case::Case;
use ertel::contact::{ContactKind, Supply};
use ertel::params::MeshParams;
use ertel::run::predicted_film;
use ertel::solution::Solution;

/// N, N/m of a line.
fn load(kind: ContactKind) -> f64 {
    if !kind.is_line() { 40.0 } else { 5e4 }
}

/// A contact whose oil is a layer of a share of the flooded film that formulas predict.
fn layer(kind: ContactKind, share: f64, target: f64) -> (Case, f64) {
    let mut case = case(kind, load(kind));
    case.mesh = MeshParams::adaptive(target, kind);
    let thickness = share * predicted_film(&case);
    case.supply = Supply::OilLayer { thickness };
    (case, thickness)
}

/// Index of the sample of the centreline nearest to x, m.
fn sample(solution: &Solution, x: f64) -> usize {
    let xs = &solution.centreline.x;
    (0..xs.len())
        .min_by(|i, j| (xs[*i] - x).abs().total_cmp(&(xs[*j] - x).abs()))
        .unwrap()
}

/// No oil leaves a line contact at its sides: ρ̄h at the centre, where pressure drives nothing, is the layer that arrives.
///
/// Theory: Starved inlet.
#[test]
fn a_line_contact_passes_the_arriving_oil() {
    for share in [0.1, 0.4, 0.8] {
        let (case, thickness) = layer(ContactKind::Line, share, 1e-3);
        let solution = solved(&case);
        let centre = sample(&solution, 0.0);
        let density = solution.centreline.density[centre] / case.lubricant.ambient_density();
        let film = solution.summary.film_central;
        assert_relative_eq!(density * film.value, thickness, max_relative = 2e-3);
        let starvation = solution.starvation.unwrap();
        let ratio = starvation.ratio_central.unwrap();
        assert!(
            ratio.value < 0.9 && ratio.error.unwrap() < 0.01,
            "{ratio:?}"
        );
        assert!(solution.summary.film_balance_error.abs() < 1e-4);
    }
}

/// From a place before the contact, where the viscosity is not yet high, Reynolds' equation of the mass flow ρ_R u h_oil,
/// p' = 12 μ u (h − ρ_R h_oil/ρ)/h³, leads upstream to p = 0: there is the meniscus.
///
/// Theory: Starved inlet.
#[test]
fn pressure_ends_at_the_meniscus() {
    let (case, thickness) = layer(ContactKind::Line, 0.5, 5e-4);
    let solution = solved(&case);
    let line = &solution.centreline;
    let u = case.motion.entrainment_speed;
    let start = (0..line.x.len())
        .find(|i| line.pressure[*i] > 0.02 * solution.hertz.pressure)
        .unwrap();
    let slope = |i: usize| {
        let carried = thickness * case.lubricant.ambient_density() / line.density[i];
        12.0 * line.viscosity[i] * u * (line.film_thickness[i] - carried)
            / line.film_thickness[i].powi(3)
    };
    let mut p = line.pressure[start];
    let mut i = start;
    let found = loop {
        let step = line.x[i] - line.x[i - 1];
        let before = p - 0.5 * step * (slope(i) + slope(i - 1));
        if before <= 0.0 {
            break line.x[i] - step * p / (p - before);
        }
        (p, i) = (before, i - 1);
    };
    let meniscus = solution.starvation.unwrap().meniscus_position.unwrap();
    let a = solution.hertz.half_width;
    assert!(meniscus.value < -a, "{meniscus:?}");
    assert_relative_eq!(meniscus.value, found, epsilon = 0.02 * a);
}

/// Of a thin layer hardly anything leaves at the sides; a thick one floods the contact; between them the film grows with the layer, and
/// is thinner than both the flooded one and the layer.
#[test]
fn a_ball_between_dry_and_flooded() {
    let mut last = 0.0;
    for (share, passes) in [(0.15, 0.97..1.001), (0.6, 0.9..1.0), (20.0, 0.0..1.0)] {
        let (case, thickness) = layer(ContactKind::Circular, share, 0.05);
        let solution = solved(&case);
        let centre = sample(&solution, 0.0);
        let density = solution.centreline.density[centre] / case.lubricant.ambient_density();
        let film = solution.summary.film_central.value;
        let passed = density * film / thickness;
        assert!(passes.contains(&passed), "{share}: {passed}");
        assert!(film > last);
        last = film;
        let starvation = solution.starvation.unwrap();
        let ratio = starvation.ratio_central.unwrap();
        match share > 1.0 {
            true => assert_relative_eq!(ratio.value, 1.0, epsilon = ratio.error.unwrap()),
            false => {
                assert!(ratio.value < 0.7, "{ratio:?}");
                let x = starvation.meniscus_position.unwrap().value;
                assert!(x < -solution.hertz.half_width);
            }
        }
    }
}

/// A meniscus far away floods the contact; the nearer it is, the thinner the film. With the layer that then passes the meniscus of a
/// line contact is found where it was put.
#[test]
fn a_meniscus_at_a_place() {
    let mut case = case(ContactKind::Line, load(ContactKind::Line));
    case.mesh = MeshParams::adaptive(1e-3, ContactKind::Line);
    let a = case.hertz().half_width;
    let mut last = 0.0;
    for distance in [1.2, 1.5, 2.0, 15.0] {
        case.supply = Supply::Meniscus {
            distance: distance * a,
        };
        let solution = solved(&case);
        let film = solution.summary.film_central.value;
        assert!(film > last);
        last = film;
        assert_relative_eq!(solution.extents[0], -distance, max_relative = 1e-12);
        let ratio = solution.starvation.as_ref().unwrap().ratio_central.unwrap();
        if distance > 10.0 {
            assert_relative_eq!(ratio.value, 1.0, epsilon = 2e-3);
            continue;
        }
        let centre = sample(&solution, 0.0);
        let density = solution.centreline.density[centre] / case.lubricant.ambient_density();
        let thickness = density * film;
        let mut layered = case.clone();
        layered.supply = Supply::OilLayer { thickness };
        let again = solved(&layered);
        assert_relative_eq!(again.summary.film_central.value, film, max_relative = 3e-3);
        let x = again.starvation.unwrap().meniscus_position.unwrap().value;
        assert_relative_eq!(x / a, -distance, epsilon = 0.02);
    }
}

/// Oil that does not fill the gap heats and carries heat by the share that it fills.
#[test]
fn heat_of_a_starved_contact_balances() {
    let mut case = heated(common::case(ContactKind::Line, load(ContactKind::Line)));
    case.motion.slide_to_roll_ratio = 0.3;
    case.mesh = MeshParams::adaptive(5e-3, ContactKind::Line);
    let thickness = 0.5 * predicted_film(&case);
    case.supply = Supply::OilLayer { thickness };
    let solution = solved(&case);
    let thermal = solution.thermal.unwrap();
    assert!(thermal.balance.error.abs() < 0.01, "{:?}", thermal.balance);
    assert!(solution.starvation.unwrap().ratio_central.unwrap().value < 0.7);
}
