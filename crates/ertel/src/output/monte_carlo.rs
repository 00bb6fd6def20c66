//! Statistics of sampled inputs: a file, a picture and a table for the terminal.

use std::f64::consts::PI;
use std::path::Path;

use serde_json::{Value, json};

use super::figure::{axis_name, unit_of_size};
use super::lines::Lines;
use super::pictures::film_unit;
use super::result_json::FORMAT_VERSION;
use super::rows::REPORTED;
use super::{OutputError, replace_picture};
use crate::files::write_whole;
use crate::params::PictureFormats;
use crate::solution::{FigureUncertainty, Kind, Uncertainties};
use crate::study::monte_carlo::{Distribution, MonteCarlo, QUANTILES, Sampled};
use crate::words::digits;
use ertel_plot::{Axis, Chart, Drawing, Look, PALETTE, Series, side_by_side};

/// Name of the statistics file next to the table of the samples.
pub const MONTE_CARLO: &str = "monte-carlo.json";
/// Value of the key `format`.
const MONTE_CARLO_FORMAT: &str = "ertel-monte-carlo";
/// Name of the picture next to it, without suffix.
const PICTURE: &str = "monte-carlo";

/// Writes statistics and picture into the folder of the study, the picture in the formats `pictures`. First-order uncertainties
/// are included if available.
///
/// # Errors
/// Files that cannot be written.
pub fn write_monte_carlo(
    found: &MonteCarlo,
    first_order: Option<&Uncertainties>,
    folder: &Path,
    pictures: PictureFormats,
) -> Result<(), OutputError> {
    let document = json(found, first_order);
    let failed = |path: &Path, source: std::io::Error| OutputError::Io {
        path: path.to_owned(),
        source,
    };
    let text = serde_json::to_string_pretty(&document)
        .map_err(|e| failed(&folder.join(MONTE_CARLO), e.into()))?;
    let path = folder.join(MONTE_CARLO);
    write_whole(&path, text.as_bytes()).map_err(|e| failed(&path, e))?;
    replace_picture(
        folder,
        PICTURE,
        Some(&picture(found, first_order)),
        pictures,
        PictureFormats::default(),
    )
}

fn json(found: &MonteCarlo, first_order: Option<&Uncertainties>) -> Value {
    let mut figures = serde_json::Map::new();
    for figure in &found.figures {
        let quantiles: serde_json::Map<String, Value> = (QUANTILES.iter().zip(figure.quantiles))
            .map(|(p, value)| (p.to_string(), value.into()))
            .collect();
        let correlations: serde_json::Map<String, Value> =
            (found.inputs.iter().zip(&figure.correlations))
                .map(|(key, value)| (key.clone(), (*value).into()))
                .collect();
        figures.insert(
            figure.figure.name().to_owned(),
            json!({
                "mean": figure.mean,
                "standard": figure.standard,
                "standard_error": figure.standard_error,
                "standard_of_first_order": standard(figure, first_order),
                "quantiles": quantiles,
                "correlations": correlations,
            }),
        );
    }
    json!({
        "format": MONTE_CARLO_FORMAT,
        "format_version": FORMAT_VERSION,
        "ertel_version": env!("CARGO_PKG_VERSION"),
        "samples": found.n,
        "solved": found.n_solved,
        "figures": figures,
    })
}

/// First-order standard deviation.
fn standard(figure: &Distribution, first_order: Option<&Uncertainties>) -> Option<f64> {
    Some(0.5 * reading(figure, first_order)?.half_width)
}

/// The figure and its first-order uncertainty; machines have none.
fn reading<'a>(
    figure: &Distribution,
    first_order: Option<&'a Uncertainties>,
) -> Option<&'a FigureUncertainty> {
    match figure.figure {
        Sampled::Contact(figure) => first_order?.get(figure),
        Sampled::Machine { .. } => None,
    }
}

/// Displayed figures: the main ones of machines; the file has all.
fn shown(found: &MonteCarlo) -> impl Iterator<Item = &Distribution> {
    let is_shown = |figure: &&Distribution| match figure.figure {
        Sampled::Contact(_) => true,
        Sampled::Machine { figure, .. } => REPORTED.iter().any(|of| of.name == figure.name),
    };
    found.figures.iter().filter(is_shown)
}

