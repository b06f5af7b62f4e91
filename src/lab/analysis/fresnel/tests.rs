use super::*;
use crate::analysis::{HeldLobe, Hold};
use bxdf::Material;
use bxdf::internals::{Conductor, fresnel as core};

/// Indices of clear media at which digits may be lost.
const CLEAR: [f64; 9] = [1e-4, 0.25, 0.5, 0.999_999, 1.000_001, 1.33, 1.5, 2.42, 1e4];

/// n and k of metals, of one with n = 0, and of what hardly absorbs.
const ABSORBING: [(f64, f64); 8] = [
    (0.143, 3.983),
    (0.375, 2.386),
    (1.442, 1.603),
    (0.0, 3.2),
    (0.05, 0.9),
    (1.5, 1e-6),
    (1e4, 1e10),
    (1.0, 1e-3),
];

fn clear(n: f64) -> Face {
    Face::new(Index { n, k: 0.0 })
}

fn mark(face: &Face, kind: MarkKind) -> Option<f64> {
    let marks = face.marks();
    let found = marks.iter().find(|mark| mark.kind == kind)?;
    Some(found.theta_deg)
}

/// Angles from 0 to 90 degrees, both ends among them.
fn angles() -> impl Iterator<Item = f64> {
    (0..=360).map(|step| 0.25 * f64::from(step))
}

fn fresnel(text: &str, theta_deg: f64, request: Request) -> Fresnel {
    let material = text.parse::<Material>().unwrap();
    let surface = material.build();
    let held = frame::direction_from_degrees(theta_deg, 20.0);
    let lobe = HeldLobe::new(&*surface, Hold::Light, held);
    let subject = Subject {
        material: Some(&material),
        ..Subject::of(lobe)
    };
    request.answer(&subject, Detail::Full, &|| true).unwrap()
}

const REQUEST: Request = Request {
    lobe: 0,
    own: Index { n: 1.5, k: 0.0 },
    is_from_below: None,
};

#[test]
fn glass_has_the_angles_of_the_textbooks() {
    let (above, below) = (clear(1.5), clear(1.5).reversed());
    let near = |found: Option<f64>, expected: f64| (found.unwrap() - expected).abs() < 5e-3;
    assert!(near(mark(&above, MarkKind::Brewster), 56.31));
    assert!(near(mark(&below, MarkKind::Brewster), 33.69));
    assert!(near(mark(&below, MarkKind::Critical), 41.81));
    assert_eq!(mark(&above, MarkKind::Critical), None);
    for face in [above, below] {
        let at = face.at(mark(&face, MarkKind::Brewster).unwrap());
        assert!(at.p < 1e-30 && (at.s - (5.0_f64 / 13.0).powi(2)).abs() < 1e-15);
    }
    // The textbook's quotients, by complex numbers.
    for (face, theta, s, p) in [
        (above, 30.0, 0.057_796_105_403_213_1, 0.025_249_146_548_43),
        (above, 80.0, 0.538_594_905_749_580_5, 0.236_813_803_633_365),
        (below, 40.0, 0.390_518_108_562_893, 0.100_064_300_010_927),
    ] {
        let at = face.at(theta);
        assert!(
            (at.s - s).abs() < 1e-14 && (at.p - p).abs() < 1e-14,
            "{at:?}"
        );
    }
}

#[test]
fn the_mean_is_what_models_reflect() {
    for n in CLEAR {
        let above = clear(n);
        for theta in angles() {
            let (c, sine) = frame::cos_sin_deg(theta);
            let index = core::RelativeIndex::new(n);
            for (face, index) in [(above, index), (above.reversed(), index.inverse())] {
                let found = face.at(theta).mean();
                let expected = core::dielectric_with_sine(c, sine * sine, index).reflectance;
                let gap = (found - expected).abs();
                assert!(gap <= 1e-12 * expected, "{n} {theta}: {found} {expected}");
            }
        }
    }
    for (n, k) in ABSORBING {
        let (face, metal) = (Face::new(Index { n, k }), Conductor::new([n; 3], [k; 3]));
        for theta in angles() {
            let (c, sine) = frame::cos_sin_deg(theta);
            let [expected, ..] = metal.reflectance_with_sine(c, sine * sine);
            let found = face.at(theta).mean();
            assert!(
                (found - expected).abs() < 2e-14,
                "{n} {k} {theta}: {found} {expected}"
            );
        }
    }
}

