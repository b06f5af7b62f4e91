//! How a material stands in a session.

use serde::{Deserialize, Deserializer, Serialize, Serializer, de};

use super::{Material, file, printed};
use crate::error::{Error, Result};

impl Material {
    /// The material as the text of a component, where that says all.
    pub(crate) fn as_line(&self) -> Option<String> {
        let said = [&self.name, &self.note, &self.source];
        let is_bare = said.iter().all(|text| text.is_empty()) && !self.has_data();
        self.only().filter(|_| is_bare).map(ToString::to_string)
    }

    /// The material as text: `id:name=value,name=value` where that says all, else the text of its file.
    #[must_use]
    pub fn to_text(&self) -> String {
        self.as_line().unwrap_or_else(|| printed::print(self))
    }
}

/// How a material stands in a session: as text where that says all, else as the table of its file.
#[derive(Serialize, Deserialize)]
#[serde(untagged)]
enum Form {
    Text(String),
    Table(toml::Table),
}

impl From<&Material> for Form {
    fn from(material: &Material) -> Self {
        match material.as_line() {
            Some(line) => Self::Text(line),
            None => Self::Table(printed::table(material)),
        }
    }
}

impl TryFrom<Form> for Material {
    type Error = Error;

    fn try_from(form: Form) -> Result<Self> {
        match form {
            Form::Text(text) => text.parse(),
            Form::Table(table) => file::parse(&table.to_string(), "material"),
        }
    }
}

impl Serialize for Material {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        Form::from(self).serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for Material {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        Self::try_from(Form::deserialize(deserializer)?).map_err(de::Error::custom)
    }
}
