//! Oil and asperities of rough surfaces in one system, against closed forms, another solver, and differences.

use approx::assert_relative_eq;

use super::super::ending::Ends;
use super::super::newton::NewtonParams;
use super::*;
use crate::mixed::{Flow, Rough};

/// Surfaces in the variables of the film equation.
fn surfaces(rms_height: f64, stiffness: f64, flow: Flow) -> Rough {
    Rough::greenwood_tripp(rms_height, stiffness, flow)
}

/// A contact with an oil of constant density.
fn contact(contact: &Contact, modulus: f64, viscosity: &ViscosityLaw, speed: f64) -> Problem<Plan> {
    let motion = Motion::straight(speed, 0.0);
    let material = Material {
        youngs_modulus: 0.91 * modulus,
        poissons_ratio: 0.3,
    };
    let hertz = Hertz::new(contact, modulus);
    let ambient = viscosity.viscosity(0.0, 313.15);
    let shape = Shape::new(contact, &hertz, &motion);
    let scales = Scales::new((contact, &hertz, &shape), &motion, ambient, 870.0);
    let density = DensityLaw::constant(870.0).unwrap();
    let mut problem = problem_of(contact, &motion, 1e-3);
    problem.shape = shape;
    problem.elasticity = Elasticity::half_space(1, &[material.over(scales.elastic_stress); 2]);
    problem.fluid = FilmFluid::new(&density, viscosity, 313.15, &scales).with_shear(
        None,
        &motion.sliding(scales.length),
        &scales,
    );
    problem.entrainment = motion.entrainment(scales.length);
    problem.load = scales.load;
    problem.scales = scales;
    problem
}

/// The linearised balances with asperities against differences: of points and lines, where the film is broken, too.
#[test]
fn jacobian_of_rough_surfaces_against_differences() {
    for flow in [Flow::AverageGap, Flow::Distance, Flow::PatirCheng] {
        let spin = Planar {
            centre: [1.0, 0.0],
            spin: 0.8,
        };
        for (half, entrainment) in [(true, Planar::along_x(1.0)), (false, spin)] {
            let (mut system, mut state) = system(half, entrainment);
            system.rough = Some(surfaces(0.1, 0.4, flow));
            // Pressures that leave something for the oil.
            state.pressure.iter_mut().for_each(|p| *p *= 1.5);
            system.settle(&mut state);
            assert_parts(&system, &state);
        }
    }
}

/// Changes of balances and pressures of the oil against differences, oil and asperities at every P as at a solution.
fn assert_parts(system: &System, state: &State) {
    let grid = &system.grid;
    let at = system.linearise(state);
    let is_free = |k: usize| {
        let [i, j] = [k % grid.n[0], k / grid.n[0]];
        grid.is_unknown(i, j) && state.oil[k] > 0.01
    };
    let change: Vec<f64> = (grid.nodes().enumerate())
        .map(|(k, [i, j])| match is_free(k) {
            true => 0.3 * (i as f64).sin() + 0.2 * (1.7 * j as f64).cos(),
            false => 0.0,
        })
        .collect();
    let film = system.change_of_film(&change, 0.4);
    let own = system.change_by(&at, &change, &film);
    let moved = |step: f64| {
        let mut state = state.clone();
        for (k, (p, c)) in state.pressure.iter_mut().zip(&change).enumerate() {
            *p += step * c;
            if at.wetted[k] {
                let change = at.touching[k].change_of_oil(*c, film[k]);
                state.oil[k] += step * change;
            }
        }
        state.separation += 0.4 * step;
        system.linearise(&state)
    };
    let step = 1e-6;
    let [below, above] = [-step, step].map(moved);
    let size = own.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
    let [nx, _] = grid.n;
    // Oil of broken nodes is none, whatever P is: those whose fluxes they share are left out.
    let is_near_broken = |k: usize| {
        [0, 1, 2, nx, 2 * nx].into_iter().any(|far| {
            let around = [k.checked_sub(far), Some(k + far)];
            (around.into_iter().flatten()).any(|k| at.wetted.get(k) == Some(&false))
        })
    };
    let mut compared = 0;
    for (k, own) in own.iter().enumerate() {
        if !grid.is_unknown(k % nx, k / nx) {
            continue;
        }
        let slack = (above.touching[k].slack - below.touching[k].slack) / (2.0 * step);
        let exact = match at.wetted[k] {
            true => 0.0,
            false => at.touching[k].change_of_oil(change[k], film[k]),
        };
        assert_relative_eq!(slack, exact, epsilon = 1e-4, max_relative = 1e-4);
        if !is_near_broken(k) {
            let difference = (above.outflow[k] - below.outflow[k]) / (2.0 * step);
            assert_relative_eq!(*own, difference, epsilon = 2e-5 * size, max_relative = 1e-4);
            compared += 1;
        }
    }
    assert!(compared > 0);
}

