//! Estimates of a reflectance: what samples, sequences and quadratures cost, and how near they come.

mod method;
mod sequence;

use std::f64::consts::TAU;

use rayon::current_num_threads;
use rayon::prelude::*;

use crate::analysis::quadrature::Integral;
use crate::analysis::{HeldLobe, Hold};
use crate::timing::Timing;
use crate::tradeoff::bench::{Bench, Family, Measuring};
use crate::tradeoff::report::{CostUnit, Point};
use crate::tradeoff::study::{Stop, Study};
use bxdf::Side;
use bxdf::batch::Columns;
use bxdf::internals::gauss_legendre;
use bxdf::optics::spectrum::luminance;

use method::{Method, Surface};
use sequence::Sequence;

/// log2 of the fewest samples.
const FEWEST: u32 = 4;

/// Up to this log2 of the number of samples the error is that of [`SEEDS`] estimates, beyond it of [`FEW_SEEDS`].
const MANY_SEEDS_TO: u32 = 16;

/// Independent estimates of each kind.
const SEEDS: u32 = 32;

/// Those of them that are long.
const FEW_SEEDS: u32 = 4;

/// Up to this log2 of the number of samples an estimate is timed; longer ones cost in proportion.
const TIMED_TO: u32 = 14;

/// log2 of the nodes along either axis of the product rule.
const NODES: std::ops::RangeInclusive<u32> = 2..=9;

/// Relative errors asked of the adaptive quadrature.
const TOLERANCES: [f64; 6] = [1e-1, 1e-2, 1e-4, 1e-6, 1e-8, 1e-10];

/// The relative error asked of the quadrature that stands for the truth.
const REFERENCE_TOLERANCE: f64 = 1e-12;

/// How many values each of its lobes may take.
const REFERENCE_EVALUATIONS: usize = 2_000_000;

/// The family.
pub(super) struct Estimators;

impl Family for Estimators {
    fn id(&self) -> &'static str {
        "estimators"
    }

    fn title(&self) -> &'static str {
        "Estimators"
    }

    fn cost_unit(&self) -> CostUnit {
        CostUnit::Estimate
    }

    fn share(&self) -> f64 {
        8.0
    }

    fn measure<'a>(&'a self, study: &'a Study<'_>, bench: &'a mut Bench<'_>) -> Measuring<'a> {
        Box::pin(async move {
            let truth = Truth::of(study)?;
            let degrees = bxdf::math::frame::theta(study.held).to_degrees();
            bench.reference(format!(
                "rho_hd at {degrees:.0} degrees by adaptive quadrature, estimated relative error {:.0e}",
                truth.error / truth.rho
            ));
            let sides =
                [Side::Reflection, Side::Transmission].map(|side| study.material.has_side(side));
            let surface = Surface {
                bxdf: study.bxdf(),
                wo: study.held.into(),
                sides,
            };
            let kinds = Sequence::ALL
                .into_iter()
                .flat_map(|sequence| Method::ALL.map(|method| Sampled { method, sequence }));
            let kinds: Vec<Sampled> = kinds.collect();
            for (index, kind) in kinds.iter().enumerate() {
                bench.at(index as f64 / (kinds.len() + 1) as f64).await?;
                kind.measure(&surface, &truth, bench).await?;
            }
            bench
                .at(kinds.len() as f64 / (kinds.len() + 1) as f64)
                .await?;
            product_rule(&surface, &truth, bench).await?;
            adaptive(study, &truth, bench).await
        })
    }
}

/// What the estimates are held against.
struct Truth {
    /// The integral of f |cos|, without deltas, as luminance.
    continuous: f64,
    /// With them: what errors are relative to.
    rho: f64,
    /// The estimated absolute error of both.
    error: f64,
}

