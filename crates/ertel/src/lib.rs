//! Elastohydrodynamic contacts: contact, film, weak forms, solve, post, case, output.
