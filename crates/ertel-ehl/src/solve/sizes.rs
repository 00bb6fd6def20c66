//! How large the cells of a contact area are, and how many there will be.

use ertel_fem::mesh::{SizeField, SizeZone, Zone};

use super::discretisation::Extents;
use crate::contact::roller::RollerZone;
use crate::contact::{Shape, Symmetry};
use crate::solve::tuning::meshes::{COVERED, OUTLET_FROM};

/// Cell sizes of one level and the region they cover, in Hertz half-widths.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LevelSizes {
    /// Cell size in the Hertz zone.
    pub hertz: f64,
    /// Cell size at the outlet constriction and the side lobes.
    pub constriction: f64,
    /// Cell size on the rim of the Hertz zone, where a thin film builds up and breaks off.
    pub rim: f64,
    /// The same on the outlet side, where the side lobes of heavily loaded contacts are much thinner than the film in the centre.
    pub outlet_rim: f64,
    /// Half the width of the strip along the rim.
    pub rim_width: f64,
    /// Largest cell size within three half-widths; beyond, it grows with the distance.
    pub edge: f64,
    /// Growth per distance along the surface.
    pub growth: f64,
    /// Growth per depth.
    pub depth_growth: f64,
}

/// Size field, where the Hertz zone is the unit circle: fine under the Hertz zone, finer in a crescent at its outlet side, `edge` on the
/// rest of the contact area, growing into the body.
pub(super) fn size_at(shape: &Shape, e: &Extents, s: &LevelSizes, x: [f64; 3]) -> f64 {
    if let Some(roller) = &shape.zone.roller {
        return size_of_roller(roller, s, [x[0], x[1]]);
    }
    let origin = [0.0; 3];
    let outlet_from = match (shape.is_line(), shape.symmetry) {
        (true, _) => 0.5,
        (false, Symmetry::Half) => OUTLET_FROM,
        // The mesh of an ellipse at an angle lies along the motion.
        (false, Symmetry::Full) if !shape.zone.turn.is_none() => OUTLET_FROM,
        // The outlet may lie on any side.
        (false, Symmetry::Full) => f64::NEG_INFINITY,
    };
    let zones = [
        SizeZone {
            zone: Zone::Disc {
                center: origin,
                radius: 1.0,
            },
            size: s.hertz,
        },
        SizeZone {
            zone: Zone::Arc {
                center: origin,
                radius: 0.95,
                half_width: 0.1,
                x_min: outlet_from,
            },
            size: s.constriction,
        },
        SizeZone {
            zone: Zone::Arc {
                center: origin,
                radius: 1.0,
                half_width: s.rim_width,
                x_min: f64::NEG_INFINITY,
            },
            size: s.rim,
        },
        SizeZone {
            zone: Zone::Arc {
                center: origin,
                radius: 1.0,
                half_width: s.rim_width,
                x_min: outlet_from,
            },
            size: s.outlet_rim,
        },
    ];
    // Far from the contact the film varies on the scale of the distance; beyond the contact area
    // there is no film.
    let r = x[0].hypot(x[1]);
    let side = if shape.is_line() { 0.0 } else { e.side };
    let area = Zone::Box {
        min: [e.inlet, -side, 0.0],
        max: [
            e.outlet,
            if shape.symmetry == Symmetry::Full {
                side
            } else {
                0.0
            },
            0.0,
        ],
    };
    let outside = area.distance([x[0], x[1], 0.0]);
    let largest = s.edge * (r / 3.0).max(1.0) + s.growth * outside;
    let surface = SizeField {
        zones: zones.to_vec(),
        growth: s.growth,
    }
    .size([x[0], x[1], 0.0]);
    surface.min(largest) + s.depth_growth * -x[2]
}

