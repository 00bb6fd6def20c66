//! What the solver knows of a contact's geometry.

use super::{Contact, ContactKind, Gap, Hertz, HertzZone, Motion, Turn, hertz};

/// Which part of the contact is solved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Symmetry {
    /// All of it.
    Full,
    /// The half y ≤ 0, which stands for both.
    Half,
}

impl Symmetry {
    /// How often the part that is solved makes up the contact.
    pub fn multiplicity(self) -> f64 {
        match self {
            Symmetry::Full => 1.0,
            Symmetry::Half => 2.0,
        }
    }
}

/// Geometry of a contact, dimensionless; X along the entrainment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shape {
    /// Line, circular or elliptical.
    pub kind: ContactKind,
    /// The undeformed gap.
    pub gap: Gap,
    /// Where the dry contact carries pressure.
    pub zone: HertzZone,
    /// Which part of the contact is solved.
    pub symmetry: Symmetry,
}

impl Shape {
    /// A cylinder.
    pub const LINE: Shape = Shape {
        kind: ContactKind::Line,
        gap: Gap {
            curvature_ratio: 0.0,
            turn: Turn::NONE,
        },
        zone: HertzZone {
            axis_ratio: 1.0,
            turn: Turn::NONE,
        },
        symmetry: Symmetry::Full,
    };

    /// A ball.
    pub const CIRCULAR: Shape = Shape {
        kind: ContactKind::Circular,
        gap: Gap {
            curvature_ratio: 1.0,
            turn: Turn::NONE,
        },
        zone: HertzZone {
            axis_ratio: 1.0,
            turn: Turn::NONE,
        },
        symmetry: Symmetry::Half,
    };

    /// Of a contact with its Hertz theory, in some motion: all of it is solved where nothing makes its halves alike.
    pub fn new(contact: &Contact, hertz: &Hertz, motion: &Motion) -> Shape {
        let turn = Turn::by(contact.entrainment_angle);
        let shape = match contact.kind {
            ContactKind::Line => Shape::LINE,
            ContactKind::Circular => Shape::CIRCULAR,
            ContactKind::Elliptical => Shape {
                kind: contact.kind,
                gap: Gap {
                    curvature_ratio: contact.radius / contact.radius_y,
                    turn,
                },
                zone: HertzZone {
                    axis_ratio: hertz.half_width_y.map_or(1.0, |b| b / hertz.half_width),
                    turn,
                },
                symmetry: match turn.is_none() {
                    true => Symmetry::Half,
                    false => Symmetry::Full,
                },
            },
        };
        match motion.is_straight() {
            true => shape,
            false => Shape {
                symmetry: Symmetry::Full,
                ..shape
            },
        }
    }

    /// Whether another shape is the same but for rounding.
    pub fn is_like(&self, other: &Shape) -> bool {
        let close = |a: f64, b: f64| (a - b).abs() <= 1e-12 * (a.abs() + b.abs());
        let [c, s] = self.zone.turn.to_axes([1.0, 0.0]);
        let [d, t] = other.zone.turn.to_axes([1.0, 0.0]);
        self.kind == other.kind
            && self.symmetry == other.symmetry
            && close(self.gap.curvature_ratio, other.gap.curvature_ratio)
            && close(self.zone.axis_ratio, other.zone.axis_ratio)
            && (c - d).abs() + (s - t).abs() < 1e-12
    }

    /// Target of ∫P over the part that is solved.
    pub fn load(&self) -> f64 {
        hertz::load_integral(self.kind) * self.zone.axis_ratio / self.symmetry.multiplicity()
    }

    /// Area of the Hertz zone in the part that is solved.
    pub fn zone_area(&self) -> f64 {
        let whole = match self.kind {
            ContactKind::Line => 2.0,
            ContactKind::Circular | ContactKind::Elliptical => {
                std::f64::consts::PI * self.zone.axis_ratio
            }
        };
        whole / self.symmetry.multiplicity()
    }
}
