//! The 3D lobe: the lobe as a surface over the sphere of directions, in the frame s, t, n.

use std::sync::Arc;

use egui::{Align2, Color32, Pos2, Rect, Sense, Theme, Ui, Role, WidgetInfo, vec2};
use glam::{DVec3, Vec3};

use super::{Cursor, ViewContext, ViewSpec};
use crate::analysis::lobe::Arrow;
use crate::analysis::lobe3d::Mesh;
use crate::analysis::{Channel, Lobe, RadialScale};
use crate::bxdf::math::frame;
use crate::ui::memo::Memo;
use crate::ui::scene3d::{self, HomeView, OrbitCamera, Ray, Scene, SceneView, Vertex};
use crate::ui::session::Session;
use crate::ui::theme::{self, Palette, rgba};
use crate::ui::widgets::draw;
use crate::ui::format;

/// The list entry.
pub(super) const SPEC: ViewSpec = ViewSpec {
    id: "lobe3d",
    title: "3D lobe",
    what_you_see: "The lobe over all directions: distance from the centre and colour are the value f; drag to orbit",
    show,
};

/// The largest radius of the lobe: a little less than the dome's, or the two surfaces would flicker into each other.
const LOBE_RADIUS: f64 = 0.96;
/// Where axes end, beyond the unit dome.
const AXIS_LENGTH: f32 = 1.22;
/// How high the view's centre lies when nothing is below the surface: the upper half then fills the view.
const UPPER_CENTRE: Vec3 = Vec3::new(0.0, 0.0, 0.38);
/// How much closer the camera then comes.
const UPPER_ZOOM: f32 = 1.15;
/// Radius of the arcs of theta and phi.
const ARC_RADIUS: f32 = 0.42;
/// What one notch of the wheel zooms by is e to this times its points.
const ZOOM_PER_POINT: f32 = 0.003;

/// What the scene is made from.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct SceneKey {
    lobe: u64,
    session: Session,
    is_dark: bool,
}

/// The scene last shown.
pub(super) type SceneMemo = Memo<SceneKey, Scene>;

fn show(ui: &mut Ui, cx: &mut ViewContext<'_>) {
    let rect = ui.available_rect_before_wrap();
    let response = ui.allocate_rect(rect, Sense::click_and_drag());
    response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, "3D lobe"));
    let mesh = cx.data.mesh(cx.session);
    let arrows = cx.data.arrows(cx.session);
    let has_lower = mesh.vertices.iter().any(|v| v.direction.z < 0.0)
        || arrows.iter().any(|arrow| arrow.direction.z < 0.0)
        || cx.session.theta_deg > 90.0;
    move_camera(ui, &response, cx.session);
    let camera = centred(&cx.session.camera, has_lower);
    let scene = scene(ui, cx, &mesh, &arrows, has_lower);
    let view = SceneView {
        id: ui.scope_id().value(),
        scene,
        version: cx.state.scene.version(),
        camera: camera.clone(),
        background: rgba(cx.palette.background, 255),
    };
    ui.painter().add(scene3d::shape(rect, view));
    let sketch = Sketch { ui, rect, camera: &camera, palette: cx.palette };
    sketch.name_axes(&mesh, cx.session);
    sketch.label(cx.session, &arrows);
    sketch.legend(&mesh, cx.session);
    home_buttons(ui, rect, cx.session);
    if !drag_held(ui, cx, rect, &camera) && !response.dragged() {
        read_out(ui, cx, &response, &mesh, &camera);
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
        let factor = (ZOOM_PER_POINT * scroll).exp() * pinch;
        if factor != 1.0 {
            camera.zoom(factor);
        }
    }
    if response.double_clicked() {
        *camera = OrbitCamera::default();
    }
}

fn home_buttons(ui: &mut Ui, rect: Rect, session: &mut Session) {
    let strip = Rect::from_min_size(rect.left_bottom() + vec2(6.0, -28.0), vec2(rect.width() - 12.0, 22.0));
    ui.scope_builder(egui::UiBuilder::new().max_rect(strip).id_salt("home views"), |ui| {
        ui.horizontal(|ui| {
            for home in HomeView::ALL {
                let hint = "Look from here; double-click the view to reset, drag to orbit, Shift-drag to pan, scroll to zoom";
                if ui.small_button(home.label()).on_hover_text(hint).clicked() {
                    session.camera.home(home);
                }
            }
            let hint = "Draw theta, phi and the projection of the held direction onto the surface, whose length is sin theta";
            ui.toggle_value(&mut session.show_geometry, "Angles").on_hover_text(hint);
        });
    });
}

