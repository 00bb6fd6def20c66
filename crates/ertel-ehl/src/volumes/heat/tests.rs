//! Films between perfect conductors against closed forms.

use approx::assert_relative_eq;
use ertel_rheology::density::{DensityLaw, DowsonHigginson, ThermalExpansion};
use ertel_rheology::viscosity::{Cheng, ViscosityLaw};
use ertel_rheology::{ConductivityLaw, HeatCapacityLaw};

use super::columns::{Columns, FilmHeat, Films, place};
use super::temperatures::{Bodies, Temperatures, account, moving_body, step, unheated};
use super::warm_up::of_film;
use crate::contact::{HertzZone, Motion, Turn};
use crate::film::cross_film::CrossFilm;
use crate::film::{FilmFluid, FilmNodes, MOST_NODES};
use crate::forms::energy::{BodyHeat, Heat, Heights};
use crate::transient::scheme::Weights;
use crate::volumes::contents::Arrival;
use crate::volumes::contents::Edges;
use crate::volumes::deflection::Deflection;
use crate::volumes::grid::Grid;
use crate::volumes::kernel::Kernel;
use crate::volumes::rows::RING;
use crate::volumes::storage::Storage;
use crate::volumes::system::{Balance, Linearised, State, System};
use crate::volumes::tests::problem;

const AMBIENT: f64 = 313.15;
const CONDUCTIVITY: f64 = 0.13;
const VISCOSITY: f64 = 0.04;
const FILM: f64 = 1e-7;
const DENSITY: f64 = 870.0;
const HEAT_CAPACITY: f64 = 2000.0;

/// Order of the temperature across the film, and its nodes.
const ORDER: usize = 8;
const NODES: usize = ORDER + 1;

/// A film of one height, m, between perfect conductors on a grid, moved by their mean speed, m/s, and sheared by their sliding, m/s.
struct Channel {
    system: System,
    state: State,
    heat: Heat,
    heights: Heights,
    films: Vec<f64>,
}

impl Channel {
    fn new(height: f64, motion: &Motion, viscosity: &ViscosityLaw, rows: f64, h: f64) -> Channel {
        Channel::of_order(ORDER, height, motion, viscosity, (rows, h))
    }

    /// With polynomials of an order across the film.
    fn of_order(
        order: usize,
        height: f64,
        motion: &Motion,
        viscosity: &ViscosityLaw,
        (rows, h): (f64, f64),
    ) -> Channel {
        let problem = problem(motion, 0.01);
        let scales = &problem.scales;
        let density = DensityLaw::dowson_higginson(DENSITY).unwrap();
        let fluid = FilmFluid::new(&density, viscosity, AMBIENT, scales)
            .with_shear(None, &motion.sliding(scales.length), scales)
            .with_nodes(FilmNodes::new(order));
        let body = |velocity| BodyHeat {
            layers: Vec::new(),
            density: 7850.0,
            conductivity: ConductivityLaw::constant(1e9).unwrap(),
            heat_capacity: HeatCapacityLaw::constant(470.0).unwrap(),
            velocity,
            bulk_temperature: AMBIENT,
        };
        let heat = Heat {
            conductivity: ConductivityLaw::constant(CONDUCTIVITY).unwrap(),
            heat_capacity: HeatCapacityLaw::constant(HEAT_CAPACITY).unwrap(),
            bodies: motion.surfaces(scales.length).map(body),
            inlet_temperature: AMBIENT,
            length: scales.length,
            film: scales.film,
            pressure: scales.pressure,
            density: scales.density,
            viscosity: scales.viscosity,
            lambda: scales.lambda,
            entrainment_speed: motion.entrainment_speed,
        };
        let zone = HertzZone {
            axis_ratio: 1.0,
            turn: Turn::NONE,
            roller: None,
        };
        let grid = Grid::covering([[-1.0, 1.0], [-rows, rows]], [h; 2], true, &zone);
        let n = grid.n_nodes();
        let film = height / scales.film;
        let system = System {
            convolution: Deflection::new(&grid, Kernel::HalfSpace { compliance: 0.3 }).into(),
            gap: vec![film; n],
            load: 0.0,
            beyond: None,
            edges: Edges::default(),
            fluid,
            lambda: scales.lambda,
            entrainment: problem.entrainment,
            arrival: Arrival::Flooded,
            warmth: Vec::new(),
            storage: None,
            balance: Balance::LOAD,
            rough: None,
            grid,
        };
        Channel {
            state: State {
                pressure: vec![0.0; n],
                oil: Vec::new(),
                separation: 0.0,
                wetted: vec![true; n],
                contents: Vec::new(),
            },
            heights: Heights::new(system.fluid.nodes().unwrap()),
            films: vec![film; n],
            system,
            heat,
        }
    }

