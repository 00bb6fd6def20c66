//! Which point of a study starts from which: a tree that the points alone determine, so that every run of the study,
//! killed and resumed or in parts, computes the same digits.
//!
//! Points of one shape, one pair of bodies, the same settings and similar films make a group. The point
//! in its middle is solved from the dry contact; then each next one is the farthest from all before, and
//! starts from the nearest of these. So the tree is about as deep as the logarithm of the number of points, and most
//! points still start from a near neighbour.

use std::collections::HashMap;

use rayon::prelude::*;

use crate::case::Study;
use crate::problem::problem;

/// Ratio of the largest to the smallest relative film thickness in a group.
const FILM_RATIO: f64 = 2.8;

/// Points of one group, at most: its tree takes their square in time.
const MOST_IN_GROUP: usize = 4_000;

/// Which point starts from which: a tree, or a chain.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    /// Point that each point starts from; `None` from the dry contact.
    pub parents: Vec<Option<usize>>,
    /// All points, each after the one it starts from, and depth first: what starts from one point follows it
    /// directly.
    pub order: Vec<usize>,
    /// Points that are similar.
    pub groups: Vec<Vec<usize>>,
}

/// Features that distinguish points.
struct Features {
    /// Properties in which similar points agree: shape, bodies, settings.
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
    /// Each point from the one before it.
    pub fn chain(n_points: usize) -> Plan {
        Plan {
            parents: (0..n_points).map(|i| i.checked_sub(1)).collect(),
            order: (0..n_points).collect(),
            groups: vec![(0..n_points).collect()],
        }
    }

    /// Points that start from no other, in their order.
    pub fn apart(n_points: usize) -> Plan {
        Plan {
            parents: vec![None; n_points],
            order: (0..n_points).collect(),
            groups: vec![(0..n_points).collect()],
        }
    }

    /// The tree of a study; cases in time begin with separate steady contacts.
    pub fn new(study: &Study) -> Plan {
        if study.points.iter().any(|p| p.case.transient.is_some()) {
            return Plan::apart(study.points.len());
        }
        let features = features(study);
        let n = features.len();
        let mut plan = Plan {
            parents: vec![None; n],
            order: Vec::with_capacity(n),
            groups: groups(&features),
        };
        for members in &plan.groups {
            grow(&features, members, &mut plan.parents, &mut plan.order);
        }
        plan
    }

    /// The tree of one group, its points by their places among the members, and these members.
    pub fn of_group(&self, group: usize) -> (Plan, &[usize]) {
        let members = &self.groups[group];
        let local: HashMap<usize, usize> =
            members.iter().enumerate().map(|(i, m)| (*m, i)).collect();
        let parent = |m: &usize| self.parents[*m].map(|parent| local[&parent]);
        let order = self.order.iter().filter_map(|i| local.get(i).copied());
        let plan = Plan {
            parents: members.iter().map(parent).collect(),
            order: order.collect(),
            groups: vec![(0..members.len()).collect()],
        };
        (plan, members)
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
}

/// The tree of one group.
fn grow(
    features: &[Features],
    members: &[usize],
    parents: &mut [Option<usize>],
    order: &mut Vec<usize>,
) {
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
        parents[members[next]] = Some(members[parent]);
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
        order.push(members[i]);
        stack.extend(children[i].iter().rev());
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

/// Points that are similar, groups and members in the order of the points.
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
        for part in parts.into_iter().filter(|part| !part.is_empty()) {
            split(features, part, &mut result);
        }
    }
    result
}

/// Halves members, along what they differ in most, until they are few enough for a group.
fn split(features: &[Features], mut members: Vec<usize>, groups: &mut Vec<Vec<usize>>) {
    if members.len() <= MOST_IN_GROUP {
        members.sort_unstable();
        groups.push(members);
        return;
    }
    let extent = |axis: usize| {
        let values = members.iter().map(|m| features[*m].place[axis]);
        let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| {
            (l.min(v), h.max(v))
        });
        high - low
    };
    let axes = 0..features[members[0]].place.len();
    let widest = axes.max_by(|a, b| extent(*a).total_cmp(&extent(*b)));
    let place = |m: &usize| widest.map_or(0.0, |axis| features[*m].place[axis]);
    members.sort_by(|a, b| place(a).total_cmp(&place(b)).then(a.cmp(b)));
    let upper = members.split_off(members.len() / 2);
    split(features, members, groups);
    split(features, upper, groups);
}

