//! A ball bearing: contact and motion follow from its parts and its speed.
//!
//! `cargo run --release -p ertel --example machine`

use std::path::Path;

use ertel::case::Case;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let cases = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/machine");
    for file in std::fs::read_dir(cases)? {
        let path = file?.path();
        if path.extension().is_none_or(|ending| ending != "toml") {
            continue;
        }
        let case = Case::read(&path)?;
        println!(
            "{}: load {:.4e}, radius {:.4e} m, entrainment {:.3} m/s, slide-to-roll {:.4}",
            path.file_stem().unwrap_or_default().to_string_lossy(),
            case.contact.load,
            case.contact.radius,
            case.motion.entrainment_speed,
            case.motion.slide_to_roll_ratio,
        );
    }
    Ok(())
}
