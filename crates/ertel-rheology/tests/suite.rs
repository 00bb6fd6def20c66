//! All integration tests in one program: each program of its own would link the whole library once more, and run alone.

mod database;
mod derivatives;
mod heat;
mod high_pressure_laws;
mod laws;
mod oils;
mod shear;