    fn of<'a>(&'a self, stored: Option<&'a Storage>) -> FilmHeat<'a> {
        FilmHeat {
            grid: &self.system.grid,
            fluid: &self.system.fluid,
            heat: &self.heat,
            heights: &self.heights,
            stored,
        }
    }

    fn films<'a>(&'a self, temperature: &'a [f64]) -> Films<'a> {
        Films {
            pressure: &self.state.pressure,
            film: &self.films,
            missing: &[],
            temperature,
            held: &[],
            pressure_rate: &[],
            rubbing: &[],
        }
    }

    /// Temperatures after some steps from the given ones, which are fixed along the edges.
    fn solve(&self, own: &mut Temperatures) -> Linearised {
        self.solve_at(None, own)
    }

    /// The same at an instant.
    fn solve_at(&self, stored: Option<&Storage>, own: &mut Temperatures) -> Linearised {
        self.solve_with(stored, own, 1.0)
    }

    /// The same with some times the flow through the faces.
    fn solve_with(
        &self,
        stored: Option<&Storage>,
        own: &mut Temperatures,
        more: f64,
    ) -> Linearised {
        let bodies = Bodies::new(&self.system.grid, &self.heat, 3.15, None);
        let mut at = self.system.linearise(&self.state);
        for face in at.faces.iter_mut().flatten() {
            face.flux *= more;
        }
        for _ in 0..12 {
            let temperature = own.film.clone();
            let now = self.films(&temperature);
            let (_, info) = step(&self.of(stored), &bodies, &now, &at.faces, own);
            assert!(info.is_finite);
        }
        at
    }
}

/// Rise at mid-film, K, and heat of shear, W/m², in the middle of a uniform film of 100 nm between surfaces that slide by their mean speed, m/s, and take away all heat; by polynomials of an
/// even order.
fn couette(speed: f64, viscosity: &ViscosityLaw, order: usize) -> (f64, f64, f64) {
    let motion = Motion::straight(speed, 1.0);
    let channel = Channel::of_order(order, FILM, &motion, viscosity, (1.0, 0.25));
    let grid = &channel.system.grid;
    let mut own = unheated(grid, &channel.heat, order + 1);
    let at = channel.solve(&mut own);
    let temperature = own.film.clone();
    let now = channel.films(&temperature);
    let made = account(&channel.of(None), &now, &at.faces, &mut own).made;
    let [i, j] = grid.centre();
    let k = grid.index(i, j);
    (
        own.film[(order + 1) * k + order / 2] - AMBIENT,
        made[k][0],
        own.flux[0][k],
    )
}

/// A film that comes warm between cold walls, T = T_w + ΔT cos πs, cools as e^(−x/l), l = ρ c u h²/(π² k) (Graetz's problem of a plug flow, its first wave): largest
/// error of the temperatures at mid-film, of ΔT. The faces of the film equation carry `more` times the flow of the nodes, and l is as much longer.
fn cooling_error(cells: u32, more: f64) -> f64 {
    let speed = 1.0;
    let motion = Motion::straight(speed, 0.0);
    let length = problem(&motion, 0.01).scales.length;
    // The film cools by e^−2 along the grid.
    let height =
        std::f64::consts::PI * (CONDUCTIVITY * length / (DENSITY * HEAT_CAPACITY * speed)).sqrt();
    let h = 2.0 / f64::from(cells);
    let viscosity = ViscosityLaw::constant(VISCOSITY).unwrap();
    let channel = Channel::new(height, &motion, &viscosity, 4.0 * h, h);
    let grid = &channel.system.grid;
    let mut own = unheated(grid, &channel.heat, NODES);
    let rise = |x: f64, s: f64| 20.0 * (std::f64::consts::PI * s).cos() * (-(1.0 + x) / more).exp();
    let heights = FilmNodes::new(8).points().to_vec();
    for (k, [i, j]) in grid.nodes().enumerate().filter(|(_, [i, _])| *i < RING) {
        for (t, s) in own.film[NODES * k..].iter_mut().zip(&heights) {
            *t = AMBIENT + rise(grid.place(i, j)[0], *s);
        }
    }
    channel.solve_with(None, &mut own, more);
    let errors = (grid.nodes().enumerate())
        .filter(|(_, [i, j])| grid.is_unknown(*i, *j))
        .map(|(k, [i, j])| {
            let found = own.film[NODES * k + NODES / 2] - AMBIENT;
            (found - rise(grid.place(i, j)[0], 0.0)).abs()
        });
    errors.fold(0.0, f64::max) / 20.0
}

