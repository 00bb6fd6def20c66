//! A picture as what it consists of: paths, text, images. Written as SVG, PDF or PNG by a backend each.

use super::font;

/// Font size of tick labels and legends, px.
pub const TICK_SIZE: f64 = 12.0;
/// Font size of axis labels, px.
pub const LABEL_SIZE: f64 = 13.5;
/// Text and frame colour.
pub const INK: &str = "#1a1a1a";

/// Horizontal alignment of text.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Anchor {
    /// It begins at the place.
    Start,
    /// Its middle is there.
    Middle,
    /// It ends there.
    End,
}

/// How a path is drawn.
#[derive(Clone, Copy, Debug)]
pub struct Stroke<'a> {
    /// Colour, `#rrggbb`.
    pub colour: &'a str,
    /// Width, px.
    pub width: f64,
    /// Lengths of dash and gap, px.
    pub dash: Option<[f64; 2]>,
}

impl<'a> Stroke<'a> {
    /// A line without gaps.
    pub fn solid(colour: &'a str, width: f64) -> Self {
        Stroke {
            colour,
            width,
            dash: None,
        }
    }
}

/// A line as it is kept.
#[derive(Clone, Debug)]
pub(crate) struct Line {
    pub colour: String,
    pub width: f64,
    pub dash: Option<[f64; 2]>,
}

impl From<Stroke<'_>> for Line {
    fn from(stroke: Stroke) -> Line {
        Line {
            colour: stroke.colour.to_owned(),
            width: stroke.width,
            dash: stroke.dash,
        }
    }
}

/// An image: its pixels, row by row from the top, red, green and blue.
#[derive(Clone, Debug)]
pub struct Raster {
    /// Pixels in a row.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// Three bytes a pixel.
    pub pixels: Vec<u8>,
    /// The same as a PNG file in base 64.
    pub png: String,
}

/// A part of a picture; coordinates in px, y downwards, paths in the notation of SVG.
#[derive(Clone, Debug)]
pub(crate) enum Element {
    /// Outline of a path.
    Stroke(String, Line),
    /// Area of a path, by the even-odd rule.
    Fill(String, String),
    /// Left, top, width and height, and colour.
    Rectangle([f64; 4], String),
    /// Left, top, width and height.
    Image([f64; 4], Box<Raster>),
    /// Centre, radius, colour within and rim.
    Circle([f64; 2], f64, String, Line),
    /// Centre, semi-axes, degrees by which it is turned, and rim.
    Ellipse([f64; 2], [f64; 2], f64, Line),
    /// Text in label markup.
    Text(Text),
    /// Clips the following items to left, top, width and height.
    BeginClip([f64; 4]),
    /// The end of that.
    EndClip,
}

/// Text in label markup (`*p*` italic, `_{h}` and `^{3}` scripts), turned by `turn` degrees about its anchor.
#[derive(Clone, Debug)]
pub(crate) struct Text {
    pub at: [f64; 2],
    pub text: String,
    pub size: f64,
    pub anchor: Anchor,
    pub colour: String,
    pub turn: f64,
}

impl Text {
    /// Its runs, and the distance from its anchor to its start, negative to the left.
    pub fn runs(&self) -> (Vec<font::Run>, f64) {
        let runs = font::runs(&self.text, self.size);
        let width: f64 = runs.iter().map(font::Run::width).sum();
        let start = match self.anchor {
            Anchor::Start => 0.0,
            Anchor::Middle => -0.5 * width,
            Anchor::End => -width,
        };
        (runs, start)
    }
}

/// Why a picture cannot be drawn in a format.
#[derive(Debug, thiserror::Error)]
pub enum DrawingError {
    /// The encoder of PNG files refused.
    #[error("cannot make a picture as PNG: {0}")]
    Png(#[from] png_image::EncodingError),
    /// A picture without an area, or a larger one than there is memory for.
    #[error("cannot make a picture of {width} by {height} pixels")]
    Size {
        /// Pixels.
        width: u32,
        /// Pixels.
        height: u32,
    },
    /// The font cannot be put into a PDF file.
    #[error("cannot put the font into a PDF file: {0}")]
    Font(String),
}

/// A picture; coordinates in px (1/96 inch), y downwards.
#[derive(Clone, Debug)]
pub struct Drawing {
    pub(crate) width: f64,
    pub(crate) height: f64,
    pub(crate) title: String,
    pub(crate) elements: Vec<Element>,
}

impl Drawing {
    /// An empty picture of a size in px.
    pub fn new(width: f64, height: f64, title: &str) -> Drawing {
        Drawing {
            width,
            height,
            title: title.to_owned(),
            elements: Vec::new(),
        }
    }

