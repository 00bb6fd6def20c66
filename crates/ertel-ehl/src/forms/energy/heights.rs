//! Heights across the film at which it is heated.

use crate::film::{FilmNodes, MOST_NODES, Nodal};

/// Heights at which the film is heated: Gauss points, and the shape functions of the film's nodes there.
#[derive(Clone, Debug)]
pub struct Heights {
    /// The points, as nodes.
    pub(super) points: FilmNodes,
    /// Shape functions of the film's nodes at each height.
    pub shapes: Vec<Nodal>,
    /// Their first and second derivatives by s.
    pub slopes: Vec<[Nodal; 2]>,
    /// ∫_{−½}^{s_k} of the shape function of each height.
    pub(super) below: Vec<Nodal>,
}

impl Heights {
    /// Heights for the nodes of a film.
    pub fn new(nodes: &FilmNodes) -> Heights {
        let points = FilmNodes::gauss((nodes.n() + 3).min(MOST_NODES));
        let unit = |l: usize| -> Nodal { std::array::from_fn(|k| f64::from(u8::from(k == l))) };
        let above: Vec<_> = (0..points.n()).map(|l| points.above(&unit(l))).collect();
        let below = |s: &f64| -> Nodal {
            let mut below = [0.0; MOST_NODES];
            for (l, above) in above.iter().enumerate() {
                below[l] = points.weights()[l] - above.at(*s);
            }
            below
        };
        Heights {
            shapes: points
                .points()
                .iter()
                .map(|s| nodes.shapes_at(*s))
                .collect(),
            slopes: points
                .points()
                .iter()
                .map(|s| nodes.slopes_at(*s))
                .collect(),
            below: points.points().iter().map(below).collect(),
            points,
        }
    }

    /// Number of heights.
    pub fn n(&self) -> usize {
        self.points.n()
    }

    /// s of each height.
    pub fn points(&self) -> &[f64] {
        self.points.points()
    }

    /// Of each height, the weights of the integral from −½ to it.
    pub fn below(&self) -> &[Nodal] {
        &self.below
    }

    /// Weights of the integral over s.
    pub fn weights(&self) -> &[f64] {
        self.points.weights()
    }
}
