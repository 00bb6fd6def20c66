//! Figures and fields that are written, against laws and sums evaluated here from the state of a small contact.

use crate::common;

use approx::assert_relative_eq;
use ertel::contact::ContactKind;
use ertel::engine::NoObserver;
use ertel::params::ElasticModel;
use ertel::run::problem;
use ertel::solve::figures::measure;
use ertel::solve::newton_level::FilmModel;
use ertel::solve::points::fields_at;
use ertel::solve::results::fields::{body, centreline, surface};
use ertel::solve::results::summary::summarise;
use ertel::solve::sequence::solve_stages;

/// A Newtonian circular contact between sliding surfaces, on an equivalent body.
#[test]
fn figures_and_fields_of_a_small_contact() {
    let mut case = common::case(ContactKind::Circular, 10.0);
    // The ball slower than the plane: stresses are negative, rates are not.
    case.motion.slide_to_roll_ratio = -0.3;
    case.mesh.hertz_size = 0.4;
    case.mesh.constriction_size = 0.3;
    case.mesh.edge_size = 1.0;
    case.mesh.pressure_order = 2;
    case.mesh.elastic_order = Some(1);
    case.mesh.target_error = None;
    case.solver.error_estimate = false;
    case.solver.elasticity = Some(ElasticModel::Equivalent);
    let problem = problem(&case);
    let (solution, levels) = solve_stages(&problem, &mut NoObserver).expect("a solution");
    let (d, state, scales) = (&solution.discretisation, &solution.state, &problem.scales);
    let model = FilmModel {
        fluid: problem.fluid.clone(),
        constants: solution.stage.constants,
    };
    let measured = measure(&problem, &solution, &levels);
    let summary = summarise(&solution, &measured, &model, scales);
    // The inflow minus the side leakage passes the middle: the mesh is coarse.
    println!("film balance {:.1e}", summary.film_balance_error);
    assert!(summary.film_balance_error.abs() < 0.02);
    assert!(summary.load_balance_error < 1e-8);
    let h_0 = state.rigid_separation * case.contact.radius.recip() * scales.length.powi(2);
    assert_relative_eq!(summary.rigid_separation, h_0, max_relative = 1e-12);
    assert!(summary.pressure_minimum < 0.0 && summary.pressure_minimum > -0.01 * scales.pressure);

    // Newtonian: τ = μΔu/h ± (h/2)∂p/∂x, rates τ/μ
    let laws = |p: f64| {
        let mu = (case.lubricant.viscosity)
            .ln_viscosity(p.max(0.0), case.lubricant.temperature)
            .exp();
        let rho = (case.lubricant.density).density(p.max(0.0), case.lubricant.temperature);
        (mu, rho)
    };
    let line = centreline(&solution, &problem.fluid, scales);
    let field = surface(&solution, &problem.fluid, scales);
    let slide = -0.3 * case.motion.entrainment_speed;
    let pressed = |p: f64| p > 1e-3 * scales.pressure;
    for (i, p) in line
        .pressure
        .iter()
        .enumerate()
        .filter(|(_, p)| pressed(**p))
    {
        let (mu, rho) = laws(*p);
        assert_relative_eq!(line.viscosity[i], mu, max_relative = 1e-9);
        assert_relative_eq!(line.density[i], rho, max_relative = 1e-9);
        let stress = mu * slide / line.film_thickness[i];
        let shear = &line.shear;
        assert_relative_eq!(shear.stress_mid[i], stress, max_relative = 1e-9);
        assert_relative_eq!(shear.rate_mid[i], stress.abs() / mu, max_relative = 1e-9);
        let x = line.x[i] / scales.length;
        let slope = fields_at(d, state, [x, 0.0]).unwrap().pressure_gradient[0];
        // Of two elements at a node either may be found.
        let inside = (0..d.contact.surface.n_vertices())
            .all(|v| (d.contact.surface.vertices[v][0] - x).abs() > 1e-6);
        if inside {
            let half = 0.5 * line.film_thickness[i] * slope * scales.pressure / scales.length;
            let off = 1e-6 * (stress.abs() + half.abs());
            assert_relative_eq!(shear.stress_body_1[i], stress - half, epsilon = off);
            assert_relative_eq!(shear.stress_body_2[i], stress + half, epsilon = off);
        }
    }
    for (i, p) in field
        .pressure
        .iter()
        .enumerate()
        .filter(|(_, p)| pressed(**p))
    {
        let (mu, rho) = laws(*p);
        assert_relative_eq!(field.viscosity[i], mu, max_relative = 1e-9);
        assert_relative_eq!(field.density[i], rho, max_relative = 1e-9);
    }
    // The cells cover the (half) contact area once.
    let area: f64 = (field.cells.iter())
        .map(|cell| {
            let [a, b, c] = cell.map(|i| field.points[i as usize]);
            0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]))
        })
        .sum();
    let e = &d.contact.extents;
    let whole = (e.outlet - e.inlet) * e.side * scales.length.powi(2);
    assert_relative_eq!(area, whole, max_relative = 1e-10);

    // On the contact area the body sinks, along its normal z, by the deflection.
    let body = body(&solution, scales).unwrap().expect("a body");
    let mut n_compared = 0;
    for (point, u) in body.points.iter().zip(&body.displacement) {
        let [x, y] = [point[0], point[1]].map(|x| x / scales.length);
        let on_top = point[2].abs() < 1e-9 * scales.length;
        if !on_top || x.hypot(y) > 1.0 {
            continue;
        }
        let fields = fields_at(d, state, [x, y]).unwrap();
        let deflection = fields.deflection * scales.film;
        assert_relative_eq!(-u[2], deflection, max_relative = 1e-6);
        n_compared += 1;
    }
    assert!(n_compared > 5, "{n_compared}");
}
