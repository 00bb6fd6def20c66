//! Cases made in code.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use ertel_input::InputError;

use super::Case;
use super::study::quoted;

/// Makes a case from the keys and values of a case file.
///
/// It is read by the readers of case files: the same keys, the same bounds, the same messages, and machines, curves and uncertainties
/// as in a file. Errors show the line that a call of [`CaseBuilder::set`] makes.
///
/// ```
/// use ertel::case::Case;
///
/// let case = Case::builder()
///     .set("contact.kind", "line")
///     .set("contact.radius", "10 mm")
///     .set("contact.load", "100 kN/m")
///     .set("bodies.body_1", "steel")
///     .set("bodies.body_2", "steel")
///     .set("motion.entrainment_speed", "2 m/s")
///     .set("motion.slide_to_roll_ratio", 0.0)
///     .set("lubricant", "squalane-pip")
///     .set("temperature", "40 degC")
///     .build()?;
/// assert_eq!(case.contact.radius, 0.01);
///
/// let error = Case::builder().set("contact.radius", "-1 mm").build().unwrap_err();
/// assert!(error.to_string().contains("contact.radius"));
/// # Ok::<(), ertel_input::InputError>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CaseBuilder {
    text: String,
    folder: PathBuf,
}

/// A value of a case.
#[derive(Clone, Debug, PartialEq)]
pub enum Setting {
    /// A quantity with its unit, `"16 mm"`, or a name.
    Text(String),
    /// A number without unit.
    Number(f64),
    /// A whole number.
    Count(i64),
    /// A switch.
    Switch(bool),
    /// A list, as of the values of a curve.
    List(Vec<Setting>),
    /// A table of keys and values.
    Table(Vec<(String, Setting)>),
}

impl CaseBuilder {
    /// Sets a key, given by its path in a case file.
    #[must_use]
    pub fn set(mut self, key: &str, value: impl Into<Setting>) -> Self {
        let path: Vec<String> = key.split('.').map(bare_or_quoted).collect();
        let _ = writeln!(self.text, "{} = {}", path.join("."), value.into().toml());
        self
    }

    /// Folder where tables of data and files of materials are found; else the current one.
    #[must_use]
    pub fn folder(mut self, folder: &Path) -> Self {
        folder.clone_into(&mut self.folder);
        self
    }

    /// The equivalent case file.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The case.
    ///
    /// # Errors
    ///
    /// As [`Case::read`], with the line of [`CaseBuilder::text`].
    pub fn build(&self) -> Result<Case, InputError> {
        Case::from_text("case made in code", &self.text, &self.folder)
    }
}

impl Setting {
    /// As a value of a TOML file.
    fn toml(&self) -> String {
        match self {
            Setting::Text(text) => quoted(text),
            // The readers refuse infinities and NaN, and report their key.
            Setting::Number(value) if value.is_finite() => format!("{value:?}"),
            Setting::Number(value) if value.is_nan() => "nan".to_owned(),
            Setting::Number(value) if *value > 0.0 => "inf".to_owned(),
            Setting::Number(_) => "-inf".to_owned(),
            Setting::Count(value) => value.to_string(),
            Setting::Switch(value) => value.to_string(),
            Setting::List(values) => {
                let values: Vec<String> = values.iter().map(Setting::toml).collect();
                format!("[{}]", values.join(", "))
            }
            Setting::Table(entries) => {
                let entry = |(key, value): &(String, Setting)| {
                    format!("{} = {}", bare_or_quoted(key), value.toml())
                };
                let entries: Vec<String> = entries.iter().map(entry).collect();
                format!("{{ {} }}", entries.join(", "))
            }
        }
    }
}

/// A part of a key as TOML has it.
fn bare_or_quoted(key: &str) -> String {
    let is_bare = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
    match !key.is_empty() && key.chars().all(is_bare) {
        true => key.to_owned(),
        false => quoted(key),
    }
}

impl From<&str> for Setting {
    fn from(text: &str) -> Self {
        Setting::Text(text.to_owned())
    }
}

impl From<String> for Setting {
    fn from(text: String) -> Self {
        Setting::Text(text)
    }
}

impl From<f64> for Setting {
    fn from(value: f64) -> Self {
        Setting::Number(value)
    }
}

impl From<i64> for Setting {
    fn from(value: i64) -> Self {
        Setting::Count(value)
    }
}

impl From<bool> for Setting {
    fn from(value: bool) -> Self {
        Setting::Switch(value)
    }
}

impl<T: Into<Setting>> From<Vec<T>> for Setting {
    fn from(values: Vec<T>) -> Self {
        Setting::List(values.into_iter().map(Into::into).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn roller() -> CaseBuilder {
        Case::builder()
            .set("contact.kind", "line")
            .set("contact.radius", "10 mm")
            .set("contact.load", "100 kN/m")
            .set("bodies.body_1", "steel")
            .set("bodies.body_2.youngs_modulus", "210 GPa")
            .set("bodies.body_2.poissons_ratio", 0.3)
            .set("motion.entrainment_speed", "2 m/s")
            .set("motion.slide_to_roll_ratio", 0.0)
            .set("lubricant", "squalane-pip")
            .set("temperature", "40 degC")
    }

    /// A built case equals that of the equivalent file.
    #[test]
    fn built_and_read_are_one() {
        let built = roller().build().unwrap();
        let file = "temperature = '40 degC'\nlubricant = 'squalane-pip'\n\
                    [contact]\nkind = 'line'\nradius = '10 mm'\nload = '100 kN/m'\n\
                    [bodies]\nbody_1 = 'steel'\nbody_2 = { youngs_modulus = '210 GPa', poissons_ratio = 0.3 }\n\
                    [motion]\nentrainment_speed = '2 m/s'\nslide_to_roll_ratio = 0.0\n";
        let read = Case::from_text("case.toml", file, Path::new("")).unwrap();
        assert_eq!(built.echo().contact, read.echo().contact);
        assert_eq!(built.motion, read.motion);
        assert_eq!(built.body_2.elasticity, read.body_2.elasticity);
        let values = vec!["1 m/s", "2 m/s"];
        let curve = roller()
            .set("curve.quantity", "motion.entrainment_speed")
            .set("curve.values", values)
            .build()
            .unwrap();
        assert_eq!(curve.curve.unwrap().points.len(), 2);
    }

    /// Errors name the key and show the line of the builder.
    #[test]
    fn bad_input_is_refused_as_in_a_file() {
        for (key, value, words) in [
            ("contact.radius", Setting::from("-1 mm"), "`radius`"),
            ("contact.radius", Setting::from("16 s"), "radius"),
            ("motion.spin", Setting::from(f64::NAN), "spin"),
            ("contact.radios", Setting::from("16 mm"), "unknown key"),
            (
                "motion.slide_to_roll_ratio",
                Setting::from(f64::INFINITY),
                "slide_to_roll_ratio",
            ),
            ("a b\n.c", Setting::from(1.0), "unknown"),
        ] {
            let text = roller().text().to_owned();
            let kept = text
                .lines()
                .filter(|line| !line.starts_with(&format!("{key} =")));
            let mut builder = CaseBuilder {
                text: kept.map(|line| format!("{line}\n")).collect(),
                folder: PathBuf::new(),
            };
            builder = builder.set(key, value);
            let error = builder.build().unwrap_err().to_string();
            assert!(
                error.contains(words) && error.contains("case made in code"),
                "{error}"
            );
        }
        let twice = roller().set("contact.radius", "11 mm").build();
        assert!(twice.unwrap_err().to_string().contains("radius"));
    }
}
