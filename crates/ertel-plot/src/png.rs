//! Pictures as PNG files.

use tiny_skia::{
    FillRule, FilterQuality, IntSize, LineJoin, Mask, Paint, Path, PathBuilder, Pixmap,
    PixmapPaint, Rect, Stroke, StrokeDash, Transform,
};
use ttf_parser::OutlineBuilder;

use super::drawing::{Drawing, DrawingError, Element, Line, Raster, Text, rgb};
use super::path::{self, Step};

/// Pixels per px: 300 dots per inch where a px is 1/96 inch.
const SCALE: f64 = 300.0 / 96.0;
/// The same per metre, as the file says.
const PER_METRE: u32 = 11_811;

impl Drawing {
    /// As a PNG file with 300 dots per inch.
    ///
    /// # Errors
    /// [`DrawingError::Size`] and [`DrawingError::Png`].
    pub fn png(&self) -> Result<Vec<u8>, DrawingError> {
        write(self)
    }
}

/// The file of a picture.
fn write(drawing: &Drawing) -> Result<Vec<u8>, DrawingError> {
    let (width, height) = size(drawing, SCALE);
    let data = pixels(drawing, SCALE, (width, height))?;
    encode(width, height, &data, Some(PER_METRE))
}

/// An animated PNG file (APNG) that shows pictures one after the other again and again, each for so many milliseconds, in pixels of the given number to a px. All have the size of the first one; each is drawn as
/// it comes. Programs that know no animations show the first one.
///
/// # Errors
/// [`DrawingError`] as of a picture; that of a size without pictures.
pub fn animate(
    frames: impl ExactSizeIterator<Item = Result<Drawing, DrawingError>>,
    milliseconds: u16,
    scale: f64,
) -> Result<Vec<u8>, DrawingError> {
    let n = frames.len();
    let mut frames = frames.peekable();
    let (width, height) = match frames.peek() {
        Some(Ok(first)) => size(first, scale),
        _ => (0, 0),
    };
    if let Some(Err(error)) = frames.next_if(Result::is_err) {
        return Err(error);
    }
    let mut bytes = Vec::new();
    let mut encoder = png_image::Encoder::new(&mut bytes, width, height);
    encoder.set_color(png_image::ColorType::Rgb);
    encoder.set_depth(png_image::BitDepth::Eight);
    encoder.set_source_srgb(png_image::SrgbRenderingIntent::Perceptual);
    if n > 1 {
        encoder.set_animated(n as u32, 0)?;
        encoder.set_frame_delay(milliseconds, 1000)?;
    }
    if n == 0 {
        return Err(DrawingError::Size { width, height });
    }
    let mut writer = encoder.write_header()?;
    for drawing in frames {
        writer.write_image_data(&pixels(&drawing?, scale, (width, height))?)?;
    }
    writer.finish()?;
    Ok(bytes)
}

/// Pixels along both sides.
fn size(drawing: &Drawing, scale: f64) -> (u32, u32) {
    let pixels = |length: f64| (scale * length).ceil().clamp(0.0, f64::from(u32::MAX)) as u32;
    (pixels(drawing.width), pixels(drawing.height))
}

/// Pixels of a picture, row by row from the top, red, green and blue.
fn pixels(
    drawing: &Drawing,
    scale: f64,
    (width, height): (u32, u32),
) -> Result<Vec<u8>, DrawingError> {
    let failed = || DrawingError::Size { width, height };
    let mut canvas = Canvas {
        pixmap: Pixmap::new(width, height).ok_or_else(failed)?,
        clip: None,
        scale: Transform::from_scale(scale as f32, scale as f32),
    };
    canvas.pixmap.fill(tiny_skia::Color::WHITE);
    for element in &drawing.elements {
        canvas.draw(element);
    }
    // Nothing shines through the white page: the pixels are opaque.
    let opaque = canvas.pixmap.pixels().iter();
    Ok(opaque
        .flat_map(|p| [p.red(), p.green(), p.blue()])
        .collect())
}

/// A PNG file of pixels, row by row from the top, red, green and blue; with its resolution, dots per metre.
pub fn encode(
    width: u32,
    height: u32,
    pixels: &[u8],
    per_metre: Option<u32>,
) -> Result<Vec<u8>, DrawingError> {
    let mut bytes = Vec::new();
    let mut encoder = png_image::Encoder::new(&mut bytes, width, height);
    encoder.set_color(png_image::ColorType::Rgb);
    encoder.set_depth(png_image::BitDepth::Eight);
    encoder.set_source_srgb(png_image::SrgbRenderingIntent::Perceptual);
    encoder.set_pixel_dims(per_metre.map(|n| png_image::PixelDimensions {
        xppu: n,
        yppu: n,
        unit: png_image::Unit::Meter,
    }));
    let mut writer = encoder.write_header()?;
    writer.write_image_data(pixels)?;
    writer.finish()?;
    Ok(bytes)
}

