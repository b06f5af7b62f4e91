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

use super::{Component, Material, WEIGHT};
use crate::bxdf::param;
use crate::bxdf::param::Kind;
use crate::error::{Error, Result};

/// The keys that describe a material and do not change it, in the order in which they are printed.
const DESCRIPTIONS: [&str; 3] = ["name", "note", "source"];

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
        let mut component: Component = self
            .string((key, value))?
            .parse()
            .map_err(|error: Error| self.error(value.span(), error.to_string()))?;
        let mut assignments = vec![component.to_string()];
        for (key, value) in table.iter().filter(|(key, _)| key.get_ref() != "model") {
            let name = key.get_ref();
            let word = word_of(value.get_ref()).ok_or_else(|| {
                let problem = format!("{name} is no number, colour, word or truth value");
                self.error(value.span(), problem)
            })?;
            let at = |error: Error| self.error(key.span(), error.to_string());
            if name == WEIGHT.name {
                component
                    .set_weight(word.parse().unwrap_or(f64::NAN))
                    .map_err(at)?;
                continue;
            }
            // Each alone first, so that the error names its line.
            let alone = format!("{}:{name}={word}", component.model().id);
            alone.parse::<Component>().map_err(at)?;
            assignments.push(format!("{name}={word}"));
        }
        let weight = component.weight();
        let text = assignments.join(",").replacen(',', ":", 1);
        let mut all: Component = text
            .parse()
            .map_err(|error: Error| self.error(value.span(), error.to_string()))?;
        all.set_weight(weight)?;
        Ok(all)
    }
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
            key.get_ref()
        );
        return Err(reader.error(key.span(), problem));
    }
    let describe = |key| {
        table
            .get_key_value(key)
            .map_or_else(|| Ok(String::new()), |entry| reader.string(entry))
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

/// A value as the command line has it: a number, `r/g/b`, a word.
fn word_of(value: &DeValue<'_>) -> Option<String> {
    match value {
        DeValue::String(word) => Some(word.to_string()),
        DeValue::Integer(number) if number.radix() == 10 => Some(number.as_str().to_owned()),
        DeValue::Float(number) => Some(number.as_str().to_owned()),
        DeValue::Boolean(flag) => Some(flag.to_string()),
        DeValue::Array(channels) => {
            let words: Option<Vec<String>> = channels
                .iter()
                .map(|channel| word_of(channel.get_ref()))
                .collect();
            Some(words?.join("/"))
        }
        DeValue::Integer(_) | DeValue::Datetime(_) | DeValue::Table(_) => None,
    }
}

/// `material` as TOML text, which [`parse`] reads back as the same.
#[must_use]
pub fn print(material: &Material) -> String {
    table(material).to_string()
}

/// `material` as a TOML table; parameters that have their default are left out.
pub(super) fn table(material: &Material) -> toml::Table {
    let mut table = toml::Table::new();
    let descriptions = [&material.name, &material.note, &material.source];
    for (key, text) in DESCRIPTIONS.into_iter().zip(descriptions) {
        if !text.is_empty() {
            table.insert(key.to_owned(), text.clone().into());
        }
    }
    let lobes = material.components().iter().map(lobe_table);
    table.insert("lobes".to_owned(), toml::Value::Array(lobes.collect()));
    table
}

fn lobe_table(component: &Component) -> toml::Value {
    let mut table = toml::Table::new();
    table.insert("model".to_owned(), component.model().id.into());
    if component.weight() != 1.0 {
        table.insert(WEIGHT.name.to_owned(), component.weight().into());
    }
    for (spec, value) in component.params().iter() {
        if value != spec.default {
            table.insert(spec.name.to_owned(), toml_value(spec.kind, value));
        }
    }
    if let Some(data) = component.params().table() {
        table.insert(param::DATA.to_owned(), data.to_string().into());
    }
    table.into()
}

fn toml_value(kind: Kind, value: param::Value) -> toml::Value {
    match value {
        param::Value::Number(number) => number.into(),
        param::Value::Rgb([r, g, b]) if kind == Kind::Rgb && r == g && g == b => r.into(),
        param::Value::Rgb(rgb) => rgb.to_vec().into(),
        param::Value::Choice(word) => word.into(),
        param::Value::Bool(flag) => flag.into(),
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
        ] {
            let line = parse(text, "m.toml").unwrap_err().to_string();
            assert!(line.contains(expected) && !line.contains('\n'), "{line}");
        }
    }
}
