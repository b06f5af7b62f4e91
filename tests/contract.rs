//! The laws of the contract hold for every model of the list, and each law catches a model that breaks it.

use std::sync::Mutex;

use brdf_explorer::bxdf::math::{Real, Vec3};
use brdf_explorer::bxdf::models::MODELS;
use brdf_explorer::bxdf::optics::Spectrum;
use brdf_explorer::bxdf::param::ParamSet;
use brdf_explorer::bxdf::{
    Builders, Bxdf, Category, Declaration, Deltas, Law, Lobe, Material, ModelSpec, Precision,
    Properties, Sample,
};
use brdf_explorer::lab::contract::{
    Effort, LawId, LawReport, Limit, Plan, Relation, Status, Subject, Tallies, check,
    check_material, compare,
};

fn failure_line(id: &str, report: &LawReport) -> String {
    format!(
        "{id} {} {}: {} {:.3e}, allowed {:.3e}, at {}",
        report.law.id(),
        report.status.id(),
        report.law.measure(),
        report.worst,
        report.error,
        report.witness
    )
}

#[test]
fn every_model_keeps_every_law() {
    // The costly models first, two at a time.
    let mut waiting: Vec<&ModelSpec> = MODELS.to_vec();
    waiting.sort_by_key(|model| model.parameters.len());
    let (waiting, failures) = (Mutex::new(waiting), Mutex::new(Vec::new()));
    std::thread::scope(|scope| {
        for _ in 0..2 {
            scope.spawn(|| {
                loop {
                    let Some(model) = waiting.lock().unwrap().pop() else {
                        return;
                    };
                    let reports = check(model, Effort::Quick);
                    assert_eq!(reports.len(), LawId::ALL.len());
                    let lines = reports
                        .iter()
                        .filter(|report| !report.status.is_pass())
                        .map(|report| failure_line(model.id, report));
                    failures.lock().unwrap().extend(lines);
                }
            });
        }
    });
    let failures = failures.into_inner().unwrap();
    assert!(failures.is_empty(), "\n{}", failures.join("\n"));
}

#[test]
fn no_law_passes_for_want_of_comparisons() {
    let mut compared = [0; LawId::ALL.len()];
    for model in MODELS {
        // Limits belong to particular models, deltas and values exclude each other; together they meet every law.
        for (sum, report) in compared
            .iter_mut()
            .zip(check_material(&Material::of(model), Effort::Quick))
        {
            *sum += report.n;
        }
    }
    for (law, n) in LawId::ALL.into_iter().zip(compared) {
        // Seven directions for each of the eight models, at the least.
        assert!(n >= 7 * MODELS.len() || law == LawId::Sampling && n > 40, "{}: {n}", law.id());
    }
}

// What can be wrong with a model; each is put into an otherwise lawful one.
const NOTHING: usize = 0;
const PDF_TOO_LARGE: usize = 1;
const SAMPLES_ELSEWHERE: usize = 2;
const LOPSIDED: usize = 3;
const TOO_BRIGHT: usize = 4;
const NAN_AT_GRAZING: usize = 5;
const NEGATIVE_AT_GRAZING: usize = 6;
const LEAKY: usize = 7;
const OTHER_WEIGHT: usize = 8;
const STRIPED: usize = 9;
const SINGLE_OFF: usize = 10;
const DELTA_WEIGHT: usize = 11;
const DELTA_ONE_WAY: usize = 12;
const DELTA_PROBABILITY: usize = 13;
const LONG_SAMPLES: usize = 14;
const NARROW_PDF: usize = 15;
const WIDER_SAMPLES: usize = 16;
const F_WITHOUT_PDF: usize = 17;
const SAMPLES_LOST: usize = 18;

/// A lawful model with one fault.
struct Faulty<R, const FAULT: usize> {
    inner: Box<dyn Bxdf<R>>,
    /// What samples come from, where it is another model.
    sampled: Box<dyn Bxdf<R>>,
}

