//! Pictures as vector drawings: charts with axes, legends and error bars, contours of fields; as SVG, PNG and PDF with embedded fonts.

pub mod axis;
pub mod chart;
pub mod contour;
mod diagram;
pub mod drawing;
mod font;
pub mod frame;
pub mod legend;
mod path;
mod pdf;
pub mod png;
pub mod polar;
mod simplify;
mod svg;

pub use axis::{Axis, AxisScale};
pub use chart::{Chart, ErrorBars, Look, Marker, PALETTE, Series};
pub use diagram::side_by_side;
pub use drawing::{Drawing, DrawingError};
pub use frame::Side;
pub use polar::{Polar, polar_row};
