//! Hills of values that have neighbours, and the passes between them.

/// Height of a peak over the pass to a higher one, in p_h, from which it counts as a separate peak.
pub const PROMINENCE: f64 = 0.02;

/// Elements at the tops of hills.
#[derive(Debug, PartialEq)]
pub struct Hills {
    /// That of the hill on which the centre lies.
    pub central: usize,
    /// Those of the others.
    pub others: Vec<usize>,
}

/// The hills of values: where two meet at a pass, the lower one ends, and counts if its top is above the pass by
/// [`PROMINENCE`]; otherwise it is a part of the higher one.
pub fn hills(values: &[f64], neighbours: &[Vec<u32>], centre: usize) -> Hills {
    let mut order: Vec<usize> = (0..values.len()).collect();
    order.sort_by(|a, b| values[*b].total_cmp(&values[*a]).then(a.cmp(b)));
    const UNDER_WATER: usize = usize::MAX;
    // Each element above the water leads to the top of its hill.
    let mut towards = vec![UNDER_WATER; values.len()];
    let (mut central, mut others) = (None, Vec::new());
    for &c in &order {
        towards[c] = c;
        for &n in &neighbours[c] {
            if towards[n as usize] == UNDER_WATER {
                continue;
            }
            let (a, b) = (root(&mut towards, c), root(&mut towards, n as usize));
            if a == b {
                continue;
            }
            let (high, low) = match (values[a], b) >= (values[b], a) {
                true => (a, b),
                false => (b, a),
            };
            if values[low] - values[c] >= PROMINENCE {
                let holds_centre =
                    towards[centre] != UNDER_WATER && root(&mut towards, centre) == low;
                match central.is_none() && holds_centre {
                    true => central = Some(low),
                    false => others.push(low),
                }
            }
            towards[low] = high;
        }
    }
    let highest = order.first().copied().unwrap_or(centre);
    match central {
        None => central = Some(highest),
        Some(_) => others.push(highest),
    }
    Hills {
        central: central.unwrap_or(highest),
        others,
    }
}

/// The top to which an element leads; shortens the path.
pub(crate) fn root(towards: &mut [usize], mut c: usize) -> usize {
    while towards[c] != c {
        towards[c] = towards[towards[c]];
        c = towards[c];
    }
    c
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A row of elements.
    fn row(values: &[f64], centre: usize) -> (usize, Vec<usize>) {
        let n = values.len() as u32;
        let neighbours: Vec<Vec<u32>> = (0..n)
            .map(|c| {
                let before = c.checked_sub(1).into_iter();
                before.chain((c + 1 < n).then_some(c + 1)).collect()
            })
            .collect();
        let hills = hills(values, &neighbours, centre);
        (hills.central, hills.others)
    }

    /// By hand: the centre stands on the slope of the hill 1.0; behind the pass 0.5 is a ridge of two beads of which the higher counts
    /// once the lower one's own pass, 0.85, is too near; a ridge that exceeds the middle leaves it its own top.
    #[test]
    fn the_middle_and_the_ridge_are_distinguished() {
        let beads = [0.0, 0.8, 0.99, 1.0, 0.9, 0.5, 0.86, 0.85, 0.9, 0.1];
        assert_eq!(row(&beads, 2), (3, vec![8]));
        let higher = [0.0, 0.8, 0.99, 1.0, 0.9, 0.5, 1.15, 0.85, 0.9, 0.1];
        assert_eq!(row(&higher, 2), (3, vec![8, 6]));
    }

    /// A ripple of 0.01 on the way up is no hill, and where there is no pass the middle is all.
    #[test]
    fn ripples_are_no_hills() {
        assert_eq!(row(&[0.0, 0.5, 0.49, 0.9, 1.0, 0.2], 1), (4, vec![]));
        assert_eq!(row(&[0.0, 0.5, 0.6, 0.9, 1.2, 0.2], 1), (4, vec![]));
        assert_eq!(row(&[0.3], 0), (0, vec![]));
    }
}
