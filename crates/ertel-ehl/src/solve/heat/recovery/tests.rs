//! Known fields on graded meshes.

use approx::assert_relative_eq;

use ertel_fem::mesh::{SimplexMesh, SurfaceParams, surface_mesh};
use rustc_hash::FxHashMap;

use super::*;

/// [−2, 1] × [−1.5, 0] or [−2, 1] with cells of a size around (0.3, 0), growing to thrice that away from it.
fn graded(dim: usize, size: f64) -> SimplexMesh {
    graded_to(dim, size, 0.0)
}

/// The same up to another y.
fn graded_to(dim: usize, size: f64, top: f64) -> SimplexMesh {
    let params = SurfaceParams {
        dim,
        x: [-2.0, 1.0],
        y: [-1.5, top],
    };
    let field = |[x, y]: [f64; 2]| size * (1.0 + (x - 0.3).hypot(y)).min(3.0);
    surface_mesh(&params, &field).unwrap().mesh().clone()
}

/// Values of a function at points.
fn at(points: &[[f64; 3]], f: &dyn Fn([f64; 2]) -> f64) -> Vec<f64> {
    points.iter().map(|p| f([p[0], p[1]])).collect()
}

/// Largest errors of the linear elements and of the recovered cubics, at the nodes of these.
fn errors(mesh: &SimplexMesh, f: &dyn Fn([f64; 2]) -> f64) -> [f64; 2] {
    errors_of(mesh, Symmetry::Half, f)
}

/// The same of a contact that is symmetric about y = 0 or not.
fn errors_of(mesh: &SimplexMesh, symmetry: Symmetry, f: &dyn Fn([f64; 2]) -> f64) -> [f64; 2] {
    let (space, fine) = (Space::new(mesh, 1), Space::new(mesh, ORDER));
    let (nodal, exact) = (at(&space.points, f), at(&fine.points, f));
    let cubics = Recovery::new(&space, symmetry).cubics(&nodal);
    let n = fine.element.n_nodes();
    let mut errors = [0.0_f64; 2];
    for cell in 0..space.n_elements() {
        for (k, xi) in fine.element.points().enumerate() {
            let truth = exact[fine.nodes_of(cell)[k] as usize];
            let linear: f64 = (space.element.values(xi).zip(space.nodes_of(cell)))
                .map(|(shape, node)| shape * nodal[*node as usize])
                .sum();
            errors[0] = errors[0].max((linear - truth).abs());
            errors[1] = errors[1].max((cubics[cell * n + k] - truth).abs());
        }
    }
    errors
}

/// Quadratics, symmetric about y = 0, are reproduced, at the edges of the mesh as well.
#[test]
fn quadratics_are_reproduced() {
    for dim in [1, 2] {
        let mesh = graded(dim, 0.2);
        let [linear, recovered] =
            errors(&mesh, &|[x, y]| 300.0 + 2.0 * x - 3.0 * x * x + 0.5 * y * y);
        assert!(linear > 0.01, "dimension {dim}: {linear}");
        assert!(recovered < 1e-10, "dimension {dim}: {recovered}");
    }
}

/// On a whole contact, quadratics that grow across y = 0 are reproduced as well: along that line, where the mesh has nodes
/// or cells across it, and everywhere else.
#[test]
fn whole_contacts_have_gradients_across() {
    let field = |[x, y]: [f64; 2]| 300.0 + 2.0 * x - 7.0 * y + x * y - 3.0 * x * x + 0.5 * y * y;
    for top in [1.5, 0.0] {
        let mesh = graded_to(2, 0.2, top);
        let [linear, recovered] = errors_of(&mesh, Symmetry::Full, &field);
        assert!(linear > 0.01, "to {top}: {linear}");
        assert!(recovered < 1e-10, "to {top}: {recovered}");
    }
    // Mirrored at y = 0, that slope would be lost.
    let [_, mirrored] = errors_of(&graded(2, 0.2), Symmetry::Half, &field);
    assert!(mirrored > 0.1, "{mirrored}");
}

/// With the gradients given, Hermite's polynomials: x³ on segments, by hand; quadratics on triangles, whatever their symmetry.
#[test]
fn given_gradients_make_cubics() {
    let mesh = graded(1, 0.3);
    let (space, fine) = (Space::new(&mesh, 1), Space::new(&mesh, ORDER));
    let values = at(&space.points, &|[x, _]| x.powi(3));
    let gradients: Vec<[f64; 2]> = space
        .points
        .iter()
        .map(|p| [3.0 * p[0] * p[0], 0.0])
        .collect();
    let cubics = Recovery::new(&space, Symmetry::Half).cubics_of(&values, &gradients);
    for (value, node) in cubics.iter().zip(&fine.element_nodes) {
        assert_relative_eq!(
            *value,
            fine.points[*node as usize][0].powi(3),
            epsilon = 1e-12
        );
    }
    let mesh = graded(2, 0.3);
    let (space, fine) = (Space::new(&mesh, 1), Space::new(&mesh, ORDER));
    let values = at(&space.points, &|[x, y]| x * x + x * y - y);
    let gradients: Vec<[f64; 2]> = space
        .points
        .iter()
        .map(|[x, y, _]| [2.0 * x + y, x - 1.0])
        .collect();
    let cubics = Recovery::new(&space, Symmetry::Half).cubics_of(&values, &gradients);
    for (value, node) in cubics.iter().zip(&fine.element_nodes) {
        let [x, y, _] = fine.points[*node as usize];
        assert_relative_eq!(*value, x * x + x * y - y, epsilon = 1e-12);
    }
}

/// Halved cells leave a quarter of the error of linear elements, and a sixth or less of the recovered fields'.
#[test]
fn smooth_fields_converge_faster() {
    let wave = |[x, y]: [f64; 2]| (2.0 * x).cos() * (1.5 * y).cos();
    for dim in [1, 2] {
        let [coarse, fine] = [0.1, 0.05].map(|size| errors(&graded(dim, size), &wave));
        let [linear, recovered] = [0, 1].map(|k: usize| coarse[k] / fine[k]);
        assert!((3.0..5.0).contains(&linear), "dimension {dim}: {linear}");
        assert!(recovered > 6.0, "dimension {dim}: {recovered}");
        assert!(fine[1] < 0.2 * fine[0], "dimension {dim}: {fine:?}");
    }
}

/// Neighbours have the same values on the edges they share, also of a field with a jump.
#[test]
fn neighbours_agree_on_edges() {
    let mesh = graded(2, 0.2);
    let (space, fine) = (Space::new(&mesh, 1), Space::new(&mesh, ORDER));
    let values = at(&space.points, &|[x, y]| if x > 0.3 * y { 1.0 } else { x });
    let cubics = Recovery::new(&space, Symmetry::Half).cubics(&values);
    let mut seen: FxHashMap<u32, f64> = FxHashMap::default();
    let mut shared = 0;
    for (value, node) in cubics.iter().zip(&fine.element_nodes) {
        if let Some(other) = seen.insert(*node, *value) {
            assert!((other - value).abs() < 1e-13);
            shared += 1;
        }
    }
    assert!(shared > space.n_elements());
}
