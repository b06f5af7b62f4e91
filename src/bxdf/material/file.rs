//! Materials as TOML text: a name, notes, and lobes with their parameters.
//!
//! ```toml
//! name = "Glossy paint"
//! note = "A narrow highlight over an even colour"
//! source = "Chosen by eye"
//!
//! [[lobes]]
//! model = "phong"
//! weight = 0.05
//! exponent = 200
//!
//! [[lobes]]
//! model = "lambertian_reflection"
//! reflectance = [0.6, 0.1, 0.1]
//! ```

use std::ops::Range;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::assignments::Assignments;
use super::printed::DESCRIPTIONS;
pub use super::printed::print;
use super::{Component, Material, WEIGHT};
use crate::catalogue::Catalogue;
use crate::error::{Error, Result, shown};
use crate::resource::{Origin, Recipe, Resource, Stored};

/// The most bytes of a description: some pages. They are laid out whole, and one of many megabytes stops the screen.
pub const MAX_DESCRIPTION: usize = 1 << 14;

/// A table, its key or its value in the text.
type Entry<'a> = (
    &'a Spanned<std::borrow::Cow<'a, str>>,
    &'a Spanned<DeValue<'a>>,
);

/// A text being read: errors name its place and the line.
struct Reader<'a> {
    text: &'a str,
    place: &'a str,
}

impl Reader<'_> {
    fn error(&self, span: Range<usize>, problem: impl Into<String>) -> Error {
        let before = self.text.get(..span.start).unwrap_or_default();
        let line = before.matches('\n').count() + 1;
        Error::parse(format!("{}: line {line}", self.place), problem)
    }

    /// The string at `entry`.
    fn string(&self, (key, value): Entry<'_>) -> Result<String> {
        match value.get_ref() {
            DeValue::String(text) => Ok(text.to_string()),
            _ => Err(self.error(value.span(), format!("{} is not in quotes", key.get_ref()))),
        }
    }

    fn component(&self, lobe: &Spanned<DeValue<'_>>) -> Result<Component> {
        let DeValue::Table(table) = lobe.get_ref() else {
            return Err(self.error(lobe.span(), "lobes are tables: [[lobes]]"));
        };
        let Some((key, value)) = table.get_key_value("model") else {
            return Err(self.error(lobe.span(), "a lobe without model = \"...\""));
        };
        let model = Catalogue::current()
            .find(&self.string((key, value))?)
            .map_err(|error| self.error(value.span(), error.to_string()))?;
        // By name, one by one: no key and no value is read as more than one parameter.
        let mut assignments = Assignments::of(model);
        let mut weight = None;
        for (key, value) in table.iter().filter(|(key, _)| key.get_ref() != "model") {
            let name = key.get_ref();
            if let Some(spec) = assignments.data(name) {
                let stored = Stored {
                    decoders: spec.decoders,
                };
                let set = |resource: Resource| {
                    if let Origin::Baked(recipe) = resource.origin() {
                        of_recipe(recipe)?;
                    }
                    assignments.set_resource(name, resource)
                };
                let set = stored.value(value.get_ref()).and_then(set);
                set.map_err(|error| self.error(value.span(), error.to_string()))?;
                continue;
            }
            let word = word_of(value.get_ref()).ok_or_else(|| {
                let problem = format!("{} is no number, colour, word or truth value", shown(name));
                self.error(value.span(), problem)
            })?;
            if name == WEIGHT.name {
                weight = Some((key, word));
                continue;
            }
            assignments
                .set(name, &word)
                .map_err(|error| self.error(key.span(), error.to_string()))?;
        }
        let mut component = assignments
            .finish()
            .map_err(|error| self.error(value.span(), error.to_string()))?;
        if let Some((key, word)) = weight {
            set_weight(&mut component, &word)
                .map_err(|error| self.error(key.span(), error.to_string()))?;
        }
        Ok(component)
    }
}

/// Sets the weight of `component` from its text.
fn set_weight(component: &mut Component, word: &str) -> Result<()> {
    let weight = word.parse().unwrap_or(f64::NAN);
    component.set_weight(weight).map_err(|error| match error {
        // As it was given: it may be no number.
        Error::Parameter {
            model,
            name,
            allowed,
            ..
        } => Error::Parameter {
            model,
            name,
            value: word.to_owned(),
            allowed,
        },
        other => other,
    })
}

