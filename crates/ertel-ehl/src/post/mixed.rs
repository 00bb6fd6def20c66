//! Rough surfaces over the film of smooth ones: lambda ratio, load and friction of asperities.

use crate::contact::{Motion, Symmetry};
use crate::mixed::{Asperities, AsperityForces, SMALL_SHARE, TOLERANCE, asperity_forces};
use crate::solution::Separation;
use crate::solution::roughness_warning;
use crate::solution::{
    AsperityFigures, ElementFields, Estimate, MixedFriction, MixedLubrication, ROUNDING, Summary,
    Traction,
};
use crate::warning::{Warning, WarningKind};
use crate::words::digits;

/// As [`TOLERANCE`], of the largest load share, whose integrand has kinks; three digits are enough.
const LIMIT_TOLERANCE: f64 = 1e-5;

/// Two rough surfaces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RoughSurfaces {
    /// Composite rms height σ, m.
    pub rms_height: f64,
    /// Their asperities, if described.
    pub asperities: Option<Asperities>,
    /// Reduced modulus E', Pa.
    pub reduced_modulus: f64,
    /// Load, N, or N/m of line contacts.
    pub load: f64,
}

/// Lambda ratio, load and friction of a solution.
pub fn mixed_lubrication(
    surfaces: &RoughSurfaces,
    motion: &Motion,
    symmetry: Symmetry,
    elements: &ElementFields,
    summary: &Summary,
    traction: &Traction,
) -> MixedLubrication {
    let sigma = surfaces.rms_height;
    let over_sigma = |film: Estimate| Estimate {
        value: film.value / sigma,
        error: film.error.map(|error| error / sigma),
    };
    let lambda_minimum = over_sigma(summary.film_minimum);
    let asperities = surfaces.asperities.map(|asperities| {
        let pressure = |u: f64| asperities.pressure(u, surfaces.reduced_modulus);
        let sliding = motion.sliding(1.0);
        let map = |factor, tolerance, pressure: &(dyn Fn(f64) -> f64 + Sync)| {
            asperity_forces(
                elements, symmetry, &sliding, sigma, factor, pressure, tolerance,
            )
        };
        let forces = |factor| map(factor, TOLERANCE, &pressure);
        let central = summary.film_central.value / sigma;
        let gap = |u: f64| pressure((u - central).max(0.0));
        let limit = map(1.0, LIMIT_TOLERANCE, &gap).load;
        let found = forces(1.0);
        let load = Estimate {
            value: found.load,
            error: relative_error(summary).map(|e| {
                let bounds = [1.0 + e, (1.0 - e).max(0.0)].map(|factor| forces(factor).load);
                let off = bounds.map(|load| (load - found.load).abs());
                off[0].max(off[1])
            }),
        };
        // Tails of the distribution of heights that carry nothing.
        let load = match load.value < ROUNDING * surfaces.load {
            true => Estimate {
                value: 0.0,
                error: load
                    .error
                    .filter(|e| *e >= ROUNDING * surfaces.load)
                    .or(Some(0.0)),
            },
            false => load,
        };
        let share = Estimate {
            value: load.value / surfaces.load,
            error: load.error.map(|error| error / surfaces.load),
        };
        let coefficient = (asperities.boundary_friction_coefficient).filter(|_| motion.slides());
        AsperityFigures {
            asperity_load: load,
            asperity_load_share: share,
            asperity_load_share_limit: limit / surfaces.load,
            asperity_pressure_maximum: pressure(lambda_minimum.value),
            friction: coefficient.map(|boundary| friction(boundary, share, &found, traction)),
        }
    });
    MixedLubrication {
        lambda_minimum,
        lambda_central: over_sigma(summary.film_central),
        separation: Separation::of(lambda_minimum.value),
        asperities,
    }
}

/// The larger relative error of both films.
fn relative_error(summary: &Summary) -> Option<f64> {
    let relative = |film: Estimate| Some(film.error? / film.value);
    Some(relative(summary.film_central)?.max(relative(summary.film_minimum)?))
}

/// f = (1 − L) f_fluid + L f_b ē with ē the mean direction of sliding over the asperity pressure, L at the most 1.
fn friction(
    boundary: f64,
    share: Estimate,
    forces: &AsperityForces,
    traction: &Traction,
) -> MixedFriction {
    let part = share.value.min(1.0);
    // A bar that ends beyond the whole load ends there.
    let error = (share.error).map(|e| {
        let ends = [share.value - e, share.value + e].map(|end| (end.min(1.0) - part).abs());
        ends[0].max(ends[1])
    });
    let component = |i: usize, fluid: Estimate| {
        let direction = match forces.load > 0.0 {
            true => forces.directed[i] / forces.load,
            false => 0.0,
        };
        let dry = boundary * direction;
        let of_share = |slope: f64| error.map(|e| slope.abs() * e);
        let both = |a: Option<f64>, b: Option<f64>| a.zip(b).map(|(a, b)| a + b);
        let own = fluid.error.map(|e| (1.0 - part) * e);
        [
            Estimate {
                value: (1.0 - part) * fluid.value,
                error: both(own, of_share(fluid.value)),
            },
            Estimate {
                value: part * dry,
                error: of_share(dry),
            },
            Estimate {
                value: (1.0 - part) * fluid.value + part * dry,
                error: both(own, of_share(dry - fluid.value)),
            },
        ]
    };
    let [friction_fluid, friction_asperities, friction_total] = component(0, traction.coefficient);
    MixedFriction {
        friction_fluid,
        friction_asperities,
        friction_total,
        across: (traction.across.as_ref()).map(|across| component(1, across.coefficient)),
    }
}

