//! Profiles from measured traces of rollers.
//!
//! A trace has its zero anywhere, may be tilted, and scatters by tenths of a micrometre where the roller is straight. A profile falls
//! off from its highest place towards both ends. Of all profiles that do, the one nearest to the trace in the mean square is taken:
//! isotonic regression on either side of the highest place, by pooling adjacent violators (Barlow, Bartholomew, Bremner and Brunk,
//! Statistical Inference under Order Restrictions, 1972), with that place where the sum of squares is least.

use serde::Serialize;

/// Preparation of a measured trace.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Treatment {
    /// Added to each drop so that the smallest is zero, m.
    pub shift: f64,
    /// Slope of the straight line that was taken off, rad.
    pub tilt: f64,
    /// Length over which drops were averaged, m; zero without.
    pub smoothing_length: f64,
    /// Largest change of a drop by pooling, m.
    pub largest_change: f64,
    /// Root mean square of these changes, m.
    pub rms_change: f64,
    /// Number of points of the trace.
    pub points: usize,
}

/// Positions increasing and drops, m.
#[derive(Clone, Debug, PartialEq)]
pub struct Trace {
    /// Along the axis, m.
    pub position: Vec<f64>,
    /// Away from the other body, m.
    pub drop: Vec<f64>,
}

impl Trace {
    /// Takes off the straight line that fits the trace best in the mean square; returns its slope.
    pub fn level(&mut self) -> f64 {
        let n = self.position.len() as f64;
        let mean = |values: &[f64]| values.iter().sum::<f64>() / n;
        let (y_0, z_0) = (mean(&self.position), mean(&self.drop));
        let pairs = || self.position.iter().zip(&self.drop);
        let above: f64 = pairs().map(|(y, z)| (y - y_0) * (z - z_0)).sum();
        let below: f64 = pairs().map(|(y, _)| (y - y_0).powi(2)).sum();
        let slope = if below > 0.0 { above / below } else { 0.0 };
        for (y, z) in self.position.iter().zip(&mut self.drop) {
            *z -= slope * (y - y_0);
        }
        slope
    }

    /// Averages drops over `length` (m) about each point, over less near the ends, alike on both sides.
    pub fn smooth(&mut self, length: f64) {
        let (y, z) = (&self.position, &self.drop);
        let [first, last] = [y[0], y[y.len() - 1]];
        let averaged = (y.iter()).map(|at| {
            let half = (0.5 * length).min(at - first).min(last - at) * (1.0 + 1e-12);
            let from = y.partition_point(|other| *other < at - half);
            let to = y.partition_point(|other| *other <= at + half);
            z[from..to].iter().sum::<f64>() / (to - from) as f64
        });
        self.drop = averaged.collect();
    }

    /// The nearest profile that falls off towards both ends, with zero at its highest place, at the points that it needs; and the
    /// changes; of a `half`, whose highest place is its first point, too. `None` of a trace without points.
    pub fn fallen(&self, half: bool) -> Option<(Trace, Treatment)> {
        let z = &self.drop;
        let n = z.len();
        if n == 0 {
            return None;
        }
        let reversed: Vec<f64> = z.iter().rev().copied().collect();
        // Costs of the first k points falling towards the first, and of the last k falling towards the last.
        let before = costs(z);
        let after = costs(&reversed);
        let splits = if half { 0..=0 } else { 0..=n };
        let split = splits.min_by(|a, b| {
            let cost = |k: usize| before[k] + after[n - k];
            cost(*a).total_cmp(&cost(*b))
        })?;
        // Drops that shrink up to the split, and grow from there.
        let mut blocks = pooled(&z[..split]);
        let mut start = split;
        let mut rising: Vec<Block> = pooled(&reversed[..n - split]);
        rising.reverse();
        for block in &mut rising {
            block.start = start;
            start += block.len;
        }
        blocks.extend(rising);
        let lowest = blocks.iter().map(|b| b.mean).fold(f64::INFINITY, f64::min);
        let mut fallen = Trace {
            position: Vec::new(),
            drop: Vec::new(),
        };
        let mut push = |y: f64, z: f64| {
            if fallen.position.last().is_none_or(|last| y > *last) {
                fallen.position.push(y);
                fallen.drop.push(z - lowest);
            }
        };
        let (mut largest, mut squares) = (0.0_f64, 0.0);
        let last = blocks.len() - 1;
        for (i, block) in blocks.iter().enumerate() {
            let points = block.start..block.start + block.len;
            for z in &z[points.clone()] {
                largest = largest.max((z - block.mean).abs());
                squares += (z - block.mean).powi(2);
            }
            let y = &self.position[points];
            let is_flat = block.mean == lowest;
            // The straight part keeps both ends; elsewhere the middle of a block represents it, to avoid steps.
            if is_flat || i == 0 {
                push(y[0], block.mean);
            }
            if !is_flat {
                push(y.iter().sum::<f64>() / y.len() as f64, block.mean);
            }
            if is_flat || i == last {
                push(y[y.len() - 1], block.mean);
            }
        }
        let treatment = Treatment {
            shift: -lowest,
            largest_change: largest,
            rms_change: (squares / n as f64).sqrt(),
            points: n,
            ..Treatment::default()
        };
        Some((fallen, treatment))
    }
}

