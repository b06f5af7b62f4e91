//! The bar that fills towards the exact value, the numbers beside it, and how the error falls with the count.

use egui::{
    Align2, Color32, Painter, Pos2, Rect, RichText, Stroke, StrokeKind, Ui, UiBuilder, pos2, vec2,
};

use super::figure::luminance;
use super::words;
use crate::theme::{self, Palette};
use crate::widgets::draw;
use crate::widgets::pictures::ColorScale;
use bxdf_lab::analysis::Channel;
use bxdf_lab::analysis::integral::{Exact, Sum};
use bxdf_study::format;

/// The width of the bar and of the names at its left, in points.
const BAR: f32 = 28.0;
const NAMES: f32 = 58.0;

/// The least height of the plot of errors, in points.
const PLOT: f32 = 96.0;

/// Room above the exact value in the bar, as a share of it.
const HEADROOM: f64 = 0.12;

/// What is known of a sum at a moment.
pub(super) struct Standing<'a> {
    pub(super) sum: &'a Sum,
    pub(super) exact: &'a Exact,
    pub(super) scale: ColorScale,
    /// How many parts lie on the disc.
    pub(super) counted: usize,
    /// The sentences about it: the count, the exact value, the error.
    pub(super) lines: [String; 3],
    /// The colour of the material.
    pub(super) color: Color32,
    pub(super) palette: &'a Palette,
}

