//! A table of values: a surface that was measured, or another model baked.
//!
//! # Source
//! Matusik et al. 2003 (`matusik2003`): values over half vector and difference (`rusinkiewicz1998`); see
//! [`Table`].
//!
//! # Departures
//! Other spacings and symmetries than theirs, see [`Table`]. Samples are drawn from the cosine and from a GGX lobe as wide
//! as the table's, half and half.
//!
//! # Validity
//! As good as the table: between nodes values are straight lines, and what is above the largest `f32` is cut off.

use std::sync::Arc;

use crate::common::*;
use crate::math::warp;
use crate::microfacet::ggx::Ggx;
use crate::microfacet::{Normals, Pair, evaluated_by_pair};
use crate::optics::Spectrum;
use crate::param::{ParamSet, ParamSpec};
use crate::sample_reflection;
use crate::table::{self, Table};

/// The name of its parameter.
const DATA: &str = "data";

/// What stands in the table before one is read, in 1/sr: four fifths of the light are reflected at most.
const EVEN: f32 = 0.4 * std::f32::consts::FRAC_1_PI;

/// The list entry.
pub(super) static SPEC: ModelSpec = ModelSpec {
    id: "table",
    title: "Table",
    source: "Matusik et al. 2003, A Data-Driven Reflectance Model",
    summary: "A surface as values over half vector and difference, and straight lines between them: what was measured, or \
              another model baked by the trade-off; before a file brings one, the law of Lommel and Seeliger",
    lobes: &[Lobe::reflection(Category::GlossySpecular)],
    parameters: &[ParamSpec::data(
        DATA,
        &[&table::TABLE],
        "The values: those of a file, or of a material that was baked",
    )],
    properties: Properties {
        is_isotropic: |params| {
            let table = params.data::<Table>(DATA);
            table.is_none_or(|table| table.shape().is_isotropic())
        },
        ..Properties::PLAIN
    },
    validate: ModelSpec::any,
    builders: builders!(build),
    // What it was made of is not known.
    stand_ins: &[],
};

struct Baked<R> {
    table: Arc<Table>,
    /// As wide as the table's lobe.
    normals: Ggx<R>,
}

fn build<R: Real>(params: &ParamSet) -> Box<dyn Scatterer<R>> {
    let table = params
        .data::<Table>(DATA)
        .unwrap_or_else(|| Arc::new(Table::even(EVEN)));
    let alpha = R::of(table.alpha());
    Box::new(Baked {
        normals: Ggx::new(alpha, alpha),
        table,
    })
}

impl<R: Real> Baked<R> {
    fn value(&self, pair: &Pair<R>) -> Spectrum<R> {
        self.table.value(pair.wo, pair.wi, pair.wh)
    }

    fn density(&self, pair: &Pair<R>) -> R {
        let half = R::of(0.5);
        let sum = warp::cosine_hemisphere_pdf(pair.wi.z) + self.normals.reflection_pdf(pair);
        (half * sum).saturated()
    }
}

impl<R: Real> Bxdf<R> for Baked<R> {
    evaluated_by_pair!(Pair::above);

    fn sample_f(&self, wo: Vec3<R>, _uc: R, [u, v]: [R; 2]) -> Option<Sample<R>> {
        // The square is halved, so that the lobe has one map.
        let (half, two) = (R::of(0.5), R::of(2.0));
        sample_reflection(self, wo, |wo| {
            if u < half {
                Some(warp::cosine_hemisphere([two * u, v]))
            } else {
                self.normals.sample_reflection(wo, [two * u - R::one(), v])
            }
        })
    }
}

impl<R: Real> Lobes<R> for Baked<R> {
    fn lobes(&self) -> &[Lobe] {
        SPEC.lobes
    }
}

impl<R: Real> Scatterer<R> for Baked<R> {
    loops!(R, if false);
}
