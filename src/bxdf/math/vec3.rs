//! A vector of three components in any precision; glam serves wherever the precision is fixed.

use std::ops::{Add, Mul, Neg, Sub};

use glam::DVec3;

use super::Real;

/// A vector in the shading frame: `x` along s, `y` along t, `z` along the normal n.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vec3<R> {
    /// The component along s.
    pub x: R,
    /// The component along t.
    pub y: R,
    /// The component along n.
    pub z: R,
}

impl<R: Real> Vec3<R> {
    /// The vector with these components.
    #[inline(always)]
    pub fn new(x: R, y: R, z: R) -> Self {
        Self { x, y, z }
    }

    /// The dot product.
    #[inline(always)]
    pub fn dot(self, other: Self) -> R {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    /// The cross product, right-handed.
    #[must_use]
    #[inline(always)]
    pub fn cross(self, other: Self) -> Self {
        Self::new(
            self.y * other.z - self.z * other.y,
            self.z * other.x - self.x * other.z,
            self.x * other.y - self.y * other.x,
        )
    }

    /// The square of the length.
    #[inline(always)]
    pub fn length_squared(self) -> R {
        self.dot(self)
    }

    /// The largest absolute value among the components.
    #[inline(always)]
    pub fn max_abs(self) -> R {
        self.x.abs().at_least(self.y.abs()).at_least(self.z.abs())
    }

    /// The unit vector along `self`, whose squared length must be a normal number.
    #[must_use]
    #[inline(always)]
    pub fn unit(self) -> Self {
        self * (R::one() / self.length_squared().sqrt())
    }

    /// The unit vector along `self`, and the length of `self`, without overflow or underflow on the way.
    ///
    /// `None` where `self` is zero or not finite.
    #[inline(always)]
    pub fn unit_and_length(self) -> Option<(Self, R)> {
        let (scale, back) = self.max_abs().rescaling();
        let scaled = self * scale;
        let square = scaled.length_squared();
        if square > R::zero() && square <= R::max_value() {
            let length = square.sqrt();
            Some((scaled * (R::one() / length), length * back))
        } else {
            None
        }
    }

    /// [`Self::unit_and_length`] of a vector of moderate length, or none: it only guards against underflow.
    #[inline(always)]
    pub fn unit_and_length_of_short(self) -> Option<(Self, R)> {
        let (scale, back) = self.max_abs().raising();
        let scaled = self * scale;
        let square = scaled.length_squared();
        if square > R::zero() {
            let length = square.sqrt();
            Some((scaled * (R::one() / length), length * back))
        } else {
            None
        }
    }

    /// The vector mirrored in the surface: (x, y, -z).
    #[must_use]
    #[inline(always)]
    pub fn mirrored_in_surface(self) -> Self {
        Self::new(self.x, self.y, -self.z)
    }

    /// The vector mirrored about the normal: (-x, -y, z), the mirror direction of a unit direction.
    #[must_use]
    #[inline(always)]
    pub fn mirrored_about_normal(self) -> Self {
        Self::new(-self.x, -self.y, self.z)
    }
}

impl<R: Real> Add for Vec3<R> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self::new(self.x + other.x, self.y + other.y, self.z + other.z)
    }
}

impl<R: Real> Sub for Vec3<R> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self::new(self.x - other.x, self.y - other.y, self.z - other.z)
    }
}

impl<R: Real> Neg for Vec3<R> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self::new(-self.x, -self.y, -self.z)
    }
}

impl<R: Real> Mul<R> for Vec3<R> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, factor: R) -> Self {
        Self::new(self.x * factor, self.y * factor, self.z * factor)
    }
}

impl<R: Real> From<DVec3> for Vec3<R> {
    #[inline(always)]
    fn from(v: DVec3) -> Self {
        Self::new(R::of(v.x), R::of(v.y), R::of(v.z))
    }
}

impl<R: Real> From<Vec3<R>> for DVec3 {
    #[inline(always)]
    fn from(v: Vec3<R>) -> Self {
        Self::new(v.x.as_f64(), v.y.as_f64(), v.z.as_f64())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn unit_vectors_survive_tiny_and_huge_lengths() {
        for scale in [1e-300, 1.0, 1e300_f64] {
            let v = Vec3::new(3.0 * scale, 0.0, -4.0 * scale);
            let (unit, length) = v.unit_and_length().unwrap();
            assert!((unit.x - 0.6).abs() < 1e-15 && (unit.z + 0.8).abs() < 1e-15);
            assert!((length / scale - 5.0).abs() < 1e-14);
        }
        assert!(Vec3::new(0.0_f32, 0.0, 0.0).unit_and_length().is_none());
        assert!(
            Vec3::new(f64::NAN, f64::INFINITY, 0.0)
                .unit_and_length()
                .is_none()
        );
    }

    #[test]
    fn products_are_right_handed() {
        let s = Vec3::new(1.0, 0.0, 0.0);
        let t = Vec3::new(0.0, 1.0, 0.0);
        assert_eq!(s.cross(t), Vec3::new(0.0, 0.0, 1.0));
        assert_eq!(s.dot(t), 0.0);
        let v = Vec3::new(0.1, 0.2, 0.3);
        assert_eq!(
            DVec3::from(Vec3::<f64>::from(DVec3::from(v))),
            DVec3::new(0.1, 0.2, 0.3)
        );
    }
}
