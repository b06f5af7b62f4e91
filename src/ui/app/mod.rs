//! The window: panels around the views.

use std::sync::{Arc, Mutex};

use egui::{Align, CentralPanel, Context, Layout, Panel, RawInput, Rect, RichText, ScrollArea, Ui};

use super::commands::Command;
use super::data::Data;
use super::history::History;
use super::jobs::Clock;
use super::pacing::Pacing;
use super::session::{SHARES, Session};
use super::theme::{self, Palette};
use super::tiles::{ViewTiles, Wish};
use super::views::{Cursor, ViewContext, ViewSpec, ViewState};
use super::widgets::components::Components;
use super::widgets::materials::MaterialList;
use super::widgets::notice::Notice;
use super::widgets::params::Ties;
use super::widgets::picker::Picker;
use super::widgets::said::Said;
use super::widgets::saved::Saved;
use super::widgets::search::{Outcome, Search};
use super::widgets::{badges, directions, help, layouts, options, status};
use super::{commands, scene3d, views};
use crate::analysis::Detail;
use crate::error::Error;
use crate::lab::timing::Stopwatch;
use export::Exports;
use files::Files;
use reading::Readings;

mod asking;
mod export;
mod files;
mod keys;
mod reading;

/// The application.
pub struct App {
    /// What is on the screen.
    pub session: Session,
    /// The states it was in.
    pub(super) history: History,
    data: Data,
    state: ViewState,
    cursor: Option<Cursor>,
    only: Option<&'static ViewSpec>,
    picker: Picker,
    components: Components,
    list: MaterialList,
    notice: Notice,
    said: Said,
    pacing: Pacing,
    saved: Option<Saved>,
    files: Option<Files>,
    readings: Readings,
    exports: Exports,
    exit_problem: Arc<Mutex<Option<Error>>>,
    search: Option<Search>,
    is_help_shown: bool,
    tiles: Option<ViewTiles>,
}

impl App {
    /// The application with `session`, drawn on what `cc` offers.
    ///
    /// `only`: the view to show alone, without panels. `clock` measures updates; pictures have none.
    #[must_use]
    pub fn new(
        cc: &eframe::CreationContext<'_>,
        session: Session,
        only: Option<&'static ViewSpec>,
        clock: Option<Clock>,
    ) -> Self {
        theme::apply(&cc.egui_ctx);
        keys::allow_slow_clicks(&cc.egui_ctx);
        if let Some(render_state) = &cc.wgpu_render_state {
            scene3d::init(render_state);
        }
        // Without a clock nothing is timed: pictures and tests need no frames to wait for.
        let picker = Picker::new(clock.is_none());
        let readings = Readings::new(clock.is_some());
        let ctx = cc.egui_ctx.clone();
        Self {
            history: History::new(&session),
            session,
            data: Data::new(clock, move || ctx.request_repaint()),
            state: ViewState::default(),
            cursor: None,
            only,
            picker,
            components: Components::default(),
            list: MaterialList::default(),
            notice: Notice::default(),
            said: Said::default(),
            pacing: Pacing::default(),
            saved: None,
            files: None,
            readings,
            exports: Exports::default(),
            exit_problem: Arc::default(),
            search: None,
            is_help_shown: false,
            tiles: None,
        }
    }

    /// The application as pictures show it: without what stands over a view for a hand alone.
    #[must_use]
    pub fn for_picture(mut self) -> Self {
        self.state.is_picture = true;
        self
    }

    /// The least detail in which the last frame shows the session; `None` where a part of it is older.
    #[must_use]
    pub fn shown(&self) -> Option<Detail> {
        self.data.shown()
    }

    /// Measures trade-offs with another clock: pictures that are to be the same twice need one that does not run.
    pub fn use_stopwatch(&mut self, stopwatch: &'static dyn Stopwatch) {
        self.data.tradeoff.use_stopwatch(stopwatch);
    }

    /// The picture behind a texture, if it is one of the views'.
    #[must_use]
    pub fn image(&self, id: egui::TextureId) -> Option<std::sync::Arc<egui::ColorImage>> {
        self.state.image(id)
    }

