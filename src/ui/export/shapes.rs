//! What egui has painted, before it becomes triangles, on a canvas of any format: lines stay lines, text stays text.
//!
//! There is no second drawing path: the shapes are those of the window.

use std::sync::Arc;

use egui::emath::Rot2;
use egui::epaint::{
    BandShape, ClippedShape, ColorMode, Mesh, PathShape, PathStroke, RectShape, TextShape,
};
use egui::{Color32, ColorImage, CornerRadius, Pos2, Rect, Shape, Stroke, TextureId, Vec2};

use super::pieces;
use super::runs::{Run, runs};
use bxdf::error::Result;

/// The picture behind a texture, if it is one of the views'.
pub type ImageOf<'a> = &'a dyn Fn(TextureId) -> Option<Arc<ColorImage>>;

/// The picture of a scene that the graphics processor draws, by the rectangle that it fills.
pub type SceneAt<'a> = &'a dyn Fn(Rect) -> Option<ColorImage>;

/// What knows the pictures in a drawing.
#[derive(Clone, Copy)]
pub struct Pictures<'a> {
    /// Those behind textures.
    pub of_texture: ImageOf<'a>,
    /// Those of what the graphics processor alone draws (the 3D lobe), which has no shapes.
    pub of_scene: SceneAt<'a>,
}

/// How an area looks: the colour that fills it, and the line around it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Ink {
    pub(super) fill: Color32,
    pub(super) stroke: Stroke,
}

impl Ink {
    /// An area without a line around it.
    pub(super) const fn filled(fill: Color32) -> Self {
        Self {
            fill,
            stroke: Stroke::NONE,
        }
    }

    /// Whether there is nothing to see.
    pub(super) fn is_nothing(&self) -> bool {
        self.fill == Color32::TRANSPARENT && self.stroke.is_empty()
    }
}

/// A rectangle with round corners, turned by `angle`, in radians clockwise, about its middle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Plate {
    pub(super) rect: Rect,
    pub(super) corners: CornerRadius,
    pub(super) angle: f32,
    /// How far its edge fades, in points.
    pub(super) blur: f32,
}

/// What shapes are drawn on, one over the other.
pub(super) trait Canvas {
    /// From here on only what lies in this rectangle is seen.
    fn clip(&mut self, inside: Rect);

    /// A line through points; it breaks at one that is no place.
    fn line(&mut self, points: &[Pos2], stroke: Stroke);

    /// An area within outlines that are `is_closed`, or open lines with a fill.
    fn area(&mut self, outlines: &[Vec<Pos2>], is_closed: bool, ink: Ink);

    /// An ellipse turned by `angle`, in radians clockwise.
    fn ellipse(&mut self, centre: Pos2, radius: Vec2, angle: f32, ink: Ink);

    /// A rectangle.
    fn plate(&mut self, plate: &Plate, ink: Ink);

    /// A picture that fills a rectangle, turned as a plate.
    ///
    /// # Errors
    /// Where it cannot be encoded.
    fn image(&mut self, rect: Rect, angle: f32, image: &ColorImage) -> Result<()>;

    /// A stretch of text, turned by `angle`, in radians clockwise, about `pivot`.
    fn text(&mut self, run: &Run, angle: f32, pivot: Pos2);
}

/// By how much the pieces of a curve may leave it, in points.
const FLATNESS: f32 = 0.05;

/// Draws shapes on a canvas that shows `page`.
///
/// # Errors
/// Where a picture cannot be encoded.
pub(super) fn draw(
    canvas: &mut impl Canvas,
    shapes: &[ClippedShape],
    page: Rect,
    pictures: Pictures<'_>,
) -> Result<()> {
    let mut clip = None;
    for clipped in shapes {
        let inside = clipped.clip_rect.intersect(page);
        if !inside.is_positive() {
            continue;
        }
        if clip != Some(inside) {
            canvas.clip(inside);
            clip = Some(inside);
        }
        shape(canvas, &clipped.shape, pictures)?;
    }
    Ok(())
}

