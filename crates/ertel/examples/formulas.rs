//! Estimates of a case from formulas, without a solve.
//!
//! `cargo run --release -p ertel --example formulas`

use std::path::Path;

use ertel::case::Case;
use ertel::estimate::estimate;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let cases = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases");
    let case = Case::read(&cases.join("ball-on-disc.toml"))?;
    let found = estimate(&case);
    println!("Hertz pressure {:.3} GPa", found.hertz.pressure / 1e9);
    for formula in &found.formulas {
        let show =
            |film: Option<f64>| film.map_or("-".to_owned(), |h| format!("{:.1} nm", h * 1e9));
        println!(
            "{}: central {}, minimum {}",
            formula.name,
            show(formula.central),
            show(formula.minimum)
        );
    }
    Ok(())
}
