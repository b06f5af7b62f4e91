//! What a lesson changes in a session: the keys of a session's file, and shorter ones for what lessons change most.

use serde::Deserialize;
use toml::{Table, Value};

use crate::session::{Direction, MaterialEntry, Materials, Place, READY_LAYOUTS, Session, Views};
use crate::views::{Options, find};
use bxdf::material::{file, library};
use bxdf::{Component, Material};

/// Where the light and the viewer are about n, in degrees, where only their angle from it is given: on the left and on the
/// right.
const LIGHT_PHI_DEG: f64 = 180.0;
const VIEWER_PHI_DEG: f64 = 0.0;

/// Changes of a session.
///
/// | key | what it does |
/// |---|---|
/// | `materials` | a list in place of all: ids of named materials, models as `id:name=value`, or tables of files of materials; the first one is selected |
/// | `select` | the number of the material that is selected, from 1 on |
/// | `set` | a table: parameters of the selected material by their names |
/// | `light`, `viewer` | the angle from n in degrees, or both angles `[theta, phi]` |
/// | `arrangement` | the name of a ready arrangement |
/// | `views` | a list of ids of kinds of views, which stand side by side |
/// | `options` | a table for each kind of view: options of all such views |
/// | any other | as in the file of a session |
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(default)]
pub struct Patch {
    materials: Option<Vec<Listed>>,
    select: Option<usize>,
    set: Table,
    light: Option<Angles>,
    viewer: Option<Angles>,
    arrangement: Option<String>,
    views: Option<Vec<String>>,
    options: Table,
    #[serde(flatten)]
    session: Table,
}

/// A material of a list.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(
    untagged,
    expecting = "expected a material: a text, { name, material }, or the table of its file"
)]
enum Listed {
    Text(String),
    Named { name: String, material: String },
    Table(Table),
}

/// The angles of a direction, in degrees.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(
    untagged,
    expecting = "expected an angle in degrees, or both as [theta, phi]"
)]
enum Angles {
    Theta(f64),
    Both([f64; 2]),
}

impl Angles {
    fn direction(self, phi_deg: f64) -> Direction {
        let [theta_deg, phi_deg] = match self {
            Self::Theta(theta_deg) => [theta_deg, phi_deg],
            Self::Both(both) => both,
        };
        Direction { theta_deg, phi_deg }
    }
}

impl Patch {
    /// A patch that sets one key to a number: what the state is with an answer put in.
    ///
    /// # Errors
    /// Where the key is none, or takes no number.
    pub fn of_number(key: &str, number: f64) -> Result<Self, String> {
        let mut table = Table::new();
        match key.strip_prefix("set.") {
            Some(parameter) => {
                let mut set = Table::new();
                set.insert(parameter.to_owned(), Value::Float(number));
                table.insert("set".to_owned(), Value::Table(set));
            }
            None => {
                table.insert(key.to_owned(), Value::Float(number));
            }
        }
        table
            .try_into()
            .map_err(|error: toml::de::Error| error.message().to_owned())
    }

    /// Changes the session so.
    ///
    /// # Errors
    /// A sentence: what is unknown or not allowed, and what is. The session may be changed in part.
    pub fn apply(&self, session: &mut Session) -> Result<(), String> {
        if let Some(listed) = &self.materials {
            let materials: Result<Vec<Material>, String> = listed.iter().map(material).collect();
            session.materials = Materials::new(materials?).map_err(said)?;
        }
        if let Some(number) = self.select {
            let entries = session.materials.iter();
            let ids: Vec<_> = entries.map(MaterialEntry::id).collect();
            let chosen = number.checked_sub(1).and_then(|index| ids.get(index));
            let none = || format!("select = {number}: allowed is 1 to {}", ids.len());
            session.materials.select(*chosen.ok_or_else(none)?);
        }
        if !self.set.is_empty() {
            let entry = session.materials.selected_mut();
            entry.material = with_parameters(&entry.material, &self.set)?;
        }
        if let Some(name) = &self.arrangement {
            session.views = arrangement(name)?;
        }
        if let Some(ids) = &self.views {
            session.views = side_by_side(ids)?;
        }
        if !self.session.is_empty() {
            *session = merged(session, &self.session)?;
        }
        for (angles, phi_deg, name) in [
            (self.light, LIGHT_PHI_DEG, "light"),
            (self.viewer, VIEWER_PHI_DEG, "viewer"),
        ] {
            if let Some(angles) = angles {
                let direction = angles.direction(phi_deg);
                put(session, name, direction);
            }
        }
        for (id, options) in &self.options {
            set_options(&mut session.views, id, options)?;
        }
        session
            .check_numbers()
            .map_err(|refused| refused.to_string())
    }
}

