//! Differences of several curves, machines or studies from the first of them.

use std::cell::Cell;

use ertel_input::csv::{CsvTable, Row};
use serde_json::Value;

use super::super::lines::{Lines, Table};
use super::super::study::words;
use crate::figures::{bearing, gears, machine, words_of};
use crate::solution::Figure;
use crate::words::{CELSIUS, digits};

/// Compared figures, by their column titles up to the unit.
const FIGURES: [&str; 9] = [
    Figure::FilmCentral.name(),
    Figure::FilmMinimum.name(),
    Figure::PressureCentral.name(),
    Figure::TractionCoefficient.name(),
    Figure::FrictionPower.name(),
    bearing::FRICTION_TORQUE.name,
    gears::MESH_LOSS.name,
    Figure::FilmTemperatureMaximum.name(),
    machine::LAMBDA_MINIMUM.name,
];

/// Maximum number of rows per result.
const MOST_ROWS: usize = 200;

/// Relative difference up to which two numbers are the same place.
const SAME: f64 = 1e-9;

/// Rows of a table by their cells.
struct Rows {
    head: Vec<String>,
    body: Vec<Vec<String>>,
    n_axes: usize,
}

/// Name, rows and overall figures of a result.
struct Part<'a> {
    name: &'a str,
    rows: Rows,
    figures: &'a Value,
}

/// Writes the differences of all tables from the first one: at the points of the first curve; row by row for machines and studies.
pub(super) fn write(out: &mut Lines, tables: &[Value]) {
    let parts: Vec<Part> = tables.iter().filter_map(part).collect();
    let Some((first, others)) = parts.split_first() else {
        return;
    };
    for other in others {
        let (whole, rows) = (whole(first, other), rows(&first.rows, &other.rows));
        if whole.is_none() && rows.is_none() {
            continue;
        }
        out.heading(&format!("{} against {}", other.name, first.name));
        whole.into_iter().for_each(|table| out.table(table));
        let Some((table, n_left_out, is_between)) = rows else {
            continue;
        };
        out.table(table);
        if is_between {
            out.note("linear interpolation between points of the other result");
        }
        if n_left_out > 0 {
            out.note(&format!(
                "{n_left_out} rows of the first result are not shown: they have no counterpart in the other result, or exceed the {MOST_ROWS} rows of this table"
            ));
        }
    }
}

fn part(table: &Value) -> Option<Part<'_>> {
    let csv = CsvTable::parse("", table["csv"].as_str()?).ok()?;
    let head = csv.header().cells().to_vec();
    let whole = |row: &Row| (0..head.len()).map(|i| row.cell(i).to_owned()).collect();
    let rows = Rows {
        body: csv.rows().iter().map(whole).collect(),
        head,
        n_axes: table["n_axes"].as_u64()? as usize,
    };
    Some(Part {
        name: table["name"].as_str()?,
        rows,
        figures: &table["figures"],
    })
}

/// Figures of two whole machines, each with its marks.
fn whole(first: &Part, other: &Part) -> Option<Table> {
    let of = first.figures.as_array()?.iter().filter_map(|figure| {
        let (name, unit) = (figure["name"].as_str()?, figure["unit"].as_str()?);
        let counterpart = (other.figures.as_array()?.iter()).find(|f| f["name"] == name)?;
        let change = match (figure["value"].as_f64(), counterpart["value"].as_f64()) {
            (Some(own), Some(new)) => with_change(own, new, unit).1,
            _ => "-".to_owned(),
        };
        let words = format!("{} {}", figure["words"].as_str()?, in_brackets(unit));
        Some(vec![
            words.trim_end().to_owned(),
            marked(figure, unit),
            marked(counterpart, unit),
            change,
        ])
    });
    let rows: Vec<Vec<String>> = of.collect();
    let head = ["figure", "first", "second", "difference"];
    (!rows.is_empty()).then(|| table(head.map(str::to_owned).to_vec(), rows))
}

