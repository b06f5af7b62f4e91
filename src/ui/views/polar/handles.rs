//! The handles of light and viewer at the rim of the plot.

use egui::Ui;
use egui_plot::{PlotPoint, PlotTransform};

use super::super::context::{Named, ViewContext};
use super::radial::at;
use crate::widgets::handle;
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
    let named = (ui.scope_id().with(name), name, *transform.frame());
    let handle = handle::show(ui, tip, named, one.color, cx.palette);
    if let Some(place) = handle.dragged_to() {
        let place = transform.value_from_position(place);
        let dragged_to = place.x.atan2(place.y);
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
