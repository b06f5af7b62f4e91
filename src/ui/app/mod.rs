//! The window: panels around the views.

use egui::{CentralPanel, Panel, RichText, ScrollArea, Ui};

use super::data::{Clock, Data};
use super::history::History;
use super::session::{self, Opened, Session};
use super::theme::{self, Palette};
use super::views::{Cursor, VIEWS, ViewContext, ViewSpec, ViewState};
use super::widgets::components::Components;
use super::widgets::materials::MaterialList;
use super::widgets::notice::Notice;
use super::widgets::params::Ties;
use super::widgets::picker::Picker;
use super::widgets::{directions, options, status};
use super::{commands, scene3d};
use crate::error::Result;

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
        let picker = Picker::new(clock.is_none());
        Self {
            history: History::new(&session),
            session,
            data: Data::new(clock),
            state: ViewState::default(),
            cursor: None,
            only,
            picker,
            components: Components::default(),
            list: MaterialList::default(),
            notice: Notice::default(),
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

    fn show_side(&mut self, ui: &mut Ui, palette: &Palette) {
        ui.add_space(4.0);
        let Session {
            materials, locked, ..
        } = &mut self.session;
        let is_adding = &mut self.picker.is_adding;
        let listed = self.list.show(ui, materials, is_adding, palette);
        self.notice.report(listed);
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
                self.components.show(ui, &mut edited.material, &mut ties);
            });
            if edited != before {
                *materials.selected_mut() = edited;
                materials.follow(&before, locked);
            }
            ui.add_space(4.0);
        });
    }

    /// Adds the material that is pasted where no text field takes it.
    fn paste(&mut self, ui: &Ui) {
        if ui.ctx().text_edit_focused() {
            return;
        }
        let pasted = ui.input(|input| {
            let mut events = input.events.iter().rev();
            events.find_map(|event| match event {
                egui::Event::Paste(text) => Some(text.clone()),
                _ => None,
            })
        });
        if let Some(text) = pasted {
            self.take(session::pasted(&text));
        }
    }

    /// Shows what was opened: a session in place of this one, a material beside the others.
    fn take(&mut self, opened: Result<Opened>) {
        let taken = opened.and_then(|opened| match opened {
            Opened::Session(session) => {
                self.session = *session;
                Ok(())
            }
            Opened::Material(material) => self.session.materials.add(*material).map(|_| ()),
        });
        self.notice.report(taken);
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
        commands::run_pressed(self, ui.ctx());
        self.paste(ui);
        Panel::top("top").show(ui, |ui| {
            let mut wished = None;
            options::headline(ui, |ui| {
                for command in [&commands::UNDO, &commands::REDO] {
                    if command.button(ui, self) {
                        wished = Some(command);
                    }
                }
            });
            if let Some(command) = wished {
                command.try_run(self, ui.ctx());
            }
            options::show(ui, &mut self.session);
        });
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
        self.notice.show(ui);
        Panel::left("side")
            .resizable(false)
            .exact_size(theme::SIDE_WIDTH)
            .show(ui, |ui| self.show_side(ui, &palette));
        Panel::bottom("directions").show(ui, |ui| directions::show(ui, &mut self.session));
        let frame = egui::Frame::NONE.fill(palette.background).inner_margin(6.0);
        CentralPanel::no_frame()
            .frame(frame)
            .show(ui, |ui| self.show_views(ui, &palette));
        let dragged = ui.ctx().dragged_id().or(ui.ctx().drag_stopped_id());
        self.history.record(&self.session, dragged);
        if self.cursor != before {
            ui.ctx().request_repaint();
        }
    }
}
