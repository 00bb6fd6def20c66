//! Damage that knows nothing of what it damages.

use fastrand::Rng;

/// Longest file that is made.
pub const LONGEST: usize = 200_000;

/// Pieces of text that readers stumble over: marks of the byte order, control characters, bytes that are no UTF-8,
/// quotes, brackets, ends of lines.
const PIECES: [&[u8]; 20] = [
    b"\xef\xbb\xbf",
    b"\0",
    b"\x1b[2J",
    b"\xff\xfe",
    b"\xc3",
    b"\"",
    b"'''",
    b"\"\"\"",
    b"[",
    b"]]",
    b"{",
    b"}",
    b"=",
    b"\r\n",
    b"\n",
    b",",
    b"#",
    b"\\u0000",
    "\u{202e}".as_bytes(),
    "½µ°".as_bytes(),
];

/// A place in a text of `n` bytes, its end included.
fn place(rng: &mut Rng, n: usize) -> usize {
    rng.usize(0..=n)
}

/// A stretch of at most `most` bytes.
fn stretch(rng: &mut Rng, n: usize, most: usize) -> std::ops::Range<usize> {
    let start = place(rng, n);
    start..(start + rng.usize(1..=most)).min(n)
}

/// Turns a bit, overwrites, cuts, doubles, inserts.
pub fn damage(content: &mut Vec<u8>, rng: &mut Rng) {
    let n = content.len();
    match rng.u8(0..9) {
        0 | 1 if n > 0 => content[rng.usize(0..n)] ^= 1 << rng.u8(0..8),
        2 if n > 0 => content[rng.usize(0..n)] = rng.u8(..),
        3 => drop(content.drain(stretch(rng, n, 30))),
        4 => content.truncate(place(rng, n)),
        5 => {
            let part = content[stretch(rng, n, 60)].to_vec();
            let at = place(rng, n);
            content.splice(at..at, part);
        }
        6 => {
            // As a disk or an editor leaves it: one stretch of zeros, or of one character many times.
            let fill = if rng.bool() { 0 } else { rng.u8(..) };
            let part = vec![fill; 1 << rng.u32(0..14)];
            let at = place(rng, n);
            content.splice(at..at, part);
        }
        _ => {
            let at = place(rng, n);
            let piece = PIECES[rng.usize(0..PIECES.len())];
            let times = if rng.u8(0..20) == 0 {
                rng.usize(1..3000)
            } else {
                1
            };
            content.splice(at..at, piece.repeat(times));
        }
    }
}

/// Damages a binary file: the above, and numbers of eight bytes that stand for sizes.
pub fn damage_binary(content: &mut Vec<u8>, rng: &mut Rng) {
    if content.len() < 16 || rng.bool() {
        return damage(content, rng);
    }
    let sizes = [
        0,
        1,
        2,
        1 << 16,
        1 << 31,
        1 << 40,
        1 << 61,
        u64::MAX,
        u64::MAX / 8,
        i64::MAX as u64,
    ];
    let size = sizes[rng.usize(0..sizes.len())];
    // The header is what everything else is read by.
    let last = if rng.bool() { 96 } else { content.len() };
    let at = rng.usize(0..=last.min(content.len()) - 8) & !7;
    content[at..at + 8].copy_from_slice(&size.to_ne_bytes());
}
