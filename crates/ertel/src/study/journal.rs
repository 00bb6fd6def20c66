//! The journal of a study: a line of JSON for each finished point, appended and brought to the disk one by one.
//!
//! ```text
//!   {"key":"…","converged":true,"fields":[…],"seconds":0.1,"sum":"16 digits"}        sum: xxh3_64 of the line without it
//! ```
//! A line whose bytes were changed is reported, and its point is solved again. Journals of versions before have no sums.
//!
//! A run that is killed loses what it had not appended; a line that the kill tore is dropped by the next run. Points are
//! known by the hash of their case, so that a study whose axes or base case have changed keeps what is unchanged.

use std::collections::{BTreeSet, HashMap};
use std::fs::{self, File, OpenOptions};
use std::io::{self, BufRead, BufReader, Read, Write};
use std::ops::Deref;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

use ertel_input::file::open;
use serde::{Deserialize, Serialize};
use xxhash_rust::xxh3::{xxh3_64, xxh3_128};

use super::StudyError;
use crate::case::Case;
use crate::files::sync_folder;
use crate::run::NUMERICS;
use crate::warning::Warning;

/// Name of the journal in the folder of a study.
pub const JOURNAL: &str = "journal.jsonl";
/// Name of the file there that a run locks.
pub const LOCK: &str = ".lock";

/// Bytes of a line that cannot be a record: many times the length of a record.
const LONGEST_LINE: u64 = 100_000_000;

/// How every record begins.
const RECORD_START: &[u8] = br#"{"key":""#;

/// Text before and after the sum of a line, and its digits.
const SUM_START: &str = r#","sum":""#;
const SUM_END: &str = r#""}"#;
const SUM_DIGITS: usize = 16;

/// Hash of all that a solve sees of a case.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String")]
pub struct PointKey(u128);

impl PointKey {
    /// The key of a case for this version of the numerics. Titles, warnings and places of results do not count.
    pub fn new(case: &Case) -> PointKey {
        let mut case = case.clone();
        case.title.clear();
        case.source.clear();
        case.given = serde_json::Value::Null;
        case.origin = None;
        case.output = crate::params::OutputParams::default();
        case.warnings.clear();
        // Contact and motion hold all that the machine says, and the mechanics all of its contacts.
        case.machine = None;
        case.contacts = None;
        let mut what = "";
        if let Some(whole) = &mut case.whole {
            let whole = Arc::make_mut(whole);
            whole.title.clear();
            whole.folders = false;
            // Journals before had the governing contact alone.
            what = " machine";
        }
        // The debug text includes all fields of a case, also future ones.
        let text = format!("{NUMERICS}{what} {case:?}");
        PointKey(xxh3_128(text.as_bytes()))
    }
}

impl From<PointKey> for String {
    fn from(key: PointKey) -> String {
        format!("{:032x}", key.0)
    }
}

impl TryFrom<String> for PointKey {
    type Error = std::num::ParseIntError;

    fn try_from(text: String) -> Result<PointKey, Self::Error> {
        u128::from_str_radix(&text, 16).map(PointKey)
    }
}

/// Title of a column; equal ones share their text, however many points there are.
#[derive(Clone, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(from = "String", into = "String")]
pub struct Title(Arc<str>);

/// The name of a column that journals of format version 1 called otherwise.
fn renamed(text: String) -> String {
    for body in ["1", "2"] {
        let rest = text.strip_prefix(&format!("body_{body}_temperature_"));
        if let Some(rest) = rest.filter(|r| r.starts_with("maximum") || r.starts_with("mean")) {
            return format!("temperature_body_{body}_{rest}");
        }
    }
    text
}

impl From<String> for Title {
    fn from(text: String) -> Title {
        let text = renamed(text);
        static TITLES: Mutex<BTreeSet<Arc<str>>> = Mutex::new(BTreeSet::new());
        let mut titles = TITLES.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(known) = titles.get(text.as_str()) {
            return Title(known.clone());
        }
        let title: Arc<str> = text.into();
        titles.insert(title.clone());
        Title(title)
    }
}

impl From<Title> for String {
    fn from(title: Title) -> String {
        title.0.to_string()
    }
}

impl Deref for Title {
    type Target = str;

    fn deref(&self) -> &str {
        &self.0
    }
}

/// A finished point.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Record {
    /// Which case.
    pub key: PointKey,
    /// Whether it was solved.
    pub converged: bool,
    /// Why not.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub reason: String,
    /// Fields of its line in the table, by the title of their column.
    pub fields: Vec<(Title, Box<str>)>,
    /// Warnings.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub warnings: Vec<Warning>,
    /// Wall time, s.
    pub seconds: f64,
}

