//! Microfacet lobes: F, D and G over the cosines.

use std::f64::consts::FRAC_1_PI;

use super::facets::{Distribution, Slopes, hidden};
use super::place::Place;
use super::term::Terms;
use bxdf::internals::{AnyFresnel, EnergyTable, FacetFresnel, Masking, fresnel};
use bxdf::param::ParamSet;

pub(super) const REFLECTED: &str = r"\frac{F\,D\,G}{4\,\light{\mu_i}\,\viewer{\mu_o}}";
const WITH_LOBE: &str = r"\frac{F\,D\,G}{4\,\light{\mu_i}\,\viewer{\mu_o}} + F_m\,\frac{(1 - \light{E_i})(1 - \viewer{E_o})}{\pi\,(1 - \bar{E})}";
const WITH_FACTOR: &str = r"\frac{F\,D\,G}{4\,\light{\mu_i}\,\viewer{\mu_o}} \left(1 + F_0\,\frac{1 - \viewer{E_o}}{\viewer{E_o}}\right)";

fn of_compensation(params: &ParamSet) -> &'static str {
    match params.choice("compensation") {
        "kulla_conty" => WITH_LOBE,
        "turquin" => WITH_FACTOR,
        _ => REFLECTED,
    }
}

pub(super) fn conductor(params: &ParamSet) -> Vec<&'static str> {
    vec![of_compensation(params)]
}

/// How the exact reflectance is computed.
pub(super) const EXACT: &str = r"\tfrac{1}{2}\left(|r_s|^2 + |r_p|^2\right)";

/// How a facet's reflectance is computed, by the word of the choice.
fn fresnel_formula(word: &str) -> &'static str {
    match word {
        "schlick" => r"F_0 + (1 - F_0)(1 - \half{h}\cdot\light{\omega_i})^5",
        "lazanyi" => {
            r"F_0 + (1 - F_0)(1 - c)^5 - b\,c\,(1 - c)^6,\quad c = \half{h}\cdot\light{\omega_i}"
        }
        "one" => "1",
        _ => EXACT,
    }
}

/// The parameters of a facet's reflectance, those that count.
fn metal(terms: &mut Terms<'_>, params: &ParamSet) {
    match params.choice("fresnel") {
        "schlick" => {
            terms.colour("f0", r"\param{f0}{F_0}");
        }
        "one" => {}
        _ => {
            terms.colour("eta", r"\param{eta}{\eta}");
            terms.colour("k", r"\param{k}{k}");
        }
    }
}

pub(super) fn conductor_terms<'a>(place: &Place<'a>) -> Option<Terms<'a>> {
    let pair = place.pair()?;
    let (params, mut terms) = (place.params, place.terms());
    metal(&mut terms, params);
    let slopes = Slopes::of(&mut terms);
    terms.cosines(&pair);
    terms.half(&pair);
    let facet = AnyFresnel::<f64>::from_params(params);
    let formula = fresnel_formula(params.choice("fresnel"));
    let f = terms.rgb(
        [
            "F",
            formula,
            "The reflectance of a facet at the half vector",
        ],
        facet.with_sine(pair.cos_d, || pair.sin2_d()),
    );
    let (distribution, is_separable) = hidden(params);
    let d = slopes.density(&mut terms, pair.h, distribution);
    let g = slopes.masking(&mut terms, [pair.wi, pair.wo], (distribution, is_separable));
    let single = f * (d * g / (4.0 * pair.mu_i() * pair.mu_o()));
    let whole = of_compensation(params);
    let is_lobe = match params.choice("compensation") {
        "kulla_conty" => true,
        "turquin" => false,
        _ => {
            terms.f(whole, single);
            return Some(terms);
        }
    };
    let [x, y] = slopes.widths;
    let table = EnergyTable::of(
        distribution != Distribution::Ggx,
        (x * y).sqrt(),
        Masking::from_params(params),
    );
    let lost_o = terms.number(
        [r"1 - \viewer{E_o}", "", "The share of light along the viewer's direction that one reflection loses: from a table"],
        table.one_minus_e(pair.mu_o()),
    );
    if is_lobe {
        let lost_i = terms.number(
            [
                r"1 - \light{E_i}",
                "",
                "The same along the light's: from a table",
            ],
            table.one_minus_e(pair.mu_i()),
        );
        let lost = terms.number(
            [
                r"1 - \bar{E}",
                "",
                "Their mean over all directions: from a table",
            ],
            table.one_minus_mean(),
        );
        let mean = terms.rgb(
            [
                r"\bar{F}",
                r"2\int_0^1 F(\mu)\,\mu\,d\mu",
                "The mean reflectance of a facet",
            ],
            facet.mean(),
        );
        let several = terms.rgb(
            [
                "F_m",
                r"\frac{\bar{F}^2\,\bar{E}}{1 - \bar{F}\,(1 - \bar{E})}",
                "The colour of light that meets several facets",
            ],
            mean.map(|f| f * f * (1.0 - lost) / (1.0 - f * lost)),
        );
        let scale = if lost > 0.0 {
            FRAC_1_PI * lost_i * lost_o / lost
        } else {
            0.0
        };
        terms.f(whole, single + several * scale);
    } else {
        let f0 = terms.rgb(
            ["F_0", "", "The reflectance of a facet at normal incidence"],
            facet.at(1.0),
        );
        terms.f(
            whole,
            single * f0.map(|f0| 1.0 + f0 * lost_o / (1.0 - lost_o)),
        );
    }
    Some(terms)
}

