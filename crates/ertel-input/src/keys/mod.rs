//! The keys of cases and studies: kind, bounds, default, usual range and meaning of each value.
//!
//! The schema for editors, questions about unusual values, the form of the page in the browser and the tables of the reference pages are
//! generated from these rows. The readers do not use them: tests compare both.

mod case;
mod describe;
mod lubricant;
mod machine;
mod paths;
mod row;
mod settings;
mod unknown;

pub use case::{
    AXIS, CASE, CONTACT, COURSE, CURVE, INLET, LAYER, MOTION, ROUGHNESS, STUDY, SURFACE, TRANSIENT,
    WEAR,
};
pub use describe::{plain, table, table_of_laws};
pub use lubricant::{
    CONDUCTIVITIES, DENSITIES, HEAT_CAPACITIES, LUBRICANT, SHEAR_LAWS, VISCOSITIES,
};
pub use machine::MACHINES;
pub use paths::{all, rows_of};
pub use row::{Kind, Law, Laws, Row};
pub use settings::{
    CODES, COMPARE, HARDNESS, INTERFEROGRAM, MESH, OUTPUT, RESIDUAL_STRESS, SOLVER, STRESS, THERMAL,
};
pub use unknown::{unknown_first, unknown_path};

use row::{
    ANGLE, DENSITY, FORCE, KELVIN, KINEMATIC, LENGTH, PER_KELVIN, PER_PRESSURE, PRESSURE, ROTATION,
    SPEED, TEMPERATURE, TIME, VISCOSITY, rows,
};
