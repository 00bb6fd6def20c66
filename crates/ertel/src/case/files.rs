//! The files that a case names.

use std::path::{Path, PathBuf};

use serde_json::Value;

use ertel_rheology::database;

use super::Case;

impl Case {
    /// The tables of data that the case names by `file = "..."`, and its own lubricants and materials, found in the folder of its file.
    pub fn files(&self, folder: &Path) -> Vec<PathBuf> {
        let mut files = Vec::new();
        collect(&self.given, folder, &mut files);
        files
    }
}

/// Whether a value names a lubricant or a material in a file.
fn is_own(key: &str, name: &str) -> bool {
    const KEYS: [&str; 6] = ["lubricant", "name", "plane", "ball", "body_1", "body_2"];
    KEYS.contains(&key) && database::is_file(name)
}

fn collect(value: &Value, folder: &Path, files: &mut Vec<PathBuf>) {
    match value {
        Value::Object(entries) => {
            for (key, value) in entries {
                match value {
                    Value::String(name) if key == "file" || is_own(key, name) => {
                        files.push(folder.join(name));
                    }
                    value => collect(value, folder, files),
                }
            }
        }
        Value::Array(values) => values.iter().for_each(|v| collect(v, folder, files)),
        _ => {}
    }
}
