//! Grids for a problem: cells and box of the first one, and patches within it.

use super::contents::Arrival;
use super::grid::Grid;
use super::plan::Plan;
use super::rows::RING;
use super::rows::Rows;
use crate::contact::roller::RollerZone;
use crate::contact::{Inlet, Symmetry};
use crate::engine::Problem;

/// Cell of the first grid in half-widths, or in widths √H of a film thicker than they are deep; and the cells from the centre that it has at
/// most: beyond, pressures of flooded contacts are those of rigid parabolas.
const FIRST_CELL: f64 = 0.375;
const FIRST_CELLS: f64 = 80.0;

/// Multiple of that distance within which edges of flooded contacts are those of the first grid, whose cells grow instead. Pressures that end there differ from those of
/// rigid parabolas by (r_0/r_1)^3.2 at the distance r_0, by 3 % of a pressure that carries almost no load.
const COARSER: f64 = 3.0;

/// Cells of the first grid between the centre and an edge at least.
const LEAST_CELLS: f64 = 4.0;

/// Error of the outlet edge at which the cells fit, in half-widths or over its distance from the centre: the film has broken there. And by how much more cells there may
/// be: a small grid costs nothing.
const FITS: f64 = 0.01;
const FITS_FAR: f64 = 2e-3;
const MORE_CELLS: f64 = 1.5;
const CHEAP: f64 = 32.0;

/// Share of the margin of flooded contacts that patches of starved ones have, so that cells at the meniscus are small compared with its distance: with 1 the film
/// of a layer of four times its thickness errs by 0.15 %.
const MENISCUS: f64 = 2.0;

/// Widths √H of a film about the dry contact that all grids of a line cover, where its pressure rises, and multiples of the margin that they have: cells of a row cost
/// little, and rolling resistance is made far in the inlet, where cells are as large as 1/margin of the distance.
const WIDE: f64 = 4.0;
const MARGIN_OF_LINES: f64 = 4.0;

/// Largest cell of the first grid.
fn largest_cell<P>(problem: &Problem<P>) -> f64 {
    let e = &problem.extents;
    let widest = e.side.max(e.inlet.abs()).max(e.outlet);
    match problem.shape.inlet {
        Inlet::Flooded => {
            let cell = FIRST_CELL * problem.start_film.sqrt().max(1.0);
            let coarser = widest / (FIRST_CELLS * cell);
            match problem.shape.is_line() {
                false if coarser <= COARSER => cell * coarser.max(1.0),
                _ => cell,
            }
        }
        Inlet::Layer(_) | Inlet::Meniscus => FIRST_CELL.max(widest / FIRST_CELLS),
    }
}

/// Cells of the first grid along and across the rows, with which the edges of the contact area are lines of the grid: inlet, or meniscus, and side exactly, the outlet
/// to a hundredth of a half-width.
pub fn first_cells<P>(problem: &Problem<P>) -> [f64; 2] {
    let largest = largest_cell(problem);
    let [[low, high], [_, side]] = first_box(problem);
    let before = match Arrival::of(problem) {
        Arrival::From(meniscus) => meniscus.abs(),
        Arrival::Flooded | Arrival::FromEdges | Arrival::Layer(_) => low.abs(),
    };
    let least = (before / largest)
        .max(LEAST_CELLS)
        .max(LEAST_CELLS * before / high);
    let most = (MORE_CELLS * least).max(CHEAP) as usize;
    let error = |n: usize| {
        let cells = high / before * n as f64;
        (cells.round() / cells - 1.0).abs()
    };
    let most_error = FITS_FAR.max(FITS / high);
    let numbers = least.ceil() as usize..=most.max(least.ceil() as usize);
    let fits = (numbers.clone())
        .find(|n| error(*n) <= most_error)
        .or_else(|| numbers.min_by(|a, b| error(*a).total_cmp(&error(*b))));
    [
        fits.map_or(largest, |n| before / n as f64),
        side / (side / largest).ceil().max(LEAST_CELLS),
    ]
}

/// The box of the first grid: that of the contact area, but for edges of flooded contacts so far away that they do not count.
fn first_box<P>(problem: &Problem<P>) -> [[f64; 2]; 2] {
    let is_near = problem.shape.is_line()
        || problem.shape.zone.roller.is_some()
        || problem.shape.inlet != Inlet::Flooded;
    let most = match is_near {
        true => f64::INFINITY,
        false => FIRST_CELLS * largest_cell(problem),
    };
    bounds(problem).map(|[low, high]| [low.max(-most), high.min(most)])
}

/// Distance from the centre beyond which a film in time is not followed unless `[mesh]` gives the edge, in half-widths.
pub fn widest<P>(problem: &Problem<P>) -> f64 {
    match problem.shape.is_line() {
        true => f64::INFINITY,
        false => FIRST_CELLS * FIRST_CELL * problem.start_film.sqrt().max(1.0),
    }
}

