//! The columns of the tables of curves and studies: every figure of the registry, then derived figures.

use std::fmt;

use super::{Outcome, PointSolution};
use crate::figures::Row;
use crate::mark::{Mark, Marked, of_figure};
use crate::solution::{Estimate, Figure, Kind, MixedLubrication, Solution, Thermal, Unresolved};

/// A column of a table, followed by that of its error bar if it has one.
#[derive(Clone, Copy)]
pub struct Column {
    /// Name in the header, without the unit.
    pub name: &'static str,
    source: Source,
}

/// Where the values of a column come from.
#[derive(Clone, Copy)]
enum Source {
    /// A figure of the registry.
    Figure(Figure),
    /// Something else with an error bar.
    Estimate(Kind, fn(&PointSolution) -> Option<Estimate>),
    /// Anything else, with its unit as the name ends with it.
    Plain(&'static str, fn(&PointSolution) -> Cell),
}

impl Column {
    /// The column of a figure.
    pub const fn of(figure: Figure) -> Column {
        Column {
            name: figure.name(),
            source: Source::Figure(figure),
        }
    }

    const fn estimate(
        name: &'static str,
        kind: Kind,
        value: fn(&PointSolution) -> Option<Estimate>,
    ) -> Column {
        let source = Source::Estimate(kind, value);
        Column { name, source }
    }

    const fn plain(
        name: &'static str,
        unit: &'static str,
        value: fn(&PointSolution) -> Cell,
    ) -> Column {
        let source = Source::Plain(unit, value);
        Column { name, source }
    }

    /// Title of the column in line or other contacts: the name, and the unit as `N_per_m`.
    pub fn title(&self, is_line: bool) -> String {
        self.with_unit(self.name, is_line)
    }

    /// Title of the column of its error bar, if it has one.
    pub fn error_title(&self, is_line: bool) -> Option<String> {
        match self.source {
            Source::Figure(_) | Source::Estimate(..) => {
                Some(self.with_unit(&format!("{}_error", self.name), is_line))
            }
            Source::Plain(..) => None,
        }
    }

    fn with_unit(&self, name: &str, is_line: bool) -> String {
        let unit = match self.source {
            Source::Figure(figure) => figure.unit(is_line),
            Source::Estimate(kind, _) => kind.unit(is_line),
            Source::Plain(unit, _) => unit,
        };
        titled(name, unit)
    }

    /// Titles with the cells of a point: value and error bar, or the value alone.
    pub fn fields(&self, point: &PointSolution, is_line: bool) -> Vec<(String, Cell)> {
        let cells = self.cells(point);
        let titles = std::iter::once(self.title(is_line)).chain(self.error_title(is_line));
        titles.zip(cells).collect()
    }

    /// The cells of a point.
    fn cells(&self, point: &PointSolution) -> Vec<Cell> {
        let of = |estimate: Option<Estimate>| {
            let error = estimate.and_then(|e| e.error);
            vec![estimate.map(|e| e.value).into(), error.into()]
        };
        match self.source {
            Source::Figure(figure) => of(solved(point, figure).map(|at| at.estimate())),
            Source::Estimate(_, value) => of(value(point)),
            Source::Plain(_, value) => vec![value(point)],
        }
    }

