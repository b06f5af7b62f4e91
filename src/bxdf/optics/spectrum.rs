//! A spectrum of three channels, linear.

use std::ops::{Add, Mul};

use crate::math::Real;

/// Three channels: linear R, G, B, or any triple of wavelengths.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spectrum<R>(pub [R; 3]);

impl<R: Real> Spectrum<R> {
    /// 0 in every channel.
    #[inline(always)]
    #[must_use]
    pub fn black() -> Self {
        Self::grey(R::zero())
    }

    /// `value` in every channel.
    #[inline(always)]
    pub fn grey(value: R) -> Self {
        Self([value; 3])
    }

    /// The spectrum of these `f64` values, rounded to the precision.
    #[inline(always)]
    pub fn of(rgb: [f64; 3]) -> Self {
        Self(rgb.map(R::of))
    }

    /// The function `op` applied to each channel.
    #[must_use]
    #[inline(always)]
    pub fn map(self, op: impl Fn(R) -> R) -> Self {
        let [a, b, c] = self.0;
        Self([op(a), op(b), op(c)])
    }

    /// Each channel saturated; see [`Real::saturated`].
    #[must_use]
    #[inline(always)]
    pub fn saturated(self) -> Self {
        let [a, b, c] = self.0;
        Self([a.saturated(), b.saturated(), c.saturated()])
    }

    /// The function `op` applied to the channels of two spectra, pair by pair.
    #[must_use]
    #[inline(always)]
    pub fn zip(self, other: Self, op: impl Fn(R, R) -> R) -> Self {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        Self([op(a, x), op(b, y), op(c, z)])
    }

    /// The channels as `f64`.
    #[inline(always)]
    pub fn to_f64(self) -> [f64; 3] {
        self.0.map(Real::as_f64)
    }

    /// The largest channel.
    #[inline(always)]
    pub fn max_channel(self) -> R {
        let [r, g, b] = self.0;
        r.max(g).max(b)
    }
}

impl<R: Real> Add for Spectrum<R> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        Self([a + x, b + y, c + z])
    }
}

impl<R: Real> Mul for Spectrum<R> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        Self([a * x, b * y, c * z])
    }
}

impl<R: Real> Mul<R> for Spectrum<R> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, factor: R) -> Self {
        let [a, b, c] = self.0;
        Self([a * factor, b * factor, c * factor])
    }
}

/// Relative luminance of linear R, G, B with the primaries of ITU-R BT.709 (the middle row of its matrix to CIE XYZ).
#[must_use]
pub fn luminance([r, g, b]: [f64; 3]) -> f64 {
    0.2126 * r + 0.7152 * g + 0.0722 * b
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn white_has_luminance_one() {
        assert!((luminance([1.0; 3]) - 1.0).abs() < 1e-15);
        assert_eq!(
            (Spectrum::of([1.0, 2.0, 3.0]) * Spectrum::grey(2.0)).max_channel(),
            6.0
        );
    }
}
