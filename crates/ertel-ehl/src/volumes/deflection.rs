//! Deflection on a grid: with even rows, with those of a roller, or with the one of a line contact.

use std::sync::Arc;

use super::convolution::Convolution;
use super::grid::Grid;
use super::line_convolution::LineConvolution;
use super::near_stencils::Stencils;
use super::rows_convolution::RowsConvolution;

/// How the bodies deflect under pressures at the nodes.
pub enum Deflection {
    /// Of a regular grid.
    Even(Convolution),
    /// Of a grid with uneven rows.
    Rows(RowsConvolution),
    /// Of the row of a line contact.
    Line(LineConvolution),
}

impl Deflection {
    /// Half-spaces of the compliance C over a grid.
    pub fn new(grid: &Grid, compliance: f64) -> Deflection {
        match &grid.rows {
            None if grid.is_line() => Deflection::Line(LineConvolution::new(grid, compliance)),
            None => Deflection::Even(Convolution::new(grid, compliance)),
            Some(rows) => Deflection::Rows(RowsConvolution::new(grid, rows, compliance)),
        }
    }

    /// At the nodes, under pressures there.
    pub fn apply(&self, pressure: &[f64]) -> Vec<f64> {
        match self {
            Deflection::Even(convolution) => convolution.apply(pressure),
            Deflection::Rows(convolution) => convolution.apply(pressure),
            Deflection::Line(convolution) => convolution.apply(pressure),
        }
    }

    /// Nine-point stencils that are nearest to the inverse.
    pub fn stencils(&self) -> Stencils {
        match self {
            Deflection::Even(convolution) => convolution.inverse().into(),
            Deflection::Rows(convolution) => convolution.stencils(),
            Deflection::Line(convolution) => convolution.inverse().into(),
        }
    }
}

impl From<Convolution> for Arc<Deflection> {
    fn from(convolution: Convolution) -> Arc<Deflection> {
        Arc::new(Deflection::Even(convolution))
    }
}
