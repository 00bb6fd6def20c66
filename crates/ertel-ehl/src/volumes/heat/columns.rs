//! The energy equation of the film at the nodes of a grid, without the flow from node to node.
//!
//! ```text
//!   R_a = ∫ φ_a (C − h(Q_shear + Q_comp)) + k/h T_s φ_a' ds = 0        W/m², φ_a the polynomials through the nodes of the film
//!   R_0 = −q_1,  R_N = −q_2                                              heat that flows into the bodies
//! ```
//! with convection and storage C from [`super::transport`]; equations and laws are those of [`crate::forms::energy`].

use rayon::prelude::*;

use crate::engine::PointFields;
use crate::film::cross_film::CrossFilm;
use crate::film::{FilmFluid, FilmNodes, MOST_NODES};
use crate::forms::energy::{FilmColumn, FilmPlace, Heat, Heights, film_column};
use crate::volumes::grid::Grid;
use crate::volumes::grid::slopes;
use crate::volumes::storage::Storage;
use crate::volumes::thinning::UNRESOLVED;

/// Coefficients of the heat equations of a film.
pub struct FilmHeat<'a> {
    /// The grid.
    pub grid: &'a Grid,
    /// The fluid, with its nodes across the film.
    pub fluid: &'a FilmFluid,
    /// Laws and scales.
    pub heat: &'a Heat,
    /// Heights at which the film is heated.
    pub heights: &'a Heights,
    /// How temperatures at the nodes change in time, where they do.
    pub stored: Option<&'a Storage>,
}

impl FilmHeat<'_> {
    /// Nodes across the film.
    pub fn nodes(&self) -> usize {
        self.fluid.nodes().map_or(2, FilmNodes::n)
    }
}

/// Films and pressures at the nodes of a grid.
pub struct Films<'a> {
    /// P.
    pub pressure: &'a [f64],
    /// H.
    pub film: &'a [f64],
    /// F, the missing oil of the gap; none where all gaps are full.
    pub missing: &'a [f64],
    /// Temperatures at the nodes of the film, node by node.
    pub temperature: &'a [f64],
    /// Conductances of the flow that is held fixed; none where the pressure gradient is used as it is.
    pub held: &'a [f64],
    /// ∂P/∂T; none of what is steady.
    pub pressure_rate: &'a [f64],
}

/// All nodes of a grid.
#[derive(Clone)]
pub struct Columns {
    /// Nodes across the film, and heights.
    pub n: [usize; 2],
    /// ∂R/∂T without convection, node by node: `[row + n·column]`.
    pub slopes: Vec<f64>,
    /// R without convection.
    pub rows: Vec<f64>,
    /// Capacity of a mass flow H ρ̄u/u_m at each height, W/(m²·K).
    pub capacity: Vec<f64>,
    /// H ρ̄u/u_m along the grid at each height.
    pub mass: Vec<[f64; 2]>,
    /// H ρ̄ at each height.
    pub content: Vec<f64>,
    /// Heat of shear and of compression, and the size of the latter, W/m².
    pub made: Vec<[f64; 3]>,
    /// Ψ.
    pub conductance: Vec<f64>,
}

/// The film at a node of a grid as the energy equation uses it.
pub fn place(grid: &Grid, films: &Films, f: usize, k: usize) -> FilmPlace {
    let [i, j] = [k % grid.n[0], k / grid.n[0]];
    let film = films.film[k].max(UNRESOLVED * grid.spacing[0].powi(2));
    let mut temperature = [0.0; MOST_NODES];
    temperature[..f].copy_from_slice(&films.temperature[k * f..][..f]);
    let fields = PointFields {
        film,
        missing: films.missing.get(k).copied().unwrap_or(0.0),
        ..PointFields::default()
    };
    FilmPlace {
        at: grid.place(i, j),
        pressure: films.pressure[k],
        pressure_rate: films.pressure_rate.get(k).copied().unwrap_or(0.0),
        pressure_gradient: grid.turn.to_motion(slopes(grid, films.pressure, i, j)),
        film,
        filling: fields.filling(),
        temperature,
        held_conductance: films.held.get(k).copied(),
    }
}

/// One node.
struct Column {
    slopes: Vec<f64>,
    rows: Vec<f64>,
    capacity: Vec<f64>,
    mass: Vec<[f64; 2]>,
    content: Vec<f64>,
    made: [f64; 3],
    conductance: f64,
}

/// Nodes that a thread takes at a time.
const BATCH: usize = 64;

impl Columns {
    /// At some films and temperatures.
    pub fn new(of: &FilmHeat, films: &Films) -> Columns {
        let columns = Columns::at(of, films, |_| true);
        let [f, h] = [of.nodes(), of.heights.n()];
        let n = columns.len();
        let mut all = Columns {
            n: [f, h],
            slopes: Vec::with_capacity(n * f * f),
            rows: Vec::with_capacity(n * f),
            capacity: Vec::with_capacity(n * h),
            mass: Vec::with_capacity(n * h),
            content: Vec::with_capacity(n * h),
            made: Vec::with_capacity(n),
            conductance: Vec::with_capacity(n),
        };
        for column in columns.into_iter().flatten() {
            all.slopes.extend(column.slopes);
            all.rows.extend(column.rows);
            all.capacity.extend(column.capacity);
            all.mass.extend(column.mass);
            all.content.extend(column.content);
            all.made.push(column.made);
            all.conductance.push(column.conductance);
        }
        all
    }

