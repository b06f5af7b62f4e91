//! The reflectance of metals with their root fitted: what [`Conductor`](super::conductor::Conductor) says, without its
//! square roots.
//!
//! With A + iB the root of (n - ik)^2 - sin^2, all is rational in A, as A^2 + B^2 + cos^2 = 2 A^2 + 1 - n^2 + k^2 =: S. With
//! T = 2 A cos, Q = (S - cos^2) cos^2 + sin^4 and U = T sin^2 the reflectance is (S - T) Q / ((S + T) (Q + U)). A is a smooth
//! function of sin^2, singular only where that is (n -+ ik)^2, which is far from 0..1 for a metal: it is a polynomial,
//! fitted when the metal is made.

use crate::math::Real;

/// Terms of the fit.
const TERMS: usize = 7;

/// The largest relative error of a fit that is taken: a tenth of a rounding in f32.
const LARGEST_ERROR: f64 = 6e-9;

/// From this k on S - T is no difference of nearly equal numbers, S is at least 2, and Q at least 3/4.
const LEAST_K: f64 = 1.0;

/// Up to this n and k the denominators are below 2^36, and the product of three is a number in f32.
const LARGEST_INDEX: f64 = 256.0;

/// A metal of three channels.
#[derive(Clone, Copy, Debug)]
pub struct Metal<R>([Channel<R>; 3]);

/// A metal whose channels are all the same.
#[derive(Clone, Copy, Debug)]
pub struct GreyMetal<R>(Channel<R>);

impl<R: Real> Metal<R> {
    /// The metal of relative index `eta` + i `k`. `None` where a channel has no good fit, and in precisions whose functions
    /// are no polynomials.
    #[must_use]
    pub fn new([n0, n1, n2]: [R; 3], [k0, k1, k2]: [R; 3]) -> Option<Self> {
        Some(Self([
            Channel::fitted(n0, k0)?,
            Channel::fitted(n1, k1)?,
            Channel::fitted(n2, k2)?,
        ]))
    }

    /// As the metal of one channel, where all have the same index.
    #[must_use]
    pub fn grey(&self) -> Option<GreyMetal<R>> {
        let [red, green, blue] = self.0;
        (red == green && red == blue).then_some(GreyMetal(red))
    }

    /// The reflectance of each channel, 0..1, at the cosine `cos_i` of the incident direction, 0..1.
    #[inline(always)]
    pub fn reflectance(&self, cos_i: R) -> [R; 3] {
        let at = Cosines::new(cos_i);
        let [red, green, blue] = &self.0;
        let [(r, x), (g, y), (b, z)] = [red.quotient(&at), green.quotient(&at), blue.quotient(&at)];
        // One division for all.
        let (xy, yz, zx) = (x * y, y * z, z * x);
        let inverse = R::one() / (xy * z);
        [
            (r * yz * inverse).at_most(R::one()),
            (g * zx * inverse).at_most(R::one()),
            (b * xy * inverse).at_most(R::one()),
        ]
    }
}

impl<R: Real> GreyMetal<R> {
    /// The reflectance, 0..1, at the cosine `cos_i` of the incident direction, 0..1.
    #[inline(always)]
    pub fn reflectance(&self, cos_i: R) -> R {
        let (above, below) = self.0.quotient(&Cosines::new(cos_i));
        (above / below).at_most(R::one())
    }
}

/// What the channels share.
struct Cosines<R> {
    c: R,
    c2: R,
    s2: R,
    s4: R,
}

impl<R: Real> Cosines<R> {
    #[inline(always)]
    fn new(cos_i: R) -> Self {
        let one = R::one();
        let c = cos_i.at_most(one);
        let s2 = (one - c) * (one + c);
        Self {
            c,
            c2: c * c,
            s2,
            s4: s2 * s2,
        }
    }
}

/// One channel, of index n + ik.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Channel<R> {
    /// 2 A by powers of sin^2.
    twice_root: [R; TERMS],
    /// 1 - n^2 + k^2.
    rest: R,
}

impl<R: Real> Channel<R> {
    fn fitted(n: R, k: R) -> Option<Self> {
        let (n, k) = (n.as_f64(), k.as_f64());
        let is_metal = (LEAST_K..=LARGEST_INDEX).contains(&k) && n <= LARGEST_INDEX;
        if !(R::FUNCTIONS_VECTORISE && is_metal) {
            return None;
        }
        let root = |s2: f64| 2.0 * real_part_of_root(n, k, s2);
        let fit = interpolated(root);
        let is_good = |s2: f64| {
            let (exact, sum) = (root(s2), fit.iter().rfold(0.0, |sum, c| sum * s2 + c));
            (sum - exact).abs() <= LARGEST_ERROR * exact
        };
        let mut checked = (0..=64).map(|i| f64::from(i) / 64.0);
        let fitted = Self {
            twice_root: fit.map(R::of),
            rest: R::of(1.0 - (n - k) * (n + k)),
        };
        checked.all(is_good).then_some(fitted)
    }

