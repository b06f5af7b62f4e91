//! What egui has painted as a vector drawing: lines stay lines, text stays text.
//!
//! There is no second drawing path: the shapes are those of the window, taken before they become triangles.

use std::fmt::Write as _;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use egui::epaint::{
    CircleShape, ClippedShape, ColorMode, Mesh, PathShape, PathStroke, RectShape, TextShape,
};
use egui::{Color32, ColorImage, Pos2, Rect, Shape, Stroke, Vec2};

use super::{ImageOf, png_of};
use crate::error::Result;

/// The drawing of `shapes` on a page of this size in points; `image_of` knows the pictures among them.
///
/// What is drawn by the graphics processor alone (the 3D lobe) has no shapes and stays empty.
///
/// # Errors
/// Where a picture cannot be encoded.
pub fn drawing(
    shapes: &[ClippedShape],
    size: Vec2,
    background: Color32,
    image_of: ImageOf<'_>,
) -> Result<String> {
    let mut writer = Writer {
        text: String::new(),
        pending: None,
        image_of,
    };
    let (width, height) = (size.x, size.y);
    let page = Rect::from_min_size(Pos2::ZERO, size);
    // Writing to a string cannot fail.
    let _ = writeln!(
        writer.text,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" \
         width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\" font-family=\"Ubuntu, sans-serif\">"
    );
    writer.rect(page, 0.0, background, Stroke::NONE);
    let mut clip = None;
    for (index, clipped) in shapes.iter().enumerate() {
        let inside = clipped.clip_rect.intersect(page);
        if !inside.is_positive() {
            continue;
        }
        if clip != Some(inside) {
            writer.flush();
            if clip.is_some() {
                writer.text += "</g>\n";
            }
            let _ = writeln!(
                writer.text,
                "<clipPath id=\"c{index}\"><rect {}/></clipPath>\n<g clip-path=\"url(#c{index})\">",
                place(inside)
            );
            clip = Some(inside);
        }
        writer.shape(&clipped.shape)?;
    }
    writer.flush();
    if clip.is_some() {
        writer.text += "</g>\n";
    }
    writer.text += "</svg>\n";
    Ok(writer.text)
}

/// By how much the pieces of a curve may leave it, in points.
const FLATNESS: f32 = 0.05;

struct Writer<'a> {
    text: String,
    /// Lines of one stroke that follow one another, as one path.
    pending: Option<(Stroke, String)>,
    image_of: ImageOf<'a>,
}

