//! Mesh thinning for a page: removes the nodes of a triangle mesh that linear interpolation between the others reproduces.
//!
//! A node is removed by sliding onto a neighbour, if all removed nodes in the new triangles stay within the tolerance
//! (Schroeder, Zarge & Lorensen 1992, Computer Graphics 26(2), 65-70: decimation of triangle meshes).

/// Smallest ratio of twice a triangle's area to the square of its longest edge: no triangle becomes flatter.
const FLATTEST: f64 = 0.05;

/// Negative barycentric coordinate down to which a point counts as on an edge, to allow for rounding.
const ON_AN_EDGE: f64 = 1e-9;

/// Maximum number of rounds.
const MOST_ROUNDS: usize = 30;

/// A field at the nodes, with the tolerance at each.
pub(super) struct Bounded<'a> {
    /// Values.
    pub values: &'a [f64],
    /// Tolerance of linear interpolation, in the unit of the values.
    pub tolerance: Vec<f64>,
}

/// The remaining triangles, by their nodes. Nodes marked in `stays` and those on the edge are kept.
pub(super) fn thin(
    points: &[[f64; 2]],
    cells: &[[u32; 3]],
    fields: &[Bounded],
    stays: &[bool],
) -> Vec<[u32; 3]> {
    let mut mesh = Mesh::new(points, cells, fields);
    let mut fixed = mesh.edge();
    fixed.iter_mut().zip(stays).for_each(|(f, s)| *f |= *s);
    // A node that could not be removed is tried again only after its surroundings have changed.
    let mut stuck = fixed.clone();
    for _ in 0..MOST_ROUNDS {
        // Neighbours of a removed node wait for the next round, which thins all regions alike.
        let mut waits = vec![false; points.len()];
        let mut n_removed = 0;
        for node in 0..points.len() {
            if waits[node] || stuck[node] {
                continue;
            }
            stuck[node] = true;
            if mesh.remove(node as u32) {
                n_removed += 1;
                for around in &mesh.around {
                    let around = *around as usize;
                    waits[around] = true;
                    stuck[around] = fixed[around];
                }
            }
        }
        if 100 * n_removed <= mesh.n_remaining {
            break;
        }
    }
    mesh.cells.into_iter().flatten().collect()
}

struct Mesh<'a> {
    points: &'a [[f64; 2]],
    fields: &'a [Bounded<'a>],
    cells: Vec<Option<[u32; 3]>>,
    /// Cells of each node; empty for removed nodes.
    of_node: Vec<Vec<u32>>,
    /// Removed nodes, by the cell that contains them.
    inside: Vec<Vec<u32>>,
    /// Number of remaining nodes.
    n_remaining: usize,
    /// Nodes around the last one examined.
    around: Vec<u32>,
    /// The attempted removal: its removed nodes, the new cells, and the cell that contains each removed node.
    removed: Vec<u32>,
    moved: Vec<[u32; 3]>,
    places: Vec<usize>,
}

