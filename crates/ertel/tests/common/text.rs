//! Case files that several tests start from, as text.

use std::path::Path;

use ertel::case::Case;

/// A steel ball on a steel disc: 16 mm, 100 N, 0.8 m/s.
pub const BALL: &str = include_str!("cases/ball.toml");

/// A line contact of steel: 10 mm, 20 kN/m, 1 m/s.
pub const LINE: &str = include_str!("cases/line.toml");

/// Bodies of steel and a mineral oil alone.
pub const STEEL_AND_OIL: &str = include_str!("cases/steel.toml");

/// A ball on glass in squalane + PIP, sliding at 1.47 m/s.
pub const SQUALANE: &str = include_str!("cases/squalane.toml");

/// The path of FZG gears on three points, and their oil.
pub const GEARS: &str = include_str!("cases/gears.toml");

/// The case of a text.
pub fn read(text: impl AsRef<str>) -> Case {
    Case::from_text("case.toml", text.as_ref(), Path::new("")).unwrap()
}

/// A text with other values in it; each of the old ones must occur.
pub fn with(text: &str, changes: &[[&str; 2]]) -> String {
    changes.iter().fold(text.to_owned(), |text, [old, new]| {
        assert!(text.contains(old), "`{old}` is not in\n{text}");
        text.replace(old, new)
    })
}
