//! `result.nc`: fields of a contact on a regular grid, and its figures, in the classic netCDF format.

pub(super) mod classic;

use classic::{Attribute, Dataset, Values, Variable};

use crate::solution::{ContactFields, Field, Figure, Solution};
use crate::stress::{COMPONENTS, Stresses};

/// Default number of points along x.
pub const N_POINTS: usize = 201;

/// Limits of a grid, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GridExtent {
    /// Along the motion.
    pub x: [f64; 2],
    /// Across it; both zero for line contacts.
    pub y: [f64; 2],
}

/// A figure as written to the file.
#[derive(Clone, Debug, PartialEq)]
pub struct GridFigure {
    /// The figure.
    pub figure: Figure,
    /// Its value, SI.
    pub value: f64,
    /// Half-width of its error bar.
    pub error: Option<f64>,
    /// Half-width due to the uncertainty of the inputs.
    pub uncertainty: Option<f64>,
    /// Whether the bar is narrow enough for a number.
    pub resolved: bool,
    /// Its place, m.
    pub place: Option<[f64; 2]>,
}

/// Global data of the result.
#[derive(Clone, Copy, Debug)]
pub struct About<'a> {
    /// Title of the case.
    pub title: &'a str,
    /// Kind of the contact.
    pub kind: &'a str,
    /// Version of the solver.
    pub version: &'a str,
}

/// Default grid: two half-widths upstream, 1.6 downstream, and 1.2 times the extent of the pressure across.
pub fn extent(
    points: &[[f64; 2]],
    pressure: &[f64],
    half_width: f64,
    hertz_pressure: f64,
) -> GridExtent {
    let all = |axis: usize| points.iter().map(move |p| p[axis]);
    let least = |axis| all(axis).fold(f64::INFINITY, f64::min);
    let most = |axis| all(axis).fold(f64::NEG_INFINITY, f64::max);
    let pressed = (points.iter().zip(pressure))
        .filter(|(_, p)| **p > 0.01 * hertz_pressure)
        .map(|(at, _)| at[1].abs())
        .reduce(f64::max);
    let across = pressed.map_or(half_width, |y| 1.2 * y);
    GridExtent {
        x: [
            least(0).max(-2.0 * half_width),
            most(0).min(1.6 * half_width),
        ],
        y: [least(1).max(-across), most(1).min(across)],
    }
}

/// Points across the motion for a grid with `n_points` along it: one for line contacts.
pub fn n_rows(is_line: bool, n_points: usize, extent: GridExtent) -> usize {
    let [width, height] = [extent.x, extent.y].map(|[low, high]| high - low);
    let n = n_points as f64;
    let rows = (n * (height / width)).min(10.0 * n).round_ties_even();
    if is_line { 1 } else { (rows as usize).max(2) }
}

/// Points along both axes with equal spacing; one at y = 0 for line contacts. At least two points along x.
pub fn axes(is_line: bool, n_points: usize, extent: GridExtent) -> [Vec<f64>; 2] {
    let rows = match is_line {
        true => vec![extent.y[0]],
        false => spaced(extent.y, n_rows(is_line, n_points, extent)),
    };
    [spaced(extent.x, n_points.max(2)), rows]
}

/// Equally spaced points, including both limits.
fn spaced([low, high]: [f64; 2], n: usize) -> Vec<f64> {
    let step = (high - low) / (n - 1) as f64;
    let inner = (0..n - 1).map(|i| i as f64 * step + low);
    inner.chain([high]).collect()
}

/// The figures of a solution.
pub fn figures(solution: &Solution) -> Vec<GridFigure> {
    let uncertainty = |figure| {
        let all = solution.uncertainty.as_ref()?;
        let own = all.0.iter().find(|own| own.figure == figure)?;
        Some(own.half_width)
    };
    let entry = |(figure, at): (Figure, crate::solution::Located)| GridFigure {
        figure,
        value: at.value,
        error: at.error,
        uncertainty: uncertainty(figure),
        resolved: at.resolved,
        place: figure.has_place().then_some([at.x, at.y]),
    };
    solution.figures().map(entry).collect()
}

/// `result.nc` of a solution.
pub(super) fn of_solution(title: &str, solution: &Solution) -> Vec<u8> {
    let fields = solution.fields();
    let pressure = fields.values(Field::Pressure).unwrap_or_default();
    let hertz = &solution.hertz;
    let extent = extent(&fields.points, pressure, hertz.half_width, hertz.pressure);
    let axes = axes(fields.is_line, N_POINTS, extent);
    let about = About {
        title,
        kind: solution.kind.name(),
        version: env!("CARGO_PKG_VERSION"),
    };
    let mut data = dataset(about, &fields, &axes, &figures(solution));
    if let Some(stresses) = &solution.stresses {
        add_stresses(&mut data, stresses);
    }
    data.to_bytes()
}

