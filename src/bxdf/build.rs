//! Tells cargo that the embedded materials are part of the sources: a file added there is seen by the next build.

fn main() {
    println!("cargo::rerun-if-changed=materials");
}
