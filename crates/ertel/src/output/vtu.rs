//! VTK XML unstructured grids, binary data inline in base64.
//!
//! Each array is little-endian data in zlib-compressed blocks, as ParaView, PyVista and meshio read it (`vtkZLibDataCompressor`, `header_type="UInt64"`): the base64 text of the number of
//! blocks, the block size, the size of a shorter last block, and the compressed size of each, then the base64 text of the blocks. The units of all arrays are repeated in the field data, as the
//! bytes of a JSON text: meshio reads numbers there, but no strings.

mod grid;
mod instant;
mod stress;
mod whole;

pub use instant::{write_collection, write_instant};
pub use stress::write_stresses;

use std::io::{self, Write};

use self::grid::{Array, Data, Grid};
use self::whole::Whole;
use crate::contact::Shape;
use crate::solution::{BodyField, ContactFields, FilmTemperatures, SurfaceField, TemperatureField};

/// Writes the fields on the whole contact area: triangles, or the segments of a line contact; with temperatures
/// for a thermal contact. Lengths in m; array names include their units.
///
/// # Errors
/// Those of the writer.
pub fn write_surface(
    out: impl Write,
    shape: &Shape,
    half: &SurfaceField,
    temperatures: Option<&FilmTemperatures>,
) -> io::Result<()> {
    let whole = ContactFields::new(shape, half, temperatures);
    let points: Vec<[f64; 3]> = whole.points.iter().map(|[x, y]| [*x, *y, 0.0]).collect();
    let n_nodes = if whole.is_line { 2 } else { 3 };
    let cells: Vec<&[u32]> = whole.cells.iter().map(|c| &c[..n_nodes]).collect();
    let fields: Vec<Array> = (whole.fields.into_iter())
        .map(|(field, values)| Array {
            name: field.column(),
            unit: field.unit(),
            n_components: 1,
            data: Data::Float64(values),
        })
        .collect();
    let grid = Grid {
        points: &points,
        cells: &cells,
        dimension: 2,
        point_data: &fields,
        ..Grid::default()
    };
    grid.write(out)
}

/// Writes the temperature, K, of the whole film and both bodies; the cell array `region` marks plane (0), film (1) or ball (2). Lengths in m, the film stretched by `film_magnification`.
///
/// # Errors
/// Those of the writer.
pub fn write_temperature(
    out: impl Write,
    shape: &Shape,
    field: &TemperatureField,
) -> io::Result<()> {
    let whole = Whole::new(shape.symmetry, &field.points, &field.cells);
    let cells: Vec<&[u32]> = whole.cells.iter().map(Vec::as_slice).collect();
    let array = |name, unit, data| Array {
        name,
        unit,
        n_components: 1,
        data,
    };
    let grid = Grid {
        points: &whole.points,
        cells: &cells,
        dimension: shape.dim + 1,
        point_data: &[array(
            "temperature_K",
            "K",
            Data::Float64(whole.scalar(&field.temperature)),
        )],
        cell_data: &[array(
            "region",
            "",
            Data::UInt8(whole.per_cell(&field.region)),
        )],
        field_data: &[array(
            "film_magnification",
            "",
            Data::Float64(vec![field.film_magnification]),
        )],
    };
    grid.write(out)
}

/// Writes the displacement of the whole elastic body, in m.
///
/// # Errors
/// Those of the writer.
pub fn write_body(out: impl Write, shape: &Shape, body: &BodyField) -> io::Result<()> {
    let whole = Whole::new(shape.symmetry, &body.points, &body.cells);
    let cells: Vec<&[u32]> = whole.cells.iter().map(Vec::as_slice).collect();
    let displacement = Array {
        name: "displacement_m",
        unit: "m",
        n_components: 3,
        data: Data::Float64(whole.vector(&body.displacement).concat()),
    };
    let grid = Grid {
        points: &whole.points,
        cells: &cells,
        dimension: shape.dim + 1,
        point_data: &[displacement],
        ..Grid::default()
    };
    grid.write(out)
}

#[cfg(test)]
mod tests {
    use super::*;
    use base64::Engine;
    use base64::engine::general_purpose::STANDARD;

    use crate::contact::Symmetry;
    use crate::solution::ShearFields;

