//! Events of a run as JSON, one object per line of stdout, for programs.

use std::path::Path;
use std::sync::Mutex;
use std::time::Instant;

use ertel::warning::{Merged, Warning};
use serde_json::{Map, Value, json};

use crate::failure::Failure;
use crate::print;

/// A path in events. JSON is text: bytes of a name that are no text are replaced, as in all messages.
pub fn path_text(path: &Path) -> String {
    path.to_string_lossy().into_owned()
}

/// Writes the events of a run, where they are asked for.
pub struct Events {
    is_on: bool,
    begun: Instant,
    /// The case that events are about, where there is one.
    case: Mutex<Option<String>>,
}

impl Events {
    /// Events that are written if `is_on`.
    pub fn new(is_on: bool) -> Self {
        Self {
            is_on,
            begun: Instant::now(),
            case: Mutex::new(None),
        }
    }

    /// Whether they are written.
    pub fn is_on(&self) -> bool {
        self.is_on
    }

    /// From here on events are about this case.
    pub fn set_case(&self, name: Option<&str>) {
        *self.case() = name.map(str::to_owned);
    }

    fn case(&self) -> std::sync::MutexGuard<'_, Option<String>> {
        self.case
            .lock()
            .unwrap_or_else(std::sync::PoisonError::into_inner)
    }

    /// Writes an event; `fields` is an object.
    pub fn emit(&self, event: &str, fields: Value) {
        // A failed write does not end the work; it is reported by the last event.
        let _ = self.write(event, fields);
    }

    /// Writes the warnings about the input or the result.
    pub fn warn<'a>(&self, warnings: impl IntoIterator<Item = &'a Warning>) {
        for warning in warnings.into_iter().filter(|w| !w.is_silenced) {
            let event = warning.kind.severity().word();
            self.emit(event, json!({ "kind": warning.kind, "text": warning.text }));
        }
    }

    /// The same of points, counted from 1.
    pub fn warn_of_points(&self, merged: &[Merged]) {
        for merged in merged.iter().filter(|merged| !merged.worst.is_silenced) {
            let points: Vec<usize> = merged.points.iter().map(|i| i + 1).collect();
            self.emit(
                "warning",
                json!({
                    "kind": merged.worst.kind,
                    "text": merged.worst.text,
                    "points": points,
                    "worst_point": merged.worst_point + 1,
                }),
            );
        }
    }

    /// Writes a failure.
    pub fn fail(&self, failure: &Failure) {
        let mut fields = json!({ "exit_code": failure.code(), "message": failure.to_string() });
        if let Failure::Input(error) = failure {
            fields["message"] = json!(error.message());
            fields["file"] = json!(error.file());
            fields["line"] = json!(error.line());
            fields["column"] = json!(error.column());
            fields["key"] = json!(error.key());
            fields["help"] = json!(error.help());
        }
        self.emit("failed", fields);
    }

    /// The last event, with the exit code.
    ///
    /// # Errors
    ///
    /// That of the run, else that of writing to stdout.
    pub fn finish(&self, result: Result<(), Failure>) -> Result<(), Failure> {
        if !self.is_on {
            return result;
        }
        match &result {
            Ok(()) => {}
            // Each case reported its own failure.
            Err(Failure::Cases { .. }) => {}
            Err(failure) => self.fail(failure),
        }
        self.set_case(None);
        let code = result.as_ref().err().map_or(0, Failure::code);
        let written = self.write("finished", json!({ "exit_code": code }));
        result.and(written)
    }

    fn write(&self, event: &str, fields: Value) -> Result<(), Failure> {
        if !self.is_on {
            return Ok(());
        }
        let mut object = Map::new();
        object.insert("event".to_owned(), json!(event));
        object.insert(
            "seconds".to_owned(),
            json!(self.begun.elapsed().as_secs_f64()),
        );
        if let Some(case) = &*self.case() {
            object.insert("case".to_owned(), json!(case));
        }
        if let Value::Object(fields) = fields {
            object.extend(fields);
        }
        print::stdout(&format!("{}\n", Value::Object(object)))
    }
}
