//! Elimination tree of a sparse matrix with symmetric pattern, cut into dense fronts
//! (Duff and Reid 1983; Liu 1992).
//!
//! A front eliminates its own unknowns from the dense matrix of these and its boundary; what is
//! left of the boundary goes to its parent. Fronts stand in postorder: a subtree is a contiguous
//! range, and its unknowns are a contiguous range of the elimination order.

use rayon::prelude::*;
use rustc_hash::FxHashMap;

use crate::assembly::NodeGraph;
use crate::linear::ordering::{FillReduction, OrderingError, fill_reducing};

/// One front: unknowns by their position in the elimination order.
#[derive(Clone, Debug)]
pub struct Front {
    /// First own position; own positions are `first..first + n_own`.
    pub first: usize,
    /// Number of unknowns eliminated here.
    pub n_own: usize,
    /// Positions of the boundary, ascending, all beyond the own ones.
    pub boundary: Vec<u32>,
    /// Children, ascending.
    pub children: Vec<usize>,
    /// First front of the subtree.
    pub subtree: usize,
    /// Index of each boundary position in the front of the parent (own first, then boundary).
    pub in_parent: Vec<u32>,
}

impl Front {
    /// Own and boundary unknowns together.
    pub fn size(&self) -> usize {
        self.n_own + self.boundary.len()
    }

    /// Index in this front of a position that belongs to it.
    pub fn index_of(&self, position: usize) -> usize {
        if position < self.first + self.n_own {
            position - self.first
        } else {
            let found = self.boundary.binary_search(&(position as u32));
            self.n_own + found.expect("the position belongs to the front")
        }
    }
}

/// All fronts in postorder, and the elimination order.
#[derive(Clone, Debug)]
pub struct Fronts {
    /// The fronts; children before parents.
    pub fronts: Vec<Front>,
    /// Fronts without parent.
    pub roots: Vec<usize>,
    /// Unknown at each position.
    pub order: Vec<u32>,
    /// Position of each unknown.
    pub position: Vec<u32>,
    /// Operations of each subtree, about.
    work: Vec<f64>,
}

/// Operations below which a subtree is left to one thread.
const SMALL: f64 = 2e6;

/// Groups of unknowns that are eliminated together, with their neighbours.
pub struct Blocks<'a> {
    /// Neighbours of each group, itself included.
    pub graph: &'a NodeGraph,
    /// Unknowns of each group.
    pub unknowns: Vec<Vec<u32>>,
    /// Groups `n_inner..` come last, all in one root front, whatever the graph says.
    pub n_inner: usize,
    /// Vertices, ascending in number, on whose common edge, face or cell each inner group lies, filled up
    /// with `u32::MAX`; every vertex is a separate group. With them only the vertices are
    /// ordered by the graph, in a small part of the time, and the other groups follow.
    pub carriers: Option<Vec<[u32; 4]>>,
    /// How the order is found.
    pub reduction: FillReduction,
}

const NONE: usize = usize::MAX;

impl Fronts {
    /// Fill-reducing order of the inner groups, then the rest.
    ///
    /// # Errors
    /// When the ordering fails.
    pub fn new(blocks: &Blocks) -> Result<Fronts, OrderingError> {
        let n = blocks.n_inner;
        let order = match &blocks.carriers {
            Some(carriers) => order_by_vertices(blocks, carriers)?,
            None => fill_reducing(&inner_graph(blocks), blocks.reduction)?,
        };
        let mut rank = vec![0usize; blocks.graph.n_nodes()];
        for (k, b) in order.iter().enumerate() {
            rank[*b] = k;
        }
        for (k, r) in rank.iter_mut().enumerate().skip(n) {
            *r = k;
        }
        let mut nodes = structures(blocks, &order, &rank);
        amalgamate(&mut nodes);
        Ok(number(&nodes, blocks, &order))
    }

