//! The `ertel` command.
fn main() {}
