//! Requested figures that a solve does not resolve.

use serde::Serialize;

use super::{Estimate, Figure, Kind, LEAST_RISE, Solution, limits};

/// A requested figure that the result does not give.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unresolved {
    /// Which.
    pub figure: Figure,
    /// Its value, SI; of a temperature the rise, of an open balance the share of the heat that is missing.
    pub estimate: Estimate,
    /// Why not.
    pub why: Why,
}

/// Why a figure is not given.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Why {
    /// Its error bar is wider than half of it.
    WideBar,
    /// An error bar was requested, and none could be computed.
    NoBar,
    /// A film thicker than the bodies' radius: there is no such contact.
    BeyondBodies,
    /// Beyond what is possible, [`super::limits`].
    BeyondPhysics,
    /// Bodies and film do not carry off the heat that is made.
    OpenBalance,
    /// The film gains or loses oil.
    OpenMassBalance,
}

impl Serialize for Unresolved {
    /// As the figure's name.
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}

/// Largest imbalance of heat, over the heat generated, with which temperatures and heat are given.
const OPEN_BALANCE: f64 = 0.2;

/// Share of the oil that passes the centre which the film may gain or lose before none of its figures is resolved. Where edges of the contact area were moved inward, a balance of
/// -15 % came with central films 1.7 % too thin at bars of 0.07 %. Sound steady solves stay below 0.6 %, sound steps in time below 0.8 %.
pub const OPEN_MASS_BALANCE: f64 = 0.05;

/// Smallest traction coefficient that counts: no rig measures less, and sliding of 1e-5 of the speed hardly causes any.
const LEAST_TRACTION: f64 = 1e-4;

/// Figures requested of a solution.
#[derive(Clone, Copy, Debug)]
pub struct Asked {
    /// Whether error bars.
    pub bars: bool,
    /// Whether the surfaces slide, and have traction that counts.
    pub slides: bool,
    /// Radius of curvature of the contact, m, that a film is not thicker than.
    pub radius: f64,
}

impl Unresolved {
    /// Those of a solution: films, traction where the surfaces slide, the largest rise of the film's temperature, and the heat balance.
    pub fn all(solution: &Solution, asked: Asked) -> Vec<Unresolved> {
        let (summary, thermal) = (&solution.summary, solution.thermal.as_ref());
        let films = [
            (Figure::FilmCentral, summary.film_central),
            (Figure::FilmMinimum, summary.film_minimum),
        ];
        let traction =
            (asked.slides).then_some((Figure::TractionCoefficient, solution.traction.size()));
        let traction = traction.filter(|(_, f)| f.error.is_none_or(|error| error > LEAST_TRACTION));
        let rise = thermal.map(|t| Estimate {
            value: t.film_maximum.value - t.inlet_temperature,
            error: t.film_maximum.error,
        });
        let rise = rise.filter(|rise| rise.value > LEAST_RISE);
        let limit = |figure: Figure| match figure {
            Figure::TractionCoefficient => limits::TRACTION,
            Figure::FilmTemperatureMaximum => {
                limits::TEMPERATURE - thermal.map_or(0.0, |t| t.inlet_temperature)
            }
            _ => f64::INFINITY,
        };
        let why = |figure: Figure, e: &Estimate| match e.error {
            _ if e.value > limit(figure) => Some(Why::BeyondPhysics),
            None if asked.bars => Some(Why::NoBar),
            _ if !e.is_resolved() => Some(Why::WideBar),
            _ if figure == Figure::FilmCentral && e.value > asked.radius => Some(Why::BeyondBodies),
            _ => None,
        };
        let figures = (films.into_iter().chain(traction))
            .chain(rise.map(|rise| (Figure::FilmTemperatureMaximum, rise)))
            .filter_map(|(figure, estimate)| {
                let why = why(figure, &estimate)?;
                Some(Unresolved {
                    figure,
                    estimate,
                    why,
                })
            });
        let heat = thermal.map(|thermal| (Why::OpenBalance, thermal.balance.error));
        let mass = Some((Why::OpenMassBalance, summary.film_balance_error));
        let balances = heat.into_iter().chain(mass);
        let open = balances.filter_map(|(why, error)| Unresolved::open_balance(why, error));
        figures.chain(open).collect()
    }

    /// A balance of heat or mass of which a share `error` is missing, if that is too much.
    fn open_balance(why: Why, error: f64) -> Option<Unresolved> {
        let (figure, most) = match why {
            Why::OpenMassBalance => (Figure::FilmCentral, OPEN_MASS_BALANCE),
            _ => (Figure::HeatByFilm, OPEN_BALANCE),
        };
        (error.abs() > most || error.is_nan()).then_some(Unresolved {
            figure,
            estimate: Estimate {
                value: error.abs(),
                error: None,
            },
            why,
        })
    }

    /// Name in results.
    pub fn name(&self) -> &'static str {
        match self.why {
            Why::OpenBalance => "heat_balance_error",
            Why::OpenMassBalance => "film_balance_error",
            _ => self.figure.name(),
        }
    }

    /// `the minimum film thickness`.
    pub fn words(&self) -> String {
        match (self.figure.kind(), self.why) {
            (_, Why::OpenBalance) => "the heat balance".to_owned(),
            (_, Why::OpenMassBalance) => "the mass balance of the film".to_owned(),
            (Kind::Temperature, _) => "the largest rise of the film's temperature".to_owned(),
            _ => format!("the {}", self.figure.words()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Bodies and film that carry off 21 times more than is made, or 30 % less, have no temperatures; 3 % is a warning. A film that gains 15 % of its oil is none.
    #[test]
    fn an_open_balance_is_no_result() {
        for error in [-20.96, 0.3, f64::NAN] {
            let found = Unresolved::open_balance(Why::OpenBalance, error).unwrap();
            assert_eq!(found.name(), "heat_balance_error");
            assert_eq!(found.words(), "the heat balance");
        }
        assert_eq!(Unresolved::open_balance(Why::OpenBalance, 0.03), None);
        assert_eq!(Unresolved::open_balance(Why::OpenBalance, -0.03), None);
        for error in [-0.153, 0.06, f64::NAN] {
            let found = Unresolved::open_balance(Why::OpenMassBalance, error).unwrap();
            assert_eq!(found.name(), "film_balance_error");
        }
        assert_eq!(Unresolved::open_balance(Why::OpenMassBalance, 5.3e-3), None);
    }
}
