//! What egui has painted as a vector drawing: lines stay lines, text stays text.
//!
//! There is no second drawing path: the shapes are those of the window, taken before they become triangles.

use std::fmt::Write as _;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use egui::epaint::{
    BandShape, CircleShape, ClippedShape, ColorMode, EllipseShape, Mesh, PathShape, PathStroke,
    RectShape,
};
use egui::{Color32, ColorImage, CornerRadius, Pos2, Rect, Shape, Stroke, Vec2};

use bxdf::error::Result;
use elements::{path_of, place, short, stroked, turned};
use images::{ImageOf, SceneAt, png_of};

mod elements;
mod images;
mod pieces;
mod text;

/// The page of a drawing.
#[derive(Clone, Copy, Debug)]
pub struct Page {
    /// Width and height in points, which the drawing is made in.
    pub size: Vec2,
    /// The width in print, in millimetres, where it has one.
    pub print_width_mm: Option<f64>,
    /// The colour behind all.
    pub background: Color32,
}

/// What knows the pictures in a drawing.
#[derive(Clone, Copy)]
pub struct Pictures<'a> {
    /// Those behind textures.
    pub of_texture: ImageOf<'a>,
    /// Those of what the graphics processor alone draws (the 3D lobe), which has no shapes.
    pub of_scene: SceneAt<'a>,
}

/// The drawing of `shapes` on this page, with these pictures.
///
/// # Errors
/// Where a picture cannot be encoded.
pub fn drawing(shapes: &[ClippedShape], page: Page, pictures: Pictures<'_>) -> Result<String> {
    let mut writer = Writer {
        text: String::new(),
        pending: None,
        pictures,
    };
    let Page {
        size,
        print_width_mm,
        background,
    } = page;
    let (width, height) = (size.x, size.y);
    let [across, down] = match print_width_mm {
        Some(mm) => [mm, mm * f64::from(height / width)].map(|mm| format!("{mm:.2}mm")),
        None => [width, height].map(|points| points.to_string()),
    };
    let page = Rect::from_min_size(Pos2::ZERO, size);
    // Writing to a string cannot fail.
    let _ = writeln!(
        writer.text,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" \
         width=\"{across}\" height=\"{down}\" viewBox=\"0 0 {width} {height}\" font-family=\"Ubuntu, sans-serif\">"
    );
    writer.element("rect", &place(page), background, Stroke::NONE);
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
    pictures: Pictures<'a>,
}

