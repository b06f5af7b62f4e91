//! `models`: the catalogue.

use std::fmt::Write as _;

use serde::Serialize;
use serde_json::{Value as Json, json};

use super::output;
use bxdf::Catalogue;
use bxdf::error::Result;
use bxdf::material::library::{self, Named};
use bxdf::param::{Kind, ParamSpec, Value};
use bxdf::{Category, Lobe, ModelSpec};

#[derive(clap::Args)]
pub(super) struct Arguments {
    /// Print JSON
    #[arg(long)]
    json: bool,
}

pub(super) fn run(arguments: &Arguments) -> Result<()> {
    if arguments.json {
        let models = Catalogue::current().models().iter().copied();
        let models: Vec<Json> = models.map(model_json).collect();
        let materials: Vec<Json> = library::all().iter().map(material_json).collect();
        output::print_json(&json!({ "models": models, "materials": materials }))
    } else {
        output::print(&(listing() + &materials_listing()))
    }
}

/// A parameter as the contract lists it; what does not apply to its kind is null, or empty.
#[derive(Serialize)]
struct Parameter {
    name: &'static str,
    kind: &'static str,
    default: Json,
    min: Option<f64>,
    max: Option<f64>,
    soft_min: Option<f64>,
    soft_max: Option<f64>,
    unit: &'static str,
    scale: Option<&'static str>,
    choices: &'static [&'static str],
}

impl From<&ParamSpec> for Parameter {
    fn from(spec: &ParamSpec) -> Self {
        let is_numeric = is_numeric(spec);
        let numeric = |x: f64| is_numeric.then_some(x);
        Self {
            name: spec.name,
            kind: spec.kind.name(),
            default: match spec.default {
                Value::Number(x) => x.into(),
                Value::Rgb(rgb) => json!(rgb),
                Value::Choice(word) => word.into(),
                Value::Bool(is_true) => is_true.into(),
                Value::Data(_) => Json::Null,
            },
            min: numeric(spec.hard[0]),
            max: numeric(spec.hard[1]),
            soft_min: numeric(spec.soft[0]),
            soft_max: numeric(spec.soft[1]),
            unit: spec.unit,
            scale: is_numeric.then_some(spec.scale.name()),
            choices: spec.choices,
        }
    }
}

fn is_numeric(spec: &ParamSpec) -> bool {
    matches!(spec.kind, Kind::Number | Kind::Rgb)
}

fn model_json(model: &ModelSpec) -> Json {
    let lobe = |lobe: &Lobe| json!({ "category": lobe.category.id(), "side": lobe.side.id() });
    json!({
        "id": model.id,
        "title": model.title,
        "source": model.source,
        "lobes": model.lobes.iter().map(lobe).collect::<Vec<_>>(),
        "parameters": model.parameters.iter().map(Parameter::from).collect::<Vec<_>>(),
        "properties": properties_json(model),
    })
}

fn material_json(named: &Named) -> Json {
    let material = &named.material;
    json!({
        "id": named.id,
        "name": material.name,
        "category": material.category().id(),
        "note": material.note,
        "source": material.source,
        "text": material.to_string(),
    })
}

/// What holds for the model at its default parameters, and the laws it declares to break.
fn properties_json(model: &ModelSpec) -> Json {
    let defaults = model.defaults();
    let properties = &model.properties;
    let declarations: Vec<Json> = properties
        .declarations
        .iter()
        .map(|declaration| {
            json!({
                "law": declaration.law.id(),
                "parameters": declaration.parameters,
                "theta": declaration.theta_deg,
                "note": declaration.note,
            })
        })
        .collect();
    json!({
        "isotropic": (properties.is_isotropic)(&defaults),
        "relative_index": (properties.relative_index)(&defaults),
        "delta_only": model.is_delta_only(),
        "declarations": declarations,
    })
}

/// The catalogue for people, grouped by category.
fn listing() -> String {
    let mut text = String::new();
    for category in Category::ALL {
        let mut models = Catalogue::current()
            .models()
            .iter()
            .filter(|model| model.category() == category)
            .peekable();
        if models.peek().is_none() {
            continue;
        }
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{}", category.title());
        for model in models {
            let _ = writeln!(text, "  {} - {}", model.id, model.title);
            let _ = writeln!(text, "    {}; {}", lobes(model), model.source);
            for (name, values, meaning) in parameters(model) {
                let _ = writeln!(text, "      {name}  {values}  {meaning}");
            }
        }
        text.push('\n');
    }
    text.push_str(
        "A material is written as id, as id:name=value,name=value, or by the id of a named one\n",
    );
    text
}

fn lobes(model: &ModelSpec) -> String {
    let lobe = |lobe: &Lobe| format!("{} {}", lobe.category.title(), lobe.side.id());
    model.lobes.iter().map(lobe).collect::<Vec<_>>().join(" + ")
}

/// The name, the values and the meaning of each parameter, the first two padded to the widest of the model.
fn parameters(model: &ModelSpec) -> Vec<(String, String, &'static str)> {
    let values = |spec: &ParamSpec| {
        let allowed = if is_numeric(spec) {
            let space = if spec.unit.is_empty() { "" } else { " " };
            format!("{} to {}{space}{}", spec.hard[0], spec.hard[1], spec.unit)
        } else if spec.choices.is_empty() {
            "true or false".to_owned()
        } else {
            spec.choices.join("|")
        };
        format!("{} ({allowed})", spec.default)
    };
    let texts: Vec<String> = model.parameters.iter().map(values).collect();
    let name_width = widest(model.parameters.iter().map(|spec| spec.name));
    let text_width = widest(texts.iter().map(String::as_str));
    model
        .parameters
        .iter()
        .zip(&texts)
        .map(|(spec, text)| {
            (
                format!("{:name_width$}", spec.name),
                format!("{text:text_width$}"),
                spec.meaning,
            )
        })
        .collect()
}

/// The named materials for people.
fn materials_listing() -> String {
    let all = library::all();
    let width = widest(all.iter().map(|named| named.id));
    all.iter()
        .fold("\nNamed materials\n".to_owned(), |text, named| {
            text + &format!("  {:width$}  {}\n", named.id, named.material.name)
        })
}

fn widest<'a>(texts: impl Iterator<Item = &'a str>) -> usize {
    texts.map(|text| text.chars().count()).max().unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_listing_names_every_model_and_category_once() {
        let text = listing();
        for model in Catalogue::current().models() {
            assert_eq!(text.matches(&format!("  {} - ", model.id)).count(), 1);
        }
        for category in Category::ALL {
            let heading = category.title();
            assert_eq!(text.lines().filter(|line| *line == heading).count(), 1);
        }
        let text = materials_listing();
        for named in library::all() {
            assert_eq!(text.matches(&format!("  {} ", named.id)).count(), 1);
        }
    }
}
