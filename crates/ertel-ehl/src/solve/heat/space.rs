//! Temperatures over the contact area, and their values in the film equations.

use ertel_fem::assembly::NodeGraph;
use ertel_fem::element::{Lagrange, Tabulation};
use ertel_fem::quadrature::Quadrature;
use ertel_fem::space::Space;

use super::column::Column;
use super::sides::{Side, outer_sides};
use crate::solve::contact_surface::ContactSurface;

/// Temperatures over the contact area: a column at each node of a surface space.
#[derive(Clone, Debug)]
pub struct HeatSpace {
    /// Nodes of the columns, numbered along the motion.
    pub surface: Space,
    /// Which of them are neighbours.
    pub graph: NodeGraph,
    /// The column.
    pub column: Column,
    /// Its temperatures before anything is heated, K.
    unheated: Vec<f64>,
    /// Quadrature over the contact area.
    pub rule: Quadrature,
    /// Surface shape functions at its points.
    pub table: Tabulation,
    /// Shape functions of pressure and deflection there.
    pub(super) film_tables: [Tabulation; 2],
    /// Surface shape functions at the points of the film equations.
    pub(super) film_table: Tabulation,
    /// Sides of elements on the edge of the contact area.
    pub(super) edges: Vec<Side>,
}

impl HeatSpace {
    /// Columns over a contact area, at whose points `film_rule` the film equations ask for temperatures.
    pub fn new(
        contact: &ContactSurface,
        pressure: &Lagrange,
        film_rule: &Quadrature,
        order: usize,
        column: Column,
        unheated: Vec<f64>,
    ) -> HeatSpace {
        let surface = Space::new(&contact.surface, order).along_x();
        // two shape functions and a gradient, with coefficients that vary
        let rule = Quadrature::simplex(contact.surface.dim, 2 * order + 2);
        HeatSpace {
            graph: NodeGraph::new(&surface),
            column,
            unheated,
            table: surface.element.tabulate(&rule),
            film_tables: [
                pressure.tabulate(&rule),
                contact.deflection.element.tabulate(&rule),
            ],
            film_table: surface.element.tabulate(film_rule),
            rule,
            surface,
            edges: outer_sides(contact, |_| true),
        }
    }

    /// Temperatures before heating: the inflow temperatures of lubricant and bodies.
    pub fn unheated(&self) -> Vec<f64> {
        self.unheated.repeat(self.surface.n_nodes())
    }

    /// Number of temperatures.
    pub fn n(&self) -> usize {
        self.surface.n_nodes() * self.column.n()
    }
}
