use super::*;
use crate::analysis::statistics::Random;
use bxdf::models::MODELS;
use bxdf::param::{Kind, ParamSpec, Scale, Value as Parameter};
use bxdf::{Material, ModelSpec, Side};

/// A value by chance in the range of the slider.
fn chosen(spec: &ParamSpec, random: &mut Random) -> Parameter {
    let [low, high] = spec.soft;
    let mut number = || {
        let place = random.unit();
        if spec.scale == Scale::Logarithmic {
            low.max(1e-3) * (high / low.max(1e-3)).powf(place)
        } else {
            low + (high - low) * place
        }
    };
    match spec.kind {
        Kind::Number => Parameter::Number(number()),
        Kind::Rgb => Parameter::Rgb([number(), number(), number()]),
        Kind::Choice => {
            let index = (number() * spec.choices.len() as f64) as usize;
            Parameter::Choice(spec.choices[index.min(spec.choices.len() - 1)])
        }
        Kind::Bool => Parameter::Bool(number() < 0.5),
        Kind::Data => spec.default,
    }
}

fn params(model: &ModelSpec, random: &mut Random) -> Option<ParamSet> {
    let mut set = model.defaults();
    for spec in model.parameters {
        set.set(spec.name, chosen(spec, random)).ok()?;
    }
    (model.validate)(&set).ok().map(|()| set)
}

/// Two directions by chance, the second often where lobes are: about the mirror direction or that back.
fn pair(random: &mut Random) -> (DVec3, DVec3) {
    let wo = random.direction();
    let near = match (random.unit() * 4.0) as u32 {
        0 => DVec3::new(-wo.x, -wo.y, wo.z),
        1 => wo,
        2 => -wo,
        _ => return (wo, random.direction()),
    };
    let wi = (near + random.direction() * 0.3).try_normalize().unwrap();
    (wo, wi)
}

/// How much the weight of the delta of `wo` to the side of `wi` is; `None` where there is none.
fn delta(surface: &dyn bxdf::Scatterer<f64>, wo: DVec3, wi: DVec3) -> Option<[f64; 3]> {
    let side = if wo.z * wi.z > 0.0 {
        Side::Reflection
    } else {
        Side::Transmission
    };
    let mut deltas = surface.deltas(wo.into()).into_iter().flatten();
    deltas
        .find(|delta| delta.side == side)
        .map(|delta| delta.weight.to_f64())
}

#[test]
fn every_model_has_a_card_in_its_order() {
    assert!(
        MODELS
            .iter()
            .map(|model| model.id)
            .eq(CARDS.iter().map(|card| card.id))
    );
}

#[test]
fn the_terms_of_every_card_lead_to_the_model_s_own_value() {
    for (card, model) in CARDS.iter().zip(MODELS) {
        let mut random = Random::new(7);
        let mut lit = 0;
        for _ in 0..150 {
            let Some(params) = params(model, &mut random) else {
                continue;
            };
            let surface = model.build::<f64>(&params);
            for _ in 0..40 {
                let (wo, wi) = pair(&mut random);
                let terms = card.terms(&params, wo, wi);
                let expected = if model.is_delta_only() {
                    delta(&*surface, wo, wi).unwrap_or_default()
                } else {
                    surface.f(wo.into(), wi.into()).to_f64()
                };
                let Some(last) = terms.last() else {
                    assert_eq!(expected, [0.0; 3], "{}:{params} {wo:?} {wi:?}", card.id);
                    continue;
                };
                lit += 1;
                for (found, expected) in last.worth.channels().into_iter().zip(expected) {
                    let error = (found - expected).abs() / expected.max(1e-30);
                    assert!(
                        error < 1e-11,
                        "{}:{params} {wo:?} {wi:?}: {found} for {expected}",
                        card.id
                    );
                }
            }
        }
        assert!(lit > 300, "{}: {lit}", card.id);
    }
}

#[test]
fn terms_have_names_and_every_section_is_there() {
    let (wo, wi) = (DVec3::new(0.6, 0.0, 0.8), DVec3::new(-0.48, 0.36, 0.8));
    for (card, model) in CARDS.iter().zip(MODELS) {
        let params = model.defaults();
        let formulas = card.formulas(&params);
        for wi in [wi, -wi] {
            let terms = card.terms(&params, wo, wi);
            for term in &terms {
                assert!(
                    !term.symbol.is_empty() && !term.meaning.is_empty(),
                    "{}",
                    card.id
                );
                assert!(
                    !term.meaning.ends_with('.'),
                    "{}: {}",
                    card.id,
                    term.meaning
                );
            }
            let whole = terms.last().map(|last| last.formula);
            assert!(
                whole.is_none_or(|whole| formulas.contains(&whole)),
                "{}",
                card.id
            );
        }
        let said = card.documentation();
        for section in [&said.source, &said.departures, &said.validity] {
            assert!(!section.is_empty(), "{}", card.id);
            assert!(
                section
                    .iter()
                    .all(|text| !text.contains('`') && !text.contains("//")),
                "{}",
                card.id
            );
        }
    }
}

