//! A cam over a turn.

use std::f64::consts::TAU;

use ertel_ehl::contact::{Contact, Hertz, Motion};

use super::error::in_range;
use super::{CamError, Follower, LiftLaw};

/// A cam and its follower.
#[derive(Clone, Debug, PartialEq)]
pub struct Cam {
    law: LiftLaw,
    follower: Follower,
    base_radius: f64,
}

/// How a cam runs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CamOperation {
    /// Speed ω of the cam, rad/s; with the other sign all surface speeds change theirs.
    pub speed: f64,
    /// Width of the contact, m.
    pub width: f64,
    /// Mass of the follower and of what moves with it, m, kg.
    pub mass: f64,
    /// Spring rate c, N/m.
    pub spring_rate: f64,
    /// Spring force F_0 at s = 0, N.
    pub preload: f64,
    /// Other force on the follower towards the cam, N, such as of gas or of a lash adjuster.
    pub extra_force: f64,
    /// Reduced modulus E' of the contact, Pa.
    pub reduced_modulus: f64,
}

/// The contact of a cam (body 2) and its follower (body 1) at one angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CamPoint {
    /// Angle θ of the cam, rad.
    pub angle: f64,
    /// Lift s, m.
    pub lift: f64,
    /// s', m.
    pub lift_velocity: f64,
    /// s'', m.
    pub lift_acceleration: f64,
    /// Contact, m from the cam's axis; the follower moves along the second axis.
    pub contact: [f64; 2],
    /// Pressure angle, rad.
    pub pressure_angle: f64,
    /// Radius of the follower, m; infinite if flat.
    pub radius_body_1: f64,
    /// Radius of curvature of the cam, m; negative where concave.
    pub radius_body_2: f64,
    /// Reduced radius, m; not positive where undercut.
    pub reduced_radius: f64,
    /// Speed of the follower's surface relative to the contact, m/s.
    pub u_1: f64,
    /// Speed of the cam's surface relative to the contact, m/s.
    pub u_2: f64,
    /// Entrainment speed (u_1 + u_2)/2, m/s.
    pub entrainment_speed: f64,
    /// Sliding speed u_2 − u_1, m/s.
    pub sliding_speed: f64,
    /// Slide-to-roll ratio (u_2 − u_1)/u_m; infinite where the entrainment vanishes.
    pub slide_to_roll_ratio: f64,
    /// Force along the motion of the follower that the cam must give, N; not positive where contact is lost.
    pub force: f64,
    /// Load per length, N/m; 0 where contact is lost.
    pub load_per_length: f64,
    /// Half-width of the Hertz contact, m; 0 where contact is lost or the cam undercut.
    pub half_width: f64,
    /// Largest Hertz pressure, Pa; 0 where contact is lost or the cam undercut.
    pub hertz_pressure: f64,
    /// Whether the entrainment speed changes its sign before the next point.
    pub entrainment_reverses: bool,
    /// Whether the cam is concave here.
    pub concave: bool,
    /// Whether the cam cannot be made here.
    pub undercut: bool,
    /// Whether the follower leaves the cam.
    pub contact_lost: bool,
}

/// Bars of a contact whose lift is that of a table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CamBars {
    /// Of s'', m.
    pub lift_acceleration: f64,
    /// Of the reduced radius, m.
    pub reduced_radius: f64,
    /// Of the largest Hertz pressure, Pa.
    pub hertz_pressure: f64,
    /// Of the entrainment speed, m/s.
    pub entrainment_speed: f64,
}

impl CamPoint {
    /// The line contact of this angle, x being along the motion; `None` where contact is lost or the cam undercut.
    pub fn line_contact(&self) -> Option<Contact> {
        if self.contact_lost || self.undercut {
            return None;
        }
        let curvatures = [self.radius_body_1, self.radius_body_2].map(|r| [r.recip(), 0.0]);
        Some(Contact::line(self.reduced_radius, self.load_per_length).between(curvatures))
    }

