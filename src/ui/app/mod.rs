//! The application: what the window works on, and what can be done to it.

use std::collections::VecDeque;
use std::sync::mpsc::Receiver;
use std::sync::{Arc, Mutex};

use egui::{Context, Pos2, Rect};

use super::pacing::Pacing;
use super::scene3d;
use super::theme::{self};
use super::tiles::ViewTiles;
use super::views::ViewState;
use super::widgets::components::Components;
use super::widgets::first_steps::FirstSteps;
use super::widgets::materials::MaterialList;
use super::widgets::notice::Notice;
use super::widgets::picker::Picker;
use super::widgets::said::Said;
use super::widgets::saved::Saved;
use super::widgets::search::Search;
use bxdf::Resource;
use bxdf::error::Error;
use bxdf::resource::Content;
use bxdf_lab::analysis::Detail;
use bxdf_lab::timing::Stopwatch;
use bxdf_study::answers::Answers;
use bxdf_study::cursor::Cursor;
use bxdf_study::history::{Control, History};
use bxdf_study::jobs::Clock;
use bxdf_study::parallel::Pool;
use bxdf_study::session::{Session, ViewId};
use bxdf_study::store::{LabelSize, Side};
use exports::Exports;
pub(super) use figure::Heading;
use files::Files;
use learning::Learning;
use left::Left;
use linking::Links;
use looking::Looking;
use readings::Reading;
pub(super) use side::Drawer;

mod asking;
mod export;
mod exports;
mod fetching;
mod figure;
mod figure_dialog;
mod files;
mod filing;
mod first_steps;
mod keys;
mod learning;
pub(super) mod left;
mod lessons;
mod linking;
mod links;
mod looking;
mod params;
mod picture;
mod presenting;
mod reading;
mod readings;
mod side;
mod views;

pub use picture::{Figure, InMaking, Maker, OnScreen, Picture, PutPicture, Title};

/// The application.
pub struct App {
    /// What is on the screen.
    pub session: Session,
    /// The states it was in.
    pub(super) history: History,
    /// The move of the camera that was made last.
    looking: Looking,
    /// The threads of the window beside the one that draws.
    pub(super) pool: Pool,
    pub(super) answers: Answers,
    pub(super) state: ViewState,
    pub(super) cursor: Option<Cursor>,
    /// What the views of this frame say of it.
    pub(super) pointed: Option<Cursor>,
    /// What was pointed at until a moment ago.
    pub(super) left: Option<Left>,
    pub(super) only: Option<ViewId>,
    /// The title above that view, where the picture of it has one.
    pub(super) heading: Option<Heading>,
    /// Whether only what the graphics processor draws is painted.
    pub(super) has_scenes_alone: bool,
    /// The view last clicked into.
    pub(super) clicked: Option<ViewId>,
    pub(super) picker: Picker,
    pub(super) components: Components,
    pub(super) list: MaterialList,
    /// What of the panel at the side is folded away.
    pub(super) side: Side,
    /// Whether that panel lies over the view.
    pub(super) drawer: Drawer,
    /// How large the labels of plots are.
    pub(super) labels: LabelSize,
    pub(super) notice: Notice,
    pub(super) said: Said,
    pub(super) pacing: Pacing,
    pub(super) saved: Option<Saved>,
    pub(super) files: Option<Files>,
    /// What is being read, in the order in which it came.
    pub(super) readings: VecDeque<Reading>,
    pub(super) exports: Exports,
    put_picture: PutPicture,
    /// The data that is being looked for.
    pub(super) fetches: Vec<(Resource, Receiver<Content>)>,
    pub(super) exit_problem: Arc<Mutex<Option<Error>>>,
    pub(super) search: Option<Search>,
    pub(super) is_help_shown: bool,
    pub(super) tiles: Option<ViewTiles>,
    pub(super) first_steps: Option<FirstSteps>,
    /// The lessons.
    pub(super) learning: Learning,
    /// Links.
    links: Links,
    /// While the views are presented: how much the window was enlarged before.
    pub(super) zoom_before: Option<f32>,
    /// The parameter that was changed last, by its name.
    pub(super) last_changed: Option<&'static str>,
    /// The room that views had in the last frame.
    pub(super) room_of_views: Rect,
    /// By how much that of the one view of a picture was too low, in points.
    pub(super) lacking: f32,
    /// What is left free above and below the one view of a figure, in points.
    pub(super) free: f32,
}