impl Truth {
    fn of(study: &Study<'_>) -> Result<Self, Stop> {
        let lobe = HeldLobe::new(study.bxdf(), Hold::Viewer, study.held);
        let total = |integrals: Vec<Integral>| {
            let value: f64 = integrals.iter().map(|lobe| luminance(lobe.value)).sum();
            let error: f64 = integrals.iter().map(|lobe| lobe.error).sum();
            (value, error)
        };
        let (rough, _) = total(lobe.integrals(1e-3, REFERENCE_EVALUATIONS));
        if rough <= 0.0 {
            let reason =
                "it has no light but in Dirac deltas, and those are added without an error";
            return Err(Stop::NotApplicable(reason.to_owned()));
        }
        let lobes = lobe.lobes().len().max(1) as f64;
        let tolerance = REFERENCE_TOLERANCE * rough / lobes;
        let (continuous, error) = total(lobe.integrals(tolerance, REFERENCE_EVALUATIONS));
        let deltas = study.bxdf().deltas(study.held.into()).into_iter().flatten();
        let deltas: f64 = deltas.map(|delta| luminance(delta.weight.to_f64())).sum();
        Ok(Self {
            continuous,
            rho: continuous + deltas,
            error,
        })
    }

    /// |error| / rho of an estimate of the continuous part.
    fn relative(&self, estimate: f64) -> f64 {
        (estimate - self.continuous).abs() / self.rho
    }
}

/// A point of the relative errors of independent estimates of `n` samples or nodes.
fn point(choice: &str, n: Option<u64>, errors: &[f64]) -> Point {
    let mean = errors.iter().map(|error| error * error).sum::<f64>() / errors.len().max(1) as f64;
    Point {
        n,
        error_rms: mean.sqrt(),
        error_max: Some(errors.iter().copied().fold(0.0, f64::max)),
        ..Point::new(choice)
    }
}

/// Samples of one kind.
struct Sampled {
    method: Method,
    sequence: Sequence,
}

impl Sampled {
    fn name(&self) -> String {
        format!("{}, {}", self.method.name(), self.sequence.name())
    }

    /// The terms of an estimate of 2^`log_n` samples.
    fn terms(&self, surface: &Surface<'_>, log_n: u32, seed: u32) -> Vec<f64> {
        let log_terms = log_n - self.method.samples_of_a_term().ilog2();
        let numbers = self.sequence.numbers(log_terms, 2 * seed);
        let others = if self.method == Method::Combined {
            self.sequence.numbers(log_terms, 2 * seed + 1)
        } else {
            sequence::Numbers::from_rows([])
        };
        self.method.terms(surface, &numbers, &others)
    }

    /// The errors of the estimates number `seed` of 2^[`FEWEST`] samples on, doubled again and again.
    fn errors(&self, surface: &Surface<'_>, truth: &Truth, seed: u32) -> Vec<f64> {
        let longest = if seed < FEW_SEEDS {
            self.sequence.longest()
        } else {
            MANY_SEEDS_TO
        };
        let mean = |terms: &[f64]| terms.iter().sum::<f64>() / terms.len() as f64;
        if !self.sequence.has_prefixes() {
            let error = |log_n| truth.relative(mean(&self.terms(surface, log_n, seed)));
            return (FEWEST..=longest).map(error).collect();
        }
        let terms = self.terms(surface, longest, seed);
        let (mut sum, mut done) = (0.0, 0);
        (FEWEST..=longest)
            .map(|log_n| {
                let n = (1_usize << log_n) / self.method.samples_of_a_term() as usize;
                sum += terms.get(done..n).unwrap_or_default().iter().sum::<f64>();
                done = n;
                truth.relative(sum / n as f64)
            })
            .collect()
    }

