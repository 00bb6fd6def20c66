//! Estimates of the discretisation error of the two films, element by element.
//!
//! ```text
//!   |h − h_h| ≲ Σ_T η_T,   η_T = c_U A_T κ_U/(2C) |e_δ| |e_ζ|  +  c_P A_T (ε κ_P² + a κ_P + 2ρ̄C) |e_P| |e_z|
//!
//!   C = Σ(1 − ν²)/E,  κ = π(k + 1)/h the wave number of what an element of order k misses,
//!   a = |∂ε/∂P ∇P − ρ̄'H|,  ε = ∂Q_x/∂P_x as in the stabilisation
//! ```
//! Both parts are products of an error and of the error of its adjoint (Becker and Rannacher, Acta Numerica
//! 10 (2001) 1-102). The first is the energy of the elastic errors, a half-space being of stiffness
//! |k|/(2C) for the wave number k; the second the Reynolds equation's, with diffusion, convection, and
//! the deflection that a pressure makes. The errors e are estimated from how little the polynomials of
//! neighbouring elements continue each other.
//!
//! Theory: Error estimate.

use ertel_fem::assembly::CONSTRAINED;
use ertel_fem::quadrature::Quadrature;
use ertel_fem::space::Space;

use super::adapt::FIRST_BAR;
use super::adjoint::{Adjoint, Functional, TO_WEIGH_ERRORS, adjoints};
use super::discretisation::Discretisation;
use super::element::{Assembler, Element, N_SUMS};
use super::evaluate::{central_film, minimum_film};
use super::minima::rival_minimum;
use super::neighbours::Neighbours;
use super::newton_level::FilmModel;
use super::points::fields_in;
use super::preconditioner::{NearStiffness, Preconditioner};
use super::ridge::{cut_off, own_shares, unresolved};
use super::state::State;
use super::system::System;
use crate::contact::Inlet;
use crate::engine::SolveError;
use crate::engine::far_field::far_field;
use crate::film::cross_film::CrossFilm;
use crate::solution::{BeyondEdges, ErrorEstimate, Figure, Figures, TemperatureErrors};
use crate::solve::tuning::errors::{
    AROUND, BLURRING, ELASTIC, REYNOLDS, RIDGE, RIDGE_SHARE, UNRESOLVED,
};

/// Estimated shares of the error in each element, relative to the film.
#[derive(Default)]
pub struct Indicator {
    /// Of the central film thickness.
    pub central: Vec<f64>,
    /// Of the minimum film thickness.
    pub minimum: Vec<f64>,
    /// Of the film at another minimum that may be the lowest where the errors are less; empty where there is none.
    pub rival: Vec<f64>,
    /// Relative change of the two films by the diffusion at ridges; a quarter of it is in the shares.
    pub ridge: [f64; 2],
    /// Relative errors of the two films that come from the edges of the contact area, where P = 0 is prescribed, and from pressures below zero behind the film.
    pub edges: [f64; 2],
    /// Of the mean square error of the pressure over the dry contact, in p_h².
    pub pressure: Vec<f64>,
    /// Largest error of the stress at the walls, ½H|∇P|, from the slopes of the pressure, in a p_h/R.
    pub shear_stress: f64,
    /// Root mean square error of the pressure in each element, in p_h.
    pub(super) local: Vec<f64>,
    /// Height of a ridge in each element that diffusion may have removed, in p_h.
    pub(super) cut_off: Vec<f64>,
    /// How high such a ridge may be, in p_h; zero without one.
    pub(super) ridge_height: f64,
    /// Adjoints of the two films.
    pub(super) adjoints: Vec<Adjoint>,
}

impl Indicator {
    /// Estimated relative errors of central and minimum film.
    pub fn totals(&self) -> [f64; 2] {
        let [central, minimum, rival] =
            [&self.central, &self.minimum, &self.rival].map(|shares| shares.iter().sum::<f64>());
        [central, minimum.max(rival)]
    }

