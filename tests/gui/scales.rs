//! The scales of the views, lobes side by side, the size of labels, presenting, and the first steps, by accessible labels.

use brdf_explorer::study::session::{READY_LAYOUTS, Session};
use brdf_explorer::study::views::{self, Arrangement, ScaleChoice, lobe3d, polar};
use brdf_explorer::ui::app::App;
use egui::{Key, Modifiers, Role, Shape, Theme, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;

use super::files::work_in;
use super::{Folder, choose, window, window_of};

/// A parameter of metals.
const ROUGHNESS: &str = "Roughness along s (alpha)";

/// The texts on the screen that begin so.
fn painted(harness: &Harness<'_, App>, start: &str) -> Vec<String> {
    fn texts(shape: &Shape, all: &mut Vec<String>) {
        match shape {
            Shape::Text(text) => all.push(text.galley.text().to_owned()),
            Shape::Vec(shapes) => shapes.iter().for_each(|shape| texts(shape, all)),
            _ => {}
        }
    }
    let mut all = Vec::new();
    for clipped in &harness.output().shapes {
        texts(&clipped.shape, &mut all);
    }
    all.retain(|text| text.starts_with(start));
    all
}

fn click(harness: &mut Harness<'_, App>, label: &str) {
    harness.get_by_label(label).click();
    harness.run();
}

fn session<'a>(harness: &'a Harness<'_, App>) -> &'a Session {
    &harness.state().session
}

#[test]
fn the_four_kinds_stand_side_by_side_after_one_click() {
    let mut harness = window("rough_conductor");
    let before = session(&harness).clone();
    click(&mut harness, "Four kinds");
    let lobes = harness.query_all_by_role_and_label(Role::Canvas, "3D lobe");
    let places: Vec<egui::Rect> = lobes.map(|lobe| lobe.rect()).collect();
    assert_eq!(places.len(), 4);
    for (index, place) in places.iter().enumerate() {
        assert!(place.width() > 150.0 && place.height() > 100.0, "{place:?}");
        assert!(
            places[..index]
                .iter()
                .all(|other| !other.intersects(*place))
        );
    }
    for view in ["3D lobe", "Polar plot"] {
        let name = format!("Scale of {view}");
        let scale = harness.get_by_label(&name);
        assert_eq!(scale.value().as_deref(), Some("Each to its peak"), "{view}");
    }
    for kind in [
        "Diffuse",
        "Glossy specular",
        "Perfect specular",
        "Retro-reflective",
    ] {
        // In either view, with the scale of what has one.
        assert_eq!(painted(&harness, kind).len(), 2, "{kind}");
    }
    let all = painted(&harness, "").into_iter();
    let scales = all.filter(|text| text.contains("own scale, peak f "));
    assert_eq!(scales.count(), 6, "a mirror has no f");
    let note = "The four kinds stand in place of your materials: Undo (Ctrl+Z) brings those back";
    assert!(harness.query_by_label(note).is_some());
    // Each has a light to be dragged, and all follow.
    let lights = harness.query_all_by_label("Light in the 3D lobe");
    assert_eq!(lights.count(), 4);
    click(&mut harness, "Undo");
    assert_eq!(*session(&harness), before);
}

#[test]
fn a_scale_holds_during_a_drag_and_goes_over_once_afterwards() {
    let mut harness = window("gold");
    let radius = |harness: &Harness<'_, App>| painted(harness, "radius = f");
    let before = radius(&harness);
    assert_eq!(before.len(), 1);
    let from = harness
        .get_by_label("Light in the polar plot")
        .rect()
        .center();
    harness.hover_at(from);
    harness.run();
    harness.drag_at(from);
    for step in 1..=6 {
        harness.hover_at(from + vec2(-1.0, 3.0) * step as f32);
        harness.step();
        assert_eq!(radius(&harness), before, "in the middle of the drag");
    }
    let theta_deg = session(&harness).theta_deg;
    assert!(theta_deg > 53.0, "towards grazing: {theta_deg}");
    harness.drop_at(from + vec2(-6.0, 18.0));
    harness.run();
    assert_ne!(radius(&harness), before, "let go");
    assert!(!harness.ctx.has_requested_repaint(), "and at rest");
}

#[test]
fn a_locked_scale_stays_whatever_is_shown() {
    let mut harness = window("gold");
    let scale = |harness: &Harness<'_, App>| {
        let plot: polar::Options = session(harness).views.options();
        plot.scale
    };
    click(&mut harness, "Lock the scale of Polar plot");
    let locked = scale(&harness).locked_at.unwrap();
    let gold = painted(&harness, "f in 1/sr");
    harness
        .state_mut()
        .session
        .materials
        .selected_mut()
        .replace("lambertian_reflection".parse().unwrap());
    harness.run();
    assert_eq!(scale(&harness).locked_at, Some(locked));
    assert_eq!(painted(&harness, "f in 1/sr"), gold);
    let lobe: lobe3d::Options = session(&harness).views.options();
    assert_eq!(lobe.scale.locked_at, None, "each view has its own");
    let text = session(&harness).to_toml().unwrap();
    assert_eq!(Session::from_toml(&text, "s").unwrap(), *session(&harness));
    click(&mut harness, "Lock the scale of Polar plot");
    assert_eq!(scale(&harness).locked_at, None);
}

