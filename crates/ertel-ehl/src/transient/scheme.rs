//! Derivatives in time from values at instants at uneven distances.
//!
//! ```text
//!   ∂q/∂T at T_n+1 = Σ c_k q^(n+1−k),   c = (1 − β) BDF2 + β BDF3        of the second order
//!   e = (1 − β) k/(1 + k) (q − q*),   k = 1/(c_0 (T_n+1 − T_n−2))            q*: parabola through the three instants before
//! ```
//! BDFk is the slope at T_n+1 of the polynomial through k + 1 instants. With β = 0.48 the error constant is half of that of BDF2, and up to β = 0.5 the scheme
//! is stable for all slopes in equal steps (Nyukhtikov et al. 2003). Fewer instants: BDF2, BDF1.

/// β.
const BLEND: f64 = 0.48;

/// Most instants before the new one that count.
pub const MEMORY: usize = 3;

/// Weights c_k of the values at instants, the newest first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Weights {
    c: [f64; MEMORY + 1],
    /// How many of them count.
    n: usize,
}

/// Slopes at the first of some instants by the values there, of the polynomial through the first `n` of them.
fn slopes(times: &[f64], n: usize) -> [f64; MEMORY + 1] {
    let mut c = [0.0; MEMORY + 1];
    let here = times[0];
    for j in 1..n {
        // Lagrange's polynomial of instant j has one root here.
        let others = (1..n).filter(|m| *m != j);
        let product: f64 = others
            .map(|m| (here - times[m]) / (times[j] - times[m]))
            .product();
        c[j] = product / (times[j] - here);
        c[0] -= c[j];
    }
    c
}

impl Weights {
    /// At the first of two to four instants, the newest first; of more, the newest count.
    ///
    /// # Panics
    /// For a single instant.
    pub fn new(times: &[f64]) -> Weights {
        assert!(times.len() > 1, "a derivative takes two instants");
        let n = times.len().min(MEMORY + 1);
        let c = match n {
            2 | 3 => slopes(times, n),
            _ => {
                let [low, high] = [3, 4].map(|n| slopes(times, n));
                std::array::from_fn(|k| (1.0 - BLEND) * low[k] + BLEND * high[k])
            }
        };
        Weights { c, n }
    }

    /// c_0.
    pub fn rate(&self) -> f64 {
        self.c[0]
    }

    /// Σ c_k q of the instants before, the newest first.
    pub fn past<'a>(&self, before: impl Iterator<Item = &'a Vec<f64>>) -> Vec<f64> {
        let mut sum = Vec::new();
        for (c, values) in self.c[1..self.n].iter().zip(before) {
            sum.resize(values.len(), 0.0);
            for (total, value) in sum.iter_mut().zip(values) {
                *total += c * value;
            }
        }
        sum
    }

    /// The same of a single number.
    pub fn past_of(&self, before: impl Iterator<Item = f64>) -> f64 {
        let weighted = self.c[1..self.n].iter().zip(before);
        weighted.map(|(c, value)| c * value).sum()
    }

    /// Local error of the step, over the difference of its value from the parabola through the three instants before; `None` with fewer.
    pub fn share_of_error(&self, times: &[f64]) -> Option<f64> {
        (self.n > MEMORY).then(|| {
            let k = 1.0 / (self.c[0] * (times[0] - times[MEMORY]));
            (1.0 - BLEND) * k / (1.0 + k)
        })
    }
}

