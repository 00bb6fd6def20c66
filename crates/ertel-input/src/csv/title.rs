//! Titles of columns: a name and a unit, in the ways in which people write them.

use std::borrow::Cow;

use super::names::{self, Match};
use super::number::is_number;
use ertel_quantity::{Dimension, Unit};

/// Zero of a pressure scale.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Zero {
    /// The ambient pressure, as `psig` and `bar(g)` say.
    Ambient,
    /// Vacuum, as `psia` and `bar(a)` say.
    Vacuum,
}

/// A unit that a title names.
#[derive(Clone, Debug)]
pub(super) struct NamedUnit {
    pub unit: Unit,
    /// As a quantity in a case has it; empty for a plain number.
    pub text: String,
    pub zero: Option<Zero>,
}

/// Bytes of a title from which no unit is looked for in it: the ways of reading it grow with the square of its length.
const LONGEST_TITLE: usize = 300;

/// One way of reading a title.
#[derive(Clone, Debug)]
pub(super) struct Reading<'a> {
    /// The name, as written.
    pub name: Cow<'a, str>,
    /// The unit, as written; empty where the title has none.
    pub unit: Cow<'a, str>,
    /// Whether the name ends there for certain: a bracket follows, ` / `, ` in `, or nothing.
    pub is_exact: bool,
}

/// The ways of reading a title, those that are certain first: `Pressure [MPa]`, `Pressure (MPa)`, `Pressure / MPa`, `Pressure in
/// MPa`, `Pressure`, then `Pressure, MPa`, `Pressure: MPa`, `pressure_MPa`, `Pressure MPa`.
pub(super) fn readings(title: &str) -> Vec<Reading<'_>> {
    let title = title.trim();
    let mut found: Vec<Reading<'_>> = Vec::new();
    if is_number(title) {
        return found;
    }
    let mut add = |name: Cow<'_, str>, unit: &str, is_exact: bool| {
        let name: Cow<'_, str> = Cow::Owned(name.trim().to_owned());
        if !name.is_empty() {
            found.push(Reading {
                name,
                unit: Cow::Owned(unit.trim().to_owned()),
                is_exact,
            });
        }
    };
    if title.len() > LONGEST_TITLE {
        add(Cow::Borrowed(title), "", true);
        return found;
    }
    for (open, close) in brackets(title) {
        let inner = &title[open + 1..close];
        let after = title.get(close + 1..).unwrap_or_default();
        add(
            Cow::Owned(format!("{} {after}", &title[..open])),
            inner,
            true,
        );
    }
    for (i, _) in title.match_indices('/') {
        let unit = title[i + 1..].trim();
        let is_exact = title[..i].ends_with(' ');
        add(Cow::Borrowed(&title[..i]), unwrapped(unit), is_exact);
    }
    for (i, _) in title.match_indices(" in ") {
        add(Cow::Borrowed(&title[..i]), unwrapped(&title[i + 4..]), true);
    }
    add(Cow::Borrowed(title), "", true);
    for (i, c) in title.match_indices([',', ':', ';']) {
        add(
            Cow::Borrowed(&title[..i]),
            unwrapped(&title[i + c.len()..]),
            false,
        );
    }
    for (i, c) in title.match_indices(['_', ' ', '-']) {
        let unit = title[i + c.len()..].replace("_per_", "/").replace('_', " ");
        add(Cow::Borrowed(&title[..i]), &unit, false);
    }
    found
}

/// Without brackets around all of it.
fn unwrapped(unit: &str) -> &str {
    let unit = unit.trim();
    match brackets(unit)[..] {
        [.., (0, close)] if close + 1 == unit.len() => &unit[1..close],
        _ => unit,
    }
}

/// Opening and closing bracket of the outermost pairs, the last pair first; one that is not closed ends with the title.
fn brackets(title: &str) -> Vec<(usize, usize)> {
    let mut pairs = Vec::new();
    let (mut depth, mut open) = (0usize, 0);
    for (i, c) in title.char_indices() {
        match c {
            '[' | '(' | '{' => {
                if depth == 0 {
                    open = i;
                }
                depth += 1;
            }
            ']' | ')' | '}' if depth > 0 => {
                depth -= 1;
                if depth == 0 {
                    pairs.push((open, i));
                }
            }
            _ => {}
        }
    }
    if depth > 0 {
        pairs.push((open, title.len()));
    }
    pairs.reverse();
    pairs
}

