//! Geometry of a contact as the solver uses it.

use std::sync::Arc;

use super::gap::{GapTerm, RollerGap};
use super::roller::{RollerZone, Slices};
use super::{
    Contact, ContactKind, Family, Gap, Hertz, HertzZone, Inlet, Motion, Roller, Turn, hertz,
};

/// Which part of the contact is solved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Symmetry {
    /// All of it.
    Full,
    /// The half y ≤ 0, which represents both.
    Half,
}

impl Symmetry {
    /// Number of solved parts that make up the contact.
    pub fn multiplicity(self) -> f64 {
        match self {
            Symmetry::Full => 1.0,
            Symmetry::Half => 2.0,
        }
    }
}

/// Geometry of a contact and of its oil, dimensionless; X along the entrainment.
#[derive(Clone, Debug, PartialEq)]
pub struct Shape {
    /// Dimension of the contact area: 1 for line contacts, with loads per length, else 2.
    pub dim: usize,
    /// The undeformed gap.
    pub gap: Gap,
    /// Where the dry contact carries pressure.
    pub zone: HertzZone,
    /// Which part of the contact is solved.
    pub symmetry: Symmetry,
    /// How much oil reaches it.
    pub inlet: Inlet,
    /// How far the bodies face each other along the principal directions, in half-widths; infinite where they do not end.
    pub ends: [f64; 2],
}

impl Shape {
    /// A cylinder.
    pub const LINE: Shape = Shape {
        dim: 1,
        gap: Gap::paraboloid(0.0),
        zone: HertzZone {
            axis_ratio: 1.0,
            turn: Turn::NONE,
            roller: None,
        },
        symmetry: Symmetry::Full,
        inlet: Inlet::Flooded,
        ends: [f64::INFINITY; 2],
    };

    /// A ball.
    pub const CIRCULAR: Shape = Shape {
        dim: 2,
        gap: Gap::paraboloid(1.0),
        zone: HertzZone {
            axis_ratio: 1.0,
            turn: Turn::NONE,
            roller: None,
        },
        symmetry: Symmetry::Half,
        inlet: Inlet::Flooded,
        ends: [f64::INFINITY; 2],
    };

    /// Of a roller of the reduced radius R (m) whose line contact has the half-width b (m); with the dry contact of a `similar` shape if its gap is the same.
    fn of_roller(roller: &Roller, radius: f64, half_width: f64, similar: Option<&Shape>) -> Shape {
        let gap = RollerGap::new(roller.clone(), half_width, half_width * half_width / radius);
        let half_length = 0.5 * roller.length / half_width;
        let known =
            similar.filter(|shape| shape.gap.terms.first() == Some(&GapTerm::Roller(gap.clone())));
        let known = known.and_then(|shape| shape.zone.roller.clone());
        let zone = known.filter(|zone| zone.half_length() == half_length);
        let zone = zone.unwrap_or_else(|| {
            let slices = Slices::new(half_length, |y| gap.at([0.0, y]).value);
            let kinks = roller.profile.kinks();
            let kinks: Vec<f64> = kinks.iter().map(|y| y / half_width).collect();
            Arc::new(RollerZone::new(half_length, |y| slices.load(y), &kinks))
        });
        Shape {
            dim: 2,
            gap: Gap {
                terms: vec![GapTerm::Roller(gap)],
                ..Gap::paraboloid(0.0)
            },
            zone: HertzZone {
                roller: Some(zone),
                ..Shape::LINE.zone
            },
            symmetry: match roller.is_symmetric() {
                true => Symmetry::Half,
                false => Symmetry::Full,
            },
            ..Shape::LINE
        }
    }

    /// Of a contact with its Hertz theory, in some motion: all of it is solved unless its halves are equal.
    ///
    /// # Panics
    /// For rollers without a length.
    pub fn new(contact: &Contact, hertz: &Hertz, motion: &Motion) -> Shape {
        Shape::near(contact, hertz, motion, None)
    }

    /// The same, without solving the dry contact of a roller again if a `similar` shape has it.
    ///
    /// # Panics
    /// For rollers without a length.
    pub fn near(
        contact: &Contact,
        hertz: &Hertz,
        motion: &Motion,
        similar: Option<&Shape>,
    ) -> Shape {
        let turn = Turn::by(contact.entrainment_angle);
        let shape = match (contact.kind, &contact.roller) {
            (_, Some(roller)) => {
                Shape::of_roller(roller, contact.radius, hertz.half_width, similar)
            }
            (ContactKind::Roller, None) => panic!("a roller has a length"),
            (ContactKind::Line, None) => Shape::LINE,
            (ContactKind::Circular, None) => Shape::CIRCULAR,
            (ContactKind::Elliptical, None) => Shape {
                dim: 2,
                gap: Gap {
                    turn,
                    ..Gap::paraboloid(contact.radius / contact.radius_y)
                },
                zone: HertzZone {
                    axis_ratio: hertz.half_width_y.map_or(1.0, |b| b / hertz.half_width),
                    turn,
                    roller: None,
                },
                symmetry: match turn.is_none() {
                    true => Symmetry::Half,
                    false => Symmetry::Full,
                },
                ..Shape::LINE
            },
        };
        let ends = contact.ends().map(|end| end / hertz.half_width);
        let shape = Shape { ends, ..shape };
        match motion.is_straight() {
            true => shape,
            false => Shape {
                symmetry: Symmetry::Full,
                ..shape
            },
        }
    }

    /// The same where this much oil reaches the contact.
    #[must_use]
    pub fn with_inlet(self, inlet: Inlet) -> Shape {
        Shape { inlet, ..self }
    }

    /// Whether another shape is the same but for rounding; layers of oil may differ.
    pub fn is_like(&self, other: &Shape) -> bool {
        let close = |a: f64, b: f64| (a - b).abs() <= 1e-12 * (a.abs() + b.abs());
        let [c, s] = self.zone.turn.to_axes([1.0, 0.0]);
        let [d, t] = other.zone.turn.to_axes([1.0, 0.0]);
        // Rollers of other loads have other lengths in half-widths; where their dry contact lies follows from the gap.
        self.gap.terms == other.gap.terms
            && self.dim == other.dim
            && self.symmetry == other.symmetry
            && self.inlet.is_like(&other.inlet)
            && close(self.gap.curvature_ratio, other.gap.curvature_ratio)
            && close(self.zone.axis_ratio, other.zone.axis_ratio)
            && (c - d).abs() + (s - t).abs() < 1e-12
    }

    /// Whether it is a line contact.
    pub fn is_line(&self) -> bool {
        self.dim == 1
    }

    /// Shape of the dry contact.
    pub fn outline(&self) -> Outline<'_> {
        match &self.zone.roller {
            Some(roller) => Outline::Roller(roller),
            None if self.is_line() => Outline::Strip,
            None => Outline::Ellipse,
        }
    }

    /// Target of ∫P over the part that is solved.
    pub fn load(&self) -> f64 {
        let whole = match self.outline() {
            Outline::Strip => hertz::load_integral(Family::Cylinder),
            Outline::Ellipse => hertz::load_integral(Family::Point) * self.zone.axis_ratio,
            Outline::Roller(roller) => {
                hertz::load_integral(Family::Cylinder) * (2.0 * roller.half_length())
            }
        };
        whole / self.symmetry.multiplicity()
    }
}

/// Outline of the dry contact.
#[derive(Clone, Copy, Debug)]
pub enum Outline<'a> {
    /// Two parallel lines.
    Strip,
    /// An ellipse, or a circle.
    Ellipse,
    /// Nearly a rectangle.
    Roller(&'a RollerZone),
}