/// The rows of the first result with a counterpart in the other, the number of omitted rows, and whether any value was interpolated.
fn rows(first: &Rows, other: &Rows) -> Option<(Table, usize, bool)> {
    let figures: Vec<([usize; 2], String, String)> = (first.head.iter().enumerate())
        .filter_map(|(i, title)| {
            let (name, unit) = name_of(title);
            let is_compared = FIGURES.contains(&name.as_str());
            let j = other.head.iter().position(|own| own == title)?;
            is_compared.then_some(([i, j], name, unit))
        })
        .collect();
    if first.n_axes >= first.head.len() {
        return None;
    }
    let axes: Vec<[usize; 2]> = (1..=first.n_axes)
        .filter_map(|i| {
            let title = first.head.get(i)?;
            Some([i, other.head.iter().position(|own| own == title)?])
        })
        .collect();
    if figures.is_empty() || axes.is_empty() || axes.len() < first.n_axes {
        return None;
    }
    let is_between = Cell::new(false);
    let mut compared = Vec::new();
    for (i, row) in first.body.iter().enumerate() {
        // Rows at one place, the sides of a jump, are compared in their order.
        let is_here = |body: &&Vec<String>| axes.iter().all(|[i, _]| is_same(&row[*i], &body[*i]));
        let nth = first.body[..i].iter().filter(is_here).count();
        let Some(found) = place((row, nth), &axes, other, |_| true) else {
            continue;
        };
        let read = |found: &Place, j: usize| match found {
            Place::At(k) => number(&other.body[*k][j]),
            Place::Between(k, l, share) => {
                let [low, high] = [*k, *l].map(|k| number(&other.body[k][j]));
                is_between.set(true);
                Some(low? * (1.0 - share) + high? * share)
            }
        };
        // The other side of a jump has no films.
        let filled = |j: usize| place((row, nth), &axes, other, |body| number(&body[j]).is_some());
        let at = |j: usize| read(&found, j).or_else(|| read(&filled(j)?, j));
        let mut cells: Vec<String> = (axes.iter())
            .map(|[i, _]| match number(&row[*i]) {
                Some(value) => shown(value, &words(&first.head[*i]).1),
                None => row[*i].clone(),
            })
            .collect();
        for ([i, j], _, unit) in &figures {
            let both = number(&row[*i]).and_then(|own| Some((own, at(*j)?)));
            cells.push(both.map_or("-".to_owned(), |(own, new)| with_change(own, new, unit).1));
        }
        compared.push(cells);
    }
    if compared.is_empty() {
        return None;
    }
    // Figures without a value in any row are omitted.
    let has = |k: usize| compared.iter().any(|row| row[k] != "-");
    let mut head: Vec<String> = (axes.iter())
        .map(|[i, _]| {
            let (name, unit) = words(&first.head[*i]);
            format!("{name} {}", in_brackets(&unit))
                .trim_end()
                .to_owned()
        })
        .collect();
    head.extend(figures.iter().map(|(_, name, _)| words_of(name)));
    let kept: Vec<usize> = (0..head.len())
        .filter(|k| *k < axes.len() || has(*k))
        .collect();
    let pick = |cells: &Vec<String>| kept.iter().map(|k| cells[*k].clone()).collect();
    let shown: Vec<Vec<String>> = compared.iter().take(MOST_ROWS).map(pick).collect();
    let n_left_out = first.body.len() - shown.len();
    Some((table(pick(&head), shown), n_left_out, is_between.get()))
}

/// Counterpart of a row of the first result in the other one.
enum Place {
    At(usize),
    Between(usize, usize, f64),
}

/// Whether two cells name the same place.
fn is_same(own: &str, there: &str) -> bool {
    match number(own).zip(number(there)) {
        Some((a, b)) => (a - b).abs() <= SAME * a.abs().max(b.abs()),
        None => own == there,
    }
}

