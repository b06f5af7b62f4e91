//! Cutting the page of a figure to what there is to see.

use egui::{Vec2, vec2};
use egui_kittest::Harness;

use crate::app::{App, Figure};
use bxdf_study::export::figure::Cut;

/// What fills this share of its room, fills it.
const FULL: f32 = 0.94;

/// What fills this share of the height of its room is as high as that lets it be, but for a margin.
const HIGH: f32 = 0.8;

/// In a room of a slide of which less of the width than this is filled, the title has its place beside the view.
const NARROW: f32 = 0.72;

/// The width of the title there, as a share of the page's.
const TITLE_SHARE: f32 = 0.3;

/// The most height over width that a page grows to, with a few pictures apart and with many.
const TALLEST: [f32; 2] = [1.25, 1.6];

/// More pictures than this are many.
const FEW: usize = 4;

/// Of the height that a view on a slide leaves free so much stays about it: the rest goes above the title and below the view.
const ROOM_ABOUT: f32 = 0.06;

/// The same of a page that is too low for all rows of a table.
const LONGEST: f32 = 3.0;

/// By how much a page is made larger at a time that is too small for all rows of a table, and how large at most.
const LARGER: f32 = 1.05;
/// See [`LARGER`].
const LARGEST: f32 = 3.0;

/// How often a page is cut: what is seen may stand elsewhere on another one.
const PASSES: usize = 4;

/// What is left free up to this share of the room is no margin to be cut.
const SLACK: f32 = 0.05;

/// What is seen on a page that is cut keeps this share of its size at least: titles may take another row.
const KEPT: f32 = 0.9;

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
                harness.state_mut().put_title_beside(TITLE_SHARE * size.x);
                harness.run_ok();
            } else {
                gather(harness);
            }
        }
        Cut::Height => {
            let apart = harness.state().number_apart();
            let tallest = if apart > FEW { TALLEST[1] } else { TALLEST[0] };
            if apart > 1 {
                // Pictures of several materials stand below one another too.
                resize(harness, vec2(size.x, tallest * size.x));
            }
            for _ in 0..PASSES {
                let more = more(harness);
                if more <= 0.0 {
                    break;
                }
                let most = if harness.state().lacking() > 0.0 {
                    LONGEST
                } else {
                    tallest
                };
                let height = harness.ctx.content_rect().height() + more;
                resize(harness, vec2(size.x, height.min(most * size.x)));
            }
            cut(harness, [false, true], size);
        }
        Cut::Both => cut(harness, [true, true], size),
    }
    if page.cut != Cut::Height {
        hold_all(harness);
    }
}

/// Brings title and view of a page that is not cut together, where the view leaves height free: in its middle.
fn gather(harness: &mut Harness<'_, App>) {
    let (room, seen) = room_and_seen(harness);
    let free = room.y - seen.y - ROOM_ABOUT * room.y;
    if free <= SLACK * room.y || harness.state().has_scene() {
        return;
    }
    harness.state_mut().leave_free(0.5 * free);
    harness.run_ok();
    let (_, gathered) = room_and_seen(harness);
    if gathered.x < KEPT * seen.x || gathered.y < KEPT * seen.y || harness.state().lacking() > 0.0 {
        harness.state_mut().leave_free(0.0);
        harness.run_ok();
    }
}

/// How much higher a page of this width is to be, so that all is seen, as large as the width allows.
fn more(harness: &Harness<'_, App>) -> f32 {
    let (app, (room, seen)) = (harness.state(), room_and_seen(harness));
    let is_narrow = seen.x < FULL * room.x;
    if app.lacking() > 0.0 {
        app.lacking()
    } else if is_narrow && (app.has_scene() || seen.y > HIGH * room.y) {
        room.y * (room.x / seen.x - 1.0)
    } else {
        0.0
    }
}

/// Cuts the page to what there is to see, across and down where that is asked for; `whole`: its size at first.
fn cut(harness: &mut Harness<'_, App>, [across, down]: [bool; 2], whole: Vec2) {
    // A scene is as large as its room.
    let down = down && !harness.state().has_scene();
    for _ in 0..PASSES {
        let (room, seen) = room_and_seen(harness);
        // What keeps a margin on one side keeps it on the other.
        let margins = (room / seen).max(Vec2::splat(1.0));
        let left = (room - seen * vec2(margins.y, margins.x)).max(Vec2::ZERO);
        let size = harness.ctx.content_rect().size();
        if across && left.x > SLACK * room.x {
            let width = (size.x - left.x).max(NARROWEST * whole.x);
            try_size(harness, vec2(width, size.y));
        }
        if down && left.y > SLACK * room.y {
            let height = harness.ctx.content_rect().height() - left.y;
            try_size(harness, vec2(harness.ctx.content_rect().width(), height));
        }
    }
}

/// Gives the page this size, unless what is seen shrinks with it: its margins are its own then.
fn try_size(harness: &mut Harness<'_, App>, size: Vec2) {
    let (before, (_, large)) = (harness.ctx.content_rect().size(), room_and_seen(harness));
    resize(harness, size);
    let (_, small) = room_and_seen(harness);
    if small.x < KEPT * large.x || small.y < KEPT * large.y {
        resize(harness, before);
    }
}

/// Makes a page larger that is too low for what there is to see, in the same number of pixels: a long table is better small
/// than cut off.
fn hold_all(harness: &mut Harness<'_, App>) {
    let scale = harness.ctx.pixels_per_point();
    let whole = harness.ctx.content_rect().size();
    let mut factor = 1.0;
    while harness.state().lacking() > 0.0 && factor < LARGEST {
        factor *= LARGER;
        harness.set_pixels_per_point(scale / factor);
        harness.set_size(whole * factor);
        harness.run_ok();
    }
}

/// The size of the view's room, and of what is seen in it: across, of what stands about the middle of the room, so that
/// nothing is cut on either side.
fn room_and_seen(harness: &Harness<'_, App>) -> (Vec2, Vec2) {
    let (app, shapes) = (harness.state(), &harness.output().shapes);
    let (room, seen) = (app.room_of_view(), app.seen(&harness.ctx, shapes));
    if !seen.is_positive() {
        return (room.size(), room.size());
    }
    let middle = room.center().x;
    let half = (seen.right() - middle).max(middle - seen.left());
    let width = (2.0 * half).min(room.width());
    (room.size(), vec2(width, seen.height()))
}

fn resize(harness: &mut Harness<'_, App>, size: Vec2) {
    let size = size.ceil();
    if size != harness.ctx.content_rect().size() {
        harness.set_size(size);
        harness.run_ok();
    }
}