/// Convection along the flow: the closed form, by the second order.
#[test]
fn film_cools_along_the_flow() {
    let [coarse, middle, fine] = [16, 32, 64].map(|cells| cooling_error(cells, 1.0));
    assert!(fine < 2e-4, "{coarse} {middle} {fine}");
    for [before, after] in [[coarse, middle], [middle, fine]] {
        let order = (before / after).log2();
        assert!((1.8..2.3).contains(&order), "{order}: {before} {after}");
    }
}

/// The film equation says how much flows: with 1.5 and with 3 times the flow of the nodes the film cools as much later.
#[test]
fn heat_is_carried_by_the_flow_of_the_film_equation() {
    for more in [1.5, 3.0] {
        let error = cooling_error(32, more);
        assert!(error < 1e-3, "{more}: {error}");
    }
}

/// A film that is warm everywhere between cold walls, T = T_w + ΔT cos πs, cools as e^(−t/τ), τ = ρ c h²/(π² k): error at mid-film after 2τ in so many steps.
fn cooling_in_time_error(steps: u32) -> f64 {
    let speed = 1.0;
    let motion = Motion::straight(speed, 0.0);
    let length = problem(&motion, 0.01).scales.length;
    // τ is the time in which the film passes a half-width.
    let height =
        std::f64::consts::PI * (CONDUCTIVITY * length / (DENSITY * HEAT_CAPACITY * speed)).sqrt();
    let viscosity = ViscosityLaw::constant(VISCOSITY).unwrap();
    let channel = Channel::new(height, &motion, &viscosity, 0.5, 0.125);
    let grid = &channel.system.grid;
    let heights = FilmNodes::new(8).points().to_vec();
    let at = |time: f64| {
        let column = heights
            .iter()
            .map(|s| AMBIENT + 20.0 * (std::f64::consts::PI * s).cos() * (-time).exp());
        column.collect::<Vec<f64>>().repeat(grid.n_nodes())
    };
    let step = 2.0 / f64::from(steps);
    // The history before the start is known.
    let mut times: Vec<f64> = (0..3).map(|n| -step * f64::from(n)).collect();
    let mut films: Vec<Vec<f64>> = times.iter().map(|t| at(*t)).collect();
    for n in 1..=steps {
        let time = step * f64::from(n);
        times.insert(0, time);
        let weights = Weights::new(&times);
        let stored = Storage {
            rate: weights.rate(),
            past: weights.past(films.iter()),
        };
        // Along the edges it is given.
        let mut own = unheated(grid, &channel.heat, NODES);
        own.film = at(time);
        channel.solve_at(Some(&stored), &mut own);
        films.insert(0, own.film);
    }
    let [i, j] = grid.centre();
    let k = NODES * grid.index(i, j) + NODES / 2;
    (films[0][k] - at(2.0)[k]).abs() / 20.0
}

/// Storage in the film: the closed form, by the second order.
#[test]
fn film_cools_in_time() {
    let [coarse, fine] = [8, 16].map(cooling_in_time_error);
    let order = (coarse / fine).log2();
    assert!(fine < 2e-3, "{coarse} {fine}");
    assert!((1.7..2.5).contains(&order), "{order}: {coarse} {fine}");
}

