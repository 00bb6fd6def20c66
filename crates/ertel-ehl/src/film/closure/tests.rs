//! The local problem against closed forms, integration by brute force, and differences.

use crate::near::near;
use approx::assert_relative_eq;

use std::f64::consts::FRAC_PI_2;

use ertel_rheology::Scalar;
use ertel_rheology::shear::{Carreau, ReeEyring, ShearLaw, ShearThinning, StressLimit};
use nalgebra::SVector;
use num_dual::{Dual2SVec64, hessian};

use super::*;
use crate::film::fluidity::{Jet, Thinning, UniformFluidity};

/// Fluidities with closed-form flows, and those with everything at once.
enum Law {
    Newtonian,
    /// γ̇ = τ(1 + (τ/κ)^m)
    Power {
        knee: f64,
        m: f64,
    },
    /// γ̇ = τ₀ sinh(τ/τ₀)
    Eyring {
        stress: f64,
    },
    /// Two plateaus, 1/f = r + (1 − r)/[1 + (τ/κ)^β]^((1/n − 1)/β), κ = κ₀ e^{P}
    Carreau {
        knee: f64,
        n: f64,
        beta: f64,
        r: f64,
    },
}

impl Law {
    fn fluidity<D: Scalar>(&self, x: D, p: D) -> D {
        match *self {
            Law::Newtonian => D::from(1.0),
            Law::Power { knee, m } => (x / (knee * knee) + 1e-30).powf(0.5 * m) + 1.0,
            Law::Eyring { stress } => {
                let t = (x + 1e-24).sqrt() / stress;
                t.sinh() / t
            }
            Law::Carreau { knee, n, beta, r } => {
                let k = p.exp() * knee;
                let thinned =
                    ((x / (k * k) + 1e-14).powf(0.5 * beta) + 1.0).powf((1.0 / n - 1.0) / beta);
                (thinned.recip() * (1.0 - r) + r).recip()
            }
        }
    }

    fn scales(&self, p: f64) -> StressScales {
        let mut scales = StressScales::default();
        match *self {
            Law::Newtonian => {}
            Law::Power { knee, .. } => scales.knee = Some(knee),
            Law::Eyring { stress } => scales.growth = Some(stress),
            Law::Carreau { knee, .. } => scales.knee = Some(knee * p.exp()),
        }
        scales
    }
}

/// A law at P.
struct At<'a>(&'a Law, f64);

impl UniformFluidity for At<'_> {
    fn jet(&self, x: f64) -> Jet {
        let At(law, p) = self;
        let (f, by, second) = hessian(
            |v: SVector<Dual2SVec64<2>, 2>| law.fluidity(v[0], v[1]),
            &SVector::from([x, *p]),
        );
        Jet {
            f,
            x: by[0],
            p: by[1],
            xx: second[(0, 0)],
            xp: second[(0, 1)],
            pp: second[(1, 1)],
        }
    }

    fn depends_on_pressure(&self) -> bool {
        matches!(self.0, Law::Carreau { .. })
    }
}

impl Fluidity for At<'_> {
    fn slope(&self, x: f64) -> [f64; 2] {
        let jet = self.jet(x);
        [jet.f, jet.x]
    }

    fn scales(&self) -> StressScales {
        self.0.scales(self.1)
    }
}

const CARREAU: Law = Law::Carreau {
    knee: 0.01,
    n: 0.4,
    beta: 2.198,
    r: 0.05,
};

/// Directions of the sliding, rad from x.
const DIRECTIONS: [f64; 3] = [0.0, 0.7, -2.0];

fn along(direction: f64, size: f64) -> [f64; 2] {
    match direction {
        0.0 => [size, 0.0],
        _ => [size * direction.cos(), size * direction.sin()],
    }
}

fn closed(law: &Law, p: f64, g: [f64; 2], slide: [f64; 2]) -> Closure {
    close::<true>(&At(law, p), g, slide, &mut CrossFilm::default())
}

/// q = G/12, τ = Ω, whatever the state.
#[test]
fn newtonian() {
    for (g, slide) in [([0.0, 0.0], 0.0), ([3.0, -1.0], 0.5), ([1e-8, 2.0], -1e6)] {
        let exact = Closure::newtonian(g, [slide, 0.4 * slide]);
        let c = closed(&Law::Newtonian, 0.3, g, [slide, 0.4 * slide]);
        for i in 0..2 {
            assert_relative_eq!(
                c.mid_stress[i],
                exact.mid_stress[i],
                epsilon = 1e-9 * slide.abs()
            );
            assert_relative_eq!(
                c.flow[i],
                exact.flow[i],
                max_relative = 1e-12,
                epsilon = 1e-9
            );
            for y in 0..2 {
                assert_relative_eq!(c.slopes[i][y], exact.slopes[i][y], epsilon = 1e-13);
            }
        }
    }
}

