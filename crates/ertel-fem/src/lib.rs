//! Meshes, Lagrange elements, assembly and solvers on simplices; knows no lubrication.

pub mod mesh;
