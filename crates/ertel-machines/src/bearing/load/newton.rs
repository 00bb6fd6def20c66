//! Newton's method for the five degrees of freedom of a ring.

use nalgebra::{SMatrix, SVector};

use super::{Error, Given, Info};

pub(crate) type Vector = SVector<f64, 5>;
pub(crate) type Matrix = SMatrix<f64, 5, 5>;

/// Forces on the inner ring and their change with its shifts.
#[derive(Clone, Debug)]
pub(crate) struct Reaction {
    pub force: Vector,
    pub stiffness: Matrix,
    /// Largest load of an element, N.
    pub largest: f64,
}

/// A row of rolling elements whose ring equilibrium is sought.
pub(crate) trait Row {
    /// Forces at given shifts.
    fn reaction(&self, shift: &Vector) -> Result<Reaction, Error>;
    /// Where to begin, with the given loads (0 where shifts are given).
    fn start(&self, load: &Vector) -> Vector;
    /// Longest step, m.
    fn longest_step(&self) -> f64;
    /// Arm of moments and tilts, m.
    fn arm(&self) -> f64;
    /// A stiffness of the order of the bearing's, N/m.
    fn typical_stiffness(&self) -> f64;
}

/// Most trials along a step.
const TRIALS: usize = 50;
/// Largest unbalanced force along a step at its end, over that at its start.
const SLACK: f64 = 0.5;
/// Stiffness added to all directions, in the typical one and times the unbalanced force: directions without any are none where nothing
/// touches.
const SOFT: f64 = 1e-6;

/// Shifts in balance with the given loads.
///
/// The elastic energy of the elements is convex in the shifts, and the unbalanced force its slope, which only grows along a step. Where a
/// step ends beyond the balance by more than [`SLACK`], the place of balance along it is enclosed by halves until it is not: the energy
/// falls with each step, also where elements come into touch. Steps are no longer than [`Row::longest_step`].
pub(crate) fn balance(
    row: &impl Row,
    given: [Given; 5],
    tolerance: f64,
    most: usize,
) -> Result<(Vector, Reaction, Info), Error> {
    let load = Vector::from_fn(|i, _| match given[i] {
        Given::Load(load) => load,
        Given::Shift(_) => 0.0,
    });
    let free = [0, 1, 2, 3, 4].map(|i| matches!(given[i], Given::Load(_)));
    let scale = Vector::from_fn(|i, _| if i < 3 { 1.0 } else { row.arm() });
    let mut shift = row.start(&load);
    for i in 0..5 {
        if let Given::Shift(value) = given[i] {
            shift[i] = value;
        }
    }
    // Force out of balance of the free directions, moments over the arm.
    let rest = |reaction: &Reaction| {
        Vector::from_fn(|i, _| {
            if free[i] {
                reaction.force[i] - load[i]
            } else {
                0.0
            }
        })
    };
    let largest_load = load.component_div(&scale).amax();
    let size = |reaction: &Reaction| {
        rest(reaction).component_div(&scale).amax() / largest_load.max(reaction.largest)
    };
    let mut reaction = row.reaction(&shift)?;
    let mut info = Info::default();
    if free == [false; 5] {
        return Ok((shift, reaction, info));
    }
    for iteration in 0..=most {
        let residual = rest(&reaction);
        info = Info {
            iterations: iteration,
            residual: size(&reaction),
            gyroscopic_slip: false,
        };
        if reaction.largest <= 0.0 && largest_load == 0.0 {
            return Err(Error::Unloaded);
        }
        if info.residual <= tolerance && reaction.largest > 0.0 {
            return Ok((shift, reaction, info));
        }
        let soft = SOFT * info.residual.min(1.0) * row.typical_stiffness();
        let matrix = Matrix::from_fn(|i, j| match (free[i] && free[j], i == j) {
            (true, true) => reaction.stiffness[(i, i)] + soft * scale[i] * scale[i],
            (true, false) => reaction.stiffness[(i, j)],
            (false, true) => 1.0,
            (false, false) => 0.0,
        });
        let Some(mut step) = matrix.lu().solve(&-residual) else {
            break;
        };
        let length = step.component_mul(&scale).amax();
        if !length.is_finite() {
            break;
        }
        if length > row.longest_step() {
            step *= row.longest_step() / length;
        }
        let before = step.dot(&residual).abs();
        let (mut low, mut part, mut high) = (0.0, 1.0, 1.0);
        for trial in 1..=TRIALS {
            let next = shift + step * part;
            let there = row.reaction(&next)?;
            let work = step.dot(&rest(&there)) / before;
            let is_short = work < -SLACK && part < high;
            if trial == TRIALS || (work <= SLACK && !is_short) || size(&there) <= tolerance {
                (shift, reaction) = (next, there);
                break;
            }
            match is_short {
                true => low = part,
                false => high = part,
            }
            part = 0.5 * (low + high);
        }
    }
    Err(Error::NoConvergence {
        iterations: info.iterations,
        residual: info.residual,
    })
}
