//! Physical limits. A figure beyond its limit is no result: its error bar covers its whole value, so that it is not resolved, and neither is what is
//! computed from it.
//!
//! | figure | limit | source |
//! |---|---|---|
//! | traction coefficient, with forces, moments and power of the same stresses | [`TRACTION`] | dry steel on steel: 0.8 (Bowden and Tabor 1950) |
//! | shear stress over p_h | [`STRESS_RATIO`] | the same at a point |
//! | temperature | [`TEMPERATURE`] | iron melts (CRC Handbook of Chemistry and Physics) |

use super::figures::{Bar, Measured, Sizes};
use super::{Figure, Kind, Section};

/// Traction coefficient beyond which a film would transmit more than dry metal does.
pub const TRACTION: f64 = 1.0;

/// Shear stress over the Hertz pressure beyond which the same holds at a point.
pub const STRESS_RATIO: f64 = 1.0;

/// Temperature at which the bodies melt, K.
pub const TEMPERATURE: f64 = 1811.0;

/// Whether a figure of a contact of these sizes is beyond its limit.
fn is_beyond(figure: Figure, value: f64, sizes: &Sizes) -> bool {
    match figure.kind() {
        Kind::Coefficient => value.abs() > TRACTION,
        Kind::Stress => value.abs() > STRESS_RATIO * sizes.pressure,
        Kind::Temperature => value > TEMPERATURE,
        _ => false,
    }
}

impl Measured {
    /// The same with bars as wide as the figures that are beyond limits of physics: each by its own, all of friction by the traction coefficients.
    pub fn within_limits(mut self, sizes: &Sizes) -> Measured {
        let beyond = |figure: Figure| {
            let value = self.figures.value(figure);
            value.is_some_and(|value| is_beyond(figure, value, sizes))
        };
        let too_much_friction =
            (Figure::ALL.into_iter()).any(|f| f.section() == Section::Traction && beyond(f));
        let covered: Vec<Figure> = (Figure::ALL.into_iter())
            .filter(|f| (too_much_friction && f.section() == Section::Traction) || beyond(*f))
            .collect();
        for figure in covered {
            let Some(reading) = self.figures.get(figure) else {
                continue;
            };
            let bar = self.bars.get(figure);
            let own = bar.map_or(0.0, |bar| bar.value);
            let value = own.max(reading.value.abs());
            let place = bar.and_then(|bar| bar.place);
            self.bars.set(figure, Bar { value, place });
        }
        self
    }
}

#[cfg(test)]
mod tests {
    use super::super::Reading;
    use super::*;

    /// At 1 GPa: a coefficient of 4e122 invalidates the power but not the film; a stress of 1.1 GPa and 1900 K are invalid by themselves. Values just below stay.
    #[test]
    fn figures_beyond_physics_are_not_resolved() {
        let sizes = Sizes {
            load: 100.0,
            length: 1e-4,
            pressure: 1e9,
            speed: 1.0,
        };
        let resolved = |coefficient: f64, stress: f64, temperature: f64| {
            let mut measured = Measured::default();
            let figures = [
                (Figure::FilmCentral, Reading::new(1e-7)),
                (Figure::TractionCoefficient, Reading::new(coefficient)),
                (Figure::FrictionPower, Reading::new(3.0)),
                (Figure::ShearStressMaximum, Reading::new(stress)),
                (
                    Figure::FilmTemperatureMaximum,
                    Reading::of_rise(temperature, temperature - 313.0),
                ),
            ];
            for (figure, reading) in figures {
                measured.figures.note(figure, reading);
                let value = 1e-3 * reading.size;
                measured.bars.set(figure, Bar { value, place: None });
            }
            let measured = measured.within_limits(&sizes);
            figures.map(|(figure, _)| measured.is_resolved(figure))
        };
        assert_eq!(resolved(-0.99, 0.99e9, 1800.0), [true; 5]);
        assert_eq!(
            resolved(-4.4e122, 0.99e9, 1800.0),
            [true, false, false, true, true]
        );
        assert_eq!(
            resolved(0.02, 1.1e9, 1900.0),
            [true, true, true, false, false]
        );
    }
}
