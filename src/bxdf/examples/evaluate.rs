//! Evaluates a material along the plane of incidence: `cargo run -p bxdf --example evaluate -- gold`.

use bxdf::math::frame::direction_from_degrees;
use bxdf::{Material, Result, Vec3};

fn main() -> Result<()> {
    let given = std::env::args_os().nth(1);
    table(&Material::open(given.unwrap_or_else(|| "gold".into()))?);
    Ok(())
}

/// Prints f and the density of the directions towards the light, seen at 30 degrees.
fn table(material: &Material) {
    let surface = material.build::<f64>();
    let viewer: Vec3<f64> = direction_from_degrees(30.0, 180.0).into();
    println!("{}, viewer at 30 degrees", material.title());
    println!("light (degrees)    f in red, green, blue (1/sr)      density (1/sr)");
    for theta in (-80..=80).step_by(10) {
        let light = direction_from_degrees(f64::from(theta), 0.0).into();
        let (f, density) = surface.f_pdf(viewer, light);
        let [r, g, b] = f.to_f64();
        println!("{theta:15}    {r:.4e}  {g:.4e}  {b:.4e}    {density:.4e}");
    }
    // What leaves in a single direction is no value: it is listed.
    for delta in surface.deltas(viewer).into_iter().flatten() {
        println!(
            "a Dirac delta along {:?}, flux {:?}",
            delta.direction,
            delta.flux.to_f64()
        );
    }
}

#[test]
fn it_runs() {
    for given in ["gold", "mirror", "rough_conductor:alpha=0.05"] {
        table(&Material::open(given).unwrap());
    }
}
