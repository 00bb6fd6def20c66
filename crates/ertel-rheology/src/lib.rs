//! Laws and database of lubricant and solid properties, in SI; knows no mesh.

pub mod input;
pub mod quantity;