    /// Estimated errors, those of the pressure around the places of `figures` in units of `scale`, Pa, `length` being the half-width in m.
    pub fn estimate(
        &self,
        d: &Discretisation,
        figures: &Figures,
        [scale, length]: [f64; 2],
    ) -> ErrorEstimate {
        let around = |figure: Figure| {
            let place = figures.get(figure).and_then(|reading| reading.place);
            place.map_or(0.0, |p| scale * self.around(d, p.map(|x| x / length)))
        };
        // Where a ridge may come up to.
        let above = |figure: Figure| {
            let value = figures.value(figure);
            value.map_or(0.0, |p| (scale * self.ridge_height - p).max(0.0))
        };
        let exceeding = |figure: Figure| around(figure).max(above(figure));
        let totals = self.totals();
        ErrorEstimate {
            films: [0, 1].map(|j: usize| totals[j] - RIDGE_SHARE * self.ridge[j]),
            ridge: self.ridge,
            edges: self.edges,
            unresolved: UNRESOLVED[d.contact.surface.dim - 1] * self.pressure_error(),
            pressure: self.pressure_error(),
            largest: exceeding(Figure::PressureMaximum),
            central_pressure: around(Figure::PressureCentral),
            ridge_pressure: match figures.get(Figure::PressureRidge) {
                Some(_) => exceeding(Figure::PressureRidge),
                None => 0.0,
            },
            spike: around(Figure::PressureSpike),
            ends: [Figure::EdgePressureLeft, Figure::EdgePressureRight].map(around),
            shear_stress: 0.0,
            share_of_point: share_of_point(d),
            beyond_edges: BeyondEdges::default(),
            temperatures: TemperatureErrors::default(),
        }
    }

    /// Largest error of the pressure in the elements around a place, in p_h.
    fn around(&self, d: &Discretisation, place: [f64; 2]) -> f64 {
        let contact = &d.contact;
        let Some((found, _)) = contact.locator.find(&contact.surface, place) else {
            return 0.0;
        };
        let reach = AROUND * contact.sizes[found];
        let is_near = |c: &usize| {
            let vertices = contact.surface.cell(*c).iter();
            let points = vertices.map(|v| contact.surface.vertices[*v as usize]);
            points.fold(f64::INFINITY, |m, p| {
                m.min((p[0] - place[0]).hypot(p[1] - place[1]))
            }) < reach
        };
        let error = |c: usize| self.local[c].max(self.cut_off[c]);
        (0..contact.n_elements())
            .filter(is_near)
            .map(error)
            .fold(error(found), f64::max)
    }

    /// Estimated root-mean-square error of the pressure over the dry contact, in p_h.
    pub fn pressure_error(&self) -> f64 {
        self.pressure.iter().sum::<f64>().sqrt()
    }
}

/// Sampling error of an area fraction of the Hertz zone: the largest weight of a point on a line; in an area errors of the many points at the
/// boundary mostly cancel, w√N with N = 1/√w of them.
fn share_of_point(d: &Discretisation) -> f64 {
    let weight = d.rule.weights.iter().copied().fold(0.0, f64::max);
    let centre = match d.contact.surface.dim {
        1 => [0.5, 0.0, 0.0],
        _ => [1.0 / 3.0, 1.0 / 3.0, 0.0],
    };
    let zone = &d.contact.shape.zone;
    let largest = (d.contact.maps.iter().enumerate())
        .filter(|(c, _)| zone.contains(d.contact.point(*c, centre)))
        .fold(0.0_f64, |most, (_, map)| most.max(weight * map.determinant));
    let share = (largest / d.contact.shape.zone_area()).min(1.0);
    match d.contact.surface.dim {
        1 => share,
        _ => share.powf(0.75),
    }
}

