//! Parts of the solver on problems of cases: stages, sides, sums of the shear, readings of figures, films of any engine.

mod engines;
mod figures_of_points;
mod shear;
mod sides;
mod stages;

use std::sync::Arc;

use ertel::case::Case;
use ertel::problem::problem;
use ertel::solve::contact_surface::ContactSurface;
use ertel::solve::discretisation::Discretisation;
use ertel::solve::sequence::{Problem, Stage};
use ertel_fem::linear::NEVER;

use crate::common::text::{STEEL_AND_OIL, read, with};

const BALL: &str = "kind = \"circular\"\nradius = \"10 mm\"\nload = \"20 N\"";
const ROLLING: &str = "slide_to_roll_ratio = 0.0";
const COARSE: &str = "[mesh]\npreset = \"coarse\"\n";

/// A case of steel at 1 m/s in an oil after Barus, by the lines of its contact, its motion and after its lubricant.
fn case(contact: &str, motion: &str, rest: &str) -> Case {
    let oil = with(
        STEEL_AND_OIL,
        &[["roelands", "barus"], ["22 1/GPa", "10 1/GPa"]],
    );
    read(format!(
        "[contact]\n{contact}\n[motion]\nentrainment_speed = \"1 m/s\"\n{motion}\n{oil}{rest}"
    ))
}

/// A ball that rolls, on a coarse mesh.
fn ball() -> Problem {
    problem(&case(BALL, ROLLING, COARSE))
}

/// The contact area of a stage.
fn surface(problem: &Problem, stage: &Stage) -> ContactSurface {
    ContactSurface::new(
        &problem.shape,
        &problem.extents,
        &stage.sizes,
        &problem.elasticity,
        NEVER,
    )
    .unwrap()
}

/// A stage on its mesh.
fn discretisation(problem: &Problem, stage: &Stage) -> Discretisation {
    Discretisation::new(&Arc::new(surface(problem, stage)), stage.pressure_order)
}
