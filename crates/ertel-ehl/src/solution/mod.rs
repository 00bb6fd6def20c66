//! What a solve returns: plain data in SI, ready for output.

mod checks;
mod contact_fields;
mod elements;
mod field;
mod figure_kinds;
mod figures;
mod left_out;
mod mixed;
mod role;
mod roller;
mod sensitivities;
mod separation;
mod starvation;
mod thermal;
mod uncertainty;
mod unresolved;

use serde::Serialize;
use serde::ser::{SerializeMap, Serializer};

use crate::contact::{ContactKind, Groups, Hertz, Scales, Shape};
use crate::warning::Warning;

pub use checks::{Balance, Checks, SummedTo};
pub use contact_fields::{ContactFields, GridField};
pub use contact_fields::{Mirrored, mirror, near_zero};
pub use elements::{ElementFields, Polynomials, TemperaturePolynomials};
pub use field::Field;
pub use figures::{
    Bar, Bars, ErrorClass, Figure, Figures, Kind, LEAST_RISE, Measured, PerFigure, ROUNDING,
    Reading, Section, Sizes, WIDEST, WIDEST_OF_PLACE,
};
pub use left_out::{Neglected, NeglectedHeat};
pub use mixed::{AsperityFigures, MixedFriction, MixedLubrication};
pub use role::Role;
pub use roller::RollerFigures;
pub use sensitivities::{FigureSensitivity, LeftOut, Sensitivities, SensitivityInput};
pub use separation::{BOUNDARY_BELOW, FULL_FROM, Separation, roughness_warning};
pub use starvation::Starvation;
pub use thermal::{
    Coupling, CrossProfile, FilmTemperatures, HeatBalance, TemperatureField, Thermal,
    ThermalReduction,
};
pub use uncertainty::{FigureUncertainty, Uncertainties};
pub use unresolved::{Asked, Unresolved, Why};

/// A figure with its discretisation error bar. Written with `resolved`: false where the bar is wider than half of the value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// The value on the finest mesh.
    pub value: f64,
    /// Half-width of the error bar, same unit; `None` when no coarser solution was computed.
    pub error: Option<f64>,
}

impl Serialize for Estimate {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(3))?;
        map.serialize_entry("value", &self.value)?;
        map.serialize_entry("error", &self.error)?;
        map.serialize_entry("resolved", &self.error.map(|_| self.is_resolved()))?;
        map.end()
    }
}

impl Estimate {
    /// Whether its bar, if it has one, is not wider than half of its value.
    pub fn is_resolved(&self) -> bool {
        (self.error).is_none_or(|error| error <= WIDEST * self.value.abs())
    }

    /// with/without of two solutions, each of which errs on its own.
    pub fn ratio(with: Estimate, without: Estimate) -> Estimate {
        let ratio = with.value / without.value;
        let relative = |e: Estimate| Some(e.error? / e.value.abs());
        let both = relative(with).zip(relative(without));
        let error = both.map(|(with, without)| (with + without) * ratio.abs());
        Estimate {
            value: ratio,
            error: error.filter(|error| error.is_finite()),
        }
    }

    /// 1 − with/without of two solutions, each of which errs on its own.
    pub fn reduction(with: Estimate, without: Estimate) -> Estimate {
        let ratio = Estimate::ratio(with, without);
        Estimate {
            value: 1.0 - ratio.value,
            ..ratio
        }
    }
}

/// A figure with its discretisation error bar and the place where it occurs, coordinates in m.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Located {
    /// The value on the finest mesh.
    pub value: f64,
    /// Half-width of the error bar, same unit; `None` as in [`Estimate`], and where no coarser mesh has the figure.
    pub error: Option<f64>,
    /// Whether the bar, if there is one, is narrow enough for a number: up to half of the value (of a temperature, of its rise), and up
    /// to a tenth of a largest pressure, whose value is a lower bound otherwise.
    pub resolved: bool,
    /// Position along the motion, m.
    pub x: f64,
    /// Position across it, m (0 for line contacts; reported at y ≤ 0, its mirror image has it too).
    pub y: f64,
    /// Half-width of the error bar of the place, m; `None` likewise.
    pub place_error: Option<f64>,
    /// Whether that is at most a quarter of the contact's half-width.
    pub place_resolved: bool,
}

impl Located {
    /// The figure without its place.
    pub fn estimate(&self) -> Estimate {
        Estimate {
            value: self.value,
            error: self.error,
        }
    }
}

