//! Fields over the whole contact area, with their mirror image where half of it is solved.

use super::point_fields::asperity_column;
use super::{Field, FilmTemperatures, Solution, SurfaceField};
use crate::contact::{Shape, Symmetry};

/// Fields at the points of the whole contact area, SI.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ContactFields {
    /// Points, m; y = 0 in line contacts.
    pub points: Vec<[f64; 2]>,
    /// Triangles by their corners, all of one orientation; in line contacts segments in the first two entries.
    pub cells: Vec<[u32; 3]>,
    /// The fields that the contact has, each with its values at the points.
    pub fields: Vec<(Field, Vec<f64>)>,
    /// Whether points lie on a line, and cells are segments.
    pub is_line: bool,
}

/// Values on a regular grid.
#[derive(Clone, Debug, PartialEq)]
pub struct GridField {
    /// Which field.
    pub field: Field,
    /// Values, `[iy * nx + ix]`; not a number outside the contact area.
    pub values: Vec<f64>,
}

impl Solution {
    /// Fields over the whole contact area.
    pub fn fields(&self) -> ContactFields {
        let temperatures = self.thermal.as_ref().map(|thermal| &thermal.surface);
        ContactFields::new(&self.shape, &self.surface, temperatures)
    }
}

impl ContactFields {
    /// Of the part that is solved.
    pub fn new(
        shape: &Shape,
        part: &SurfaceField,
        temperatures: Option<&FilmTemperatures>,
    ) -> ContactFields {
        let whole = match shape.symmetry {
            Symmetry::Full => None,
            Symmetry::Half => Some(mirror(&part.points, &part.cells)),
        };
        let values = |own: &[f64]| match &whole {
            None => own.to_vec(),
            Some(whole) => whole.sources.iter().map(|i| own[*i]).collect(),
        };
        let fields = (Self::columns(part, temperatures).into_iter())
            .map(|(field, own)| (field, values(own)))
            .collect();
        let (points, cells) = match whole {
            None => (part.points.clone(), part.cells.clone()),
            Some(whole) => (whole.points, whole.cells),
        };
        ContactFields {
            points,
            cells,
            fields,
            is_line: shape.is_line(),
        }
    }

    /// The fields of the part that is solved, each with its values at its points.
    pub fn columns<'a>(
        part: &'a SurfaceField,
        temperatures: Option<&'a FilmTemperatures>,
    ) -> Vec<(Field, &'a [f64])> {
        let mut columns: Vec<(Field, &[f64])> = vec![
            (Field::Pressure, &part.pressure),
            (Field::FilmThickness, &part.film_thickness),
            (Field::Deflection, &part.deflection),
            (Field::Viscosity, &part.viscosity),
            (Field::Density, &part.density),
        ];
        columns.extend(asperity_column(&part.asperity_pressure));
        columns.extend(part.shear.columns());
        columns.extend(temperatures.into_iter().flat_map(FilmTemperatures::columns));
        columns
    }

    /// Values of a field at the points; `None` where the contact has none.
    pub fn values(&self, field: Field) -> Option<&[f64]> {
        let (_, values) = self.fields.iter().find(|(own, _)| *own == field)?;
        Some(values)
    }

    /// All fields at the crossings of `x` and `y`, m, both ascending, by linear interpolation in the cells; not a number outside the
    /// contact area. In line contacts `y` is not looked at, and there is one row.
    pub fn on_grid(&self, x: &[f64], y: &[f64]) -> Vec<GridField> {
        let n_rows = if self.is_line { 1 } else { y.len() };
        let mut grids: Vec<GridField> = (self.fields.iter())
            .map(|(field, _)| GridField {
                field: *field,
                values: vec![f64::NAN; x.len() * n_rows],
            })
            .collect();
        let mut put = |at: usize, corners: &[(u32, f64)]| {
            for (grid, (_, values)) in grids.iter_mut().zip(&self.fields) {
                let shares = corners
                    .iter()
                    .map(|(corner, share)| share * values[*corner as usize]);
                grid.values[at] = shares.sum();
            }
        };
        for cell in &self.cells {
            let n_corners = if self.is_line { 2 } else { 3 };
            let corners = cell.map(|c| self.points[c as usize]);
            let reach = |axis: usize, values: &[f64]| {
                let all = corners[..n_corners].iter().map(|p| p[axis]);
                let low = all.clone().fold(f64::INFINITY, f64::min);
                let high = all.fold(f64::NEG_INFINITY, f64::max);
                values.partition_point(|v| *v < low)..values.partition_point(|v| *v <= high)
            };
            let columns = reach(0, x);
            if self.is_line {
                let [a, b] = [corners[0][0], corners[1][0]];
                for i in columns {
                    let share = (x[i] - a) / (b - a);
                    put(i, &[(cell[0], 1.0 - share), (cell[1], share)]);
                }
                continue;
            }
            for j in reach(1, y) {
                for i in columns.clone() {
                    let shares = barycentric(&corners, [x[i], y[j]]);
                    if shares.iter().all(|share| *share >= -ON_AN_EDGE) {
                        let corners = [0, 1, 2].map(|k: usize| (cell[k], shares[k]));
                        put(j * x.len() + i, &corners);
                    }
                }
            }
        }
        grids
    }
}

/// Barycentric coordinate below zero up to which a point counts as on an edge: a tolerance for rounding.
const ON_AN_EDGE: f64 = 1e-12;

