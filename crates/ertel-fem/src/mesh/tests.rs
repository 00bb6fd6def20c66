//! Every property in two and three dimensions by the same functions, on the boxes of Habchi 2008, section 3.7.1.

use std::collections::HashMap;

use super::bisection::Bisection;
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

/// Size `inside` the unit ball, and its growth outside.
fn hertz_zone(inside: f64, growth: f64) -> impl Fn([f64; 3]) -> f64 {
    move |x| inside + growth * (norm(x) - 1.0).max(0.0)
}

fn norm(x: [f64; 3]) -> f64 {
    x.iter().map(|x| x * x).sum::<f64>().sqrt()
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
    for (facet, n) in &owners {
        let side = sides
            .iter()
            .position(|&(k, x)| facet.iter().all(|&v| mesh.vertices[v as usize][k] == x));
        assert_eq!(
            *n,
            if side.is_some() { 1 } else { 2 },
            "{p:?}: facet {facet:?} on side {side:?}"
        );
    }
    // every vertex is used: a hanging node would make the counts above right by accident only if unused
    let mut used = vec![false; mesh.n_vertices()];
    (0..mesh.n_cells())
        .flat_map(|c| mesh.cell(c))
        .for_each(|&v| used[v as usize] = true);
    assert!(used.iter().all(|&u| u));
    check_facets(mesh, &body.contact, [0.0, 0.0, 1.0]);
    check_contact(body);
}

/// Outward orientation and owner.
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
        let cell = mesh.cell(part.cells[i] as usize);
        assert!(facet[..mesh.dim].iter().all(|v| cell.contains(v)));
    }
}

/// The surface mesh covers the patch, once.
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
}

#[test]
fn bodies_are_met_exactly() {
    for p in bodies() {
        let field = hertz_zone(0.4, 0.8);
        let body = body_mesh(&p, &field).unwrap();
        check(&body);
        // the coarsest possible mesh still has the patch
        check(&body_mesh(&p, &|_| f64::INFINITY).unwrap());
    }
}

fn longest(vertices: &[[f64; 3]], simplex: &[u32]) -> f64 {
    let x = |i: usize| vertices[simplex[i] as usize];
    let pairs = (0..simplex.len()).flat_map(|i| (0..i).map(move |j| (i, j)));
    pairs
        .map(|(i, j)| {
            (0..3)
                .map(|k| (x(i)[k] - x(j)[k]).powi(2))
                .sum::<f64>()
                .sqrt()
        })
        .fold(0.0, f64::max)
}

#[test]
fn size_is_respected() {
    for p in bodies() {
        let field = hertz_zone(0.3, 0.8);
        let body = body_mesh(&p, &field).unwrap();
        let mesh = &body.mesh;
        for c in 0..mesh.n_cells() {
            let mut barycentre = [0.0; 3];
            for &v in mesh.cell(c) {
                (0..3).for_each(|k| {
                    barycentre[k] += mesh.vertices[v as usize][k] / (p.dim + 1) as f64
                });
            }
            // the barycentre is summed in another order than in the mesher
            assert!(longest(&mesh.vertices, mesh.cell(c)) <= field(barycentre) * (1.0 + 1e-14));
        }
        for facet in &body.contact.facets {
            let facet = &facet[..p.dim];
            let allowed = facet
                .iter()
                .map(|&v| field(mesh.vertices[v as usize]))
                .fold(f64::INFINITY, f64::min);
            assert!(longest(&mesh.vertices, facet) <= allowed);
        }
    }
}

/// The coarsest conforming descendant of the first cubes is unique, so another program must find the same counts:
/// these come from full sweeps over all cells, without adjacency or worklist, in another language.
#[test]
fn counts_agree_with_an_independent_program() {
    let field = SizeField {
        zones: vec![SizeZone {
            zone: Zone::Disc {
                center: ORIGIN,
                radius: 1.1,
            },
            size: 0.15,
        }],
        growth: 0.8,
    };
    for (dim, n_cells, n_vertices) in [(2, 263, 158), (3, 6660, 1557)] {
        let body = body_mesh(&BodyParams { dim, ..THESIS }, &|x| field.size(x)).unwrap();
        let found = (body.mesh.n_cells(), body.mesh.n_vertices());
        assert_eq!(found, (n_cells, n_vertices));
    }
}

