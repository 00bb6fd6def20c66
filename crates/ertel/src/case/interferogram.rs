//! `[output.interferogram]`: light, oil and spacer layer of an interferogram.

use ertel_input::{Bounds, InputError, Table};
use ertel_quantity::Dimension;

use crate::contact::Contact;
use crate::interference::{CIE_RGB, Interferometer};

/// Ultraviolet to infrared, m.
const WAVELENGTHS: [f64; 2] = [100e-9, 20e-6];
/// Of oils and layers.
const REFRACTIVE_INDICES: Bounds = Bounds::closed(1.0, 4.0);
/// Of a spacer layer, m.
const SPACER: Bounds = Bounds::closed(0.0, 100e-6);
/// Two turns, rad.
const PHASE: Bounds = Bounds::closed(-4.0 * std::f64::consts::PI, 4.0 * std::f64::consts::PI);
/// Names of sets of wavelengths.
const LIGHTS: [(&str, [f64; 3]); 1] = [("cie-rgb", CIE_RGB)];

/// Reads the table.
pub(super) fn read(mut table: Table<'_>, contact: &Contact) -> Result<Interferometer, InputError> {
    if contact.kind.is_line() {
        let error = "an interferogram shows a point contact, but `kind` is a line contact";
        return Err(table
            .error_here(error)
            .with_help("remove [output.interferogram]"));
    }
    let wavelengths = wavelengths(&mut table)?;
    let refractive_index = table.required_number("refractive_index", REFRACTIVE_INDICES)?;
    let follows_density = table.optional_bool("follows_density")?.unwrap_or(false);
    let thickness = table.optional_quantity("spacer_thickness", Dimension::LENGTH, SPACER)?;
    let index = table.optional_number("spacer_refractive_index", REFRACTIVE_INDICES)?;
    let (spacer_thickness, spacer_refractive_index) = match (thickness, index) {
        (None, None) => (0.0, 1.0),
        (Some(thickness), Some(index)) => (thickness, index),
        (Some(_), None) => return Err(table.missing("spacer_refractive_index")),
        (None, Some(_)) => return Err(table.missing("spacer_thickness")),
    };
    let phase_change = table
        .required_quantity("phase_change", Dimension::ANGLE, PHASE)
        .map_err(|error| {
            error.with_help(
                "the phase change of the reflections: with \"180 deg\" zero film is dark",
            )
        })?;
    let visibility = table.optional_number("visibility", Bounds::closed(0.0, 1.0))?;
    table.finish()?;
    Ok(Interferometer {
        wavelengths,
        refractive_index,
        follows_density,
        spacer_thickness,
        spacer_refractive_index,
        phase_change,
        visibility: visibility.unwrap_or(1.0),
    })
}

/// One wavelength, three, or a named set of three.
fn wavelengths(table: &mut Table<'_>) -> Result<Vec<f64>, InputError> {
    let keys = ["wavelength", "wavelengths", "light"];
    let given: Vec<&str> = keys.into_iter().filter(|key| table.contains(key)).collect();
    match given[..] {
        ["wavelength"] => {
            let bounds = Bounds::closed(WAVELENGTHS[0], WAVELENGTHS[1]);
            Ok(vec![table.required_quantity("wavelength", Dimension::LENGTH, bounds)?])
        }
        ["wavelengths"] => {
            let bounds = Bounds::closed(WAVELENGTHS[0], WAVELENGTHS[1]);
            let all = table.required_quantities("wavelengths", Dimension::LENGTH, bounds)?;
            match all.len() {
                3 => Ok(all),
                n => Err(table.error(
                    "wavelengths",
                    format!("`wavelengths` needs three values, for the red, green and blue channel, not {n}"),
                )),
            }
        }
        [_] => {
            let name = table.required_str("light")?;
            let found = LIGHTS.into_iter().find(|(own, _)| *own == name);
            found.map(|(_, wavelengths)| wavelengths.to_vec()).ok_or_else(|| {
                let names = LIGHTS.map(|(name, _)| name).join(", ");
                table.error("light", format!("there is no light `{name}`; the choices are {names}"))
            })
        }
        [] => Err(table.missing("wavelength").with_help(
            "one, wavelength = \"600 nm\"; those of three channels, wavelengths = [\"700 nm\", \"546 nm\", \"436 nm\"]; or light = \"cie-rgb\"",
        )),
        [first, second, ..] => {
            Err(table.error(second, format!("`{first}` and `{second}` are both given; keep one of them")))
        }
    }
}
