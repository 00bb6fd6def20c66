//! Numbers of cells: decimal points and commas, thousands, cells for missing values.

use std::borrow::Cow;

use super::super::excerpt;

/// The decimal mark given by the user.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Decimal {
    /// 1234.5
    Point,
    /// 1234,5
    Comma,
}

/// Words for a value that is not there, in small letters.
const MISSING: [&str; 22] = [
    "no data", "nodata", "no_data", "bad", "missing", "-", "--", "---", "–", "—", "n/a", "na",
    "n.a.", "nan", "#n/a", "#na", "#nv", "null", "none", "k.a.", "nv", "*",
];

/// Whether a cell marks a missing value.
#[must_use]
pub fn is_missing(cell: &str) -> bool {
    // No longer word is one of them.
    cell.is_empty() || (cell.len() < 8 && MISSING.contains(&cell.to_lowercase().as_str()))
}

/// Form of a number in a cell, apart from its sign.
enum Form {
    /// Without marks, or with one that can only be a decimal point; as Rust reads it.
    Plain(String),
    /// With a point, a comma or none as its decimal mark, and thousands apart by the other one.
    Clear {
        number: String,
        decimal: Option<char>,
        thousands: Option<char>,
    },
    /// `1,234` or `1.234`: decimals or thousands.
    Open(char),
}

/// Digits in groups of three behind a first one of one to three.
fn are_groups(whole: &str, mark: char) -> bool {
    let is_digits = |part: &str| part.bytes().all(|b| b.is_ascii_digit());
    let mut parts = whole.split(mark);
    let first = parts.next().unwrap_or_default();
    (1..=3).contains(&first.len())
        && is_digits(first)
        && !first.starts_with('0')
        && parts.all(|p| p.len() == 3 && is_digits(p))
}

/// Signs and blanks as Rust writes them: `−1 234` is -1234, `1'234` is 1234.
fn plain(cell: &str) -> Option<Cow<'_, str>> {
    let is_blank = |c: char| matches!(c, ' ' | '\u{a0}' | '\u{202f}' | '\u{2009}' | '\'' | '’');
    if !cell.contains(|c| is_blank(c) || c == '−') {
        return Some(Cow::Borrowed(cell));
    }
    let cell = cell.replace('−', "-");
    let Some(blank) = cell.chars().find(|c| is_blank(*c)) else {
        return Some(Cow::Owned(cell));
    };
    let unsigned = cell.trim_start_matches(['+', '-']);
    let end = unsigned.find(['.', ',']).unwrap_or(unsigned.len());
    are_groups(&unsigned[..end], blank).then(|| Cow::Owned(cell.replace(blank, "")))
}

fn form(cell: &str) -> Option<Form> {
    let cell = plain(cell)?;
    let unsigned = cell.trim_start_matches(['+', '-']);
    if cell.len() - unsigned.len() > 1
        || !unsigned.starts_with(|c: char| c.is_ascii_digit() || c == '.' || c == ',')
    {
        return None;
    }
    let end = unsigned.find(['e', 'E']).unwrap_or(unsigned.len());
    let (mantissa, exponent) = unsigned.split_at(end);
    let count = |mark: char| mantissa.matches(mark).count();
    let (points, commas) = (count('.'), count(','));
    let last = mantissa.rfind(['.', ',']);
    let Some(last) = last else {
        return cell
            .parse::<f64>()
            .ok()
            .map(|_| Form::Plain(cell.into_owned()));
    };
    let mark = if mantissa[last..].starts_with('.') {
        '.'
    } else {
        ','
    };
    let other = if mark == '.' { ',' } else { '.' };
    let (n_mark, n_other) = if mark == '.' {
        (points, commas)
    } else {
        (commas, points)
    };
    let sign = &cell[..cell.len() - unsigned.len()];
    let clear = |whole: String, decimal, thousands| {
        let number = format!("{sign}{whole}{exponent}");
        number.parse::<f64>().ok()?;
        Some(Form::Clear {
            number,
            decimal,
            thousands,
        })
    };
    match (n_mark, n_other) {
        (1, 0) if exponent.is_empty() && are_groups(mantissa, mark) => Some(Form::Open(mark)),
        (1, 0) => clear(mantissa.replace(mark, "."), Some(mark), None),
        (1, _) if are_groups(&mantissa[..last], other) => clear(
            mantissa.replace(other, "").replace(mark, "."),
            Some(mark),
            Some(other),
        ),
        (_, 0) if are_groups(mantissa, mark) => clear(mantissa.replace(mark, ""), None, Some(mark)),
        _ => None,
    }
}

/// Whether a cell is a number in one spelling or another.
pub(super) fn is_number(cell: &str) -> bool {
    form(cell).is_some()
}

/// Decimal and thousands marks found in the cells of a table.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Marks {
    /// The mark given by the user.
    given: Option<Decimal>,
    /// Whether a cell has a point, or a comma, that can only be a decimal mark.
    decimal: [bool; 2],
    /// Whether a cell has points, or commas, that can only separate thousands.
    thousands: [bool; 2],
}

impl Marks {
    /// Marks before any cell is seen.
    pub(super) fn new(given: Option<Decimal>) -> Self {
        Self {
            given,
            ..Self::default()
        }
    }

