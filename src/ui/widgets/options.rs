//! The bar at the top: what to try first, and how values are drawn in all views.

use egui::{RichText, ThemePreference, Ui};

use crate::theme;
use crate::widgets::number::Number;
use bxdf_study::session::{Curves, LobeSurface, SECTION_PHI, Session};

/// The line that says what to try first.
const FIRST_STEP: &str = "Try this: drag the round handle, pick another model";

/// How a lobe may be drawn: the name and what it is good for.
const SURFACES: [(LobeSurface, &str, &str); 4] = [
    (
        LobeSurface::Automatic,
        "Automatic",
        "One lobe as a solid, several as translucent shells",
    ),
    (
        LobeSurface::Solid,
        "Solid",
        "Lobes as solids that hide what is behind them",
    ),
    (
        LobeSurface::Wire,
        "Wire",
        "Lobes as wireframes: shows where the mesh is fine, and lobes inside one another",
    ),
    (
        LobeSurface::Translucent,
        "Translucent",
        "Lobes as translucent shells: shows lobes inside one another",
    ),
];

/// The first line of the bar: the name, what `commands` adds, what to try first, and the theme.
pub fn headline(ui: &mut Ui, commands: impl FnOnce(&mut Ui)) {
    ui.horizontal(|ui| {
        ui.label(RichText::new("BRDF Explorer").heading());
        commands(ui);
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            theme_choice(ui);
            ui.with_layout(egui::Layout::left_to_right(egui::Align::Center), |ui| {
                ui.add(egui::Label::new(RichText::new(FIRST_STEP).weak()).truncate());
            });
        });
    });
}

/// How values are drawn.
pub fn show(ui: &mut Ui, session: &mut Session) {
    ui.horizontal_wrapped(|ui| {
        ui.label("Radius");
        let mut is_logarithmic = session.scale.is_logarithmic();
        ui.selectable_value(&mut is_logarithmic, false, "Linear")
            .on_hover_text("Lengths proportional to f");
        ui.selectable_value(&mut is_logarithmic, true, "Logarithmic")
            .on_hover_text("Lengths in decades below the peak: shows the tails of a narrow lobe");
        if is_logarithmic != session.scale.is_logarithmic() {
            session.set_logarithmic(is_logarithmic);
        }
        ui.checkbox(&mut session.with_cosine, "Times cos θ")
            .on_hover_text(
                "Show f |cos θ| of the free direction: the flux, rather than the radiance",
            );
        ui.separator();
        ui.label("Curves");
        curves(ui, session);
        ui.separator();
        ui.label("Section");
        section(ui, session);
        ui.separator();
        ui.label("Lobe");
        lobe_surface(ui, session);
    });
}

/// How the lobes are drawn.
fn lobe_surface(ui: &mut Ui, session: &mut Session) {
    let chosen = SURFACES
        .iter()
        .find(|(surface, ..)| *surface == session.lobe_surface);
    let combo = egui::ComboBox::from_id_salt("lobe surface")
        .selected_text(chosen.map_or("", |(_, name, _)| name))
        .width(theme::SHORT_COMBO_WIDTH)
        .show_ui(ui, |ui| {
            for (surface, name, hint) in SURFACES {
                ui.selectable_value(&mut session.lobe_surface, surface, name)
                    .on_hover_text(hint);
            }
        });
    let response = combo.response.on_hover_text("How the 3D view draws lobes");
    ui.ctx()
        .accesskit_node_builder(response.id, |node| node.set_label("Surface of lobes"));
}

/// The curves of the polar plot; several materials have one each.
fn curves(ui: &mut Ui, session: &mut Session) {
    if session.materials.is_overlay() {
        let mut is_luminance = true;
        ui.toggle_value(&mut is_luminance, "Luminance")
            .on_hover_text("One curve of the luminance for each material");
        ui.add_enabled(false, egui::Button::selectable(false, "R, G, B"))
            .on_disabled_hover_text(
                "Drawn where one material is shown: show it alone, or hide the others",
            );
        return;
    }
    ui.selectable_value(&mut session.curves, Curves::Luminance, "Luminance")
        .on_hover_text("One curve of the luminance");
    ui.selectable_value(&mut session.curves, Curves::Rgb, "R, G, B")
        .on_hover_text("Three curves, one for each channel");
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
        (true, None) => session.section_phi_deg = Some(session.section().azimuth_deg),
        (false, Some(_)) => session.section_phi_deg = None,
        _ => {}
    }
    if let Some(phi) = &mut session.section_phi_deg {
        let number = Number::new("Section azimuth", SECTION_PHI);
        let shown = number.speed(1.0).field(ui, phi);
        shown
            .on_hover_text("Azimuth of the section from s")
            .explain(ui);
    }
}
