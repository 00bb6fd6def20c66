//! Elastohydrodynamic contacts by the full-system finite element approach: contact and film, weak
//! forms, solve, post-processing, case files and output. The arrows point one way:
//! contact, film → forms → solve → post → output; forms never see files, solve never formats text.

pub mod case;
pub mod compare;
pub mod contact;
pub mod elastic;
pub mod estimate;
pub mod film;
pub mod fit;
pub mod forms;
pub mod interference;
pub mod mixed;
pub mod output;
pub mod params;
pub mod plausible;
pub mod post;
pub mod problem;
pub mod reference;
pub mod run;
pub mod sensitivity;
pub mod solution;
pub mod solve;
pub mod study;
pub mod validate;
pub mod warning;
