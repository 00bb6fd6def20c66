//! All results of a case.

use super::{
    BodyField, Centreline, Checks, ElementFields, Estimate, Figure, FilmReduction, FormulaFilm,
    IterationRecord, Located, Measured, MixedLubrication, Neglected, Sensitivities, Starvation,
    Stats, Summary, SummedTo, SurfaceField, Thermal, Traction, Uncertainties, Unresolved, Wear,
};
use crate::contact::{ContactKind, Groups, Hertz, Scales, Shape};
use crate::stress::Stresses;
use crate::warning::Warning;

/// The solution of a case.
#[derive(Clone, Debug)]
pub struct Solution {
    /// Kind of the contact.
    pub kind: ContactKind,
    /// Geometry of the contact.
    pub shape: Shape,
    /// Hertz contact.
    pub hertz: Hertz,
    /// Reduced modulus E', Pa.
    pub reduced_modulus: f64,
    /// Groups with the initial slope of ln μ(p) as pressure-viscosity coefficient.
    pub groups: Groups,
    /// Groups with the reciprocal asymptotic isoviscous coefficient α*, where it exists.
    pub groups_asymptotic: Option<Groups>,
    /// Scales of the dimensionless variables.
    pub scales: Scales,
    /// Extents of the contact area in half-widths: inlet, outlet, side.
    pub extents: [f64; 3],
    /// Every figure with its error bar.
    pub measured: Measured,
    /// The main figures.
    pub summary: Summary,
    /// Effect of starvation on the film; `None` for a flooded contact.
    pub starvation: Option<Starvation>,
    /// Mixed lubrication; `None` where the case gives no roughness.
    pub mixed: Option<MixedLubrication>,
    /// Traction and friction.
    pub traction: Traction,
    /// Range of their integrals.
    pub summed_to: SummedTo,
    /// Balances that the solution should satisfy.
    pub checks: Checks,
    /// Effect of shear thinning on the film; `None` for Newtonian fluids, or where the film of the
    /// Newtonian fluid was not found.
    pub film_reduction: Option<FilmReduction>,
    /// Temperatures and heat; `None` for an isothermal contact.
    pub thermal: Option<Thermal>,
    /// Stresses in the bodies, where requested.
    pub stresses: Option<Stresses>,
    /// Wear of the bodies, where requested.
    pub wear: Option<Wear>,
    /// Sensitivities to the inputs, where requested and computable.
    pub sensitivities: Option<Sensitivities>,
    /// Uncertainty of the figures from that of the inputs; `None` where inputs have none.
    pub uncertainty: Option<Uncertainties>,
    /// Film-thickness formulas for the same case.
    pub formulas: Vec<FormulaFilm>,
    /// Profiles along the centreline.
    pub centreline: Centreline,
    /// Fields on the contact area.
    pub surface: SurfaceField,
    /// The same fields as polynomials, for pictures.
    pub elements: ElementFields,
    /// Displacement of the body, if requested.
    pub body: Option<BodyField>,
    /// Every Newton iteration.
    pub history: Vec<IterationRecord>,
    /// Effort.
    pub stats: Stats,
    /// Effects that the model neglects.
    pub left_out: Neglected,
    /// Requested figures that the mesh does not resolve.
    pub unresolved: Vec<Unresolved>,
    /// Warnings: data ranges exceeded, films below a nanometre, contact area too small.
    pub warnings: Vec<Warning>,
}

impl Solution {
    /// A figure with its error bar and its place, SI; `None` where this contact has none. Coordinates are zero of figures without a place.
    pub fn figure(&self, figure: Figure) -> Option<Located> {
        self.measured.find_located(figure)
    }

    /// The figures that this contact has, in the order of the registry.
    pub fn figures(&self) -> impl Iterator<Item = (Figure, Located)> {
        (Figure::ALL.into_iter()).filter_map(|figure| Some((figure, self.figure(figure)?)))
    }

    /// Whether the mesh resolves a figure; one that this contact does not have counts as resolved. Of the traction the size of both components
    /// decides.
    pub fn resolves(&self, figure: Figure) -> bool {
        match figure {
            Figure::TractionCoefficient => self.traction.size().is_resolved(),
            _ => self.figure(figure).is_none_or(|at| at.resolved),
        }
    }

    /// Sets the comparison with the flooded contact.
    pub fn compare_with_flooded(&mut self, flooded: &Solution) {
        let (own, full) = (&self.summary, &flooded.summary);
        let Some(starvation) = &mut self.starvation else {
            return;
        };
        starvation.film_central_flooded = Some(full.film_central);
        starvation.film_minimum_flooded = Some(full.film_minimum);
        starvation.ratio_central = Some(Estimate::ratio(own.film_central, full.film_central));
        starvation.ratio_minimum = Some(Estimate::ratio(own.film_minimum, full.film_minimum));
    }
}
