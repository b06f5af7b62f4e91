//! What an edit has changed, in words.

use crate::parameters::{changed, label};
use crate::session::{MaterialEntry, READY_LAYOUTS, Session, ViewId};
use bxdf::Component;
use bxdf::param::{ParamSpec, Role};

/// What an edit is about. Those of the arrangement and of the camera are named apart from those of what is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Area {
    /// The materials, the directions, and how things are shown.
    Shown,
    /// Which views there are, and where.
    Layout,
    /// Where the 3D views are looked at from.
    Camera,
}

/// What an edit has changed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Edit {
    /// What it is about.
    pub area: Area,
    /// In a few words: "roughness of Copper".
    pub what: String,
}

impl Edit {
    fn of(area: Area, what: impl Into<String>) -> Self {
        let what = what.into();
        Self { area, what }
    }

    /// What leads from one state to another that is not the same.
    #[must_use]
    pub fn between(before: &Session, after: &Session) -> Self {
        let changes = [
            materials(before, after),
            directions(before, after),
            shown(before, after),
            layout(before, after),
            camera(before, after),
        ];
        let mut changes: Vec<Self> = changes.into_iter().flatten().collect();
        // A camera that moves along with something else is not what was edited.
        if changes.len() > 1 {
            changes.retain(|change| change.area != Area::Camera);
        }
        let several = Self {
            area: Area::Shown,
            what: "several changes at once".to_owned(),
        };
        match changes.len() {
            0 => Self {
                what: "details".to_owned(),
                ..several
            },
            1 | 2 => changes.swap_remove(0),
            _ => several,
        }
    }

    /// What a command does to it that is called so: "Undo layout: close Slice", "Undo: roughness of Copper".
    #[must_use]
    pub fn title(&self, command: &str) -> String {
        let area = match self.area {
            Area::Shown => "",
            Area::Layout => " layout",
            Area::Camera => " camera",
        };
        format!("{command}{area}: {}", self.what)
    }
}

fn camera(before: &Session, after: &Session) -> Option<Edit> {
    let [a, b] = [&before.camera, &after.camera];
    if a == b {
        return None;
    }
    let is_turned = a.yaw() != b.yaw() || a.pitch() != b.pitch();
    let parts = [
        (is_turned, "orbit"),
        (a.distance() != b.distance(), "zoom"),
        (a.target() != b.target(), "pan"),
    ];
    let mut parts = parts.into_iter().filter(|part| part.0).map(|part| part.1);
    let what = match (parts.next(), parts.next()) {
        _ if b.is_home() => "home view",
        (Some(only), None) => only,
        _ => "move",
    };
    Some(Edit::of(Area::Camera, what))
}

fn layout(before: &Session, after: &Session) -> Option<Edit> {
    let [a, b] = [&before.views, &after.views];
    if a.layout() == b.layout() {
        return None;
    }
    let [left, come] = [(a, b), (b, a)].map(|(these, those)| {
        let is_gone = |id: &ViewId| those.get(*id).is_none();
        let ids = these.ids().into_iter().filter(is_gone);
        ids.map(|id| these.title(id)).collect::<Vec<_>>()
    });
    let ready = READY_LAYOUTS.iter().find(|ready| b.has_views_of(ready));
    let what = match (&left[..], &come[..], ready) {
        (_, _, Some(ready)) => format!("arrangement {}", ready.name),
        ([only], [], _) => format!("close {only}"),
        ([], [only], _) => format!("open {only}"),
        _ => "arrangement of the views".to_owned(),
    };
    Some(Edit::of(Area::Layout, what))
}

fn directions(before: &Session, after: &Session) -> Option<Edit> {
    if before.hold != after.hold {
        return Some(Edit::of(
            Area::Shown,
            format!("fix the {}", after.held_name()),
        ));
    }
    let place = |session: &Session| [session.theta_deg, session.phi_deg];
    let what = if place(before) != place(after) {
        format!("place of the {}", after.held_name())
    } else if before.other != after.other {
        format!("place of the {}", after.free_name())
    } else if before.rotation_deg != after.rotation_deg {
        "turn of the surface".to_owned()
    } else {
        return None;
    };
    Some(Edit::of(Area::Shown, what))
}

/// How things are shown.
fn shown(before: &Session, after: &Session) -> Option<Edit> {
    let parts = [
        (before.pinned != after.pinned, "pin of a parameter"),
        (before.section_phi_deg != after.section_phi_deg, "section"),
        (before.curves != after.curves, "luminance or R, G and B"),
        (before.with_cosine != after.with_cosine, "times cos θ"),
        (
            before.lobe_surface != after.lobe_surface,
            "surface of the lobes",
        ),
        (before.show_geometry != after.show_geometry, "angles"),
    ];
    if let Some((_, what)) = parts.into_iter().find(|part| part.0) {
        return Some(Edit::of(Area::Shown, what));
    }
    let [a, b] = [&before.views, &after.views];
    let is_other = |id: &ViewId| {
        let was = a.get(*id);
        was.is_some() && was != b.get(*id)
    };
    let mut changed = b.ids().into_iter().filter(is_other);
    let first = changed.next()?;
    let what = match changed.next() {
        None => format!("settings of {}", b.title(first)),
        Some(_) => "settings of several views".to_owned(),
    };
    Some(Edit::of(Area::Shown, what))
}

