//! Conditions that change in time.
//!
//! ```text
//!   T = t u_r/a,   u_1 = ū(1 − S/2), u_2 = ū(1 + S/2) over u_r,   v_2 = −v_1 = ū S_⊥/2,   ω in u_r/a,   w over w_r
//! ```
//! The speed u_r and the load w_r of reference are those of the scales: the largest that occur, which never vanish.

use super::{Approach, Course, Start};
use crate::contact::pose::turned;
use crate::contact::{Planar, Pose};

/// Velocities of both surfaces along the motion.
#[derive(Clone, Debug, PartialEq)]
pub enum Speeds {
    /// Entrainment speed and slide-to-roll ratio.
    Mean {
        /// ū.
        entrainment: Course,
        /// S.
        slide_to_roll_ratio: Course,
    },
    /// Both separately: they may move in opposite directions without entrainment.
    Each([Course; 2]),
}

impl Speeds {
    /// Velocities of body 1 and body 2 at an instant.
    pub fn at(&self, time: f64) -> [f64; 2] {
        match self {
            Speeds::Mean {
                entrainment,
                slide_to_roll_ratio,
            } => {
                let (u, half) = (entrainment.at(time), 0.5 * slide_to_roll_ratio.at(time));
                [u * (1.0 - half), u * (1.0 + half)]
            }
            Speeds::Each(speeds) => speeds.each_ref().map(|speed| speed.at(time)),
        }
    }

    fn courses(&self) -> [&Course; 2] {
        match self {
            Speeds::Mean {
                entrainment,
                slide_to_roll_ratio,
            } => [entrainment, slide_to_roll_ratio],
            Speeds::Each([first, second]) => [first, second],
        }
    }
}

/// Contents of cavitated gaps in contacts with excess oil.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Cavities {
    /// Full of oil drawn from around the contact: no film is missing where the gap closes again.
    #[default]
    Refilled,
    /// The oil that has flown in, as in starved contacts (Jakobsson and Floberg 1957, Olsson 1965).
    Conserved,
}

/// Conditions that change in time, divided by the scales of the contact.
#[derive(Clone, Debug, PartialEq)]
pub struct Conditions {
    /// Velocities of the surfaces along the motion.
    pub speeds: Speeds,
    /// S_⊥: velocity of body 2 less that of body 1 across the motion, over ū.
    pub slide_to_roll_ratio_across: Course,
    /// ω of body 1 and body 2 about the contact normal, from x towards y.
    pub spin: [Course; 2],
    /// Load.
    pub load: Course,
    /// Radius of the bodies.
    pub radius: Course,
    /// Temperature of bodies and oil, K; that of the problem's fluid where there is none.
    pub temperature: Option<Course>,
    /// H_oil of the layer that arrives, in a²/R; as in the problem where there is none.
    pub layer: Option<Course>,
    /// Contents of gaps where the film has cavitated.
    pub cavities: Cavities,
    /// The equation for the distance of the bodies.
    pub approach: Approach,
    /// The initial state.
    pub start: Start,
    /// T at the end.
    pub duration: f64,
    /// Instants other than kinks at which a step ends.
    pub instants: Vec<f64>,
}

/// Nothing changes, and no time passes.
impl Default for Conditions {
    fn default() -> Conditions {
        Conditions {
            speeds: Speeds::Mean {
                entrainment: Course::Constant(1.0),
                slide_to_roll_ratio: Course::Constant(0.0),
            },
            slide_to_roll_ratio_across: Course::Constant(0.0),
            spin: [0.0; 2].map(Course::Constant),
            load: Course::Constant(1.0),
            radius: Course::Constant(1.0),
            temperature: None,
            layer: None,
            cavities: Cavities::default(),
            approach: Approach::Massless,
            start: Start::Steady,
            duration: 0.0,
            instants: Vec::new(),
        }
    }
}

/// Points and weights of Gauss's rule of five points on (0, 1).
const GAUSS: [[f64; 2]; 5] = [
    [0.046_910_077_030_668, 0.118_463_442_528_095],
    [0.230_765_344_947_158, 0.239_314_335_249_683],
    [0.5, 0.284_444_444_444_444],
    [0.769_234_655_052_842, 0.239_314_335_249_683],
    [0.953_089_922_969_332, 0.118_463_442_528_095],
];

/// Instants other than kinks at which the speed is sampled.
const SAMPLES: u32 = 2000;

impl Conditions {
    /// Velocities of body 1 and body 2 at an instant, at places in half-widths.
    pub fn velocities(&self, time: f64) -> [Planar; 2] {
        let speeds = self.speeds.at(time);
        let across = 0.25 * self.slide_to_roll_ratio_across.at(time) * (speeds[0] + speeds[1]);
        [0, 1].map(|b: usize| Planar {
            centre: [speeds[b], if b == 0 { -across } else { across }],
            spin: self.spin[b].at(time),
        })
    }

