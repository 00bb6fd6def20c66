//! `ertel fit film`.

use std::slice;

use ertel::contact::Family;
use ertel::fit::{self, FilmFit, FilmForm, FilmKind, Films};
use ertel::words::{digits, length};
use ertel_input::file::read_table;
use ertel_quantity::Dimension;

use crate::args::FitFilmArgs;
use crate::failure::Failure;
use crate::inputs;
use crate::picture;
use crate::print;
use crate::table::columns;

/// Runs the command.
///
/// # Errors
///
/// Results that cannot be read, too few of them, a picture that cannot be written.
pub fn run(arguments: &FitFilmArgs) -> Result<(), Failure> {
    if let Some(path) = &arguments.plot {
        picture::check(path)?;
        inputs::keep(slice::from_ref(&arguments.results), &[("--plot", path)])?;
        inputs::refuse_existing(&[path], arguments.force)?;
    }
    let radius = arguments
        .radius
        .as_ref()
        .map(|text| ertel_quantity::parse(text, Dimension::LENGTH))
        .transpose()?;
    if radius.is_some_and(|radius| radius <= 0.0) {
        return Err(Failure::Argument("--radius must be above zero".into()));
    }
    let file = arguments.results.display().to_string();
    let text = read_table(&arguments.results)
        .map_err(|error| Failure::Argument(format!("{file} {error}")))?;
    let given = fit::Given {
        radius,
        table: arguments.table.params(&[]),
    };
    let contact = fit::contact_of_films_with(&text, &given.table);
    let form = FilmForm::named(&arguments.form, contact)
        .map_err(|error| Failure::Argument(format!("{file}: {error}")))?;
    check_given(form, &arguments.given_formulas)?;
    let mut fits = Vec::new();
    for kind in [FilmKind::Central, FilmKind::Minimum] {
        // The asymptotes are those of the central film.
        if kind == FilmKind::Minimum && matches!(form, FilmForm::Blend(_)) {
            continue;
        }
        let films = fit::read_films_with(&file, &text, form, kind, &given)
            .map_err(|error| Failure::Argument(error.to_string()))?;
        if let Some(films) = films {
            let fit = fit::fit_film(&films, arguments.confidence)
                .map_err(|error| Failure::Argument(format!("{file}: {error}")))?;
            for warning in &fit.warnings {
                print::stderr(&format!("warning: {} film: {warning}", kind.name()));
            }
            fits.push((fit, films));
        }
    }
    if fits.is_empty() {
        let columns = match form {
            FilmForm::Blend(_) => {
                "no column `film_central_m`, which the asymptotes of the blend need"
            }
            _ => "neither a column `film_central_m` nor `film_minimum_m`",
        };
        return Err(Failure::Argument(format!("{file}: there is {columns}")));
    }
    let fitted = |kind: FilmKind| fits.iter().any(|(_, films)| films.kind == kind);
    if let Some((kind, _)) = arguments
        .given_formulas
        .iter()
        .find(|(kind, _)| !fitted(*kind))
    {
        return Err(Failure::Argument(format!(
            "--given: {file} has no {} films that the form {} is fitted to",
            kind.name(),
            arguments.form
        )));
    }
    if let Some(path) = &arguments.plot {
        picture::write(path, &fit::parity(&fits, &file).drawing())?;
    }
    let reports: Vec<String> = fits
        .iter()
        .map(|(fit, films)| {
            report(fit, films, &file, contact, arguments.verbose)
                + &deviations(films, &arguments.given_formulas)
        })
        .collect();
    print::stdout(&reports.join("\n"))
}

/// Whether formulas with given constants are of the form.
fn check_given(form: FilmForm, given: &[(FilmKind, Vec<f64>)]) -> Result<(), Failure> {
    let names = form.constants();
    for (_, constants) in given {
        let signs = form.positive();
        let mut given = constants.iter().zip(signs);
        if constants.len() != names.len() || !given.all(|(c, positive)| *c > 0.0 || !positive) {
            let positive = names.iter().zip(signs).filter(|(_, positive)| **positive);
            let positive: Vec<&str> = positive.map(|(name, _)| *name).collect();
            return Err(Failure::Argument(format!(
                "--given: write {} constants, {}, of {}; {} above zero",
                names.len(),
                names.join(", "),
                form.formula(),
                positive.join(", "),
            )));
        }
    }
    Ok(())
}

