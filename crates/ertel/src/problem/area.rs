//! The contact area of a case and the bodies that grow with it.

use super::outlet::{self, ToHalves};
use crate::contact::{Family, Inlet, Outline, Shape, hertz};
use crate::params::{ElasticModel, MeshParams};
use crate::solve::discretisation::Extents;

/// Ratio of the gap at the inlet edge to the central film from which the inlet counts as flooded.
///
/// 80 gives the thesis's contact area for thin films. The thicker the film, the more of the load is
/// carried outside the Hertz zone (a rigid ball's falls off only as 1/r), and the farther the edge
/// must be: measured at M = 5, L = 0, the central film still grows by 3 % from 20 to 40
/// half-widths.
fn flooded(film: f64) -> f64 {
    let [thin, thick] = FLOODED;
    (thin * (film / 0.1).powf(1.5)).clamp(thin, thick)
}

/// That ratio for thin films, and the largest.
const FLOODED: [f64; 2] = [80.0, 1e4];

/// Distance of the inlet edge under thin films, in half-widths, as in the thesis.
const INLET: f64 = 4.5;

/// Distance of the side edge at least, in half-widths, as in the thesis.
const SIDE: f64 = 3.0;

/// Width and depth of bodies at least, in half-widths, and over the farthest edge of the area.
const BODY: f64 = 60.0;
const BODY_OVER_AREA: f64 = 4.0;

/// How much wider the area is above half-spaces in line contacts, and in point contacts whose film is thin.
const WIDENING_OF_LINES: f64 = 2.5;
const WIDENING_OF_POINTS: f64 = 5.0;

/// How much wider the area is above half-spaces, where no body grows with it and far cells are few.
///
/// Measured, by what the adjoint says of the edges: in circular contacts their effect on the films falls with the reach itself where
/// the film is thick (M = 1 to 5: 0.3 % at 2.5, 0.09 % at 10, 0.04 % at 20, 0.024 % at 35), with its square or so where it is thin (M = 200: 1e-4 at 2.5, 3e-5 at 5); in
/// line contacts it is 4e-6 at 2.5.
fn widening(family: Family, film: f64) -> f64 {
    match family {
        Family::Cylinder => WIDENING_OF_LINES,
        Family::Point => {
            let film = film.min(1.0);
            WIDENING_OF_POINTS + 15.0 * film * (1.0 + film)
        }
    }
}

/// How far the contact area of a case goes where the user does not set its edges.
#[derive(Clone, Copy)]
pub(super) struct Reach {
    pub(super) inlet: f64,
    pub(super) side: f64,
}

/// The thesis's contact area where the film is thin; longer where a thick film builds up further out.
pub(super) fn reach(family: Family, model: ElasticModel, heats: bool, film: f64) -> Reach {
    let mut inlet = INLET;
    let target = flooded(film) * film;
    while hertz::dry_gap(family, inlet) < target {
        inlet = (1.05 * inlet).ceil_half();
    }
    // A finite-element body grows with the contact area; half-spaces afford a wider one.
    if model == ElasticModel::HalfSpace && !heats {
        inlet *= widening(family, film);
        return Reach { inlet, side: inlet };
    }
    Reach {
        inlet,
        side: inlet * 2.0 / 3.0,
    }
}

/// Contact area, and the body that grows with it.
pub(super) fn extents(reach: Reach, mesh: &MeshParams, film: f64, shape: &Shape) -> Extents {
    let inlet = mesh.inlet.unwrap_or(-reach.inlet);
    let outlet = mesh.outlet.unwrap_or_else(|| {
        let is_flooded =
            shape.inlet == Inlet::Flooded && matches!(shape.outline(), Outline::Ellipse);
        if let Some(far) = outlet::behind_thick(film, reach.inlet).filter(|_| is_flooded) {
            return far;
        }
        if !shape.zone.turn.is_none() {
            return outlet::at_an_angle(film);
        }
        // The dry contact of a short or crowned roller is wider in places than that of its line (ISO profile, 12 half-widths long: 1.5).
        let widest = shape
            .zone
            .roller
            .as_ref()
            .map_or(1.0, |r| r.half_extents()[0]);
        outlet::behind(widest, film).max((widest + BEYOND_ROLLER).ceil_half())
    });
    let side = mesh.side.unwrap_or_else(|| {
        // The film ends with the roller.
        if let Some(roller) = &shape.zone.roller {
            return roller.side();
        }
        SIDE.max(reach.side.ceil_half())
            .min(end_across(shape, inlet.abs()))
    });
    let widest = inlet.abs().max(outlet).max(side);
    let body = BODY.max(BODY_OVER_AREA * widest);
    Extents {
        inlet,
        outlet,
        side,
        body_width: mesh.body_width.unwrap_or(body),
        body_depth: mesh.body_depth.unwrap_or(body),
    }
}

/// Where bodies end along the longer axis, for the edge of the contact area: of ellipses that are wide there and whose films do not feel it, since the oil
/// that enters by that edge passes the dry contact.
///
/// Measured on the inner ring of a 6206 (1.05 kN, 3000 rpm), whose ball ends at 3.4 half-widths: with edges at 2.25, 3, 5 and 26 half-widths both films
/// are the same to a tenth of their error bars.
fn end_across(shape: &Shape, inlet: f64) -> f64 {
    let ratio = shape.zone.axis_ratio;
    let end = (shape.ends[1] / ratio).floor_half().max(NEAREST_SIDE);
    match ratio > WIDE && shape.zone.is_passed_from(end, inlet) {
        true => end,
        false => f64::INFINITY,
    }
}

/// Axis ratio beyond which an ellipse is wide, and the nearest edge across the motion, in half-widths.
const WIDE: f64 = 1.5;
const NEAREST_SIDE: f64 = 2.0;

/// Distance of the outlet edge from the widest place of the dry contact of a roller at least, in half-widths of its line.
const BEYOND_ROLLER: f64 = 0.3;
