use super::{Bounds, Document, InputError, StrOrTable};
use ertel_quantity::Dimension;

const CASE: &str = r#"title = "Steel ball"

[contact]
kind = "circular"
radius = "16 mm"
load = "100 N"

[bodies]
body_1 = "steel"
body_2 = { youngs_modulus = "210 GPa", poissons_ratio = 0.3 }

[mesh]
order = 2
fine = true
points = ["1 mm", "2 mm"]
weights = [1, 0.5]
names = ["a", "b"]

[[zone]]
size = 0.1
[[zone]]
size = 0.2
"#;

fn document(text: &str) -> Document {
    Document::parse("case.toml", text).unwrap()
}

/// Reads `text` as a document whose `[contact]` has a radius and a load.
fn read(text: &str) -> Result<(f64, f64), InputError> {
    let document = Document::parse("case.toml", text)?;
    let mut root = document.root();
    let mut contact = root.required_table("contact")?;
    let radius = contact.required_quantity("radius", Dimension::LENGTH, Bounds::POSITIVE)?;
    let load = contact.required_quantity("load", Dimension::FORCE, Bounds::POSITIVE)?;
    contact.finish()?;
    root.finish()?;
    Ok((radius, load))
}

fn error_of(text: &str) -> InputError {
    read(text).expect_err(text)
}

#[test]
fn every_kind_of_value_is_read() {
    let document = document(CASE);
    let mut root = document.root();
    assert_eq!(root.required_str("title").unwrap(), "Steel ball");
    let mut contact = root.required_table("contact").unwrap();
    let kind = contact.required_choice("kind", &[("line", 1), ("circular", 2)]);
    assert_eq!(kind.unwrap(), 2);
    let radius = contact.required_quantity("radius", Dimension::LENGTH, Bounds::ANY);
    assert_eq!(radius.unwrap(), 0.016);
    let load = contact.optional_quantity("load", Dimension::FORCE, Bounds::ANY);
    assert_eq!(load.unwrap(), Some(100.0));
    assert!(contact.optional_str("nothing").unwrap().is_none());
    contact.finish().unwrap();

    let mut bodies = root.required_table("bodies").unwrap();
    assert_eq!(bodies.keys().collect::<Vec<_>>(), ["body_1", "body_2"]);
    let plane = bodies.required_str_or_table("body_1").unwrap();
    assert!(matches!(plane, StrOrTable::Str("steel")));
    let StrOrTable::Table(mut ball) = bodies.required_str_or_table("body_2").unwrap() else {
        panic!("not a table");
    };
    assert_eq!(ball.path(), "bodies.body_2");
    let modulus = ball.required_quantity("youngs_modulus", Dimension::PRESSURE, Bounds::POSITIVE);
    assert_eq!(modulus.unwrap(), 210e9);
    let ratio = ball.required_number("poissons_ratio", Bounds::open(-1.0, 0.5));
    assert_eq!(ratio.unwrap(), 0.3);
    ball.finish().unwrap();
    bodies.finish().unwrap();

    let mut mesh = root.required_table("mesh").unwrap();
    assert_eq!(mesh.required_integer("order", 1..=5).unwrap(), 2);
    assert_eq!(mesh.optional_bool("fine").unwrap(), Some(true));
    let points = mesh.required_quantities("points", Dimension::LENGTH, Bounds::POSITIVE);
    assert_eq!(points.unwrap(), [1e-3, 2e-3]);
    assert_eq!(
        mesh.required_numbers("weights", Bounds::ANY).unwrap(),
        [1.0, 0.5]
    );
    assert_eq!(mesh.optional_strs("names").unwrap().unwrap(), ["a", "b"]);
    mesh.finish().unwrap();

    let zones = root.tables("zone").unwrap();
    assert_eq!(zones.len(), 2);
    for (mut zone, size) in zones.into_iter().zip([0.1, 0.2]) {
        assert_eq!(zone.required_number("size", Bounds::ANY).unwrap(), size);
        zone.finish().unwrap();
    }
    assert!(root.tables("absent").unwrap().is_empty());
    root.finish().unwrap();
}

