//! Fresnel's equations at a smooth interface, for unpolarised light, in forms that keep their digits.
//!
//! # Source
//! Born & Wolf, "Principles of Optics", 7th ed., section 1.5.2; the rearrangements that avoid the cancellations near normal
//! incidence and near equal indices are our own and stated beside each formula.

use crate::math::{Real, Vec3};

/// The index of the far side over that of the near side, above 0, with its difference from 1: one that is itself a quotient
/// has lost the digits of that where it is small, and next to equal indices the difference is what counts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RelativeIndex<R> {
    /// The quotient.
    pub n: R,
    /// That less 1.
    pub minus_1: R,
}

impl<R: Real> RelativeIndex<R> {
    /// The relative index `n`, given as such: next to 1 the difference is exact.
    #[inline(always)]
    pub fn new(n: R) -> Self {
        Self {
            n,
            minus_1: n - R::one(),
        }
    }

    /// The one seen from the other side.
    #[must_use]
    #[inline(always)]
    pub fn inverse(self) -> Self {
        Self {
            n: R::one() / self.n,
            minus_1: -self.minus_1 / self.n,
        }
    }
}

/// What a smooth dielectric interface does with unpolarised light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dielectric<R> {
    /// The share of the flux that is reflected, 0..1; 1 at total internal reflection.
    pub reflectance: R,
    /// The share of the flux that is transmitted, 0..1; not computed as 1 - reflectance, which would lose its digits
    /// where it is small.
    pub transmittance: R,
    /// The cosine of the refracted direction with the normal, 0..1; 0 at total internal reflection.
    pub cos_t: R,
}

/// Dielectric Fresnel reflectance and transmittance.
///
/// `cos_i`: absolute cosine of the incident direction, 0..1. `n`: index of the far side over that of the near side,
/// above 0.
///
/// With d = (n - 1)(n + 1) and G = sqrt(c^2 + d), the amplitude of s polarisation is d / (c + G)^2: no difference of
/// nearly equal numbers is left. Largest error in f32 8e-7, at n = 1.0001 too (the textbook form: 1.5e-3).
#[inline(always)]
pub fn dielectric<R: Real>(cos_i: R, n: R) -> Dielectric<R> {
    let c = cos_i.min(R::one());
    let index = RelativeIndex::new(n);
    dielectric_with_sine(c, (R::one() - c) * (R::one() + c), index)
}

/// [`dielectric`] along the unit vector `w`: sin^2 comes from its components in the surface, which keep the digits that
/// a cosine near 1 has lost. Seen from a medium of index 1000 all that crosses lies within 1e-3 of the normal.
#[inline(always)]
pub fn dielectric_along<R: Real>(w: Vec3<R>, n: R) -> Dielectric<R> {
    let index = RelativeIndex::new(n);
    dielectric_with_sine(w.z.abs(), w.x * w.x + w.y * w.y, index)
}

/// [`dielectric`] of the cosine `cos_i` and the square `s2` of the sine, where the sine is known better than by the cosine.
#[inline(always)]
pub fn dielectric_with_sine<R: Real>(cos_i: R, s2: R, index: RelativeIndex<R>) -> Dielectric<R> {
    let one = R::one();
    let c = cos_i.min(one);
    let RelativeIndex { n, minus_1 } = index;
    let d = minus_1 * (n + one);
    let g_squared = refracted_squared(c, s2, index);
    let refracts = g_squared > R::zero();
    let g = g_squared.sqrt_clamped();
    let c_plus_g = c + g;
    let r_s = d / (c_plus_g * c_plus_g);
    let n_squared = n * n;
    let p_denominator = n_squared * c + g;
    // c^2 + c G - 1 over c d / (c + G) + 1, both without their cancellations.
    let ratio_p_to_s = (c * g - s2) * c_plus_g / p_denominator;
    let reflectance = R::of(0.5) * r_s * r_s * (one + ratio_p_to_s * ratio_p_to_s);
    let four_c_g = R::of(4.0) * c * g;
    let transmittance_s = four_c_g / (c_plus_g * c_plus_g);
    let transmittance_p = n_squared * four_c_g / (p_denominator * p_denominator);
    let transmittance = R::of(0.5) * (transmittance_s + transmittance_p);
    if d == R::zero() {
        // At extreme grazing c^2 underflows, and the test below would take it for total reflection.
        no_interface(c)
    } else if refracts {
        Dielectric {
            reflectance: reflectance.min(one),
            transmittance: transmittance.min(one),
            cos_t: (g / n).min(one),
        }
    } else {
        total_reflection()
    }
}

/// What passes between equal indices: all, straight on.
#[inline(always)]
pub(super) fn no_interface<R: Real>(cos_i: R) -> Dielectric<R> {
    Dielectric {
        reflectance: R::zero(),
        transmittance: R::one(),
        cos_t: cos_i,
    }
}