/// Estimates the errors of a converged state; `near` is what its level has for preconditioners, if anything, `kept`
/// a preconditioner of a state nearby.
///
/// # Errors
/// When the adjoints cannot be solved for.
pub fn indicator(
    d: &Discretisation,
    model: &FilmModel,
    state: &State,
    near: Option<&NearStiffness>,
    kept: Option<Preconditioner>,
) -> Result<Indicator, SolveError> {
    let own;
    let near = match near {
        Some(near) => near,
        None => {
            own = NearStiffness::new(d);
            &own
        }
    };
    let system = System::assemble(d, &model.fluid, &model.constants, state, None);
    let (h_m, at) = minimum_film(d, state);
    let surface = &d.contact.surface;
    let neighbours = Neighbours::new(surface);
    let rival = rival_minimum(d, state, &neighbours, (h_m, at));
    let mut films = vec![central_film(d, state), h_m];
    let mut thicknesses = vec![Functional::film_at(d, [0.0; 2]), Functional::film_at(d, at)];
    if let Some((film, place)) = rival {
        films.push(film);
        thicknesses.push(Functional::film_at(d, place));
    }
    // Coarse meshes may put a film below zero.
    let magnitudes: Vec<f64> = films.iter().map(|film| film.abs()).collect();
    let solve = |by| adjoints(d, &system, by, &thicknesses, &[], TO_WEIGH_ERRORS);
    let mut adjoint = match kept.map(solve) {
        Some(Ok(adjoint)) => adjoint,
        // None, or of no use any more.
        _ => solve(Preconditioner::new(d, near, &system)?)?,
    };
    let fields = |own: &'_ [f64], of: fn(&Adjoint) -> &[f64], space: &Space| {
        let fields: Vec<&[f64]> = std::iter::once(own).chain(adjoint.iter().map(of)).collect();
        neighbours.misfit(surface, space, &fields)
    };
    let film = fields(&state.pressure, |a| &a.film, &d.pressure);
    let deflection = fields(&state.deflection, |a| &a.deflection, &d.contact.deflection);
    let compliance = d.contact.response.compliance();
    let reference = Quadrature::simplex(surface.dim, 1)
        .weights
        .iter()
        .sum::<f64>();
    let wave = |space: &Space| std::f64::consts::PI * (space.element.order() + 1) as f64;
    let mut shares = vec![Vec::new(); films.len()];
    let mut rule = CrossFilm::default();
    let mut film_of_element = Vec::with_capacity(d.contact.n_elements());
    for c in 0..d.contact.n_elements() {
        let area = d.contact.maps[c].determinant * reference;
        let size = d.contact.sizes[c];
        let centroid = 1.0 / (surface.dim as f64 + 1.0);
        let xi = [centroid, if surface.dim == 2 { centroid } else { 0.0 }, 0.0];
        let f = fields_in(d, state, c, xi);
        film_of_element.push(f.film);
        let fluid = model.fluid.local(f.pressure, f.temperature.as_deref());
        let [rho, rho_p, _] = fluid.point().density;
        let [mu, mu_p, _] = fluid.point().viscosity;
        let (g, omega) = fluid.demands(f.place, f.pressure_gradient, f.film);
        let closure = fluid.close(g, omega, &mut rule);
        let factor = 12.0 * rho * f.film.powi(3) / (mu * model.constants.lambda);
        let epsilon = factor * closure.slopes[0][0];
        let gradient = f.pressure_gradient[0].hypot(f.pressure_gradient[1]);
        let convection = (epsilon * (rho_p / rho - mu_p / mu) * gradient).abs() + rho_p * f.film;
        let kappa = wave(&d.pressure) / size;
        let reynolds = epsilon * kappa * kappa + convection * kappa + 2.0 * rho * compliance;
        let elastic = wave(&d.contact.deflection) / (size * 2.0 * compliance);
        for (j, share) in shares.iter_mut().enumerate() {
            share.push(
                area / magnitudes[j]
                    * (ELASTIC * elastic * deflection[0][c] * deflection[j + 1][c]
                        + REYNOLDS * reynolds * film[0][c] * film[j + 1][c]),
            );
        }
    }
    let weights: Vec<&[f64]> = adjoint.iter().map(|a| a.film.as_slice()).collect();
    let usual = Assembler::new(d, &model.fluid, &model.constants, state, None);
    if d.contact.shape.inlet.layer().is_some() {
        // Smearing of the boundary of the filled gap over a length.
        let elements: Vec<usize> = (0..d.contact.n_elements()).collect();
        let changes = film_changes(d, [&usual, &usual.filling_over(0.5)], &weights, &elements);
        share_out(&changes, &magnitudes, BLURRING, &mut shares);
    }
    let mut ridge = vec![0.0; films.len()];
    if model.constants.ridge_diffusion > 0.0 {
        let at_ridge = |c: &usize| d.share_at_ridge(*c) > 0.0;
        let elements: Vec<usize> = (0..d.contact.n_elements()).filter(at_ridge).collect();
        let without = usual.without_ridge_diffusion();
        let changes = film_changes(d, [&usual, &without], &weights, &elements);
        ridge = share_out(&changes, &magnitudes, RIDGE, &mut shares);
    }
    let rival = match shares.len() {
        3 => shares.pop().unwrap_or_default(),
        _ => Vec::new(),
    };
    adjoint.truncate(2);
    // One that the errors do not bring down to the minimum is no rival.
    let above = films.last().map_or(0.0, |film| film / h_m - 1.0);
    let rival = match above < FIRST_BAR * rival.iter().sum::<f64>() {
        true => rival,
        false => Vec::new(),
    };
    let minimum = shares.pop().unwrap_or_default();
    let central = shares.pop().unwrap_or_default();
    let of_minimum = match rival.iter().sum::<f64>() > minimum.iter().sum::<f64>() {
        true => 2,
        false => 1,
    };
    let ridge = [ridge[0], ridge[of_minimum]];
    let zone = d.contact.shape.zone_area();
    let unresolved = unresolved(&d.pressure, &state.pressure);
    let squares: Vec<f64> = (d.contact.maps.iter().zip(&unresolved).zip(&system.missed))
        .map(|((map, error), missed)| map.determinant * reference * error * error + missed)
        .collect();
    let local: Vec<f64> = (squares.iter().zip(&d.contact.maps))
        .map(|(s, map)| (s / (map.determinant * reference)).sqrt())
        .collect();
    let (cut_off, ridge_height) = match (model.constants.ridge_diffusion > 0.0, surface.dim) {
        (true, _) => cut_off(&d.pressure, |c| d.share_at_ridge(c), &state.pressure),
        (false, 2) => {
            let shares = own_shares(&unresolved, &neighbours);
            cut_off(&d.pressure, |c| shares[c], &state.pressure)
        }
        // The spikes of lines are what their cells make of them.
        (false, _) => (vec![0.0; local.len()], 0.0),
    };
    // An error e of the wave number κ, in its slope: κe.
    let slope = |c: usize| 0.5 * wave(&d.pressure) / d.contact.sizes[c] * local[c];
    let shear_stress = (0..local.len())
        .map(|c| 0.5 * film_of_element[c] * slope(c))
        .fold(0.0, f64::max);
    Ok(Indicator {
        central,
        minimum,
        rival,
        ridge,
        shear_stress,
        local,
        cut_off,
        ridge_height,
        edges: [0, 1].map(|j: usize| {
            let edges = edge_error(d, model, state, &system, &adjoint[j].film);
            (edges + pulling_error(d, state, &system, &adjoint[j])) / magnitudes[j]
        }),
        pressure: squares.iter().map(|s| s / zone).collect(),
        adjoints: adjoint,
    })
}

