//! the thermal film against the film of one temperature, closed forms, Yang and Wen's integrals, and differences.

use approx::assert_relative_eq;
use ertel_rheology::ShearThinning;
use ertel_rheology::shear::{Carreau, ShearLaw, StressLimit};
use num_dual::DualNum;

use super::*;
use crate::film::closure;
use crate::film::fluidity::Thinning;
use crate::film::polynomial::FilmNodes;
use crate::film::thermal::{Jet2, TemperatureProfile, ThermalFluid};

/// ρ̄ and ln μ̄ of a fluid that thins by heat, more so under pressure.
fn properties(p: f64, t: f64) -> [Jet2; 2] {
    let thinning_by_heat = |t: num_dual::Dual2SVec64<2>| (t - 310.0) / 40.0;
    [
        Jet2::of(
            |p, t| (p * 0.3 + 1.0).ln() * 0.5 + 1.0 - thinning_by_heat(t) * 0.03 / (p + 1.0),
            p,
            t,
        ),
        Jet2::of(
            |p, t| {
                p * 4.0 - thinning_by_heat(t) * (p * 0.8 + 1.0) * 1.5
                    + thinning_by_heat(t).powi(2) * 0.2
            },
            p,
            t,
        ),
    ]
}

/// A crooked profile, hotter in the middle, that changes along X and Y.
fn profile(nodes: &FilmNodes) -> TemperatureProfile {
    let mut profile = TemperatureProfile::default();
    for (m, s) in nodes.points().iter().enumerate() {
        profile.temperature[m] = 315.0 + 60.0 * (0.25 - s * s) + 9.0 * s + 8.0 * (4.0 * s).sin();
        profile.slopes[0][m] = 12.0 - 30.0 * s + 20.0 * s * s;
        profile.slopes[1][m] = -7.0 + 25.0 * s;
    }
    profile
}

fn moved(profile: &TemperatureProfile, d: usize, step: f64) -> TemperatureProfile {
    let mut profile = *profile;
    for (t, slope) in profile.temperature.iter_mut().zip(profile.slopes[d]) {
        *t += step * slope;
    }
    profile
}

fn thinning() -> Thinning {
    let carreau = Carreau::new(2e5, 0.4, 2.2, 0.1).unwrap();
    Thinning::new(&ShearThinning::of(ShearLaw::Carreau(carreau)))
}

/// The same below a limit that grows with pressure: a fluidity that depends on it.
fn limited() -> Thinning {
    let carreau = Carreau::new(2e5, 0.4, 2.2, 0.1).unwrap();
    Thinning::new(&ShearThinning {
        law: Some(ShearLaw::Carreau(carreau)),
        limit: Some(StressLimit::new(8e6, 0.02).unwrap()),
    })
}

fn close(
    thinning: Option<&Thinning>,
    fluid: &ThermalFluid,
    p: f64,
    g: [f64; 2],
    slide: [f64; 2],
) -> ThermalClosure {
    let law = ThermalLaw {
        thinning: thinning.map(|t| t.at(p, 1e6, 1e9)),
        fluid,
    };
    close_thermal::<true>(&law, g, slide, &mut CrossFilm::default())
}

/// One temperature: the closure of a film that has one.
#[test]
fn uniform_temperature() {
    let nodes = FilmNodes::new(8);
    let flat = TemperatureProfile {
        temperature: [330.0; 13],
        slopes: [[0.0; 13]; 2],
    };
    let thinning = thinning();
    for (p, g, slide) in [
        (0.4, [0.3, -0.1], [0.0; 2]),
        (0.9, [2.0, 0.7], [5.0, 0.0]),
        (0.9, [2.0, 0.7], [5.0, -1.0]),
        (0.1, [0.02, 0.0], [-0.4, 0.0]),
    ] {
        let fluid = ThermalFluid::new(&nodes, &flat, |t| properties(p, t));
        let thermal = close(Some(&thinning), &fluid, p, g, slide).closure;
        let isothermal = closure::close::<true>(
            &thinning.at(p, 1e6, 1e9),
            g,
            slide,
            &mut CrossFilm::default(),
        );
        for i in 0..2 {
            assert_relative_eq!(
                thermal.mid_stress[i],
                isothermal.mid_stress[i],
                epsilon = 1e-8
            );
            assert_relative_eq!(thermal.flow[i], isothermal.flow[i], epsilon = 1e-8);
            for d in 0..N_DEMANDS {
                assert_relative_eq!(
                    thermal.slopes[i][d],
                    isothermal.slopes[i][d],
                    epsilon = 1e-7
                );
            }
        }
        assert_relative_eq!(
            fluid.point().density[1],
            properties(p, 330.0)[0].p,
            epsilon = 1e-12
        );
    }
}

