//! Elastohydrodynamic contacts by the full-system finite element approach: the solver alone, in numbers. It reads no files and writes none;
//! cases, reports and pictures are those of the crate `ertel`, which hands a [`solve::sequence::Problem`] in.
//!
//! | module | what |
//! |---|---|
//! | [`warning`], [`words`] | warnings, number formats in them |
//! | [`contact`], [`params`] | geometry, scales, motion; settings |
//! | [`film`] | the fluid in the film and its flow at a point |
//! | [`forms`] | weak forms at a point |
//! | [`layers`] | layers on elastic bodies |
//! | [`elastic`] | elastic bodies |
//! | [`stress`] | stresses in the bodies, and what they mean for fatigue |
//! | [`solution`], [`mixed`] | figures and fields in SI; asperities |
//! | [`engine`] | the interface of numerical methods: problem, film, errors, coupling of film and heat; figures of any film |
//! | [`post`] | figures, fields and warnings of any film for output |
//! | [`solve`] | finite elements: Newton's method, continuation, refinement, heat |
//! | [`volumes`] | finite volumes: a monotone scheme for line and point contacts and rollers between half-spaces |
//! | [`transient`] | contacts in time, by finite volumes |
//! | [`wear`] | contacts that wear, by finite volumes |

pub mod contact;
pub mod elastic;
pub mod engine;
pub mod film;
pub mod forms;
pub mod interference;
pub mod layers;
pub mod mixed;
pub mod params;
pub mod post;
pub mod solution;
pub mod solve;
pub mod stress;
pub mod transient;
pub mod volumes;
pub mod warning;
pub mod wear;
pub mod words;

#[cfg(test)]
#[path = "../../ertel-quantity/tests/common/near.rs"]
mod near;