    async fn measure(
        &self,
        surface: &Surface<'_>,
        truth: &Truth,
        bench: &mut Bench<'_>,
    ) -> Result<(), Stop> {
        let name = self.name();
        // Each by itself, the same on any number of threads; on one of them each is a step.
        let at_once = if current_num_threads() > 1 { SEEDS } else { 1 };
        let mut errors: Vec<Vec<f64>> = Vec::new();
        for first in (0..SEEDS).step_by(at_once as usize) {
            let seeds = (first..first + at_once).into_par_iter();
            let some = seeds.map(|seed| self.errors(surface, truth, seed));
            errors.extend(some.collect::<Vec<_>>());
            bench.wanted().await?;
        }
        let mut last = None;
        for (place, log_n) in (FEWEST..=self.sequence.longest()).enumerate() {
            bench.wanted().await?;
            let n = 1_u64 << log_n;
            let here: Vec<f64> = errors
                .iter()
                .filter_map(|run| run.get(place).copied())
                .collect();
            let cost = if log_n <= TIMED_TO {
                bench.time(n as f64, &mut || {
                    std::hint::black_box(self.terms(surface, log_n, 0).iter().sum::<f64>());
                })
            } else {
                let (timed, cost): (u64, Timing) = last.unwrap_or_default();
                cost.over(timed as f64 / n as f64)
            };
            if log_n <= TIMED_TO {
                last = Some((n, cost));
            }
            bench.point(point(&name, Some(n), &here).costing(cost));
        }
        Ok(())
    }
}

/// Gauss-Legendre nodes in the cosine times as many in the azimuth, over each side.
async fn product_rule(
    surface: &Surface<'_>,
    truth: &Truth,
    bench: &mut Bench<'_>,
) -> Result<(), Stop> {
    let is_above = surface.wo.z > 0.0;
    let signs: Vec<f64> = [is_above, !is_above]
        .into_iter()
        .zip(surface.sides)
        .filter_map(|(is_up, is_lit)| is_lit.then_some(if is_up { 1.0 } else { -1.0 }))
        .collect();
    for log_nodes in NODES {
        bench.wanted().await?;
        let rule = gauss_legendre(1 << log_nodes);
        let (mut wi, mut weights) = (Vec::new(), Vec::new());
        for sign in &signs {
            for (x, weight) in &rule {
                let mu = 0.5 * (1.0 + x);
                let radius = (0.5 * (1.0 - x) * (1.0 + mu)).sqrt();
                for (y, other) in &rule {
                    let (sin, cos) = (0.5 * TAU * (1.0 + y)).sin_cos();
                    wi.push([radius * cos, radius * sin, sign * mu]);
                    weights.push(0.25 * TAU * weight * other);
                }
            }
        }
        let wi = Columns::from_rows(wi);
        let sum = || {
            let values = surface.values(&wi);
            values
                .iter()
                .zip(&weights)
                .map(|(f, weight)| f * weight)
                .sum::<f64>()
        };
        let n = weights.len() as u64;
        let cost = bench.time(n as f64, &mut || {
            std::hint::black_box(sum());
        });
        let point = point("Gauss-Legendre product", Some(n), &[truth.relative(sum())]);
        bench.point(point.costing(cost));
    }
    Ok(())
}

/// The adaptive quadrature at several tolerances.
async fn adaptive(study: &Study<'_>, truth: &Truth, bench: &mut Bench<'_>) -> Result<(), Stop> {
    let lobe = HeldLobe::new(study.bxdf(), Hold::Viewer, study.held);
    let lobes = lobe.lobes().len().max(1) as f64;
    for tolerance in TOLERANCES {
        bench.wanted().await?;
        let estimate = || {
            let parts = lobe.integrals(tolerance * truth.rho / lobes, REFERENCE_EVALUATIONS);
            let value: f64 = parts.iter().map(|part| luminance(part.value)).sum();
            let evaluations: usize = parts.iter().map(|part| part.evaluations).sum();
            (value, evaluations)
        };
        let (value, evaluations) = estimate();
        let cost = bench.time(evaluations as f64, &mut || {
            std::hint::black_box(estimate());
        });
        let n = Some(evaluations as u64);
        let point = point("adaptive quadrature", n, &[truth.relative(value)]);
        bench.point(point.costing(cost));
    }
    Ok(())
}