/// Warns if the film does not separate the surfaces, and if asperities carry so much that the smooth-surface film no longer applies.
pub fn warnings(mixed: &MixedLubrication, summary: &Summary, rms_height: f64) -> Vec<Warning> {
    let minimum = summary.film_minimum.value;
    let lambda = roughness_warning("the minimum film thickness", minimum, rms_height);
    let asperities = mixed.asperities.as_ref();
    let share = asperities.and_then(|a| share_warning(a.asperity_load_share.value));
    let limit = asperities
        .and_then(|a| limit_warning(mixed.lambda_minimum.value, a.asperity_load_share_limit));
    lambda.into_iter().chain(share).chain(limit).collect()
}

/// Lambda ratio below which asperities are expected to touch (Zhu and Wang 2012, abstract: little or no contact above 0.6 to 1.2).
const TOUCHING: f64 = 1.0;

/// Warns if asperities touch but could not carry the load however thin the film; `limit` is their largest share.
pub fn limit_warning(lambda: f64, limit: f64) -> Option<Warning> {
    let text = format!(
        "these asperities carry at most {} % of this load, even without any film: friction of thin films \
         comes out below that of boundary lubrication, and the load of the asperities too small",
        digits(100.0 * limit, 2)
    );
    (lambda < TOUCHING && limit < 1.0)
        .then(|| Warning::beyond(WarningKind::AsperityLimit, -limit, text))
}

