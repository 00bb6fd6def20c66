//! Elastohydrodynamic contacts by the full-system finite element approach: film thickness, pressure, traction and temperature of the
//! micrometre of oil between a ball and its raceway, two gear teeth, a cam and its tappet.
//!
//! A case is read from a file ([`case::Case::read`]) or made in code, with the same checks; a solve gives figures with error bars and fields
//! over the whole contact:
//!
//! ```
//! use ertel::{case::Case, run, solution::Field, engine::NoObserver};
//!
//! let case = Case::builder()
//!     .set("contact.kind", "line")                       // or "circular", "elliptical", "roller"
//!     .set("contact.radius", "10 mm")
//!     .set("contact.load", "100 kN/m")
//!     .set("bodies.body_1", "steel")
//!     .set("bodies.body_2", "steel")
//!     .set("motion.entrainment_speed", "2 m/s")
//!     .set("motion.slide_to_roll_ratio", 0.0)
//!     .set("lubricant", "squalane-pip")
//!     .set("temperature", "40 degC")
//!     .build()?;
//! let solution = run::solve(&case, &mut NoObserver)?;
//! println!("{:.0} nm", 1e9 * solution.summary.film_central.value);
//! let fields = solution.fields();
//! assert!(fields.values(Field::Pressure).is_some());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! | to | see |
//! |---|---|
//! | make or read a case | [`case`] |
//! | solve it from the solution of another one | [`run::solve_from`] |
//! | read figures and fields | [`solution::Solution`], [`solution::ContactFields`] |
//! | vary inputs over lists and ranges | [`case::Study`], [`sweep::sweep`] |
//! | estimate by formulas | [`estimate`], [`mod@reference`] |
//! | fit laws to measurements | [`fit`] |
//! | compare with measurements | [`compare`] |
//! | write the files of the program | [`output`] |
//!
//! The folder `examples` has a small program for each. The solver is the crate `ertel_ehl`, which reads and writes no files; its modules are re-exported
//! here. Modules use only those below them, `ertel_ehl → files, case → problem → mark → figures → run → point → machine → study → output → sweep`
//! (`tests/arrows.rs`).

pub use ertel_ehl::{
    contact, elastic, engine, film, forms, interference, layers, mixed, params, post, solution,
    solve, stress, transient, volumes, warning, wear, words,
};

pub mod case;
pub mod compare;
pub mod cross_check;
pub mod estimate;
pub mod figures;
pub mod files;
pub mod fit;
pub mod machine;
pub mod mark;
pub mod output;
pub mod plausible;
pub mod point;
pub mod problem;
pub mod reference;
pub mod run;
pub mod sensitivity;
pub mod study;
pub mod sweep;

#[cfg(test)]
#[path = "../../ertel-quantity/tests/common/contains.rs"]
mod contains;
#[cfg(test)]
#[path = "../../ertel-quantity/tests/common/near.rs"]
mod near;