fn scene(ui: &Ui, cx: &mut ViewContext<'_>, mesh: &Mesh, arrows: &[Arrow], has_lower: bool) -> Arc<Scene> {
    let key = SceneKey {
        lobe: cx.data.lobe_version(),
        session: Session { camera: OrbitCamera::default(), ..cx.session.clone() },
        is_dark: ui.ctx().theme() == Theme::Dark,
    };
    let (session, palette) = (&*cx.session, cx.palette);
    cx.state.scene.get(key, || {
        let mut scene = Scene::default();
        add_lobe(&mut scene, mesh, session);
        add_frame(&mut scene, palette, has_lower);
        add_directions(&mut scene, session, arrows, palette);
        if session.show_geometry {
            add_geometry(&mut scene, session, palette);
        }
        scene
    })
}

/// The luminance that is drawn as radius and colour.
fn shown(session: &Session, direction: DVec3, value: [f64; 3]) -> f64 {
    let cosine = if session.with_cosine { direction.z.abs() } else { 1.0 };
    Channel::Luminance.of(value) * cosine
}

fn peak(mesh: &Mesh, session: &Session) -> f64 {
    mesh.vertices.iter().map(|v| shown(session, v.direction, v.value)).fold(0.0, f64::max)
}

fn add_lobe(scene: &mut Scene, mesh: &Mesh, session: &Session) {
    let peak = peak(mesh, session);
    let radii: Vec<f64> =
        mesh.vertices.iter().map(|v| session.scale.radius(shown(session, v.direction, v.value), peak)).collect();
    let tips: Vec<Vec3> = mesh.vertices.iter().zip(&radii).map(|(v, radius)| (v.direction * (LOBE_RADIUS * radius)).as_vec3()).collect();
    let tip = |index: u32| tips.get(index as usize).copied().unwrap_or_default();
    // Degenerate triangles about the centre show nothing and would spoil the normals.
    let triangles: Vec<[u32; 3]> =
        mesh.triangles.iter().copied().filter(|t| t.iter().any(|index| tip(*index) != Vec3::ZERO)).collect();
    let mut normals = vec![Vec3::ZERO; tips.len()];
    for triangle in &triangles {
        let [a, b, c] = triangle.map(tip);
        let area = (b - a).cross(c - a);
        for index in triangle {
            if let Some(normal) = normals.get_mut(*index as usize) {
                *normal += area;
            }
        }
    }
    let vertices: Vec<Vertex> = tips
        .iter()
        .zip(&normals)
        .zip(&radii)
        .map(|((tip, normal), radius)| Vertex {
            position: tip.to_array(),
            normal: normal.normalize_or_zero().to_array(),
            color: theme::viridis(*radius),
        })
        .collect();
    scene.opaque.append(&vertices, triangles.into_iter().flatten());
}

fn add_frame(scene: &mut Scene, palette: &Palette, has_lower: bool) {
    let (axis, grid) = (rgba(palette.axis, 255), rgba(palette.axis, 60));
    scene.add_hemisphere(true, palette.dome);
    scene.add_degree_grid(true, 15.0, 30.0, grid, 1.0);
    if has_lower {
        scene.add_hemisphere(false, palette.dome);
        scene.add_degree_grid(false, 15.0, 30.0, grid, 1.0);
    }
    scene.add_ground_disc(palette.ground);
    for direction in [Vec3::X, Vec3::Y] {
        scene.add_arrow(Vec3::ZERO, direction * AXIS_LENGTH, axis, 1.5);
    }
    scene.add_arrow(Vec3::ZERO, Vec3::Z * AXIS_LENGTH, rgba(palette.ink, 255), 1.5);
}

fn add_directions(scene: &mut Scene, session: &Session, arrows: &[Arrow], palette: &Palette) {
    let held = session.held();
    let mirror = DVec3::new(-held.x, -held.y, held.z);
    scene.add_arrow(Vec3::ZERO, held.as_vec3(), rgba(palette.held(session.hold), 255), 3.0);
    scene.add_dashed(Vec3::ZERO, mirror.as_vec3(), rgba(palette.mirror, 255), 2.0);
    for arrow in arrows {
        let length = Channel::Luminance.of(arrow.flux);
        scene.add_arrow(Vec3::ZERO, (arrow.direction * length).as_vec3(), rgba(palette.delta, 255), 5.0);
    }
}

