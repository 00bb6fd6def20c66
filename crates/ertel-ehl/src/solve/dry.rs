//! The dry contact of a roller by the elastic operator: its rim, and the pressures of a start.
//!
//! Theory: Dry contact.

use std::f64::consts::PI;
use std::sync::Arc;

use ertel_fem::assembly::CONSTRAINED;
use ertel_fem::linear::NEVER;

use super::discretisation::{Discretisation, Extents, LevelSizes};

use super::contact_surface::ContactSurface;
use super::points::{gap_at_nodes, pressure_at};
use crate::contact::roller::RollerZone;
use crate::contact::{Shape, Symmetry};
use crate::elastic::{Accuracy, Elasticity};
use crate::solve::tuning::meshes::{ACROSS, MAX_ITERATIONS, ORDER, TOLERANCE, WIDER};

/// Cells there, in half-widths.
const SIZES: LevelSizes = LevelSizes {
    hertz: 0.25,
    constriction: 0.15,
    rim: 0.1,
    outlet_rim: 0.1,
    rim_width: 0.05,
    edge: 0.5,
    growth: 0.5,
    depth_growth: 0.5,
};

/// The shape of a roller under ∫P = `load` (dimensionless, over the part that is solved) whose zone has the load per length of the dry
/// contact on a coarse mesh, instead of that of slices: half-widths by slices are off by some per cent, and by a tenth at ends that carry
/// much; the strip of fine cells along the rim of a thin film is narrower. The first of two rounds finds where the contact ends, the mesh of
/// the second is fine there. Other shapes, and contacts whose mesh cannot be made, stay as they are.
pub fn with_dry_zone(shape: Shape, elasticity: &Elasticity, load: f64) -> Shape {
    let Some(slices) = shape.zone.roller.clone() else {
        return shape;
    };
    let with = |zone: RollerZone| {
        let mut shape = shape.clone();
        shape.zone.roller = Some(Arc::new(zone));
        shape
    };
    let first = with(slices.to_look_at_edges(|y| slices.load(y)));
    let Some(loads) = DryLoads::new(&first, elasticity, load) else {
        return shape;
    };
    let second = with(slices.to_look_at_edges(|y| loads.at(y)));
    match DryLoads::new(&second, elasticity, load) {
        Some(loads) => with(slices.with_loads(|y| loads.at(y))),
        None => shape,
    }
}

/// The dry contact of a roller on a coarse mesh.
struct DryLoads {
    d: Discretisation,
    pressure: Vec<f64>,
    /// Half the width of the area.
    reach: f64,
}

impl DryLoads {
    /// That of a shape; `None` where its mesh cannot be made.
    fn new(shape: &Shape, elasticity: &Elasticity, load: f64) -> Option<DryLoads> {
        let roller = shape.zone.roller.as_ref()?;
        let reach = WIDER * roller.half_extents()[0];
        let extents = Extents {
            inlet: -reach,
            outlet: reach,
            side: roller.side(),
            body_width: 0.0,
            body_depth: 0.0,
        };
        let elasticity = Elasticity {
            order: ORDER,
            ..elasticity.clone()
        };
        let surface = ContactSurface::new(shape, &extents, &SIZES, &elasticity, NEVER);
        let d = Discretisation::new(&Arc::new(surface.ok()?), ORDER);
        let guess: Vec<f64> = (d.pressure.points.iter())
            .map(|p| shape.zone.pressure([p[0], p[1]]))
            .collect();
        let pressure = dry_pressure(&d, &guess, load);
        Some(DryLoads { d, pressure, reach })
    }

    /// Load per length at y, in units in which that of the line contact under the mean load is 1.
    fn at(&self, y: f64) -> f64 {
        let y = match self.d.contact.shape.symmetry {
            Symmetry::Half => -y.abs(),
            Symmetry::Full => y,
        };
        // Of the Hertz pressure of a line, ∫P dX = π/2.
        let step = 2.0 * self.reach / ACROSS as f64;
        let sum: f64 = (1..ACROSS)
            .map(|i| i as f64 * step - self.reach)
            .map(|x| pressure_at(&self.d, &self.pressure, [x, y]).max(0.0))
            .sum();
        2.0 / PI * sum * step
    }
}