/// The figures that a tribologist asks for first.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Summary {
    /// Film thickness at the centre of the contact, m.
    pub film_central: Estimate,
    /// Smallest film thickness, m.
    pub film_minimum: Estimate,
    /// Where it is.
    pub film_minimum_at: Located,
    /// Smallest film thickness on the centreline y = 0, m.
    pub film_centreline_minimum: Located,
    /// Largest pressure, Pa; a lower bound where a ridge that the mesh does not resolve may exceed it.
    pub pressure_maximum: Located,
    /// Top of the smooth hill of the pressure on which the centre of the contact lies, Pa.
    pub pressure_central: Located,
    /// Largest pressure of the ridge before the outlet of a point contact, Pa; `None` without one, and in line contacts, whose ridge is the
    /// spike.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pressure_ridge: Option<Located>,
    /// Pressure spike near the outlet on the centreline, Pa; `None` when the profile has none.
    pub spike: Option<Located>,
    /// Where the film breaks on the centreline, m.
    pub outlet_position: Estimate,
    /// Most negative pressure left by the cavitation penalty, Pa.
    pub pressure_minimum: f64,
    /// (inflow − outflow − side leakage)/inflow over the boundary of the contact area.
    pub film_balance_error: f64,
    /// |∫p − load|/load.
    pub load_balance_error: f64,
    /// Rigid-body separation h0 of the film equation, m.
    pub rigid_separation: f64,
}

/// One Newton iteration.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct IterationRecord {
    /// Mesh level, 0 the coarsest.
    pub level: usize,
    /// Pressure order on this level.
    pub pressure_order: usize,
    /// Share of the full cavitation penalty in force.
    pub penalty_share: f64,
    /// Iteration count on this level, from 1.
    pub iteration: usize,
    /// Reynolds residual relative to the entrained flow (dimensionless).
    pub residual: f64,
    /// Largest pressure update over p_h.
    pub update: f64,
    /// Share of the Newton step taken.
    pub step: f64,
    /// Krylov iterations of the linear solve.
    pub krylov_iterations: usize,
    /// Central film thickness after the step, m.
    pub film_central: f64,
    /// The round of film and heat that this step ended.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub heat: Option<HeatRound>,
}

/// A round in which films are computed at given temperatures, and temperatures at given films.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct HeatRound {
    /// Relative change of temperature rise, pressure and film from the round before.
    pub change: f64,
    /// Largest temperature rise, K.
    pub temperature_rise: f64,
}

/// One mesh level of the solve.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LevelStats {
    /// Whether Newton's method converged here; a start or an estimate may do without.
    pub converged: bool,
    /// Cells of the body.
    pub n_body_cells: usize,
    /// Elements on the contact area.
    pub n_contact_elements: usize,
    /// Pressure unknowns.
    pub n_pressure_dofs: usize,
    /// Displacement unknowns.
    pub n_displacement_dofs: usize,
    /// Normal displacements on the contact area.
    pub n_contact_dofs: usize,
    /// Lagrange order of the pressure.
    pub pressure_order: usize,
    /// What it was for.
    pub role: Role,
    /// Newton iterations.
    pub newton_iterations: usize,
    /// Krylov iterations, all Newton iterations together.
    pub krylov_iterations: usize,
    /// Factorisations of the preconditioner or the monolithic matrix.
    pub factorisations: usize,
    /// Figures reached: all of a solution, an estimate and an isothermal stage that have converged, else films and
    /// largest pressure.
    #[serde(flatten)]
    pub figures: Figures,
    /// Estimated errors, uncalibrated; `None` where none were.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub estimate: Option<ErrorEstimate>,
    /// Wall seconds: mesh, elastic operator, assembly, preconditioner, Krylov, error estimate, the rest.
    pub seconds: Timings,
}