#[test]
fn both_polarisations_are_one_at_the_normal_and_all_at_the_horizon() {
    let clear = CLEAR.map(|n| (n, 0.0));
    for (n, k) in clear.into_iter().chain(ABSORBING) {
        let face = Face::new(Index { n, k });
        let normal = face.at(0.0);
        let expected = ((n - 1.0).powi(2) + k * k) / ((n + 1.0).powi(2) + k * k);
        assert!(
            (normal.s / expected - 1.0).abs() < 1e-9,
            "{n} {k}: {normal:?}"
        );
        for other in [normal.p, normal.schlick, normal.lazanyi] {
            assert!((other / normal.s - 1.0).abs() < 1e-9, "{n} {k}: {normal:?}");
        }
        let horizon = face.at(90.0);
        for share in [horizon.s, horizon.p, horizon.schlick, horizon.lazanyi] {
            assert!((share - 1.0).abs() < 1e-12, "{n} {k}: {horizon:?}");
        }
        for theta in angles() {
            let Reflectances {
                s,
                p,
                schlick,
                lazanyi,
            } = face.at(theta);
            for share in [s, p, schlick, lazanyi] {
                assert!((0.0..=1.0).contains(&share), "{n} {k} {theta}");
            }
            assert!(p <= s * (1.0 + 1e-12), "{n} {k} {theta}: {s} {p}");
        }
    }
}

#[test]
fn both_ways_through_reflect_alike_at_snell_s_angles() {
    for n in CLEAR {
        let (above, below) = (clear(n), clear(n).reversed());
        for theta in angles() {
            let Some(refracted) = above.refracted_deg(theta) else {
                let beyond = above.at(theta);
                let all = Reflectances {
                    s: 1.0,
                    p: 1.0,
                    schlick: 1.0,
                    lazanyi: 1.0,
                };
                assert_eq!(beyond, all, "{n} {theta}");
                continue;
            };
            let sines = [theta, refracted].map(|angle| frame::cos_sin_deg(angle).1);
            assert!((sines[0] - n * sines[1]).abs() < 1e-14 * n.max(1.0));
            // Next to the critical angle the cosine has lost digits that the curve needs there.
            let is_grazing = theta.max(refracted) > 89.0;
            let (there, back) = (above.at(theta), below.at(refracted));
            for (there, back) in [
                (there.s, back.s),
                (there.p, back.p),
                (there.schlick, back.schlick),
                (there.lazanyi, back.lazanyi),
            ] {
                // An angle near the horizon, or its partner in a medium 1e4 times as dense, has lost digits.
                let is_close = (there - back).abs() < 1e-8;
                assert!(is_grazing || is_close, "{n} {theta}: {there} {back}");
            }
        }
    }
}

#[test]
fn equal_indices_reflect_nothing_and_bend_nothing() {
    let none = clear(1.0);
    assert!(none.marks().is_empty() && none.index().is_matched());
    for theta in angles() {
        assert_eq!(none.at(theta), Reflectances::default());
        assert_eq!(none.reversed().at(theta), Reflectances::default());
        assert!((none.refracted_deg(theta).unwrap() - theta).abs() < 1e-12);
    }
}

#[test]
fn metals_have_their_minimum_where_the_textbook_s_form_has_it() {
    // By thirds of an interval, of the quotient of complex numbers.
    for (n, k, angle, least) in [
        (0.143, 3.983, 75.145_169_8, 0.927_025_016_531_482),
        (0.375, 2.386, 64.940_477_9, 0.703_755_308_088_316),
        (1.442, 1.603, 63.038_071_2, 0.157_826_610_708_567),
    ] {
        let face = Face::new(Index { n, k });
        let found = mark(&face, MarkKind::LeastP).unwrap();
        assert!((found - angle).abs() < 1e-4, "{found} {angle}");
        assert!((face.at(found).p - least).abs() < 1e-14);
    }
    // What hardly absorbs has it at Brewster's angle, what absorbs much next to the horizon, and n = 0 reflects all.
    let hardly = Face::new(Index { n: 1.5, k: 1e-6 });
    let found = mark(&hardly, MarkKind::LeastP).unwrap();
    assert!((found - 1.5_f64.atan().to_degrees()).abs() < 1e-4);
    let much = Face::new(Index { n: 1e4, k: 1e10 });
    let found = mark(&much, MarkKind::LeastP).unwrap();
    assert!(found < 90.0 && 90.0 - found < 1e-7, "{found}");
    let all = Face::new(Index { n: 0.0, k: 3.2 });
    assert!(all.marks().is_empty() && all.at(45.0).p == 1.0);
    for face in [hardly, much, all] {
        assert_eq!(face.refracted_deg(30.0), None);
    }
}