/// An error as the sentence that it says.
#[expect(
    clippy::needless_pass_by_value,
    reason = "what is mapped over is handed over"
)]
fn said(error: bxdf::Error) -> String {
    error.to_string()
}

fn material(listed: &Listed) -> Result<Material, String> {
    match listed {
        Listed::Text(text) => library::read(text).map_err(said),
        Listed::Named { name, material } => {
            let mut material = library::read(material).map_err(said)?;
            material.name.clone_from(name);
            Ok(material)
        }
        Listed::Table(table) => file::parse(&table.to_string(), "a material").map_err(said),
    }
}

/// The material with these parameters, each in every component that has it.
fn with_parameters(material: &Material, set: &Table) -> Result<Material, String> {
    let mut components: Vec<Component> = material.components().to_vec();
    for (name, value) in set {
        let text = match value {
            Value::String(text) => text.clone(),
            Value::Array(numbers) => {
                let texts: Vec<String> = numbers.iter().map(ToString::to_string).collect();
                texts.join("/")
            }
            other => other.to_string(),
        };
        let mut last = None;
        let mut is_set = false;
        for component in &mut components {
            match component.set_text(name, &text) {
                Ok(()) => is_set = true,
                Err(error) => last = Some(error),
            }
        }
        if let (false, Some(error)) = (is_set, last) {
            return Err(said(error));
        }
    }
    material.with_components(components).map_err(said)
}

fn arrangement(name: &str) -> Result<Views, String> {
    let is_it = |ready: &&crate::session::ReadyLayout| ready.name.eq_ignore_ascii_case(name);
    let ready = READY_LAYOUTS.iter().find(is_it);
    let names = READY_LAYOUTS.iter().map(|ready| ready.name);
    let ready = ready.ok_or_else(|| said(bxdf::Error::unknown("arrangement", name, names)))?;
    Ok(Views::ready(ready))
}

fn side_by_side(ids: &[String]) -> Result<Views, String> {
    let kinds: Result<Vec<_>, _> = ids.iter().map(|id| find(id).map_err(said)).collect();
    let places: Vec<_> = kinds?
        .into_iter()
        .map(|kind| Place::View(Options::of(kind)))
        .collect();
    match <[_; 1]>::try_from(places) {
        Ok([one]) => Ok(one.into()),
        Err(places) if places.is_empty() => Err("views = []: at least one is needed".to_owned()),
        Err(places) => Ok(Place::row(places).into()),
    }
}

/// The session with these keys of its file.
fn merged(session: &Session, keys: &Table) -> Result<Session, String> {
    // Materials may hold data: they need not go through text.
    let bare = Session {
        materials: Session::default().materials,
        ..session.clone()
    };
    let text = bare.to_toml().map_err(said)?;
    let mut table: Table = text.parse().map_err(|error: toml::de::Error| {
        format!("the session as it is cannot be read: {}", error.message())
    })?;
    merge(&mut table, keys);
    let read = Session::read_toml(&table.to_string(), "a state").map_err(said)?;
    if let Some(line) = read.left_out.into_iter().next() {
        return Err(line);
    }
    Ok(Session {
        materials: session.materials.clone(),
        ..read.session
    })
}

/// Puts the values of `keys` in place of those of `table`; tables are merged, but for a layout, which is one thing.
fn merge(table: &mut Table, keys: &Table) {
    for (key, value) in keys {
        match (table.get_mut(key), value) {
            (Some(Value::Table(inner)), Value::Table(values)) if key != "layout" => {
                merge(inner, values);
            }
            _ => {
                table.insert(key.clone(), value.clone());
            }
        }
    }
}

/// Puts the light or the viewer.
fn put(session: &mut Session, name: &str, direction: Direction) {
    let Direction { theta_deg, phi_deg } = direction;
    if session.held_name() == name {
        (session.theta_deg, session.phi_deg) = (theta_deg, phi_deg);
    } else {
        session.other = Some(direction);
    }
}

