//! PNG from SVG; needs the cargo feature `png`.

/// Why there is no PNG.
#[derive(Debug, thiserror::Error)]
pub enum PngError {
    /// The program was built without the feature.
    #[error(
        "this build writes SVG only. For PNG pictures, build with `--features png`, or convert the \
         SVG files with a program such as rsvg-convert or Inkscape"
    )]
    NotBuilt,
    /// The conversion failed.
    #[error("cannot convert a picture to PNG: {0}")]
    Conversion(String),
}

/// Whether this build can write PNG; call it before a long solve.
///
/// # Errors
/// [`PngError::NotBuilt`], with advice, without the feature `png`.
pub fn check() -> Result<(), PngError> {
    if cfg!(feature = "png") {
        Ok(())
    } else {
        Err(PngError::NotBuilt)
    }
}

/// PNG file of an SVG picture, `scale` pixels per SVG unit.
///
/// # Errors
/// [`PngError::NotBuilt`] without the feature `png`; [`PngError::Conversion`] where the renderer
/// refuses.
#[cfg(not(feature = "png"))]
pub fn from_svg(_svg: &str, _scale: f32) -> Result<Vec<u8>, PngError> {
    Err(PngError::NotBuilt)
}

/// PNG file of an SVG picture, `scale` pixels per SVG unit.
///
/// # Errors
/// [`PngError::NotBuilt`] without the feature `png`; [`PngError::Conversion`] where the renderer
/// refuses.
#[cfg(feature = "png")]
pub fn from_svg(svg: &str, scale: f32) -> Result<Vec<u8>, PngError> {
    use resvg::{tiny_skia, usvg};

    let failed = |e: &dyn std::fmt::Display| PngError::Conversion(e.to_string());
    let mut options = usvg::Options::default();
    options.fontdb_mut().load_system_fonts();
    let tree = usvg::Tree::from_str(svg, &options).map_err(|e| failed(&e))?;
    let size = tree.size();
    let pixels = |length: f32| (scale * length).ceil() as u32;
    let mut image = tiny_skia::Pixmap::new(pixels(size.width()), pixels(size.height()))
        .ok_or_else(|| failed(&"the picture has no size"))?;
    let transform = tiny_skia::Transform::from_scale(scale, scale);
    resvg::render(&tree, transform, &mut image.as_mut());
    image.encode_png().map_err(|e| failed(&e))
}