    fn show_view(&mut self, ui: &mut Ui, view: &ViewSpec, palette: &Palette) {
        let mut cx = ViewContext {
            session: &mut self.session,
            data: &mut self.data,
            state: &mut self.state,
            cursor: &mut self.cursor,
            palette,
        };
        ui.push_id(view.id, |ui| {
            views::warn_of_held(ui, &mut cx, view);
            (view.show)(ui, &mut cx);
        });
    }

    fn show_side(&mut self, ui: &mut Ui, palette: &Palette) {
        ui.add_space(4.0);
        self.list_header(ui);
        let Session {
            materials, locked, ..
        } = &mut self.session;
        let listed = self.list.show(ui, materials, &mut self.data, palette);
        let mut wished = self.notice.report(listed).flatten();
        ui.separator();
        let picked = self.picker.show(ui, materials);
        self.notice.report(picked);
        ui.separator();
        let area = ScrollArea::vertical()
            .id_salt("parameters")
            .auto_shrink([false, false]);
        area.show(ui, |ui| {
            // The scroll bar must not lie over the reset buttons.
            ui.set_max_width(ui.available_width() - theme::SCROLL_ROOM);
            let before = materials.selected().clone();
            let mut edited = before.clone();
            let mut ties = Ties {
                has_linked_widths: &mut edited.has_linked_widths,
                locked,
                is_shared: &|spec| materials.is_shared(spec),
            };
            ui.push_id(before.id(), |ui| {
                let title = materials.title(&before);
                let material = &mut edited.material;
                let clicked = badges::show(ui, &title, &before, material, &mut self.data, palette);
                wished = clicked.or(wished.take());
                self.components.show(ui, material, &mut ties);
            });
            if edited != before {
                *materials.selected_mut() = edited;
                materials.follow(&before, locked);
            }
            ui.add_space(4.0);
        });
        if let Some(witness) = wished {
            let selected = self.session.materials.selected().id();
            self.cursor = Cursor::jump(&mut self.session, selected, &witness).or(self.cursor);
        }
    }

    /// The heading of the list, with the commands that add to it.
    fn list_header(&mut self, ui: &mut Ui) {
        let mut wished = None;
        ui.horizontal(|ui| {
            ui.label(RichText::new("Your materials").strong());
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                for command in [&commands::PASTE, &commands::ADD] {
                    if command.button(ui, self) {
                        wished = Some(command);
                    }
                }
            });
        });
        self.run(wished, ui.ctx());
    }

    /// The bar at the top: the menu of files, undo and redo, and how values are drawn.
    fn show_top(&mut self, ui: &mut Ui) {
        let mut wished = None;
        options::headline(ui, |ui| {
            wished = self.file_menu(ui);
            layouts::menu(ui, &mut self.session);
            for command in [&commands::UNDO, &commands::REDO, &commands::HELP] {
                if command.button(ui, self) {
                    wished = Some(command);
                }
            }
        });
        self.run(wished, ui.ctx());
        options::show(ui, &mut self.session);
    }

    fn run(&mut self, wished: Option<&'static Command>, ctx: &Context) {
        if let Some(command) = wished {
            command.try_run(self, ctx);
        }
    }

    /// Begins anew, with all there is to choose from.
    pub fn start_anew(&mut self) {
        self.session = Session::default();
        self.picker.clear_search();
    }

    /// Replaces the session and forgets what was done before: there is nothing to undo.
    fn restart(&mut self, session: Session) {
        self.history = History::new(&session);
        self.session = session;
    }

    /// Lets the picker add the next choice, or not any more.
    pub fn start_adding(&mut self, ctx: &Context) {
        self.picker.start_adding(ctx);
    }

    /// Adds another material like the selected one.
    pub fn duplicate(&mut self) {
        let id = self.session.materials.selected().id();
        let added = self.session.materials.duplicate(id);
        self.notice.report(added);
    }

    /// Copies the session as text.
    pub fn copy_session(&mut self, ctx: &Context) {
        let text = self.session.to_toml();
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

    /// The windows above all else: the help, the search of the commands, and what a key did, over the `views`.
    fn show_windows(&mut self, ctx: &Context, views: Rect) {
        self.show_path_field(ctx);
        if self.is_help_shown {
            self.is_help_shown = help::show(ctx);
        }
        if let Some(mut search) = self.search.take() {
            match search.show(ctx, self) {
                Outcome::Open => self.search = Some(search),
                Outcome::Closed => {}
                Outcome::Chosen(command) => command.run_and_say(self, ctx),
            }
        }
        self.said.show(ctx, views);
    }

    fn show_views(&mut self, ui: &mut Ui, palette: &Palette) {
        let mut layout = self.session.layout.clone();
        let mut tiles = self.tiles.take().unwrap_or_default();
        let wished = tiles.show(ui, &mut layout, &mut |ui, view| {
            self.show_view(ui, view, palette);
        });
        self.tiles = Some(tiles);
        self.session.layout = layout;
        let asked = self.state.take_wished_file();
        match wished.or_else(|| asked.map(|(view, format)| (view, Wish::Export(format)))) {
            Some((view, Wish::Export(format))) => self.ask_export(view, format),
            Some((view, Wish::CopyPicture)) => self.copy_picture(view, ui.ctx()),
            None => {}
        }
    }
}