    fn text(write: impl FnOnce(&mut Vec<u8>) -> io::Result<()>) -> String {
        let mut out = Vec::new();
        write(&mut out).unwrap();
        String::from_utf8(out).unwrap()
    }

    /// The content of an array of at most one block, from the layout of VTK files.
    fn payload(file: &str, name: &str) -> Vec<u8> {
        let (_, rest) = file.split_once(&format!("Name=\"{name}\"")).unwrap();
        let text = rest.lines().nth(1).unwrap();
        // Four 8-byte numbers are 44 characters.
        let header = STANDARD.decode(&text[..44]).unwrap();
        let number = |i: usize| u64::from_le_bytes(header[8 * i..][..8].try_into().unwrap());
        let block = STANDARD.decode(&text[44..]).unwrap();
        assert_eq!([number(0), number(3)], [1, block.len() as u64]);
        let data = miniz_oxide::inflate::decompress_to_vec_zlib(&block).unwrap();
        assert_eq!(number(2), data.len() as u64);
        data
    }

    /// Prefixed with its length, as base64 text.
    fn packed(file: &str, name: &str) -> String {
        let data = payload(file, name);
        STANDARD.encode([&(data.len() as u64).to_le_bytes()[..], &data].concat())
    }

    /// Encoded by Python: `base64.b64encode(struct.pack('<Q…', …))`.
    #[test]
    fn line_surface_matches_hand_packed_bytes() {
        let field = SurfaceField {
            points: vec![[0.0, 0.0], [1.0, 0.0], [3.0, 0.0]],
            cells: vec![[0, 1, 0], [1, 2, 0]],
            order: 1,
            elements: vec![0, 1, 1, 2],
            pressure: vec![0.0, 1.0, 0.5],
            asperity_pressure: Vec::new(),
            film_thickness: vec![1.0; 3],
            deflection: vec![1.0; 3],
            viscosity: vec![1.0; 3],
            density: vec![1.0; 3],
            shear: ShearFields::default(),
        };
        let file = text(|out| write_surface(out, &Shape::LINE, &field, None));
        assert!(file.contains("NumberOfPoints=\"3\" NumberOfCells=\"2\""));
        assert_eq!(packed(&file, "pressure_Pa"), PRESSURE);
        assert_eq!(packed(&file, "connectivity"), CONNECTIVITY);
        assert_eq!(packed(&file, "offsets"), OFFSETS);
        assert_eq!(packed(&file, "types"), TYPES);
        assert_eq!(packed(&file, "Points"), POINTS);
        let (_, units) = file.split_once("<FieldData>").unwrap();
        let bytes = payload(units, "units");
        let text = std::str::from_utf8(&bytes).unwrap();
        assert!(text.starts_with(r#"{"points":"m","pressure_Pa":"Pa","film_thickness_m":"m","#));
        assert!(units.contains(&format!("NumberOfTuples=\"{}\"", text.len())));
    }

    #[test]
    fn cells_without_a_vtk_type_are_rejected() {
        let body = BodyField {
            points: vec![[0.0; 3]; 5],
            cells: vec![vec![0, 1, 2, 3, 4]],
            displacement: vec![[0.0; 3]; 5],
        };
        let whole_circle = Shape {
            symmetry: Symmetry::Full,
            ..Shape::CIRCULAR
        };
        let error = write_body(Vec::new(), &whole_circle, &body).unwrap_err();
        assert!(error.to_string().contains("5 nodes"));
    }

    const PRESSURE: &str = "GAAAAAAAAAAAAAAAAAAAAAAAAAAAAPA/AAAAAAAA4D8=";
    const CONNECTIVITY: &str = "IAAAAAAAAAAAAAAAAAAAAAEAAAAAAAAAAQAAAAAAAAACAAAAAAAAAA==";
    const OFFSETS: &str = "EAAAAAAAAAACAAAAAAAAAAQAAAAAAAAA";
    const TYPES: &str = "AgAAAAAAAAADAw==";
    const POINTS: &str = "SAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAADwPwAAAAAAAAAAAAAAAAAAAAAAAAAAAAAIQAAAAAAAAAAAAAAAAAAAAAA=";
}
