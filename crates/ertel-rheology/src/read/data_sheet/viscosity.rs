//! Kinematic viscosities of a data sheet.

use super::data::{computed, estimated, figures, given};
use crate::data_sheet::{
    BaseOil, Estimate, ISO_VG, ISO_VG_NAMES, ISO_VG_TOLERANCE, Spread, viscosity_at_100,
    viscosity_index,
};
use crate::input::{Bounds, InputError, Table};
use crate::provenance::Datum;
use crate::quantity::Dimension;

/// Kinematic viscosities that Walther's equation covers, m²/s, up to pitch.
const VISCOSITIES: Bounds = Bounds::closed(0.2e-6, 1.0);
/// Viscosity indices of oils.
const INDICES: Bounds = Bounds::closed(-200.0, 500.0);
/// Difference between a given and a computed index that rounding explains.
const INDEX_TOLERANCE: f64 = 5.0;

/// Kinematic viscosity at 40 degC (m²/s), measured or that of the grade.
pub(super) fn viscosity_40(
    table: &mut Table<'_>,
    data: &mut Vec<Datum>,
) -> Result<f64, InputError> {
    let key = "kinematic_viscosity_40";
    let measured = table.optional_quantity(key, Dimension::KINEMATIC_VISCOSITY, VISCOSITIES)?;
    table.contains("iso_vg");
    let grade = (table.unnoted()).optional_number("iso_vg", Bounds::POSITIVE)?;
    let middle = match grade {
        None => None,
        Some(grade) => match ISO_VG_NAMES.iter().position(|name| *name == grade) {
            Some(i) => Some(1e-6 * ISO_VG[i]),
            None => {
                let names = ISO_VG_NAMES.map(|name| name.to_string()).join(", ");
                return Err(table
                    .error("iso_vg", format!("there is no grade ISO VG {grade}"))
                    .with_help(format!("the grades of ISO 3448 are {names}")));
            }
        },
    };
    if let Some(grade) = grade {
        data.push(given(table, "iso_vg", grade.to_string(), "1"));
    }
    match (measured, middle) {
        (Some(nu), Some(middle)) => {
            if (nu / middle - 1.0).abs() > ISO_VG_TOLERANCE + 1e-9 {
                return Err(table
                    .error(
                        key,
                        format!(
                            "an oil of {} mm^2/s at 40 degC is not of grade ISO VG {}, which has {} to {} mm^2/s",
                            figures(1e6 * nu),
                            grade.unwrap_or_default(),
                            figures(1e6 * middle * (1.0 - ISO_VG_TOLERANCE)),
                            figures(1e6 * middle * (1.0 + ISO_VG_TOLERANCE)),
                        ),
                    )
                    .with_help("give `iso_vg` or `kinematic_viscosity_40`, or make them agree"));
            }
            data.push(given(table, key, figures(1e6 * nu), "mm^2/s"));
            Ok(nu)
        }
        (Some(nu), None) => {
            data.push(given(table, key, figures(1e6 * nu), "mm^2/s"));
            Ok(nu)
        }
        (None, Some(middle)) => {
            let estimate = Estimate {
                value: middle,
                below: ISO_VG_TOLERANCE,
                above: ISO_VG_TOLERANCE,
                spread: Spread::Even,
                source: "iso3448",
                basis: "an oil of a grade may lie anywhere in it",
            };
            let dimension = Dimension::KINEMATIC_VISCOSITY;
            Ok(estimated(
                table,
                data,
                (key, &estimate),
                dimension,
                (1e6, "mm^2/s"),
            ))
        }
        (None, None) => Err(table
            .missing(key)
            .with_help("a data sheet needs `kinematic_viscosity_40` or `iso_vg`")),
    }
}

/// Kinematic viscosity at 100 degC (m²/s), measured or from the viscosity index.
pub(super) fn viscosity_100(
    table: &mut Table<'_>,
    nu_40: f64,
    base_oil: Option<BaseOil>,
    data: &mut Vec<Datum>,
) -> Result<f64, InputError> {
    let key = "kinematic_viscosity_100";
    let measured = table.optional_quantity(key, Dimension::KINEMATIC_VISCOSITY, VISCOSITIES)?;
    let index = table.optional_number("viscosity_index", INDICES)?;
    if let Some(nu) = measured {
        if nu >= nu_40 {
            return Err(table
                .error(
                    key,
                    format!(
                        "the viscosity at 100 degC, {} mm^2/s, must be below that at 40 degC, {} mm^2/s",
                        figures(1e6 * nu),
                        figures(1e6 * nu_40)
                    ),
                )
                .with_help("are both exchanged?"));
        }
        let found = viscosity_index(nu_40, nu);
        if let Some(found) = found.filter(|index| !INDICES.contains(*index)) {
            return Err(table
                .error(
                    key,
                    format!(
                        "with {} mm^2/s at 40 degC this is a viscosity index of {found:.0}, which no oil has",
                        figures(1e6 * nu_40)
                    ),
                )
                .with_help("mineral oils have about 95, polyalphaolefins 150"));
        }
        if let (Some(index), Some(found)) = (index, found)
            && (index - found).abs() > INDEX_TOLERANCE
        {
            return Err(table
                .error(
                    "viscosity_index",
                    format!(
                        "the viscosities at 40 and 100 degC make an index of {found:.0}, not {index}"
                    ),
                )
                .with_help("give two of `kinematic_viscosity_40`, `kinematic_viscosity_100` and `viscosity_index`"));
        }
        data.push(given(table, key, figures(1e6 * nu), "mm^2/s"));
        if let Some(found) = found {
            data.push(computed(
                "viscosity_index",
                format!("{found:.0}"),
                "1",
                "astm_d2270",
            ));
        }
        return Ok(nu);
    }
    let (index, key) = match (index, base_oil.and_then(BaseOil::viscosity_index)) {
        (Some(index), _) => {
            data.push(given(table, "viscosity_index", index.to_string(), "1"));
            (index, "viscosity_index")
        }
        (None, Some(typical)) => {
            let key = ("viscosity_index", &typical);
            let index = estimated(table, data, key, Dimension::DIMENSIONLESS, (1.0, "1"));
            (index, "base_oil")
        }
        (None, None) => {
            return Err(table.missing(key).with_help(
                "give it, or `viscosity_index`; a typical index is known for base_oil = \"mineral\" or \"PAO\"",
            ));
        }
    };
    let Some(nu) = viscosity_at_100(nu_40, index) else {
        return Err(table
            .error(
                key,
                format!(
                    "no oil of {} mm^2/s at 40 degC and more than 2 mm^2/s at 100 degC has a viscosity index of {index}",
                    figures(1e6 * nu_40)
                ),
            )
            .with_help("give `kinematic_viscosity_100`"));
    };
    data.push(computed(
        "kinematic_viscosity_100",
        figures(1e6 * nu),
        "mm^2/s",
        "astm_d2270",
    ));
    Ok(nu)
}
