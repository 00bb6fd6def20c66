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
    /// P at the spike near the outlet.
    SpikePressure,
    /// Variation of P on the centreline, |X| ≤ 0.8, beyond that of one rise and one fall.
    PressureOscillation,
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
    pub const ALL: [Quantity; 13] = [
        Quantity::CentralFilm,
        Quantity::MinimumFilm,
        Quantity::Outlet,
        Quantity::MinimumPressure,
        Quantity::MaximumPressure,
        Quantity::SpikePressure,
        Quantity::PressureOscillation,
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
            Quantity::SpikePressure => "spike-pressure",
            Quantity::PressureOscillation => "pressure-oscillation",
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
            Quantity::SpikePressure => "P of the spike",
            Quantity::PressureOscillation => "oscillation of P",
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
                    Quantity::SpikePressure => f.spike.map(|p| p.value / s.scales.pressure),
                    Quantity::PressureOscillation => {
                        let line = &s.centreline;
                        let inner = line
                            .x
                            .iter()
                            .zip(&line.pressure)
                            .filter(|(x, _)| x.abs() <= OSCILLATION_ZONE * s.scales.length)
                            .map(|(_, p)| p / s.scales.pressure);
                        Some(oscillation(&inner.collect::<Vec<_>>()))
                    }
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

/// Part of the Hertz zone where a heavily loaded contact's pressure is smooth: the inlet and the
/// spike lie outside.
const OSCILLATION_ZONE: f64 = 0.8;

/// Sum of all rises and falls beyond those of a profile that rises to its maximum and falls.
fn oscillation(values: &[f64]) -> f64 {
    let (Some(first), Some(last)) = (values.first(), values.last()) else {
        return 0.0;
    };
    let total: f64 = values.windows(2).map(|w| (w[1] - w[0]).abs()).sum();
    let top = values.iter().fold(f64::NEG_INFINITY, |m, v| m.max(*v));
    (total - (2.0 * top - first - last)).max(0.0)
}

#[cfg(test)]
mod tests {
    use super::oscillation;
    use approx::assert_relative_eq;

    /// By hand: one dip of 0.2 on the way up and one of 0.1 on the way down cost twice their depths.
    #[test]
    fn oscillation_counts_dips_twice() {
        let smooth = oscillation(&[0.1, 0.5, 1.0, 0.7, 0.2]);
        assert_relative_eq!(smooth, 0.0, epsilon = 1e-15);
        let dips = [0.1, 0.5, 0.3, 1.0, 0.6, 0.7, 0.2];
        assert_relative_eq!(oscillation(&dips), 0.6, epsilon = 1e-14);
        assert_eq!(oscillation(&[]), 0.0);
    }
}