fn materials(before: &Session, after: &Session) -> Option<Edit> {
    let [a, b] = [&before.materials, &after.materials];
    let missing =
        |entry: &&MaterialEntry, in_them: &Session| in_them.materials.get(entry.id()).is_none();
    let come: Vec<_> = b.iter().filter(|entry| missing(entry, before)).collect();
    let left: Vec<_> = a.iter().filter(|entry| missing(entry, after)).collect();
    let is_other = |entry: &MaterialEntry| a.get(entry.id()).is_some_and(|was| was != entry);
    let what = match (&left[..], &come[..]) {
        ([], []) => return of_each(before, after),
        _ if b.iter().any(is_other) => "other materials".to_owned(),
        ([only], []) => format!("remove {}", a.title(only)),
        ([], [only]) => format!("add {}", b.title(only)),
        ([], several) => format!("add {} materials", several.len()),
        (several, []) => format!("remove {} materials", several.len()),
        _ => "other materials".to_owned(),
    };
    Some(Edit::of(Area::Shown, what))
}

/// What is changed of materials that are the same ones.
fn of_each(before: &Session, after: &Session) -> Option<Edit> {
    let [a, b] = [&before.materials, &after.materials];
    let pairs = b
        .iter()
        .filter_map(|entry| Some((a.get(entry.id())?, entry)));
    let changed: Vec<_> = pairs.filter(|(was, is)| was != is).collect();
    let title = |entry: &MaterialEntry| b.title(entry);
    let what = match &changed[..] {
        [] if before.locked != after.locked => {
            let name = before.locked.symmetric_difference(&after.locked).next()?;
            let mut params = b.iter().flat_map(|entry| entry.material.components());
            let spec = params.find_map(|component| spec_of(component, name))?;
            format!("one slider for {}", in_sentence(&label(spec)))
        }
        [] if a.solo() != b.solo() => {
            let alone = b.solo().and_then(|id| b.get(id));
            alone.map_or_else(
                || "show all materials".to_owned(),
                |entry| format!("show {} alone", title(entry)),
            )
        }
        [] if a.reference().id() != b.reference().id() => {
            format!("compare with {}", title(b.reference()))
        }
        [] if !a
            .iter()
            .map(MaterialEntry::id)
            .eq(b.iter().map(MaterialEntry::id)) =>
        {
            "order of the materials".to_owned()
        }
        [] => return None,
        [(was, is)] => of_one(was, is, (&a.title(was), &title(is))),
        [(was, is), rest @ ..] => {
            let part = part_of(was, is).unwrap_or_else(|| "changes".to_owned());
            format!("{part} of {} materials", rest.len() + 1)
        }
    };
    Some(Edit::of(Area::Shown, what))
}

/// What is changed of one material, which was called `old` and is called `new`.
fn of_one(was: &MaterialEntry, is: &MaterialEntry, (old, new): (&str, &str)) -> String {
    if was.name != is.name {
        return format!("name of {old}");
    }
    if was.is_visible != is.is_visible {
        return format!("{} {new}", if is.is_visible { "show" } else { "hide" });
    }
    part_of(was, is).map_or_else(
        || format!("change {old} to {new}"),
        |part| format!("{part} of {new}"),
    )
}

/// What part of a material is changed; `None` where it is another one.
fn part_of(was: &MaterialEntry, is: &MaterialEntry) -> Option<String> {
    if was.has_linked_widths != is.has_linked_widths && was.material == is.material {
        return Some("same roughness along s and t".to_owned());
    }
    let [a, b] = [was, is].map(|entry| entry.material.components());
    if a.len() != b.len() {
        return Some("lobes".to_owned());
    }
    let pairs = || a.iter().zip(b);
    let is_other = |(a, b): (&Component, &Component)| a.model().id != b.model().id;
    if pairs().any(is_other) || was.material.title() != is.material.title() {
        return None;
    }
    if pairs().any(|(a, b)| a.weight() != b.weight()) {
        return Some("weight of a lobe".to_owned());
    }
    let changed = changed(&was.material, &is.material);
    let is_width = |spec: &&ParamSpec| matches!(spec.role, Role::WidthS | Role::WidthT);
    let (first, rest) = changed.split_first()?;
    Some(if rest.iter().all(|spec| spec.name == first.name) {
        in_sentence(&label(first))
    } else if changed.iter().all(is_width) {
        "roughness".to_owned()
    } else {
        "parameters".to_owned()
    })
}

