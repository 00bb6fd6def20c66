//! The local laws of rough surfaces in dimensionless variables: asperity pressure and gap over the distance of the mean planes.

use super::flow::{Flow, Orientation};
use super::law::{Asperities, AsperityLaw};
use super::persson::Persson;
use super::pressure_table::PressureTable;
use super::statistics::{mean_gap, share_apart};
use super::table::Tail;
use crate::contact::Scales;

/// Elastic asperity pressure over the distance of the mean planes.
#[derive(Clone, Debug, PartialEq)]
enum Elastic {
    /// κ F(H/σ), κ in p_h.
    Tail { stiffness: f64, tail: Tail },
    /// Persson's law with E* in p_h.
    Exponential { law: Persson, modulus: f64 },
    /// A table, with the scales of films, m, and of pressures, Pa.
    Table {
        table: PressureTable,
        film: f64,
        pressure: f64,
    },
}

/// Two rough surfaces, in the variables of the film equation.
#[derive(Clone, Debug, PartialEq)]
pub struct Rough {
    /// σ, in a²/R.
    pub rms_height: f64,
    elastic: Elastic,
    /// Hardness, in p_h, if asperities flow.
    pub hardness: Option<f64>,
    /// Where the oil flows.
    pub flow: Flow,
    /// Orientation of the roughness where flow factors depend on it.
    pub orientation: Orientation,
    /// f_b, if given.
    pub boundary_friction: Option<f64>,
}

/// Width in σ over which the distance h₊ as the gap that flows is rounded at zero: a kink makes the active set cycle.
const ROUNDED: f64 = 1e-4;

/// u from which the mean gap is the distance to the last digit.
const APART: f64 = 9.0;

/// The smallest distance for relative changes, in σ.
const LEAST_GAP: f64 = 0.05;

/// Rms height that cells of the size h resolve, in h²: a parabola rises by twice as much over a cell. On coarser grids films err by more than the height of all asperities. With 0.25, a ball
/// at 2.1 GPa with σ = 0.006 a²/R and an ellipse at 1.9 GPa had no solution.
const RESOLVED: f64 = 1.0;

/// Asperity pressure of the start at the centre, in p_h: from thicker films Newton's method overshoots, since it sees no asperities there.
const PRESSURE_OF_START: f64 = 0.3;

impl Rough {
    /// Of asperities with the composite rms height σ in m; `reduced_modulus` is E' in Pa.
    pub fn new(
        asperities: &Asperities,
        rms_height: f64,
        reduced_modulus: f64,
        scales: &Scales,
    ) -> Rough {
        let stiffness = asperities.law.stiffness(reduced_modulus).unwrap_or(0.0) / scales.pressure;
        let tail = |tail| Elastic::Tail { stiffness, tail };
        Rough {
            rms_height: rms_height / scales.film,
            elastic: match &asperities.law {
                AsperityLaw::GreenwoodTripp(_) => tail(Tail::FiveHalves),
                AsperityLaw::GreenwoodWilliamson(_) => tail(Tail::ThreeHalves),
                AsperityLaw::Persson(law) => Elastic::Exponential {
                    law: *law,
                    modulus: 0.5 * reduced_modulus / scales.pressure,
                },
                AsperityLaw::Table(table) => Elastic::Table {
                    table: table.clone(),
                    film: scales.film,
                    pressure: scales.pressure,
                },
            },
            hardness: asperities
                .hardness
                .map(|hardness| hardness / scales.pressure),
            flow: asperities.flow,
            orientation: asperities.orientation.unwrap_or_default(),
            boundary_friction: asperities.boundary_friction_coefficient,
        }
    }

    /// Of Greenwood and Tripp with κ in p_h and σ in a²/R, without friction.
    pub fn greenwood_tripp(rms_height: f64, stiffness: f64, flow: Flow) -> Rough {
        Rough {
            rms_height,
            elastic: Elastic::Tail {
                stiffness,
                tail: Tail::FiveHalves,
            },
            hardness: None,
            flow,
            orientation: Orientation::default(),
            boundary_friction: None,
        }
    }

    /// Whether cells of the size h, in half-widths, resolve the roughness; coarser grids have the film of smooth surfaces.
    pub fn is_resolved(&self, h: f64) -> bool {
        self.rms_height >= RESOLVED * h * h
    }

    /// p_a at a distance H of the mean planes, and its derivative.
    #[inline]
    pub fn pressure(&self, distance: f64) -> [f64; 2] {
        let u = distance / self.rms_height;
        let elastic = match &self.elastic {
            Elastic::Tail { stiffness, tail } => {
                let [value, slope] = tail.at(u);
                [stiffness * value, stiffness * slope / self.rms_height]
            }
            Elastic::Exponential { law, modulus } => {
                let [value, slope] = law.pressure(u);
                [modulus * value, modulus * slope / self.rms_height]
            }
            Elastic::Table {
                table,
                film,
                pressure,
            } => {
                let [value, slope] = table.at(distance * film);
                [value / pressure, slope * film / pressure]
            }
        };
        let Some(hardness) = self.hardness else {
            return elastic;
        };
        let [area, slope] = self.area_in_touch(u, elastic);
        let flowing = [hardness * area, hardness * slope];
        match flowing[0] < elastic[0] {
            true => flowing,
            false => elastic,
        }
    }

    /// Share of the area in touch where asperities flow, and its derivative by the distance, at u and the elastic pressure with its derivative.
    #[inline]
    fn area_in_touch(&self, u: f64, [pressure, slope]: [f64; 2]) -> [f64; 2] {
        match &self.elastic {
            Elastic::Exponential { law, modulus } => {
                let [area, by_pressure] = law.area_in_touch(pressure / modulus);
                [area, by_pressure * slope / modulus]
            }
            _ => {
                // Q' = −φ.
                let density = (-0.5 * u * u).exp() / (2.0 * std::f64::consts::PI).sqrt();
                [share_apart(-u), -density / self.rms_height]
            }
        }
    }

