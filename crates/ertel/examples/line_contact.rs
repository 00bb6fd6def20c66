//! A steel roller from its case file, and its computed film compared with film formulas.
//!
//! `cargo run --release -p ertel --example line_contact`

use std::path::Path;

use ertel::case::Case;
use ertel::engine::NoObserver;
use ertel::run;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let cases = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases");
    let case = Case::read(&cases.join("roller.toml"))?;
    let solution = run::solve(&case, &mut NoObserver)?;
    let film = solution.summary.film_central;
    println!("computed {:.1} nm", film.value * 1e9);
    for formula in &solution.formulas {
        if let Some(central) = formula.central {
            println!("{} {:.1} nm", formula.name, central * 1e9);
        }
    }
    Ok(())
}
