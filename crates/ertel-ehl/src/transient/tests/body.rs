//! Bodies that approach each other: rigid squeeze films against closed forms, impacts against the dry one and against published histories.

use std::f64::consts::PI;

use approx::assert_relative_eq;
use ertel_rheology::density::DensityLaw;
use ertel_rheology::viscosity::ViscosityLaw;

use super::{Given, Params, line, run, steady};
use crate::contact::Contact;
use crate::engine::{NoObserver, Observer, Problem};
use crate::film::FilmFluid;
use crate::solution::Figure;
use crate::transient::{
    Approach, Conditions, Course, Info, Instant, Mover, Speeds, Start, TransientError,
    TransientObserver, march,
};
use crate::volumes::Plan;

/// An instant, SI but for the time.
#[derive(Clone, Copy, Debug)]
struct Row {
    time: f64,
    approach: f64,
    velocity: f64,
    force: f64,
    central: f64,
    minimum: f64,
    /// Pressure at the centre.
    pressure: f64,
}

struct Rows {
    rows: Vec<Row>,
    quiet: NoObserver,
}

impl TransientObserver for Rows {
    fn instant(&mut self, instant: &Instant<'_>) {
        let scales = &instant.problem.scales;
        let of = |figure| instant.measured.estimate(figure).value;
        let level = instant.levels.last().unwrap();
        let [i, j] = level.system.grid.centre();
        let pressure = level.state.pressure[level.system.grid.index(i, j)];
        self.rows.push(Row {
            time: instant.time,
            approach: instant.approach * scales.film,
            velocity: instant.approach_velocity * scales.film,
            force: instant.film_force,
            central: of(Figure::FilmCentral),
            minimum: of(Figure::FilmMinimum),
            pressure: pressure * scales.pressure,
        });
    }

    fn start(&mut self) -> &mut dyn Observer {
        &mut self.quiet
    }
}

/// A contact between bodies that do not roll; its speed of reference is that at which the bodies come near, V, times R/a.
struct Squeeze {
    problem: Problem<Plan>,
    /// Seconds in T.
    unit: f64,
    /// Load of reference.
    load: f64,
}

impl Squeeze {
    fn new(given: &Given, velocity: f64, reach: f64) -> Squeeze {
        let half_width = given.problem().scales.length;
        let speed = velocity * given.contact.radius / half_width;
        let mut problem = Given {
            speed,
            contact: given.contact.clone(),
            thinning: None,
            ..*given
        }
        .problem();
        problem.extents.inlet = -reach;
        problem.extents.outlet = reach;
        problem.extents.side = reach;
        Squeeze {
            unit: half_width / speed,
            load: given.contact.load,
            problem,
        }
    }

    /// Without rolling, from a gap (m) at a velocity (m/s), for some seconds.
    fn conditions(&self, gap: f64, velocity: f64, approach: Approach, duration: f64) -> Conditions {
        let film = self.problem.scales.film;
        Conditions {
            speeds: Speeds::Each([0.0, 0.0].map(Course::Constant)),
            approach,
            start: Start::Apart {
                gap: gap / film,
                velocity: velocity / film * self.unit,
            },
            load: Course::Constant(1e-12),
            ..steady(duration / self.unit)
        }
    }

    /// A free mass, kg.
    fn mass(&self, mass: f64) -> Approach {
        let acceleration = self.problem.scales.film / self.unit.powi(2);
        Approach::Body(Mover {
            mass: mass * acceleration / self.load,
            ..Mover::default()
        })
    }

    /// Rows with times in s, velocities in m/s and forces in N.
    fn run(
        self,
        conditions: &Conditions,
        params: &Params,
    ) -> (Vec<Row>, Result<Info, TransientError>) {
        let (unit, load) = (self.unit, self.load);
        let mut rows = Rows {
            rows: Vec::new(),
            quiet: NoObserver,
        };
        let info = march(self.problem, conditions, params, &mut rows);
        let si = |row: Row| Row {
            time: row.time * unit,
            velocity: row.velocity / unit,
            force: row.force * load,
            ..row
        };
        (rows.rows.into_iter().map(si).collect(), info)
    }
}

