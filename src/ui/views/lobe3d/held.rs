//! Light and viewer: a small sun and an eye on the dome, which are dragged.

use std::f32::consts::TAU;

use egui::{Painter, Pos2, Rect, Ui, Vec2, vec2};

use super::super::context::{Named, ViewContext};
use super::super::direction;
use crate::scene3d::Projection as _;
use crate::theme::{HANDLE_RADIUS, Palette};
use crate::widgets::handle;
use bxdf_lab::analysis::Hold;
use bxdf_study::session::OrbitCamera;
use bxdf_study::views::lobe3d::Options;

/// Rays of the sun.
const RAYS: u8 = 10;
/// Where they begin and end beyond the handle, in points.
const RAY: [f32; 2] = [3.5, 7.0];
/// Half the width and height of the eye, in points.
const EYE: [f32; 2] = [16.0, 11.0];
/// Width of the strokes of either, in points.
const STROKE: f32 = 1.6;
/// How much wider the halo is that sets them off against a lobe, in points.
const HALO: f32 = 2.0;
/// Steps of a lid of the eye.
const LID_STEPS: u8 = 12;

/// What the light or the viewer covers where its tip is at `tip`: no label stands there.
pub(super) fn room(tip: Pos2) -> Rect {
    handle::room(tip).expand(RAY[1])
}

/// The handles of light and viewer on the dome. Returns whether one is being dragged.
pub(super) fn drag(
    ui: &Ui,
    cx: &mut ViewContext<'_, Options>,
    rect: Rect,
    camera: &OrbitCamera,
) -> bool {
    let dragged = cx
        .directions()
        .map(|one| drag_one(ui, cx, (rect, camera), &one));
    dragged.contains(&true)
}

fn drag_one(
    ui: &Ui,
    cx: &mut ViewContext<'_, Options>,
    (rect, camera): (Rect, &OrbitCamera),
    one: &Named,
) -> bool {
    let Some(tip) = camera.project(one.direction.as_vec3(), rect) else {
        return false;
    };
    let painter = ui.painter_at(rect);
    let name = match one.of {
        Hold::Light => {
            sun(&painter, tip, cx.palette);
            "Light in the 3D lobe"
        }
        Hold::Viewer => {
            eye(&painter, tip, cx.palette);
            "Viewer in the 3D lobe"
        }
    };
    let handle = direction::show(ui, cx, one, tip, (name, rect, direction::KEYS));
    let dragged_to = handle.dragged_to().map(|place| {
        let w = camera.ray(place, rect).drag_on_sphere(1.0);
        w.as_dvec3()
    });
    let turned = handle
        .steps()
        .map(|steps| direction::turned(one.direction, steps));
    if let Some(w) = dragged_to.or(turned) {
        cx.put(one.of, w);
        ui.ctx().request_repaint();
    }
    handle.is_dragged()
}

/// The rays of a sun about its disc, which is the handle.
fn sun(painter: &Painter, middle: Pos2, palette: &Palette) {
    for ray in 0..RAYS {
        let way = Vec2::angled(TAU * f32::from(ray) / f32::from(RAYS));
        let ends = RAY.map(|beyond| middle + way * (HANDLE_RADIUS + beyond));
        for stroke in [(STROKE + HALO, palette.background), (STROKE, palette.light)] {
            painter.line_segment(ends, stroke);
        }
    }
}

/// The lids of an eye about its iris, which is the handle.
fn eye(painter: &Painter, middle: Pos2, palette: &Palette) {
    let [width, height] = EYE;
    for side in [-1.0, 1.0] {
        let lid = (0..=LID_STEPS).map(|step| {
            let x = 2.0 * f32::from(step) / f32::from(LID_STEPS) - 1.0;
            middle + vec2(width * x, side * height * (1.0 - x * x))
        });
        let lid: Vec<Pos2> = lid.collect();
        for stroke in [
            (STROKE + HALO, palette.background),
            (STROKE, palette.viewer),
        ] {
            painter.line(lid.clone(), stroke);
        }
    }
}
