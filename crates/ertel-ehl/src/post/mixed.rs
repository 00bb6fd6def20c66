//! Rough surfaces at a solution: lambda ratio, load and friction of asperities.

use crate::mixed::Asperities;
use crate::solution::{
    AsperityFigures, Estimate, Figure, Measured, MixedFriction, MixedLubrication, Separation,
    roughness_warning,
};
use crate::warning::Warning;

/// Two rough surfaces.
#[derive(Clone, Debug, PartialEq)]
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

fn times(estimate: Estimate, factor: f64) -> Estimate {
    Estimate {
        value: factor * estimate.value,
        error: estimate.error.map(|error| factor * error),
    }
}

/// Lambda ratio, load and friction from the figures of a solution.
pub fn mixed_lubrication(surfaces: &RoughSurfaces, measured: &Measured) -> MixedLubrication {
    let sigma = surfaces.rms_height;
    let over_sigma = |film| times(measured.estimate(film), 1.0 / sigma);
    let lambda_minimum = over_sigma(Figure::FilmMinimum);
    let share = measured.find(Figure::AsperityLoadShare);
    let asperities =
        (surfaces.asperities.as_ref().zip(share)).map(|(asperities, share)| AsperityFigures {
            asperity_load: times(share, surfaces.load),
            asperity_load_share: share,
            asperity_pressure_maximum: asperities.pressure(
                lambda_minimum.value,
                sigma,
                surfaces.reduced_modulus,
            ),
            friction: friction(measured),
            other_gap: None,
        });
    MixedLubrication {
        lambda_minimum,
        lambda_central: over_sigma(Figure::FilmCentral),
        separation: Separation::of(lambda_minimum.value),
        asperities,
    }
}

/// Friction of film and asperities, if the case has it.
fn friction(measured: &Measured) -> Option<MixedFriction> {
    let film_across = measured.find(Figure::TractionCoefficientAcross);
    let across = film_across.zip(measured.find(Figure::FrictionAsperitiesAcross));
    Some(MixedFriction {
        friction_fluid: measured.find(Figure::TractionCoefficient)?,
        friction_asperities: measured.find(Figure::FrictionAsperities)?,
        friction_total: measured.find(Figure::FrictionTotal)?,
        across: across.map(|(film, asperities)| {
            let total = Estimate {
                value: film.value + asperities.value,
                error: film.error.zip(asperities.error).map(|(a, b)| a + b),
            };
            [film, asperities, total]
        }),
    })
}

/// Warns if a film of smooth surfaces does not separate rough ones; asperities that share the load are no reason.
pub fn warning(mixed: &MixedLubrication, film_minimum: f64, rms_height: f64) -> Option<Warning> {
    match mixed.asperities {
        Some(_) => None,
        None => roughness_warning("the minimum film thickness", film_minimum, rms_height),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mixed::{AsperityLaw, Flow, Summits};
    use crate::solution::{Bar, Reading};
    use approx::assert_relative_eq;

    /// By hand: films of -20 and -30 nm over 0.1 µm, a share of 0.9 ± 0.01 of 5 kN/m; without asperities a warning, with them none.
    #[test]
    fn figures_over_roughness_and_load() {
        let mut measured = Measured::default();
        for (figure, value, bar) in [
            (Figure::FilmCentral, -20e-9, 1e-9),
            (Figure::FilmMinimum, -30e-9, 2e-9),
            (Figure::AsperityLoadShare, 0.9, 0.01),
            (Figure::TractionCoefficient, 0.004, 1e-4),
            (Figure::FrictionAsperities, 0.108, 1e-3),
            (Figure::FrictionTotal, 0.112, 1e-3),
        ] {
            measured.figures.note(figure, Reading::new(value));
            let place = None;
            measured.bars.set(figure, Bar { value: bar, place });
        }
        let smooth = RoughSurfaces {
            rms_height: 1e-7,
            asperities: None,
            reduced_modulus: 230e9,
            load: 5000.0,
        };
        let rough = RoughSurfaces {
            asperities: Some(Asperities {
                law: AsperityLaw::GreenwoodTripp(Summits {
                    asperity_group: 0.05,
                    rms_height_to_asperity_radius: 1e-3,
                }),
                hardness: None,
                boundary_friction_coefficient: Some(0.12),
                flow: Flow::AverageGap,
                flow_is_chosen: false,
                orientation: None,
            }),
            ..smooth
        };
        let without = mixed_lubrication(&smooth, &measured);
        assert_eq!(without.asperities, None);
        assert!(warning(&without, -30e-9, 1e-7).is_some());
        let with = mixed_lubrication(&rough, &measured);
        assert_relative_eq!(with.lambda_minimum.value, -0.3, max_relative = 1e-12);
        assert_eq!(with.separation, Separation::Boundary);
        assert_eq!(warning(&with, -30e-9, 1e-7), None);
        let asperities = with.asperities.unwrap();
        assert_relative_eq!(asperities.asperity_load.value, 4500.0, max_relative = 1e-12);
        let error = asperities.asperity_load.error.unwrap();
        assert_relative_eq!(error, 50.0, max_relative = 1e-12);
        assert_eq!(asperities.friction.unwrap().friction_total.value, 0.112);
    }
}