/// Weights that extrapolate the polynomial through up to three instants, the newest first, to another one.
pub fn extrapolation(times: &[f64], to: f64) -> Vec<f64> {
    let n = times.len().min(MEMORY);
    (0..n)
        .map(|j| {
            let others = (0..n).filter(|m| *m != j);
            others
                .map(|m| (to - times[m]) / (times[j] - times[m]))
                .product()
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// By hand for equal steps: BDF2 has 3/2, −2, 1/2, BDF3 11/6, −3, 3/2, −1/3.
    #[test]
    fn equal_steps_by_hand() {
        let times = [0.4, 0.3, 0.2, 0.1];
        let two = Weights::new(&times[..3]);
        for (own, c) in two.c.iter().zip([1.5, -2.0, 0.5, 0.0]) {
            assert_relative_eq!(*own, 10.0 * c, max_relative = 1e-12, epsilon = 1e-12);
        }
        let blend = Weights::new(&times);
        for (own, [two, three]) in blend.c.iter().zip([
            [1.5, 11.0 / 6.0],
            [-2.0, -3.0],
            [0.5, 1.5],
            [0.0, -1.0 / 3.0],
        ]) {
            let c = 0.52 * two + 0.48 * three;
            assert_relative_eq!(*own, 10.0 * c, max_relative = 1e-9, epsilon = 1e-9);
        }
        let one = Weights::new(&times[..2]);
        assert_relative_eq!(one.rate(), 10.0, max_relative = 1e-12);
    }

    /// Exact for parabolas at uneven instants, and the estimated error of a cubic is the scheme's own.
    #[test]
    fn uneven_steps_are_exact_for_parabolas() {
        let times = [1.0, 0.83, 0.71, 0.4];
        let weights = Weights::new(&times);
        let slope = |q: &dyn Fn(f64) -> f64| {
            let before: Vec<Vec<f64>> = times[1..].iter().map(|t| vec![q(*t)]).collect();
            weights.rate() * q(times[0]) + weights.past(before.iter())[0]
        };
        assert_relative_eq!(slope(&|t| 2.0 - t + 3.0 * t * t), 5.0, max_relative = 1e-12);
        // The derivative of t³ is short by the share of the parabola in the blend.
        let cubic = |t: f64| t.powi(3);
        let [c1, c2] = [times[0] - times[1], times[0] - times[2]];
        let missing = (1.0 - BLEND) * c1 * c2;
        assert_relative_eq!(slope(&cubic), 3.0 - missing, max_relative = 1e-12);
        let weights_on = extrapolation(&times[1..], times[0]);
        let predicted: f64 = weights_on
            .iter()
            .zip(&times[1..])
            .map(|(w, t)| w * cubic(*t))
            .sum();
        // Exact at the three instants: what is missing is the product of the distances.
        let product: f64 = times[1..].iter().map(|t| times[0] - t).product();
        assert_relative_eq!(cubic(times[0]) - predicted, product, max_relative = 1e-9);
        assert!(weights.share_of_error(&times).unwrap() > 0.0);
        assert!(
            Weights::new(&times[..3])
                .share_of_error(&times[..3])
                .is_none()
        );
    }

    /// q' = −q + sin T from T = 0 to 2 in uneven steps, against the closed form: halving the steps divides the error by about four.
    #[test]
    fn second_order_in_uneven_steps() {
        let exact = |t: f64| 0.5 * (t.sin() - t.cos()) + 1.5 * (-t).exp();
        let error = |n: usize| {
            let step = 2.0 / n as f64;
            // Every other step is longer.
            let at = |i: usize| step * (i as f64 + if i % 2 == 1 { 0.3 } else { 0.0 });
            let (mut times, mut values) = (vec![at(0)], vec![vec![exact(0.0)]]);
            for i in 1..=n {
                let t = at(i);
                let mut all = vec![t];
                all.extend(times.iter().take(MEMORY));
                if i < 3 {
                    values.insert(0, vec![exact(t)]);
                } else {
                    let weights = Weights::new(&all);
                    let past = weights.past(values.iter())[0];
                    values.insert(0, vec![(t.sin() - past) / (1.0 + weights.rate())]);
                }
                times.insert(0, t);
            }
            (values[0][0] - exact(times[0])).abs()
        };
        let [coarse, fine] = [80, 160].map(error);
        let order = (coarse / fine).log2();
        assert!((1.8..2.3).contains(&order), "{order}: {coarse} {fine}");
    }
}