/// The table for the terminal.
pub fn monte_carlo_report(found: &MonteCarlo, first_order: Option<&Uncertainties>) -> String {
    let mut out = Lines::default();
    out.heading(&format!(
        "Uncertainty of the inputs, {} of {} samples solved (95 % intervals)",
        found.n_solved, found.n
    ));
    for figure in shown(found) {
        let (factor, unit) = unit(figure);
        let value = |v: f64| digits(factor * v, 4);
        let [low, .., high] = figure.quantiles;
        let first = standard(figure, first_order);
        let first = first.map_or(String::new(), |s| {
            format!(", to first order ± {}", digits(2.0 * factor * s, 3))
        });
        out.row(
            &title(figure),
            format!(
                "{} to {}{unit}, median {}, ± {} (two standard deviations, each ± {:.0} %){first}",
                value(low),
                value(high),
                value(figure.quantiles[2]),
                digits(2.0 * factor * figure.standard, 3),
                100.0 * figure.standard_error / figure.standard,
            ),
        );
        let mut inputs: Vec<(&String, f64)> = found
            .inputs
            .iter()
            .zip(figure.correlations.iter().copied())
            .collect();
        inputs.sort_by(|a, b| b.1.abs().total_cmp(&a.1.abs()));
        let shown: Vec<String> = (inputs.iter().take(4))
            .map(|(key, c)| format!("{key} {c:+.2}"))
            .collect();
        out.row("  correlated with", shown.join(", "));
    }
    out.text()
}

/// Description of a figure.
fn title(figure: &Distribution) -> String {
    match figure.figure {
        Sampled::Contact(figure) => figure.title(),
        Sampled::Machine { figure, .. } => figure.words.to_owned(),
    }
}

/// Factor and display unit of a figure.
fn unit(figure: &Distribution) -> (f64, String) {
    let (factor, unit) = match figure.figure {
        Sampled::Contact(of) => unit_of_size(of.kind(), figure.mean),
        Sampled::Machine { figure: of, unit } => match of.kind {
            Kind::Length => film_unit(figure.mean),
            Kind::PeakPressure | Kind::Stress => (1e-9, "GPa"),
            Kind::Moment if figure.mean < 1.0 => (1e3, "N mm"),
            _ => (1.0, unit),
        },
    };
    let space = if unit.is_empty() { "" } else { " " };
    (factor, format!("{space}{unit}"))
}

/// Frequencies of the samples, and the first-order normal distribution.
fn picture(found: &MonteCarlo, first_order: Option<&Uncertainties>) -> Drawing {
    let charts: Vec<Chart> = shown(found).map(|f| chart(f, first_order)).collect();
    side_by_side("Uncertainty of the inputs", &charts, 2)
}

fn chart(figure: &Distribution, first_order: Option<&Uncertainties>) -> Chart {
    let (factor, unit) = unit(figure);
    let name = match figure.figure {
        Sampled::Contact(figure) => axis_name(figure),
        Sampled::Machine { figure, .. } => figure.words.to_owned(),
    };
    let values: Vec<f64> = figure.values.iter().map(|v| factor * v).collect();
    let least = values.iter().copied().fold(f64::INFINITY, f64::min);
    let most = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    // Sturges' number of classes
    let n = (values.len() as f64).log2().ceil() as usize + 1;
    let width = (most - least) / n as f64;
    let mut counts = vec![0usize; n];
    for value in &values {
        counts[(((value - least) / width) as usize).min(n - 1)] += 1;
    }
    let density = |count: usize| count as f64 / (values.len() as f64 * width);
    let mut steps = vec![[least, 0.0]];
    for (i, count) in counts.iter().enumerate() {
        let (from, y) = (least + i as f64 * width, density(*count));
        steps.extend([[from, y], [from + width, y]]);
    }
    steps.push([most, 0.0]);
    let mut series = vec![Series::new(
        format!("{} samples", values.len()),
        steps,
        Look::Line,
        PALETTE[0],
    )];
    if let Some(first) = reading(figure, first_order).filter(|u| u.half_width > 0.0) {
        let (centre, standard) = (factor * first.value, 0.5 * factor * first.half_width);
        let normal = |x: f64| {
            let z = (x - centre) / standard;
            (-0.5 * z * z).exp() / (standard * (2.0 * PI).sqrt())
        };
        series.push(Series::new(
            "first order",
            (-60..=60)
                .map(|i| centre + standard * f64::from(i) / 20.0)
                .map(|x| [x, normal(x)])
                .collect(),
            Look::Dashed,
            PALETTE[1],
        ));
    }
    let all = || series.iter().flat_map(|s| &s.points);
    let low = all().map(|p| p[0]).fold(f64::INFINITY, f64::min);
    let high = all().map(|p| p[0]).fold(f64::NEG_INFINITY, f64::max);
    let tallest = all().map(|p| p[1]).fold(0.0, f64::max);
    let unit = unit.trim();
    let (label, per) = match unit {
        "" => (name.to_owned(), "Density".to_owned()),
        unit => (format!("{name} ({unit})"), format!("Density (1/{unit})")),
    };
    let mut chart = Chart::new(
        &name,
        Axis::linear_around(&label, [low, high]),
        Axis::linear_around(&per, [0.0, 1.1 * tallest]),
    );
    chart.series = series;
    chart
}
