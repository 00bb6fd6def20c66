//! Answers to the questions of `ertel init --ask`.

#[allow(dead_code)]
#[path = "../../../ertel-cli/src/init/ask.rs"]
mod questions;
#[allow(dead_code)]
#[path = "../../../ertel-cli/src/init/template.rs"]
mod template;

use std::path::Path;

use ertel::case::Case;

use super::{Verdict, check_text};
use crate::finding::Defect;
use crate::input::{Input, Target};

/// Templates that there are answers for: from the first number to this one.
const N_TEMPLATES: usize = 9;

/// Answers that keep all values of each template, and some that change them.
pub fn seeds() -> Vec<Input> {
    let keep = "\n".repeat(30);
    let mut texts: Vec<String> = (1..=N_TEMPLATES).map(|i| format!("{i}\n{keep}")).collect();
    texts.push("rig\n20 mm\n40 N\n2 m/s\n1.5 m/s\n\n\n80 degC\n\n\n\n".to_owned());
    texts.push("gear\n4 mm\n20\n40,5\n20 deg\n".to_owned() + &keep);
    let input = |text: String| Input {
        target: Target::Answers,
        files: vec![(Target::Answers.main_file().to_owned(), text.into_bytes())],
    };
    texts.into_iter().map(input).collect()
}

/// Asks, `answers.txt` being what is typed: the case that this makes is a good one.
pub fn run(input: &Input) -> Result<Verdict, Defect> {
    let mut answers = input.file(Target::Answers.main_file());
    match questions::ask(None, &mut answers, &mut |_| {}) {
        Ok(text) => match Case::from_text("case.toml", &text, Path::new("")) {
            Ok(_) => Ok(Verdict::Taken),
            Err(error) => Err(Defect::wrong(
                "answers that make no case",
                error.to_string(),
            )),
        },
        Err(failure) if failure.code() == 2 => {
            check_text(&ertel_input::escaped(&failure.to_string()))
        }
        Err(failure) => Err(Defect::wrong(
            "answers are refused for no reason",
            failure.to_string(),
        )),
    }
}