/// Nodal pressures of the dry contact under ∫P = `load`, from a guess.
///
/// ```text
///   P ≥ 0,   G = gap + deflection − approach ≥ 0,   P G = 0
/// ```
/// by conjugate gradients over the nodes in contact: nodes that come below zero leave it, nodes where the bodies overlap join it.
///
/// Source: Polonsky and Keer, Wear 231 (1999), 206-219; here on a mesh of uneven cells, whose scalar products weigh each node by its area.
pub(super) fn dry_pressure(d: &Discretisation, guess: &[f64], load: f64) -> Vec<f64> {
    let free: Vec<bool> = (d.pressure_dofs.iter())
        .map(|i| *i != CONSTRAINED)
        .collect();
    let nodes = Nodes::new(d);
    let mut pressure: Vec<f64> = (guess.iter().zip(&free))
        .map(|(p, free)| if *free { p.max(0.0) } else { 0.0 })
        .collect();
    let scaled = |pressure: &mut [f64]| {
        let factor = load / d.integral(pressure);
        pressure.iter_mut().for_each(|p| *p *= factor);
    };
    scaled(&mut pressure);
    let gap = gap_at_nodes(d);
    let mut direction = vec![0.0; pressure.len()];
    let (mut keep, mut last) = (0.0, 1.0);
    for _ in 0..MAX_ITERATIONS {
        let deflection = d.deflect(&pressure, Accuracy::Krylov);
        let mut g = nodes.values(d, &deflection);
        g.iter_mut().zip(&gap).for_each(|(g, gap)| *g += gap);
        let touches: Vec<bool> = pressure.iter().map(|p| *p > 0.0).collect();
        let level = nodes.mean(&g, &touches);
        g.iter_mut().for_each(|g| *g -= level);
        let size = nodes.product(&g, &g, &touches);
        for ((t, g), touches) in direction.iter_mut().zip(&g).zip(&touches) {
            *t = if *touches {
                g + keep * size / last * *t
            } else {
                0.0
            };
        }
        last = size;
        let bend = d.deflect(&direction, Accuracy::Krylov);
        let mut r = nodes.values(d, &bend);
        let level = nodes.mean(&r, &touches);
        r.iter_mut().for_each(|r| *r -= level);
        let step =
            nodes.product(&g, &direction, &touches) / nodes.product(&r, &direction, &touches);
        if !(step.is_finite() && step > 0.0) {
            break;
        }
        let before = pressure.clone();
        let mut joined = false;
        for (i, p) in pressure.iter_mut().enumerate().filter(|(i, _)| free[*i]) {
            match touches[i] {
                true => *p = (*p - step * direction[i]).max(0.0),
                false if g[i] < 0.0 => {
                    *p = -step * g[i];
                    joined = true;
                }
                false => {}
            }
        }
        keep = if joined { 0.0 } else { 1.0 };
        scaled(&mut pressure);
        let moved: f64 = (pressure.iter().zip(&before).zip(&nodes.areas))
            .map(|((a, b), w)| w * (a - b).abs())
            .sum();
        if moved < TOLERANCE * load {
            break;
        }
    }
    pressure
}

/// Areas of the pressure nodes, and where they are among those of the deflection.
struct Nodes {
    areas: Vec<f64>,
    /// An element of each, and the deflection's shape functions at it.
    places: Vec<(u32, Vec<f64>)>,
}

impl Nodes {
    fn new(d: &Discretisation) -> Nodes {
        let element = &d.pressure.element;
        let basis: Vec<Vec<f64>> = (element.points())
            .map(|xi| d.contact.deflection.element.values(xi).collect())
            .collect();
        let n = d.pressure.n_nodes();
        let (mut areas, mut places) = (vec![0.0; n], vec![(0, Vec::new()); n]);
        for (c, map) in d.contact.maps.iter().enumerate() {
            for (node, basis) in d.pressure.nodes_of(c).iter().zip(&basis) {
                areas[*node as usize] += map.determinant / element.n_nodes() as f64;
                places[*node as usize] = (c as u32, basis.clone());
            }
        }
        Nodes { areas, places }
    }

    /// Nodal values of a deflection.
    fn values(&self, d: &Discretisation, deflection: &[f64]) -> Vec<f64> {
        (self.places.iter())
            .map(|(cell, basis)| {
                let nodes = d.contact.deflection.nodes_of(*cell as usize);
                let terms = basis.iter().zip(nodes);
                terms.map(|(b, n)| b * deflection[*n as usize]).sum()
            })
            .collect()
    }