#[test]
fn a_misspelt_key_is_shown_with_its_line() {
    let text = "title = \"x\"\n[contact]\nradius = \"16 mm\"\nload = \"1 N\"\nlaod = \"2 N\"\n";
    let document = document(text);
    let mut root = document.root();
    root.optional_str("title").unwrap();
    let mut contact = root.required_table("contact").unwrap();
    contact.optional_str("radius").unwrap();
    contact.optional_str("load").unwrap();
    let error = contact.finish().unwrap_err();
    assert_eq!(
        error.to_string(),
        "\
unknown key `laod` in [contact]
  --> case.toml:5:1
   |
 5 | laod = \"2 N\"
   | ^^^^ did you mean `load`?
   = help: the keys here are radius, load"
    );
    assert_eq!((error.line(), error.column()), (Some(5), Some(1)));
    assert_eq!((error.file(), error.key()), ("case.toml", "contact.laod"));
}

#[test]
fn a_missing_key_points_at_the_misspelt_one_or_the_table() {
    let misspelt = error_of("[contact]\nraduis = \"16 mm\"\nload = \"1 N\"");
    assert_eq!(misspelt.message(), "missing key `radius` in [contact]");
    assert_eq!((misspelt.line(), misspelt.column()), (Some(2), Some(1)));
    assert!(misspelt.to_string().contains("did you mean `radius`?"));

    let absent = error_of("\n[contact]\nload = \"1 N\"");
    assert_eq!(absent.message(), "missing key `radius` in [contact]");
    assert_eq!(absent.line(), Some(2));
    assert_eq!(absent.key(), "contact.radius");

    let table = error_of("[conact]\nload = \"1 N\"");
    assert_eq!(table.message(), "the section [contact] is missing");
    assert_eq!((table.line(), table.column()), (Some(1), Some(2)));

    assert_eq!(error_of("").message(), "the section [contact] is missing");
}

/// 3000 rpm of 20 mm: π · 0.02 m · 50 1/s = 3.1416 m/s.
#[test]
fn quantities_of_another_kind_come_with_advice() {
    let error = |value: &str, dimension| {
        let document = document(&format!("key = \"{value}\""));
        let mut root = document.root();
        let error = root.required_quantity("key", dimension, Bounds::ANY);
        error.unwrap_err().to_string()
    };
    for (value, dimension, words) in [
        (
            "3000 rpm",
            Dimension::SPEED,
            "u = π d n/60; with d = 20 mm, 3000 rpm are \"3.142 m/s\"",
        ),
        (
            "3000 rpm",
            Dimension::SPEED,
            "[machine] take rpm (inner_ring_speed",
        ),
        ("50 1/s", Dimension::ANGULAR_SPEED, "written \"3000 rpm\""),
        (
            "50 turns/min",
            Dimension::ANGULAR_SPEED,
            "did you mean rev?",
        ),
        ("46 cSt", Dimension::VISCOSITY, "times the density, μ = ν ρ"),
        (
            "16,5 mm",
            Dimension::LENGTH,
            "write a decimal point: `16.5 mm`",
        ),
        (
            "40,5 ± 2 mPa.s",
            Dimension::VISCOSITY,
            "write a decimal point: `40.5`",
        ),
        ("1,000 N", Dimension::FORCE, "`1.000 N` or `1000 N`"),
    ] {
        let error = error(value, dimension);
        assert!(error.contains(words), "{value}: {error}");
    }
}

#[test]
fn an_unknown_key_at_the_top_level() {
    let error = error_of("colour = 1\n[contact]\nradius = \"1 m\"\nload = \"1 N\"");
    assert_eq!(error.message(), "unknown key `colour` at the top level");
    assert_eq!(error.help(), ["the keys here are contact"]);
}

