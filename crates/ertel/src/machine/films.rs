//! Films of the contacts of a machine, solved or by formulas.

use super::contacts::{Values, each, figure_of};
use crate::case::{Case, WholeMachine};
use crate::contact::Family;
use crate::estimate::{FilmEstimate, films};
use crate::mark::Marked;
use crate::point::{MachineSolution, distinct};
use crate::solution::Figure;

/// Films of all contacts.
pub(super) struct Films {
    /// Central films, m.
    pub central: Values,
    /// Minimum films, m.
    pub minimum: Values,
    /// Minimum films over the composite roughness.
    pub lambda: Values,
    /// How they are known.
    pub by: By,
}

/// How the films of a machine are known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum By {
    /// By the solution of each contact.
    Solution,
    /// By formulas for contacts of this family.
    Formulas(Family),
}

impl By {
    /// The source of films; empty of solved ones.
    pub fn source(self) -> &'static str {
        match self {
            By::Solution => "",
            By::Formulas(Family::Point) => {
                "films by formulas, isothermal and Newtonian: central Nijenbanning-Venner-Moes 1994, minimum Hamrock-Dowson 1977"
            }
            By::Formulas(Family::Cylinder) => {
                "films by formulas, isothermal and Newtonian: central Moes (line), minimum Dowson-Higginson 1977"
            }
        }
    }
}

impl Films {
    /// Those of the solved contacts.
    pub fn solved(solved: &MachineSolution) -> Films {
        Films {
            central: each(solved, |point| figure_of(point, Figure::FilmCentral)),
            minimum: each(solved, |point| figure_of(point, Figure::FilmMinimum)),
            lambda: each(solved, |point| {
                let mixed = point.outcome.solution()?.mixed.as_ref()?;
                Some(Marked::from(mixed.lambda_minimum))
            }),
            by: By::Solution,
        }
    }

    /// Those of formulas for the contacts of a case; none of a case with a `[curve]`, whose points have the contacts.
    pub fn by_formulas(case: &Case, machine: &WholeMachine) -> Films {
        let points = case.contacts.iter().flat_map(|of| &of.study.points);
        let mut of: Vec<Option<FilmEstimate>> = vec![None; machine.contacts.len()];
        for (i, point) in distinct(machine).into_iter().zip(points) {
            of[i] = Some(films(&point.case));
        }
        let value = |value: &dyn Fn(&FilmEstimate) -> Option<f64>| -> Values {
            let like = machine.contacts.iter().map(|contact| contact.like);
            like.map(|like| Some(Marked::exact(value(of[like?].as_ref()?)?)))
                .collect()
        };
        Films {
            central: value(&|film| Some(film.central)),
            minimum: value(&|film| film.minimum),
            lambda: value(&|film| Some(film.minimum? / case.roughness?)),
            by: By::Formulas(case.contact.kind.family()),
        }
    }

    /// The contact with the smallest film, by its place among the contacts.
    pub fn thinnest(&self) -> Option<usize> {
        let films = self.minimum.iter().enumerate();
        let films = films.filter_map(|(i, film)| Some((i, film.as_ref()?.value)));
        let (i, _) = films.min_by(|a, b| a.1.total_cmp(&b.1))?;
        Some(i)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reference::FilmFormula;

    /// The sources name the formulas that the estimates use.
    #[test]
    fn sources_name_the_formulas() {
        for (family, central, minimum) in [
            (
                Family::Point,
                FilmFormula::NijenbanningVennerMoes,
                FilmFormula::HamrockDowson,
            ),
            (
                Family::Cylinder,
                FilmFormula::MoesLine,
                FilmFormula::DowsonHigginson,
            ),
        ] {
            let source = By::Formulas(family).source();
            for formula in [central, minimum] {
                assert!(source.contains(formula.name()), "{source}");
            }
        }
    }
}