fn barycentric([a, b, c]: &[[f64; 2]; 3], p: [f64; 2]) -> [f64; 3] {
    let cross = |u: [f64; 2], v: [f64; 2]| u[0] * v[1] - u[1] * v[0];
    let from = |q: &[f64; 2]| [p[0] - q[0], p[1] - q[1]];
    let side = |q: &[f64; 2]| [q[0] - a[0], q[1] - a[1]];
    let area = cross(side(b), side(c));
    let by_b = cross(from(a), side(c)) / area;
    let by_c = cross(side(b), from(a)) / area;
    [1.0 - by_b - by_c, by_b, by_c]
}

/// A half y ≤ 0 with its mirror image, nodes on y = 0 shared.
pub struct Mirrored {
    /// Points: those of the half first.
    pub points: Vec<[f64; 2]>,
    /// Triangles: those of the half first.
    pub cells: Vec<[u32; 3]>,
    /// For each point, the point of the half that has its values.
    pub sources: Vec<usize>,
}

/// The half y ≤ 0 with its mirror image.
pub fn mirror(points: &[[f64; 2]], cells: &[[u32; 3]]) -> Mirrored {
    let on_centreline = near_zero(points.iter().map(|p| p[1]));
    let mut whole = Mirrored {
        points: points.to_vec(),
        cells: cells.to_vec(),
        sources: (0..points.len()).collect(),
    };
    let mut image = Vec::with_capacity(points.len());
    for (i, [x, y]) in points.iter().enumerate() {
        if on_centreline(*y) {
            image.push(i as u32);
            continue;
        }
        image.push(whole.points.len() as u32);
        whole.points.push([*x, -y]);
        whole.sources.push(i);
    }
    // A mirror turns the orientation round; exchanging two corners turns it back
    let mirrored = (cells.iter()).map(|[a, b, c]| [*a, *c, *b].map(|n| image[n as usize]));
    whole.cells.extend(mirrored);
    whole
}

/// Whether a number is zero compared with others, within rounding.
pub fn near_zero(all: impl Iterator<Item = f64>) -> impl Fn(f64) -> bool {
    let reach = all.fold(0.0, |r: f64, v| r.max(v.abs()));
    move |v| v.abs() <= 1e-9 * reach
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solution::ShearFields;

    fn half() -> SurfaceField {
        // f = 1 + 2x - 3y on a square below y = 0
        let points = vec![[0.0, 0.0], [0.0, -1.0], [1.0, 0.0], [1.0, -1.0]];
        let values: Vec<f64> = points
            .iter()
            .map(|[x, y]| 1.0 + 2.0 * x - 3.0 * y)
            .collect();
        SurfaceField {
            points,
            cells: vec![[0, 1, 2], [1, 3, 2]],
            order: 1,
            elements: vec![0, 1, 2, 1, 3, 2],
            pressure: values.clone(),
            asperity_pressure: Vec::new(),
            film_thickness: values.clone(),
            deflection: values.clone(),
            viscosity: values.clone(),
            density: values.clone(),
            shear: ShearFields {
                stress_mid: values.clone(),
                stress_body_1: values.clone(),
                stress_body_2: values.clone(),
                stress_across: Default::default(),
                rate_mid: values.clone(),
                generalized_viscosity: values,
            },
        }
    }

    /// Six points and four triangles of one orientation from four and two.
    #[test]
    fn mirror_shares_the_centreline() {
        let whole = ContactFields::new(&Shape::CIRCULAR, &half(), None);
        assert_eq!(whole.points.len(), 6);
        assert_eq!(whole.points[4..], [[0.0, 1.0], [1.0, 1.0]]);
        for (_, values) in &whole.fields {
            assert_eq!(*values, [1.0, 4.0, 3.0, 6.0, 4.0, 6.0]);
        }
        let area = |cell: &[u32; 3]| {
            let [a, b, c] = cell.map(|i| whole.points[i as usize]);
            (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
        };
        assert!(whole.cells.iter().all(|cell| area(cell) == 1.0));
    }

    /// A field that is linear in each half comes back exactly; there is none outside.
    #[test]
    fn grids_by_linear_interpolation() {
        let whole = ContactFields::new(&Shape::CIRCULAR, &half(), None);
        let (x, y) = ([-0.5, 0.0, 0.3, 1.0], [-1.0, -0.25, 0.0, 0.7, 1.5]);
        let grids = whole.on_grid(&x, &y);
        assert_eq!(grids.len(), whole.fields.len());
        for (j, y) in y.iter().enumerate() {
            for (i, x) in x.iter().enumerate() {
                let value = grids[0].values[j * 4 + i];
                if *x < 0.0 || *y > 1.0 {
                    assert!(value.is_nan());
                } else {
                    let exact = 1.0 + 2.0 * x + 3.0 * y.abs();
                    assert!((value - exact).abs() < 1e-14, "{x} {y} {value}");
                }
            }
        }
    }

    /// Along a line.
    #[test]
    fn grids_of_line_contacts() {
        let line = SurfaceField {
            points: vec![[-1.0, 0.0], [0.0, 0.0], [2.0, 0.0]],
            cells: vec![[0, 1, 0], [1, 2, 0]],
            pressure: vec![0.0, 5.0, 1.0],
            ..SurfaceField::default()
        };
        let mut fields = ContactFields::new(&Shape::LINE, &line, None);
        fields.fields.truncate(1);
        let grid = &fields.on_grid(&[-2.0, -0.5, 0.0, 1.0], &[])[0];
        assert!(grid.values[0].is_nan());
        assert_eq!(grid.values[1..], [2.5, 5.0, 3.0]);
    }
}
