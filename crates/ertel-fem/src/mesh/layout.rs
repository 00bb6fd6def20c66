//! How cubes are laid under the contact patch and stretched onto the box.
//!
//! In reference units the patch is nx by ny unit squares and every cube has side 2^m, so that bisection brings cell
//! faces onto all integer planes, the edges of the patch among them:
//!
//! ```text
//!   reference x   -l          0   nx            r + nx        l + nx + r = Nx 2^m
//!                  +-----------+====+-------------+
//!   physical x   -w/2    x_inlet   x_outlet      w/2
//! ```
//!
//! Each axis is mapped piecewise linearly; depth is unstretched as far down as the patch is long.

use super::MeshError;
use super::bisection::AxisMap;

/// A grid of cubes with the maps that take it to the box.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Layout {
    /// side of a cube in reference units
    pub side: f64,
    /// lowest corner in reference units
    pub lower: [f64; 3],
    /// cubes along each axis (1 along y for a plane body)
    pub n_cubes: [usize; 3],
    /// reference to physical coordinates
    pub maps: [AxisMap; 3],
    /// largest over smallest stretch of any part of any axis: bounds the distortion of cells
    pub spread: f64,
}

/// Weight of the number of cubes against the distortion: halving the cubes' side for 10 % less distortion.
const CUBE_WEIGHT: f64 = 0.05;
/// Preference for a coarse unit.
const UNIT_WEIGHT: f64 = 0.02;
const MAX_UNITS: u32 = 8;
const MAX_LEVEL: u32 = 24;
const MAX_CUBES: f64 = 1e5;
/// Above this spread cells would be slivers.
const MAX_SPREAD: f64 = 4.0;

/// Lengths of the parts of an axis: reference (integers) and physical.
type Parts = Vec<[f64; 2]>;

/// Finds the layout with least distortion and few cubes.
pub(super) fn choose_layout(params: &BodyParams) -> Result<Layout, MeshError> {
    let mut best: Option<(f64, Layout)> = None;
    for units in 1..=MAX_UNITS {
        let patch = patch_units(params, units);
        for level in 0..=MAX_LEVEL {
            let side = f64::from(1_u32 << level);
            let xs = x_candidates(params, patch, side);
            let ys = if params.dim == 2 {
                vec![(1, vec![])]
            } else {
                y_candidates(params, patch, side)
            };
            let zs = z_candidates(params, patch, side);
            for (nx, x) in &xs {
                for (ny, y) in &ys {
                    for (nz, z) in &zs {
                        let n_cubes = *nx as f64 * *ny as f64 * *nz as f64;
                        if n_cubes > MAX_CUBES {
                            continue;
                        }
                        let stretches = [x, y, z]
                            .into_iter()
                            .flatten()
                            .map(|part| part[1] / (part[0] * patch.unit));
                        let (low, high) =
                            stretches.fold((1.0_f64, 1.0_f64), |(l, h), s| (l.min(s), h.max(s)));
                        let spread = high / low;
                        if spread > MAX_SPREAD {
                            continue;
                        }
                        let score = spread.ln()
                            + CUBE_WEIGHT * n_cubes.ln()
                            + UNIT_WEIGHT * f64::from(units);
                        if best.as_ref().is_none_or(|(s, _)| score < *s) {
                            best = Some((
                                score,
                                layout(params, side, [*nx, *ny, *nz], [x, y, z], spread),
                            ));
                        }
                    }
                }
            }
        }
    }
    best.map(|(_, layout)| layout)
        .ok_or(MeshError::Proportions {
            width: params.width,
            depth: params.depth,
        })
}

#[derive(Clone, Copy)]
struct Patch {
    nx: f64,
    ny: f64,
    /// physical length of a reference unit
    unit: f64,
}

