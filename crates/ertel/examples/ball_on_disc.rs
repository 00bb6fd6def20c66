//! A steel ball on a steel disc: film, pressure, and what counts most.
//!
//! `cargo run --release -p ertel --example ball_on_disc`

use ertel::case::Case;
use ertel::engine::NoObserver;
use ertel::run;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let case = Case::builder()
        .set("contact.kind", "circular")
        .set("contact.radius", "16 mm")
        .set("contact.load", "20 N")
        .set("bodies.body_1", "steel")
        .set("bodies.body_2", "steel")
        .set("motion.entrainment_speed", "0.8 m/s")
        .set("motion.slide_to_roll_ratio", 0.0)
        .set("lubricant", "squalane-pip")
        .set("temperature", "40 degC")
        .set("mesh.target_error", "1 %")
        .build()?;
    let solution = run::solve(&case, &mut NoObserver)?;
    let (summary, hertz) = (&solution.summary, &solution.hertz);
    println!("dry contact     {:8.1} MPa", hertz.pressure / 1e6);
    println!(
        "central film    {:8.1} nm",
        summary.film_central.value * 1e9
    );
    println!(
        "minimum film    {:8.1} nm",
        summary.film_minimum.value * 1e9
    );
    println!(
        "largest pressure{:8.1} MPa",
        summary.pressure_maximum.value / 1e6
    );
    Ok(())
}