/// A rigid cylinder in an oil of constant viscosity: Martin's film and the closed load of the asperities in a parabolic gap, 2 kN/m on R = 10 mm, σ 0.3 µm, κ
/// 100 MPa. The asperities do not change the film at a given gap, so that the film is known.
#[test]
fn rigid_rough_cylinder() {
    let (load, radius, sigma) = (2000.0, 0.01, 3e-7);
    let modulus = 5e14;
    let viscosity = ViscosityLaw::constant(0.01).unwrap();
    for (speed, exact, share) in [
        (0.05, 1.73790671e-7, 0.929585281),
        (0.5, 2.51529723e-7, 0.513480113),
        (2.0, 5.14972865e-7, 0.0494705983),
        (4.0, 9.79189456e-7, 0.000199917288),
    ] {
        let line = Contact::line(radius, load);
        let mut problem = contact(&line, modulus, &viscosity, speed);
        let scales = &problem.scales;
        let rms_height = sigma / scales.film;
        problem.rough = Some(surfaces(rms_height, 1e8 / scales.pressure, Flow::Distance));
        let width = (2.0 * radius * exact).sqrt() / scales.length;
        problem.start_film = exact / scales.film;
        problem.extents.inlet = -100.0 * width;
        problem.extents.outlet = 10.0 * width;
        problem.plan.most_grids = 11;
        let found = solved(&problem);
        let measured = found.measured(&problem);
        let film = measured.find(Figure::FilmMinimum).unwrap().value;
        assert_relative_eq!(film, exact, max_relative = 3e-3);
        let found = measured.find(Figure::AsperityLoadShare).unwrap();
        assert!((found.value - share).abs() < 3e-3, "{speed}: {found:?}");
    }
}

/// A steel line against an independent solver (two graded grids and Richardson's extrapolation): R 20 mm, 20 kN/m, 30 mPa s, 18 1/GPa, σ 0.25 µm, κ 196.9 MPa.
#[test]
fn rough_elastic_line() {
    let viscosity = ViscosityLaw::barus(0.03, 1.8e-8).unwrap();
    let line = Contact::line(0.02, 20e3);
    for (flow, speed, central, minimum, share) in [
        (Flow::AverageGap, 1.0, 354.518762, 329.058933, 0.0395223437),
        (Flow::AverageGap, 0.25, 104.295084, 93.4058245, 0.436277445),
        (Flow::AverageGap, 0.02, 3.32160379, 3.2580402, 0.954368922),
        (Flow::Distance, 0.25, 165.779223, 142.258304, 0.289971221),
        (Flow::Distance, 0.02, 41.0695068, 35.7061052, 0.772667872),
    ] {
        let mut problem = contact(&line, 230.769_230_77e9, &viscosity, speed);
        let scales = &problem.scales;
        let rms_height = 0.25e-6 / scales.film;
        problem.rough = Some(surfaces(rms_height, 196.9e6 / scales.pressure, flow));
        problem.start_film = 1.5e-9 * central / scales.film;
        problem.extents.inlet = -30.0;
        problem.extents.outlet = 4.0;
        let found = solved(&problem);
        let iterations: Vec<usize> = found.stats.iter().map(|s| s.newton_iterations).collect();
        assert!(iterations[0] < 20, "{iterations:?}");
        let measured = found.measured(&problem);
        for (figure, exact) in [
            (Figure::FilmCentral, central),
            (Figure::FilmMinimum, minimum),
        ] {
            let film = 1e9 * measured.find(figure).unwrap().value;
            // Distances far below σ by what they are of the mean gap, about 100 nm.
            let allowed = 3e-3 * exact + if exact < 10.0 { 0.05 } else { 0.0 };
            assert!((film - exact).abs() < allowed, "{speed}: {film} of {exact}");
        }
        let found = measured.find(Figure::AsperityLoadShare).unwrap();
        assert!((found.value - share).abs() < 2e-3, "{speed}: {found:?}");
        assert!(found.error.unwrap() < 5e-3);
    }
}