fn spec_of(component: &Component, name: &str) -> Option<&'static ParamSpec> {
    let mut specs = component.model().parameters.iter();
    specs.find(|spec| spec.name == name)
}

/// A name within a sentence: small, unless it is a symbol.
fn in_sentence(name: &str) -> String {
    let mut letters = name.chars();
    let is_word = letters.clone().nth(1).is_some_and(char::is_lowercase);
    match letters.next() {
        Some(first) if is_word => first.to_lowercase().chain(letters).collect(),
        _ => name.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::session::{HomeView, OrbitCamera};
    use crate::views::{self, hemisphere};
    use bxdf::param::Value;
    use bxdf_lab::analysis::Hold;

    /// What undoing a change of a session with gold and plastic is called.
    fn said(change: impl FnOnce(&mut Session)) -> String {
        let mut before = Session::of("rough_conductor".parse().unwrap());
        before.materials.add("plastic".parse().unwrap()).unwrap();
        let mut after = before.clone();
        change(&mut after);
        Edit::between(&before, &after).title("Undo")
    }

    fn set(session: &mut Session, names: &[&str]) {
        let mut component = session.material().components()[0].clone();
        for name in names {
            component.set(name, Value::Number(0.77)).unwrap();
        }
        session.materials.selected_mut().material = component.into();
    }

    #[test]
    fn edits_of_materials_are_named_by_part_and_material() {
        assert_eq!(
            said(|s| set(s, &["eta"])),
            "Undo: index of refraction (eta) of Plastic"
        );
        assert_eq!(
            said(|s| set(s, &["alpha_x", "alpha_y"])),
            "Undo: roughness of Plastic"
        );
        assert_eq!(
            said(|s| set(s, &["alpha_x"])),
            "Undo: roughness along s (alpha) of Plastic"
        );
        let phong = || "phong".parse().unwrap();
        assert_eq!(
            said(|s| s.materials.add(phong()).map(|_| ()).unwrap()),
            "Undo: add Phong"
        );
        assert_eq!(
            said(|s| s.materials.selected_mut().replace(phong())),
            "Undo: change Plastic to Phong"
        );
        let hide = |s: &mut Session| s.materials.selected_mut().is_visible = false;
        assert_eq!(said(hide), "Undo: hide Plastic");
        let remove = |s: &mut Session| s.materials.remove(s.materials.selected().id());
        assert_eq!(said(remove), "Undo: remove Plastic");
        let lock = |s: &mut Session| {
            s.locked.insert("alpha_x".to_owned());
        };
        assert_eq!(said(lock), "Undo: one slider for roughness along s (alpha)");
    }

    #[test]
    fn layout_and_camera_are_kept_apart() {
        let hemisphere = views::find("hemisphere").unwrap();
        let open = |s: &mut Session| s.views.add(hemisphere, [900.0, 600.0]).map(|_| ()).unwrap();
        assert_eq!(said(open), "Undo layout: open Hemisphere");
        let compare = |s: &mut Session| s.views.show_ready(&READY_LAYOUTS[1], [1280.0, 720.0]);
        assert_eq!(said(compare), "Undo layout: arrangement Compare");
        assert_eq!(said(|s| s.camera.orbit([20.0, 3.0])), "Undo camera: orbit");
        assert_eq!(said(|s| s.camera.zoom(2.0)), "Undo camera: zoom");
        let top = |s: &mut Session| s.camera = OrbitCamera::new(HomeView::Top);
        assert_eq!(said(top), "Undo camera: home view");
        let settings = |s: &mut Session| {
            let id = s.views.add(hemisphere, [900.0, 600.0]).unwrap();
            let before = s.clone();
            s.views
                .each(|map: &mut hemisphere::Options| map.is_lower = true);
            let edit = Edit::between(&before, s);
            assert_eq!(edit.title("Redo"), "Redo: settings of Hemisphere");
            assert!(s.views.get(id).is_some());
        };
        said(settings);
    }

    #[test]
    fn directions_and_what_is_changed_together_are_named() {
        assert_eq!(said(|s| s.set_theta_deg(20.0)), "Undo: place of the light");
        assert_eq!(
            said(|s| s.set_other(glam::DVec3::Z)),
            "Undo: place of the viewer"
        );
        assert_eq!(said(|s| s.set_hold(Hold::Viewer)), "Undo: fix the viewer");
        let anew = || Session::of("phong".parse().unwrap());
        assert_eq!(said(|s| *s = anew()), "Undo: other materials");
        let all = |s: &mut Session| {
            *s = anew();
            s.set_theta_deg(20.0);
            s.with_cosine = true;
        };
        assert_eq!(said(all), "Undo: several changes at once");
    }
}
