//! Weights of the nearest nodes in the deflection, row by row.

/// Nine-point stencils, one for all rows or one for each: weights at the centre, along the first and the second direction, and on the diagonals.
#[derive(Clone, Debug, PartialEq)]
pub struct Stencils(Vec<[f64; 4]>);

impl Stencils {
    /// One for each row.
    pub fn of_rows(stencils: Vec<[f64; 4]>) -> Stencils {
        Stencils(stencils)
    }

    /// That of a row.
    #[inline(always)]
    pub fn of(&self, row: usize) -> &[f64; 4] {
        &self.0[row.min(self.0.len() - 1)]
    }
}

impl From<[f64; 4]> for Stencils {
    fn from(stencil: [f64; 4]) -> Stencils {
        Stencils(vec![stencil])
    }
}
