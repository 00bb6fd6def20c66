//! Newton's method on the coupled system: its two linear solvers agree, it converges
//! quadratically, and its effort and results repeat.

use crate::common;

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use ertel::case::Case;
use ertel::contact::ContactKind;
use ertel::engine::{NoObserver, Observer, SolveError};
use ertel::params::Method;
use ertel::params::{ElasticModel, LinearSolver};
use ertel::run::{problem, solve};
use ertel::solution::Role;
use ertel::solution::{IterationRecord, Solution};
use ertel::solve::contact_surface::ContactSurface;
use ertel::solve::sequence::{Problem, StageSolution, solve_stages};
use ertel_fem::linear::NEVER;
use ertel_rheology::shear::{Carreau, ShearLaw, ShearThinning};

/// A contact that a small mesh resolves: M = 90 (line), M = 20 (circular).
fn small_case(kind: ContactKind) -> Case {
    let load = if kind == ContactKind::Line { 3e5 } else { 10.0 };
    let mut case = common::case(kind, load);
    case.body_1.elasticity = common::GLASS;
    case.solver.tolerance = 1e-11;
    if kind == ContactKind::Circular {
        case.mesh.hertz_size = 0.4;
        case.mesh.constriction_size = 0.3;
        case.mesh.edge_size = 1.0;
        case.mesh.elastic_order = Some(1);
        case.mesh.pressure_order = 2;
        // Not as far as a film this thick asks for: few cells.
        case.mesh.outlet = Some(2.0);
    }
    case
}

/// The same between sliding surfaces, with a fluid that stress thins a hundredfold. With β_c = 2 its flow is smooth;
/// with others it has a corner of order β_c + 1 where the stress passes zero, and Newton's method the order β_c − 1.
fn thinned(case: Case) -> Case {
    let carreau = Carreau::new(1e5, 0.5, 2.0, 0.01).unwrap();
    let mut case = case;
    case.lubricant.shear_thinning = Some(ShearThinning::of(ShearLaw::Carreau(carreau)));
    case.motion.slide_to_roll_ratio = 0.2;
    case
}

/// Its problem on the fine mesh alone: start and solution.
fn one_mesh(case: &Case) -> Problem {
    let mut problem = problem(case);
    let sizes = problem.plan.stages.last().unwrap().sizes;
    problem.plan.stages.retain(|s| s.role != Role::Estimate);
    for stage in &mut problem.plan.stages {
        stage.sizes = sizes;
    }
    problem
}

/// A case on one equivalent finite-element body.
fn on_a_body(case: Case) -> Case {
    let mut case = case;
    case.solver.elasticity = Some(ElasticModel::Equivalent);
    case
}

fn largest_difference(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    (a.iter().zip(b)).fold(0.0, |m, (a, b)| m.max((a - b).abs()))
}

/// Condensed and monolithic Newton end at the same solution of the same discrete equations.
///
/// Habchi 2008, eq. 3.22.
#[test]
fn condensed_path_equals_monolithic_path() {
    for kind in [ContactKind::Line, ContactKind::Circular] {
        for elasticity in [ElasticModel::Equivalent, ElasticModel::TwoBodies] {
            let mut case = small_case(kind);
            case.solver.elasticity = Some(elasticity);
            let solution = |linear: LinearSolver| -> StageSolution {
                let mut case = case.clone();
                case.solver.linear = linear;
                solve_stages(&one_mesh(&case), &mut NoObserver).unwrap().0
            };
            let [a, b] = [LinearSolver::Condensed, LinearSolver::Monolithic].map(solution);
            let (a, b) = (a.state, b.state);
            let pressure = largest_difference(&a.pressure, &b.pressure);
            let deflection = largest_difference(&a.deflection, &b.deflection);
            let separation = (a.rigid_separation - b.rigid_separation).abs();
            println!(
                "{kind:?} {elasticity:?}: P {pressure:.1e}, deflection {deflection:.1e}, H0 {separation:.1e}"
            );
            assert!(pressure < 1e-9 && deflection < 1e-9 && separation < 1e-9);
        }
    }
}

