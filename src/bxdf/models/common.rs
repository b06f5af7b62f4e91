//! What the files of models have in common: the names they need, and the parameters that several have.

pub(super) use crate::batch::{Scatterer, loops};
pub(super) use crate::builders;
pub(super) use crate::error::Result;
pub(super) use crate::lobe::{Category, Lobe, Side};
pub(super) use crate::lobes::Lobes;
pub(super) use crate::math::{Real, Vec3};
pub(super) use crate::param::{ParamSpec, Role, Value};
pub(super) use crate::sample::Sample;
pub(super) use crate::scattering::Bxdf;
pub(super) use crate::spec::{Declaration, Law, ModelSpec, Properties, StandIn};

/// The reflectance of a diffuse or wholly reflecting surface.
pub(super) const REFLECTANCE: ParamSpec = ParamSpec::rgb(
    "reflectance",
    [0.8; 3],
    "Share of the light that is reflected, per channel; black absorbs all",
);

/// The relative index of refraction of a dielectric below the surface.
pub(super) const DIELECTRIC_ETA: ParamSpec = ParamSpec::number(
    "eta",
    1.5,
    "Index of refraction below the surface over the one above: 1.33 water, 1.5 glass, 2.42 diamond",
)
.role(Role::Index)
.hard(DIELECTRIC_ETA_RANGE[0], DIELECTRIC_ETA_RANGE[1])
.soft(1.0, 3.0);

/// Hard range of a dielectric's relative index: beyond it no medium exists, and the formulas are not tested.
pub(super) const DIELECTRIC_ETA_RANGE: [f64; 2] = [0.25, 1000.0];

/// The real part of a conductor's relative index: that of gold with the colour of its spectrum, as the material has it (a
/// test holds both against the table of gold). Its red reflects everything, whatever its k.
pub(super) const CONDUCTOR_ETA: ParamSpec = ParamSpec::rgb(
    "eta",
    [0.0, 0.5032, 1.463],
    "Index of refraction n of the metal, per channel",
)
.role(Role::Index)
.hard(0.0, 1e4)
.soft(0.0, 5.0);

/// The imaginary part of a conductor's relative index.
pub(super) const CONDUCTOR_K: ParamSpec = ParamSpec::rgb(
    "k",
    [3.208, 2.268, 1.774],
    "Absorption index k of the metal, per channel; larger means a more perfect mirror",
)
.role(Role::Absorption)
.hard(0.0, 1e10)
.soft(0.0, 10.0);

/// Refuses eta = k = 0 in any channel: such a medium has no Fresnel reflectance.
#[inline(always)]
pub(super) fn refuse_zero_index(params: &crate::param::ParamSet) -> Result<()> {
    let (eta, k) = (params.rgb("eta"), params.rgb("k"));
    if eta.iter().zip(k).any(|(&n, k)| n == 0.0 && k == 0.0) {
        return Err(params.error(
            "eta",
            "eta and k may not both be 0 in a channel: no medium has index 0",
        ));
    }
    Ok(())
}
