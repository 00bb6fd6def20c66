//! The film on all patches together.

use rayon::prelude::*;

use super::grid::{Grid, slopes};
use super::level::Level;
use crate::contact::Shape;
use crate::engine::region::Region;
use crate::engine::{Film, Point, PointFields, PointTable};

/// The film on nested grids, with the table of its nodes.
pub struct PatchedFilm<'a> {
    shape: Shape,
    levels: &'a [Level],
    points: PointTable,
}

/// Rows that a thread takes at a time.
const ROWS: usize = 8;

impl<'a> PatchedFilm<'a> {
    /// Of the first grids of a solve; grids finer than the last one are ignored.
    pub fn new(shape: &Shape, levels: &'a [Level]) -> PatchedFilm<'a> {
        // Without threads that wait for each other.
        for level in levels {
            level.held();
        }
        let whole = Region::of(shape);
        let shorter = whole.shorter(shape);
        let row = |l: usize, j: usize| -> Vec<Point> {
            let grid = &levels[l].system.grid;
            let of_node = |i: usize| {
                let share = share(levels, l, i, j);
                (share > 0.0).then(|| {
                    let fields = node_fields(shape, &levels[l], i, j);
                    Point {
                        area: share * grid.cell(j),
                        within: [&whole, &shorter].map(|region| inside(region, grid, i, j)),
                        in_zone: shape.zone.contains(fields.place),
                        fields,
                    }
                })
            };
            (0..grid.n[0]).filter_map(of_node).collect()
        };
        let rows: Vec<(usize, usize)> = (0..levels.len())
            .flat_map(|l| (0..levels[l].system.grid.n[1]).map(move |j| (l, j)))
            .collect();
        let mut groups: Vec<Vec<Point>> = (rows.into_par_iter().with_min_len(ROWS))
            .map(|(l, j)| row(l, j))
            .collect();
        if let (Some(first), Some(last)) = (levels.first(), levels.last())
            && let Some(beyond) = &first.system.beyond
        {
            let points = beyond.points(shape, last.state.separation);
            let of_fields = |(area, fields): (f64, PointFields)| Point {
                area,
                within: [&whole, &shorter].map(|region| {
                    let [x, y] = region.unit(fields.place);
                    f64::from(u8::from(x.hypot(y) <= 1.0))
                }),
                in_zone: false,
                fields,
            };
            groups.push(points.map(of_fields).collect());
        }
        PatchedFilm {
            shape: shape.clone(),
            levels,
            points: PointTable::new(groups),
        }
    }

    /// H at the centre.
    pub fn centre(&self) -> f64 {
        self.at([0.0; 2]).map_or(f64::NAN, |fields| fields.film)
    }

    /// The grids, coarse to fine.
    pub fn levels(&self) -> &'a [Level] {
        self.levels
    }
}

/// Share of its cell that a node of a level represents outside the next one.
pub fn share(levels: &[Level], l: usize, i: usize, j: usize) -> f64 {
    match l + 1 == levels.len() {
        true => levels[l].system.grid.share(i, j),
        false => levels[l].share(i, j),
    }
}

/// Share of the cell of a node within a region, by the distance from its end.
fn inside(region: &Region, grid: &Grid, i: usize, j: usize) -> f64 {
    let radius = |dx: f64, dy: f64| {
        let [x, y] = grid.on_axes(i, j);
        let at = [x + dx * grid.spacing[0], y + dy * grid.length(1, j)];
        let [x, y] = region.unit(grid.turn.to_motion(at));
        x.hypot(y)
    };
    // Far from the end the distance is not computed: within a cell it changes by no more than the length of the sides.
    let beyond = radius(0.0, 0.0) - 1.0;
    let sides = [[grid.spacing[0], 0.0], [0.0, grid.spacing[1]]];
    let most: f64 = (sides
        .map(|side| region.unit(grid.turn.to_motion(side)))
        .iter())
    .map(|[x, y]| x.hypot(*y))
    .sum();
    if beyond.abs() > 0.5 * most {
        return f64::from(u8::from(beyond < 0.0));
    }
    let change =
        (radius(0.5, 0.0) - radius(-0.5, 0.0)).abs() + (radius(0.0, 0.5) - radius(0.0, -0.5)).abs();
    match change > 0.0 {
        true => (0.5 - beyond / change).clamp(0.0, 1.0),
        false => 1.0,
    }
}

/// Fields at a node.
pub fn node_fields(shape: &Shape, level: &Level, i: usize, j: usize) -> PointFields {
    let grid = &level.system.grid;
    let k = grid.index(i, j);
    with_film(
        shape,
        level,
        PointFields {
            place: grid.place(i, j),
            pressure: level.state.pressure[k],
            pressure_gradient: grid
                .turn
                .to_motion(slopes(grid, &level.state.pressure, i, j)),
            film: level.films[k],
            missing: level.missing(k),
            temperature: (level.warm.as_ref()).map(|warm| Box::new(warm.temperatures.profile(k))),
            ..PointFields::default()
        },
    )
}

/// Gap and deflection of a place whose film is known.
fn with_film(shape: &Shape, level: &Level, mut fields: PointFields) -> PointFields {
    fields.gap = shape.gap.value(fields.place);
    fields.deflection = fields.film - level.state.separation - fields.gap;
    fields
}

