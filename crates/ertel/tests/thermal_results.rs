//! Temperatures and heat as results: made-up temperatures whose figures are known by hand, and real ones computed
//! again from the written fields.

use crate::common;

use crate::common::text::read;
use approx::assert_relative_eq;
use common::{heated, near};
use ertel::case::Case;
use ertel::contact::{ContactKind, Scales, Symmetry};
use ertel::engine::NoObserver;
use ertel::params::{Method, ThermalParams};
use ertel::post::thermal::warnings;
use ertel::run::{problem, solve};
use ertel::solution::{Figure, LevelStats, Polynomials, Solution, Thermal};
use ertel::solve::figures::measure;
use ertel::solve::points::fields_in;
use ertel::solve::results::elements::elements;
use ertel::solve::results::thermal::thermal;
use ertel::solve::sequence::{Problem, StageSolution, solve_stages};
use ertel_fem::element::Lagrange;
use ertel_rheology::provenance::{TemperatureRange, celsius};

fn case(kind: ContactKind, load: f64, slide_to_roll_ratio: f64) -> Case {
    let mut case = heated(common::case(kind, load));
    case.motion.slide_to_roll_ratio = slide_to_roll_ratio;
    // The mesh as it is: one solution, one stage to compare it with.
    case.mesh.target_error = None;
    case.solver.error_estimate = false;
    case.thermal.as_mut().unwrap().field = true;
    case
}

fn scales(case: &Case) -> Scales {
    problem(case).scales
}

fn stages(case: &Case) -> (Problem, StageSolution, Vec<LevelStats>) {
    let problem = problem(case);
    let (solution, levels) = solve_stages(&problem, &mut NoObserver).expect("a solution");
    (problem, solution, levels)
}

fn thermal_of(
    solution: &StageSolution,
    problem: &Problem,
    levels: &[LevelStats],
    params: &ThermalParams,
) -> Thermal {
    let measured = measure(problem, solution, levels);
    thermal(solution, problem, levels, &measured, params).unwrap()
}

/// T = 350 + 10 X + 8 s + 12 (1 − 4 s²), K, in the film: at the plane 346 + 10 X, at the ball 354 + 10 X, at mid-film
/// 362 + 10 X, on average 358 + 10 X; at its largest where s = 1/12, 12 + 1/3 above 350 + 10 X.
#[test]
fn figures_of_made_up_temperatures() {
    let mut case = case(ContactKind::Line, 8e4, 0.0);
    case.thermal.as_mut().unwrap().profiles = vec![[0.5, 0.0]];
    let (problem, mut solution, levels) = stages(&case);
    let scales = scales(&case);
    let space = solution.discretisation.heat.clone().unwrap();
    let column = &space.column;
    let n = column.n();
    let film = column.film_range();
    for (node, point) in space.surface.points.iter().enumerate() {
        for (k, t) in solution.state.temperature[node * n..][..n]
            .iter_mut()
            .enumerate()
        {
            let s = match k {
                k if k < film.start => -0.5,
                k if k < film.end => column.film.points()[k - film.start],
                _ => 0.5,
            };
            *t = 350.0 + 10.0 * point[0] + 8.0 * s + 12.0 * (1.0 - 4.0 * s * s);
        }
    }
    let params = case.thermal.as_ref().unwrap();
    let found: Thermal = thermal_of(&solution, &problem, &levels, params);
    let outlet = solution.discretisation.contact.extents.outlet;
    // The largest temperature lies between two of the sampled heights: 48 (1/128)².
    assert_relative_eq!(
        found.film_maximum.value,
        362.0 + 1.0 / 3.0 + 10.0 * outlet,
        epsilon = 3e-3
    );
    let inlet = solution.discretisation.contact.extents.inlet;
    let lowest = 346.0 + 10.0 * inlet;
    assert_relative_eq!(found.film_lowest.value, lowest, epsilon = 1e-9);
    for (located, value) in [
        (&found.body_1_maximum, 346.0),
        (&found.body_2_maximum, 354.0),
    ] {
        assert_relative_eq!(located.value, value + 10.0 * outlet, epsilon = 1e-9);
        assert_relative_eq!(located.x, outlet * scales.length, max_relative = 1e-12);
    }
    // Relative errors of temperatures are relative to their rise above the inlet, 313.15 K.
    let measured = measure(&problem, &solution, &levels);
    for (figure, value) in [
        (Figure::FilmTemperatureMaximum, found.film_maximum.value),
        (Figure::TemperatureBody1Maximum, 346.0 + 10.0 * outlet),
        (Figure::TemperatureBody2Maximum, 354.0 + 10.0 * outlet),
    ] {
        let size = measured.figures.get(figure).unwrap().size;
        assert_relative_eq!(size, value - 313.15, epsilon = 1e-9);
    }
    // Quadrature points define the Hertz zone: its ends err by a share of a cell, times 10 K.
    for (mean, value) in [
        (found.film_mean.value, 358.0),
        (found.body_1_mean.value, 346.0),
        (found.body_2_mean.value, 354.0),
    ] {
        assert_relative_eq!(mean, value, epsilon = 0.1);
    }
    let line = &found.centreline;
    let x = solution.discretisation.contact.extents.inlet;
    for (values, value) in [
        (&line.mid, 362.0),
        (&line.mean, 358.0),
        (&line.body_1, 346.0),
        (&line.body_2, 354.0),
    ] {
        assert_relative_eq!(values[0], value + 10.0 * x, epsilon = 1e-9);
    }
    for (point, t) in (solution.discretisation.pressure.points.iter()).zip(&found.surface.mid) {
        assert_relative_eq!(*t, 362.0 + 10.0 * point[0], epsilon = 1e-9);
    }
    let profile = &found.profiles[0];
    for (z, t) in profile.z.iter().zip(&profile.temperature) {
        let s = z / profile.film_thickness - 0.5;
        let expected = 355.0 + 8.0 * s + 12.0 * (1.0 - 4.0 * s * s);
        assert_relative_eq!(*t, expected, epsilon = 1e-9);
    }
}