/// Habchi 2008, section 3.7.1.1: in a box ten times as large the number of unknowns remains practically the same.
#[test]
fn far_field_is_cheap() {
    for dim in [2, 3] {
        let n_vertices = |width: f64| {
            let params = BodyParams {
                dim,
                width,
                depth: width,
                ..THESIS
            };
            body_mesh(&params, &hertz_zone(0.1, 1.0))
                .unwrap()
                .mesh
                .n_vertices() as f64
        };
        let ratio = n_vertices(600.0) / n_vertices(60.0);
        // a decade more, of three from the smallest cell to the box, at the same number of cells per decade
        assert!(ratio < 4.0 / 3.0 + 0.05, "dim {dim}: {ratio}");
    }
}

/// On unstretched cubes all cells of one tag are similar: right isosceles triangles; three shapes of tetrahedra.
/// Five decades of grading do not change that.
#[test]
fn shapes_do_not_degrade() {
    for (axes, n_shapes) in [(&[0, 2][..], 1), (&[0, 1, 2], 3)] {
        let dim = axes.len();
        let mut bisection =
            Bisection::from_cubes(axes, [-2.0, -2.0, -4.0], 2.0, [2, 1, 2], Default::default());
        bisection
            .refine_while(|vertices, cell| {
                let nearest = cell.iter().map(|&v| {
                    vertices[v as usize]
                        .map(|x| x * x)
                        .iter()
                        .sum::<f64>()
                        .sqrt()
                });
                Ok(longest(vertices, cell) > 4e-5 + nearest.fold(f64::INFINITY, f64::min))
            })
            .unwrap();
        let mesh = bisection.mesh();
        assert!(mesh.n_cells() > 100 * dim, "{}", mesh.n_cells());
        let [shortest, longest_of_all] = edges(&mesh);
        assert!(longest_of_all / shortest > 5e4);
        let mut shapes: Vec<Vec<i64>> = (0..mesh.n_cells())
            .map(|c| {
                let cell = mesh.cell(c);
                let size = longest(&mesh.vertices, cell);
                let pairs = (0..=dim).flat_map(|i| (0..i).map(move |j| (i, j)));
                let mut edges: Vec<i64> = pairs
                    .map(|(i, j)| {
                        (longest(&mesh.vertices, &[cell[i], cell[j]]) / size * 1e6).round() as i64
                    })
                    .collect();
                edges.sort_unstable();
                edges
            })
            .collect();
        shapes.sort();
        shapes.dedup();
        assert_eq!(shapes.len(), n_shapes, "{shapes:?}");
    }
}

/// Normalised radius ratio `n r / R` of inscribed to circumscribed sphere: 1 for the regular simplex, 0 for a
/// degenerate one (segments: always 1).
///
/// Triangle: `r = 2 A / sum l`, `R = l0 l1 l2 / (4 A)`. Tetrahedron: `r = 3 V / sum A`,
/// `R = sqrt(s (s - 2 p0) (s - 2 p1) (s - 2 p2)) / (24 V)` with the products `p` of opposite edges, `s` their sum.
fn quality(mesh: &SimplexMesh, cell: usize) -> f64 {
    let x: Vec<[f64; 3]> = mesh
        .cell(cell)
        .iter()
        .map(|&v| mesh.vertices[v as usize])
        .collect();
    let length = |i: usize, j: usize| longest(&x, &[i as u32, j as u32]);
    let measure = mesh.measure(cell).abs();
    match mesh.dim {
        1 => 1.0,
        2 => {
            let l = [length(0, 1), length(1, 2), length(2, 0)];
            16.0 * measure * measure / (l.iter().sum::<f64>() * l.iter().product::<f64>())
        }
        _ => {
            let p = [
                length(0, 1) * length(2, 3),
                length(0, 2) * length(1, 3),
                length(0, 3) * length(1, 2),
            ];
            let s: f64 = p.iter().sum();
            let surface: f64 = [[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]]
                .map(|f| triangle_area(f.map(|i| x[i])))
                .iter()
                .sum();
            let heron = (s * (s - 2.0 * p[0]) * (s - 2.0 * p[1]) * (s - 2.0 * p[2]))
                .max(0.0)
                .sqrt();
            if heron == 0.0 {
                0.0
            } else {
                216.0 * measure * measure / (surface * heron)
            }
        }
    }
}

fn triangle_area(x: [[f64; 3]; 3]) -> f64 {
    let edge = |i: usize| [x[i][0] - x[0][0], x[i][1] - x[0][1], x[i][2] - x[0][2]];
    let (a, b) = (edge(1), edge(2));
    let normal = [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ];
    normal.iter().map(|n| n * n).sum::<f64>().sqrt() / 2.0
}

