//! The lowest film and the tops of hills between the nodes of grids.

use super::grid::Grid;

use super::level::{Level, Sampled};
use super::rows::RING;

/// The lowest film of all grids, in a²/R.
#[derive(Clone, Copy, Debug)]
pub struct Lowest {
    /// The film.
    pub film: f64,
    /// Where it is.
    pub place: [f64; 2],
    /// Error that finer grids cannot show: outside the finest grid, the change made there by the last grid that covers it; the full value for a
    /// minimum on the edge of the first grid.
    pub misfit: f64,
}

/// The lowest film, among the nodes on the contact area that the finest grid at each place has; `None` without grids.
pub fn lowest(levels: &[Level]) -> Option<Lowest> {
    let film = |(l, i, j): &(usize, usize, usize)| {
        let level: &Level = &levels[*l];
        level.films[level.system.grid.index(*i, *j)]
    };
    let last = levels.len().checked_sub(1)?;
    let (l, i, j) = (levels.iter().enumerate())
        .flat_map(|(l, level)| {
            let grid = &level.system.grid;
            let nodes = grid.nodes();
            nodes
                .filter(move |[i, j]| grid.share(*i, *j) > 0.0)
                .filter(move |[i, j]| l == last || !level.is_refined(*i, *j))
                .map(move |[i, j]| (l, i, j))
        })
        .min_by(|a, b| film(a).total_cmp(&film(b)))?;
    let grid = &levels[l].system.grid;
    let (film, place) = extreme(grid, &levels[l].films, i, j);
    let misfit = match l {
        _ if l == last => 0.0,
        0 => film.abs(),
        _ => {
            let before = &levels[l - 1];
            let start = Sampled::new(&before.system.grid, grid);
            (start.cubic(&before.films, i, j) - levels[l].films[grid.index(i, j)]).abs()
        }
    };
    let misfit = match (l == 0 && is_given(grid, i, j)) || is_on_wall(grid, [i, j]) {
        true => film.abs(),
        false => misfit,
    };
    Some(Lowest {
        film,
        place,
        misfit,
    })
}

/// Whether a node lies on the edge of the contact area, which patches may reach.
fn is_on_wall(grid: &Grid, at: [usize; 2]) -> bool {
    (0..2).any(|d| {
        let number = grid.first[d] + at[d] as i64;
        let ends = grid.ends(d).into_iter().zip(grid.walls[d]);
        ends.into_iter()
            .any(|(end, is_wall)| is_wall && number == end)
    })
}

/// Whether the pressure of a node is given; rows of a roller end with it.
fn is_given(grid: &Grid, i: usize, j: usize) -> bool {
    match grid.rows {
        None => !grid.is_unknown(i, j),
        Some(_) => !(RING..grid.n[0] - RING).contains(&i),
    }
}

/// Differences of the values around a node: slopes, curvatures, and the mixed one; those of a direction that ends there are zero.
struct Around {
    slopes: [f64; 2],
    curvatures: [f64; 2],
    mixed: f64,
}

impl Around {
    fn new(grid: &Grid, values: &[f64], i: usize, j: usize) -> Around {
        let [nx, ny] = grid.n;
        let along = (i > 0 && i + 1 < nx).then_some([i.wrapping_sub(1), i + 1]);
        // Beyond the centreline of a half all is mirrored.
        let across = match j + 1 == ny {
            true => (grid.half && j > 0).then(|| [j - 1, j - 1]),
            false => (j > 0).then(|| [j - 1, j + 1]),
        };
        let here = values[grid.index(i, j)];
        let along_values = along.map(|sides| sides.map(|x| values[grid.index(x, j)]));
        let across_values = across.map(|sides| sides.map(|y| values[grid.index(i, y)]));
        let of = |sides: Option<[f64; 2]>| {
            let [low, high] = sides.unwrap_or([here; 2]);
            [0.5 * (high - low), high - 2.0 * here + low]
        };
        let [x, y] = [along_values, across_values].map(of);
        let mixed = along
            .zip(across)
            .map_or(0.0, |([west, east], [south, north])| {
                let at = |x: usize, y: usize| values[grid.index(x, y)];
                0.25 * (at(east, north) - at(east, south) - at(west, north) + at(west, south))
            });
        Around {
            slopes: [x[0], y[0]],
            curvatures: [x[1], y[1]],
            mixed,
        }
    }