/// What becomes of light beyond the critical angle.
#[inline(always)]
pub(super) fn total_reflection<R: Real>() -> Dielectric<R> {
    Dielectric {
        reflectance: R::one(),
        transmittance: R::zero(),
        cos_t: R::zero(),
    }
}

/// The square of n times the refracted cosine, not above 0 beyond the critical angle.
#[inline(always)]
fn refracted_squared<R: Real>(c: R, s2: R, RelativeIndex { n, minus_1 }: RelativeIndex<R>) -> R {
    // c^2 + n^2 - 1 = n^2 - s^2: the sum of the smaller terms, so that neither a small index nor one near 1 cancels.
    let c2 = c * c;
    if s2 < c2 {
        n * n - s2
    } else {
        c2 + minus_1 * (n + R::one())
    }
}

/// The refracted cosine alone, as [`dielectric_with_sine`] gives it; `cos_i` at most 1.
#[inline(always)]
pub(super) fn refracted_cosine<R: Real>(cos_i: R, s2: R, index: RelativeIndex<R>) -> R {
    (refracted_squared(cos_i, s2, index).sqrt_clamped() / index.n).min(R::one())
}

/// Dielectric transmittance between two directions that refract into each other, by both their cosines `cos_i` and
/// `cos_t`, above 0; `n` as in [`dielectric`].
///
/// With G = n cos_t both polarisations are sums of positive terms: near the critical angle, where n^2 - sin^2 cancels,
/// the cosine itself is known better.
#[inline(always)]
pub fn transmittance_between<R: Real>(cos_i: R, cos_t: R, n: R) -> R {
    let (s, p) = (cos_i + n * cos_t, n * cos_i + cos_t);
    let product = R::of(2.0) * n * cos_i * cos_t;
    let inverse = R::one() / (s * p);
    (product * inverse * ((s * s + p * p) * inverse)).min(R::one())
}

/// The direction refracted at the plane z = 0: `w` points away from the surface, the result too, on the other side.
///
/// `n`: index of the far side over that of `w`'s side; `cos_t`: the refracted cosine from [`dielectric`].
#[inline(always)]
pub fn refracted<R: Real>(w: Vec3<R>, n: R, cos_t: R) -> Vec3<R> {
    let z = if w.z > R::zero() { -cos_t } else { cos_t };
    Vec3::new(-w.x / n, -w.y / n, z)
}

/// Schlick's approximation f0 + (1 - f0)(1 - c)^5.
///
/// `cos_i`: cosine of the incident direction, clamped to 0..1. `f0`: reflectance at normal incidence, 0..1.
///
/// # Source
/// Schlick 1994, "An Inexpensive BRDF Model for Physically-based Rendering", eq. 15, `doi:10.1111/1467-8659.1330233`
#[inline(always)]
pub fn schlick<R: Real>(cos_i: R, f0: R) -> R {
    f0 + (R::one() - f0) * schlick_weight(cos_i)
}

/// The weight (1 - c)^5 of [`schlick`], for `cos_i` clamped to 0..1.
#[inline(always)]
pub fn schlick_weight<R: Real>(cos_i: R) -> R {
    let m = (R::one() - cos_i).at_least(R::zero()).at_most(R::one());
    let m2 = m * m;
    m2 * m2 * m
}

/// 1 - (1 - c)^5 for `cos_i` in 0..1, without cancellation: c times the geometric sum of the powers of 1 - c.
#[inline(always)]
pub fn schlick_rest<R: Real>(cos_i: R) -> R {
    let m = (R::one() - cos_i).at_least(R::zero()).at_most(R::one());
    let m2 = m * m;
    cos_i * (R::one() + m + m2 + m2 * m + m2 * m2)
}

/// What the error term of Lazanyi & Szirmay-Kalos is in proportion to: c (1 - c)^6, for `cos_i` in 0..1.
///
/// # Source
/// Lazanyi & Szirmay-Kalos 2005, "Fresnel Term Approximations for Metals" (`lazanyi2005`), with the exponent that Hoffman
/// 2019 gives it for every metal (`hoffman2019`)
#[inline(always)]
pub fn lazanyi_term<R: Real>(cos_i: R) -> R {
    let m = (R::one() - cos_i).at_least(R::zero()).at_most(R::one());
    let m2 = m * m;
    cos_i * (m2 * m2 * m2)
}

/// The cosine at which [`lazanyi_term`] is largest, 1/7 or 81.8 degrees.
#[inline(always)]
#[must_use]
pub fn lazanyi_cosine<R: Real>() -> R {
    R::one() / R::of(7.0)
}

/// The factor with which [`lazanyi_term`] is the `excess` of [`schlick`] over the exact reflectance where it is largest, at
/// [`lazanyi_cosine`].
#[inline(always)]
pub fn lazanyi_factor<R: Real>(excess: R) -> R {
    excess / lazanyi_term(lazanyi_cosine())
}

