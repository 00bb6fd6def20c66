//! Pictures as PDF files of one page: lines and areas as such, text that can be searched, with its font.

use std::collections::BTreeMap;

use miniz_oxide::deflate::compress_to_vec_zlib;
use pdf_writer::types::{CidFontType, FontFlags, LineJoinStyle, SystemInfo, UnicodeCmap};
use pdf_writer::{Content, Filter, Finish, Name, Pdf, Rect, Ref, Str, TextStr};
use subsetter::GlyphRemapper;

use super::drawing::{Drawing, DrawingError, Element, Line, Raster, Text, rgb};
use super::font::Style;
use super::path::{self, Step};

/// Points per px, which is 1/96 inch.
const SCALE: f64 = 0.75;
/// Effort of the compression, of 10.
const LEVEL: u8 = 8;
const SYSTEM: SystemInfo = SystemInfo {
    registry: Str(b"Adobe"),
    ordering: Str(b"Identity"),
    supplement: 0,
};

/// Names of the fonts of both styles on the page.
const FONTS: [&[u8]; 2] = [b"F0", b"F1"];

impl Drawing {
    /// As a PDF file of one page of the size of the picture: lines and areas as such, text with its font.
    ///
    /// # Errors
    /// [`DrawingError::Font`].
    pub fn pdf(&self) -> Result<Vec<u8>, DrawingError> {
        write(self)
    }
}

/// The file of a picture.
fn write(drawing: &Drawing) -> Result<Vec<u8>, DrawingError> {
    let mut page = Page {
        content: Content::new(),
        height: drawing.height,
        fonts: [Glyphs::default(), Glyphs::default()],
        images: Vec::new(),
        n_clips: 0,
    };
    let scale = SCALE as f32;
    page.content.save_state();
    // px with y downwards become points with y upwards.
    let foot = (SCALE * drawing.height) as f32;
    page.content.transform([scale, 0.0, 0.0, -scale, 0.0, foot]);
    for element in &drawing.elements {
        page.draw(element);
    }
    for _ in 0..page.n_clips {
        page.content.restore_state();
    }
    page.content.restore_state();
    page.file(drawing)
}

/// Glyphs of a style that the page has: by their number in the font, with the character and the width.
#[derive(Default)]
struct Glyphs {
    remapper: GlyphRemapper,
    used: BTreeMap<u16, (char, f64)>,
}

/// The page as far as it is drawn.
struct Page<'a> {
    content: Content,
    /// px.
    height: f64,
    fonts: [Glyphs; 2],
    images: Vec<&'a Raster>,
    /// Clips that are not closed yet.
    n_clips: usize,
}

impl<'a> Page<'a> {
    fn draw(&mut self, element: &'a Element) {
        match element {
            Element::Stroke(d, line) => {
                self.line(line);
                self.path(d);
                self.content.stroke();
            }
            Element::Fill(d, colour) => {
                self.colour(colour);
                self.path(d);
                self.content.fill_even_odd();
            }
            Element::Rectangle(place, colour) => {
                self.colour(colour);
                let [x, y, width, height] = place.map(short);
                self.content.rect(x, y, width, height).fill_nonzero();
            }
            Element::Image(place, raster) => {
                let [x, y, width, height] = place.map(short);
                let name = format!("I{}", self.images.len());
                self.content.save_state();
                // The unit square of an image has its first row at the top.
                let place = [width, 0.0, 0.0, -height, x, y + height];
                self.content.transform(place);
                self.content.x_object(Name(name.as_bytes()));
                self.content.restore_state();
                self.images.push(raster);
            }
            Element::Circle(at, radius, fill, line) => {
                self.colour(fill);
                self.line(line);
                self.ellipse(*at, [*radius; 2], 0.0);
                self.content.fill_nonzero_and_stroke();
            }
            Element::Ellipse(at, radii, turn, line) => {
                self.line(line);
                self.ellipse(*at, *radii, *turn);
                self.content.stroke();
            }
            Element::Text(text) => self.text(text),
            Element::BeginClip(place) => {
                let [x, y, width, height] = place.map(short);
                self.content.save_state();
                self.content.rect(x, y, width, height);
                self.content.clip_nonzero().end_path();
                self.n_clips += 1;
            }
            Element::EndClip => {
                if self.n_clips > 0 {
                    self.content.restore_state();
                    self.n_clips -= 1;
                }
            }
        }
    }