/// Relative sum of the elements' `changes` of each film; a part of it is added to the shares.
fn share_out(
    changes: &[Vec<f64>],
    films: &[f64],
    [part, least]: [f64; 2],
    shares: &mut [Vec<f64>],
) -> Vec<f64> {
    (changes.iter().zip(films).zip(shares))
        .map(|((changes, film), shares)| {
            let sum = changes.iter().sum::<f64>().abs();
            let sizes: f64 = changes.iter().map(|change| change.abs()).sum();
            let total = sum.max(least * sizes) / film;
            if sizes > 0.0 {
                let weight = part * total / sizes;
                (shares.iter_mut().zip(changes)).for_each(|(s, c)| *s += weight * c.abs());
            }
            total
        })
        .collect()
}

/// By how much films would change, element by element, if the equations on some `elements` were those of the other assembly; `weights` are the
/// adjoints of the films.
fn film_changes(
    d: &Discretisation,
    [usual, other]: [&Assembler; 2],
    weights: &[&[f64]],
    elements: &[usize],
) -> Vec<Vec<f64>> {
    let (n, m) = (d.pressure_table.n_nodes, d.deflection_table.n_nodes);
    let (mut element, mut block) = (Element::default(), vec![0.0; n * (n + m)]);
    let mut sums = [vec![[0.0; N_SUMS]; n], vec![[0.0; N_SUMS]; n]];
    let mut changes = vec![vec![0.0; d.contact.n_elements()]; weights.len()];
    for &c in elements {
        for (assembler, sums) in [usual, other].into_iter().zip(&mut sums) {
            assembler.element(c, &mut element, &mut block, sums);
        }
        for (change, weights) in changes.iter_mut().zip(weights) {
            let nodes = d.pressure.nodes_of(c).iter().zip(&sums[0]).zip(&sums[1]);
            change[c] = nodes
                .filter(|((node, _), _)| d.pressure_dofs[**node as usize] != CONSTRAINED)
                .map(|((node, a), b)| -weights[*node as usize] * (b[1] - a[1]))
                .sum();
        }
    }
    changes
}