/// Reads a material from TOML `text`; `place` (the file) is named in errors, with the line.
///
/// # Errors
/// [`Error::Parse`] for a syntax error, an unknown key, model, parameter or choice, a value or weight out of range,
/// and what [`Material::new`] refuses.
pub fn parse(text: &str, place: &str) -> Result<Material> {
    let reader = Reader { text, place };
    let document = DeTable::parse(text).map_err(|error| {
        let span = error.span().unwrap_or(0..0);
        reader.error(span, error.message().replace('\n', " "))
    })?;
    let table = document.get_ref();
    let is_known = |key: &str| DESCRIPTIONS.contains(&key) || key == "lobes";
    if let Some((key, _)) = table.iter().find(|(key, _)| !is_known(key.get_ref())) {
        let problem = format!(
            "unknown key '{}'; known are name, note, source and lobes",
            shown(key.get_ref())
        );
        return Err(reader.error(key.span(), problem));
    }
    let describe = |key| {
        let Some(entry) = table.get_key_value(key) else {
            return Ok(String::new());
        };
        let text = reader.string(entry)?;
        if text.len() > MAX_DESCRIPTION {
            let length = text.len();
            let problem = format!("{key} is {length} bytes long; the limit is {MAX_DESCRIPTION}");
            return Err(reader.error(entry.1.span(), problem));
        }
        Ok(text)
    };
    let [name, note, source] = DESCRIPTIONS.map(describe);
    let (span, components) = match table.get("lobes") {
        None => (0..0, Vec::new()),
        Some(lobes) => match lobes.get_ref() {
            DeValue::Array(lobes_in_order) => {
                let read = lobes_in_order.iter().map(|lobe| reader.component(lobe));
                (lobes.span(), read.collect::<Result<_>>()?)
            }
            _ => return Err(reader.error(lobes.span(), "lobes are tables: [[lobes]]")),
        },
    };
    let material = Material::new(components).map_err(|error| match error {
        Error::Parse { problem, .. } => reader.error(span, problem),
        other => other,
    })?;
    Ok(Material {
        name: name?,
        note: note?,
        source: source?,
        ..material
    })
}

/// The material that a recipe names.
///
/// # Errors
/// What the readers of materials refuse, and a material that has data itself.
pub(super) fn of_recipe(recipe: &Recipe) -> Result<Material> {
    let text = recipe.text();
    let material = if text.contains("lobes") {
        parse(text, "baked")?
    } else {
        text.parse::<Material>()?
    };
    if material.has_data() {
        return Err(Error::parse("baked", "a material that has data itself"));
    }
    Ok(material)
}

/// A value as the command line has it: a number, `r/g/b`, a word.
fn word_of(value: &DeValue<'_>) -> Option<String> {
    match value {
        DeValue::String(word) => Some(word.to_string()),
        DeValue::Boolean(flag) => Some(flag.to_string()),
        DeValue::Array(channels) => {
            let numbers: Option<Vec<&str>> = channels
                .iter()
                .map(|channel| number_of(channel.get_ref()))
                .collect();
            Some(numbers?.join("/"))
        }
        number => number_of(number).map(str::to_owned),
    }
}