impl<'a> Mesh<'a> {
    fn new(points: &'a [[f64; 2]], cells: &[[u32; 3]], fields: &'a [Bounded<'a>]) -> Mesh<'a> {
        // Corners counterclockwise.
        let turned = |[a, b, c]: [u32; 3]| match twice_area([a, b, c].map(|n| points[n as usize])) {
            area if area < 0.0 => [a, c, b],
            _ => [a, b, c],
        };
        let mut of_node = vec![Vec::new(); points.len()];
        for (c, cell) in cells.iter().enumerate() {
            cell.iter()
                .for_each(|n| of_node[*n as usize].push(c as u32));
        }
        let n_remaining = of_node.iter().filter(|own| !own.is_empty()).count();
        Mesh {
            points,
            fields,
            cells: cells.iter().map(|cell| Some(turned(*cell))).collect(),
            of_node,
            inside: vec![Vec::new(); cells.len()],
            n_remaining,
            around: Vec::new(),
            removed: Vec::new(),
            moved: Vec::new(),
            places: Vec::new(),
        }
    }

    fn cell(&self, c: u32) -> [u32; 3] {
        cell(&self.cells, c)
    }

    /// Whether each node is on the edge of the mesh: the triangles around it do not close.
    fn edge(&mut self) -> Vec<bool> {
        let mut is_on_edge = Vec::with_capacity(self.points.len());
        for (node, own) in self.of_node.iter().enumerate() {
            note_around(&self.cells, own, node as u32, &mut self.around);
            is_on_edge.push(own.is_empty() || self.around.len() != own.len());
        }
        is_on_edge
    }

    /// Removes a node if it can slide onto a neighbour.
    fn remove(&mut self, node: u32) -> bool {
        let own = std::mem::take(&mut self.of_node[node as usize]);
        note_around(&self.cells, &own, node, &mut self.around);
        let of = own.iter().flat_map(|c| &self.inside[*c as usize]);
        self.removed.clear();
        self.removed.extend(of);
        self.removed.push(node);
        let goes = (0..self.around.len()).any(|n| self.slides(node, &own, self.around[n]));
        if goes {
            self.replace(node, &own);
        } else {
            self.of_node[node as usize] = own;
        }
        goes
    }

    /// Whether a node can slide onto another; the new cells are then stored.
    fn slides(&mut self, node: u32, own: &[u32], onto: u32) -> bool {
        self.moved.clear();
        for c in own {
            let cell = self.cell(*c);
            if !cell.contains(&onto) {
                let moved = cell.map(|n| if n == node { onto } else { n });
                self.moved.push(moved);
            }
        }
        if !self.moved.iter().all(|cell| self.is_sound(cell)) {
            return false;
        }
        let mut places = std::mem::take(&mut self.places);
        places.clear();
        let found = self
            .removed
            .iter()
            .map_while(|n| self.place(*n, &self.moved));
        places.extend(found);
        self.places = places;
        self.places.len() == self.removed.len()
    }

    fn is_sound(&self, cell: &[u32; 3]) -> bool {
        let corners = cell.map(|n| self.points[n as usize]);
        let length = |i: usize| {
            let (p, q) = (corners[i], corners[(i + 1) % 3]);
            (q[0] - p[0]).powi(2) + (q[1] - p[1]).powi(2)
        };
        let longest = length(0).max(length(1)).max(length(2));
        twice_area(corners) > FLATTEST * longest
    }

    /// Index of the first cell that contains a node, if all fields there are within the tolerance.
    fn place(&self, node: u32, cells: &[[u32; 3]]) -> Option<usize> {
        let p = self.points[node as usize];
        let of = |cell: &[u32; 3]| shares(cell.map(|n| self.points[n as usize]), p);
        let mut found = cells.iter().map(of).enumerate();
        let (place, shares) = found.find(|(_, s)| s.iter().all(|s| *s >= -ON_AN_EDGE))?;
        let is_near = |field: &Bounded| {
            let own = field.values[node as usize];
            let corners = cells[place].iter().zip(shares);
            let value: f64 = corners.map(|(n, s)| s * field.values[*n as usize]).sum();
            (value - own).abs() <= field.tolerance[node as usize]
        };
        self.fields.iter().all(is_near).then_some(place)
    }

    /// Replaces the old cells of a removed node with the new ones.
    fn replace(&mut self, node: u32, own: &[u32]) {
        for c in own {
            for n in self.cell(*c).into_iter().filter(|n| *n != node) {
                self.of_node[n as usize].retain(|other| other != c);
            }
            self.cells[*c as usize] = None;
            self.inside[*c as usize].clear();
        }
        // New cells reuse the indices of old ones, in order.
        for (c, cell) in own.iter().zip(&self.moved) {
            self.cells[*c as usize] = Some(*cell);
            cell.iter().for_each(|n| self.of_node[*n as usize].push(*c));
        }
        for (n, place) in self.removed.iter().zip(&self.places) {
            self.inside[own[*place] as usize].push(*n);
        }
        self.n_remaining -= 1;
    }
}

fn cell(cells: &[Option<[u32; 3]>], c: u32) -> [u32; 3] {
    cells[c as usize].expect("cells of nodes are there")
}

/// Stores the nodes around a node, given its cells, each once.
fn note_around(cells: &[Option<[u32; 3]>], own: &[u32], node: u32, around: &mut Vec<u32>) {
    around.clear();
    let of = own.iter().flat_map(|c| cell(cells, *c));
    around.extend(of.filter(|n| *n != node));
    around.sort_unstable();
    around.dedup();
}

/// Whether a point is inside a triangle or on its edge.
pub(super) fn contains(corners: [[f64; 2]; 3], p: [f64; 2]) -> bool {
    shares(corners, p).iter().all(|s| *s >= -ON_AN_EDGE)
}

/// Barycentric coordinates of a point.
fn shares([a, b, c]: [[f64; 2]; 3], p: [f64; 2]) -> [f64; 3] {
    let whole = twice_area([a, b, c]);
    [[p, b, c], [a, p, c], [a, b, p]].map(|part| twice_area(part) / whole)
}

/// Twice the area of a triangle, positive for counterclockwise corners.
fn twice_area([a, b, c]: [[f64; 2]; 3]) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A square of n × n cells over [-1, 1]².
    fn square(n: usize) -> (Vec<[f64; 2]>, Vec<[u32; 3]>) {
        let at = |i: usize| 2.0 * i as f64 / n as f64 - 1.0;
        let points = (0..=n)
            .flat_map(|j| (0..=n).map(move |i| [at(i), at(j)]))
            .collect();
        let node = |i: usize, j: usize| (j * (n + 1) + i) as u32;
        let cells = (0..n).flat_map(|j| {
            (0..n).flat_map(move |i| {
                let [a, b, c, d] = [
                    node(i, j),
                    node(i + 1, j),
                    node(i + 1, j + 1),
                    node(i, j + 1),
                ];
                [[a, b, c], [a, c, d]]
            })
        });
        (points, cells.collect())
    }

    /// Hertz pressure √(1 - r²): flat in the middle, steep at the rim. The remaining triangles cover the same area, reproduce the
    /// removed nodes within the tolerance, and keep the marked nodes.
    #[test]
    fn removed_nodes_are_within_the_tolerance() {
        let (points, cells) = square(80);
        let values: Vec<f64> = (points.iter())
            .map(|p| (1.0 - p[0] * p[0] - p[1] * p[1]).max(0.0).sqrt())
            .collect();
        let tolerance = 2e-3;
        let field = Bounded {
            values: &values,
            tolerance: vec![tolerance; values.len()],
        };
        let mut stays = vec![false; points.len()];
        let centre = 40 * 81 + 40;
        stays[centre] = true;
        let left = thin(&points, &cells, &[field], &stays);
        let area: f64 = left
            .iter()
            .map(|cell| 0.5 * twice_area(cell.map(|n| points[n as usize])))
            .sum();
        assert!((area - 4.0).abs() < 1e-12, "{area}");
        assert!(left.iter().flatten().any(|n| *n as usize == centre));
        let mut nodes: Vec<u32> = left.iter().flatten().copied().collect();
        nodes.sort_unstable();
        nodes.dedup();
        assert!(3 * nodes.len() < points.len(), "{}", nodes.len());
        let mut worst = 0.0_f64;
        for (p, value) in points.iter().zip(&values) {
            let found = left.iter().find_map(|cell| {
                let shares = shares(cell.map(|n| points[n as usize]), *p);
                (shares.iter().all(|s| *s > -1e-9)).then(|| {
                    let corners = cell.iter().zip(shares);
                    corners.map(|(n, s)| s * values[*n as usize]).sum::<f64>()
                })
            });
            worst = worst.max((found.expect("no gaps") - value).abs());
        }
        assert!(worst <= tolerance * 1.000_001, "{worst}");
        assert!(worst > 0.3 * tolerance, "{worst}");
    }

    /// A plane needs only the edge, unless a triangle would become too flat.
    #[test]
    fn planes_need_few_nodes() {
        let (points, cells) = square(24);
        let values: Vec<f64> = points.iter().map(|p| 1.0 + 2.0 * p[0] - p[1]).collect();
        let field = Bounded {
            values: &values,
            tolerance: vec![1e-9; values.len()],
        };
        let left = thin(&points, &cells, &[field], &vec![false; points.len()]);
        let mut nodes: Vec<u32> = left.iter().flatten().copied().collect();
        nodes.sort_unstable();
        nodes.dedup();
        assert!(nodes.len() < 96 + 60, "{}", nodes.len());
    }
}
