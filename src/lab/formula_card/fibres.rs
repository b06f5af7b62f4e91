//! Lobes of cloth and of soil: fibres that stand upright, grains that hide their own shadows.

use std::f64::consts::{FRAC_1_PI, PI, TAU};

use super::place::Place;
use super::term::Terms;
use bxdf::Spectrum;
use bxdf::param::ParamSet;

const VELVET: &str = r"\param{reflectance}{\rho}\,\frac{D}{4\,(\light{\mu_i} + \viewer{\mu_o} - \light{\mu_i}\,\viewer{\mu_o})}";

pub(super) fn velvet(_: &ParamSet) -> Vec<&'static str> {
    vec![VELVET]
}

pub(super) fn velvet_terms<'a>(place: &Place<'a>) -> Option<Terms<'a>> {
    let pair = place.pair()?;
    let mut terms = place.terms();
    let rho = terms.colour("reflectance", r"\param{reflectance}{\rho}");
    let alpha = terms.parameter("alpha", r"\param{alpha}{\alpha}");
    terms.cosines(&pair);
    let sin2 = pair.h.truncate().length_squared();
    terms.number(SINE, sin2.sqrt());
    let rise = (-(pair.h.z / alpha).powi(2) / sin2).exp();
    let rise = if rise > 0.0 {
        rise / (sin2 * sin2)
    } else {
        0.0
    };
    let d = terms.density(
        [
            "D",
            r"\frac{1 + 4 \exp(-\cot^2\theta_h / \param{alpha}{\alpha}^2) / \sin^4\theta_h}{\pi\,(1 + 4\,\param{alpha}{\alpha}^2)}",
            "The density of the fibres at the half vector",
        ],
        (1.0 + 4.0 * rise) / (PI * (1.0 + 4.0 * alpha * alpha)),
    );
    let denominator = 4.0 * (pair.mu_i() + pair.mu_o() - pair.mu_i() * pair.mu_o());
    terms.f(VELVET, rho * (d / denominator));
    Some(terms)
}

const SINE: [&str; 3] = [
    r"\sin\theta_h",
    "",
    "The sine of the angle from n to the half vector",
];

const CHARLIE: &str = r"\param{reflectance}{\rho}\,\frac{D\,G}{4\,\light{\mu_i}\,\viewer{\mu_o}}";

pub(super) fn charlie(_: &ParamSet) -> Vec<&'static str> {
    vec![CHARLIE]
}

/// The fit of Lambda, L = a / (1 + b x^c) + d x + e, at roughness 0 and at 1: a, b, c, d, e.
const FIT: [[f64; 5]; 2] = [
    [25.3245, 3.32435, 0.16801, -1.27393, -4.85967],
    [21.5473, 3.82987, 0.19823, -1.97760, -4.32054],
];

fn fitted(roughness: f64, x: f64) -> f64 {
    let [smooth, rough] = FIT;
    let share = (1.0 - roughness).powi(2);
    let mut mixed = rough;
    for (value, smooth) in mixed.iter_mut().zip(smooth) {
        *value += share * (smooth - *value);
    }
    let [a, b, c, d, e] = mixed;
    a / (1.0 + b * x.powf(c)) + d * x + e
}

fn lambda(roughness: f64, mu: f64) -> f64 {
    if mu < 0.5 {
        fitted(roughness, mu).exp()
    } else {
        (2.0 * fitted(roughness, 0.5) - fitted(roughness, 1.0 - mu)).exp()
    }
}

