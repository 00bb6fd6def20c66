//! Meshes, Lagrange elements, assembly and solvers on simplices, independent of lubrication.

pub mod assembly;
pub mod element;
pub mod linear;
pub mod locate;
pub mod mesh;
pub mod platform;
pub mod potential;
pub mod quadrature;
pub mod space;
