//! Bearing designations.

use super::clearance::ClearanceClass;
use super::series::Series;

/// A designation taken apart.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Designation {
    /// Its series.
    pub series: Series,
    /// Bore code: 00 to 03 are 10, 12, 15 and 17 mm, from 04 on 5 mm times the code.
    pub code: u8,
    /// Clearance class; the normal one where none is named.
    pub clearance: ClearanceClass,
    /// Suffixes that change nothing of what is calculated, such as those of seals, cages and tolerances.
    pub ignored: Vec<String>,
    /// Meaning of the suffixes that would change the result and are neglected.
    pub left_out: Vec<&'static str>,
}

impl Designation {
    /// Without suffixes.
    pub(super) fn plain(series: Series, code: u8) -> Designation {
        Designation {
            series,
            code,
            clearance: ClearanceClass::Normal,
            ignored: Vec::new(),
            left_out: Vec::new(),
        }
    }

    /// As catalogues write it, without further suffixes.
    pub fn name(&self) -> String {
        let [before, after] = self.series.affixes();
        format!("{before}{:02}{after}", self.code)
    }
}

/// Why a designation names no bearing of the catalogue.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("no bearing `{given}` in the catalogue{}", .kind.map_or(String::new(), |kind| format!(": {kind} are not covered")))]
pub struct DesignationError {
    /// The text given.
    pub given: String,
    /// Kind of bearing of the designation, where it is not covered.
    pub kind: Option<&'static str>,
    /// The nearest designations; none of kinds that are not covered.
    pub nearest: Vec<String>,
}

/// Kinds of bearings that are not covered, by the beginning and the number of digits of their designations (ISO 15 and makers' catalogues).
const NOT_COVERED: [(&str, usize, &str); 20] = [
    ("12", 4, "self-aligning ball bearings"),
    ("13", 4, "self-aligning ball bearings"),
    ("22", 4, "self-aligning ball bearings"),
    ("23", 4, "self-aligning ball bearings"),
    ("213", 5, "spherical roller bearings"),
    ("22", 5, "spherical roller bearings"),
    ("23", 5, "spherical roller bearings"),
    ("24", 5, "spherical roller bearings"),
    ("29", 5, "spherical roller thrust bearings"),
    ("32", 4, "double-row angular contact ball bearings"),
    ("33", 4, "double-row angular contact ball bearings"),
    ("42", 4, "double-row deep groove ball bearings"),
    ("43", 4, "double-row deep groove ball bearings"),
    ("51", 5, "thrust ball bearings"),
    ("52", 5, "thrust ball bearings"),
    ("53", 5, "thrust ball bearings"),
    ("81", 5, "cylindrical roller thrust bearings"),
    ("HK", 4, "needle roller bearings"),
    ("NA", 4, "needle roller bearings"),
    ("QJ", 3, "four-point contact ball bearings"),
];

/// The kind of a designation that is none of the catalogue.
fn not_covered(wanted: &str) -> Option<&'static str> {
    let digits = wanted
        .trim_start_matches(|c: char| c.is_ascii_alphabetic())
        .chars()
        .take_while(char::is_ascii_digit)
        .count();
    let found =
        (NOT_COVERED.iter()).find(|(start, n, _)| wanted.starts_with(start) && digits == *n);
    found.map(|(_, _, kind)| *kind)
}

/// Designations with the same first sign and bore code, then with the longest common beginning, then the nearest numbers.
pub(super) fn unknown(given: &str) -> DesignationError {
    let wanted: String = compact(without_maker(&given.trim().to_ascii_uppercase()));
    let number = |text: &str| {
        let digits: String = text.chars().filter(char::is_ascii_digit).take(5).collect();
        digits.parse::<i64>().unwrap_or(0)
    };
    // Four digits, such as 6806: the last two are the bore code.
    let is_long = wanted.len() == 4 && wanted.chars().all(|c| c.is_ascii_digit());
    let bore = is_long.then(|| &wanted[2..]);
    let mut known: Vec<String> = all().collect();
    known.sort_by_key(|name| {
        let common = (name.chars().zip(wanted.chars()))
            .take_while(|(a, b)| a == b)
            .count();
        let is_of_bore =
            bore.is_some_and(|bore| name.trim_end_matches('B').ends_with(bore)) && common > 0;
        (
            std::cmp::Reverse(is_of_bore),
            std::cmp::Reverse(common),
            (number(name) - number(&wanted)).abs(),
        )
    });
    let kind = not_covered(&wanted);
    known.truncate(if kind.is_some() { 0 } else { 4 });
    DesignationError {
        given: given.trim().to_string(),
        kind,
        nearest: known,
    }
}

/// In capitals, without blanks and marks.
fn compact(text: &str) -> String {
    text.chars()
        .filter(char::is_ascii_alphanumeric)
        .map(|c| c.to_ascii_uppercase())
        .collect()
}

/// Makers, whose names people write before a designation.
const MAKERS: [&str; 16] = [
    "SCHAEFFLER",
    "TIMKEN",
    "NACHI",
    "JTEKT",
    "KOYO",
    "SKF",
    "FAG",
    "INA",
    "NSK",
    "NTN",
    "SNR",
    "NKE",
    "ZVL",
    "ZKL",
    "NMB",
    "RHP",
];