    /// Whether the value of a point is to be used: its error bar is narrow enough for a number, and no mark forbids it.
    fn is_usable(&self, point: &PointSolution) -> bool {
        match self.source {
            Source::Figure(figure) => {
                let doubtful = |s: &Solution| of_figure(s, figure).iter().any(Mark::forbids);
                solved(point, figure).is_none_or(|at| at.resolved)
                    && !point.outcome.solution().is_some_and(doubtful)
            }
            Source::Estimate(_, value) => value(point).is_none_or(|e| e.is_resolved()),
            Source::Plain(..) => true,
        }
    }
}

/// A name with its unit as `N_per_m`.
pub(crate) fn titled(name: &str, unit: &str) -> String {
    match unit {
        "" => name.to_owned(),
        unit => format!("{name}_{}", unit.replace('/', "_per_").replace(' ', "_")),
    }
}

/// Titles with the cells of a point: of a single contact those of all columns, of a whole machine and of a case in time their figures.
pub fn point_fields(point: &PointSolution, is_line: bool) -> Vec<(String, Cell)> {
    if point.machine.is_none() && !point.is_in_time {
        return columns().flat_map(|c| c.fields(point, is_line)).collect();
    }
    let text = |name: &str, text: String| (name.to_owned(), Cell::Text(text));
    let count = |name: &str, n: usize| (name.to_owned(), Cell::Count(n));
    let mut fields = vec![text("converged", point.outcome.is_solved().to_string())];
    if let Some(machine) = &point.machine {
        let solution = &machine.solution;
        fields.push(count("contacts", solution.n_contacts()));
        fields.push(count("contacts_failed", solution.n_failed()));
    }
    fields.extend(point.rows().iter().flat_map(row_fields));
    let names = match point.outcome.in_time() {
        Some(run) => {
            let [steps, refused] = run.steps;
            fields.extend([
                count("steps", steps),
                count("refused_steps", refused),
                count("newton_iterations", run.newton_iterations),
            ]);
            Some(run.unresolved.clone())
        }
        None if point.is_in_time => None,
        None => {
            let solutions = point.solutions();
            let sum = |of: fn(&Solution) -> usize| solutions.iter().map(|s| of(s)).sum();
            fields.extend([
                count("newton_iterations", sum(newton_iterations)),
                count("krylov_iterations", sum(krylov_iterations)),
            ]);
            let names = solutions.iter().flat_map(|s| &s.unresolved);
            Some(distinct(names.map(Unresolved::name)))
        }
    };
    if let Some(names) = names {
        let uncertain = (point.rows().iter()).filter(|row| row.estimate.is_doubtful());
        let uncertain: Vec<&str> = uncertain.map(|row| row.figure.name).collect();
        fields.extend([
            text("unresolved", names.join(" ")),
            text("uncertain_figures", uncertain.join(" ")),
            text("warnings", warnings(point)),
        ]);
    }
    let reason = point.outcome.reason().unwrap_or_default();
    fields.extend([
        ("seconds".to_owned(), Cell::Number(point.seconds)),
        text("reason", reason.to_owned()),
    ]);
    fields
}

/// A figure of a machine or a run with its error bar and its instant.
fn row_fields(row: &Row) -> Vec<(String, Cell)> {
    let (name, Marked { value, error, .. }) = (row.figure.name, row.estimate);
    let mut fields = vec![(titled(name, row.unit), Cell::Number(value))];
    if row.figure.has_bar() {
        fields.push((titled(&format!("{name}_error"), row.unit), error.into()));
    }
    if let Some(time) = row.time {
        fields.push((titled(&format!("{name}_time"), "s"), Cell::Number(time)));
    }
    fields
}

/// Each name once, in order.
fn distinct(names: impl Iterator<Item = &'static str>) -> Vec<&'static str> {
    let mut all: Vec<&str> = Vec::new();
    for name in names {
        if !all.contains(&name) {
            all.push(name);
        }
    }
    all
}

fn newton_iterations(solution: &Solution) -> usize {
    solution
        .stats
        .levels
        .iter()
        .map(|l| l.newton_iterations)
        .sum()
}

fn krylov_iterations(solution: &Solution) -> usize {
    solution
        .stats
        .levels
        .iter()
        .map(|l| l.krylov_iterations)
        .sum()
}

/// Titles of several points in their order, each once: points of a machine may lack figures that others have.
pub(crate) fn joint_titles<'a>(points: impl IntoIterator<Item = Vec<&'a str>>) -> Vec<&'a str> {
    let mut titles: Vec<&str> = Vec::new();
    for own in points {
        if own == titles {
            continue;
        }
        let mut place = 0;
        for title in own {
            match titles.iter().position(|known| *known == title) {
                Some(at) => place = at + 1,
                None => {
                    titles.insert(place, title);
                    place += 1;
                }
            }
        }
    }
    titles
}

fn solved(point: &PointSolution, figure: Figure) -> Option<crate::solution::Located> {
    point.outcome.solution()?.figure(figure)
}

/// A value of a table.
#[derive(Clone, Debug, PartialEq)]
pub enum Cell {
    /// There is none: an empty field.
    Empty,
    /// A number.
    Number(f64),
    /// A count.
    Count(usize),
    /// A text.
    Text(String),
}

impl fmt::Display for Cell {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Cell::Empty => Ok(()),
            Cell::Number(value) => write!(f, "{value:e}"),
            Cell::Count(value) => write!(f, "{value}"),
            Cell::Text(text) => f.write_str(text),
        }
    }
}

impl From<Option<f64>> for Cell {
    fn from(value: Option<f64>) -> Cell {
        value.map_or(Cell::Empty, Cell::Number)
    }
}

