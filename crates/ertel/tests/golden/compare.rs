//! Comparison of two records, with a description of the differences.

use std::fmt::Write;

use ertel::solution::ROUNDING;

use super::record::{Entry, Record};

/// How records are compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// Everything, to the bit.
    Exact,
    /// Figures within a tenth of their bars, films and figures without a bar within 1e-3 of themselves.
    WithinBars,
}

/// Share of a bar by which figures of other machines may differ.
const SHARE_OF_BAR: f64 = 0.1;

/// Share of itself by which a film, or a figure without a bar, may.
const SHARE_OF_VALUE: f64 = 1e-3;

/// Values that differ beyond figures, of which no more are printed.
const MOST_LINES: usize = 20;

/// Differences between two records.
#[derive(Debug, Default)]
pub struct Difference {
    changes: Vec<Change>,
    n_values: usize,
}

/// A value that is not the same.
#[derive(Debug)]
struct Change {
    section: String,
    key: String,
    old: Option<String>,
    new: Option<String>,
    /// The old error bar, of a figure.
    bar: Option<f64>,
}

/// Whether a section has figures, that of a point of a curve included.
fn has_figures(section: &str) -> bool {
    section == "figures" || section.ends_with(" figures")
}

/// The error bar of a figure, if it is one.
fn bar_of(record: &Record, section: &str, key: &str) -> Option<f64> {
    match has_figures(section) {
        true => record.get(section, &format!("{key} bar"))?.parse().ok(),
        false => None,
    }
}

/// Whether a value counts on another machine: a figure itself, neither its bar nor its place.
fn counts(section: &str, key: &str) -> bool {
    has_figures(section) && !key.contains(' ')
}

/// Whether two figures agree for machines that compute otherwise.
fn agree(key: &str, old: &str, new: &str, bar: Option<f64>) -> bool {
    let (Ok(a), Ok(b)) = (old.parse::<f64>(), new.parse::<f64>()) else {
        return old == new;
    };
    let relative = SHARE_OF_VALUE * a.abs();
    let allowed = match bar {
        Some(bar) if !key.starts_with("film_") || key.contains("temperature") => SHARE_OF_BAR * bar,
        _ => relative,
    };
    // With a bar of zero, rounding counts.
    (a - b).abs() <= allowed.max(ROUNDING * a.abs()) || old == new
}

/// Differences between two records, except the machines that they come from.
pub fn difference(old: &Record, new: &Record, mode: Mode) -> Difference {
    let (before, after) = (old.by_key(), new.by_key());
    let compared = |e: &Entry| mode == Mode::Exact || counts(&e.section, &e.key);
    let mut changes = Vec::new();
    for entry in old.values().filter(|e| compared(e)) {
        let Entry {
            section,
            key,
            value,
        } = entry;
        let bar = bar_of(old, section, key);
        let now = after.get(&(section.as_str(), key.as_str()));
        let same = now.is_some_and(|now| match mode {
            Mode::Exact => now == value,
            Mode::WithinBars => agree(key, value, now, bar),
        });
        if !same {
            changes.push(Change {
                section: section.clone(),
                key: key.clone(),
                old: Some(value.clone()),
                new: now.map(|now| (*now).to_owned()),
                bar,
            });
        }
    }
    for entry in new.values().filter(|e| compared(e)) {
        if !before.contains_key(&(entry.section.as_str(), entry.key.as_str())) {
            changes.push(Change {
                section: entry.section.clone(),
                key: entry.key.clone(),
                old: None,
                new: Some(entry.value.clone()),
                bar: None,
            });
        }
    }
    Difference {
        changes,
        n_values: old.len(),
    }
}

impl Change {
    fn is_of_figure(&self) -> bool {
        counts(&self.section, &self.key)
    }

    /// Size of the change over the old value, where both are numbers.
    fn relative(&self) -> Option<f64> {
        let number = |text: &Option<String>| text.as_ref()?.parse::<f64>().ok();
        let (old, new) = (number(&self.old)?, number(&self.new)?);
        Some((new - old) / old.abs()).filter(|change| change.is_finite())
    }

    fn text(&self) -> String {
        let name = format!("[{}] {}", self.section, self.key);
        match (&self.old, &self.new) {
            (Some(old), Some(new)) => {
                let mut text = format!("  {name}: {old} -> {new}");
                if let Some(relative) = self.relative() {
                    let _ = write!(text, ", {relative:+.1e} of it");
                    let old: f64 = old.parse().unwrap_or(f64::NAN);
                    if let Some(bar) = self.bar.filter(|bar| *bar > 0.0) {
                        let of_bar = relative * old.abs() / bar;
                        let _ = write!(text, ", {of_bar:+.1e} of its bar");
                    }
                }
                text
            }
            (Some(old), None) => format!("- {name}: {old}, removed"),
            (None, Some(new)) => format!("+ {name}: {new}, new"),
            (None, None) => name,
        }
    }
}

impl Difference {
    /// Whether nothing differs.
    pub fn is_empty(&self) -> bool {
        self.changes.is_empty()
    }

    /// How many values differ, and the largest change: that of a figure where one changed, for balances are rounding.
    pub fn title(&self) -> String {
        let largest = |of: &dyn Fn(&&Change) -> bool| {
            (self.changes.iter().filter(of))
                .filter_map(|change| Some((change.relative()?.abs(), change)))
                .max_by(|a, b| a.0.total_cmp(&b.0))
        };
        let mut title = format!("{} of {} values", self.changes.len(), self.n_values);
        if let Some((relative, change)) =
            largest(&|c| c.is_of_figure()).or_else(|| largest(&|_| true))
        {
            let Change { section, key, .. } = change;
            let _ = write!(title, ", at the most {relative:.1e} of [{section}] {key}");
        }
        title
    }

    /// In words: all figures, and the first of the other values.
    pub fn text(&self) -> String {
        let (figures, others): (Vec<&Change>, Vec<&Change>) = self
            .changes
            .iter()
            .partition(|change| change.is_of_figure());
        let mut text = String::new();
        for change in figures.iter().chain(others.iter().take(MOST_LINES)) {
            let _ = writeln!(text, "{}", change.text());
        }
        if others.len() > MOST_LINES {
            let more = others.len() - MOST_LINES;
            let _ = writeln!(
                text,
                "  and {more} more beyond the figures: `git diff` after --update shows them"
            );
        }
        text
    }
}
