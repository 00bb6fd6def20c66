//! Which grids a problem is solved on: cells and box of the first one, and patches within it.

use super::contents::Arrival;
use super::engine::Plan;
use super::grid::{Grid, RING};
use super::rows::Rows;
use crate::contact::roller::RollerZone;
use crate::contact::{Inlet, Symmetry};
use crate::engine::Problem;

/// Cell of the first grid in half-widths, or in widths √H of a film thicker than they are deep; and the cells from the centre that it has at
/// most: beyond, pressures of flooded contacts are those of rigid parabolas.
const FIRST_CELL: f64 = 0.375;
const FIRST_CELLS: f64 = 80.0;

/// Share of the margin of flooded contacts that patches of starved ones have, so that cells at the meniscus are small beside its distance: with 1 the film
/// of a layer of four times its thickness errs by 0.15 %.
const MENISCUS: f64 = 2.0;

/// Widths √H of a film about the dry contact that all grids of a line cover, where its pressure rises, and multiples of the margin that they have: cells of a row cost
/// little, and rolling resistance is made far in the inlet, where cells are as large as 1/margin of the distance.
const WIDE: f64 = 4.0;
const MARGIN_OF_LINES: f64 = 4.0;

/// Rounding of places, in cells.
const ROUNDING: f64 = 1e-9;

/// Largest cell of the first grid.
fn largest_cell<P>(problem: &Problem<P>) -> f64 {
    let e = &problem.extents;
    let widest = e.side.max(e.inlet.abs()).max(e.outlet);
    match problem.shape.inlet {
        Inlet::Flooded => FIRST_CELL * problem.start_film.sqrt().max(1.0),
        Inlet::Layer(_) | Inlet::Meniscus => FIRST_CELL.max(widest / FIRST_CELLS),
    }
}

/// Cell of the first grid. A meniscus lies on the lines of a grid with cells of twice the size, and so does the outlet edge of a line: the oil behind the film is sheared as
/// far as that, which is a part of its traction.
pub fn first_cell<P>(problem: &Problem<P>) -> f64 {
    let largest = largest_cell(problem);
    let unit = 2.0 * largest;
    let dividing = |length: f64| largest * length / (unit * (length / unit).ceil());
    match Arrival::of(problem) {
        Arrival::From(meniscus) => dividing(meniscus.abs()),
        Arrival::Flooded | Arrival::FromEdges | Arrival::Layer(_) if problem.shape.is_line() => {
            dividing(problem.extents.outlet)
        }
        Arrival::Flooded | Arrival::FromEdges | Arrival::Layer(_) => largest,
    }
}

/// Distance from the centre to which the first grid of a flooded point contact goes at most, in half-widths.
pub fn widest<P>(problem: &Problem<P>) -> f64 {
    match problem.shape.is_line() {
        true => f64::INFINITY,
        false => FIRST_CELLS * first_cell(problem),
    }
}

/// The box, in the plane in which the zone is the unit circle, that a problem is solved in. Beyond a meniscus it holds the nodes that fluxes there
/// reach for.
pub fn bounds<P>(problem: &Problem<P>) -> [[f64; 2]; 2] {
    let e = &problem.extents;
    if problem.shape.zone.turn.is_none() {
        let inlet = match Arrival::of(problem) {
            Arrival::Flooded | Arrival::FromEdges | Arrival::Layer(_) => e.inlet,
            Arrival::From(meniscus) => meniscus - (2 * RING) as f64 * largest_cell(problem),
        };
        return [[inlet, e.outlet], [-e.side, e.side]];
    }
    // The motion enters and leaves by any side, unless what enters by a nearer one passes the dry contact.
    let along = e.inlet.abs().max(e.outlet);
    match problem.shape.zone.is_passed_from(e.side, along) {
        true => [[-along, along], [-e.side, e.side]],
        false => [[-along.max(e.side), along.max(e.side)]; 2],
    }
}

/// The grid with cells of the size h: the first one over the box, the others within it as far as the margin goes. Its corners are nodes of a
/// grid with cells of twice the size.
pub fn grid(problem: &Problem<Plan>, h: f64, first: Option<&Grid>) -> Grid {
    if let Some(roller) = &problem.shape.zone.roller {
        return roller_grid(problem, roller, h, first);
    }
    let (unit, zone) = (2.0 * h, &problem.shape.zone);
    let is_line = problem.shape.is_line();
    let region = match first {
        // Nodes whose pressure is given stand beyond the centre at least.
        None => {
            let least = ((RING + 1) as f64 * h / unit).ceil() * unit;
            bounds(problem).map(|[low, high]| {
                let most = match problem.shape.inlet {
                    // Cells of a row are few anyway.
                    _ if is_line => f64::INFINITY,
                    Inlet::Flooded => FIRST_CELLS * h,
                    Inlet::Layer(_) | Inlet::Meniscus => f64::INFINITY,
                };
                let (low, high) = (low.max(-most), high.min(most));
                // An edge that lies on a line does, whatever its rounding.
                let (low, high) = (
                    (low / unit - ROUNDING).ceil() * unit,
                    (high / unit + ROUNDING).floor() * unit,
                );
                [low.min(-least), high.max(least)]
            })
        }
        Some(first) => {
            let margin = match Arrival::of(problem) {
                Arrival::Flooded | Arrival::FromEdges | Arrival::From(_) => problem.plan.margin,
                Arrival::Layer(_) => MENISCUS * problem.plan.margin,
            };
            let (inner, margin) = match is_line {
                true => (
                    1.0 + WIDE * problem.start_film.sqrt(),
                    MARGIN_OF_LINES * margin,
                ),
                false => (1.0, margin),
            };
            let reach = ((inner + margin * h) / unit).floor() * unit;
            let whole = first.bounds();
            whole.map(|[low, high]| [low.max(-reach), high.min(reach)])
        }
    };
    if is_line {
        let columns = region[0].map(|x| (x / h).round() as i64);
        return Grid::of_line(columns, h);
    }
    let half = problem.shape.symmetry == Symmetry::Half;
    Grid::covering(region, h, half, zone)
}

/// Rows of a first grid over its columns, in the lengths by which elements are drawn out along a roller, and the fewest of them before and behind the
/// middle.
const ROWS: f64 = 2.0;
const FEWEST_ROWS: f64 = 4.0;

/// The grid of a roller with cells of the length h along the motion: all of its rows, whose distances are halved with h.
fn roller_grid(problem: &Problem<Plan>, roller: &RollerZone, h: f64, first: Option<&Grid>) -> Grid {
    let unit = 2.0 * h;
    let [low, high] = match first {
        None => [problem.extents.inlet, problem.extents.outlet],
        Some(first) => first.bounds()[0],
    };
    let reach = match first {
        None => f64::INFINITY,
        Some(_) => roller.half_extents()[0] + problem.plan.margin * h,
    };
    let columns = [
        2 * (low.max(-reach) / unit).ceil() as i64,
        2 * (high.min(reach) / unit).floor() as i64,
    ];
    let half = problem.shape.symmetry == Symmetry::Half;
    let coarsest = first.map_or(h, |first| first.spacing[0]);
    let finer = (coarsest / h).round() as usize;
    let (side, middle) = (roller.side(), roller.unit(0.0));
    let steps = [side + middle, side - middle].map(|length| {
        let rows = (length / (ROWS * coarsest)).ceil().max(FEWEST_ROWS);
        rows as usize * finer
    });
    let rows = Rows::new(roller, steps, half);
    Grid::of_roller(columns, h, rows, steps[0] + RING, half)
}
