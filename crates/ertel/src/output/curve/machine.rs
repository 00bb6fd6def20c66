//! Figures of whole machines and transient runs over the quantity of a curve.

use super::super::machine::{DRAWN, DRAWN_IN_TIME, Drawn};
use super::super::pictures::{ERROR_BARS, Picture};
use super::frame::{curve_chart, fit_y, largest, points_over};
use crate::solution::Estimate;
use crate::study::{CurveSolution, PointSolution};
use ertel_plot::{Chart, ErrorBars, PALETTE, Series, Side};

/// One picture per kind of figure that the machines or the transient runs have.
pub(super) fn pictures(title: &str, curve: &CurveSolution) -> Vec<Picture> {
    let drawn: &[Drawn] = match curve.points.iter().any(|point| point.is_in_time) {
        true => &DRAWN_IN_TIME,
        false => &DRAWN,
    };
    let charts = drawn
        .iter()
        .filter_map(|drawn| Some((drawn, chart(title, curve, drawn)?)));
    charts
        .map(|(drawn, chart)| Picture::new(drawn.curve, chart.drawing()))
        .collect()
}

/// A figure of a point.
struct Shown {
    words: &'static str,
    estimate: Estimate,
}

fn figure(point: &PointSolution, name: &str) -> Option<Shown> {
    if let Some(run) = point.outcome.in_time() {
        let found = run.find(name)?;
        let (words, estimate) = (found.words, found.estimate);
        return Some(Shown { words, estimate });
    }
    let found = point.machine.as_ref()?.figures.find(name)?;
    Some(Shown {
        words: found.words,
        estimate: found.estimate.estimate(),
    })
}

/// Figures over the quantity, with their error bars; `None` if no point has one.
fn chart(title: &str, curve: &CurveSolution, drawn: &Drawn) -> Option<Chart> {
    let figures = drawn.figures.iter().flat_map(|name| {
        let of = curve.points.iter().filter_map(|point| figure(point, name));
        of.map(|figure| figure.estimate.value.abs())
    });
    let size = largest(figures);
    let ([factor, summand], label) = drawn.scale(size);
    let mut chart = curve_chart(title, curve, &label);
    for (i, name) in drawn.figures.iter().enumerate() {
        let mut of = curve.points.iter().filter_map(|point| figure(point, name));
        let Some(words) = of.next().map(|figure| figure.words) else {
            continue;
        };
        let over = |of: &dyn Fn(&Shown) -> Option<f64>| {
            points_over(curve, |p| Some(factor * of(&figure(p, name)?)? + summand))
        };
        let ends = |sign: f64| over(&|f| Some(f.estimate.value + sign * f.estimate.error?));
        let bars: Vec<[f64; 3]> = (ends(-1.0).into_iter().zip(ends(1.0)))
            .map(|([x, low], [_, high])| [x, low, high])
            .filter(|bar| bar.iter().all(|v| v.is_finite()))
            .collect();
        let look = drawn.look(chart.series.len(), !bars.is_empty());
        chart.error_bars.push(ErrorBars {
            bars,
            colour: PALETTE[i].to_owned(),
        });
        chart.series.push(Series {
            label: words.to_owned(),
            points: over(&|f| Some(f.estimate.value)),
            look,
            colour: PALETTE[i].to_owned(),
            side: Side::Left,
        });
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
