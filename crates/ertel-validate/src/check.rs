//! Comparisons.

use super::Quantity;
use super::outcome::{Outcome, Run};
use super::place::{Place, film_at};
use ertel::fit::{FilmForm, FilmState};
use ertel::reference::FilmFormula;
use ertel::solution::Solution;

/// Reference of a comparison.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Reference {
    /// A published value.
    Value(f64),
    /// A formula, evaluated for the case; for an incompressible fluid's formula the flag asks for
    /// its film divided by the relative density at the Hertz pressure.
    Formula(FilmFormula, bool),
    /// A power law `h = c R √(2U) M^a L^b` with these c, a and b, evaluated for the case.
    PowerLaw([f64; 3]),
    /// Nothing: our figure is shown.
    Nothing,
}

/// When a figure is accepted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Accept {
    /// |ours/reference − 1| at most this.
    Relative(f64),
    /// |ours − reference| at most this.
    Absolute(f64),
    /// |ours| at most this.
    AtMost(f64),
    /// Ours within these bounds.
    Between(f64, f64),
    /// Ours has the reference's sign.
    Sign,
    /// Shown only.
    Anything,
}

/// How a figure is made from the quantity of the runs.
#[derive(Clone, Debug, PartialEq)]
pub enum Subject {
    /// The value, of each of these runs.
    Value(Vec<usize>),
    /// Relative change from the second run to the first; for differences of fields, between them.
    Change(usize, usize),
    /// Observed order of convergence over three meshes, each with cells half as large.
    Order([usize; 3]),
}

impl Subject {
    /// The runs that it looks at.
    pub(super) fn runs(&self) -> Vec<usize> {
        match self {
            Subject::Value(runs) => runs.clone(),
            Subject::Change(i, j) => vec![*i, *j],
            Subject::Order(runs) => runs.to_vec(),
        }
    }
}

/// A comparison to make.
#[derive(Clone, Debug)]
pub struct Check {
    /// The figure.
    pub quantity: Quantity,
    /// Of which runs.
    pub subject: Subject,
    /// Where and when, of [`Quantity::FilmAt`].
    pub place: Option<Place>,
    /// Against what.
    pub reference: Reference,
    /// With which tolerance.
    pub accept: Accept,
    /// Whose value it is.
    pub source: String,
    /// Why this tolerance.
    pub reason: String,
}

/// How a comparison ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Within the tolerance.
    Holds,
    /// Not.
    Fails,
    /// Shown without a tolerance.
    Shown,
}

/// One line of the table.
#[derive(Clone, Debug)]
pub struct Row {
    /// Run or runs.
    pub run: String,
    /// The compared quantity.
    pub label: String,
    /// Whose value it is.
    pub source: String,
    /// Published value.
    pub reference: Option<f64>,
    /// Our value; `None` if the run failed.
    pub ours: Option<f64>,
    /// When it is accepted.
    pub accept: Accept,
    /// The values are shares, shown in per cent.
    pub is_share: bool,
    /// How it ended.
    pub verdict: Verdict,
    /// Error message of a failed run.
    pub message: Option<String>,
}

impl Row {
    /// A failed run.
    pub(super) fn failure(run: &str, message: &str) -> Row {
        Row {
            run: run.to_owned(),
            label: "solve".to_owned(),
            source: String::new(),
            reference: None,
            ours: None,
            accept: Accept::Anything,
            is_share: false,
            verdict: Verdict::Fails,
            message: Some(message.to_owned()),
        }
    }

    pub(super) fn new(
        run: &str,
        quantity: Quantity,
        reference: Reference,
        ours: f64,
        accept: Accept,
        source: &str,
    ) -> Row {
        let value = match reference {
            Reference::Value(v) => Some(v),
            _ => None,
        };
        Row::with_value(run, quantity.label(), value, ours, accept, source)
    }

    fn with_value(
        run: &str,
        label: &str,
        reference: Option<f64>,
        ours: f64,
        accept: Accept,
        source: &str,
    ) -> Row {
        let holds = match (accept, reference) {
            (Accept::Anything, _) => None,
            (Accept::AtMost(limit), _) => Some(ours.abs() <= limit),
            (Accept::Between(low, high), _) => Some(low <= ours && ours <= high),
            (Accept::Relative(limit), Some(r)) => Some((ours / r - 1.0).abs() <= limit),
            (Accept::Absolute(limit), Some(r)) => Some((ours - r).abs() <= limit),
            (Accept::Sign, Some(r)) => Some(ours * r > 0.0),
            // A comparison without a value to compare with cannot hold.
            (_, None) => Some(false),
        };
        Row {
            run: run.to_owned(),
            label: label.to_owned(),
            source: source.to_owned(),
            reference,
            ours: Some(ours),
            accept,
            is_share: false,
            verdict: match holds {
                None => Verdict::Shown,
                Some(true) => Verdict::Holds,
                Some(false) => Verdict::Fails,
            },
            message: None,
        }
    }
}

