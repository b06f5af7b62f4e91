//! The quantities compared, each written twice.

use bxdf::internals::Conductor;
use bxdf::internals::Normals as _;
use bxdf::internals::cosine_power;
use bxdf::internals::eon_loss;
use bxdf::internals::fresnel;
use bxdf::internals::{ggx, gtr1};
use bxdf::math::{Real, Vec3};

/// A quantity that is written twice.
pub(super) trait Formula {
    /// What the forms are given where the parameter is `x`.
    fn input(x: f64) -> f64 {
        x
    }

    /// As textbooks have it, of the parameter and of the second argument.
    fn textbook<R: Real>(x: R, y: R) -> R;

    /// As the core has it.
    fn stable<R: Real>(x: R, y: R) -> R;
}

/// The unit vector of sine `sin`, and its cosine.
fn leaning<R: Real>(sin: R) -> Vec3<R> {
    let cos = ((R::one() - sin) * (R::one() + sin)).sqrt();
    Vec3::new(sin, R::zero(), cos)
}

/// D of GGX of this width, where the sine is y widths.
pub(super) struct Ggx;

/// The half vector of [`Ggx`].
fn widths_off<R: Real>(alpha: R, y: R) -> Vec3<R> {
    leaning(alpha * y)
}

impl Formula for Ggx {
    fn textbook<R: Real>(alpha: R, y: R) -> R {
        let cos = widths_off(alpha, y).z;
        let (one, cos2, alpha2) = (R::one(), cos * cos, alpha * alpha);
        let tan2 = (one - cos2) / cos2;
        one / (R::pi() * alpha2 * cos2 * cos2 * (one + tan2 / alpha2).sqr())
    }

    fn stable<R: Real>(alpha: R, y: R) -> R {
        ggx::Ggx::new(alpha, alpha).d(widths_off(alpha, y))
    }
}

/// The reflectance of a dielectric by its index, at the cosine y.
pub(super) struct NearIndexOne;

impl Formula for NearIndexOne {
    fn input(x: f64) -> f64 {
        1.0 + x
    }

    fn textbook<R: Real>(n: R, cos_i: R) -> R {
        let one = R::one();
        let sin_t = (one - cos_i * cos_i).sqrt() / n;
        let cos_t = (one - sin_t * sin_t).sqrt();
        let s = (cos_i - n * cos_t) / (cos_i + n * cos_t);
        let p = (n * cos_i - cos_t) / (n * cos_i + cos_t);
        (s * s + p * p) * R::of(0.5)
    }

    fn stable<R: Real>(n: R, cos_i: R) -> R {
        fresnel::dielectric(cos_i, n).reflectance
    }
}

/// The reflectance of a medium of index 1 + i k at the cosine y.
pub(super) struct Metal;

impl Formula for Metal {
    fn textbook<R: Real>(k: R, cos: R) -> R {
        let (half, two, n) = (R::of(0.5), R::of(2.0), R::one());
        let (cos2, sin2) = (cos * cos, R::one() - cos * cos);
        let re = n * n - k * k - sin2;
        let a2_plus_b2 = (re * re + R::of(4.0) * n * n * k * k).sqrt();
        let a = (half * (a2_plus_b2 + re)).sqrt();
        let s = (a2_plus_b2 + cos2 - two * a * cos) / (a2_plus_b2 + cos2 + two * a * cos);
        let even = cos2 * a2_plus_b2 + sin2 * sin2;
        let odd = two * a * cos * sin2;
        half * s * (R::one() + (even - odd) / (even + odd))
    }

    fn stable<R: Real>(k: R, cos: R) -> R {
        let [reflectance, ..] = Conductor::new([R::one(); 3], [k; 3]).reflectance(cos);
        reflectance
    }
}

/// Smith's Lambda of GGX of width y at the polar angle x.
pub(super) struct Lambda;

impl Formula for Lambda {
    fn textbook<R: Real>(theta: R, alpha: R) -> R {
        let one = R::one();
        let x = alpha * theta.sin() / theta.cos();
        ((one + x * x).sqrt() - one) * R::of(0.5)
    }

    fn stable<R: Real>(theta: R, alpha: R) -> R {
        let (sin, cos) = theta.sin_cos();
        let excess = ggx::Ggx::new(alpha, alpha).masking_excess(Vec3::new(sin, R::zero(), cos));
        excess / (R::of(2.0) * cos)
    }
}

/// D of GTR1 of this width, where the sine is y widths.
pub(super) struct ClearCoat;

impl Formula for ClearCoat {
    fn textbook<R: Real>(a: R, y: R) -> R {
        let cos = widths_off(a, y).z;
        let (one, less_one) = (R::one(), a * a - R::one());
        less_one / (R::pi() * less_one.ln_1p() * (one + less_one * cos * cos))
    }

    fn stable<R: Real>(a: R, y: R) -> R {
        gtr1::Gtr1::new(a).d(widths_off(a, y))
    }
}

/// cos^n where the sine is y over the root of n: at 1 it has fallen to the root of 1/e.
pub(super) struct Power;

/// The normal of [`Power`]: n ln cos is -y^2 / 2 to first order.
fn down_the_lobe<R: Real>(n: R, y: R) -> Vec3<R> {
    leaning((y * (R::one() / n).sqrt()).min(R::of(0.9)))
}

impl Formula for Power {
    fn textbook<R: Real>(n: R, y: R) -> R {
        down_the_lobe(n, y).z.powf(n)
    }

    fn stable<R: Real>(n: R, y: R) -> R {
        cosine_power::of_normal(down_the_lobe(n, y), n)
    }
}

/// pi (1 - E) over A and the roughness, for E of one bounce in Fujii's Oren-Nayar, at the cosine x: of nothing else.
pub(super) struct Fujii;

impl Formula for Fujii {
    fn textbook<R: Real>(mu: R, _: R) -> R {
        let (one, two, three) = (R::one(), R::of(2.0), R::of(3.0));
        let s = (one - mu * mu).sqrt();
        let g = s * (s.atan2(mu) - s * mu) + two / three * (s / mu * (one - s * s * s) - s);
        R::frac_pi_2() - two / three - g
    }

    fn stable<R: Real>(mu: R, _: R) -> R {
        let sin = ((R::one() - mu) * (R::one() + mu)).sqrt();
        eon_loss(Vec3::new(sin, R::zero(), mu))
    }
}