    /// Steps from the node to the vertex of the paraboloid, `None` where it has none within reach.
    fn vertex(&self) -> Option<[f64; 2]> {
        let ([u, v], [a, b], c) = (self.slopes, self.curvatures, self.mixed);
        let determinant = a * b - c * c;
        let steps = [(c * v - b * u) / determinant, (c * u - a * v) / determinant];
        (determinant > 0.0 && steps.iter().all(|step| step.abs() <= REACH)).then_some(steps)
    }

    /// Steps to the vertices of the parabolas along each direction alone.
    fn vertices(&self) -> [f64; 2] {
        [0, 1].map(|d: usize| match (self.slopes[d], self.curvatures[d]) {
            (slope, curvature) if curvature != 0.0 && slope.abs() <= curvature.abs() => {
                -slope / curvature
            }
            _ => 0.0,
        })
    }
}

/// Distance of a vertex from the node of its paraboloid, in cells: the lobe of a slender contact is a narrow valley at an angle to the grid, whose lowest node may lie
/// more than a cell from the vertex.
const REACH: f64 = 1.5;

/// Most nodes from which a vertex is computed, one after the other.
const MOST_TRIES: usize = 3;

/// Vertex of the paraboloid through the values at a node that is higher or lower than its neighbours, computed from the node next to the vertex. The paraboloid of a
/// side lobe is rotated: separate parabolas along both directions miss its minimum by an amount that depends on the grid.
pub fn extreme(grid: &Grid, values: &[f64], i: usize, j: usize) -> (f64, [f64; 2]) {
    let at_node = values[grid.index(i, j)];
    let first = Around::new(grid, values, i, j);
    let is_lowest = first.curvatures.iter().sum::<f64>() > 0.0;
    let mut best = None;
    let mut node = [i, j];
    for _ in 0..MOST_TRIES {
        let around = Around::new(grid, values, node[0], node[1]);
        let Some(steps) = around.vertex() else {
            break;
        };
        let distance = steps[0].hypot(steps[1]);
        let found = placed(grid, values, node, steps, &around);
        let is_beyond_node = (found.0 <= at_node) == is_lowest;
        if best.is_none_or(|(least, _)| distance < least) && is_beyond_node {
            best = Some((distance, found));
        }
        let next = [0, 1].map(|d: usize| {
            let moved = node[d] as f64 + steps[d].round();
            moved.clamp(0.0, (grid.n[d] - 1) as f64) as usize
        });
        if next == node {
            break;
        }
        node = next;
    }
    match best {
        Some((_, found)) => found,
        None => placed(grid, values, [i, j], first.vertices(), &first),
    }
}

/// Value and place at some steps from a node.
fn placed(
    grid: &Grid,
    values: &[f64],
    [i, j]: [usize; 2],
    steps: [f64; 2],
    around: &Around,
) -> (f64, [f64; 2]) {
    let mut at = grid.on_axes(i, j);
    let mut value = values[grid.index(i, j)];
    for d in (0..2).filter(|d| steps[*d] != 0.0) {
        let side = if steps[d] < 0.0 { j.max(1) - 1 } else { j };
        at[d] += steps[d] * grid.step(d, side);
        value += 0.5 * around.slopes[d] * steps[d];
    }
    (value, grid.turn.to_motion(at))
}

