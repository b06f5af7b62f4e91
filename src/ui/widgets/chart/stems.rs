//! The stems of a chart: Dirac deltas on a scale of shares, which is not that of the values.

use egui::{Align2, Pos2, Rect, Ui, vec2};

use super::axis::TOP_ROOM;
use super::series::Series;
use super::{Chart, Shown, Stem, deltas, draw};
use crate::theme::Palette;

/// The shares written at the right, where values have another scale.
const TICKS: [f64; 2] = [0.5, 1.0];

/// The length of a tick of shares, and where its text begins, from the edge, in points.
const TICK: [f32; 2] = [5.0, 7.0];

/// Between stems that would hide one another, in points.
const BESIDE: f32 = 6.0;

/// A stem at the end of the axis stands this far inside, in points.
const EDGE: f32 = 3.0;

/// How near the pointer reads a stem out, in points.
const REACH: f32 = 6.0;

impl Chart {
    /// Whether the axis upwards measures the shares themselves.
    fn has_share_axis(&self) -> bool {
        self.series.iter().all(Series::is_zero) && !self.stems.is_empty()
    }

    /// Where a stem of this share has its foot and its tip.
    fn ends_of(&self, shown: &Shown, at: f64, share: f64) -> [Pos2; 2] {
        let frame = shown.frame();
        let zero = if self.y.is_logarithmic {
            self.y.range[0]
        } else {
            0.0
        };
        let foot = self.position_of(shown, [at, zero]);
        if self.has_share_axis() && !self.y.is_logarithmic {
            return [foot, self.position_of(shown, [at, share])];
        }
        // The whole flux reaches as high as the highest value does.
        let [low, high] = self.y.ends();
        let of_height = (high - self.y.place(zero)) / (high - low);
        let unit = frame.height() * of_height as f32 / (1.0 + TOP_ROOM as f32);
        let foot = Pos2::new(
            foot.x,
            foot.y.clamp(frame.top() + 0.25 * unit, frame.bottom()),
        );
        [foot, foot - vec2(0.0, share as f32 * unit)]
    }

    pub(super) fn draw_stems(
        &self,
        ui: &Ui,
        shown: &Shown,
        taken: &mut Vec<Rect>,
        palette: &Palette,
    ) {
        let Some(first) = self.stems.first() else {
            return;
        };
        let frame = shown.frame();
        let painter = ui.painter_at(frame);
        if !self.has_share_axis() && !first.name.is_empty() {
            let (font, color) = (draw::small_font(ui), palette.faint_ink);
            for tick in TICKS {
                let [_, tip] = self.ends_of(shown, first.at, tick);
                let text = format!("share {tick}");
                let galley = painter.layout_no_wrap(text.clone(), font.clone(), color);
                // At the right, but where a stem stands there; nothing of it is to be hidden.
                let at = |anchor: Align2, edge: f32, inwards: f32| {
                    let place = Pos2::new(edge + inwards * TICK[1], tip.y);
                    (anchor.anchor_size(place, galley.size()), edge, inwards)
                };
                let sides = [
                    at(Align2::RIGHT_CENTER, frame.right(), -1.0),
                    at(Align2::LEFT_CENTER, frame.left(), 1.0),
                ];
                let is_clear = |(rect, ..): &(Rect, f32, f32)| {
                    let room = rect.expand(BESIDE).x_range();
                    let mut feet = self
                        .stems
                        .iter()
                        .map(|stem| self.ends_of(shown, stem.at, tick)[0].x);
                    feet.all(|x| !room.contains(x))
                };
                let Some((rect, edge, inwards)) = sides.into_iter().find(is_clear) else {
                    continue;
                };
                let ends = [edge, edge + inwards * TICK[0]].map(|x| Pos2::new(x, tip.y));
                painter.line_segment(ends, (1.0, palette.axis));
                taken.push(rect);
                let (at, anchor) = (rect.center(), Align2::CENTER_CENTER);
                draw::haloed_text(&painter, at, anchor, &text, font.clone(), color, palette);
            }
        }
        // Where each was wanted, and where it stands.
        let mut columns: Vec<[f32; 2]> = Vec::new();
        let mut labels = Vec::new();
        for stem in &self.stems {
            let [foot, tip] = self.ends_of(shown, stem.at, stem.share);
            if !frame.x_range().expand(1.0).contains(foot.x) {
                continue;
            }
            // Labels stand on the side with more room; stems that would hide one another step aside to it.
            let side = if tip.x > frame.center().x { -1.0 } else { 1.0 };
            let wanted = foot.x.clamp(frame.left() + EDGE, frame.right() - EDGE);
            let is_taken = |x: f32| {
                columns
                    .iter()
                    .any(|[_, other]| (other - x).abs() < 0.7 * BESIDE)
            };
            let mut steps = (0..self.stems.len()).map(|step| wanted + side * BESIDE * step as f32);
            let x = steps.find(|x| !is_taken(*x)).unwrap_or(wanted);
            columns.push([wanted, x]);
            let ends = [Pos2::new(x, foot.y), Pos2::new(x, tip.y)];
            deltas::stem(&painter, ends, stem.color, stem.dash);
            labels.push((stem, Pos2::new(wanted, tip.y), side));
        }
        for (stem, tip, side) in labels {
            if stem.name.is_empty() {
                continue;
            }
            // Beside all stems that were wanted in this place.
            let group = columns
                .iter()
                .filter(|[wanted, _]| (wanted - tip.x).abs() < BESIDE);
            let farthest = group
                .map(|[_, x]| side * x)
                .fold(f32::NEG_INFINITY, f32::max);
            let anchor = if side < 0.0 {
                Align2::RIGHT_CENTER
            } else {
                Align2::LEFT_CENTER
            };
            let down = if stem.share < 0.0 { -6.0 } else { 6.0 };
            let place = Pos2::new(side * farthest + 8.0 * side, tip.y + down);
            let look = (stem.color, palette);
            deltas::write(ui, &painter, taken, (place, anchor), &stem.name, look);
        }
    }

    /// The stems that stand so near to `x` that a pointer there means them.
    pub(super) fn stems_near<'a>(
        &'a self,
        shown: &'a Shown,
        x: f64,
    ) -> impl Iterator<Item = &'a Stem> {
        let across = move |x: f64| shown.position([self.x.place(x), 0.0]).x;
        let is_near = move |stem: &&Stem| (across(stem.at) - across(x)).abs() <= REACH;
        self.stems.iter().filter(is_near)
    }
}