/// Shortest and longest edge.
fn edges(mesh: &SimplexMesh) -> [f64; 2] {
    let pairs = mesh.cells.iter().flat_map(|cell| {
        let cell = cell[..=mesh.dim].to_vec();
        (0..cell.len()).flat_map(move |i| (0..i).map(|j| [cell[i], cell[j]]).collect::<Vec<_>>())
    });
    let lengths = pairs.map(|pair| longest(&mesh.vertices, &pair));
    lengths.fold([f64::INFINITY, 0.0], |[a, b], l| [a.min(l), b.max(l)])
}

/// Stretching costs no more than its ratio: a quality of 0.5 for every box here, at a grading of 1000 to 1 and more.
#[test]
fn quality_is_bounded() {
    for p in bodies() {
        let mesh = body_mesh(&p, &|x| 1e-3 + 0.9 * norm(x)).unwrap().mesh;
        let [shortest, longest] = edges(&mesh);
        assert!(longest / shortest > 4e3, "{p:?}");
        assert!(
            (0..mesh.n_cells()).all(|cell| quality(&mesh, cell) > 0.5),
            "{p:?}"
        );
    }
}

#[test]
fn quality_of_known_simplices() {
    let of = |dim: usize, vertices: &[[f64; 3]]| {
        let mesh = SimplexMesh {
            dim,
            axes: [0, 1, 2],
            vertices: vertices.to_vec(),
            cells: vec![[0, 1, 2, 3]],
        };
        quality(&mesh, 0)
    };
    let h = 3_f64.sqrt() / 2.0;
    let regular = [
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.5, h, 0.0],
        [0.5, h / 3.0, (2.0 / 3.0_f64).sqrt()],
    ];
    approx::assert_relative_eq!(of(2, &regular[..3]), 1.0, epsilon = 1e-14);
    approx::assert_relative_eq!(of(3, &regular), 1.0, epsilon = 1e-14);
    // unit legs at a right angle. Triangle: r = 1 / (2 + sqrt 2), R = sqrt 2 / 2.
    // Tetrahedron: r = 1 / (3 + sqrt 3), R = sqrt 3 / 2 (the sphere of the cube)
    let corner = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let s = 2_f64.sqrt();
    approx::assert_relative_eq!(
        of(2, &corner[..3]),
        2.0 / (2.0 + s) / (s / 2.0),
        epsilon = 1e-14
    );
    approx::assert_relative_eq!(of(3, &corner), 3.0 / (3.0 + 2.0 * h) / h, epsilon = 1e-14);
}

/// Marking by a fixed pseudo-random rule, ten times over: vertices stay, children fill the cell that is named.
#[test]
fn marked_cells_are_refined_in_place() {
    for axes in [&[0, 2][..], &[0, 1, 2]] {
        let mut bisection =
            Bisection::from_cubes(axes, [0.0; 3], 1.0, [9, 2, 9], Default::default());
        for round in 0..10 {
            let old = bisection.mesh();
            let marked: Vec<u32> = (0..old.n_cells() as u32)
                .filter(|c| (c * 7919 + round * 104_729) % 53 < 2)
                .collect();
            let origin = bisection.refine_marked(&marked).unwrap();
            let new = bisection.mesh();
            assert_eq!(origin.len(), new.n_cells());
            assert_eq!(new.vertices[..old.n_vertices()], old.vertices);
            let mut filled = vec![0.0; old.n_cells()];
            let mut n_children = vec![0; old.n_cells()];
            for (c, &o) in origin.iter().enumerate() {
                filled[o as usize] += new.measure(c);
                n_children[o as usize] += 1;
            }
            assert!(marked.iter().all(|&c| n_children[c as usize] >= 2));
            for (c, &measure) in filled.iter().enumerate() {
                approx::assert_relative_eq!(measure, old.measure(c), max_relative = 1e-12);
            }
        }
    }
}

/// Some facets of the patch are halved, ten times over: conforming each time, and vertices stay.
#[test]
fn patches_are_refined_in_place() {
    for dim in [2, 3] {
        let coarse = hertz_zone(1.0, 1.0);
        let mut body = body_mesh(&BodyParams { dim, ..THESIS }, &coarse).unwrap();
        for round in 0..10 {
            let (old, facets) = (body.mesh.clone(), body.contact.facets.clone());
            let size = |(i, facet): (usize, &[u32; 3])| match (i * 7919 + round * 104_729) % 53 {
                0..8 => 0.6 * longest(&old.vertices, &facet[..dim]),
                _ => f64::INFINITY,
            };
            let sizes: Vec<f64> = facets.iter().enumerate().map(size).collect();
            body.refine_contact(&sizes).unwrap();
            check(&body);
            assert_eq!(body.mesh.vertices[..old.n_vertices()], old.vertices);
        }
        let coarse = body_mesh(&BodyParams { dim, ..THESIS }, &coarse).unwrap();
        assert!(body.contact.facets.len() > coarse.contact.facets.len());
    }
}

