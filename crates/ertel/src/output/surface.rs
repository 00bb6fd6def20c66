//! The whole contact area from the part that is solved.

use crate::contact::Symmetry;
use crate::solution::SurfaceField;

/// A half y ≤ 0 with its mirror image, nodes on y = 0 shared.
pub(super) struct Mirrored {
    /// Points: those of the half first.
    pub points: Vec<[f64; 2]>,
    /// Triangles: those of the half first.
    pub cells: Vec<[u32; 3]>,
    /// For each point, the point of the half that has its values.
    pub sources: Vec<usize>,
}

/// The half y ≤ 0 with its mirror image.
pub(super) fn mirror(points: &[[f64; 2]], cells: &[[u32; 3]]) -> Mirrored {
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

/// Whether a number among others counts as zero, for all that rounding does.
pub(super) fn near_zero(all: impl Iterator<Item = f64>) -> impl Fn(f64) -> bool {
    let reach = all.fold(0.0, |r: f64, v| r.max(v.abs()));
    move |v| v.abs() <= 1e-9 * reach
}

/// Fields on the whole contact area: a half y ≤ 0 with its mirror image, nodes on y = 0 shared; one that was solved whole as
/// it is.
pub(super) fn full_surface(symmetry: Symmetry, half: &SurfaceField) -> SurfaceField {
    let mut full = half.clone();
    if symmetry == Symmetry::Full {
        return full;
    }
    let whole = mirror(&half.points, &half.cells);
    for i in &whole.sources[half.points.len()..] {
        full.pressure.push(half.pressure[*i]);
        full.film_thickness.push(half.film_thickness[*i]);
        full.deflection.push(half.deflection[*i]);
        full.viscosity.push(half.viscosity[*i]);
        full.density.push(half.density[*i]);
        full.shear.repeat(*i);
    }
    (full.points, full.cells) = (whole.points, whole.cells);
    full
}

/// For each point of the whole contact area, the point of the part that is solved that has its values.
pub(super) fn sources(symmetry: Symmetry, half: &SurfaceField) -> Vec<usize> {
    match symmetry {
        Symmetry::Full => (0..half.points.len()).collect(),
        Symmetry::Half => mirror(&half.points, &[]).sources,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solution::ShearFields;

    /// One triangle with an edge on y = 0: four nodes, two triangles of the same orientation.
    #[test]
    fn mirror_shares_the_centreline() {
        let values = vec![1.0, 2.0, 3.0];
        let half = SurfaceField {
            points: vec![[0.0, 0.0], [0.0, -1.0], [1.0, 0.0]],
            cells: vec![[0, 1, 2]],
            pressure: values.clone(),
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
        };
        let full = full_surface(Symmetry::Half, &half);
        assert_eq!(full.points[3], [0.0, 1.0]);
        assert_eq!(full.cells, [[0, 1, 2], [0, 2, 3]]);
        assert_eq!(full.density, [1.0, 2.0, 3.0, 2.0]);
        for (_, values) in full.shear.columns() {
            assert_eq!(values, [1.0, 2.0, 3.0, 2.0]);
        }
        assert_eq!(sources(Symmetry::Half, &half), [0, 1, 2, 1]);
        assert_eq!(sources(Symmetry::Full, &half), [0, 1, 2]);
        assert_eq!(full_surface(Symmetry::Full, &half), half);
    }
}
