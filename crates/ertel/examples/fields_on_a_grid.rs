//! Film thickness over the whole contact, on a regular grid, as CSV.
//!
//! `cargo run --release -p ertel --example fields_on_a_grid`

use std::path::Path;

use ertel::case::Case;
use ertel::engine::NoObserver;
use ertel::run;
use ertel::solution::Field;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let cases = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases");
    let text = std::fs::read_to_string(cases.join("ball-on-disc.toml"))?;
    let text = format!("{text}\n[mesh]\ntarget_error = \"5 %\"\n");
    let case = Case::from_text("ball-on-disc.toml", &text, &cases)?;
    let solution = run::solve(&case, &mut NoObserver)?;
    let half_width = solution.hertz.half_width;
    let axis: Vec<f64> = (-4..=4).map(|i| 0.25 * f64::from(i) * half_width).collect();
    println!("x [m],y [m],film_thickness [m]");
    for grid in solution.fields().on_grid(&axis, &axis) {
        if grid.field != Field::FilmThickness {
            continue;
        }
        for (i, film) in grid.values.iter().enumerate() {
            println!(
                "{:e},{:e},{film:e}",
                axis[i % axis.len()],
                axis[i / axis.len()]
            );
        }
    }
    Ok(())
}
