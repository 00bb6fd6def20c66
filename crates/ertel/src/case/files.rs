//! The files that a case names.

use std::path::{Path, PathBuf};

use serde_json::Value;

use super::Case;

impl Case {
    /// The tables of data that the case names by `file = "..."`, found in the folder of its file.
    pub fn files(&self, folder: &Path) -> Vec<PathBuf> {
        let mut files = Vec::new();
        collect(&self.given, folder, &mut files);
        files
    }
}

fn collect(value: &Value, folder: &Path, files: &mut Vec<PathBuf>) {
    match value {
        Value::Object(entries) => {
            for (key, value) in entries {
                match value {
                    Value::String(name) if key == "file" => files.push(folder.join(name)),
                    value => collect(value, folder, files),
                }
            }
        }
        Value::Array(values) => values.iter().for_each(|v| collect(v, folder, files)),
        _ => {}
    }
}
