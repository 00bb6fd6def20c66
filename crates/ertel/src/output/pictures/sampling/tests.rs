//! Fields with known contours, on meshes much coarser than the picture.

use super::*;
use ertel_plot::contour::Triangulation;

/// Size of a pixel: 330 px over [−1, 1].
const PIXEL: f64 = 2.0 / 330.0;

/// A function on n × n squares over [−1, 1]², each divided in two, as polynomials of an order.
fn elements(n: usize, order: usize, f: impl Fn([f64; 2]) -> f64) -> (ElementFields, Polynomials) {
    let at = |i: usize| 2.0 * i as f64 / n as f64 - 1.0;
    let vertices: Vec<[f64; 2]> = (0..=n)
        .flat_map(|j| (0..=n).map(move |i| [at(i), at(j)]))
        .collect();
    let id = |i: usize, j: usize| (j * (n + 1) + i) as u32;
    let cells: Vec<[u32; 3]> = (0..n)
        .flat_map(|j| (0..n).map(move |i| (i, j)))
        .flat_map(|(i, j)| {
            [
                [id(i, j), id(i + 1, j), id(i + 1, j + 1)],
                [id(i, j + 1), id(i, j), id(i + 1, j + 1)],
            ]
        })
        .collect();
    let lagrange = Lagrange::new(2, order);
    let mut values = Vec::new();
    for cell in &cells {
        let [a, b, c] = cell.map(|v| vertices[v as usize]);
        for [s, t, _] in lagrange.points() {
            let x = |i: usize| a[i] + s * (b[i] - a[i]) + t * (c[i] - a[i]);
            values.push(f([x(0), x(1)]));
        }
    }
    let elements = ElementFields {
        dim: 2,
        vertices,
        cells,
        ..ElementFields::default()
    };
    (elements, Polynomials { order, values })
}

fn view(levels: &[f64]) -> View<'_> {
    View {
        unit: 1.0,
        window: [[-1.0, 1.0]; 2],
        pixel: PIXEL,
        factor: 1.0,
        levels,
    }
}

/// The contour lines of a level, as drawn.
fn level_lines(elements: &ElementFields, field: &Polynomials, level: f64) -> Vec<Vec<[f64; 2]>> {
    let sampling = Sampling::new(elements, field, &view(&[level]));
    let mesh = Triangulation::new(&sampling.points, &sampling.triangles);
    mesh.regions(&sampling.values, &[level])
        .remove(0)
        .level_lines
}

/// Largest distance, px, of a line, including points between its vertices, from a circle about the origin.
fn off_the_circle(line: &[[f64; 2]], radius: f64) -> f64 {
    let off = |[x, y]: [f64; 2]| (x.hypot(y) - radius).abs() / PIXEL;
    let between = line.windows(2).map(|w| {
        let [a, b] = [w[0], w[1]];
        off([0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])])
    });
    (line.iter().map(|p| off(*p)).chain(between)).fold(0.0, f64::max)
}

/// {r⁴ = 0.7⁴} on 18 elements: a closed circle within 0.2 px. Straight lines between the nodes of the same elements
/// deviate by more than a pixel.
#[test]
fn circle_on_a_coarse_mesh_is_round() {
    let quartic = |[x, y]: [f64; 2]| (x * x + y * y).powi(2);
    let level = 0.7_f64.powi(4);
    for order in [4, 5] {
        let (fields, polynomials) = elements(3, order, quartic);
        let lines = level_lines(&fields, &polynomials, level);
        assert_eq!(lines.len(), 1);
        assert_eq!(lines[0].first(), lines[0].last());
        let off = off_the_circle(&lines[0], 0.7);
        assert!(off < 0.2, "order {order}: {off} px");
        let (fields, polynomials) = elements(3 * order, 1, quartic);
        let off = off_the_circle(&level_lines(&fields, &polynomials, level)[0], 0.7);
        assert!(off > 1.0, "nodes of order {order}: {off} px");
    }
    let (fields, polynomials) = elements(3, 3, |[x, y]| x * x + y * y);
    let lines = level_lines(&fields, &polynomials, 0.49);
    assert!(off_the_circle(&lines[0], 0.7) < 0.2);
}

