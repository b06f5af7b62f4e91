//! The catalogue: one file per model, and the one list of them.

mod ashikhmin_shirley;
mod blinn_phong;
mod burley_diffuse;
mod charlie_sheen;
mod cook_torrance;
pub(crate) mod eon;
mod fresnel_specular;
mod hapke;
mod lambertian_reflection;
mod lambertian_transmission;
mod oren_nayar;
mod phong;
mod plastic;
mod principled;
mod retro_reflector;
mod rough_conductor;
mod rough_dielectric;
mod specular_reflection;
mod specular_transmission;
mod table;
mod thin_dielectric;
mod velvet;
mod ward;

use super::batch::loops;
use super::math::{Real, Vec3};
use super::param::{ParamSpec, Role, Value};
use super::spec::{Category, Declaration, Law, Lobe, ModelSpec, Properties, Side, StandIn};
use super::{Bxdf, Sample};
use crate::builders;
use crate::error::Result;

/// Every model, in the order of the catalogue: grouped by category.
pub static MODELS: [&ModelSpec; 23] = [
    &lambertian_reflection::SPEC,
    &lambertian_transmission::SPEC,
    &oren_nayar::SPEC,
    &eon::SPEC,
    &burley_diffuse::SPEC,
    &rough_conductor::SPEC,
    &rough_dielectric::SPEC,
    &plastic::SPEC,
    &phong::SPEC,
    &blinn_phong::SPEC,
    &ward::SPEC,
    &ashikhmin_shirley::SPEC,
    &cook_torrance::SPEC,
    &principled::SPEC,
    &table::SPEC,
    &specular_reflection::SPEC,
    &specular_transmission::SPEC,
    &fresnel_specular::SPEC,
    &thin_dielectric::SPEC,
    &retro_reflector::SPEC,
    &hapke::SPEC,
    &velvet::SPEC,
    &charlie_sheen::SPEC,
];

/// The model to begin with: its lobe shows at once what the direction of the light does.
pub static START: &ModelSpec = &rough_conductor::SPEC;

/// The reflectance of a diffuse or wholly reflecting surface.
const REFLECTANCE: ParamSpec = ParamSpec::rgb(
    "reflectance",
    [0.8; 3],
    "Share of the light that is reflected, per channel; black absorbs all",
);

/// What may replace a rough diffuse surface of [`REFLECTANCE`].
const LAMBERT: StandIn = StandIn {
    name: "Lambert for the rough diffuse lobe",
    lost: "The lobe is round: no brightening back towards the light, no change towards the horizon",
    replace: |params| {
        let reflectance = Value::Rgb(params.rgb("reflectance"));
        lambertian_reflection::SPEC.text_at(&[("reflectance", reflectance)])
    },
};

/// The relative index of refraction of a dielectric below the surface.
const DIELECTRIC_ETA: ParamSpec = ParamSpec::number(
    "eta",
    1.5,
    "Index of refraction below the surface over the one above: 1.33 water, 1.5 glass, 2.42 diamond",
)
.role(Role::Index)
.hard(DIELECTRIC_ETA_RANGE[0], DIELECTRIC_ETA_RANGE[1])
.soft(1.0, 3.0);

/// Hard range of a dielectric's relative index: beyond it no medium exists, and the formulas are not tested.
const DIELECTRIC_ETA_RANGE: [f64; 2] = [0.25, 1000.0];

/// The real part of a conductor's relative index: that of gold with the colour of its spectrum, as the material has it (a
/// test holds both against the table of gold). Its red reflects everything, whatever its k.
const CONDUCTOR_ETA: ParamSpec = ParamSpec::rgb(
    "eta",
    [0.0, 0.5032, 1.463],
    "Index of refraction n of the metal, per channel",
)
.role(Role::Index)
.hard(0.0, 1e4)
.soft(0.0, 5.0);

/// The imaginary part of a conductor's relative index.
const CONDUCTOR_K: ParamSpec = ParamSpec::rgb(
    "k",
    [3.208, 2.268, 1.774],
    "Absorption index k of the metal, per channel; larger means a more perfect mirror",
)
.role(Role::Absorption)
.hard(0.0, 1e10)
.soft(0.0, 10.0);

/// Refuses eta = k = 0 in any channel: such a medium has no Fresnel reflectance.
#[inline(always)]
fn refuse_zero_index(params: &super::param::ParamSet) -> Result<()> {
    let (eta, k) = (params.rgb("eta"), params.rgb("k"));
    if eta.iter().zip(k).any(|(&n, k)| n == 0.0 && k == 0.0) {
        return Err(params.error(
            "eta",
            "eta and k may not both be 0 in a channel: no medium has index 0",
        ));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ids_are_unique_and_models_build_in_every_precision() {
        for (index, model) in MODELS.iter().enumerate() {
            assert!(
                MODELS
                    .iter()
                    .skip(index + 1)
                    .all(|other| other.id != model.id)
            );
            let params = model.defaults();
            assert!((model.validate)(&params).is_ok(), "{}", model.id);
            for (spec, value) in params.iter() {
                assert!(spec.allows(value), "{}:{}", model.id, spec.name);
                assert!(
                    spec.hard[0] <= spec.soft[0] && spec.soft[1] <= spec.hard[1],
                    "{}:{}",
                    model.id,
                    spec.name
                );
                assert!(
                    !spec.meaning.is_empty() && !spec.meaning.ends_with('.'),
                    "{}:{}",
                    model.id,
                    spec.name
                );
                assert!(params.is_relevant(spec) || spec.relevant_when.is_some());
            }
            let (up, side) = (Vec3::new(0.0, 0.0, 1.0), Vec3::new(0.6, 0.0, 0.8));
            let value = model.build::<f64>(&params).f(up, side).to_f64();
            let single = model
                .build::<f32>(&params)
                .f(Vec3::new(0.0, 0.0, 1.0), Vec3::new(0.6, 0.0, 0.8))
                .to_f64();
            assert!(
                value
                    .iter()
                    .zip(single)
                    .all(|(v, s)| (v - s).abs() <= 1e-5 * v),
                "{}",
                model.id
            );
        }
    }

    #[test]
    fn categories_stand_together_in_the_list() {
        let categories: Vec<Category> = MODELS.iter().map(|model| model.category()).collect();
        for category in Category::ALL {
            let first = categories.iter().position(|c| *c == category);
            let last = categories.iter().rposition(|c| *c == category);
            let (first, last) = (first.expect("a model of each category"), last.unwrap());
            assert!(
                categories[first..=last].iter().all(|c| *c == category),
                "{category:?}"
            );
        }
    }
}