    fn product(&self, a: &[f64], b: &[f64], of: &[bool]) -> f64 {
        (0..a.len())
            .filter(|i| of[*i])
            .map(|i| self.areas[i] * a[i] * b[i])
            .sum()
    }

    fn mean(&self, a: &[f64], of: &[bool]) -> f64 {
        let of_area = (0..a.len()).filter(|i| of[*i]).map(|i| self.areas[i]);
        let sum: f64 = of_area.sum();
        (0..a.len())
            .filter(|i| of[*i])
            .map(|i| self.areas[i] * a[i])
            .sum::<f64>()
            / sum
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::roller::{Profile, Roller};
    use crate::contact::{Contact, Hertz, Material, Motion};
    use approx::assert_relative_eq;

    const RADIUS: f64 = 0.01;
    const MODULUS: f64 = 2.3e11;

    fn zone(roller: Roller, load: f64) -> (Shape, Shape, f64) {
        let contact = Contact::of_roller(RADIUS, load, roller);
        let hertz = Hertz::new(&contact, MODULUS);
        let shape = Shape::new(&contact, &hertz, &Motion::straight(1.0, 0.0));
        // Both bodies alike, in units of p_h R/b = E'/4: E = E'(1 − ν²), so 4(1 − ν²).
        let body = Material {
            youngs_modulus: 4.0 * (1.0 - 0.3 * 0.3),
            poissons_ratio: 0.3,
        };
        let elasticity = Elasticity::half_space(3, &[body, body]);
        let load = shape.load();
        let dry = with_dry_zone(shape.clone(), &elasticity, load);
        (shape, dry, hertz.half_width)
    }

    /// A crown makes a Hertz ellipse, whose load per length is ½π a p_h √(1 − (y/c)²)² by the closed form; slices are off by 0.2 to 0.3 %.
    #[test]
    fn a_crown_makes_an_ellipse() {
        let load = 5000.0;
        let ellipse = Contact::elliptical([RADIUS, 20.0 * RADIUS], load, 0.0);
        let exact = Hertz::new(&ellipse, MODULUS);
        let [a, c] = [exact.half_width, exact.half_width_y.unwrap()];
        let roller = Roller {
            length: 2.6 * c,
            profile: Profile::Crown {
                crown_radius: 20.0 * RADIUS,
            },
            misalignment: 0.0,
        };
        let (slices, dry, b) = zone(roller, load);
        let widths = |shape: &Shape| {
            [0.0, 0.3, 0.6].map(|share: f64| {
                let y = share * c / b;
                let line_load = load / (2.6 * c);
                let middle = (0.5 * PI * a * exact.pressure / line_load).sqrt();
                let elliptic = middle * (1.0 - share * share).sqrt();
                shape.zone.roller.as_ref().unwrap().peak(y) / elliptic - 1.0
            })
        };
        println!(
            "slices {:.4?}, dry contact {:.4?}",
            widths(&slices),
            widths(&dry)
        );
        for error in widths(&dry) {
            assert!(error.abs() < 1e-3, "{error}");
        }
    }

    /// Straight with rounded ends, where slices are off by some per cent: the zone is the same whether half of the contact is solved or all of it,
    /// and symmetric.
    #[test]
    fn halves_are_alike() {
        let roller = |misalignment| Roller {
            length: 4e-3,
            profile: Profile::Straight {
                straight_length: 3.2e-3,
                end_radius: 0.02,
            },
            misalignment,
        };
        let (_, half, b) = zone(roller(0.0), 2000.0);
        let (_, whole, _) = zone(roller(1e-12), 2000.0);
        assert_eq!(half.symmetry, Symmetry::Half);
        assert_eq!(whole.symmetry, Symmetry::Full);
        let at = |shape: &Shape, y: f64| shape.zone.roller.as_ref().unwrap().peak(y);
        for y in [0.0, 0.5e-3, 1e-3, 1.5e-3].map(|y| y / b) {
            assert_relative_eq!(at(&half, y), at(&half, -y), max_relative = 1e-9);
            assert_relative_eq!(at(&half, y), at(&whole, y), max_relative = 2e-3);
        }
    }

    /// Other shapes are unchanged.
    #[test]
    fn other_shapes_stay() {
        let elasticity = Elasticity::half_space(
            3,
            &[Material {
                youngs_modulus: 4.0,
                poissons_ratio: 0.3,
            }],
        );
        assert_eq!(
            with_dry_zone(Shape::CIRCULAR, &elasticity, 1.0),
            Shape::CIRCULAR
        );
    }
}