/// Deviations of formulas with given constants from the films.
fn deviations(films: &Films, formulas: &[(FilmKind, Vec<f64>)]) -> String {
    let mut text = String::new();
    let names = films.form.constants();
    for (_, constants) in formulas.iter().filter(|(kind, _)| *kind == films.kind) {
        let states = films.states.iter();
        let deviations: Vec<f64> = states
            .map(|s| films.form.film(constants, s) / s.film - 1.0)
            .collect();
        let squares = deviations.iter().map(|d| d * d).sum::<f64>();
        let range = deviations
            .iter()
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], d| {
                [low.min(*d), high.max(*d)]
            });
        let given = names.iter().zip(constants);
        let given: Vec<String> = given.map(|(name, c)| format!("{name} = {c}")).collect();
        text += &format!(
            "\n  given formula: {} deviates by {:+.2} to {:+.2} %, rms {} %\n",
            given.join(", "),
            100.0 * range[0],
            100.0 * range[1],
            digits(100.0 * (squares / deviations.len() as f64).sqrt(), 3)
        );
    }
    text
}

fn report(
    fit: &FilmFit,
    films: &Films,
    file: &str,
    contact: Option<Family>,
    verbose: bool,
) -> String {
    let number = |value: f64| digits(value, 4);
    let range = |[low, high]: [f64; 2]| format!("{} to {}", number(low), number(high));
    let percent = format!("{} % interval", digits(100.0 * fit.confidence, 4));
    let mut head = vec!["constant".to_owned(), "value".to_owned(), percent];
    if fit.widened.is_some() {
        head.push("with error bars".to_owned());
    }
    let mut constants = vec![head];
    for (i, (name, estimate)) in fit.form.constants().iter().zip(&fit.constants).enumerate() {
        let unit = if i == 0 { fit.form.unit() } else { "" };
        let with_unit = |text: String| format!("{text} {unit}").trim_end().to_owned();
        let [value, interval] = match estimate {
            Some(e) => [with_unit(number(e.value)), with_unit(range(e.interval))],
            None => ["none".to_owned(), "not determined".to_owned()],
        };
        let mut row = vec![(*name).to_owned(), value, interval];
        if let Some(Some(wide)) = fit.widened.as_ref().map(|widened| widened[i]) {
            row.push(with_unit(range(wide)));
        }
        constants.push(row);
    }
    let mut text = format!(
        "{} film of {} results in {file}, {}\n\n{}\n",
        match fit.kind {
            FilmKind::Central => "Central",
            FilmKind::Minimum => "Minimum",
        },
        films.states.len(),
        fit.form.formula(),
        columns(&constants)
    );
    let line = |name: &str, value: String| vec![name.to_owned(), value];
    let mut lines = vec![
        line(
            "deviation, rms",
            format!("{} %", digits(100.0 * fit.rms(), 3)),
        ),
        line("largest", format!("{} %", digits(100.0 * fit.largest(), 3))),
    ];
    for (variable, values) in fit.form.variables().iter().zip(&fit.ranges) {
        let values = format!("{} {}", range(*values), variable.unit);
        let name = format!("range of {}", variable.symbol);
        lines.push(line(&name, values.trim_end().to_owned()));
    }
    lines.push(line("text", fit.text()));
    lines.push(line("LaTeX", fit.latex()));
    lines.push(line("code", fit.code()));
    text += &columns(&lines);
    let other = contact.and_then(|contact| fit.hamrock_dowson(contact));
    if let Some([factor, speed, material, load]) = other {
        text += &format!(
            "\n  in the groups of Hamrock and Dowson: {} R U^{speed:.4} G^{material:.4} W^{load:.4}\n",
            digits(factor, 5)
        );
    }
    if verbose {
        let symbols = fit.form.variables().iter().map(|v| match v.unit {
            "" => v.symbol.to_owned(),
            unit => format!("{} ({unit})", v.symbol),
        });
        let ends = ["film", "formula", "deviation"].map(str::to_owned);
        let mut rows = vec![symbols.chain(ends).collect::<Vec<_>>()];
        for (state, deviation) in films.states.iter().zip(&fit.deviations) {
            let mut row: Vec<String> = state.variables.iter().map(|v| number(*v)).collect();
            row.push(length(state.film));
            row.push(length(state.film * (1.0 + deviation)));
            row.push(format!("{:+.2} %", 100.0 * deviation));
            rows.push(row);
        }
        text += &format!("\n{}", columns(&rows));
    }
    text
}
