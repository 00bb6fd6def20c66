//! Quantities that are compared.

use super::run::{Outcome, Run};

/// A figure of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// H_c = h_c R/a².
    CentralFilm,
    /// H_m = h_m R/a², the smallest anywhere.
    MinimumFilm,
    /// X at which the film breaks on the centreline.
    Outlet,
    /// Most negative P.
    MinimumPressure,
    /// Largest P.
    MaximumPressure,
    /// Mass balance error of the film between inlet and centre.
    FilmBalance,
    /// Newton iterations of a cold start, all levels together.
    NewtonIterations,
    /// Largest deviation of the deflection from Hertz theory on |X| ≤ 1, over the central one.
    DeflectionError,
    /// The same without the deviation at the centre, which the rigid displacement takes up.
    DeflectionShapeError,
    /// Largest difference of the deflections of two runs on |X| ≤ 1, over the central one.
    DeflectionDifference,
    /// Unknowns: displacements, and pressures where they are solved for.
    Unknowns,
}

impl Quantity {
    /// Every quantity.
    pub const ALL: [Quantity; 11] = [
        Quantity::CentralFilm,
        Quantity::MinimumFilm,
        Quantity::Outlet,
        Quantity::MinimumPressure,
        Quantity::MaximumPressure,
        Quantity::FilmBalance,
        Quantity::NewtonIterations,
        Quantity::DeflectionError,
        Quantity::DeflectionShapeError,
        Quantity::DeflectionDifference,
        Quantity::Unknowns,
    ];

    /// Name in `reference.toml`.
    pub fn key(self) -> &'static str {
        match self {
            Quantity::CentralFilm => "central-film",
            Quantity::MinimumFilm => "minimum-film",
            Quantity::Outlet => "outlet",
            Quantity::MinimumPressure => "minimum-pressure",
            Quantity::MaximumPressure => "maximum-pressure",
            Quantity::FilmBalance => "film-balance",
            Quantity::NewtonIterations => "newton-iterations",
            Quantity::DeflectionError => "deflection-error",
            Quantity::DeflectionShapeError => "deflection-shape-error",
            Quantity::DeflectionDifference => "deflection-difference",
            Quantity::Unknowns => "unknowns",
        }
    }

    /// Name in tables.
    pub fn label(self) -> &'static str {
        match self {
            Quantity::CentralFilm => "H_c",
            Quantity::MinimumFilm => "H_m",
            Quantity::Outlet => "X_out",
            Quantity::MinimumPressure => "min P",
            Quantity::MaximumPressure => "max P",
            Quantity::FilmBalance => "balance error",
            Quantity::NewtonIterations => "Newton iterations",
            Quantity::DeflectionError => "deflection error",
            Quantity::DeflectionShapeError => "shape error",
            Quantity::DeflectionDifference => "deflection difference",
            Quantity::Unknowns => "unknowns",
        }
    }

    /// Whether it counts something.
    pub fn is_count(self) -> bool {
        matches!(self, Quantity::NewtonIterations | Quantity::Unknowns)
    }

    /// Value in the outcome of a run, `None` where it has no such figure; `other` is the run that
    /// differences are taken from.
    pub fn value(self, run: &Run, outcome: &Outcome, other: Option<&Outcome>) -> Option<f64> {
        match outcome {
            Outcome::Solved(s) => {
                let f = &s.summary;
                let last = s.stats.levels.last();
                match self {
                    Quantity::CentralFilm => Some(f.film_central.value / s.scales.film),
                    Quantity::MinimumFilm => Some(f.film_minimum.value / s.scales.film),
                    Quantity::Outlet => Some(f.outlet_position / s.scales.length),
                    Quantity::MinimumPressure => Some(f.pressure_minimum / s.scales.pressure),
                    Quantity::MaximumPressure => Some(f.pressure_maximum.value / s.scales.pressure),
                    Quantity::FilmBalance => Some(f.film_balance_error.abs()),
                    Quantity::NewtonIterations => Some(
                        s.stats
                            .levels
                            .iter()
                            .map(|l| l.newton_iterations)
                            .sum::<usize>() as f64,
                    ),
                    Quantity::Unknowns => {
                        last.map(|l| (l.n_displacement_dofs + l.n_pressure_dofs) as f64)
                    }
                    Quantity::DeflectionError
                    | Quantity::DeflectionShapeError
                    | Quantity::DeflectionDifference => None,
                }
            }
            Outcome::Deflected(d) => {
                let kind = run.case.contact.kind;
                match (self, other) {
                    (Quantity::DeflectionError, _) => Some(d.error(kind)),
                    (Quantity::DeflectionShapeError, _) => Some(d.shape_error(kind)),
                    (Quantity::DeflectionDifference, Some(Outcome::Deflected(other))) => {
                        d.difference(other)
                    }
                    (Quantity::Unknowns, _) => Some(d.n_displacement_dofs as f64),
                    _ => None,
                }
            }
            Outcome::Failed(_) | Outcome::Skipped => None,
        }
    }
}
