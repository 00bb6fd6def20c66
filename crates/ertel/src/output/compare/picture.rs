//! `comparison.svg`: measured points with their error bars over the computed curve.

use std::collections::HashSet;

use super::super::pictures::{LEGEND_GREY, is_wide, legend_entry};
use super::super::study::words;
use super::report::unit_of;
use super::settings::{n_apart, settings};
use crate::case::study::AxisValue;
use crate::compare::{ComparedRow, Comparison, Measurand};
use crate::words::{CELSIUS, digits};
use ertel_plot::{Axis, AxisScale, Chart, Drawing, ErrorBars, Look, PALETTE, Series, side_by_side};

/// Margin of a logarithmic axis around the points.
const ROOM: f64 = 1.1;

/// Films in one diagram, traction and machine figures in others, over the column with the most settings. Each setting of the other
/// columns has a colour. `None` without a numeric column.
pub fn comparison_picture(comparison: &Comparison) -> Option<Drawing> {
    let layout = Layout::new(comparison)?;
    let (films, others): (Vec<Measurand>, Vec<Measurand>) =
        comparison.figures().partition(|f| f.is_film());
    let others = others.into_iter().map(|figure| vec![figure]);
    let charts: Vec<Chart> = (std::iter::once(films).chain(others))
        .filter(|figures| !figures.is_empty())
        .map(|figures| layout.chart(comparison, &figures))
        .collect();
    Some(side_by_side(&comparison.title, &charts, 2))
}

/// The lower axis and the grouping of the rows.
struct Layout {
    /// Column of the lower axis.
    x: usize,
    /// Number of each row's setting in the other columns.
    group: Vec<usize>,
    /// Label of each setting.
    labels: Vec<String>,
}

impl Layout {
    fn new(comparison: &Comparison) -> Option<Self> {
        let settings: Vec<Vec<usize>> = (0..comparison.columns.len())
            .map(|c| settings(comparison, c))
            .collect();
        let count = |c: usize| settings[c].iter().collect::<HashSet<_>>().len();
        let n_apart = |c: usize| n_apart(comparison, c);
        let numbers = (0..settings.len()).filter(|c| comparison.dimensions[*c].is_some());
        // Ties: the first column.
        let x = numbers.rev().max_by_key(|c| n_apart(*c))?;
        let others: Vec<usize> = (0..settings.len())
            .filter(|c| *c != x && count(*c) > 1)
            .collect();
        let mut keys: Vec<Vec<usize>> = Vec::new();
        let mut labels = Vec::new();
        let mut group = Vec::new();
        for (i, row) in comparison.rows.iter().enumerate() {
            let key: Vec<usize> = others.iter().map(|c| settings[*c][i]).collect();
            let place = keys
                .iter()
                .position(|own| *own == key)
                .unwrap_or(keys.len());
            if place == keys.len() {
                keys.push(key);
                labels.push(label(comparison, row, &others));
            }
            group.push(place);
        }
        Some(Self { x, group, labels })
    }

