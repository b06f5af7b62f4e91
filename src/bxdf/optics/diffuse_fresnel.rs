//! What a smooth dielectric interface lets through of diffuse light.
//!
//! # Source
//! Walsh 1926 (`walsh1926`), in the closed form of Duntley 1942 (`duntley1942`) for the cosine-weighted mean of the
//! Fresnel reflectance.

use xprec::Df64;

use crate::math::Real;

/// n - 1 below which the closed form, whose terms grow as 1 / (n - 1) and leave n - 1, gives way to its expansion. There
/// the first term left out is 1e-16 of the sum, and the closed form in double-double has lost 12 of its 32 digits.
const NEAR_ONE: f64 = 1e-4;

/// The transmittance 2 int T(mu) mu dmu of diffuse light that arrives from outside, 0..1.
///
/// `n`: index inside over index outside, above 0. From the inside, 1 - `Fdr_int` is this over n^2. Formed in
/// double-double, with `n` taken as an `f64`: correctly rounded in f32 and f64.
#[must_use]
pub fn diffuse_transmittance<R: Real>(n: R) -> R {
    let n = Df64::new(n.as_f64());
    let one = Df64::new(1.0);
    let value = if n < one {
        // The way back of the light that passes from the other side: the same share but for the n^2 of its spread.
        n * n * (one - diffuse_reflectance(one / n))
    } else {
        one - diffuse_reflectance(n)
    };
    R::of(value.hi()) + R::of(value.lo())
}

/// 2 int F(mu) mu dmu from outside, for n >= 1.
fn diffuse_reflectance(n: Df64) -> Df64 {
    let c = |x: f64| Df64::new(x);
    let one = c(1.0);
    let d = n - one;
    if d <= c(0.0) {
        return c(0.0);
    }
    if d < c(NEAR_ONE) {
        let log = (d * c(0.5)).ln();
        let cubic = c(37.0) / c(160.0) - c(0.625) * log;
        let square = c(19.0) / c(24.0) + c(0.5) * log;
        return d * (one / c(3.0) + d * (square + d * (d * cubic - c(79.0) / c(60.0))));
    }
    let n2 = n * n;
    let (below, above) = (n2 - one, n2 + one);
    let fourth = below * above;
    let polynomial = d * (c(3.0) * n + one) / (c(6.0) * (n + one) * (n + one))
        - c(2.0) * n * n2 * (n2 + c(2.0) * n - one) / (above * fourth);
    let outer = n2 * below * below / (above * above * above) * (d / (n + one)).ln();
    let inner = c(8.0) * n2 * n2 * (n2 * n2 + one) / (above * fourth * fourth) * n.ln();
    c(0.5) + polynomial + outer + inner
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::optics::fresnel;

    /// n, and the reflectance from outside in 60-digit arithmetic.
    const TABLE: [(f64, f64); 5] = [
        (1.33, 0.065_930_849_299_405_42),
        (1.5, 0.091_777_959_342_351_21),
        (2.5, 0.221_866_573_521_962_88),
        (1000.0, 0.994_719_939_327_603_6),
        (1.01, 0.003_146_302_682_353_431_3),
    ];

    #[test]
    fn published_values() {
        for (n, reflectance) in TABLE {
            let found = diffuse_transmittance(n);
            assert!((found + reflectance - 1.0).abs() < 2e-16, "{n}: {found}");
        }
        // n = 1.5 from the inside: .596, the number of every text on translucency.
        let inside: f64 = 1.0 - diffuse_transmittance(1.5) / 2.25;
        assert!((inside - 0.596_345_759_707_711_6).abs() < 2e-16);
    }

    #[test]
    fn the_expansion_meets_the_closed_form() {
        let (below, above) = (1.0 + NEAR_ONE * (1.0 - 1e-9), 1.0 + NEAR_ONE * (1.0 + 1e-9));
        let of = |n| diffuse_reflectance(Df64::new(n)).as_f64();
        let slope = (of(above) - of(below)) / (above - below);
        // F is n - 1 over 3 there, less a part in a thousand.
        assert!((slope - 1.0 / 3.0).abs() < 1e-3, "{slope}");
        assert!((of(1.0 + 1e-6) - 3.333_268_706_698_14e-7).abs() < 1e-16);
        assert_eq!(diffuse_transmittance(1.0_f32), 1.0);
    }

    #[test]
    fn both_sides_are_the_mean_of_the_transmittance() {
        for n in [0.25, 0.8, 1.2, 3.0] {
            let steps = 100_000;
            let width = 1.0 / f64::from(steps);
            let sum: f64 = (0..steps)
                .map(|i| {
                    let mu = (f64::from(i) + 0.5) * width;
                    2.0 * fresnel::dielectric(mu, n).transmittance * mu * width
                })
                .sum();
            // Midpoint rule; the root where total reflection begins leaves width^1.5 times its steepness, about 30.
            assert!((diffuse_transmittance(n) - sum).abs() < 1e-6, "{n}: {sum}");
        }
    }
}
