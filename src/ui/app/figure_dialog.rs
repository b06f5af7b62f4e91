//! Choosing a figure: the window, its preview, and what is kept of the choice.

use std::sync::mpsc::TryRecvError;
use std::time::Duration;

use egui::{Context, TextureOptions, Vec2};

use super::App;
use super::exports::{Dialog, Wanted};
use crate::theme;
use crate::views::heading;
use crate::widgets::figure_dialog::{self, Outcome, Preview};
use bxdf_study::session::ViewId;

/// How often a preview that is being drawn is looked for, in seconds.
const POLL: f64 = 0.05;

impl App {
    /// Lets a person choose a figure of a view.
    pub fn choose_figure(&mut self, view: ViewId) {
        if self.has_files() {
            self.exports.dialog = Some(Dialog {
                view,
                title: String::new(),
                shown: None,
                drawing: None,
            });
        }
    }

    /// Whether a figure is being chosen.
    #[must_use]
    pub fn is_choosing_figure(&self) -> bool {
        self.exports.dialog.is_some()
    }

    /// The window in which a figure is chosen, while it is.
    pub(crate) fn show_figure_dialog(&mut self, ctx: &Context) {
        let Some(mut dialog) = self.exports.dialog.take() else {
            return;
        };
        let Some(options) = self.session.views.get(dialog.view) else {
            return;
        };
        let automatic = heading::words(options, &options.caption(&self.session));
        let name = self.session.views.title(dialog.view);
        self.preview(&mut dialog, ctx);
        let shown = dialog.shown.as_ref().map(|(_, shown)| shown);
        let preview = Preview {
            picture: shown.and_then(|shown| shown.as_ref().ok()),
            problem: shown.and_then(|shown| shown.as_ref().err().map(String::as_str)),
            is_awaited: dialog.drawing.is_some(),
        };
        let outcome = figure_dialog::show(
            ctx,
            &mut self.exports.choice,
            &mut dialog.title,
            (&name, &automatic),
            &preview,
        );
        let title = self.title_of(&dialog.title);
        match outcome {
            Outcome::Open => self.exports.dialog = Some(dialog),
            Outcome::Closed => {}
            Outcome::File(format) => self.ask_export(dialog.view, format, title),
            Outcome::Copy => self.copy_figure(dialog.view, title, ctx),
        }
    }

    /// Takes the preview that is drawn, and lets the one be drawn that is wanted, one at a time.
    fn preview(&mut self, dialog: &mut Dialog, ctx: &Context) {
        if let Some((wanted, answer)) = dialog.drawing.take() {
            match answer.try_recv() {
                Ok(drawn) => {
                    let load = |image| ctx.load_texture("preview", image, TextureOptions::LINEAR);
                    let drawn = drawn.map(load).map_err(|error| error.to_string());
                    dialog.shown = Some((wanted, drawn));
                }
                Err(TryRecvError::Empty) => {
                    dialog.drawing = Some((wanted, answer));
                    ctx.request_repaint_after(Duration::from_secs_f64(POLL));
                    return;
                }
                Err(TryRecvError::Disconnected) => {
                    let problem = "The preview could not be drawn".to_owned();
                    dialog.shown = Some((wanted, Err(problem)));
                }
            }
        }
        let wanted = Wanted {
            session: self.session.clone(),
            choice: self.exports.choice,
            title: dialog.title.clone(),
        };
        let is_shown = dialog.shown.as_ref().is_some_and(|(of, _)| *of == wanted);
        let Some(maker) = self.maker().filter(|_| !is_shown) else {
            return;
        };
        let title = self.title_of(&dialog.title);
        let mut picture = self.picture_of(dialog.view, title, ctx);
        // As large as it is shown.
        let [width, height] = picture.size.map(|points| points as f32);
        let fits = (theme::PREVIEW / Vec2::new(width, height)).min_elem();
        picture.scale = (fits * ctx.pixels_per_point()).min(picture.scale);
        let wake = ctx.clone();
        let draw = move || (maker.image)(picture);
        let answer = self.pool.complete(draw, move || wake.request_repaint());
        dialog.drawing = Some((wanted, answer));
        ctx.request_repaint();
    }
}
