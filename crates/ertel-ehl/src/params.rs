//! User settings: mesh, solver, heat, output. The defaults suit most contacts.

mod thermal;

use crate::interference::Interferometer;
use std::path::PathBuf;

use serde::{Deserialize, Serialize};

use crate::contact::ContactKind;
use crate::warning::WarningKind;

pub use thermal::ThermalParams;

/// Mesh density presets.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum MeshPreset {
    /// Quick look.
    Coarse,
    /// Engineering accuracy.
    #[default]
    Normal,
    /// Reference accuracy.
    Fine,
}

impl MeshPreset {
    /// Cell size on the rim of the Hertz zone as a share of the length H_f^⅔ over which a film of
    /// thickness H_f builds up pressure. Newton's method stops converging between 2 and 4, and the
    /// coarse mesh that it starts on has twice these.
    pub fn rim_share(self) -> f64 {
        match self {
            MeshPreset::Coarse => 1.5,
            MeshPreset::Normal => 1.0,
            MeshPreset::Fine => 0.5,
        }
    }
}

/// Mesh and elements; lengths in Hertz half-widths a.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MeshParams {
    /// Preset of the sizes below.
    pub preset: MeshPreset,
    /// Target error (relative) of central and minimum film, until which cells are halved; `None`: the mesh has the
    /// sizes below.
    pub target_error: Option<f64>,
    /// Most pressure unknowns, approximately; `None`: a default that depends on the bodies.
    pub max_unknowns: Option<usize>,
    /// Cell size in the Hertz zone.
    pub hertz_size: f64,
    /// Cell size at the outlet constriction and the side lobes.
    pub constriction_size: f64,
    /// Cell size on the rim of the Hertz zone; `None`: the preset's share of the length over which
    /// the film that formulas predict builds up pressure.
    pub rim_size: Option<f64>,
    /// Cell size at the edge of the contact area (inlet and outlet regions).
    pub edge_size: f64,
    /// Growth of the cell size per distance along the surface.
    pub growth: f64,
    /// Growth of the cell size per depth.
    pub depth_growth: f64,
    /// Width of the elastic body (x extent; half of it in y); `None`: 60, more for thick films.
    pub body_width: Option<f64>,
    /// Depth of the elastic body; `None`: likewise.
    pub body_depth: Option<f64>,
    /// Inlet edge of the contact area, X < −1; `None`: chosen from the film that formulas predict.
    pub inlet: Option<f64>,
    /// Outlet edge of the contact area, X > 1; `None`: chosen likewise.
    pub outlet: Option<f64>,
    /// Half-width of the contact area in Y (circular contacts); `None`: chosen likewise.
    pub side: Option<f64>,
    /// Lagrange order of the pressure, 1 to 5.
    pub pressure_order: usize,
    /// Lagrange order of the displacement: 1 or 2 of finite-element bodies, the pressure's or higher of half-spaces;
    /// `None`: 2, and the pressure's.
    pub elastic_order: Option<usize>,
}

impl MeshParams {
    /// Sizes of a preset; a line contact affords much finer cells.
    pub fn preset(preset: MeshPreset, kind: ContactKind) -> MeshParams {
        let (hertz_size, constriction_size) = match (kind.is_line(), preset) {
            (false, MeshPreset::Coarse) => (0.18, 0.09),
            (false, MeshPreset::Normal) => (0.13, 0.065),
            (false, MeshPreset::Fine) => (0.09, 0.032),
            (true, MeshPreset::Coarse) => (0.05, 0.02),
            (true, MeshPreset::Normal) => (0.02, 0.005),
            (true, MeshPreset::Fine) => (0.01, 0.002),
        };
        // Growing by 0.9 per depth leaves the Hertz deflection 1e-3 off, 0.45 a quarter of it.
        let (growth, depth_growth) = match kind.is_line() {
            false => (0.9, 0.45),
            true => (0.3, 0.3),
        };
        MeshParams {
            preset,
            target_error: None,
            max_unknowns: None,
            hertz_size,
            constriction_size,
            rim_size: None,
            edge_size: 0.5,
            growth,
            depth_growth,
            body_width: None,
            body_depth: None,
            inlet: None,
            outlet: None,
            side: None,
            pressure_order: 3,
            elastic_order: None,
        }
    }
}

