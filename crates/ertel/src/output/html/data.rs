//! Page data of a result: figures, fields on the mesh, profiles, iterations.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use serde_json::{Value, json};

use super::thin::{Bounded, contains, thin};
use crate::case::CaseEcho;
use crate::contact::{Outline, Symmetry};
use crate::output::pictures::has_one_tolerance;
use crate::solution::{ContactFields, Field, Figure, Located, Solution};

/// Value of the key `format` of the data.
pub const DATA_FORMAT: &str = "ertel-report";
/// Version of the layout of the data.
pub const DATA_VERSION: u64 = 1;

/// Maximum bytes of fields in a page before encoding; the page stays below 2 MB.
const MOST_BYTES: usize = 1_150_000;

/// Tolerances of thinned fields on meshes of many triangles: relative for the film, of the range for others.
/// The next tolerance is used if the fields do not fit.
const TOLERANCES: [f64; 3] = [1e-3, 3e-3, 1e-2];

/// Margin of the maps around the dry contact, in half-widths.
const MARGIN: f64 = 1.5;

/// Fields on the contact area in order of priority if not all fit.
const BY_IMPORTANCE: [Field; 15] = [
    Field::Pressure,
    Field::FilmThickness,
    Field::AsperityPressure,
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

/// Number of segments in the drawn edge of an elliptical zone.
const EDGE_PIECES: usize = 120;

/// Edge of the dry contact, m, in the axes of motion: an ellipse, or the rectangle of a roller; empty for a line.
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

/// Every figure, with its place if it has one; a page shows those with a symbol large. The film is first because it scales the maps.
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
    // The first figure is the central film, whose place the registry omits.
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

/// A field as text: name, unit, and values in single precision.
fn field(field: Field, values: impl Iterator<Item = f64>) -> Value {
    let bytes: Vec<u8> = values.flat_map(|v| (v as f32).to_le_bytes()).collect();
    json!({
        "name": field.name(),
        "words": field.words(),
        "unit": field.unit(),
        "values": STANDARD.encode(bytes),
    })
}

/// The elements of the contact and its margin with their fields; empty for line contacts, whose profiles are complete.
fn mesh(solution: &Solution) -> Value {
    let surface = &solution.surface;
    if solution.shape.is_line() || surface.elements.is_empty() {
        return Value::Null;
    }
    let temperatures = solution.thermal.as_ref().map(|t| &t.surface);
    let columns = ContactFields::columns(surface, temperatures);
    let found = BY_IMPORTANCE.iter().filter_map(|wanted| {
        let (_, values) = columns.iter().find(|(own, _)| own == wanted)?;
        Some((*wanted, *values))
    });
    let fields: Vec<(Field, &[f64])> = found.collect();
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
    let mut elements = Elements::new(surface.points.len(), near.flatten().copied().collect());
    let mut off_by = None;
    if surface.order == 1 {
        for tolerance in TOLERANCES {
            if elements.room_for() >= fields.len() {
                break;
            }
            elements = thinned(solution, &elements, &fields, tolerance);
            off_by = Some(tolerance);
        }
    }
    let n_fields = elements.room_for().max(2);
    let (mut shown, mut left_out) = (Vec::new(), Vec::new());
    for (own, values) in fields {
        match shown.len() < n_fields {
            true => shown.push(field(own, elements.kept.iter().map(|i| values[*i]))),
            false => left_out.push(own.words()),
        }
    }
    let axis = |i: usize| {
        let kept = elements.kept.iter();
        let values: Vec<f32> = kept.map(|n| surface.points[*n][i] as f32).collect();
        STANDARD.encode(bytes(&values, f32::to_le_bytes))
    };
    let node_bytes = elements.node_bytes();
    let text = match node_bytes {
        2 => STANDARD.encode(bytes(&elements.nodes, |n| (n as u16).to_le_bytes())),
        _ => STANDARD.encode(bytes(&elements.nodes, u32::to_le_bytes)),
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
        "off_by": off_by,
    })
}

/// Nodes of each element, numbered by occurrence.
struct Elements {
    /// Nodes of the elements, concatenated, as indices into `kept`.
    nodes: Vec<u32>,
    /// Nodes of the surface.
    kept: Vec<usize>,
}

impl Elements {
    /// From elements by nodes of the surface, given the number of its nodes.
    fn new(n_points: usize, of_surface: Vec<u32>) -> Elements {
        let mut number = vec![u32::MAX; n_points];
        let (mut kept, mut nodes) = (Vec::new(), Vec::new());
        for node in of_surface {
            let own = &mut number[node as usize];
            if *own == u32::MAX {
                *own = kept.len() as u32;
                kept.push(node as usize);
            }
            nodes.push(*own);
        }
        Elements { nodes, kept }
    }

    fn node_bytes(&self) -> usize {
        match self.kept.len() <= usize::from(u16::MAX) {
            true => 2,
            false => 4,
        }
    }

    /// Number of fields that fit on a page, in addition to the node coordinates.
    fn room_for(&self) -> usize {
        let room = MOST_BYTES.saturating_sub(self.node_bytes() * self.nodes.len());
        (room / (4 * self.kept.len().max(1))).saturating_sub(2)
    }
}

