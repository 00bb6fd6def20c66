//! `main.xml` of an X3P: bounded before it is parsed, its numbers and its axes.

use roxmltree::{Document, Error, Node, ParsingOptions};

use super::super::MapError;
use super::archive::{Archive, DESCRIPTION};

/// Bytes of a description at most: heights in one take some tens each.
pub(super) const LARGEST_DESCRIPTION: usize = 8 << 20;
/// Elements and texts at most: two or three for each height in a description.
const MOST_NODES: u32 = 300_000;
/// Signs of equality at most, of which each attribute has one; the parser compares each attribute of an element with all others.
const MOST_ATTRIBUTES: usize = 2_000;

/// Parses it within the bounds.
pub(super) fn parsed(text: &str) -> Result<Document<'_>, MapError> {
    let too_many = |what: String| {
        MapError::content(format!(
            "{DESCRIPTION} has more than {what}: many points belong into a binary file of the archive (PointDataLink)"
        ))
    };
    if text
        .bytes()
        .filter(|b| *b == b'=')
        .nth(MOST_ATTRIBUTES)
        .is_some()
    {
        return Err(too_many(format!("{MOST_ATTRIBUTES} attributes")));
    }
    let options = ParsingOptions {
        nodes_limit: MOST_NODES,
        ..ParsingOptions::default()
    };
    Document::parse_with_options(text, options).map_err(|error| match error {
        Error::NodesLimitReached => too_many(format!("{MOST_NODES} elements")),
        error => MapError::content(format!("{DESCRIPTION}: {error}")),
    })
}

/// The text at a path of elements; `None` where there is none or nothing but blanks.
pub(super) fn at<'a>(node: Node<'a, '_>, path: &[&str]) -> Option<&'a str> {
    let found = path.iter().try_fold(node, |node, name| {
        node.children()
            .find(|child| child.tag_name().name() == *name)
    })?;
    found.text().map(str::trim).filter(|text| !text.is_empty())
}

/// The positive number at a path; `None` where there is none.
pub(super) fn positive(root: Node<'_, '_>, path: &[&str]) -> Result<Option<f64>, MapError> {
    let Some(text) = at(root, path) else {
        return Ok(None);
    };
    match text.parse::<f64>() {
        Ok(value) if value.is_finite() && value > 0.0 => Ok(Some(value)),
        _ => Err(MapError::content(format!(
            "{DESCRIPTION}: {} is \"{text}\", no positive number",
            path.join("/")
        ))),
    }
}

/// The positive number that has to be there.
pub(super) fn required(root: Node<'_, '_>, path: &[&str]) -> Result<f64, MapError> {
    positive(root, path)?
        .ok_or_else(|| MapError::content(format!("{DESCRIPTION} has no {}", path.join("/"))))
}

/// How numbers of an axis are written.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Number {
    Short,
    Long,
    Float,
    Double,
}

impl Number {
    pub(super) fn size(self) -> usize {
        match self {
            Number::Short => 2,
            Number::Long | Number::Float => 4,
            Number::Double => 8,
        }
    }

    /// Of its bytes, the lowest first.
    pub(super) fn read(self, bytes: &[u8]) -> f64 {
        let first = |n: usize| {
            let mut own = [0; 8];
            own[..n].copy_from_slice(&bytes[..n]);
            own
        };
        let own = first(self.size());
        let [a, b, c, d, ..] = own;
        match self {
            Number::Short => f64::from(i16::from_le_bytes([a, b])),
            Number::Long => f64::from(i32::from_le_bytes([a, b, c, d])),
            Number::Float => f64::from(f32::from_le_bytes([a, b, c, d])),
            Number::Double => f64::from_le_bytes(own),
        }
    }
}

/// An axis: a coordinate is `offset + increment n`, m, where n is a number of the file or, of an axis that is not absolute, a place in the matrix
/// (ISO 25178-72, Record1/Axes).
#[derive(Clone, Copy)]
pub(super) struct Axis<'a> {
    root: Node<'a, 'a>,
    name: &'static str,
    pub(super) increment: f64,
    offset: f64,
    /// Whether each point gives its coordinate, as heights always do.
    pub(super) is_absolute: bool,
}

