//! One point: a pair of directions, in one precision against the reference.

use glam::DVec3;
use xprec::Df64;

use super::ExtremeKind;
use super::directions::Pair;
use super::extreme_tally::{Finding, Tally};
use crate::rounding::{
    Quantity, WHOLE, condition_numbers, is_subnormal, quantities, relative_difference,
    stability_bound,
};
use crate::specimen::Specimen;
use bxdf::Scatterer;
use bxdf::math::{Real, Vec3};

/// A precision with the models of a specimen in it.
pub(crate) struct Tested<'a, R: Real> {
    pub(crate) specimen: &'a Specimen,
    pub(super) model: &'a dyn Scatterer<R>,
    /// At the parameters as `R` has them.
    pub(super) exact: &'a dyn Scatterer<Df64>,
}

/// `specimen` in f32.
pub(crate) fn single(specimen: &Specimen) -> Tested<'_, f32> {
    Tested {
        specimen,
        model: &*specimen.single,
        exact: &*specimen.reference_of_single,
    }
}

/// `specimen` in f64.
pub(crate) fn double(specimen: &Specimen) -> Tested<'_, f64> {
    Tested {
        specimen,
        model: &*specimen.double,
        exact: &*specimen.reference,
    }
}

/// `specimen` in the reference precision, which nothing is held against.
pub(super) fn reference(specimen: &Specimen) -> Tested<'_, Df64> {
    Tested {
        specimen,
        model: &*specimen.reference,
        exact: &*specimen.reference,
    }
}

/// Whether a component is a subnormal number: it has lost the digits by whose rounding the stability law measures.
fn has_subnormal<R: Real>(w: Vec3<R>) -> bool {
    let least = R::min_positive_value();
    [w.x, w.y, w.z]
        .iter()
        .any(|x| *x != R::zero() && x.abs() < least)
}

/// The largest number, times a reflectance that a model may multiply by at last.
const SATURATED: f64 = 1e-6;

/// How far an edge may be from a pair, in roundings of the directions.
const EDGE_ROUNDOFFS: f64 = 8.0;

/// The number of `R` nearest to the reference's.
fn truth_in<R: Real>(exact: Df64) -> f64 {
    // Beyond the range of the type models saturate.
    exact.as_f64().min(R::max_value().as_f64())
}

impl<R: Real> Tested<'_, R> {
    /// The numbers of the reference at a pair as `R` has it.
    fn exact_at(&self, (wo, wi): Pair) -> [Df64; 4] {
        let (wo, wi): (Vec3<R>, Vec3<R>) = (wo.into(), wi.into());
        let (wo, wi): Pair = (wo.into(), wi.into());
        quantities(self.exact, wo.into(), wi.into())
    }

    /// The largest relative error at a pair, and by how much it uses up its bound, if that is more than `floor`.
    pub(crate) fn compare(&self, pair: Pair, floor: f64) -> Finding {
        self.compare_with(pair, self.exact_at(pair), floor)
    }

    /// [`Self::compare`] with the reference's numbers there.
    fn compare_with(&self, (wo, wi): Pair, exact: [Df64; 4], floor: f64) -> Finding {
        let (wo, wi): (Vec3<R>, Vec3<R>) = (wo.into(), wi.into());
        // The directions as `R` has them, which both sides see.
        let (wo_rounded, wi_rounded): Pair = (wo.into(), wi.into());
        let found = quantities(self.model, wo, wi);
        let zero = R::zero();
        let mut finding = Finding {
            is_not_finite: found.iter().any(|x| !x.is_finite()),
            is_negative: found.iter().any(|x| *x < zero),
            ..Finding::default()
        };
        if has_subnormal(wo) || has_subnormal(wi) {
            return finding;
        }
        let well_conditioned = stability_bound(0.0, R::UNIT_ROUNDOFF);
        let mut errors = [0.0; 4];
        for (slot, quantity) in errors.iter_mut().zip(Quantity::ALL) {
            let truth = truth_in::<R>(quantity.of(exact));
            let value = quantity.of(found).as_f64();
            if is_subnormal::<R>(truth) && is_subnormal::<R>(value) {
                continue;
            }
            if value == truth {
                continue;
            }
            let is_saturated = truth >= R::max_value().as_f64() && value >= SATURATED * truth;
            if is_saturated || truth == 0.0 && self.is_at_edge(quantity, (wo_rounded, wi_rounded)) {
                continue;
            }
            *slot = relative_difference(value, truth);
            finding.relative_error = finding.relative_error.max(*slot);
        }
        if finding.relative_error <= floor * well_conditioned {
            return finding;
        }
        // From this condition number on the ratio is not above the floor.
        let enough = errors.map(|error| error / (floor * well_conditioned) - 1.0);
        let kappas = self.condition_numbers((wo_rounded, wi_rounded), enough);
        for quantity in Quantity::ALL {
            let bound = stability_bound(quantity.of(kappas), R::UNIT_ROUNDOFF);
            let ratio = quantity.of(errors) / bound;
            if ratio > finding.ratio {
                finding.ratio = ratio;
                finding.what = match quantity {
                    Quantity::Pdf => "pdf",
                    Quantity::F(_) => "f",
                };
            }
        }
        finding
    }

    fn condition_numbers(&self, pair: Pair, enough: [f64; 4]) -> [f64; 4] {
        let models = (self.exact, &*self.specimen.neighbours);
        condition_numbers(models, pair, R::UNIT_ROUNDOFF, enough)
    }

    /// Whether the quantity, 0 at a pair, is not 0 within the rounding of the directions: the relative error of a number that
    /// vanishes there says nothing.
    fn is_at_edge(&self, quantity: Quantity, (wo, wi): Pair) -> bool {
        let reach = EDGE_ROUNDOFFS * R::UNIT_ROUNDOFF;
        let moved = |w: DVec3, axis: usize, by: f64| {
            let factor = DVec3::ONE + DVec3::AXES.into_iter().nth(axis).unwrap_or(DVec3::ZERO) * by;
            Vec3::<Df64>::from(w * factor)
        };
        (0..3).any(|axis| {
            [reach, -reach].into_iter().any(|by| {
                let at = [
                    quantities(self.exact, moved(wo, axis, by), wi.into()),
                    quantities(self.exact, wo.into(), moved(wi, axis, by)),
                ];
                at.into_iter().any(|all| quantity.of(all).as_f64() > 0.0)
            })
        })
    }

    /// Compares with the reference's numbers at `pair`, and counts it under `cases`.
    fn measure(&self, cases: &[ExtremeKind], pair: Pair, exact: [Df64; 4], tally: &mut Tally) {
        let finding = self.compare_with(pair, exact, tally.largest_ratio(cases, R::NAME));
        tally.add(cases, R::NAME, finding, || self.at(pair));
    }

    /// The point as it is reported.
    pub(crate) fn at(&self, (wo, wi): Pair) -> (String, DVec3, DVec3) {
        let (wo, wi): (Vec3<R>, Vec3<R>) = (wo.into(), wi.into());
        (self.specimen.name.clone(), wo.into(), wi.into())
    }
}