fn features(study: &Study) -> Vec<Features> {
    // Numbers of one sign are compared by their ratios, others by their share of the axis.
    let scale = |column: usize| -> Box<dyn Fn(f64) -> f64 + Sync> {
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
        let bodies: Vec<String> = (problem.elasticity.bodies.iter())
            .map(|body| format!("{:.8e} {:.8e}", body.youngs_modulus, body.poissons_ratio))
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
    study.points.par_iter().map(features).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Points on a line, in an order that says nothing.
    fn line(n: usize) -> Vec<Features> {
        let place = |i: usize| ((7 * i + 3) % n) as f64;
        let features = |i| Features {
            kind: String::new(),
            film: 0.0,
            place: vec![place(i)],
            names: Vec::new(),
        };
        (0..n).map(features).collect()
    }

    fn tree(features: &[Features]) -> (Vec<Option<usize>>, Vec<usize>) {
        let members: Vec<usize> = (0..features.len()).collect();
        let (mut parents, mut order) = (vec![None; features.len()], Vec::new());
        grow(features, &members, &mut parents, &mut order);
        (parents, order)
    }

    #[test]
    fn every_point_comes_once_and_after_its_start() {
        let features = line(100);
        let (parents, order) = tree(&features);
        let mut sorted = order.clone();
        sorted.sort_unstable();
        assert_eq!(sorted, (0..100).collect::<Vec<_>>());
        let place = |i: usize| order.iter().position(|o| *o == i).unwrap();
        assert_eq!(parents.iter().filter(|p| p.is_none()).count(), 1);
        for (i, parent) in parents.iter().enumerate() {
            assert!(parent.is_none_or(|p| place(p) < place(i)));
        }
        // Depth first: what follows a point starts from it, or from one that leads to it.
        let leads = |from: usize, to: usize| {
            let mut at = Some(to);
            while let Some(i) = at {
                if i == from {
                    return true;
                }
                at = parents[i];
            }
            false
        };
        for pair in order.windows(2) {
            assert!(leads(parents[pair[1]].unwrap(), pair[0]));
        }
    }

    #[test]
    fn a_long_line_is_few_starts_deep_with_short_steps() {
        let features = line(100);
        let (parents, order) = tree(&features);
        let plan = Plan {
            parents,
            order,
            groups: Vec::new(),
        };
        // The middle, an end, and then halves of halves: log2(100) = 6.6.
        assert!(plan.depth() <= 9, "{}", plan.depth());
        let step = |(i, parent): (usize, &Option<usize>)| {
            parent.map(|p| (features[i].place[0] - features[p].place[0]).abs())
        };
        let steps: Vec<f64> = plan.parents.iter().enumerate().filter_map(step).collect();
        // Of halves of halves, half of the steps reach the neighbour and a quarter the next one.
        let short = steps.iter().filter(|s| **s <= 2.0).count();
        assert!(short >= 60, "{short} of 99 steps");
    }

    /// Each point of a chain starts from the one before.
    #[test]
    fn a_chain_goes_from_point_to_point() {
        let plan = Plan::chain(4);
        assert_eq!(plan.parents, [None, Some(0), Some(1), Some(2)]);
        assert_eq!(plan.order, [0, 1, 2, 3]);
        assert_eq!(plan.depth(), 4);
    }

    /// No group is too large for its tree, each point is in one, and groups are neighbours.
    #[test]
    fn large_groups_are_split() {
        let n = 3 * MOST_IN_GROUP;
        let features = line(n);
        let groups = groups(&features);
        assert_eq!(groups.len(), 4);
        let mut all: Vec<usize> = groups.concat();
        all.sort_unstable();
        assert_eq!(all, (0..n).collect::<Vec<_>>());
        for group in groups {
            let places = group.iter().map(|m| features[*m].place[0]);
            let (low, high) =
                places.fold((f64::INFINITY, 0.0_f64), |(l, h), v| (l.min(v), h.max(v)));
            assert_eq!(high - low, (n / 4 - 1) as f64);
        }
    }

    #[test]
    fn films_of_one_group_are_within_its_ratio() {
        let mut features = line(60);
        for (i, f) in features.iter_mut().enumerate() {
            f.film = (1.0 + i as f64).ln();
            f.kind = if i % 2 == 0 { "a" } else { "b" }.to_owned();
        }
        let groups = groups(&features);
        let mut all: Vec<usize> = groups.concat();
        all.sort_unstable();
        assert_eq!(all, (0..60).collect::<Vec<_>>());
        for group in &groups {
            assert!(group.iter().all(|i| i % 2 == group[0] % 2));
            let films = group.iter().map(|i| 1.0 + *i as f64);
            let (low, high) = films.fold((f64::INFINITY, 0.0), |(l, h): (f64, f64), f| {
                (l.min(f), h.max(f))
            });
            assert!(high <= FILM_RATIO * low * (1.0 + 1e-9), "{low} to {high}");
        }
        // ln 60/ln 2.8 = 3.98 for the even ones.
        assert_eq!(groups.len(), 8);
    }
}
