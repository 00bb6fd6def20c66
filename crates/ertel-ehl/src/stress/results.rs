//! Settings and results of the stresses in the bodies, SI.

use serde::Serialize;

use super::{Criterion, Hardness, Residual, Stress};

/// Settings.
#[derive(Clone, Debug, PartialEq)]
pub struct StressParams {
    /// Largest depth, m; `None`: three times the smaller half-width of the dry contact.
    pub depth: Option<f64>,
    /// Number of planes below the surface.
    pub planes: usize,
    /// Depth from which lives are computed, m; `None`: a tenth of the smaller half-width.
    pub cut_depth: Option<f64>,
    /// Fatigue limit τ_u of the life integral, Pa.
    pub fatigue_limit: f64,
    /// Weight α of the hydrostatic stress in Dang Van's index.
    pub dang_van: f64,
    /// Weight κ of the normal stress in Fatemi and Socie's parameter.
    pub fatemi_socie: f64,
    /// Hardness of each body over depth, if given.
    pub hardness: [Option<Hardness>; 2],
    /// Residual stress of each body over depth, if given.
    pub residual: [Option<Residual>; 2],
}

impl Default for StressParams {
    fn default() -> StressParams {
        StressParams {
            depth: None,
            planes: 60,
            cut_depth: None,
            fatigue_limit: 0.0,
            dang_van: 0.3,
            fatemi_socie: 1.0,
            hardness: [None, None],
            residual: [None, None],
        }
    }
}

/// A largest value with its place; bars are differences from loads, places and depths half as dense, and the bar of the solution's pressure.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Extreme {
    /// The value, Pa.
    pub value: f64,
    /// Error bar, Pa.
    pub error: f64,
    /// Place along the motion, m.
    pub x: f64,
    /// Place across, m.
    pub y: f64,
    /// Depth, m.
    pub depth: f64,
    /// Error bar of the depth, m.
    pub depth_error: f64,
    /// Where in a body with layers.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub site: Option<Site>,
}

/// A place in a body with layers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Site {
    /// The layer, 1 the uppermost; `None`: the substrate.
    pub layer: Option<usize>,
    /// The interface whose side it is, 1 the uppermost.
    pub interface: Option<usize>,
}

/// A value with its depth.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct AtDepth {
    /// The value.
    pub value: f64,
    /// Depth, m.
    pub depth: f64,
}

/// A largest value over depth; bars as those of [`Extreme`].
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct OverDepth {
    /// The value.
    pub value: f64,
    /// Error bar.
    pub error: f64,
    /// Depth, m.
    pub depth: f64,
    /// Error bar of the depth, m.
    pub depth_error: f64,
    /// Where in a body with layers.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub site: Option<Site>,
}

/// A relative life; the bar as that of [`Extreme`].
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Life {
    /// The life over that of the reference.
    pub value: f64,
    /// Error bar.
    pub error: f64,
}

/// The stresses at all depths below a place.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Profile {
    /// Place along the motion, m.
    pub x: f64,
    /// Place across, m.
    pub y: f64,
    /// Depths, m.
    pub depth: Vec<f64>,
    /// Stresses there, Pa.
    pub stress: Vec<Stress>,
    /// Range of σ_xz that points of these depths see while the contact passes, Pa.
    pub orthogonal_range: Vec<f64>,
}

/// Stresses in the plane of motion through the middle of the contact.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Section {
    /// Places along the motion, m.
    pub x: Vec<f64>,
    /// Depths, m.
    pub depth: Vec<f64>,
    /// Stresses, `[depth * x.len() + x]`, Pa.
    pub stress: Vec<Stress>,
}

impl Section {
    /// Indices of the depths above which cells begin: between both sides of an interface there are none.
    pub fn rows(&self) -> impl Iterator<Item = usize> {
        let pairs = self.depth.windows(2).enumerate();
        pairs.filter_map(|(j, pair)| (pair[1] > pair[0]).then_some(j))
    }
}

/// Largest values of a passage at a depth; of the whole plane but for the indices, the shear of the shakedown and the range of σ_xz under
/// rollers, which are those of the middle.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Layer {
    /// Depth, m.
    pub depth: f64,
    /// Where in a body with layers.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub site: Option<Site>,
    /// Largest stress after von Mises, Pa.
    pub von_mises: f64,
    /// Largest shear stress, Pa.
    pub largest_shear: f64,
    /// Largest principal stress, Pa.
    pub tension: f64,
    /// Half the largest range of σ_xz, Pa.
    pub orthogonal_half_range: f64,
    /// Dang Van's index, with the residual stress, Pa.
    pub dang_van: f64,
    /// Least yield strength in shear that shakes down: |σ_xz| of lines and rollers, else the radius of the smallest sphere around the path of the
    /// deviator over √2, Pa.
    pub shakedown_shear: f64,
    /// Fatemi and Socie's parameter, with the residual stress, Pa; where there is a hardness.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub fatemi_socie: Option<f64>,
    /// Hardness, HV.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub hardness: Option<f64>,
    /// Residual stress along and across the motion, Pa.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub residual: Option<[f64; 2]>,
    /// Largest stress after von Mises with the residual stress, Pa.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub total_von_mises: Option<f64>,
    /// Stress after von Mises, with the residual stress, over the yield strength.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub utilisation: Option<f64>,
    /// The shear of the shakedown over the yield strength in shear.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub shakedown_use: Option<f64>,
}

