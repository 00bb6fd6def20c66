//! End of the pressure zone of a roller, from its film on a few coarse grids: slices of the dry contact err by up to a tenth where ends carry much load, and they
//! decide where rows are close together.

use std::f64::consts::PI;
use std::sync::Arc;

use super::engine::{FiniteVolumes, Volumes};

use super::plan::Plan;
use crate::contact::Symmetry;
use crate::engine::{Observer, Problem, SolveError};

/// Grids: the last one has cells of a twentieth of a half-width.
const GRIDS: usize = 4;

/// The same problem, rows drawn around where the loads per length end that the film carries; as it is where these grids are not solved. The zone stays that of
/// the slices: its reported figures are those of the dry contact.
///
/// # Errors
/// When the observer cancels.
pub fn with_rows_by_film(
    mut problem: Problem<Plan>,
    observer: &mut dyn Observer,
) -> Result<Problem<Plan>, SolveError> {
    let Some(roller) = problem.shape.zone.roller.clone() else {
        return Ok(problem);
    };
    let plan = problem.plan;
    problem.plan.most_grids = GRIDS;
    // All of these grids.
    problem.plan.target_error = 0.0;
    let found = FiniteVolumes.solve(&problem, observer);
    problem.plan = plan;
    match found {
        Err(SolveError::Interrupted) => Err(SolveError::Interrupted),
        Err(_) => Ok(problem),
        Ok(found) => {
            let loads = loads(&found);
            let at = |y: f64| {
                let y = match problem.shape.symmetry {
                    Symmetry::Half => -y.abs(),
                    Symmetry::Full => y,
                };
                between(&loads, y)
            };
            problem.shape.zone.roller = Some(Arc::new(roller.graded_around(at)));
            Ok(problem)
        }
    }
}

/// Places along the axis with the load per length there, in units in which that of the line contact under the mean load is 1 on the finest grid, which holds nearly all of it.
fn loads(found: &Volumes) -> Vec<[f64; 2]> {
    let Some(finest) = found.levels.last() else {
        return Vec::new();
    };
    let grid = &finest.system.grid;
    let [nx, ny] = grid.n;
    let of_row = |j: usize| {
        let along: f64 = (0..nx)
            .map(|i| {
                let share = if i == 0 || i + 1 == nx { 0.5 } else { 1.0 };
                share * finest.state.pressure[grid.index(i, j)]
            })
            .sum();
        // Of the Hertz pressure of a line, ∫P dX = π/2.
        [grid.on_axes(0, j)[1], 2.0 / PI * along * grid.spacing[0]]
    };
    (0..ny).map(of_row).collect()
}

/// Between the places by straight lines.
fn between(loads: &[[f64; 2]], y: f64) -> f64 {
    let after = loads.partition_point(|[place, _]| *place <= y);
    let [Some(a), Some(b)] = [after.wrapping_sub(1), after].map(|k| loads.get(k)) else {
        return match (loads.first(), loads.last()) {
            (Some(first), _) if y < first[0] => first[1],
            (_, Some(last)) => last[1],
            _ => 0.0,
        };
    };
    a[1] + (b[1] - a[1]) * (y - a[0]) / (b[0] - a[0])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::Planar;
    use crate::volumes::grid::Grid;
    use crate::volumes::level::Level;
    use crate::volumes::rows::Rows;
    use crate::volumes::system::{State, System};
    use crate::volumes::tests::system;
    use approx::assert_relative_eq;

    /// A row under the Hertz pressure √(1 − x²) of a line bears the load per length of that line.
    #[test]
    fn loads_of_a_line() {
        let places = (-6..=6).map(|j| 0.25 * f64::from(j)).collect();
        let grid = Grid::of_roller([-40, 40], 0.05, Rows::at(places, false), 6, false);
        let (own, state) = system(false, Planar::along_x(1.0));
        let nodes = grid.nodes().map(|[i, j]| grid.on_axes(i, j)[0]);
        let pressure = nodes.map(|x| (1.0 - x * x).max(0.0).sqrt()).collect();
        let level = Level {
            films: vec![0.0; grid.n_nodes()],
            system: System { grid, ..own },
            state: State { pressure, ..state },
            patch: None,
            warm: None,
            contents: std::sync::OnceLock::new(),
        };
        let found = loads(&Volumes {
            levels: vec![level],
            stats: Vec::new(),
            stopped: false,
            edge_effects: [0.0; 2],
            balance_error: 0.0,
        });
        for [_, load] in found {
            assert_relative_eq!(load, 1.0, max_relative = 1e-2);
        }
    }
}
