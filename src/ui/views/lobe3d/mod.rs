//! The 3D lobe: the lobe as a surface over the sphere of directions, in the frame s, t, n.

use std::cell::RefCell;
use std::sync::Arc;

use egui::{Align2, Rect, Role, Sense, Ui, WidgetInfo};
use glam::{DVec3, Vec3};

use super::context::ViewContext;
use super::{half_vector, settings, side_by_side};
use crate::scene3d::{self, Backdrop, Projection as _, SceneView};
use crate::theme::{self, Dash, rgba};
use crate::widgets::labels::Labels;
use crate::widgets::legend::Swatch;
use crate::widgets::{draw, reset, small, still};
use axes::Solids;
use bxdf::math::frame;
use bxdf_study::cursor::Cursor;
use bxdf_study::session::{HomeView, LobeSurface, OrbitCamera, Session};
use bxdf_study::views::Arrangement;
use bxdf_study::views::lobe3d::Options;
use glide::Glide;
use scene::Requested;
use sketch::Sketch;
use surface::{Lobes, Scales};

mod axes;
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
/// Width over height of each of several lobes side by side.
const CELL_ASPECT: f32 = 1.1;
/// Where the button stands that puts the camera back.
const RESET_CORNER: Align2 = Align2::LEFT_TOP;

pub(super) fn show(ui: &mut Ui, cx: &mut ViewContext<'_, Options>) {
    let requested = scene::requested(cx);
    let scales = scene::scales(ui, cx, &requested);
    settings::row(ui, cx, |ui, cx| {
        let Options {
            mut scale,
            mut arrangement,
        } = *cx.options;
        settings::scale(ui, cx, &mut scale, scales.shared());
        settings::arrangement(ui, cx, &mut arrangement);
        (cx.options.scale, cx.options.arrangement) = (scale, arrangement);
        settings::cosine(ui, cx);
        surface_choice(ui, cx);
        home_buttons(ui, cx.session);
    });
    let is_overlaid = cx.options.arrangement == Arrangement::Overlaid || requested.len() < 2;
    if is_overlaid {
        cx.legend(ui, Swatch::Patch);
    }
    let room = ui.available_rect_before_wrap();
    let covered = reset::place(room, RESET_CORNER);
    if is_overlaid {
        show_scene(ui, cx, (requested, scales), room, covered);
    } else {
        let named = requested.iter().enumerate();
        let named: Vec<_> = named
            .map(|(index, one)| (one.material(), scales.own_of(index)))
            .collect();
        let cells = side_by_side::cells(ui, cx, (room, CELL_ASPECT), &named);
        for (index, (picture, one)) in cells.into_iter().zip(requested).enumerate() {
            let own = scales.of_one(index);
            ui.push_id(one.material(), |ui| {
                show_scene(ui, cx, (vec![one], own), picture, covered);
            });
        }
    }
    ui.advance_cursor_after_rect(room);
    if reset::button(ui, room, RESET_CORNER, is_moved(cx)) {
        cx.session.camera = OrbitCamera::default();
    }
}

/// Whether the camera is elsewhere than at first. It is part of the session, which pictures show too: nobody can click in
/// them.
fn is_moved(cx: &ViewContext<'_, Options>) -> bool {
    !cx.session.camera.is_home() && !cx.state.is_picture
}

/// The lobes of what is `drawn`. `covered`: where the button stands that puts the camera back.
fn show_scene(
    ui: &mut Ui,
    cx: &mut ViewContext<'_, Options>,
    drawn: (Vec<Requested>, Scales),
    rect: Rect,
    covered: Rect,
) {
    let sense = still::sense(ui, Sense::click_and_drag());
    let response = ui.interact(rect, ui.scope_id().with("scene"), sense);
    response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, "3D lobe"));
    let has_lower = cx.state.shows_lower_half(cx.session);
    move_camera(ui, &response, cx.session);
    let camera = centred(&glided(ui, cx), has_lower);
    let drawing = scene::drawing(ui, cx, drawn, has_lower);
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
    cx.fill(dome(&camera, rect, has_lower));
    let mut labels = Labels::within(rect);
    if is_moved(cx) {
        labels.keep_off(covered);
    }
    let directions = cx.directions();
    for one in &directions {
        if let Some(tip) = camera.project(one.direction.as_vec3(), rect) {
            labels.keep_off(held::room(tip));
        }
    }
    let sketch = Sketch {
        ui,
        rect,
        camera: &camera,
        palette: cx.palette,
        labels: RefCell::new(labels),
    };
    if cx.state.is_drawing {
        let solids = Solids {
            lobes: &drawing.lobes,
            has_table: !has_lower,
        };
        axes::draw(&ui.painter_at(rect), rect, &camera, &solids, cx.palette);
    }
    sketch.draw(cx.session, &directions, &drawing);
    if let Some(half) = half_vector::pointed(ui, cx.session) {
        let ends = [Vec3::ZERO, half.as_vec3()].map(|end| camera.project(end, rect));
        half_vector::mark(ui, ends, Dash::Solid, cx.palette);
    }
    let mut free = rect;
    if is_moved(cx) && rect.intersects(covered) {
        free.min.y = covered.bottom();
    }
    offer_peaks(ui, cx, &drawing.lobes, free);
    if held::drag(ui, cx, rect, &camera) {
        cx.state.keep_arrangement(has_lower);
    } else if !response.dragged() {
        read_out(ui, cx, &response, &drawing.lobes, &camera);
    }
    if !response.hovered() {
        mark_cursor(ui, cx, rect, &camera);
    }
}