/// A steel ball of 10 mm on a plane under 15 N, whose a²/R is 1 µm.
fn ball() -> Given {
    Given {
        contact: Contact::circular(0.01, 15.0),
        target: 2e-2,
        ..line()
    }
}

fn params(tolerance: f64) -> Params {
    Params {
        tolerance,
        ..Params::default()
    }
}

/// An oil of constant density.
fn oil(problem: &mut Problem<Plan>, viscosity: &ViscosityLaw) {
    let density = DensityLaw::constant(870.0).unwrap();
    problem.fluid = FilmFluid::new(&density, viscosity, 313.15, &problem.scales);
}

/// Half-widths from the centre to the edges.
const REACH: f64 = 28.0;

/// Viscosity without pressure, Pa s.
const ETA: f64 = 0.04;

/// A body comes near at a given velocity from 2 to 1 µm.
fn given_approach(contact: Contact, viscosity: &ViscosityLaw, velocity: f64) -> Vec<Row> {
    let given = Given { contact, ..ball() };
    let mut squeeze = Squeeze::new(&given, velocity, REACH);
    oil(&mut squeeze.problem, viscosity);
    let duration = 1e-6 / velocity;
    let film = squeeze.problem.scales.film;
    let course = Course::Table(vec![[0.0, 0.0], [duration / squeeze.unit, 1e-6 / film]]);
    let conditions = squeeze.conditions(2e-6, velocity, Approach::Given(course), duration);
    let (rows, info) = squeeze.run(&conditions, &params(1e-2));
    assert_eq!(info.unwrap().refused, 0);
    // Bodies that yield a little take some steps to.
    let rows: Vec<Row> = rows.into_iter().skip(4).collect();
    assert!(rows.len() > 2);
    for row in &rows {
        assert_relative_eq!(row.velocity, velocity, max_relative = 1e-6);
    }
    rows
}

/// Rigid paraboloids of R_x and R_y that approach each other at V have p = C/h² with C = 6ηV/(1/R_x + 1/R_y), and the force 2π√(R_x R_y) C/h_0 (6πηR²V/h_0 of a sphere): here
/// without the part outside the domain, and of a sphere alone.
#[test]
fn a_given_approach_has_the_force_of_rigid_bodies() {
    let velocity = 1e-4;
    let constant = ViscosityLaw::constant(ETA).unwrap();
    let r = 0.01;
    for row in given_approach(ball().contact, &constant, velocity) {
        let h = 2e-6 - row.approach;
        let c = 3.0 * ETA * velocity * r;
        assert_relative_eq!(row.pressure, c / (h * h), max_relative = 1e-2);
        // a²/R is 1 µm.
        let edge = h + 0.5e-6 * REACH * REACH;
        let force = 6.0 * PI * ETA * r * r * velocity * (1.0 / h - 1.0 / edge);
        assert_relative_eq!(row.force, force, max_relative = 5e-3);
    }
    let contact = Contact::elliptical([0.01, 0.03], 25.0, 0.0);
    for row in given_approach(contact, &constant, velocity) {
        let h = 2e-6 - row.approach;
        let c = 6.0 * ETA * velocity / (1.0 / 0.01 + 1.0 / 0.03);
        assert_relative_eq!(row.pressure, c / (h * h), max_relative = 1e-2);
    }
}

/// The same of Barus's oil η exp(αp): p = −ln(1 − αC/h²)/α, here 1.7 times that of constant viscosity at the end.
#[test]
fn a_given_approach_has_the_pressure_of_barus() {
    // αC/h² = 0.7 at 1 µm.
    let (velocity, alpha) = (1e-3, 0.7 / 1.2e6);
    let c = 3.0 * ETA * velocity * 0.01;
    let barus = ViscosityLaw::barus(ETA, alpha).unwrap();
    let rows = given_approach(ball().contact, &barus, velocity);
    for row in &rows {
        // With the deflection of the bodies, a four-hundredth of the film.
        let h = row.central;
        let pressure = -(-alpha * c / (h * h)).ln_1p() / alpha;
        assert_relative_eq!(row.pressure, pressure, max_relative = 1e-2);
    }
    let last = rows.last().unwrap();
    assert!(last.pressure > 1.6 * c / 1e-12, "{last:?}");
}

