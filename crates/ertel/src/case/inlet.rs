//! `[inlet]`: how much oil reaches the contact.

use ertel_rheology::input::{Bounds, InputError, Table};
use ertel_rheology::quantity::Dimension;

use super::params::FARTHEST;
use crate::contact::{Contact, Supply, Turn};
use crate::output::length;

/// Thickness of a layer, m: from single molecules to what no contact takes up.
const LAYER: Bounds = Bounds::closed(1e-10, 1e-2);

/// Reads `[inlet]`; `half_width` is that of the dry contact along the motion, m, `mesh` the table `[mesh]`.
///
/// # Errors
/// Both keys or none of them, a meniscus inside the dry contact or too far away, a meniscus before an ellipse whose axes lie askew.
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
                .error("meniscus_distance", "`oil_layer` and `meniscus_distance` are both given")
                .with_help("the layer decides where the meniscus is: give one or the other"));
        }
        (None, None) => {
            return Err(table.missing("oil_layer").with_help(
                "`oil_layer`, the thickness of the oil on both surfaces together, or `meniscus_distance`, from the centre to \
                 where the gap is full; without [inlet] there is more oil than the contact takes",
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
                .with_help("leave [inlet] out"));
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
