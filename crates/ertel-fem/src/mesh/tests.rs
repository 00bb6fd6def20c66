//! Every property in two and three dimensions by the same functions, on the boxes of Habchi 2008, section 3.7.1.

use std::collections::HashMap;

use super::*;

/// The thesis's box: 60 x 30 x 60 (in Hertz radii) with the patch x in [-4.5, 1.5], y in [-3, 0].
const THESIS: BodyParams = BodyParams {
    dim: 3,
    x_inlet: -4.5,
    x_outlet: 1.5,
    y_side: 3.0,
    width: 60.0,
    depth: 60.0,
};

const ORIGIN: [f64; 3] = [0.0; 3];

fn hertz_zone(inside: f64, growth: f64) -> SizeField {
    SizeField {
        zones: vec![SizeZone {
            zone: Zone::Ball {
                center: ORIGIN,
                radius: 1.0,
            },
            size: inside,
        }],
        growth,
    }
}

fn bodies() -> Vec<BodyParams> {
    let boxes = [
        THESIS,
        BodyParams {
            width: 20.0,
            depth: 20.0,
            ..THESIS
        },
        BodyParams {
            width: 600.0,
            depth: 600.0,
            ..THESIS
        },
        BodyParams {
            x_inlet: -10.0,
            x_outlet: 2.0,
            y_side: 6.0,
            ..THESIS
        },
        // not multiples of any unit
        BodyParams {
            x_inlet: -4.37,
            x_outlet: 1.513,
            y_side: 2.91,
            width: 61.7,
            depth: 47.3,
            ..THESIS
        },
        // patch over the full length of the box
        BodyParams {
            x_inlet: -4.0,
            x_outlet: 4.0,
            y_side: 4.0,
            width: 8.0,
            depth: 8.0,
            ..THESIS
        },
    ];
    boxes
        .iter()
        .flat_map(|&b| [BodyParams { dim: 2, ..b }, b])
        .collect()
}

fn facets(cell: &[u32]) -> Vec<Vec<u32>> {
    (0..cell.len())
        .map(|i| {
            let mut facet: Vec<u32> = cell.iter().copied().filter(|&v| v != cell[i]).collect();
            facet.sort_unstable();
            facet
        })
        .collect()
}

fn box_measure(p: &BodyParams) -> f64 {
    p.width * p.depth * if p.dim == 3 { p.width / 2.0 } else { 1.0 }
}

fn patch_measure(p: &BodyParams) -> f64 {
    (p.x_outlet - p.x_inlet) * if p.dim == 3 { p.y_side } else { 1.0 }
}

/// Everything that holds for any mesh of a body, computed from vertices and cells alone.
fn check(body: &BodyMesh) {
    let p = body.params();
    let mesh = &body.mesh;
    // positive cells fill the box
    let measures: Vec<f64> = (0..mesh.n_cells()).map(|c| mesh.measure(c)).collect();
    assert!(measures.iter().all(|&m| m > 0.0), "{p:?}");
    let relative = measures.iter().sum::<f64>() / box_measure(p) - 1.0;
    assert!(relative.abs() < 1e-12, "{p:?}: measure off by {relative:e}");
    // conformity: two cells at a facet, or one where the facet lies in a side of the box
    let half = p.width / 2.0;
    let mut sides = vec![(0, -half), (0, half), (2, -p.depth), (2, 0.0)];
    if p.dim == 3 {
        sides.extend([(1, -half), (1, 0.0)]);
    }
    let mut owners: HashMap<Vec<u32>, usize> = HashMap::new();
    for c in 0..mesh.n_cells() {
        facets(mesh.cell(c))
            .into_iter()
            .for_each(|f| *owners.entry(f).or_default() += 1);
    }
    let mut on_side = [0; 6];
    for (facet, n) in &owners {
        let side = sides
            .iter()
            .position(|&(k, x)| facet.iter().all(|&v| mesh.vertices[v as usize][k] == x));
        assert_eq!(
            *n,
            if side.is_some() { 1 } else { 2 },
            "{p:?}: facet {facet:?} on side {side:?}"
        );
        if let Some(side) = side {
            on_side[side] += 1;
        }
    }
    assert_eq!(body.bottom.len(), on_side[2]);
    assert_eq!(body.symmetry.len(), on_side[5]);
    // every vertex is used: a hanging node would make the counts above right by accident only if unused
    let mut used = vec![false; mesh.n_vertices()];
    (0..mesh.n_cells())
        .flat_map(|c| mesh.cell(c))
        .for_each(|&v| used[v as usize] = true);
    assert!(used.iter().all(|&u| u));
    for (part, normal) in [
        (&body.contact, [0.0, 0.0, 1.0]),
        (&body.bottom, [0.0, 0.0, -1.0]),
        (&body.symmetry, [0.0, 1.0, 0.0]),
    ] {
        check_facets(mesh, part, normal);
    }
    check_contact(body);
}