/// A film of one viscosity heats up by the parabola of μU²/8k, and half of its heat goes into each body, whatever the order of its polynomials: nodes are filled up to different lengths.
#[test]
fn couette_flow_by_hand() {
    for order in [4, ORDER, 12] {
        let (rise, made, flux) = couette(1.0, &ViscosityLaw::constant(VISCOSITY).unwrap(), order);
        assert_relative_eq!(rise, VISCOSITY / (8.0 * CONDUCTIVITY), max_relative = 1e-4);
        assert_relative_eq!(made, VISCOSITY / FILM, max_relative = 1e-6);
        assert_relative_eq!(flux, 0.5 * made, max_relative = 1e-3);
    }
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
    let (rise, made, _) = couette(speed, &law, ORDER);
    assert_relative_eq!(rise, (nahme / 8.0).ln_1p() / slope, max_relative = 1e-2);
    let x = (nahme / 8.0).sqrt();
    let thinned = x.asinh() / (x * (1.0 + x * x).sqrt());
    let cold = VISCOSITY * speed * speed / FILM;
    assert_relative_eq!(made, cold * thinned, max_relative = 1e-2);
}

/// Coefficients of the film equation for a film with two layers of temperature, Newtonian: K = 12 ∫ (s − s̄)² φ ds, u_s = −∫ sφ ds/∫ φ ds of the sliding, φ = 1/μ(T(s)), by Simpson's rule.
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
    // The film drifts along the sliding, at any angle to the grid.
    let turned = of_film(
        &fluid,
        (0.2, 0.1, 0.01),
        [0.0; 2],
        [0.6 * slide[0], 0.8 * slide[0]],
        &temperature,
        scales.lambda,
        &mut CrossFilm::default(),
    );
    for (drift, part) in turned.drift.into_iter().zip([0.6, 0.8]) {
        assert_relative_eq!(drift, -0.6 * part * centre, max_relative = 1e-5);
    }
}

/// Oil that expands by β = 5e-4/K under a pressure that rises by p_h/1000 in the time a/u: h T β p_h/1000 · u/a of heat, whether it rises in time or along the flow. All of it enters the equations across
/// the film, and where temperatures are given the oil carries it off.
#[test]
fn compression_by_hand() {
    let motion = Motion::straight(1.0, 0.0);
    let viscosity = ViscosityLaw::constant(VISCOSITY).unwrap();
    let mut channel = Channel::of_order(4, FILM, &motion, &viscosity, (1.0, 0.25));
    let problem = problem(&motion, 0.01);
    let scales = &problem.scales;
    let expansion = ThermalExpansion {
        reference_temperature: AMBIENT,
        temperature_coefficient: 5e-4,
    };
    let law = DowsonHigginson::new(DENSITY, Some(expansion)).unwrap();
    let density = DensityLaw::DowsonHigginson(law);
    channel.system.fluid = FilmFluid::new(&density, &viscosity, AMBIENT, scales)
        .with_shear(None, &motion.sliding(scales.length), scales)
        .with_nodes(FilmNodes::new(4));
    let grid = channel.system.grid.clone();
    let hand = FILM * AMBIENT * 5e-4 * 1e-3 * scales.pressure / scales.length;
    let zeros = vec![0.0; grid.n_nodes()];
    let rates = vec![1e-3; grid.n_nodes()];
    let places = grid.nodes().map(|[i, j]| grid.place(i, j)[0]);
    let rising: Vec<f64> = places.map(|x| 1e-3 * (2.0 + x)).collect();
    for (pressure, rate) in [(&zeros, &rates), (&rising, &zeros)] {
        channel.state.pressure.clone_from(pressure);
        let at = channel.system.linearise(&channel.state);
        let mut own = unheated(&grid, &channel.heat, 5);
        let temperature = own.film.clone();
        let now = Films {
            pressure_rate: rate,
            ..channel.films(&temperature)
        };
        let columns = Columns::new(&channel.of(None), &now);
        let found = account(&channel.of(None), &now, &at.faces, &mut own);
        for (k, [i, j]) in grid.nodes().enumerate() {
            let [shear, compression, _] = found.made[k];
            assert_relative_eq!(compression, hand, max_relative = 1e-2);
            let rows: f64 = columns.rows[5 * k..][..5].iter().sum();
            assert_relative_eq!(rows, -shear - compression, max_relative = 1e-9);
            if !grid.is_unknown(i, j) {
                let to_bodies = own.flux[0][k] + own.flux[1][k];
                let carried = shear + compression - to_bodies;
                assert_relative_eq!(found.carried[k], carried, max_relative = 1e-9);
            }
        }
    }
}

