//! What a surface's value is made of: its lobes, and the factors of a microfacet model.

use super::cartesian::SECTION_LINES;
use super::deltas::{self, Stem};
use super::lobe::{HeldLobe, off_horizon};
use super::polar::{UNIFORM_STEP_DEG, direction, seed_angles};
use super::refine::{MIDDLE_AND_BESIDE, first_places, is_on_chord, peaks, refine};
use super::{Detail, IsWanted, Query, RadialScale, Subject};
use bxdf::{Lobe, Microfacet};

/// What a decomposition shows: curves over the free direction's signed angle in a section.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Request {
    /// The azimuth of the section's positive half, in radians.
    pub phi: f64,
    /// Whether the lobes' values are multiplied by |cos(theta)| of the free direction.
    pub with_cosine: bool,
}

impl Query for Request {
    type Answer = Decomposition;

    fn answer(&self, subject: &Subject<'_>, _: Detail, _: IsWanted<'_>) -> Option<Decomposition> {
        Some(decomposition(&subject.lobe, self))
    }
}

/// Curves on common angles, on which the chords of each leave it by at most a thousandth of its peak.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Decomposition {
    /// The signed angles from n in degrees, ascending: -90..90, or -180..180 where light crosses the surface. The
    /// horizon then stands there twice, with the limits from either side.
    pub angles_deg: Vec<f64>,
    /// Each of the surface's lobes, in their order; they sum to f.
    pub lobes: Vec<Part>,
    /// The factors of a microfacet model; `None` for other surfaces, and where there is no half vector at any angle.
    pub factors: Option<Factors>,
    /// The lobes that are Dirac deltas, over the same angle: they have no values.
    pub stems: Vec<Stem>,
}

/// One lobe's part of the value.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// The lobe.
    pub lobe: Lobe,
    /// Its f (times the cosine, if asked for) in 1/sr, per channel, at each angle.
    pub values: Vec<[f64; 3]>,
}

/// The factors of a microfacet model at each angle; 0 where they are not defined. See [`Microfacet`].
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Factors {
    /// The density of microfacet normals at the half vector, in 1/sr.
    pub d: Vec<f64>,
    /// Masking and shadowing together, 0..1.
    pub g: Vec<f64>,
    /// The Fresnel factor of a facet, per channel.
    pub fresnel: Vec<[f64; 3]>,
    /// Whether there is a half vector: curves break where there is none.
    pub is_defined: Vec<bool>,
}

/// The numbers that stand for a microfacet: whether it is defined, D, G, and the three of F.
const FACTORS: usize = 6;

/// The parts of `lobe` that `request` asks for.
#[must_use]
pub fn decomposition(lobe: &HeldLobe<'_>, request: &Request) -> Decomposition {
    let known = seed_angles(lobe, request.phi);
    let lines = SECTION_LINES.map(|([low, high], is_upper)| {
        let steps = ((high - low).to_degrees() / UNIFORM_STEP_DEG) as u32;
        let line = refine(
            first_places([low, high], steps, known.iter().copied()),
            &MIDDLE_AND_BESIDE,
            |angles| numbers_at(lobe, request, angles, is_upper),
            peaks,
            |peaks, points| is_on_chord(RadialScale::Linear, peaks, points),
        );
        (line, is_upper)
    });
    // Light that crosses the surface has a line to either side of the horizon.
    let crosses = lines
        .iter()
        .any(|(line, is_upper)| !is_upper && peaks(line).is_some());
    let points: Vec<_> = lines
        .into_iter()
        .filter(|(_, is_upper)| *is_upper || crosses)
        .flat_map(|(line, _)| line)
        .collect();
    let triples = |first: usize| -> Vec<[f64; 3]> {
        let triple = |numbers: &Vec<f64>| numbers.get(first..)?.first_chunk().copied();
        let all = points.iter().map(|(_, numbers)| triple(numbers));
        all.map(Option::unwrap_or_default).collect()
    };
    let parts = lobe.lobes().iter().enumerate().map(|(index, part)| Part {
        lobe: *part,
        values: triples(FACTORS + 3 * index),
    });
    let (mut factors, fresnel) = (Factors::default(), triples(3));
    for ([is_defined, d, g], fresnel) in triples(0).into_iter().zip(fresnel) {
        factors.is_defined.push(is_defined > 0.0);
        factors.d.push(d);
        factors.g.push(g);
        factors.fresnel.push(fresnel);
    }
    let has_factors = factors.is_defined.contains(&true);
    Decomposition {
        angles_deg: points.iter().map(|(angle, _)| angle.to_degrees()).collect(),
        lobes: parts.collect(),
        factors: has_factors.then_some(factors),
        stems: deltas::in_section(&lobe.arrows(), request.phi),
    }
}

