//! The polar plot: a section of the lobe through a plane that contains n.

use std::f64::consts::{FRAC_PI_2, PI};

use egui::{Align2, Color32, Pos2, Stroke, Ui, vec2};
use egui_plot::{Line, LineStyle, Plot, PlotBounds, PlotPoint, PlotPoints, PlotTransform, PlotUi};

use super::{Cursor, ViewContext, ViewSpec};
use crate::analysis::lobe::Arrow;
use crate::analysis::polar::{self, Point, Section};
use crate::analysis::{Channel, Lobe, RadialScale};
use crate::bxdf::math::frame;
use crate::ui::data::section_request;
use crate::ui::session::{Curves, Session};
use crate::ui::widgets::draw;
use crate::ui::{format, theme};

/// The list entry.
pub(super) const SPEC: ViewSpec = ViewSpec {
    id: "polar",
    title: "Polar plot",
    what_you_see: "A section of the lobe through the normal n: the length of a ray is the value f in its direction",
    show,
};

/// The room beside the plot's unit circle that labels need, and above it.
const SIDE_ROOM: f64 = 0.4;
const TOP_ROOM: f64 = 0.27;
/// Below the horizon, where nothing is drawn but the labels of the scale.
const LOWER_ROOM: f64 = 0.16;
/// Radius of the angle labels.
const ANGLE_LABEL_RADIUS: f64 = 1.075;
/// Radius of the names of directions.
const NAME_RADIUS: f64 = 1.15;
/// Spacing of the angle rays.
const RAY_STEP_DEG: i32 = 15;
/// A delta whose azimuth is within this of the section is drawn in it.
const IN_PLANE: f64 = 0.02;

/// The radial scale with the value at the unit circle.
struct Radial {
    scale: RadialScale,
    full: f64,
    /// The values that have a ring.
    ticks: Vec<f64>,
    /// What the rings are numbered in, with its unit.
    quantity: &'static str,
}

impl Radial {
    fn of(session: &Session, section: &Section) -> Self {
        let channels = session.curves.channels();
        let shown = |point: &Point| channels.iter().map(|c| c.of(point.value)).fold(0.0, f64::max);
        let peak = section.upper.iter().chain(&section.lower).map(shown).fold(0.0, f64::max);
        if peak <= 0.0 {
            // Deltas alone: the rings count shares of the light.
            let ticks = vec![0.25, 0.5, 0.75, 1.0];
            return Self { scale: RadialScale::Linear, full: 1.0, ticks, quantity: "share of the flux" };
        }
        let (full, ticks) = match session.scale {
            RadialScale::Linear => {
                let step = format::round_step(peak);
                let count = (peak / step - 1e-9).ceil();
                (step * count, (1..=count as i32).map(|i| f64::from(i) * step).collect())
            }
            RadialScale::Logarithmic { decades } => {
                let top = (peak.log10() - 1e-9).ceil();
                (10_f64.powf(top), (0..decades as i32).map(|i| 10_f64.powf(top - f64::from(i))).collect())
            }
        };
        let quantity = if session.with_cosine { "f cos θ in 1/sr" } else { "f in 1/sr" };
        Self { scale: session.scale, full, ticks, quantity }
    }

    fn radius(&self, value: f64) -> f64 {
        self.scale.radius(value, self.full)
    }
}

/// The plot's coordinates of a radius at a signed angle from n.
fn at(radius: f64, angle: f64) -> [f64; 2] {
    [radius * angle.sin(), radius * angle.cos()]
}

fn show(ui: &mut Ui, cx: &mut ViewContext<'_>) {
    let section = cx.data.section(cx.session);
    let arrows: Vec<Arrow> = cx.data.arrows(cx.session).iter().copied().filter(|a| is_in_section(cx.session, a)).collect();
    let radial = Radial::of(cx.session, &section);
    let held = cx.session.held();
    let has_lower = !section.lower.is_empty() || held.z < 0.0 || arrows.iter().any(|a| a.direction.z < 0.0);
    let window = window(ui.available_size(), has_lower);
    let plot = Plot::new(("polar", has_lower, ui.available_size().round().to_string()))
        .data_aspect(1.0)
        .show_axes(false)
        .show_grid(false)
        .show_x(false)
        .show_y(false)
        .show_crosshair(false)
        .show_background(false)
        .allow_boxed_zoom(false)
        .set_margin_fraction(vec2(0.0, 0.0))
        .default_x_bounds(window.min()[0], window.max()[0])
        .default_y_bounds(window.min()[1], window.max()[1])
        .label_formatter(|_| None);
    let palette = *cx.palette;
    let response = plot.show(ui, |plot_ui| {
        draw_grid(plot_ui, &radial, &palette, has_lower);
        draw_curves(plot_ui, cx.session, &section, &radial, &palette);
        draw_directions(plot_ui, cx.session, &palette);
    });
    let canvas = Canvas { ui, transform: &response.transform };
    canvas.fill(cx.session, &section, &radial, &palette);
    canvas.label_grid(&radial, &palette, has_lower);
    canvas.name_directions(cx.session, &palette);
    canvas.draw_arrows(cx.session, &arrows, &palette);
    let transform = response.transform;
    let is_dragging = drag_held(ui, cx, &transform);
    if !is_dragging {
        read_out(ui, cx, &response.response, &transform, &radial);
    }
}