/// Default limit of pressure unknowns of a third mesh: some seconds, with heat a minute.
pub const DEFAULT_MAX_UNKNOWNS: usize = 30_000;

/// The same with finite-element bodies, whose operator costs their square to their cube.
pub const DEFAULT_MAX_UNKNOWNS_OF_BODIES: usize = 16_000;

/// Default target error.
pub const DEFAULT_TARGET_ERROR: f64 = 0.002;

impl MeshParams {
    /// Mesh whose cells are halved until central and minimum film are accurate to `target_error`, relative; the sizes
    /// are those that it starts from.
    pub fn adaptive(target_error: f64, kind: ContactKind) -> MeshParams {
        let start = MeshParams::preset(MeshPreset::Normal, kind);
        // Halved cells do not reduce the error of the growth, which falls with its square.
        let share = (target_error / DEFAULT_TARGET_ERROR).min(1.0).sqrt();
        MeshParams {
            target_error: Some(target_error),
            depth_growth: share * start.depth_growth,
            ..start
        }
    }
}

/// Discrete formulation of Reynolds' equation (Habchi 2008, section 3.4.3).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Formulation {
    /// Standard Galerkin.
    Galerkin,
    /// Streamline-upwind Petrov-Galerkin, Habchi 2008, eq. 3.15.
    Supg,
    /// Galerkin least squares, Habchi 2008, eq. 3.16.
    #[default]
    Gls,
}

/// How the cavitation penalty ξ depends on the element size h_e.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum PenaltyScaling {
    /// ξ = ξ₀ h_e², as printed in Habchi 2008, eq. 3.24.
    ElementSquared,
    /// ξ = ξ₀.
    Constant,
    /// ξ = ξ₀ max(1, H_f²/λ), H_f the central film that formulas predict: the layer at the free
    /// boundary, √(ε/ξ), then is a fixed small share of the length √H_f over which a film of any
    /// thickness ruptures.
    #[default]
    Film,
    /// ξ = ξ₀/h_e².
    InverseElementSquared,
}

/// Which bodies deflect.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum ElasticModel {
    /// Both bodies as elastic half-spaces, by integrals over the contact area.
    #[default]
    HalfSpace,
    /// One equivalent finite-element body (Habchi 2008, appendix A).
    Equivalent,
    /// Plane and ball as separate finite-element bodies, deflections summed.
    TwoBodies,
}

/// How the film is discretised.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Method {
    /// Full-system finite elements (Habchi 2008).
    #[default]
    FiniteElements,
    /// Finite volumes on regular grids, for line and point contacts and rollers between half-spaces, with or without heat.
    FiniteVolumes,
}

impl Method {
    /// Its name in case files.
    pub fn name(self) -> &'static str {
        match self {
            Method::FiniteElements => "finite-elements",
            Method::FiniteVolumes => "finite-volumes",
        }
    }

    /// Its name in messages.
    pub fn words(self) -> &'static str {
        match self {
            Method::FiniteElements => "finite elements",
            Method::FiniteVolumes => "finite volumes",
        }
    }

    /// The other one.
    #[must_use]
    pub fn other(self) -> Method {
        match self {
            Method::FiniteElements => Method::FiniteVolumes,
            Method::FiniteVolumes => Method::FiniteElements,
        }
    }
}

/// How Newton's linear system is solved.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum LinearSolver {
    /// Body condensed to its loaded surface once, then Krylov iterations in P and H0.
    #[default]
    Condensed,
    /// One sparse direct factorisation of the whole coupled system in every iteration.
    Monolithic,
}

/// Solver settings.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SolverParams {
    /// Finite elements or finite volumes; `None`: the faster one, and the other one where that does not converge.
    pub method: Option<Method>,
    /// Galerkin, SUPG or GLS.
    pub formulation: Formulation,
    /// Isotropic diffusion coefficient ρ_id of Habchi 2008, eq. 3.18; 0 for none.
    pub isotropic_diffusion: f64,
    /// Whether SUPG and GLS include the deflection, too; without, they are as printed in Habchi
    /// 2008, eqs. 3.15 to 3.17, and incompressible lubricants are not stabilised at all.
    pub elastic_stabilisation: bool,
    /// Cavitation penalty ξ₀.
    pub penalty: f64,
    /// Its dependence on the element size.
    pub penalty_scaling: PenaltyScaling,
    /// Half-spaces or finite-element bodies; `None`: half-spaces, unless another setting requires a body.
    pub elasticity: Option<ElasticModel>,
    /// Condensed or monolithic.
    pub linear: LinearSolver,
    /// Newton stops when the largest pressure update falls below this share of p_h, and the
    /// relative residual too.
    pub tolerance: f64,
    /// Largest number of Newton iterations on one mesh.
    pub max_iterations: usize,
    /// Solve on a second, coarser mesh to bound the discretisation error.
    pub error_estimate: bool,
    /// Neglect shear thinning: use the low-shear viscosity of the lubricant.
    pub newtonian: bool,
    /// Neglect heat in a case with `[thermal]`: everything at the temperature of the inlet.
    pub isothermal: bool,
}

