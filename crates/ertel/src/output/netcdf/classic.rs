//! The classic format of netCDF with 64-bit offsets (CDF-2), restricted to fixed dimensions, variables of single or double
//! precision, and attributes that are texts, numbers or integers.
//!
//! Source: Unidata, The NetCDF Classic Format Specification (NetCDF Users Guide, file format specifications).

/// A value of an attribute.
#[derive(Clone, Debug)]
pub enum Attribute {
    /// UTF-8.
    Text(String),
    /// Double precision.
    Number(f64),
    /// Single precision.
    Single(f32),
    /// 32 bits.
    Integer(i32),
}

/// Values of a variable.
#[derive(Clone, Debug)]
pub enum Values {
    /// Double precision.
    Double(Vec<f64>),
    /// Single precision.
    Single(Vec<f32>),
}

impl Values {
    /// Type, bytes, and number of the values.
    fn layout(&self) -> (u32, usize, usize) {
        match self {
            Values::Double(values) => (DOUBLE, 8, values.len()),
            Values::Single(values) => (FLOAT, 4, values.len()),
        }
    }

    fn write(&self, out: &mut Vec<u8>) {
        match self {
            Values::Double(values) => out.extend(values.iter().flat_map(|v| v.to_be_bytes())),
            Values::Single(values) => out.extend(values.iter().flat_map(|v| v.to_be_bytes())),
        }
    }
}

/// A variable.
#[derive(Clone, Debug)]
pub struct Variable {
    /// Its name.
    pub name: String,
    /// Indices of its dimensions in [`Dataset::dimensions`], the slowest first; empty for a scalar.
    pub dimensions: Vec<usize>,
    /// Names and values of its attributes.
    pub attributes: Vec<(&'static str, Attribute)>,
    /// Its values, as many as the product of its dimensions.
    pub values: Values,
}

/// A netCDF file.
#[derive(Clone, Debug, Default)]
pub struct Dataset {
    /// Names and lengths of the dimensions.
    pub dimensions: Vec<(&'static str, usize)>,
    /// Names and values of the global attributes.
    pub attributes: Vec<(&'static str, Attribute)>,
    /// The variables.
    pub variables: Vec<Variable>,
}

const MAGIC: &[u8] = b"CDF\x02";
const DIMENSIONS: u32 = 10;
const VARIABLES: u32 = 11;
const ATTRIBUTES: u32 = 12;
const CHAR: u32 = 2;
const INT: u32 = 4;
const FLOAT: u32 = 5;
const DOUBLE: u32 = 6;

impl Dataset {
    /// The bytes of the file: a header, then the values of each variable.
    pub fn to_bytes(&self) -> Vec<u8> {
        // The size of the offsets does not depend on their values.
        let n_header = self.header(0).len();
        let mut bytes = self.header(n_header);
        for variable in &self.variables {
            variable.values.write(&mut bytes);
        }
        bytes
    }

    /// The header; the values begin at this byte.
    fn header(&self, begin: usize) -> Vec<u8> {
        let mut out = MAGIC.to_vec();
        // No records.
        word(&mut out, 0);
        list(&mut out, DIMENSIONS, self.dimensions.len());
        for (dimension, length) in &self.dimensions {
            name(&mut out, dimension);
            word(&mut out, *length);
        }
        attributes(&mut out, &self.attributes);
        list(&mut out, VARIABLES, self.variables.len());
        let mut begin = begin;
        for variable in &self.variables {
            name(&mut out, &variable.name);
            word(&mut out, variable.dimensions.len());
            for dimension in &variable.dimensions {
                word(&mut out, *dimension);
            }
            attributes(&mut out, &variable.attributes);
            let (kind, width, n) = variable.values.layout();
            tag(&mut out, kind);
            let n_bytes = width * n;
            word(&mut out, n_bytes);
            out.extend((begin as u64).to_be_bytes());
            begin += n_bytes;
        }
        out
    }
}

fn tag(out: &mut Vec<u8>, tag: u32) {
    out.extend(tag.to_be_bytes());
}

/// A count; those of results are far below the format's limit of four gigabytes.
fn word(out: &mut Vec<u8>, count: usize) {
    tag(out, u32::try_from(count).unwrap_or(u32::MAX));
}

/// Head of a list; an empty one has no tag.
fn list(out: &mut Vec<u8>, of: u32, n: usize) {
    tag(out, if n == 0 { 0 } else { of });
    word(out, n);
}

/// Padding to a multiple of four bytes.
fn padded(out: &mut Vec<u8>, bytes: &[u8]) {
    out.extend(bytes);
    out.resize(out.len().next_multiple_of(4), 0);
}

fn name(out: &mut Vec<u8>, name: &str) {
    word(out, name.len());
    padded(out, name.as_bytes());
}

fn attributes(out: &mut Vec<u8>, all: &[(&str, Attribute)]) {
    list(out, ATTRIBUTES, all.len());
    for (key, value) in all {
        name(out, key);
        match value {
            Attribute::Text(text) => {
                tag(out, CHAR);
                name(out, text);
            }
            Attribute::Number(number) => {
                tag(out, DOUBLE);
                word(out, 1);
                out.extend(number.to_be_bytes());
            }
            Attribute::Single(number) => {
                tag(out, FLOAT);
                word(out, 1);
                out.extend(number.to_be_bytes());
            }
            Attribute::Integer(integer) => {
                tag(out, INT);
                word(out, 1);
                out.extend(integer.to_be_bytes());
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By hand from the grammar of the specification: two points, one variable, and a single attribute, of the file.
    #[test]
    fn bytes_are_those_of_the_specification() {
        let data = Dataset {
            dimensions: vec![("x", 2)],
            attributes: vec![("title", Attribute::Text("oil".to_owned()))],
            variables: vec![Variable {
                name: "p".to_owned(),
                dimensions: vec![0],
                attributes: Vec::new(),
                values: Values::Double(vec![1.0, -2.0]),
            }],
        };
        let mut expected = b"CDF\x02".to_vec();
        expected.extend([0; 4]);
        expected.extend(b"\0\0\0\x0a\0\0\0\x01\0\0\0\x01x\0\0\0\0\0\0\x02");
        expected.extend(b"\0\0\0\x0c\0\0\0\x01\0\0\0\x05title\0\0\0\0\0\0\x02\0\0\0\x03oil\0");
        expected.extend(b"\0\0\0\x0b\0\0\0\x01\0\0\0\x01p\0\0\0\0\0\0\x01\0\0\0\0");
        expected.extend([0; 8]);
        expected.extend(b"\0\0\0\x06\0\0\0\x10\0\0\0\0\0\0\0\x6c");
        expected.extend(b"\x3f\xf0\0\0\0\0\0\0\xc0\0\0\0\0\0\0\0");
        assert_eq!(data.to_bytes(), expected);
        // The same in single precision: another type, half the bytes.
        let mut single = data;
        single.variables[0].values = Values::Single(vec![1.0, -2.0]);
        let n = expected.len();
        expected.truncate(n - 16);
        expected[n - 16 - 13] = 5;
        expected[n - 16 - 9] = 8;
        expected.extend(b"\x3f\x80\0\0\xc0\0\0\0");
        assert_eq!(single.to_bytes(), expected);
    }
}
