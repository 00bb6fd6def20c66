//! Figures of whole machines: from the solutions of their contacts to friction, heat, safety and life.

mod bearing;
mod cam;
mod curve;
mod gears;
mod heat;
mod life;
mod moments;
mod rolling;
mod slip;

pub(crate) use heat::solve_by;
pub use heat::{Balance, SolvedMachine};

use self::curve::Curve;
use crate::case::{Case, Mechanics};
use crate::mark::Marked;
pub use crate::point::{MachineFigure, MachineFigures, Section};
use crate::point::{MachineSolution, PointSolution};
use crate::solution::Figure;
use crate::warning::silence;

/// The figures of a machine; sums and extremes over its contacts only where all of them are solved: the thinnest film may be that of a contact which is missing.
pub fn figures(case: &Case, solved: &MachineSolution) -> MachineFigures {
    let unsolved;
    let solved = match solved.n_solved() < solved.n_contacts() {
        true => {
            unsolved = solved.unsolved();
            &unsolved
        }
        false => solved,
    };
    let mut all = films(solved);
    let mut warnings = Vec::new();
    match &solved.machine.mechanics {
        Mechanics::Bearing(bearing) => {
            all.extend(bearing::figures(case, bearing, solved, &mut warnings));
        }
        Mechanics::Gears(gears) => all.extend(gears::figures(case, gears, solved, &mut warnings)),
        Mechanics::Cam(cam) => all.extend(cam::figures(cam, solved)),
    }
    silence(&mut warnings, &case.output.silence);
    MachineFigures { all, warnings }
}

/// A machine none of whose contacts is solved, with the figures that need no film: loads, ratings, lives, models of friction. `None` of single contacts.
pub fn unsolved(case: &Case) -> Option<(MachineSolution, MachineFigures)> {
    let machine = case.whole.clone()?;
    let solution = MachineSolution {
        contacts: vec![None; machine.contacts.len()],
        machine,
        wall_seconds: 0.0,
    };
    let figures = figures(case, &solution);
    Some((solution, figures))
}

/// The contact with the smallest film, by its place among the contacts.
fn thinnest(solved: &MachineSolution) -> Option<usize> {
    let films = solved
        .solved()
        .filter_map(|(i, point)| Some((i, figure_of(point, Figure::FilmMinimum)?.value)));
    let (i, _) = films.min_by(|a, b| a.1.total_cmp(&b.1))?;
    Some(i)
}

/// A figure of a contact.
fn figure_of(point: &PointSolution, figure: Figure) -> Option<Marked> {
    Marked::of(point.outcome.solution()?, figure)
}

/// The friction coefficient of a contact: of oil and asperities where they share the load.
fn friction_of(point: &PointSolution) -> Option<Marked> {
    let both = figure_of(point, Figure::FrictionTotal);
    both.or_else(|| figure_of(point, Figure::TractionCoefficient))
}

/// Sum over all loaded contacts, identical ones counted as often as they occur. `None` where one of them has no value.
fn sum(
    solved: &MachineSolution,
    value: impl Fn(usize, &PointSolution) -> Option<Marked>,
) -> Option<Marked> {
    let machine = &solved.machine;
    let own = machine.contacts.iter().enumerate();
    let own = own.filter(|(i, contact)| contact.like == Some(*i));
    let of = own.map(|(i, _)| Some(value(i, solved.of(i)?)? * machine.count(i) as f64));
    let nothing = Marked {
        error: Some(0.0),
        ..Marked::exact(0.0)
    };
    of.into_iter().try_fold(nothing, |sum, of| Some(sum + of?))
}

/// The smallest value of all contacts. Along a path and over a turn its bar allows for what lies between the contacts.
fn smallest(
    solved: &MachineSolution,
    value: impl Fn(&PointSolution) -> Option<Marked>,
) -> Option<Marked> {
    let contacts = solved.machine.contacts.iter().enumerate();
    let values = contacts.filter_map(|(i, at)| Some((at.place, value(solved.of(i)?)?)));
    let values: Vec<(f64, Marked)> = values.collect();
    match &solved.machine.mechanics {
        Mechanics::Bearing(_) => {
            let values = values.into_iter().map(|(_, value)| value);
            values.min_by(|a, b| a.value.total_cmp(&b.value))
        }
        Mechanics::Gears(_) => Some(Curve::new(values)?.smallest().1),
        Mechanics::Cam(cam) => cam::smallest(cam, values),
    }
}

/// The smallest film of all, and the smallest film over roughness.
fn films(solved: &MachineSolution) -> Vec<MachineFigure> {
    let film = smallest(solved, |point| figure_of(point, Figure::FilmMinimum));
    let central = smallest(solved, |point| figure_of(point, Figure::FilmCentral));
    let lambda = smallest(solved, |point| {
        let mixed = point.outcome.solution()?.mixed.as_ref()?;
        Some(Marked::from(mixed.lambda_minimum))
    });
    let figure = |name, words, unit, estimate: Option<Marked>| {
        Some(Section::Films.figure(name, words, estimate?, unit, ""))
    };
    [
        figure("film_central", "smallest central film", "m", central),
        figure("film_minimum", "smallest film", "m", film),
        figure("lambda_minimum", "λ (minimum film / σ)", "", lambda),
    ]
    .into_iter()
    .flatten()
    .collect()
}
