//! The halves of the sphere with their patches, the discs below them, and what falls.

use std::cmp::Ordering;

use egui::{Align2, Color32, Mesh, Painter, Pos2, Rect, Shape, Stroke, Ui, vec2};
use glam::DVec3;

use super::super::context::Named;
use super::play::Moment;
use super::scene::Scene;
use crate::theme::{Dash, Palette};
use crate::widgets::pictures::ColorScale;
use crate::widgets::{deltas, draw};
use bxdf_lab::analysis::Channel;
use bxdf_lab::analysis::integral::{Part, Sum};

/// Patches that are narrower than this have no edges drawn, in points.
const NARROWEST: f32 = 12.0;

/// Values from this part of the largest on hide what is behind them; smaller ones let it through, the more the smaller.
const OPAQUE: f64 = 0.25;

/// What is left of the colour of a value of 0.
const FAINTEST: f64 = 0.1;

/// Colours from this part of the scale on are bright.
const BRIGHT: f64 = 0.5;

/// How strong edges are on colours.
const EDGE: f32 = 0.5;

/// Axes and sides have names in pictures of a larger radius, in points; directions and deltas in those of a somewhat smaller one.
const NAMED: f32 = 60.0;
const NAMED_DIRECTIONS: f32 = 36.0;

/// How far outside the sphere the held direction ends, in radii.
const HELD: f64 = 1.1;

/// A patch that is turned away counts as if it were seen under this cosine, where one is chosen.
const FACING: f64 = 0.2;

/// A sum, and how it is drawn.
pub(super) struct Figure<'a> {
    pub(super) sum: &'a Sum,
    pub(super) scale: ColorScale,
    pub(super) moment: Moment,
    /// The index of the part that is linked with its shadow.
    pub(super) linked: Option<usize>,
    /// The colour of the material.
    pub(super) color: Color32,
    pub(super) palette: &'a Palette,
}

/// What lies over one another, from below: areas without lines between them are one mesh.
#[derive(Default)]
struct Layers {
    shapes: Vec<Shape>,
    mesh: Mesh,
}

impl Layers {
    fn add(&mut self, shape: Shape) {
        self.end_mesh();
        self.shapes.push(shape);
    }

    fn end_mesh(&mut self) {
        if !self.mesh.is_empty() {
            self.shapes
                .push(Shape::mesh(std::mem::take(&mut self.mesh)));
        }
    }

    fn all(mut self) -> Vec<Shape> {
        self.end_mesh();
        self.shapes
    }
}

/// The luminance of a value.
pub(super) fn luminance(part: &Part) -> f64 {
    Channel::Luminance.of(part.value)
}

/// The patch that is linked where none is pointed at: the one that fell last, in the end the one that adds most.
pub(super) fn linked(sum: &Sum, moment: Moment, eye: DVec3) -> Option<usize> {
    if moment.is_playing() {
        let total = sum.parts.len() + sum.deltas.len();
        return moment.counted(total).checked_sub(1);
    }
    // Of those that add about as much, one that is well seen.
    let rank = |part: &Part| luminance(part) * part.patch.middle().dot(eye).max(FACING);
    let ranks = sum.parts.iter().map(rank).enumerate();
    let lit = ranks.filter(|(_, rank)| *rank > 0.0);
    let most = lit.max_by(|(_, a), (_, b)| a.total_cmp(b));
    most.map(|(index, _)| index)
}

