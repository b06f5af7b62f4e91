//! What cheaper numbers cost here.

use xprec::Df64;

use super::quantity::{Argument, Given, Quantity, Value, word};
use super::scene::Scene;
use crate::analysis::Channel;
use crate::rounding::relative_difference;
use bxdf::math::{Vec3, frame};
use bxdf::{Material, Precision, Rotated, Scatterer};

pub(super) const QUANTITY: Quantity = Quantity {
    id: "error",
    symbol: "error",
    unit: "",
    meaning: "The relative error of f here in a precision, f32 or f64, rounded directions included, or with a stand-in of \
        the material by its name",
    arguments: &[Argument::name("of")],
    value,
};

fn value(scene: &Scene, given: &[Given]) -> Value {
    let name = word(given, 0);
    let exact = at::<Df64>(scene, scene.material());
    let value = match name.as_str() {
        "f32" => at::<f32>(scene, scene.material()),
        "f64" => at::<f64>(scene, scene.material()),
        _ => at::<Df64>(scene, &stand_in(scene.material(), &name)?),
    };
    Ok(relative_difference(value, exact))
}

/// The luminance of f at the pair.
fn at<R: Precision>(scene: &Scene, material: &Material) -> f64 {
    let (cos, sin) = frame::cos_sin_deg(scene.rotation_deg());
    let turn = (R::of(cos), R::of(sin));
    let surface: Box<dyn Scatterer<R>> = Box::new(Rotated::new(material.build(), turn));
    let [wo, wi] = [scene.viewer(), scene.light()].map(Vec3::from);
    Channel::Luminance.of(surface.f(wo, wi).to_f64())
}

/// The material with a stand-in for its first component that has one of this name.
fn stand_in(material: &Material, name: &str) -> Result<Material, String> {
    let mut components = material.components().to_vec();
    let found = components.iter_mut().find_map(|component| {
        let mut all = component.stand_ins();
        let replaced = all.find(|(stand_in, _)| stand_in.name == name)?.1;
        drop(all);
        *component = replaced;
        Some(())
    });
    if found.is_none() {
        let all = material.components().iter();
        let names = all.flat_map(|component| component.stand_ins().map(|(one, _)| one.name));
        let names: Vec<&str> = ["f32", "f64"].into_iter().chain(names).collect();
        return Err(format!(
            "nothing called '{name}': there is {}",
            names.join(", ")
        ));
    }
    material
        .with_components(components)
        .map_err(|error| error.to_string())
}