impl<R: Real> Tested<'_, R> {
    /// Holds the two ways of a pair against each other: n_i^2 f(wo, wi) = n_o^2 f(wi, wo).
    pub(super) fn two_ways(&self, (wo, wi): Pair, tally: &mut Tally) {
        let (o, i): (Vec3<R>, Vec3<R>) = (wo.into(), wi.into());
        let (wo, wi): Pair = (o.into(), i.into());
        let [n_o, n_i] = [wo, wi].map(|w| self.specimen.index_at(w));
        if has_subnormal(o) || has_subnormal(i) {
            return;
        }
        let (there, back) = (self.model.f(o, i), self.model.f(i, o));
        let floor = tally.largest_ratio(&[ExtremeKind::Reciprocity], R::NAME);
        let mut finding = Finding {
            what: "f",
            ..Finding::default()
        };
        let channels = there.to_f64().into_iter().zip(back.to_f64());
        for (channel, (there, back)) in channels.enumerate() {
            let is_readable = |f: f64| !is_subnormal::<R>(f) && f < R::max_value().as_f64();
            if !is_readable(there) || !is_readable(back) {
                continue;
            }
            let error = relative_difference(n_i * n_i * there, n_o * n_o * back);
            finding.relative_error = finding.relative_error.max(error);
            let mut ratio = error / stability_bound(0.0, R::UNIT_ROUNDOFF);
            if ratio > floor.max(finding.ratio) {
                let kappa = Quantity::F(channel).of(self.condition_numbers((wo, wi), WHOLE));
                ratio = error / stability_bound(kappa, R::UNIT_ROUNDOFF);
                finding.ratio = finding.ratio.max(ratio);
            }
        }
        tally.add(&[ExtremeKind::Reciprocity], R::NAME, finding, || {
            (self.specimen.name.clone(), wo, wi)
        });
    }
}

/// Whether nothing is seen at a pair: f and pdf are 0, in the reference precision.
pub(super) fn is_black(specimen: &Specimen, (wo, wi): Pair) -> bool {
    let values = quantities(&*specimen.reference, wo.into(), wi.into());
    values.iter().all(|x| x.as_f64() == 0.0)
}

/// Compares at `pair` in every precision, and counts it under `cases`; of the reference, whether it is finite and not negative.
pub(super) fn measure(specimen: &Specimen, cases: &[ExtremeKind], pair: Pair, tally: &mut Tally) {
    let (single, double) = (single(specimen), double(specimen));
    single.measure(cases, pair, single.exact_at(pair), tally);
    let exact = double.exact_at(pair);
    double.measure(cases, pair, exact, tally);
    let finding = Finding {
        is_not_finite: exact.iter().any(|x| !x.as_f64().is_finite()),
        is_negative: exact.iter().any(|x| x.as_f64() < 0.0),
        ..Finding::default()
    };
    tally.add(cases, Df64::NAME, finding, || double.at(pair));
}