/// Rabinowitsch's cubic along one line, by hand: ∫tf = τ + (τ³ + τG²/4)/κ²,
/// ∫stf = G/12 + (3τ²G/12 + G³/80)/κ².
#[test]
fn rabinowitsch_line_flow() {
    let knee = 0.2;
    let law = Law::Power { knee, m: 2.0 };
    for g in [0.01, 0.3, 5.0] {
        for tau in [0.0, 0.02, 1.0, 40.0_f64] {
            let slide = tau + (tau.powi(3) + tau * g * g / 4.0) / (knee * knee);
            let c = closed(&law, 0.0, [g, 0.0], [slide, 0.0]);
            assert_relative_eq!(c.mid_stress[0], tau, max_relative = 1e-10);
            let q = g / 12.0 + (tau * tau * g / 4.0 + g.powi(3) / 80.0) / (knee * knee);
            // q is the small difference of stresses of order Ω
            assert_relative_eq!(c.flow[0], q, max_relative = 1e-10, epsilon = 1e-15 * slide);
        }
    }
}

/// Pure rolling of a power law: ∫|sG|^{m+2} ds/(Gκ^m) = G^{m+1}/[κ^m 2^{m+2}(m + 3)], plus the plateau's G/12.
#[test]
fn power_law_in_pure_rolling() {
    let knee = 1e-3;
    for m in [0.25, 1.0, 1.5, 3.0_f64] {
        let law = Law::Power { knee, m };
        for g in [0.1, 2.0_f64] {
            let c = closed(&law, 0.0, [g, 0.0], [0.0; 2]);
            let thinned = g.powf(m + 1.0) / (knee.powf(m) * 2.0_f64.powf(m + 2.0) * (m + 3.0));
            // |s|^m has a corner in the middle of the film
            assert_relative_eq!(c.flow[0], g / 12.0 + thinned, max_relative = 2e-9);
        }
    }
}

/// Ree-Eyring along one line, τ₀ = 1: Ω = sinh τ · S, S = sinh(G/2)/(G/2);
/// q = cosh τ [cosh(G/2) − S]/G.
#[test]
fn eyring_line_flow() {
    let law = Law::Eyring { stress: 1.0 };
    for g in [0.1, 2.0, 12.0_f64] {
        let s = (0.5 * g).sinh() / (0.5 * g);
        for tau in [0.0, 0.3, 8.0_f64] {
            let c = closed(&law, 0.0, [g, 0.0], [tau.sinh() * s, 0.0]);
            assert_relative_eq!(c.mid_stress[0], tau, max_relative = 1e-10, epsilon = 1e-12);
            let q = tau.cosh() * ((0.5 * g).cosh() - s) / g;
            assert_relative_eq!(c.flow[0], q, max_relative = 1e-10);
        }
    }
}

/// States at random: stresses over ten decades around the knee, both signs of sliding.
fn states() -> Vec<([f64; 2], f64, f64)> {
    let mut seed = 12345_u64;
    let mut random = move || {
        seed = seed
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (seed >> 11) as f64 / (1_u64 << 53) as f64
    };
    (0..60)
        .map(|_| {
            let size = 10.0_f64.powf(-5.0 + 7.0 * random());
            let angle = 6.3 * random();
            let slide =
                10.0_f64.powf(-6.0 + 10.0 * random()) * if random() < 0.5 { 1.0 } else { -1.0 };
            (
                [size * angle.cos(), size * angle.sin()],
                slide,
                random() - 0.5,
            )
        })
        .collect()
}

