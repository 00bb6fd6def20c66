//! `curve.csv`: one line for each point.

use std::fmt::{self, Write};

use crate::case::study::header;
use crate::contact::ContactKind;
use crate::files::text_field;
use crate::solution::{Estimate, Located, MixedLubrication, Thermal, Unresolved};
use crate::study::{CurveSolution, Outcome, PointSolution};

/// A column of the table, and beside it that of its error bar if it has one.
pub struct Column {
    /// Name in the header, without the unit.
    pub name: &'static str,
    /// The unit as the name ends with it; empty where there is none.
    unit: &'static str,
    /// Value in a line.
    value: fn(&PointSolution) -> Cell,
    /// Half-width of its error bar, if it is a figure that has one.
    error: Option<fn(&PointSolution) -> Cell>,
    /// Whether a line contact has it per metre of its length, which the unit then says.
    per_length: bool,
    /// Whether the error bar in a line is narrow enough for a number.
    resolved: fn(&PointSolution) -> bool,
}

impl Column {
    const fn new(
        name: &'static str,
        unit: &'static str,
        value: fn(&PointSolution) -> Cell,
    ) -> Column {
        Column {
            name,
            unit,
            value,
            error: None,
            per_length: false,
            resolved: |_| true,
        }
    }

    const fn with_error(self, error: fn(&PointSolution) -> Cell) -> Column {
        Column {
            error: Some(error),
            ..self
        }
    }

    const fn resolved_if(self, resolved: fn(&PointSolution) -> bool) -> Column {
        Column { resolved, ..self }
    }

    const fn per_length(self) -> Column {
        Column {
            per_length: true,
            ..self
        }
    }

    /// Title and value of the column in line or circular contacts, and of that of its error bar.
    pub fn fields(
        &self,
        is_line: bool,
    ) -> impl Iterator<Item = (String, fn(&PointSolution) -> Cell)> {
        let title = |name: &str| {
            let suffix = if self.per_length && is_line {
                "_per_m"
            } else {
                ""
            };
            match self.unit {
                "" => name.to_owned(),
                unit => format!("{name}_{unit}{suffix}"),
            }
        };
        let error = (self.error).map(|error| (title(&format!("{}_error", self.name)), error));
        std::iter::once((title(self.name), self.value)).chain(error)
    }
}

/// A value of the table.
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

impl From<Option<Estimate>> for Cell {
    fn from(estimate: Option<Estimate>) -> Cell {
        estimate.map(|e| e.value).into()
    }
}

/// Figure of a solution, empty where there is none.
macro_rules! figure {
    ($name:literal, $unit:literal, $solution:ident => $value:expr) => {
        Column::new($name, $unit, |point| {
            point.outcome.solution().map(|$solution| $value).into()
        })
    };
}

/// Figure of a point with its error bar, empty where there is none.
macro_rules! estimate {
    ($name:literal, $unit:literal, $point:ident => $value:expr) => {
        Column::new($name, $unit, |$point| $value.into())
            .with_error(|$point| {
                let estimate: Option<Estimate> = $value;
                estimate.and_then(|e| e.error).into()
            })
            .resolved_if(|$point| {
                let estimate: Option<Estimate> = $value;
                estimate.is_none_or(|e| e.is_resolved())
            })
    };
}

/// The same of a figure at a place, which knows itself whether it is resolved.
macro_rules! located {
    ($name:literal, $unit:literal, $point:ident => $value:expr) => {
        Column::new($name, $unit, |$point| {
            let at: Option<Located> = $value;
            at.map(|at| at.value).into()
        })
        .with_error(|$point| {
            let at: Option<Located> = $value;
            at.and_then(|at| at.error).into()
        })
        .resolved_if(|$point| {
            let at: Option<Located> = $value;
            at.is_none_or(|at| at.resolved)
        })
    };
}

/// Names of the figures of a point whose error bars are too wide for a number: largest pressures are lower bounds then.
fn uncertain_figures(point: &PointSolution) -> Cell {
    let names = (COLUMNS.iter())
        .filter(|column| !(column.resolved)(point))
        .map(|column| column.name);
    Cell::Text(names.collect::<Vec<_>>().join(" "))
}