    /// The motion of the surfaces in it, x turned so that the entrainment is positive; `None` where it vanishes.
    pub fn motion(&self) -> Option<Motion> {
        let entrainment = self.entrainment_speed.abs();
        (entrainment > 0.0).then(|| Motion::straight(entrainment, self.slide_to_roll_ratio))
    }
}

impl Cam {
    /// A cam of a base radius r_b (m), at s = 0.
    ///
    /// # Errors
    ///
    /// Numbers out of range.
    pub fn new(law: LiftLaw, follower: Follower, base_radius: f64) -> Result<Cam, CamError> {
        in_range("base radius", base_radius, base_radius > 0.0, "positive")?;
        law.check()?;
        follower.check(base_radius)?;
        Ok(Cam {
            law,
            follower,
            base_radius,
        })
    }

    /// The law of lift.
    pub fn law(&self) -> &LiftLaw {
        &self.law
    }

    /// n contacts at equal steps of a turn, from θ = 0 on.
    ///
    /// # Errors
    ///
    /// Numbers out of range. Undercut, concave and lost contacts are marked at their points.
    pub fn turn(&self, operation: &CamOperation, n: usize) -> Result<Vec<CamPoint>, CamError> {
        operation.check()?;
        in_range("number of points", n as f64, n > 0, "positive")?;
        let mut points: Vec<CamPoint> = (0..n)
            .map(|i| self.contact(operation, TAU * i as f64 / n as f64))
            .collect();
        for i in 0..n {
            let next = points[(i + 1) % n].entrainment_speed;
            points[i].entrainment_reverses = (points[i].entrainment_speed > 0.0) != (next > 0.0);
        }
        Ok(points)
    }

    /// The contact at the angle θ (rad).
    ///
    /// F = F_0 + c s + m ω² s'' + F_extra,  w = F/(b cos φ)
    ///
    /// without friction. [`CamPoint::entrainment_reverses`] is left to [`Cam::turn`].
    ///
    /// # Errors
    ///
    /// Numbers out of range.
    pub fn at(&self, operation: &CamOperation, angle: f64) -> Result<CamPoint, CamError> {
        operation.check()?;
        in_range("angle", angle, true, "a finite number")?;
        Ok(self.contact(operation, angle))
    }

    /// Angles (rad) from 0 to 2π at which the entrainment speed changes its sign, found between n equal steps and closed in by bisection; at jumps of s'' these
    /// are the jumps.
    ///
    /// # Errors
    ///
    /// As [`Cam::turn`].
    pub fn reversals(&self, operation: &CamOperation, n: usize) -> Result<Vec<f64>, CamError> {
        let step = TAU / n.max(1) as f64;
        let is_positive = |angle| self.contact(operation, angle).entrainment_speed > 0.0;
        let points = self.turn(operation, n)?;
        let starts = points.iter().filter(|point| point.entrainment_reverses);
        Ok(starts
            .map(|point| {
                let (mut from, mut to) = (point.angle, point.angle + step);
                let before = is_positive(from);
                for _ in 0..60 {
                    let middle = 0.5 * (from + to);
                    if is_positive(middle) == before {
                        from = middle;
                    } else {
                        to = middle;
                    }
                }
                0.5 * (from + to)
            })
            .collect())
    }

    /// By how much figures of the contact at the angle θ (rad) may be off, as s'' of a table of lifts is.
    pub fn bars(&self, operation: &CamOperation, angle: f64) -> CamBars {
        let lift = self.law.at(angle);
        let bar = self.law.acceleration_bar(angle);
        let own = self.contact_with(operation, angle, lift);
        let sides = [-bar, bar]
            .map(|by| self.contact_with(operation, angle, [lift[0], lift[1], lift[2] + by]));
        let off = |of: fn(&CamPoint) -> f64| {
            let each = sides.iter().map(|side| (of(side) - of(&own)).abs());
            each.fold(0.0, f64::max)
        };
        CamBars {
            lift_acceleration: bar,
            reduced_radius: off(|point| point.reduced_radius),
            hertz_pressure: off(|point| point.hertz_pressure),
            entrainment_speed: off(|point| point.entrainment_speed),
        }
    }

