use super::*;
use crate::solution::{ErrorEstimate, Figure, Reading};
use crate::solve::bars::tests::level;
use crate::solve::sequence::Role;

const TARGET: f64 = 2e-3;
const N: usize = 1000;

/// A mesh whose films err by `films` and whose pressures by `pressure`, with the shares in different elements.
fn refinement_at(films: f64, pressure: f64) -> Option<Refinement> {
    let figures = [Figure::FilmCentral, Figure::FilmMinimum].map(|f| (f, Reading::new(1e-7)));
    let mut level = level(N, Role::Final, &figures);
    level.n_displacement_dofs = 0;
    level.estimate = Some(ErrorEstimate {
        films: [films; 2],
        ..ErrorEstimate::default()
    });
    let shares = |share: f64, elements: std::ops::Range<usize>| -> Vec<f64> {
        let n = elements.len() as f64;
        (0..N)
            .map(|c| {
                if elements.contains(&c) {
                    share / n
                } else {
                    0.0
                }
            })
            .collect()
    };
    let indicator = Indicator {
        central: shares(films, 0..100),
        minimum: shares(films, 0..100),
        pressure: shares(pressure * pressure, 900..1000),
        ..Indicator::default()
    };
    let params = AdaptParams::new(TARGET, Some(3.5 * TARGET), 100 * N);
    next_refinement(&params, 2, &[level], [SMALLEST_ERROR; 2], 0, &indicator)
}

/// Films that err too much are refined for alone, however wrong the pressure; then the pressure alone; then nothing.
#[test]
fn films_come_before_the_pressure() {
    let halved = |refinement: &Refinement, elements: std::ops::Range<usize>| {
        refinement.halvings[elements].iter().any(|h| *h > 0)
    };
    let first = refinement_at(1e-3, 0.1).unwrap();
    assert!(!first.for_pressure_alone);
    assert!(halved(&first, 0..100) && !halved(&first, 100..N));
    let second = refinement_at(1e-5, 0.1).unwrap();
    assert!(second.for_pressure_alone);
    assert!(halved(&second, 900..N) && !halved(&second, 0..900));
    assert!(refinement_at(1e-5, 1e-3).is_none());
}
