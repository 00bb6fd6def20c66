//! Sums of the shear over films that are written down, against closed forms and an independent quadrature.

use std::f64::consts::PI;

use crate::common::near;
use approx::assert_relative_eq;
use ertel::case::Case;
use ertel::contact::Planar;
use ertel::engine::friction::{Frictions, friction};
use ertel::engine::region::Region;
use ertel::problem::problem;
use ertel::solve::discretisation::Discretisation;
use ertel::solve::evaluated::Evaluated;
use ertel::solve::region::Elements;
use ertel::solve::sequence::Problem;
use ertel::solve::state::State;

use super::{BALL, COARSE, case, discretisation};
use crate::common::text::read;

const LINE: &str = "kind = \"line\"\nradius = \"10 mm\"\nload = \"50 kN/m\"";
const MESH: &str = "[mesh]\npreset = \"coarse\"\ninlet = -5\noutlet = 5\nside = 5\n";
const LINE_MESH: &str = "[mesh]\npreset = \"coarse\"\ninlet = -5\noutlet = 5\n";

/// A rigid film of the least thickness `film` with a pressure P(X, Y), between bodies that end at `ends`.
struct Film {
    problem: Problem,
    d: Discretisation,
    state: State,
}

impl Film {
    fn new(case: &Case, ends: [f64; 2], film: f64, pressure: impl Fn([f64; 2]) -> f64) -> Film {
        let mut problem = problem(case);
        problem.shape.ends = ends;
        let stage = problem.plan.stages.last().unwrap();
        let d = discretisation(&problem, stage);
        let state = State {
            pressure: (d.pressure.points.iter())
                .map(|p| pressure([p[0], p[1]]))
                .collect(),
            deflection: vec![0.0; d.contact.deflection.n_nodes()],
            rigid_separation: film,
            temperature: Vec::new(),
        };
        Film { problem, d, state }
    }

    fn sums(&self) -> Frictions {
        // Full of oil everywhere: no stream leaves it.
        let film = Evaluated::new(
            &self.problem.shape,
            &Planar::default(),
            &self.d,
            &self.state,
        );
        friction(&self.problem, &self.problem.fluid, &film)
    }
}

/// Pure spin and sliding of a rigid paraboloid h = h_0 + r²/2R up to the radius l, isoviscous:
///
/// ```text
///   M = 4πμΔω a²R [S − H_0 ln(1 + S/H_0)],  F = 2πμΔu R ln(1 + S/H_0),  S = (l/a)²/2,  power = F Δu + M Δω
/// ```
/// They end where the bodies do, though the film goes on.
///
/// Theory: Where the sums end.
#[test]
fn a_paraboloid_that_spins() {
    let motion =
        "slide_to_roll_ratio = 0.1\nbody_1_spin = \"-400 rad/s\"\nbody_2_spin = \"500 rad/s\"";
    let case = case(BALL, motion, MESH);
    let (h, end) = (0.5, 3.0);
    let film = Film::new(&case, [end; 2], h, |_| 0.0);
    let (a, radius) = (film.problem.scales.length, 0.01);
    let reach = 0.5 * end * end;
    let log = (1.0 + reach / h).ln();
    let moment = 4.0 * PI * 0.04 * 900.0 * a * a * radius * (reach - h * log);
    let force = 2.0 * PI * 0.04 * 0.1 * radius * log;
    let f = film.sums();
    assert!(f.is_cut);
    assert_relative_eq!(f.here.moment[0], moment, max_relative = 2e-3);
    assert_relative_eq!(f.here.force[0], force, max_relative = 2e-3);
    assert_relative_eq!(f.here.coefficients[1][0], force / 20.0, max_relative = 2e-3);
    let power = 0.1 * force + 900.0 * moment;
    assert_relative_eq!(f.here.work, power, max_relative = 2e-3);
    assert_relative_eq!(f.here.dissipation, power, max_relative = 2e-3);
    // The whole square has more than three times as much, two half-widths much less: the bar shows this.
    assert!(f.whole.moment[0] > 3.0 * moment);
    let near = 4.0 * PI * 0.04 * 900.0 * a * a * radius * (2.0 - h * 5.0_f64.ln());
    assert_relative_eq!(f.shorter.moment[0], near, max_relative = 2e-3);
    // Bodies that reach beyond the edges: around the square the gap is full before the contact alone.
    let open = Film::new(&case, [8.0; 2], h, |_| 0.0).sums();
    assert!(!open.is_cut && open.ends_with_bodies);
    assert_eq!(open.here, open.whole);
    let full = 4.0 * PI * 0.04 * 900.0 * a * a * radius * (32.0 - h * 65.0_f64.ln());
    let [here, square] = [open.here, f.whole].map(|sums| sums.moment[0]);
    assert!(square + 0.5 * (full - square) < here && here < full);
}

