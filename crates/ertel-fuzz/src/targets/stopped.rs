//! A run in time that is stopped: its checkpoint in two parts, with a hash that fits.

use std::io;
use std::path::Path;
use std::sync::OnceLock;
use std::time::{Duration, Instant};

use ertel::case::Case;
use ertel::engine::Observer;
use ertel::run::checkpoint::Checkpoint;
use ertel::run::transient::{InstantObserver, Reached, solve_from};
use xxhash_rust::xxh3::xxh3_128;

use crate::input::{Input, Target};

/// A line contact whose bodies come together: it needs no steady solution at its start.
const CASE: &str = include_str!("../../corpus/checkpoint-case.toml");
/// The file up to its program and case, and the rest: this is read alike by all versions that have the same layout.
pub const HEAD: &str = "head.bin";
pub const RUN: &str = "run.bin";
/// Steps after which the run of the seed stops.
const STEPS: usize = 3;
/// Bytes of the hash, and of the wall time at the end of the file.
const HASH: usize = 16;
const WALL_TIME: usize = 8;
/// Time for the run of the seed.
const LONG: Duration = Duration::from_secs(1000);

/// A checkpoint that is not damaged.
pub struct Whole {
    pub case: Case,
    pub head: Vec<u8>,
    pub run: Vec<u8>,
}

/// The run of the case, stopped after some steps.
pub fn whole() -> Option<&'static Whole> {
    static WHOLE: OnceLock<Option<Whole>> = OnceLock::new();
    let make = || {
        let case = Case::from_text("case.toml", CASE, Path::new("")).ok()?;
        let mut stop = Stop::after(STEPS, LONG);
        solve_from(&case, None, &mut stop);
        let mut bytes = stop.kept?.to_bytes();
        // It differs from run to run.
        let n = bytes.len();
        bytes[n - WALL_TIME..].fill(0);
        let body = &bytes[start_of_hash(&bytes)? + HASH..];
        let (_, rest) = postcard::take_from_bytes::<(String, u32, u64)>(body).ok()?;
        let (head, run) = bytes.split_at(n - rest.len());
        let head = sealed(head, run)[..head.len()].to_vec();
        let run = run.to_vec();
        Some(Whole { case, head, run })
    };
    WHOLE.get_or_init(make).as_ref()
}

/// Files from which inputs are made.
///
/// # Errors
/// A case that leaves no checkpoint.
pub fn seed() -> io::Result<Input> {
    let whole = whole().ok_or_else(|| io::Error::other("no checkpoint"))?;
    let files = [
        (RUN, &whole.run[..]),
        (HEAD, &whole.head),
        ("case.toml", CASE.as_bytes()),
    ];
    let files = files.map(|(name, content)| (name.to_owned(), content.to_vec()));
    Ok(Input {
        target: Target::Checkpoint,
        files: files.into(),
    })
}

/// The file with a hash that fits the rest.
pub fn sealed(head: &[u8], run: &[u8]) -> Vec<u8> {
    let mut bytes = [head, run].concat();
    if let Some(at) = start_of_hash(&bytes)
        && let Some((hash, body)) = bytes[at..].split_first_chunk_mut::<HASH>()
    {
        *hash = xxh3_128(body).to_le_bytes();
    }
    bytes
}

/// Where the name of the format ends.
fn start_of_hash(bytes: &[u8]) -> Option<usize> {
    bytes.iter().position(|b| *b == b'\n').map(|at| at + 1)
}

/// Stops a run after a number of instants, or after a time, and keeps its checkpoint.
pub struct Stop {
    left: usize,
    until: Instant,
    kept: Option<Checkpoint>,
}

impl Stop {
    pub fn after(instants: usize, patience: Duration) -> Stop {
        Stop {
            left: instants + 1,
            until: Instant::now() + patience,
            kept: None,
        }
    }
}

impl Observer for Stop {
    fn cancelled(&self) -> bool {
        self.left == 0 || Instant::now() > self.until
    }
}

impl InstantObserver for Stop {
    fn instant(&mut self, _reached: &Reached) {
        self.left = self.left.saturating_sub(1);
    }

    fn checkpoint(&mut self, checkpoint: Checkpoint) {
        self.kept = Some(checkpoint);
    }
}
