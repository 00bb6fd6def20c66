//! Constants of the program that the theory pages tell: the page says the number that stands in the source.

use std::fs;
use std::path::{Path, PathBuf};

/// A sentence of a page with `{}` where a number stands, and the constants that these numbers are: file, name, which of its numbers,
/// and the factor by which the page tells it (100 of a share in per cent).
type Row = (
    &'static str,
    &'static str,
    &'static [(&'static str, &'static str, usize, f64)],
);

const STAGE: &str = "solve/sequence/stage_run.rs";
const ADAPT: &str = "solve/adapt.rs";
const NEWTON: &str = "solve/newton.rs";
const INDICATOR: &str = "solve/indicator.rs";
const DECISION: &str = "solve/sequence/driver/decision.rs";
const PANELS: &str = "film/cross_film/panels.rs";
const LAWS: &str = "solve/sequence/strategies/shear_law.rs";
const SLIDING: &str = "solve/sequence/strategies/sliding.rs";

const ISOTHERMAL: &str = "theory/isothermal-contact.md";
const HEAT: &str = "theory/heat.md";
const THINNING: &str = "theory/shear-thinning.md";

const ROWS: &[Row] = &[
    (
        ISOTHERMAL,
        "cavitation penalty ramped {}, {};",
        &[
            (STAGE, "PENALTY_RAMP", 0, 1.0),
            (STAGE, "PENALTY_RAMP", 1, 1.0),
        ],
    ),
    (
        ISOTHERMAL,
        "a start that stalls with a residual above {} skips",
        &[(STAGE, "DIVERGENCE_LIMIT", 0, 1.0)],
    ),
    (
        ISOTHERMAL,
        "refined further end at {}: the remaining error",
        &[(STAGE, "EXACT_ENOUGH", 0, 1.0)],
    ),
    (
        ISOTHERMAL,
        "they end at √({} e), {} at most, if the last step changed both films by less than {} e.",
        &[
            (STAGE, "ROUGH_SHARE", 0, 1.0),
            (STAGE, "ROUGH_UPDATE", 0, 1.0),
            (STAGE, "ROUGH_FILM_CHANGE", 0, 1.0),
        ],
    ),
    (
        "decisions/0012-films-first.md",
        "{} times the target today, `ROUGH_FILM_CHANGE`",
        &[(STAGE, "ROUGH_FILM_CHANGE", 0, 1.0)],
    ),
    (
        ISOTHERMAL,
        "the first try of the final stage stops after {} iterations without a smaller update, and after {} iterations in total ({} under rollers",
        &[
            (STAGE, "EARLY_STAGNATION", 0, 1.0),
            (STAGE, "EARLY_ITERATIONS", 0, 1.0),
            (STAGE, "EARLY_ITERATIONS", 1, 1.0),
        ],
    ),
    (
        ISOTHERMAL,
        "The prediction is u₂(u₂/u₁)^{}, which",
        &[(NEWTON, "FORESEEN_ORDER", 0, 1.0)],
    ),
    (
        ISOTHERMAL,
        "No step may increase the residual more than {} times",
        &[(NEWTON, "MOST_RISE", 0, 1.0)],
    ),
    (
        ISOTHERMAL,
        "isotropic diffusion, ρ_id = {}, {}, {}, {} and that of the case",
        &[
            (
                "solve/sequence/strategies/diffusion.rs",
                "DIFFUSION",
                0,
                1.0,
            ),
            (
                "solve/sequence/strategies/diffusion.rs",
                "DIFFUSION",
                1,
                1.0,
            ),
            (
                "solve/sequence/strategies/diffusion.rs",
                "DIFFUSION",
                2,
                1.0,
            ),
            (
                "solve/sequence/strategies/diffusion.rs",
                "DIFFUSION",
                3,
                1.0,
            ),
        ],
    ),
    (
        ISOTHERMAL,
        "ln μ̄ times {}, {}, {}, {} and {}, from a separate start",
        &[
            (
                "solve/sequence/strategies/viscosity_exponent.rs",
                "EXPONENTS",
                0,
                1.0,
            ),
            (
                "solve/sequence/strategies/viscosity_exponent.rs",
                "EXPONENTS",
                1,
                1.0,
            ),
            (
                "solve/sequence/strategies/viscosity_exponent.rs",
                "EXPONENTS",
                2,
                1.0,
            ),
            (
                "solve/sequence/strategies/viscosity_exponent.rs",
                "EXPONENTS",
                3,
                1.0,
            ),
            (
                "solve/sequence/strategies/viscosity_exponent.rs",
                "EXPONENTS",
                4,
                1.0,
            ),
        ],
    ),
    (
        ISOTHERMAL,
        "the speed, from {} times that of the case down in halves",
        &[("solve/sequence/strategies/speed.rs", "SPEEDS", 0, 1.0)],
    ),
    (
        ISOTHERMAL,
        "not where the films have bars below {} % and a diffused ridge",
        &[(DECISION, "GOOD_ENOUGH", 0, 100.0)],
    ),
    (
        ISOTHERMAL,
        "halve the step, up to {} times in one continuation ({} if shear rates",
        &[
            (DECISION, "MAX_HALVED_STEPS", 0, 1.0),
            (DECISION, "MAX_HALVED_EXPONENTIAL_STEPS", 0, 1.0),
        ],
    ),
    (
        ISOTHERMAL,
        "less than {} % of the central film within {} half-widths of an end",
        &[
            ("solve/sequence/mesh_solver.rs", "NO_FILM", 0, 100.0),
            ("contact/roller/ends.rs", "AROUND_EDGE", 0, 1.0),
        ],
    ),
    (
        ISOTHERMAL,
        "the error bar is {}θE + {} E_r, combined",
        &[
            (ADAPT, "SAFETY", 0, 1.0),
            (ADAPT, "SAFETY_OF_RIDGE", 0, 1.0),
        ],
    ),
    (
        ISOTHERMAL,
        "θ = |h_1 − h_2|/(E_1 − E_2), between {} and {}, and {} if there is no previous mesh",
        &[
            (ADAPT, "CALIBRATION", 0, 1.0),
            (ADAPT, "CALIBRATION", 1, 1.0),
            (ADAPT, "UNCALIBRATED", 0, 1.0),
        ],
    ),
    (
        ISOTHERMAL,
        "more than the estimates tell: {} (point) or {} (line contacts)",
        &[
            (INDICATOR, "UNRESOLVED", 1, 1.0),
            (INDICATOR, "UNRESOLVED", 0, 1.0),
        ],
    ),
    (
        ISOTHERMAL,
        "η_T = {} A_T κ/(2C) |e_δ||e_ζ| + {} A_T (ε κ² + a κ",
        &[
            (INDICATOR, "ELASTIC", 0, 1.0),
            (INDICATOR, "REYNOLDS", 0, 1.0),
        ],
    ),
    (
        ISOTHERMAL,
        "The factors {} and {} are measured",
        &[
            (INDICATOR, "ELASTIC", 0, 1.0),
            (INDICATOR, "REYNOLDS", 0, 1.0),
        ],
    ),
    (
        ISOTHERMAL,
        "one refinement aims at no less than {} % of it",
        &[(ADAPT, "SMALLEST_GOAL", 0, 100.0)],
    ),
    (
        ISOTHERMAL,
        "the sum may then be {} of its size",
        &[(ADAPT, "CONFIRMING_GOAL", 0, 1.0)],
    ),
    (
        ISOTHERMAL,
        "From error bars of {} times the target on",
        &[(ADAPT, "NEARLY", 0, 1.0)],
    ),
    (
        ISOTHERMAL,
        "d = {} C =",
        &[("elastic/half_space.rs", "LINE_REFERENCE", 0, 1.0)],
    ),
    (
        ISOTHERMAL,
        "at the distance d from the load, {} half-widths",
        &[("elastic/half_space.rs", "LINE_REFERENCE", 0, 1.0)],
    ),
    (
        ISOTHERMAL,
        "e₀ = {} p_h; in steps of 1/{})",
        &[
            ("solve/ridge.rs", "SCALE", 0, 1.0),
            ("solve/ridge.rs", "STEPS", 0, 1.0),
        ],
    ),
    (
        HEAT,
        "If it is more than {} of the previous one, only a fraction",
        &[("solve/heat/relaxation.rs", "SLOW", 0, 1.0)],
    ),
    (
        HEAT,
        "costs at most {} iterations more than when it was new",
        &[("solve/heat/newton.rs", "SPARE_KRYLOV", 0, 1.0)],
    ),
    (
        HEAT,
        "to a depth of {} half-widths",
        &[("params/thermal.rs", "depth", 0, 1.0)],
    ),
    (
        HEAT,
        "is limited separately: to {} K,",
        &[("solve/heat/newton.rs", "largest_step", 0, 1.0)],
    ),
    (
        HEAT,
        "with `θ` = {}, {}, {}, {}, {}, {}, {}.",
        &[
            (SLIDING, "SLIDING", 0, 1.0),
            (SLIDING, "SLIDING", 1, 1.0),
            (SLIDING, "SLIDING", 2, 1.0),
            (SLIDING, "SLIDING", 3, 1.0),
            (SLIDING, "SLIDING", 4, 1.0),
            (SLIDING, "SLIDING", 5, 1.0),
            (SLIDING, "SLIDING", 6, 1.0),
        ],
    ),
    (
        THINNING,
        "(1 − r₁²)/(2r₁) = {}, {}, {}, {}, {}, {}, {} r₁",
        &[
            (LAWS, "SOFTNESS", 0, 1e-3),
            (LAWS, "SOFTNESS", 1, 1e-3),
            (LAWS, "SOFTNESS", 2, 1e-3),
            (LAWS, "SOFTNESS", 3, 1e-3),
            (LAWS, "SOFTNESS", 4, 1e-3),
            (LAWS, "SOFTNESS", 5, 1e-3),
            (LAWS, "SOFTNESS", 6, 1e-3),
        ],
    ),
    (
        THINNING,
        "first increases sliding at `ε` = {}.",
        &[(LAWS, "MEDIUM_SOFTNESS", 0, 1e-3)],
    ),
    (
        THINNING,
        "Continuation steps end at updates and residuals of {},",
        &[(STAGE, "EXPONENTIAL_TOLERANCE", 0, 1.0)],
    ),
    (
        THINNING,
        "panels end {} and",
        &[(PANELS, "UPPER_FOLDS", 0, 1.0)],
    ),
    (
        THINNING,
        "contributions more than {} e-folds below",
        &[(PANELS, "LOWER_FOLDS", 0, 1.0)],
    ),
];