impl Writer<'_> {
    fn shape(&mut self, shape: &Shape) -> Result<()> {
        if let Shape::LineSegment { points, stroke } = shape {
            self.line(points, *stroke);
            return Ok(());
        }
        if let Shape::Path(PathShape {
            points,
            closed: false,
            fill,
            stroke,
        }) = shape
            && *fill == Color32::TRANSPARENT
        {
            self.line(points, solid(stroke, points));
            return Ok(());
        }
        match shape {
            Shape::Vec(shapes) => return shapes.iter().try_for_each(|shape| self.shape(shape)),
            Shape::Noop | Shape::Callback(_) | Shape::LineSegment { .. } => return Ok(()),
            _ => self.flush(),
        }
        match shape {
            Shape::Circle(circle) => self.circle(circle),
            Shape::Ellipse(ellipse) => {
                let (centre, radius) = (ellipse.center, ellipse.radius);
                self.element(
                    "ellipse",
                    &format!(
                        "cx=\"{}\" cy=\"{}\" rx=\"{}\" ry=\"{}\"",
                        short(centre.x),
                        short(centre.y),
                        short(radius.x),
                        short(radius.y)
                    ),
                    ellipse.fill,
                    ellipse.stroke,
                );
            }
            Shape::Path(path) => {
                let mut d = path_of(&path.points);
                if path.closed {
                    d += "Z";
                }
                let stroke = solid(&path.stroke, &path.points);
                self.element("path", &format!("d=\"{d}\""), path.fill, stroke);
            }
            Shape::Rect(rect) => self.rect_shape(rect)?,
            Shape::Text(text) => self.galley(text),
            Shape::Mesh(mesh) => self.mesh(mesh)?,
            Shape::QuadraticBezier(curve) => {
                self.curve(&curve.flatten(Some(FLATNESS)), curve.fill, &curve.stroke);
            }
            Shape::CubicBezier(curve) => {
                self.curve(&curve.flatten(Some(FLATNESS)), curve.fill, &curve.stroke);
            }
            // Taken above, or painted by nothing in this program.
            Shape::Noop
            | Shape::Vec(_)
            | Shape::LineSegment { .. }
            | Shape::Callback(_)
            | Shape::Band(_) => {}
        }
        Ok(())
    }

    /// A curve through these points.
    fn curve(&mut self, points: &[Pos2], fill: Color32, stroke: &PathStroke) {
        let geometry = format!("d=\"{}\"", path_of(points));
        self.element("path", &geometry, fill, solid(stroke, points));
    }

    /// A line, joined to those of its stroke before it.
    fn line(&mut self, points: &[Pos2], stroke: Stroke) {
        if stroke.width <= 0.0 || stroke.color == Color32::TRANSPARENT || points.len() < 2 {
            return;
        }
        if self
            .pending
            .as_ref()
            .is_none_or(|(other, _)| *other != stroke)
        {
            self.flush();
        }
        let (_, d) = self.pending.get_or_insert_with(|| (stroke, String::new()));
        *d += &path_of(points);
    }

    /// Writes the lines that wait.
    fn flush(&mut self) {
        if let Some((stroke, d)) = self.pending.take() {
            let d = format!("d=\"{d}\" stroke-linejoin=\"round\"");
            self.element("path", &d, Color32::TRANSPARENT, stroke);
        }
    }

    fn element(&mut self, name: &str, geometry: &str, fill: Color32, stroke: Stroke) {
        let _ = writeln!(
            self.text,
            "<{name} {geometry} {}{}/>",
            paint("fill", fill),
            stroked(stroke)
        );
    }

    fn circle(&mut self, circle: &CircleShape) {
        let geometry = format!(
            "cx=\"{}\" cy=\"{}\" r=\"{}\"",
            short(circle.center.x),
            short(circle.center.y),
            short(circle.radius)
        );
        self.element("circle", &geometry, circle.fill, circle.stroke);
    }

    fn rect(&mut self, rect: Rect, radius: f32, fill: Color32, stroke: Stroke) {
        let mut geometry = place(rect);
        if radius > 0.0 {
            let _ = write!(geometry, " rx=\"{}\"", short(radius));
        }
        self.element("rect", &geometry, fill, stroke);
    }

    fn rect_shape(&mut self, shape: &RectShape) -> Result<()> {
        if let Some(brush) = &shape.brush
            && let Some(image) = (self.image_of)(brush.fill_texture_id)
        {
            return self.image(shape.rect, &image);
        }
        let inset = match shape.stroke_kind {
            egui::StrokeKind::Inside => -0.5 * shape.stroke.width,
            egui::StrokeKind::Middle => 0.0,
            egui::StrokeKind::Outside => 0.5 * shape.stroke.width,
        };
        let radius = shape.corner_radius.average();
        if shape.fill != Color32::TRANSPARENT || shape.stroke.width > 0.0 {
            self.rect(shape.rect.expand(inset), radius, shape.fill, shape.stroke);
        }
        Ok(())
    }

    /// Text, row by row. Fonts differ from machine to machine: the length of each row is kept.
    fn galley(&mut self, shape: &TextShape) {
        let Some(section) = shape.galley.job.sections.first() else {
            return;
        };
        let own = match section.format.color {
            Color32::PLACEHOLDER => shape.fallback_color,
            color => color,
        };
        let color = shape
            .override_text_color
            .unwrap_or(own)
            .gamma_multiply(shape.opacity_factor);
        for placed in &shape.galley.rows {
            let text = placed.row.text();
            let (Some(first), false) = (placed.row.glyphs.first(), text.trim().is_empty()) else {
                continue;
            };
            let offset = placed.pos.to_vec2() + first.pos.to_vec2();
            let at = shape.pos + offset;
            let turned = if shape.angle == 0.0 {
                String::new()
            } else {
                let (angle, pivot) = (shape.angle.to_degrees(), shape.pos);
                format!(
                    " transform=\"rotate({} {} {})\"",
                    short(angle),
                    short(pivot.x),
                    short(pivot.y)
                )
            };
            let _ = writeln!(
                self.text,
                "<text x=\"{}\" y=\"{}\" font-size=\"{}\" textLength=\"{}\" lengthAdjust=\"spacingAndGlyphs\"{turned} {}>{}</text>",
                short(at.x),
                short(at.y),
                short(section.format.font_id.size),
                short(placed.row.size.x),
                paint("fill", color),
                escaped(&text)
            );
        }
    }

    /// A picture, or an area of triangles.
    fn mesh(&mut self, mesh: &Mesh) -> Result<()> {
        if let Some(image) = (self.image_of)(mesh.texture_id) {
            return self.image(mesh.calc_bounds(), &image);
        }
        // Triangles of one colour that follow one another are one path.
        let mut run: Option<(Color32, String)> = None;
        for corners in mesh.indices.chunks_exact(3) {
            let corners: Vec<_> = corners
                .iter()
                .filter_map(|index| mesh.vertices.get(*index as usize))
                .collect();
            let [a, b, c] = &corners[..] else { continue };
            if run.as_ref().is_some_and(|(color, _)| *color != a.color) {
                self.fill(run.take());
            }
            let (_, d) = run.get_or_insert_with(|| (a.color, String::new()));
            *d += &path_of(&[a.pos, b.pos, c.pos]);
            d.push('Z');
        }
        self.fill(run);
        Ok(())
    }

    fn fill(&mut self, run: Option<(Color32, String)>) {
        if let Some((color, d)) = run {
            self.element("path", &format!("d=\"{d}\""), color, Stroke::NONE);
        }
    }

    fn image(&mut self, rect: Rect, image: &ColorImage) -> Result<()> {
        let data = STANDARD.encode(png_of(image)?);
        let _ = writeln!(
            self.text,
            "<image {} preserveAspectRatio=\"none\" xlink:href=\"data:image/png;base64,{data}\"/>",
            place(rect)
        );
        Ok(())
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

/// A length to a hundredth of a point, as short as it goes.
fn short(x: f32) -> String {
    let text = format!("{x:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" {
        "0".to_owned()
    } else {
        text.to_owned()
    }
}

fn path_of(points: &[Pos2]) -> String {
    let mut d = String::new();
    for (index, point) in points.iter().enumerate() {
        let letter = if index == 0 { 'M' } else { 'L' };
        let _ = write!(d, "{letter}{} {}", short(point.x), short(point.y));
    }
    d
}

fn place(rect: Rect) -> String {
    format!(
        "x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"",
        short(rect.left()),
        short(rect.top()),
        short(rect.width()),
        short(rect.height())
    )
}

fn paint(what: &str, color: Color32) -> String {
    let [r, g, b, alpha] = color.to_srgba_unmultiplied();
    match alpha {
        0 => format!("{what}=\"none\""),
        255 => format!("{what}=\"#{r:02x}{g:02x}{b:02x}\""),
        _ => format!(
            "{what}=\"#{r:02x}{g:02x}{b:02x}\" {what}-opacity=\"{}\"",
            short(f32::from(alpha) / 255.0)
        ),
    }
}

fn stroked(stroke: Stroke) -> String {
    if stroke.width <= 0.0 || stroke.color == Color32::TRANSPARENT {
        return String::new();
    }
    format!(
        " {} stroke-width=\"{}\"",
        paint("stroke", stroke.color),
        short(stroke.width)
    )
}

/// Text as XML has it.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
}
