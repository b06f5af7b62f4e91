//! The views as tiles, and the one cursor, by accessible label.

use brdf_explorer::study::session::{Place, READY_LAYOUTS, Session};
use brdf_explorer::ui::app::App;
use brdf_explorer::ui::widgets::status::IN_PLANE;
use egui::{Rect, Role, Shape, Theme, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT, Queryable};

use super::figures::texts_of;
use super::{picture, session, window, window_of};

fn layout(harness: &Harness<'_, App>) -> Vec<&'static str> {
    let views = &harness.state().session.views;
    let kinds = views.ids().into_iter().filter_map(|id| views.kind(id));
    kinds.map(|kind| kind.id).collect()
}

#[test]
fn ready_layouts_are_a_click_away_and_undone() {
    let mut harness = window("rough_conductor");
    assert_eq!(layout(&harness), ["lobe3d", "polar"]);
    harness.get_by_label("Compare").click();
    harness.run();
    assert_eq!(layout(&harness), ["lobe3d", "polar", "inspector"]);
    assert!(
        harness.query_by_label("Copy").is_some(),
        "the inspector is seen"
    );
    harness.get_by_label("Undo").click();
    harness.run();
    assert_eq!(layout(&harness), ["lobe3d", "polar"]);
}

#[test]
fn views_are_closed_and_added() {
    let mut harness = window("rough_conductor");
    let close = harness.query_all_by_label("Close").next().unwrap();
    close.click();
    harness.run();
    assert_eq!(layout(&harness), ["polar"]);
    assert!(
        harness.query_by_label("Close").is_none(),
        "the last view stays"
    );
    harness.get_by_label("Views").click();
    harness.run();
    harness.get_by_label("Add 3D lobe").click();
    harness.run();
    assert_eq!(layout(&harness), ["polar", "lobe3d"]);
}

#[test]
fn a_view_gets_all_the_room_and_gives_it_back() {
    let mut harness = window("rough_conductor");
    let canvas = |harness: &Harness<'_, App>, name| {
        let found = harness
            .query_all_by_role_and_label(Role::Canvas, name)
            .next();
        found.map(|node| node.rect().width())
    };
    let before = canvas(&harness, "3D lobe").unwrap();
    harness.get_by_label("Maximise 3D lobe").click();
    harness.run();
    assert!(canvas(&harness, "3D lobe").unwrap() > 1.4 * before);
    assert!(harness.query_by_label("Scale of Polar plot").is_none());
    harness.get_by_label("Restore 3D lobe").click();
    harness.run();
    assert_eq!(canvas(&harness, "3D lobe"), Some(before));
    // By a double click on the name, too; what is opened is to be seen.
    let name = harness.get_by_role_and_label(Role::Button, "3D lobe");
    let name = name.rect().center();
    harness.hover_at(name);
    harness.run();
    // Within one frame, since the harness lets a quarter of a second pass between frames.
    for pressed in [true, false, true, false] {
        harness.input_mut().events.push(egui::Event::PointerButton {
            pos: name,
            button: egui::PointerButton::Primary,
            pressed,
            modifiers: egui::Modifiers::NONE,
        });
    }
    harness.run();
    assert!(canvas(&harness, "3D lobe").unwrap() > 1.4 * before);
    harness.get_by_label("Views").click();
    harness.run();
    harness.get_by_label("Add Slice").click();
    harness.run();
    assert!(harness.query_by_label("Scale of Polar plot").is_some());
    assert_eq!(layout(&harness).len(), 3);
}

