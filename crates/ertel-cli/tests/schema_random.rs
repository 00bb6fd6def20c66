//! The schema against the readers on random cases: an editor marks no error in a case that the readers accept.

use std::collections::BTreeSet;
use std::path::Path;

use ertel::case::Case;
use ertel_input::keys::{self, Kind, Row};
use ertel_rheology::database::{fluid_names, solid_names};
use fastrand::Rng;
use serde_json::{Map, Value, json};

use crate::schema::{cases, draft7::errors, schema};

/// Cases that the readers must have taken in the end.
const N_TAKEN: usize = 3_000;
/// Trials at most.
const N_TRIALS: usize = 60_000;
/// Keys among them that must have been given a value.
const LEAST_KEYS: usize = 140;

/// A random value of a row, as people write such values; some of them are wrong.
fn value_of(row: &Row, rng: &mut Rng) -> Value {
    let [low, high] = row.bounds.and_then(|b| b.ends()).unwrap_or([0.0, 4.0]);
    let number =
        |rng: &mut Rng| (1e3 * (low + (high.min(low + 10.0) - low) * rng.f64())).round() / 1e3;
    let word = |words: &[&str], rng: &mut Rng| words[rng.usize(0..words.len())].to_owned();
    match row.kind {
        Kind::Text => json!("oil"),
        Kind::Switch => json!(rng.bool()),
        Kind::Count => json!((low + rng.f64() * (high.min(low + 20.0) - low)) as i64),
        Kind::Number | Kind::Share => match rng.u8(0..6) {
            0 => json!(format!("{} %", 100.0 * number(rng))),
            1 => json!(format!("{} ± 1 %", number(rng))),
            2 => json!(number(rng).round() as i64),
            _ => json!(number(rng)),
        },
        Kind::Numbers => (0..3).map(|_| json!(number(rng))).collect(),
        Kind::Quantity(_) => json!(quantity(row, rng)),
        Kind::Quantities(_) => (0..rng.usize(2..4))
            .map(|_| json!(quantity(row, rng)))
            .collect(),
        Kind::QuantityOr(words) => match rng.bool() {
            true => json!(word(words, rng)),
            false => json!(format!("{} mm", rng.u8(1..50))),
        },
        Kind::Points => json!([[0, 0], [number(rng), 0.0]]),
        Kind::Choice(words) | Kind::AnyCase(words) => {
            let word = word(words, rng);
            match rng.u8(0..8) {
                0 => json!(word.replace('-', "_")),
                1 => json!(word.to_uppercase()),
                _ => json!(word),
            }
        }
        Kind::Choices(words) => json!([word(words, rng)]),
        Kind::Fluid | Kind::FluidOrTable(_) => json!(word(&fluid_names(), rng)),
        Kind::Solid | Kind::SolidOrTable(_) => json!(word(&solid_names(), rng)),
        Kind::Table(rows) => table_of(rows, rng),
        Kind::Tables(rows) => json!([table_of(rows, rng)]),
        Kind::Law(laws) | Kind::LawOr(laws, _) => {
            let law = &laws.laws[rng.usize(0..laws.laws.len())];
            let needed = keys_in(law.needs);
            let rows = laws
                .keys
                .iter()
                .filter(|row| needed.iter().any(|key| row.keys.contains(key)));
            let mut table = Map::from_iter([("law".to_owned(), json!(law.name))]);
            for row in rows {
                table.insert(row.keys[0].to_owned(), value_of(row, rng));
            }
            Value::Object(table)
        }
        Kind::Scalar => match rng.bool() {
            true => json!(number(rng)),
            false => json!(format!("{} mm", rng.u8(1..50))),
        },
        Kind::Texts => json!({ "viscosity": "Result (mPas)" }),
        Kind::List => json!(["Remark"]),
        Kind::Machine(_) => json!(number(rng)),
    }
}

fn keys_in(text: &str) -> Vec<&str> {
    text.split('`').skip(1).step_by(2).collect()
}

/// Some of the keys of a table.
fn table_of(rows: &[Row], rng: &mut Rng) -> Value {
    let mut table = Map::new();
    for row in rows {
        if rng.u8(0..4) > 0 {
            continue;
        }
        let key = row.keys[rng.usize(0..row.keys.len())];
        table.insert(key.to_owned(), value_of(row, rng));
    }
    Value::Object(table)
}

/// A quantity of one of the dimensions, of a usual size where one is known.
fn quantity(row: &Row, rng: &mut Rng) -> String {
    let (Kind::Quantity(dimensions) | Kind::Quantities(dimensions)) = row.kind else {
        return String::new();
    };
    let usual = row.usual.first();
    let (unit, [low, high]) = match usual {
        Some(usual) => (usual.unit.to_owned(), usual.range),
        None => {
            let dimension = dimensions[rng.usize(0..dimensions.len())];
            (dimension.si_unit(), [1e-4, 400.0])
        }
    };
    let size: f64 = low * (high / low).powf(rng.f64());
    match rng.u8(0..6) {
        0 => format!("{size:.3} {unit} ± 2 %"),
        1 => format!("[{size:.3}, {:.3}] {unit}", 1.1 * size),
        2 => format!(" {size:.4e} {unit}"),
        _ => format!("{size:.4} {unit}"),
    }
}