/// Every kind of shape is named: one that is new to egui does not compile before it has its form here.
fn shape(canvas: &mut impl Canvas, shape: &Shape, pictures: Pictures<'_>) -> Result<()> {
    match shape {
        Shape::Noop => {}
        Shape::Vec(shapes) => {
            for one in shapes {
                self::shape(canvas, one, pictures)?;
            }
        }
        Shape::LineSegment { points, stroke } => line(canvas, points, *stroke),
        Shape::Path(path) => self::path(canvas, path),
        Shape::Band(band) => self::band(canvas, band),
        Shape::Circle(circle) => {
            let ink = Ink {
                fill: circle.fill,
                stroke: circle.stroke,
            };
            ellipse(canvas, circle.center, Vec2::splat(circle.radius), 0.0, ink);
        }
        Shape::Ellipse(one) => {
            let ink = Ink {
                fill: one.fill,
                stroke: one.stroke,
            };
            ellipse(canvas, one.center, one.radius, one.angle, ink);
        }
        Shape::Rect(rect) => self::rect(canvas, rect, pictures)?,
        Shape::Text(text) => self::text(canvas, text),
        Shape::Mesh(mesh) => self::mesh(canvas, mesh, pictures)?,
        Shape::QuadraticBezier(curve) => path(
            canvas,
            &PathShape {
                points: curve.flatten(Some(FLATNESS)),
                closed: curve.closed,
                fill: curve.fill,
                stroke: curve.stroke.clone(),
            },
        ),
        Shape::CubicBezier(curve) => path(
            canvas,
            &PathShape {
                points: curve.flatten(Some(FLATNESS)),
                closed: curve.closed,
                fill: curve.fill,
                stroke: curve.stroke.clone(),
            },
        ),
        Shape::Callback(callback) => {
            if let Some(image) = (pictures.of_scene)(callback.rect) {
                canvas.image(callback.rect, 0.0, &image)?;
            }
        }
    }
    Ok(())
}

fn text(canvas: &mut impl Canvas, text: &TextShape) {
    for run in runs(text) {
        let (background, beyond) = run.background;
        if background != Color32::TRANSPARENT {
            let rect = run.place.expand(beyond);
            let middle = Rot2::from_angle(text.angle) * (rect.center() - text.pos);
            let plate = Plate {
                rect: Rect::from_center_size(text.pos + middle, rect.size()),
                corners: CornerRadius::ZERO,
                angle: text.angle,
                blur: 0.0,
            };
            canvas.plate(&plate, Ink::filled(background));
        }
        if !run.is_blank() {
            canvas.text(&run, text.angle, text.pos);
        }
    }
}

/// The textures that a shape is painted with.
pub(super) fn textures(shape: &Shape, found: &mut dyn FnMut(TextureId)) {
    match shape {
        Shape::Vec(shapes) => shapes.iter().for_each(|shape| textures(shape, found)),
        Shape::Mesh(mesh) => found(mesh.texture_id),
        Shape::Rect(rect) => rect
            .brush
            .iter()
            .for_each(|brush| found(brush.fill_texture_id)),
        _ => {}
    }
}

fn line(canvas: &mut impl Canvas, points: &[Pos2], stroke: Stroke) {
    if !stroke.is_empty() && points.len() >= 2 {
        canvas.line(points, stroke);
    }
}

fn area(canvas: &mut impl Canvas, outlines: &[Vec<Pos2>], is_closed: bool, ink: Ink) {
    if !ink.is_nothing() && !outlines.is_empty() {
        canvas.area(outlines, is_closed, ink);
    }
}

fn ellipse(canvas: &mut impl Canvas, centre: Pos2, radius: Vec2, angle: f32, ink: Ink) {
    if !ink.is_nothing() {
        canvas.ellipse(centre, radius, angle, ink);
    }
}

fn path(canvas: &mut impl Canvas, path: &PathShape) {
    let stroke = solid(&path.stroke, &path.points);
    if !path.closed && path.fill == Color32::TRANSPARENT {
        line(canvas, &path.points, stroke);
        return;
    }
    let ink = Ink {
        fill: path.fill,
        stroke,
    };
    let outline = std::slice::from_ref(&path.points);
    area(canvas, outline, path.closed, ink);
}