#[test]
fn a_dragged_tab_makes_tabs_of_two_views() {
    let mut harness = window("rough_conductor");
    let place = |harness: &Harness<'_, App>, name| {
        harness
            .get_by_role_and_label(Role::Button, name)
            .rect()
            .center()
    };
    let (from, to) = (place(&harness, "3D lobe"), place(&harness, "Polar plot"));
    harness.drag_at(from);
    harness.run_steps(2);
    for part in [0.2_f32, 0.6, 1.0, 1.0] {
        harness.hover_at(from + part * (to - from));
        harness.run_steps(2);
    }
    harness.drop_at(to);
    harness.run();
    let Place::Tabs { views, .. } = harness.state().session.views.layout() else {
        panic!("{:?}", harness.state().session.views);
    };
    assert_eq!(views.len(), 2);
    let text = harness.state().session.to_toml().unwrap();
    assert_eq!(
        Session::from_toml(&text, "s").unwrap(),
        harness.state().session
    );
}

#[test]
fn the_inspector_reads_every_material_at_the_one_cursor() {
    let mut harness = window_of(&["lambertian_reflection:reflectance=0.5", "rough_conductor"]);
    harness.get_by_label("Compare").click();
    harness.run();
    // 0.5 / pi in each channel, whatever the direction.
    let value = "0.159";
    let before = harness.query_all_by_label_contains(value).count();
    assert!(before >= 3, "{before}");
    assert!(
        harness.query_by_label("θ 50°  φ 0°").is_some(),
        "the mirror direction at first"
    );
    let dome = harness
        .get_by_role_and_label(Role::Canvas, "3D lobe")
        .rect();
    harness.hover_at(dome.center() + vec2(30.0, -40.0));
    harness.run();
    assert!(
        harness.query_by_label("θ 50°  φ 0°").is_none(),
        "the cursor has moved"
    );
    // The pointer leaves for the settings, or the views: the light and the viewer are read again.
    let settings = harness.get_by_label("Scale of Polar plot");
    let settings = settings.rect().center();
    for away in [settings, egui::pos2(2.0, 2.0)] {
        harness.hover_at(dome.center() + vec2(30.0, -40.0));
        harness.run();
        assert!(harness.query_by_label("θ 50°  φ 0°").is_none());
        harness.hover_at(away);
        harness.run();
        assert!(harness.query_by_label("θ 50°  φ 0°").is_some(), "{away:?}");
    }
    assert_eq!(harness.query_all_by_label_contains(value).count(), before);
}

/// The polar angle that a text begins with, in degrees.
fn theta_deg(text: &str) -> Option<f64> {
    let (angle, _) = text.strip_prefix("θ ")?.split_once('°')?;
    angle.parse().ok()
}

/// Below an opaque surface there is nothing to be read: what is read there is the pair of light and viewer.
#[test]
fn the_inspector_follows_no_pointer_below_what_lets_no_light_through() {
    for (material, is_read) in [("rough_conductor", false), ("frosted_glass", true)] {
        let mut harness = window_of(&[material]);
        harness.get_by_label("Compare").click();
        harness.run();
        let dome = harness
            .get_by_role_and_label(Role::Canvas, "3D lobe")
            .rect();
        let (mut pointed, mut read) = (0, 0);
        for step in 0..12 {
            harness.hover_at(dome.center() + vec2(0.0, 0.04 * step as f32 * dome.height()));
            harness.run();
            // A note beside the pointer has a value, the viewer in the inspector has none.
            let below = |text: &str| theta_deg(text).is_some_and(|theta| theta > 90.0);
            let notes = texts_of(&harness).into_iter();
            pointed += notes
                .filter(|text| below(text) && text.contains("  f "))
                .count();
            let labels = harness.query_all_by_label_contains("θ ");
            let labels = labels.filter_map(|node| node.accesskit_node().value());
            read += labels
                .filter(|text| below(text) && !text.contains("  f "))
                .count();
        }
        assert!(pointed > 0, "{material}: nothing below is pointed at");
        assert_eq!(read > 0, is_read, "{material}");
    }
}