/// Estimated errors on one mesh, uncalibrated.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct ErrorEstimate {
    /// Relative errors of central and minimum film from the cells.
    pub films: [f64; 2],
    /// What the diffusion at ridges changes both films by, relative.
    #[serde(skip_serializing_if = "are_zero")]
    pub ridge: [f64; 2],
    /// The same from the edges of the contact area.
    pub edges: [f64; 2],
    /// What pressures that the cells do not resolve may do to both films, relative.
    pub unresolved: f64,
    /// Root-mean-square error of the pressure over the dry contact, over p_h.
    pub pressure: f64,
    /// Root-mean-square error of the pressure in the cells around its largest value, Pa.
    pub largest: f64,
    /// The same around the top of the central hill, Pa.
    pub central_pressure: f64,
    /// By how much the ridge may be higher, Pa; zero without one.
    pub ridge_pressure: f64,
    /// Root-mean-square error around the spike on the centreline, Pa; zero without one.
    pub spike: f64,
    /// The same around the edge pressures at y < 0 and y > 0 of a roller, Pa; zero without them.
    #[serde(skip_serializing_if = "are_zero")]
    pub ends: [f64; 2],
    /// Error of the largest shear stress from the slopes of the pressure, Pa.
    pub shear_stress: f64,
    /// Share of the Hertz zone that its boundary is uncertain by for the points at which the film is evaluated.
    pub share_of_point: f64,
    /// What rolling drags along beyond the edges of the contact area.
    pub beyond_edges: BeyondEdges,
    /// Errors of the temperatures; zero where there are none, and where they are not of linear elements.
    pub temperatures: TemperatureErrors,
}

/// Whether there is nothing to write.
fn are_zero(values: &[f64; 2]) -> bool {
    *values == [0.0; 2]
}

/// Share of the rolling friction that lies between edges of the contact area that are set by hand and those that it would have otherwise.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct BeyondEdges {
    /// Traction coefficient at each wall.
    pub traction: f64,
    /// Friction power, W or W/m.
    pub power: f64,
    /// Share of the distance to the edges that is cut off.
    pub cut: f64,
}

/// How far temperatures of linear elements are from those by recovered gradients, K.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct TemperatureErrors {
    /// At most, around the largest and the lowest temperature of the film, and the largest ones of body 1 and body 2.
    pub local: [f64; 4],
    /// Root mean square over the Hertz zone, at mid-film.
    pub rms: f64,
}

/// Wall-clock split of the work, s.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Timings {
    /// Meshing.
    pub mesh: f64,
    /// Elastic operator: assembly and factorisation.
    pub operator: f64,
    /// Assembly of the Reynolds equation and its Jacobian.
    pub assembly: f64,
    /// Factorisation of the preconditioner (or the monolithic matrix).
    pub factorisation: f64,
    /// Linear solves.
    pub krylov: f64,
    /// Temperatures.
    pub heat: f64,
    /// Error estimate: adjoints and misfits.
    pub estimate: f64,
    /// Everything else: spaces, starts, step limits, figures of the level.
    pub other: f64,
}

impl Timings {
    /// Sum of all parts but the rest.
    pub fn known(&self) -> f64 {
        self.mesh
            + self.operator
            + self.assembly
            + self.factorisation
            + self.krylov
            + self.heat
            + self.estimate
    }
}

/// Solver statistics of the whole run.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Stats {
    /// Whether it started from the solution of another case; else from the dry contact.
    pub warm: bool,
    /// One entry per mesh level, coarse to fine.
    pub levels: Vec<LevelStats>,
    /// Wall time of the solve, s.
    pub wall_seconds: f64,
    /// Peak resident memory of the process, bytes; `None` where the system does not tell.
    pub peak_memory: Option<u64>,
}

impl Stats {
    /// The level of the solution; what was tried after it in vain stands behind it.
    pub fn solved(&self) -> Option<&LevelStats> {
        solved(&self.levels)
    }
}

impl LevelStats {
    /// Central and minimum film thickness, m; not a number where there is none.
    pub fn films(&self) -> [f64; 2] {
        let film = |figure| self.figures.value(figure).unwrap_or(f64::NAN);
        [film(Figure::FilmCentral), film(Figure::FilmMinimum)]
    }

    /// Whether it has the mesh and the elements of another.
    pub(crate) fn is_beside(&self, other: &LevelStats) -> bool {
        self.n_contact_elements == other.n_contact_elements
            && self.pressure_order == other.pressure_order
    }
}

/// The last level that is a solution.
pub(crate) fn solved(levels: &[LevelStats]) -> Option<&LevelStats> {
    (levels.iter().rev()).find(|l| l.converged && l.role == Role::Final)
}

/// Film thickness predicted by a published formula.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct FormulaFilm {
    /// Name, e.g. "Hamrock-Dowson 1977".
    pub name: &'static str,
    /// Central film thickness, m, where the formula gives one.
    pub central: Option<f64>,
    /// Minimum film thickness, m, where the formula gives one.
    pub minimum: Option<f64>,
    /// Source of the constants, and what the formula assumes.
    pub source: &'static str,
}