    /// Outline of a path given as the `d` of SVG.
    pub fn stroke(&mut self, d: &str, stroke: Stroke) {
        if !d.is_empty() {
            self.elements
                .push(Element::Stroke(d.to_owned(), stroke.into()));
        }
    }

    /// Filled path.
    pub fn fill(&mut self, d: &str, colour: &str) {
        if !d.is_empty() {
            self.elements
                .push(Element::Fill(d.to_owned(), colour.to_owned()));
        }
    }

    /// Filled rectangle.
    pub fn rectangle(&mut self, x: f64, y: f64, width: f64, height: f64, colour: &str) {
        let place = [x, y, width, height];
        self.elements
            .push(Element::Rectangle(place, colour.to_owned()));
    }

    /// An image in a rectangle.
    pub fn image(&mut self, place: [f64; 4], raster: Raster) {
        self.elements.push(Element::Image(place, Box::new(raster)));
    }

    /// Circle, filled and outlined.
    pub(crate) fn circle(&mut self, x: f64, y: f64, radius: f64, fill: &str, stroke: Stroke) {
        let fill = fill.to_owned();
        self.elements
            .push(Element::Circle([x, y], radius, fill, stroke.into()));
    }

    /// The outline of an ellipse, turned by `turn` degrees.
    pub fn ellipse(&mut self, at: [f64; 2], radii: [f64; 2], turn: f64, stroke: Stroke) {
        self.elements
            .push(Element::Ellipse(at, radii, turn, stroke.into()));
    }

    /// Text in label markup.
    pub fn text(&mut self, at: [f64; 2], text: &str, size: f64, anchor: Anchor, colour: &str) {
        self.turned_text(at, text, size, anchor, colour, 0.0);
    }

    /// Text turned by `turn` degrees about its anchor.
    pub fn turned_text(
        &mut self,
        at: [f64; 2],
        text: &str,
        size: f64,
        anchor: Anchor,
        colour: &str,
        turn: f64,
    ) {
        self.elements.push(Element::Text(Text {
            at,
            text: text.to_owned(),
            size,
            anchor,
            colour: colour.to_owned(),
            turn,
        }));
    }

    /// Everything until [`Drawing::end_clip`] shows only inside the rectangle.
    pub fn begin_clip(&mut self, x: f64, y: f64, width: f64, height: f64) {
        self.elements
            .push(Element::BeginClip([x, y, width, height]));
    }

    /// Ends what [`Drawing::begin_clip`] began.
    pub fn end_clip(&mut self) {
        self.elements.push(Element::EndClip);
    }
}

/// At most two decimals, none where they are zero.
pub fn number(value: f64) -> String {
    let text = format!("{value:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0" } else { text }.to_owned()
}

/// Width of a label in px.
pub fn text_width(text: &str, size: f64) -> f64 {
    font::runs(text, size).iter().map(font::Run::width).sum()
}

/// A red, green and blue of `#rrggbb` or `white`.
pub(crate) fn rgb(colour: &str) -> [u8; 3] {
    let part = |i: usize| {
        let digits = colour.get(2 * i + 1..2 * i + 3);
        digits.and_then(|d| u8::from_str_radix(d, 16).ok())
    };
    match [part(0), part(1), part(2)] {
        [Some(r), Some(g), Some(b)] if colour.starts_with('#') => [r, g, b],
        _ if colour == "white" => [255; 3],
        _ => [0; 3],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        assert_eq!(number(1.0), "1");
        assert_eq!(number(-0.001), "0");
        assert_eq!(number(12.345), "12.35");
        assert_eq!(number(100.0), "100");
    }

    #[test]
    fn colours_have_three_parts() {
        assert_eq!(rgb("#0072B2"), [0, 0x72, 0xb2]);
        assert_eq!(rgb("white"), [255; 3]);
    }
}