/// Spellings of units in titles that a quantity does not have, in small letters and separated by commas, and what is meant.
const SPELLINGS: [(&str, &str); 10] = [
    ("-, –, —, none, dimensionless, unitless, ohne", ""),
    (
        "° c, deg c, deg. c, grad c, degrees c, celsius, °celsius, grad celsius, oc, ºc, degc, °c, ˚c",
        "degC",
    ),
    (
        "° f, deg f, deg. f, degrees f, fahrenheit, ºf, degf, °f",
        "degF",
    ),
    ("kelvin", "K"),
    ("mpas, mpa-s, m pas, mpa sec, mpa.sec", "mPa.s"),
    ("cps, cp, centipoise", "cP"),
    ("cst, centistokes", "cSt"),
    ("micron, microns, µ, μ", "um"),
    ("pct, percent, prozent", "%"),
    ("newton, newtons", "N"),
];

/// The unit that a text of a title means.
pub(super) fn unit_of(text: &str) -> Option<NamedUnit> {
    let text = text.trim();
    let of = |text: &str, zero| {
        let unit = Unit::parse(text).ok()?;
        let text = text.to_owned();
        Some(NamedUnit { unit, text, zero })
    };
    let small = text.to_lowercase();
    // Pas is no picoampere second, and MPas no mPas.
    let spelling = match text {
        "Pas" | "Pa-s" => Some("Pa.s"),
        "Ns/m2" | "Ns/m²" | "Ns/m^2" => Some("N.s/m^2"),
        "C" => Some("degC"),
        "F" => Some("degF"),
        "MPas" | "CP" | "PaS" => None,
        _ => SPELLINGS
            .iter()
            .find(|(spellings, _)| spellings.split(", ").any(|own| own == small))
            .map(|(_, unit)| *unit),
    };
    if let Some(unit) = spelling {
        return of(unit, None);
    }
    if let Some(unit) = of(text, None) {
        return Some(unit);
    }
    if let Some(unit) = text
        .strip_suffix("/sec")
        .or_else(|| text.strip_suffix("/sek"))
    {
        return of(&format!("{unit}/s"), None);
    }
    let ends: [(&[&str], Zero); 2] = [
        (&["(g)", "(gauge)", "gauge", "g", "(ü)", "ü"], Zero::Ambient),
        (
            &["(a)", "(abs)", "(abs.)", "abs.", "abs", "absolute", "a"],
            Zero::Vacuum,
        ),
    ];
    ends.iter().find_map(|(ends, zero)| {
        ends.iter().find_map(|end| {
            let unit = text
                .strip_suffix(end)?
                .trim_end_matches([' ', '_', '-', ',']);
            let found = of(unit, Some(*zero))?;
            found
                .unit
                .dimension()
                .same_exponents(Dimension::PRESSURE)
                .then_some(found)
        })
    })
}

/// A title read as one of a quantity.
#[derive(Clone, Debug)]
pub(super) struct Title {
    /// The text of the unit, as written.
    pub given: String,
    /// The unit; `None` of one that is not known.
    pub unit: Option<NamedUnit>,
    /// Whether the name ends before the unit for certain.
    pub is_exact: bool,
    /// How sure the name is.
    pub name: Match,
}

impl Title {
    /// The ways in which a title is one of the quantity that the program calls `own`.
    pub(super) fn all(title: &str, own: &str) -> Vec<Self> {
        let of = |reading: Reading<'_>| {
            // The name first: most columns are others, and units that are not known take long to look up.
            let folded = names::fold(&reading.name);
            let plain =
                || names::matches(&folded, "pressure").filter(|_| own == "absolute pressure");
            names::matches(&folded, own).or_else(plain)?;
            let unit = unit_of(&reading.unit);
            let zero = unit.as_ref().and_then(|unit| unit.zero);
            let name = match (own, zero) {
                ("pressure", Some(Zero::Vacuum)) => None,
                ("absolute pressure", Some(Zero::Vacuum)) => {
                    names::matches(&folded, own).or_else(|| names::matches(&folded, "pressure"))
                }
                ("absolute pressure", Some(Zero::Ambient)) => None,
                _ => names::matches(&folded, own),
            }?;
            Some(Self {
                given: reading.unit.into_owned(),
                unit,
                is_exact: reading.is_exact,
                name,
            })
        };
        readings(title).into_iter().filter_map(of).collect()
    }

    /// The unit, if it measures that. `mm_s` is read as a product, or else as the quotient that it mostly means.
    pub(super) fn unit_of(&self, dimension: Dimension) -> Option<NamedUnit> {
        let fits = |unit: &NamedUnit| unit.unit.dimension().same_exponents(dimension);
        if let Some(unit) = self.unit.clone().filter(fits) {
            return Some(unit);
        }
        let (above, below) = self.given.split_once(' ').filter(|_| !self.is_exact)?;
        unit_of(&format!("{above}/{below}")).filter(fits)
    }

    /// Whether the title is a name alone.
    pub(super) fn is_bare(&self) -> bool {
        self.given.is_empty()
    }
}

