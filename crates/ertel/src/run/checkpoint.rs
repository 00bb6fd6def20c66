//! A case in time that stopped, as bytes that a later run goes on from.
//!
//! ```text
//!   MAGIC, hash of the rest (16 bytes), program and case, the run
//! ```
//! Damaged bytes, a checkpoint of another case and one of another version of the program are refused.

use serde::{Deserialize, Serialize};
use xxhash_rust::xxh3::{xxh3_64, xxh3_128};

use super::NUMERICS;
use super::transient::{
    FilmMap, InstantFields, InstantProfile, InstantSolution, TransientSolution,
};
use crate::case::Case;
use crate::params::OutputParams;
use crate::transient;

/// First bytes of a checkpoint of any version.
pub const NAME: &[u8] = b"ertel checkpoint ";

/// First bytes of those of this version.
const MAGIC: &[u8] = b"ertel checkpoint 3\n";

/// Bytes of the hash.
const HASH: usize = 16;

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
        // Tables and maps of files are a part of the case; its place and its pictures change no step.
        let mut case = case.clone();
        case.source.clear();
        case.origin = None;
        case.output = OutputParams::default();
        case.warnings.clear();
        let read = format!("{} {case:?}", case.given);
        MadeBy {
            version: env!("CARGO_PKG_VERSION").to_owned(),
            numerics: NUMERICS,
            case: xxh3_64(read.as_bytes()),
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
    #[error("this checkpoint is damaged: its bytes do not match their hash")]
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
        // Numbers, lists and texts have a form in bytes.
        let body = postcard::to_allocvec(self).unwrap_or_default();
        [MAGIC, &xxh3_128(&body).to_le_bytes(), &body].concat()
    }

    /// From bytes, for a case.
    ///
    /// # Errors
    /// Bytes that are no checkpoint or a damaged one, and checkpoints of another version or another case.
    pub fn from_bytes(bytes: &[u8], case: &Case) -> Result<Checkpoint, CheckpointError> {
        let hashed = bytes
            .strip_prefix(MAGIC)
            .ok_or(match bytes.starts_with(NAME) {
                true => CheckpointError::OtherVersion,
                false => CheckpointError::Foreign,
            })?;
        let (hash, body) = hashed
            .split_first_chunk::<HASH>()
            .ok_or(CheckpointError::Damaged)?;
        if u128::from_le_bytes(*hash) != xxh3_128(body) {
            return Err(CheckpointError::Damaged);
        }
        // Program and case come first: the rest may have another form.
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
