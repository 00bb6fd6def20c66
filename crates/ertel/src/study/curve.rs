//! A curve: point by point, each from the solution of the previous one.

use ertel_fem::platform::Instant;
use ertel_quantity::Dimension;

use super::machine::cores;
use super::plan::Plan;
use super::point::{Ends, Interrupted, Task};
use super::walk::Walk;
use crate::case::Curve;
use crate::case::curve::Quantity;
use crate::engine::Observer;
use crate::point::PointSolution;
use crate::run::transient::Reached;
use crate::words::digits;

/// Follows the points of a curve.
pub trait CurveObserver: Observer {
    /// The next point begins: its index from 0, how many there are, and the quantity's value with its unit.
    fn point(&mut self, _index: usize, _n_points: usize, _value: &str) {}
    /// A point that is a case in time has come to an instant.
    fn reached(&mut self, _reached: &Reached) {}
    /// A point ended: its index from 0, and what became of it.
    fn finished(&mut self, _index: usize, _point: &PointSolution) {}
}

impl CurveObserver for crate::engine::NoObserver {}

/// Outcome of a curve.
#[derive(Clone, Debug)]
pub struct CurveSolution {
    /// The varied quantity.
    pub quantity: Quantity,
    /// Every point that was begun, in the order of the case file.
    pub points: Vec<PointSolution>,
    /// Points that the curve has.
    pub n_points: usize,
    /// Wall time, s.
    pub wall_seconds: f64,
}

impl CurveSolution {
    /// Points without solution.
    pub fn n_failed(&self) -> usize {
        let failed = |p: &&PointSolution| !p.outcome.is_solved();
        self.points.iter().filter(failed).count()
    }

    /// Whether the user stopped it before the last point.
    pub fn is_partial(&self) -> bool {
        self.points.len() < self.n_points
    }
}

/// Solves the points of a curve in their order, each from the last one that was solved. A point that fails
/// is kept with its reason. When the observer cancels, the points until then are returned. Newtonian and isothermal
/// solutions, where the curve requests them, start from one another, the first one from its own point.
///
/// Fields and iterations of the solutions are kept only where the curve requests folders.
pub fn solve_curve(curve: &Curve, observer: &mut dyn CurveObserver) -> CurveSolution {
    let clock = Instant::now();
    let n_points = curve.points.len();
    let plan = Plan::chain(n_points);
    let mut points = Vec::new();
    let walk = Walk::<Ends>::new(&plan, &vec![true; n_points]);
    // Interrupted or not, what is solved counts.
    let _ = walk.run(|index, from| {
        let point = &curve.points[index];
        let task = Task {
            point,
            place: (index, n_points),
            label: value_text(&curve.quantity, point.value()),
            simpler: [curve.newtonian, curve.isothermal],
            fields: curve.folders,
            workers: cores(),
        };
        let (point, ends) = task.solve(from, observer)?;
        observer.finished(index, &point);
        points.push(point);
        Ok::<_, Interrupted>(ends)
    });
    CurveSolution {
        quantity: curve.quantity,
        points,
        n_points,
        wall_seconds: clock.elapsed().as_secs_f64(),
    }
}

/// A value of what varies with its unit: `0.4 m/s`, `1000 rpm`.
pub fn value_text(quantity: &Quantity, value: f64) -> String {
    let text = match quantity.dimension {
        Dimension::ANGULAR_SPEED => format!("{} rpm", digits(value * RPM, 6)),
        Dimension::TEMPERATURE => format!("{} °C", digits(value - 273.15, 6)),
        _ => format!("{} {}", digits(value, 6), quantity.unit()),
    };
    text.trim_end().to_owned()
}

/// Revolutions per minute of 1 rad/s.
pub(crate) const RPM: f64 = 30.0 / std::f64::consts::PI;
