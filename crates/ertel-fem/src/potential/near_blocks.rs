//! Entries of the near field: closed forms and Gauss sums over the elements around the targets of a leaf.
//!
//! ```text
//!   entry = ∫ N_j K  −  Σ_q w_q N_j K over the points that expansions include
//! ```

use std::ops::Range;

use pulp::{Arch, Simd, WithSimd};
use rayon::prelude::*;

use super::Kernel;
use super::integrals::{ElementIntegrals, POINTS};
use super::lanes::{Lanes, logarithms};
use super::number::Number;
use super::sources::Sources;
use super::tree::{Near, Tree};

/// Distance from an element, in its diameters, within which it is integrated in closed form.
const REACH: f64 = 0.5;

/// Distance from an element, in its diameters, beyond which Gauss sums take the place of closed forms: these lose digits like the
/// power of that distance that is the order of the density.
const FAR: f64 = 8.0;

/// An element near a leaf.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Around {
    element: u32,
    image: bool,
}

/// Buffers of one task.
#[derive(Default)]
pub struct Scratch {
    /// Nodes of the block.
    pub nodes: Vec<u32>,
    /// Coordinates of the targets: x, y and −y.
    points: [Vec<f64>; 3],
    work: Vec<f64>,
    entries: Vec<f64>,
    /// Column by column.
    columns: Vec<f64>,
    gauss: Vec<usize>,
}

/// Input of the blocks.
pub struct Builder<'a> {
    sources: &'a Sources<'a>,
    targets: &'a [[f64; 2]],
    tree: &'a Tree,
    integrals: &'a ElementIntegrals,
    /// Position of each source in the tree.
    position: Vec<u32>,
}

impl<'a> Builder<'a> {
    /// Nothing is computed yet.
    pub fn new(
        sources: &'a Sources<'a>,
        targets: &'a [[f64; 2]],
        tree: &'a Tree,
        integrals: &'a ElementIntegrals,
    ) -> Self {
        let mut position = vec![0u32; tree.source_order.len()];
        for (k, source) in tree.source_order.iter().enumerate() {
            position[*source as usize] = k as u32;
        }
        Builder {
            sources,
            targets,
            tree,
            integrals,
            position,
        }
    }

    /// Elements (and images) of which something is near each leaf: points of theirs in near boxes, or all of them
    /// within [`REACH`].
    pub fn elements_around(&self, near: &[Vec<Near>]) -> Vec<Vec<Around>> {
        let (sources, tree) = (self.sources, self.tree);
        let mut around: Vec<Vec<Around>> = vec![Vec::new(); near.len()];
        let images: &[bool] = if sources.mirrored {
            &[false, true]
        } else {
            &[false]
        };
        for element in 0..sources.n_elements() {
            let (low, high) = sources.bounds(element);
            let reach = REACH * (high[0] - low[0]).hypot(high[1] - low[1]);
            for image in images {
                let (bottom, top) = match image {
                    false => (low[1], high[1]),
                    true => (-high[1], -low[1]),
                };
                let corners = [
                    [low[0] - reach, bottom - reach],
                    [high[0] + reach, top + reach],
                ];
                tree.leaves_within(corners[0], corners[1], &mut |leaf| {
                    around[leaf].push(Around {
                        element: element as u32,
                        image: *image,
                    });
                });
            }
        }
        let per_element = sources.per_element() as u32;
        around.par_iter_mut().zip(near).for_each(|(around, near)| {
            for n in near {
                let mut last = u32::MAX;
                for s in &tree.source_order[tree.cells[n.from as usize].sources.clone()] {
                    // Points of an element stand together.
                    if s / per_element != last {
                        last = s / per_element;
                        around.push(Around {
                            element: last,
                            image: n.image,
                        });
                    }
                }
            }
            around.sort_unstable();
            around.dedup();
        });
        around
    }

    /// Whether an element is far from all of some points, x and y.
    fn is_far(&self, element: usize, [xs, ys]: [&[f64]; 2]) -> bool {
        let (low, high) = self.sources.bounds(element);
        let diameter = (high[0] - low[0]).hypot(high[1] - low[1]);
        let outside = |v: f64, k: usize| (low[k] - v).max(v - high[k]).max(0.0);
        (xs.iter().zip(ys)).all(|(x, y)| outside(*x, 0).hypot(outside(*y, 1)) > FAR * diameter)
    }

