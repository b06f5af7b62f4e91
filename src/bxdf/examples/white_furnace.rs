//! How much light a rough metal that absorbs nothing gives back: in a white furnace, where light comes from everywhere, it
//! would vanish if none were lost. `cargo run -p bxdf --example white_furnace`.

use bxdf::math::frame::direction_from_degrees;
use bxdf::{Material, Result};

fn main() -> Result<()> {
    println!("the share of light that comes back, seen at 0, 60 and 85 degrees");
    for alpha in [0.1, 0.3, 1.0] {
        for compensation in ["none", "kulla_conty", "turquin"] {
            let text =
                format!("rough_conductor:fresnel=one,alpha={alpha},compensation={compensation}");
            let material: Material = text.parse()?;
            let [at_0, at_60, at_85] = [0.0, 60.0, 85.0].map(|theta| returned(&material, theta));
            println!("alpha {alpha:.1}, {compensation:12} {at_0:.3}  {at_60:.3}  {at_85:.3}");
        }
    }
    Ok(())
}

/// Samples for each number printed: its error is about a thousandth.
const SAMPLES: u32 = 1 << 15;

/// The mean weight of samples, which is the integral of f cos over the directions of the light; red, as all are alike.
fn returned(material: &Material, theta_deg: f64) -> f64 {
    let surface = material.build::<f64>();
    let viewer = direction_from_degrees(theta_deg, 0.0).into();
    let weights = (0..SAMPLES).filter_map(|i| {
        let [uc, u0, u1] = quasi_random(i);
        // A lost sample counts as one of weight 0.
        let sample = surface.sample_f(viewer, uc, [u0, u1])?;
        Some(sample.weight().to_f64()[0])
    });
    weights.sum::<f64>() / f64::from(SAMPLES)
}

/// Points that fill the unit cube evenly, by the powers of the root of x^4 = x + 1 (Roberts 2018, "The Unreasonable
/// Effectiveness of Quasirandom Sequences").
fn quasi_random(i: u32) -> [f64; 3] {
    const ROOT: f64 = 1.220_744_084_605_759_5;
    [1, 2, 3].map(|power| (0.5 + f64::from(i) * ROOT.powi(-power)).fract())
}

#[test]
fn what_is_lost_at_normal_incidence_is_known() {
    // 1 - ln 2 of the light comes back at alpha 1 (the masking of height-correlated GGX, integrated).
    let rough: Material = "rough_conductor:fresnel=one,alpha=1".parse().unwrap();
    assert!((returned(&rough, 0.0) - (1.0 - 2.0_f64.ln())).abs() < 2e-3);
    let whole: Material = "rough_conductor:fresnel=one,alpha=1,compensation=kulla_conty"
        .parse()
        .unwrap();
    assert!((returned(&whole, 0.0) - 1.0).abs() < 3e-3);
    main().unwrap();
}
