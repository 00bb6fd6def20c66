//! `curve.csv`: one line for each point.

use std::fmt::Write;

use crate::contact::ContactKind;
use crate::study::{CurveSolution, Outcome, PointSolution};

/// A column of the table: its name with the unit, and its value.
pub struct Column {
    /// Name in the header, with the unit.
    pub name: &'static str,
    /// Value in a line.
    pub value: fn(&PointSolution) -> Cell,
    /// Whether a line contact has it per metre of its length, which the unit then says.
    pub per_length: bool,
}

impl Column {
    const fn new(name: &'static str, value: fn(&PointSolution) -> Cell) -> Column {
        Column {
            name,
            value,
            per_length: false,
        }
    }

    const fn per_length(self) -> Column {
        Column {
            per_length: true,
            ..self
        }
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

/// Figure of a solution, empty where there is none.
macro_rules! figure {
    ($name:literal, $solution:ident => $value:expr) => {
        Column::new($name, |point| {
            point.outcome.solution().map(|$solution| $value).into()
        })
    };
    ($name:literal, $solution:ident =>? $value:expr) => {
        Column::new($name, |point| {
            point.outcome.solution().and_then(|$solution| $value).into()
        })
    };
}

/// Figure of the temperatures of a point, likewise.
macro_rules! thermal {
    ($name:literal, $thermal:ident => $value:expr) => {
        Column::new($name, |point| {
            let solution = point.outcome.solution();
            let thermal = solution.and_then(|s| s.thermal.as_ref());
            thermal.map(|$thermal| $value).into()
        })
    };
}

/// Figure of the isothermal solution of a point, likewise.
macro_rules! isothermal {
    ($name:literal, $solution:ident => $value:expr) => {
        Column::new($name, |point| {
            point.isothermal_solution().map(|$solution| $value).into()
        })
    };
}

/// Figure of the Newtonian solution of a point, likewise.
macro_rules! newtonian {
    ($name:literal, $solution:ident => $value:expr) => {
        Column::new($name, |point| {
            point.newtonian_solution().map(|$solution| $value).into()
        })
    };
}

/// The columns, after the point's number and the quantity.
pub const COLUMNS: &[Column] = &[
    Column::new("converged", |point| {
        Cell::Text(point.outcome.solution().is_some().to_string())
    }),
    figure!("film_central_m", s => s.summary.film_central.value),
    figure!("film_central_error_m", s =>? s.summary.film_central.error),
    figure!("film_minimum_m", s => s.summary.film_minimum.value),
    figure!("film_minimum_error_m", s =>? s.summary.film_minimum.error),
    figure!("pressure_maximum_Pa", s => s.summary.pressure_maximum.value),
    figure!("hertz_pressure_Pa", s => s.hertz.pressure),
    figure!("traction_coefficient", s => s.traction.coefficient),
    figure!("traction_coefficient_plane", s => s.traction.coefficient_plane),
    figure!("traction_coefficient_ball", s => s.traction.coefficient_ball),
    figure!("friction_power_W", s => s.traction.friction_power).per_length(),
    figure!("shear_stress_maximum_Pa", s => s.traction.shear_stress_maximum),
    Column::new("film_reduction_central", |point| {
        point.film_reduction().map(|r| r.central).into()
    }),
    Column::new("film_reduction_minimum", |point| {
        point.film_reduction().map(|r| r.minimum).into()
    }),
    newtonian!("newtonian_film_central_m", s => s.summary.film_central.value),
    newtonian!("newtonian_film_minimum_m", s => s.summary.film_minimum.value),
    newtonian!("newtonian_traction_coefficient", s => s.traction.coefficient),
    thermal!("film_temperature_maximum_K", t => t.film_maximum.value),
    thermal!("film_temperature_mean_K", t => t.film_mean),
    thermal!("plane_temperature_maximum_K", t => t.plane_maximum.value),
    thermal!("plane_temperature_mean_K", t => t.plane_mean),
    thermal!("ball_temperature_maximum_K", t => t.ball_maximum.value),
    thermal!("ball_temperature_mean_K", t => t.ball_mean),
    thermal!("heat_shear_W", t => t.balance.shear).per_length(),
    thermal!("heat_to_plane_W", t => t.balance.to_plane).per_length(),
    thermal!("heat_to_ball_W", t => t.balance.to_ball).per_length(),
    thermal!("heat_by_film_W", t => t.balance.by_film).per_length(),
    thermal!("heat_balance_error", t => t.balance.error),
    Column::new("thermal_reduction_central", |point| {
        point.thermal_reduction().map(|r| r.film_central).into()
    }),
    Column::new("thermal_reduction_minimum", |point| {
        point.thermal_reduction().map(|r| r.film_minimum).into()
    }),
    Column::new("thermal_reduction_traction", |point| {
        point.thermal_reduction().and_then(|r| r.traction).into()
    }),
    isothermal!("isothermal_film_central_m", s => s.summary.film_central.value),
    isothermal!("isothermal_film_minimum_m", s => s.summary.film_minimum.value),
    isothermal!("isothermal_traction_coefficient", s => s.traction.coefficient),
    figure!("speed_group", s => s.groups.speed),
    figure!("moes_load", s => s.groups.moes_load),
    figure!("moes_material", s => s.groups.moes_material),
    figure!("newton_iterations", s => s.stats.levels.iter().map(|l| l.newton_iterations).sum::<usize>()),
    figure!("krylov_iterations", s => s.stats.levels.iter().map(|l| l.krylov_iterations).sum::<usize>()),
    figure!("pressure_unknowns", s =>? s.stats.solved().map(|l| l.n_pressure_dofs)),
    Column::new("start", |point| match point.outcome.solution() {
        Some(s) if s.stats.warm => Cell::Text("warm".to_owned()),
        Some(_) => Cell::Text("cold".to_owned()),
        None => Cell::Empty,
    }),
    Column::new("seconds", |point| Cell::Number(point.seconds)),
    Column::new("reason", |point| {
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
    let mut text = format!("point,{}", quantity_column(curve));
    let is_line = (curve.points.first()).is_some_and(|p| p.case.contact.kind == ContactKind::Line);
    for column in COLUMNS {
        text.push(',');
        text.push_str(column.name);
        if column.per_length && is_line {
            text.push_str("_per_m");
        }
    }
    text.push('\n');
    for (i, point) in curve.points.iter().enumerate() {
        let _ = write!(text, "{},{:e}", i + 1, point.value);
        for column in COLUMNS {
            text.push(',');
            text.push_str(&field((column.value)(point)));
        }
        text.push('\n');
    }
    text
}

/// `entrainment_speed_m_per_s`, `load_N`, `slide_to_roll_ratio`.
fn quantity_column(curve: &CurveSolution) -> String {
    let unit = curve.quantity.unit().replace('/', "_per_");
    match unit.as_str() {
        "" => curve.quantity.key().to_owned(),
        unit => format!("{}_{unit}", curve.quantity.key()),
    }
}

/// A field, quoted where it must be (RFC 4180).
fn field(cell: Cell) -> String {
    match cell {
        Cell::Empty => String::new(),
        Cell::Number(value) => format!("{value:e}"),
        Cell::Count(value) => value.to_string(),
        Cell::Text(text) if text.contains([',', '"', '\n', '\r']) => {
            format!("\"{}\"", text.replace('"', "\"\""))
        }
        Cell::Text(text) => text,
    }
}
