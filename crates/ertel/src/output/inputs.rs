//! Sensitivities to the inputs, in the report.

use super::lines::{Lines, Table};
use crate::solution::{
    Figure, FigureSensitivity, FigureUncertainty, Kind, Sensitivities, SensitivityMethod, Solution,
};
use crate::words::digits;

/// Widths of the columns of keys and numbers.
const KEY_WIDTH: usize = 44;
const NUMBER_WIDTH: usize = 11;

/// Effects below this, in per cent of a figure per per cent of an input, are only named.
const NEGLIGIBLE: f64 = 1e-3;

/// Shares of an uncertainty below this are not listed separately.
const NEGLIGIBLE_SHARE: f64 = 0.01;

/// Half-width of an interval, relative to the figure, above which first-order results are unreliable.
const FAR_FROM_LINEAR: f64 = 0.2;

/// Sensitivities, the largest for the films first, and the resulting uncertainty from the inputs.
pub(super) fn write(out: &mut Lines, solution: &Solution) {
    write_uncertainty(out, solution);
    let Some(sensitivities) = &solution.sensitivities else {
        if solution.thermal.is_some() {
            out.heading("Sensitivities: not computed for thermal cases unless [output] sensitivities = true");
        }
        return;
    };
    out.heading("Sensitivities: per cent of the figure for one per cent of the input, for one kelvin of a temperature");
    // A traction of zero has no percentage, and that of an unresolved figure is meaningless; figures without a symbol are in result.json.
    let figures: Vec<&FigureSensitivity> = sensitivities
        .figures
        .iter()
        .filter(|f| f.value != 0.0 && !f.figure.symbol().is_empty())
        .filter(|f| {
            solution.resolves(f.figure) && solution.figure(f.figure).is_none_or(|at| at.resolved)
        })
        .collect();
    if figures.is_empty() {
        out.line("not computed: the mesh resolves none of the figures");
        return;
    }
    let mut head = vec![String::new()];
    let title = |figure: Figure| match figure.kind() {
        Kind::Temperature => format!("{} (K)", figure.symbol()),
        _ => figure.symbol().to_owned(),
    };
    head.extend(figures.iter().map(|f| title(f.figure)));
    let (rows, negligible) = rows(sensitivities, &figures);
    let longest = rows.iter().map(|(key, _)| key.len() + 1).max();
    let mut widths = vec![(NUMBER_WIDTH, 0); head.len()];
    widths[0] = (KEY_WIDTH.max(longest.unwrap_or(0)), 0);
    let cells = |(key, by): (&str, Vec<f64>)| {
        let by = by.into_iter().map(signed);
        std::iter::once(key.to_owned()).chain(by).collect()
    };
    out.table(Table {
        head,
        rows: rows.into_iter().map(cells).collect(),
        widths,
    });
    if !negligible.is_empty() {
        out.line(&format!("below {NEGLIGIBLE}: {}", negligible.join(", ")));
    }
    for (reason, keys) in left_out(sensitivities) {
        out.line(&format!("not computed: {} ({reason})", keys.join(", ")));
    }
    let missing: Vec<&str> = Figure::TRACED
        .into_iter()
        .filter(|figure| !solution.resolves(*figure))
        .map(Figure::symbol)
        .collect();
    if !missing.is_empty() {
        out.line(&format!(
            "not computed for unresolved figures: {}",
            missing.join(", ")
        ));
    }
    match sensitivities.by {
        SensitivityMethod::LinearSolves => {
            out.line(
                "from linear solves on coarser grids; accurate to a few per cent of the largest",
            );
        }
        SensitivityMethod::Differences => {
            out.line("from differences of solves on one mesh; accurate to about one per cent");
        }
    }
}

