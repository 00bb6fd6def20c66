//! The files that a case names.

use std::path::{Path, PathBuf};

use serde_json::Value;

use ertel_rheology::database::{Kind, own_path};

use super::Case;

impl Case {
    /// The tables of data that the case names by `file = "..."`, and its own lubricants and materials, found in the folder of its file.
    pub fn files(&self, folder: &Path) -> Vec<PathBuf> {
        let mut files = Vec::new();
        collect(&self.given, folder, &mut files);
        files
    }
}

/// The user's files that a value may name, such as a lubricant or a material.
fn own(key: &str, name: &str, folder: &Path) -> Vec<PathBuf> {
    const KEYS: [&str; 4] = ["lubricant", "name", "body_1", "body_2"];
    if !KEYS.contains(&key) {
        return Vec::new();
    }
    let kinds = [Kind::Fluid, Kind::Solid].into_iter();
    let mut paths: Vec<PathBuf> = kinds
        .filter_map(|kind| own_path(kind, name, folder))
        .collect();
    paths.dedup();
    paths
}

fn collect(value: &Value, folder: &Path, files: &mut Vec<PathBuf>) {
    match value {
        Value::Object(entries) => {
            for (key, value) in entries {
                match value {
                    Value::String(name) if key == "file" => files.push(folder.join(name)),
                    Value::String(name) => files.extend(own(key, name, folder)),
                    value => collect(value, folder, files),
                }
            }
        }
        Value::Array(values) => values.iter().for_each(|v| collect(v, folder, files)),
        _ => {}
    }
}
