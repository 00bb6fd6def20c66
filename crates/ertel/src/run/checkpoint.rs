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
const MAGIC: &[u8] = b"ertel checkpoint 4\n";

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

impl Collected {
    /// Whether every instant has its row of the map, every output time its fields, and every place its value; times and places rise.
    fn is_whole(&self) -> bool {
        let (map, fields) = (&self.map, &self.fields);
        let times: Vec<f64> = self.instants.iter().map(|instant| instant.time).collect();
        let rows = |values: &[Vec<f32>], n_rows: usize, n: usize| {
            values.len() == n_rows && values.iter().all(|row| row.len() == n)
        };
        let n_places = fields.x.len() * fields.y.len();
        !times.is_empty()
            && [&times, &map.x, &fields.times, &fields.x, &fields.y]
                .into_iter()
                .all(|values| rise(values))
            && rows(&map.films, times.len(), map.x.len())
            && rows(&map.pressures, times.len(), map.x.len())
            && rows(&fields.pressure, fields.times.len(), n_places)
            && rows(&fields.film, fields.times.len(), n_places)
            && (fields.times.is_empty() || n_places > 0)
            && self.profiles.len() == fields.times.len()
            && self.profiles.iter().all(|profile| {
                let n = profile.x.len();
                rise(&profile.x) && profile.pressure.len() == n && profile.film.len() == n
            })
    }
}

/// Whether numbers are finite, each larger than the one before.
fn rise(values: &[f64]) -> bool {
    values.iter().all(|value| value.is_finite()) && values.is_sorted_by(|a, b| a < b)
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
    #[error("this checkpoint is damaged")]
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
        let (read, left): (Checkpoint, _) =
            postcard::take_from_bytes(body).map_err(|_| CheckpointError::Damaged)?;
        let is_whole = left.is_empty() && read.physics.is_whole() && read.collected.is_whole();
        match is_whole && read.wall_seconds >= 0.0 && read.wall_seconds.is_finite() {
            true => Ok(read),
            false => Err(CheckpointError::Damaged),
        }
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;
    use crate::engine::Observer;
    use crate::run::transient::{InstantObserver, Reached, solve_from};

    /// A line contact whose bodies come together.
    const CASE: &str = include_str!("../../../ertel-fuzz/corpus/checkpoint-case.toml");

    /// Stops after the first step.
    #[derive(Default)]
    struct Stop {
        instants: usize,
        kept: Option<Checkpoint>,
    }

    impl Observer for Stop {
        fn cancelled(&self) -> bool {
            self.instants > 1
        }
    }

    impl InstantObserver for Stop {
        fn instant(&mut self, _reached: &Reached) {
            self.instants += 1;
        }

        fn checkpoint(&mut self, checkpoint: Checkpoint) {
            self.kept = Some(checkpoint);
        }
    }

    /// Bytes whose hash fits, but that no run has written, are refused: what follows the run, rows without instants, places that are no numbers.
    #[test]
    fn a_fitting_hash_is_not_enough() {
        let case = Case::from_text("case.toml", CASE, Path::new("")).unwrap();
        let mut stop = Stop::default();
        solve_from(&case, None, &mut stop);
        let whole = stop.kept.unwrap().to_bytes();
        let read = || Checkpoint::from_bytes(&whole, &case).unwrap();
        assert_eq!(read().to_bytes(), whole);
        let body = [&whole[MAGIC.len() + HASH..], b"x"].concat();
        let longer = [MAGIC, &xxh3_128(&body).to_le_bytes(), &body].concat();
        let damage: [fn(&mut Checkpoint); 10] = [
            |of| of.physics.time = f64::NAN,
            |of| of.wall_seconds = f64::NAN,
            |of| of.collected.instants.clear(),
            |of| _ = of.collected.instants.pop(),
            |of| _ = of.collected.map.films.pop(),
            |of| of.collected.map.x.truncate(1),
            |of| of.collected.map.x[0] = f64::NAN,
            |of| of.collected.fields.y.clear(),
            |of| of.collected.fields.times.push(1.0),
            |of| _ = of.collected.profiles[0].film.pop(),
        ];
        let damaged = damage.map(|damage| {
            let mut checkpoint = read();
            damage(&mut checkpoint);
            checkpoint.to_bytes()
        });
        for bytes in damaged.iter().chain([&longer]) {
            let error = Checkpoint::from_bytes(bytes, &case).unwrap_err();
            assert_eq!(error, CheckpointError::Damaged);
        }
    }
}
