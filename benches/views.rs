//! How long the pictures of the views take, for every model at its defaults and every named material.
//!
//! `cargo bench --bench views` prints for each query the median, the slowest and its limit. Whatever cores there are
//! work together, as they do for the window.

use std::time::Instant;

use brdf_explorer::analysis::hemisphere::{Comparison, Projection, Quantity};
use brdf_explorer::analysis::sphere::Light;
use brdf_explorer::analysis::{Detail, HeldLobe, Hold, Query, Subject, hemisphere, slice, sphere};
use brdf_explorer::bxdf::Material;
use brdf_explorer::bxdf::material::library;
use brdf_explorer::bxdf::math::frame::direction_from_degrees;
use brdf_explorer::bxdf::models::MODELS;

/// Answers of which the fastest counts: other work on the machine only makes them slower.
const ROUNDS: usize = 3;

/// Prints how long `query` takes of all `materials`, in milliseconds.
fn measure<Q: Query>(
    name: &str,
    query: &Q,
    detail: Detail,
    limit_ms: Option<f64>,
    materials: &[Material],
) {
    let mut times: Vec<(f64, String)> = Vec::new();
    for material in materials {
        let surface = material.build();
        let held = direction_from_degrees(50.0, 180.0);
        let subject = Subject {
            material: Some(material),
            ..Subject::of(HeldLobe::new(&*surface, Hold::Light, held))
        };
        let time = || {
            let begin = Instant::now();
            let answer = query.answer(&subject, detail, &|| true);
            assert!(answer.is_some(), "it is wanted to the end");
            begin.elapsed().as_secs_f64() * 1e3
        };
        let fastest = (0..ROUNDS).map(|_| time()).fold(f64::INFINITY, f64::min);
        times.push((fastest, material.title()));
    }
    times.sort_by(|a, b| a.0.total_cmp(&b.0));
    let median = times.get(times.len() / 2).map_or(f64::NAN, |time| time.0);
    if let Some((slowest, title)) = times.last() {
        let limit = limit_ms.map_or(String::new(), |limit| format!("   limit {limit:5.0} ms"));
        println!("{name:44} median {median:7.2} ms   slowest {slowest:8.2} ms ({title}){limit}");
    }
}

fn main() {
    use Detail::{Coarse, Full};

    let models = MODELS.iter().map(|spec| Material::of(spec));
    let named = library::all().iter().map(|named| named.material.clone());
    let all: Vec<Material> = models.chain(named).collect();
    let map = |quantity| hemisphere::Request {
        projection: Projection::EqualArea,
        quantity,
        comparison: Comparison::None,
        is_upper: true,
        size: 256,
    };
    let lit = |light| sphere::Request {
        light,
        direction: [45.0, 135.0],
        size: 512,
    };
    let slice = slice::Request {
        phi_d_deg: 90.0,
        phi_h_deg: 0.0,
        is_square_root: false,
        size: 256,
    };
    for quantity in [Quantity::F, Quantity::Weight] {
        let name = format!("hemisphere 256, {}, full", quantity.title());
        measure(&name, &map(quantity), Full, Some(60.0), &all);
    }
    let directional = lit(Light::Directional);
    measure(
        "sphere 512, directional, coarse",
        &directional,
        Coarse,
        Some(30.0),
        &all,
    );
    measure(
        "sphere 512, directional, full",
        &directional,
        Full,
        Some(150.0),
        &all,
    );
    measure(
        "sphere 512, dome, full",
        &lit(Light::Dome),
        Full,
        None,
        &all,
    );
    measure(
        "sphere 512, sky, coarse",
        &lit(Light::Sky),
        Coarse,
        None,
        &all,
    );
    measure("slice 256, full", &slice, Full, None, &all);
}