/// At a vanishing speed the contact is that of dry rough bodies: pressure and distance at the centre against an independent solver.
#[test]
fn dry_rough_contacts() {
    let viscosity = ViscosityLaw::constant(0.04).unwrap();
    let [line, circle] = [Contact::line(0.016, 7e4), Contact::circular(0.016, 100.0)];
    for (shape, sigma, stiffness, pressure, distance) in [
        (&line, 0.05, 1.0, 0.972335196, -0.272441521),
        (&line, 0.2, 5.0, 0.917521062, 0.63047931),
        (&line, 0.5, 1.0, 0.785871823, -0.142195336),
        (&circle, 0.2, 1.0, 0.847732595, -0.187943881),
        (&circle, 0.5, 1.0, 0.670071125, -0.0480249389),
    ] {
        let mut problem = contact(shape, 230.769_230_77e9, &viscosity, 1e-9);
        problem.rough = Some(surfaces(sigma, stiffness, Flow::AverageGap));
        problem.start_film = 1e-3;
        problem.extents.outlet = 4.5;
        problem.plan.target_error = 1e-3;
        let found = solved(&problem);
        let measured = found.measured(&problem);
        let of = |figure| measured.find(figure).unwrap().value;
        let central = of(Figure::PressureCentral) / problem.scales.pressure;
        assert_relative_eq!(central, pressure, max_relative = 1e-3);
        let film = of(Figure::FilmCentral) / problem.scales.film / sigma;
        assert!((film - distance).abs() < 2e-3, "{film} of {distance}");
        assert!(of(Figure::AsperityLoadShare) > 0.999);
    }
}

/// Roughness far below the film leaves the film of smooth surfaces; without asperities there are no figures of them.
#[test]
fn smooth_limit() {
    let motion = Motion::straight(0.8, 0.1);
    let smooth = problem(&motion, 0.02);
    let mut rough = problem(&motion, 0.02);
    rough.rough = Some(surfaces(1e-4, 1.0, Flow::AverageGap));
    let [own, limit] = [&smooth, &rough].map(|problem| solved(problem).measured(problem));
    for figure in [
        Figure::FilmCentral,
        Figure::FilmMinimum,
        Figure::PressureCentral,
        Figure::TractionCoefficient,
    ] {
        let [own, limit] = [&own, &limit].map(|of| of.find(figure).unwrap().value);
        assert_relative_eq!(own, limit, max_relative = 2e-4);
    }
    assert!(own.find(Figure::AsperityLoadShare).is_none());
    assert!(limit.find(Figure::AsperityLoadShare).unwrap().value < 1e-12);
}

/// Damped steps lead to the same solution as full ones.
#[test]
fn damped_steps_have_the_same_end() {
    let [full, damped] = [false, true].map(|damped| {
        let mut problem = problem(&Motion::straight(0.2, 0.0), 0.02);
        problem.rough = Some(surfaces(0.08, 1.0, Flow::AverageGap));
        problem.plan.newton = NewtonParams {
            damped,
            max_iterations: 100,
            ends: Ends::of(2e-5),
            ..problem.plan.newton
        };
        let found = solved(&problem);
        let figures = found.stats.last().unwrap().figures;
        [
            Figure::FilmCentral,
            Figure::MeanGapMinimum,
            Figure::AsperityLoadShare,
        ]
        .map(|figure| figures.value(figure).unwrap())
    });
    for (full, damped) in full.into_iter().zip(damped) {
        assert_relative_eq!(full, damped, max_relative = 2e-4);
    }
}

