//! All integration tests in one program: separate programs would each link the whole library, and run alone.

mod common;
mod database;
mod derivatives;
mod heat;
mod high_pressure_laws;
mod laws;
mod oils;
mod shear;