/// A sphere sinks from 2 to 1 µm under a constant load within 6πηR²/W ln 2 (rigid, no inertia).
#[test]
fn a_massless_sphere_sinks_as_stefan_says() {
    let (load, r) = (0.02, 0.01);
    let velocity = load * 2e-6 / (6.0 * PI * ETA * r * r);
    let mut squeeze = Squeeze::new(&ball(), velocity, REACH);
    oil(&mut squeeze.problem, &ViscosityLaw::constant(ETA).unwrap());
    let duration = 6.0 * PI * ETA * r * r / load * 2.0_f64.ln();
    let conditions = Conditions {
        load: Course::Constant(load / squeeze.load),
        ..squeeze.conditions(2e-6, velocity, Approach::Massless, duration)
    };
    let (rows, info) = squeeze.run(&conditions, &params(1e-2));
    info.unwrap();
    let last = rows.last().unwrap();
    assert_relative_eq!(last.force, load, max_relative = 1e-3);
    // The domain cuts off a three-hundredth of the force.
    assert_relative_eq!(last.approach, 1e-6, max_relative = 1e-2);
}

/// A sphere of mass m that falls on thick oil is slowed by 6πηR²V/h: V = V_0 − (6πηR²/m) ln(h(0)/h), whatever the course of time; here without the part beyond the domain.
#[test]
fn a_mass_is_slowed_by_a_rigid_film() {
    let (velocity, mass, r) = (1e-3, 0.1, 0.01);
    let rate = 6.0 * PI * ETA * r * r / mass;
    let mut squeeze = Squeeze::new(&ball(), velocity, REACH);
    oil(&mut squeeze.problem, &ViscosityLaw::constant(ETA).unwrap());
    let conditions = squeeze.conditions(2e-6, velocity, squeeze.mass(mass), 1.2e-3);
    let (rows, info) = squeeze.run(&conditions, &params(1e-2));
    info.unwrap();
    let last = rows.last().unwrap();
    let ends = [2e-6, 2e-6 - last.approach];
    let edges = ends.map(|h| h + 0.5e-6 * REACH * REACH);
    let slowed = rate * ((ends[0] / ends[1]).ln() - (edges[0] / edges[1]).ln());
    assert!(slowed > 0.4 * velocity, "{slowed}");
    assert_relative_eq!(velocity - last.velocity, slowed, max_relative = 1e-2);
    // The elastic energy of the bodies is negligible: the lost energy is the work on the film, ∫F dh.
    let work: f64 = (rows.windows(2))
        .map(|pair| 0.5 * (pair[0].force + pair[1].force) * (pair[1].approach - pair[0].approach))
        .sum();
    let lost = 0.5 * mass * (velocity * velocity - last.velocity * last.velocity);
    assert_relative_eq!(work, lost, max_relative = 2e-2);
}

/// A steel ball of 10 mm and 32.88 g falls at 0.1 m/s from 5 µm, without gravity, for some time; results at some instants, and the whole course.
fn impact(
    fluid: (&DensityLaw, &ViscosityLaw),
    tolerance: f64,
    duration: f64,
    instants: &[f64],
) -> (Vec<Row>, Vec<Row>) {
    let velocity = 0.1;
    let given = Given {
        contact: Contact::circular(0.01, 90.0),
        target: 5e-2,
        ..line()
    };
    let mut squeeze = Squeeze::new(&given, velocity, 24.0);
    let problem = &mut squeeze.problem;
    problem.fluid = FilmFluid::new(fluid.0, fluid.1, 313.15, &problem.scales);
    let unit = squeeze.unit;
    let conditions = Conditions {
        instants: instants.iter().map(|t| t / unit).collect(),
        ..squeeze.conditions(5e-6, velocity, squeeze.mass(0.032_88), duration)
    };
    let (rows, info) = squeeze.run(&conditions, &params(tolerance));
    info.unwrap();
    let at = |time: f64| {
        let row = rows.iter().find(|row| (row.time / time - 1.0).abs() < 1e-6);
        *row.expect("steps end at instants that are asked for")
    };
    (instants.iter().map(|time| at(*time)).collect(), rows)
}

