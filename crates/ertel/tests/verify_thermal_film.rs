//! Properties of the thermal film by their laws, and bodies whose temperatures and heat are known in closed form.

use crate::common;

use approx::assert_relative_eq;
use common::rigid::{EXTENTS, heated_case, problem_without_expansion, rigid, solve};
use ertel::contact::{ContactKind, Planar};
use ertel::film::MOST_NODES;
use ertel::film::cross_film::CrossFilm;
use ertel::forms::energy::{FilmPlace, Layer, film_column};
use ertel::run::problem;
use ertel::solve::discretisation::Extents;
use ertel::solve::heat::balance::heat_balance;
use ertel::solve::heat::column::Column;
use ertel_rheology::conductivity::LarssonAndersson;
use ertel_rheology::property::LinearFactor;
use ertel_rheology::{ConductivityLaw, HeatCapacityLaw};

/// k/h, ρch u_m/a and c ρ_R h_R u_m/a with laws written out here; below ambient pressure those of p = 0. No slide and no gradient of the
/// pressure: the film flows with the bodies.
#[test]
fn film_properties_follow_pressure_and_temperature() {
    let mut case = heated_case(ContactKind::Line, 6);
    case.lubricant.thermal_conductivity = Some(ConductivityLaw::LarssonAndersson(
        LarssonAndersson::new(0.14, 1.7e-9, 0.7e-9).unwrap(),
    ));
    let factor = LinearFactor::new(313.15, 1e-3, 0.3e-9).unwrap();
    case.lubricant.heat_capacity = Some(HeatCapacityLaw::linear(2000.0, factor).unwrap());
    let problem = problem(&case);
    let heat = problem.heat.as_ref().unwrap();
    let heights = &problem.plan.heat.as_ref().unwrap().column.heights;
    for pressure in [0.5, -0.3] {
        let mut place = FilmPlace {
            pressure_rate: 0.0,
            at: [0.0; 2],
            pressure,
            pressure_gradient: [0.0; 2],
            film: 0.3,
            filling: 1.0,
            temperature: [0.0; MOST_NODES],
            held_conductance: None,
        };
        let nodes = problem.fluid.nodes().unwrap().points();
        for (t, s) in place.temperature.iter_mut().zip(nodes) {
            *t = 340.0 + 20.0 * s;
        }
        let rule = &mut CrossFilm::default();
        let column = film_column(&problem.fluid, heat, heights, &place, rule);
        let p = f64::max(pressure, 0.0) * heat.pressure;
        let h = 0.3 * heat.film;
        for (point, s) in column.heights.iter().zip(heights.points()) {
            let t = 340.0 + 20.0 * s;
            let k = 0.14 * (1.0 + 1.7e-9 * p / (1.0 + 0.7e-9 * p));
            let c = 2000.0 * (1.0 + 1e-3 * (t - 313.15) + 0.3e-9 * p);
            let rho = 870.0 * (1.0 + 0.6e-9 * p / (1.0 + 1.7e-9 * p) - 7e-4 * (t - 313.15));
            let rate = heat.entrainment_speed / heat.length;
            assert_relative_eq!(point.temperature, t, max_relative = 1e-12);
            assert_relative_eq!(point.conduction, k / h, max_relative = 1e-12);
            // Below ambient pressure the density goes on falling by up to 5 %.
            let off = if pressure < 0.0 { 0.05 } else { 1e-9 };
            assert_relative_eq!(point.capacity, rho * c * h * rate, max_relative = off);
            let lift = c * heat.density * heat.film * rate;
            assert_relative_eq!(point.lift_capacity, lift, max_relative = 1e-12);
            assert_relative_eq!(point.velocity[0], 1.0, max_relative = 1e-12);
        }
    }
}

