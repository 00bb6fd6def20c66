//! The kind of the base oil of a data sheet, by the names that people give it.

use crate::data_sheet::BaseOil;
use crate::database::names::{base_oil_in, plain};
use ertel_input::{InputError, Table};

/// Kinds of oils for which no correlation with a source is known here, in small letters and digits.
const WITHOUT_CORRELATION: [&str; 21] = [
    "groupv",
    "apigroupv",
    "gruppev",
    "silicone",
    "silikon",
    "siliconeoil",
    "silikonoel",
    "pdms",
    "pfpe",
    "perfluoropolyether",
    "perfluoropolyetheroil",
    "waterglycol",
    "wasserglykol",
    "hfc",
    "polybutene",
    "polyisobutene",
    "pib",
    "gtl",
    "vegetable",
    "vegetableoil",
    "rapeseedoil",
];

/// Advice: data to give instead of a kind.
const INSTEAD: &str = "leave `base_oil` out and give what it would estimate: `pressure_viscosity_coefficient`, two viscosities or \
                       one with `viscosity_index`, and a law of the density, such as density = { law = \"dowson-higginson\", rho_0 = \
                       \"870 kg/m^3\" }";

pub(in crate::read) fn read_base_oil(table: &mut Table<'_>) -> Result<Option<BaseOil>, InputError> {
    let key = "base_oil";
    let Some(text) = table.optional_str(key)? else {
        return Ok(None);
    };
    let plain = plain(text);
    if let Some(base_oil) = BaseOil::by_other_name(&plain) {
        return Ok(Some(base_oil));
    }
    if WITHOUT_CORRELATION.contains(&plain.as_str()) {
        let problem =
            format!("no correlation with a source is known here for the base oil `{text}`");
        return Err(table.error(key, problem).with_help(INSTEAD));
    }
    let names = BaseOil::NAMES.map(|(name, _)| name);
    let error = match base_oil_in(text) {
        Some(near) => table.unknown_name_like(key, &names, Some(near)),
        None => table.unknown_name(key, names),
    };
    Err(error.with_help(format!("if it is none of them, {INSTEAD}")))
}

pub(super) fn needs_base_oil(table: &Table<'_>, key: &str) -> InputError {
    let names = BaseOil::NAMES.map(|(name, _)| name).join(", ");
    table.missing(key).with_help(format!(
        "`base_oil` lets it be estimated; it is one of: {names}"
    ))
}