/// Warns if the asperity load share is too large for the smooth-surface film.
pub fn share_warning(share: f64) -> Option<Warning> {
    let text = if share > 1.0 {
        format!(
            "at the film of smooth surfaces the asperities would carry {share:.2} times the load: real surfaces stay further apart. \
             Friction is computed with asperities that carry all of the load; the load of the asperities and the film are not those of \
             rough surfaces"
        )
    } else if share > SMALL_SHARE {
        format!(
            "the asperities carry {:.0} % of the load: beyond {:.0} % their load changes the film, which is computed for smooth \
             surfaces; load share and friction are indications",
            100.0 * share,
            100.0 * SMALL_SHARE
        )
    } else {
        return None;
    };
    Some(Warning::beyond(WarningKind::AsperityLoad, share, text))
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    fn exact(value: f64) -> Estimate {
        Estimate {
            value,
            error: Some(0.0),
        }
    }

    fn traction(coefficient: Estimate) -> Traction {
        let nothing = exact(0.0);
        Traction {
            coefficient,
            coefficient_body_1: coefficient,
            coefficient_body_2: coefficient,
            force: nothing,
            across: None,
            moment: None,
            friction_power: nothing,
            shear_stress_maximum: nothing,
            beyond_first_limit: None,
            beyond_second_limit: None,
        }
    }

    fn along(load: f64, sign: f64) -> AsperityForces {
        AsperityForces {
            load,
            directed: [sign * load, 0.0],
        }
    }

    /// All load on asperities is boundary friction, none is the traction of the fluid, half is the mean; more than all is all.
    #[test]
    fn friction_between_fluid_and_boundary() {
        for (share, sign, total) in [
            (0.0, 1.0, 0.04),
            (0.5, 1.0, 0.08),
            (1.0, 1.0, 0.12),
            (3.0, 1.0, 0.12),
            (1.0, -1.0, -0.12),
        ] {
            let forces = along(share, sign);
            let found = friction(0.12, exact(share), &forces, &traction(exact(0.04)));
            assert_relative_eq!(found.friction_total.value, total, max_relative = 1e-14);
            let parts = found.friction_fluid.value + found.friction_asperities.value;
            assert_relative_eq!(parts, total, max_relative = 1e-14);
        }
    }

    /// Bars by hand: (1 − 0.2)·0.001 + |0.12 − 0.04|·0.025; a share that is certain to be whole has none.
    #[test]
    fn bars_of_share_and_traction() {
        let uncertain = Estimate {
            value: 0.04,
            error: Some(0.001),
        };
        let share = |value| Estimate {
            value,
            error: Some(0.025),
        };
        let at = |value| friction(0.12, share(value), &along(value, 1.0), &traction(uncertain));
        let bar = at(0.2).friction_total.error.unwrap();
        assert_relative_eq!(bar, 0.8 * 0.001 + 0.08 * 0.025, max_relative = 1e-12);
        assert_eq!(at(2.0).friction_total.error, Some(0.0));
    }

    #[test]
    fn shares_at_the_limits() {
        assert_eq!(share_warning(0.0999), None);
        assert!(
            share_warning(0.11)
                .unwrap()
                .contains("carry 11 % of the load")
        );
        assert_eq!(limit_warning(0.5, 1.1), None);
        assert_eq!(limit_warning(1.5, 0.1), None);
        assert!(limit_warning(0.5, 0.041).unwrap().contains("at most 4.1 %"));
        assert!(share_warning(1.5).unwrap().contains("1.50 times the load"));
    }

    /// A line of the film h_c for |x| < b, and h_c + (|x| − b)²/2R beyond. The load of the asperities, its bar from films thinner and thicker by
    /// the larger relative error, and their largest share, with the gap of the dry contact, (h − h_c)⁺: against sums by the midpoint rule.
    #[test]
    fn load_and_largest_share_of_a_flattened_line() {
        const SIGMA: f64 = 0.2e-6;
        const MODULUS: f64 = 230e9;
        let (central, b, radius, load) = (0.3e-6, 1e-4, 1e-2, 1e5);
        let film = |x: f64| central + (x.abs() - b).max(0.0).powi(2) / (2.0 * radius);
        let asperities = Asperities {
            asperity_group: 0.05,
            rms_height_to_asperity_radius: 1e-3,
            boundary_friction_coefficient: None,
        };
        // Elements meet at ±b: quadratic films are exact.
        let n = 30;
        let vertices: Vec<[f64; 2]> = (0..=n)
            .map(|i| [3.0 * b * (2.0 * f64::from(i) / f64::from(n) - 1.0), 0.0])
            .collect();
        let cells: Vec<[u32; 3]> = (0..n as u32).map(|i| [i, i + 1, 0]).collect();
        let nodes = ertel_fem::element::Lagrange::new(1, 2);
        let values = (cells.iter())
            .flat_map(|cell| {
                let [l, r, _] = cell.map(|v| vertices[v as usize][0]);
                nodes.points().map(move |xi| film(l + xi[0] * (r - l)))
            })
            .collect();
        let elements = ElementFields {
            dim: 1,
            vertices,
            cells,
            film_thickness: crate::solution::Polynomials { order: 2, values },
            ..ElementFields::default()
        };
        let nowhere = crate::solution::Located {
            value: central,
            error: Some(0.02 * central),
            resolved: true,
            x: 0.0,
            y: 0.0,
            place_error: None,
            place_resolved: true,
        };
        let summary = Summary {
            film_central: Estimate {
                value: central,
                error: Some(0.01 * central),
            },
            film_minimum: nowhere.estimate(),
            film_minimum_at: nowhere,
            film_centreline_minimum: nowhere,
            pressure_maximum: nowhere,
            pressure_central: nowhere,
            pressure_ridge: None,
            spike: None,
            outlet_position: exact(0.0),
            pressure_minimum: 0.0,
            film_balance_error: 0.0,
            load_balance_error: 0.0,
            rigid_separation: 0.0,
        };
        let surfaces = RoughSurfaces {
            rms_height: SIGMA,
            asperities: Some(asperities),
            reduced_modulus: MODULUS,
            load,
        };
        let mixed = mixed_lubrication(
            &surfaces,
            &Motion::straight(1.0, 0.5),
            Symmetry::Full,
            &elements,
            &summary,
            &traction(exact(0.0)),
        );
        let found = mixed.asperities.unwrap();
        let sum = |gap: &dyn Fn(f64) -> f64| -> f64 {
            let m = 60_000;
            let step = 6.0 * b / f64::from(m);
            let at = |i: i32| step * (f64::from(i) + 0.5) - 3.0 * b;
            let pressures = (0..m).map(|i| asperities.pressure(gap(at(i)) / SIGMA, MODULUS));
            step * pressures.sum::<f64>()
        };
        let at_film = sum(&film);
        assert_relative_eq!(found.asperity_load.value, at_film, max_relative = 1e-6);
        let bar = sum(&|x| 0.98 * film(x)) - at_film;
        assert_relative_eq!(found.asperity_load.error.unwrap(), bar, max_relative = 1e-5);
        assert_relative_eq!(
            found.asperity_load_share.error.unwrap(),
            bar / load,
            max_relative = 1e-5
        );
        let dry = sum(&|x| film(x) - central);
        assert_relative_eq!(
            found.asperity_load_share_limit,
            dry / load,
            max_relative = 1e-4
        );
        assert!(dry > 3.0 * at_film);
    }
}