/// The patch in units, `units` of them along its shorter extent.
fn patch_units(params: &BodyParams, units: u32) -> Patch {
    let length = params.x_outlet - params.x_inlet;
    let units = f64::from(units);
    if params.dim == 2 {
        return Patch {
            nx: units,
            ny: 0.0,
            unit: length / units,
        };
    }
    let unit = length.min(params.y_side) / units;
    let (nx, ny) = ((length / unit).round(), (params.y_side / unit).round());
    Patch {
        nx,
        ny,
        unit: (length / nx * params.y_side / ny).sqrt(),
    }
}

/// Numbers of cubes that come nearest to a physical length.
fn cube_counts(length: f64, side: f64) -> [usize; 2] {
    let n = (length / side).floor().clamp(1.0, 1e7) as usize;
    [n, n + 1]
}

/// A part that is absent physically must be absent in the grid, and conversely.
fn consistent(parts: &Parts) -> bool {
    parts
        .iter()
        .all(|part| part[0] >= 0.0 && (part[0] > 0.0) == (part[1] > 0.0))
}

fn present(parts: Parts) -> Parts {
    parts.into_iter().filter(|part| part[0] > 0.0).collect()
}

fn x_candidates(params: &BodyParams, patch: Patch, side: f64) -> Vec<(usize, Parts)> {
    let (left, right) = (
        params.x_inlet + params.width / 2.0,
        params.width / 2.0 - params.x_outlet,
    );
    let mut found = vec![];
    for n in cube_counts(params.width / patch.unit, side) {
        let outside = n as f64 * side - patch.nx;
        let share = if left + right > 0.0 {
            outside * left / (left + right)
        } else {
            0.0
        };
        for l in [share.floor(), share.floor() + 1.0] {
            let parts = vec![
                [l, left],
                [patch.nx, params.x_outlet - params.x_inlet],
                [outside - l, right],
            ];
            if consistent(&parts) {
                found.push((n, present(parts)));
            }
        }
    }
    found
}

fn y_candidates(params: &BodyParams, patch: Patch, side: f64) -> Vec<(usize, Parts)> {
    let width = params.width / 2.0;
    let parts = |n: usize| {
        vec![
            [n as f64 * side - patch.ny, width - params.y_side],
            [patch.ny, params.y_side],
        ]
    };
    let counts = cube_counts(width / patch.unit, side).into_iter();
    counts
        .filter(|&n| consistent(&parts(n)))
        .map(|n| (n, present(parts(n))))
        .collect()
}

fn z_candidates(params: &BodyParams, patch: Patch, side: f64) -> Vec<(usize, Parts)> {
    // unstretched to the length of the patch, but not below half the depth
    let near = patch
        .nx
        .max(patch.ny)
        .min((params.depth / (2.0 * patch.unit)).floor());
    let parts = |n: usize| {
        vec![
            [n as f64 * side - near, params.depth - near * patch.unit],
            [near, near * patch.unit],
        ]
    };
    let counts = cube_counts(params.depth / patch.unit, side).into_iter();
    counts
        .filter(|&n| consistent(&parts(n)))
        .map(|n| (n, present(parts(n))))
        .collect()
}

fn layout(
    params: &BodyParams,
    side: f64,
    n_cubes: [usize; 3],
    parts: [&Parts; 3],
    spread: f64,
) -> Layout {
    let (low, high) = (-params.width / 2.0, params.width / 2.0);
    // knots of the patch in full precision: facets are recognised by equality
    let x_exact = [low, params.x_inlet, params.x_outlet, high];
    let y_exact = [low, -params.y_side, 0.0];
    let z_exact = [-params.depth, 0.0];
    // reference coordinate 0 is the inlet along x, the symmetry plane along y, the surface along z
    let x_left = if params.x_inlet > low {
        parts[0][0][0]
    } else {
        0.0
    };
    let lower_x = -x_left;
    let lower_y = -parts[1].iter().map(|p| p[0]).sum::<f64>();
    let lower_z = -parts[2].iter().map(|p| p[0]).sum::<f64>();
    let lower = [lower_x, lower_y, lower_z];
    let maps = [
        axis_map(lower_x, low, parts[0], &x_exact),
        if params.dim == 2 {
            AxisMap::default()
        } else {
            axis_map(lower_y, low, parts[1], &y_exact)
        },
        axis_map(lower_z, -params.depth, parts[2], &z_exact),
    ];
    Layout {
        side,
        lower,
        n_cubes,
        maps,
        spread,
    }
}

