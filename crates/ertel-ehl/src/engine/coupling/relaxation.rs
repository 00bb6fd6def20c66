//! Which share of new temperatures is taken, T ← T + ω(T_new − T).
//!
//! All of them while the defect T_new − T shrinks fast. Where it does not, as where film and heat overshoot each other in turn,
//! the share that would have left the least of it, had it answered to the last share in proportion (Aitken's relaxation: Irons and
//! Tuck, Int. J. Numer. Methods Eng. 1 (1969) 275-277):
//!
//! ```text
//!   ω = −ω₁ r₁·(r − r₁)/|r − r₁|²
//! ```
//! with the defects r of this round and r₁ of the one before, of which ω₁ was taken. The ratio of defects alone would not do: of a
//! share ω it is 1 − ω at the least, however fast whole temperatures would converge.
//!
//! Theory: Film and heat together.

/// Ratio of defects beyond which only shares of new temperatures are taken.
const SLOW: f64 = 0.7;

/// The smallest share of new temperatures that is taken.
const SMALLEST: f64 = 0.25;

/// Ratio by which shares grow from round to round at most: far from the solution the last two rounds predict little of the next.
const GROWTH: f64 = 2.0;

/// Rounds whose defects are ignored: the first is that of a film without heat.
const SILENT_ROUNDS: usize = 2;

/// Record of the previous rounds.
#[derive(Debug, Default)]
pub struct Relaxation {
    rounds: usize,
    defect: Vec<f64>,
    share: f64,
}

impl Relaxation {
    /// The share of new temperatures to take.
    pub fn share(&self, defect: &[f64]) -> f64 {
        let slow = || dot(defect, defect).sqrt() > SLOW * dot(&self.defect, &self.defect).sqrt();
        if self.rounds == 0 || self.share == 1.0 && (self.rounds < SILENT_ROUNDS || !slow()) {
            return 1.0;
        }
        let change: Vec<f64> = (defect.iter().zip(&self.defect))
            .map(|(r, before)| r - before)
            .collect();
        let best = -self.share * dot(&self.defect, &change) / dot(&change, &change);
        // A defect that grows in the same direction shows that the share was too small.
        let best = if best > 0.0 { best } else { f64::INFINITY };
        best.min(GROWTH * self.share).clamp(SMALLEST, 1.0)
    }

    /// Keeps the defect of a round and the share of it that was taken.
    pub fn taken(&mut self, share: f64, defect: Vec<f64>) {
        self.rounds += 1;
        self.defect = defect;
        self.share = share;
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rounds of T ← T + ω(g(T) − T) until the defect is below 1e-6 of the first.
    fn rounds(g: impl Fn(&[f64]) -> Vec<f64>) -> usize {
        let mut relaxation = Relaxation::default();
        let mut t = vec![0.0; 2];
        for round in 1..200 {
            let defect: Vec<f64> = g(&t).iter().zip(&t).map(|(new, t)| new - t).collect();
            if dot(&defect, &defect).sqrt() < 1e-6 {
                return round;
            }
            let share = relaxation.share(&defect);
            for (t, r) in t.iter_mut().zip(&defect) {
                *t += share * r;
            }
            relaxation.taken(share, defect);
        }
        200
    }

    /// Fast convergence is not relaxed: ln(1e-6)/ln(0.3) = 11.5 rounds.
    #[test]
    fn fast_rounds_take_all() {
        let n = rounds(|t| vec![1.0 - 0.3 * t[0], 0.2 * t[1]]);
        assert!((12..=14).contains(&n), "{n}");
    }

    /// Overshoots by more than 1 would diverge; one that has died down is not paid for in every later round. Shares of 1/4 at 3/4
    /// left of each round would take ln(1e-6)/ln(0.75) = 48 rounds.
    #[test]
    fn overshoots_are_damped_and_forgotten() {
        let n = rounds(|t| vec![1.0 - 1.5 * t[0], 0.0]);
        assert!(n < 12, "{n}");
        let n = rounds(|t| {
            let slope = if t[0].abs() > 0.1 { -1.2 } else { -0.1 };
            vec![slope * (t[0] - 0.01) + 0.01 * t[1], 1.0 - 0.8 * t[1]]
        });
        assert!(n < 40, "{n}");
    }
}
