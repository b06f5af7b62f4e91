//! How long the checks behind the badges of a material take, for every model and named material:
//! `cargo bench --bench badges`.

use std::time::Instant;

use brdf_explorer::bxdf::Material;
use brdf_explorer::bxdf::material::library;
use brdf_explorer::bxdf::models::MODELS;
use brdf_explorer::lab::contract::check_physical;

fn main() {
    let models = MODELS.map(Material::of);
    let named = library::all().iter().map(|named| named.material.clone());
    let mut times: Vec<(f64, String)> = models
        .into_iter()
        .chain(named)
        .map(|material| {
            let start = Instant::now();
            let reports = check_physical(&material, &|| true);
            assert!(reports.is_some(), "nobody gives up");
            (start.elapsed().as_secs_f64() * 1e3, material.title())
        })
        .collect();
    times.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (median, _) = times.get(times.len() / 2).cloned().unwrap_or_default();
    println!("median {median:.1} ms of {}; the longest:", times.len());
    for (ms, title) in times.iter().rev().take(5) {
        println!("{ms:8.1} ms  {title}");
    }
}
