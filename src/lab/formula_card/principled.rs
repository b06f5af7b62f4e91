//! The principled model: lobes that are added.

use std::f64::consts::{FRAC_1_PI, PI};

use super::diffuse::F90;
use super::facets::Slopes;
use super::place::{Pair, Place};
use super::term::Terms;
use bxdf::Spectrum;
use bxdf::internals::fresnel::schlick_weight;
use bxdf::param::ParamSet;

const WHOLE: &str = r"(1 - \param{metallic}{m})\,(f_d + f_h) + \frac{F_s\,D_s\,G_s}{4\,\light{\mu_i}\,\viewer{\mu_o}} + \frac{\param{clearcoat}{c}}{4}\,\frac{F_r\,D_r\,G_r}{4\,\light{\mu_i}\,\viewer{\mu_o}}";

pub(super) fn formulas(_: &ParamSet) -> Vec<&'static str> {
    vec![WHOLE]
}

fn mix(a: f64, b: f64, share: f64) -> f64 {
    a * (1.0 - share) + b * share
}

/// The parameters and the directions, by the names of the formula.
struct Inside {
    pair: Pair,
    base: Spectrum<f64>,
    tint: Spectrum<f64>,
    metallic: f64,
    roughness: f64,
    weight: f64,
}

pub(super) fn terms<'a>(place: &Place<'a>) -> Option<Terms<'a>> {
    let pair = place.pair()?;
    let mut terms = place.terms();
    let base = terms.colour("base_color", r"\param{base_color}{C}");
    let metallic = terms.parameter("metallic", r"\param{metallic}{m}");
    let roughness = terms.parameter("roughness", r"\param{roughness}{r}");
    terms.cosines(&pair);
    terms.half(&pair);
    let [r, g, b] = base.0;
    let luminance = 0.3 * r + 0.6 * g + 0.1 * b;
    let tint = base.map(|x| if luminance > 0.0 { x / luminance } else { 1.0 });
    terms.rgb(
        [
            "T",
            r"\frac{\param{base_color}{C}}{0.3\,C_R + 0.6\,C_G + 0.1\,C_B}",
            "The hue of the body",
        ],
        tint,
    );
    let weight = terms.number(
        [
            "w",
            r"(1 - \half{h}\cdot\light{\omega_i})^5",
            "Schlick's weight at the half vector",
        ],
        schlick_weight(pair.cos_d),
    );
    let inside = Inside {
        pair,
        base,
        tint,
        metallic,
        roughness,
        weight,
    };
    let body = inside.diffuse(&mut terms) + inside.sheen(&mut terms);
    let f = body * (1.0 - metallic) + inside.specular(&mut terms) + inside.coat(&mut terms);
    terms.f(WHOLE, f);
    Some(terms)
}

impl Inside {
    fn cosines(&self) -> [f64; 2] {
        [self.pair.mu_i(), self.pair.mu_o()]
    }

    fn diffuse(&self, terms: &mut Terms<'_>) -> Spectrum<f64> {
        let subsurface = terms.parameter("subsurface", r"\param{subsurface}{k}");
        let retro = self.roughness * self.pair.cos_d * self.pair.cos_d;
        let [i, o] = self.cosines();
        let f90 = terms.number(F90, 0.5 + 2.0 * retro);
        let [rough_i, rough_o] = [i, o].map(|mu| mix(1.0, f90, schlick_weight(mu)));
        let rough = terms.number(
            [
                "R",
                r"\left(1 + (F_{90} - 1)(1 - \light{\mu_i})^5\right) \left(1 + (F_{90} - 1)(1 - \viewer{\mu_o})^5\right)",
                "The shape of the diffuse lobe",
            ],
            rough_i * rough_o,
        );
        let [flat_i, flat_o] = [i, o].map(|mu| mix(1.0, retro, schlick_weight(mu)));
        let flat = terms.number(
            [
                "S",
                r"1.25 \left(s_i\,s_o \left(\frac{1}{\light{\mu_i} + \viewer{\mu_o}} - \tfrac{1}{2}\right) + \tfrac{1}{2}\right),\quad s = 1 + \left(\tfrac{1}{2}(F_{90} - \tfrac{1}{2}) - 1\right)(1 - \mu)^5",
                "Its shape where light has travelled under the surface",
            ],
            1.25 * (flat_i * flat_o * (1.0 / (i + o) - 0.5) + 0.5),
        );
        terms.value(
            ["f_d", r"\frac{\param{base_color}{C}}{\pi} \left((1 - \param{subsurface}{k})\,R + \param{subsurface}{k}\,S\right)", "The diffuse lobe"],
            self.base * (FRAC_1_PI * mix(rough, flat, subsurface)),
        )
    }

    /// White, taking so much of the hue of the body.
    fn tinted(&self, share: f64) -> Spectrum<f64> {
        self.tint.map(|x| mix(1.0, x, share))
    }

