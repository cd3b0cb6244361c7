//! Project commands: demo, test, gen, validate.
fn main() {}
