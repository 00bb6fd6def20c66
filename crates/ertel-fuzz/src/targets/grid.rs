//! Fields of a surface on a grid, as the Python package asks for them.

use ertel::output::netcdf::{self, About};
use ertel::solution::{ContactFields, Field};
use serde_json::Value;

use crate::finding::Defect;

/// Points along a grid, and most points of it; the package has its own limit.
const N_POINTS: usize = 41;
const MOST_POINTS: usize = 100_000;
/// By how much rounding may bring a value beyond those it lies between, over the largest of them.
const ROUNDING: f64 = 1e-9;

/// Arrays of a surface as the package hands them over: any numbers, cells whose corners are points.
pub fn fields(is_line: bool, points: &str, cells: &str) -> Option<ContactFields> {
    let (head, rows) = points.split_once('\n')?;
    let names: Vec<&str> = head.trim().split(',').skip(2).collect();
    let rows: Vec<Vec<f64>> = (rows.lines())
        .map(|line| {
            line.split(',')
                .map(|v| v.trim().parse().unwrap_or(f64::NAN))
                .collect()
        })
        .collect();
    let known = |name: &str| Field::ALL.into_iter().find(|field| field.name() == name);
    let column = |k: usize| rows.iter().map(|row| row[k + 2]).collect();
    let n_corners = if is_line { 2 } else { 3 };
    let cell = |line: &str| {
        let corners: Vec<u32> = line
            .split(',')
            .map(|c| c.trim().parse().ok())
            .collect::<Option<_>>()?;
        let is_cell =
            corners.len() == n_corners && corners.iter().all(|c| (*c as usize) < rows.len());
        is_cell.then(|| {
            [
                corners[0],
                corners[1],
                corners.get(2).copied().unwrap_or_default(),
            ]
        })
    };
    let is_table = rows.iter().all(|row| row.len() == names.len() + 2);
    is_table.then_some(())?;
    Some(ContactFields {
        points: rows.iter().map(|row| [row[0], row[1]]).collect(),
        cells: cells.lines().map(cell).collect::<Option<_>>()?,
        fields: (names.iter().enumerate())
            .map(|(k, name)| Some((known(name)?, column(k))))
            .collect::<Option<_>>()?,
        is_line,
    })
}

/// Fields on a grid about the contact, and `result.nc`: values lie between those at the points.
pub fn on_grid(about: &Value, fields: &ContactFields) -> Result<(), Defect> {
    let size = |key: &str| about["hertz"][key].as_f64().unwrap_or(f64::NAN);
    let pressure = fields.values(Field::Pressure).unwrap_or_default();
    let extent = netcdf::extent(
        &fields.points,
        pressure,
        size("half_width"),
        size("pressure"),
    );
    if netcdf::n_rows(fields.is_line, N_POINTS, extent).saturating_mul(N_POINTS) > MOST_POINTS {
        return Ok(());
    }
    let axes = netcdf::axes(fields.is_line, N_POINTS, extent);
    for (grid, (_, own)) in fields
        .on_grid(&axes[0], &axes[1])
        .iter()
        .zip(&fields.fields)
    {
        let reach = |all: &[f64]| {
            let all = all.iter().filter(|v| !v.is_nan());
            all.fold([f64::INFINITY, f64::NEG_INFINITY], |[l, h], v| {
                [l.min(*v), h.max(*v)]
            })
        };
        let [low, high] = reach(own);
        let slack = ROUNDING * low.abs().max(high.abs());
        let [least, most] = reach(&grid.values);
        if least < low - slack || most > high + slack {
            let text = format!("{least:e} to {most:e}, of values from {low:e} to {high:e}");
            return Err(Defect::wrong("a value beyond those of the points", text));
        }
    }
    let text = |key: &str| about[key].as_str().unwrap_or_default();
    let about = About {
        title: text("title"),
        kind: text("kind"),
        version: text("ertel_version"),
    };
    match netcdf::netcdf(about, fields, &axes, &[]).starts_with(b"CDF") {
        true => Ok(()),
        false => Err(Defect::wrong("a file that is not netCDF", "")),
    }
}