/// Traction and friction.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Traction {
    /// Traction coefficient from the stress at mid-film; positive where body 2 is the faster surface.
    pub coefficient: Estimate,
    /// The same from the stress at body 1.
    pub coefficient_body_1: Estimate,
    /// The same from the stress at body 2.
    pub coefficient_body_2: Estimate,
    /// Traction force at mid-film: N (circular), N/m (line).
    pub force: Estimate,
    /// Traction across the motion, where the contact is not symmetric about y = 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub across: Option<TractionAcross>,
    /// Moment of the traction at mid-film about the contact normal, from x towards y, N m, with which body 2 turns body 1; likewise,
    /// and not of line contacts.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub moment: Option<Estimate>,
    /// Friction power, the work of the surfaces on the film: W (circular), W/m (line).
    pub friction_power: Estimate,
    /// Largest shear stress anywhere in the film, Pa.
    pub shear_stress_maximum: Estimate,
    /// Share of the Hertz zone where the stress, at its largest across the film, thins the fluid by more than
    /// 5 %; `None` for Newtonian fluids.
    pub beyond_first_limit: Option<Estimate>,
    /// Share where it brings the fluid within 5 % of its second plateau; `None` without one.
    pub beyond_second_limit: Option<Estimate>,
}

impl Traction {
    /// Size of the traction coefficient of both components, with the larger of their error bars.
    pub fn size(&self) -> Estimate {
        let Some(across) = &self.across else {
            return Estimate {
                value: self.coefficient.value.abs(),
                error: self.coefficient.error,
            };
        };
        let (along, across) = (self.coefficient, across.coefficient);
        Estimate {
            value: along.value.hypot(across.value),
            error: along.error.zip(across.error).map(|(a, b)| a.max(b)),
        }
    }
}

/// Traction across the motion.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct TractionAcross {
    /// Traction coefficient from the stress at mid-film; positive where body 2 drags body 1 towards +y.
    pub coefficient: Estimate,
    /// The same from the stress at body 1.
    pub coefficient_body_1: Estimate,
    /// The same from the stress at body 2.
    pub coefficient_body_2: Estimate,
    /// Traction force at mid-film: N, N/m (line).
    pub force: Estimate,
}

/// What shear thinning does to the film: both films on one and the same mesh.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct FilmReduction {
    /// 1 − h_c/(h_c of the Newtonian fluid).
    pub central: Estimate,
    /// 1 − h_min/(h_min of the Newtonian fluid).
    pub minimum: Estimate,
}

fn are_empty(fields: &[Vec<f64>; 3]) -> bool {
    fields.iter().all(Vec::is_empty)
}

/// Shear of the film at the points of a profile or a surface, SI. Stresses are those along the motion,
/// positive where body 2 drags the film.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct ShearFields {
    /// Shear stress at mid-film, Pa.
    pub stress_mid: Vec<f64>,
    /// Shear stress at body 1, Pa.
    pub stress_body_1: Vec<f64>,
    /// Shear stress at body 2, Pa.
    pub stress_body_2: Vec<f64>,
    /// Shear stresses across the motion at mid-film, body 1 and body 2, Pa; empty where both halves of the contact are alike.
    #[serde(skip_serializing_if = "are_empty")]
    pub stress_across: [Vec<f64>; 3],
    /// Shear rate at mid-film, its size, 1/s.
    pub rate_mid: Vec<f64>,
    /// Generalized viscosity at mid-film, Pa·s.
    pub generalized_viscosity: Vec<f64>,
}

impl ShearFields {
    /// The fields that there are, with their values.
    pub fn columns(&self) -> Vec<(Field, &[f64])> {
        let [across_mid, across_1, across_2] = &self.stress_across;
        let all: [(Field, &[f64]); 8] = [
            (Field::ShearStressMid, &self.stress_mid),
            (Field::ShearStressBody1, &self.stress_body_1),
            (Field::ShearStressBody2, &self.stress_body_2),
            (Field::ShearRateMid, &self.rate_mid),
            (Field::GeneralizedViscosityMid, &self.generalized_viscosity),
            (Field::ShearStressAcrossMid, across_mid),
            (Field::ShearStressAcrossBody1, across_1),
            (Field::ShearStressAcrossBody2, across_2),
        ];
        (all.into_iter().enumerate())
            .filter(|(i, (_, values))| *i < 5 || !values.is_empty())
            .map(|(_, column)| column)
            .collect()
    }
}

