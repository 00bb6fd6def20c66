//! Figures of whole machines: from the solutions of their contacts to friction, heat, safety and life.

mod bearing;
mod cam;
mod collected;
mod contacts;
mod courses;
mod curve;
mod gears;
mod heat;
mod life;
mod moments;
mod path;
mod rolling;
mod slip;

pub(crate) use heat::solve_by;
pub use heat::{Balance, SolvedMachine};

use self::contacts::figure_of;
use self::curve::Curve;
use crate::case::{Case, Mechanics};
use crate::figures::Row;
use crate::figures::machine::{
    ASPERITY_LOAD_SHARE_MAXIMUM, FILM_CENTRAL, FILM_MINIMUM, LAMBDA_MINIMUM,
    ORTHOGONAL_SHEAR_MAXIMUM, VON_MISES_MAXIMUM,
};
use crate::mark::Marked;
pub use crate::point::MachineFigures;
use crate::point::{MachineSolution, PointSolution};
use crate::solution::Figure;
use crate::warning::silence;

/// The figures of a machine; sums and extremes over its contacts only where all of them are solved: the thinnest film may be that of a contact which is missing.
pub fn figures(case: &Case, solved: &MachineSolution) -> MachineFigures {
    let courses = courses::courses(case, solved);
    let unsolved;
    let solved = match solved.n_solved() < solved.n_contacts() {
        true => {
            unsolved = solved.unsolved();
            &unsolved
        }
        false => solved,
    };
    let mut all = films(solved);
    all.extend(stresses(solved));
    let mut warnings = Vec::new();
    match &solved.machine.mechanics {
        Mechanics::Bearing(bearing) => {
            all.extend(bearing::figures(case, bearing, solved, &mut warnings));
        }
        Mechanics::Gears(gears) => all.extend(gears::figures(case, gears, solved, &mut warnings)),
        Mechanics::Cam(cam) => all.extend(cam::figures(cam, solved)),
    }
    silence(&mut warnings, &case.output.silence);
    MachineFigures {
        all,
        courses,
        warnings,
    }
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

/// The smallest film of all, the smallest film over roughness, and the largest load share of asperities.
fn films(solved: &MachineSolution) -> Vec<Row> {
    let film = smallest(solved, |point| figure_of(point, Figure::FilmMinimum));
    let central = smallest(solved, |point| figure_of(point, Figure::FilmCentral));
    let lambda = smallest(solved, |point| {
        let mixed = point.outcome.solution()?.mixed.as_ref()?;
        Some(Marked::from(mixed.lambda_minimum))
    });
    let share = |point: &PointSolution| figure_of(point, Figure::AsperityLoadShare);
    let share = smallest(solved, |point| Some(share(point)? * -1.0)).map(|least| least * -1.0);
    [
        (FILM_CENTRAL, central),
        (FILM_MINIMUM, film),
        (LAMBDA_MINIMUM, lambda),
        (ASPERITY_LOAD_SHARE_MAXIMUM, share),
    ]
    .into_iter()
    .filter_map(|(figure, estimate)| Some(figure.row(estimate?, "")))
    .collect()
}

/// The largest stresses in the bodies of all contacts.
fn stresses(solved: &MachineSolution) -> Vec<Row> {
    let largest = |figures: [Figure; 2]| {
        // The smallest of the negative values.
        let of = |point: &PointSolution| {
            let bodies = figures.into_iter().filter_map(|f| figure_of(point, f));
            let largest = bodies.max_by(|a, b| a.value.total_cmp(&b.value));
            Some(largest? * -1.0)
        };
        Some(smallest(solved, of)? * -1.0)
    };
    [
        (
            VON_MISES_MAXIMUM,
            largest([Figure::VonMisesBody1, Figure::VonMisesBody2]),
        ),
        (
            ORTHOGONAL_SHEAR_MAXIMUM,
            largest([Figure::OrthogonalShearBody1, Figure::OrthogonalShearBody2]),
        ),
    ]
    .into_iter()
    .filter_map(|(figure, estimate)| Some(figure.row(estimate?, "")))
    .collect()
}