impl From<Option<usize>> for Cell {
    fn from(value: Option<usize>) -> Cell {
        value.map_or(Cell::Empty, Cell::Count)
    }
}

/// All columns, after the point's number and the quantity.
pub fn columns() -> impl Iterator<Item = Column> {
    let converged = Column::plain("converged", "", |point| {
        Cell::Text(point.outcome.is_solved().to_string())
    });
    let figures = Figure::ALL.into_iter().map(Column::of);
    std::iter::once(converged)
        .chain(figures)
        .chain(DERIVED.iter().copied())
}

/// Names of the figures of a point that are not to be used: error bars are too wide for a number (largest pressures are lower bounds then), or a mark forbids it.
fn uncertain_figures(point: &PointSolution) -> Cell {
    let names = columns()
        .filter(|column| !column.is_usable(point))
        .map(|column| column.name);
    Cell::Text(names.collect::<Vec<_>>().join(" "))
}

/// The codes of the warnings of a point, without notes and those that are silenced.
fn warnings(point: &PointSolution) -> String {
    let all = point.warnings();
    let shown = all.iter().filter(|warning| warning.is_shown());
    distinct(shown.map(|warning| warning.kind.code())).join(" ")
}

fn film_central(solution: Option<&crate::solution::Solution>) -> Option<Estimate> {
    solution.map(|s| s.summary.film_central)
}

fn film_minimum(solution: Option<&crate::solution::Solution>) -> Option<Estimate> {
    solution.map(|s| s.summary.film_minimum)
}

fn thermal(point: &PointSolution) -> Option<&Thermal> {
    point.outcome.solution()?.thermal.as_ref()
}

fn mixed(point: &PointSolution) -> Option<&MixedLubrication> {
    point.outcome.solution()?.mixed.as_ref()
}

fn starvation(point: &PointSolution) -> Option<&crate::solution::Starvation> {
    point.outcome.solution()?.starvation.as_ref()
}

/// A quantity of a solution without error bar.
macro_rules! plain {
    ($name:literal, $unit:literal, $solution:ident => $value:expr) => {
        Column::plain($name, $unit, |point| {
            point.outcome.solution().map(|$solution| $value).into()
        })
    };
}

