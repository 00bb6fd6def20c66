//! A study of speeds and loads: a journal that a later run goes on with, and one table.
//!
//! `cargo run --release -p ertel --example study`

use std::path::Path;

use ertel::case::Study;
use ertel::engine::NoObserver;
use ertel::study::TABLE;
use ertel::sweep::{SweepParams, sweep};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let folder = tempfile::tempdir()?;
    let cases = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases");
    std::fs::copy(cases.join("roller.toml"), folder.path().join("roller.toml"))?;
    let file = folder.path().join("study.toml");
    std::fs::write(
        &file,
        r#"
        case = "roller.toml"
        [[axis]]
        key = "motion.entrainment_speed"
        values = ["1 m/s", "2 m/s"]
        [[axis]]
        key = "contact.load"
        values = ["80 kN/m", "120 kN/m"]
        "#,
    )?;
    let study = Study::read(&file)?;
    let results = folder.path().join("results");
    let summary = sweep(&study, &results, &SweepParams::default(), &NoObserver)?;
    let table = std::fs::read_to_string(results.join(TABLE))?;
    println!(
        "{} points, {} lines in the table",
        summary.n_points,
        table.lines().count()
    );
    Ok(())
}
