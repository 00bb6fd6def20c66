//! Wear against closed forms, by hand, and against itself with other steps.

use approx::assert_relative_eq;
use ertel_rheology::density::DensityLaw;
use ertel_rheology::viscosity::ViscosityLaw;

use super::depth::{Depth, Lattice, Pressures};
use super::*;
use crate::contact::gap::Body;
use crate::contact::{Contact, Hertz, Material, Motion, Scales, Shape};
use crate::elastic::Elasticity;
use crate::engine::{Extents, NoObserver, Problem};
use crate::film::FilmFluid;
use crate::mixed::{Flow, Rough};
use crate::solution::Figure;
use crate::volumes::{FiniteVolumes, Plan};

const MODULUS: f64 = 230.769_230_77e9;

/// A steel contact with asperities of the rms height σ in m and κ in Pa, body 1 at rest, lubricated with 40 mPa s.
fn contact(contact: &Contact, speed: f64, sigma: f64, kappa: f64, grids: usize) -> Problem<Plan> {
    let motion = Motion::straight(speed, 2.0);
    let hertz = Hertz::new(contact, MODULUS);
    let shape = Shape::new(contact, &hertz, &motion);
    let scales = Scales::new((contact, &hertz, &shape), &motion, 0.04, 870.0);
    let steel = Material {
        youngs_modulus: 0.91 * MODULUS,
        poissons_ratio: 0.3,
    };
    let (density, viscosity) = (
        DensityLaw::constant(870.0).unwrap(),
        ViscosityLaw::constant(0.04).unwrap(),
    );
    let sliding = motion.sliding(scales.length);
    let mut rough = Rough::greenwood_tripp(
        sigma / scales.film,
        kappa / scales.pressure,
        Flow::AverageGap,
    );
    rough.boundary_friction = Some(0.1);
    let mut plan = Plan::new(1e-9, 400_000);
    plan.most_grids = grids;
    Problem {
        shape,
        extents: Extents {
            inlet: -9.0,
            outlet: 5.0,
            side: 9.0,
            body_width: 60.0,
            body_depth: 60.0,
        },
        reach: [9.0, 9.0],
        elasticity: Elasticity::half_space(1, &[steel.over(scales.elastic_stress); 2]),
        fluid: FilmFluid::new(&density, &viscosity, 313.15, &scales)
            .with_shear(None, &sliding, &scales),
        friction: None,
        entrainment: motion.entrainment(scales.length),
        load: scales.load,
        start_film: 0.12,
        heat: None,
        rough: Some(rough),
        scales,
        plan,
    }
}

fn wearing(specific: f64, track_length: Option<f64>) -> WearingBody {
    WearingBody {
        coefficient: 2e9 * specific,
        hardness: 2e9,
        track_length,
    }
}

/// Body 1 at rest and body 2 on a track of 50 mm: a line in mixed lubrication, 20 kN/m on 20 mm.
fn line(step: f64, coefficient: f64) -> (Problem<Plan>, WearParams) {
    let problem = contact(&Contact::line(0.02, 20e3), 0.1, 0.25e-6, 196.9e6, 8);
    let params = WearParams {
        bodies: [
            Some(wearing(coefficient, None)),
            Some(wearing(3.0 * coefficient, Some(0.05))),
        ],
        distance: 30.0,
        step,
        max_steps: 100,
    };
    (problem, params)
}