/// Why a line is no record.
#[derive(Debug, thiserror::Error)]
pub enum LineError {
    /// It is something else.
    #[error(transparent)]
    Form(#[from] serde_json::Error),
    /// Its bytes were changed.
    #[error("the line does not match its sum")]
    Sum,
}

impl Record {
    /// Its line in a journal, with its end.
    fn line(&self) -> serde_json::Result<String> {
        let text = serde_json::to_string(self)?;
        let sum = xxh3_64(text.as_bytes());
        let open = text.strip_suffix('}').unwrap_or(&text);
        Ok(format!("{open}{SUM_START}{sum:016x}{SUM_END}\n"))
    }

    /// From a line without its end.
    ///
    /// # Errors
    /// [`LineError`].
    pub fn from_line(line: &[u8]) -> Result<Record, LineError> {
        let Some((text, sum)) = split_sum(line) else {
            return Ok(serde_json::from_slice(line)?);
        };
        match sum == format!("{:016x}", xxh3_64(&text)).as_bytes() {
            true => Ok(serde_json::from_slice(&text)?),
            false => Err(LineError::Sum),
        }
    }

    /// Whether it has figures that its mesh does not resolve.
    pub fn is_unresolved(&self) -> bool {
        (self.field("unresolved")).is_some_and(|names| !names.is_empty())
    }

    /// The field of a column.
    pub fn field(&self, name: &str) -> Option<&str> {
        let (_, value) = self.fields.iter().find(|(own, _)| **own == *name)?;
        Some(value)
    }
}

/// The record of a line and the digits of its sum; `None` where it has none.
fn split_sum(line: &[u8]) -> Option<(Vec<u8>, &[u8])> {
    let rest = line.strip_suffix(SUM_END.as_bytes())?;
    let (rest, sum) = rest.split_at_checked(rest.len().checked_sub(SUM_DIGITS)?)?;
    let open = rest.strip_suffix(SUM_START.as_bytes())?;
    Some(([open, b"}"].concat(), sum))
}

/// The journal in a folder, locked for this process.
#[derive(Debug)]
pub struct Journal {
    path: PathBuf,
    file: File,
    /// Held as long as the journal.
    _lock: Lock,
}

/// Contents of a journal.
#[derive(Debug, Default)]
pub struct Entries {
    /// The last record of each key.
    pub records: HashMap<PointKey, Record>,
    /// Lines that could not be read, or do not match their sum.
    pub n_damaged: usize,
    /// Bytes up to the end of the last whole line.
    length: u64,
    /// Whether what follows the last whole line is no part of a record.
    foreign_end: bool,
}

impl Entries {
    /// Reads the journal in a folder; empty where there is none.
    ///
    /// # Errors
    /// [`StudyError::Io`].
    pub fn read(folder: &Path) -> Result<Entries, StudyError> {
        let path = folder.join(JOURNAL);
        let mut lines = match open(&path, u64::MAX) {
            Ok((file, _)) => BufReader::new(file),
            Err(e) if e.is_missing() => return Ok(Entries::default()),
            Err(e) => return Err(StudyError::io(&path, e.into())),
        };
        let mut entries = Entries::default();
        let mut line = Vec::new();
        loop {
            line.clear();
            let n = ((&mut lines).take(LONGEST_LINE).read_until(b'\n', &mut line))
                .map_err(|e| StudyError::io(&path, e))?;
            if n == 0 {
                break;
            }
            if n as u64 == LONGEST_LINE {
                // No run wrote that, and it need not fit into the memory.
                entries.foreign_end = true;
                break;
            }
            let Some(record) = line.strip_suffix(b"\n") else {
                entries.foreign_end = !is_torn_record(&line);
                break;
            };
            entries.length += n as u64;
            match Record::from_line(record) {
                Ok(record) => {
                    entries.records.insert(record.key, record);
                }
                Err(_) => entries.n_damaged += 1,
            }
        }
        Ok(entries)
    }

