//! The direction panel: the held direction and the turn of the surface.

use egui::{Grid, RichText, ScrollArea, Ui};

use crate::widgets::number::Number;
use bxdf_lab::analysis::Hold;
use bxdf_study::number::NumberSpec;
use bxdf_study::session::{PHI, ROTATION, Session};

/// The panel; it changes the session.
pub fn show(ui: &mut Ui, session: &mut Session) {
    ui.add_space(3.0);
    ScrollArea::horizontal().show(ui, |ui| grid(ui, session));
    ui.add_space(2.0);
}

/// One line of it, while the views are presented.
pub fn slim(ui: &mut Ui, session: &mut Session) {
    ui.horizontal(|ui| {
        hold(ui, session);
        let hint = "Polar angle of the held direction from the normal n";
        let spec = session.theta_spec();
        angle(ui, "θ from n", &mut session.theta_deg, spec, hint);
        let hint = "Azimuth of the held direction from the axis s";
        angle(ui, "φ from s", &mut session.phi_deg, PHI, hint);
    });
}

fn grid(ui: &mut Ui, session: &mut Session) {
    Grid::new("directions").num_columns(5).spacing([12.0, 3.0]).show(ui, |ui| {
        hold(ui, session);
        let hint = "Polar angle of the held direction from the normal n";
        let spec = session.theta_spec();
        angle(ui, "θ from n", &mut session.theta_deg, spec, hint);
        trigonometry(ui, "θ", session.theta_deg);
        ui.end_row();

        ui.weak(match session.hold {
            Hold::Light => "f over all viewers (wo)",
            Hold::Viewer => "f over all lights (wi)",
        });
        let hint = "Azimuth of the held direction from the axis s";
        angle(ui, "φ from s", &mut session.phi_deg, PHI, hint);
        trigonometry(ui, "φ", session.phi_deg);
        ui.end_row();

        ui.weak(if session.material().is_isotropic() {
            "Isotropic lobe: stays"
        } else {
            "Anisotropic lobe: turns"
        });
        let hint = "Turns the surface with its own axes (see its brush lines) under the fixed directions and the axes s and t: \
                    an isotropic lobe stays as it is, an anisotropic one turns";
        angle(ui, "Rotate surface about n", &mut session.rotation_deg, ROTATION, hint);
        ui.end_row();
    });
}

fn hold(ui: &mut Ui, session: &mut Session) {
    ui.horizontal(|ui| {
        ui.label("Hold");
        ui.selectable_value(&mut session.hold, Hold::Light, "Light")
            .on_hover_text(
                "Hold the light (wi): the lobe shows where its light goes, f over all wo",
            );
        ui.selectable_value(&mut session.hold, Hold::Viewer, "Viewer")
            .on_hover_text(
                "Hold the viewer (wo): the lobe shows where the light that is seen comes from, f over all wi",
            );
    });
}

/// An angle with its slider, which has steps of a tenth of a degree as long as the value has no finer digits.
fn angle(ui: &mut Ui, label: &str, value: &mut f64, spec: NumberSpec, hint: &str) {
    let is_tenth = (*value * 10.0).fract() == 0.0;
    let step = if is_tenth { 0.1 } else { 0.0 };
    let number = Number::new(label, spec).steps(step, 4);
    ui.vertical(|ui| {
        let shown = number.slider(ui, label, value);
        shown.on_hover_text(hint).explain(ui);
    });
}

fn trigonometry(ui: &mut Ui, name: &str, angle_deg: f64) {
    for (function, number) in ["cos", "sin", "tan"]
        .into_iter()
        .zip(cos_sin_tan(angle_deg))
    {
        ui.label(
            RichText::new(format!("{function} {name} {number}"))
                .monospace()
                .small(),
        );
    }
}

/// Cosine, sine and tangent as text; the tangent of a right angle is infinite.
fn cos_sin_tan(angle_deg: f64) -> [String; 3] {
    let (cos, sin) = bxdf::math::frame::cos_sin_deg(angle_deg);
    let number = |x: f64| format!("{:>6.3}", x + 0.0);
    let tangent = if cos == 0.0 {
        format!("{:>6}", "inf")
    } else {
        number(sin / cos)
    };
    [number(cos), number(sin), tangent]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn right_angles_are_exact() {
        assert_eq!(
            cos_sin_tan(90.0).map(|s| s.trim().to_owned()),
            ["0.000", "1.000", "inf"]
        );
        assert_eq!(cos_sin_tan(45.0)[2].trim(), "1.000");
    }
}
