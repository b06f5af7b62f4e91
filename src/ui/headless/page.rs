//! Cutting the page of a figure to what there is to see.

use egui::{Rect, Vec2, vec2};
use egui_kittest::Harness;

use crate::app::{App, Figure};
use bxdf_study::export::figure::Cut;

/// What fills this share of its room, fills it.
const FULL: f32 = 0.94;

/// In a room of a slide of which less of the width than this is filled, the title has its place beside the view.
const NARROW: f32 = 0.72;

/// The width of the title there, as a share of the page's.
const TITLE_SHARE: f32 = 0.3;

/// The most height over width that a page grows to.
const TALLEST: f32 = 1.25;

/// The least width of a page, as a share of the whole one: titles need it.
const NARROWEST: f32 = 0.5;

/// Cuts the page to what there is to see; the title of a page that is not cut stands where that leaves the most room.
pub(super) fn fit(harness: &mut Harness<'_, App>, figure: Option<&Figure>) {
    let Some(page) = figure.and_then(|figure| figure.page) else {
        return;
    };
    let size = page.size.map(|side| side as f32);
    let size = vec2(size[0], size[1]);
    match page.cut {
        Cut::None => {
            let (room, seen) = room_and_seen(harness);
            if harness.state().has_title() && seen.x < NARROW * room.x {
                let width = TITLE_SHARE * size.x;
                harness.state_mut().put_title_beside(width);
                harness.run_ok();
            }
        }
        Cut::Height => {
            let (room, seen) = room_and_seen(harness);
            let more = if seen.x < FULL * room.x {
                // What is as high as the room is larger in a higher one.
                room.y * (room.x / seen.x - 1.0)
            } else {
                (seen.y - room.y).min(0.0)
            };
            resize(harness, vec2(size.x, (size.y + more).min(TALLEST * size.x)));
            // What grew no wider leaves room below.
            let (room, seen) = room_and_seen(harness);
            let height = harness.ctx.content_rect().height() - (room.y - seen.y).max(0.0);
            resize(harness, vec2(size.x, height));
        }
        Cut::Both => {
            for _ in 0..2 {
                let (room, seen) = room_and_seen(harness);
                let left = (room - seen).max(Vec2::ZERO);
                let now = harness.ctx.content_rect().size();
                let width = (now.x - left.x).max(NARROWEST * size.x);
                resize(harness, vec2(width, now.y - left.y));
            }
        }
    }
}

/// The size of the view's room, and of what is seen in it.
fn room_and_seen(harness: &Harness<'_, App>) -> (Vec2, Vec2) {
    let (app, shapes) = (harness.state(), &harness.output().shapes);
    let (room, seen) = (app.room_of_view(), app.seen(shapes));
    let seen = if seen.is_positive() { seen } else { room };
    (room.size(), centred(seen, room).size())
}

/// The rectangle about the middle of `room` that holds `seen`, so that nothing is cut on any side, and no higher than the room.
fn centred(seen: Rect, room: Rect) -> Rect {
    let middle = room.center();
    let half = (seen.max - middle).max(middle - seen.min);
    Rect::from_center_size(middle, 2.0 * half).intersect(room)
}

fn resize(harness: &mut Harness<'_, App>, size: Vec2) {
    let size = size.ceil();
    if size != harness.ctx.content_rect().size() {
        harness.set_size(size);
        harness.run_ok();
    }
}
