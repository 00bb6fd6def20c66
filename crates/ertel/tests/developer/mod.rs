//! The pages for developers: what is generated on them is that of the sources, and the files and names that they link exist.
//!
//! ```text
//! cargo test --release -p ertel --test suite developer                   compare
//! UPDATE_DOCS=1 cargo test --release -p ertel --test suite developer     rewrite the generated parts
//! ```

mod architecture;
mod constants;
mod decisions;
mod equations;
mod links;
mod pages;
mod reference;
mod source;
mod words;
