//! Films too thin for what is computed: roughness and molecules.

use serde::Serialize;

use crate::warning::{Warning, WarningKind};

/// Film that keeps the surfaces of the best rolling bearings apart, m (Habchi 2008, section 6.2).
pub const SAFE_FILM: f64 = 10e-9;

/// Ten layers of molecules of 0.5 nm, m, down to which a liquid is a continuum (Habchi 2008, section 6.2).
pub const CONTINUUM_FILM: f64 = 5e-9;

/// Film of one or two molecules, m.
const MOLECULES: f64 = 1e-9;

/// Says so if the film thickness, m, is below 10 nm, below ten molecular layers, or below a nanometre. `film` names it,
/// such as "the minimum film thickness".
pub fn thin_film_warning(film: &str, thickness: f64) -> Option<Warning> {
    let nm = thickness * 1e9;
    let text = if thickness < MOLECULES {
        format!("{film}, {nm:.2} nm, is below a nanometre: no continuum film exists there")
    } else if thickness < CONTINUUM_FILM {
        format!(
            "{film}, {nm:.2} nm, is below 5 nm, 10 layers of molecules of 0.5 nm: the laws of a continuum do not \
             hold there, and the asperities of the smoothest surfaces touch"
        )
    } else if thickness < SAFE_FILM {
        format!(
            "{film}, {nm:.2} nm, is below 10 nm: even the smoothest bearing surfaces may touch, and the laws of a \
             continuum are doubtful where molecules are large (10 layers of 0.5 nm are 5 nm)"
        )
    } else {
        return None;
    };
    Some(Warning::beyond(WarningKind::ThinFilm, -nm, text))
}

/// How much the asperities carry, by the usual bounds of the lambda ratio.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Separation {
    /// λ < 1: the asperities carry most of the load.
    Boundary,
    /// 1 ≤ λ < 3: film and asperities share the load.
    Mixed,
    /// λ ≥ 3: the film carries the load.
    Full,
}

impl Separation {
    /// Of a lambda ratio.
    pub fn of(lambda: f64) -> Separation {
        match lambda {
            l if l < 1.0 => Separation::Boundary,
            l if l < 3.0 => Separation::Mixed,
            _ => Separation::Full,
        }
    }

    /// For reports.
    pub fn name(self) -> &'static str {
        match self {
            Separation::Boundary => "boundary lubrication",
            Separation::Mixed => "mixed lubrication",
            Separation::Full => "full film",
        }
    }
}

/// Says so if the film does not separate the surfaces; film thickness and composite rms roughness in m.
pub fn roughness_warning(film: &str, thickness: f64, roughness: f64) -> Option<Warning> {
    let lambda = thickness / roughness;
    match Separation::of(lambda) {
        Separation::Full => None,
        separation => {
            let text = format!(
                "{film} is {lambda:.2} times the roughness: {}; the surfaces are computed as smooth",
                separation.name()
            );
            Some(Warning::beyond(WarningKind::Roughness, -lambda, text))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 10 nm, and 10 layers of 0.5 nm: Habchi 2008, section 6.2.
    #[test]
    fn films_at_the_limits() {
        for (nm, words) in [
            (10.01, None),
            (9.99, Some("the film, 9.99 nm, is below 10 nm")),
            (5.01, Some("is below 10 nm")),
            (
                4.99,
                Some("is below 5 nm, 10 layers of molecules of 0.5 nm"),
            ),
            (1.01, Some("is below 5 nm")),
            (0.99, Some("0.99 nm, is below a nanometre")),
        ] {
            let warning = thin_film_warning("the film", nm * 1e-9);
            match (&warning, words) {
                (Some(warning), Some(words)) => assert!(warning.contains(words), "{warning}"),
                _ => assert_eq!(warning.as_deref(), words, "{nm} nm"),
            }
        }
    }

    /// The usual bounds 1 and 3.
    #[test]
    fn surfaces_part_at_three_roughnesses() {
        for (nm, words) in [
            (31.0, None),
            (
                29.0,
                Some("the film is 2.90 times the roughness: mixed lubrication"),
            ),
            (11.0, Some("mixed")),
            (9.0, Some("0.90 times the roughness: boundary")),
        ] {
            let warning = roughness_warning("the film", nm * 1e-9, 10e-9);
            match (&warning, words) {
                (Some(warning), Some(words)) => assert!(warning.contains(words), "{warning}"),
                _ => assert_eq!(warning.as_deref(), words, "{nm} nm"),
            }
        }
    }
}
