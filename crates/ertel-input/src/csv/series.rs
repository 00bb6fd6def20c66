//! Tables of one quantity over another: lifts over angles, speeds over time.

use ertel_quantity::Dimension;

use super::{Column, CsvError, CsvParams, CsvTable, Vocabulary, title};

/// A quantity that a table has: the names of its column, the program's own first, and what it measures.
#[derive(Clone, Copy)]
pub struct Wanted<'a> {
    /// Names, each known with its other spellings.
    pub names: &'a [&'static str],
    /// Dimension.
    pub dimension: Dimension,
}

impl CsvTable {
    /// Reads a table of one quantity over another and finds both columns: each has one of the names of its quantity, or is the only one with such a unit.
    ///
    /// # Errors
    ///
    /// As [`CsvTable::parse_for`] and [`CsvTable::find_with_unit`]; neither a column of that name nor a single one with such a unit.
    pub fn series(
        file: &str,
        text: &str,
        wanted: [Wanted<'_>; 2],
    ) -> Result<(Self, [Column; 2]), CsvError> {
        let names: Vec<&'static str> = wanted.iter().flat_map(|of| of.names).copied().collect();
        let vocabulary = Vocabulary {
            names: &names,
            is_key: &|_| false,
        };
        let table = Self::parse_for(file, text, &vocabulary, &CsvParams::default())?;
        let first = table.named(wanted[0])?;
        let second = table.named(wanted[1])?;
        let place = |column: &Option<Column>| column.as_ref().map(|column| column.index);
        let taken = [place(&first), place(&second)];
        let first = first.map_or_else(|| table.only(wanted[0], taken[1]), Ok)?;
        let second = second.map_or_else(|| table.only(wanted[1], Some(first.index)), Ok)?;
        Ok((table, [first, second]))
    }

    /// The unit of the last digit of a column's numbers, SI, as its largest numbers are written: small ones may have more digits, and zeros at the end may be omitted.
    /// 0 without a number.
    #[must_use]
    pub fn last_digit(&self, column: &Column) -> f64 {
        let numbers = || {
            let cells = self
                .rows
                .iter()
                .map(|row| self.with_point(row.cell(column.index)));
            cells.filter_map(|cell| Some((cell.parse::<f64>().ok()?.abs(), exponent(&cell))))
        };
        let largest = numbers().map(|(size, _)| size).fold(0.0, f64::max);
        let of_large = numbers().filter(|(size, _)| *size >= 0.5 * largest);
        let unit = of_large.map(|(_, exponent)| 10_f64.powi(exponent));
        let unit = unit.fold(f64::INFINITY, f64::min);
        let si = column.unit.to_si(1.0) - column.unit.to_si(0.0);
        if unit.is_finite() { unit * si } else { 0.0 }
    }

    /// The column that has one of the names.
    fn named(&self, wanted: Wanted<'_>) -> Result<Option<Column>, CsvError> {
        for name in wanted.names {
            if let Some(found) = self.find_with_unit(name, wanted.dimension)? {
                return Ok(Some(found));
            }
        }
        Ok(None)
    }

    /// The only column with such a unit other than `taken`.
    fn only(&self, wanted: Wanted<'_>, taken: Option<usize>) -> Result<Column, CsvError> {
        let name = wanted.names.first().copied().unwrap_or_default();
        let mut found = (0..self.titles.len())
            .filter(|index| Some(*index) != taken && !self.titles[*index].is_empty())
            .filter_map(|index| {
                Some((
                    index,
                    title::unit_with(&self.titles[index], wanted.dimension)?,
                ))
            });
        match (found.next(), found.next()) {
            (Some((index, unit)), None) => Ok(Column {
                index,
                name,
                unit: unit.unit,
                unit_text: unit.text,
                is_open: true,
            }),
            (Some((one, _)), Some((other, _))) => {
                let problem = format!(
                    "there is no column `{name}`, and columns {} and {} both have a unit of {}: call one of them `{name}`",
                    one + 1,
                    other + 1,
                    wanted.dimension.name()
                );
                Err(self.error(&self.header, one, problem))
            }
            (None, _) => {
                let problem = format!(
                    "there is no column `{name}`, and none with a unit of {}: {}",
                    wanted.dimension.name(),
                    wanted.dimension.examples()
                );
                Err(self.error(&self.header, 0, problem))
            }
        }
    }
}

/// The power of ten of the last digit of a number: −2 of `12.50` and of `1.250e1`.
fn exponent(number: &str) -> i32 {
    let small = number.to_ascii_lowercase();
    let (mantissa, power) = small.split_once('e').unwrap_or((&small, "0"));
    let decimals = mantissa
        .split_once('.')
        .map_or(0, |(_, part)| part.trim().len());
    power
        .trim()
        .parse::<i32>()
        .unwrap_or(0)
        .saturating_sub(i32::try_from(decimals).unwrap_or(i32::MAX))
}

#[cfg(test)]
mod tests {
    use super::*;

    const TIME: Wanted<'_> = Wanted {
        names: &["time"],
        dimension: Dimension::TIME,
    };
    const SPEED: Wanted<'_> = Wanted {
        names: &["entrainment speed", "value"],
        dimension: Dimension::SPEED,
    };

    /// As loggers title them, in either order and with lines of the instrument before.
    #[test]
    fn titles_of_loggers() {
        for text in [
            "time (s);speed (m/s)\n0;0.2\n1;0.3\n",
            "t [ms],u [m/s]\n0,0.2\n1000,0.3\n",
            "Zeit (ms);Geschwindigkeit (m/s)\n0;0,2\n1000;0,3\n",
            "Logger 7\n\ntime [s];value [m/s]\n0;0.2\n1;0.3\n",
            "Disc drum [mm/s];Elapsed [s]\n200;0\n300;1\n",
        ] {
            let (table, [time, speed]) = CsvTable::series("log.csv", text, [TIME, SPEED]).unwrap();
            let rows = table.rows().iter();
            let read: Vec<[f64; 2]> = rows
                .map(|row| {
                    let of = |column| table.required_number(row, column).unwrap();
                    [of(&time), of(&speed)]
                })
                .collect();
            assert_eq!(read, [[0.0, 0.2], [1.0, 0.3]], "{text}");
        }
        for (text, words) in [
            ("time (s);a (m/s);b (m/s)\n0;1;2\n", "both have a unit"),
            (
                "time (s);load (N)\n0;1\n",
                "there is no column `entrainment speed`",
            ),
            ("time (s);speed\n0;1\n", "unit"),
        ] {
            let error = CsvTable::series("log.csv", text, [TIME, SPEED]).unwrap_err();
            assert!(error.to_string().contains(words), "{error}");
        }
    }

    /// The last digit of the largest numbers: zeros at the end may be omitted, and small numbers have more digits where digits are significant ones.
    #[test]
    fn last_digits() {
        for (cells, digit) in [
            ("0.0000\n0.1250\n0.2", 1e-4),
            ("1.25e1\n1e0", 1e-1),
            ("0.00263\n5.217", 1e-3),
            ("0,125\n0,25", 1e-3),
            ("3\n12", 1.0),
        ] {
            let text = format!("time [s];value [m/s]\n0;{}\n", cells.replace('\n', "\n1;"));
            let (table, [_, speed]) = CsvTable::series("log.csv", &text, [TIME, SPEED]).unwrap();
            let found = table.last_digit(&speed);
            assert!((found / digit - 1.0).abs() < 1e-9, "{cells}: {found}");
        }
    }
}