#[test]
fn a_turned_surface_is_read_in_its_own_frame() {
    let brushed: Material = "rough_conductor:alpha_x=.1,alpha_y=.5".parse().unwrap();
    let (wo, wi) = (DVec3::new(0.6, 0.0, 0.8), DVec3::new(-0.48, 0.36, 0.8));
    let turned = Reading::of(&brushed.components()[0], 30.0, wo, wi).unwrap();
    let surface = bxdf::Rotated::new(brushed.build::<f64>(), cos_sin_deg(30.0));
    let expected = bxdf::Bxdf::f(&surface, wo.into(), wi.into()).to_f64();
    let found = turned.terms.last().unwrap().worth.channels();
    for (found, expected) in found.into_iter().zip(expected) {
        assert!((found / expected - 1.0).abs() < 1e-12);
    }
}

#[test]
fn conventions_are_those_of_their_definitions() {
    let glass: Material = "rough_dielectric:eta=1.5".parse().unwrap();
    let (wo, wi) = (
        DVec3::new(0.6, 0.0, 0.8),
        DVec3::new(-0.3, 0.1, -0.9).try_normalize().unwrap(),
    );
    let reading = Reading::of(&glass.components()[0], 0.0, wo, wi).unwrap();
    let first = |index: usize| reading.conventions[index].rgb[0];
    let f = glass.build::<f64>().f(wo.into(), wi.into()).to_f64()[0];
    assert!((first(0) / f - 1.0).abs() < 1e-12);
    assert!((first(1) / (f * wi.z.abs()) - 1.0).abs() < 1e-12);
    // Reciprocity across the surface: n_i^2 f(wo, wi) = n_o^2 f(wi, wo).
    assert!(
        (first(2) / (2.25 * f) - 1.0).abs() < 1e-12,
        "{}",
        first(2) / f
    );
    assert!((first(3) / (2.25 * f) - 1.0).abs() < 1e-12);
    assert!((first(4) / (std::f64::consts::PI * f) - 1.0).abs() < 1e-12);
}

#[test]
fn the_ends_of_the_ranges_have_their_own_words() {
    let reading = |text: &str, wo: DVec3, wi: DVec3| {
        let material: Material = text.parse().unwrap();
        let reading = Reading::of(&material.components()[0], 0.0, wo, wi).unwrap();
        (
            reading,
            material.build::<f64>().f(wo.into(), wi.into()).to_f64(),
        )
    };
    let (wo, wi) = (DVec3::new(0.6, 0.0, 0.8), DVec3::new(-0.48, 0.36, 0.8));
    for text in [
        "plastic:alpha=0",
        "plastic:alpha=0,nonlinear=false,fresnel=lazanyi",
        "cook_torrance:f0=0",
        "cook_torrance:f0=1",
        "eon:roughness=0",
        "velvet:alpha=.01",
        "hapke:single_scattering_albedo=1",
    ] {
        for (wo, wi) in [(wo, wi), (-wo, -wi), (DVec3::Z, DVec3::Z), (wo, wo)] {
            let (found, f) = reading(text, wo, wi);
            let last = found.terms.last().unwrap().worth.channels();
            for (found, f) in last.into_iter().zip(f) {
                assert!(
                    (found - f).abs() <= 1e-11 * f,
                    "{text} {wo:?}: {found} for {f}"
                );
            }
            assert!(!found.is_delta);
        }
        assert!(reading(text, wo, -wi).0.terms.is_empty(), "{text}");
    }
    // The weight of the mirror of a smooth coat stands apart.
    let (smooth, _) = reading("plastic:alpha=0", wo, wi);
    let delta = smooth.terms.iter().find(|term| term.symbol == "w").unwrap();
    let surface = "plastic:alpha=0"
        .parse::<Material>()
        .unwrap()
        .build::<f64>();
    let [Some(mirror), None] = surface.deltas(wo.into()) else {
        panic!("a mirror")
    };
    assert_eq!(delta.worth.channels(), mirror.weight.to_f64());
    // Where there is no surface, all goes straight on.
    let (nothing, _) = reading("rough_dielectric:eta=1", wo, -wo);
    assert!(nothing.is_delta && nothing.terms.last().unwrap().worth.channels() == [1.0; 3]);
}
