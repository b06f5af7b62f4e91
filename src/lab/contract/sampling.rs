//! The laws that samples keep: what they are, how they are distributed, and what they average to.

use glam::DVec3;

use super::integrals::{CellIntegral, Channels, ESTIMATE};
use super::law::LawId;
use super::law_tally::Tallies;
use super::partition::Partition;
use super::plan::Plan;
use super::statistics::sidak;
use super::sweep::directions;
use super::{energy, lobes};
use crate::analysis::statistics::{Random, chi_square};
use crate::rounding::{UNIT_LENGTH_ROUNDOFFS, relative_difference};
use crate::specimen::Specimen;
use bxdf::math::{Real, Vec3};
use bxdf::optics::Spectrum;
use bxdf::{Deltas, Sample};

/// Samples that cut the sphere into cells: 64 cells of 32.
const PILOTS: u32 = 2048;

/// Absolute error wanted in each cell of [`Partition::integrate`]: 64 cells stay below 1e-4, a tenth of what the
/// rates are known to.
const CELL_TOLERANCE: f64 = 1e-6;

/// Standard errors within which a mean must lie.
const STANDARD_ERRORS: f64 = 4.0;

/// A share of the samples rarer than this over their number goes unseen with a probability of e^-6 = .25 %, and then
/// the standard error does not know of it either.
const UNSEEN: f64 = 6.0;

/// A density that two evaluations of the same formula at the same direction give may differ by rounding only; 1e-9
/// leaves room for the condition number of the narrowest lobe, 1e4 per component, and a sample rounded once.
const SAME: f64 = 1e-9;

/// The laws of the samples at every given direction, and energy, whose integrals come with theirs.
pub(super) fn sampling(specimen: &Specimen, plan: &Plan, tallies: &mut Tallies) {
    for (index, wo) in directions().into_iter().enumerate() {
        // Seeds of their own, so that the tests of a run are independent, as Sidak's correction takes them to be.
        let mut random = Random::new(specimen.seed() ^ index as u64);
        let pilots = pilot_samples(specimen, wo, &mut random, tallies);
        let partition = Partition::new(specimen, wo, &pilots, &mut random);
        let integrals = partition.integrate(|wi| integrands(specimen, wo, wi), CELL_TOLERANCE);
        goodness_of_fit(
            specimen,
            wo,
            plan,
            &partition,
            &integrals,
            &mut random,
            tallies,
        );
        let total = CellIntegral::sum(&integrals);
        means(specimen, wo, plan, &total, &mut random, tallies);
        let [_, _, _, _, back @ ..] = total.value;
        lobes::integrals(specimen, wo, (back, total.error), tallies);
        energy::energy(specimen, wo, (back, total.error), tallies);
    }
}

/// What is integrated over the directions `wi`: the density at `wo`, and f |cos| of each channel towards `wo` and back.
fn integrands(specimen: &Specimen, wo: DVec3, wi: DVec3) -> Channels {
    let (o, i): (Vec3<f64>, Vec3<f64>) = (wo.into(), wi.into());
    let (Spectrum([r, g, b]), pdf) = specimen.double.f_pdf(o, i);
    let [r_back, g_back, b_back] = specimen.double.f(i, o).0;
    let back_cos = wi.z.abs();
    let cos = back_cos * specimen.flux_factor(wo, wi);
    [
        pdf,
        r * cos,
        g * cos,
        b * cos,
        r_back * back_cos,
        g_back * back_cos,
        b_back * back_cos,
    ]
}

fn draw(specimen: &Specimen, wo: DVec3, random: &mut Random) -> Option<Sample<f64>> {
    let (uc, u) = (random.unit(), random.pair());
    specimen.double.sample_f(wo.into(), uc, u)
}

/// Draws samples, checks each by itself, and returns the directions of those that are no deltas.
fn pilot_samples(
    specimen: &Specimen,
    wo: DVec3,
    random: &mut Random,
    tallies: &mut Tallies,
) -> Vec<DVec3> {
    let deltas = specimen.double.deltas(wo.into());
    let mut directions = Vec::new();
    for _ in 0..PILOTS {
        let Some(sample) = draw(specimen, wo, random) else {
            continue;
        };
        check_sample(specimen, wo, &sample, &deltas, tallies);
        if !sample.is_delta {
            directions.push(sample.wi.into());
        }
    }
    directions
}

fn check_sample(
    specimen: &Specimen,
    wo: DVec3,
    sample: &Sample<f64>,
    deltas: &Deltas<f64>,
    tallies: &mut Tallies,
) {
    let wi: DVec3 = sample.wi.into();
    let witness = || specimen.witness(&[("wo", wo), ("sampled wi", wi)]);
    let length_error = (sample.wi.length_squared() - 1.0).abs();
    let unit_length = UNIT_LENGTH_ROUNDOFFS * f64::UNIT_ROUNDOFF;
    tallies.record(LawId::Weight, length_error, unit_length, witness);
    tallies.require(LawId::Support, sample.pdf > 0.0 && wi.z != 0.0, witness);
    let (f, pdf) = if sample.is_delta {
        let Some(delta) = deltas
            .iter()
            .flatten()
            .find(|delta| delta.direction == sample.wi)
        else {
            tallies.require(LawId::Support, false, witness);
            return;
        };
        (delta.sample().f, delta.probability)
    } else {
        let wo = wo.into();
        (
            specimen.double.f(wo, sample.wi),
            specimen.double.pdf(wo, sample.wi),
        )
    };
    let pdf_error = relative_difference(sample.pdf, pdf);
    tallies.record(LawId::Weight, pdf_error, SAME, witness);
    for ((sampled, value), weight) in sample.f.0.into_iter().zip(f.0).zip(sample.weight().0) {
        tallies.record(
            LawId::Weight,
            relative_difference(sampled, value),
            SAME,
            witness,
        );
        // weight * pdf = f |cos|, with the model's own pdf and f.
        let weighted = relative_difference(weight * pdf, value * wi.z.abs());
        tallies.record(LawId::Weight, weighted, SAME, witness);
    }
}