    fn colour(&mut self, colour: &str) {
        let [r, g, b] = rgb(colour).map(|v| short(f64::from(v) / 255.0));
        self.content.set_fill_rgb(r, g, b);
    }

    fn line(&mut self, line: &Line) {
        let [r, g, b] = rgb(&line.colour).map(|v| short(f64::from(v) / 255.0));
        self.content
            .set_stroke_rgb(r, g, b)
            .set_line_width(short(line.width))
            .set_line_join(LineJoinStyle::RoundJoin);
        let dash = line
            .dash
            .map_or(Vec::new(), |dash| dash.map(short).to_vec());
        self.content.set_dash_pattern(dash, 0.0);
    }

    fn path(&mut self, d: &str) {
        for step in path::steps(d) {
            match step {
                Step::Move([x, y]) => self.content.move_to(short(x), short(y)),
                Step::Line([x, y]) => self.content.line_to(short(x), short(y)),
                Step::Close => self.content.close_path(),
            };
        }
    }

    fn ellipse(&mut self, at: [f64; 2], radii: [f64; 2], turn: f64) {
        let (start, curves) = path::ellipse(at, radii, turn);
        let [x, y] = start.map(short);
        self.content.move_to(x, y);
        for curve in curves {
            let [[x1, y1], [x2, y2], [x, y]] = curve.map(|p| p.map(short));
            self.content.cubic_to(x1, y1, x2, y2, x, y);
        }
        self.content.close_path();
    }

    fn text(&mut self, text: &Text) {
        let (runs, mut along) = text.runs();
        let (s, c) = text.turn.to_radians().sin_cos();
        self.colour(&text.colour);
        self.content.begin_text();
        for run in &runs {
            let mut codes = Vec::new();
            let font = &mut self.fonts[run.style as usize];
            for ch in run.text.chars() {
                let (glyph, width) = run.style.glyph(ch);
                let code = font.remapper.remap(glyph.0);
                font.used.entry(code).or_insert((ch, width));
                codes.extend(code.to_be_bytes());
            }
            let x = text.at[0] + c * along - s * run.shift;
            let y = text.at[1] + s * along + c * run.shift;
            let [c, s] = [c, s].map(|v| v as f32);
            self.content
                .set_font(Name(FONTS[run.style as usize]), short(run.size))
                // Letters are upright with y downwards.
                .set_text_matrix([c, s, s, -c, short(x), short(y)])
                .show(Str(&codes));
            along += run.width();
        }
        self.content.end_text();
    }

