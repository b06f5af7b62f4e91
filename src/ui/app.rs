//! The window: panels around the views.

use egui::{CentralPanel, Panel, RichText, ScrollArea, ThemePreference, Ui};

use super::data::{Clock, Data};
use super::scene3d;
use super::session::{Curves, DECADES, Session};
use super::theme::{self, Palette};
use super::views::{Cursor, VIEWS, ViewContext, ViewSpec, ViewState};
use super::widgets::components::Components;
use super::widgets::picker::Picker;
use super::widgets::{directions, status};
use crate::analysis::RadialScale;

/// The line that says what to try first.
const FIRST_STEP: &str = "Try this: drag the round handle of the light, then pick another kind of reflection on the left";

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
        let picker = Picker::new(&session.material, clock.is_none());
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
        self.picker.show(ui, &mut self.session.material);
        ui.separator();
        ScrollArea::vertical()
            .id_salt("parameters")
            .auto_shrink([false, false])
            .show(ui, |ui| {
                // The scroll bar must not lie over the reset buttons.
                ui.set_max_width(ui.available_width() - theme::SCROLL_ROOM);
                self.components.show(ui, &mut self.session.material);
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
        self.data.begin_frame();
        self.state.begin_frame();
        let before = self.cursor.take();
        if let Some(view) = self.only {
            let frame = egui::Frame::NONE.fill(palette.background);
            CentralPanel::no_frame()
                .frame(frame)
                .show(ui, |ui| self.show_view(ui, view, &palette));
            return;
        }
        Panel::top("top").show(ui, |ui| display_options(ui, &mut self.session));
        Panel::bottom("status").show(ui, |ui| {
            let shares = self.data.shares(&self.session);
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

/// The bar at the top: what to try first, and how values are drawn in all views.
fn display_options(ui: &mut Ui, session: &mut Session) {
    ui.horizontal(|ui| {
        ui.label(RichText::new("BRDF Explorer").heading());
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            theme_choice(ui);
            ui.with_layout(egui::Layout::left_to_right(egui::Align::Center), |ui| {
                ui.add(egui::Label::new(RichText::new(FIRST_STEP).weak()).truncate());
            });
        });
    });
    ui.horizontal_wrapped(|ui| {
        ui.label("Radius");
        let mut is_logarithmic = session.scale.is_logarithmic();
        ui.selectable_value(&mut is_logarithmic, false, "Linear")
            .on_hover_text("Lengths in proportion to f");
        ui.selectable_value(&mut is_logarithmic, true, "Logarithmic")
            .on_hover_text("Lengths by decades below the peak: shows the tails of a narrow lobe");
        if is_logarithmic != session.scale.is_logarithmic() {
            session.scale = if is_logarithmic {
                RadialScale::Logarithmic { decades: DECADES }
            } else {
                RadialScale::Linear
            };
        }
        ui.checkbox(&mut session.with_cosine, "Times cos θ")
            .on_hover_text(
                "Show f |cos θ| of the free direction: the flux, rather than the radiance",
            );
        ui.separator();
        ui.label("Curves");
        ui.selectable_value(&mut session.curves, Curves::Luminance, "Luminance");
        ui.selectable_value(&mut session.curves, Curves::Rgb, "R, G, B");
        ui.separator();
        ui.label("Section");
        section(ui, session);
    });
}

/// Dark, light, or as the system has it.
fn theme_choice(ui: &mut Ui) {
    let mut preference = ui.options(|options| options.theme_preference);
    for (choice, name) in [
        (ThemePreference::System, "System"),
        (ThemePreference::Light, "Light"),
        (ThemePreference::Dark, "Dark"),
    ] {
        let response = ui.selectable_value(&mut preference, choice, name);
        ui.ctx()
            .accesskit_node_builder(response.id, |node| node.set_label(format!("{name} theme")));
    }
    ui.label("Theme");
    ui.ctx().set_theme(preference);
}

fn section(ui: &mut Ui, session: &mut Session) {
    let mut is_free = session.section_phi_deg.is_some();
    ui.selectable_value(&mut is_free, false, "Incidence plane")
        .on_hover_text("The polar plot cuts the lobe along the plane of the held direction and n");
    ui.selectable_value(&mut is_free, true, "Azimuth")
        .on_hover_text("The polar plot cuts the lobe along any azimuth");
    match (is_free, session.section_phi_deg) {
        (true, None) => session.section_phi_deg = Some(session.section_azimuth_deg()),
        (false, Some(_)) => session.section_phi_deg = None,
        _ => {}
    }
    if let Some(phi) = &mut session.section_phi_deg {
        let field = egui::DragValue::new(phi)
            .range(-90.0..=90.0)
            .suffix("°")
            .speed(1.0);
        let response = ui.add(field).on_hover_text("Azimuth of the section from s");
        ui.ctx()
            .accesskit_node_builder(response.id, |node| node.set_label("Section azimuth"));
    }
}
