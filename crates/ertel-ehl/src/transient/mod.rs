//! Contacts in time: speeds and loads that change, reliefs that pass, bodies that fall on each other.
//!
//! ```text
//!   ∂(ρ̄H)/∂T + ∇·F = 0,  P ≥ 0,    F = ū(T) ρ̄H − H₊³ρ̄/(μ̄λ) ∇P,    ΣP dA = w̄(T)
//!   H = H_0 + G − Σ_b s_b(x − ∫u_b dT) + K * P
//! ```
//! Finite volumes ([`crate::volumes`]) with what the film stores at each node: steps of the second order whose length follows from their error, each of them
//! solved on all grids, coarse to fine. Where the film has broken the gap counts as full, as in steady contacts.
//!
//! | module | what |
//! |---|---|
//! | [`scheme`] | derivatives in time from instants at uneven distances |
//! | [`course`] | a quantity over time |
//! | [`conditions`] | what changes |
//! | [`body`] | what the distance of the bodies follows from |
//! | [`march`](mod@march) | steps, their errors and lengths |
//! | [`levels`] | one step on all grids |
//!
//! Theory: Time.

pub mod body;
pub mod conditions;
pub mod course;
pub mod levels;
pub mod march;
pub mod scheme;

pub use body::{Approach, Mover, Start};
pub use conditions::{Conditions, Speeds};
pub use course::Course;
pub use march::{Info, Instant, Params, TransientError, TransientObserver, march};

#[cfg(test)]
mod tests;
