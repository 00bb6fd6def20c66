//! Axes: range, scale, ticks.

/// How values are spread over the axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AxisScale {
    /// Equal steps.
    Linear,
    /// Equal steps, ticks at whole numbers only.
    Count,
    /// Equal ratios; values must be positive.
    Log,
}

/// One axis: label (markup of labels: `*p*` italic, `_{h}` and `^{3}` scripts), range and scale.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// Label with its unit.
    pub label: String,
    /// Lower end.
    pub low: f64,
    /// Upper end.
    pub high: f64,
    /// How values are spread.
    pub scale: AxisScale,
}

impl Axis {
    /// Linear axis over exactly this range; a drawable one instead, where the ends are not finite, not in order,
    /// too large, or too near to each other to be distinguished.
    pub fn linear(label: &str, low: f64, high: f64) -> Axis {
        let (low, high) = match low.is_finite() && high.is_finite() {
            true => apart(low.min(high), low.max(high)),
            false => (0.0, 1.0),
        };
        Axis {
            label: label.to_owned(),
            low,
            high,
            scale: AxisScale::Linear,
        }
    }

    /// Axis over the numbers 1 to n of steps, iterations or the like.
    pub fn count(label: &str, n: usize) -> Axis {
        Axis {
            scale: AxisScale::Count,
            ..Axis::linear(label, 0.5, n.max(2) as f64 + 0.5)
        }
    }

    /// Linear axis that covers the values, rounded outwards to whole ticks.
    pub fn linear_around(label: &str, values: impl IntoIterator<Item = f64>) -> Axis {
        let (low, high) = range(values);
        let (low, high) = if high > low {
            apart(low, high)
        } else {
            (
                low - 0.5 * low.abs().max(1.0),
                high + 0.5 * high.abs().max(1.0),
            )
        };
        let step = tick_step(high - low);
        Axis::linear(
            label,
            (low / step).floor() * step,
            (high / step).ceil() * step,
        )
    }

    /// Logarithmic axis over the positive values, rounded outwards to 1, 2 or 5 times a power of ten.
    pub fn log_close_around(label: &str, values: impl IntoIterator<Item = f64>) -> Axis {
        let (low, high) = range(values.into_iter().filter(|v| *v > 0.0).map(within_logs));
        let wide = Axis::log_around(label, [low, high]);
        let ends = || {
            let powers = (-300..300).map(|e| 10f64.powi(e));
            let ends = powers.flat_map(|p| [p, 2.0 * p, 5.0 * p]);
            ends.filter(|v| (0.999 * wide.low..=1.001 * wide.high).contains(v))
        };
        // Apart, where all values are about the same.
        let lower = ends()
            .filter(|v| *v <= 1.001 * low && *v < 0.7 * wide.high)
            .fold(wide.low, f64::max);
        let upper = ends()
            .filter(|v| *v >= 0.999 * high && *v > 1.5 * lower)
            .fold(wide.high, f64::min);
        Axis {
            low: lower,
            high: upper,
            ..wide
        }
    }

    /// Logarithmic axis over the decades that cover the positive values.
    pub fn log_around(label: &str, values: impl IntoIterator<Item = f64>) -> Axis {
        let positive = values.into_iter().filter(|v| *v > 0.0 && v.is_finite());
        let (low, high) = range(positive.map(|v| within_logs(v).log10()));
        let (low, high) = (low.floor(), high.ceil());
        Axis {
            label: label.to_owned(),
            low: 10f64.powf(low),
            high: 10f64.powf(if high > low { high } else { low + 1.0 }),
            scale: AxisScale::Log,
        }
    }

    /// Position of a value between 0 (low) and 1 (high); not finite for a value ≤ 0 on a log axis.
    pub fn position(&self, value: f64) -> f64 {
        match self.scale {
            AxisScale::Linear | AxisScale::Count => (value - self.low) / (self.high - self.low),
            AxisScale::Log if value > 0.0 => (value / self.low).ln() / (self.high / self.low).ln(),
            AxisScale::Log => f64::NAN,
        }
    }

