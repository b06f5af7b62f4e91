//! The native window.

use std::env;
use std::sync::{Arc, Mutex, PoisonError};

use super::app::App;
use super::{export, headless, screens, theme};
use crate::clipboard;
use crate::dialogs::Native;
use bxdf::error::{Error, Result};
use bxdf_study::platform;
use bxdf_study::session::Session;
use bxdf_study::store::Store;

/// Opens the window and runs it until it is closed.
///
/// # Errors
/// [`Error::Platform`] where there is no display or no graphics adapter, naming the remedy.
pub fn run() -> Result<()> {
    require_display()?;
    let store = Store::platform();
    let viewport = egui::ViewportBuilder::default()
        .with_title("BRDF Explorer")
        .with_app_id("brdf-explorer")
        .with_inner_size(theme::WINDOW_SIZE)
        .with_min_inner_size(theme::MIN_WINDOW_SIZE);
    let options = eframe::NativeOptions {
        viewport: screens::placed(viewport, store.window()),
        ..Default::default()
    };
    let mut exit_problem: Arc<Mutex<Option<Error>>> = Arc::default();
    let exit_problem_of = &mut exit_problem;
    eframe::run_native(
        "brdf-explorer",
        options,
        Box::new(|cc| {
            screens::keep_on_screen(cc);
            let mut app = App::new(cc, Session::default(), None, Some(platform::seconds));
            let store = store.in_threads(app.pool());
            app.use_clipboard(clipboard::native());
            app.work_on(
                &cc.egui_ctx,
                store,
                Box::new(Native::default()),
                export::MAKER,
            );
            *exit_problem_of = app.exit_problem();
            Ok(Box::new(app))
        }),
    )
    .map_err(|error| refusal(&error))?;
    let problem = exit_problem
        .lock()
        .unwrap_or_else(PoisonError::into_inner)
        .take();
    problem.map_or(Ok(()), Err)
}

/// What the user can act on; the window system's own words name files of its source.
fn refusal(error: &eframe::Error) -> Error {
    match error {
        eframe::Error::Wgpu(_) => Error::Platform {
            problem: "no graphics adapter can draw to this display".to_owned(),
            remedy: headless::NO_ADAPTER_REMEDY.to_owned(),
        },
        eframe::Error::Winit(_) | eframe::Error::WinitEventLoop(_) => Error::Platform {
            problem: "the display cannot be opened".to_owned(),
            remedy: "check DISPLAY, or draw to a file with 'brdf-explorer render -o out.png'"
                .to_owned(),
        },
        eframe::Error::AppCreation(other) => Error::Platform {
            problem: format!("the window cannot be opened: {other}"),
            remedy: "'brdf-explorer render -o out.png' draws it to a file".to_owned(),
        },
    }
}

/// On systems that name their display in the environment: one must be named.
fn require_display() -> Result<()> {
    let is_named = ["DISPLAY", "WAYLAND_DISPLAY", "WAYLAND_SOCKET"]
        .iter()
        .any(|name| env::var_os(name).is_some_and(|value| !value.is_empty()));
    if cfg!(all(unix, not(target_os = "macos"))) && !is_named {
        return Err(Error::Platform {
            problem: "no display is found (neither DISPLAY nor WAYLAND_DISPLAY is set)".to_owned(),
            remedy: "start it in a graphical session, or draw to a file with 'brdf-explorer render -o out.png'"
                .to_owned(),
        });
    }
    Ok(())
}
