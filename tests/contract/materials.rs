//! What is said of one material is measured of that material, and keeps to it.

use brdf_explorer::bxdf::material::library;
use brdf_explorer::bxdf::{Component, Material};
use brdf_explorer::lab::contract::{
    Effort, LawId, LawReport, Status, check_energy, check_material, check_physical,
    weight_that_keeps_energy,
};

use super::{mixture, status_of};

/// Breaks both laws, as its model declares.
const TURQUIN: &str = "rough_conductor:alpha=1,fresnel=one,compensation=turquin";

#[test]
fn weights_that_create_energy_are_caught() {
    let bright = mixture(&[(0.7, "lambertian_reflection:reflectance=1"), (0.7, "eon")]);
    let reports = check_material(&bright, Effort::Quick);
    assert_eq!(status_of(&reports, LawId::Energy), Status::Violated);
    // A lobe that creates energy as declared excuses itself alone, not what the weights add.
    for (weight, expected) in [(0.7, Status::Violated), (0.3, Status::Declared)] {
        let mixed = mixture(&[
            (weight, "lambertian_reflection:reflectance=1"),
            (0.7, "burley_diffuse:reflectance=1,roughness=1"),
        ]);
        let reports = check_material(&mixed, Effort::Quick);
        assert_eq!(status_of(&reports, LawId::Energy), expected, "{weight}");
    }
}

/// The laws of a material, by its text, on both ways that they are measured: thoroughly, and in passing.
fn both_ways(material: &Material) -> [Vec<LawReport>; 2] {
    [
        check_material(material, Effort::Quick),
        check_physical(material, &|| true).unwrap(),
    ]
}

/// What is reported of a material is of that material: not of the parameters at which its model is worst.
#[test]
fn a_material_answers_for_itself_alone() {
    let of = |reports: &[LawReport], law| -> LawReport {
        let mut all = reports.iter();
        all.find(|report| report.law == law).unwrap().clone()
    };
    let named = |id: &str| library::find(id).unwrap().material.clone();
    let text = |text: &str| -> Material { text.parse().unwrap() };
    let (energy, reciprocity) = (LawId::Energy, LawId::Reciprocity);
    for (material, law, status, worst) in [
        // The model declares both broken where it compensates: gold does not.
        (named("gold"), energy, Status::Ok, 0.0),
        (named("gold"), reciprocity, Status::Ok, 0.0),
        (
            text("phong:diffuse=.3,specular=.3"),
            energy,
            Status::Ok,
            0.0,
        ),
        // diffuse + specular at normal incidence.
        (
            text("phong:diffuse=.9,specular=.9"),
            energy,
            Status::Declared,
            0.8,
        ),
        (
            text("phong:diffuse=.6,specular=.9"),
            energy,
            Status::Declared,
            0.5,
        ),
        (text(TURQUIN), reciprocity, Status::Declared, 0.69),
        (
            mixture(&[(3.0, "lambertian_reflection:reflectance=.5")]),
            energy,
            Status::Violated,
            0.5,
        ),
        // Its weight is not what the model declares.
        (
            mixture(&[(2.0, "phong:diffuse=.9,specular=.9")]),
            energy,
            Status::Violated,
            2.6,
        ),
        (
            mixture(&[(0.4, "phong:diffuse=.9,specular=.9")]),
            energy,
            Status::Ok,
            0.0,
        ),
    ] {
        for reports in both_ways(&material) {
            let report = of(&reports, law);
            assert_eq!(report.status, status, "{material}: {report:?}");
            // Within the tolerance of what is measured in passing; reciprocity is measured at chance pairs.
            let tolerance = if law == energy { 3e-4 } else { 0.3 };
            assert!(
                (report.worst - worst).abs() < tolerance,
                "{material}: {report:?}"
            );
            assert_eq!(
                report.sentence().is_some(),
                status != Status::Ok,
                "{report:?}"
            );
            if status != Status::Ok {
                assert!(report.witness.wi.is_some() && report.n > 0, "{report:?}");
            }
        }
    }
}

/// Reasons are those of the material at hand.
#[test]
fn a_break_says_what_happens_and_why() {
    let sentence = |material: &Material, law| -> String {
        let [thorough, quick] = both_ways(material).map(|reports| {
            let report = reports.into_iter().find(|report| report.law == law);
            report.unwrap().sentence().unwrap()
        });
        // The numbers may differ in their last digit, the reasons may not.
        let reason = |text: &str| text.split_once("because").unwrap().1.to_owned();
        assert_eq!(reason(&thorough), reason(&quick));
        quick
    };
    let two = mixture(&[
        (0.7, "lambertian_reflection:reflectance=.5"),
        (1.0, "rough_conductor:fresnel=one,alpha=.1"),
    ]);
    let said = sentence(&two, LawId::Energy);
    assert!(said.starts_with("With light at ") && said.contains(" % more leaves than arrives"));
    // Nothing of compensations, which are off.
    assert!(said.ends_with("because the lobes add up"), "{said}");
    let heavy = mixture(&[(3.0, "lambertian_reflection")]);
    let said = sentence(&heavy, LawId::Energy);
    assert!(said.contains("140 % more leaves") && said.ends_with("because its weight is 3"));
    let both = mixture(&[
        (1.0, "phong:diffuse=.9,specular=.9"),
        (0.5, "lambertian_reflection"),
    ]);
    let said = sentence(&both, LawId::Energy);
    let reasons =
        "because the lobes add up, and Phong alone gives back more than it gets, as published: ";
    assert!(said.contains(reasons), "{said}");
    // Of the three notes of the model the one that speaks of these parameters.
    let turquin: Material = TURQUIN.parse().unwrap();
    let said = sentence(&turquin, LawId::Energy);
    assert!(said.contains("the factor is made for"), "{said}");
    for other in ["isotropic surface", "the fit masks less"] {
        assert!(!said.contains(other), "{said}");
    }
    let said = sentence(&turquin, LawId::Reciprocity);
    assert!(said.contains("depends on wo alone"), "{said}");
}

/// Weights over the largest reflectance, and the weight of a lobe that is added, keep energy.
#[test]
fn weights_are_made_that_keep_energy() {
    let base = mixture(&[(1.0, "lambertian_reflection"), (0.1, "rough_conductor")]);
    for (added, expected) in [
        ("lambertian_reflection:reflectance=.5", 0.2),
        // Phong gives back less than all: there is room for a little more than the .1 that is left.
        ("phong", 0.12),
        ("lambertian_transmission:transmittance=.2", 0.25),
    ] {
        let added: Component = added.parse().unwrap();
        let weight = weight_that_keeps_energy(&base, &added, 0.25);
        assert!(weight <= expected && weight > 0.0, "{added}: {weight}");
        let with = |weight| {
            let mut added = added.clone();
            added.set_weight(weight).unwrap();
            let all = [base.components(), &[added]].concat();
            base.with_components(all).unwrap()
        };
        let status = |material: &Material| check_energy(material).unwrap().status;
        assert_eq!(status(&with(weight)), Status::Ok, "{added}: {weight}");
        if weight < 0.25 {
            assert_eq!(status(&with(weight + 0.02)), Status::Violated, "{added}");
        }
    }
    let mirror = mixture(&[(1.0, "specular_reflection")]);
    let lambert: Component = "lambertian_reflection".parse().unwrap();
    assert_eq!(weight_that_keeps_energy(&mirror, &lambert, 0.25), 0.0);
}