/// Theta, phi and the projection onto the s-t plane.
fn add_geometry(scene: &mut Scene, session: &Session, palette: &Palette) {
    let color = rgba(palette.geometry, 255);
    let held = session.held().as_vec3();
    let flat = Vec3::new(held.x, held.y, 0.0);
    scene.add_arc(Vec3::ZERO, Vec3::Z, held, ARC_RADIUS, color, 2.0);
    if flat.length() > 1e-3 {
        scene.add_arc(Vec3::ZERO, Vec3::X, flat, ARC_RADIUS, color, 2.0);
        scene.add_arrow(Vec3::ZERO, flat, color, 2.0);
        scene.add_dashed(held, flat, color, 1.5);
    }
}

/// What is painted over the scene.
struct Sketch<'a> {
    ui: &'a Ui,
    rect: Rect,
    camera: &'a OrbitCamera,
    palette: &'a Palette,
}

impl Sketch<'_> {
    fn name(&self, place: Vec3, text: &str, color: Color32) {
        if let Some(position) = self.camera.project(place, self.rect) {
            let painter = self.ui.painter_at(self.rect);
            let font = draw::body_font(self.ui);
            draw::haloed_text(&painter, position, Align2::CENTER_CENTER, text, font, color, self.palette);
        }
    }

    /// The names of the axes, where the lobe does not stand before them.
    fn name_axes(&self, mesh: &Mesh, session: &Session) {
        let eye = self.camera.eye();
        for (axis, name) in [(Vec3::X, "s"), (Vec3::Y, "t"), (Vec3::Z, "n")] {
            let place = axis * (AXIS_LENGTH + 0.08);
            let sight = Ray { origin: eye, direction: place - eye };
            let is_hidden = lobe_hit(&sight, mesh, session).is_some_and(|hit| {
                (hit - eye.as_dvec3()).length() < f64::from((place - eye).length())
            });
            if !is_hidden {
                self.name(place, name, self.palette.ink);
            }
        }
    }

    fn label(&self, session: &Session, arrows: &[Arrow]) {
        let held = session.held().as_vec3();
        let mirror = Vec3::new(-held.x, -held.y, held.z);
        for arrow in arrows {
            let share = Channel::Luminance.of(arrow.flux);
            let place = (arrow.direction * share.max(0.3) * 0.62).as_vec3();
            self.name(place, &format!("delta {share:.3}"), self.palette.delta);
        }
        self.name(mirror * 1.12, "mirror", self.palette.mirror);
        self.name(held * 1.17, session.held_name(), self.palette.held(session.hold));
        if session.show_geometry {
            self.label_geometry(session);
        }
    }

    fn label_geometry(&self, session: &Session) {
        let held = session.held().as_vec3();
        let flat = Vec3::new(held.x, held.y, 0.0);
        let color = self.palette.geometry;
        let beyond = |a: Vec3, b: Vec3| (a + b).normalize_or_zero() * (ARC_RADIUS + 0.1);
        self.name(beyond(Vec3::Z, held), &format!("θ {}", format::degrees(session.theta_deg)), color);
        if let Some(along) = flat.try_normalize() {
            self.name(beyond(Vec3::X, along), &format!("φ {}", format::degrees(session.phi_deg)), color);
            self.name(flat * 0.75, &format!("sin θ {:.3}", flat.length()), color);
        }
    }

    /// The colours with the values they stand for.
    fn legend(&self, mesh: &Mesh, session: &Session) {
        let peak = peak(mesh, session);
        if peak <= 0.0 {
            return;
        }
        let (width, height) = (10.0, (0.2 * self.rect.height()).clamp(50.0, 120.0));
        let corner = self.rect.right_top() + vec2(-width - 8.0, 12.0);
        let bar = Rect::from_min_size(corner, vec2(width, height));
        let mut strip = egui::Mesh::default();
        let steps = 24_u32;
        for step in 0..=steps {
            let t = step as f32 / steps as f32;
            let color = theme::viridis_color(f64::from(1.0 - t));
            let y = bar.top() + t * bar.height();
            strip.colored_vertex(Pos2::new(bar.left(), y), color);
            strip.colored_vertex(Pos2::new(bar.right(), y), color);
            if step > 0 {
                let first = 2 * (step - 1);
                strip.add_triangle(first, first + 1, first + 2);
                strip.add_triangle(first + 1, first + 2, first + 3);
            }
        }
        let painter = self.ui.painter_at(self.rect);
        painter.add(strip);
        let text = |y: f32, anchor: Align2, text: String| {
            let place = Pos2::new(bar.left() - 5.0, y);
            painter.text(place, anchor, text, draw::small_font(self.ui), self.palette.faint_ink);
        };
        let quantity = if session.with_cosine { "f cos θ" } else { "f" };
        text(bar.top(), Align2::RIGHT_CENTER, format!("{quantity} {} 1/sr", format::value(peak)));
        let low = match session.scale {
            RadialScale::Linear => "0".to_owned(),
            RadialScale::Logarithmic { .. } => format::value(session.scale.value(0.0, peak)),
        };
        text(bar.bottom(), Align2::RIGHT_CENTER, low);
    }
}

