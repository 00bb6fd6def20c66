//! Options for reading a table: columns by their titles, columns to ignore, the decimal mark.

use super::super::{InputError, Table};
use super::number::Decimal;
use super::title::{readings, unit_of};
use super::{CsvError, CsvTable, names};

/// Options for reading a table.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CsvParams {
    /// Quantities and their columns.
    pub columns: Vec<ColumnMap>,
    /// Titles of columns to ignore.
    pub ignored: Vec<String>,
    /// The decimal mark; `None` for that of the cells.
    pub decimal: Option<Decimal>,
}

/// A quantity and its column, as in `film=Film (nm)` and `film=Film:nm`.
#[derive(Clone, Debug, PartialEq)]
pub struct ColumnMap {
    /// A name of the quantity, or a key of a case.
    pub name: String,
    /// The title of the column or its number, `#3`; a unit may follow a colon.
    pub title: String,
}

impl CsvParams {
    /// Reads the keys `columns` and `decimal` of a table in a file: `columns = { viscosity = "Result (mPas)" }`.
    ///
    /// # Errors
    ///
    /// Values of another kind.
    pub fn of_keys(table: &mut Table<'_>) -> Result<Self, InputError> {
        let mut params = Self::default();
        if let Some(mut columns) = table.optional_table("columns")? {
            let names: Vec<String> = columns.keys().map(str::to_owned).collect();
            for name in names {
                let title = columns.required_str(&name)?.to_owned();
                params.columns.push(ColumnMap { name, title });
            }
        }
        let marks = [("point", Decimal::Point), ("comma", Decimal::Comma)];
        params.decimal = table.optional_choice("decimal", &marks)?;
        Ok(params)
    }

    /// Reads a table in a file that has these keys and `ignore`, a list of titles, and no others.
    ///
    /// # Errors
    ///
    /// Other keys, values of another kind.
    pub fn of_table(mut table: Table<'_>) -> Result<Self, InputError> {
        let mut params = Self::of_keys(&mut table)?;
        let ignored = table.optional_strs("ignore")?.unwrap_or_default();
        params.ignored = ignored.into_iter().map(str::to_owned).collect();
        table.finish()?;
        Ok(params)
    }

    /// Combines both; `others` has priority.
    #[must_use]
    pub fn with(mut self, others: &Self) -> Self {
        let is_other = |map: &ColumnMap| others.columns.iter().any(|other| other.name == map.name);
        self.columns.retain(|map| !is_other(map));
        self.columns.extend(others.columns.iter().cloned());
        self.ignored.extend(others.ignored.iter().cloned());
        self.decimal = others.decimal.or(self.decimal);
        self
    }
}

/// Quantities that the columns of a table may have.
pub struct Vocabulary<'a> {
    /// Quantities, by the names of the program.
    pub names: &'a [&'static str],
    /// Whether a title is a key with a unit.
    pub is_key: &'a (dyn Fn(&str) -> bool + Sync),
}

impl Vocabulary<'_> {
    /// Nothing: the first line is the header.
    pub const NONE: Vocabulary<'static> = Vocabulary {
        names: &[],
        is_key: &|_| false,
    };

    /// The program's name of a quantity; the surest match.
    fn own(&self, name: &str) -> Option<&'static str> {
        let folded = names::fold(name);
        let sure = |own: &&'static str| names::matches(&folded, own).map(|sure| (sure, *own));
        let found = self.names.iter().filter_map(sure);
        found.max_by_key(|(sure, _)| *sure).map(|(_, own)| own)
    }
}

impl ColumnMap {
    /// Reads `NAME=TITLE` or `NAME=TITLE:UNIT`.
    ///
    /// # Errors
    ///
    /// A text without these parts.
    pub fn parse(text: &str) -> Result<Self, String> {
        match text.split_once('=') {
            Some((name, title)) if !name.trim().is_empty() && !title.trim().is_empty() => Ok(Self {
                name: name.trim().to_owned(),
                title: title.trim().to_owned(),
            }),
            _ => Err(
                "write NAME=TITLE, or NAME=TITLE:UNIT where the title has no unit, such as film=\"Film (nm)\" or film=Film:nm"
                    .to_owned(),
            ),
        }
    }

    /// Place of the column, and its unit if one follows the title.
    fn find<'a>(&'a self, table: &CsvTable) -> Option<(usize, Option<&'a str>)> {
        let parted = self
            .title
            .rsplit_once(':')
            .filter(|(_, unit)| unit_of(unit).is_some());
        table
            .place(&self.title)
            .map(|place| (place, None))
            .or_else(|| {
                let (title, unit) = parted?;
                Some((table.place(title.trim())?, Some(unit.trim())))
            })
    }
}

