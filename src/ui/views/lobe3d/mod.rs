//! The 3D lobe: the lobe as a surface over the sphere of directions, in the frame s, t, n.

use std::cell::RefCell;
use std::sync::Arc;

use egui::{Align2, Rect, Role, Sense, Ui, WidgetInfo, vec2};
use glam::{DVec3, Vec3};

use super::context::ViewContext;
use crate::scene3d::{self, Backdrop, Projection as _, SceneView};
use crate::theme::{Dash, rgba};
use crate::widgets::labels::Labels;
use crate::widgets::legend::{self, Swatch};
use crate::widgets::{draw, reset};
use bxdf_study::cursor::Cursor;
use bxdf_study::session::Session;
use bxdf_study::session::{HomeView, OrbitCamera};
use bxdf_study::views::lobe3d::Options;
use glide::Glide;
use sketch::Sketch;
use surface::Lobes;

mod glide;
mod held;
mod isolines;
mod level;
mod looks;
mod scene;
mod shadow;
mod sizes;
mod sketch;
mod surface;

/// How high the view's centre lies when nothing is below the surface: the upper half then fills the view.
const UPPER_CENTRE: Vec3 = Vec3::new(0.0, 0.0, 0.38);
/// How much closer the camera then comes.
const UPPER_ZOOM: f32 = 1.15;
/// Where the button stands that puts the camera back.
const RESET_CORNER: Align2 = Align2::LEFT_TOP;

pub(super) fn show(ui: &mut Ui, cx: &mut ViewContext<'_, Options>) {
    legend::show(ui, Swatch::Patch, cx.session, cx.palette);
    let rect = ui.available_rect_before_wrap();
    let response = ui.allocate_rect(rect, Sense::click_and_drag());
    response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, "3D lobe"));
    let requested = scene::requested(cx);
    let has_lower = cx.state.shows_lower_half(cx.session);
    move_camera(ui, &response, cx.session);
    let camera = centred(&glided(ui, cx), has_lower);
    let drawing = scene::drawing(ui, cx, requested, has_lower);
    let view = SceneView {
        id: ui.scope_id().value(),
        scene: Arc::clone(&drawing.scene),
        version: drawing.version,
        camera: camera.clone(),
        backdrop: Backdrop {
            edge: rgba(cx.palette.background, 255),
            middle: rgba(cx.palette.backdrop, 255),
        },
    };
    ui.painter().add(scene3d::shape(rect, view));
    // The camera is part of the session, which pictures show too: nobody can click in them.
    let is_moved = !cx.session.camera.is_home() && !cx.state.is_picture;
    let mut labels = Labels::within(rect);
    labels.keep_off(home_buttons(ui, rect, cx.session));
    if is_moved {
        labels.keep_off(reset::place(rect, RESET_CORNER));
    }
    let tip = camera.project(cx.session.held().as_vec3(), rect);
    if let Some(tip) = tip {
        labels.keep_off(held::room(tip));
    }
    let sketch = Sketch {
        ui,
        rect,
        camera: &camera,
        palette: cx.palette,
        labels: RefCell::new(labels),
    };
    sketch.draw(cx.session, &drawing);
    if held::drag(ui, cx, rect, &camera) {
        cx.state.keep_arrangement(has_lower);
    } else if !response.dragged() {
        read_out(ui, cx, &response, &drawing.lobes, &camera);
    }
    if !response.hovered() {
        mark_cursor(ui, cx, rect, &camera);
    }
    if reset::button(ui, rect, RESET_CORNER, is_moved) {
        cx.session.camera = OrbitCamera::default();
    }
}

/// The session's camera, or where it is on its way there.
fn glided(ui: &Ui, cx: &mut ViewContext<'_, Options>) -> OrbitCamera {
    if cx.state.is_picture {
        return cx.session.camera.clone();
    }
    let now = ui.input(|input| input.time);
    let glide: &mut Glide = cx.state.own(cx.view);
    let (camera, is_on_way) = glide.shown(&cx.session.camera, now);
    if is_on_way {
        ui.ctx().request_repaint();
    }
    camera
}