/// How much a film changes where the pressure beyond the edges of the contact area decays as it does far from a contact:
///
/// ```text
///   P = −λ(c_x e_x x + c_y e_y y)/H² > 0     c_x = 1/(3 + 2κ), c_y = κ/(3κ + 2): the solution of ∇·(H³∇P) = λ e·∇H for
///                                             H = ½(x² + κy²) (Kapitza 1955): 1/5 around a sphere, 1/3 along a cylinder
/// ```
/// with the film at the edge itself; to the pressures of the edge the film answers by −z·(R_P P).
fn edge_error(
    d: &Discretisation,
    model: &FilmModel,
    state: &State,
    system: &System,
    adjoint: &[f64],
) -> f64 {
    let lambda = model.constants.lambda;
    let [along, across] = far_field(&d.contact.shape.gap).map(|c| c * lambda);
    let (n, m) = (d.pressure_table.n_nodes, d.deflection_table.n_nodes);
    let on_edge = |node: &u32| d.pressure_dofs[*node as usize] == CONSTRAINED;
    let order = d.pressure.element.order() as f64;
    let mut change = 0.0;
    for c in 0..d.contact.n_elements() {
        let nodes = d.pressure.nodes_of(c);
        if !nodes.iter().any(on_edge) {
            continue;
        }
        let beyond: Vec<f64> = (nodes.iter().zip(d.pressure.element.lattice()))
            .map(|(node, alpha)| {
                let [x, y, _] = d.pressure.points[*node as usize];
                let drop = along * x + across * y;
                // At the ends of a roller the film ends.
                // Nor does pressure extend beyond a meniscus, or where the gap is not filled.
                let dry = match &d.contact.shape.inlet {
                    Inlet::Flooded => false,
                    Inlet::Meniscus => x < d.contact.extents.inlet * (1.0 - 1e-9),
                    Inlet::Layer(layer) => {
                        let xi = [1, 2, 3].map(|v: usize| f64::from(alpha[v]) / order);
                        fields_in(d, state, c, xi).film > layer.thickness
                    }
                };
                let at_end = d.contact.shape.zone.roller.is_some()
                    && x > d.contact.extents.inlet * (1.0 - 1e-9);
                if !on_edge(node) || at_end || dry || drop >= 0.0 {
                    return 0.0;
                }
                let xi = [1, 2, 3].map(|v: usize| f64::from(alpha[v]) / order);
                let film = fields_in(d, state, c, xi).film;
                -drop / (film * film)
            })
            .collect();
        for (i, node) in nodes.iter().enumerate() {
            let start = (c * n + i) * (n + m);
            let row = &system.blocks[start..start + n];
            let residual: f64 = row.iter().zip(&beyond).map(|(r, p)| r * p).sum();
            change -= adjoint[*node as usize] * residual;
        }
    }
    change.abs()
}

/// How much a film changes where pressures below zero, which the penalty leaves behind the film, are taken away: what they carry less of the load than nothing,
/// and what they pull at the film before them,
///
/// ```text
///   −Σ z_i (R_P ΔP)_i  over P_i ≥ 0  −  s ∫ΔP,     ΔP = max(−P, 0)
/// ```
/// Far behind thick films they are small and the area is large: 0.05 % of the load at M = 3, L = 0.
fn pulling_error(d: &Discretisation, state: &State, system: &System, adjoint: &Adjoint) -> f64 {
    let (n, m) = (d.pressure_table.n_nodes, d.deflection_table.n_nodes);
    let removed: Vec<f64> = state.pressure.iter().map(|p| (-p).max(0.0)).collect();
    let mut change = -adjoint.load * d.integral(&removed);
    for c in 0..d.contact.n_elements() {
        let nodes = d.pressure.nodes_of(c);
        if nodes.iter().all(|node| removed[*node as usize] == 0.0) {
            continue;
        }
        for (i, node) in nodes.iter().enumerate() {
            if removed[*node as usize] > 0.0 {
                continue;
            }
            let start = (c * n + i) * (n + m);
            let row = &system.blocks[start..start + n];
            let residual: f64 = (row.iter().zip(nodes))
                .map(|(r, node)| r * removed[*node as usize])
                .sum();
            change -= adjoint.film[*node as usize] * residual;
        }
    }
    change.abs()
}