/// Keeps the iterations of the final stage.
#[derive(Default)]
struct LastLevel(Vec<IterationRecord>);

impl Observer for LastLevel {
    fn level(&mut self, _: usize, _: usize, _: usize, _: usize) {
        self.0.clear();
    }
    fn iteration(&mut self, record: &IterationRecord) {
        self.0.push(record.clone());
    }
}

/// Updates u_k of the last iterations: order ln(u_(k+1)/u_k)/ln(u_k/u_(k−1)) is 2 while the updates
/// lie between the nonlinear start and what linear solves leave; a Jacobian that is wrong by a per cent has
/// order 1.
///
/// Theory: How it is solved.
#[test]
fn newton_converges_quadratically() {
    use ElasticModel::{Equivalent, HalfSpace};
    use LinearSolver::{Condensed, Monolithic};
    for (kind, elasticity, linear, thins) in [
        (ContactKind::Line, HalfSpace, Condensed, false),
        (ContactKind::Line, Equivalent, Condensed, false),
        (ContactKind::Line, Equivalent, Monolithic, false),
        (ContactKind::Circular, HalfSpace, Condensed, false),
        (ContactKind::Circular, Equivalent, Condensed, false),
        (ContactKind::Circular, Equivalent, Monolithic, false),
        (ContactKind::Line, Equivalent, Monolithic, true),
        (ContactKind::Circular, Equivalent, Monolithic, true),
    ] {
        let mut case = small_case(kind);
        case.solver.elasticity = Some(elasticity);
        if thins {
            case = thinned(case);
        }
        case.solver.linear = linear;
        let mut last = LastLevel::default();
        let mut problem = one_mesh(&case);
        problem.plan.newton.foresight = false; // to the last update
        solve_stages(&problem, &mut last).unwrap();
        let updates: Vec<f64> = (last.0.iter().map(|r| r.update))
            .filter(|u| *u > 1e-10)
            .collect();
        let [.., a, b, c] = updates[..] else {
            panic!("too few iterations")
        };
        let order = (c / b).ln() / (b / a).ln();
        println!(
            "{kind:?} {elasticity:?} {linear:?} thins: {thins}: {a:.1e} -> {b:.1e} -> {c:.1e}, order {order:.2}"
        );
        // Single steps scatter upward: an update can be small by chance.
        assert!(c < 1e-5 && order > 1.7, "{updates:?}");
    }
}

/// Newton iterations, Krylov iterations and factorisations of every level.
fn effort(s: &Solution) -> Vec<[usize; 3]> {
    (s.stats.levels.iter())
        .map(|l| [l.newton_iterations, l.krylov_iterations, l.factorisations])
        .collect()
}

/// Cold start on the coarse preset: the effort is pinned, a second run repeats every bit. Krylov
/// iterations may differ by 3 %: the last digits of a dense product depend on the processor's vector
/// instructions, and a residual may pass its tolerance one iteration sooner or later.
fn pinned(case: &Case, expected: &[[usize; 3]]) {
    let [a, b] = [(); 2].map(|()| solve(case, &mut NoObserver).unwrap());
    assert_eq!(a.surface, b.surface);
    assert_eq!(a.centreline, b.centreline);
    assert_eq!(a.history, b.history);
    assert_eq!(a.summary, b.summary);
    let effort = effort(&a);
    println!("Newton, Krylov, factorisations: {effort:?}");
    assert_eq!(effort.len(), expected.len());
    for (ours, pin) in effort.iter().zip(expected) {
        assert_eq!(
            (ours[0], ours[2]),
            (pin[0], pin[2]),
            "Newton, factorisations"
        );
        let difference = ours[1].abs_diff(pin[1]) as f64;
        assert!(difference <= 0.03 * pin[1] as f64, "Krylov {effort:?}");
    }
}

