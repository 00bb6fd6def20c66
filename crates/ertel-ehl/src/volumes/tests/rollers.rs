//! Rows at uneven distances against closed forms and manufactured fields; rollers against their mirror images, balances and the limits of their ends.

use std::f64::consts::PI;

use approx::assert_relative_eq;

use super::*;
use crate::contact::Roller;
use crate::contact::roller::Profile;
use crate::engine::SolveError;
use crate::volumes::deflection::Deflection;
use crate::volumes::roller_zone::with_rows_by_film;
use crate::volumes::rows::RING;
use crate::volumes::rows::Rows;

/// Rows from −1 to 1, or to the middle, whose distances change by a factor of six: `n` steps on either side.
fn uneven(n: i64, half: bool) -> Rows {
    let place = |j: i64| {
        let t = j as f64 / n as f64;
        t + 0.225 * (PI * t).sin()
    };
    let beyond = RING as i64;
    let last = if half { 0 } else { n + beyond };
    Rows::at((-n - beyond..=last).map(place).collect(), half)
}

/// A grid with those rows.
pub(super) fn uneven_grid(n: i64, h: f64, half: bool) -> Grid {
    let columns = (1.0 / h).round() as i64;
    let rows = uneven(n, half);
    Grid::of_roller([-columns, columns], h, rows, n as usize + RING, half)
}

/// ∫∫ dA/r over a rectangle, seen from the origin (Love 1929; Johnson 1985, eq. 3.25).
fn love([x_0, x_1]: [f64; 2], [y_0, y_1]: [f64; 2]) -> f64 {
    let corner = |x: f64, y: f64| x * (y / x.abs()).asinh() + y * (x / y.abs()).asinh();
    corner(x_1, y_1) - corner(x_0, y_1) - corner(x_1, y_0) + corner(x_0, y_0)
}

/// A pressure of 1 between two rows, which falls to zero up to the rows beyond, deflects as rectangles do whose ends lie anywhere between: at all
/// nodes, on halves and wholes.
#[test]
fn rectangles_between_uneven_rows() {
    let c = 0.7;
    for half in [false, true] {
        let grid = uneven_grid(24, 0.05, half);
        let places = grid.rows.clone().unwrap();
        let y = |j: usize| places.places()[j];
        let (from, to) = (9, if half { 26 } else { 31 });
        let pressure: Vec<f64> = (grid.nodes())
            .map(|[i, j]| f64::from(u8::from((8..20).contains(&i) && (from..=to).contains(&j))))
            .collect();
        let found = Deflection::new(&grid, Kernel::HalfSpace { compliance: c }).apply(&pressure);
        // Of a half that ends in the middle: with the image.
        let ends = |t: f64| {
            let low = y(from) + t * (y(from - 1) - y(from));
            let high = if half {
                -low
            } else {
                y(to) + t * (y(to + 1) - y(to))
            };
            [low, high]
        };
        let x = [8, 19].map(|i| grid.on_axes(i, 0)[0]);
        let size = found.iter().fold(0.0_f64, |m, v| m.max(*v));
        for ([i, j], found) in grid.nodes().zip(found) {
            // Values beyond an end are not used.
            if places.height(j) == 0.0 || i % 3 != 0 {
                continue;
            }
            let [at, row] = grid.on_axes(i, j);
            let n = 400;
            let sum: f64 = (0..n)
                .map(|k| {
                    let across = ends((f64::from(k) + 0.5) / f64::from(n)).map(|end| end - row);
                    love([x[0] - 0.025 - at, x[1] + 0.025 - at], across)
                })
                .sum();
            let own = c / PI * sum / f64::from(n);
            assert_relative_eq!(found, own, epsilon = 2e-6 * size);
        }
    }
}

