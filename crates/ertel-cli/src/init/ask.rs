//! Questions about a case, each answer checked at once.

use std::io::{BufRead, Read};

use ertel::warning::WarningKind;
use ertel_input::InputError;

use super::template::{TEMPLATES, Template, named};
use crate::failure::Failure;

/// Longest answer, bytes.
const LONGEST_ANSWER: usize = 1_000;
/// Largest number of wrong answers to one question.
const MOST_TRIES: usize = 100;

/// Asks for the values of a case, of a given template or of one to be chosen; returns the case file. `say` shows a line.
///
/// # Errors
///
/// Input that ends before the last answer or cannot be read, an answer that is too long or no text, and too many wrong ones.
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
    for (key, question) in template.questions() {
        let pointer = format!("/{}", key.replace('.', "/"));
        let value = given.pointer(&pointer);
        let value = value.map_or_else(String::new, |v| {
            v.as_str().map_or_else(|| v.to_string(), str::to_owned)
        });
        let mut tries = 0;
        loop {
            say(&format!("{question} [{value}]: "));
            let answer = answer(input)?;
            if answer.is_empty() {
                break;
            }
            count(&mut tries)?;
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
    say("Kind of case:");
    for (i, template) in TEMPLATES.iter().enumerate() {
        say(&format!(
            "  {}  {:<15} {}",
            i + 1,
            template.name,
            template.about
        ));
    }
    let mut tries = 0;
    loop {
        say("Name or number: ");
        count(&mut tries)?;
        match named(&answer(input)?) {
            Ok(template) => return Ok(template),
            Err(error) => say(&format!("error: {error}")),
        }
    }
}

fn count(tries: &mut usize) -> Result<(), Failure> {
    *tries += 1;
    match *tries > MOST_TRIES {
        true => Err(Failure::Argument(format!(
            "{MOST_TRIES} answers to one question were wrong; nothing was written"
        ))),
        false => Ok(()),
    }
}

fn answer(input: &mut dyn BufRead) -> Result<String, Failure> {
    let refused = |reason: String| Failure::Argument(format!("{reason}; nothing was written"));
    let mut line = Vec::new();
    let n = (input.take(LONGEST_ANSWER as u64 + 1)).read_until(b'\n', &mut line);
    match n.map_err(|error| Failure::Other(format!("cannot read the answer: {error}")))? {
        0 => Err(refused(
            "the answers ended before the last question".to_owned(),
        )),
        n if n > LONGEST_ANSWER => Err(refused(format!(
            "an answer is longer than {LONGEST_ANSWER} bytes"
        ))),
        _ => match std::str::from_utf8(&line) {
            Ok(text) => Ok(text.trim().to_owned()),
            Err(_) => Err(refused("an answer is not UTF-8 text".to_owned())),
        },
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

    /// Wrong answers are reported and asked for again; a likely slip of a unit brings a question.
    #[test]
    fn answers_are_checked_at_once() {
        let number = TEMPLATES.iter().position(|t| t.name == "rig").unwrap() + 1;
        let answers = format!(
            "{number}\n20 mm\n40\n40,5 N\n40 N\n3000 rpm\n2 m/s\n1.5 m/s\n\n\n80 degC\n80 degC\n\n\n0.02 1/GPa\n\n"
        );
        let (text, said) = answered(None, &answers);
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
            "warning: lubricant.viscosity.alpha = 0.02 1/GPa is far from the usual range, 0.5 to 60 1/GPa: is 20 1/GPa meant?",
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

    /// Devices, programs that answer for ever, and answers that are no text end the questions.
    #[test]
    fn answers_are_bounded() {
        let end = |input: &mut dyn BufRead| {
            let template = named("rig").unwrap();
            let failure = ask(Some(template), input, &mut |_| {}).unwrap_err();
            assert_eq!(failure.code(), 2);
            failure.to_string()
        };
        let mut zeros = std::io::BufReader::new(std::io::repeat(0));
        assert!(end(&mut zeros).contains("longer than 1000 bytes"));
        let wrong = "nonsense\n".repeat(1000);
        assert!(end(&mut wrong.as_bytes()).contains("100 answers to one question were wrong"));
        assert!(end(&mut &b"\xff\n"[..]).contains("not UTF-8"));
        let failure = ask(None, &mut wrong.as_bytes(), &mut |_| {}).unwrap_err();
        assert!(failure.to_string().contains("were wrong"));
    }
}
