//! MD5 (RFC 1321), by which X3P states the content of its files. It finds changes by chance, not those of an attacker.

/// Bits by which each round turns its sums.
const TURNS: [[u32; 4]; 4] = [
    [7, 12, 17, 22],
    [5, 9, 14, 20],
    [4, 11, 16, 23],
    [6, 10, 15, 21],
];
/// Words A to D before the first block.
const START: [u32; 4] = [0x6745_2301, 0xefcd_ab89, 0x98ba_dcfe, 0x1032_5476];

/// The 32 hexadecimal digits, in lower case.
pub(in super::super) fn digest(bytes: &[u8]) -> String {
    // floor(2^32 |sin(i + 1)|)
    let sines: [u32; 64] =
        std::array::from_fn(|i| (((i + 1) as f64).sin().abs() * 4_294_967_296.0) as u32);
    let blocks = bytes.chunks_exact(64);
    let rest = blocks.remainder();
    let mut state = blocks.fold(START, |state, block| next(state, block, &sines));
    // A bit that is set, zeros, and the length in bits at the end of the last block.
    let mut last = rest.to_vec();
    last.push(0x80);
    last.resize(if last.len() > 56 { 120 } else { 56 }, 0);
    last.extend(((bytes.len() as u64).wrapping_mul(8)).to_le_bytes());
    for block in last.chunks_exact(64) {
        state = next(state, block, &sines);
    }
    (state.iter().flat_map(|word| word.to_le_bytes()))
        .map(|byte| format!("{byte:02x}"))
        .collect()
}

fn next(state: [u32; 4], block: &[u8], sines: &[u32; 64]) -> [u32; 4] {
    let word = |i: usize| {
        let mut own = [0; 4];
        own.copy_from_slice(&block[4 * i..4 * i + 4]);
        u32::from_le_bytes(own)
    };
    let [mut a, mut b, mut c, mut d] = state;
    for i in 0..64 {
        let (mixed, k) = match i / 16 {
            0 => ((b & c) | (!b & d), i),
            1 => ((d & b) | (!d & c), 5 * i + 1),
            2 => (b ^ c ^ d, 3 * i + 5),
            _ => (c ^ (b | !d), 7 * i),
        };
        let sum = (a.wrapping_add(mixed))
            .wrapping_add(sines[i])
            .wrapping_add(word(k % 16));
        (a, d, c) = (d, c, b);
        b = b.wrapping_add(sum.rotate_left(TURNS[i / 16][i % 4]));
    }
    [
        state[0].wrapping_add(a),
        state[1].wrapping_add(b),
        state[2].wrapping_add(c),
        state[3].wrapping_add(d),
    ]
}

#[cfg(test)]
mod tests {
    use super::digest;

    /// The test suite of RFC 1321, A.5.
    #[test]
    fn digests_of_the_rfc() {
        for (text, expected) in [
            ("", "d41d8cd98f00b204e9800998ecf8427e"),
            ("a", "0cc175b9c0f1b6a831c399e269772661"),
            ("abc", "900150983cd24fb0d6963f7d28e17f72"),
            ("message digest", "f96b697d7cb7938d525a2f31aaf161d0"),
            (
                "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789",
                "d174ab98d277d9f5a5611c2c9f419d9f",
            ),
            (
                "12345678901234567890123456789012345678901234567890123456789012345678901234567890",
                "57edf4a22be3c955ac49da2e2107b67a",
            ),
        ] {
            assert_eq!(digest(text.as_bytes()), expected, "{text}");
        }
    }
}
