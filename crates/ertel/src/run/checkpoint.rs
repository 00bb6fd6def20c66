//! A case in time that stopped, as bytes that a later run goes on from.
//!
//! What a run is made of is kept with it: a checkpoint of another case, or of another version of the program, is refused.

use serde::{Deserialize, Serialize};

use super::NUMERICS;
use super::transient::{
    FilmMap, InstantFields, InstantProfile, InstantSolution, TransientSolution,
};
use crate::case::Case;
use crate::transient;

/// What the bytes begin with.
pub const MAGIC: &[u8] = b"ertel checkpoint 2\n";

/// A run that stopped.
#[derive(Debug, Deserialize, Serialize)]
pub struct Checkpoint {
    made_by: MadeBy,
    pub(super) physics: transient::Checkpoint,
    pub(super) collected: Collected,
    /// Wall time so far, s.
    pub(super) wall_seconds: f64,
}

/// What the results tell of the time until then.
#[derive(Debug, Default, Deserialize, Serialize)]
pub(super) struct Collected {
    pub instants: Vec<InstantSolution>,
    pub profiles: Vec<InstantProfile>,
    pub fields: InstantFields,
    pub map: FilmMap,
}

/// Program and case.
#[derive(Debug, Deserialize, PartialEq, Serialize)]
struct MadeBy {
    version: String,
    numerics: u32,
    case: u64,
}

impl MadeBy {
    fn of(case: &Case) -> MadeBy {
        // Tables and maps of files are a part of what is read.
        let read = format!("{} {:?} {:?}", case.given, case.transient, case.reliefs);
        MadeBy {
            version: env!("CARGO_PKG_VERSION").to_owned(),
            numerics: NUMERICS,
            case: xxhash_rust::xxh3::xxh3_64(read.as_bytes()),
        }
    }
}

/// Why a run cannot go on from some bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum CheckpointError {
    /// They are something else.
    #[error("this is no checkpoint of ertel")]
    Foreign,
    /// They end early, or were changed.
    #[error("this checkpoint is damaged")]
    Damaged,
    /// They are of another version.
    #[error("this checkpoint was written by another version of ertel, whose results may differ")]
    OtherVersion,
    /// They are of another case.
    #[error("this checkpoint is of a case with other values, tables or maps")]
    OtherCase,
}

impl Checkpoint {
    /// Of a run that has come to somewhere.
    pub(super) fn new(
        case: &Case,
        physics: transient::Checkpoint,
        found: &TransientSolution,
        wall_seconds: f64,
    ) -> Checkpoint {
        Checkpoint {
            made_by: MadeBy::of(case),
            physics,
            collected: Collected {
                instants: found.instants.clone(),
                profiles: found.profiles.clone(),
                fields: found.fields.clone(),
                map: found.map.clone(),
            },
            wall_seconds,
        }
    }

    /// As bytes.
    pub fn to_bytes(&self) -> Vec<u8> {
        let mut bytes = MAGIC.to_vec();
        // Numbers, lists and texts have a form in bytes.
        bytes.extend(postcard::to_allocvec(self).unwrap_or_default());
        bytes
    }

    /// From bytes, for a case.
    ///
    /// # Errors
    /// Of something else, or of another case.
    pub fn from_bytes(bytes: &[u8], case: &Case) -> Result<Checkpoint, CheckpointError> {
        let body = bytes.strip_prefix(MAGIC).ok_or(CheckpointError::Foreign)?;
        // Who made them comes first: the rest may have another form.
        let (made_by, _): (MadeBy, _) =
            postcard::take_from_bytes(body).map_err(|_| CheckpointError::Damaged)?;
        let own = MadeBy::of(case);
        if (&made_by.version, made_by.numerics) != (&own.version, own.numerics) {
            return Err(CheckpointError::OtherVersion);
        }
        if made_by.case != own.case {
            return Err(CheckpointError::OtherCase);
        }
        postcard::from_bytes(body).map_err(|_| CheckpointError::Damaged)
    }

    /// Time that it has come to over the duration, s.
    pub fn reached(&self) -> f64 {
        (self.collected.instants.last()).map_or(0.0, |instant| instant.time)
    }
}
