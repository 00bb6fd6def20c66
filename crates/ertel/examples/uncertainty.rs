//! How much each input counts, and what its uncertainty makes of the film.
//!
//! `cargo run --release -p ertel --example uncertainty`

use ertel::case::Case;
use ertel::engine::NoObserver;
use ertel::run;
use ertel::solution::Figure;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let case = Case::builder()
        .set("contact.kind", "line")
        .set("contact.radius", "10 mm")
        .set("contact.load", "100 kN/m ± 5 %")
        .set("bodies.body_1", "steel")
        .set("bodies.body_2", "steel")
        .set("motion.entrainment_speed", "2 m/s ± 1 %")
        .set("motion.slide_to_roll_ratio", 0.0)
        .set("lubricant.temperature", "40 degC")
        .set("lubricant.density.law", "dowson-higginson")
        .set("lubricant.density.rho_0", "870 kg/m^3")
        .set("lubricant.viscosity.law", "roelands")
        .set("lubricant.viscosity.mu_0", "40 mPa.s ± 10 %")
        .set("lubricant.viscosity.alpha", "20 1/GPa ± 5 %")
        .build()?;
    let solution = run::solve(&case, &mut NoObserver)?;
    let sensitivities = solution
        .sensitivities
        .ok_or("uncertain inputs have sensitivities")?;
    for figure in sensitivities
        .figures
        .iter()
        .filter(|f| f.figure == Figure::FilmCentral)
    {
        for (key, exponent) in sensitivities.logarithmic(figure) {
            println!("{key} {exponent:+.3}");
        }
    }
    Ok(())
}
