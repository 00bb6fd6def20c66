//! Oil and asperities at a node between rough surfaces.
//!
//! ```text
//!   P = p + p_a(H),   g = g(H)                 p: P of the oil, g: the gap that flows
//!   δp = δP − p_a' δH + r,   δg = g' δH        r = P − p_a(H) − p, zero at a solution
//! ```
//! p is a variable of Newton's method like P, tied to it by a linearised equation: it stays positive however steep p_a is. Where the film has
//! cavitated p = 0, and the asperities bear all of P.
//!
//! Theory: Mixed lubrication.

use rayon::prelude::*;

use super::grid::Grid;
use crate::mixed::Rough;

/// Nodes that a thread takes at a time.
const BATCH: usize = 1024;

/// Asperities at a node: their pressure, and the gap that they leave.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Touch {
    /// p_a and its derivative by H.
    pub pressure: [f64; 2],
    /// g and its derivative by H.
    pub gap: [f64; 2],
    /// ln of the flow that pressure drives over that through g, along the motion and across it, each with its derivative by g.
    pub ln_passage: [[f64; 2]; 2],
    /// r.
    pub slack: f64,
}

impl Touch {
    /// At the distance H where oil and asperities together bear the first pressure, the oil the second.
    fn new(rough: &Rough, film: f64, [all, oil]: [f64; 2]) -> Touch {
        let pressure = rough.pressure(film);
        Touch {
            pressure,
            slack: all - pressure[0] - oil,
            ..Touch::given(rough, film)
        }
    }

    /// Where the pressure is given, and with it its parts.
    fn given(rough: &Rough, film: f64) -> Touch {
        Touch {
            gap: rough.gap(film),
            ln_passage: rough.ln_passage(film),
            ..Touch::default()
        }
    }

    /// δp without r.
    #[inline]
    pub fn change_of_oil(&self, pressure: f64, film: f64) -> f64 {
        pressure - self.pressure[1] * film
    }
}

/// Asperities at all nodes; none between smooth surfaces. `all` are the pressures of oil and asperities together.
pub fn touching(
    rough: Option<&Rough>,
    grid: &Grid,
    [all, oil]: [&[f64]; 2],
    films: &[f64],
) -> Vec<Touch> {
    let Some(rough) = rough else {
        return Vec::new();
    };
    let [nx, _] = grid.n;
    let of_node = |k: usize| match grid.is_unknown(k % nx, k / nx) {
        true => Touch::new(rough, films[k], [all[k], oil[k]]),
        false => Touch::given(rough, films[k]),
    };
    let nodes = (0..films.len()).into_par_iter().with_min_len(BATCH);
    nodes.map(of_node).collect()
}

/// Changes of the pressures of the oil and of the gaps that flow by those of P and H; `None` between smooth surfaces, where they are these.
pub fn parts(touching: &[Touch], pressure: &[f64], film: &[f64]) -> Option<[Vec<f64>; 2]> {
    if touching.is_empty() {
        return None;
    }
    let both = || touching.iter().zip(pressure.iter().zip(film));
    Some([
        both()
            .map(|(of, (p, h))| of.change_of_oil(*p, *h))
            .collect(),
        both().map(|(of, (_, h))| of.gap[1] * h).collect(),
    ])
}
