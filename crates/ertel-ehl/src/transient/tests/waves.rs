//! Waves on a sliding body: their squeezing, and the complementary waves from the inlet.

use std::f64::consts::TAU;

use super::*;
use crate::transient::Instant;
use crate::volumes::fields::profile;
use crate::volumes::film::PatchedFilm;

/// Centrelines at the requested instants: T, places, and film and pressure there.
#[derive(Default)]
struct Lines(Vec<(f64, Vec<[f64; 3]>)>, NoObserver);

impl TransientObserver for Lines {
    fn instant(&mut self, instant: &Instant<'_>) {
        // The start is reported, too.
        if instant.is_asked && instant.time > 0.0 {
            let film = PatchedFilm::new(&instant.problem.shape, instant.levels);
            let found = profile(&film);
            let rows = found.x.iter().zip(&found.fields);
            let rows = rows.map(|(x, at)| [*x, at.film, at.pressure]).collect();
            self.0.push((instant.time, rows));
        }
    }

    fn start(&mut self) -> &mut dyn Observer {
        &mut self.1
    }
}

/// Coefficients of functions by least squares, and the residual, root mean square.
fn fitted(rows: &[(Vec<f64>, f64)]) -> (Vec<f64>, f64) {
    let n = rows[0].0.len();
    let mut normal = vec![vec![0.0; n + 1]; n];
    for (own, value) in rows {
        for (a, row) in own.iter().zip(&mut normal) {
            for (b, cell) in own.iter().chain([value]).zip(row.iter_mut()) {
                *cell += a * b;
            }
        }
    }
    for k in 0..n {
        let pivot = normal[k].clone();
        for (i, row) in normal.iter_mut().enumerate() {
            if i != k {
                let factor = row[k] / pivot[k];
                row.iter_mut()
                    .zip(&pivot)
                    .for_each(|(a, b)| *a -= factor * b);
            }
        }
    }
    let found: Vec<f64> = (0..n).map(|k| normal[k][n] / normal[k][k]).collect();
    let residual = rows.iter().map(|(own, value)| {
        let sum: f64 = own.iter().zip(&found).map(|(a, c)| a * c).sum();
        (sum - value).powi(2)
    });
    let residual = (residual.sum::<f64>() / rows.len() as f64).sqrt();
    (found, residual)
}

/// Waves of length λ on a body at the speed v under the entrainment speed u = 2v: in the thick oil of the contact the film follows them, as far as it is not squeezed, a/A = C/(1 + C) and
/// p/A = (E'w/4)/(1 + C), w = 2π/λ, C = h E'w/(4B), B = ρ dp/dρ; they are accompanied only by the films that the waves make in the inlet, at the speed u and so of the length λu/v
/// (Hooke, Proc. IMechE J 220, 2006, 259, for Q → ∞, where these complementary waves do not decay). Both swing at each place with the frequency v/λ.
/// To 6 %: h and B change over the three waves about the centre that are looked at.
#[test]
fn waves_under_sliding_have_companions_at_the_speed_of_the_film() {
    let (wavelength, v) = (0.25, 0.5);
    let speeds = Speeds::Each([v, 2.0 - v].map(Course::Constant));
    let [early, late] = [6.0, 6.07];
    let conditions = Conditions {
        speeds,
        duration: late,
        instants: vec![early, late],
        ..Conditions::default()
    };
    let given = line();
    let modulus = given.reduced_modulus;
    let solved = |waves: Option<f64>| {
        let mut problem = given.problem();
        problem.plan.largest_cell = wavelength / 32.0;
        if let Some(amplitude) = waves {
            problem.shape.gap.add(
                Form::Waves {
                    wavelength,
                    amplitude,
                    direction: 0.0,
                },
                Body::First,
                [-1.75, 0.0],
            );
        }
        let (fluid, scales) = (problem.fluid.clone(), problem.scales);
        let mut lines = Lines::default();
        march(problem, &conditions, &Params::default(), &mut lines).unwrap();
        (lines.0, fluid, scales)
    };
    let (smooth, fluid, scales) = solved(None);
    let at = |rows: &[[f64; 3]], x: f64, which: usize| {
        let rows = rows.iter().map(|row| [row[0], row[which]]).collect();
        Course::Table(rows).at(x)
    };
    let [film, pressure] = [1, 2].map(|which| at(&smooth[0].1, 0.0, which));
    let amplitude = 0.02 * film;
    let (rough, ..) = solved(Some(amplitude));
    let [rho, rho_p, _] = fluid.at(pressure).density;
    let wave = TAU / wavelength;
    let c = film * scales.film * modulus * (wave / scales.length) * rho_p
        / (4.0 * scales.pressure * rho);
    let expected = [
        c / (1.0 + c),
        0.25 * modulus * wave / scales.length / (1.0 + c) * scales.film / scales.pressure,
    ];
    // Waves of both lengths over the flat part of the film, with a parabola for the slow change.
    let parts = |instant: usize, which: usize, companion: f64| {
        let (_, rows) = &rough[instant];
        let inside = rows.iter().filter(|row| row[0].abs() < 0.375);
        let rows: Vec<(Vec<f64>, f64)> = inside
            .map(|row| {
                let x = row[0];
                let waves = [wave * x, companion * x].map(|phase| [phase.cos(), phase.sin()]);
                let own = [waves.concat(), vec![1.0, x, x * x]].concat();
                (own, row[which] - at(&smooth[instant].1, x, which))
            })
            .collect();
        let (found, residual) = fitted(&rows);
        let polar = |k: usize| [found[k].hypot(found[k + 1]), found[k + 1].atan2(found[k])];
        ([polar(0), polar(2)], residual)
    };
    for (which, expected) in [1, 2].into_iter().zip(expected) {
        let ([own, companion], residual) = parts(0, which, wave * v);
        assert_relative_eq!(own[0] / amplitude, expected, max_relative = 0.06);
        // Pressures contain almost none of the complementary waves.
        if which == 2 {
            continue;
        }
        assert!(companion[0] > 0.1 * amplitude, "{companion:?} {own:?}");
        let all = own[0].hypot(companion[0]);
        assert!(residual < 0.05 * all, "{residual:e} {companion:?} {own:?}");
        // Another length does not fit.
        let (_, without) = parts(0, which, wave * v * 1.3);
        assert!(without > 5.0 * residual, "{without:e} {residual:e}");
        let ([own_later, later], _) = parts(1, which, wave * v);
        for [from, to] in [[own, own_later], [companion, later]] {
            let turned = (to[1] - from[1]).rem_euclid(TAU);
            assert_relative_eq!(turned, wave * v * (late - early), max_relative = 0.05);
        }
    }
}