impl CsvTable {
    /// Place of a column by its title, or its number as in `#3`.
    fn place(&self, title: &str) -> Option<usize> {
        let cells = self.header.cells();
        let number = || {
            let number: usize = title.strip_prefix('#')?.trim().parse().ok()?;
            (1..=cells.len()).contains(&number).then(|| number - 1)
        };
        let folded = names::fold(title);
        let same = |fits: &dyn Fn(&String) -> bool| {
            let mut found = (0..cells.len()).filter(|i| fits(&cells[*i]));
            found.next().filter(|_| found.next().is_none())
        };
        let written = || same(&|cell| cell == title);
        written()
            .or_else(|| same(&|cell| !folded.is_empty() && names::fold(cell) == folded))
            .or_else(number)
    }

    /// Applies the user's titles of columns, and blots out the ignored columns.
    pub(super) fn apply(
        &mut self,
        params: &CsvParams,
        vocabulary: &Vocabulary<'_>,
    ) -> Result<(), CsvError> {
        let listed = |table: &Self| table.header.cells().join(", ");
        for name in &params.ignored {
            let cells = self.header.cells().iter().enumerate();
            let places: Vec<usize> = cells
                .filter(|(_, cell)| *cell == name)
                .map(|(i, _)| i)
                .collect();
            if places.is_empty() {
                let problem = format!(
                    "there is no column `{name}` to be ignored; the columns are {}",
                    listed(self)
                );
                return Err(self.error(&self.header, 0, problem));
            }
            places.into_iter().for_each(|place| self.blot_out(place));
        }
        let mut mapped: Vec<(usize, String)> = Vec::new();
        for map in &params.columns {
            let Some((place, unit)) = map.find(self) else {
                let problem = format!(
                    "there is no column `{}`, or more than one, for {}; the columns are {}; or give its number, as in #3",
                    map.title,
                    map.name,
                    listed(self)
                );
                return Err(self.error(&self.header, 0, problem));
            };
            let own = vocabulary.own(&map.name);
            let name = match own {
                Some(own) => own.to_owned(),
                None if (vocabulary.is_key)(&map.name) => map.name.clone(),
                None => {
                    let problem = format!(
                        "`{}` is no quantity that a column of this table may be; it may be {}",
                        map.name,
                        vocabulary.names.join(", ")
                    );
                    return Err(self.error(&self.header, place, problem));
                }
            };
            if let Some((_, former)) = mapped
                .iter()
                .find(|(other, former)| *other == place || *former == name)
            {
                let problem = format!(
                    "this column is given as {name}, and as {former} or for another column, too"
                );
                return Err(self.error(&self.header, place, problem));
            }
            mapped.push((place, name.clone()));
            let unit = unit.map(str::to_owned);
            self.titles[place] = match unit.or_else(|| own_unit(self.header.cell(place))) {
                Some(unit) => format!("{name} [{unit}]"),
                None => name,
            };
            // A column of that name in the table is another one.
            let Some(own) = own else { continue };
            for other in 0..self.titles.len() {
                let is_mapped = mapped.iter().any(|(place, _)| *place == other);
                if !is_mapped && vocabulary.own_of_title(&self.titles[other]) == Some(own) {
                    let note = format!("column `{}` is ignored", self.header.cell(other));
                    self.notes.push(note);
                    self.blot_out(other);
                }
            }
        }
        Ok(())
    }

    fn blot_out(&mut self, place: usize) {
        self.titles[place] = String::new();
        self.is_ignored[place] = true;
    }
}

/// The unit in a title.
fn own_unit(title: &str) -> Option<String> {
    (readings(title).into_iter())
        .find(|reading| !reading.unit.is_empty() && unit_of(&reading.unit).is_some())
        .map(|reading| reading.unit.into_owned())
}

impl Vocabulary<'_> {
    /// The quantity that a title names, with a unit or without.
    pub(super) fn own_of_title(&self, title: &str) -> Option<&'static str> {
        readings(title).into_iter().find_map(|reading| {
            let own = self.own(&reading.name)?;
            let is_unit = reading.unit.is_empty() || unit_of(&reading.unit).is_some();
            is_unit.then_some(own)
        })
    }

    /// Whether a cell is the title of a column that may be there.
    pub(super) fn knows(&self, cell: &str) -> bool {
        !cell.is_empty() && (self.own_of_title(cell).is_some() || (self.is_key)(cell))
    }
}
