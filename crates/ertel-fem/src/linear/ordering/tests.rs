use super::*;

/// Nodes of a square grid with their eight neighbours.
fn grid(n: usize) -> NodeGraph {
    let mut graph = NodeGraph {
        offsets: vec![0],
        neighbours: Vec::new(),
    };
    for node in 0..n * n {
        let (x, y) = (node % n, node / n);
        for y in y.saturating_sub(1)..(y + 2).min(n) {
            graph
                .neighbours
                .extend((x.saturating_sub(1)..(x + 2).min(n)).map(|x| (y * n + x) as u32));
        }
        graph.offsets.push(graph.neighbours.len());
    }
    graph
}

/// Entries below the diagonal of the factor, by eliminating nodes one after the other.
fn fill(graph: &NodeGraph, order: &[usize]) -> usize {
    let n = graph.n_nodes();
    let mut rank = vec![usize::MAX; n];
    for (k, node) in order.iter().enumerate() {
        assert_eq!(rank[*node], usize::MAX, "node {node} stands twice");
        rank[*node] = k;
    }
    let mut columns: Vec<std::collections::BTreeSet<usize>> = (0..n)
        .map(|k| {
            let others = graph.of(order[k]).iter().map(|m| rank[*m as usize]);
            others.filter(|r| *r > k).collect()
        })
        .collect();
    let mut entries = 0;
    for k in 0..n {
        let column = std::mem::take(&mut columns[k]);
        entries += column.len();
        if let Some(parent) = column.first().copied() {
            columns[parent].extend(column.iter().copied().filter(|r| *r > parent));
        }
    }
    entries
}

/// Nodes of a cube of cells with the 26 others around each.
fn cube(n: usize) -> NodeGraph {
    let mut graph = NodeGraph {
        offsets: vec![0],
        neighbours: Vec::new(),
    };
    let near = |at: usize| at.saturating_sub(1)..(at + 2).min(n);
    for node in 0..n * n * n {
        let (x, y, z) = (node % n, node / n % n, node / (n * n));
        for z in near(z) {
            for y in near(y) {
                let row = near(x).map(|x| ((z * n + y) * n + x) as u32);
                graph.neighbours.extend(row);
            }
        }
        graph.offsets.push(graph.neighbours.len());
    }
    graph
}

fn filled(graph: &NodeGraph, how: FillReduction) -> usize {
    fill(graph, &fill_reducing(graph, how).unwrap())
}

/// METIS 5.2.1 (`METIS_NodeND` with its defaults) fills 32,184 entries on a plane grid of 40² nodes, 63,960 come about in rows; on a cube of
/// 14³ nodes METIS fills 282,541, and minimum degree 343,398.
#[test]
fn fills_little_more_than_metis() {
    let surface = filled(&grid(40), FillReduction::MinimumDegree);
    assert!(100 * surface < 105 * 32_184, "{surface}");
    let body = filled(&cube(14), FillReduction::NestedDissection);
    assert!(100 * body < 110 * 282_541, "{body}");
}

/// Graphs without neighbours, with all of them, in separate parts, and a star.
#[test]
fn unusual_graphs_are_ordered() {
    let n = 300;
    let from = |near: &dyn Fn(usize, usize) -> bool| {
        let mut graph = NodeGraph {
            offsets: vec![0],
            neighbours: Vec::new(),
        };
        for i in 0..n {
            let row = (0..n).filter(|j| i == *j || near(i, *j));
            graph.neighbours.extend(row.map(|j| j as u32));
            graph.offsets.push(graph.neighbours.len());
        }
        graph
    };
    let alone = from(&|_, _| false);
    let complete = from(&|_, _| true);
    let apart = from(&|i, j| i / 7 == j / 7);
    let star = from(&|i, j| i == 0 || j == 0);
    for how in [
        FillReduction::MinimumDegree,
        FillReduction::NestedDissection,
    ] {
        assert_eq!(filled(&alone, how), 0);
        assert_eq!(filled(&complete, how), n * (n - 1) / 2);
        // 42 cliques of seven, and the six nodes left
        assert_eq!(filled(&apart, how), 42 * 21 + 15);
        assert_eq!(filled(&star, how), n - 1);
    }
}