/// Of the rows of the other result that `keeps`, the n-th at the same place or the last one there; with a single numeric axis also between two rows.
fn place(
    (row, nth): (&[String], usize),
    axes: &[[usize; 2]],
    other: &Rows,
    keeps: impl Fn(&[String]) -> bool,
) -> Option<Place> {
    let kept = || (other.body.iter().enumerate()).filter(|(_, body)| keeps(body));
    let is_here = |body: &[String]| axes.iter().all(|[i, j]| is_same(&row[*i], &body[*j]));
    if let Some((k, _)) = kept()
        .filter(|(_, body)| is_here(body))
        .take(nth + 1)
        .last()
    {
        return Some(Place::At(k));
    }
    let [[i, j]] = axes else { return None };
    let at = number(&row[*i])?;
    let places = kept().filter_map(|(k, body)| Some((k, number(&body[*j])?)));
    let places: Vec<(usize, f64)> = places.collect();
    let below = places
        .iter()
        .filter(|(_, x)| *x < at)
        .max_by(|a, b| a.1.total_cmp(&b.1))?;
    let above = places
        .iter()
        .filter(|(_, x)| *x > at)
        .min_by(|a, b| a.1.total_cmp(&b.1))?;
    let share = (at - below.1) / (above.1 - below.1);
    Some(Place::Between(below.0, above.0, share))
}

fn number(cell: &str) -> Option<f64> {
    cell.parse().ok().filter(|v: &f64| v.is_finite())
}

/// Name and unit of a column of figures.
fn name_of(title: &str) -> (String, String) {
    let (name, unit) = words(title);
    (name.replace([' ', '-'], "_"), unit)
}

/// Unit of a temperature rise in page data; temperatures have the unit K and are shown in °C.
pub(super) const RISE: &str = "K rise";

/// The display unit of a number, in brackets.
fn in_brackets(unit: &str) -> String {
    match unit {
        RISE => "(K)".to_owned(),
        "" => String::new(),
        "K" => "(°C)".to_owned(),
        unit => format!("({unit})"),
    }
}

fn shown(value: f64, unit: &str) -> String {
    digits(if unit == "K" { value - CELSIUS } else { value }, 5)
}

/// A figure of a machine with the symbols of its marks.
fn marked(figure: &Value, unit: &str) -> String {
    match figure["value"].as_f64() {
        Some(value) => shown(value, unit) + figure["marks"].as_str().unwrap_or_default(),
        None => "not resolved".to_owned(),
    }
}

/// The second number and its difference: in K for temperatures, in per cent otherwise.
fn with_change(own: f64, new: f64, unit: &str) -> (String, String) {
    let change = match (unit, own) {
        ("K" | RISE, _) => format!("{:+.2} K", new - own),
        (_, own) if own == new => "0".to_owned(),
        (_, 0.0) => "-".to_owned(),
        _ => format!("{:+.2} %", 100.0 * (new / own - 1.0)),
    };
    (shown(new, unit), change)
}

