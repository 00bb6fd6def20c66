//! What a designation says.

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
}

impl Designation {
    /// Without suffixes.
    pub(super) fn plain(series: Series, code: u8) -> Designation {
        Designation {
            series,
            code,
            clearance: ClearanceClass::Normal,
            ignored: Vec::new(),
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
#[error("no bearing `{given}` in the catalogue; the nearest ones are {}", .nearest.join(", "))]
pub struct DesignationError {
    /// What was given.
    pub given: String,
    /// The nearest designations.
    pub nearest: Vec<String>,
}

/// Designations with the longest common beginning, then the nearest numbers.
pub(super) fn unknown(given: &str) -> DesignationError {
    let wanted: String = compact(given);
    let number = |text: &str| {
        let digits: String = text.chars().filter(char::is_ascii_digit).take(5).collect();
        digits.parse::<i64>().unwrap_or(0)
    };
    let mut known: Vec<String> = super::all().collect();
    known.sort_by_key(|name| {
        let common = (name.chars().zip(wanted.chars()))
            .take_while(|(a, b)| a == b)
            .count();
        (
            std::cmp::Reverse(common),
            (number(name) - number(&wanted)).abs(),
        )
    });
    known.truncate(4);
    DesignationError {
        given: given.trim().to_string(),
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

/// Takes a designation apart: series, bore code, suffixes.
pub(super) fn parse(given: &str) -> Result<Designation, DesignationError> {
    let upper = given.trim().to_ascii_uppercase();
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
    let mut ignored = Vec::new();
    // 72 and 73 have other angles without the B, and E of cylindrical roller bearings is all that is made today.
    if affix == "B" {
        match tokens.first_mut() {
            Some(first) if first.starts_with('B') => *first = first[1..].to_string(),
            _ => return Err(fail()),
        }
    }
    for token in tokens {
        let (class, rest) = ClearanceClass::at_the_end(&token);
        if let Some(class) = class {
            clearance = class;
        }
        // B, C and D of tapered roller bearings are those of other contact angles, or of pairs.
        if series.is_tapered() && rest.starts_with(['B', 'C', 'D']) {
            return Err(fail());
        }
        let is_design = (affix == "E" && rest == "E") || affix == "X";
        let rest = match is_design {
            true => rest.strip_prefix(affix).unwrap_or(rest),
            false => rest,
        };
        if !rest.is_empty() {
            ignored.push(rest.to_string());
        }
    }
    Ok(Designation {
        series,
        code,
        clearance,
        ignored,
    })
}

/// Suffixes of seals and shields that begin with a digit.
fn is_seal(token: &str) -> bool {
    token.starts_with("2R") || token.starts_with("2Z")
}
