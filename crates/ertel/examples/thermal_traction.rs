//! Traction of a sliding line contact whose film heats up.
//!
//! `cargo run --release -p ertel --example thermal_traction`

use ertel::case::Case;
use ertel::engine::NoObserver;
use ertel::run;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let cold = Case::builder()
        .set("contact.kind", "line")
        .set("contact.radius", "10 mm")
        .set("contact.load", "60 kN/m")
        .set("bodies.body_1", "steel")
        .set("bodies.body_2", "steel")
        .set("motion.entrainment_speed", "1 m/s")
        .set("motion.slide_to_roll_ratio", 0.1)
        .set("lubricant", "squalane-pip")
        .set("temperature", "40 degC")
        .set("mesh.target_error", "2 %");
    let hot = cold.clone().set("thermal.max_iterations", 60_i64);
    for (words, builder) in [("isothermal", cold), ("thermal", hot)] {
        let solution = run::solve(&builder.build()?, &mut NoObserver)?;
        println!(
            "{words}: traction coefficient {:.4}",
            solution.traction.coefficient.value
        );
        if let Some(thermal) = &solution.thermal {
            let rise = thermal.film_maximum.value - thermal.inlet_temperature;
            println!("the film is at most {rise:.1} K warmer than the oil that enters");
        }
    }
    Ok(())
}