    /// Whether it is the journal of another program: no line in it is a record, or its end is no part of one.
    pub fn is_foreign(&self) -> bool {
        (self.n_damaged > 0 && self.records.is_empty()) || self.foreign_end
    }
}

/// Whether a line without end is the beginning of a record, as a kill or a crash of the machine leaves it.
fn is_torn_record(line: &[u8]) -> bool {
    let n = line.iter().rposition(|b| *b != 0).map_or(0, |i| i + 1);
    let n = n.min(RECORD_START.len());
    line[..n] == RECORD_START[..n]
}

/// The lock of a study's folder, held as long as the value.
#[derive(Debug)]
pub struct Lock {
    _file: File,
}

impl Lock {
    /// Locks a folder that exists.
    ///
    /// # Errors
    /// [`StudyError::Locked`] where another run holds it; [`StudyError::Io`].
    pub fn new(folder: &Path) -> Result<Lock, StudyError> {
        let path = folder.join(LOCK);
        let file = options().open(&path);
        let file = file.map_err(|e| StudyError::io(&path, e))?;
        match file.try_lock() {
            Ok(()) => Ok(Lock { _file: file }),
            Err(fs::TryLockError::WouldBlock) => Err(StudyError::Locked {
                folder: folder.to_owned(),
            }),
            Err(fs::TryLockError::Error(e)) => Err(StudyError::io(&path, e)),
        }
    }
}

/// A file to be written, made where there is none; links are not followed.
fn options() -> OpenOptions {
    let mut options = File::options();
    options.create(true).write(true).truncate(false);
    #[cfg(unix)]
    {
        use std::os::unix::fs::OpenOptionsExt;
        options.custom_flags(rustix::fs::OFlags::NOFOLLOW.bits().cast_signed());
    }
    options
}

impl Journal {
    /// Opens the journal in a folder that is locked, where `entries` were read; a torn last line is cut off.
    ///
    /// # Errors
    /// [`StudyError::Io`].
    pub fn open(folder: &Path, lock: Lock, entries: &Entries) -> Result<Journal, StudyError> {
        let path = folder.join(JOURNAL);
        let failed = |path: &Path| {
            let path = path.to_owned();
            move |e| StudyError::io(&path, e)
        };
        // Not by the handle that appends: some systems do not let that one cut.
        let whole = options().open(&path).map_err(failed(&path))?;
        whole.set_len(entries.length).map_err(failed(&path))?;
        whole.sync_all().map_err(failed(&path))?;
        let file = options().append(true).open(&path).map_err(failed(&path))?;
        sync_folder(folder).map_err(failed(folder))?;
        Ok(Journal {
            path,
            file,
            _lock: lock,
        })
    }

    /// Appends a finished point and brings it to the disk.
    ///
    /// # Errors
    /// [`StudyError::Io`].
    pub fn append(&mut self, record: &Record) -> Result<(), StudyError> {
        self.append_all(std::slice::from_ref(record))
    }

    /// Appends several at once.
    ///
    /// # Errors
    /// [`StudyError::Io`].
    pub fn append_all(&mut self, records: &[Record]) -> Result<(), StudyError> {
        let mut write = || -> io::Result<()> {
            let lines: String = (records.iter().map(Record::line)).collect::<Result<_, _>>()?;
            self.file.write_all(lines.as_bytes())?;
            self.file.sync_data()
        };
        write().map_err(|e| StudyError::io(&self.path, e))
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;
    use crate::warning::{Warning, WarningKind};

    const ROLLER: &str = concat!(
        "[contact]\nkind = \"line\"\nradius = \"10 mm\"\nload = \"100 kN/m\"\n",
        "[motion]\nentrainment_speed = \"2 m/s\"\nslide_to_roll_ratio = 0.0\n",
        include_str!("../../tests/common/cases/steel.toml")
    );

    /// Whichever byte of a line is changed, it is no record any more; without its sum it is one of a version before.
    #[test]
    fn changed_bytes_of_a_line_are_found() {
        let record = Record {
            key: PointKey(0x1234),
            converged: true,
            reason: String::new(),
            fields: vec![("film_central_m".to_owned().into(), "1.234e-7".into())],
            warnings: Vec::new(),
            seconds: 0.25,
        };
        let line = record.line().unwrap();
        let line = line.trim_end().as_bytes();
        assert_eq!(Record::from_line(line).unwrap(), record);
        for i in 0..line.len() {
            for bit in [1, 16] {
                let mut changed = line.to_vec();
                changed[i] ^= bit;
                assert!(Record::from_line(&changed).is_err(), "{i}");
            }
        }
        let before = serde_json::to_vec(&record).unwrap();
        assert_eq!(Record::from_line(&before).unwrap(), record);
    }

    /// Inputs without effect on a solve do not change the key; all others do.
    #[test]
    fn keys_depend_on_the_inputs_of_a_solve() {
        let read = |text: &str| Case::from_text("roller.toml", text, Path::new("")).unwrap();
        let case = read(ROLLER);
        let key = PointKey::new(&case);
        let mut other = case.clone();
        other.title = "a roller".to_owned();
        other
            .warnings
            .push(Warning::new(WarningKind::NoEffect, "words"));
        other.output.pictures.png = true;
        assert_eq!(PointKey::new(&other), key);
        for [from, to] in [
            ["100 kN", "101 kN"],
            ["40 degC", "41 degC"],
            ["2 m/s", "3 m/s"],
        ] {
            assert_ne!(PointKey::new(&read(&ROLLER.replace(from, to))), key, "{to}");
        }
    }
}
