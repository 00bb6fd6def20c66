//! When the rounds of a coupling may end.
//!
//! ```text
//!   changes c_k = |x_k − x_(k−1)| that shrink by q leave the error    |x* − x_k| ≤ c_k (q + q² + …) = c_k q/(1 − q)
//! ```
//! Where changes shrink by little, the error is many times the last of them.

/// Judges a coupling by its changes from round to round.
#[derive(Clone, Copy, Debug)]
pub struct StoppingRule {
    /// Relative change, and error, at which it has converged.
    pub tolerance: f64,
    /// Share of the tolerance to which each half of a round is solved: changes below it that do not shrink are noise.
    pub inner_share: f64,
}

impl StoppingRule {
    /// Whether a round may be the last: it would change by `change`, of which a `share` was taken, and changes shrink by `ratio` from
    /// round to round; `None` after a single one.
    pub fn holds(&self, change: f64, share: f64, ratio: Option<f64>) -> bool {
        let limit = match ratio {
            Some(q) if q < 1.0 => self.tolerance * ((1.0 - q) / (share * q)).min(1.0),
            _ => self.inner_share * self.tolerance,
        };
        change < limit
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const RULE: StoppingRule = StoppingRule {
        tolerance: 1e-4,
        inner_share: 0.1,
    };

    /// x_k = x_(k−1) + ω(J − 1)x_(k−1), x* = 0: x_k = qᵏ with q = 1 − ω(1 − J), whole changes (1 − J)x_(k−1), in closed form. A rule that
    /// looked at the change alone would stop at J = 0.95 with 19 times the error that is allowed.
    #[test]
    fn slow_couplings_continue_until_the_error_is_small() {
        for (slope, share) in [
            (0.05, 1.0),
            (0.3, 1.0),
            (0.6, 1.0),
            (0.8, 1.0),
            (0.95, 1.0),
            (-0.6, 0.5),
            (0.6, 0.5),
        ] {
            let q: f64 = 1.0 - share * (1.0 - slope);
            let change = |k: i32| q.powi(k - 1) * (1.0 - slope);
            let k = (2..1000)
                .find(|k| RULE.holds(change(*k), share, Some(change(*k) / change(k - 1))))
                .expect("it converges");
            let largest = |k: i32| q.powi(k).max(change(k));
            let error = q.powi(k);
            assert!(error < 1e-4, "{slope} {share}: error {error}");
            // No round too many.
            let before = largest(k - 1);
            assert!(before >= 1e-4, "{slope} {share}: {before} before");
        }
    }

    /// One change alone does not bound the error, nor do changes that grow; those below the tolerance of the halves are noise.
    #[test]
    fn changes_without_contraction() {
        for ratio in [None, Some(1.1)] {
            assert!(!RULE.holds(5e-5, 1.0, ratio) && RULE.holds(0.9e-5, 1.0, ratio));
        }
        assert!(!RULE.holds(1.1e-4, 1.0, Some(0.01)));
    }
}
