//! The rollers of a bearing together.

use ertel_ehl::contact::{Contact, Curvatures, Hertz};
use nalgebra::{SMatrix, Vector2};

use super::newton::{Push, Row, Vector, angles, direction};
use super::roller::{Roller, RollerState};
use super::{Element, Params, RingContact, Slice};
use crate::bearing::Material;
use crate::bearing::geometry::{Ring, RollerGeometry, TaperedGeometry};
use crate::bearing::kinematics::{RollerMotion, Speeds};

/// Cylindrical or tapered rollers.
pub(super) struct Rollers {
    roller: Roller,
    /// Places of the rollers, rad.
    angles: Vec<f64>,
    /// Contact angles, rad, reduced radii, m, and curvatures, 1/m.
    raceways: [Raceway; 2],
    /// Radial play, m.
    clearance: f64,
    /// Radius of the rollers' middles and half of their length, m.
    pitch_radius: f64,
    half_length: f64,
    motion: RollerMotion,
    /// Radially outwards, N.
    centrifugal: f64,
    /// Half angle of the rollers and inclination of their axes, rad.
    half_angle: f64,
    axis_angle: f64,
    /// E', Pa.
    reduced_modulus: f64,
}

struct Raceway {
    angle: f64,
    radius: f64,
    curvatures: [Curvatures; 2],
}

impl Rollers {
    pub fn cylindrical(
        geometry: &RollerGeometry,
        material: Material,
        speeds: Speeds,
        params: &Params,
    ) -> Rollers {
        let motion = RollerMotion::new(geometry.gamma(), geometry.pitch_diameter, speeds);
        let mass = geometry.mass(material.density);
        let centrifugal = 0.5 * mass * geometry.pitch_diameter * motion.cage.powi(2);
        let drop = |z| geometry.drop(z);
        Rollers {
            roller: Roller::new(geometry.length, drop, material, centrifugal, params.slices),
            angles: angles(geometry.number, params),
            raceways: Ring::BOTH.map(|ring| Raceway {
                angle: 0.0,
                radius: geometry.radius(ring),
                curvatures: geometry.curvatures(ring),
            }),
            clearance: geometry.clearance,
            pitch_radius: 0.5 * geometry.pitch_diameter,
            half_length: 0.5 * geometry.length,
            motion,
            centrifugal,
            half_angle: 0.0,
            axis_angle: 0.0,
            reduced_modulus: material.reduced_modulus,
        }
    }

    /// Tapered rollers between the cup and the cone with its rib, which moves them along their axes with the inner ring.
    ///
    /// ```text
    ///   across the roller's axis:  Q_o cos ν = Q_i cos ν + F_c cos β       along it:  Q_f = (Q_i + Q_o) sin ν + F_c sin β,   β = α_o − ν
    ///   δ_i + δ_o = δ_r cos α_o + δ_a sin α_o
    /// ```
    /// The rib without friction pushes along the axis; ring and rib together then bear Q_o at the cup's angle less F_c. Both contacts are
    /// taken to be alike stiff.
    pub fn tapered(
        geometry: &TaperedGeometry,
        material: Material,
        speeds: Speeds,
        params: &Params,
    ) -> Rollers {
        let contact_angles = Ring::BOTH.map(|ring| geometry.angle(ring));
        let (half_angle, axis_angle) = (geometry.half_angle(), geometry.axis_angle());
        let motion =
            RollerMotion::of_cones(half_angle, contact_angles, geometry.apex_distance(), speeds);
        let mass = geometry.mass(material.density);
        let centrifugal = 0.5 * mass * geometry.pitch_diameter * motion.cage.powi(2);
        let normal = centrifugal * axis_angle.cos() / half_angle.cos();
        let relief = geometry.relief();
        let drop = |y| (relief.as_ref()).map_or(0.0, |p| p.drop(geometry.length, y)[0]);
        Rollers {
            roller: Roller::new(geometry.length, drop, material, normal, params.slices),
            angles: angles(geometry.number, params),
            raceways: Ring::BOTH.map(|ring| Raceway {
                angle: geometry.angle(ring),
                radius: geometry.radius(ring),
                curvatures: geometry.curvatures(ring),
            }),
            clearance: 0.0,
            pitch_radius: 0.5 * geometry.pitch_diameter,
            half_length: 0.5 * geometry.length,
            motion,
            centrifugal,
            half_angle,
            axis_angle,
            reduced_modulus: material.reduced_modulus,
        }
    }

