//! The inspector's data: everything there is to say of a surface at one pair of directions.

use glam::DVec3;

use crate::bxdf::{Bxdf, Microfacet};

/// What a surface does at a pair of directions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reading {
    /// f in 1/sr, per channel.
    pub f: [f64; 3],
    /// f |cos(theta_i)| in 1/sr, per channel.
    pub f_cos: [f64; 3],
    /// The density with which wi is sampled for wo, in 1/sr.
    pub pdf: f64,
    /// The factors of a microfacet model; `None` for other surfaces, and where there is no half vector.
    pub microfacet: Option<Microfacet<f64>>,
}

impl Reading {
    /// That of `bxdf` at the unit vectors `wo` and `wi`.
    #[must_use]
    pub fn of(bxdf: &dyn Bxdf<f64>, wo: DVec3, wi: DVec3) -> Self {
        let f = bxdf.f(wo.into(), wi.into()).to_f64();
        Self {
            f,
            f_cos: f.map(|f| f * wi.z.abs()),
            pdf: bxdf.pdf(wo.into(), wi.into()),
            microfacet: bxdf.microfacet(wo.into(), wi.into()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bxdf::Material;
    use crate::bxdf::math::frame::direction_from_degrees;

    #[test]
    fn the_factors_of_a_microfacet_model_make_up_its_value() {
        let material: Material = "rough_conductor:alpha=.4".parse().unwrap();
        let model = material.build::<f64>();
        let [wo, wi] = [40.0, 200.0].map(|phi| direction_from_degrees(55.0, phi));
        let reading = Reading::of(&*model, wo, wi);
        let factors = reading.microfacet.unwrap();
        let product = factors.fresnel.0[1] * factors.d * factors.g / (4.0 * wo.z * wi.z);
        assert!((reading.f[1] / product - 1.0).abs() < 1e-13);
        assert!((reading.f_cos[1] / (product * wi.z) - 1.0).abs() < 1e-13);
        assert!(reading.pdf > 0.0);
    }
}
