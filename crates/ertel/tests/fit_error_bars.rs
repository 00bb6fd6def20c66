//! Intervals of fitted constants, widened by the error bars of the films, against fits to films that are moved.

use ertel::contact::Family;
use ertel::fit::{FilmFit, FilmForm, FilmKind, FilmState, Films, fit_film};

/// Films over M and L (or over the speed alone) that scatter by some per cent, with separate error bars.
fn states(form: FilmForm, truth: &[f64]) -> Vec<FilmState> {
    let mut states = Vec::new();
    for (i, load) in [20.0, 60.0, 200.0, 900.0].into_iter().enumerate() {
        for (k, material) in [1.0, 4.0, 12.0].into_iter().enumerate() {
            let n = (3 * i + k) as f64;
            let mut state = FilmState {
                film: 1.0,
                scale: if form == FilmForm::Speed { 1.0 } else { 2e-8 },
                variables: vec![load, material],
                error: Some(0.004 + 0.001 * n),
            };
            state.variables.truncate(form.variables().len());
            state.film = form.film(truth, &state) * (0.01 * (2.7 * n).sin()).exp();
            states.push(state);
        }
    }
    states
}

fn fitted(form: FilmForm, states: Vec<FilmState>) -> FilmFit {
    let films = Films {
        form,
        kind: FilmKind::Central,
        states,
        warnings: Vec::new(),
    };
    fit_film(&films, 0.95).unwrap()
}

/// Half an interval is widened by Σ|∂x/∂ln h_i| e_i, the derivatives by fits to films of which one is moved by ±1e-4. Factors and all constants of the
/// blend are known by their logarithms. The power laws are linear in them; of the blend, derivatives at the minimum neglect the
/// scatter times the curvature, a few per cent.
#[test]
fn error_bars_come_on_top_of_the_scatter() {
    let blend = FilmForm::Blend(Family::Point);
    for (form, truth, off) in [
        (FilmForm::Speed, &[4.5e-8, 0.67][..], 1e-6),
        (FilmForm::Moes, &[2.2, -0.13, 0.3], 1e-6),
        (blend, &[3.0, 1.7, 1.5], 0.1),
    ] {
        let states = states(form, truth);
        let fit = fitted(form, states.clone());
        let scaled = |i: usize, v: f64| if i == 0 || form == blend { v.ln() } else { v };
        let values = |states: Vec<FilmState>| -> Vec<f64> {
            let values = fitted(form, states).values().into_iter().enumerate();
            values.map(|(i, v)| scaled(i, v)).collect()
        };
        let mut moved = vec![0.0; truth.len()];
        for (k, state) in states.iter().enumerate() {
            let shifted = |by: f64| {
                let mut states = states.clone();
                states[k].film *= f64::exp(by);
                values(states)
            };
            let ends = shifted(1e-4).into_iter().zip(shifted(-1e-4));
            for (sum, (up, down)) in moved.iter_mut().zip(ends) {
                *sum += (up - down).abs() / 2e-4 * state.error.unwrap();
            }
        }
        let widened = fit.widened.as_ref().expect("every film has an error bar");
        for i in 0..truth.len() {
            let half = |[low, high]: [f64; 2]| 0.5 * (scaled(i, high) - scaled(i, low));
            let plain = half(fit.constants[i].unwrap().interval);
            let wide = half(widened[i].unwrap());
            assert!(plain > 0.0 && moved[i] > 0.1 * plain, "{form:?} {i}");
            assert!(
                ((wide - plain) / moved[i] - 1.0).abs() < off,
                "{form:?} {i}: {plain} {wide} {}",
                moved[i]
            );
        }
    }
}
