//! Laws ranked by cross-validation: error on the isotherm left out.
//!
//! Each isotherm in turn is left out, the law is fitted to the others, and its deviation there is
//!
//! ```text
//! d = ln(law/measured),   rms = √(1/n Σ d²) over the states of all isotherms
//! ```
//!
//! (cross-validation, leaving one group out: Stone, J. Royal Stat. Soc. B 36, 1974, 111-147). A law with many constants follows
//! any data that it is fitted to; only its prediction of other data distinguishes laws.

use super::law::ISOTHERM;
use super::{Data, Fit, FitError, LawName, Params, fit};

/// Isotherms that are needed: with one left out, the others must still determine the effect of temperature.
const FEWEST_ISOTHERMS: usize = 3;

/// A law in the ranking.
#[derive(Clone, Debug)]
pub struct Ranked {
    /// The law fitted to all states.
    pub fit: Fit,
    /// Root mean square of ln(law/measured) on isotherms left out.
    pub rms_left_out: f64,
    /// Temperature of the isotherm that it predicts worst, K, and the rms there.
    pub worst: (f64, f64),
}

/// A law that is not in the ranking.
#[derive(Clone, Debug, PartialEq)]
pub struct Unranked {
    /// The law.
    pub law: LawName,
    /// Why not.
    pub reason: String,
}

/// The laws for the property of the data.
#[derive(Clone, Debug, Default)]
pub struct Ranking {
    /// The best first.
    pub ranked: Vec<Ranked>,
    /// Laws that could not be fitted to all states, or not without one of the isotherms.
    pub unranked: Vec<Unranked>,
    /// Temperatures of the isotherms, K.
    pub isotherms: Vec<f64>,
}

/// Ranks all laws for the property of the data. Constants are neither held nor freed; `params` gives the other options.
pub fn rank(data: &Data, params: &Params) -> Ranking {
    let isotherms = isotherms(data);
    let mut ranking = Ranking::default();
    for law in LawName::ALL
        .into_iter()
        .filter(|law| law.property() == data.property)
    {
        match try_rank(data, law, params, &isotherms) {
            Ok(ranked) => ranking.ranked.push(ranked),
            Err(reason) => ranking.unranked.push(Unranked { law, reason }),
        }
    }
    ranking
        .ranked
        .sort_by(|a, b| a.rms_left_out.total_cmp(&b.rms_left_out));
    ranking.isotherms = isotherms;
    ranking
}

fn try_rank(
    data: &Data,
    law: LawName,
    params: &Params,
    isotherms: &[f64],
) -> Result<Ranked, String> {
    if !law.is_thermal() {
        return Err("no temperature dependence; cannot be ranked".to_owned());
    }
    if isotherms.len() < FEWEST_ISOTHERMS {
        return Err(format!(
            "at least {FEWEST_ISOTHERMS} isotherms are needed, and the data have {}",
            isotherms.len()
        ));
    }
    let whole = fit(data, law, params).map_err(|error| error.to_string())?;
    let (mut sum, mut n) = (0.0, 0);
    let mut worst = (isotherms[0], 0.0);
    for temperature in isotherms {
        let celsius = temperature - 273.15;
        let is_out = |t: f64| (t - temperature).abs() <= ISOTHERM;
        let mut rest = data.clone();
        rest.states.retain(|state| !is_out(state.temperature));
        let without = |error: FitError| format!("without the isotherm of {celsius:.1} °C: {error}");
        let part = fit(&rest, law, params).map_err(without)?;
        let left_out = data.states.iter().filter(|state| is_out(state.temperature));
        let squares: Vec<f64> = left_out
            .map(|s| (part.law.ln_value(s.pressure, s.temperature) - s.value.ln()).powi(2))
            .collect();
        let own: f64 = squares.iter().sum();
        if !own.is_finite() {
            return Err(format!(
                "without the isotherm of {celsius:.1} °C it has no finite value there"
            ));
        }
        let rms = (own / squares.len() as f64).sqrt();
        if rms > worst.1 {
            worst = (*temperature, rms);
        }
        sum += own;
        n += squares.len();
    }
    Ok(Ranked {
        fit: whole,
        rms_left_out: (sum / n as f64).sqrt(),
        worst,
    })
}

/// Temperatures of the isotherms, rising.
fn isotherms(data: &Data) -> Vec<f64> {
    let mut temperatures: Vec<f64> = data.states.iter().map(|state| state.temperature).collect();
    temperatures.sort_by(f64::total_cmp);
    let mut isotherms: Vec<f64> = Vec::new();
    for temperature in temperatures {
        if isotherms
            .last()
            .is_none_or(|last| temperature - last > ISOTHERM)
        {
            isotherms.push(temperature);
        }
    }
    isotherms
}

