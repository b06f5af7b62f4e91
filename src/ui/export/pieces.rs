//! The parts of shapes that are no element of a format by themselves.

use egui::epaint::{BandPoint, BandShape};
use egui::{Color32, ColorImage, Pos2, Rect, StrokeKind, Vec2, emath::Rot2, pos2};

/// The whole of a texture.
pub(super) const WHOLE: Rect = Rect::from_min_max(Pos2::ZERO, pos2(1.0, 1.0));

/// The outlines of a band, one for each stretch of points that ascend in x; what breaks it is left out, as egui does.
pub(super) fn of_band(band: &BandShape) -> Vec<Vec<Pos2>> {
    let is_valid = |point: &BandPoint| point.is_finite() && point.y.min <= point.y.max;
    let inset = match band.stroke_kind {
        _ if band.stroke.is_empty() => 0.0,
        StrokeKind::Inside => 0.5 * band.stroke.width,
        StrokeKind::Middle => 0.0,
        StrokeKind::Outside => -0.5 * band.stroke.width,
    };
    let rotation = Rot2::from_angle(band.angle);
    let at = |x: f32, y: f32| (rotation * Vec2::new(x, y)).to_pos2();
    let points = band.points.as_slice();
    let runs = points.chunk_by(|a, b| is_valid(a) && is_valid(b) && a.x < b.x);
    runs.filter(|run| run.len() > 1)
        .map(|run| {
            let upper = run.iter().map(|point| at(point.x, point.y.min + inset));
            let lower = run.iter().rev();
            let lower = lower.map(|point| at(point.x, point.y.max - inset));
            upper.chain(lower).collect()
        })
        .collect()
}

/// The part `uv` of a picture, each of its colours multiplied by `tint`.
pub(super) fn cropped(image: &ColorImage, uv: Rect, tint: Color32) -> ColorImage {
    if uv == WHOLE && tint == Color32::WHITE {
        return image.clone();
    }
    let [width, height] = image.size;
    let range = |low: f32, high: f32, size: usize| {
        let end = |share: f32| (share.clamp(0.0, 1.0) * size as f32).round() as usize;
        let first = end(low).min(size.saturating_sub(1));
        first..end(high).max(first + 1).min(size)
    };
    let (columns, rows) = (
        range(uv.left(), uv.right(), width),
        range(uv.top(), uv.bottom(), height),
    );
    let pixels = rows.clone().flat_map(|row| {
        let columns = columns.clone();
        columns.filter_map(move |column| image.pixels.get(row * width + column).copied())
    });
    let pixels = pixels.map(|color| color * tint).collect();
    ColorImage::new([columns.len(), rows.len()], pixels)
}

/// How often a triangle of several colours is divided: a side of it is eight long then.
const DIVISIONS: usize = 3;

/// A place and its colour.
type Corner = (Pos2, Color32);

/// Triangles of one colour each that stand for one whose corners have their own.
pub(super) fn shades(corners: [Corner; 3]) -> Vec<([Pos2; 3], Color32)> {
    let mut parts = vec![corners];
    let [a, b, c] = corners.map(|(_, color)| color);
    if a != b || b != c {
        for _ in 0..DIVISIONS {
            parts = parts.into_iter().flat_map(quartered).collect();
        }
    }
    let flat = |part: [Corner; 3]| {
        let [(_, a), (_, b), (_, c)] = part;
        let mean = a.lerp_to_gamma(b, 0.5).lerp_to_gamma(c, 1.0 / 3.0);
        let color = if a == b && b == c { a } else { mean };
        (part.map(|(place, _)| place), color)
    };
    parts.into_iter().map(flat).collect()
}

fn quartered([a, b, c]: [Corner; 3]) -> [[Corner; 3]; 4] {
    let between = |a: Corner, b: Corner| (a.0.lerp(b.0, 0.5), a.1.lerp_to_gamma(b.1, 0.5));
    let (ab, bc, ca) = (between(a, b), between(b, c), between(c, a));
    [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
}
