//! A figure of contacts over their places, linear between them, and the effect of the distance of the places on its extremes.

use crate::mark::{Marked, Marks};

/// Values with their bars at ascending places.
pub(super) struct Curve(Vec<(f64, Marked)>);

impl Curve {
    /// `None` without a value.
    pub fn new(points: Vec<(f64, Marked)>) -> Option<Curve> {
        (!points.is_empty()).then_some(Curve(points))
    }

    /// Whether all values have bars.
    pub fn has_bars(&self) -> bool {
        self.0.iter().all(|(_, value)| value.error.is_some())
    }

    /// The marks of all values, which apply to all that is derived from the curve.
    pub fn marks(&self) -> Marks {
        self.0.iter().map(|(_, value)| value.marks).sum()
    }

    /// The value at a place; beyond the ends that of the end.
    pub fn at(&self, place: f64) -> f64 {
        self.interpolate(place, |value| value.value)
    }

    /// The bar there; zero where there is none.
    pub fn bar_at(&self, place: f64) -> f64 {
        self.interpolate(place, |value| value.error.unwrap_or(0.0))
    }

    /// The same through every second place, the first and the last among them, and through those between with both ends: the difference of a sum over them
    /// shows the effect of the distance of the places. `None` for fewer than three.
    pub fn halves(&self) -> Option<[Curve; 2]> {
        let last = self.0.len().checked_sub(1).filter(|last| *last >= 2)?;
        let half = |odd: usize| {
            let own = self.0.iter().enumerate();
            let own = own.filter(|(i, _)| i % 2 == odd || *i == 0 || *i == last);
            Curve(own.map(|(_, point)| *point).collect())
        };
        Some([half(0), half(1)])
    }

    /// The smallest value and its index; its bar allows for what lies between the places.
    pub fn smallest(&self) -> (usize, Marked) {
        self.lowest(1.0)
    }

    /// The largest value, likewise.
    pub fn largest(&self) -> (usize, Marked) {
        self.lowest(-1.0)
    }

    /// The lowest of the values times `sign`.
    ///
    /// Parabolas through it and its neighbours, and through those after next, have a vertex below it: the bar covers the first one, plus the distance between
    /// both.
    fn lowest(&self, sign: f64) -> (usize, Marked) {
        let value = |i: usize| sign * self.0[i].1.value;
        let i = (0..self.0.len())
            .reduce(|best, i| if value(i) < value(best) { i } else { best })
            .unwrap_or(0);
        let near = self.below(i, 1, value);
        let far = self.below(i, 2, value).or(near);
        let between = near.zip(far);
        let between = between.map_or(0.0, |(near, far)| near + (near - far).abs());
        (i, self.0[i].1.wider(between))
    }

    /// How far below the value at `i` the vertex of the parabola lies that goes through it and through the values `step` places before and behind. `None`
    /// at an end, where the extreme is on its place, and where two values stand at one place.
    fn below(&self, i: usize, step: usize, value: impl Fn(usize) -> f64) -> Option<f64> {
        let (before, behind) = (i.checked_sub(step)?, i + step);
        let (from, to) = (self.0.get(before)?.0, self.0.get(behind)?.0);
        let [left, right] = [self.0[i].0 - from, to - self.0[i].0];
        if left <= 0.0 || right <= 0.0 {
            return None;
        }
        // y = slope x + curvature x² from the middle point on
        let [one, two] = [value(before) - value(i), value(behind) - value(i)];
        let curvature = (one / left + two / right) / (left + right);
        let slope = two / right - curvature * right;
        Some(match curvature > 0.0 {
            true => slope * slope / (4.0 * curvature),
            false => 0.0,
        })
    }

    fn interpolate(&self, place: f64, of: impl Fn(&Marked) -> f64) -> f64 {
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
    use crate::mark::Mark;

    fn number(value: f64, error: f64) -> Marked {
        Marked {
            error: Some(error),
            ..Marked::exact(value)
        }
    }

    #[test]
    fn between_and_beyond() {
        let doubted = number(6.0, 0.3).with(Marks::when(true, Mark::Friction));
        let curve = Curve::new(vec![(1.0, number(2.0, 0.1)), (3.0, doubted)]);
        let curve = curve.expect("two points");
        assert!(curve.has_bars() && curve.marks().has(Mark::Friction));
        let values = [0.0, 1.0, 1.5, 3.0, 9.0].map(|place| curve.at(place));
        assert_eq!(values, [2.0, 2.0, 3.0, 6.0, 6.0]);
        assert!((curve.bar_at(2.0) - 0.2).abs() < 1e-15);
        assert!(Curve::new(Vec::new()).is_none());
        assert!(curve.halves().is_none());
    }

    /// Of the places 0 to 5 the even ones, and the odd ones with the first.
    #[test]
    fn halves_have_both_ends() {
        let at = |place: usize| (place as f64, Marked::exact(1.0));
        let curve = Curve::new((0..6).map(at).collect()).expect("points");
        let places = curve
            .halves()
            .expect("enough")
            .map(|half| half.0.iter().map(|(at, _)| *at).collect::<Vec<f64>>());
        assert_eq!(places, [vec![0.0, 2.0, 4.0, 5.0], vec![0.0, 1.0, 3.0, 5.0]]);
    }

    /// (x − x_0)² + 1 and its mirror image at places of uneven distance: the parabola finds 1 and -1 exactly. The minimum of 2 - cos(x − x_0), six places to
    /// a turn, is within the bar wherever it lies between the places.
    #[test]
    fn extremes_between_the_places_are_in_the_bar() {
        for top in [0.0, 0.2, 0.31, 0.5, 0.69, 0.9] {
            let curve = |of: &dyn Fn(f64) -> f64| {
                let places = [-3.0, -2.0, -1.0, 0.0, 1.0, 2.1, 3.0, 4.0];
                let points = places.map(|x| (x, number(of(x - top), 0.0)));
                Curve::new(points.into()).expect("points")
            };
            let (i, low) = curve(&|x| x * x + 1.0).smallest();
            let bar = low.error.expect("a bar");
            assert!((low.value - bar - 1.0).abs() < 1e-12, "{top}: {low:?}");
            let (j, high) = curve(&|x| -x * x - 1.0).largest();
            assert_eq!((i, high.value), (j, -low.value));
            let (_, wave) = curve(&|x| 2.0 - x.cos()).smallest();
            let bar = wave.error.expect("a bar");
            assert!(wave.value - bar <= 1.0 + 1e-12, "{top}: {wave:?}");
        }
        // At an end, and where two values stand at one place, the extreme is known.
        for points in [
            vec![(0.0, 1.0), (1.0, 2.0), (2.0, 5.0)],
            vec![(0.0, 2.0), (1.0, 1.0), (1.0, 4.0), (2.0, 5.0)],
        ] {
            let points = points.into_iter().map(|(x, y)| (x, number(y, 0.1)));
            let (_, low) = Curve::new(points.collect()).expect("points").smallest();
            assert_eq!(low.error, Some(0.1));
        }
    }
}
