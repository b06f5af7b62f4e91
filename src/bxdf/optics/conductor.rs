//! Fresnel's equations for metals and other absorbing media, for unpolarised light, in a form that keeps its digits.
//!
//! # Source
//! Born & Wolf, "Principles of Optics", 7th ed., section 14.2; the rearrangements are our own and stated beside the
//! formulas.

use crate::math::Real;

/// A conductor of three channels: what its Fresnel reflectance needs of its index, computed once.
#[derive(Clone, Copy, Debug)]
pub struct Conductor<R> {
    channels: [Channel<R>; 3],
    /// Brings the square of the largest k into range: a power of two.
    scale: R,
}

/// Beyond this k the product of two squares of it overflows f32.
const LARGE_K: f64 = (1_u64 << 20) as f64;

/// Brings k^2 back to 1 at the largest k, 1e10 = 2^33.
const LARGE_K_SCALE: f64 = 1.0 / (LARGE_K * LARGE_K * LARGE_K) / (1_u64 << 6) as f64;

/// Below it the larger part of a root is taken as it, so that three of them multiply without underflow; the smaller part
/// is then less than 1e-12 and no longer seen beside the cosine.
const LEAST_ROOT: f64 = 1e-12;

/// The smallest factor that both sides of the s polarisation's fraction are multiplied by, in units of the smallest normal
/// number: what is multiplied by it keeps its digits.
const LEAST_FACTOR: f64 = (1_u64 << 24) as f64;

impl<R: Real> Conductor<R> {
    /// The conductor of relative index eta + i k; in no channel both are 0.
    #[must_use]
    pub fn new(eta: [R; 3], k: [R; 3]) -> Self {
        let ([n0, n1, n2], [k0, k1, k2]) = (eta, k);
        Self {
            channels: [
                Channel::new(n0, k0),
                Channel::new(n1, k1),
                Channel::new(n2, k2),
            ],
            scale: large_k_scale(k0.max(k1).max(k2)),
        }
    }

    /// The reflectance of each channel, 0..1, at the absolute cosine `cos_i` of the incident direction, 0..1.
    ///
    /// Largest error in f32 2e-6 over n .01..3, k 1e-4..1e10, cos 1e-5..1.
    #[inline(always)]
    pub fn reflectance(&self, cos_i: R) -> [R; 3] {
        let one = R::one();
        let c = cos_i.at_most(one);
        self.reflectance_with_sine(c, (one - c) * (one + c))
    }

    /// [`Self::reflectance`] at the cosine `c`, 0..1, and the square `s2` of the sine, where that is known better than by a
    /// cosine near 1: without absorption a small index lets in light from within a narrow cone only.
    #[inline(always)]
    pub fn reflectance_with_sine(&self, c: R, s2: R) -> [R; 3] {
        let c2 = c * c;
        let [red, green, blue] = &self.channels;
        let [x, y, z] = [red.root(c2, s2), green.root(c2, s2), blue.root(c2, s2)];
        // 1 / (2 x), 1 / (2 y), 1 / (2 z) by one division.
        let (xy, yz, zx) = (
            x.larger * y.larger,
            y.larger * z.larger,
            z.larger * x.larger,
        );
        let halves = R::of(0.5) / (xy * z.larger);
        let shared = Cosines {
            c,
            c2: c2 * self.scale,
            s4: s2 * s2 * self.scale,
            c_s2: R::of(2.0) * c * s2 * self.scale,
        };
        [
            red.reflectance(&shared, &x, halves * yz),
            green.reflectance(&shared, &y, halves * zx),
            blue.reflectance(&shared, &z, halves * xy),
        ]
    }
}

#[inline(always)]
fn large_k_scale<R: Real>(k: R) -> R {
    R::of(if k > R::of(LARGE_K) {
        LARGE_K_SCALE
    } else {
        1.0
    })
}

/// One channel of a [`Conductor`], of index n + ik.
///
/// A + iB is the root of (n - ik)^2 - sin^2. The larger of A and B comes from the modulus, the smaller from their product
/// n k, and A - c from its own equation where k is small, so that k = 0 agrees with [`dielectric`].
#[derive(Clone, Copy, Debug)]
struct Channel<R> {
    /// 2 n k = 2 A B, and its square times that of the scale.
    im: R,
    scaled_im_squared: R,
    /// Whether the real part is (n^2 - k^2 - 1) + c^2, else (n^2 - k^2) - s^2: no difference of nearly equal numbers.
    is_near_vacuum: bool,
    /// What is added to c^2 or -s^2, times the scale.
    scaled_re: R,
    /// Brings squares of this k into range, and half its reciprocal: powers of two.
    scale: R,
    half_per_scale: R,
    /// Whether A^2 - c^2 comes from B^2 and not from A.
    is_weak: bool,
    /// n^2 - k^2 - 1.
    re_at_horizon: R,
}

/// The cosine that three channels share, and what comes of it and the sine; the last three times the scale.
struct Cosines<R> {
    c: R,
    c2: R,
    s4: R,
    /// 2 c s^2.
    c_s2: R,
}