    /// The file with all that the page needs.
    fn file(self, drawing: &Drawing) -> Result<Vec<u8>, DrawingError> {
        let mut pdf = Pdf::new();
        let mut last = 0;
        let mut new = || {
            last += 1;
            Ref::new(last)
        };
        let (catalog, pages, page, content, info) = (new(), new(), new(), new(), new());
        pdf.catalog(catalog).pages(pages);
        pdf.pages(pages).kids([page]).count(1);
        let fonts: Vec<(Style, Ref)> = Style::ALL
            .into_iter()
            .filter(|style| !self.fonts[*style as usize].used.is_empty())
            .map(|style| (style, new()))
            .collect();
        let images: Vec<Ref> = self.images.iter().map(|_| new()).collect();
        let size = [drawing.width, self.height].map(|v| (SCALE * v) as f32);
        let mut on_page = pdf.page(page);
        on_page.media_box(Rect::new(0.0, 0.0, size[0], size[1]));
        on_page.parent(pages).contents(content);
        let mut resources = on_page.resources();
        let mut of_fonts = resources.fonts();
        for (style, font) in &fonts {
            of_fonts.pair(Name(FONTS[*style as usize]), *font);
        }
        of_fonts.finish();
        if !images.is_empty() {
            let mut of_images = resources.x_objects();
            for (i, image) in images.iter().enumerate() {
                of_images.pair(Name(format!("I{i}").as_bytes()), *image);
            }
            of_images.finish();
        }
        resources.finish();
        on_page.finish();
        for (raster, id) in self.images.iter().zip(images) {
            let data = compress_to_vec_zlib(&raster.pixels, LEVEL);
            let mut image = pdf.image_xobject(id, &data);
            image.filter(Filter::FlateDecode);
            image.width(raster.width as i32);
            image.height(raster.height as i32);
            image.color_space().device_rgb();
            image.bits_per_component(8);
        }
        for (style, id) in fonts {
            write_font(&mut pdf, style, &self.fonts[style as usize], id, &mut new)?;
        }
        let data = compress_to_vec_zlib(&self.content.finish(), LEVEL);
        pdf.stream(content, &data).filter(Filter::FlateDecode);
        pdf.document_info(info)
            .title(TextStr(&drawing.title))
            .creator(TextStr("ertel"));
        Ok(pdf.finish())
    }
}

/// A font with the glyphs that are used, and their characters.
fn write_font(
    pdf: &mut Pdf,
    style: Style,
    glyphs: &Glyphs,
    id: Ref,
    new: &mut impl FnMut() -> Ref,
) -> Result<(), DrawingError> {
    let failed = |e: &dyn std::fmt::Display| DrawingError::Font(e.to_string());
    let face = style.face().ok_or_else(|| failed(&"it cannot be read"))?;
    let (cid, descriptor, file, unicode) = (new(), new(), new(), new());
    let name: &[u8] = match style {
        Style::Regular => b"ERTELS+ErtelSans-Regular",
        Style::Italic => b"ERTELS+ErtelSans-Italic",
    };
    let name = Name(name);
    pdf.type0_font(id)
        .base_font(name)
        .encoding_predefined(Name(b"Identity-H"))
        .descendant_font(cid)
        .to_unicode(unicode);
    let mut font = pdf.cid_font(cid);
    font.subtype(CidFontType::Type2)
        .base_font(name)
        .system_info(SYSTEM)
        .font_descriptor(descriptor)
        .default_width(0.0)
        .cid_to_gid_map_predefined(Name(b"Identity"));
    let mut widths = font.widths();
    for (code, (_, width)) in &glyphs.used {
        widths.consecutive(*code, [(1000.0 * width) as f32]);
    }
    widths.finish();
    font.finish();
    let em = f32::from(face.units_per_em());
    let part = |v: i16| 1000.0 * f32::from(v) / em;
    let bounds = face.global_bounding_box();
    let [left, bottom, right, top] =
        [bounds.x_min, bounds.y_min, bounds.x_max, bounds.y_max].map(part);
    let (flags, angle) = match style {
        Style::Regular => (FontFlags::SYMBOLIC, 0.0),
        Style::Italic => (FontFlags::SYMBOLIC | FontFlags::ITALIC, -12.0),
    };
    pdf.font_descriptor(descriptor)
        .name(name)
        .flags(flags)
        .bbox(Rect::new(left, bottom, right, top))
        .italic_angle(angle)
        .ascent(part(face.ascender()))
        .descent(part(face.descender()))
        .cap_height(part(face.capital_height().unwrap_or(1409)))
        .stem_v(80.0)
        .font_file2(file);
    let subset = subsetter::subset(style.file(), 0, &glyphs.remapper).map_err(|e| failed(&e))?;
    let data = compress_to_vec_zlib(&subset, LEVEL);
    let mut stream = pdf.stream(file, &data);
    stream.filter(Filter::FlateDecode);
    stream.pair(Name(b"Length1"), subset.len() as i32);
    stream.finish();
    let mut map = UnicodeCmap::new(Name(b"Ertel"), SYSTEM);
    for (code, (ch, _)) in &glyphs.used {
        map.pair(*code, *ch);
    }
    let map = map.finish();
    pdf.cmap(unicode, &map);
    Ok(())
}

