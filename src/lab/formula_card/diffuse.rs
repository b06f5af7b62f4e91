//! Diffuse lobes.

use super::place::Place;
use super::term::Terms;
use bxdf::internals::{eon_loss, fresnel};
use bxdf::param::ParamSet;
use std::f64::consts::{FRAC_1_PI, PI};

const REFLECTANCE: &str = r"\param{reflectance}{\rho}";

pub(super) fn lambert(_: &ParamSet) -> Vec<&'static str> {
    vec![LAMBERT]
}

const LAMBERT: &str = r"\frac{\param{reflectance}{\rho}}{\pi}";

pub(super) fn lambert_terms<'a>(place: &Place<'a>) -> Option<Terms<'a>> {
    place.pair()?;
    let mut terms = place.terms();
    let rho = terms.colour("reflectance", REFLECTANCE);
    terms.f(LAMBERT, rho * FRAC_1_PI);
    Some(terms)
}

const TRANSMITTED: &str = r"\frac{\param{transmittance}{\tau}}{\pi}";

pub(super) fn transmitted(_: &ParamSet) -> Vec<&'static str> {
    vec![TRANSMITTED]
}

pub(super) fn transmitted_terms<'a>(place: &Place<'a>) -> Option<Terms<'a>> {
    let mut terms = place.is_across().then(|| place.terms())?;
    let tau = terms.colour("transmittance", r"\param{transmittance}{\tau}");
    terms.f(TRANSMITTED, tau * FRAC_1_PI);
    Some(terms)
}

const OREN_NAYAR: &str = r"\frac{\param{reflectance}{\rho}}{\pi} \left( A + B\,\frac{\max(0, s)}{\max(\light{\mu_i}, \viewer{\mu_o})} \right)";

pub(super) fn oren_nayar(_: &ParamSet) -> Vec<&'static str> {
    vec![OREN_NAYAR]
}

pub(super) fn oren_nayar_terms<'a>(place: &Place<'a>) -> Option<Terms<'a>> {
    let pair = place.pair()?;
    let mut terms = place.terms();
    let rho = terms.colour("reflectance", REFLECTANCE);
    let sigma = terms
        .parameter("sigma", r"\param{sigma}{\sigma}")
        .to_radians();
    terms.cosines(&pair);
    let s = terms.number(PLANE, pair.wi.truncate().dot(pair.wo.truncate()));
    let sigma2 = sigma * sigma;
    let a = terms.number(
        [
            "A",
            r"1 - 0.5\,\frac{\param{sigma}{\sigma}^2}{\param{sigma}{\sigma}^2 + 0.33}",
            "The part that is the same all around, sigma in radians",
        ],
        1.0 - 0.5 * sigma2 / (sigma2 + 0.33),
    );
    let b = terms.number(
        [
            "B",
            r"0.45\,\frac{\param{sigma}{\sigma}^2}{\param{sigma}{\sigma}^2 + 0.09}",
            "The part that bulges towards the light",
        ],
        0.45 * sigma2 / (sigma2 + 0.09),
    );
    let bulge = s.max(0.0) / pair.mu_i().max(pair.mu_o());
    terms.f(OREN_NAYAR, rho * ((a + b * bulge) * FRAC_1_PI));
    Some(terms)
}

/// The name of the product of both directions in the plane of the surface.
const PLANE: [&str; 3] = [
    "s",
    r"\light{\omega_i}\cdot\viewer{\omega_o} - \light{\mu_i}\,\viewer{\mu_o}",
    "The product of both directions in the plane of the surface: above 0 where they lean to one side",
];

const EON: &str = r"\frac{\param{reflectance}{\rho}\,A}{\pi} \left( 1 + \param{roughness}{r}\,\frac{s}{t} \right) + \frac{\rho_m}{\pi}\,\frac{(1 - \light{E_i})(1 - \viewer{E_o})}{1 - \bar{E}}";

pub(super) fn eon(_: &ParamSet) -> Vec<&'static str> {
    vec![EON]
}

