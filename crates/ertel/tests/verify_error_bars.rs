//! Error bars against the same case on much finer meshes: the bar must cover the true value, and must not
//! be too wide to be useful.

use crate::common;

use ertel::contact::ContactKind;
use ertel::engine::NoObserver;
use ertel::params::Method;
use ertel::params::{MeshParams, MeshPreset};
use ertel::run::solve;
use ertel::solution::Estimate;

/// Widest useful bars: a coarse mesh is for a quick look.
const WIDEST_COARSE: f64 = 0.1;
const WIDEST_NORMAL: f64 = 0.04;

/// Relative error and bar of one figure.
fn check(label: &str, figure: Estimate, exact: f64, widest: f64) {
    let error = (figure.value / exact - 1.0).abs();
    let bar = figure.error.expect("an estimate was asked for") / exact;
    println!("{label}: error {error:.1e}, bar {bar:.1e}");
    assert!(
        error < bar,
        "{label}: error {error:.1e} beyond the bar {bar:.1e}"
    );
    assert!(bar < widest, "{label}: bar {bar:.1e}");
}

/// Reference refined to 0.02 %; fixed presets and targets against it.
///
/// Theory: Error estimate.
#[test]
fn line() {
    let kind = ContactKind::Line;
    for (m, l) in [
        (5.0, 0.0),
        (5.0, 10.0),
        (20.0, 5.0),
        (50.0, 10.0),
        (200.0, 0.0),
        (200.0, 2.5),
        (200.0, 10.0),
    ] {
        let mut case = common::moes_case(kind, m, l);
        case.mesh = MeshParams::adaptive(2e-4, kind);
        let exact = solve(&case, &mut NoObserver).unwrap();
        for (mesh, widest) in [
            (MeshParams::preset(MeshPreset::Coarse, kind), WIDEST_COARSE),
            (MeshParams::preset(MeshPreset::Normal, kind), WIDEST_NORMAL),
            (MeshParams::adaptive(1e-2, kind), 1e-2),
            (MeshParams::adaptive(2e-3, kind), 2e-3),
        ] {
            case.mesh = mesh;
            let s = solve(&case, &mut NoObserver).unwrap();
            let label = |name| {
                let mesh = &case.mesh;
                format!(
                    "M = {m}, L = {l}, {:?}, {:?}, {name}",
                    mesh.preset, mesh.target_error
                )
            };
            check(
                &label("h_c"),
                s.summary.film_central,
                exact.summary.film_central.value,
                widest,
            );
            check(
                &label("h_m"),
                s.summary.film_minimum,
                exact.summary.film_minimum.value,
                widest,
            );
        }
    }
}

/// References H_c, H_m on the same contact areas, refined to 0.04 % with cells growing by 0.27 with depth,
/// or fixed meshes of 120,000 (M = 200) and 260,000 (M = 50) displacement unknowns: they agree to 4e-4.
///
/// Theory: Error estimate.
#[test]
fn circular() {
    let kind = ContactKind::Circular;
    for (m, l, area, exact) in [
        (200.0, 10.0, [-4.5, 1.5, 3.0], [8.143e-2, 3.887e-2]),
        (50.0, 5.0, [-6.5, 2.0, 4.5], [0.145_43, 9.191e-2]),
    ] {
        for (mesh, widest) in [
            (MeshParams::preset(MeshPreset::Coarse, kind), WIDEST_COARSE),
            // The edges set by hand add up to 0.3 %.
            (MeshParams::adaptive(1e-2, kind), 1.3e-2),
            (MeshParams::adaptive(2e-3, kind), 5e-3),
        ] {
            let mut case = common::moes_case(kind, m, l);
            case.solver.method = Some(Method::FiniteElements);
            let [inlet, outlet, side] = area.map(Some);
            case.mesh = MeshParams {
                inlet,
                outlet,
                side,
                ..mesh
            };
            let s = solve(&case, &mut NoObserver).unwrap();
            let target = case.mesh.target_error;
            let label = |name| format!("M = {m}, L = {l}, {target:?}, {name}");
            let [h_c, h_m] = exact.map(|h| h * s.scales.film);
            check(&label("h_c"), s.summary.film_central, h_c, widest);
            check(&label("h_m"), s.summary.film_minimum, h_m, widest);
        }
    }
}
