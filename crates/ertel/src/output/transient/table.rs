//! `transient.csv` and `profiles.csv`.

use std::fmt::Write;

use super::conditions::CONDITIONS;
use crate::run::transient::{InstantSolution, TransientSolution};
use crate::solution::Figure;
use crate::study::titled;

/// Words for A_d/A_i.
pub(super) const AMPLITUDE_RATIO: &str = "amplitude ratio of the waves";

/// A row for each instant: time, conditions, every figure of the registry with its error bar, the amplitude ratio of waves, and step statistics.
pub fn transient_table(found: &TransientSolution, is_line: bool) -> String {
    let shown = figures(found);
    let mut titles = vec!["instant".to_owned(), "time_s".to_owned()];
    titles.extend(
        CONDITIONS
            .iter()
            .map(|of| titled(of.name, of.unit(is_line))),
    );
    for figure in &shown {
        let (name, unit) = (figure.name(), figure.unit(is_line));
        titles.push(titled(name, unit));
        titles.push(titled(&format!("{name}_error"), unit));
    }
    let has_ratios = !found.amplitude_ratios.is_empty();
    if has_ratios {
        titles.push("amplitude_ratio".to_owned());
    }
    titles.extend(["step_s", "newton_iterations", "mass_error", "unresolved"].map(String::from));
    let mut text = titles.join(",") + "\n";
    for (i, instant) in found.instants.iter().enumerate() {
        let number = |value: Option<f64>| value.map_or_else(String::new, |v| format!("{v:e}"));
        let mut cells = vec![(i + 1).to_string(), number(Some(instant.time))];
        cells.extend(CONDITIONS.iter().map(|of| number((of.value)(instant))));
        for figure in &shown {
            let measured = &instant.measured;
            let bar = measured.bars.get(*figure);
            cells.push(number(measured.figures.value(*figure)));
            cells.push(number(bar.map(|bar| bar.value)));
        }
        if has_ratios {
            cells.push(number(found.amplitude_ratios[i]));
        }
        cells.extend([
            number(Some(instant.step)),
            instant.newton_iterations.to_string(),
            number(Some(instant.mass_error)),
            unresolved(instant).join(" "),
        ]);
        text += &(cells.join(",") + "\n");
    }
    text
}

/// Figures that some instant has.
pub(super) fn figures(found: &TransientSolution) -> Vec<Figure> {
    let is_there = |figure: &Figure| {
        (found.instants.iter()).any(|instant| instant.measured.figures.value(*figure).is_some())
    };
    Figure::ALL.into_iter().filter(is_there).collect()
}

/// Names of the figures whose error bars are too wide.
pub(super) fn unresolved(instant: &InstantSolution) -> Vec<&'static str> {
    let measured = &instant.measured;
    (Figure::ALL.into_iter())
        .filter(|figure| {
            measured.figures.value(*figure).is_some() && !measured.is_resolved(*figure)
        })
        .map(Figure::name)
        .collect()
}

/// The centrelines at the output times, one below the other.
pub fn profiles_table(found: &TransientSolution) -> String {
    let mut text = "time_s,x_m,pressure_Pa,film_thickness_m\n".to_owned();
    for profile in &found.profiles {
        let fields = profile.pressure.iter().zip(&profile.film);
        for (x, (pressure, film)) in profile.x.iter().zip(fields) {
            let _ = writeln!(text, "{:e},{x:e},{pressure:e},{film:e}", profile.time);
        }
    }
    text
}
