//! The words of the format: numbers, places, paths and paints.

use std::fmt::Write as _;

use egui::{Color32, Pos2, Rect, Stroke};

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

/// A colour as an attribute. One that is added to what lies under it, as egui tints rows of tables, is a veil of its hue:
/// the format has no adding.
pub(super) fn paint(what: &str, color: Color32) -> String {
    let [r, g, b, alpha] = match color.to_array() {
        [r, g, b, 0] => {
            let most = r.max(g).max(b);
            let scaled = |x: u8| (f32::from(x) * 255.0 / f32::from(most.max(1))).round() as u8;
            [scaled(r), scaled(g), scaled(b), most]
        }
        _ => color.to_srgba_unmultiplied(),
    };
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
