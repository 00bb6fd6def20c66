//! Requested figures that a solve does not resolve.

use serde::Serialize;

use super::{Estimate, Figure, Kind};

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

impl Unresolved {
    /// A balance of heat or mass of which a share `error` is missing, if that is too much.
    pub(super) fn open_balance(why: Why, error: f64) -> Option<Unresolved> {
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
