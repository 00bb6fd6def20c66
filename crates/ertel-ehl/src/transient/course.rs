//! A quantity over time.
//!
//! ```text
//!   table: straight lines between rows        smooth: cubics between rows without new extrema (Fritsch and Butland 1984)
//!   sine: v_0 + A sin(2π (t − t_0)/period) from t_0 on        step: v_0 up to t_0, v_1 after it
//! ```

use std::f64::consts::TAU;

/// A quantity over time, in the units of its creator.
#[derive(Clone, Debug, PartialEq)]
pub enum Course {
    /// The same at all times.
    Constant(f64),
    /// Straight lines between instants and values; before the first and after the last as there.
    Table(Vec<[f64; 2]>),
    /// Smooth curves between them.
    Smooth(Vec<[f64; 2]>),
    /// A sine from an instant on.
    Sine {
        /// Value before it, and mean.
        mean: f64,
        /// Amplitude.
        amplitude: f64,
        /// Period.
        period: f64,
        /// When it begins.
        start: f64,
    },
    /// Another value after an instant.
    Step {
        /// Up to it.
        from: f64,
        /// After it.
        to: f64,
        /// When.
        at: f64,
    },
}

/// Steps of a period of a sine at the least.
const STEPS_OF_PERIOD: f64 = 8.0;

impl Course {
    /// Value at an instant; at a step, the value before it.
    pub fn at(&self, time: f64) -> f64 {
        match self {
            Course::Constant(value) => *value,
            Course::Table(rows) => between(rows, time, |[a, b], share, _| a + share * (b - a)),
            Course::Smooth(rows) => between(rows, time, |[a, b], s, i| {
                let width = rows[i + 1][0] - rows[i][0];
                let [start, end] = [i, i + 1].map(|i| width * slope(rows, i));
                let (s2, s3) = (s * s, s * s * s);
                (2.0 * s3 - 3.0 * s2 + 1.0) * a
                    + (3.0 * s2 - 2.0 * s3) * b
                    + (s3 - 2.0 * s2 + s) * start
                    + (s3 - s2) * end
            }),
            Course::Sine {
                mean,
                amplitude,
                period,
                start,
            } => mean + amplitude * (TAU * (time - start).max(0.0) / period).sin(),
            Course::Step { from, to, at } => {
                if time > *at {
                    *to
                } else {
                    *from
                }
            }
        }
    }

    /// Instants at which it has a kink or a step.
    pub fn kinks(&self) -> Vec<f64> {
        match self {
            Course::Constant(_) => Vec::new(),
            Course::Table(rows) => rows.iter().map(|[t, _]| *t).collect(),
            Course::Smooth(rows) => [rows.first(), rows.last()]
                .into_iter()
                .flatten()
                .map(|[t, _]| *t)
                .collect(),
            Course::Sine { start, .. } => vec![*start],
            Course::Step { at, .. } => vec![*at],
        }
    }

    /// Largest step from an instant that resolves the course: to the second row of a smooth curve, a share of a period of a sine. Kinks end steps anyway.
    pub fn visible(&self, time: f64) -> f64 {
        match self {
            Course::Constant(_) | Course::Table(_) | Course::Step { .. } => f64::INFINITY,
            Course::Smooth(rows) => {
                let next = rows.partition_point(|[t, _]| *t <= time);
                rows.get(next + 1).map_or(f64::INFINITY, |[t, _]| t - time)
            }
            Course::Sine { period, .. } => period / STEPS_OF_PERIOD,
        }
    }

    /// Steps up to an instant that resolve the course.
    pub fn least_steps(&self, end: f64) -> f64 {
        match self {
            Course::Constant(_) => 0.0,
            Course::Step { .. } => 1.0,
            Course::Table(rows) | Course::Smooth(rows) => rows.len() as f64,
            Course::Sine { period, start, .. } => STEPS_OF_PERIOD * (end - start).max(0.0) / period,
        }
    }

    /// Instant of the first change; `None` of a constant.
    pub fn first_change(&self) -> Option<f64> {
        match self {
            Course::Constant(_) => None,
            Course::Step { at, .. } => Some(*at),
            Course::Table(rows) | Course::Smooth(rows) => rows.first().map(|[t, _]| *t),
            Course::Sine { start, .. } => Some(*start),
        }
    }

    /// Largest size up to an instant.
    pub fn largest(&self, end: f64) -> f64 {
        let of =
            |values: &mut dyn Iterator<Item = f64>| values.fold(0.0_f64, |m, v| m.max(v.abs()));
        match self {
            Course::Sine { period, start, .. } => {
                // Extremes lie at quarters of the period.
                let quarters = (4.0 * (end - start) / period).floor().clamp(0.0, 4.0) as usize;
                let extremes = (0..=quarters).map(|i| start + 0.25 * i as f64 * period);
                of(&mut extremes.chain([0.0, end]).map(|t| self.at(t)))
            }
            _ => {
                let kinks = self.kinks().into_iter().filter(|t| *t < end);
                let after = |t: f64| self.at(t + f64::EPSILON * t.abs().max(f64::MIN_POSITIVE));
                let rows: Vec<f64> = match self {
                    Course::Smooth(rows) => rows.iter().map(|[t, _]| *t).collect(),
                    _ => Vec::new(),
                };
                let rows = rows.into_iter().filter(|t| *t < end);
                let all: Vec<f64> = kinks.chain(rows).chain([0.0]).collect();
                let values = all.into_iter().flat_map(|t| [self.at(t), after(t)]);
                of(&mut values.chain([self.at(end)]))
            }
        }
    }

