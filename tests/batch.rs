//! A batch gives what single calls give.

#![allow(
    clippy::unwrap_used,
    clippy::indexing_slicing,
    reason = "a test's own helpers may fail as loudly as the test"
)]

use brdf_explorer::bxdf::Rotated;
use brdf_explorer::bxdf::batch::{Job, Path};
use brdf_explorer::bxdf::material::library;
use brdf_explorer::bxdf::math::{Real, Vec3};
use brdf_explorer::bxdf::models::MODELS;
use brdf_explorer::bxdf::optics::Spectrum;
use brdf_explorer::bxdf::{Material, Precision, Scatterer};

/// Directions of a spiral over the sphere, `n` of them, as components.
fn spiral<R: Real>(n: usize, turn: f64) -> [Vec<R>; 3] {
    let at = |i: usize| {
        let z = 1.0 - (2.0 * i as f64 + 1.0) / n as f64;
        let (sin, cos) = (turn * i as f64).sin_cos();
        let radius = (1.0 - z * z).sqrt();
        [radius * cos, radius * sin, z]
    };
    [0, 1, 2].map(|axis: usize| (0..n).map(|i| R::of(at(i)[axis])).collect())
}

fn batches_give_what_single_calls_give<R: Precision>(n: usize) {
    let (wo, wi) = (spiral::<R>(n, 2.4), spiral::<R>(n, 1.7));
    let numbers = spiral::<R>(n, 0.9).map(|axis| {
        let half = R::of(0.4999);
        axis.into_iter()
            .map(|x| x * half + half)
            .collect::<Vec<R>>()
    });
    let [uc, u, v] = &numbers;
    let at = |d: &[Vec<R>; 3], i: usize| Vec3::new(d[0][i], d[1][i], d[2][i]);
    let mixture = library::find("road_sign").unwrap();
    let models = MODELS
        .into_iter()
        .map(|model| (model.id, Material::of(model)));
    let surfaces = models
        .chain([(mixture.id, mixture.material.clone())])
        .flat_map(|(id, material)| {
            // By a quarter: turning is exact, and so is turning back.
            let turned = Rotated::new(material.build::<R>(), (R::zero(), R::one()));
            [(id, material.build::<R>()), (id, Box::new(turned))]
        });
    for (id, bxdf) in surfaces {
        for path in [Path::Plain, Path::Dispatched] {
            let mut all: Vec<Vec<R>> = vec![vec![R::zero(); n]; 8];
            let wo_in = wo.each_ref().map(Vec::as_slice);
            let wi_in = wi.each_ref().map(Vec::as_slice);
            let [x, y, z, r, g, b, pdf, delta] = all.each_mut_slices();
            let f = [&mut *r, &mut *g, &mut *b];
            bxdf.batch(
                path,
                Job::FPdf {
                    wo: wo_in,
                    wi: wi_in,
                    f,
                    pdf: &mut *pdf,
                },
            );
            for k in 0..n {
                let single = bxdf.f(at(&wo, k), at(&wi, k));
                assert_eq!(Spectrum([r[k], g[k], b[k]]), single, "{id} {k}");
                assert_eq!(pdf[k], bxdf.pdf(at(&wo, k), at(&wi, k)), "{id} {k}");
            }
            let job = Job::Sample {
                wo: wo_in,
                uc,
                u: [u, v],
                wi: [&mut *x, &mut *y, &mut *z],
                f: [&mut *r, &mut *g, &mut *b],
                pdf: &mut *pdf,
                delta: &mut *delta,
            };
            bxdf.batch(path, job);
            for k in 0..n {
                let single = bxdf.sample_f(at(&wo, k), uc[k], [u[k], v[k]]);
                assert_eq!(pdf[k], single.map_or(R::zero(), |s| s.pdf), "{id} {k}");
                if let Some(sample) = single {
                    assert_eq!(Vec3::new(x[k], y[k], z[k]), sample.wi, "{id} {k}");
                    assert_eq!(Spectrum([r[k], g[k], b[k]]), sample.f, "{id} {k}");
                    assert_eq!(delta[k] == R::one(), sample.is_delta, "{id} {k}");
                }
            }
            for index in 0..bxdf.lobes().len() {
                let job = Job::LobeF {
                    index,
                    wo: wo_in,
                    wi: wi_in,
                    f: [&mut *r, &mut *g, &mut *b],
                };
                bxdf.batch(path, job);
                for k in 0..n {
                    let single = bxdf.lobe_f(index, at(&wo, k), at(&wi, k));
                    let found = Spectrum([r[k], g[k], b[k]]);
                    assert_eq!(found, single, "{id} lobe {index} {k}");
                }
            }
            for (index, is_incident) in
                (0..bxdf.lobes().len()).flat_map(|i| [(i, false), (i, true)])
            {
                let job = Job::Lobe {
                    index,
                    is_incident,
                    held: wo_in,
                    u: [u, v],
                    free: [&mut *x, &mut *y, &mut *z],
                    weight: [&mut *r, &mut *g, &mut *b],
                };
                bxdf.batch(path, job);
                for k in 0..n {
                    let single = drawn(&*bxdf, index, is_incident, at(&wo, k), [u[k], v[k]]);
                    let found = (Vec3::new(x[k], y[k], z[k]), Spectrum([r[k], g[k], b[k]]));
                    assert_eq!(found, single, "{id} lobe {index} {k}");
                }
            }
        }
    }
}