impl Default for SolverParams {
    fn default() -> Self {
        SolverParams {
            method: None,
            formulation: Formulation::default(),
            isotropic_diffusion: 0.0,
            elastic_stabilisation: true,
            penalty: 1e4,
            penalty_scaling: PenaltyScaling::default(),
            elasticity: None,
            linear: LinearSolver::default(),
            tolerance: 1e-8,
            max_iterations: 60,
            error_estimate: true,
            newtonian: false,
            isothermal: false,
        }
    }
}

/// Output files and their folder.
#[derive(Clone, PartialEq, Serialize, Default)]
pub struct OutputParams {
    /// Folder; `None`: `results/<case name>`.
    pub folder: Option<PathBuf>,
    /// Formats in which pictures are written.
    pub pictures: PictureFormats,
    /// Write the displacement of the whole body (`body.vtu`).
    pub body_field: bool,
    /// Write the fields on a regular grid and all figures as netCDF (`result.nc`).
    pub netcdf: bool,
    /// Write the fields at each output time of a case in time as VTU files (`fields.pvd`).
    pub vtu: bool,
    /// Write an animation of a case in time (`animation.png`).
    pub animation: bool,
    /// Interferogram of a point contact.
    pub interferogram: Option<Interferometer>,
    /// Which derivatives of the figures by inputs are computed.
    pub sensitivities: SensitivityDemand,
    /// Kinds of warnings that are counted but not shown.
    pub silence: Vec<WarningKind>,
}

/// As derived, without later fields at their defaults: keys of journals are made of this text, and existing ones stay valid.
impl std::fmt::Debug for OutputParams {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let OutputParams {
            folder,
            pictures,
            body_field,
            netcdf,
            vtu,
            animation,
            interferogram,
            sensitivities,
            // Changes no result.
            silence: _,
        } = self;
        let mut text = f.debug_struct("OutputParams");
        text.field("folder", folder)
            .field("pictures", pictures)
            .field("body_field", body_field)
            .field("interferogram", interferogram)
            .field("sensitivities", sensitivities);
        for (name, is_on) in [("netcdf", netcdf), ("vtu", vtu), ("animation", animation)] {
            if *is_on {
                text.field(name, is_on);
            }
        }
        text.finish()
    }
}

/// Formats in which pictures are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct PictureFormats {
    /// SVG, for browsers and vector programs.
    pub svg: bool,
    /// PDF, for papers.
    pub pdf: bool,
    /// PNG with 300 dots per inch.
    pub png: bool,
}

impl PictureFormats {
    /// Their names in case files.
    pub const NAMES: [&str; 3] = ["svg", "pdf", "png"];

    /// Those with these names; `None` where one is none of [`PictureFormats::NAMES`].
    pub fn named<'a>(names: impl IntoIterator<Item = &'a str>) -> Option<PictureFormats> {
        let mut formats = PictureFormats {
            svg: false,
            ..PictureFormats::default()
        };
        for name in names {
            match name {
                "svg" => formats.svg = true,
                "pdf" => formats.pdf = true,
                "png" => formats.png = true,
                _ => return None,
            }
        }
        Some(formats)
    }
}

impl Default for PictureFormats {
    /// SVG alone.
    fn default() -> Self {
        PictureFormats {
            svg: true,
            pdf: false,
            png: false,
        }
    }
}

/// Which derivatives of the figures by inputs are computed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum SensitivityDemand {
    /// None.
    Off,
    /// Where an input has an uncertainty.
    #[default]
    WhereUncertain,
    /// Also those that cost little compared with a solve: not for thermal contacts, nor for inputs that change the length of a roller in half-widths.
    WhereCheap,
    /// All of them.
    All,
}