impl<'a> Axis<'a> {
    /// # Errors
    /// An increment that is missing where it is needed, by integers and places of a matrix, or is not positive; an offset that is no number.
    pub(super) fn read(root: Node<'a, 'a>, name: &'static str) -> Result<Self, MapError> {
        let of = |key: &str| at(root, &["Record1", "Axes", name, key]);
        let is_absolute = name == "CZ" || of("AxisType") == Some("A");
        let is_integer = matches!(of("DataType"), Some("I" | "L"));
        let path = ["Record1", "Axes", name, "Increment"];
        let increment = match positive(root, &path)? {
            Some(increment) => increment,
            None if is_absolute && !is_integer => 1.0,
            None => {
                return Err(MapError::content(format!(
                    "{DESCRIPTION} has no {}, the metres by which {} are multiplied",
                    path.join("/"),
                    match (is_absolute, name) {
                        (false, _) => "places in the matrix",
                        (true, "CZ") => "heights that are integers",
                        (true, _) => "places that are integers",
                    }
                )));
            }
        };
        let offset = of("Offset").unwrap_or("0");
        let offset = (offset.parse::<f64>().ok())
            .filter(|value| value.is_finite())
            .ok_or_else(|| {
                MapError::content(format!(
                    "{DESCRIPTION}: Record1/Axes/{name}/Offset is \"{offset}\", no number"
                ))
            })?;
        Ok(Self {
            root,
            name,
            increment,
            offset,
            is_absolute,
        })
    }

    /// The coordinate of a number of the file, m.
    pub(super) fn value(&self, number: f64) -> f64 {
        self.offset + self.increment * number
    }

    /// How its numbers are written in a binary file.
    pub(super) fn number(&self) -> Result<Number, MapError> {
        match at(self.root, &["Record1", "Axes", self.name, "DataType"]) {
            Some("I") => Ok(Number::Short),
            Some("L") => Ok(Number::Long),
            Some("F") => Ok(Number::Float),
            Some("D") => Ok(Number::Double),
            other => Err(MapError::content(format!(
                "{DESCRIPTION}: {} has the data type {}, which is none of I, L, F and D",
                self.name,
                other.unwrap_or("of no name")
            ))),
        }
    }
}

/// The texts of the points in the description.
pub(super) fn data<'a>(root: Node<'a, 'a>) -> Result<Vec<&'a str>, MapError> {
    let list = (root.descendants())
        .find(|node| node.tag_name().name() == "DataList")
        .ok_or_else(|| {
            MapError::content(format!(
                "{DESCRIPTION} has neither a PointDataLink nor a DataList"
            ))
        })?;
    let points = list
        .children()
        .filter(|node| node.tag_name().name() == "Datum");
    Ok(points
        .map(|datum| datum.text().unwrap_or_default().trim())
        .collect())
}

/// The text of an element of `DataLink`, which names the files of points.
pub(super) fn of_link<'a>(root: Node<'a, '_>, key: &str) -> Option<&'a str> {
    at(root, &["Record3", "DataLink", key])
}

/// Which of the points have a height: one bit a point, the lowest first.
pub(super) fn valid(
    archive: &Archive<'_>,
    root: Node<'_, '_>,
    n: usize,
) -> Result<impl Fn(usize) -> bool + use<>, MapError> {
    let bits = match of_link(root, "ValidPointsLink") {
        None => None,
        Some(name) => {
            let bits =
                archive.points(name, n.div_ceil(8), of_link(root, "MD5ChecksumValidPoints"))?;
            if bits.len() != n.div_ceil(8) {
                return Err(MapError::content(format!(
                    "`{name}` does not have a bit for each point"
                )));
            }
            Some(bits)
        }
    };
    Ok(move |k: usize| {
        bits.as_ref()
            .is_none_or(|bits| bits[k / 8] >> (k % 8) & 1 == 1)
    })
}
