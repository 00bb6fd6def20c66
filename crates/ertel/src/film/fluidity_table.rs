//! A law of shear thinning in a table.

use std::sync::Arc;

use ertel_rheology::shear::ShearLaw;

use super::fluidity::exact;
use super::quintic::Quintic;

/// Quintic Hermite interpolation of a law in x, on cells that grow with x: [`PER_BINADE`] between each
/// power of two and the next. Twice continuously differentiable.
#[derive(Debug)]
pub(super) struct FluidityTable {
    /// Square of the knee's stress.
    unit: f64,
    /// Interpolants in the local coordinate, and its slope.
    cells: Arc<[(Quintic, f64)]>,
}

/// Cells to each power of two: 2⁵.
const PER_BINADE_LOG2: u32 = 5;
/// Powers of two of the stress's square, over the knee's, between which the table holds.
const LOWEST: i32 = -50;
const HIGHEST: i32 = 50;
/// Bits of a double's mantissa below the cell.
const LOCAL_BITS: u32 = 52 - PER_BINADE_LOG2;

impl FluidityTable {
    pub fn new(law: &ShearLaw, knee: f64) -> FluidityTable {
        let unit = knee * knee;
        let first = 2.0_f64.powi(LOWEST).to_bits() >> LOCAL_BITS;
        let n = ((HIGHEST - LOWEST) as u64) << PER_BINADE_LOG2;
        let node = |i: u64| f64::from_bits((first + i) << LOCAL_BITS);
        let at = |x: f64| {
            let [a, a1, a2] = exact(law, x * unit);
            [a, a1 * unit, a2 * unit * unit]
        };
        let cells = (0..n).map(|i| {
            let (low, high) = (node(i), node(i + 1));
            let w = high - low;
            let end = |x: f64| {
                let [a, a1, a2] = at(x);
                [a, a1 * w, a2 * w * w]
            };
            (Quintic::new(end(low), end(high)), 1.0 / w)
        });
        FluidityTable {
            unit,
            cells: cells.collect(),
        }
    }

    /// The table of the same law at a multiple of all stresses.
    pub fn scaled(&self, factor: f64) -> FluidityTable {
        FluidityTable {
            unit: factor * factor * self.unit,
            cells: Arc::clone(&self.cells),
        }
    }

    /// A and its derivatives at the square of a stress, Pa²; `None` outside the table.
    #[inline(always)]
    pub fn at(&self, square: f64) -> Option<[f64; 3]> {
        let bits = (square / self.unit).to_bits();
        let first = 2.0_f64.powi(LOWEST).to_bits() >> LOCAL_BITS;
        let cell = (bits >> LOCAL_BITS).wrapping_sub(first);
        let (quintic, slope) = self.cells.get(cell as usize)?;
        let local = bits & ((1 << LOCAL_BITS) - 1);
        let t = local as f64 * (1.0 / (1_u64 << LOCAL_BITS) as f64);
        let [value, first, second] = quintic.at(t);
        let scale = slope / self.unit;
        Some([value, first * scale, second * scale * scale])
    }
}