const WORDS: [&str; 13] = [
    "zero", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten",
    "eleven", "twelve",
];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// The numbers of a constant, or of the first field of this name that has a number, as the source has them.
fn constant(file: &str, name: &str) -> Vec<f64> {
    let text = fs::read_to_string(root().join("crates/ertel-ehl/src").join(file)).unwrap();
    if name.starts_with(|c: char| c.is_lowercase()) {
        let key = format!(" {name}: ");
        let fields = text.split(&key).skip(1);
        let values =
            fields.filter_map(|rest| rest.split_once(',')?.0.replace('_', "").parse().ok());
        return values.take(1).collect();
    }
    let (_, rest) = text
        .split_once(&format!("const {name}: "))
        .unwrap_or_else(|| panic!("{file} has no {name}"));
    let (_, value) = rest.split_once(" = ").unwrap();
    let (value, _) = value.split_once(';').unwrap();
    let numbers = value.split(|c: char| !(c.is_ascii_alphanumeric() || ".-_".contains(c)));
    numbers
        .filter(|part| !part.is_empty())
        .map(|part| {
            part.replace('_', "")
                .parse()
                .unwrap_or_else(|_| panic!("{file}: {name} = {value}"))
        })
        .collect()
}

/// The number with which a text begins, in digits or as a word, and what follows.
fn number(text: &str) -> Option<(f64, &str)> {
    if let Some(value) = WORDS.iter().position(|word| text.starts_with(word)) {
        return Some((value as f64, &text[WORDS[value].len()..]));
    }
    let end = text
        .find(|c: char| !(c.is_ascii_digit() || ".e-".contains(c)))
        .unwrap_or(text.len());
    // A point may end the sentence.
    let ends = (1..=end).rev().filter(|end| text.is_char_boundary(*end));
    ends.map(|end| (&text[..end], &text[end..]))
        .filter(|(digits, _)| !digits.ends_with('.'))
        .find_map(|(digits, rest)| Some((digits.parse().ok()?, rest)))
}

