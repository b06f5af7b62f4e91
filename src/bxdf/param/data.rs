//! The data of a model's parameters.

use std::sync::Arc;

use super::{ParamSet, ParamSpec, Value};
use crate::error::Result;
use crate::resource::Resource;

impl ParamSet {
    /// Sets the data of the parameter `name`.
    ///
    /// # Errors
    /// [`Error::UnknownId`](crate::Error::UnknownId) where the model has no such parameter of kind data; the set is then unchanged.
    pub fn set_resource(&mut self, name: &str, resource: Resource) -> Result<()> {
        let index = self.index_of(name).ok_or_else(|| self.unknown(name))?;
        match self.values.get_mut(index) {
            Some(value @ Value::Data(_)) => *value = Value::Data(true),
            _ => return Err(self.unknown(name)),
        }
        self.resources.retain(|(place, _)| *place != index);
        self.resources.push((index, resource));
        Ok(())
    }

    /// The data of the parameter `name`, wherever it comes from, and whether or not it is here.
    #[must_use]
    pub fn resource(&self, name: &str) -> Option<&Resource> {
        let index = self.index_of(name)?;
        let mut resources = self.resources.iter();
        resources.find_map(|(place, resource)| (*place == index).then_some(resource))
    }

    /// All data, each with its spec.
    pub fn resources(&self) -> impl Iterator<Item = (&'static ParamSpec, &Resource)> {
        let spec = |(place, resource)| Some((self.specs.get(place)?, resource));
        self.resources
            .iter()
            .map(|(place, resource)| (*place, resource))
            .filter_map(spec)
    }

    /// Changes all data.
    pub fn map_resources(&mut self, change: &mut dyn FnMut(&'static ParamSpec, &mut Resource)) {
        for (place, resource) in &mut self.resources {
            if let Some(spec) = self.specs.get(*place) {
                change(spec, resource);
            }
        }
    }

    /// What was read of the data of the parameter `name`, where it is here and of this type.
    #[must_use]
    pub fn data<T: Send + Sync + 'static>(&self, name: &str) -> Option<Arc<T>> {
        self.resource(name)?.decoded()?.value()
    }
}
