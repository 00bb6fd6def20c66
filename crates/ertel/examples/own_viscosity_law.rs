//! A viscosity law of one's own, as a function in code: tabulated, and read as a table of measured states is.
//!
//! `cargo run --release -p ertel --example own_viscosity_law`

use std::fmt::Write as _;

use ertel::case::Case;
use ertel::engine::NoObserver;
use ertel::run;

/// Pa.s at a pressure in Pa: a power law that no database has.
fn viscosity(pressure: f64) -> f64 {
    0.04 * (1.0 + pressure / 0.4e9).powf(9.0)
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let folder = tempfile::tempdir()?;
    let mut table = String::from("pressure [MPa],temperature [degC],viscosity [mPa.s]\n");
    for temperature in [20, 40, 60] {
        for step in 0..=80 {
            let pressure = 25.0e6 * f64::from(step);
            writeln!(
                table,
                "{},{temperature},{}",
                pressure / 1e6,
                1e3 * viscosity(pressure)
            )?;
        }
    }
    std::fs::write(folder.path().join("law.csv"), table)?;
    let case = Case::builder()
        .folder(folder.path())
        .set("contact.kind", "line")
        .set("contact.radius", "10 mm")
        .set("contact.load", "60 kN/m")
        .set("bodies.body_1", "steel")
        .set("bodies.body_2", "steel")
        .set("motion.entrainment_speed", "2 m/s")
        .set("motion.slide_to_roll_ratio", 0.0)
        .set("lubricant.temperature", "40 degC")
        .set("lubricant.density.law", "dowson-higginson")
        .set("lubricant.density.rho_0", "870 kg/m^3")
        .set("lubricant.viscosity.law", "table")
        .set("lubricant.viscosity.file", "law.csv")
        .set("mesh.target_error", "1 %")
        .build()?;
    let solution = run::solve(&case, &mut NoObserver)?;
    println!(
        "central film {:.1} nm",
        solution.summary.film_central.value * 1e9
    );
    Ok(())
}
