//! Rough interfaces of clear media: frosted glass, and a coat over a matt ground.

use std::f64::consts::FRAC_1_PI;

use super::facets::{Slopes, hidden};
use super::microfacet::{EXACT, REFLECTED};
use super::place::{Pair, Place};
use super::term::Terms;
use bxdf::Spectrum;
use bxdf::internals::{AnyInterface, Interface, fresnel};
use bxdf::param::ParamSet;

const REFRACTED: &str = r"\frac{(1 - F)\,D\,G\,|\half{h}\cdot\light{\omega_i}|\,|\half{h}\cdot\viewer{\omega_o}|}{|\light{\mu_i}|\,|\viewer{\mu_o}|\,|\viewer{\omega_o} + e\,\light{\omega_i}|^2}";

pub(super) fn dielectric(_: &ParamSet) -> Vec<&'static str> {
    vec![REFLECTED, REFRACTED]
}

/// How the reflectance of a clear interface is computed, by the word of the choice.
fn interface_formula(word: &str) -> &'static str {
    match word {
        "schlick" => r"F_0 + (1 - F_0)(1 - c)^5",
        "lazanyi" => r"F_0 + (1 - F_0)(1 - c)^5 - b\,c\,(1 - c)^6",
        _ => EXACT,
    }
}

pub(super) fn dielectric_terms<'a>(place: &Place<'a>) -> Option<Terms<'a>> {
    let (params, mut terms) = (place.params, place.terms());
    let eta = terms.parameter("eta", r"\param{eta}{\eta}");
    if eta == 1.0 {
        // No surface: light goes straight on, as a delta.
        place.is_across().then_some(())?;
        terms.weight("1", Spectrum::grey(1.0));
        return Some(terms);
    }
    let e = place.index_across(eta);
    if let Some(pair) = place.pair() {
        let f = mirrored(&mut terms, &pair, params, e);
        terms.f(REFLECTED, Spectrum::grey(f));
    } else {
        let f = crossing(&mut terms, place, e)?;
        terms.f(REFRACTED, Spectrum::grey(f));
    }
    Some(terms)
}

/// The lobe that clear facets reflect, `e` being the index across the surface over that on the side of the pair.
fn mirrored(terms: &mut Terms<'_>, pair: &Pair, params: &ParamSet, e: f64) -> f64 {
    let slopes = Slopes::of(terms);
    terms.cosines(pair);
    terms.half(pair);
    let interface = AnyInterface::<f64>::from_params(params);
    let index = fresnel::RelativeIndex::new(e);
    let formula = interface_formula(params.choice("fresnel"));
    let f = terms.number(
        [
            "F",
            formula,
            "The reflectance of a facet at the half vector",
        ],
        interface
            .with_sine(pair.cos_d, pair.sin2_d(), index)
            .reflectance,
    );
    let hidden = hidden(params);
    let d = slopes.density(terms, pair.h, hidden.0);
    let g = slopes.masking(terms, [pair.wi, pair.wo], hidden);
    f * d * g / (4.0 * pair.mu_i() * pair.mu_o())
}

/// The lobe that clear facets refract. `None` where no facet turns the one direction into the other.
fn crossing(terms: &mut Terms<'_>, place: &Place<'_>, e: f64) -> Option<f64> {
    let slopes = Slopes::of(terms);
    let (wo, wi) = (place.wo, place.wi);
    let sum = wo + wi * e;
    let h = sum.try_normalize()?;
    let h = if h.z < 0.0 { -h } else { h };
    let (cos_o, cos_i) = (wo.dot(h), -wi.dot(h));
    if cos_o <= 0.0 || cos_i <= 0.0 {
        return None;
    }
    let interface = AnyInterface::<f64>::from_params(place.params);
    terms.number(
        [
            r"\light{\mu_i}",
            r"\normal{n}\cdot\light{\omega_i}",
            "The cosine of the light, below 0 as it is on the other side",
        ],
        wi.z,
    );
    terms.number(
        [
            r"\viewer{\mu_o}",
            r"\normal{n}\cdot\viewer{\omega_o}",
            "The cosine of the viewer",
        ],
        wo.z,
    );
    terms.number(
        [
            "e",
            "",
            "The index on the light's side over that on the viewer's",
        ],
        e,
    );
    terms.number(
        [
            r"|\viewer{\omega_o} + e\,\light{\omega_i}|",
            "",
            "The length of the sum along which the facet's normal h lies",
        ],
        sum.length(),
    );
    terms.number(
        [
            r"|\half{h}\cdot\light{\omega_i}|",
            "",
            "The light's cosine with that normal",
        ],
        cos_i,
    );
    terms.number(
        [
            r"|\half{h}\cdot\viewer{\omega_o}|",
            "",
            "The viewer's cosine with it",
        ],
        cos_o,
    );
    let through = terms.number(
        ["1 - F", "", "The share that a facet lets through"],
        interface.transmittance_between(cos_o, cos_i, e),
    );
    let hidden = hidden(place.params);
    let d = slopes.density(terms, h, hidden.0);
    let g = slopes.masking(terms, [wi, wo], hidden);
    Some(through * d * g * cos_i * cos_o / (wi.z.abs() * wo.z * sum.length_squared()))
}

