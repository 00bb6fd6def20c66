//! Which requested figures a solution does not resolve.

use super::{Estimate, Figure, LEAST_RISE, Solution, Unresolved, Why, limits};

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
}