impl Check {
    /// Rows of this comparison; none for runs that were skipped or failed.
    pub(super) fn rows(&self, runs: &[Run], outcomes: &[Outcome]) -> Vec<Row> {
        let value = |i: usize, other: Option<usize>| match (self.place, &outcomes[i]) {
            (Some(place), Outcome::Transient(found)) => film_at(&found.profiles, place),
            (Some(_), _) => None,
            (None, outcome) => {
                let other = other.map(|j| &outcomes[j]);
                self.quantity.value(&runs[i], outcome, other)
            }
        };
        let row = |run: &str, label: &str, reference, ours| {
            Row::with_value(run, label, reference, ours, self.accept, &self.source)
        };
        let label = match self.place {
            Some(place) => &place.words(),
            None => self.quantity.label(),
        };
        match &self.subject {
            Subject::Value(list) => list
                .iter()
                .filter_map(|i| {
                    let ours = value(*i, None)?;
                    let reference = match (&self.reference, &outcomes[*i]) {
                        (Reference::Value(v), _) => Some(*v),
                        (Reference::Formula(f, compressed), Outcome::Solved(s)) => {
                            formula_film(*f, *compressed, self.quantity, &runs[*i], s)
                        }
                        (Reference::PowerLaw(constants), Outcome::Solved(s)) => {
                            Some(power_law_film(constants, &runs[*i], s))
                        }
                        _ => None,
                    };
                    let mut row = row(&runs[*i].name, label, reference, ours);
                    row.is_share = self.quantity.is_share();
                    Some(row)
                })
                .collect(),
            Subject::Change(i, j) => {
                let names = format!("{} / {}", runs[*i].name, runs[*j].name);
                let ours = if self.quantity == Quantity::DeflectionDifference {
                    value(*i, Some(*j))
                } else {
                    value(*i, None)
                        .zip(value(*j, None))
                        .map(|(a, b)| a / b - 1.0)
                };
                let reference = match self.reference {
                    Reference::Value(v) => Some(v),
                    _ => None,
                };
                ours.map(|ours| {
                    let label = match self.quantity {
                        Quantity::DeflectionDifference => label.to_owned(),
                        _ => format!("{label}, change"),
                    };
                    Row {
                        is_share: true,
                        ..row(&names, &label, reference, ours)
                    }
                })
                .into_iter()
                .collect()
            }
            Subject::Order([i, j, k]) => {
                let names = format!("{}, {}, {}", runs[*i].name, runs[*j].name, runs[*k].name);
                let values = [*i, *j, *k].map(|r| value(r, None));
                let [Some(a), Some(b), Some(c)] = values else {
                    return Vec::new();
                };
                let order = ((a - b).abs() / (b - c).abs()).log2();
                vec![row(&names, &format!("{label}, order"), None, order)]
            }
        }
    }
}

/// Dimensionless film of a formula for the case of a solution.
fn formula_film(
    formula: FilmFormula,
    compressed: bool,
    quantity: Quantity,
    run: &Run,
    solution: &Solution,
) -> Option<f64> {
    let (contact, groups) = (&run.case.contact, &solution.groups);
    let (central, minimum) = match compressed {
        true => formula.film_of_compressible(contact, groups, run.case.relative_density()),
        false => formula.film(contact, groups),
    };
    let film = match quantity {
        Quantity::CentralFilm => central?,
        Quantity::MinimumFilm => minimum?,
        _ => return None,
    };
    Some(film / solution.scales.film)
}

/// Dimensionless film of a power law for the case of a solution.
fn power_law_film(constants: &[f64; 3], run: &Run, solution: &Solution) -> f64 {
    let groups = &solution.groups;
    let state = FilmState {
        film: f64::NAN,
        scale: run.case.contact.radius * (2.0 * groups.speed).sqrt(),
        variables: vec![groups.moes_load, groups.moes_material],
        error: None,
    };
    FilmForm::Moes.film(constants, &state) / solution.scales.film
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn verdicts() {
        let verdict = |reference, ours, accept| {
            Row::with_value("r", "q", reference, ours, accept, "s").verdict
        };
        use Verdict::{Fails, Holds, Shown};
        for (reference, ours, accept, expected) in [
            (Some(0.08), 0.0807, Accept::Relative(0.01), Holds),
            (Some(0.08), 0.0809, Accept::Relative(0.01), Fails),
            (Some(0.08), 0.0791, Accept::Relative(0.01), Fails),
            (Some(14.0), 15.0, Accept::Absolute(1.0), Holds),
            (Some(14.0), 12.0, Accept::Absolute(1.0), Fails),
            (None, -0.02, Accept::AtMost(0.01), Fails),
            (None, -0.005, Accept::AtMost(0.01), Holds),
            (None, 1.5, Accept::Between(2.0, 4.0), Fails),
            (None, 3.0, Accept::Between(2.0, 4.0), Holds),
            (Some(-0.4), -0.01, Accept::Sign, Holds),
            (Some(-0.4), 0.01, Accept::Sign, Fails),
            (Some(1.0), f64::NAN, Accept::Relative(0.1), Fails),
            (Some(1.0), f64::NAN, Accept::AtMost(0.1), Fails),
            (None, 1.0, Accept::Relative(0.1), Fails),
            (Some(1.0), 2.0, Accept::Anything, Shown),
        ] {
            assert_eq!(
                verdict(reference, ours, accept),
                expected,
                "{ours} {accept:?}"
            );
        }
    }
}
