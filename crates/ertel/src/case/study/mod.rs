//! Study files: a base case and axes over any of its input keys.
//!
//! ```toml
//! title = "Ball on disc, speed and load"
//! case = "ball-on-disc.toml"        # next to the study
//!
//! [[axis]]
//! key = "motion.entrainment_speed"
//! from = "0.1 m/s"
//! to = "10 m/s"
//! points = 9
//! spacing = "log"
//!
//! [[axis]]
//! key = "contact.load"
//! values = ["10 N", "50 N"]
//! ```
//!
//! Axes are crossed, the last one varying fastest; those with the same `zip` vary together. `points = "points.csv"`
//! reads a table whose headers are input keys with units, and counts as the first axis. Each point is the
//! base case read again with its values: every check of a case applies, and errors point to the study.

mod axis;
mod columns;
mod in_time;
mod points;
mod text;
pub(super) mod values;

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use ertel_input::tree::{Node, Value};
use ertel_input::{Document, InputError, Table, excerpt, keys};
use ertel_quantity::Dimension;
use rayon::prelude::*;

use super::Case;
use super::set::with_settings;
use crate::contact::ContactKind;
use axis::Group;
pub use columns::PointColumn;
pub(crate) use points::split_title;
pub(super) use text::{inline, quoted, to_toml};
pub use values::AxisValue;
pub(crate) use values::header;

/// Points of one study, at most: each takes about 10 kB of memory while it runs.
pub const MOST_POINTS: usize = 1_000_000;

/// A base case and the points that axes make of it.
#[derive(Clone, Debug)]
pub struct Study {
    /// Title; empty if the file gives none.
    pub title: String,
    /// The base case.
    pub base: PathBuf,
    /// The varied keys, in the order of the table's columns.
    pub columns: Vec<StudyColumn>,
    /// The points, the last axis varying fastest.
    pub points: Vec<StudyPoint>,
    /// Every file that it was read from: the study, its base case, its points, and the tables that its cases name.
    pub files: Vec<PathBuf>,
    /// Text of the study file.
    pub source: String,
    /// Line or circular, the same in all points.
    pub kind: ContactKind,
    /// Source of the points; `None` for those made in code.
    reader: Option<Arc<Reader>>,
    /// Place of each point among all that the file has.
    places: Vec<usize>,
}

/// Source of the points of a study.
#[derive(Debug)]
struct Reader {
    case: Document,
    folder: PathBuf,
    groups: Vec<Group>,
    /// The file that defines the points, as errors name it.
    name: String,
}

impl Reader {
    fn read(&self, index: usize) -> Result<StudyPoint, InputError> {
        let settings = settings_of(&self.groups, index);
        let naming = |label: &str| format!("point {} of {}: {label}", index + 1, self.name);
        let (mut point, varied) = StudyPoint::read(
            &self.case,
            &self.folder,
            &settings,
            &BTreeMap::new(),
            naming,
        )?;
        point.case.source = format!(
            "# Point {} of {}: {}\n{}",
            index + 1,
            excerpt(&self.name),
            excerpt(&point.label),
            text::to_toml(varied.tree())
        );
        Ok(point)
    }
}

/// A key that varies.
#[derive(Clone, Debug, PartialEq)]
pub struct StudyColumn {
    /// Key path in the case file.
    pub key: String,
    /// Title of its column: the key, and the SI unit of a quantity, `contact.load_N`.
    pub header: String,
    /// The unit in which the user gave its first value, `kN`; empty where it has none.
    pub unit: String,
}

impl StudyColumn {
    /// Of a key whose values measure something.
    pub(crate) fn of(key: &str, dimension: Dimension) -> Self {
        Self {
            key: key.to_owned(),
            header: header(key, dimension),
            unit: String::new(),
        }
    }
}

/// A point of a study.
#[derive(Clone, Debug)]
pub struct StudyPoint {
    /// Values of the columns.
    pub values: Vec<AxisValue>,
    /// The values as they are shown: `contact.load = 10 N, motion.entrainment_speed = 0.1 m/s`.
    pub label: String,
    /// The case; in a study that was read without its text, the contacts of a machine and where its quantities come from
    /// ([`Study::whole_point`] has them).
    pub case: Case,
}

