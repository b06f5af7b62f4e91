//! The window around the views: its panels and menus, and what happens in a frame.

use egui::{CentralPanel, Context, Panel, RawInput, Rect, Ui, UiBuilder};

use super::app::left::Left;
use super::app::{App, Heading};
use super::commands::{self, Command, help, search};
use super::theme::{self, Palette};
use super::tiles::Wish;
use super::views::{self, ViewContext, heading};
use super::widgets::bottom::{Bar, presented};
use super::widgets::search::Outcome;
use super::widgets::shares::Energy;
use super::widgets::{covered, focus, menus, spotlight, still};
use bxdf_study::cursor::Cursor;
use bxdf_study::lessons::Cover;
use bxdf_study::session::{SHARES, ViewId};
use bxdf_study::views::Options;

mod top;

impl App {
    fn show_view(&mut self, ui: &mut Ui, view: ViewId, palette: &Palette) {
        let is_pressed = ui.input(|input| input.pointer.any_pressed());
        if is_pressed && ui.rect_contains_pointer(ui.max_rect()) {
            self.clicked = Some(view);
        }
        self.note_size(view, ui.max_rect().size());
        let mark = self.mark(ui.ctx());
        let factor = 0.01 * f32::from(self.labels.percent());
        self.with_view(view, palette, mark, |cx, options| {
            ui.push_id((options.kind().id, view), |ui| {
                theme::enlarge_labels(ui.style_mut(), factor);
                views::show(ui, cx, options);
            });
        });
        self.mark_view(ui, view, palette);
    }

