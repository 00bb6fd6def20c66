//! Questions about a case, each answer checked at once.

use std::io::BufRead;

use ertel::warning::WarningKind;
use ertel_rheology::input::InputError;

use super::template::{COMMON, TEMPLATES, Template, named};
use crate::failure::Failure;

/// Asks for what a case needs, of a template or of one to be chosen; returns the case file. `say` shows a line.
///
/// # Errors
///
/// Input that ends before the last answer, or cannot be read.
pub fn ask(
    template: Option<&'static Template>,
    input: &mut dyn BufRead,
    say: &mut dyn FnMut(&str),
) -> Result<String, Failure> {
    let template = match template {
        Some(template) => template,
        None => choose(input, say)?,
    };
    let failed = |error: InputError| Failure::Other(error.to_string());
    say(&format!(
        "{}. An empty answer keeps the value in brackets.",
        template.about
    ));
    let given = template.read(&[]).map_err(failed)?.given;
    let mut settings: Vec<String> = Vec::new();
    for (key, question) in template.questions.iter().chain(COMMON) {
        let pointer = format!("/{}", key.replace('.', "/"));
        let value = given.pointer(&pointer);
        let value = value.map_or_else(String::new, |v| {
            v.as_str().map_or_else(|| v.to_string(), str::to_owned)
        });
        loop {
            say(&format!("{question} [{value}]: "));
            let answer = answer(input)?;
            if answer.is_empty() {
                break;
            }
            let mut all = settings.clone();
            all.push(format!("{key}={answer}"));
            match template.read(&all) {
                Ok(case) => {
                    let about = |text: &str| text.starts_with(*key);
                    let mut warnings = case.warnings.iter();
                    if let Some(warning) =
                        warnings.find(|w| w.kind == WarningKind::UnusualInput && about(w))
                    {
                        say(&format!("warning: {warning}"));
                    }
                    settings = all;
                    break;
                }
                Err(error) => {
                    say(&format!("error: {}", error.message()));
                    for help in error.help() {
                        say(&format!("  = help: {help}"));
                    }
                }
            }
        }
    }
    Ok(template.read(&settings).map_err(failed)?.source)
}

fn choose(
    input: &mut dyn BufRead,
    say: &mut dyn FnMut(&str),
) -> Result<&'static Template, Failure> {
    say("What is it?");
    for (i, template) in TEMPLATES.iter().enumerate() {
        say(&format!(
            "  {}  {:<15} {}",
            i + 1,
            template.name,
            template.about
        ));
    }
    loop {
        say("Name or number: ");
        match named(&answer(input)?) {
            Ok(template) => return Ok(template),
            Err(error) => say(&format!("error: {error}")),
        }
    }
}

fn answer(input: &mut dyn BufRead) -> Result<String, Failure> {
    let mut line = String::new();
    let n = input.read_line(&mut line);
    match n.map_err(|error| Failure::Other(format!("cannot read the answer: {error}")))? {
        0 => Err(Failure::Argument(
            "the answers ended before the last question; nothing was written".to_owned(),
        )),
        _ => Ok(line.trim().to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use ertel::case::Case;

    use super::*;

    fn answered(template: Option<&str>, answers: &str) -> (Result<String, Failure>, Vec<String>) {
        let mut said = Vec::new();
        let template = template.map(|name| named(name).unwrap());
        let result = ask(template, &mut answers.as_bytes(), &mut |line| {
            said.push(line.to_owned())
        });
        (result, said)
    }

    /// Wrong answers are told and asked for again; a slip of a unit is asked about.
    #[test]
    fn answers_are_checked_at_once() {
        let answers =
            "6\n20 mm\n40\n40,5 N\n40 N\n3000 rpm\n2 m/s\n1.5 m/s\n\n\n80 degC\n\n0.02 1/GPa\n\n";
        let (text, said) = answered(None, answers);
        let case = Case::from_text("case.toml", &text.unwrap(), Path::new("")).unwrap();
        assert_eq!(case.contact.load, 40.0);
        assert_eq!(case.contact.radius, 0.01);
        assert_eq!(case.lubricant.temperature, 353.15);
        assert!((case.motion.entrainment_speed - 1.75).abs() < 1e-15);
        for words in [
            "error: `load` has no unit",
            "error: `40,5 N` has a comma",
            "needs a speed",
            "u = π d n/60",
            "diameter of the ball [19.05 mm]: ",
            "warning: lubricant.viscosity.alpha = 0.02 1/GPa is far from what is usual, 0.5 to 60 1/GPa: is 20 1/GPa meant?",
        ] {
            assert!(
                said.iter().any(|line| line.contains(words)),
                "{words}: {said:#?}"
            );
        }
    }

    #[test]
    fn answers_that_end_leave_nothing() {
        let (text, _) = answered(Some("gear"), "4 mm\n");
        assert_eq!(text.unwrap_err().code(), 2);
        let (text, said) = answered(None, "nonsense\n");
        assert!(text.is_err());
        assert!(
            said.iter()
                .any(|line| line.contains("there is no template `nonsense`"))
        );
    }
}
