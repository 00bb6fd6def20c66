//! From a bearing and its loads to the distribution.

use std::f64::consts::{PI, TAU};

use ertel_ehl::contact::{Contact, Ellipse, Hertz};
use nalgebra::{SMatrix, Vector2};

use super::ball::{Ball, BallState};
use super::newton::{Matrix, Reaction, Row, Vector, balance};
use super::roller::{Roller, RollerState};
use super::{Distribution, Element, Error, Given, Loads, Params, RingContact, Slice};
use crate::bearing::geometry::{BallGeometry, Ring, RollerGeometry};
use crate::bearing::kinematics::{BallMotion, RacewayControl, RollerMotion, Speeds};
use crate::bearing::{Bearing, Geometry, Material};

/// Solves the equilibrium of the inner ring.
///
/// # Errors
/// Geometries and loads that make no sense, no load at all, and no convergence.
pub fn solve(
    bearing: &Bearing,
    loads: &Loads,
    speeds: Speeds,
    params: &Params,
) -> Result<Distribution, Error> {
    bearing.geometry.check()?;
    check(bearing, loads, speeds, params)?;
    let given = loads.all();
    let is_loaded = |given: &Given| *given != Given::Load(0.0);
    match &bearing.geometry {
        Geometry::Ball(geometry) => {
            if !given[..3].iter().any(is_loaded) && geometry.clearance() >= 0.0 {
                return Err(Error::Unloaded);
            }
            let row = Balls {
                geometry,
                ball: Ball::new(geometry, bearing.material, speeds, params),
                angles: angles(geometry.number, params),
            };
            row.solve(given, bearing.material, speeds, params)
        }
        Geometry::CylindricalRoller(geometry) => {
            let mut given = given;
            match given[2] {
                Given::Load(load) if load != 0.0 => return Err(Error::AxialLoad(load)),
                // No force follows from an axial shift.
                _ => given[2] = Given::Shift(0.0),
            }
            if !given[..2].iter().any(is_loaded) && geometry.clearance >= 0.0 {
                return Err(Error::Unloaded);
            }
            let motion = RollerMotion::new(geometry.gamma(), geometry.pitch_diameter, speeds);
            let mass = geometry.mass(bearing.material.density);
            let centrifugal = 0.5 * mass * geometry.pitch_diameter * motion.cage.powi(2);
            let row = Rollers {
                geometry,
                roller: Roller::new(geometry, bearing.material, centrifugal, params.slices),
                angles: angles(geometry.number, params),
            };
            row.solve(given, bearing.material, motion, centrifugal, params)
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
    value("density", density, positive(density))?;
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

fn angles(number: usize, params: &Params) -> Vec<f64> {
    (0..number)
        .map(|j| params.first_element + TAU * j as f64 / number as f64)
        .collect()
}

/// Contact angles of a ball, both that of the outer ring where the ball does not touch the inner one.
fn motion_angles(state: &BallState) -> [f64; 2] {
    let [_, outer] = state.angles;
    match state.loads[0] > 0.0 {
        true => state.angles,
        false => [outer; 2],
    }
}

/// Direction of the radial load; x where there is none.
fn direction(load: &Vector) -> [f64; 2] {
    match load[0].hypot(load[1]) {
        0.0 => [1.0, 0.0],
        size => [load[0] / size, load[1] / size],
    }
}

struct Balls<'a> {
    geometry: &'a BallGeometry,
    ball: Ball<'a>,
    angles: Vec<f64>,
}

impl Balls<'_> {
    /// Radial and axial shift of the groove at ψ.
    fn map(&self, angle: f64) -> SMatrix<f64, 2, 5> {
        let (s, c) = angle.sin_cos();
        let arm = self.geometry.arm();
        SMatrix::<f64, 2, 5>::from_row_slice(&[
            c,
            s,
            0.0,
            0.0,
            0.0, //
            0.0,
            0.0,
            1.0,
            arm * s,
            -arm * c,
        ])
    }

    fn state(&self, angle: f64, shift: &Vector) -> Result<BallState, Error> {
        let moved = self.map(angle) * shift;
        let [radial, axial] = self.geometry.centres();
        let centre = Vector2::new(radial + moved[0], axial + moved[1]);
        let found = (centre.norm() > 0.0).then(|| self.ball.state(centre));
        found.flatten().ok_or(Error::Element {
            degrees: angle.to_degrees(),
        })
    }

    /// δ/Q^(2/3) of a ball between both rings at the free angle, m/N^(2/3).
    fn compliance(&self) -> f64 {
        let angle = self.geometry.free_angle();
        let of = |ring| {
            Ellipse::of_radii(self.geometry.radii(ring, angle))
                .approach(1.0, self.ball.reduced_modulus)
        };
        of(Ring::Inner) + of(Ring::Outer)
    }

    /// Contact angle of balls under an axial load (N) alone, rad, by bisection.
    ///
    /// A (cos α0/cos α − 1) = C [F_a/(Z sin α)]^(2/3)
    fn axial_angle(&self, load: f64) -> f64 {
        let a = self.geometry.centre_distance();
        let [radial, _] = self.geometry.centres();
        let (mut low, mut high) = (self.geometry.free_angle(), 0.499 * PI);
        for _ in 0..60 {
            let angle = 0.5 * (low + high);
            let of_ball = load / (self.geometry.number as f64 * angle.sin());
            match radial / angle.cos() - a < self.compliance() * of_ball.powf(2.0 / 3.0) {
                true => low = angle,
                false => high = angle,
            }
        }
        0.5 * (low + high)
    }

    fn solve(
        &self,
        given: [Given; 5],
        material: Material,
        speeds: Speeds,
        params: &Params,
    ) -> Result<Distribution, Error> {
        let (shift, reaction, info) = balance(self, given, params.tolerance, params.iterations)?;
        let elements = self
            .angles
            .iter()
            .map(|angle| {
                let state = self.state(*angle, &shift)?;
                Ok(self.element(*angle, &state, material, speeds, params.control))
            })
            .collect::<Result<Vec<_>, Error>>()?;
        finish(elements, &shift, &reaction, info)
    }

    fn element(
        &self,
        position: f64,
        state: &BallState,
        material: Material,
        speeds: Speeds,
        control: RacewayControl,
    ) -> Element {
        let g = self.geometry;
        let ratio = g.ball_diameter / g.pitch_diameter;
        let angles = motion_angles(state);
        let motion = BallMotion::new(ratio, angles, speeds, control);
        let contacts = Ring::BOTH.map(|ring| {
            let (load, angle) = (state.loads[ring.index()], angles[ring.index()]);
            let radii = g.radii(ring, angle);
            let semi_axes = Ellipse::of_radii(radii).semi_axes(load, material.reduced_modulus);
            let area = PI * semi_axes[0] * semi_axes[1];
            RingContact {
                ring,
                load,
                angle,
                radii,
                curvatures: g.curvatures(ring, angle),
                semi_axes,
                pressure: if load > 0.0 { 1.5 * load / area } else { 0.0 },
                entrainment_speed: motion.entrainment_speed(
                    ring,
                    ratio,
                    g.pitch_diameter,
                    angle,
                    speeds,
                ),
                spin: motion.spin(ring, angle, speeds),
                slices: Vec::new(),
            }
        });
        Element {
            position,
            contacts,
            cage_speed: motion.cage,
            own_speed: motion.element,
            attitude: motion.attitude,
            centrifugal_force: state.centrifugal_force,
            gyroscopic_moment: state.gyroscopic_moment,
        }
    }
}

impl Row for Balls<'_> {
    fn reaction(&self, shift: &Vector) -> Result<Reaction, Error> {
        let mut sum = Reaction::none();
        for angle in &self.angles {
            let map = self.map(*angle);
            let state = self.state(*angle, shift)?;
            sum.force += map.transpose() * state.force;
            sum.stiffness += map.transpose() * state.stiffness * map;
            sum.largest = sum.largest.max(state.loads[0]);
        }
        Ok(sum)
    }

    fn start(&self, load: &Vector) -> Vector {
        let [x, y] = direction(load);
        let (radial_load, axial_load) = (load[0].hypot(load[1]), load[2]);
        let of_ball = 5.0 * radial_load / self.geometry.number as f64;
        let [radial, axial] = self.geometry.centres();
        let squeeze = self.compliance() * of_ball.powf(2.0 / 3.0);
        let (radial, axial) = match axial_load.abs() > 1e-3 * radial_load {
            true => {
                let angle = self.axial_angle(axial_load.abs());
                (squeeze, axial_load.signum() * radial * angle.tan() - axial)
            }
            // Centres of both grooves at one height.
            false => (squeeze + self.geometry.centre_distance() - radial, -axial),
        };
        Vector::from([radial * x, radial * y, axial, 0.0, 0.0])
    }

    fn longest_step(&self) -> f64 {
        0.3 * self.geometry.centre_distance()
    }

    fn arm(&self) -> f64 {
        self.geometry.arm()
    }

    fn typical_stiffness(&self) -> f64 {
        // At δ = A/10.
        let approach = 0.1 * self.geometry.centre_distance();
        1.5 * approach.sqrt() / self.compliance().powf(1.5)
    }
}

