//! The font of pictures: outlines, widths, and labels cut into runs of one style.
//!
//! Ertel Sans is Liberation Sans 2.1.5, reduced to Latin, Greek and mathematical signs and renamed as its licence asks
//! (SIL Open Font License 1.1, `assets/fonts`). It is as wide as Helvetica and Arial, which SVG viewers take.

use std::sync::OnceLock;

use ttf_parser::{Face, GlyphId};

/// Style of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Style {
    Regular,
    Italic,
}

impl Style {
    pub const ALL: [Style; 2] = [Style::Regular, Style::Italic];

    /// The font file.
    pub fn file(self) -> &'static [u8] {
        match self {
            Style::Regular => include_bytes!("../assets/fonts/ErtelSans-Regular.ttf"),
            Style::Italic => include_bytes!("../assets/fonts/ErtelSans-Italic.ttf"),
        }
    }

    /// The font; `None` would be a damaged file, which the tests exclude.
    pub fn face(self) -> Option<&'static Face<'static>> {
        static FACES: [OnceLock<Option<Face<'static>>>; 2] = [OnceLock::new(), OnceLock::new()];
        let face = FACES[self as usize].get_or_init(|| Face::parse(self.file(), 0).ok());
        face.as_ref()
    }

    /// Glyph of a character, the empty box where the font has none, and its width in ems.
    pub fn glyph(self, c: char) -> (GlyphId, f64) {
        let Some(face) = self.face() else {
            return (GlyphId(0), 0.54);
        };
        let glyph = face.glyph_index(c).unwrap_or(GlyphId(0));
        let width = f64::from(face.glyph_hor_advance(glyph).unwrap_or(0));
        (glyph, width / f64::from(face.units_per_em()))
    }
}

/// Text of one style, size and height.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Run {
    pub text: String,
    pub style: Style,
    /// Font size, px.
    pub size: f64,
    /// How far its baseline lies below that of the label, px.
    pub shift: f64,
}

impl Run {
    /// Advance, px.
    pub fn width(&self) -> f64 {
        let widths = self.text.chars().map(|c| self.style.glyph(c).1);
        self.size * widths.sum::<f64>()
    }
}

/// A label cut into runs: `*p*` italic, `_{h}` subscript, `^{3}` superscript.
pub(crate) fn runs(text: &str, size: f64) -> Vec<Run> {
    let mut runs: Vec<Run> = Vec::new();
    let mut style = Style::Regular;
    let mut plain = String::new();
    let flush = |plain: &mut String, style: Style, runs: &mut Vec<Run>| {
        if !plain.is_empty() {
            runs.push(Run {
                text: std::mem::take(plain),
                style,
                size,
                shift: 0.0,
            });
        }
    };
    let mut chars = text.chars().peekable();
    while let Some(c) = chars.next() {
        match c {
            '*' => {
                flush(&mut plain, style, &mut runs);
                style = match style {
                    Style::Regular => Style::Italic,
                    Style::Italic => Style::Regular,
                };
            }
            '_' | '^' if chars.peek() == Some(&'{') => {
                flush(&mut plain, style, &mut runs);
                chars.next();
                runs.push(Run {
                    text: chars.by_ref().take_while(|c| *c != '}').collect(),
                    style: Style::Regular,
                    size: 0.75 * size,
                    shift: if c == '_' { 0.25 * size } else { -0.38 * size },
                });
            }
            // Control characters are in no font, and XML 1.0 knows none.
            c if c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}') => {}
            c => plain.push(c),
        }
    }
    flush(&mut plain, style, &mut runs);
    runs
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Widths of Helvetica (Adobe's font metrics): p 556, blank 278, parenthesis 333, G 778, P 667, a 556 of 1000.
    #[test]
    fn widths_are_those_of_helvetica() {
        let found = runs("*p*_{h} (GPa)", 10.0);
        assert_eq!(found.len(), 3);
        let expected = [
            5.56,
            7.5 * 0.556,
            0.01 * (278.0 + 2.0 * 333.0 + 778.0 + 667.0 + 556.0),
        ];
        for (run, expected) in found.iter().zip(expected) {
            assert!(
                (run.width() - expected).abs() < 0.01,
                "{run:?} {}",
                run.width()
            );
        }
    }

    /// Every sign of labels has a glyph in both styles.
    #[test]
    fn the_font_has_the_signs_of_labels() {
        for style in Style::ALL {
            for c in "aZ09°µ±×·−–≈≤≥√∞′ηλμνρσξδτΩ√äéß\u{a0}".chars()
            {
                assert_ne!(style.glyph(c).0, GlyphId(0), "{c} {style:?}");
            }
        }
    }
}