/// Figures derived from others, and data of the solve.
const DERIVED: &[Column] = &[
    plain!("hertz_pressure", "Pa", s => s.hertz.pressure),
    Column::estimate("film_reduction_central", Kind::Share, |p| {
        p.film_reduction().map(|r| r.central)
    }),
    Column::estimate("film_reduction_minimum", Kind::Share, |p| {
        p.film_reduction().map(|r| r.minimum)
    }),
    Column::estimate("newtonian_film_central", Kind::Length, |p| {
        film_central(p.newtonian_solution())
    }),
    Column::estimate("newtonian_film_minimum", Kind::Length, |p| {
        film_minimum(p.newtonian_solution())
    }),
    Column::estimate("newtonian_traction_coefficient", Kind::Coefficient, |p| {
        p.newtonian_solution().map(|s| s.traction.coefficient)
    }),
    Column::plain("heat_balance_error", "", |p| {
        thermal(p).map(|t| t.balance.error).into()
    }),
    Column::estimate("thermal_reduction_central", Kind::Share, |p| {
        p.thermal_reduction().map(|r| r.film_central)
    }),
    Column::estimate("thermal_reduction_minimum", Kind::Share, |p| {
        p.thermal_reduction().map(|r| r.film_minimum)
    }),
    Column::estimate("thermal_reduction_traction", Kind::Share, |p| {
        p.thermal_reduction().and_then(|r| r.traction)
    }),
    Column::estimate("isothermal_film_central", Kind::Length, |p| {
        film_central(p.isothermal_solution())
    }),
    Column::estimate("isothermal_film_minimum", Kind::Length, |p| {
        film_minimum(p.isothermal_solution())
    }),
    Column::estimate("isothermal_traction_coefficient", Kind::Coefficient, |p| {
        p.isothermal_solution().map(|s| s.traction.coefficient)
    }),
    Column::estimate("starved_ratio_central", Kind::Coefficient, |p| {
        starvation(p)?.ratio_central
    }),
    Column::estimate("starved_ratio_minimum", Kind::Coefficient, |p| {
        starvation(p)?.ratio_minimum
    }),
    Column::estimate("lambda_minimum", Kind::Coefficient, |p| {
        mixed(p).map(|m| m.lambda_minimum)
    }),
    Column::estimate("lambda_central", Kind::Coefficient, |p| {
        mixed(p).map(|m| m.lambda_central)
    }),
    Column::estimate("asperity_load", Kind::Force, |p| {
        Some(mixed(p)?.asperities.as_ref()?.asperity_load)
    }),
    Column::estimate("asperity_load_share", Kind::Share, |p| {
        Some(mixed(p)?.asperities.as_ref()?.asperity_load_share)
    }),
    Column::estimate("friction_fluid", Kind::Coefficient, |p| {
        Some(mixed(p)?.friction()?.friction_fluid)
    }),
    Column::estimate("friction_asperities", Kind::Coefficient, |p| {
        Some(mixed(p)?.friction()?.friction_asperities)
    }),
    Column::estimate("friction_total", Kind::Coefficient, |p| {
        Some(mixed(p)?.friction()?.friction_total)
    }),
    plain!("speed_group", "", s => s.groups.speed),
    plain!("moes_load", "", s => s.groups.moes_load),
    plain!("moes_material", "", s => s.groups.moes_material),
    plain!("newton_iterations", "", s => newton_iterations(s)),
    plain!("krylov_iterations", "", s => krylov_iterations(s)),
    Column::plain("pressure_unknowns", "", |point| {
        let solved = point.outcome.solution().and_then(|s| s.stats.solved());
        solved.map(|level| level.n_pressure_dofs).into()
    }),
    Column::plain("start", "", |point| match point.outcome.solution() {
        Some(s) if s.stats.warm => Cell::Text("warm".to_owned()),
        Some(_) => Cell::Text("cold".to_owned()),
        None => Cell::Empty,
    }),
    Column::plain("unresolved", "", |point| match point.outcome.solution() {
        Some(s) => {
            let names: Vec<&str> = s.unresolved.iter().map(Unresolved::name).collect();
            Cell::Text(names.join(" "))
        }
        None => Cell::Empty,
    }),
    Column::plain("uncertain_figures", "", uncertain_figures),
    Column::plain("warnings", "", |point| Cell::Text(warnings(point))),
    Column::plain("seconds", "", |point| Cell::Number(point.seconds)),
    Column::plain("reason", "", |point| {
        let reason = |outcome: &Option<Outcome>, name: &str| {
            let reason = outcome.as_ref().and_then(Outcome::reason)?;
            Some(format!("{name}: {reason}"))
        };
        let own = point.outcome.reason().map(str::to_owned);
        let first = own
            .or_else(|| reason(&point.newtonian, "Newtonian"))
            .or_else(|| reason(&point.isothermal, "isothermal"));
        Cell::Text(first.unwrap_or_default())
    }),
];

#[cfg(test)]
mod tests {
    use super::*;

    /// Points that lack figures lead to no column twice, and each column follows those before it at its point.
    #[test]
    fn titles_of_points_that_lack_some() {
        let all = joint_titles([
            vec!["a", "d"],
            vec!["a", "b", "c", "d", "e"],
            vec!["a", "x", "d"],
        ]);
        assert_eq!(all, ["a", "x", "b", "c", "d", "e"]);
        assert_eq!(joint_titles([vec!["a", "b"], vec!["a", "b"]]), ["a", "b"]);
        assert_eq!(titled("friction_torque", "N m"), "friction_torque_N_m");
    }

    #[test]
    fn titles_have_units() {
        let title = |figure, is_line| Column::of(figure).title(is_line);
        assert_eq!(title(Figure::FilmCentral, false), "film_central_m");
        assert_eq!(title(Figure::TractionForce, true), "traction_force_N_per_m");
        assert_eq!(title(Figure::RollerMoment, false), "roller_moment_N_m");
        assert_eq!(title(Figure::BeyondFirstLimit, false), "beyond_first_limit");
        let error = Column::of(Figure::FrictionPower).error_title(true);
        assert_eq!(error.unwrap(), "friction_power_error_W_per_m");
    }

    #[test]
    fn every_figure_has_a_column_and_no_name_occurs_twice() {
        let names: Vec<&str> = columns().map(|column| column.name).collect();
        for figure in Figure::ALL {
            assert!(names.contains(&figure.name()), "{}", figure.name());
        }
        for (i, name) in names.iter().enumerate() {
            assert!(!names[..i].contains(name), "{name} twice");
        }
    }
}
