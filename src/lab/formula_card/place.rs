//! Where a formula is worked out: the parameters, and a pair of directions.

use glam::DVec3;

use super::term::{Terms, VALUE, WEIGHT};
use bxdf::Spectrum;
use bxdf::param::ParamSet;

/// Parameters and directions, in the frame of the surface; the viewer is above, the surface mirrored where it was not.
pub(super) struct Place<'a> {
    pub(super) params: &'a ParamSet,
    /// To the viewer.
    pub(super) wo: DVec3,
    /// To the light.
    pub(super) wi: DVec3,
    /// Whether the viewer was below.
    pub(super) is_from_below: bool,
}

/// A pair of directions above the surface, with their half vector.
pub(super) struct Pair {
    pub(super) wo: DVec3,
    pub(super) wi: DVec3,
    /// The half vector.
    pub(super) h: DVec3,
    /// The cosine of each direction with it.
    pub(super) cos_d: f64,
}

impl Pair {
    pub(super) fn mu_o(&self) -> f64 {
        self.wo.z
    }

    pub(super) fn mu_i(&self) -> f64 {
        self.wi.z
    }

    /// The square of the sine that goes with [`Self::cos_d`].
    pub(super) fn sin2_d(&self) -> f64 {
        (self.wo - self.wi).length_squared() * 0.25
    }
}

impl<'a> Place<'a> {
    /// `None` where a direction lies in the horizon.
    pub(super) fn new(params: &'a ParamSet, wo: DVec3, wi: DVec3) -> Option<Self> {
        let mirrored = |w: DVec3| DVec3::new(w.x, w.y, -w.z);
        let is_from_below = wo.z < 0.0;
        let (wo, wi) = if is_from_below {
            (mirrored(wo), mirrored(wi))
        } else {
            (wo, wi)
        };
        (wo.z != 0.0 && wi.z != 0.0).then_some(Self {
            params,
            wo,
            wi,
            is_from_below,
        })
    }

    /// Whether the directions lie on two sides of the surface.
    pub(super) fn is_across(&self) -> bool {
        self.wi.z < 0.0
    }

    /// The pair where both lie on one side, and have a half vector.
    pub(super) fn pair(&self) -> Option<Pair> {
        if self.is_across() {
            return None;
        }
        let sum = self.wo + self.wi;
        Some(Pair {
            wo: self.wo,
            wi: self.wi,
            h: sum.try_normalize()?,
            cos_d: (0.5 * sum.length()).min(1.0),
        })
    }

    /// The index on the light's side over that on the viewer's, of a surface of relative index `eta`.
    pub(super) fn index_across(&self, eta: f64) -> f64 {
        if self.is_from_below { 1.0 / eta } else { eta }
    }

    /// No terms yet.
    pub(super) fn terms(&self) -> Terms<'a> {
        Terms::of(self.params)
    }
}

impl Terms<'_> {
    /// The cosines of both directions with n.
    pub(super) fn cosines(&mut self, pair: &Pair) {
        self.number(
            [
                r"\light{\mu_i}",
                r"\normal{n}\cdot\light{\omega_i}",
                "The cosine of the angle from n to the light",
            ],
            pair.mu_i(),
        );
        self.number(
            [
                r"\viewer{\mu_o}",
                r"\normal{n}\cdot\viewer{\omega_o}",
                "The cosine of the angle from n to the viewer",
            ],
            pair.mu_o(),
        );
    }

    /// The cosines of the half vector with n and with both directions.
    pub(super) fn half(&mut self, pair: &Pair) {
        self.number(
            [
                r"\half{h}\cdot\normal{n}",
                "",
                "The cosine of the angle from n to the half vector",
            ],
            pair.h.z,
        );
        self.cos_d(pair);
    }

    /// The cosine of the half vector with both directions.
    pub(super) fn cos_d(&mut self, pair: &Pair) {
        self.number(
            [
                r"\half{h}\cdot\light{\omega_i}",
                r"\tfrac{1}{2}\,|\light{\omega_i} + \viewer{\omega_o}|",
                "The cosine of the angle from the half vector to the light, and to the viewer",
            ],
            pair.cos_d,
        );
    }

    /// f itself.
    pub(super) fn f(&mut self, formula: &'static str, f: Spectrum<f64>) {
        self.value(
            [VALUE, formula, "The value of the BSDF, without the cosine"],
            f,
        );
    }

    /// The weight of a Dirac delta, which f has no value for.
    pub(super) fn weight(&mut self, formula: &'static str, weight: Spectrum<f64>) {
        self.rgb(
            [WEIGHT, formula, "The weight of the Dirac delta: the viewer's radiance over that of its one direction"],
            weight,
        );
    }
}