/// The handle of the held direction on the dome. Returns whether it is being dragged.
fn drag_held(ui: &Ui, cx: &mut ViewContext<'_>, rect: Rect, camera: &OrbitCamera) -> bool {
    let Some(tip) = camera.project(cx.session.held().as_vec3(), rect).filter(|tip| rect.contains(*tip)) else {
        return false;
    };
    let color = cx.palette.held(cx.session.hold);
    let handle = draw::handle(ui, tip, ui.scope_id().with("held"), "Held direction in the 3D lobe", color, cx.palette);
    if let Some(pointer) = handle.interact_pointer_pos().filter(|_| handle.dragged()) {
        cx.session.set_held(camera.ray(pointer, rect).drag_on_sphere(1.0).as_dvec3());
        ui.ctx().request_repaint();
    }
    handle.dragged()
}

/// The direction and value under the pointer: on the lobe where the pointer meets it, else on the dome.
fn read_out(ui: &Ui, cx: &mut ViewContext<'_>, response: &egui::Response, mesh: &Mesh, camera: &OrbitCamera) {
    let Some(pointer) = response.hover_pos() else {
        return;
    };
    let ray = camera.ray(pointer, response.rect);
    let hit = lobe_hit(&ray, mesh, cx.session).or_else(|| ray.sphere_hits(1.0)[0].map(Vec3::as_dvec3));
    let Some(direction) = hit.and_then(DVec3::try_normalize) else {
        return;
    };
    let surface = cx.data.surface(cx.session);
    let lobe = Lobe::new(&**surface, cx.session.hold, cx.session.held());
    let cosine = if cx.session.with_cosine { direction.z.abs() } else { 1.0 };
    let cursor = Cursor {
        theta_deg: frame::theta(direction).to_degrees(),
        phi_deg: frame::phi(direction).to_degrees(),
        value: lobe.value_or_limit(direction, direction.z >= 0.0).map(|f| f * cosine),
    };
    draw::pointer_note(ui, pointer, response.rect, &draw::cursor_text(&cursor, cx.session), cx.palette);
    *cx.cursor = Some(cursor);
}

/// Where `ray` first meets the drawn lobe (Moeller & Trumbore 1997).
fn lobe_hit(ray: &Ray, mesh: &Mesh, session: &Session) -> Option<DVec3> {
    let peak = peak(mesh, session);
    let tip = |index: u32| {
        let vertex = mesh.vertices.get(index as usize)?;
        let radius = session.scale.radius(shown(session, vertex.direction, vertex.value), peak);
        Some(vertex.direction * (LOBE_RADIUS * radius))
    };
    let (origin, direction) = (ray.origin.as_dvec3(), ray.direction.as_dvec3());
    let distance = |[a, b, c]: [u32; 3]| {
        let (a, b, c) = (tip(a)?, tip(b)?, tip(c)?);
        let (ab, ac) = (b - a, c - a);
        let p = direction.cross(ac);
        let determinant = ab.dot(p);
        let from_a = origin - a;
        let q = from_a.cross(ab);
        let (u, v) = (from_a.dot(p) / determinant, direction.dot(q) / determinant);
        let t = ac.dot(q) / determinant;
        (u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 0.0).then_some(t)
    };
    let nearest = mesh.triangles.iter().filter_map(|t| distance(*t)).fold(f64::INFINITY, f64::min);
    nearest.is_finite().then(|| origin + direction * nearest)
}
