//! The application on a page: what its address asks for, what is dropped on it, and what it keeps when it is left.

use std::path::PathBuf;
use std::sync::Arc;
use std::sync::mpsc::{self, Receiver, Sender};

use eframe::WebRunner;
use egui::{Context, RawInput, Ui};
use wasm_bindgen::prelude::*;
use web_sys::UrlSearchParams;

use bxdf_study::colors::Theme;
use bxdf_study::session::Session;
use bxdf_study::store::{Files as _, Store};
use bxdf_study::{link, platform};
use bxdf_ui::app::App;
use bxdf_ui::{export, headless, theme};

use crate::dialogs::{PageDialogs, opened};
use crate::files::{KEPT, PageFiles, is_kept};
use crate::probe::Probe;

/// What is said once where the browser keeps nothing.
const KEEPS_NOTHING: &str = "This browser keeps nothing for the next visit, as in a private window: download the session to keep it";

/// The application on a page.
pub struct Page {
    app: App,
    files: Arc<PageFiles>,
    /// The fragment of the address that was followed last, or made.
    followed: String,
    /// What was dropped and has been read: where it stands, or why it does not.
    dropped: Receiver<Result<PathBuf, String>>,
    dropping: Sender<Result<PathBuf, String>>,
}

/// What the part of the address behind `?` asks for.
struct Asked {
    theme: Option<Theme>,
    /// Whether the page stands within another one: without anything around what is linked.
    is_embedded: bool,
    is_tested: bool,
}

impl Asked {
    fn of(query: &str) -> Self {
        let query = UrlSearchParams::new_with_str(query).ok();
        let given = |name: &str| query.as_ref().and_then(|query| query.get(name));
        let theme = match given("theme").as_deref() {
            Some("dark") => Some(Theme::Dark),
            Some("light") => Some(Theme::Light),
            _ => None,
        };
        Self {
            theme,
            is_embedded: given("embed").is_some_and(|value| value != "0"),
            is_tested: given("test").is_some(),
        }
    }
}

impl Page {
    /// The application with what the address asks for; `number` as [`crate::start`] has it.
    pub fn new(cc: &eframe::CreationContext<'_>, number: u32) -> Self {
        let location = &cc.integration_info.web_info.location;
        let asked = Asked::of(&location.query);
        if let Some(render_state) = &cc.wgpu_render_state {
            headless::draw_with(render_state);
        }
        let mut app = App::new(cc, Session::default(), None, Some(platform::seconds));
        let files = Arc::new(PageFiles::new(number));
        // Within another page nothing is kept: what is there is the page's own.
        let keeps = !asked.is_embedded && is_kept();
        let store = Store::new(Arc::clone(&files) as _, keeps.then(|| KEPT.into()));
        let dialogs = Box::new(PageDialogs::new(Arc::clone(&files)));
        app.work_on(&cc.egui_ctx, store, dialogs, export::MAKER);
        if !keeps && !asked.is_embedded {
            app.tell(KEEPS_NOTHING);
        }
        if let Some(theme) = asked.theme {
            cc.egui_ctx.set_theme(theme::as_drawn(theme));
        }
        app.is_linked_from(Some(format!("{}{}", location.origin, path_of_page())));
        if asked.is_tested {
            Probe::begin(&cc.egui_ctx);
        }
        let (dropping, dropped) = mpsc::channel();
        let mut page = Self {
            app,
            files,
            followed: String::new(),
            dropped,
            dropping,
        };
        page.follow(&location.hash, &cc.egui_ctx);
        if asked.is_embedded {
            page.app.embed();
        }
        page
    }

    /// Goes where the fragment of the address leads, unless it is there.
    fn follow(&mut self, fragment: &str, ctx: &Context) {
        if self.followed == fragment {
            return;
        }
        fragment.clone_into(&mut self.followed);
        if !fragment.is_empty() {
            self.app.open_link(fragment, ctx);
        }
    }

    /// Shows the link that was made in the address, so that the browser steps back to it.
    fn show_link(&mut self) {
        let Some(made) = self.app.take_made_link() else {
            return;
        };
        let location = web_sys::window().map(|window| window.location());
        if let Some(location) = location.filter(|_| made != self.followed) {
            self.followed.clone_from(&made);
            // Where the browser refuses, the link is in the clipboard all the same.
            let _ = location.set_hash(&made);
        }
    }

    /// Reads what is dropped; it is opened once it is there.
    fn read_dropped(&self, ctx: &Context, raw: &mut RawInput) {
        for file in raw.dropped_files.drain(..) {
            let (files, sender, ctx) =
                (Arc::clone(&self.files), self.dropping.clone(), ctx.clone());
            wasm_bindgen_futures::spawn_local(async move {
                let path = opened(&file.path().to_string_lossy());
                let read = file.bytes_async().await;
                let laid = read.and_then(|bytes| {
                    let laid = files.write(&path, &bytes);
                    laid.map_err(|error| error.to_string())
                });
                // Nobody listens where the page is closed meanwhile.
                let _ = sender.send(laid.map(|()| path));
                ctx.request_repaint();
            });
        }
    }
}

/// The path of the page, without what stands behind it.
fn path_of_page() -> String {
    let location = web_sys::window().map(|window| window.location());
    let path = location.and_then(|location| location.pathname().ok());
    path.unwrap_or_default()
}

impl eframe::App for Page {
    fn raw_input_hook(&mut self, ctx: &Context, raw: &mut RawInput) {
        self.read_dropped(ctx, raw);
        self.app.raw_input_hook(ctx, raw);
    }

    fn ui(&mut self, ui: &mut Ui, frame: &mut eframe::Frame) {
        let hash = frame.info().web_info.location.hash.clone();
        if link::fragment_of(&hash).is_some() {
            self.follow(&hash, ui.ctx());
        }
        while let Ok(dropped) = self.dropped.try_recv() {
            match dropped {
                Ok(path) => self.app.open(&path, ui.ctx()),
                Err(problem) => self.app.tell(&problem),
            }
        }
        self.app.ui(ui, frame);
        self.show_link();
    }

    fn on_exit(&mut self) {
        self.app.on_exit();
    }
}

/// Keeps the session when the page is left or covered: nobody says whether it comes back.
///
/// # Errors
/// Where the browser has no window, or takes nobody who listens.
pub fn keep_when_left(runner: &WebRunner) -> Result<(), JsValue> {
    let window = web_sys::window().ok_or(JsValue::NULL)?;
    let runner = runner.clone();
    let keep = Closure::<dyn FnMut()>::new(move || {
        if let Some(mut page) = runner.app_mut::<Page>() {
            eframe::App::on_exit(&mut *page);
        }
    });
    for event in ["pagehide", "blur"] {
        window.add_event_listener_with_callback(event, keep.as_ref().unchecked_ref())?;
    }
    keep.forget();
    Ok(())
}