/// A band of varying width: its outline, each stretch of ascending x by itself.
fn band(canvas: &mut impl Canvas, band: &BandShape) {
    let ink = Ink {
        fill: band.fill,
        stroke: band.stroke,
    };
    area(canvas, &pieces::of_band(band), true, ink);
}

fn rect(canvas: &mut impl Canvas, shape: &RectShape, pictures: Pictures<'_>) -> Result<()> {
    let textured = shape.brush.as_ref().filter(|brush| brush.uv != Rect::ZERO);
    let image = textured.and_then(|brush| {
        (pictures.of_texture)(brush.fill_texture_id).map(|image| (image, brush.uv))
    });
    let mut fill = shape.fill;
    if let Some((image, uv)) = image {
        canvas.image(shape.rect, shape.angle, &pieces::cropped(&image, uv, fill))?;
        fill = Color32::TRANSPARENT;
    }
    let inset = match shape.stroke_kind {
        _ if shape.stroke.is_empty() => 0.0,
        egui::StrokeKind::Inside => -0.5 * shape.stroke.width,
        egui::StrokeKind::Middle => 0.0,
        egui::StrokeKind::Outside => 0.5 * shape.stroke.width,
    };
    let ink = Ink {
        fill,
        stroke: shape.stroke,
    };
    if !ink.is_nothing() {
        let plate = Plate {
            rect: shape.rect.expand(inset),
            corners: shape.corner_radius,
            angle: shape.angle,
            blur: shape.blur_width,
        };
        canvas.plate(&plate, ink);
    }
    Ok(())
}

/// A picture, or an area of triangles.
fn mesh(canvas: &mut impl Canvas, mesh: &Mesh, pictures: Pictures<'_>) -> Result<()> {
    if let Some(image) = (pictures.of_texture)(mesh.texture_id) {
        let corners = mesh.vertices.iter().map(|vertex| vertex.uv);
        let uv = Rect::from_points(&corners.collect::<Vec<_>>());
        let tint = mesh.vertices.first().map_or(Color32::WHITE, |v| v.color);
        let image = pieces::cropped(&image, uv, tint);
        return canvas.image(mesh.calc_bounds(), 0.0, &image);
    }
    // Triangles of one colour that follow one another are one area.
    let mut run: (Color32, Vec<Vec<Pos2>>) = (Color32::TRANSPARENT, Vec::new());
    for corners in mesh.indices.chunks_exact(3) {
        let corners: Vec<_> = corners
            .iter()
            .filter_map(|index| mesh.vertices.get(*index as usize))
            .collect();
        let [a, b, c] = corners[..] else { continue };
        let corners = [a, b, c].map(|vertex| (vertex.pos, vertex.color));
        for (places, color) in pieces::shades(corners) {
            if run.0 != color {
                let (color, outlines) = std::mem::replace(&mut run, (color, Vec::new()));
                area(canvas, &outlines, true, Ink::filled(color));
            }
            run.1.push(places.to_vec());
        }
    }
    let (color, outlines) = run;
    area(canvas, &outlines, true, Ink::filled(color));
    Ok(())
}

/// A colour as formats have it, with its opacity. One that is added to what lies under it, as egui tints rows of tables, is a
/// veil of its hue: no format has adding.
pub(super) fn straight(color: Color32) -> [u8; 4] {
    match color.to_array() {
        [r, g, b, 0] => {
            let most = r.max(g).max(b);
            let scaled = |x: u8| (f32::from(x) * 255.0 / f32::from(most.max(1))).round() as u8;
            [scaled(r), scaled(g), scaled(b), most]
        }
        _ => color.to_srgba_unmultiplied(),
    }
}

/// A stroke of one colour; that of its start where it has several.
fn solid(stroke: &PathStroke, points: &[Pos2]) -> Stroke {
    let color = match (&stroke.color, points.first()) {
        (ColorMode::Solid(color), _) => *color,
        (ColorMode::UV(color), Some(first)) => color(Rect::from_points(points), *first),
        (ColorMode::UV(_), None) => Color32::TRANSPARENT,
    };
    Stroke::new(stroke.width, color)
}
