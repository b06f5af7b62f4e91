//! Distributions of microfacet normals, and the masking that goes with them.

use std::f64::consts::{FRAC_1_PI, PI};

use glam::DVec3;

use super::place::Pair;
use super::term::{Name, Terms};
use bxdf::internals::Masking;
use bxdf::math::Real;
use bxdf::param::ParamSet;

/// The widths of a distribution, along s and t.
#[derive(Clone, Copy)]
pub(super) struct Slopes {
    pub(super) widths: [f64; 2],
}

/// The distributions that models choose among.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Distribution {
    Ggx,
    Beckmann,
    /// Beckmann's, its masking fitted.
    Rational,
}

pub(super) const GGX: Name = [
    r"D",
    r"\frac{1}{\pi\,\param{alpha_x}{\alpha_s}\param{alpha_y}{\alpha_t} \left(\frac{\half{h_s}^2}{\param{alpha_x}{\alpha_s}^2} + \frac{\half{h_t}^2}{\param{alpha_y}{\alpha_t}^2} + \half{h_n}^2\right)^2}",
    "The density of microfacet normals at the half vector (GGX)",
];

pub(super) const BECKMANN: Name = [
    r"D",
    r"\frac{1}{\pi\,\param{alpha_x}{\alpha_s}\param{alpha_y}{\alpha_t}\,\half{h_n}^4} \exp\left(-\frac{1}{\half{h_n}^2}\left(\frac{\half{h_s}^2}{\param{alpha_x}{\alpha_s}^2} + \frac{\half{h_t}^2}{\param{alpha_y}{\alpha_t}^2}\right)\right)",
    "The density of microfacet normals at the half vector (Beckmann)",
];

/// The symbols and the meanings of Lambda of the light and of the viewer.
const LAMBDAS: [[&str; 2]; 2] = [
    [
        r"\light{\Lambda_i}",
        "How much of the light's way is masked: 1/(1 + it) of the facets is seen",
    ],
    [
        r"\viewer{\Lambda_o}",
        "How much of the viewer's way is masked",
    ],
];

impl Distribution {
    pub(super) fn of(params: &ParamSet) -> Self {
        match params.choice("distribution") {
            "beckmann" => Self::Beckmann,
            "beckmann_rational" => Self::Rational,
            _ => Self::Ggx,
        }
    }

    /// Lambda by a, the cotangent over the width.
    fn lambda(self, a: f64) -> f64 {
        match self {
            Self::Ggx => {
                let x = 1.0 / (a * a);
                0.5 * x / ((1.0 + x).sqrt() + 1.0)
            }
            Self::Beckmann => {
                let bell = (-a * a).exp() / PI.sqrt();
                (0.5 * (bell / a - Real::erfc(a))).max(0.0)
            }
            Self::Rational if a < 1.6 => {
                let g1 = a * (3.535 + 2.181 * a) / (1.0 + a * (2.276 + 2.577 * a));
                (1.0 / g1 - 1.0).max(0.0)
            }
            Self::Rational => 0.0,
        }
    }

    /// How Lambda is computed for each direction.
    fn formulas(self) -> [&'static str; 2] {
        match self {
            Self::Ggx => [
                r"\tfrac{1}{2}\left(\sqrt{1 + 1/\light{a_i}^2} - 1\right)",
                r"\tfrac{1}{2}\left(\sqrt{1 + 1/\viewer{a_o}^2} - 1\right)",
            ],
            Self::Beckmann => [
                r"\tfrac{1}{2}\left(\frac{e^{-\light{a_i}^2}}{\light{a_i}\sqrt{\pi}} - \mathrm{erfc}(\light{a_i})\right)",
                r"\tfrac{1}{2}\left(\frac{e^{-\viewer{a_o}^2}}{\viewer{a_o}\sqrt{\pi}} - \mathrm{erfc}(\viewer{a_o})\right)",
            ],
            Self::Rational => [
                r"\max\left(0, \frac{1 - 1.259\,\light{a_i} + 0.396\,\light{a_i}^2}{3.535\,\light{a_i} + 2.181\,\light{a_i}^2}\right)",
                r"\max\left(0, \frac{1 - 1.259\,\viewer{a_o} + 0.396\,\viewer{a_o}^2}{3.535\,\viewer{a_o} + 2.181\,\viewer{a_o}^2}\right)",
            ],
        }
    }
}

/// The distribution of the normals, and whether both directions are masked independently.
pub(super) fn hidden(params: &ParamSet) -> (Distribution, bool) {
    let is_separable = Masking::from_params(params) == Masking::Separable;
    (Distribution::of(params), is_separable)
}

