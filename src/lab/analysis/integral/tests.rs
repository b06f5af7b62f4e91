use std::f64::consts::PI;

use super::*;
use bxdf::math::frame::direction_from_degrees;
use bxdf::{Material, Scatterer};

fn built(text: &str) -> Box<dyn Scatterer<f64>> {
    text.parse::<Material>().unwrap().build()
}

fn lobe(surface: &dyn Scatterer<f64>, hold: Hold) -> HeldLobe<'_> {
    HeldLobe::new(surface, hold, direction_from_degrees(50.0, 180.0))
}

fn request(integrand: Integrand, count_log2: u8) -> Request {
    Request {
        integrand,
        count_log2,
        is_sphere: true,
    }
}

fn exact(lobe: HeldLobe<'_>, integrand: Integrand) -> Exact {
    let query = ExactRequest {
        integrand,
        is_sphere: true,
    };
    let subject = Subject::of(lobe);
    query.answer(&subject, Detail::Full, &|| true).unwrap()
}

fn value(exact: &Exact) -> f64 {
    exact.value.unwrap()[1]
}

#[test]
fn patches_cover_a_side_and_find_their_directions() {
    for log2 in COUNT_LOG2[0]..=COUNT_LOG2[1] {
        let grid = Grid::of(log2);
        assert_eq!(grid.count(), 1 << log2);
        for is_upper in [true, false] {
            for (index, patch) in grid.patches(is_upper).enumerate() {
                let w = patch.middle();
                assert_eq!(grid.index_of(w), index);
                assert!((w.z > 0.0) == is_upper && (w.length() - 1.0).abs() < 1e-15);
            }
        }
    }
    assert_eq!(
        Grid::of(8),
        Grid {
            rows: 8,
            columns: 32
        }
    );
    // The pole and the horizon belong to the patches beside them.
    assert!(Grid::of(4).index_of(DVec3::Z) < 8 && Grid::of(4).index_of(DVec3::X) >= 8);
}

#[test]
fn the_sums_of_1_and_of_the_cosine_are_exact_at_every_count() {
    let surface = built("lambertian_reflection");
    let lobe = lobe(&*surface, Hold::Light);
    for (integrand, whole) in [(Integrand::One, 4.0 * PI), (Integrand::Cosine, 2.0 * PI)] {
        for log2 in COUNT_LOG2[0]..=COUNT_LOG2[1] {
            for (is_sphere, part) in [(false, 0.5), (true, 1.0)] {
                let request = Request {
                    is_sphere,
                    ..request(integrand, log2)
                };
                let [found, ..] = request.sum(&lobe).total();
                // Thousands of summands, each rounded.
                assert!((found - part * whole).abs() < 1e-11, "{integrand:?} {log2}");
            }
        }
        assert_eq!(value(&exact(lobe, integrand)), whole);
    }
    // A patch's shadow is its cosine times its area: together they are the disc.
    let shadows: f64 = Grid::of(6).patches(true).map(|patch| patch.shadow()).sum();
    assert!((shadows - PI).abs() < 1e-13);
}

#[test]
fn the_sum_over_a_lambertian_surface_is_its_reflectance() {
    let surface = built("lambertian_reflection:reflectance=0.7");
    for hold in [Hold::Light, Hold::Viewer] {
        let lobe = lobe(&*surface, hold);
        for log2 in [4, 9] {
            let [_, found, _] = request(Integrand::FCos, log2).sum(&lobe).total();
            assert!((found - 0.7).abs() < 1e-13, "{found}");
        }
        let exact = exact(lobe, Integrand::FCos);
        assert!((value(&exact) - 0.7).abs() < 1e-9);
        assert!(
            exact
                .missed(&request(Integrand::FCos, 4).sum(&lobe))
                .is_empty()
        );
    }
}

#[test]
fn a_sum_over_ggx_converges_to_the_reflectance() {
    let surface = built("rough_conductor:alpha=0.3");
    let lobe = lobe(&*surface, Hold::Light);
    let exact = exact(lobe, Integrand::FCos);
    let known =
        crate::analysis::reflectance::directional_hemispherical(lobe.surface(), lobe.held(), 1e-8);
    assert!((value(&exact) - known.reflection[1]).abs() < 1e-6);
    let errors: Vec<f64> = exact
        .course
        .iter()
        .map(|(_, sum)| (sum[1] - value(&exact)).abs())
        .collect();
    assert_eq!(errors.len(), 9);
    assert!(
        errors[8] < 1e-3 && errors[8] < 0.05 * errors[0],
        "{errors:?}"
    );
    let [_, last, _] = request(Integrand::FCos, 12).sum(&lobe).total();
    assert_eq!(last, exact.course[8].1[1]);
}