/// The same around the zone of a roller, in the plane where it is shortened: fine inside, finer along the outlet and at the ends.
fn size_of_roller(roller: &RollerZone, s: &LevelSizes, at: [f64; 2]) -> f64 {
    let (distance, inside) = roller.rim_distance(at);
    let signed = if inside { -distance } else { distance };
    // As the crescent of circles: from 0.15 inside to 0.05 outside.
    let from_band = ((signed + 0.05).abs() - 0.1).max(0.0);
    let outlet = |from: f64| match at[0] > OUTLET_FROM {
        true => from,
        false => from.hypot(OUTLET_FROM - at[0]),
    };
    let sizes = [
        s.hertz + s.growth * signed.max(0.0),
        s.constriction + s.growth * outlet(from_band),
        s.rim + s.growth * (distance - s.rim_width).max(0.0),
    ];
    let largest = s.edge * (at[0].abs() / 3.0).max(1.0);
    sizes.into_iter().fold(largest, f64::min)
}

/// Pressure unknowns of a given order that a mesh of these sizes has, within a third or so.
pub fn expected_unknowns(
    shape: &Shape,
    extents: &Extents,
    sizes: &LevelSizes,
    order: usize,
) -> f64 {
    let k = order as f64;
    if let Some(roller) = &shape.zone.roller {
        return 0.5 * k * k * cells_of_roller(roller, extents, sizes)
            / shape.symmetry.multiplicity();
    }
    let reach = (-extents.inlet).max(extents.outlet).max(extents.side);
    let size = |x: f64, y: f64| size_at(shape, extents, sizes, [x, y, 0.0]);
    // Rings around the rim whose widths grow with the distance from it, from a fraction of the finest cell on.
    let mut distances = vec![0.0];
    let finest = sizes.outlet_rim.min(sizes.constriction);
    let mut step = 0.25 * finest.min(sizes.rim_width);
    while *distances.last().expect("not empty") < reach + 1.0 {
        distances.push(distances.last().expect("not empty") + step);
        step *= 1.05;
    }
    let mut radii: Vec<f64> = (distances.iter())
        .flat_map(|d| [1.0 - d, 1.0 + d])
        .collect();
    radii.retain(|r| (0.0..=1.5 * reach).contains(r));
    radii.sort_by(f64::total_cmp);
    let inside =
        |x: f64, y: f64| (extents.inlet..=extents.outlet).contains(&x) && y.abs() <= extents.side;
    let mut cells = 0.0;
    for pair in radii.windows(2) {
        let (r, width) = (0.5 * (pair[0] + pair[1]), pair[1] - pair[0]);
        if shape.is_line() {
            let ends = [-r, r].into_iter().filter(|x| inside(*x, 0.0));
            cells += ends
                .map(|x| width / (COVERED[1] * size(x, 0.0)))
                .sum::<f64>();
            continue;
        }
        const ANGLES: usize = 48;
        for k in 0..ANGLES {
            let angle = std::f64::consts::PI * (k as f64 + 0.5) / ANGLES as f64;
            let (x, y) = (r * angle.cos(), -r * angle.sin());
            if inside(x, y) {
                let area = r * width * std::f64::consts::PI / ANGLES as f64;
                cells += area / (COVERED[0] * size(x, y).powi(2));
            }
        }
    }
    match shape.is_line() {
        true => k * cells,
        // Counted over one half.
        false => 0.5 * k * k * cells * (2.0 / shape.symmetry.multiplicity()),
    }
}

/// Cells of all of the film under a roller: in rows across, in steps that grow with the distance from the rim.
fn cells_of_roller(roller: &RollerZone, extents: &Extents, sizes: &LevelSizes) -> f64 {
    const ROWS: usize = 120;
    let height = 2.0 * roller.side() / ROWS as f64;
    let mut cells = 0.0;
    for row in 0..ROWS {
        let v = (row as f64 + 0.5) * height - roller.side();
        let mut u = extents.inlet;
        while u < extents.outlet {
            let size = size_of_roller(roller, sizes, [u, v]);
            let width = (0.5 * size).min(extents.outlet - u);
            let size = size_of_roller(roller, sizes, [u + 0.5 * width, v]);
            cells += width * height / (COVERED[0] * size * size);
            u += width;
        }
    }
    cells
}
