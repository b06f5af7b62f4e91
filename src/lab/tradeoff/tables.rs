//! Tables: the material baked into values over half vector and difference, of growing resolution.

use std::sync::Arc;

use glam::DVec3;

use super::bench::{Bench, Family, Measuring};
use super::precision::{Batch, values_in};
use super::report::{CostUnit, Point};
use super::study::{Stop, Study};
use crate::analysis::lobe::pair_values;
use bxdf::batch::Path;
use bxdf::error::Result;
use bxdf::resource::Decoded;
use bxdf::table::{Shape, Table};
use bxdf::{Component, Material, Resource, Side};

/// Nodes along each coordinate.
const COUNTS: [usize; 8] = [4, 8, 12, 16, 24, 32, 48, 64];

/// The most memory that a table may take: a larger one is refused before anything is allocated.
const MAX_BYTES: u64 = 64 << 20;

/// A table up to this size is a material to choose; a larger one would make files of many megabytes.
const MAX_KEPT_BYTES: u64 = 2 << 20;

/// The family.
pub(super) struct Tables;

impl Family for Tables {
    fn id(&self) -> &'static str {
        "tables"
    }

    fn title(&self) -> &'static str {
        "Tables"
    }

    fn cost_unit(&self) -> CostUnit {
        CostUnit::Evaluation
    }

    fn is_of_material(&self) -> bool {
        true
    }

    fn share(&self) -> f64 {
        1.0
    }

    fn measure<'a>(&'a self, study: &'a Study<'_>, bench: &'a mut Bench<'_>) -> Measuring<'a> {
        Box::pin(async move {
            let exact = |pairs: &[(DVec3, DVec3)]| pair_values(study.bxdf(), pairs);
            let baseline = study.baseline(&exact)?;
            if study.material.has_side(Side::Transmission) {
                let reason = "light crosses it, and the table is of what is reflected";
                return Err(Stop::NotApplicable(reason.to_owned()));
            }
            let is_isotropic = study.material.is_isotropic();
            let shapes: Vec<Shape> = COUNTS
                .into_iter()
                .filter_map(|n| Shape::of(n, is_isotropic).ok())
                .collect();
            bench.reference(reference(&shapes));
            let pairs = &study.probe.pairs;
            let n = pairs.len() as f64;
            let mut batch = Batch::<f32>::new(pairs);
            bench.wanted().await?;
            let formula = study.material.build::<f32>();
            let cost = bench
                .time(n, &mut || batch.run(&*formula, Path::Dispatched))
                .over(n);
            let values = |pairs: &[(DVec3, DVec3)]| values_in(&*formula, Path::Dispatched, pairs);
            let point = Point::new("formula, f32").with_errors(baseline.errors(&values));
            bench.point(Point {
                error_rms_f32: Some(point.error_rms),
                ..point.costing(cost)
            });
            for (index, shape) in shapes.iter().enumerate() {
                bench.at(index as f64 / shapes.len() as f64).await?;
                // What is too large stands in the text of the reference.
                let Ok(material) = baked(study, *shape) else {
                    continue;
                };
                let (double, single) = (material.build::<f64>(), material.build::<f32>());
                let errors =
                    baseline.errors(&|pairs: &[(DVec3, DVec3)]| pair_values(&*double, pairs));
                let cost = bench
                    .time(4.0 * n, &mut || batch.run(&*single, Path::Dispatched))
                    .over(n);
                let point = Point::new("table").with_errors(errors).costing(cost);
                bench.point(Point {
                    n: Some(shape.nodes() as u64),
                    bytes: Some(shape.bytes()),
                    lost: Some(format!("what lies between its {shape} nodes")),
                    material: (shape.bytes() <= MAX_KEPT_BYTES).then_some(material),
                    ..point
                });
            }
            Ok(())
        })
    }
}

/// What the tables are held against, and which of them are too large.
fn reference(shapes: &[Shape]) -> String {
    let refused = shapes
        .iter()
        .filter_map(|shape| shape.within(MAX_BYTES).err());
    let refused: Vec<String> = refused.map(|error| error.to_string()).collect();
    let mut text =
        "the material's formula in f64, without Dirac deltas; theta_h by square roots".to_owned();
    if !refused.is_empty() {
        text.push_str("; refused: ");
        text.push_str(&refused.join("; "));
    }
    text
}

/// The material of `study` as a table, as a material of its own.
fn baked(study: &Study<'_>, shape: Shape) -> Result<Material> {
    let table = Table::bake(study.bxdf(), shape, MAX_BYTES)?;
    let resource = match study.material.recipe(shape) {
        Some(recipe) => Resource::baked(recipe, table),
        None => Resource::inline(Arc::new(Decoded::table(table))),
    };
    let mut component: Component = "table".parse()?;
    component.set_resource("data", resource)?;
    Ok(Material::from(component))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::timing::Stopwatch::NoClock;
    use crate::tradeoff::{FamilyReport, measure};

    fn report(text: &str) -> FamilyReport {
        let material: Material = text.parse().unwrap();
        let study = Study::new(&material, None);
        let report = measure(&study, &[&Tables], NoClock, &|| true, &mut |_, _| {});
        report.unwrap().families.remove(0)
    }

    #[test]
    fn finer_tables_err_less_and_are_materials() {
        let found = report("oren_nayar:sigma=30");
        let [_, tables @ ..] = &found.points[..] else {
            panic!("{found:?}");
        };
        assert_eq!(tables.len(), COUNTS.len());
        let errors: Vec<f64> = tables.iter().map(|point| point.error_rms).collect();
        assert!(
            errors.windows(2).all(|pair| pair[1] < pair[0]),
            "{errors:?}"
        );
        let last = tables.last().unwrap();
        assert!(last.error_rms < 2e-3, "{errors:?}");
        assert_eq!(last.bytes, Some(64 * 64 * 64 * 12));
        // The finest is too large to be kept.
        assert!(last.material.is_none());
        let kept = tables.iter().rev().find_map(|point| point.material.clone());
        let material = kept.unwrap();
        // The error of the material itself, apart from the family.
        let exact: Material = "oren_nayar:sigma=30".parse().unwrap();
        let [exact, table] = [exact, material].map(|material| material.build::<f64>());
        let w = |x: f64, y: f64| DVec3::new(x, y, (1.0 - x * x - y * y).sqrt());
        let pairs = [(w(0.3, 0.1), w(-0.5, 0.2)), (w(0.1, 0.7), w(0.2, 0.4))];
        let [exact, table] = [exact, table].map(|bxdf| pair_values(&*bxdf, &pairs));
        for (a, b) in exact.iter().zip(&table) {
            assert!((a[0] / b[0] - 1.0).abs() < 0.02, "{a:?} {b:?}");
        }
    }

    #[test]
    fn what_does_not_fit_is_said_and_not_made() {
        let found = report("ward:alpha_x=.2,alpha_y=.5");
        assert!(
            found
                .reference
                .contains("refused: the table is of 64x64x64x64 nodes, 192.0 MiB"),
            "{}",
            found.reference
        );
        assert_eq!(found.points.len(), COUNTS.len());
        let kept = found.points.iter().filter(|point| point.material.is_some());
        assert!(kept.count() < found.points.len() - 1);
        let glass = report("rough_dielectric").not_applicable.unwrap();
        assert!(glass.contains("light crosses"), "{glass}");
    }
}
