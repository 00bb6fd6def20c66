//! The rollers of a bearing together.

use ertel_ehl::contact::{Contact, Hertz};
use nalgebra::SMatrix;

use super::newton::{Reaction, Row, Vector, balance};
use super::roller::{Roller, RollerState};
use super::solve::{direction, finish};
use super::{Distribution, Element, Error, Given, Params, RingContact, Slice};
use crate::bearing::Material;
use crate::bearing::geometry::{Ring, RollerGeometry};
use crate::bearing::kinematics::RollerMotion;

pub(super) struct Rollers<'a> {
    pub geometry: &'a RollerGeometry,
    pub roller: Roller,
    pub angles: Vec<f64>,
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

    pub fn solve(
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