    /// Eliminates all fronts, subtrees on several threads where they are large; returns what the
    /// roots leave.
    ///
    /// `storage` holds what each front keeps, front k from `starts[k]` to `starts[k + 1]`. `f(k, kept,
    /// left)` eliminates front k given what its children leave, in their order: the result does not
    /// depend on the number of threads.
    ///
    /// # Errors
    /// The first that `f` returns.
    pub fn eliminate<T: Send, U: Send, E: Send>(
        &self,
        starts: &[usize],
        storage: &mut [T],
        f: &(impl Fn(usize, &mut [T], Vec<U>) -> Result<U, E> + Sync),
    ) -> Result<Vec<U>, E> {
        self.subtrees(&self.roots, starts, storage, f)
    }

    fn subtrees<T: Send, U: Send, E: Send>(
        &self,
        tops: &[usize],
        starts: &[usize],
        mut storage: &mut [T],
        f: &(impl Fn(usize, &mut [T], Vec<U>) -> Result<U, E> + Sync),
    ) -> Result<Vec<U>, E> {
        let mut parts = Vec::with_capacity(tops.len());
        for k in tops {
            let length = starts[k + 1] - starts[self.fronts[*k].subtree];
            let (part, rest) = storage.split_at_mut(length);
            parts.push((*k, part));
            storage = rest;
        }
        let subtree = |(k, part): (usize, &mut [T])| {
            let front = &self.fronts[k];
            let (below, own) = part.split_at_mut(starts[k] - starts[front.subtree]);
            let left = self.subtrees(&front.children, starts, below, f)?;
            f(k, own, left)
        };
        if tops.iter().filter(|k| self.work[**k] > SMALL).count() > 1 {
            parts.into_par_iter().map(subtree).collect()
        } else {
            parts.into_iter().map(subtree).collect()
        }
    }

    /// The front that eliminates each position.
    pub fn owners(&self) -> Vec<u32> {
        let mut owner = vec![0; self.order.len()];
        for (k, f) in self.fronts.iter().enumerate() {
            owner[f.first..f.first + f.n_own].fill(k as u32);
        }
        owner
    }
}

/// Graph of the inner groups alone.
fn inner_graph(blocks: &Blocks) -> NodeGraph {
    let mut graph = NodeGraph {
        offsets: vec![0],
        neighbours: Vec::with_capacity(blocks.graph.neighbours.len()),
    };
    for b in 0..blocks.n_inner {
        let inner = blocks.graph.of(b).iter().copied();
        graph
            .neighbours
            .extend(inner.filter(|o| (*o as usize) < blocks.n_inner));
        graph.offsets.push(graph.neighbours.len());
    }
    graph
}

/// Vertices by a fill-reducing order; any other group before the first of its vertices, so that a separator
/// of vertices, with what lies on it, separates all groups.
fn order_by_vertices(blocks: &Blocks, carriers: &[[u32; 4]]) -> Result<Vec<usize>, OrderingError> {
    let n_carriers = |g: usize| carriers[g].iter().filter(|v| **v != u32::MAX).count();
    let vertices: Vec<usize> = (0..blocks.n_inner)
        .filter(|g| n_carriers(*g) == 1)
        .collect();
    let mut index = vec![u32::MAX; blocks.graph.n_nodes()];
    for (k, g) in vertices.iter().enumerate() {
        index[*g] = k as u32;
    }
    let mut graph = NodeGraph {
        offsets: vec![0],
        neighbours: Vec::new(),
    };
    for g in &vertices {
        let others = blocks.graph.of(*g).iter().map(|o| index[*o as usize]);
        graph.neighbours.extend(others.filter(|k| *k != u32::MAX));
        graph.offsets.push(graph.neighbours.len());
    }
    let mut rank: FxHashMap<u32, usize> = FxHashMap::default();
    for (r, k) in fill_reducing(&graph, blocks.reduction)?
        .into_iter()
        .enumerate()
    {
        let vertex = carriers[vertices[k]].iter().min();
        rank.insert(*vertex.expect("four places"), r);
    }
    let mut order: Vec<usize> = (0..blocks.n_inner).collect();
    order.sort_by_cached_key(|g| {
        let ranks = carriers[*g].iter().filter_map(|v| rank.get(v).copied());
        let mut ranks: Vec<usize> = ranks.collect();
        ranks.sort_unstable();
        // edges of a vertex by their other ends, then the vertex itself
        let last = ranks.get(1).copied().unwrap_or(usize::MAX);
        (ranks.first().copied(), last, *g)
    });
    Ok(order)
}

