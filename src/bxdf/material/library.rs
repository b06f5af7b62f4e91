//! The library: the materials of `materials`, by name, embedded in the program.

use std::sync::LazyLock;

use super::embedded::{files, id_of};
use super::{Material, file};
use crate::catalogue::Catalogue;
use crate::error::{Error, Result, shown};

static ALL: LazyLock<Vec<Named>> = LazyLock::new(|| {
    // A test reads every file: none is left out here.
    let read = |file| named(file).ok();
    let mut all: Vec<Named> = files().filter_map(read).collect();
    all.sort_by(|a, b| {
        let key = |named: &Named| {
            (
                named.material.category(),
                named.material.name.to_lowercase(),
            )
        };
        key(a).cmp(&key(b))
    });
    all
});

/// A material of the library.
#[derive(Debug)]
pub struct Named {
    /// The id: the name of its file without `.toml`, a command-line word.
    pub id: &'static str,
    /// The material; it has a name.
    pub material: Material,
}

/// Every material of the library, by category, then by name.
///
/// ```
/// for named in bxdf::material::library::all() {
///     println!("{:24} {}", named.id, named.material.note);
/// }
/// ```
#[must_use]
pub fn all() -> &'static [Named] {
    &ALL
}

/// The material of the library with this id.
///
/// # Errors
/// [`Error::UnknownId`], with the nearest ids.
pub fn find(id: &str) -> Result<&'static Named> {
    all()
        .iter()
        .find(|named| named.id == id)
        .ok_or_else(|| Error::unknown("material", id, all().iter().map(|named| named.id)))
}

/// Reads a material that stands in no file: a model as `id` or `id:name=value,name=value`, or the id of a material of the
/// library.
///
/// # Errors
/// [`Error::UnknownId`], with the nearest ids of both; [`Error::Parameter`] and [`Error::Parse`] for the parameters.
pub fn read(text: &str) -> Result<Material> {
    let (id, parameters) = text
        .split_once(':')
        .map_or((text.trim(), None), |(id, rest)| (id.trim(), Some(rest)));
    if Catalogue::current().find(id).is_ok() {
        return text.parse();
    }
    match (find(id), parameters) {
        (Ok(named), None) => Ok(named.material.clone()),
        (Ok(_), Some(_)) => Err(Error::parse(
            format!("material '{}'", shown(text)),
            "a named material takes no parameters; write a .toml file, or name a model",
        )),
        (Err(_), _) => Err(unknown(id)),
    }
}

/// The error for a text of which [`is_known`] is false: it names the nearest ids of both.
#[must_use]
pub fn unknown(text: &str) -> Error {
    let id = text.split(':').next().unwrap_or_default().trim();
    let models = Catalogue::current().models().iter().map(|model| model.id);
    let named = all().iter().map(|named| named.id);
    Error::unknown("material", id, models.chain(named))
}

/// Whether `text` begins with the id of a model or of a material of the library, as [`read`] takes it.
#[must_use]
pub fn is_known(text: &str) -> bool {
    let id = text.split(':').next().unwrap_or_default().trim();
    Catalogue::current().find(id).is_ok() || all().iter().any(|named| named.id == id)
}

/// The material of the library that `material` is, or was before its components were changed: the one of its name.
#[must_use]
pub fn origin(material: &Material) -> Option<&'static Named> {
    all()
        .iter()
        .find(|named| named.material.name == material.name)
}

fn named(file: &'static include_dir::File<'static>) -> Result<Named> {
    let place = file.path().display().to_string();
    let (Some(id), Some(text)) = (id_of(file), file.contents_utf8()) else {
        return Err(Error::parse(place, "no text"));
    };
    let material = file::parse(text, &place)?;
    Ok(Named { id, material })
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;
    use crate::models::MODELS;

    #[test]
    fn every_file_is_a_material_that_says_what_it_is() {
        for file in files() {
            let named = named(file).unwrap();
            let Material {
                name, note, source, ..
            } = &named.material;
            for text in [name, note, source] {
                assert!(!text.trim().is_empty(), "{}: {named:?}", named.id);
            }
            assert!(MODELS.iter().all(|model| model.id != named.id));
            assert_eq!(find(named.id).unwrap().material, named.material);
        }
        let names: BTreeSet<&str> = all().iter().map(|n| n.material.name.as_str()).collect();
        assert_eq!(names.len(), all().len(), "a name stands twice");
        assert_eq!(all().len(), files().count());
    }

    #[test]
    fn the_library_is_sorted_and_knows_its_own() {
        let categories: Vec<_> = all().iter().map(|n| n.material.category()).collect();
        assert!(categories.is_sorted());
        let gold = find("gold").unwrap();
        let edited = gold
            .material
            .with_components(vec!["phong".parse().unwrap()])
            .unwrap();
        assert_eq!(origin(&edited).unwrap().id, "gold");
        assert!(origin(&"phong".parse().unwrap()).is_none());
        let line = find("golf").unwrap_err().to_string();
        assert!(
            line.starts_with("unknown material 'golf'; nearest: gold"),
            "{line}"
        );
    }

    #[test]
    fn materials_go_by_the_ids_of_both_lists() {
        assert_eq!(read("gold").unwrap().name, "Gold");
        assert_eq!(read("phong").unwrap().name, "");
        for (text, expected) in [
            ("golf", "unknown material 'golf'; nearest: gold"),
            ("oren", "unknown material 'oren'; nearest: oren_nayar"),
            (
                "gold:alpha=0.2",
                "material 'gold:alpha=0.2': a named material takes no parameters",
            ),
        ] {
            let line = read(text).unwrap_err().to_string();
            assert!(line.starts_with(expected), "{line}");
        }
    }
}