#[cfg(test)]
mod tests {
    use super::super::Property;
    use super::*;

    /// Viscosities after Cheng, by his formula: ln μ = ln μ₀ + α p + (β + γ p)(1/T - 1/T_R).
    fn table(temperatures: &[f64]) -> Data {
        let mut csv = "pressure_Pa,temperature_K,viscosity_Pa_s\n".to_owned();
        for t in temperatures {
            for i in 0..8 {
                let p = 5e7 * f64::from(i);
                let ln = 0.04f64.ln() + 20e-9 * p + (4000.0 + 3e-6 * p) * (1.0 / t - 1.0 / 313.15);
                csv += &format!("{p},{t},{:e}\n", ln.exp());
            }
        }
        Data::parse("oil.csv", &csv, Property::Viscosity).unwrap()
    }

    #[test]
    fn the_law_behind_the_data_comes_first() {
        let ranking = rank(
            &table(&[293.15, 313.15, 333.15, 353.15]),
            &Params::default(),
        );
        assert_eq!(ranking.isotherms.len(), 4);
        let best = &ranking.ranked[0];
        assert_eq!(best.fit.name, LawName::Cheng);
        assert!(best.rms_left_out < 1e-6, "{}", best.rms_left_out);
        for pair in ranking.ranked.windows(2) {
            assert!(pair[0].rms_left_out <= pair[1].rms_left_out);
        }
        // An unsuitable law predicts the isotherm left out worse than the isotherms it was fitted to.
        let roelands = ranking
            .ranked
            .iter()
            .find(|r| r.fit.name == LawName::Roelands)
            .unwrap();
        assert!(roelands.rms_left_out > 1e-3);
        assert!(
            roelands.rms_left_out > 1.05 * roelands.fit.rms(),
            "{} {}",
            roelands.rms_left_out,
            roelands.fit.rms()
        );
        let why = |law| {
            &ranking
                .unranked
                .iter()
                .find(|u| u.law == law)
                .unwrap()
                .reason
        };
        assert!(why(LawName::Barus).contains("no temperature"));
        assert!(why(LawName::Doolittle).contains("equation of state"));
    }

    #[test]
    fn two_isotherms_are_too_few() {
        let ranking = rank(&table(&[293.15, 313.15]), &Params::default());
        assert!(ranking.ranked.is_empty());
        assert!(
            ranking
                .unranked
                .iter()
                .any(|u| u.reason.contains("at least 3 isotherms"))
        );
    }

    /// A law, ln(μ/μ₀) by its formula, and its constants.
    type Case<'a> = (LawName, &'a dyn Fn(f64) -> f64, &'a [(&'a str, f64)]);

    /// One isotherm made by each law, by its formula; the fit finds its constants again.
    #[test]
    fn laws_of_one_isotherm_are_fitted() {
        let cases: [Case<'_>; 3] = [
            (
                LawName::McEwen,
                &|p| 8.0 * (18e-9 * p / 8.0).ln_1p(),
                &[("alpha", 18e-9), ("q", 8.0)],
            ),
            (
                LawName::Paluch,
                &|p| 40.0 * p / (3e9 - p),
                &[("c_f", 40.0), ("p_inf", 3e9)],
            ),
            (
                LawName::Hybrid,
                &|p| 3.0 * (15e-9 * p / 3.0).ln_1p() + 10.0 * p / (3e9 - p),
                &[("a_0", 15e-9), ("q", 3.0), ("c_f", 10.0), ("p_inf", 3e9)],
            ),
        ];
        for (law, ln, constants) in cases {
            let mut csv = "pressure_Pa,temperature_K,viscosity_Pa_s\n".to_owned();
            for i in 0..25 {
                let p = 5e7 * f64::from(i);
                csv += &format!("{p},313.15,{:e}\n", 0.05 * ln(p).exp());
            }
            let data = Data::parse("oil.csv", &csv, Property::Viscosity).unwrap();
            let fit = fit(&data, law, &Params::default()).unwrap();
            assert!(fit.rms() < 1e-4, "{law:?} {}", fit.rms());
            for (key, value) in constants {
                let found = fit.constants.iter().find(|c| c.key == *key).unwrap().value;
                assert!((found / value - 1.0).abs() < 0.02, "{law:?} {key} {found}");
            }
        }
    }
}
