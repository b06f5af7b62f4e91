//! The validated values of a model's parameters.

use std::fmt;

use super::{Kind, ParamSpec, Role, Value};
use crate::error::{Error, Result};
use crate::resource::{Origin, Resource, Stored};

/// The values of a model's parameters: one per spec, in the order of the specs, each allowed by its spec.
#[derive(Clone, Debug)]
pub struct ParamSet {
    model: &'static str,
    pub(super) specs: &'static [ParamSpec],
    pub(super) values: Vec<Value>,
    /// The data of the parameters of that kind that have some, by their places among the specs.
    pub(super) resources: Vec<(usize, Resource)>,
}

impl PartialEq for ParamSet {
    fn eq(&self, other: &Self) -> bool {
        let [own, others] = [self, other].map(|set| (set.model, &set.values, &set.resources));
        own == others
    }
}

impl ParamSet {
    /// The defaults of `specs`; `model` is named in errors.
    #[must_use]
    pub fn defaults(model: &'static str, specs: &'static [ParamSpec]) -> Self {
        Self {
            model,
            specs,
            values: specs.iter().map(|spec| spec.default).collect(),
            resources: Vec::new(),
        }
    }

    /// Each spec with its value, in the order of the specs.
    pub fn iter(&self) -> impl Iterator<Item = (&'static ParamSpec, Value)> + '_ {
        self.specs.iter().zip(self.values.iter().copied())
    }

    /// Whether the parameter has an effect at the present values of the others.
    #[must_use]
    pub fn is_relevant(&self, spec: &ParamSpec) -> bool {
        spec.relevant_when
            .is_none_or(|(name, words)| words.contains(&self.choice(name)))
    }

    /// Sets the parameter `name` to `value`.
    ///
    /// # Errors
    /// [`Error::UnknownId`] where the model has no such parameter, [`Error::Parameter`] where its range does not
    /// include the value; the set is then unchanged.
    pub fn set(&mut self, name: &str, value: Value) -> Result<()> {
        let index = self.index_of(name).ok_or_else(|| self.unknown(name))?;
        let (Some(spec), Some(slot)) = (self.specs.get(index), self.values.get_mut(index)) else {
            return Err(self.unknown(name));
        };
        if !spec.allows(value) {
            return Err(refused(self.model, spec, &value.to_string()));
        }
        *slot = value;
        if value == Value::Data(false) {
            self.resources.retain(|(place, _)| *place != index);
        }
        Ok(())
    }

    /// The first parameter that means this, with its value.
    #[must_use]
    pub fn of_role(&self, role: Role) -> Option<(&'static ParamSpec, Value)> {
        self.iter().find(|(spec, _)| spec.role == role)
    }

    /// The names of the widths along s and t, where the model has them.
    #[must_use]
    pub fn widths(&self) -> Option<[&'static str; 2]> {
        let name = |role| self.of_role(role).map(|(spec, _)| spec.name);
        Some([name(Role::WidthS)?, name(Role::WidthT)?])
    }

    /// The parameters that [`Self::set_text`] sets under `name`: that one, or both widths under what their names begin with,
    /// `alpha` for `alpha_x` and `alpha_y`.
    #[must_use]
    pub fn targets<'a>(&self, name: &'a str) -> Vec<&'a str> {
        match self.widths() {
            Some(widths) if self.index_of(name).is_none() && name == stem(widths) => {
                widths.to_vec()
            }
            _ => vec![name],
        }
    }

    /// Sets the parameter `name` from its text: a number, `r/g/b`, a word, `true` or `false`; for data the name of a file, or
    /// what would stand in it. `alpha` sets `alpha_x` and `alpha_y`.
    ///
    /// # Errors
    /// As [`Self::set`], and [`Error::Parameter`] where the text is not of the parameter's kind; what the decoders of data
    /// refuse.
    pub fn set_text(&mut self, name: &str, text: &str) -> Result<()> {
        for target in self.targets(name) {
            let spec = self.spec(target)?;
            if spec.kind == Kind::Data {
                let stored = Stored {
                    decoders: spec.decoders,
                };
                self.set_resource(target, stored.word(text)?)?;
                continue;
            }
            let value = spec
                .parse(text)
                .ok_or_else(|| refused(self.model, spec, text))?;
            self.set(target, value)?;
        }
        Ok(())
    }

    /// The set with these values in place of its own. `None` where the model has no such parameter, or a range that does
    /// not include the value.
    #[must_use]
    pub fn with(&self, values: &[(&str, Value)]) -> Option<Self> {
        let mut changed = self.clone();
        for (name, value) in values {
            changed.set(name, *value).ok()?;
        }
        Some(changed)
    }

    /// The set with the number `name` where its range need not reach: for a look inside a model's core, whose formulas
    /// hold on beyond what is allowed. `None` where the model has no such number.
    #[must_use]
    pub(crate) fn beyond_range(&self, name: &str, value: f64) -> Option<Self> {
        let index = self.index_of(name)?;
        let mut changed = self.clone();
        let slot = changed.values.get_mut(index)?;
        let Value::Number(_) = slot else { return None };
        *slot = Value::Number(value);
        Some(changed)
    }

    /// The model at these values as the text form of a component, `id:name=value,name=value`: what differs from the
    /// defaults.
    #[must_use]
    pub fn component(&self) -> String {
        let values = self.to_string();
        let colon = if values.is_empty() { "" } else { ":" };
        format!("{}{colon}{values}", self.model)
    }

    /// The text form of [`Self::component`] with these values in place of its own. `None` as of [`Self::with`], and where
    /// nothing differs.
    #[must_use]
    pub fn replaced(&self, values: &[(&str, Value)]) -> Option<String> {
        let changed = self.with(values)?;
        (changed != *self).then(|| changed.component())
    }

    /// The number `name`. A name the model does not have is a mistake in the model's own code; it reads as 0.
    #[must_use]
    pub fn number(&self, name: &str) -> f64 {
        match self.get(name) {
            Some(Value::Number(x)) => x,
            other => self.misread(name, other, 0.0),
        }
    }

    /// The channels of `name`; black for a name the model does not have, as in [`Self::number`].
    #[must_use]
    pub fn rgb(&self, name: &str) -> [f64; 3] {
        match self.get(name) {
            Some(Value::Rgb(rgb)) => rgb,
            other => self.misread(name, other, [0.0; 3]),
        }
    }

    /// The word of `name`; empty for a name the model does not have, as in [`Self::number`].
    #[must_use]
    pub fn choice(&self, name: &str) -> &'static str {
        match self.get(name) {
            Some(Value::Choice(word)) => word,
            other => self.misread(name, other, ""),
        }
    }

    /// Whether `name` is true; false for a name the model does not have, as in [`Self::number`].
    #[must_use]
    pub fn flag(&self, name: &str) -> bool {
        match self.get(name) {
            Some(Value::Bool(flag)) => flag,
            other => self.misread(name, other, false),
        }
    }

    /// The value of `name`, if the model has such a parameter.
    #[must_use]
    pub fn get(&self, name: &str) -> Option<Value> {
        self.index_of(name)
            .and_then(|index| self.values.get(index).copied())
    }

    /// The spec of the parameter `name`.
    ///
    /// # Errors
    /// [`Error::UnknownId`] where the model has no such parameter.
    pub fn spec(&self, name: &str) -> Result<&'static ParamSpec> {
        let spec = self.index_of(name).and_then(|index| self.specs.get(index));
        spec.ok_or_else(|| self.unknown(name))
    }

    pub(super) fn index_of(&self, name: &str) -> Option<usize> {
        self.specs.iter().position(|spec| spec.name == name)
    }

    pub(super) fn unknown(&self, name: &str) -> Error {
        let known = self.specs.iter().map(|spec| spec.name);
        Error::unknown("parameter", name, known)
    }

    /// An [`Error::Parameter`] about `name`, for rules that span several parameters.
    #[must_use]
    pub fn error(&self, name: &str, allowed: impl Into<String>) -> Error {
        let value = self
            .get(name)
            .map(|value| value.to_string())
            .unwrap_or_default();
        Error::Parameter {
            model: self.model.to_owned(),
            name: name.to_owned(),
            value,
            allowed: allowed.into(),
        }
    }

    fn misread<T>(&self, name: &str, found: Option<Value>, fallback: T) -> T {
        debug_assert!(
            false,
            "{}: no parameter '{name}' of that kind (found {found:?})",
            self.model
        );
        fallback
    }
}