/// Other threads of the process change no bit of a result: sums are taken in a fixed
/// order, and the elimination order is drawn under a lock.
#[test]
fn results_repeat_during_other_solves() {
    let case = on_a_body(common::case(ContactKind::Line, 3e5));
    let alone = solve(&case, &mut NoObserver).unwrap();
    let done = AtomicBool::new(false);
    std::thread::scope(|scope| {
        scope.spawn(|| {
            let other = problem(&on_a_body(common::case(ContactKind::Line, 2e5)));
            while !done.load(Ordering::Relaxed) {
                let sizes = other.plan.stages[0].sizes;
                ContactSurface::new(
                    &other.shape,
                    &other.extents,
                    &sizes,
                    &other.elasticity,
                    NEVER,
                )
                .unwrap();
            }
        });
        let repeats: Vec<bool> = (0..15)
            .map(|_| solve(&case, &mut NoObserver).is_ok_and(|s| s.summary == alone.summary))
            .collect();
        done.store(true, Ordering::Relaxed);
        assert!(repeats.iter().all(|same| *same), "{repeats:?}");
    });
}

/// On one thread and on two: the same to 1e-10 of the largest.
#[test]
fn results_do_not_depend_on_the_number_of_threads() {
    for kind in [ContactKind::Line, ContactKind::Circular] {
        for case in [small_case(kind), on_a_body(small_case(kind))] {
            let [a, b] = [1, 2].map(|n| {
                let pool = rayon::ThreadPoolBuilder::new().num_threads(n).build();
                pool.unwrap()
                    .install(|| solve(&case, &mut NoObserver).unwrap())
            });
            let scale = |v: &[f64]| v.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
            for (a, b) in [
                (&a.surface.pressure, &b.surface.pressure),
                (&a.surface.film_thickness, &b.surface.film_thickness),
            ] {
                assert!(largest_difference(a, b) < 1e-10 * scale(a));
            }
            assert_eq!(effort(&a), effort(&b));
        }
    }
}

#[test]
fn effort_on_half_spaces() {
    let by_elements = |kind, load| {
        let mut case = common::case(kind, load);
        case.solver.method = Some(Method::FiniteElements);
        case
    };
    pinned(
        &by_elements(ContactKind::Line, 3e5),
        &[[5, 65, 2], [3, 25, 1], [6, 72, 1]],
    );
    pinned(
        &by_elements(ContactKind::Circular, 100.0),
        &[[7, 89, 5], [9, 190, 7], [8, 83, 3]],
    );
}

#[test]
fn effort_of_a_line_contact() {
    pinned(
        &on_a_body(common::case(ContactKind::Line, 3e5)),
        &[[5, 58, 2], [5, 44, 1], [5, 35, 1]],
    );
}

#[test]
fn effort_of_a_circular_contact() {
    pinned(
        &on_a_body(common::case(ContactKind::Circular, 100.0)),
        &[[8, 111, 6], [6, 119, 5], [8, 96, 4]],
    );
}

/// Start and film of the Newtonian fluid on the coarse mesh, then the fluid itself on both.
#[test]
fn effort_of_shear_thinning_contacts() {
    pinned(
        &thinned(on_a_body(common::case(ContactKind::Line, 3e5))),
        &[[5, 58, 2], [8, 83, 1], [9, 97, 2], [3, 23, 1]],
    );
    pinned(
        &thinned(on_a_body(common::case(ContactKind::Circular, 100.0))),
        &[[8, 111, 6], [11, 170, 7], [11, 121, 4], [9, 148, 5]],
    );
}

/// Wants to stop when asked for the second time, and sees whether a mesh was finished.
#[derive(Default)]
struct Impatient {
    asked: AtomicUsize,
    meshed: bool,
}

impl Observer for Impatient {
    fn level(&mut self, _: usize, _: usize, _: usize, _: usize) {
        self.meshed = true;
    }
    fn cancelled(&self) -> bool {
        self.asked.fetch_add(1, Ordering::Relaxed) > 0
    }
}

/// The user need not wait for the elastic operator: asked once before the stage, then between fronts.
#[test]
fn a_wish_to_stop_is_heard_inside_the_factorisation() {
    for kind in [ContactKind::Line, ContactKind::Circular] {
        let mut observer = Impatient::default();
        let outcome = solve(&on_a_body(small_case(kind)), &mut observer);
        assert!(matches!(outcome, Err(SolveError::Interrupted)));
        assert!(!observer.meshed, "the operator was finished first");
    }
}