/// The box, in the plane in which the zone is the unit circle, that a problem is solved in. Beyond a meniscus it includes the nodes that the fluxes there
/// use.
pub fn bounds<P>(problem: &Problem<P>) -> [[f64; 2]; 2] {
    let e = &problem.extents;
    if problem.shape.zone.turn.is_none() {
        let inlet = match Arrival::of(problem) {
            Arrival::Flooded | Arrival::FromEdges | Arrival::Layer(_) => e.inlet,
            Arrival::From(meniscus) => meniscus - (2 * RING) as f64 * largest_cell(problem),
        };
        return [[inlet, e.outlet], [-e.side, e.side]];
    }
    // The flow may enter and leave by any side, unless inflow by a nearer one passes the dry contact.
    let along = e.inlet.abs().max(e.outlet);
    match problem.shape.zone.is_passed_from(e.side, along) {
        true => [[-along, along], [-e.side, e.side]],
        false => [[-along.max(e.side), along.max(e.side)]; 2],
    }
}

/// The grid with cells of the length h along the rows: the first one over the box, the others within it as far as the margin goes. Corners of the others are
/// nodes of a grid with cells of twice the size, or lie on edges of the contact area.
pub fn grid(problem: &Problem<Plan>, h: f64, first: Option<&Grid>) -> Grid {
    if let Some(roller) = &problem.shape.zone.roller {
        return roller_grid(problem, roller, h, first);
    }
    let is_line = problem.shape.is_line();
    let Some(first) = first else {
        let cell = [h, first_cells(problem)[1]];
        return covering(problem, first_box(problem), cell).with_walls(WALLS);
    };
    let margin = match Arrival::of(problem) {
        Arrival::Flooded | Arrival::FromEdges | Arrival::From(_) => problem.plan.margin,
        Arrival::Layer(_) => MENISCUS * problem.plan.margin,
    };
    let (inner, margin) = match is_line {
        true => (
            problem.plan.inner + WIDE * problem.start_film.sqrt(),
            MARGIN_OF_LINES * margin,
        ),
        false => (problem.plan.inner, margin),
    };
    let [along, across] = first.unit_cell();
    let cell = [h, across / along * h];
    let whole = first.bounds();
    let reach = cell.map(|h| ((inner + margin * h) / (2.0 * h)).floor() * 2.0 * h);
    let walls = [0, 1].map(|d: usize| [-whole[d][0], whole[d][1]].map(|edge| edge <= reach[d]));
    let region = [0, 1].map(|d: usize| {
        let [low, high] = whole[d];
        [low.max(-reach[d]), high.min(reach[d])]
    });
    covering(problem, region, cell).with_walls(walls)
}

/// Edges of the contact area on all sides.
const WALLS: [[bool; 2]; 2] = [[true; 2]; 2];

/// The grid of a contact without rows of a roller over a box.
fn covering<P>(problem: &Problem<P>, region: [[f64; 2]; 2], cell: [f64; 2]) -> Grid {
    let zone = &problem.shape.zone;
    if problem.shape.is_line() {
        return Grid::of_line(region[0].map(|x| (x / cell[0]).round() as i64), cell[0]);
    }
    let half = problem.shape.symmetry == Symmetry::Half;
    Grid::covering(region, cell, half, zone)
}

/// Rows of a first grid over its columns, in the lengths by which elements are stretched along a roller, and the fewest of them before and behind the
/// middle.
const ROWS: f64 = 2.0;
const FEWEST_ROWS: f64 = 4.0;

/// The grid of a roller with cells of the length h along the motion: all of its rows, whose distances are halved with h.
fn roller_grid(problem: &Problem<Plan>, roller: &RollerZone, h: f64, first: Option<&Grid>) -> Grid {
    let reach = match first {
        None => f64::INFINITY,
        Some(_) => {
            ((roller.half_extents()[0] + problem.plan.margin * h) / (2.0 * h)).floor() * 2.0 * h
        }
    };
    let [low, high] = match first {
        None => first_box(problem)[0],
        Some(first) => first.bounds()[0],
    };
    let walls = [[-low <= reach, high <= reach], [false; 2]];
    let columns = [low.max(-reach), high.min(reach)].map(|x| (x / h).round() as i64);
    let half = problem.shape.symmetry == Symmetry::Half;
    let coarsest = first.map_or(h, |first| first.spacing[0]);
    let finer = (coarsest / h).round() as usize;
    let (side, middle) = (roller.side(), roller.unit(0.0));
    let steps = [side + middle, side - middle].map(|length| {
        let rows = (length / (ROWS * coarsest)).ceil().max(FEWEST_ROWS);
        rows as usize * finer
    });
    let rows = Rows::new(roller, steps, half);
    Grid::of_roller(columns, h, rows, steps[0] + RING, half).with_walls(walls)
}
