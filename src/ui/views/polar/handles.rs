//! The handles of light and viewer at the rim of the plot.

use egui::Ui;
use egui_plot::{PlotPoint, PlotTransform};

use super::super::context::{Named, ViewContext};
use super::super::direction;
use super::radial::at;
use crate::widgets::steps::Steps;
use bxdf_lab::analysis::{Hold, polar};
use bxdf_study::session::wrapped_deg;
use bxdf_study::views::polar::Options;

/// The handles of light and viewer. Returns whether one is being dragged.
pub(super) fn drag_all(
    ui: &Ui,
    cx: &mut ViewContext<'_, Options>,
    transform: &PlotTransform,
) -> bool {
    let dragged = cx.directions().map(|one| drag(ui, cx, transform, &one));
    dragged.contains(&true)
}

/// The handle of one of them. Returns whether it is being dragged.
fn drag(
    ui: &Ui,
    cx: &mut ViewContext<'_, Options>,
    transform: &PlotTransform,
    one: &Named,
) -> bool {
    let section = cx.options.own_section_deg.of(cx.session);
    let azimuth = section.phi();
    let angle = polar::signed_angle(one.direction, azimuth);
    let [x, y] = at(1.0, angle);
    let tip = transform.position_from_point(&PlotPoint::new(x, y));
    let name = match one.of {
        Hold::Light => "Light in the polar plot",
        Hold::Viewer => "Viewer in the polar plot",
    };
    let handle = direction::show(ui, cx, one, tip, (name, *transform.frame(), KEYS));
    let dragged_to = handle.dragged_to().map(|place| {
        let place = transform.value_from_position(place);
        place.x.atan2(place.y)
    });
    let wanted = dragged_to.or_else(|| handle.steps().map(|steps| moved(angle, steps)));
    if let Some(dragged_to) = wanted {
        if !one.is_held || section.holds_held {
            cx.put(one.of, polar::direction(dragged_to, azimuth));
        } else {
            // Outside the section only theta is the pointer's, and the side of n on which it is drawn.
            let theta_deg = (dragged_to.abs().to_degrees() * 10.0).round() / 10.0;
            cx.session.set_theta_deg(theta_deg);
            if (dragged_to < 0.0) != (angle < 0.0) {
                cx.session.phi_deg = wrapped_deg(cx.session.phi_deg + 180.0);
            }
        }
        ui.ctx().request_repaint();
    }
    handle.is_dragged()
}

/// What the arrow keys do here.
const KEYS: &str = "Left and Right move it along the circle by 1°, Up and Down towards n and away from it; with Shift by 0.1°";

/// An angle from n, positive to the right, in radians, moved by the arrow keys.
fn moved(angle: f64, steps: Steps) -> f64 {
    let side = if angle < 0.0 { -1.0 } else { 1.0 };
    angle + (steps.right - side * steps.up).to_radians()
}