impl StudyPoint {
    /// Reads the case of a document with settings in place and other values, SI, at the key paths `replaced`, of a whole machine with its
    /// contacts, and returns the document with the settings; `naming` names the point in an error, from its label.
    pub(super) fn read(
        document: &Document,
        folder: &Path,
        settings: &[Setting],
        replaced: &BTreeMap<String, f64>,
        naming: impl Fn(&str) -> String,
    ) -> Result<(Self, Document), InputError> {
        let label = settings
            .iter()
            .map(|s| match &s.node.value {
                Value::Str(text) => format!("{} = {text}", s.key),
                _ => format!("{} = {}", s.key, s.value),
            })
            .collect::<Vec<_>>()
            .join(", ");
        let mut varied = document.clone();
        let mut read = || -> Result<Case, InputError> {
            for setting in settings {
                varied.put(&setting.key, &setting.key_span, setting.node.clone())?;
            }
            let mut case = Case::without_curve(&varied, folder, replaced.clone())?;
            case.read_contacts(&varied, folder, replaced)?;
            for setting in settings {
                in_time::check_effect(&varied, setting)?;
            }
            Ok(case)
        };
        let mut case = read().map_err(|error| {
            keys::unknown_first(&varied, keys::CASE, error).with_help(naming(&label))
        })?;
        let keys = settings.iter().map(|s| s.key.as_str());
        let ignored = case.lubricant.temperature_ignored(keys, "varies");
        case.warn(ignored);
        let values = settings.iter().map(|s| s.value.clone()).collect();
        let point = StudyPoint {
            values,
            label,
            case,
        };
        Ok((point, varied))
    }

    /// Value of the first column, SI; NaN where that is no number.
    pub fn value(&self) -> f64 {
        let first = self.values.first();
        first.and_then(AxisValue::number).unwrap_or(f64::NAN)
    }
}

/// A value on its way into the case.
#[derive(Clone, Debug)]
pub(super) struct Setting {
    pub(super) key: String,
    pub(super) key_span: Range<usize>,
    pub(super) node: Node,
    pub(super) value: AxisValue,
}

impl Study {
    /// A study made in code of points of one case.
    pub(crate) fn of_samples(
        base: &Case,
        columns: Vec<StudyColumn>,
        points: Vec<StudyPoint>,
    ) -> Self {
        Self {
            title: base.title.clone(),
            base: PathBuf::new(),
            columns,
            points,
            files: Vec::new(),
            source: base.source.clone(),
            kind: base.contact.kind,
            reader: None,
            places: Vec::new(),
        }
    }

    /// A point whose case has its text, the contacts of a machine and where its quantities come from, read again; `None` where that fails now, or the points
    /// were made in code and have all of it.
    pub fn whole_point(&self, index: usize) -> Option<StudyPoint> {
        self.reader.as_ref()?.read(self.places[index]).ok()
    }

    /// Reads a study, its base case and every point of it.
    ///
    /// # Errors
    ///
    /// [`InputError`] with file, line and key: of the study itself, of the table of points, and of any case that
    /// comes of them.
    pub fn read(path: &Path) -> Result<Self, InputError> {
        Self::read_some(path, None)
    }

    /// Reads a study with values that replace those of its base case, each written `key=value` as in
    /// [`Case::from_text_with`].
    ///
    /// # Errors
    ///
    /// As [`Study::read`]; settings that are none, and one of a key that varies.
    pub fn read_with(path: &Path, settings: &[String]) -> Result<Self, InputError> {
        Self::read_of(path, settings, None)
    }

    /// Reads a study with some of its points alone, given by their places, in this order; `None` for all of them.
    ///
    /// # Errors
    ///
    /// As [`Study::read`], of these points; places that the study does not have.
    pub fn read_some(path: &Path, places: Option<&[usize]>) -> Result<Self, InputError> {
        Self::read_of(path, &[], places)
    }

    fn read_of(
        path: &Path,
        settings: &[String],
        places: Option<&[usize]>,
    ) -> Result<Self, InputError> {
        let study = Document::read(path)?;
        Self::of_document(&study, path, settings, places)
            .map_err(|error| keys::unknown_first(&study, keys::STUDY, error))
    }

