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

use crate::spec::ModelSpec;

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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lobe::Category;
    use crate::math::Vec3;
    use crate::param::{Kind, Role};

    #[test]
    fn parameters_of_one_name_mean_the_same() {
        for spec in MODELS.iter().flat_map(|model| model.parameters) {
            let expected = match spec.name {
                "alpha_x" => Role::WidthS,
                "alpha_y" => Role::WidthT,
                "alpha" | "m" | "roughness" => Role::Width,
                "eta" => Role::Index,
                "k" => Role::Absorption,
                "fresnel" => Role::Fresnel,
                "distribution" => Role::Distribution,
                _ if spec.kind == Kind::Rgb => Role::Colour,
                _ => Role::Plain,
            };
            assert_eq!(spec.role, expected, "{}", spec.name);
            assert!(
                spec.role != Role::Colour || spec.hard == [0.0, 1.0],
                "{}",
                spec.name
            );
        }
    }

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
