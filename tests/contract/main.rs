//! The laws of the contract hold for every model of the list, and each law catches a model that breaks it.

#![allow(
    clippy::unwrap_used,
    reason = "a test's own helpers may fail as loudly as the test"
)]

mod extremes;
mod faulty;
mod materials;

use std::sync::Mutex;

use brdf_explorer::bxdf::material::library;
use brdf_explorer::bxdf::models::MODELS;
use brdf_explorer::bxdf::{Component, Declaration, Law, Material, ModelSpec, Properties};
use brdf_explorer::lab::contract::{
    Effort, LawId, LawReport, Limit, Plan, Relation, Specimen, Status, Tallies, check, check_at,
    check_material, compare,
};
use faulty::*;
use rayon::prelude::*;

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
fn a_million_samples_agree_with_the_integrals() {
    // At the defaults of each model, in each of the seven directions, within four standard errors.
    let failures: Vec<String> = MODELS
        .par_iter()
        .flat_map(|model| {
            let reports = check_material(&Material::of(model), Effort::Thorough);
            let failed = reports.iter().filter(|report| !report.status.is_pass());
            failed
                .map(|report| failure_line(model.id, report))
                .collect::<Vec<_>>()
        })
        .collect();
    assert!(failures.is_empty(), "\n{}", failures.join("\n"));
}

/// Mixtures of lobes that overlap, lie on both sides, are deltas, blades, needles or faint.
const MIXTURES: [&[(f64, &str)]; 6] = [
    &[
        (0.5, "rough_conductor:alpha_x=.01,alpha_y=.3"),
        (0.4, "eon:roughness=.7"),
    ],
    &[
        (0.6, "lambertian_reflection"),
        (0.5, "lambertian_transmission:transmittance=.3"),
    ],
    &[
        (0.3, "fresnel_specular"),
        (0.4, "rough_dielectric:alpha=.02"),
        (0.3, "oren_nayar"),
    ],
    &[
        (0.001, "phong:exponent=10000"),
        (0.2, "retro_reflector:alpha=.05"),
        (0.7, "velvet"),
    ],
    &[
        (0.5, "specular_reflection"),
        (0.25, "plastic:alpha=0"),
        (0.0, "principled"),
        (0.2, "hapke"),
    ],
    // A needle back and one forth: from the horizon each is a thin wedge at the far rim of the other's half vectors.
    &[
        (0.5, "retro_reflector:reflectance=0.8/0.06/0.05,alpha=0.04"),
        (0.5, "plastic:diffuse=0.5/0.02/0.02,alpha=0.05"),
    ],
];

fn mixture(parts: &[(f64, &str)]) -> Material {
    let component = |(weight, text): &(f64, &str)| {
        let mut component: Component = text.parse().unwrap();
        component.set_weight(*weight).unwrap();
        component
    };
    Material::new(parts.iter().map(component).collect()).unwrap()
}

#[test]
fn mixtures_keep_every_law() {
    for parts in MIXTURES {
        let material = mixture(parts);
        for report in check_material(&material, Effort::Thorough) {
            let line = failure_line(&material.to_string(), &report);
            assert!(report.status.is_pass(), "{line}");
        }
    }
}

#[test]
fn every_named_material_keeps_every_law() {
    let failures: Vec<String> = library::all()
        .par_iter()
        .flat_map(|named| {
            let reports = check_material(&named.material, Effort::Quick);
            let failed = reports.iter().filter(|report| !report.status.is_pass());
            failed
                .map(|report| failure_line(named.id, report))
                .collect::<Vec<_>>()
        })
        .collect();
    assert!(failures.is_empty(), "\n{}", failures.join("\n"));
}