    fn of_document(
        study: &Document,
        path: &Path,
        settings: &[String],
        places: Option<&[usize]>,
    ) -> Result<Self, InputError> {
        let folder = path.parent().unwrap_or(Path::new(""));
        let mut root = study.root();
        let title = root.optional_str("title")?.unwrap_or_default().to_owned();
        let base = folder.join(root.required_str("case").map_err(|error| {
            error.with_help("the case that the axes start from, as in case = \"base.toml\"")
        })?);
        let case = read_named(&root, "case", &base)?;
        if case.tree().entry("curve").is_some() {
            return Err(root
                .error("case", "the base case of a study has a [curve]")
                .with_help("make an [[axis]] of it"));
        }
        let case = with_settings(case, settings)?;
        let (case, offset) = case.with_file(study.file(), study.text());
        let mut files = vec![path.to_owned(), base.clone()];
        let (case, mut groups) = match root.optional_str("points")? {
            None => (case, Vec::new()),
            Some(name) => {
                let table = folder.join(name);
                let (case, group) = points::read(case, &table, study)?;
                files.push(table);
                (case, vec![group])
            }
        };
        groups.extend(axis::read(&mut root, study, offset)?);
        root.finish()?;
        if groups.is_empty() {
            return Err(study.root().missing("axis").with_help(
                "what varies: [[axis]] with `key` and `values`, or a table `points = \"points.csv\"`",
            ));
        }
        check_settings(&case, settings, &groups)?;
        // Stored with the results: the file alone does not define what was solved.
        let heads: String = (settings.iter())
            .map(|setting| format!("# --set {}\n", setting.replace(char::is_control, " ")))
            .collect();
        let text = heads + study.text();
        let source = Source {
            name: study.file(),
            text: &text,
            error: &|message| study.root().error_here(message),
        };
        build(title, base, &case, &groups, &source, (files, places))
    }
}

/// The file that defines the points of a study.
struct Source<'a> {
    /// As errors name it.
    name: &'a str,
    /// Its text.
    text: &'a str,
    /// An error about all of it.
    error: &'a dyn Fn(String) -> InputError,
}

/// Reads every point of a study whose base case and axes are known.
fn build(
    title: String,
    base: PathBuf,
    case: &Document,
    groups: &[Group],
    source: &Source<'_>,
    (mut files, places): (Vec<PathBuf>, Option<&[usize]>),
) -> Result<Study, InputError> {
    check_keys(case, groups)?;
    let n_points = groups
        .iter()
        .try_fold(1usize, |n, group| n.checked_mul(group.len()));
    let n_points = n_points
        .filter(|n| *n <= MOST_POINTS)
        .ok_or_else(|| (source.error)(format!("these are more than {MOST_POINTS} points")))?;
    let reader = Reader {
        case: case.clone(),
        folder: base.parent().unwrap_or(Path::new("")).to_owned(),
        groups: groups.to_vec(),
        name: source.name.to_owned(),
    };
    let places: Vec<usize> = places.map_or_else(|| (0..n_points).collect(), <[usize]>::to_vec);
    if places.is_empty() || places.iter().any(|place| *place >= n_points) {
        return Err((source.error)(format!(
            "there are {n_points} points, and not all of those asked for"
        )));
    }
    // An error common to all points is reported before there are a million of them.
    reader.read(places[0])?;
    let read: Vec<Result<(StudyPoint, Vec<PathBuf>), InputError>> = (places.par_iter())
        .map(|index| {
            let mut point = reader.read(*index)?;
            let files = point.case.files(&reader.folder);
            // There may be a million of them.
            let case = &mut point.case;
            (case.origin, case.given) = (None, serde_json::Value::Null);
            case.contacts = None;
            case.source = String::new();
            Ok((point, files))
        })
        .collect();
    let mut tables = BTreeSet::new();
    let mut points = Vec::with_capacity(places.len());
    for point in read {
        let (point, files) = point?;
        points.push(point);
        tables.extend(files);
    }
    files.extend(tables);
    let kind = points[0].case.contact.kind;
    if let Some(i) = points.iter().position(|p| p.case.contact.kind != kind) {
        return Err((source.error)(format!(
            "point 1 is a {kind:?} contact and point {} is not: their tables have different units; make two studies \
             of them",
            i + 1
        )));
    }
    let columns = groups
        .iter()
        .flat_map(|group| &group.axes)
        .map(|axis| StudyColumn {
            key: axis.key.clone(),
            header: axis.header(),
            unit: axis.unit(),
        })
        .collect();
    Ok(Study {
        reader: Some(Arc::new(reader)),
        places,
        title,
        base,
        columns,
        points,
        files,
        source: source.text.to_owned(),
        kind,
    })
}

