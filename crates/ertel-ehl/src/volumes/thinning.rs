//! Shear thinning of the film at a node.
//!
//! ```text
//!   q = K G/12,  K = κ_∥ e eᵀ + κ_⊥ (I − e eᵀ),   G = H∇P,  e along the sliding velocity
//!   κ_∥ = 12 q_∥/G_∥,  κ_⊥ = 12 q_⊥/G_⊥           of the closure for G and Ω = σμ̄/H, both 1 in Newtonian films
//! ```
//! Each κ is even in both gradients, so that it is taken at a small gradient where there is none. A face sees the resistance μ̄/K_dd along its own
//! direction d instead of μ̄, and the flow that the gradient along the other one drives through it, K_xy/μ̄ · ∂P.
//!
//! Theory: Shear thinning by finite volumes.

use super::node::Node;
use crate::film::FilmFluid;
use crate::film::closure::Closure;
use crate::film::cross_film::CrossFilm;

/// A value and its derivatives by P, H and the components of ∇P along the grid.
pub type Jet = [f64; 5];

/// Thinning at a node, along both directions of the grid.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Thinned {
    /// ln K_dd.
    pub ln_flow: [Jet; 2],
    /// K_xy/μ̄ times the component of ∇P along the other direction.
    pub oblique: [Jet; 2],
}

/// Gradient, in the smallest stress of the law, at which κ is taken where there is less; κ changes by its square.
const NO_GRADIENT: f64 = 1e-4;

/// Film below which κ is that of this film, in h²: half of what a parabola rises by over a cell. Stresses grow without bound as a film vanishes, and on
/// grids too coarse for the smallest one, where it is below zero, Newton's method then does not converge (a ball at 1.9 GPa with L 19 and Eyring's
/// fluid; it does from 0.1 on). Results on the last grids do not depend on it.
pub(super) const UNRESOLVED: f64 = 0.25;

/// e-folds of the fluidity by the wall stress above which κ stays constant: many more than a solution has.
pub(super) const MAX_LN_FLUIDITY: f64 = 40.0;

/// e-folds below the ambient viscosity at which that of a thinned film levels off: gradients of early iterates would make it vanish.
const MAX_LN_THINNING: f64 = 10.0;

/// κ and its derivatives by G_∥, G_⊥, Ω and P.
#[derive(Clone, Copy, Debug)]
struct Factor {
    value: f64,
    by: [f64; 4],
}

impl Factor {
    /// Without shear thinning.
    const NONE: Factor = Factor {
        value: 1.0,
        by: [0.0; 4],
    };

    /// Of the flow along a direction i of the frame of the sliding, driven by the gradient there, which may have been held up.
    fn new(closure: &Closure, i: usize, gradient: f64, is_held: bool) -> Factor {
        let slopes = &closure.slopes[i];
        let value = 12.0 * closure.flow[i] / gradient;
        let by = |k: usize| 12.0 * slopes[k] / gradient;
        let own = match is_held {
            true => 0.0,
            false => by(i) - value / gradient,
        };
        Factor {
            value,
            by: [
                if i == 0 { own } else { by(0) },
                if i == 1 { own } else { by(1) },
                by(2),
                by(4),
            ],
        }
    }
}

/// κ along and across the sliding; `None` where no stress is found.
fn factors(
    fluid: &FilmFluid,
    pressure: f64,
    demand: &Demand,
    rule: &mut CrossFilm,
) -> Option<[Factor; 2]> {
    let [smallest, largest] = fluid.stresses_between(pressure, MAX_LN_FLUIDITY)?;
    let (own, omega) = (demand.gradient, demand.omega);
    let least = NO_GRADIENT * smallest;
    if own[0].abs().max(own[1].abs()).max(omega) < least {
        return None;
    }
    let g = own.map(|g| match g.abs() {
        size if size < least => least,
        size => size.min(2.0 * largest).copysign(g),
    });
    let held = [0, 1].map(|i: usize| g[i] != own[i]);
    let closure = fluid.close(pressure, g, [omega, 0.0], rule);
    let [along, across] = [0, 1].map(|i| Factor::new(&closure, i, g[i], held[i]));
    (along.value > 0.0 && across.value > 0.0).then_some([along, across])
}

/// Pressure gradient and sliding at a node, in the frame of the sliding.
pub(super) struct Demand {
    /// H, or its substitute for unresolved films.
    pub film: f64,
    /// Direction of the sliding along the grid.
    pub direction: [f64; 2],
    /// ∂P along and across it.
    pub slopes: [f64; 2],
    /// G.
    pub gradient: [f64; 2],
    /// Ω.
    pub omega: f64,
}