/// Supernode of groups (by rank) with its boundary.
#[derive(Clone, Default)]
struct Node {
    groups: Vec<usize>,
    boundary: Vec<u32>,
    parent: Option<usize>,
    /// Unknowns of `groups` and of `boundary`.
    own: usize,
    outer: usize,
    /// Zeros taken in by merging.
    zeros: usize,
}

impl Node {
    /// Entries of the factor, lower half.
    fn entries(own: usize, outer: usize) -> usize {
        own * (own + 1) / 2 + own * outer
    }
}

/// Column structures of the factor, each the union of the children's and of the matrix column;
/// a group whose structure is its only child's without itself joins that child's supernode.
fn structures(blocks: &Blocks, order: &[usize], rank: &[usize]) -> Vec<Node> {
    let n = blocks.n_inner;
    let mut nodes: Vec<Node> = Vec::new();
    let mut children: Vec<Vec<usize>> = vec![Vec::new(); n]; // supernodes whose parent is a group
    let mut stamp = vec![NONE; blocks.graph.n_nodes()];
    for r in 0..n {
        let below = std::mem::take(&mut children[r]);
        stamp[r] = r;
        let mut list: Vec<u32> = Vec::new();
        let from_children = below
            .iter()
            .flat_map(|c| nodes[*c].boundary.iter().copied());
        let from_matrix = blocks
            .graph
            .of(order[r])
            .iter()
            .map(|o| rank[*o as usize] as u32);
        for s in from_children.chain(from_matrix.filter(|s| *s as usize > r)) {
            if stamp[s as usize] != r {
                stamp[s as usize] = r;
                list.push(s);
            }
        }
        let k = match below[..] {
            [only] if nodes[only].boundary.len() == list.len() + 1 => only,
            _ => {
                nodes.push(Node::default());
                nodes.len() - 1
            }
        };
        nodes[k].groups.push(r);
        let parent = list.iter().copied().min().map(|s| s as usize);
        nodes[k].boundary = list;
        if let Some(parent) = parent.filter(|s| *s < n) {
            children[parent].push(k);
        }
    }
    // The parent holds the first group of the boundary.
    let mut holder = vec![0; n];
    for (k, node) in nodes.iter().enumerate() {
        for r in &node.groups {
            holder[*r] = k;
        }
    }
    let weight = |r: usize| blocks.unknowns[if r < n { order[r] } else { r }].len();
    for node in &mut nodes {
        let first = node.boundary.iter().copied().min();
        node.parent = first
            .filter(|s| (*s as usize) < n)
            .map(|s| holder[s as usize]);
        node.own = node.groups.iter().map(|r| weight(*r)).sum();
        node.outer = node.boundary.iter().map(|r| weight(*r as usize)).sum();
    }
    nodes
}

/// Share of zeros that a merged front may have, by its own unknowns: small fronts cost more than
/// the zeros that fill them.
const RELAXATION: [(usize, f64); 3] = [(16, 0.9), (48, 0.4), (usize::MAX, 0.08)];

/// Merges children into parents where that costs few zeros; merged nodes lose their groups.
fn amalgamate(nodes: &mut [Node]) {
    let mut children: Vec<Vec<usize>> = vec![Vec::new(); nodes.len()];
    for (k, node) in nodes.iter().enumerate() {
        if let Some(p) = node.parent {
            children[p].push(k);
        }
    }
    for p in 0..nodes.len() {
        let mut mine = std::mem::take(&mut children[p]);
        mine.sort_by_key(|c| std::cmp::Reverse(nodes[*c].boundary.len()));
        for c in mine {
            let own = nodes[c].own + nodes[p].own;
            let outer = nodes[p].outer;
            let after = Node::entries(own, outer);
            let before = Node::entries(nodes[c].own, nodes[c].outer)
                + Node::entries(nodes[p].own, nodes[p].outer);
            let zeros = nodes[c].zeros + nodes[p].zeros + after.saturating_sub(before);
            let allowed = RELAXATION.iter().find(|(limit, _)| own <= *limit);
            if zeros as f64 > allowed.map_or(0.0, |a| a.1) * after as f64 {
                continue;
            }
            let mut groups = std::mem::take(&mut nodes[c].groups);
            groups.append(&mut nodes[p].groups);
            nodes[p].groups = groups;
            nodes[p].own = own;
            nodes[p].zeros = zeros;
        }
    }
    // Parents that were merged themselves hand their children up.
    for k in (0..nodes.len()).rev() {
        if let Some(p) = nodes[k].parent
            && nodes[p].groups.is_empty()
        {
            nodes[k].parent = nodes[p].parent;
        }
    }
}

