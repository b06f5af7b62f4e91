//! Resolutions of what is drawn: the lobe's surface and its section.

use std::f64::consts::{PI, TAU};

use glam::DVec3;

use super::bench::{Bench, Family, Measuring};
use super::report::{CostUnit, Point};
use super::study::{Stop, Study};
use crate::analysis::lobe3d::{self, Mesh};
use crate::analysis::polar::{self, Section};
use crate::analysis::reflectance::MAX_EVALUATIONS;
use crate::analysis::{Detail, HeldLobe, Hold, RadialScale};
use bxdf::math::frame;
use bxdf::optics::spectrum::luminance;

/// Halvings of the octahedron's edges.
const LEVELS: std::ops::RangeInclusive<u32> = 2..=8;

/// Intervals of a half circle, as powers of 2.
const STEPS_LOG2: std::ops::RangeInclusive<u32> = 4..=14;

/// The relative error asked of the reflectance that stands for the truth.
const TOLERANCE: f64 = 1e-9;

/// Parts into which each interval of the adaptive section is cut for the integral that stands for the truth.
const FINER: usize = 16;

/// The family.
pub(super) struct Resolutions;

impl Family for Resolutions {
    fn id(&self) -> &'static str {
        "mesh"
    }

    fn title(&self) -> &'static str {
        "Resolution"
    }

    fn cost_unit(&self) -> CostUnit {
        CostUnit::Build
    }

    fn share(&self) -> f64 {
        1.0
    }

    fn measure<'a>(&'a self, study: &'a Study<'_>, bench: &'a mut Bench<'_>) -> Measuring<'a> {
        Box::pin(async move {
            let lobe = HeldLobe::new(study.bxdf(), Hold::Viewer, study.held);
            bench.reference(
                "the lobe's integral by quadrature; that of its section by a far finer one"
                    .to_owned(),
            );
            let parts = lobe.integrals(TOLERANCE, MAX_EVALUATIONS / 4);
            let rho: f64 = parts.iter().map(|part| luminance(part.value)).sum();
            if rho <= 0.0 {
                let reason = "its light is all in Dirac deltas, which are drawn as arrows";
                return Err(Stop::NotApplicable(reason.to_owned()));
            }
            let mesh_point = |choice: &str, mesh: &Mesh| {
                let bytes = size_of_val(&mesh.vertices[..]) + size_of_val(&mesh.triangles[..]);
                Point {
                    n: Some(mesh.triangles.len() as u64),
                    bytes: Some(bytes as u64),
                    error_rms: (luminance(mesh.integral()) / rho - 1.0).abs(),
                    ..Point::new(choice)
                }
            };
            for level in LEVELS {
                bench.wanted().await?;
                let mesh = lobe3d::uniform(&lobe, level);
                let size = mesh.triangles.len() as f64;
                let cost = bench.time(size, &mut || {
                    std::hint::black_box(lobe3d::uniform(&lobe, level));
                });
                bench.point(mesh_point("surface, uniform", &mesh).costing(cost));
            }
            bench.at(0.5).await?;
            let request = lobe3d::Request {
                scale: RadialScale::Linear,
                with_cosine: true,
            };
            for (choice, detail) in [
                ("surface, adaptive, first answer", Detail::Coarse),
                ("surface, adaptive", Detail::Full),
            ] {
                let build =
                    || lobe3d::mesh_while(&lobe, &request, detail, &|| true).unwrap_or_default();
                let mesh = build();
                let cost = bench.time(mesh.triangles.len() as f64 * 4.0, &mut || {
                    std::hint::black_box(build());
                });
                bench.point(mesh_point(choice, &mesh).costing(cost));
            }
            bench.at(0.8).await?;
            sections(&lobe, bench).await
        })
    }
}