/// The direction pointed at in another view: a line to the dome.
fn mark_cursor(ui: &Ui, cx: &ViewContext<'_, Options>, rect: Rect, camera: &OrbitCamera) {
    let Some(cursor) = &*cx.cursor else {
        return;
    };
    let project = |place: Vec3| camera.project(place, rect);
    if let (Some(foot), Some(tip)) = (project(Vec3::ZERO), project(cursor.direction.as_vec3())) {
        draw::cursor_mark(&ui.painter_at(rect), [foot, tip], Dash::Solid, cx.palette);
    }
}

/// The session's camera, with its target at the middle of what there is to see.
fn centred(camera: &OrbitCamera, has_lower: bool) -> OrbitCamera {
    let mut camera = camera.clone();
    if !has_lower {
        camera.set_target(camera.target() + UPPER_CENTRE);
        camera.zoom(UPPER_ZOOM);
    }
    camera
}

fn move_camera(ui: &Ui, response: &egui::Response, session: &mut Session) {
    let camera = &mut session.camera;
    let is_panning = ui.input(|input| input.modifiers.shift);
    if response.dragged_by(egui::PointerButton::Primary) && !is_panning {
        camera.orbit(response.drag_delta());
    } else if response.dragged() {
        camera.pan(response.drag_delta(), response.rect.size());
    }
    if response.hovered() {
        let (scroll, pinch) = ui.input(|input| (input.smooth_scroll_delta().y, input.zoom_delta()));
        let factor = (draw::ZOOM_PER_POINT * scroll).exp() * pinch;
        if factor != 1.0 {
            camera.zoom(factor);
        }
    }
    if response.double_clicked() {
        *camera = OrbitCamera::default();
    }
}

/// The buttons below the picture; what they cover.
fn home_buttons(ui: &mut Ui, rect: Rect, session: &mut Session) -> Rect {
    let strip = Rect::from_min_size(
        rect.left_bottom() + vec2(6.0, -28.0),
        vec2(rect.width() - 12.0, 22.0),
    );
    let shown = ui.scope_builder(
        egui::UiBuilder::new().max_rect(strip).id_salt("home views"),
        |ui| {
            let row = ui.horizontal(|ui| {
                for home in HomeView::ALL {
                    let hint = "Look from here; double-click the view to reset, drag to orbit, \
                    Shift-drag to pan, scroll to zoom";
                    if ui.small_button(home.label()).on_hover_text(hint).clicked() {
                        session.camera.home(home);
                    }
                }
                let hint = "Draw theta, phi and the projection of the held direction onto the \
                surface, whose length is sin theta";
                ui.toggle_value(&mut session.show_geometry, "Angles")
                    .on_hover_text(hint);
            });
            row.response.rect
        },
    );
    shown.inner
}

/// The direction and value under the pointer: on the lobe where the pointer meets it, else on the dome.
fn read_out(
    ui: &Ui,
    cx: &mut ViewContext<'_, Options>,
    response: &egui::Response,
    lobes: &Lobes,
    camera: &OrbitCamera,
) {
    let Some(pointer) = response.hover_pos() else {
        return;
    };
    let ray = camera.ray(pointer, response.rect);
    let on_lobe = lobes.hit(&ray);
    let hit = on_lobe
        .map(|(distance, _)| ray.origin + distance * ray.direction)
        .or_else(|| ray.sphere_hits(1.0)[0])
        .map(Vec3::as_dvec3);
    let Some(direction) = hit.and_then(DVec3::try_normalize) else {
        return;
    };
    ui.painter_at(response.rect)
        .circle_stroke(pointer, 4.0, (1.5, cx.palette.ink));
    let materials = &cx.session.materials;
    let entry = on_lobe
        .and_then(|(_, material)| materials.get(material))
        .unwrap_or_else(|| materials.selected());
    let cursor = Cursor {
        material: entry.id(),
        direction,
    };
    let value = cursor.value(cx.session, cx.answers);
    draw::pointer_note(
        ui,
        pointer,
        response.rect,
        &draw::cursor_text(&cursor, cx.session, value),
        cx.palette,
    );
    *cx.cursor = Some(cursor);
}
