//! What is measured: a material, with what every family needs of it.

use glam::DVec3;

use super::errors::{Baseline, Values};
use super::probe::Probe;
use bxdf::math::frame::direction_from_degrees;
use bxdf::{Material, Scatterer};

/// Why a family has no (more) points.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Stop {
    /// It does not apply to this material, with the reason: a sentence's end after "because".
    NotApplicable(String),
    /// Nobody wants it any more.
    Unwanted,
}

/// The direction of view at which reflectances are estimated unless another one is given: polar angle and azimuth, degrees.
pub const DIRECTION_DEG: [f64; 2] = [45.0, 30.0];

/// A material with what every family needs of it.
pub struct Study<'a> {
    /// The material.
    pub material: &'a Material,
    /// The direction of view at which reflectances are estimated, a unit vector.
    pub held: DVec3,
    bxdf: Box<dyn Scatterer<f64>>,
    pub(super) probe: Probe,
}

impl<'a> Study<'a> {
    /// `material` seen along `held`, a unit vector; `None` for [`DIRECTION_DEG`].
    #[must_use]
    pub fn new(material: &'a Material, held: Option<DVec3>) -> Self {
        let bxdf = material.build();
        let [theta, phi] = DIRECTION_DEG;
        Self {
            probe: Probe::new(material, &*bxdf),
            held: held.unwrap_or_else(|| direction_from_degrees(theta, phi)),
            bxdf,
            material,
        }
    }

    pub(super) fn bxdf(&self) -> &dyn Scatterer<f64> {
        &*self.bxdf
    }

    /// # Errors
    /// [`Stop::NotApplicable`] where there are no values to be compared.
    pub(super) fn baseline<'b>(&'b self, exact: Values<'b>) -> Result<Baseline<'b>, Stop> {
        let baseline = Baseline::new(&self.probe, exact);
        if baseline.is_black() {
            let reason = "its light is all in Dirac deltas, which have no values to be off";
            return Err(Stop::NotApplicable(reason.to_owned()));
        }
        Ok(baseline)
    }
}
