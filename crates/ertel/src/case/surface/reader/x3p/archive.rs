//! The archive of an X3P: its files by name, wherever the folder of `main.xml` lies, bounded in size and compared with their checksums.

use miniz_oxide::inflate::decompress_to_vec_with_limit;
use rawzip::{CompressionMethod, ZipArchive};

use super::super::MapError;
use super::md5;

/// The description of the format.
pub(super) const DESCRIPTION: &str = "main.xml";

/// An archive with the folder in which its description lies, in lower case and with a slash at its end.
pub(super) struct Archive<'a> {
    bytes: &'a [u8],
    folder: String,
}

fn damaged(error: &dyn std::fmt::Display) -> MapError {
    MapError::content(format!("the archive is damaged: {error}"))
}

/// A name as it is compared: desktops pack with either slash, descriptions name files from the root or from where they are.
fn plain(name: &[u8]) -> String {
    let name = String::from_utf8_lossy(name)
        .replace('\\', "/")
        .to_lowercase();
    let name = name.trim_start_matches('/');
    name.strip_prefix("./").unwrap_or(name).to_owned()
}

impl<'a> Archive<'a> {
    /// Finds the description, at the top of the archive or in one folder of it.
    pub(super) fn open(bytes: &'a [u8]) -> Result<Self, MapError> {
        let own = ZipArchive::from_slice(bytes).map_err(|e| damaged(&e))?;
        let mut folders: Vec<String> = Vec::new();
        for entry in own.entries() {
            let name = plain(entry.map_err(|e| damaged(&e))?.file_path().as_ref());
            if let Some(folder) = name.strip_suffix(DESCRIPTION)
                && (folder.is_empty() || folder.ends_with('/'))
            {
                folders.push(folder.to_owned());
            }
        }
        let at_the_top = folders.iter().position(String::is_empty);
        let folder = match (at_the_top, folders.len()) {
            (Some(top), _) => folders.swap_remove(top),
            (None, 1) => folders.remove(0),
            (None, 0) => {
                return Err(MapError::content(
                    "the archive has no main.xml: it is no X3P file",
                ));
            }
            (None, n) => {
                return Err(MapError::content(format!(
                    "{n} folders of the archive have a main.xml: an X3P file has one"
                )));
            }
        };
        Ok(Self { bytes, folder })
    }

    /// A file, uncompressed; `None` where there is none.
    pub(super) fn file(&self, name: &str, limit: usize) -> Result<Option<Vec<u8>>, MapError> {
        let wanted = format!("{}{}", self.folder, plain(name.as_bytes()));
        let own = ZipArchive::from_slice(self.bytes).map_err(|e| damaged(&e))?;
        for entry in own.entries() {
            let entry = entry.map_err(|e| damaged(&e))?;
            if plain(entry.file_path().as_ref()) != wanted {
                continue;
            }
            let place = own.get_entry(entry.wayfinder()).map_err(|e| damaged(&e))?;
            let too_large = || damaged(&format!("`{name}` has more than {limit} bytes"));
            let content = match entry.compression_method() {
                CompressionMethod::STORE if place.data().len() > limit => return Err(too_large()),
                CompressionMethod::STORE => place.data().to_vec(),
                CompressionMethod::DEFLATE if entry.uncompressed_size_hint() > limit as u64 => {
                    return Err(too_large());
                }
                CompressionMethod::DEFLATE => {
                    decompress_to_vec_with_limit(place.data(), limit).map_err(|e| damaged(&e))?
                }
                _ => {
                    return Err(MapError::content(format!(
                        "`{name}` in the archive is compressed by another method than deflate"
                    )));
                }
            };
            if rawzip::crc32(&content) != entry.crc32() {
                return Err(damaged(&format!(
                    "`{name}` does not match its CRC-32 checksum"
                )));
            }
            return Ok(Some(content));
        }
        Ok(None)
    }

    /// A file of points that the description names, with the checksum that it states, if any.
    pub(super) fn points(
        &self,
        name: &str,
        limit: usize,
        checksum: Option<&str>,
    ) -> Result<Vec<u8>, MapError> {
        let content = (self.file(name, limit)?)
            .ok_or_else(|| MapError::content(format!("the archive has no `{name}`")))?;
        compare(name, &content, checksum, DESCRIPTION)?;
        Ok(content)
    }

    /// Compares the description with the file of its checksum: lines of `digits *name`, where there is one.
    pub(super) fn check_description(&self, description: &[u8], list: &str) -> Result<(), MapError> {
        let Some(text) = self.file(list, LARGEST_LIST)? else {
            return Ok(());
        };
        let text = String::from_utf8_lossy(&text);
        let stated = text.lines().find_map(|line| {
            let (digits, name) = line.trim().split_once(char::is_whitespace)?;
            let name = plain(name.trim().trim_start_matches('*').as_bytes());
            (name == DESCRIPTION).then_some(digits)
        });
        compare(DESCRIPTION, description, stated, list)
    }
}

/// Bytes of the list of checksums at most: it has one line.
const LARGEST_LIST: usize = 65_536;

/// Refuses content whose checksum is another one than stated; writers that compute none leave it empty or zero.
fn compare(name: &str, content: &[u8], stated: Option<&str>, by: &str) -> Result<(), MapError> {
    let is_stated = |text: &&str| {
        text.len() == 32
            && text.bytes().all(|b| b.is_ascii_hexdigit())
            && text.bytes().any(|b| b != b'0')
    };
    let Some(stated) = stated.map(str::trim).filter(is_stated) else {
        return Ok(());
    };
    let own = md5::digest(content);
    match own.eq_ignore_ascii_case(stated) {
        true => Ok(()),
        false => Err(MapError::content(format!(
            "`{name}` was changed after it was written: its MD5 checksum is {own}, and `{by}` states {}; \
             export the surface again",
            stated.to_ascii_lowercase()
        ))),
    }
}
