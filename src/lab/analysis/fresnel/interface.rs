//! The interfaces of a material: which of its lobes have an index of refraction.

use super::face::Index;
use crate::analysis::Channel;
use bxdf::param::{ParamSet, Role, Value};
use bxdf::{Component, Material};

/// A smooth interface between the medium above the surface and the one below.
#[derive(Clone, Debug, PartialEq)]
pub struct Interface {
    /// The index below the surface over the one above, of each channel; of all at once, by no channel, where they have the
    /// same.
    pub channels: Vec<(Option<Channel>, Index)>,
}

impl Interface {
    /// That of a lobe: what its parameters mean says so. `None` where it has no index of refraction that has an effect.
    #[must_use]
    pub fn of(component: &Component) -> Option<Self> {
        let params = component.params();
        let n = of_role(params, Role::Index)?;
        let k = of_role(params, Role::Absorption).unwrap_or_default();
        let index = |(n, k)| Index { n, k };
        let [red, green, blue] = [0, 1, 2].map(|at: usize| {
            let of = |rgb: [f64; 3]| rgb.get(at).copied().unwrap_or_default();
            index((of(n), of(k)))
        });
        let interface = if red == green && red == blue {
            Self::grey(red)
        } else {
            let channels = [Channel::Red, Channel::Green, Channel::Blue].map(Some);
            Self {
                channels: channels.into_iter().zip([red, green, blue]).collect(),
            }
        };
        let is_medium = |(_, index): &(_, Index)| index.is_medium();
        interface
            .channels
            .iter()
            .all(is_medium)
            .then_some(interface)
    }

    /// One that is the same for all light.
    #[must_use]
    pub fn grey(index: Index) -> Self {
        Self {
            channels: vec![(None, index)],
        }
    }

    /// Whether light is absorbed below, so that there is no looking from there.
    #[must_use]
    pub fn is_absorbing(&self) -> bool {
        self.channels.iter().any(|(_, index)| index.is_absorbing())
    }
}

/// The value of the parameter that means this, where it has an effect.
fn of_role(params: &ParamSet, role: Role) -> Option<[f64; 3]> {
    let (spec, value) = params.of_role(role)?;
    match value {
        _ if !params.is_relevant(spec) => None,
        Value::Number(x) => Some([x; 3]),
        Value::Rgb(rgb) => Some(rgb),
        _ => None,
    }
}

/// The lobes of `material` that have an interface.
pub fn lobes(material: &Material) -> impl Iterator<Item = &Component> {
    let has_one = |component: &&Component| Interface::of(component).is_some();
    material.components().iter().filter(has_one)
}

/// The lobe at `place` among those that have an interface; the last where there are fewer, `None` where there is none.
#[must_use]
pub fn lobe(material: &Material, place: usize) -> Option<&Component> {
    lobes(material).take(place.saturating_add(1)).last()
}