/// The unit of a dimension that a title has, whatever its name.
pub(super) fn unit_with(title: &str, dimension: Dimension) -> Option<NamedUnit> {
    readings(title).iter().find_map(|reading| {
        let unit = unit_of(&reading.unit);
        unit.filter(|unit| unit.unit.dimension().same_exponents(dimension))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pressure(title: &str) -> Option<(f64, Option<Zero>)> {
        let titles = Title::all(title, "pressure");
        let unit = titles
            .iter()
            .find_map(|title| title.unit_of(Dimension::PRESSURE))?;
        Some((unit.unit.to_si(1.0), unit.zero))
    }

    #[test]
    fn one_title_in_many_spellings() {
        for title in [
            "pressure_MPa",
            "Pressure [MPa]",
            "PRESSURE (MPa)",
            "pressure / MPa",
            "p/MPa",
            "Pressure in MPa",
            "p, MPa",
            "p: MPa",
            "Pressure MPa",
            "Druck p [MPa]",
            "Druck / (MPa)",
            "Pressure {MPa}",
            "Pressure [MPa",
            "pressure[MPa]",
            "Pressure-MPa",
            "Druck in [MPa]",
            "pressure [N/mm²]",
            "Pressure (N/mm2)",
            "p / N mm^-2",
        ] {
            assert_eq!(pressure(title), Some((1e6, None)), "{title}");
        }
        for (title, value, zero) in [
            (
                "Pressure (psig)",
                6_894.757_293_168_361,
                Some(Zero::Ambient),
            ),
            ("p [bar(g)]", 1e5, Some(Zero::Ambient)),
            ("p [barg]", 1e5, Some(Zero::Ambient)),
            ("Druck [bar ü]", 1e5, Some(Zero::Ambient)),
            ("pressure [MPa] (gauge)", 1e6, None),
        ] {
            assert_eq!(pressure(title), Some((value, zero)), "{title}");
        }
        for title in [
            "pressure [m]",
            "pressure",
            "pressure ratio",
            "p [psia]",
            "ap_MPa",
            "Hertz pressure [MPa]",
            "",
            "[MPa]",
        ] {
            assert_eq!(pressure(title), None, "{title}");
        }
        let absolute = Title::all("p [psia]", "absolute pressure");
        assert!(absolute[0].unit_of(Dimension::PRESSURE).is_some());
    }

    #[test]
    fn long_titles_and_numbers_are_read_at_once() {
        let long = format!("pressure [MPa]{}", " - a".repeat(100));
        assert_eq!(readings(&long).len(), 1);
        assert!(readings("-1.5e-7").is_empty());
    }

    #[test]
    fn units_as_titles_have_them() {
        for (text, expected) in [
            ("-", ""),
            ("", ""),
            ("mPas", "mPa.s"),
            ("Pas", "Pa.s"),
            ("C", "degC"),
            ("°C", "degC"),
            ("Grad C", "degC"),
            ("cSt", "cSt"),
            ("mm²/s", "mm²/s"),
            ("Prozent", "%"),
            ("mm/sec", "mm/sec"),
            ("F", "degF"),
            ("mPa·s", "mPa·s"),
            ("mPa*s", "mPa*s"),
        ] {
            assert_eq!(
                unit_of(text).map(|unit| unit.text).as_deref(),
                Some(expected),
                "{text}"
            );
        }
        assert!(unit_of("furlong").is_none());
        assert!(unit_of("MPas").is_none_or(|unit| unit.text != "mPa.s"));
    }
}