/// The numbers at the left of the Cartesian plot, which is alone in its window.
fn heights(harness: &Harness<'_, App>) -> Vec<String> {
    let plot = harness.get_by_role_and_label(Role::Canvas, "Cartesian plot");
    let left = plot.rect().left();
    let mut found = Vec::new();
    for clipped in &harness.output().shapes {
        if let Shape::Text(text) = &clipped.shape
            && (left - 60.0..left - 1.0).contains(&text.pos.x)
            && text.galley.text() != "-90"
            && text.galley.text().parse::<f64>().is_ok()
        {
            found.push(text.galley.text().to_owned());
        }
    }
    found
}

#[test]
fn the_cartesian_plot_keeps_its_scale_too() {
    let mut harness = window("gold");
    let cartesian = views::find("cartesian").unwrap();
    harness.state_mut().session.views.show_alone(cartesian);
    harness.run();
    let before = heights(&harness);
    assert!(before.len() > 3, "{before:?}");
    // While something is dragged, here a number of the light, it stays though the peak moves.
    let number = harness.get_by_role_and_label(Role::SpinButton, "θ from n");
    let from = number.rect().center();
    harness.hover_at(from);
    harness.drag_at(from);
    for step in 1..=6 {
        harness.hover_at(from + vec2(3.0 * step as f32, 0.0));
        harness.step();
    }
    assert_ne!(session(&harness).theta_deg, 45.0);
    assert_eq!(heights(&harness), before, "in the middle of the drag");
    harness.drop_at(from + vec2(18.0, 0.0));
    harness.run();
    // Locked, it stays for a material that is far lower, and for one that leaves it.
    click(&mut harness, "Lock the scale of Cartesian plot");
    let locked = heights(&harness);
    for material in ["lambertian_reflection", "rough_conductor:alpha=0.01"] {
        let material = material.parse().unwrap();
        let materials = &mut harness.state_mut().session.materials;
        materials.selected_mut().replace(material);
        harness.run();
        assert_eq!(heights(&harness), locked);
    }
    assert!(harness.query_by_label_contains("Reset view").is_none());
    click(&mut harness, "Lock the scale of Cartesian plot");
    assert_ne!(heights(&harness), locked);
}