impl Film for PatchedFilm<'_> {
    fn points(&self) -> &PointTable {
        &self.points
    }

    fn at(&self, place: [f64; 2]) -> Option<PointFields> {
        let half = self.levels.first()?.system.grid.half;
        let mirrored = half && place[1] > 0.0;
        let own = if mirrored {
            [place[0], -place[1]]
        } else {
            place
        };
        let mut fields =
            (self.levels.iter().rev()).find_map(|level| at(&self.shape, level, own))?;
        if mirrored {
            fields.place = place;
            fields.pressure_gradient[1] *= -1.0;
        }
        Some(fields)
    }

    fn covers(&self, place: [f64; 2]) -> bool {
        let beyond = (self.levels.first()).and_then(|level| level.system.beyond.as_ref());
        match beyond {
            Some(beyond) => beyond.covers(&self.shape, place),
            None => self.at(place).is_some(),
        }
    }
}

/// Fields at a place of a grid, between the nodes by straight lines; `None` beyond its edge.
fn at(shape: &Shape, level: &Level, place: [f64; 2]) -> Option<PointFields> {
    let grid = &level.system.grid;
    let axes = grid.turn.to_axes(place);
    let (mut cell, mut weight) = ([0; 2], [0.0; 2]);
    for d in 0..2 {
        if let Some(rows) = grid.rows.as_ref().filter(|_| d == 1) {
            (cell[d], weight[d]) = rows.find(axes[d])?;
            continue;
        }
        if d == 1 && grid.is_line() {
            continue;
        }
        let at = axes[d] / grid.spacing[d] - grid.first[d] as f64;
        let [first, last] = grid.ends(d).map(|n| (n - grid.first[d]) as f64);
        // Rounding must not lead out of the grid.
        if !(first - ON_EDGE..=last + ON_EDGE).contains(&at) {
            return None;
        }
        cell[d] = (at.max(0.0) as usize).min(grid.n[d] - 2);
        weight[d] = at - cell[d] as f64;
    }
    let mut fields = PointFields {
        place,
        ..PointFields::default()
    };
    let mut deflection = 0.0;
    for (di, wx) in [(0, 1.0 - weight[0]), (1, weight[0])] {
        for (dj, wy) in [(0, 1.0 - weight[1]), (1, weight[1])] {
            let w = wx * wy;
            if dj > 0 && grid.is_line() {
                continue;
            }
            let node = node_fields(shape, level, cell[0] + di, cell[1] + dj);
            fields.pressure += w * node.pressure;
            deflection += w * node.deflection;
            fields.missing += w * node.missing;
            if let Some(profile) = node.temperature {
                let sum = fields.temperature.get_or_insert_default();
                let values = sum.temperature.iter_mut().zip(profile.temperature);
                values.for_each(|(sum, t)| *sum += w * t);
            }
            for (sum, slope) in fields
                .pressure_gradient
                .iter_mut()
                .zip(node.pressure_gradient)
            {
                *sum += w * slope;
            }
        }
    }
    fields.film = level.state.separation + shape.gap.value(place) + deflection;
    Some(with_film(shape, level, fields))
}

/// Share of a cell by which a place may lie beyond the edge of its grid.
const ON_EDGE: f64 = 1e-9;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::{Motion, Planar};
    use crate::volumes::tests::{problem, system};
    use approx::assert_relative_eq;

    /// A plane has its slopes at all nodes, at those of the edges too.
    #[test]
    fn slopes_of_a_plane() {
        let (system, _) = system(false, Planar::along_x(1.0));
        let grid = &system.grid;
        let plane: Vec<f64> = (grid.nodes())
            .map(|[i, j]| {
                let [x, y] = grid.on_axes(i, j);
                1.0 + 0.3 * x - 0.2 * y
            })
            .collect();
        for [i, j] in grid.nodes() {
            let [along, across] = slopes(grid, &plane, i, j);
            assert_relative_eq!(along, 0.3, max_relative = 1e-9);
            assert_relative_eq!(across, -0.2, max_relative = 1e-9);
        }
    }

    /// P = 0.4 − 0.3 (x² + y²/2) + 0.05 x on a half: a place and its mirror image have the same pressure and opposite slopes across, by hand.
    #[test]
    fn mirror_images() {
        let problem = problem(&Motion::straight(0.8, 0.0), 0.01);
        let (system, state) = system(true, Planar::along_x(1.0));
        let levels = [Level::new(system, state)];
        let film = PatchedFilm::new(&problem.shape, &levels);
        for [x, y] in [[0.25, -0.35], [-0.1, 0.5]] {
            let [own, image] = [y, -y].map(|y| film.at([x, y]).unwrap());
            assert_relative_eq!(own.pressure, image.pressure, max_relative = 1e-12);
            for (fields, y) in [(own, y), (image, -y)] {
                let [along, across] = fields.pressure_gradient;
                assert_relative_eq!(along, 0.05 - 0.6 * x, max_relative = 1e-9);
                assert_relative_eq!(across, -0.3 * y, max_relative = 1e-9);
            }
        }
    }

    /// Bodies that end at x = 1.1: of the cells of 0.25 around 1 and 1.25, nine tenths and nothing lie within, of that around 0.75 all.
    #[test]
    fn cells_end_with_the_bodies() {
        let problem = problem(&Motion::straight(0.8, 0.0), 0.01);
        let shape = Shape {
            ends: [1.1, 1e9],
            ..problem.shape
        };
        let (system, _) = system(true, Planar::along_x(1.0));
        let grid = &system.grid;
        let [centre, row] = grid.centre();
        for (steps, share) in [(3, 1.0), (4, 0.9), (5, 0.0)] {
            for i in [centre - steps, centre + steps] {
                let found = inside(&Region::of(&shape), grid, i, row);
                assert_relative_eq!(found, share, epsilon = 1e-9);
            }
        }
    }
}