impl eframe::App for App {
    fn raw_input_hook(&mut self, _ctx: &Context, raw_input: &mut RawInput) {
        self.pacing.pace(&mut raw_input.events);
    }

    fn ui(&mut self, ui: &mut Ui, _frame: &mut eframe::Frame) {
        self.pacing.take();
        if self.pacing.is_waiting() {
            ui.ctx().request_repaint();
        }
        let palette = Palette::of(ui.ctx().theme());
        let is_small = ui.available_size().min(theme::USABLE_SIZE) != theme::USABLE_SIZE;
        if is_small && self.only.is_none() {
            CentralPanel::default().show(ui, |ui| ui.label("Enlarge the window"));
            return;
        }
        self.session.keep_allowed(self.history.present());
        self.data.begin_frame(&self.session);
        self.state.begin_frame();
        let before = self.cursor;
        if let Some(view) = self.only {
            let frame = egui::Frame::NONE
                .fill(palette.background)
                .inner_margin(theme::TILE_MARGIN);
            CentralPanel::no_frame()
                .frame(frame)
                .show(ui, |ui| self.show_view(ui, view, &palette));
            return;
        }
        commands::run_pressed(self, ui.ctx());
        self.take_what_comes(ui.ctx());
        Panel::top("top").show(ui, |ui| self.show_top(ui));
        Panel::bottom("status").show(ui, |ui| {
            let selected = self.session.materials.selected();
            let shares = self.data.ask(&self.session, selected, SHARES);
            // Panels are drawn before the views: the line shows the pointer of the frame before.
            let value = before.map(|cursor| cursor.value(&self.session, &mut self.data));
            status::show(
                ui,
                &self.session,
                before.as_ref().zip(value),
                &shares,
                self.data.progress(),
                &palette,
            );
        });
        self.notice.show(ui);
        self.show_reading(ui);
        if self.saved.as_mut().is_some_and(|saved| !saved.show(ui)) {
            self.saved = None;
        }
        Panel::left("side")
            .resizable(false)
            .exact_size(theme::SIDE_WIDTH)
            .show(ui, |ui| self.show_side(ui, &palette));
        Panel::bottom("directions").show(ui, |ui| directions::show(ui, &mut self.session));
        let frame = egui::Frame::NONE.fill(palette.background).inner_margin(6.0);
        let views = CentralPanel::no_frame()
            .frame(frame)
            .show(ui, |ui| self.show_views(ui, &palette));
        self.show_windows(ui.ctx(), views.response.rect);
        self.session.keep_allowed(self.history.present());
        self.refuse_what_does_not_fit();
        self.history
            .record(&self.session, keys::control_at_work(ui.ctx()));
        self.keep(ui.ctx());
        // Panels are drawn before the views: what was said since is shown by the next frame.
        if self.cursor != before || self.notice.is_new() {
            ui.ctx().request_repaint();
        }
    }

    fn on_exit(&mut self) {
        self.keep_now();
    }
}
