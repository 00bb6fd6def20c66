//! The figures of a solution, and warnings about the edges of its contact area.

use crate::contact::{Inlet, Shape};
use crate::engine::Extents;
use crate::solution::{Figure, Measured, Summary, Traction, TractionAcross};
use crate::warning::{Warning, WarningKind};

/// The figures of a solve; balances and separation, which the engine supplies, are zero.
pub fn summary_of(measured: &Measured) -> Summary {
    Summary {
        film_central: measured.estimate(Figure::FilmCentral),
        film_minimum: measured.estimate(Figure::FilmMinimum),
        film_minimum_at: measured.located(Figure::FilmMinimum),
        film_centreline_minimum: measured.located(Figure::FilmCentrelineMinimum),
        pressure_maximum: measured.located(Figure::PressureMaximum),
        pressure_central: measured.located(Figure::PressureCentral),
        pressure_ridge: measured.find_located(Figure::PressureRidge),
        spike: measured.find_located(Figure::PressureSpike),
        outlet_position: measured.estimate(Figure::OutletPosition),
        pressure_minimum: 0.0,
        film_balance_error: 0.0,
        load_balance_error: 0.0,
        rigid_separation: 0.0,
    }
}

/// Traction and friction of the finest stage.
pub fn traction(measured: &Measured) -> Traction {
    Traction {
        coefficient: measured.estimate(Figure::TractionCoefficient),
        coefficient_body_1: measured.estimate(Figure::TractionCoefficientBody1),
        coefficient_body_2: measured.estimate(Figure::TractionCoefficientBody2),
        force: measured.estimate(Figure::TractionForce),
        across: across(measured),
        moment: measured.find(Figure::TractionMoment),
        friction_power: measured.estimate(Figure::FrictionPower),
        shear_stress_maximum: measured.estimate(Figure::ShearStressMaximum),
        beyond_first_limit: measured.find(Figure::BeyondFirstLimit),
        beyond_second_limit: measured.find(Figure::BeyondSecondLimit),
    }
}

fn across(measured: &Measured) -> Option<TractionAcross> {
    Some(TractionAcross {
        coefficient: measured.find(Figure::TractionCoefficientAcross)?,
        coefficient_body_1: measured.find(Figure::TractionCoefficientAcrossBody1)?,
        coefficient_body_2: measured.find(Figure::TractionCoefficientAcrossBody2)?,
        force: measured.find(Figure::TractionForceAcross)?,
    })
}

/// Films that show whether the edges of a contact area are far enough out.
#[derive(Clone, Copy, Debug)]
pub struct EdgeFilms {
    /// X where the film breaks on the centreline.
    pub outlet: f64,
    /// H at the inlet edge.
    pub inlet: f64,
    /// H in the centre.
    pub centre: f64,
}

/// Warnings about edges that are too close.
pub fn edge_warnings(e: &Extents, shape: &Shape, films: EdgeFilms) -> Vec<Warning> {
    let mut warnings = Vec::new();
    let side_key = if shape.is_line() { "" } else { ", side" };
    if films.outlet > e.outlet - 0.02 {
        let text = format!(
            "the film does not break before the outlet edge X = {}: move it outward ([mesh] outlet)",
            e.outlet
        );
        warnings.push(Warning::new(WarningKind::OutletEdge, text));
    }
    if shape.inlet == Inlet::Flooded && films.inlet < 20.0 * films.centre {
        let text = format!(
            "the film at the inlet edge X = {} is only {:.0} times the central film: the \
             computational inlet is too short (numerical starvation); move the edge outward ([mesh] inlet{})",
            e.inlet,
            films.inlet / films.centre,
            side_key
        );
        let shortage = films.centre / films.inlet;
        warnings.push(Warning::beyond(WarningKind::InletEdge, shortage, text));
    }
    warnings
}
