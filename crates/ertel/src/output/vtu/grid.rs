//! Unstructured grids with arrays, as text.

use std::io::{self, Write};

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use rayon::prelude::*;

/// VTK cell types by number of nodes: triangles and segments, or also tetrahedra.
const LINE: u8 = 3;
const TRIANGLE: u8 = 5;
const QUADRILATERAL: u8 = 9;
const TETRAHEDRON: u8 = 10;
const WEDGE: u8 = 13;
const QUADRATIC_TRIANGLE: u8 = 22;
const QUADRATIC_TETRAHEDRON: u8 = 24;

/// An array of a grid.
#[derive(Clone)]
pub(super) struct Array<'a> {
    pub name: &'a str,
    /// SI unit, such as `Pa.s`; empty if dimensionless.
    pub unit: &'static str,
    pub n_components: usize,
    pub data: Data,
}

#[derive(Clone)]
pub(super) enum Data {
    Float32(Vec<f32>),
    Float64(Vec<f64>),
    Int64(Vec<i64>),
    UInt8(Vec<u8>),
}

impl Data {
    fn type_name(&self) -> &'static str {
        match self {
            Data::Float32(_) => "Float32",
            Data::Float64(_) => "Float64",
            Data::Int64(_) => "Int64",
            Data::UInt8(_) => "UInt8",
        }
    }

    fn len(&self) -> usize {
        match self {
            Data::Float32(values) => values.len(),
            Data::Float64(values) => values.len(),
            Data::Int64(values) => values.len(),
            Data::UInt8(values) => values.len(),
        }
    }

    fn bytes(&self) -> Vec<u8> {
        match self {
            Data::Float32(values) => values.iter().flat_map(|v| v.to_le_bytes()).collect(),
            Data::Float64(values) => values.iter().flat_map(|v| v.to_le_bytes()).collect(),
            Data::Int64(values) => values.iter().flat_map(|v| v.to_le_bytes()).collect(),
            Data::UInt8(values) => values.clone(),
        }
    }
}

/// Cell type for this number of nodes in a grid of two or three dimensions.
fn cell_type(n_nodes: usize, dimension: usize) -> io::Result<u8> {
    match (n_nodes, dimension) {
        (2, _) => Ok(LINE),
        (3, _) => Ok(TRIANGLE),
        (4, 2) => Ok(QUADRILATERAL),
        (4, 3) => Ok(TETRAHEDRON),
        (6, 3) => Ok(WEDGE),
        (6, _) => Ok(QUADRATIC_TRIANGLE),
        (10, 3) => Ok(QUADRATIC_TETRAHEDRON),
        _ => Err(io::Error::new(
            io::ErrorKind::InvalidInput,
            format!("no VTK cell of {n_nodes} nodes in {dimension} dimensions"),
        )),
    }
}

/// An unstructured grid.
#[derive(Default)]
pub(super) struct Grid<'a> {
    pub points: &'a [[f64; 3]],
    pub cells: &'a [&'a [u32]],
    pub dimension: usize,
    pub point_data: &'a [Array<'a>],
    pub cell_data: &'a [Array<'a>],
    pub field_data: &'a [Array<'a>],
}

impl Grid<'_> {
    pub fn write(&self, out: impl Write) -> io::Result<()> {
        write_grid(out, self)
    }

    /// `{"points":"m","pressure_Pa":"Pa"}`: the units of points and arrays.
    fn units(&self) -> String {
        let arrays = [self.point_data, self.cell_data, self.field_data];
        let of_arrays = arrays.into_iter().flatten();
        let units: serde_json::Map<_, _> = std::iter::once(("points", "m"))
            .chain(of_arrays.map(|array| (array.name, array.unit)))
            .filter(|(_, unit)| !unit.is_empty())
            .map(|(name, unit)| (name.to_owned(), unit.into()))
            .collect();
        serde_json::Value::Object(units).to_string()
    }
}

fn write_grid(mut out: impl Write, grid: &Grid) -> io::Result<()> {
    let Grid {
        points,
        cells,
        dimension,
        ..
    } = *grid;
    let types: Vec<u8> = cells
        .iter()
        .map(|c| cell_type(c.len(), dimension))
        .collect::<io::Result<_>>()?;
    let connectivity = cells.iter().flat_map(|c| c.iter().map(|n| i64::from(*n)));
    let offsets = cells.iter().scan(0, |end, c| {
        *end += c.len() as i64;
        Some(*end)
    });
    writeln!(out, "<?xml version=\"1.0\"?>")?;
    writeln!(
        out,
        "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">"
    )?;
    writeln!(out, "<UnstructuredGrid>")?;
    let units = Array {
        name: "units",
        unit: "",
        n_components: 1,
        data: Data::UInt8(grid.units().into_bytes()),
    };
    section(&mut out, "FieldData", &[grid.field_data, &[units]].concat())?;
    writeln!(
        out,
        "<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">",
        points.len(),
        cells.len()
    )?;
    section(
        &mut out,
        "Points",
        &[Array {
            name: "Points",
            unit: "m",
            n_components: 3,
            data: Data::Float64(points.concat()),
        }],
    )?;
    let integers = |name, values| Array {
        name,
        unit: "",
        n_components: 1,
        data: Data::Int64(values),
    };
    section(
        &mut out,
        "Cells",
        &[
            integers("connectivity", connectivity.collect()),
            integers("offsets", offsets.collect()),
            Array {
                name: "types",
                unit: "",
                n_components: 1,
                data: Data::UInt8(types),
            },
        ],
    )?;
    section(&mut out, "PointData", grid.point_data)?;
    if !grid.cell_data.is_empty() {
        section(&mut out, "CellData", grid.cell_data)?;
    }
    writeln!(out, "</Piece>\n</UnstructuredGrid>\n</VTKFile>")
}

fn section(out: &mut impl Write, name: &str, arrays: &[Array]) -> io::Result<()> {
    writeln!(out, "<{name}>")?;
    for array in arrays {
        // Readers take scalars without the attribute as one-dimensional arrays
        let mut size = match array.n_components {
            1 => String::new(),
            n => format!(" NumberOfComponents=\"{n}\""),
        };
        // VTK needs the number of tuples for arrays that belong to no points or cells
        if name == "FieldData" {
            let n_tuples = array.data.len() / array.n_components;
            size += &format!(" NumberOfTuples=\"{n_tuples}\"");
        }
        writeln!(
            out,
            "<DataArray type=\"{}\" Name=\"{}\"{size} format=\"binary\">",
            array.data.type_name(),
            array.name,
        )?;
        writeln!(out, "{}\n</DataArray>", compressed(&array.data.bytes()))?;
    }
    writeln!(out, "</{name}>")
}

/// Uncompressed bytes per block.
const BLOCK: usize = 1 << 18;

/// The fastest level of zlib: higher ones hardly reduce the size of points, connectivity and fields.
const LEVEL: u8 = 1;

/// The text of an array.
fn compressed(data: &[u8]) -> String {
    let blocks: Vec<Vec<u8>> = (data.par_chunks(BLOCK))
        .map(|block| miniz_oxide::deflate::compress_to_vec_zlib(block, LEVEL))
        .collect();
    let mut header = vec![blocks.len(), BLOCK, data.len() % BLOCK];
    header.extend(blocks.iter().map(Vec::len));
    let header: Vec<u8> = (header.into_iter())
        .flat_map(|size| (size as u64).to_le_bytes())
        .collect();
    STANDARD.encode(header) + &STANDARD.encode(blocks.concat())
}
