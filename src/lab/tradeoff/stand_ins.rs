//! Stand-ins: what may replace a term or a lobe of this material, and what that saves and costs.

use glam::DVec3;

use super::bench::{Bench, Family, Measuring};
use super::precision::{Batch, values_in};
use super::report::{CostUnit, Point};
use super::study::{Stop, Study};
use crate::analysis::lobe::pair_values;
use bxdf::Material;
use bxdf::batch::Path;

/// At most this many stand-ins and combinations of them are measured.
const MOST: usize = 32;

/// At most this many are combined.
const MOST_TOGETHER: usize = 3;

/// The family.
pub(super) struct StandIns;

impl Family for StandIns {
    fn id(&self) -> &'static str {
        "stand_ins"
    }

    fn title(&self) -> &'static str {
        "Stand-ins"
    }

    fn cost_unit(&self) -> CostUnit {
        CostUnit::Evaluation
    }

    fn is_of_material(&self) -> bool {
        true
    }

    fn has_quick_errors(&self) -> bool {
        true
    }

    fn share(&self) -> f64 {
        1.0
    }

    fn measure<'a>(&'a self, study: &'a Study<'_>, bench: &'a mut Bench<'_>) -> Measuring<'a> {
        Box::pin(async move {
            let exact = |pairs: &[(DVec3, DVec3)]| pair_values(study.bxdf(), pairs);
            let baseline = study.baseline(&exact)?;
            bench.reference(
                "the material as it is; errors in f64, costs in f32 with the widest registers"
                    .to_owned(),
            );
            let candidates = candidates(study.material);
            if candidates.len() < 2 {
                let reason = "nothing is registered that could stand in for its terms, and it has no lobe to drop";
                return Err(Stop::NotApplicable(reason.to_owned()));
            }
            let pairs = &study.probe.pairs;
            let n = pairs.len() as f64;
            let mut batch = Batch::<f32>::new(pairs);
            for (index, candidate) in candidates.iter().enumerate() {
                bench.at(index as f64 / candidates.len() as f64).await?;
                let bxdf = candidate.material.build::<f64>();
                let single = candidate.material.build::<f32>();
                let errors =
                    baseline.errors(&|pairs: &[(DVec3, DVec3)]| pair_values(&*bxdf, pairs));
                let in_single = baseline.rms(&values_in(&*single, Path::Dispatched, pairs));
                let size = n / (1.0 + candidate.names.len() as f64);
                let cost = bench
                    .time(size, &mut || batch.run(&*single, Path::Dispatched))
                    .over(n);
                let point = Point::new(candidate.name())
                    .with_errors(errors)
                    .costing(cost);
                bench.point(Point {
                    error_rms_f32: Some(in_single),
                    lost: candidate.lost(),
                    material: Some(candidate.material.clone()),
                    ..point
                });
            }
            Ok(())
        })
    }
}

/// A material with some of its terms replaced or lobes dropped.
#[derive(Clone)]
struct Candidate {
    names: Vec<String>,
    lost: Vec<String>,
    material: Material,
}

impl Candidate {
    fn name(&self) -> String {
        if self.names.is_empty() {
            "as it is".to_owned()
        } else {
            self.names.join(" + ")
        }
    }

    fn lost(&self) -> Option<String> {
        (!self.lost.is_empty()).then(|| self.lost.join("; "))
    }

    /// It with one more thing replaced or dropped.
    fn next(&self) -> Vec<Self> {
        let components = self.material.components();
        let is_mixture = components.len() > 1;
        let mut next = Vec::new();
        let mut add = |name: String, lost: String, changed: Vec<_>| {
            // A stand-in of another index below the surface does not fit beside lobes that light crosses.
            let Ok(material) = self.material.with_components(changed) else {
                return;
            };
            let mut candidate = Self {
                material,
                ..self.clone()
            };
            candidate.names.push(name);
            candidate.lost.push(lost);
            next.push(candidate);
        };
        for (index, component) in components.iter().enumerate() {
            let of = if is_mixture {
                format!(" ({})", component.model().title)
            } else {
                String::new()
            };
            for (stand_in, replaced) in component.stand_ins() {
                let mut changed = components.to_vec();
                if let Some(slot) = changed.get_mut(index) {
                    *slot = replaced;
                }
                add(
                    format!("{}{of}", stand_in.name),
                    stand_in.lost.to_owned(),
                    changed,
                );
            }
            if is_mixture {
                let mut changed = components.to_vec();
                changed.remove(index);
                let title = component.model().title;
                add(
                    format!("without {title}"),
                    format!("all light of {title}"),
                    changed,
                );
            }
        }
        next
    }
}

/// `material` as it is, then its stand-ins, then their combinations, each once.
fn candidates(material: &Material) -> Vec<Candidate> {
    let mut all = vec![Candidate {
        names: Vec::new(),
        lost: Vec::new(),
        material: material.clone(),
    }];
    let mut looked_at = 0;
    while let Some(candidate) = all.get(looked_at).filter(|_| all.len() < MOST) {
        if candidate.names.len() < MOST_TOGETHER {
            for next in candidate.next() {
                let is_new = all.iter().all(|other| other.material != next.material);
                if is_new && all.len() < MOST {
                    all.push(next);
                }
            }
        }
        looked_at += 1;
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;
    use bxdf::material::library;

    #[test]
    fn combinations_are_made_once_and_lobes_are_dropped() {
        let found = candidates(&"rough_conductor:distribution=ggx".parse().unwrap());
        assert!(found.len() > 3 && found[0].name() == "as it is" && found[0].lost().is_none());
        let both = found.iter().filter(|c| c.names.len() == 2).count();
        assert!(both >= 1, "Schlick and separable masking together");
        for (index, candidate) in found.iter().enumerate() {
            let same = found
                .iter()
                .skip(index + 1)
                .filter(|c| c.material == candidate.material);
            assert_eq!(same.count(), 0, "{}", candidate.name());
            assert_eq!(candidate.names.len(), candidate.lost.len());
        }
        let mixture = &library::find("car_paint").unwrap().material;
        let count = mixture.components().len();
        let dropped = candidates(mixture);
        let dropped = dropped
            .iter()
            .filter(|c| c.material.components().len() == count - 1);
        assert!(count > 1 && dropped.count() >= count);
    }
}