/// Profiles along y = 0, SI.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Centreline {
    /// Position, m.
    pub x: Vec<f64>,
    /// Pressure, Pa.
    pub pressure: Vec<f64>,
    /// Film thickness, m.
    pub film_thickness: Vec<f64>,
    /// Elastic deflection of both bodies together, m.
    pub deflection: Vec<f64>,
    /// Viscosity, Pa·s.
    pub viscosity: Vec<f64>,
    /// Density, kg/m³.
    pub density: Vec<f64>,
    /// Hertz pressure of the dry contact, Pa.
    pub hertz_pressure: Vec<f64>,
    /// Shear of the film.
    pub shear: ShearFields,
}

/// Fields on the contact area (half domain y ≤ 0 for circular contacts), SI.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct SurfaceField {
    /// Points, m.
    pub points: Vec<[f64; 2]>,
    /// Linear sub-cells: triangles (circular), or segments in the first two entries (line).
    pub cells: Vec<[u32; 3]>,
    /// Order of the elements: on each, a field is the polynomial of this order through its values at the nodes.
    pub order: usize,
    /// Points of each element, in the order of [`ertel_fem::element::Lagrange`].
    pub elements: Vec<u32>,
    /// Pressure, Pa.
    pub pressure: Vec<f64>,
    /// Film thickness, m.
    pub film_thickness: Vec<f64>,
    /// Elastic deflection, m.
    pub deflection: Vec<f64>,
    /// Viscosity, Pa·s.
    pub viscosity: Vec<f64>,
    /// Density, kg/m³.
    pub density: Vec<f64>,
    /// Shear of the film.
    pub shear: ShearFields,
}

impl Centreline {
    /// The fields that there are, with their values, SI; `temperatures` of a thermal contact at the same places.
    pub fn columns<'a>(
        &'a self,
        temperatures: Option<&'a FilmTemperatures>,
    ) -> Vec<(Field, &'a [f64])> {
        let mut columns: Vec<(Field, &[f64])> = vec![
            (Field::Pressure, &self.pressure),
            (Field::HertzPressure, &self.hertz_pressure),
            (Field::FilmThickness, &self.film_thickness),
            (Field::Deflection, &self.deflection),
            (Field::Viscosity, &self.viscosity),
            (Field::Density, &self.density),
        ];
        columns.extend(self.shear.columns());
        columns.extend(temperatures.into_iter().flat_map(FilmTemperatures::columns));
        columns
    }
}

/// Displacement of the equivalent body, SI.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct BodyField {
    /// Points, m; y = 0 for line contacts.
    pub points: Vec<[f64; 3]>,
    /// Cell corners and, for order 2, mid-edge nodes in VTK order: 3 or 6 (triangles), 4 or 10
    /// (tetrahedra) entries.
    pub cells: Vec<Vec<u32>>,
    /// Displacement vector, m.
    pub displacement: Vec<[f64; 3]>,
}

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
    /// The figures that are asked for first.
    pub summary: Summary,
    /// What a lack of oil does to the film; `None` where there is enough by itself.
    pub starvation: Option<Starvation>,
    /// Ends and load of a roller; `None` of other contacts.
    pub roller: Option<RollerFigures>,
    /// What roughness makes of the film; `None` where the case gives none.
    pub mixed: Option<MixedLubrication>,
    /// Traction and friction.
    pub traction: Traction,
    /// Where they are summed.
    pub summed_to: SummedTo,
    /// Balances that the solution should keep.
    pub checks: Checks,
    /// Effect of shear thinning on the film; `None` for Newtonian fluids, or where the film of the
    /// Newtonian fluid was not found.
    pub film_reduction: Option<FilmReduction>,
    /// Temperatures and heat; `None` for an isothermal contact.
    pub thermal: Option<Thermal>,
    /// How much each input counts, where that was asked for and can be computed.
    pub sensitivities: Option<Sensitivities>,
    /// What the uncertainty of the inputs comes to; `None` where they have none.
    pub uncertainty: Option<Uncertainties>,
    /// Film-thickness formulas for the same case.
    pub formulas: Vec<FormulaFilm>,
    /// Profiles along the centreline.
    pub centreline: Centreline,
    /// Fields on the contact area.
    pub surface: SurfaceField,
    /// The same fields as polynomials, for pictures.
    pub elements: ElementFields,
    /// Displacement of the body, if asked for.
    pub body: Option<BodyField>,
    /// Every Newton iteration.
    pub history: Vec<IterationRecord>,
    /// Effort.
    pub stats: Stats,
    /// What the model leaves out.
    pub left_out: Neglected,
    /// Figures that the case is solved for and that the mesh does not resolve.
    pub unresolved: Vec<Unresolved>,
    /// What the user should know: ranges left, films below a nanometre, contact area too small.
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
}