/// Distances against the nearest of many points of each zone.
#[test]
fn zone_distances() {
    let center = [0.3, -0.2, 0.1];
    let turn = |i: usize| (2.0 * std::f64::consts::PI * i as f64 / 20_000.0).sin_cos();
    let on_circle = |radius: f64, x_min: f64| -> Vec<[f64; 3]> {
        let all = (0..20_000)
            .map(turn)
            .map(|(s, c)| [center[0] + radius * c, center[1] + radius * s, center[2]]);
        all.filter(|x| x[0] >= x_min).collect()
    };
    let nearest = |points: &[[f64; 3]], x: [f64; 3]| {
        let d = points
            .iter()
            .map(|p| (0..3).map(|k| (p[k] - x[k]).powi(2)).sum::<f64>().sqrt());
        d.fold(f64::INFINITY, f64::min)
    };
    for i in 0..60_usize {
        let x = [3, 5, 7].map(|p: usize| ((i * p * p + 1) % 41) as f64 / 10.0 - 2.0);
        for x_min in [f64::NEG_INFINITY, 0.0, 0.7] {
            let arc = Zone::Arc {
                center,
                radius: 1.0,
                half_width: 0.15,
                x_min,
            };
            let in_plane = nearest(&on_circle(1.0, x_min), [x[0], x[1], center[2]]);
            let expected = (in_plane - 0.15).max(0.0).hypot(x[2] - center[2]);
            approx::assert_abs_diff_eq!(arc.distance(x), expected, epsilon = 1e-3);
        }
        // to the rim of a disc unless straight above
        let rho = (x[0] - center[0]).hypot(x[1] - center[1]);
        let disc = if rho > 0.8 {
            nearest(&on_circle(0.8, f64::NEG_INFINITY), x)
        } else {
            (x[2] - center[2]).abs()
        };
        approx::assert_abs_diff_eq!(
            Zone::Disc {
                center,
                radius: 0.8
            }
            .distance(x),
            disc,
            epsilon = 1e-3
        );
        let (min, max) = ([-1.0, -0.5, -0.4], [0.5, 0.2, -0.4]);
        let clamped = [0, 1, 2].map(|k: usize| x[k].clamp(min[k], max[k]));
        approx::assert_abs_diff_eq!(
            Zone::Box { min, max }.distance(x),
            nearest(&[clamped], x),
            epsilon = 1e-14
        );
    }
    let beyond = Zone::Arc {
        center,
        radius: 1.0,
        half_width: 0.1,
        x_min: 1.4,
    };
    assert_eq!(beyond.distance(ORIGIN), f64::INFINITY);
}

#[test]
fn errors_name_the_culprit() {
    let unit = |_: [f64; 3]| 1.0;
    let name = |p: BodyParams| match body_mesh(&p, &unit) {
        Err(MeshError::Parameter { name, .. }) => name,
        other => panic!("{:?}", other.map(|b| b.mesh.n_cells())),
    };
    let changed = |change: fn(&mut BodyParams)| {
        let mut params = THESIS;
        change(&mut params);
        name(params)
    };
    assert_eq!(changed(|p| p.dim = 4), "dim");
    assert_eq!(changed(|p| p.width = f64::NAN), "width");
    assert_eq!(changed(|p| p.depth = 0.0), "depth");
    assert_eq!(changed(|p| p.x_inlet = -31.0), "x_inlet");
    for x_outlet in [-5.0, 30.1, f64::NAN] {
        assert_eq!(name(BodyParams { x_outlet, ..THESIS }), "x_outlet");
    }
    assert_eq!(changed(|p| p.y_side = 0.0), "y_side");
    let negative = body_mesh(&THESIS, &|x| x[2] + 1.0);
    assert!(matches!(negative, Err(MeshError::Size { value, .. }) if value <= 0.0));
    let flat = body_mesh(
        &BodyParams {
            width: 1e5,
            depth: 0.01,
            ..THESIS
        },
        &unit,
    );
    assert!(
        matches!(flat, Err(MeshError::Proportions { .. })),
        "{:?}",
        flat.map(|b| b.mesh.n_cells())
    );
}
