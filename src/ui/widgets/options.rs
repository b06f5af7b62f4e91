//! The choices of the theme and of the size of labels, and that of the section which views share.

use egui::{ComboBox, Response, ThemePreference, Ui};

use crate::theme;
use crate::widgets::number::Number;
use bxdf_study::session::{SECTION_PHI, Session};
use bxdf_study::store::LabelSize;

/// Dark, light, or as the system has it; how large the labels of plots are; and whether anything moves by itself. The button of the menu
/// shows `text`.
pub fn display_menu(ui: &mut Ui, text: &str, labels: &mut LabelSize) {
    let mut preference = ui.options(|options| options.theme_preference);
    let menu = ui.menu_button(text, |ui| {
        for (choice, name) in [
            (ThemePreference::System, "As the system"),
            (ThemePreference::Light, "Light"),
            (ThemePreference::Dark, "Dark"),
        ] {
            let response = ui.selectable_value(&mut preference, choice, name);
            ui.ctx().accesskit_node_builder(response.id, |node| {
                node.set_label(format!("{name} theme"));
            });
        }
        ui.separator();
        ui.weak("Labels in plots");
        for size in LabelSize::ALL {
            let name = format!("{} %", size.percent());
            let response = ui.selectable_value(labels, size, &name);
            ui.ctx().accesskit_node_builder(response.id, |node| {
                node.set_label(format!("Labels at {name}"));
            });
        }
        ui.separator();
        let mut is_reduced = theme::has_reduced_motion(ui.ctx());
        let switch = ui.checkbox(&mut is_reduced, "Reduce motion");
        switch.on_hover_text(
            "Nothing moves or fades by itself: the camera jumps, and marks go at once",
        );
        theme::reduce_motion(ui.ctx(), is_reduced);
    });
    let response = menu.response.on_hover_text(
        "Dark or light, the size of the labels in plots, and whether anything moves by itself",
    );
    ui.ctx()
        .accesskit_node_builder(response.id, |node| node.set_label("Theme"));
    ui.ctx().set_theme(preference);
}

/// The section that views share. Returns the drop-down.
pub fn section(ui: &mut Ui, session: &mut Session) -> Response {
    let mut is_free = session.section_phi_deg.is_some();
    let title = |is_free| {
        if is_free {
            "At azimuth"
        } else {
            "Plane of incidence"
        }
    };
    let combo = ComboBox::from_id_salt("section")
        .selected_text(title(is_free))
        .width(0.0)
        .show_ui(ui, |ui| {
            for choice in [false, true] {
                ui.selectable_value(&mut is_free, choice, title(choice));
            }
        });
    ui.ctx()
        .accesskit_node_builder(combo.response.id, |node| node.set_label("Section"));
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
    combo.response
}
