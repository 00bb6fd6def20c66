//! Evaluation of a film by either engine: the table of finite elements against the fields at any place, and a film without
//! elements.

use std::f64::consts::PI;
use std::sync::Arc;

use approx::assert_relative_eq;
use ertel::engine::friction::friction;
use ertel::engine::{Film, Point, PointFields, PointTable};
use ertel::problem::problem;
use ertel::solve::contact_surface::ContactSurface;
use ertel::solve::discretisation::Discretisation;
use ertel::solve::evaluated::Evaluated;
use ertel::solve::sequence::Problem;
use ertel::solve::state::State;
use ertel_fem::linear::NEVER;

use super::{BALL, COARSE, case};

const EDGES: &str = "inlet = -5\noutlet = 5\nside = 5\n";

fn problem_with(motion: &str) -> Problem {
    problem(&case(BALL, motion, &format!("{COARSE}{EDGES}")))
}

/// Rows of the table are the fields at their places; H is H_0 + ½r² + δ there; areas come to that of the contact area, and to the half disc
/// within the bodies.
#[test]
fn rows_are_the_fields_at_their_places() {
    let mut problem = problem_with("slide_to_roll_ratio = 0.0");
    problem.shape.ends = [3.0; 2];
    let stage = problem.plan.stages.last().unwrap();
    let (shape, extents) = (&problem.shape, &problem.extents);
    let contact = ContactSurface::new(shape, extents, &stage.sizes, &problem.elasticity, NEVER);
    let d = Discretisation::new(&Arc::new(contact.unwrap()), stage.pressure_order);
    let deflection = |p: &[f64; 3]| 0.1 * p[0] - 0.02 * p[0] * p[1];
    let state = State {
        pressure: (d.pressure.points.iter())
            .map(|p| 1.0 + p[0] * p[1])
            .collect(),
        deflection: (d.contact.deflection.points.iter())
            .map(deflection)
            .collect(),
        rigid_separation: 0.4,
        temperature: Vec::new(),
    };
    let film = Evaluated::new(shape, &problem.entrainment, &d, &state);
    let (mut area, mut inside) = (0.0, 0.0);
    for Point {
        area: own,
        within,
        in_zone,
        fields,
    } in film.points().iter()
    {
        let [x, y] = fields.place;
        let there = film.at(fields.place).unwrap();
        assert_relative_eq!(there.pressure, fields.pressure, epsilon = 1e-9);
        assert_relative_eq!(there.film, fields.film, epsilon = 1e-9);
        assert_relative_eq!(fields.pressure, 1.0 + x * y, epsilon = 1e-9);
        assert_relative_eq!(fields.pressure_gradient[0], y, epsilon = 1e-8);
        assert_relative_eq!(fields.pressure_gradient[1], x, epsilon = 1e-8);
        let gap = 0.5 * (x * x + y * y);
        assert_relative_eq!(fields.gap, gap, epsilon = 1e-9);
        let h = 0.4 + gap + deflection(&[x, y, 0.0]);
        assert_relative_eq!(fields.film, h, epsilon = 1e-9);
        assert_eq!(*in_zone, x.hypot(y) < 1.0);
        area += own;
        inside += own * within[0];
    }
    assert_relative_eq!(area, 50.0, max_relative = 1e-9);
    assert_relative_eq!(inside, 4.5 * PI, max_relative = 1e-3);
}

/// A rigid paraboloid H = H_0 + ½r² on rings around the centre.
struct Rings {
    least: f64,
    points: PointTable,
}

impl Rings {
    fn fields(least: f64, place: [f64; 2]) -> PointFields {
        let gap = 0.5 * (place[0] * place[0] + place[1] * place[1]);
        PointFields {
            place,
            gap,
            film: least + gap,
            ..PointFields::default()
        }
    }

    /// Up to a radius, by the midpoint rule, where bodies end at `end`.
    fn new(least: f64, radius: f64, end: f64) -> Rings {
        let (rings, angles) = (500, 16);
        let of_ring = |i: usize| -> Vec<Point> {
            let width = radius / rings as f64;
            let r = (i as f64 + 0.5) * width;
            (0..angles)
                .map(|k| {
                    let (s, c) = (2.0 * PI * k as f64 / angles as f64).sin_cos();
                    Point {
                        area: r * width * 2.0 * PI / angles as f64,
                        within: [end, 0.5 * end].map(|end| f64::from(u8::from(r < end))),
                        in_zone: r < 1.0,
                        fields: Rings::fields(least, [r * c, r * s]),
                    }
                })
                .collect()
        };
        Rings {
            least,
            points: PointTable::new((0..rings).map(of_ring).collect()),
        }
    }
}

impl Film for Rings {
    fn points(&self) -> &PointTable {
        &self.points
    }

    fn at(&self, place: [f64; 2]) -> Option<PointFields> {
        Some(Rings::fields(self.least, place))
    }
}

/// Pure spin and sliding of it between bodies that end at l: as in `shear`, by
///
/// ```text
///   M = 4πμΔω a²R [S − H_0 ln(1 + S/H_0)],  F = 2πμΔu R ln(1 + S/H_0),  S = (l/a)²/2
/// ```
#[test]
fn friction_of_a_film_without_elements() {
    let mut problem = problem_with(
        "slide_to_roll_ratio = 0.1\nbody_1_spin = \"-400 rad/s\"\nbody_2_spin = \"500 rad/s\"",
    );
    let (h, end) = (0.5, 3.0);
    problem.shape.ends = [end; 2];
    let found = friction(&problem, &problem.fluid, &Rings::new(h, 5.0, end));
    let (a, radius, reach) = (problem.scales.length, 0.01, 0.5 * end * end);
    let log = (1.0 + reach / h).ln();
    let moment = 4.0 * PI * 0.04 * 900.0 * a * a * radius * (reach - h * log);
    let force = 2.0 * PI * 0.04 * 0.1 * radius * log;
    assert!(found.is_cut);
    assert_relative_eq!(found.here.moment[0], moment, max_relative = 1e-4);
    assert_relative_eq!(found.here.force[0], force, max_relative = 1e-4);
    let power = 0.1 * force + 900.0 * moment;
    assert_relative_eq!(found.here.work, power, max_relative = 1e-4);
    assert_relative_eq!(found.here.dissipation, power, max_relative = 1e-4);
    assert_relative_eq!(found.power_misfit(), 0.0, epsilon = 1e-9 * power);
}
