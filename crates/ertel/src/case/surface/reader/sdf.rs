//! SDF, ASCII (ISO 25178-71): a header of keys, heights, a trailer, each of which ends with an asterisk. Lengths are in metres.

pub(super) mod binary;

use super::{MapError, checked};
use crate::contact::topography::Topography;

/// First lines of such files; the second one is that of the format before the standard.
const ASCII: [&str; 2] = ["aISO-1.0", "aBCR-1.0"];
const BINARY: [&str; 2] = ["bISO-1.0", "bBCR-1.0"];

/// Whether a text is one.
pub(super) fn is_ascii(text: &str) -> bool {
    ASCII.iter().any(|name| text.trim_start().starts_with(name))
}

/// Whether bytes are a binary one.
pub(super) fn is_binary(bytes: &[u8]) -> bool {
    BINARY.iter().any(|name| bytes.starts_with(name.as_bytes()))
}

pub(super) fn parse(text: &str) -> Result<Topography, MapError> {
    let mut lines = text
        .lines()
        .enumerate()
        .map(|(i, line)| (i + 1, line.trim()));
    let mut keys: Vec<(String, &str, usize)> = Vec::new();
    for (line, content) in lines.by_ref() {
        if content == "*" {
            break;
        }
        if let Some((key, value)) = content.split_once('=') {
            keys.push((key.trim().to_lowercase(), value.trim(), line));
        }
    }
    let find = |key: &str| keys.iter().find(|(own, ..)| own == &key.to_lowercase());
    let number = |key: &str| -> Result<(f64, usize), MapError> {
        let (_, value, line) =
            find(key).ok_or_else(|| MapError::content(format!("the header has no {key}")))?;
        match value.parse::<f64>() {
            Ok(number) if number.is_finite() => Ok((number, *line)),
            _ => Err(MapError::at(
                *line,
                format!("{key} is \"{value}\", no number"),
            )),
        }
    };
    let count = |key: &str| -> Result<usize, MapError> {
        match number(key)? {
            (value, _) if value >= 1.0 && value.fract() == 0.0 && value < 1e9 => Ok(value as usize),
            (value, line) => Err(MapError::at(
                line,
                format!("{key} is {value}, no number of points"),
            )),
        }
    };
    let scale = |key: &str| -> Result<f64, MapError> {
        match number(key)? {
            (value, _) if value > 0.0 => Ok(value),
            (value, line) => Err(MapError::at(
                line,
                format!("{key} is {value}, not positive"),
            )),
        }
    };
    let counts = checked([count("NumPoints")?, count("NumProfiles")?])?;
    if let Some((_, value, line)) = find("Compression").filter(|(_, value, _)| *value != "0") {
        return Err(MapError::at(
            *line,
            format!("Compression is {value}: compressed data are not read"),
        ));
    }
    let spacing = [
        scale("Xscale")?,
        if counts[1] == 1 {
            1.0
        } else {
            scale("Yscale")?
        },
    ];
    let unit = scale("Zscale")?;
    let heights = heights(lines, counts, unit)?;
    Ok(Topography {
        counts,
        spacing,
        heights,
    })
}

/// The heights of the lines below the header, with their unit in m.
fn heights<'a>(
    lines: impl Iterator<Item = (usize, &'a str)>,
    counts: [usize; 2],
    unit: f64,
) -> Result<Vec<f64>, MapError> {
    let n = counts[0] * counts[1];
    let mut heights = Vec::with_capacity(n);
    'rows: for (line, content) in lines {
        for cell in content.split_whitespace() {
            if cell == "*" {
                break 'rows;
            }
            let value = match cell.parse::<f64>() {
                _ if cell.eq_ignore_ascii_case("bad") => f64::NAN,
                Ok(value) if value.is_finite() => unit * value,
                _ => {
                    return Err(MapError::at(
                        line,
                        format!("\"{cell}\" is no height; a point without one is BAD"),
                    ));
                }
            };
            if heights.len() == n {
                return Err(MapError::at(
                    line,
                    format!(
                        "more heights than NumPoints times NumProfiles, {} x {}",
                        counts[0], counts[1]
                    ),
                ));
            }
            heights.push(value);
        }
    }
    if heights.len() != n {
        return Err(MapError::content(format!(
            "{} heights, where NumPoints times NumProfiles are {} x {}",
            heights.len(),
            counts[0],
            counts[1]
        )));
    }
    Ok(heights)
}
