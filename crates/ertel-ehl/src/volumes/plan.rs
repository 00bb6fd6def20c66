//! Meshes, tolerances and limits of the finite-volume method.

use super::ending::Ends;
use super::heat::Params;
use super::newton::NewtonParams;
use crate::engine::Problem;

/// Meshes, tolerances and limits of the finite-volume method.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plan {
    /// Relative error of both films at which it ends.
    pub target_error: f64,
    /// Most unknowns of a grid.
    pub max_unknowns: usize,
    /// Newton's method.
    pub newton: NewtonParams,
    /// Grids at least, of point and of line contacts.
    pub least_grids: [usize; 2],
    /// Grids at most.
    pub most_grids: usize,
    /// Cells of the finest grid at most, in half-widths.
    pub largest_cell: f64,
    /// Margin of a patch around the dry contact, in its cells.
    pub margin: f64,
    /// Half-widths from the centre to which that margin is added: 1 for the dry contact, more where a worn one is wider.
    pub inner: f64,
    /// Heat, in thermal contacts.
    pub heat: Params,
    /// Whether a grid is solved by continuation where Newton's method does not converge.
    pub continues: bool,
}

impl Plan {
    /// Patches wide enough for their films to agree with those of whole grids.
    pub fn new(target_error: f64, max_unknowns: usize) -> Plan {
        Plan {
            target_error,
            max_unknowns,
            least_grids: [LEAST_GRIDS, LEAST_GRIDS_OF_LINES],
            most_grids: MOST_GRIDS,
            largest_cell: f64::INFINITY,
            newton: NewtonParams {
                ends: Ends::of(target_error),
                ..NewtonParams::default()
            },
            margin: 45.0,
            inner: 1.0,
            heat: Params::default(),
            continues: true,
        }
    }
}

/// Most grids: cells of 1e-7 of the contact area.
const MOST_GRIDS: usize = 24;

/// Grids required for the error estimate of the films.
pub const LEAST_GRIDS: usize = 4;

/// Fewest grids of a line, whose cells are few: cells of 7e-4 half-widths resolve the pressure spike, which hardly affects the films but determines the shear.
const LEAST_GRIDS_OF_LINES: usize = 10;

/// Relative residual of the linear solves of lines: iterations on a row cost little, and balances of thick films far in the inlet close.
const KRYLOV_OF_LINES: f64 = 1e-4;

/// Largest change of the viscosity in a step, in e-folds, averaged up to the Hertz pressure.
const MAX_LN_VISCOSITY_STEP: f64 = 4.0;

/// Grids on which the start may be far from the film, and the largest change of a pressure on finer ones, at least: nodes at the ridge rise by half of the Hertz pressure
/// from grid to grid. Measured at M 745, L 18, where the limit by the viscosity is 0.053: 8 steps instead of 12 on the last grid.
const FAR_GRIDS: usize = 3;
const LARGEST_CHANGE_NEAR: f64 = 0.2;

/// Largest change of a pressure in a step: that of [`MAX_LN_VISCOSITY_STEP`] e-folds of the viscosity, where it is less than usual. By the ridge
/// of steep viscosities longer steps diverge.
fn largest_change(problem: &Problem<Plan>, level: usize) -> f64 {
    let [viscosity, ..] = problem.fluid.at(1.0).viscosity;
    let usual = problem.plan.newton.largest_change;
    let by_viscosity = MAX_LN_VISCOSITY_STEP / viscosity.ln().max(1.0);
    usual.min(match level < FAR_GRIDS {
        true => by_viscosity,
        false => by_viscosity.max(LARGEST_CHANGE_NEAR),
    })
}

/// Parameters of Newton's method for a problem on a grid.
pub fn newton_params(problem: &Problem<Plan>, level: usize) -> NewtonParams {
    NewtonParams {
        largest_change: largest_change(problem, level),
        krylov_tolerance: match problem.shape.is_line() {
            true => KRYLOV_OF_LINES,
            false => problem.plan.newton.krylov_tolerance,
        },
        ..problem.plan.newton
    }
}