impl App {
    /// The application with `session`, drawn on what `cc` offers.
    ///
    /// `only`: the view to show alone, without panels. `clock` measures updates; pictures have none.
    #[must_use]
    pub fn new(
        cc: &eframe::CreationContext<'_>,
        session: Session,
        only: Option<ViewId>,
        clock: Option<Clock>,
    ) -> Self {
        theme::apply(&cc.egui_ctx);
        keys::allow_slow_clicks(&cc.egui_ctx);
        if let Some(render_state) = &cc.wgpu_render_state {
            scene3d::init(render_state);
        }
        // Without a clock nothing is timed: pictures and tests need no frames to wait for.
        let pool = clock.map_or_else(Pool::at_once, |_| Pool::new());
        let ctx = cc.egui_ctx.clone();
        Self {
            history: History::new(&session),
            looking: Looking::default(),
            session,
            answers: Answers::new(clock, pool.clone(), move || ctx.request_repaint()),
            pool,
            state: ViewState::by(clock),
            cursor: None,
            pointed: None,
            left: None,
            only,
            heading: None,
            has_scenes_alone: false,
            clicked: None,
            picker: Picker::default(),
            components: Components::default(),
            list: MaterialList::default(),
            side: Side::default(),
            drawer: Drawer::default(),
            labels: LabelSize::default(),
            last_changed: None,
            notice: Notice::default(),
            said: Said::default(),
            pacing: Pacing::default(),
            saved: None,
            files: None,
            readings: VecDeque::new(),
            exports: Exports::default(),
            put_picture: Box::new(|ctx, picture| {
                ctx.copy_image(picture);
                Ok(())
            }),
            fetches: Vec::new(),
            exit_problem: Arc::default(),
            search: None,
            is_help_shown: false,
            tiles: None,
            first_steps: None,
            learning: Learning::default(),
            links: Links::default(),
            zoom_before: None,
            lacking: 0.0,
            free: 0.0,
            room_of_views: Rect::from_min_size(Pos2::ZERO, theme::WINDOW_SIZE),
        }
    }

    /// The application as pictures show it: without what stands over a view for a hand alone.
    #[must_use]
    pub fn for_picture(mut self, figure: Option<&Figure>) -> Self {
        self.state.is_picture = true;
        self.heading = figure.and_then(Heading::of);
        self.state.has_title = figure.map(|_| self.heading.is_some());
        self
    }

    /// The least detail in which the last frame shows the session; `None` where a part of it is older.
    #[must_use]
    pub fn shown(&self) -> Option<Detail> {
        self.answers.shown()
    }

    /// Measures trade-offs with another clock: pictures that are to be the same twice need one that does not run.
    pub fn use_stopwatch(&mut self, stopwatch: Stopwatch) {
        self.state.stopwatch = stopwatch;
    }

    /// Puts pictures into this clipboard from here on: egui's does not say whether it takes them.
    pub fn use_clipboard(&mut self, put_picture: PutPicture) {
        self.put_picture = put_picture;
    }

    /// The threads of the window beside the one that draws.
    #[must_use]
    pub fn pool(&self) -> Pool {
        self.pool.clone()
    }

    /// The picture behind a texture, if it is one of the views'.
    #[must_use]
    pub fn image(&self, id: egui::TextureId) -> Option<std::sync::Arc<egui::ColorImage>> {
        self.state.image(id)
    }

    /// Begins anew.
    pub fn start_anew(&mut self, ctx: &Context) {
        self.replace(Session::default());
        self.picker.close(ctx);
    }

    /// Replaces the session and forgets what was done before: there is nothing to undo.
    pub(super) fn restart(&mut self, session: Session) {
        self.history = History::new(&session);
        self.session = session;
    }

    /// Takes note of what this frame has made of the session.
    pub(super) fn record(&mut self, ctx: &Context) {
        let is_looking = self.session.camera != self.history.present().camera;
        let control = if is_looking {
            Some(self.looking.control(ctx))
        } else {
            keys::control_at_work(ctx).map(|id| Control(id.value()))
        };
        self.history.record(&self.session, control);
    }

    /// Adds another material like the selected one.
    pub fn duplicate(&mut self) {
        let id = self.session.materials.selected().id();
        let added = self.session.materials.duplicate(id);
        self.notice.report(added);
    }

    /// Copies the session as text, with all data in it.
    pub fn copy_session(&mut self, ctx: &Context) {
        let whole = self.session.with_data();
        let text = whole.and_then(|whole| whole.to_toml());
        if let Some(text) = self.notice.report(text) {
            ctx.copy_text(text);
        }
    }

    /// Shows the search of the commands.
    pub fn start_search(&mut self, ctx: &Context) {
        self.search = Some(Search::begin(ctx));
    }

    /// Whether it is shown what keys and the mouse do.
    #[must_use]
    pub fn is_help_shown(&self) -> bool {
        self.is_help_shown
    }

    /// Shows what keys and the mouse do, or no longer.
    pub fn show_help(&mut self) {
        self.is_help_shown ^= true;
    }

    /// Whether what is typed next goes to a text, which has the focus or is about to have it.
    #[must_use]
    pub fn is_typed_in(&self, ctx: &Context) -> bool {
        ctx.text_edit_focused()
            || self.search.is_some()
            || self.is_asking_page()
            || self.is_choosing_figure()
            || self.files.as_ref().is_some_and(Files::is_asking)
            || self.picker.has_focus(ctx)
    }

    /// Says for a moment what a key did.
    pub fn say(&mut self, text: String, ctx: &Context) {
        self.said.say(text, ctx);
    }
}