/// The picture as far as it is drawn.
struct Canvas {
    pixmap: Pixmap,
    clip: Option<Mask>,
    /// From px to pixels.
    scale: Transform,
}

impl Canvas {
    fn draw(&mut self, element: &Element) {
        match element {
            Element::Stroke(d, line) => self.stroke(path_of(d), line),
            Element::Fill(d, colour) => self.fill(path_of(d), colour),
            Element::Rectangle(place, colour) => self.fill(rectangle(*place), colour),
            Element::Image(place, raster) => self.image(*place, raster),
            Element::Circle(at, radius, fill, line) => {
                let path = ellipse(*at, [*radius; 2], 0.0);
                self.fill(path.clone(), fill);
                self.stroke(path, line);
            }
            Element::Ellipse(at, radii, turn, line) => {
                self.stroke(ellipse(*at, *radii, *turn), line);
            }
            Element::Text(text) => self.text(text),
            Element::BeginClip(place) => {
                let mask = Mask::new(self.pixmap.width(), self.pixmap.height());
                let scale = self.scale;
                self.clip = mask.zip(rectangle(*place)).map(|(mut mask, path)| {
                    mask.fill_path(&path, FillRule::Winding, true, scale);
                    mask
                });
            }
            Element::EndClip => self.clip = None,
        }
    }

    fn stroke(&mut self, path: Option<Path>, line: &Line) {
        let stroke = Stroke {
            width: line.width as f32,
            line_join: LineJoin::Round,
            dash: line
                .dash
                .and_then(|dash| StrokeDash::new(dash.map(|v| v as f32).to_vec(), 0.0)),
            ..Stroke::default()
        };
        if let Some(path) = path {
            let paint = paint(&line.colour);
            self.pixmap
                .stroke_path(&path, &paint, &stroke, self.scale, self.clip.as_ref());
        }
    }

    fn fill(&mut self, path: Option<Path>, colour: &str) {
        if let Some(path) = path {
            let paint = paint(colour);
            self.pixmap.fill_path(
                &path,
                &paint,
                FillRule::EvenOdd,
                self.scale,
                self.clip.as_ref(),
            );
        }
    }

    fn image(&mut self, [x, y, width, height]: [f64; 4], raster: &Raster) {
        let opaque = raster.pixels.chunks_exact(3);
        let data = opaque.flat_map(|p| [p[0], p[1], p[2], 255]).collect();
        let size = IntSize::from_wh(raster.width as u32, raster.height as u32);
        let Some(image) = size.and_then(|size| Pixmap::from_vec(data, size)) else {
            return;
        };
        let [sx, sy] = [width / raster.width as f64, height / raster.height as f64];
        let place = Transform::from_row(sx as f32, 0.0, 0.0, sy as f32, x as f32, y as f32);
        let paint = PixmapPaint {
            quality: FilterQuality::Bilinear,
            ..PixmapPaint::default()
        };
        let place = place.post_concat(self.scale);
        self.pixmap
            .draw_pixmap(0, 0, image.as_ref(), &paint, place, self.clip.as_ref());
    }

    fn text(&mut self, text: &Text) {
        let (runs, mut along) = text.runs();
        let mut outline = Outline {
            path: PathBuilder::new(),
            origin: [0.0; 2],
            scale: 1.0,
        };
        for run in &runs {
            for c in run.text.chars() {
                let (glyph, advance) = run.style.glyph(c);
                if let Some(face) = run.style.face() {
                    outline.origin = [along, run.shift];
                    outline.scale = run.size / f64::from(face.units_per_em());
                    face.outline_glyph(glyph, &mut outline);
                }
                along += run.size * advance;
            }
        }
        let Some(path) = outline.path.finish() else {
            return;
        };
        let [x, y] = text.at.map(|v| v as f32);
        let place = Transform::from_rotate(text.turn as f32).post_translate(x, y);
        let place = place.post_concat(self.scale);
        let paint = paint(&text.colour);
        self.pixmap
            .fill_path(&path, &paint, FillRule::Winding, place, self.clip.as_ref());
    }
}

/// Outlines of glyphs, y upwards, as a path with y downwards.
struct Outline {
    path: PathBuilder,
    /// Position of the glyph, px.
    origin: [f64; 2],
    /// px per unit of the font.
    scale: f64,
}

impl Outline {
    fn place(&self, x: f32, y: f32) -> [f32; 2] {
        [
            (self.origin[0] + self.scale * f64::from(x)) as f32,
            (self.origin[1] - self.scale * f64::from(y)) as f32,
        ]
    }
}

impl OutlineBuilder for Outline {
    fn move_to(&mut self, x: f32, y: f32) {
        let [x, y] = self.place(x, y);
        self.path.move_to(x, y);
    }

    fn line_to(&mut self, x: f32, y: f32) {
        let [x, y] = self.place(x, y);
        self.path.line_to(x, y);
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        let ([x1, y1], [x, y]) = (self.place(x1, y1), self.place(x, y));
        self.path.quad_to(x1, y1, x, y);
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        let ([x1, y1], [x2, y2]) = (self.place(x1, y1), self.place(x2, y2));
        let [x, y] = self.place(x, y);
        self.path.cubic_to(x1, y1, x2, y2, x, y);
    }

