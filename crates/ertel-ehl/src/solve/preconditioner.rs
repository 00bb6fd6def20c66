//! Sparse approximation of the coupled Jacobian, factorised.
//!
//! ```text
//!   | R_P   R_δ | | dP |     S̃: the stiffness of the surface between near nodes: of one
//!   | −M    S̃   | | dδ |     element, in line contacts neighbours of neighbours
//! ```
//! The compliance of a half-space is long-range, its inverse is not: that is why cutting the
//! stiffness works where cutting the compliance does not.

use std::sync::{Arc, OnceLock};

use ertel_fem::assembly::{CONSTRAINED, NodeGraph};
use ertel_fem::linear::equilibrate::{Equilibration, unit_of};
use ertel_fem::linear::frontal_lu::{FrontalLu, FrontalPattern};
use ertel_fem::linear::fronts::Blocks;
use ertel_fem::linear::lu::LuError;
use ertel_fem::linear::ordering::FillReduction;
use rustc_hash::FxHashMap;

use super::discretisation::Discretisation;
use super::system::{Column, System};

/// Data shared by all preconditioners of a level: the entries of the matrix and their elimination
/// order.
pub struct NearStiffness {
    /// Row and column of each entry.
    entries: Vec<(u32, u32)>,
    /// Values of the entries that do not change with the state; zero for the others.
    fixed: Vec<f64>,
    /// The first entries come from the element blocks: index in [`System::blocks`].
    from_blocks: Vec<u32>,
    /// Made when first needed.
    pattern: OnceLock<Arc<FrontalPattern>>,
}

impl NearStiffness {
    /// Stiffness between near nodes.
    pub fn new(d: &Discretisation) -> NearStiffness {
        let first = d.n_pressure as u32;
        let mut near = NearStiffness {
            entries: Vec::new(),
            fixed: Vec::new(),
            from_blocks: Vec::new(),
            pattern: OnceLock::new(),
        };
        System::for_each_entry(d, |row, column, index| {
            let column = match column {
                Column::Pressure(dof) => dof,
                Column::Deflection(node) => first + node,
            };
            near.entries.push((row, column));
            near.from_blocks.push(index as u32);
        });
        near.fixed = vec![0.0; near.entries.len()];
        d.for_each_coupling(|node, dof, value| {
            near.entries.push((first + node, dof));
            near.fixed.push(-value);
        });
        let stiffness = d.contact.response.near_stiffness();
        for (&(i, j), v) in d.contact.near_pairs.iter().zip(stiffness) {
            near.entries.push((first + i, first + j));
            near.fixed.push(v);
            if i != j {
                near.entries.push((first + j, first + i));
                near.fixed.push(v);
            }
        }
        near
    }

    fn pattern(&self, d: &Discretisation) -> Result<&Arc<FrontalPattern>, LuError> {
        if let Some(pattern) = self.pattern.get() {
            return Ok(pattern);
        }
        let groups = Groups::new(d);
        let graph = groups.graph(d);
        let blocks = Blocks {
            graph: &graph,
            n_inner: groups.unknowns.len(),
            carriers: Some(groups.places),
            reduction: FillReduction::MinimumDegree,
            unknowns: groups.unknowns,
        };
        let pattern = FrontalPattern::new(&blocks, &self.entries).map_err(|e| LuError {
            n: d.n_pressure + d.contact.deflection.n_nodes(),
            reason: e.to_string(),
        })?;
        Ok(self.pattern.get_or_init(|| Arc::new(pattern)))
    }
}

/// Unknowns of one vertex, edge or element of the surface: pressures and deflections of one place
/// are eliminated together, where either may be the better pivot.
struct Groups {
    unknowns: Vec<Vec<u32>>,
    /// Vertices on whose common edge or element a group lies.
    places: Vec<[u32; 4]>,
    of_deflection: Vec<u32>,
    /// `CONSTRAINED` at the edge.
    of_pressure: Vec<u32>,
}

