//! Input dimensions of a pair of gears.

use super::GearError;

/// Whether the wheel has its teeth outside or inside.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Meshing {
    /// Two external gears.
    External,
    /// An external pinion in an internal wheel.
    Internal,
}

impl Meshing {
    /// The sign of the wheel's teeth and diameters in ISO 21771: 1, or −1 of an internal wheel.
    pub fn sign(self) -> f64 {
        match self {
            Meshing::External => 1.0,
            Meshing::Internal => -1.0,
        }
    }
}

/// The basic rack in normal modules; as in ISO 53, profile A, by default.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BasicRack {
    /// Addendum h_aP/m_n.
    pub addendum: f64,
    /// Dedendum h_fP/m_n.
    pub dedendum: f64,
    /// Root radius ρ_fP/m_n.
    pub root_radius: f64,
}

impl Default for BasicRack {
    fn default() -> BasicRack {
        BasicRack {
            addendum: 1.0,
            dedendum: 1.25,
            root_radius: 0.38,
        }
    }
}

/// How tip circles follow from the basic rack where tip diameters are not given: d_a = d + 2 m_n (h_aP* + x + k).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TipAlteration {
    /// k = 0.
    None,
    /// The tip clearance of the basic rack is kept: k = (a_w − a)/m_n − (x_1 + x_2).
    KeepClearance,
}

/// The curve of a tip relief.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ReliefShape {
    /// C = C_a ξ.
    Linear,
    /// C = C_a ξ².
    Parabolic,
}

/// Material taken off towards the tip, normal to the flank.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Relief {
    /// Amount C_a at the tip, m.
    pub amount: f64,
    /// Length along the path of contact from its end at this tip, m.
    pub length: f64,
    /// Curve.
    pub shape: ReliefShape,
}

impl Relief {
    /// Relief (m) at a distance (m) from the end of the path of contact at this tip: C_a ξ or C_a ξ², ξ = 1 − distance/length, none beyond the length.
    pub fn at(&self, distance: f64) -> f64 {
        let xi = (1.0 - distance / self.length).max(0.0);
        self.amount
            * match self.shape {
                ReliefShape::Linear => xi,
                ReliefShape::Parabolic => xi * xi,
            }
    }
}

/// A pair of cylindrical gears; arrays have the pinion first.
///
/// Tooth numbers, diameters and the centre distance are positive, those of internal wheels too. The profile shift of an internal wheel has the sign of
/// ISO 21771: positive makes its teeth thicker and its tip diameter smaller.
#[derive(Clone, Debug, PartialEq)]
pub struct GearDimensions {
    /// External or internal wheel.
    pub meshing: Meshing,
    /// Normal module m_n, m.
    pub normal_module: f64,
    /// Numbers of teeth.
    pub teeth: [u32; 2],
    /// Normal pressure angle α_n, rad.
    pub normal_pressure_angle: f64,
    /// Helix angle β at the reference cylinder, rad; the hand does not matter.
    pub helix_angle: f64,
    /// Profile shift coefficient x of the pinion.
    pub pinion_shift: f64,
    /// Profile shift coefficient x of the wheel; if absent, that which leaves no backlash at the centre distance, or 0 without a centre distance.
    pub wheel_shift: Option<f64>,
    /// Working centre distance a_w, m; if absent, that without backlash.
    pub centre_distance: Option<f64>,
    /// Tip diameters, m; if absent, from the basic rack.
    pub tip_diameters: [Option<f64>; 2],
    /// Tip alteration where tip diameters are absent.
    pub tip_alteration: TipAlteration,
    /// Root diameters, m; if absent, from the basic rack.
    pub root_diameters: [Option<f64>; 2],
    /// Face widths, m; contact is on the smaller.
    pub face_widths: [f64; 2],
    /// Basic rack.
    pub basic_rack: BasicRack,
    /// Tip reliefs.
    pub reliefs: [Option<Relief>; 2],
}

impl GearDimensions {
    /// An external spur pair without profile shift, on the standard rack: normal module (m), teeth, pressure angle (rad) and face width (m).
    pub fn spur(module: f64, teeth: [u32; 2], pressure_angle: f64, width: f64) -> GearDimensions {
        GearDimensions {
            meshing: Meshing::External,
            normal_module: module,
            teeth,
            normal_pressure_angle: pressure_angle,
            helix_angle: 0.0,
            pinion_shift: 0.0,
            wheel_shift: None,
            centre_distance: None,
            tip_diameters: [None; 2],
            tip_alteration: TipAlteration::None,
            root_diameters: [None; 2],
            face_widths: [width; 2],
            basic_rack: BasicRack::default(),
            reliefs: [None; 2],
        }
    }

    /// Refuses numbers that no gear can have.
    pub(super) fn check(&self) -> Result<(), GearError> {
        let positive = |name, value: f64| in_range(name, value, value > 0.0, "positive");
        positive("normal module", self.normal_module)?;
        for width in self.face_widths {
            positive("face width", width)?;
        }
        for diameter in self.tip_diameters.into_iter().flatten() {
            positive("tip diameter", diameter)?;
        }
        for diameter in self.root_diameters.into_iter().flatten() {
            positive("root diameter", diameter)?;
        }
        if let Some(distance) = self.centre_distance {
            positive("centre distance", distance)?;
        }
        for teeth in self.teeth.map(f64::from) {
            let requirement = "from 3 to 100 000";
            in_range(
                "number of teeth",
                teeth,
                (3.0..=1e5).contains(&teeth),
                requirement,
            )?;
        }
        let alpha = self.normal_pressure_angle;
        let requirement = "between 0 and π/4";
        let inside = alpha > 0.0 && alpha < std::f64::consts::FRAC_PI_4;
        in_range("normal pressure angle", alpha, inside, requirement)?;
        let beta = self.helix_angle;
        let inside = (0.0..=std::f64::consts::FRAC_PI_4).contains(&beta);
        in_range("helix angle", beta, inside, "from 0 to π/4")?;
        let shifts = [Some(self.pinion_shift), self.wheel_shift];
        for shift in shifts.into_iter().flatten() {
            in_range(
                "profile shift coefficient",
                shift,
                shift.abs() <= 10.0,
                "from −10 to 10",
            )?;
        }
        let rack = self.basic_rack;
        positive("addendum of the basic rack", rack.addendum)?;
        positive("dedendum of the basic rack", rack.dedendum)?;
        let rho = rack.root_radius;
        in_range(
            "root radius of the basic rack",
            rho,
            rho >= 0.0,
            "not negative",
        )?;
        for relief in self.reliefs.into_iter().flatten() {
            let amount = relief.amount;
            in_range("tip relief", amount, amount >= 0.0, "not negative")?;
            positive("length of a tip relief", relief.length)?;
        }
        let [pinion, wheel] = self.teeth;
        if self.meshing == Meshing::Internal && wheel <= pinion {
            return Err(GearError::InternalTeeth { pinion, wheel });
        }
        Ok(())
    }
}

/// An error unless the number is finite and inside its range.
pub(crate) fn in_range(
    name: &'static str,
    value: f64,
    inside: bool,
    requirement: &'static str,
) -> Result<(), GearError> {
    if inside && value.is_finite() {
        return Ok(());
    }
    Err(GearError::Value {
        name,
        value,
        requirement,
    })
}