impl Slopes {
    /// The widths among the parameters.
    pub(super) fn of(terms: &mut Terms<'_>) -> Self {
        Self {
            widths: [
                terms.parameter("alpha_x", r"\param{alpha_x}{\alpha_s}"),
                terms.parameter("alpha_y", r"\param{alpha_y}{\alpha_t}"),
            ],
        }
    }

    /// The square of the slope of `w` in widths, times that of its cosine.
    fn stretched(self, w: DVec3) -> f64 {
        let [a, b] = self.widths;
        (w.x / a).powi(2) + (w.y / b).powi(2)
    }

    /// D of GGX.
    pub(super) fn ggx(self, h: DVec3) -> f64 {
        let [a, b] = self.widths;
        let stretched = self.stretched(h) + h.z * h.z;
        1.0 / (PI * a * b * stretched * stretched)
    }

    /// D of Beckmann.
    pub(super) fn beckmann(self, h: DVec3) -> f64 {
        let [a, b] = self.widths;
        let bell = (-self.stretched(h) / (h.z * h.z)).exp();
        if bell > 0.0 {
            bell * FRAC_1_PI / (a * b * h.z.powi(4))
        } else {
            0.0
        }
    }

    /// The cotangent of `w` over the width in its azimuth.
    fn a(self, w: DVec3) -> f64 {
        let [a, b] = self.widths;
        w.z.abs() / (a * w.x).hypot(b * w.y)
    }

    /// D at `h`.
    pub(super) fn density(
        self,
        terms: &mut Terms<'_>,
        h: DVec3,
        distribution: Distribution,
    ) -> f64 {
        if distribution == Distribution::Ggx {
            terms.density(GGX, self.ggx(h))
        } else {
            terms.density(BECKMANN, self.beckmann(h))
        }
    }

    /// Masking of both directions together.
    pub(super) fn masking(
        self,
        terms: &mut Terms<'_>,
        [wi, wo]: [DVec3; 2],
        (distribution, is_separable): (Distribution, bool),
    ) -> f64 {
        const A: [Name; 2] = [
            [
                r"\light{a_i}",
                r"\frac{\light{\mu_i}}{|(\param{alpha_x}{\alpha_s}\light{\omega_{i,s}},\ \param{alpha_y}{\alpha_t}\light{\omega_{i,t}})|}",
                "The cotangent of the light's angle over the width in its azimuth",
            ],
            [
                r"\viewer{a_o}",
                r"\frac{\viewer{\mu_o}}{|(\param{alpha_x}{\alpha_s}\viewer{\omega_{o,s}},\ \param{alpha_y}{\alpha_t}\viewer{\omega_{o,t}})|}",
                "The same of the viewer",
            ],
        ];
        let mut lambda = [0.0; 2];
        let each = [wi, wo]
            .into_iter()
            .zip(A)
            .zip(LAMBDAS)
            .zip(distribution.formulas());
        for (slot, (((w, name), [symbol, meaning]), formula)) in lambda.iter_mut().zip(each) {
            let a = terms.number(name, self.a(w));
            *slot = terms.number([symbol, formula, meaning], distribution.lambda(a));
        }
        let [i, o] = lambda;
        if is_separable {
            terms.number(
                ["G", r"\frac{1}{(1 + \light{\Lambda_i})(1 + \viewer{\Lambda_o})}", "The share of the facets that neither direction is masked from, taken as independent"],
                1.0 / ((1.0 + i) * (1.0 + o)),
            )
        } else {
            terms.number(
                [
                    "G",
                    r"\frac{1}{1 + \light{\Lambda_i} + \viewer{\Lambda_o}}",
                    "The share of the facets that neither direction is masked from",
                ],
                1.0 / (1.0 + i + o),
            )
        }
    }

    /// Masking of both directions by GGX, taken as independent.
    pub(super) fn smith_of_ggx(self, pair: &Pair) -> f64 {
        let seen = |w| 1.0 / (1.0 + Distribution::Ggx.lambda(self.a(w)));
        seen(pair.wi) * seen(pair.wo)
    }

    /// D G / (4 mu_i mu_o) of GGX.
    pub(super) fn lobe(self, terms: &mut Terms<'_>, pair: &Pair) -> f64 {
        let d = self.density(terms, pair.h, Distribution::Ggx);
        let g = self.masking(terms, [pair.wi, pair.wo], (Distribution::Ggx, false));
        d * g / (4.0 * pair.mu_i() * pair.mu_o())
    }
}