const GROOVES: &str = r"\min\left(1, \frac{2\,\half{h_n}\,\light{\mu_i}}{\half{h}\cdot\light{\omega_i}}, \frac{2\,\half{h_n}\,\viewer{\mu_o}}{\half{h}\cdot\light{\omega_i}}\right)";

pub(super) fn cook_torrance(_: &ParamSet) -> Vec<&'static str> {
    vec![REFLECTED]
}

pub(super) fn cook_torrance_terms<'a>(place: &Place<'a>) -> Option<Terms<'a>> {
    let pair = place.pair()?;
    let mut terms = place.terms();
    let f0 = terms.colour("f0", r"\param{f0}{F_0}");
    let m = terms.parameter("m", r"\param{m}{m}");
    terms.cosines(&pair);
    terms.half(&pair);
    let index = terms.rgb(
        [
            r"\eta",
            r"\frac{1 + \sqrt{\param{f0}{F_0}}}{1 - \sqrt{\param{f0}{F_0}}}",
            "The index that belongs to that reflectance at normal incidence",
        ],
        f0.map(|f0| (1.0 + f0.sqrt()) / (1.0 - f0.sqrt())),
    );
    let at = |f0: f64, eta: f64| match f0 {
        0.0 => 0.0,
        1.0 => 1.0,
        _ => {
            fresnel::dielectric_with_sine(
                pair.cos_d,
                pair.sin2_d(),
                fresnel::RelativeIndex::new(eta),
            )
            .reflectance
        }
    };
    let f = terms.rgb(
        ["F", EXACT, "The reflectance of a facet at the half vector"],
        f0.zip(index, at),
    );
    let slopes = Slopes { widths: [m; 2] };
    let d = terms.density(
        [
            "D",
            r"\frac{1}{\pi\,\param{m}{m}^2\,\half{h_n}^4} \exp\left(-\frac{1 - \half{h_n}^2}{\param{m}{m}^2\,\half{h_n}^2}\right)",
            "The density of microfacet normals at the half vector (Beckmann)",
        ],
        slopes.beckmann(pair.h),
    );
    let least = pair.mu_i().min(pair.mu_o());
    let g = terms.number(
        [
            "G",
            GROOVES,
            "The share of the grooves' sides that neither direction is masked from",
        ],
        (2.0 * pair.h.z * least / pair.cos_d).min(1.0),
    );
    terms.f(REFLECTED, f * (d * g / (4.0 * pair.mu_i() * pair.mu_o())));
    Some(terms)
}
