//! Text of tables from bytes: UTF-8, UTF-16, Windows-1252.

use encoding_rs::{Encoding, UTF_8, UTF_16BE, UTF_16LE, WINDOWS_1252};

use super::FileError;

/// First bytes of files that are no text, and what they are.
const BINARY: [(&[u8], &str); 5] = [
    (
        b"PK\x03\x04",
        "a workbook of a spreadsheet (xlsx, ods) or another archive",
    ),
    (
        b"\xd0\xcf\x11\xe0",
        "a workbook of an older spreadsheet (xls)",
    ),
    (b"%PDF", "a PDF document"),
    (b"{\\rtf", "an RTF document"),
    (b"\x1f\x8b", "a compressed file (gzip)"),
];

/// Bytes by which UTF-16 without a byte-order mark is recognised.
const SAMPLE: usize = 4096;

/// The text of a table.
///
/// # Errors
///
/// Bytes that are no text in any of the encodings.
pub(super) fn decode(bytes: &[u8]) -> Result<String, FileError> {
    if let Some((_, kind)) = BINARY.iter().find(|(start, _)| bytes.starts_with(start)) {
        return Err(FileError::Binary { kind });
    }
    let encoding = encoding_of(bytes);
    let (text, _, _) = encoding.decode(bytes);
    // Old instruments end a file with the control character 26.
    let text = text.trim_end_matches(['\u{1a}', '\0']);
    let is_foreign = |c: char| c.is_control() && !matches!(c, '\t' | '\n' | '\r' | '\u{c}');
    // Errors show an escape or two in a text; other encodings have no such characters in tables.
    if text.contains('\0') || (encoding != UTF_8 && text.contains(is_foreign)) {
        let kind = "neither UTF-8 nor UTF-16 nor Windows-1252 (Latin-1)";
        return Err(FileError::Binary { kind });
    }
    Ok(match has_lone_returns(text) {
        true => text.replace("\r\n", "\n").replace('\r', "\n"),
        false => text.to_owned(),
    })
}

fn encoding_of(bytes: &[u8]) -> &'static Encoding {
    if let Some((encoding, _)) = Encoding::for_bom(bytes) {
        return encoding;
    }
    // Western text in UTF-16 has a zero in every other byte.
    let sample = &bytes[..bytes.len().min(SAMPLE)];
    let zeros = |parity: usize| {
        let own = sample.iter().skip(parity).step_by(2);
        own.filter(|byte| **byte == 0).count()
    };
    let (even, odd, quarter) = (zeros(0), zeros(1), sample.len() / 4);
    if bytes.len() >= 4 && bytes.len().is_multiple_of(2) {
        if odd > quarter && even == 0 {
            return UTF_16LE;
        }
        if even > quarter && odd == 0 {
            return UTF_16BE;
        }
    }
    match std::str::from_utf8(bytes) {
        Ok(_) => UTF_8,
        Err(_) => WINDOWS_1252,
    }
}

/// Whether lines end with a carriage return alone.
fn has_lone_returns(text: &str) -> bool {
    let bytes = text.as_bytes();
    let is_lone = |i: usize| bytes[i] == b'\r' && bytes.get(i + 1) != Some(&b'\n');
    (0..bytes.len()).any(is_lone)
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "Druck [bar];Temperatur [°C]\nä;µ\n";

    #[test]
    fn one_text_in_many_encodings() {
        let utf16 = |bytes_of: fn(u16) -> [u8; 2], mark: &str| -> Vec<u8> {
            let text = format!("{mark}{TEXT}");
            text.encode_utf16().flat_map(bytes_of).collect()
        };
        let latin: Vec<u8> = TEXT.chars().map(|c| c as u8).collect();
        for bytes in [
            TEXT.as_bytes().to_vec(),
            format!("\u{feff}{TEXT}").into_bytes(),
            utf16(u16::to_le_bytes, "\u{feff}"),
            utf16(u16::to_be_bytes, "\u{feff}"),
            utf16(u16::to_le_bytes, ""),
            utf16(u16::to_be_bytes, ""),
            latin,
            TEXT.replace('\n', "\r").into_bytes(),
            format!("{TEXT}\u{1a}").into_bytes(),
        ] {
            assert_eq!(decode(&bytes).unwrap(), TEXT, "{bytes:x?}");
        }
        // The upper half that Windows-1252 has beyond Latin-1: a dash and a quote.
        assert_eq!(decode(b"a \x96 \x93b\x94 \xb0C").unwrap(), "a – “b” °C");
        assert_eq!(decode(b"").unwrap(), "");
    }

    #[test]
    fn what_is_no_text_is_named() {
        for (bytes, words) in [
            (&b"PK\x03\x04\x14\0"[..], "xlsx"),
            (b"\xd0\xcf\x11\xe0\xa1\xb1", "xls"),
            (b"%PDF-1.7", "PDF"),
            (b"a\0\0b\0c\x01", "neither UTF-8"),
            (b"\xff\x81\x02\x03", "neither UTF-8"),
        ] {
            let error = decode(bytes).unwrap_err().to_string();
            assert!(error.contains(words) && error.contains("CSV"), "{error}");
        }
    }
}