/// The direction of a lobe and f |cos| / pdf there, by single calls; 0 where it is lost.
fn drawn<R: Real>(
    bxdf: &dyn Scatterer<R>,
    index: usize,
    is_incident: bool,
    held: Vec3<R>,
    u: [R; 2],
) -> (Vec3<R>, Spectrum<R>) {
    let zero = R::zero();
    let free = bxdf.sample_lobe(index, held, u);
    match free.map(|free| (free, bxdf.lobe_pdf(index, held, free))) {
        Some((free, pdf)) if pdf > zero => {
            let (wo, wi) = if is_incident {
                (free, held)
            } else {
                (held, free)
            };
            (free, bxdf.lobe_f(index, wo, wi) * (free.z.abs() / pdf))
        }
        _ => (Vec3::new(zero, zero, zero), Spectrum::black()),
    }
}

trait EachMut<R> {
    fn each_mut_slices(&mut self) -> [&mut [R]; 8];
}

impl<R> EachMut<R> for Vec<Vec<R>> {
    fn each_mut_slices(&mut self) -> [&mut [R]; 8] {
        let mut slices = self.iter_mut().map(Vec::as_mut_slice);
        std::array::from_fn(|_| slices.next().unwrap())
    }
}

#[test]
fn batches_of_any_length_are_the_single_calls_bit_for_bit() {
    for n in [1, 63, 64, 200] {
        batches_give_what_single_calls_give::<f32>(n);
        batches_give_what_single_calls_give::<f64>(n);
    }
    batches_give_what_single_calls_give::<xprec::Df64>(65);
}

#[test]
fn slices_of_unequal_length_end_with_the_shortest() {
    let bxdf = Material::of(MODELS[0]).build::<f64>();
    let (long, short) = ([0.6; 100], [0.8; 70]);
    let mut pdf = [7.0; 90];
    let job = Job::Pdf {
        wo: [&long, &[0.0; 100], &short],
        wi: [&long, &[0.0; 100], &short],
        pdf: &mut pdf,
    };
    bxdf.batch(Path::Dispatched, job);
    assert!(
        pdf[..70]
            .iter()
            .all(|x| *x == 0.8 / std::f64::consts::PI * 1.0)
    );
    assert!(pdf[70..].iter().all(|x| *x == 7.0));
    let (mut short_red, mut green, mut blue) = ([7.0; 65], [7.0; 80], [7.0; 80]);
    let job = Job::FPdf {
        wo: [&long, &[0.0; 100], &short],
        wi: [&long, &[0.0; 100], &short],
        f: [&mut short_red, &mut green, &mut blue],
        pdf: &mut pdf,
    };
    bxdf.batch(Path::Dispatched, job);
    assert!(green[..65].iter().all(|x| *x != 7.0) && green[65..].iter().all(|x| *x == 7.0));
    assert!(
        pdf[65..70]
            .iter()
            .all(|x| *x == 0.8 / std::f64::consts::PI * 1.0)
    );
}