/// Finds the places of boundaries in the fronts of their parents.
fn place_in_parents(fronts: &mut [Front]) {
    for p in 0..fronts.len() {
        for c in fronts[p].children.clone() {
            let map = fronts[c]
                .boundary
                .iter()
                .map(|s| fronts[p].index_of(*s as usize) as u32);
            fronts[c].in_parent = map.collect();
        }
    }
}

/// Numbers fronts and unknowns in postorder.
fn number(nodes: &[Node], blocks: &Blocks, order: &[usize]) -> Fronts {
    let n = blocks.n_inner;
    let has_last = n < blocks.graph.n_nodes();
    let mut children: Vec<Vec<usize>> = vec![Vec::new(); nodes.len() + 1];
    let last = nodes.len();
    for (k, node) in nodes.iter().enumerate() {
        if !node.groups.is_empty() {
            children[node.parent.unwrap_or(last)].push(k);
        }
    }
    let mut fronts: Vec<Front> = Vec::new();
    let mut new_index = vec![NONE; nodes.len() + 1];
    let mut unknowns: Vec<u32> = Vec::new();
    let mut start = vec![0usize; blocks.graph.n_nodes()]; // first position of a group, by rank
    let roots = if has_last {
        vec![last]
    } else {
        children[last].clone()
    };
    let mut stack: Vec<(usize, bool)> = roots.iter().rev().map(|k| (*k, false)).collect();
    while let Some((k, visited)) = stack.pop() {
        if !visited {
            stack.push((k, true));
            stack.extend(children[k].iter().rev().map(|c| (*c, false)));
            continue;
        }
        let first = unknowns.len();
        if k == last {
            for b in n..blocks.graph.n_nodes() {
                start[b] = unknowns.len();
                unknowns.extend_from_slice(&blocks.unknowns[b]);
            }
        } else {
            for r in &nodes[k].groups {
                start[*r] = unknowns.len();
                unknowns.extend_from_slice(&blocks.unknowns[order[*r]]);
            }
        }
        let below: Vec<usize> = children[k].iter().map(|c| new_index[*c]).collect();
        new_index[k] = fronts.len();
        fronts.push(Front {
            first,
            n_own: unknowns.len() - first,
            boundary: Vec::new(),
            subtree: below.first().map_or(fronts.len(), |c| fronts[*c].subtree),
            children: below,
            in_parent: Vec::new(),
        });
    }
    let boundaries = nodes.iter().zip(&new_index);
    for (node, index) in boundaries.filter(|(node, _)| !node.groups.is_empty()) {
        let boundary = &mut fronts[*index].boundary;
        for r in &node.boundary {
            let r = *r as usize;
            let size = blocks.unknowns[if r < n { order[r] } else { r }].len();
            boundary.extend((start[r]..start[r] + size).map(|p| p as u32));
        }
        boundary.sort_unstable();
    }
    place_in_parents(&mut fronts);
    let mut position = vec![0; unknowns.len()];
    for (k, u) in unknowns.iter().enumerate() {
        position[*u as usize] = k as u32;
    }
    let mut work: Vec<f64> = Vec::with_capacity(fronts.len());
    for f in &fronts {
        let below = f.children.iter().map(|c| work[*c]).sum::<f64>();
        work.push(below + f.n_own as f64 * (f.size() as f64).powi(2));
    }
    Fronts {
        work,
        roots: roots.iter().map(|k| new_index[*k]).collect(),
        fronts,
        order: unknowns,
        position,
    }
}
