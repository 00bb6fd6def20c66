//! A figure of contacts over their places, linear between them.

use crate::solution::Estimate;

/// Values with their bars at ascending places.
pub(super) struct Curve(Vec<(f64, Estimate)>);

impl Curve {
    /// `None` without a value.
    pub fn new(points: Vec<(f64, Estimate)>) -> Option<Curve> {
        (!points.is_empty()).then_some(Curve(points))
    }

    /// Whether all values have bars.
    pub fn has_bars(&self) -> bool {
        self.0.iter().all(|(_, value)| value.error.is_some())
    }

    /// The value at a place; beyond the ends that of the end.
    pub fn at(&self, place: f64) -> f64 {
        self.interpolate(place, |value| value.value)
    }

    /// The bar there; zero where there is none.
    pub fn bar_at(&self, place: f64) -> f64 {
        self.interpolate(place, |value| value.error.unwrap_or(0.0))
    }

    /// The same through every second place, the first and the last among them, and through those between with both ends: by how much a sum over them differs
    /// tells what the distance of the places does to it. `None` of fewer than three.
    pub fn halves(&self) -> Option<[Curve; 2]> {
        let last = self.0.len().checked_sub(1).filter(|last| *last >= 2)?;
        let half = |odd: usize| {
            let own = self.0.iter().enumerate();
            let own = own.filter(|(i, _)| i % 2 == odd || *i == 0 || *i == last);
            Curve(own.map(|(_, point)| *point).collect())
        };
        Some([half(0), half(1)])
    }

    fn interpolate(&self, place: f64, of: impl Fn(&Estimate) -> f64) -> f64 {
        let points = &self.0;
        let after = points.partition_point(|(at, _)| *at <= place);
        if after == 0 {
            return of(&points[0].1);
        }
        if after == points.len() {
            return of(&points[after - 1].1);
        }
        let ((from, a), (to, b)) = (&points[after - 1], &points[after]);
        let share = (place - from) / (to - from);
        of(a) * (1.0 - share) + of(b) * share
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn between_and_beyond() {
        let estimate = |value, error| Estimate {
            value,
            error: Some(error),
        };
        let curve = Curve::new(vec![(1.0, estimate(2.0, 0.1)), (3.0, estimate(6.0, 0.3))]);
        let curve = curve.expect("two points");
        assert!(curve.has_bars());
        let values = [0.0, 1.0, 1.5, 3.0, 9.0].map(|place| curve.at(place));
        assert_eq!(values, [2.0, 2.0, 3.0, 6.0, 6.0]);
        assert!((curve.bar_at(2.0) - 0.2).abs() < 1e-15);
        assert!(Curve::new(Vec::new()).is_none());
        assert!(curve.halves().is_none());
    }

    /// Of the places 0 to 5 the even ones, and the odd ones with the first.
    #[test]
    fn halves_have_both_ends() {
        let at = |place: usize| {
            (
                place as f64,
                Estimate {
                    value: 1.0,
                    error: None,
                },
            )
        };
        let curve = Curve::new((0..6).map(at).collect()).expect("points");
        let places = curve
            .halves()
            .expect("enough")
            .map(|half| half.0.iter().map(|(at, _)| *at).collect::<Vec<f64>>());
        assert_eq!(places, [vec![0.0, 2.0, 4.0, 5.0], vec![0.0, 1.0, 3.0, 5.0]]);
    }
}
