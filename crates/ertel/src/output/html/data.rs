//! What a page knows of a result: figures, fields on the mesh, profiles, iterations.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use serde_json::{Value, json};

use crate::case::CaseEcho;
use crate::contact::{Outline, Symmetry};
use crate::output::pictures::has_one_tolerance;
use crate::solution::{ContactFields, Field, Figure, Located, Solution};

/// Value of the key `format` of the data.
pub const DATA_FORMAT: &str = "ertel-report";
/// Version of the layout of the data.
pub const DATA_VERSION: u64 = 1;

/// Bytes of fields that a page holds at the most, before they are written as text; so it stays below 2 MB.
const MOST_BYTES: usize = 1_150_000;

/// Half-widths of the dry contact that maps reach beyond it.
const MARGIN: f64 = 1.5;

/// Fields on the contact area in the order in which they are kept where there is no room for all.
const BY_IMPORTANCE: [Field; 14] = [
    Field::Pressure,
    Field::FilmThickness,
    Field::TemperatureMid,
    Field::ShearStressMid,
    Field::TemperatureBody1,
    Field::TemperatureBody2,
    Field::TemperatureMean,
    Field::Viscosity,
    Field::GeneralizedViscosityMid,
    Field::ShearRateMid,
    Field::Deflection,
    Field::Density,
    Field::ShearStressBody1,
    Field::ShearStressBody2,
];

/// The data of one solution.
pub fn data(case: &CaseEcho, solution: &Solution, tolerance: f64) -> Value {
    let [zone_x, zone_y] = solution.shape.zone.half_extents();
    let a = solution.hertz.half_width;
    let history: Vec<Value> = (solution.history.iter())
        .map(|r| {
            json!({
                "stage": r.level + 1,
                "residual": r.residual,
                "update": r.update,
                "film_central": r.film_central,
                "heat_change": r.heat.map(|heat| heat.change),
            })
        })
        .collect();
    json!({
        "format": DATA_FORMAT,
        "version": DATA_VERSION,
        "title": case.title,
        "kind": solution.kind,
        "half_width": a,
        "zone": [a * zone_x, a * zone_y],
        "edge": edge(solution),
        "reference_temperature": case.temperature,
        "figures": figures(solution),
        "mesh": mesh(solution),
        "centreline": centreline(solution),
        "history": history,
        "tolerance": has_one_tolerance(solution).then_some(tolerance),
        "heat_tolerance": solution.thermal.as_ref().map(|t| t.coupling.tolerance),
    })
}

/// Straight pieces of the drawn edge of an elliptical zone.
const EDGE_PIECES: usize = 120;

/// Edge of the dry contact, m, as it lies against the motion: an ellipse, or the rectangle of a roller; nothing of a line.
fn edge(solution: &Solution) -> Value {
    let zone = &solution.shape.zone;
    let corners = match solution.shape.outline() {
        Outline::Strip => return Value::Null,
        Outline::Roller(_) => {
            let [x, y] = zone.half_extents();
            vec![[-x, -y], [x, -y], [x, y], [-x, y]]
        }
        Outline::Ellipse => (0..EDGE_PIECES)
            .map(|i| {
                let angle = std::f64::consts::TAU * i as f64 / EDGE_PIECES as f64;
                zone.place([angle.cos(), angle.sin()])
            })
            .collect(),
    };
    let a = solution.hertz.half_width;
    let scaled = corners.iter().map(|p| p.map(|x| (a * x) as f32));
    json!(scaled.collect::<Vec<_>>())
}

/// Every figure, with the places of those that have one; a page shows those large that have a symbol. The film first, by which maps are scaled.
fn figures(solution: &Solution) -> Vec<Value> {
    let is_line = solution.shape.is_line();
    let entry = |(figure, at): (Figure, Located)| {
        let uncertainty = (solution.uncertainty.as_ref()).and_then(|u| u.get(figure));
        let mut entry = json!({
            "name": figure.name(), "words": figure.words(), "symbol": figure.symbol(), "unit": figure.unit(is_line),
            "value": at.value, "error": at.error, "resolved": at.resolved,
            "uncertainty": uncertainty.map(|u| u.half_width), "is_peak": figure.is_peak(),
        });
        if figure.has_place() {
            entry["x"] = at.x.into();
            entry["y"] = at.y.into();
            entry["place_error"] = at.place_error.into();
            entry["place_resolved"] = at.place_resolved.into();
        }
        entry
    };
    let mut figures: Vec<Value> = solution.figures().map(entry).collect();
    // The centre is a place, too, though no one looks for it.
    figures[0]["x"] = 0.0.into();
    figures[0]["y"] = 0.0.into();
    if let Some(mixed) = &solution.mixed {
        let lambda = mixed.lambda_minimum;
        figures.push(json!({
            "name": "lambda_minimum", "words": "lambda ratio", "symbol": "λ", "unit": "",
            "value": lambda.value, "error": lambda.error, "resolved": lambda.is_resolved(),
        }));
    }
    figures
}

/// A field as text: its name, unit and values in single precision.
fn field(field: Field, values: impl Iterator<Item = f64>) -> Value {
    let bytes: Vec<u8> = values.flat_map(|v| (v as f32).to_le_bytes()).collect();
    json!({
        "name": field.name(),
        "words": field.words(),
        "unit": field.unit(),
        "values": STANDARD.encode(bytes),
    })
}

