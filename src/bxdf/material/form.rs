//! How a material stands in a session.

use serde::{Deserialize, Deserializer, Serialize, Serializer, de};

use super::{Material, file};
use crate::error::{Error, Result};

/// How a material stands in a session: as text where that says all, else as the table of its file.
#[derive(Serialize, Deserialize)]
#[serde(untagged)]
enum Form {
    Text(String),
    Table(toml::Table),
}

impl From<&Material> for Form {
    fn from(material: &Material) -> Self {
        let is_bare = [&material.name, &material.note, &material.source]
            .iter()
            .all(|text| text.is_empty());
        match material.only() {
            Some(only) if is_bare => Self::Text(only.to_string()),
            _ => Self::Table(file::table(material)),
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