/// Chi-square test of the samples against the integrals of `pdf`, with one bin per cell, per delta, and for no sample.
fn goodness_of_fit(
    specimen: &Specimen,
    wo: DVec3,
    plan: &Plan,
    partition: &Partition<'_>,
    integrals: &[CellIntegral],
    random: &mut Random,
    tallies: &mut Tallies,
) {
    let n = plan.effort.samples();
    let deltas: Vec<(Vec3<f64>, f64)> = specimen
        .double
        .deltas(wo.into())
        .into_iter()
        .flatten()
        .map(|delta| (delta.direction, delta.probability))
        .collect();
    let expected = integrals
        .iter()
        .map(pdf_of)
        .chain(deltas.iter().map(|(_, probability)| *probability));
    let mut bins: Vec<(f64, f64)> = expected.map(|share| (0.0, share * f64::from(n))).collect();
    let sum: f64 = bins.iter().map(|(_, expected)| expected).sum();
    let mut lost = (0.0, (f64::from(n) - sum).max(0.0));
    for _ in 0..n {
        let bin = draw(specimen, wo, random).and_then(|sample| {
            let index = if sample.is_delta {
                integrals.len() + deltas.iter().position(|(w, _)| *w == sample.wi)?
            } else {
                partition.cell_of(sample.wi.into(), random)?
            };
            bins.get_mut(index)
        });
        bin.unwrap_or(&mut lost).0 += 1.0;
    }
    bins.push(lost);
    if let Some(test) = chi_square(&bins) {
        // A p-value of 0 has no logarithm; beyond 300 digits nothing is told apart.
        let digits = |p: f64| -p.max(1e-300).log10();
        let witness = || specimen.witness(&[("wo", wo)]);
        tallies.record(
            LawId::Sampling,
            digits(test.p_value),
            digits(sidak(plan.tests)),
            witness,
        );
    }
}

/// The integral of `pdf` over a cell: its first channel.
fn pdf_of(integral: &CellIntegral) -> f64 {
    let [pdf, ..] = integral.value;
    pdf
}

/// Compares the rate of samples and their mean weight with the integrals; weights as flux: the radiance seen from a dense
/// medium would make one sample in millions count for a million.
fn means(
    specimen: &Specimen,
    wo: DVec3,
    plan: &Plan,
    total: &CellIntegral,
    random: &mut Random,
    tallies: &mut Tallies,
) {
    let found = Stratified::new(specimen, wo, plan.effort.strata(), random);
    let [pdf, r, g, b, ..] = total.value;
    let mut expected = [pdf, r, g, b];
    for delta in specimen.double.deltas(wo.into()).into_iter().flatten() {
        let [r, g, b] = delta.flux.0;
        expected
            .iter_mut()
            .zip([0.0, r, g, b])
            .for_each(|(sum, x)| *sum += x);
    }
    let channels = found
        .mean
        .into_iter()
        .zip(found.variance)
        .zip(found.largest)
        .zip(expected);
    for (channel, (((mean, variance), largest), expected)) in channels.enumerate() {
        let law = if channel == 0 {
            LawId::PdfIntegral
        } else {
            LawId::MeanWeight
        };
        // Rounding of a mean of n numbers and of the weights themselves, where nothing else is left.
        let rounding = 1e-9 * expected.abs();
        let error = STANDARD_ERRORS * variance.sqrt()
            + UNSEEN / found.n * largest
            + ESTIMATE * total.error
            + rounding;
        let witness = || {
            format!(
                "{}: mean {mean}, integral {expected}",
                specimen.witness(&[("wo", wo)])
            )
        };
        tallies.record(law, (mean - expected).abs(), error, witness);
    }
}

/// Means over a stratified set of samples: of "is a sample and no delta", and of the weight's three channels.
struct Stratified {
    mean: [f64; 4],
    /// The variance of the mean, from the differences of the two samples of each stratum.
    variance: [f64; 4],
    largest: [f64; 4],
    n: f64,
}

impl Stratified {
    fn new(specimen: &Specimen, wo: DVec3, strata: u32, random: &mut Random) -> Self {
        let mut sums = Self {
            mean: [0.0; 4],
            variance: [0.0; 4],
            largest: [0.0; 4],
            n: 2.0 * f64::from(strata) * f64::from(strata),
        };
        for i in 0..strata {
            for j in 0..strata {
                let mut value = || {
                    let uc = random.unit();
                    let [u, v] = random.pair();
                    let u = [f64::from(i) + u, f64::from(j) + v].map(|x| x / f64::from(strata));
                    let sample = specimen.double.sample_f(wo.into(), uc, u);
                    sample.map_or([0.0; 4], |sample| {
                        let flux = specimen.flux_factor(wo, sample.wi.into());
                        let [r, g, b] = sample.weight().0.map(|weight| weight * flux);
                        [f64::from(u8::from(!sample.is_delta)), r, g, b]
                    })
                };
                sums.add(value(), value());
            }
        }
        sums
    }

    fn add(&mut self, a: [f64; 4], b: [f64; 4]) {
        let n = self.n;
        let slots = self
            .mean
            .iter_mut()
            .zip(&mut self.variance)
            .zip(&mut self.largest);
        for (((mean, variance), largest), (a, b)) in slots.zip(a.into_iter().zip(b)) {
            *mean += (a + b) / n;
            *variance += (a - b) * (a - b) / (n * n);
            *largest = largest.max(a).max(b);
        }
    }
}
