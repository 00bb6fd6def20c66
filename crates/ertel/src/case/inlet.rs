//! `[inlet]`: how much oil reaches the contact.

use ertel_input::{Bounds, InputError, Table};
use ertel_quantity::Dimension;

use super::params::FARTHEST;
use crate::contact::{Contact, Supply, Turn};
use crate::words::length;

/// Thickness of a layer, m: from single molecules to more than a contact can use.
pub(super) const LAYER: Bounds = Bounds::closed(1e-10, 1e-2);

/// Reads `[inlet]`; `half_width` is that of the dry contact along the motion, m, `mesh` the table `[mesh]`.
///
/// # Errors
/// Both keys or none of them, a meniscus inside the dry contact or too far away, a meniscus before an ellipse whose axes are skewed to the motion.
pub(super) fn read(
    mut table: Table<'_>,
    contact: &Contact,
    half_width: f64,
    mesh: Option<&Table<'_>>,
) -> Result<Supply, InputError> {
    let layer = table.optional_quantity("oil_layer", Dimension::LENGTH, LAYER)?;
    let distance =
        table.optional_quantity("meniscus_distance", Dimension::LENGTH, Bounds::POSITIVE)?;
    let supply = match (layer, distance) {
        (Some(_), Some(_)) => {
            return Err(table
                .error(
                    "meniscus_distance",
                    "`oil_layer` and `meniscus_distance` are both given",
                )
                .with_help(
                    "the layer determines the position of the meniscus: give one or the other",
                ));
        }
        (None, None) => {
            return Err(table.missing("oil_layer").with_help(
                "`oil_layer`, the thickness of the oil on both surfaces together, or `meniscus_distance`, from the centre to \
                 the filled gap; without [inlet] the contact is flooded",
            ));
        }
        (Some(thickness), None) => Supply::OilLayer { thickness },
        (None, Some(distance)) => {
            let error = |text: String| table.error("meniscus_distance", text);
            if !Turn::by(contact.along_motion().entrainment_angle).is_none() {
                return Err(error(
                    "a straight meniscus across the motion is for ellipses along it".to_owned(),
                )
                .with_help("give `oil_layer`: it holds for any `entrainment_angle`"));
            }
            if distance <= half_width {
                return Err(error(format!(
                    "the meniscus would lie within the dry contact, whose half-width is {}",
                    length(half_width)
                )));
            }
            if distance > FARTHEST * half_width {
                return Err(error(format!(
                    "the meniscus is farther than {FARTHEST} half-widths, {}: the contact is flooded",
                    length(FARTHEST * half_width)
                ))
                .with_help("remove [inlet]"));
            }
            if let Some(mesh) = mesh
                && mesh.clone().contains("inlet")
            {
                return Err(error(
                    "the mesh ends at the meniscus, but [mesh] gives another `inlet`".to_owned(),
                )
                .with_help("remove `inlet` from [mesh]"));
            }
            Supply::Meniscus { distance }
        }
    };
    table.finish()?;
    Ok(supply)
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::super::Case;
    use super::*;

    fn read(contact: &str, rest: &str) -> Result<Case, InputError> {
        let text = format!(
            "[contact]\n{contact}\n[motion]\nentrainment_speed = \"1 m/s\"\nslide_to_roll_ratio = 0.0\n{rest}\n{}",
            include_str!("../../tests/common/cases/steel.toml")
        );
        Case::from_text("case.toml", &text, Path::new(""))
    }

    const BALL: &str = "kind = \"circular\"\nradius = \"16 mm\"\nload = \"100 N\"";
    const ELLIPSE: &str =
        "kind = \"elliptical\"\nradius_x = \"16 mm\"\nradius_y = \"32 mm\"\nload = \"100 N\"";

    #[test]
    fn supplies() {
        let supply = |contact: &str, rest: &str| read(contact, rest).unwrap().supply;
        assert_eq!(supply(BALL, ""), Supply::Flooded);
        let layer = supply(BALL, "[inlet]\noil_layer = \"150 nm\"");
        assert_eq!(layer, Supply::OilLayer { thickness: 150e-9 });
        let meniscus = supply(ELLIPSE, "[inlet]\nmeniscus_distance = \"1 mm\"");
        assert_eq!(meniscus, Supply::Meniscus { distance: 1e-3 });
    }

    #[test]
    fn bad_supplies_are_refused() {
        let skewed = format!("{ELLIPSE}\nentrainment_angle = \"30 deg\"");
        let cases = [
            (BALL, "", "oil_layer"),
            (BALL, "oil_layer = 1", "unit"),
            (BALL, "oil_layer = \"-1 nm\"", "oil_layer"),
            (BALL, "oil_layer = \"1 Pa\"", "oil_layer"),
            (BALL, "oil_layer = \"nan nm\"", "oil_layer"),
            (BALL, "thickness = \"1 nm\"", "oil_layer"),
            (
                BALL,
                "oil_layer = \"1 um\"\nmeniscus_distance = \"1 mm\"",
                "one or the other",
            ),
            (BALL, "meniscus_distance = \"0.2 mm\"", "half-width"),
            (BALL, "meniscus_distance = \"1 m\"", "flooded"),
            (
                BALL,
                "meniscus_distance = \"1 mm\"\n[mesh]\ninlet = -4.0",
                "[mesh]",
            ),
            (skewed.as_str(), "meniscus_distance = \"1 mm\"", "oil_layer"),
        ];
        for (contact, inlet, word) in cases {
            let error = read(contact, &format!("[inlet]\n{inlet}"))
                .unwrap_err()
                .to_string();
            assert!(error.contains(word), "`{word}` is not in {error}");
        }
    }
}
