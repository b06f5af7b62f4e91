//! Lawful models with one fault each: what the laws are tested on.

use brdf_explorer::bxdf::math::{Real, Vec3};
use brdf_explorer::bxdf::optics::Spectrum;
use brdf_explorer::bxdf::param::ParamSet;
use brdf_explorer::bxdf::{
    Bxdf, Category, Component, Deltas, Lobe, Lobes, Material, ModelSpec, Precision, Properties,
    Sample, Scatterer, builders,
};

// What can be wrong with a model; each is put into an otherwise lawful one.
pub const NOTHING: usize = 0;
pub const PDF_TOO_LARGE: usize = 1;
pub const SAMPLES_ELSEWHERE: usize = 2;
pub const LOPSIDED: usize = 3;
pub const TOO_BRIGHT: usize = 4;
pub const NAN_AT_GRAZING: usize = 5;
pub const NEGATIVE_AT_GRAZING: usize = 6;
pub const LEAKY: usize = 7;
pub const OTHER_WEIGHT: usize = 8;
pub const STRIPED: usize = 9;
pub const SINGLE_OFF: usize = 10;
pub const DELTA_WEIGHT: usize = 11;
pub const DELTA_ONE_WAY: usize = 12;
pub const DELTA_PROBABILITY: usize = 13;
pub const LONG_SAMPLES: usize = 14;
pub const NARROW_PDF: usize = 15;
pub const WIDER_SAMPLES: usize = 16;
pub const F_WITHOUT_PDF: usize = 17;
pub const SAMPLES_LOST: usize = 18;
pub const BLIND: usize = 19;
pub const PDF_SLIGHTLY_TOO_LARGE: usize = 20;
pub const LOBE_TOO_DARK: usize = 21;
pub const LOBE_PDF_TOO_LARGE: usize = 22;
pub const NEEDLES: usize = 23;
pub const NEEDLES_PDF: usize = 24;
pub const NEEDLES_SAMPLES: usize = 25;
pub const STEPPED: usize = 26;

/// A lawful model with one fault.
struct Faulty<R, const FAULT: usize> {
    inner: Box<dyn Scatterer<R>>,
    /// What samples come from, where it is another model.
    sampled: Box<dyn Scatterer<R>>,
}

/// Two needles apart, and the same with one of them a tenth wider.
const TWO_NEEDLES: &str = "retro_reflector:alpha=.04 + rough_conductor:alpha=.05";
const ONE_NEEDLE_WIDER: &str = "retro_reflector:alpha=.044 + rough_conductor:alpha=.05";

/// Models with a plus between them, as a material in equal parts.
fn sum(text: &str) -> Material {
    let texts: Vec<&str> = text.split(" + ").collect();
    let component = |text: &&str| {
        let mut component: Component = text.parse().unwrap();
        component.set_weight(1.0 / texts.len() as f64).unwrap();
        component
    };
    Material::new(texts.iter().map(component).collect()).unwrap()
}

fn build<R: Precision, const FAULT: usize>(_: &ParamSet) -> Box<dyn Scatterer<R>> {
    let (inner, sampled) = match FAULT {
        DELTA_WEIGHT | DELTA_ONE_WAY | DELTA_PROBABILITY => {
            ("fresnel_specular", "fresnel_specular")
        }
        NARROW_PDF => (
            "rough_conductor:fresnel=one,alpha=.001",
            "rough_conductor:fresnel=one,alpha=.001",
        ),
        PDF_SLIGHTLY_TOO_LARGE => (
            "rough_conductor:fresnel=one,alpha=.3",
            "rough_conductor:fresnel=one,alpha=.3",
        ),
        NEEDLES | NEEDLES_PDF => (TWO_NEEDLES, TWO_NEEDLES),
        NEEDLES_SAMPLES => (TWO_NEEDLES, ONE_NEEDLE_WIDER),
        WIDER_SAMPLES => (
            "rough_conductor:fresnel=one,alpha=.01",
            "rough_conductor:fresnel=one,alpha=.011",
        ),
        _ => (
            "lambertian_reflection:reflectance=.9",
            "lambertian_reflection:reflectance=.9",
        ),
    };
    Box::new(Faulty::<R, FAULT> {
        inner: sum(inner).build(),
        sampled: sum(sampled).build(),
    })
}

impl<R: Real, const FAULT: usize> Bxdf<R> for Faulty<R, FAULT> {
    fn f(&self, wo: Vec3<R>, wi: Vec3<R>) -> Spectrum<R> {
        let f = self.inner.f(wo, wi);
        let grazes = wi.z.abs() < R::of(1e-12);
        match FAULT {
            LOPSIDED => f * (R::one() + R::of(0.01) * wo.x),
            TOO_BRIGHT => f * R::of(1.05 / 0.9),
            NEGATIVE_AT_GRAZING if grazes => Spectrum::grey(-R::one()),
            BLIND if wo.x > R::of(0.5) => Spectrum::black(),
            LEAKY if wo.z * wi.z < R::zero() => Spectrum::grey(R::of(1e-6)),
            STEPPED if wi.z > R::of(0.31) => f * R::of(1.0 + 1e-9),
            STRIPED => f * (R::one() + R::of(0.01) * wo.x * wi.x),
            SINGLE_OFF if R::NAME == "f32" => f * R::of(1.0 + 1e-4),
            _ => f,
        }
    }

