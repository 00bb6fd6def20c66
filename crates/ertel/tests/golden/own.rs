//! Tests of the comparison itself.

use libtest_mimic::Trial;

use super::compare::{Mode, difference};
use super::record::{Record, exact};
use super::trial;

/// A record of two figures and a count.
fn sample(film: f64, pressure: f64, iterations: usize) -> Record {
    let mut record = Record::default();
    record.put("machine", "kernels", "x86_64");
    record.float("figures", "film_central", film);
    record.float("figures", "film_central bar", 1e-8);
    record.float("figures", "pressure_central", pressure);
    record.float("figures", "pressure_central bar", 1e6);
    record.put("levels", "0 Newton iterations", iterations);
    record
}

fn ensure(holds: bool, what: &str) -> Result<(), String> {
    match holds {
        true => Ok(()),
        false => Err(what.to_owned()),
    }
}

fn records_read_back() -> Result<(), String> {
    let mut record = sample(1e-7 / 3.0, f64::MIN_POSITIVE, 7);
    record.float("checks", "load", -0.0);
    record.float("fields", "pressure_Pa at 0.1", f64::NAN);
    let read = Record::read(&record.text("sample"))?;
    ensure(
        read == record,
        "a record that is written is not the one that is read",
    )?;
    ensure(exact(-0.0) != exact(0.0), "the sign of zero is lost")?;
    ensure(
        Record::read("[a]\nb 1\n").is_err(),
        "a line without a value is read",
    )?;
    ensure(
        Record::read("[a]\nb = 1\nb = 2\n").is_err(),
        "a duplicate key is read",
    )
}

fn the_last_bit_counts() -> Result<(), String> {
    let old = sample(3e-7, 5e8, 7);
    let new = sample(3e-7_f64.next_up(), 5e8, 7);
    let found = difference(&old, &new, Mode::Exact);
    let text = found.text();
    let line = "[figures] film_central: 3e-7 -> 3.0000000000000004e-7, +1.8e-16 of it, +5.3e-15 of its bar";
    ensure(
        text.contains(line),
        &format!("no line `{line}` in:\n{text}"),
    )?;
    ensure(
        difference(&old, &new, Mode::WithinBars).is_empty(),
        "rounding counts on another machine",
    )
}

fn removed_and_new_values_are_reported() -> Result<(), String> {
    let (old, mut new) = (sample(3e-7, 5e8, 7), Record::default());
    new.float("figures", "film_central", 3e-7);
    new.float("figures", "spike", 6e8);
    let text = difference(&old, &new, Mode::Exact).text();
    for line in [
        "- [figures] pressure_central: 500000000.0, removed",
        "- [levels] 0 Newton iterations: 7, removed",
        "+ [figures] spike: 600000000.0, new",
    ] {
        ensure(
            text.contains(line),
            &format!("no line `{line}` in:\n{text}"),
        )?;
    }
    Ok(())
}

fn bars_count_on_another_machine() -> Result<(), String> {
    let old = sample(3e-7, 5e8, 7);
    let differs = |new: &Record| !difference(&old, new, Mode::WithinBars).is_empty();
    ensure(
        !differs(&sample(3e-7, 5e8 + 0.9e5, 9)),
        "within a tenth of the bar is not enough",
    )?;
    ensure(
        differs(&sample(3e-7, 5e8 + 1.1e5, 7)),
        "beyond a tenth of the bar is enough",
    )?;
    ensure(
        !differs(&sample(3.002e-7, 5e8, 7)),
        "within 1e-3 of a film is not enough",
    )?;
    ensure(
        differs(&sample(3.004e-7, 5e8, 7)),
        "beyond 1e-3 of a film is enough",
    )
}

/// All of them.
pub fn trials() -> Vec<Trial> {
    vec![
        trial("records::records_read_back", records_read_back),
        trial("records::the_last_bit_counts", the_last_bit_counts),
        trial(
            "records::removed_and_new_values_are_reported",
            removed_and_new_values_are_reported,
        ),
        trial(
            "records::bars_count_on_another_machine",
            bars_count_on_another_machine,
        ),
    ]
}