/// A grid at an angle of 0.3 to the motion: bodies at 1 m/s cross it by cos 0.3 and sin 0.3, and a pressure that rises along the motion alone does so for the film.
#[test]
fn grids_at_an_angle_by_hand() {
    let motion = Motion::straight(1.0, 0.0);
    let viscosity = ViscosityLaw::constant(VISCOSITY).unwrap();
    let channel = Channel::of_order(4, FILM, &motion, &viscosity, (1.0, 0.25));
    let zone = HertzZone {
        axis_ratio: 1.0,
        turn: Turn::by(0.3),
        roller: None,
    };
    let grid = Grid::covering([[-1.0, 1.0]; 2], [0.25; 2], false, &zone);
    let [along, across] = moving_body(&channel.heat, 0, &grid, 3.15).velocity;
    assert_relative_eq!(along, 0.3_f64.cos(), max_relative = 1e-12);
    assert_relative_eq!(across.abs(), 0.3_f64.sin(), max_relative = 1e-12);
    let n = grid.n_nodes();
    let places = grid.nodes().map(|[i, j]| grid.place(i, j)[0]);
    let rising: Vec<f64> = places.map(|x| 0.1 + 0.02 * x).collect();
    let temperature = vec![AMBIENT; 5 * n];
    let films = Films {
        pressure: &rising,
        film: &vec![0.1; n],
        ..channel.films(&temperature)
    };
    let [i, j] = grid.centre();
    let [x, y] = place(&grid, &films, 5, grid.index(i, j)).pressure_gradient;
    assert_relative_eq!(x, 0.02, max_relative = 1e-9);
    assert_relative_eq!(y, 0.0, epsilon = 1e-12);
}

/// The oil carries as much heat at the nodes of a half as at those of the whole, at the centreline too, where pressure drives it across.
#[test]
fn halves_carry_the_heat_of_wholes() {
    let motion = Motion::straight(1.0, 0.0);
    let viscosity = ViscosityLaw::constant(VISCOSITY).unwrap();
    let [half, whole] = [true, false].map(|half| {
        let mut channel = Channel::of_order(4, FILM, &motion, &viscosity, (1.0, 0.25));
        let own = channel.system.grid.clone();
        let [nx, ny] = own.n;
        let grid = Grid {
            half,
            n: [nx, if half { ny } else { 2 * ny - 1 }],
            ..own
        };
        let of = |f: &dyn Fn(f64, f64) -> f64| -> Vec<f64> {
            let places = grid.nodes().map(|[i, j]| grid.place(i, j));
            places.map(|[x, y]| f(x, y)).collect()
        };
        channel.films = vec![channel.films[0]; grid.n_nodes()];
        channel.state.pressure = of(&|x, y| 0.3 - 0.1 * (x * x + y * y));
        channel.state.wetted = vec![true; grid.n_nodes()];
        channel.system.convolution =
            Deflection::new(&grid, Kernel::HalfSpace { compliance: 0.0 }).into();
        channel.system.gap = channel.films.clone();
        channel.system.grid = grid.clone();
        let warm = of(&|x, y| AMBIENT + 5.0 * x.cos() * (1.0 + 0.5 * y * y));
        let mut own = unheated(&grid, &channel.heat, 5);
        own.film = warm.iter().flat_map(|t| [*t; 5]).collect();
        let temperature = own.film.clone();
        let faces = channel.system.linearise(&channel.state).faces;
        let now = channel.films(&temperature);
        let carried = account(&channel.of(None), &now, &faces, &mut own).carried;
        (grid, carried)
    });
    for (k, [i, j]) in half.0.nodes().enumerate() {
        let other = whole.1[whole.0.index(i, j)];
        assert_relative_eq!(half.1[k], other, max_relative = 1e-8, epsilon = 1e-3);
    }
}