    fn pdf(&self, wo: Vec3<R>, wi: Vec3<R>) -> R {
        let pdf = self.inner.pdf(wo, wi);
        match FAULT {
            PDF_TOO_LARGE | NARROW_PDF => pdf * R::of(1.02),
            PDF_SLIGHTLY_TOO_LARGE | NEEDLES_PDF => pdf * R::of(1.002),
            NAN_AT_GRAZING if wi.z.abs() < R::of(1e-12) => R::of(f64::NAN),
            F_WITHOUT_PDF if wi.x > R::of(0.9) => R::zero(),
            _ => pdf,
        }
    }

    fn sample_f(&self, wo: Vec3<R>, uc: R, u: [R; 2]) -> Option<Sample<R>> {
        let [u0, u1] = u;
        let u = if FAULT == SAMPLES_ELSEWHERE {
            [u0 * u0, u1]
        } else {
            u
        };
        let mut sample = self.sampled.sample_f(wo, uc, u)?;
        if sample.is_delta {
            return self
                .deltas(wo)
                .into_iter()
                .flatten()
                .map(|delta| delta.sample())
                .find(|other| other.wi.z * sample.wi.z > R::zero());
        }
        if FAULT == SAMPLES_LOST && uc > R::of(0.98) {
            return None;
        }
        if FAULT == LONG_SAMPLES {
            sample.wi = sample.wi * R::of(1.0 + 1e-6);
        }
        sample.f = self.f(wo, sample.wi);
        sample.pdf = self.pdf(wo, sample.wi);
        if FAULT == OTHER_WEIGHT {
            sample.f = sample.f * R::of(1.0 + 1e-6);
        }
        Some(sample)
    }

    fn deltas(&self, w: Vec3<R>) -> Deltas<R> {
        self.inner.deltas(w).map(|delta| {
            let mut delta = delta?;
            match FAULT {
                DELTA_WEIGHT => delta.weight = delta.weight * R::of(1.0 + 1e-6),
                DELTA_ONE_WAY if w.z < R::zero() => {
                    delta.flux = delta.flux * R::of(0.99);
                    delta.weight = delta.weight * R::of(0.99);
                }
                DELTA_PROBABILITY => delta.probability = delta.probability * R::of(0.9),
                _ => {}
            }
            Some(delta)
        })
    }
}

impl<R: Real, const FAULT: usize> Lobes<R> for Faulty<R, FAULT> {
    fn lobes(&self) -> &[Lobe] {
        self.inner.lobes()
    }

    fn lobe_f(&self, index: usize, wo: Vec3<R>, wi: Vec3<R>) -> Spectrum<R> {
        match FAULT {
            NEEDLES | NEEDLES_PDF | NEEDLES_SAMPLES => self.inner.lobe_f(index, wo, wi),
            LOBE_TOO_DARK => self.f(wo, wi) * R::of(0.999),
            _ => self.f(wo, wi),
        }
    }

    fn lobe_pdf(&self, index: usize, wo: Vec3<R>, wi: Vec3<R>) -> R {
        let pdf = self.inner.lobe_pdf(index, wo, wi);
        if FAULT == LOBE_PDF_TOO_LARGE {
            pdf * R::of(1.001)
        } else {
            pdf
        }
    }

    fn sample_lobe(&self, index: usize, wo: Vec3<R>, u: [R; 2]) -> Option<Vec3<R>> {
        self.inner.sample_lobe(index, wo, u)
    }
}

impl<R: Real, const FAULT: usize> Scatterer<R> for Faulty<R, FAULT> {}

const DIFFUSE: &[Lobe] = &[Lobe::reflection(Category::Diffuse)];
const GLOSSY: &[Lobe] = &[Lobe::reflection(Category::GlossySpecular)];
const NEEDLE_PAIR: &[Lobe] = &[
    Lobe::reflection(Category::RetroReflective),
    Lobe::reflection(Category::GlossySpecular),
];
const DELTAS: &[Lobe] = &[
    Lobe::reflection(Category::PerfectSpecular),
    Lobe::transmission(Category::PerfectSpecular),
];

/// A model with this fault, and these declarations.
pub fn faulty<const FAULT: usize>(properties: Properties) -> ModelSpec {
    let is_delta = matches!(FAULT, DELTA_WEIGHT | DELTA_ONE_WAY | DELTA_PROBABILITY);
    let lobes: &[Lobe] = match FAULT {
        _ if is_delta => DELTAS,
        NARROW_PDF | WIDER_SAMPLES | PDF_SLIGHTLY_TOO_LARGE => GLOSSY,
        NEEDLES | NEEDLES_PDF | NEEDLES_SAMPLES => NEEDLE_PAIR,
        _ => DIFFUSE,
    };
    let relative_index: fn(&ParamSet) -> f64 = if is_delta { |_| 1.5 } else { |_| 1.0 };
    ModelSpec {
        id: "faulty",
        title: "Faulty",
        source: "none",
        summary: "none",
        lobes,
        parameters: &[],
        properties: Properties {
            relative_index,
            ..properties
        },
        validate: ModelSpec::any,
        builders: builders!(build::<_, FAULT>),
        stand_ins: &[],
    }
}
