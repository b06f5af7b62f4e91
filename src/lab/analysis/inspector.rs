//! The inspector's data: everything there is to say of a surface at one pair of directions.

use glam::DVec3;

use super::HeldLobe;
use super::lobe::Arrow;
use bxdf::math::frame;
use bxdf::{Microfacet, Side};

/// What a surface does at a pair of directions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reading {
    /// f in 1/sr, per channel; its limit where the free direction lies in the surface plane.
    pub f: [f64; 3],
    /// f |cos(theta_i)| in 1/sr, per channel.
    pub f_cos: [f64; 3],
    /// The density with which wi is sampled for wo, in 1/sr.
    pub pdf: f64,
    /// The factors of a microfacet model; `None` for other surfaces, and where there is no half vector.
    pub microfacet: Option<Microfacet<f64>>,
}

impl Reading {
    /// That of `lobe` with the unit vector `free` as the other direction of the pair.
    #[must_use]
    pub fn of(lobe: &HeldLobe<'_>, free: DVec3) -> Self {
        let bxdf = lobe.surface();
        let (wo, wi) = lobe.pair(free);
        let f = lobe.value_or_limit(free, free.z >= 0.0);
        Self {
            f,
            f_cos: f.map(|f| f * wi.z.abs()),
            pdf: bxdf.pdf(wo.into(), wi.into()),
            microfacet: bxdf.microfacet(wo.into(), wi.into()),
        }
    }
}

/// A Dirac delta of the direction held, beside the values of a pair.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DeltaReading {
    /// Where it goes, and its share.
    pub arrow: Arrow,
    /// Whether the free direction of the pair is its own.
    pub is_here: bool,
}

/// How near the free direction must be to a delta's to be its own, in radians: half a degree, as near as one points.
const HERE: f64 = 0.5 * std::f64::consts::PI / 180.0;

/// The deltas of `lobe`, the reflected one and the transmitted one, with `free` as the other direction of the pair.
#[must_use]
pub fn deltas(lobe: &HeldLobe<'_>, free: DVec3) -> [Option<DeltaReading>; 2] {
    let arrows = lobe.arrows();
    [Side::Reflection, Side::Transmission].map(|side| {
        let arrow = arrows.iter().find(|arrow| arrow.side == side)?;
        Some(DeltaReading {
            arrow: *arrow,
            is_here: frame::angle_between(arrow.direction, free) < HERE,
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::Hold;
    use bxdf::Material;
    use bxdf::math::frame::direction_from_degrees;

    #[test]
    fn the_factors_of_a_microfacet_model_make_up_its_value() {
        let material: Material = "rough_conductor:alpha=.4".parse().unwrap();
        let model = material.build::<f64>();
        let [wo, wi] = [40.0, 200.0].map(|phi| direction_from_degrees(55.0, phi));
        let lobe = HeldLobe::new(&*model, Hold::Light, wi);
        let reading = Reading::of(&lobe, wo);
        let factors = reading.microfacet.unwrap();
        let product = factors.fresnel.0[1] * factors.d * factors.g / (4.0 * wo.z * wi.z);
        assert!((reading.f[1] / product - 1.0).abs() < 1e-13);
        assert!((reading.f_cos[1] / (product * wi.z) - 1.0).abs() < 1e-13);
        assert!(reading.pdf > 0.0);
    }

    /// f has its limit in the surface plane, as a drawn lobe has; times the cosine of the light there it is 0.
    #[test]
    fn in_the_surface_plane_f_is_its_limit_and_no_light_crosses() {
        let material: Material = "oren_nayar:sigma=30".parse().unwrap();
        let model = material.build::<f64>();
        let (held, flat) = (direction_from_degrees(50.0, 180.0), DVec3::X);
        for hold in [Hold::Light, Hold::Viewer] {
            let lobe = HeldLobe::new(&*model, hold, held);
            let reading = Reading::of(&lobe, flat);
            let limit = lobe.value_or_limit(flat, true);
            assert!(limit[0] > 0.05 && reading.f == limit, "{:?}", reading.f);
            let cosine = lobe.pair(flat).1.z.abs();
            assert_eq!(reading.f_cos, limit.map(|f| f * cosine));
        }
    }

    #[test]
    fn a_delta_is_here_where_one_points_at_it() {
        let glass: Material = "fresnel_specular".parse().unwrap();
        let surface = glass.build::<f64>();
        let held = direction_from_degrees(50.0, 180.0);
        let lobe = HeldLobe::new(&*surface, Hold::Light, held);
        let mirror = direction_from_degrees(50.2, 0.0);
        let [Some(up), Some(down)] = deltas(&lobe, mirror) else {
            panic!("two deltas");
        };
        assert!(up.is_here && !down.is_here);
        let [Some(up), Some(down)] = deltas(&lobe, down.arrow.direction) else {
            panic!("two deltas");
        };
        assert!(!up.is_here && down.is_here);
    }
}
