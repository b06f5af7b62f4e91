use glam::DVec3;

use super::*;
use crate::timing::Stopwatch::NoClock;
use bxdf::Material;

fn study_of(text: &str) -> (Material, Option<DVec3>) {
    (text.parse().unwrap(), None)
}

/// The report of one family of `text`, without a clock.
fn report(text: &str, id: &str) -> Report {
    let (material, held) = study_of(text);
    let study = Study::new(&material, held);
    let family = FAMILIES
        .into_iter()
        .find(|family| family.id() == id)
        .unwrap();
    measure(&study, &[family], NoClock, &|| true, &mut |_, _| {}).unwrap()
}

fn family(text: &str, id: &str) -> FamilyReport {
    report(text, id).families.remove(0)
}

fn point<'a>(family: &'a FamilyReport, choice: &str) -> &'a Point {
    let found = family
        .points
        .iter()
        .find(|point| point.choice.starts_with(choice));
    found.unwrap_or_else(|| panic!("{choice}: {:?}", family.points))
}

#[test]
fn errors_fall_with_the_number_of_samples_as_theory_says() {
    // Smooth and wide: the theory is about smooth integrands.
    let found = family("rough_conductor:fresnel=one,alpha=0.8", "estimators");
    let slope = |choice: &str| found.slopes.get(choice).copied().flatten().unwrap();
    for method in ["uniform", "cosine", "importance"] {
        let plain = slope(&format!("{method}, plain"));
        assert!((plain + 0.5).abs() < 0.05, "{method}: {plain}");
        for sequence in ["stratified", "Sobol"] {
            let steep = slope(&format!("{method}, {sequence}"));
            assert!(steep < -0.7, "{method} {sequence}: {steep}");
        }
    }
    // Faster than any power: each doubling of the nodes gains more than the one before, until rounding.
    let errors: Vec<f64> = found
        .points
        .iter()
        .filter(|point| point.choice.starts_with("Gauss"))
        .map(|point| point.error_rms)
        .take_while(|error| *error > 1e-10)
        .collect();
    assert!(errors.len() >= 4, "{errors:?}");
    let gains: Vec<f64> = errors.windows(2).map(|pair| pair[0] / pair[1]).collect();
    assert!(
        gains.windows(2).all(|pair| pair[1] > 2.0 * pair[0]),
        "{errors:?}"
    );
    let last = found
        .points
        .iter()
        .rfind(|p| p.choice.starts_with("Gauss"))
        .unwrap();
    // Until what the quadrature that stands for the truth leaves uncertain.
    assert!(last.error_rms < 1e-10, "{last:?}");
}

#[test]
fn the_same_seed_gives_the_same_errors() {
    let [first, second] = [(); 2].map(|()| family("phong:exponent=20", "estimators"));
    assert_eq!(first, second);
}

#[test]
fn energy_missing_without_compensation_is_ln_2() {
    let found = family(
        "rough_conductor:fresnel=one,alpha=1,masking=separable,compensation=kulla_conty",
        "stand_ins",
    );
    let exact = point(&found, "as it is");
    assert_eq!((exact.error_rms, exact.error_max), (0.0, Some(0.0)));
    let without = found
        .points
        .iter()
        .find(|p| {
            p.material
                .as_ref()
                .is_some_and(|m| !m.to_string().contains("compensation"))
        })
        .unwrap();
    // The largest is at normal incidence or further down: never less than ln 2 there.
    let missing = without.albedo_error.unwrap();
    assert!(missing > 0.69, "{missing}");
}

#[test]
fn digits_cost_what_they_are_worth() {
    let found = family("rough_conductor", "precision");
    let error = |choice| point(&found, choice).error_rms;
    assert_eq!(error("double-double"), 0.0);
    let (single, double) = (
        error("f32, polynomials, widest"),
        error("f64, library functions, widest"),
    );
    assert!(single > 1e-9 && single < 1e-5, "{single}");
    assert!(double > 0.0 && double < 1e-13, "{double}");
    assert_eq!(
        error("f64, library functions, plain"),
        double,
        "the same formula, the same numbers"
    );
}

#[test]
fn polynomials_are_as_good_as_the_library_and_not_the_same() {
    // Its tail is an exponential.
    let found = family("rough_conductor:distribution=beckmann", "precision");
    let error = |choice| point(&found, choice).error_rms;
    let polynomials = error("f32, polynomials, plain");
    let library = error("f32, library functions, plain");
    assert!(library > 1e-9 && polynomials != library, "{library}");
    assert!(polynomials < 2.0 * library, "{polynomials} {library}");
}

#[test]
fn drawn_lobes_come_nearer_with_their_resolution() {
    for text in ["rough_conductor:alpha=0.5", "rough_dielectric:alpha=0.4"] {
        let found = family(text, "mesh");
        for kind in ["surface, uniform", "section, uniform"] {
            let errors: Vec<f64> = found
                .points
                .iter()
                .filter(|point| point.choice == kind)
                .map(|point| point.error_rms)
                .collect();
            let [first, .., last] = errors[..] else {
                panic!("{errors:?}")
            };
            assert!(
                last < 1e-3 && last < 0.05 * first,
                "{text} {kind}: {errors:?}"
            );
        }
        assert!(
            point(&found, "section, adaptive").error_rms < 1e-3,
            "{text}"
        );
        assert!(
            found
                .points
                .iter()
                .filter(|p| p.choice == "surface, adaptive")
                .all(|p| p.error_rms < 0.01)
        );
    }
}

