//! Warnings about a case or its results, by kind; those of many points are merged.

mod kind;

use std::collections::BTreeMap;
use std::fmt;
use std::ops::Deref;

use ertel_rheology::provenance::RangeWarning;
use serde::{Deserialize, Serialize};

pub use kind::{Explanation, Severity, WarningKind};

/// A warning, in a sentence or two.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Warning {
    /// Kind.
    pub kind: WarningKind,
    /// The sentence.
    pub text: String,
    /// How far a limit is exceeded, to find the worst of one kind.
    pub excess: f64,
    /// Whether the case does not want to see it.
    #[serde(default)]
    pub is_silenced: bool,
}

impl Warning {
    /// A warning whose kind has no worst.
    pub fn new(kind: WarningKind, text: impl Into<String>) -> Warning {
        Warning {
            kind,
            text: text.into(),
            excess: 0.0,
            is_silenced: false,
        }
    }

    /// A warning about a limit, and how far it is exceeded.
    pub fn beyond(kind: WarningKind, excess: f64, text: impl Into<String>) -> Warning {
        Warning {
            excess,
            ..Warning::new(kind, text)
        }
    }

    /// Whether it is shown as a warning: no note, and not silenced.
    pub fn is_shown(&self) -> bool {
        !self.kind.is_note() && !self.is_silenced
    }

    /// The same where a record keeps it: `silence` are the kinds that its study silences now.
    pub fn is_shown_with(&self, silence: &[WarningKind]) -> bool {
        !self.kind.is_note() && !self.kind.is_silenced_by(silence)
    }

    /// Whether it is shown as a note.
    pub fn is_shown_note(&self) -> bool {
        self.kind.is_note() && !self.is_silenced
    }

    /// The sentence and the code behind it, for reports: `the film … [thin-film]`.
    pub fn coded(&self) -> String {
        format!("{} [{}]", self.text, self.kind)
    }

    /// Whether one line can show both.
    fn is_like(&self, other: &Warning) -> bool {
        self.kind == other.kind && (!self.kind.has_own_words() || self.text == other.text)
    }
}

/// Marks those of the given kinds as silenced, unless they may not be.
pub fn silence(warnings: &mut [Warning], kinds: &[WarningKind]) {
    for warning in warnings {
        warning.is_silenced = warning.kind.is_silenced_by(kinds);
    }
}

/// How many warnings of each kind are silenced, by code.
pub fn silenced(warnings: &[Warning]) -> BTreeMap<&'static str, usize> {
    let mut counts = BTreeMap::new();
    for warning in warnings.iter().filter(|w| w.is_silenced) {
        *counts.entry(warning.kind.code()).or_default() += 1;
    }
    counts
}

impl From<&RangeWarning> for Warning {
    fn from(warning: &RangeWarning) -> Warning {
        let (kind, excess) = match warning {
            RangeWarning::PressureAbove {
                pressure,
                limit,
                of_law,
                ..
            } => match of_law {
                true => (WarningKind::LawRange, pressure / limit),
                false => (WarningKind::PressureRange, pressure / limit),
            },
            RangeWarning::Temperature {
                temperature, range, ..
            } => (
                WarningKind::TemperatureRange,
                (range.lowest - temperature).max(temperature - range.highest),
            ),
        };
        Warning::beyond(kind, excess, warning.to_string())
    }
}

impl Deref for Warning {
    type Target = str;

    fn deref(&self) -> &str {
        &self.text
    }
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

/// The sentences alone, without notes.
pub fn texts(warnings: &[Warning]) -> Vec<&str> {
    (warnings.iter().filter(|w| w.is_shown()))
        .map(|w| &**w)
        .collect()
}

/// Those of notes.
pub fn notes(warnings: &[Warning]) -> Vec<&str> {
    (warnings.iter().filter(|w| w.is_shown_note()))
        .map(|w| &**w)
        .collect()
}

/// The codes of [`texts`].
pub fn codes(warnings: &[Warning]) -> Vec<WarningKind> {
    (warnings.iter().filter(|w| w.is_shown()))
        .map(|w| w.kind)
        .collect()
}

/// Warnings of one kind at several points.
#[derive(Clone, Debug, PartialEq)]
pub struct Merged {
    /// The worst of them.
    pub worst: Warning,
    /// Its point.
    pub worst_point: usize,
    /// The points, in order.
    pub points: Vec<usize>,
    /// Whether all say the same.
    pub alike: bool,
}

/// Warnings of points, those of one kind together, in the order in which they first occur.
pub fn by_kind<'a>(warnings: impl IntoIterator<Item = (usize, &'a Warning)>) -> Vec<Merged> {
    let mut all: Vec<Merged> = Vec::new();
    for (point, warning) in warnings {
        let Some(merged) = all.iter_mut().find(|m| m.worst.is_like(warning)) else {
            all.push(Merged {
                worst: warning.clone(),
                worst_point: point,
                points: vec![point],
                alike: true,
            });
            continue;
        };
        if merged.points.last() != Some(&point) {
            merged.points.push(point);
        }
        merged.alike &= merged.worst.text == warning.text;
        if warning.excess > merged.worst.excess {
            merged.worst = warning.clone();
            merged.worst_point = point;
        }
    }
    all
}

impl Merged {
    /// A warning of this kind with another text, silenced as the worst is.
    pub fn with_text(&self, text: String) -> Warning {
        Warning {
            text,
            ..self.worst.clone()
        }
    }

    /// In one line, points counted from 1: `points 2 to 5: the film …`; `of` is how many points there are.
    pub fn line(&self, of: usize) -> String {
        let place = match self.points[..] {
            [one] => format!("point {}", one + 1),
            _ if self.points.len() == of => all(of, "points"),
            _ => format!("points {}", ranges(&self.points)),
        };
        self.with_worst(&place, &format!("point {}", self.worst_point + 1))
    }

