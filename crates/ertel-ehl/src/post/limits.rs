//! Films too thin for a continuum.

use crate::warning::{Warning, WarningKind};

/// Film that keeps the surfaces of the best rolling bearings apart, m (Habchi 2008, section 6.2).
pub const SAFE_FILM: f64 = 10e-9;

/// Ten layers of molecules of 0.5 nm, m, down to which a liquid is a continuum (Habchi 2008, section 6.2).
pub const CONTINUUM_FILM: f64 = 5e-9;

/// Film of one or two molecules, m.
const MOLECULES: f64 = 1e-9;

/// Warns if the film thickness, m, is below 10 nm, below ten molecular layers, or below a nanometre. `film` names it,
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
}