impl Writer<'_> {
    /// Every kind of shape is named: one that is new to egui does not compile before it has its form here.
    fn shape(&mut self, shape: &Shape) -> Result<()> {
        match shape {
            Shape::Noop => {}
            Shape::Vec(shapes) => shapes.iter().try_for_each(|shape| self.shape(shape))?,
            Shape::LineSegment { points, stroke } => self.line(points, *stroke),
            Shape::Path(path) => self.path(path),
            Shape::Band(band) => self.band(band),
            Shape::Circle(circle) => self.circle(circle),
            Shape::Ellipse(ellipse) => self.ellipse(ellipse),
            Shape::Rect(rect) => self.rect(rect)?,
            Shape::Text(text) => {
                self.flush();
                self.galley(text);
            }
            Shape::Mesh(mesh) => self.mesh(mesh)?,
            Shape::QuadraticBezier(curve) => self.path(&PathShape {
                points: curve.flatten(Some(FLATNESS)),
                closed: curve.closed,
                fill: curve.fill,
                stroke: curve.stroke.clone(),
            }),
            Shape::CubicBezier(curve) => self.path(&PathShape {
                points: curve.flatten(Some(FLATNESS)),
                closed: curve.closed,
                fill: curve.fill,
                stroke: curve.stroke.clone(),
            }),
            Shape::Callback(callback) => {
                if let Some(image) = (self.pictures.of_scene)(callback.rect) {
                    self.image(callback.rect, "", &image)?;
                }
            }
        }
        Ok(())
    }

    /// A line, joined to those of its stroke before it.
    fn line(&mut self, points: &[Pos2], stroke: Stroke) {
        if stroke.is_empty() || points.len() < 2 {
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

    /// An element with a fill and a stroke, over all before it; nothing where both are empty.
    fn element(&mut self, name: &str, geometry: &str, fill: Color32, stroke: Stroke) {
        self.flush();
        if fill == Color32::TRANSPARENT && stroke.is_empty() {
            return;
        }
        let _ = writeln!(
            self.text,
            "<{name} {geometry} {}{}/>",
            elements::paint("fill", fill),
            stroked(stroke)
        );
    }

    fn path(&mut self, path: &PathShape) {
        let stroke = solid(&path.stroke, &path.points);
        if !path.closed && path.fill == Color32::TRANSPARENT {
            self.line(&path.points, stroke);
            return;
        }
        let close = if path.closed { "Z" } else { "" };
        let geometry = format!("d=\"{}{close}\"", path_of(&path.points));
        self.element("path", &geometry, path.fill, stroke);
    }

    /// A band of varying width: its outline, each stretch of ascending x by itself.
    fn band(&mut self, band: &BandShape) {
        let outlines = pieces::of_band(band).into_iter();
        let d: String = outlines.map(|outline| path_of(&outline) + "Z").collect();
        if !d.is_empty() {
            let geometry = format!("d=\"{d}\"");
            self.element("path", &geometry, band.fill, band.stroke);
        }
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

    fn ellipse(&mut self, ellipse: &EllipseShape) {
        let (centre, radius) = (ellipse.center, ellipse.radius);
        let geometry = format!(
            "cx=\"{}\" cy=\"{}\" rx=\"{}\" ry=\"{}\"{}",
            short(centre.x),
            short(centre.y),
            short(radius.x),
            short(radius.y),
            turned(ellipse.angle, centre)
        );
        self.element("ellipse", &geometry, ellipse.fill, ellipse.stroke);
    }

    fn rect(&mut self, shape: &RectShape) -> Result<()> {
        let turn = turned(shape.angle, shape.rect.center());
        let textured = shape.brush.as_ref().filter(|brush| brush.uv != Rect::ZERO);
        let image = textured.and_then(|brush| {
            (self.pictures.of_texture)(brush.fill_texture_id).map(|image| (image, brush.uv))
        });
        let mut fill = shape.fill;
        if let Some((image, uv)) = image {
            self.image(shape.rect, &turn, &pieces::cropped(&image, uv, fill))?;
            fill = Color32::TRANSPARENT;
        }
        let inset = match shape.stroke_kind {
            _ if shape.stroke.is_empty() => 0.0,
            egui::StrokeKind::Inside => -0.5 * shape.stroke.width,
            egui::StrokeKind::Middle => 0.0,
            egui::StrokeKind::Outside => 0.5 * shape.stroke.width,
        };
        let rect = shape.rect.expand(inset);
        let blur = if shape.blur_width > 0.0 {
            format!(
                " style=\"filter:blur({}px)\"",
                short(0.5 * shape.blur_width)
            )
        } else {
            String::new()
        };
        let corners = shape.corner_radius;
        if corners.is_same() {
            let mut geometry = place(rect);
            if corners != CornerRadius::ZERO {
                let _ = write!(geometry, " rx=\"{}\"", corners.nw);
            }
            let geometry = geometry + &turn + &blur;
            self.element("rect", &geometry, fill, shape.stroke);
        } else {
            let geometry = format!("d=\"{}\"{turn}{blur}", pieces::rounded(rect, corners));
            self.element("path", &geometry, fill, shape.stroke);
        }
        Ok(())
    }

    /// A picture, or an area of triangles.
    fn mesh(&mut self, mesh: &Mesh) -> Result<()> {
        if let Some(image) = (self.pictures.of_texture)(mesh.texture_id) {
            let corners = mesh.vertices.iter().map(|vertex| vertex.uv);
            let uv = Rect::from_points(&corners.collect::<Vec<_>>());
            let tint = mesh.vertices.first().map_or(Color32::WHITE, |v| v.color);
            return self.image(mesh.calc_bounds(), "", &pieces::cropped(&image, uv, tint));
        }
        // Triangles of one colour that follow one another are one path.
        let mut run: Option<(Color32, String)> = None;
        for corners in mesh.indices.chunks_exact(3) {
            let corners: Vec<_> = corners
                .iter()
                .filter_map(|index| mesh.vertices.get(*index as usize))
                .collect();
            let [a, b, c] = corners[..] else { continue };
            let corners = [a, b, c].map(|vertex| (vertex.pos, vertex.color));
            for (places, color) in pieces::shades(corners) {
                if run.as_ref().is_some_and(|(other, _)| *other != color) {
                    self.fill(run.take());
                }
                let (_, d) = run.get_or_insert_with(|| (color, String::new()));
                *d += &path_of(&places);
                d.push('Z');
            }
        }
        self.fill(run);
        Ok(())
    }

    fn fill(&mut self, run: Option<(Color32, String)>) {
        if let Some((color, d)) = run {
            self.element("path", &format!("d=\"{d}\""), color, Stroke::NONE);
        }
    }

    fn image(&mut self, rect: Rect, turn: &str, image: &ColorImage) -> Result<()> {
        self.flush();
        let data = STANDARD.encode(png_of(image)?);
        let _ = writeln!(
            self.text,
            "<image {}{turn} preserveAspectRatio=\"none\" xlink:href=\"data:image/png;base64,{data}\"/>",
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

#[cfg(test)]
mod tests;