fn table(head: Vec<String>, rows: Vec<Vec<String>>) -> Table {
    Table {
        head,
        rows,
        widths: Vec::new(),
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::super::super::lines::Block;
    use super::*;

    fn differences(tables: &[Value]) -> Vec<Table> {
        let mut out = Lines::default();
        write(&mut out, tables);
        let tables = out.blocks.into_iter().filter_map(|block| match block {
            Block::Table(table) => Some(table),
            _ => None,
        });
        tables.collect()
    }

    fn of(name: &str, csv: &str, n_axes: usize) -> Value {
        json!({ "name": name, "csv": csv, "n_axes": n_axes, "figures": null })
    }

    /// The sides of a jump are compared with each other, films only where they are.
    #[test]
    fn both_sides_of_a_jump() {
        let csv = |films: [&str; 3], power: [f64; 3]| {
            let mut text = "contact,position_m,film_central_m,friction_power_W_per_m\n".to_owned();
            for (i, place) in [0, 1, 1].into_iter().enumerate() {
                text += &format!("{},{place},{},{}\n", place + 1, films[i], power[i]);
            }
            text
        };
        let first = of("one", &csv(["1e-7", "", "1e-7"], [1.0, 2.0, 4.0]), 1);
        let other = of("other", &csv(["1e-7", "", "2e-7"], [1.0, 3.0, 8.0]), 1);
        let found = &differences(&[first, other])[0];
        let cells: Vec<[&str; 2]> = (found.rows.iter())
            .map(|row| [row[1].as_str(), row[2].as_str()])
            .collect();
        assert_eq!(
            cells,
            [["0", "0"], ["-", "+50.00 %"], ["+100.00 %", "+100.00 %"]]
        );
    }

    /// Pages are read from files: a table may state more axes than it has columns.
    #[test]
    fn a_table_with_fewer_columns_than_axes_is_omitted() {
        let of = of("one", "point,film_central_m\n1,2e-7\n", 3);
        assert!(differences(&[of.clone(), of]).is_empty());
        let of = self::of("one", "point,film_central_m\n1,2e-7\n", usize::MAX);
        assert!(differences(&[of.clone(), of]).is_empty());
        let of = self::of("one", "point\n1\n", 1);
        assert!(differences(&[of.clone(), of]).is_empty());
    }

    /// By hand: at 2 m/s the other film is midway between 300 and 500 nm, 100 % above 200 nm; 4 m/s is beyond it. At 1 m/s both have points: +50 %
    /// and 3 K.
    #[test]
    fn curves_over_the_places_of_the_first() {
        let head = "point,entrainment_speed_m_per_s,film_central_m,film_temperature_maximum_K\n";
        let first = format!("{head}1,1e0,2e-7,300\n2,2e0,2e-7,300\n3,4e0,3e-7,310\n");
        let other = format!("{head}1,1e0,3e-7,303\n2,3e0,5e-7,305\n");
        let tables = differences(&[of("one", &first, 1), of("two", &other, 1)]);
        assert_eq!(tables.len(), 1);
        assert_eq!(
            tables[0].head,
            [
                "entrainment speed (m/s)",
                "central film thickness",
                "largest film temperature"
            ]
        );
        assert_eq!(
            tables[0].rows,
            [["1", "+50.00 %", "+3.00 K"], ["2", "+100.00 %", "+4.00 K"]]
        );
    }

    /// Row by row for the same contact and ring, and the figures of the whole machine.
    #[test]
    fn machines_row_by_row() {
        let head = "contact,angle_rad,ring,name,film_minimum_m\n";
        let first = format!("{head}1,0e0,inner,\"ball 0, inner ring\",2e-7\n2,0e0,outer,b,1e-7\n");
        let other =
            format!("{head}1,0e0,inner,\"ball 0, inner ring\",1e-7\n2,0e0,outer,b,1.5e-7\n");
        let figure = |value: f64| {
            json!([
                { "name": "friction_torque", "words": "torque", "unit": "N m", "value": value, "marks": " (f)" },
                { "name": "spin", "words": "spin", "unit": "W", "value": null },
                { "name": "flash", "words": "rise", "unit": RISE, "value": 300.0 * value },
                { "name": "flank", "words": "flank", "unit": "K", "value": 273.15 + 300.0 * value },
            ])
        };
        let mut both = [of("one", &first, 2), of("two", &other, 2)];
        for (table, value) in both.iter_mut().zip([0.2, 0.1]) {
            table["figures"] = figure(value);
        }
        let tables = differences(&both);
        assert_eq!(
            tables[0].rows,
            [
                ["torque (N m)", "0.2 (f)", "0.1 (f)", "-50.00 %"],
                ["spin (W)", "not resolved", "not resolved", "-"],
                ["rise (K)", "60", "30", "-30.00 K"],
                ["flank (°C)", "60", "30", "-30.00 K"],
            ]
        );
        assert_eq!(
            tables[1].rows,
            [["0", "inner", "-50.00 %"], ["0", "outer", "+50.00 %"]]
        );
    }
}
