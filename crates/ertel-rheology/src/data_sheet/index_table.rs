//! The table of ASTM D2270 (ISO 2909), `viscosity_index.csv`.

use std::sync::LazyLock;

/// Kinematic viscosity at 100 degC (mm²/s) of row `i`.
pub(super) fn row(i: usize) -> f64 {
    let i = i as f64;
    if i <= 180.0 {
        2.0 + 0.1 * i
    } else if i <= 230.0 {
        20.0 + 0.2 * (i - 180.0)
    } else {
        30.0 + 0.5 * (i - 230.0)
    }
}

/// Kinematic viscosities at 40 degC, mm²/s, of the oil of index 0, L, and of that of index 100, H, in each row.
pub(super) static L_AND_H: LazyLock<[Vec<f64>; 2]> = LazyLock::new(|| {
    let lines = include_str!("viscosity_index.csv").lines();
    let rows = lines.filter(|line| !line.starts_with('#'));
    let columns: (Vec<f64>, Vec<f64>) = rows
        .map(|row| {
            let (l, h) = row.split_once(',').expect("two columns");
            let number = |text: &str| text.parse::<f64>().expect("a number");
            (number(l), number(h))
        })
        .unzip();
    columns.into()
});
