//! Equations as comments and pages name them.

/// Sources that have numbered equations, as comments and pages name them.
const SOURCES: [&str; 9] = [
    HABCHI,
    "Johnson 1985",
    "Biboulet and Houpert 2010, part 1",
    "Biboulet and Houpert 2010, part 2",
    "Born and Wolf 1999, section 7.2",
    "Born and Wolf 1999, section 2.3.3",
    "ISO/TS 16281:2008",
    "JCGM 100:2008",
    "Abramowitz and Stegun 1964",
];

/// Numbers on theory pages are those of the thesis where no other source is named.
const HABCHI: &str = "Habchi 2008";

/// An equation by its source and number, or by its name on a theory page.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Equation {
    /// Of one of the sources, with its number there.
    Numbered { source: usize, number: Number },
    /// By bold words or a heading.
    Named(String),
}

impl Equation {
    pub fn words(&self) -> String {
        match self {
            Equation::Numbered { source, number } => {
                format!("{}, eq. {}", SOURCES[*source], number.words)
            }
            Equation::Named(name) => name.clone(),
        }
    }
}

/// `2.24b`, ordered by its parts: chapter or appendix, number, letter.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Number {
    parts: Vec<(u32, String)>,
    words: String,
}

impl Number {
    /// The number with which a text begins, and what follows.
    fn read(text: &str) -> Option<(Number, &str)> {
        let is_part = |c: char| c.is_ascii_alphanumeric() || c == '.';
        let end = text.find(|c| !is_part(c)).unwrap_or(text.len());
        let words = text[..end].trim_end_matches('.');
        let mut parts = Vec::new();
        for part in words.split('.') {
            let digits = part
                .find(|c: char| !c.is_ascii_digit())
                .unwrap_or(part.len());
            let letters = part[digits..].to_owned();
            if letters.len() > 1 {
                return None;
            }
            // Appendices, `A.6`, stand behind the chapters.
            let value = if digits == 0 {
                1000
            } else {
                part[..digits].parse().ok()?
            };
            parts.push((value, letters));
        }
        let has_digit = words.contains(|c: char| c.is_ascii_digit());
        let words = words.to_owned();
        has_digit.then(|| {
            (
                Number {
                    parts,
                    words: words.clone(),
                },
                &text[words.len()..],
            )
        })
    }

    /// All numbers up to another one that differs in its last part.
    fn up_to(&self, last: &Number) -> Vec<Number> {
        let (before, _) = self.words.rsplit_once('.').map_or(("", ""), |parts| parts);
        let ends = [self, last].map(|number| number.parts.last().unwrap().0);
        let all = (ends[0] + 1..=ends[1]).map(|i| match before {
            "" => format!("{i}"),
            before => format!("{before}.{i}"),
        });
        all.map(|words| Number::read(&words).unwrap().0).collect()
    }
}

/// The numbers of `2.25, 2.26 and 2.29 to 2.31, ...` up to the first word that is none.
fn numbers(mut text: &str) -> Vec<Number> {
    let mut found: Vec<Number> = Vec::new();
    let mut is_range = false;
    while let Some((number, rest)) = Number::read(text) {
        let new = match (is_range, found.last()) {
            (true, Some(last)) => last.up_to(&number),
            _ => vec![number],
        };
        found.extend(new);
        let separators = [", ", " and ", " to "];
        let Some(separator) = separators.iter().find(|s| rest.starts_with(**s)) else {
            break;
        };
        is_range = *separator == " to ";
        text = &rest[separator.len()..];
    }
    found
}

/// The equations that a text names; of one without its source, that of `usual`.
///
/// # Errors
/// Text in front of a number that has no source.
pub fn named(text: &str, usual: Option<usize>) -> Result<Vec<Equation>, String> {
    let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
    let mut found = Vec::new();
    for word in ["eq. ", "eqs. "] {
        for (at, _) in text.match_indices(word) {
            let (before, after) = (&text[..at], &text[at + word.len()..]);
            if before.ends_with(|c: char| c.is_alphanumeric()) {
                continue;
            }
            let own = SOURCES
                .iter()
                .position(|s| before.ends_with(&format!("{s}, ")));
            let numbers = numbers(after);
            if numbers.is_empty() {
                continue;
            }
            let source = own.or(usual).ok_or_else(|| {
                let start = before.char_indices().rev().nth(40).map_or(0, |(i, _)| i);
                format!("...{}{word}{}", &before[start..], numbers[0].words)
            })?;
            let with_source = |number| Equation::Numbered { source, number };
            found.extend(numbers.into_iter().map(with_source));
        }
    }
    Ok(found)
}

#[test]
fn numbers_of_equations_are_read() {
    let words = |text: &str| -> Vec<String> {
        let found = named(text, None).unwrap();
        found.iter().map(Equation::words).collect()
    };
    assert_eq!(
        words("(Habchi 2008, eqs. 2.25, 2.26, corrected)."),
        ["Habchi 2008, eq. 2.25", "Habchi 2008, eq. 2.26"]
    );
    assert_eq!(
        words("Johnson 1985,\n eqs. 4.25 to 4.27; see Habchi 2008, eq. A.6."),
        [
            "Habchi 2008, eq. A.6",
            "Johnson 1985, eq. 4.25",
            "Johnson 1985, eq. 4.26",
            "Johnson 1985, eq. 4.27"
        ]
    );
    assert!(named("the diffusion (eq. 2.29).", None).is_err());
    assert_eq!(
        named("(eq. 2.29)", Some(0)),
        named("Habchi 2008, eq. 2.29", None)
    );
    assert!(words("a sequence. 3").is_empty());
}