    /// Hands out what a view draws with, and its options. `mark`: the direction marked in it.
    fn with_view(
        &mut self,
        view: ViewId,
        palette: &Palette,
        mark: Option<(Cursor, f32)>,
        draw: impl FnOnce(&mut ViewContext<'_>, &mut Options),
    ) {
        // Its options are taken out of the session meanwhile: views change that too.
        let Some(mut options) = self.session.views.get(view).cloned() else {
            return;
        };
        self.answers.asked_by(Some(view));
        let mut cx = ViewContext {
            view,
            session: &mut self.session,
            options: &mut (),
            answers: &mut self.answers,
            state: &mut self.state,
            cursor: self.cursor,
            mark,
            pointed: &mut self.pointed,
            palette,
        };
        draw(&mut cx, &mut options);
        self.answers.asked_by(None);
        if let Some(own) = self.session.views.get_mut(view)
            && *own != options
        {
            *own = options;
        }
    }

    /// The view alone, in the whole window; of a figure with its title.
    fn show_alone(&mut self, ui: &mut Ui, view: ViewId, palette: &Palette) {
        let margin = if self.state.is_figure() {
            theme::FIGURE_MARGIN
        } else {
            theme::TILE_MARGIN
        };
        let frame = egui::Frame::NONE
            .fill(palette.background)
            .inner_margin(margin);
        CentralPanel::no_frame().frame(frame).show(ui, |ui| {
            if self.state.is_picture {
                still::make(ui);
            }
            let figure = palette.of_figure();
            let mut palette = palette;
            if self.state.is_figure() {
                palette = &figure;
                ui.visuals_mut().weak_text_color = Some(palette.faint_ink);
            }
            let mut room = ui.available_rect_before_wrap();
            room = room.shrink2(egui::vec2(0.0, self.free));
            if let Some(Heading { own, beside }) = self.heading.take() {
                let mut place = room;
                if let Some(width) = beside {
                    place.set_width(width);
                }
                let mut above = ui.new_child(UiBuilder::new().max_rect(place).id_salt("title"));
                self.with_view(view, palette, None, |cx, options| {
                    heading::show(&mut above, cx, options, own.as_deref());
                });
                match beside {
                    Some(width) => room.min.x += width + theme::FIGURE_GAP,
                    None => room.min.y = above.min_rect().bottom() + theme::FIGURE_GAP,
                }
                self.heading = Some(Heading { own, beside });
            }
            self.room_of_views = room;
            let mut ui = ui.new_child(UiBuilder::new().max_rect(room).id_salt("view"));
            ui.set_clip_rect(room.expand(margin).intersect(ui.clip_rect()));
            self.show_view(&mut ui, view, palette);
            let beyond = ui.min_rect().bottom() - room.bottom();
            self.lacking = beyond.max(self.state.lacking);
        });
        self.keep_scenes(ui);
    }

    /// Runs what a button asks for.
    pub(super) fn run(&mut self, wished: Option<&'static Command>, ctx: &Context) {
        if let Some(command) = wished {
            command.try_run(self, ctx);
        }
    }

    /// The windows above all else: the help, the search of the commands, and what a key did, over the `views`.
    fn show_windows(&mut self, ctx: &Context, views: Rect) {
        self.show_figure_dialog(ctx);
        self.show_path_field(ctx);
        self.show_page_field(ctx);
        if self.is_help_shown {
            self.is_help_shown = help::show(ctx);
        }
        if let Some(mut search) = self.search.take() {
            match search::show(&mut search, ctx, self) {
                Outcome::Open => self.search = Some(search),
                Outcome::Closed => {}
                Outcome::Chosen(hit) => hit.run(self, ctx),
            }
        }
        if !self.is_presenting() && !self.is_learning() {
            self.show_first_steps(ctx, views);
        }
        self.said.show(ctx, views);
        menus::shield(ctx);
        focus::around(ctx);
    }

    /// What the views mark, and how strongly, 0 to 1: what is pointed at, and for a moment what was.
    fn mark(&self, ctx: &Context) -> Option<(Cursor, f32)> {
        let pointed = self.cursor.map(|cursor| (cursor, 1.0));
        let now = ctx.input(|input| input.time);
        pointed.or_else(|| self.left.map(|left| left.mark(now)))
    }

    /// Takes what the views of this frame say is pointed at, which the next one shows; `before`: what this one has shown.
    fn point(&mut self, ctx: &Context, before: Option<Cursor>) {
        self.cursor = self.pointed.take();
        let now = ctx.input(|input| input.time);
        let left = Left::next(self.left, (self.cursor, before), now);
        self.left = left.filter(|_| !theme::has_reduced_motion(ctx));
        if self.cursor != before || self.left.is_some() {
            ctx.request_repaint();
        }
    }

    /// The bar at the bottom. `before`: where the pointer was in the frame before.
    fn show_bar(&mut self, ui: &mut Ui, before: Option<Cursor>, palette: &Palette) {
        let margin = egui::Margin::symmetric(8, 0);
        Panel::bottom("bar")
            .exact_size(Bar::height(ui))
            .frame(egui::Frame::side_top_panel(ui.style()).inner_margin(margin))
            .show(ui, |ui| {
                if self.is_presenting() {
                    let edited = presented::show(ui, &mut self.session);
                    self.take_edited(edited);
                    return;
                }
                let selected = self.session.materials.selected();
                let energy = if covered::is_covered(ui.ctx(), Cover::Shares) {
                    Energy::covered(palette)
                } else {
                    let shares = self.answers.ask(&self.session, selected, SHARES);
                    Energy::of(self.session.held(), shares.as_deref(), palette)
                };
                // Panels are drawn before the views: the line shows the pointer of the frame before.
                let read = before.unwrap_or_else(|| Cursor::at_other(&self.session));
                let value = read.value(&self.session, &mut self.answers);
                let bar = Bar {
                    cursor: Some((&read, value)),
                    energy,
                    progress: self.answers.progress(),
                };
                bar.show(ui, &mut self.session);
            });
    }

    fn show_views(&mut self, ui: &mut Ui, palette: &Palette) {
        let views = self.session.views.clone();
        let mut tiles = self.tiles.take().unwrap_or_default();
        let is_small = self.is_small();
        let shown = tiles.show(ui, &views, is_small, &mut |ui, view| {
            self.show_view(ui, view, palette);
        });
        if is_small {
            // What is done by keys is done to the one that is seen.
            self.clicked = tiles.seen();
        }
        self.tiles = Some(tiles);
        if let Some(layout) = shown.layout {
            self.session.views.arrange(&layout);
        }
        let asked = self.state.take_wished_file();
        let asked = asked.map(|(view, format)| (view, Wish::Export(format)));
        match shown.wished.or(asked) {
            Some((view, Wish::Export(format))) => self.ask_export_of(view, format),
            Some((view, Wish::Figure)) => self.choose_figure(view),
            Some((view, Wish::CopyPicture)) => self.copy_picture(view, ui.ctx()),
            Some((view, Wish::Duplicate)) => self.duplicate_view(view),
            Some((view, Wish::OwnSection)) => self.switch_own_section(view),
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
        let size = ui.available_size();
        if size.min(theme::USABLE_SIZE) != theme::USABLE_SIZE && self.only.is_none() {
            CentralPanel::default().show(ui, |ui| ui.label("Enlarge the window"));
            return;
        }
        self.fit_to(size, ui.ctx());
        self.session.keep_allowed(self.history.present());
        self.answers.begin_frame(&self.session);
        self.state.begin_frame(&self.session);
        let before = self.cursor;
        if let Some(view) = self.only {
            self.show_alone(ui, view, &palette);
            self.point(ui.ctx(), before);
            return;
        }
        commands::run_pressed(self, ui.ctx());
        self.take_what_comes(ui.ctx());
        self.fetch_data(ui.ctx());
        self.present(ui.ctx());
        covered::cover(ui.ctx(), self.covers());
        if !self.is_presenting() {
            Panel::top("top").show(ui, |ui| self.show_top(ui));
        }
        self.show_bar(ui, before, &palette);
        self.notice.show(ui);
        self.show_reading(ui);
        let saved = self.saved.as_mut();
        if saved.is_some_and(|saved| !saved.show(ui, &self.pool)) {
            self.saved = None;
        }
        if !self.is_presenting() && !self.is_small() {
            self.show_side(ui, &palette);
        }
        let beside_bars = ui.available_rect_before_wrap();
        self.show_lessons(ui, &palette);
        let frame = egui::Frame::NONE.fill(palette.background).inner_margin(6.0);
        let views = CentralPanel::no_frame()
            .frame(frame)
            .show(ui, |ui| self.show_views(ui, &palette));
        self.room_of_views = views.response.rect;
        self.show_drawer(ui.ctx(), beside_bars, &palette);
        self.show_picker(ui.ctx(), views.response.rect);
        self.show_windows(ui.ctx(), views.response.rect);
        spotlight::show(ui.ctx(), &palette);
        self.session.keep_allowed(self.history.present());
        self.refuse_what_does_not_fit();
        self.record(ui.ctx());
        self.keep(ui.ctx());
        self.point(ui.ctx(), before);
        // Panels are drawn before the views: what was said since is shown by the next frame.
        if self.notice.is_new() {
            ui.ctx().request_repaint();
        }
    }

    fn on_exit(&mut self) {
        self.keep_now();
    }
}
