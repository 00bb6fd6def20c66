//! The number that a quantity begins with.

/// Splits `"16 mm"` into 16 and `mm`; `None` if there is no number in front.
pub(super) fn split_number(text: &str) -> Option<(f64, &str)> {
    let bytes = text.as_bytes();
    let digits_from = |from: usize| {
        bytes[from..]
            .iter()
            .take_while(|byte| byte.is_ascii_digit())
            .count()
    };
    let mut end = usize::from(matches!(bytes.first(), Some(b'+' | b'-')));
    let mut n_digits = digits_from(end);
    end += n_digits;
    if bytes.get(end) == Some(&b'.') {
        let n_decimals = digits_from(end + 1);
        // The point of "5.Pa" would be a product sign; a number keeps its point only before digits or at its end.
        if n_decimals > 0 || end + 1 == bytes.len() || bytes[end + 1] == b' ' {
            end += 1 + n_decimals;
            n_digits += n_decimals;
        }
    }
    if n_digits == 0 {
        return None;
    }
    if matches!(bytes.get(end), Some(b'e' | b'E')) {
        let sign = usize::from(matches!(bytes.get(end + 1), Some(b'+' | b'-')));
        let n_exponent = if end + 1 + sign <= bytes.len() {
            digits_from(end + 1 + sign)
        } else {
            0
        };
        if n_exponent > 0 {
            end += 1 + sign + n_exponent;
        }
    }
    let number: f64 = text[..end].parse().ok()?;
    match power_of_ten(text[end..].trim_start()) {
        // Read as one number, so that it is rounded once.
        Some((exponent, rest)) => {
            let number = format!("{}e{exponent}", &text[..end]).parse().ok()?;
            Some((number, rest.trim_start()))
        }
        None => Some((number, text[end..].trim_start())),
    }
}

/// The exponent of `×10^-8`, `x 10^-8`, `·10⁻⁸`, and the rest; `None` without a power of ten.
fn power_of_ten(text: &str) -> Option<(i32, &str)> {
    let rest = text.strip_prefix(['×', 'x', '*', '·', '⋅'])?;
    let rest = rest.trim_start().strip_prefix("10")?;
    let (raised, rest) = match rest.strip_prefix('^') {
        Some(rest) => (true, rest),
        None => (false, rest),
    };
    let plain = |c: char| match c {
        '⁻' | '−' => Some('-'),
        '⁰' => Some('0'),
        '¹' => Some('1'),
        '²' => Some('2'),
        '³' => Some('3'),
        '⁴'..='⁹' => char::from_digit(c as u32 - '⁰' as u32, 10),
        '-' | '0'..='9' if raised => Some(c),
        _ => None,
    };
    let digits: String = rest.chars().map_while(plain).collect();
    let n_bytes: usize = rest
        .chars()
        .take(digits.chars().count())
        .map(char::len_utf8)
        .sum();
    let exponent = digits.parse::<i32>().ok()?;
    (exponent.abs() < 400).then(|| (exponent, &rest[n_bytes..]))
}
