//! The names of curves, each beside its curve.

use egui::{Label, Pos2, Rect, RichText, Sense, Ui, vec2};

use super::series::Series;
use super::{Chart, Shown, choice, draw};
use crate::theme::{self, Palette};

/// Between the places that are tried and between those where curves are looked at, in points.
const STEPS: [f32; 2] = [6.0, 2.0];

/// Between a curve and its name, in points.
const GAP: f32 = 4.0;

/// A name that stands farther from all other curves than this, in points, is as clear as it can be.
const CLEAR: f32 = 26.0;

impl Chart {
    /// The names of the curves with samples of their lines, in rows.
    pub(super) fn name_series(&self, ui: &mut Ui) {
        ui.horizontal_wrapped(|ui| {
            let row = draw::label_scale(ui) * theme::LEGEND_ROW;
            let spacing = ui.spacing_mut();
            (spacing.item_spacing.y, spacing.interact_size.y) = (0.0, row);
            for series in &self.series {
                let font = draw::small_font(ui);
                let painter = ui.painter();
                let galley = painter.layout_no_wrap(series.name.clone(), font, series.color);
                let gap = ui.spacing().item_spacing.x;
                let width = theme::LINE_SAMPLE + galley.size().x + 2.0 * gap;
                choice::keep_together(ui, width);
                ui.horizontal(|ui| {
                    let size = vec2(theme::LINE_SAMPLE, row);
                    let (rect, _) = ui.allocate_exact_size(size, Sense::hover());
                    let ends = [rect.left_center(), rect.right_center()];
                    let stroke = (series.width, series.color);
                    draw::line(ui.painter(), ends, stroke, series.dash);
                    // Narrower than one name, the chart shows its beginning.
                    ui.add(Label::new(RichText::new(&series.name).small()).truncate());
                });
            }
        });
    }

    /// Writes the name of each curve where it covers no curve, no line and no other name, as far as can be from the other
    /// curves. Where there is no such place it is left out: the pointer reads it out.
    pub(super) fn label_series(
        &self,
        ui: &Ui,
        shown: &Shown,
        taken: &mut Vec<Rect>,
        palette: &Palette,
    ) {
        let frame = shown.frame().shrink(2.0);
        let font = draw::body_font(ui);
        let paths: Vec<Vec<Pos2>> = self
            .series
            .iter()
            .map(|series| self.path(shown, series))
            .collect();
        let lines = self
            .marks
            .iter()
            .map(|mark| self.position_of(shown, [mark.at, self.y.range[0]]).x);
        let lines: Vec<f32> = lines.collect();
        for (index, series) in self.series.iter().enumerate() {
            let Some(own) = paths.get(index) else {
                continue;
            };
            let ink = palette.text_in(series.color);
            let galley = ui
                .painter()
                .layout_no_wrap(series.name.clone(), font.clone(), ink);
            let size = galley.size();
            let is_free = |rect: &Rect| {
                let is_apart = |other: &Rect| !other.intersects(rect.expand(2.0));
                let is_crossed = |x: &f32| (rect.left() - 2.0..=rect.right() + 2.0).contains(x);
                let covers = |path: &Vec<Pos2>| near(path, rect, 0.0).any(|at| rect.contains(*at));
                frame.contains_rect(*rect)
                    && taken.iter().all(is_apart)
                    && !lines.iter().any(is_crossed)
                    && !paths.iter().any(covers)
            };
            // How far the nearest other curve is.
            let room = |rect: &Rect| {
                let others = paths
                    .iter()
                    .enumerate()
                    .filter(|(other, _)| *other != index);
                let distances = others.flat_map(|(_, path)| near(path, rect, CLEAR));
                let nearest = distances.map(|at| rect.distance_to_pos(*at));
                nearest.fold(CLEAR, f32::min)
            };
            let places = own.iter().step_by((STEPS[0] / STEPS[1]) as usize);
            let beside = |at: &Pos2| {
                let (x, y) = (0.5 * size.x, 0.5 * size.y + GAP);
                // Above and below, and aside where the curve is steep.
                let offsets = [
                    vec2(0.0, -y),
                    vec2(0.0, y),
                    vec2(-x - GAP, 0.0),
                    vec2(x + GAP, 0.0),
                ];
                offsets.map(|offset| Rect::from_center_size(*at + offset, size))
            };
            let all: Vec<Rect> = places.flat_map(beside).collect();
            let mut best: Option<(Rect, f32)> = None;
            for rect in all.into_iter().rev().filter(is_free) {
                let room = room(&rect);
                if best.is_none_or(|(_, most)| room > most) {
                    best = Some((rect, room));
                }
                // No place is clearer than clear.
                if room >= CLEAR {
                    break;
                }
            }
            if let Some((rect, _)) = best {
                taken.push(rect);
                let painter = ui.painter_at(shown.frame());
                painter.rect_filled(rect, 2.0, palette.background.gamma_multiply(0.8));
                painter.galley(rect.min, galley, ink);
            }
        }
    }

    /// Where a curve lies on the screen, from left to right.
    fn path(&self, shown: &Shown, series: &Series) -> Vec<Pos2> {
        let frame = shown.frame();
        let steps = (frame.width() / STEPS[1]) as usize;
        let at = |step: usize| {
            let across = frame.left() + STEPS[1] * step as f32;
            let [x, _] = self.value_at(shown, Pos2::new(across, frame.center().y));
            let y = series.value_at(x)?;
            Some(self.position_of(shown, [x, y]))
        };
        let evenly = (0..=steps).filter_map(at);
        let corners = series.lines.iter().flatten();
        let corners = corners.map(|point| self.position_of(shown, *point));
        let mut path: Vec<Pos2> = evenly.chain(corners).collect();
        path.sort_by(|a, b| a.x.total_cmp(&b.x));
        path
    }
}

/// The points of a path, from left to right, that are no farther than `reach` beside `rect`.
fn near<'a>(path: &'a [Pos2], rect: &Rect, reach: f32) -> impl Iterator<Item = &'a Pos2> + use<'a> {
    let first = path.partition_point(|at| at.x < rect.left() - reach);
    let right = rect.right() + reach;
    let (_, from) = path.split_at(first);
    from.iter().take_while(move |at| at.x <= right)
}
