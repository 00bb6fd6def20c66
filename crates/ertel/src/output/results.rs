//! The figures of a solution in the report: a row for each figure of the registry.

use super::figure::{
    estimate, in_unit, number, peak, percent, place, position, pressure_estimate, temperature,
};
use super::lines::{Lines, two_columns};
use crate::contact::Symmetry;
use crate::solution::{ErrorClass, Estimate, Figure, Kind, Located, Section, Solution};

/// The figures of a section.
pub(super) fn write_section(out: &mut Lines, solution: &Solution, section: Section) {
    let found = solution.figures().filter(|(f, _)| f.section() == section);
    for (figure, at) in found.filter(|(figure, at)| !is_repetition(solution, *figure, at)) {
        let text = two_columns(
            &value(solution, figure, &at),
            &remark(solution, figure, &at),
        );
        out.row(&figure.title(), text);
    }
}

/// Whether another row shows the same.
fn is_repetition(solution: &Solution, figure: Figure, at: &Located) -> bool {
    let is_half = solution.shape.symmetry == Symmetry::Half;
    match figure {
        Figure::FilmCentrelineMinimum => solution.shape.is_line(),
        Figure::PressureCentral => (solution.figure(Figure::PressureMaximum))
            .is_some_and(|largest| largest.resolved && largest.value == at.value),
        // Both ends are equal, and the load acts in the middle.
        Figure::EdgePressureRight | Figure::RollerMoment | Figure::LoadPosition => is_half,
        Figure::FilmTemperatureLowest => {
            inlet_temperature(solution).is_some_and(|inlet| at.value >= inlet - LEAST_COOLING)
        }
        _ => false,
    }
}

/// Smallest reported cooling below the inlet temperature, K.
const LEAST_COOLING: f64 = 0.005;

/// Fraction of the shear heat below which heat is round-off, such as compression heat if the laws have none.
const ROUND_OFF: f64 = 1e-9;

fn inlet_temperature(solution: &Solution) -> Option<f64> {
    solution.thermal.as_ref().map(|t| t.inlet_temperature)
}

/// Value and error bar.
pub(super) fn value(solution: &Solution, figure: Figure, at: &Located) -> String {
    let e = at.estimate();
    let unit = figure.unit(solution.shape.is_line());
    match figure.kind() {
        Kind::Length | Kind::Offset => estimate(&e),
        Kind::Position => position(e, solution.hertz.half_width),
        Kind::PeakPressure => peak(at),
        Kind::Stress => pressure_estimate(e),
        Kind::Coefficient => number(e),
        Kind::Share => percent(e),
        Kind::Power if is_round_off(solution, figure, e) => format!("0 {unit}"),
        Kind::Force
        | Kind::Power
        | Kind::Rise
        | Kind::Angle
        | Kind::Speed
        | Kind::AngularSpeed
        | Kind::Duration
        | Kind::Revolutions => in_unit(e, 1.0, unit),
        Kind::Moment => match e.value.abs().max(e.error.unwrap_or(0.0)) < 1.0 {
            true => in_unit(e, 1e3, "N mm"),
            false => in_unit(e, 1.0, unit),
        },
        Kind::Temperature => temperature(e, inlet_temperature(solution)),
    }
}

fn is_round_off(solution: &Solution, figure: Figure, e: Estimate) -> bool {
    let shear = solution.figure(Figure::HeatShear);
    figure.section() == Section::Heat
        && shear.is_some_and(|shear| e.value.abs() < ROUND_OFF * shear.value.abs())
}

/// The second column: the place, or the share of the total heat carried away.
fn remark(solution: &Solution, figure: Figure, at: &Located) -> String {
    if figure.error_class() == ErrorClass::HeatCarried {
        return share_of_heat(solution, at.value);
    }
    // The place is meaningless if a higher peak may be elsewhere.
    let is_known = figure.kind() != Kind::PeakPressure || at.resolved || at.place_resolved;
    match figure.has_place() && is_known {
        true => place(solution, at),
        false => String::new(),
    }
}

fn share_of_heat(solution: &Solution, heat: f64) -> String {
    let of_heat = |class| {
        let heat = solution
            .figures()
            .filter(move |(f, _)| f.error_class() == class);
        heat.map(|(_, at)| at.value).sum::<f64>()
    };
    let carried = of_heat(ErrorClass::HeatCarried);
    // Shares of a negligible amount are meaningless.
    match carried.abs() > 1e-6 * of_heat(ErrorClass::HeatShear).abs() {
        true => format!("{:.1} %", 100.0 * heat / carried),
        false => String::new(),
    }
}