impl Standing<'_> {
    /// The sum so far, as luminance.
    pub(super) fn so_far(&self) -> f64 {
        self.sum.luminance_of_first(self.counted)
    }

    /// The numbers in short lines: the sum, the exact value, the error.
    pub(super) fn short_lines(&self, so_far: &str) -> Vec<String> {
        let Some(exact) = self.exact() else {
            return vec![format!("Sum {so_far}"), "Exact …".to_owned()];
        };
        let exact = words::number(exact);
        let [.., error] = &self.lines;
        // What is relative to the exact value is the shorter.
        let relative = error
            .split_once('(')
            .and_then(|(_, rest)| rest.strip_suffix(')'));
        let error = relative.map_or_else(|| error.clone(), |share| format!("Error {share}"));
        vec![format!("Sum {so_far}"), format!("Exact {exact}"), error]
    }

    fn exact(&self) -> Option<f64> {
        self.exact.value.map(|rgb| Channel::Luminance.of(rgb))
    }

    /// The value at the upper end of the bar.
    fn top(&self) -> f64 {
        let all = Channel::Luminance.of(self.sum.total());
        let largest = self.exact().unwrap_or(0.0).max(all);
        if largest > 0.0 {
            largest * (1.0 + HEADROOM)
        } else {
            1.0
        }
    }

    /// The bar, with a slice for each part in its colour, and the mark of the exact value.
    pub(super) fn bar(&self, painter: &Painter, rect: Rect) {
        let top = self.top();
        let y = |value: f64| rect.bottom() - (value / top).clamp(0.0, 1.0) as f32 * rect.height();
        painter.rect_filled(rect, 0.0, self.palette.ground_color());
        let parts = self.sum.parts.iter();
        let values = parts.map(|part| self.scale.color(luminance(part)));
        let colors = values.chain(self.sum.deltas.iter().map(|_| self.color));
        let mut sum = 0.0;
        let mut low = rect.bottom();
        let shares = self.sum.shares().map(|rgb| Channel::Luminance.of(rgb));
        let mut last = self.palette.ground_color();
        for (share, color) in shares.zip(colors).take(self.counted) {
            sum += share;
            last = color;
            let high = y(sum);
            // Thinner slices are not seen.
            if low - high >= 1.0 {
                let slice = Rect::from_x_y_ranges(rect.x_range(), high..=low + 0.5);
                painter.rect_filled(slice, 0.0, color);
                low = high;
            }
        }
        let rest = Rect::from_x_y_ranges(rect.x_range(), y(sum)..=low);
        if rest.height() > 0.0 {
            painter.rect_filled(rest, 0.0, last);
        }
        painter.rect_stroke(rect, 0.0, (1.0, self.palette.axis), StrokeKind::Outside);
        if let Some(exact) = self.exact() {
            let x = rect.left() - 5.0..=rect.right() + 5.0;
            painter.hline(x.clone(), y(exact), (4.0, self.palette.background));
            painter.hline(x, y(exact), (2.0, self.palette.ink));
        }
    }

    /// The names at the left of the bar: of the exact value, and 0.
    fn bar_names(&self, ui: &Ui, painter: &Painter, rect: Rect, symbol: &str) {
        let Some(exact) = self.exact() else {
            return;
        };
        let top = self.top();
        let y = rect.bottom() - (exact / top) as f32 * rect.height();
        let font = draw::small_font(ui);
        let write = |at: Pos2, anchor: Align2, text: &str, color| {
            painter.text(at, anchor, text, font.clone(), color);
        };
        let x = rect.left() - 9.0;
        if exact > 0.0 {
            let ink = self.palette.ink;
            write(pos2(x, y - 1.0), Align2::RIGHT_BOTTOM, symbol, ink);
            write(pos2(x, y), Align2::RIGHT_TOP, &words::number(exact), ink);
        }
        let faint = self.palette.faint_ink;
        if exact == 0.0 || rect.bottom() - y > 3.0 * font.size {
            write(pos2(x, rect.bottom()), Align2::RIGHT_CENTER, "0", faint);
        }
    }

    /// The bar and all that is said, in a column of its own.
    pub(super) fn show(&self, ui: &mut Ui, room: Rect, symbol: &str, notes: &[(String, Color32)]) {
        let bar = Rect::from_min_max(
            pos2(room.left() + NAMES, room.top() + 6.0),
            pos2(room.left() + NAMES + BAR, room.bottom() - 12.0),
        );
        self.bar(ui.painter(), bar);
        self.bar_names(ui, ui.painter(), bar, symbol);
        let texts = room.with_min_x(bar.right() + 18.0).with_max_y(bar.bottom());
        let mut column = ui.new_child(UiBuilder::new().max_rect(texts));
        let [counted, exact, error] = &self.lines;
        column.spacing_mut().item_spacing.y = 4.0;
        column.label(RichText::new(counted).color(self.palette.faint_ink));
        column.label(RichText::new(words::number(self.so_far())).size(theme::LARGE_TEXT));
        column.label(exact);
        column.label(error);
        for (note, color) in notes {
            column.add_space(4.0);
            column.label(RichText::new(note).small().color(*color));
        }
        let rest = Rect::from_min_max(
            pos2(texts.left(), column.min_rect().bottom() + 14.0),
            texts.max,
        );
        if rest.height() >= PLOT {
            let height = rest.height().min(0.7 * rest.width()).max(PLOT);
            self.plot_errors(ui, rest.with_min_y(rest.bottom() - height));
        }
    }

    /// The errors of all numbers of patches, both by powers.
    fn plot_errors(&self, ui: &Ui, room: Rect) {
        let Some(exact) = self.exact().filter(|exact| *exact > 0.0) else {
            return;
        };
        let error = |sum: [f64; 3]| (Channel::Luminance.of(sum) / exact - 1.0).abs();
        let course = self.exact.course.iter();
        let points: Vec<(u8, f64)> = course.map(|(log2, sum)| (*log2, error(*sum))).collect();
        // What is exact at every count has no course: below stands the error of what is called exact.
        let floor = (self.exact.error / exact).max(1e-9);
        let largest = points.iter().map(|(_, error)| *error).fold(0.0, f64::max);
        let ends = points.first().zip(points.last());
        let Some(((first, _), (last, _))) = ends.filter(|_| largest > floor) else {
            return;
        };
        let smallest = points
            .iter()
            .map(|(_, error)| error.max(floor))
            .fold(largest, f64::min);
        let (low, high) = (smallest.log10().floor(), largest.log10().ceil());
        let font = draw::small_font(ui);
        let painter = ui.painter_at(room.expand(4.0));
        let line = font.size + 4.0;
        let frame = Rect::from_min_max(
            room.min + vec2(52.0, line + 4.0),
            room.max - vec2(6.0, line),
        );
        let faint = self.palette.faint_ink;
        let write = |at: Pos2, anchor: Align2, text: String| {
            painter.text(at, anchor, text, font.clone(), faint);
        };
        write(
            room.left_top(),
            Align2::LEFT_TOP,
            "Error by count".to_owned(),
        );
        let place = |log2: u8, error: f64| {
            let x = f64::from(log2 - first) / f64::from((last - first).max(1));
            let y = (error.max(floor).log10() - low) / (high - low).max(1.0);
            pos2(
                frame.left() + x as f32 * frame.width(),
                frame.bottom() - y as f32 * frame.height(),
            )
        };
        let axis = Stroke::new(1.0, self.palette.axis);
        painter.vline(frame.left(), frame.y_range(), axis);
        painter.hline(frame.x_range(), frame.bottom(), axis);
        for (exponent, anchor) in [(low, Align2::RIGHT_BOTTOM), (high, Align2::RIGHT_TOP)] {
            let error = 10_f64.powf(exponent);
            let at = pos2(frame.left() - 5.0, place(*first, error).y);
            write(at, anchor, format!("{} %", format::value(100.0 * error)));
        }
        for (log2, anchor) in [(*first, Align2::LEFT_TOP), (*last, Align2::RIGHT_TOP)] {
            let at = pos2(place(log2, 1.0).x, frame.bottom() + 3.0);
            write(at, anchor, f64::from(log2).exp2().to_string());
        }
        let places: Vec<Pos2> = points
            .iter()
            .map(|(log2, error)| place(*log2, *error))
            .collect();
        painter.line(places.clone(), (theme::CURVE_WIDTH, self.color));
        let chosen = self.sum.grid.count().checked_ilog2();
        for ((log2, _), at) in points.iter().zip(places) {
            if chosen == Some(u32::from(*log2)) {
                painter.circle(at, 4.5, self.palette.ink, (1.5, self.palette.background));
            } else {
                painter.circle_filled(at, 2.5, self.color);
            }
        }
    }
}
