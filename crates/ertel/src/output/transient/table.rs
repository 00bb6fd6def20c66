//! `transient.csv` and `profiles.csv`.

use std::fmt::Write;

use crate::run::transient::{InstantSolution, TransientSolution};
use crate::solution::Figure;
use crate::study::titled;

/// A row for each instant: time, conditions, every figure of the registry with its error bar, the amplitude ratio of waves, and step statistics.
pub fn transient_table(found: &TransientSolution, is_line: bool) -> String {
    let shown = figures(found);
    let load_unit = if is_line { "N/m" } else { "N" };
    let mut titles = vec![
        "instant".to_owned(),
        "time_s".to_owned(),
        "entrainment_speed_m_per_s".to_owned(),
        "body_1_speed_m_per_s".to_owned(),
        "body_2_speed_m_per_s".to_owned(),
        "body_1_spin_rad_per_s".to_owned(),
        "body_2_spin_rad_per_s".to_owned(),
        titled("load", load_unit),
        "radius_m".to_owned(),
        "temperature_K".to_owned(),
        "oil_layer_m".to_owned(),
        "approach_m".to_owned(),
        "approach_velocity_m_per_s".to_owned(),
        titled("film_force", load_unit),
    ];
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
        let [first, second] = instant.speeds;
        let [spin_1, spin_2] = instant.spin;
        let _ = write!(
            text,
            "{},{:e},{:e},{first:e},{second:e},{spin_1:e},{spin_2:e},{:e},{:e},{:e},{},{:e},{:e},{:e}",
            i + 1,
            instant.time,
            0.5 * (first + second),
            instant.load,
            instant.radius,
            instant.temperature,
            (instant.oil_layer).map_or_else(String::new, |layer| format!("{layer:e}")),
            instant.approach,
            instant.approach_velocity,
            instant.film_force
        );
        for figure in &shown {
            let measured = &instant.measured;
            for value in [
                measured.figures.value(*figure),
                measured.bars.get(*figure).map(|bar| bar.value),
            ] {
                text.push(',');
                if let Some(value) = value {
                    let _ = write!(text, "{value:e}");
                }
            }
        }
        if has_ratios {
            text.push(',');
            if let Some(ratio) = found.amplitude_ratios[i] {
                let _ = write!(text, "{ratio:e}");
            }
        }
        let _ = writeln!(
            text,
            ",{:e},{},{:e},{}",
            instant.step,
            instant.newton_iterations,
            instant.mass_error,
            unresolved(instant).join(" ")
        );
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