/// The smallest part of the plot's plane of this shape that holds the circle (or its upper half) with its labels.
fn window(size: egui::Vec2, has_lower: bool) -> PlotBounds {
    let (right, top) = (1.0 + SIDE_ROOM, 1.0 + TOP_ROOM);
    let bottom = if has_lower { -top } else { -LOWER_ROOM };
    let (width, height) = (f64::from(size.x.max(1.0)), f64::from(size.y.max(1.0)));
    let per_point = (2.0 * right / width).max((top - bottom) / height);
    let (half_width, half_height) = (0.5 * width * per_point, 0.5 * height * per_point);
    let middle = f64::midpoint(top, bottom);
    PlotBounds::from_min_max([-half_width, middle - half_height], [half_width, middle + half_height])
}

fn is_in_section(session: &Session, arrow: &Arrow) -> bool {
    let (sin, cos) = session.section_azimuth_deg().to_radians().sin_cos();
    (arrow.direction.y * cos - arrow.direction.x * sin).abs() < IN_PLANE
}

fn line<'a>(points: impl IntoIterator<Item = [f64; 2]>, stroke: impl Into<Stroke>) -> Line<'a> {
    Line::new("", PlotPoints::from_iter(points)).stroke(stroke).allow_hover(false)
}

fn draw_grid(plot_ui: &mut PlotUi<'_>, radial: &Radial, palette: &theme::Palette, has_lower: bool) {
    let sweep = if has_lower { PI } else { FRAC_PI_2 };
    for tick in &radial.ticks {
        let radius = radial.radius(*tick);
        let angles = (-90..=90).map(|i| f64::from(i) / 90.0 * sweep);
        plot_ui.line(line(angles.map(|angle| at(radius, angle)), (1.0, palette.grid)));
    }
    let limit: i32 = if has_lower { 180 } else { 90 };
    for angle_deg in (-limit + RAY_STEP_DEG..limit).step_by(RAY_STEP_DEG as usize) {
        let angle = f64::from(angle_deg).to_radians();
        plot_ui.line(line([[0.0, 0.0], at(1.0, angle)], (1.0, palette.grid)));
    }
    plot_ui.line(line([[-1.0, 0.0], [1.0, 0.0]], (1.5, palette.axis)));
}

fn arcs(section: &Section) -> impl Iterator<Item = &Vec<Point>> {
    [&section.upper, &section.lower].into_iter().filter(|arc| !arc.is_empty())
}

fn draw_curves(
    plot_ui: &mut PlotUi<'_>,
    session: &Session,
    section: &Section,
    radial: &Radial,
    palette: &theme::Palette,
) {
    for channel in session.curves.channels() {
        let style = match channel {
            Channel::Luminance | Channel::Red => LineStyle::Solid,
            Channel::Green => LineStyle::dashed_loose(),
            Channel::Blue => LineStyle::dotted_dense(),
        };
        for arc in arcs(section) {
            let curve = arc.iter().map(|point| at(radial.radius(channel.of(point.value)), point.angle));
            let closed = [[0.0, 0.0]].into_iter().chain(curve).chain([[0.0, 0.0]]);
            plot_ui.line(line(closed, theme::curve(palette.channel(*channel))).style(style));
        }
    }
}

/// The directions that are named: n, the held one and the mirror direction, with angle and colour.
fn named_directions(session: &Session, palette: &theme::Palette) -> [(&'static str, f64, Color32); 3] {
    let azimuth = session.section_azimuth_deg().to_radians();
    let held = polar::signed_angle(session.held(), azimuth);
    [
        ("n", if session.held().z < 0.0 { PI } else { 0.0 }, palette.ink),
        ("mirror", -held, palette.mirror),
        (session.held_name(), held, palette.held(session.hold)),
    ]
}

fn draw_directions(plot_ui: &mut PlotUi<'_>, session: &Session, palette: &theme::Palette) {
    plot_ui.line(line([[0.0, 0.0], [0.0, 1.0]], (1.5, palette.ink)));
    for (name, angle, color) in named_directions(session, palette) {
        let is_mirror = name == "mirror";
        // Outside the section the directions are shown at their theta, but faintly: they do not lie in it.
        let style = if is_mirror || !session.section_holds_held() { LineStyle::dashed_dense() } else { LineStyle::Solid };
        if name != "n" {
            plot_ui.line(line([[0.0, 0.0], at(1.0, angle)], (if is_mirror { 1.5 } else { 2.0 }, color)).style(style));
        }
    }
}

/// The plot as a canvas for what has no place among its items.
struct Canvas<'a> {
    ui: &'a Ui,
    transform: &'a PlotTransform,
}