impl Demand {
    /// At a node of a grid with cells of the size h.
    pub fn new(node: &Node, h: f64, gradient: [f64; 2], slide: [f64; 2]) -> Demand {
        let film = node.film.max(UNRESOLVED * h * h);
        let speed = slide[0].hypot(slide[1]);
        // Without sliding the fluid has no preferred direction.
        let [c, s] = match speed > 0.0 {
            true => slide.map(|u| u / speed),
            false => [1.0, 0.0],
        };
        let slopes = [
            c * gradient[0] + s * gradient[1],
            c * gradient[1] - s * gradient[0],
        ];
        Demand {
            film,
            direction: [c, s],
            gradient: slopes.map(|p| film * p),
            slopes,
            omega: speed * node.ln_viscosity[0].exp() / film,
        }
    }
}

impl Thinned {
    /// At a node of a grid with cells of the size h, with the gradient of the pressure and the sliding velocity along the grid; 1 where no
    /// stress is found. `warmth`: factors of κ along and across the sliding where the temperature varies across the film.
    pub fn at(
        fluid: &FilmFluid,
        (node, h): (&Node, f64),
        gradient: [f64; 2],
        slide: [f64; 2],
        warmth: Option<[f64; 2]>,
        rule: &mut CrossFilm,
    ) -> Thinned {
        let demand = Demand::new(node, h, gradient, slide);
        let of_stress = factors(fluid, node.pressure, &demand, rule);
        let [along, across] = match (of_stress, warmth) {
            (None, None) => return Thinned::default(),
            (Some(factors), None) => factors,
            (factors, Some(warmth)) => {
                let mut factors = factors.unwrap_or([Factor::NONE; 2]);
                for (factor, by_heat) in factors.iter_mut().zip(warmth) {
                    factor.value *= by_heat;
                    factor.by = factor.by.map(|slope| by_heat * slope);
                }
                factors
            }
        };
        let Demand {
            film,
            slopes,
            omega,
            direction: [c, s],
            ..
        } = demand;
        let [ln_mu, ln_mu_by_p] = node.ln_viscosity;
        let jet = |factor: &Factor| -> Jet {
            let [by_along, by_across, by_omega, by_p] = factor.by;
            [
                factor.value,
                by_p + by_omega * omega * ln_mu_by_p,
                match film > node.film {
                    true => 0.0,
                    false => by_along * slopes[0] + by_across * slopes[1] - by_omega * omega / film,
                },
                film * (by_along * c - by_across * s),
                film * (by_along * s + by_across * c),
            ]
        };
        let (along, across) = (jet(&along), jet(&across));
        let weighed =
            |[a, b]: [f64; 2]| -> Jet { std::array::from_fn(|k| a * along[k] + b * across[k]) };
        // Levels off before the viscosity vanishes.
        let most = ln_mu + MAX_LN_THINNING;
        let ln = |k: Jet| -> Jet {
            let beyond = (k[0].ln() - most).max(0.0);
            std::array::from_fn(|i| match i {
                0 => k[0].ln() - beyond + beyond.ln_1p(),
                _ => k[i] / (k[0] * (1.0 + beyond)),
            })
        };
        // K_xy/μ̄ and, of each direction, its product with the gradient along the other one.
        let by_viscosity = (-ln_mu).exp();
        let mut oblique = weighed([c * s, -c * s]).map(|v| v * by_viscosity);
        oblique[1] -= oblique[0] * ln_mu_by_p;
        let driven = |other: usize| -> Jet {
            let mut driven = oblique.map(|v| v * gradient[other]);
            driven[3 + other] += oblique[0];
            driven
        };
        Thinned {
            ln_flow: [ln(weighed([c * c, s * s])), ln(weighed([s * s, c * c]))],
            oblique: [driven(1), driven(0)],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::{Contact, Hertz, Motion, Scales, Shape};
    use approx::assert_relative_eq;
    use ertel_rheology::density::DensityLaw;
    use ertel_rheology::shear::{ReeEyring, ShearLaw, ShearThinning};
    use ertel_rheology::viscosity::ViscosityLaw;

    fn fluid(motion: &Motion) -> FilmFluid {
        let contact = Contact::circular(0.016, 100.0);
        let hertz = Hertz::new(&contact, 230e9);
        let shape = Shape::new(&contact, &hertz, motion);
        let scales = Scales::new((&contact, &hertz, &shape), motion, 0.04, 870.0);
        let density = DensityLaw::dowson_higginson(870.0).unwrap();
        let viscosity = ViscosityLaw::barus(0.04, 1.5e-8).unwrap();
        let law = ShearThinning {
            law: Some(ShearLaw::ReeEyring(ReeEyring { eyring_stress: 5e6 })),
            limit: None,
        };
        FilmFluid::new(&density, &viscosity, 313.15, &scales).with_shear(
            Some(&law),
            &motion.sliding(hertz.half_width),
            &scales,
        )
    }

    fn node(fluid: &FilmFluid, pressure: f64, film: f64) -> Node {
        let [mu, mu_p, _] = fluid.at(pressure).viscosity;
        Node {
            pressure,
            film,
            ln_viscosity: [mu.ln(), mu_p / mu],
            ..Node::default()
        }
    }

    /// Eyring's fluid without a gradient: κ_∥ = dq/dG and κ_⊥ by ∫ s² f ds at the stress asinh(Ω τ₀')/τ₀': cosh and sinh(x)/x of x = τ/τ₀.
    #[test]
    fn sliding_alone_by_hand() {
        let motion = Motion::straight(1.0, 0.2);
        let fluid = fluid(&motion);
        let at = node(&fluid, 0.5, 0.2);
        let slide = fluid.slide().at([0.0; 2]);
        let found = Thinned::at(
            &fluid,
            (&at, 0.1),
            [0.0; 2],
            slide,
            None,
            &mut CrossFilm::default(),
        );
        let x = (slide[0] * at.ln_viscosity[0].exp() / 0.2 * fluid.stress_scale() / 5e6).asinh();
        assert!(x > 1.0, "{x}");
        assert_relative_eq!(found.ln_flow[0][0], x.cosh().ln(), max_relative = 1e-6);
        assert_relative_eq!(
            found.ln_flow[1][0],
            (x.sinh() / x).ln(),
            max_relative = 1e-6
        );
        assert_eq!(found.oblique[0][0], 0.0);
        // Sliding at an angle of cosine 0.6 and sine 0.8: K_xx = 0.36 κ_∥ + 0.64 κ_⊥, K_xy = 0.48 (κ_∥ − κ_⊥) > 0.
        let size = slide[0];
        let rule = &mut CrossFilm::default();
        let (slide, gradient) = ([0.6 * size, 0.8 * size], [0.0, 1e-6]);
        let found = Thinned::at(&fluid, (&at, 0.1), gradient, slide, None, rule);
        let (along, across) = (x.cosh(), x.sinh() / x);
        for (ln, [a, b]) in found.ln_flow.iter().zip([[0.36, 0.64], [0.64, 0.36]]) {
            assert_relative_eq!(ln[0], (a * along + b * across).ln(), max_relative = 1e-6);
        }
        let oblique = 0.48 * (along - across) * (-at.ln_viscosity[0]).exp() * 1e-6;
        assert_relative_eq!(found.oblique[0][0], oblique, max_relative = 1e-5);
    }

    /// All derivatives against differences, sliding along the grid and at an angle, with a gradient and without: there κ is that of a gradient
    /// of 1e-4 of Eyring's stress.
    #[test]
    fn derivatives_against_differences() {
        let motion = Motion::straight(1.0, 0.2);
        let fluid = fluid(&motion);
        let [slide, _] = fluid.slide().at([0.0; 2]);
        for direction in [[1.0, 0.0], [0.8, 0.6], [0.0, 0.0]] {
            for gradient in [[3.0, -2.0], [0.3, 0.0]] {
                let slide = direction.map(|d| d * slide);
                let at = |x: [f64; 4]| {
                    let node = node(&fluid, x[0], x[1]);
                    let rule = &mut CrossFilm::default();
                    Thinned::at(&fluid, (&node, 0.1), [x[2], x[3]], slide, None, rule)
                };
                let x = [0.5, 0.2, gradient[0], gradient[1]];
                let found = at(x);
                for k in 0..4 {
                    let step = 1e-5;
                    let moved = |sign: f64| {
                        let mut x = x;
                        x[k] += sign * step;
                        at(x)
                    };
                    let (above, below) = (moved(1.0), moved(-1.0));
                    for d in 0..2 {
                        for of in [|t: &Thinned| t.ln_flow, |t: &Thinned| t.oblique] {
                            let difference = (of(&above)[d][0] - of(&below)[d][0]) / (2.0 * step);
                            assert_relative_eq!(
                                of(&found)[d][k + 1],
                                difference,
                                max_relative = 1e-4,
                                epsilon = 1e-5
                            );
                        }
                    }
                }
            }
        }
    }
}
