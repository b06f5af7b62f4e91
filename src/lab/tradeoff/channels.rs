//! Channels: three colours against many wavelengths, for metals whose optical constants are known over the spectrum.

use glam::DVec3;

use super::bench::{Bench, Family, Measuring};
use super::precision::{Batch, by_pair, values_in};
use super::report::{CostUnit, Point};
use super::study::{Stop, Study};
use crate::spectral::{Constants, FINEST, RANGE_NM, rgb_weights};
use bxdf::batch::{Columns, Path};
use bxdf::param::{Kind, Role, Value};
use bxdf::{Component, Material, Precision, Scatterer};

/// How many wavelengths are tried.
const COUNTS: [usize; 3] = [8, 16, 31];

/// The family.
pub(super) struct Channels;

impl Family for Channels {
    fn id(&self) -> &'static str {
        "channels"
    }

    fn title(&self) -> &'static str {
        "Wavelengths"
    }

    fn cost_unit(&self) -> CostUnit {
        CostUnit::Evaluation
    }

    fn share(&self) -> f64 {
        0.2
    }

    fn measure<'a>(&'a self, study: &'a Study<'_>, bench: &'a mut Bench<'_>) -> Measuring<'a> {
        Box::pin(async move {
            let substances = substances(study.material).map_err(Stop::NotApplicable)?;
            let finest = Spectral::<f64>::new(study.material, &substances, FINEST);
            let exact = |pairs: &[(DVec3, DVec3)]| finest.values(pairs);
            let baseline = study.baseline(&exact)?;
            let [start, end] = RANGE_NM;
            bench.reference(format!(
                "{FINEST} wavelengths from {start} to {end} nm, n and k of {}, seen under D65 by the CIE 1931 observer",
                names(&substances)
            ));
            let pairs = &study.probe.pairs;
            let n = pairs.len() as f64;
            let mut batch = Batch::<f32>::new(pairs);
            bench.wanted().await?;
            let rgb = study.material.build::<f32>();
            let cost = bench
                .time(n, &mut || batch.run(&*rgb, Path::Dispatched))
                .over(n);
            let values =
                |pairs: &[(DVec3, DVec3)]| values_in(study.bxdf(), Path::Dispatched, pairs);
            let point = Point::new("RGB").with_errors(baseline.errors(&values));
            bench.point(Point {
                material: Some(study.material.clone()),
                ..point.costing(cost)
            });
            for (index, count) in COUNTS.into_iter().enumerate() {
                bench
                    .at((index + 1) as f64 / (COUNTS.len() + 1) as f64)
                    .await?;
                let fine = Spectral::<f64>::new(study.material, &substances, count);
                let errors = baseline.errors(&|pairs: &[(DVec3, DVec3)]| fine.values(pairs));
                let single = Spectral::<f32>::new(study.material, &substances, count);
                let mut sum = Columns::filled(0.0_f32, pairs.len());
                let size = n * single.parts.len() as f64;
                let cost = bench.time(size, &mut || single.add_up(&mut batch, &mut sum));
                let point = Point::new("wavelengths").with_errors(errors);
                bench.point(Point {
                    n: Some(count as u64),
                    ..point.costing(cost.over(n))
                });
            }
            Ok(())
        })
    }
}

/// The optical constants of each component of `material`; none for one that is grey. Or why there is no spectrum.
fn substances(material: &Material) -> Result<Vec<Option<&'static Constants>>, String> {
    let of = |component: &Component| {
        let found = Constants::of(component);
        if is_grey(component, found.is_some()) {
            Ok(found)
        } else {
            let title = component.model().title;
            Err(format!(
                "the colours of {title} are given as red, green and blue, not by wavelength"
            ))
        }
    };
    let all: Result<Vec<_>, String> = material.components().iter().map(of).collect();
    let all = all?;
    if all.iter().all(Option::is_none) {
        let reason = "none of its lobes has the n and k of a substance of assets/ior";
        return Err(reason.to_owned());
    }
    Ok(all)
}

/// Whether no parameter has a colour; the indices may, where they are those of a substance.
fn is_grey(component: &Component, has_constants: bool) -> bool {
    let params = component.params();
    let mut colours = params.iter().filter(|(spec, _)| {
        let is_index = has_constants && matches!(spec.role, Role::Index | Role::Absorption);
        spec.kind == Kind::Rgb && params.is_relevant(spec) && !is_index
    });
    colours.all(|(_, value)| match value {
        Value::Rgb([r, g, b]) => r == g && g == b,
        _ => true,
    })
}