/// Sets options of every view of a kind.
fn set_options(views: &mut Views, id: &str, options: &Value) -> Result<(), String> {
    let kind = find(id).map_err(said)?;
    let Value::Table(options) = options else {
        return Err(format!("options.{id}: expected a table"));
    };
    let mut is_there = false;
    for view in views.ids() {
        let Some(own) = views.get_mut(view).filter(|own| own.kind().id == kind.id) else {
            continue;
        };
        let mut table = Table::try_from(&*own).map_err(|error| error.to_string())?;
        merge(&mut table, options);
        let set: Result<Options, toml::de::Error> = table.try_into();
        *own = set.map_err(|error| format!("options.{id}: {}", error.message()))?;
        is_there = true;
    }
    if is_there {
        Ok(())
    } else {
        Err(format!("options.{id}: no such view is open"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::views::{integral, polar};

    fn patch(text: &str) -> Result<Patch, String> {
        let table: Table = text.parse().unwrap();
        table
            .try_into()
            .map_err(|error: toml::de::Error| error.to_string())
    }

    fn applied(text: &str) -> Result<Session, String> {
        let mut session = Session::default();
        patch(text)?.apply(&mut session)?;
        Ok(session)
    }

    #[test]
    fn a_session_is_changed_so() {
        let text = "
            materials = [\"chalk\", \"phong:exponent=12\", { name = \"Mine\", material = \"chalk\" }]
            select = 2
            set = { exponent = 30 }
            light = 35
            viewer = [20, 90]
            rotation_deg = 15.0
            views = [\"integral\", \"polar\"]
            options.integral = { integrand = \"cosine\" }
            options.polar.scale.is_each_to_peak = true
            camera = { distance = 4.0 }";
        let session = applied(text).unwrap();
        let titles: Vec<String> = session.materials.iter().map(MaterialEntry::title).collect();
        assert_eq!((titles.len(), titles[2].as_str()), (3, "Mine"));
        let component = &session.material().components()[0];
        assert_eq!(component.params().number("exponent"), 30.0);
        assert_eq!((session.theta_deg, session.phi_deg), (35.0, 180.0));
        let other = session.other.unwrap();
        assert_eq!((other.theta_deg, other.phi_deg), (20.0, 90.0));
        assert_eq!(session.rotation_deg, 15.0);
        let integrand = session.views.options::<integral::Options>().integrand;
        assert_eq!(integrand.id(), "cos");
        assert!(
            session
                .views
                .options::<polar::Options>()
                .scale
                .is_each_to_peak
        );
        // What is not named stays.
        assert_eq!(session.camera.distance(), 4.0);
        assert_eq!(session.camera.yaw(), Session::default().camera.yaw());
        let compare = applied("arrangement = \"compare\"").unwrap();
        assert_eq!(compare.views.ids().len(), 3);
    }

    #[test]
    fn an_answer_is_put_where_a_number_stands() {
        let mut session = Session::default();
        Patch::of_number("light", 12.0)
            .unwrap()
            .apply(&mut session)
            .unwrap();
        Patch::of_number("set.alpha", 0.4)
            .unwrap()
            .apply(&mut session)
            .unwrap();
        assert_eq!(session.theta_deg, 12.0);
        assert_eq!(
            session.material().components()[0]
                .params()
                .number("alpha_x"),
            0.4
        );
    }

    #[test]
    fn what_is_unknown_or_broken_is_said() {
        for (text, expected) in [
            (
                "materials = [\"gold_dust\"]",
                "unknown material 'gold_dust'",
            ),
            ("materials = []", "the number of materials"),
            ("select = 2", "select = 2: allowed is 1 to 1"),
            ("set = { flavour = 1 }", "flavour"),
            ("set = { alpha = 7 }", "alpha"),
            ("light = 200", "200: allowed is 0 to 180 degrees"),
            (
                "arrangement = \"loook\"",
                "unknown arrangement 'loook'; nearest: Look",
            ),
            ("views = [\"pola\"]", "unknown view 'pola'; nearest: polar"),
            ("views = []", "at least one"),
            ("flavour = 1", "unknown field `flavour`"),
            ("options.pola = {}", "unknown view 'pola'"),
            (
                "options.polar = { flavour = 1 }",
                "options.polar: unknown field `flavour`",
            ),
            (
                "options.integral = {}",
                "options.integral: no such view is open",
            ),
            ("layout.view = \"pola\"", "unknown view 'pola'"),
        ] {
            let line = applied(text).unwrap_err();
            assert!(line.contains(expected), "{text}: {line}");
        }
    }
}
