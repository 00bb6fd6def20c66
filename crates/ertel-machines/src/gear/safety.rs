//! Safety figures against scuffing and micropitting.
//!
//! The closed forms here compare a computed film or temperature with a limit. The limits themselves, the scuffing temperature of an oil and
//! the permissible specific film, come from tests (FZG scuffing and FVA micropitting tests) and are given by the user.

use super::geometry::{GearError, in_range};

/// The place of the smallest specific film and its figures.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Micropitting {
    /// Index of the contact with the smallest film.
    pub index: usize,
    /// λ_GF,min.
    pub specific_film: f64,
    /// S_λ = λ_GF,min/λ_GFP.
    pub safety: f64,
}

/// Smallest specific film and safety against micropitting, of the films h along the path (m), the roughness Ra of both gears (m) and the permissible specific
/// film λ_GFP.
///
/// λ_GF = h/Ra,  Ra = (Ra_1 + Ra_2)/2,  S_λ = λ_GF,min/λ_GFP
///
/// Source: ISO/TS 6336-22 (ISO/TR 15144-1).
pub fn micropitting(
    films: &[f64],
    roughness: [f64; 2],
    permissible: f64,
) -> Result<Micropitting, GearError> {
    let mean = 0.5 * (roughness[0] + roughness[1]);
    in_range("mean roughness", mean, mean > 0.0, "positive")?;
    let name = "permissible specific film";
    in_range(name, permissible, permissible > 0.0, "positive")?;
    let count = films.len() as f64;
    in_range("number of films", count, !films.is_empty(), "positive")?;
    let mut index = 0;
    for (i, film) in films.iter().enumerate() {
        in_range("film thickness", *film, *film >= 0.0, "not negative")?;
        if *film < films[index] {
            index = i;
        }
    }
    let specific_film = films[index] / mean;
    Ok(Micropitting {
        index,
        specific_film,
        safety: specific_film / permissible,
    })
}

/// The hottest contact and its figures.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scuffing {
    /// Index of the hottest contact.
    pub index: usize,
    /// Largest contact temperature Θ_B,max = Θ_M + Θ_fl,max, K.
    pub contact_temperature: f64,
    /// S_B.
    pub safety: f64,
}

/// Largest contact temperature and safety against scuffing by the flash temperature, of the flash temperatures along the path (K), the temperatures of the teeth
/// Θ_M, of the oil Θ_oil and of scuffing Θ_S (K, or °C throughout).
///
/// Θ_B,max = Θ_M + max Θ_fl,  S_B = (Θ_S − Θ_oil)/(Θ_B,max − Θ_oil)
///
/// Source: ISO/TS 6336-20 (ISO/TR 13989-1).
pub fn scuffing(
    flash_temperatures: &[f64],
    bulk: f64,
    oil: f64,
    scuffing_temperature: f64,
) -> Result<Scuffing, GearError> {
    let count = flash_temperatures.len() as f64;
    let name = "number of flash temperatures";
    in_range(name, count, !flash_temperatures.is_empty(), "positive")?;
    let mut index = 0;
    for (i, flash) in flash_temperatures.iter().enumerate() {
        in_range("flash temperature", *flash, *flash >= 0.0, "not negative")?;
        if *flash > flash_temperatures[index] {
            index = i;
        }
    }
    let contact_temperature = bulk + flash_temperatures[index];
    let excess = contact_temperature - oil;
    let name = "largest contact temperature less that of the oil";
    in_range(name, excess, excess > 0.0, "positive")?;
    let margin = scuffing_temperature - oil;
    let name = "scuffing temperature less that of the oil";
    in_range(name, margin, margin > 0.0, "positive")?;
    Ok(Scuffing {
        index,
        contact_temperature,
        safety: margin / excess,
    })
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    /// By hand: 0.12 µm over (0.4 + 0.6)/2 µm is 0.24; over 0.16 that is 1.5.
    #[test]
    fn micropitting_by_hand() {
        let films = [0.2e-6, 0.12e-6, 0.15e-6];
        let found = micropitting(&films, [0.4e-6, 0.6e-6], 0.16).expect("figures");
        assert_eq!(found.index, 1);
        assert_relative_eq!(found.specific_film, 0.24, max_relative = 1e-12);
        assert_relative_eq!(found.safety, 1.5, max_relative = 1e-12);
        assert!(micropitting(&[], [1e-6; 2], 0.2).is_err());
        assert!(micropitting(&films, [0.0; 2], 0.2).is_err());
        assert!(micropitting(&[f64::NAN], [1e-6; 2], 0.2).is_err());
    }

    /// By hand: teeth at 110 °C, 150 K of flash, oil at 90 °C, scuffing at 430 °C: (430 − 90)/(260 − 90) = 2.
    #[test]
    fn scuffing_by_hand() {
        let found = scuffing(&[40.0, 150.0, 90.0], 110.0, 90.0, 430.0).expect("figures");
        assert_eq!((found.index, found.contact_temperature), (1, 260.0));
        assert_relative_eq!(found.safety, 2.0, max_relative = 1e-12);
        assert!(scuffing(&[0.0], 90.0, 90.0, 430.0).is_err());
        assert!(scuffing(&[10.0], 90.0, 90.0, 80.0).is_err());
    }
}