#[test]
fn the_density_integrates_to_1_less_deltas_and_lost_samples() {
    let exact_of = |text: &str| {
        let surface = built(text);
        exact(lobe(&*surface, Hold::Light), Integrand::Density)
    };
    let glass = exact_of("fresnel_specular:eta=1.5");
    assert!(value(&glass) == 0.0 && glass.lost < 1e-15);
    assert!((glass.deltas - 1.0).abs() < 1e-12);
    let diffuse = exact_of("lambertian_reflection");
    assert!((value(&diffuse) - 1.0).abs() < 1e-6 && diffuse.deltas == 0.0);
    // Facets that send light below the horizon.
    let rough = exact_of("rough_conductor:alpha=0.8");
    assert!(rough.lost > 0.01 && (value(&rough) + rough.lost - 1.0).abs() < 1e-12);
    let text = "name = \"Half a mirror\"\n[[lobes]]\nmodel = \"specular_reflection\"\nweight = 0.5\n\
        [[lobes]]\nmodel = \"lambertian_reflection\"\nweight = 0.5\nreflectance = 1.0\n";
    let surface = bxdf::material::file::parse(text, "mixture")
        .unwrap()
        .build();
    let half = exact(lobe(&*surface, Hold::Light), Integrand::Density);
    assert!(half.deltas > 0.1 && (value(&half) + half.deltas - 1.0).abs() < 1e-6);
    let lobe = lobe(&*surface, Hold::Light);
    let [found, ..] = request(Integrand::Density, 12).sum(&lobe).total();
    assert!((found - value(&half)).abs() < 1e-3);
}

#[test]
fn of_a_mirror_there_is_only_the_point() {
    let surface = built("specular_reflection:reflectance=0.9");
    let lobe = lobe(&*surface, Hold::Light);
    let sum = request(Integrand::FCos, 6).sum(&lobe);
    assert!(sum.parts.iter().all(|part| part.value == [0.0; 3]));
    let [point] = &sum.deltas[..] else {
        panic!("{:?}", sum.deltas);
    };
    assert!(point.direction.distance(direction_from_degrees(50.0, 0.0)) < 1e-12);
    assert!((sum.total()[1] - 0.9).abs() < 1e-12);
    assert!((value(&exact(lobe, Integrand::FCos)) - 0.9).abs() < 1e-12);
    // The cosine and the solid angle have none.
    assert!(request(Integrand::Cosine, 6).sum(&lobe).deltas.is_empty());
    let black = built("specular_reflection:reflectance=0");
    let black = HeldLobe::new(&*black, Hold::Light, DVec3::Z);
    assert_eq!(request(Integrand::FCos, 4).sum(&black).total(), [0.0; 3]);
    assert_eq!(value(&exact(black, Integrand::FCos)), 0.0);
}

#[test]
fn what_crosses_glass_counts_as_flux_for_a_light_and_as_radiance_for_a_viewer() {
    let surface = built("fresnel_specular:eta=1.5");
    let below = |hold| {
        let sum = request(Integrand::FCos, 4).sum(&lobe(&*surface, hold));
        let crossing = sum
            .deltas
            .iter()
            .find(|point| point.side == Side::Transmission);
        (crossing.unwrap().share[1], sum.total()[1])
    };
    let (flux, all) = below(Hold::Light);
    assert!((all - 1.0).abs() < 1e-12);
    // Within glass radiance is larger by the square of the index: from above one sees it divided by that.
    let (radiance, _) = below(Hold::Viewer);
    assert!((radiance - flux / 2.25).abs() < 1e-12, "{radiance} {flux}");
}

#[test]
fn a_needle_that_patches_miss_is_said_with_the_count_that_finds_it() {
    let surface = built("rough_conductor:fresnel=one,alpha=0.001");
    let lobe = lobe(&*surface, Hold::Light);
    for integrand in [Integrand::FCos, Integrand::Density] {
        let exact = exact(lobe, integrand);
        let [missed] = &exact.missed(&request(integrand, 4).sum(&lobe))[..] else {
            panic!("{integrand:?}");
        };
        assert!(missed.found < 0.1 && missed.of > 0.99, "{missed:?}");
        let needed = missed.needed_log2.unwrap();
        assert!((20..=24).contains(&needed), "{needed}");
        let [_, found, _] = request(integrand, needed).sum(&lobe).total();
        assert!((found - missed.of).abs() < OFF_THERE * missed.of, "{found}");
    }
    // At normal incidence the middle of the first row stands too far from n, until there are very many.
    let upright = HeldLobe::new(&*surface, Hold::Light, DVec3::Z);
    let exact = exact(upright, Integrand::FCos);
    let missed = exact.missed(&request(Integrand::FCos, 12).sum(&upright));
    assert!(missed[0].needed_log2.unwrap() > 30);
}

/// How far off a sum may be whose steps hold half of the lobe.
const OFF_THERE: f64 = 0.2;

#[test]
fn the_reflectances_of_a_model_that_is_not_reciprocal_differ() {
    // The factor of Turquin is of one direction alone.
    let surface = built("rough_conductor:compensation=turquin,alpha=1");
    let of = |hold| {
        let lobe = lobe(&*surface, hold);
        let exact = exact(lobe, Integrand::FCos);
        let [_, sum, _] = request(Integrand::FCos, 12).sum(&lobe).total();
        assert!((sum - value(&exact)).abs() < 2e-3, "{sum} {exact:?}");
        value(&exact)
    };
    let [rho_dh, rho_hd] = [Hold::Light, Hold::Viewer].map(of);
    assert!((rho_dh - rho_hd).abs() > 1e-3, "{rho_dh} {rho_hd}");
}