/// Mean shear rate, flow, and mean size of the shear rate by a midpoint rule with Richardson's extrapolation, in the variable in which
/// the stress passes its smallest value smoothly; independent of the rule under test.
fn brute_force(law: &Law, p: f64, tau: [f64; 2], g: [f64; 2]) -> [f64; 5] {
    let n = 1 << 15;
    let gg = dot(g, g);
    let centre = -dot(tau, g) / gg;
    let width = 1e-3 * 0.01 / gg.sqrt() + 1e-9;
    let far = dot(tau, tau) > 4.0 * gg;
    let ends = [-0.5, 0.5].map(|s: f64| {
        if far {
            s
        } else {
            ((s - centre) / width).asinh()
        }
    });
    let sum = |n: usize| {
        let du = (ends[1] - ends[0]) / n as f64;
        let mut sums = [0.0; 5];
        for k in 0..n {
            let u = ends[0] + (k as f64 + 0.5) * du;
            let (s, slope) = if far {
                (u, 1.0)
            } else {
                (centre + width * u.sinh(), width * u.cosh())
            };
            let t = [tau[0] + s * g[0], tau[1] + s * g[1]];
            let f = law.fluidity(dot(t, t), p) * slope * du;
            for i in 0..2 {
                sums[i] += f * t[i];
                sums[2 + i] += f * t[i] * s;
            }
            sums[4] += f * dot(t, t).sqrt();
        }
        sums
    };
    let (coarse, fine) = (sum(n), sum(2 * n));
    std::array::from_fn(|i| (4.0 * fine[i] - coarse[i]) / 3.0)
}

/// The surfaces slide by Ω, and the flow is right, to 1e-10 of the mean shear rate in the film.
#[test]
fn matches_brute_force() {
    let all = states();
    let all = all.iter().flat_map(|s| DIRECTIONS.map(|d| (*s, d)));
    for ((g, size, p), direction) in all {
        let slide = along(direction, size);
        let c = closed(&CARREAU, p, g, slide);
        let alone = flow(&At(&CARREAU, p), |s| s, g, slide, &mut CrossFilm::default());
        assert_eq!([alone.mid_stress, alone.flow], [c.mid_stress, c.flow]);
        // ∫ t·tf ds = Ω·τ + G·q
        let work = dot(slide, c.mid_stress) + g[0] * c.flow[0] + g[1] * c.flow[1];
        assert_relative_eq!(alone.work, work, max_relative = 1e-9);
        let [ax, ay, bx, by, mean] = brute_force(&CARREAU, p, c.mid_stress, g);
        println!(
            "{g:?} {slide:?} {p} {:?} {mean:.1e}: {:.1e} {:.1e} {:.1e} {:.1e}",
            c.mid_stress,
            (ax - slide[0]) / mean,
            (ay - slide[1]) / mean,
            (c.flow[0] - bx) / mean,
            (c.flow[1] - by) / mean
        );
        for (ours, exact) in [
            (slide[0], ax),
            (slide[1], ay),
            (c.flow[0], bx),
            (c.flow[1], by),
        ] {
            // The points across the film are laid for the stress; turned, they err by 1.3e-10 once.
            let off = if direction == 0.0 { 1e-10 } else { 2e-10 };
            assert_relative_eq!(ours, exact, epsilon = off * mean);
        }
    }
}

/// A limiting stress of 26 of the film's units at P = 0.5; with a law below it, too.
fn limited(law: Option<ShearLaw>) -> Thinning {
    let limit = Some(StressLimit::new(1e6, 0.05).unwrap());
    Thinning::new(&ShearThinning { law, limit })
}

fn limited_laws() -> Vec<Thinning> {
    let eyring = ReeEyring::new(5e6).unwrap();
    let carreau = Carreau::new(2e5, 0.5, 2.198, 0.05).unwrap();
    vec![
        limited(None),
        limited(Some(ShearLaw::ReeEyring(eyring))),
        limited(Some(ShearLaw::Carreau(carreau))),
    ]
}

/// Mean shear rate, flow and mean size of the shear rate by Gauss' rule on 20,000 intervals.
fn composite(law: &impl Fluidity, tau: [f64; 2], g: [f64; 2]) -> [f64; 5] {
    const N: usize = 20_000;
    let node = 0.6_f64.sqrt() / 2.0;
    let rule = [(-node, 5.0), (0.0, 8.0), (node, 5.0)];
    let mut sums = [0.0; 5];
    for k in 0..N {
        for (x, w) in rule {
            let s = (k as f64 + 0.5 + x) / N as f64 - 0.5;
            let t = [0, 1].map(|i| tau[i] + s * g[i]);
            let f = law.slope(dot(t, t))[0] * w / 18.0 / N as f64;
            for i in 0..2 {
                sums[i] += f * t[i];
                sums[2 + i] += f * t[i] * s;
            }
            sums[4] += f * dot(t, t).sqrt();
        }
    }
    sums
}

