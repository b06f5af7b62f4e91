//! The laws that a person asks about first, checked while they wait: of one material, at a fraction of the work.

use super::law::{LawId, LawReport, Status};
use super::law_tally::Tallies;
use super::plan::{Effort, Plan};
use super::{cause, deltas, energy, finite, pointwise};
use crate::analysis::{Basis, Detail, IsWanted, Pace, Query, Subject, isotropy};
use crate::specimen::{Specimen, Witness};
use bxdf::Material;

/// The laws of [`check_physical`], in the order of its reports.
pub const PHYSICAL: [LawId; 4] = [
    LawId::Reciprocity,
    LawId::Energy,
    LawId::Finite,
    LawId::Isotropy,
];

/// Runs the laws of [`PHYSICAL`] for `material`, at its parameters only: tens of milliseconds. `None` as soon as it is
/// not wanted any more.
///
/// It sees less than [`check_material`](super::check_material): energy is integrated by the lobes' own maps, and the
/// report of isotropy is a measurement, which breaks its law only where a lobe declared isotropic is not: it is isotropic
/// while `worst` does not exceed `error`. What breaks is judged as there.
#[must_use]
pub fn check_physical(material: &Material, is_wanted: &dyn Fn() -> bool) -> Option<Vec<LawReport>> {
    let specimen = Specimen::at(material);
    let plan = Plan {
        effort: Effort::Quick,
        tests: 0,
    };
    let mut tallies = Tallies::default();
    pointwise::reciprocity(&specimen, &plan, &mut tallies);
    deltas::deltas(&specimen, &mut tallies);
    if !is_wanted() {
        return None;
    }
    for wi in energy::directions_of(material.components().iter()) {
        energy::energy_by_lobes(&specimen, wi, &mut tallies);
        if !is_wanted() {
            return None;
        }
    }
    finite::finite(&specimen, &plan, &mut tallies);
    if !is_wanted() {
        return None;
    }
    let measured = isotropy_of(&specimen);
    let mut reports = Vec::new();
    for report in tallies.into_reports() {
        if report.law == LawId::Isotropy {
            reports.push(measured.clone());
        } else if PHYSICAL.contains(&report.law) {
            reports.push(cause::judged(material, report));
        }
        if !is_wanted() {
            return None;
        }
    }
    Some(reports)
}

/// What [`check_physical`] finds, asked as a query.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PhysicalLaws;

impl Query for PhysicalLaws {
    type Answer = Vec<LawReport>;

    const BASIS: Basis = Basis::Material;

    const PACE: Pace = Pace::Background;

    fn answer(
        &self,
        of: &Subject<'_>,
        _: Detail,
        is_wanted: IsWanted<'_>,
    ) -> Option<Vec<LawReport>> {
        check_physical(of.material?, is_wanted)
    }
}

/// The law of energy of [`check_physical`] alone: milliseconds. There is a report of every law: it is never `None`.
#[must_use]
pub fn check_energy(material: &Material) -> Option<LawReport> {
    let specimen = Specimen::at(material);
    let mut tallies = Tallies::default();
    for wi in energy::directions_of(material.components().iter()) {
        energy::energy_by_lobes(&specimen, wi, &mut tallies);
    }
    let mut reports = tallies.into_reports();
    let found = reports.find(|report| report.law == LawId::Energy)?;
    Some(cause::judged(material, found))
}

/// Whether the lobe turns with the surface, as measured.
fn isotropy_of(specimen: &Specimen) -> LawReport {
    let change = isotropy::largest_change(&*specimen.double);
    let is_measured = change.deviation <= isotropy::MAX_DEVIATION;
    let status = if specimen.is_isotropic && !is_measured {
        Status::Violated
    } else {
        Status::Ok
    };
    let places = [("wo", change.wo), ("wi", change.wi)];
    let found: Vec<_> = places
        .into_iter()
        .filter_map(|(name, w)| Some((name, w?)))
        .collect();
    LawReport {
        law: LawId::Isotropy,
        status,
        worst: change.deviation,
        error: isotropy::MAX_DEVIATION,
        n: change.n,
        witness: if found.is_empty() {
            Witness::default()
        } else {
            specimen.witness(&found)
        },
        reason: String::new(),
    }
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;

    use super::*;
    use bxdf::material::library;
    use bxdf::models::MODELS;

    fn check(material: &Material) -> Vec<LawReport> {
        check_physical(material, &|| true).unwrap()
    }

    fn report(text: &str, law: LawId) -> LawReport {
        let mut reports = check(&text.parse().unwrap()).into_iter();
        reports.find(|report| report.law == law).unwrap()
    }

    /// The catalogue breaks nothing that it does not declare; the quick way may not say otherwise.
    #[test]
    fn no_material_of_the_catalogue_breaks_more_than_it_declares() {
        let models = MODELS.map(Material::of);
        let named = library::all().iter().map(|named| named.material.clone());
        for material in models.into_iter().chain(named) {
            let reports = check(&material);
            assert!(reports.iter().map(|report| report.law).eq(PHYSICAL));
            for report in reports {
                assert!(report.status.is_pass(), "{material}: {report:?}");
                assert!(report.n > 0, "{material}: {report:?}");
            }
        }
    }

    #[test]
    fn a_break_comes_with_its_place() {
        let broken = report("phong:diffuse=1,specular=1", LawId::Energy);
        assert_eq!(broken.status, Status::Declared, "{broken:?}");
        assert!(broken.worst > broken.error && broken.witness.wi.is_some());
        let broken = report("rough_conductor:compensation=turquin", LawId::Reciprocity);
        assert_eq!(broken.status, Status::Declared, "{broken:?}");
        assert!(broken.witness.wo.is_some() && broken.witness.wi.is_some());
    }

    #[test]
    fn weights_that_create_energy_are_a_break() {
        let two: Material = "lambertian_reflection:reflectance=1".parse().unwrap();
        let [only] = two.components() else { panic!() };
        let twice = two
            .with_components(vec![only.clone(), only.clone()])
            .unwrap();
        let reports = check(&twice);
        let energy = reports.iter().find(|report| report.law == LawId::Energy);
        let energy = energy.unwrap();
        assert_eq!(energy.status, Status::Violated);
        assert!((energy.worst - 1.0).abs() < 1e-3, "{energy:?}");
    }

    #[test]
    fn isotropy_is_measured() {
        let isotropic = report("rough_conductor:alpha=0.2", LawId::Isotropy);
        assert!(isotropic.worst <= isotropic.error);
        let blade = report("rough_conductor:alpha_x=0.2,alpha_y=0.4", LawId::Isotropy);
        assert!(blade.worst > blade.error && blade.status == Status::Ok);
        assert!(blade.witness.wo.is_some() && blade.witness.wi.is_some());
    }

    #[test]
    fn what_is_not_wanted_any_more_is_given_up() {
        let material: Material = "phong".parse().unwrap();
        let asked = Cell::new(0);
        let given_up = check_physical(&material, &|| {
            asked.set(asked.get() + 1);
            false
        });
        assert!(given_up.is_none() && asked.get() == 1);
    }
}