    /// Load on the rib of the inner ring, in addition to Q_i along the normal of the cup: Q_o − Q_i along that normal, less F_c. Zero for
    /// cylindrical rollers.
    fn thrust(&self, angle: f64) -> Vector {
        let (s, c) = angle.sin_cos();
        let normal = self.centrifugal * self.axis_angle.cos() / self.half_angle.cos();
        let (axial, radial) = self.raceways[1].angle.sin_cos();
        let [radial, axial] = [normal * radial - self.centrifugal, normal * axial];
        let moment = self.pitch_radius * axial;
        Vector::from([radial * c, radial * s, axial, moment * s, -moment * c])
    }

    /// Spin of ring and roller about the normal from ring to roller, seen from the cage: cones with one apex have the same, ω_R sin ν, at
    /// both rings.
    fn spin(&self) -> [f64; 2] {
        [self.motion.element * self.half_angle.sin(); 2]
    }

    fn contact(&self, ring: Ring, state: &RollerState) -> RingContact {
        let raceway = &self.raceways[ring.index()];
        let radius = raceway.radius;
        let hertz = |line_load| {
            let line = Contact::line(radius, line_load);
            match line_load > 0.0 {
                true => Hertz::new(&line, self.reduced_modulus),
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
            angle: raceway.angle,
            radii: [radius, f64::INFINITY],
            curvatures: raceway.curvatures,
            semi_axes: [
                hertz(0.5 * load / self.half_length).half_width,
                self.half_length,
            ],
            pressure: slices.iter().fold(0.0, |p, slice| p.max(slice.pressure)),
            entrainment_speed: self.motion.entrainment_speed,
            spin: self.spin(),
            slices,
            tilt: state.tilts[ring.index()],
        }
    }
}

impl Row for Rollers {
    type State = RollerState;

    fn angles(&self) -> &[f64] {
        &self.angles
    }

    /// Shift along the normal of the outer raceway, and tilt of the generator, at ψ.
    fn map(&self, angle: f64) -> SMatrix<f64, 2, 5> {
        let (s, c) = angle.sin_cos();
        let (axial, radial) = self.raceways[1].angle.sin_cos();
        let arm = self.pitch_radius * axial;
        SMatrix::<f64, 2, 5>::from_row_slice(&[
            c * radial,
            s * radial,
            axial,
            arm * s,
            -arm * c, //
            0.0,
            0.0,
            0.0,
            -s,
            c,
        ])
    }

    fn state(&self, moved: Vector2<f64>) -> Option<RollerState> {
        (self.roller).state(moved[0] - 0.5 * self.clearance, moved[1])
    }

    fn push(&self, angle: f64, state: &RollerState) -> Push {
        Push {
            force: state.force,
            stiffness: state.stiffness,
            load: state.force[0],
            thrust: self.thrust(angle),
        }
    }

    fn element(&self, position: f64, state: &RollerState) -> Element {
        let contacts = Ring::BOTH.map(|ring| self.contact(ring, state));
        let both = contacts[0].load + contacts[1].load;
        Element {
            position,
            rib_load: both * self.half_angle.sin() + self.centrifugal * self.axis_angle.sin(),
            contacts,
            cage_speed: self.motion.cage,
            own_speed: self.motion.element,
            attitude: self.axis_angle,
            centrifugal_force: self.centrifugal,
            gyroscopic_moment: 0.0,
        }
    }

    fn start(&self, load: &Vector) -> Vector {
        let [x, y] = direction(load);
        let (axial_part, radial_part) = self.raceways[1].angle.sin_cos();
        let squeeze = |of_roller: f64| {
            let unit = self.typical_stiffness() * self.longest_step();
            self.longest_step() * (of_roller / unit).powf(0.9)
        };
        let number = self.angles.len() as f64;
        let radial_load = load[0].hypot(load[1]) / radial_part;
        let radial = squeeze(5.0 * radial_load / number) + 0.5 * self.clearance;
        let axial = match axial_part > 0.0 {
            true => squeeze(load[2].max(0.0) / (number * axial_part)) / axial_part,
            false => 0.0,
        };
        Vector::from([radial * x, radial * y, axial, 0.0, 0.0])
    }

    fn longest_step(&self) -> f64 {
        0.005 * self.pitch_radius
    }

    fn arm(&self) -> f64 {
        self.pitch_radius.max(self.half_length)
    }

    fn typical_stiffness(&self) -> f64 {
        let reach = self.longest_step();
        let flat = self.roller.state(reach, 0.0);
        flat.map_or(1.0, |state| state.force[0] / reach)
    }
}
