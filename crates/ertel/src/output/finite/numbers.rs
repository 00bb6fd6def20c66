//! The first non-finite number of any serialisable value. Nothing is stored, so fields of millions of numbers cost little.

use std::fmt::Display;

use serde::ser::{
    Error, Serialize, SerializeMap, SerializeSeq, SerializeStruct, SerializeStructVariant,
    SerializeTuple, SerializeTupleStruct, SerializeTupleVariant, Serializer,
};

/// Path of the first non-finite number: `.film_central.value`, `[3]`.
pub(super) fn first_not_finite(value: &impl Serialize) -> Option<String> {
    value.serialize(Look).err().map(|found| found.0)
}

/// Path of a non-finite number, relative to the scanned value.
#[derive(Debug)]
struct Found(String);

impl Found {
    fn within(self, part: impl Display) -> Found {
        Found(format!("{part}{}", self.0))
    }
}

impl Display for Found {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for Found {}

impl Error for Found {
    fn custom<T: Display>(reason: T) -> Found {
        Found(format!(" ({reason})"))
    }
}

type Looked = Result<(), Found>;

/// Scans a value.
struct Look;

/// Scans the parts of a value by index or key.
#[derive(Default)]
struct Parts {
    number: usize,
    key: String,
}

impl Parts {
    fn element<T: Serialize + ?Sized>(&mut self, value: &T) -> Looked {
        let looked = value.serialize(Look);
        self.number += 1;
        looked.map_err(|found| found.within(format_args!("[{}]", self.number - 1)))
    }

    fn field<T: Serialize + ?Sized>(&mut self, key: impl Display, value: &T) -> Looked {
        let looked = value.serialize(Look);
        looked.map_err(|found| found.within(format_args!(".{key}")))
    }
}

/// Values that cannot hold a non-finite number.
macro_rules! fine {
    ($($name:ident: $kind:ty),*) => {
        $(fn $name(self, _: $kind) -> Looked {
            Ok(())
        })*
    };
}

impl Serializer for Look {
    type Ok = ();
    type Error = Found;
    type SerializeSeq = Parts;
    type SerializeTuple = Parts;
    type SerializeTupleStruct = Parts;
    type SerializeTupleVariant = Parts;
    type SerializeMap = Parts;
    type SerializeStruct = Parts;
    type SerializeStructVariant = Parts;

    fine!(
        serialize_bool: bool, serialize_i8: i8, serialize_i16: i16, serialize_i32: i32, serialize_i64: i64, serialize_u8: u8,
        serialize_u16: u16, serialize_u32: u32, serialize_u64: u64, serialize_char: char, serialize_str: &str,
        serialize_bytes: &[u8], serialize_unit_struct: &'static str
    );

    fn serialize_f32(self, value: f32) -> Looked {
        self.serialize_f64(value.into())
    }

    fn serialize_f64(self, value: f64) -> Looked {
        match value.is_finite() {
            true => Ok(()),
            false => Err(Found(String::new())),
        }
    }

    fn serialize_none(self) -> Looked {
        Ok(())
    }

    fn serialize_some<T: Serialize + ?Sized>(self, value: &T) -> Looked {
        value.serialize(self)
    }

    fn serialize_unit(self) -> Looked {
        Ok(())
    }

    fn serialize_unit_variant(self, _: &'static str, _: u32, _: &'static str) -> Looked {
        Ok(())
    }

    fn serialize_newtype_struct<T: Serialize + ?Sized>(self, _: &'static str, value: &T) -> Looked {
        value.serialize(self)
    }

    fn serialize_newtype_variant<T: Serialize + ?Sized>(
        self,
        _: &'static str,
        _: u32,
        variant: &'static str,
        value: &T,
    ) -> Looked {
        Parts::default().field(variant, value)
    }

    fn serialize_seq(self, _: Option<usize>) -> Result<Parts, Found> {
        Ok(Parts::default())
    }

    fn serialize_tuple(self, _: usize) -> Result<Parts, Found> {
        Ok(Parts::default())
    }

    fn serialize_tuple_struct(self, _: &'static str, _: usize) -> Result<Parts, Found> {
        Ok(Parts::default())
    }

    fn serialize_tuple_variant(
        self,
        _: &'static str,
        _: u32,
        _: &'static str,
        _: usize,
    ) -> Result<Parts, Found> {
        Ok(Parts::default())
    }

    fn serialize_map(self, _: Option<usize>) -> Result<Parts, Found> {
        Ok(Parts::default())
    }

    fn serialize_struct(self, _: &'static str, _: usize) -> Result<Parts, Found> {
        Ok(Parts::default())
    }

    fn serialize_struct_variant(
        self,
        _: &'static str,
        _: u32,
        _: &'static str,
        _: usize,
    ) -> Result<Parts, Found> {
        Ok(Parts::default())
    }
}

/// Parts by index.
macro_rules! by_number {
    ($($kind:ident, $method:ident);*) => {
        $(impl $kind for Parts {
            type Ok = ();
            type Error = Found;

            fn $method<T: Serialize + ?Sized>(&mut self, value: &T) -> Looked {
                self.element(value)
            }

            fn end(self) -> Looked {
                Ok(())
            }
        })*
    };
}

by_number!(
    SerializeSeq, serialize_element;
    SerializeTuple, serialize_element;
    SerializeTupleStruct, serialize_field;
    SerializeTupleVariant, serialize_field
);

/// Parts by field name.
macro_rules! by_field {
    ($($kind:ident),*) => {
        $(impl $kind for Parts {
            type Ok = ();
            type Error = Found;

            fn serialize_field<T: Serialize + ?Sized>(&mut self, key: &'static str, value: &T) -> Looked {
                self.field(key, value)
            }

            fn end(self) -> Looked {
                Ok(())
            }
        })*
    };
}

by_field!(SerializeStruct, SerializeStructVariant);

impl SerializeMap for Parts {
    type Ok = ();
    type Error = Found;

    fn serialize_key<T: Serialize + ?Sized>(&mut self, key: &T) -> Looked {
        let text = serde_json::to_string(key).map_err(Found::custom)?;
        self.key = text.trim_matches('"').to_owned();
        Ok(())
    }

    fn serialize_value<T: Serialize + ?Sized>(&mut self, value: &T) -> Looked {
        let key = std::mem::take(&mut self.key);
        self.field(key, value)
    }

    fn end(self) -> Looked {
        Ok(())
    }
}
