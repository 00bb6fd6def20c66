//! One case by two methods: finite elements and finite volumes share the contact, the fluid and the evaluation of a film, but not the
//! solver. Figures that agree within their error bars are confirmed independently.

use crate::case::{Case, finite_volumes_refuse};
use crate::engine::{Observer, SolveError};
use crate::params::Method;
use crate::run;
use crate::solution::{Figure, Located, Solution};

/// A figure by both methods.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossed {
    /// Which.
    pub figure: Figure,
    /// By the method of the case.
    pub own: Located,
    /// By the other method; `None` where it does not have it.
    pub other: Option<Located>,
}

/// Whether a figure is the same by both methods.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// They differ by no more than the sum of both error bars.
    Agrees,
    /// They differ by more.
    Differs,
    /// One of them is not resolved, or has no error bar.
    NotResolved,
    /// The other method does not have it.
    Missing,
}

impl Verdict {
    /// Short label.
    pub fn words(self) -> &'static str {
        match self {
            Verdict::Agrees => "agrees",
            Verdict::Differs => "differs",
            Verdict::NotResolved => "not resolved",
            Verdict::Missing => "missing",
        }
    }
}

impl Crossed {
    /// Value of the other method less that of the case's own, and the sum of both error bars; `None` without bars.
    pub fn difference(&self) -> Option<(f64, f64)> {
        let other = self.other?;
        let bars = self.own.error? + other.error?;
        Some((other.value - self.own.value, bars))
    }

    /// Whether both agree.
    pub fn verdict(&self) -> Verdict {
        let Some(other) = self.other else {
            return Verdict::Missing;
        };
        match self.difference() {
            Some((difference, bars)) if self.own.resolved && other.resolved => {
                match difference.abs() <= bars {
                    true => Verdict::Agrees,
                    false => Verdict::Differs,
                }
            }
            _ => Verdict::NotResolved,
        }
    }
}

/// All figures of a case by both methods.
#[derive(Clone, Debug, PartialEq)]
pub struct CrossCheck {
    /// The method of the case, and the other one.
    pub methods: [Method; 2],
    /// Wall seconds of both.
    pub seconds: [f64; 2],
    /// The figures that the case's own method has.
    pub figures: Vec<Crossed>,
}

impl CrossCheck {
    /// Figures with some verdict.
    pub fn count(&self, verdict: Verdict) -> usize {
        (self.figures.iter())
            .filter(|crossed| crossed.verdict() == verdict)
            .count()
    }
}

/// Reason why a case cannot be solved by the other method; `None` where it can.
pub fn why_not(case: &Case) -> Option<String> {
    if let Some(part) = case.only_by_volumes() {
        return Some(format!("{part} are solved by finite volumes alone"));
    }
    match case.solver.method {
        Some(Method::FiniteVolumes) => None,
        _ => finite_volumes_refuse(case)
            .map(|reason| format!("{} {reason}", Method::FiniteVolumes.words())),
    }
}

/// Solves a case by the other method, and compares.
///
/// # Errors
/// As [`run::solve`] has them.
pub fn cross_check(
    case: &Case,
    own: &Solution,
    observer: &mut dyn Observer,
) -> Result<CrossCheck, SolveError> {
    let methods = [own.stats.method, own.stats.method.other()];
    let mut crossed = case.clone();
    crossed.solver.method = Some(methods[1]);
    // A limit in unknowns of one method does not apply to the other.
    crossed.mesh.max_unknowns = None;
    let other = run::solve(&crossed, observer)?;
    let figures = (own.figures())
        .map(|(figure, own)| Crossed {
            figure,
            own,
            other: other.figure(figure),
        })
        .collect();
    Ok(CrossCheck {
        methods,
        seconds: [own.stats.wall_seconds, other.stats.wall_seconds],
        figures,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn located(value: f64, error: Option<f64>, resolved: bool) -> Located {
        Located {
            value,
            error,
            resolved,
            x: 0.0,
            y: 0.0,
            place_error: None,
            place_resolved: true,
        }
    }

    /// By hand: 1.00 ± 0.02 and 1.04 ± 0.03 agree, and do not if the bars are half as wide; without a bar, or with one too wide, nothing is said.
    #[test]
    fn verdicts_by_hand() {
        let crossed = |own: Located, other: Option<Located>| Crossed {
            figure: Figure::FilmCentral,
            own,
            other,
        };
        let of = |a: f64, b: f64| {
            crossed(
                located(1.0, Some(a), true),
                Some(located(1.04, Some(b), true)),
            )
            .verdict()
        };
        assert_eq!(of(0.02, 0.03), Verdict::Agrees);
        assert_eq!(of(0.01, 0.015), Verdict::Differs);
        let bare = crossed(
            located(1.0, None, true),
            Some(located(1.0, Some(0.1), true)),
        );
        assert_eq!(bare.verdict(), Verdict::NotResolved);
        let wide = crossed(
            located(1.0, Some(0.1), true),
            Some(located(1.0, Some(0.9), false)),
        );
        assert_eq!(wide.verdict(), Verdict::NotResolved);
        assert_eq!(
            crossed(located(1.0, None, true), None).verdict(),
            Verdict::Missing
        );
    }
}