/// Hertz's pressure √(1 − r²) on rows that are near to each other at the ends of the circle (Johnson 1985, eq. 3.41a): errors fall with the power 1.5 of
/// the cell at least. A half is half of a whole.
#[test]
fn hertz_pressure_on_uneven_rows() {
    let error = |n: i64, half: bool| {
        let grid = uneven_grid(n, 1.0 / n as f64, half);
        let pressure: Vec<f64> = (grid.nodes())
            .map(|[i, j]| {
                let [x, y] = grid.on_axes(i, j);
                (1.0 - x * x - y * y).max(0.0).sqrt()
            })
            .collect();
        let deflection =
            Deflection::new(&grid, Kernel::HalfSpace { compliance: 0.7 }).apply(&pressure);
        let errors = grid.nodes().zip(deflection).map(|([i, j], found)| {
            let [x, y] = grid.on_axes(i, j);
            let r2 = x * x + y * y;
            match r2 < 0.9 {
                true => (found - 0.7 * PI / 4.0 * (2.0 - r2)).abs(),
                false => 0.0,
            }
        });
        errors.fold(0.0, f64::max)
    };
    let errors = [12, 24, 48].map(|n| error(n, true));
    assert!(errors[2] < 1e-3, "{errors:?}");
    assert!(errors[0] > 6.0 * errors[2], "{errors:?}");
    assert_relative_eq!(errors[1], error(24, false), max_relative = 1e-5);
}

/// The linearised balances against central differences on uneven rows, halves and wholes.
#[test]
fn jacobian_on_uneven_rows_against_differences() {
    for half in [true, false] {
        let (mut system, mut state) = system(half, Planar::along_x(1.0));
        let grid = uneven_grid(10, 0.125, half);
        let of = |f: &dyn Fn(f64, f64) -> f64| -> Vec<f64> {
            let places = grid.nodes().map(|[i, j]| grid.on_axes(i, j));
            places.map(|[x, y]| f(x, y)).collect()
        };
        system.gap =
            of(&|x, y| 0.25 + 0.5 * (x * x + y * y) + 0.05 * (3.0 * x).sin() * (2.0 * y).cos());
        state.pressure = of(&|x, y| (0.4 - 0.3 * (x * x + 0.5 * y * y) + 0.05 * x).max(0.0));
        for (k, [_, j]) in grid.nodes().enumerate() {
            if grid.is_end(j) {
                state.pressure[k] = 0.0;
            }
        }
        state.wetted = state.pressure.iter().map(|p| *p > 0.0).collect();
        system.convolution = Deflection::new(&grid, Kernel::HalfSpace { compliance: 0.3 }).into();
        system.grid = grid;
        assert_changes(&system, &state, 1e-6);
    }
}

/// A logarithmic steel roller of 2 mm under 300 N, tilted or not.
fn roller(profile: Profile, misalignment: f64, target: f64) -> Problem<Plan> {
    let roller = Roller {
        length: 2e-3,
        profile,
        misalignment,
    };
    let contact = Contact::of_roller(5e-3, 300.0, roller);
    let mut problem = problem_of(&contact, &Motion::straight(3.0, 0.0), target);
    problem.extents.inlet = -4.0;
    problem.extents.outlet = 2.0;
    problem
}

fn logarithmic() -> Profile {
    // For 400 N: b = 0.1 mm.
    Profile::lundberg(2e-3, 2e5, 1.05e-4, 230.8e9)
}

/// Mass is kept node by node, all of the load is carried, and the roller's figures are those of its mirror image: a tilt and the opposite one, a half and
/// a whole with no tilt to speak of.
#[test]
fn balances_and_mirror_images() {
    let own = |tilt: f64| {
        let mut problem = roller(logarithmic(), tilt, 0.05);
        problem.plan.newton.ends = Ends::of(0.0);
        let found = solved(&problem);
        let film = PatchedFilm::new(&problem.shape, &found.levels);
        let points = film.points().iter();
        let sum: f64 = points.map(|point| point.area * point.fields.pressure).sum();
        assert_relative_eq!(sum, problem.load, max_relative = 1e-6);
        assert_mass_is_kept(&found);
        found.measured(&problem)
    };
    let [half, whole, left, right] = [0.0, 1e-15, -2e-4, 2e-4].map(own);
    let value = |measured: &crate::solution::Measured, figure| {
        let found = measured.figures.value(figure);
        found.unwrap_or_else(|| panic!("{figure:?}"))
    };
    for figure in [
        Figure::FilmCentral,
        Figure::FilmMinimum,
        Figure::EdgePressureLeft,
    ] {
        let [a, b] = [&half, &whole].map(|measured| value(measured, figure));
        assert_relative_eq!(a, b, max_relative = 1e-5);
    }
    assert_eq!(value(&half, Figure::RollerMoment), 0.0);
    let arm = 300.0 * 1e-3;
    assert!(value(&whole, Figure::RollerMoment).abs() < 1e-5 * arm);
    for (a, b, sign) in [
        (Figure::FilmMinimum, Figure::FilmMinimum, 1.0),
        (Figure::EdgePressureLeft, Figure::EdgePressureRight, 1.0),
        (Figure::RollerMoment, Figure::RollerMoment, -1.0),
        (Figure::LoadPosition, Figure::LoadPosition, -1.0),
    ] {
        let pair = [value(&left, a), sign * value(&right, b)];
        assert_relative_eq!(pair[0], pair[1], max_relative = 1e-3);
    }
    // The end that is pressed in carries more: the load stands there, at the moment over the load.
    let place = value(&right, Figure::LoadPosition);
    assert!(place > 1e-5);
    assert_relative_eq!(
        300.0 * place,
        value(&right, Figure::RollerMoment),
        max_relative = 1e-4
    );
    assert!(value(&right, Figure::EdgePressureRight) > value(&right, Figure::EdgePressureLeft));
}