/// Temperatures of a point.
fn thermal(point: &PointSolution) -> Option<&Thermal> {
    point.outcome.solution()?.thermal.as_ref()
}

/// Roughness of a point.
fn mixed(point: &PointSolution) -> Option<&MixedLubrication> {
    point.outcome.solution()?.mixed.as_ref()
}

/// The columns, after the point's number and the quantity.
pub const COLUMNS: &[Column] = &[
    Column::new("converged", "", |point| {
        Cell::Text(point.outcome.solution().is_some().to_string())
    }),
    estimate!("film_central", "m", p => p.outcome.solution().map(|s| s.summary.film_central)),
    estimate!("film_minimum", "m", p => p.outcome.solution().map(|s| s.summary.film_minimum)),
    located!("pressure_maximum", "Pa", p => p.outcome.solution().map(|s| s.summary.pressure_maximum)),
    located!("pressure_central", "Pa", p => p.outcome.solution().map(|s| s.summary.pressure_central)),
    located!("pressure_ridge", "Pa", p => p.outcome.solution().and_then(|s| s.summary.pressure_ridge)),
    located!("pressure_spike", "Pa", p => p.outcome.solution().and_then(|s| s.summary.spike)),
    figure!("hertz_pressure", "Pa", s => s.hertz.pressure),
    estimate!("traction_coefficient", "", p => p.outcome.solution().map(|s| s.traction.coefficient)),
    estimate!("traction_coefficient_body_1", "", p => p.outcome.solution().map(|s| s.traction.coefficient_body_1)),
    estimate!("traction_coefficient_body_2", "", p => p.outcome.solution().map(|s| s.traction.coefficient_body_2)),
    estimate!("traction_coefficient_across", "", p => p.outcome.solution().and_then(|s| s.traction.across.map(|t| t.coefficient))),
    estimate!("traction_moment", "N_m", p => p.outcome.solution().and_then(|s| s.traction.moment)),
    estimate!("friction_power", "W", p => p.outcome.solution().map(|s| s.traction.friction_power))
        .per_length(),
    estimate!("shear_stress_maximum", "Pa", p => p.outcome.solution().map(|s| s.traction.shear_stress_maximum)),
    estimate!("film_reduction_central", "", p => p.film_reduction().map(|r| r.central)),
    estimate!("film_reduction_minimum", "", p => p.film_reduction().map(|r| r.minimum)),
    estimate!("newtonian_film_central", "m", p => p.newtonian_solution().map(|s| s.summary.film_central)),
    estimate!("newtonian_film_minimum", "m", p => p.newtonian_solution().map(|s| s.summary.film_minimum)),
    estimate!("newtonian_traction_coefficient", "", p => p.newtonian_solution().map(|s| s.traction.coefficient)),
    located!("film_temperature_maximum", "K", p => thermal(p).map(|t| t.film_maximum)),
    estimate!("film_temperature_mean", "K", p => thermal(p).map(|t| t.film_mean)),
    located!("body_1_temperature_maximum", "K", p => thermal(p).map(|t| t.body_1_maximum)),
    estimate!("body_1_temperature_mean", "K", p => thermal(p).map(|t| t.body_1_mean)),
    located!("body_2_temperature_maximum", "K", p => thermal(p).map(|t| t.body_2_maximum)),
    estimate!("body_2_temperature_mean", "K", p => thermal(p).map(|t| t.body_2_mean)),
    estimate!("heat_shear", "W", p => thermal(p).map(|t| t.balance.shear)).per_length(),
    estimate!("heat_to_body_1", "W", p => thermal(p).map(|t| t.balance.to_body_1)).per_length(),
    estimate!("heat_to_body_2", "W", p => thermal(p).map(|t| t.balance.to_body_2)).per_length(),
    estimate!("heat_by_film", "W", p => thermal(p).map(|t| t.balance.by_film)).per_length(),
    Column::new("heat_balance_error", "", |p| {
        thermal(p).map(|t| t.balance.error).into()
    }),
    estimate!("thermal_reduction_central", "", p => p.thermal_reduction().map(|r| r.film_central)),
    estimate!("thermal_reduction_minimum", "", p => p.thermal_reduction().map(|r| r.film_minimum)),
    estimate!("thermal_reduction_traction", "", p => p.thermal_reduction().and_then(|r| r.traction)),
    estimate!("isothermal_film_central", "m", p => p.isothermal_solution().map(|s| s.summary.film_central)),
    estimate!("isothermal_film_minimum", "m", p => p.isothermal_solution().map(|s| s.summary.film_minimum)),
    estimate!("isothermal_traction_coefficient", "", p => p.isothermal_solution().map(|s| s.traction.coefficient)),
    estimate!("starved_ratio_central", "", p => p.outcome.solution().and_then(|s| s.starvation.as_ref()?.ratio_central)),
    estimate!("starved_ratio_minimum", "", p => p.outcome.solution().and_then(|s| s.starvation.as_ref()?.ratio_minimum)),
    estimate!("meniscus_position", "m", p => p.outcome.solution().and_then(|s| s.starvation.as_ref()?.meniscus_position)),
    estimate!("lambda_minimum", "", p => mixed(p).map(|m| m.lambda_minimum)),
    estimate!("lambda_central", "", p => mixed(p).map(|m| m.lambda_central)),
    estimate!("asperity_load", "N", p => mixed(p).and_then(|m| m.asperities.as_ref()).map(|a| a.asperity_load)).per_length(),
    estimate!("asperity_load_share", "", p => mixed(p).and_then(|m| m.asperities.as_ref()).map(|a| a.asperity_load_share)),
    estimate!("friction_fluid", "", p => mixed(p).and_then(MixedLubrication::friction).map(|f| f.friction_fluid)),
    estimate!("friction_asperities", "", p => mixed(p).and_then(MixedLubrication::friction).map(|f| f.friction_asperities)),
    estimate!("friction_total", "", p => mixed(p).and_then(MixedLubrication::friction).map(|f| f.friction_total)),
    figure!("speed_group", "", s => s.groups.speed),
    figure!("moes_load", "", s => s.groups.moes_load),
    figure!("moes_material", "", s => s.groups.moes_material),
    figure!("newton_iterations", "", s => s.stats.levels.iter().map(|l| l.newton_iterations).sum::<usize>()),
    figure!("krylov_iterations", "", s => s.stats.levels.iter().map(|l| l.krylov_iterations).sum::<usize>()),
    Column::new("pressure_unknowns", "", |point| {
        let solved = point.outcome.solution().and_then(|s| s.stats.solved());
        solved.map(|level| level.n_pressure_dofs).into()
    }),
    Column::new("start", "", |point| match point.outcome.solution() {
        Some(s) if s.stats.warm => Cell::Text("warm".to_owned()),
        Some(_) => Cell::Text("cold".to_owned()),
        None => Cell::Empty,
    }),
    Column::new("unresolved", "", |point| match point.outcome.solution() {
        Some(s) => {
            let names: Vec<&str> = s.unresolved.iter().map(Unresolved::name).collect();
            Cell::Text(names.join(" "))
        }
        None => Cell::Empty,
    }),
    Column::new("uncertain_figures", "", uncertain_figures),
    Column::new("seconds", "", |point| Cell::Number(point.seconds)),
    Column::new("reason", "", |point| {
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

/// The table as text, SI.
pub fn curve_table(curve: &CurveSolution) -> String {
    // `entrainment_speed_m_per_s`, `load_N`, `slide_to_roll_ratio`.
    let quantity = &curve.quantity;
    let mut text = format!("point,{}", header(quantity.key(), quantity.dimension));
    let is_line = (curve.points.first()).is_some_and(|p| p.case.contact.kind == ContactKind::Line);
    let fields: Vec<_> = COLUMNS.iter().flat_map(|c| c.fields(is_line)).collect();
    for (title, _) in &fields {
        text.push(',');
        text.push_str(title);
    }
    text.push('\n');
    for (i, point) in curve.points.iter().enumerate() {
        let _ = write!(text, "{},{:e}", i + 1, point.value);
        for (_, value) in &fields {
            text.push(',');
            text.push_str(&text_field(&value(point).to_string()));
        }
        text.push('\n');
    }
    text
}
