//! Snell's triangles: the rays as long as the index of their side, so that n sin θ is a leg of the same length on both.

use std::cell::RefCell;

use egui::text::LayoutJob;
use egui::{Align2, Color32, Painter, Pos2, Rect, Shape, Ui, pos2, vec2};

use super::curves::Look;
use super::words::{index_text, with_subscripts};
use crate::theme::{self, Dash};
use crate::widgets::{deltas, draw};
use bxdf::math::frame;
use bxdf_lab::analysis::Channel;
use bxdf_lab::analysis::fresnel::{Curve, Fresnel};
use bxdf_study::format;

/// The radius of the larger circle as a part of the smaller side.
const RADIUS: f32 = 0.38;

/// Beyond this ratio of the indices the smaller triangle could not be seen: rays are equally long then.
const LARGEST_RATIO: f64 = 4.0;

/// The radius of the arcs of angles as a part of the larger circle's.
const ARC: f32 = 0.22;

/// The length of the head of a ray, in points.
const HEAD: f32 = 10.0;

/// Between a ray and its name, in points.
const GAP: f32 = 4.0;

/// How strong the lower medium and the circles are.
const STRENGTHS: [f32; 2] = [0.5, 0.6];

/// The picture of the rays.
pub(super) struct Drawing<'a> {
    ui: &'a Ui,
    painter: Painter,
    rect: Rect,
    fresnel: &'a Fresnel,
    look: &'a Look<'a>,
    /// The y of the incident side.
    up: f32,
    /// Where texts stand.
    taken: RefCell<Vec<Rect>>,
}

impl<'a> Drawing<'a> {
    /// A picture in `rect`.
    pub(super) fn new(ui: &'a Ui, rect: Rect, fresnel: &'a Fresnel, look: &'a Look<'a>) -> Self {
        Self {
            ui,
            painter: ui.painter_at(rect),
            rect,
            fresnel,
            look,
            up: if fresnel.is_from_below { 1.0 } else { -1.0 },
            taken: RefCell::default(),
        }
    }

    /// Draws it.
    pub(super) fn show(&self) {
        self.media();
        for curve in self.fresnel.curves.iter().take(1) {
            self.incident(curve);
        }
        for curve in &self.fresnel.curves {
            self.refracted(curve);
        }
        let refracted = |curve: &Curve| curve.held.refracted_deg;
        if self
            .fresnel
            .curves
            .iter()
            .all(|curve| refracted(curve).is_none())
        {
            self.say_no_angle();
        }
    }

    /// Whether there is one index, so that there is one triangle on either side.
    fn is_single(&self) -> bool {
        self.fresnel.curves.len() == 1
    }

    fn largest(&self) -> f32 {
        RADIUS * self.rect.width().min(self.rect.height())
    }

    /// The lengths of the rays on the incident side and beyond, in points, where they can be as long as the indices.
    fn to_scale(&self, curve: &Curve) -> Option<[f32; 2]> {
        let [n_i, n_t] = curve.sides(self.fresnel.is_from_below);
        let is_seen = (1.0 / LARGEST_RATIO..=LARGEST_RATIO).contains(&(n_t / n_i));
        let is_drawn = is_seen && self.is_single() && !self.fresnel.is_absorbing;
        is_drawn.then(|| [n_i, n_t].map(|n| self.largest() * (n / n_i.max(n_t)) as f32))
    }

    /// A place at `radius` and an angle from the normal, above 0 to the right, on the incident side or beyond.
    fn place(&self, radius: f32, angle_deg: f64, is_beyond: bool) -> Pos2 {
        let (cos, sin) = frame::cos_sin_deg(angle_deg);
        let up = if is_beyond { -self.up } else { self.up };
        self.rect.center() + radius * vec2(sin as f32, up * cos as f32)
    }