/// Pressure stresses up to and beyond the limit, slides from rolling to more than any film can carry; the limit as it is, and softened.
#[test]
fn limited_film_matches_brute_force() {
    let softened = [750.0, 81.0, 9.0].map(|softness| limited(None).softened(softness));
    // Softened limits, whose panels are those of the sharp one, only lead to it.
    let sharp = limited_laws().into_iter().map(|law| (law, 1e-9));
    for (thinning, tolerance) in sharp.chain(softened.map(|law| (law, 1e-5))) {
        let law = thinning.at(0.5, 1e6, 1e9);
        for size in [1e-4, 0.01, 0.3, 3.0, 10.0, 30.0, 49.0, 53.0, 60.0] {
            for angle in [0.0, 0.3, 1.2, FRAC_PI_2, 2.0] {
                let g = [size * f64::cos(angle), size * f64::sin(angle)];
                for slide in [1e-2, 20.0, 1e2, 1e4, 1e8, 1e20] {
                    let film = flow(&law, |s| s, g, [slide, 0.0], &mut CrossFilm::default());
                    let (tau, q) = (film.mid_stress, film.flow);
                    let [ax, ay, bx, by, mean] = composite(&law, tau, g);
                    let off = [ax - slide, ay, q[0] - bx, q[1] - by];
                    let worst = off.iter().fold(0.0, |m, v| v.abs().max(m));
                    assert!(
                        tau[0].is_finite() && worst < tolerance * mean,
                        "{} {g:?} {slide:e} {tau:?}: {:e}",
                        thinning.law.describe(),
                        worst / mean
                    );
                }
            }
        }
    }
}

/// Derivatives of a film near its limit against differences that are small compared with the stress of an e-fold, 0.026.
#[test]
fn limited_derivatives_match_differences() {
    for thinning in &limited_laws() {
        for g in [[0.01, 0.0], [3.0, 1.0], [10.0, 0.0], [10.0, -20.0]] {
            // The third derivative jumps at 0.999 of the limit, a slide of 98: no step may cross it.
            for slide in [1.0, 150.0, 1e4, 1e8] {
                let y = [g[0], g[1], slide, 0.6 * slide, 0.5];
                let at = |y: [f64; N_DEMANDS]| {
                    let law = thinning.at(y[4], 1e6, 1e9);
                    let (g, slide) = ([y[0], y[1]], [y[2], y[3]]);
                    close::<true>(&law, g, slide, &mut CrossFilm::default())
                };
                let c = at(y);
                // The limit moves by 50 for P = 1.
                let steps = [3e-4, 3e-4, 1e-2 * slide, 1e-2 * slide, 6e-6];
                for k in 0..N_DEMANDS {
                    let moved = [-2.0, -1.0, 1.0, 2.0].map(|m| {
                        let mut z = y;
                        z[k] += m * steps[k];
                        at(z)
                    });
                    let difference = |f: &dyn Fn(&Closure) -> f64| {
                        let v = moved.each_ref().map(f);
                        (v[0] - 8.0 * v[1] + 8.0 * v[2] - v[3]) / 12.0
                    };
                    let largest =
                        |f: &dyn Fn(usize) -> f64| (0..2).fold(0.0, |m, i| f(i).abs().max(m));
                    // q is a small difference of shear rates of order Ω: 1e-13 of it is round-off.
                    let slope = largest(&|i| c.slopes[i][k] * steps[k]);
                    for i in 0..2 {
                        let round_off = 1e-12 * (slide + c.flow[0].hypot(c.flow[1]));
                        assert_relative_eq!(
                            c.slopes[i][k] * steps[k],
                            difference(&|c| c.flow[i]),
                            epsilon = 1e-6 * slope + round_off
                        );
                        for l in 0..N_DEMANDS {
                            let size = largest(&|i| c.curvatures[i][l][k] * steps[k])
                                + 1e-2 * largest(&|i| c.slopes[i][l]);
                            assert_relative_eq!(
                                c.curvatures[i][l][k] * steps[k],
                                difference(&|c| c.slopes[i][l]),
                                epsilon = 1e-6 * size + round_off / steps[l]
                            );
                        }
                    }
                }
            }
        }
    }
}