/// The polynomials that pictures sample are those of the solution, at any point of any element.
#[test]
fn pictures_have_the_fields_of_the_solution() {
    let ball = Case {
        thermal: None,
        ..case(ContactKind::Circular, 100.0, 0.0)
    };
    let mut line = case(ContactKind::Line, 8e4, 0.1);
    // Linear temperatures are drawn from recovered gradients.
    line.thermal.as_mut().unwrap().surface_order = 2;
    for case in [line, ball] {
        let (_, solution, _) = stages(&case);
        let (d, state) = (&solution.discretisation, &solution.state);
        let scales = scales(&case);
        let found = elements(&solution, &scales);
        let xi = match found.dim {
            1 => [0.37, 0.0, 0.0],
            _ => [0.37, 0.21, 0.0],
        };
        for element in 0..d.contact.n_elements() {
            let expected = fields_in(d, state, element, xi);
            let value = |field: &Polynomials| -> f64 {
                let lagrange = Lagrange::new(found.dim, field.order);
                let nodes = &field.values[element * lagrange.n_nodes()..];
                lagrange.values(xi).zip(nodes).map(|(n, v)| n * v).sum()
            };
            let [pressure, film] = [&found.pressure, &found.film_thickness].map(value);
            let expected_pressure = scales.pressure * expected.pressure;
            assert_relative_eq!(
                pressure,
                expected_pressure,
                epsilon = 1e-9 * scales.pressure
            );
            assert_relative_eq!(film, scales.film * expected.film, max_relative = 1e-9);
            if let Some(profile) = expected.temperature {
                let t = found.temperatures.as_ref().unwrap();
                let nodes = &d.heat.as_ref().unwrap().column.film;
                let values = &profile.temperature;
                let mid = nodes.through(values).at(0.0);
                assert_relative_eq!(value(&t.mid), mid, max_relative = 1e-9);
                assert_relative_eq!(value(&t.mean), nodes.mean(values), max_relative = 1e-9);
                assert_relative_eq!(value(&t.body_1), values[0], max_relative = 1e-9);
                assert_relative_eq!(value(&t.body_2), values[nodes.n() - 1], max_relative = 1e-9);
            }
        }
        assert_eq!(found.temperatures.is_some(), case.thermal.is_some());
    }
}

