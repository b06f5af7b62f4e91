//! No text lies over another one or over a handle, and none is cut off, in any view.

use brdf_explorer::study::session::{READY_LAYOUTS, Session};
use brdf_explorer::study::views::VIEWS;
use brdf_explorer::ui::app::App;
use egui::{Rect, Shape, Theme};
use egui_kittest::Harness;

use super::figures::{figure, uses};
use super::{SIX, picture, session};

/// The room of a view: the least one, tiles of windows of 1024 by 640, 1280 by 800 and 1920 by 1080, and all of the last.
const SIZES: [[u32; 2]; 5] = [[320, 236], [470, 530], [600, 660], [900, 960], [1640, 960]];

/// The radii of what can be taken hold of, in points: larger circles are grids, smaller ones dots.
const HANDLES: std::ops::Range<f32> = 6.0..14.0;

/// The edge of a text that has no ink, in points.
const EDGE: f32 = 0.75;

/// Views with lists that are scrolled to what is cut off.
const SCROLLED: [&str; 5] = [
    "formula_card",
    "inspector",
    "sampling",
    "stability",
    "tradeoff",
];

/// What is written or can be taken hold of: what it says, where it is, and what of that is seen.
struct Covered {
    text: String,
    rect: Rect,
    seen: Rect,
}

fn covered(harness: &Harness<'_, App>) -> Vec<Covered> {
    fn each(shape: &Shape, seen: Rect, all: &mut Vec<Covered>) {
        let (text, rect) = match shape {
            Shape::Vec(shapes) => return shapes.iter().for_each(|shape| each(shape, seen, all)),
            Shape::Text(text) if text.opacity_factor > 0.0 => {
                let rect = text.visual_bounding_rect().shrink(EDGE);
                (text.galley.text().to_owned(), rect)
            }
            Shape::Circle(circle) if HANDLES.contains(&circle.radius) => {
                ("handle".to_owned(), shape.visual_bounding_rect())
            }
            _ => return,
        };
        if !text.trim().is_empty() && rect.intersects(seen) {
            all.push(Covered { text, rect, seen });
        }
    }
    let mut all = Vec::new();
    for clipped in &harness.output().shapes {
        each(&clipped.shape, clipped.clip_rect, &mut all);
    }
    all
}

/// What is wrong with a picture, one line each.
fn faults(harness: &Harness<'_, App>, is_scrolled: bool) -> Vec<String> {
    let covered = covered(harness);
    let mut faults = Vec::new();
    for (index, one) in covered.iter().enumerate() {
        let is_handle = one.text == "handle";
        if !is_handle && !is_scrolled && !one.seen.expand(0.5).contains_rect(one.rect) {
            faults.push(format!(
                "{:?} {} is cut at {}",
                one.text, one.rect, one.seen
            ));
        }
        for other in &covered[..index] {
            let both = one
                .rect
                .intersect(one.seen)
                .intersect(other.rect.intersect(other.seen));
            if both.width() > 1.0 && both.height() > 1.0 && !(is_handle && other.text == "handle") {
                faults.push(format!(
                    "{:?} {} lies over {:?} {}",
                    one.text, one.rect, other.text, other.rect
                ));
            }
        }
    }
    faults
}

#[test]
fn no_text_of_a_view_lies_over_another() {
    let mut all = Vec::new();
    for view in &VIEWS {
        for count in [1, 3, 6] {
            for size in SIZES {
                let shown: Session = session(&SIX[6 - count..]);
                let shown = picture(shown, Some(view.id), size, Theme::Dark).controls();
                for fault in faults(&shown, SCROLLED.contains(&view.id)) {
                    all.push(format!("{} of {count} in {size:?}: {fault}", view.id));
                }
            }
        }
    }
    assert!(all.is_empty(), "{}", all.join("\n"));
}

/// The windows that the design names, and a larger text.
const WINDOWS: [([u32; 2], f32); 4] = [
    ([1024, 640], 1.0),
    ([1280, 800], 1.0),
    ([1920, 1080], 1.0),
    ([1920, 1080], 1.5),
];

#[test]
fn no_text_of_a_window_lies_over_another() {
    let mut all = Vec::new();
    for ready in &READY_LAYOUTS {
        for count in [1, 3, 6] {
            for (size, zoom) in WINDOWS {
                let mut shown = session(&SIX[6 - count..]);
                let room = size.map(|side| side as f32 / zoom);
                shown.views.show_ready(ready, room);
                let size = room.map(|side| side as u32);
                let shown = picture(shown, None, size, Theme::Dark).controls();
                for fault in faults(&shown, true) {
                    all.push(format!("{} of {count} in {size:?}: {fault}", ready.name));
                }
            }
        }
    }
    assert!(all.is_empty(), "{}", all.join("\n"));
}

#[test]
fn no_text_of_a_figure_lies_over_another() {
    let mut all = Vec::new();
    for view in &VIEWS {
        for count in [1, 3, 6] {
            for purpose in uses() {
                let shown = session(&SIX[6 - count..]);
                let shown = figure(shown, view.id, purpose, Theme::Light).shapes();
                for fault in faults(&shown, false) {
                    all.push(format!("{} of {count} in {purpose:?}: {fault}", view.id));
                }
            }
        }
    }
    assert!(all.is_empty(), "{}", all.join("\n"));
}
