//! Points from a file other than a study, such as a table of measurements.

use std::ops::Range;
use std::path::{Path, PathBuf};

use ertel_input::tree::{Node, Value};
use ertel_input::{Document, InputError};

use super::axis::{Axis, Group};
use super::points::value_of;
use super::values::AxisValue;
use super::{Source, Study, build};

/// A key of the case, and its value at each point.
#[derive(Clone, Debug)]
pub struct PointColumn {
    /// Key path in the case file.
    pub key: String,
    /// Bytes of its title in the file of the points, where errors about the key point.
    pub span: Range<usize>,
    /// The values as in a case file, each with its bytes in the file of the points.
    pub values: Vec<(Range<usize>, Value)>,
}

impl PointColumn {
    /// Adds the value of a cell, `100` with the unit `N`; without a unit a number, a switch or a name.
    pub fn push(&mut self, span: Range<usize>, cell: &str, unit: &str) {
        let value = value_of(&self.key, cell, unit);
        self.values.push((span, value));
    }

    /// Adds a pure number, without the noise of the last digits: 0.152 % is 0.00152.
    pub fn push_number(&mut self, span: Range<usize>, value: f64) {
        let value = format!("{value:.14e}").parse().unwrap_or(value);
        self.values.push((span, Value::Float(value)));
    }
}

impl Study {
    /// A study of the case in the file `base` without the keys `replaced`, whose points are the rows of `columns`; these
    /// come from the file `path` with this text, to which errors point.
    ///
    /// # Errors
    ///
    /// [`InputError`]: of the base case, which may have no `[curve]`; of a key that varies twice or changes nothing; of any case
    /// that comes of a point; columns of different lengths, or none.
    pub fn of_points(
        base: &Path,
        replaced: &[&str],
        path: &Path,
        text: &str,
        columns: Vec<PointColumn>,
    ) -> Result<Study, InputError> {
        let file = path.display().to_string();
        let mut case = Document::read(base)?;
        replaced.iter().for_each(|key| case.remove(key));
        if let Some(curve) = case.tree().entry("curve") {
            let message = format!("the points come from {file}, but the case has a [curve]");
            let error = case.error_at(curve.key_span.clone(), "curve", message);
            return Err(
                error.with_help("take [curve] out of the case, or compare with a copy without it")
            );
        }
        if let Some(transient) = case.tree().entry("transient") {
            let message =
                format!("the rows of {file} are steady contacts, and this case changes in time");
            let error = case.error_at(transient.key_span.clone(), "transient", message);
            return Err(error.with_help("take [transient] out of the case"));
        }
        let title = case.root().optional_str("title")?.unwrap_or_default();
        let title = title.to_owned();
        let (case, offset) = case.with_file(&file, text);
        let moved = |span: Range<usize>| span.start + offset..span.end + offset;
        let error = |message: String| case.error_at(moved(0..0), "", message);
        let n_points = columns.first().map_or(0, |column| column.values.len());
        if n_points == 0 || columns.iter().any(|c| c.values.len() != n_points) {
            return Err(error(
                "there are no points, or not all of their values".to_owned(),
            ));
        }
        let axes = columns.into_iter().map(|column| Axis {
            key_span: moved(column.span),
            values: (column.values.into_iter())
                .map(|(span, value)| {
                    let span = moved(span);
                    let node = Node { span, value };
                    let value = AxisValue::of(&column.key, &node);
                    (node, value)
                })
                .collect(),
            key: column.key,
        });
        let groups = [Group {
            name: None,
            axes: axes.collect(),
        }];
        let source = Source {
            name: &file,
            text,
            error: &error,
        };
        let files: Vec<PathBuf> = vec![path.to_owned(), base.to_owned()];
        build(
            title,
            base.to_owned(),
            &case,
            &groups,
            &source,
            (files, None),
        )
    }
}
