//! The window, driven through accessible labels and compared with stored pictures.

#![expect(
    clippy::indexing_slicing,
    clippy::panic,
    clippy::unwrap_used,
    reason = "a failed step is a failed test"
)]

mod badges;
mod bottom;
mod commands;
mod data;
mod deltas;
mod directions;
mod documents;
mod drawing;
mod export;
mod figure_pages;
mod figures;
mod files;
mod formula_card;
mod fresnel;
mod gestures;
mod history;
mod instances;
mod integral;
mod interaction;
mod keeping;
mod keyboard;
mod lessons;
mod links;
mod list;
mod lobe;
mod materials;
mod number_field;
mod numbers;
mod numerics;
mod overlap;
mod overlay;
mod picker;
mod render;
mod scales;
mod screenshots;
mod sessions;
mod small;
mod tables;
mod tiles;
mod typing;
mod views;
mod workers;

use std::path::PathBuf;

use brdf_explorer::bxdf::Material;
use brdf_explorer::bxdf::material::library;
use brdf_explorer::lab::timing::Stopwatch::NoClock;
use brdf_explorer::lab::tradeoff::FAMILIES;
use brdf_explorer::study::session::{Materials, Session};
use brdf_explorer::study::views::{self as all_views, tradeoff};
use brdf_explorer::ui::app::App;
use brdf_explorer::ui::headless::Picture;
use egui::{Role, Theme};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;

/// Lobes as unlike as they come: broad, narrow, backwards, in deltas, on both sides, and brushed.
const SIX: [&str; 6] = [
    "chalk",
    "brass",
    "road_sign",
    "mirror",
    "frosted_glass",
    "brushed_steel",
];

/// Three for a comparison.
const THREE: [&str; 3] = ["rough_conductor", "plastic", "oren_nayar"];

/// As many as fit a lecture.
const EIGHT: [&str; 8] = [
    "rough_conductor",
    "plastic",
    "oren_nayar",
    "frosted_glass",
    "velvet_cloth",
    "fresnel_specular",
    "moon",
    "brushed_steel",
];

/// A folder of its own, removed in the end.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let path =
            std::env::temp_dir().join(format!("brdf-explorer-{name}-{}", std::process::id()));
        std::fs::create_dir_all(&path).unwrap();
        Self(path)
    }

    fn file(&self, name: &str) -> PathBuf {
        self.0.join(name)
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

/// The material of this text, or the named one with this id.
fn material(text: &str) -> Material {
    library::find(text).map_or_else(|_| text.parse().unwrap(), |named| named.material.clone())
}

/// The families of the trade-off that are measured here: those that take no long time without optimisation.
const QUICK_FAMILIES: [&str; 2] = ["precision", "stand_ins"];

/// The start, showing these materials; the first one is selected.
fn session(shown: &[&str]) -> Session {
    let materials = shown.iter().map(|text| material(text)).collect();
    let mut session = Session {
        materials: Materials::new(materials).unwrap(),
        ..Session::default()
    };
    let ids = FAMILIES.iter().map(|family| family.id());
    let slow = ids.filter(|id| !QUICK_FAMILIES.contains(id));
    let slow: Vec<String> = slow.map(str::to_owned).collect();
    session
        .views
        .each(|tradeoff: &mut tradeoff::Options| tradeoff.left_out.clone_from(&slow));
    session
}

/// Measures the trade-off, where it is shown, as if each thing took as long as it is large.
fn measure_tradeoff(harness: &mut Harness<'_, App>) {
    harness.state_mut().use_stopwatch(NoClock);
    if let Some(button) = harness.query_by_label("Measure") {
        button.click();
    } else {
        // A picture has no button.
        let views = &mut harness.state_mut().session.views;
        views.each(|options: &mut tradeoff::Options| options.is_immediate = true);
    }
    harness.run();
}

/// Chooses `item` in the drop-down `name`.
fn choose(harness: &mut Harness<'_, App>, name: &str, item: &str) {
    harness.get_by_role_and_label(Role::ComboBox, name).click();
    harness.run();
    harness.get_by_role_and_label(Role::Button, item).click();
    harness.run();
}

/// An edit of what is shown.
fn show_decades(harness: &mut Harness<'_, App>) {
    choose(harness, "Scale of Polar plot", "Logarithmic");
}

/// The window showing `session`, or its first view of a kind alone, settled.
fn picture(mut session: Session, view: Option<&str>, size: [u32; 2], theme: Theme) -> Picture {
    let only = view.map(|id| session.views.show_alone(all_views::find(id).unwrap()));
    Picture {
        session,
        only,
        size,
        scale: 1.0,
        theme,
        figure: None,
    }
}

/// Chooses what has this title from the pictures, in place of the selected material.
fn pick(harness: &mut Harness<'_, App>, title: &str) {
    harness.get_by_label("Change…").click();
    harness.run();
    let cell = harness.get_by_role_and_label(egui::Role::Button, title);
    cell.scroll_to_me();
    harness.run();
    let cell = harness.get_by_role_and_label(egui::Role::Button, title);
    cell.click();
    harness.run();
}

/// The start window with several materials.
fn window_of(shown: &[&str]) -> Harness<'static, App> {
    let picture = picture(session(shown), None, [1280, 800], Theme::Dark);
    picture.harness().unwrap()
}

/// The start window.
fn window(shown: &str) -> Harness<'static, App> {
    window_of(&[shown])
}