impl Canvas<'_> {
    fn painter(&self) -> egui::Painter {
        self.ui.painter_at(*self.transform.frame())
    }

    fn position(&self, radius: f64, angle: f64) -> Pos2 {
        let [x, y] = at(radius, angle);
        self.transform.position_from_point(&PlotPoint::new(x, y))
    }

    /// Tints the area inside the curve, as a fan about the origin: a lobe is star-shaped by construction.
    fn fill(&self, session: &Session, section: &Section, radial: &Radial, palette: &theme::Palette) {
        if session.curves != Curves::Luminance {
            return;
        }
        let color = theme::fill_of(palette.lobe);
        for arc in arcs(section) {
            let mut mesh = egui::Mesh::default();
            mesh.colored_vertex(self.position(0.0, 0.0), color);
            for (index, point) in arc.iter().enumerate() {
                mesh.colored_vertex(self.position(radial.radius(Channel::Luminance.of(point.value)), point.angle), color);
                if index > 0 {
                    mesh.add_triangle(0, index as u32, index as u32 + 1);
                }
            }
            self.painter().add(mesh);
        }
    }

    fn label_grid(&self, radial: &Radial, palette: &theme::Palette, has_lower: bool) {
        let painter = self.painter();
        let text = |position: Pos2, anchor: Align2, text: String| {
            painter.text(position, anchor, text, draw::small_font(self.ui), palette.faint_ink);
        };
        let limit: i32 = if has_lower { 180 } else { 90 };
        for angle_deg in (-limit..=limit).step_by(RAY_STEP_DEG as usize).filter(|a| *a != -180) {
            let angle = f64::from(angle_deg).to_radians();
            text(self.position(ANGLE_LABEL_RADIUS, angle), Align2::CENTER_CENTER, format!("{}°", angle_deg.abs()));
        }
        let below = vec2(0.0, 4.0);
        for tick in &radial.ticks {
            let place = self.position(radial.radius(*tick), FRAC_PI_2) + below;
            text(place, Align2::CENTER_TOP, format::value(*tick));
        }
        text(self.position(0.5, -FRAC_PI_2) + below, Align2::CENTER_TOP, radial.quantity.to_owned());
    }

    fn name_directions(&self, session: &Session, palette: &theme::Palette) {
        let painter = self.painter();
        for (name, angle, color) in named_directions(session, palette) {
            let position = self.position(NAME_RADIUS, angle);
            // Outwards from the circle, so that the text stays clear of the angle labels.
            let anchor = match angle.sin() {
                x if x > 0.3 => Align2::LEFT_CENTER,
                x if x < -0.3 => Align2::RIGHT_CENTER,
                _ if angle.cos() < 0.0 => Align2::CENTER_TOP,
                _ => Align2::CENTER_BOTTOM,
            };
            draw::haloed_text(&painter, position, anchor, name, draw::body_font(self.ui), color, palette);
        }
    }

    /// Deltas: an arrow of the share of the flux as its length, 1 at the unit circle.
    fn draw_arrows(&self, session: &Session, arrows: &[Arrow], palette: &theme::Palette) {
        let painter = self.painter();
        let azimuth = session.section_azimuth_deg().to_radians();
        for arrow in arrows {
            let share = Channel::Luminance.of(arrow.flux);
            let angle = polar::signed_angle(arrow.direction, azimuth);
            let (from, to) = (self.position(0.0, 0.0), self.position(share, angle));
            draw::arrow(&painter, from, to, palette.delta);
            // Beside a long arrow, beyond the tip of a short one: either way clear of the horizon's numbers.
            let place = if share > 0.4 { self.position(0.45 * share, angle) } else { self.position(share + 0.2, angle) };
            let outwards = vec2(if angle > 0.0 { 10.0 } else { -10.0 }, 0.0);
            let anchor = if angle > 0.0 { Align2::LEFT_CENTER } else { Align2::RIGHT_CENTER };
            let text = format!("delta {share:.3}");
            let place = place + outwards;
            draw::haloed_text(&painter, place, anchor, &text, draw::body_font(self.ui), palette.delta, palette);
        }
    }
}

