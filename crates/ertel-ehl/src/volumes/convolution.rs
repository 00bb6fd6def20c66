//! Convolution of nodal values of a grid with influence coefficients, by fast Fourier transforms.
//!
//! ```text
//!   u_i = Σ_j K_{i−j} v_j         K_{i−j}: from a unit over the cell of node j to node i
//! ```
//! Pressures and deflections ([`super::deflection`]), where K is even and its transform real; heat and temperatures ([`super::heat`]), where it is complex.

use std::ops::MulAssign;
use std::sync::Mutex;

use realfft::num_complex::Complex64;

use super::padded::{Padded, Room};

/// The convolution of a grid.
pub struct Convolution<F> {
    transforms: Padded,
    /// Transform of K over the gain of the transforms, a line across for each wave along the rows.
    symbol: Vec<F>,
    /// Work space, reused: as much memory as all other vectors of a grid together.
    room: Mutex<Room>,
}

impl<F> Convolution<F> {
    /// With the transform of K, over the gain of the transforms.
    pub fn new(transforms: Padded, symbol: Vec<F>) -> Convolution<F> {
        Convolution {
            transforms,
            symbol,
            room: Mutex::default(),
        }
    }

    /// Transforms of the grid.
    pub fn transforms(&self) -> &Padded {
        &self.transforms
    }

    /// Transform of K, over the gain of the transforms.
    pub fn symbol(&self) -> &[F] {
        &self.symbol
    }
}

impl<F: Copy + Sync> Convolution<F>
where
    Complex64: MulAssign<F>,
{
    /// Σ K v at the nodes.
    pub fn apply(&self, values: &[f64]) -> Vec<f64> {
        // Where another thread has it, for this time.
        let mut own = Room::default();
        let mut kept = self.room.try_lock();
        let room = kept.as_deref_mut().unwrap_or(&mut own);
        self.transforms.convolved(values, &self.symbol, room)
    }
}