/// The larger part of a root, and its square.
struct Root<R> {
    larger: R,
    larger_squared: R,
    /// Whether it is A.
    is_real: bool,
}

impl<R: Real> Channel<R> {
    fn new(n: R, k: R) -> Self {
        let (one, half) = (R::one(), R::of(0.5));
        let is_near_vacuum = k < one && (n - one).abs() < half;
        let re_at_horizon = (n - one) * (n + one) - k * k;
        let re = if is_near_vacuum {
            re_at_horizon
        } else {
            (n - k) * (n + k)
        };
        let im = R::of(2.0) * n * k;
        let scale = large_k_scale(k);
        Self {
            im,
            scaled_im_squared: (im * scale).sqr(),
            is_near_vacuum,
            scaled_re: re * scale,
            scale,
            half_per_scale: half / scale,
            is_weak: k < one,
            re_at_horizon,
        }
    }

    #[inline(always)]
    fn root(&self, c2: R, s2: R) -> Root<R> {
        let of_angle = if self.is_near_vacuum { c2 } else { -s2 };
        let re = self.scaled_re + of_angle * self.scale;
        let modulus = (re * re + self.scaled_im_squared).sqrt();
        let larger_squared = (modulus + re.abs()) * self.half_per_scale;
        Root {
            larger: larger_squared.sqrt().at_least(R::of(LEAST_ROOT)),
            larger_squared,
            is_real: re >= R::zero(),
        }
    }

    /// The reflectance, by half the reciprocal of the larger part of the root.
    ///
    /// s polarisation reflects ((A - c)^2 + B^2) / ((A + c)^2 + B^2), for a small k both times (A + c)^2, so that
    /// A^2 - c^2 takes the place of A - c; p polarisation of that (Q - 2 A c s^2) / (Q + 2 A c s^2), with
    /// Q = (A^2 + B^2) c^2 + s^4. The mean of the two has the one denominator of p polarisation.
    #[inline(always)]
    fn reflectance(&self, at: &Cosines<R>, root: &Root<R>, half_per_larger: R) -> R {
        let smaller = self.im * half_per_larger;
        let smaller_squared = smaller * smaller;
        let (a, b2) = if root.is_real {
            (root.larger, smaller_squared)
        } else {
            (smaller, root.larger_squared)
        };
        let (plus, minus) = (a + at.c, a - at.c);
        let plus2 = plus * plus;
        let (difference, factor) = if self.is_weak {
            // Beyond the critical angle A is 0, and at grazing (A + c)^2 would underflow on both sides of the fraction.
            let least = R::min_positive_value() * R::of(LEAST_FACTOR);
            (self.re_at_horizon + b2, plus2.at_least(least))
        } else {
            (minus, R::one())
        };
        let q = (root.larger_squared + smaller_squared) * at.c2 + at.s4;
        let above = (difference * difference + b2 * factor) * q;
        let below = (plus2 + b2) * factor * (q + a * at.c_s2);
        // Where all underflows nothing is reflected: the limit at the horizon of an interface that is none.
        (above / below.at_least(R::min_positive_value())).at_most(R::one())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::optics::fresnel::dielectric;

    /// The reflectance of one channel, beside two that are far from it.
    fn conductor<R: Real>(c: R, n: R, k: R) -> R {
        let (low, high) = (R::of(1e-3), R::of(1e3));
        let [r, ..] = Conductor::new([n, low, high], [k, high, low]).reflectance(c);
        r
    }

    #[test]
    fn conductor_without_absorption_is_the_dielectric() {
        for n in [0.7_f64, 1.0 + 1e-6, 1.5, 3.0] {
            for c in [1e-3, 0.2, 0.8, 1.0] {
                let expected = dielectric(c, n).reflectance;
                assert!(
                    (conductor(c, n, 0.0) - expected).abs() <= 1e-13 * expected.max(1e-3),
                    "n {n} c {c}"
                );
            }
        }
    }

    #[test]
    fn conductor_survives_its_extremes() {
        for k in [0.0_f32, 1e-10, 1e-4, 1.0, 1e5, 1e10] {
            for n in [0.0_f32, 1e-4, 1.0, 1e4] {
                for c in [0.0_f32, 1e-38, 1e-5, 0.5, 1.0] {
                    let r = conductor(c, n, k);
                    assert!((0.0..=1.0).contains(&r), "n {n} k {k} c {c}: {r}");
                }
            }
        }
        // Gold at 700 nm, normal incidence: ((n-1)^2 + k^2) / ((n+1)^2 + k^2).
        let (n, k) = (0.143_f64, 3.983);
        let expected = ((n - 1.0).powi(2) + k * k) / ((n + 1.0).powi(2) + k * k);
        assert!((conductor(1.0, n, k) - expected).abs() < 1e-15);
    }

    #[test]
    fn total_reflection_without_absorption_reaches_the_horizon() {
        // The square of these cosines underflows in f32, on both sides of a fraction.
        for c in [1e-5_f32, 1e-15, 1e-23, 1e-38] {
            let r = conductor(c, 0.143, 0.0);
            assert!((r - 1.0).abs() < 1e-6, "{c}: {r}");
        }
    }
}
