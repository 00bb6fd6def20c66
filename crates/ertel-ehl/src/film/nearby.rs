//! Flow across the film of fluids that differ little from one.
//!
//! A closure depends on its fluid by the demands P and Ω, on the unit of stress a p_h/R, on that of pressure p_h if there is a limiting stress, and on
//! the constants of the thinning law. The change by each of these is found once at a point, by one Newton step from the stress of the
//! fluid itself to either side, and serves all similar fluids.

use std::sync::Arc;

use ertel_fem::kernel;
use ertel_fem::linear::dense::vectorised;
use ertel_rheology::shear::ShearThinning;

use super::closure::{Closure, N_DEMANDS, close_nearby};
use super::cross_film::CrossFilm;
use super::fluid::FilmFluid;
use super::fluidity::{PointThinning, Thinning};

/// Step of the numbers that a closure depends on, over their size.
const STEP: f64 = 1e-5;

/// A fluid, and how its closures change with the numbers that they depend on.
pub struct Nearby<'a> {
    fluid: &'a FilmFluid,
    parameters: Vec<Parameter>,
}

/// One of the numbers that differ between the fluids.
struct Parameter {
    /// Which.
    index: usize,
    /// The law with less and with more of it.
    sides: [Varied; 2],
    /// By how much it differs between them.
    distance: f64,
}

/// A thinning law with its units of stress and pressure, Pa.
struct Varied {
    thinning: Arc<Thinning>,
    units: [f64; 2],
}

/// A first-order change of a closure: flow, its slopes, and the stress at mid-film.
#[derive(Clone, Copy, Debug, Default)]
struct Change {
    flow: [f64; 2],
    slopes: [[f64; N_DEMANDS]; 2],
    mid_stress: [f64; 2],
}

/// The changes of a closure at a point by each of the numbers that differ, with its place among them.
pub struct Changes(Vec<(usize, Change)>);

/// Numbers other than P and Ω on which closures of a fluid depend: units of stress and pressure, and the constants of its law; none of a
/// Newtonian one.
pub fn numbers(fluid: &FilmFluid) -> Vec<f64> {
    fluid.thinning().map_or_else(Vec::new, |thinning| {
        let mut constants = thinning.law.constants();
        let mut units = [fluid.stress_scale(), fluid.pressure_scale()];
        if thinning.law.limit.is_none() {
            // The unit of pressure has no effect, and that of stress only over the stress of the law, its first constant.
            units = [units[0] / constants[0], 1.0];
            constants[0] = 1.0;
        }
        [&units[..], &constants].concat()
    })
}

impl<'a> Nearby<'a> {
    /// Prepares for fluids in which some of the [`numbers`] are a little different.
    pub fn new(fluid: &'a FilmFluid, moves: &[bool]) -> Self {
        let own = numbers(fluid);
        let parameters = (fluid.thinning()).map_or_else(Vec::new, |thinning| {
            (0..own.len())
                .filter(|i| moves[*i])
                .map(|index| Parameter::new(fluid, thinning, index))
                .collect()
        });
        Nearby { fluid, parameters }
    }

    /// Changes of the fluid's closure at a point.
    pub fn changes(
        &self,
        pressure: f64,
        pressure_stress: [f64; 2],
        sliding_stress: [f64; 2],
        closure: &Closure,
        rule: &mut CrossFilm,
    ) -> Changes {
        let tau = closure.mid_stress;
        if let Some(scales) = self
            .fluid
            .stress_scales(pressure)
            .filter(|_| !self.parameters.is_empty())
        {
            rule.lay(&scales, tau, pressure_stress);
        }
        let across = !self.fluid.slide().is_along_x();
        let changes = (self.parameters.iter())
            .map(|parameter| {
                let [below, above] = parameter.sides.each_ref().map(|side| {
                    let law = (side.thinning).at(pressure, side.units[0], side.units[1]);
                    let demands = [tau, pressure_stress, sliding_stress];
                    let (law, rule) = (&law, &*rule);
                    match across {
                        true => vectorised(CloseNearby::<true> { law, demands, rule }),
                        false => vectorised(CloseNearby::<false> { law, demands, rule }),
                    }
                });
                (
                    parameter.index,
                    Change::between(&below, &above, parameter.distance),
                )
            })
            .collect();
        Changes(changes)
    }
}

/// Number of units before the constants of the law.
const N_UNITS: usize = 2;

impl Parameter {
    fn new(fluid: &FilmFluid, thinning: &Arc<Thinning>, index: usize) -> Parameter {
        let own = [fluid.stress_scale(), fluid.pressure_scale()];
        let value = numbers(fluid)[index];
        let step = if value == 0.0 {
            STEP
        } else {
            STEP * value.abs()
        };
        let varied = |step: f64| -> Option<Varied> {
            let (mut thinning, mut units) = (thinning.clone(), own);
            if index < N_UNITS {
                units[index] *= 1.0 + step / value;
            } else {
                let mut constants = thinning.law.constants();
                constants[index - N_UNITS] += step;
                let law: ShearThinning = thinning.law.with_constants(&constants).ok()?;
                thinning = Arc::new(Thinning::new(&law));
            }
            Some(Varied { thinning, units })
        };
        let itself = || Varied {
            thinning: thinning.clone(),
            units: own,
        };
        // At the limit of a constant's range, the difference is one-sided.
        let (below, above) = (varied(-step), varied(step));
        let distance = match below.is_some() && above.is_some() {
            true => 2.0 * step,
            false => step,
        };
        Parameter {
            index,
            sides: [below, above].map(|side| side.unwrap_or_else(itself)),
            distance,
        }
    }
}