    /// Adds a cell.
    pub(super) fn see(&mut self, cell: &str) {
        // Most cells have no marks.
        if !cell.contains(['.', ',']) || !cell.starts_with(|c: char| !c.is_alphabetic()) {
            return;
        }
        if let Some(Form::Clear {
            decimal, thousands, ..
        }) = form(cell)
        {
            let place = |mark: char| usize::from(mark == ',');
            decimal
                .into_iter()
                .for_each(|mark| self.decimal[place(mark)] = true);
            thousands
                .into_iter()
                .for_each(|mark| self.thousands[place(mark)] = true);
        }
    }

    /// A cell as Rust reads it; `None` where it is no number.
    ///
    /// # Errors
    ///
    /// A number that may be two: `1,234`.
    pub(super) fn read<'a>(&self, cell: &'a str) -> Result<Option<Cow<'a, str>>, String> {
        let mark = match form(cell) {
            None => return Ok(None),
            Some(Form::Plain(number)) if number == cell => return Ok(Some(Cow::Borrowed(cell))),
            Some(Form::Plain(number)) => return Ok(Some(Cow::Owned(number))),
            Some(Form::Clear {
                number, decimal, ..
            }) => {
                let is_number = match (self.given, decimal) {
                    (Some(Decimal::Point), Some(',')) | (Some(Decimal::Comma), Some('.')) => false,
                    (Some(_) | None, _) => true,
                };
                return Ok(is_number.then_some(Cow::Owned(number)));
            }
            Some(Form::Open(mark)) => mark,
        };
        let plain = plain(cell).unwrap_or(Cow::Borrowed(cell));
        let as_decimal = plain.replace(mark, ".");
        let as_thousands = plain.replace(mark, "");
        let own = usize::from(mark == ',');
        let is_decimal = match self.given {
            Some(given) => Some((given == Decimal::Comma) == (mark == ',')),
            None => {
                let is_decimal =
                    self.decimal[own] && !self.thousands[own] && !self.decimal[1 - own];
                let is_thousands = self.thousands[own] && !self.decimal[own];
                // Programs write points.
                let is_program = mark == '.' && !self.thousands[own] && !self.decimal[1 - own];
                match (is_decimal || is_program, is_thousands) {
                    (true, _) => Some(true),
                    (false, true) => Some(false),
                    (false, false) => None,
                }
            }
        };
        match is_decimal {
            Some(true) => Ok(Some(Cow::Owned(as_decimal))),
            Some(false) => Ok(Some(Cow::Owned(as_thousands))),
            None => Err(format!(
                "`{}` may be {as_decimal} or {as_thousands}, and no other cell shows which; write more or fewer decimals, or give the \
                 decimal mark (`--decimal comma` or `--decimal point`)",
                excerpt(cell)
            )),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A cell among others.
    fn read(cells: &[&str]) -> Result<Option<String>, String> {
        let mut marks = Marks::default();
        cells.iter().for_each(|cell| marks.see(cell));
        Ok(marks.read(cells[0])?.map(Cow::into_owned))
    }

    #[test]
    fn marks_are_found_from_the_other_cells() {
        for (cells, expected) in [
            (&["112,052", "9,53843"][..], Ok(Some("112.052"))),
            (&["0,052"], Ok(Some("0.052"))),
            (&["1203,020"], Ok(Some("1203.020"))),
            (&["112.052"], Ok(Some("112.052"))),
            (&["1.203,02"], Ok(Some("1203.02"))),
            (&["1,203.02"], Ok(Some("1203.02"))),
            (&["1.203", "1.203,02"], Ok(Some("1203"))),
            (&["1,203", "1,203.02"], Ok(Some("1203"))),
            (&["1,203", "1,203,456"], Ok(Some("1203"))),
            (&["1,203"], Err(())),
            (&["1,203", "4.5", "2,5"], Err(())),
            (&["1,203", "4.5"], Err(())),
            (&["1.203", "2,5"], Err(())),
            (&["1 203,5"], Ok(Some("1203.5"))),
            (&["1'203.5"], Ok(Some("1203.5"))),
            (&["12\u{a0}345"], Ok(Some("12345"))),
            (&["−2,5e3"], Ok(Some("-2.5e3"))),
            (&["+2.5E+03"], Ok(Some("+2.5E+03"))),
            (&["1 2"], Ok(None)),
            (&["1,2,3"], Ok(None)),
            (&["1,23.4"], Ok(None)),
            (&["3OO"], Ok(None)),
            (&["--5"], Ok(None)),
            (&["inf"], Ok(None)),
            (&["nan"], Ok(None)),
            (&["."], Ok(None)),
            (&["17:28"], Ok(None)),
            (&["03.04.2017"], Ok(None)),
        ] {
            let found = read(cells).map_err(|_| ());
            assert_eq!(
                found.as_ref().map(|f| f.as_deref()),
                expected.as_ref().map(|e| *e),
                "{cells:?}"
            );
        }
        let with = |decimal| Marks::new(Some(decimal));
        assert_eq!(
            with(Decimal::Comma).read("1,203").unwrap().unwrap(),
            "1.203"
        );
        assert_eq!(with(Decimal::Point).read("1,203").unwrap().unwrap(), "1203");
        assert_eq!(with(Decimal::Point).read("1,2").unwrap(), None);
    }
}
