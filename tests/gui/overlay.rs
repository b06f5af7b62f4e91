//! Several materials in the views, by accessible label.

use brdf_explorer::study::session::{LobeSurface, Materials};
use brdf_explorer::ui::app::App;
use egui::{Role, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable};

use super::{choose, window, window_of};

const THREE: [&str; 3] = ["rough_conductor", "plastic", "oren_nayar"];

fn materials<'a>(harness: &'a Harness<'_, App>) -> &'a Materials {
    &harness.state().session.materials
}

#[test]
fn the_legend_of_each_view_names_and_selects() {
    let mut harness = window_of(&THREE);
    for name in ["Legend: Plastic", "Legend: Oren-Nayar"] {
        for view in [0, 1] {
            let rows: Vec<_> = harness.query_all_by_label(name).collect();
            assert_eq!(rows.len(), 2, "one in each view");
            rows[view].click();
            harness.run();
            let selected = materials(&harness).selected();
            assert_eq!(
                format!("Legend: {}", materials(&harness).title(selected)),
                name
            );
            // The other view selects another one, so that the next click shows.
            harness
                .query_all_by_label("Legend: Rough conductor")
                .next()
                .unwrap()
                .click();
            harness.run();
        }
    }
    let single = window("rough_conductor");
    assert!(single.query_by_label_contains("Legend").is_none());
}

/// The choice of the curves.
const CURVES: &str = "Curves of Polar plot";

#[test]
fn channels_are_told_apart_where_one_material_is_shown() {
    let mut harness = window("rough_conductor");
    choose(&mut harness, CURVES, "R, G, B");
    let added = "plastic".parse().unwrap();
    harness.state_mut().session.materials.add(added).unwrap();
    harness.run();
    assert!(harness.get_by_label(CURVES).accesskit_node().is_disabled());
    let first = materials(&harness).iter().next().unwrap().id();
    harness.state_mut().session.materials.set_solo(Some(first));
    harness.run();
    assert!(!harness.get_by_label(CURVES).accesskit_node().is_disabled());
}

#[test]
fn the_read_out_names_the_material() {
    let mut harness = window_of(&[
        "lambertian_reflection",
        "lambertian_reflection:reflectance=0.4",
    ]);
    let second = materials(&harness).iter().nth(1).unwrap().id();
    let dome = harness
        .get_by_role_and_label(Role::Canvas, "3D lobe")
        .rect();
    harness.hover_at(dome.center());
    harness.run();
    let outer = "Lambertian reflection:  θ";
    assert!(
        harness.query_by_label_contains(outer).is_some(),
        "the outer lobe is met first"
    );
    harness.state_mut().session.materials.select(second);
    let held = harness.get_by_label("Light in the polar plot");
    harness.hover_at(held.rect().center() + vec2(140.0, 0.0));
    harness.run();
    let read = "Lambertian reflection 2:  θ";
    assert!(
        harness.query_by_label_contains(read).is_some(),
        "the selected one"
    );
    assert!(
        harness.query_by_label_contains("f 0.127 1/sr").is_some(),
        "0.4 / pi"
    );
}

#[test]
fn lobes_are_drawn_as_chosen() {
    let mut harness = window_of(&THREE);
    let mut pictures = Vec::new();
    for (label, surface) in [
        ("Wire", LobeSurface::Wire),
        ("Translucent", LobeSurface::Translucent),
        ("Solid", LobeSurface::Solid),
    ] {
        choose(&mut harness, "Surface of 3D lobe", label);
        assert_eq!(harness.state().session.lobe_surface, surface);
        pictures.push(harness.render().unwrap());
    }
    assert!(pictures[0] != pictures[1] && pictures[1] != pictures[2]);
}

#[test]
fn every_material_may_be_hidden() {
    let mut harness = window_of(&THREE);
    for entry in harness.state_mut().session.materials.iter_mut() {
        entry.is_visible = false;
    }
    harness.run();
    assert!(harness.query_by_label_contains("Legend").is_none());
    // The shares are those of the selected one, whichever are seen.
    assert!(harness.query_by_label_contains("reflected ").is_some());
}

#[test]
fn the_list_shows_as_many_rows_as_there_is_room_for() {
    let mut harness = window_of(&super::EIGHT);
    // How high the parameters are is known from the second frame on.
    harness.run();
    let parameters = harness.get_by_label("Change…").rect().top();
    let rows = harness.query_all_by_label_contains("Menu of ");
    let lowest: Vec<f32> = rows.map(|row| row.rect().bottom()).collect();
    assert_eq!(lowest.len(), super::EIGHT.len());
    assert!(lowest.iter().all(|bottom| *bottom < parameters));
}
