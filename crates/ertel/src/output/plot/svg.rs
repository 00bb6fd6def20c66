//! A small SVG writer: paths, text with italics and scripts, clipping.

use std::fmt::Write;

/// Font size of tick labels and legends, px.
pub(super) const TICK_SIZE: f64 = 12.0;
/// Font size of axis labels, px.
pub(super) const LABEL_SIZE: f64 = 13.5;
/// Text and frame colour.
pub(super) const INK: &str = "#1a1a1a";

const FONT: &str = "Helvetica, Arial, 'Liberation Sans', 'DejaVu Sans', sans-serif";

/// Horizontal alignment of text.
#[derive(Clone, Copy)]
pub(super) enum Anchor {
    Start,
    Middle,
    End,
}

/// How a path is drawn.
#[derive(Clone, Copy)]
pub(super) struct Stroke<'a> {
    pub colour: &'a str,
    pub width: f64,
    pub dash: Option<&'a str>,
}

impl<'a> Stroke<'a> {
    pub fn solid(colour: &'a str, width: f64) -> Self {
        Stroke {
            colour,
            width,
            dash: None,
        }
    }
}

/// A picture under construction; coordinates in px, y downwards.
pub(super) struct Svg {
    width: f64,
    height: f64,
    title: String,
    body: String,
    n_clips: usize,
}

impl Svg {
    pub fn new(width: f64, height: f64, title: &str) -> Svg {
        Svg {
            width,
            height,
            title: escape(title),
            body: String::new(),
            n_clips: 0,
        }
    }

    fn push(&mut self, element: std::fmt::Arguments) {
        // Writing into a String cannot fail
        let _ = writeln!(self.body, "{element}");
    }

    /// Outline of a path given by its `d` attribute.
    pub fn stroke(&mut self, d: &str, stroke: Stroke) {
        if d.is_empty() {
            return;
        }
        let dash = stroke
            .dash
            .map_or(String::new(), |d| format!(" stroke-dasharray=\"{d}\""));
        self.push(format_args!(
            "<path d=\"{d}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" stroke-linejoin=\"round\"{dash}/>",
            stroke.colour,
            number(stroke.width)
        ));
    }

    /// Filled path.
    pub fn fill(&mut self, d: &str, colour: &str) {
        if !d.is_empty() {
            self.push(format_args!(
                "<path d=\"{d}\" fill=\"{colour}\" fill-rule=\"evenodd\"/>"
            ));
        }
    }

    /// Filled rectangle.
    pub fn rectangle(&mut self, x: f64, y: f64, width: f64, height: f64, colour: &str) {
        self.push(format_args!(
            "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{colour}\"/>",
            number(x),
            number(y),
            number(width),
            number(height)
        ));
    }

    /// An image: left, top, width and height, and its PNG file in base 64.
    pub fn image(&mut self, [x, y, width, height]: [f64; 4], png: &str) {
        self.push(format_args!(
            "<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" preserveAspectRatio=\"none\" href=\"data:image/png;base64,{png}\"/>",
            number(x),
            number(y),
            number(width),
            number(height)
        ));
    }

    /// Circle, filled or outlined.
    pub fn circle(&mut self, x: f64, y: f64, radius: f64, fill: &str, stroke: Stroke) {
        self.push(format_args!(
            "<circle cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"{fill}\" stroke=\"{}\" stroke-width=\"{}\"/>",
            number(x),
            number(y),
            number(radius),
            stroke.colour,
            number(stroke.width)
        ));
    }

    /// The outline of an ellipse, turned by `turn` degrees.
    pub fn ellipse(&mut self, [x, y]: [f64; 2], [rx, ry]: [f64; 2], turn: f64, stroke: Stroke) {
        self.push(format_args!(
            "<ellipse cx=\"{}\" cy=\"{}\" rx=\"{}\" ry=\"{}\" transform=\"rotate({} {} {})\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\"/>",
            number(x),
            number(y),
            number(rx),
            number(ry),
            number(turn),
            number(x),
            number(y),
            stroke.colour,
            number(stroke.width)
        ));
    }

    /// Text in the notation of [`spans`], turned by `turn` degrees about its anchor.
    pub fn text(&mut self, at: [f64; 2], text: &str, size: f64, anchor: Anchor, colour: &str) {
        self.turned_text(at, text, size, anchor, colour, 0.0);
    }

    pub fn turned_text(
        &mut self,
        at: [f64; 2],
        text: &str,
        size: f64,
        anchor: Anchor,
        colour: &str,
        turn: f64,
    ) {
        let (x, y) = (number(at[0]), number(at[1]));
        let anchor = match anchor {
            Anchor::Start => "start",
            Anchor::Middle => "middle",
            Anchor::End => "end",
        };
        let transform = if turn == 0.0 {
            String::new()
        } else {
            format!(" transform=\"rotate({} {x} {y})\"", number(turn))
        };
        let spans = spans(text, size);
        self.push(format_args!(
            "<text x=\"{x}\" y=\"{y}\" font-size=\"{}\" text-anchor=\"{anchor}\" fill=\"{colour}\"{transform}>{spans}</text>",
            number(size)
        ));
    }

