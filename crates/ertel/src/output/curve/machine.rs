//! Figures of whole machines and transient runs over the quantity of a curve.

use super::super::drawn::{DRAWN, Drawn};
use super::super::pictures::{ERROR_BARS, Picture};
use super::frame::{curve_chart, fit_y, largest, points_over};
use crate::figures::Row;
use crate::study::CurveSolution;
use ertel_plot::{Chart, ErrorBars, PALETTE, Series};

/// One picture per kind of figure that the machines or the transient runs have.
pub(super) fn pictures(title: &str, curve: &CurveSolution) -> Vec<Picture> {
    let charts = DRAWN
        .iter()
        .filter_map(|drawn| Some((drawn, chart(title, curve, drawn)?)));
    charts
        .map(|(drawn, chart)| Picture::new(drawn.curve, chart.drawing()))
        .collect()
}

/// Figures over the quantity, with their error bars; `None` if no point has one.
fn chart(title: &str, curve: &CurveSolution, drawn: &Drawn) -> Option<Chart> {
    let rows = |name: &'static str| curve.points.iter().filter_map(move |point| point.row(name));
    let figures = drawn.figures.iter().flat_map(|figure| rows(figure.name));
    let size = largest(figures.map(|row| row.estimate.value.abs()));
    let ([factor, summand], label) = drawn.scale(size);
    let mut chart = curve_chart(title, curve, &label);
    for (i, name) in drawn.figures.iter().map(|figure| figure.name).enumerate() {
        let Some(first) = rows(name).next() else {
            continue;
        };
        let over = |of: &dyn Fn(&Row) -> Option<f64>| {
            points_over(curve, |p| Some(factor * of(p.row(name)?)? + summand))
        };
        let ends = |sign: f64| over(&|row| Some(row.estimate.value + sign * row.estimate.error?));
        let bars: Vec<[f64; 3]> = (ends(-1.0).into_iter().zip(ends(1.0)))
            .map(|([x, low], [_, high])| [x, low, high])
            .filter(|bar| bar.iter().all(|v| v.is_finite()))
            .collect();
        let look = drawn.look(chart.series.len(), !bars.is_empty());
        chart.error_bars.push(ErrorBars {
            bars,
            colour: PALETTE[i].to_owned(),
        });
        chart.series.push(Series::new(
            first.figure.words,
            over(&|row| Some(row.estimate.value)),
            look,
            PALETTE[i],
        ));
    }
    if chart.series.is_empty() {
        return None;
    }
    if chart.error_bars.iter().any(|of| !of.bars.is_empty()) {
        chart.error_label = ERROR_BARS.to_owned();
    }
    fit_y(&mut chart);
    Some(chart)
}
