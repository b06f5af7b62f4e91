//! Shapes on a page.

use egui::{Color32, ColorImage, Pos2, Rect, Stroke, Vec2};
use krilla::color::rgb;
use krilla::geom::{Path, Size, Transform};
use krilla::image::Image;
use krilla::num::NormalizedF32;
use krilla::paint::{Fill, FillRule, LineCap, LineJoin};
use krilla::surface::Surface;

use super::faces::Faces;
use super::paths;
use crate::export::runs::Run;
use crate::export::shapes::{Canvas, Ink, Plate, straight};
use bxdf::error::Result;

/// What draws on a page.
pub(super) struct Writer<'a, 'page> {
    pub(super) surface: &'a mut Surface<'page>,
    pub(super) faces: &'a mut Faces,
    /// Whether what is drawn is clipped.
    is_clipped: bool,
}

impl<'a, 'page> Writer<'a, 'page> {
    /// Begins to draw on a page.
    pub(super) fn new(surface: &'a mut Surface<'page>, faces: &'a mut Faces) -> Self {
        Self {
            surface,
            faces,
            is_clipped: false,
        }
    }

    /// Leaves the page as it is found.
    pub(super) fn end(&mut self) {
        if std::mem::take(&mut self.is_clipped) {
            self.surface.pop();
        }
    }

    fn path(&mut self, path: Option<Path>, ink: Ink) {
        let Some(path) = path else { return };
        self.surface.set_fill(fill(ink.fill));
        self.surface.set_stroke(stroke(ink.stroke));
        self.surface.draw_path(&path);
    }

    /// Draws what is turned by `angle`, in radians clockwise, about `pivot`.
    pub(super) fn turned(&mut self, angle: f32, pivot: Pos2, draw: impl FnOnce(&mut Self)) {
        let turn = Transform::from_rotate_at(angle.to_degrees(), pivot.x, pivot.y);
        self.surface.push_transform(&turn);
        draw(self);
        self.surface.pop();
    }
}

/// What fills an area; nothing where it is seen through altogether.
pub(super) fn fill(color: Color32) -> Option<Fill> {
    let (color, opacity) = paint(color)?;
    Some(Fill {
        paint: color.into(),
        opacity,
        rule: FillRule::NonZero,
    })
}

/// A line with round joints; nothing where there is none.
pub(super) fn stroke(stroke: Stroke) -> Option<krilla::paint::Stroke> {
    if stroke.is_empty() {
        return None;
    }
    let (color, opacity) = paint(stroke.color)?;
    Some(krilla::paint::Stroke {
        paint: color.into(),
        width: stroke.width,
        line_cap: LineCap::Butt,
        line_join: LineJoin::Round,
        opacity,
        ..krilla::paint::Stroke::default()
    })
}

fn paint(color: Color32) -> Option<(rgb::Color, NormalizedF32)> {
    let [r, g, b, alpha] = straight(color);
    let opacity = NormalizedF32::new(f32::from(alpha) / 255.0)?;
    (alpha > 0).then(|| (rgb::Color::new(r, g, b), opacity))
}

impl Canvas for Writer<'_, '_> {
    fn clip(&mut self, inside: Rect) {
        self.end();
        if let Some(path) = paths::plate(inside, egui::CornerRadius::ZERO) {
            self.surface.push_clip_path(&path, &FillRule::NonZero);
            self.is_clipped = true;
        }
    }

    fn line(&mut self, points: &[Pos2], stroke: Stroke) {
        let ink = Ink {
            fill: Color32::TRANSPARENT,
            stroke,
        };
        self.path(paths::outlines(&[points.to_vec()], false), ink);
    }

    fn area(&mut self, outlines: &[Vec<Pos2>], is_closed: bool, ink: Ink) {
        self.path(paths::outlines(outlines, is_closed), ink);
    }

    fn ellipse(&mut self, centre: Pos2, radius: Vec2, angle: f32, ink: Ink) {
        let path = paths::ellipse(centre, radius);
        self.turned(angle, centre, |page| page.path(path, ink));
    }

    /// Pages have nothing that fades: a shadow is left out.
    fn plate(&mut self, plate: &Plate, ink: Ink) {
        if plate.blur == 0.0 {
            let path = paths::plate(plate.rect, plate.corners);
            self.turned(plate.angle, plate.rect.center(), |page| {
                page.path(path, ink);
            });
        }
    }

    fn image(&mut self, rect: Rect, angle: f32, image: &ColorImage) -> Result<()> {
        let [width, height] = image.size.map(|side| side as u32);
        let Some(size) = Size::from_wh(rect.width(), rect.height()) else {
            return Ok(());
        };
        let pixels = image.pixels.iter();
        let bytes = pixels.flat_map(Color32::to_srgba_unmultiplied);
        let image = Image::from_rgba8(bytes.collect(), width, height);
        self.turned(angle, rect.center(), |page| {
            let corner = Transform::from_translate(rect.left(), rect.top());
            page.surface.push_transform(&corner);
            page.surface.draw_image(image, size);
            page.surface.pop();
        });
        Ok(())
    }

    fn text(&mut self, run: &Run, angle: f32, pivot: Pos2) {
        self.turned(angle, pivot, |page| page.stretch(run));
    }
}
