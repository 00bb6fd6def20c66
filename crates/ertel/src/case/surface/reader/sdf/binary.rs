//! SDF, binary (ISO 25178-71): a header of 81 bytes, and heights, all with the lowest byte first.
//!
//! | bytes | content |
//! |---|---|
//! | 0 to 8 | `bISO-1.0` |
//! | 8 to 42 | maker, dates of creation and change |
//! | 42 to 46 | points in a row, rows: 2 bytes each |
//! | 46 to 78 | distances along the rows and across them, unit of the heights, resolution: double precision, m |
//! | 78 to 81 | compression (0: none), type of the heights, check |

use super::super::{MapError, checked, finite};
use crate::contact::topography::Topography;

const HEADER: usize = 81;
/// Bytes that the exports of some makers add to the header.
const ADDED: usize = 8;

/// How heights are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    U8,
    U16,
    U32,
    F32,
    I8,
    I16,
    I32,
    F64,
}

impl Kind {
    /// In the order of their numbers.
    const ALL: [Kind; 8] = [
        Kind::U8,
        Kind::U16,
        Kind::U32,
        Kind::F32,
        Kind::I8,
        Kind::I16,
        Kind::I32,
        Kind::F64,
    ];

    fn size(self) -> usize {
        match self {
            Kind::U8 | Kind::I8 => 1,
            Kind::U16 | Kind::I16 => 2,
            Kind::U32 | Kind::I32 | Kind::F32 => 4,
            Kind::F64 => 8,
        }
    }

    /// A height, not a number where the point has none: the least of the signed integers, the largest of the unsigned ones.
    fn read(self, bytes: &[u8]) -> f64 {
        let mut own = [0; 8];
        own[..bytes.len()].copy_from_slice(bytes);
        let [a, b, c, d, ..] = own;
        let known = |is_none: bool, value: f64| if is_none { f64::NAN } else { value };
        match self {
            Kind::U8 => f64::from(a),
            Kind::I8 => f64::from(i8::from_le_bytes([a])),
            Kind::U16 => {
                let value = u16::from_le_bytes([a, b]);
                known(value == u16::MAX, f64::from(value))
            }
            Kind::I16 => {
                let value = i16::from_le_bytes([a, b]);
                known(value == i16::MIN, f64::from(value))
            }
            Kind::U32 => {
                let value = u32::from_le_bytes([a, b, c, d]);
                known(value == u32::MAX, f64::from(value))
            }
            Kind::I32 => {
                let value = i32::from_le_bytes([a, b, c, d]);
                known(value == i32::MIN, f64::from(value))
            }
            Kind::F32 => f64::from(f32::from_le_bytes([a, b, c, d])),
            Kind::F64 => f64::from_le_bytes(own),
        }
    }
}

pub(in super::super) fn parse(bytes: &[u8]) -> Result<Topography, MapError> {
    if bytes.len() < HEADER {
        return Err(MapError::content(format!(
            "{} bytes, and the header of a binary SDF takes {HEADER}",
            bytes.len()
        )));
    }
    let count = |at: usize| usize::from(u16::from_le_bytes([bytes[at], bytes[at + 1]]));
    let scale = |at: usize, name: &str| {
        let mut own = [0; 8];
        own.copy_from_slice(&bytes[at..at + 8]);
        match f64::from_le_bytes(own) {
            value if value.is_finite() && value > 0.0 => Ok(value),
            value => Err(MapError::content(format!(
                "{name} is {value}, no positive number"
            ))),
        }
    };
    let counts = checked([count(42), count(44)])?;
    let spacing = [
        scale(46, "Xscale")?,
        if counts[1] == 1 {
            1.0
        } else {
            scale(54, "Yscale")?
        },
    ];
    let unit = scale(62, "Zscale")?;
    if bytes[78] != 0 {
        return Err(MapError::content(format!(
            "Compression is {}: compressed data are not read",
            bytes[78]
        )));
    }
    let kind = Kind::ALL
        .get(usize::from(bytes[79]))
        .ok_or_else(|| MapError::content(format!("DataType is {}, none of 0 to 7", bytes[79])))?;
    let length = counts[0] * counts[1] * kind.size();
    let start = match bytes.len() == HEADER + ADDED + length && bytes.starts_with(b"bISO-1.0") {
        true => HEADER + ADDED,
        false => HEADER,
    };
    // A trailer may follow.
    let data = bytes.get(start..start + length).ok_or_else(|| {
        MapError::content(format!(
            "{} bytes of heights, where NumPoints times NumProfiles, {} x {}, take {length}",
            bytes.len() - HEADER,
            counts[0],
            counts[1]
        ))
    })?;
    let heights: Vec<f64> = (data.chunks_exact(kind.size()))
        .map(|own| unit * kind.read(own))
        .collect();
    finite(counts, spacing, heights)
}
