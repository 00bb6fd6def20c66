//! `ertel fit film`.

use ertel::contact::ContactKind;
use ertel::fit::{self, Estimate, FilmFit, FilmKind, FilmState, PowerFormula};
use ertel::output::{digits, length};
use ertel_rheology::quantity::{self, Dimension};

use super::check_svg;
use crate::args::FitFilmArgs;
use crate::failure::Failure;
use crate::file::write_whole;
use crate::print;
use crate::table::columns;

/// Runs the command.
///
/// # Errors
///
/// Results that cannot be read, too few of them, a picture that cannot be written.
pub fn run(arguments: &FitFilmArgs) -> Result<(), Failure> {
    if let Some(path) = &arguments.plot {
        check_svg(path)?;
    }
    let radius = arguments
        .radius
        .as_ref()
        .map(|text| quantity::parse(text, Dimension::LENGTH))
        .transpose()?;
    if radius.is_some_and(|radius| radius <= 0.0) {
        return Err(Failure::Argument("--radius must be above zero".into()));
    }
    let file = arguments.results.display().to_string();
    let text = std::fs::read_to_string(&arguments.results)
        .map_err(|error| Failure::Argument(format!("{file} cannot be read: {error}")))?;
    let mut fits = Vec::new();
    for kind in [FilmKind::Central, FilmKind::Minimum] {
        let states = fit::read_films(&file, &text, kind, radius)
            .map_err(|error| Failure::Argument(error.to_string()))?;
        if let Some(states) = states {
            let fit = fit::fit_film(&states, kind, arguments.confidence)
                .map_err(|error| Failure::Argument(format!("{file}: {error}")))?;
            for warning in &fit.warnings {
                eprintln!("warning: {} film: {warning}", kind.name());
            }
            fits.push((fit, states));
        }
    }
    if fits.is_empty() {
        return Err(Failure::Argument(format!(
            "{file}: there is neither a column `film_central_m` nor `film_minimum_m`"
        )));
    }
    if let Some(path) = &arguments.plot {
        let svg = fit::parity(&fits, &file).svg();
        write_whole(path, svg.as_bytes())
            .map_err(|error| Failure::Other(format!("cannot write {}: {error}", path.display())))?;
    }
    let contact = fit::contact_of_films(&text);
    let reports: Vec<String> = fits
        .iter()
        .map(|(fit, states)| {
            report(fit, states, &file, contact, arguments.verbose)
                + &beside(fit, states, &arguments.beside)
        })
        .collect();
    print::stdout(&reports.join("\n"))
}

/// How far formulas with given constants are from the films.
fn beside(fit: &FilmFit, states: &[FilmState], formulas: &[(FilmKind, PowerFormula)]) -> String {
    let mut text = String::new();
    for (_, formula) in formulas.iter().filter(|(kind, _)| *kind == fit.kind) {
        let deviations: Vec<f64> = states.iter().map(|s| formula.deviation(s)).collect();
        let squares = deviations.iter().map(|d| d * d).sum::<f64>();
        let range = deviations
            .iter()
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], d| {
                [low.min(*d), high.max(*d)]
            });
        text += &format!(
            "\n  beside: {} R √(2U) M^{} L^{} deviates by {:+.2} to {:+.2} %, rms {} %\n",
            formula.factor,
            formula.load_exponent,
            formula.material_exponent,
            100.0 * range[0],
            100.0 * range[1],
            digits(100.0 * (squares / states.len() as f64).sqrt(), 3)
        );
    }
    text
}

fn report(
    fit: &FilmFit,
    states: &[FilmState],
    file: &str,
    contact: Option<ContactKind>,
    verbose: bool,
) -> String {
    let number = |value: f64| digits(value, 4);
    let range = |[low, high]: [f64; 2]| format!("{} to {}", number(low), number(high));
    let percent = format!("{} % interval", digits(100.0 * fit.confidence, 4));
    let row = |name: &str, estimate: Option<Estimate>| {
        let [value, interval] = match estimate {
            Some(e) => [number(e.value), range(e.interval)],
            None => ["none".to_owned(), "not determined".to_owned()],
        };
        vec![name.to_owned(), value, interval]
    };
    let mut text = format!(
        "{} film of {} results in {file}, h = c R √(2U) M^a L^b\n\n{}\n",
        match fit.kind {
            FilmKind::Central => "Central",
            FilmKind::Minimum => "Minimum",
        },
        states.len(),
        columns(&[
            vec!["constant".to_owned(), "value".to_owned(), percent],
            row("c", Some(fit.factor)),
            row("a", fit.load_exponent),
            row("b", fit.material_exponent),
        ])
    );
    let line = |name: &str, value: String| vec![name.to_owned(), value];
    text += &columns(&[
        line(
            "deviation, rms",
            format!("{} %", digits(100.0 * fit.rms(), 3)),
        ),
        line("largest", format!("{} %", digits(100.0 * fit.largest(), 3))),
        line("range of M", range(fit.load_range)),
        line("range of L", range(fit.material_range)),
        line("text", fit.text()),
        line("LaTeX", fit.latex()),
        line("code", fit.code()),
    ]);
    if let Some(contact) = contact {
        let [factor, speed, material, load] = fit.hamrock_dowson(contact);
        text += &format!(
            "\n  in the groups of Hamrock and Dowson: {} R U^{speed:.4} G^{material:.4} W^{load:.4}\n",
            digits(factor, 5)
        );
    }
    if verbose {
        let mut rows = vec![
            ["M", "L", "film", "formula", "deviation"]
                .map(str::to_owned)
                .to_vec(),
        ];
        for (state, deviation) in states.iter().zip(&fit.deviations) {
            rows.push(vec![
                number(state.load),
                number(state.material),
                length(state.film),
                length(state.film * (1.0 + deviation)),
                format!("{:+.2} %", 100.0 * deviation),
            ]);
        }
        text += &format!("\n{}", columns(&rows));
    }
    text
}