    /// The same of contacts by their names: `2 of 9 contacts, worst at ball 0, inner ring: the film …`.
    pub fn line_of<'a>(&self, of: usize, name: impl Fn(usize) -> &'a str) -> String {
        let worst = name(self.worst_point);
        match self.points.len() {
            1 => self.with_worst(worst, worst),
            n if n == of => self.with_worst(&all(of, "contacts"), worst),
            n => self.with_worst(&format!("{n} of {of} contacts"), worst),
        }
    }

    fn with_worst(&self, place: &str, worst: &str) -> String {
        let text = &self.worst.text;
        match self.alike || self.points.len() == 1 {
            true => format!("{place}: {text}"),
            false => format!("{place}, worst at {worst}: {text}"),
        }
    }
}

/// `all 5 points`, `both contacts`.
fn all(n: usize, what: &str) -> String {
    match n {
        2 => format!("both {what}"),
        n => format!("all {n} {what}"),
    }
}

/// `1, 3 to 5` of indices from 0, in order; long lists end in how many more there are.
fn ranges(points: &[usize]) -> String {
    const MOST: usize = 6;
    let mut runs: Vec<[usize; 2]> = Vec::new();
    for point in points {
        match runs.last_mut() {
            Some([_, last]) if *last + 1 == *point => *last = *point,
            _ => runs.push([*point, *point]),
        }
    }
    let shown = runs
        .iter()
        .take(MOST)
        .map(|[first, last]| match last - first {
            0 => format!("{}", first + 1),
            1 => format!("{}, {}", first + 1, last + 1),
            _ => format!("{} to {}", first + 1, last + 1),
        });
    let mut text = shown.collect::<Vec<_>>().join(", ");
    let more: usize = runs.iter().skip(MOST).map(|[a, b]| b - a + 1).sum();
    if more > 0 {
        text += &format!(" and {more} more");
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    fn thin(nm: f64) -> Warning {
        Warning::beyond(WarningKind::ThinFilm, -nm, format!("film {nm} nm"))
    }

    #[test]
    fn one_kind_is_one_line_with_the_worst() {
        let other = Warning::new(WarningKind::NoEffect, "no title");
        let films = [9.0, 7.0, 8.0].map(thin);
        let all = [
            (0, &films[0]),
            (1, &films[1]),
            (1, &other),
            (2, &films[2]),
            (4, &other),
        ];
        let merged = by_kind(all);
        let lines: Vec<String> = merged.iter().map(|m| m.line(5)).collect();
        assert_eq!(
            lines,
            [
                "points 1 to 3, worst at point 2: film 7 nm",
                "points 2, 5: no title"
            ]
        );
        let few: Vec<String> = by_kind(all).iter().map(|m| m.line(3)).collect();
        assert!(
            few[0].starts_with("all 3 points, worst at point 2"),
            "{few:?}"
        );
        let two = [(0, &films[0]), (1, &films[1])];
        assert_eq!(
            by_kind(two)[0].line(2),
            "both points, worst at point 2: film 7 nm"
        );
    }

    /// Contacts have names: that of the worst is shown.
    #[test]
    fn contacts_are_named() {
        let films = [9.0, 7.0, 8.0].map(thin);
        let merged = by_kind(films.iter().enumerate());
        let name = |i: usize| ["inner ring", "outer ring", "rib"][i];
        assert_eq!(
            merged[0].line_of(9, name),
            "3 of 9 contacts, worst at outer ring: film 7 nm"
        );
        assert_eq!(
            merged[0].line_of(3, name),
            "all 3 contacts, worst at outer ring: film 7 nm"
        );
        let alike = [thin(9.0), thin(9.0)];
        let merged = by_kind(alike.iter().enumerate());
        assert_eq!(merged[0].line_of(9, name), "2 of 9 contacts: film 9 nm");
        let alone = by_kind([(2, &films[0])]);
        assert_eq!(alone[0].line_of(9, name), "rib: film 9 nm");
    }

    /// A kind about different keys is one warning only where the texts are equal.
    #[test]
    fn own_words_are_kept() {
        let warnings = ["a", "b", "a"].map(|text| Warning::new(WarningKind::NoEffect, text));
        let lines: Vec<String> = by_kind(warnings.iter().enumerate().map(|(i, w)| (2 * i, w)))
            .iter()
            .map(|m| m.line(9))
            .collect();
        assert_eq!(lines, ["points 1, 5: a", "point 3: b"]);
    }

    /// Silenced warnings are counted, and warnings about unusable figures are shown.
    #[test]
    fn silenced_warnings_are_counted() {
        let friction = Warning::new(WarningKind::Friction, "0.3");
        let mut all = [thin(9.0), thin(8.0), friction];
        silence(&mut all, &[WarningKind::ThinFilm, WarningKind::Friction]);
        assert_eq!(texts(&all), ["0.3"]);
        assert_eq!(codes(&all), [WarningKind::Friction]);
        assert_eq!(silenced(&all), BTreeMap::from([("thin-film", 2)]));
        silence(&mut all, &[]);
        assert_eq!(texts(&all).len(), 3);
    }

    #[test]
    fn long_lists_are_cut() {
        let points: Vec<usize> = (0..20).map(|i| 3 * i).collect();
        assert_eq!(ranges(&points), "1, 4, 7, 10, 13, 16 and 14 more");
        assert_eq!(ranges(&[0, 1, 2, 5, 6]), "1 to 3, 6, 7");
    }
}
