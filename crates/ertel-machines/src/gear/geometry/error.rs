//! Errors and warnings about a pair of gears.

use std::fmt;

use thiserror::Error;

/// One of the two gears.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Member {
    /// Body 2.
    Pinion,
    /// Body 1.
    Wheel,
}

impl Member {
    /// Pinion first, as in the arrays of this module.
    pub const BOTH: [Member; 2] = [Member::Pinion, Member::Wheel];

    /// The other gear.
    #[must_use]
    pub fn other(self) -> Member {
        match self {
            Member::Pinion => Member::Wheel,
            Member::Wheel => Member::Pinion,
        }
    }

    /// Index into arrays of both gears.
    pub fn index(self) -> usize {
        match self {
            Member::Pinion => 0,
            Member::Wheel => 1,
        }
    }
}

impl fmt::Display for Member {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Member::Pinion => "pinion",
            Member::Wheel => "wheel",
        })
    }
}

/// Why a pair of gears, or an operation of one, is refused.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum GearError {
    /// A number is outside the range in which it makes sense.
    #[error("{name} = {value} must be {requirement}")]
    Value {
        /// Name of the number.
        name: &'static str,
        /// The number, in SI.
        value: f64,
        /// The range.
        requirement: &'static str,
    },
    /// The wheel of an internal pair has too few teeth.
    #[error("an internal wheel of {wheel} teeth cannot take a pinion of {pinion}")]
    InternalTeeth {
        /// Teeth of the pinion.
        pinion: u32,
        /// Teeth of the wheel.
        wheel: u32,
    },
    /// The base circles overlap, so no line touches both from the sides that are needed.
    #[error(
        "the centre distance {centre_distance} m is below {smallest} m, at which the base circles would touch"
    )]
    CentreDistance {
        /// Centre distance, m.
        centre_distance: f64,
        /// Smallest centre distance, m.
        smallest: f64,
    },
    /// The profile shifts are so negative that no pressure angle fits them.
    #[error("no working pressure angle fits the sum of profile shift coefficients {sum}")]
    ProfileShift {
        /// x_1 + x_2.
        sum: f64,
    },
    /// Both the centre distance and both profile shifts are given, and they disagree.
    #[error(
        "the centre distance {given} m disagrees with {from_shifts} m, which follows from the profile shifts"
    )]
    Inconsistent {
        /// Centre distance as given, m.
        given: f64,
        /// Centre distance without backlash, m.
        from_shifts: f64,
    },
    /// The tip circle of a gear leaves no involute on its teeth.
    #[error(
        "the tip circle of the {member}, {diameter} m, leaves no involute: the base circle is {base} m"
    )]
    TipInsideBase {
        /// Which gear.
        member: Member,
        /// Tip diameter, m.
        diameter: f64,
        /// Base diameter, m.
        base: f64,
    },
    /// The flanks of a tooth meet before its tip circle.
    #[error(
        "the teeth of the {member} are pointed before their tip circle: their thickness there would be {thickness} m"
    )]
    Pointed {
        /// Which gear.
        member: Member,
        /// Tip thickness in the transverse section, m; not positive.
        thickness: f64,
    },
    /// Pairs of teeth do not take over from each other.
    #[error("the transverse contact ratio {ratio} is below 1")]
    ContactRatio {
        /// ε_α.
        ratio: f64,
    },
    /// Tips of an internal pair collide outside the path of contact.
    #[error(
        "the tips of the pinion and the internal wheel collide: the wheel needs more teeth than {wheel} for a pinion of {pinion}"
    )]
    InternalTips {
        /// Teeth of the pinion.
        pinion: u32,
        /// Teeth of the wheel.
        wheel: u32,
    },
    /// A law of load sharing is requested outside its range.
    #[error("load sharing {law} is for {requirement}")]
    Sharing {
        /// Which law.
        law: &'static str,
        /// Its range.
        requirement: &'static str,
    },
}

/// Warnings about a pair of gears that can be computed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum GearWarning {
    /// The tip of the other gear reaches inside the base circle of this one, where there is no involute; the path of contact is cut there.
    TipBeyondTangent {
        /// The gear whose base circle is passed.
        member: Member,
    },
    /// A rack cutter of the basic rack undercuts the teeth of this gear.
    Undercut {
        /// Which gear.
        member: Member,
    },
    /// The path of contact uses flank below the form circle, where the rack cutter leaves no involute.
    BelowForm {
        /// Which gear.
        member: Member,
        /// Form diameter of the root, m.
        form_diameter: f64,
        /// Smallest diameter at which this gear is touched, m.
        contact_diameter: f64,
    },
    /// Tips of one gear reach the root of the other.
    NoClearance {
        /// The gear whose root is reached.
        member: Member,
        /// Clearance, m; not positive.
        clearance: f64,
    },
}

impl fmt::Display for GearWarning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            GearWarning::TipBeyondTangent { member } => write!(
                f,
                "the tips of the {} reach inside the base circle of the {member}: the path of contact ends there",
                member.other()
            ),
            GearWarning::Undercut { member } => {
                write!(f, "the teeth of the {member} are undercut by a rack cutter")
            }
            GearWarning::BelowForm {
                member,
                form_diameter,
                contact_diameter,
            } => write!(
                f,
                "contact on the {member} extends down to a diameter of {contact_diameter:.6} m, but its involute ends at {form_diameter:.6} m"
            ),
            GearWarning::NoClearance { member, clearance } => write!(
                f,
                "the tips of the {} reach the root of the {member}: the clearance is {clearance:.3e} m",
                member.other()
            ),
        }
    }
}