    fn chart(&self, comparison: &Comparison, figures: &[Measurand]) -> Chart {
        let rows = || comparison.rows.iter().zip(&self.group);
        let (factor, unit) = unit_of(comparison, figures[0]);
        let mut name = figures[0].words().to_owned();
        if let Some(first) = name.get_mut(..1) {
            first.make_ascii_uppercase();
        }
        let y_label = match (figures[0].is_film(), unit) {
            (true, unit) => format!("Film thickness *h* ({unit})"),
            (false, "") => name,
            (false, unit) => format!("{name} ({unit})"),
        };
        let (x_label, shown) = self.x_unit(comparison);
        let x_of = |row: &ComparedRow| row.values[self.x].number().map_or(f64::NAN, shown);
        let xs = || comparison.rows.iter().map(x_of);
        let x_axis = match is_wide(xs()) {
            true => Axis::log_close_around(&x_label, xs().flat_map(|x| [x / ROOM, x * ROOM])),
            false => Axis::linear_around(&x_label, xs()),
        };
        let mut chart = Chart::new(&comparison.title, x_axis, Axis::linear(&y_label, 0.0, 1.0));
        let is_crowded = self.labels.len() * figures.len() > PALETTE.len();
        let n_groups = if is_crowded { 1 } else { self.labels.len() };
        for (i, figure) in figures.iter().enumerate() {
            for group in 0..n_groups {
                let own = rows().filter(|(_, own)| is_crowded || **own == group);
                let own: Vec<&ComparedRow> = own.map(|(row, _)| row).collect();
                let colour = match is_crowded {
                    true => LEGEND_GREY,
                    false => PALETTE[group * figures.len() + i],
                };
                let label = match (is_crowded, self.labels[group].as_str()) {
                    (false, label) if !label.is_empty() && figures.len() > 1 => {
                        format!("{}, {label}", figure.words())
                    }
                    (false, label) if !label.is_empty() => label.to_owned(),
                    _ => figure.words().to_owned(),
                };
                self.draw(
                    &mut chart,
                    &own,
                    *figure,
                    (factor, &x_of),
                    (colour, &label),
                    is_crowded,
                );
            }
        }
        let computed = match is_crowded {
            true => Look::Crosses,
            false => Look::LineAndDots,
        };
        if let [of_points, of_rows] = &mut chart.series[..] {
            // A single curve needs no separate colour in the legend.
            for (series, what) in [(of_rows, "measured"), (of_points, "computed")] {
                series.label = format!("{}, {what}", figures[0].words());
            }
        } else {
            chart.series.push(legend_entry(Look::Circles, "measured"));
            chart.series.push(legend_entry(computed, "computed"));
        }
        chart.error_label = "uncertainty of the measurement".to_owned();
        chart.y = y_axis(&chart, &y_label);
        chart
    }

    /// Adds the measured and the computed points of a figure.
    fn draw(
        &self,
        chart: &mut Chart,
        rows: &[&ComparedRow],
        figure: Measurand,
        (factor, x_of): (f64, &dyn Fn(&ComparedRow) -> f64),
        (colour, label): (&str, &str),
        is_crowded: bool,
    ) {
        let compared = || {
            rows.iter()
                .filter_map(|row| Some((x_of(row), row.figures[figure as usize]?)))
        };
        let mut computed: Vec<[f64; 2]> = compared()
            .filter_map(|(x, c)| Some([x, factor * c.computed?.value.abs()]))
            .collect();
        computed.sort_by(|a, b| a[0].total_cmp(&b[0]));
        chart.series.push(Series::new(
            label,
            computed,
            if is_crowded {
                Look::Crosses
            } else {
                Look::LineAndDots
            },
            colour,
        ));
        chart.series.push(Series::new(
            "",
            compared()
                .map(|(x, c)| [x, factor * c.measured.value.abs()])
                .collect(),
            Look::Circles,
            colour,
        ));
        let bars = compared().filter_map(|(x, c)| {
            let (value, u) = (
                factor * c.measured.value.abs(),
                factor * c.measured.uncertainty?,
            );
            Some([x, value - u, value + u])
        });
        chart.error_bars.push(ErrorBars {
            bars: bars.collect(),
            colour: colour.to_owned(),
        });
    }

    /// Label of the lower axis and its display unit.
    fn x_unit(&self, comparison: &Comparison) -> (String, fn(f64) -> f64) {
        let (mut name, unit) = words(&comparison.columns[self.x]);
        if let Some(first) = name.get_mut(..1) {
            first.make_ascii_uppercase();
        }
        let name = name.replace("Slide to roll ratio", "Slide-to-roll ratio");
        match unit.as_str() {
            "K" => (format!("{name} (°C)"), |v| v - CELSIUS),
            "" => (name, |v| v),
            unit => (format!("{name} ({unit})"), |v| v),
        }
    }
}

