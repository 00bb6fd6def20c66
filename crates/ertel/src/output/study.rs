//! The picture of a study: films over one of its axes.

use std::collections::{HashMap, HashSet};

use ertel_rheology::quantity::Unit;

use super::plot::{Axis, Chart, Look, PALETTE, Series, film_unit};
use super::report::digits;
use crate::study::StudyEcho;
use crate::study::journal::{PointKey, Record};

/// Values of an axis from which films over it are a picture.
const FEWEST_POINTS: usize = 3;
/// Ratio of the largest to the smallest value from which an axis is logarithmic.
const LOG_FROM: f64 = 5.0;

/// Central films with dots and minimum films without, over the axis with the most numbers, a colour for each combination
/// of the others. `None` where no axis has three numbers, or there are more combinations than colours.
pub fn study_chart(study: &StudyEcho, records: &HashMap<PointKey, Record>) -> Option<Chart> {
    let number = |column: usize| {
        let values = study.points.iter().map(|(_, values)| &values[column]);
        values
            .map(|v| v.parse::<f64>().ok())
            .collect::<Option<Vec<_>>>()
    };
    let distinct = |column: &usize| {
        let values = study.points.iter().map(|(_, values)| &values[*column]);
        values.collect::<HashSet<_>>().len()
    };
    let numeric = (0..study.columns.len()).filter(|c| number(*c).is_some());
    // The first of equals.
    let x = numeric.rev().max_by_key(distinct)?;
    if distinct(&x) < FEWEST_POINTS {
        return None;
    }
    let xs = number(x)?;
    let field = |i: usize, name: &str| -> Option<f64> {
        let record = records.get(&study.points[i].0)?;
        let (_, value) = record.fields.iter().find(|(own, _)| own == name)?;
        value.parse().ok()
    };
    let mut combinations: Vec<(String, Vec<usize>)> = Vec::new();
    for (i, (_, values)) in study.points.iter().enumerate() {
        let others = study.columns.iter().zip(values).enumerate();
        let shown =
            others
                .filter(|(c, _)| *c != x && distinct(c) > 1)
                .map(|(_, (title, value))| {
                    let (name, unit) = words(title);
                    match value.parse::<f64>() {
                        Ok(number) => format!("{name} {} {unit}", digits(number, 4))
                            .trim_end()
                            .to_owned(),
                        Err(_) => format!("{name} {}", value.replace(['{', '}', '*'], "")),
                    }
                });
        let label = shown.collect::<Vec<_>>().join(", ");
        match combinations.iter_mut().find(|(known, _)| *known == label) {
            Some((_, points)) => points.push(i),
            None => combinations.push((label, vec![i])),
        }
    }
    if combinations.len() > PALETTE.len() {
        return None;
    }
    let films = [
        ("central film", "film_central_m", Look::LineAndDots),
        ("minimum film", "film_minimum_m", Look::Line),
    ];
    let all = || {
        let pairs = (0..study.points.len()).flat_map(|i| films.map(|(_, name, _)| field(i, name)));
        pairs.flatten()
    };
    let (factor, film_unit) = film_unit(all().fold(0.0, f64::max));
    let x_range = range(xs.iter().copied());
    let (name, unit) = words(&study.columns[x]);
    let mut x_title = name;
    if let Some(first) = x_title.get_mut(..1) {
        first.make_ascii_uppercase();
    }
    if !unit.is_empty() {
        x_title += &format!(" ({unit})");
    }
    let x_axis = match is_wide(x_range) {
        true => Axis::log_close_around(&x_title, xs.iter().copied()),
        false => Axis::linear_around(&x_title, xs.iter().copied()),
    };
    let label = format!("Film thickness *h* ({film_unit})");
    let heights = || all().map(|h| factor * h);
    let y_axis = match is_wide(x_range) && is_wide(range(heights())) {
        true => Axis::log_close_around(&label, heights()),
        false => Axis::linear_around(&label, heights().chain([0.0])),
    };
    let mut chart = Chart::new(&study.title, x_axis, y_axis);
    let single = combinations.len() == 1;
    for ((label, points), colour) in combinations.iter().zip(PALETTE) {
        for (name, column, look) in films {
            let mut points: Vec<[f64; 2]> = (points.iter())
                .map(|i| [xs[*i], field(*i, column).map_or(f64::NAN, |h| factor * h)])
                .collect();
            points.sort_by(|a, b| a[0].total_cmp(&b[0]));
            chart.series.push(Series {
                label: match (single, look) {
                    (true, _) => name.to_owned(),
                    (false, Look::LineAndDots) => label.clone(),
                    (false, _) => String::new(),
                },
                points,
                look,
                colour: colour.to_owned(),
                ..Series::default()
            });
        }
    }
    Some(chart)
}

/// Words and unit of a column: entrainment speed and m/s of `motion.entrainment_speed_m_per_s`.
fn words(title: &str) -> (String, String) {
    let name = title.rsplit('.').next().unwrap_or(title);
    // The longest unit: `_m_per_s` before `_s`.
    for (i, _) in name.match_indices('_') {
        let unit = name[i + 1..].replace("_per_", "/").replace('_', ".");
        if !unit.is_empty() && Unit::parse(&unit).is_ok() {
            return (name[..i].replace('_', " "), unit);
        }
    }
    (name.replace('_', " "), String::new())
}

fn range(values: impl Iterator<Item = f64>) -> [f64; 2] {
    values.fold([f64::INFINITY, f64::NEG_INFINITY], |[l, h], v| {
        [l.min(v), h.max(v)]
    })
}

fn is_wide([low, high]: [f64; 2]) -> bool {
    low > 0.0 && high >= LOG_FROM * low
}

#[cfg(test)]
mod tests {
    use super::words;

    #[test]
    fn columns_in_words() {
        for (title, name, unit) in [
            (
                "motion.entrainment_speed_m_per_s",
                "entrainment speed",
                "m/s",
            ),
            ("contact.load_N", "load", "N"),
            ("contact.load_N_per_m", "load", "N/m"),
            ("motion.slide_to_roll_ratio", "slide to roll ratio", ""),
            ("lubricant.name", "name", ""),
        ] {
            assert_eq!(words(title), (name.to_owned(), unit.to_owned()));
        }
    }
}