/// The components of the stresses of both bodies over depth and x, in the plane of motion through the middle of the contact. Bodies with different layers have their own depths.
fn add_stresses(data: &mut Dataset, stresses: &Stresses) {
    let sections = stresses.bodies.each_ref().map(|body| &body.section);
    let x = axis(
        data,
        "stress_x",
        &sections[0].x,
        "position along the motion",
    );
    let words = "depth below the surface, both sides of interfaces";
    let depths = match sections[0].depth == sections[1].depth {
        true => [axis(data, "depth", &sections[0].depth, words); 2],
        false => [
            axis(data, "depth_body_1", &sections[0].depth, words),
            axis(data, "depth_body_2", &sections[1].depth, words),
        ],
    };
    for ((section, depth), number) in sections.into_iter().zip(depths).zip(1..) {
        for (i, component) in COMPONENTS.into_iter().enumerate() {
            let words = format!("stress {component} in body {number}");
            let values = section.stress.iter().map(|s| s.0[i]);
            data.variables.push(Variable {
                name: format!("stress_{component}_body_{number}"),
                dimensions: vec![depth, x],
                attributes: named("Pa", &words),
                values: Values::Double(values.collect()),
            });
        }
    }
}

/// Adds a dimension with its places, m; its index.
fn axis(data: &mut Dataset, name: &'static str, values: &[f64], words: &str) -> usize {
    let index = data.dimensions.len();
    data.dimensions.push((name, values.len()));
    data.variables.push(Variable {
        name: name.to_owned(),
        dimensions: vec![index],
        attributes: named("m", words),
        values: Values::Double(values.to_vec()),
    });
    index
}

fn named(unit: &str, words: &str) -> Vec<(&'static str, Attribute)> {
    vec![("units", text(unit)), ("long_name", text(words))]
}

/// A text without control characters.
pub(super) fn text(text: &str) -> Attribute {
    Attribute::Text(ertel_input::escaped(text).into_owned())
}

/// The file: variables `x` and `y`, m; each field on the grid, NaN outside the contact area; each figure as a scalar variable
/// with its bars and place as attributes.
pub fn netcdf(
    about: About<'_>,
    fields: &ContactFields,
    axes: &[Vec<f64>; 2],
    figures: &[GridFigure],
) -> Vec<u8> {
    dataset(about, fields, axes, figures).to_bytes()
}

fn dataset(
    about: About<'_>,
    fields: &ContactFields,
    [x, y]: &[Vec<f64>; 2],
    figures: &[GridFigure],
) -> Dataset {
    let axis = |name: &str, dimension, values: &[f64], words| Variable {
        name: name.to_owned(),
        dimensions: vec![dimension],
        attributes: named("m", words),
        values: Values::Double(values.to_vec()),
    };
    let mut data = Dataset {
        dimensions: Vec::new(),
        attributes: vec![
            ("title", text(about.title)),
            ("kind", text(about.kind)),
            ("source", text(&format!("ertel {}", about.version))),
        ],
        variables: Vec::new(),
    };
    // Grid rows come first.
    if !fields.is_line {
        data.dimensions.push(("y", y.len()));
        data.variables
            .push(axis("y", 0, y, "position across the motion"));
    }
    let along = data.dimensions.len();
    data.dimensions.push(("x", x.len()));
    data.variables
        .push(axis("x", along, x, "position along the motion"));
    let dimensions: Vec<usize> = (0..=along).collect();
    for grid in fields.on_grid(x, y) {
        let mut attributes = named(grid.field.unit(), grid.field.words());
        attributes.push(("_FillValue", Attribute::Number(f64::NAN)));
        data.variables.push(Variable {
            name: grid.field.name().to_owned(),
            dimensions: dimensions.clone(),
            attributes,
            values: Values::Double(grid.values),
        });
    }
    for own in figures {
        let unit = match own.figure.unit(fields.is_line) {
            "" => "1",
            unit => unit,
        };
        let mut attributes = named(unit, own.figure.words());
        if let Some(error) = own.error {
            attributes.push(("error", Attribute::Number(error)));
            attributes.push(("resolved", Attribute::Integer(own.resolved.into())));
        }
        if let Some(half_width) = own.uncertainty {
            attributes.push(("uncertainty", Attribute::Number(half_width)));
        }
        if let Some([x, y]) = own.place {
            attributes.push(("x", Attribute::Number(x)));
            attributes.push(("y", Attribute::Number(y)));
        }
        data.variables.push(Variable {
            name: own.figure.name().to_owned(),
            dimensions: Vec::new(),
            attributes,
            values: Values::Double(vec![own.value]),
        });
    }
    data
}
