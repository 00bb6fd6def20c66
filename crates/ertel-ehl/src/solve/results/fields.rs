//! Fields of a solved stage for output, in SI.

use ertel_fem::linear::NEVER;
use ertel_fem::linear::condensed::Keep;
use ertel_fem::space::Space;

use crate::contact::Scales;
use crate::elastic::FiniteBodyError;
use crate::engine::{PointFields, Profile};
use crate::film::FilmFluid;
use crate::post::fields::{centreline_of, surface_of};
use crate::solution::{BodyField, Centreline, SurfaceField};
use crate::solve::discretisation::Discretisation;
use crate::solve::points::fields_in;
use crate::solve::sequence::StageSolution;
use crate::solve::state::State;

/// Samples per element edge along the centreline, and how many there are at least on coarse meshes, so that curves through
/// them are round.
const PER_EDGE: usize = 4;
const AT_LEAST: usize = 600;

/// The centreline as it is written and drawn.
pub(super) fn sampled(d: &Discretisation, state: &State) -> Profile {
    Profile::smooth(d, state, PER_EDGE, AT_LEAST)
}

/// Profiles along y = 0, four samples per element edge or more.
pub fn centreline(solution: &StageSolution, fluid: &FilmFluid, scales: &Scales) -> Centreline {
    let d = &solution.discretisation;
    let profile = sampled(d, &solution.state);
    centreline_of(&profile, &d.contact.shape, fluid, scales)
}

/// Fields at the pressure nodes; each element is cut into linear cells between them.
pub fn surface(solution: &StageSolution, fluid: &FilmFluid, scales: &Scales) -> SurfaceField {
    let d = &solution.discretisation;
    let mut at_nodes = vec![PointFields::default(); d.pressure.n_nodes()];
    for c in 0..d.contact.n_elements() {
        let nodes = d.pressure.nodes_of(c);
        for (xi, node) in d.pressure.element.points().zip(nodes) {
            at_nodes[*node as usize] = fields_in(d, &solution.state, c, xi);
        }
    }
    // Exactly the nodal values, and the places of the nodes.
    let nodes = d.pressure.points.iter().zip(&solution.state.pressure);
    for (fields, (place, pressure)) in at_nodes.iter_mut().zip(nodes) {
        fields.place = [place[0], place[1]];
        fields.pressure = *pressure;
    }
    SurfaceField {
        cells: sub_cells(&d.pressure),
        order: d.pressure.element.order(),
        elements: d.pressure.element_nodes.clone(),
        ..surface_of(&at_nodes, &d.contact.shape, fluid, scales)
    }
}

/// Elements cut into linear cells between their nodes: triangles, or segments in the first two entries.
pub(super) fn sub_cells(space: &Space) -> Vec<[u32; 3]> {
    let (lattice, order) = (space.element.lattice(), space.element.order());
    let local = |a1: usize, a2: usize| {
        let key = [(order - a1 - a2) as u8, a1 as u8, a2 as u8, 0];
        lattice
            .iter()
            .position(|a| *a == key)
            .expect("lattice point")
    };
    let mut cells = Vec::new();
    for c in 0..space.n_elements() {
        let nodes = space.nodes_of(c);
        let corner = |a: usize, b: usize| nodes[local(a, b)];
        for i in 0..order {
            if space.element.dim() == 1 {
                cells.push([corner(i, 0), corner(i + 1, 0), 0]);
                continue;
            }
            for j in 0..order - i {
                cells.push([corner(i, j), corner(i + 1, j), corner(i, j + 1)]);
                if i + j + 2 <= order {
                    cells.push([corner(i + 1, j + 1), corner(i, j + 1), corner(i + 1, j)]);
                }
            }
        }
    }
    cells
}

/// Displacement of the first body (the equivalent one, or body 1); `None` above a half-space.
///
/// The solve keeps only the surface, so the body is factorised again.
///
/// # Errors
/// When the factorisation fails.
pub fn body(
    solution: &StageSolution,
    scales: &Scales,
) -> Result<Option<BodyField>, FiniteBodyError> {
    let d = &solution.discretisation;
    let Some((body, condensed)) = d.contact.body() else {
        return Ok(None);
    };
    let elastic = &condensed.bodies[0];
    let trace = body.space(&d.contact.deflection);
    let mut load = vec![0.0; trace.dofs.n_dofs];
    let loads = d.trace.loads(&solution.state.pressure);
    for (f, dof) in loads.iter().zip(&trace.normal_dofs) {
        load[*dof] = -f / elastic.material.youngs_modulus;
    }
    trace
        .factorise(
            &body.mesh,
            elastic.material.poissons_ratio,
            Keep::Factor,
            NEVER,
        )
        .and_then(|k| k.solve_full(&mut load))
        .map_err(FiniteBodyError::from)?;
    let space = &trace.space;
    // VTK's order of mid-edge nodes, as pairs of corners.
    let edges: &[(usize, usize)] = match (body.mesh.mesh.dim, space.element.order()) {
        (_, 1) => &[],
        (2, _) => &[(0, 1), (1, 2), (0, 2)],
        _ => &[(0, 1), (1, 2), (0, 2), (0, 3), (1, 3), (2, 3)],
    };
    let lattice = space.element.lattice();
    let mid = |&(a, b): &(usize, usize)| {
        lattice
            .iter()
            .position(|l| l[a] == 1 && l[b] == 1)
            .expect("mid-edge node")
    };
    let local: Vec<usize> = (0..=body.mesh.mesh.dim)
        .chain(edges.iter().map(mid))
        .collect();
    Ok(Some(BodyField {
        points: space
            .points
            .iter()
            .map(|p| p.map(|x| x * scales.length))
            .collect(),
        cells: (0..space.n_elements())
            .map(|e| local.iter().map(|l| space.nodes_of(e)[*l]).collect())
            .collect(),
        displacement: trace
            .displacement(&load)
            .into_iter()
            .map(|u| u.map(|v| v * scales.film))
            .collect(),
    }))
}