/// Sliding, spin and slopes of the pressure in an ellipse: forces, moment, work of both surfaces and dissipation from their definitions in
/// SI, summed over rings of the ellipse; the offset of the load and the rolling force over the square, by hand.
#[test]
fn sums_agree_with_a_separate_quadrature() {
    let motion = "slide_to_roll_ratio = 0.1\nslide_to_roll_ratio_across = -0.05\n\
                  body_1_spin = \"-400 rad/s\"\nbody_2_spin = \"500 rad/s\"";
    let case = case(BALL, motion, MESH);
    let (h_0, c, ends) = (0.5, 0.01, [3.0, 2.0]);
    let pressure = |[x, y]: [f64; 2]| c * (1.0 + 0.1 * x * y + 0.05 * x);
    let film = Film::new(&case, ends, h_0, pressure);
    let scales = film.problem.scales;
    let (a, p_h, unit) = (scales.length, scales.pressure, scales.film);
    let n = 400;
    let (mut forces, mut moment, mut work, mut dissipation, mut area) =
        ([[0.0; 2]; 3], 0.0, 0.0, 0.0, 0.0);
    for i in 0..n {
        let s = (f64::from(i) + 0.5) / f64::from(n);
        for k in 0..n {
            let t = 2.0 * PI * (f64::from(k) + 0.5) / f64::from(n);
            let at = [ends[0] * s * t.cos(), ends[1] * s * t.sin()];
            let da = ends[0] * ends[1] * s / f64::from(n) * 2.0 * PI / f64::from(n) * a * a;
            let [x, y] = at.map(|x| x * a);
            let h = unit * (h_0 + 0.5 * (at[0] * at[0] + at[1] * at[1]));
            let mu = 0.04 * (10e-9 * p_h * pressure(at)).exp();
            let slope = [0.1 * at[1] + 0.05, 0.1 * at[0]].map(|s| c * s * p_h / a);
            let one = [0.95 + 400.0 * y, 0.025 - 400.0 * x];
            let two = [1.05 - 500.0 * y, -0.025 + 500.0 * x];
            let mid = [0, 1].map(|i: usize| mu * (two[i] - one[i]) / h);
            let walls = [-0.5, 0.5].map(|z| [0, 1].map(|i: usize| mid[i] + z * h * slope[i]));
            for (sum, stress) in forces.iter_mut().zip([mid, walls[0], walls[1]]) {
                for i in 0..2 {
                    sum[i] += da * stress[i];
                }
            }
            moment += da * (x * mid[1] - y * mid[0]);
            area += da;
            for i in 0..2 {
                work += da * (two[i] * walls[1][i] - one[i] * walls[0][i]);
                dissipation += da * mu / h * (two[i] - one[i]).powi(2);
                dissipation += da * h.powi(3) * slope[i].powi(2) / (12.0 * mu);
            }
        }
    }
    let f = film.sums();
    for (found, force) in f.here.coefficients.iter().zip(forces) {
        let size = force[0].hypot(force[1]) / 20.0;
        for i in 0..2 {
            assert_relative_eq!(found[i], force[i] / 20.0, epsilon = 2e-3 * size);
        }
    }
    assert_relative_eq!(f.here.moment[0], moment, max_relative = 2e-3);
    assert_relative_eq!(f.here.work, work, max_relative = 2e-3);
    assert_relative_eq!(f.here.dissipation, dissipation, max_relative = 2e-3);
    // Over the square of 10: ∫PX = 0.05c ∫X², ∫H ∂P/∂X = 0.05c ∫H.
    let square = 100.0 * 25.0 / 3.0;
    let load = scales.load;
    let offset = -0.05 * c * square / load * unit / a;
    let rolling = 0.05 * c * (100.0 * h_0 + square) / load * unit / a;
    assert_relative_eq!(f.offset, offset, max_relative = 1e-9);
    assert_relative_eq!(f.whole.rolling, rolling, max_relative = 1e-9);
    let region = Region::of(&film.problem.shape);
    let elements = Elements::new(&film.d);
    let found: f64 = (0..film.d.contact.n_elements())
        .map(|cell| {
            let share = elements.share(&region, cell);
            let weights = film.d.rule.weights.iter().enumerate();
            let part: f64 = weights.map(|(q, w)| w * share.at(q)).sum();
            part * film.d.contact.maps[cell].determinant
        })
        .sum();
    assert_relative_eq!(found * a * a, area, max_relative = 1e-4);
}

