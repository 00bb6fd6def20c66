//! An oil of one's own: a viscosity law fitted to measured states, written as a file that cases can name.
//!
//! `cargo run --release -p ertel --example own_oil`

use std::path::Path;

use ertel::case::Case;
use ertel::engine::NoObserver;
use ertel::fit::{Data, Heading, LawName, Params, Property, entry, fit};
use ertel::run;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let table = std::fs::read_to_string(root.join("validation/appendix-c/fluid-a.csv"))?;
    let data = Data::parse("fluid-a.csv", &table, Property::Viscosity)?;
    let law = fit(&data, LawName::Roelands, &Params::default())?;
    println!("rms {:.1} %", 100.0 * law.rms());
    let folder = tempfile::tempdir()?;
    let heading = Heading {
        title: "My oil".to_owned(),
        source: "measured states of fluid A".to_owned(),
    };
    std::fs::write(
        folder.path().join("my-oil.toml"),
        entry(&law, &data, &heading),
    )?;
    let case = Case::builder()
        .folder(folder.path())
        .set("contact.kind", "line")
        .set("contact.radius", "10 mm")
        .set("contact.load", "60 kN/m")
        .set("bodies.body_1", "steel")
        .set("bodies.body_2", "steel")
        .set("motion.entrainment_speed", "2 m/s")
        .set("motion.slide_to_roll_ratio", 0.0)
        .set("lubricant.name", "my-oil.toml")
        .set("lubricant.density.law", "dowson-higginson")
        .set("lubricant.density.rho_0", "870 kg/m^3")
        .set("lubricant.temperature", "40 degC")
        .build()?;
    let solution = run::solve(&case, &mut NoObserver)?;
    println!(
        "central film {:.1} nm",
        solution.summary.film_central.value * 1e9
    );
    Ok(())
}
