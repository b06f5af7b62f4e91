//! What the files of models have in common: the names they need, and the parameters that several have.

pub(crate) use crate::batch::{Scatterer, loops};
pub(crate) use crate::builders;
pub(crate) use crate::error::Result;
pub(crate) use crate::lobe::{Category, Lobe, Side};
pub(crate) use crate::lobes::Lobes;
pub(crate) use crate::math::{Real, Vec3};
pub(crate) use crate::param::{ParamSpec, Role, Value};
pub(crate) use crate::sample::Sample;
pub(crate) use crate::scattering::Bxdf;
pub(crate) use crate::spec::{Declaration, Law, ModelSpec, Properties, StandIn};

/// The reflectance of a diffuse or wholly reflecting surface.
pub(crate) const REFLECTANCE: ParamSpec = ParamSpec::rgb(
    "reflectance",
    [0.8; 3],
    "Share of the light that is reflected, per channel; black absorbs all",
);

/// The relative index of refraction of a dielectric below the surface.
pub(crate) const DIELECTRIC_ETA: ParamSpec = ParamSpec::number(
    "eta",
    1.5,
    "Index of refraction below the surface over the one above: 1.33 water, 1.5 glass, 2.42 diamond",
)
.role(Role::Index)
.hard(DIELECTRIC_ETA_RANGE[0], DIELECTRIC_ETA_RANGE[1])
.soft(1.0, 3.0);

/// Hard range of a dielectric's relative index: beyond it no medium exists, and the formulas are not tested.
pub(crate) const DIELECTRIC_ETA_RANGE: [f64; 2] = [0.25, 1000.0];

/// The real part of a conductor's relative index: that of gold with the colour of its spectrum, as the material has it (a
/// test holds both against the table of gold). Its red reflects everything, whatever its k.
pub(crate) const CONDUCTOR_ETA: ParamSpec = ParamSpec::rgb(
    "eta",
    [0.0, 0.5032, 1.463],
    "Index of refraction n of the metal, per channel",
)
.role(Role::Index)
.hard(0.0, 1e4)
.soft(0.0, 5.0);

/// The imaginary part of a conductor's relative index.
pub(crate) const CONDUCTOR_K: ParamSpec = ParamSpec::rgb(
    "k",
    [3.208, 2.268, 1.774],
    "Absorption index k of the metal, per channel; larger means a more perfect mirror",
)
.role(Role::Absorption)
.hard(0.0, 1e10)
.soft(0.0, 10.0);

/// Refuses eta = k = 0 in any channel: such a medium has no Fresnel reflectance.
#[inline(always)]
pub(crate) fn refuse_zero_index(params: &crate::param::ParamSet) -> Result<()> {
    let (eta, k) = (params.rgb("eta"), params.rgb("k"));
    if eta.iter().zip(k).any(|(&n, k)| n == 0.0 && k == 0.0) {
        return Err(params.error(
            "eta",
            "eta and k may not both be 0 in a channel: no medium has index 0",
        ));
    }
    Ok(())
}