/// Knots from the lower end; a physical coordinate within rounding of an exact one is replaced by it.
fn axis_map(lower: f64, physical_lower: f64, parts: &Parts, exact: &[f64]) -> AxisMap {
    let (mut reference, mut physical) = (lower, physical_lower);
    let total: f64 = parts.iter().map(|p| p[1]).sum();
    let mut knots = vec![[reference, physical]];
    for part in parts {
        reference += part[0];
        physical += part[1];
        let snapped = exact
            .iter()
            .copied()
            .find(|e| (e - physical).abs() < 1e-9 * total)
            .unwrap_or(physical);
        knots.push([reference, snapped]);
    }
    AxisMap { knots }
}

/// Box with a contact patch on its upper side; any unit of length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BodyParams {
    /// 2: plane body in x-z (line contact); 3: solid cut by its symmetry plane y = 0 (circular contact)
    pub dim: usize,
    /// patch: x from here
    pub x_inlet: f64,
    /// patch: x to here
    pub x_outlet: f64,
    /// patch: y in `[-y_side, 0]` (not read for `dim` 2)
    pub y_side: f64,
    /// box: x in `[-width/2, width/2]`, y in `[-width/2, 0]`
    pub width: f64,
    /// box: z in `[-depth, 0]`
    pub depth: f64,
}

impl BodyParams {
    pub(super) fn check(&self) -> Result<(), MeshError> {
        let require = |ok: bool, name, value, expected| {
            if ok {
                Ok(())
            } else {
                Err(MeshError::Parameter {
                    name,
                    value,
                    expected,
                })
            }
        };
        require(
            matches!(self.dim, 2 | 3),
            "dim",
            self.dim as f64,
            "must be 2 or 3",
        )?;
        let finite_positive = |x: f64| x.is_finite() && x > 0.0;
        require(
            finite_positive(self.width),
            "width",
            self.width,
            "must be positive",
        )?;
        require(
            finite_positive(self.depth),
            "depth",
            self.depth,
            "must be positive",
        )?;
        let half = self.width / 2.0;
        require(
            self.x_inlet >= -half,
            "x_inlet",
            self.x_inlet,
            "must lie within the box, at or right of -width/2",
        )?;
        require(
            self.x_outlet <= half,
            "x_outlet",
            self.x_outlet,
            "must lie within the box, at or left of width/2",
        )?;
        require(
            self.x_outlet > self.x_inlet,
            "x_outlet",
            self.x_outlet,
            "must exceed x_inlet",
        )?;
        if self.dim == 3 {
            let inside = self.y_side > 0.0 && self.y_side <= half;
            require(
                inside,
                "y_side",
                self.y_side,
                "must be positive, at most width/2",
            )?;
        }
        Ok(())
    }

    fn y_lowest(&self) -> f64 {
        if self.dim == 3 { -self.y_side } else { 0.0 }
    }

    pub(super) fn on_patch(&self, x: [f64; 3]) -> bool {
        x[2] == 0.0 && (self.x_inlet..=self.x_outlet).contains(&x[0]) && x[1] >= self.y_lowest()
    }

    /// Whether a facet of the upper side is partly on the patch, partly off.
    pub(super) fn straddles_patch(&self, vertices: &[[f64; 3]], facet: &[u32]) -> bool {
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for x in facet.iter().map(|&v| vertices[v as usize]) {
            for k in 0..2 {
                low[k] = low[k].min(x[k]);
                high[k] = high[k].max(x[k]);
            }
        }
        let overlaps = low[0] < self.x_outlet
            && high[0] > self.x_inlet
            && (self.dim == 2 || high[1] > -self.y_side);
        let inside =
            low[0] >= self.x_inlet && high[0] <= self.x_outlet && low[1] >= self.y_lowest();
        overlaps && !inside
    }
}
