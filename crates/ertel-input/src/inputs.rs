//! The quantities of a document, noted as they are read; and other values to read in their place.

use std::collections::BTreeMap;
use std::sync::{Mutex, PoisonError};

use ertel_quantity::{Correlation, Dimension, Uncertainty};

/// A quantity that was read.
#[derive(Clone, Debug, PartialEq)]
pub struct Input {
    /// Its key path, as `contact.load`; for a quantity of a named entry, below the key of the name: `lubricant.viscosity.mu_0`.
    pub key: String,
    /// Its value as written, SI.
    pub value: f64,
    /// Its dimension.
    pub dimension: Dimension,
    /// Its uncertainty, if it has one.
    pub uncertainty: Option<Uncertainty>,
    /// Whether it is in the document itself, and not in a named entry.
    pub written: bool,
    /// Whether nobody gave it: it is estimated from other inputs.
    pub estimated: bool,
}

/// Quantities of a document, in the order in which they were read.
#[derive(Debug, Default)]
pub struct Inputs {
    replaced: BTreeMap<String, f64>,
    noted: Mutex<Noted>,
}

#[derive(Debug, Default)]
struct Noted {
    inputs: Vec<Input>,
    correlations: Vec<Correlation>,
}

impl Inputs {
    /// None yet; quantities of these key paths are read as these values, SI.
    #[must_use]
    pub fn replacing(replaced: BTreeMap<String, f64>) -> Self {
        Self {
            replaced,
            noted: Mutex::default(),
        }
    }

    /// Recorder of the quantities of the document itself.
    #[must_use]
    pub fn recorder(&self) -> Recorder<'_> {
        Recorder {
            inputs: self,
            prefix: String::new(),
            written: true,
        }
    }

    /// The quantities, and their correlations.
    #[must_use]
    pub fn into_noted(self) -> (Vec<Input>, Vec<Correlation>) {
        let noted = (self.noted.into_inner()).unwrap_or_else(PoisonError::into_inner);
        (noted.inputs, noted.correlations)
    }

    fn note(&self, input: Input) {
        let mut noted = self.noted.lock().unwrap_or_else(PoisonError::into_inner);
        // A quantity that is read again, or overrides that of a named entry, replaces the former.
        match noted.inputs.iter_mut().find(|i| i.key == input.key) {
            Some(known) => *known = input,
            None => noted.inputs.push(input),
        }
    }
}

/// Why two quantities cannot be correlated.
pub(super) enum NotCorrelated<'k> {
    /// This one has no uncertainty.
    Certain(&'k str),
    /// They are already.
    Twice,
}

/// Notes the quantities of a table, and of those in it.
#[derive(Clone, Debug)]
pub struct Recorder<'a> {
    inputs: &'a Inputs,
    prefix: String,
    written: bool,
}

impl<'a> Recorder<'a> {
    /// Recorder of the quantities of the file that the key `key` names.
    #[must_use]
    pub fn within(&self, key: &str) -> Recorder<'a> {
        Recorder {
            inputs: self.inputs,
            prefix: self.path(key),
            written: false,
        }
    }

    /// Notes a correlation of two quantities of the table.
    ///
    /// # Errors
    ///
    /// A quantity without an uncertainty; a pair that is correlated already, in either order.
    pub(super) fn correlate<'k>(
        &self,
        keys: [&'k str; 2],
        coefficient: f64,
    ) -> Result<(), NotCorrelated<'k>> {
        let mut noted = (self.inputs.noted.lock()).unwrap_or_else(PoisonError::into_inner);
        let paths = keys.map(|key| self.path(key));
        for (key, path) in keys.into_iter().zip(&paths) {
            let uncertain = |i: &Input| i.key == *path && i.uncertainty.is_some();
            if !noted.inputs.iter().any(uncertain) {
                return Err(NotCorrelated::Certain(key));
            }
        }
        let is_same = |known: &Correlation| paths.iter().all(|path| known.keys.contains(path));
        if noted.correlations.iter().any(is_same) {
            return Err(NotCorrelated::Twice);
        }
        noted.correlations.push(Correlation {
            keys: paths,
            coefficient,
        });
        Ok(())
    }

    fn path(&self, key: &str) -> String {
        match (self.prefix.as_str(), key) {
            ("", key) => key.to_owned(),
            (prefix, "") => prefix.to_owned(),
            (prefix, key) => format!("{prefix}.{key}"),
        }
    }

    /// Notes a quantity, which nobody gave if `estimated`; returns the value that replaces it, if there is one.
    pub(super) fn read(
        &self,
        key: &str,
        (value, dimension): (f64, Dimension),
        uncertainty: Option<Uncertainty>,
        estimated: bool,
    ) -> Option<f64> {
        let key = self.path(key);
        let replaced = self.inputs.replaced.get(&key).copied();
        self.inputs.note(Input {
            key,
            value,
            dimension,
            uncertainty,
            written: self.written && !estimated,
            estimated,
        });
        replaced
    }
}
