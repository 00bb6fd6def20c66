//! Temperature of the film and of both bodies, and its coupling with the film equations.
//!
//! - `column`: the layers over a point of the contact area, bottom to top;
//! - `space`: temperatures over the contact area, and their values in the film equations;
//! - `profile`: temperatures of a state at points;
//! - `prescribed`: temperatures that are prescribed;
//! - `inflow`: heat that the lubricant brings through the edge;
//! - `cross_flow`: the mass flow across the film;
//! - `sides`: sides of elements, and what flows through them;
//! - `element`: what an element adds to residual and Jacobian of the energy equation;
//! - `system`: both as a whole;
//! - `newton`: temperatures for given pressures and films;
//! - `coupling`: both in turn, until neither changes;
//! - `balance`: sources and sinks of heat;
//! - `recovery`: smooth temperatures from linear elements;
//! - `deviation`: how far the linear elements are from them.

pub mod balance;
pub mod column;
pub mod coupling;
mod cross_flow;
pub mod deviation;
mod element;
mod inflow;
pub mod newton;
mod prescribed;
mod profile;
pub mod recovery;
pub mod sides;
pub mod space;
pub mod system;
