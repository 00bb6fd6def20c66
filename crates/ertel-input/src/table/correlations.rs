//! Reader of correlations between uncertain quantities.

use super::Table;
use crate::inputs::NotCorrelated;
use crate::{Bounds, InputError};

impl Table<'_> {
    /// Correlations of uncertain quantities of this table, and of those in it:
    /// `correlation = [{ of = "viscosity.mu_0", with = "viscosity.alpha", coefficient = -0.8 }]`. Called once they are all read.
    ///
    /// # Errors
    ///
    /// A coefficient outside −1 to 1, a key that has no uncertainty, two that are one, or a pair that is correlated already.
    pub fn read_correlations(&mut self) -> Result<(), InputError> {
        let inputs = self.own_recorder();
        for mut pair in self.tables("correlation")? {
            let keys = [pair.required_str("of")?, pair.required_str("with")?];
            let coefficient = pair.required_number("coefficient", Bounds::closed(-1.0, 1.0))?;
            if keys[0] == keys[1] {
                return Err(pair.error("with", "a quantity is correlated with another one"));
            }
            if let Some(inputs) = &inputs {
                (inputs.correlate(keys, coefficient)).map_err(|error| match error {
                    NotCorrelated::Certain(key) => {
                        let at = if key == keys[0] { "of" } else { "with" };
                        pair.error(at, format!("`{key}` has no uncertainty"))
                            .with_help(
                                "it is a key path from here with a ±, as in \"40 mPa.s ± 5 %\"",
                            )
                    }
                    NotCorrelated::Twice => {
                        let [of, with] = keys;
                        pair.error_here(format!("`{of}` and `{with}` are correlated twice"))
                            .with_help(
                                "one coefficient holds in both directions: keep one of the entries",
                            )
                    }
                })?;
            }
            pair.finish()?;
        }
        Ok(())
    }
}