    /// Everything until [`Svg::end_clip`] shows only inside the rectangle.
    pub fn begin_clip(&mut self, x: f64, y: f64, width: f64, height: f64) {
        self.n_clips += 1;
        let id = self.n_clips;
        self.push(format_args!(
            "<clipPath id=\"c{id}\"><rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/></clipPath>\n<g clip-path=\"url(#c{id})\">",
            number(x),
            number(y),
            number(width),
            number(height)
        ));
    }

    pub fn end_clip(&mut self) {
        self.push(format_args!("</g>"));
    }

    /// The finished file.
    pub fn finish(self) -> String {
        let (w, h) = (number(self.width), number(self.height));
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{w}\" height=\"{h}\" viewBox=\"0 0 {w} {h}\" font-family=\"{FONT}\">\n\
             <title>{}</title>\n<rect width=\"{w}\" height=\"{h}\" fill=\"white\"/>\n{}</svg>\n",
            self.title, self.body
        )
    }
}

/// At most two decimals, none where they are zero.
pub(super) fn number(value: f64) -> String {
    let text = format!("{value:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0" } else { text }.to_owned()
}

fn escape(text: &str) -> String {
    text.chars()
        // XML 1.0 knows no control characters
        .filter(|c| !c.is_control() && !matches!(c, '\u{fffe}' | '\u{ffff}'))
        .map(|c| match c {
            '&' => "&amp;".to_owned(),
            '<' => "&lt;".to_owned(),
            '>' => "&gt;".to_owned(),
            '"' => "&quot;".to_owned(),
            c => c.to_string(),
        })
        .collect()
}

/// Markup of labels: `*p*` italic, `_{h}` subscript, `^{3}` superscript.
fn spans(text: &str, size: f64) -> String {
    let mut out = String::new();
    let mut italic = false;
    // Vertical shift still to be undone, px
    let mut shift = 0.0;
    let mut chars = text.chars().peekable();
    let mut plain = String::new();
    fn flush(out: &mut String, plain: &mut String, italic: bool, shift: &mut f64) {
        if plain.is_empty() {
            return;
        }
        // Some renderers drop blanks at the ends of spans: these stay.
        if plain.starts_with(' ') {
            plain.replace_range(..1, "\u{a0}");
        }
        if plain.ends_with(' ') {
            plain.truncate(plain.len() - 1);
            plain.push('\u{a0}');
        }
        let style = if italic { " font-style=\"italic\"" } else { "" };
        let dy = if *shift == 0.0 {
            String::new()
        } else {
            format!(" dy=\"{}\"", number(-*shift))
        };
        if style.is_empty() && dy.is_empty() {
            out.push_str(&escape(plain));
        } else {
            let _ = write!(out, "<tspan{style}{dy}>{}</tspan>", escape(plain));
        }
        *shift = 0.0;
        plain.clear();
    }
    while let Some(c) = chars.next() {
        match c {
            '*' => {
                flush(&mut out, &mut plain, italic, &mut shift);
                italic = !italic;
            }
            '_' | '^' if chars.peek() == Some(&'{') => {
                flush(&mut out, &mut plain, italic, &mut shift);
                chars.next();
                let script: String = chars.by_ref().take_while(|c| *c != '}').collect();
                let target = if c == '_' { 0.25 * size } else { -0.38 * size };
                let _ = write!(
                    out,
                    "<tspan font-size=\"{}\" dy=\"{}\">{}</tspan>",
                    number(0.75 * size),
                    number(target - shift),
                    escape(&script)
                );
                shift = target;
            }
            c => plain.push(c),
        }
    }
    flush(&mut out, &mut plain, italic, &mut shift);
    out
}

/// Rough width of a label in px, markup left out.
pub(super) fn text_width(text: &str, size: f64) -> f64 {
    let n = text.chars().filter(|c| !"*_^{}".contains(*c)).count();
    0.54 * size * n as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn markup_becomes_spans_and_returns_to_the_baseline() {
        assert_eq!(
            spans("*p*_{h} (GPa)", 10.0),
            "<tspan font-style=\"italic\">p</tspan><tspan font-size=\"7.5\" dy=\"2.5\">h</tspan>\
             <tspan dy=\"-2.5\">\u{a0}(GPa)</tspan>"
        );
    }

    #[test]
    fn text_of_users_cannot_break_the_file() {
        let svg = Svg::new(10.0, 10.0, "a<b & \"c\"\u{1}").finish();
        assert!(svg.contains("<title>a&lt;b &amp; &quot;c&quot;</title>"));
    }

    #[test]
    fn numbers_are_short() {
        assert_eq!(number(1.0), "1");
        assert_eq!(number(-0.001), "0");
        assert_eq!(number(12.345), "12.35");
        assert_eq!(number(100.0), "100");
    }
}
