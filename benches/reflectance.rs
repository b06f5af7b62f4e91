//! How long a reflectance to 1e-6 takes, of every model and named material: `cargo bench --bench reflectance`.

use std::time::Instant;

use brdf_explorer::analysis::reflectance::directional_hemispherical;
use brdf_explorer::bxdf::material::library;
use brdf_explorer::bxdf::math::frame::direction_from_degrees;
use brdf_explorer::bxdf::models::MODELS;
use brdf_explorer::bxdf::{Material, Scatterer};
use rayon::prelude::*;

/// The absolute error wanted.
const TOLERANCE: f64 = 1e-6;

/// Polar angles of the light at which single reflectances are timed, in degrees.
const ANGLES: [f64; 7] = [0.0, 30.0, 60.0, 85.0, 89.9, 120.0, 170.0];

/// Azimuth of the light, in degrees.
const PHI: f64 = 20.0;

/// Milliseconds that `work` takes, and its result.
fn timed<T>(work: impl FnOnce() -> T) -> (f64, T) {
    let start = Instant::now();
    let result = work();
    (start.elapsed().as_secs_f64() * 1e3, result)
}

/// The estimated error of the reflectance at `theta` degrees.
fn error(bxdf: &dyn Scatterer<f64>, theta: f64) -> f64 {
    directional_hemispherical(bxdf, direction_from_degrees(theta, PHI), TOLERANCE).error
}

fn main() {
    let models = MODELS
        .into_iter()
        .map(|model| (model.id, Material::of(model)));
    let named = library::all()
        .iter()
        .map(|named| (named.id, named.material.clone()));
    let (mut singles, mut curves) = (Vec::new(), Vec::new());
    println!("milliseconds at {ANGLES:?} degrees, and of 91 angles on all threads [largest error]");
    for (id, material) in models.chain(named) {
        let bxdf = material.build::<f64>();
        let times = ANGLES.map(|theta| timed(|| error(&*bxdf, theta)).0);
        let (curve, worst) = timed(|| {
            let angles = (0..91_u32).into_par_iter();
            let errors = angles.map(|theta| error(&*bxdf, theta.into()));
            errors.reduce(|| 0.0, f64::max)
        });
        let times_text = times.map(|ms| format!("{ms:8.2}")).concat();
        println!("{id:24}{times_text} {curve:9.1} [{worst:.0e}]");
        singles.extend(times);
        curves.push(curve);
    }
    for (name, limit, mut times) in [("one angle", 5.0, singles), ("91 angles", 200.0, curves)] {
        times.sort_by(f64::total_cmp);
        let rank = |share: f64| {
            let index = (share * (times.len() - 1) as f64) as usize;
            times.get(index).copied().unwrap_or(f64::NAN)
        };
        let within = times.iter().filter(|ms| **ms < limit).count();
        println!(
            "{name}: median {:.2} ms, nine of ten below {:.2} ms, longest {:.1} ms; {within} of {} below {limit} ms",
            rank(0.5),
            rank(0.9),
            rank(1.0),
            times.len()
        );
    }
}
