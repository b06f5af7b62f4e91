use super::*;
use crate::analysis::Hold;
use bxdf::math::frame::direction_from_degrees;
use bxdf::{Material, Scatterer};

fn surface(text: &str) -> Box<dyn Scatterer<f64>> {
    text.parse::<Material>().unwrap().build()
}

fn lobe(surface: &dyn Scatterer<f64>) -> HeldLobe<'_> {
    HeldLobe::new(surface, Hold::Light, direction_from_degrees(60.0, 20.0))
}

fn request(abscissa: Abscissa) -> Request {
    Request {
        abscissa,
        fixed_deg: 30.0,
        phi: 20.0_f64.to_radians(),
        with_cosine: false,
        scale: RadialScale::Linear,
        is_residual: false,
    }
}

fn chord_at(line: &[Point], x_deg: f64, height: impl Fn(f64) -> f64) -> f64 {
    let after = line.partition_point(|point| point.x_deg < x_deg);
    let (a, b) = (line[after - 1], line[after]);
    let part = (x_deg - a.x_deg) / (b.x_deg - a.x_deg);
    height(a.value[0]) * (1.0 - part) + height(b.value[0]) * part
}

#[test]
fn the_chords_follow_the_curve_everywhere() {
    let logarithmic = RadialScale::Logarithmic { decades: 4.0 };
    for text in [
        "rough_conductor:alpha=0.0003",
        "rough_conductor:alpha=0.3",
        "retro_reflector:alpha=0.01",
        "plastic:alpha=0.1",
        "rough_dielectric:alpha=0.02",
        "oren_nayar:sigma=40",
        "ward:alpha=0.05",
        "charlie_sheen",
    ] {
        let surface = surface(text);
        let subject = Subject::of(lobe(&*surface));
        for abscissa in Abscissa::ALL {
            for scale in [RadialScale::Linear, logarithmic] {
                let request = Request {
                    scale,
                    ..request(abscissa)
                };
                let curve = curve(&subject, &request);
                // What lies below the last decade is cut off by the plot's frame, not moved up to it.
                let height = |value: f64| match scale {
                    RadialScale::Linear => value / curve.peak,
                    RadialScale::Logarithmic { decades } => {
                        (1.0 + (value / curve.peak).log10() / decades).max(-1.0)
                    }
                };
                let points: usize = curve.lines.iter().map(Vec::len).sum();
                assert!(points < 6000, "{text} {request:?}: {points}");
                for line in &curve.lines {
                    let (first, last) = (line[0].x_deg, line[line.len() - 1].x_deg);
                    // Places that no halving meets, and more of them where there are more points.
                    let even = (1..2000).map(|i| first + (last - first) * f64::from(i) / 2000.0);
                    let between = line.windows(2);
                    let between =
                        between.map(|pair| pair[0].x_deg + 0.37 * (pair[1].x_deg - pair[0].x_deg));
                    for x_deg in even.chain(between) {
                        let value = height(value_at(&subject, &request, x_deg)[0]);
                        let chord = chord_at(line, x_deg, height);
                        let gap = (value.max(0.0) - chord.max(0.0)).abs();
                        // Twice the tolerance: it is kept at the middle of each chord.
                        assert!(gap < 2e-3, "{text} {request:?} {x_deg}: {gap:e}");
                    }
                }
            }
        }
    }
}

#[test]
fn a_diffuse_surface_is_level_above_and_left_out_below() {
    let surface = surface("lambertian_reflection:reflectance=0.5/0.25/1");
    let subject = Subject::of(lobe(&*surface));
    let expected = [0.5, 0.25, 1.0].map(|x| x / PI);
    for abscissa in Abscissa::ALL {
        let curve = curve(&subject, &request(abscissa));
        let [line] = &curve.lines[..] else {
            panic!("{}", curve.lines.len())
        };
        let ends = match abscissa {
            Abscissa::Free => (-90.0, 90.0),
            Abscissa::Half | Abscissa::Difference => (0.0, END_DEG),
        };
        assert_eq!((line[0].x_deg, line[line.len() - 1].x_deg), ends);
        for point in line {
            let gaps = point.value.iter().zip(expected).map(|(a, b)| (a - b).abs());
            assert!(gaps.fold(0.0, f64::max) < 1e-15, "{point:?}");
        }
        assert!((curve.peak - 1.0 / PI).abs() < 1e-15);
    }
    let with_cosine = Request {
        with_cosine: true,
        ..request(Abscissa::Free)
    };
    for point in &curve(&subject, &with_cosine).lines[0] {
        let expected = 0.5 / PI * point.x_deg.to_radians().cos();
        assert!((point.value[0] - expected).abs() < 1e-15);
    }
}

