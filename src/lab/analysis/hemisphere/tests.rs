use std::f64::consts::PI;

use super::*;
use crate::analysis::{HeldLobe, Hold};
use bxdf::math::frame::direction_from_degrees;
use bxdf::{Material, Scatterer};

const REQUEST: Request = Request {
    projection: Projection::EqualArea,
    quantity: Quantity::F,
    comparison: Comparison::None,
    is_upper: true,
    size: 64,
};

fn built(material: &str) -> Box<dyn Scatterer<f64>> {
    material.parse::<Material>().unwrap().build()
}

fn map(request: Request, material: &str, against: Option<&str>) -> Map {
    let held = direction_from_degrees(40.0, 25.0);
    let (model, other) = (built(material), against.map(built));
    let lobe = HeldLobe::new(&*model, Hold::Light, held);
    let against = other
        .as_deref()
        .map(|other| HeldLobe::new(other, Hold::Light, held));
    let subject = Subject {
        against,
        ..Subject::of(lobe)
    };
    request.answer(&subject, Detail::Full, &|| true).unwrap()
}

/// The sum over the disc of the luminance, each pixel by its share of the hemisphere's solid angle.
fn integral(map: &Map) -> f64 {
    let pixel = 4.0 / (map.raster.width * map.raster.height) as f64;
    let values = map.channel(Channel::Luminance).pixels;
    // The disc's area is pi, the hemisphere's 2 pi.
    values.iter().filter(|v| v.is_finite()).sum::<f64>() * pixel * 2.0
}

#[test]
fn places_and_directions_are_inverse() {
    for projection in Projection::ALL {
        for (theta, phi) in [(0.0, 0.0), (35.0, 100.0), (89.0, -30.0), (140.0, 7.0)] {
            let w = direction_from_degrees(theta, phi);
            let back = projection
                .direction(projection.place(w), theta < 90.0)
                .unwrap();
            assert!(back.distance(w) < 1e-14, "{projection:?} {theta} {phi}");
        }
        assert_eq!(projection.direction([0.8, 0.7], true), None);
        assert!(projection.direction([0.8, 0.5], false).unwrap().z < 0.0);
    }
}

#[test]
fn equal_areas_are_equal_solid_angles() {
    // The zone down to 60 degrees is half the hemisphere.
    let [x, _] = Projection::EqualArea.place(direction_from_degrees(60.0, 0.0));
    assert!((x * x - 0.5).abs() < 1e-15);
}

#[test]
fn s_is_right_and_t_is_up() {
    // A narrow lobe: held at azimuth 25, the mirrored direction stands at azimuth 205, lower left.
    let map = map(REQUEST, "rough_conductor:alpha=0.1", None);
    let values = map.channel(Channel::Luminance).pixels;
    let finite = |i: &usize| values[*i].is_finite();
    let best = (0..values.len())
        .filter(finite)
        .max_by(|a, b| values[*a].total_cmp(&values[*b]))
        .unwrap();
    let expected = REQUEST
        .projection
        .place(direction_from_degrees(40.0, 205.0));
    let found = [best % 64, best / 64].map(|i| 2.0 * (i as f64 + 0.5) / 64.0 - 1.0);
    assert!(
        (found[0] - expected[0]).abs() < 0.05,
        "{found:?} {expected:?}"
    );
    assert!(
        (-found[1] - expected[1]).abs() < 0.05,
        "{found:?} {expected:?}"
    );
    assert!(map.raster.at(0, 0).unwrap()[0].is_nan());
    assert_eq!(map.range(Channel::Luminance).highest, values[best]);
}

#[test]
fn integrals_over_the_disc_are_those_over_the_hemisphere() {
    let f_cos = Request {
        quantity: Quantity::FCos,
        ..REQUEST
    };
    let white = map(f_cos, "lambertian_reflection:reflectance=1", None);
    assert!(
        (integral(&white) - 1.0).abs() < 2e-3,
        "{}",
        integral(&white)
    );
    let pdf = Request {
        quantity: Quantity::Pdf,
        size: 256,
        ..REQUEST
    };
    let density = map(pdf, "rough_conductor:alpha=0.3", None);
    // What is drawn below the horizon is lost.
    assert!(
        (0.9..1.001).contains(&integral(&density)),
        "{}",
        integral(&density)
    );
}

#[test]
fn weights_are_those_of_the_sampler_and_undefined_without_a_density() {
    let weight = Request {
        quantity: Quantity::Weight,
        ..REQUEST
    };
    let white = map(weight, "lambertian_reflection:reflectance=0.7", None);
    let range = white.range(Channel::Green);
    assert!((range.lowest - 0.7).abs() < 1e-12 && (range.highest - 0.7).abs() < 1e-12);
    let below = Request {
        is_upper: false,
        ..weight
    };
    let dark = map(below, "lambertian_reflection", None);
    assert!(dark.raster.pixels.iter().flatten().all(|v| v.is_nan()));
    assert!(!dark.range(Channel::Luminance).is_some());
}

#[test]
fn surfaces_are_compared() {
    let of = |comparison| {
        let request = Request {
            comparison,
            ..REQUEST
        };
        let (a, b) = (
            "lambertian_reflection:reflectance=0.2",
            "lambertian_reflection:reflectance=0.8",
        );
        map(request, a, Some(b)).range(Channel::Luminance)
    };
    let (difference, ratio) = (of(Comparison::Difference), of(Comparison::Ratio));
    assert!(
        (difference.lowest + 0.6 / PI).abs() < 1e-12 && difference.smallest_positive.is_infinite()
    );
    assert!((ratio.highest - 0.25).abs() < 1e-12 && (ratio.lowest - 0.25).abs() < 1e-12);
    let nothing = Request {
        comparison: Comparison::Ratio,
        ..REQUEST
    };
    assert_eq!(map(nothing, "phong", None).raster, Raster::default());
    let below = Request {
        is_upper: false,
        ..nothing
    };
    let undefined = map(below, "phong", Some("phong"));
    assert!(!undefined.range(Channel::Red).is_some());
}

#[test]
fn the_coarse_map_is_smaller_and_either_side_has_a_place() {
    let model = built("phong");
    let subject = Subject::of(HeldLobe::new(&*model, Hold::Light, DVec3::Z));
    let coarse = REQUEST.answer(&subject, Detail::Coarse, &|| true).unwrap();
    assert_eq!((coarse.raster.width, coarse.raster.height), (16, 16));
    assert!(REQUEST.answer(&subject, Detail::Full, &|| false).is_none());
    let below = Request {
        is_upper: false,
        ..REQUEST
    };
    assert_ne!(REQUEST.place(), below.place());
}
