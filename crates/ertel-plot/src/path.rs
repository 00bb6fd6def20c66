//! Paths in the notation of SVG, read back for the other backends.

/// A step of a path, absolute coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Step {
    Move([f64; 2]),
    Line([f64; 2]),
    Close,
}

/// The steps of a path of the commands that pictures use: M, L, H and V, absolute and relative, and Z.
pub(crate) fn steps(d: &str) -> Vec<Step> {
    let mut steps = Vec::new();
    let (mut at, mut start) = ([0.0; 2], [0.0; 2]);
    let mut command = 'M';
    let mut rest = d;
    loop {
        rest = rest.trim_start_matches([' ', ',']);
        let Some(c) = rest.chars().next() else {
            return steps;
        };
        if c.is_ascii_alphabetic() {
            (command, rest) = (c, &rest[1..]);
            if matches!(c, 'Z' | 'z') {
                steps.push(Step::Close);
                at = start;
            }
            continue;
        }
        let is_relative = command.is_ascii_lowercase();
        let from = if is_relative { at } else { [0.0; 2] };
        let Some((first, after)) = number(rest) else {
            return steps;
        };
        rest = after;
        match command.to_ascii_uppercase() {
            'H' => at[0] = from[0] + first,
            'V' => at[1] = from[1] + first,
            _ => {
                let Some((second, after)) = number(rest) else {
                    return steps;
                };
                rest = after;
                at = [from[0] + first, from[1] + second];
            }
        }
        if matches!(command, 'M' | 'm') {
            start = at;
            steps.push(Step::Move(at));
            // More pairs behind are lines.
            command = if is_relative { 'l' } else { 'L' };
        } else {
            steps.push(Step::Line(at));
        }
    }
}

/// The number at the start of a text, and what follows.
fn number(text: &str) -> Option<(f64, &str)> {
    let text = text.trim_start_matches([' ', ',']);
    let end = text
        .char_indices()
        .find(|(i, c)| !(c.is_ascii_digit() || *c == '.' || (*i == 0 && *c == '-')))
        .map_or(text.len(), |(i, _)| i);
    Some((text[..end].parse().ok()?, &text[end..]))
}

/// The four curves of an ellipse: its start, and control points and end of each.
pub(crate) fn ellipse(
    [x, y]: [f64; 2],
    [rx, ry]: [f64; 2],
    turn: f64,
) -> ([f64; 2], [[[f64; 2]; 3]; 4]) {
    // Distance of control points at which a cubic is within 3e-4 of a quarter of a circle.
    const K: f64 = 0.552_284_749_8;
    let (s, c) = turn.to_radians().sin_cos();
    let place = |[u, v]: [f64; 2]| {
        let (u, v) = (rx * u, ry * v);
        [x + c * u - s * v, y + s * u + c * v]
    };
    let quarter = |i: usize| {
        let turned = |[u, v]: [f64; 2]| match i {
            0 => [u, v],
            1 => [-v, u],
            2 => [-u, -v],
            _ => [v, -u],
        };
        [[1.0, K], [K, 1.0], [0.0, 1.0]].map(|p| place(turned(p)))
    };
    (place([1.0, 0.0]), [0, 1, 2, 3].map(quarter))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn absolute_and_relative_steps_are_read() {
        let found = steps("M1 2l3 -4-1 1h5V0H2v-1.5ZM0 0L1,1");
        let expected = [
            Step::Move([1.0, 2.0]),
            Step::Line([4.0, -2.0]),
            Step::Line([3.0, -1.0]),
            Step::Line([8.0, -1.0]),
            Step::Line([8.0, 0.0]),
            Step::Line([2.0, 0.0]),
            Step::Line([2.0, -1.5]),
            Step::Close,
            Step::Move([0.0, 0.0]),
            Step::Line([1.0, 1.0]),
        ];
        assert_eq!(found, expected);
        assert!(steps("").is_empty());
    }

    /// Points of the curves at their middles lie on the turned ellipse.
    #[test]
    fn curves_lie_on_the_ellipse() {
        let (mut from, curves) = ellipse([3.0, 1.0], [2.0, 0.5], 30.0);
        let (s, c) = 30f64.to_radians().sin_cos();
        for [p, q, to] in curves {
            let mid = [0, 1].map(|k| (from[k] + 3.0 * p[k] + 3.0 * q[k] + to[k]) / 8.0);
            let [x, y] = [mid[0] - 3.0, mid[1] - 1.0];
            let [u, v] = [(c * x + s * y) / 2.0, (c * y - s * x) / 0.5];
            assert!((u.hypot(v) - 1.0).abs() < 1e-3);
            from = to;
        }
    }
}