struct Rollers<'a> {
    geometry: &'a RollerGeometry,
    roller: Roller,
    angles: Vec<f64>,
}

impl Rollers<'_> {
    /// Radial shift and tilt of the raceway at ψ.
    fn map(angle: f64) -> SMatrix<f64, 2, 5> {
        let (s, c) = angle.sin_cos();
        SMatrix::<f64, 2, 5>::from_row_slice(&[
            c, s, 0.0, 0.0, 0.0, //
            0.0, 0.0, 0.0, -s, c,
        ])
    }

    fn state(&self, angle: f64, shift: &Vector) -> Result<RollerState, Error> {
        let moved = Self::map(angle) * shift;
        let found = (self.roller).state(moved[0] - 0.5 * self.geometry.clearance, moved[1]);
        found.ok_or(Error::Element {
            degrees: angle.to_degrees(),
        })
    }

    fn solve(
        &self,
        given: [Given; 5],
        material: Material,
        motion: RollerMotion,
        centrifugal_force: f64,
        params: &Params,
    ) -> Result<Distribution, Error> {
        let (shift, reaction, info) = balance(self, given, params.tolerance, params.iterations)?;
        let elements = self
            .angles
            .iter()
            .map(|angle| {
                let state = self.state(*angle, &shift)?;
                Ok(Element {
                    position: *angle,
                    contacts: Ring::BOTH.map(|ring| self.contact(ring, &state, material, motion)),
                    cage_speed: motion.cage,
                    own_speed: motion.element,
                    attitude: 0.0,
                    centrifugal_force,
                    gyroscopic_moment: 0.0,
                })
            })
            .collect::<Result<Vec<_>, Error>>()?;
        finish(elements, &shift, &reaction, info)
    }

    fn contact(
        &self,
        ring: Ring,
        state: &RollerState,
        material: Material,
        motion: RollerMotion,
    ) -> RingContact {
        let radius = self.geometry.radius(ring);
        let hertz = |line_load| {
            let line = Contact::line(radius, line_load);
            match line_load > 0.0 {
                true => Hertz::new(&line, material.reduced_modulus),
                false => Hertz {
                    half_width: 0.0,
                    half_width_y: None,
                    pressure: 0.0,
                },
            }
        };
        let loads = &state.slices[ring.index()];
        let slices: Vec<Slice> = (self.roller.slices.iter().zip(loads))
            .map(|([position, _], load)| {
                let line_load = load / self.roller.width;
                Slice {
                    position: *position,
                    line_load,
                    pressure: hertz(line_load).pressure,
                }
            })
            .collect();
        let load = loads.iter().sum();
        RingContact {
            ring,
            load,
            angle: 0.0,
            radii: [radius, f64::INFINITY],
            curvatures: self.geometry.curvatures(ring),
            semi_axes: [
                hertz(load / self.geometry.length).half_width,
                0.5 * self.geometry.length,
            ],
            pressure: slices.iter().fold(0.0, |p, slice| p.max(slice.pressure)),
            entrainment_speed: motion.entrainment_speed,
            spin: [0.0; 2],
            slices,
        }
    }
}