/// Reads a file that the key `key` of a table names: where it cannot be read, the error points at that key.
pub fn read_named(table: &Table<'_>, key: &str, path: &Path) -> Result<Document, InputError> {
    Document::read(path).map_err(|error| match error.line() {
        Some(_) => error,
        None => table.error(key, format!("{} {}", error.file(), error.message())),
    })
}

/// Refuses a value that every point replaces: it would have no effect.
fn check_settings(
    case: &Document,
    settings: &[String],
    groups: &[Group],
) -> Result<(), InputError> {
    for setting in settings {
        let key = setting.split('=').next().unwrap_or_default();
        let mut axes = groups.iter().flat_map(|group| &group.axes);
        if let Some(axis) = axes.find(|axis| axis.key == key) {
            let message = format!("`{key}` varies in this study, and --set gives it one value");
            return Err(case.error_at(axis.key_span.clone(), key, message));
        }
    }
    Ok(())
}

/// Refuses a key that is set twice: one of its values would have no effect.
fn check_keys(case: &Document, groups: &[Group]) -> Result<(), InputError> {
    let axes: Vec<&axis::Axis> = groups.iter().flat_map(|group| &group.axes).collect();
    for (i, axis) in axes.iter().enumerate() {
        if axes[..i].iter().any(|former| former.key == axis.key) {
            return Err(case.error_at(
                axis.key_span.clone(),
                &axis.key,
                format!("`{}` varies twice", axis.key),
            ));
        }
    }
    for axis in &axes {
        if let Some(error) = keys::unknown_path(case, &axis.key, axis.key_span.clone()) {
            return Err(error);
        }
    }
    for group in groups {
        let is_contact = |axis: &axis::Axis| axis.key != "title" && axis.values.len() > 1;
        let has_contact_axis = group.axes.iter().any(is_contact);
        for axis in &group.axes {
            if let Some((reason, help)) = without_effect(axis, has_contact_axis) {
                let error = case.error_at(axis.key_span.clone(), &axis.key, reason);
                return Err(error.with_help(help));
            }
        }
    }
    Ok(())
}

/// Why an axis does not change the solution, and the remedy; `has_contact_axis` if another one of its group does.
fn without_effect(axis: &axis::Axis, has_contact_axis: bool) -> Option<(String, &'static str)> {
    let key = &axis.key;
    match key.split('.').next().unwrap_or_default() {
        "curve" => Some((
            format!("`{key}` cannot be an axis: the points of a study have no [curve]"),
            "make an [[axis]] of the quantity of the curve, crossed with the others",
        )),
        "output" => Some((
            format!("`{key}` cannot be an axis: this setting does not change what is solved"),
            "set it in the base case; `ertel sweep --folders` writes each point to a separate folder",
        )),
        "title" if axis.values.len() > 1 && !has_contact_axis => Some((
            "`title` alone cannot be an axis: its points would be the same contact".to_owned(),
            "give it the same `zip` as an axis of a contact's input, or a column next to such inputs in the table of points",
        )),
        _ => None,
    }
}

/// The settings of a point: the last group varies fastest.
fn settings_of(groups: &[Group], index: usize) -> Vec<Setting> {
    let mut rest = index;
    let mut chosen: Vec<Vec<Setting>> = groups
        .iter()
        .rev()
        .map(|group| {
            let i = rest % group.len();
            rest /= group.len();
            let setting = |axis: &axis::Axis| Setting {
                key: axis.key.clone(),
                key_span: axis.key_span.clone(),
                node: axis.values[i].0.clone(),
                value: axis.values[i].1.clone(),
            };
            group.axes.iter().map(setting).collect()
        })
        .collect();
    chosen.reverse();
    chosen.into_iter().flatten().collect()
}

#[cfg(test)]
mod tests;
