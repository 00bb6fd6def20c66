//! Error bars against the same case on much finer meshes: the bar must hold the truth, and must not
//! be so wide that it says nothing.

mod common;

use ertel::contact::ContactKind;
use ertel::params::{MeshParams, MeshPreset};
use ertel::run::solve;
use ertel::solution::Estimate;
use ertel::solve::Silent;

/// Widest bars that still tell something: a coarse mesh is for a quick look.
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

/// Reference on cells of 0.4 and 0.3 of the normal preset's, growing by 0.2 instead of 0.3: its own
/// error is near 1e-4, half of the smallest bar.
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
        case.mesh = MeshParams {
            hertz_size: 0.008,
            constriction_size: 0.0016,
            edge_size: 0.15,
            growth: 0.2,
            depth_growth: 0.2,
            ..MeshParams::preset(MeshPreset::Fine, kind)
        };
        let exact = solve(&case, &mut Silent).unwrap();
        for (preset, widest) in [
            (MeshPreset::Coarse, WIDEST_COARSE),
            (MeshPreset::Normal, WIDEST_NORMAL),
        ] {
            case.mesh = MeshParams::preset(preset, kind);
            let s = solve(&case, &mut Silent).unwrap();
            let label = |name| format!("M = {m}, L = {l}, {preset:?}, {name}");
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

/// Coarse preset; references H_c, H_m computed on the same contact areas with cells of 0.09 and, at
/// the constriction, 0.032 (M = 200) or 0.1 and 0.05 (M = 50), all growing by 0.3: good to 5e-4.
#[test]
fn circular() {
    let kind = ContactKind::Circular;
    for (m, l, area, exact) in [
        (200.0, 10.0, [-4.5, 1.5, 3.0], [8.1424e-2, 3.8825e-2]),
        (50.0, 5.0, [-6.5, 2.0, 4.5], [0.145_386, 9.1792e-2]),
    ] {
        let mut case = common::moes_case(kind, m, l);
        let [inlet, outlet, side] = area.map(Some);
        case.mesh = MeshParams {
            inlet,
            outlet,
            side,
            ..case.mesh
        };
        let s = solve(&case, &mut Silent).unwrap();
        let label = |name| format!("M = {m}, L = {l}, {name}");
        let [h_c, h_m] = exact.map(|h| h * s.scales.film);
        check(&label("h_c"), s.summary.film_central, h_c, WIDEST_COARSE);
        check(&label("h_m"), s.summary.film_minimum, h_m, WIDEST_COARSE);
    }
}
