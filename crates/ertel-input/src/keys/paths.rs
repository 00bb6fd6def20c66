//! Key paths of cases, and the rows of each.

use std::sync::LazyLock;

use super::{CASE, Row};

fn collect(path: &str, rows: &'static [Row], found: &mut Vec<(String, &'static Row)>) {
    for row in rows {
        for key in row.keys {
            let path = match path {
                "" => (*key).to_owned(),
                path => format!("{path}.{key}"),
            };
            for table in row.kind.tables() {
                collect(&path, table, found);
            }
            found.push((path, row));
        }
    }
}

/// All keys of cases by their key paths.
pub fn all() -> &'static [(String, &'static Row)] {
    static ALL: LazyLock<Vec<(String, &Row)>> = LazyLock::new(|| {
        let mut found = Vec::new();
        collect("", CASE, &mut found);
        found
    });
    &ALL
}

/// The rows of a key path: of the path from the top of a case; else of those that end with it, as in files of own data.
pub fn rows_of(path: &str) -> Vec<&'static Row> {
    let of = |is_it: &dyn Fn(&str) -> bool| -> Vec<&'static Row> {
        let found = all().iter().filter(|(own, _)| is_it(own));
        found.map(|(_, row)| *row).collect()
    };
    let whole = of(&|own| own == path);
    if !whole.is_empty() {
        return whole;
    }
    of(&|own| {
        own.strip_suffix(path)
            .is_some_and(|head| head.ends_with('.'))
    })
}