/// By hand: rows of 0 1 0, 2 4 2, 0 1 0 at the distances 0.5 and 0.25, worn by twice their pressures; a track of 10 half-widths loses 2 · 0.5/10 of the sums 1, 8, 1.
#[test]
fn scar_and_track_by_hand() {
    let lattice = Lattice {
        spacing: [0.5, 0.25],
        half: [1, 1],
    };
    let pressures = Pressures {
        lattice,
        values: vec![0.0, 1.0, 0.0, 2.0, 4.0, 2.0, 0.0, 1.0, 0.0],
        load: 1.25,
    };
    let wide = Lattice {
        half: [30, 40],
        ..lattice
    };
    let shape = contact(&Contact::circular(0.005, 10.0), 0.1, 2e-7, 1e9, 4).shape;
    let worn = |track| {
        let mut depth = Depth::none(lattice, track);
        depth.add(&pressures.rates(track), 2.0);
        depth.on(wide)
    };
    let at = |depth: &Depth, place| match depth.term(Body::First, &shape) {
        Some(term) => term.at(place).value,
        None => 0.0,
    };
    let scar = worn(None);
    for (place, depth) in [
        ([0.0, 0.0], 8.0),
        ([0.5, 0.0], 4.0),
        ([0.0, -0.25], 2.0),
        ([0.5, 0.25], 0.0),
        ([0.0, 0.75], 0.0),
    ] {
        assert_relative_eq!(at(&scar, place), depth, epsilon = 1e-12);
    }
    // Σ 2 p Δx Δy = 2 · 10 · 0.125.
    assert_relative_eq!(scar.volume(), 2.5, max_relative = 1e-13);
    assert_eq!(scar.size(), [Some(1.0), Some(0.5)]);
    let track = worn(Some(10.0));
    for (y, depth) in [(0.0, 0.8), (0.25, 0.1), (-0.25, 0.1), (0.5, 0.0)] {
        for x in [-7.0, 0.0, 0.3] {
            assert_relative_eq!(at(&track, [x, y]), depth, epsilon = 1e-12);
        }
    }
    assert_relative_eq!(track.volume(), 2.5, max_relative = 1e-13);
    assert_eq!(track.size(), [None, Some(0.5)]);
    assert!(track.profile(false).is_empty());
    assert_relative_eq!(track.profile(true)[40][1], 0.8);
}

/// Each body loses k/H ∫ W_a ds, from the loads of the asperities before each step, as depth of its surface; the track of a line loses V/L everywhere and changes no gap.
#[test]
fn volume_is_conserved() {
    let (mut line, of_line) = line(0.3, 1e-16);
    let ball = Contact::circular(0.005, 10.0);
    let mut circle = contact(&ball, 0.01, 0.2e-6, 1e9, 4);
    let of_circle = WearParams {
        distance: 2.0,
        ..of_line.clone()
    };
    for (problem, params, load) in [(&mut line, of_line, 20e3), (&mut circle, of_circle, 10.0)] {
        let n_terms = problem.shape.gap.terms.len();
        let is_line = problem.shape.is_line();
        let worn = run_in(problem, &params, &mut NoObserver).unwrap();
        assert!(worn.wear.steps > 2);
        let steps = worn.wear.course.windows(2);
        let sum: f64 = (steps)
            .map(|pair| {
                let distance = pair[1].sliding_distance - pair[0].sliding_distance;
                pair[0].asperity_load_share * load * distance
            })
            .sum();
        for (n, body) in worn.wear.bodies() {
            let own = params.bodies[n - 1].unwrap();
            let volume = own.coefficient / own.hardness * sum;
            assert_relative_eq!(body.volume.value, volume, max_relative = 1e-12);
            assert!(
                body.volume_deviation.abs() < 1e-12,
                "{}",
                body.volume_deviation
            );
        }
        let track = worn.wear.body_2.unwrap();
        match is_line {
            true => assert_relative_eq!(
                track.depth.value,
                track.volume.value / 0.05,
                max_relative = 1e-12
            ),
            false => assert!(track.length.is_none() && track.width.is_some()),
        }
        let expected = n_terms + if is_line { 1 } else { 2 };
        assert_eq!(problem.shape.gap.terms.len(), expected);
    }
}