fn build<R: Precision, const FAULT: usize>(_: &ParamSet) -> Box<dyn Bxdf<R>> {
    let (inner, sampled) = match FAULT {
        DELTA_WEIGHT | DELTA_ONE_WAY | DELTA_PROBABILITY => ("fresnel_specular", "fresnel_specular"),
        NARROW_PDF => (
            "rough_conductor:fresnel=one,alpha=.001",
            "rough_conductor:fresnel=one,alpha=.001",
        ),
        WIDER_SAMPLES => (
            "rough_conductor:fresnel=one,alpha=.01",
            "rough_conductor:fresnel=one,alpha=.011",
        ),
        _ => (
            "lambertian_reflection:reflectance=.9",
            "lambertian_reflection:reflectance=.9",
        ),
    };
    let model = |text: &str| text.parse::<Material>().unwrap().build::<R>();
    Box::new(Faulty::<R, FAULT> {
        inner: model(inner),
        sampled: model(sampled),
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
            LEAKY if wo.z * wi.z < R::zero() => Spectrum::grey(R::of(1e-6)),
            STRIPED => f * (R::one() + R::of(0.01) * wo.x * wi.x),
            SINGLE_OFF if R::NAME == "f32" => f * R::of(1.0 + 1e-4),
            _ => f,
        }
    }

    fn pdf(&self, wo: Vec3<R>, wi: Vec3<R>) -> R {
        let pdf = self.inner.pdf(wo, wi);
        match FAULT {
            PDF_TOO_LARGE | NARROW_PDF => pdf * R::of(1.02),
            NAN_AT_GRAZING if wi.z.abs() < R::of(1e-12) => R::nan(),
            F_WITHOUT_PDF if wi.x > R::of(0.9) => R::zero(),
            _ => pdf,
        }
    }

    fn sample_f(&self, wo: Vec3<R>, uc: R, u: [R; 2]) -> Option<Sample<R>> {
        let [u0, u1] = u;
        let u = if FAULT == SAMPLES_ELSEWHERE { [u0 * u0, u1] } else { u };
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
                DELTA_ONE_WAY if w.z < R::zero() => delta.flux = delta.flux * R::of(0.99),
                DELTA_PROBABILITY => delta.probability = delta.probability * R::of(0.9),
                _ => {}
            }
            Some(delta)
        })
    }
}

const DIFFUSE: &[Lobe] = &[Lobe::reflection(Category::Diffuse)];
const GLOSSY: &[Lobe] = &[Lobe::reflection(Category::GlossySpecular)];
const DELTAS: &[Lobe] = &[
    Lobe::reflection(Category::PerfectSpecular),
    Lobe::transmission(Category::PerfectSpecular),
];

/// A model with this fault, and these declarations.
fn faulty<const FAULT: usize>(properties: Properties) -> ModelSpec {
    let is_delta = matches!(FAULT, DELTA_WEIGHT | DELTA_ONE_WAY | DELTA_PROBABILITY);
    let lobes: &[Lobe] = match FAULT {
        _ if is_delta => DELTAS,
        NARROW_PDF | WIDER_SAMPLES => GLOSSY,
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
        builders: Builders {
            f32: build::<f32, FAULT>,
            f64: build::<f64, FAULT>,
            reference: build::<xprec::Df64, FAULT>,
        },
    }
}

fn status_of(reports: &[LawReport], law: LawId) -> Status {
    reports
        .iter()
        .find(|report| report.law == law)
        .unwrap()
        .status
}

/// Asserts that exactly these laws are violated.
fn breaks<const FAULT: usize>(laws: &[LawId]) {
    let reports = check(&faulty::<FAULT>(Properties::PLAIN), Effort::Quick);
    for law in LawId::ALL {
        let is_violated = status_of(&reports, law) == Status::Violated;
        assert_eq!(
            is_violated,
            laws.contains(&law),
            "fault {FAULT}, {}: {reports:#?}",
            law.id()
        );
    }
}

#[test]
fn each_fault_is_caught_by_its_laws_and_by_no_other() {
    use LawId::{
        Deltas, Energy, Finite, Isotropy, MeanWeight, PdfIntegral, Precision, Reciprocity,
        Sampling, Support, Weight,
    };
    breaks::<NOTHING>(&[]);
    breaks::<PDF_TOO_LARGE>(&[PdfIntegral, MeanWeight]);
    breaks::<NARROW_PDF>(&[PdfIntegral, Sampling, MeanWeight]);
    breaks::<SAMPLES_ELSEWHERE>(&[Sampling]);
    breaks::<WIDER_SAMPLES>(&[Sampling, MeanWeight]);
    breaks::<SAMPLES_LOST>(&[PdfIntegral, Sampling, MeanWeight]);
    breaks::<LOPSIDED>(&[Reciprocity, Isotropy]);
    breaks::<TOO_BRIGHT>(&[Energy]);
    breaks::<NAN_AT_GRAZING>(&[Finite]);
    breaks::<NEGATIVE_AT_GRAZING>(&[Finite]);
    breaks::<LEAKY>(&[Support]);
    breaks::<F_WITHOUT_PDF>(&[Support]);
    breaks::<OTHER_WEIGHT>(&[Weight]);
    breaks::<LONG_SAMPLES>(&[Weight]);
    breaks::<STRIPED>(&[Isotropy]);
    breaks::<SINGLE_OFF>(&[Precision]);
    breaks::<DELTA_WEIGHT>(&[Deltas]);
    breaks::<DELTA_ONE_WAY>(&[Reciprocity]);
    breaks::<DELTA_PROBABILITY>(&[Sampling]);
}