    /// Labelled ticks: value and text in label markup.
    pub fn ticks(&self) -> Vec<(f64, String)> {
        match self.scale {
            AxisScale::Linear | AxisScale::Count => {
                let step = self.step();
                multiples(self.low, self.high, step)
                    .map(|v| (v, tick_label(v, step)))
                    .collect()
            }
            AxisScale::Log => {
                let (low, high) = self.decades();
                let between: Vec<(f64, String)> = self
                    .within_decades(&[1.0, 2.0, 5.0])
                    .map(|v| (v, plain_label(v)))
                    .collect();
                if between.len() >= 2 && self.high / self.low <= labels_within(&between) {
                    return between;
                }
                // At most about eight labels
                let every = ((high - low).max(0) as usize).div_ceil(8).max(1);
                let powers: Vec<(f64, String)> = (low..=high)
                    .filter(|e| e.rem_euclid(every as i32) == 0)
                    .map(|e| (10f64.powi(e), power_label(e)))
                    .collect();
                if powers.len() >= 2 {
                    return powers;
                }
                // Too short for either: round numbers as on an axis of equal steps.
                let step = tick_step(self.high - self.low);
                multiples(self.low, self.high, step)
                    .map(|v| (v, tick_label(v, step)))
                    .collect()
            }
        }
    }

    /// Ticks without labels, between the labelled ones.
    pub fn minor_ticks(&self) -> Vec<f64> {
        match self.scale {
            AxisScale::Count => {
                let step = (self.step() / 5.0).round().max(1.0);
                multiples(self.low, self.high, step).collect()
            }
            AxisScale::Linear => {
                let step = self.step();
                let leading = step / 10f64.powf(step.log10().floor());
                let parts = if (leading - 2.0).abs() < 0.1 {
                    4.0
                } else {
                    5.0
                };
                multiples(self.low, self.high, step / parts).collect()
            }
            AxisScale::Log => {
                let (low, high) = self.decades();
                let inner: &[f64] = match high - low {
                    ..=6 => &[2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0],
                    7..=60 => &[1.0],
                    _ => &[],
                };
                self.within_decades(inner).collect()
            }
        }
    }

    /// These multiples of the powers of ten, as far as they lie on the axis.
    fn within_decades(&self, multiples: &[f64]) -> impl Iterator<Item = f64> {
        let first = (self.low.log10() + 1e-9).floor() as i32;
        let last = (self.high.log10() + 1e-9).floor() as i32;
        let ends = 0.999 * self.low..=1.001 * self.high;
        (first..=last)
            .flat_map(move |e| multiples.iter().map(move |m| m * 10f64.powi(e)))
            .filter(move |v| ends.contains(v))
    }

    /// Distance of labelled ticks.
    fn step(&self) -> f64 {
        let step = tick_step(self.high - self.low);
        match self.scale {
            AxisScale::Count => step.max(1.0),
            _ => step,
        }
    }

    fn decades(&self) -> (i32, i32) {
        (
            (self.low.log10() - 1e-9).ceil() as i32,
            (self.high.log10() + 1e-9).floor() as i32,
        )
    }
}

/// Ratio of the ends of a logarithmic axis up to which there is room for its labels at 1, 2 and 5 times the powers of ten.
fn labels_within(ticks: &[(f64, String)]) -> f64 {
    let longest = ticks.iter().map(|t| t.1.chars().count()).max();
    match longest.unwrap_or(0) {
        ..=4 => 1.05e4,
        5..=6 => 1.05e3,
        _ => 50.0,
    }
}

/// Label of a number that is 1, 2 or 5 times a power of ten.
fn plain_label(value: f64) -> String {
    if (0.9e-4..1.1e5).contains(&value) {
        let decimals = (-(value.log10() + 1e-9).floor()).max(0.0) as usize;
        return format!("{value:.decimals$}");
    }
    let exponent = (value.log10() + 1e-9).floor() as i32;
    let multiple = (value / 10f64.powi(exponent)).round();
    match multiple as i32 {
        1 => power_label(exponent),
        m => format!("{m}·{}", power_label(exponent)),
    }
}

/// Smallest and largest finite value; (0, 1) without any.
fn range(values: impl IntoIterator<Item = f64>) -> (f64, f64) {
    let (low, high) = values
        .into_iter()
        .filter(|v| v.is_finite())
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| {
            (l.min(v), h.max(v))
        });
    if low <= high { (low, high) } else { (0.0, 1.0) }
}