fn refused(model: &str, spec: &ParamSpec, text: &str) -> Error {
    Error::Parameter {
        model: model.to_owned(),
        name: spec.name.to_owned(),
        value: text.to_owned(),
        allowed: spec.allowed(),
    }
}

/// What two names begin with alike, less an underscore at its end.
fn stem([first, second]: [&'static str; 2]) -> &'static str {
    let same = first
        .bytes()
        .zip(second.bytes())
        .take_while(|(a, b)| a == b);
    let length = same.count();
    first
        .get(..length)
        .unwrap_or_default()
        .trim_end_matches('_')
}

impl fmt::Display for ParamSet {
    /// The parameters that differ from their default, as `name=value,name=value`; data as the name of its file, the bytes
    /// that stand in the text, or what was baked.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let changed = self.iter().filter(|(spec, value)| *value != spec.default);
        for (index, (spec, value)) in changed.enumerate() {
            let comma = if index == 0 { "" } else { "," };
            write!(f, "{comma}{}=", spec.name)?;
            match self.resource(spec.name).map(|data| (data, data.origin())) {
                None => write!(f, "{value}")?,
                Some((data, Origin::Inline)) => {
                    let bytes = data.decoded().map(|decoded| decoded.bytes());
                    f.write_str(&String::from_utf8_lossy(bytes.unwrap_or_default()))?;
                }
                Some((data, _)) => f.write_str(&data.name())?,
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    static SPECS: [ParamSpec; 4] = [
        ParamSpec::rgb("reflectance", [0.8; 3], "share reflected"),
        ParamSpec::number("alpha_x", 0.3, "width along s")
            .role(Role::WidthS)
            .hard(1e-4, 1.0),
        ParamSpec::number("alpha_y", 0.3, "width along t")
            .role(Role::WidthT)
            .hard(1e-4, 1.0),
        ParamSpec::choice("fresnel", &["one", "schlick"], "reflectance of a facet"),
    ];

    fn set() -> ParamSet {
        ParamSet::defaults("test_model", &SPECS)
    }

    #[test]
    fn text_sets_and_prints_values() {
        let mut params = set();
        params.set_text("reflectance", "0.1/0.2/0.3").unwrap();
        params.set_text("alpha", "0.5").unwrap();
        params.set_text("fresnel", "schlick").unwrap();
        assert_eq!(
            params.to_string(),
            "reflectance=0.1/0.2/0.3,alpha_x=0.5,alpha_y=0.5,fresnel=schlick"
        );
        params.set_text("reflectance", "0.25").unwrap();
        assert_eq!(params.rgb("reflectance"), [0.25; 3]);
        let one = params.replaced(&[("fresnel", Value::Choice("one"))]);
        assert_eq!(
            one.as_deref(),
            Some("test_model:reflectance=0.25,alpha_x=0.5,alpha_y=0.5")
        );
        assert_eq!(
            params.replaced(&[("fresnel", Value::Choice("schlick"))]),
            None
        );
        assert_eq!(params.replaced(&[("alpha_x", Value::Number(2.0))]), None);
        assert_eq!(set().to_string(), "");
    }

    #[test]
    fn refusals_name_what_is_allowed() {
        let mut params = set();
        let cases = [
            (
                "alpha_x",
                "2",
                "test_model: alpha_x = 2: allowed is a number from 0.0001 to 1",
            ),
            ("alpha_x", "nan", "from 0.0001 to 1"),
            ("alpha_x", "wide", "alpha_x = wide"),
            ("reflectance", "0.1/0.2", "one number or three as r/g/b"),
            ("reflectance", "0.1/0.2/1.2", "each from 0 to 1"),
            ("fresnel", "exact", "allowed is one of one, schlick"),
            (
                "alpa_x",
                "0.1",
                "unknown parameter 'alpa_x'; nearest: alpha_x",
            ),
        ];
        for (name, text, expected) in cases {
            let line = params.set_text(name, text).unwrap_err().to_string();
            assert!(line.contains(expected), "{line}");
        }
        assert_eq!(params, set(), "a refused value changes nothing");
    }
}
