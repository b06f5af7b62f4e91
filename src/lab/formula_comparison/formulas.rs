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

    /// As textbooks have it.
    fn textbook<R: Real>(x: R) -> R;

    /// As the core has it.
    fn stable<R: Real>(x: R) -> R;
}

/// The unit vector of sine `sin`, and its cosine.
fn leaning<R: Real>(sin: R) -> Vec3<R> {
    let cos = ((R::one() - sin) * (R::one() + sin)).sqrt();
    Vec3::new(sin, R::zero(), cos)
}

/// D of GGX, one width off the normal; at alpha 1 half of it.
pub(super) struct Ggx;

/// The half vector of [`Ggx`].
fn one_width_off<R: Real>(alpha: R) -> Vec3<R> {
    leaning(alpha * R::of(0.5))
}

impl Formula for Ggx {
    fn textbook<R: Real>(alpha: R) -> R {
        let cos = one_width_off(alpha).z;
        let (one, cos2, alpha2) = (R::one(), cos * cos, alpha * alpha);
        let tan2 = (one - cos2) / cos2;
        one / (R::pi() * alpha2 * cos2 * cos2 * (one + tan2 / alpha2).sqr())
    }

    fn stable<R: Real>(alpha: R) -> R {
        ggx::Ggx::new(alpha, alpha).d(one_width_off(alpha))
    }
}

/// The reflectance of a dielectric at 45 degrees, by its index.
pub(super) struct NearIndexOne;

impl Formula for NearIndexOne {
    fn input(x: f64) -> f64 {
        1.0 + x
    }

    fn textbook<R: Real>(n: R) -> R {
        let one = R::one();
        let cos_i = R::frac_1_sqrt_2();
        let sin_t = (one - cos_i * cos_i).sqrt() / n;
        let cos_t = (one - sin_t * sin_t).sqrt();
        let s = (cos_i - n * cos_t) / (cos_i + n * cos_t);
        let p = (n * cos_i - cos_t) / (n * cos_i + cos_t);
        (s * s + p * p) * R::of(0.5)
    }

    fn stable<R: Real>(n: R) -> R {
        fresnel::dielectric(R::frac_1_sqrt_2(), n).reflectance
    }
}

/// The reflectance of a medium of index 1 + i k at 60 degrees.
pub(super) struct Metal;

impl Formula for Metal {
    fn textbook<R: Real>(k: R) -> R {
        let (half, two, n, cos) = (R::of(0.5), R::of(2.0), R::one(), R::of(0.5));
        let (cos2, sin2) = (cos * cos, R::one() - cos * cos);
        let re = n * n - k * k - sin2;
        let a2_plus_b2 = (re * re + R::of(4.0) * n * n * k * k).sqrt();
        let a = (half * (a2_plus_b2 + re)).sqrt();
        let s = (a2_plus_b2 + cos2 - two * a * cos) / (a2_plus_b2 + cos2 + two * a * cos);
        let even = cos2 * a2_plus_b2 + sin2 * sin2;
        let odd = two * a * cos * sin2;
        half * s * (R::one() + (even - odd) / (even + odd))
    }

    fn stable<R: Real>(k: R) -> R {
        let [reflectance, ..] = Conductor::new([R::one(); 3], [k; 3]).reflectance(R::of(0.5));
        reflectance
    }
}

/// Smith's Lambda of GGX of width .1 at the polar angle x.
pub(super) struct Lambda;

impl Lambda {
    const ALPHA: f64 = 0.1;
}

impl Formula for Lambda {
    fn textbook<R: Real>(theta: R) -> R {
        let (one, alpha) = (R::one(), R::of(Self::ALPHA));
        let x = alpha * theta.sin() / theta.cos();
        ((one + x * x).sqrt() - one) * R::of(0.5)
    }

    fn stable<R: Real>(theta: R) -> R {
        let (sin, cos) = theta.sin_cos();
        let alpha = R::of(Self::ALPHA);
        let excess = ggx::Ggx::new(alpha, alpha).masking_excess(Vec3::new(sin, R::zero(), cos));
        excess / (R::of(2.0) * cos)
    }
}

/// D of GTR1, half a width off the normal.
pub(super) struct ClearCoat;

impl Formula for ClearCoat {
    fn textbook<R: Real>(a: R) -> R {
        let cos = one_width_off(a).z;
        let (one, less_one) = (R::one(), a * a - R::one());
        less_one / (R::pi() * less_one.ln_1p() * (one + less_one * cos * cos))
    }

    fn stable<R: Real>(a: R) -> R {
        gtr1::Gtr1::new(a).d(one_width_off(a))
    }
}

/// cos^n where it has fallen to 1/e.
pub(super) struct Power;

/// The normal of [`Power`]: ln cos is -1/n to first order.
fn down_by_e<R: Real>(n: R) -> Vec3<R> {
    leaning((R::one() / n).sqrt().min(R::of(0.9)))
}

impl Formula for Power {
    fn textbook<R: Real>(n: R) -> R {
        down_by_e(n).z.powf(n)
    }

    fn stable<R: Real>(n: R) -> R {
        cosine_power::of_normal(down_by_e(n), n)
    }
}

/// pi (1 - E) over A and the roughness, for E of one bounce in Fujii's Oren-Nayar, at the cosine x.
pub(super) struct Fujii;

impl Formula for Fujii {
    fn textbook<R: Real>(mu: R) -> R {
        let (one, two, three) = (R::one(), R::of(2.0), R::of(3.0));
        let s = (one - mu * mu).sqrt();
        let g = s * (s.atan2(mu) - s * mu) + two / three * (s / mu * (one - s * s * s) - s);
        R::frac_pi_2() - two / three - g
    }

    fn stable<R: Real>(mu: R) -> R {
        let sin = ((R::one() - mu) * (R::one() + mu)).sqrt();
        eon_loss(Vec3::new(sin, R::zero(), mu))
    }
}