/// Distance 1, 2 or 5 times a power of ten that gives four to eight ticks.
pub fn tick_step(span: f64) -> f64 {
    let rough = span / 6.0;
    let power = 10f64.powf(rough.log10().floor());
    match rough / power {
        f if f < 1.5 => power,
        f if f < 3.5 => 2.0 * power,
        f if f < 7.5 => 5.0 * power,
        _ => 10.0 * power,
    }
}

fn multiples(low: f64, high: f64, step: f64) -> impl Iterator<Item = f64> {
    let first = (low / step - 1e-6).ceil() as i64;
    let last = (high / step + 1e-6).floor() as i64;
    // Never more than can be drawn, whatever the ends are.
    (first..=last.min(first.saturating_add(MOST_TICKS))).map(move |i| i as f64 * step)
}

/// Most ticks of an axis, minor ones among them.
const MOST_TICKS: i64 = 100;

/// Largest size of an end of an axis, and least length of an axis over the size of its ends.
const LARGEST: f64 = 1e300;
const LEAST_LENGTH: f64 = 1e-9;

/// Ends in order that are so far apart that ticks between them differ.
fn apart(low: f64, high: f64) -> (f64, f64) {
    let (low, high) = (low.clamp(-LARGEST, LARGEST), high.clamp(-LARGEST, LARGEST));
    let size = low.abs().max(high.abs());
    match size {
        s if s < 1.0 / LARGEST => (0.0, 1.0),
        s if high - low > LEAST_LENGTH * s => (low, high),
        s => (low - 0.5 * s, high + 0.5 * s),
    }
}

/// A positive number of which powers of ten are at hand.
fn within_logs(value: f64) -> f64 {
    value.clamp(1.0 / LARGEST, LARGEST)
}

/// Number with as many decimals as the tick distance needs.
pub fn tick_label(value: f64, step: f64) -> String {
    let decimals = (-(step.log10() + 1e-9).floor()).max(0.0) as usize;
    let text = format!("{value:.decimals$}");
    let zero = text
        .trim_start_matches('-')
        .chars()
        .all(|c| c == '0' || c == '.');
    match text.strip_prefix('-') {
        Some(digits) if zero => digits.to_owned(),
        Some(digits) => format!("−{digits}"),
        None => text,
    }
}

