//! Edges of the contact area: their place, sums up to them, and their effect on the films.

use approx::assert_relative_eq;

use super::{problem, solved};
use crate::contact::Motion;
use crate::engine::{Film, NoObserver, Problem};
use crate::solution::Figure;
use crate::volumes::engine::FiniteVolumes;
use crate::volumes::film::PatchedFilm;
use crate::volumes::plan::Plan;

/// A ball with these edges.
fn with_edges([inlet, outlet, side]: [f64; 3]) -> Problem<Plan> {
    let mut problem = problem(&Motion::straight(0.8, 0.1), 0.01);
    problem.extents.inlet = -inlet;
    problem.extents.outlet = outlet;
    problem.extents.side = side;
    problem
}

const BOXES: [[f64; 3]; 4] = [
    [2.9, 1.5, 2.2],
    [2.5, 1.5, 2.2],
    [3.37, 1.43, 2.71],
    [9.0, 2.0, 9.0],
];

/// Inlet and side lie where they are given and the outlet to a hundredth of a half-width on every grid that reaches them, with no pressure there, and pressure
/// one cell inside the inlet.
#[test]
fn edges_lie_where_they_are_given() {
    for edges in BOXES {
        let problem = with_edges(edges);
        let found = solved(&problem);
        let [inlet, outlet, side] = edges;
        for level in &found.levels {
            let grid = &level.system.grid;
            let [[x, end], [y, _]] = grid.bounds();
            if grid.walls[0][0] {
                assert_relative_eq!(x, -inlet, max_relative = 1e-12);
                let [i, j] = [grid.ends(0)[0] - grid.first[0], -grid.first[1]].map(|n| n as usize);
                assert_eq!(level.state.pressure[grid.index(i, j)], 0.0);
                assert!(level.state.pressure[grid.index(i + 1, j)] > 0.0);
            }
            if grid.walls[0][1] {
                assert!((end - outlet).abs() < 0.0101, "{end} for {outlet}");
            }
            if grid.walls[1][0] {
                assert_relative_eq!(y, -side, max_relative = 1e-12);
            }
        }
        assert!(found.levels[0].system.grid.walls[0][0]);
    }
}

/// Areas of all nodes add up to the box, so the sum of a uniform quantity is exact: a node on the edge of the area and of a patch counts neither twice nor not at all.
#[test]
fn areas_add_up_to_the_box() {
    for edges in BOXES {
        let problem = with_edges(edges);
        let found = solved(&problem);
        let n = found.levels.len();
        for n in 1..=n {
            let film = PatchedFilm::new(&problem.shape, &found.levels[..n]);
            let sum: f64 = film.points().iter().map(|point| point.area).sum();
            let [[x, end], [y, _]] = found.levels[0].system.grid.bounds();
            assert_relative_eq!(sum, (end - x) * -y, max_relative = 1e-10);
        }
    }
}

/// Effect of edges on the films, by one step, against solves with edges further away: the bar of near edges covers the difference, and is not more than four times as wide.
#[test]
fn bars_cover_near_edges() {
    let solve = |edges: [f64; 3]| {
        let problem = with_edges(edges);
        let found = FiniteVolumes.solve(&problem, &mut NoObserver).unwrap();
        let measured = found.measured(&problem);
        let films = [Figure::FilmCentral, Figure::FilmMinimum].map(|f| measured.estimate(f));
        (films, found.edge_effects)
    };
    let ([central, minimum], _) = solve([9.0, 1.5, 9.0]);
    for edges in [[2.25, 1.5, 1.875], [2.9, 1.5, 2.2], [3.5, 1.5, 3.0]] {
        let (near, effects) = solve(edges);
        for ((near, far), effect) in near.iter().zip([central, minimum]).zip(effects) {
            let difference = (near.value / far.value - 1.0).abs();
            let bar = near.error.unwrap() / near.value;
            assert!(bar > difference, "{edges:?}: {bar} of {difference}");
            assert!(
                effect < 4.0 * difference + 1e-3,
                "{edges:?}: {effect} of {difference}"
            );
        }
    }
}