/// Uncertainty of the top of a hill above the parabola through its node: half of the disagreement of second differences over one and two cells. On a
/// hill that is smooth on the grid their ratio is 1 to 4; on a ridge as narrow as the cells they are equal.
pub fn sharpness(grid: &Grid, values: &[f64], top: usize) -> f64 {
    let [nx, ny] = grid.n.map(|n| n as i64);
    let at = |x: i64, y: i64| {
        let y = match grid.half && y >= ny {
            true => 2 * (ny - 1) - y,
            false => y,
        };
        let is_inside = (0..nx).contains(&x) && (0..ny).contains(&y);
        is_inside.then(|| values[(y * nx + x) as usize])
    };
    let (i, j) = (top as i64 % nx, top as i64 / nx);
    let of = |[dx, dy]: [i64; 2]| {
        let second = |n: i64| {
            let sides = at(i - n * dx, j - n * dy)? + at(i + n * dx, j + n * dy)?;
            Some(sides - 2.0 * values[top])
        };
        Some(0.5 * (second(1)? - 0.25 * second(2)?).abs())
    };
    [[1, 0], [0, 1]]
        .into_iter()
        .filter_map(of)
        .fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;
    use crate::contact::Turn;

    fn square(n: usize) -> Grid {
        Grid {
            spacing: [0.1, 0.1],
            first: [-(n as i64) / 2; 2],
            n: [n; 2],
            half: false,
            turn: Turn::NONE,
            rows: None,
            stretch: 1.0,
            walls: [[false; 2]; 2],
        }
    }

    fn values(grid: &Grid, of: impl Fn([f64; 2]) -> f64) -> Vec<f64> {
        grid.nodes().map(|[i, j]| of(grid.on_axes(i, j))).collect()
    }

    /// A valley of 3 at (0.03, −0.02) that is ten times as narrow across a line at 40 degrees as along it: one paraboloid through the nodes finds bottom and place,
    /// wherever it lies between them.
    #[test]
    fn a_rotated_valley() {
        let grid = square(5);
        let (s, c) = 40f64.to_radians().sin_cos();
        for [x, y] in [[0.03, -0.02], [0.0, 0.04], [-0.01, -0.03]] {
            let film = values(&grid, |at| {
                let [dx, dy] = [at[0] - x, at[1] - y];
                let [along, across] = [c * dx + s * dy, c * dy - s * dx];
                3.0 + 0.2 * along * along + 2.0 * across * across
            });
            let (bottom, place) = extreme(&grid, &film, 2, 2);
            assert_relative_eq!(bottom, 3.0, max_relative = 1e-12);
            assert_relative_eq!(place[0], x, epsilon = 1e-12);
            assert_relative_eq!(place[1], y, epsilon = 1e-12);
        }
    }

    /// A valley of 3 that is seven times as narrow as long, at 30 degrees: its lowest node lies up to 1.2 cells from its bottom, and the paraboloid of any node is the valley.
    #[test]
    fn the_bottom_of_a_narrow_valley() {
        let grid = square(9);
        let (s, c) = 30f64.to_radians().sin_cos();
        let mut farthest = 0.0_f64;
        for (i, j) in (0..5).flat_map(|i| (0..5).map(move |j| (i, j))) {
            let [x, y] = [i, j].map(|k| 0.02 * f64::from(k) - 0.04);
            let film = values(&grid, |at| {
                let [dx, dy] = [at[0] - x, at[1] - y];
                let [along, across] = [c * dx + s * dy, c * dy - s * dx];
                3.0 + 0.1 * along * along + 5.0 * across * across
            });
            let lowest = (0..film.len()).min_by(|a, b| film[*a].total_cmp(&film[*b]));
            let (i, j) = lowest.map(|k| (k % 9, k / 9)).unwrap();
            let node = grid.on_axes(i, j);
            farthest = farthest.max((node[0] - x).abs().max((node[1] - y).abs()));
            let (bottom, _) = extreme(&grid, &film, i, j);
            assert_relative_eq!(bottom, 3.0, max_relative = 1e-9);
        }
        assert!(farthest > 0.1, "{farthest}");
    }

    /// The lowest film lies on the second of three grids, outside the third one: there the second grid has changed it from 0.4 to 0.3, and it may err by as much.
    #[test]
    fn a_minimum_outside_the_finest_grid() {
        let flow = crate::contact::Planar::along_x(1.0);
        let (system, state) = crate::volumes::tests::system(false, flow);
        let level = |h: f64, n: usize, low: f64, patch| {
            let grid = Grid {
                spacing: [h; 2],
                ..square(n)
            };
            Level {
                films: values(&grid, |[x, y]| low + 0.5 * ((x - 1.5).powi(2) + y * y)),
                system: crate::volumes::system::System {
                    grid,
                    ..system.clone()
                },
                state: state.clone(),
                patch,
                warm: None,
                contents: std::sync::OnceLock::new(),
            }
        };
        let levels = [
            level(0.5, 13, 0.4, Some([[2, 10]; 2])),
            level(0.25, 17, 0.3, Some([[4, 12]; 2])),
            level(0.125, 17, 0.3, None),
        ];
        let found = lowest(&levels).unwrap();
        assert_relative_eq!(found.film, 0.3, max_relative = 1e-12);
        assert_relative_eq!(found.place[0], 1.5, max_relative = 1e-12);
        assert_relative_eq!(found.misfit, 0.1, max_relative = 1e-9);
    }

    /// 1 − x² − y² is no sharper than its parabola; a ridge on a single column, 0.2 high, is uncertain by three quarters of its half.
    #[test]
    fn a_ridge_between_nodes_is_sharp() {
        let grid = square(7);
        let smooth = values(&grid, |[x, y]| 1.0 - x * x - y * y);
        let top = grid.index(3, 3);
        assert!(sharpness(&grid, &smooth, top) < 1e-14);
        let ridge = values(&grid, |[x, _]| if x.abs() < 0.05 { 1.2 } else { 1.0 });
        assert_relative_eq!(sharpness(&grid, &ridge, top), 0.15, max_relative = 1e-12);
    }
}
