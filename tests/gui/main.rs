//! The window, driven through accessible labels and compared with stored pictures.

#![expect(clippy::unwrap_used, reason = "a failed step is a failed test")]

mod interaction;
mod materials;
mod render;
mod screenshots;

use brdf_explorer::bxdf::Material;
use brdf_explorer::bxdf::material::library;
use brdf_explorer::ui::app::App;
use brdf_explorer::ui::headless::Picture;
use brdf_explorer::ui::session::Session;
use brdf_explorer::ui::views;
use egui::Theme;
use egui_kittest::Harness;

/// The material of this text, or the named one with this id.
fn material(text: &str) -> Material {
    library::find(text).map_or_else(|_| text.parse().unwrap(), |named| named.material.clone())
}

/// The start window showing `shown`, or one view of it, settled.
fn picture(shown: &str, view: Option<&str>, size: [u32; 2], theme: Theme) -> Harness<'static, App> {
    let session = Session {
        material: material(shown),
        ..Session::default()
    };
    let only = view.map(|id| views::find(id).unwrap());
    Picture {
        session,
        only,
        size,
        scale: 1.0,
        theme,
    }
    .harness()
    .unwrap()
}

/// The start window.
fn window(shown: &str) -> Harness<'static, App> {
    picture(shown, None, [1280, 800], Theme::Dark)
}
