//! Laws of conductivity and heat capacity from a table.

use super::{
    Files, Material, given_law, linear_factor, locate,
    table::{Columns, Pressures},
};
use crate::Isotherms;
use crate::property::{Property, PropertyLaw};
use ertel_input::{Bounds, InputError, Table};
use ertel_quantity::Dimension;

laws! {
    Constant = "constant",
    Linear = "linear",
    LarssonAndersson = "larsson-andersson",
    Scaling = "scaling",
    Table = "table",
}

/// The readers of a property: its name in messages, its dimension and its own laws.
pub(super) struct Reader<L, S> {
    pub(super) name: &'static str,
    pub(super) dimension: Dimension,
    pub(super) larsson_andersson: L,
    pub(super) scaling: S,
}

impl<L, S> Reader<L, S> {
    /// Reads the law at `key` of `table`, `None` if there is none: a quantity for a constant, or a table with a law.
    pub(super) fn read<P>(
        self,
        table: &mut Table<'_>,
        key: &str,
        material: Material,
        files: Files<'_>,
    ) -> Result<Option<PropertyLaw<P>>, InputError>
    where
        P: Property,
        L: FnOnce(&mut Table<'_>) -> Result<P::LarssonAndersson, InputError>,
        S: FnOnce(&mut Table<'_>) -> Result<P::Scaling, InputError>,
    {
        let Some(mut inner) = given_law(table, key)? else {
            let value = table.optional_quantity(key, self.dimension, Bounds::POSITIVE)?;
            let law = value.map(PropertyLaw::constant).transpose();
            return law.map_err(|error| table.error(key, error.to_string()));
        };
        let table = &mut inner;
        let value = |table: &mut Table<'_>| {
            table.required_quantity(P::KEY, self.dimension, Bounds::POSITIVE)
        };
        let law = match table.required_choice("law", &material.suitable(LAWS))? {
            Law::Constant => PropertyLaw::constant(value(table)?).map_err(locate(table))?,
            Law::Linear => {
                let value = value(table)?;
                let factor = linear_factor(table, material)?;
                PropertyLaw::linear(value, factor).map_err(locate(table))?
            }
            Law::LarssonAndersson => {
                PropertyLaw::LarssonAndersson((self.larsson_andersson)(table)?)
            }
            Law::Scaling => PropertyLaw::Scaling((self.scaling)(table)?),
            Law::Table => {
                let columns =
                    Columns::read(table, files, self.name, self.dimension, Pressures::Optional)?;
                PropertyLaw::Table(columns.law(table, Isotherms::held)?)
            }
        };
        inner.finish()?;
        Ok(Some(law))
    }
}
