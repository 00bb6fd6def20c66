//! Elements that share a side.

use rustc_hash::FxHashMap;

use ertel_fem::mesh::SimplexMesh;

/// Neighbours of each element.
pub(super) fn neighbours(surface: &SimplexMesh) -> Vec<Vec<u32>> {
    let mut sides: FxHashMap<[u32; 2], u32> = FxHashMap::default();
    let mut of = vec![Vec::with_capacity(surface.dim + 1); surface.n_cells()];
    for c in 0..surface.n_cells() {
        let cell = surface.cell(c);
        for (i, &a) in cell.iter().enumerate() {
            for &b in &cell[i + 1..] {
                // a segment's sides are its ends, a triangle's its edges
                let keys = if surface.dim == 1 {
                    [Some([a, a]), Some([b, b])]
                } else {
                    [Some([a.min(b), a.max(b)]), None]
                };
                for key in keys.into_iter().flatten() {
                    if let Some(other) = sides.insert(key, c as u32) {
                        of[c].push(other);
                        of[other as usize].push(c as u32);
                    }
                }
            }
        }
    }
    of
}