/// T₅(x) on two elements: ridges of height 1 at cos(2π/5) and cos(4π/5) between nodes at which it is 0.85 and 0.08 at
/// the most. The sides of {T₅ ≥ 0.9} are at cos((2πk ± arccos 0.9)/5).
#[test]
fn ridges_between_nodes_are_seen() {
    let (fields, polynomials) =
        elements(1, 5, |[x, _]| 16.0 * x.powi(5) - 20.0 * x.powi(3) + 5.0 * x);
    let mut found: Vec<f64> = level_lines(&fields, &polynomials, 0.9)
        .iter()
        .map(|line| {
            let x: Vec<f64> = line.iter().map(|p| p[0]).collect();
            let mean = x.iter().sum::<f64>() / x.len() as f64;
            let straight = x.iter().all(|x| (x - mean).abs() < 0.2 * PIXEL);
            assert!(straight, "{x:?}");
            mean
        })
        .collect();
    found.sort_by(f64::total_cmp);
    let half = 0.9_f64.acos();
    let turn = std::f64::consts::TAU;
    let sides = [2.0 * turn - half, turn + half, turn - half]
        .map(|angle| angle / 5.0)
        .map(f64::cos);
    let sides = [
        ((2.0 * turn + half) / 5.0).cos(),
        sides[0],
        sides[1],
        sides[2],
    ];
    for (found, side) in found.iter().zip(sides) {
        assert!((found - side).abs() < 0.2 * PIXEL, "{found} {side}");
    }
    // The fifth bounds the rise to 1 at x = 1
    assert_eq!(found.len(), 5);
}

/// Pieces of very different sizes: edges not shared by two of them form the boundary of the square, of length 8; the pieces
/// cover it, and edges are at most 3 px long.
#[test]
fn fine_and_coarse_pieces_fit_together() {
    let (fields, polynomials) = elements(2, 5, |[x, y]| (x + 0.3 * y).powi(5));
    // The smallest are where the field is flat: contours are sensitive there
    let levels = [1e-7, 1e-6, 1e-5, 0.1, 0.2, 0.3];
    let sampling = Sampling::new(&fields, &polynomials, &view(&levels));
    let area: f64 = (sampling.triangles.iter())
        .map(|t| {
            let [a, b, c] = t.map(|i| sampling.points[i as usize]);
            0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])).abs()
        })
        .sum();
    assert!((area - 4.0).abs() < 1e-12, "{area}");
    let mesh = Triangulation::new(&sampling.points, &sampling.triangles);
    let whole = mesh.whole(&sampling.values);
    assert_eq!(whole.loops.len(), 1);
    let (mut around, mut lengths) = (0.0, Vec::new());
    for side in whole.loops[0].windows(2) {
        let length = (side[1][0] - side[0][0]).hypot(side[1][1] - side[0][1]);
        around += length;
        lengths.push(length / PIXEL);
    }
    assert!((around - 8.0).abs() < 1e-12, "{around}");
    let (shortest, longest) = lengths
        .iter()
        .fold((f64::INFINITY, 0.0_f64), |(s, l), v| (s.min(*v), l.max(*v)));
    assert!(
        longest <= LONGEST && shortest < 0.6 * longest,
        "{shortest} {longest}"
    );
}

/// Elements outside the window are omitted, and adjacent ones are divided only within it.
#[test]
fn elements_outside_the_window_are_not_divided() {
    let (fields, polynomials) = elements(4, 3, |[x, y]| x * x + y * y);
    let near = View {
        window: [[0.1, 0.4], [0.1, 0.4]],
        ..view(&[0.1])
    };
    let sampling = Sampling::new(&fields, &polynomials, &near);
    let everywhere = Sampling::new(&fields, &polynomials, &view(&[0.1]));
    assert!(sampling.triangles.len() * 10 < everywhere.triangles.len());
    let enlarged = View {
        pixel: 0.01 * PIXEL,
        ..view(&[0.1])
    };
    let most = Sampling::new(&fields, &polynomials, &enlarged);
    assert!(most.triangles.len() <= MOST);
}