    /// Writes a text at the first of the places where it covers no other, if there is one.
    fn write(&self, job: LayoutJob, places: &[(Pos2, Align2)]) {
        let galley = self.painter.layout_job(job);
        let mut taken = self.taken.borrow_mut();
        let rect = |(at, anchor): &(Pos2, Align2)| {
            draw::inside(anchor.anchor_size(*at, galley.size()), self.rect)
        };
        let is_free = |rect: &Rect| taken.iter().all(|other| !other.intersects(*rect));
        if let Some(rect) = places.iter().map(rect).find(is_free) {
            taken.push(rect);
            self.painter.galley(rect.min, galley, self.look.palette.ink);
        }
    }

    /// The surface, its normal, and the indices of both sides.
    fn media(&self) {
        let (rect, palette) = (self.rect, self.look.palette);
        let [medium, _] = STRENGTHS;
        let surface = rect.left_center();
        let below = Rect::from_min_max(surface, rect.max);
        self.painter
            .rect_filled(below, 0.0, palette.grid.gamma_multiply(medium));
        self.painter
            .hline(rect.x_range(), surface.y, (1.5, palette.axis));
        let ends = [rect.center_top(), rect.center_bottom()];
        draw::line(&self.painter, ends, (1.0, palette.faint_ink), Dash::Dashed);
        let margin = vec2(GAP, GAP);
        let write = |text: &str, color, at, anchor| {
            self.write(with_subscripts(self.ui, text, color), &[(at, anchor)]);
        };
        let top = rect.left_top() + margin;
        write("n = 1", palette.ink, top, Align2::LEFT_TOP);
        let mut bottom = rect.left_bottom() + vec2(margin.x, -margin.y);
        for curve in self.fresnel.curves.iter().rev() {
            let symbol = curve.channel.and_then(Channel::symbol).unwrap_or("n");
            let color = curve.channel.map(|_| self.look.channel(curve.channel));
            let text = format!("{symbol} = {}", index_text(curve.index));
            let color = color.unwrap_or(palette.ink);
            write(&text, color, bottom, Align2::LEFT_BOTTOM);
            bottom.y -= draw::small_font(self.ui).size + 2.0 * GAP;
        }
    }

    /// The incident light and the reflected light.
    fn incident(&self, curve: &Curve) {
        let (theta, palette) = (self.fresnel.theta_deg, self.look.palette);
        let length = self
            .to_scale(curve)
            .map_or_else(|| self.largest(), |[near, _]| near);
        let (center, color) = (self.rect.center(), self.look.held);
        let [from, mirrored] = [-theta, theta].map(|angle| self.place(length, angle, false));
        self.circle(length, false);
        if self.to_scale(curve).is_some() {
            // The same n sin θ beyond: where it meets the other circle is the light that goes on.
            let ends = [
                mirrored,
                pos2(mirrored.x, center.y - self.up * self.largest()),
            ];
            draw::line(&self.painter, ends, (1.0, palette.axis), Dash::Dashed);
            self.leg(from, color, "n_i sin θ_i");
        }
        self.ray([center, mirrored], mirrored, palette.mirror);
        let middle = from + 0.6 * (center - from);
        self.ray([from, center], middle, color);
        self.arc([-theta, 0.0], false, color);
        let name = format!("θ_i {}", format::degrees(theta));
        self.name_ray(&name, from, color);
    }

    /// Why no light goes on.
    fn say_no_angle(&self) {
        let text = with_subscripts(self.ui, "no real angle", self.look.palette.ink);
        let (middle, aside) = (self.place(0.5 * self.largest(), 0.0, true), vec2(GAP, 0.0));
        let places = [
            (middle - aside, Align2::RIGHT_CENTER),
            (middle + aside, Align2::LEFT_CENTER),
        ];
        self.write(text, &places);
    }