    fn close(&mut self) {
        self.path.close();
    }
}

fn paint(colour: &str) -> Paint<'static> {
    let [r, g, b] = rgb(colour);
    let mut paint = Paint::default();
    paint.set_color_rgba8(r, g, b, 255);
    paint.anti_alias = true;
    paint
}

fn path_of(d: &str) -> Option<Path> {
    let mut path = PathBuilder::new();
    for step in path::steps(d) {
        match step {
            Step::Move([x, y]) => path.move_to(x as f32, y as f32),
            Step::Line([x, y]) => path.line_to(x as f32, y as f32),
            Step::Close => path.close(),
        }
    }
    path.finish()
}

fn rectangle([x, y, width, height]: [f64; 4]) -> Option<Path> {
    let rect = Rect::from_xywh(x as f32, y as f32, width as f32, height as f32)?;
    Some(PathBuilder::from_rect(rect))
}

fn ellipse(at: [f64; 2], radii: [f64; 2], turn: f64) -> Option<Path> {
    let ([x, y], curves) = path::ellipse(at, radii, turn);
    let mut path = PathBuilder::new();
    path.move_to(x as f32, y as f32);
    for curve in curves {
        let [[x1, y1], [x2, y2], [x, y]] = curve.map(|p| p.map(|v| v as f32));
        path.cubic_to(x1, y1, x2, y2, x, y);
    }
    path.close();
    path.finish()
}

#[cfg(test)]
mod tests {
    use super::super::drawing;
    use super::*;

    /// Two pictures of one size: the decoder finds two frames with their colours and their time, again and again.
    #[test]
    fn an_animation_is_read_back() {
        let frame = |colour: &str| {
            let mut drawing = Drawing::new(20.0, 10.0, "T");
            drawing.rectangle(0.0, 0.0, 20.0, 10.0, colour);
            Ok(drawing)
        };
        let frames = ["#ff0000", "#0000ff"].map(frame).into_iter();
        let bytes = animate(frames, 250, 2.0).unwrap();
        let decoder = png_image::Decoder::new(std::io::Cursor::new(bytes));
        let mut reader = decoder.read_info().unwrap();
        let control = *reader.info().animation_control().unwrap();
        assert_eq!((control.num_frames, control.num_plays), (2, 0));
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        for expected in [[255, 0, 0], [0, 0, 255]] {
            reader.next_frame(&mut pixels).unwrap();
            let frame = reader.info().frame_control().unwrap();
            assert_eq!((frame.width, frame.height), (40, 20));
            assert_eq!((frame.delay_num, frame.delay_den), (250, 1000));
            assert_eq!(pixels[3 * 410..3 * 411], expected);
        }
        assert!(animate(std::iter::empty(), 250, 2.0).is_err());
    }

    /// A red square in a clip, a circle and text: read back by the decoder, with the colours where they belong.
    #[test]
    fn a_picture_is_read_back() {
        let mut drawing = Drawing::new(96.0, 48.0, "T");
        drawing.begin_clip(8.0, 8.0, 16.0, 16.0);
        drawing.rectangle(0.0, 0.0, 40.0, 40.0, "#ff0000");
        drawing.end_clip();
        drawing.circle(
            60.0,
            16.0,
            6.0,
            "#0000ff",
            drawing::Stroke::solid("#0000ff", 1.0),
        );
        let ink = drawing::INK;
        drawing.text([48.0, 44.0], "*h* (nm)", 12.0, drawing::Anchor::Middle, ink);
        let bytes = drawing.png().unwrap();
        let decoder = png_image::Decoder::new(std::io::Cursor::new(bytes));
        let mut reader = decoder.read_info().unwrap();
        let info = reader.info();
        assert_eq!((info.width, info.height), (300, 150));
        assert_eq!(info.pixel_dims.unwrap().xppu, 11_811);
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        reader.next_frame(&mut pixels).unwrap();
        let at = |x: f64, y: f64| {
            let i = 3 * ((SCALE * y) as usize * 300 + (SCALE * x) as usize);
            [pixels[i], pixels[i + 1], pixels[i + 2]]
        };
        assert_eq!(at(16.0, 16.0), [255, 0, 0]);
        assert_eq!(at(30.0, 16.0), [255; 3]);
        assert_eq!(at(60.0, 16.0), [0, 0, 255]);
        let is_ink = |p: &[u8]| p.iter().all(|v| *v < 80);
        // Letters are above their baseline at 44.
        let rows = |from: f64, to: f64| {
            let row = |y: f64| 3 * 300 * (SCALE * y) as usize;
            pixels[row(from)..row(to)].chunks_exact(3).any(is_ink)
        };
        assert!(rows(36.0, 40.0) && !rows(24.0, 33.0));
    }
}