impl Groups {
    fn new(d: &Discretisation) -> Groups {
        let mut index: FxHashMap<[u32; 4], u32> = FxHashMap::default();
        let mut unknowns: Vec<Vec<u32>> = Vec::new();
        let mut places: Vec<[u32; 4]> = Vec::new();
        let mut add = |place: [u32; 4], unknown: u32| {
            let group = *index.entry(place).or_insert_with(|| {
                unknowns.push(Vec::new());
                places.push(place);
                unknowns.len() as u32 - 1
            });
            unknowns[group as usize].push(unknown);
            group
        };
        let deflections = d.contact.deflection.carriers();
        let of_deflection = (deflections.into_iter().enumerate())
            .map(|(node, place)| add(place, (d.n_pressure + node) as u32))
            .collect();
        let of_pressure = (d.pressure.carriers().into_iter().zip(&d.pressure_dofs))
            .map(|(place, dof)| match *dof {
                CONSTRAINED => CONSTRAINED,
                dof => add(place, dof),
            })
            .collect();
        Groups {
            unknowns,
            places,
            of_deflection,
            of_pressure,
        }
    }

    /// Groups of one element, and those of near deflections, are neighbours.
    fn graph(&self, d: &Discretisation) -> NodeGraph {
        let mut rows: Vec<Vec<u32>> = vec![Vec::new(); self.unknowns.len()];
        for c in 0..d.contact.n_elements() {
            let pressures = d.pressure.nodes_of(c).iter();
            let deflections = d.contact.deflection.nodes_of(c).iter();
            let mut groups: Vec<u32> = pressures
                .map(|n| self.of_pressure[*n as usize])
                .filter(|g| *g != CONSTRAINED)
                .chain(deflections.map(|n| self.of_deflection[*n as usize]))
                .collect();
            groups.sort_unstable();
            groups.dedup();
            for g in &groups {
                rows[*g as usize].extend_from_slice(&groups);
            }
        }
        for (i, j) in &d.contact.near_pairs {
            let (a, b) = (
                self.of_deflection[*i as usize],
                self.of_deflection[*j as usize],
            );
            rows[a as usize].push(b);
            rows[b as usize].push(a);
        }
        let mut graph = NodeGraph {
            offsets: vec![0],
            neighbours: Vec::new(),
        };
        for mut row in rows {
            row.sort_unstable();
            row.dedup();
            graph.neighbours.append(&mut row);
            graph.offsets.push(graph.neighbours.len());
        }
        graph
    }
}

/// Factorised approximation of the coupled system without the load equation.
#[derive(Clone)]
pub struct Preconditioner {
    lu: FrontalLu,
    /// Scaling of rows and columns, where single precision does not span the entries as they are.
    equilibration: Option<Equilibration>,
    n_pressure: usize,
    scratch: Vec<f64>,
}

impl Preconditioner {
    /// Factorises for the Jacobian of `system`.
    ///
    /// # Errors
    /// When the matrix is singular.
    pub fn new(
        d: &Discretisation,
        near: &NearStiffness,
        system: &System,
    ) -> Result<Preconditioner, LuError> {
        let n = d.n_pressure + d.contact.deflection.n_nodes();
        let mut values = near.fixed.clone();
        for (value, index) in values.iter_mut().zip(&near.from_blocks) {
            *value = system.blocks[*index as usize];
        }
        let pattern = near.pattern(d)?;
        let mut equilibration = None;
        let lu = FrontalLu::new(pattern, &values).or_else(|e| {
            // Film equations span many decades where films are thick next to the dry contact, or stresses near a limit.
            let scaling = Equilibration::new(n, &near.entries, &values).ok_or(e)?;
            let scaled = scaling.scale(&near.entries, &values);
            equilibration = Some(scaling);
            FrontalLu::new(pattern, &scaled)
        });
        let lu = lu.map_err(|e| LuError {
            n,
            reason: match values.iter().all(|v| v.is_finite()) {
                true => e.to_string(),
                false => "an entry of the matrix is not finite".to_owned(),
            },
        })?;
        Ok(Preconditioner {
            lu,
            equilibration,
            n_pressure: d.n_pressure,
            scratch: vec![0.0; n],
        })
    }

    /// Solves approximately for the pressure update, in place.
    pub fn solve(&mut self, rhs: &mut [f64]) {
        let x = &mut self.scratch;
        x.fill(0.0);
        x[..self.n_pressure].copy_from_slice(rhs);
        let mut unit = 1.0;
        if let Some(e) = &self.equilibration {
            for (x, f) in x.iter_mut().zip(&e.rows) {
                *x *= f;
            }
            unit = unit_of(x);
            x.iter_mut().for_each(|x| *x /= unit);
        }
        self.lu.solve(x);
        if let Some(e) = &self.equilibration {
            for (x, f) in x.iter_mut().zip(&e.columns) {
                *x *= f * unit;
            }
        }
        rhs.copy_from_slice(&x[..self.n_pressure]);
    }
}
