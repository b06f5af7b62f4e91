//! Properties that hold for every model at all parameters and directions, on cases that are drawn and shrunk.

#![allow(
    clippy::indexing_slicing,
    clippy::expect_used,
    reason = "a test's own helpers may fail as loudly as the test"
)]

use brdf_explorer::bxdf::math::{Real, Vec3};
use brdf_explorer::bxdf::models::MODELS;
use brdf_explorer::bxdf::param::{Kind, ParamSet, ParamSpec, Scale, Value};
use brdf_explorer::bxdf::{Component, ModelSpec, Scatterer, Side};
use brdf_explorer::lab::rounding::UNIT_LENGTH_ROUNDOFFS;
use proptest::collection::vec;
use proptest::prelude::*;

/// Cases of each property: some hundred for each model.
const CASES: u32 = 8192;

/// No model has more parameters than this.
const MOST_PARAMETERS: usize = 16;

/// A share of 0..1, its ends often.
fn share() -> impl Strategy<Value = f64> {
    prop_oneof![6 => 0.0..=1.0, 1 => Just(0.0), 1 => Just(1.0)]
}

/// The number at `share` of the parameter's range: evenly, or over the decades where its slider goes by decades.
fn number(spec: &ParamSpec, share: f64) -> f64 {
    let [min, max] = spec.hard;
    let x = if spec.scale == Scale::Logarithmic || max > 100.0 {
        let least = min.max(1e-8);
        if share == 0.0 {
            min
        } else {
            least * (max / least).powf(share)
        }
    } else {
        min + (max - min) * share
    };
    x.clamp(min, max)
}

fn value(spec: &ParamSpec, [a, b, c]: [f64; 3]) -> Value {
    match spec.kind {
        Kind::Number => Value::Number(number(spec, a)),
        Kind::Rgb => Value::Rgb([a, b, c].map(|share| number(spec, share))),
        Kind::Choice => {
            let last = spec.choices.len() - 1;
            Value::Choice(spec.choices[(a * spec.choices.len() as f64).min(last as f64) as usize])
        }
        Kind::Bool => Value::Bool(a < 0.5),
        Kind::Data => spec.default,
    }
}

/// A model at some parameters; it is told by its text.
#[derive(Clone)]
struct Made {
    model: &'static ModelSpec,
    params: ParamSet,
}

impl std::fmt::Debug for Made {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.params.component())
    }
}

fn made() -> impl Strategy<Value = Made> {
    let shares = vec([share(), share(), share()], MOST_PARAMETERS);
    (0..MODELS.len(), shares).prop_filter_map("the model refuses them", |(index, shares)| {
        let model = MODELS[index];
        assert!(model.parameters.len() <= MOST_PARAMETERS);
        let mut params = model.defaults();
        for (spec, shares) in model.parameters.iter().zip(shares) {
            params
                .set(spec.name, value(spec, shares))
                .expect("within the range");
        }
        (model.validate)(&params)
            .ok()
            .map(|()| Made { model, params })
    })
}

/// A unit direction: anywhere, or next to the horizon or the normal by decades.
fn direction() -> impl Strategy<Value = [f64; 3]> {
    let cosine = prop_oneof![
        4 => -1.0..=1.0_f64,
        1 => (-45.0..0.0).prop_map(|decade: f64| 10.0_f64.powf(decade)),
        1 => (-18.0..0.0).prop_map(|decade: f64| 1.0 - 10.0_f64.powf(decade)),
        1 => Just(1.0),
        1 => Just(0.0),
    ];
    (cosine, 0.0..std::f64::consts::TAU, any::<bool>()).prop_map(
        |(cos, phi, is_below): (f64, f64, bool)| {
            let sin = ((1.0 - cos) * (1.0 + cos)).max(0.0).sqrt();
            let z = if is_below { -cos } else { cos };
            [sin * phi.cos(), sin * phi.sin(), z]
        },
    )
}

fn in_precision<R: Real>([x, y, z]: [f64; 3]) -> Vec3<R> {
    Vec3::new(R::of(x), R::of(y), R::of(z))
}

fn is_good<R: Real>(x: R) -> bool {
    x.is_finite() && x >= R::zero()
}

/// `f` and `pdf` are finite and not negative, and the same together as each by itself.
fn values_are_good<R: Real>(
    bxdf: &dyn Scatterer<R>,
    wo: [f64; 3],
    wi: [f64; 3],
) -> Result<(), TestCaseError> {
    let (wo, wi) = (in_precision(wo), in_precision(wi));
    let (f, pdf) = (bxdf.f(wo, wi), bxdf.pdf(wo, wi));
    prop_assert!(
        f.0.into_iter().all(is_good) && is_good(pdf),
        "{}: f {f:?} pdf {pdf:?}",
        R::NAME
    );
    prop_assert_eq!(bxdf.f_pdf(wo, wi), (f, pdf));
    Ok(())
}

/// A sample is a unit vector on a side that has a lobe, with a density and a finite weight.
fn a_sample_is_good<R: Real>(
    model: &ModelSpec,
    bxdf: &dyn Scatterer<R>,
    wo: [f64; 3],
    u: [f64; 3],
) -> Result<(), TestCaseError> {
    let wo = in_precision(wo);
    let below_one = |u: f64| R::of(u).min(R::one() - R::of(R::UNIT_ROUNDOFF));
    let [uc, u, v] = u.map(below_one);
    let Some(sample) = bxdf.sample_f(wo, uc, [u, v]) else {
        return Ok(());
    };
    let off = (sample.wi.length_squared() - R::one()).as_f64().abs();
    prop_assert!(
        off <= UNIT_LENGTH_ROUNDOFFS * R::UNIT_ROUNDOFF,
        "{}: {sample:?}",
        R::NAME
    );
    let side = Side::between(wo, sample.wi);
    let has_side = model.lobes.iter().any(|lobe| lobe.side == side);
    prop_assert!(
        has_side && sample.wi.z != R::zero(),
        "{}: {sample:?}",
        R::NAME
    );
    let weight = sample.weight().0;
    prop_assert!(
        sample.pdf > R::zero() && weight.into_iter().all(is_good),
        "{}: {sample:?}",
        R::NAME
    );
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: CASES,
        // The cases are the same in every run; a failure is shrunk, and becomes a test of its own.
        rng_seed: proptest::test_runner::RngSeed::Fixed(8),
        failure_persistence: None,
        ..ProptestConfig::default()
    })]

    #[test]
    fn values_are_finite_and_not_negative(made in made(), wo in direction(), wi in direction()) {
        values_are_good(&*made.model.build::<f32>(&made.params), wo, wi)?;
        values_are_good(&*made.model.build::<f64>(&made.params), wo, wi)?;
    }

    #[test]
    fn samples_are_where_lobes_are(made in made(), wo in direction(), u in [share(), share(), share()]) {
        a_sample_is_good(made.model, &*made.model.build::<f32>(&made.params), wo, u)?;
        a_sample_is_good(made.model, &*made.model.build::<f64>(&made.params), wo, u)?;
    }

    #[test]
    fn texts_of_models_are_read_as_the_same(made in made()) {
        let text = made.params.component();
        let read: Component = text.parse().expect("its own text");
        prop_assert_eq!(read.model().id, made.model.id);
        prop_assert_eq!(read.params(), &made.params);
    }
}
