//! Outlines as pages have them.

use egui::{CornerRadius, Pos2, Rect, Vec2, pos2};
use krilla::geom::{Path, PathBuilder};

/// Where the handles of a curve stand that is a quarter of a circle, as a part of its radius from either end.
const QUARTER: f32 = 0.552_284_7;

/// Lines through points, each outline by itself; one breaks at a point that is no place. `None` where nothing is left.
pub(super) fn outlines(outlines: &[Vec<Pos2>], is_closed: bool) -> Option<Path> {
    let mut builder = PathBuilder::new();
    for outline in outlines {
        for stretch in outline.split(|point| !point.is_finite()) {
            let [first, rest @ ..] = stretch else {
                continue;
            };
            builder.move_to(first.x, first.y);
            for point in rest {
                builder.line_to(point.x, point.y);
            }
            if is_closed {
                builder.close();
            }
        }
    }
    builder.finish()
}

/// An ellipse with upright axes.
pub(super) fn ellipse(centre: Pos2, radius: Vec2) -> Option<Path> {
    let rect = Rect::from_center_size(centre, 2.0 * radius);
    rounded(rect, [radius; 4])
}

/// A rectangle with round corners.
pub(super) fn plate(rect: Rect, corners: CornerRadius) -> Option<Path> {
    let most = 0.5 * rect.width().min(rect.height());
    let CornerRadius { nw, ne, se, sw } = corners;
    rounded(
        rect,
        [nw, ne, se, sw].map(|radius| Vec2::splat(f32::from(radius).min(most))),
    )
}

/// A rectangle whose corners are quarters of ellipses with these radii: from the upper left one on, clockwise.
fn rounded(rect: Rect, [nw, ne, se, sw]: [Vec2; 4]) -> Option<Path> {
    let mut builder = PathBuilder::new();
    let Rect { min, max } = rect;
    builder.move_to(min.x + nw.x, min.y);
    let corners = [
        (
            pos2(max.x - ne.x, min.y),
            pos2(max.x, min.y),
            pos2(max.x, min.y + ne.y),
        ),
        (pos2(max.x, max.y - se.y), max, pos2(max.x - se.x, max.y)),
        (
            pos2(min.x + sw.x, max.y),
            pos2(min.x, max.y),
            pos2(min.x, max.y - sw.y),
        ),
        (pos2(min.x, min.y + nw.y), min, pos2(min.x + nw.x, min.y)),
    ];
    for (from, corner, to) in corners {
        builder.line_to(from.x, from.y);
        if from != to {
            let [a, b] = [from, to].map(|end| end.lerp(corner, QUARTER));
            builder.cubic_to(a.x, a.y, b.x, b.y, to.x, to.y);
        }
    }
    builder.close();
    builder.finish()
}
