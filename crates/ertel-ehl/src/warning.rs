//! What a user should know about a case or its results, by kind, so that many points say it once.

use std::fmt;
use std::ops::Deref;

use ertel_rheology::provenance::RangeWarning;
use serde::{Deserialize, Serialize};

/// What a warning is about. Warnings of one kind differ only in their figures, except for [`WarningKind::Other`] and
/// [`WarningKind::UnusualInput`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum WarningKind {
    /// Something that has no kind of its own.
    Other,
    /// How long what changes at the inlet edge takes to the contact.
    OnItsWay,
    /// A value of the case far from those of such contacts.
    UnusualInput,
    /// Surfaces that move in opposite directions.
    OppositeMotion,
    /// A contact too wide for the parabola of Hertz theory.
    WideContact,
    /// A contact area that reaches beyond the bodies.
    WideArea,
    /// The same where friction hardly feels what lies so far away.
    WideAreaUnfelt,
    /// Pressures beyond the lubricant's data.
    PressureRange,
    /// A temperature that was changed, of which the laws of the lubricant know nothing.
    TemperatureIgnored,
    /// Pressures beyond those that are stated for the lubricant's law in general: hardly any contact stays below.
    LawRange,
    /// Pressures beyond what the bodies bear.
    Strength,
    /// Temperatures beyond the lubricant's data, at the inlet.
    TemperatureRange,
    /// The same in the film where it is hottest.
    HottestFilm,
    /// The same in the film where it is coldest.
    ColdestFilm,
    /// A film that is colder before the contact than all that flows in.
    ColdInlet,
    /// Heat that is lost or gained on the way.
    HeatBalance,
    /// A film too thin for a continuum.
    ThinFilm,
    /// A film that is not small beside the radius.
    ThickFilm,
    /// A film that roughness pierces.
    Roughness,
    /// Asperities that carry so much that the film of smooth surfaces is not theirs.
    AsperityLoad,
    /// Asperities that cannot carry the load however thin the film.
    AsperityLimit,
    /// Numbers of asperities unlike those of measured surfaces.
    AsperityData,
    /// Friction that no lubricant transmits.
    Friction,
    /// A film that a law thins whose constants are estimated.
    EstimatedThinning,
    /// A shear stress of rolling beyond what lubricants bear, where film and pressure hardly feel it.
    RollingStress,
    /// Heat that an isothermal contact leaves out.
    HeatLeftOut,
    /// Teeth that mesh badly.
    Gears,
    /// An error bar of the central film beyond the target.
    CentralFilmError,
    /// An error bar of the minimum film beyond the target.
    MinimumFilmError,
    /// Films without an error bar.
    NoErrorBar,
    /// A largest pressure that the mesh does not resolve.
    Spike,
    /// Another method than finite elements, which did not converge.
    Method,
    /// Newton's method or elements that end short of what was asked for.
    Convergence,
    /// An outlet edge before the end of the film.
    OutletEdge,
    /// An inlet edge that starves the contact.
    InletEdge,
    /// Inertia of the lubricant.
    Inertia,
}

impl WarningKind {
    /// Whether it is worth knowing, but no reason to doubt a result: told quietly.
    pub fn is_note(self) -> bool {
        matches!(
            self,
            WarningKind::LawRange
                | WarningKind::RollingStress
                | WarningKind::WideAreaUnfelt
                | WarningKind::Method
                | WarningKind::OnItsWay
        )
    }
}

/// What a user should know, in a sentence or two.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Warning {
    /// What it is about.
    pub kind: WarningKind,
    /// The sentence.
    pub text: String,
    /// How far a bound is exceeded, to tell the worst of one kind.
    pub excess: f64,
}

impl Warning {
    /// A warning whose kind has no worst.
    pub fn new(kind: WarningKind, text: impl Into<String>) -> Warning {
        Warning {
            kind,
            text: text.into(),
            excess: 0.0,
        }
    }

    /// A warning about a bound, and how far it is exceeded.
    pub fn beyond(kind: WarningKind, excess: f64, text: impl Into<String>) -> Warning {
        Warning {
            excess,
            ..Warning::new(kind, text)
        }
    }

    /// Whether one line can say both.
    fn is_like(&self, other: &Warning) -> bool {
        // Warnings about different keys.
        let has_own_words = matches!(self.kind, WarningKind::Other | WarningKind::UnusualInput);
        self.kind == other.kind && (!has_own_words || self.text == other.text)
    }
}