    /// Selected nodes of a grid.
    fn at(
        of: &FilmHeat,
        films: &Films,
        wanted: impl Fn(usize) -> bool + Sync,
    ) -> Vec<Option<Column>> {
        let f = of.nodes();
        (0..of.grid.n_nodes())
            .into_par_iter()
            .with_min_len(BATCH)
            .map_init(CrossFilm::default, |rule, k| {
                wanted(k).then(|| {
                    let place = place(of.grid, films, f, k);
                    let film = film_column(of.fluid, of.heat, of.heights, &place, rule);
                    column(of, &film, &place, f)
                })
            })
            .collect()
    }

    /// R, flow and capacity for films and temperatures that differ little from those of these columns, whose temperatures are `before`: evaluated at the nodes that are `near`,
    /// updated by the temperatures alone elsewhere. Slopes and heat do not change.
    pub fn nearby(&self, of: &FilmHeat, films: &Films, before: &[f64], near: &[bool]) -> Columns {
        let [f, h] = self.n;
        let mut moved = self.clone();
        for (k, column) in Columns::at(of, films, |k| near[k]).into_iter().enumerate() {
            let rows = &mut moved.rows[k * f..][..f];
            match column {
                Some(column) => {
                    rows.copy_from_slice(&column.rows);
                    moved.capacity[k * h..][..h].copy_from_slice(&column.capacity);
                    moved.mass[k * h..][..h].copy_from_slice(&column.mass);
                    moved.content[k * h..][..h].copy_from_slice(&column.content);
                }
                None => {
                    for b in 0..f {
                        let change = films.temperature[k * f + b] - before[k * f + b];
                        let slopes = &self.slopes[(k * f + b) * f..][..f];
                        for (row, slope) in rows.iter_mut().zip(slopes) {
                            *row += slope * change;
                        }
                    }
                }
            }
        }
        moved
    }

    /// Whether all of it is finite.
    pub fn is_finite(&self) -> bool {
        self.rows.iter().all(|v| v.is_finite()) && self.slopes.iter().all(|v| v.is_finite())
    }
}

fn column(of: &FilmHeat, film: &FilmColumn, place: &FilmPlace, f: usize) -> Column {
    let heights = of.heights;
    let h = heights.n();
    let mut column = Column {
        slopes: vec![0.0; f * f],
        rows: vec![0.0; f],
        capacity: Vec::with_capacity(h),
        mass: Vec::with_capacity(h),
        content: Vec::with_capacity(h),
        made: [0.0; 3],
        conductance: film.conductance,
    };
    // ∫ φ_a ∂(hQ)/∂(τ, κ) ds
    let mut by_stress = [[0.0; 3]; MOST_NODES];
    for k in 0..h {
        let point = &film.heights[k];
        let (shapes, [first, _]) = (&heights.shapes[k], &heights.slopes[k]);
        let weight = heights.weights()[k];
        let slope: f64 = (0..f).map(|m| first[m] * place.temperature[m]).sum();
        let source = point.shear + point.compression;
        let by_temperature = point.compression / point.temperature;
        let by = [
            point.by_stress[0],
            point.by_stress[1],
            point.by_gradient_factor,
        ];
        for a in 0..f {
            column.rows[a] += weight * (point.conduction * slope * first[a] - source * shapes[a]);
            for (sum, by) in by_stress[a].iter_mut().zip(by) {
                *sum += weight * shapes[a] * by;
            }
        }
        for b in 0..f {
            let heating = shapes[b] * (point.shear * film.thinning[b] + by_temperature);
            let conducted = point.conduction * first[b];
            for a in 0..f {
                column.slopes[b * f + a] += weight * (first[a] * conducted - shapes[a] * heating);
            }
        }
        column.capacity.push(point.lift_capacity);
        // Both are proportional to the density: a mass flow.
        let content = match point.lift_capacity > 0.0 {
            true => point.capacity / point.lift_capacity,
            false => 0.0,
        };
        let flow = match point.lift_capacity > 0.0 {
            true => point
                .velocity
                .map(|u| u * point.capacity / point.lift_capacity),
            false => [0.0; 2],
        };
        column.content.push(content);
        column.mass.push(of.grid.turn.to_axes(flow));
        column.made[0] += weight * point.shear;
        column.made[1] += weight * point.compression;
        column.made[2] += weight * point.compression.abs();
    }
    for b in 0..f {
        let [x, y] = film.stress_slopes[b];
        let factor = film.gradient_factor_slopes[b];
        for a in 0..f {
            let [by_x, by_y, by_factor] = by_stress[a];
            column.slopes[b * f + a] -= by_x * x + by_y * y + by_factor * factor;
        }
    }
    column
}