    /// The reflectance as numerator and denominator.
    #[inline(always)]
    fn quotient(&self, at: &Cosines<R>) -> (R, R) {
        let mut twice_a = R::zero();
        for coefficient in self.twice_root.into_iter().rev() {
            twice_a = twice_a * at.s2 + coefficient;
        }
        let s = R::of(0.5) * (twice_a * twice_a) + self.rest;
        let t = twice_a * at.c;
        let q = (s - at.c2) * at.c2 + at.s4;
        ((s - t) * q, (s + t) * (q + t * at.s2))
    }
}

/// The real part of the root of (`n` - i `k`)^2 - `s2`, without cancellation.
fn real_part_of_root(n: f64, k: f64, s2: f64) -> f64 {
    let re = (n - k) * (n + k) - s2;
    let larger = (0.5 * (re.hypot(2.0 * n * k) + re.abs())).sqrt();
    if re >= 0.0 { larger } else { n * k / larger }
}

/// The polynomial through `function` at Chebyshev's nodes of 0..1, by powers.
fn interpolated(function: impl Fn(f64) -> f64) -> [f64; TERMS] {
    let node = |i: usize| {
        let angle = std::f64::consts::PI * (i as f64 + 0.5) / TERMS as f64;
        0.5 * (1.0 - angle.cos())
    };
    let nodes: [f64; TERMS] = std::array::from_fn(node);
    // Newton's divided differences.
    let mut differences = nodes.map(function);
    for order in 1..TERMS {
        let lower = differences;
        let widths = nodes.iter().zip(nodes.iter().skip(order));
        let pairs = lower.iter().zip(lower.iter().skip(1)).skip(order - 1);
        let upper = differences.iter_mut().skip(order);
        for (difference, ((a, b), (from, to))) in upper.zip(pairs.zip(widths)) {
            *difference = (b - a) / (to - from);
        }
    }
    let mut powers = [0.0; TERMS];
    for (difference, node) in differences.iter().zip(nodes).rev() {
        // Times (x - node), plus the difference.
        let mut carried = *difference;
        for power in &mut powers {
            let shifted = *power;
            *power = carried - node * shifted;
            carried = shifted;
        }
    }
    powers
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::optics::conductor::Conductor;

    /// n and k at red, green and blue: silver, gold, copper, iron, aluminium, and what is just a metal here.
    const METALS: [([f64; 3], [f64; 3]); 6] = [
        ([0.059, 0.055, 0.05], [4.28, 3.38, 2.53]),
        ([0.143, 0.375, 1.442], [3.983, 2.386, 1.603]),
        ([0.2, 0.924, 1.102], [3.912, 2.452, 2.142]),
        ([2.879, 2.949, 2.584], [3.098, 2.931, 2.77]),
        ([1.657, 0.88, 0.521], [9.224, 6.269, 4.837]),
        ([200.0, 0.0, 2.0], [250.0, 1.8, 1.4]),
    ];

    #[test]
    fn the_fit_is_the_exact_reflectance_to_some_roundings() {
        for (eta, k) in METALS {
            let singles = [eta, k].map(|values| values.map(f32::of));
            let [eta, k] = singles;
            let metal = Metal::new(eta, k).unwrap();
            let exact = Conductor::new(eta.map(Real::as_f64), k.map(Real::as_f64));
            for step in 0..=1000_u16 {
                let c = f32::from(step) / 1000.0;
                let found = metal.reflectance(c).map(Real::as_f64);
                for (found, exact) in found.into_iter().zip(exact.reflectance(c.into())) {
                    let error = (found / exact - 1.0).abs();
                    assert!(error < 6e-7, "{eta:?} {k:?} {c}: {error}");
                }
            }
        }
    }

    #[test]
    fn a_grey_metal_is_each_channel_of_it() {
        let (eta, k) = ([0.2_f32; 3], [3.9; 3]);
        let grey = Metal::new(eta, k).unwrap().grey().unwrap().reflectance(0.3);
        let [r, _, b] = Metal::new(eta, k).unwrap().reflectance(0.3);
        assert!(r == b && (r / grey - 1.0).abs() < 4e-7);
        let [n, _, _] = eta;
        assert!(Metal::new([n, n, 0.3], k).unwrap().grey().is_none());
    }

    #[test]
    fn what_is_no_metal_has_no_fit() {
        let of = |n: f32, k: f32| Metal::new([n; 3], [k; 3]);
        for (n, k) in [(1.5, 0.0), (1.0, 1e-3), (0.2, 0.9), (0.0, 1e10), (1e4, 1e4)] {
            assert!(of(n, k).is_none(), "{n} {k}");
        }
        assert!(Metal::new([0.2_f64; 3], [3.9; 3]).is_none(), "f64");
    }
}
