//! Serialised state of an interrupted transient run, from which a later run resumes.
//!
//! ```text
//!   MAGIC, hash of the rest (16 bytes), program and case, the run
//! ```
//! Damaged bytes, and checkpoints of another case or another program version, are rejected.

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

/// An interrupted run.
#[derive(Debug, Deserialize, Serialize)]
pub struct Checkpoint {
    made_by: MadeBy,
    pub(super) physics: transient::Checkpoint,
    pub(super) collected: Collected,
    /// Wall time so far, s.
    pub(super) wall_seconds: f64,
}

/// Results up to that time.
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
        // Tables and map files belong to the case; the location of the case and its pictures do not affect the steps.
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

/// Why a run cannot resume from some bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum CheckpointError {
    /// Not a checkpoint.
    #[error("this is not an ertel checkpoint")]
    Foreign,
    /// Truncated or changed.
    #[error("this checkpoint is damaged: its bytes do not match their hash")]
    Damaged,
    /// From another version.
    #[error("this checkpoint was written by another version of ertel, whose results may differ")]
    OtherVersion,
    /// From another case.
    #[error("this checkpoint belongs to a case with other values, tables or maps")]
    OtherCase,
}

impl Checkpoint {
    /// For a run that has reached some time.
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

    /// Serialises the checkpoint.
    pub fn to_bytes(&self) -> Vec<u8> {
        // Numbers, lists and texts always serialise.
        let body = postcard::to_allocvec(self).unwrap_or_default();
        [MAGIC, &xxh3_128(&body).to_le_bytes(), &body].concat()
    }

    /// Reads a checkpoint of a case.
    ///
    /// # Errors
    /// If the bytes are not a checkpoint, are damaged, or belong to another version or another case.
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
        // Program and case are checked first: the rest may have another layout.
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

    /// The reached time, s.
    pub fn reached(&self) -> f64 {
        (self.collected.instants.last()).map_or(0.0, |instant| instant.time)
    }
}