impl Row for Rollers<'_> {
    fn reaction(&self, shift: &Vector) -> Result<Reaction, Error> {
        let mut sum = Reaction::none();
        for angle in &self.angles {
            let map = Self::map(*angle);
            let state = self.state(*angle, shift)?;
            sum.force += map.transpose() * state.force;
            sum.stiffness += map.transpose() * state.stiffness * map;
            sum.largest = sum.largest.max(state.force[0]);
        }
        Ok(sum)
    }

    fn start(&self, load: &Vector) -> Vector {
        let [x, y] = direction(load);
        let of_roller = 5.0 * load[0].hypot(load[1]) / self.geometry.number as f64;
        let unit = self.typical_stiffness() * self.longest_step();
        let squeeze = self.longest_step() * (of_roller / unit).powf(0.9);
        let radial = squeeze + 0.5 * self.geometry.clearance;
        Vector::from([radial * x, radial * y, 0.0, 0.0, 0.0])
    }

    fn longest_step(&self) -> f64 {
        0.01 * self.geometry.roller_diameter
    }

    fn arm(&self) -> f64 {
        0.5 * self.geometry.length
    }

    fn typical_stiffness(&self) -> f64 {
        let reach = self.longest_step();
        let flat = self.roller.state(reach, 0.0);
        flat.map_or(1.0, |state| state.force[0] / reach)
    }
}

impl Reaction {
    fn none() -> Reaction {
        Reaction {
            force: Vector::zeros(),
            stiffness: Matrix::zeros(),
            largest: 0.0,
        }
    }
}

fn finish(
    elements: Vec<Element>,
    shift: &Vector,
    reaction: &Reaction,
    info: super::Info,
) -> Result<Distribution, Error> {
    if reaction.largest <= 0.0 {
        return Err(Error::Unloaded);
    }
    Ok(Distribution {
        elements,
        shift: [shift[0], shift[1], shift[2]],
        tilt: [shift[3], shift[4]],
        force: [reaction.force[0], reaction.force[1], reaction.force[2]],
        moment: [reaction.force[3], reaction.force[4]],
        stiffness: std::array::from_fn(|i| std::array::from_fn(|j| reaction.stiffness[(i, j)])),
        info,
    })
}

#[cfg(test)]
#[path = "tests.rs"]
mod tests;