/// Heat of the bodies from the temperatures that are written: what the slices of each body carry out of the contact area,
/// ρcu∫(T − T_bulk) dz (W/m), by the rule of Gauss and Lobatto on each cubic element over the depth.
fn carried(case: &Case, solution: &Solution, region: u8) -> f64 {
    let field = solution.thermal.as_ref().unwrap().field.as_ref().unwrap();
    let outlet = solution.extents[1] * solution.hertz.half_width;
    let bulk = case.lubricant.temperature;
    // Quadrilaterals with a side at the outlet edge: points 1 and 2.
    let mut heights: Vec<[f64; 2]> = (field.cells.iter().zip(&field.region))
        .filter(|(_, r)| **r == region)
        .flat_map(|(cell, _)| [cell[1], cell[2]])
        .map(|i| i as usize)
        .filter(|i| (field.points[*i][0] / outlet - 1.0).abs() < 1e-9)
        .map(|i| [field.points[i][2], field.temperature[i] - bulk])
        .collect();
    heights.sort_by(|a, b| a[0].total_cmp(&b[0]));
    heights.dedup_by(|a, b| a[0] == b[0]);
    assert_eq!(heights.len() % 3, 1);
    let elements = heights.windows(4).step_by(3).map(|e| {
        let size = e[3][0] - e[0][0];
        size / 12.0 * (e[0][1] + 5.0 * e[1][1] + 5.0 * e[2][1] + e[3][1])
    });
    let (body, speed) = match region {
        0 => (&case.body_1, case.motion.body_1_speed()),
        _ => (&case.body_2, case.motion.body_2_speed()),
    };
    let capacity = body.density.unwrap()
        * body
            .heat_capacity
            .as_ref()
            .unwrap()
            .heat_capacity(0.0, bulk);
    capacity * speed * elements.sum::<f64>()
}

/// The heat made by shear is the friction power, computed by another rule; generated heat is carried off; what the plane of
/// glass carries off, it carries through the outlet section.
#[test]
fn heat_is_accounted_for() {
    let mut case = case(ContactKind::Line, 8e4, 0.4);
    // With a stage on the mesh of the isothermal one.
    case.solver.error_estimate = true;
    let solution = solve(&case, &mut NoObserver).unwrap();
    let thermal = solution.thermal.as_ref().unwrap();
    let b = &thermal.balance;
    near(b.shear.value, solution.traction.friction_power.value, 2e-3);
    let made = b.shear.value + b.compression.value;
    near(
        made,
        b.to_body_1.value + b.to_body_2.value + b.by_film.value,
        0.01,
    );
    // The error is of the heat made, compression with its sign; what compression and expansion make is a small part of the heat.
    let lost = made - b.to_body_1.value - b.to_body_2.value - b.by_film.value;
    assert_relative_eq!(b.error * b.shear.value, lost, max_relative = 0.1);
    // Across the film the velocity goes from one surface's to the other's.
    for profile in &thermal.profiles {
        let speeds = [case.motion.body_1_speed(), case.motion.body_2_speed()];
        let ends = [0, profile.velocity_x.len() - 1].map(|k| profile.velocity_x[k]);
        for (end, speed) in ends.into_iter().zip(speeds) {
            assert_relative_eq!(end, speed, max_relative = 1e-5);
        }
    }
    // The plane is drawn below the film, the ball above it.
    let heights = thermal.field.as_ref().unwrap().points.iter().map(|p| p[2]);
    let depth = case.thermal.as_ref().unwrap().depth * solution.hertz.half_width;
    let lowest = heights.clone().fold(f64::INFINITY, f64::min);
    assert_relative_eq!(lowest, -depth, max_relative = 1e-9);
    assert!(heights.fold(0.0, f64::max) > depth);
    // Glass conducts next to nothing out of the area; steel a little, to where it comes in.
    near(carried(&case, &solution, 0), b.to_body_1.value, 0.02);
    near(carried(&case, &solution, 2), b.to_body_2.value, 0.05);
    let reduction = thermal.reduction.unwrap();
    assert!(reduction.traction.unwrap().value > 0.0 && reduction.film_central.value > 0.0);
}

