//! Radii, temperatures and layers of oil that change, and cavities with conserved oil.

use crate::near::near;
use approx::assert_relative_eq;
use ertel_rheology::density::DensityLaw;
use ertel_rheology::viscosity::{TemperatureSlope, ViscosityLaw};

use super::{Films, Given, Params, line, mass_error, run, steady};
use crate::contact::{Contact, Inlet, OilLayer, Planar};
use crate::engine::{NoObserver, Problem};
use crate::film::FilmFluid;
use crate::transient::levels::held;
use crate::transient::scheme::{MEMORY, Weights};
use crate::transient::{Cavities, Conditions, Course, Speeds};
use crate::volumes::Plan;
use crate::volumes::contents::Arrival;
use crate::volumes::contents::Edges;
use crate::volumes::deflection::Deflection;
use crate::volumes::ending::Ends;
use crate::volumes::grid::Grid;
use crate::volumes::kernel::Kernel;
use crate::volumes::newton::{NewtonParams, newton};
use crate::volumes::preconditioner::pattern;
use crate::volumes::rows::RING;
use crate::volumes::storage::Storage;
use crate::volumes::system::{Balance, State, System};

fn params() -> Params {
    Params {
        tolerance: 1e-2,
        ..Params::default()
    }
}

/// Between two values from T = 1 to 3.
fn ramp(from: f64, to: f64) -> Course {
    Course::Table(vec![[1.0, from], [3.0, to]])
}

/// A problem with a layer of oil, m.
fn with_layer(mut problem: Problem<Plan>, thickness: f64) -> Problem<Plan> {
    let layer = OilLayer {
        thickness: thickness / problem.scales.film,
        lambda: problem.scales.lambda,
    };
    problem.shape = problem.shape.with_inlet(Inlet::Layer(layer));
    problem
}

/// Films long after a change are those of a steady solve with the new conditions.
fn assert_comes_to(films: &Films, steady: &Films, within: f64) {
    let (last, steady) = (films.0.last().unwrap(), steady.0[0]);
    for which in [1, 2] {
        assert_relative_eq!(last[which], steady[which], max_relative = within);
    }
}

/// A radius that falls to a half: the film comes to that of a steady contact of half the radius, whose scales are others.
#[test]
fn a_smaller_radius_is_come_to() {
    let conditions = Conditions {
        radius: ramp(1.0, 0.5),
        ..steady(10.0)
    };
    let (films, _) = run(line().problem(), &conditions, &params());
    let small = Given {
        contact: Contact::line(0.005, 1e5),
        ..line()
    };
    let (there, _) = run(small.problem(), &steady(0.01), &params());
    assert!(films.0[0][1] > 1.2 * there.0[0][1]);
    assert_comes_to(&films, &there, 3e-3);
    assert!(mass_error(&films) < 1e-2);
}

/// Oil that warms up by 20 K has the film of a steady contact with its viscosity there.
#[test]
fn warmer_oil_is_come_to() {
    let density = DensityLaw::dowson_higginson(870.0).unwrap();
    let mut viscosity = ViscosityLaw::roelands(0.04, 2.2e-8).unwrap();
    if let ViscosityLaw::Roelands(roelands) = &mut viscosity {
        roelands.thermal = Some(TemperatureSlope {
            reference_temperature: 313.15,
            beta: 0.04,
        });
    }
    let oil = |temperature: f64| {
        let mut problem = line().problem();
        problem.fluid = FilmFluid::new(&density, &viscosity, temperature, &problem.scales);
        problem
    };
    let conditions = Conditions {
        temperature: Some(ramp(313.15, 333.15)),
        ..steady(10.0)
    };
    let (films, _) = run(oil(313.15), &conditions, &params());
    let (there, _) = run(oil(333.15), &steady(0.01), &params());
    assert!(films.0[0][1] > 1.5 * there.0[0][1]);
    assert_comes_to(&films, &there, 3e-3);
}

/// Layers of oil on lines and circles: a layer that stays leaves the film as it is; one that gets thinner does so at the edge first, comes to the contact at the
/// entrainment speed and leaves the film of the thinner layer.
///
/// Theory: Time.
#[test]
fn a_thinner_layer_arrives() {
    let reach = 4.5;
    let [thick, thin] = [150e-9, 80e-9];
    let problem = || with_layer(line().problem(), thick);
    let (stays, _) = run(problem(), &steady(1.0), &params());
    assert_comes_to(&stays, &stays, 1e-3);
    let film = problem().scales.film;
    let conditions = Conditions {
        layer: Some(Course::Step {
            from: thick / film,
            to: thin / film,
            at: 0.5,
        }),
        instants: vec![0.5 + reach - 2.5],
        ..steady(14.0)
    };
    let (films, _) = run(problem(), &conditions, &params());
    let (there, _) = run(with_layer(line().problem(), thin), &steady(0.01), &params());
    // Before it has come near.
    near(films.at(conditions.instants[0], 1), films.0[0][1], 1e-3);
    assert!(films.0[0][1] > 1.3 * there.0[0][1]);
    assert_comes_to(&films, &there, 1e-2);
    assert!(mass_error(&films) < 1e-2, "{}", mass_error(&films));
}