#[test]
fn wrong_quantities_name_the_key_and_the_need() {
    let length = error_of("[contact]\nradius = \"16 mm\"\nload = \"100 mm\"");
    assert_eq!(
        length.message(),
        "`100 mm` is a length, but `load` needs a force (N, kN, mN)"
    );
    assert_eq!((length.line(), length.column()), (Some(3), Some(8)));
    assert!(
        length.to_string().contains("\n   |        ^^^^^^^^"),
        "{length}"
    );

    let bare = error_of("[contact]\nradius = 16\nload = \"1 N\"");
    assert_eq!(bare.message(), "`radius` has no unit");
    assert!(bare.to_string().contains("radius = \"16 mm\""), "{bare}");

    let unitless = error_of("[contact]\nradius = \"16\"\nload = \"1 N\"");
    assert!(
        unitless
            .message()
            .contains("needs a length (m, mm, um, nm)")
    );

    let misspelt = error_of("[contact]\nradius = \"16 mn\"\nload = \"1 N\"");
    assert!(
        misspelt.message().contains("unknown unit `mn`"),
        "{misspelt}"
    );

    let kind = error_of("[contact]\nradius = true\nload = \"1 N\"");
    assert!(kind.message().contains("not a boolean"), "{kind}");
}

#[test]
fn numbers_must_be_finite_and_in_bounds() {
    for bad in [
        "\"0 mm\"",
        "\"-16 mm\"",
        "\"nan mm\"",
        "\"inf m\"",
        "\"1e400 m\"",
        "inf",
        "nan",
    ] {
        let error = error_of(&format!("[contact]\nradius = {bad}\nload = \"1 N\""));
        assert_eq!(error.key(), "contact.radius");
        assert!(
            error.message().contains("must be positive") || error.message().contains("finite"),
            "{error}"
        );
    }
    let document =
        document("a = nan\nb = 0.5\nc = 1e999\nd = 7\ne = 99999999999999999999\nf = 1.5");
    let mut root = document.root();
    assert!(root.required_number("a", Bounds::ANY).is_err());
    let error = root
        .required_number("b", Bounds::open(-1.0, 0.5))
        .unwrap_err();
    assert_eq!(
        error.message(),
        "`b` must be between -1 (excluded) and 0.5 (excluded)"
    );
    assert!(root.required_number("c", Bounds::ANY).is_err());
    let error = root.required_integer("d", 1..=5).unwrap_err();
    assert_eq!(error.message(), "`d` must be a whole number from 1 to 5");
    assert!(root.required_integer("e", 0..=i64::MAX).is_err());
    assert!(root.required_number("e", Bounds::ANY).is_err());
    assert!(root.required_integer("f", 0..=5).is_err());
}

#[test]
fn bounds_include_and_exclude_their_ends() {
    assert!(Bounds::closed(0.0, 1.0).contains(0.0) && Bounds::closed(0.0, 1.0).contains(1.0));
    assert!(!Bounds::open(0.0, 1.0).contains(0.0) && !Bounds::open(0.0, 1.0).contains(1.0));
    assert!(Bounds::from_to(0.0, 1.0).contains(0.0) && !Bounds::from_to(0.0, 1.0).contains(1.0));
    assert!(!Bounds::above_to(0.0, 1.0).contains(0.0) && Bounds::above_to(0.0, 1.0).contains(1.0));
    assert!(!Bounds::POSITIVE.contains(0.0) && Bounds::NON_NEGATIVE.contains(0.0));
    assert!(!Bounds::NEGATIVE.contains(0.0) && Bounds::NEGATIVE.contains(-1.0));
    assert!(!Bounds::ANY.contains(f64::NAN));
    assert_eq!(
        Bounds::closed(1e6, 5e9).describe("Pa"),
        "between 1e6 Pa and 5e9 Pa"
    );
    assert_eq!(
        Bounds::above_to(0.0, 1.0).to_string(),
        "between 0 (excluded) and 1"
    );
}