#[test]
fn an_arrangement_is_folded_where_there_is_no_room_for_it() {
    let small = super::picture(super::session(&["gold"]), None, [1024, 640], Theme::Dark);
    let mut harness = small.harness().unwrap();
    let compare = READY_LAYOUTS.iter().find(|ready| ready.name == "Compare");
    let compare = compare.unwrap();
    let tiles = |harness: &Harness<'_, App>| {
        let layout = session(harness).views.layout();
        format!("{layout:?}").matches("Tabs").count()
    };
    click(&mut harness, "Compare");
    assert_eq!(tiles(&harness), 1, "the inspector is a tab");
    let room = harness.state().room_of_views();
    assert!(session(&harness).views.is_ready(compare, room));
    // In a window with room it stands unfolded again, when it is asked for.
    harness.set_size(vec2(1280.0, 800.0));
    harness.run();
    click(&mut harness, "Compare");
    assert_eq!(tiles(&harness), 0);
}

#[test]
fn a_small_lobe_is_told_of_and_shown_to_its_peak() {
    let mut harness = window_of(&[
        "lambertian_reflection",
        "rough_conductor:alpha_x=0.05,alpha_y=0.05",
    ]);
    let offers = || painted(&harness, "Lambertian reflection is ");
    assert_eq!(offers().len(), 2, "in both views: {:?}", offers());
    click(&mut harness, "Small lobes of Polar plot");
    let views = &session(&harness).views;
    let choices = [
        views.options::<polar::Options>().scale.choice(),
        views.options::<lobe3d::Options>().scale.choice(),
    ];
    assert!(choices.contains(&ScaleChoice::EachToPeak) && choices.contains(&ScaleChoice::Same));
    assert_eq!(painted(&harness, "Lambertian reflection is ").len(), 1);
    // On its own scale it is as long as the other one.
    choose(&mut harness, "Scale of 3D lobe", "Each to its peak");
    assert_eq!(
        painted(&harness, "each its own scale: radius = f over its peak").len(),
        1
    );
    choose(&mut harness, "Arrangement of 3D lobe", "Side by side");
    let lobe: lobe3d::Options = session(&harness).views.options();
    assert_eq!(lobe.arrangement, Arrangement::SideBySide);
    let own = painted(&harness, "").into_iter();
    let own = own.filter(|text| text.contains("own scale, peak f "));
    assert_eq!(own.count(), 2, "each says its own");
}

#[test]
fn presenting_shows_the_views_alone_and_escape_returns() {
    let mut harness = window("gold");
    let zoom = harness.ctx.zoom_factor();
    let before = session(&harness).clone();
    harness.key_press(Key::F5);
    harness.run();
    assert!(harness.query_by_label("Your materials").is_none());
    assert!(harness.query_by_label("Four kinds").is_none());
    let slider = |harness: &Harness<'_, App>, name| {
        let found = harness.query_by_role_and_label(Role::Slider, name);
        found.is_some()
    };
    assert!(slider(&harness, "θ from n"), "the slim bar");
    assert!(!slider(&harness, ROUGHNESS), "nothing is pinned");
    assert!(harness.ctx.zoom_factor() > 1.3 * zoom);
    harness.key_press(Key::Escape);
    harness.run();
    assert_eq!(harness.ctx.zoom_factor(), zoom);
    assert!(harness.query_by_label("Your materials").is_some());
    assert_eq!(*session(&harness), before);
}

#[test]
fn what_is_pinned_has_a_slider_while_presenting_and_stays_pinned() {
    let mut harness = window("gold");
    click(&mut harness, &format!("Pin {ROUGHNESS}"));
    // By a command, too: what was changed last.
    harness
        .get_by_role_and_label(Role::Slider, "Roughness along t (alpha)")
        .focus();
    harness.run();
    harness.key_press(Key::ArrowRight);
    harness.run();
    assert_eq!(session(&harness).pinned.len(), 1);
    harness.key_press_modifiers(Modifiers::COMMAND.plus(Modifiers::SHIFT), Key::P);
    harness.run();
    assert_eq!(session(&harness).pinned.len(), 2);
    harness.key_press(Key::F5);
    harness.run();
    let before = session(&harness).material().clone();
    harness
        .get_by_role_and_label(Role::Slider, ROUGHNESS)
        .focus();
    harness.run();
    harness.key_press(Key::ArrowRight);
    harness.run();
    let component = &session(&harness).material().components()[0];
    let [s, t] = ["alpha_x", "alpha_y"].map(|name| component.params().get(name));
    assert_ne!(*session(&harness).material(), before);
    assert_eq!(s, t, "what is linked follows");
    let text = session(&harness).to_toml().unwrap();
    let again = Session::from_toml(&text, "s").unwrap();
    assert_eq!(again.pinned, session(&harness).pinned);
}