/// The same over both halves of a circular contact.
#[test]
fn heat_of_a_circular_contact_counts_both_halves() {
    let solution = solve(&case(ContactKind::Circular, 30.0, 0.4), &mut NoObserver).unwrap();
    let thermal = solution.thermal.as_ref().unwrap();
    let b = &thermal.balance;
    near(b.shear.value, solution.traction.friction_power.value, 5e-3);
    assert!(b.error.abs() < 0.01, "{}", b.error);
    // Every wedge has its lower triangle below the upper one, and volume.
    let field = thermal.field.as_ref().unwrap();
    for cell in &field.cells {
        let p = |i: usize| field.points[cell[i] as usize];
        let side = |i: usize| [0, 1, 2].map(|a: usize| p(i)[a] - p(0)[a]);
        let ([ax, ay, _], [bx, by, _]) = (side(1), side(2));
        // The normal of the first triangle points away from the second: down.
        assert!(ax * by - ay * bx < 0.0 && side(3)[2] > 0.0);
    }
}

/// A film that leaves the range of the data says so, once; one that stays inside does not.
#[test]
fn temperatures_beyond_the_data_are_reported() {
    let mut case = case(ContactKind::Line, 8e4, 0.4);
    let (problem, solution, levels) = stages(&case);
    let scales = scales(&case);
    let params = case.thermal.clone().unwrap();
    let found = thermal_of(&solution, &problem, &levels, &params);
    let top = found.film_maximum.value;
    let mut warned = |lowest: f64, highest: f64| {
        case.lubricant.temperature_ranges = vec![TemperatureRange {
            lowest,
            highest,
            basis: "measured".to_owned(),
        }];
        warnings(
            &found,
            &case.lubricant.temperature_ranges,
            &params,
            &scales,
            Symmetry::Full,
            [-4.5, 1.5, 3.0],
        )
    };
    assert!(warned(300.0, top + 0.1).is_empty());
    let end = celsius(top - 2.0);
    // Data of one temperature, that of the inlet, have no two ends.
    for (lowest, highest, words) in [
        (300.0, top - 2.0, format!("valid from 26.85 °C to {end} (")),
        (313.15, 313.15, "valid at 40 °C only (".to_owned()),
    ] {
        let [warning] = &warned(lowest, highest)[..] else {
            panic!("one warning")
        };
        assert!(
            warning.contains(&format!("reaches {:.1} °C at x/a", top - 273.15))
                && warning.contains(&words),
            "{warning}"
        );
    }
}

/// Oil of 60 °C between bodies of 75 °C: nothing cools it, the density does not change with the temperature, and so no film is colder than the oil, whatever the element of
/// its polynomials. Heat conducted from hot to cold alone would keep to that exactly; 0.3 K, a fiftieth of the difference, is allowed for convection of the second order.
#[test]
fn no_film_is_colder_than_the_inflow() {
    for (kind, method) in [
        ("line", Method::FiniteElements),
        ("line", Method::FiniteVolumes),
        ("circular", Method::FiniteVolumes),
    ] {
        let text = format!(
            "contact = {{ kind = \"{kind}\", radius = \"10 mm\", hertz_pressure = \"0.8 GPa\" }}\nbodies = {{ body_1 = \"steel\", body_2 = \"steel\" }}\n\
             motion = {{ entrainment_speed = \"5 m/s\", slide_to_roll_ratio = 0.2 }}\nthermal = {{ body_1_temperature = \"75 degC\", body_2_temperature = \"75 degC\" }}\n\
             mesh = {{ preset = \"coarse\" }}\n[lubricant]\ntemperature = \"60 degC\"\ndensity = {{ law = \"dowson-higginson\", rho_0 = \"860 kg/m^3\" }}\n\
             viscosity = {{ law = \"roelands\", mu_0 = \"20 mPa.s\", alpha = \"19 1/GPa\", beta = \"0.037 1/K\", reference_temperature = \"60 degC\" }}\n\
             thermal_conductivity = \"0.14 W/(m.K)\"\nheat_capacity = \"2000 J/(kg.K)\"\n"
        );
        let mut case = read(text);
        case.solver.method = Some(method);
        let solution = solve(&case, &mut NoObserver).unwrap();
        let lowest = &solution.thermal.as_ref().unwrap().film_lowest;
        println!("{kind} {method:?}: {lowest:?}");
        assert!(lowest.value > 333.15 - 0.3, "{kind} {method:?}: {lowest:?}");
    }
}
