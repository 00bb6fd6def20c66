//! Figures of a rolling bearing: friction by its parts, and what they come to.
//!
//! ```text
//!   P = Σ P_film + P_slip       over all contacts: work of the surfaces on the film, and of the differential slip beside it
//!   P_roll = Σ (µ_2 − µ_1) Q u  the part of P_film that rolling takes; the rest is spin
//!   M = P/|ω_i − ω_o|
//! ```

use ertel_machines::bearing::Geometry;
use ertel_machines::bearing::kinematics::deformed_radius;

use super::slip::{Slip, stress};
use super::{MachineFigure, Section, figure_of, sum};
use crate::case::{BearingMechanics, Case};
use crate::solution::{Estimate, Figure};
use crate::study::{MachineSolution, PointSolution};

/// The figures, of a bearing all of whose contacts are solved.
pub(super) fn figures(
    case: &Case,
    mechanics: &BearingMechanics,
    solved: &MachineSolution,
) -> Vec<MachineFigure> {
    let mut figures = Vec::new();
    let film = sum(solved, |_, point| figure_of(point, Figure::FrictionPower));
    let rolling = sum(solved, |_, point| rolling_power(point));
    let slip = sum(solved, |i, point| {
        let side = solved.machine.contacts[i].side;
        Some(Estimate {
            value: slip_power(case, mechanics, side, point)?,
            error: None,
        })
    });
    let (Some(film), Some(rolling), Some(slip)) = (film, rolling, slip) else {
        return figures;
    };
    let slip = slip.value;
    let power = Estimate {
        value: film.value + slip,
        error: film.error,
    };
    let relative = mechanics.speeds.relative().abs();
    let figure = |name, words, estimate, unit, source| MachineFigure {
        name,
        words,
        estimate,
        unit,
        section: Section::Friction,
        source,
    };
    let of_model = |value| Estimate { value, error: None };
    figures.push(figure(
        "friction_power_rolling",
        "power lost by rolling",
        rolling,
        "W",
        "rolling: what both walls of the film resist at equal speeds",
    ));
    if mechanics
        .distribution
        .elements
        .iter()
        .any(|e| e.contacts.iter().any(|c| c.spin[0] != c.spin[1]))
    {
        figures.push(figure(
            "friction_power_spin",
            "power lost by spin",
            Estimate {
                value: film.value - rolling.value,
                error: film.error,
            },
            "W",
            "",
        ));
    }
    figures.push(figure(
        "friction_power_differential_slip",
        "power lost by differential slip",
        of_model(slip),
        "W",
        "differential slip: Heathcote 1921, by the laws of the lubricant at the dry pressure and the central film of each contact",
    ));
    figures.push(figure(
        "friction_power",
        "power lost in all contacts",
        power,
        "W",
        "",
    ));
    if relative > 0.0 {
        let torque = Estimate {
            value: power.value / relative,
            error: power.error.map(|e| e / relative),
        };
        figures.push(figure(
            "friction_torque",
            "friction torque of all contacts",
            torque,
            "N m",
            "without cage, seals and churning of the oil",
        ));
    }
    figures
}

/// Power that rolling alone takes: (µ_2 − µ_1) Q u.
fn rolling_power(point: &PointSolution) -> Option<Estimate> {
    let one = figure_of(point, Figure::TractionCoefficientBody1)?;
    let two = figure_of(point, Figure::TractionCoefficientBody2)?;
    let scale = point.case.contact.load * point.case.motion.entrainment_speed;
    let both = one.error.zip(two.error);
    Some(Estimate {
        value: (two.value - one.value) * scale,
        error: both.map(|(one, two)| (one + two) * scale),
    })
}

/// Power of the differential slip at a ring, W; `None` of rollers, and where the contact was not solved.
fn slip_power(
    case: &Case,
    mechanics: &BearingMechanics,
    side: usize,
    point: &PointSolution,
) -> Option<f64> {
    let Geometry::Ball(geometry) = &mechanics.bearing.geometry else {
        return None;
    };
    let solution = point.outcome.solution()?;
    let deformed = deformed_radius(geometry.groove[side], geometry.ball_diameter);
    let slip = Slip {
        half_widths: [solution.hertz.half_width, solution.hertz.half_width_y?],
        hertz_pressure: solution.hertz.pressure,
        film: solution.summary.film_central.value,
        speed: point.case.motion.entrainment_speed,
        curvature: 0.5 / (deformed * point.case.contact.radius),
    };
    let lubricant = &case.lubricant;
    let thinning = case.shear_thinning();
    Some(slip.power(|pressure, rate| {
        let viscosity = lubricant
            .viscosity
            .viscosity(pressure, lubricant.temperature);
        stress(thinning, viscosity, pressure, rate)
    }))
}
