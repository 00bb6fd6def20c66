//! Contacts along the line of action.

mod beam;
mod lines;
mod operation;
mod point;
mod sharing;
mod stiffness;
#[cfg(test)]
mod tests;
mod tooth;

pub use lines::{line_length, mean_line_length};
pub use operation::Operation;
pub use point::{PathLabel, PathParams, PathPoint};
pub use sharing::LoadSharing;
pub(crate) use sharing::Sharing;
pub use stiffness::{ToothStiffness, iso_single_stiffness};