/// The elements of the contact and its margin with the fields on them; nothing of line contacts, whose profiles say all.
fn mesh(solution: &Solution) -> Value {
    let surface = &solution.surface;
    if solution.shape.is_line() || surface.elements.is_empty() {
        return Value::Null;
    }
    let temperatures = solution.thermal.as_ref().map(|t| &t.surface);
    let fields = ContactFields::columns(surface, temperatures);
    let a = solution.hertz.half_width;
    let zone = solution.shape.zone.half_extents();
    let reach = zone.map(|half| a * (half + MARGIN * zone[0].min(zone[1])));
    let per_element = (surface.order + 1) * (surface.order + 2) / 2;
    let is_near = |element: &&[u32]| {
        (element.iter().take(3)).any(|n| {
            let p = surface.points[*n as usize];
            p[0].abs() <= reach[0] && p[1].abs() <= reach[1]
        })
    };
    let near = surface.elements.chunks_exact(per_element).filter(is_near);
    let mut number = vec![u32::MAX; surface.points.len()];
    let (mut kept, mut nodes) = (Vec::new(), Vec::new());
    for node in near.flatten() {
        let own = &mut number[*node as usize];
        if *own == u32::MAX {
            *own = kept.len() as u32;
            kept.push(*node as usize);
        }
        nodes.push(*own);
    }
    let node_bytes = if kept.len() <= usize::from(u16::MAX) {
        2
    } else {
        4
    };
    let text = match node_bytes {
        2 => STANDARD.encode(bytes(&nodes, |n| (n as u16).to_le_bytes())),
        _ => STANDARD.encode(bytes(&nodes, u32::to_le_bytes)),
    };
    let room = MOST_BYTES.saturating_sub(node_bytes * nodes.len());
    let n_fields = (room / (4 * kept.len().max(1))).saturating_sub(2).max(2);
    let found = BY_IMPORTANCE.iter().filter_map(|wanted| {
        let (_, values) = fields.iter().find(|(own, _)| own == wanted)?;
        Some((*wanted, *values))
    });
    let (mut shown, mut left_out) = (Vec::new(), Vec::new());
    for (own, values) in found {
        match shown.len() < n_fields {
            true => shown.push(field(own, kept.iter().map(|i| values[*i]))),
            false => left_out.push(own.words()),
        }
    }
    let axis = |i: usize| {
        let values: Vec<f32> = kept.iter().map(|n| surface.points[*n][i] as f32).collect();
        STANDARD.encode(bytes(&values, f32::to_le_bytes))
    };
    json!({
        "order": surface.order,
        "mirrored": solution.shape.symmetry == Symmetry::Half,
        "reach": reach,
        "x": axis(0),
        "y": axis(1),
        "nodes": text,
        "node_bytes": node_bytes,
        "fields": shown,
        "left_out": left_out,
    })
}

pub(super) fn bytes<T: Copy, const N: usize>(values: &[T], of: impl Fn(T) -> [u8; N]) -> Vec<u8> {
    values.iter().flat_map(|v| of(*v)).collect()
}

/// The profiles along the centreline where there is a contact to see.
fn centreline(solution: &Solution) -> Value {
    let line = &solution.centreline;
    let a = solution.hertz.half_width;
    let [half, _] = solution.shape.zone.half_extents();
    let reach = a * (half + 2.0 * MARGIN);
    let near: Vec<usize> = (0..line.x.len())
        .filter(|i| line.x[*i].abs() <= reach)
        .collect();
    let temperatures = solution.thermal.as_ref().map(|t| &t.centreline);
    let fields: Vec<Value> = (line.columns(temperatures).into_iter())
        .filter(|(_, values)| !values.is_empty())
        .map(|(own, values)| field(own, near.iter().map(|i| values[*i])))
        .collect();
    let x: Vec<f32> = near.iter().map(|i| line.x[*i] as f32).collect();
    json!({ "x": STANDARD.encode(bytes(&x, f32::to_le_bytes)), "fields": fields })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::Turn;
    use crate::output::sample;

    /// The edge of an ellipse of half-axes a and 3 a whose first axis is turned by 30° against the motion: in its own axes
    /// each point has (x/a)² + (y/3a)² = 1.
    #[test]
    fn the_edge_of_a_turned_ellipse_is_turned() {
        let mut solution = sample::ellipse().1.clone();
        let a = solution.hertz.half_width;
        let angle = 30_f64.to_radians();
        for turned in [0.0, angle] {
            solution.shape.zone.axis_ratio = 3.0;
            solution.shape.zone.turn = match turned {
                0.0 => Turn::NONE,
                _ => Turn::by(turned),
            };
            let points: Vec<[f64; 2]> = serde_json::from_value(edge(&solution)).unwrap();
            assert_eq!(points.len(), EDGE_PIECES);
            let (sine, cosine) = turned.sin_cos();
            let off = |sine: f64| {
                let distances = points.iter().map(|[x, y]| {
                    let own = [cosine * x + sine * y, cosine * y - sine * x];
                    ((own[0] / a).powi(2) + (own[1] / (3.0 * a)).powi(2) - 1.0).abs()
                });
                distances.fold(0.0, f64::max)
            };
            // The sense of the angle is that of `Turn`.
            assert!(off(sine).min(off(-sine)) < 1e-5, "{}", off(sine));
            assert!(turned == 0.0 || off(0.0) > 0.1);
        }
    }
}
