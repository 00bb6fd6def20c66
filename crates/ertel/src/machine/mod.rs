//! Figures of whole machines: from the solutions of their contacts to friction, heat, safety and life.

mod at_contacts;
mod bearing;
mod cam;
mod collected;
mod contacts;
mod curve;
mod estimate;
mod films;
mod gears;
mod heat;
mod life;
mod moments;
mod path;
mod rolling;
mod slip;

pub use estimate::MachineEstimate;
pub(crate) use heat::solve_by;
pub use heat::{Balance, SolvedMachine};

use self::contacts::{Values, each, figure_of};
use self::curve::Curve;
use self::films::Films;
use crate::case::{Case, Mechanics, WholeMachine};
use crate::figures::Row;
use crate::figures::machine::{
    ASPERITY_LOAD_SHARE_MAXIMUM, FILM_CENTRAL, FILM_MINIMUM, LAMBDA_MINIMUM,
    ORTHOGONAL_SHEAR_MAXIMUM, VON_MISES_MAXIMUM,
};
use crate::mark::Marked;
pub use crate::point::MachineFigures;
use crate::point::MachineSolution;
use crate::solution::Figure;
use crate::warning::silence;

/// The figures of a machine; sums and extremes over its contacts only where all of them are solved: the thinnest film may be that of a contact which is missing.
pub fn figures(case: &Case, solved: &MachineSolution) -> MachineFigures {
    let films = Films::solved(solved);
    let at_contacts = at_contacts::figures(case, &solved.machine, &films, Some(solved));
    let unsolved;
    let solved = match solved.n_solved() < solved.n_contacts() {
        true => {
            unsolved = solved.unsolved();
            &unsolved
        }
        false => solved,
    };
    let films = Films::solved(solved);
    let mut all = film_rows(&solved.machine, &films);
    all.extend(asperities(solved));
    all.extend(stresses(solved));
    let mut warnings = Vec::new();
    match &solved.machine.mechanics {
        Mechanics::Bearing(bearing) => {
            all.extend(bearing::figures(case, bearing, solved, &mut warnings));
        }
        Mechanics::Gears(gears) => {
            all.extend(gears::figures(case, gears, solved, &films, &mut warnings));
        }
        Mechanics::Cam(cam) => all.extend(cam::figures(cam, solved, &films)),
    }
    silence(&mut warnings, &case.output.silence);
    MachineFigures {
        all,
        at_contacts,
        warnings,
    }
}

/// Closed forms of a whole machine, before its contacts are solved; `None` of single contacts.
pub fn estimate(case: &Case) -> Option<MachineEstimate> {
    let machine = case.whole.clone()?;
    let films = Films::by_formulas(case, &machine);
    let mut all = film_rows(&machine, &films);
    let mut warnings = Vec::new();
    all.extend(match &machine.mechanics {
        Mechanics::Bearing(bearing) => bearing::estimate(case, bearing, &mut warnings),
        Mechanics::Gears(gears) => gears::estimate(case, &machine, gears, &films),
        Mechanics::Cam(cam) => cam::estimate(cam, &films),
    });
    silence(&mut warnings, &case.output.silence);
    Some(MachineEstimate {
        absent: estimate::absent(case, &machine.mechanics, &all),
        figures: MachineFigures {
            all,
            at_contacts: at_contacts::figures(case, &machine, &films, None),
            warnings,
        },
        films: [films.central, films.minimum],
        machine,
    })
}

/// The smallest value of all contacts. Along a path and over a turn its bar allows for what lies between the contacts.
fn smallest(machine: &WholeMachine, values: &Values) -> Option<Marked> {
    let values = machine.contacts.iter().zip(values);
    let values = values.filter_map(|(at, value)| Some((at.place, (*value)?)));
    let values: Vec<(f64, Marked)> = values.collect();
    match &machine.mechanics {
        Mechanics::Bearing(_) => {
            let values = values.into_iter().map(|(_, value)| value);
            values.min_by(|a, b| a.value.total_cmp(&b.value))
        }
        Mechanics::Gears(_) => Some(Curve::new(values)?.smallest().1),
        Mechanics::Cam(cam) => cam::smallest(cam, values),
    }
}

/// The largest value of all contacts, likewise.
fn largest(machine: &WholeMachine, values: &Values) -> Option<Marked> {
    let turned = values.iter().map(|value| Some((*value)? * -1.0)).collect();
    Some(smallest(machine, &turned)? * -1.0)
}

/// The smallest films, and the smallest film over roughness.
fn film_rows(machine: &WholeMachine, films: &Films) -> Vec<Row> {
    [
        (FILM_CENTRAL, &films.central),
        (FILM_MINIMUM, &films.minimum),
        (LAMBDA_MINIMUM, &films.lambda),
    ]
    .into_iter()
    .filter_map(|(figure, of)| Some(figure.row(smallest(machine, of)?, films.by.source())))
    .collect()
}

/// The largest load share of asperities.
fn asperities(solved: &MachineSolution) -> Option<Row> {
    let share = each(solved, |point| figure_of(point, Figure::AsperityLoadShare));
    Some(ASPERITY_LOAD_SHARE_MAXIMUM.row(largest(&solved.machine, &share)?, ""))
}

/// The largest stresses in the bodies of all contacts.
fn stresses(solved: &MachineSolution) -> Vec<Row> {
    let of = |figures: [Figure; 2]| {
        let in_bodies = each(solved, |point| {
            let bodies = figures.into_iter().filter_map(|f| figure_of(point, f));
            bodies.max_by(|a, b| a.value.total_cmp(&b.value))
        });
        largest(&solved.machine, &in_bodies)
    };
    [
        (
            VON_MISES_MAXIMUM,
            of([Figure::VonMisesBody1, Figure::VonMisesBody2]),
        ),
        (
            ORTHOGONAL_SHEAR_MAXIMUM,
            of([Figure::OrthogonalShearBody1, Figure::OrthogonalShearBody2]),
        ),
    ]
    .into_iter()
    .filter_map(|(figure, estimate)| Some(figure.row(estimate?, "")))
    .collect()
}
