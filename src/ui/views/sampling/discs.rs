//! The sampling on discs of directions: samples, the warp of the square, the histogram.

use std::cell::RefCell;
use std::f64::consts::TAU;
use std::sync::Arc;

use egui::{Align2, Pos2, Rect, Shape, Stroke, TextStyle, Ui, Vec2, vec2};
use glam::DVec3;

use super::super::context::ViewContext;
use super::super::direction;
use super::studies::color_of;
use crate::scene3d::Projection as _;
use crate::theme::Palette;
use crate::widgets::labels::{Labels, Place, Reach};
use crate::widgets::pictures::{self, Cell, ColorScale, ScaleKind};
use crate::widgets::{choice, draw};
use bxdf::math::frame;
use bxdf_lab::analysis::hemisphere::Projection;
use bxdf_lab::analysis::raster::Raster;
use bxdf_lab::analysis::sampling::{Cell as Bin, Histogram, Warp};
use bxdf_study::format;
use bxdf_study::session::OrbitCamera;
use bxdf_study::session::{EntryId, MaterialEntry};
use bxdf_study::views::sampling::{Options, Plot, WARP};

/// How directions are projected onto the discs.
const DISC: Projection = Projection::EqualArea;

/// Room for labels around a disc, in points.
const LABELS: f32 = 14.0;

/// The room of light and viewer, and the radius of the ring of a delta, in points.
const HANDLE: Vec2 = Vec2::splat(12.0);
/// See [`HANDLE`].
const RING: f32 = 7.0;

/// The most samples drawn as dots, and the most for each square point of the picture: more are a blot.
const MOST_DOTS: usize = 4096;
const DOTS_PER_AREA: f32 = 0.12;

/// Pixels along either side of a histogram.
const HISTOGRAM_SIZE: usize = 192;

/// The ends of the colours of a histogram, in standard deviations of the expected number.
const DEVIATIONS: f64 = 4.0;

/// Narrower discs have no room for the names of light and viewer, in points.
const ROOM_FOR_NAMES: f32 = 150.0;

/// Narrower discs have room for the chance only, in points.
const ROOM_FOR_TEST: f32 = 180.0;

/// Below this chance the samples do not follow the density: one in ten thousand by bad luck.
const SUSPICIOUS: f64 = 1e-4;

