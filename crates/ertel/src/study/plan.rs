//! Which point of a study starts from which: a tree that the points alone determine, so that every run of the study,
//! killed and resumed or in parts, computes the same digits.
//!
//! Points of one shape, one pair of bodies, the same settings and similar films make a group with one mesh. The point
//! in its middle is solved from the dry contact; then each next one is the farthest from all before, and
//! starts from the nearest of these. So the tree is about as deep as the logarithm of the number of points, and most
//! points still start from a near neighbour.

use crate::case::Study;
use crate::run::problem;

/// Ratio of the largest to the smallest relative film thickness in a group: one mesh has room for so many.
const FILM_RATIO: f64 = 2.8;

/// The tree of starts.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    /// Point that each point starts from; `None` from the dry contact.
    pub parents: Vec<Option<usize>>,
    /// All points, each after the one it starts from, and depth first: what starts from one point follows it
    /// directly.
    pub order: Vec<usize>,
    /// Points that share each point's mesh, without itself.
    pub groups: Vec<Vec<usize>>,
}

/// What tells points apart.
struct Features {
    /// What one mesh cannot serve: shape, bodies, settings.
    kind: String,
    /// Logarithm of the relative film thickness that formulas predict.
    film: f64,
    /// Coordinates of the distance.
    place: Vec<f64>,
    /// Values that are no numbers.
    names: Vec<String>,
}

impl Features {
    fn distance(&self, other: &Features) -> f64 {
        let square = |a: &f64, b: &f64| (a - b) * (a - b);
        let places = self.place.iter().zip(&other.place);
        let names = self.names.iter().zip(&other.names);
        square(&self.film, &other.film)
            + places.map(|(a, b)| square(a, b)).sum::<f64>()
            + names.filter(|(a, b)| a != b).count() as f64
    }
}

impl Plan {
    /// The tree of a study.
    pub fn new(study: &Study) -> Plan {
        let features = features(study);
        let n = features.len();
        let mut plan = Plan {
            parents: vec![None; n],
            order: Vec::with_capacity(n),
            groups: vec![Vec::new(); n],
        };
        for members in groups(&features) {
            plan.add(&features, &members);
        }
        plan
    }

    /// How many starts lead to a point at most, the cold one included.
    pub fn depth(&self) -> usize {
        let depth = |mut i: usize| {
            let mut depth = 1;
            while let Some(parent) = self.parents[i] {
                i = parent;
                depth += 1;
            }
            depth
        };
        (0..self.parents.len()).map(depth).max().unwrap_or(0)
    }

    fn add(&mut self, features: &[Features], members: &[usize]) {
        let root = middle(features, members);
        let mut children: Vec<Vec<usize>> = vec![Vec::new(); members.len()];
        // Distance to the nearest point in the tree, and which that is.
        let mut near: Vec<(f64, usize)> = members
            .iter()
            .map(|m| (features[*m].distance(&features[members[root]]), root))
            .collect();
        let mut inside = vec![false; members.len()];
        inside[root] = true;
        for _ in 1..members.len() {
            let mut next: Option<usize> = None;
            for i in (0..members.len()).filter(|i| !inside[*i]) {
                if next.is_none_or(|n| near[i].0 > near[n].0) {
                    next = Some(i);
                }
            }
            let Some(next) = next else { break };
            inside[next] = true;
            let parent = near[next].1;
            self.parents[members[next]] = Some(members[parent]);
            children[parent].push(next);
            for (i, m) in members.iter().enumerate() {
                let distance = features[*m].distance(&features[members[next]]);
                if !inside[i] && distance < near[i].0 {
                    near[i] = (distance, next);
                }
            }
        }
        let mut stack = vec![root];
        while let Some(i) = stack.pop() {
            self.order.push(members[i]);
            stack.extend(children[i].iter().rev());
        }
        for m in members {
            self.groups[*m] = members.iter().copied().filter(|o| o != m).collect();
        }
    }
}

/// The member nearest to the mean of all.
fn middle(features: &[Features], members: &[usize]) -> usize {
    let n = members.len() as f64;
    let mean = |value: &dyn Fn(&Features) -> f64| {
        members.iter().map(|m| value(&features[*m])).sum::<f64>() / n
    };
    let film = mean(&|f| f.film);
    let place: Vec<f64> = (0..features[members[0]].place.len())
        .map(|i| mean(&|f| f.place[i]))
        .collect();
    let off = |m: usize| {
        let f = &features[m];
        let places = f.place.iter().zip(&place);
        (f.film - film).powi(2) + places.map(|(a, b)| (a - b).powi(2)).sum::<f64>()
    };
    let mut best = 0;
    for i in 1..members.len() {
        if off(members[i]) < off(members[best]) {
            best = i;
        }
    }
    best
}

/// Points that can share a mesh, groups and members in the order of the points.
fn groups(features: &[Features]) -> Vec<Vec<usize>> {
    let mut kinds: Vec<(&str, Vec<usize>)> = Vec::new();
    for (i, f) in features.iter().enumerate() {
        match kinds.iter_mut().find(|(kind, _)| *kind == f.kind) {
            Some((_, members)) => members.push(i),
            None => kinds.push((&f.kind, vec![i])),
        }
    }
    let mut result = Vec::new();
    for (_, members) in kinds {
        let films = members.iter().map(|m| features[*m].film);
        let (low, high) = films.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), f| {
            (l.min(f), h.max(f))
        });
        let n_parts = (((high - low) / FILM_RATIO.ln()).ceil() as usize).max(1);
        let width = (high - low) / n_parts as f64;
        let mut parts = vec![Vec::new(); n_parts];
        for m in members {
            let part = match width > 0.0 {
                true => ((features[m].film - low) / width) as usize,
                false => 0,
            };
            parts[part.min(n_parts - 1)].push(m);
        }
        result.extend(parts.into_iter().filter(|part| !part.is_empty()));
    }
    result
}

fn features(study: &Study) -> Vec<Features> {
    // Numbers of one sign are told apart by their ratios, others by their share of the axis.
    let scale = |column: usize| -> Box<dyn Fn(f64) -> f64> {
        let numbers = study.points.iter().map(|p| p.values[column].number());
        let (low, high) = numbers
            .flatten()
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| {
                (l.min(v), h.max(v))
            });
        match low {
            low if low > 0.0 => Box::new(f64::ln),
            low if high > low => Box::new(move |v| (v - low) / (high - low)),
            _ => Box::new(|_| 0.0),
        }
    };
    let scales: Vec<_> = (0..study.columns.len()).map(scale).collect();
    let features = |point: &crate::case::study::StudyPoint| {
        let problem = problem(&point.case);
        let case = &point.case;
        // Without the noise of the last digits.
        let bodies: Vec<String> = (problem.bodies.iter())
            .map(|(modulus, ratio)| format!("{modulus:.8e} {ratio:.8e}"))
            .collect();
        let values = point.values.iter().zip(&scales);
        let place = values.map(|(value, scale)| value.number().map_or(0.0, scale));
        let names = point.values.iter().filter(|v| v.number().is_none());
        Features {
            kind: format!(
                "{:?} {bodies:?} {:?} {:?}",
                case.contact.kind, case.mesh, case.solver
            ),
            film: problem.start_film.ln(),
            place: place.collect(),
            names: names.map(|v| v.to_string()).collect(),
        }
    };
    study.points.iter().map(features).collect()
}