/// The handle of the held direction. Returns whether it is being dragged.
fn drag_held(ui: &Ui, cx: &mut ViewContext<'_>, transform: &PlotTransform) -> bool {
    let azimuth = cx.session.section_azimuth_deg().to_radians();
    let angle = polar::signed_angle(cx.session.held(), azimuth);
    let [x, y] = at(1.0, angle);
    let tip = transform.position_from_point(&PlotPoint::new(x, y));
    let handle = draw::handle(ui, tip, ui.scope_id().with("held"), "Held direction in the polar plot", cx.palette.held(cx.session.hold), cx.palette);
    if let Some(pointer) = handle.interact_pointer_pos().filter(|_| handle.dragged()) {
        let place = transform.value_from_position(pointer);
        let angle = place.x.atan2(place.y);
        if cx.session.section_holds_held() {
            cx.session.set_held(polar::direction(angle, azimuth));
        } else {
            cx.session.theta_deg = (angle.abs().to_degrees() * 10.0).round() / 10.0;
        }
        ui.ctx().request_repaint();
    }
    handle.dragged()
}

/// The direction and value under the pointer.
fn read_out(ui: &Ui, cx: &mut ViewContext<'_>, plot: &egui::Response, transform: &PlotTransform, radial: &Radial) {
    let Some(pointer) = plot.hover_pos() else {
        return;
    };
    let place = transform.value_from_position(pointer);
    let angle = place.x.atan2(place.y);
    let surface = cx.data.surface(cx.session);
    let request = section_request(cx.session);
    let value = polar::value_at(&Lobe::new(&**surface, cx.session.hold, cx.session.held()), &request, angle);
    let w = polar::direction(angle, request.phi);
    let cursor =
        Cursor { theta_deg: frame::theta(w).to_degrees(), phi_deg: frame::phi(w).to_degrees(), value };
    let painter = ui.painter_at(*transform.frame());
    let position = |radius: f64| {
        let [x, y] = at(radius, angle);
        transform.position_from_point(&PlotPoint::new(x, y))
    };
    painter.line_segment([position(0.0), position(1.0)], (1.0, cx.palette.faint_ink));
    for channel in cx.session.curves.channels() {
        let tip = position(radial.radius(channel.of(value)).min(1.0));
        painter.circle(tip, 4.0, cx.palette.channel(*channel), (1.5, cx.palette.background));
    }
    draw::pointer_note(ui, pointer, *transform.frame(), &draw::cursor_text(&cursor, cx.session), cx.palette);
    *cx.cursor = Some(cursor);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rings_reach_the_peak_and_no_further_than_needed() {
        let point = |f: f64| Point { angle: 0.0, value: [f; 3] };
        let section = |f: f64| Section { upper: vec![point(f)], lower: Vec::new(), peak: f };
        let mut session = Session::default();
        for peak in [0.01, 0.2546, 1.0, 3.7e6] {
            let radial = Radial::of(&session, &section(peak));
            assert!(radial.full >= peak * (1.0 - 1e-9) && radial.full <= 1.7 * peak, "{peak}: {}", radial.full);
            assert!((3..=5).contains(&radial.ticks.len()), "{peak}: {:?}", radial.ticks);
            assert!((radial.radius(*radial.ticks.last().unwrap()) - 1.0).abs() < 1e-9);
        }
        session.scale = RadialScale::Logarithmic { decades: 4.0 };
        let radial = Radial::of(&session, &section(0.2546));
        assert_eq!(radial.ticks.len(), 4);
        assert!((radial.full - 1.0).abs() < 1e-12);
        assert_eq!(Radial::of(&session, &Section::default()).quantity, "share of the flux");
    }

    #[test]
    fn every_shape_of_window_holds_the_circle() {
        for size in [vec2(480.0, 360.0), vec2(300.0, 700.0), vec2(900.0, 200.0)] {
            for has_lower in [false, true] {
                let bounds = window(size, has_lower);
                let ([left, low], [right, high]) = (bounds.min(), bounds.max());
                assert!(left <= -1.399 && right >= 1.399 && high >= 1.269, "{size:?}");
                assert!(low <= if has_lower { -1.269 } else { -0.159 }, "{size:?}");
                let shape = (right - left) / (high - low);
                assert!((shape / f64::from(size.x / size.y) - 1.0).abs() < 1e-6, "circles are round");
            }
        }
    }

    #[test]
    fn angles_run_from_n_to_the_right() {
        let [x, y] = at(1.0, FRAC_PI_2);
        assert!((x - 1.0).abs() < 1e-15 && y.abs() < 1e-15);
        assert_eq!(at(1.0, 0.0), [0.0, 1.0]);
    }
}