/// Draws into the disc of one material.
type DrawDisc = fn(&Ui, &mut ViewContext<'_, Options>, &Disc, EntryId);

/// A disc for each material, n in its middle, what goes below the surface seen through it.
pub(super) fn show(ui: &mut Ui, cx: &mut ViewContext<'_, Options>, draw_disc: DrawDisc) {
    let room = ui.available_rect_before_wrap();
    let mut discs = room;
    if cx.options.plot == Plot::Histogram {
        discs = pictures::color_bar(ui, room, deviations(), "standard deviations", cx.palette);
    }
    let ids: Vec<EntryId> = cx
        .session
        .materials
        .shown()
        .map(MaterialEntry::id)
        .collect();
    for (cell, entry) in pictures::cells(ui, discs, ids.len(), 1.0)
        .into_iter()
        .zip(ids)
    {
        let disc = Cell {
            picture: cell.picture.shrink(draw::label_scale(ui) * LABELS),
            ..cell
        };
        pictures::title(ui, cell, entry, cx.session, cx.palette);
        let disc = Disc::of(ui, disc.picture, cx);
        draw_disc(ui, cx, &disc, entry);
        disc.frame(ui, cx);
    }
    ui.advance_cursor_after_rect(room);
}

/// Where directions lie in a picture: on a disc, n in its middle, or on the dome as the 3D view shows it.
pub(super) struct Disc {
    rect: Rect,
    /// The camera that looks at the dome.
    camera: Option<OrbitCamera>,
    /// Where names stand, clear of light and viewer.
    labels: RefCell<Labels>,
}

impl Disc {
    fn of(ui: &Ui, rect: Rect, cx: &ViewContext<'_, Options>) -> Self {
        let (session, options) = (&*cx.session, &*cx.options);
        let is_dome = options.is_dome && options.plot.shows_directions();
        let bounds = rect.expand(draw::label_scale(ui) * LABELS);
        let disc = Self {
            rect,
            camera: is_dome.then(|| session.camera.clone()),
            labels: RefCell::new(Labels::within(bounds.intersect(ui.clip_rect()))),
        };
        for one in cx.directions() {
            let handle = Rect::from_center_size(disc.position(one.direction), HANDLE);
            disc.labels.borrow_mut().keep_off(handle);
        }
        disc
    }

    /// Where a direction lies, whichever side it is on.
    fn position(&self, w: DVec3) -> Pos2 {
        let on_disc = || {
            let [x, y] = DISC.place(w);
            pictures::position_of(self.rect, [0.5 + 0.5 * x, 0.5 - 0.5 * y])
        };
        let camera = self.camera.as_ref();
        let on_dome = camera.and_then(|camera| camera.project(w.as_vec3(), self.rect));
        on_dome.unwrap_or_else(on_disc)
    }

    /// The rim, the axes, the light and the viewer; of the dome two meridians too.
    fn frame(&self, ui: &Ui, cx: &ViewContext<'_, Options>) {
        let (painter, palette) = (ui.painter(), cx.palette);
        let circle = |u: DVec3, v: DVec3, turn: f64| {
            let angle = |step: u32| turn * f64::from(step) / 64.0;
            let point = |step| self.position(u * angle(step).cos() + v * angle(step).sin());
            let points = (0..=64).map(point).collect();
            painter.add(Shape::line(points, Stroke::new(1.0, palette.axis)));
        };
        circle(DVec3::X, DVec3::Y, TAU);
        if self.camera.is_some() {
            circle(DVec3::X, DVec3::Z, 0.5 * TAU);
            circle(DVec3::Y, DVec3::Z, 0.5 * TAU);
        }
        let font = draw::small_font(ui);
        for (w, name) in [(DVec3::X, "s"), (DVec3::Y, "t")] {
            let at = self.position(w);
            let outwards = (at - self.rect.center()).normalized();
            let place = at + 8.0 * outwards;
            painter.text(
                place,
                Align2::CENTER_CENTER,
                name,
                font.clone(),
                palette.ink,
            );
        }
        for one in cx.directions() {
            let at = self.position(one.direction);
            if one.direction.z > 0.0 {
                painter.circle(at, 4.0, one.color, (1.5, palette.background));
            } else {
                painter.circle_stroke(at, 4.0, (1.0, one.color));
            }
        }
        if self.rect.width() < ROOM_FOR_NAMES {
            return;
        }
        for one in cx.directions() {
            let (at, centre) = (self.position(one.direction), self.rect.center());
            let labels = &mut self.labels.borrow_mut();
            direction::name(ui, painter, cx, labels, (&one, at, centre));
        }
    }
}

/// The samples as dots; those below the surface as rings; deltas as one ring with their number.
pub(super) fn draw_points(ui: &Ui, cx: &mut ViewContext<'_, Options>, disc: &Disc, entry: EntryId) {
    let (session, answers) = (&*cx.session, &mut *cx.answers);
    let Some(found) = session.materials.get(entry) else {
        return;
    };
    let study = answers.ask(session, found, cx.options.request(session));
    let color = color_of(cx, entry);
    let painter = ui.painter();
    let radius = (disc.rect.width() / 260.0).clamp(0.7, 1.8);
    let continuous = study.points.iter().filter(|point| !point.is_delta);
    let most = (DOTS_PER_AREA * disc.rect.area()) as usize;
    for point in continuous.take(most.min(MOST_DOTS)) {
        let at = disc.position(point.direction);
        if point.direction.z > 0.0 {
            painter.circle_filled(at, radius, color);
        } else {
            painter.circle_stroke(at, radius, (0.7, color));
        }
    }
    let deltas: Vec<_> = study.points.iter().filter(|point| point.is_delta).collect();
    for is_upper in [true, false] {
        let one_side = deltas
            .iter()
            .filter(|point| (point.direction.z > 0.0) == is_upper);
        let number = one_side.clone().count();
        if let Some(first) = one_side.clone().next() {
            let at = disc.position(first.direction);
            painter.circle_stroke(at, RING, (2.0, color));
            let ring = Rect::from_center_size(at, Vec2::splat(2.0 * RING));
            disc.labels.borrow_mut().keep_off(ring);
            let text = format!("{number} samples (delta)");
            let (font, ink) = (draw::small_font(ui), cx.palette.ink);
            let galley = painter.layout_no_wrap(text.clone(), font.clone(), ink);
            let towards = if is_upper { Vec2::UP } else { Vec2::DOWN };
            let (from, size) = (at + RING * towards, galley.size() + vec2(6.0, 2.0));
            let place = disc
                .labels
                .borrow_mut()
                .place(from, size, towards, Reach::Near);
            // Where there is no room, the ring stands alone.
            if let Some(Place { rect, .. }) = place {
                let (at, anchor) = (rect.center(), Align2::CENTER_CENTER);
                draw::haloed_text(painter, at, anchor, &text, font, ink, cx.palette);
            }
        }
    }
    if study.lost > 0 {
        let share = study.lost as f64 / (study.lost + study.points.len()) as f64;
        let share = format!("{} %", format::value(100.0 * share));
        let whole = format!("{share} of the samples have weight 0");
        let fits =
            |text: &String| choice::width_of(ui, text, &TextStyle::Small) < disc.rect.width();
        let texts = [whole, format!("weight 0: {share}")];
        if let Some(text) = texts.iter().find(|text| fits(text)) {
            note(ui, disc.rect, text, cx.palette);
        }
    }
}

/// The images of the grid of random numbers, lobe by lobe.
pub(super) fn draw_warp(ui: &Ui, cx: &mut ViewContext<'_, Options>, disc: &Disc, entry: EntryId) {
    let (session, answers) = (&*cx.session, &mut *cx.answers);
    let Some(found) = session.materials.get(entry) else {
        return;
    };
    let warps = answers.ask(session, found, WARP);
    let is_only = warps.len() == 1;
    for Warp { lobe, lines } in warps.iter() {
        let color = if is_only {
            color_of(cx, entry)
        } else {
            cx.palette.category(lobe.category)
        };
        for line in lines {
            let points = line.iter().map(|w| disc.position(*w)).collect();
            ui.painter()
                .add(Shape::line(points, Stroke::new(0.8, color)));
        }
    }
    if warps.is_empty() {
        note(ui, disc.rect, "Deltas alone: nothing is warped", cx.palette);
    }
}

/// A small note at the lower left of a disc.
fn note(ui: &Ui, rect: Rect, text: &str, palette: &Palette) {
    let place = rect.left_bottom() + vec2(0.0, draw::label_scale(ui) * LABELS);
    let font = draw::small_font(ui);
    draw::haloed_text(
        ui.painter(),
        place,
        Align2::LEFT_BOTTOM,
        text,
        font,
        palette.ink,
        palette,
    );
}

/// The colours of a histogram.
fn deviations() -> ColorScale {
    ColorScale {
        range: [-DEVIATIONS, DEVIATIONS],
        kind: ScaleKind::Diverging,
    }
}

/// By how much each cell's samples differ from what the density says, and the chance of that.
pub(super) fn draw_histogram(
    ui: &Ui,
    cx: &mut ViewContext<'_, Options>,
    disc: &Disc,
    entry: EntryId,
) {
    let rect = disc.rect;
    let (session, answers) = (&*cx.session, &mut *cx.answers);
    let Some(found) = session.materials.get(entry) else {
        return;
    };
    let study = answers.ask(session, found, cx.options.request(session));
    let id = ui.scope_id().with(("histogram", entry));
    let sources = vec![Arc::clone(&study) as _];
    let scale = deviations();
    let paint = || scale.paint(&deviation_map(&study.histogram));
    let texture = cx.state.textures.get(ui, id, (sources, Some(scale)), paint);
    texture.paint(ui.painter(), rect);
    let Histogram {
        chi_square,
        degrees,
        p_value,
        ..
    } = study.histogram;
    let test = if rect.width() > ROOM_FOR_TEST {
        format!(
            "χ² {} of {degrees} degrees, p {}",
            format::value(chi_square),
            format::value(p_value)
        )
    } else {
        format!("p {}", format::value(p_value))
    };
    let verdict = match degrees {
        0 => "nothing to test".to_owned(),
        _ if p_value < SUSPICIOUS => format!("{test}: not this density"),
        _ => test,
    };
    note(ui, rect, &verdict, cx.palette);
}

/// For each pixel of a disc the deviation of its cell, of the upper half, or of the lower one where only that has any.
fn deviation_map(histogram: &Histogram) -> Raster<f64> {
    let is_above = |cell: &&Bin| cell.theta[0] < std::f64::consts::FRAC_PI_2 - 1e-9;
    let expected_above: f64 = histogram
        .cells
        .iter()
        .filter(is_above)
        .map(|cell| cell.expected)
        .sum();
    let is_upper = expected_above > 0.0;
    let size = HISTOGRAM_SIZE;
    let place = |index: usize| 2.0 * (index as f64 + 0.5) / size as f64 - 1.0;
    let value = |index: usize| {
        let place = [place(index % size), -place(index / size)];
        let w = DISC.direction(place, is_upper)?;
        let cell = histogram.cells.iter().find(|cell| holds(cell, w))?;
        (cell.expected > 0.0).then(|| (cell.observed as f64 - cell.expected) / cell.expected.sqrt())
    };
    Raster {
        width: size,
        height: size,
        pixels: (0..size * size)
            .map(|index| value(index).unwrap_or(f64::NAN))
            .collect(),
    }
}

/// Whether the direction `w` lies in a cell.
fn holds(cell: &Bin, w: DVec3) -> bool {
    let (theta, phi) = (frame::theta(w), frame::phi(w));
    let turn = std::f64::consts::TAU;
    let is_between = |[low, high]: [f64; 2], x: f64| (low..high).contains(&x);
    is_between(cell.theta, theta) && (is_between(cell.phi, phi) || is_between(cell.phi, phi + turn))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_direction_lies_in_the_cell_that_holds_it() {
        let bin = |theta: [f64; 2], phi: [f64; 2], observed, expected| Bin {
            theta,
            phi,
            solid_angle: 1.0,
            observed,
            expected,
        };
        let histogram = Histogram {
            cells: vec![
                bin([0.0, 0.8], [-3.2, 3.2], 109, 100.0),
                bin([0.8, 1.6], [0.0, 6.4], 16, 25.0),
            ],
            ..Histogram::default()
        };
        let map = deviation_map(&histogram);
        let at = |x, y| *map.at(x, y).unwrap();
        let middle = HISTOGRAM_SIZE / 2;
        assert!((at(middle, middle) - 0.9).abs() < 1e-12);
        assert!((at(4, middle) + 1.8).abs() < 1e-12);
        assert!(at(0, 0).is_nan());
    }
}
