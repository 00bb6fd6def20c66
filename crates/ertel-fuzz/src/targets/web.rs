//! Requests of the page in a browser: the checks of a case, its values, a changed value.

use serde_json::Value;

use super::{Verdict, check_text};
use crate::finding::Defect;
use crate::input::{Input, Target};

/// Asks for all but the solve, with the text of `case.toml` and the changes of `changes.json`.
pub fn run(input: &Input) -> Result<Verdict, Defect> {
    // A page has no text but UTF-16, and no halves of pairs come across.
    let texts =
        [Target::Web.main_file(), "changes.json"].map(|name| std::str::from_utf8(input.file(name)));
    let [Ok(case), Ok(changes)] = texts else {
        return Ok(Verdict::Refused);
    };
    let checked = answered(&ertel_web::check(case))?;
    answered(&ertel_web::form(case))?;
    match ertel_web::edit(case, changes) {
        // Valid TOML stays valid.
        Ok(text) => drop(answered(&ertel_web::form(&text))?),
        Err(error) => drop(check_text(&ertel_input::escaped(&error.to_string()))?),
    }
    Ok(checked)
}

/// Whether an answer is one: yes, or no with words.
fn answered(answer: &Value) -> Result<Verdict, Defect> {
    match (answer["ok"].as_bool(), &answer["error"]) {
        (Some(true), _) => Ok(Verdict::Taken),
        (Some(false), error) => {
            let text = match error {
                Value::String(text) => text.clone(),
                // Of a case file the message alone; of what the solver refuses, the text.
                error => [&error["message"], &error["text"]]
                    .iter()
                    .find_map(|text| text.as_str())
                    .unwrap_or_default()
                    .to_owned(),
            };
            check_text(&ertel_input::escaped(&text))
        }
        (None, _) => Err(Defect::wrong("an answer that is none", answer.to_string())),
    }
}
