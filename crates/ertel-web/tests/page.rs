//! Requests of the page, on the computer: fields of a case file, edits that keep it, and the words of the program.

use std::path::Path;

use ertel::case::Case;
use ertel_web::{check, database, edit, form};
use serde_json::{Value, json};

const ROLLER: &str = include_str!("../../../cases/roller.toml");
const BALL: &str = include_str!("../../../cases/ball-on-disc.toml");

fn edited(text: &str, changes: &Value) -> String {
    edit(text, &changes.to_string()).unwrap()
}

/// Values as written in the file, by their key paths.
#[test]
fn fields_are_the_values_of_the_file() {
    let found = form(BALL);
    assert_eq!(found["ok"], true);
    let values = &found["values"];
    assert_eq!(values["contact.radius"], "16 mm");
    assert_eq!(values["motion.slide_to_roll_ratio"], 0.0);
    assert_eq!(values["bodies.body_2.poissons_ratio"], 0.3);
    let tables = found["tables"].as_array().unwrap();
    assert!(tables.contains(&json!("lubricant.viscosity")));
    assert_eq!(form("radius = ")["error"]["line"], 1);
}

/// Keys that the page names are keys of a case, and choices have titles of no others.
#[test]
fn keys_of_the_page_are_those_of_cases() {
    let page = include_str!("../page/fields.js");
    let known = database()["keys"].as_object().unwrap().clone();
    assert_eq!(known["motion.slide_to_roll_ratio"]["number"], true);
    assert_eq!(known["lubricant.base_oil"]["choices"][1], "PAO");
    let sections = ["contact.", "motion.", "bodies.", "lubricant.", "thermal."];
    let is_key = |word: &&str| sections.iter().any(|section| word.starts_with(section));
    let mut n_keys = 0;
    for word in page
        .split(['"', '`'])
        .filter(is_key)
        .filter(|word| !word.contains('$'))
    {
        assert!(known.contains_key(word), "{word}");
        n_keys += 1;
    }
    assert!(n_keys > 60, "{n_keys}");
    let (_, titles) = page.split_once("choices(\"contact.kind\", {").unwrap();
    let kinds = known["contact.kind"]["choices"].as_array().unwrap();
    for kind in kinds {
        let title = format!("{}: \"", kind.as_str().unwrap());
        assert!(titles.lines().next().unwrap().contains(&title), "{title}");
    }
}

/// One value changes; comments, order and spaces stay.
#[test]
fn an_edit_changes_one_value() {
    let changes = json!([
        ["contact.radius", "20 mm"],
        ["motion.slide_to_roll_ratio", 0.5]
    ]);
    let expected = BALL
        .replace("\"16 mm\" ", "\"20 mm\" ")
        .replace("ratio = 0.0 ", "ratio = 0.5 ");
    assert_eq!(edited(BALL, &changes), expected);
}

/// Tables are made where they are needed, and values make way for them: the case that comes out is the one that was meant.
#[test]
fn edits_make_and_remove_tables() {
    let changes = json!([
        ["bodies.body_1.youngs_modulus", "73 GPa"],
        ["bodies.body_1.poissons_ratio", 0.17],
        ["lubricant", null],
        ["lubricant.name", "squalane-pip"],
        ["lubricant.temperature", "313 K"],
    ]);
    let text = edited(ROLLER, &changes);
    let case = Case::from_text("case.toml", &text, Path::new("")).unwrap();
    assert_eq!(case.body_1.elasticity.youngs_modulus, 73e9);
    assert_eq!(case.lubricant.temperature, 313.0);
    let text = edited(&text, &json!([["thermal", {}], ["bodies.body_1", "glass"]]));
    let case = Case::from_text("case.toml", &text, Path::new("")).unwrap();
    assert!(case.thermal.is_some());
    let text = edited(&text, &json!([["thermal", null]]));
    let case = Case::from_text("case.toml", &text, Path::new("")).unwrap();
    assert!(case.thermal.is_none());
    assert_eq!(form(&text)["values"]["bodies.body_1"], "glass");
}

#[test]
fn edits_that_are_none_are_refused() {
    for changes in ["{", "[[1, 2]]", r#"[["a", [1]]]"#, r#"[["a", {"b": 1}]]"#] {
        assert!(edit(ROLLER, changes).is_err(), "{changes}");
    }
    assert!(edit("a = ", "[]").is_err());
}

/// The error of the library with its place and key; a case that cannot be solved is refused before a solve.
#[test]
fn errors_have_their_place() {
    let text = ROLLER.replace("10 mm", "10 s");
    let expected = Case::from_text("case.toml", &text, Path::new("")).unwrap_err();
    let error = &check(&text)["error"];
    assert_eq!(error["text"], expected.to_string());
    assert_eq!(error["key"], "contact.radius");
    assert_eq!((&error["line"], &error["column"]), (&json!(5), &json!(10)));
    let thin = include_str!("../../ertel-cli/tests/bad/film-too-thin.toml");
    let error = &check(thin)["error"]["text"];
    assert!(error.as_str().unwrap().contains("too thin"), "{error}");
    let long = format!("{ROLLER}\n#{}", "-".repeat(2_000_000));
    let error = &check(&long)["error"]["text"];
    assert!(error.as_str().unwrap().contains("is too large"), "{error}");
    // There is no disk to look for it.
    let own = ROLLER.replace("body_1 = \"steel\"", "body_1 = \"own-steel.toml\"");
    assert_eq!(check(&own)["error"]["key"], "bodies.body_1");
    assert_eq!(check(ROLLER)["ok"], true);
}

/// Every example and every entry of the lists can be used.
#[test]
fn lists_can_be_chosen_from() {
    let lists = database();
    for example in lists["examples"].as_array().unwrap() {
        let text = example["text"].as_str().unwrap();
        assert_eq!(check(text)["ok"], true, "{}", example["name"]);
    }
    let names = |list: &str| lists[list].as_array().unwrap().len();
    assert!(names("fluids") > 60 && names("solids") > 5);
    for solid in lists["solids"].as_array().unwrap() {
        let text = edited(ROLLER, &json!([["bodies.body_1", solid["name"]]]));
        assert_eq!(check(&text)["ok"], true, "{}", solid["name"]);
    }
}