    /// The light that goes on, if any does.
    fn refracted(&self, curve: &Curve) {
        let color = self.look.channel(curve.channel);
        let scaled = self.to_scale(curve);
        let length = scaled.map_or_else(|| self.largest(), |[_, far]| far);
        if scaled.is_some() {
            self.circle(length, true);
        }
        let Some(refracted) = curve.held.refracted_deg else {
            return;
        };
        let to = self.place(length, refracted, true);
        if scaled.is_some() {
            self.leg(to, color, "n_t sin θ_t");
        }
        self.ray([self.rect.center(), to], to, color);
        if self.is_single() {
            self.arc([0.0, refracted], true, color);
            self.name_ray(&format!("θ_t {refracted:.1}°"), to, color);
        }
    }

    /// Half a circle about the point of incidence.
    fn circle(&self, radius: f32, is_beyond: bool) {
        let places = (-45..=45).map(|step| self.place(radius, 2.0 * f64::from(step), is_beyond));
        let [_, strength] = STRENGTHS;
        let color = self.look.palette.axis.gamma_multiply(strength);
        self.painter
            .add(Shape::line(places.collect(), (1.0, color)));
    }

    /// The leg of the triangle from the normal to `tip`.
    fn leg(&self, tip: Pos2, color: Color32, name: &str) {
        let foot = pos2(self.rect.center().x, tip.y);
        let stroke = (theme::CURVE_WIDTH, color);
        self.painter.line_segment([foot, tip], stroke);
        let job = with_subscripts(self.ui, name, color);
        let width = self.painter.layout_job(job.clone()).size().x;
        if (tip.x - foot.x).abs() > width {
            let middle = foot + 0.5 * (tip - foot);
            let outwards = (tip.y - self.rect.center().y).signum();
            let (anchor, inner) = if outwards < 0.0 {
                (Align2::CENTER_BOTTOM, Align2::CENTER_TOP)
            } else {
                (Align2::CENTER_TOP, Align2::CENTER_BOTTOM)
            };
            let gap = vec2(0.0, outwards * GAP);
            self.write(job, &[(middle + gap, anchor), (middle - gap, inner)]);
        }
    }

    /// A ray with its head at a place of it.
    fn ray(&self, ends: [Pos2; 2], head: Pos2, color: Color32) {
        let stroke = (theme::CURVE_WIDTH, color);
        self.painter.line_segment(ends, stroke);
        let [from, _] = ends;
        deltas::head(&self.painter, [from, head], HEAD, color);
    }

    /// The name of a ray beyond its end.
    fn name_ray(&self, name: &str, tip: Pos2, color: Color32) {
        let off = tip - self.rect.center();
        let outwards = vec2(off.x.signum(), off.y.signum());
        let is_left = outwards.x < 0.0;
        let anchor = |at_side: bool, is_up: bool| match (at_side, is_left, is_up) {
            (true, true, true) => Align2::RIGHT_BOTTOM,
            (true, true, false) => Align2::RIGHT_TOP,
            (true, false, true) => Align2::LEFT_BOTTOM,
            (true, false, false) => Align2::LEFT_TOP,
            (false, _, true) => Align2::CENTER_BOTTOM,
            (false, _, false) => Align2::CENTER_TOP,
        };
        let is_up = outwards.y < 0.0;
        let (aside, along) = (vec2(outwards.x, 0.0) * GAP, vec2(0.0, outwards.y) * GAP);
        let places = [
            (tip + aside, anchor(true, is_up)),
            (tip + aside, anchor(true, !is_up)),
            (tip + along, anchor(false, is_up)),
        ];
        self.write(with_subscripts(self.ui, name, color), &places);
    }

    /// The arc between two angles.
    fn arc(&self, [low, high]: [f64; 2], is_beyond: bool, color: Color32) {
        const STEPS: u8 = 24;
        let at = |step: u8| low + (high - low) * f64::from(step) / f64::from(STEPS);
        let radius = ARC * self.largest();
        let places = (0..=STEPS).map(|step| self.place(radius, at(step), is_beyond));
        self.painter
            .add(Shape::line(places.collect(), (1.0, color)));
    }
}
