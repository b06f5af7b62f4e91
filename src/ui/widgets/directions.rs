//! The direction panel: the held direction and the turn of the surface.

use egui::{Slider, Ui};

use crate::analysis::Hold;
use crate::ui::session::Session;

/// The panel; it changes the session.
pub fn show(ui: &mut Ui, session: &mut Session) {
    ui.horizontal(|ui| {
        ui.label("Hold");
        ui.selectable_value(&mut session.hold, Hold::Light, "Light")
            .on_hover_text("Hold the light (wi): the lobe shows where its light goes, f over all wo");
        ui.selectable_value(&mut session.hold, Hold::Viewer, "Viewer")
            .on_hover_text("Hold the viewer (wo): the lobe shows whence light is seen, f over all wi");
    });
    angle(ui, "θ from n", &mut session.theta_deg, 0.0..=180.0, "Polar angle of the held direction from the normal n");
    angle(ui, "φ from s", &mut session.phi_deg, -180.0..=180.0, "Azimuth of the held direction from the axis s");
    let hint = "Turns the surface with its axes under the fixed directions: an isotropic lobe stays, an anisotropic one turns";
    angle(ui, "Rotate surface about n", &mut session.rotation_deg, -180.0..=180.0, hint);
    trigonometry(ui, session);
}

fn angle(ui: &mut Ui, label: &str, value: &mut f64, range: std::ops::RangeInclusive<f64>, hint: &str) {
    let slider = Slider::new(value, range).suffix("°").max_decimals(4).step_by(0.1).text(label);
    ui.add(slider).on_hover_text(hint);
}

fn trigonometry(ui: &mut Ui, session: &Session) {
    egui::Grid::new("trigonometry").num_columns(4).spacing([14.0, 2.0]).show(ui, |ui| {
        for head in ["", "cos", "sin", "tan"] {
            ui.weak(head);
        }
        ui.end_row();
        for (name, angle_deg) in [("θ", session.theta_deg), ("φ", session.phi_deg)] {
            ui.weak(name);
            for number in cos_sin_tan(angle_deg) {
                ui.monospace(number);
            }
            ui.end_row();
        }
    });
}

/// Cosine, sine and tangent as text; the tangent of a right angle is infinite.
fn cos_sin_tan(angle_deg: f64) -> [String; 3] {
    let (cos, sin) = crate::bxdf::math::frame::cos_sin_deg(angle_deg);
    let number = |x: f64| format!("{:>8.4}", x + 0.0);
    let tangent = if cos == 0.0 { format!("{:>8}", "inf") } else { number(sin / cos) };
    [number(cos), number(sin), tangent]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn right_angles_are_exact() {
        assert_eq!(cos_sin_tan(90.0).map(|s| s.trim().to_owned()), ["0.0000", "1.0000", "inf"]);
        assert_eq!(cos_sin_tan(45.0)[2].trim(), "1.0000");
    }
}