kernel! {
    CloseNearby ['a, const ACROSS: bool] ['a, ACROSS] (
        law: &'a PointThinning<'a>,
        demands: [[f64; 2]; 3],
        rule: &'a CrossFilm,
    ) -> Closure {
        let [tau, pressure_stress, sliding_stress] = demands;
        close_nearby::<ACROSS>(law, tau, pressure_stress, sliding_stress, rule)
    }
}

impl Change {
    fn between(below: &Closure, above: &Closure, distance: f64) -> Change {
        let over = |a: f64, b: f64| (a - b) / distance;
        let mut change = Change::default();
        for i in 0..2 {
            change.flow[i] = over(above.flow[i], below.flow[i]);
            change.mid_stress[i] = over(above.mid_stress[i], below.mid_stress[i]);
            for y in 0..N_DEMANDS {
                change.slopes[i][y] = over(above.slopes[i][y], below.slopes[i][y]);
            }
        }
        change
    }
}

impl Changes {
    /// The closure of a fluid whose sliding stress differs from that of `own` and one of whose numbers, given by its place, does, to first
    /// order; without curvatures.
    #[inline]
    pub fn moved(&self, own: &Closure, number: Option<(usize, f64)>, sliding: [f64; 2]) -> Closure {
        let mut moved = Closure {
            mid_stress: own.mid_stress,
            flow: own.flow,
            slopes: own.slopes,
            ..Closure::default()
        };
        for (k, by) in sliding.into_iter().enumerate().filter(|(_, by)| *by != 0.0) {
            for i in 0..2 {
                moved.flow[i] += by * own.slopes[i][2 + k];
                moved.mid_stress[i] += by * own.stress_slopes[2 + k][i];
                for y in 0..N_DEMANDS {
                    moved.slopes[i][y] += by * own.curvatures[i][y][2 + k];
                }
            }
        }
        let Some((index, by)) = number else {
            return moved;
        };
        for (_, change) in self.0.iter().filter(|(other, _)| *other == index) {
            for i in 0..2 {
                moved.flow[i] += by * change.flow[i];
                moved.mid_stress[i] += by * change.mid_stress[i];
                for y in 0..N_DEMANDS {
                    moved.slopes[i][y] += by * change.slopes[i][y];
                }
            }
        }
        moved
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;
    use ertel_rheology::density::DensityLaw;
    use ertel_rheology::shear::{Carreau, ReeEyring, ShearLaw, StressLimit};
    use ertel_rheology::viscosity::ViscosityLaw;

    use super::*;
    use crate::contact::{Planar, Scales};

    fn scales(pressure: f64) -> Scales {
        Scales {
            length: 2e-4,
            pressure,
            film: 2.5e-6,
            viscosity: 0.04,
            density: 870.0,
            lambda: 0.01,
            elastic_stress: 8e10,
            load: 1.0,
        }
    }

    fn fluid(law: &ShearThinning, pressure: f64) -> FilmFluid {
        let density = DensityLaw::dowson_higginson(870.0).unwrap();
        let viscosity = ViscosityLaw::roelands(0.04, 2e-8).unwrap();
        let scales = scales(pressure);
        FilmFluid::new(&density, &viscosity, 313.15, &scales).with_shear(
            Some(law),
            &Planar::along_x(0.3),
            &scales,
        )
    }

    /// Closures of fluids with other constants and units, solved for, against those to first order from one fluid.
    #[test]
    fn first_order_matches_closures() {
        let limit = || StressLimit::new(2e6, 0.04).unwrap();
        let carreau = ShearLaw::Carreau(Carreau::new(1e5, 0.6, 2.2, 0.2).unwrap());
        let eyring = ShearLaw::ReeEyring(ReeEyring::new(5e6).unwrap());
        let (p, g, omega) = (0.4, [0.3, 0.1], [0.8, 0.0]);
        for law in [
            ShearThinning::of(carreau.clone()),
            ShearThinning::of(eyring),
            ShearThinning {
                law: Some(carreau),
                limit: Some(limit()),
            },
            ShearThinning::limited(limit()),
        ] {
            let unit = 1e9;
            let own = fluid(&law, unit);
            let mut rule = CrossFilm::default();
            let closure = own.close(p, g, omega, &mut rule);
            let all = vec![true; numbers(&own).len()];
            let nearby = Nearby::new(&own, &all);
            let changes = nearby.changes(p, g, omega, &closure, &mut rule);
            let mut others = vec![fluid(&law, unit * (1.0 + 1e-4))];
            for k in 0..law.constants().len() {
                let mut constants = law.constants();
                constants[k] *= 1.0 + 1e-4;
                others.push(fluid(&law.with_constants(&constants).unwrap(), unit));
            }
            for other in others {
                let exact = other.close(p, g, omega, &mut rule);
                let mut found = closure;
                let (own, theirs) = (numbers(&own), numbers(&other));
                for k in 0..own.len() {
                    let moved = changes.moved(&closure, Some((k, theirs[k] - own[k])), [0.0; 2]);
                    found.flow[0] += moved.flow[0] - closure.flow[0];
                    found.mid_stress[0] += moved.mid_stress[0] - closure.mid_stress[0];
                    for y in 0..N_DEMANDS {
                        found.slopes[0][y] += moved.slopes[0][y] - closure.slopes[0][y];
                    }
                }
                // By a thousandth of the change, which is 1e-4.
                assert_relative_eq!(found.flow[0], exact.flow[0], max_relative = 1e-6);
                assert_relative_eq!(
                    found.mid_stress[0],
                    exact.mid_stress[0],
                    max_relative = 1e-6
                );
                let size = closure.slopes[0][0].abs();
                for y in [0, 1, 2, 4] {
                    let (found, exact) = (found.slopes[0][y], exact.slopes[0][y]);
                    assert_relative_eq!(found, exact, epsilon = 1e-6 * size, max_relative = 1e-6);
                }
            }
        }
    }
}
