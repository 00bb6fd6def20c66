//! Bodies in series: one load, deflections that add up.

use super::{Accuracy, SurfaceResponse, Trace};

/// Several responses to one load.
pub struct Series {
    parts: Vec<Box<dyn SurfaceResponse>>,
}

impl Series {
    /// Joins them.
    ///
    /// # Panics
    /// When there is none.
    pub fn new(parts: Vec<Box<dyn SurfaceResponse>>) -> Series {
        assert!(!parts.is_empty(), "a series of bodies has one at least");
        Series { parts }
    }

    fn sum(&self, part: impl Fn(&dyn SurfaceResponse) -> Vec<f64>) -> Vec<f64> {
        let mut total = part(&*self.parts[0]);
        for other in &self.parts[1..] {
            for (t, v) in total.iter_mut().zip(part(&**other)) {
                *t += v;
            }
        }
        total
    }
}

impl SurfaceResponse for Series {
    fn deflect(&self, trace: &Trace, pressure: &[f64], accuracy: Accuracy) -> Vec<f64> {
        self.sum(|part| part.deflect(trace, pressure, accuracy))
    }

    fn respond(&self, trace: &Trace, loads: &[f64]) -> Vec<f64> {
        self.sum(|part| part.respond(trace, loads))
    }

    /// The first body's, scaled by its share of the compliance: short waves see half-spaces.
    fn near_stiffness(&self) -> Vec<f64> {
        let first = &self.parts[0];
        let share = first.compliance() / self.compliance();
        first
            .near_stiffness()
            .into_iter()
            .map(|s| s * share)
            .collect()
    }

    fn compliance(&self) -> f64 {
        self.parts.iter().map(|part| part.compliance()).sum()
    }

    fn release(&self) {
        self.parts.iter().for_each(|part| part.release());
    }
}
