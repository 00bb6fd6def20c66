//! Parts of the solver on problems of cases: stages, sides, sums of the shear, readings of figures.

mod figures_of_points;
mod shear;
mod sides;
mod stages;