/// The table that a key path belongs to, as a JSON pointer.
fn parent_of(path: &str) -> String {
    let parent = path.rsplit_once('.').map(|(tables, _)| tables);
    parent.map_or_else(String::new, |tables| {
        format!("/{}", tables.replace('.', "/"))
    })
}

/// Puts a value at a key path; whether it is there.
fn put(case: &mut Value, path: &str, value: Value) -> bool {
    let (tables, key) = path.rsplit_once('.').unwrap_or(("", path));
    let mut here = case;
    for name in tables.split('.').filter(|name| !name.is_empty()) {
        let Some(table) = here.as_object_mut() else {
            return false;
        };
        here = table.entry(name).or_insert_with(|| json!({}));
        // Of an array of tables the first.
        if here.get(0).is_some() {
            here = &mut here[0];
        }
    }
    let Some(table) = here.as_object_mut() else {
        return false;
    };
    table.insert(key.to_owned(), value);
    true
}

/// Takes a random key out of a random table.
fn take_out(value: &mut Value, rng: &mut Rng) {
    let Some(table) = value.as_object_mut().filter(|table| !table.is_empty()) else {
        return;
    };
    let key = table.keys().nth(rng.usize(0..table.len())).cloned();
    let key = key.unwrap_or_default();
    match table.get_mut(&key) {
        Some(inner @ Value::Object(_)) if rng.u8(0..5) > 0 => take_out(inner, rng),
        _ => {
            table.shift_remove(&key);
        }
    }
}

/// A value of TOML on one line.
fn inline(value: &Value) -> String {
    match value {
        Value::Object(table) => {
            let pairs: Vec<String> = (table.iter())
                .map(|(key, value)| format!("{key:?} = {}", inline(value)))
                .collect();
            format!("{{ {} }}", pairs.join(", "))
        }
        Value::Array(values) => {
            let values: Vec<String> = values.iter().map(inline).collect();
            format!("[{}]", values.join(", "))
        }
        Value::Number(number) if number.is_f64() => format!("{:?}", number.as_f64().unwrap_or(0.0)),
        other => other.to_string(),
    }
}

fn read(case: &Value, folder: &Path) -> Result<Case, ertel_input::InputError> {
    let lines = case.as_object().into_iter().flatten();
    let lines: Vec<String> = lines
        .map(|(key, value)| format!("{key} = {}\n", inline(value)))
        .collect();
    Case::from_text("case.toml", &lines.concat(), folder)
}

#[test]
fn what_the_readers_take_fits_the_schema() {
    let schema = schema("case");
    let seeds = cases();
    let with = |parent: &str| -> Vec<usize> {
        (0..seeds.len())
            .filter(|&i| seeds[i].1.pointer(parent).is_some())
            .collect()
    };
    let keys: Vec<_> = (keys::all().iter())
        .map(|(key, row)| (key, row, with(&parent_of(key))))
        .collect();
    let mut rng = Rng::with_seed(59);
    let (mut n_taken, mut keys_taken) = (0, BTreeSet::<&str>::new());
    let mut failures = BTreeSet::new();
    for _ in 0..N_TRIALS {
        // A case that has the table of the first key, if there is one.
        let first = rng.usize(0..keys.len());
        let having = &keys[first].2;
        let (path, seed) = match having.is_empty() {
            true => &seeds[rng.usize(0..seeds.len())],
            false => &seeds[having[rng.usize(0..having.len())]],
        };
        let mut case = seed.clone();
        let mut set = Vec::new();
        let others: Vec<usize> = (0..rng.usize(0..3))
            .map(|_| rng.usize(0..keys.len()))
            .collect();
        for k in std::iter::once(first).chain(others) {
            let (key, row, _) = &keys[k];
            let is_there = case.pointer(&parent_of(key)).is_some();
            if (is_there || rng.u8(0..8) == 0) && put(&mut case, key, value_of(row, &mut rng)) {
                set.push(key.as_str());
            }
        }
        if rng.u8(0..3) == 0 {
            take_out(&mut case, &mut rng);
        }
        let refused = errors(&schema, &case);
        match read(&case, path.parent().unwrap()) {
            Ok(_) => {
                n_taken += 1;
                let is_there = |key: &&str| {
                    case.pointer(&format!("/{}", key.replace('.', "/")))
                        .is_some()
                };
                keys_taken.extend(set.iter().copied().filter(is_there));
                failures.extend(
                    refused
                        .into_iter()
                        .map(|error| format!("{error} refuses {set:?}")),
                );
            }
            Err(error) => {
                let is_kind = [
                    "must be a string",
                    "must be true or false",
                    "must be a table",
                    "must be an array",
                ];
                let is_kind = is_kind.iter().any(|words| error.message().contains(words));
                if is_kind && refused.is_empty() {
                    failures.insert(format!("the schema takes: {}", error.message()));
                }
            }
        }
        if n_taken == N_TAKEN {
            break;
        }
    }
    let failures: Vec<String> = failures.into_iter().collect();
    assert!(
        failures.is_empty(),
        "{} failures:\n{}",
        failures.len(),
        failures.join("\n")
    );
    assert_eq!(n_taken, N_TAKEN);
    assert!(keys_taken.len() >= LEAST_KEYS, "{} keys", keys_taken.len());
}