#[test]
fn what_does_not_apply_says_why() {
    for id in ["estimators", "precision", "stand_ins", "mesh"] {
        let found = family("specular_reflection", id);
        assert!(found.points.is_empty());
        let reason = found.not_applicable.unwrap();
        assert!(reason.contains("Dirac deltas"), "{reason}");
    }
    let found = family("velvet", "stand_ins");
    assert!(found.not_applicable.is_some() || found.points.len() > 1);
}

#[test]
fn it_stops_when_nobody_wants_it_and_tells_how_far_it_is() {
    let (material, held) = study_of("lambertian_reflection");
    let study = Study::new(&material, held);
    assert_eq!(
        measure(&study, &FAMILIES, NoClock, &|| false, &mut |_, _| {}),
        None
    );
    let mut shares = Vec::new();
    let precision = FAMILIES.into_iter().filter(|f| f.id() != "estimators");
    let families: Vec<&dyn Family> = precision.collect();
    let found = measure(&study, &families, NoClock, &|| true, &mut |_, share| {
        shares.push(share);
    });
    assert!(found.is_some() && shares.is_sorted());
    assert_eq!(shares.last(), Some(&1.0));
}

#[test]
fn advice_holds_when_it_is_measured_again() {
    for text in ["rough_conductor:alpha=0.4", "eon:roughness=1"] {
        let material: Material = text.parse().unwrap();
        let study = Study::new(&material, None);
        let wanted = ["precision", "stand_ins"];
        let families: Vec<&dyn Family> = FAMILIES
            .into_iter()
            .filter(|f| wanted.contains(&f.id()))
            .collect();
        let report = measure(&study, &families, NoClock, &|| true, &mut |_, _| {}).unwrap();
        for tolerance in [0.3, 0.03] {
            let advice = advise(&report, tolerance);
            let chosen = advice.iter().find(|a| a.family == WHOLE).unwrap();
            assert!(chosen.met && chosen.error_rms <= tolerance, "{chosen:?}");
            let Some(stand_in) = &chosen.material else {
                continue;
            };
            // Independently: a plain product grid over both hemispheres, in f32 as advised. It is coarse near the horizon,
            // where the two differ most.
            let error = error_on_a_grid(&material, stand_in);
            assert!(
                (error / chosen.error_rms - 1.0).abs() < 0.25,
                "{text}: {error} {chosen:?}"
            );
        }
        let nothing = advise(&report, -1.0);
        assert!(!nothing.is_empty() && nothing.iter().all(|a| !a.met));
    }
}

/// The weighted root mean square of the relative difference, over a midpoint grid.
fn error_on_a_grid(exact: &Material, choice: &Material) -> f64 {
    const THETAS: u32 = 24;
    const PHIS: u32 = 32;
    let (exact, choice) = (exact.build::<f64>(), choice.build::<f32>());
    let directions: Vec<DVec3> = (0..THETAS)
        .flat_map(|i| (0..PHIS).map(move |j| (i, j)))
        .map(|(i, j)| {
            // Equal steps of sin^2: each direction stands for the same cosine times solid angle.
            let sin2 = (f64::from(i) + 0.5) / f64::from(THETAS);
            let (sin, cos) =
                (std::f64::consts::TAU * (f64::from(j) + 0.5) / f64::from(PHIS)).sin_cos();
            DVec3::new(sin2.sqrt() * cos, sin2.sqrt() * sin, (1.0 - sin2).sqrt())
        })
        .collect();
    let (mut difference, mut square) = (0.0, 0.0);
    for wo in &directions {
        for wi in &directions {
            let f = exact.f((*wo).into(), (*wi).into()).to_f64();
            let single = |w: DVec3| bxdf::math::Vec3::new(w.x as f32, w.y as f32, w.z as f32);
            let other = choice.f(single(*wo), single(*wi)).to_f64();
            for (a, b) in f.into_iter().zip(other) {
                difference += (a - b) * (a - b);
                square += a * a;
            }
        }
    }
    (difference / square).sqrt()
}

#[test]
fn a_material_without_a_cheaper_choice_is_advised_as_it_is() {
    // Alone, the stand-ins must name the material itself; with number formats beside them, those do.
    let found = report("eon", "stand_ins");
    let whole = |report: &Report| {
        let mut advice = advise(report, 1e-6).into_iter();
        advice.find(|one| one.family == WHOLE).unwrap()
    };
    let alone = whole(&found);
    assert!(
        alone.met && alone.choice.starts_with("as it is"),
        "{alone:?}"
    );
    let mut both = report("eon", "precision");
    both.families.extend(found.families);
    let advice = whole(&both);
    assert!(
        advice.met && advice.choice.starts_with("f32, "),
        "{advice:?}"
    );
}
