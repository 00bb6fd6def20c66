//! Residual and Jacobian of the energy equation, in film and bodies at once.
//!
//! ```text
//!   film:    ∫∫ Ŵ(C v·∇T + cωT_s − hQ) − (Ŵ − W) κ T_ss + κ T_s W_s ds dA,   C = ρc h u_m/a, κ = k/h
//!   edge:    ∫∫ W max(−C v·n, 0)(T − T_e) ds dl                       what flows in
//!   bodies:  ∫∫ Ŵ c T_X − (Ŵ − W) κ ΔT + κ ∇T·∇W dZ dA,              c = ρc u, κ = k/a
//!   Ŵ = W + τ_S v·∇W     streamline upwinding (Habchi 2008, eq. 5.26 and following)
//! ```
//! Film and bodies share the nodes at the walls: that heat fluxes meet there is the natural condition. The
//! heat of shearing is differentiated by the temperature, at its height and, through the stress, at all
//! others; velocities, densities and thermal properties are not. ω comes from the assembly before.

use ertel_fem::linear::block_ilu::BlockMatrix;
use rayon::prelude::*;

use super::cross_flow::divide_by_mass;
use super::element::{Account, Assembly, Element, size_of_layers};
use super::prescribed::prescribed;
use super::space::HeatSpace;
use crate::film::FilmFluid;
use crate::film::cross_film::CrossFilm;
use crate::forms::energy::{Heat, Source};
use crate::solve::discretisation::Discretisation;
use crate::solve::state::State;
use crate::solve::streams::Streams;

/// Energy equation at a state.
pub struct HeatSystem {
    /// Residual, W/m² times half-widths squared, column by column.
    pub residual: Vec<f64>,
    /// Whether a temperature is prescribed.
    pub fixed: Vec<bool>,
    /// Heat balance: sources, and where the heat goes.
    pub account: Account,
    /// ω at each height over each vertex of the contact area, over ρ_R u_m a/R.
    pub cross_flow: Vec<f64>,
    /// Heat that the film takes up in each element, W/m² times half-widths squared.
    pub taken_up: Vec<f64>,
    /// Conductance Ψ at each point of each element.
    pub conductances: Vec<f64>,
}

/// Data that an assembly keeps from previous ones.
#[derive(Clone, Copy, Debug, Default)]
pub struct Kept<'a> {
    /// ω at each height over each vertex; empty: none.
    pub cross_flow: &'a [f64],
    /// Conductance Ψ of the frozen flow, at each point of each element; empty: the pressure gradient is used.
    pub conductances: &'a [f64],
    /// Oil behind the film; none: gaps are filled.
    pub streams: Option<&'a Streams>,
}

/// Residual, and the Jacobian into a matrix if there is one, damped by an inverse temperature (1/K).
pub fn assemble(
    d: &Discretisation,
    fluid: &FilmFluid,
    heat: &Heat,
    state: &State,
    source: Source,
    kept: Kept,
    jacobian: Option<(&mut BlockMatrix, f64)>,
) -> HeatSystem {
    let space = d.heat.as_ref().expect("a discretisation with heat");
    let n = space.column.n();
    let (mut matrix, damping) = jacobian.unzip();
    let mut system = HeatSystem {
        residual: vec![0.0; space.n()],
        fixed: prescribed(d, space, heat),
        account: Account::default(),
        cross_flow: vec![0.0; d.contact.surface.n_vertices() * space.column.heights.n()],
        taken_up: Vec::with_capacity(d.contact.n_elements()),
        conductances: Vec::with_capacity(d.contact.n_elements() * space.rule.weights.len()),
    };
    if let Some(matrix) = &mut matrix {
        matrix.clear();
    }
    let assembly = Assembly {
        d,
        space,
        fluid,
        heat,
        state,
        source,
        cross_flow: kept.cross_flow,
        conductances: kept.conductances,
        streams: kept.streams,
        with_jacobian: matrix.is_some(),
        damping: damping.unwrap_or(0.0),
    };
    let batches: Vec<usize> = (0..d.contact.n_elements()).step_by(BATCH).collect();
    for group in batches.chunks(GROUP) {
        let elements: Vec<Vec<Element>> = group
            .par_iter()
            .map(|first| {
                let mut rule = CrossFilm::default();
                let last = (first + BATCH).min(d.contact.n_elements());
                (*first..last)
                    .map(|c| assembly.element(c, &mut rule))
                    .collect()
            })
            .collect();
        for (first, elements) in group.iter().zip(&elements) {
            for (k, e) in elements.iter().enumerate() {
                system.add(d, space, first + k, e);
                if let Some(matrix) = &mut matrix {
                    scatter(space, space.surface.nodes_of(first + k), e, matrix);
                }
            }
        }
    }
    assembly.add_edges(&mut system, matrix.as_deref_mut());
    divide_by_mass(d, space, &mut system.cross_flow);
    for (k, fixed) in system.fixed.iter().enumerate() {
        if *fixed {
            // The reaction of a prescribed temperature is conducted out of the body.
            let unknown = k % n;
            let body = usize::from(unknown > space.column.first);
            system.account.conducted[body] -= system.residual[k];
            system.residual[k] = 0.0;
            if let Some(matrix) = &mut matrix {
                matrix.fix((k / n) as u32, unknown);
            }
        }
    }
    system
}

/// Elements that a thread takes at a time, and such batches whose contributions are kept at once.
const BATCH: usize = 8;
const GROUP: usize = 32;

impl HeatSystem {
    /// Adds what an element has to say.
    fn add(&mut self, d: &Discretisation, space: &HeatSpace, c: usize, e: &Element) {
        let n = space.column.n();
        for (i, node) in space.surface.nodes_of(c).iter().enumerate() {
            let rows = &mut self.residual[*node as usize * n..][..n];
            for (sum, v) in rows.iter_mut().zip(&e.residual[i * n..]) {
                *sum += v;
            }
        }
        self.account.add(&e.account);
        self.taken_up.push(e.taken_up);
        self.conductances.extend(&e.conductances);
        let n_heights = space.column.heights.n();
        let vertices = d.contact.surface.cell(c);
        for (vertex, rise) in vertices.iter().zip(e.rise.chunks_exact(n_heights)) {
            let sums = &mut self.cross_flow[*vertex as usize * n_heights..][..n_heights];
            for (sum, v) in sums.iter_mut().zip(rise) {
                *sum += v;
            }
        }
    }
}

fn scatter(space: &HeatSpace, nodes: &[u32], e: &Element, matrix: &mut BlockMatrix) {
    let (n, f) = (space.column.n(), space.column.film.n());
    let first = space.column.first;
    for (i, row) in nodes.iter().enumerate() {
        for (j, column) in nodes.iter().enumerate() {
            let pair = i * nodes.len() + j;
            let block = matrix.block_mut(*row, *column);
            for b in 0..f {
                let from = &e.film[(pair * f + b) * f..][..f];
                let to = &mut block[(first + b) * n + first..][..f];
                for (to, v) in to.iter_mut().zip(from) {
                    *to += v;
                }
            }
            for (layers, values) in space.column.bodies.iter().zip(&e.bodies) {
                let mut values = &values[pair * size_of_layers(layers)..];
                for layer in layers {
                    let m = layer.nodes.len();
                    for (b, column) in layer.nodes.iter().enumerate() {
                        for (a, row) in layer.nodes.iter().enumerate() {
                            block[column * n + row] += values[b * m + a];
                        }
                    }
                    values = &values[m * m..];
                }
            }
        }
    }
}