/// Oil that does not fill the gap shears on the share of the area that it wets, θ = H_oil/H where there is no pressure: in a line contact
/// ∫ θ/H dX, and twice that over H for the heat.
#[test]
fn oil_that_does_not_fill_the_gap() {
    let layer = format!("[inlet]\noil_layer = \"1 um\"\n{LINE_MESH}");
    let case = case(LINE, "slide_to_roll_ratio = 0.1", &layer);
    let film = Film::new(&case, [3.0, f64::INFINITY], 0.2, |_| 0.0);
    let scales = film.problem.scales;
    let oil = 1e-6 / scales.film;
    let n = 20_000;
    let integral: f64 = (0..n)
        .map(|i| -3.0 + 6.0 * (f64::from(i) + 0.5) / f64::from(n))
        .map(|x| {
            let h = 0.2 + 0.5 * x * x;
            (oil / h).min(1.0) / h * 6.0 / f64::from(n)
        })
        .sum();
    assert!(oil < 2.0, "{oil}");
    let force = 0.04 * 0.1 * scales.length / scales.film * integral;
    let f = film.sums();
    assert_relative_eq!(f.here.force[0], force, max_relative = 5e-3);
    assert_relative_eq!(f.here.work, 0.1 * force, max_relative = 5e-3);
    assert_relative_eq!(f.here.dissipation, 0.1 * force, max_relative = 5e-3);
}

/// Where nothing slides, stress is at the walls, ½h|∇p|: beyond the limit in the half of the zone where H exceeds that at R²/2.
#[test]
fn shares_beyond_the_limit_include_the_walls() {
    let thinning = "shear_thinning = { law = \"ree-eyring\", tau_0 = \"5 MPa\" }";
    let rest = format!("{thinning}\n{MESH}");
    let case = case(BALL, "slide_to_roll_ratio = 0.0", &rest);
    let fluid = problem(&case).fluid;
    let limit = fluid.newtonian_limits(0.0)[0].unwrap();
    let slope = 2.0 * limit / (0.75 * fluid.stress_scale());
    let film = Film::new(&case, [3.0; 2], 0.5, |[x, _]| {
        0.1 * slope * (10.0 + 10.0 * x).max(-40.0)
    });
    let [first, _] = film.sums().here.beyond;
    assert_relative_eq!(first.unwrap(), 0.5, epsilon = 0.03);
}

/// The power that leaves with the pressure where the bodies end closes the balance of the power, of a line contact whose bodies end close to its
/// Hertz zone, where P is 0.03: without it a good part of the work of the surfaces would be missing.
#[test]
fn power_balances_up_to_the_end_of_the_bodies() {
    use ertel::engine::NoObserver;
    use ertel::solve::sequence::solve_stages;
    let mut case = case(LINE, "slide_to_roll_ratio = 0.02", COARSE);
    case.mesh.target_error = None;
    let mut problem = problem(&case);
    let (solution, _) = solve_stages(&problem, &mut NoObserver).unwrap();
    let (d, state) = (&solution.discretisation, &solution.state);
    let sums = |problem: &Problem| {
        let film = Evaluated::new(&problem.shape, &problem.entrainment, d, state);
        friction(problem, &problem.fluid, &film)
    };
    let whole = sums(&problem);
    assert!(!whole.is_cut && whole.through_end == 0.0);
    problem.shape.ends[0] = 1.2;
    let cut = sums(&problem);
    println!("{whole:?} {cut:?}");
    let size = whole.here.work.abs();
    // Both miss the same part, which the mesh dissipates inside.
    let missed = (cut.power_misfit() - whole.power_misfit()).abs();
    assert!(missed < 2e-3 * size, "{missed} of {size}");
    assert!(
        cut.through_end.abs() > 20.0 * missed,
        "{} {missed}",
        cut.through_end
    );
    // P = F_2 u_2 − F_1 u_1
    let [_, one, two] = whole.here.coefficients.map(|c| 5e4 * c[0]);
    near(whole.here.work, 1.01 * two - 0.99 * one, 1e-9);
    assert_relative_eq!(whole.whole.rolling, whole.offset, max_relative = 1e-3);
}

/// Sums end with the ball of a bearing, whose own radius is less than the reduced one along the groove; reduced radii stand for bodies that
/// are not described.
#[test]
fn bodies_end_with_their_own_radii() {
    let text = "lubricant = \"squalane-pip\"\ntemperature = \"313 K\"\n\
         [machine]\nkind = \"ball-bearing\"\nring = \"inner\"\nball_diameter = \"7.144 mm\"\npitch_diameter = \"54 mm\"\ninner_groove_curvature = 0.54\ncontact_angle = \"15 deg\"\ninner_ring_speed = \"30000 rpm\"\nball_load = \"40 N\"\n\
         [bodies]\nbody_1 = \"steel\"\nbody_2 = \"steel\"\n";
    let ends = |text: &str| {
        let case = read(text);
        let problem = problem(&case);
        problem.shape.ends.map(|end| end * problem.scales.length)
    };
    let [x, y] = ends(text);
    assert_relative_eq!(x, 3.572e-3, max_relative = 1e-12);
    assert_relative_eq!(y, 3.572e-3, max_relative = 1e-12);
    let plain = problem(&case(BALL, "slide_to_roll_ratio = 0.0", ""));
    let [x, y] = plain.shape.ends.map(|end| end * plain.scales.length);
    assert_relative_eq!(x, 0.01, max_relative = 1e-12);
    assert_relative_eq!(y, 0.01, max_relative = 1e-12);
}