/// Newtonian film with ln μ = −bs and ρ = 1 + cs, by hand (∫e^{bs}, ∫s e^{bs}, …): the stress, and the mass flow
/// of Yang and Wen's equation (Habchi 2008, eqs. 5.4 and 5.5).
#[test]
fn yang_and_wen() {
    let (b, c) = (1.7, 0.12);
    let nodes = FilmNodes::new(10);
    let mut profile = TemperatureProfile::default();
    for (t, s) in profile.temperature.iter_mut().zip(nodes.points()) {
        *t = 300.0 + s;
    }
    let flat = |value: f64| Jet2 {
        value,
        p: 0.0,
        t: 0.0,
        pp: 0.0,
        pt: 0.0,
    };
    let fluid = ThermalFluid::new(&nodes, &profile, |t| {
        let s = t - 300.0;
        [flat(1.0 + c * s), flat(-b * s)]
    });
    let (g, slide) = ([0.8, -0.3], [0.5, -0.2]);
    let thermal = close(None, &fluid, 0.2, g, slide).closure;
    // Simpson's rule on 2000 intervals for every integral of the thesis
    let integral = |f: &dyn Fn(f64) -> f64, to: f64| -> f64 {
        let n = 2000;
        let h = (to + 0.5) / n as f64;
        let at = |k: usize| f(-0.5 + h * k as f64);
        let inner: f64 = (1..n)
            .map(|k| if k % 2 == 1 { 4.0 } else { 2.0 } * at(k))
            .sum();
        h / 3.0 * (at(0) + inner + at(n))
    };
    let fluidity = |s: f64| (b * s).exp();
    let e0 = integral(&fluidity, 0.5);
    let e1 = integral(&|s| s * fluidity(s), 0.5);
    for i in 0..2 {
        let omega = slide[i];
        let tau = (omega - g[i] * e1) / e0;
        assert_relative_eq!(thermal.mid_stress[i], tau, epsilon = 1e-9);
        // velocity beyond that of the plane, then its mean over the mass
        let rate = |s: f64| (tau + s * g[i]) * fluidity(s);
        let mass = integral(&|s| (1.0 + c * s) * integral(&rate, s), 0.5);
        // ρ_m (½Ω − q) where entrainment is counted with the mean velocity of the surfaces
        assert_relative_eq!(0.5 * omega - thermal.flow[i], mass, epsilon = 1e-7);
    }
}

/// Every derivative against central differences.
#[test]
fn derivatives_match_differences() {
    let nodes = FilmNodes::new(8);
    let base = profile(&nodes);
    for (thinning, p, g, slide) in [
        (thinning(), 0.4, [0.3, -0.1], [0.05, 0.0]),
        (thinning(), 0.8, [1.5, 0.4], [4.0, -1.5]),
        (thinning(), 0.2, [0.6, 0.2], [-1.0, 0.3]),
        (limited(), 0.8, [1.5, 0.4], [4.0, 1.0]),
    ] {
        let reference = ThermalFluid::new(&nodes, &base, |t| properties(p, t));
        // The mean viscosity of the film stays fixed when the temperature changes.
        let at = |x: [f64; N]| {
            let profile = moved(&moved(&base, 0, x[P + 1]), 1, x[P + 2]);
            let mut fluid = ThermalFluid::new(&nodes, &profile, |t| properties(x[P], t));
            let still = ThermalFluid::new(&nodes, &base, |t| properties(x[P], t));
            let shift = (still.viscosity[0] / fluid.viscosity[0]).ln();
            fluid.exponent.by_p[0] = fluid.exponent.by_p[0].plus(shift);
            (
                close(Some(&thinning), &fluid, x[P], [x[0], x[1]], [x[2], x[3]]),
                fluid,
            )
        };
        let here = [g[0], g[1], slide[0], slide[1], p, 0.0, 0.0];
        let (ours, _) = at(here);
        let difference = |d: usize, f: &dyn Fn([f64; N]) -> f64| {
            let step = 1e-5;
            let (mut up, mut down) = (here, here);
            up[d] += step;
            down[d] -= step;
            (f(up) - f(down)) / (2.0 * step)
        };
        let mut drift = 0.0;
        for i in 0..2 {
            for d in 0..N_DEMANDS {
                let slope = difference(d, &|x| at(x).0.closure.flow[i]);
                assert_relative_eq!(
                    ours.closure.slopes[i][d],
                    slope,
                    epsilon = 2e-7,
                    max_relative = 1e-5
                );
                for e in 0..N_DEMANDS {
                    let curvature = difference(e, &|x| at(x).0.closure.slopes[i][d]);
                    let exact = ours.closure.curvatures[i][d][e];
                    assert_relative_eq!(exact, curvature, epsilon = 2e-6, max_relative = 1e-4);
                }
            }
            drift += difference(P + 1 + i, &|x| at(x).0.closure.flow[i]);
        }
        assert_relative_eq!(ours.drift, drift, epsilon = 1e-6, max_relative = 1e-5);
        for d in 0..N_DEMANDS {
            let slope = difference(d, &|x| at(x).0.drift);
            assert_relative_eq!(
                ours.drift_slopes[d],
                slope,
                epsilon = 1e-5,
                max_relative = 1e-4
            );
        }
        for i in 0..2 {
            let slope = difference(P + 1 + i, &|x| at(x).1.density.by_p[0]);
            assert_relative_eq!(reference.density.along[i][0], slope, epsilon = 1e-9);
            let slope = difference(P, &|x| at(x).1.density.along[i][0]);
            assert_relative_eq!(reference.density.along[i][1], slope, epsilon = 1e-8);
        }
        for k in 0..2 {
            let slope = difference(P, &|x| at(x).1.viscosity[k]);
            assert_relative_eq!(reference.viscosity[k + 1], slope, max_relative = 1e-6);
        }
    }
}

/// u = p²t through u³: p⁶t³, with its derivatives.
#[test]
fn functions_of_a_property() {
    let (p, t) = (1.3_f64, 0.7_f64);
    let inner = Jet2 {
        value: p * p * t,
        p: 2.0 * p * t,
        t: p * p,
        pp: 2.0 * t,
        pt: 2.0 * p,
    };
    let u = inner.value;
    let found = inner.through([u.powi(3), 3.0 * u * u, 6.0 * u]);
    for (value, expected) in [
        (found.value, p.powi(6) * t.powi(3)),
        (found.p, 6.0 * p.powi(5) * t.powi(3)),
        (found.t, 3.0 * p.powi(6) * t * t),
        (found.pp, 30.0 * p.powi(4) * t.powi(3)),
        (found.pt, 18.0 * p.powi(5) * t * t),
    ] {
        assert_relative_eq!(value, expected, max_relative = 1e-13);
    }
}