    /// The same with times and values in other units.
    #[must_use]
    pub fn scaled(&self, time: f64, value: f64) -> Course {
        let rows = |rows: &[[f64; 2]]| rows.iter().map(|[t, v]| [time * t, value * v]).collect();
        match self {
            Course::Constant(v) => Course::Constant(value * v),
            Course::Table(own) => Course::Table(rows(own)),
            Course::Smooth(own) => Course::Smooth(rows(own)),
            Course::Sine {
                mean,
                amplitude,
                period,
                start,
            } => Course::Sine {
                mean: value * mean,
                amplitude: value * amplitude,
                period: time * period,
                start: time * start,
            },
            Course::Step { from, to, at } => Course::Step {
                from: value * from,
                to: value * to,
                at: time * at,
            },
        }
    }
}

/// Value between two rows from those there, the share of the way and the first row.
fn between(rows: &[[f64; 2]], time: f64, value: impl Fn([f64; 2], f64, usize) -> f64) -> f64 {
    let behind = rows.partition_point(|[t, _]| *t < time);
    match behind {
        0 => rows.first().map_or(f64::NAN, |[_, v]| *v),
        n if n == rows.len() => rows[n - 1][1],
        n => {
            let [[t0, a], [t1, b]] = [rows[n - 1], rows[n]];
            value([a, b], (time - t0) / (t1 - t0), n - 1)
        }
    }
}

/// Slope at a row: a mean of the two adjacent slopes that is zero where they differ in sign; at the ends zero, as the value stays the same beyond.
fn slope(rows: &[[f64; 2]], i: usize) -> f64 {
    if i == 0 || i + 1 == rows.len() {
        return 0.0;
    }
    let [[t0, v0], [t1, v1], [t2, v2]] = [rows[i - 1], rows[i], rows[i + 1]];
    let [a, b] = [(v1 - v0) / (t1 - t0), (v2 - v1) / (t2 - t1)];
    if a * b <= 0.0 {
        return 0.0;
    }
    let share = (1.0 + (t2 - t1) / (t2 - t0)) / 3.0;
    a * b / (share * b + (1.0 - share) * a)
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// By hand: lines, a sine at a quarter of its period, a step on either side; sizes, kinks, other units.
    #[test]
    fn courses_by_hand() {
        let table = Course::Table(vec![[1.0, 2.0], [3.0, -4.0]]);
        for (time, value) in [(0.0, 2.0), (2.0, -1.0), (3.0, -4.0), (9.0, -4.0)] {
            assert_relative_eq!(table.at(time), value);
        }
        assert_eq!(table.largest(2.5), 2.5);
        assert_eq!(table.largest(9.0), 4.0);
        let sine = Course::Sine {
            mean: 1.0,
            amplitude: 0.5,
            period: 4.0,
            start: 2.0,
        };
        assert_relative_eq!(sine.at(1.0), 1.0);
        assert_relative_eq!(sine.at(3.0), 1.5);
        assert_relative_eq!(sine.largest(10.0), 1.5);
        assert_relative_eq!(sine.largest(2.5), 1.0 + 0.5 * 0.5_f64.sqrt());
        let step = Course::Step {
            from: 1.0,
            to: -3.0,
            at: 2.0,
        };
        assert_eq!([step.at(2.0), step.at(2.001)], [1.0, -3.0]);
        assert_eq!([step.largest(2.0), step.largest(5.0)], [1.0, 3.0]);
        let scaled = table.scaled(10.0, 2.0);
        assert_relative_eq!(scaled.at(20.0), -2.0);
        assert_eq!(scaled.kinks(), vec![10.0, 30.0]);
        // Two periods, each in eight steps.
        assert_eq!(sine.least_steps(10.0), 16.0);
        assert_eq!(sine.least_steps(1.0), 0.0);
        let changes = [&table, &sine, &step].map(Course::first_change);
        assert_eq!(changes, [Some(1.0), Some(2.0), Some(2.0)]);
    }

    /// Slopes of 1 over a width of 1 and ½ over 2: α = (1 + 2/3)/3, D = ½/(½α + 1 − α) = 9/13 between them (Fritsch and Butland 1984), by hand.
    #[test]
    fn slope_between_uneven_rows() {
        let smooth = Course::Smooth(vec![[0.0, 0.0], [1.0, 1.0], [3.0, 2.0]]);
        let slope = (smooth.at(1.0 + 1e-6) - smooth.at(1.0 - 1e-6)) / 2e-6;
        assert_relative_eq!(slope, 9.0 / 13.0, max_relative = 1e-5);
    }

    /// Smooth curves pass through their rows with one slope, and go beyond none of them.
    #[test]
    fn smooth_curves_make_no_extremum() {
        let rows = vec![[0.0, 0.0], [1.0, 0.1], [1.5, 2.0], [4.0, 2.0], [5.0, 1.0]];
        let smooth = Course::Smooth(rows.clone());
        for [t, v] in &rows {
            assert_relative_eq!(smooth.at(*t), *v, epsilon = 1e-12);
        }
        for row in rows.windows(2) {
            let [[t0, a], [t1, b]] = [row[0], row[1]];
            for i in 0..=20 {
                let value = smooth.at(t0 + 0.05 * f64::from(i) * (t1 - t0));
                assert!((a.min(b) - 1e-12..=a.max(b) + 1e-12).contains(&value));
            }
        }
        for [t, _] in &rows[1..4] {
            let [low, high] = [-1e-7, 1e-7].map(|e| (smooth.at(t + e) - smooth.at(*t)) / e);
            assert_relative_eq!(low, high, epsilon = 1e-5);
        }
        assert_eq!(smooth.kinks(), vec![0.0, 5.0]);
        // A pulse between 1 and 4 is seen from 0.5 on.
        assert_eq!(
            [0.0, 0.5, 1.0, 4.5].map(|t| smooth.visible(t)),
            [1.5, 1.0, 3.0, f64::INFINITY]
        );
    }
}