/// In the surface plane the Inspector has the value of the bar below, which says so in the same words.
#[test]
fn the_inspector_and_the_bar_show_one_limit_in_the_surface_plane() {
    let mut shown = session(&["oren_nayar:sigma=30"]);
    shown.put_other(glam::DVec3::X);
    let mut harness = picture(shown, None, [1600, 900], Theme::Dark).controls();
    harness.get_by_label("Compare").click();
    harness.run();
    let bar = harness.get_by_label_contains("θ 90°  φ 0°  f ");
    let (place, text) = (bar.rect(), bar.accesskit_node().value().unwrap());
    let value = text.split_whitespace().nth(5).unwrap().to_owned();
    assert!(value.parse::<f64>().unwrap() > 0.05, "{text}");
    let in_table = harness.query_all_by_label(&value).count();
    assert!(in_table >= 4, "luminance, R, G and B: {in_table}");
    assert_eq!(harness.query_all_by_label(IN_PLANE).count(), 1);
    harness.hover_at(place.center());
    harness.run_steps(6);
    assert!(
        texts_of(&harness)
            .iter()
            .filter(|text| **text == IN_PLANE)
            .count()
            == 2
    );
}

#[test]
fn the_inspector_has_columns_of_the_deltas_that_there_are() {
    for (material, sides) in [
        ("mirror", [true, false]),
        ("glass", [true, true]),
        ("gold", [false; 2]),
    ] {
        let mut harness = window_of(&[material]);
        harness.get_by_label("Compare").click();
        harness.run();
        let found = ["Delta, reflected", "Delta, transmitted"]
            .map(|name| harness.query_by_label(name).is_some());
        assert_eq!(found, sides, "{material}");
    }
}

/// The window of 1024 by 640 with a layout that is made for its panel folded, and the panel unfolded.
fn crowded(layout: &str) -> Harness<'static, App> {
    let mut shown = session(&["rough_conductor"]);
    let ready = READY_LAYOUTS.iter().find(|ready| ready.name == layout);
    shown.views.show_ready(ready.unwrap(), [970.0, 560.0]);
    let mut harness = picture(shown, None, [1024, 640], Theme::Dark).controls();
    harness.get_by_label("Fold the side panel").click();
    harness.run();
    assert!(harness.query_by_label("Your materials").is_some());
    harness
}

/// Where the texts are seen that contain this.
fn seen(harness: &Harness<'_, App>, part: &str) -> Vec<Rect> {
    fn texts(shape: &Shape, clip: Rect, part: &str, all: &mut Vec<Rect>) {
        match shape {
            Shape::Text(text) if text.galley.text().contains(part) => {
                let rect = text.visual_bounding_rect();
                assert!(clip.contains_rect(rect), "{rect} is cut at {clip}");
                all.push(rect);
            }
            Shape::Vec(shapes) => {
                for shape in shapes {
                    texts(shape, clip, part, all);
                }
            }
            _ => {}
        }
    }
    let mut all = Vec::new();
    for clipped in &harness.output().shapes {
        texts(&clipped.shape, clipped.clip_rect, part, &mut all);
    }
    all
}

#[test]
fn what_the_pointer_reads_stays_in_its_tile() {
    let mut harness = crowded("Reflectance");
    let neighbour = harness
        .get_by_role_and_label(Role::ComboBox, "Into")
        .rect()
        .left();
    let pictures = harness.query_all_by_role_and_label(Role::Canvas, "Rough conductor");
    let pictures: Vec<Rect> = pictures.map(|picture| picture.rect()).collect();
    // The lit sphere is on the other side.
    let mut pictures = pictures.into_iter();
    let dome = pictures.find(|rect| rect.right() < neighbour).unwrap();
    for share in [0.35, 0.5, 0.65] {
        let at = dome.min + dome.size() * vec2(share, 0.3);
        harness.hover_at(at);
        harness.run();
        for note in seen(&harness, " sr = ") {
            assert!(note.right() < neighbour, "{note} {neighbour}");
        }
    }
    assert!(!seen(&harness, " sr = ").is_empty());
}

#[test]
fn a_plot_that_nobody_has_moved_is_not_to_be_reset() {
    for layout in ["Numerics", "Reflectance", "Look", "Compare"] {
        let harness = crowded(layout);
        assert!(harness.query_by_label("Reset view").is_none(), "{layout}");
    }
}
