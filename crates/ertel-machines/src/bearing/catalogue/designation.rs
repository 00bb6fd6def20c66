//! What a designation says.

use super::Boundary;
use super::clearance::ClearanceClass;
use super::dimensions as table;
use crate::bearing::friction::{PalmgrenSeries, SkfSeries};

/// Series of the catalogue.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Series {
    /// Deep groove ball bearings 60.
    DeepGroove60,
    /// 62.
    DeepGroove62,
    /// 63.
    DeepGroove63,
    /// Angular contact ball bearings 72..B.
    Angular72B,
    /// 73..B.
    Angular73B,
    /// Cylindrical roller bearings NU10.
    CylindricalNu10,
    /// NU2..E.
    CylindricalNu2,
    /// NU3..E.
    CylindricalNu3,
    /// Tapered roller bearings 302.
    Tapered302,
    /// 303.
    Tapered303,
}

impl Series {
    /// All of them.
    pub const ALL: [Series; 10] = [
        Series::DeepGroove60,
        Series::DeepGroove62,
        Series::DeepGroove63,
        Series::Angular72B,
        Series::Angular73B,
        Series::CylindricalNu10,
        Series::CylindricalNu2,
        Series::CylindricalNu3,
        Series::Tapered302,
        Series::Tapered303,
    ];

    /// What stands before and after the bore code.
    fn affixes(self) -> [&'static str; 2] {
        match self {
            Series::DeepGroove60 => ["60", ""],
            Series::DeepGroove62 => ["62", ""],
            Series::DeepGroove63 => ["63", ""],
            Series::Angular72B => ["72", "B"],
            Series::Angular73B => ["73", "B"],
            Series::CylindricalNu10 => ["NU10", ""],
            Series::CylindricalNu2 => ["NU2", "E"],
            Series::CylindricalNu3 => ["NU3", "E"],
            Series::Tapered302 => ["302", ""],
            Series::Tapered303 => ["303", ""],
        }
    }

    /// Rows of bore code, d, D and B (mm), and further dimensions.
    fn rows(self) -> Vec<Vec<f64>> {
        fn all<const N: usize>(rows: &[[f64; N]]) -> Vec<Vec<f64>> {
            rows.iter().map(|row| row.to_vec()).collect()
        }
        match self {
            Series::DeepGroove60 => all(&table::DEEP_GROOVE_60),
            Series::DeepGroove62 => all(&table::DEEP_GROOVE_62),
            Series::DeepGroove63 => all(&table::DEEP_GROOVE_63),
            Series::Angular72B => all(&table::ANGULAR_72B),
            Series::Angular73B => all(&table::ANGULAR_73B),
            Series::CylindricalNu10 => all(&table::CYLINDRICAL_NU10),
            Series::CylindricalNu2 => all(&table::CYLINDRICAL_NU2),
            Series::CylindricalNu3 => all(&table::CYLINDRICAL_NU3),
            Series::Tapered302 => all(&table::TAPERED_302),
            Series::Tapered303 => all(&table::TAPERED_303),
        }
    }

    /// Nominal contact angle of ratings, rad; `None` of tapered roller bearings, whose angles differ.
    pub fn nominal_angle(self) -> Option<f64> {
        match self {
            Series::DeepGroove60
            | Series::DeepGroove62
            | Series::DeepGroove63
            | Series::CylindricalNu10
            | Series::CylindricalNu2
            | Series::CylindricalNu3 => Some(0.0),
            Series::Angular72B | Series::Angular73B => Some(40_f64.to_radians()),
            Series::Tapered302 | Series::Tapered303 => None,
        }
    }

    /// Its series in SKF's model of friction, which is here for deep groove ball bearings.
    pub fn skf(self) -> Option<SkfSeries> {
        match self {
            Series::DeepGroove60 => Some(SkfSeries::S60),
            Series::DeepGroove62 => Some(SkfSeries::S62),
            Series::DeepGroove63 => Some(SkfSeries::S63),
            _ => None,
        }
    }

    /// Its series in Palmgren's model of friction.
    pub fn palmgren(self) -> PalmgrenSeries {
        match self {
            Series::DeepGroove60 => PalmgrenSeries::DeepGroove60,
            Series::DeepGroove62 => PalmgrenSeries::DeepGroove62,
            Series::DeepGroove63 => PalmgrenSeries::DeepGroove63,
            Series::Angular72B => PalmgrenSeries::Angular72B,
            Series::Angular73B => PalmgrenSeries::Angular73B,
            Series::CylindricalNu10 => PalmgrenSeries::Cylindrical10,
            Series::CylindricalNu2 => PalmgrenSeries::Cylindrical2,
            Series::CylindricalNu3 => PalmgrenSeries::Cylindrical3,
            Series::Tapered302 | Series::Tapered303 => PalmgrenSeries::Tapered302,
        }
    }

    /// X_0 and Y_0 of the static equivalent load; `None` of tapered roller bearings, whose factors differ. Schaeffler, HR 1, 2006.
    pub fn static_factors(self) -> Option<[f64; 2]> {
        match self {
            Series::DeepGroove60 | Series::DeepGroove62 | Series::DeepGroove63 => Some([0.6, 0.5]),
            Series::Angular72B | Series::Angular73B => Some([0.5, 0.26]),
            Series::CylindricalNu10 | Series::CylindricalNu2 | Series::CylindricalNu3 => {
                Some([1.0, 0.0])
            }
            Series::Tapered302 | Series::Tapered303 => None,
        }
    }

    /// Bore codes of the catalogue.
    pub fn codes(self) -> impl Iterator<Item = u8> {
        self.rows().into_iter().map(|row| row[0] as u8)
    }

    /// Dimensions of a bore code.
    pub(super) fn boundary(self, code: u8) -> Option<Boundary> {
        let row = (self.rows().into_iter()).find(|row| row[0] == f64::from(code))?;
        let further = (row.len() > 4).then(|| [row[4] * 1e-3, row[5] * 1e-3]);
        let tapered = matches!(self, Series::Tapered302 | Series::Tapered303);
        Some(Boundary {
            bore: row[1] * 1e-3,
            outside: row[2] * 1e-3,
            width: row[3] * 1e-3,
            raceways: further.filter(|_| !tapered),
            taper_widths: further.filter(|_| tapered),
        })
    }
}

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
        let is_design = affix == "E" && rest == "E";
        if !rest.is_empty() && !is_design {
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