/// Triangles without the nodes that linear interpolation reproduces. Nodes around the places of figures are kept.
fn thinned(
    solution: &Solution,
    elements: &Elements,
    fields: &[(Field, &[f64])],
    tolerance: f64,
) -> Elements {
    let points: Vec<[f64; 2]> = (elements.kept.iter())
        .map(|n| solution.surface.points[*n])
        .collect();
    let own: Vec<(Field, Vec<f64>)> = (fields.iter())
        .map(|(field, values)| {
            let at_nodes = elements.kept.iter().map(|n| values[*n]).collect();
            (*field, at_nodes)
        })
        .collect();
    let logarithms: Vec<Option<Vec<f64>>> = (own.iter())
        .map(|(field, values)| {
            has_decades(*field, values).then(|| values.iter().map(|v| v.ln()).collect())
        })
        .collect();
    let bounded: Vec<Bounded> = (own.iter().zip(&logarithms))
        .map(|((field, values), logarithms)| {
            let values = logarithms.as_ref().unwrap_or(values);
            let low = values.iter().copied().fold(f64::INFINITY, f64::min);
            let high = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
            let of = |v: &f64| match field {
                Field::FilmThickness => tolerance * v,
                _ => tolerance * (high - low),
            };
            Bounded {
                values,
                tolerance: values.iter().map(of).collect(),
            }
        })
        .collect();
    let cells: Vec<[u32; 3]> = (elements.nodes.chunks_exact(3))
        .map(|c| [c[0], c[1], c[2]])
        .collect();
    let mut stays = vec![false; points.len()];
    let is_half = solution.shape.symmetry == Symmetry::Half;
    let places = (solution.figures()).filter_map(|(figure, at)| {
        let y = if is_half { -at.y.abs() } else { at.y };
        figure.has_place().then_some([at.x, y])
    });
    for place in places.chain([[0.0; 2]]) {
        let has = |cell: &&[u32; 3]| contains(cell.map(|n| points[n as usize]), place);
        let around = cells.iter().filter(has).flatten();
        around.for_each(|n| stays[*n as usize] = true);
    }
    let left = thin(&points, &cells, &bounded, &stays);
    let of_surface = left
        .iter()
        .flatten()
        .map(|n| elements.kept[*n as usize] as u32);
    Elements::new(solution.surface.points.len(), of_surface.collect())
}

/// Whether a page draws the logarithm of a field; `spread` in `assets/field.js` has the same rule.
fn has_decades(field: Field, values: &[f64]) -> bool {
    let low = values.iter().copied().fold(f64::INFINITY, f64::min);
    let high = values.iter().copied().fold(0.0, f64::max);
    low > 0.0 && high > 100.0 * low && field.unit() != "m"
}

pub(super) fn bytes<T: Copy, const N: usize>(values: &[T], of: impl Fn(T) -> [u8; N]) -> Vec<u8> {
    values.iter().flat_map(|v| of(*v)).collect()
}

/// The profiles along the centreline within the visible contact.
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
    use std::path::Path;

    use super::*;
    use crate::case::Case;
    use crate::contact::Turn;
    use crate::engine::NoObserver;
    use crate::output::sample;
    use crate::run::solve;

    /// The edge of an ellipse of half-axes a and 3 a whose first axis is rotated by 30° against the motion: in its own axes
    /// each point has (x/a)² + (y/3a)² = 1.
    #[test]
    fn the_edge_of_a_rotated_ellipse_is_rotated() {
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
            // The angle has the sense of `Turn`.
            assert!(off(sine).min(off(-sine)) < 1e-5, "{}", off(sine));
            assert!(turned == 0.0 || off(0.0) > 0.1);
        }
    }

    /// A film by finite volumes on 25,000 nodes: the page has few of them, with all fields, and includes the nodes nearest to the minimum
    /// film and to the centre with their values.
    #[test]
    fn meshes_of_finite_volumes_are_thinned() {
        let text = include_str!("../../../../../cases/ball-on-disc.toml");
        let case = Case::from_text("ball.toml", text, Path::new("")).expect("a valid case");
        let solution = solve(&case, &mut NoObserver).expect("it converges");
        assert!(solution.surface.points.len() > 50_000);
        let data = data(&case.echo(), &solution, 1e-6);
        let text = data.to_string();
        assert!(text.len() < 1_700_000, "{} bytes", text.len());
        assert_eq!(data["mesh"]["left_out"], json!([]));
        let read = |value: &Value| -> Vec<f32> {
            let text = value.as_str().expect("a text");
            let bytes = STANDARD.decode(text).expect("base 64");
            bytes
                .as_chunks::<4>()
                .0
                .iter()
                .map(|b| f32::from_le_bytes(*b))
                .collect()
        };
        let mesh = &data["mesh"];
        let (x, y) = (read(&mesh["x"]), read(&mesh["y"]));
        let films = mesh["fields"].as_array().expect("a list").iter();
        let film = films
            .clone()
            .find(|f| f["name"] == "film_thickness")
            .expect("there");
        let film = read(&film["values"]);
        let figure = |wanted: Figure| {
            solution
                .figures()
                .find(|(own, _)| *own == wanted)
                .expect("there")
                .1
        };
        let nearest = |nodes: &[[f64; 2]], place: [f64; 2]| {
            let far = |i: &usize| (nodes[*i][0] - place[0]).hypot(nodes[*i][1] + place[1].abs());
            let nearest = (0..nodes.len()).min_by(|i, j| far(i).total_cmp(&far(j)));
            nearest.expect("nodes")
        };
        let kept: Vec<[f64; 2]> = (x.iter().zip(&y))
            .map(|(x, y)| [f64::from(*x), f64::from(*y)])
            .collect();
        let at = |place: [f64; 2]| f64::from(film[nearest(&kept, place)]);
        let centre = figure(Figure::FilmCentral).value;
        assert!((at([0.0; 2]) / centre - 1.0).abs() < 1e-6);
        let smallest = figure(Figure::FilmMinimum);
        let place = [smallest.x, smallest.y];
        let surface = &solution.surface;
        let solved = surface.film_thickness[nearest(&surface.points, place)];
        assert!((at(place) / solved - 1.0).abs() < 1e-6);
    }
}