/// At a slide-to-roll ratio of ±2 one body is at rest. Nothing carries heat out of it through the sides: both stay at its
/// bulk temperature. The other one's temperature is prescribed where it comes in, and free where it leaves.
#[test]
fn a_body_at_rest_is_held_at_its_temperature() {
    for (slide, at_rest) in [(2.0, 0), (-2.0, 1)] {
        let mut case = heated_case(ContactKind::Line, 4);
        case.motion.slide_to_roll_ratio = slide;
        let params = case.thermal.as_mut().unwrap();
        (params.body_1_temperature, params.body_2_temperature) = (Some(303.0), Some(320.0));
        let problem = problem(&case);
        let heat = problem.heat.as_ref().unwrap();
        assert!(heat.bodies[at_rest].velocity.is_zero());
        let column = Column::new(4, 3, 1.0, [0.3, 0.3]);
        let (d, mut state) = rigid(ContactKind::Line, &EXTENTS, 0.25, 1, column, heat);
        let space = d.heat.as_ref().unwrap();
        let n = space.column.n();
        let source = |_: [f64; 2], layer: Layer| match layer {
            Layer::Film(_) => 1e7,
            _ => 0.0,
        };
        solve(&d, &problem.fluid, heat, &mut state, Some(&source));
        for (body, bulk) in [(0, 303.0), (1, 320.0)] {
            // Hottest of the body at the inlet, at the outlet and in between
            let mut rises = [0.0_f64; 3];
            for (node, point) in space.surface.points.iter().enumerate() {
                let place = match point[0] {
                    x if x < EXTENTS.inlet + 1e-9 => 0,
                    x if x > EXTENTS.outlet - 1e-9 => 1,
                    _ => 2,
                };
                for t in &state.temperature[node * n..][space.column.body_range(body)] {
                    rises[place] = rises[place].max((t - bulk).abs());
                }
            }
            let [inlet, outlet, between] = rises;
            assert!(between > 1.0 && inlet < 1e-9, "{slide} {body}: {rises:?}");
            assert_eq!(outlet < 1e-9, body == at_rest, "{slide} {body}: {rises:?}");
        }
    }
}

/// Bodies at rest that conduct without resistance, the ball 10 K hotter: heat flows straight through the film, q = kΔT/h with
/// h = h_R(½ + X²/2), and is conducted out of the plane and into the ball at their held temperatures:
/// ∫q dx = kΔT a/h_R · 4 atan 6. What passes to walls at the edges, which are held themselves, and the resistance of the bodies
/// are about a thousandth.
#[test]
fn heat_is_conducted_out_of_bodies_at_rest() {
    let mut case = heated_case(ContactKind::Line, 4);
    let params = case.thermal.as_mut().unwrap();
    (params.body_1_temperature, params.body_2_temperature) = (Some(310.0), Some(320.0));
    for body in [&mut case.body_1, &mut case.body_2] {
        body.thermal_conductivity = Some(ConductivityLaw::constant(1e6).unwrap());
    }
    let problem = problem_without_expansion(&case);
    let mut heat = problem.heat.as_ref().unwrap().clone();
    for body in &mut heat.bodies {
        body.velocity = Planar::default();
    }
    let extents = Extents {
        inlet: -6.0,
        outlet: 6.0,
        ..EXTENTS
    };
    let column = Column::new(4, 3, 1.0, [0.3, 0.3]);
    let (d, mut state) = rigid(ContactKind::Line, &extents, 0.1, 1, column, &heat);
    solve(&d, &problem.fluid, &heat, &mut state, None);
    let balance = heat_balance(&d, &state, &problem.fluid, &heat, &problem.scales);
    let through = 0.14 * 10.0 * heat.length / heat.film * 4.0 * 6.0_f64.atan();
    assert_relative_eq!(balance.to_bodies[0], through, max_relative = 5e-3);
    assert_relative_eq!(balance.to_bodies[1], -through, max_relative = 5e-3);
    assert!(balance.shear.abs() + balance.compression.abs() < 1e-9 * through);
}