pub(super) fn eon_terms<'a>(place: &Place<'a>) -> Option<Terms<'a>> {
    let pair = place.pair()?;
    let mut terms = place.terms();
    let rho = terms.colour("reflectance", REFLECTANCE);
    let r = terms.parameter("roughness", r"\param{roughness}{r}");
    terms.cosines(&pair);
    let s = terms.number(PLANE, pair.wi.truncate().dot(pair.wo.truncate()));
    let t = if s > 0.0 {
        pair.mu_i().max(pair.mu_o())
    } else {
        1.0
    };
    terms.number(
        [
            "t",
            r"\max(\light{\mu_i}, \viewer{\mu_o})",
            "What the product is divided by; 1 where it is below 0",
        ],
        t,
    );
    let a = terms.number(
        ["A", r"\left(1 + \left(\tfrac{1}{2} - \tfrac{2}{3\pi}\right) \param{roughness}{r}\right)^{-1}", "What the first bounce is divided by"],
        1.0 / (1.0 + (0.5 - 2.0 / (3.0 * PI)) * r),
    );
    let lost_of = |w: glam::DVec3| a * r * eon_loss::<f64>(w.into()) * FRAC_1_PI;
    let lost_i = terms.number(
        [r"1 - \light{E_i}", "", "The share of the light along the light's direction that one bounce leaves inside, at reflectance 1"],
        lost_of(pair.wi),
    );
    let lost_o = terms.number(
        [
            r"1 - \viewer{E_o}",
            "",
            "The same along the viewer's direction",
        ],
        lost_of(pair.wo),
    );
    let mean_lost = terms.number(
        [
            r"1 - \bar{E}",
            r"A\,\param{roughness}{r} \left(\tfrac{6}{5\pi} - \tfrac{1}{6}\right)",
            "Their mean over all directions",
        ],
        a * r * (6.0 / (5.0 * PI) - 1.0 / 6.0),
    );
    let rho_m = terms.rgb(
        [r"\rho_m", r"\frac{\param{reflectance}{\rho}^2\,\bar{E}}{1 - \param{reflectance}{\rho}\,(1 - \bar{E})}", "What is reflected after several bounces"],
        rho.map(|rho| rho * rho * (1.0 - mean_lost) / (1.0 - rho * mean_lost)),
    );
    let single = (1.0 + r * s / t).max(0.0) * a * FRAC_1_PI;
    let several = if mean_lost > 0.0 {
        lost_i * lost_o / mean_lost * FRAC_1_PI
    } else {
        0.0
    };
    terms.f(EON, rho * single + rho_m * several);
    Some(terms)
}

const BURLEY: &str = r"\frac{\param{reflectance}{\rho}}{\pi} \left(1 + (F_{90} - 1)(1 - \light{\mu_i})^5\right) \left(1 + (F_{90} - 1)(1 - \viewer{\mu_o})^5\right)";

pub(super) fn burley(_: &ParamSet) -> Vec<&'static str> {
    vec![BURLEY]
}

pub(super) fn burley_terms<'a>(place: &Place<'a>) -> Option<Terms<'a>> {
    let pair = place.pair()?;
    let mut terms = place.terms();
    let rho = terms.colour("reflectance", REFLECTANCE);
    let r = terms.parameter("roughness", r"\param{roughness}{r}");
    terms.cosines(&pair);
    terms.cos_d(&pair);
    let f90 = terms.number(F90, 0.5 + 2.0 * r * pair.cos_d * pair.cos_d);
    let [i, o] =
        [pair.mu_i(), pair.mu_o()].map(|mu| 1.0 + (f90 - 1.0) * fresnel::schlick_weight(mu));
    terms.f(BURLEY, rho * (i * o * FRAC_1_PI));
    Some(terms)
}

/// The name of the factor that a diffuse lobe has at grazing angles.
pub(super) const F90: [&str; 3] = [
    r"F_{90}",
    r"\tfrac{1}{2} + 2\,\param{roughness}{r}\,(\half{h}\cdot\light{\omega_i})^2",
    "The factor at grazing angles",
];