impl Figure<'_> {
    /// The parts of one half, with their indices.
    fn parts(&self, is_upper: bool) -> impl Iterator<Item = (usize, &Part)> {
        let parts = self.sum.parts.iter().enumerate();
        parts.filter(move |(_, part)| part.patch.is_upper == is_upper)
    }

    fn total(&self) -> usize {
        self.sum.parts.len() + self.sum.deltas.len()
    }

    fn fallen(&self, index: usize) -> f64 {
        self.moment.fallen(index, self.total())
    }

    /// One half with its disc, at this moment.
    pub(super) fn shapes(&self, scene: &Scene) -> Vec<Shape> {
        let mut layers = Layers::default();
        self.draw_disc(&mut layers, scene);
        self.draw_dome(&mut layers, scene);
        for (index, part) in self.parts(scene.is_upper) {
            let share = self.fallen(index);
            if luminance(part) > 0.0 && share > 0.0 && share < 1.0 {
                let color = self.scale.color(luminance(part));
                scene.add_area(&mut layers.mesh, &part.patch, share, color);
            }
        }
        layers.all()
    }

    /// Whether there is room for the edges of patches.
    fn has_edges(&self, scene: &Scene) -> bool {
        let solid_angle = std::f64::consts::TAU / self.sum.grid.count() as f64;
        scene.radius() * solid_angle.sqrt() as f32 > NARROWEST
    }

    /// Draws the edges of a patch that has fallen this far, as they are seen on its colour. About n, where many meet, those
    /// along meridians are faint.
    fn draw_edges(&self, layers: &mut Layers, scene: &Scene, part: &Part, fallen: f64) {
        let share = self.scale.share(luminance(part));
        let is_clear = share < OPAQUE && fallen < 1.0 || luminance(part) == 0.0;
        let color = if is_clear {
            self.palette.grid
        } else if share > BRIGHT {
            self.palette.contour_on_white.gamma_multiply(EDGE)
        } else {
            self.palette.contour.gamma_multiply(EDGE)
        };
        let [_, high] = part.patch.height;
        let strength = if high >= 1.0 { EDGE } else { 1.0 };
        let strokes = [color, color.gamma_multiply(strength)];
        let edges = scene.edges(&part.patch, fallen).into_iter();
        for (edge, color) in edges.zip(strokes.into_iter().cycle()) {
            layers.add(Shape::line(edge, Stroke::new(0.8, color)));
        }
    }

    fn draw_disc(&self, layers: &mut Layers, scene: &Scene) {
        let ground = self.palette.ground_color();
        layers.add(Shape::convex_polygon(scene.rim(true), ground, Stroke::NONE));
        // Where nothing falls, there is no shadow.
        let has_shadow = |index, part| luminance(part) > 0.0 && self.fallen(index) >= 1.0;
        for (index, part) in self.parts(scene.is_upper) {
            if has_shadow(index, part) {
                let color = self.scale.color(luminance(part));
                scene.add_area(&mut layers.mesh, &part.patch, 1.0, color);
            }
        }
        if self.has_edges(scene) {
            for (index, part) in self.parts(scene.is_upper) {
                if has_shadow(index, part) {
                    self.draw_edges(layers, scene, part, 1.0);
                }
            }
        }
        let rim = Stroke::new(1.2, self.palette.axis);
        layers.add(Shape::closed_line(scene.rim(true), rim));
    }

    fn draw_dome(&self, layers: &mut Layers, scene: &Scene) {
        let rim = Stroke::new(1.2, self.palette.axis);
        layers.add(Shape::closed_line(scene.rim(false), rim));
        let mut parts: Vec<(f64, &Part)> = self
            .parts(scene.is_upper)
            .map(|(_, part)| (part.patch.middle().dot(scene.eye), part))
            .collect();
        parts.sort_by(|(a, _), (b, _)| a.partial_cmp(b).unwrap_or(Ordering::Equal));
        let has_edges = self.has_edges(scene);
        for (_, part) in parts {
            let value = luminance(part);
            let share = self.scale.share(value) / OPAQUE;
            let strength = share.clamp(FAINTEST, 1.0) as f32;
            let color = self.scale.color(value).gamma_multiply(strength);
            scene.add_area(&mut layers.mesh, &part.patch, 0.0, color);
            if has_edges {
                self.draw_edges(layers, scene, part, 0.0);
            }
        }
        layers.add(Shape::line(scene.outline(), rim));
    }

    /// The patch that is linked with its shadow, by lines straight down.
    pub(super) fn draw_link(&self, painter: &Painter, scene: &Scene) {
        let found = self.linked.and_then(|index| self.sum.parts.get(index));
        let Some(part) = found.filter(|part| part.patch.is_upper == scene.is_upper) else {
            return;
        };
        let thin = Stroke::new(0.8, self.palette.ink);
        for corner in [[0.0, 0.0], [0.0, 1.0], [1.0, 0.0], [1.0, 1.0]] {
            let w = part.patch.direction(corner);
            painter.line_segment([scene.place(w), scene.shadow(w)], thin);
        }
        for share in [0.0, 1.0] {
            // Joined, flat ones would end in spikes.
            for edge in scene.edges(&part.patch, share) {
                painter.add(Shape::line(edge, Stroke::new(1.6, self.palette.ink)));
            }
        }
    }

    /// The deltas as points that fall, each with what it adds.
    pub(super) fn draw_deltas(
        &self,
        ui: &Ui,
        painter: &Painter,
        scenes: &[Scene],
        taken: &mut Vec<Rect>,
    ) {
        let first = self.sum.parts.len();
        for (index, point) in self.sum.deltas.iter().enumerate() {
            let is_upper = point.direction.z > 0.0;
            let Some(scene) = scenes.iter().find(|scene| scene.is_upper == is_upper) else {
                continue;
            };
            let (from, to) = (scene.place(point.direction), scene.shadow(point.direction));
            draw::line(painter, [from, to], (1.2, self.color), Dash::Dashed);
            deltas::ring(painter, from, (self.color, self.palette), true);
            let fallen = self.fallen(first + index);
            let at = scene.fallen(point.direction, fallen);
            painter.circle(at, 4.5, self.color, (1.5, self.palette.background));
            if scene.radius() < NAMED_DIRECTIONS {
                continue;
            }
            let beside = at + vec2(deltas::BESIDE_RING, 0.0);
            let text = deltas::label(Channel::Luminance.of(point.share));
            let look = (self.palette.ink, self.palette);
            deltas::write(
                ui,
                painter,
                taken,
                (beside, Align2::LEFT_CENTER),
                &text,
                look,
            );
        }
    }
}