    fn sheen(&self, terms: &mut Terms<'_>) -> Spectrum<f64> {
        let sheen = terms.parameter("sheen", r"\param{sheen}{s_h}");
        let tint = terms.parameter("sheen_tint", r"\param{sheen_tint}{t_h}");
        terms.value(
            ["f_h", r"\param{sheen}{s_h} \left(1 - \param{sheen_tint}{t_h} + \param{sheen_tint}{t_h}\,T\right) w", "The sheen"],
            self.tinted(tint) * (sheen * self.weight),
        )
    }

    fn specular(&self, terms: &mut Terms<'_>) -> Spectrum<f64> {
        let specular = terms.parameter("specular", r"\param{specular}{s}");
        let tint = terms.parameter("specular_tint", r"\param{specular_tint}{t_s}");
        let anisotropic = terms.parameter("anisotropic", r"\param{anisotropic}{a}");
        let tinted = self.tinted(tint);
        let f0 = terms.rgb(
            [
                "F_0",
                r"(1 - \param{metallic}{m})\,0.08\,\param{specular}{s} \left(1 - \param{specular_tint}{t_s} + \param{specular_tint}{t_s}\,T\right) + \param{metallic}{m}\,\param{base_color}{C}",
                "The reflectance of the highlight at normal incidence",
            ],
            tinted.zip(self.base, |tinted, base| mix(0.08 * specular * tinted, base, self.metallic)),
        );
        let fresnel = terms.rgb(
            [
                "F_s",
                r"F_0 + (1 - F_0)\,w",
                "The reflectance of the highlight",
            ],
            f0.map(|f0| mix(f0, 1.0, self.weight)),
        );
        let aspect = (1.0 - 0.9 * anisotropic).sqrt();
        let square = self.roughness * self.roughness;
        let widths = [square / aspect, square * aspect].map(|width| width.max(1e-3));
        let [x, y] = widths;
        terms.number([r"\alpha_s", r"\max\left(0.001, \frac{\param{roughness}{r}^2}{\sqrt{1 - 0.9\,\param{anisotropic}{a}}}\right)", "The width of the highlight along s"], x);
        terms.number([r"\alpha_t", r"\max\left(0.001, \param{roughness}{r}^2 \sqrt{1 - 0.9\,\param{anisotropic}{a}}\right)", "Its width along t"], y);
        let slopes = Slopes { widths };
        let d = terms.density(
            [
                "D_s",
                r"\frac{1}{\pi\,\alpha_s \alpha_t \left(\frac{\half{h_s}^2}{\alpha_s^2} + \frac{\half{h_t}^2}{\alpha_t^2} + \half{h_n}^2\right)^2}",
                "The density of microfacet normals at the half vector (GGX)",
            ],
            slopes.ggx(self.pair.h),
        );
        let g = terms.number(
            [
                "G_s",
                r"\frac{1}{(1 + \light{\Lambda_i})(1 + \viewer{\Lambda_o})}",
                "Shadowing and masking of Smith for the same widths",
            ],
            slopes.smith_of_ggx(&self.pair),
        );
        let [i, o] = self.cosines();
        fresnel * (d * g / (4.0 * i * o))
    }

    fn coat(&self, terms: &mut Terms<'_>) -> Spectrum<f64> {
        let strength = terms.parameter("clearcoat", r"\param{clearcoat}{c}");
        let gloss = terms.parameter("clearcoat_gloss", r"\param{clearcoat_gloss}{g}");
        let fresnel = terms.number(
            [
                "F_r",
                r"0.04 + 0.96\,w",
                "The reflectance of the clear coat",
            ],
            mix(0.04, 1.0, self.weight),
        );
        let a = terms.number(
            [
                r"\alpha_r",
                r"0.1 - 0.099\,\param{clearcoat_gloss}{g}",
                "Its width",
            ],
            0.1 - 0.099 * gloss,
        );
        let sin2 = self.pair.h.truncate().length_squared();
        let (a2, rest) = (a * a, (1.0 - a) * (1.0 + a));
        let d = terms.density(
            [
                "D_r",
                r"\frac{\alpha_r^2 - 1}{\pi \ln(\alpha_r^2) \left(1 + (\alpha_r^2 - 1)\,\half{h_n}^2\right)}",
                "The density of microfacet normals at the half vector (GTR1)",
            ],
            rest / (-2.0 * PI * a.ln() * (a2 + rest * sin2)),
        );
        let g = terms.number(
            [
                "G_r",
                r"\frac{1}{(1 + \light{\Lambda_i})(1 + \viewer{\Lambda_o})}",
                "Shadowing and masking of Smith for a width of 0.25",
            ],
            Slopes { widths: [0.25; 2] }.smith_of_ggx(&self.pair),
        );
        let [i, o] = self.cosines();
        Spectrum::grey(0.25 * strength * fresnel * d * g / (4.0 * i * o))
    }
}
