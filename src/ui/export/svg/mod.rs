//! What egui has painted as a vector drawing: lines stay lines, text stays text.

use std::fmt::Write as _;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use egui::epaint::ClippedShape;
use egui::{Color32, ColorImage, CornerRadius, Pos2, Rect, Stroke, Vec2};

use super::runs::Run;
use super::shapes::{self, Canvas, Ink, Pictures, Plate};
use bxdf::error::Result;
use elements::{path_of, place, short, stroked, turned};
use images::png_of;

mod elements;
mod images;
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

/// The drawing of `shapes` on this page, with these pictures.
///
/// # Errors
/// Where a picture cannot be encoded.
pub fn drawing(shapes: &[ClippedShape], page: Page, pictures: Pictures<'_>) -> Result<String> {
    let mut writer = Writer {
        text: String::new(),
        pending: None,
        clips: 0,
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
    writer.element("rect", &place(page), Ink::filled(background));
    shapes::draw(&mut writer, shapes, page, pictures)?;
    writer.end_clip();
    writer.text += "</svg>\n";
    Ok(writer.text)
}

struct Writer {
    text: String,
    /// Lines of one stroke that follow one another, as one path.
    pending: Option<(Stroke, String)>,
    /// How many clips there were; the last one is open.
    clips: usize,
}

impl Writer {
    /// Writes the lines that wait.
    fn flush(&mut self) {
        if let Some((stroke, d)) = self.pending.take() {
            let d = format!("d=\"{d}\" stroke-linejoin=\"round\"");
            let ink = Ink {
                fill: Color32::TRANSPARENT,
                stroke,
            };
            self.element("path", &d, ink);
        }
    }

    /// An element with a fill and a stroke, over all before it.
    fn element(&mut self, name: &str, geometry: &str, ink: Ink) {
        self.flush();
        let _ = writeln!(
            self.text,
            "<{name} {geometry} {}{}/>",
            elements::paint("fill", ink.fill),
            stroked(ink.stroke)
        );
    }

    fn end_clip(&mut self) {
        self.flush();
        if self.clips > 0 {
            self.text += "</g>\n";
        }
    }
}

impl Canvas for Writer {
    fn clip(&mut self, inside: Rect) {
        self.end_clip();
        let number = self.clips;
        self.clips += 1;
        let _ = writeln!(
            self.text,
            "<clipPath id=\"c{number}\"><rect {}/></clipPath>\n<g clip-path=\"url(#c{number})\">",
            place(inside)
        );
    }

    /// A line, joined to those of its stroke before it.
    fn line(&mut self, points: &[Pos2], stroke: Stroke) {
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

    fn area(&mut self, outlines: &[Vec<Pos2>], is_closed: bool, ink: Ink) {
        let close = if is_closed { "Z" } else { "" };
        let d: String = outlines
            .iter()
            .map(|outline| path_of(outline) + close)
            .collect();
        self.element("path", &format!("d=\"{d}\""), ink);
    }

    fn ellipse(&mut self, centre: Pos2, radius: Vec2, angle: f32, ink: Ink) {
        let (x, y) = (short(centre.x), short(centre.y));
        if radius.x == radius.y {
            let geometry = format!("cx=\"{x}\" cy=\"{y}\" r=\"{}\"", short(radius.x));
            self.element("circle", &geometry, ink);
            return;
        }
        let geometry = format!(
            "cx=\"{x}\" cy=\"{y}\" rx=\"{}\" ry=\"{}\"{}",
            short(radius.x),
            short(radius.y),
            turned(angle, centre)
        );
        self.element("ellipse", &geometry, ink);
    }

    fn plate(&mut self, plate: &Plate, ink: Ink) {
        let turn = turned(plate.angle, plate.rect.center());
        let blur = if plate.blur > 0.0 {
            format!(" style=\"filter:blur({}px)\"", short(0.5 * plate.blur))
        } else {
            String::new()
        };
        let corners = plate.corners;
        if corners.is_same() {
            let mut geometry = place(plate.rect);
            if corners != CornerRadius::ZERO {
                let _ = write!(geometry, " rx=\"{}\"", corners.nw);
            }
            self.element("rect", &(geometry + &turn + &blur), ink);
        } else {
            let d = elements::rounded(plate.rect, corners);
            self.element("path", &format!("d=\"{d}\"{turn}{blur}"), ink);
        }
    }

    fn image(&mut self, rect: Rect, angle: f32, image: &ColorImage) -> Result<()> {
        self.flush();
        let data = STANDARD.encode(png_of(image)?);
        let _ = writeln!(
            self.text,
            "<image {}{} preserveAspectRatio=\"none\" xlink:href=\"data:image/png;base64,{data}\"/>",
            place(rect),
            turned(angle, rect.center())
        );
        Ok(())
    }

    fn text(&mut self, run: &Run, angle: f32, pivot: Pos2) {
        self.flush();
        self.stretch(run, angle, pivot);
    }
}

#[cfg(test)]
mod tests;
