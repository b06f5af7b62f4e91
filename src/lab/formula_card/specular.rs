//! Dirac deltas: their weights stand where f would.

use super::microfacet::EXACT;
use super::place::Place;
use super::term::Terms;
use bxdf::Spectrum;
use bxdf::internals::{Conductor, fresnel};
use bxdf::param::ParamSet;

const MIRROR: &str = r"\param{reflectance}{\rho}\,F";

pub(super) fn mirror(_: &ParamSet) -> Vec<&'static str> {
    vec![MIRROR]
}

fn viewer_cosine(terms: &mut Terms<'_>, place: &Place<'_>) {
    terms.number(
        [
            r"\viewer{\mu_o}",
            r"\normal{n}\cdot\viewer{\omega_o}",
            "The cosine of the angle from n to the viewer, and to the delta's light",
        ],
        place.wo.z,
    );
}

pub(super) fn mirror_terms<'a>(place: &Place<'a>) -> Option<Terms<'a>> {
    if place.is_across() {
        return None;
    }
    let (params, mut terms) = (place.params, place.terms());
    let rho = terms.colour("reflectance", r"\param{reflectance}{\rho}");
    let cos = place.wo.z;
    let mut metal = |with_k: bool| {
        let eta = terms.colour("eta", r"\param{eta}{\eta}");
        let k = if with_k {
            terms.colour("k", r"\param{k}{k}")
        } else {
            Spectrum::black()
        };
        (eta, k)
    };
    let (formula, share) = match params.choice("fresnel") {
        "dielectric" => {
            let (eta, _) = metal(false);
            (
                EXACT,
                eta.map(|eta| fresnel::dielectric(cos, eta).reflectance),
            )
        }
        "conductor" => {
            let (eta, k) = metal(true);
            (EXACT, Spectrum(Conductor::new(eta.0, k.0).reflectance(cos)))
        }
        _ => ("1", Spectrum::grey(1.0)),
    };
    viewer_cosine(&mut terms, place);
    let share = terms.rgb(["F", formula, "The reflectance of the surface"], share);
    terms.weight(MIRROR, rho * share);
    Some(terms)
}

const REFRACTED: &str = r"\frac{\param{transmittance}{\tau}}{e^2}";

pub(super) fn refracted(_: &ParamSet) -> Vec<&'static str> {
    vec![REFRACTED]
}

/// The index on the light's side over that on the viewer's, as a term.
fn index(terms: &mut Terms<'_>, place: &Place<'_>) -> f64 {
    let eta = terms.parameter("eta", r"\param{eta}{\eta}");
    terms.number(
        [
            "e",
            r"\param{eta}{\eta}\ \text{or}\ 1/\param{eta}{\eta}",
            "The index on the far side over that on the viewer's",
        ],
        place.index_across(eta),
    )
}

pub(super) fn refracted_terms<'a>(place: &Place<'a>) -> Option<Terms<'a>> {
    let mut terms = place.is_across().then(|| place.terms())?;
    let tau = terms.colour("transmittance", r"\param{transmittance}{\tau}");
    let e = index(&mut terms, place);
    if fresnel::dielectric_along(place.wo.into(), e).cos_t == 0.0 {
        return None;
    }
    terms.weight(REFRACTED, tau * (1.0 / (e * e)));
    Some(terms)
}

const SHARED: [&str; 2] = ["F", r"\frac{1 - F}{e^2}"];

pub(super) fn interface(_: &ParamSet) -> Vec<&'static str> {
    SHARED.to_vec()
}

pub(super) fn interface_terms<'a>(place: &Place<'a>) -> Option<Terms<'a>> {
    let mut terms = place.terms();
    let e = index(&mut terms, place);
    viewer_cosine(&mut terms, place);
    let share = fresnel::dielectric_along(place.wo.into(), e);
    terms.number(
        ["F", EXACT, "The reflectance of the surface"],
        share.reflectance,
    );
    let [reflected, transmitted] = SHARED;
    if !place.is_across() {
        terms.weight(reflected, Spectrum::grey(share.reflectance));
    } else if share.transmittance > 0.0 {
        terms.weight(transmitted, Spectrum::grey(share.transmittance / (e * e)));
    } else {
        return None;
    }
    Some(terms)
}

const SLAB: [&str; 2] = [r"\frac{2\,F}{1 + F}", r"\frac{1 - F}{1 + F}"];

pub(super) fn slab(_: &ParamSet) -> Vec<&'static str> {
    SLAB.to_vec()
}

pub(super) fn slab_terms<'a>(place: &Place<'a>) -> Option<Terms<'a>> {
    let mut terms = place.terms();
    let eta = terms.parameter("eta", r"\param{eta}{\eta}");
    viewer_cosine(&mut terms, place);
    let face = fresnel::dielectric_along(place.wo.into(), eta);
    let f = terms.number(
        ["F", EXACT, "The reflectance of one of the two faces"],
        face.reflectance,
    );
    let [reflected, transmitted] = SLAB;
    if place.is_across() {
        // Beyond the critical angle of a film of air nothing crosses.
        (face.transmittance > 0.0).then_some(())?;
        terms.weight(transmitted, Spectrum::grey(face.transmittance / (1.0 + f)));
    } else {
        terms.weight(reflected, Spectrum::grey(2.0 * f / (1.0 + f)));
    }
    Some(terms)
}
