//! The words of the format: numbers, places, paths and paints.

use std::fmt::Write as _;

use egui::{Color32, CornerRadius, Pos2, Rect, Stroke};

use crate::export::shapes::straight;

/// A length to a hundredth of a point, as short as it goes.
pub(super) fn short(x: f32) -> String {
    decimals::<2>(x)
}

/// A number with so many decimals, as short as it goes; 0 where it is no number.
fn decimals<const N: usize>(x: f32) -> String {
    let x = if x.is_finite() { x } else { 0.0 };
    let text = format!("{x:.N$}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" {
        "0".to_owned()
    } else {
        text.to_owned()
    }
}

/// A path through `points`. It breaks at a point that is no place, as a reader would stop there.
pub(super) fn path_of(points: &[Pos2]) -> String {
    let mut d = String::new();
    let mut is_first = true;
    for point in points {
        if !point.is_finite() {
            is_first = true;
            continue;
        }
        let letter = if is_first { 'M' } else { 'L' };
        is_first = false;
        // Writing to a string cannot fail.
        let _ = write!(d, "{letter}{} {}", short(point.x), short(point.y));
    }
    d
}

pub(super) fn place(rect: Rect) -> String {
    format!(
        "x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"",
        short(rect.left()),
        short(rect.top()),
        short(rect.width()),
        short(rect.height())
    )
}

/// A turn by `angle`, in radians clockwise, about `pivot`; nothing where there is none.
pub(super) fn turned(angle: f32, pivot: Pos2) -> String {
    if angle == 0.0 {
        return String::new();
    }
    format!(
        " transform=\"rotate({} {} {})\"",
        short(angle.to_degrees()),
        short(pivot.x),
        short(pivot.y)
    )
}

/// A colour as an attribute.
pub(super) fn paint(what: &str, color: Color32) -> String {
    let [r, g, b, alpha] = straight(color);
    match alpha {
        0 => format!("{what}=\"none\""),
        255 => format!("{what}=\"#{r:02x}{g:02x}{b:02x}\""),
        _ => format!(
            "{what}=\"#{r:02x}{g:02x}{b:02x}\" {what}-opacity=\"{}\"",
            decimals::<3>(f32::from(alpha) / 255.0)
        ),
    }
}

pub(super) fn stroked(stroke: Stroke) -> String {
    if stroke.is_empty() {
        return String::new();
    }
    format!(
        " {} stroke-width=\"{}\"",
        paint("stroke", stroke.color),
        short(stroke.width)
    )
}

/// Text as XML has it, which has no control characters.
pub(super) fn escaped(text: &str) -> String {
    let shown: String = text
        .chars()
        .map(|c| if c.is_control() { ' ' } else { c })
        .collect();
    shown
        .replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
}

/// The path of a rectangle whose corners are not all as round.
pub(super) fn rounded(rect: Rect, corners: CornerRadius) -> String {
    let most = 0.5 * rect.width().min(rect.height());
    let [nw, ne, se, sw] =
        [corners.nw, corners.ne, corners.se, corners.sw].map(|r| f32::from(r).min(most));
    let [left, right, top, bottom] =
        [rect.left(), rect.right(), rect.top(), rect.bottom()].map(short);
    let arc = |r: f32, x: &str, y: &str| format!("A{} {} 0 0 1 {x} {y}", short(r), short(r));
    let inner = |edge: f32, by: f32| short(edge + by);
    [
        format!("M{} {top}", inner(rect.left(), nw)),
        format!("L{} {top}", inner(rect.right(), -ne)),
        arc(ne, &right, &inner(rect.top(), ne)),
        format!("L{right} {}", inner(rect.bottom(), -se)),
        arc(se, &inner(rect.right(), -se), &bottom),
        format!("L{} {bottom}", inner(rect.left(), sw)),
        arc(sw, &left, &inner(rect.bottom(), -sw)),
        format!("L{left} {}", inner(rect.top(), nw)),
        arc(nw, &inner(rect.left(), nw), &top),
        "Z".to_owned(),
    ]
    .concat()
}