/// Hundredths of a px are enough, and short.
fn short(value: f64) -> f32 {
    ((value * 1000.0).round() / 1000.0) as f32
}

#[cfg(test)]
mod tests {
    use super::super::drawing;
    use super::*;

    fn picture() -> Drawing {
        let mut drawing = Drawing::new(400.0, 200.0, "A film");
        let line = drawing::Stroke::solid(drawing::INK, 1.0);
        drawing.begin_clip(10.0, 10.0, 100.0, 100.0);
        drawing.fill("M0 0h50v50h-50Z", "#336699");
        drawing.end_clip();
        drawing.stroke("M0 0L400 200", line);
        drawing.ellipse([200.0, 100.0], [50.0, 20.0], 30.0, line);
        let label = "Film thickness *h*_{c} (µm), λ";
        let ink = drawing::INK;
        drawing.turned_text(
            [20.0, 100.0],
            label,
            13.5,
            drawing::Anchor::Middle,
            ink,
            -90.0,
        );
        drawing
    }

    /// Read back by a library for PDF: one page of the size of the picture, with text to be searched.
    #[test]
    fn a_picture_is_read_back_with_its_text() {
        let bytes = picture().pdf().unwrap();
        let document = lopdf::Document::load_mem(&bytes).unwrap();
        let pages = document.get_pages();
        assert_eq!(pages.len(), 1);
        let page = document.get_dictionary(pages[&1]).unwrap();
        let size = page.get(b"MediaBox").unwrap().as_array().unwrap();
        let size: Vec<f32> = size.iter().map(|v| v.as_float().unwrap()).collect();
        assert_eq!(size, [0.0, 0.0, 300.0, 150.0]);
        assert_eq!(shown(&document), "Film thickness hc (µm), λ");
    }

    /// The text of the page: codes of its content, by the maps to characters of its fonts.
    fn shown(document: &lopdf::Document) -> String {
        let page = document.get_pages()[&1];
        let fonts = document.get_page_fonts(page).unwrap();
        let map = |name: &[u8]| -> BTreeMap<u16, char> {
            let id = fonts[name]
                .get(b"ToUnicode")
                .unwrap()
                .as_reference()
                .unwrap();
            let map = document.get_object(id).unwrap().as_stream().unwrap();
            let text = String::from_utf8_lossy(&map.content).into_owned();
            let pairs = text.lines().filter_map(|line| {
                let (code, ch) = line
                    .strip_prefix('<')?
                    .strip_suffix('>')?
                    .split_once("> <")?;
                let number = |hex| u16::from_str_radix(hex, 16).ok();
                Some((number(code)?, char::from_u32(number(ch)?.into())?))
            });
            pairs.filter(|(code, _)| *code != 0xffff).collect()
        };
        let content = document.get_page_content(page).unwrap();
        let content = lopdf::content::Content::decode(&content).unwrap();
        let (mut text, mut font) = (String::new(), BTreeMap::new());
        for operation in &content.operations {
            match operation.operator.as_str() {
                "Tf" => font = map(operation.operands[0].as_name().unwrap()),
                "Tj" => {
                    let codes = operation.operands[0].as_str().unwrap();
                    let codes = codes
                        .chunks_exact(2)
                        .map(|c| u16::from_be_bytes([c[0], c[1]]));
                    text.extend(codes.map(|code| font[&code]));
                }
                _ => {}
            }
        }
        text
    }

    #[test]
    fn only_the_letters_that_are_used_are_in_the_file() {
        let bytes = picture().pdf().unwrap();
        assert!(
            bytes.starts_with(b"%PDF-") && bytes.len() < 15_000,
            "{}",
            bytes.len()
        );
    }
}
