//! `sample`: directions of incidence as the model draws them.

use std::path::PathBuf;

use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::{Rng, SeedableRng};
use xprec::Df64;

use super::args::{self, Angles, Given, PrecisionName, STANDARD_STREAM};
use super::output::Table;
use crate::bxdf::Precision;
use crate::bxdf::math::Real;
use crate::bxdf::math::frame::direction_from_degrees;
use crate::error::{Error, Result};

/// The columns written.
const COLUMNS: [&str; 11] = [
    "u0", "u1", "uc", "wi_x", "wi_y", "wi_z", "f_r", "f_g", "f_b", "pdf", "delta",
];

/// The most samples of one run: some 200 GB of text.
const MAX_SAMPLES: u64 = 1_000_000_000;

#[derive(clap::Args)]
pub(super) struct Arguments {
    /// The material: id of a model or named material, id:name=value,name=value, or a .toml file
    #[arg(value_parser = args::material)]
    material: Given,
    /// The direction to the viewer in degrees, theta from the normal
    #[arg(long, value_name = "THETA,PHI", value_parser = args::angles, allow_hyphen_values = true)]
    wo: Angles,
    /// How many samples
    #[arg(short, value_name = "N", value_parser = sample_count, allow_hyphen_values = true)]
    n: u64,
    /// The seed of the random numbers
    #[arg(long, value_parser = seed, default_value = "0", allow_hyphen_values = true)]
    seed: u64,
    /// The precision of the arithmetic: f32, f64 or reference
    #[arg(long, value_parser = args::precision, default_value = <f64 as Real>::NAME)]
    precision: PrecisionName,
    /// The file to write; - is standard output
    #[arg(long = "out", value_name = "FILE", default_value = STANDARD_STREAM)]
    output: PathBuf,
}

fn sample_count(text: &str) -> Result<u64> {
    let count = text
        .parse()
        .map_err(|_| Error::parse(format!("-n '{text}'"), "expected a whole number"))?;
    if count > MAX_SAMPLES {
        return Err(Error::Limit {
            what: "-n",
            value: text.to_owned(),
            limit: format!("{MAX_SAMPLES} samples"),
        });
    }
    Ok(count)
}

fn seed(text: &str) -> Result<u64> {
    text.parse().map_err(|_| {
        Error::parse(
            format!("--seed '{text}'"),
            format!("expected a whole number from 0 to {}", u64::MAX),
        )
    })
}

pub(super) fn run(arguments: &Arguments) -> Result<()> {
    match arguments.precision {
        PrecisionName::F32 => draw::<f32>(arguments),
        PrecisionName::F64 => draw::<f64>(arguments),
        PrecisionName::Reference => draw::<Df64>(arguments),
    }
}

fn draw<R: Precision>(arguments: &Arguments) -> Result<()> {
    let bxdf = arguments.material.checked().build::<R>();
    let wo = direction_from_degrees(arguments.wo.theta_deg, arguments.wo.phi_deg).into();
    let mut generator = Pcg64Mcg::seed_from_u64(arguments.seed);
    let mut table = Table::open(&arguments.output, &COLUMNS)?;
    for _ in 0..arguments.n {
        let [u0, u1, uc]: [R; 3] = std::array::from_fn(|_| uniform(&mut generator));
        table.numbers(&[u0, u1, uc].map(R::as_f64))?;
        if let Some(sample) = bxdf.sample_f(wo, uc, [u0, u1]) {
            let wi = sample.wi;
            table.numbers(&[wi.x, wi.y, wi.z].map(R::as_f64))?;
            table.numbers(&sample.f.to_f64())?;
            table.numbers(&[sample.pdf.as_f64()])?;
            table.text(if sample.is_delta { "1" } else { "0" })?;
        } else {
            for field in ["", "", "", "", "", "", "0", "0"] {
                table.text(field)?;
            }
        }
        table.end_row()?;
    }
    table.finish()
}

/// The most bits of one random number.
const RANDOM_BITS: u32 = f64::MANTISSA_DIGITS;

/// A number uniform in [0, 1) with as many bits as `R` holds, at most 53: rounding never makes it 1.
///
/// The numbers of a seed are the same in every precision, but for the bits that do not fit.
fn uniform<R: Real>(generator: &mut impl Rng) -> R {
    let bits = (-R::UNIT_ROUNDOFF.log2() as u32).min(RANDOM_BITS);
    let integer = generator.next_u64() >> (u64::BITS - bits);
    R::of(integer as f64 / (1_u64 << bits) as f64)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A generator of ones only: the largest number there is.
    struct Ones;

    impl rand_pcg::rand_core::TryRng for Ones {
        type Error = std::convert::Infallible;
        fn try_next_u32(&mut self) -> std::result::Result<u32, Self::Error> {
            Ok(u32::MAX)
        }
        fn try_next_u64(&mut self) -> std::result::Result<u64, Self::Error> {
            Ok(u64::MAX)
        }
        fn try_fill_bytes(&mut self, bytes: &mut [u8]) -> std::result::Result<(), Self::Error> {
            bytes.fill(u8::MAX);
            Ok(())
        }
    }

    #[test]
    fn random_numbers_stay_below_one_in_every_precision() {
        assert_eq!(uniform::<f32>(&mut Ones), 1.0 - f32::EPSILON / 2.0);
        assert_eq!(uniform::<f64>(&mut Ones), 1.0 - f64::EPSILON / 2.0);
        assert!(uniform::<Df64>(&mut Ones) < Df64::of(1.0));
    }

    #[test]
    fn precisions_share_their_random_numbers() {
        let (mut a, mut b) = (Pcg64Mcg::seed_from_u64(7), Pcg64Mcg::seed_from_u64(7));
        for _ in 0..100 {
            let (single, double) = (uniform::<f32>(&mut a), uniform::<f64>(&mut b));
            // The bits cut off.
            assert!((0.0..2_f64.powi(-24)).contains(&(double - f64::from(single))));
        }
    }

    #[test]
    fn counts_and_seeds_are_whole() {
        assert_eq!(sample_count("1000000000").unwrap(), MAX_SAMPLES);
        assert_eq!(
            sample_count("1000000001").unwrap_err().to_string(),
            "-n is 1000000001; the limit is 1000000000 samples"
        );
        for text in ["-1", "1e3", ""] {
            assert!(sample_count(text).is_err() && seed(text).is_err());
        }
    }
}
