//! Facets of a clear surface: of two directions, the one that mirrors or refracts the one into the other.

use super::Pair;
use crate::are_across;
use crate::math::{Real, Vec3};
use crate::optics::fresnel::RelativeIndex;
use crate::optics::interface::Interface;

/// A facet that turns `wo` into `wi`, in the frame in which `wo` is above.
#[derive(Clone, Copy, Debug)]
pub struct Facet<R> {
    /// The directions, and the normal of the facet.
    pub pair: Pair<R>,
    /// Reflectance or transmittance, whichever turns `wo` into `wi`.
    pub share: R,
    /// 4 |wo.h| times the solid angle of h per solid angle of `wi`: 1 in reflection.
    pub stretch: R,
    /// 4 |wo.h wi.h| / |g|^2, the same for f: 1 in reflection.
    pub factor: R,
}

/// Two directions with the unit normal `wh` along their sum g, and the length of that.
struct Half<R> {
    wo: Vec3<R>,
    wi: Vec3<R>,
    wh: Vec3<R>,
    length: R,
}

impl<R: Real> Facet<R> {
    /// The facet of such an `interface` at the half vector of two directions: the one that mirrors, or the one that
    /// refracts. One root and one division serve both. `across` is the index on the other side over that on the side of
    /// `wo`. `None` where no facet does.
    #[inline(always)]
    pub fn between(
        wo: Vec3<R>,
        wi: Vec3<R>,
        across: RelativeIndex<R>,
        interface: &impl Interface<R>,
    ) -> Option<Self> {
        let is_across = are_across(wo, wi);
        let (wo, wi) = upright(wo, wi);
        // wo + e wi; where the index is near 1, the sum of the nearly opposed first.
        let g = if !is_across {
            wo + wi
        } else if across.minus_1.abs() < R::of(0.5) {
            (wo + wi) + wi * across.minus_1
        } else {
            wo + wi * across.n
        };
        let (unit, length) = g.unit_and_length()?;
        let wh = if unit.z < R::zero() { -unit } else { unit };
        let half = Half { wo, wi, wh, length };
        if is_across {
            Self::refractor(&half, across.n, interface)
        } else {
            Self::mirror(&half, across, interface)
        }
    }

    /// The facet that mirrors, g being wo + wi.
    #[inline(always)]
    fn mirror(
        half: &Half<R>,
        across: RelativeIndex<R>,
        interface: &impl Interface<R>,
    ) -> Option<Self> {
        let &Half { wo, wi, wh, length } = half;
        if wo.z <= R::zero() || wi.z <= R::zero() {
            return None;
        }
        let pair = Pair {
            wo,
            wi,
            wh,
            cos_d: (length * R::of(0.5)).at_most(R::one()),
        };
        Some(Self {
            share: pair.dielectric(interface, across).reflectance,
            pair,
            stretch: R::one(),
            factor: R::one(),
        })
    }

    /// The facet that refracts, g being wo + e wi.
    #[inline(always)]
    fn refractor(half: &Half<R>, e: R, interface: &impl Interface<R>) -> Option<Self> {
        let &Half { wo, wi, wh, length } = half;
        let (cos_o, cos_i) = (wo.dot(wh), -wi.dot(wh));
        if cos_o <= R::zero() || cos_i <= R::zero() {
            return None;
        }
        let jacobian = R::of(4.0) * cos_o * cos_i / (length * length);
        Some(Self {
            pair: Pair {
                wo,
                wi,
                wh,
                cos_d: cos_o,
            },
            share: interface.transmittance_between(cos_o, cos_i, e),
            stretch: jacobian * (e * e),
            factor: jacobian,
        })
    }
}

/// `wo` and `wi`, mirrored in the surface where `wo` is below.
#[inline(always)]
pub fn upright<R: Real>(wo: Vec3<R>, wi: Vec3<R>) -> (Vec3<R>, Vec3<R>) {
    if wo.z < R::zero() {
        (wo.mirrored_in_surface(), wi.mirrored_in_surface())
    } else {
        (wo, wi)
    }
}