pub(super) fn charlie_terms<'a>(place: &Place<'a>) -> Option<Terms<'a>> {
    let pair = place.pair()?;
    let mut terms = place.terms();
    let rho = terms.colour("reflectance", r"\param{reflectance}{\rho}");
    let r = terms.parameter("roughness", r"\param{roughness}{r}");
    terms.cosines(&pair);
    let sin = terms.number(SINE, pair.h.truncate().length());
    let d = terms.density(
        [
            "D",
            r"\frac{(2 + 1/\param{roughness}{r})\,(\sin\theta_h)^{1/\param{roughness}{r}}}{2\pi}",
            "The density of the fibres at the half vector",
        ],
        (2.0 + 1.0 / r) * sin.powf(1.0 / r) / TAU,
    );
    let [i, o] = [
        terms.number(
            [
                r"\light{\Lambda_i}",
                "",
                "How much of the light's way is masked, by the paper's fit",
            ],
            lambda(r, pair.mu_i()),
        ),
        terms.number(
            [
                r"\viewer{\Lambda_o}",
                "",
                "How much of the viewer's way is masked, by the paper's fit",
            ],
            lambda(r, pair.mu_o()),
        ),
    ];
    let g = terms.number(
        [
            "G",
            r"\frac{1}{1 + \light{\Lambda_i} + \viewer{\Lambda_o}}",
            "The share of the fibres that neither direction is masked from",
        ],
        1.0 / (1.0 + i + o),
    );
    terms.f(CHARLIE, rho * (d * g / (4.0 * pair.mu_i() * pair.mu_o())));
    Some(terms)
}

const HAPKE: &str = r"\frac{\param{single_scattering_albedo}{w}}{4\pi}\,\frac{(1 + B)\,p + \light{H_i}\,\viewer{H_o} - 1}{\light{\mu_i} + \viewer{\mu_o}}";

pub(super) fn hapke(_: &ParamSet) -> Vec<&'static str> {
    vec![HAPKE]
}

pub(super) fn hapke_terms<'a>(place: &Place<'a>) -> Option<Terms<'a>> {
    let pair = place.pair()?;
    let mut terms = place.terms();
    let w = terms.colour(
        "single_scattering_albedo",
        r"\param{single_scattering_albedo}{w}",
    );
    let b = terms.parameter("asymmetry", r"\param{asymmetry}{b}");
    let strength = terms.parameter("opposition_strength", r"\param{opposition_strength}{B_0}");
    let width = terms.parameter("opposition_width", r"\param{opposition_width}{h}");
    terms.cosines(&pair);
    let cos_g = terms.number(
        [
            r"\cos g",
            r"\light{\omega_i}\cdot\viewer{\omega_o}",
            "The cosine of the phase angle, between light and viewer",
        ],
        pair.wi.dot(pair.wo),
    );
    let tan = (pair.wi - pair.wo).length() / (pair.wi + pair.wo).length();
    let surge = terms.number(
        [
            "B",
            r"\frac{\param{opposition_strength}{B_0}}{1 + \tan(g/2)/\param{opposition_width}{h}}",
            "The surge with the light behind the viewer",
        ],
        strength / (1.0 + tan / width),
    );
    let phase = terms.number(
        [
            "p",
            r"\frac{1 - \param{asymmetry}{b}^2}{(1 + 2\,\param{asymmetry}{b} \cos g + \param{asymmetry}{b}^2)^{3/2}}",
            "The phase function of a grain",
        ],
        (1.0 - b * b) / (1.0 + 2.0 * b * cos_g + b * b).powf(1.5),
    );
    let h = |mu: f64| {
        w.map(|w| {
            let gamma = (1.0 - w).sqrt();
            let r0 = (1.0 - gamma) / (1.0 + gamma);
            1.0 / (1.0 - w * mu * (r0 + (0.5 - r0 * mu) * ((1.0 + mu) / mu).ln()))
        })
    };
    let [i, o] = [
        terms.rgb(
            [
                r"\light{H_i}",
                "",
                "Chandrasekhar's H of the light: how repeated scattering brightens it",
            ],
            h(pair.mu_i()),
        ),
        terms.rgb(
            [r"\viewer{H_o}", "", "The same of the viewer"],
            h(pair.mu_o()),
        ),
    ];
    let once = Spectrum::grey((1.0 + surge) * phase);
    let several = i.zip(o, |i, o| i * o - 1.0);
    let scale = 0.25 * FRAC_1_PI / (pair.mu_i() + pair.mu_o());
    terms.f(HAPKE, w * (once + several) * scale);
    Some(terms)
}