#[test]
fn an_isotropic_lobe_may_not_be_declared_anisotropic() {
    let properties = Properties {
        is_isotropic: |_| false,
        ..Properties::PLAIN
    };
    let reports = check(&faulty::<NOTHING>(properties), Effort::Quick);
    assert_eq!(status_of(&reports, LawId::Isotropy), Status::Violated);
}

fn declaring<const FAULT: usize>(declarations: &'static [Declaration], law: LawId) -> Status {
    let properties = Properties {
        declarations,
        ..Properties::PLAIN
    };
    status_of(&check(&faulty::<FAULT>(properties), Effort::Quick), law)
}

const ENERGY: Declaration = Declaration {
    law: Law::Energy,
    parameters: "",
    theta_deg: 30.0,
    note: "",
};
const RECIPROCITY: Declaration = Declaration {
    law: Law::Reciprocity,
    ..ENERGY
};

#[test]
fn declarations_excuse_what_their_witness_shows() {
    assert_eq!(
        declaring::<TOO_BRIGHT>(&[ENERGY], LawId::Energy),
        Status::Declared
    );
    assert_eq!(
        declaring::<TOO_BRIGHT>(&[RECIPROCITY], LawId::Energy),
        Status::Violated
    );
    assert_eq!(
        declaring::<LOPSIDED>(&[RECIPROCITY], LawId::Reciprocity),
        Status::Declared
    );
    for (declaration, law) in [(&[ENERGY], LawId::Energy), (&[RECIPROCITY], LawId::Reciprocity)] {
        assert_eq!(declaring::<NOTHING>(declaration, law), Status::Misdeclared);
    }
    const BAD_PARAMETERS: Declaration = Declaration {
        parameters: "alpha=2",
        ..ENERGY
    };
    assert_eq!(
        declaring::<TOO_BRIGHT>(&[BAD_PARAMETERS], LawId::Energy),
        Status::Misdeclared
    );
}

#[test]
fn a_wrong_limit_is_caught() {
    let status = |material: &'static str, becomes: &'static str, relation| {
        let limit = Limit {
            material,
            becomes,
            relation,
            tolerance: 1e-3,
            reason: "a test",
        };
        let plan = Plan {
            effort: Effort::Quick,
            tests: 1,
        };
        let [a, b] = [material, becomes].map(|text| {
            let material: Material = text.parse().unwrap();
            Subject::new(material.model(), material.params())
        });
        let mut tallies = Tallies::default();
        compare(&limit, &a, &b, &plan, &mut tallies);
        status_of(&tallies.into_reports().collect::<Vec<_>>(), LawId::Limits)
    };
    let mirror = "specular_reflection";
    for (material, becomes, relation, expected) in [
        ("oren_nayar:sigma=0", "lambertian_reflection", Relation::Same, Status::Ok),
        ("oren_nayar:sigma=3", "lambertian_reflection", Relation::Same, Status::Violated),
        ("retro_reflector", "rough_conductor:fresnel=one", Relation::Mirrored, Status::Violated),
        ("rough_conductor:alpha_x=.1", "rough_conductor:alpha_x=.1", Relation::QuarterTurn, Status::Violated),
        ("rough_conductor:fresnel=one,alpha=.001", mirror, Relation::NarrowLobe, Status::Violated),
        ("fresnel_specular", "specular_reflection:fresnel=dielectric,eta=1.6", Relation::HasDeltas, Status::Violated),
        ("fresnel_specular", "specular_transmission:eta=1.6", Relation::SameDirection, Status::Violated),
        ("fresnel_specular", mirror, Relation::Same, Status::Violated),
    ] {
        assert_eq!(status(material, becomes, relation), expected, "{material} {becomes}");
    }
}