impl From<String> for Warning {
    fn from(text: String) -> Warning {
        Warning::new(WarningKind::Other, text)
    }
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
    let told = warnings.iter().filter(|w| !w.kind.is_note());
    told.map(|w| &**w).collect()
}

/// Those of notes.
pub fn notes(warnings: &[Warning]) -> Vec<&str> {
    let notes = warnings.iter().filter(|w| w.kind.is_note());
    notes.map(|w| &**w).collect()
}

/// Warnings of one kind at several points.
#[derive(Clone, Debug, PartialEq)]
pub struct Merged {
    /// The worst of them.
    pub worst: Warning,
    /// Whose it is.
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
    /// In one line, points counted from 1: `points 2 to 5: the film …`; `of` is how many points there are.
    pub fn line(&self, of: usize) -> String {
        let place = match self.points[..] {
            [one] => format!("point {}", one + 1),
            _ if self.points.len() == of => all(of, "points"),
            _ => format!("points {}", ranges(&self.points)),
        };
        self.with_worst(&place, &format!("point {}", self.worst_point + 1))
    }

    /// The same of contacts by their names: `ball 0, inner ring and 3 more contacts: the film …`.
    pub fn line_of<'a>(&self, of: usize, name: impl Fn(usize) -> &'a str) -> String {
        let worst = name(self.worst_point);
        let text = &self.worst.text;
        match self.points.len() {
            1 => format!("{worst}: {text}"),
            n if n == of => self.with_worst(&all(of, "contacts"), worst),
            n => {
                let others = match n - 1 {
                    1 => "1 more contact".to_owned(),
                    more => format!("{more} more contacts"),
                };
                let alike = if self.alike {
                    ""
                } else {
                    ", shown for the first"
                };
                format!("{worst} and {others}{alike}: {text}")
            }
        }
    }

    fn with_worst(&self, place: &str, worst: &str) -> String {
        let text = &self.worst.text;
        match self.alike || self.points.len() == 1 {
            true => format!("{place}: {text}"),
            false => format!("{place}, shown for {worst}: {text}"),
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
        let other = Warning::from("no title".to_owned());
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
                "points 1 to 3, shown for point 2: film 7 nm",
                "points 2, 5: no title"
            ]
        );
        let few: Vec<String> = by_kind(all).iter().map(|m| m.line(3)).collect();
        assert!(
            few[0].starts_with("all 3 points, shown for point 2"),
            "{few:?}"
        );
        let two = [(0, &films[0]), (1, &films[1])];
        assert_eq!(
            by_kind(two)[0].line(2),
            "both points, shown for point 2: film 7 nm"
        );
    }

    /// Contacts have names, that of the worst first.
    #[test]
    fn contacts_are_told_by_name() {
        let films = [9.0, 7.0, 8.0].map(thin);
        let merged = by_kind(films.iter().enumerate());
        let name = |i: usize| ["inner ring", "outer ring", "rib"][i];
        assert_eq!(
            merged[0].line_of(9, name),
            "outer ring and 2 more contacts, shown for the first: film 7 nm"
        );
        assert_eq!(
            merged[0].line_of(3, name),
            "all 3 contacts, shown for outer ring: film 7 nm"
        );
        let alike = [thin(9.0), thin(9.0)];
        let merged = by_kind(alike.iter().enumerate());
        assert_eq!(
            merged[0].line_of(9, name),
            "inner ring and 1 more contact: film 9 nm"
        );
        let alone = by_kind([(2, &films[0])]);
        assert_eq!(alone[0].line_of(9, name), "rib: film 9 nm");
    }

    /// What has no kind is told apart by its words.
    #[test]
    fn other_warnings_keep_their_words() {
        let warnings = ["a", "b", "a"].map(|text| Warning::from(text.to_owned()));
        let lines: Vec<String> = by_kind(warnings.iter().enumerate().map(|(i, w)| (2 * i, w)))
            .iter()
            .map(|m| m.line(9))
            .collect();
        assert_eq!(lines, ["points 1, 5: a", "point 3: b"]);
    }

    #[test]
    fn long_lists_are_cut() {
        let points: Vec<usize> = (0..20).map(|i| 3 * i).collect();
        assert_eq!(ranges(&points), "1, 4, 7, 10, 13, 16 and 14 more");
        assert_eq!(ranges(&[0, 1, 2, 5, 6]), "1 to 3, 6, 7");
    }
}
