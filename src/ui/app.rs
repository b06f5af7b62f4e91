//! The window: panels around the views.

use egui::{CentralPanel, Panel, RichText, ScrollArea, Ui};

use super::data::{Clock, Data};
use super::scene3d;
use super::session::Session;
use super::theme::{self, Palette};
use super::views::{Cursor, VIEWS, ViewContext, ViewSpec, ViewState};
use super::widgets::components::Components;
use super::widgets::picker::Picker;
use super::widgets::{directions, options, status};

/// The application.
pub struct App {
    /// What is on the screen.
    pub session: Session,
    data: Data,
    state: ViewState,
    cursor: Option<Cursor>,
    only: Option<&'static ViewSpec>,
    picker: Picker,
    components: Components,
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
        if let Some(render_state) = &cc.wgpu_render_state {
            scene3d::init(render_state);
        }
        // Without a clock nothing is timed: pictures and tests need no frames to wait for.
        let picker = Picker::new(session.material(), clock.is_none());
        Self {
            session,
            data: Data::new(clock),
            state: ViewState::default(),
            cursor: None,
            only,
            picker,
            components: Components::default(),
        }
    }

    fn show_view(&mut self, ui: &mut Ui, view: &ViewSpec, palette: &Palette) {
        let mut cx = ViewContext {
            session: &mut self.session,
            data: &mut self.data,
            state: &mut self.state,
            cursor: &mut self.cursor,
            palette,
        };
        ui.push_id(view.id, |ui| (view.show)(ui, &mut cx));
    }

    fn show_side(&mut self, ui: &mut Ui) {
        ui.add_space(4.0);
        let entry = self.session.materials.selected_mut();
        self.picker.show(ui, entry);
        ui.separator();
        ScrollArea::vertical()
            .id_salt("parameters")
            .auto_shrink([false, false])
            .show(ui, |ui| {
                // The scroll bar must not lie over the reset buttons.
                ui.set_max_width(ui.available_width() - theme::SCROLL_ROOM);
                let entry = self.session.materials.selected_mut();
                self.components.show(ui, &mut entry.material);
                ui.add_space(4.0);
            });
    }

    fn show_views(&mut self, ui: &mut Ui, palette: &Palette) {
        ui.columns(VIEWS.len(), |columns| {
            for (column, view) in columns.iter_mut().zip(&VIEWS) {
                column.label(RichText::new(view.title).strong());
                column.label(RichText::new(view.what_you_see).small().weak());
                self.show_view(column, view, palette);
            }
        });
    }
}

impl eframe::App for App {
    fn ui(&mut self, ui: &mut Ui, _frame: &mut eframe::Frame) {
        let palette = Palette::of(ui.ctx().theme());
        let is_small = ui.available_size().min(theme::USABLE_SIZE) != theme::USABLE_SIZE;
        if is_small && self.only.is_none() {
            CentralPanel::default().show(ui, |ui| ui.label("Enlarge the window"));
            return;
        }
        self.data.begin_frame(&self.session);
        self.state.begin_frame();
        let before = self.cursor.take();
        if let Some(view) = self.only {
            let frame = egui::Frame::NONE.fill(palette.background);
            CentralPanel::no_frame()
                .frame(frame)
                .show(ui, |ui| self.show_view(ui, view, &palette));
            return;
        }
        Panel::top("top").show(ui, |ui| options::show(ui, &mut self.session));
        Panel::bottom("status").show(ui, |ui| {
            let shares = self
                .data
                .shares(&self.session, self.session.materials.selected());
            // Panels are drawn before the views: the line shows the pointer of the frame before.
            status::show(
                ui,
                &self.session,
                before.as_ref(),
                &shares,
                self.data.last_update,
                &palette,
            );
        });
        Panel::left("side")
            .resizable(false)
            .exact_size(theme::SIDE_WIDTH)
            .show(ui, |ui| self.show_side(ui));
        Panel::bottom("directions").show(ui, |ui| directions::show(ui, &mut self.session));
        let frame = egui::Frame::NONE.fill(palette.background).inner_margin(6.0);
        CentralPanel::no_frame()
            .frame(frame)
            .show(ui, |ui| self.show_views(ui, &palette));
        if self.cursor != before {
            ui.ctx().request_repaint();
        }
    }
}