fn names(substances: &[Option<&'static Constants>]) -> String {
    let mut ids: Vec<&str> = substances.iter().flatten().map(|one| one.id).collect();
    ids.dedup();
    ids.join(" and ")
}

/// A material by wavelength: models have three channels, so it is several materials of three wavelengths each.
struct Spectral<R> {
    parts: Vec<Part<R>>,
}

/// Three wavelengths.
struct Part<R> {
    bxdf: Box<dyn Scatterer<R>>,
    /// What the value at each adds to R, G and B.
    weights: [[f64; 3]; 3],
}

impl<R: Precision> Spectral<R> {
    /// `material` at `count` wavelengths.
    fn new(material: &Material, substances: &[Option<&'static Constants>], count: usize) -> Self {
        let all = rgb_weights(count);
        let parts = all.chunks(3).filter_map(|some| {
            let last = some.last()?.0;
            // The last part may have fewer than three: what it repeats has no weight.
            let at = |index: usize| some.get(index).copied().unwrap_or((last, [0.0; 3]));
            let triple = [at(0), at(1), at(2)];
            let components = material.components().iter().zip(substances);
            let components = components.map(|(component, substance)| match substance {
                Some(constants) => with_indices(component, constants, triple.map(|(nm, _)| nm)),
                None => Some(component.clone()),
            });
            let components: Option<Vec<Component>> = components.collect();
            Some(Part {
                bxdf: material.with_components(components?).ok()?.build::<R>(),
                weights: triple.map(|(_, weights)| weights),
            })
        });
        Self {
            parts: parts.collect(),
        }
    }

    /// f as R, G and B in 1/sr at the pairs of `batch`, into `sum`.
    fn add_up(&self, batch: &mut Batch<R>, sum: &mut Columns<R, 3>) {
        let mut sum = sum.slices_mut();
        for channel in &mut sum {
            channel.fill(R::zero());
        }
        for part in &self.parts {
            batch.run(&*part.bxdf, Path::Dispatched);
            for (values, weights) in batch.values().slices().into_iter().zip(part.weights) {
                for (channel, weight) in sum.iter_mut().zip(weights.map(R::of)) {
                    for (sum, value) in channel.iter_mut().zip(values) {
                        *sum = *sum + weight * *value;
                    }
                }
            }
        }
    }

    fn values(&self, pairs: &[(DVec3, DVec3)]) -> Vec<[f64; 3]> {
        let mut sum = Columns::filled(R::zero(), pairs.len());
        self.add_up(&mut Batch::new(pairs), &mut sum);
        by_pair(&sum)
    }
}

/// `component` with n and k at three wavelengths in nm for its three channels; `None` where it does not take them.
fn with_indices(
    component: &Component,
    constants: &Constants,
    wavelengths: [f64; 3],
) -> Option<Component> {
    let indices = wavelengths.map(|nm| constants.at(nm));
    let mut params = component.params().clone();
    let (n, k) = (indices.map(|[n, _]| n), indices.map(|[_, k]| k));
    for (role, values) in [(Role::Index, n), (Role::Absorption, k)] {
        let (spec, _) = params.of_role(role)?;
        params.set(spec.name, Value::Rgb(values)).ok()?;
    }
    let mut changed = component.clone();
    changed.set_all(&params).ok()?;
    Some(changed)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::timing::Stopwatch::NoClock;
    use crate::tradeoff::measure;
    use bxdf::material::library;

    fn reasons(text: &str) -> String {
        substances(&library::read(text).unwrap()).unwrap_err()
    }

    #[test]
    fn what_has_no_spectrum_says_why() {
        assert!(reasons("rough_conductor:eta=0.3,k=3").contains("assets/ior"));
        assert!(reasons("chalk").contains("red, green and blue"));
        let gold = library::read("gold").unwrap();
        assert_eq!(names(&substances(&gold).unwrap()), "gold");
    }

    #[test]
    fn more_wavelengths_are_nearer_than_three_colours() {
        let gold = library::read("gold").unwrap();
        let study = Study::new(&gold, None);
        let report = measure(&study, &[&Channels], NoClock, &|| true, &mut |_, _| {});
        let points = report.unwrap().families.remove(0).points;
        let [rgb, eight, sixteen, many] = &points[..] else {
            panic!("{points:?}");
        };
        // Three colours follow the spectrum but for the red of gold, which lies outside sRGB by 4 %. With n and k read at three
        // wavelengths they were 7 % off, and plain to see: a difference of 6.
        assert!(rgb.error_rms < 0.04, "{rgb:?}");
        assert!(rgb.delta_e.unwrap() < 3.0, "{rgb:?}");
        assert!(eight.error_rms < rgb.error_rms, "{eight:?}");
        assert!(sixteen.error_rms < eight.error_rms, "{sixteen:?}");
        assert!(
            many.error_rms < sixteen.error_rms && many.delta_e.unwrap() < 0.2,
            "{many:?}"
        );
        assert_eq!([eight.n, sixteen.n, many.n], [8, 16, 31].map(Some));
    }

    #[test]
    fn a_grey_spectrum_is_the_material_itself() {
        // Without constants, every wavelength has the same value, and the weights of a channel sum to 1.
        let material: Material = "lambertian_reflection:reflectance=0.4".parse().unwrap();
        let spectral = Spectral::<f64>::new(&material, &[None], 8);
        let w = DVec3::new(0.6, 0.0, 0.8);
        let [value] = spectral.values(&[(w, DVec3::Z)])[..] else {
            panic!("one value");
        };
        let exact = 0.4 * std::f64::consts::FRAC_1_PI;
        assert!(value.iter().all(|x| (x - exact).abs() < 1e-15), "{value:?}");
    }
}
