//! Contacts in time: speeds and loads that change, reliefs that pass, bodies that fall on each other.
//!
//! ```text
//!   ∂(ρ̄H)/∂T + ∇·F = 0,  P ≥ 0,    F = ū(T) ρ̄H − H₊³ρ̄/(μ̄λ) ∇P,    ΣP dA = w̄(T)
//!   H = H_0 + G − Σ_b s_b(x − ∫u_b dT) + K * P
//! ```
//! Finite volumes ([`crate::volumes`]) with the storage term of the film at each node: second-order steps with error control, each
//! solved on all grids, coarse to fine. Where the film has broken the gap counts as full, as in steady contacts.
//!
//! | module | what |
//! |---|---|
//! | [`scheme`] | derivatives in time from instants at uneven distances |
//! | [`course`] | a quantity over time |
//! | [`conditions`] | what changes |
//! | [`body`] | the equation for the distance of the bodies |
//! | `heat` | temperatures of film and bodies |
//! | `present` | the contact at an instant |
//! | [`march`](mod@march) | steps, their errors and lengths |
//! | [`run`] | step control, instants, errors |
//! | [`checkpoint`] | the state for continuing a stopped run |
//! | `report` | the figures reported at an instant |
//! | [`levels`] | one step on all grids |
//!
//! Theory: Time.

pub mod body;
pub mod checkpoint;
pub mod conditions;
pub mod course;
mod heat;
pub mod levels;
pub mod march;
mod present;
mod report;
pub mod run;
pub mod scheme;

pub use body::{Approach, Mover, Start};
pub use checkpoint::{Checkpoint, Info, OtherGrids};
pub use conditions::{Cavities, Conditions, Speeds};
pub use course::Course;
pub use march::{march, resume};
pub use run::{Instant, Params, TransientError, TransientObserver};

#[cfg(test)]
mod tests;
