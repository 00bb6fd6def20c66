//! The divergence of the flow through a film against differences of the flow itself, along fields written out here.

use crate::common;

use approx::assert_relative_eq;
use common::rigid::heated_case;
use ertel::contact::ContactKind;
use ertel::film::cross_film::CrossFilm;
use ertel::film::{FilmFluid, TemperatureProfile};
use ertel::forms::flow::{
    Flow, PointSliding, PointState, Properties, generalized, pressure_stress, sliding_stress,
    thermal,
};
use ertel::run::problem;
use ertel_rheology::shear::{Carreau, ShearLaw, ShearThinning, StressLimit};

const LAMBDA: f64 = 0.02;

/// P and H with all their derivatives at (x, y).
fn state([x, y]: [f64; 2]) -> PointState<f64> {
    PointState {
        pressure: 0.4 + 0.3 * x - 0.2 * y + 0.15 * x * x + 0.1 * x * y - 0.25 * y * y,
        pressure_gradient: [0.3 + 0.3 * x + 0.1 * y, -0.2 + 0.1 * x - 0.5 * y],
        pressure_curvature: [0.3, 0.1, -0.5],
        film: 0.2 + 0.05 * x - 0.03 * y + 0.02 * x * x + 0.01 * x * y,
        film_gradient: [0.05 + 0.04 * x + 0.01 * y, -0.03 + 0.01 * x],
        pressure_unresolved: 0.0,
    }
}

/// T across the film at (x, y), K, and its slopes.
fn temperature(nodes: &[f64], [x, y]: [f64; 2]) -> TemperatureProfile {
    let mut profile = TemperatureProfile::default();
    for (m, s) in nodes.iter().enumerate() {
        let slopes = [40.0 - 30.0 * s, -25.0 + 50.0 * s * s];
        profile.temperature[m] =
            330.0 + 12.0 * s + 60.0 * (0.25 - s * s) + slopes[0] * x + slopes[1] * y;
        (profile.slopes[0][m], profile.slopes[1][m]) = (slopes[0], slopes[1]);
    }
    profile
}

/// The flow at (x, y), the temperature and the sliding being those at `place`.
fn flow(fluid: &FilmFluid, state: &PointState<f64>, place: [f64; 2]) -> (Flow<f64>, f64) {
    let rule = &mut CrossFilm::default();
    let p = state.pressure;
    let slide = PointSliding::new(fluid.slide(), place);
    let Some(nodes) = fluid.nodes() else {
        let m = Properties::around(p, &fluid.at(p));
        let omega = sliding_stress(state, &m, slide.value);
        let closure = fluid.close(p, pressure_stress(state), omega, rule);
        let flow = generalized(state, &m, LAMBDA, &slide, &closure);
        return (flow, m.density);
    };
    let here = fluid.thermal(p, &temperature(nodes.points(), place));
    let m = Properties::around(p, &here.point());
    let omega = sliding_stress(state, &m, slide.value);
    let closure = fluid.close_thermal(p, &here, pressure_stress(state), omega, rule);
    let flow = thermal(state, &m, LAMBDA, &slide, &closure, &here.density);
    (flow, m.density)
}

/// ∂Q_x/∂X + ∂Q_y/∂Y, ∂Q_x/∂P_x and H ∂ρ̄/∂X at a fixed P by central differences: of steps of 1e-4, with flows to 1e-10, 1e-5 of them.
///
/// Habchi 2008, eqs. 4.9 and 4.11.
#[test]
fn divergence_is_that_of_the_flow() {
    let carreau = ShearLaw::Carreau(Carreau::new(2e5, 0.5, 2.2, 0.05).unwrap());
    let limit = StressLimit::new(4e6, 0.03).unwrap();
    let mut limited = ShearThinning::of(carreau.clone());
    limited.limit = Some(limit);
    for (heated, skewed) in [(false, false), (true, false), (false, true), (true, true)] {
        for law in [ShearThinning::of(carreau.clone()), limited.clone()] {
            let mut case = heated_case(ContactKind::Circular, 8);
            case.motion.slide_to_roll_ratio = 0.3;
            if skewed {
                case.motion.slide_to_roll_ratio_across = -0.2;
                case.motion.spin = [900.0, -1500.0];
            }
            case.lubricant.shear_thinning = Some(law);
            if !heated {
                case.thermal = None;
            }
            let fluid = problem(&case).fluid;
            assert_eq!(fluid.nodes().is_some(), heated);
            let at = |point: [f64; 2]| flow(&fluid, &state(point), point).0.flux;
            let step = 1e-4;
            for point in [[0.0, 0.0], [0.2, -0.3]] {
                let [x, y] = point;
                let (found, _) = flow(&fluid, &state(point), point);
                let difference = (at([x + step, y])[0] - at([x - step, y])[0]
                    + at([x, y + step])[1]
                    - at([x, y - step])[1])
                    / (2.0 * step);
                let size = found.flux[0].hypot(found.flux[1]);
                println!("{heated}: {} {difference}, flow {size}", found.divergence);
                assert_relative_eq!(found.divergence, difference, epsilon = 1e-5 * size);

                let steeper = |by: f64| {
                    let mut s = state(point);
                    s.pressure_gradient[0] += by;
                    flow(&fluid, &s, point).0.flux[0]
                };
                let diffusivity = (steeper(step) - steeper(-step)) / (2.0 * step);
                assert_relative_eq!(found.diffusivity, diffusivity, max_relative = 1e-5);

                let density = |x: f64, y: f64| flow(&fluid, &state(point), [x, y]).1;
                let along = (density(x + step, y) - density(x - step, y)) / (2.0 * step);
                let across = (density(x, y + step) - density(x, y - step)) / (2.0 * step);
                for (found, by) in found.drift.into_iter().zip([along, across]) {
                    assert_relative_eq!(found, state(point).film * by, epsilon = 1e-8);
                    assert_eq!(found != 0.0, heated);
                }
            }
        }
    }
}
