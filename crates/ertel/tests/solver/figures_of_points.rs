//! Figures read from states that are written down.

use ertel::engine::figures::note_roller;
use ertel::problem::problem;
use ertel::solution::{Figure, Figures};
use ertel::solve::evaluate::largest_pressure_where;
use ertel::solve::state::State;

use super::{COARSE, ROLLING, case, discretisation};

const ROLLER: &str = "kind = \"roller\"\nradius = \"10 mm\"\nlength = \"2 mm\"\nload = \"200 N\"\n\
                      profile = { kind = \"crown\", crown_radius = \"300 mm\" }";

/// Pressures that fall from the middle of a roller towards its ends are largest, over the quarter of its length next to an end, where that
/// begins: at L/4 from the middle, half of the largest pressure.
#[test]
fn edge_pressures_are_those_of_the_outer_quarters() {
    let problem = problem(&case(ROLLER, ROLLING, COARSE));
    let stage = problem.plan.stages[0];
    let d = discretisation(&problem, &stage);
    let half = problem.shape.zone.roller.as_ref().unwrap().half_length();
    let falling = |p: &[f64; 3]| 1.0 - p[1].abs() / half;
    let state = State {
        pressure: d.pressure.points.iter().map(falling).collect(),
        deflection: vec![0.0; d.contact.deflection.n_nodes()],
        rigid_separation: 1.0,
        temperature: Vec::new(),
    };
    let mut figures = Figures::default();
    let largest =
        |at: &dyn Fn(f64) -> bool| Some(largest_pressure_where(&d, &state, |[_, y]| at(y)));
    let moments = || unreachable!("one half is solved");
    note_roller(&mut figures, &problem, largest, moments);
    let edge = figures.get(Figure::EdgePressureLeft).unwrap();
    let p = edge.size / problem.scales.pressure;
    // Read at nodes: one cell short of it at the most.
    assert!((0.42..=0.5 + 1e-9).contains(&p), "{p}");
    let y = edge.place.unwrap()[1] / problem.scales.length;
    assert!((-0.58..=-0.5 + 1e-9).contains(&(y / half)), "{}", y / half);
}
