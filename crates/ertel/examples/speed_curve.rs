//! Film over speed: each point starts from the one before.
//!
//! `cargo run --release -p ertel --example speed_curve`

use std::path::Path;

use ertel::case::Case;
use ertel::engine::NoObserver;
use ertel::run::{Start, solve_from};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let cases = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases");
    let case = Case::read(&cases.join("roller.toml"))?;
    let mut start: Option<Start> = None;
    for speed in [0.5, 1.0, 2.0, 4.0] {
        let next = case.with_values([("motion.entrainment_speed".to_owned(), speed)].into())?;
        let (solution, end) = solve_from(&next, start.as_ref(), &mut NoObserver)?;
        println!(
            "{speed} m/s {:.1} nm",
            solution.summary.film_central.value * 1e9
        );
        start = Some(end);
    }
    Ok(())
}