fn power_label(exponent: i32) -> String {
    match exponent {
        0 => "1".to_owned(),
        1 => "10".to_owned(),
        e if e < 0 => format!("10^{{−{}}}", -e),
        e => format!("10^{{{e}}}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(axis: &Axis) -> Vec<String> {
        axis.ticks().into_iter().map(|t| t.1).collect()
    }

    #[test]
    fn linear_ticks_are_round_numbers() {
        let axis = Axis::linear("", -2.5, 1.5);
        assert_eq!(
            labels(&axis),
            [
                "−2.5", "−2.0", "−1.5", "−1.0", "−0.5", "0.0", "0.5", "1.0", "1.5"
            ]
        );
        let axis = Axis::linear_around("", [0.0, 1.13]);
        assert_eq!((axis.low, axis.high), (0.0, 1.2000000000000002));
    }

    #[test]
    fn log_ticks_are_powers_of_ten() {
        let axis = Axis::log_around("", [3e-4, 20.0, 0.0, f64::NAN]);
        assert_eq!((axis.low, axis.high), (1e-4, 100.0));
        assert_eq!(
            labels(&axis),
            [
                "10^{−4}",
                "10^{−3}",
                "10^{−2}",
                "10^{−1}",
                "1",
                "10",
                "10^{2}"
            ]
        );
        assert!((axis.position(0.1) - 0.5).abs() < 1e-12);
        assert!(axis.position(0.0).is_nan());
    }

    #[test]
    fn a_short_log_axis_has_labels_between_powers_of_ten() {
        let axis = Axis::log_close_around("", [0.3, 3.0]);
        assert_eq!((axis.low, axis.high), (0.2, 5.0));
        assert_eq!(labels(&axis), ["0.2", "0.5", "1", "2", "5"]);
        let minor = axis.minor_ticks();
        assert!(
            minor.iter().any(|v| (v - 0.3).abs() < 1e-12) && minor.len() == 12,
            "{minor:?}"
        );
        let axis = Axis::log_close_around("", [12.0, 1800.0]);
        assert_eq!((axis.low, axis.high), (10.0, 2000.0));
        assert_eq!(
            labels(&axis),
            ["10", "20", "50", "100", "200", "500", "1000", "2000"]
        );
        let axis = Axis::log_close_around("", [0.011, 90.0]);
        let shown = labels(&axis);
        assert_eq!((shown.len(), &*shown[1], &*shown[11]), (13, "0.02", "50"));
        // Four decades of long numbers have no room between them.
        let axis = Axis::log_close_around("", [1e-4, 1.0]);
        assert_eq!(labels(&axis).len(), 5);
    }

    #[test]
    fn counts_have_whole_ticks() {
        assert_eq!(labels(&Axis::count("", 3)), ["1", "2", "3"]);
        assert_eq!(Axis::count("", 11).minor_ticks().len(), 11);
    }

    /// The number that a label says, read as a person does.
    fn read(label: &str) -> f64 {
        let plain = label.replace('−', "-");
        match plain.split_once("10^{") {
            Some((lead, power)) => {
                let lead = lead.trim_end_matches('·');
                let power = power.trim_end_matches('}');
                format!("{}e{power}", if lead.is_empty() { "1" } else { lead })
                    .parse()
                    .unwrap()
            }
            None => plain.parse().unwrap(),
        }
    }

    /// Of thousands of ranges: ticks lie on the axis, are 2 to 13, and their labels say where they are.
    #[test]
    fn ticks_of_any_range_are_few_and_true() {
        // A linear congruential generator (Knuth, MMIX).
        let mut state = 35_u64;
        let mut random = || {
            state = state
                .wrapping_mul(6364136223846793005)
                .wrapping_add(1442695040888963407);
            (state >> 11) as f64 / (1_u64 << 53) as f64
        };
        let mut axes = Vec::new();
        for _ in 0..5000 {
            let middle = (random() - 0.5).signum() * 10f64.powf(40.0 * random() - 20.0);
            let length = middle.abs() * 10f64.powf(10.0 * random() - 7.0);
            let ends = [middle - length * random(), middle + length];
            axes.extend([
                Axis::linear("", ends[0], ends[1]),
                Axis::linear_around("", ends),
            ]);
            let low = 10f64.powf(40.0 * random() - 20.0);
            let ends = [low, low * 10f64.powf(10f64.powf(5.0 * random() - 3.5))];
            axes.extend([Axis::log_around("", ends), Axis::log_close_around("", ends)]);
            axes.push(Axis {
                low: ends[0],
                high: ends[1],
                ..Axis::log_around("", ends)
            });
        }
        let odd = [
            f64::NAN,
            f64::INFINITY,
            0.0,
            5e-324,
            1e-310,
            f64::MAX,
            f64::MIN,
            -1.0,
            1.0,
            1.0 + 1e-15,
        ];
        for p in odd {
            for q in odd {
                axes.extend([
                    Axis::linear("", p, q),
                    Axis::linear_around("", [p, q]),
                    Axis::log_around("", [p, q]),
                    Axis::log_close_around("", [p, q]),
                ]);
            }
        }
        for axis in axes {
            let ticks = axis.ticks();
            assert!((2..=13).contains(&ticks.len()), "{axis:?}: {ticks:?}");
            assert!(axis.minor_ticks().len() <= 101, "{axis:?}");
            let room = 2e-3 * (axis.high - axis.low) + 2e-3 * axis.low.abs().min(axis.high.abs());
            for (value, label) in &ticks {
                assert!(
                    (axis.low - room..=axis.high + room).contains(value),
                    "{axis:?}: {value}"
                );
                let size = axis.low.abs().max(axis.high.abs());
                assert!(
                    (read(label) - value).abs() <= 1e-12 * size,
                    "{axis:?}: {value} is not {label}"
                );
            }
        }
    }

    #[test]
    fn empty_or_constant_data_still_make_an_axis() {
        for axis in [
            Axis::linear_around("", []),
            Axis::linear_around("", [3.0, 3.0]),
            Axis::log_around("", []),
            Axis::log_around("", [10.0]),
            Axis::log_close_around("", [2.0, 2.0]),
            Axis::log_close_around("", [9.9999, 10.0]),
            Axis::linear("", 1.0, f64::NAN),
        ] {
            assert!(axis.low < axis.high && axis.low.is_finite() && axis.high.is_finite());
            assert!(axis.ticks().len() >= 2);
        }
    }
}
