//! The `gouge` command.
fn main() {}
