//! The solver for a web page: case files as text in, JSON out.
//!
//! A page asks for five things, and each is a function here: [`database()`] for its lists, [`form()`] for the values of its fields, [`edit()`]
//! to put a changed field into the case file, [`check()`] for what is wrong with it, and [`solve()`]. Answers are objects with `ok`; where that is
//! `false`, `error` says what the program `ertel` would say, with line, column and key ([`failure`]).
//!
//! The functions are plain Rust, so that tests run them on the computer; `browser` (on `wasm32-unknown-unknown` alone) exports them to
//! JavaScript.

#[cfg(target_arch = "wasm32")]
mod browser;
mod check;
mod database;
mod edit;
pub mod failure;
mod form;
mod progress;
mod solve;

pub use check::check;
pub use database::database;
pub use edit::{EditError, edit};
pub use failure::CASE;
pub use form::form;
pub use solve::solve;