#[cfg(test)]
mod tests {
    use super::*;
    use xprec::Df64;

    #[test]
    fn dielectric_at_normal_incidence_is_the_textbook_value() {
        let glass = dielectric(1.0, 1.5_f64);
        assert!((glass.reflectance - 0.04).abs() < 1e-16);
        assert!((glass.transmittance - 0.96).abs() < 1e-15);
        assert_eq!(glass.cos_t, 1.0);
    }

    #[test]
    fn dielectric_shares_sum_to_one_on_both_sides() {
        for n in [0.25_f64, 0.666, 1.0 - 1e-6, 1.0, 1.0 + 1e-6, 1.5, 1000.0] {
            for c in [1e-12, 1e-3, 0.3, 0.745, 0.999, 1.0] {
                let d = dielectric(c, n);
                // Three roundings in each share.
                assert!(
                    (d.reflectance + d.transmittance - 1.0).abs() < 2e-15,
                    "n {n} c {c}: {d:?}"
                );
            }
        }
    }

    #[test]
    fn equal_indices_are_no_interface_even_where_the_squared_cosine_underflows() {
        for c in [1e-38_f32, 1e-20, 1e-3, 1.0] {
            let nothing = dielectric(c, 1.0);
            assert_eq!(
                (nothing.reflectance, nothing.transmittance, nothing.cos_t),
                (0.0, 1.0, c)
            );
        }
    }

    #[test]
    fn total_internal_reflection_is_total() {
        let inside = dielectric(0.5, 1.0 / 1.5);
        assert_eq!((inside.reflectance, inside.transmittance), (1.0, 0.0));
    }

    #[test]
    fn brewster_angle_kills_p_polarisation() {
        let n = 1.5_f64;
        let c = 1.0 / (1.0 + n * n).sqrt();
        let r_s = ((1.0 - n * n) / (1.0 + n * n)).powi(2);
        assert!((dielectric(c, n).reflectance - 0.5 * r_s).abs() < 1e-15);
    }

    #[test]
    fn dielectric_keeps_its_digits_in_f32() {
        let mut worst = 0.0_f64;
        for n in [1.000_1_f32, 1.01, 1.5, 0.9, 2.42] {
            for step in 1..=100_u8 {
                let c = f32::from(step) / 100.0;
                let exact = dielectric(Df64::of(c.into()), Df64::of(n.into()))
                    .reflectance
                    .as_f64();
                let error = (f64::from(dielectric(c, n).reflectance) / exact - 1.0).abs();
                worst = worst.max(error);
            }
        }
        // A dozen roundings of 6e-8; measured 8e-7.
        assert!(worst < 1.2e-6, "{worst}");
    }

    #[test]
    fn a_quotient_next_to_1_keeps_the_digits_of_its_difference() {
        // One step of f32 below 1, seen from below at a grazing angle: 1 - 4 c / sqrt(2 (n - 1)).
        let eta = 1.0_f32 - f32::EPSILON / 2.0;
        let exact_eta = Df64::of(eta.into());
        for c in [1e-9_f32, 3e-8, 1e-6, 1e-4, 1e-2] {
            let at = |index| dielectric_with_sine(c, 1.0, index).reflectance;
            let exact_index = RelativeIndex::new(exact_eta).inverse();
            let one = Df64::of(1.0);
            let exact = dielectric_with_sine(Df64::of(c.into()), one, exact_index);
            let error = |x: f32| (f64::from(x) / exact.reflectance.as_f64() - 1.0).abs();
            assert!(error(at(RelativeIndex::new(eta).inverse())) < 1e-6, "{c}");
            let plain = error(at(RelativeIndex::new(1.0 / eta)));
            assert!(c < 1e-8 || plain > 5e-5, "{c}: {plain}");
        }
    }

    #[test]
    fn refraction_obeys_snell() {
        let w = Vec3::new(0.6_f64, 0.0, 0.8);
        let t = refracted(w, 1.5, dielectric(0.8, 1.5).cos_t);
        assert!((t.length_squared() - 1.0).abs() < 1e-15);
        assert!((t.x + 0.4).abs() < 1e-15 && t.z < 0.0);
        assert!((schlick(0.0, 0.04_f64) - 1.0).abs() < 1e-15 && schlick(1.0, 0.04_f64) == 0.04);
    }

    #[test]
    fn refraction_out_of_a_dense_medium_gives_unit_vectors() {
        // From index 1000, all within 1e-3 of the normal crosses; the cosine alone no longer tells those directions apart.
        for x in [0.0_f32, 1e-4, 5e-4, 9e-4] {
            let w = Vec3::new(x, 0.0, -(1.0 - x * x).sqrt());
            let n = 1.0 / 1000.0;
            let crossed = refracted(w, n, dielectric_along(w, n).cos_t);
            assert!((crossed.length_squared() - 1.0).abs() < 1e-6, "{crossed:?}");
        }
    }
}
