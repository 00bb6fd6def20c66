//! The mass flow across the film, from one share of its thickness to another.
//!
//! ```text
//!   ω = −∇·m,   m(s) = h∫_{−½}^s ρu ds' − (s + ½) h∫ρu ds'
//!   ∫ λ_i ω dA = ∫ m·∇λ_i dA − ∮ λ_i m·n dl,   ω = Σ ω_j λ_j            λ: linear, one for each vertex
//! ```
//! With the whole mass matrix on the left, heat is conserved: for temperatures T = Σ T_j(s) λ_j what the energy equation lets the film
//! take up, ∫∫ ρu·∇T + ωT_s ds dA, is what flows out through the edge, because ∫ λ_j (∇·m + ω) dA is zero at each height for each j. With
//! the mass matrix lumped, or without the edge, it is not: in coarse inlets, where warm lubricant flows back, heat would be lost or made.

use super::sides::SideRule;
use super::space::HeatSpace;
use crate::film::FilmFluid;
use crate::film::cross_film::CrossFilm;
use crate::forms::energy::{FilmPlace, Heat, film_column};
use crate::solve::discretisation::Discretisation;
use crate::solve::evaluate::fields_in;
use crate::solve::system::State;

/// Relative residual of the mass matrix's solution, and iterations at most: each shrinks it by 3 at the least (Wathen, IMA J. Numer.
/// Anal. 7 (1987) 449-457).
const TOLERANCE: f64 = 1e-9;
const MOST_ITERATIONS: usize = 40;

/// Takes −∮ λ m·n dl to the sums ∫ m·∇λ dA at each height over each vertex.
pub(super) fn subtract_edges(
    d: &Discretisation,
    fluid: &FilmFluid,
    heat: &Heat,
    state: &State,
    sums: &mut [f64],
) {
    let space = d.heat.as_ref().expect("a discretisation with heat");
    let (heights, n) = (&space.column.heights, space.column.heights.n());
    let mut rule = CrossFilm::default();
    for side in &space.edges {
        let (c, _) = *side;
        let SideRule { normal, points } = SideRule::new(&d.contact, *side);
        for (xi, weight) in points {
            let fields = fields_in(d, state, c, xi);
            let place = FilmPlace {
                pressure: fields.pressure,
                pressure_gradient: fields.pressure_gradient,
                film: fields.film,
                temperature: fields.temperature.unwrap_or_default().temperature,
                held_conductance: None,
            };
            let film = film_column(fluid, heat, heights, &place, &mut rule);
            for (v, vertex) in d.contact.surface.cell(c).iter().enumerate() {
                let share = match v {
                    0 => 1.0 - xi[..d.contact.surface.dim].iter().sum::<f64>(),
                    _ => xi[v - 1],
                };
                let sums = &mut sums[*vertex as usize * n..][..n];
                for (sum, point) in sums.iter_mut().zip(&film.heights) {
                    let [x, y] = point.mass_below;
                    *sum -= weight * share * (x * normal[0] + y * normal[1]);
                }
            }
        }
    }
}

/// ω at each height over each vertex from ∫ λω dA, by conjugate gradients with the diagonal as preconditioner, all heights at once.
pub(super) fn divide_by_mass(d: &Discretisation, space: &HeatSpace, sums: &mut [f64]) {
    let n = space.column.heights.n();
    let surface = &d.contact.surface;
    let corners = surface.dim + 1;
    // ∫ λ_i λ_j = |c| (1 + δ_ij)/((dim + 1)(dim + 2))
    let share = 1.0 / (corners * (corners + 1)) as f64;
    let mut diagonal = vec![0.0; surface.n_vertices()];
    for c in 0..surface.n_cells() {
        for vertex in surface.cell(c) {
            diagonal[*vertex as usize] += 2.0 * share * surface.measure(c);
        }
    }
    let product = |x: &[f64], y: &mut [f64]| {
        y.fill(0.0);
        let mut whole = vec![0.0; n];
        for c in 0..surface.n_cells() {
            let cell = surface.cell(c);
            let weight = share * surface.measure(c);
            whole.fill(0.0);
            for vertex in cell {
                for (sum, x) in whole.iter_mut().zip(&x[*vertex as usize * n..]) {
                    *sum += x;
                }
            }
            for vertex in cell {
                let at = *vertex as usize * n;
                for (k, sum) in whole.iter().enumerate() {
                    y[at + k] += weight * (sum + x[at + k]);
                }
            }
        }
    };
    let scaled = |r: &[f64]| -> Vec<f64> {
        let rows = r.chunks_exact(n).zip(&diagonal);
        rows.flat_map(|(row, m)| row.iter().map(move |v| v / m))
            .collect()
    };
    let mut residual = sums.to_vec();
    let mut z = scaled(&residual);
    let mut direction = z.clone();
    let mut images = vec![0.0; sums.len()];
    let mut square = dot(&residual, &z);
    let goal = TOLERANCE * TOLERANCE * square;
    sums.fill(0.0);
    for _ in 0..MOST_ITERATIONS {
        // also where nothing flows across, or what does is not a number
        if !(square > goal) {
            break;
        }
        product(&direction, &mut images);
        let step = square / dot(&direction, &images);
        for (k, p) in direction.iter().enumerate() {
            sums[k] += step * p;
            residual[k] -= step * images[k];
        }
        z = scaled(&residual);
        let next = dot(&residual, &z);
        for (p, z) in direction.iter_mut().zip(&z) {
            *p = z + next / square * *p;
        }
        square = next;
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}
