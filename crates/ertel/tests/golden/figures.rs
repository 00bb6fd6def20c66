//! The figures of a solution by their names in the registry.

use ertel::solution::{Estimate, Figure, Located, Solution};

/// A figure of a solution.
#[derive(Clone, Copy, Debug)]
pub struct Told {
    /// Value with its bar.
    pub estimate: Estimate,
    /// Where it is, if it has a place.
    pub place: Option<Located>,
}

impl From<Estimate> for Told {
    fn from(estimate: Estimate) -> Told {
        Told {
            estimate,
            place: None,
        }
    }
}

impl From<Located> for Told {
    fn from(located: Located) -> Told {
        Told {
            estimate: located.estimate(),
            place: Some(located),
        }
    }
}

/// A figure, where the solution has it. Without a wildcard: a new figure must be put here before this compiles.
pub fn told(solution: &Solution, figure: Figure) -> Option<Told> {
    let (s, t) = (&solution.summary, &solution.traction);
    let (roller, heat) = (solution.roller.as_ref(), solution.thermal.as_ref());
    let (across, balance) = (t.across.as_ref(), heat.map(|heat| &heat.balance));
    let found = match figure {
        Figure::FilmCentral => Some(s.film_central.into()),
        Figure::FilmMinimum => Some(s.film_minimum_at.into()),
        Figure::FilmCentrelineMinimum => Some(s.film_centreline_minimum.into()),
        Figure::PressureMaximum => Some(s.pressure_maximum.into()),
        Figure::PressureCentral => Some(s.pressure_central.into()),
        Figure::PressureRidge => s.pressure_ridge.map(Told::from),
        Figure::EdgePressureLeft => roller.map(|r| r.edge_pressure_left.into()),
        Figure::EdgePressureRight => roller.map(|r| r.edge_pressure_right.into()),
        Figure::RollerMoment => roller.map(|r| r.roller_moment.into()),
        Figure::LoadPosition => roller.map(|r| r.load_position.into()),
        Figure::Spike => s.spike.map(Told::from),
        Figure::OutletPosition => Some(s.outlet_position.into()),
        Figure::MeniscusPosition => (solution.starvation.as_ref())
            .and_then(|starvation| starvation.meniscus_position)
            .map(Told::from),
        Figure::TractionCoefficient => Some(t.coefficient.into()),
        Figure::TractionCoefficientBody1 => Some(t.coefficient_body_1.into()),
        Figure::TractionCoefficientBody2 => Some(t.coefficient_body_2.into()),
        Figure::TractionForce => Some(t.force.into()),
        Figure::TractionCoefficientAcross => across.map(|a| a.coefficient.into()),
        Figure::TractionCoefficientAcrossBody1 => across.map(|a| a.coefficient_body_1.into()),
        Figure::TractionCoefficientAcrossBody2 => across.map(|a| a.coefficient_body_2.into()),
        Figure::TractionForceAcross => across.map(|a| a.force.into()),
        Figure::TractionMoment => t.moment.map(Told::from),
        Figure::FrictionPower => Some(t.friction_power.into()),
        Figure::ShearStressMaximum => Some(t.shear_stress_maximum.into()),
        Figure::BeyondFirstLimit => t.beyond_first_limit.map(Told::from),
        Figure::BeyondSecondLimit => t.beyond_second_limit.map(Told::from),
        Figure::FilmTemperatureMaximum => heat.map(|h| h.film_maximum.into()),
        Figure::FilmTemperatureLowest => heat.map(|h| h.film_lowest.into()),
        Figure::FilmTemperatureMean => heat.map(|h| h.film_mean.into()),
        Figure::Body1TemperatureMaximum => heat.map(|h| h.body_1_maximum.into()),
        Figure::Body1TemperatureMean => heat.map(|h| h.body_1_mean.into()),
        Figure::Body2TemperatureMaximum => heat.map(|h| h.body_2_maximum.into()),
        Figure::Body2TemperatureMean => heat.map(|h| h.body_2_mean.into()),
        Figure::HeatShear => balance.map(|b| b.shear.into()),
        Figure::HeatCompression => balance.map(|b| b.compression.into()),
        Figure::HeatToBody1 => balance.map(|b| b.to_body_1.into()),
        Figure::HeatToBody2 => balance.map(|b| b.to_body_2.into()),
        Figure::HeatByFilm => balance.map(|b| b.by_film.into()),
    };
    // Figures that every solution should have are not a number where the mesh has none.
    found.filter(|told: &Told| !told.estimate.value.is_nan())
}
