//! The picture of a fit.

use super::{FilmFit, Films};
use ertel_plot::{Axis, Chart, Look, PALETTE, Series};

/// Films by the formula over the films given.
pub fn parity(fits: &[(FilmFit, Films)], title: &str) -> Chart {
    let all: Vec<f64> = fits
        .iter()
        .flat_map(|(_, films)| films.states.iter().map(|s| 1e9 * s.film))
        .collect();
    let x = Axis::log_close_around("Film thickness *h* given (nm)", all.clone());
    let mut y = Axis::log_close_around("by the formula (nm)", all);
    (y.low, y.high) = (x.low, x.high);
    let mut chart = Chart::new(title, x, y);
    let (low, high) = (chart.x.low, chart.x.high);
    for (label, factor, look) in [
        ("equal", 1.0, Look::Line),
        ("±5 %", 1.05, Look::Dashed),
        ("", 0.95, Look::Dashed),
    ] {
        chart.series.push(Series::new(
            label,
            vec![[low, factor * low], [high, factor * high]],
            look,
            "#7f7f7f",
        ));
    }
    for (i, (fit, films)) in fits.iter().enumerate() {
        chart.series.push(Series::new(
            format!("{} film", fit.kind.name()),
            films
                .states
                .iter()
                .zip(&fit.deviations)
                .map(|(s, d)| [1e9 * s.film, 1e9 * s.film * (1.0 + d)])
                .collect(),
            Look::Circles,
            PALETTE[i % PALETTE.len()],
        ));
    }
    chart
}