    /// h_T and its derivative, the share Φ of the area that is apart.
    #[inline]
    pub fn mean_gap(&self, distance: f64) -> [f64; 2] {
        let u = distance / self.rms_height;
        match u < APART {
            true => [self.rms_height * mean_gap(u), share_apart(u)],
            false => [distance, 1.0],
        }
    }

    /// The gap that flows, and its derivative.
    #[inline]
    pub fn gap(&self, distance: f64) -> [f64; 2] {
        match self.flow {
            Flow::AverageGap | Flow::PatirCheng => self.mean_gap(distance),
            Flow::Distance => {
                let rounded = distance.hypot(ROUNDED * self.rms_height);
                let gap = match distance > 0.0 {
                    true => 0.5 * (rounded + distance),
                    // Without cancellation.
                    false => 0.5 * (ROUNDED * self.rms_height).powi(2) / (rounded - distance),
                };
                [gap, gap / rounded]
            }
        }
    }

    /// ln of the flow that pressure drives, over that through the gap g of smooth surfaces, along the motion and across it, each with its derivative by g.
    #[inline]
    pub fn ln_passage(&self, distance: f64) -> [[f64; 2]; 2] {
        match self.flow {
            Flow::AverageGap | Flow::Distance => [[0.0; 2]; 2],
            Flow::PatirCheng => {
                let u = distance / self.rms_height;
                let by_gap = self.rms_height * share_apart(u);
                let of_u = self.orientation.ln_passage(u);
                of_u.map(|[ln, slope]| [ln, if slope == 0.0 { 0.0 } else { slope / by_gap }])
            }
        }
    }

    /// Smallest gap for relative changes: where no oil flows, the distance as the gap that flows vanishes.
    pub fn least_gap(&self) -> f64 {
        match self.flow {
            Flow::AverageGap | Flow::PatirCheng => 0.0,
            Flow::Distance => LEAST_GAP * self.rms_height,
        }
    }

    /// The smallest film of a start.
    pub fn least_start(&self) -> f64 {
        let (mut low, mut high) = (-8.0, 8.0);
        while high - low > 0.01 {
            let middle = 0.5 * (low + high);
            match self.pressure(middle * self.rms_height)[0] > PRESSURE_OF_START {
                true => low = middle,
                false => high = middle,
            }
        }
        high * self.rms_height
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    fn surfaces(flow: Flow) -> Rough {
        Rough::greenwood_tripp(0.02, 1.3, flow)
    }

    /// Derivatives against differences, for all gaps and pressures, overlapping and apart.
    #[test]
    fn slopes_against_differences() {
        let step = 1e-7;
        let of = |law: &dyn Fn(f64) -> [f64; 2]| {
            for h in [-0.1, -0.011, 0.003, 0.03, 0.1, 0.17] {
                let difference = (law(h + step)[0] - law(h - step)[0]) / (2.0 * step);
                assert_relative_eq!(law(h)[1], difference, max_relative = 1e-5, epsilon = 1e-8);
            }
        };
        let soft = Rough {
            hardness: Some(2.0),
            ..surfaces(Flow::AverageGap)
        };
        let on_one = Rough {
            elastic: Elastic::Tail {
                stiffness: 1.3,
                tail: Tail::ThreeHalves,
            },
            ..surfaces(Flow::AverageGap)
        };
        let measured = Rough {
            elastic: Elastic::Table {
                table: PressureTable::new(vec![-1e-7, 1e-7, 4e-7], vec![1e9, 2e8, 1e6]).unwrap(),
                film: 2e-6,
                pressure: 5e8,
            },
            ..surfaces(Flow::AverageGap)
        };
        let persson = |hardness| Rough {
            elastic: Elastic::Exponential {
                law: Persson::new(0.2, None, None),
                modulus: 60.0,
            },
            hardness,
            ..surfaces(Flow::AverageGap)
        };
        let (random, random_soft) = (persson(None), persson(Some(2.0)));
        for law in [
            &soft,
            &on_one,
            &measured,
            &random,
            &random_soft,
            &surfaces(Flow::Distance),
        ] {
            of(&|h| law.pressure(h));
            of(&|h| law.gap(h));
        }
        let factors = surfaces(Flow::PatirCheng);
        for h in [-0.1, 0.003, 0.03, 0.1] {
            let by_distance = (factors.ln_passage(h + step)[0][0]
                - factors.ln_passage(h - step)[0][0])
                / (2.0 * step);
            let by_gap = by_distance / factors.gap(h)[1];
            assert_relative_eq!(
                factors.ln_passage(h)[0][1],
                by_gap,
                max_relative = 1e-5,
                epsilon = 1e-6
            );
        }
    }

    /// Far apart both gaps are the distance; where mean planes meet, the mean gap is σ/√(2π), and the distance none.
    #[test]
    fn gaps_far_apart_and_in_touch() {
        let [mean, distance] = [Flow::AverageGap, Flow::Distance].map(surfaces);
        for surfaces in [&mean, &distance] {
            assert_relative_eq!(surfaces.gap(1.0)[0], 1.0, max_relative = 1e-11);
        }
        let touching = 0.02 / (2.0 * std::f64::consts::PI).sqrt();
        assert_relative_eq!(mean.gap(0.0)[0], touching, max_relative = 1e-14);
        assert!(distance.gap(0.0)[0] < 1e-4 * 0.02 && distance.gap(-0.02)[0] < 1e-8);
        assert_relative_eq!(
            mean.pressure(mean.least_start())[0],
            0.3,
            max_relative = 0.02
        );
    }
}