/// The light and the viewer, if there are `directions`, and the axes of the surface at the rims of the discs.
pub(super) fn name_directions(
    ui: &Ui,
    painter: &Painter,
    (scenes, directions): (&[Scene], &[Named]),
    taken: &mut Vec<Rect>,
    palette: &Palette,
) {
    let mut write = |at: Pos2, text: &str, color: Color32| {
        let font = draw::small_font(ui);
        let size = painter.layout_no_wrap(text.to_owned(), font.clone(), color);
        let rect = Align2::CENTER_CENTER.anchor_size(at, size.size());
        let rect = draw::inside(rect, painter.clip_rect());
        taken.push(rect.expand(2.0));
        let centre = (rect.center(), Align2::CENTER_CENTER);
        draw::haloed_text(painter, centre.0, centre.1, text, font, color, palette);
    };
    for scene in scenes {
        if scene.radius() > NAMED {
            for (axis, name) in [(DVec3::X, "s"), (DVec3::Y, "t")] {
                write(scene.shadow(1.09 * axis), name, palette.faint_ink);
            }
        }
        if scenes.len() > 1 && scene.radius() > NAMED {
            let side = if scene.is_upper { "above" } else { "below" };
            write(scene.corner(), side, palette.faint_ink);
        }
        let is_here = |one: &&Named| (one.direction.z > 0.0) == scene.is_upper;
        for one in directions.iter().filter(is_here) {
            let color = one.color;
            // The sum is over the other one: it is a point among those that are summed up.
            let reach = if one.is_held { HELD } else { 1.0 };
            let ends = [DVec3::ZERO, reach * one.direction].map(|w| scene.place(w));
            if one.is_held {
                painter.line_segment(ends, (1.6, color));
            }
            painter.circle(ends[1], 4.5, color, (1.5, palette.background));
            let least = if one.is_held { NAMED_DIRECTIONS } else { NAMED };
            if scene.radius() < least {
                continue;
            }
            let (name, ink) = (one.name, palette.text_in(color));
            let galley = painter.layout_no_wrap(name.to_owned(), draw::small_font(ui), ink);
            let aside = deltas::BESIDE_RING + 0.5 * galley.size().x;
            let outwards = vec2(aside * (ends[1] - ends[0]).x.signum(), 0.0);
            let upwards = vec2(0.0, -galley.size().y);
            // Beside the handle or above it, else towards the middle: never over it.
            let mut places = [outwards, upwards, -outwards]
                .map(|by| ends[1] + by)
                .into_iter();
            let has_room = |place: &Pos2| {
                let room = Rect::from_center_size(*place, galley.size() + vec2(6.0, 2.0));
                painter.clip_rect().contains_rect(room)
            };
            if let Some(place) = places.find(has_room) {
                write(place, name, ink);
            }
        }
    }
}