    /// Whether bodies turn about the contact normal at some time.
    pub fn spins(&self) -> bool {
        self.spin.iter().any(|spin| *spin != Course::Constant(0.0))
    }

    /// How both bodies move between two instants without a kink between them.
    pub fn way(&self, from: f64, to: f64) -> [Pose; 2] {
        let integral = |from: f64, to: f64, of: &dyn Fn(f64) -> [f64; 2]| {
            GAUSS.iter().fold([0.0; 2], |sum, [share, weight]| {
                let values = of(from + share * (to - from));
                [0, 1].map(|i: usize| sum[i] + weight * (to - from) * values[i])
            })
        };
        let spins = self.spins();
        [0, 1].map(|b: usize| {
            let angle = |from: f64| match spins {
                true => integral(from, to, &|time| [self.spin[b].at(time), 0.0])[0],
                false => 0.0,
            };
            Pose {
                shift: integral(from, to, &|time| {
                    turned(angle(time), self.velocities(time)[b].centre)
                }),
                angle: angle(from),
            }
        })
    }

    /// Smallest size of the entrainment speed over time.
    pub fn slowest(&self) -> f64 {
        let sizes = self.entrainment().map(f64::abs);
        sizes.fold(f64::INFINITY, f64::min)
    }

    /// Largest speed of a body at the centre over time, over that of reference.
    pub fn fastest(&self) -> f64 {
        let velocities = self.samples().map(|time| self.velocities(time));
        (velocities.flatten()).fold(0.0, |most, v| most.max(v.centre[0].hypot(v.centre[1])))
    }

    /// Smallest value of a course over time.
    pub fn least(&self, course: &Course) -> f64 {
        let values = self.samples().map(|time| course.at(time));
        values.fold(f64::INFINITY, f64::min)
    }

    /// Whether the entrainment turns at some time.
    pub fn turns(&self) -> bool {
        self.entrainment().any(|speed| speed < 0.0)
    }

    /// The entrainment speed at kinks and between them.
    fn entrainment(&self) -> impl Iterator<Item = f64> {
        self.samples().map(|time| {
            let [first, second] = self.speeds.at(time);
            0.5 * (first + second)
        })
    }

    /// Kinks and instants between them.
    fn samples(&self) -> impl Iterator<Item = f64> {
        let even = (0..=SAMPLES).map(|i| self.duration * f64::from(i) / f64::from(SAMPLES));
        let stops = self.stops().into_iter().map(|(stop, _)| stop);
        even.chain(stops)
    }

    /// Whether an instant is a requested output time.
    pub fn is_asked(&self, time: f64) -> bool {
        let near = 1e-9 * self.duration;
        (self.instants.iter()).any(|other| (other - time).abs() <= near)
    }

    /// All that changes.
    fn courses(&self) -> impl Iterator<Item = &Course> {
        let approach = match &self.approach {
            Approach::Given(course) => Some(course),
            Approach::Massless | Approach::Body(_) => None,
        };
        (self.speeds.courses().into_iter())
            .chain([&self.slide_to_roll_ratio_across])
            .chain(&self.spin)
            .chain([&self.load, &self.radius])
            .chain(&self.temperature)
            .chain(&self.layer)
            .chain(approach)
    }

    /// Largest step from an instant that resolves all courses.
    pub fn visible(&self, time: f64) -> f64 {
        let all = self.courses().map(|course| course.visible(time));
        all.fold(f64::INFINITY, f64::min)
    }

