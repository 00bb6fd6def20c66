//! The smallest sphere that encloses points of five dimensions, by Welzl's algorithm with pivots (Gärtner 1999).

/// Coordinates of a point.
pub(super) type Point = [f64; 5];

fn less(p: &Point, q: &Point) -> Point {
    std::array::from_fn(|i| p[i] - q[i])
}

fn dot(p: &Point, q: &Point) -> f64 {
    p.iter().zip(q).map(|(p, q)| p * q).sum()
}

/// A new point on the sphere must leave the span of those before by more than this share of the squared radius.
const INDEPENDENT: f64 = 1e-24;
/// Excess over the squared radius, relative, that counts as outside.
const OUTSIDE: f64 = 1e-14;

/// The sphere through the points that were pushed, with its centre in their span.
#[derive(Default)]
struct Ball {
    /// The first point, directions to the others made orthogonal, and twice their squared lengths.
    first: Point,
    directions: Vec<(Point, f64)>,
    /// Centres and squared radii, one for each number of points; the last one outlives the points.
    spheres: Vec<(Point, f64)>,
    centre: Point,
    squared: f64,
}

impl Ball {
    fn excess(&self, p: &Point) -> f64 {
        let from = less(p, &self.centre);
        dot(&from, &from) - self.squared
    }

    /// Adds a point to the surface unless it lies in the span of the others.
    fn push(&mut self, p: &Point) -> bool {
        if self.spheres.is_empty() {
            self.first = *p;
            self.spheres.push((*p, 0.0));
        } else {
            let (centre, squared) = self.spheres[self.spheres.len() - 1];
            let mut direction = less(p, &self.first);
            for (other, double) in &self.directions {
                let share = 2.0 * dot(other, &direction) / double;
                direction = std::array::from_fn(|i| direction[i] - share * other[i]);
            }
            let double = 2.0 * dot(&direction, &direction);
            if double <= INDEPENDENT * self.squared {
                return false;
            }
            let from = less(p, &centre);
            let excess = dot(&from, &from) - squared;
            let step = excess / double;
            let centre = std::array::from_fn(|i| centre[i] + step * direction[i]);
            self.directions.push((direction, double));
            self.spheres.push((centre, squared + 0.5 * excess * step));
        }
        (self.centre, self.squared) = self.spheres[self.spheres.len() - 1];
        true
    }

    fn pop(&mut self) {
        self.spheres.pop();
        self.directions.pop();
    }

    /// Encloses the first `n` points of the order, with the pushed ones on the surface; points found outside move to the front.
    fn enclose(&mut self, points: &[Point], order: &mut [usize], n: usize) {
        if self.spheres.len() == 6 {
            return;
        }
        for k in 0..n {
            let p = &points[order[k]];
            if self.excess(p) > OUTSIDE * self.squared && self.push(p) {
                self.enclose(points, order, k);
                self.pop();
                order[..=k].rotate_right(1);
            }
        }
    }
}

/// Centre and radius of the smallest enclosing sphere.
pub(super) fn smallest_sphere(points: &[Point]) -> (Point, f64) {
    let mut ball = Ball::default();
    let mut order: Vec<usize> = (0..points.len()).collect();
    let Some(first) = points.first() else {
        return ([0.0; 5], 0.0);
    };
    ball.push(first);
    ball.pop();
    let mut n_front = 1;
    loop {
        // The farthest point, last in the order of those that matter.
        let farthest = (0..points.len()).max_by(|a, b| {
            ball.excess(&points[order[*a]])
                .total_cmp(&ball.excess(&points[order[*b]]))
        });
        let Some(k) = farthest else { break };
        let (p, before) = (points[order[k]], ball.squared);
        if ball.excess(&p) <= OUTSIDE * before || !ball.push(&p) {
            break;
        }
        ball.enclose(points, &mut order, n_front);
        ball.pop();
        order[..=k].rotate_right(1);
        n_front = (n_front + 1).min(points.len());
        if ball.squared <= before {
            break;
        }
    }
    (ball.centre, ball.squared.sqrt())
}
