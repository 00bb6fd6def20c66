//! Lines without the points that make no difference.

/// Points of a line without those closer than `tolerance` to the segment between the neighbours that are kept
/// (Douglas and Peucker 1973). The ends stay.
pub(crate) fn simplify(points: &[[f64; 2]], tolerance: f64) -> Vec<[f64; 2]> {
    let Some(last) = points.len().checked_sub(1) else {
        return Vec::new();
    };
    let mut kept = vec![false; points.len()];
    (kept[0], kept[last]) = (true, true);
    let mut parts = vec![(0, last)];
    while let Some((from, to)) = parts.pop() {
        let farthest = (from + 1..to)
            .map(|i| (distance(points[i], points[from], points[to]), i))
            .max_by(|a, b| a.0.total_cmp(&b.0));
        if let Some((_, i)) = farthest.filter(|(far, _)| *far > tolerance) {
            kept[i] = true;
            parts.extend([(from, i), (i, to)]);
        }
    }
    let kept = points.iter().zip(kept).filter(|(_, kept)| *kept);
    kept.map(|(point, _)| *point).collect()
}

/// Distance of a point from the segment between two others, which may coincide.
fn distance(point: [f64; 2], from: [f64; 2], to: [f64; 2]) -> f64 {
    let (along, to_point) = (
        [to[0] - from[0], to[1] - from[1]],
        [point[0] - from[0], point[1] - from[1]],
    );
    let length_squared = along[0] * along[0] + along[1] * along[1];
    let share = match length_squared > 0.0 {
        true => (along[0] * to_point[0] + along[1] * to_point[1]) / length_squared,
        false => 0.0,
    };
    let share = share.clamp(0.0, 1.0);
    (to_point[0] - share * along[0]).hypot(to_point[1] - share * along[1])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn straight_lines_keep_their_corners() {
        let line: Vec<[f64; 2]> = (0..=20)
            .map(f64::from)
            .map(|x| [x, (x - 10.0).abs()])
            .collect();
        assert_eq!(
            simplify(&line, 0.05),
            [[0.0, 10.0], [10.0, 0.0], [20.0, 10.0]]
        );
        assert_eq!(simplify(&line[..1], 0.05), line[..1]);
        assert!(simplify(&[], 0.05).is_empty());
    }

    /// A circle of 50 px in 5,000 chords: the chords of 0.05 px of sag are 2√(2·50·0.05) = 4.5 px long.
    #[test]
    fn circle_keeps_its_shape_with_few_points() {
        let circle: Vec<[f64; 2]> = (0..=5000)
            .map(|i| std::f64::consts::TAU * f64::from(i) / 5000.0)
            .map(|t| [50.0 * t.cos(), 50.0 * t.sin()])
            .collect();
        let few = simplify(&circle, 0.05);
        assert!((70..150).contains(&few.len()), "{}", few.len());
        for pair in few.windows(2) {
            let mid = [0, 1].map(|i: usize| 0.5 * (pair[0][i] + pair[1][i]));
            assert!(50.0 - mid[0].hypot(mid[1]) < 0.051);
        }
    }
}
