//! Films between perfect conductors against closed forms.

use approx::assert_relative_eq;
use ertel_rheology::density::DensityLaw;
use ertel_rheology::viscosity::{Cheng, ViscosityLaw};
use ertel_rheology::{ConductivityLaw, HeatCapacityLaw};

use super::columns::{FilmHeat, Films};
use super::temperatures::{Bodies, account, step, unheated};
use super::warmth::of_film;
use crate::contact::{HertzZone, Motion, Turn};
use crate::film::cross_film::CrossFilm;
use crate::film::{FilmFluid, FilmNodes, MOST_NODES};
use crate::forms::energy::{BodyHeat, Heat, Heights};
use crate::volumes::contents::Arrival;
use crate::volumes::convolution::Convolution;
use crate::volumes::grid::Grid;
use crate::volumes::system::{State, System};
use crate::volumes::tests::problem;

const AMBIENT: f64 = 313.15;
const CONDUCTIVITY: f64 = 0.13;
const VISCOSITY: f64 = 0.04;
const FILM: f64 = 1e-7;

/// Rise at mid-film, K, and heat of shear, W/m², in the middle of a uniform film of 100 nm between surfaces that slide by their mean speed, m/s, and take away all heat.
fn couette(speed: f64, viscosity: &ViscosityLaw) -> (f64, f64, f64) {
    let motion = Motion::straight(speed, 1.0);
    let problem = problem(&motion, 0.01);
    let scales = &problem.scales;
    let density = DensityLaw::dowson_higginson(870.0).unwrap();
    let fluid = FilmFluid::new(&density, viscosity, AMBIENT, scales)
        .with_shear(None, &motion.sliding(scales.length), scales)
        .with_nodes(FilmNodes::new(8));
    let body = |velocity| BodyHeat {
        density: 7850.0,
        conductivity: ConductivityLaw::constant(1e9).unwrap(),
        heat_capacity: HeatCapacityLaw::constant(470.0).unwrap(),
        velocity,
        bulk_temperature: AMBIENT,
    };
    let heat = Heat {
        conductivity: ConductivityLaw::constant(CONDUCTIVITY).unwrap(),
        heat_capacity: HeatCapacityLaw::constant(2000.0).unwrap(),
        bodies: motion.surfaces(scales.length).map(body),
        inlet_temperature: AMBIENT,
        length: scales.length,
        film: scales.film,
        pressure: scales.pressure,
        density: scales.density,
        viscosity: scales.viscosity,
        lambda: scales.lambda,
        entrainment_speed: speed,
    };
    let zone = HertzZone {
        axis_ratio: 1.0,
        turn: Turn::NONE,
        roller: None,
    };
    let grid = Grid::covering([[-1.0, 1.0], [-1.0, 1.0]], 0.25, true, &zone);
    let n = grid.n_nodes();
    let film = FILM / scales.film;
    let system = System {
        convolution: Convolution::new(&grid, 0.3).into(),
        gap: vec![film; n],
        load: 0.0,
        beyond: None,
        fluid,
        lambda: scales.lambda,
        entrainment: problem.entrainment,
        arrival: Arrival::Flooded,
        warmth: Vec::new(),
        grid,
    };
    let state = State {
        pressure: vec![0.0; n],
        separation: 0.0,
        wetted: vec![true; n],
        contents: Vec::new(),
    };
    let heights = Heights::new(system.fluid.nodes().unwrap());
    let of = FilmHeat {
        grid: &system.grid,
        fluid: &system.fluid,
        heat: &heat,
        heights: &heights,
    };
    let bodies = Bodies::new(&system.grid, &heat, 3.15);
    let mut own = unheated(&system.grid, &heat, 9);
    let at = system.linearise(&state);
    let films = vec![film; n];
    for _ in 0..12 {
        let temperature = own.film.clone();
        let now = Films {
            pressure: &state.pressure,
            film: &films,
            missing: &[],
            temperature: &temperature,
            held: &[],
        };
        let (_, info) = step(&of, &bodies, &now, &at.faces, &mut own);
        assert!(info.is_finite);
    }
    let temperature = own.film.clone();
    let now = Films {
        pressure: &state.pressure,
        film: &films,
        missing: &[],
        temperature: &temperature,
        held: &[],
    };
    let made = account(&of, &now, &at.faces, &mut own).made;
    let [i, j] = system.grid.centre();
    let k = system.grid.index(i, j);
    (own.film[9 * k + 4] - AMBIENT, made[k][0], own.flux[0][k])
}