/// Slopes against differences of the flow, curvatures against differences of the slopes.
#[test]
fn derivatives_match_differences() {
    let laws = [
        CARREAU,
        Law::Eyring { stress: 5.0 },
        Law::Power { knee: 0.5, m: 2.0 },
    ];
    for law in &laws {
        let all = states();
        for ((g, slide, p), direction) in all.iter().flat_map(|s| DIRECTIONS.map(|d| (*s, d))) {
            let slide = slide.clamp(-1e3, 1e3);
            let g = g.map(|v| v.clamp(-10.0, 10.0));
            let [slide_x, slide_y] = along(direction, slide);
            let y = [g[0], g[1], slide_x, slide_y, p];
            let at = |y: [f64; N_DEMANDS]| closed(law, y[4], [y[0], y[1]], [y[2], y[3]]);
            let c = at(y);
            let size = [
                g[0].hypot(g[1]),
                g[0].hypot(g[1]),
                slide.abs(),
                slide.abs(),
                1.0,
            ];
            for k in 0..N_DEMANDS {
                let step = 1e-3 * size[k];
                let moved = [-2.0, -1.0, 1.0, 2.0].map(|m| {
                    let mut z = y;
                    z[k] += m * step;
                    at(z)
                });
                let difference = |f: &dyn Fn(&Closure) -> f64| {
                    let v = moved.each_ref().map(f);
                    (v[0] - 8.0 * v[1] + 8.0 * v[2] - v[3]) / (12.0 * step)
                };
                let scale = c.flow[0].hypot(c.flow[1]);
                // round-off of order 1e-16 Ω in q, over the step
                let round_off = 1e-12 * slide.abs();
                for i in 0..2 {
                    assert_relative_eq!(
                        c.slopes[i][k] * size[k],
                        difference(&|c| c.flow[i]) * size[k],
                        max_relative = 1e-6,
                        epsilon = 1e-7 * scale + round_off
                    );
                    for l in 0..N_DEMANDS {
                        assert_relative_eq!(
                            c.curvatures[i][l][k] * size[k] * size[l],
                            difference(&|c| c.slopes[i][l]) * size[k] * size[l],
                            max_relative = 1e-5,
                            epsilon = 1e-6 * scale + round_off
                        );
                    }
                }
            }
        }
    }
}

/// Shear in the other direction gives the mirror image; a film that does not slide has no mid-plane stress.
#[test]
fn sliding_is_symmetric() {
    let (g, p) = ([0.3, -0.1], 0.2);
    let (plus, minus) = (
        closed(&CARREAU, p, g, [2.0, 0.0]),
        closed(&CARREAU, p, g, [-2.0, 0.0]),
    );
    for i in 0..2 {
        near(plus.mid_stress[i], -minus.mid_stress[i], 1e-12);
        assert_relative_eq!(plus.flow[i], minus.flow[i], max_relative = 1e-12);
    }
    assert_eq!(closed(&CARREAU, p, g, [0.0; 2]).mid_stress, [0.0; 2]);
}

/// Where the surfaces slide along x only, omitting the derivatives by Ω_y changes no other by a bit.
#[test]
fn straight_films_leave_out_what_they_do_not_need() {
    for (g, slide, p) in states() {
        let mut all = closed(&CARREAU, p, g, [slide, 0.0]);
        let law = At(&CARREAU, p);
        let straight = close::<false>(&law, g, [slide, 0.0], &mut CrossFilm::default());
        for i in 0..2 {
            all.slopes[i][ACROSS_MOTION] = 0.0;
            for y in 0..N_DEMANDS {
                all.curvatures[i][y][ACROSS_MOTION] = 0.0;
                all.curvatures[i][ACROSS_MOTION][y] = 0.0;
            }
        }
        assert_eq!(straight.slopes, all.slopes);
        assert_eq!(straight.curvatures, all.curvatures);
    }
}

/// Eyring's stress where pressure has made a glass of the oil: τ = τ₀ asinh(Ω/τ₀) of 27.9 within a step of round-off of the start, and
/// the walls nearly without pressure. From half of that Newton's method does not converge within its iterations.
#[test]
fn eyring_of_a_glass() {
    let law = |stress| {
        let law = ShearLaw::ReeEyring(ReeEyring {
            eyring_stress: stress * 1e6,
        });
        ShearThinning::of(law)
    };
    for (stress, slide) in [
        (0.411_301_426_811_788_96, 9.785_640_781_832_169e28),
        (0.411_301_426_811_788_96, 7.966_038_956_824_404e26),
        (0.411_301_426_811_788_96, 4.229e21),
        (0.1, 1e60),
        (2.0, 1e3),
    ] {
        let thinning = Thinning::new(&law(stress));
        let point = thinning.at(1.0, 1e6, 1e9);
        let mut rule = CrossFilm::default();
        let [tau, _] = mid_stress(&point, [-1e-4, 0.0], [slide, 0.0], &mut rule);
        let exact = stress * (slide / stress).asinh();
        assert_relative_eq!(tau, exact, max_relative = 1e-6);
    }
}