/// The text of a number in decimal digits.
fn number_of<'a>(value: &'a DeValue<'_>) -> Option<&'a str> {
    match value {
        DeValue::Integer(number) if number.radix() == 10 => Some(number.as_str()),
        DeValue::Float(number) => Some(number.as_str()),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_a_material_and_prints_as_itself() {
        let text = "name = \"Gold\"\n[[lobes]]\nmodel = \"rough_conductor\"\nalpha = 0.05\neta = [0.2, 0.4, 1]\n";
        let material = parse(text, "gold.toml").unwrap();
        assert_eq!(
            material.to_string(),
            "rough_conductor:eta=0.2/0.4/1,alpha_x=0.05,alpha_y=0.05"
        );
        assert_eq!(material.title(), "Gold");
        let text = "[[lobes]]\nmodel = \"phong\"\nweight = 0.25\n[[lobes]]\nmodel = \"oren_nayar\"\nreflectance = .5";
        let text = text.replace("= .5", "= 0.5");
        let two = parse(&text, "m").unwrap();
        assert_eq!(two.to_string(), "0.25 * phong + oren_nayar:reflectance=0.5");
        for material in [material, two] {
            assert_eq!(parse(&print(&material), "printed").unwrap(), material);
        }
    }

    #[test]
    fn mistakes_name_file_and_line() {
        let two =
            "[[lobes]]\nmodel = \"oren_nayar\"\nsigma = 9\n[[lobes]]\nmodel = \"oren_nayar\"\n";
        for (text, expected) in [
            ("name = \"x\"\nnote \"y\"", "m.toml: line 2: "),
            (
                "[[lobes]]\nmodel = \"gold\"\nalpha = 1",
                "m.toml: line 2: unknown model 'gold'",
            ),
            (
                &format!("{two}sigma = 91"),
                "m.toml: line 6: oren_nayar: sigma = 91: allowed is",
            ),
            (
                &format!("{two}sgma = 9"),
                "m.toml: line 6: unknown parameter 'sgma'; nearest: sigma",
            ),
            (
                &format!("{two}weight = -0.5"),
                "m.toml: line 6: oren_nayar: weight = -0.5: allowed is a number from 0 to 1000",
            ),
            (
                &format!("{two}weight = 4e38"),
                "m.toml: line 6: oren_nayar: weight = 4",
            ),
            (
                &format!("{two}weight = inf"),
                "weight = inf: allowed is a number from 0 to 1000",
            ),
            (
                &format!("{two}sigma = {{ a = 1 }}"),
                "m.toml: line 6: sigma is no number, colour, word or truth value",
            ),
            (
                "[[lobes]]\nmodel = \"rough_conductor\"\nfresnel = \"gold\"",
                "line 3: rough_conductor: fresnel = gold: allowed is one of",
            ),
            ("colour = 1\n", "m.toml: line 1: unknown key 'colour'"),
            ("name = \"none\"", "m.toml: line 1: 0 lobes"),
            ("lobes = 3", "line 1: lobes are tables"),
            ("[[lobes]]\nweight = 1", "line 1: a lobe without model"),
            (
                "name = 3\n[[lobes]]\nmodel = \"phong\"",
                "line 1: name is not in quotes",
            ),
            (&two.repeat(5), "line 1: 10 lobes; allowed are 1 to 8"),
            (
                &format!("{two}weight = \"much\""),
                "line 6: oren_nayar: weight = much: allowed is a number",
            ),
            (
                &format!("note = \"{}\"\n{two}", "long ".repeat(1 << 12)),
                "line 1: note is 20480 bytes long; the limit is 16384",
            ),
        ] {
            let line = parse(text, "m.toml").unwrap_err().to_string();
            assert!(line.contains(expected) && !line.contains('\n'), "{line}");
        }
    }

    #[test]
    fn keys_and_values_stand_for_one_parameter_each() {
        for (line, expected) in [
            (
                "exponent = \"32,specular=0.25\"",
                "line 3: phong: exponent = 32,specular=0.25: allowed is a number",
            ),
            (
                "\"exponent=32,specular\" = 0.25",
                "line 3: unknown parameter 'exponent=32,specular'",
            ),
            (
                "diffuse = [\"0.1/0.2\", \"0.3\"]",
                "line 3: diffuse is no number, colour",
            ),
            (
                "diffuse = [[0.1, 0.2], 0.3]",
                "line 3: diffuse is no number",
            ),
            ("diffuse = [0.1, 0.2]", "line 3: phong: diffuse = 0.1/0.2"),
        ] {
            let text = format!("[[lobes]]\nmodel = \"phong\"\n{line}\n");
            let error = parse(&text, "m").unwrap_err().to_string();
            assert!(error.contains(expected), "{error}");
        }
        let text = "[[lobes]]\nmodel = \"phong:exponent=32\"\n";
        let error = parse(text, "m").unwrap_err().to_string();
        assert!(
            error.contains("line 2: unknown model 'phong:exponent=32'"),
            "{error}"
        );
        let text = "[[lobes]]\nmodel = \"rough_conductor\"\nalpha = 0.1\nalpha_x = 0.2\n";
        let error = parse(text, "m").unwrap_err().to_string();
        assert!(
            error.contains("line 4: rough_conductor: alpha and alpha_x both set alpha_x"),
            "{error}"
        );
    }

    #[test]
    fn what_may_not_stand_together_is_refused_at_the_model() {
        let text = "[[lobes]]\nmodel = \"rough_conductor\"\nk = 0\neta = 0\n";
        let error = parse(text, "m").unwrap_err().to_string();
        assert!(error.contains("line 2: rough_conductor: "), "{error}");
        assert!(error.contains("may not both be 0"), "{error}");
        assert!(parse(&text.replace("eta = 0", "eta = 1.5"), "m").is_ok());
    }
}