/// Outward orientation, owner and opposite vertex.
fn check_facets(mesh: &SimplexMesh, part: &FacetMesh, normal: [f64; 3]) {
    for (i, facet) in part.facets.iter().enumerate() {
        let x: Vec<[f64; 3]> = facet[..mesh.dim]
            .iter()
            .map(|&v| mesh.vertices[v as usize])
            .collect();
        let edge = |i: usize, k: usize| x[i][k] - x[0][k];
        let n = if mesh.dim == 2 {
            [-edge(1, 2), 0.0, edge(1, 0)]
        } else {
            [(1, 2), (2, 0), (0, 1)].map(|(a, b)| edge(1, a) * edge(2, b) - edge(1, b) * edge(2, a))
        };
        let along: f64 = (0..3).map(|k| n[k] * normal[k]).sum();
        let length = n.iter().map(|n| n * n).sum::<f64>().sqrt();
        assert!(
            along > (1.0 - 1e-14) * length,
            "facet {facet:?} not outward"
        );
        let mut cell = mesh.cell(part.cells[i] as usize).to_vec();
        let opposite = cell.remove(part.opposite[i] as usize);
        assert!(!facet.contains(&opposite));
        assert!(facet[..mesh.dim].iter().all(|v| cell.contains(v)));
    }
}

/// The surface mesh covers the patch, once, and its edge is the patch's edge.
fn check_contact(body: &BodyMesh) {
    let p = body.params();
    let contact = body.contact_mesh();
    let surface = &contact.mesh;
    let measures: Vec<f64> = (0..surface.n_cells()).map(|c| surface.measure(c)).collect();
    assert!(measures.iter().all(|&m| m > 0.0));
    let relative = measures.iter().sum::<f64>() / patch_measure(p) - 1.0;
    assert!(relative.abs() < 1e-12, "{p:?}: patch off by {relative:e}");
    for (c, facet) in body.contact.facets.iter().enumerate() {
        let body_facet: Vec<u32> = surface
            .cell(c)
            .iter()
            .map(|&v| contact.body_vertices[v as usize])
            .collect();
        assert_eq!(body_facet, facet[..p.dim]);
    }
    // Dirichlet facets: those of one cell that do not lie in y = 0
    let mut owners: HashMap<Vec<u32>, usize> = HashMap::new();
    for c in 0..surface.n_cells() {
        facets(surface.cell(c))
            .into_iter()
            .for_each(|f| *owners.entry(f).or_default() += 1);
    }
    let mut on_edge = vec![false; surface.n_vertices()];
    for (facet, _) in owners.iter().filter(|(_, n)| **n == 1) {
        if p.dim == 2
            || facet
                .iter()
                .any(|&v| surface.vertices[v as usize][1] != 0.0)
        {
            facet.iter().for_each(|&v| on_edge[v as usize] = true);
        }
    }
    assert_eq!(on_edge, contact.on_patch_edge);
}

#[test]
fn bodies_are_met_exactly() {
    for p in bodies() {
        let field = hertz_zone(0.4, 0.8);
        let body = body_mesh(&p, &|x| field.size(x)).unwrap();
        check(&body);
        // the coarsest possible mesh still has the patch
        check(&body_mesh(&p, &|_| f64::INFINITY).unwrap());
    }
}

#[test]
fn size_is_respected_and_not_overdone() {
    for p in bodies() {
        let field = hertz_zone(0.3, 0.8);
        let body = body_mesh(&p, &|x| field.size(x)).unwrap();
        let mesh = &body.mesh;
        for c in 0..mesh.n_cells() {
            let cell = mesh.cell(c);
            let allowed = cell
                .iter()
                .map(|&v| field.size(mesh.vertices[v as usize]))
                .fold(f64::INFINITY, f64::min);
            assert!(mesh.longest_edge(c) <= allowed);
        }
    }
}
