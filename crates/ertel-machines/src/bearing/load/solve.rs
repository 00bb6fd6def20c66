//! From a bearing and its loads to the distribution.

use super::ball::Ball;
use super::ball_row::Balls;
use super::newton::{Row, angles};
use super::roller_row::Rollers;
use super::{Distribution, Error, Given, Loads, Params};
use crate::bearing::kinematics::Speeds;
use crate::bearing::{Bearing, Geometry, Material};

impl Bearing {
    /// Loads, angles, speeds and dry contacts of all elements.
    ///
    /// # Errors
    /// Geometries and loads that make no sense, no load at all, and no convergence.
    pub fn solve(
        &self,
        loads: &Loads,
        speeds: Speeds,
        params: &Params,
    ) -> Result<Distribution, Error> {
        self.geometry.check()?;
        check(self, loads, speeds, params)?;
        let given = loads.all();
        match &self.geometry {
            Geometry::Ball(geometry) => {
                let solved = |params: &Params| {
                    let row = Balls {
                        geometry,
                        ball: Ball::new(geometry, self.material, speeds, params),
                        angles: angles(geometry.number, params),
                        control: params.control,
                    };
                    row.solve(given, params)
                };
                match solved(params) {
                    Err(Error::Element { .. } | Error::NoConvergence { .. })
                        if params.gyroscopic_moment && speeds != Speeds::default() =>
                    {
                        let without = Params {
                            gyroscopic_moment: false,
                            ..*params
                        };
                        let mut found = solved(&without)?;
                        found.info.gyroscopic_slip = true;
                        Ok(found)
                    }
                    other => other,
                }
            }
            Geometry::CylindricalRoller(geometry) => {
                let mut given = given;
                match given[2] {
                    Given::Load(load) if load != 0.0 => return Err(Error::AxialLoad(load)),
                    // No force follows from an axial shift.
                    _ => given[2] = Given::Shift(0.0),
                }
                let row = Rollers::cylindrical(geometry, self.material, speeds, params);
                row.solve(given, params)
            }
            Geometry::TaperedRoller(geometry) => {
                if let Given::Load(load) = given[2]
                    && load <= 0.0
                {
                    return Err(Error::Separation(load));
                }
                let row = Rollers::tapered(geometry, self.material, speeds, params);
                row.solve(given, params)
            }
        }
    }
}

fn check(bearing: &Bearing, loads: &Loads, speeds: Speeds, params: &Params) -> Result<(), Error> {
    let value = |name, value: f64, good: bool| match good {
        true => Ok(()),
        false => Err(Error::Value { name, value }),
    };
    let Material {
        reduced_modulus,
        density,
    } = bearing.material;
    let positive = |v: f64| v > 0.0 && v.is_finite();
    value(
        "reduced modulus",
        reduced_modulus,
        positive(reduced_modulus),
    )?;
    // Elements without mass have no centrifugal force.
    value("density", density, density >= 0.0 && density.is_finite())?;
    value("inner ring speed", speeds.inner, speeds.inner.is_finite())?;
    value("outer ring speed", speeds.outer, speeds.outer.is_finite())?;
    value("tolerance", params.tolerance, positive(params.tolerance))?;
    value(
        "number of slices",
        params.slices as f64,
        params.slices >= 30,
    )?;
    let first = params.first_element;
    value("angle of the first element", first, first.is_finite())?;
    for given in loads.all() {
        let (Given::Load(number) | Given::Shift(number)) = given;
        value("load or shift", number, number.is_finite())?;
    }
    Ok(())
}
