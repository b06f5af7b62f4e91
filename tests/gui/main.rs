//! The window, driven through accessible labels and compared with stored pictures.

#![expect(clippy::unwrap_used, reason = "a failed step is a failed test")]

mod interaction;
mod render;
mod screenshots;

use brdf_explorer::ui::app::App;
use brdf_explorer::ui::headless::Picture;
use brdf_explorer::ui::session::Session;
use brdf_explorer::ui::views;
use egui::Theme;
use egui_kittest::Harness;

/// The start window showing `material`, or one view of it, settled.
fn picture(
    material: &str,
    view: Option<&str>,
    size: [u32; 2],
    theme: Theme,
) -> Harness<'static, App> {
    let session = Session {
        material: material.parse().unwrap(),
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
fn window(material: &str) -> Harness<'static, App> {
    picture(material, None, [1280, 800], Theme::Dark)
}