const GROUND: &str = r"\frac{\param{diffuse}{\rho}}{\pi}\,\frac{\light{T_i}\,\viewer{T_o}}{\param{eta}{\eta}^2\,(1 - d\,\bar{F}_{\mathrm{int}})}";
const COATED: &str = r"\frac{F\,D\,G}{4\,\light{\mu_i}\,\viewer{\mu_o}} + \frac{\param{diffuse}{\rho}}{\pi}\,\frac{\light{T_i}\,\viewer{T_o}}{\param{eta}{\eta}^2\,(1 - d\,\bar{F}_{\mathrm{int}})}";

fn of_coat(params: &ParamSet) -> &'static str {
    if params.number("alpha_x") > 0.0 {
        COATED
    } else {
        GROUND
    }
}

pub(super) fn plastic(params: &ParamSet) -> Vec<&'static str> {
    vec![of_coat(params)]
}

pub(super) fn plastic_terms<'a>(place: &Place<'a>) -> Option<Terms<'a>> {
    let pair = place.pair()?;
    let (params, mut terms) = (place.params, place.terms());
    let eta = terms.parameter("eta", r"\param{eta}{\eta}");
    let rho = terms.colour("diffuse", r"\param{diffuse}{\rho}");
    let interface = AnyInterface::<f64>::from_params(params);
    let index = fresnel::RelativeIndex::new(eta);
    let coat = coat(&mut terms, &pair, params, &interface);
    let through = |w: glam::DVec3| interface.along(w.into(), index).transmittance;
    let [light, viewer] = [
        terms.number(
            [
                r"\light{T_i}",
                r"1 - F(\light{\mu_i})",
                "The share of the light that crosses the coat on its way in",
            ],
            through(pair.wi),
        ),
        terms.number(
            [
                r"\viewer{T_o}",
                r"1 - F(\viewer{\mu_o})",
                "The share that crosses it on its way out",
            ],
            through(pair.wo),
        ),
    ];
    let inside = 1.0 - interface.diffuse_transmittance(eta) / (eta * eta);
    terms.number(
        [
            r"\bar{F}_{\mathrm{int}}",
            "",
            "The mean share that the coat reflects back to the ground",
        ],
        inside,
    );
    let d = if params.flag("nonlinear") {
        rho
    } else {
        Spectrum::grey(1.0)
    };
    let d = terms.rgb(["d", "", "What a bounce below the coat keeps: the ground's colour, or 1 where bounces do not saturate it"], d);
    let crossed = interface.diffuse_transmittance(eta);
    let ground = rho.zip(d, |rho, d| {
        rho * FRAC_1_PI / (eta * eta * (1.0 - d) + d * crossed)
    });
    terms.f(of_coat(params), coat + ground * (light * viewer));
    Some(terms)
}

/// The lobe of the coat, where it has one.
fn coat(
    terms: &mut Terms<'_>,
    pair: &Pair,
    params: &ParamSet,
    interface: &AnyInterface<f64>,
) -> Spectrum<f64> {
    if params.number("alpha_x") == 0.0 {
        terms.cosines(pair);
        let index = fresnel::RelativeIndex::new(params.number("eta"));
        terms.number(
            [
                "w",
                r"F(\viewer{\mu_o})",
                "The weight of the coat's mirror delta, which is no part of f",
            ],
            interface.along(pair.wo.into(), index).reflectance,
        );
        return Spectrum::black();
    }
    Spectrum::grey(mirrored(terms, pair, params, params.number("eta")))
}