/// Neighbouring points with their mean in common.
#[derive(Clone, Copy)]
struct Block {
    start: usize,
    len: usize,
    mean: f64,
}

/// Adds a point to blocks whose means shrink; returns how much the sum of squares grows.
fn add(blocks: &mut Vec<Block>, at: usize, z: f64) -> f64 {
    let mut block = Block {
        start: at,
        len: 1,
        mean: z,
    };
    let mut growth = 0.0;
    while let Some(previous) = blocks.last().copied().filter(|b| b.mean < block.mean) {
        blocks.pop();
        let (n, m) = (previous.len as f64, block.len as f64);
        growth += n * m / (n + m) * (previous.mean - block.mean).powi(2);
        block = Block {
            start: previous.start,
            len: previous.len + block.len,
            mean: (n * previous.mean + m * block.mean) / (n + m),
        };
    }
    blocks.push(block);
    growth
}

/// The blocks of the nearest sequence that never grows.
fn pooled(z: &[f64]) -> Vec<Block> {
    let mut blocks = Vec::new();
    for (i, z) in z.iter().enumerate() {
        add(&mut blocks, i, *z);
    }
    blocks
}

/// Sums of squares between the first k points and the nearest sequence that never grows, for k from 0.
fn costs(z: &[f64]) -> Vec<f64> {
    let mut blocks = Vec::new();
    let mut cost = 0.0;
    let mut costs = vec![0.0];
    for (i, z) in z.iter().enumerate() {
        cost += add(&mut blocks, i, *z);
        costs.push(cost);
    }
    costs
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// By hand: 5 3 4 1 2 0 3 2 6 in µm. Left of the lowest, 3 and 4 pool to 3.5, 1 and 2 to 1.5; right of it 3 and 2 to 2.5.
    #[test]
    fn a_trace_by_hand() {
        let trace = Trace {
            position: (0..9).map(f64::from).collect(),
            drop: vec![5.0, 3.0, 4.0, 1.0, 2.0, 0.0, 3.0, 2.0, 6.0],
        };
        let (fallen, treatment) = trace.fallen(false).unwrap();
        assert_eq!(fallen.drop, [5.0, 3.5, 1.5, 0.0, 2.5, 6.0]);
        assert_eq!(fallen.position, [0.0, 1.5, 3.5, 5.0, 6.5, 8.0]);
        assert_relative_eq!(treatment.largest_change, 0.5);
        // Six points move by 0.5.
        assert_relative_eq!(treatment.rms_change, (6.0 * 0.25 / 9.0_f64).sqrt());
    }

    /// A crown with scatter and a wrong zero: within the scatter of the crown, zero at its top.
    #[test]
    fn scatter_is_taken_off_a_crown() {
        let scatter = |i: usize| 0.2e-6 * (((i * 7919) % 1000) as f64 / 500.0 - 1.0);
        let position: Vec<f64> = (0..2001).map(|i| 8e-6 * f64::from(i) - 8e-3).collect();
        let crown = |y: f64| 8e-6 * (y / 8e-3).powi(2);
        let drop = (position.iter().enumerate())
            .map(|(i, y)| crown(*y) - 3e-6 + scatter(i))
            .collect();
        let mut trace = Trace { position, drop };
        trace.smooth(0.2e-3);
        let (fallen, treatment) = trace.fallen(false).unwrap();
        assert_relative_eq!(treatment.shift, 3e-6, max_relative = 0.02);
        for (y, z) in fallen.position.iter().zip(&fallen.drop) {
            assert!((z - crown(*y)).abs() < 0.25e-6, "{y}: {z}");
        }
        let falls = |pair: &[f64]| pair[1] <= pair[0];
        let top = fallen.drop.iter().position(|z| *z == 0.0).unwrap();
        assert!(fallen.drop[..=top].windows(2).all(falls));
    }

    #[test]
    fn a_tilt_is_taken_off() {
        let position: Vec<f64> = (0..11).map(|i| 1e-3 * f64::from(i)).collect();
        let drop = position
            .iter()
            .map(|y| (y - 5e-3).powi(2) + 2e-3 * y)
            .collect();
        let mut trace = Trace { position, drop };
        assert_relative_eq!(trace.level(), 2e-3, max_relative = 1e-9);
        assert_relative_eq!(trace.drop[0], trace.drop[10], max_relative = 1e-9);
    }
}
