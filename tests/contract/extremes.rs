//! The extremes: no model gives out there, each fault that others have is seen when provoked, and the table of the
//! documentation is current.

use brdf_explorer::bxdf::Catalogue;
use brdf_explorer::bxdf::models::MODELS;
use brdf_explorer::bxdf::{ModelSpec, Properties};
use brdf_explorer::lab::stability::table::Row;
use brdf_explorer::lab::stability::{Extreme, ExtremeKind, examine, examine_material};
use rayon::prelude::*;

use crate::faulty::*;

/// The table of the documentation, as `check --all --extremes --markdown` writes it.
const TABLE: &str = include_str!("../../src/lab/stability/table.md");

/// Of the sets of parameters every so manieth is examined here; `check --all --extremes` examines all.
const STRIDE: usize = 24;

/// Random points of each model here.
const RANDOM: u64 = 256;

/// By what factor the table may differ from what is measured.
const CURRENT: f64 = 2.0;

/// Ratios this small are no news, whatever their factor.
const SMALL: f64 = 0.02;

fn line(id: &str, extreme: &Extreme) -> String {
    format!("{id}: {extreme:?}")
}

#[test]
fn no_model_gives_out_at_the_extremes_and_the_table_holds() {
    let rows: Vec<Row> = TABLE.lines().filter_map(Row::read).collect();
    let failures: Vec<String> = MODELS
        .par_iter()
        .flat_map(|model| {
            let extremes = examine(model, STRIDE, RANDOM);
            let unstable = extremes.iter().filter(|extreme| !extreme.is_stable());
            let mut failures: Vec<String> =
                unstable.map(|extreme| line(model.id, extreme)).collect();
            for precision in ["f32", "f64"] {
                let mut rows = rows.iter();
                let row = rows.find(|row| row.model == model.id && row.precision == precision);
                let found = extremes.iter().filter(|extreme| {
                    extreme.precision == precision && extreme.case != ExtremeKind::Core
                });
                let of_values = found.filter(|extreme| {
                    !matches!(
                        extreme.case,
                        ExtremeKind::SamplerEnds | ExtremeKind::Reciprocity | ExtremeKind::Random
                    )
                });
                let largest = of_values
                    .map(|extreme| extreme.max_bound_ratio)
                    .fold(0.0, f64::max);
                match row {
                    Some(row) if largest <= CURRENT * row.ratio.max(SMALL) => {}
                    _ => failures.push(format!(
                        "{} {precision}: {largest} found, the table says {row:?}",
                        model.id
                    )),
                }
            }
            failures
        })
        .collect();
    assert!(failures.is_empty(), "\n{}", failures.join("\n"));
}

#[test]
fn the_places_of_the_table_are_as_it_says() {
    let rows: Vec<Row> = TABLE.lines().filter_map(Row::read).collect();
    assert_eq!(rows.len(), 2 * MODELS.len());
    for row in rows {
        let Some(anew) = row.measured_anew() else {
            assert!(row.ratio < SMALL, "{row:?}");
            continue;
        };
        let least = row.ratio.max(SMALL) / CURRENT;
        let most = row.ratio.max(SMALL) * CURRENT;
        assert!(
            (least..=most).contains(&anew.max(SMALL)),
            "{anew} anew: {row:?}"
        );
    }
}

#[test]
fn every_extreme_is_reached() {
    // The whole grid of glass, which has an index, widths, a colourless Fresnel term and a critical angle.
    let glass = examine(
        Catalogue::current().find("rough_dielectric").unwrap(),
        STRIDE,
        RANDOM,
    );
    let silver = examine(
        Catalogue::current().find("rough_conductor").unwrap(),
        STRIDE,
        RANDOM,
    );
    for case in ExtremeKind::ALL {
        let mut all = glass.iter().chain(&silver);
        let found = all.any(|extreme| extreme.case == case && extreme.n > 0);
        // One in so many sets of parameters need not meet each of their extremes; a crowd is asked for by itself.
        let is_optional = case < ExtremeKind::Ladder || case == ExtremeKind::Crowd;
        assert!(found || is_optional, "{}", case.id());
    }
    let mirror = examine_material(&"rough_conductor:alpha=.001".parse().unwrap());
    assert!(mirror.iter().all(Extreme::is_stable), "{mirror:?}");
}

/// What is found of a model with this fault.
fn provoked<const FAULT: usize>() -> Vec<Extreme> {
    let model: &'static ModelSpec = Box::leak(Box::new(faulty::<FAULT>(Properties::PLAIN)));
    examine(model, 1, RANDOM)
}

fn sum(extremes: &[Extreme], of: fn(&Extreme) -> u64) -> u64 {
    extremes.iter().map(of).sum()
}

/// The largest ratio at an extreme in a precision.
fn ratio(extremes: &[Extreme], case: ExtremeKind, precision: &str) -> f64 {
    let is_it = |extreme: &&Extreme| extreme.case == case && extreme.precision == precision;
    extremes
        .iter()
        .find(is_it)
        .map_or(f64::NAN, |extreme| extreme.max_bound_ratio)
}

#[test]
fn faults_are_seen_when_they_are_provoked() {
    let lawful = provoked::<NOTHING>();
    assert!(lawful.iter().all(Extreme::is_stable), "{lawful:?}");
    assert!(sum(&provoked::<NAN_AT_GRAZING>(), |extreme| extreme.non_finite) > 0);
    assert!(
        sum(&provoked::<NEGATIVE_AT_GRAZING>(), |extreme| extreme
            .negative)
            > 0
    );
    assert!(sum(&provoked::<LONG_SAMPLES>(), |extreme| extreme.misplaced) > 0);
    let single_off = provoked::<SINGLE_OFF>();
    assert!(ratio(&single_off, ExtremeKind::Ladder, "f32") > 10.0);
    assert!(ratio(&single_off, ExtremeKind::Ladder, "f64") < 1.0);
    assert!(ratio(&provoked::<OTHER_WEIGHT>(), ExtremeKind::SamplerEnds, "f64") > 1e3);
    assert!(ratio(&provoked::<LOPSIDED>(), ExtremeKind::Reciprocity, "f64") > 1e3);
    let stepped = provoked::<STEPPED>();
    assert!(ratio(&stepped, ExtremeKind::Jumps, "reference") > 1e3);
    // The same step in every precision is no error.
    assert!(ratio(&stepped, ExtremeKind::Ladder, "f64") < 1.0);
}
