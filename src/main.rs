//! Arguments to command line or window; no logic.

fn main() {}
