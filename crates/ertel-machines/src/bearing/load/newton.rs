//! Newton's method for the five degrees of freedom of a ring.

use std::f64::consts::TAU;

use nalgebra::{Matrix2, SMatrix, SVector, Vector2};

use super::{Distribution, Element, Error, Given, Info, Params};

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

/// Force of one element on the inner ring in the two coordinates of [`Row::map`], and its change with them.
pub(crate) struct Push {
    pub force: Vector2<f64>,
    pub stiffness: Matrix2<f64>,
    /// Load on the inner ring, N.
    pub load: f64,
    /// Force on the inner ring in addition, in its own coordinates.
    pub thrust: Vector,
}

/// A row of rolling elements whose ring equilibrium is sought.
pub(crate) trait Row {
    /// An element in balance.
    type State;

    /// Places ψ of the elements, rad.
    fn angles(&self) -> &[f64];
    /// The two coordinates of an element at ψ by the shifts of the inner ring.
    fn map(&self, angle: f64) -> SMatrix<f64, 2, 5>;
    /// The element in balance where the inner ring moves its groove by `moved`; `None` where no balance is found.
    fn state(&self, moved: Vector2<f64>) -> Option<Self::State>;
    /// Its force.
    fn push(&self, angle: f64, state: &Self::State) -> Push;
    /// All about it.
    fn element(&self, angle: f64, state: &Self::State) -> Element;
    /// Where to begin, with the given loads (0 where shifts are given).
    fn start(&self, load: &Vector) -> Vector;
    /// Longest step, m.
    fn longest_step(&self) -> f64;
    /// Arm of moments and tilts, m.
    fn arm(&self) -> f64;
    /// A stiffness of the order of the bearing's, N/m.
    fn typical_stiffness(&self) -> f64;

    /// The element at ψ in balance at given shifts.
    fn state_at(&self, angle: f64, shift: &Vector) -> Result<Self::State, Error> {
        let found = self.state(self.map(angle) * shift);
        found.ok_or(Error::Element {
            degrees: angle.to_degrees(),
        })
    }

    /// Forces at given shifts.
    fn reaction(&self, shift: &Vector) -> Result<Reaction, Error> {
        let mut sum = Reaction::none();
        for angle in self.angles() {
            let map = self.map(*angle);
            let push = self.push(*angle, &self.state_at(*angle, shift)?);
            sum.force += map.transpose() * push.force + push.thrust;
            sum.stiffness += map.transpose() * push.stiffness * map;
            sum.largest = sum.largest.max(push.load);
        }
        Ok(sum)
    }

    /// The distribution in balance with the given loads.
    fn solve(&self, given: [Given; 5], params: &Params) -> Result<Distribution, Error>
    where
        Self: Sized,
    {
        let (shift, reaction, info) = balance(self, given, params.tolerance, params.iterations)?;
        let elements = self.angles().iter().map(|angle| {
            let state = self.state_at(*angle, &shift)?;
            Ok(self.element(*angle, &state))
        });
        finish(
            elements.collect::<Result<_, Error>>()?,
            &shift,
            &reaction,
            info,
        )
    }
}

/// Most steps of the equilibrium of an element, the residual allowed over the largest force, and the one that is accepted where round-off
/// prevents a lower one.
pub(super) const STEPS: usize = 100;
pub(super) const RESIDUAL: f64 = 1e-12;
pub(super) const ACCEPTED: f64 = 1e-9;
/// Approach whose force does not count, in diameters of a ball or lengths of a roller: round-off of its place is not far below.
pub(super) const NEGLIGIBLE: f64 = 1e-6;

/// The part of a step at which a convex energy is low enough, and what `at` gives there: state and work, which is the slope of the energy
/// along the step over its size at the start.
///
/// Where a step ends beyond the balance by more than [`SLACK`], the place of balance along it is enclosed by halves until it is not, or the state
/// `is_good`, at most in `trials`.
pub(super) fn part_of_step<T, E>(
    trials: usize,
    mut at: impl FnMut(f64) -> Result<(T, f64), E>,
    is_good: impl Fn(&T) -> bool,
) -> Result<(f64, T), E> {
    let (mut low, mut part, mut high) = (0.0, 1.0, 1.0);
    let mut trial = 1;
    loop {
        let (there, work) = at(part)?;
        let is_short = work < -SLACK && part < high;
        if trial == trials || (work <= SLACK && !is_short) || is_good(&there) {
            return Ok((part, there));
        }
        match is_short {
            true => low = part,
            false => high = part,
        }
        part = 0.5 * (low + high);
        trial += 1;
    }
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
/// The elastic energy of the elements is convex in the shifts, and the unbalanced force its slope, which only grows along a step. By
/// [`part_of_step`] the energy falls with each step, also where elements come into touch. Steps are no longer than [`Row::longest_step`].
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
        let matrix = reaction.stiffness_of(free, soft, &scale);
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
        let at = |part| {
            let there = row.reaction(&(shift + step * part))?;
            let work = step.dot(&rest(&there)) / before;
            Ok::<_, Error>((there, work))
        };
        let (part, there) = part_of_step(TRIALS, at, |there| size(there) <= tolerance)?;
        (shift, reaction) = (shift + step * part, there);
    }
    Err(Error::NoConvergence {
        iterations: info.iterations,
        residual: info.residual,
    })
}

impl Reaction {
    /// Stiffness of the free directions, with `soft` times the square of their scale; one of the others.
    fn stiffness_of(&self, free: [bool; 5], soft: f64, scale: &Vector) -> Matrix {
        Matrix::from_fn(|i, j| match (free[i] && free[j], i == j) {
            (true, true) => self.stiffness[(i, i)] + soft * scale[i] * scale[i],
            (true, false) => self.stiffness[(i, j)],
            (false, true) => 1.0,
            (false, false) => 0.0,
        })
    }

    fn none() -> Reaction {
        Reaction {
            force: Vector::zeros(),
            stiffness: Matrix::zeros(),
            largest: 0.0,
        }
    }
}

/// The distribution of elements in balance.
fn finish(
    elements: Vec<Element>,
    shift: &Vector,
    reaction: &Reaction,
    info: Info,
) -> Result<Distribution, Error> {
    if reaction.largest <= 0.0 {
        return Err(Error::Unloaded);
    }
    Ok(Distribution {
        elements,
        shift: [shift[0], shift[1], shift[2]],
        tilt: [shift[3], shift[4]],
        force: [reaction.force[0], reaction.force[1], reaction.force[2]],
        moment: [reaction.force[3], reaction.force[4]],
        stiffness: std::array::from_fn(|i| std::array::from_fn(|j| reaction.stiffness[(i, j)])),
        info,
    })
}

pub(super) fn angles(number: usize, params: &Params) -> Vec<f64> {
    (0..number)
        .map(|j| params.first_element + TAU * j as f64 / number as f64)
        .collect()
}

/// Direction of the radial load; x where there is none.
pub(super) fn direction(load: &Vector) -> [f64; 2] {
    match load[0].hypot(load[1]) {
        0.0 => [1.0, 0.0],
        size => [load[0] / size, load[1] / size],
    }
}