/// A roller with two thirds of the drop that makes the pressure uniform has no film at its ends: the solve reports this as an error.
#[test]
fn ends_that_press_in_are_reported() {
    // 1 µm at the ends.
    let crown = Profile::Crown { crown_radius: 0.5 };
    let problem = roller(crown, 0.0, 0.002);
    let end = FiniteVolumes.solve(&problem, &mut NoObserver).map(drop);
    match end {
        Err(SolveError::EndCarries { place, .. }) => {
            assert_relative_eq!(place, -1e-3, max_relative = 0.01);
        }
        other => panic!("{other:?}"),
    }
}

/// Derivatives by the load, which changes the length of the roller in half-widths, against differences of whole solves on as many grids.
#[test]
fn tangents_of_rollers_against_differences_of_solves() {
    let at = |share: f64| {
        let roller = Roller {
            length: 2e-3,
            profile: logarithmic(),
            misalignment: 0.0,
        };
        let contact = Contact::of_roller(5e-3, 300.0 * (1.0 + share), roller);
        let mut problem = problem_of(&contact, &Motion::straight(3.0, 0.0), 0.05);
        problem.extents.inlet = -4.0;
        problem.extents.outlet = 2.0;
        problem
    };
    let own = at(0.0);
    let found = solved(&own);
    let tangents = Tangents::new(&own, &found, |_| true);
    let step = 1e-5;
    let sides = Perturbed {
        problem: at(step),
        step,
    };
    let derivatives = tangents.derivatives(&[sides]).remove(0).unwrap();
    let n = tangents.grids();
    let figures_of = |problem: &Problem<Plan>| figures(problem, &solved(problem).levels[..n]);
    let here = figures(&own, &found.levels[..n]);
    let [below, above] = [at(-0.004), at(0.004)].map(|problem| figures_of(&problem));
    for (figure, derivative) in tangents.figures().into_iter().zip(derivatives) {
        let of = |figures: &Figures| figures.value(figure).unwrap();
        let difference = (of(&above) - of(&below)) / 0.008 / of(&here);
        let own = derivative / tangents.value(figure);
        assert_relative_eq!(own, difference, max_relative = 0.03, epsilon = 0.02);
    }
}

/// Rows by the loads per length of the film instead of those of slices: the same films and their mean, and the loads of the zone as before.
#[test]
fn rows_by_the_film_have_the_same_films() {
    let slices = roller(logarithmic(), 1e-4, 0.02);
    let film = with_rows_by_film(roller(logarithmic(), 1e-4, 0.02), &mut NoObserver).unwrap();
    let zones = [&slices, &film].map(|problem| problem.shape.zone.roller.clone().unwrap());
    assert_ne!(zones[0], zones[1]);
    for y in [-0.7, -0.3, 0.0, 0.5] {
        let loads = zones
            .each_ref()
            .map(|zone| zone.load(y * zone.half_length()));
        // Linear between other knots.
        assert_relative_eq!(loads[0], loads[1], max_relative = 5e-3);
    }
    let films = [&slices, &film].map(|problem| {
        let measured = solved(problem).measured(problem);
        [
            Figure::FilmCentral,
            Figure::FilmMinimum,
            Figure::FilmZoneMean,
        ]
        .map(|figure| measured.figures.value(figure).unwrap())
    });
    assert_relative_eq!(films[0][0], films[1][0], max_relative = 2e-3);
    assert_relative_eq!(films[0][1], films[1][1], max_relative = 2e-2);
    assert_relative_eq!(films[0][2], films[1][2], max_relative = 1e-2);
}