/// A designation without the name of its maker.
fn without_maker(upper: &str) -> &str {
    let rests = MAKERS.iter().filter_map(|maker| upper.strip_prefix(maker));
    // NSK 6206, but no letters that go on.
    let mut rests = rests.filter(|rest| !rest.starts_with(|c: char| c.is_ascii_alphabetic()));
    rests.next().map_or(upper, str::trim_start)
}

/// Parses a designation: series, bore code, suffixes.
pub(super) fn parse(given: &str) -> Result<Designation, DesignationError> {
    let upper = given.trim().to_ascii_uppercase();
    let upper = without_maker(&upper);
    // N, NJ and NUP have the raceways of NU, and ribs elsewhere, which do not count here.
    let (upper, design) = as_nu(upper);
    let fail = || unknown(given);
    // Blanks within the number, as in `NU 206`, do not count.
    let head_length = |prefix: &str| {
        let wanted = prefix.len() + 2;
        let mut seen = 0;
        let end = upper.char_indices().find(|(_, c)| {
            seen += usize::from(c.is_ascii_alphanumeric());
            seen == wanted
        });
        end.map(|(at, c)| at + c.len_utf8())
    };
    // The longest prefix first: `NU10` before `NU2` does no harm, `302` before `30`.
    let mut series: Vec<Series> = Series::ALL.to_vec();
    series.sort_by_key(|s| std::cmp::Reverse(s.affixes()[0].len()));
    let found = series.into_iter().find_map(|series| {
        let [prefix, affix] = series.affixes();
        let end = head_length(prefix)?;
        let is_clean = |c: char| c.is_ascii_alphanumeric() || c == ' ' || c == '-';
        if !upper[..end].chars().all(is_clean) {
            return None;
        }
        let head = compact(&upper[..end]);
        let code = head.strip_prefix(prefix)?.parse::<u8>().ok()?;
        let rest = &upper[end..];
        let tokens: Vec<String> = rest
            .split(|c: char| !c.is_ascii_alphanumeric())
            .filter(|token| !token.is_empty())
            .map(str::to_string)
            .collect();
        // A further digit would make it another bearing.
        if rest.starts_with(|c: char| c.is_ascii_digit()) && !is_seal(&tokens[0]) {
            return None;
        }
        Some((series, affix, code, tokens))
    });
    let (series, affix, code, mut tokens) = found.ok_or_else(fail)?;
    let mut clearance = ClearanceClass::Normal;
    let (mut ignored, mut left_out) = (Vec::new(), Vec::new());
    ignored.extend(design.map(str::to_string));
    // 72 and 73 have other angles without the B, and E of cylindrical roller bearings is all that is made today.
    if affix == "B" {
        match tokens.first_mut() {
            Some(first) if first.starts_with('B') => *first = first[1..].to_string(),
            _ => return Err(fail()),
        }
    }
    for token in tokens {
        let (class, parts) = ClearanceClass::within(&token);
        clearance = class.unwrap_or(clearance);
        for part in parts.into_iter().filter(|part| !part.is_empty()) {
            // B, C and D of tapered roller bearings are those of other contact angles, or of pairs.
            if series.is_tapered() && part.starts_with(['B', 'C', 'D']) {
                return Err(fail());
            }
            let is_design = (affix == "E" && part == "E") || affix == "X";
            let part = match is_design {
                true => part.strip_prefix(affix).unwrap_or(part),
                false => part,
            };
            match neglected_by(part) {
                Some(what) => left_out.push(what),
                None if part.is_empty() => {}
                None => ignored.push(part.to_string()),
            }
        }
    }
    Ok(Designation {
        series,
        code,
        clearance,
        ignored,
        left_out,
    })
}

/// Cylindrical roller bearings N, NJ and NUP as NU, and what they are.
fn as_nu(upper: &str) -> (String, Option<&'static str>) {
    for design in ["NUP", "NJ", "N"] {
        let rest = upper.strip_prefix(design).map(str::trim_start);
        if let Some(rest) = rest.filter(|rest| rest.starts_with(|c: char| c.is_ascii_digit())) {
            return (format!("NU{rest}"), Some(design));
        }
    }
    (upper.to_owned(), None)
}

/// Meaning of a suffix whose effect is neglected although it would change the result.
fn neglected_by(suffix: &str) -> Option<&'static str> {
    let is_of = |names: &[&str]| names.contains(&suffix);
    let is_hybrid = suffix.starts_with("HC") && suffix[2..].chars().all(|c| c.is_ascii_digit());
    match suffix {
        _ if is_hybrid => Some("HC, ceramic balls: give their material as body_2"),
        _ if is_of(&["DB", "DF", "DT", "TBT", "TFT", "QBC", "QFC"]) => {
            Some("DB, DF or DT, a set: one bearing of it is calculated, under its own loads")
        }
        _ if is_of(&["C1", "C5"]) => {
            Some("C1 or C5, a clearance that is not in the tables: give it")
        }
        _ => None,
    }
}

/// Suffixes of seals and shields that begin with a digit.
fn is_seal(token: &str) -> bool {
    token.starts_with("2R") || token.starts_with("2Z")
}

/// Designations of all bearings of the catalogue, by series.
pub fn all() -> impl Iterator<Item = String> {
    Series::ALL.into_iter().flat_map(|series| {
        series
            .codes()
            .map(move |code| Designation::plain(series, code).name())
    })
}
