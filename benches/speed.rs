//! Nanoseconds per evaluation of every model, f32, on one thread: `cargo bench --bench speed`.
//!
//! The verb `bench` measures the same, in every precision and way to run.

use brdf_explorer::bxdf::models::MODELS;
use brdf_explorer::bxdf::{Material, Side};
use brdf_explorer::lab::speed::{Mode, Operation, PAIRS, Pairs, measure};

fn main() {
    let [above, anywhere] =
        [false, true].map(|is_crossing| Pairs::<f32>::random(PAIRS, is_crossing));
    println!("{:24} {:>8} {:>8} {:>8}", "", "f", "pdf", "sample_f");
    for model in MODELS {
        let material = Material::of(model);
        let pairs = if material.has_side(Side::Transmission) {
            &anywhere
        } else {
            &above
        };
        let ns = |operation| {
            let rows = measure(&material, pairs, operation, &[Mode::Dispatched]);
            rows.first().map_or(f64::NAN, |row| row.ns)
        };
        let [f, pdf, sample] = [Operation::F, Operation::Pdf, Operation::SampleF].map(ns);
        println!("{:24} {f:8.2} {pdf:8.2} {sample:8.2}", model.id);
    }
}