#[test]
fn an_unknown_choice_lists_the_choices() {
    let document = document("law = \"roelads\"\nother = 3");
    let mut root = document.root();
    let options = [("barus", 1), ("roelands", 2)];
    let error = root.required_choice("law", &options).unwrap_err();
    assert_eq!(
        error.to_string(),
        "\
`roelads` is not a known `law`
  --> case.toml:1:7
   |
 1 | law = \"roelads\"
   |       ^^^^^^^^^ did you mean `roelands`?
   = help: `law` is one of: barus, roelands"
    );
    let missing = root.required_choice("kind", &options).unwrap_err();
    assert_eq!(missing.help(), ["`kind` is one of: barus, roelands"]);
    assert!(root.required_choice("other", &options).is_err());
}

#[test]
fn wrong_kinds_are_refused() {
    let document =
        document("n = 1\ns = \"x\"\nt = { a = 1 }\nl = [1]\nd = 2020-01-01\nm = [\"1 m\", 2]");
    let mut root = document.root();
    assert_eq!(
        root.required_str("n").unwrap_err().message(),
        "`n` must be a string, not an integer"
    );
    assert!(root.required_table("s").is_err());
    assert!(root.required_str_or_table("l").is_err());
    assert!(root.optional_bool("s").is_err());
    assert!(root.required_number("t", Bounds::ANY).is_err());
    assert!(
        root.required_quantity("d", Dimension::TIME, Bounds::ANY)
            .is_err()
    );
    assert!(root.required_numbers("n", Bounds::ANY).is_err());
    assert!(root.optional_strs("l").is_err());
    assert!(root.tables("l").is_err());
    assert!(root.tables("n").is_err());
    // The caret is under the second value.
    let error = root.required_quantities("m", Dimension::LENGTH, Bounds::ANY);
    assert_eq!(error.unwrap_err().column(), Some(13));
}

#[test]
fn syntax_errors_and_duplicates_have_their_place() {
    let duplicate = error_of("[contact]\nradius = \"1 m\"\nradius = \"2 m\"\n");
    assert_eq!(duplicate.line(), Some(3));
    assert!(duplicate.message().contains("duplicate"), "{duplicate}");

    let table = error_of("[contact]\nradius = \"1 m\"\n[contact]\nload = \"2 N\"\n");
    assert_eq!(table.line(), Some(3));

    let unquoted = error_of("[contact]\nradius = 16 mm\n");
    assert_eq!(unquoted.line(), Some(2));
    assert!(unquoted.message().starts_with("not valid TOML"));

    for text in [
        "[contact",
        "radius = ",
        "= 3",
        "a = \"x",
        "\u{0}",
        "a = [1,",
    ] {
        let error = error_of(text);
        assert!(error.line().is_some(), "{error}");
    }
}

#[test]
fn hostile_files_do_not_overflow_the_stack() {
    let nested = format!("a = {}{}", "[".repeat(100_000), "]".repeat(100_000));
    assert!(Document::parse("deep.toml", nested).is_err());
    let tables = format!("a = {}{}", "{ a = ".repeat(100_000), "}".repeat(100_000));
    assert!(Document::parse("deep.toml", tables).is_err());
}

#[test]
fn carets_line_up_after_tabs_accents_and_carriage_returns() {
    let error = error_of("[contact]\r\n\tradius = \"16 µn\"\r\nload = \"1 N\"\r\n");
    let shown = error.to_string();
    assert!(
        shown.contains("\n 2 |  radius = \"16 µn\"\n   |           ^^^^^^^"),
        "{shown}"
    );
}

#[test]
fn columns_count_characters() {
    let document = document("t = { \"µµ\" = \"µm\", r = \"1 N\" }");
    let mut table = document.root().required_table("t").unwrap();
    let error = table
        .required_quantity("r", Dimension::LENGTH, Bounds::ANY)
        .unwrap_err();
    assert_eq!(error.column(), Some(24));
}

