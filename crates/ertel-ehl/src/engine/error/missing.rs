//! Data of materials that heat needs and that are not there.

use std::fmt;

use thiserror::Error;

/// Data without which no thermal contact can be computed.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("heat cannot be computed without {}", list(.missing))]
pub struct MissingHeatData {
    /// At least one.
    pub missing: Vec<MissingDatum>,
}

/// A missing datum, its material, and the table where it belongs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MissingDatum {
    /// Its key, `heat_capacity`.
    pub key: &'static str,
    /// `lubricant`, `body_1`, `body_2`, or `the layers of` one of them.
    pub part: &'static str,
    /// Name of the material; `None` for one that the case file gives by its constants.
    pub material: Option<String>,
}

impl fmt::Display for MissingDatum {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let whose = match self.part {
            "lubricant" => "the lubricant".to_owned(),
            body => body.replace('_', " "),
        };
        write!(f, "the {} of {whose}", self.key)?;
        match &self.material {
            Some(name) => write!(f, " ({name})"),
            None => Ok(()),
        }
    }
}

fn list(missing: &[MissingDatum]) -> String {
    let names: Vec<String> = missing.iter().map(ToString::to_string).collect();
    names.join(", ")
}

impl MissingHeatData {
    /// Where to add the data, in words.
    pub fn advice(&self) -> String {
        let mut places: Vec<String> = Vec::new();
        for MissingDatum {
            key,
            part,
            material,
        } in &self.missing
        {
            let unit = match *key {
                "density" => "kg/m^3",
                "heat_capacity" => "J/(kg.K)",
                _ => "W/(m.K)",
            };
            let datum = format!("{key} = \"... {unit}\"");
            places.push(match (*part, material) {
                ("lubricant", _) => format!("add {datum} to [lubricant]"),
                (part, Some(name)) if part.starts_with("the layers") => {
                    let body = part.trim_start_matches("the layers of ");
                    format!("add {datum} to the layer `{name}` of {body} in [bodies]")
                }
                (_, Some(name)) => {
                    format!("add {datum} in [bodies], {part} = {{ name = \"{name}\", {datum} }}")
                }
                (_, None) => format!("add {datum} to `{part}` in [bodies]"),
            });
        }
        let database = if self.missing.iter().any(|datum| datum.material.is_some()) {
            ", or to the entry of the material in the database"
        } else {
            ""
        };
        // The kind is not known: otherwise the numbers would have been estimated.
        let kind = if self.missing.iter().any(|datum| datum.part == "lubricant") {
            "; what the lubricant lacks is estimated where `base_oil` in [lubricant] names its kind: \"mineral\", \"PAO\", \"ester\", \
             \"PAG\", \"naphthenic\" or \"Group III\""
        } else {
            ""
        };
        format!(
            "{}{database}{kind}; `isothermal = true` in [solver] leaves heat out",
            places.join("; ")
        )
    }
}