/// Condition that limits the shakedown.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum ShakedownBy {
    /// Lines and rollers: residual stresses depend on the depth alone, have no σ_xz, and let |σ_xz| decide (Melan's static theorem).
    OrthogonalShear,
    /// Others: residual stresses may take the deviator to the centre of the smallest sphere around its path. Whether they are in equilibrium is
    /// not checked: the limit is an upper bound.
    SmallestSphere,
}

/// Elastic limit in repeated passages.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Shakedown {
    /// Condition that limits it.
    pub by: ShakedownBy,
    /// Least yield strength in shear k that shakes down, Pa.
    pub shear: OverDepth,
    /// Hertz pressure over that: the limit p_h/k.
    pub pressure_over_yield: f64,
    /// Smallest yield strength in shear over the shear of all depths, where there is a hardness; k = σ_y/√3.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub safety: Option<OverDepth>,
}

/// Lives by one criterion over those of the frictionless Hertz contact of the same load without fatigue limit.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Lives {
    /// The stress that decides.
    pub criterion: Criterion,
    /// Depths from which it is counted, m: half the cut, the cut, and twice the cut.
    pub cut_depth: [f64; 3],
    /// By the volume integral with the fatigue limit; `None`: no stress exceeds the limit.
    pub integral: [Option<Life>; 3],
    /// By the largest stress and its depth, without fatigue limit.
    pub largest_stress: [Life; 3],
}

/// Largest stresses in a layer or in the substrate.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PartStresses {
    /// The layer, 1 the uppermost; `None`: the substrate.
    pub layer: Option<usize>,
    /// Largest stress after von Mises.
    pub von_mises: Extreme,
    /// Largest shear stress.
    pub largest_shear: Extreme,
    /// Largest principal stress.
    pub tension: Extreme,
    /// Largest stress after von Mises over the yield strength.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub utilisation: Option<OverDepth>,
}

/// Largest tractions on an interface, which both its sides share.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Interface {
    /// Its number, 1 the uppermost.
    pub interface: usize,
    /// Largest shear on it, √(σ_xz² + σ_yz²).
    pub shear: Extreme,
    /// Largest σ_zz on it: where positive, it pulls the layer off.
    pub pull: Extreme,
}

/// Stresses in a body.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct BodyStresses {
    /// Poisson's ratio, of the substrate.
    pub poissons_ratio: f64,
    /// Traction on the body along x over its load.
    pub traction: f64,
    /// Largest stress after von Mises.
    pub von_mises: Extreme,
    /// Largest shear stress.
    pub largest_shear: Extreme,
    /// Largest principal stress: tension.
    pub tension: Extreme,
    /// Half the largest range of σ_xz over a passage, below the cut; under a roller in its middle.
    pub orthogonal_half_range: Extreme,
    /// Largest index of Dang Van below the cut, Pa.
    pub dang_van: OverDepth,
    /// Largest index of Dang Van from the surface to the cut, Pa: an index of micropitting.
    pub near_surface_dang_van: OverDepth,
    /// Shakedown.
    pub shakedown: Shakedown,
    /// Largest stress after von Mises with the residual stress.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub total_von_mises: Option<OverDepth>,
    /// Largest stress after von Mises over the yield strength.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub utilisation: Option<OverDepth>,
    /// Largest stresses of each layer and of the substrate; none without layers.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub parts: Vec<PartStresses>,
    /// Largest tractions on the interfaces above the largest depth.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub interfaces: Vec<Interface>,
    /// Relative lives; of bodies with layers those of the substrate.
    pub lives: Vec<Lives>,
    /// Depth by depth.
    pub layers: Vec<Layer>,
    /// Below the middle of the contact.
    pub axis: Profile,
    /// Below the place of the largest stress after von Mises.
    pub below_largest: Profile,
    /// The plane of motion through the middle.
    #[serde(skip)]
    pub section: Section,
}

/// Largest stresses of the frictionless dry contact, Pa.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct DryContact {
    /// After von Mises.
    pub von_mises: AtDepth,
    /// Largest shear.
    pub largest_shear: AtDepth,
    /// Half the range of σ_xz (Lundberg and Palmgren); where the motion is along the smaller half-width.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub orthogonal_half_range: Option<AtDepth>,
}

/// Stresses in both bodies.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Stresses {
    /// Each body.
    pub bodies: [BodyStresses; 2],
    /// The dry contact, by Poisson's ratio of body 1.
    pub dry: DryContact,
    /// Largest depth, m.
    pub depth: f64,
    /// Fatigue limit of the life integral, Pa.
    pub fatigue_limit: f64,
    /// Weight of the hydrostatic stress in Dang Van's index.
    pub dang_van_weight: f64,
    /// Pressure on the grid of the stresses over the load of the contact.
    pub load_share: f64,
    /// Number of points per body.
    pub points: usize,
}
