//! Numbers with a comma, which people of many countries write for the decimal point, and others between thousands.

/// Possible readings of a number with a comma, as they are to be written, with the text after it; `None` without such a comma.
pub(super) fn readings(text: &str) -> Option<Vec<String>> {
    let is_number = |c: char| c.is_ascii_digit() || matches!(c, '+' | '-' | '.' | ',');
    let end = text.find(|c| !is_number(c)).unwrap_or(text.len());
    let (number, rest) = text.split_at(end);
    // A comma at the end belongs to a sentence, or to a list.
    let within = |at: usize| number[at + 1..].starts_with(|c: char| c.is_ascii_digit());
    let commas: Vec<usize> = number.match_indices(',').map(|(at, _)| at).collect();
    let last = *commas.last()?;
    if !commas.iter().all(|at| within(*at)) {
        return None;
    }
    let decimals = number.len() - last - 1;
    let as_thousands = number.replace(',', "");
    let as_decimal = || {
        let whole = number[..last].replace('.', "");
        format!("{whole}.{}", &number[last + 1..])
    };
    let numbers = match (commas.len(), number.rfind('.')) {
        // 1,234.5
        (_, Some(point)) if point > last => vec![as_thousands],
        // 1.234,5
        (1, Some(_)) => vec![as_decimal()],
        // 1,000
        (1, None) if decimals == 3 => vec![as_decimal(), as_thousands],
        (1, None) => vec![as_decimal()],
        (_, None) => vec![as_thousands],
        (_, Some(_)) => return None,
    };
    Some(numbers.into_iter().map(|n| n + rest).collect())
}

/// The readings as a list of choices.
pub(super) fn listed(readings: &[String]) -> String {
    let quoted: Vec<String> = readings.iter().map(|r| format!("`{r}`")).collect();
    quoted.join(" or ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn commas_are_read_as_people_mean_them() {
        for (text, expected) in [
            ("16,5 mm", Some("`16.5 mm`")),
            ("-0,25", Some("`-0.25`")),
            ("1,000 N", Some("`1.000 N` or `1000 N`")),
            ("1,234.5 N", Some("`1234.5 N`")),
            ("1.234,5 N", Some("`1234.5 N`")),
            ("1,000,000 Pa", Some("`1000000 Pa`")),
            ("2,2e-8 1/Pa", Some("`2.2e-8 1/Pa`")),
            ("16.5 mm", None),
            ("16, mm", None),
            ("16 m,m", None),
            ("1,2.3,4 N", None),
        ] {
            let found = readings(text).map(|r| listed(&r));
            assert_eq!(found.as_deref(), expected, "{text}");
        }
    }
}