/// Where the dome, or the sphere, is seen in `rect`.
fn dome(camera: &OrbitCamera, rect: Rect, has_lower: bool) -> Rect {
    const STEPS: u32 = 24;
    let turn = |step: u32| 360.0 * f64::from(step) / f64::from(STEPS);
    let lowest = if has_lower { STEPS / 2 } else { STEPS / 4 };
    let directions = (0..=lowest).flat_map(|theta| {
        (0..STEPS).map(move |phi| frame::direction_from_degrees(turn(theta), turn(phi)))
    });
    let places = directions.filter_map(|w| camera.project(w.as_vec3(), rect));
    Rect::from_points(&places.collect::<Vec<_>>()).intersect(rect)
}

/// How a lobe may be drawn: the name and what it is good for.
const SURFACES: [(LobeSurface, &str); 4] = [
    (LobeSurface::Automatic, "Automatic"),
    (LobeSurface::Solid, "Solid"),
    (LobeSurface::Wire, "Wire"),
    (LobeSurface::Translucent, "Translucent"),
];

/// How the lobes are drawn.
fn surface_choice(ui: &mut Ui, cx: &mut ViewContext<'_, Options>) {
    let hint = "Automatic: one lobe as a solid, several as shells. Solid: what is behind is hidden. Wire: shows where the mesh is \
                fine. Translucent: shows lobes inside one another";
    let mut surface = cx.session.lobe_surface;
    settings::combo(ui, cx, ("Surface", hint), &mut surface, &SURFACES);
    cx.session.lobe_surface = surface;
}

/// Offers to show each lobe to its peak, where one is too small to be seen.
fn offer_peaks(ui: &mut Ui, cx: &mut ViewContext<'_, Options>, lobes: &Lobes, room: Rect) {
    let small = settings::smallest(cx, lobes.radii());
    let mut scale = cx.options.scale;
    settings::offer_peaks(ui, cx, &mut scale, small, room);
    cx.options.scale = scale;
}

/// The session's camera, or where it is on its way there.
fn glided(ui: &Ui, cx: &mut ViewContext<'_, Options>) -> OrbitCamera {
    if cx.state.is_picture {
        return cx.session.camera.clone();
    }
    let now = ui.input(|input| input.time);
    let glide: &mut Glide = cx.state.own(cx.view);
    if theme::has_reduced_motion(ui.ctx()) {
        *glide = Glide::default();
        return cx.session.camera.clone();
    }
    let (camera, is_on_way) = glide.shown(&cx.session.camera, now);
    if is_on_way {
        ui.ctx().request_repaint();
    }
    camera
}

/// The direction pointed at in another view: a line to the dome.
fn mark_cursor(ui: &Ui, cx: &ViewContext<'_, Options>, rect: Rect, camera: &OrbitCamera) {
    let Some((cursor, strength)) = &cx.mark else {
        return;
    };
    let project = |place: Vec3| camera.project(place, rect);
    if let (Some(foot), Some(tip)) = (project(Vec3::ZERO), project(cursor.direction.as_vec3())) {
        let look = (cx.palette, *strength);
        draw::cursor_mark(&ui.painter_at(rect), [foot, tip], Dash::Solid, look);
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

/// The home views, and the overlay of the angles.
fn home_buttons(ui: &mut Ui, session: &mut Session) {
    for home in HomeView::ALL {
        let hint = "Look from here; double-click the view to reset, drag to orbit, Shift-drag to pan, scroll to zoom";
        if ui
            .add(small::button(ui, home.label()))
            .on_hover_text(hint)
            .clicked()
        {
            session.camera.home(home);
        }
    }
    let hint = "Draw theta, phi and the projection of the fixed direction onto the surface, whose length is sin theta, with \
                their sines, cosines and tangents";
    ui.toggle_value(&mut session.show_geometry, "Angles")
        .on_hover_text(hint);
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
    *cx.pointed = Some(cursor);
}
