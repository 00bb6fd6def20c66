//! Damage to tables: rows, columns, cells, quotes, separators, decimal commas.

use fastrand::Rng;

use super::Words;
use super::bytes::LONGEST;
use super::tokens::NUMBERS;

/// Titles that readers know, and some that they do not.
const TITLES: [&str; 24] = [
    "pressure_MPa",
    "pressure [GPa]",
    "absolute_pressure_MPa",
    "temperature_K",
    "temperature [degC]",
    "viscosity_mPa_s",
    "viscosity [Pa.s]",
    "density_kg_per_m3",
    "density [kg/m^3]",
    "thermal conductivity [W/(m.K)]",
    "heat capacity [J/(kg.K)]",
    "film_central_m",
    "film_minimum_m",
    "film_central_error_m",
    "entrainment_speed_m_per_s",
    "load_N",
    "load_N_per_m",
    "moes_load",
    "moes_material",
    "speed_group",
    "radius_m",
    "contact.load_N",
    "motion.slide_to_roll_ratio",
    "viscosity",
];

/// Rows of a table that is made longer, at most.
const MOST_ROWS: usize = 3000;

/// Changes one thing in a table.
pub fn damage(text: &mut String, rng: &mut Rng, words: &Words) {
    let separator = [';', '\t']
        .into_iter()
        .find(|c| text.contains(*c))
        .unwrap_or(',');
    let mut rows: Vec<Vec<String>> = text
        .lines()
        .map(|line| line.split(separator).map(str::to_owned).collect())
        .collect();
    if rows.is_empty() {
        return text.push_str("pressure_MPa,temperature_K,viscosity_mPa_s\n1,300,1\n");
    }
    let row = rng.usize(0..rows.len());
    let column = rng.usize(0..rows[row].len());
    let mut separator = separator.to_string();
    match rng.u8(0..18) {
        0 => drop(rows.remove(row)),
        1 => {
            let to = rng.usize(0..rows.len());
            rows.swap(row, to);
        }
        2 => {
            let times = [1, 1, 2, 100, MOST_ROWS][rng.usize(0..5)];
            let copy = rows[row].clone();
            // Longer values are cut off anyway.
            let length: usize = copy.iter().map(|cell| cell.len() + 1).sum();
            let times = times.min(1 + LONGEST / length);
            rows.splice(row..row, std::iter::repeat_n(copy, times));
        }
        3 => rows
            .iter_mut()
            .filter(|r| column < r.len())
            .for_each(|r| drop(r.remove(column))),
        4 => rows
            .iter_mut()
            .filter(|r| column < r.len())
            .for_each(|r| r.insert(column, r[column].clone())),
        5 => {
            let to = rng.usize(0..rows[row].len());
            rows.iter_mut()
                .filter(|r| column.max(to) < r.len())
                .for_each(|r| r.swap(column, to));
        }
        6 => rows[row].truncate(column),
        7 => rows[row].push(words.word(rng).to_owned()),
        8 => rows[row][column] = format!("\"{}\"", rows[row][column]),
        9 => rows[row][column] = format!("\"{}", rows[row][column]),
        10 => rows[row][column].clear(),
        11 => separator = [",", ";", "\t", " ", "|", ", ", "\";\""][rng.usize(0..7)].to_owned(),
        12 => rows
            .iter_mut()
            .flatten()
            .for_each(|cell| *cell = cell.replace('.', ",")),
        13 => {
            let head = rows
                .iter()
                .position(|r| !r[0].starts_with('#'))
                .unwrap_or(0);
            let column = rng
                .usize(0..rows[head].len().max(1))
                .min(rows[head].len().saturating_sub(1));
            if let Some(title) = rows[head].get_mut(column) {
                *title = TITLES[rng.usize(0..TITLES.len())].to_owned();
            }
        }
        14 => {
            // A column of one value, or in another scale.
            let factor = [0.0, 1e-9, 1e9, 1e150, -1.0][rng.usize(0..5)];
            for cell in rows.iter_mut().filter_map(|r| r.get_mut(column)) {
                if let Ok(value) = cell.trim().parse::<f64>() {
                    *cell = format!("{:e}", value * factor);
                }
            }
        }
        _ => rows[row][column] = NUMBERS[rng.usize(0..NUMBERS.len())].to_owned(),
    }
    let end = ["\n", "\n", "\n", "\r\n", "\r"][rng.usize(0..5)];
    let lines: Vec<String> = rows.iter().map(|row| row.join(&separator)).collect();
    *text = lines.join(end) + end;
    if rng.u8(0..20) == 0 {
        text.insert(0, '\u{feff}');
    }
}