    /// Entries of a leaf's block, row by row; its nodes are left in `scratch`.
    pub fn block<S: Number>(
        &self,
        leaf: usize,
        near: &[Near],
        elements: &[Around],
        scratch: &mut Scratch,
    ) -> Vec<S> {
        let (sources, tree) = (self.sources, self.tree);
        let targets = &tree.target_order[tree.cells[leaf].targets.clone()];
        let direct = Direct::new(tree, near);
        let Scratch {
            nodes,
            points,
            work,
            entries,
            columns,
            gauss,
        } = scratch;
        nodes.clear();
        for around in elements {
            nodes.extend(sources.space.nodes_of(around.element as usize));
        }
        nodes.sort_unstable();
        nodes.dedup();
        // Whole vectors: the last target pads the places beyond.
        let n = targets.len().next_multiple_of(POINTS);
        points.iter_mut().for_each(Vec::clear);
        for k in 0..n {
            let [x, y] = self.targets[targets[k.min(targets.len() - 1)] as usize];
            (points.iter_mut().zip([x, y, -y])).for_each(|(points, v)| points.push(v));
        }
        entries.resize(sources.space.element.n_nodes() * n, 0.0);
        columns.clear();
        columns.resize(nodes.len() * n, 0.0);
        let per_element = sources.per_element();
        for around in elements {
            let element = around.element as usize;
            let y = if around.image { &points[2] } else { &points[1] };
            let first = element * per_element;
            gauss.clear();
            let position = |q: usize| self.position[first + q];
            let far = self.is_far(element, [&points[0], y]);
            // Of a far element only the points that expansions omit, instead of all points less those included.
            gauss
                .extend((0..per_element).filter(|q| direct.has(position(*q), around.image) == far));
            let vertices = sources.vertices(element);
            match far {
                true => entries.fill(0.0),
                false => self
                    .integrals
                    .at_all(vertices, [&points[0], y], work, entries),
            }
            if !gauss.is_empty() {
                Arch::new().dispatch(GaussSum {
                    sources,
                    element,
                    gauss,
                    points: [&points[0], y],
                    entries,
                });
            }
            if far {
                entries.iter_mut().for_each(|e| *e = -*e);
            }
            for (node, entries) in
                (sources.space.nodes_of(element).iter()).zip(entries.chunks_exact(n))
            {
                let at = nodes.binary_search(node).expect("listed above") * n;
                for (sum, entry) in columns[at..at + n].iter_mut().zip(entries) {
                    *sum += entry;
                }
            }
        }
        let mut rows = Vec::with_capacity(targets.len() * nodes.len());
        for target in 0..targets.len() {
            rows.extend(columns.chunks_exact(n).map(|c| S::from_f64(c[target])));
        }
        rows
    }
}

/// Sources that expansions leave out, as ranges of the tree's order; and their images.
struct Direct([Vec<Range<u32>>; 2]);

impl Direct {
    fn new(tree: &Tree, near: &[Near]) -> Direct {
        let mut direct: [Vec<Range<u32>>; 2] = [Vec::new(), Vec::new()];
        for n in near {
            let s = &tree.cells[n.from as usize].sources;
            direct[usize::from(n.image)].push(s.start as u32..s.end as u32);
        }
        direct.iter_mut().for_each(|d| d.sort_by_key(|r| r.start));
        Direct(direct)
    }

    fn has(&self, position: u32, image: bool) -> bool {
        let ranges = &self.0[usize::from(image)];
        let next = ranges.partition_point(|r| r.start <= position);
        next > 0 && ranges[next - 1].contains(&position)
    }
}

/// Takes off Σ_q w_q N_j(y_q) K(|x − y_q|) over some Gauss points of an element, at many points x.
struct GaussSum<'a> {
    sources: &'a Sources<'a>,
    element: usize,
    gauss: &'a [usize],
    points: [&'a [f64]; 2],
    /// Shape function by shape function.
    entries: &'a mut [f64],
}

impl WithSimd for GaussSum<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        match self.sources.space.element.n_nodes() {
            2 => self.run::<S, 2>(simd),
            3 => self.run::<S, 3>(simd),
            4 => self.run::<S, 4>(simd),
            5 => self.run::<S, 5>(simd),
            6 => self.run::<S, 6>(simd),
            10 => self.run::<S, 10>(simd),
            15 => self.run::<S, 15>(simd),
            21 => self.run::<S, 21>(simd),
            n => panic!("no element has {n} nodes"),
        }
    }
}

impl GaussSum<'_> {
    /// With `N` shape functions, whose sums stay in registers.
    #[inline(always)]
    fn run<S: Simd, const N: usize>(self, simd: S) {
        let first = self.element * self.sources.per_element();
        let [xs, ys] = self.points;
        let (xs, ys) = (S::as_simd_f64s(xs).0, S::as_simd_f64s(ys).0);
        let entries = S::as_mut_simd_f64s(self.entries).0;
        let m = xs.len();
        for i in 0..m {
            let x = [Lanes(simd, xs[i]), Lanes(simd, ys[i])];
            let mut sums = [Lanes::of(simd, 0.0); N];
            for q in self.gauss {
                let y = self.sources.points[first + q];
                let weight = self.sources.weight(self.element, *q);
                let (dx, dy) = (x[0] - Lanes::of(simd, y[0]), x[1] - Lanes::of(simd, y[1]));
                let r = dx.times_plus(dx, dy * dy).sqrt();
                let value = match self.sources.kernel {
                    Kernel::InverseDistance => Lanes::of(simd, weight) / r,
                    Kernel::Logarithm => {
                        let mut logs = [0.0; POINTS];
                        simd.partial_store_f64s(&mut logs[..S::F64_LANES], r.1);
                        logarithms(&mut logs[..S::F64_LANES]);
                        let logs = Lanes(simd, simd.partial_load_f64s(&logs[..S::F64_LANES]));
                        Lanes::of(simd, -weight) * logs
                    }
                };
                let shapes = &self.sources.shapes(*q)[..N];
                for j in 0..N {
                    sums[j] = Lanes::of(simd, shapes[j]).times_plus(value, sums[j]);
                }
            }
            for j in 0..N {
                entries[j * m + i] = (Lanes(simd, entries[j * m + i]) - sums[j]).1;
            }
        }
    }
}