/// A ball at twice the Hertz pressure of the other tests in films below the roughness: the load and the mass are kept, and the slower it rolls, the more of the load the asperities bear.
#[test]
fn heavy_balls_at_low_speeds() {
    let heavy = Contact::circular(0.004, 60.0);
    let mut before = 0.0;
    for (speed, sigma) in [(0.1, 0.05), (0.01, 0.05), (0.001, 0.05), (0.001, 0.015)] {
        let mut problem = problem_of(&heavy, &Motion::straight(speed, 0.0), 0.05);
        let stiffness = 0.05;
        problem.rough = Some(surfaces(sigma, stiffness, Flow::AverageGap));
        let found = solved(&problem);
        let finest = found.levels.last().unwrap();
        let force = finest.system.load - finest.system.integral(&finest.state.pressure);
        assert!(
            force.abs() < 1e-6 * problem.load,
            "{speed} {sigma}: {force}"
        );
        assert!(
            found.balance_error.abs() < 1e-2,
            "{speed} {sigma}: {}",
            found.balance_error
        );
        let figures = found.stats.last().unwrap().figures;
        let share = figures.value(Figure::AsperityLoadShare).unwrap();
        let gap = figures.value(Figure::MeanGapCentral).unwrap();
        assert!(gap > 0.0 && share < 1.0, "{speed} {sigma}: {gap} {share}");
        if sigma == 0.05 {
            assert!(share > before, "{speed}: {share} after {before}");
            before = share;
        }
    }
}

/// Derivatives of film, load share and pressure by speed and roughness against differences of whole solves.
#[test]
fn tangents_of_rough_surfaces_against_differences() {
    let at = |speed: f64, sigma: f64| {
        let mut problem = problem(&Motion::straight(speed, 0.1), 0.02);
        let mut rough = surfaces(sigma, 1.0, Flow::AverageGap);
        rough.boundary_friction = Some(0.1);
        problem.rough = Some(rough);
        // Differences of whole solves are small.
        problem.plan.newton.ends = Ends::of(2e-5);
        problem
    };
    let own = at(0.8, 0.08);
    let found = solved(&own);
    let tangents = Tangents::new(&own, &found, |_| true);
    let step = 1e-5;
    let sides = |of: &dyn Fn(f64) -> Problem<Plan>, size: f64| Perturbed {
        problem: of(step * size),
        step: step * size,
    };
    let by_speed = |d: f64| at(0.8 + d, 0.08);
    let by_roughness = |d: f64| at(0.8, 0.08 + d);
    let derivatives = tangents.derivatives(&[sides(&by_speed, 0.8), sides(&by_roughness, 0.08)]);
    let figures_of = |problem: &Problem<Plan>, n: usize| {
        let solved = solved(problem);
        figures(problem, &solved.levels[..n])
    };
    let n = tangents.grids();
    let of = |figures: &Figures, figure| figures.value(figure).unwrap();
    let here = figures_of(&own, n);
    let mut off = Vec::new();
    for (k, size) in [0.8, 0.08].into_iter().enumerate() {
        let step = 2e-3 * size;
        let [below, above] = [-step, step].map(|d| match k {
            0 => figures_of(&by_speed(d), n),
            _ => figures_of(&by_roughness(d), n),
        });
        let found = derivatives[k].as_ref().unwrap();
        for (figure, own) in tangents.figures().into_iter().zip(found) {
            let difference = (of(&above, figure) - of(&below, figure)) / (2.0 * step);
            let ratio = match figure {
                Figure::FilmCentral | Figure::FilmMinimum => 1.0,
                _ => tangents.value(figure) / of(&here, figure),
            };
            let size = tangents.value(figure).abs() / size;
            if (own - difference * ratio).abs() > 5e-3 * size {
                off.push((figure, k, *own, difference * ratio, size));
            }
        }
    }
    assert!(off.is_empty(), "{off:?}");
}