/// Without wear the contact is what it was, to the last bit.
#[test]
fn no_wear_changes_nothing() {
    let (mut problem, params) = line(0.3, 0.0);
    let before = FiniteVolumes.solve(&problem, &mut NoObserver).unwrap();
    let worn = run_in(&mut problem, &params, &mut NoObserver).unwrap();
    assert_eq!(worn.wear.steps, 1);
    assert_eq!(worn.wear.body_1.unwrap().volume.value, 0.0);
    let bits = |found: &crate::volumes::Volumes| -> Vec<u64> {
        let states = found.levels.iter().map(|level| &level.state);
        states
            .flat_map(|state| state.pressure.iter().chain([&state.separation]))
            .map(|p| p.to_bits())
            .collect()
    };
    assert_eq!(bits(&worn.solved), bits(&before));
    let before = before.measured(&problem);
    for figure in Figure::ALL {
        assert_eq!(worn.measured.find(figure), before.find(figure));
    }
}

/// Steps of half the depth change depths, volumes, films and shares by no more than the error bars.
#[test]
fn steps_are_within_their_bars() {
    let of = |step: f64| {
        let (mut problem, params) = line(step, 1e-16);
        run_in(&mut problem, &params, &mut NoObserver).unwrap()
    };
    let [coarse, fine] = [0.2, 0.1].map(of);
    assert!(fine.wear.steps > coarse.wear.steps);
    for (one, two) in [
        (&coarse.wear.body_1, &fine.wear.body_1),
        (&coarse.wear.body_2, &fine.wear.body_2),
    ] {
        let [one, two] = [one, two].map(|body| body.as_ref().unwrap());
        for [a, b] in [[one.depth, two.depth], [one.volume, two.volume]] {
            let bar = a.error.unwrap();
            assert!((a.value - b.value).abs() <= bar, "{a:?} {b:?}");
            assert!(bar < 0.1 * a.value, "{a:?}");
        }
    }
    for figure in [
        Figure::FilmCentral,
        Figure::FilmMinimum,
        Figure::AsperityLoadShare,
        Figure::FrictionTotal,
    ] {
        let [a, b] = [&coarse, &fine].map(|worn| worn.measured.find(figure).unwrap());
        assert!((a.value - b.value).abs() <= a.error.unwrap(), "{figure:?}");
    }
}

/// The ball of `wear_archard_ball.csv` (k/H 1e-16 m²/N, 10 N, R 5 mm, 100 m): V = 1e-13 m³, scar radius 158.84 µm and depth 2.523 µm of a rigid cap, V = πa⁴/(4R). On an elastic
/// half-space a uniform pressure W/(πa²) presses the middle of the scar in by (2 − 4/π) W/(πaE*) more than its rim, and takes 4aW/(3πE*) off the volume of the cap: by mpmath 161.15 µm and 2.472 µm.
#[test]
fn scar_of_a_ball() {
    let ball = Contact::circular(0.005, 10.0);
    let mut problem = contact(&ball, 1e-9, 0.3e-6, 1e9, 4);
    let params = WearParams {
        bodies: [Some(wearing(1e-16, None)), None],
        distance: 100.0,
        step: 0.4,
        max_steps: 100,
    };
    let worn = run_in(&mut problem, &params, &mut NoObserver).unwrap();
    let body = worn.wear.body_1.unwrap();
    assert_relative_eq!(body.volume.value, 1e-13, max_relative = 1e-5);
    assert_relative_eq!(body.depth.value, 2.472e-6, max_relative = 0.015);
    assert_relative_eq!(body.depth.value, 2.523e-6, max_relative = 0.04);
    for size in [body.length, body.width] {
        assert_relative_eq!(0.5 * size.unwrap(), 161.15e-6, max_relative = 0.02);
    }
    let [first, last] = [0, worn.wear.steps].map(|i| worn.wear.course[i]);
    // Uniform: W/(πa²) = 123 MPa.
    assert!(first.pressure_maximum > 7e8 && last.pressure_maximum < 1.4e8);
}
