//! Draws samples of a material and counts them by angle, beside what their density says:
//! `cargo run -p bxdf --example histogram -- brass`.

use std::f64::consts::TAU;

use bxdf::batch::{Columns, Job, Path};
use bxdf::math::frame::{self, direction_from_degrees};
use bxdf::{Material, Result, Scatterer, Vec3};
use glam::DVec3;

fn main() -> Result<()> {
    let given = std::env::args_os().nth(1);
    let material = Material::open(given.unwrap_or_else(|| "brass".into()))?;
    println!(
        "{}, viewer at 40 degrees: samples by their angle from the normal",
        material.title()
    );
    for (index, bin) in histogram(&material).iter().enumerate() {
        let from = index as f64 * WIDTH_DEG;
        let bar = "#".repeat((bin.drawn * 200.0) as usize);
        println!(
            "{from:4}  drawn {:.4}  expected {:.4}  {bar}",
            bin.drawn, bin.expected
        );
    }
    Ok(())
}

/// Samples along each of both numbers that choose a direction.
const SIDE: usize = 512;

/// Degrees of a bin of the histogram.
const WIDTH_DEG: f64 = 5.0;

/// The share of samples whose angle lies in a bin.
#[derive(Clone, Copy, Default)]
struct Bin {
    drawn: f64,
    expected: f64,
}

fn histogram(material: &Material) -> [Bin; 18] {
    let surface = material.build::<f32>();
    let viewer = direction_from_degrees(40.0, 180.0);
    let mut bins = [Bin::default(); 18];
    for [x, y, z] in drawn(&*surface, viewer.into()).rows() {
        // Lost samples are 0.
        let w = DVec3::new(x.into(), y.into(), z.into());
        let bin = (frame::theta(w).to_degrees() / WIDTH_DEG) as usize;
        if w.length_squared() > 0.5
            && let Some(bin) = bins.get_mut(bin)
        {
            bin.drawn += 1.0 / (SIDE * SIDE) as f64;
        }
    }
    // The density, integrated over each bin by midpoints of both angles.
    let surface = material.build::<f64>();
    let (heights, turns) = (32, 720);
    let step = WIDTH_DEG.to_radians() / f64::from(heights);
    for (index, bin) in bins.iter_mut().enumerate() {
        for height in 0..heights {
            let within = (f64::from(height) + 0.5) / f64::from(heights);
            let theta = (index as f64 + within) * WIDTH_DEG;
            let cell = theta.to_radians().sin() * step * TAU / f64::from(turns);
            for turn in 0..turns {
                let phi = 360.0 * (f64::from(turn) + 0.5) / f64::from(turns);
                let light = direction_from_degrees(theta, phi);
                bin.expected += surface.pdf(viewer.into(), light.into()) * cell;
            }
        }
    }
    bins
}

/// The directions drawn for `viewer`, all in one call: batches are several times as fast as single samples.
fn drawn(surface: &dyn Scatterer<f32>, viewer: Vec3<f32>) -> Columns<f32, 3> {
    let count = SIDE * SIDE;
    let middle = |i: usize| (i as f32 + 0.5) / SIDE as f32;
    let numbers = Columns::from_rows((0..count).map(|i| [middle(i % SIDE), middle(i / SIDE)]));
    let choices = Columns::repeated([0.5], count);
    let viewers = Columns::repeated([viewer.x, viewer.y, viewer.z], count);
    let mut directions = Columns::filled(0.0, count);
    let mut rest = Columns::<f32, 5>::filled(0.0, count);
    let [uc] = choices.slices();
    let [r, g, b, pdf, delta] = rest.slices_mut();
    surface.batch(
        Path::Dispatched,
        Job::Sample {
            wo: viewers.slices(),
            uc,
            u: numbers.slices(),
            wi: directions.slices_mut(),
            f: [r, g, b],
            pdf,
            delta,
        },
    );
    directions
}

#[test]
fn samples_are_where_their_density_is() {
    for given in ["brass", "rough_conductor:alpha=0.5,distribution=beckmann"] {
        for bin in histogram(&Material::open(given).unwrap()) {
            // A grid of half a thousand by half a thousand has some thousandths of its points along the edge of a bin.
            assert!((bin.drawn - bin.expected).abs() < 3e-3, "{given}");
        }
    }
    main().unwrap();
}