    /// By how much the angle (rad) of a reversal may be off: as far as the entrainment speed stays within its bar, half a turn at most.
    pub fn reversal_bar(&self, operation: &CamOperation, reversal: f64) -> f64 {
        const STEPS: usize = 3600;
        let is_open = |angle: f64| {
            let bar = self.bars(operation, angle).entrainment_speed;
            self.contact(operation, angle).entrainment_speed.abs() < bar
        };
        let far = |sign: f64| {
            let step = |n: usize| n as f64 * TAU / STEPS as f64;
            let end = (1..STEPS / 2).find(|n| !is_open(reversal + sign * step(*n)));
            step(end.unwrap_or(STEPS / 2))
        };
        match self.law.acceleration_bar(reversal) > 0.0 {
            true => far(-1.0).max(far(1.0)),
            false => 0.0,
        }
    }

    fn contact(&self, operation: &CamOperation, angle: f64) -> CamPoint {
        self.contact_with(operation, angle, self.law.at(angle))
    }

    /// The contact where the lift and its derivatives are these.
    fn contact_with(&self, operation: &CamOperation, angle: f64, lift: [f64; 3]) -> CamPoint {
        let place = self.follower.place(self.base_radius, lift);
        let [u_1, u_2] = place.speeds.map(|speed| operation.speed * speed);
        let entrainment_speed = 0.5 * (u_1 + u_2);
        let inertia = operation.mass * operation.speed * operation.speed * lift[2];
        let spring = operation.preload + operation.spring_rate * lift[0];
        let force = spring + inertia + operation.extra_force;
        let contact_lost = force <= 0.0;
        let load_per_length = if contact_lost {
            0.0
        } else {
            force / (operation.width * place.pressure_angle.cos())
        };
        let [half_width, hertz_pressure] = if contact_lost || place.undercut {
            [0.0; 2]
        } else {
            let line = Contact::line(place.reduced_radius, load_per_length);
            let hertz = Hertz::new(&line, operation.reduced_modulus);
            [hertz.half_width, hertz.pressure]
        };
        CamPoint {
            angle,
            lift: lift[0],
            lift_velocity: lift[1],
            lift_acceleration: lift[2],
            contact: place.contact,
            pressure_angle: place.pressure_angle,
            radius_body_1: self.follower.radius(),
            radius_body_2: place.cam_curvature.recip(),
            reduced_radius: place.reduced_radius,
            u_1,
            u_2,
            entrainment_speed,
            sliding_speed: u_2 - u_1,
            slide_to_roll_ratio: (u_2 - u_1) / entrainment_speed,
            force,
            load_per_length,
            half_width,
            hertz_pressure,
            entrainment_reverses: false,
            concave: place.cam_curvature < 0.0 && !place.undercut,
            undercut: place.undercut,
            contact_lost,
        }
    }
}

impl CamOperation {
    fn check(&self) -> Result<(), CamError> {
        in_range(
            "cam speed",
            self.speed,
            self.speed != 0.0,
            "other than zero",
        )?;
        in_range("width", self.width, self.width > 0.0, "positive")?;
        in_range("mass", self.mass, self.mass >= 0.0, "not negative")?;
        let rate = self.spring_rate;
        in_range("spring rate", rate, rate >= 0.0, "not negative")?;
        in_range("preload", self.preload, true, "a finite number")?;
        in_range("extra force", self.extra_force, true, "a finite number")?;
        let modulus = self.reduced_modulus;
        in_range("reduced modulus", modulus, modulus > 0.0, "positive")
    }
}