/// The numbers of a sentence where the text has it.
fn told(text: &str, sentence: &str) -> Vec<Vec<f64>> {
    let mut parts = sentence.split("{}");
    let first = parts.next().unwrap();
    let rest: Vec<&str> = parts.collect();
    let starts = text.match_indices(first).map(|(at, _)| at + first.len());
    let read = |start: usize| {
        let mut left = &text[start..];
        let mut numbers = Vec::new();
        for part in &rest {
            let (value, after) = number(left)?;
            numbers.push(value);
            left = after.strip_prefix(part)?;
        }
        Some(numbers)
    };
    starts.filter_map(read).collect()
}

/// Each sentence is on its page, and tells what the source has.
#[test]
fn theory_pages_tell_the_constants_of_the_source() {
    let mut wrong = Vec::new();
    for (page, sentence, constants) in ROWS {
        let text = fs::read_to_string(root().join("docs").join(page)).unwrap();
        let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
        let found = told(&text, sentence);
        let expected: Vec<f64> = (constants.iter())
            .map(|(file, name, at, factor)| constant(file, name)[*at] * factor)
            .collect();
        let same = |numbers: &Vec<f64>| {
            numbers.len() == expected.len()
                && numbers
                    .iter()
                    .zip(&expected)
                    .all(|(a, b)| (a - b).abs() <= 1e-9 * b.abs())
        };
        if !found.iter().any(same) {
            wrong.push(format!(
                "{page}: \"{sentence}\" says {found:?}, the source has {expected:?}"
            ));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Words, digits and the ends of sentences are read as they are meant.
#[test]
fn numbers_are_read_from_sentences() {
    assert_eq!(
        told(
            "halved up to six times (twelve at most).",
            "up to {} times ({} at"
        ),
        [[6.0, 12.0]]
    );
    assert_eq!(
        told("with 0.3, 1. Then 1e-3: end", "with {}, {}."),
        [[0.3, 1.0]]
    );
    assert_eq!(told("end at 1e-3: the", "end at {}: the"), [[1e-3]]);
    assert!(told("end at some", "end at {}").is_empty());
}