fn largest_force(rows: &[Row]) -> f64 {
    rows.iter().fold(0.0, |m, row| m.max(row.force))
}

/// Against an axisymmetric solution of the same equations (BDF2, 500 nodes): velocities, forces and films on the way in and out, and the rebound. Where the film breaks on
/// the way out there is no suction: both leave p ≥ 0.
#[test]
fn a_ball_falls_on_oil_of_constant_viscosity() {
    let fluid = (
        &DensityLaw::constant(870.0).unwrap(),
        &ViscosityLaw::constant(ETA).unwrap(),
    );
    let history = [
        [3.071_495_36e-5, 0.097_902_450, 3.575_822, 2.032_840e-6],
        [6.654_906_614e-5, 0.081_962_968, 38.937_40, 2.588_842e-7],
        [1.023_831_787e-4, 0.003_667_110, 91.068_36, 1.811_016e-7],
        [1.382_172_912e-4, -0.073_380_395, 36.644_73, 1.506_034e-7],
    ];
    let (found, rows) = impact(fluid, 2e-2, 1.65e-4, &history.map(|[t, ..]| t));
    assert_history(&found, &history);
    assert_relative_eq!(largest_force(&rows), 91.118, max_relative = 1e-2);
    let thinnest = rows.iter().map(|row| row.minimum).fold(1.0, f64::min);
    assert_relative_eq!(thinnest, 1.059_15e-7, max_relative = 4e-2);
    let last = rows.last().unwrap();
    assert!(last.force < 1e-4, "{last:?}");
    assert_relative_eq!(-last.velocity / 0.1, 0.835_1, max_relative = 5e-3);
}

/// The same with Roelands' viscosity: the middle of the film is entrapped.
#[test]
fn a_ball_falls_on_oil_that_thickens() {
    let fluid = (
        &DensityLaw::dowson_higginson(870.0).unwrap(),
        &ViscosityLaw::roelands(ETA, 1.5e-8).unwrap(),
    );
    let history = [
        [3.063_228_214e-5, 0.097_854_222, 3.779_620, 2.050_412e-6],
        [6.636_994_463e-5, 0.078_298_939, 46.167_90, 8.644_413e-7],
        [1.021_076_071e-4, -0.003_969_362, 89.603_12, 8.511_584e-7],
        [1.378_452_696e-4, -0.077_102_800, 34.157_45, 8.630_725e-7],
    ];
    let (found, rows) = impact(fluid, 2e-2, 1.65e-4, &history.map(|[t, ..]| t));
    assert_history(&found, &history);
    assert_relative_eq!(largest_force(&rows), 90.255, max_relative = 1e-2);
    let last = rows.last().unwrap();
    assert_relative_eq!(-last.velocity / 0.1, 0.865_8, max_relative = 5e-3);
}

/// Time, velocity, force and central film.
fn assert_history(found: &[Row], history: &[[f64; 4]]) {
    for (row, [_, velocity, force, central]) in found.iter().zip(history) {
        assert_relative_eq!(row.velocity, *velocity, epsilon = 5e-4);
        assert_relative_eq!(row.force, *force, max_relative = 1e-2);
        assert_relative_eq!(row.central, *central, max_relative = 1e-2);
    }
}