/// A film of one viscosity heats up by the parabola of μU²/8k, and half of its heat goes into each body.
#[test]
fn couette_flow_by_hand() {
    let (rise, made, flux) = couette(1.0, &ViscosityLaw::constant(VISCOSITY).unwrap());
    assert_relative_eq!(rise, VISCOSITY / (8.0 * CONDUCTIVITY), max_relative = 1e-4);
    assert_relative_eq!(made, VISCOSITY / FILM, max_relative = 1e-6);
    assert_relative_eq!(flux, 0.5 * made, max_relative = 1e-3);
}

/// A viscosity that falls exponentially by β: with Na = βμU²/k the rise is ln(1 + Na/8)/β, the stress that of a cold film times asinh x/(x √(1 + x²)), x² = Na/8
/// (Nahme, Ing.-Arch. 11, 1940, 191-209).
#[test]
fn nahmes_film() {
    let slope = 1.0;
    let law = ViscosityLaw::Cheng(Cheng {
        mu_0: VISCOSITY,
        alpha: 2e-8,
        beta: slope * AMBIENT * AMBIENT,
        gamma: 0.0,
        reference_temperature: AMBIENT,
    });
    let speed = 8.0;
    let nahme: f64 = slope * VISCOSITY * speed * speed / CONDUCTIVITY;
    let (rise, made, _) = couette(speed, &law);
    assert_relative_eq!(rise, (nahme / 8.0).ln_1p() / slope, max_relative = 1e-2);
    let x = (nahme / 8.0).sqrt();
    let thinned = x.asinh() / (x * (1.0 + x * x).sqrt());
    let cold = VISCOSITY * speed * speed / FILM;
    assert_relative_eq!(made, cold * thinned, max_relative = 1e-2);
}

/// What the film equation sees of a film of two layers' worth of temperatures, Newtonian: K = 12 ∫ (s − s̄)² φ ds, u_s = −∫ sφ ds/∫ φ ds of the sliding, φ = 1/μ(T(s)), by Simpson's rule.
#[test]
fn flow_of_a_film_warmer_on_one_side() {
    let motion = Motion::straight(1.0, 0.6);
    let problem = problem(&motion, 0.01);
    let scales = &problem.scales;
    let density = DensityLaw::constant(870.0).unwrap();
    let law = Cheng {
        mu_0: VISCOSITY,
        alpha: 2e-8,
        beta: 4000.0,
        gamma: 0.0,
        reference_temperature: AMBIENT,
    };
    let fluid = FilmFluid::new(&density, &ViscosityLaw::Cheng(law), AMBIENT, scales)
        .with_shear(None, &motion.sliding(scales.length), scales)
        .with_nodes(FilmNodes::new(8));
    let profile = |s: f64| AMBIENT + 10.0 + 15.0 * s - 8.0 * s * s;
    let mut temperature = [0.0; MOST_NODES];
    for (t, s) in temperature.iter_mut().zip(FilmNodes::new(8).points()) {
        *t = profile(*s);
    }
    let slide = fluid.slide().at([0.0; 2]);
    let found = of_film(
        &fluid,
        (0.2, 0.1, 0.01),
        [0.5, 0.2],
        slide,
        &temperature,
        scales.lambda,
        &mut CrossFilm::default(),
    );
    let n = 2000;
    let (mut moments, mut mean) = ([0.0; 3], 0.0);
    for k in 0..=n {
        let weight = match k {
            _ if k == 0 || k == n => 1.0,
            _ if k % 2 == 1 => 4.0,
            _ => 2.0,
        } / (3.0 * f64::from(n));
        let s = f64::from(k) / f64::from(n) - 0.5;
        mean += weight * profile(s);
        let fluidity = (-4000.0 * (1.0 / profile(s) - 1.0 / AMBIENT)).exp();
        for (p, moment) in moments.iter_mut().enumerate() {
            *moment += weight * fluidity * s.powi(p as i32);
        }
    }
    let centre = moments[1] / moments[0];
    let conductance = moments[2] - centre * moments[1];
    let uniform = (-4000.0 * (1.0 / mean - 1.0 / AMBIENT)).exp();
    assert_relative_eq!(found.temperature, mean, max_relative = 1e-9);
    for factor in found.flow {
        assert_relative_eq!(factor, 12.0 * conductance / uniform, max_relative = 1e-5);
    }
    // Δu = 0.6 of the mean speed.
    assert_relative_eq!(found.drift[0], -0.6 * centre, max_relative = 1e-5);
    assert_relative_eq!(found.density, 1.0, max_relative = 1e-9);
}
