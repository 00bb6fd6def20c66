//! Fields of an instant, and their collection for ParaView.

use std::io::{self, Write};

use super::grid::{Array, Data, Grid};
use crate::run::transient::InstantFields;
use crate::solution::Field;

/// Writes pressure and film of the output time with this number: quadrilaterals around the contact, or the segments of a centreline. Lengths in m, the time in s in the field data `TimeValue`.
///
/// # Errors
/// Those of the writer.
pub fn write_instant(out: impl Write, fields: &InstantFields, number: usize) -> io::Result<()> {
    let [nx, ny] = [fields.x.len(), fields.y.len()];
    let rows = fields.y.iter();
    let points: Vec<[f64; 3]> = rows
        .flat_map(|y| fields.x.iter().map(|x| [*x, *y, 0.0]))
        .collect();
    let cells: Vec<Vec<u32>> = match fields.is_line() {
        true => (1..nx as u32).map(|i| vec![i - 1, i]).collect(),
        false => (1..ny)
            .flat_map(|j| (1..nx).map(move |i| [j * nx + i, (j - 1) * nx + i]))
            .map(|[above, below]| {
                [below - 1, below, above, above - 1]
                    .map(|n| n as u32)
                    .to_vec()
            })
            .collect(),
    };
    let cells: Vec<&[u32]> = cells.iter().map(Vec::as_slice).collect();
    let array = |field: Field, values: &[f32]| Array {
        name: field.column(),
        unit: field.unit(),
        n_components: 1,
        data: Data::Float32(values.to_vec()),
    };
    let grid = Grid {
        points: &points,
        cells: &cells,
        dimension: 2,
        point_data: &[
            array(Field::Pressure, &fields.pressure[number]),
            array(Field::FilmThickness, &fields.film[number]),
        ],
        field_data: &[Array {
            name: "TimeValue",
            unit: "s",
            n_components: 1,
            data: Data::Float64(vec![fields.times[number]]),
        }],
        ..Grid::default()
    };
    grid.write(out)
}

/// Writes a ParaView collection: times, s, and file names.
///
/// # Errors
/// Those of the writer.
pub fn write_collection(
    mut out: impl Write,
    files: impl IntoIterator<Item = (f64, String)>,
) -> io::Result<()> {
    writeln!(out, "<?xml version=\"1.0\"?>")?;
    writeln!(
        out,
        "<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n<Collection>"
    )?;
    for (time, file) in files {
        writeln!(
            out,
            "<DataSet timestep=\"{time:e}\" part=\"0\" file=\"{file}\"/>"
        )?;
    }
    writeln!(out, "</Collection>\n</VTKFile>")
}