/// The choices of the section through the held direction.
async fn sections(lobe: &HeldLobe<'_>, bench: &mut Bench<'_>) -> Result<(), Stop> {
    let request = polar::Request {
        phi: frame::phi(lobe.held()),
        with_cosine: true,
        scale: RadialScale::Linear,
    };
    let adaptive = polar::section(lobe, &request);
    let arcs = arcs(&adaptive);
    let total = |angles_of: &dyn Fn(&Arc) -> Vec<f64>| -> f64 {
        let areas = arcs
            .iter()
            .map(|arc| area(lobe, request.phi, &angles_of(arc), arc.is_upper));
        areas.sum()
    };
    let truth = total(&|arc| finer(&arc.angles));
    if truth <= 0.0 {
        return Ok(());
    }
    let point = |choice: &str, n: usize, area: f64| Point {
        n: Some(n as u64),
        bytes: Some((n * size_of::<polar::Point>()) as u64),
        error_rms: (area / truth - 1.0).abs(),
        ..Point::new(choice)
    };
    for steps in STEPS_LOG2.map(|log| 1_u32 << log) {
        bench.wanted().await?;
        let build = || -> f64 {
            total(&|arc| {
                let middle = if arc.is_upper { 0.0 } else { PI };
                let angle = |i| middle + PI * (f64::from(i) / f64::from(steps) - 0.5);
                (0..=steps).map(angle).collect()
            })
        };
        let n = arcs.len() * (steps as usize + 1);
        let cost = bench.time(n as f64, &mut || {
            std::hint::black_box(build());
        });
        bench.point(point("section, uniform", n, build()).costing(cost));
    }
    let n = adaptive.upper.len() + adaptive.lower.len();
    let own = total(&|arc| arc.angles.clone());
    let cost = bench.time(4.0 * n as f64, &mut || {
        std::hint::black_box(polar::section(lobe, &request));
    });
    bench.point(point("section, adaptive", n, own).costing(cost));
    Ok(())
}

/// The angles of half a section.
struct Arc {
    is_upper: bool,
    /// Those of the lower half from pi/2 to 3 pi/2, without the step at pi.
    angles: Vec<f64>,
}

/// The halves of `section` that are not empty.
fn arcs(section: &Section) -> Vec<Arc> {
    let upper = section.upper.iter().map(|point| point.angle).collect();
    let lower = section
        .lower
        .iter()
        .map(|point| point.angle.rem_euclid(TAU));
    let lower = lower.collect();
    let mut arcs: Vec<Arc> = [(true, upper), (false, lower)]
        .into_iter()
        .map(|(is_upper, angles)| Arc { is_upper, angles })
        .collect();
    arcs.retain(|arc| !arc.angles.is_empty());
    arcs
}

/// The integral of the luminance of f |cos| over the angle, by the chords between `angles`, which rise or fall.
fn area(lobe: &HeldLobe<'_>, phi: f64, angles: &[f64], is_upper: bool) -> f64 {
    let directions: Vec<DVec3> = angles
        .iter()
        .map(|angle| polar::direction(*angle, phi))
        .collect();
    let values = lobe.values_or_limits(&directions, is_upper);
    let heights: Vec<f64> = values
        .iter()
        .zip(&directions)
        .map(|(f, w)| luminance(*f) * w.z.abs())
        .collect();
    let chords = heights.windows(2).zip(angles.windows(2));
    let part = |(heights, angles): (&[f64], &[f64])| match (heights, angles) {
        ([a, b], [from, to]) => 0.5 * (a + b) * (to - from).abs(),
        _ => 0.0,
    };
    chords.map(part).sum()
}

/// `angles` with [`FINER`] parts to each interval.
fn finer(angles: &[f64]) -> Vec<f64> {
    let parts = |pair: &[f64]| match pair {
        [a, b] => (0..FINER)
            .map(|i| a + (b - a) * i as f64 / FINER as f64)
            .collect(),
        _ => Vec::new(),
    };
    let mut all: Vec<f64> = angles.windows(2).flat_map(parts).collect();
    all.extend(angles.last());
    all
}