#[test]
fn a_layer_on_a_ball_stays() {
    let given = Given {
        contact: Contact::circular(0.016, 100.0),
        speed: 0.8,
        target: 5e-2,
        ..line()
    };
    let problem = with_layer(given.problem(), 120e-9);
    let (films, info) = run(problem, &steady(0.5), &params());
    let (first, last) = (films.0[0], films.0.last().unwrap());
    for which in [1, 2] {
        assert_relative_eq!(last[which], first[which], max_relative = 2e-3);
    }
    assert_eq!(info.refused, 0);
    assert!(mass_error(&films) < 1e-2, "{}", mass_error(&films));
}

/// Where the motion turns, the cavity behind the contact comes in front of it. Filled up it makes a full film at once; with conserved oil the contact is starved until
/// oil from the edge has come.
#[test]
fn a_cavity_that_comes_back_starves() {
    let course = Course::Table(vec![[0.0, 1.0], [0.2, -1.0]]);
    let of = |cavities| {
        let mut problem = line().problem();
        problem.extents.outlet = 4.5;
        let conditions = Conditions {
            speeds: Speeds::Each([course.clone(), course.clone()]),
            cavities,
            instants: vec![1.7],
            ..steady(12.0)
        };
        run(problem, &conditions, &params()).0
    };
    let [refilled, conserved] = [Cavities::Refilled, Cavities::Conserved].map(of);
    let first = refilled.0[0];
    assert_relative_eq!(conserved.0[0][1], first[1], max_relative = 1e-9);
    assert!(conserved.at(1.7, 1) < 0.95 * refilled.at(1.7, 1));
    assert_comes_to(&conserved, &refilled, 1e-2);
    assert!(mass_error(&conserved) < 1e-2, "{}", mass_error(&conserved));
}

/// Parallel plates whose distance swings, h = ⅛ cos 4πt + ⅜ over 0 < x < 1, with p = 0.025 at both ends, (h³p')' = 2 ∂(hθ)/∂t: where the film breaks and closes again. While the cavity grows
/// its edge is √(p_0 h³/h'), and then 2 (h − h_r) x' = p_0 h³/x − h' x with the distance h_r at which the film broke there (the problem of Ausas, Jai and Buscaglia, J. Tribol. 131, 2009, 031702;
/// both integrated to 1e-8).
///
/// Theory: Time.
#[test]
fn a_cavity_between_swinging_plates_closes() {
    let cells = 1000;
    let h = 1.0 / f64::from(cells);
    let half = i64::from(cells) / 2 + RING as i64 - 1;
    let grid = Grid::of_line([-half, half], h);
    let n = grid.n_nodes();
    let mut problem = line().problem();
    problem.fluid = FilmFluid::new(
        &DensityLaw::constant(870.0).unwrap(),
        &ViscosityLaw::constant(0.04).unwrap(),
        313.15,
        &problem.scales,
    );
    let distance = |t: f64| 0.125 * (4.0 * std::f64::consts::PI * t).cos() + 0.375;
    let mut state = State {
        pressure: vec![0.025; n],
        oil: Vec::new(),
        separation: distance(0.0),
        wetted: vec![true; n],
        contents: vec![f64::INFINITY; n],
    };
    let mut system = System {
        // As good as rigid.
        convolution: std::sync::Arc::new(Deflection::new(
            &grid,
            Kernel::HalfSpace { compliance: 1e-9 },
        )),
        gap: vec![0.0; n],
        load: 0.0,
        beyond: None,
        edges: Edges::default(),
        fluid: problem.fluid.clone(),
        lambda: 2.0,
        entrainment: Planar::along_x(0.0),
        arrival: Arrival::FromEdges,
        warmth: Vec::new(),
        storage: None,
        balance: Balance::LOAD,
        rough: None,
        grid,
    };
    let fronts = [
        (0.27232806, 0.03085042),
        (0.31482583, 0.02300771),
        (0.37087714, 0.02468897),
        (0.44297966, 0.03116223),
        (0.51508223, 0.04162025),
        (0.58718478, 0.05835571),
        (0.65928733, 0.09947997),
    ];
    let mut times: Vec<f64> = vec![0.0];
    let mut stored = vec![held(&system, &state, &system.films(&state))];
    let params = NewtonParams {
        ends: Ends::of(1e-4),
        // At once half of the plates: nodes leave the film one after the other.
        max_iterations: 500,
        ..NewtonParams::default()
    };
    let step = 5e-4;
    for (to, front) in fronts {
        while times[0] < to {
            let time = (times[0] + step).min(to);
            times.insert(0, time);
            times.truncate(MEMORY + 1);
            let weights = Weights::new(&times);
            system.storage = Some(Storage {
                rate: weights.rate(),
                past: weights.past(stored.iter()),
            });
            system.balance = Balance {
                load: 0.0,
                separation: 1.0,
                given: -distance(time),
            };
            let pattern = pattern(&system).unwrap();
            let info = newton(
                &system,
                &pattern,
                &mut state,
                &params,
                (0, 1.0),
                &mut NoObserver,
            );
            assert!(info.converged, "{time}");
            stored.insert(0, held(&system, &state, &system.films(&state)));
            stored.truncate(MEMORY);
        }
        let broken = state
            .contents
            .iter()
            .position(|content| content.is_finite());
        let found = h * (broken.unwrap() - RING + 1) as f64;
        assert!((found - front).abs() < 1.5 * h, "{to}: {found} {front}");
    }
}