/// On thin oil it falls as a dry one: F = 4/3 E* √R δ^(3/2) with the deepest δ = (15 m V²/(16 E* √R))^(2/5), the impact of Hertz.
#[test]
fn a_ball_on_thin_oil_falls_as_a_dry_one() {
    let fluid = (
        &DensityLaw::constant(870.0).unwrap(),
        &ViscosityLaw::constant(1e-3).unwrap(),
    );
    let (_, rows) = impact(fluid, 5e-2, 1.1e-4, &[]);
    let (mass, velocity, e, r): (f64, f64, f64, f64) = (0.032_88, 0.1, 115.384_615e9, 0.01);
    let deepest = (15.0 * mass * velocity * velocity / (16.0 * e * r.sqrt())).powf(0.4);
    let force = 4.0 / 3.0 * e * r.sqrt() * deepest.powf(1.5);
    assert_relative_eq!(largest_force(&rows), force, max_relative = 2e-2);
}

/// A roller of some mass with a damper falls from rest on a disc whose speed rises from nothing, and comes to the steady film.
#[test]
fn a_mass_comes_to_the_steady_film() {
    let (constant, _) = run(line().problem(), &steady(0.01), &Params::default());
    let conditions = Conditions {
        speeds: Speeds::Mean {
            entrainment: Course::Table(vec![[0.0, 0.0], [1.0, 1.0]]),
            slide_to_roll_ratio: Course::Constant(0.0),
        },
        ..falling()
    };
    let (films, _) = run(line().problem(), &conditions, &params(1e-2));
    let last = films.0.last().unwrap();
    assert_relative_eq!(last[1], constant.0[0][1], max_relative = 5e-3);
    assert_relative_eq!(last[2], constant.0[0][2], max_relative = 1e-2);
}

/// A spring shares the load with the film: when the load rises by a tenth, a spring as stiff as the contact takes its share, and the film force shows
/// how much.
#[test]
fn a_spring_takes_its_share() {
    let conditions = |stiffness: f64| Conditions {
        load: Course::Table(vec![[0.0, 1.0], [1.0, 1.1]]),
        approach: Approach::Body(Mover {
            mass: 0.01,
            damping: 0.3,
            stiffness,
        }),
        ..steady(12.0)
    };
    let of = |stiffness: f64| {
        let mut problem = line().problem();
        problem.scales.load = problem.load;
        let mut rows = Rows {
            rows: Vec::new(),
            quiet: NoObserver,
        };
        march(problem, &conditions(stiffness), &params(1e-2), &mut rows).unwrap();
        let film = line().problem().scales.film;
        let last = *rows.rows.last().unwrap();
        [last.force, last.approach / film]
    };
    let [[bare, _], [shared, near]] = [0.0, 1.0].map(of);
    assert_relative_eq!(bare, 1.1, max_relative = 1e-3);
    // The spring carries the rest of the load.
    assert!(shared < 1.09, "{shared}");
    assert_relative_eq!(shared + near, 1.1, max_relative = 1e-3);
}

/// A damped mass that falls from a gap.
fn falling() -> Conditions {
    Conditions {
        approach: Approach::Body(Mover {
            mass: 0.05,
            damping: 0.5,
            stiffness: 0.0,
        }),
        start: Start::Apart {
            gap: 0.5,
            velocity: 0.0,
        },
        ..steady(16.0)
    }
}

/// If steps would have to be shorter than allowed, the run stops and reports how far it came; instants reported until then remain valid.
#[test]
fn time_that_ends_early_says_how_far_it_came() {
    let conditions = falling();
    let params = Params {
        smallest_step: 0.02,
        ..params(1e-3)
    };
    let mut rows = Rows {
        rows: Vec::new(),
        quiet: NoObserver,
    };
    let end = march(line().problem(), &conditions, &params, &mut rows);
    let Err(TransientError::Stuck {
        time,
        duration,
        info,
        ..
    }) = end
    else {
        panic!("{end:?}");
    };
    assert_relative_eq!(duration, 16.0);
    assert_eq!(rows.rows.len(), info.steps + 1);
    let last = rows.rows.last().unwrap();
    assert!(last.time == time && time < 16.0);
    assert!(info.refused > 0);
}