#[test]
fn labels_grow_by_themselves_and_stay_so() {
    let folder = Folder::new("labels");
    let size = |harness: &Harness<'_, App>, text: &str| {
        let shapes = harness.output().shapes.iter();
        let mut found = shapes.filter_map(|clipped| match &clipped.shape {
            egui::Shape::Text(shape) if shape.galley.text() == text => Some(shape.galley.size().y),
            _ => None,
        });
        found.next().unwrap()
    };
    let mut harness = window("gold");
    work_in(&mut harness, &folder);
    harness.run();
    let [label, other] = ["30°", "Your materials"].map(|text| size(&harness, text));
    click(&mut harness, "Theme");
    click(&mut harness, "Labels at 200 %");
    harness.run();
    assert!(size(&harness, "30°") > 1.8 * label);
    assert_eq!(size(&harness, "Your materials"), other);
    let mut next = window("gold");
    work_in(&mut next, &folder);
    next.run();
    assert!(size(&next, "30°") > 1.8 * label);
    next.key_press_modifiers(Modifiers::COMMAND.plus(Modifiers::SHIFT), Key::L);
    next.run();
    assert_eq!(size(&next, "30°"), label);
}

#[test]
fn the_first_steps_go_on_by_doing_and_come_once() {
    let folder = Folder::new("first-steps");
    let mut harness = window("gold");
    assert!(
        harness.query_by_label("1 of 5").is_none(),
        "not in pictures"
    );
    work_in(&mut harness, &folder);
    harness.run();
    assert!(harness.query_by_label("1 of 5").is_some());
    harness.state_mut().session.set_theta_deg(20.0);
    harness.run();
    assert!(harness.query_by_label("2 of 5").is_some());
    super::pick(&mut harness, "Chalk");
    assert!(harness.query_by_label("3 of 5").is_some());
    harness.key_press(Key::F5);
    harness.run();
    assert!(
        harness.query_by_label("3 of 5").is_none(),
        "nobody learns while presenting"
    );
    harness.key_press(Key::Escape);
    harness.run();
    click(&mut harness, "Skip");
    assert!(harness.query_by_label_contains(" of 5").is_none());
    let mut next = window("gold");
    work_in(&mut next, &folder);
    next.run();
    assert!(next.query_by_label_contains(" of 5").is_none());
    next.key_press_modifiers(Modifiers::SHIFT, Key::F1);
    next.run();
    assert!(next.query_by_label("1 of 5").is_some(), "brought back");
}

#[test]
fn the_offer_of_other_scales_stands_apart_from_the_reset() {
    let mut harness = window_of(&["rough_conductor:alpha=0.02", "lambertian_reflection"]);
    let offered = "% of the scale";
    assert!(harness.query_all_by_label_contains(offered).count() > 0);
    harness.state_mut().session.camera.orbit(vec2(40.0, 20.0));
    harness.run();
    let reset = harness.get_by_label("Reset view").rect();
    let offers = harness.query_all_by_label_contains(offered);
    let offers: Vec<egui::Rect> = offers.map(|offer| offer.rect()).collect();
    assert!(!offers.is_empty());
    for offer in offers {
        assert!(!offer.intersects(reset), "{offer} {reset}");
    }
}
