//! `ertel fit viscosity --law all`.

use ertel::fit::{self, Property};
use ertel::words::digits;

use super::law::{finish, keep_inputs, params, plot_path, read};
use crate::args::FitLawArgs;
use crate::failure::Failure;
use crate::table::columns;

/// Name for all laws.
pub const NAME: &str = "all";

/// Ranks the laws and fits the best one.
///
/// # Errors
///
/// Constants to hold or free, which are those of one law; bad data; no law that can be ranked.
pub fn run(property: Property, arguments: &FitLawArgs) -> Result<(), Failure> {
    for (option, given) in [("--hold", &arguments.hold), ("--free", &arguments.free)] {
        if let Some(text) = given.first() {
            return Err(Failure::Argument(format!(
                "{option} {text}: constants belong to one law; name it instead of `all` in --law"
            )));
        }
    }
    let plot = plot_path(arguments)?;
    keep_inputs(arguments, plot.as_deref())?;
    let params = params(arguments, None)?;
    let data = read(arguments, property, &params, false)?;
    let ranking = fit::rank(&data, &params);
    let reasons = ranking
        .unranked
        .iter()
        .map(|u| vec![u.law.name().to_owned(), u.reason.clone()]);
    let reasons = columns(&reasons.collect::<Vec<_>>());
    let Some(best) = ranking.ranked.first() else {
        return Err(Failure::Argument(format!(
            "{}: no law can be ranked\n{}",
            data.file,
            reasons.trim_end()
        )));
    };
    let percent = |share: f64| format!("{} %", digits(100.0 * share, 3));
    let mut rows = vec![
        [
            "law",
            "rms of ln, isotherm left out",
            "worst isotherm",
            "rms of the fit to all",
        ]
        .map(str::to_owned)
        .to_vec(),
    ];
    for ranked in &ranking.ranked {
        let (temperature, rms) = ranked.worst;
        rows.push(vec![
            ranked.fit.name.name().to_owned(),
            percent(ranked.rms_left_out),
            format!("{} at {} °C", percent(rms), digits(temperature - 273.15, 4)),
            percent(ranked.fit.rms()),
        ]);
    }
    let mut text = format!(
        "Cross-validation: error on the isotherm left out ({} isotherms)\n\n{}",
        ranking.isotherms.len(),
        columns(&rows)
    );
    if !ranking.unranked.is_empty() {
        text += &format!("\nNot ranked\n{reasons}");
    }
    text.push('\n');
    finish(&best.fit, &data, arguments, plot.as_deref(), text)
}