/// All numbers of the curves at each of `angles`: those of the microfacet, then three of each lobe.
fn numbers_at(
    lobe: &HeldLobe<'_>,
    request: &Request,
    angles: &[f64],
    is_upper: bool,
) -> Vec<Vec<f64>> {
    let free: Vec<_> = angles
        .iter()
        .map(|angle| direction(*angle, request.phi))
        .collect();
    let lifted: Vec<_> = free.iter().map(|w| off_horizon(*w, is_upper)).collect();
    let microfacet = |w| {
        let (wo, wi) = lobe.pair(w);
        match lobe.surface().microfacet(wo.into(), wi.into()) {
            Some(Microfacet { d, g, fresnel }) => {
                let [red, green, blue] = fresnel.to_f64();
                vec![1.0, d, g, red, green, blue]
            }
            None => vec![0.0; FACTORS],
        }
    };
    let mut numbers: Vec<Vec<f64>> = lifted.iter().copied().map(microfacet).collect();
    for index in 0..lobe.lobes().len() {
        let values = lobe.lobe_values(index, &lifted);
        for ((numbers, value), w) in numbers.iter_mut().zip(values).zip(&free) {
            let cosine = if request.with_cosine { w.z.abs() } else { 1.0 };
            numbers.extend(value.map(|x| x * cosine));
        }
    }
    numbers
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::Hold;
    use bxdf::math::frame::direction_from_degrees;
    use bxdf::{Material, Scatterer};

    const HELD_DEG: f64 = 50.0;

    fn found(text: &str, with_cosine: bool) -> (Box<dyn Scatterer<f64>>, Decomposition) {
        let surface = text.parse::<Material>().unwrap().build();
        let lobe = HeldLobe::new(
            &*surface,
            Hold::Light,
            direction_from_degrees(HELD_DEG, 0.0),
        );
        let request = Request {
            phi: 0.0,
            with_cosine,
        };
        let found = decomposition(&lobe, &request);
        (surface, found)
    }

    #[test]
    fn the_lobes_sum_to_the_value() {
        for text in [
            "plastic:alpha=0.05",
            "principled:clearcoat=1,sheen=1",
            "rough_dielectric:alpha=0.1",
            "hapke",
            "retro_reflector:alpha=0.0005",
        ] {
            for with_cosine in [false, true] {
                let (surface, found) = found(text, with_cosine);
                let lobe = HeldLobe::new(
                    &*surface,
                    Hold::Light,
                    direction_from_degrees(HELD_DEG, 0.0),
                );
                assert_eq!(found.lobes.len(), surface.lobes().len());
                assert!(
                    found
                        .lobes
                        .iter()
                        .all(|part| part.values.len() == found.angles_deg.len())
                );
                assert!(found.angles_deg.is_sorted() && found.angles_deg.len() < 8000);
                let at_horizon = |angle: &&f64| angle.abs() == 90.0;
                let crosses = found.angles_deg[0] == -180.0;
                let ends = found.angles_deg.iter().filter(at_horizon).count();
                assert_eq!(ends, if crosses { 4 } else { 2 });
                assert_eq!(crosses, text.starts_with("rough_dielectric"), "{text}");
                for (index, angle) in found.angles_deg.iter().enumerate() {
                    if angle.abs() == 90.0 {
                        continue;
                    }
                    let free = direction(angle.to_radians(), 0.0);
                    let cosine = if with_cosine { free.z.abs() } else { 1.0 };
                    let expected = lobe.value_or_limit(free, free.z > 0.0)[1] * cosine;
                    let sum: f64 = found.lobes.iter().map(|part| part.values[index][1]).sum();
                    // An angle in degrees is rounded, which the steep sides of a lobe magnify.
                    let gap = (sum - expected).abs();
                    assert!(gap <= 1e-6 * expected, "{text} {angle}: {sum} {expected}");
                }
            }
        }
    }

    #[test]
    fn the_factors_make_up_a_conductor() {
        let (_, found) = found("rough_conductor:alpha=0.2", false);
        let factors = found.factors.unwrap();
        let mu_i = HELD_DEG.to_radians().cos();
        for (index, angle) in found.angles_deg.iter().enumerate() {
            assert!(factors.is_defined[index]);
            if angle.abs() < 89.9 {
                let product = factors.d[index] * factors.g[index] * factors.fresnel[index][0];
                let expected = product / (4.0 * mu_i * angle.to_radians().cos());
                let value = found.lobes[0].values[index][0];
                assert!(
                    (value / expected - 1.0).abs() < 1e-10,
                    "{angle}: {value} {expected}"
                );
            }
        }
        // The half vector is n in the mirror direction: D = 1/(pi alpha^2), its largest value.
        let peak = factors.d.iter().copied().fold(0.0, f64::max);
        assert!(
            (peak * std::f64::consts::PI * 0.04 - 1.0).abs() < 1e-9,
            "{peak}"
        );
    }

    #[test]
    fn a_surface_without_facets_has_no_factors_and_one_of_deltas_no_lobes() {
        let (_, diffuse) = found("lambertian_reflection:reflectance=1", false);
        assert_eq!(diffuse.factors, None);
        let level = std::f64::consts::FRAC_1_PI;
        assert!(
            diffuse.lobes[0]
                .values
                .iter()
                .all(|f| (f[2] - level).abs() < 1e-15)
        );
        let (_, mirror) = found("specular_reflection", false);
        assert!(mirror.lobes.is_empty() && mirror.factors.is_none());
    }

    #[test]
    fn curves_break_where_there_is_no_half_vector() {
        let (_, found) = found("rough_dielectric:alpha=0.1", false);
        let factors = found.factors.unwrap();
        let numbers = factors
            .d
            .iter()
            .chain(&factors.g)
            .chain(factors.fresnel.as_flattened());
        assert!(numbers.into_iter().all(|x| x.is_finite()));
        for (index, angle) in found.angles_deg.iter().enumerate() {
            let is_zero = found
                .lobes
                .iter()
                .all(|part| part.values[index] == [0.0; 3]);
            assert!(factors.is_defined[index] || is_zero, "{angle}");
        }
    }
}