#[test]
fn approximations_are_what_they_are_defined_as() {
    let at = core::lazanyi_cosine::<f64>();
    let seventh = (1.0 - at * at).sqrt().atan2(at).to_degrees();
    let clear = [1.1, 1.5, 1e4].map(|n| (n, 0.0));
    for (n, k) in clear.into_iter().chain(ABSORBING) {
        let face = Face::new(Index { n, k });
        let f0 = face.at(0.0).mean();
        let exact = face.at(seventh);
        assert!((exact.lazanyi - exact.mean()).abs() < 1e-12, "{n} {k}");
        let middle = face.at(60.0);
        assert!((middle.schlick - (f0 + (1.0 - f0) / 32.0)).abs() < 1e-14);
    }
    // From the denser side they take the cosine of the light that crosses.
    let below = self::clear(1.5).reversed();
    let f0 = 0.04;
    let crossed = below.refracted_deg(30.0).unwrap().to_radians().cos();
    let expected = f0 + (1.0 - f0) * (1.0 - crossed).powi(5);
    assert!((below.at(30.0).schlick - expected).abs() < 1e-14);
}

#[test]
fn a_lobe_has_an_interface_by_what_its_parameters_mean() {
    let of = |text: &str| {
        let material: Material = text.parse().unwrap();
        lobes(&material)
            .map(|lobe| lobe.model().id)
            .collect::<Vec<_>>()
    };
    assert_eq!(of("rough_dielectric"), ["rough_dielectric"]);
    assert!(of("lambertian_reflection").is_empty());
    // Its index has no effect with these.
    assert!(of("rough_conductor:fresnel=schlick").is_empty());
    assert!(of("specular_reflection").is_empty());
    assert_eq!(of("specular_reflection:fresnel=dielectric").len(), 1);
    let both = Material::new(
        ["plastic", "lambertian_reflection", "rough_conductor"]
            .map(|id| {
                let mut component = id.parse::<Material>().unwrap().components()[0].clone();
                component.set_weight(0.3).unwrap();
                component
            })
            .to_vec(),
    )
    .unwrap();
    let chosen = |place| lobe(&both, place).unwrap().model().id;
    assert_eq!(
        [0, 1, 9, usize::MAX].map(chosen)[..2],
        ["plastic", "rough_conductor"]
    );
    assert_eq!(chosen(usize::MAX), "rough_conductor");
}

#[test]
fn the_side_is_that_of_the_held_direction_unless_one_is_chosen() {
    let glass = "fresnel_specular:eta=1.5";
    let from_above = fresnel(glass, 30.0, REQUEST);
    assert!(!from_above.is_from_below && (from_above.theta_deg - 30.0).abs() < 1e-12);
    let from_below = fresnel(glass, 150.0, REQUEST);
    assert!(from_below.is_from_below && (from_below.theta_deg - 30.0).abs() < 1e-12);
    let [curve] = &from_below.curves[..] else {
        panic!("{from_below:?}");
    };
    assert_eq!(curve.sides(true), [1.5, 1.0]);
    let refracted = curve.held.refracted_deg.unwrap();
    assert!((refracted.to_radians().sin() - 0.75).abs() < 1e-12);
    let chosen = Request {
        is_from_below: Some(true),
        ..REQUEST
    };
    let chosen_from_below = fresnel(glass, 30.0, chosen);
    assert!(chosen_from_below.curves[0].points == curve.points);
    // There is no looking out of a metal.
    let metal = fresnel("rough_conductor", 150.0, chosen);
    assert!(metal.is_absorbing && !metal.is_from_below && metal.curves.len() == 3);
    let own = fresnel("lambertian_reflection", 30.0, REQUEST);
    assert!(own.curves == from_above.curves);
}

#[test]
fn curves_rise_from_place_to_place_and_reach_where_they_bend() {
    for eta in [0.25, 1.0, 1.5, 1000.0] {
        for is_from_below in [false, true].map(Some) {
            let request = Request {
                is_from_below,
                ..REQUEST
            };
            let found = fresnel(&format!("fresnel_specular:eta={eta}"), 10.0, request);
            let curve = &found.curves[0];
            let angles: Vec<f64> = curve.points.iter().map(|point| point.theta_deg).collect();
            assert!(angles.is_sorted_by(|a, b| a < b));
            let ends = (angles[0], *angles.last().unwrap());
            assert_eq!(ends, (0.0, 90.0));
            for mark in &curve.marks {
                assert!(angles.contains(&mark.theta_deg), "{mark:?}");
            }
            // No step is too coarse to be drawn: a hundredth of the height, but where the curve is a wall.
            let steps = curve.points.windows(2);
            let widest = steps
                .filter(|pair| pair[1].theta_deg - pair[0].theta_deg > 0.01)
                .map(|pair| (pair[1].reflectances.s - pair[0].reflectances.s).abs())
                .fold(0.0, f64::max);
            assert!(widest < 0.12, "{eta} {is_from_below:?}: {widest}");
        }
    }
}