#[test]
fn light_that_crosses_has_lines_of_its_own() {
    let surface = surface("lambertian_transmission:transmittance=0.5");
    let curve = curve(&Subject::of(lobe(&*surface)), &request(Abscissa::Free));
    let ends = |line: &Vec<Point>| (line[0].x_deg, line[line.len() - 1].x_deg);
    let lines: Vec<_> = curve.lines.iter().map(ends).collect();
    assert_eq!(lines, [(-180.0, -90.0), (-90.0, 90.0), (90.0, 180.0)]);
    let is_level = |line: &[Point], level: f64| {
        line.iter()
            .all(|point| (point.value[0] - level).abs() < 1e-15)
    };
    assert!(is_level(&curve.lines[0], 0.5 / PI) && is_level(&curve.lines[1], 0.0));
}

#[test]
fn over_the_half_angle_stands_the_density_of_normals() {
    // D of GGX in closed form; masking and the Fresnel factor are 1 for a narrow lobe seen from near n.
    let surface = surface("rough_conductor:fresnel=one,alpha=0.001");
    let subject = Subject::of(lobe(&*surface));
    let request = Request {
        fixed_deg: 10.0,
        ..request(Abscissa::Half)
    };
    let curve = curve(&subject, &request);
    let density = |theta: f64| {
        let tangent = theta.tan() / 0.001;
        1.0 / (PI * 1e-6 * theta.cos().powi(4) * (1.0 + tangent * tangent).powi(2))
    };
    let cos_d = 10.0_f64.to_radians().cos();
    assert!((curve.peak / (density(0.0) / (4.0 * cos_d * cos_d)) - 1.0).abs() < 1e-6);
    for point in &curve.lines[0] {
        let theta = point.x_deg.to_radians();
        let mu = theta.cos() * cos_d;
        let expected = density(theta) / (4.0 * mu * mu);
        let tolerance = if theta < 0.1 { 1e-5 } else { f64::INFINITY };
        assert!(
            (point.value[0] / expected - 1.0).abs() < tolerance,
            "{point:?}"
        );
    }
}

#[test]
fn residuals_are_differences_at_the_same_place() {
    let (narrow, broad) = (
        surface("ward:alpha=0.02"),
        surface("rough_conductor:alpha=0.3"),
    );
    let (narrow, broad) = (lobe(&*narrow), lobe(&*broad));
    let subject = Subject {
        against: Some(narrow),
        ..Subject::of(broad)
    };
    for abscissa in Abscissa::ALL {
        let request = Request {
            is_residual: true,
            with_cosine: true,
            ..request(abscissa)
        };
        let found = curve(&subject, &request);
        let plain = Request {
            is_residual: false,
            ..request
        };
        for point in found.lines.iter().flatten().step_by(7) {
            let values =
                [broad, narrow].map(|lobe| value_at(&Subject::of(lobe), &plain, point.x_deg)[1]);
            let gap = (point.value[1] - (values[0] - values[1])).abs();
            // The last points stand at a rounded angle.
            assert!(
                gap <= 1e-6 * found.peak,
                "{request:?} {point:?}: {values:?}"
            );
        }
        // The narrow lobe taken off is seen, though the other surface has no sample of it.
        let narrow_peak = curve(&Subject::of(narrow), &plain).peak;
        let lowest = found.lines.iter().flatten().map(|point| point.value[1]);
        let lowest = lowest.fold(f64::INFINITY, f64::min);
        assert!(abscissa == Abscissa::Difference || -lowest > 0.9 * narrow_peak);
        // With nothing to compare with, the value; with itself, nothing.
        assert_eq!(
            curve(&Subject::of(broad), &request),
            curve(&Subject::of(broad), &plain)
        );
        let itself = Subject {
            against: Some(broad),
            ..Subject::of(broad)
        };
        assert_eq!(curve(&itself, &request).peak, 0.0);
    }
}