/// The left axis. It is logarithmic if the lower axis is, because power laws are then straight lines.
fn y_axis(chart: &Chart, label: &str) -> Axis {
    let points = chart.series.iter().flat_map(|s| &s.points).map(|p| p[1]);
    let bars = chart.error_bars.iter().flat_map(|b| &b.bars);
    let ends = bars.flat_map(|[_, low, high]| [*low, *high]);
    let heights: Vec<f64> = points.collect();
    if chart.x.scale == AxisScale::Log && is_wide(heights.iter().copied()) {
        let all = heights.into_iter().chain(ends.filter(|end| *end > 0.0));
        return Axis::log_close_around(label, all);
    }
    let all = heights.into_iter().chain(ends).chain([0.0]);
    let (low, high) = all.fold((0.0, 0.0), |(l, h): (f64, f64), v| (l.min(v), h.max(v)));
    Axis::linear_around(label, [low, high])
}

/// `load 20 N, temperature 40 °C`.
fn label(comparison: &Comparison, row: &ComparedRow, columns: &[usize]) -> String {
    let words = columns.iter().map(|c| {
        let (name, unit) = words(&comparison.columns[*c]);
        match (&row.values[*c], unit.as_str()) {
            (AxisValue::Number(value, _), "K") => format!("{} °C", digits(value - CELSIUS, 3)),
            (AxisValue::Number(value, _), "") => format!("{name} {}", digits(*value, 2)),
            (AxisValue::Number(value, _), unit) => format!("{} {unit}", digits(*value, 3)),
            (AxisValue::Text(text), _) => text.replace(['{', '}', '*'], ""),
        }
    });
    words.collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use ertel_quantity::Dimension;

    use super::*;
    use crate::compare::{N_MEASURANDS, Outcome};

    fn comparison(columns: &[(&str, Dimension)], rows: &[&[f64]]) -> Comparison {
        let row = |values: &&[f64]| ComparedRow {
            line: 1,
            point: 0,
            values: (values.iter().zip(columns))
                .map(|(value, (_, dimension))| AxisValue::Number(*value, *dimension))
                .collect(),
            outcome: Outcome::Open,
            figures: [None; N_MEASURANDS],
        };
        Comparison {
            title: String::new(),
            columns: columns
                .iter()
                .map(|(title, _)| (*title).to_owned())
                .collect(),
            dimensions: columns
                .iter()
                .map(|(_, dimension)| Some(*dimension))
                .collect(),
            rows: rows.iter().map(row).collect(),
            n_points: 1,
            notes: Vec::new(),
        }
    }

    const COLUMNS: [(&str, Dimension); 4] = [
        ("motion.entrainment_speed_m_per_s", Dimension::SPEED),
        ("motion.slide_to_roll_ratio", Dimension::DIMENSIONLESS),
        ("contact.load_N", Dimension::FORCE),
        ("temperature_K", Dimension::TEMPERATURE),
    ];

    /// A speed ramp at two loads with the scatter of a test rig.
    #[test]
    fn the_scatter_of_a_rig_makes_no_curves() {
        let rows: [&[f64]; 6] = [
            &[0.1, -0.004, 19.9, 313.1],
            &[0.2, 0.001, 20.1, 314.0],
            &[0.4, 0.0, 20.0, 312.9],
            &[0.1, 0.0, 50.1, 313.0],
            &[0.2, 0.003, 49.9, 313.4],
            &[0.4, 0.0, 50.0, 313.2],
        ];
        let layout = Layout::new(&comparison(&COLUMNS, &rows)).unwrap();
        assert_eq!(layout.x, 0);
        assert_eq!(layout.group, [0, 0, 0, 1, 1, 1]);
        assert_eq!(layout.labels, ["19.9 N", "50.1 N"]);
    }

    #[test]
    fn a_fine_ramp_is_the_lower_axis() {
        let ramp: Vec<[f64; 4]> = (0..20)
            .map(|i| [1.0, 0.005 * f64::from(i), 20.0, 313.0])
            .collect();
        let rows: Vec<&[f64]> = ramp.iter().map(|row| &row[..]).collect();
        let layout = Layout::new(&comparison(&COLUMNS, &rows)).unwrap();
        assert_eq!(layout.x, 1);
        assert_eq!(layout.labels, [""]);
    }
}