#[test]
fn files_that_cannot_be_read_are_named() {
    let folder = tempfile::tempdir().unwrap();
    let absent = folder.path().join("absent.toml");
    let error = Document::read(&absent).unwrap_err().to_string();
    assert!(error.contains("absent.toml cannot be read"), "{error}");

    let binary = folder.path().join("binary.toml");
    std::fs::write(&binary, b"a = 1\nb = \"\xff\"\n").unwrap();
    let error = Document::read(&binary).unwrap_err().to_string();
    assert!(error.contains("is not UTF-8 text (line 2)"), "{error}");

    assert!(Document::read(folder.path()).is_err());
}

#[test]
fn errors_of_later_checks_point_at_their_value() {
    let document = document(CASE);
    let mut root = document.root();
    let contact = root.required_table("contact").unwrap();
    let error = contact
        .error("load", "the Hertz pressure is too high")
        .with_help("below 90 N");
    assert_eq!((error.line(), error.key()), (Some(6), "contact.load"));
    assert_eq!(error.help(), ["below 90 N"]);
    assert_eq!(contact.error("absent", "x").line(), Some(3));
    assert_eq!(contact.error_here("x").key(), "contact");
}

#[test]
fn user_text_is_escaped_and_cut() {
    let document = Document::parse("e\u{1b}sc.toml", "title = \"x\"\n\"\u{1b}[2J\u{9b}\" = 1\n");
    let error = match document {
        Ok(document) => {
            let mut root = document.root();
            let _ = root.optional_str("title");
            root.finish().unwrap_err()
        }
        Err(error) => error,
    };
    let shown = error.to_string();
    assert!(
        shown.chars().all(|c| c == '\n' || !c.is_control()),
        "{shown:?}"
    );
    assert!(
        shown.contains("\\u001b[2J") && shown.contains("e\\u001bsc.toml"),
        "{shown}"
    );
    // The caret is below the fault, and the line is cut on both sides.
    let text = format!("a = \"{}\" ! \"{}\"\n", "µ".repeat(5000), "x".repeat(5000));
    let shown = Document::parse("c.toml", text).unwrap_err().to_string();
    let lines: Vec<&str> = shown.lines().collect();
    let caret = lines.iter().position(|line| line.contains('^')).unwrap();
    let column = lines[caret].chars().position(|c| c == '^').unwrap();
    assert_eq!(lines[caret - 1].chars().nth(column), Some('!'), "{shown}");
    assert!(shown.chars().count() < 700, "{shown}");
    let long = format!("{} = 1\n", "k".repeat(100_000));
    let document = Document::parse("c.toml", long).unwrap();
    let shown = document.root().finish().unwrap_err().to_string();
    assert!(shown.chars().count() < 5000, "{}", shown.len());
}

#[test]
fn files_that_are_none_are_refused_at_once() {
    let folder = tempfile::tempdir().unwrap();
    let error = |path: &std::path::Path| Document::read(path).unwrap_err().to_string();
    assert!(error(folder.path()).contains("it is a folder, not a file"));
    let path = folder.path().join("deep.toml");
    std::fs::write(&path, "[".repeat(3_000_000)).unwrap();
    assert!(error(&path).contains("is too large: 3000000 bytes, and at most 2000000 are read"));
    for deep in [
        "a = ".to_owned() + &"[".repeat(100_000),
        "a = ".to_owned() + &"{a = ".repeat(100_000),
        format!("[{}]\n", vec!["a"; 100_000].join(".")),
    ] {
        std::fs::write(&path, deep).unwrap();
        assert!(
            error(&path).contains("nested too deeply"),
            "{}",
            error(&path)
        );
    }
    #[cfg(target_os = "linux")]
    assert!(error(std::path::Path::new("/dev/zero")).contains("not a regular file"));
}
