//! The parameters of a component, given by name.

use std::str::FromStr;

use super::Component;
use crate::catalogue::Catalogue;
use crate::error::{Error, Result, shown};
use crate::param::{Kind, ParamSet, ParamSpec};
use crate::resource::Resource;
use crate::spec::ModelSpec;

/// A component whose parameters are given one by one, by name, in any order: all together must be allowed, and none may be
/// given twice.
pub(super) struct Assignments {
    model: &'static ModelSpec,
    params: ParamSet,
    /// What is given: a parameter, and the name under which it was.
    given: Vec<(String, String)>,
}

impl Assignments {
    /// `model`, nothing given yet.
    pub(super) fn of(model: &'static ModelSpec) -> Self {
        Self {
            model,
            params: model.defaults(),
            given: Vec::new(),
        }
    }

    /// Sets a parameter from its text, which is that of one value whatever it holds.
    ///
    /// # Errors
    /// As [`ParamSet::set_text`], and [`Error::Parse`] where the parameter was given before, by this or another name.
    pub(super) fn set(&mut self, name: &str, text: &str) -> Result<()> {
        let targets = self.params.targets(name);
        for target in &targets {
            if let Some((_, before)) = self.given.iter().find(|(given, _)| given == target) {
                let problem = if before == name {
                    format!("{} is given twice", shown(name))
                } else {
                    format!("{before} and {name} both set {target}")
                };
                return Err(Error::parse(self.model.id, problem));
            }
        }
        self.params.set_text(name, text)?;
        let given = targets.into_iter();
        self.given
            .extend(given.map(|target| (target.to_owned(), name.to_owned())));
        Ok(())
    }

    /// The spec of the parameter `name`, where it is of kind data.
    pub(super) fn data(&self, name: &str) -> Option<&'static ParamSpec> {
        let spec = self.params.spec(name).ok()?;
        (spec.kind == Kind::Data).then_some(spec)
    }

    /// Sets the data of a parameter.
    ///
    /// # Errors
    /// As [`ParamSet::set_resource`].
    pub(super) fn set_resource(&mut self, name: &str, resource: Resource) -> Result<()> {
        self.params.set_resource(name, resource)
    }

    /// The component, of weight 1.
    ///
    /// # Errors
    /// Where the model refuses the combination.
    pub(super) fn finish(self) -> Result<Component> {
        Component::at(self.model, self.params)
    }
}

impl FromStr for Component {
    type Err = Error;

    /// Reads `id` or `id:name=value,name=value`, weight 1; all parameters together must be allowed, their order does not matter.
    fn from_str(text: &str) -> Result<Self> {
        let (id, assignments) = text.split_once(':').unwrap_or((text, ""));
        let mut component = Assignments::of(Catalogue::current().find(id.trim())?);
        for assignment in assignments
            .split(',')
            .map(str::trim)
            .filter(|part| !part.is_empty())
        {
            let (name, value) = assignment.split_once('=').ok_or_else(|| {
                Error::parse(
                    format!("material '{}'", shown(text)),
                    format!("'{}' is not name=value", shown(assignment)),
                )
            })?;
            component.set(name.trim(), value.trim())?;
        }
        component.finish()
    }
}