/// Keys with their effects, the largest effect on a film first, and the keys without effects.
fn rows<'a>(
    sensitivities: &'a Sensitivities,
    figures: &[&FigureSensitivity],
) -> (Vec<(&'a str, Vec<f64>)>, Vec<&'a str>) {
    let all = (sensitivities.inputs.iter().enumerate())
        .filter(|(_, input)| input.value != 0.0)
        .map(|(i, input)| {
            // Per cent per per cent, or per kelvin; kelvins for the largest temperature.
            let step = match input.is_temperature() {
                true => 100.0,
                false => input.value,
            };
            let of = |f: &&FigureSensitivity| match f.figure.kind() {
                Kind::Temperature => 0.01 * step * f.derivatives[i],
                _ => f.derivatives[i] * step / f.value,
            };
            (
                input.key.as_str(),
                figures.iter().map(of).collect::<Vec<f64>>(),
            )
        });
    let (mut rows, negligible): (Vec<_>, Vec<_>) =
        all.partition(|(_, by)| by.iter().any(|by| by.abs() >= NEGLIGIBLE));
    let on_films = |by: &[f64]| by.iter().take(2).fold(0.0_f64, |m, by| m.max(by.abs()));
    rows.sort_by(|a, b| on_films(&b.1).total_cmp(&on_films(&a.1)));
    let keys = negligible.into_iter().map(|(key, _)| key).collect();
    (rows, keys)
}

/// Omitted inputs, grouped by reason.
fn left_out(sensitivities: &Sensitivities) -> Vec<(&str, Vec<&str>)> {
    let mut reasons: Vec<(&str, Vec<&str>)> = Vec::new();
    for input in &sensitivities.left_out {
        match reasons
            .iter_mut()
            .find(|(reason, _)| *reason == input.reason)
        {
            Some((_, keys)) => keys.push(&input.key),
            None => reasons.push((&input.reason, vec![&input.key])),
        }
    }
    reasons
}

/// The symbol of a figure, or its words.
fn short(figure: Figure) -> &'static str {
    match figure.symbol() {
        "" => figure.words(),
        symbol => symbol,
    }
}

fn write_uncertainty(out: &mut Lines, solution: &Solution) {
    let Some(uncertainty) = &solution.uncertainty else {
        return;
    };
    out.heading("Uncertainty of the inputs, to first order (95 % intervals)");
    for figure in &uncertainty.0 {
        let shares: Vec<String> = (figure.shares.iter())
            .filter(|(_, share)| share.abs() >= NEGLIGIBLE_SHARE)
            .map(|(key, share)| format!("{key} {:.0} %", 100.0 * share))
            .collect();
        let size = match (figure.figure.kind(), figure.value) {
            // A percentage of a temperature is meaningless.
            (Kind::Temperature, _) => {
                format!("{} K", digits(figure.half_width, 2))
            }
            (_, 0.0) => digits(figure.half_width, 2),
            (_, value) => format!(
                "{} % of it",
                digits(100.0 * figure.half_width / value.abs(), 2)
            ),
        };
        out.row(
            short(figure.figure),
            format!("± {size:<14} {}", shares.join(", ")),
        );
    }
    let wide = |u: &&FigureUncertainty| u.half_width > FAR_FROM_LINEAR * u.value.abs();
    let far: Vec<&str> = uncertainty
        .0
        .iter()
        .filter(wide)
        .map(|u| short(u.figure))
        .collect();
    if !far.is_empty() {
        out.line(&format!(
            "{}: too wide for the first order; --monte-carlo N samples the inputs instead",
            far.join(", ")
        ));
    }
}

/// With sign, to three decimals.
fn signed(value: f64) -> String {
    if value.abs() < 0.5 * NEGLIGIBLE {
        return "0".to_owned();
    }
    format!("{value:+.3}")
}

#[cfg(test)]
mod tests {
    use super::super::sample;
    use super::*;
    use crate::solution::{Bar, Reading};

    /// A traction of unknown sign has no percentage: it would be in the millions. A resolved one has.
    #[test]
    fn only_resolved_figures_have_sensitivities() {
        let (_, solution) = sample::line();
        for (error, is_shown) in [(1e-5, true), (1.0, false)] {
            let mut solution = solution.clone();
            let measured = &mut solution.measured;
            measured
                .figures
                .set(Figure::TractionCoefficient, Reading::new(1e-3));
            let bar = Bar {
                value: error,
                place: None,
            };
            measured.bars.set(Figure::TractionCoefficient, bar);
            solution.traction.coefficient = measured.estimate(Figure::TractionCoefficient);
            let of = |figure: Figure| FigureSensitivity {
                figure,
                value: 1e-3,
                derivatives: Vec::new(),
            };
            solution.sensitivities = Some(Sensitivities {
                inputs: Vec::new(),
                figures: vec![of(Figure::FilmCentral), of(Figure::TractionCoefficient)],
                left_out: Vec::new(),
                by: SensitivityMethod::LinearSolves,
            });
            let mut out = Lines::default();
            write(&mut out, &solution);
            let head = out.text();
            let head = head.lines().find(|line| line.contains("h_c")).unwrap();
            assert_eq!(head.contains('µ'), is_shown, "{head}");
        }
    }
}
