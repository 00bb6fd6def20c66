//! Pictures as SVG files.

use std::fmt::Write;

use super::drawing::{Anchor, Drawing, Element, Line, number};
use super::font::{Style, runs};

const FONT: &str = "Helvetica, Arial, 'Liberation Sans', 'DejaVu Sans', sans-serif";

impl Drawing {
    /// As an SVG file.
    pub fn svg(&self) -> String {
        write(self)
    }
}

/// The file of a picture.
fn write(drawing: &Drawing) -> String {
    let mut body = String::new();
    let mut n_clips = 0;
    for element in &drawing.elements {
        let line = match element {
            Element::Stroke(d, line) => format!(
                "<path d=\"{d}\" fill=\"none\"{} stroke-linejoin=\"round\"/>",
                outline(line)
            ),
            Element::Fill(d, colour) => {
                format!("<path d=\"{d}\" fill=\"{colour}\" fill-rule=\"evenodd\"/>")
            }
            Element::Rectangle(place, colour) => {
                format!("<rect{} fill=\"{colour}\"/>", rectangle(*place))
            }
            Element::Image(place, raster) => format!(
                "<image{} preserveAspectRatio=\"none\" href=\"data:image/png;base64,{}\"/>",
                rectangle(*place),
                raster.png
            ),
            Element::Circle([x, y], radius, fill, line) => format!(
                "<circle cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"{fill}\"{}/>",
                number(*x),
                number(*y),
                number(*radius),
                outline(line)
            ),
            Element::Ellipse([x, y], [rx, ry], turn, line) => {
                let (x, y) = (number(*x), number(*y));
                format!(
                    "<ellipse cx=\"{x}\" cy=\"{y}\" rx=\"{}\" ry=\"{}\" transform=\"rotate({} {x} {y})\" fill=\"none\"{}/>",
                    number(*rx),
                    number(*ry),
                    number(*turn),
                    outline(line)
                )
            }
            Element::Text(text) => {
                let (x, y) = (number(text.at[0]), number(text.at[1]));
                let anchor = match text.anchor {
                    Anchor::Start => "start",
                    Anchor::Middle => "middle",
                    Anchor::End => "end",
                };
                let transform = match text.turn {
                    0.0 => String::new(),
                    turn => format!(" transform=\"rotate({} {x} {y})\"", number(turn)),
                };
                let spans = spans(&text.text, text.size);
                // Some renderers drop blanks at the ends of spans, and even those that do not break.
                let space = match spans.contains("<tspan") {
                    true => " xml:space=\"preserve\"",
                    false => "",
                };
                format!(
                    "<text x=\"{x}\" y=\"{y}\" font-size=\"{}\" text-anchor=\"{anchor}\" fill=\"{}\"{transform}{space}>{spans}</text>",
                    number(text.size),
                    text.colour,
                )
            }
            Element::BeginClip(place) => {
                n_clips += 1;
                format!(
                    "<clipPath id=\"c{n_clips}\"><rect{}/></clipPath>\n<g clip-path=\"url(#c{n_clips})\">",
                    rectangle(*place)
                )
            }
            Element::EndClip => "</g>".to_owned(),
        };
        body += &line;
        body.push('\n');
    }
    let (w, h) = (number(drawing.width), number(drawing.height));
    let title = escape(&drawing.title);
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{w}\" height=\"{h}\" viewBox=\"0 0 {w} {h}\" font-family=\"{FONT}\">\n\
         <title>{title}</title>\n<rect width=\"{w}\" height=\"{h}\" fill=\"white\"/>\n{body}</svg>\n"
    )
}

fn outline(line: &Line) -> String {
    let dash = line.dash.map_or(String::new(), |[dash, gap]| {
        format!(" stroke-dasharray=\"{} {}\"", number(dash), number(gap))
    });
    let width = number(line.width);
    format!(" stroke=\"{}\" stroke-width=\"{width}\"{dash}", line.colour)
}

fn rectangle([x, y, width, height]: [f64; 4]) -> String {
    format!(
        " x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"",
        number(x),
        number(y),
        number(width),
        number(height)
    )
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

/// A label as spans of one style each.
fn spans(text: &str, size: f64) -> String {
    let mut out = String::new();
    let mut shift = 0.0;
    for run in runs(text, size) {
        let mut style = String::new();
        if run.style == Style::Italic {
            style += " font-style=\"italic\"";
        }
        if run.size != size {
            let _ = write!(style, " font-size=\"{}\"", number(run.size));
        }
        if run.shift != shift {
            let _ = write!(style, " dy=\"{}\"", number(run.shift - shift));
            shift = run.shift;
        }
        let text = escape(&run.text);
        match style.is_empty() {
            true => out += &text,
            false => {
                let _ = write!(out, "<tspan{style}>{text}</tspan>");
            }
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn markup_becomes_spans_and_returns_to_the_baseline() {
        assert_eq!(
            spans("*p*_{h} (GPa)", 10.0),
            "<tspan font-style=\"italic\">p</tspan><tspan font-size=\"7.5\" dy=\"2.5\">h</tspan>\
             <tspan dy=\"-2.5\"> (GPa)</tspan>"
        );
    }

    /// Blanks between spans count, in renderers that drop them otherwise.
    #[test]
    fn blanks_at_the_ends_of_spans_are_kept() {
        let mut drawing = Drawing::new(10.0, 10.0, "");
        let label = "Film thickness *h*_{c} (nm)";
        drawing.text([0.0; 2], label, 12.0, Anchor::Start, "#000000");
        let svg = drawing.svg();
        assert!(
            svg.contains(" xml:space=\"preserve\">Film thickness <tspan"),
            "{svg}"
        );
        assert!(svg.contains("> (nm)</tspan>"), "{svg}");
    }

    #[test]
    fn text_of_users_cannot_break_the_file() {
        let svg = Drawing::new(10.0, 10.0, "a<b & \"c\"\u{1}").svg();
        assert!(svg.contains("<title>a&lt;b &amp; &quot;c&quot;</title>"));
    }
}
