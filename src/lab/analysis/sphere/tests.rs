use super::*;
use crate::analysis::{HeldLobe, Hold};
use bxdf::Material;
use bxdf::material::library;
use bxdf::models::MODELS;

const SIZE: usize = 64;

fn picture(material: &str, light: Light, direction: [f64; 2]) -> Picture {
    of(&material.parse().unwrap(), light, direction, Detail::Full)
}

fn of(material: &Material, light: Light, direction: [f64; 2], detail: Detail) -> Picture {
    let request = Request {
        light,
        direction,
        size: SIZE,
    };
    let model = material.build();
    let lobe = HeldLobe::new(&*model, Hold::Light, DVec3::Z);
    let subject = Subject {
        material: Some(material),
        ..Subject::of(lobe)
    };
    request.answer(&subject, detail, &|| true).unwrap()
}

/// The green channel at a point of the sphere, x to the right and y up, in radii.
fn at(picture: &Picture, x: f64, y: f64) -> f64 {
    let index = |place: f64| ((0.5 + 0.5 * RADIUS * place) * picture.width as f64) as usize;
    f64::from(picture.at(index(x), index(-y)).unwrap()[1])
}

#[test]
fn a_white_diffuse_sphere_shows_the_cosine_to_the_light() {
    let light = direction_from_degrees(50.0, 120.0);
    let white = picture(
        "lambertian_reflection:reflectance=1",
        Light::Directional,
        [50.0, 120.0],
    );
    let disc = Disc { side: SIZE };
    for (index, pixel) in white.pixels.iter().enumerate() {
        let Some((n, coverage)) = disc.pixel(index % SIZE, index / SIZE) else {
            assert_eq!(*pixel, [0.0; 4]);
            continue;
        };
        let expected = n.dot(light).max(0.0);
        assert!(
            (f64::from(pixel[1]) - expected).abs() < 1e-6,
            "{n} {pixel:?}"
        );
        assert!((f64::from(pixel[3]) - coverage).abs() < 1e-7);
    }
}

#[test]
fn a_translucent_sphere_is_lit_from_behind() {
    let leaf = picture(
        "lambertian_transmission:transmittance=1",
        Light::Directional,
        [180.0, 0.0],
    );
    assert!((at(&leaf, 0.0, 0.0) - 1.0).abs() < 2e-3);
    let opaque = picture("lambertian_reflection", Light::Directional, [180.0, 0.0]);
    assert!(opaque.pixels.iter().all(|[r, g, b, _]| *r + *g + *b == 0.0));
}

#[test]
fn the_highlight_stands_halfway_to_the_light() {
    let shiny = picture(
        "rough_conductor:fresnel=one,alpha=0.1",
        Light::Directional,
        [60.0, 90.0],
    );
    let best = (0..SIZE * SIZE).max_by(|a, b| shiny.pixels[*a][1].total_cmp(&shiny.pixels[*b][1]));
    let (n, _) = Disc { side: SIZE }
        .pixel(best.unwrap() % SIZE, best.unwrap() / SIZE)
        .unwrap();
    assert!(n.distance(direction_from_degrees(30.0, 90.0)) < 0.06, "{n}");
}

#[test]
fn a_dome_around_a_white_surface_is_not_seen() {
    for material in [
        "lambertian_reflection:reflectance=1",
        "specular_reflection:reflectance=1",
    ] {
        let white = picture(material, Light::Dome, [0.0; 2]);
        let inside = white.pixels.iter().filter(|pixel| pixel[3] > 0.0);
        for pixel in inside {
            assert!((pixel[1] - 1.0).abs() < 1e-3, "{material} {pixel:?}");
        }
    }
    // Both halves of the dome count.
    let leaf = picture(
        "lambertian_transmission:transmittance=0.5",
        Light::Dome,
        [0.0; 2],
    );
    assert!((at(&leaf, 0.2, 0.3) - 0.5).abs() < 1e-3);
}

#[test]
fn a_mirror_shows_sky_and_sun_and_a_narrow_lobe_comes_near_it() {
    let direction = [70.0, 135.0];
    let mirror = picture("specular_reflection:reflectance=1", Light::Sky, direction);
    let n = direction_from_degrees(35.0, 135.0);
    assert!(at(&mirror, n.x, n.y) > 0.9 * scene::LIGHT_RADIANCE);
    assert!((at(&mirror, 0.0, 0.8) - scene::SKY[1]).abs() < 1e-6);
    let narrow = picture(
        "rough_conductor:fresnel=one,alpha=0.003",
        Light::Sky,
        direction,
    );
    for (a, b) in mirror.pixels.iter().zip(&narrow.pixels) {
        // The edge of the sun is steep: a lobe of some width blurs it.
        assert!((a[1] - b[1]).abs() < 0.05 * a[1] + 1.0, "{a:?} {b:?}");
    }
    let directional = picture("specular_reflection", Light::Directional, direction);
    assert!(
        directional
            .pixels
            .iter()
            .all(|[r, g, b, _]| *r + *g + *b == 0.0)
    );
}

#[test]
fn the_sky_on_a_white_diffuse_sphere_is_its_irradiance() {
    let white = picture(
        "lambertian_reflection:reflectance=1",
        Light::Sky,
        [40.0, 90.0],
    );
    // By a sum over a fine grid of the sphere: no sampling, no lobe.
    let sun = direction_from_degrees(40.0, 90.0);
    let n = DVec3::new(0.0, 0.3, (1.0_f64 - 0.09).sqrt());
    let (rows, columns) = (600, 600);
    let mut sum = 0.0;
    for row in 0..rows {
        let y = 1.0 - 2.0 * (f64::from(row) + 0.5) / f64::from(rows);
        for column in 0..columns {
            let angle = std::f64::consts::TAU * (f64::from(column) + 0.5) / f64::from(columns);
            let radius = (1.0 - y * y).sqrt();
            let w = DVec3::new(radius * angle.cos(), y, radius * angle.sin());
            let t = ((w.dot(sun) - scene::LIGHT_COS) / (1.0 - scene::LIGHT_COS)).clamp(0.0, 1.0);
            let step = ((y + 0.2) / 0.4).clamp(0.0, 1.0);
            let above = step * step * (3.0 - 2.0 * step);
            let sky = above * scene::SKY[1] + (1.0 - above) * 0.10;
            let light = scene::LIGHT_RADIANCE * t * t * (3.0 - 2.0 * t);
            sum += (sky + light) * n.dot(w).max(0.0) / std::f64::consts::PI;
        }
    }
    sum *= 4.0 * std::f64::consts::PI / f64::from(rows * columns);
    let found = at(&white, n.x, n.y);
    assert!((found / sum - 1.0).abs() < 0.02, "{found} {sum}");
}

#[test]
fn every_model_and_material_is_finite_under_every_light() {
    let models = MODELS.iter().map(|model| Material::of(model));
    let named = library::all().iter().map(|named| named.material.clone());
    for material in models.chain(named) {
        for light in Light::ALL {
            let picture = of(&material, light, [40.0, 120.0], Detail::Coarse);
            assert_eq!(picture.width, SIZE.div_ceil(COARSER));
            let is_sane = |x: &f32| x.is_finite() && *x >= 0.0;
            let name = &material.components()[0].model().id;
            assert!(
                picture.pixels.iter().flatten().all(is_sane),
                "{name} {light:?}"
            );
        }
    }
}