    /// Instants after the start that a step ends at, in order; with each whether something has a kink there.
    pub fn stops(&self) -> Vec<(f64, bool)> {
        let kinks = self.courses().flat_map(Course::kinks);
        let mut stops: Vec<(f64, bool)> = (kinks.map(|t| (t, true)))
            .chain(self.instants.iter().map(|t| (*t, false)))
            .chain([(self.duration, false)])
            .filter(|(t, _)| *t > 0.0 && *t <= self.duration)
            .collect();
        stops.sort_by(|a, b| a.0.total_cmp(&b.0));
        let near = 1e-9 * self.duration;
        stops.dedup_by(|next, kept| {
            let same = next.0 - kept.0 <= near;
            kept.1 |= same && next.1;
            same
        });
        stops
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use std::f64::consts::TAU;

    /// A ramp from 1 to 3 within T = 2 at a ratio of 0.5: the bodies move by 0.75 and 1.25 of ∫ū = 4; stops in order, kinks listed once.
    #[test]
    fn ways_and_stops_by_hand() {
        let conditions = Conditions {
            speeds: Speeds::Mean {
                entrainment: Course::Table(vec![[0.0, 1.0], [2.0, 3.0]]),
                slide_to_roll_ratio: Course::Constant(0.5),
            },
            load: Course::Step {
                from: 1.0,
                to: 0.5,
                at: 1.5,
            },
            duration: 5.0,
            instants: vec![4.0, 2.0, 9.0],
            ..Conditions::default()
        };
        for (way, expected) in conditions.way(0.0, 2.0).iter().zip([3.0, 5.0]) {
            assert_relative_eq!(way.shift[0], expected, max_relative = 1e-12);
            assert_eq!((way.shift[1], way.angle), (0.0, 0.0));
        }
        assert_relative_eq!(conditions.slowest(), 1.0);
        assert!(!conditions.turns());
        assert_eq!(
            conditions.stops(),
            vec![(1.5, true), (2.0, true), (4.0, false), (5.0, false)]
        );
    }

    /// A step that ends at an instant just before a kink, within rounding, ends at the kink as well.
    #[test]
    fn kinks_within_rounding_of_an_instant_count() {
        let conditions = Conditions {
            load: Course::Step {
                from: 1.0,
                to: 0.5,
                at: 2.0,
            },
            duration: 5.0,
            instants: vec![2.0 - 1e-10],
            ..Conditions::default()
        };
        let kinks: Vec<bool> = (conditions.stops().iter()).map(|(_, kink)| *kink).collect();
        assert_eq!(kinks, vec![true, false]);
    }

    /// By hand: ū = 0.8 with S_⊥ = 0.5 makes v_2 − v_1 = 0.4, half of it each way, and S = 0.25 makes u_1 = 0.7, u_2 = 0.9.
    #[test]
    fn velocities_by_hand() {
        let conditions = Conditions {
            speeds: Speeds::Mean {
                entrainment: Course::Constant(0.8),
                slide_to_roll_ratio: Course::Constant(0.25),
            },
            slide_to_roll_ratio_across: Course::Constant(0.5),
            ..Conditions::default()
        };
        for (velocity, [u, v]) in (conditions.velocities(0.0).iter()).zip([[0.7, -0.2], [0.9, 0.2]])
        {
            assert_relative_eq!(velocity.centre[0], u, max_relative = 1e-12);
            assert_relative_eq!(velocity.centre[1], v, max_relative = 1e-12);
        }
    }

    /// A body at the speed u that turns by ω moves about (0, u/ω): in one step, and in two. One whose spin swings turns by ∫ω.
    #[test]
    fn bodies_turn_about_their_poles() {
        let (u, omega) = (0.8, 0.6);
        let conditions = Conditions {
            speeds: Speeds::Mean {
                entrainment: Course::Constant(u),
                slide_to_roll_ratio: Course::Constant(0.0),
            },
            spin: [
                Course::Constant(omega),
                Course::Sine {
                    mean: 0.1,
                    amplitude: 0.4,
                    period: 3.0,
                    start: 0.0,
                },
            ],
            duration: 2.0,
            ..Conditions::default()
        };
        let start = [-0.7, 0.3];
        let pole = [0.0, u / omega];
        let way = conditions.way(0.0, 1.3);
        let [x, y] = turned(omega * 1.3, [start[0] - pole[0], start[1] - pole[1]]);
        let found = way[0].at_start([x + pole[0], y + pole[1]]);
        let steps = [conditions.way(0.0, 0.5), conditions.way(0.5, 1.3)];
        let both = [0, 1].map(|b: usize| steps[0][b].then(&steps[1][b]));
        for d in 0..2 {
            assert_relative_eq!(found[d], start[d], max_relative = 1e-9);
            for b in 0..2 {
                assert_relative_eq!(both[b].shift[d], way[b].shift[d], max_relative = 1e-6);
            }
        }
        let wave = TAU / 3.0;
        let angle = 0.13 + 0.4 / wave * (1.0 - (wave * 1.3).cos());
        assert_relative_eq!(way[1].angle, angle, max_relative = 1e-6);
    }

    /// A speed that falls below zero between two samples of even times is seen at its kink; one that only falls to zero does not turn, nor do bodies that run
    /// against each other without entrainment.
    #[test]
    fn turns_are_seen_at_kinks() {
        let of = |speeds: Speeds| Conditions {
            speeds,
            duration: 10.0,
            ..Conditions::default()
        };
        let dip = |low: f64| {
            let rows = [[0.0, 1.0], [3.0011, 1.0], [3.0012, low], [3.0013, 1.0]];
            of(Speeds::Mean {
                entrainment: Course::Table(rows.to_vec()),
                slide_to_roll_ratio: Course::Constant(0.0),
            })
        };
        assert!(dip(-0.1).turns());
        assert!(!dip(0.0).turns());
        assert_relative_eq!(dip(0.0).slowest(), 0.0);
        let [there, back] = [1.0, -1.0].map(Course::Constant);
        assert!(!of(Speeds::Each([there.clone(), back.clone()])).turns());
        let faster = Course::Constant(-1.5);
        assert!(of(Speeds::Each([there, faster])).turns());
    }
}