#[test]
fn no_law_passes_for_want_of_comparisons() {
    let mut compared = [0; LawId::ALL.len()];
    for model in MODELS {
        // Limits belong to particular models, deltas and values exclude each other; together they meet every law.
        let defaults = [model.defaults()];
        for (sum, report) in compared
            .iter_mut()
            .zip(check_at(model, &defaults, Effort::Quick))
        {
            *sum += report.n;
        }
    }
    for (law, n) in LawId::ALL.into_iter().zip(compared) {
        // Seven directions for each model, at the least.
        assert!(
            n >= 7 * MODELS.len() || law == LawId::Sampling && n > 40,
            "{}: {n}",
            law.id()
        );
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
        Deltas, Energy, Finite, Isotropy, Lobes, MeanWeight, PdfIntegral, Precision, Reciprocity,
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
    breaks::<BLIND>(&[Reciprocity, Isotropy]);
    breaks::<F_WITHOUT_PDF>(&[
        PdfIntegral,
        Sampling,
        Support,
        Weight,
        MeanWeight,
        Finite,
        Isotropy,
    ]);
    breaks::<OTHER_WEIGHT>(&[Weight]);
    breaks::<LONG_SAMPLES>(&[Weight, Finite]);
    breaks::<STRIPED>(&[Isotropy]);
    breaks::<SINGLE_OFF>(&[Precision]);
    breaks::<DELTA_WEIGHT>(&[Deltas]);
    breaks::<DELTA_ONE_WAY>(&[Reciprocity]);
    breaks::<DELTA_PROBABILITY>(&[Sampling, MeanWeight]);
    breaks::<LOBE_TOO_DARK>(&[Lobes]);
    breaks::<LOBE_PDF_TOO_LARGE>(&[Lobes]);
}

#[test]
fn thorough_checks_catch_a_density_wrong_by_a_fifth_of_a_percent() {
    let model = faulty::<PDF_SLIGHTLY_TOO_LARGE>(Properties::PLAIN);
    let status = |effort| status_of(&check(&model, effort), LawId::PdfIntegral);
    assert_eq!(status(Effort::Thorough), Status::Violated);
}

#[test]
fn two_needles_are_told_from_faulty_ones() {
    fn reports<const FAULT: usize>() -> Vec<LawReport> {
        check(&faulty::<FAULT>(Properties::PLAIN), Effort::Thorough)
    }
    for report in reports::<NEEDLES>() {
        assert!(report.status.is_pass(), "{report:#?}");
    }
    let [wrong_pdf, wrong_samples] = [reports::<NEEDLES_PDF>(), reports::<NEEDLES_SAMPLES>()];
    assert_eq!(status_of(&wrong_pdf, LawId::PdfIntegral), Status::Violated);
    assert_eq!(status_of(&wrong_samples, LawId::Sampling), Status::Violated);
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
    when: Declaration::always,
};
const RECIPROCITY: Declaration = Declaration {
    law: Law::Reciprocity,
    theta_deg: 89.0,
    ..ENERGY
};

const BAD_PARAMETERS: Declaration = Declaration {
    parameters: "alpha=2",
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
    for (declaration, law) in [
        (&[ENERGY], LawId::Energy),
        (&[RECIPROCITY], LawId::Reciprocity),
    ] {
        assert_eq!(declaring::<NOTHING>(declaration, law), Status::Misdeclared);
    }
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
            Specimen::of_material(&material)
        });
        let mut tallies = Tallies::default();
        compare(&limit, &a, &b, &plan, &mut tallies);
        status_of(&tallies.into_reports().collect::<Vec<_>>(), LawId::Limits)
    };
    let mirror = "specular_reflection";
    for (material, becomes, relation, expected) in [
        (
            "oren_nayar:sigma=0",
            "lambertian_reflection",
            Relation::Same,
            Status::Ok,
        ),
        (
            "oren_nayar:sigma=3",
            "lambertian_reflection",
            Relation::Same,
            Status::Violated,
        ),
        (
            "retro_reflector",
            "rough_conductor:fresnel=one",
            Relation::Mirrored,
            Status::Violated,
        ),
        (
            "rough_conductor:alpha_x=.1",
            "rough_conductor:alpha_x=.1",
            Relation::QuarterTurn,
            Status::Violated,
        ),
        (
            "rough_conductor:fresnel=one,alpha=.001",
            mirror,
            Relation::NarrowLobe,
            Status::Violated,
        ),
        (
            "fresnel_specular",
            "specular_reflection:fresnel=dielectric,eta=1.6",
            Relation::HasDeltas,
            Status::Violated,
        ),
        (
            "fresnel_specular",
            "specular_transmission:eta=1.6",
            Relation::SameDirection,
            Status::Violated,
        ),
        ("fresnel_specular", mirror, Relation::Same, Status::Violated),
    ] {
        assert_eq!(
            status(material, becomes, relation),
            expected,
            "{material} {becomes}"
        );
    }
}
